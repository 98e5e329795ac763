# SPDX-License-Identifier: LGPL-2.1-or-later
"""The real path of tip and tool axis against the kinematics, and its derivatives against differences."""

from __future__ import annotations

import numpy as np
import pytest
from five_kinds import KINDS, NUTATIONS, kinematics_of, nutating, random_blocks

from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.motion.trajectory import axis_at, frames, tip_at, tip_derivatives_at

ROUNDING = 5e-12  # mm: coordinates of some 500 mm, a few dozen roundings


LEANING = [(degrees, side) for degrees in NUTATIONS for side in ("table", "head")]


@pytest.fixture(params=[*KINDS, *LEANING], ids=str)
def kinematics(request):
    return kinematics_of(request.param) if isinstance(request.param, str) else nutating(*request.param)


def blocks(kinematics, count=400, seed=2):
    return random_blocks(kinematics, count, seed)


def test_tip_and_axis_are_those_of_the_words_in_between(kinematics):
    start, end = blocks(kinematics)
    u = np.random.default_rng(3).uniform(0, 1, len(start))
    tip, axis = forward(kinematics, words_to_q(start + u[:, None] * (end - start)))
    assert np.abs(tip_at(kinematics, start, end, u) - tip).max() < ROUNDING
    assert np.abs(axis_at(kinematics, start, end, u) - axis).max() < 1e-14


def test_path_begins_and_ends_at_the_commanded_tips(kinematics):
    start, end = blocks(kinematics)
    for u, words in ((0.0, start), (1.0, end)):
        assert (
            np.abs(tip_at(kinematics, start, end, u) - forward(kinematics, words_to_q(words))[0]).max()
            < ROUNDING
        )


def test_derivatives_are_limits_of_differences(kinematics):
    start, end = blocks(kinematics)
    u, h = np.full(len(start), 0.3), 1e-5
    before, now, after = (tip_derivatives_at(kinematics, start, end, u + d) for d in (-h, 0.0, h))
    scale = 1.0 + np.abs(now[2]).max()
    assert np.abs((after[0] - before[0]) / (2 * h) - now[1]).max() < 1e-6 * scale
    assert np.abs((after[1] - before[1]) / (2 * h) - now[2]).max() < 1e-6 * scale
    assert (
        np.abs((after[0] - before[0]) / (2 * h) - 1.001 * now[1]).max() > 1e-6 * scale
    )  # the comparison can fail


def test_many_u_for_each_block_come_as_a_third_dimension(kinematics):
    start, end = blocks(kinematics, 6)
    u = np.linspace(0, 1, 5)
    many = tip_at(kinematics, start, end, u[None])
    assert many.shape == (6, 5, 3)
    for j, value in enumerate(u):
        assert np.array_equal(many[:, j], tip_at(kinematics, start, end, value))


def test_no_blocks_give_no_points(kinematics):
    none = np.empty((0, 5))
    assert tip_at(kinematics, none, none, 0.5).shape == (0, 3)


def test_rotary_frames_are_right_handed_and_carry_the_axes(kinematics):
    frame = frames(kinematics)
    assert np.allclose(frame.first @ frame.first.T, np.eye(3), atol=1e-15)
    assert np.linalg.det(frame.first) == pytest.approx(1.0)
    assert np.linalg.det(frame.mix) == pytest.approx(1.0)
    assert np.allclose(frame.first[2], kinematics.direction[3], atol=1e-15)
    assert np.allclose(frame.first.T @ frame.mix[:, 2], kinematics.direction[4], atol=1e-15)
    assert abs(frame.tool[1]) < 1e-15
