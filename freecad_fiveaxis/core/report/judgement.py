# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the figures of the feed blocks mean for the part, in plain words.

Each kind of trouble gives one finding for all blocks together, with the worst block's value and place, and,
where there are several blocks, one for each of the worst.

deviation-over-tolerance   ERROR: the tip leaves the commanded segment by more than the tolerance.
bound-over-tolerance       WARNING: it was not seen to, but the proven bound does not exclude it.
singular-block             WARNING: near the pole, where the first rotary axis turns far to move the tool a
                           little. NOTE where every such block holds the tolerance by proof, and no rotary
                           axis is slowed by its rate.
turns-at-pole              NOTE: the tool stands at the pole all along, and nothing shows of the turn
                           (:mod:`.turns_at_pole`); these blocks are in no singular-block.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import (
    Angle,
    Choice,
    Length,
    Option,
    Sentence,
    join_sentences,
    plural,
    say,
)
from freecad_fiveaxis.core.machine.kinematics import Chain, forward
from freecad_fiveaxis.core.motion.deviation import Deviation
from freecad_fiveaxis.core.motion.program import Program, feed_blocks
from freecad_fiveaxis.core.motion.singularity import Singularity

from .figures import WORST, axis_rates, inner_words, travel, worst_first
from .turns_at_pole import UPRIGHT, find_turns_at_pole, measure_kept

ROUND_UP = 1.0 + 1e-4
"""A bound must not become less by being told with five digits."""
UNHURRIED = 0.95
"""Share of its maximum rate up to which a rotary axis follows the feed: one that is held back runs at all of
it."""

_SPLIT = say(
    "Shorter blocks help: half the length leaves about a quarter of the deviation; {linearize} makes as many "
    "as are needed.",
    linearize=Choice("linearize", ("on",)),
)
_AWAY = say(
    "Let the tool axis be turned past the pole ({past}; where that is on, with a larger {change}), lean the "
    "tool by a few degrees ({lead}, {tilt}), or clamp the part tilted, so that the tool keeps off the pole.",
    past=Choice("singularity", ("deform",), alone=True),
    change=Option("max_axis_change", flag=False),
    lead=Option("lead", flag=False),
    tilt=Option("tilt", flag=False),
)
_TIP_BENDS = say(
    "While rotary axes turn, straight moves of the axes carry the tip along a curve beside the straight "
    "segment."
)
_BALL_BENDS = say(
    "While rotary axes turn, straight moves of the axes carry the ball's centre along a curve beside its "
    "straight segment, and the surface with it."
)
_GUIDE = say("A controller with tool tip control (RTCP) guides the tip along the segment itself.")


def judge(
    kinematics: Chain,
    program: Program,
    deviation: Deviation,
    singularity: Singularity,
    tolerance: float,
    surface: bool = False,
    programmed: Floats | None = None,
) -> tuple[Finding, ...]:
    """Return the findings of all feed blocks; ``tolerance`` mm. All records have one row a block.
    ``surface``: the deviation is that of a ball's centre, which makes the surface, not of the tip;
    ``programmed`` (m,) mm/min: how fast the tip was to go over the part, None: that is not known."""
    feeds = feed_blocks(program)
    over = ~(deviation.segment[feeds] <= tolerance)  # so a NaN counts as over
    unproven = ~over & ~(deviation.bound[feeds] <= tolerance)
    upright = find_turns_at_pole(kinematics, program, deviation, singularity, tolerance, programmed)
    near = singularity.singular & ~upright
    return (
        *_over_tolerance(kinematics, program, deviation, singularity, tolerance, feeds[over], surface),
        *_unproven(program, deviation, tolerance, feeds[unproven]),
        *_near_pole(kinematics, program, deviation, singularity, feeds[near[feeds]], tolerance),
        *_turns_at_pole(kinematics, program, deviation, np.flatnonzero(upright), programmed),
    )


@dataclass(frozen=True)
class _Kind:
    """One kind of trouble: ``values`` (m,) in ``unit``, the worst being the largest."""

    code: Code
    values: Floats
    limit: float | None
    severity: Severity | None = None


def _findings(
    kind: _Kind,
    program: Program,
    deviation: Deviation,
    rows: Ints,
    whole: Callable[[int], Sentence],
    single: Callable[[int], Sentence],
) -> list[Finding]:
    """Return the worst of ``rows`` first: ``whole`` tells of all, ``single`` of one."""
    rows = worst_first(rows, kind.values)
    spots = [(int(row), whole(int(row))) for row in rows[:1]]
    spots += [(int(row), single(int(row))) for row in rows[:WORST] if len(rows) > 1]
    return [_finding(kind, program, deviation, row, text) for row, text in spots]


def _finding(kind: _Kind, program: Program, deviation: Deviation, row: int, text: str) -> Finding:
    x, y, z = deviation.place[row].tolist()
    value, line = float(kind.values[row]), int(program.line[row])
    return report_finding(kind.code, text, value, kind.limit, row, line, (x, y, z), severity=kind.severity)


def _over_tolerance(
    kinematics: Chain, program: Program, deviation: Deviation, singularity: Singularity, tolerance: float,
    rows: Ints,
    surface: bool,
) -> list[Finding]:  # fmt: skip
    near = int(singularity.singular[rows].sum())

    def whole(row: int) -> Sentence:
        lead = say(
            "{blocks} the commanded path by more than {tolerance}; the worst, NC line {line}, by "
            "{deviation}: there {turns} within a step of {step}.",
            blocks=plural(len(rows), "1 feed block leaves", "{count} feed blocks leave"),
            tolerance=Length(tolerance),
            line=program.line[row],
            deviation=Length(deviation.segment[row], ".5g"),
            turns=_turns(program, row),
            step=Length(_chord(kinematics, program, row), ".3f"),
        )
        bends = _BALL_BENDS if surface else _TIP_BENDS
        guide = "" if surface else _GUIDE
        return join_sentences(
            (lead, bends, _near(near, len(rows), program), _SPLIT, _AWAY if near else "", guide)
        )

    def single(row: int) -> Sentence:
        lead = say(
            "NC line {line} leaves the commanded segment by {deviation}, {tolerance} allowed: {turns} within "
            "a step of {step}.",
            line=program.line[row],
            deviation=Length(deviation.segment[row], ".5g"),
            tolerance=Length(tolerance),
            turns=_turns(program, row),
            step=Length(_chord(kinematics, program, row), ".3f"),
        )
        keep = singularity.singular[row]
        return join_sentences(
            (lead, say("Split it, or keep the tool off the pole.") if keep else say("Split it."))
        )

    kind = _Kind(Code.DEVIATION_OVER_TOLERANCE, deviation.segment, tolerance)
    return _findings(kind, program, deviation, rows, whole, single)


def _unproven(program: Program, deviation: Deviation, tolerance: float, rows: Ints) -> list[Finding]:
    def whole(row: int) -> Sentence:
        lead = say(
            "{blocks} so near to the tolerance of {tolerance} that the proof does not reach: the deviation "
            "is within it, its proven upper bound is not (worst, NC line {line}: bound {bound}).",
            blocks=plural(len(rows), "1 feed block is", "{count} feed blocks are"),
            tolerance=Length(tolerance),
            line=program.line[row],
            bound=Length(deviation.bound[row], ".6f"),
        )
        return join_sentences((lead, _SPLIT))

    def single(row: int) -> Sentence:
        return say(
            "NC line {line}: deviation {deviation}, proven bound {bound}, {tolerance} allowed. Split it.",
            line=program.line[row],
            deviation=Length(deviation.segment[row], ".6f"),
            bound=Length(deviation.bound[row], ".6f"),
            tolerance=Length(tolerance),
        )

    kind = _Kind(Code.BOUND_OVER_TOLERANCE, deviation.bound, tolerance)
    return _findings(kind, program, deviation, rows, whole, single)


def _near_pole(
    kinematics: Chain,
    program: Program,
    deviation: Deviation,
    singularity: Singularity,
    rows: Ints,
    tolerance: float,
) -> list[Finding]:
    turned = np.abs(travel(program)[:, 3:]).max(axis=1, initial=0.0)
    if not len(rows):
        return []
    if _is_harmless(kinematics, program, deviation, rows, tolerance):
        return _note_harmless(program, deviation, singularity, turned, rows)

    def whole(row: int) -> Sentence:
        lead = say(
            "{blocks} near the pole (the tool almost along the {letter} axis), where {letter} must turn far "
            "to lean the tool a little. The worst is NC line {line}: {turns}. The axis may be too slow for "
            "the programmed feed, the tool dwells, and marks or a deviation from the path may show.",
            blocks=plural(len(rows), "1 feed block lies", "{count} feed blocks lie"),
            letter=program.letters[3],
            line=program.line[row],
            turns=_turns_to_lean(program, singularity, row),
        )
        return join_sentences((lead, _AWAY))

    def single(row: int) -> Sentence:
        return say(
            "NC line {line}: {turns}. Keep the tool off the pole.",
            line=program.line[row],
            turns=_turns_to_lean(program, singularity, row),
        )

    kind = _Kind(Code.SINGULAR_BLOCK, turned, None)
    return _findings(kind, program, deviation, rows, whole, single)


def _is_harmless(
    kinematics: Chain, program: Program, deviation: Deviation, rows: Ints, tolerance: float
) -> bool:
    """Whether each of the feed blocks ``rows`` is proven to hold ``tolerance`` mm and runs below the rates of
    the rotary axes. Not where the controller guides the tip, for how it turns there is not known, nor where
    the machine states no rate."""
    if program.guided is not None or not np.isfinite(kinematics.rate[3:]).all():
        return False
    rates = axis_rates(program)[rows, 3:]
    within = (deviation.bound[rows] <= tolerance).all() and (program.seconds[rows] > 0.0).all()
    return bool(within and (rates <= UNHURRIED * np.rad2deg(kinematics.rate[3:])).all())


def _note_harmless(
    program: Program, deviation: Deviation, singularity: Singularity, turned: Floats, rows: Ints
) -> list[Finding]:
    """One note about the feed blocks ``rows``, at the one that turns farthest."""
    row = int(worst_first(rows, turned, 1)[0])
    text = say(
        "{blocks} near the pole (the tool almost along the {letter} axis), where {letter} turns more than "
        "the tool leans: most in NC line {line}, where {turns}. Each holds the tolerance by proof, and no "
        "rotary axis comes to its maximum rate there.",
        blocks=plural(len(rows), "1 feed block lies", "{count} feed blocks lie"),
        letter=program.letters[3],
        line=program.line[row],
        turns=_turns_to_lean(program, singularity, row),
    )
    return [_finding(_Kind(Code.SINGULAR_BLOCK, turned, None, Severity.NOTE), program, deviation, row, text)]


def _turns_at_pole(
    kinematics: Chain, program: Program, deviation: Deviation, rows: Ints, programmed: Floats | None
) -> list[Finding]:
    """One note about the blocks ``rows`` in which the tool stands at the pole, at the one that turns
    farthest; its value: how far the first rotary axis turns in all of them."""
    if programmed is None or not len(rows):
        return []
    turned = np.abs(travel(program)[:, 3])
    row, whole = int(worst_first(rows, turned, 1)[0]), float(turned[rows].sum())
    kept = float(measure_kept(kinematics, program, rows, programmed)[0].min())
    text = say(
        "{letter} turns {whole} in all in {blocks} in which the tool stands at the pole, along the {letter} "
        "axis, and does not lean: most in NC line {line}, {turn}. The surface is held: each keeps the "
        "tolerance by proof, and the tool keeps {kept} % of its feed or more. Nothing is to be done.",
        letter=program.letters[3],
        whole=Angle(whole, ".4g"),
        blocks=plural(len(rows), "1 feed block", "{count} feed blocks"),
        line=program.line[row],
        turn=Angle(float(turned[row]), ".4g"),
        kept=math.floor(100.0 * min(kept, 1.0)),
    )
    one = _finding(_Kind(Code.TURNS_AT_POLE, turned, None), program, deviation, row, text)
    return [replace(one, value=whole)]


def _turns_to_lean(program: Program, singularity: Singularity, row: int) -> Sentence:
    """Return what the rotary axes do in a block and what the tool axis does by it, which may be nothing."""
    lean = singularity.axis_travel[row]
    if lean > 2.0 * UPRIGHT:
        angle = Angle(math.degrees(lean), ".3g")
        return say("{turns} to lean the tool by {lean}", turns=_turns(program, row), lean=angle)
    turn = float(np.abs(program.words[row, 3] - program.words[row - 1, 3]))
    return say(
        "{letter} turns {turn} and the tool leans as before",
        letter=program.letters[3],
        turn=Angle(turn, ".4g"),
    )


def _near(near: int, rows: int, program: Program) -> str:
    """How many of ``rows`` blocks lie near the pole, and what that means; nothing where none does."""
    if not near:
        return ""
    lies = plural(near, "{count} of them lies", "{count} of them lie") if rows > 1 else say("It lies")
    return say(
        "{lies} near the pole, where {letter} must turn far to lean the tool a little.",
        lies=lies,
        letter=program.letters[3],
    )


def _turns(program: Program, row: int) -> Sentence:
    """Return what the rotary axes do in a block, as "C turns 27.4 deg and A 0.11 deg"."""
    first, second = np.abs(program.words[row, 3:] - program.words[row - 1, 3:]).tolist()
    return say(
        "{first} turns {turn} and {second} {other_turn}",
        first=program.letters[3],
        turn=Angle(first, ".4g"),
        second=program.letters[4],
        other_turn=Angle(second, ".3g"),
    )


def _chord(kinematics: Chain, program: Program, row: int) -> float:
    start, end = forward(kinematics, inner_words(program.words[row - 1 : row + 1]))[0]
    return math.dist(start, end)
