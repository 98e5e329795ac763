# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where passes that follow one another begin, and which way round closed ones run, so that a rotary axis with
limits seldom has to turn back from one to the next.

way       one manner to cut a pass: where it begins, which way round, on which branch of the machine. An open
          pass has one on each branch, a closed one many.
chain     one way of each pass in the order in which they are cut, and the whole turns that its words lie on.
          The best one is a shortest path over layers, as it is in motion/joint_path/branches.py, with passes
          for rows.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

TURN = 2.0 * math.pi
REWIND = 150.0
"""Cost, mm, of turning back: the way at feed that takes as long as to retract, turn and re-engage."""
TURNING = 5.0
"""Cost, mm, of turning the axis by a radian: so far a usual feed goes in the time."""
SLACK = 1e-9
"""Rounding, rad, allowed to a word at its limit."""
FARTHEST = 4.0 * math.pi
"""Words, rad, no farther from zero are looked at: limits that wide hold the rings of any part to and fro."""


class Ways(NamedTuple):
    """The ways (c,) to cut one pass: ``words`` (c, 4), rad, the first, the last, the least and the most of
    them; ``ends`` (c, 2, 3), mm, where it begins and ends; ``branch`` (c,); ``worse`` (c,), mm, what else
    speaks against each."""

    words: Floats
    ends: Floats
    branch: Ints
    worse: Floats


def choose_ways(passes: Sequence[Ways], free: Bools, low: float, high: float) -> Ints:
    """Return the way (p,) of each pass that makes the best chain within the limits ``low`` and ``high``, rad.
    ``free`` (p,): a rapid above the part leads there, on which the axis may turn as it likes."""
    low, high = max(low, -FARTHEST), min(high, FARTHEST)
    layers = [_wind(ways, low, high) for ways in passes]
    cost, origin = layers[0][0].worse, []
    for (before, _), (after, _), jump in zip(layers, layers[1:], free[1:].tolist(), strict=False):
        total = cost[:, None] + _cost_between(before, after, jump)
        origin.append(total.argmin(axis=0))
        cost = total.min(axis=0) + after.worse
    state = [int(cost.argmin())]
    for back in reversed(origin):
        state.append(int(back[state[-1]]))
    return np.array([of[one] for (_, of), one in zip(layers, reversed(state), strict=True)])


def _wind(ways: Ways, low: float, high: float) -> tuple[Ways, Ints]:
    """Return the ways on each of the whole turns on which they fit within the limits, and which way each is.
    Where none fits, the axis turns back inside the pass, and only where it begins and ends counts."""
    least, most = np.ceil((low - SLACK - ways.words[:, 2]) / TURN), np.floor(
        (high + SLACK - ways.words[:, 3]) / TURN
    )  # fmt: skip
    count = np.maximum(most - least + 1.0, 0.0).astype(np.int64)
    if not count.any():
        return _wind_end(ways, low, high), np.arange(len(count))
    way = np.repeat(np.arange(len(count)), count)
    turn = least[way] + np.arange(len(way)) - np.repeat(np.cumsum(count) - count, count)
    words = ways.words[way] + TURN * turn[:, None]
    return Ways(words, ways.ends[way], ways.branch[way], ways.worse[way]), way


def _wind_end(ways: Ways, low: float, high: float) -> Ways:
    """Return the ways with each end on the turn nearest to the middle of the limits."""
    middle = 0.5 * (low + high)
    return ways._replace(words=ways.words - TURN * np.rint((ways.words - middle) / TURN))


def _cost_between(before: Ways, after: Ways, jump: bool) -> Floats:
    """Return the cost (c, d), mm, from each way of one pass to each of the next."""
    turn = np.abs(after.words[None, :, 0] - before.words[:, None, 1])
    air = np.linalg.norm(after.ends[None, :, 0] - before.ends[:, None, 1], axis=2)
    back = (turn > math.pi + SLACK) | (after.branch != before.branch[:, None])
    return np.asarray(air + TURNING * turn + REWIND * (back & (not jump)))
