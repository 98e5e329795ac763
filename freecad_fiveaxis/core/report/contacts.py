# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a ball touches the part, for the picture.

The tip of a ball that leans stands beside its contact, the radius times the sine of the lean away: passes
drawn through tips leave bare what is cut and cover what is not. A picture of what is cut is drawn through
contacts.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Floats, Ints, freeze
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.deepest import nearest_on_facet

LEAN = math.cos(math.radians(1.0))
"""Axes that lean less from all normals are taken to stand on them: tip and contact are one."""
NEAR = 4
"""Contacts of the passes, the nearest ones, whose facets are tried."""
MOST = 1_000_000
"""More contacts are not kept: between them the facets change little."""
FAR = 2.0
"""Radii: farther from the part the ball touches nothing, and the tip is shown."""


@dataclass(frozen=True, eq=False)
class Contacts:
    """The ball's centres (k, 3) mm along the passes, and the facets ``face`` (k,) of ``mesh`` that it touches
    there; its ``radius`` mm, and how far ``above`` the driven point its centre stands along the axis, mm."""

    centre: Floats
    face: Ints
    mesh: Mesh
    radius: float
    above: float

    def __post_init__(self) -> None:
        freeze(self, len(self.face), centre="f3", face="i")

    @cached_property
    def _tree(self) -> scipy.spatial.cKDTree:
        return scipy.spatial.cKDTree(self.centre)

    def find_touched(self, driven: Floats, axis: Floats) -> Floats:
        """Find the points (n, 3) mm of the ball that are nearest to the part, where it stands with ``driven``
        (n, 3) mm and unit ``axis`` (n, 3)."""
        centre = driven + self.above * axis
        _, near = self._tree.query(centre, k=np.arange(1, min(NEAR, len(self.centre)) + 1), workers=2)
        least, way = np.full(len(centre), np.inf), np.zeros_like(centre)
        for row in near.T:
            towards = nearest_on_facet(self._corners(row), centre.T).T - centre
            away = np.linalg.norm(towards, axis=1)
            better = away < least
            least[better], way[better] = away[better], towards[better]
        off = (least > FAR * self.radius) | (least == 0.0)
        length = np.where(off, 1.0, least)
        return np.where(off[:, None], driven, centre + (self.radius / length)[:, None] * way)

    def _corners(self, row: Ints) -> Floats:
        return np.ascontiguousarray(self.mesh.vertex[self.mesh.face[self.face[row]]].transpose(1, 2, 0))


def contacts_of(
    centre: Floats, normal: Floats, axis: Floats, face: Ints, mesh: Mesh, radius: float, above: float
) -> Contacts | None:
    """Keep the contacts of passes at which a ball's ``centre`` (k, 3) mm stood over facets ``face`` (k,) of
    ``mesh``, with unit normals (k, 3) and ``axis`` (k, 3), at most MOST of them; None where the tool stands
    on all normals: tips show the same."""
    if not len(centre) or float((normal * axis).sum(axis=1).min()) >= LEAN:
        return None
    some = slice(None, None, -(-len(centre) // MOST))
    return Contacts(centre[some], face[some], mesh, radius, above)
