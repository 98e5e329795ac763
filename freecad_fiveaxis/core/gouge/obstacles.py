# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is in the way of a tool that touches the surface at a place with an axis: the machine's limits, the
table, the part, fixtures, or bodies of the machine."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import IntEnum

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.vectors import dot
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.passes import axes_within_limits, least_up
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import (
    CUTTER,
    HOLDER,
    LARGEST,
    SHANK,
    Body,
    body_of,
    body_support,
    extend_way_out,
)
from freecad_fiveaxis.core.tool.stick_out import Stack, clamp_tool

from .machine_in_pose import MachineInPose
from .search import which_enter
from .swept_motion import still_positions

ROUNDING = 0.1
"""Of what may enter the part: a body that touches a plane from above is above it, though rounding says a
little less."""

ROWS = 64
"""Normals at a time along which all corners of a hull are measured."""


class Obstacle(IntEnum):
    """Why the tool does not get to a place, in the order in which axes are asked; in a closed hollow none is,
    and the last is no obstacle. Whether it is the cutter's end that enters or its flank, a reach map asks
    (:mod:`~freecad_fiveaxis.core.studies.reach_map`); :func:`obstacles` says CUTTER of both."""

    HOLLOW = 0
    LIMITS = 1
    TABLE = 2
    CUTTER = 3
    FLANK = 4
    SHANK = 5
    HOLDER = 6
    FIXTURE = 7
    MACHINE = 8
    NONE = 9


@dataclass(frozen=True, eq=False)
class Reacher:
    """What is set on the part: ``limit`` mm that may enter it; ``table`` mm: height of the table's face in
    the work frame, below which no part of the tool may be, None where it is not known. ``kinematics`` None:
    any axis will do; ``most`` rad: the largest angle from +Z that is wanted; ``far`` mm: so far along its
    axis it must be free to be drawn out. ``machine``: its bodies, None: it has none, or they are not looked
    at. ``fixtures``: those, work frame, that are asked by themselves once the part is not in the way; None:
    there are none, or what is asked holds part and fixtures together. ``floors`` mm, falling: as ``table``,
    but an axis goes below one where none above it is free."""

    cutter: Cutter
    shank: tuple[tuple[float, float], ...] = ()
    holder: tuple[tuple[float, float], ...] = ()
    kinematics: Chain | None = None
    limit: float = 0.01
    table: float | None = None
    most: float = math.pi
    far: float = 0.0
    machine: MachineInPose | None = None
    fixtures: Mesh | None = None
    floors: tuple[float, ...] = ()

    @property
    def body(self) -> Body:
        """Cutter, shank and holder, in all places on their way out."""
        body = body_of(self.cutter, self.shank, self.holder)
        return extend_way_out(body, self.far) if self.far else body


def obstacles(
    reacher: Reacher,
    tree: FacetTree,
    point: Floats,
    normal: Floats,
    axis: Floats,
    height: Floats | None = None,
) -> Ints:
    """Return what is in the way (n,) of :class:`Obstacle` of the tool that touches ``point`` (n, 3) mm, where
    the surface has the unit ``normal`` (n, 3), with the unit ``axis`` (n, 3). ``height`` (n,) mm as of
    :func:`part_heights`, where it is known: of a tool that stands above all of the part nothing more is
    asked."""
    met, body = np.full(len(point), int(Obstacle.NONE)), reacher.body
    tip = tip_at(reacher.cutter, point, normal, axis)
    above = (
        np.zeros(len(point), np.bool_)
        if height is None
        else is_above(body, tip, axis, normal, height, reacher.limit)
    )

    def enters_with(part: int) -> Callable[[Ints], Bools]:
        def hit(rows: Ints) -> Bools:
            hits, low = np.zeros(len(rows), np.bool_), ~above[rows]
            hits[low] = enters(body.only(part), tree, tip[rows[low]], axis[rows[low]], reacher.limit)
            return hits

        return hit

    checks: tuple[tuple[Obstacle, Callable[[Ints], Bools]], ...] = (
        (Obstacle.LIMITS, lambda rows: ~within_limits(reacher, axis[rows])),
        (Obstacle.TABLE, lambda rows: is_below(body, tip[rows], axis[rows], reacher.table, reacher.limit)),
        (Obstacle.CUTTER, enters_with(CUTTER)),
        (Obstacle.SHANK, enters_with(SHANK)),
        (Obstacle.HOLDER, enters_with(HOLDER)),
        (Obstacle.FIXTURE, lambda rows: _hits_fixture(reacher, tip[rows], axis[rows])),
        (Obstacle.MACHINE, lambda rows: _hits_machine(reacher, tree, tip[rows], axis[rows])),
    )
    for obstacle, hit in checks:
        rows = np.flatnonzero(met == Obstacle.NONE)
        met[rows[hit(rows)]] = obstacle
    return met


def stay_above(reacher: Reacher) -> tuple[Reacher, ...]:
    """Return the tool above each of its floors, the highest first, then down to the table."""
    return (*(replace(reacher, table=floor) for floor in reacher.floors), reacher)


def find_lower(reacher: Reacher, point: Floats, normal: Floats, axis: Floats, instead: Floats) -> Bools:
    """Find where (n,) of contacts ``point`` (n, 3) mm with unit ``normal`` (n, 3) the tool goes below one of
    its floors with the unit ``axis`` (n, 3), and not with ``instead`` (n, 3)."""
    lower, body, limit = np.zeros(len(point), np.bool_), reacher.body, reacher.limit
    for floor in reacher.floors:
        low, high = (
            is_below(body, tip_at(reacher.cutter, point, normal, one), one, floor, limit)
            for one in (axis, instead)
        )
        lower |= low & ~high
    return lower


def stick_out_farther(reacher: Reacher, more: float) -> Reacher:
    """Let the tool stick out ``more`` mm farther, or as far as any may, and be as much longer where its
    length is known."""
    stack = Stack(reacher.cutter, reacher.shank, reacher.holder)
    length = min(stack.stick_out + more, LARGEST)
    longer = replace(reacher, shank=clamp_tool(stack, length).shank)
    if longer.machine is None:
        return longer
    return replace(longer, machine=longer.machine.longer(length - stack.stick_out, longer.body))


def _hits_fixture(reacher: Reacher, tip: Floats, axis: Floats) -> Bools:
    """Whether (n,) tool or spindle go into a fixture with the tip (n, 3) mm and unit axis (n, 3) there."""
    if reacher.fixtures is None or not len(tip):
        return np.zeros(len(tip), np.bool_)
    spindle = Body(()) if reacher.machine is None else reacher.machine.spindle
    if reacher.far:
        spindle = extend_way_out(spindle, reacher.far)
    stack = Body((*reacher.body.pieces, *spindle.pieces))
    return enters(stack, facet_tree(reacher.fixtures), tip, axis, reacher.limit)


def _hits_machine(reacher: Reacher, tree: FacetTree, tip: Floats, axis: Floats) -> Bools:
    """Whether (n,) the machine is in the way of the tool with its tip (n, 3) mm and unit axis (n, 3)
    there."""
    if reacher.machine is None or not len(tip):
        return np.zeros(len(tip), np.bool_)
    return reacher.machine.hits(reacher.body, tree, tip, axis, reacher.limit, reacher.far)


def part_heights(tree: FacetTree, normal: Floats) -> Floats:
    """Measure how far (n,) mm the part reaches along each unit ``normal`` (n, 3), its support by the corners
    of its hull, with the largest allowance; infinite of a part that is flat, which has none."""
    corner = _each_once(tree.corner.reshape(3, 3, -1).transpose(1, 0, 2).reshape(3, -1))
    try:
        corner = corner[scipy.spatial.ConvexHull(corner).vertices]
    except scipy.spatial.QhullError:
        return np.full(len(normal), np.inf)
    parts = [normal[first : first + ROWS] @ corner.T for first in range(0, len(normal), ROWS)]
    return (
        np.concatenate([part.max(axis=1) for part in parts]) + tree.most_allowance if parts else np.empty(0)
    )


def _each_once(point: Floats) -> Floats:
    """Return the different ones (k, 3) of points (3, n), ascending: as ``np.unique`` of rows, which compares
    them one with another."""
    order = np.lexsort(point[::-1])
    point = point.take(order, axis=1)
    new = np.append(True, (np.diff(point, axis=1) != 0.0).any(axis=0))[: len(order)]
    return np.ascontiguousarray(point[:, new].T)


def is_above(body: Body, tip: Floats, axis: Floats, normal: Floats, height: Floats, limit: float) -> Bools:
    """Find which bodies (n,) with tips and unit axes (n, 3) there lie above the plane at ``height`` (n,) mm
    across ``normal`` (n, 3), but for much less than ``limit`` mm."""
    lowest = dot(tip.T, normal.T) - body_support(body, -dot(axis.T, normal.T))
    return np.asarray(lowest > height - ROUNDING * limit)


def tip_at(cutter: Cutter, point: Floats, normal: Floats, axis: Floats) -> Floats:
    """Return the tips (n, 3) mm of a cutter that touches these points (n, 3) with its corner, or a barrel's
    flank: its corner circle leans towards the surface, and with an axis along the normal the middle of its
    bottom stands on the point."""
    if (barrel := cutter.barrel) is not None:
        return np.asarray(point + cutter.corner * (normal - axis) + barrel.hub_shift(normal, axis))
    across = normal - dot(normal.T, axis.T)[:, None] * axis
    length = np.linalg.norm(across, axis=1)[:, None]
    lean = np.divide(across, length, out=np.zeros_like(across), where=length > 1e-9)
    return np.asarray(point + cutter.corner * (normal - axis) + cutter.ring * lean)


def within_limits(reacher: Reacher, axis: Floats) -> Bools:
    """Which unit axes (n, 3) the machine takes up and are wanted (n,)."""
    within = axis[:, 2] >= least_up(reacher.most)
    return (
        within
        if reacher.kinematics is None
        else np.asarray(within & axes_within_limits(reacher.kinematics, axis))
    )


def is_below(body: Body, tip: Floats, axis: Floats, table: float | None, limit: float) -> Bools:
    """Find which bodies (n,) with tips (n, 3) mm and unit axes (n, 3) go more than ``limit`` mm below the
    table's face, whose height is ``table`` mm; None where that is not known."""
    if table is None:
        return np.zeros(len(tip), np.bool_)
    return np.asarray(tip[:, 2] - body_support(body, -axis[:, 2]) < table - limit)


def enters(body: Body, tree: FacetTree, tip: Floats, axis: Floats, limit: float) -> Bools:
    """Whether (n,) the body enters the part by more than ``limit`` mm with its tip (n, 3) mm and unit axis
    (n, 3) there."""
    if not body.pieces or not len(tip):
        return np.zeros(len(tip), np.bool_)
    return which_enter(body, tree, still_positions(tip, axis), limit, np.arange(len(tip)))
