# SPDX-License-Identifier: LGPL-2.1-or-later
"""Neighbours: pieces that touch, or are in each other, with all joints at zero, as a platter does on its
cradle.

granted  how deep they are in each other there; only what goes deeper is a collision. It is measured as
         everywhere: by how much the standing piece can be pared until the moved one no longer meets it.
hollow   a mesh that does not fill its hull: what lies in its hollow is in the hull, and goes in and out of
         it without a collision, so such neighbours are not looked at.
held     nor are those of which each holds the inmost point of the other: nothing tells how deep they are.
round    a solid with flat sides around it, which turns about its own line, comes out as far as its edges do.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.convex import Convex, Poses, find_gaps
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.geometry.solids import SIDES
from freecad_fiveaxis.core.machine import Vector

from .carried_motion import CarriedMotion

TOUCHING = 0.05
"""mm; pieces of neighbours that are nearer with all joints at zero touch by construction."""

FILLED = 0.95
"""Of its hull's volume: a mesh with less is hollow."""

CLOSELY = 1e-3
"""mm, to which it is known how deep neighbours are in each other."""

MOST = 0.9
"""Of the depth of a piece's inmost point: what is deeper at zero leaves nothing to go deeper into."""

PAIRS = 128
"""Of which is kept how deep they are: they are the same in each check."""

Line = tuple[Vector, Vector, float]
"""Two points of a line, mm, and the radius of what is round about it."""


def touches(one: Convex, other: Convex) -> bool:
    """Tell whether two pieces touch, or are in each other, as they stand."""
    return _are_within(one, other, TOUCHING)


@lru_cache(PAIRS)
def _are_within(one: Convex, other: Convex, within: float) -> bool:
    still, none = Poses(np.eye(3)[None], np.zeros((1, 3))), np.zeros(1)
    return bool(find_gaps(one, other, still, within, none, np.array([[0.0, 0.0, 1.0]])).met[0])


@lru_cache(PAIRS)
def find_granted(moved: Convex, standing: Convex) -> float | None:
    """Find how deep, mm, ``moved`` is in ``standing`` at most as they stand; None where it holds so much of
    it that nothing can be deeper."""
    rounds = moved.round + standing.round

    def meet(level: float) -> bool:
        if rounds:
            return _are_within(moved, standing, -level)
        return _are_within(moved, standing.pare(level), 0.0)

    low, high = 0.0, MOST * (rounds or standing.inmost[1])
    if not meet(low):
        return 0.0
    if meet(high):
        return None
    while high - low > CLOSELY:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if meet(middle) else (low, middle)
    return high


def is_hollow(mesh: Mesh | None) -> bool:
    """Tell whether a mesh, None: a plain solid, fills less than its hull."""
    from scipy.spatial import ConvexHull, QhullError

    if mesh is None:
        return False
    corner = mesh.vertex[mesh.face] - mesh.vertex.mean(axis=0)
    volume = float((corner[:, 0] * np.cross(corner[:, 1], corner[:, 2])).sum()) / 6.0
    try:
        return volume < FILLED * float(ConvexHull(mesh.vertex).volume)
    except QhullError:  # all in a plane: there is no inside
        return False


def find_unevenness(motion: CarriedMotion, line: Line | None) -> float:
    """Find by how much, mm, the edges of what is round about a ``line`` stand out of it, where an axis turns
    it about just that one; else 0."""
    if line is None:
        return 0.0
    one, other, radius = line
    way: Floats = np.subtract(other, one) / math.dist(one, other)
    for axis, _ in motion.steps:
        off = np.array([np.subtract(one, axis.point), way])
        if axis.rotary and np.abs(np.cross(off, axis.direction)).max() < 1e-6 * max(1.0, radius):
            return radius * (1.0 / math.cos(math.pi / SIDES) - 1.0)
    return 0.0
