# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool vectors that pass the pole: the rotary words in closed form."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from test_nc_planes import FORK, NARROW, TRUNNION, poses, read

from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program

LEAN = np.arange(-8.6, 9.0, 1.5)
"""Degrees from the pole: it lies between two of them, and on neither."""


def vectors(beside: float = 0.0, lean: np.ndarray = LEAN) -> np.ndarray:
    """Tool axes (n, 3) along a great arc of azimuth 30 deg that passes the pole ``beside`` it, deg."""
    arc = np.column_stack([np.sin(np.radians(lean)), 0.0 * lean, np.cos(np.radians(lean))])
    return np.asarray(Rotation.from_euler("xz", [beside, 30.0], degrees=True).apply(arc))


def program_of(controller: str, axis: np.ndarray, kinematics: Chain = TRUNNION) -> Program:
    head, word, end = {
        "siemens840d": ("G71 G90 G94\nTRAORI\nORIWKS\n", "G1 {} A3={:.7f} B3={:.7f} C3={:.7f} F500", "TRAFOOF\nM30\n"),
        "fanuc": ("G21 G90 G94\nG43.5 H1\n", "G1 {} I{:.7f} J{:.7f} K{:.7f} F500.", "G49\nM30\n"),
        "heidenhain": (
            "BEGIN PGM A MM\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n",
            "LN {} TX{:+.7f} TY{:+.7f} TZ{:+.7f} F500",
            "END PGM A MM\n",
        ),
    }[controller]  # fmt: skip
    lines = (word.format(f"X{k} Y0 Z0", *row) for k, row in enumerate(axis.tolist()))
    return read(head + "\n".join(lines) + f"\n{end}", controller, kinematics)


@pytest.mark.parametrize("kinematics", [TRUNNION, FORK], ids=["trunnion", "fork"])
@pytest.mark.parametrize("controller", ["siemens840d", "fanuc", "heidenhain"])
def test_an_axis_straight_through_the_pole_turns_the_second_axis_alone(
    controller: str, kinematics: Chain
) -> None:
    program = program_of(controller, vectors(), kinematics)
    first, second = np.diff(program.words[:, 3:], axis=0).T
    np.testing.assert_allclose(first, 0.0, atol=1e-3)
    np.testing.assert_allclose(np.abs(second), 1.5, atol=1e-4)
    assert len(set(np.sign(second))) == 1
    np.testing.assert_allclose(poses(program, kinematics)[1], vectors(), atol=1e-6)


def test_where_the_limits_hold_the_second_axis_back_the_first_one_turns_half_a_turn() -> None:
    lean = np.arange(-30.7, 31.0, 1.5)
    program = program_of("siemens840d", vectors(lean=lean), NARROW)
    assert np.degrees(NARROW.high[4]) > program.words[:, 4].max()
    assert np.abs(np.diff(program.words[:, 3])).max() == pytest.approx(180.0, abs=1e-3)
    np.testing.assert_allclose(np.abs(program.words[:, 4]), np.abs(lean), atol=1e-4)


def test_an_axis_that_passes_beside_the_pole_turns_the_first_axis_by_the_arc() -> None:
    """0.5 deg beside it the axis of the control goes on along the arc: C turns by the azimuth from vector to
    vector, A dips to 0.5 deg and keeps its sign."""
    axis = vectors(0.5)
    program = program_of("siemens840d", axis)
    azimuth = np.degrees(np.unwrap(np.arctan2(axis[:, 1], axis[:, 0])))
    np.testing.assert_allclose(np.abs(np.diff(program.words[:, 3])), np.abs(np.diff(azimuth)), atol=1e-3)
    assert len(set(np.sign(program.words[:, 4]))) == 1


@pytest.mark.parametrize(
    ("controller", "text", "line"),
    [
        ("heidenhain", "BEGIN PGM T MM\nL X+0 Y+0 Z+9 A+0 C+0 R0 FMAX\nLN X+5 Y+0 Z+5 TX0.6 TY0 TZ0.8 F500\nEND PGM T MM\n", 3),
        ("heidenhain", "BEGIN PGM T MM\nL X+0 Y+0 Z+9 A+0 C+0 R0 FMAX\nCALL LBL 1\nSTOP M30\nLBL 1\nLN X+5 Y+0 Z+5 TX0.6 TY0 TZ0.8 F500\nLBL 0\nEND PGM T MM\n", 6),
        ("siemens840d", "G710 G90 G17\nG0 X0 Y0 Z9 A0 C0\nG1 X5 A3=0.6 B3=0 C3=0.8 F500\n", 3),
    ],
)  # fmt: skip
def test_vectors_that_nobody_follows_are_named(controller: str, text: str, line: int) -> None:
    program = read(text, controller)
    found = next(one for one in program.findings if one.code == "orientation-not-interpreted")
    assert found.line == line and str(line) in found.text and program.words[-1, 3:].tolist() == [0, 0]
    on, off = {"heidenhain": ("M128", "M129"), "siemens840d": ("TRAORI", "TRAFOOF")}[controller]
    before, cut, behind = text.rpartition("LN" if controller == "heidenhain" else "G1")
    guided = read(f"{before}{on}\n{cut}{behind}{off}\n", controller)
    assert not [one for one in guided.findings if one.code == "orientation-not-interpreted"]
