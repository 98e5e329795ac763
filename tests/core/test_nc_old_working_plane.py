# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext's cycle 19: the plane of its angles, where both of its meanings are one, and additive CYCLE800."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from test_nc_cycles import errors
from test_nc_planes import FORK, MIXED, NUTATING, POINTS, TRUNNION, lies, poses, read, swivel

from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program

CUTS = "".join(f"L X{x:+} Y{y:+} Z{z:+} F300\n" for x, y, z in POINTS)


def klartext(text: str, kinematics: Chain = TRUNNION) -> Program:
    first, second = kinematics.letters[3:]
    start = f"L X+0 Y+0 Z+100 {first}+0 {second}+0 R0 FMAX"
    return read(f"BEGIN PGM T MM\n{start}\n{text}\n{CUTS}END PGM T MM\n", "heidenhain", kinematics)


def plane(angles: str) -> str:
    return f"4 CYCL DEF 19.0 WORKING PLANE\n5 CYCL DEF 19.1 {angles}"


@pytest.mark.parametrize(
    ("kinematics", "angles", "turn", "axes"),
    [
        (TRUNNION, "A-30 C+90", (0, 0, -30, 90), "A-30 C+90"), (TRUNNION, "A-90", (0, 0, -90, 0), "A-90 C+0"),
        (TRUNNION, "A-30. C90.", (0, 0, -30, 90), "A-30 C+90"), (MIXED, "B74.995 C210.", (0, 74.995, 0, 210), "B74.995 C210"),
        (FORK, "B+90 C+30", (0, 90, 0, 30), "B+90 C+30"),
    ],
)  # fmt: skip
def test_one_plane_in_both_meanings_is_read(
    kinematics: Chain, angles: str, turn: tuple[float, ...], axes: str
) -> None:
    program = klartext(f"L {axes} FMAX\n{plane(angles)}", kinematics)
    _, b, a, c = turn
    expected = Rotation.from_euler("ZYX", [c, b, a], degrees=True).as_matrix()
    if not b:
        expected = Rotation.from_euler("ZX", [c, a], degrees=True).as_matrix()
    lies(program, kinematics, (0.0, 0.0, 0.0), expected)
    assert not errors(program)


def test_letters_that_the_machine_has_not_are_spatial_and_q120_to_q122_hold_its_words() -> None:
    program = klartext(f"{plane('A+0 B+45 C+0')}\nL A+Q120 C+Q122 R0 FMAX")
    assert not errors(program), program.findings
    axis = poses(program, TRUNNION)[1]
    np.testing.assert_allclose(axis[-1], [0.5**0.5, 0, 0.5**0.5], atol=1e-9)
    by_parameter = klartext(f"Q5 = 45\n{plane('A+0 B+Q5 C+0')}\nL A+Q120 C+Q122 R0 FMAX")
    np.testing.assert_allclose(by_parameter.words[-5:], program.words[-5:], atol=1e-9)


def test_two_planes_by_one_line_are_named() -> None:
    for kinematics, angles in ((NUTATING, "B+30"), (TRUNNION, "A-30 C+90")):
        program = klartext(plane(angles), kinematics)
        named = [found for found in program.findings if found.code == "offset-not-interpreted"]
        assert bool(named) == (kinematics is NUTATING)
        assert not named or (named[0].line == 4 and "spatial" in named[0].text)
    assert "plane-not-taken" in errors(klartext(plane("A-30 C+90")))  # nobody has turned the axes


def test_a_feed_lets_the_control_turn_and_no_word_ends_the_plane() -> None:
    turned = klartext(plane("A-30 F1000 DIST 50"))
    assert not errors(turned) and turned.words[-1, 4] == pytest.approx(-30)
    ended = klartext(f"L A-30 FMAX\n{plane('A-30')}\nL X+1 Y+2 Z+3 F300\n{plane('')}")
    np.testing.assert_allclose(ended.words[-5:, :3], POINTS)
    assert not errors(ended)
    for wrong in ("A-30 X+5", "A-30 A+10", "A-30 DIST"):
        assert "offset-not-interpreted" in errors(klartext(plane(wrong)))


def test_a_shift_before_cycle_19_moves_the_zero_of_the_plane() -> None:
    shift = "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y-20\nCYCL DEF 7.3 Z+5\n"
    program = klartext(f"L A-30 C+90 FMAX\n{shift}{plane('A-30 C+90')}")
    turn = Rotation.from_euler("ZX", [90, -30], degrees=True).as_matrix()
    lies(program, TRUNNION, (10.0, -20.0, 5.0), turn)


def test_an_additive_swivel_goes_on_from_the_plane_that_is_on() -> None:
    first = 'CYCLE800(0,"TC1",200000,57,1,2,50,-15,0,0,50,51.75,0,1,,1)'
    second = 'CYCLE800(0,"TC1",200001,54,35,-24,0,7,0,0,0,0,4,1,,1)'
    program = swivel(f"{first}\n{second}")
    one = Rotation.from_euler("XYZ", [-15, 0, 0], degrees=True).as_matrix()
    two = Rotation.from_euler("YXZ", [7, 0, 0], degrees=True).as_matrix()
    zero = np.array([1, 2, 50]) + one @ [50, 51.75, 0]
    lies(program, TRUNNION, tuple(zero + one @ ([35, -24, 0] + two @ [0, 0, 4])), one @ two)
    assert not errors(program)
    alone = swivel(second)
    lies(alone, TRUNNION, tuple([35, -24, 0] + two @ [0, 0, 4]), two)


def test_an_additive_swivel_without_angles_shifts_and_keeps_the_plane() -> None:
    first, second = 'CYCLE800(0,"T",0,57,0,0,0,30,0,0,0,0,0,1)', 'CYCLE800(0,"T",1,57,5,6,7,0,0,0,0,0,0,1)'
    turn = Rotation.from_euler("X", 30, degrees=True).as_matrix()
    lies(swivel(f"{first}\n{second}"), TRUNNION, tuple(turn @ [5, 6, 7]), turn)


def test_an_additive_swivel_on_a_frame_is_named() -> None:
    first, second = 'CYCLE800(0,"T",0,57,0,0,0,30,0,0,0,0,0,1)', 'CYCLE800(0,"T",1,57,0,0,0,9,0,0,0,0,0,1)'
    for frame in ("TRANS X5", "ROT Z20", "TRANS X5\nAROT Z20"):
        assert "offset-not-interpreted" in errors(swivel(f"{first}\n{frame}\n{second}")), frame
