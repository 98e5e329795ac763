# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviations against dense sampling, closed forms and the numbers of both papers."""

from __future__ import annotations

import numpy as np
import pytest
from five_kinds import (
    KINDS,
    TABLE_2,
    interleaved,
    kinematics_of,
    mikron_links,
    random_blocks,
    sampled_deviation,
)

from freecad_fiveaxis.core.base.errors import Cancelled, ProgramError, SettingsError
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, linear_words, words_to_q
from freecad_fiveaxis.core.motion.deviation import lin_ye_deviation, measure, same_u_deviation
from freecad_fiveaxis.core.motion.deviation import measurement as module
from freecad_fiveaxis.core.motion.trajectory import axis_at, tip_at

RELATIVE, ABSOLUTE = 1e-5, 1e-6  # what is promised: share of the deviation, or mm


@pytest.fixture(params=KINDS)
def kinematics(request):
    return kinematics_of(request.param)


@pytest.fixture(scope="module")
def mikron():
    return mikron_links()


def ordinary_program(kinematics, count=1500, seed=4):
    """A smooth path: chords of about 1 mm, turns of 0.1 to 2 deg a block about axes well off the pole."""
    rng = np.random.default_rng(seed)
    sign = np.where(np.arange(count) // 60 % 2, 1, -1)[:, None]
    angles = np.radians((20, 35)) + np.cumsum(
        np.radians(rng.uniform(0.1, 2.0, (count, 2))) * sign * (1, 0.5), axis=0
    )
    way = 0.05 * np.arange(count)
    heading = np.stack([np.cos(way), np.sin(way), 0.3 * np.sin(3 * way)], axis=1)
    tips = np.cumsum(rng.uniform(0.8, 1.5, (count, 1)) * heading, axis=0)
    return np.concatenate([linear_words(kinematics, tips, angles), np.degrees(angles)], axis=1)


def errors(found, expected):
    """Largest difference in units of what is promised."""
    return (np.abs(found - expected) / np.maximum(RELATIVE * expected, ABSOLUTE)).max()


# ------------------------------------------------------------------------------------------- against sampling


def compare_with_sampling(kinematics, count, seed):
    start, end = random_blocks(kinematics, count, seed)
    found = measure(kinematics, interleaved(start, end))
    segment, line = sampled_deviation(kinematics, start, end)
    assert errors(found.segment[1::2], segment) <= 1.0
    assert errors(found.line[1::2], line) <= 1.0
    assert (found.bound[1::2] >= segment).all()
    assert (found.bound - found.segment <= np.maximum(ABSOLUTE, RELATIVE * found.segment)).all()


def test_random_blocks_agree_with_dense_sampling(kinematics):
    compare_with_sampling(kinematics, 2000, 11)


@pytest.mark.slow
@pytest.mark.large
def test_twenty_thousand_random_blocks_agree_with_dense_sampling(kinematics):
    compare_with_sampling(kinematics, 20_000, 12)


def test_ordinary_blocks_agree_with_dense_sampling_and_hardly_need_a_search(kinematics, monkeypatch):
    words, searched, search = ordinary_program(kinematics), [], module._search

    def counted(frame, words, rows, table):
        searched.extend(rows)
        search(frame, words, rows, table)

    monkeypatch.setattr(module, "_search", counted)
    found = measure(kinematics, words)
    assert len(searched) <= 0.002 * len(words)
    segment, line = sampled_deviation(kinematics, words[:-1], words[1:], 401)
    assert errors(found.segment[1:], segment) <= 1.0
    assert errors(found.line[1:], line) <= 1.0
    assert (found.bound[1:] >= segment).all()


def test_a_coarse_sampling_would_be_found_out():
    kinematics = kinematics_of("table_table")
    start, end = random_blocks(kinematics, 300, 11)
    found = measure(kinematics, interleaved(start, end)).segment[1::2]
    assert errors(sampled_deviation(kinematics, start, end, 21)[0], found) > 2.0


def test_the_highest_of_several_maxima_is_found(kinematics):
    rng = np.random.default_rng(5)
    start = rng.uniform(-1, 1, (60, 5)) * (100, 100, 100, 180, 60)
    end = (
        start
        + rng.uniform(-1, 1, (60, 5)) * (40, 40, 40, 0, 0)
        + [0, 0, 0, 2000, 0]
        + rng.uniform(-1, 1, (60, 1)) * [0, 0, 0, 0, 400]
    )
    path = tip_at(kinematics, start, end, np.linspace(0, 1, 4001)[None])
    off = np.linalg.norm(path - path[:, :1], axis=2)
    maxima = ((off[:, 1:-1] > off[:, :-2]) & (off[:, 1:-1] > off[:, 2:])).sum(axis=1)
    assert np.median(maxima) >= 4
    assert (
        errors(
            measure(kinematics, interleaved(start, end)).segment[1::2],
            sampled_deviation(kinematics, start, end, 8001)[0],
        )
        <= 1.0
    )


def test_place_is_the_real_tip_where_the_deviation_is_largest(kinematics):
    start, end = random_blocks(kinematics, 300, 6)
    words = interleaved(start, end)
    found = measure(kinematics, words)
    tips = tip_at(kinematics, words[:-1], words[1:], found.u_segment[1:])
    assert np.abs(tips - found.place[1:]).max() <= ABSOLUTE
    ends = forward(kinematics, words_to_q(words))[0]
    chord = np.diff(ends, axis=0)
    share = ((tips - ends[:-1]) * chord).sum(1) / np.maximum((chord**2).sum(1), 1e-18)
    off = np.linalg.norm(tips - ends[:-1] - np.clip(share, 0, 1)[:, None] * chord, axis=1)
    assert errors(off, found.segment[1:]) <= 1.0


def test_each_block_is_measured_by_itself(kinematics, monkeypatch):
    words = interleaved(*random_blocks(kinematics, 40, 7))
    whole = measure(kinematics, words)
    monkeypatch.setattr(module, "CHUNK", 7)
    monkeypatch.setattr(module, "SEARCHED", 3)
    parts = measure(kinematics, words)
    for name in ("line", "segment", "bound", "axis"):
        assert getattr(parts, name) == pytest.approx(getattr(whole, name), rel=1e-9, abs=1e-10), name


# ----------------------------------------------------------------------------------------- So et al., Table 2


def test_table_2_line_deviation(mikron):
    found = measure(mikron, TABLE_2)
    assert found.line[1] == pytest.approx(0.93845, abs=3e-4)
    assert found.u_line[1] == pytest.approx(0.40415, abs=1e-3)


def test_table_2_line_distance_at_the_printed_u(mikron):
    path = tip_at(mikron, TABLE_2[:1], TABLE_2[1:], np.array([[0.0, 0.4101, 1.0]]))[0]
    chord, off = path[2] - path[0], path[1] - path[0]
    assert np.linalg.norm(off - off @ chord / (chord @ chord) * chord) == pytest.approx(0.9383, abs=5e-5)


def test_table_2_segment_deviation(mikron):
    found = measure(mikron, TABLE_2)
    assert found.segment[1] == pytest.approx(2.12642, abs=5e-4)
    assert found.u_segment[1] == pytest.approx(0.54543, abs=5e-4)
    assert found.segment[1] <= found.bound[1] <= found.segment[1] + 3e-5


def test_table_2_same_u_deviation(mikron):
    distance, u = same_u_deviation(mikron, TABLE_2)
    assert distance[1] == pytest.approx(2.62355, abs=5e-4)
    assert u[1] == pytest.approx(0.4995, abs=5e-4)


def test_same_u_deviation_agrees_with_sampling(kinematics):
    start, end = random_blocks(kinematics, 200, 8)
    u = np.linspace(0, 1, 2001)
    path = tip_at(kinematics, start, end, u[None])
    even = path[:, :1] + u[:, None] * (path[:, -1:] - path[:, :1])
    sampled = np.linalg.norm(path - even, axis=2).max(axis=1)
    words = interleaved(start, end)
    distance, _ = same_u_deviation(kinematics, words)
    assert errors(distance[1::2], sampled) <= 1.0
    assert (distance >= measure(kinematics, words).segment * (1 - RELATIVE) - ABSOLUTE).all()


# ----------------------------------------------------------------------------------------------- closed forms


def test_a_turning_table_draws_a_circular_arc():
    """C turns under a tool that stands still: the part sees an arc of known sagitta."""
    kinematics, radius, turn = kinematics_of("table_table"), 80.0, np.radians([0.5, 5.0, 60.0, 180.0])
    words = np.zeros((8, 5))
    words[:, 0] = radius - 5.0  # C's line stands at (-5, -14) of the work zero
    words[:, 1] = -14.0
    words[1::2, 3] = np.degrees(turn)
    found = measure(kinematics, words)
    assert found.line[1::2] == pytest.approx(radius * (1 - np.cos(turn / 2)), rel=1e-6)
    assert found.segment[1::2] == pytest.approx(found.line[1::2], rel=1e-6)
    assert found.u_segment[1::2] == pytest.approx(0.5, abs=1e-6)


def test_a_full_turn_measures_from_the_point_of_start():
    kinematics = kinematics_of("table_table")
    found = measure(kinematics, [[75, -14, 0, 0, 0], [75, -14, 0, 360, 0]])
    assert found.segment[1] == pytest.approx(160.0, rel=1e-6)
    assert found.line[1] == pytest.approx(160.0, rel=1e-6)


def test_straight_moves_do_not_deviate(kinematics):
    words = np.random.default_rng(1).uniform(-200, 200, (50, 5))
    words[:, 3:] = 25.0, 40.0
    found = measure(kinematics, words)
    assert found.segment.max() < 1e-11
    assert found.bound.max() < 1e-8
    assert found.axis.max() < 1e-14


def test_standing_still_does_not_deviate(kinematics):
    found = measure(kinematics, np.tile([10.0, 20, 30, 40, 50], (3, 1)))
    assert found.segment.max() < 1e-11
    assert found.bound.max() < 1e-8


def test_axis_turning_on_a_cone_leaves_the_plane_of_its_ends_by_a_known_angle():
    kinematics, tilt, half = (
        kinematics_of("table_table"),
        np.radians([0.1, 20.0, 70.0, 40.0]),
        np.radians([60.0, 3.0, 80.0, 0.05]),
    )
    words = np.zeros((8, 5))
    words[0::2, 4] = words[1::2, 4] = np.degrees(tilt)
    words[1::2, 3] = np.degrees(2 * half)
    expected = tilt - np.arctan(np.tan(tilt) * np.cos(half))
    assert measure(kinematics, words).axis[1::2] == pytest.approx(expected, rel=1e-5)


def test_axis_that_comes_back_is_measured_from_where_it_started():
    kinematics = kinematics_of("table_table")
    assert measure(kinematics, [[0, 0, 0, 0, 30], [0, 0, 0, 360, 30]]).axis[1] == pytest.approx(
        np.radians(60.0)
    )
    assert measure(kinematics, [[0, 0, 0, 0, 0], [0, 0, 0, 90, 0]]).axis[1] == 0.0  # it spins about itself


def test_axis_deviation_agrees_with_sampling(kinematics):
    start, end = random_blocks(kinematics, 300, 9)
    axes = axis_at(kinematics, start, end, np.linspace(0, 1, 1001)[None])
    normal = np.cross(axes[:, 0], axes[:, -1])
    sine = np.linalg.norm(normal, axis=1)
    clear = sine > 1e-9
    off = np.abs(np.einsum("ijk,ik->ij", axes, normal)).max(axis=1)[clear] / sine[clear]
    found = measure(kinematics, interleaved(start, end)).axis[1::2][clear]
    assert (np.abs(found - np.arcsin(off)) <= np.maximum(2e-5 * found, 1e-9)).all()


# ------------------------------------------------------------------------------------------------ Lin & Ye


def half_circle(centre_distance, step, radius=60.0):
    """Words of a half circle cut by the A axis alone, and the arc's centre; its top is the middle of a
    step."""
    machine = load_machine("trunnion_ac")
    kinematics = chain(machine, Setup(machine.origin))
    centre = kinematics.point2 + (0.0, 0.0, centre_distance)
    angle = (np.arange(round(np.pi / step) + 1) - 0.5 * round(np.pi / step)) * step
    tips = centre + radius * np.stack([0 * angle, -np.sin(angle), np.cos(angle)], axis=1)
    turns = np.stack([0 * angle, angle], axis=1)
    return (
        kinematics,
        np.concatenate([linear_words(kinematics, tips, turns), np.degrees(turns)], axis=1),
        centre,
    )


def departure_in_mid_step(kinematics, words, centre, radius=60.0):
    """How far the real path is from the arc in the middle of each step."""
    return radius - np.linalg.norm(tip_at(kinematics, words[:-1], words[1:], 0.5) - centre, axis=1)


def test_lin_ye_half_circle_departs_from_the_arc_by_2_70_mm_with_the_r0_solved_from_it():
    """The paper prints 2.70 mm and no R0: 177.73 mm is solved from it by eq. (6). Tested is that the real
    path agrees with that."""
    kinematics, words, centre = half_circle(177.73, np.radians(20.0))
    departure = departure_in_mid_step(kinematics, words, centre)
    assert departure.max() == pytest.approx(2.70, abs=5e-4)
    assert lin_ye_deviation(177.73, np.radians(20.0)) == pytest.approx(departure.max(), abs=1e-9)


def test_lin_ye_half_circle_departs_from_the_chord_by_the_chord_error_less():
    """With the R0 solved from the paper's 2.70 mm."""
    kinematics, words, _ = half_circle(177.73, np.radians(20.0))
    chord_error = 60.0 * (1 - np.cos(np.radians(10.0)))
    top = len(words) // 2
    assert measure(kinematics, words).segment[top] + chord_error == pytest.approx(2.70, abs=5e-4)


@pytest.mark.parametrize("centre_distance", [0.0, 50.0, 100.0, 200.0])
@pytest.mark.parametrize("degrees", [2.0, 5.0, 10.0, 20.0])
def test_lin_ye_equation_6_is_exact_at_the_top_and_of_first_order_elsewhere(centre_distance, degrees):
    step = np.radians(degrees)
    kinematics, words, centre = half_circle(centre_distance, step)
    beta = np.radians(0.5 * (words[1:, 4] + words[:-1, 4]))
    departure, formula = (
        departure_in_mid_step(kinematics, words, centre),
        lin_ye_deviation(centre_distance, step, beta),
    )
    whole = lin_ye_deviation(centre_distance, step)
    assert (np.abs(departure - formula) <= whole**2 / (2 * (60.0 - whole)) + 1e-9).all()
    at_top = np.abs(beta) < 1e-9
    assert departure[at_top] == pytest.approx(formula[at_top], abs=1e-9)


# ----------------------------------------------------------------------------------------------- border cases


@pytest.mark.parametrize("rows", [0, 1])
def test_a_program_without_blocks_has_no_deviation(rows):
    found = measure(kinematics_of("head_head"), np.ones((rows, 5)))
    assert len(found.segment) == rows
    assert not found.bound.any()
    assert not found.place.any()


@pytest.mark.parametrize("value", [np.nan, np.inf, 1e7])
def test_words_that_are_no_numbers_are_refused_with_their_place(value):
    words = np.zeros((4, 5))
    words[2, 3] = value
    with pytest.raises(ProgramError, match="word 4 of row 2") as error:
        measure(kinematics_of("head_head"), words)
    assert error.value.value == pytest.approx(value, nan_ok=True)


def test_words_of_the_wrong_shape_are_refused():
    with pytest.raises(ProgramError, match=r"\(3, 4\)"):
        measure(kinematics_of("head_head"), np.zeros((3, 4)))


def test_an_unknown_method_is_refused():
    with pytest.raises(SettingsError, match="exact, so2008"):
        measure(kinematics_of("head_head"), np.zeros((3, 5)), method="guess")


def test_a_block_of_a_thousand_turns_is_measured():
    found = measure(kinematics_of("table_table"), [[75, -14, 0, 0, 0], [75, -14, 0, 360_000, 0]])
    assert found.segment[1] == pytest.approx(160.0, rel=1e-5)
    assert found.segment[1] <= found.bound[1]


def test_progress_reaches_the_end_and_may_stop_the_work():
    words, heard = ordinary_program(kinematics_of("table_table")), []
    measure(
        kinematics_of("table_table"), words, progress=lambda stage, fraction: heard.append((stage, fraction))
    )
    assert heard[-1] == ("deviation", 1.0)

    def stop(stage, fraction):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        measure(kinematics_of("table_table"), words, progress=stop)


def test_result_is_read_only():
    with pytest.raises(ValueError, match="read-only"):
        measure(kinematics_of("table_table"), np.zeros((3, 5))).segment[0] = 1.0
