# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes led past the pole: ten times less on the dome, no pass worse, on every kind of machine, to the
program's words."""

import shutil
import subprocess
from functools import lru_cache

import numpy as np
import pytest
from dome_passes import BOTH_WAYS, MACHINES, dome_passes, least_turn, parts
from plain import build_settings

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces, write_stl
from freecad_fiveaxis.core.machine.kinematics import inverse_axis, joint_words, q_to_words
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.orientation.past_pole import deform_axes, reroute_axes, trade_findings, trade_off
from freecad_fiveaxis.core.orientation.past_pole.drive import drive
from freecad_fiveaxis.core.orientation.past_pole.meridian import angle_between
from freecad_fiveaxis.core.passes import axes_within_limits
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.cl_path import Motion
from freecad_fiveaxis.core.toolpath.coedge import take_path_rows

CHANGE = np.radians(2.0)
QUIET = np.radians(1.0)  # a pass on which C turns less has nothing to be cured


@lru_cache(maxsize=64)
def correct_axes(*args, change=CHANGE, **options):
    offset, axis, kinematics = dome_passes(*args, **dict(options))
    return reroute_axes(offset, axis, kinematics, change)


def turned(offset, words, shortest=1e-6):
    """Peak rate rad/mm and turn rad of the first word on every polyline, in plain words: the second route to
    `figures`."""
    peak, turn = [], []
    for line in range(offset.polyline.max() + 1):
        rows = np.flatnonzero(offset.polyline == line)
        step = np.abs(np.diff(words[rows, 0]))
        length = np.linalg.norm(
            np.diff(offset.point[rows] if offset.fill[rows].any() else offset.centre[rows], axis=0), axis=1
        )
        turn.append(step.sum())
        peak.append((step / np.maximum(length, shortest)).max())
    return np.array(peak), np.array(turn)


def near_pole(offset, axis, kinematics, angle=CHANGE):
    """The polylines of which a row's axis stands within that angle of the pole."""
    tilt = np.linalg.norm(np.cross(axis, kinematics.direction[3]), axis=1)
    return np.array(
        [tilt[offset.polyline == line].min() <= np.sin(angle) for line in range(offset.polyline.max() + 1)]
    )


def short_of_ten(offset, axis, corrected_axis, kinematics):
    """Polylines within 2 deg of the pole on which peak rate or travel of the first word did not fall ten
    times."""
    before, after = (turned(offset, drive(offset, part, kinematics)) for part in (axis, corrected_axis))
    near = near_pole(offset, axis, kinematics) & (before[1] > QUIET)
    assert near.any()
    return np.flatnonzero(near & ((10 * after[0] > before[0]) | (10 * after[1] > before[1])))


@pytest.mark.thorough
@pytest.mark.parametrize("name", BOTH_WAYS)
@pytest.mark.parametrize(("stepover", "direction"), [(0.5, 0.0), (1.0, 0.35), (2.0, np.radians(20.0))])
def test_on_the_dome_c_turns_ten_times_less_and_slower_on_every_pass_within_2_deg_of_the_pole(
    name, stepover, direction
):
    offset, axis, kinematics = dome_passes(name, stepover, direction)
    assert not len(short_of_ten(offset, axis, correct_axes(name, stepover, direction).axis, kinematics))


def test_axes_as_given_would_fail_that():
    offset, axis, kinematics = dome_passes("trunnion_ac", 0.5)
    assert len(short_of_ten(offset, axis, axis, kinematics)) == 5


def test_where_ten_times_is_not_reached_no_way_within_2_deg_reaches_it():
    """Finer passes: of those that only just come within 2 deg some need a turn, whatever way they are led."""
    offset, axis, kinematics = dome_passes("trunnion_ac", 0.25, 0.0)
    found = correct_axes("trunnion_ac", 0.25, 0.0)
    short = short_of_ten(offset, axis, found.axis, kinematics)
    assert 0 < len(short) <= 2
    for line in short:
        assert least_turn(kinematics, axis[offset.polyline == line], CHANGE) > 0.2 * found.before.first[line]
        assert found.after.peak[line] < 0.01 * found.before.peak[line]


@pytest.mark.parametrize(
    ("name", "stepover"), [("trunnion_ac", 0.5), ("nutating_table_b45", 1.0), ("nutating_head", 1.0)]
)
def test_the_turn_left_is_near_the_least_possible(name, stepover):
    """A nutating axis turns C along even through the pole. What more is turned than must be comes from
    keeping to given axes."""
    offset, axis, kinematics = dome_passes(name, stepover)
    found = correct_axes(name, stepover)
    for line in np.flatnonzero(near_pole(offset, axis, kinematics)):
        least = least_turn(kinematics, axis[offset.polyline == line], CHANGE)
        assert least - 0.02 < found.after.first[line] < least + np.radians(15.0)


@pytest.mark.parametrize("name", MACHINES)
def test_no_pass_is_worse_and_the_axis_keeps_to_its_change_the_part_and_the_limits(name):
    offset, axis, kinematics = dome_passes(name)
    found = correct_axes(name)
    assert found.rerouted.any()
    assert angle_between(found.axis, axis).max() <= CHANGE
    np.testing.assert_allclose(np.linalg.norm(found.axis, axis=1), 1, atol=1e-12)
    assert ((found.axis * offset.normal).sum(1) >= -1e-6).all()
    assert axes_within_limits(kinematics, found.axis).all()
    before, after = (turned(offset, drive(offset, part, kinematics)) for part in (axis, found.axis))
    assert (after[0] <= before[0] * (1 + 1e-6) + 1e-6).all() and (after[1] <= before[1] + 1e-6).all()
    np.testing.assert_allclose([found.after.peak, found.after.first], after, rtol=1e-6, atol=1e-9)
    same = np.repeat(~found.rerouted, np.bincount(offset.polyline))
    np.testing.assert_array_equal(found.axis[same], axis[same])


@pytest.mark.parametrize(
    ("name", "times"), [("nutating_table_b45", 100), ("nutating_head", 100), ("mikron_ucp710", 20)]
)
def test_the_peak_rate_falls_on_machines_that_cannot_pass_the_pole_for_nothing(name, times):
    """The mikron leans 30 deg to the other side: no pass goes through, all go around."""
    offset, axis, kinematics = dome_passes(name, 1.0)
    found, near = correct_axes(name, 1.0), near_pole(offset, axis, kinematics)
    assert (found.before.peak[near] > times * found.after.peak[near]).all()


@pytest.mark.parametrize(
    "options", [{"strategy": "step_weighted"}, {"lead": 0.02}, {"tilt": -0.03}, {"order": "one_way"}]
)
def test_any_axes_are_corrected(options):
    offset, axis, kinematics = dome_passes("trunnion_ac", **options)
    found = reroute_axes(offset, axis, kinematics, CHANGE)
    assert found.rerouted.any() and not found.after.worse(found.before)[~found.rerouted].any()
    for line in short_of_ten(offset, axis, found.axis, kinematics):
        assert (
            least_turn(kinematics, axis[offset.polyline == line], CHANGE) > 0.1 * found.before.first[line]
        ), line


def test_a_way_that_the_machine_cannot_drive_as_meant_gives_way_to_one_around():
    """Through the pole the mikron would have to turn C by half a turn at once: lower than given, but no
    cure."""
    found = correct_axes("mikron_ucp710", 1.0, np.radians(45.0), half_width=2.0)
    assert found.rerouted.all() and found.before.peak.max() > 100 * found.after.peak.max()


def test_after_an_odd_number_of_passes_through_the_pole_nothing_else_is_worse_on_a_nutating_axis():
    """On the other branch its C turns further on every pass that follows; so one pass goes around, or the
    machine swaps back."""
    offset, axis, kinematics = dome_passes("nutating_table_b45", 0.5)
    found = correct_axes("nutating_table_b45", 0.5)
    near = near_pole(offset, axis, kinematics)
    assert near.sum() == 5 and found.rerouted[near].all() and not found.after.worse(found.before).any()
    assert (found.after.first[near] < 0.3 * found.before.first[near]).sum() >= 4
    assert (found.before.peak[near] > 4 * found.after.peak[near]).all()


def test_rows_of_one_contact_point_keep_one_axis_between_them():
    offset, axis, _ = dome_passes("trunnion_ac")
    result = correct_axes("trunnion_ac").axis
    one = (np.abs(np.diff(offset.point, axis=0)).max(1) == 0) & (np.abs(np.diff(axis, axis=0)).max(1) == 0)
    assert one.sum() > 1000
    assert np.abs(np.diff(result, axis=0)[one]).max() < 1e-12


def test_axes_that_keep_off_the_pole_are_returned_as_they_are():
    offset, axis, kinematics = dome_passes("trunnion_ac", tilt=0.5)
    for given in (axis, np.repeat([[0.0, 0.0, 1.0]], len(axis), axis=0)):
        result, findings = deform_axes(offset, given, kinematics, CHANGE)
        np.testing.assert_array_equal(result, given)
        assert not findings
    nothing = np.zeros(0, int)
    assert deform_axes(take_path_rows(offset, nothing), axis[nothing], kinematics, CHANGE)[0].shape == (0, 3)


def test_the_findings_say_what_was_corrected_and_what_is_left():
    offset, axis, kinematics = dome_passes("mikron_ucp710")
    found = correct_axes("mikron_ucp710")
    _, findings = deform_axes(offset, axis, kinematics, CHANGE)
    assert [finding.code for finding in findings] == ["axis-led-past-pole"]
    assert findings[0].text.startswith(
        f"{found.rerouted.sum()} passes are turned past the pole: C turns at most"
    )
    assert (
        findings[0].value == pytest.approx(np.degrees(angle_between(found.axis, axis).max()))
        and findings[0].limit == 2.0
    )


@pytest.mark.parametrize("change", [0.0, -0.1, 1e-5, 1.0, np.nan, np.inf])
def test_a_change_out_of_range_is_refused(change):
    offset, axis, kinematics = dome_passes("trunnion_ac")
    with pytest.raises(SettingsError, match=r"give an angle from 0\.01 to 30 deg"):
        deform_axes(offset, axis, kinematics, change)
    with pytest.raises(SettingsError, match="give a length above 0"):
        trade_off(offset, axis, kinematics, [CHANGE], 0.0)


def test_it_says_where_it_stands_and_can_be_stopped():
    offset, axis, kinematics = dome_passes("trunnion_ac")
    message = []
    deform_axes(offset, axis, kinematics, CHANGE, lambda stage, share: message.append((stage, share)))
    assert {stage for stage, _ in message} >= {"leading past the pole", "driving what is led"}
    assert all(0 <= share <= 1 for _, share in message)
    for stop in (0, len(message) // 2, len(message) - 1):
        calls = iter(range(len(message)))

        def cancel(stage, share, calls=calls, stop=stop):
            if next(calls) == stop:
                raise Cancelled("stopped")

        with pytest.raises(Cancelled):
            deform_axes(offset, axis, kinematics, CHANGE, cancel)


def test_the_trade_is_what_each_angle_gives_by_itself():
    offset, axis, kinematics = dome_passes("trunnion_ac", half_width=2.5)
    changes = np.radians([0.5, 1.0, 2.0, 4.0])
    trade = trade_off(offset, axis, kinematics, changes, 0.01, 5.0)
    assert trade.allowed.tolist() == [0.0, *changes] and trade.used[0] == 0.0 and trade.passes[0] == 0
    before = turned(offset, drive(offset, axis, kinematics))
    assert (trade.peak[0], trade.first[0]) == pytest.approx((before[0].max(), before[1].sum()))
    for row, change in enumerate(changes, 1):
        found = reroute_axes(offset, axis, kinematics, change)
        peak, turn = turned(offset, drive(offset, found.axis, kinematics))
        assert (trade.peak[row], trade.first[row]) == pytest.approx((peak.max(), turn.sum()))
        assert trade.passes[row] == found.rerouted.sum() and trade.used[row] <= change
    assert (
        (np.diff(trade.peak) < 0).all()
        and (np.diff(trade.first) < 0).all()
        and (trade.blocks[1:] <= trade.blocks[0]).all()
    )
    heads, rows = trade.table(kinematics.letters)
    assert len(heads) == len(rows[0]) and rows[3][0] == pytest.approx(2.0) and heads[3].startswith("peak C")


def test_the_number_of_blocks_is_an_estimate_that_bisection_of_real_blocks_confirms():
    """Blocks of a pass cut in 1, 2, 3 ... equal parts along the chord until all parts hold the tolerance."""
    offset, axis, kinematics = dome_passes("trunnion_ac", half_width=2.5)
    trade = trade_off(offset, axis, kinematics, [CHANGE], 0.002, 5.0)
    words = drive(offset, axis, kinematics)
    tip = offset.centre - 5.0 * axis
    count = 0
    joined = np.flatnonzero(np.diff(offset.polyline) == 0)
    over = measure(kinematics, q_to_words(joint_words(kinematics, tip, words))).segment[joined + 1] > 0.002
    for row in joined[over]:
        for pieces in range(2, 200):
            u = np.linspace(0, 1, pieces + 1)[:, None]
            part = joint_words(
                kinematics,
                tip[row] + u * (tip[row + 1] - tip[row]),
                words[row] + u * (words[row + 1] - words[row]),
            )
            if measure(kinematics, q_to_words(part)).segment.max() <= 0.002:
                break
        count += pieces
    assert trade.blocks[0] == pytest.approx((~over).sum() + count, rel=0.02)


def test_the_trade_is_reported_in_one_note():
    offset, axis, kinematics = dome_passes("trunnion_ac")
    (note,) = trade_findings(offset, axis, kinematics, CHANGE, 0.01, 5.0)
    assert note.code == "axis-change-trade" and "the 5 passes that come within 2 deg" in note.text
    assert [part in note.text for part in ("as given", "0.5 deg", "1 deg", "2 deg", "4 deg")] == [True] * 5
    assert trade_findings(*dome_passes("trunnion_ac", tilt=0.5), CHANGE, 0.01) == ()


# the whole pipeline


@pytest.fixture(scope="module")
def dome(tmp_path_factory):
    path = tmp_path_factory.mktemp("dome") / "dome.stl"
    write_stl(from_faces(*parts.dome()), path)
    return path


@pytest.fixture(scope="module")
def milled(dome):
    @lru_cache
    def mill(*given):
        options = {"machine": "trunnion_ac", "stepover": 0.5, "max_axis_angle": 60, "tool_length": 100}
        return job.make(build_settings("mill", str(dome), options | dict(given)))

    return mill


def program_figures(result, shortest=1e-3):
    """Peak rate deg/mm and turn deg of C on every pass, from the rounded words; blocks shorter than a
    micrometre, in which rounding is all there is, count as that long."""
    program, path = result.program, result.joints.path
    pass_ = path.pass_[program.row]
    on_part = (program.motion <= Motion.FILL) & (pass_ >= 0)
    step = np.abs(np.diff(program.words[:, 3], prepend=program.words[:1, 3]))
    centre = path.tip[program.row] + 5.0 * path.axis[program.row]
    length = np.linalg.norm(np.diff(centre, axis=0, prepend=centre[:1]), axis=1)
    rate = step / np.maximum(length, shortest)
    return {
        n: (rate[on_part & (pass_ == n)].max(), step[on_part & (pass_ == n)].sum())
        for n in np.unique(pass_[on_part])
    }


@pytest.mark.thorough
def test_the_programs_c_is_ten_times_slower_and_its_contacts_stay_where_they_are(milled):
    plain, cured = milled(), milled(("singularity", "deform"))
    rows = [result.path.pass_ >= 0 for result in (plain, cured)]
    np.testing.assert_allclose(cured.path.contact[rows[1]], plain.path.contact[rows[0]], atol=1e-9, rtol=0)
    centre = [
        Cutter(10.0).radius * result.path.axis[row] + result.path.tip[row]
        for result, row in zip((plain, cured), rows, strict=True)
    ]
    np.testing.assert_allclose(centre[1], centre[0], atol=1e-9, rtol=0)
    tilt = np.degrees(np.arccos(np.clip(plain.path.axis[rows[0], 2], -1, 1)))
    near = np.unique(plain.path.pass_[rows[0]][tilt <= 2.0])
    before, after = program_figures(plain), program_figures(cured)
    assert len(near) == 5
    for n in near:
        assert before[n][0] >= 10 * after[n][0] and before[n][1] >= 10 * after[n][1]
    assert all(after[n][1] <= before[n][1] + 0.01 for n in before)
    assert {finding.code for finding in cured.findings} >= {"axis-led-past-pole", "axis-change-trade"}


def test_report_is_the_default_and_changes_no_byte(milled):
    wide = ("stepover", 8.0)
    assert (
        milled(wide, ("singularity", "report")).nc
        == milled(wide).nc
        != milled(wide, ("singularity", "deform")).nc
    )
    assert milled(wide, ("singularity", "report"), ("max_axis_change", 5)).nc == milled(wide).nc


def test_a_driven_centre_runs_the_same_way_with_other_axes(milled):
    given = ("stepover", 5.0), ("control_point", "centre")
    plain, cured = (milled(*given, ("singularity", kind)) for kind in ("report", "deform"))
    rows = [result.path.pass_ >= 0 for result in (plain, cured)]
    np.testing.assert_allclose(cured.path.tip[rows[1]], plain.path.tip[rows[0]], atol=1e-9, rtol=0)
    assert np.abs(cured.path.axis[rows[1]] - plain.path.axis[rows[0]]).max() > 0.01


@pytest.mark.rs274
@pytest.mark.skipif(shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed")
def test_linuxcnc_accepts_the_program(milled, tmp_path):
    (tmp_path / "dome.ngc").write_bytes(milled(("singularity", "deform")).nc)
    done = subprocess.run(
        ["rs274", "-g", "dome.ngc"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr[-400:]


@pytest.mark.parametrize(
    ("options", "message"),
    [(["--singularity", "bend"], "'report', 'linearize', 'deform'"), (["--max-axis-change", "40"], "40 is out of range; it must be at least 0.01 deg"),
     (["--max-axis-change", "0"], "0 is out of range; it must be at least 0.01 deg and at most 30 deg"),
     (["--max-axis-change", "nan"], "nan")],
)  # fmt: skip
def test_bad_values_end_with_2_and_are_named_with_a_remedy(options, message, dome, tmp_path, capsys):
    target = tmp_path / "out.ngc"
    try:
        code = cli.main(["mill", str(dome), "--machine", "trunnion_ac", *options, "-o", str(target)])
    except SystemExit as left:
        code = left.code
    assert code == 2 and message in capsys.readouterr().err.replace(
        "choose from report, linearize, deform", "'report', 'linearize', 'deform'"
    )
    assert not target.exists()


def test_a_cl_file_keeps_its_axes(tmp_path):
    with pytest.raises(SettingsError, match="singularity deform needs the part's passes"):
        build_settings("post", "a.apt", {"machine": "trunnion_ac", "singularity": "deform"})


def test_corrected_axes_are_within_reach_of_the_machine():
    """The other route to the limits: the inverse of every led axis has a branch within them."""
    offset, _, kinematics = dome_passes("mikron_ucp710")
    second = inverse_axis(kinematics, correct_axes("mikron_ucp710").axis)[0][:, :, 1]
    low, high = kinematics.low[4], kinematics.high[4]
    assert ((second >= low - 1e-9) & (second <= high + 1e-9)).any(0).all()
    assert len(offset.point) == second.shape[1]
