# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext programs with Q parameters, labels and drilling cycles, run in bounds: plain blocks in the order
in which the control comes to them.

Q1 = Q2 + 3 * SIN Q4     formulas, and FN 0 to FN 8, FN 13 with DIV, LEN, ANG; QL and QR parameters. L X+Q1
                         FQ2: words by value.
FN 9 to FN 12            IF +Q1 EQU +Q2 GOTO LBL 5: EQU, NE, GT, LT.
CALL LBL 1               to LBL 0 and back; with REP 3 the section from LBL 1 to the call runs three times
                         more.
CALL PGM NAME.H          to its end and back, where a folder has the file (:mod:`.called_klartext`).
CYCL DEF 200 ...         with CYCL CALL or M99: the drilling cycles of :mod:`.heidenhain_cycles`.
Q120, Q121, Q122         the axes' words for the last PLANE or cycle 19 (:mod:`.plane_parameters`).

One that was never set only the control knows. Sources: Heidenhain TNC 620 and TNC 640, Klartext Programming,
Q parameters, subprograms and program section repeats.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import say

from .called_klartext import PROGRAM, RETURN, with_called_programs
from .codes import CYCLE_KIND, INCH
from .expressions import NUMBER, Unread
from .heidenhain_cycles import Around, Cycle, place_before, write_hole
from .heidenhain_formula import Formula
from .interpreter import BETWEEN, MOST, Refused, Written, deeper, endless, refusal_of
from .of_machine import NO_MACHINE, OfMachine
from .old_working_plane import LINE as OLD_PLANE
from .plane_parameters import NAMES, READS, PlaneParameters

MARK = re.compile(
    rb"\bFN *[0-9]+ *:|\bQ[LR]?[0-9]+ *=|\bCALL +(?:LBL|PGM)\b|[-+ ]Q[LR]?[0-9]|\bCYCL +CALL\b|M99"
)
"""What shows that a text has parameters, calls or cycles."""
SIGNS = (b"Q", b"CALL", b"M99")
CONTINUED = re.compile(rb"[^\n]*~ *\n(?:[^\n]*~ *\n)*[^\n]*")
LOOSE = re.compile(
    rb"^ *(?:[0-9]+ +)?CYCL +DEF +2[0-9][0-9](?![0-9.])[^\n]*(?:\n *)*\n *Q[0-9]{3} *=[^\n]*"
    rb"(?:(?:\n *)*\n *Q[0-9]{3} *=[^\n]*)*",
    re.MULTILINE,
)
"""A cycle whose words stand in lines of their own without ~ and without a number, as posts write them. They
set Q parameters that the cycle reads: the same for a control that takes them as formulas."""
NUMBERED = re.compile(r"^ *[0-9]+(?= *[A-Z*])")
SETS = re.compile(r"(?:FN(?:[0-8]|13):)?Q([LR]?[0-9]+)=(.*)")
JUMP = re.compile(r"FN(9|10|11|12):IF(.*?)(EQU|NE|GT|LT)(.*)GOTOLBL(.*)")
LABEL = re.compile(r'LBL("[^"]*"|[0-9]+)$')
CALL = re.compile(r'CALLLBL("[^"]*"|[0-9]+)(?:REP([0-9]+)(?:/[0-9]+)?)?$')
CYCLE = re.compile(r"CYCLDEF(20[0-35-9]|24[01])(?![0-9.])")
OLD_CYCLE = re.compile(r"CYCLDEF(1|2|17)\.([0-9])(.*)")
LAST_NUMBER = re.compile(rf"[-+]?(?:{NUMBER.pattern})$")
SPEED = re.compile(r"(?<![A-Z0-9])S *([0-9]+\.?[0-9]*)")
RADIUS = re.compile(r"(?<![A-Z0-9])DR *([-+]?[0-9]+\.?[0-9]*)")
OTHER_CYCLE = re.compile(r"CYCLDEF([0-9]+)")
CALLED = re.compile(r"M0*99(?![0-9])")
IN_INCHES = re.compile(r" *BEGIN +PGM\b.*\bINCH *$")
FASTEST = "=99999"
"""How a cycle's feed that is MAX counts (:data:`.heidenhain_cycles.FREE`)."""
CYCLE_WORD = re.compile(rf"Q([0-9]+)=([-+]?(?:{NUMBER.pattern}))")
WORD = re.compile(r"(?<![A-Z0-9])([A-Z]+) *([-+]?) *Q([LR]?[0-9]+)(?! *=)")
NO_WORDS = ("TOOL", "BLK", "FN", "CALL", "SEL", "TCH", "PATTERN", "FUNCTION", "STOP", "QS", "DECLARE")
"""How lines begin whose parameters lead no axis."""
SETS_UNKNOWN = re.compile(r"FN.*Q[LR]?[0-9]+=|Q[LR]?[0-9]+=")
OF_STRING = re.compile(r"TONUMB|INSTR|STRLEN|STRCOMP|SYSSTR|SRC_|QS[0-9]")
"""A value that is read from a string: not known from there on."""
FEED = re.compile(r"(?<![A-Z])F *([0-9]+\.?[0-9]*)")
RELATIONS: dict[str, Callable[[float, float], bool]] = {
    "EQU": operator.eq, "NE": operator.ne, "GT": operator.gt, "LT": operator.lt,
}  # fmt: skip
LARGEST = 1e10


def has_parameters(text: bytes) -> bool:
    """Whether a text, in capitals, has parameters, calls or cycle calls."""
    return bool(any(sign in text for sign in SIGNS) and MARK.search(text))


def run_heidenhain(
    text: bytes, progress: Progress = silent, of_machine: OfMachine = NO_MACHINE
) -> Written | Refused:
    """Return the text, in capitals and without comments, as the control of that machine runs it. Raises
    ProgramError for what does not end."""
    try:
        text, own = with_called_programs(text, of_machine.search)
    except Unread as unread:
        return Refused(unread.at + 1, unread.reason)
    if b"~" in text:
        text = CONTINUED.sub(_one_line, text)
    text = LOOSE.sub(_one_line, text) if b"CYCL" in text else text
    rows = text.decode("latin-1").split("\n")
    kinematics = of_machine.kinematics
    planes = PlaneParameters(kinematics) if kinematics is not None and READS.search(text) else None
    run = Run(rows, progress, planes, of_machine.diameters, own)
    if refusal := refusal_of(run):
        return replace(refusal, line=run.find_line() + 1)
    source = np.array([0, *(at + 1 for at, _ in run.output)], np.int64)
    findings = (*run.unread.values(), *(planes.findings if planes else ()))
    return Written("\n".join(row for _, row in run.output).encode("latin-1"), source, findings)


def _one_line(found: re.Match[bytes]) -> bytes:
    first, *others = found[0].split(b"\n")
    whole = b" ".join([first, *others]).replace(b"~", b" ")
    return whole + b"\n" * len(others)


@dataclass(eq=False)
class Section:
    """A call from line ``back`` - 1; ``left``: how often its section still runs; -1: a subprogram, which ends
    in LBL 0; ``program``: of a file of its own."""

    back: int
    left: int = -1
    program: bool = False


def _write(value: float, sign: str = "") -> str:
    """Return a number without the zeros behind it that say nothing."""
    return f"{value:{sign}.10f}".rstrip("0").rstrip(".")


class Run:
    """One run over ``rows``: ``output`` (line, its text) so far, ``at`` the line that runs."""

    def __init__(
        self,
        rows: list[str],
        progress: Progress,
        planes: PlaneParameters | None,
        diameters: Mapping[int, float],
        own: int,
    ) -> None:
        self.rows, self.progress = [NUMBERED.sub("", row, count=1) for row in rows], progress
        self.lines = [row.replace(" ", "") for row in self.rows]
        self.labels = {
            found[1]: at for at, line in reversed([*enumerate(self.lines)]) if (found := LABEL.match(line))
        }
        words = ("Q", "LBL", "CYCL", "M", *(("PLANE",) if planes else ()))
        self.plain = [not any(word in line for word in words) for line in self.lines]
        self.planes, self.own = planes, own
        self.known: dict[str, float] = {}
        self.calls, self.repeats = list[Section](), dict[int, int]()
        self.cycle: Cycle | None = None
        self.reshaped = set[str]()
        self.feed, self.at, self.ended = "", 0, False
        self.mm = 1.0 / INCH if any(IN_INCHES.match(row) for row in self.rows) else 1.0
        self.diameters = diameters
        self.diameter: float | None = None
        self.speed: float | None = None
        self.along = "Z"
        self.unread: dict[str, Finding] = {}
        self.output: list[tuple[int, str]] = []

    def run(self) -> None:
        """Run to the end. Raises Unread, ProgramError."""
        count, most = 0, MOST + len(self.rows)
        while not self.ended and self.at < len(self.rows) and self.at != self.own:
            count += 1
            if not count % BETWEEN:
                self.progress("reading NC", 0.0)
                if count > most or len(self.output) > most:
                    endless(self.at, most)
            if self.plain[self.at]:
                self._put(self.rows[self.at])
                self.at += 1
            else:
                self.at = self._step(self.lines[self.at])

    def find_line(self) -> int:
        """Return the index of the line that runs; in a program of another file, of its call in this one."""
        return self.at if self.at < self.own else next(call.back for call in self.calls if call.program) - 1

    def _put(self, row: str) -> None:
        if "TOOL" in row:
            self._tool(row)
        if "F" in row and (found := FEED.search(row)):
            self.feed = found[1]
        self.output.append((self.find_line(), row))

    def _step(self, line: str) -> int:
        """Run one line; the next one."""
        if found := SETS.fullmatch(line):
            self._set(found[1], found[2])
        elif found := JUMP.fullmatch(line):
            if RELATIONS[found[3]](self._value(found[2]), self._value(found[4])):
                return self._label(found[5])
        elif found := CALL.fullmatch(line):
            return self._call(found[1], found[2])
        elif found := LABEL.fullmatch(line):
            return self._back(found[1])
        elif line.startswith("CYCL"):
            self._cycle(line)
        else:
            self._block(line)
        return self.at + 1

    def _set(self, name: str, value: str) -> None:
        """Set a parameter, or forget it where its value comes from a string."""
        if OF_STRING.search(value):
            self.known.pop(name, None)
        else:
            self.known[name] = self._value(value)

    def _label(self, name: str) -> int:
        if name not in self.labels or name == "0":
            raise Unread(say("LBL {label} stands in no line of this program", label=name))
        return self.labels[name]

    def _call(self, name: str, times: str | None) -> int:
        head = self._label(name)
        if times is None:
            deeper(len(self.calls), self.at)
            self.calls.append(Section(self.at + 1, program=name.startswith(PROGRAM)))
            return head
        left = self.repeats.get(self.at, int(times))
        if left > 0:
            self.repeats[self.at] = left - 1
            return head
        del self.repeats[self.at]
        return self.at + 1

    def _back(self, name: str) -> int:
        """LBL 0, or the end of a program that was called: back behind the call; where nothing has called, and
        at other labels, on."""
        while name == RETURN and self.calls and not self.calls[-1].program:
            self.calls.pop()
        ends = bool(self.calls) and name == (RETURN if self.calls[-1].program else "0")
        return self.calls.pop().back if ends else self.at + 1

    def _block(self, line: str) -> None:
        if SETS_UNKNOWN.match(line):
            raise Unread(say("{rest} is not known here", rest=repr(line[:20])))
        row = self.rows[self.at]
        row = WORD.sub(self._word, row) if "Q" in line and not line.startswith(NO_WORDS) else row
        if self.planes and line.startswith("PLANE"):
            self.known.update(self.planes.tilt(row, self.find_line(), self.output))
        called = CALLED.search(line) and line.startswith(("L", "C")) and self.cycle is not None
        self._put(CALLED.sub("   ", row) if called else row)
        if called:
            self._drill()
        self.ended = bool(re.search(r"(?<![A-Z0-9])M0*(?:2|30)(?![0-9])", row))

    def _word(self, found: re.Match[str]) -> str:
        """Return a word by value; F by a parameter that was never set stays, and is named as such."""
        letter, sign, name = found[1], found[2], found[3]
        if letter == "F" and name not in self.known:
            return found[0]
        value = self._read_parameter(name)
        if not abs(value) < LARGEST:
            raise Unread(say("a value beyond all words"))
        return letter + (_write(value) if letter == "F" else _write(-value if sign == "-" else value, "+"))

    def _read_parameter(self, name: str) -> float:
        if name not in self.known:
            raise Unread(say("{name} was never set", name=f"Q{name}"))
        if self.planes and name in NAMES.values():
            self.planes.note_read()
        return self.known[name]

    def _value(self, text: str) -> float:
        parser = Formula(text, self._read_parameter)
        value = parser.sum()
        if parser.rest():
            raise Unread(say("{rest} is not known here", rest=repr(parser.rest()[:20])))
        return value

    def _cycle(self, line: str) -> None:
        """Read a cycle that is defined or called; those that are not known stay as they are, and are
        named."""
        values = self._with_values().replace("=MAX", FASTEST).replace("=FMAX", FASTEST)
        words = {name: float(value) for name, value in CYCLE_WORD.findall(values)}
        if found := CYCLE.match(line):
            self.cycle = Cycle(found[1], words)
            self.known.update(words)
            self.output.append((self.find_line(), ""))
        elif found := OLD_CYCLE.match(line):
            self._old_cycle(found[1], found[2], found[3])
        elif (
            line.startswith("CYCLCALL")
            and not line.startswith(("CYCLCALLPO", "CYCLCALLPA"))
            and self.cycle is not None
        ):
            self._drill()
        else:
            number = OTHER_CYCLE.match(line)
            if number and number[1] in RESHAPES:
                self._reshape(number[1], line)
            if number and number[1] not in NEVER_CALLED:
                self.cycle = None
            self.known.update(words)
            row = self.rows[self.at]
            if number and number[1] in WITH_WORDS:
                row = WORD.sub(self._word, row)
            if self.planes and OLD_PLANE.match(row.strip()):
                self.known.update(self.planes.tilt(row, self.find_line(), self.output))
            self.output.append((self.find_line(), row))

    def _reshape(self, number: str, line: str) -> None:
        """Note whether coordinates are mirrored or scaled from here on."""
        if ".1" in line:
            self.reshaped.discard(number)
        if ".1" in line and not AS_IT_IS.fullmatch(line):
            self.reshaped.add(number)

    def _old_cycle(self, number: str, part: str, rest: str) -> None:
        """Read a line of CYCL DEF 1, 2 or 17: 1.0 begins it, the number at the end of the others is a
        word."""
        if part == "0" or self.cycle is None or self.cycle.number != number:
            self.cycle = Cycle(number)
        if part != "0" and (found := LAST_NUMBER.search(rest)):
            self.cycle.words[part] = float(found[0])
        self.output.append((self.find_line(), ""))

    def _tool(self, row: str) -> None:
        """Whose speed and diameter the cycles take from here on."""
        unquoted = re.sub(r'"[^"]*"', "", row)
        speed, radius = SPEED.search(unquoted), RADIUS.search(unquoted)
        self.speed = float(speed[1]) if speed else self.speed
        along = ALONG.search(unquoted)
        self.along = along[1] if along else self.along
        if re.search(r"TOOL +CALL +(?:[0-9\"'Q])", row):
            self.diameter = self.diameters.get(self.at)
            if self.diameter is not None and radius:
                self.diameter += 2.0 * float(radius[1])

    def _with_values(self) -> str:
        """Return the line of a cycle with numbers for the values told by parameters."""

        def value(found: re.Match[str]) -> str:
            return f"={(-1.0 if found[1] == '-' else 1.0) * self._read_parameter(found[2]):+.10f}"

        return re.sub(r"=([-+]?)Q([LR]?[0-9]+)", value, self.lines[self.at])

    def _drill(self) -> None:
        """Drill the hole of the cycle that was defined; where it is not understood, that is found once, and
        its moves are missing."""
        assert self.cycle is not None
        if self.along != "Z":
            reason = say("the tool lies along {axis}, and holes are written along Z alone", axis=self.along)
            self._not_drilled(self.cycle.number, reason)
            return
        if self.reshaped:
            reason = say("the coordinates are mirrored or scaled (CYCL DEF 8, 11, 26)")
            self._not_drilled(self.cycle.number, reason)
            return
        around = Around(self.feed, self.speed, self.diameter, lambda: place_before(self.output), self.mm)
        try:
            rows = write_hole(self.cycle, around)
        except Unread as unread:
            self._not_drilled(self.cycle.number, unread.reason)
            return
        self.output += [(self.find_line(), row) for row in rows]

    def _not_drilled(self, number: str, reason: str) -> None:
        sentence = say(
            "{name} is not written out, and its moves are missing: {reason}. Correct it, or post straight "
            "moves.",
            name=f"CYCL DEF {number}",
            reason=reason,
        )
        self.unread.setdefault(sentence, report_finding(CYCLE_KIND[0], sentence, line=self.find_line() + 1))


ALONG = re.compile(r"TOOL +CALL +(?:(?:[0-9.]+|Q[LRS]?[0-9]+) +)?([XYZ])(?![0-9A-Z])")
"""The axis that the tool lies along, as TOOL CALL tells it."""
WITH_WORDS = ("7", "8", "10", "11", "19", "26")
"""Cycles whose words may be parameters."""
RESHAPES = ("8", "11", "26")
"""Cycles that mirror or scale: what they make of the moves of a cycle is not known here."""
AS_IT_IS = re.compile(r"CYCLDEF(?:8\.1|11\.1SCL\+?1\.?0*|26\.1(?:[CXYZ]+\+?1?\.?0*)*)")
NEVER_CALLED = {"7", "8", "9", "10", "11", "13", "14", "19", "20", "26", "32", "220", "221", "239", "247"}
"""Cycles that work where they are defined, and leave the one that is called as it is."""
