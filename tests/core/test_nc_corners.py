# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rounded and chamfered corners between two lines: against the closed forms; every other corner is an error."""

from __future__ import annotations

import math

import numpy as np
import pytest
from test_nc_cycles import errors, read

HEAD = "G21 G90 G17\nG0 X0 Y0 Z0 A0 C0\n"
CONTROLLER = {"fanuc": "fanuc", "siemens": "siemens840d"}
SIEMENS = "G710 G90 G17\nG0 X0 Y0 Z0 A0 C0\n"


def places(text: str, language: str = "fanuc") -> np.ndarray:
    program = read((SIEMENS if language == "siemens" else HEAD) + text + "M30\n", CONTROLLER[language])
    assert not errors(program), program.findings
    return program.words[:, :3]


@pytest.mark.parametrize(
    ("word", "language"), [(",R2", "fanuc"), (", R 2.", "fanuc"), ("RND=2", "siemens"), ("RND = 2.0", "siemens")]
)
def test_a_rounded_corner_is_an_arc_tangent_to_both_lines(word: str, language: str) -> None:
    path = places(f"G1 X10 {word} F100\nY10\n", language)
    arc = path[1:-1]
    assert arc[0] == pytest.approx([8, 0, 0]) and arc[-1] == pytest.approx([10, 2, 0]) and path[-1].tolist() == [10, 10, 0]
    assert np.abs(np.hypot(arc[:, 0] - 8, arc[:, 1] - 2) - 2).max() < 1e-9 and len(arc) > 10
    middle = (arc[1:] + arc[:-1]) / 2
    assert np.abs(np.hypot(middle[:, 0] - 8, middle[:, 1] - 2) - 2).max() < 1.1e-3


@pytest.mark.parametrize(("word", "language"), [(",C2", "fanuc"), ("CHR=2", "siemens")])
@pytest.mark.parametrize("turn", [20.0, 90.0, 150.0, -60.0])
def test_a_chamfer_takes_its_leg_of_both_lines(word: str, language: str, turn: float) -> None:
    along = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    path = places(f"G1 X10 {word} F100\nX{10 + 10 * along[0]:.6f} Y{10 * along[1]:.6f}\n", language)
    assert path[1] == pytest.approx([8, 0, 0]) and path[2] == pytest.approx([10 + 2 * along[0], 2 * along[1], 0], abs=1e-5)
    assert len(path) == 4


@pytest.mark.parametrize("turn", [1.0, 30.0, 120.0, 170.0, -45.0])
def test_any_angle_is_rounded_by_the_same_radius(turn: float) -> None:
    along = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    path = places(f"G1 X100 ,R3 F100\nX{100 + 100 * along[0]:.9f} Y{100 * along[1]:.9f}\n")
    leg = 3.0 * math.tan(math.radians(abs(turn)) / 2.0)
    assert path[1] == pytest.approx([100 - leg, 0, 0], abs=1e-6)
    centre = path[1, :2] + (0.0, math.copysign(3.0, turn))
    assert np.abs(np.linalg.norm(path[1:-1, :2] - centre, axis=1) - 3.0).max() < 1e-5


def test_corners_follow_one_another_in_any_plane_and_in_steps() -> None:
    path = places("G18 G91\nG1 X10 ,R2 F100\nZ10 ,C3\nG90 X0\n")
    assert [path[1].tolist(), path[-3].tolist(), path[-2].tolist(), path[-1].tolist()] == [
        [8, 0, 0], [10, 0, 7], [7, 0, 10], [0, 0, 10],
    ]  # fmt: skip
    assert places("G1 X10 ,R2 F100\nX20\n")[:, 0].tolist() == [0, 10, 20]


@pytest.mark.parametrize(
    "text",
    [
        "G1 X10 ,R2 F100\nG2 X12 Y2 R2\n", "G1 X10 ,R2 F100\nG0 Y10\n", "G1 X10 ,R2 F100\nY10 Z1\n", "G1 X10 ,R2 F100\nY1\n",
        "G1 X10 ,R6 F100\nY10 ,R6\nX0\n", "G1 X10 ,R2 F100\nX0\n", "G1 X10 ,C2 F100\n", "G1 X10 ,C2 F100\nY5 A10\n",
    ],
)  # fmt: skip
def test_any_other_corner_is_an_error_with_its_line(text: str) -> None:
    program = read(HEAD + text + "M30\n", "fanuc")
    (found,) = [one for one in program.findings if one.code == "corner-not-interpreted"]
    assert found.line == (4 if "R6" in text else 3)


def test_what_is_no_plain_number_is_refused_or_an_error() -> None:
    assert "corner-not-interpreted" in errors(read(SIEMENS + "G1 X10 CHF=2 F100\nY10\nM30\n", "siemens840d"))
    assert "corner-not-interpreted" in errors(read(SIEMENS + "G1 X10 RNDM=2 F100\nY10\nM30\n", "siemens840d"))
