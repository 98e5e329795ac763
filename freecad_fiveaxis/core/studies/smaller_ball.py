# SPDX-License-Identifier: LGPL-2.1-or-later
"""How small a ball would have to be where a reach map says that the cutter is too large.

Only the ball itself is set on the place, so that no axis counts; a smaller ball of the same tool may still
meet shank or holder.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixtures import Fixture, join_obstacles
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher, enters
from freecad_fiveaxis.core.tool.body import Body, round_piece

from .reach_map import TRIED, ReachMap

SMALLER = tuple(0.1 * k for k in range(9, 0, -1))
"""Of the cutter's radius: these are tried, the largest first."""


def smaller_ball(
    mesh: Mesh,
    reacher: Reacher,
    found: ReachMap,
    share: float,
    fixtures: Sequence[Fixture] = (),
    progress: Progress = silent,
) -> float | None:
    """Return the largest radius tried, mm, of a ball that is free on a ``share`` of the area where the cutter
    is too large; 0.0: none, None where the cutter is no ball or nowhere too large. An estimate from about
    TRIED of those places."""
    tight = np.flatnonzero(found.obstacle == Obstacle.CUTTER)
    if not reacher.cutter.touches_as_ball or not len(tight):
        return None
    rows, tree = tight[:: max(1, len(tight) // TRIED)], facet_tree(join_obstacles(mesh, fixtures))
    point, normal, area = found.point[rows], mesh.normal[found.facet[rows]], found.area[rows]
    for part in SMALLER:
        progress("reach", 1.0 - part)
        radius = part * reacher.cutter.radius
        ball = Body((round_piece(0.0, radius, radius),))
        if area[~enters(ball, tree, point, normal, reacher.limit)].sum() >= share * area.sum():
            return radius
    return 0.0
