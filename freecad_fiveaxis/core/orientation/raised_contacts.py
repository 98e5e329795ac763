# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a tool stands whose end itself would enter the part at a contact: raised along the normal, for no
axis helps there. How far it is really lifted, the check of the program decides."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.gouge.search import find_entries, which_enter
from freecad_fiveaxis.core.gouge.swept_motion import still_positions
from freecad_fiveaxis.core.tool.body import Body, body_of, round_piece

RAISED = 0.25
"""Of the corner radius: so far the tool is raised, at most, where the ball itself enters."""

RAISED_LEVEL = 0.12
"""Of the radius of a level bottom: so far it is raised in a hollow, at most."""

RAISES = 3
"""Times that it is raised: above one facet it may enter another."""


def raise_contacts(reacher: Reacher, tree: FacetTree, point: Floats, normal: Floats) -> tuple[Floats, Bools]:
    """Raise contacts (n, 3) mm along their unit ``normal`` (n, 3) until a ball end, or a level bottom across
    the normal, is out of the part, and say which (n,) fit: a ball within RAISED of its radius. Of a bottom
    that stays in the part, and of other cutters, nothing is known before their axis is."""
    cutter, stand = reacher.cutter, np.array(point, float)
    fits = np.ones(len(point), np.bool_)
    if cutter.has_level_bottom:
        return raise_bottoms(reacher, tree, stand, normal), fits
    if cutter.ring > 0.0:
        return stand, fits
    ball, rows, up = (
        Body((round_piece(0.0, cutter.corner, cutter.corner),)),
        np.arange(len(point)),
        np.zeros(len(point)),
    )
    for _ in range(RAISES + 1):
        depth = find_entries(ball, tree, still_positions(stand[rows], normal[rows]), reacher.limit).bound
        deep = depth > reacher.limit
        rows, depth = rows[deep], depth[deep]
        up[rows] += depth
        rows = rows[up[rows] <= RAISED * cutter.corner]
        stand[rows] = point[rows] + up[rows, None] * normal[rows]
    fits[rows] = False
    return stand, fits & (up <= RAISED * cutter.corner)


def raise_bottoms(reacher: Reacher, tree: FacetTree, point: Floats, normal: Floats) -> Floats:
    """Raise contacts (n, 3) mm of a level bottom along their unit ``normal`` (n, 3), which is its axis, until
    its rim is out of a hollow: by RAISED_LEVEL of its radius at most; beyond that they stay."""
    cutter, up = body_of(reacher.cutter), np.zeros(len(point))
    most = RAISED_LEVEL * reacher.cutter.radius
    rows = np.arange(len(point))
    for height, enters in ((0.0, True), (most, False)):  # how deep is only worth knowing of what comes free
        at = point[rows] + height * normal[rows]
        hit = which_enter(
            cutter, tree, still_positions(at, normal[rows]), reacher.limit, np.arange(len(rows))
        )
        rows = rows[hit == enters]
    for _ in range(RAISES):
        at = point[rows] + up[rows, None] * normal[rows]
        depth = find_entries(cutter, tree, still_positions(at, normal[rows]), reacher.limit).bound
        deep = depth > reacher.limit
        rows, depth = rows[deep], depth[deep]
        up[rows] = np.minimum(up[rows] + depth, most)
    return np.asarray(point + up[:, None] * normal)
