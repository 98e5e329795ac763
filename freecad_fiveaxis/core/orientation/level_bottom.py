# SPDX-License-Identifier: LGPL-2.1-or-later
"""Free tool axes of cutters that end in a plane: flat and bull nose.

level    the tool axis along the normal: the bottom lies on the surface, and passes may be as far apart as it
         is wide.
flank    the tool axis square to the normal: the side of the cutter lies along the surface, a wall.
aslant   anything between: the cutter touches with its corner alone.

Where a level or a flank axis is free, no other is taken.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.obstacles import Reacher, find_lower

from .axis_field import Freedom, Nodes, are_free, find_field, unit, with_way_out

FLANK = math.sin(math.radians(0.6))
"""Sine: a direction that stands no farther off the surface is along a wall."""

TO_LEVEL, TO_FLANK = math.cos(math.radians(45.0)), math.sin(math.radians(30.0))
"""Cosine to the normal from which an axis of the field is made level; sine up to which it is laid along the
wall."""


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
    long, stand, normal = with_way_out(reacher, tree), nodes.stand[rows], nodes.normal[rows]
    good = are_free(long, tree, stand, normal, level[rows])
    good &= ~find_lower(long, stand, normal, level[rows], axis[rows])
    found = axis.copy()
    found[rows[good]] = level[rows[good]]
    return found


def find_axes(
    nodes: Nodes, freedom: Freedom, reacher: Reacher, tree: FacetTree, progress: Progress = silent
) -> Floats:
    """Find the unit axis (n, 3) of every node, as :func:`.axis_field.find_field`; of a level bottom a level
    or a flank one wherever such a one is free."""
    if not reacher.cutter.has_level_bottom:
        return find_field(nodes, freedom, reacher, tree, progress)
    preferred, good = prefer_level(freedom, nodes.normal)
    axis = find_field(nodes, preferred, reacher, tree, progress, good)
    return stand_level_where_free(axis, nodes, freedom, reacher, tree)
