# SPDX-License-Identifier: LGPL-2.1-or-later
"""Free tool axes of cutters that end in a plane: flat and bull nose.

level    the tool axis along the normal: the bottom lies on the surface, and passes may be as far apart as it
         is wide.
flank    the tool axis square to the normal: the side of the cutter lies along the surface, a wall.
aslant   anything between: the cutter touches with its corner alone.
slide    a level bottom may touch with any of its points. Beside a wall it is put as far from its contact as
         it must be to stand free, on the same plane: what it covers is what it would have touched.

Where a level or a flank axis is free, no other is taken.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.obstacles import Reacher

from .axis_field import Freedom, Nodes, are_free, unit, with_way_out

FLANK = math.sin(math.radians(0.6))
"""Sine: a direction that stands no farther off the surface is along a wall."""

TO_LEVEL, TO_FLANK = math.cos(math.radians(45.0)), math.sin(math.radians(30.0))
"""Cosine to the normal from which an axis of the field is made level; sine up to which it is laid along the
wall."""

WAYS, HALVINGS = 12, 5
"""Directions in which a bottom slides, and how often the shortest of these ways is halved."""

SHARES = (0.25, 0.5, 0.75, 1.0, 1.05)
"""Of the cutter's radius: how far it slides."""

LOWER = 3.0
"""Times what may enter: so much lower the bottom meets the surface that it lies on."""


def prefer_level(freedom: Freedom, normal: Floats) -> tuple[Freedom, Bools]:
    """Leave at each node, with its unit ``normal`` (n, 3), only level and flank axes free where any is, and
    say where (n,)."""
    flank = freedom.free & (np.abs(normal @ freedom.direction.T) < FLANK)
    good = freedom.upright | flank.any(axis=1)
    return replace(freedom, free=np.where(good[:, None], flank, freedom.free)), good


def stand_level(axis: Floats, normal: Floats) -> Floats:
    """Return unit axes (n, 3) made level where they are nearly along the unit ``normal`` (n, 3), and laid
    along the wall where they are nearly square to it."""
    along = (axis * normal).sum(axis=1)[:, None]
    flank = unit(axis - along * normal)
    return np.where(along > TO_LEVEL, normal, np.where(np.abs(along) < TO_FLANK, flank, axis))


def stand_level_where_free(
    axis: Floats, nodes: Nodes, freedom: Freedom, reacher: Reacher, tree: FacetTree
) -> Floats:
    """Return the axes (n, 3) of nodes, level or along the wall wherever the tool is free so."""
    level = stand_level(axis, nodes.normal)
    rows = np.flatnonzero(freedom.some & (np.abs(level - axis).max(axis=1) > 1e-9))
    good = are_free(with_way_out(reacher, tree), tree, nodes.stand[rows], nodes.normal[rows], level[rows])
    found = axis.copy()
    found[rows[good]] = level[rows[good]]
    return found


def slide_bottoms(
    reacher: Reacher, tree: FacetTree, stand: Floats, normal: Floats, progress: Progress = silent
) -> Floats:
    """Find how (n, 3) mm a level bottom must slide that touches ``stand`` (n, 3) mm with its middle, with its
    axis along the unit ``normal`` (n, 3), to be free: nothing where it is, or where no way leads out."""
    slide = np.zeros_like(stand)
    rows = np.flatnonzero(~are_free(reacher, tree, stand, normal, normal, progress))
    if not len(rows):
        return slide
    way = _ways_across(normal[rows])
    first = np.full(len(rows), -1)
    far = np.zeros(len(rows))
    low = np.zeros(len(rows))
    before = 0.0
    for share in SHARES:
        far_now = share * reacher.cutter.radius
        for k in range(WAYS):
            ask = np.flatnonzero(first < 0)
            if not len(ask):
                break
            at = stand[rows[ask]] + far_now * way[ask, k]
            good = _lies_free(reacher, tree, at, normal[rows[ask]], progress)
            first[ask[good]], far[ask[good]], low[ask[good]] = k, far_now, before
        before = far_now
    out = np.flatnonzero(first >= 0)
    rows, way, far, low = rows[out], way[out, first[out]], far[out], low[out]
    for _ in range(HALVINGS):
        middle = 0.5 * (low + far)
        good = _lies_free(reacher, tree, stand[rows] + middle[:, None] * way, normal[rows], progress)
        far, low = np.where(good, middle, far), np.where(good, low, middle)
    slide[rows] = far[:, None] * way
    return slide


def _lies_free(reacher: Reacher, tree: FacetTree, at: Floats, normal: Floats, progress: Progress) -> Bools:
    """Whether (n,) a level bottom is free at ``at`` (n, 3) mm and lies on the part there."""
    free = are_free(reacher, tree, at, normal, normal, progress)
    rows = np.flatnonzero(free)
    bare = replace(reacher, shank=(), holder=(), kinematics=None, most=math.pi, table=None, far=0.0, machine=None)
    down = at[rows] - LOWER * reacher.limit * normal[rows]
    free[rows] = ~are_free(bare, tree, down, normal[rows], normal[rows], progress)
    return free


def _ways_across(normal: Floats) -> Floats:
    """Return WAYS unit vectors (n, WAYS, 3) square to each unit ``normal`` (n, 3)."""
    one = unit(np.cross(normal, np.eye(3)[np.abs(normal).argmin(axis=1)]))
    two = np.cross(normal, one)
    turn = 2.0 * math.pi * np.arange(WAYS) / WAYS
    return np.cos(turn)[:, None] * one[:, None] + np.sin(turn)[:, None] * two[:, None]
