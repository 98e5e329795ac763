# SPDX-License-Identifier: LGPL-2.1-or-later
"""Branch and winding: exact, against trying every way."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from freecad_fiveaxis.core.base import columns
from freecad_fiveaxis.core.base.progress import silent
from freecad_fiveaxis.core.motion.joint_path import branches
from freecad_fiveaxis.core.motion.joint_path.branches import (
    BETWEEN,
    BREAK,
    SMALL_TURN,
    TURN,
    choose,
    find_broken_steps,
    least_path,
    within_limits,
)

FREE = (-math.inf, math.inf)


def step_cost(before, after, cutting, crossing):
    """Cost of a step between two states (branch, q1, q2), written down as the module's head defines it.
    ``cutting``: True, False or the weight of a break."""
    turns = [abs(b - a) for a, b in zip(before[1:], after[1:], strict=True)]
    changes = before[0] != after[0] and not crossing and sum(turns) > SMALL_TURN
    return sum(turns) + BREAK * float(cutting) * (changes or max(turns) > math.pi + 1e-9)


def states_of(angles, limits):
    """Every state of one row, windings up to two turns where there is no limit."""
    found = []
    for branch in range(2):
        ranges = [[q + TURN * w for w in range(-2, 3)] for q in angles[branch]]
        inside = [
            [q for q in qs if low - 1e-9 <= q <= high + 1e-9]
            for qs, (low, high) in zip(ranges, limits, strict=True)
        ]
        found += [(branch, *q) for q in itertools.product(*inside)]
    return found


def least_cost(angles, limits, cutting, crossing):
    """The cost of the cheapest of all ways: one dimension of the table for each row, every combination added
    up."""
    layers = [states_of(angles[:, i], limits) for i in range(angles.shape[1])]
    total = np.zeros([1] * len(layers))
    for i in range(len(layers) - 1):
        table = np.array(
            [[step_cost(a, b, cutting[i], crossing[i]) for b in layers[i + 1]] for a in layers[i]]
        )
        shape = [1] * len(layers)
        shape[i : i + 2] = table.shape
        total = total + table.reshape(shape)
    return total.min()


def cost_of(words, branch, cutting, crossing):
    rows = [(b, *q) for b, q in zip(branch.tolist(), words.tolist(), strict=True)]
    return sum(step_cost(a, b, c, p) for a, b, c, p in zip(rows, rows[1:], cutting, crossing, strict=False))


def random_case(rng, rows):
    start = rng.uniform(-math.pi, math.pi, (2, 1, 2))
    angles = start + np.cumsum(rng.normal(0.0, 1.2, (2, rows, 2)), 1)
    angles = angles - TURN * np.ceil((angles - math.pi) / TURN)
    return angles, rng.random(rows - 1) < 0.7, rng.random(rows - 1) < 0.15


@pytest.mark.parametrize(
    ("limits", "rows"),
    [
        ((FREE, FREE), 3),
        (((-TURN, TURN), FREE), 3),
        (((-TURN, TURN), (-3.5, 3.5)), 6),
        (((-math.pi, math.pi), (-3.2, 3.2)), 7),
        (((-1.0, 5.6), (-3.3, 3.9)), 7),
        (((-9.0, 4.0), (-3.5, 6.0)), 5),
    ],
)
def test_the_way_found_costs_as_much_as_the_cheapest_of_all(limits, rows):
    rng = np.random.default_rng(5)
    low, high = np.array(limits).T
    for _ in range(12):
        angles, cutting, crossing = random_case(rng, rows)
        words, branch = choose(angles, within_limits(angles, low, high), low, high, cutting, crossing)
        assert cost_of(words, branch, cutting, crossing) == pytest.approx(
            least_cost(angles, limits, cutting, crossing), abs=1e-7
        )
        assert (words >= low).all() and (words <= high).all()
        own = angles[branch, np.arange(rows)]
        np.testing.assert_allclose(np.cos(words - own), 1.0, atol=1e-12)


@pytest.mark.parametrize("limits", [((-3.5, 3.5), FREE), ((-3.3, 3.3), (-3.3, 3.3))])
def test_with_breaks_of_different_weight_the_cheapest_way_is_found_too(limits):
    rng = np.random.default_rng(8)
    low, high = np.array(limits).T
    seldom, differ = 0, 0
    for _ in range(60 if limits[1] != FREE else 20):
        angles, cutting, crossing = random_case(rng, 5)
        weight = np.where(rng.random(4) < 0.5, BETWEEN, 1.0) * cutting
        fits = within_limits(angles, low, high)
        words, branch = choose(angles, fits, low, high, weight, crossing)
        least = least_cost(angles, limits, weight, crossing)
        assert cost_of(words, branch, weight, crossing) == pytest.approx(least, abs=1e-7)
        before, other = choose(angles, fits, low, high, cutting, crossing)
        differ += cost_of(before, other, weight, crossing) > least + 0.1 * BREAK
        seldom += find_broken_steps(words, branch, cutting, crossing).any()
    assert limits[1] == FREE or (seldom and differ)


def test_a_branch_that_the_limits_forbid_is_not_taken():
    rng = np.random.default_rng(6)
    limits = ((-4.0, 4.0), (-0.4, 2.5))
    low, high = np.array(limits).T
    checked = 0
    for _ in range(400):
        angles, cutting, crossing = random_case(rng, 5)
        fits = within_limits(angles, low, high)
        if fits.any(0).all() and not fits.all():
            checked += 1
            words, branch = choose(angles, fits, low, high, cutting, crossing)
            assert fits[branch, np.arange(5)].all()
            assert cost_of(words, branch, cutting, crossing) == pytest.approx(
                least_cost(angles, limits, cutting, crossing), abs=1e-7
            )
    assert checked > 20


def test_nearest_windings_alone_cost_more_under_limits():
    """The comparison above can fail: the step-by-step way breaks at the limit, the best way starts a turn
    lower."""
    q1 = np.linspace(0.0, 2.5 * math.pi, 11)
    angles = np.zeros((2, 11, 2))
    angles[0, :, 0] = q1 - TURN * np.ceil((q1 - math.pi) / TURN)
    angles[1] = np.nan
    low, high = np.array([-TURN, -1.0]), np.array([TURN, 1.0])
    cutting, crossing = np.ones(10, bool), np.zeros(10, bool)
    words, branch = choose(angles, within_limits(angles, low, high), low, high, cutting, crossing)
    assert not find_broken_steps(words, branch, cutting, crossing).any()
    assert words[0, 0] == pytest.approx(-TURN)
    greedy = np.where(q1 > TURN, q1 - TURN, q1)[:, None] * [1.0, 0.0]
    assert cost_of(greedy, branch, cutting, crossing) > BREAK


def test_many_turns_are_not_folded():
    q1 = np.linspace(0.0, 40.0 * math.pi, 1001)
    angles = np.zeros((2, 1001, 2))
    angles[:, :, 0] = q1 - TURN * np.ceil((q1 - math.pi) / TURN)
    low, high = np.array(FREE * 2).reshape(2, 2).T
    words, _ = choose(angles, np.ones((2, 1001), bool), low, high, np.ones(1000, bool), np.zeros(1000, bool))
    np.testing.assert_allclose(words[:, 0], q1, atol=1e-12)


def test_an_axis_of_very_many_turns_stays_within_its_limits_with_a_break_now_and_then():
    q1 = np.linspace(0.0, 100.0 * math.pi, 2001)
    angles = np.zeros((2, 2001, 2))
    angles[:, :, 0] = q1 - TURN * np.ceil((q1 - math.pi) / TURN)
    low, high = np.array([-40.0 * math.pi, -1.0]), np.array([40.0 * math.pi, 1.0])
    cutting, crossing = np.ones(2000, bool), np.zeros(2000, bool)
    words, branch = choose(angles, np.ones((2, 2001), bool), low, high, cutting, crossing)
    assert (words >= low).all() and (words <= high).all()
    assert 1 <= find_broken_steps(words, branch, cutting, crossing).sum() <= 4


def test_of_equal_ways_the_one_nearest_to_zero_is_taken():
    angles = np.array([[[3.0, 1.0]] * 4, [[-0.1, -1.0]] * 4])
    low, high = np.array([-10.0, -2.0]), np.array([10.0, 2.0])
    words, branch = choose(angles, np.ones((2, 4), bool), low, high, np.ones(3, bool), np.zeros(3, bool))
    assert (branch == 1).all()
    np.testing.assert_allclose(words, [[-0.1, -1.0]] * 4)


@pytest.mark.parametrize("steps", [0, 1, 2, 3, 16, 17, 99, 250])
@pytest.mark.parametrize("count", [1, 2, 5])
def test_the_scan_on_two_levels_agrees_with_one_row_after_the_other(steps, count, monkeypatch):
    monkeypatch.setattr(branches, "SLAB", 16 * count**2)
    rng = np.random.default_rng(steps + count)
    cost = rng.uniform(0.0, 1.0, (count, count, steps))
    cost[rng.random(cost.shape) < 0.3] = math.inf
    cost[0, 0, :] = 5.0
    entry = rng.uniform(0.0, 1.0, count)
    value = entry
    for i in range(steps):
        value = (value[:, None] + cost[:, :, i]).min(0)
    state = least_path(entry, lambda start, end: cost[:, :, start:end], steps)
    total = entry[state[0]] + cost[state[:-1], state[1:], np.arange(steps)].sum()
    assert len(state) == steps + 1
    assert total == pytest.approx(value.min(), abs=1e-9)


def long_case(rng, rows, jump):
    """Angles that go on evenly on both branches, like those of a machine of orthogonal axes, or less so the
    larger ``jump`` is."""
    steps = rng.normal(0.0, 0.3, (2, rows, 2))
    steps[1] = steps[0] * [1.0, -1.0] + rng.normal(0.0, jump, (rows, 2))
    angles = np.cumsum(steps, 1) + [[[0.3, 0.8]], [[0.3 + math.pi, -0.8]]]
    return angles - TURN * np.ceil((angles - math.pi) / TURN)


@pytest.mark.parametrize(
    ("jump", "gates", "lost", "shorter"),
    [(0.0, 0.1, 0.002, True), (0.3, 0.1, 0.002, True), (0.0, 0.01, 0.05, False)],
)
@pytest.mark.parametrize("chunk", [7, 64, 16384])
def test_the_shorter_graph_of_gates_and_branch_runs_has_the_best_way_or_none(
    jump, gates, lost, shorter, chunk, monkeypatch
):
    monkeypatch.setattr(columns, "CHUNK", chunk)
    rng, changes = np.random.default_rng(11), 0
    free = np.array([-math.inf] * 2), np.array([math.inf] * 2)
    for _ in range(5):
        angles = long_case(rng, 2000, jump)
        cutting, crossing, fits = rng.random(1999) > gates, rng.random(1999) < gates, np.ones((2, 2000), bool)
        out = np.flatnonzero(rng.random(2000) < lost)
        fits[rng.integers(0, 2, len(out)), out] = False
        layers = branches._layers(angles, fits, *free, [True, True])
        entry = np.where(fits[:, 0], 0.0, math.inf)
        cost = branches._step_cost(layers, cutting, crossing, slice(0, 1999), slice(1, 2000))
        best = least_path(entry, lambda first, last, cost=cost: cost[:, :, first:last], 1999)
        state = branches._by_branch_runs(layers, entry, cutting, crossing, silent)
        assert (state is not None) is shorter
        if state is not None:
            at, changes = np.arange(1999), changes + np.count_nonzero(np.diff(state))
            assert cost[state[:-1], state[1:], at].sum() == pytest.approx(
                cost[best[:-1], best[1:], at].sum(), abs=1e-8
            )
    assert changes > 3 or not shorter


def test_a_break_that_has_to_be_built_inside_a_branch_run_is_found():
    """Branch 0 ends and branch 1 begins within one cut: no gate helps, so the shorter graph must not
    answer."""
    angles = np.zeros((2, 60, 2))
    angles[0], angles[1] = [0.0, 1.0], [math.pi, -1.0]
    fits = np.ones((2, 60), bool)
    fits[0, 40:] = fits[1, :20] = False
    free = np.array([-math.inf] * 2), np.array([math.inf] * 2)
    cutting, crossing = np.ones(59, bool), np.zeros(59, bool)
    words, branch = choose(angles, fits, *free, cutting, crossing)
    assert fits[branch, np.arange(60)].all()
    assert find_broken_steps(words, branch, cutting, crossing).sum() == 1
