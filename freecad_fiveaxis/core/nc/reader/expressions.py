# SPDX-License-Identifier: LGPL-2.1-or-later
"""Expressions of NC programs: parsed once into functions of the variables, never handed to Python itself.

value     a number, a variable (#1, #[#2+1], #<name>), an expression in brackets, a function of one (SIN[..],
          ATAN[..]/[..]).
dialect   LinuxCNC: AND, OR, XOR are logical and bind least; FIX and FUP go down and up; a variable that was
          never set is 0, one with a name is an error. Fanuc, Haas: bitwise, AND binds as *, OR and XOR as +;
          FIX goes to zero, FUP from it; a variable that was never set is vacant, and a word with it is left
          out.

ATAN[y]/[x]  LinuxCNC: from -180 to 180. Fanuc: from 0 to 360 with parameter 6004#0 (NAT) = 0, its default:
             #1=ATAN[-1]/[-1] is 225.0, the example of Fanuc's manuals (custom macro, arithmetic and logic
             operation), read where others quote it; with NAT = 1 as LinuxCNC's. Haas is taken to do as Fanuc
             does: its page was not at hand.

Angles in degrees. Sources: LinuxCNC 2.9, G-code overview; Fanuc B-63324EN, 15.4 (custom macro); Haas mill
operator's manual.
"""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable
from dataclasses import dataclass, field

from freecad_fiveaxis.core.base.sentences import say

NUMBER = re.compile(r"\d+\.?\d*|\.\d+")
NAME = re.compile(r"<([^<>]*)>")
FUNCTION = re.compile(r"(SIN|COS|TAN|ASIN|ACOS|ATAN|SQRT|SQR|EXP|LN|ABS|FIX|FUP|ROUND|EXISTS)(?=[\[#])")
OPERATOR = re.compile(r"\*\*|[-+*/]|MOD|EQ|NE|GT|GE|LT|LE|AND|OR|XOR")
DEEPEST = 50
"""Brackets in brackets."""
LARGEST = 1e15
EQUAL = 1e-4
"""Numbers that EQ takes as one on LinuxCNC."""
Value = float | None
"""None: vacant."""


class Unread(Exception):
    """What is not understood, and why, in the line of index ``at`` (-1: the one that runs); the whole program
    is then named as not interpreted."""

    def __init__(self, reason: str, at: int = -1) -> None:
        super().__init__(reason)
        self.reason, self.at = reason, at


@dataclass(eq=False)
class Variables:
    """``own`` and ``own_named``: of the subprogram that runs; ``shared``, ``shared_named``: of all.
    ``fanuc``: whose ways."""

    fanuc: bool = False
    own: dict[int, Value] = field(default_factory=dict)
    shared: dict[int, Value] = field(default_factory=dict)
    own_named: dict[str, float] = field(default_factory=dict)
    shared_named: dict[str, float] = field(default_factory=dict)

    def number(self, key: float) -> int:
        """Return the number of a variable."""
        if not (abs(key - round(key)) < EQUAL and 0 <= key < 1e6):
            raise Unread(say("a variable of no whole number"))
        return round(key)

    def read(self, key: int) -> Value:
        """Return the value of ``#key``. Raises Unread for one that only the machine knows."""
        if key <= (33 if self.fanuc else 30):
            return self.own.get(key, None if self.fanuc else 0.0)
        if key not in self.shared and (key >= 500 if self.fanuc else key >= 5061):
            raise Unread(say("#{key} is known only at the machine", key=str(key)))
        return self.shared.get(key, None if self.fanuc else 0.0)

    def write(self, key: int, value: Value) -> None:
        """Set ``#key``. Raises Unread where that changes what the machine does."""
        if key == 0:
            raise Unread(say("#0 takes no value"))
        if key <= (33 if self.fanuc else 30):
            self.own[key] = value
        elif (1000 <= key < 10000 and key not in WITHOUT_EFFECT) if self.fanuc else 5061 <= key < 5603:
            raise Unread(say("#{key} sets the machine", key=str(key)))
        else:
            self.shared[key] = value

    def find_store(self, name: str) -> dict[str, float]:
        """Where a variable of that name lives."""
        return self.shared_named if name.startswith("_") else self.own_named


WITHOUT_EFFECT = (3001, 3002, 3003, 3004, 3006)
"""Fanuc's timers, single block and feed hold, message with a stop."""
Expression = Callable[[Variables], Value]


def number(value: Value) -> float:
    """Return a vacant one counts as 0."""
    return 0.0 if value is None else value


class Parser:
    """Over one line without blanks, in capitals; ``at`` moves on."""

    def __init__(self, text: str, fanuc: bool, at: int = 0) -> None:
        self.text, self.fanuc, self.at, self.depth = text, fanuc, at, 0
        self.levels = FANUC_LEVELS if fanuc else LINUXCNC_LEVELS

    def rest(self) -> str:
        """Return what is not yet read."""
        return self.text[self.at :]

    def takes(self, start: str) -> bool:
        """Whether the text goes on with ``start``, which is then read."""
        found = self.text.startswith(start, self.at)
        self.at += len(start) * found
        return found

    def needs(self, start: str) -> None:
        """Read ``start``. Raises Unread where it does not stand here."""
        if not self.takes(start):
            raise Unread(
                say("{missing} is missing before {rest}", missing=repr(start), rest=repr(self.rest()[:20]))
            )

    def match(self, pattern: re.Pattern[str]) -> str | None:
        """Return the text of the pattern here, which is then read."""
        found = pattern.match(self.text, self.at)
        self.at = found.end() if found else self.at
        return found[0] if found else None

    def value(self) -> Expression:
        """Return a value with its sign."""
        if self.takes("-"):
            inner = self.value()
            return lambda known: -number(inner(known))
        self.takes("+")
        if self.takes("#"):
            return self.variable()[0]
        if self.takes("["):
            return self.parse_bracket()
        if name := self.match(FUNCTION):
            return self.function(name)
        if text := self.match(NUMBER):
            literal = float(text)
            return lambda known: literal
        raise Unread(say("no value: {rest}", rest=repr(self.rest()[:20])))

    def parse_bracket(self) -> Expression:
        """Return what stands up to the closing bracket."""
        self.depth += 1
        if self.depth > DEEPEST:
            raise Unread(say("more than {most} brackets in brackets", most=DEEPEST))
        inner = self.expression()
        self.needs("]")
        self.depth -= 1
        return inner

    def variable(self) -> tuple[Expression, Callable[[Variables, Value], None]]:
        """How a variable is read and written; the # is read already."""
        if found := NAME.match(self.text, self.at):
            self.at = found.end()
            return _access_variable(found[1])
        self.depth += 1
        if self.depth > DEEPEST:
            raise Unread(say("more than {most} brackets in brackets", most=DEEPEST))
        key = self.value()
        self.depth -= 1
        return (
            lambda known: known.read(known.number(number(key(known)))),
            lambda known, value: known.write(known.number(number(key(known))), value),
        )

    def function(self, name: str) -> Expression:
        """Return a function with its arguments; its name is read already."""
        if name == "EXISTS":
            return self.exists()
        inner = self.value()
        if name == "ATAN" and self.takes("/"):
            other, turn = self.value(), 360.0 if self.fanuc else 0.0
            return lambda known: _direction(number(inner(known)), number(other(known)), turn)
        table = FANUC_FUNCTIONS if self.fanuc else FUNCTIONS
        work = table[name]
        return lambda known: work(number(inner(known)))

    def exists(self) -> Expression:
        """Whether a variable of that name was set."""
        self.needs("[#")
        found = NAME.match(self.text, self.at)
        if not found:
            raise Unread(say("EXISTS of a variable without a name"))
        self.at, name = found.end(), found[1]
        self.needs("]")
        return lambda known: float(name in known.find_store(name))

    def expression(self, level: int = 0) -> Expression:
        """Values with operators of this level and those that bind more."""
        if level == len(self.levels):
            return self.value()
        left = self.expression(level + 1)
        while name := self.operator(level):
            left = self.join_operands(name, left, self.expression(level + 1))
        return left

    def operator(self, level: int) -> str | None:
        """Read the next operator of that level; None, and nothing read, where there is none."""
        found = OPERATOR.match(self.text, self.at)
        if found is None or found[0] not in self.levels[level]:
            return None
        self.at = found.end()
        return found[0]

    def join_operands(self, name: str, left: Expression, right: Expression) -> Expression:
        """Return the two with an operator between them."""
        if self.fanuc and name in ("EQ", "NE"):
            equal = name == "EQ"
            return lambda known: float((left(known) == right(known)) is equal)
        work = (FANUC_OPERATORS if self.fanuc else OPERATORS)[name]
        return lambda known: work(number(left(known)), number(right(known)))


def _access_variable(name: str) -> tuple[Expression, Callable[[Variables, Value], None]]:
    def read(known: Variables) -> Value:
        if name not in known.find_store(name):
            raise Unread(say("{name} was never set", name=_show_name(name)))
        return known.find_store(name)[name]

    def write(known: Variables, value: Value) -> None:
        known.find_store(name)[name] = number(value)

    return read, write


def _show_name(name: str) -> str:
    """Return a name as the program writes it: Siemens' R1 and names of variables (:mod:`.siemens_names`), or
    LinuxCNC's."""
    if re.fullmatch("_R[0-9]+", name):
        return name[1:]
    return name.partition(".")[2].upper() if name.startswith(("v.", "_g.")) else f"#<{name.lower()}>"


def _whole(value: float) -> int:
    return round(value)


def _direction(y: float, x: float, turn: float) -> float:
    """Return the angle of a direction, deg: from -180 to 180, or from 0 to below ``turn``."""
    angle = math.degrees(math.atan2(y, x))
    return angle + turn if angle < 0.0 else angle


def _power(a: float, b: float) -> float:
    result = a**b
    if isinstance(result, complex):
        raise ValueError
    return float(result)


LINUXCNC_LEVELS = (
    ("AND", "OR", "XOR"),
    ("EQ", "NE", "GT", "GE", "LT", "LE"),
    ("+", "-"),
    ("*", "/", "MOD"),
    ("**",),
)
FANUC_LEVELS = (("EQ", "NE", "GT", "GE", "LT", "LE"), ("+", "-", "OR", "XOR"), ("*", "/", "MOD", "AND"))
_COMMON: dict[str, Callable[[float, float], float]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "**": _power,
    "GT": lambda a, b: float(a > b), "GE": lambda a, b: float(a >= b),
    "LT": lambda a, b: float(a < b), "LE": lambda a, b: float(a <= b),
}  # fmt: skip
OPERATORS: dict[str, Callable[[float, float], float]] = _COMMON | {
    "MOD": lambda a, b: math.fmod(a, b) + abs(b) * (math.fmod(a, b) < 0.0), "EQ": lambda a,
    b: float(abs(a - b) < EQUAL),
    "NE": lambda a, b: float(abs(a - b) >= EQUAL), "AND": lambda a, b: float(a != 0.0 and b != 0.0),
    "OR": lambda a, b: float(a != 0.0 or b != 0.0), "XOR": lambda a, b: float((a != 0.0) != (b != 0.0)),
}  # fmt: skip
FANUC_OPERATORS: dict[str, Callable[[float, float], float]] = _COMMON | {
    "MOD": math.fmod, "AND": lambda a, b: float(_whole(a) & _whole(b)), "OR": lambda a,
    b: float(_whole(a) | _whole(b)),
    "XOR": lambda a, b: float(_whole(a) ^ _whole(b)),
}  # fmt: skip
COMMON_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "SIN": lambda a: math.sin(math.radians(a)), "COS": lambda a: math.cos(math.radians(a)),
    "TAN": lambda a: math.tan(math.radians(a)), "ASIN": lambda a: math.degrees(math.asin(a)),
    "ACOS": lambda a: math.degrees(math.acos(a)), "ATAN": lambda a: math.degrees(math.atan(a)),
    "SQRT": math.sqrt, "EXP": math.exp, "LN": math.log, "ABS": abs,
}  # fmt: skip
"""Angles in degrees."""
FUNCTIONS: dict[str, Callable[[float], float]] = COMMON_FUNCTIONS | {
    "SQR": math.sqrt, "FIX": lambda a: float(math.floor(a)),
    "FUP": lambda a: float(math.ceil(a)), "ROUND": lambda a: math.copysign(math.floor(abs(a) + 0.5), a),
}  # fmt: skip
FANUC_FUNCTIONS: dict[str, Callable[[float], float]] = FUNCTIONS | {
    "FIX": lambda a: float(math.trunc(a)), "FUP": lambda a: math.copysign(math.ceil(abs(a)), a),
}  # fmt: skip
