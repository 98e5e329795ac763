# SPDX-License-Identifier: LGPL-2.1-or-later
"""Branch and winding of the rotary words, chosen for the whole path: the way of least rotary travel.

state     one way to take up the axis of a row: a branch, and a winding for each rotary axis that has limits.
winding   which turn a rotary word lies on: words that differ by whole turns are the same pose, but not the same place on
          an axis with limits.
travel    |change of the first rotary word| + |change of the second|, rad, summed over the steps.
break     a step of a cutting move that cannot be driven while the tool cuts: a word would have to change by more than half
          a turn, or the branch would change away from the pole. It costs BREAK on top of its travel.

The rows are the layers of a graph and the states its nodes, so the best way is a shortest path over layers: a product of
matrices in (min, +) algebra. It is exact. A scan on two levels keeps Python out of the rows: the steps are cut into blocks of
about the square root of their number, all blocks advance together by one step at a time, then the blocks are joined.

Without limits only the two branches are states and every step takes the nearest winding. That way's cost is a lower bound of
the limited problem's; so when it fits into the limits after whole turns it is the answer there too.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .progress import Progress, silent
from .records import Bools, Bytes, Floats, Ints

BREAK = 1000.0
"""Cost of a break, rad: a retract costs more than any turning back above the part that a job is likely to need."""
POLE_ANGLE = math.radians(0.5e-4)
"""So near to the pole (rad) the axis is taken as the pole: half a step of a rotary word with four decimals of a degree."""
SLACK = 1e-9
"""Rounding allowed to a word at its limit, rad: far below any controller's step."""
PREFER_ZERO = 1e-9
"""Weight of the first row's words, rad per rad: among ways of equal travel the one that starts nearest to zero is taken."""
SMALL_TURN = math.radians(0.1)
"""A step of less rotary travel than this is no break whatever its branches: its axis stays within half of it of both ends."""
STATES = 24
"""Most states that are searched: the work grows with their cube. A word that fits into its limits on the nearest windings alone
never needs them; of one that does not, on an axis of more turns, only the turns around zero are used, at the price of rewinds."""
SLAB = 1 << 20
"""Costs (states x states x steps) that are held at once: 8 MB."""

TURN = 2.0 * math.pi
StepCost = Callable[[int, int], Floats]


@dataclass(frozen=True, eq=False)
class Layers:
    """``word`` (2, s, n) rad: first and second rotary word of each state at each row; ``fits`` (s, n) within the limits;
    ``branch`` (s,); ``wraps``: for each word, True where it has one state a branch and takes the nearest winding."""

    word: Floats
    fits: Bools
    branch: Bytes
    wraps: list[bool]


def choose(
    angles: Floats, fits: Bools, low: Floats, high: Floats, cutting: Bools, crossing: Bools, progress: Progress = silent
) -> tuple[Floats, Bytes]:
    """Rotary words (n, 2) rad, turns not folded, and branch (n,) of least travel and fewest breaks.

    ``angles`` (2, n, 2) rad of both branches in (-pi, pi]; ``fits`` (2, n) from :func:`within_limits`, at least one of the two
    true at every row; ``low``, ``high`` (2,) rad; ``cutting`` and ``crossing`` (n - 1,): the step is made while the tool cuts;
    the step goes through the pole.
    """
    wraps = [True, True]
    while True:
        words, branch = _solve(_layers(angles, fits, low, high, wraps), cutting, crossing, progress)
        turns = [_fitting_turns(words[:, axis], low[axis], high[axis]) for axis in range(2)]
        if not any(math.isnan(turn) for turn in turns):
            for axis, turn in enumerate(turns):
                words[:, axis] = np.clip(words[:, axis] + TURN * turn, low[axis], high[axis])
            return words, branch
        wraps = [wrap and not math.isnan(turn) for wrap, turn in zip(wraps, turns, strict=True)]
        low, high = _window(low, high, wraps)


def within_limits(angles: Floats, low: Floats, high: Floats) -> Bools:
    """Whether some winding of both words lies within the limits, (2, n) for each branch; False where NaN."""
    fits = np.asarray(~np.isnan(angles).any(2))
    for axis in range(2):
        if high[axis] - low[axis] < TURN:
            fits &= _least_word(angles[:, :, axis], low[axis]) <= high[axis] + SLACK
    return fits


def broken_steps(words: Floats, branch: Bytes, cutting: Bools, crossing: Bools) -> Bools:
    """The breaks (n - 1,) of a way that was chosen."""
    travel = np.abs(np.diff(words, axis=0))
    swap = (branch[1:] != branch[:-1]) & ~crossing & (travel.sum(1) > SMALL_TURN)
    return np.asarray(cutting & (swap | (travel > math.pi + SLACK).any(1)))


def _limited(low: float, high: float) -> bool:
    """A word that is limited on one side only can always be brought inside by whole turns."""
    return math.isfinite(low) and math.isfinite(high)


def _least_word(angle: Floats, low: float) -> Floats:
    """The least winding of ``angle`` that is not below ``low``."""
    return np.asarray(angle - TURN * np.floor((angle - low + SLACK) * (1.0 / TURN)))


def _window(low: Floats, high: Floats, wraps: list[bool]) -> tuple[Floats, Floats]:
    """Limits that make no more than STATES states: of the words that need them, the turns around zero are kept."""
    low, high = low.copy(), high.copy()
    for axis in (axis for axis in range(2) if not wraps[axis]):
        other = 1 if wraps[1 - axis] else _windings(low[1 - axis], high[1 - axis])
        width = TURN * (max(2, STATES // 2 // other) - 1)
        if high[axis] - low[axis] > width:
            low[axis] = np.clip(-0.5 * width, low[axis], high[axis] - width)
            high[axis] = low[axis] + width
    return low, high


def _windings(low: float, high: float) -> int:
    return int((high - low + 2 * SLACK) // TURN) + 1 if _limited(low, high) else 1


def _fitting_turns(word: Floats, low: float, high: float) -> float:
    """The whole turns nearest to none that bring all of ``word`` (n,) within the limits; NaN where none do."""
    least = math.ceil((low - 2 * SLACK - float(word.min())) / TURN) if math.isfinite(low) else -math.inf
    most = math.floor((high + 2 * SLACK - float(word.max())) / TURN) if math.isfinite(high) else math.inf
    return min(max(0.0, least), most) if least <= most else math.nan


def _layers(angles: Floats, fits: Bools, low: Floats, high: Floats, wraps: list[bool]) -> Layers:
    count = [1 if wraps[axis] else _windings(low[axis], high[axis]) for axis in range(2)]
    branch, *winding = (part.ravel() for part in np.indices((2, count[0], count[1])))
    word, fits = np.empty((2, len(branch), angles.shape[1])), fits[branch]
    for axis in range(2):
        angle = angles[:, :, axis]
        if not fits.all():
            angle = np.nan_to_num(angle)
        if wraps[axis]:
            word[axis] = angle[branch]
        else:
            word[axis] = _least_word(angle, low[axis])[branch] + TURN * winding[axis][:, None]
            fits &= word[axis] <= high[axis] + SLACK
    used = np.flatnonzero(fits.any(1))
    return Layers(word[:, used], fits[used], branch[used].astype(np.int8), wraps)


def _solve(layers: Layers, cutting: Bools, crossing: Bools, progress: Progress) -> tuple[Floats, Bytes]:
    """The best states' words (n, 2), unwound where they wrap, and branch (n,)."""
    entry = PREFER_ZERO * np.abs(layers.word[:, :, 0]).sum(0)
    entry[~layers.fits[:, 0]] = math.inf
    banned = np.where(cutting & ~crossing, BREAK, 0.0)
    held = np.where(cutting, BREAK, 0.0)

    def cost(start: int, end: int) -> Floats:
        return _step_cost(layers, held[start:end], banned[start:end], start, end)

    state = least_path(entry, cost, len(cutting), progress)
    words, at = np.empty((2, len(state))).T, state * len(state) + np.arange(len(state))
    for axis in range(2):
        words[:, axis] = layers.word[axis].ravel().take(at)
        if layers.wraps[axis]:
            words[1:, axis] -= TURN * np.cumsum(np.rint(np.diff(words[:, axis]) / TURN))
    return words, layers.branch[state]


def _step_cost(layers: Layers, held: Floats, banned: Floats, start: int, end: int) -> Floats:
    """Cost (s, s, end - start) of the steps that leave rows ``start`` to ``end``, from state to state."""
    count = len(layers.branch)
    cost = np.empty((count, count, end - start))
    closed = np.where(layers.fits[:, start + 1 : end + 1], 0.0, math.inf)
    for this, after in np.ndindex(count, count):
        total = cost[this, after]
        total[:] = 0.0
        wide = np.zeros(end - start, bool)
        for axis, word in enumerate(layers.word):
            step = word[after, start + 1 : end + 1] - word[this, start:end]
            if layers.wraps[axis]:
                step -= TURN * np.rint(step * (1.0 / TURN))
            np.abs(step, out=step)
            if not layers.wraps[axis]:
                wide |= step > math.pi + SLACK
            total += step
        if layers.branch[this] != layers.branch[after]:
            total += np.where(wide, held, banned * (total > SMALL_TURN))
        elif not all(layers.wraps):
            total += wide * held
        total += closed[after]
    return cost


def least_path(entry: Floats, cost: StepCost, steps: int, progress: Progress = silent) -> Ints:
    """The states (steps + 1,) of the cheapest way through the layers.

    ``entry`` (s,) cost of starting in each state; ``cost(start, end)`` the (s, s, end - start) costs of those steps, inf where
    there is no way. At least one way must be finite.
    """
    count = len(entry)
    blocks = max(1, math.isqrt(max(1, SLAB // count**2)))
    value, traces = entry, []
    for start in range(0, steps, blocks**2):
        progress("joint path", start / steps)
        end = min(start + blocks**2, steps)
        folded = _fold(cost(start, end), blocks)
        value, trace = _advance(value, folded)
        traces.append((start, end, trace))
    state = np.empty(steps + 1, np.int64)
    state[steps] = value.argmin()
    for start, end, trace in reversed(traces):
        state[start:end] = _retrace(trace, int(state[end]))[: end - start]
    return state


def _fold(cost: Floats, blocks: int) -> Floats:
    """Steps as (position, s, s, block), the end filled with steps that stay where they are."""
    count, steps = len(cost), cost.shape[2]
    length = -(-steps // blocks)
    stay = np.where(np.eye(count, dtype=bool), 0.0, math.inf)
    filler = np.broadcast_to(stay[:, :, None], (count, count, length * blocks - steps))
    return np.ascontiguousarray(np.concatenate([cost, filler], 2).reshape(count, count, blocks, length).transpose(3, 0, 1, 2))


def _advance(value: Floats, cost: Floats) -> tuple[Floats, Bytes]:
    """The least values (s,) after the slab, and for each state where it came from, (position, s, block)."""
    length, count, _, blocks = cost.shape
    product = cost[0]
    for step in cost[1:]:
        product = _product(product, step)
    starts = np.empty((count, blocks))
    for block, matrix in enumerate(np.ascontiguousarray(product.transpose(2, 0, 1))):
        starts[:, block] = value
        value = (value[:, None] + matrix).min(0)
    trace = np.zeros((length, count, blocks), np.int8)
    for position, step in enumerate(cost):
        best = starts[0] + step[0]
        for state in range(1, count):
            other = starts[state] + step[state]
            trace[position][other < best] = state
            np.minimum(best, other, out=best)
        starts = best
    return starts[:, -1], trace


def _product(left: Floats, right: Floats) -> Floats:
    """(min, +) products of matrices (s, s, block)."""
    best = left[:, 0, None] + right[None, 0]
    for state in range(1, len(left)):
        np.minimum(best, left[:, state, None] + right[None, state], out=best)
    return np.asarray(best)


def _retrace(trace: Bytes, last: int) -> Ints:
    """The states before every step of the slab, in the order of the steps, from the state after the last one."""
    length, count, blocks = trace.shape
    block = np.arange(blocks)
    origin = np.broadcast_to(np.arange(count)[:, None], (count, blocks))
    for back in trace[::-1]:
        origin = back.ravel().take(origin * blocks + block).astype(np.int64)
    state = np.empty(blocks, np.int64)
    for this in range(blocks - 1, -1, -1):
        state[this] = last
        last = int(origin[last, this])
    states = np.empty((length, blocks), np.int64)
    for position in range(length - 1, -1, -1):
        state = trace[position].ravel().take(state * blocks + block).astype(np.int64)
        states[position] = state
    return states.T.ravel()
