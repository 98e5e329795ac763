# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the tool goes: the poses of every block at every u, and how much the way between two poses bends.

pose      where the tip stands and where the unit axis points, work frame.
block     the way from one row to the next, u from 0 to 1. Block i leads to row i + 1.
stretch   a part of a block, from one u to another, short enough to bend little; or several of them in a row
          (a cluster).
bend      of a stretch: how far, at most, tip (mm) and axis (a pure number) leave the straight way between its
          two end poses.

**Why the end poses are enough.** A piece's support in direction g is the larger one of ``g . (tip + z axis) +
r |g x axis|`` for its two discs, plus its round. Where tip and axis move straight this is a convex function
of u, because a norm of something linear is convex; so it is largest at an end. What they leave the straight
way by adds at most ``bend_tip + (|z| + r) bend_axis``. A stretch of the body therefore lies in the convex
hull of its two end bodies, thickened by that much.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.vectors import NO_DIRECTION
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.deviation.bound import bending, quick_levers
from freecad_fiveaxis.core.motion.trajectory import (
    Vectors,
    at,
    axis,
    check_words,
    frames,
    motion,
    tip,
    to_work,
)

WIDE = 4
"""Stretches, or clusters, in a cluster."""

MOST_PARTS = 64
"""A block is not laid out in more stretches than that at first; what bends more is divided where it
matters."""


class Poses(NamedTuple):
    """``tip`` (3, n) mm, ``axis`` (3, n) unit."""

    tip: Floats
    axis: Floats


@dataclass(frozen=True, eq=False)
class SweptMotion:
    """``pose`` gives the poses of blocks (n,) at u (n,); ``bend_tip`` (m,) mm and ``bend_axis`` (m,) bound
    the second derivatives by u of tip and axis in each of the m blocks."""

    pose: Callable[[Ints, Floats], Poses]
    bend_tip: Floats
    bend_axis: Floats

    def __len__(self) -> int:
        return len(self.bend_tip)


def straight_motion(
    tips: Floats, axes: Floats, above: float = 0.0, blocks: Ints | None = None
) -> SweptMotion:
    """Return the swept motion as it is commanded: the unit axis (n, 3) on great arcs, and on straight lines
    the point ``above`` mm over the tip (n, 3) mm. ``blocks`` (k,): it has only those, in their order, None:
    all."""
    ends = (slice(None, -1), slice(1, None)) if blocks is None else (blocks, blocks + 1)
    first, last = (_columns(axes[rows]) for rows in ends)
    start, end = (_columns(tips[rows]) for rows in ends)
    if above:
        start, end = start + above * first, end + above * last
    way = end - start
    angle = 2.0 * np.arcsin(np.minimum(0.5 * np.linalg.norm(last - first, axis=0), 1.0))
    across, length = _across(first, last)

    def pose(block: Ints, u: Floats) -> Poses:
        turned = u * angle.take(block)
        k = np.cos(turned) * first.take(block, axis=1)
        k += (np.sin(turned) / length.take(block)) * across.take(block, axis=1)
        point = start.take(block, axis=1) + u * way.take(block, axis=1)
        return Poses(point - above * k if above else point, k)

    return SweptMotion(pose, above * angle * angle, angle * angle)


def without_ways(swept: SweptMotion, unknown: Bools) -> SweptMotion:
    """Return the swept motion in which the blocks ``unknown`` (m,) stand at their ends."""
    if not unknown.any():
        return swept

    def pose(block: Ints, u: Floats) -> Poses:
        return swept.pose(block, np.where(unknown[block], 1.0, u))

    return SweptMotion(pose, swept.bend_tip * ~unknown, swept.bend_axis * ~unknown)


def still_positions(tips: Floats, axes: Floats) -> SweptMotion:
    """Blocks that only stand: one for each tip (n, 3) mm and unit axis (n, 3)."""
    place, pointing = _columns(tips), _columns(axes)

    def pose(block: Ints, u: Floats) -> Poses:
        return Poses(place.take(block, axis=1), pointing.take(block, axis=1))

    return SweptMotion(pose, np.zeros(len(tips)), np.zeros(len(tips)))


def ways_up(tips: Floats, axes: Floats, way: Floats) -> SweptMotion:
    """Blocks that go up: one for each tip (n, 3) mm, ``way`` (n,) mm along its unit axis (n, 3)."""
    place, pointing = _columns(tips), _columns(axes)

    def pose(block: Ints, u: Floats) -> Poses:
        axis = pointing.take(block, axis=1)
        return Poses(place.take(block, axis=1) + u * way.take(block) * axis, axis)

    return SweptMotion(pose, np.zeros(len(tips)), np.zeros(len(tips)))


def _across(first: Floats, last: Floats) -> tuple[Floats, Floats]:
    """Return what of the axes ``last`` (3, n) is square to ``first``, towards which great arcs begin, and its
    length (n,); between opposite axes one of the many directions there are.

    Not :func:`~.vectors.slerp`: its last digits differ, and the lift, which stops at the first depth that
    will do, would make other programs of the same solid."""
    across = last - (first * last).sum(axis=0) * first
    length = np.linalg.norm(across, axis=0)
    lost = np.flatnonzero(length < NO_DIRECTION)
    if len(lost):
        any_way = np.cross(first[:, lost], np.eye(3)[np.abs(first[:, lost]).argmin(axis=0)].T, axis=0)
        across[:, lost] = any_way
        length[lost] = np.linalg.norm(any_way, axis=0)
    return across, np.asarray(length)


def real_motion(kinematics: Chain, words: Floats, back: float = 0.0) -> SweptMotion:
    """Return the swept motion on the machine, all axes moving linearly between rows of ``words`` (n, 5), mm
    and **degrees**.

    ``back`` mm: the point that the words drive lies so far above the tip (the ball's centre is driven).
    Raises ProgramError for words that cannot be used.
    """
    rows, frame = check_words(words), frames(kinematics)
    move = motion(frame, rows[:-1], rows[1:])
    turn = np.broadcast_to(np.abs(move.a_step) + np.abs(move.b_step), (len(rows) - 1,)) ** 2

    def pose(block: Ints, u: Floats) -> Poses:
        there = at(move.take(block), u)
        k = _stack_columns(to_work(frame, axis(frame, there)), len(block))
        return Poses(_stack_columns(to_work(frame, tip(frame, there)), len(block)) - back * k, k)

    return SweptMotion(pose, np.broadcast_to(bending(quick_levers(move), 2), turn.shape) + back * turn, turn)


def _stack_columns(vector: Vectors, count: int) -> Floats:
    return np.stack([np.broadcast_to(column, (count,)) for column in vector])


def _columns(rows: Floats) -> Floats:
    return np.ascontiguousarray(np.asarray(rows, float).T)


# ------------------------------------------------------------------------------------------------ stretches


class MotionSegments(NamedTuple):
    """``block`` (n,), from ``start`` to ``end`` (n,), the u of that block."""

    block: Ints
    start: Floats
    end: Floats


def segments_of(swept: SweptMotion, blocks: Ints, reach: float, least: float) -> MotionSegments:
    """Return these blocks (k,) in stretches in which no point up to ``reach`` mm from the tip leaves the
    straight way by more than ``least`` mm, as far as MOST_PARTS allow."""
    bent = 0.125 * (swept.bend_tip[blocks] + reach * swept.bend_axis[blocks])
    count = np.clip(np.ceil(np.sqrt(bent / least)), 1, MOST_PARTS).astype(np.int64)
    row, part = number_runs(count)
    share = (1.0 / count)[row]
    return MotionSegments(blocks[row], part * share, (part + 1) * share)


class StraightSweep(NamedTuple):
    """The straight way between two poses, from ``tip`` - ``travel`` to ``tip`` + ``travel`` with the axes
    ``cosine unit`` -+ ``turn`` (None where no axis turns: 1 and 0). ``bend_tip`` (mm), ``bend_axis``: what
    the way itself leaves this one by. All are rows of ``column`` (15 or 11, n), or (7 or 6, n) where all only
    stand: then travel and bends are None, too, all of them 0."""

    column: Floats
    tip: Floats
    unit: Floats
    travel: Floats | None
    bend_tip: Floats | None
    bend_axis: Floats | None
    turn: Floats | None
    cosine: Floats | None

    @classmethod
    def of(cls, column: Floats) -> StraightSweep:
        """Return the way whose rows these are."""
        if len(column) < 11:
            return cls(
                column,
                column[0:3],
                column[3:6],
                None,
                None,
                None,
                None,
                column[6] if len(column) > 6 else None,
            )
        turn, cosine = (column[11:14], column[14]) if len(column) > 11 else (None, None)
        return cls(column, column[0:3], column[3:6], column[6:9], column[9], column[10], turn, cosine)

    def take(self, rows: Ints) -> StraightSweep:
        """Return some of them."""
        return StraightSweep.of(self.column.take(rows, axis=1))


class Clusters(NamedTuple):
    """Stretches and their clusters in one table, the largest first: ``sweep`` (11 or 15, n), rows as in
    :class:`StraightSweep`; ``size`` (n,) mm, half the travel; ``child`` (n,) the first part and ``arity``
    (n,); ``first`` the column of the first stretch, ``top`` how many clusters stand at the head. ``still`` (7
    or 6, n): the rows of ``sweep`` that are not 0 in any stretch, where all of these only stand; else
    None."""

    sweep: Floats
    size: Floats
    child: Ints
    arity: Ints
    first: int
    top: int
    still: Floats | None

    def ways(self, rows: Ints) -> StraightSweep:
        """Those of these clusters (k,)."""
        table = self.sweep if self.still is None or not len(rows) or rows.min() < self.first else self.still
        return StraightSweep.of(table.take(rows, axis=1))


def clusters_of(swept: SweptMotion, parts: MotionSegments, reach: float, levels: int = 3) -> Clusters:
    """Return the table over stretches that follow one another; ``reach`` mm from the tip to the farthest
    point of the body."""
    start, end = swept.pose(parts.block, parts.start), swept.pose(parts.block, parts.end)
    share = 0.125 * (parts.end - parts.start) ** 2
    bend_tip, bend_axis = share * swept.bend_tip[parts.block], share * swept.bend_axis[parts.block]
    rows = [(*_straight(start, end), bend_tip, bend_axis)]
    counts = [len(share)]
    for _ in range(levels):
        first = np.arange(0, counts[0], WIDE)
        last = np.minimum(first + WIDE, counts[0]) - 1
        begin, stop = Poses(*(part[:, first] for part in start)), Poses(*(part[:, last] for part in end))
        straight = _straight(begin, stop)
        rows.insert(0, (*straight, *_compute_joined_bends(straight, start, end, first, last, *rows[0][4:])))
        start, end = begin, stop
        counts.insert(0, len(first))
    tip, travel, axis, turn, bend_tip, bend_axis = (
        np.concatenate(column, axis=-1) for column in zip(*rows, strict=True)
    )
    cosine, turned = _length(axis), _length(turn)
    unit = np.where(cosine > NO_DIRECTION, axis / np.maximum(cosine, NO_DIRECTION), np.eye(3)[:, 2:])
    sweep = [tip, unit, travel, bend_tip[None], bend_axis[None]]
    if turned.any():
        sweep += [turn, cosine[None]]
    size = _length(travel) + bend_tip + reach * (turned + bend_axis)
    table, (child, arity) = np.concatenate(sweep), _family(counts)
    stretches = sum(counts[:-1])
    still = (
        None if table[6:14, stretches:].any() else np.concatenate([tip, unit, *sweep[6:]])
    )  # and cosine where there is one
    return Clusters(table, size, child, arity, stretches, counts[0], still)


def _length(vector: Floats) -> Floats:
    return np.asarray(np.sqrt((vector * vector).sum(axis=0)))


def _family(counts: list[int]) -> tuple[Ints, Ints]:
    child, arity, start = [], [], 0
    for count, more in pairwise(counts):
        start += count
        first = WIDE * np.arange(count)
        child.append(start + first)
        arity.append(np.minimum(first + WIDE, more) - first)
    none = np.zeros(counts[-1], np.int64)
    return np.concatenate([*child, none]), np.concatenate([*arity, none])


def _straight(start: Poses, end: Poses) -> tuple[Floats, Floats, Floats, Floats]:
    """Tip, travel, axis and turn of the straight ways from pose to pose."""
    travel, turn = 0.5 * (end.tip - start.tip), 0.5 * (end.axis - start.axis)
    return start.tip + travel, travel, start.axis + turn, turn


def _compute_joined_bends(
    straight: tuple[Floats, ...], start: Poses, end: Poses, first: Ints, last: Ints, bend_tip: Floats,
    bend_axis: Floats
) -> tuple[Floats, Floats]:  # fmt: skip
    """Return what ways from ``start`` to ``end`` (n,), with their own bends, leave the straight ones (k,) by
    that lead over those from ``first`` to ``last`` (k,).

    Both their ends are compared with the point of the straight way at which its tip is nearest; what lies
    between them leaves that by no more than the farther end and its own bend.
    """
    tip, travel, axis, turn = straight
    group = np.repeat(np.arange(len(first)), last - first + 1)
    off_tip, off_axis = np.zeros(len(group)), np.zeros(len(group))
    square, along = np.maximum((travel * travel).sum(axis=0), 1e-300)[group], travel[:, group]
    even = 2.0 * (np.arange(len(group)) - first[group]) / np.maximum(last - first, 1)[group] - 1.0
    turns = (start.axis != axis[:, group]).any() or (end.axis != axis[:, group]).any()
    for pose in (start, end):
        arm = pose.tip - tip[:, group]
        share = np.clip((arm * along).sum(axis=0) / square, -1.0, 1.0)
        share = np.where(square > 1e-18, share, even)
        off_tip = np.maximum(off_tip, _length(arm - share * along))
        if turns:
            off_axis = np.maximum(off_axis, _length(pose.axis - axis[:, group] - share * turn[:, group]))
    return np.maximum.reduceat(bend_tip + off_tip, first), np.maximum.reduceat(bend_axis + off_axis, first)
