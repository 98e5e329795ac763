# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words between bounds: against brute force, a linear program and dynamic programming."""

import numpy as np
import pytest
from scipy.optimize import linprog

from freecad_fiveaxis.core.orientation.past_pole import even_word as even


def bounds(seed, count=60):
    """Random places, a word and room around it that is wide in the middle."""
    rng = np.random.default_rng(seed)
    along = np.cumsum(rng.uniform(0, 1, count) * (rng.random(count) > 0.2))
    word = np.cumsum(rng.normal(size=count)) * 0.3
    room = 2.0 * np.exp(-(((np.arange(count) - 0.5 * count) / 12) ** 2))
    low, high = word - room * rng.random(count), word + room * rng.random(count)
    for row in np.flatnonzero(np.diff(along) == 0):  # rows of one place have one word
        low[row + 1], high[row + 1], word[row + 1] = low[row], high[row], word[row]
    return along, word, low, high


def least_peak(along, low, high):
    """The least rate at which a word between the bounds exists: a linear program over the word and the
    rate."""
    n, step = len(along), np.diff(along)
    move = np.eye(n, n + 1, 1)[:-1] - np.eye(n, n + 1)[:-1]
    up, down = move.copy(), -move
    up[:, n] = down[:, n] = -step
    found = linprog(
        np.eye(1, n + 1, n)[0],
        np.vstack([up, down]),
        np.zeros(2 * n - 2),
        bounds=[*zip(low, high, strict=True), (0, None)],
    )
    return found.x[n] if found.status == 0 else np.inf


@pytest.mark.parametrize("seed", range(8))
def test_a_reach_is_the_most_over_all_bounds(seed):
    along, _, low, high = bounds(seed)
    leash = even.leash_of(along, np.random.default_rng(seed).uniform(0, 3, len(along) - 1))
    distance = np.abs(leash[:, None] - leash)
    np.testing.assert_allclose(even.upper_reach(leash, high), (high + distance).min(1), atol=1e-12)
    np.testing.assert_allclose(even.lower_reach(leash, low), (low - distance).max(1), atol=1e-12)


@pytest.mark.parametrize("seed", range(8))
def test_the_rates_are_the_least_possible_but_for_their_steps_and_the_word_keeps_them(seed):
    along, word, low, high = bounds(seed)
    rates = even.least_rates(along, low, high, 1e-3)
    best = least_peak(along, low, high)
    assert best - 1e-9 <= rates.max() <= best * even.RAISE * even.SPARE * 1.01
    leash = even.leash_of(along, rates)
    result = even.even_out_word(leash, word, low, high)
    assert (result >= low - 1e-8).all() and (result <= high + 1e-8).all()
    assert (np.abs(np.diff(result)) <= np.diff(leash) + 1e-8).all()


def test_a_rate_that_is_too_low_would_be_noticed():
    along, _, low, high = bounds(1)
    rates = 0.5 * even.least_rates(along, low, high, 1e-3)
    leash = even.leash_of(along, rates)
    assert (even.lower_reach(leash, low) > even.upper_reach(leash, high) + 1e-6).any()


def test_where_one_place_needs_two_words_there_are_no_rates():
    assert (
        even.least_rates(
            np.array([0.0, 1.0, 1.0, 2.0]), np.array([0.0, 0, 5, 5]), np.array([1.0, 1, 6, 6]), 1e-3
        )
        is None
    )


def test_a_word_that_turns_no_faster_is_left_alone():
    along, word, _, _ = bounds(3)
    leash = even.leash_of(along, np.full(len(along) - 1, 1e7))
    np.testing.assert_allclose(even.even_out_word(leash, word, word - 1, word + 1), word, atol=1e-9)


@pytest.mark.parametrize("seed", range(8))
def test_the_laziest_word_travels_least(seed):
    """Dynamic programming from the same start over all bounds, between which a word of least travel turns."""
    _, word, low, high = bounds(seed)
    result = even.laziest(low, high, float(word[0]))
    assert (result >= low).all() and (result <= high).all()
    grid = np.unique(np.concatenate([low, high, word[:1]]))
    cost = np.where(grid == word[0], 0.0, np.inf)
    for least, most in zip(low[1:], high[1:], strict=True):
        cost = np.minimum(
            np.minimum.accumulate(cost - grid) + grid, np.minimum.accumulate((cost + grid)[::-1])[::-1] - grid
        )
        cost[(grid < least) | (grid > most)] = np.inf
    assert np.abs(np.diff(result)).sum() == pytest.approx(cost.min(), abs=1e-9)
    in_turn = [np.clip(word[0], low[0], high[0])]
    for least, most in zip(low[1:], high[1:], strict=True):
        in_turn.append(np.clip(in_turn[-1], least, most))
    np.testing.assert_array_equal(result, in_turn)


def test_the_course_counts_what_is_cut():
    centre = np.array([[0.0, 0, 0], [3, 4, 0], [3, 4, 1], [3, 4, 3]])
    np.testing.assert_allclose(even.cut_length(centre, np.array([False, False, True, False])), [0, 5, 5, 7])
