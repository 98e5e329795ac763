# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tools of a CL file: which of them each move is made with, and the moves of one of them.

number    LOADTL/ n, LOAD/ TOOL, n or TOOLNO/ n. Where these tell fewer tools apart than the names of NX (TOOL
          PATH/ ..., TOOL, name) or than TLDATA, the tools are numbered as they come: 1, 2, ...
change    All that stands between the last move of one tool and the word that names the next belongs to the
          next: CUTTER and TLDATA stand before LOADTL.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.base.sentences import Option, say

from . import vocabulary as words
from .source import Source
from .statements import Kind, Statements

LISTED = 20
"""How many tools are named."""
CARRIED = (Kind.UNITS, Kind.FEED, Kind.SPINDLE, Kind.COOLANT, Kind.MULTAX)
"""Statements that go on to hold for the tools that follow."""


@dataclass(frozen=True, eq=False)
class Tools:
    """``of`` (n,) the tool's number of each move; ``names`` of the numbers; ``second`` the line where it
    first changes, 0: never."""

    of: Ints
    names: dict[int, str]
    second: int

    @property
    def listed(self) -> str:
        """The tools with their names, as "1 (T10), 2 (T8)"."""
        every = [f"{number} ({name})" if name else str(number) for number, name in self.names.items()]
        return ", ".join(every[:LISTED]) + (" ..." if len(every) > LISTED else "")


def tools_of(source: Source, statements: Statements) -> Tools:
    """Return the tools that the moves are made with; none where the file says none."""
    numbers = statements.of(Kind.TOOL)
    best = _by_number(source, statements, numbers if len(numbers) else statements.of(Kind.TOOLNO))
    for name in (_name_of_path, _name_of_data):
        texts = [name(text) for text in statements.texts]
        other = _by_name(source, statements, texts)
        if len(other.names) > max(len(best.names), 1):
            best = other
    return best


def _by_number(source: Source, statements: Statements, at: Ints) -> Tools:
    return _hold_tools(
        source,
        statements,
        at,
        np.clip(statements.value(at), -words.LARGEST, words.LARGEST).astype(np.int64),
        {},
    )


def _by_name(source: Source, statements: Statements, names: list[str]) -> Tools:
    """Tools by name: ``names`` of each text of ``statements``, empty where it has none; numbered in the order
    of their moves."""
    at = np.flatnonzero(np.array([bool(name) for name in names] or [False])[statements.which])
    order = {
        name: k for k, name in enumerate(dict.fromkeys(names[which] for which in statements.which[at]), 1)
    }
    number = np.array([order[names[which]] for which in statements.which[at]], np.int64)
    return _hold_tools(source, statements, at, number, {k: name for name, k in order.items()})


def _hold_tools(
    source: Source, statements: Statements, at: Ints, number: Ints, names: dict[int, str]
) -> Tools:
    """Each move's tool: the last one named before it, the first one where none is."""
    moves = len(source.move_at)
    used = statements.row[at] < moves
    at, number = at[used], number[used]
    if not len(at):
        return Tools(np.zeros(moves, np.int64), {}, 0)
    of = number[np.maximum(np.searchsorted(statements.row[at], np.arange(moves), side="right") - 1, 0)]
    change = np.flatnonzero(of[1:] != of[:-1])
    second = 0
    if len(change):
        second = int(
            source.line[
                statements.statement[at[np.searchsorted(statements.row[at], change[0] + 1, side="right") - 1]]
            ]
        )
    return Tools(of, {k: names.get(k, "") for k in dict.fromkeys(of.tolist())}, second)


def _name_of_path(text: str) -> str:
    """NX: ``TOOL PATH/ operation, TOOL, name``."""
    return text.partition(",TOOL,")[2] if text.startswith("TOOLPATH/") else ""


def _name_of_data(text: str) -> str:
    """NX: ``TLDATA/MILL, 10.0000, 0.0000, ...`` as "MILL,10,0,..."."""
    if not text.startswith("TLDATA/"):
        return ""
    parts = text.removeprefix("TLDATA/").split(",")
    return ",".join(f"{float(part):g}" if words.NUMBER.fullmatch(part) else part for part in parts)


def only(source: Source, statements: Statements, tools: Tools, tool: int) -> Bools:
    """Which statements (s,) are those of one tool, with what earlier ones say for it too. Raises ProgramError
    where there is no such tool."""
    if tool not in tools.names:
        raise ProgramError(_no_such_tool(tools, tool), tool)
    kept = np.zeros(len(source.begin), np.bool_)
    kept[source.move_at] = tools.of == tool
    following = np.append(tools.of, tools.of[-1])
    carried = np.isin([int(meaning.kind) for meaning in statements.meanings], [int(kind) for kind in CARRIED])
    kept[statements.statement] = (following[statements.row] == tool) | carried[statements.which]
    return kept


def _no_such_tool(tools: Tools, tool: int) -> str:
    if not tools.names:
        return say("the CL file names no tool; leave {option} out", option=Option("cl_tool"))
    return say("the CL file has no tool {tool}; it has {listed}", tool=tool, listed=tools.listed)


def tool_findings(tools: Tools, chosen: int | None) -> tuple[Finding, ...]:
    """Report that the file changes tools, or which of them has been chosen."""
    if len(tools.names) < 2:
        return ()
    count = float(len(tools.names))
    if chosen is None:
        text = say(
            "The file changes tools ({listed}), the program does not: it cuts all of it with one. Write one "
            "file for each tool, or choose one: {option}.",
            listed=tools.listed,
            option=Option("cl_tool"),
        )
        return (report_finding(Code.SEVERAL_TOOLS, text, count, 1.0, line=tools.second),)
    text = say(
        "Of the file's tools ({listed}) the moves of tool {tool} are taken: {count} of {all}.",
        listed=tools.listed,
        tool=chosen,
        count=int((tools.of == chosen).sum()),
        all=len(tools.of),
    )
    return (report_finding(Code.TOOL_CHOSEN, text, float(chosen)),)
