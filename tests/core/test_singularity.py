# SPDX-License-Identifier: LGPL-2.1-or-later
"""Singular blocks: the paper's example, hand-made blocks, and dense sampling."""

from __future__ import annotations

import math

import numpy as np
import pytest
from bare_machines import BARE

from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, inverse_axis, words_to_q
from freecad_fiveaxis.core.motion.singularity import LEAST_TRAVEL, find_singular, in_cone

CONE = math.radians(5.0)
TABLE_2 = [[-90.9595, 7.3103, 227.6341, 148.9685, 1.0664], [-82.0656, -34.8175, 228.3975, 121.5477, 1.1793]]


def kinematics_of(name):
    return chain(load_machine(name), Setup())


def block(start, end, name="trunnion_ac", cone=CONE):
    """The block from one pair of rotary words to another, degrees."""
    words = np.array([[0.0, 0.0, 0.0, *start], [1.0, 0.0, 0.0, *end]])
    found = find_singular(kinematics_of(name), words, cone)
    return found.least_sine[1], found.rotary_travel[1], found.axis_travel[1], bool(found.singular[1])


def test_table_2_of_so_et_al_is_singular():
    found = find_singular(kinematics_of("mikron_ucp710"), np.array(TABLE_2), CONE)
    assert found.singular.tolist() == [False, True]
    assert found.least_sine[1] == pytest.approx(math.sin(math.radians(1.0664)), abs=1e-12)
    assert found.rotary_travel[1] == pytest.approx(
        math.radians(148.9685 - 121.5477 + 1.1793 - 1.0664), abs=1e-12
    )
    axes = forward(kinematics_of("mikron_ucp710"), words_to_q(np.array(TABLE_2)))[1]
    assert found.axis_travel[1] == pytest.approx(math.acos(axes[0] @ axes[1]), abs=1e-9)


@pytest.mark.parametrize(
    ("start", "end", "singular"),
    [
        ((0.0, 0.0), (0.0, 0.0), False),  # three axes, at the pole itself
        ((0.0, 0.0), (30.0, 0.0), True),  # the first axis turns, the tool's direction stays
        ((0.0, -3.0), (0.0, 3.0), False),  # straight through the pole
        ((0.0, 40.0), (30.0, 42.0), False),  # far from it
        ((0.0, 4.9), (30.0, 4.9), True),
        ((0.0, 5.1), (30.0, 5.1), False),  # just outside the cone
        ((0.0, 5.1), (20.0, -5.1), False),  # through it, but the tool's axis turns as well
        ((0.0, 5.1), (178.0, -5.1), True),  # out where it came in
        ((0.0, 0.0), (0.5, 0.0), False),  # less than the least travel
        ((0.0, 178.0), (30.0, 178.0), True),  # the other pole
    ],
)
def test_blocks_built_by_hand(start, end, singular):
    assert block(start, end)[3] is singular


def test_the_least_travel_is_the_limit_between_noise_and_a_turn():
    degrees = math.degrees(LEAST_TRAVEL)
    assert block((0.0, 0.1), (1.01 * degrees, 0.1))[3]
    assert not block((0.0, 0.1), (0.99 * degrees, 0.1))[3]


@pytest.mark.parametrize("name", BARE)
def test_columns_agree_with_sampling_and_forward_kinematics(name):
    kinematics = kinematics_of(name)
    rng = np.random.default_rng(8)
    words = rng.uniform(-1.0, 1.0, (150, 5)) * [50.0, 50.0, 50.0, 400.0, 250.0]
    found = find_singular(kinematics, words, CONE)
    q = words_to_q(words)
    axes = forward(kinematics, q)[1]
    angle = np.arctan2(np.linalg.norm(np.cross(axes[:-1], axes[1:]), axis=1), (axes[:-1] * axes[1:]).sum(1))
    np.testing.assert_allclose(found.axis_travel[1:], angle, atol=1e-7)
    u = np.linspace(0.0, 1.0, 2001)[:, None, None]
    along = (q[:-1] + u * np.diff(q, axis=0)).reshape(-1, 5)
    sampled = inverse_axis(kinematics, forward(kinematics, along)[1])[1].reshape(2001, -1).min(0)
    assert (found.least_sine[1:] <= sampled + 1e-7).all()
    np.testing.assert_allclose(found.least_sine[1:], sampled, atol=np.abs(np.diff(q[:, 4])).max() / 4000)
    assert (
        found.least_sine[0] == found.rotary_travel[0] == found.axis_travel[0] == 0.0 and not found.singular[0]
    )


@pytest.mark.parametrize("name", BARE)
def test_the_cone_is_an_angle_to_the_pole_on_every_machine(name):
    """A turn of the first axis just inside the cone is singular, just outside it is not."""
    kinematics = kinematics_of(name)
    for degrees, singular in ((4.99, True), (5.01, False)):
        tilt = math.radians(degrees)
        second = math.degrees(
            inverse_axis(kinematics, np.array([[math.sin(tilt), 0.0, math.cos(tilt)]]))[0][0, 0, 1]
        )
        words = np.array([[0.0, 0.0, 0.0, 0.0, second], [0.0, 0.0, 0.0, 20.0, second]])
        assert bool(find_singular(kinematics, words, CONE).singular[1]) is singular


def test_no_blocks_and_one_position_are_fine():
    kinematics = kinematics_of("trunnion_ac")
    assert find_singular(kinematics, np.empty((0, 5)), CONE).singular.shape == (0,)
    assert find_singular(kinematics, np.zeros((1, 5)), CONE).singular.tolist() == [False]


def test_chunks_join_without_a_seam():
    kinematics = kinematics_of("nutating_table_b45")
    rng = np.random.default_rng(9)
    words = np.cumsum(rng.normal(0.0, 2.0, (40_000, 5)), 0)
    whole = find_singular(kinematics, words, CONE)
    at = np.array([1, 16383, 16384, 16385, 32768, 39_999])
    for i in at:
        pair = find_singular(kinematics, words[i - 1 : i + 1], CONE)
        assert (pair.least_sine[1], pair.axis_travel[1]) == pytest.approx(
            (whole.least_sine[i], whole.axis_travel[i]), abs=1e-12
        )


def test_blocks_that_pass_the_cone_are_found_whether_they_turn_far_or_not():
    kinematics = kinematics_of("mikron_ucp710")
    words = np.zeros((5, 5))
    words[:, 4] = [20.0, 4.0, 10.0, -10.0, -20.0]  # in, out, through the pole, away
    words[1:, 3] = 0.5
    assert in_cone(kinematics, words, CONE).tolist() == [False, True, True, True, False]
    assert not find_singular(kinematics, words, CONE).singular.any()  # without turning far
    assert in_cone(kinematics, words[:1], CONE).tolist() == [False]
