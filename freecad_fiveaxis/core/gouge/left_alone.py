# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways over facets that are not to be machined: a cutter that stays on the surface there would touch them.

border    of the chosen facets; a place on it is as near to them as to the others, and no way over the others.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.geometry.nearest import Facets, nearest, search

PLACES = 32
"""Places looked at on each way, between its ends."""
BESIDE = 0.02
"""mm by which another facet must be nearer than the chosen ones: facets leave the surface by about so
much."""


def lead_over_others(begin: Floats, end: Floats, mesh: Mesh, chosen: Bools) -> Bools:
    """Find the straight ways (w,) between contacts ``begin`` and ``end`` (w, 3) mm that lead over facets of
    the mesh which are not ``chosen`` (f,)."""
    if not len(begin) or chosen.all() or not chosen.any():
        return np.zeros(len(begin), np.bool_)
    share = (np.arange(PLACES) + 0.5)[:, None, None] / PLACES
    place = (begin + share * (end - begin)).reshape(-1, 3)
    others = _distance(place, mesh, ~chosen) + BESIDE < _distance(place, mesh, chosen)
    return np.asarray(others.reshape(PLACES, -1).any(axis=0))


def _distance(point: Floats, mesh: Mesh, some: Bools) -> Floats:
    """Return the distances (n,) mm of points from some facets of the mesh."""
    corner = np.ascontiguousarray(mesh.vertex[mesh.face[some]].transpose(1, 0, 2))
    facets = Facets(corner, mesh.normal[some])
    return search(point, facets.pieces(), facets.square_distances, nearest, 2)[:, 0]
