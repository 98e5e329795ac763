# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the division of blocks says about itself.

linearized            NOTE: how many blocks were divided into how many.
rotary-words-even     NOTE: blocks whose tool axis could not be led along its great arc without losing rotary
                      travel.
linearize-rounding    WARNING: blocks that hold a larger tolerance only, because of the rounding of the words.
linearize-impossible  WARNING: blocks left whole, because no division was found that holds anything near the
                      tolerance.
linearize-limit       ERROR: inserted rows that would drive an axis beyond its limits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, Option, Sentence, measure, say
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, words_to_q
from freecad_fiveaxis.core.motion.short_travel import find_aside, say_remedy_beyond_limit

from .commanded_moves import Steps, most_off

LIMIT_SLACK = 1e-6
"""mm or rad: excess over a limit that is rounding, not travel."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """Blocks that were over tolerance: ``row`` (b,) they end in, ``count`` (b,) of pieces, ``held`` (b,) mm:
    the distance that their pieces are proven to keep (infinite: left whole), ``even`` (b,) where the rotary
    words go evenly."""

    row: Ints
    count: Ints
    held: Floats
    even: Bools


def report_division(
    kinematics: Chain, outcome: Outcome, words: Floats, new: Ints, steps: Steps, tolerance: float
) -> tuple[Finding, ...]:
    """Return the findings of a division: ``words`` (k, 5) of the divided path, mm and degrees, ``new`` its
    inserted rows."""
    rows = _end_rows(outcome)
    divided, even = outcome.count > 1, outcome.even & (outcome.count > 1)
    coarse, whole = np.isfinite(outcome.held) & (outcome.held > tolerance), np.isinf(outcome.held)
    reports = []
    if divided.any():
        text = say(
            "{count} blocks were over {tolerance} and were divided into {pieces}, as few as hold it by "
            "proof.",
            count=divided.sum(),
            tolerance=Length(tolerance),
            pieces=outcome.count[divided].sum(),
        )
        reports.append(report_finding(Code.LINEARIZED, text, float(divided.sum())))
    if even.any():
        text = say(
            "In {count} divided blocks the rotary axes turn evenly, because the straight swing of the tool "
            "axis would need another branch or winding; its axis deviation stays as it was. Lead the tool "
            "round the pole to avoid it.",
            count=even.sum(),
        )
        reports.append(
            _at(kinematics, Code.ROTARY_WORDS_EVEN, text, float(even.sum()), None, "1", words, rows[even])
        )
    if coarse.any():
        value = float(outcome.held[coarse].max())
        worst = rows[coarse][np.argmax(outcome.held[coarse]) :]
        text = say(
            "{count} blocks cannot be held within {tolerance}: words of {linear} and {rotary} decimals put "
            "the tip up to {most_off} off. The worst, which leads to {spot}, is proven to hold {value}. "
            "Allow more, or use a controller with finer words.",
            count=coarse.sum(),
            tolerance=Length(tolerance),
            linear=steps.linear,
            rotary=steps.rotary,
            most_off=Length(most_off(kinematics, steps), ".3g"),
            spot=_spot(kinematics, words[worst[0]]),
            value=Length(value, ".3g"),
        )
        reports.append(_at(kinematics, Code.LINEARIZE_ROUNDING, text, value, tolerance, "mm", words, worst))
    if whole.any():
        text = say(
            "{count} blocks are over {tolerance} and were left whole (the first leads to {spot}): no number "
            "of blocks holds it there, because the linear axes turn into one plane on the way. Turn the "
            "part on the table, or take another machine.",
            count=whole.sum(),
            tolerance=Length(tolerance),
            spot=_spot(kinematics, words[rows[whole][0]]),
        )
        reports.append(
            _at(kinematics, Code.LINEARIZE_IMPOSSIBLE, text, float(whole.sum()), 0.0, "1", words, rows[whole])
        )
    return (*reports, *_beyond_limits(kinematics, words, new))


def _end_rows(outcome: Outcome) -> Ints:
    """Return the rows of the divided path that the blocks end in."""
    return np.asarray(outcome.row + np.cumsum(outcome.count - 1), np.int64)


def _at(
    kinematics: Chain,
    code: Code,
    text: str,
    value: float,
    limit: float | None,
    unit: str | None,
    words: Floats,
    rows: Ints,
) -> Finding:
    """Return a finding at the first of ``rows``."""
    row = int(rows[0])
    return report_finding(code, text, value, limit, row, place=_place(kinematics, words[row]), unit=unit)


def _place(kinematics: Chain, words: Floats) -> tuple[float, float, float]:
    x, y, z = forward(kinematics, words_to_q(words[None]))[0][0].tolist()
    return x, y, z


def _spot(kinematics: Chain, words: Floats) -> Sentence:
    x, y, z = (Length(value, ".3f", bare=True) for value in _place(kinematics, words))
    return say("X{x} Y{y} Z{z}", x=x, y=y, z=z)


def _choose_remedy(kinematics: Chain, words: Floats, k: int) -> Sentence:
    """Return what helps where axis ``k`` leaves its limits."""
    if k < 3:
        low, high = float(kinematics.low[k]), float(kinematics.high[k])
        aside = find_aside(kinematics, forward(kinematics, words_to_q(words))[0])
        return say_remedy_beyond_limit(kinematics.letters[k], words[:, k], low, high, aside)
    return say("move the work zero ({origin}) or take a larger machine.", origin=Option("origin"))


def _beyond_limits(kinematics: Chain, words: Floats, new: Ints) -> list[Finding]:
    """Return an error for each axis that inserted rows drive beyond its limits, at the worst place."""
    reports = []
    q = words_to_q(words[new])
    for k, letter in enumerate(kinematics.letters):
        excess = np.maximum(kinematics.low[k] - q[:, k], q[:, k] - kinematics.high[k])
        worst = int(excess.argmax()) if len(excess) else 0
        if len(excess) and excess[worst] > LIMIT_SLACK:
            row, unit = int(new[worst]), "mm" if k < 3 else "deg"
            limit = float(kinematics.low[k] if q[worst, k] < kinematics.low[k] else kinematics.high[k])
            limit = limit if k < 3 else float(np.degrees(limit))
            text = say(
                "{letter} would have to go to {word} inside a divided block, its limit is {limit} "
                "({count} rows): {remedy}",
                letter=letter,
                word=measure(words[row, k], unit, ".4f"),
                limit=measure(limit, unit, ".4f"),
                count=(excess > LIMIT_SLACK).sum(),
                remedy=_choose_remedy(kinematics, words, k),
            )
            reports.append(
                _at(
                    kinematics,
                    Code.LINEARIZE_LIMIT,
                    text,
                    float(words[row, k]),
                    limit,
                    unit,
                    words,
                    new[worst:],
                )
            )
    return reports
