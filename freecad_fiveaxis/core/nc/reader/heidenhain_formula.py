# SPDX-License-Identifier: LGPL-2.1-or-later
"""Formulas of Q parameters: Q2 + 3 * SIN Q4, +Q2 DIV +2, +3 LEN +4 (Heidenhain TNC 620 and TNC 640, Klartext
Programming)."""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable

from freecad_fiveaxis.core.base.sentences import say

from .expressions import COMMON_FUNCTIONS, NUMBER, Unread
from .expressions import DEEPEST as DEEPEST_BRACKETS

FUNCTION = re.compile(r"ASIN|ACOS|ATAN|SIN|COS|TAN|SQRT|SQ|LN|LOG|EXP|NEG|INT|ABS|FRAC|SGN")
OPERATOR = re.compile(r"DIV|LEN|ANG|[-+*/^%]")
LEVELS: tuple[tuple[str, ...], ...] = (("+", "-"), ("*", "/", "DIV", "%", "LEN", "ANG"), ("^",))
OPERATORS: dict[str, Callable[[float, float], float]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv, "DIV": operator.truediv,
    "^": math.pow,
    "%": math.fmod, "LEN": math.hypot, "ANG": lambda a, b: math.degrees(math.atan2(a, b)),
}  # fmt: skip
FUNCTIONS: dict[str, Callable[[float], float]] = COMMON_FUNCTIONS | {
    "SQ": lambda a: a * a, "LOG": math.log10, "NEG": operator.neg,
    "INT": lambda a: float(math.trunc(a)), "FRAC": lambda a: a - math.trunc(a),
    "SGN": lambda a: -1.0 if a < 0.0 else 1.0,
}  # fmt: skip
SIGN, OPEN, CLOSE, PI = (re.compile(one) for one in (r"[-+]", r"\(", r"\)", "PI"))
NAME = re.compile(r"Q([LR]?[0-9]+)")


class Formula:
    """A formula without blanks, worked out as it is read."""

    def __init__(self, text: str, known: Callable[[str], float]) -> None:
        self.text, self.known, self.at, self.depth = text, known, 0, 0

    def rest(self) -> str:
        """Return what is not yet read."""
        return self.text[self.at :]

    def match(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        """Return what stands here, which is then read."""
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
        """Return a value with its sign."""
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
                raise Unread(
                    say("{missing} is missing before {rest}", missing="')'", rest=repr(self.rest()[:20]))
                )
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
