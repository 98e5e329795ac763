# SPDX-License-Identifier: LGPL-2.1-or-later
"""Beyond a limit another work zero helps only where the travel is long enough."""

import math
from dataclasses import replace

import numpy as np
import pytest
from test_joint_path import CLEARANCE, HIGH, LOW, dome_zigzag, kinematics_of

from freecad_fiveaxis.core.motion.joint_path import solve
from freecad_fiveaxis.core.motion.short_travel import find_aside, say_remedy_beyond_limit


@pytest.mark.parametrize(("low", "high"), [(-30.0, 75.0), (0.0, math.inf), (-20.0, 80.0)])
def test_where_the_travel_is_long_enough_the_work_zero_is_moved(low, high):
    reported = say_remedy_beyond_limit("X", np.array([-20.0, 80.0]), low, high)
    assert reported == "move the work zero (--origin) or take a larger machine."


def test_where_it_is_not_that_is_stated_and_by_how_much():
    reported = say_remedy_beyond_limit("X", np.array([769.995, -798.222]), -500.0, 500.0)
    assert "needs 1568.22 mm of X, whose travel is 1000 mm, 568.217 mm too short" in reported
    assert "work zero" not in reported


def test_a_part_far_beside_the_axes_of_the_table_says_by_how_much_the_work_zero_is_to_be_moved():
    """trunnion_ac: C through 0,0, A through Z -50; a part 1200 mm off in X, 800 in Y, 300 above."""
    kinematics, corners = kinematics_of("trunnion_ac"), np.array([(-15.0, -15.0, 0.0), (15.0, 15.0, 15.0)])
    tip = corners + (1200.0, -800.0, 300.0)
    aside = find_aside(kinematics, tip)
    assert aside is not None and aside.letter == "C"
    assert aside.distance == pytest.approx(math.hypot(1200.0, 800.0))
    moved = tip.mean(axis=0) + aside.move
    assert np.allclose(moved, (0.0, 0.0, -50.0))  # C's line is at once within A's reach
    text = say_remedy_beyond_limit("X", np.array([-1440.0, 1442.0]), -200.0, 200.0, aside)
    assert (
        "2882 mm of X" in text and "1442 mm from the axis of C" in text and "X -1200 Y 800 Z -357.5" in text
    )
    assert "(--origin)" in text and "larger machine" not in text
    assert find_aside(kinematics, corners - (0.0, 0.0, 20.0)) is None
    assert find_aside(kinematics_of("fork_head_bc"), tip) is None, "no axis carries the part"


def test_a_path_says_which_of_both_it_is():
    """Limits that are shifted want another zero, limits too near to each other a longer axis."""
    wide = kinematics_of("trunnion_ac")
    x = solve(dome_zigzag(), wide, LOW, HIGH, CLEARANCE).q[:, 0]
    for low, high, short in ((x.min() + 1.0, x.max() + 1.0, False), (x.min() + 1.0, x.max() - 1.0, True)):
        narrow = replace(wide, low=np.r_[low, wide.low[1:]], high=np.r_[high, wide.high[1:]])
        texts = [one.text for one in solve(dome_zigzag(), narrow, LOW, HIGH, CLEARANCE).findings
                 if one.code == "limit" and one.text.startswith("X")]  # fmt: skip
        assert texts and all(("2 mm too short" in text) == short for text in texts)
        assert all(("move the work zero" in text) != short for text in texts)
