# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drilling and boring cycles (G73, G74, G81 to G86, G88, G89) written out as rapids and feeds.

R, Z, Q   height of the plane where the feed begins, bottom of the hole, one peck. G91: R from the initial
          level, Z from R.
level     the initial one is where the axis stood before the first of several cycles; G98 goes back to it, G99
          to R.
L, K      how often: under G91 a row of holes. LinuxCNC, Haas: L. Fanuc: K. 0: the words are kept, and nothing
          is drilled.
kept      G90 and G91 within one cycle: Fanuc and Haas keep the heights that R and Z had when they were told,
          so that a row that begins with one hole in absolute words (G81 X5. Z-10. R2., then G91 X10. K3) is
          drilled to one depth. LinuxCNC reads the words anew.

Sources: LinuxCNC 2.9, interp_cycles.cc (NIST RS274NGC 3, 3.5.16), moved as its ``rs274`` moves; Fanuc
B-63324EN, 13.1; Haas mill operator's manual, canned cycles; R from the initial level and Z from R under G91,
K repeats a series of holes: a description of G81 at zanotowane.pl/117/8692. That heights are kept is how such
rows are written; no manual that says so was found. What differs between them is a row of :class:`Ways`.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from itertools import groupby

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.sentences import Length, plural, say

from . import codes
from .arcs import AXES
from .codes import Grammar
from .cycle_plan import EQUAL_HEIGHT, FINE, LINUXCNC, PECKING, WAYS, Hole, Ways, steps_of
from .lines import Lines, tenfold
from .positions import ABSOLUTE, STEP, absolute_anyway, axis_words
from .words import Words

RETRACT = {980: 0, 990: 1}
BACK = np.argsort(AXES, axis=1)
"""By plane: where X, Y and Z stand in :data:`AXES`."""
WORDS = "XYZRQPLKIJ"
"""The words of a cycle, which mean nothing in the moves that it becomes."""
NOT_IN_TEXT = -1
"""``Words.start`` of a word that stands nowhere in the text."""
MOST_NAMED = 20
MOST = 2_000_000
"""Moves that the cycles of one program may become."""
NOWHERE_YET = say(
    "where it begins is not known: X, Y and Z are not all told since the tilted plane began or ended"
)
Moves = list[tuple[bool, float, float, float]]


@dataclass(eq=False)
class CycleMoves:
    """The moves that lines become, along the axes of their planes; lines left, with code and reason; those of
    R, Q alone."""

    moves: dict[int, Moves] = field(default_factory=dict)
    refused: dict[int, tuple[int, str]] = field(default_factory=dict)
    stored: set[int] = field(default_factory=set)


def write_out_cycles(
    words: Words, lines: Lines, grammar: Grammar, controller: str
) -> tuple[Words, list[Finding]]:
    """Return the words with the cycles as moves of G0 and G1 in absolute words; each line that becomes
    several keeps its number in ``Words.source``. Without any cycle, the same object. ``controller``: the
    dialect's name, of
    :data:`WAYS` or LinuxCNC's."""
    ways = WAYS.get(controller, LINUXCNC)
    if grammar.name != "iso" or not np.isin(lines.code, ways.read).any():
        return words, []
    table = _Table(lines, grammar, ways)
    cycles = _cycle_moves(lines, table)
    return _with_moves(words, lines, cycles, table), _findings(cycles, lines, controller)


def _cycle_moves(lines: Lines, table: _Table) -> CycleMoves:
    cycles = CycleMoves()
    group = dict.fromkeys(codes.MOTION, 0) | {code: code for code in codes.CYCLES}
    code = lines.mode(group, 0)
    cuts = np.flatnonzero(np.diff(code > 0, prepend=False))
    place, since = np.zeros(3), 0
    for first, last in zip(
        cuts[::2].tolist(), [*cuts[1::2].tolist(), lines.count][: len(cuts[::2])], strict=True
    ):
        place = table.end(place, since, first)
        hole, since = Hole(initial=float(place[AXES[table.plane[first], 2]])), last
        for row in (np.flatnonzero(table.concerned[first:last]) + first).tolist():
            place = table.drill_hole(cycles, hole, int(code[row]), row, place)
        if sum(map(len, cycles.moves.values())) > MOST:
            raise ProgramError(
                say(
                    "line {line}: the cycles make more than {most} moves; divide the program",
                    line=table.line(first),
                    most=MOST,
                ),
                MOST,
            )
    return cycles


class _Table:
    """The columns of the program that the cycles look at, in mm."""

    def __init__(self, lines: Lines, grammar: Grammar, ways: Ways) -> None:
        self.ways, self.steps = ways, lines.mode(codes.DISTANCE, 0) == 1
        self.scale = lines.unit(grammar)
        self.plane, self.to_r = lines.mode(codes.PLANES, 0), lines.mode(RETRACT, int(ways.to_r)) == 1
        here = [axis_words(lines, letter) for letter in "XYZ"]
        self.value = np.stack([value * self.scale for value, _ in here], axis=1)
        kind = np.stack([kind for _, kind in here], axis=1)
        anyway = np.stack([absolute_anyway(lines, letter) for letter in "XYZ"], axis=1)
        self.kind = np.where(self.steps[:, None] & (kind == ABSOLUTE) & ~anyway, STEP, kind)
        self.kind[lines.any_of(grammar.no_move)] = 0
        self.r, self.q = (lines.column(letter) * self.scale for letter in "RQ")
        self.times = lines.column(ways.repeats)
        self.by_parts: Bools = ~np.isnan(lines.column("I")) & ~lines.any_of((20, 30))
        self.inverse = lines.mode(codes.FEED_MODE, 0) == codes.INVERSE
        rotary = [~np.isnan(lines.column(letter)) for letter in "ABC"]
        moving = np.logical_or.reduce([(self.kind != 0).any(axis=1), ~np.isnan(self.r), *rotary])
        self.runs: Bools = moving & ~lines.any_of(grammar.no_move)
        self.concerned: Bools = self.runs | ~np.isnan(self.q)
        planes = (*codes.TILT, codes.LEVEL, *codes.DYNAMIC)
        tilted = np.isin(lines.code, (*codes.TILT, codes.DYNAMIC[0])).any()
        self.anew = np.flatnonzero(lines.any_of(planes)) if tilted else np.empty(0, np.int64)
        self.words = lines.words

    def line(self, row: int) -> int:
        """Return the line of the file."""
        return int(self.words.in_file(np.array([row]))[0])

    def end(self, place: Floats, first: int, last: int) -> Floats:
        """Where the lines from ``first`` to before ``last`` lead from ``place`` (3,) mm."""
        place = place.copy()
        known = self.anew[np.searchsorted(self.anew, first) : np.searchsorted(self.anew, last)]
        if len(known):
            place[:], first = np.nan, int(known[-1])
        for k in range(3):
            value, kind = self.value[first:last, k], self.kind[first:last, k]
            absolute = np.flatnonzero((kind != 0) & (kind != STEP))
            if len(absolute):
                place[k], value, kind = value[absolute[-1]], value[absolute[-1] :], kind[absolute[-1] :]
            place[k] += value[kind == STEP].sum()
        return place

    def drill_hole(self, cycles: CycleMoves, hole: Hole, code: int, row: int, place: Floats) -> Floats:
        """Put the moves of one line into ``cycles``; returns where they end."""
        axes = AXES[self.plane[row]]
        if code not in self.ways.read:
            hole.code = code
            return place
        if reason := self._take(hole, code, row, int(axes[2])):
            cycles.refused[row] = code, reason
            return place
        if not self.runs[row]:
            cycles.stored.add(row)
            return place
        times = 1 if np.isnan(self.times[row]) else int(self.times[row])
        across, step = self._across(row, axes, place)
        if np.isnan(across).any() or (self.ways.rises and np.isnan(place).any()):
            cycles.refused[row] = code, NOWHERE_YET
            return place
        moves = self._moves(hole, row, (place[axes[0]], place[axes[1]], place[axes[2]]), across, step, times)
        for _, *where in moves[-1:]:
            place = place.copy()
            place[axes] = where
        cycles.moves[row] = moves
        return place

    def _take(self, hole: Hole, code: int, row: int, axis: int) -> str | None:
        """Return the words of a line into ``hole``; the reason where they make none."""
        if code != hole.code and self.ways.rises:
            # LinuxCNC wants R and Z again with another code
            hole.programmed_r = hole.programmed_z = hole.r = hole.z = hole.q = np.nan
        hole.code = code
        programmed_z = self.value[row, axis] if self.kind[row, axis] else np.nan
        if self.ways.rises:
            hole.programmed_r = hole.programmed_r if np.isnan(self.r[row]) else self.r[row]
            hole.programmed_z = hole.programmed_z if np.isnan(programmed_z) else programmed_z
            self._heights(hole, row, hole.programmed_r, hole.programmed_z)
        else:
            self._heights(hole, row, self.r[row], programmed_z)
        hole.q = self.q[row] if not np.isnan(self.q[row]) else hole.q
        return self._wrong(hole, row)

    def _heights(self, hole: Hole, row: int, r: float, z: float) -> None:
        """Take the heights that these words tell; those of words that are NaN stay."""
        steps = self.steps[row]
        hole.r = hole.r if np.isnan(r) else r + (hole.initial if steps else 0.0)
        hole.z = hole.z if np.isnan(z) else z + (hole.r if steps else 0.0)

    def _wrong(self, hole: Hole, row: int) -> str | None:
        times = self.times[row]
        if not self.runs[row]:
            return None
        if np.isnan(hole.initial):
            return NOWHERE_YET
        if np.isnan(hole.r) or np.isnan(hole.z):
            return say("it has no R or no depth")
        if hole.z > hole.r:
            return say("its depth lies above R")
        if hole.code in PECKING and not hole.q > 0.0:
            return say("it has no Q above 0")
        if not np.isnan(times) and not (0.0 <= times < MOST and times == int(times)):
            return say("its repeats are no whole number from 0 on")
        if (hole.r - hole.z) / hole.q > MOST if hole.code in PECKING else False:
            return say("its Q makes too many pecks")
        if self.by_parts[row] and hole.code == 830:
            return say("its pecks get smaller (I)")
        return say("its feed is inverse time (G93)") if self.inverse[row] else None

    def _across(self, row: int, axes: Ints, place: Floats) -> tuple[list[float], list[float]]:
        """Return the first place of the hole before its steps, and the steps from one to the next."""
        kind, value = self.kind[row, axes[:2]], self.value[row, axes[:2]]
        start = np.where((kind != 0) & (kind != STEP), value, place[axes[:2]])
        return start.tolist(), np.where(kind == STEP, value, 0.0).tolist()

    def _moves(
        self,
        hole: Hole,
        row: int,
        at: tuple[float, float, float],
        across: list[float],
        step: list[float],
        times: int,
    ) -> Moves:
        """Rapids and feeds (fast, u, v, w) of a line."""
        ways, r, moves = self.ways, hole.r, Moves()
        clear = r if self.to_r[row] else max(hole.initial, r) if ways.rises else hole.initial
        level = at[2]
        if ways.rises:
            if hole.initial < r and times:
                moves.append((True, at[0], at[1], r))
                level = r
            level = level if level > r + EQUAL_HEIGHT else clear
        body = steps_of(hole, clear, ways)
        u, v = across
        for _ in range(min(times, MOST // max(len(body), 1))):
            u, v = u + step[0], v + step[1]
            moves.append((True, u, v, level))
            if abs(level - r) > EQUAL_HEIGHT:
                moves.append((True, u, v, r))
            moves += [(fast, u, v, w) for fast, w in body]
            level = body[-1][1]
            if ways.stays and hole.code == 880:
                level = clear
        return moves


def _with_moves(words: Words, lines: Lines, cycles: CycleMoves, table: _Table) -> Words:
    """Return the words with the moves in rows of their own, and the rows after them moved down."""
    rows = np.array(sorted(cycles.moves), np.int64)
    count = np.array([len(cycles.moves[row]) for row in rows.tolist()], np.int64)
    more = np.zeros(lines.count, np.int64)
    more[rows] = np.maximum(count - 1, 0) + table.steps[rows]
    shift = np.cumsum(more) - more
    keep = _find_kept_words(words, rows, cycles, table.ways)
    letter = _stepwise(words.letter[keep], np.isin(words.line[keep], rows[table.steps[rows]]))
    return spread(words, more, keep, letter, _new_words(cycles, rows, count, shift, table))


def spread(words: Words, more: Ints, keep: Bools, letter: Bytes, put: tuple[Ints, Bytes, Floats]) -> Words:
    """Return the words that are kept (``letter``: theirs), with ``more`` (lines,) rows after each line, and
    words put in: the rows where they stand, letters, values."""
    at, letters, values = put
    shift = np.cumsum(more) - more
    start = np.full(len(letter), NOT_IN_TEXT) if words.start is None else words.start[keep]
    line = np.concatenate([(words.line + shift[words.line])[keep], at])
    order = np.argsort(line, kind="stable")
    source = np.repeat(np.arange(len(more)), more + 1)
    return replace(
        words,
        letter=np.concatenate([letter, letters])[order],
        value=np.concatenate([words.value[keep], values])[order],
        line=line[order],
        start=np.concatenate([start, np.full(len(at), NOT_IN_TEXT)])[order],
        source=source if words.source is None else words.source[source],
    )


def _find_kept_words(words: Words, rows: Ints, cycles: CycleMoves, ways: Ways) -> Bools:
    """Which words stay: not those of the cycles that are written out, and no code of one where it stands
    alone."""
    own = np.isin(words.line, rows) & np.isin(words.letter, [ord(letter) for letter in WORDS])
    code: Bools = (words.letter == ord("G")) & np.isin(tenfold(words.value), ways.read)
    lone = np.isin(words.line, list(cycles.stored)) & np.isin(words.letter, [ord(letter) for letter in "RQ"])
    return ~(own | lone | (code & ~np.isin(words.line, list(cycles.refused))))


def _stepwise(letter: Bytes, chosen: Bools) -> Bytes:
    """Return the letters of rotary axes as those of incremental words, where ``chosen``: the moves themselves
    are absolute."""
    letter = letter.copy()
    for axis in "ABC":
        letter[chosen & (letter == ord(axis))] = ord(codes.STEP_OF[axis])
    return letter


def _new_words(
    cycles: CycleMoves, rows: Ints, count: Ints, shift: Ints, table: _Table
) -> tuple[Ints, Bytes, Floats]:
    """Line, letter and value of the words of all moves; of the G91 behind those that stand under it; and the
    code of each refused line, for the moves before it are in other modes."""
    moves = np.array([move for row in rows.tolist() for move in cycles.moves[row]], float).reshape(-1, 4)
    run, number = number_runs(count)
    of = rows[run]
    at = of + shift[of] + number
    where = np.take_along_axis(moves[:, 1:], BACK[table.plane[of]], axis=1) / table.scale[of][:, None]
    stepped, again = table.steps[of], rows[table.steps[rows]]
    refused = np.array(list(cycles.refused), np.int64)
    parts = [
        (at, "G", 1.0 - moves[:, 0]),
        (at[stepped], "G", np.full(int(stepped.sum()), 90.0)),
        *((at, letter, where[:, k]) for k, letter in enumerate("XYZ")),
        ((rows + shift[rows] + np.maximum(count, 1))[table.steps[rows]], "G", np.full(len(again), 91.0)),
        (refused + shift[refused], "G", np.array([code / 10.0 for code, _ in cycles.refused.values()])),
    ]
    letters = np.concatenate([np.full(len(line), ord(letter), np.int8) for line, letter, _ in parts])
    return (
        np.concatenate([line for line, *_ in parts]),
        letters,
        np.concatenate([value for *_, value in parts]),
    )


def _report_refused(cycles: CycleMoves) -> list[Finding]:
    """Return one finding for each run of holes of one cycle that are refused for one reason."""
    found = list[Finding]()
    for (code, reason), holes in groupby(cycles.refused.items(), lambda one: one[1]):
        rows = [row for row, _ in holes]
        text = plural(
            len(rows),
            "The cycle G{code} is not written out, and its moves are missing: {reason}. Correct it, or post "
            "straight moves.",
            "The cycle G{code} is not written out, and the moves of its {count} holes are missing: {reason}. "
            "Correct it, or post straight moves.",
            code=f"{code / 10:g}",
            reason=reason,
        )
        found.append(report_finding(codes.CYCLE_KIND[0], text, float(len(rows)), line=rows[0]))
    return found[:MOST_NAMED]


def _findings(cycles: CycleMoves, lines: Lines, controller: str) -> list[Finding]:
    found = _report_refused(cycles)
    pecks = np.flatnonzero(lines.any_of(PECKING))
    if controller in WAYS and len(pecks) and cycles.moves:
        text = say(
            "Between pecks the tool stays {back} off the depth reached here; on this control a setting says "
            "how far. No other place hangs on it.",
            back=Length(WAYS[controller].peck),
        )
        found.append(report_finding(Code.PECK_CLEARANCE, text, line=int(pecks[0])))
    fine = np.flatnonzero(lines.any_of((FINE,)))
    if controller in WAYS and len(fine) and cycles.moves:
        text = say(
            "G76 is read without its shift: at the bottom the control leaves the wall by I J or Q before "
            "the tool rises, and comes back above."
        )
        found.append(report_finding(Code.BORING_SHIFT, text, line=int(fine[0])))
    return found
