# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which places of a path lie at the part: where the tool cuts, and where it was lifted off what it should have cut.

stand    how far from the part the driven point stands in a cut at most: a flat or a ring that leans touches beside it.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.geometry.nearest import Facets, nearest, search

NEAR = 0.5
"""mm: a tool that is lifted farther than this off the part cuts nothing worth a colour."""


def stand_of(ring: float, corner: float, normal: Floats, axis: Floats) -> float:
    """How far from the part the tip stands at most, mm, of a tool with ``ring`` and ``corner`` radius (mm) that touches with unit
    ``normal`` (k, 3) and stands along ``axis`` (k, 3)."""
    upright = np.clip((normal * axis).sum(axis=1), 0.0, 1.0)
    stand = ring * np.sqrt(1.0 - upright**2) + corner * (1.0 - upright)
    return float(stand.max(initial=0.0))


def near_part(mesh: Mesh, place: Floats, stand: float) -> Bools:
    """Whether the places (n, 3) mm lie within NEAR and ``stand`` mm of the part."""
    facets = Facets(np.ascontiguousarray(mesh.vertex[mesh.face.T]), mesh.normal)
    pieces, most = facets.pieces(), NEAR + stand
    near = pieces.clear_by(place) <= most
    rows = np.flatnonzero(near)
    found = search(place[rows], pieces, facets.squared, nearest, 2)
    near[rows] = found[:, 0] <= most
    return np.asarray(near)
