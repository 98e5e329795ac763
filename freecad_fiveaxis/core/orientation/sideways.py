# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way out across the axis: how a lollipop leaves a place over which the part is.

retreat   unit direction in which the tool goes straight out of the part's box, without turning: along its
          axis where it is free so, as all tools go; else across it and not towards the table, the shortest
          way first, where it is free on all of it.

Only what has an undercut is asked: of other cutters the shank is as wide as what cuts, and what is over one
is in the other's way, too.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Reacher, is_below
from freecad_fiveaxis.core.gouge.search import which_enter
from freecad_fiveaxis.core.gouge.swept_motion import still_positions, straight_motion
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import HOLDER, SHANK
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

from .auto_axis import Free
from .axis_field import with_way_out

SQUARE = 1e-6
"""Cosine of an angle that counts as a right one."""

WAYS = 16
"""Directions across the axis that are tried."""


def find_retreats(
    reacher: Reacher, tree: FacetTree, tip: Floats, axis: Floats, progress: Progress = silent
) -> tuple[Floats, Bools]:
    """Find the retreat (m, 3) from tips (m, 3) mm with unit ``axis`` (m, 3), and whether (m,) there is one;
    elsewhere it is the axis."""
    long, every = with_way_out(reacher, tree), np.arange(len(tip))
    out = which_enter(long.body, tree, still_positions(tip, axis), reacher.limit, every, progress)
    trapped = np.flatnonzero(out | is_below(long.body, tip, axis, reacher.table, reacher.limit))
    retreat, found = np.array(axis), np.ones(len(tip), np.bool_)
    found[trapped] = False
    tried, far = _across(axis[trapped]), long.far + reacher.body.reach
    nearest = np.argsort(_out_of_box(tree, tip[trapped], tried), axis=1, kind="stable")
    for rank in nearest.T:
        left = np.flatnonzero(~found[trapped])
        rows, way = trapped[left], tried[left, rank[left]]
        free = ~_entering(reacher, tree, tip[rows], axis[rows], far * way, progress)
        free &= (way[:, 2] >= -SQUARE) | (reacher.table is None)
        retreat[rows[free]], found[rows[free]] = way[free], True
    return retreat, found


def add_retreats(
    path: OffsetPath, axis: Floats, free: Ints, mesh: Mesh, reacher: Reacher, progress: Progress = silent
) -> Ints:  # fmt: skip
    """Return what is free (n,) of :class:`Free` at the rows of ``path`` with axes (n, 3), with the ends of
    each unbroken stretch of free rows counted as a way out where the tool can leave them across its axis."""
    if not reacher.cutter.undercut or not len(free):
        return free
    rows = _ends(path.polyline, free > Free.NONE)
    rows = rows[free[rows] == Free.STANDING]
    _, out = find_retreats(
        reacher, facet_tree(mesh), reacher.cutter.tip_at(path.centre[rows], axis[rows]), axis[rows], progress
    )
    found = np.array(free)
    found[rows[out]] = Free.WAY_OUT
    return found


def neck_entering(
    path: OffsetPath, axis: Floats, mesh: Mesh, reacher: Reacher, progress: Progress = silent
) -> Bools:
    """Whether (n,) a lollipop's neck, or what is above it, enters the part on the move to each row from the
    one before: it is free at both, but so thin that an edge between them may be missed, and nothing is lifted
    for it."""
    entering, blocks = np.zeros(len(axis), np.bool_), np.flatnonzero(np.diff(path.polyline) == 0)
    if not reacher.cutter.undercut or not len(blocks):
        return entering
    hub, tip = reacher.cutter.corner, reacher.cutter.tip_at(path.centre, axis)
    swept = straight_motion(tip, axis, hub)
    entering[1:] = which_enter(
        reacher.body.only(SHANK, HOLDER), facet_tree(mesh), swept, reacher.limit, blocks, progress
    )
    return entering


def path_retreats(
    path: OffsetPath, axis: Floats, mesh: Mesh, reacher: Reacher, progress: Progress = silent
) -> Floats | None:
    """Return the retreat (n, 3) from the first and last row of each polyline, of the other rows their axis;
    None where all go along their axes (n, 3)."""
    if not reacher.cutter.undercut or not len(axis):
        return None
    rows, retreat = _ends(path.polyline, np.ones(len(axis), np.bool_)), np.array(axis)
    tip = reacher.cutter.tip_at(path.centre[rows], axis[rows])
    retreat[rows], _ = find_retreats(
        replace(reacher, kinematics=None), facet_tree(mesh), tip, axis[rows], progress
    )
    return retreat


def rows_left_aside(path: CLPath, cutter: Cutter) -> Ints:
    """Return the rows (k,) of a linked path between which and its links the tool goes square to its axis:
    these links were found free, whatever is over them."""
    move, axis = np.diff(path.tip, axis=0), path.axis[:-1]
    length, along = np.linalg.norm(move, axis=1), np.abs((move * axis).sum(axis=1))
    square = (path.motion[1:] == Motion.LINK) & (length > 0.0) & (along < SQUARE * length)
    blocks = np.flatnonzero(square & (cutter.undercut > 0.0))
    return np.union1d(blocks, blocks + 1)


def _ends(polyline: Ints, some: Bools) -> Ints:
    """Return the first and the last row of each unbroken stretch of ``some`` (n,) rows within a ``polyline``
    (n,)."""
    joined = some[1:] & some[:-1] & (polyline[1:] == polyline[:-1])
    return np.flatnonzero(some & ~(np.append(False, joined) & np.append(joined, False)))


def _across(axis: Floats) -> Floats:
    """Return unit directions (m, WAYS, 3) across the unit ``axis`` (m, 3), evenly about it."""
    least = np.eye(3)[np.abs(axis).argmin(axis=1)]
    one = np.cross(axis, least)
    one /= np.linalg.norm(one, axis=1)[:, None]
    turn = np.arange(WAYS) * (2.0 * math.pi / WAYS)
    return np.asarray(
        one[:, None] * np.cos(turn)[:, None] + np.cross(axis, one)[:, None] * np.sin(turn)[:, None]
    )


def _out_of_box(tree: FacetTree, tip: Floats, way: Floats) -> Floats:
    """How far (m, k) mm it is from the tips (m, 3) to the border of the part's box, in each of the directions
    (m, k, 3)."""
    middle, half = tree.middle[:, 0], tree.half[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        off = (np.copysign(half, way) + middle - tip[:, None]) / way
    return np.asarray(np.where(np.isfinite(off), np.maximum(off, 0.0), np.inf).min(axis=2))


def _entering(
    reacher: Reacher, tree: FacetTree, tip: Floats, axis: Floats, way: Floats, progress: Progress
) -> Bools:
    """Which tools (m,) enter the part on a straight way (m, 3) mm."""
    tips, axes = np.stack([tip, tip + way], axis=1).reshape(-1, 3), np.repeat(axis, 2, axis=0)
    blocks = 2 * np.arange(len(tip))
    if not len(tip):
        return np.zeros(0, np.bool_)
    return which_enter(reacher.body, tree, straight_motion(tips, axes), reacher.limit, blocks, progress)[
        blocks
    ]
