# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arcs that a CL file says, and what is wrong about them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, plural, say
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .arcs import FIT, Arcs, ArcSpans, ambiguous, arc_spans, chord_counts, inner_ends, misfit, runs_back
from .rows import Put, Rows
from .source import Source
from .statements import Kind, Statements

MOST_ROWS = 20_000_000
"""More chords than this are a slip of the pen in a radius or a tolerance."""


def chords(
    source: Source, statements: Statements, rows: Rows, scale: Floats, sagitta: float, holes: Ints
) -> tuple[Put, tuple[Finding, ...]]:  # fmt: skip
    """Return the rows that the chords of all arcs put in, and what is wrong about arcs. ``scale`` (n,) mm of
    the unit at each row; ``sagitta`` mm; ``holes`` (h,) rows that no arc ends at. Raises ProgramError."""
    arcs, lost = read_arcs(statements, rows.tip, scale, holes)
    spans = arc_spans(arcs, rows.tip)
    straight = rows.motion != Motion.RAPID
    straight[arcs.row] = False
    found = tuple(arc_findings(source, arcs, spans, rows.tip, straight, lost))
    arcs = arcs.take(fitting(arcs, spans))
    spans = arc_spans(arcs, rows.tip)
    count = chord_counts(arcs, spans, sagitta)
    refuse_too_many(source, arcs, count)
    at, tip, axis = inner_ends(arcs, spans, count, rows.axis)
    return Put(at, tip, axis, rows.motion[at], rows.speed[at]), found


def read_arcs(statements: Statements, tip: Floats, scale: Floats, holes: Ints) -> tuple[Arcs, Ints]:
    """Return the arcs, and the statements (k,) that say one without a move before and after it, or one that
    another goes before, or that would end in one of the ``holes``. ``tip`` (n, 3) mm; ``scale`` (n,) mm of
    the unit at each row."""
    at = np.concatenate([statements.of(Kind.CIRCLE), statements.of(Kind.TANGENT)])
    at = at[np.argsort(at, kind="stable")]
    row = statements.row[at]
    last = np.append(row[1:] != row[:-1], True)[: len(row)]
    whole = last & (row > 0) & (row < len(tip)) & ~np.isin(row, holes)
    lost, at, row = at[~whole], at[whole], row[whole]
    number = np.array([statements.meanings[which].more for which in statements.which[at]]).reshape(-1, 8)
    centre, vector, radius = number[:, :3] * scale[row, None], number[:, 3:6], number[:, 6] * scale[row]
    tangent = np.isin(at, statements.of(Kind.TANGENT))
    vector = np.where(tangent[:, None], np.cross(tip[row - 1] - centre, vector), vector)
    length = np.linalg.norm(vector, axis=1)
    good = length > 0.0
    normal = vector[good] / length[good, None]
    start = np.linalg.norm(np.cross(normal, tip[row[good] - 1] - centre[good]), axis=1)
    radius = np.where(np.isnan(radius[good]), start, radius[good])
    turns, statement_of = number[good, 7], statements.statement[at[good]]
    arcs = Arcs(row[good], centre[good], normal, radius, statement_of, turns)
    return arcs, statements.statement[np.concatenate([lost, at[~good]])]


def fitting(arcs: Arcs, spans: ArcSpans) -> Bools:
    """Which arcs (a,) pass through both their ends."""
    return misfit(arcs, spans) <= FIT


def refuse_too_many(source: Source, arcs: Arcs, count: Ints) -> None:
    """Raise ProgramError where the arcs need more chords than any path has."""
    if count.sum() > MOST_ROWS:
        worst = int(count.argmax())
        source.fail(
            int(arcs.statement[worst]),
            "",
            say("this arc alone needs {count} chords; give a larger tolerance", count=int(count[worst])),
        )


def arc_findings(
    source: Source, arcs: Arcs, spans: ArcSpans, tip: Floats, straight: Bools, lost: Ints
) -> Iterator[Finding]:  # fmt: skip
    """Yield what is wrong about arcs; ``lost`` (k,) statements that say one without its two ends."""
    off = misfit(arcs, spans)
    bad = ~(off <= FIT)  # not a number where a row lies beyond all bounds
    if bad.any():
        yield _does_not_fit(source, arcs, off, bad)
    if len(lost):
        line = int(source.line[lost[0]])
        text = plural(
            len(lost),
            "An arc lacks its start or its end (line {line}): it stands before the first move, after the "
            "last one, before another arc or a hole, or its direction points to its centre. The path goes "
            "straight there.",
            "{count} arcs lack their start or their end (first line {line}): they stand before the first "
            "move, after the last one, before another arc or a hole, or their direction points to their "
            "centre. The path goes straight there.",
            line=line,
        )
        yield report_finding(Code.ARC_DOES_NOT_FIT, text, float(len(lost)), line=line, unit="")
    back, on = (which & ~bad for which in runs_back(arcs, spans, tip, straight))
    if back.any():
        yield (
            _runs_back(source, arcs, back)
            if back.sum() >= on.sum()
            else _cusps(source, arcs, back, int(on.sum()))
        )
    either = ambiguous(arcs, spans) & ~bad & ~back
    if either.any():
        yield _ambiguous(source, arcs, spans, either)


def _does_not_fit(source: Source, arcs: Arcs, off: Floats, bad: Bools) -> Finding:
    worst = int(off.argmax())
    line = int(source.line[arcs.statement[worst]])
    text = plural(
        int(bad.sum()),
        "An arc does not pass through the points before and after it (line {line}: off by {off}, radius "
        "{radius}); the path goes "
        "straight there. Has the CAM system left out a move, or are the units mixed?",
        "{count} arcs do not pass through the points before and after them (worst line {line}: off by {off}, "
        "radius {radius}); "
        "the path goes straight there. Has the CAM system left out a move, or are the units mixed?",
        line=line,
        off=Length(off[worst], ".4g"),
        radius=Length(arcs.radius[worst], ".6g"),
    )
    return report_finding(Code.ARC_DOES_NOT_FIT, text, float(off[worst]), FIT, line=line, unit="mm")


def _runs_back(source: Source, arcs: Arcs, back: Bools) -> Finding:
    line = int(source.line[arcs.statement[back.argmax()]])
    text = plural(
        int(back.sum()),
        "An arc runs back against the straight moves beside it (line {line}): does the CAM system mean its "
        "circles the other way round? Have curves written as points.",
        "{count} arcs run back against the straight moves beside them (first line {line}): does the CAM "
        "system mean its circles the other way round? Have curves written as points.",
        line=line,
    )
    return report_finding(Code.ARC_RUNS_BACK, text, float(back.sum()), line=line, severity=Severity.ERROR)


def _cusps(source: Source, arcs: Arcs, back: Bools, on: int) -> Finding:
    """Return a pocket's corner beside an island ends in a cusp; which way round circles are meant shows by
    the others of the file."""
    line = int(source.line[arcs.statement[back.argmax()]])
    text = plural(
        int(back.sum()),
        "An arc turns back where a straight move meets it (line {line}), as in a corner beside an island; "
        "{on} others of the file run on as read.",
        "{count} arcs turn back where straight moves meet them (first line {line}), as in corners beside "
        "islands; {on} others of the file run on as read.",
        line=line,
        on=on,
    )
    return report_finding(Code.ARC_RUNS_BACK, text, float(back.sum()), line=line, severity=Severity.NOTE)


def _ambiguous(source: Source, arcs: Arcs, spans: ArcSpans, either: Bools) -> Finding:
    first = int(either.argmax())
    line = int(source.line[arcs.statement[first]])
    last = spans.sweep[first] - 2.0 * np.pi * arcs.turns[first]
    taken = say("a whole turn") if last > np.pi else say("the short way")
    text = plural(
        int(either.sum()),
        "The ends of an arc are as near as the printed digits allow (line {line}): it may be a whole turn "
        "or next to nothing; {taken} is taken, as its direction says.",
        "The ends of {count} arcs are as near as the printed digits allow (first line {line}): they may be "
        "whole turns or next to nothing; there {taken} is taken, as its direction says.",
        line=line,
        taken=taken,
    )
    return report_finding(Code.ARC_RUNS_BACK, text, float(either.sum()), line=line)
