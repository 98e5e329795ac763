# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a Siemens program with its drilling cycles as moves: rows of their own after the line that
calls them.

The moves go along the drilling axis, where the block before has led, those of CYCLE86 aside too; after them
G0 to G3, G90 or G91 and F are as before (Siemens 840D sl, Programming Manual Cycles: the G functions before
the call stay in force behind it).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from . import codes
from .arcs import AXES
from .canned_cycles import MOST, MOST_NAMED, spread
from .codes import INCH, Grammar
from .lines import Lines, hold_words, last_of
from .positions import axis_words
from .siemens_cycles import Around, Drill, sideways, steps, wrong_here
from .words import Words

Rows = tuple[Ints, Bytes, Floats]
"""Words of rows: which row, from 1 after the line of the call, the letter, the value."""


@dataclass(eq=False)
class _State:
    """What is in force in each line (lines,)."""

    plane: Ints
    feed: Floats
    speed: Floats
    feed_mode: Ints
    inch: Bools
    inch_feed: Bools
    steps: Bools
    motion: Ints
    machine: Bools


@dataclass(eq=False)
class _HoleMoves:
    """``rows`` of the calls that are written out, by what is in force; ``which`` of them each line takes;
    ``refused``: first line by cycle and reason."""

    rows: dict[tuple[object, ...], Rows] = field(default_factory=dict)
    which: dict[int, Rows] = field(default_factory=dict)
    refused: dict[tuple[str, str], int] = field(default_factory=dict)
    count: int = 0


def holes_written_out(words: Words, lines: Lines, grammar: Grammar) -> tuple[Words, list[Finding]]:
    """Return the words with the moves of the cycles; each line that becomes several keeps its number in
    ``Words.source``. Without any call, the same object. Raises ProgramError for more moves than
    :data:`.canned_cycles.MOST`."""
    if codes.DRILL not in lines.letters:
        return words, []
    holes, state = _HoleMoves(), _state(lines, grammar)
    for row, drill in _calls(lines):
        reason = drill.refused or _wrong(state, row)
        if reason:
            holes.refused.setdefault((drill.name, reason), row)
            continue
        _put(holes, drill, row, state, lines)
    return _with_rows(words, lines, holes), _findings(holes)


def _calls(lines: Lines) -> list[tuple[int, Drill]]:
    """Return the lines after which a cycle runs, and which; of a modal one that is not understood its own
    line."""
    number, drills = lines.column(codes.DRILL), lines.words.drills
    at = np.flatnonzero(~np.isnan(number))
    modal = np.array([drill.modal or not drill.name for drill in drills])
    runs = np.array([drill.modal and not drill.refused for drill in drills])
    index = number[at].astype(np.int64)
    since = at[modal[index]]
    state = np.full(lines.count, -1, np.int64)
    state[since] = index[modal[index]]
    state = state[last_of(since, lines.count)]
    moving = _moving(lines)
    moving[at] = False
    rows = np.flatnonzero(moving & (state >= 0) & np.append(runs, False)[state])
    own = at[[bool(drills[k].name) and not runs[k] for k in index.tolist()]]
    state[own] = number[own].astype(np.int64)
    return [(row, drills[state[row]]) for row in np.union1d(rows, own).tolist()]


def _moving(lines: Lines) -> Bools:
    """Return the lines whose words move an axis."""
    moving = np.logical_or.reduce([axis_words(lines, letter)[1] != 0 for letter in "XYZABC"])
    arc = lines.mode(codes.SIEMENS.motion, codes.NONE) == codes.ARC
    moving |= arc & ~np.isnan(lines.columns("IJK")).all(axis=1)
    if codes.SHIFTED in lines.letters:
        moving &= np.isnan(lines.column(codes.SHIFTED))
    return np.asarray(moving & ~lines.any_of(codes.POLES))


def _state(lines: Lines, grammar: Grammar) -> _State:
    motion = {
        code: code for code in codes.MOTION if codes.MOTION[code] in (codes.RAPID, codes.STRAIGHT, codes.ARC)
    }
    return _State(
        lines.mode(codes.PLANES, 0), hold_words(lines.column("F")), hold_words(lines.column("S")),
        lines.mode(codes.FEED_MODE, codes.PER_MINUTE),
        lines.inch(grammar), lines.inch_feed(grammar), lines.mode(codes.DISTANCE, 0) == 1,
        lines.mode(motion, 10),
        ~np.isnan(lines.column(codes.MACHINE)) | lines.any_of(grammar.no_move),
    )  # fmt: skip


def _wrong(state: _State, row: int) -> str:
    if state.machine[row]:
        return say("it would run at a machine position")
    return say("its feed is inverse time (G93)") if state.feed_mode[row] == codes.INVERSE else ""


def _put(holes: _HoleMoves, drill: Drill, row: int, state: _State, lines: Lines) -> None:
    """Put the rows of a call into ``holes``: made once for calls of the same cycle in the same state."""
    around = Around(
        int(state.plane[row]), float(state.feed[row]), float(state.speed[row]),
        bool(state.feed_mode[row] == codes.PER_TURN),
        INCH if state.inch[row] else 1.0, INCH if state.inch_feed[row] else 1.0,
    )  # fmt: skip
    if reason := wrong_here(drill, around):
        holes.refused.setdefault((drill.name, reason), row)
        return
    key = (id(drill), str(around), state.steps[row], state.motion[row])
    rows = holes.rows.get(key)
    if rows is None:
        rows = holes.rows[key] = _rows(drill, around, bool(state.steps[row]), int(state.motion[row]))
    holes.which[row] = rows
    holes.count += len(rows[0])
    if holes.count > 4 * MOST:
        line = int(lines.words.in_file(np.array([row]))[0])
        raise ProgramError(
            say(
                "line {line}: the cycles make more than {most} moves; divide the program",
                line=line,
                most=MOST,
            ),
            MOST,
        )


def _rows(drill: Drill, around: Around, stepwise: bool, motion: int) -> Rows:
    """Return the words of a call: its moves, each a row, and a row that puts back what was in force."""
    axis, feed, words = "XYZ"[AXES[around.plane, 2]], around.feed, list[tuple[int, str, float]]()
    if stepwise:
        words.append((1, "G", 90.0))
    moves = steps(drill, around)
    for row, (fast, height, own) in enumerate(moves, 1):
        words += [(row, "G", 0.0 if fast else 1.0), (row, axis, height)]
        if not math.isnan(own) and own != feed:
            words.append((row, "F", own))
            feed = own
    for row, sign in (3, 1.0), (5, -1.0):
        words += [
            (row, codes.STEP_OF["XYZ"[one]], sign * way)
            for one, way in zip(AXES[around.plane], sideways(drill), strict=False)
            if way
        ]
    last = len(moves) + 1
    words += [(last, "G", motion / 10.0), *([(last, "G", 91.0)] if stepwise else [])]
    if feed != around.feed and not math.isnan(around.feed):
        words.append((last, "F", around.feed))
    letters = np.array([ord(letter) for _, letter, _ in words], np.int8)
    return np.array([row for row, *_ in words], np.int64), letters, np.array([value for *_, value in words])


def _with_rows(words: Words, lines: Lines, holes: _HoleMoves) -> Words:
    keep = words.letter != ord(codes.DRILL)
    at = np.array(sorted(holes.which), np.int64)
    rows = [holes.which[row] for row in at.tolist()]
    more = np.zeros(lines.count, np.int64)
    more[at] = [int(row.max()) for row, *_ in rows]
    first = (at + (np.cumsum(more) - more)[at]).tolist()
    if not rows:
        return spread(
            words, more, keep, words.letter[keep], (np.empty(0, np.int64), np.empty(0, np.int8), np.empty(0))
        )
    put = (
        np.concatenate([row + begin for (row, *_), begin in zip(rows, first, strict=True)]),
        np.concatenate([letter for _, letter, _ in rows]),
        np.concatenate([value for *_, value in rows]),
    )
    return spread(words, more, keep, words.letter[keep], put)


def _findings(holes: _HoleMoves) -> list[Finding]:
    text = [
        (say("{name} is not written out, and its moves are missing: {reason}. Correct it, or post straight "
             "moves.",
             name=name, reason=reason), row)
        for (name, reason), row in holes.refused.items()
    ]  # fmt: skip
    return [report_finding(codes.CYCLE_KIND[0], sentence, line=row) for sentence, row in text[:MOST_NAMED]]
