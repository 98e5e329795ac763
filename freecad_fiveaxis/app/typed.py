# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user types into a box: a number, a fraction, a small sum, with units or without.

FreeCAD's own reader of quantities is asked for the size of one unit at a time only: it ends the whole program
over a text as ``45 deg 30'``.

dims    powers of length, angle and time of what is typed; of a plain number they are all 0.
base    mm, degrees and seconds.
"""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Callable
from typing import NamedTuple

import FreeCAD

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import say

from .units import INCH, field_text

Dims = tuple[int, int, int]
NONE, LENGTH, ANGLE, TIME = (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)
MARKS = str.maketrans("′’″”−·×÷", "''\"\"-**/")
"""Signs that are typed or pasted for others."""
TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?(?![.,\d]))"
    r"|(?P<name>[^\W\d_²³]+|°|''|'|\")|(?P<sign>[-+*/^()²³]))"
)
THOUSANDS = re.compile(r"[1-9]\d{0,2}([.,])\d{3}")
LONGEST, DEEPEST, HIGHEST = 200, 20, 4
"""Letters of a text, brackets within each other, and the power of a unit, that are read at most."""


class Value(NamedTuple):
    """A number in base units."""

    number: float
    dims: Dims = NONE


class Kind(NamedTuple):
    """What a box holds. ``refuse`` says that a text is no such thing; ``whole``: only whole numbers are."""

    dims: Dims
    refuse: Callable[[str], str]
    whole: bool = False


KINDS = {
    "length": Kind(LENGTH, lambda text: say("{text} is no length; type one, as 30 mm or 1.5 in", text=text)),
    "angle": Kind(ANGLE, lambda text: say("{text} is no angle; type one, as 30 or 12° 30'", text=text)),
    "feed": Kind((1, 0, -1), lambda text: say("{text} is no feed; type one, as 1000 mm/min", text=text)),
    "turns": Kind((0, 1, -1), lambda text: say("{text} is no rate; type one, as 3600 °/min", text=text)),
    "acceleration": Kind(
        (1, 0, -2), lambda text: say("{text} is no acceleration; type one, as 2000 mm/s²", text=text)
    ),
    "turning": Kind(
        (0, 1, -2), lambda text: say("{text} is no acceleration; type one, as 500 °/s²", text=text)
    ),
    "number": Kind(NONE, lambda text: say("{text} is no number; type one, as 0.5 or 1/2", text=text)),
    "whole": Kind(NONE, lambda text: say("{text} is no whole number; type one, as 5", text=text), True),
}


def read_typed(text: str, kind: str, unit: float = 1.0, point: str = ".", tail: str = "") -> float:
    """Return what was typed, in the unit of a box, which has ``unit`` base units and may stand as ``tail``
    behind the number.

    ``point``: the decimal sign in force; the other one is read too. Raises SettingsError, which says why.
    """
    wanted, plain = KINDS[kind], text.strip()
    if tail.strip() and plain.endswith(tail.strip()):
        plain = plain[: -len(tail.strip())].strip()
    try:
        found = _Reader(plain.translate(MARKS), wanted.dims[1] > 0, point).read()
    except (_NotRead, ArithmeticError):
        raise SettingsError(wanted.refuse(text.strip()), text) from None
    number = found.number if found.dims == NONE else found.number / unit
    good = found.dims in (NONE, wanted.dims) and math.isfinite(number)
    if not good or (wanted.whole and number != int(number)):
        raise SettingsError(wanted.refuse(text.strip()), text)
    return number


def check_range(text: str, number: float, low: float, high: float) -> None:
    """Raise SettingsError for a number that a box does not hold."""
    if not low <= number <= high:
        ends = {"low": field_text(low, 0), "high": field_text(high, 0)}
        raise SettingsError(
            say("{text} is out of range; type {low} to {high}", text=text.strip(), **ends), text
        )


class _NotRead(Exception):
    """What is typed is no sum of numbers and units."""


class _Reader:
    """Reads one text. ``angles``: ' and '' are minutes and seconds, else feet and inches."""

    def __init__(self, text: str, angles: bool, point: str) -> None:
        self.angles, self.point, self.at, self.depth = angles, point, 0, 0
        self.tokens = _tokens(text) if len(text) <= LONGEST else []

    def read(self) -> Value:
        """Return the value of the whole text."""
        value = self.sum()
        if self.at < len(self.tokens):
            raise _NotRead
        return value

    def next(self, *kinds: str) -> str:
        """Return the next token where it is of one of these kinds, or is one of them; else nothing."""
        kind, text = self.tokens[self.at] if self.at < len(self.tokens) else ("", "")
        return text if kind in kinds or text in kinds else ""

    def take(self, *kinds: str) -> str:
        """Return the next token as ``next`` does, and pass it."""
        found = self.next(*kinds)
        self.at += bool(found)
        return found

    def sum(self) -> Value:
        """Return a sum of terms, each with its sign."""
        total = self.read_compound()
        while sign := self.take("+", "-"):
            term = self.read_compound()
            total = _add(total, Value(-term.number, term.dims) if sign == "-" else term)
        return total

    def read_compound(self) -> Value:
        """Return measures behind each other with one sign before all: -5' 3 in."""
        factor = -1.0 if self.take("-") else 1.0
        self.take("+")
        total = self.product()
        while total.dims != NONE and self.next("number"):
            total = _add(total, self.product())
        return Value(factor * total.number, total.dims)

    def product(self) -> Value:
        """Return factors, and units behind numbers: 1/4 in is a quarter of an inch."""
        value = self.read_mixed() or self.factor()
        while True:
            if sign := self.take("*", "/"):
                other = self.factor()
                value = _times(value, other, 1 if sign == "*" else -1)
            elif self.next("name"):
                value = _times(value, self.factor(), 1)
            else:
                return value

    def read_mixed(self) -> Value | None:
        """Return a number with a fraction, as 1 1/4; None where none stands here."""
        kinds = [kind if kind == "number" else text for kind, text in self.tokens[self.at : self.at + 4]]
        if kinds != ["number", "number", "/", "number"]:
            return None
        texts = [text for kind, text in self.tokens[self.at : self.at + 4] if kind == "number"]
        if not all(text.isdigit() for text in texts):
            raise _NotRead
        self.at += 4
        whole, over, under = (float(text) for text in texts)
        return Value(whole + over / under)

    def factor(self) -> Value:
        """Return a number, a unit or what stands in brackets, with its power."""
        base = self.atom()
        power = {"²": 2, "³": 3}.get(self.take("²", "³"), 1)
        if self.take("^"):
            power = self.power()
        if base.dims == NONE:
            return Value(float(base.number**power))
        return Value(base.number**power, _raise_dims(base.dims, power))

    def power(self) -> int:
        """Return a whole number of one figure."""
        sign = -1 if self.take("-") else 1
        text = self.take("number")
        if not text.isdigit() or int(text) > HIGHEST:
            raise _NotRead
        return sign * int(text)

    def atom(self) -> Value:
        """Return a number, a unit, or what stands in brackets."""
        if text := self.take("number"):
            return Value(self.number(text))
        if name := self.take("name"):
            return _unit(name, self.angles)
        self.depth += 1
        if not self.take("(") or self.depth > DEEPEST:
            raise _NotRead
        value = self.sum()
        if not self.take(")"):
            raise _NotRead
        self.depth -= 1
        return value

    def number(self, text: str) -> float:
        """Return a number with either decimal sign. Raises SettingsError where that of thousands could be
        meant."""
        found = THOUSANDS.fullmatch(text)
        if found is not None and found[1] != self.point:
            one, other = text.replace(found[1], ""), text.replace(found[1], self.point)
            raise SettingsError(
                say("{text} can be read in two ways; type {one} or {other}", text=text, one=one, other=other),
                text,
            )
        return float(text.replace(",", "."))


def _tokens(text: str) -> list[tuple[str, str]]:
    """Return the kind and the text of each token."""
    found, at = [], 0
    while at < len(text):
        token = TOKEN.match(text, at)
        if token is None:
            raise _NotRead
        found.append((str(token.lastgroup), token[str(token.lastgroup)]))
        at = token.end()
    return found


def _add(one: Value, other: Value) -> Value:
    if one.dims != other.dims:
        raise _NotRead
    return Value(one.number + other.number, one.dims)


def _times(one: Value, other: Value, power: int) -> Value:
    x, y, z = (mine + power * its for mine, its in zip(one.dims, other.dims, strict=True))
    return Value(one.number * other.number**power, (x, y, z))


def _raise_dims(dims: Dims, power: int) -> Dims:
    x, y, z = (power * one for one in dims)
    return x, y, z


def _unit(name: str, angles: bool) -> Value:
    """Return one of a unit, in base units."""
    marks = {
        "°": Value(1.0, ANGLE), "pi": Value(math.pi),
        "'": Value(1.0 / 60.0, ANGLE) if angles else Value(12.0 * INCH, LENGTH),
        '"': Value(1.0 / 3600.0, ANGLE) if angles else Value(INCH, LENGTH),
    }  # fmt: skip
    found = marks.get('"' if name == "''" else name) or _find_unit(name)
    if found is None:
        raise _NotRead
    return found


@functools.lru_cache(maxsize=256)
def _find_unit(name: str) -> Value | None:
    """Return one of a unit that FreeCAD knows by that name, a length, an angle or a time; None for any
    other."""
    units = FreeCAD.Units
    try:
        one = units.Quantity(f"1 {name}")
        kinds = ((units.Length, "mm", LENGTH), (units.Angle, "deg", ANGLE), (units.TimeSpan, "s", TIME))
        found = [Value(float(one.getValueAs(base)), dims) for unit, base, dims in kinds if one.Unit == unit]
    except (ValueError, ArithmeticError, OSError):
        return None
    return found[0] if found else None
