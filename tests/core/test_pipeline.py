# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole pipeline on real parts: what is posted, read again and sent through forward kinematics is the CL
path."""

import shutil
import subprocess
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from bare_machines import BARE
from plain import build_settings

from freecad_fiveaxis.core.machine import load_machine, save_machine
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.toolpath.cl_path import Motion

ROOT = Path(__file__).parents[2]
PARTS = ("dome", "blade", "saddle", "half_cylinder", "freeform_233")


def largest_miss(result):
    """Distance mm of the re-read, forwarded words from the driven CL path, and angle rad of the axes."""
    read = read_nc(result.draft.nc, result.draft.kinematics, result.draft.dialect)
    own = np.isin(
        read.line, result.draft.program.line
    )  # a plane above the part is one row before them, and one after
    assert (~own).sum() == (
        2 if load_machine(result.draft.settings.machine.machine).safe_start.retract == "clearance" else 0
    )
    np.testing.assert_allclose(read.words[own], result.draft.program.words, atol=1e-9)
    np.testing.assert_array_equal(read.line[own], result.draft.program.line)
    tip, axis = forward(result.draft.kinematics, words_to_q(read.words[own]))
    path, row = result.draft.joints.path, result.draft.program.row
    return np.linalg.norm(tip - path.tip[row], axis=1).max(), np.linalg.norm(
        axis - path.axis[row], axis=1
    ).max()


def rounding(result):
    """What half a step of every word can move the tip (mm) and the axis (rad): lever arms are below 500 mm
    here."""
    linear, angle = 0.5e-4 * np.sqrt(3), 2 * np.radians(0.5e-4)
    return linear + 500 * angle, angle


@pytest.mark.parametrize("machine", BARE)
def test_posted_words_read_again_are_the_cl_path(machine, milled):
    result = milled("dome", machine)
    miss, allowed = largest_miss(result), rounding(result)
    assert miss[0] < allowed[0] and miss[1] < allowed[1]


@pytest.mark.thorough
@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize("controller", ["linuxcnc", "fanuc"])
def test_every_part_comes_back_through_every_controller(part, controller, milled):
    result = milled(part, "trunnion_ac", controller)
    miss, allowed = largest_miss(result), rounding(result)
    assert miss[0] < allowed[0] and miss[1] < allowed[1]


def test_a_wrong_sign_would_be_noticed(milled):
    result = milled("dome", "trunnion_ac")
    words = result.draft.program.words * (1, 1, 1, 1, -1)
    tip, _ = forward(result.draft.kinematics, words_to_q(words))
    assert np.linalg.norm(tip - result.draft.joints.path.tip[result.draft.program.row], axis=1).max() > 1.0


@pytest.mark.parametrize("machine", BARE)
def test_the_deviation_of_the_program_is_that_of_a_dense_walk(machine, milled):
    """A random share of the blocks, 2001 points each, distance to the segment by hand; never above the
    bound."""
    result = milled("dome", machine)
    words, rng = result.draft.program.words, np.random.default_rng(5)
    block = rng.choice(np.arange(1, len(words)), min(400, len(words) - 1), replace=False)
    u = np.linspace(0, 1, 2001)
    q = words_to_q(words)
    for b in block:  # plain on purpose: the second route shares nothing with the first
        tip, _ = forward(result.draft.kinematics, q[b - 1] + u[:, None] * (q[b] - q[b - 1]))
        chord = tip[-1] - tip[0]
        k = np.clip((tip - tip[0]) @ chord / max(chord @ chord, 1e-30), 0, 1)
        dense = np.linalg.norm(tip - tip[0] - k[:, None] * chord, axis=1).max()
        got, bound = result.deviation.segment[b], result.deviation.bound[b]
        assert dense - 1e-9 <= bound <= got + max(1e-4, 0.01 * got)
        assert got == pytest.approx(dense, rel=1e-5, abs=1e-6)


def test_the_dome_passes_the_pole(milled):
    result = milled("dome", "trunnion_ac")
    assert result.singularity.singular.any()
    assert {finding.code for finding in result.findings} >= {"singular-block", "deviation-over-tolerance"}


def least_ball_clearance(outcome, radius):
    """How near the ball comes to the part's box on rapids, mm, along their real path: 101 points a block."""
    low, high = outcome.mesh.vertex.min(axis=0), outcome.mesh.vertex.max(axis=0)
    q, rapid = words_to_q(outcome.program.words), outcome.program.motion == Motion.RAPID
    end = np.flatnonzero(rapid)[1:]
    u = np.linspace(0, 1, 101)[None, :, None]
    walk = q[end - 1][:, None] * (1 - u) + q[end][:, None] * u
    tip, axis = forward(outcome.kinematics, walk.reshape(-1, 5))
    centre = tip + radius * axis
    return np.linalg.norm(np.maximum(0, np.maximum(low - centre, centre - high)), axis=1).min() - radius


@pytest.mark.parametrize("machine", BARE)
def test_the_ball_keeps_its_clearance_on_rapids(machine, milled):
    assert least_ball_clearance(milled("dome", machine).draft, 5.0) > 5.0


@pytest.mark.thorough
def test_a_narrow_first_axis_never_swings_the_ball_beside_the_part(parts, tmp_path):
    """C of 180 deg in all forces flips of A by 180 deg between passes: they belong above the part."""
    machine = load_machine("trunnion_ac")
    narrow = [
        replace(axis, low=-np.pi / 2, high=np.pi / 2) if axis.letter == "C" else axis for axis in machine.axes
    ]
    save_machine(replace(machine, axes=tuple(narrow)), tmp_path / "narrow.fcm")
    options = {"machine": str(tmp_path / "narrow.fcm"), "cutter": "ball:30", "stepover": 6, "direction": 30}
    for part in ("half_cylinder", "dome"):
        outcome = job.make(build_settings("mill", str(parts / f"{part}.stl"), options))
        assert np.ptp(outcome.program.words[:, 3]) <= 180.0 and np.ptp(outcome.program.words[:, 4]) > 100.0
        assert least_ball_clearance(outcome, 15.0) > 5.0


@pytest.mark.rs274
@pytest.mark.skipif(shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed")
@pytest.mark.parametrize("mode", ["g93", "g94"])
@pytest.mark.parametrize("machine", BARE)
def test_linuxcnc_accepts_every_program(machine, mode, milled, tmp_path):
    (tmp_path / "dome.ngc").write_bytes(milled("dome", machine, feed_mode=mode).draft.nc)
    done = subprocess.run(
        ["rs274", "-g", "dome.ngc"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr[-400:]


@pytest.mark.rs274
@pytest.mark.skipif(shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed")
def test_linuxcnc_would_refuse_a_broken_program(milled, tmp_path):
    text = milled("dome", "trunnion_ac").draft.nc.replace(b"G1 X", b"G1 X1 X", 1)
    (tmp_path / "dome.ngc").write_bytes(text)
    done = subprocess.run(
        ["rs274", "-g", "dome.ngc"], cwd=tmp_path, capture_output=True, stdin=subprocess.DEVNULL, timeout=120
    )
    assert done.returncode != 0
