# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sphere of tool axes as two rotary axes divide it: against forward kinematics and dense sampling, on
every kind of machine."""

from itertools import pairwise

import numpy as np
import pytest
from dome_passes import MACHINES, kinematics_of, meridian_angles
from five_kinds import KINDS
from five_kinds import kinematics_of as links_of_kind

from freecad_fiveaxis.core.base.ranges import OFF_POLE
from freecad_fiveaxis.core.machine.kinematics import forward, inverse_axis
from freecad_fiveaxis.core.orientation.past_pole.meridian import Globe, angle_between

CHAINS = [*((name, kinematics_of) for name in MACHINES), *((name, links_of_kind) for name in KINDS)]


@pytest.fixture(params=CHAINS, ids=[name for name, _ in CHAINS])
def kinematics(request):
    name, make = request.param
    return make(name)


def poses(kinematics, count=300, seed=3):
    """Rotary words (n, 2) rad, a third of them near the pole, and their axes (n, 3)."""
    rng = np.random.default_rng(seed)
    pole = inverse_axis(
        kinematics, np.array([kinematics.direction[3] * np.sign(kinematics.direction[3][2])])
    )[0][0, 0, 1]
    angles = rng.uniform(-1, 1, (count, 2)) * (np.pi, 1.2)
    angles[:, 1] = pole + angles[:, 1] * np.where(np.arange(count) % 3 == 0, 0.02, 1.0)
    return angles, forward(kinematics, np.column_stack([np.zeros((count, 3)), angles]))[1]


def test_a_meridian_is_where_the_second_word_takes_the_tool(kinematics):
    globe, (angles, axis) = Globe.of(kinematics), poses(kinematics)
    np.testing.assert_allclose((axis * globe.centre(angles[:, 0])).sum(1), np.cos(globe.circle), atol=1e-12)


def test_the_side_is_the_angle_to_the_second_axis_and_the_other_branch_negates_it(kinematics):
    globe, (angles, axis) = Globe.of(kinematics), poses(kinematics)
    side = globe.side(axis, angles[:, 0])
    centre = globe.centre(angles[:, 0])
    formula = axis @ globe.pole * np.cos(globe.lean) + np.linalg.norm(globe.across(axis), axis=1) * np.sin(
        globe.lean
    ) * np.cos(side)
    np.testing.assert_allclose((axis * centre).sum(1), formula, atol=1e-12)
    other = angles[:, 0] - 2 * side
    np.testing.assert_allclose((axis * globe.centre(other)).sum(1), np.cos(globe.circle), atol=1e-12)
    np.testing.assert_allclose(np.cos(globe.side(axis, other)), np.cos(side), atol=1e-9)


@pytest.mark.thorough
@pytest.mark.parametrize("change", [0.01, 0.035, 0.2])
def test_the_room_is_all_words_whose_meridian_is_within_the_change(kinematics, change):
    globe, (angles, axis) = Globe.of(kinematics), poses(kinematics)
    word = angles[:, 0]
    below, above = globe.room(axis, globe.side(axis, word), change)
    free = np.isinf(below)
    assert (free == np.isinf(above)).all()
    turn = np.linspace(-np.pi, np.pi, 721)
    far = np.array(
        [meridian_angles(kinematics, one + turn, k[None])[0] for one, k in zip(word, axis, strict=True)]
    )
    assert (far[free] <= change + 1e-9).all() and (far[~free].max(1) > change - 1e-9).all()
    inside = (turn >= -below[:, None]) & (turn <= above[:, None])
    assert (far[inside] <= change + 1e-9).all()
    for edge in (word - below, word + above):
        rows = np.flatnonzero(~free & (np.abs(edge - word) > 1e-6))
        at = np.array([meridian_angles(kinematics, edge[[row]], axis[[row]])[0, 0] for row in rows])
        met = (
            np.abs(np.sin(globe.side(axis[rows], edge[rows]))) < 1e-6
        )  # there the other branch's room begins
        np.testing.assert_allclose(at[~met], change, atol=1e-6)


@pytest.mark.thorough
def test_the_nearest_axis_on_a_meridian_is_that_of_a_dense_walk_along_it(kinematics):
    globe, (angles, axis) = Globe.of(kinematics), poses(kinematics, 60)
    word = angles[:, 0] + 0.03
    result = globe.nearest(axis, word)
    np.testing.assert_allclose(np.linalg.norm(result, axis=1), 1, atol=1e-12)
    second = np.linspace(-np.pi, np.pi, 20001)
    for one, k, got in zip(word, axis, result, strict=True):
        q = np.column_stack([np.zeros((len(second), 3)), np.full(len(second), one), second])
        least = angle_between(forward(kinematics, q)[1], np.broadcast_to(k, (len(second), 3))).min()
        assert angle_between(got[None], k[None])[0] == pytest.approx(least, abs=OFF_POLE + np.pi / 20000)
    assert (np.linalg.norm(globe.across(result), axis=1) >= OFF_POLE * (1 - 1e-6)).all()


def test_the_nearest_axis_to_the_pole_itself_still_says_its_word(kinematics):
    globe = Globe.of(kinematics)
    pole = globe.pole * np.sign(globe.pole[2])
    if abs(abs(globe.pole @ [0, 0, 1]) - 1) > 1e-9:
        pytest.skip("the machine's pole is not upright")
    word = np.linspace(-3, 3, 50)
    result = globe.nearest(np.repeat(pole[None], 50, axis=0), word)
    found = inverse_axis(kinematics, result)[0][:, :, 0]
    assert (np.abs(np.sin(0.5 * (found - word))).min(0) < 0.02).all()


def test_the_approach_is_the_nearest_point_of_a_dense_way(kinematics):
    globe, (_, axis) = Globe.of(kinematics), poses(kinematics, 80)
    u = np.linspace(0, 1, 2001)[:, None]
    place = globe.across(axis)
    for one, (a, b) in zip(globe.approach(axis), pairwise(place), strict=True):
        if np.isfinite(one):
            assert one == pytest.approx(np.linalg.norm(a + u * (b - a), axis=1).min(), abs=2e-3)


def test_a_wrong_branch_angle_would_be_noticed():
    globe, (angles, axis) = Globe.of(kinematics_of("trunnion_ac")), poses(kinematics_of("trunnion_ac"))
    assert np.abs((axis * globe.centre(angles[:, 0] + 0.1)).sum(1) - np.cos(globe.circle)).max() > 0.05
