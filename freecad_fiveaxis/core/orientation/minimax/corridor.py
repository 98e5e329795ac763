# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the level of each run small: dynamic programming in a corridor about the way that is known.

corridor  the states about the present one of every row: a grid of rotary words, first wide and coarse, then
          narrow and fine.
round     a line of the second word, one of the first, and a coarse grid of both, each searched through whole
          runs at once.

The rotary words are the coordinates because the deviation is smooth in them, at the pole too: through it the
second word just changes sign. The axis is only asked whether it is allowed. What a search makes as small as
it can be on its grid is the sum over the blocks of ``(deviation / level) ** 32``, which for a high power is
nearly the largest deviation. The present way is in the grid: no search makes that sum larger.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats, Ints

from .blocks import QUARTERS, states
from .rows import Rows
from .steps import Task, levels, step_costs, usable
from .sweep import cheapest

LINE, GRID = (21, 5), (3, 3)
"""States of a line, and along each side of a grid: of a wide corridor, and of a narrow one."""
KINDS = 3
"""A round has so many corridors: two lines and a grid."""
NARROW = 0.2
"""Half width below which a corridor is narrow, in units of the largest tilt."""
WIDEST, FINEST = 1.2, 1e-3
"""Half width of the first corridor, and that of the last, in units of the largest tilt."""
SHRINK, SLOW = 0.6, 0.9
"""The corridor becomes narrower by the first where a round did not bring the level below the second of what
it was."""
ROUNDS = 40
STEEP = 0.05
"""Nearer to the pole than this (as a sine) the corridor of the first word does not grow wider."""
GOOD = 5e-5
"""mm: a level not worth work: half of a word's last digit."""
SLAB = 1 << 22
"""Costs that are held at a time."""


def improve(task: Task, at: Rows, angles: Floats, progress: Progress = silent) -> Floats:
    """Rotary words (k, 2) rad of every row with a smaller level of each run, from ``angles`` (k, 2)."""
    width, level = np.full(len(at.first), WIDEST * task.max_tilt), levels(task, at, angles)
    best, best_level = angles, level
    for count in range(ROUNDS):
        busy = np.flatnonzero((width > FINEST * task.max_tilt) & (best_level > GOOD))
        if not len(busy):
            break
        shown = partial(_share, progress, count)
        angles, before = _round(task, at, angles, width, level, busy, shown), level
        level = levels(task, at, angles)
        width = np.where(level > SLOW * before, SHRINK * width, width)
        better = level < best_level
        best, best_level = np.where(better[at.run][:, None], angles, best), np.minimum(level, best_level)
    return best.copy()


def _share(progress: Progress, count: int, part: float) -> None:
    """How far the search is after ``count`` rounds and a part of the next."""
    progress("minimax axes", (count + part) / ROUNDS)


def portions(at: Rows, runs: Ints, edges: int) -> list[Ints]:
    """Return ``runs`` in parts whose steps, ``edges`` for each row, fit into a slab."""
    number = np.cumsum(at.size[runs]) * edges // SLAB
    return [runs[number == value] for value in np.unique(number)]


def _round(
    task: Task,
    at: Rows,
    angles: Floats,
    width: Floats,
    level: Floats,
    busy: Ints,
    shown: Callable[[float], None],
) -> Floats:
    """One corridor of each kind for the ``busy`` runs; ``shown`` hears which share of these is done."""
    done = 0
    angles, wide = angles.copy(), width[busy] > NARROW * task.max_tilt
    for runs, line, side in zip((busy[wide], busy[~wide]), LINE, GRID, strict=True):
        for part in portions(at, runs, line**2):
            some, rows = at.take(part)
            own, now = task.take(rows), angles[rows]
            for kind, offsets in enumerate(_corridors(line, side)):
                shown((done + kind / KINDS * len(part)) / len(busy))
                now = _choose_states(own, some, _grid(own, some, now, offsets, width[part]), level[part])
            angles[rows], done = now, done + len(part)
    return angles


def _corridors(count: int, side: int) -> list[Floats]:
    """Offsets (2, m) of half width 1; the middle one is the present way."""
    line, zero, edge = np.linspace(-1.0, 1.0, count), np.zeros(count), np.linspace(-0.5, 0.5, side)
    return [np.stack([zero, line]), np.stack([line, zero]), np.stack(np.meshgrid(edge, edge)).reshape(2, -1)]


def _grid(task: Task, at: Rows, angles: Floats, offsets: Floats, width: Floats) -> Floats:
    """States (2, m, k): ``angles`` (k, 2) and ``offsets`` (2, m) of them, ``width`` (p,) rad wide."""
    return np.asarray(
        angles.T[:, None] + offsets[:, :, None] * (_scale(task, angles) * width[at.run])[:, None]
    )


def _scale(task: Task, angles: Floats) -> Floats:
    """Return steps (2, k) of the words that turn the axis by equal angles."""
    sine = np.abs(np.sin(angles[:, 1] - task.pair.best))
    return np.stack([1.0 / np.maximum(sine, STEEP), np.ones(len(angles))])


def _choose_states(task: Task, at: Rows, grid: Floats, level: Floats) -> Floats:
    """Return the best states (k, 2) of a grid (2, m, k), the middle one of which is allowed whatever it
    is."""
    there, middle = states(task.kinematics, grid, at.centre, task.reach, task.ring), grid.shape[1] // 2
    good = usable(task, at, grid, there)
    good[middle] = True
    cost = step_costs(task, at, there, np.maximum(level, GOOD), QUARTERS, known=middle)
    state = cheapest(cost, np.where(good, 0.0, np.inf), at.first, at.size)
    return np.asarray(grid[:, state, np.arange(len(state))].T)
