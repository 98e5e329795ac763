# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rounded and chamfered corners of lines and arcs: against the closed forms; every other corner is an
error."""

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
    ("word", "language"),
    [(",R2", "fanuc"), (", R 2.", "fanuc"), ("RND=2", "siemens"), ("RND = 2.0", "siemens")],
)
def test_a_rounded_corner_is_an_arc_tangent_to_both_lines(word: str, language: str) -> None:
    path = places(f"G1 X10 {word} F100\nY10\n", language)
    arc = path[1:-1]
    assert (
        arc[0] == pytest.approx([8, 0, 0])
        and arc[-1] == pytest.approx([10, 2, 0])
        and path[-1].tolist() == [10, 10, 0]
    )
    assert np.abs(np.hypot(arc[:, 0] - 8, arc[:, 1] - 2) - 2).max() < 1e-9 and len(arc) > 10
    middle = (arc[1:] + arc[:-1]) / 2
    assert np.abs(np.hypot(middle[:, 0] - 8, middle[:, 1] - 2) - 2).max() < 1.1e-3


@pytest.mark.parametrize(("word", "language"), [(",C2", "fanuc"), ("CHR=2", "siemens")])
@pytest.mark.parametrize("turn", [20.0, 90.0, 150.0, -60.0])
def test_a_chamfer_takes_its_leg_of_both_lines(word: str, language: str, turn: float) -> None:
    along = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    path = places(f"G1 X10 {word} F100\nX{10 + 10 * along[0]:.6f} Y{10 * along[1]:.6f}\n", language)
    assert path[1] == pytest.approx([8, 0, 0]) and path[2] == pytest.approx(
        [10 + 2 * along[0], 2 * along[1], 0], abs=1e-5
    )
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
        "G1 X10 ,C2 F100\nG2 X12 Y2 R2\n", "G1 X1 ,R9 F100\nG2 X3 Y2 R2\n", "G1 X10 ,R2 F100\nG0 Y10\n", "G1 X10 ,R2 F100\nY10 Z1\n", "G1 X10 ,R2 F100\nY1\n",
        "G1 X10 ,R6 F100\nY10 ,R6\nX0\n", "G1 X10 ,R2 F100\nX0\n", "G1 X10 ,C2 F100\n", "G1 X10 ,C2 F100\nY5 A10\n",
    ],
)  # fmt: skip
def test_any_other_corner_is_an_error_with_its_line(text: str) -> None:
    program = read(HEAD + text + "M30\n", "fanuc")
    (found,) = [one for one in program.findings if one.code == "corner-not-interpreted"]
    assert found.line == (4 if "R6" in text else 3)


def test_what_is_no_plain_number_is_refused_or_an_error() -> None:
    assert "corner-not-interpreted" in errors(
        read(SIEMENS + "G1 X10 CHF=2.5.5 F100\nY10\nM30\n", "siemens840d")
    )
    assert "corner-not-interpreted" in errors(
        read(SIEMENS + "G1 X10 RNDM=2.5.5 F100\nY10\nM30\n", "siemens840d")
    )
    assert "corner-not-interpreted" in errors(
        read(SIEMENS + "G1 X10 RNDM=2000000 F100\nY10\nM30\n", "siemens840d")
    )


CONTOUR = "G1 X20 {0} F100\nY10 {0}\nG3 X0 Y10 I-10 J0 {1}\nG1 Y0 {0}\n"


@pytest.mark.parametrize("scale", ["G710", "G700"])
def test_rounding_of_every_corner_is_that_of_each_of_them(scale: str) -> None:
    """The same words, as RND= in each line; a corner of its own goes before it, RNDM=0 ends it."""
    head = f"{scale} G90 G17\nG0 X0 Y0 Z0 A0 C0\n"
    every = read(head + "RNDM=2\n" + CONTOUR.format("", "RND=1") + "RNDM=0\nX-10\nY-10\nM30\n", "siemens840d")
    each = read(head + CONTOUR.format("RND=2", "RND=1") + "X-10\nY-10\nM30\n", "siemens840d")
    assert not errors(every) and not errors(each)
    assert (every.words == each.words).all() and len(every.words) > 20
    sharp = read(head + CONTOUR.format("", "RND=1") + "X-10\nY-10\nM30\n", "siemens840d")
    assert len(sharp.words) < len(every.words)


def test_rounding_of_every_corner_takes_its_length_off_a_square() -> None:
    path = places("G1 X10 RNDM=2 F100\nY10\nX0\nY0\nX10\n", "siemens")
    length = np.linalg.norm(np.diff(path, axis=0, prepend=0.0), axis=1).sum()
    assert length == pytest.approx(50.0 - 4 * (2 * 2.0 - np.pi), abs=0.01) and length < 50.0 - 4 * (
        2 * 2.0 - np.pi
    )


@pytest.mark.parametrize("text", ["G1 X10 RNDM=2 F100\nZ5\nX0\n", "G1 Z5 RNDM=2 F100\nX10 Y1 Z6\nG0 Z9\n"])
def test_a_corner_that_leaves_the_plane_has_no_rounding_of_every_corner(text: str) -> None:
    """6FC5398: no rounding is inserted where there is no contour in the plane; alone, RND= there stays an
    error."""
    assert places(text, "siemens").tolist() == places(text.replace("RNDM=2", ""), "siemens").tolist()
    assert "corner-not-interpreted" in errors(
        read(SIEMENS + text.replace("RNDM", "RND") + "M30\n", "siemens840d")
    )


@pytest.mark.parametrize("text", ["G1 X10 RNDM=2 F100\nG0 Y10\n", "G1 X10 RNDM=2 F100\nY1\n"])
def test_rounding_of_every_corner_beside_a_rapid_or_a_short_move_is_an_error(text: str) -> None:
    program = read(SIEMENS + text + "M30\n", "siemens840d")
    (found,) = [one for one in program.findings if one.code == "corner-not-interpreted"]
    assert found.line == 3


def rounded(path: np.ndarray, centre: tuple[float, float], radius: float) -> np.ndarray:
    """The places of the rounding about that centre, X Y; all of them lie on it, with no chord too long."""
    arc = path[np.abs(np.hypot(*(path[:, :2] - centre).T) - radius) < 1e-6, :2]
    middle = (arc[1:] + arc[:-1]) / 2
    assert np.abs(np.hypot(*(middle - centre).T) - radius).max() < 1.1e-3
    return arc


@pytest.mark.parametrize(("word", "language"), [(",R2", "fanuc"), ("RND=2", "siemens")])
def test_a_rounding_between_a_line_and_an_arc_is_tangent_to_both(word: str, language: str) -> None:
    path = places(f"G1 X10 {word} F100\nG3 X0 Y10 I-10 J0\n", language)
    centre = (60.0**0.5, 2.0)  # 2 off the line, and 2 within the circle of 10
    arc = rounded(path, centre, 2.0)
    assert (
        arc[0] == pytest.approx([60.0**0.5, 0])
        and arc[-1] == pytest.approx(np.array(centre) * 10 / 8)
        and path[-1].tolist() == [0, 10, 0]
    )
    assert np.abs(np.hypot(path[-20:, 0], path[-20:, 1]) - 10.0).max() < 1e-6


def test_a_rounding_between_an_arc_and_a_line_is_the_same_the_other_way_round() -> None:
    path = places("G1 Y10 F100\nG2 X10 Y0 I0 J-10 ,R2\nG1 X0\n")
    arc = rounded(path, (60.0**0.5, 2.0), 2.0)
    assert arc[-1] == pytest.approx([60.0**0.5, 0]) and arc[0] == pytest.approx(
        np.array([60.0**0.5, 2.0]) * 10 / 8
    )


def test_a_rounding_between_two_arcs_lies_within_one_and_without_the_other() -> None:
    """Up a circle about (5, 0) to its top, and from there up one about (0, 5)."""
    path = places("G2 X5 Y5 I5 J0 F100 ,R1\nG3 X0 Y10 I-5 J0\n")
    centre = np.array([(6 + 92**0.5) / 4, (14 + 92**0.5) / 4])  # 6 from (5, 0), and 4 from (0, 5)
    arc = rounded(path, (float(centre[0]), float(centre[1])), 1.0)
    assert arc[0] == pytest.approx((5, 0) + (centre - (5, 0)) * 5 / 6)
    assert arc[-1] == pytest.approx((0, 5) + (centre - (0, 5)) * 5 / 4) and path[-1].tolist() == [0, 10, 0]
    for part, middle in ((path[: len(path) // 4], (5, 0)), (path[-len(path) // 4 :], (0, 5))):
        assert np.abs(np.hypot(*(part[:, :2] - middle).T) - 5).max() < 1e-6


def test_arcs_that_go_on_in_one_direction_have_no_corner() -> None:
    with_word, without = (places(f"G3 X10 Y0 I5 J0 F100 {word}\nG2 X20 Y0 I5 J0\n") for word in (",R1", ""))
    np.testing.assert_allclose(with_word, without, atol=1e-9)


def test_corners_at_both_ends_of_an_arc_leave_its_middle() -> None:
    path = places("G1 X10 ,R1 F100\nG3 X0 Y10 I-10 J0 ,R1\nG1 Y0\n")
    rounded(path, (80.0**0.5, 1.0), 1.0)
    rounded(path, (1.0, 80.0**0.5), 1.0)
    on_circle = np.abs(np.hypot(path[:, 0], path[:, 1]) - 10.0) < 1e-6
    assert on_circle.sum() > 20 and path[-1].tolist() == [0, 0, 0]


def test_a_chamfer_by_its_own_length_is_so_long() -> None:
    for turn in (20.0, 90.0, -60.0):
        along = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        path = places(f"G1 X10 CHF=2 F100\nX{10 + 10 * along[0]:.6f} Y{10 * along[1]:.6f}\n", "siemens")
        assert len(path) == 4 and np.linalg.norm(path[2] - path[1]) == pytest.approx(2.0)
        assert 10 - path[1, 0] == pytest.approx(np.linalg.norm(path[2] - (10, 0, 0)), abs=1e-5)


@pytest.mark.parametrize(
    ("word", "language"),
    [(",A30.", "fanuc"), (", A +30.", "fanuc"), ("ANG=30", "siemens"), ("ANG = 390.0", "siemens")],
)
def test_a_line_by_its_angle_and_one_coordinate_ends_on_it(word: str, language: str) -> None:
    tan = math.tan(math.radians(30))
    assert places(f"G1 X10 {word} F100\n", language)[-1] == pytest.approx([10, 10 * tan, 0])
    assert places(f"G1 Y3 {word} F100\n", language)[-1] == pytest.approx([3 / tan, 3, 0])
    assert places(f"G1 X2 Y1 F100\nG91 X10 {word}\nG90 Y9\n", language)[-2:] == pytest.approx(
        np.array([[12, 1 + 10 * tan, 0], [12, 9, 0]])
    )
    assert places(f"G18\nG1 Z10 {word} F100\n", language)[-1] == pytest.approx([10 * tan, 0, 10])
    assert places(f"G19\nG1 Z3 {word} F100\n", language)[-1] == pytest.approx([0, 3 / tan, 3])


def test_two_lines_by_their_angles_meet_in_a_corner_that_can_be_rounded() -> None:
    text = "G1 ANG=60 {} F100\nX20 Y0 ANG=-60\n"
    assert places(text.format(""), "siemens")[-2:] == pytest.approx(
        np.array([[10, 10 * 3**0.5, 0], [20, 0, 0]]), abs=1e-9
    )
    path = places(text.format("RND=2"), "siemens")
    arc = rounded(path, (10.0, 10 * 3**0.5 - 4.0), 2.0)
    assert arc[0] == pytest.approx([10 - 3**0.5, 10 * 3**0.5 - 3.0])


@pytest.mark.parametrize(
    "text",
    [
        "G1 ,A30. F100\nY5.\n",
        "G1 X5. Y5. ,A30. F100\n",
        "G1 Y5. ,A0. F100\n",
        "G2 X5. R9. ,A30. F100\n",
        "G1 ,A30. F100\nX9. Y9. ,A30.\n",
    ],
)
def test_an_angle_that_makes_no_end_is_an_error_with_its_line(text: str) -> None:
    found = [
        one for one in read(HEAD + text + "M30\n", "fanuc").findings if one.code == "corner-not-interpreted"
    ]
    assert found and found[0].line == 3 and "by their angle" in found[0].text


def test_an_angle_leaves_the_rotary_axis_of_its_letter_alone_and_takes_values_beside_it() -> None:
    program = read(HEAD + "#1=10.\nG1 X#1 ,A45. A20. F100\nM30\n", "fanuc")
    assert not errors(program) and program.words[-1].tolist() == pytest.approx([10, 10, 0, 0, 20])


def test_random_corners_are_rounded_without_a_kink() -> None:
    """Lines and arcs at random: where a corner is rounded, no two pieces of the path turn by more than two
    chords do."""
    dice, rounded_ones = np.random.default_rng(32), 0
    for _ in range(120):
        way, end = dice.uniform(-20, 20, (2, 2))
        codes, radii = dice.choice(["G1", "G2", "G3"], 2), dice.uniform(25, 60, 2)
        tail = [f"R{radius:.4f}" if code != "G1" else "" for code, radius in zip(codes, radii, strict=True)]
        text = f"{codes[0]} X{way[0]:.4f} Y{way[1]:.4f} {tail[0]} ,R1. F100\n{codes[1]} X{end[0]:.4f} Y{end[1]:.4f} {tail[1]}\n"
        program = read(HEAD + text + "M30\n", "fanuc")
        if errors(program):
            continue
        step = np.diff(program.words[:, :2], axis=0)
        step = step[np.hypot(*step.T) > 1e-9]
        turn = np.angle(np.exp(1j * np.diff(np.arctan2(step[:, 1], step[:, 0]))))
        assert np.abs(turn).max() < 2.0 * 2.0 * math.acos(1.0 - 0.001), text
        rounded_ones += 1
    assert rounded_ones > 60
