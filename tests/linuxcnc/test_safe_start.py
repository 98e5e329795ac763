# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a posted program begins and ends, on LinuxCNC's whole controller: sampled in every servo cycle, no two
groups of axes move at once, and the tool is above the part, or at the machine's safe Z, before the rotary
axes turn.

One program begins where the last one has left the machine, so the rotary axes stand elsewhere each time.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from controller import LENGTH, TOOL, missing, run_programs, write_configuration
from test_whole_controller import PINS, some_joints

from freecad_fiveaxis.core.machine import SafeStart, save_machine
from freecad_fiveaxis.core.machine.importing import import_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.apt import ClHead, write_apt

pytestmark = [pytest.mark.linuxcnc, pytest.mark.skipif(bool(missing()), reason=missing() or "it is here")]

SAFE_Z, CLEARANCE = 420.0, 5.0
"""mm; the clearance is the settings' own."""
GROUPS = ((0, 1), (2,), (3, 4))
STILL = 1e-3
"""mm and deg in one cycle: an axis creeps by so much to its place while the next one starts (G61: 0.0004 in
one cycle)."""
AT_PLACE = 0.01
"""mm; the last cycles of a block are slow, and the next line's number comes before they end."""
CASES = [
    (SafeStart(), "off"), (SafeStart("machine", SAFE_Z), "off"), (SafeStart(), "angles"), (SafeStart("machine", SAFE_Z), "angles")
]  # fmt: skip


def highest(kinematics: str, box: np.ndarray, joints: np.ndarray) -> np.ndarray:
    """The highest place (n,) of a box (2, 3) of the work, in the machine, while its joints (n, 5) stand so:
    the inverse of the kinematics' formula."""
    pins = PINS[kinematics]
    r = np.array([pins[f"{letter}-rot-point"] for letter in "xyz"])
    d = np.array([pins.get("x-offset", 0.0), pins.get("y-offset", 0.0), pins["z-offset"]])
    tilt, turn = np.radians(joints[:, 3]), np.radians(joints[:, 4])
    corners = np.array(list(product(*box.T))) - r
    x, y, z = (corner[:, None] for corner in corners.T)
    x, y = np.cos(turn) * x - np.sin(turn) * y - d[0], np.sin(turn) * x + np.cos(turn) * y - d[1]
    z = z - d[2]
    up = np.sin(tilt) * y + np.cos(tilt) * z if "ac" in kinematics else np.cos(tilt) * z - np.sin(tilt) * x
    return np.asarray((up + d[2] + r[2]).max(axis=0))


@pytest.fixture(scope="module", params=list(PINS))
def begun(request, tmp_path_factory):
    """One start of the controller for each kinematics, with a program for each case."""
    kinematics, folder = request.param, tmp_path_factory.mktemp("ring")
    machine = import_machine(str(write_configuration(folder, kinematics, PINS[kinematics]))).machine
    result = []
    for k, (start, rtcp) in enumerate(CASES):
        save_machine(replace(machine, safe_start=start), folder / f"{k}.fcm")
        path = some_joints(chain(machine, Setup(machine.origin)), blocks=3, seed=k).path
        (folder / "a.apt").write_bytes(write_apt(path, Cutter(10.0), "ring", head=ClHead(tool=TOOL)))
        given = {"machine": str(folder / f"{k}.fcm"), "rtcp": rtcp, "tool_length": LENGTH}
        result.append((job.make(build_settings("post", str(folder / "a.apt"), given)), path))
    samples = run_programs(kinematics, PINS[kinematics], [posted.nc.decode() for posted, _ in result])
    return kinematics, [
        (start, posted, path, sample)
        for (start, _), (posted, path), sample in zip(CASES, result, samples, strict=True)
    ]


def begin_of(samples: np.ndarray, posted: job.PostedProgram) -> np.ndarray:
    """The samples of the lines up to block 0; line 0 is none: the controller idles."""
    return samples[(samples[:, 0] > 0) & (samples[:, 0] <= posted.program.line[0])]


def moving(samples: np.ndarray) -> np.ndarray:
    """Which groups move in each cycle, (n - 1, 3)."""
    change = np.abs(np.diff(samples[:, 1:], axis=0))
    return np.stack([(change[:, group] > STILL).any(axis=1) for group in GROUPS], axis=1)


def test_z_then_the_rotary_axes_then_x_and_y_then_z_and_never_two_groups_at_once(begun) -> None:
    for _, posted, _, samples in begun[1]:
        head = begin_of(samples, posted)
        groups = moving(head)
        assert (groups.sum(axis=1) <= 1).all()
        order = groups[groups.any(axis=1)].argmax(axis=1)
        order = order[np.append(True, np.diff(order) != 0)].tolist()
        assert order == [1, 2, 0, 1]  # Z, both rotary, X and Y, Z


def test_the_tool_is_above_the_part_or_at_the_safe_z_while_the_rotary_axes_turn(begun) -> None:
    kinematics, cases = begun
    for start, posted, path, samples in cases:
        box = np.array([path.tip[1:].min(axis=0), path.tip[1:].max(axis=0)])
        head = begin_of(samples, posted)
        turning = head[1:][moving(head)[:, 2]]
        assert len(turning) > 50
        if start.z is not None:
            assert np.abs(turning[:, 3] - SAFE_Z).max() < AT_PLACE
        room = turning[:, 3] - LENGTH - highest(kinematics, box, turning[:, 1:])
        assert room.min() >= CLEARANCE - STILL


def test_at_the_end_z_goes_up_alone(begun) -> None:
    for start, posted, _, samples in begun[1]:
        end = samples[samples[:, 0] > posted.program.line[-1]][
            1:
        ]  # the interpolator is a cycle behind the line's number
        groups = moving(end)
        assert groups[:, 1].any() and not groups[:, [0, 2]].any() and (np.diff(end[:, 3]) > -STILL).all()
        if start.z is not None:
            assert abs(end[-1, 3] - SAFE_Z) < AT_PLACE


def test_without_a_safe_start_all_axes_would_move_at_once(begun) -> None:
    """The comparison sees what it is for: in the blocks that cut, they do."""
    for _, posted, _, samples in begun[1]:
        assert (moving(samples[samples[:, 0] > posted.program.line[0]]).sum(axis=1) == 3).any()
