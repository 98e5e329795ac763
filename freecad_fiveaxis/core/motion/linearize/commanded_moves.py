# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a block's tool should be at any share of it: the tip on the commanded chord, the axis on the
commanded great arc.

move      the way of one block that is to be divided, and the words that follow it. Its ends are the block's
          own words.
share     how much of the chord is done, 0 to 1.
arc       the great arc between the tool axes at both ends, followed evenly with the share (slerp).
even      the rotary words themselves run evenly with the share, and the axis goes where they lead it.
placed    linear words worked out for the *rounded* rotary words: the rounding of a rotary word, which a long
          lever makes many times that of a linear word, then costs the tip nothing.

The words follow the arc on one branch, on the winding next to the middle of the block's own words. They must
arrive at the block's own end words, so that the whole rotary change is kept. They cannot where branch or
winding differ: through the pole onto the other branch, and where the words turn the longer way round. There
the rotary words go evenly, as they do in the undivided block.

Where an end is at the pole, the first rotary word is free, and its turn from the given word to the arc's own
is made at the pole, in next to no share: such a piece is a pure rotation. To have one rule for that and for
an arc that passes close by the pole, the arc ends at NUDGE from the pole, in the direction of the given word:
no controller's step shows that, and the tip does not move. The same nudge opens an arc of half a turn through
the pole itself.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.number_text import round_as_printed
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.vectors import slerp
from freecad_fiveaxis.core.machine.kinematics import Chain, RotaryPair, forward, inverse_axis, joint_words

NUDGE = 1e-7
"""rad: how near an arc may come to the pole; a ninth of half a step of four decimals."""

OPPOSITE = 1e-5
"""rad: axes that near to opposite span no arc."""

SQUARE = 1e-3
"""Cosine between linear axes that still count as square."""

TURN = 2.0 * math.pi


@dataclass(frozen=True)
class Steps:
    """Decimals of linear words, in units of ``unit`` mm, and of rotary words (degrees)."""

    linear: int
    rotary: int
    unit: float = 1.0


def most_off(kinematics: Chain, steps: Steps) -> float:
    """mm: how far the rounding of placed words moves the tip at most.

    The roundings of linear axes that are not square to each other, or not on one side of the rotary axes, may
    add up.
    """
    skew = kinematics.direction[:3] @ kinematics.direction[:3].T - np.eye(3)
    square = len(set(kinematics.slot)) == 1 and np.abs(skew).max() < SQUARE
    return 0.5 * (math.sqrt(3.0) if square else 3.0) * steps.unit * float(10.0**-steps.linear)


@dataclass(frozen=True, eq=False)
class CommandedMoves:
    """Blocks (b,): ``tip`` and ``chord`` (b, 3) mm, work frame; ``start`` and ``turn`` (b, 2) rotary words at
    share 0 and their change, rad; ``even`` (b,) where there is no arc; ``axis0``, ``axis1`` (b, 3) the ends
    of the arc; ``branch`` (b,); ``first``, ``last`` (b, 5) rounded words of the ends, mm and degrees."""

    tip: Floats
    chord: Floats
    start: Floats
    turn: Floats
    even: Bools
    axis0: Floats
    axis1: Floats
    branch: Ints
    first: Floats
    last: Floats

    def take(self, rows: Ints) -> CommandedMoves:
        """Return the moves of some blocks."""
        return CommandedMoves(*(column[rows] for column in vars(self).values()))


def place_words(kinematics: Chain, tip: Floats, angles: Floats, steps: Steps) -> Floats:
    """Return rounded words (n, 5), mm and **degrees**, that put the tip (n, 3) mm in place at rotary words
    ``angles`` (n, 2) rad.

    NaN linear words where the linear axes lie in a plane.
    """
    degrees = round_as_printed(np.degrees(angles), steps.rotary)
    linear = joint_words(kinematics, tip, np.deg2rad(degrees))[:, :3]
    return np.concatenate([round_as_printed(linear, steps.linear, steps.unit), degrees], axis=1)


def compute_commanded_moves(
    kinematics: Chain, tip: Floats, angles: Floats, words: Floats, rows: Ints
) -> CommandedMoves:
    """Return the moves of the blocks that end in ``rows`` (b,).

    ``tip`` (m, 3) mm and ``angles`` (m, 2) rad of all rows as commanded, ``words`` (m, 5) their rounded
    words.
    """
    start, turn = angles[rows - 1], angles[rows] - angles[rows - 1]
    axis0, axis1, half, even = _arcs(kinematics, start, turn)
    across = np.cross(axis0, axis1)
    angle = np.arctan2(np.sqrt((across * across).sum(axis=1)), (axis0 * axis1).sum(axis=1))
    even |= angle > math.pi - OPPOSITE
    branch = np.asarray(half % 2, np.int64)
    return CommandedMoves(
        tip[rows - 1], tip[rows] - tip[rows - 1], start, turn, even, axis0, axis1, branch, words[rows - 1],
        words[rows]
    )  # fmt: skip


def _arcs(kinematics: Chain, start: Floats, turn: Floats) -> tuple[Floats, Floats, Floats, Bools]:
    """Tool axes at both ends, nudged off the pole; the half turn of the second word on which both lie,
    counted from the pole; and where no arc leads from the start words to the end words."""
    pair = RotaryPair.of(kinematics.direction[3], kinematics.direction[4])
    second = np.stack([start[:, 1], start[:, 1] + turn[:, 1]]) - pair.best
    half = np.floor(second.mean(axis=0) / math.pi)
    low, high = half * math.pi, (half + 1.0) * math.pi
    even = ((second < low - NUDGE) | (second > high + NUDGE)).any(axis=0)
    at_pole = (np.minimum(second - low, high - second) <= NUDGE).all(axis=0)
    second = np.clip(second, low + NUDGE, high - NUDGE) + pair.best
    first = np.stack([start[:, 0], start[:, 0] + turn[:, 0]])
    aside = [_azimuth(kinematics, pair, np.zeros_like(angle), angle) for angle in second]
    sweep = pair.sign * turn[:, 0] + aside[1] - aside[0]
    over = np.maximum(np.abs(sweep) - (math.pi - NUDGE), 0.0)
    even |= at_pole | (over > 2.0 * NUDGE)
    first = first + np.array([[0.5], [-0.5]]) * pair.sign * np.copysign(over, sweep)
    axis0, axis1 = (_axis(kinematics, angles) for angles in np.stack([first, second], axis=2))
    return axis0, axis1, half, even


def _axis(kinematics: Chain, angles: Floats) -> Floats:
    return forward(kinematics, np.concatenate([np.zeros((len(angles), 3)), angles], axis=1))[1]


def _azimuth(kinematics: Chain, pair: RotaryPair, first: Floats, second: Floats) -> Floats:
    """Return the angle of the tool axis about the pole, rad."""
    n, t, _ = np.asarray(pair.frame) @ _axis(kinematics, np.stack([first, second], axis=1)).T
    return np.asarray(np.arctan2(t, n))


def follow(kinematics: Chain, way: CommandedMoves, block: Ints, share: Floats, steps: Steps) -> Floats:
    """Return rounded words (r, 5), mm and **degrees**, at a ``share`` (r,) of the move ``block`` (r,); the
    block's own at its ends."""
    tip = way.tip[block] + share[:, None] * way.chord[block]
    words = place_words(kinematics, tip, _angles(kinematics, way, block, share), steps)
    for end, own in ((0.0, way.first), (1.0, way.last)):
        rows = np.flatnonzero(share == end)
        words[rows] = own[block[rows]]
    return words


def _angles(kinematics: Chain, way: CommandedMoves, block: Ints, share: Floats) -> Floats:
    """Rotary words (r, 2) rad at a share of each move."""
    angles = way.start[block] + share[:, None] * way.turn[block]
    rows = np.flatnonzero(~way.even[block])
    if len(rows):
        chosen = block[rows]
        both = inverse_axis(kinematics, arc_axis(way, chosen, share[rows]))[0]
        middle = way.start[chosen] + 0.5 * way.turn[chosen]
        found = np.where(way.branch[chosen, None] == 0, both[0], both[1])
        angles[rows] = found + TURN * np.rint((middle - found) / TURN)
    return angles


def arc_axis(way: CommandedMoves, block: Ints, share: Floats) -> Floats:
    """Return the unit tool axis (r, 3) on the arc, of moves that have one."""
    return slerp(way.axis0[block], way.axis1[block], share)


def tool_axis(kinematics: Chain, way: CommandedMoves, block: Ints, share: Floats) -> Floats:
    """Return the unit tool axis (r, 3) of each move at a share: on the arc, or where the even rotary words
    lead it."""
    axis = _axis(kinematics, way.start[block] + share[:, None] * way.turn[block])
    rows = np.flatnonzero(~way.even[block])
    axis[rows] = arc_axis(way, block[rows], share[rows])
    return axis
