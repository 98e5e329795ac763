# SPDX-License-Identifier: LGPL-2.1-or-later
"""Counting loops and repeats of a Siemens 840D program, written in words that :mod:`.siemens_run` runs.

FOR R1=1 TO 5 .. ENDFOR     R1=1, WHILE R1<=5 .. R1=R1+1, ENDWHILE.
REPEATB NEXT P=3            the block of the label three times more; P left out: once.
REPEAT NEXT P=3             from the label to the line before. REPEAT FIRST LAST P=3: from the one label to
                            the block of the other; ENDLABEL ends the section of a label by itself.
R[1]                        R1.

Source: 840D sl, Programming Manual Job Planning (program section repetition; count loop).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from freecad_fiveaxis.core.base.sentences import say

from .expressions import Unread
from .siemens_calls import Whole

INDEX = re.compile(r"(?<![A-Z_$])R *\[ *([0-9]+) *\]")
BEFORE = r"^(?P<before> *(?:N *[0-9]+ *)?(?:[A-Z_]{2}[A-Z0-9_]* *: *)?)"
FOR = re.compile(
    BEFORE + r"FOR +(?P<name>[A-Z_][A-Z0-9_]*|R *[0-9]+) *= *(?P<first>.+?) +TO +(?P<last>.+?) *$"
)
END_FOR = re.compile(BEFORE + r"ENDFOR *$")
REPEAT = re.compile(
    BEFORE + r"REPEAT(?P<block>B?) +(?P<first>[A-Z_]{2}[A-Z0-9_]*|N *[0-9]+)"
    r"(?: +(?!P *=)(?P<last>[A-Z_]{2}[A-Z0-9_]*|N *[0-9]+))?(?: +P *= *(?P<times>[0-9]+))? *$"
)
LABEL = re.compile(r"^ *(?P<number>N *[0-9]+)? *(?:(?P<name>[A-Z_]{2}[A-Z0-9_]*) *:)?")
MOST = 200_000
"""Lines that repeats may make."""


def write_loops(whole: Whole) -> None:
    """Put the counting loops and repeats of the rows into words of :mod:`.siemens_run`. Raises Unread for one
    without its label, and for more than :data:`MOST` lines."""
    rows = [INDEX.sub(r"R\1", row) if "[" in row else row for row in whole.rows]
    if any("FOR" in row or "REPEAT" in row for row in rows):
        written = _without_repeats(_without_counts(list(zip(rows, whole.unit, whole.source, strict=True))))
        rows = [row for row, _, _ in written]
        whole.unit, whole.source = [unit for _, unit, _ in written], [at for _, _, at in written]
    whole.rows = rows


Row = tuple[str, int, int]
"""A row, the program that it is of, and its line in the main file, from 0."""


def _without_counts(rows: Sequence[Row]) -> list[Row]:
    written, counts = list[Row](), list[str]()
    for row, unit, at in rows:
        texts = [row]
        if found := FOR.match(row):
            name = found["name"].replace(" ", "")
            counts.append(name)
            texts = [f"{found['before']}{name}={found['first']}", f"WHILE {name}<={found['last']}"]
        elif counts and (found := END_FOR.match(row)):
            name = counts.pop()
            texts = [f"{found['before']}{name}={name}+1", "ENDWHILE"]
        written += [(text, unit, at) for text in texts]
    return written


def _without_repeats(rows: Sequence[Row]) -> list[Row]:
    written = list[Row]()
    for place, (row, unit, at) in enumerate(rows):
        found = REPEAT.match(row)
        if not found:
            written.append((row, unit, at))
            continue
        section = _section(found, written, rows[place + 1 :], unit, at)
        times = 1 if found["times"] is None else int(found["times"])
        if len(written) + times * len(section) > MOST:
            raise Unread(say("it repeats more than {most} lines", most=MOST), at)
        written.append((found["before"], unit, at))
        written += [(LABEL.sub("", text, count=1), unit, line) for text, _, line in section] * times
    return written


def _section(
    found: re.Match[str], before: Sequence[Row], behind: Sequence[Row], unit: int, at: int
) -> list[Row]:
    """Return the rows that a repeat names: searched backwards, then on. Raises Unread where they are not."""
    here = [row for row in before if row[1] == unit]
    if (first := _find(here, found["first"], reversed(range(len(here))))) is None:
        here = [row for row in behind if row[1] == unit]
        first = _find(here, found["first"], range(len(here)))
        if first is not None and not (found["block"] or found["last"]):
            last = _find(here, "ENDLABEL", range(first, len(here)))
            first = None if last is None else first
    if first is None:
        raise Unread(say("{label} stands in no line of this program", label=found["first"]), at)
    section = here[first : _end(found, here, first, at) + 1]
    if any(REPEAT.match(text) or "GOTO" in text for text, _, _ in section):
        raise Unread(say("it repeats lines with jumps or repeats"), at)
    return section


def _end(found: re.Match[str], here: Sequence[Row], first: int, at: int) -> int:
    """Return the last row of a section."""
    if found["block"]:
        return first
    last = _find(here, found["last"] or "ENDLABEL", range(first, len(here)))
    if last is None and found["last"]:
        raise Unread(say("{label} stands in no line of this program", label=found["last"]), at)
    return len(here) - 1 if last is None else last


def _find(rows: Sequence[Row], name: str, places: Iterable[int]) -> int | None:
    """Return the first of the places whose row has that label or block number."""
    wanted = name.replace(" ", "")
    for place in places:
        head = LABEL.match(rows[place][0])
        if head and wanted in (head["name"], (head["number"] or "").replace(" ", "")):
            return place
    return None
