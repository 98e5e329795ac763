# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which places of a path lie at the part: where the tool cuts, and where it was lifted off what it should
have cut.

stand    how far from the part the driven point stands in a cut at most: a flat or a ring that leans touches
         beside it.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.geometry.nearest import Facets, nearest, search
from freecad_fiveaxis.core.tool import Cutter

NEAR = 0.5
"""mm: a tool that is lifted farther than this off the part cuts nothing worth a colour."""


def stand_of(cutter: Cutter, normal: Floats, axis: Floats) -> float:
    """How far from the part the tip stands at most, mm, of a cutter that touches with unit ``normal`` (k, 3)
    and stands along ``axis`` (k, 3)."""
    upright = np.clip((normal * axis).sum(axis=1), 0.0, 1.0)
    stand = cutter.ring * np.sqrt(1.0 - upright**2) + cutter.corner * (1.0 - upright)
    if (barrel := cutter.barrel) is not None:
        stand = stand + (barrel.hub_shift(normal, axis) * normal).sum(axis=1)
    return float(stand.max(initial=0.0))


def near_part(mesh: Mesh, place: Floats, stand: float) -> Bools:
    """Whether the places (n, 3) mm lie within NEAR and ``stand`` mm of the part."""
    facets = Facets(np.ascontiguousarray(mesh.vertex[mesh.face.T]), mesh.normal)
    pieces, most = facets.pieces(), NEAR + stand
    near = pieces.clear_by(place) <= most
    rows = np.flatnonzero(near)
    found = search(place[rows], pieces, facets.square_distances, nearest, 2)
    near[rows] = found[:, 0] <= most
    return np.asarray(near)
