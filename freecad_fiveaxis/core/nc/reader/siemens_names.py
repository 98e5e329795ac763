# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variables with names in a Siemens 840D program: marked in its rows, so that none is taken for words of a
block.

DEF REAL _A, B=5    of the program that defines them, 0 where no value is told; INT, BOOL and CHAR too.
                    Strings, axes, frames and fields have no value here: a line that uses one is not known.
_A=5                without a DEF: of the control (GUD), the same in all programs.

Source: 840D sl, Programming Manual Job Planning (user-defined variables; redefinition; initial values).
"""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.sentences import say

from .expressions import Unread

DEFINES = re.compile(
    r"(?<![A-Z0-9_$])DEF +(?:[A-Z]+ +)*?(REAL|INT|BOOL|CHAR|STRING *\[[^]]*\]|AXIS|FRAME) +([^\n]*)"
)
WITH_VALUE = ("REAL", "INT", "BOOL", "CHAR")
ASSIGNS = re.compile(r"(?<![A-Z0-9_$])(_[A-Z0-9_]+) *=(?!=)")
IDENTIFIER = re.compile(r"(?<![A-Z0-9_$.])[A-Z_][A-Z0-9_]*(?! *[(\[:])")
MARKED = re.compile(r"\xab([^\xab\xbb]*)\xbb")
"""A variable: its name in small letters, for none is a word; v. before one of the program, _g. of the
control."""
SETS = re.compile(r"(?:R[0-9]+|\xab[^\xbb]*\xbb)=(?!=)")
"""A line that sets variables, without blanks."""
DEFINITION = re.compile(r"DEF(?:NCK|CHAN)?(?:REAL|INT|BOOL|CHAR)(.*)$")
WITHOUT_VALUE = re.compile(r"DEF(?:NCK|CHAN)?(?:STRING|AXIS|FRAME)")
OPERAND = re.compile(
    r" *[-+]* *(?:[0-9.]+|R *[0-9]+|\xab[^\xbb]*\xbb|(?:[A-Z_]{2,}[0-9]?(?= *\())?(?=[(\[]))"
)
OPERATOR = re.compile(r" *(?:\*|/|[-+]|(?:DIV|MOD|AND|OR|XOR)\b|==|<>|<=|>=|<|>)")


def mark_names(rows: list[str]) -> list[str]:
    """Return the rows with the names of their variables between marks; the same where they have none."""
    own, control = set[str](), set[str]()
    for row in rows:
        if "DEF" in row and (found := DEFINES.search(row)) and found[1] in WITH_VALUE:
            own |= {part.partition("=")[0].strip() for part in found[2].split(",")}
        if "_" in row:
            control |= set(ASSIGNS.findall(row))
    own = {name for name in own if re.fullmatch("[A-Z_][A-Z0-9_]*", name)}
    known = {name: f"\xabv.{name.lower()}\xbb" for name in own}
    known |= {name: f"\xab_g.{name.lower()}\xbb" for name in control - own}
    if not known:
        return rows
    return [IDENTIFIER.sub(lambda found: known.get(found[0], found[0]), row) for row in rows]


def unmark_names(text: str) -> str:
    """Return the text with the names as they are written."""
    return MARKED.sub(lambda found: found[1].partition(".")[2].upper(), text)


def by_names(text: str) -> str:
    """Return the text with the names as those of the variables of :mod:`.expressions`."""
    return MARKED.sub(r"#<\1>", text)


def definition(line: str) -> str:
    """Return a line of DEF, without blanks, as settings; nothing for variables that have no value here.
    Raises Unread for fields."""
    found = DEFINITION.match(line)
    if not found:
        if WITHOUT_VALUE.match(line):
            return ""
        raise Unread(say("{rest} is not known here", rest=repr(unmark_names(line)[:20])))
    settings = []
    for part in found[1].split(","):
        name, _, value = part.partition("=")
        if not MARKED.fullmatch(name) or not re.fullmatch(r"|[-+]?[0-9.]+|TRUE|FALSE", value):
            raise Unread(say("{rest} is not known here", rest=repr(unmark_names(part)[:20])))
        settings.append(f"{by_names(name)}=[{ {'': '0', 'TRUE': '1', 'FALSE': '0'}.get(value, value) }]")
    return "".join(settings)


def value_end(row: str, at: int) -> int:
    """Where the value that begins at ``at`` of a row, with its blanks, ends."""
    while True:
        found = OPERAND.match(row, at)
        if not found:
            return at
        at = found.end()
        if row[at : at + 1] in ("(", "["):
            at = _find_closing(row, at)
        found = OPERATOR.match(row, at)
        if not found:
            return at
        at = found.end()


def _find_closing(row: str, at: int) -> int:
    """Behind the bracket that closes the one at ``at``; the end of the row where none does."""
    depth = 0
    for place in range(at, len(row)):
        depth += (row[place] in "([") - (row[place] in ")]")
        if not depth:
            return place + 1
    return len(row)
