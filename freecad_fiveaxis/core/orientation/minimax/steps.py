# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a way through the states costs, and which states and steps there may be.

step      from a state of one row to a state of the next: a block of the program.
level     the largest deviation of a run.
side      of the pole: the branch. A step may change it only where its great arc goes through the pole, for
          elsewhere that is a break of the joint path.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import Chain, RotaryPair, forward

from .blocks import QUARTERS, Ends, Ring, States, bow, states
from .rows import Rows, is_allowed

DOUBLINGS = 4
"""The deviation counts with the power 2 ** (this + 1), 32. Of 50 blocks that are all at the level, such a sum
misses the smallest largest by at most 13 %, mostly far less."""
EVENLY, STILL = 1e-3, 1e-6
"""Weights of the squared deviation, and of the squared turn in units of the largest tilt: among ways of one
level, the one that deviates less elsewhere and turns less."""
POLE = 1e-4
"""States nearer to the pole (rad) are left out: the first word is not known there."""
THROUGH = math.radians(0.08)
"""A great arc that passes the pole that near (rad) goes through it: less than what the joint path takes for a
crossing."""
STEADY = 1e-6
"""rad: a turn that rounding may make."""
TURN = 2.0 * math.pi
FRONT = math.radians(60.0)
"""How far from straight ahead the contact of a cutter with a ring may go."""


@dataclass(frozen=True, eq=False)
class Task:
    """What bounds the states. ``reach`` mm from the ball's centre to the driven point; ``max_tilt`` rad;
    ``minutes`` (k,) the time of the block that leads to each row; ``least`` (k, 2) rad: the turn of it that
    is allowed whatever the time; ``ring`` of a cutter that is no ball."""

    kinematics: Chain
    reach: float
    max_tilt: float
    minutes: Floats
    least: Floats
    ring: Ring | None = None

    def take(self, rows: Ints) -> Task:
        """Return the task for some of the rows."""
        ring = None if self.ring is None else self.ring.take(rows)
        return Task(self.kinematics, self.reach, self.max_tilt, self.minutes[rows], self.least[rows], ring)

    @property
    def ring_radius(self) -> float:
        """mm; 0 for a ball."""
        return 0.0 if self.ring is None else self.ring.radius

    @property
    def pair(self) -> RotaryPair:
        """The two rotary axes."""
        return RotaryPair.of(self.kinematics.direction[3], self.kinematics.direction[4])


def axes_of(kinematics: Chain, angles: Floats) -> Floats:
    """Return the unit tool axis (k, 3) at rotary words (k, 2) rad."""
    return forward(kinematics, np.column_stack([np.zeros((len(angles), 3)), angles]))[1]


def levels(task: Task, at: Rows, angles: Floats) -> Floats:
    """Return the largest deviation (p,) mm of each run."""
    return np.asarray(np.maximum.reduceat(deviations(task, at, angles), at.first))


def deviations(task: Task, at: Rows, angles: Floats) -> Floats:
    """Return the deviation (k,) mm of the block that leads to each row; 0 where a run begins."""
    start, end = _blocks(states(task.kinematics, angles.T[:, None], at.centre, task.reach, task.ring).ends)
    found = np.zeros(len(angles))
    found[1:] = bow(task.kinematics, start, end, QUARTERS)[0, 0]
    found[at.first] = 0.0
    return found


def hastes(task: Task, at: Rows, angles: Floats) -> Floats:
    """How many times faster than it may a rotary axis turns in each run (p,); below 1: none does."""
    turn = np.abs(np.diff(angles, axis=0, prepend=angles[:1]))
    turn[at.first] = 0.0
    most = np.maximum(task.kinematics.rate[3:] * task.minutes[:, None], task.least)
    return np.asarray(np.maximum.reduceat((turn / (most + STEADY)).max(axis=1), at.first))


def usable(task: Task, at: Rows, grid: Floats, there: States) -> Bools:
    """Which states (m, k) the limits and the row's range allow; ``grid`` (2, m, k) rad."""
    low, high = task.kinematics.low[3:, None, None], task.kinematics.high[3:, None, None]
    good = ((grid >= low) & (grid <= high)).all(0) & (np.abs(np.sin(grid[1] - task.pair.best)) > POLE)
    good &= is_allowed(at.before, at.after, task.max_tilt, there.axis)
    return np.asarray(good if task.ring is None else good & _in_front(task.ring, there.axis))


def _in_front(ring: Ring, axis: Floats) -> Bools:
    """For which axes (3, m, k) the contact stays in front of the hub, within FRONT of straight ahead: for
    others a small change of the axis would throw the hub from one side of the contact to the other."""
    flat = np.moveaxis(axis, 0, -1).reshape(-1, 3)
    out = ring.out(flat).reshape(*axis.shape[1:], 3)
    return np.asarray(-(out * ring.feed).sum(axis=-1) >= math.cos(FRONT) * ring.radius)


def step_costs(
    task: Task,
    at: Rows,
    there: States,
    level: Floats,
    shares: Sequence[float],
    nearest: bool = False,
    known: int | None = None,
) -> Floats:
    """Costs (m, m, k - 1) of the steps between the states, inf where there must be none; from run to run they
    mean nothing.

    ``level`` (p,) mm: what the deviations, those at ``shares`` of the blocks, are measured by; ``nearest``:
    the first word turns the shorter way; ``known``: a state of every row whose steps to each other are
    allowed whatever they are.
    """
    start, end = _blocks(there.ends)
    ratio = bow(task.kinematics, start, end, shares, nearest)
    ratio /= level[at.run[1:]]
    np.square(ratio, out=ratio)
    cost = ratio * EVENLY
    for _ in range(DOUBLINGS):
        np.square(ratio, out=ratio)
    cost += ratio
    bad = _sides_differ(task, there, start, end)
    for word, (one, two) in enumerate(((start.a, end.a), (start.b, end.b))):
        turn = two[None] - one[:, None]
        if nearest and word == 0:
            turn -= TURN * np.rint(turn / TURN)
        most = np.maximum(task.kinematics.rate[3 + word] * task.minutes[1:], task.least[1:, word])
        bad |= np.abs(turn) > most
        turn *= turn
        turn *= STILL / task.max_tilt**2
        cost += turn
    if known is not None:
        bad[known, known] = False
    cost[bad] = np.inf
    return cost


def _blocks(ends: Ends) -> tuple[Ends, Ends]:
    """Both ends of the blocks from each row to the next."""
    count = ends.a.shape[1]
    return ends.take(slice(0, count - 1)), ends.take(slice(1, count))


def side(task: Task, second: Floats) -> Bools:
    """Return the branch of second rotary words, as on which side of the pole they are."""
    return np.asarray(np.sin(second - task.pair.best) > 0.0)


def _sides_differ(task: Task, there: States, start: Ends, end: Ends) -> Bools:
    """Return the steps (m, m', k) that change sides of the pole and do not go through it."""
    one, two = side(task, start.b), side(task, end.b)
    bad = np.zeros((len(one), len(two), one.shape[1]), bool)
    rows = np.flatnonzero(~((one.all(0) & two.all(0)) | ~(one.any(0) | two.any(0))))
    if len(rows):
        through = through_pole(
            task.kinematics.direction[3], there.axis[:, :, rows], there.axis[:, :, rows + 1]
        )
        bad[..., rows] = (one[:, None, rows] != two[None, :, rows]) & ~through
    return bad


def through_pole(first: Floats, one: Floats, two: Floats) -> Bools:
    """Which great arcs from axes ``one`` (3, m, k) to axes ``two`` (3, m', k) pass ``first`` (3,) or its
    opposite."""
    frame = np.linalg.svd(first[None])[2][1:]
    (x0, y0), (x1, y1) = (np.einsum("ij,j...->i...", frame, axis) for axis in (one[:, :, None], two[:, None]))
    area = np.abs(x0 * y1 - y0 * x1)
    return np.asarray(
        (x0 * x1 + y0 * y1 < 0.0) & (area <= THROUGH * np.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2))
    )
