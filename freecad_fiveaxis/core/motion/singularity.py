# SPDX-License-Identifier: LGPL-2.1-or-later
"""Singular blocks: where the rotary axes turn far to move the tool axis a little.

measure        ``|a1 . (a2 x k)|`` with a1, a2 the rotary axes as they stand and k the tool axis. It depends
               on the second rotary word only, ``H |sin d|`` with d that word counted from its position at the
               pole; on a machine of orthogonal axes it is the sine of the tilt.
singular cone  all poses whose measure is below that of an axis which stands at the cone's half angle from the
               pole.
rotary travel  ``|change of the first rotary word| + |change of the second|`` over the block.
axis travel    the angle between the tool axes at the block's two ends.
singular block a block whose real tool axis comes inside the singular cone while its rotary travel is at least
TRAVEL_RATIO
               times its axis travel and at least LEAST_TRAVEL.

Far from the pole a machine turns about as much as its tool axis does; near it the first rotary axis has to
turn by any amount, and the tip, which only the linear axes hold in place, leaves its line (So et al. 2008,
section 1 and Table 2). Within a block d goes evenly, so the least measure is exact without sampling: 0 where
d passes a multiple of pi, else that of one of the ends.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.columns import cache_chunks, cos_sin
from freecad_fiveaxis.core.base.records import Bools, Floats, freeze
from freecad_fiveaxis.core.machine.kinematics import Chain, RotaryPair

TRAVEL_RATIO = 4.0
"""Rotary travel that counts as large, in axis travels."""
LEAST_TRAVEL = math.radians(1.0)
"""Rotary travel below which no block is singular, rad: on a lever of 200 mm the tip then leaves its chord by
8 micrometres at most, and the ratio of two tiny rounded travels says nothing."""


@dataclass(frozen=True, eq=False)
class Singularity:
    """One row a block of the Program, row 0 (the first position) all zero, as are blocks whose way is not
    known.

    ``least_sine`` (m,) least measure along the block; ``rotary_travel``, ``axis_travel`` (m,) rad;
    ``singular`` (m,).
    """

    least_sine: Floats
    rotary_travel: Floats
    axis_travel: Floats
    singular: Bools

    def __post_init__(self) -> None:
        freeze(self, None, least_sine="f", rotary_travel="f", axis_travel="f", singular="b")

    def without(self, rows: Bools) -> Singularity:
        """Return the same with zero in ``rows`` (m,): of blocks whose way is not known, as of row 0, nothing
        is claimed."""
        columns = (self.least_sine, self.rotary_travel, self.axis_travel)
        least, rotary, axis = (np.where(rows, 0.0, column) for column in columns)
        return Singularity(least, rotary, axis, self.singular & ~rows)


def find_singular(kinematics: Chain, words: Floats, cone: float) -> Singularity:
    """Return the singular blocks among ``words`` (m, 5) mm and **degrees**; ``cone`` half angle of the
    singular cone, rad."""
    pair = RotaryPair.of(kinematics.direction[3], kinematics.direction[4])
    count = len(words)
    least, rotary, axis, singular = np.zeros(count), np.zeros(count), np.zeros(count), np.zeros(count, bool)
    measure = _cone_measure(pair, cone)
    for rows in cache_chunks(max(count - 1, 0)):
        ends = slice(rows.start, rows.stop + 1)
        first, second = np.deg2rad(words[ends, 3]), np.deg2rad(words[ends, 4]) - pair.best
        blocks = slice(rows.start + 1, rows.stop + 1)
        turn1, turn2 = np.diff(first), np.diff(second)
        sine = cos_sin(second)[1]
        least[blocks] = pair.reach * _least_sine(second, np.abs(sine))
        rotary[blocks] = np.abs(turn1) + np.abs(turn2)
        axis[blocks] = _axis_travel(pair, second, sine, turn1, turn2)
        large = (rotary[blocks] >= LEAST_TRAVEL) & (rotary[blocks] >= TRAVEL_RATIO * axis[blocks])
        singular[blocks] = large & (least[blocks] < measure)
    return Singularity(least, rotary, axis, singular)


def in_cone(kinematics: Chain, words: Floats, cone: float) -> Bools:
    """Return the blocks (m,) among ``words`` (m, 5) mm and **degrees** whose real tool axis comes inside the
    singular cone, however far they turn; ``cone`` half angle, rad. Row 0 is no block: False."""
    pair = RotaryPair.of(kinematics.direction[3], kinematics.direction[4])
    inside = find_singular(kinematics, words, cone).least_sine < _cone_measure(pair, cone)
    inside[:1] = False
    return inside


def _cone_measure(pair: RotaryPair, cone: float) -> float:
    """Return the measure at ``cone`` rad from the pole: ``cos(cone) = cos b cos g + H cos d`` (symbols of
    rotary_pair)."""
    cos_d = (math.cos(cone) - (pair.near + 1.0 - pair.reach)) / pair.reach
    if cos_d <= 0.0:
        return math.inf
    return pair.reach * math.sqrt(max(0.0, 1.0 - cos_d * cos_d))


def _least_sine(angle: Floats, sine: Floats) -> Floats:
    """Least |sin| between successive angles (n + 1,), whose |sin| are ``sine``: |sin| is concave between its
    zeros."""
    half_turn = np.floor(angle * (1.0 / math.pi))
    least = np.minimum(sine[1:], sine[:-1])
    least[np.flatnonzero(half_turn[1:] != half_turn[:-1])] = 0.0
    return np.asarray(least)


def _axis_travel(pair: RotaryPair, second: Floats, sine: Floats, turn1: Floats, turn2: Floats) -> Floats:
    """Angle between successive tool axes: from the chord, so that small ones are exact.

    With w the part of ``R2 ez`` across the pole, ``chord^2 = 4 sin^2 b sin^2(turn2 / 2) + 4 sin^2(turn1 / 2)
    w0 . w1
    - 2 sin(turn1) (w0 x w1)``: the chord of the second turn alone, then what the first one adds.
    """
    sin_b = pair.reach / math.sqrt(1.0 - pair.cos_g**2)
    across = -sin_b * sine
    chord2 = 4.0 * sin_b**2 * _half_sine_squared(turn2)
    half1 = _half_sine_squared(turn1)
    if pair.straight:
        chord2 += 4.0 * half1 * across[1:] * across[:-1]
    else:
        lean = _lean(pair, sin_b, second)
        inner = lean[1:] * lean[:-1] + across[1:] * across[:-1]
        outer = across[:-1] * lean[1:] - lean[:-1] * across[1:]
        chord2 += 4.0 * half1 * inner - 2.0 * pair.sign * cos_sin(turn1)[1] * outer
    return np.asarray(2.0 * np.arcsin(0.5 * np.sqrt(np.clip(chord2, 0.0, 4.0))))


def _half_sine_squared(angle: Floats) -> Floats:
    """``sin^2(angle / 2)``, through the tangent as in columns.cos_sin."""
    square = np.tan(0.5 * angle) ** 2
    return np.asarray(square / (1.0 + square))


def _lean(pair: RotaryPair, sin_b: float, second: Floats) -> Floats:
    """Return the n part of ``R2 ez``: ``cos b sin g - sin b cos g cos d = sin(g - b) + 2 sin b cos g sin^2(d
    / 2)``."""
    return np.asarray(2.0 * sin_b * (pair.aside + pair.cos_g * np.sin(0.5 * second) ** 2))
