# SPDX-License-Identifier: LGPL-2.1-or-later
"""Branch and winding of the rotary words, chosen for the whole path: the way of least rotary travel.

state     one way to take up the axis of a row: a branch, and a winding for each rotary axis that has limits.
winding   which turn a rotary word lies on: words that differ by whole turns are the same pose, but not the
          same place on an axis with limits.
travel    |change of the first rotary word| + |change of the second|, rad, summed over the steps.
break     a step of a cutting move that cannot be driven while the tool cuts: a word would have to change by
          more than half a turn, or the branch would change away from the pole. It costs BREAK on top of its
          travel, or the share of it that the step's weight is.

The rows are the layers of a graph and the states its nodes, so the best way is a shortest path over layers: a
product of matrices in (min, +) algebra. It is exact. A scan on two levels keeps Python out of the rows: the
steps are cut into blocks of about the square root of their number, all blocks advance together by one step at
a time, then the blocks are joined.

Without limits only the two branches are states and every step takes the nearest winding. That way's cost is a
lower bound of the limited problem's; so when it fits into the limits after whole turns it is the answer there
too.

gate      a step where the branch may change without a break: of a rapid, at the pole, or hardly a turn.
run       of a branch: the steps between gates, each way through them on one branch: one step of a much
          shorter graph.

Of the ways that change branch at gates only, the shorter graph has the best. Any other way costs a break, the
cheapest one, more than every step at its least; so the best one is the best of all where it costs less than
that, and mostly no other search is needed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints

BREAK = 1000.0
"""Cost of a break, rad: a retract costs more than any turning back above the part that a job is likely to
need."""
POLE_ANGLE = math.radians(0.5e-4)
"""So near to the pole (rad) the axis is taken as the pole: half a step of a rotary word with four decimals of
a degree."""
BETWEEN = 0.4
"""Weight of a break between two cuts: the tool leaves the part there anyway, and no mark stays. Two of them
are better than one inside a cut."""
SLACK = 1e-9
"""Rounding allowed to a word at its limit, rad: far below any controller's step."""
PREFER_ZERO = 1e-9
"""Weight of the first row's words, rad per rad: among ways of equal travel the one that starts nearest to
zero is taken."""
SMALL_TURN = math.radians(0.1)
"""A step of less rotary travel than this is no break whatever its branches: its axis stays within half of it
of both ends."""
STATES = 24
"""Most states that are searched: the work grows with their cube. A word that fits into its limits on the
nearest windings alone never needs them; of one that does not, on an axis of more turns, only the turns around
zero are used, at the price of rewinds."""
LONGEST = 16384
"""Steps of a branch run at most. A portion is a whole number of them: the sums, which decide between ways
that cost the same but for rounding, do not depend on portions then."""
SLAB = 1 << 20
"""Costs (states x states x steps) that are held at once: 8 MB."""

TURN = 2.0 * math.pi
StepCost = Callable[[int, int], Floats]


@dataclass(frozen=True, eq=False)
class Layers:
    """``word`` (2, s, n) rad: first and second rotary word of each state at each row; ``fits`` (s, n) within
    the limits; ``branch`` (s,); ``wraps``: for each word, True where it has one state a branch and takes the
    nearest winding."""

    word: Floats
    fits: Bools
    branch: Bytes
    wraps: list[bool]


def choose(
    angles: Floats,
    fits: Bools,
    low: Floats,
    high: Floats,
    cutting: Bools | Floats,
    crossing: Bools,
    progress: Progress = silent,
) -> tuple[Floats, Bytes]:
    """Rotary words (n, 2) rad, turns not folded, and branch (n,) of least travel and fewest breaks.

    ``angles`` (2, n, 2) rad of both branches in (-pi, pi]; ``fits`` (2, n) from :func:`within_limits`, at
    least one of the two true at every row; ``low``, ``high`` (2,) rad; ``cutting`` and ``crossing`` (n - 1,):
    the step is made while the tool cuts, or the weight of a break on it; the step goes through the pole.
    """
    wraps = [True, True]
    while True:
        words, branch = _solve(_layers(angles, fits, low, high, wraps), cutting, crossing, progress)
        turns = [_fitting_turns(words[:, axis], low[axis], high[axis]) for axis in range(2)]
        if not any(math.isnan(turn) for turn in turns):
            for word, turn, least, most in zip(words.T, turns, low, high, strict=True):
                word += TURN * turn
                np.clip(word, least, most, out=word)
            return words, branch
        wraps = [wrap and not math.isnan(turn) for wrap, turn in zip(wraps, turns, strict=True)]
        low, high = _window(low, high, wraps)


def within_limits(angles: Floats, low: Floats, high: Floats) -> Bools:
    """Whether some winding of both words lies within the limits, (2, n) for each branch; False where NaN."""
    fits = np.empty((2, angles.shape[1]), bool)

    def fill(rows: slice) -> None:
        fits[:, rows] = ~np.isnan(angles[:, rows, 0] + angles[:, rows, 1])
        for axis in range(2):
            if high[axis] - low[axis] < TURN:
                fits[:, rows] &= _least_word(angles[:, rows, axis], low[axis]) <= high[axis] + SLACK

    in_threads(fill, chunks(angles.shape[1]))
    return fits


def find_broken_steps(words: Floats, branch: Bytes, cutting: Bools, crossing: Bools) -> Bools:
    """Return the breaks (n - 1,) of a way that was chosen."""
    broken = np.empty(len(cutting), bool)
    for rows in chunks(len(broken)):
        travel = np.abs(np.diff(words[rows.start : rows.stop + 1], axis=0))
        broken[rows] = np.maximum(travel[:, 0], travel[:, 1]) > math.pi + SLACK
    swap = np.flatnonzero((branch[1:] != branch[:-1]) & ~crossing)
    broken[swap] |= np.abs(words[swap + 1] - words[swap]).sum(1) > SMALL_TURN
    return broken & cutting


def _is_limited(low: float, high: float) -> bool:
    """Return a word that is limited on one side only can always be brought inside by whole turns."""
    return math.isfinite(low) and math.isfinite(high)


def _least_word(angle: Floats, low: float) -> Floats:
    """Return the least winding of ``angle`` that is not below ``low``."""
    return np.asarray(angle - TURN * np.floor((angle - low + SLACK) * (1.0 / TURN)))


def _window(low: Floats, high: Floats, wraps: list[bool]) -> tuple[Floats, Floats]:
    """Limits that make no more than STATES states: of the words that need them, the turns around zero are
    kept."""
    low, high = low.copy(), high.copy()
    for axis in (axis for axis in range(2) if not wraps[axis]):
        other = 1 if wraps[1 - axis] else _windings(low[1 - axis], high[1 - axis])
        width = TURN * (max(2, STATES // 2 // other) - 1)
        if high[axis] - low[axis] > width:
            low[axis] = np.clip(-0.5 * width, low[axis], high[axis] - width)
            high[axis] = low[axis] + width
    return low, high


def _windings(low: float, high: float) -> int:
    return int((high - low + 2 * SLACK) // TURN) + 1 if _is_limited(low, high) else 1


def _fitting_turns(word: Floats, low: float, high: float) -> float:
    """Return the whole turns nearest to none that bring all of ``word`` (n,) within the limits; NaN where
    none do."""
    least = math.ceil((low - 2 * SLACK - float(word.min())) / TURN) if math.isfinite(low) else -math.inf
    most = math.floor((high + 2 * SLACK - float(word.max())) / TURN) if math.isfinite(high) else math.inf
    return min(max(0.0, least), most) if least <= most else math.nan


def _layers(angles: Floats, fits: Bools, low: Floats, high: Floats, wraps: list[bool]) -> Layers:
    if not fits.all():
        angles = np.nan_to_num(angles) if math.isnan(angles.min()) else angles
    if all(wraps):
        open_ = fits.any(1)
        word = angles.transpose(2, 0, 1)  # a view, unless a branch is left out
        return Layers(
            word if open_.all() else word[:, open_], fits[open_], np.flatnonzero(open_).astype(np.int8), wraps
        )
    count = [1 if wraps[axis] else _windings(low[axis], high[axis]) for axis in range(2)]
    branch, *winding = (part.ravel() for part in np.indices((2, count[0], count[1])))
    word, fits = np.empty((2, len(branch), angles.shape[1])), fits[branch]
    for axis in range(2):
        angle = angles[:, :, axis]
        if wraps[axis]:
            word[axis] = angle[branch]
        else:
            word[axis] = _least_word(angle, low[axis])[branch] + TURN * winding[axis][:, None]
            fits &= word[axis] <= high[axis] + SLACK
    used = np.flatnonzero(fits.any(1))
    return Layers(word[:, used], fits[used], branch[used].astype(np.int8), wraps)


def _solve(
    layers: Layers, cutting: Bools | Floats, crossing: Bools, progress: Progress
) -> tuple[Floats, Bytes]:
    """Return the best states' words (n, 2), unwound where they wrap, and branch (n,)."""
    entry = PREFER_ZERO * np.abs(layers.word[:, :, 0]).sum(0)
    entry[~layers.fits[:, 0]] = math.inf
    state = _by_branch_runs(layers, entry, cutting, crossing, progress) if all(layers.wraps) else None
    if state is None:

        def cost(start: int, end: int) -> Floats:
            return _step_cost(layers, cutting, crossing, slice(start, end), slice(start + 1, end + 1))

        state = least_path(entry, cost, len(cutting), progress)
    return _words_of(layers, state), layers.branch[state]


def _words_of(layers: Layers, state: Ints) -> Floats:
    words = np.empty((2, len(state))).T

    def fill(rows: slice) -> None:
        first, several = int(state[rows.start]), np.ptp(state[rows]) > 0
        at = (state[rows], np.arange(rows.start, rows.stop)) if several else (first, rows)
        for axis in range(2):
            words[rows, axis] = layers.word[axis][at]

    in_threads(fill, chunks(len(state)))
    in_threads(lambda axis: _unwind(words[:, axis]), [axis for axis in range(2) if layers.wraps[axis]])
    return words


def _unwind(word: Floats) -> None:
    """Give each value (n,) of an angle the winding that is nearest to the one before; in place."""
    jumps = [np.empty(0, np.int64)]
    for rows in chunks(len(word) - 1):
        jumps.append(rows.start + np.flatnonzero(np.abs(np.diff(word[rows.start : rows.stop + 1])) > math.pi))
    at = np.concatenate(jumps)
    if len(at):
        turns = np.cumsum(np.rint((word[at + 1] - word[at]) / TURN))
        word[at[0] + 1 :] -= TURN * np.repeat(turns, np.diff(at, append=len(word) - 1))


def _nearest(step: Floats) -> Floats:
    """Return the size of steps between angles on their nearest windings; changes ``step``."""
    step -= TURN * np.rint(step * (1.0 / TURN))
    return np.abs(step, out=step)


def _step_cost(
    layers: Layers, cutting: Bools | Floats, crossing: Bools, start: slice | Ints, end: slice | Ints
) -> Floats:
    """Cost (s, s, m) of the m steps from the rows ``start`` to the rows ``end`` after them, from state to
    state."""
    this_word, next_word, held = (
        layers.word[:, :, start],
        layers.word[:, :, end],
        np.asarray(BREAK * cutting[start]),
    )
    banned = np.where(crossing[start], 0.0, held)
    closed, count = np.where(layers.fits[:, end], 0.0, math.inf), len(layers.branch)
    cost = np.zeros((count, count, len(held)))
    for this, after in np.ndindex(count, count):
        total = cost[this, after]
        wide = np.zeros(len(held), bool)
        for axis in range(2):
            step = next_word[axis, after] - this_word[axis, this]
            if layers.wraps[axis]:
                total += _nearest(step)
            else:
                np.abs(step, out=step)
                wide |= step > math.pi + SLACK
                total += step
        if layers.branch[this] != layers.branch[after]:
            total += np.where(wide, held, banned * (total > SMALL_TURN))
        elif not all(layers.wraps):
            total += wide * held
        total += closed[after]
    return cost


def _by_branch_runs(
    layers: Layers, entry: Floats, cutting: Bools | Floats, crossing: Bools, progress: Progress
) -> Ints | None:
    """Return the best states (n,) where both words wrap; None where changing branch at gates only is not
    proven to be the best."""
    if len(layers.branch) == 1:
        return np.zeros(len(cutting) + 1, np.int64)
    if not len(cutting):
        return np.array([entry.argmin()])

    def cut(rows: slice) -> tuple[Ints, Floats, float]:
        return _branch_runs(layers, cutting, crossing, rows)

    parts = in_threads(cut, chunks(len(cutting)), lambda done: progress("joint path", done))
    starts, costs, bounds = zip(*parts, strict=True)
    cost, start, least = np.concatenate(costs, 2), np.concatenate([*starts, [len(cutting)]]), sum(bounds)
    state = least_path(entry, lambda first, last: cost[:, :, first:last], cost.shape[2])
    cheapest = BREAK * float(np.where(cutting > 0, cutting, 1.0).min())
    total = entry[state[0]] + cost[state[:-1], state[1:], np.arange(len(state) - 1)].sum()
    if (
        not total <= least + cheapest - TURN
    ):  # a step on the nearest windings is half a turn of each word at most
        return None
    return np.repeat(state, np.diff(start, append=len(cutting) + 1))


def _branch_runs(
    layers: Layers, cutting: Bools | Floats, crossing: Bools, rows: slice
) -> tuple[Ints, Floats, float]:
    """Return the steps ``rows`` cut into gates and branch runs of at most LONGEST steps: the first step of
    each, their costs (2, 2, m), and the sum of all steps' least costs. On a gate's step both branches may
    follow, on a branch run's only one."""
    ends, after = slice(rows.start, rows.stop + 1), slice(rows.start + 1, rows.stop + 1)
    first, second = layers.word[:, :, ends]
    stay = _nearest(np.diff(first)) + _nearest(np.diff(second))
    stay[~layers.fits[:, after]] = math.inf
    swap = _nearest(second[::-1, 1:] - second[:, :-1])
    small = np.minimum(swap[0], swap[1]) <= SMALL_TURN
    gate = np.flatnonzero((cutting[rows] == 0) | crossing[rows] | small)
    free = _step_cost(layers, cutting, crossing, rows.start + gate, rows.start + gate + 1)
    least = np.minimum(stay[0], stay[1])
    least[gate] = free.min((0, 1))
    begin = np.unique(np.concatenate([np.arange(0, stay.shape[1], LONGEST), gate, gate + 1]))
    begin = begin[begin < stay.shape[1]]
    cost = np.full((2, 2, len(begin)), math.inf)
    cost[0, 0], cost[1, 1] = np.add.reduceat(stay, begin, axis=1)
    cost[:, :, np.searchsorted(begin, gate)] = free
    return rows.start + begin, cost, float(least.sum())


def least_path(entry: Floats, cost: StepCost, steps: int, progress: Progress = silent) -> Ints:
    """Return the states (steps + 1,) of the cheapest way through the layers.

    ``entry`` (s,) cost of starting in each state; ``cost(start, end)`` the (s, s, end - start) costs of those
    steps, inf where there is no way. At least one way must be finite.
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
    """Return steps as (position, s, s, block), the end filled with steps that stay where they are."""
    count, steps = len(cost), cost.shape[2]
    length = -(-steps // blocks)
    stay = np.where(np.eye(count, dtype=bool), 0.0, math.inf)
    filler = np.broadcast_to(stay[:, :, None], (count, count, length * blocks - steps))
    return np.ascontiguousarray(
        np.concatenate([cost, filler], 2).reshape(count, count, blocks, length).transpose(3, 0, 1, 2)
    )


def _advance(value: Floats, cost: Floats) -> tuple[Floats, Bytes]:
    """Return the least values (s,) after the slab, and for each state where it came from, (position, s,
    block)."""
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
    """Return the states before every step of the slab, in the order of the steps, from the state after the
    last one."""
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
