# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far, at most, the tip can bend away from the straight line within a block: bounds that hold for every
u.

lever     the distance of the moving point from a rotary line: the longer, the more a turn bends the path.
bending   an upper bound of ``|d^k tip / du^k|``, k >= 2, over the whole block, mm.
allowance what floating-point rounding can add to a computed distance, mm.

With ``tip = s + R1(a) y``, ``y = w + R2(b) v`` and s, w, v, a, b linear in u (see ``trajectory``), Leibniz'
rule gives

    ``|tip^(k)| <= sum_j C(k, j) |a'|^j |y^(k-j)|``     and for m >= 2     ``|y^(m)| <= |b'|^m |v| + m
    |b'|^(m-1) |v'|``,

where for every factor a' or b' only the part across that rotary axis counts. Summed up, with ``t = |a'| +
|b'|``:

    ``|tip^(k)| <= |a'|^k L1 + k |a'|^(k-1) V1 + (t^k - |a'|^k - k |a'|^(k-1) |b'|) L2 + k (t^(k-1) -
    |a'|^(k-1)) V2``

L1 and L2 are the largest levers about the first and the second axis, V1 and V2 the largest speeds of y and v
across them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.vectors import length
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.trajectory import (
    Frames,
    Motion,
    Vectors,
    check_words,
    derivatives,
    flat_length,
    frames,
    motion,
)

ROUNDINGS = 256.0
"""Units in the last place of the coordinates' size that are allowed for. No result passes through as many as
100 roundings of that size (the arithmetic of one tip is 40), the quartic's weights at most double them: the
rest is reserve."""

ABSOLUTE, RELATIVE = 2e-7, 2e-6
"""mm, and share of the deviation: the bound may exceed the deviation by both, a fifth of the accuracy that is
promised."""

CHUNK = 8192
"""Rows worked on at a time: their columns stay in the processor's second-level cache."""


@dataclass(frozen=True, eq=False)
class Levers:
    """``a``, ``b`` (n,) rad: how far each rotary axis turns, unsigned; the others mm, (n,) or one number: L1,
    L2, V1, V2."""

    a: Floats
    b: Floats
    lever1: Floats
    lever2: Floats
    speed1: Floats
    speed2: Floats

    @property
    def turn(self) -> Floats:
        """The summed rotary travel, rad."""
        return self.a + self.b


def bending(levers: Levers, order: int) -> Floats:
    """Return the bound of ``|d^k tip / du^k|`` over the block for k = ``order`` >= 2, mm (formula at the
    module's head)."""
    k, a, b, turn = order, levers.a, levers.b, levers.turn
    a_once, turn_once = a, turn  # to the power of k - 1
    for _ in range(k - 2):
        a_once, turn_once = a_once * a, turn_once * turn
    inner_part = turn_once * turn - a_once * (a + k * b)
    lower = a_once * (a * levers.lever1 + k * levers.speed1)
    return np.asarray(lower + inner_part * levers.lever2 + k * (turn_once - a_once) * levers.speed2)


def quick_levers(move: Motion) -> Levers:
    """Levers by the triangle inequality from the ends of the arm: cheap, no trigonometry, longer than they
    need be."""
    return _levers(move, _quick_lever1(move))


def end_levers(move: Motion, start_reach: Floats, end_reach: Floats) -> Levers:
    """Levers from the true distances ``start_reach``, ``end_reach`` (n,) mm of y from the first axis at both
    ends.

    The distance from a line is convex, so within the block it exceeds the larger end value by at most ``|y''|
    / 8``.
    """
    levers = _levers(move, np.maximum(start_reach, end_reach))
    bent = levers.b * (levers.b * levers.lever2 + 2.0 * levers.speed2)
    return replace(levers, lever1=levers.lever1 + 0.125 * bent)


def close_levers(frame: Frames, move: Motion) -> Levers:
    """Levers from both ends' true distances and speeds, or the quick ones where these are shorter: the most
    work."""
    still = _without_first_turn(move)
    reach, speed = [], []
    for u in (np.zeros_like(move.a), np.ones_like(move.a)):
        y, first, _ = derivatives(frame, still, u)
        reach.append(flat_length(y[0], y[1]))
        speed.append(flat_length(first[0], first[1]))
    levers = end_levers(move, *reach)
    bent = levers.b**2 * (levers.b * levers.lever2 + 3.0 * levers.speed2)  # |y'''|, as |y''| above
    lever1 = np.minimum(levers.lever1, _quick_lever1(move))
    return replace(levers, lever1=lever1, speed1=np.minimum(levers.speed1, np.maximum(*speed) + 0.125 * bent))


def _quick_lever1(move: Motion) -> Floats:
    """L1 <= |w across| + |v|, each largest at an end."""
    w, v = _ends(move, 3), _ends(move, 6)
    return np.asarray(np.maximum(*(flat_length(x, y) for x, y, _ in w)) + np.maximum(*map(length, v)))


def _levers(move: Motion, lever1: Floats) -> Levers:
    """All levers but L1 found here; V1 <= |w' across| + |v'| + |b'| L2."""
    a, b = np.abs(move.a_step), np.abs(move.b_step)
    dx, dy, dz = move.arm_step[6:9]
    lever2 = np.maximum(*(flat_length(x, y) for x, y, _ in _ends(move, 6)))
    speed1 = flat_length(move.arm_step[3], move.arm_step[4]) + length((dx, dy, dz)) + b * lever2
    return Levers(a, b, lever1, lever2, speed1, flat_length(dx, dy))


def _without_first_turn(move: Motion) -> Motion:
    """Return the same motion as seen from the first rotary axis: its tip is y."""
    zero = np.asarray(0.0)
    still = np.zeros_like(move.a)
    return Motion(
        (zero,) * 3 + move.arm[3:], (zero,) * 3 + move.arm_step[3:], still, still, move.b, move.b_step
    )


def _ends(move: Motion, first: int) -> tuple[Vectors, Vectors]:
    """Three columns of the arm, at both ends."""
    x, y, z = move.arm[first : first + 3]
    dx, dy, dz = move.arm_step[first : first + 3]
    return (x, y, z), (x + dx, y + dy, z + dz)


def allowance(move: Motion) -> Floats:
    """Return what rounding can add to a distance in these blocks (n,) mm: so many roundings of a size.

    The size is the sum of the arm's components, times one more than the angles in rad: a rounded angle moves
    the tip, too.
    """
    size: Floats = np.asarray(0.0)
    for start, step in zip(move.arm, move.arm_step, strict=True):
        size = size + (np.abs(start) + np.abs(step) if start.ndim else np.abs(start))
    angle = np.abs(move.a) + np.abs(move.a_step) + np.abs(move.b) + np.abs(move.b_step)
    return np.asarray(ROUNDINGS * np.finfo(float).eps * size * (1.0 + angle))


def quick_bound(kinematics: Chain, words: ArrayLike) -> Floats:
    """Return a proven upper bound (m,) mm of each block's segment deviation, from the end words alone; row 0
    zero.

    ``words`` (m, 5) mm and **degrees**. The same-u point of the commanded segment is at most ``max |tip''| /
    8`` away (error of linear interpolation), so the segment is. It is typically four times the deviation:
    enough to see that a block is harmless. ``deviation.measure`` gives the close bound. Raises ProgramError
    for words that cannot be used.
    """
    rows = check_words(words)
    bound = np.zeros(len(rows))
    frame = frames(kinematics)
    for first in range(0, len(rows) - 1, CHUNK):
        last = min(first + CHUNK, len(rows) - 1)
        move = motion(frame, rows[first:last], rows[first + 1 : last + 1])
        bound[first + 1 : last + 1] = 0.125 * bending(quick_levers(move), 2) + allowance(move)
    return bound
