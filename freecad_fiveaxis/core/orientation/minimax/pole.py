# SPDX-License-Identifier: LGPL-2.1-or-later
"""Near the pole: another way for a run to begin with, through the pole or wide around it.

pole      the tool axis that leaves the first rotary word free. Passing beside it, that word turns far for
          little.
passage   the rows of a run that are near the pole, with one on either side that stays where it is.
lattice   rotary words at equal distances: the same first words at every row, so that a straight way through
          the pole is there.

A corridor about the known way does not find the one through the pole, for between the two the deviation is
larger. So all ways on a coarse lattice are searched at once. Behind a passage that was crossed the words go
on on the other branch.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import inverse_axis

from .blocks import MIDDLE, states
from .corridor import GOOD, portions
from .rows import Rows, is_allowed
from .steps import TURN, Task, axes_of, side, step_costs, usable
from .sweep import cheapest

NEAR = 2.5
"""Largest tilts from the pole within which the lattice is searched."""
FIRST = math.radians(15.0)
"""Distance of the lattice's first words: it divides half a turn."""
SECOND = 0.4
"""Distance of its second words, in units of the largest tilt."""


def other_way(task: Task, at: Rows, angles: Floats, level: Floats) -> tuple[Ints, Floats]:
    """Return the runs (p',) that have a passage, and rotary words (k, 2) rad of all rows: in passages the
    best on the lattice, elsewhere the axes of ``angles`` (k, 2), on the other branch behind a passage that
    goes through the pole."""
    axis, branch = axes_of(task.kinematics, angles), side(task, angles[:, 1])
    passage, rows, inner = _pole_passages(task, at, axis)
    if not len(rows):
        return np.empty(0, np.int64), angles
    level = level[at.run[rows[passage.first]]]
    found = np.empty((len(rows), 2))
    for part in portions(passage, np.arange(len(passage.first)), (4 * _count(task)) ** 2):
        some, own = passage.take(part)
        mine = rows[own]
        found[own] = _search_passages(
            task.take(mine), some, angles[mine], axis[mine], inner[own], level[part]
        )
    axis[rows] = axes_of(task.kinematics, found)
    swapped = np.zeros(len(angles), bool)
    swapped[rows] = side(task, found[:, 1]) != branch[rows]
    swapped ^= _behind(swapped, at, rows[passage.first + passage.size - 1])
    return np.unique(at.run[rows]), _words(task, at, axis, branch ^ swapped, angles)


def _count(task: Task) -> int:
    """About how many states of the lattice lie within the largest tilt of one axis near the pole."""
    return round(math.pi / SECOND) * round(math.pi / FIRST) // 4


def _pole_passages(task: Task, at: Rows, axis: Floats) -> tuple[Rows, Ints, Bools]:
    """Return the passages as runs of their own, their rows (s,), and which of these are near the pole."""
    near = np.linalg.norm(np.cross(axis, task.kinematics.direction[3]), axis=1) < math.sin(
        min(NEAR * task.max_tilt, 1.0)
    )
    wider = near.copy()
    same = at.run[1:] == at.run[:-1]
    wider[1:] |= near[:-1] & same
    wider[:-1] |= near[1:] & same
    rows = np.flatnonzero(wider)
    begins = (np.diff(rows, prepend=-2) != 1) | (np.diff(at.run[rows], prepend=-1) != 0)
    first = np.flatnonzero(begins)
    run, size = np.cumsum(begins) - 1, np.diff(first, append=len(rows))
    passage = Rows(first, size, run, at.centre[rows], at.before[rows], at.after[rows])
    return passage, rows, near[rows]


def _search_passages(
    task: Task, at: Rows, angles: Floats, axis: Floats, inner: Bools, level: Floats
) -> Floats:
    """Return the best states (s, 2) of passages on the lattice."""
    grid, good = _lattice(task, at, angles, axis, inner)
    grid = np.ascontiguousarray(grid.transpose(2, 1, 0))
    there = states(task.kinematics, grid, at.centre, task.reach, task.ring)
    good = good.T & usable(task, at, grid, there)
    good[-1] = True
    cost = step_costs(task, at, there, np.maximum(level, GOOD), MIDDLE, nearest=True, known=-1)
    state = cheapest(cost, np.where(good, 0.0, np.inf), at.first, at.size)
    return np.asarray(grid[:, state, np.arange(len(state))].T)


def _lattice(task: Task, at: Rows, angles: Floats, axis: Floats, inner: Bools) -> tuple[Floats, Bools]:
    """States (s, m, 2) and which of them count (s, m). The last is the present one, the last but one the same
    axis on the other branch, which the first row of a passage does not have if it stays where it is."""
    most = (NEAR + 3.0) * task.max_tilt
    second = SECOND * task.max_tilt * (np.arange(math.ceil(most / (SECOND * task.max_tilt))) + 0.5)
    first = np.arange(-math.pi, math.pi - 0.5 * FIRST, FIRST)
    points = np.stack(np.meshgrid(first, task.pair.best + np.concatenate([-second, second])), -1).reshape(
        -1, 2
    )
    there = axes_of(task.kinematics, points)
    near = inner[:, None] & is_allowed(at.before, at.after, task.max_tilt, there.T[:, :, None]).T
    width = int(near.sum(axis=1).max())
    order = np.argsort(~near, axis=1, kind="stable")[:, :width]
    grid = np.concatenate([points[order], _other(task, axis, angles)[:, None], angles[:, None]], axis=1)
    good = np.concatenate([np.take_along_axis(near, order, 1), np.ones((len(angles), 2), bool)], axis=1)
    good[at.first, -2] &= inner[at.first]
    return grid, good


def _other(task: Task, axis: Floats, angles: Floats) -> Floats:
    """Return the words (s, 2) of the other branch."""
    both = inverse_axis(task.kinematics, axis)[0]
    same = side(task, both[0, :, 1]) == side(task, angles[:, 1])
    return np.asarray(np.where(same[:, None], both[1], both[0]))


def _behind(swapped: Bools, at: Rows, ends: Ints) -> Bools:
    """Which rows (k,) lie behind an odd number of crossings of their run; ``ends``: the last rows of
    passages."""
    ends = ends[swapped[ends] & (ends < at.first[at.run[ends]] + at.size[at.run[ends]] - 1)]
    count = np.cumsum(np.bincount(ends + 1, minlength=len(swapped)))
    return np.asarray((count - count[at.first][at.run]) % 2 == 1)


def _words(task: Task, at: Rows, axis: Floats, branch: Bools, angles: Floats) -> Floats:
    """Rotary words (k, 2) of the axes on the branches, unwound along each run from where ``angles`` begins
    it."""
    both = inverse_axis(task.kinematics, axis)[0]
    words = np.where((side(task, both[0, :, 1]) == branch)[:, None], both[0], both[1])
    step = np.diff(words, axis=0, prepend=words[:1])
    step[at.first] = words[at.first] - angles[at.first]
    turns = np.cumsum(np.rint(step / TURN), axis=0)
    base = turns[at.first][at.run] - np.rint(step[at.first] / TURN)[at.run]
    return np.asarray(words - TURN * (turns - base))
