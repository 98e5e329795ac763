# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programmed frames of Siemens 840D that are turned: by hand, on the axes and on a guided tip."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import errors, path, read
from test_nc_planes import read as read_on

from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, words_to_q

HEAD = "G71 G90 G94 F100\nG0 X0 Y0 Z20 A0 C0\n"
HALF, COSINE = 0.5, float(np.cos(np.pi / 6))


@pytest.mark.parametrize(
    ("frame", "ends"),
    [
        ("ROT Z90", (0, 10, 5)), ("AROT Z90\nAROT X90", (5, 10, 0)), ("ROT X90 Z90", (5, 10, 0)), ("ROT Z90\nROT X90", (10, -5, 0)),
        ("TRANS X1\nAROT Z90", (1, 10, 5)), ("TRANS X1\nROT Z90", (0, 10, 5)), ("ROT Z90\nATRANS X1", (0, 11, 5)),
        ("ROT Z90\nTRANS X1", (11, 0, 5)), ("ROT Z90\nTRANS", (10, 0, 5)), ("ROT Z90\nROT", (10, 0, 5)),
        ("G18\nROT RPL=90\nG17", (5, 0, -10)), ("ROT RPL=30", (10 * COSINE, 10 * HALF, 5)), ("ROT Y90\nTRANS X0 Y0 Z0", (10, 0, 5)),
    ],
)  # fmt: skip
def test_frames_turn_coordinates_in_the_order_of_the_manual(frame: str, ends: tuple[float, ...]) -> None:
    program = read(f"{HEAD}{frame}\nG1 X10 Y0 Z5\n", "siemens840d")
    assert not errors(program), program.findings
    np.testing.assert_allclose(program.words[-1, :3], ends, atol=1e-9)


def test_inches_arcs_and_steps_stand_in_a_frame() -> None:
    assert path(read(HEAD + "G70\nROT Z90\nATRANS X1\nG1 X1 Y0 Z0\n", "siemens840d"))[-1] == "f 0 50.8 0"
    assert path(read(HEAD + "ROT Z90\nG1 X10 Y0\nG91 X1\n", "siemens840d"))[-1] == "f 0 11 20"
    program = read(HEAD + "ROT X90\nG1 X10 Y0 Z0\nG3 X-10 Y0 I-10 J0\n", "siemens840d")
    np.testing.assert_allclose(np.hypot(program.words[2:, 0], program.words[2:, 2]), 10.0, atol=1e-9)
    assert program.words[:, 2].max() == pytest.approx(20.0) and not errors(program)


@pytest.mark.parametrize(("angle", "opposite"), [(90, False), (-90, True), (0, False)])
def test_a_tool_that_points_against_the_normal_of_its_frame_is_noticed(angle: float, opposite: bool) -> None:
    """AROT X90 turns Z to -Y; on trunnion_ac the tool lies there at A90."""
    kinematics = chain(load_machine("trunnion_ac"), Setup())
    words = np.zeros((1, 5))
    words[0, kinematics.letters.index("A")] = angle
    assert (forward(kinematics, words_to_q(words))[1][0] @ (0.0, -1.0, 0.0) < -0.999) == opposite
    moved = f"TRAORI\nG0 A{angle} C0\nAROT X90\nG1 X10 Y2 Z5\nTRAFOOF\n"
    found = [one for one in read_on(HEAD + moved, "siemens840d").findings if one.code == "plane-not-taken"]
    assert [one.severity.name for one in found] == ["WARNING"] * opposite
    assert all("against the normal" in one.text for one in found)


def test_a_guided_tip_and_its_vectors_stand_in_a_frame() -> None:
    moved = "TRAORI\nG0 A90 C90\n{}G1 X10 Y2 Z5 {}\nTRAFOOF\n"
    turned = read_on(HEAD + moved.format("AROT Z90\nAROT X90\n", ""), "siemens840d")
    plain = read_on(HEAD + moved.format("", "").replace("X10 Y2 Z5", "X5 Y10 Z2"), "siemens840d")
    assert not errors(turned) and turned.guided is not None and plain.guided is not None
    np.testing.assert_allclose(turned.words[-1], plain.words[-1], atol=1e-9)
    vector = read_on(HEAD + moved.format("AROT X90\n", "A3=0 B3=0 C3=1"), "siemens840d")
    straight = read_on(
        HEAD + moved.format("", "A3=0 B3=-1 C3=0").replace("X10 Y2 Z5", "X10 Y-5 Z2"), "siemens840d"
    )
    np.testing.assert_allclose(vector.words[-1], straight.words[-1], atol=1e-9)
    assert abs(vector.words[-1, 4]) > 1.0  # it would be 0 were the vector not turned
