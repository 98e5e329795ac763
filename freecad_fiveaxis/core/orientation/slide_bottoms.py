# SPDX-License-Identifier: LGPL-2.1-or-later
"""Level bottoms beside walls: a bottom may touch with any of its points. Where it would not be free with its
middle on a contact, it slides on the plane as far as it must to be free, and covers the contact still, or as
much about it as gets under that cutter."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.obstacles import Reacher

from .axis_field import are_free, unit

CLEAR = 0.5
"""Of what may enter: a bottom that has slid enters by no more."""

WAYS, HALVINGS = 16, 5
"""Directions in which a bottom slides, and how often the shortest of these ways is halved."""

SHARES = (0.25, 0.5, 0.75, 1.0, 1.25, 1.45)
"""Of the cutter's radius: how far it slides; out of a corner by its diagonal."""

LOWER = 3.0
"""Times what may enter: so much lower the bottom meets the surface that it lies on."""


def slide_bottoms(
    reacher: Reacher, tree: FacetTree, stand: Floats, normal: Floats, progress: Progress = silent
) -> Floats:
    """Find how (n, 3) mm a level bottom must slide that touches ``stand`` (n, 3) mm with its middle, with its
    axis along the unit ``normal`` (n, 3), to be free: nothing where it is, or where no way leads out."""
    slide, reacher = np.zeros_like(stand), replace(reacher, limit=CLEAR * reacher.limit)
    rows = np.flatnonzero(~are_free(reacher, tree, stand, normal, normal, progress))
    way, near, far = _find_ways_out(reacher, tree, stand[rows], normal[rows], progress)
    out = far > 0.0
    rows, way, near, far = rows[out], way[out], near[out], far[out]
    for _ in range(HALVINGS):
        middle = 0.5 * (near + far)
        good = _lies_free(reacher, tree, stand[rows] + middle[:, None] * way, normal[rows], progress)
        near, far = np.where(good, near, middle), np.where(good, middle, far)
    slide[rows] = far[:, None] * way
    return slide


def _find_ways_out(
    reacher: Reacher, tree: FacetTree, stand: Floats, normal: Floats, progress: Progress
) -> tuple[Floats, Floats, Floats]:
    """Find the unit ``way`` (n, 3) on which the shortest of the slides that are tried ends free, and between
    which lengths of it, mm (n,) and (n,), the tool comes free; 0 where none does."""
    way, near, far = np.zeros_like(stand), np.zeros(len(stand)), np.zeros(len(stand))
    ways, radius = _ways_across(normal), reacher.cutter.radius
    for shorter, longer in pairwise((0.0, *SHARES)):
        ask = np.flatnonzero(far == 0.0)
        free = np.stack(
            [
                _lies_free(reacher, tree, stand[ask] + longer * radius * one, normal[ask], progress)
                for one in ways[ask].transpose(1, 0, 2)
            ],
            axis=1,
        )
        row = free.any(axis=1)
        ask, free = ask[row], free[row]
        first = ways[ask, free.argmax(axis=1)]
        between = unit((free[:, :, None] * ways[ask]).sum(axis=1))  # straight off a wall, halfway in a corner
        good = _lies_free(reacher, tree, stand[ask] + longer * radius * between, normal[ask], progress)
        good &= np.linalg.norm(between, axis=1) > 0.5
        way[ask] = np.where(good[:, None], between, first)
        near[ask], far[ask] = shorter * radius, longer * radius
    return way, near, far


def _lies_free(reacher: Reacher, tree: FacetTree, at: Floats, normal: Floats, progress: Progress) -> Bools:
    """Whether (n,) a level bottom is free at ``at`` (n, 3) mm and lies on the part there: a little lower the
    cutter would enter."""
    free = are_free(reacher, tree, at, normal, normal, progress)
    rows = np.flatnonzero(free)
    bare = Reacher(reacher.cutter, limit=reacher.limit)
    lower = at[rows] - LOWER * reacher.limit * normal[rows]
    free[rows] = ~are_free(bare, tree, lower, normal[rows], normal[rows], progress)
    return free


def _ways_across(normal: Floats) -> Floats:
    """Return WAYS unit vectors (n, WAYS, 3) square to each unit ``normal`` (n, 3)."""
    one = unit(np.cross(normal, np.eye(3)[np.abs(normal).argmin(axis=1)]))
    turn = 2.0 * math.pi * np.arange(WAYS)[:, None] / WAYS
    return np.asarray(np.cos(turn) * one[:, None] + np.sin(turn) * np.cross(normal, one)[:, None])
