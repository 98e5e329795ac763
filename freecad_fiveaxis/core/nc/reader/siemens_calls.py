# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subprograms that a Siemens 840D program calls, found in folders and written behind it.

L100, MYSUB, MYSUB(1,R2)   a line of its own; P3 behind it: three times. CALL "NAME", EXTCALL "DIR/NAME.SPF",
                           PCALL NAME(..).
PROC MYSUB(REAL A, INT B=2)   the head of one with parameters, which take the values of the call in their
                              order; one that is left out has its own, or 0. Strings, axes and VAR parameters
                              are not known.
RET, M17, M2, M30             back.

Source: 840D sl, Programming Manual Job Planning (subprogram technique). The folders that are named are
searched in their order for NAME.SPF, then NAME.MPF; the control's own order was not looked up.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from freecad_fiveaxis.core.base.errors import FileError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.sentences import say

from .expressions import Unread
from .siemens_cycles import split_arguments

CALL = re.compile(
    r"^(?P<before> *(?:N *[0-9]+)? *)(?:(?:EXT|P)?CALL *\(? *\"?(?P<path>[A-Z0-9_./\\:]+)\"?"
    r"|(?P<name>L[0-9]+|[A-Z_][A-Z_][A-Z0-9_]*))"
    r"(?: *\((?P<inside>.*)\))? *\)?(?: +P *=? *(?P<times>[0-9]+))? *$"
)
PROC = re.compile(r"^ *(?:N *[0-9]+)? *PROC +([A-Z_][A-Z0-9_]*) *(?:\(([^()]*)\))?.*$")
PARAMETER = re.compile(r" *(?:REAL|INT|BOOL|CHAR) +([A-Z_][A-Z0-9_]*) *(?:= *([-+]?[0-9.]+))? *")
COMMENT = re.compile(rb'("[^"\n]*")|;[^\n]*')
MOST_TIMES = 9999
"""P of a call."""
ENDINGS = (".spf", ".mpf", "")
DEEPEST = 100
"""Files that one program may call."""


@dataclass(eq=False)
class Unit:
    """A program: its ``rows``, the line of the main file that each ``source`` stands for, ``parameters`` with
    their values where a call leaves them out."""

    rows: list[str]
    source: list[int]
    parameters: list[tuple[str, str]] = field(default_factory=list)


@dataclass(eq=False)
class Whole:
    """The rows of a program and of those that it calls, calls as ``@2(1,R2)``; ``unit``: which of them each
    is of (0: the main one); ``source``: its line in the main file, from 0."""

    rows: list[str]
    unit: list[int]
    source: list[int]


def put_unit(
    whole: Whole, number: int, rows: list[str], texts: list[str], source: list[int], units: dict[str, Unit]
) -> None:
    """Put the rows of a program behind the others; ``texts``: the same with their strings. Raises Unread for
    a call that does not fit."""
    names = list(units)
    for row, text, at in zip(rows, texts, source, strict=True):
        found = CALL.match(text) if units else None
        name = name_of(found) if found else ""
        times = 1
        if found and name in units:
            row = f"@{names.index(name) + 1}({_arguments(found['inside'] or '', units[name], at)})"
            times = int(found["times"] or 1)
        for _ in range(min(times, MOST_TIMES)):
            whole.rows.append(row)
            whole.unit.append(number)
            whole.source.append(at)


def _arguments(inside: str, unit: Unit, at: int) -> str:
    """Return the values of a call, with those of the head for what it leaves out."""
    given = [part.strip() for part in split_arguments(inside)] if inside.strip() else []
    if len(given) > len(unit.parameters):
        raise Unread(say("it gives more values than the program takes"), at)
    given += [""] * (len(unit.parameters) - len(given))
    return ",".join(value or own for value, (_, own) in zip(given, unit.parameters, strict=True))


def find_units(rows: list[str], folders: Sequence[str], known: frozenset[bytes]) -> dict[str, Unit]:
    """Return the programs that the rows call, and those that these call, by name. ``known``: words that are
    no programs."""
    units, waiting = dict[str, Unit](), [(row, at) for at, row in enumerate(rows)]
    while waiting and folders:
        row, at = waiting.pop(0)
        found = CALL.match(row)
        name = name_of(found) if found else ""
        if not found or name in units or name.encode() in known or (text := _text(name, folders)) is None:
            continue
        if len(units) >= DEEPEST:
            raise Unread(say("it calls more than {most} programs", most=DEEPEST), at)
        own = [line for line in text.decode("latin-1").split("\n") if not line.lstrip().startswith("%")]
        units[name] = _unit(own, at)
        waiting += [(line, at) for line in own]
    return units


def name_of(found: re.Match[str]) -> str:
    """Return the name that a call gives, without folder and ending."""
    if found["name"]:
        return found["name"]
    name = re.split(r"[/\\:]", found["path"])[-1].partition(".")[0]
    return name.removeprefix("_N_").removesuffix("_SPF").removesuffix("_MPF")


def _text(name: str, folders: Sequence[str]) -> bytes | None:
    """Return the program of a name in capitals, without comments; None where no folder has it."""
    for folder in folders:
        try:
            here = {entry.lower(): entry for entry in sorted(os.listdir(folder))}
        except OSError:
            continue
        for ending in ENDINGS:
            if file := here.get(name.lower() + ending):
                try:
                    text = read_bytes(os.path.join(folder, file), "NC file")
                except FileError:
                    continue
                return COMMENT.sub(
                    lambda found: found[1] or b"", text.replace(b"\r\n", b"\n").replace(b"\t", b" ")
                ).upper()
    return None


def _unit(rows: list[str], at: int) -> Unit:
    parameters = list[tuple[str, str]]()
    for k, row in enumerate(rows):
        if found := PROC.match(row):
            rows = [*rows[:k], "", *rows[k + 1 :]]
            for part in (found[2] or "").split(",") if (found[2] or "").strip() else ():
                assignment = PARAMETER.fullmatch(part)
                if not assignment:
                    raise Unread(say("{rest} is not known here", rest=repr(part.strip()[:20])), at)
                parameters.append((assignment[1], assignment[2] or "0"))
            break
    return Unit(rows, [at] * len(rows), parameters)
