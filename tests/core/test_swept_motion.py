# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much motions bend, by second differences of dense poses; and blocks that are buried in the part."""

import numpy as np
import pytest
from gouge_examples import prism

from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge import real_motion, straight_motion
from freecad_fiveaxis.core.gouge.inside import find_buried_blocks
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, linear_words
from freecad_fiveaxis.core.tool.body import Body, round_piece

SAMPLES = 201


def second_derivatives(swept, block):
    """The largest of tip (mm) and axis by u in a block, by second differences: means of the derivative, so
    never above it."""
    pose = swept.pose(np.full(SAMPLES, block), np.linspace(0.0, 1.0, SAMPLES))
    return [np.linalg.norm(np.diff(column, 2, axis=1), axis=0).max() * (SAMPLES - 1) ** 2 for column in pose]


@pytest.mark.parametrize("degrees", [0.5, 20.0, 120.0])
def test_an_axis_on_a_great_arc_bends_by_the_square_of_its_angle(degrees):
    angle = np.radians(degrees)
    axes = np.array([[0.0, 0.0, 1.0], [np.sin(angle), 0.0, np.cos(angle)]])
    swept = straight_motion(np.array([[0.0, 0.0, 0.0], [5.0, 1.0, 2.0]]), axes)
    tip, axis = second_derivatives(swept, 0)
    assert axis == pytest.approx(angle**2, rel=1e-3) and axis * (1 - 1e-6) <= swept.bend_axis[
        0
    ] <= angle**2 * (1 + 1e-9)
    assert tip < 1e-8 and swept.bend_tip[0] == 0.0


@pytest.mark.parametrize("back", [0.0, 5.0, 60.0])
def test_a_tip_that_swings_about_the_driven_point_bends_with_it(back):
    """The driven point stands on both rotary lines, so that its own path does not bend: the tip circles about
    it."""
    machine = load_machine("trunnion_ac")
    kinematics = chain(machine, Setup(machine.origin))
    angles = np.radians([[0.0, 20.0], [0.0, 50.0]])
    still = np.tile(kinematics.point2, (2, 1))
    words = np.column_stack([linear_words(kinematics, still, angles), np.degrees(angles)])
    swept = real_motion(kinematics, words, back)
    tip, axis = second_derivatives(swept, 0)
    turn = np.radians(30.0)
    assert tip == pytest.approx(back * turn**2, rel=1e-3, abs=1e-7) and axis == pytest.approx(
        turn**2, rel=1e-3
    )
    assert tip <= swept.bend_tip[0] + 1e-7 and axis * (1 - 1e-9) <= swept.bend_axis[0]


@pytest.mark.parametrize("above", [0.0, 3.0])
def test_some_blocks_alone_move_as_among_all(above):
    rng, blocks = np.random.default_rng(3), np.array([1, 4, 5, 9])
    tips, axes = rng.normal(size=(12, 3)), rng.normal(size=(12, 3))
    axes /= np.linalg.norm(axes, axis=1)[:, None]
    whole, some = straight_motion(tips, axes, above), straight_motion(tips, axes, above, blocks)
    u = rng.random(len(blocks))
    for one, other in zip(some.pose(np.arange(len(blocks)), u), whole.pose(blocks, u), strict=True):
        np.testing.assert_array_equal(one, other)
    np.testing.assert_array_equal(some.bend_tip, whole.bend_tip[blocks])
    np.testing.assert_array_equal(some.bend_axis, whole.bend_axis[blocks])


def test_random_blocks_bend_no_more_than_is_stated():
    rng, kinematics = np.random.default_rng(2), chain(load_machine("trunnion_ac"), Setup())
    words = np.cumsum(rng.normal(size=(31, 5)) * (8, 8, 8, 25, 12), axis=0)
    swept = real_motion(kinematics, words, 30.0)
    for block in range(30):
        tip, axis = second_derivatives(swept, block)
        assert tip <= swept.bend_tip[block] * (1 + 1e-9) and axis <= swept.bend_axis[block] * (1 + 1e-9)


# ------------------------------------------------------------------------------------------------ buried


@pytest.mark.parametrize(
    ("centre", "buried"), [(-8.0, True), (-4.9, True), (-2.9, True), (0.1, False), (2.9, False)]
)
def test_a_block_is_buried_where_the_middle_of_its_ball_is_in_the_part(centre, buried):
    """Material from z = -11 to 0: the ball's middle, not its tip, decides, for a tip that sticks out below
    it, too."""
    tree = facet_tree(prism([(-30, -11), (30, -11), (30, 0), (-30, 0)]))
    ball = Body((round_piece(0.0, 3.0, 3.0),))
    tips = np.array([[-2.0, 0.3, centre - 3.0], [2.0, 0.3, centre - 3.0]])
    swept = straight_motion(tips, np.tile([0.0, 0.0, 1.0], (2, 1)))
    entry = np.array([max(3.0 - min(abs(centre), abs(centre + 11.0)), 0.0)])
    assert find_buried_blocks(tree, ball, swept, np.where(entry < 2.7, entry, 0.0)).tolist() == [buried]
