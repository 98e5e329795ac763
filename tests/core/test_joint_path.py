# SPDX-License-Identifier: LGPL-2.1-or-later
"""The joint path: poles, limits, rewinds, rapids, on every shipped machine."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from bare_machines import BARE

from freecad_fiveaxis.core.base.errors import Cancelled, ReachError, SettingsError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, branch_of, chain, forward, inverse_axis
from freecad_fiveaxis.core.motion.joint_path import plan, solve
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

LOW, HIGH, CLEARANCE = np.array([-25.0, -25.0, -30.0]), np.array([25.0, 25.0, 5.0]), 4.0


def path_of(tip, axis, motion):
    tip, axis, motion = np.array(tip, float), np.array(axis, float), np.array(motion, np.int8)
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    none = np.full(len(tip), -1)
    return CLPath(
        tip, axis, motion, np.where(motion == Motion.RAPID, 0.0, 800.0), tip, axis, none, none, none
    )


def linked(tip, axis):
    """A cut with its approach and retract of 60 mm along the axis."""
    tip, axis = np.array(tip, float), np.array(axis, float)
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    tip = np.concatenate([tip[:1] + 60.0 * axis[:1], tip, tip[-1:] + 60.0 * axis[-1:]])
    axis = np.concatenate([axis[:1], axis, axis[-1:]])
    return path_of(tip, axis, [Motion.RAPID, Motion.LINK, *[Motion.CUT] * (len(tip) - 3), Motion.LINK])


def joined(*paths):
    columns = {
        name: np.concatenate([getattr(p, name) for p in paths])
        for name in CLPath.__dataclass_fields__
        if name != "findings"
    }
    return CLPath(**columns)


def circling(turns, tilt=0.5, steps=72, start=0.3):
    a = np.linspace(start, start + 2.0 * math.pi * turns, round(steps * turns) + 1)
    axis = np.column_stack(
        [math.sin(tilt) * np.cos(a), math.sin(tilt) * np.sin(a), np.full(len(a), math.cos(tilt))]
    )
    return linked(np.column_stack([20.0 * np.cos(a), 20.0 * np.sin(a), np.zeros(len(a))]), axis)


def dome_zigzag(passes=9, points=41, radius=40.0):
    y, x = np.linspace(-20.0, 20.0, passes), np.linspace(-20.0, 20.0, points)
    runs = []
    for i, yi in enumerate(y):
        along = x if i % 2 == 0 else x[::-1]
        axis = np.column_stack([along, np.full(points, yi), np.sqrt(radius**2 - along**2 - yi**2)]) / radius
        runs.append(linked(radius * axis - [0.0, 0.0, radius - 5.0], axis))
    return joined(*runs)


def meridian(tilts, azimuth=0.4, tip_step=1.0):
    """A cut straight over the pole of a machine whose first rotary axis is vertical; tilts in degrees,
    signed."""
    t = np.radians(np.array(tilts, float))
    axis = np.column_stack([np.sin(t) * math.cos(azimuth), np.sin(t) * math.sin(azimuth), np.cos(t)])
    return linked(np.column_stack([np.arange(len(t)) * tip_step, np.zeros(len(t)), np.zeros(len(t))]), axis)


def kinematics_of(name, first=None, second=None, **setup):
    machine = load_machine(name)
    limits = dict(zip(machine.rotary, (first, second), strict=True))
    axes = tuple(
        replace(axis, low=math.radians(limits[axis][0]), high=math.radians(limits[axis][1]))
        if limits.get(axis)
        else axis
        for axis in machine.axes
    )
    return chain(
        replace(machine, axes=axes),
        Setup(setup.get("origin", machine.origin), setup.get("tool_length", 100.0)),
    )


def given_rows(joints):
    """Where the rows of the given path stand in the driven one: the last of each run of equal ``row``."""
    return np.flatnonzero(np.append(joints.row[1:] != joints.row[:-1], True))


def dense(kinematics, q, count=400):
    """Tips (blocks, count, 3) along every block, words going evenly."""
    u = np.linspace(0.0, 1.0, count)[None, :, None]
    words = q[:-1, None] + u * (q[1:] - q[:-1])[:, None]
    return forward(kinematics, words.reshape(-1, 5))[0].reshape(len(q) - 1, count, 3)


def off_chord(points):
    start, chord = points[:, :1], points[:, -1:] - points[:, :1]
    length2 = np.maximum((chord**2).sum(2, keepdims=True), 1e-300)
    share = np.clip(((points - start) * chord).sum(2, keepdims=True) / length2, 0.0, 1.0)
    return np.linalg.norm(points - start - share * chord, axis=2).max(1)


def inside_box(points, margin):
    return ((points > LOW - margin) & (points < HIGH + margin)).all(-1)


MACHINES = BARE


@pytest.mark.parametrize("name", MACHINES)
def test_every_row_gives_back_its_tip_and_axis_and_a_cut_goes_on_without_jumps(name):
    kinematics = kinematics_of(name)
    path = dome_zigzag()
    joints = solve(path, kinematics, LOW, HIGH, CLEARANCE)
    tip, axis = forward(kinematics, joints.q)
    np.testing.assert_allclose(tip, joints.path.tip, atol=1e-9)
    np.testing.assert_allclose(axis, joints.path.axis, atol=1e-9)
    np.testing.assert_allclose(joints.sine, inverse_axis(kinematics, joints.path.axis)[1], atol=1e-9)
    away = joints.sine > 1e-6
    assert (joints.branch == branch_of(kinematics, joints.q[:, 4]))[away].all()
    assert not [f for f in joints.findings if f.code != "limit"]
    assert (
        np.abs(np.diff(joints.q[:, 3:], axis=0))[joints.path.motion[1:] != Motion.RAPID] <= math.pi + 1e-9
    ).all()


@pytest.mark.parametrize("name", MACHINES)
def test_rows_lead_to_the_rows_of_the_given_path(name):
    path = joined(circling(1.2), circling(1.4, start=2.0))
    joints = solve(path, kinematics_of(name, first=(-200.0, 200.0)), LOW, HIGH, CLEARANCE)
    at = given_rows(joints)
    assert (np.diff(joints.row) >= 0).all() and joints.row[0] == 0
    np.testing.assert_array_equal(joints.row[at], np.arange(len(path.tip)))
    np.testing.assert_array_equal(joints.path.tip[at], path.tip)
    np.testing.assert_array_equal(joints.path.axis[at], path.axis)
    assert joints.path.motion[0] == Motion.RAPID
    assert len(joints.row) > len(path.tip)


@pytest.mark.parametrize("name", ["trunnion_ac", "head_b_table_c"])
@pytest.mark.parametrize("tilts", [[-9, -6, -3, 0, 3, 6, 9], [-9, -6, -2, 1, 4, 7]])
def test_straight_over_the_pole_the_first_axis_stands_still_and_the_second_changes_sides(name, tilts):
    joints = solve(meridian(tilts), kinematics_of(name), LOW, HIGH, CLEARANCE)
    assert np.ptp(joints.q[:, 3]) < 1e-9
    assert np.ptp(joints.q[:, 4]) == pytest.approx(math.radians(tilts[-1] - tilts[0]), abs=1e-12)
    assert {0, 1} == set(joints.branch.tolist())
    assert joints.findings == ()


@pytest.mark.parametrize("degrees", [3.0, 0.3, 0.12])
def test_past_the_pole_at_a_distance_the_first_axis_turns_on_one_branch(degrees):
    """The comparison above can fail: beside the pole the branch has to stay; across it the axis would leave
    its arc by as much."""
    t = np.radians(np.arange(-9.0, 10.0, 2.0))
    side = math.radians(degrees)
    axis = np.column_stack([np.sin(t), np.full(len(t), math.sin(side)), np.cos(t)])
    joints = solve(
        linked(np.column_stack([t, 0 * t, 0 * t]) * 50.0, axis),
        kinematics_of("trunnion_ac"),
        LOW,
        HIGH,
        CLEARANCE,
    )
    assert len(set(joints.branch.tolist())) == 1
    assert np.ptp(joints.q[:, 3]) > math.radians(120.0)


def test_so_near_to_the_pole_that_no_one_sees_it_the_branch_changes():
    t = np.radians(np.arange(-9.0, 10.0, 2.0))
    axis = np.column_stack([np.sin(t), np.full(len(t), math.sin(math.radians(0.08))), np.cos(t)])
    joints = solve(
        linked(np.column_stack([t, 0 * t, 0 * t]) * 50.0, axis),
        kinematics_of("trunnion_ac"),
        LOW,
        HIGH,
        CLEARANCE,
    )
    assert set(joints.branch.tolist()) == {0, 1} and np.abs(np.diff(joints.q[:, 3])).max() < math.radians(
        10.0
    )


def test_with_one_side_of_the_tilt_only_the_first_axis_turns_at_the_pole_in_one_step():
    kinematics = kinematics_of("trunnion_ac", second=(-0.001, 90.0))
    joints = solve(meridian([-9, -6, -3, 0, 0, 3, 6, 9]), kinematics, LOW, HIGH, CLEARANCE)
    turns = np.abs(np.diff(joints.q[:, 3]))
    assert turns.sum() == pytest.approx(math.pi, abs=1e-9)
    assert (turns > 1e-9).sum() == 1
    assert joints.findings == ()


def test_along_cuts_at_the_pole_the_first_axis_turns_evenly():
    """At once it would take the time of the whole turn on one short cut, where the tool would dwell."""
    path = meridian([-9, -6, 0, 0, 0, 0, 6, 9])
    path = replace(path, tip=path.tip + np.outer([0, 0, 0, 0, 1, 4, 6, 6, 6, 6], [0.0, 2.0, 0.0]))
    joints = solve(path, kinematics_of("trunnion_ac", second=(-0.001, 90.0)), LOW, HIGH, CLEARANCE)
    pole = np.flatnonzero(np.abs(joints.q[:, 4]) < 1e-9)
    length, turns = np.linalg.norm(np.diff(joints.path.tip[pole], axis=0), axis=1), np.diff(joints.q[:, 3])
    assert len(pole) == 4 and np.ptp(length) > 1.0
    assert turns[pole[:-1]] == pytest.approx(turns.sum() * length / length.sum(), abs=1e-9)
    assert abs(turns.sum()) == pytest.approx(math.pi) and np.abs(np.delete(turns, pole[:-1])).max() < 1e-9


def test_the_turn_at_the_pole_is_built_on_a_rapid_where_there_is_one():
    up = path_of([[0, 0, 60.0], [30, 0, 60.0]], [[0, 0, 1.0]] * 2, [Motion.RAPID] * 2)
    path = joined(meridian([-9, -5, 0]), up, meridian([0, 5, 9], azimuth=1.3))
    joints = solve(path, kinematics_of("trunnion_ac", second=(0.0, 90.0)), LOW, HIGH, CLEARANCE)
    turning = np.flatnonzero(np.abs(np.diff(joints.q[:, 3])) > 1e-9) + 1
    assert len(turning) and (joints.path.motion[turning] == Motion.RAPID).all()


def test_the_turn_at_the_pole_is_built_on_the_longest_cut_rather_than_on_a_link():
    """Without a rapid between two cuts: the links there are 60 mm long, the longest cut at the pole 3 mm."""
    first, second = meridian([-9, -5, 0]), meridian([0, 5, 9], azimuth=1.3, tip_step=3.0)
    path = joined(first, second)
    motion = path.motion.copy()
    motion[len(first.motion)] = Motion.LINK  # from retract to approach, at the pole
    joints = solve(
        replace(path, motion=motion), kinematics_of("trunnion_ac", second=(0.0, 90.0)), LOW, HIGH, CLEARANCE
    )
    turning = np.flatnonzero(np.abs(np.diff(joints.q[:, 3])) > 1e-9) + 1
    assert joints.path.motion[turning].tolist() == [Motion.CUT]
    assert joints.path.tip[turning[0]] == pytest.approx((3.0, 0.0, 0.0), abs=1e-9)


def test_a_turn_at_the_pole_that_no_cut_could_make_is_built_on_the_rapid():
    """C from 160 deg to -160 deg, the short way barred by the limits: 320 deg, but never on a cut or a
    link."""
    up = path_of([[0, 0, 60.0], [30, 0, 60.0]], [[0, 0, 1.0]] * 2, [Motion.RAPID] * 2)
    path = joined(
        meridian([9, 5, 0], azimuth=math.radians(70)), up, meridian([0, 5, 9], azimuth=math.radians(110))
    )
    joints = solve(
        path, kinematics_of("trunnion_ac", first=(-175.0, 175.0), second=(0.0, 90.0)), LOW, HIGH, CLEARANCE
    )
    turning = np.flatnonzero(np.abs(np.diff(joints.q[:, 3])) > 1e-9) + 1
    assert np.abs(np.diff(joints.q[:, 3])).sum() == pytest.approx(math.radians(320.0), abs=1e-9)
    assert (joints.path.motion[turning] == Motion.RAPID).all() and joints.findings == ()


def test_pole_rows_cost_no_needless_travel():
    """Against trying the first word of every other row, both branches, on the pole rows."""
    kinematics = kinematics_of("trunnion_ac", first=(-1e5, 1e5))
    rng = np.random.default_rng(3)
    for _ in range(20):
        tilt, azimuth = rng.uniform(0.1, 0.5, 4), rng.uniform(-math.pi, math.pi, 4)
        tilt[[1, 2]] = 0.0
        axis = np.column_stack([np.sin(tilt) * np.cos(azimuth), np.sin(tilt) * np.sin(azimuth), np.cos(tilt)])
        joints = solve(linked(rng.uniform(-20, 20, (4, 3)), axis), kinematics, LOW, HIGH, CLEARANCE)
        angles = inverse_axis(kinematics, axis)[0]
        least = min(
            abs(math.remainder(angles[b, 3, 0] - angles[a, 0, 0], 2 * math.pi))
            + abs(angles[a, 0, 1])
            + abs(angles[b, 3, 1])
            for a in range(2)
            for b in range(2)
        )
        assert np.abs(np.diff(joints.q[:, 3:], axis=0)).sum() == pytest.approx(least, abs=1e-9)


def test_a_path_that_stands_at_the_pole_keeps_the_first_axis_where_it_is():
    tip = [[0, 0, 50], [0, 0, 0], [5, 3, 0], [0, 0, 50]]
    joints = solve(
        path_of(tip, [[0, 0, 1]] * 4, [3, 2, 0, 2]), kinematics_of("mikron_ucp710"), LOW, HIGH, CLEARANCE
    )
    np.testing.assert_array_equal(joints.q[:, 3:], 0.0)
    np.testing.assert_allclose(joints.q[:, :3], tip, atol=1e-9)


def test_five_turns_are_cut_in_one_where_nothing_limits_them():
    joints = solve(circling(5), kinematics_of("mikron_ucp710"), LOW, HIGH, CLEARANCE)
    assert np.ptp(joints.q[:, 3]) == pytest.approx(10.0 * math.pi)
    assert len(joints.q) == len(circling(5).tip) and joints.findings == ()


@pytest.mark.parametrize(("limit", "rewinds"), [(360.0, 2), (540.0, 1), (900.0, 1), (1080.0, 0)])
def test_five_turns_within_limits_rewind_as_seldom_as_possible(limit, rewinds):
    joints = solve(circling(5), kinematics_of("head_b_table_c", first=(-limit, limit)), LOW, HIGH, CLEARANCE)
    single = [f for f in joints.findings if f.code == "rewind"]
    assert len(single) == rewinds
    assert all(f.severity == Severity.WARNING and f.block is not None and f.unit == "deg" for f in single)
    assert [f.value for f in joints.findings if f.code == "rewinds"] == (
        [float(rewinds)] if rewinds > 1 else []
    )
    assert np.abs(joints.q[:, 3]).max() <= math.radians(limit)
    cutting = joints.path.motion[1:] < Motion.LINK
    assert np.abs(np.diff(joints.q[:, 3]))[cutting].max() <= math.radians(5.0) + 1e-9


def list_reported(joints, code):
    return [one for one in joints.findings if one.code == code]


ONE_SIDE = {"first": (-200.0, 200.0), "second": (0.0, 110.0)}
"""Limits, deg, of an axis that has 400 deg, and of one that leans to one side: there is one branch."""


@pytest.mark.parametrize("start", [0.0, 0.7, 2.0, 4.1])
@pytest.mark.parametrize("second", [(0.0, 110.0), (-110.0, 110.0)])
def test_a_cut_that_turns_farther_than_the_limits_are_wide_says_how_far(second, start):
    path, kinematics = (
        circling(410.0 / 360.0, start=start),
        kinematics_of("head_b_table_c", (-200, 200), second),
    )
    joints = solve(path, kinematics, LOW, HIGH, CLEARANCE)
    (one,) = list_reported(joints, "rewind")
    assert "takes 410.0 and has 400.0 deg: wider limits" in one.text and joints.rewinds == 1


def test_a_cut_that_fits_begins_on_the_turn_that_fits_and_else_says_that_it_only_begins_elsewhere():
    """A cut of 367 deg within 400 fits where it begins in 33 of 360 deg: there no way turns back."""
    kinematics, fitting = kinematics_of("head_b_table_c", **ONE_SIDE), 0
    for start in np.radians(np.arange(0.0, 360.0, 8.0)):
        joints = solve(circling(367.0 / 360.0, start=start), kinematics, LOW, HIGH, CLEARANCE)
        turned = [one.text for one in list_reported(joints, "rewind")]
        assert all("takes 367.0 and has 400.0 deg, but begins where" in text for text in turned)
        assert np.abs(joints.q[:, 3]).max() <= math.radians(200.0) and len(turned) == joints.rewinds <= 1
        fitting += not turned
    assert fitting == pytest.approx(45 * 33 / 360, abs=1.0)


def arcs(count, start):
    """Cuts of 88 deg, each beginning 2 deg behind the end of the one before, after a link."""
    path = joined(*(circling(88.0 / 360.0, start=math.radians(start + 90.0 * k)) for k in range(count)))
    motion = path.motion.copy()
    motion[1:][motion[1:] == Motion.RAPID] = Motion.LINK
    return replace(path, motion=motion)


def inside(joints, path):
    """How many rewinds lie on steps to rows that are cut."""
    jumps = np.flatnonzero(np.abs(np.diff(joints.q[given_rows(joints), 3])) > math.pi)
    return int((path.motion[jumps + 1] == Motion.CUT).sum())


def test_an_axis_rather_turns_back_between_two_cuts_than_inside_one(monkeypatch):
    """From -170 to 368 deg within 400: it turns back somewhere from 160 to 200 deg, and at 188 deg there is a
    link."""
    path, kinematics = arcs(6, -170.0), kinematics_of("head_b_table_c", **ONE_SIDE)
    joints = solve(path, kinematics, LOW, HIGH, CLEARANCE)
    assert joints.rewinds == 1 and not inside(joints, path) and not list_reported(joints, "rewind")
    (one,) = list_reported(joints, "rewinds-between-cuts")
    assert one.value == 1.0 and one.severity == Severity.NOTE and one.block is not None
    assert str(one.text).startswith("Once the tool retracts between two cuts and C turns back")
    monkeypatch.setattr(plan, "BETWEEN", 1.0)
    before = solve(path, kinematics, LOW, HIGH, CLEARANCE)
    assert before.rewinds == 1 and inside(before, path) == 1 and list_reported(before, "rewind")


def test_a_way_without_a_break_is_not_chosen_anew(monkeypatch):
    wanted, choose = [], plan.choose

    def spied(*given):
        wanted.append(given)
        return choose(*given)

    monkeypatch.setattr(plan, "choose", spied)
    solve(circling(1.0), kinematics_of("head_b_table_c"), LOW, HIGH, CLEARANCE)
    assert len(wanted) == 1
    solve(circling(1.5), kinematics_of("head_b_table_c", first=(-180.0, 180.0)), LOW, HIGH, CLEARANCE)
    assert len(wanted) == 3


def test_a_rewind_leaves_along_the_axis_and_comes_back_to_the_same_place():
    path = circling(1.5)
    joints = solve(path, kinematics_of("head_b_table_c", first=(-180.0, 180.0)), LOW, HIGH, CLEARANCE)
    motion, tip, axis = joints.path.motion, joints.path.tip, joints.path.axis
    link = np.flatnonzero(motion == Motion.LINK)[1:-1].reshape(-1, 2)
    assert len(link) >= 1
    for out, back in link:
        np.testing.assert_allclose(tip[back], tip[out - 1], atol=1e-6)
        for i in (out, back):
            way = tip[i] - tip[i - 1]
            assert abs(abs(way @ axis[i]) - np.linalg.norm(way)) < 1e-9
        np.testing.assert_allclose(joints.q[out, 3:], joints.q[out - 1, 3:])
        assert motion[out + 1 : back].tolist() == [Motion.RAPID] * (back - out - 1)
        assert abs(joints.q[back, 3] - joints.q[out, 3]) == pytest.approx(2.0 * math.pi, abs=1e-6)
    cut = np.linalg.norm(np.diff(tip, axis=0), axis=1)[motion[1:] == Motion.CUT].sum()
    assert cut == pytest.approx(
        np.linalg.norm(np.diff(path.tip, axis=0), axis=1)[path.motion[1:] == Motion.CUT].sum(), abs=1e-6
    )
    own = np.flatnonzero((motion == Motion.LINK) | (motion == Motion.RAPID))
    assert (joints.path.face[own] == -1).all() and (joints.path.feed[motion == Motion.RAPID] == 0.0).all()


@pytest.mark.parametrize("name", MACHINES)
def test_rapids_stay_by_their_chord_and_out_of_the_part(name):
    path = joined(circling(1.3), circling(0.4, tilt=0.9, start=4.0), circling(1.2, tilt=0.2, start=1.0))
    kinematics = kinematics_of(name, first=(-185.0, 185.0))
    joints = solve(path, kinematics, LOW, HIGH, CLEARANCE)
    rapid = np.flatnonzero(joints.path.motion[1:] == Motion.RAPID)
    tips = dense(kinematics, joints.q)[rapid]
    assert off_chord(tips).max() <= 0.5 * CLEARANCE
    own = joints.row[rapid + 1]
    inserted = ~np.isin(rapid + 1, given_rows(joints)) & (path.motion[own] != Motion.RAPID)
    assert inserted.any()
    assert not inside_box(tips[inserted], 0.5 * CLEARANCE).any()


def test_a_rapid_in_one_block_would_leave_its_chord():
    """The comparison above can fail: without the blocks in between the tip swings far out."""
    path = joined(circling(0.3), circling(0.3, tilt=0.9, start=3.0))
    kinematics = kinematics_of("trunnion_ac")
    joints = solve(path, kinematics, LOW, HIGH, CLEARANCE)
    assert len(joints.q) > len(path.tip)
    assert off_chord(dense(kinematics, joints.q[given_rows(joints)])).max() > CLEARANCE


def test_where_no_side_of_a_rewind_reaches_the_axis_the_rest_is_reported_as_uncut():
    a = np.radians([60.0, 80.0, 100.0, 120.0])
    axis = np.column_stack([0.5 * np.cos(a), 0.5 * np.sin(a), np.full(4, math.sqrt(0.75))])
    tip = np.column_stack([np.arange(4) * 2.0, np.zeros(4), np.zeros(4)])
    kinematics = kinematics_of("mikron_ucp710", first=(-175.0, 175.0), second=(1.0, 90.0))
    joints = solve(linked(tip, axis), kinematics, LOW, HIGH, CLEARANCE)
    (uncut,) = (f for f in joints.findings if f.code == "uncut")
    assert uncut.value == pytest.approx(2.0 * 10.0 / 20.0, rel=0.1)
    assert uncut.severity == Severity.WARNING
    whole = solve(linked(tip, axis), kinematics_of("mikron_ucp710", second=(1.0, 90.0)), LOW, HIGH, CLEARANCE)
    assert whole.findings == ()


def test_an_axis_out_of_reach_is_named_with_its_place():
    path = meridian([0, 30, 60])
    with pytest.raises(ReachError, match=r"2 of 5 points .* at \(2, 0, 0\).*max-axis-angle") as caught:
        solve(path, kinematics_of("trunnion_ac", second=(-45.0, 45.0)), LOW, HIGH, CLEARANCE)
    assert caught.value.value == pytest.approx(tuple(path.axis[3]))


def test_a_linear_axis_beyond_its_limits_is_an_error_with_the_worst_value():
    kinematics = kinematics_of("trunnion_ac")
    path = linked([[0, 0, 0], [700.0, 0, 0], [600.0, 0, 0]], [[0, 0, 1.0]] * 3)
    joints = solve(path, kinematics, LOW, HIGH, CLEARANCE)
    (finding,) = joints.findings
    assert (finding.severity, finding.code, finding.unit, finding.block) == (Severity.ERROR, "limit", "mm", 2)
    assert finding.value == pytest.approx(700.0)
    assert finding.limit == pytest.approx(kinematics.high[0])
    assert finding.place == (700.0, 0.0, 0.0)


def test_no_clearance_is_refused():
    with pytest.raises(SettingsError, match="clearance 0"):
        solve(circling(0.1), kinematics_of("trunnion_ac"), LOW, HIGH, 0.0)


def test_an_empty_path_and_a_single_row_are_driven():
    kinematics = kinematics_of("trunnion_ac")
    empty = circling(0.1)
    empty = CLPath(**{n: getattr(empty, n)[:0] for n in CLPath.__dataclass_fields__ if n != "findings"})
    assert solve(empty, kinematics, LOW, HIGH, CLEARANCE).q.shape == (0, 5)
    single = solve(path_of([[1, 2, 3.0]], [[0, 0, 1.0]], [Motion.CUT]), kinematics, LOW, HIGH, CLEARANCE)
    np.testing.assert_allclose(single.q, [[1, 2, 3, 0, 0]], atol=1e-12)
    assert single.path.motion[0] == Motion.RAPID


def test_the_work_can_be_stopped():
    def stop(stage, fraction):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        solve(circling(1), kinematics_of("trunnion_ac"), LOW, HIGH, CLEARANCE, progress=stop)
