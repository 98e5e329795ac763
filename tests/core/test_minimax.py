# SPDX-License-Identifier: LGPL-2.1-or-later
"""minimax: what it must reach, against facet_mean and an exact dynamic programme, and that it keeps what it
must not touch."""

import itertools
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from thorough import some_in_core

STUDIES = Path(__file__).parents[2] / "docs" / "studies"
sys.path.insert(0, str(STUDIES))

import lin_ye_parts as parts  # noqa: E402
import lin_ye_profiles as profiles  # noqa: E402
import minimax_cases as cases  # noqa: E402
from plain import build_settings  # noqa: E402
from uncured import UNCURED  # noqa: E402

from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError  # noqa: E402
from freecad_fiveaxis.core.cli import main  # noqa: E402
from freecad_fiveaxis.core.machine import load_machine  # noqa: E402
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, linear_words, q_to_words  # noqa: E402
from freecad_fiveaxis.core.motion.trajectory import tip_at  # noqa: E402
from freecad_fiveaxis.core.orientation.minimax import minimax_axes  # noqa: E402
from freecad_fiveaxis.core.orientation.minimax.apply import _drive_axes  # noqa: E402
from freecad_fiveaxis.core.orientation.minimax.blocks import bow, states  # noqa: E402
from freecad_fiveaxis.core.orientation.minimax.rows import find_rows, is_allowed, run_begins  # noqa: E402
from freecad_fiveaxis.core.orientation.minimax.steps import through_pole  # noqa: E402
from freecad_fiveaxis.core.orientation.minimax.sweep import cheapest  # noqa: E402
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, tool_axes  # noqa: E402
from freecad_fiveaxis.core.pipeline import job  # noqa: E402

TILT = np.radians(5.0)
LARGE = [pytest.mark.slow, pytest.mark.large]
DEPTHS = [150.0, *(pytest.param(depth, marks=LARGE) for depth in (None, 60.0, 300.0))]
FEED = 1000.0


def settings(machine, **others):
    options = {
        "machine": machine,
        "cutter": "ball:10",
        "stepover": 12.0,
        "control_point": "centre",
        "max_axis_angle": 60.0,
    }
    options |= UNCURED
    if load_machine(machine).has_head:
        options["tool_length"] = 120.0
    return build_settings("mill", str(parts.workshop() / f"{parts.PART}.stl"), options | others)


@cache
def given(machine, **others):
    """The offset path, facet_mean's axes, the chain, and reach of a job."""
    result = job.make(settings(machine, **others))
    reach = 5.0 if others.get("control_point") == "tip" else 0.0
    return result.offset, tool_axes(result.offset, "facet_mean", AxisOptions()), result.kinematics, reach


@cache
def found(machine, **others):
    offset, axis, kinematics, reach = given(machine, **others)
    return minimax_axes(offset, axis, kinematics, reach, TILT, FEED)


def beyond(path, axis, samples=2001):
    """Angle (n,) rad of each axis from the nearest of many points of its range: dense sampling of the arc."""
    turn = np.arccos(np.clip((path.before * path.after).sum(1), -1, 1))[:, None]
    share = np.linspace(0, 1, samples)
    sine = np.maximum(np.sin(turn), 1e-12)
    one, two = np.sin((1 - share) * turn) / sine, np.sin(share * turn) / sine
    one, two = np.where(turn < 1e-9, 1.0, one), np.where(turn < 1e-9, 0.0, two)
    arc = one[:, :, None] * path.before[:, None] + two[:, :, None] * path.after[:, None]
    return np.arccos(np.clip(np.einsum("nsi,ni->ns", arc, axis).max(axis=1), -1, 1))


# ----------------------------------------------------------------------------------------- what it must reach


@some_in_core("depth", DEPTHS, kept=())
def test_on_the_part_of_233_facets_at_least_5_times_smaller(depth):
    assert cases.ratio(cases.part(parts.PART, "table_ab", depth)) > 5.0


@pytest.mark.slow
@pytest.mark.parametrize("depth", DEPTHS)
def test_by_the_pole_at_least_10_times_smaller(depth):
    assert cases.ratio(cases.part(parts.PART, "trunnion_ac", depth)) > 10.0


@pytest.mark.slow
@pytest.mark.parametrize("depth", DEPTHS)
def test_on_the_half_cylinder_that_one_axis_turns_at_least_5_times_smaller(depth):
    assert cases.ratio(cases.part("half_cylinder", "table_ab", depth, **cases.HALF)) > 5.0


@pytest.mark.thorough
@pytest.mark.parametrize("depth", [None, 60.0, 150.0, 300.0])
def test_on_a_hill_that_one_axis_cuts_at_least_5_times_smaller(depth):
    case = cases.profile("hill", 1, depth)
    assert case.largest(case.mean) > 5.0 * case.largest(case.found)


@pytest.mark.thorough
@pytest.mark.parametrize(("family", "depth"), [("hill", 300.0), ("wavy", None), ("hollow", 150.0)])
def test_within_10_percent_of_the_exact_dynamic_programme(family, depth):
    case = cases.profile(family, 0, depth)
    assert case.largest(case.found) < 1.1 * cases.optimum(case, cases.TILT, 0.05)


def test_a_way_that_is_not_the_best_would_be_noticed():
    case = cases.profile("wavy", 0, None)
    assert case.largest(0.9 * case.found + 0.1 * case.mean) > 1.1 * cases.optimum(case, cases.TILT, 0.1)


def test_in_a_hollow_5_times_is_beyond_the_optimum_itself():
    case = cases.profile("hollow", 0, 150.0)
    assert case.largest(case.mean) < 5.0 * cases.optimum(case, cases.TILT, 0.05)


def test_the_dynamic_programmes_blocks_are_those_of_the_core():
    case = cases.profile("wavy", 1, 60.0)
    y, z = case.path.centre[:, 1], case.path.centre[:, 2] - case.axis_z
    place = z + 1j * y
    bows = [
        cases._bows(place[i], case.mean[i : i + 1], place[i + 1], case.mean[i + 1 : i + 2])[0, 0]
        for i in range(len(y) - 1)
    ]
    assert max(bows) == pytest.approx(case.largest(case.mean), rel=0.02)


@pytest.mark.thorough
def test_more_tilt_makes_it_smaller():
    largest = [cases.profile("hill", 1, 300.0, tilt) for tilt in (1.0, 3.0, 8.0)]
    largest = [case.largest(case.found) for case in largest]
    assert largest[0] > 1.3 * largest[1] > 1.3 * 1.3 * largest[2]


# ------------------------------------------------------------------------------------------ what it must keep


MACHINES = [
    "head_b_table_c",
    *(pytest.param(name, marks=pytest.mark.slow) for name in ("trunnion_ac", "fork_head_bc")),
    pytest.param("nutating_table_b45", marks=LARGE),
]


@pytest.mark.thorough
@pytest.mark.parametrize("machine", MACHINES)
def test_no_run_is_worse_and_those_not_better_are_the_same_to_the_last_bit(machine):
    offset, axis, kinematics, reach = given(machine)
    new = found(machine)
    before, after = (
        _drive_axes(offset, axis, kinematics, reach)[1],
        _drive_axes(offset, new, kinematics, reach)[1],
    )
    assert after.max() < before.max() / 3.0
    assert (after <= before * (1 + 1e-9) + 1e-9).all()
    run = np.cumsum(run_begins(offset)) - 1
    for number in np.flatnonzero(after >= 0.99 * before):
        assert np.array_equal(new[run == number], axis[run == number])


@pytest.mark.parametrize("machine", MACHINES)
def test_every_axis_is_within_the_tilt_of_its_range(machine):
    offset, new = given(machine)[0], found(machine)
    np.testing.assert_allclose(np.linalg.norm(new, axis=1), 1.0, atol=1e-12)
    assert beyond(offset, new).max() < TILT + 1e-4
    assert ((new * offset.before).sum(1) > -1e-9).all() and ((new * offset.after).sum(1) > -1e-9).all()
    assert beyond(offset, new).max() > 0.5 * TILT  # a smaller tilt would be noticed


@pytest.mark.parametrize("machine", MACHINES)
def test_no_rotary_axis_exceeds_its_rate_where_it_did_not_before(machine):
    offset, axis, kinematics, reach = given(machine)
    minutes = np.linalg.norm(np.diff(offset.centre, axis=0), axis=1) / FEED
    inside = ~run_begins(offset)[1:]
    turn = [
        np.abs(np.diff(_drive_axes(offset, ways, kinematics, reach)[0], axis=0))
        for ways in (axis, found(machine))
    ]
    most = np.maximum(kinematics.rate[3:] * minutes[:, None], turn[0])
    assert (turn[1] <= 1.01 * most + 2e-6)[inside].all()


def test_a_slow_axis_bounds_the_gain():
    case = cases.profile("hill", 1, 150.0)
    kinematics = cases.one_axis(case.axis_z)
    rate = kinematics.rate.copy()
    rate[3:] = 1e-3
    slow = replace(kinematics, rate=rate)
    axis = tool_axes(case.path, "facet_mean", AxisOptions())
    new = minimax_axes(case.path, axis, slow, 0.0, TILT, FEED)
    lean = np.arctan2(new[:, 1], new[:, 2])
    assert (np.abs(np.diff(lean)) <= np.abs(np.diff(case.mean)) + 1e-6).all()
    assert case.largest(lean) > 3.0 * case.largest(case.found)


def test_the_limits_of_the_rotary_axes_hold():
    case = cases.profile("wavy", 0, None)
    kinematics = cases.one_axis(case.axis_z)
    most = np.abs(case.mean).max() + np.radians(0.5)
    assert np.abs(case.found).max() > most
    low, high = kinematics.low.copy(), kinematics.high.copy()
    low[4], high[4] = -most, most
    axis = tool_axes(case.path, "facet_mean", AxisOptions())
    new = minimax_axes(case.path, axis, replace(kinematics, low=low, high=high), 0.0, TILT)
    lean = np.arctan2(new[:, 1], new[:, 2])
    assert np.abs(lean).max() <= most + 1e-9
    assert case.largest(lean) < case.largest(case.mean) / 2.0


@pytest.mark.parametrize(
    "control_point",
    [pytest.param("tip", marks=pytest.mark.thorough), pytest.param("centre", marks=pytest.mark.slow)],
)
def test_the_surface_is_cut_as_before(control_point):
    """The ball's centre and its contact of every row are those of facet_mean; only the axis moves."""
    one, two = (
        job.make(settings("trunnion_ac", tool_axis=method, control_point=control_point))
        for method in ("facet_mean", "minimax")
    )
    reach = 5.0 if control_point == "tip" else 0.0
    cut = [result.path.motion <= 1 for result in (one, two)]
    assert np.array_equal(one.path.contact[cut[0]], two.path.contact[cut[1]])
    centre = [
        result.path.tip[rows] + reach * result.path.axis[rows]
        for result, rows in zip((one, two), cut, strict=True)
    ]
    np.testing.assert_allclose(centre[0], centre[1], atol=1e-9)
    assert np.abs(one.path.axis[cut[0]] - two.path.axis[cut[1]]).max() > 0.02
    largest = [job.prove(result).deviation.segment[result.program.motion <= 1].max() for result in (one, two)]
    assert largest[1] < largest[0] / 3.0


@pytest.mark.slow
def test_the_axes_are_the_same_on_every_run():
    offset, axis, kinematics, reach = given("trunnion_ac")
    assert np.array_equal(minimax_axes(offset, axis, kinematics, reach, TILT, FEED), found("trunnion_ac"))


def test_polylines_that_touch_are_one_run():
    path = cases.profile("hill", 1, 150.0).path
    split = np.where(np.arange(len(path.point)) < 30, 0, 1)
    apart = replace(path, polyline=split)
    assert len(find_rows(apart).first) == 2
    centre = path.centre.copy()
    centre[30] = centre[29]
    assert len(find_rows(replace(apart, centre=centre)).first) == 1


def test_an_empty_path_and_a_flat_one_keep_their_axes():
    offset, axis, kinematics, reach = given("trunnion_ac")
    none = replace(
        offset, **{name: value[:0] for name, value in vars(offset).items() if isinstance(value, np.ndarray)}
    )
    assert minimax_axes(none, axis[:0], kinematics, reach, TILT).shape == (0, 3)
    flat = profiles.offset_path(np.column_stack([np.arange(6.0), np.zeros(6)]))
    up = tool_axes(flat, "facet_mean", AxisOptions())
    assert np.array_equal(minimax_axes(flat, up, kinematics, 0.0, TILT), up)


# --------------------------------------------------------------------------------------------- how it is told


def test_it_says_where_it_stands_and_can_be_stopped():
    case = cases.profile("hill", 1, 150.0)
    offset, axis, kinematics, reach = (
        case.path,
        tool_axes(case.path, "facet_mean", AxisOptions()),
        cases.one_axis(case.axis_z),
        0.0,
    )
    message = []
    minimax_axes(
        offset, axis, kinematics, reach, TILT, FEED, lambda stage, share: message.append((stage, share))
    )
    assert len(message) > 5 and all(0.0 <= share <= 1.0 for _, share in message)
    assert any(abs(40.0 * share - round(40.0 * share)) > 0.1 for _, share in message), (
        "it speaks within a round, too"
    )

    def stop(stage, share):
        raise Cancelled("enough")

    with pytest.raises(Cancelled):
        minimax_axes(offset, axis, kinematics, reach, TILT, FEED, stop)


@pytest.mark.parametrize("tilt", [0.0, -0.1, 1.0, np.nan])
def test_a_tilt_of_zero_or_beyond_all_sense_is_refused(tilt):
    offset, axis, kinematics, reach = given("trunnion_ac")
    with pytest.raises(SettingsError, match=r"max-tilt .* is out of range; give 0.001 to 30 deg"):
        minimax_axes(offset, axis, kinematics, reach, tilt)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--max-tilt", "0"], "max-tilt 0 is out of range"), (["--max-tilt", "31"], "at most 30 deg"),
        (["--max-tilt", "nan"], "max-tilt"), (["--lead", "3"], "lead 3 deg leaves minimax no choice; leave it out"),
        (["--tilt", "-3"], "tilt -3 deg leaves minimax no choice"),
    ],
)  # fmt: skip
def test_bad_settings_end_with_2_and_name_the_remedy(words, message, capsys, tmp_path):
    part, out = str(parts.workshop() / f"{parts.PART}.stl"), tmp_path / "a.ngc"
    reported = ["mill", part, "--machine", "trunnion_ac", "--tool-axis", "minimax", "-o", str(out), *words]
    assert main(reported) == 2
    assert message in capsys.readouterr().err and not out.exists()


def test_max_tilt_is_for_minimax_alone_and_its_default_is_5_deg():
    assert settings("trunnion_ac").tool_axis.max_tilt == pytest.approx(TILT)
    assert settings("trunnion_ac", tool_axis="facet_mean", lead=3.0).tool_axis.lead > 0.0


# ------------------------------------------------------------------------------------------------ its parts


@pytest.mark.thorough
@pytest.mark.parametrize("angle", [0.0, 1e-12, 0.3, 2.0])
def test_what_is_allowed_is_what_dense_sampling_of_the_range_says(angle):
    rng = np.random.default_rng(3)
    before = np.array([[0.0, 0.0, 1.0]])
    after = np.array([[np.sin(angle), 0.0, np.cos(angle)]])
    axis = rng.normal(size=(4000, 3)) * (0.6, 0.2, 0.6)
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    turn = np.linspace(0.0, angle, 4001)
    arc = np.column_stack([np.sin(turn), 0.0 * turn, np.cos(turn)])
    away = np.arccos(np.clip((axis @ arc.T).max(axis=1), -1, 1))
    expected = (away <= TILT) & (axis @ before[0] >= 0) & (axis @ after[0] >= 0)
    got = is_allowed(before, after, TILT, axis.T[:, :, None])[:, 0]
    clear = np.abs(away - TILT) > 1e-5
    assert np.array_equal(got[clear], expected[clear]) and 10 < got.sum() < 3000


@pytest.mark.parametrize("machine", MACHINES)
def test_bows_are_those_of_the_real_path(machine):
    record = load_machine(machine)
    kinematics = chain(record, Setup(record.origin, 120.0 if record.has_head else 0.0))
    rng = np.random.default_rng(5)
    angles, centre = rng.uniform(-0.5, 0.5, (2, 3, 4)), rng.uniform(-40, 40, (4, 3))
    there = states(kinematics, angles, centre, 5.0)
    got = bow(kinematics, there.ends.take(slice(0, 3)), there.ends.take(slice(1, 4)), (0.25, 0.5, 0.75))
    axis = np.moveaxis(there.axis, 0, -1)
    for row, one, two in itertools.product(range(3), range(3), range(3)):
        place = [centre[row] - 5.0 * axis[one, row], centre[row + 1] - 5.0 * axis[two, row + 1]]
        turn = [angles[:, one, row], angles[:, two, row + 1]]
        words = [
            q_to_words(np.column_stack([linear_words(kinematics, p[None], a[None]), a[None]]))
            for p, a in zip(place, turn, strict=True)
        ]
        real = tip_at(kinematics, words[0], words[1], np.array([[0.25, 0.5, 0.75]]))[0]
        chord = place[1] - place[0]
        foot = np.clip((real - place[0]) @ chord / (chord @ chord), 0, 1)
        assert got[one, two, row] == pytest.approx(
            np.linalg.norm(real - place[0] - foot[:, None] * chord, axis=1).max(), abs=1e-9
        )


def test_the_cheapest_way_is_that_of_all_ways():
    rng = np.random.default_rng(7)
    size, width = np.array([4, 1, 3]), 3
    first = np.cumsum(size) - size
    cost, entry = rng.uniform(0, 1, (width, width, 7)), rng.uniform(0, 1, (width, 8))
    state = cheapest(cost, entry, first, size)
    for begin, rows in zip(first, size, strict=True):

        def total(way, begin=begin):
            steps = sum(cost[a, b, begin + i] for i, (a, b) in enumerate(itertools.pairwise(way)))
            return steps + sum(entry[s, begin + i] for i, s in enumerate(way))

        best = min(itertools.product(range(width), repeat=int(rows)), key=total)
        assert tuple(state[begin : begin + rows]) == best


def test_an_arc_through_the_pole_is_reported_from_one_beside_it():
    lean = np.radians(3.0)
    one = np.array([np.sin(lean), 0.0, np.cos(lean)]).reshape(3, 1, 1)
    ends = [(-1.0, 0.0), (-1.0, 0.1), (1.0, 0.0)]  # opposite, beside, on the same side
    two = np.array([[np.sin(lean) * x, np.sin(lean) * y, np.cos(lean)] for x, y in ends]).T.reshape(3, 3, 1)
    assert through_pole(np.array([0.0, 0.0, 1.0]), one, two)[0, :, 0].tolist() == [True, False, False]
