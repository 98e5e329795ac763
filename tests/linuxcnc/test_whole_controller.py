# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's whole controller, run headless, travels what is predicted here: in joints, and with its own tool
centre point control.

The tip comes from the joints that the controller commands in every servo cycle, by the formula of its own
kinematics (written here once more); the prediction comes from the machine that is imported from the very
configuration it runs with.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from controller import LENGTH, TOOL, missing, run_programs, write_configuration

from freecad_fiveaxis.core.controllers import find_dialect
from freecad_fiveaxis.core.machine.importing import import_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.program import Program, build_program
from freecad_fiveaxis.core.nc.head import PostOptions
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.nc.writer import write_nc
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

pytestmark = [pytest.mark.linuxcnc, pytest.mark.skipif(bool(missing()), reason=missing() or "it is here")]

LINUXCNC = find_dialect("linuxcnc")
PINS = {
    "xyzac-trt-kins": {
        "x-rot-point": 3.0,
        "y-rot-point": -5.0,
        "z-rot-point": -40.0,
        "y-offset": 20.0,
        "z-offset": 10.0,
    },
    "xyzbc-trt-kins": {
        "x-rot-point": -2.0,
        "y-rot-point": 4.0,
        "z-rot-point": 25.0,
        "x-offset": -20.0,
        "z-offset": -15.0,
    },
}
JOINT_TOLERANCE, CHORD_TOLERANCE = 1e-4, 1e-3
"""mm, as promised: of the predicted deviations, and of the tip from the chord under tool centre point
control."""
SLOW = 0.01
"""mm or deg that an axis still moves in the last cycle of a block, at most."""
PRINTED = 1e-6
"""The sampler prints six decimals."""


def tip_of(kinematics: str, joints: np.ndarray) -> np.ndarray:
    """P = r + Rz(-C)(d + Rx(-A)(J - r - d)), for B with Ry: tips (n, 3) for joints (n, 5) in mm and
    degrees."""
    pins = PINS[kinematics]
    r = np.array([pins[f"{letter}-rot-point"] for letter in "xyz"])
    d = np.array([pins.get("x-offset", 0.0), pins.get("y-offset", 0.0), pins["z-offset"]])
    tilt, turn = -np.radians(joints[:, 3]), -np.radians(joints[:, 4])
    x, y, z = (joints[:, :3] - r - d).T
    if "ac" in kinematics:
        y, z = np.cos(tilt) * y - np.sin(tilt) * z, np.sin(tilt) * y + np.cos(tilt) * z
    else:
        x, z = np.cos(tilt) * x + np.sin(tilt) * z, -np.sin(tilt) * x + np.cos(tilt) * z
    x, y, z = x + d[0], y + d[1], z + d[2]
    return r + np.stack([np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y, z], axis=1)


def from_segment(point: np.ndarray, start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Distances (n,) of points from the segment."""
    along = np.clip((point - start) @ (end - start) / max((end - start) @ (end - start), 1e-30), 0.0, 1.0)
    return np.linalg.norm(point - start - along[:, None] * (end - start), axis=1)


def peak(values: np.ndarray) -> float:
    """The maximum of a smooth curve between its samples: the parabola through the largest and its
    neighbours."""
    at = int(np.argmax(values))
    if not 0 < at < len(values) - 1:
        return float(values[at])
    before, top, after = values[at - 1 : at + 2]
    bend = before - 2.0 * top + after
    return float(top - (before - after) ** 2 / (8.0 * bend)) if bend < 0.0 else float(top)


def chain_of(kinematics: str, folder: Path, **changed: float) -> Chain:
    """The chain of the machine that is imported from the ring's own configuration."""
    ini = write_configuration(folder, kinematics, {**PINS[kinematics], **changed})
    machine = import_machine(str(ini)).machine
    return chain(machine, Setup(machine.origin))


def some_joints(chain_: Chain, blocks: int = 9, seed: int = 5) -> JointPath:
    """Blocks with every axis moving, the rotary ones up to 40 degrees at a time; each takes 0.7 s or so."""
    random = np.random.default_rng(seed)
    step = random.uniform(-1, 1, (blocks + 1, 5)) * (15, 15, 15, np.radians(30), np.radians(40))
    q = np.cumsum(step, axis=0) * (1, 1, 1, 0.5, 1) + (0, 0, 30, 0, 0)
    tip, axis = forward(chain_, q)
    motion, none = np.full(len(q), Motion.CUT, np.int8), np.full(len(q), -1)
    motion[0] = Motion.RAPID
    feed = np.where(motion == Motion.RAPID, 0.0, 1800.0)
    return JointPath(
        CLPath(tip, axis, motion, feed, tip, axis, none, none, none),
        np.arange(len(q)),
        q,
        np.zeros(len(q), np.int8),
        np.ones(len(q)),
    )


def rtcp_text(program: Program, tip: np.ndarray) -> str:
    """The same poses under the controller's own tool centre point control: the words of X Y Z are the tip in
    the work."""
    lines = [
        "(tool centre point control)",
        *["(head)"] * 7,
        "G21 G17 G40 G80 G90 G61",
        f"T{TOOL} M6",
        f"G43 H{TOOL}",
        "M428",
        "G93",
    ]
    for k, (place, words) in enumerate(zip(tip, program.words, strict=True)):
        numbers = (*place, words[4], words[3])  # our order: C, nearer to the work, comes first
        named = " ".join(
            f"{letter}{number:.6f}" for letter, number in zip(axes_of(program), numbers, strict=True)
        )
        lines.append(f"G0 {named}" if k == 0 else f"G1 {named} F80")
    return "\n".join([*lines, "G94", "M429", "M2", ""])


def axes_of(program: Program) -> str:
    return "XYZ" + program.letters[4] + program.letters[3]


@pytest.fixture(scope="module", params=list(PINS))
def travelled(request, tmp_path_factory):
    """One start of the controller for each kinematics: the joint program, then the same poses with tool
    centre point control."""
    kinematics = request.param
    chain_ = chain_of(kinematics, tmp_path_factory.mktemp("ring"))
    program = build_program(some_joints(chain_), chain_, LINUXCNC, inverse_time=True)
    tip = np.round(forward(chain_, words_to_q(program.words))[0], 6)
    text = write_nc(program, LINUXCNC, "ring", PostOptions(tool=TOOL)).decode()
    rtcp = rtcp_text(program, tip)
    joints, controlled = run_programs(kinematics, PINS[kinematics], [text, rtcp])
    for samples in (joints, controlled):
        samples[:, 3] -= LENGTH  # from the spindle's gauge point to the tip
    return kinematics, chain_, program, joints, controlled, rtcp, tip


def blocks_of(samples: np.ndarray, lines: list[int]) -> list[np.ndarray]:
    """The joints (n, 5) sampled in each of these lines, without the first sample: the interpolator of the
    joints is a cycle behind the line's number, and still ends the block before."""
    found = [samples[samples[:, 0] == line, 1:][1:] for line in lines]
    assert min(map(len, found)) > 100, "too few samples for a comparison"
    return found


def test_a_joint_program_travels_the_deviation_that_is_predicted_for_every_block(travelled) -> None:
    kinematics, chain_, program, samples, *_ = travelled
    predicted = measure(chain_, program.words).segment[1:]
    real = real_deviations(kinematics, program, samples)
    assert predicted.max() > 1.0  # there is something to predict
    assert np.abs(real - predicted).max() < JOINT_TOLERANCE
    again = read_nc(write_nc(program, LINUXCNC, "ring", PostOptions(tool=TOOL)), chain_, LINUXCNC)
    assert np.array_equal(again.words, program.words)


def real_deviations(kinematics: str, program: Program, samples: np.ndarray) -> np.ndarray:
    ends = tip_of(kinematics, program.words[:, [0, 1, 2, 4, 3]])
    blocks = blocks_of(samples, program.line[1:].tolist())
    pairs = zip(blocks, ends[:-1], ends[1:], strict=True)
    return np.array(
        [peak(from_segment(tip_of(kinematics, block), start, end)) for block, start, end in pairs]
    )


def test_the_controller_moves_the_joints_straight_and_ends_where_the_words_say(travelled) -> None:
    _, _, program, samples, *_ = travelled
    words = program.words[:, [0, 1, 2, 4, 3]]
    for block, start, end in zip(
        blocks_of(samples, program.line[1:].tolist()), words[:-1], words[1:], strict=True
    ):
        along = (block - start) @ (end - start) / ((end - start) @ (end - start))
        assert np.abs(block - start - along[:, None] * (end - start)).max() < 2 * PRINTED
        assert np.abs(block[-1] - end).max() < SLOW  # the last cycles of a block under G61 are slow


def test_with_tool_centre_point_control_the_tip_stays_on_the_chord(travelled) -> None:
    kinematics, chain_, program, joints, samples, rtcp, tip = travelled
    first = rtcp.split("\n").index("G93") + 3
    blocks = blocks_of(samples, list(range(first, first + len(tip) - 1)))
    off = [
        from_segment(tip_of(kinematics, block), start, end).max()
        for block, start, end in zip(blocks, tip[:-1], tip[1:], strict=True)
    ]
    assert max(off) < CHORD_TOLERANCE
    for block, start, end in zip(blocks, tip[:-1], tip[1:], strict=True):
        ours = forward(chain_, words_to_q(block[:, [0, 1, 2, 4, 3]]))[0]
        assert from_segment(ours, start, end).max() < CHORD_TOLERANCE  # our chain says the same of its joints
    assert (
        real_deviations(kinematics, program, joints).max() > 1000 * CHORD_TOLERANCE
    )  # joints alone leave it far behind


@pytest.mark.parametrize("wrong", ["z-offset", "z-rot-point"])
def test_an_offset_wrong_by_a_hundredth_of_a_millimetre_would_be_seen(travelled, wrong, tmp_path) -> None:
    kinematics, _, program, samples, *_ = travelled
    others = chain_of(kinematics, tmp_path, **{wrong: PINS[kinematics][wrong] + 0.01})
    predicted = measure(others, program.words).segment[1:]
    assert np.abs(real_deviations(kinematics, program, samples) - predicted).max() > 3 * JOINT_TOLERANCE


def test_a_program_that_the_controller_refuses_is_reported() -> None:
    with pytest.raises(AssertionError, match="the controller says"):
        run_programs("xyzac-trt-kins", PINS["xyzac-trt-kins"], ["G21\nG1 X1 X2 F100\nM2\n"])
