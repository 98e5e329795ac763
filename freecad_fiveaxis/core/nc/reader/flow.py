# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which lines of a program belong together: loops, branches, subprograms and the lines that jumps go to.

O-word    LinuxCNC: O100 WHILE [..] ... O100 ENDWHILE; SUB, CALL, RETURN, IF, ELSEIF, ELSE, DO, REPEAT, BREAK,
          CONTINUE.
macro     Fanuc, Haas: WHILE [..] DO1 ... END1, GOTO 10 to N10, O1000 as the head of a subprogram.

Sources: LinuxCNC 2.9, O codes; Fanuc B-63324EN, 15.5 and 13.3; Haas mill operator's manual, M97 and M98.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import dataclass, field

from freecad_fiveaxis.core.base.sentences import say

from .expressions import Unread

O_WORD = re.compile(
    r"O(<[^<>]*>|[0-9]+)(SUB|ENDSUB|CALL|RETURN|IF|ELSEIF|ELSE|ENDIF|WHILE|ENDWHILE|DO|REPEAT|ENDREPEAT|BREAK|CONTINUE)"
)
HEAD = re.compile(r"O([0-9]+)(?![0-9.]|[A-Z])")
BLOCK_NUMBER = re.compile(r"N([0-9]+)(?:\.[0-9]*)?")
DO = re.compile(r"(?:WHILE\[.*\])?DO([0-9]+)$")
END = re.compile(r"END([0-9]+)$")
CLOSES = {"ENDSUB": "SUB", "ENDIF": "IF", "ENDWHILE": "WHILE", "ENDREPEAT": "REPEAT"}
LOOPS = ("WHILE", "DO", "REPEAT")


@dataclass(eq=False)
class Flow:
    """By index of a line (from 0). ``end``: where what begins there ends; ``begin``: the other way round;
    ``next``: from IF, ELSEIF and ELSE to the branch after it; ``loop``: of BREAK and CONTINUE; ``subs``:
    LinuxCNC's subprograms by name; ``heads``: O numbers; ``numbers``: lines by their block number; ``words``:
    name and keyword of each O-word line."""

    end: dict[int, int] = field(default_factory=dict)
    begin: dict[int, int] = field(default_factory=dict)
    next: dict[int, int] = field(default_factory=dict)
    loop: dict[int, int] = field(default_factory=dict)
    subs: dict[str, int] = field(default_factory=dict)
    heads: dict[int, int] = field(default_factory=dict)
    numbers: dict[int, list[int]] = field(default_factory=dict)
    words: dict[int, tuple[str, str]] = field(default_factory=dict)

    def find_line(self, number: int, at: int) -> int:
        """Return the line that a jump from line ``at`` to N``number`` leads to: on to the end of its program,
        then from its start.

        Raises Unread where there is none."""
        edges = sorted(self.heads.values())
        program = bisect_right(edges, at)
        first = edges[program - 1] if program else 0
        last = edges[program] if program < len(edges) else None
        lines = [
            line for line in self.numbers.get(number, []) if first <= line and (last is None or line < last)
        ]
        if not lines:
            raise Unread(say("N{number} stands in no line of this program", number=str(number)))
        return next((line for line in lines if line > at), lines[0])


def without_number(line: str) -> str:
    """Return a line without its block number."""
    found = BLOCK_NUMBER.match(line)
    return line[found.end() :] if found else line


def flow_of(lines: list[str]) -> Flow:
    """Return the structure of a program, its lines without blanks and in capitals. Raises Unread for ends
    without a begin."""
    flow, opened = Flow(), list[tuple[str, str, int]]()
    for at, line in enumerate(lines):
        if line[:1] == "N" and (found := BLOCK_NUMBER.match(line)):
            flow.numbers.setdefault(int(found[1]), []).append(at)
            line = line[found.end() :]
        if line[:1] == "O":
            _o_line(flow, opened, line, at)
        elif "DO" in line and (found := DO.match(line)):
            opened.append((found[1], "MACRO", at))
        elif line[:3] == "END" and (found := END.match(line)):
            _close(flow, opened, found[1], "MACRO", at)
    if opened:
        _, word, at = opened[-1]
        raise Unread(say("{word} has no end", word="DO" if word == "MACRO" else word), at)
    return flow


def _o_line(flow: Flow, opened: list[tuple[str, str, int]], line: str, at: int) -> None:
    found = O_WORD.match(line)
    if not found:
        if head := HEAD.match(line):
            flow.heads.setdefault(int(head[1]), at)
        return
    name, word = found[1].lstrip("0") or "0", found[2]
    flow.words[at] = name, word
    if word == "WHILE" and opened and opened[-1][:2] == (name, "DO"):
        flow.words[at] = name, "UNTIL"
        _close(flow, opened, name, "DO", at)
    elif word in ("SUB", "IF", *LOOPS):
        opened.append((name, word, at))
        if word == "SUB":
            flow.subs.setdefault(name, at)
    elif word in CLOSES:
        _close(flow, opened, name, CLOSES[word], at)
    elif word in ("ELSEIF", "ELSE"):
        begin = _close(flow, opened, name, "IF", at)
        flow.begin[at] = begin
        opened.append((name, "IF", at))
    elif word in ("BREAK", "CONTINUE"):
        loops = [begin for own, kind, begin in opened if own == name and kind in LOOPS]
        if not loops:
            raise Unread(say("{word} stands in no loop of its name", word=word), at)
        flow.loop[at] = loops[-1]


def _close(flow: Flow, opened: list[tuple[str, str, int]], name: str, word: str, at: int) -> int:
    """End what is open; returns where it began."""
    if not opened or opened[-1][:2] != (name, word):
        raise Unread(say("this end has no begin of its name"), at)
    begin = opened.pop()[2]
    flow.begin[at], flow.end[begin], flow.next[begin] = begin, at, at
    return begin
