# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a machine really drives an offset path with given tool axes: the same linking and branch choice as the
program's.

polyline   the unit that is driven without lifting the tool. Figures are given for each.
rate       turn of a word over the length that is cut meanwhile, rad/mm; a step shorter than SHORT counts as
           that long.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, freeze
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.joint_path import solve
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.cl_path import LinkOptions, link_passes
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

SHORT = 1e-6
"""mm; a step below this is rounding of a contact point, and says nothing about a rate."""
STANDING = LinkOptions(clearance=5.0, control_point="centre")
"""Rapids well above the path: between polylines the rotary axes may turn, whatever the job's own
clearance."""
BALL = Cutter(2.0)
"""Only sizes the rapids: the centre is driven, and it lies where the path says."""


@dataclass(frozen=True, eq=False)
class Figures:
    """One row a polyline: ``peak`` largest rate of the first rotary word, rad/mm; ``first`` and ``travel``
    rad: how far the first word, and both words, turn while the tool is on the part."""

    peak: Floats
    first: Floats
    travel: Floats

    def __post_init__(self) -> None:
        freeze(self, None, peak="f", first="f", travel="f")

    def better(self, other: Figures) -> Bools:
        """Where (p,) these are better than the others: the first word's peak is lower, its travel is no
        longer, and leading costs the second word no more than a little."""
        lower = self.peak < (1.0 - GAIN) * other.peak
        return np.asarray(
            lower
            & (self.first <= other.first + ROUNDING)
            & (self.travel <= (1.0 + COST) * other.travel + ROUNDING)
        )

    def worse(self, other: Figures) -> Bools:
        """Where (p,) any of these is larger than the other's."""
        higher = self.peak > (1.0 + ROUNDING) * other.peak + ROUNDING
        return np.asarray(
            higher | (self.first > other.first + ROUNDING) | (self.travel > other.travel + ROUNDING)
        )


GAIN = 0.05
"""Share by which the peak must fall, or leading a pass is not worth its change."""
COST = 0.01
"""Share by which the turns of both words together may grow: an axis led around the pole keeps further off it,
which the second word has to follow."""
ROUNDING = 1e-6
"""rad, rad/mm, and share: figures that differ by less are the same; solving anew rounds anew."""


def drive(offset: OffsetPath, axis: Floats, kinematics: Chain, progress: Progress = silent) -> Floats:
    """Return the rotary words (n, 2) rad, turns not folded, of an offset path with tool axes (n, 3). Raises
    ReachError where the machine cannot take up an axis."""
    low, high = offset.centre.min(axis=0), offset.centre.max(axis=0)
    path = link_passes(offset, axis, BALL, low, high, STANDING)
    joints = solve(path, kinematics, low, high, STANDING.clearance, 0.0, progress)
    last = np.flatnonzero(
        np.diff(joints.row, append=len(path.tip))
    )  # the rows before it with the same number were inserted
    return np.asarray(joints.q[last[path.pass_ >= 0], 3:])


def starts(polyline: Ints) -> Ints:
    """Rows at which the polylines begin."""
    return np.flatnonzero(np.diff(polyline, prepend=polyline[:1] - 1))


def figures(offset: OffsetPath, words: Floats) -> Figures:
    """Return the figures of every polyline, driven with rotary ``words`` (n, 2) rad."""
    begin = starts(offset.polyline)
    turn = np.abs(np.diff(words, axis=0, prepend=words[:1]))
    length = np.linalg.norm(np.diff(offset.centre, axis=0, prepend=offset.centre[:1]), axis=1)
    turn[begin] = 0.0
    rate = turn[:, 0] / np.maximum(np.where(offset.fill, 0.0, length), SHORT)
    return Figures(
        *(
            np.maximum.reduceat(rate, begin),
            *(np.add.reduceat(part, begin) for part in (turn[:, 0], turn.sum(1))),
        )
    )
