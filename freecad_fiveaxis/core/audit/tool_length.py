# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the length of the tool that is in the spindle is active where a program feeds.

Fanuc, Haas, Mach3   G43 H, G43.4 H, G43.5 H, G234 H take the length of row H of the table; G49 and H0 take
                     none. M6 does not change it.
LinuxCNC             the same; G43 without H takes that of the tool in the spindle (G code reference, G43).
Siemens              the tool's edge D1 is taken with the tool; D0 takes its length away.
Heidenhain           TOOL CALL takes the length with the tool; tool 0 has none.

Where neither a tool nor a length is read, as in parts of programs and where one tool stands in the spindle,
nothing is found: the report then says that the length was assumed.
"""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Sentence, plural, say
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.nc.reader import Reading

from .states import NOTHING, UNKNOWN, before, clean_text, cutting_rows, events, has_code, hold, words_of
from .states import mark_file_lines as mark

TABLE = ("fanuc", "haas", "mach3", "linuxcnc")
"""Controllers that take the length by G43 H."""
ON, OFF = 1.0, 0.0
TAKES = (430, 432, 433, 434, 435, 436, 437, 438, 440, 2340)
DYNAMIC = (431,)
"""G43.1 of LinuxCNC: the lengths stand in the line."""
CANCELS = (490,)
OTHER_H = (100, 410, 420, 650, 660, 661)
"""G10, G41 and G42 (older Fanuc), and calls have an H of their own."""
CHANGE = 6
RULE = 10
"""Rows of the table that are so many, or a multiple, off the tool's number follow a rule: H101 for T1."""
TOOL_BY_NAME = re.compile(rb"(?<![A-Z0-9_$])T *=")
TOOL_CALL = re.compile(rb"^[ 0-9/]*TOOL CALL +(?P<number>[0-9]+)?", re.MULTILINE)


class Held(NamedTuple):
    """What is in force in each row (rows,): ``tool`` in the spindle, ``called``: the one called before;
    ``length`` :data:`ON`, :data:`OFF` or nothing; ``number`` of its row in the table."""

    tool: Floats
    called: Floats
    length: Floats
    number: Floats


def length_findings(text: bytes, reading: Reading, dialect: Dialect) -> tuple[Finding, ...]:
    """Say where the program feeds without a tool length, or with that of another tool."""
    block, row = cutting_rows(reading)
    if reading.language != "iso":
        return _report(reading, block, _is_taken_away(text, reading)[row], _advise(reading.language))
    if dialect.name not in TABLE:
        return ()
    held = _find_held(reading, dialect.name)
    after = (held.called != NOTHING)[row]
    length, number = held.length[row], held.number[row]
    on = length == ON
    bare = on & (number == NOTHING)
    return (
        *_report(reading, block, after & ((length != ON) | (number == 0.0)), say("Give G43 H after M6.")),
        *_report(reading, block, bare, say("G43, G43.4, G43.5 and G234 take it by their H: give H there.")),
        *_report_other(reading, block, on & (number > 0.0), Held(*(column[row] for column in held))),
    )


def assume_length(reading: Reading, dialect: Dialect) -> tuple[Sentence, ...]:
    """Return what is taken for granted where the program reads no length and calls no tool."""
    if reading.language != "iso" or dialect.name not in TABLE:
        return ()
    if has_code(reading, (*TAKES, *DYNAMIC)).any() or (_find_called(reading) != NOTHING).any():
        return ()
    return (say("the length of the tool is active: no G43 was read"),)


def _find_held(reading: Reading, controller: str) -> Held:
    """Return tool and length in each row; a length that stands in the line itself has no number."""
    called = _find_called(reading)
    tool = _in_spindle(reading)
    length, number = events(reading), events(reading)
    takes = has_code(reading, TAKES)
    length[has_code(reading, CANCELS)] = OFF
    length[takes | has_code(reading, DYNAMIC)] = ON
    rows, value = words_of(reading, "H")
    own = ~has_code(reading, OTHER_H)[rows]
    if controller == "linuxcnc":  # H is read beside G43 alone
        number[takes] = np.where(tool[takes] == NOTHING, UNKNOWN, tool[takes])
        own &= takes[rows]
    number[rows[own]] = value[own]
    number[has_code(reading, DYNAMIC)] = UNKNOWN
    return Held(tool, called, hold(length), hold(number))


def _find_called(reading: Reading) -> Floats:
    """Return the last T in each row from the first M6 on, :data:`UNKNOWN` where there was none; before it the
    tool may stand in the spindle already."""
    event = events(reading)
    rows, tool = words_of(reading, "T")
    event[rows] = tool
    state = hold(event)
    rows, number = words_of(reading, "M")
    first = rows[number == CHANGE].min(initial=reading.lines.count)
    return np.where(np.arange(len(state)) < first, float(NOTHING), np.where(state < 0.0, UNKNOWN, state))


def _in_spindle(reading: Reading) -> Floats:
    """Return the tool of the last M6 in each row. Where another was called before it and not changed to, some
    controls change to that one: then it is not known."""
    rows, number = words_of(reading, "M")
    changes, called = np.unique(rows[number == CHANGE]), _find_called(reading)
    event = events(reading)
    event[changes] = called[changes]
    of_change, alone = np.zeros((2, len(event)), np.bool_)
    of_change[changes] = True
    alone[words_of(reading, "T")[0]] = True
    waiting = events(reading)
    waiting[alone | of_change] = (alone & ~of_change)[alone | of_change]
    waits = before(hold(waiting)) == 1.0
    event[of_change & alone & waits & (before(called) != called)] = UNKNOWN
    return hold(event)


def _is_taken_away(text: bytes, reading: Reading) -> Bools:
    """Return the rows (rows,) in which D0 of Siemens is in force, or tool 0 of Heidenhain."""
    event, text = events(reading), clean_text(text, reading.language)
    if reading.language == "heidenhain":
        mark(
            reading,
            event,
            text,
            ((at.start(), float(at["number"] or b"1")) for at in TOOL_CALL.finditer(text)),
        )
        return np.asarray(hold(event) == 0.0)
    for letter, number in (("T", 1.0), ("M", 1.0), ("D", np.nan)):
        rows, value = words_of(reading, letter)
        kept = value == CHANGE if letter == "M" else np.full(len(rows), True)
        event[rows[kept]] = value[kept] if np.isnan(number) else number
    mark(reading, event, text, ((at.start(), 1.0) for at in TOOL_BY_NAME.finditer(text)))
    return np.asarray(hold(event) == 0.0)


def _advise(language: str) -> Sentence:
    return say("Give D1 after D0.") if language == "siemens" else say("Give TOOL CALL with the tool.")


def _report(reading: Reading, block: Ints, where: Bools, remedy: Sentence) -> tuple[Finding, ...]:
    """Say where no length is active, and what to do."""
    if not where.any():
        return ()
    first, count = int(block[np.argmax(where)]), int(where.sum())
    line = int(reading.program.line[first])
    text = plural(
        count,
        "No tool length is active in {count} feed block, NC line {line}: the control takes the tool for one "
        "of length 0 and drives it in by its length, if work zero was not set with this tool. {remedy}",
        "No tool length is active in {count} feed blocks, from NC line {line} on: the control takes the tool "
        "for one of length 0 and drives it in by its length, if work zero was not set with this tool. "
        "{remedy}",
        line=line,
        remedy=remedy,
    )
    return (report_finding(Code.TOOL_LENGTH_OFF, text, float(count), block=first, line=line),)


def _report_other(reading: Reading, block: Ints, on: Bools, held: Held) -> tuple[Finding, ...]:
    """Say where the row of the table is not that of the tool: a note where it follows a rule, as H101 for
    T1."""
    known = on & (held.tool > 0.0) & (held.tool < UNKNOWN) & (held.number < UNKNOWN)
    other = known & (held.tool != held.number)
    if not other.any():
        return ()
    by_rule = bool(((held.number - held.tool)[other] % RULE == 0.0).all())
    at, count = int(np.argmax(other)), int(other.sum())
    first = int(block[at])
    line = int(reading.program.line[first])
    text = plural(
        count,
        "The length of H{number} is active with tool T{tool} in {count} feed block, NC line {line}. Give "
        "G43 H{tool} after the M6, or see that row {number} of the table holds the length of T{tool}.",
        "The length of H{number} is active with tool T{tool} in {count} feed blocks, from NC line {line} on. "
        "Give G43 H{tool} after the M6, or see that row {number} of the table holds the length of T{tool}.",
        number=f"{held.number[at]:g}",
        tool=f"{held.tool[at]:g}",
        line=line,
    )
    severity = Severity.NOTE if by_rule else None
    return (
        report_finding(Code.TOOL_LENGTH_OTHER, text, float(count), block=first, line=line, severity=severity),
    )
