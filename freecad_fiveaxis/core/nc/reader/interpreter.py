# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs with variables, jumps and subprograms, run in bounds: the blocks in the order in which the control
comes to them.

row       a line of the text that is made; each knows the line of the file that it comes from.
bounds    :data:`MOST` lines beyond the program's own, :data:`DEEPEST` calls: what does not end is refused
          with its line.
refusal   one thing that is not understood makes the whole program one that is not interpreted: guessing on is
          no help.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import NoReturn, Protocol

import numpy as np

from freecad_fiveaxis.core.base.errors import FiveAxisError, ProgramError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Ints
from freecad_fiveaxis.core.base.sentences import Option, say

from .called_files import file_of
from .expressions import Unread, Value, Variables, number
from .flow import Flow, flow_of
from .siemens_run import to_o_words, with_calls
from .statements import ARGUMENTS, SPECIAL, Block, Macro, OWord, Statement, Text, statement

MOST = 2_000_000
DEEPEST = 100
BETWEEN = 1 << 14
"""Lines from one look at ``progress`` to the next."""
REPEATS = 1e6


@dataclass(frozen=True, eq=False)
class Written:
    """``text`` with one line a row; ``source`` (rows + 1,) the line of the file of each row, counted from 1,
    0 for row 0; ``findings`` of the run, with lines of the file."""

    text: bytes
    source: Ints
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True)
class Refused:
    """What is not understood in ``line``."""

    line: int
    reason: str


@dataclass(eq=False)
class Frame:
    """A call: the line ``back`` to, the line ``head`` where it begins, how often ``left``, the caller's
    variables, and how often each REPEAT in it still runs. ``macro``: it has variables of its own."""

    back: int = -1
    head: int = -1
    left: int = 0
    own: dict[int, Value] = field(default_factory=dict)
    own_named: dict[str, float] = field(default_factory=dict)
    repeats: dict[int, int] = field(default_factory=dict)
    macro: bool = False
    o_word: bool = False


def run_program(
    text: bytes, fanuc: bool, progress: Progress = silent, siemens: bytes = b"",
    search: tuple[str, ...] = (), origin: Sequence[int] = (),
) -> Written | Refused:  # fmt: skip
    """Return the text, in capitals and without comments, as the control runs it. ``fanuc``: as Fanuc and Haas
    mean it, else LinuxCNC. ``siemens``: with Siemens' variables and jumps; the same with its strings.
    ``search``: folders with the programs called (Siemens). ``origin``: the line of the file, from 0, that
    each line of the text comes from, where that is not its own.

    Raises ProgramError for what does not end."""
    rows = text.split(b"\n")
    try:
        origin = origin or range(len(rows))
        if siemens:
            program = with_calls(rows, siemens.split(b"\n"), search)
            lines, plain, origin = *to_o_words(program), program.source
            rows = [row.encode("latin-1") for row in program.rows]
        else:
            lines = [row.replace(b" ", b"").decode("latin-1") for row in rows]
            plain = [not SPECIAL.search(line) for line in lines]
        flow = _flow_of_file(lines, origin)
    except Unread as refused:
        return Refused(refused.at + 1, refused.reason)
    run = Run(lines, plain, flow, fanuc, progress, origin)
    if refusal := refusal_of(run):
        return replace(refusal, line=origin[refusal.line - 1] + 1)
    written = [rows[at] if row is None else row.encode("latin-1") for at, row in run.output]
    return Written(b"\n".join(written), np.array([0, *(origin[at] + 1 for at, _ in run.output)], np.int64))


def _flow_of_file(lines: list[str], origin: Sequence[int]) -> Flow:
    """Return the structure of the lines. Raises Unread with the line of the file."""
    try:
        return flow_of(lines)
    except Unread as refused:
        raise Unread(refused.reason, origin[refused.at]) from None


class Running(Protocol):
    """A run of a program: ``at`` is the line that runs."""

    at: int

    def run(self) -> None:
        """Run to the end. Raises Unread, ProgramError."""


def refusal_of(run: Running) -> Refused | None:
    """Run to the end; what was not understood, if anything was not. Raises ProgramError for what does not
    end."""
    try:
        run.run()
    except Unread as refused:
        return Refused(run.at + 1, refused.reason)
    except FiveAxisError:
        raise
    except (ArithmeticError, ValueError):
        return Refused(run.at + 1, say("a value that is no number"))
    return None


def endless(at: int, most: int) -> NoReturn:
    """Raise for a program that has run ``most`` lines, and is in that of index ``at``."""
    raise ProgramError(
        say(
            "line {line}: the loop does not end: {most} lines were run; correct its condition, or post the "
            "moves themselves",
            line=at + 1,
            most=most,
        ),
        most,
    )


def deeper(calls: int, at: int) -> None:
    """Raise ProgramError where ``calls`` that have not ended are as many as may be, and one more stands in
    line ``at``."""
    if calls >= DEEPEST:
        raise ProgramError(
            say(
                "line {line}: calls are nested deeper than {most}; does a subprogram call itself? Post the "
                "moves themselves",
                line=at + 1,
                most=DEEPEST,
            ),
            DEEPEST,
        )


class Run:
    """One run: ``output`` (line, its text where that is another) so far, ``at`` the line that runs, and
    ``origin`` the line of the file of each."""

    def __init__(
        self, lines: list[str], plain: list[bool], flow: Flow, fanuc: bool, progress: Progress,
        origin: Sequence[int],
    ) -> None:  # fmt: skip
        self.lines, self.plain, self.flow, self.fanuc, self.progress = lines, plain, flow, fanuc, progress
        self.origin = origin
        self.known, self.frames = Variables(fanuc), [Frame()]
        self.output: list[tuple[int, str | None]] = []
        self.parsed: list[Statement | None] = [None] * len(lines)
        self.at, self.ended = 0, False

    def run(self) -> None:
        """Run to the end. Raises Unread, ProgramError."""
        count, most, plain, output = 0, MOST + len(self.lines), self.plain, self.output
        while not self.ended and self.at < len(plain):
            count += 1
            if not count % BETWEEN:
                self.progress("reading NC", 0.0)
                if count > most:
                    endless(self.origin[self.at], most)
            if plain[self.at]:
                output.append((self.at, None))
                self.at += 1
            else:
                self.at = self._step(self._statement(self.at))

    def _statement(self, at: int) -> Statement:
        known = self.parsed[at]
        if known is None:
            known = self.parsed[at] = statement(self.lines[at], self.flow.words.get(at), self.fanuc)
        return known

    def _step(self, what: Statement) -> int:
        """Run one line; the next one."""
        if isinstance(what, Block):
            return self._block(what)
        if isinstance(what, Text):
            self.output.append((self.at, what.row(self.known)))
            return self.at + 1
        return self._macro(what) if isinstance(what, Macro) else O_WORDS[what.word](self, what)

    def _truth(self, what: OWord | Macro) -> bool:
        value = what.value if isinstance(what, OWord) else what.condition
        return value is None or number(value(self.known)) != 0.0

    def _block(self, what: Block) -> int:
        if what.calls:
            return self._call_by_number(what)
        row, _ = what.row(self.known)
        if row:
            self.output.append((self.at, row))
        what.set(self.known)
        self.ended = what.ends
        return self.at + 1

    def _macro(self, what: Macro) -> int:
        flow, at = self.flow, self.at
        if what.word == "WHILE":
            return at + 1 if self._truth(what) else flow.end[at] + 1
        if what.word == "END":
            return flow.begin[at]
        if what.word == "THEN" and what.then and self._truth(what):
            return self._block(what.then)
        if what.word == "GOTO" and what.to and self._truth(what):
            return flow.find_line(self._count(what.to(self.known)), at)
        return at + 1

    def _count(self, value: Value) -> int:
        """Return a whole number from 0 on."""
        whole = number(value)
        if not 0.0 <= whole < 1e9 or abs(whole - round(whole)) > 1e-6:
            raise Unread(say("{value} is no whole number from 0 on", value=f"{whole:g}"))
        return round(whole)

    def _call_by_number(self, what: Block) -> int:
        """M97, M98, M99 and G65; the other words of the block come before the call."""
        macro = what.calls == "G65"
        if macro and sum(letter == "G" for letter, *_ in what.words) > 1:
            raise Unread(say("a G65 beside another G code"))
        row, values = what.row(self.known, without="".join(ARGUMENTS) + "GPLMNO" if macro else "MPLNQ")
        if row and what.calls != "M99":
            self.output.append((self.at, row))
        what.set(self.known)
        if what.calls == "M99":
            return self._back(values)
        if "Q" in values and not (self.fanuc or macro or "L" in values):
            values["L"] = values.pop("Q")  # Mach3's other word for how often
        if "P" not in values or values["P"] is None or ("Q" in values and not macro):
            raise Unread(say("a call that does not say what by P alone"))
        head, times = self._find_called(self._count(values["P"]), values.get("L"), what.calls == "M97")
        if not times:
            return self.at + 1
        frame = Frame(self.at + 1, head, times - 1, macro=macro)
        if macro:
            given = {ARGUMENTS[letter]: value for letter, value in values.items() if letter in ARGUMENTS}
            return self._enter(frame, given)
        return self._push(frame)

    def _find_called(self, program: int, count: Value, in_here: bool) -> tuple[int, int]:
        """Return the line where what is called begins, ``in_here`` by its block number, and how often it
        runs: ``count``, or the digits before the last four of its number."""
        times = 1 if count is None else self._count(count)
        if in_here:
            return self.flow.find_line(program, self.at), times
        if program not in self.flow.heads and program > 9999 and count is None:
            program, times = program % 10000, program // 10000
        if program not in self.flow.heads:
            raise Unread(
                say(
                    "program O{program} is not in this file; put it there, behind what calls it",
                    program=str(program),
                )
            )
        return self.flow.heads[program] + 1, times

    def _enter(self, frame: Frame, given: dict[int, Value]) -> int:
        """Into a call with variables of its own."""
        frame.own, frame.own_named, frame.macro = self.known.own, self.known.own_named, True
        self.known.own, self.known.own_named = given, {}
        return self._push(frame)

    def _push(self, frame: Frame) -> int:
        deeper(len(self.frames) - 1, self.origin[self.at])
        self.frames.append(frame)
        return frame.head

    def _back(self, values: dict[str, Value]) -> int:
        """M99: once more, or back behind the call, or to the caller's N of its P; in the main program on to N
        of its P, or the end: from the start, or from a line before, the same comes again."""
        if len(self.frames) == 1:
            line = self.flow.find_line(self._count(values["P"]), self.at) if "P" in values else -1
            if line > self.at:
                return line
            self.output.append((self.at, "M99"))
            self.ended = True
            return self.at
        frame = self.frames[-1]
        if frame.left and "P" not in values:
            frame.left -= 1
            return frame.head
        self._pop()
        return self.flow.find_line(self._count(values["P"]), frame.back - 1) if "P" in values else frame.back

    def _pop(self) -> Frame:
        frame = self.frames.pop()
        if frame.macro:
            self.known.own, self.known.own_named = frame.own, frame.own_named
        return frame

    def _sub(self, what: OWord) -> int:
        return self.flow.end[self.at] + 1

    def _call(self, what: OWord) -> int:
        if what.name not in self.flow.subs:
            raise Unread(
                say(
                    "subprogram O{name} is not in this file, and no {file} that holds it was found beside "
                    "it; give the folder of that file with {option}",
                    name=what.name.lower(), file=file_of(what.name), option=Option("search"),
                )
            )  # fmt: skip
        given: dict[int, Value] = {k: value(self.known) for k, value in enumerate(what.arguments, 1)}
        return self._enter(Frame(self.at + 1, self.flow.subs[what.name] + 1, o_word=True), given)

    def _return(self, what: OWord) -> int:
        if not self.frames[-1].o_word:
            raise Unread(say("{word} stands outside of a subprogram", word=what.word))
        result = None if what.value is None else number(what.value(self.known))
        shared = self.known.shared_named
        shared["_VALUE_RETURNED"] = float(result is not None)
        shared["_VALUE"] = 0.0 if result is None else result
        return self._pop().back

    def _if(self, what: OWord) -> int:
        """To the first branch whose condition holds."""
        at, branch = self.at, what
        while not (branch.word in ("ELSE", "ENDIF") or self._truth(branch)):
            at = self.flow.next[at]
            self.at = at
            found = self._statement(at)
            assert isinstance(found, OWord)
            branch = found
        return at + 1

    def _else(self, what: OWord) -> int:
        """Return the branch before ends here: behind the last."""
        at = self.at
        while at in self.flow.next:
            at = self.flow.next[at]
        return at + 1

    def _while(self, what: OWord) -> int:
        return self.at + 1 if self._truth(what) else self.flow.end[self.at] + 1

    def _endwhile(self, what: OWord) -> int:
        return self.flow.begin[self.at]

    def _until(self, what: OWord) -> int:
        return self.flow.begin[self.at] + 1 if self._truth(what) else self.at + 1

    def _repeat(self, what: OWord) -> int:
        times = number(what.value(self.known)) if what.value else 0.0
        if not abs(times) < 1e9:
            raise Unread(say("{value} is no whole number from 0 on", value=f"{times:g}"))
        self.frames[-1].repeats[self.at] = round(times)
        return self.at + 1 if round(times) > 0 else self.flow.end[self.at] + 1

    def _endrepeat(self, what: OWord) -> int:
        begin, repeats = self.flow.begin[self.at], self.frames[-1].repeats
        repeats[begin] = repeats.get(begin, 0) - 1
        return begin + 1 if repeats[begin] > 0 else self.at + 1

    def _break(self, what: OWord) -> int:
        return self.flow.end[self.flow.loop[self.at]] + 1

    def _continue(self, what: OWord) -> int:
        begin = self.flow.loop[self.at]
        return begin if self.flow.words[begin][1] == "WHILE" else self.flow.end[begin]

    def _go_on(self, what: OWord) -> int:
        return self.at + 1


O_WORDS = {
    "SUB": Run._sub, "ENDSUB": Run._return, "RETURN": Run._return, "CALL": Run._call, "IF": Run._if,
    "ELSEIF": Run._else,
    "ELSE": Run._else, "ENDIF": Run._go_on, "WHILE": Run._while, "ENDWHILE": Run._endwhile, "DO": Run._go_on,
    "UNTIL": Run._until, "REPEAT": Run._repeat, "ENDREPEAT": Run._endrepeat, "BREAK": Run._break,
    "CONTINUE": Run._continue,
}  # fmt: skip
