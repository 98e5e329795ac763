# SPDX-License-Identifier: LGPL-2.1-or-later
"""In which blocks two convex pieces of a machine meet, with a proof for all others.

free      a cell of joints, if a gap is left in it along some direction (:mod:`.carried_motion`). What is not
          free and does not meet in its middle is halved.
grid      cells whose ends lie on a grid of each joint. Blocks that stay in one cell are free together, and a
          program comes to the same cells again and again: so most of it is proven with few cells, from a
          coarse grid to finer ones.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.convex import Convex, find_gaps

from .carried_motion import CarriedMotion, Cells

SLICE = 4096
"""Cells at a time."""

MOST_CELLS = 20_000
"""Of a block; one that needs more is not proven."""

GRIDS = (4, 16, 64, 256, 1024)
"""Parts of the range of each joint."""

WORTH = 2
"""So many blocks must there be for each cell of a grid; a finer one has no more of them."""


class Pair(NamedTuple):
    """How a piece moves, seen from the one that is ``standing``; pieces that are ``within`` mm of each other
    meet."""

    motion: CarriedMotion
    standing: Convex
    within: float = 0.0


class Meetings(NamedTuple):
    """Of m blocks: ``met`` (m,), at ``u`` (m,), with joints (m, k) mm and rad, at ``place`` (m, 3) mm, seen
    from the standing piece; ``unproven`` (m,): neither met nor free."""

    met: Bools
    u: Floats
    joints: Floats
    place: Floats
    unproven: Bools


def find_meetings(pair: Pair, start: Floats, end: Floats, joined: bool, slack: float) -> Meetings:
    """Find in which blocks, from joints ``start`` to ``end`` (m, k) mm and rad, the pieces meet; ``joined``:
    all joints go in step, else each as it will. What comes nearer by less than ``slack`` mm may be called
    free."""
    count = len(start)
    found = Meetings(
        np.zeros(count, np.bool_),
        np.zeros(count),
        start.copy(),
        np.zeros((count, 3)),
        np.zeros(count, np.bool_),
    )
    rows = open_blocks(pair, np.minimum(start, end), np.maximum(start, end))
    if len(rows):
        only, which = _different(np.concatenate([start[rows], end[rows]], axis=1))
        one = _search(pair, only[:, : start.shape[1]], only[:, start.shape[1] :], joined, slack)
        for part, new in zip(found, one, strict=True):
            part[rows] = new[which]
    return found


def open_blocks(pair: Pair, low: Floats, high: Floats) -> Ints:
    """Pick the blocks that no cell of a grid proves to be free; joints (m, k) between ``low`` and
    ``high``."""
    rows: Ints = np.arange(len(low))
    first = low.min(axis=0, initial=np.inf)
    span = high.max(axis=0, initial=-np.inf) - first
    if not len(rows):
        return rows
    for parts in (1, *GRIDS):
        size = np.where(span > 0.0, span / parts, 1.0)
        corner = np.floor((low[rows] - first) / size), np.ceil((high[rows] - first) / size)
        cells, which = _different(np.concatenate(corner, axis=1))
        if parts > 1 and WORTH * len(cells) > len(rows):
            return rows
        low_, high_ = cells[:, : low.shape[1]] * size + first, cells[:, low.shape[1] :] * size + first
        free = free_cells(pair, low_, high_)
        rows = rows[~free[which]]
        if not len(rows):
            return rows
    return rows


def free_cells(pair: Pair, low: Floats, high: Floats) -> Bools:
    """Tell of cells of joints, each from ``low`` to ``high`` (n, k), mm and rad, which are proven to be free
    all over (n,)."""
    parts = [
        _look(pair, _cells(low[k : k + SLICE], high[k : k + SLICE]), False)[0]
        for k in range(0, len(low), SLICE)
    ]
    return np.concatenate(parts) if parts else np.zeros(0, np.bool_)


def _different(rows: Floats) -> tuple[Floats, Ints]:
    """Give the different ones of rows (n, k), and which of them each is (n,). Those that follow their like
    are dropped before the rest is sorted, which is dear."""
    new = np.concatenate([[True], (np.diff(rows, axis=0) != 0.0).any(axis=1)])
    only, which = np.unique(rows[new], axis=0, return_inverse=True)
    return only, which.reshape(-1)[np.cumsum(new) - 1]


def _cells(start: Floats, end: Floats) -> Cells:
    every, guess = np.arange(len(start)), np.tile((0.0, 0.0, 1.0), (len(start), 1))
    half = np.full(len(start), 0.5)
    return Cells(every, 0.5 * (start + end), 0.5 * (end - start), half, half, guess)


def _look(pair: Pair, cells: Cells, joined: bool) -> tuple[Bools, Bools, Floats, Floats, Floats]:
    """Tell of cells (n) which are free and which meet in the middle; the directions (n, 3) of the gaps, the
    places (n, 3), and how far (n,) mm each cell reaches."""
    motion, standing, within = pair
    lines = motion.lines(cells.middle)
    _, far = motion.travel(lines, cells.half)
    middle = lines.poses.turn @ motion.moved.middle + lines.poses.shift - standing.middle
    free = np.linalg.norm(middle, axis=1) - motion.moved.reach - standing.reach - within > far
    met, way, place = np.zeros_like(free), cells.guess.copy(), np.zeros_like(middle)
    for search in (False, True):
        rows = np.flatnonzero(~free)
        lines_, half = lines.take(rows), cells.half[rows]
        if search:
            gaps = find_gaps(motion.moved, standing, lines_.poses, within, far[rows], cells.guess[rows])
            met[rows], way[rows], place[rows] = gaps.met, gaps.way, gaps.place
        free[rows] = ~met[rows] & (motion.least_gap(standing, lines_, half, way[rows], joined) > within)
    return free, met, way, place, far


def _search(pair: Pair, start: Floats, end: Floats, joined: bool, slack: float) -> Meetings:
    count = len(start)
    none, spent = np.zeros(count, np.bool_), np.zeros(count, np.int64)
    found = Meetings(none, np.zeros(count), start.copy(), np.zeros((count, 3)), none.copy())
    todo = _slice_cells(_cells(start, end))
    while todo:
        cells = todo.pop()
        spent += np.bincount(cells.owner, minlength=count)
        found.unproven[(spent > MOST_CELLS) & ~found.met] = True
        cells = cells.take(~(found.met | found.unproven)[cells.owner])
        free, met, way, place, far = _look(pair, cells, joined)
        at = cells.owner[met]
        found.met[at], found.u[at], found.joints[at], found.place[at] = (
            True,
            cells.u[met],
            cells.middle[met],
            place[met],
        )
        rows = np.flatnonzero(~free & (far > slack) & ~found.met[cells.owner])
        todo += _slice_cells(_halve_cells(pair.motion, cells.take(rows)._replace(guess=way[rows]), joined))
    return found


def _halve_cells(motion: CarriedMotion, cells: Cells, joined: bool) -> Cells:
    """Halve cells: in time, or across the joint that moves most."""
    owner, middle, half, u, wide, guess = cells
    half_ = half.copy()
    if joined:
        half_ *= 0.5
        step, later = half_, 0.5 * wide
    else:
        lever = motion.lines(middle).lever.T
        every, most = np.arange(len(half)), (np.abs(half) * lever).argmax(axis=1)
        half_[every, most] *= 0.5
        step, later = half - half_, 0.0 * wide
    return Cells(
        np.tile(owner, 2), np.concatenate([middle - step, middle + step]), np.tile(half_, (2, 1)),
        np.concatenate([u - later, u + later]), np.tile(wide - later, 2), np.tile(guess, (2, 1)),
    )  # fmt: skip


def _slice_cells(cells: Cells) -> list[Cells]:
    count = len(cells.owner)
    return [cells.take(np.arange(first, min(first + SLICE, count))) for first in range(0, count, SLICE)]
