# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks divided through the whole pipeline: proven, the surface as it was, feeds right, rapids whole, and
nothing of it when off."""

import json
import shutil
import subprocess
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from plain import PLAIN_WORDS, build_settings
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.base.progress import silent
from freecad_fiveaxis.core.machine.kinematics import forward, q_to_words, words_to_q
from freecad_fiveaxis.core.motion.joint_path import solve
from freecad_fiveaxis.core.motion.program import block_findings, build_program
from freecad_fiveaxis.core.motion.program.feeds import STILL, least_minutes
from freecad_fiveaxis.core.motion.singularity import in_cone
from freecad_fiveaxis.core.nc.writer import write_nc
from freecad_fiveaxis.core.pipeline import options as wanted
from freecad_fiveaxis.core.pipeline.safe_start import start_plane
from freecad_fiveaxis.core.pipeline.settings import flat_options
from freecad_fiveaxis.core.toolpath.cl_path import Motion

ROOT = Path(__file__).parents[2]
CASES = [
    ("dome", "trunnion_ac"),
    ("saddle", "trunnion_ac"),
    ("saddle", "fork_head_bc"),
    ("dome", "nutating_table_b45"),
]


@pytest.fixture(scope="session")
def milled(milled):
    """As everywhere, with wider stepovers."""
    return partial(milled, stepover=8)


def own_rows(divided, whole):
    """The rows of the divided joint path that are those of the undivided one, in order."""
    rows, at = [], 0
    for tip, motion in zip(whole.path.tip, whole.path.motion, strict=True):
        while not ((divided.path.tip[at] == tip).all() and divided.path.motion[at] == motion):
            at += 1
        rows.append(at)
        at += 1
    return np.array(rows)


def walks(outcome, samples, above=0.0):
    """The points (m - 1, samples, 3) mm that stand ``above`` mm over the tip, of every block of a program, by
    plain forward kinematics."""
    q = words_to_q(outcome.program.words)
    u = np.linspace(0.0, 1.0, samples)[None, :, None]
    way = q[:-1, None] + u * np.diff(q, axis=0)[:, None]
    tip, axis = forward(outcome.kinematics, way.reshape(-1, 5))
    return (tip + above * axis).reshape(len(way), samples, 3)


@pytest.mark.parametrize(("part", "machine"), CASES)
def test_every_feed_block_is_proven_within_tolerance(part, machine, milled):
    before, result = milled(part, machine), milled(part, machine, linearize="on")
    feed = result.draft.program.motion != Motion.RAPID
    assert before.surface.bound[before.draft.program.motion != Motion.RAPID].max() > 0.1
    assert result.surface.bound[feed].max() <= 0.01
    codes = {finding.code for finding in result.findings}
    assert "linearized" in codes
    assert not codes & {
        "deviation-over-tolerance",
        "bound-over-tolerance",
        "linearize-rounding",
        "linearize-impossible",
    }


@pytest.mark.parametrize(("part", "machine"), CASES)
def test_the_real_centre_stays_by_the_commanded_segments_of_the_undivided_path(part, machine, milled):
    """201 points of every block of the rounded words, against the segments of the ball's centre along the CL
    path."""
    whole, outcome = milled(part, machine).draft.joints, milled(part, machine, linearize="on").draft
    end = np.searchsorted(
        own_rows(outcome.joints, whole), outcome.program.row[1:]
    )  # the undivided row that each block leads to
    radius = outcome.settings.cutter.cutter.radius
    centre = whole.path.tip + radius * whole.path.axis
    start = centre[end - 1][:, None]
    chord = centre[end][:, None] - start
    way = walks(outcome, 201, radius) - start
    share = np.clip((way * chord).sum(2) / np.maximum((chord**2).sum(2), 1e-30), 0.0, 1.0)
    far = np.linalg.norm(way - share[:, :, None] * chord, axis=2).max(1)
    assert far[outcome.program.motion[1:] != Motion.RAPID].max() <= 0.01


@pytest.mark.parametrize(("part", "machine"), CASES)
def test_contacts_tips_and_axes_are_those_of_the_undivided_path(part, machine, milled):
    whole, divided = milled(part, machine).draft.joints, milled(part, machine, linearize="on").draft.joints
    own = own_rows(divided, whole)
    for name in ("contact", "normal", "tip", "axis", "motion", "feed", "face", "coedge", "pass_"):
        assert (getattr(divided.path, name)[own] == getattr(whole.path, name)).all()
    inserted = np.setdiff1d(np.arange(len(divided.row)), own)
    inserted = inserted[divided.path.motion[inserted] < Motion.LINK]
    end = np.searchsorted(own, inserted)
    start, stop, between = (
        whole.path.contact[end - 1],
        whole.path.contact[end],
        divided.path.contact[inserted],
    )
    detour = (
        np.linalg.norm(between - start, axis=1)
        + np.linalg.norm(stop - between, axis=1)
        - np.linalg.norm(stop - start, axis=1)
    )
    assert np.abs(detour).max(initial=0.0) < 1e-9


@pytest.mark.parametrize(("part", "machine"), CASES)
def test_rapids_are_never_divided(part, machine, milled):
    whole, divided = milled(part, machine).draft.program, milled(part, machine, linearize="on").draft.program
    rapid, rapid_too = whole.motion == Motion.RAPID, divided.motion == Motion.RAPID
    assert len(divided.words) > len(whole.words)
    assert rapid.sum() == rapid_too.sum()
    assert (
        np.abs(whole.words[rapid] - divided.words[rapid_too]).max() < 5e-3
    )  # linear words make up for rounded rotary ones


@pytest.mark.parametrize("mode", ["g93", "g94"])
def test_the_tip_keeps_the_programmed_feed_over_the_part_in_divided_blocks(mode, milled):
    """The length of a densely sampled path over the time by the F word, wherever no axis is at its limit."""
    outcome = milled("saddle", "trunnion_ac", linearize="on", feed_mode=mode).draft
    program, path = outcome.program, outcome.joints.path
    points = walks(outcome, 129)
    length = np.linalg.norm(np.diff(points, axis=1), axis=2).sum(1)
    fed = program.motion[1:] != Motion.RAPID
    if mode == "g93":
        minutes = 1.0 / np.where(fed, program.feed[1:], 1.0)
    else:  # LinuxCNC: F counts along X Y Z where any of them moves
        moved = np.diff(program.words, axis=0)
        linear = np.linalg.norm(moved[:, :3], axis=1)
        minutes = np.where(linear > 0.0, linear, np.linalg.norm(moved[:, 3:], axis=1)) / np.where(
            fed, program.feed[1:], 1.0
        )
    least = least_minutes(outcome.kinematics.rate, np.diff(words_to_q(program.words), axis=0))
    wanted = path.feed[program.row[1:]]
    free = fed & (length > 0.05) & (least < 0.99 * length / np.where(fed, wanted, 1.0))
    inserted = np.diff(outcome.joints.path.tip[program.row] @ np.ones(3)) != 0.0
    assert (free & inserted).sum() > 500
    assert np.abs(length[free] / minutes[free] / wanted[free] - 1.0).max() < 3e-3
    moving = fed & (length > 10.0 * STILL)
    assert (length[moving] / minutes[moving] <= wanted[moving] * 1.003).all()
    assert (minutes[fed] >= least[fed] * (1.0 - 1e-6)).all()


@pytest.mark.rs274
@pytest.mark.skipif(shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed")
@pytest.mark.parametrize("mode", ["g93", "g94"])
@pytest.mark.parametrize(("part", "machine"), CASES)
def test_linuxcnc_accepts_divided_programs(part, machine, mode, milled, tmp_path):
    (tmp_path / "part.ngc").write_bytes(milled(part, machine, linearize="on", feed_mode=mode).draft.nc)
    done = subprocess.run(
        ["rs274", "-g", "part.ngc"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr[-400:]


@some_in_core(("part", "machine"), CASES, kept=(2,))
def test_off_is_the_pipeline_without_it_byte_for_byte(part, machine, milled):
    outcome = milled(part, machine).draft
    assert milled(part, machine, linearize="off", singularity="report").draft.nc == outcome.nc
    settings = outcome.settings
    bare = solve(
        outcome.path,
        outcome.kinematics,
        *outcome.mesh.box,
        settings.links.clearance,
        settings.cutter.cutter.radius,
    )
    program = build_program(bare, outcome.kinematics, outcome.dialect, True)
    height, _ = start_plane(outcome.context(silent), program)
    title, options = wanted.nc_title(settings, outcome.machine), wanted.post_options(settings)
    assert write_nc(program, outcome.dialect, title, options, height=height) == outcome.nc
    assert milled(part, machine, linearize="on").draft.nc != outcome.nc


@some_in_core("machine", ["trunnion_ac", "fork_head_bc"], kept=(1,))
def test_at_the_pole_only_blocks_that_pass_the_cone_are_divided(machine, milled):
    result, whole = milled("saddle", machine, singularity="linearize"), milled("saddle", machine).draft
    outcome = result.draft
    near = in_cone(outcome.kinematics, q_to_words(whole.joints.q), outcome.machine.singular_cone)
    pieces = np.diff(own_rows(outcome.joints, whole.joints), prepend=-1)
    assert (pieces[~near] == 1).all()
    assert (pieces[near] > 1).any()
    end = np.searchsorted(own_rows(outcome.joints, whole.joints), outcome.program.row)
    fed = outcome.program.motion != Motion.RAPID
    assert result.surface.bound[fed & near[end]].max() <= 0.01
    assert result.surface.bound[fed & ~near[end]].max() > 0.1  # the rest is only reported
    both = milled("saddle", machine, singularity="linearize", linearize="on")
    assert both.draft.nc == milled("saddle", machine, linearize="on").draft.nc


def test_what_rounding_makes_impossible_is_named_with_its_block_its_line_and_what_is_held(milled):
    result = milled("dome", "trunnion_ac", linearize="on", tolerance=5e-5)
    program = result.draft.program
    (finding,) = (finding for finding in result.findings if finding.code == "linearize-rounding")
    assert finding.severity is Severity.WARNING and finding.limit == 5e-5 and 5e-5 < finding.value < 3e-4
    assert finding.line == program.line[finding.block]
    assert (
        np.linalg.norm(
            forward(result.draft.kinematics, words_to_q(program.words[[finding.block]]))[0] - finding.place
        )
        < 1e-9
    )
    feed = program.motion != Motion.RAPID
    assert result.surface.bound[feed].max() <= finding.value
    text = f"X{finding.place[0]:.3f} Y{finding.place[1]:.3f} Z{finding.place[2]:.3f}"
    assert text in finding.text and f"{finding.value:.3g} mm" in finding.text


def test_findings_of_the_joint_path_come_to_their_blocks_and_lines(milled):
    outcome = milled("saddle", "trunnion_ac", linearize="on").draft
    row = int(outcome.program.row[100])
    joints = replace(
        outcome.joints,
        q=np.insert(outcome.joints.q, row, outcome.joints.q[row], axis=0)[: len(outcome.joints.q)],
    )
    program = build_program(
        joints, outcome.kinematics, outcome.dialect, True
    )  # row + 1 has the words of row, and no block
    given = [Finding(Severity.NOTE, "x", "", block=at) for at in (row, row + 1, row + 2)] + [
        Finding(Severity.NOTE, "x", "")
    ]
    reported = block_findings(tuple(given), program)
    assert [finding.block for finding in reported] == [100, 100, 101, None]
    assert [finding.line for finding in reported] == [int(program.line[100])] * 2 + [
        int(program.line[101]),
        None,
    ]


def run(*words):
    return cli.main([str(word) for word in words])


@pytest.mark.thorough
def test_post_of_the_cl_file_and_the_job_file_give_the_same_divided_program(parts, tmp_path):
    words = ("--machine", "trunnion_ac", "--linearize", "on", "--quiet")
    part = parts / "saddle.stl"
    out = [tmp_path / f"{name}.ngc" for name in "abc"]
    report = tmp_path / "a.json"
    assert (
        run(
            "mill",
            part,
            "--stepover",
            24,
            *PLAIN_WORDS,
            *words,
            "-o",
            out[0],
            "--cl",
            tmp_path / "a.apt",
            "--report",
            report,
        )
        == cli.DONE
    )
    assert run("post", tmp_path / "a.apt", *words, "-o", out[1]) == cli.DONE
    inputs = json.loads(report.read_text())["inputs"]
    assert inputs["linearize"] == "on" and inputs["singularity"] == "report" and inputs["tolerance"] == 0.01
    (tmp_path / "job.json").write_text(json.dumps(inputs | {"output": str(out[2])}))
    assert run("run", tmp_path / "job.json", "--quiet") == cli.DONE
    assert out[0].read_bytes() == out[2].read_bytes()
    assert json.loads(report.read_text())["summary"]["over_tolerance"] == 0
    blocks = [path.read_bytes().count(b"\n") for path in out]
    assert blocks[0] == pytest.approx(blocks[1], abs=12)  # the CL file rounds its numbers
    assert (
        run(
            "mill",
            part,
            "--stepover",
            24,
            *PLAIN_WORDS,
            *words[:2],
            "--linearize",
            "off",
            "--quiet",
            "-o",
            out[1],
        )
        == cli.DONE_WITH_ERRORS
    )


def test_mill_and_post_divide_unless_requested_not_to_or_the_controller_guides_the_tip():
    for task in ("mill", "post"):
        flat = flat_options(build_settings(task, "x", {"machine": "trunnion_ac"}))
        assert (flat["linearize"], flat["singularity"]) == ("on", "report")
        for given in (
            {"linearize": "off"},
            {"rtcp": "angles"},
            {"rtcp": True},
            {"rtcp": "vectors", "linearize": None},
        ):
            assert build_settings(task, "x", {"machine": "trunnion_ac", **given}).cure.linearize == "off"
        with pytest.raises(SettingsError, match="give one"):
            build_settings(task, "x", {"machine": "trunnion_ac", "rtcp": "angles", "linearize": "on"})
    assert "linearize" not in flat_options(build_settings("audit", "x", {"machine": "trunnion_ac"}))
