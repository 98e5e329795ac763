# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext programs with Q parameters, labels and drilling cycles, run in bounds: plain blocks in the order in which the control
comes to them.

Q1 = Q2 + 3 * SIN Q4     formulas, and FN 0 to FN 8, FN 13 with DIV, LEN, ANG; QL and QR parameters. L X+Q1 FQ2: words by value.
FN 9 to FN 12            IF +Q1 EQU +Q2 GOTO LBL 5: EQU, NE, GT, LT.
CALL LBL 1               to LBL 0 and back; with REP 3 the section from LBL 1 to the call runs three times more.
CYCL DEF 200, 203        with CYCL CALL or M99: down by Q202 at F Q206, between up to Q200 over the surface (FMAX) and down again
                         to Q200 over the depth reached, at last up to Q200 or Q204; 203 leaves the hole at Q208 (FMAX where 0).
Q120, Q121, Q122         the axes' words for the last PLANE (:mod:`.plane_parameters`).

One that was never set only the control knows. Sources: Heidenhain TNC 620 and TNC 640, Klartext Programming, Q parameters,
subprograms and program section repeats. The moves of the cycles were written without their manual at hand: check them on the
control.
"""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine.kinematics import Chain

from .expressions import DEEPEST as DEEPEST_BRACKETS
from .expressions import NUMBER, Unread
from .interpreter import BETWEEN, MOST, Refused, Written, deeper, endless, refusal_of
from .plane_parameters import NAMES, READS, PlaneParameters

MARK = re.compile(rb"\bFN *[0-9]+ *:|\bQ[LR]?[0-9]+ *=|\bCALL +LBL\b|[-+ ]Q[LR]?[0-9]|\bCYCL +CALL\b|M99")
"""What shows that a text has parameters, calls or cycles."""
SIGNS = (b"Q", b"CALL", b"M99")
CONTINUED = re.compile(rb"[^\n]*~ *\n(?:[^\n]*~ *\n)*[^\n]*")
NUMBERED = re.compile(r"^ *[0-9]+(?= *[A-Z*])")
SETS = re.compile(r"(?:FN(?:[0-8]|13):)?Q([LR]?[0-9]+)=(.*)")
JUMP = re.compile(r"FN(9|10|11|12):IF(.*?)(EQU|NE|GT|LT)(.*)GOTOLBL(.*)")
LABEL = re.compile(r'LBL("[^"]*"|[0-9]+)$')
CALL = re.compile(r'CALLLBL("[^"]*"|[0-9]+)(?:REP([0-9]+)(?:/[0-9]+)?)?$')
CYCLE = re.compile(r"CYCLDEF(200|203)(?![0-9.])")
OTHER_CYCLE = re.compile(r"CYCLDEF([0-9]+)")
CALLED = re.compile(r"M0*99(?![0-9])")
CYCLE_WORD = re.compile(rf"Q([0-9]+)=([-+]?(?:{NUMBER.pattern}))")
WORD = re.compile(r"(?<![A-Z0-9])([A-Z]+) *([-+]?) *Q([LR]?[0-9]+)(?! *=)")
NO_WORDS = ("TOOL", "BLK", "FN", "CALL", "SEL", "TCH", "PATTERN", "FUNCTION", "STOP")
"""How lines begin whose parameters lead no axis."""
SETS_UNKNOWN = re.compile(r"FN.*Q[LR]?[0-9]+=|Q[LR]?[0-9]+=")
FEED = re.compile(r"(?<![A-Z])F *([0-9]+\.?[0-9]*)")
FUNCTION = re.compile(r"ASIN|ACOS|ATAN|SIN|COS|TAN|SQRT|SQ|LN|LOG|EXP|NEG|INT|ABS|FRAC|SGN")
OPERATOR = re.compile(r"DIV|LEN|ANG|[-+*/^%]")
LEVELS: tuple[tuple[str, ...], ...] = (("+", "-"), ("*", "/", "DIV", "%", "LEN", "ANG"), ("^",))
OPERATORS: dict[str, Callable[[float, float], float]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "DIV": operator.truediv, "^": math.pow,
    "%": math.fmod, "LEN": math.hypot, "ANG": lambda a, b: math.degrees(math.atan2(a, b)),
}  # fmt: skip
FUNCTIONS: dict[str, Callable[[float], float]] = {
    "SIN": lambda a: math.sin(math.radians(a)), "COS": lambda a: math.cos(math.radians(a)),
    "TAN": lambda a: math.tan(math.radians(a)), "ASIN": lambda a: math.degrees(math.asin(a)),
    "ACOS": lambda a: math.degrees(math.acos(a)), "ATAN": lambda a: math.degrees(math.atan(a)), "SQRT": math.sqrt,
    "SQ": lambda a: a * a, "LN": math.log, "LOG": math.log10, "EXP": math.exp, "NEG": operator.neg,
    "INT": lambda a: float(math.trunc(a)), "ABS": abs, "FRAC": lambda a: a - math.trunc(a),
    "SGN": lambda a: -1.0 if a < 0.0 else 1.0,
}  # fmt: skip
RELATIONS: dict[str, Callable[[float, float], bool]] = {
    "EQU": operator.eq, "NE": operator.ne, "GT": operator.gt, "LT": operator.lt,
}  # fmt: skip
LARGEST = 1e10
NEEDED = ("200", "201", "202", "203", "206")
MOST_PECKS = 10_000


def marked(text: bytes) -> bool:
    """Whether a text, in capitals, has parameters, calls or cycle calls."""
    return bool(any(sign in text for sign in SIGNS) and MARK.search(text))


def written_out(text: bytes, progress: Progress = silent, kinematics: Chain | None = None) -> Written | Refused:
    """The text, in capitals and without comments, as the control of that machine runs it. Raises ProgramError for what does not
    end."""
    if b"~" in text:
        text = CONTINUED.sub(_one_line, text)
    rows = text.decode("latin-1").split("\n")
    planes = PlaneParameters(kinematics) if kinematics is not None and READS.search(text) else None
    run = Run(rows, progress, planes)
    if refusal := refusal_of(run):
        return refusal
    source = np.array([0, *(at + 1 for at, _ in run.made)], np.int64)
    findings = tuple(planes.findings) if planes else ()
    return Written("\n".join(row for _, row in run.made).encode("latin-1"), source, findings)


def _one_line(found: re.Match[bytes]) -> bytes:
    first, *others = found[0].split(b"\n")
    whole = b" ".join([first, *others]).replace(b"~", b" ")
    return whole + b"\n" * len(others)


@dataclass(eq=False)
class Section:
    """A call from line ``back`` - 1; ``left``: how often its section still runs; -1: a subprogram, which ends in LBL 0."""

    back: int
    left: int = -1


@dataclass(eq=False)
class Cycle:
    """A drilling cycle that was defined: its number, and its Q words."""

    number: str
    words: dict[str, float] = field(default_factory=dict)


class Run:
    """One run over ``rows``: ``made`` (line, its text) so far, ``at`` the line that runs."""

    def __init__(self, rows: list[str], progress: Progress, planes: PlaneParameters | None = None) -> None:
        self.rows, self.progress = [NUMBERED.sub("", row, count=1) for row in rows], progress
        self.lines = [row.replace(" ", "") for row in self.rows]
        self.labels = {found[1]: at for at, line in reversed([*enumerate(self.lines)]) if (found := LABEL.match(line))}
        words = ("Q", "LBL", "CYCL", "M", *(("PLANE",) if planes else ()))
        self.plain = [not any(word in line for word in words) for line in self.lines]
        self.planes = planes
        self.known: dict[str, float] = {}
        self.calls, self.repeats = list[Section](), dict[int, int]()
        self.cycle: Cycle | None = None
        self.feed, self.at, self.ended = "", 0, False
        self.made: list[tuple[int, str]] = []

    def run(self) -> None:
        """Run to the end. Raises Unread, ProgramError."""
        count, most = 0, MOST + len(self.rows)
        while not self.ended and self.at < len(self.rows):
            count += 1
            if not count % BETWEEN:
                self.progress("reading NC", 0.0)
                if count > most or len(self.made) > most:
                    endless(self.at, most)
            if self.plain[self.at]:
                self._put(self.rows[self.at])
                self.at += 1
            else:
                self.at = self._step(self.lines[self.at])

    def _put(self, row: str) -> None:
        if "F" in row and (found := FEED.search(row)):
            self.feed = found[1]
        self.made.append((self.at, row))

    def _step(self, line: str) -> int:
        """Run one line; the next one."""
        if found := SETS.fullmatch(line):
            self.known[found[1]] = self._value(found[2])
        elif found := JUMP.fullmatch(line):
            if RELATIONS[found[3]](self._value(found[2]), self._value(found[4])):
                return self._label(found[5])
        elif found := CALL.fullmatch(line):
            return self._call(found[1], found[2])
        elif found := LABEL.fullmatch(line):
            return self._back() if found[1] == "0" else self.at + 1
        elif line.startswith("CYCL"):
            self._cycle(line)
        else:
            self._block(line)
        return self.at + 1

    def _label(self, name: str) -> int:
        if name not in self.labels or name == "0":
            raise Unread(say("LBL {label} stands in no line of this program", label=name))
        return self.labels[name]

    def _call(self, name: str, times: str | None) -> int:
        head = self._label(name)
        if times is None:
            deeper(len(self.calls), self.at)
            self.calls.append(Section(self.at + 1))
            return head
        left = self.repeats.get(self.at, int(times))
        if left > 0:
            self.repeats[self.at] = left - 1
            return head
        del self.repeats[self.at]
        return self.at + 1

    def _back(self) -> int:
        """LBL 0: back behind the call; where nothing has called, on."""
        return self.calls.pop().back if self.calls else self.at + 1

    def _block(self, line: str) -> None:
        if SETS_UNKNOWN.match(line):
            raise Unread(say("{rest} is not known here", rest=repr(line[:20])))
        row = self.rows[self.at]
        row = WORD.sub(self._word, row) if "Q" in line and not line.startswith(NO_WORDS) else row
        if self.planes and line.startswith("PLANE"):
            self.known.update(self.planes.tilt(row, self.at, self.made))
        called = CALLED.search(line) and line.startswith(("L", "C")) and self.cycle is not None
        self._put(CALLED.sub("   ", row) if called else row)
        if called:
            self._drill()
        self.ended = bool(re.search(r"(?<![A-Z0-9])M0*(?:2|30)(?![0-9])", row))

    def _word(self, found: re.Match[str]) -> str:
        """A word by value; F by a parameter that was never set stays, and is named as such."""
        letter, sign, name = found[1], found[2], found[3]
        if letter == "F" and name not in self.known:
            return found[0]
        value = self._known(name)
        if not abs(value) < LARGEST:
            raise Unread(say("a value beyond all words"))
        return f"{letter}{value:.10f}" if letter == "F" else f"{letter}{-value if sign == '-' else value:+.10f}"

    def _known(self, name: str) -> float:
        if name not in self.known:
            raise Unread(say("{name} was never set", name=f"Q{name}"))
        if self.planes and name in NAMES.values():
            self.planes.note_read()
        return self.known[name]

    def _value(self, text: str) -> float:
        parser = Formula(text, self._known)
        value = parser.sum()
        if parser.rest():
            raise Unread(say("{rest} is not known here", rest=repr(parser.rest()[:20])))
        return value

    def _cycle(self, line: str) -> None:
        """A cycle that is defined or called; those that are not known stay as they are, and are named."""
        words = {name: float(value) for name, value in CYCLE_WORD.findall(self._with_values())}
        if found := CYCLE.match(line):
            self.cycle = Cycle(found[1], words)
            self.known.update(words)
            self.made.append((self.at, ""))
        elif line.startswith("CYCLCALL") and not line.startswith(("CYCLCALLPO", "CYCLCALLPA")) and self.cycle is not None:
            self._drill()
        else:
            number = OTHER_CYCLE.match(line)
            if number and int(number[1]) >= 200 and number[1] not in DEF_ACTIVE:
                self.cycle = None
            self.known.update(words)
            row = self.rows[self.at]
            self.made.append((self.at, WORD.sub(self._word, row) if number and number[1] == DATUM_SHIFT else row))

    def _with_values(self) -> str:
        """The line of a cycle with numbers for the values told by parameters."""

        def value(found: re.Match[str]) -> str:
            return f"={(-1.0 if found[1] == '-' else 1.0) * self._known(found[2]):+.10f}"

        return re.sub(r"=([-+]?)Q([LR]?[0-9]+)", value, self.lines[self.at])

    def _drill(self) -> None:
        assert self.cycle is not None
        for row in drilled(self.cycle, self.feed):
            self.made.append((self.at, row))


DATUM_SHIFT = "7"
DEF_ACTIVE = ("220", "221", "247", "239")
"""Cycles that are no cycle to be called."""


def drilled(cycle: Cycle, feed: str) -> list[str]:
    """The blocks of one hole, the tool above it; after them F is ``feed`` again. Raises Unread."""
    words = cycle.words
    missing = [name for name in NEEDED if name not in words]
    if missing:
        raise Unread(say("cycle {number} without {name}", number=cycle.number, name=f"Q{missing[0]}"))
    own = [name for name in ("212", "213", "395") if words.get(name, 0.0) != 0.0]
    if own:
        raise Unread(say("cycle {number} with {name} above 0", number=cycle.number, name=f"Q{own[0]}"))
    surface, clear, depth, peck = words["203"], words["200"], words["201"], words["202"]
    if depth == 0.0:
        return []
    if depth > 0.0 or clear < 0.0 or not peck > 0.0:
        raise Unread(say("cycle {number} whose depth is not below 0, or whose infeed is not above it", number=cycle.number))
    steps = min(math.ceil(-depth / peck - 1e-9), MOST_PECKS + 1)
    if steps > MOST_PECKS:
        raise Unread(say("its Q makes too many pecks"))
    up, down = f"L Z{surface + clear:+.6f} FMAX", f"F{words['206']:.6f}"
    rows = [up]
    for step in range(1, steps + 1):
        rows.append(f"L Z{surface + max(depth, -step * peck):+.6f} {down}")
        if step < steps:
            rows += [up, f"L Z{surface - step * peck + clear:+.6f} FMAX"]
    out = words.get("208", 0.0) if cycle.number == "203" else 0.0
    rows.append(up if out in (0.0, 99999.0) else f"L Z{surface + clear:+.6f} F{out:.6f}")
    if words.get("204", 0.0) > clear:
        rows.append(f"L Z{surface + words['204']:+.6f} FMAX")
    return [*rows, f"L F{feed}"] if feed else rows


class Formula:
    """A formula without blanks, worked out as it is read."""

    def __init__(self, text: str, known: Callable[[str], float]) -> None:
        self.text, self.known, self.at, self.depth = text, known, 0, 0

    def rest(self) -> str:
        """What is not yet read."""
        return self.text[self.at :]

    def match(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        """What stands here, which is then read."""
        found = pattern.match(self.text, self.at)
        self.at = found.end() if found else self.at
        return found

    def sum(self, level: int = 0) -> float:
        """Values with operators of this level and those that bind more."""
        if level == len(LEVELS):
            return self.value()
        left = self.sum(level + 1)
        while (found := OPERATOR.match(self.text, self.at)) and found[0] in LEVELS[level]:
            self.at = found.end()
            left = OPERATORS[found[0]](left, self.sum(level + 1))
        return left

    def value(self) -> float:
        """A value with its sign."""
        self.depth += 1
        if self.depth > DEEPEST_BRACKETS:
            raise Unread(say("more than {most} brackets in brackets", most=DEEPEST_BRACKETS))
        value = self._value()
        self.depth -= 1
        return value

    def _value(self) -> float:
        if found := self.match(SIGN):
            return -self.value() if found[0] == "-" else self.value()
        if self.match(OPEN):
            value = self.sum()
            if not self.match(CLOSE):
                raise Unread(say("{missing} is missing before {rest}", missing="')'", rest=repr(self.rest()[:20])))
            return value
        if found := self.match(NUMBER):
            return float(found[0])
        if found := self.match(NAME):
            return self.known(found[1])
        if self.match(PI):
            return math.pi
        if found := self.match(FUNCTION):
            return FUNCTIONS[found[0]](self.value())
        raise Unread(say("no value: {rest}", rest=repr(self.rest()[:20])))


SIGN, OPEN, CLOSE, PI = (re.compile(one) for one in (r"[-+]", r"\(", r"\)", "PI"))
NAME = re.compile(r"Q([LR]?[0-9]+)")
