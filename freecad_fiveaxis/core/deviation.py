# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the tip leaves the commanded segment while the axes move linearly, with a proven bound.

chord             the straight segment between the real tips at a block's two ends: what the block commands.
line deviation    largest distance of the real path from the infinite line through the chord (So et al. 2008, eq. 6).
segment deviation largest distance from the chord itself: where the tool should have been. Never less than the former.
bound             a proven upper bound of the segment deviation, whatever u, rounding of the arithmetic included.
axis deviation    largest angle of the real tool axis off the plane of the block's two end axes (``axis_swing``).
same-u deviation  largest distance from the point of the chord with the same u; it also counts uneven speed.

Ordinary blocks are proven by the quartic through five points of the path, the others by search. Both are derived and
proven at the head of their modules, and in docs/deviation.md.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from . import so2008
from .axis_swing import small_swing, swing
from .bound import CHUNK, allowance, bending, close_levers, end_levers
from .errors import ProgramError, SettingsError
from .findings import Finding
from .kinematics import Chain
from .progress import Progress, silent
from .quartic import POINT, bow, chord, node_poses
from .records import Floats, Ints, freeze
from .search import Chords, farthest
from .trajectory import Frames, Vectors, at, axis, chained_motion, flat_length, frames, inner, motion, outer, tip, to_work

FARTHEST_WORD = 1e7
"""mm or deg: beyond this a word is a mistake, and a float no longer holds a micron of it after arithmetic."""

SEARCHED = 2048
"""Blocks searched at a time: their pieces fill a chunk."""

REPORT_EVERY = 0.25
"""s between calls of progress."""


@dataclass(frozen=True, eq=False)
class Deviation:
    """One row a block of the Program, row 0 (the first position) all zero.

    ``line`` (m,) mm: largest distance of the real tip path from the infinite line through the block's ends (So et al.,
    eq. 6), at ``u_line``; ``segment`` (m,) mm: largest distance from the commanded segment, at ``u_segment``; ``bound``
    (m,) mm: proven upper bound of ``segment``; ``axis`` (m,) rad: largest angle by which the real tool axis leaves the plane
    of the block's two end axes; ``place`` (m, 3) mm: the real tip at ``u_segment``, work frame.
    """

    line: Floats
    u_line: Floats
    segment: Floats
    u_segment: Floats
    bound: Floats
    axis: Floats
    place: Floats
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, None, line="f", u_line="f", segment="f", u_segment="f", bound="f", axis="f", place="f3")


METHODS = ("exact", "so2008")
"""Of the line deviation; everything else is exact with either."""


def measure(links: Chain, words: ArrayLike, method: str = "exact", progress: Progress = silent) -> Deviation:
    """The deviation of every block of a program, from its words as rounded for the controller.

    ``words`` (m, 5) mm and **degrees** in the chain's word order, turns not folded. ``method``: ``exact``, or ``so2008`` for
    ``line`` and ``u_line`` by the model of So et al. (module ``so2008``); every other column is exact with either. Distances
    are within 1e-5 of their value or 1e-6 mm; ``bound`` is no more than that above ``segment``, but for rounding. Raises
    ProgramError for words that are no numbers or beyond :data:`FARTHEST_WORD`, SettingsError for an unknown method.
    """
    if method not in METHODS:
        raise SettingsError(f"unknown method {method!r} of the line deviation; use one of {', '.join(METHODS)}", method)
    rows = checked_words(words)
    result = _exact(frames(links), rows, paced(progress))
    if method == "exact":
        return result
    line, u_line, findings = so2008.line_deviation(links, rows, paced(progress))
    return replace(result, line=line, u_line=u_line, findings=findings)


def checked_words(words: ArrayLike) -> Floats:
    """``words`` as floats (m, 5), or ProgramError with the row that cannot be used."""
    rows = np.asarray(words, float)
    if rows.ndim != 2 or rows.shape[1] != 5:
        raise ProgramError(f"words have shape {rows.shape}; give one row of five words for each block", rows.shape)
    good = np.abs(rows) <= FARTHEST_WORD  # False for NaN
    if not good.all():
        row, word = (int(i) for i in np.argwhere(~good)[0])
        value = float(rows[row, word])
        raise ProgramError(f"word {word + 1} of row {row} is {value:g}; words are numbers up to {FARTHEST_WORD:g}", value)
    return rows


def paced(progress: Progress) -> Progress:
    """``progress``, called no more often than every :data:`REPORT_EVERY` seconds."""
    last = time.monotonic()

    def report(stage: str, fraction: float) -> None:
        nonlocal last
        if time.monotonic() - last >= REPORT_EVERY:
            progress(stage, fraction)
            last = time.monotonic()

    return report


@dataclass(frozen=True, eq=False)
class _Table:
    """The columns of a :class:`Deviation` while they are filled; ``place`` (3, m)."""

    line: Floats
    u_line: Floats
    segment: Floats
    u_segment: Floats
    bound: Floats
    axis: Floats
    place: Floats

    def put(self, frame: Frames, rows: Ints | slice, place: Vectors, **columns: Floats) -> None:
        for column, values in zip(self.place, to_work(frame, place), strict=True):
            column[rows] = values
        for name, values in columns.items():
            getattr(self, name)[rows] = values


def _exact(frame: Frames, words: Floats, progress: Progress) -> Deviation:
    count = len(words)
    line, u_line, segment, u_segment, bound, angle = np.zeros((6, count))
    table = _Table(line, u_line, segment, u_segment, bound, angle, np.zeros((3, count)))
    waiting: list[Ints] = []
    for first in range(0, count - 1, CHUNK):
        last = min(first + CHUNK, count - 1)
        waiting.append(first + 1 + _fit(frame, words[first : last + 1], slice(first + 1, last + 1), table))
        if sum(map(len, waiting)) >= SEARCHED or last == count - 1:
            _search(frame, words, np.concatenate(waiting), table)
            waiting.clear()
        progress("deviation", last / count)
    columns = {name: value for name, value in vars(table).items() if name != "place"}
    return Deviation(**columns, place=table.place.T)


def _fit(frame: Frames, words: Floats, rows: slice, table: _Table) -> Ints:
    """Measure the blocks between these rows of words by quartics; returns the indices of the blocks that need a search."""
    move, poses = chained_motion(frame, words)
    y = inner(frame, poses)
    tips, axes, reach = np.array(outer(poses, y)), axis(frame, poses), flat_length(y[0], y[1])
    nodes = node_poses(move, poses)
    way = chord(tips[:, :-1], tips[:, 1:])
    found = bow(way, np.array(tip(frame, nodes)), end_levers(move, reach[:-1], reach[1:]))
    bound = found.bound + allowance(move) + np.where(way.length > POINT, 0.0, POINT)
    angle = small_swing(_but_last(axes), _but_first(axes), axis(frame, nodes))
    distance, u = found.distance, found.u
    table.put(frame, rows, (found.place[0], found.place[1], found.place[2]), line=distance, u_line=u, segment=distance, u_segment=u, bound=bound, axis=angle)
    return np.flatnonzero(~found.proven)


def _search(frame: Frames, words: Floats, rows: Ints, table: _Table) -> None:
    """Measure the blocks that end in these rows by search."""
    for part in np.array_split(rows, -(-len(rows) // SEARCHED)):
        move = motion(frame, words[part - 1], words[part])
        levers = close_levers(frame, move)
        start, end = (tip(frame, at(move, np.full_like(move.a, u))) for u in (0.0, 1.0))
        way = chord(np.array(start), np.array(end))
        second, third = bending(levers, 2), bending(levers, 3)
        along = (way.along[0], way.along[1], way.along[2])
        endless = np.full_like(way.length, np.inf)
        line, u_line, _ = farthest(frame, Chords(move, start, along, -endless, endless, second, third, levers.turn))
        low, high = np.zeros_like(way.length), way.length
        segment, u, bound = farthest(frame, Chords(move, start, along, low, high, second, third, levers.turn))
        bound = bound + allowance(move) + np.where(way.length > POINT, 0.0, POINT)
        place = tip(frame, at(move, u))
        angle = swing(frame, move)
        table.put(frame, part, place, line=line, u_line=u_line, segment=segment, u_segment=u, bound=bound, axis=angle)


def _but_last(v: Vectors) -> Vectors:
    return v[0][:-1], v[1][:-1], v[2][:-1]


def _but_first(v: Vectors) -> Vectors:
    return v[0][1:], v[1][1:], v[2][1:]
