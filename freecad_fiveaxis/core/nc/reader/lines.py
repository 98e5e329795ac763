# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a program sorted into lines, and the modes in force in each of them.

modal     a code or a word that stays in force until another of its group comes (ISO 6983-1; NIST RS274NGC 3).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from . import codes
from .codes import Grammar
from .words import Words


@dataclass(frozen=True)
class Assumed:
    """What is taken where the text does not say it. ``units``: ``mm``, ``inch``, or ``file`` where nobody has
    said it either (mm, with a finding); ``decimal``: a word without a point is in millimetres or inches and
    degrees (``calculator``), or counts the controller's least increment; ``no_motion``: functions of the
    machine that move nothing, as its file names them; ``search``: folders with the programs that it calls;
    ``centres``: the machine's centres of rotation are known, by which a control leads the axes in a tilted
    plane and under G254."""

    units: str = "file"
    decimal: str = "calculator"
    no_motion: tuple[str, ...] = ()
    search: tuple[str, ...] = ()
    centres: bool = True


UNTOLD = Assumed()


class Lines:
    """Every column is (lines + 1,), line 0 stands empty."""

    def __init__(self, words: Words, assumed: Assumed) -> None:
        self.words, self.assumed = words, assumed
        self.count = int(words.line.max(initial=0)) + 1
        self.letters = frozenset(map(chr, np.unique(words.letter).tolist()))
        at = np.flatnonzero(words.letter == ord("G"))
        self.code = tenfold(words.value[at])
        self.code_line = words.line[at]

    def column(self, letter: str) -> Floats:
        """Return the word of that letter in each line, NaN where there is none. Raises ProgramError where it
        stands twice."""
        column = np.full(self.count, np.nan)
        if letter not in self.letters:
            return column
        at = np.flatnonzero(self.words.letter == ord(letter))
        line = self.words.line[at]
        twice = np.flatnonzero(line[1:] == line[:-1])
        if len(twice):
            place = self.words.place(int(at[twice[0] + 1]))
            raise ProgramError(
                say(
                    "{place}: word {letter} stands twice; a line takes one of each",
                    place=place,
                    letter=letter.upper(),
                ),
                letter,
            )
        column[line] = self.words.value[at]
        return column

    def columns(self, letters: str) -> Floats:
        """Return the words of these letters in each line (lines, k), as :meth:`column`."""
        return np.stack([self.column(letter) for letter in letters], axis=1)

    def inch(self, grammar: Grammar) -> Bools:
        """Whether the lengths of each line are in inches."""
        return np.asarray(self.mode(grammar.units, int(self.assumed.units == "inch")) == 1)

    def inch_feed(self, grammar: Grammar) -> Bools:
        """Whether F of each line counts inches. Siemens' G70 and G71 leave F to the control's basic system,
        which is taken as theirs where nobody has said it; G700 and G710 count it as lengths (802D sl,
        6FC5398-3CP10, 8.2.3)."""
        if grammar.name != "siemens" or self.assumed.units == "file":
            return self.inch(grammar)
        basic = int(self.assumed.units == "inch")
        units = {code: basic if code in codes.LENGTHS_ALONE else k for code, k in grammar.units.items()}
        return np.asarray(self.mode(units, basic) == 1)

    def unit(self, grammar: Grammar) -> Floats:
        """Return how many mm the unit of length of each line has."""
        return np.where(self.inch(grammar), codes.INCH, 1.0)

    def any_of(self, chosen: Iterable[int]) -> Bools:
        """Return the lines with one of these codes."""
        found = np.zeros(self.count, np.bool_)
        found[self.code_line[np.isin(self.code, list(chosen))]] = True
        return found

    def m_line(self, chosen: Iterable[int]) -> Ints:
        """Return the lines of these M codes."""
        words = self.words
        at: Bools = (words.letter == ord("M")) & np.isin(words.value, list(chosen))
        return words.line[at]

    def mode(self, group: Mapping[int, int], initial: int) -> Ints:
        """Return the mode in force in each line, its own code included; of several in one line the last
        counts."""
        chosen = np.isin(self.code, list(group))
        line, code = self.code_line[chosen], self.code[chosen]
        state = np.full(self.count, initial, np.int64)
        if not len(line):
            return state
        lookup = np.zeros(max(group) + 1, np.int64)
        lookup[list(group)] = list(group.values())
        state[line] = lookup[code]
        return hold_state(state, line, self.count)


def without_dwells(words: Words, grammar: Grammar) -> Words:
    """Return the words without the times of dwells (G4): of each such line the first letter of
    ``grammar.dwell`` that stands in it. All else in the line is meant as in any other (NIST RS274NGC 3,
    3.5.4: the axes may move in the line of a dwell)."""
    dwell = words.line[(words.letter == ord("G")) & (tenfold(words.value) == codes.DWELL)]
    keep = np.ones(len(words.line), np.bool_)
    for letter in grammar.dwell if len(dwell) else ():
        time = (words.letter == ord(letter)) & np.isin(words.line, dwell)
        keep &= ~time
        dwell = np.setdiff1d(dwell, words.line[time])
    if keep.all():
        return words
    start = None if words.start is None else words.start[keep]
    return replace(
        words, letter=words.letter[keep], value=words.value[keep], line=words.line[keep], start=start
    )


def by_least_increment(lines: Lines, grammar: Grammar) -> Words:
    """Return the words in which those of axes, centres and radii without a decimal point counted the least
    increment, IS-B (Fanuc B-63324EN, 3.4.3): 0.001 mm, 0.0001 inch, 0.001 deg."""
    words = lines.words
    bare = words.bare() & np.isin(words.letter, [ord(letter) for letter in codes.INCREMENTED + codes.PECK])
    linear = ~np.isin(words.letter, [ord(letter) for letter in "ABC"])
    step = np.where(linear & lines.inch(grammar)[words.line], 1e-4, 1e-3)
    return replace(words, value=np.where(bare, np.round(words.value * step, 4), words.value))


def tenfold(value: Floats) -> Ints:
    """Ten times the number of a code, as G43.4 = 434; -1 where it is no such number."""
    with np.errstate(over="ignore", invalid="ignore"):
        tens = np.rint(value * 10.0)
        known = (np.abs(tens - value * 10.0) < 1e-6) & (np.abs(tens) < 1e6)
    return np.asarray(np.where(known, tens, -1.0).astype(np.int64))


def hold_state(state: Ints, line: Ints, count: int) -> Ints:
    """``state`` of the last of the given lines at or before each line (of line 0 before the first)."""
    return state[last_of(line, count)]


def last_of(line: Ints, count: int) -> Ints:
    """For each line the last of the given lines at or before it, 0 where there is none."""
    last = np.zeros(count, np.int64)
    last[line] = line
    return np.maximum.accumulate(last)


def hold_words(column: Floats) -> Floats:
    """Return the last word of a column at or before each line, NaN before the first."""
    return column[last_of(np.flatnonzero(~np.isnan(column)), len(column))]
