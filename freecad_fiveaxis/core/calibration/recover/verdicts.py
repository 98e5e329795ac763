# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is poor about a recovered machine, and where the machine that was given differs from it, in plain
words."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import (
    Angle,
    Length,
    Number,
    Option,
    Sentence,
    join_sentences,
    measure,
    say,
)
from freecad_fiveaxis.core.machine import Axis

from .layouts import start_layout
from .model import KINDS, Layout
from .parameters import Parameter, parameters, way_name
from .recovery import EQUAL, Recovery

NAMED = 5
"""So many lines of rows left out are named."""
LEAST_LEAN = 0.01
"""deg; tool axes nearer than that are good."""
UNSURE = 5.0
"""deg, and 100 mm: zeros less certain than this are as good as not determined."""


def recovery_findings(found: Recovery, tolerance: float) -> tuple[Finding, ...]:
    """All of them. ``tolerance`` mm: offsets that are that certain, and that near to the given ones, are
    good."""
    fits = parameters(found)
    return (
        *_layouts(found),
        *_residuals(found, tolerance),
        *_certainties(found, fits, tolerance),
        *_zeros(fits),
        *_signs(found),
        *_mismatches(found, fits, tolerance),
        *_report_assumptions(found),
    )


def describe(layout: Layout) -> Sentence:
    """Return a layout in one phrase."""
    one, two = layout.letters[0], layout.letters[1]
    return say(
        "{kind}, {one} nearer to the work turning about {way}, {two} about {other_way}",
        kind=layout.kind,
        one=one,
        way=way_name(np.array(layout.direction1)),
        two=two,
        other_way=way_name(np.array(layout.direction2)),
    )


def _layouts(found: Recovery) -> Iterator[Finding]:
    if found.others:
        more = join_sentences((describe(fit.layout) for fit in found.others[:3]), "; ")
        text = say(
            "{count} other layouts explain the rows as well: {more}. The plainest is written; give more "
            "rows, with larger turns of both rotary axes, or the machine with {machine}.",
            count=len(found.others),
            more=more,
            machine=Option("machine"),
        )
        yield report_finding(Code.LAYOUT_NOT_DETERMINED, text, float(len(found.others)), 0.0)


def _residuals(found: Recovery, tolerance: float) -> Iterator[Finding]:
    fit, pairs = found.fit, found.pairs
    wrong = np.flatnonzero(~fit.good)
    if len(wrong):
        lines = ", ".join(str(line) for line in pairs.line[wrong[:NAMED]].tolist()) + (
            ", ..." if len(wrong) > NAMED else ""
        )
        text = say(
            "{count} of {all} rows do not fit and are left out (NC lines {lines}); their tips would be off "
            "by up to {miss}. Look at them: they are wrong in the CL path or in the program.",
            count=len(wrong),
            all=len(fit.good),
            lines=lines,
            miss=Length(float(fit.miss[wrong].max()), ".4g"),
        )
        yield report_finding(Code.ROWS_LEFT_OUT, text, float(len(wrong)), 0.0, line=int(pairs.line[wrong[0]]))
    worst = float(fit.miss[fit.good].max(initial=0.0))
    lean = math.degrees(float(fit.lean[fit.good].max(initial=0.0)))
    if fit.scale > EQUAL and (worst > tolerance or lean > LEAST_LEAN):
        text = say(
            "The rows are off by up to {worst} and {lean} from the best machine, {scale} times what "
            "rounding explains. The program may come from another CL path, or its machine have directions "
            "or axes that are not tried here.",
            worst=Length(worst, ".4g"),
            lean=Angle(lean, ".3g"),
            scale=Number(fit.scale, ".3g"),
        )
        yield report_finding(Code.POOR_FIT, text, worst, tolerance)
    if found.skipped:
        text = say(
            "{skipped} blocks have no row of the CL path (moves of the post's own); they are passed over.",
            skipped=found.skipped,
        )
        yield report_finding(Code.BLOCKS_WITHOUT_ROW, text, float(found.skipped))


def _certainties(found: Recovery, fits: tuple[Parameter, ...], tolerance: float) -> Iterator[Finding]:
    for one in fits:
        if not one.fitted:
            continue
        kept = say("as in the machine given") if one.given is not None else say("as 0")
        if not one.determined:
            text = say(
                "The rows do not determine {name}; it is written {kept}. Give rows in which the rotary axes "
                "turn farther.",
                name=one.name,
                kept=kept,
            )
            yield report_finding(Code.NOT_DETERMINED, text)
        elif one.unit == "mm" and one.certainty > tolerance:
            text = say(
                "{name} = {value} is certain within {certainty} only; give rows with larger turns.",
                name=one.name,
                value=Length(one.value, ".4f"),
                certainty=Length(one.certainty, ".2g"),
            )
            yield report_finding(Code.UNCERTAIN, text, one.certainty, tolerance)


def _zeros(fits: tuple[Parameter, ...]) -> Iterator[Finding]:
    linear = [one for one in fits[4:] if one.unit == "mm" and _elsewhere(one)]
    if len(linear) > 1:
        yield _report_shifted_zeros(linear)
    for one in fits[4:]:
        if one in linear and len(linear) > 1:
            continue
        if _elsewhere(one):
            what = say("the work offset") if one.unit == "mm" else say("the axis' zero in the controller")
            what += (
                " or the tool's point that is driven (tip, centre, gauge point)"
                if one.name == "Z zero"
                else ""
            )
            text = say(
                "The program counts {name} from {value} (within {certainty}), not from the CL path's zero. A "
                "machine file cannot hold that: correct {what}, or the post.",
                name=one.name[0],
                value=measure(one.value, one.unit, ".4f"),
                certainty=measure(one.certainty, one.unit, ".2g", bare=True),
                what=what,
            )
            severity = Severity.WARNING if one.unit == "mm" else Severity.ERROR
            yield report_finding(Code.ZERO_ELSEWHERE, text, one.value, 0.0, unit=one.unit, severity=severity)
    assumed = [
        one.name[0]
        for one in fits[4:]
        if not one.fitted and not one.certainty_free < (100.0 if one.unit == "mm" else UNSURE)
    ]
    if assumed:
        text = say(
            "The zeros of {assumed} are taken as right: these rows could not tell them apart from the "
            "offsets. Give rows with larger turns to have them proven too.",
            assumed=", ".join(assumed),
        )
        yield report_finding(Code.ZEROS_ASSUMED, text)


def _elsewhere(one: Parameter) -> bool:
    """Whether a zero lies elsewhere than the CL path's, beyond its certainty."""
    return (
        one.fitted
        and one.determined
        and abs(one.value) > max(one.certainty, 1e-3 if one.unit == "mm" else 1e-4)
    )


def _report_shifted_zeros(zeros: list[Parameter]) -> Finding:
    """Zeros of several linear axes that lie elsewhere are one thing: the work zero."""
    shift = float(np.linalg.norm([one.value for one in zeros]))
    text = say(
        "The work zero is shifted: the program counts {axes} from {values} (within {certainty}), not from "
        "the CL path's zero. A machine file cannot hold that: correct the work offset, or the post.",
        axes=", ".join(one.name[0] for one in zeros),
        values=", ".join(f"{one.value:.4f}" for one in zeros),
        certainty=Length(max(one.certainty for one in zeros), ".2g"),
    )
    return report_finding(Code.ZERO_ELSEWHERE, text, shift, 0.0, unit="mm")


def _signs(found: Recovery) -> Iterator[Finding]:
    for axis in found.machine.rotary:
        if float(np.sum(axis.direction)) < 0.0:
            text = say(
                "Positive {letter} words turn the tool, seen from the work, left-handed about {plus}, "
                "against ISO 841; the direction in the file is reversed accordingly.",
                letter=axis.letter,
                plus=_plus(axis),
            )
            yield report_finding(Code.TURNS_AGAINST_ISO, text)


def _plus(axis: Axis) -> str:
    return way_name(-np.array(axis.direction))


def _mismatches(found: Recovery, fits: tuple[Parameter, ...], tolerance: float) -> Iterator[Finding]:
    start = found.start
    if start is None:
        return
    own, layout = start_layout(start), found.fit.layout
    code, effect = Code.POST_AND_MACHINE_DIFFER, _effect(found)
    if own.slot != layout.slot:
        kinds = {"kind": layout.kind, "name": start.name, "own": KINDS.get(own.slot, own.kind)}
        yield report_finding(
            code, say("The machine that the post had in mind is {kind}, {name} is {own}.", **kinds) + effect
        )
    if set(own.letters) != set(layout.letters):
        text = say(
            "The program has rotary words {letters}, {name} has {own}.",
            letters=" and ".join(layout.letters),
            name=start.name,
            own=" and ".join(own.letters),
        )
        yield report_finding(code, text)
    elif own.letters != layout.letters:
        text = say(
            "For the post {letter} is the rotary axis nearer to the work, for {name} it is {own}.",
            letter=layout.letters[0],
            name=start.name,
            own=own.letters[0],
        )
        yield report_finding(code, text + effect)
    directions = dict(zip(layout.letters, (layout.direction1, layout.direction2), strict=True))
    for axis in start.rotary:
        if axis.letter in directions:
            yield from _direction_mismatch(axis, np.array(directions[axis.letter]), start.name, effect)
    for one in fits:
        limit = max(one.certainty, tolerance)
        if one.determined and one.given is not None and one.apart > limit:
            text = say(
                "{name}: the post has {value} (within {certainty}), {machine} has {given}, {apart} "
                "apart.{effect}",
                name=one.name,
                value=Length(round(one.value, 4) + 0.0, ".4f"),
                certainty=Length(one.certainty, ".2g", bare=True),
                machine=start.name,
                given=Length(one.given, ".4f"),
                apart=Length(one.apart, ".4f"),
                effect=effect,
            )
            yield report_finding(code, text, one.apart, limit, unit="mm")


def _direction_mismatch(axis: Axis, direction: Floats, name: str, effect: str) -> Iterator[Finding]:
    own, code = np.array(axis.direction), Code.POST_AND_MACHINE_DIFFER
    angle = math.degrees(math.acos(float(np.clip(own @ direction, -1.0, 1.0))))
    if angle > 179.9:
        text = say(
            "{letter} turns the other way: the post's positive {letter} is the negative one of "
            "{name}.{effect}",
            letter=axis.letter,
            name=name,
            effect=effect,
        )
        yield report_finding(code, text, 180.0, 0.0, unit="deg")
    elif angle > 1e-4:
        yield report_finding(
            code,
            say(
                "{letter} is another axis: the post turns it about {way}, {name} about {own}.",
                letter=axis.letter,
                way=way_name(direction),
                name=name,
                own=way_name(own),
            )
            + effect,
            angle,
            0.0,
            unit="deg",
        )


def _effect(found: Recovery) -> str:
    if not math.isfinite(found.start_miss):
        return ""
    miss = Length(found.start_miss, ".4g")
    return say(" All differences together put the tip off by up to {miss} on that machine.", miss=miss)


def _report_assumptions(found: Recovery) -> Iterator[Finding]:
    known = () if found.start is None else tuple(axis.letter for axis in found.start.axes)
    if unknown := [axis.letter for axis in found.machine.axes if axis.letter not in known]:
        of = say(" of {axes}", axes=", ".join(unknown)) if known else ""
        text = say(
            "Limits{of} are left open and maximum rates are assumed (10 m/min, 10 turns a minute): no row "
            "tells them. Correct them from the machine's data sheet.",
            of=of,
        )
        yield report_finding(Code.LIMITS_UNKNOWN, text)
    if any(axis.side == "head" for axis in found.machine.rotary) and not found.setup.tool_length:
        text = say(
            "A head's pivot was found as its distance from the tip, tool included. Give {tool_length} to "
            "have the gauge point's written; else use the file with tool length 0.",
            tool_length=Option("tool_length"),
        )
        yield report_finding(Code.TOOL_LENGTH_INCLUDED, text)
