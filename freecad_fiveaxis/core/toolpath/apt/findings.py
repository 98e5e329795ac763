# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is poor about a CL file: statements not interpreted, axes that are no unit vectors, moves without a
feed, no unit."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Option, plural, say

from .poses import Moves
from .source import Source
from .statements import Kind, Statements, name_of
from .vocabulary import CURVES, OF_INCHES, SPOILING

NOT_UNIT = 1e-4
"""An axis whose length differs by more than this from 1 was not meant as a unit vector; four printed decimals
stay below."""
TILTED = 1e-6
"""An axis that leans more than this, in sine, is not upright."""
LINES_LISTED, NAMES_LISTED = 5, 20
"""How many lines of one word, and how many words, are told."""


def find_poor_spots(
    source: Source, statements: Statements, moves: Moves, length: Floats, speed: Floats, fed: Bools
) -> tuple[Finding, ...]:  # fmt: skip
    """Return the findings of a CL file; ``length`` (n,) of the axes as printed, ``speed`` (n,) mm/min of its
    moves, ``fed`` (n,) which of them need one."""
    found = [
        *_report_passed_over(source, statements),
        *_frames(source, statements),
        *_compensation(source, statements),
    ]
    return (*found, *_rows(source, statements, moves, length, speed, fed))


def _report_passed_over(source: Source, statements: Statements) -> Iterator[Finding]:
    """One finding for each word that is not interpreted, in the order in which they first stand."""
    at = statements.of(Kind.UNKNOWN)
    names = [
        name_of(statements.texts[which]) if statements.meanings[which].kind is Kind.UNKNOWN else ""
        for which in range(len(statements.texts))
    ]
    number = {name: k for k, name in enumerate(dict.fromkeys(names))}
    word = np.array([number[name] for name in names] or [0])[statements.which[at]]
    order = np.argsort(word, kind="stable")
    groups = np.split(at[order], np.flatnonzero(np.diff(word[order])) + 1) if len(at) else []
    groups.sort(key=lambda group: int(group[0]))
    for group in groups[:NAMES_LISTED]:
        yield _not_interpreted(
            name_of(statements.texts[statements.which[group[0]]]), source.line[statements.statement[group]]
        )
    rest = groups[NAMES_LISTED:]
    if rest:
        count, line = sum(map(len, rest)), int(source.line[statements.statement[rest[0][0]]])
        text = say(
            "{words} further words ({count} statements) are not interpreted; is this a CL file?",
            words=len(rest),
            count=count,
        )
        yield report_finding(Code.STATEMENT_NOT_INTERPRETED, text, float(count), line=line)


def _not_interpreted(name: str, lines: Ints) -> Finding:
    listed = ", ".join(map(str, lines[:LINES_LISTED].tolist())) + (
        " ..." if len(lines) > LINES_LISTED else ""
    )
    remedy = ""
    if name in CURVES:
        remedy = say(" The path goes straight on to the next GOTO: have curves written as points.")
    elif name.startswith("CYCLE"):
        remedy = say(" The tool only goes to its points: have cycles written as moves.")
    where = plural(
        len(lines), "{count} statements, line {lines}", "{count} statements, lines {lines}", lines=listed
    )
    text = say(
        "{name} is not interpreted ({where}); what it does is missing in the path.{remedy}",
        name=name,
        where=where,
        remedy=remedy,
    )
    severity = Severity.ERROR if name.partition("/")[0] in SPOILING else Severity.WARNING
    return report_finding(
        Code.STATEMENT_NOT_INTERPRETED, text, float(len(lines)), line=int(lines[0]), severity=severity
    )


def _frames(source: Source, statements: Statements) -> Iterator[Finding]:
    """Points are counted from MSYS: one for the whole file is the work zero, a second one means another zero.
    So it is with CSYS, but where TRNTYP/WORLD says that all points are counted from one."""
    at = statements.of(Kind.FRAME)
    planes = np.array([text.startswith("CSYS/") for text in statements.texts] or [False])[statements.which]
    if planes.any() and not any(text.startswith("TRNTYP/WORLD") for text in statements.texts):
        at = np.flatnonzero(planes)
    other = at[statements.which[at] != statements.which[at[0]]] if len(at) else at
    if len(other):
        line = int(source.line[statements.statement[other[0]]])
        text = say(
            "{word} changes the coordinate system within the file; its points are taken in one. Write one "
            "file for each system.",
            word=name_of(statements.texts[statements.which[other[0]]]),
        )
        yield report_finding(Code.SEVERAL_COORDINATE_SYSTEMS, text, float(len(other)), line=line)


def _compensation(source: Source, statements: Statements) -> Iterator[Finding]:
    """CL files say the tool's own path, whatever the controller is to add to it (ISO 4343); Creo says where
    they do not."""
    at = statements.of(Kind.CUTCOM)
    if not len(at):
        return
    line = int(source.line[statements.statement[at[0]]])
    contour = b"OUTPUT_ON_PROFILE" in source.plain
    text = plural(
        len(at),
        "CUTCOM asks for cutter compensation once (line {line}); the program has none: {taken}",
        "CUTCOM asks for cutter compensation {count} times (first line {line}); the program has none: "
        "{taken}",
        line=line,
        taken=say("the file says that its points are the part's contour. Have the tool's path written.")
        if contour
        else say("the points are taken as the tool's own path, as CL files mean them."),
    )
    yield report_finding(
        Code.CUTTER_COMPENSATION,
        text,
        float(len(at)),
        line=line,
        severity=Severity.ERROR if contour else Severity.WARNING,
    )


def units_findings(source: Source, statements: Statements, units: str) -> tuple[Finding, ...]:
    """Report that nobody has said the unit, where feeds or speeds are said in those of inches. ``units``:
    what the reading says."""
    if units != "file" or len(statements.of(Kind.UNITS)):
        return ()
    spoken = (Kind.FEED, Kind.SPINDLE, Kind.CYCLE)
    inches = [
        meaning.kind in spoken and not OF_INCHES.isdisjoint(text.partition("/")[2].split(","))
        for text, meaning in zip(statements.texts, statements.meanings, strict=True)
    ]
    at = np.flatnonzero(np.array(inches or [False])[statements.which])
    if not len(at):
        return ()
    line = int(source.line[statements.statement[at[0]]])
    text = say(
        "The CL file does not say its unit; mm is taken, but line {line} says {statement}, as files in "
        "inches do. Give {option}, mm or inch.",
        line=line,
        statement=statements.texts[statements.which[at[0]]][:40],
        option=Option("units"),
    )
    return (report_finding(Code.UNITS_NOT_SAID, text, float(len(at)), line=line),)


def _rows(
    source: Source, statements: Statements, moves: Moves, length: Floats, speed: Floats, fed: Bools
) -> Iterator[Finding]:
    line = source.line[source.move_at]
    off = np.abs(length - 1.0)
    if (off > NOT_UNIT).any():
        text = say(
            "{count} tool axes are no unit vectors; they are scaled to length 1.",
            count=int((off > NOT_UNIT).sum()),
        )
        first = int((off > NOT_UNIT).argmax())
        yield report_finding(Code.AXIS_NOT_UNIT, text, float(off.max()), NOT_UNIT, line=int(line[first]))
    switch = statements.of(Kind.MULTAX)
    on = np.concatenate([[1.0], statements.value(switch)])[
        np.searchsorted(statements.row[switch], np.arange(len(length)), side="right")
    ]
    leaning = (on == 0.0) & ~moves.full & (np.hypot(*moves.axis[:, :2].T) > TILTED * length)
    if leaning.any():
        text = say(
            "{count} moves after MULTAX/OFF say no axis; the tool keeps the last one, which is not upright.",
            count=int(leaning.sum()),
        )
        yield report_finding(Code.AXIS_CARRIED_ON, text, line=int(line[leaning.argmax()]))
    unfed = fed & (speed <= 0.0)
    if unfed.any():
        text = say("{count} moves come before any FEDRAT; give a feed.", count=int(unfed.sum()))
        yield report_finding(Code.NO_FEED, text, line=int(line[unfed.argmax()]), severity=Severity.WARNING)
    if source.after_end:
        yield report_finding(
            Code.TEXT_AFTER_END, say("The text after FINI is not read."), line=source.after_end
        )
