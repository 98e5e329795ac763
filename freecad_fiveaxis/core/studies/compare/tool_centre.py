# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the axes do where the controller guides the tip itself (tool-centre control: RTCP, TCPM, TRAORI,
G43.4).

guided    the words of a block are the tip's place over the part and the two rotary words. The tip goes
          straight and evenly, the rotary words go evenly, and the linear axes do whatever keeps the tip
          there: they speed up and slow down within a block.
peak      the largest ``|dq/du|`` of an axis in a block, mm or rad: over the block's time, its peak rate.

The tip cannot leave its chord, so the deviation is none; the price is rates, which the peaks show. A
controller that guides the tip slows it down where an axis would exceed its maximum rate: so the time of a
block here.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bytes, Floats, Ints, freeze
from freecad_fiveaxis.core.machine.kinematics import Chain, joint_words
from freecad_fiveaxis.core.motion.program.feeds import feed_minutes, rapid_minutes
from freecad_fiveaxis.core.toolpath.cl_path import Motion

TURN_PER_PIECE = 0.05
"""Rotary travel (rad) of a piece, on which the words are taken as parabolas: their slope is then within a
thousandth."""
STILL = 1e-9
"""mm or rad a unit of u: an axis that turns out to move by less stands still. Rounding alone, over the time
that it would take, reads as an axis at its limit."""
MOST_PIECES = 40_000
"""Pieces worked on at a time."""


@dataclass(frozen=True, eq=False)
class Guided:
    """One row a block, row 0 all zero: ``peak`` (m, 5) mm and rad a unit of u, ``seconds`` (m,) of the
    block."""

    peak: Floats
    seconds: Floats

    def __post_init__(self) -> None:
        freeze(self, None, peak="f5", seconds="f")

    def rates(self, rows: Ints) -> Floats:
        """Return the largest rate (5,) of each axis in the blocks ``rows``: mm/min and rad/min."""
        minutes = self.seconds[rows, None] / 60.0
        rate = np.divide(self.peak[rows], minutes, out=np.zeros((len(rows), 5)), where=minutes > 0.0)
        return np.asarray(rate.max(axis=0, initial=0.0))


def guide(kinematics: Chain, tip: Floats, angles: Floats, motion: Bytes, feed: Floats) -> Guided:
    """Peaks and times of the blocks between rows of ``tip`` (m, 3) mm, work frame, and ``angles`` (m, 2) rad.

    ``motion`` (m,) and ``feed`` (m,) mm/min of the tip as in the CL path. Rates that the machine does not
    state are no limit of feed blocks; rapids and turns on the spot take those that ``program.feeds`` assumes.
    """
    peak = np.zeros((len(tip), 5))
    turn = np.abs(np.diff(angles, axis=0)).sum(axis=1)
    pieces = 2 ** np.ceil(np.log2(np.maximum(turn / TURN_PER_PIECE, 1.0))).astype(np.int64)
    for count in np.unique(pieces).tolist():
        alike, portion = np.flatnonzero(pieces == count) + 1, max(1, MOST_PIECES // count)
        for first in range(0, len(alike), portion):
            rows = alike[first : first + portion]
            peak[rows] = _peaks(kinematics, tip, angles, rows, count)
    peak[peak < STILL] = 0.0
    return Guided(peak, _seconds(kinematics, tip, motion, feed, peak))


def _peaks(kinematics: Chain, tip: Floats, angles: Floats, rows: Ints, pieces: int) -> Floats:
    """Return the largest slopes (k, 5) of the words in each block, from parabolas through three points of
    each piece."""
    u = np.linspace(0.0, 1.0, 2 * pieces + 1)[None, :, None]
    place, turned = ((1.0 - u) * table[rows - 1, None] + u * table[rows, None] for table in (tip, angles))
    q = joint_words(kinematics, place.reshape(-1, 3), turned.reshape(-1, 2)).reshape(len(rows), -1, 5)
    start, middle, end = q[:, :-2:2], q[:, 1::2], q[:, 2::2]
    slopes = (-3.0 * start + 4.0 * middle - end, end - start, start - 4.0 * middle + 3.0 * end)
    return np.asarray(pieces * np.max([np.abs(slope).max(axis=1) for slope in slopes], axis=0))


def _seconds(kinematics: Chain, tip: Floats, motion: Bytes, feed: Floats, peak: Floats) -> Floats:
    seconds = np.zeros(len(tip))
    rapid = np.flatnonzero(motion[1:] == Motion.RAPID) + 1
    feeding = np.flatnonzero(motion[1:] != Motion.RAPID) + 1
    chord = np.linalg.norm(tip[feeding] - tip[feeding - 1], axis=1)
    seconds[rapid] = 60.0 * rapid_minutes(kinematics, peak[rapid])
    seconds[feeding] = 60.0 * feed_minutes(kinematics, peak[feeding], chord, feed[feeding])[0]
    return seconds
