# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC text of any origin into a Program: joint programs of straight moves.

modal     a code or a word that stays in force until another of its group comes (ISO 6983-1; NIST RS274NGC 3).
motion line  a line with a word of one of the machine's axes under G0 or G1: one block of the Program.

What is not interpreted (arcs, cycles, macros, subprograms, offsets, tool centre point control) is never passed over in
silence: each kind is a finding with its first line and its count.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.cl_path import Motion
from freecad_fiveaxis.core.errors import ProgramError
from freecad_fiveaxis.core.findings import Finding, Severity
from freecad_fiveaxis.core.kinematics import Chain
from freecad_fiveaxis.core.post.dialect import Dialect, feed_distance
from freecad_fiveaxis.core.program import Program, rapid_minutes
from freecad_fiveaxis.core.progress import Progress, silent
from freecad_fiveaxis.core.records import Bools, Bytes, Floats, Ints

from . import codes
from .words import Words, read_words

INCH = 25.4


def read_nc(text: bytes, links: Chain, dialect: Dialect | None = None, progress: Progress = silent) -> Program:
    """The Program of an NC text, one block for every motion line. ``dialect`` says how F is meant under G94 (None: over X Y Z).

    Rotary words are absolute degrees, turns not folded; inches become mm. Axes that the first motion line does not name are
    taken as 0 there, with a finding. Raises ProgramError, naming line and column, for text that cannot be read, and where
    there is no motion line at all.
    """
    progress("reading NC", 0.0)
    words = read_words(text)
    progress("reading NC", 0.5)
    words, findings = _up_to_end(words)
    lines = _Lines(words)
    named = {letter: lines.column(letter) for letter in links.letters}
    has_axis = np.logical_or.reduce([~np.isnan(column) for column in named.values()])
    moving = has_axis & ~lines.any_of(codes.NO_MOVE) & (lines.mode(codes.MOTION, codes.NONE) != codes.CYCLE)
    at = np.flatnonzero(moving)
    if not len(at):
        raise ProgramError("the file holds no motion blocks: no axis word of this machine under G0 or G1", links.letters)
    motion_mode, incremental = lines.mode(codes.MOTION, codes.NONE)[at], lines.mode(codes.DISTANCE, 0)[at] == 1
    position = _positions([column[at] for column in named.values()], incremental, lines.mode(codes.UNITS, 0)[at] == 1)
    feed, inverse, more = _feeds(lines, at, motion_mode != codes.RAPID)
    motion = np.where(motion_mode == codes.RAPID, Motion.RAPID, Motion.CUT).astype(np.int8)
    seconds = _seconds(position, motion, feed, inverse, lines.mode(codes.FEED_MODE, 0)[at] == codes.PER_TURN, links, dialect)
    findings += (*words.findings, *_code_findings(words), *_word_findings(words, lines, links.letters), *more)
    findings += tuple(_start_findings(named, at, motion_mode, incremental, lines))
    return Program(links.letters, position, feed, inverse, motion, seconds, np.full(len(at), -1), at, findings)


class _Lines:
    """The words sorted into lines; every column is (lines + 1,), line 0 stands empty."""

    def __init__(self, words: Words) -> None:
        self.words = words
        self.count = int(words.line.max(initial=0)) + 1
        self.code_at = np.flatnonzero(words.letter == ord("G"))
        self.code = tenfold(words.value[self.code_at])
        self.code_line = words.line[self.code_at]

    def column(self, letter: str) -> Floats:
        """The word of that letter in each line, NaN where there is none. Raises ProgramError where it stands twice."""
        at = np.flatnonzero(self.words.letter == ord(letter))
        line = self.words.line[at]
        twice = np.flatnonzero(line[1:] == line[:-1])
        if len(twice):
            number = int(line[twice[0]])
            raise ProgramError(f"line {number}: word {letter} stands twice; a line takes one of each", letter)
        column = np.full(self.count, np.nan)
        column[line] = self.words.value[at]
        return column

    def any_of(self, chosen: tuple[int, ...]) -> Bools:
        found = np.zeros(self.count, np.bool_)
        found[self.code_line[np.isin(self.code, chosen)]] = True
        return found

    def mode(self, group: dict[int, int], initial: int) -> Ints:
        """The mode in force in each line, its own code included; of several in one line the last counts."""
        chosen = np.isin(self.code, list(group))
        line, code = self.code_line[chosen], self.code[chosen]
        state = np.full(self.count, initial, np.int64)
        if not len(line):
            return state
        lookup = np.zeros(max(group) + 1, np.int64)
        lookup[list(group)] = list(group.values())
        state[line] = lookup[code]
        return held(state, line, self.count)


def tenfold(value: Floats) -> Ints:
    """Ten times the number of a code, as G43.4 = 434; -1 where it is no such number."""
    tens = np.rint(value * 10.0)
    return np.where((np.abs(tens - value * 10.0) < 1e-6) & (np.abs(tens) < 1e6), tens, -1.0).astype(np.int64)


def held(state: Ints, line: Ints, count: int) -> Ints:
    """``state`` of the last of the given lines at or before each line (of line 0 before the first)."""
    return state[last_of(line, count)]


def last_of(line: Ints, count: int) -> Ints:
    """For each line the last of the given lines at or before it, 0 where there is none."""
    last = np.zeros(count, np.int64)
    last[line] = line
    return np.maximum.accumulate(last)


def _up_to_end(words: Words) -> tuple[Words, tuple[Finding, ...]]:
    """The words up to M2, M30 or M99."""
    ends = np.flatnonzero((words.letter == ord("M")) & np.isin(words.value, (2.0, 30.0, 99.0)))
    if not len(ends):
        return words, ()
    last = int(words.line[ends[0]])
    keep = int(np.searchsorted(words.line, last, side="right"))
    findings: tuple[Finding, ...] = ()
    if keep < len(words.line):
        line = int(words.line[keep])
        text = f"The lines after the end of the program in line {last} are not read."
        findings = (Finding(Severity.NOTE, "text-after-end", text, line=line),)
    return Words(words.letter[:keep], words.value[:keep], words.line[:keep], words.findings), findings


def _positions(columns: list[Floats], incremental: Bools, inch: Bools) -> Floats:
    """Words (m, 5) mm and degrees at the end of each motion line."""
    position = np.empty((5, len(incremental))).T
    for k, column in enumerate(columns):
        value = np.where(inch, column * INCH, column) if k < 3 and inch.any() else column
        given = ~np.isnan(value)
        anchor = last_of(np.flatnonzero(given & ~incremental) + 1, len(value) + 1)[1:]
        padded = np.concatenate([np.zeros(1), value])
        position[:, k] = padded[anchor]
        if incremental.any():
            travelled = np.cumsum(np.where(given & incremental, value, 0.0))
            position[:, k] += travelled - np.concatenate([np.zeros(1), travelled])[anchor]
    return position


def _feeds(lines: _Lines, at: Ints, feeding: Bools) -> tuple[Floats, Bools, tuple[Finding, ...]]:
    """F (m,) in force in mm/min or 1/min, whether it is inverse time, and the findings."""
    mode, inch, column = lines.mode(codes.FEED_MODE, 0), lines.mode(codes.UNITS, 0), lines.column("F")
    given = np.flatnonzero(~np.isnan(column))
    column[given] *= np.where((inch[given] == 1) & (mode[given] != codes.INVERSE), INCH, 1.0)
    last = last_of(given, lines.count)
    changed = last_of(np.flatnonzero(np.diff(mode, prepend=mode[:1])), lines.count)
    valid = (last > 0) & (last >= changed)  # an F word dies with its feed mode
    feed = np.where(valid[at] & feeding, column[last[at]], 0.0)
    inverse: Bools = mode[at] == codes.INVERSE
    own = last[at] == at
    cases = (
        (feeding & ~(feed > 0.0), "no-feed", "blocks have no F above 0 in force; most controllers stop there. Give F."),
        (feeding & inverse & ~own & (feed > 0.0), "inverse-feed-missing",
         "blocks under G93 have no F of their own; most controllers stop there. Give F in every block."),
    )  # fmt: skip
    found = [
        Finding(Severity.ERROR, code, f"{int(rows.sum())} {text}", block=int(rows.argmax()), line=int(at[rows.argmax()]))
        for rows, code, text in cases
        if rows.any()
    ]
    return np.where(feed > 0.0, feed, 0.0), inverse, tuple(found)


def _seconds(
    position: Floats, motion: Bytes, feed: Floats, inverse: Bools, unknown: Bools, links: Chain, dialect: Dialect | None
) -> Floats:
    """The time (m,) s that the controller takes by what the words say; 0 where they say nothing."""
    change = np.diff(position, axis=0, prepend=position[:1])
    distance = np.where(inverse, 1.0, feed_distance(dialect, change))
    minutes = np.divide(distance, feed, out=np.zeros(len(feed)), where=(feed > 0.0) & ~unknown)
    change[:, 3:] = np.radians(change[:, 3:])
    seconds: Floats = 60.0 * np.where(motion == Motion.RAPID, rapid_minutes(links, change), minutes)
    seconds[0] = 0.0
    return seconds


def _code_findings(words: Words) -> list[Finding]:
    found = []
    for letter, table in (("G", codes.CODES), ("M", codes.M_CODES)):
        at = np.flatnonzero(words.letter == ord(letter))
        number = tenfold(words.value[at]) if letter == "G" else words.value[at].astype(np.int64)
        for value, first, count in zip(*np.unique(number, return_index=True, return_counts=True), strict=True):
            line, name = int(words.line[at[first]]), f"{letter}{words.value[at[first]]:g}"
            if value in table:
                severity, kind, text = table[int(value)]
                found.append(Finding(severity, kind, f"{name} stands in {count} lines: {text}.", float(count), line=line))
            elif letter == "G" and int(value) not in codes.HARMLESS:
                text = f"{name} is not known and not interpreted ({count} lines); what it does is missing here."
                found.append(Finding(Severity.WARNING, "unknown-code", text, float(count), line=line))
    return found


def _word_findings(words: Words, lines: _Lines, letters: str) -> list[Finding]:
    found = []
    for value, first, count in zip(*np.unique(words.letter, return_index=True, return_counts=True), strict=True):
        letter, line = chr(value), int(words.line[first])
        if letter in letters or letter in codes.WORDS_IGNORED:
            continue
        if letter in codes.AXES:
            text = f"The machine has no axis {letter}: its {count} words are left out. Choose the program's own machine."
            found.append(Finding(Severity.ERROR, "unknown-axis", text, float(count), line=line))
        elif letter not in "IJKR" or not np.isin(lines.code, (20, 30)).any():
            text = f"The {count} words {letter} are not interpreted."
            found.append(Finding(Severity.WARNING, "word-not-interpreted", text, float(count), line=line))
    return found


def _start_findings(named: dict[str, Floats], at: Ints, motion_mode: Ints, incremental: Bools, lines: _Lines) -> list[Finding]:
    found = []
    first = int(at[0])
    unknown = [letter for letter, column in named.items() if np.isnan(column[first]) or incremental[0]]
    if unknown:
        text = f"The first motion line does not say where {', '.join(sorted(unknown))} stand; they are taken as 0 there."
        found.append(Finding(Severity.NOTE, "position-unknown", text, block=0, line=first))
    if (motion_mode == codes.NONE).any():
        block = int((motion_mode == codes.NONE).argmax())
        text = "Axis words stand under no G0 or G1; they are taken as G1. Give a motion code."
        found.append(Finding(Severity.WARNING, "no-motion-code", text, block=block, line=int(at[block])))
    if not np.isin(lines.code, list(codes.UNITS)).any():
        found.append(Finding(Severity.NOTE, "units-not-said", "The program says neither G20 nor G21; taken as mm.", line=first))
    offsets = np.unique(lines.code[np.isin(lines.code, codes.OFFSETS)])
    if len(offsets) > 1:
        text = f"The program uses {len(offsets)} work offsets; their distance is not known, and the blocks between are not right."
        found.append(Finding(Severity.WARNING, "work-offset-change", text, line=first))
    return found
