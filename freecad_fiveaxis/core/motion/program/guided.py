# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an NC program says in blocks in which the controller guides the tip itself (RTCP, TCPC, TCPM, TRAORI,
G43.4).

guided    the linear words of a block are the tip's place in the work; the tool axis is given by the rotary
          words, or by its vector. Where the axes stand follows from the machine; how they get there is the
          controller's affair.
proven    of a guided block: that its end, as rounded, puts tip and axis where the CL path wants them
          (``rounding_finding``), and where the axes then stand. Not what happens between the ends.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.columns import cache_chunks
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, freeze
from freecad_fiveaxis.core.base.sentences import Angle, Length, say
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, inverse_axis, joint_words, words_to_q

TURN = 2.0 * math.pi
AT_POLE = 1e-6
"""Singularity measure below which the first rotary word of a vector means nothing: it is rounding."""


@dataclass(frozen=True, eq=False)
class Guided:
    """One row a block: ``on`` (m,) True where the controller guides the tip; ``tip`` (m, 3) mm: the linear
    words as they stand in the NC file there; ``vector`` (m, 3) the tool axis as it stands there, None where
    the rotary words give it in all blocks."""

    on: Bools
    tip: Floats
    vector: Floats | None = None

    def __post_init__(self) -> None:
        freeze(self, None, on="b", tip="f3")
        if self.vector is not None:
            freeze(self, len(self.on), vector="f3")


def standing(kinematics: Chain, tip: Floats, angles: Floats) -> Floats:
    """Words (m, 5) mm and degrees of the axes for tips (m, 3) mm and rotary words (m, 2) **degrees**, which
    are kept as given."""
    words = np.empty((5, len(tip))).T
    words[:, :3] = joint_words(kinematics, tip, np.radians(angles))[:, :3]
    words[:, 3:] = angles
    return words


def take_up_axes(kinematics: Chain, vector: Floats, near: Floats) -> Floats:
    """Rotary words (m, 2) degrees that take up tool axes ``vector`` (m, 3), of the branch and winding nearest
    to ``near`` (m, 2) degrees; at the pole the first one is that of ``near``. NaN where the machine cannot
    take up the axis."""
    unit = vector / np.linalg.norm(vector, axis=1)[:, None]
    wanted, best, least = np.radians(near), np.full((len(vector), 2), np.nan), np.full(len(vector), np.inf)
    branches, sine = inverse_axis(kinematics, unit)
    for angles in branches:
        free = sine < AT_POLE
        angles[free, 0] = wanted[free, 0]
        angles += TURN * np.rint((wanted - angles) / TURN)
        off = np.abs(angles - wanted).sum(axis=1)
        rows = off < least
        best[rows], least[rows] = angles[rows], off[rows]
    return np.asarray(np.degrees(best))


def rounding_finding(kinematics: Chain, words: Floats, tip: Floats, axis: Floats) -> Finding:
    """How far the blocks' ends are from the CL path's ``tip`` (m, 3) mm and ``axis`` (m, 3): all that is
    proven."""
    off, lean = 0.0, 0.0
    for rows in cache_chunks(len(words)):
        place, stands = forward(kinematics, words_to_q(words[rows]))
        off = max(off, float(np.linalg.norm(place - tip[rows], axis=1).max(initial=0.0)))
        chord = np.linalg.norm(stands - axis[rows], axis=1).max(initial=0.0)
        lean = max(lean, 2.0 * math.asin(min(float(chord) / 2.0, 1.0)))
    text = say(
        "The controller guides the tip (RTCP). Proven is that every block ends within {off} of the path's tip"
        " and {lean} of its tool axis, as the machine file describes the machine; how tip and axes go from "
        "end to end is the controller's affair, and not proven here.",
        off=Length(off, ".2g"),
        lean=Angle(math.degrees(lean), ".2g"),
    )
    return report_finding(Code.TIP_GUIDED_BY_CONTROLLER, text, off, unit="mm")
