# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a machine is recovered from: rows of a CL path, each with the words that a post made of it.

pair     one row: tip and tool axis as commanded, and the five words that are meant to bring them about.
step     of a column: what its last printed digit is worth. A rounded number is off by at most half of it,
         evenly spread, so its standard deviation is the step over the square root of 12.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.records import Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine.model import ROTARY_LETTERS

COARSEST, FINEST = 3, 9
"""Decimals that posts print at least; decimals of a column that was not rounded, or was in another unit."""
AXIS_STEP = 1e-4
"""Step of tool axes whose print is not known: the coarsest that CAM systems write."""
INCH = 25.4
TEXT_LOOKED_AT = 1_000_000
"""Bytes of a text that are enough to see its letters and decimals."""

_ROTARY_WORD = re.compile(rb"(?<![A-Z])([ABC])(?!3?\s*=\s*[A-Z])\s*=?\s*[-+]?[0-9.]")
_COMMENTS = re.compile(rb"\([^()\n]*\)|;[^\n]*")
_GOTO = re.compile(rb"GOTO\s*/([^\n]*)")


@dataclass(frozen=True)
class Steps:
    """The step of tips mm, axes 1, linear words mm and rotary words **rad**."""

    tip: float = 1e-9
    axis: float = AXIS_STEP
    linear: float = 1e-9
    rotary: float = 1e-11


@dataclass(frozen=True, eq=False)
class Pairs:
    """``letters`` of the two rotary words, in the alphabet's order; ``tip`` (n, 3) mm, ``axis`` (n, 3) unit,
    ``linear`` (n, 3) mm for X Y Z, ``rotary`` (n, 2) **rad** by ``letters``; ``row`` (n,) of the CL path,
    ``line`` (n,) of the NC file, ``block`` (n,) of the program; lines come again where the program loops."""

    letters: str
    tip: Floats
    axis: Floats
    linear: Floats
    rotary: Floats
    row: Ints
    line: Ints
    steps: Steps
    block: Ints

    def __post_init__(self) -> None:
        freeze(self, None, tip="f3", axis="f3", linear="f3", rotary="f2", row="i", line="i", block="i")

    def take(self, rows: Ints) -> Pairs:
        """Return some of the rows."""
        tip, axis, linear, rotary = self.tip[rows], self.axis[rows], self.linear[rows], self.rotary[rows]
        return Pairs(
            self.letters,
            tip,
            axis,
            linear,
            rotary,
            self.row[rows],
            self.line[rows],
            self.steps,
            self.block[rows],
        )


def step_of(column: Floats, inch: bool = True) -> float:
    """Return what the last printed digit of the numbers is worth, by the power of ten of which all are
    multiples; whole numbers count as printed with three decimals. ``inch``: in millimetres, but perhaps
    printed in inches, with four decimals or more."""
    values = np.ravel(column)
    decimals = max(_decimals(values), COARSEST)
    if inch and decimals > COARSEST + 1:
        in_inches = max(_decimals(values / INCH), COARSEST + 1)
        if in_inches < decimals:
            return float(INCH * 10.0**-in_inches)
    return float(10.0**-decimals)


def _decimals(values: Floats) -> int:
    for decimals in range(FINEST):
        scaled = values * 10.0**decimals
        if (np.abs(scaled - np.rint(scaled)) < 1e-6 + 1e-15 * np.abs(scaled)).all():
            return decimals
    return FINEST


def find_axis_step(text: bytes) -> float:
    """Return the step of the tool axes of an APT text, by the longest of their printed numbers; AXIS_STEP
    where there are none."""
    most = 0
    for statement in _GOTO.findall(text[:TEXT_LOOKED_AT].upper()):
        numbers = statement.split(b"$")[0].split(b",")[3:6]
        most = max([most, *(len(number.strip().partition(b".")[2].partition(b"E")[0]) for number in numbers)])
    return float(10.0 ** -min(most, FINEST)) if most else AXIS_STEP


def rotary_letters(text: bytes) -> str:
    """Return the two letters of the rotary words of an NC text, as "AC". Raises ProgramError where there are
    not two."""
    plain = _COMMENTS.sub(b" ", text[:TEXT_LOOKED_AT]).upper()
    found = {letter.decode() for letter in _ROTARY_WORD.findall(plain)}
    letters = "".join(letter for letter in ROTARY_LETTERS if letter in found)
    if len(letters) != 2:
        names = " ".join(letters) or "none"
        raise ProgramError(
            say(
                "the program has rotary words of {names}; a five-axis machine is recovered from two of A B C",
                names=names,
            ),
            letters,
        )
    return letters
