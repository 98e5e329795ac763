# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps between the states of minimax: what they deviate by, and which turns they may make."""

from dataclasses import replace

import numpy as np
import pytest
from five_kinds import TABLE_2, kinematics_of, mikron_links

from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.motion.trajectory import tip_at
from freecad_fiveaxis.core.orientation.minimax.blocks import QUARTERS, bow, states
from freecad_fiveaxis.core.orientation.minimax.rows import Rows
from freecad_fiveaxis.core.orientation.minimax.steps import Task, step_costs

RATE = 2.0  # rad/min of both rotary axes


def test_a_bow_that_overshoots_its_chord_counts_from_the_chord_s_end():
    """Table 2 of So et al.: the path runs beyond the chord's end, and is 0.94 mm from its line but 2.1 mm
    from the chord."""
    kinematics = mikron_links()
    tips = forward(kinematics, words_to_q(TABLE_2))[0]
    there = states(kinematics, np.radians(TABLE_2[:, None, 3:].T), tips, 0.0)
    found = bow(kinematics, there.ends.take(slice(0, 1)), there.ends.take(slice(1, 2)), QUARTERS)
    off = tip_at(kinematics, TABLE_2[:1], TABLE_2[1:], np.array([QUARTERS]))[0] - tips[0]
    chord = tips[1] - tips[0]
    foot = np.clip(off @ chord / (chord @ chord), 0.0, 1.0)
    assert found[0, 0, 0] == pytest.approx(
        np.linalg.norm(off - foot[:, None] * chord, axis=1).max(), abs=1e-9
    )
    assert found[0, 0, 0] > 2.0


def costs(turns, minutes=0.1, least=0.0, nearest=False):
    """Costs (k,) of steps whose first word goes from ``turns[0]`` to the others (rad), the second one
    standing still."""
    kinematics = replace(kinematics_of("table_table"), rate=np.array([1e4, 1e4, 1e4, RATE, RATE]))
    angles = np.stack([np.tile(np.array(turns)[:, None], (1, 2)), np.full((len(turns), 2), 0.5)])
    normal = np.tile([0.0, 0.0, 1.0], (2, 1))
    at = Rows(
        np.array([0]), np.array([2]), np.zeros(2, int), np.array([[0.0, 0, 0], [1.0, 0, 0]]), normal, normal
    )
    task = Task(kinematics, 0.0, 0.1, np.full(2, minutes), np.full((2, 2), least))
    return step_costs(task, at, states(kinematics, angles, at.centre, 0.0), np.array([1e6]), (0.5,), nearest)[
        0, 1:, 0
    ]


def test_a_step_turns_no_faster_than_the_rate_allows_in_its_time():
    turns = np.array([0.0, 0.19, 0.199, 0.201, 0.3, 1.0, -0.19, -0.21])
    assert np.isfinite(costs(turns)).tolist() == (np.abs(turns[1:]) <= RATE * 0.1).tolist()


def test_a_step_that_turned_faster_before_may_go_on_doing_so():
    assert np.isfinite(costs(np.array([0.0, 0.3, 0.45]), least=0.4)).tolist() == [True, False]


def test_the_first_word_goes_the_shorter_way_where_whole_turns_do_not_count():
    turns = np.array([3.1, -3.1, 3.1 - 4.0 * np.pi, 3.3, -2.5])
    across = np.abs(np.remainder(turns[1:] - 3.1 + np.pi, 2.0 * np.pi) - np.pi)
    assert (
        np.isfinite(costs(turns, nearest=True)).tolist()
        == (across <= RATE * 0.1).tolist()
        == [True, True, True, False]
    )
    assert np.isfinite(costs(turns)).tolist() == [False, False, True, False]
