# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that lead beyond the machine's limits.

limits   of the words, as the chain has them: the machine file's limits of the joints, less what the work zero
         (``--origin``), the tool's length and the gauge point shift them by.
excess   how far a word lies beyond its limit, mm or **degrees**; both ends of a block stand for all of it,
         because every axis moves evenly between them (where the controller guides the tip, only its ends are
         judged).
modulo   a rotary word that the control takes by the shorter way may stand any number of turns off: the turn
         that suits the limits best counts. Other rotary words count as they are, turns and all.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bytes, Floats, freeze
from freecad_fiveaxis.core.base.sentences import Number, Option, Task, measure, plural, say
from freecad_fiveaxis.core.machine.kinematics import Chain, forward_tip, words_to_q
from freecad_fiveaxis.core.motion.program import Program

from .rates import DEGREES

SLACK = 5.01e-4
"""mm, deg: half the coarsest step that a dialect writes. A word at the limit may be rounded beyond it by so
much."""
CIRCLE = 360.0


@dataclass(frozen=True, eq=False)
class Limits:
    """One row a block: ``excess`` (m,) mm or **degrees** beyond a limit, the largest of all words, 0 within
    them; ``axis`` (m,) the word that it is of."""

    excess: Floats
    axis: Bytes
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, None, excess="f", axis="m")


def check_limits(kinematics: Chain, program: Program) -> Limits:
    """Return the excess of every block, rapids and the first position too, and an error for each limit that
    is exceeded."""
    count = len(program.words)
    excess, axis, found = np.zeros(count), np.zeros(count, np.int8), []
    for k in range(5):
        word = _nearest_turn(kinematics, program, k)
        for sign, limits in ((-1.0, kinematics.low), (1.0, kinematics.high)):
            limit = float(limits[k] * DEGREES[k])
            beyond = sign * (word - limit)
            rows = np.flatnonzero(beyond > SLACK)
            if len(rows):
                found.append(_finding(kinematics, program, k, limit, beyond, word))
                larger = rows[beyond[rows] > excess[rows]]
                excess[larger], axis[larger] = beyond[larger], k
    return Limits(excess, axis, tuple(found))


def _nearest_turn(kinematics: Chain, program: Program, k: int) -> Floats:
    """Return the words (m,) of one axis, mm or degrees; modulo ones by the turn nearest to the middle of the
    limits."""
    word: Floats = program.words[:, k]
    low, high = float(kinematics.low[k]), float(kinematics.high[k])
    if k < 3 or program.wrap[k - 3] != "modulo" or not np.isfinite([low, high]).all():
        return word
    middle = (low + high) * float(DEGREES[k]) / 2.0
    return np.asarray(word - CIRCLE * np.rint((word - middle) / CIRCLE))


def _finding(
    kinematics: Chain, program: Program, k: int, limit: float, beyond: Floats, word: Floats
) -> Finding:
    rows = np.flatnonzero(beyond > SLACK)
    worst, letter, unit = int(beyond.argmax()), program.letters[k], "mm" if k < 3 else "deg"
    blocks = plural(len(rows), "1 block leads", "{count} blocks lead")
    help_ = (
        say(
            "Words count from the work zero: is {origin} where it stood on the machine? Else move it "
            "({setup} finds a place)",
            origin=Option("origin"),
            setup=Task("setup"),
        )
        if k < 3
        else say("Post it again for this machine")
    )
    text = say(
        "{blocks} {letter} beyond its limit of {limit}: farthest NC line {line}, {letter}{word}, "
        "{beyond} too far; first NC line {first}. {help}, or take a machine with more travel.",
        blocks=blocks,
        letter=letter,
        limit=measure(limit, unit, ".4f"),
        line=program.line[worst],
        word=Number(word[worst], ".4f"),
        beyond=measure(beyond[worst], unit, ".4f"),
        first=program.line[rows[0]],
        help=help_,
    )
    x, y, z = forward_tip(kinematics, words_to_q(program.words[worst : worst + 1]))[0].tolist()
    value, line = float(word[worst]), int(program.line[worst])
    return report_finding(Code.LIMIT, text, value, limit, worst, line, (x, y, z), unit=unit)
