# SPDX-License-Identifier: LGPL-2.1-or-later
"""Frames: the few tool axes with which a part is cut while the rotary axes are locked, and which place is cut
in which."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.mesh import Mesh

NEAREST = 3
"""Places about a point of which one must be in a frame for the point to be."""


@dataclass(frozen=True, eq=False)
class Frames:
    """``axis`` (k, 3) unit, in the order in which they are cut; of n places on the surface ``point`` (n, 3)
    mm, unit ``normal`` (n, 3) and the ``frame`` (n,) they are cut in, -1: none sees them; ``spacing`` mm
    between places."""

    axis: Floats
    point: Floats
    normal: Floats
    frame: Ints
    spacing: float

    def at(self, point: Floats, normal: Floats) -> Ints:
        """Return the frame (m,) of points (m, 3) mm with unit normals (m, 3): of the nearest place that has
        one among NEAREST, else -1."""
        tree = scipy.spatial.cKDTree(np.concatenate([self.point, self.spacing * self.normal], axis=1))
        place = np.concatenate([point, self.spacing * normal], axis=1)
        near = tree.query(place, k=np.arange(1, min(NEAREST, len(self.frame)) + 1))[1]
        frame = self.frame[near]
        first = (frame >= 0).argmax(axis=1)
        return np.asarray(np.take_along_axis(frame, first[:, None], axis=1)[:, 0])

    def facets(self, mesh: Mesh) -> list[Bools]:
        """Return the facets (f,) of the part's ``mesh`` that each frame cuts, by their middles."""
        own = self.at(mesh.vertex[mesh.face].mean(axis=1), mesh.normal)
        return [own == number for number in range(len(self.axis))]
