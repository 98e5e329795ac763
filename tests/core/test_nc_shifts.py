# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shifts of the zero in all three languages: by hand, as LinuxCNC moves, and with tilted planes; what is not
known is never silent."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest
from rs274_judge import needs_rs274
from scipy.spatial.transform import Rotation
from test_nc_cycles import agree, errors, path, read
from test_nc_planes import POINTS, TRUNNION, klartext, lies, poses, swivel
from test_nc_planes import read as read_on

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.reader import Assumed, codes, shifts
from freecad_fiveaxis.core.nc.reader.lines import Lines
from freecad_fiveaxis.core.nc.reader.words import read_words

HEAD = {
    "fanuc": "G21 G90 G94 F100\nG0 X0. Y0. Z20. A0. C0.\n", "linuxcnc": "G21 G90 G94 F100\nG0 X0 Y0 Z20 A0 C0\n",
    "siemens840d": "G71 G90 G94 F100\nG0 X0 Y0 Z20 A0 C0\n", "heidenhain": "BEGIN PGM A MM\nL X+0 Y+0 Z+20 A+0 C+0 FMAX\n",
}  # fmt: skip
TURN = Rotation.from_euler("xyz", [30, -20, 10], degrees=True).as_matrix()


LOST = ("feed-from-machine-position",)
"""These feed on from a machine position, to show that it is no block."""


def after(text: str, controller: str, expected: tuple[str, ...] = ()) -> list[str]:
    program = read(HEAD[controller] + text, controller)
    assert errors(program) == [*expected], program.findings
    return path(program)


def test_g52_counts_for_the_axes_that_it_names_until_it_is_taken_back() -> None:
    text = "G52 X10. Z5.\nG1 X1.\nG52 Y3. X2.\nY1.\nG91 X1.\nG90 G53 X7.\nG52 X0. Y0. Z0.\nX1. Y1. Z1.\n"
    for controller in ("fanuc", "linuxcnc"):
        assert after(text.replace("G53 X7.", "X7."), controller) == [
            "f 11 0 20", "f 11 4 20", "f 12 4 20", "f 9 4 20", "f 1 1 1",
        ]  # fmt: skip
    assert 7 not in read(HEAD["fanuc"] + text, "fanuc").words[:, 0]


def test_g52_moves_arcs_by_their_centres_cycles_with_their_r_and_inches() -> None:
    arc = read(HEAD["linuxcnc"] + "G52 X10 Y5\nG0 X1 Y0\nG90.1 G3 X-1 Y0 I0 J0 F50\n")
    np.testing.assert_allclose(np.hypot(*(arc.words[1:, :2] - [10, 5]).T), 1.0, atol=1e-9)
    assert after("G52 Y5. Z-3.\nG98 G81 X1. Y1. R2. Z-5.\nG80\n", "fanuc") == [
        "r 1 6 20",
        "r 1 6 -1",
        "f 1 6 -8",
        "r 1 6 20",
    ]
    stepped = after("G52 Y5. Z-3.\nG91 G98 G81 X1. Y1. R-18. Z-5.\nG80\n", "fanuc")
    assert stepped == ["r 1 1 20", "r 1 1 2", "f 1 1 -3", "r 1 1 20"]
    assert after("G52 X10.\nG20\nG1 X1.\n", "fanuc") == ["f 35.4 0 20"]


def some_shifts(seed: int) -> str:
    dice = random.Random(seed)
    lines = [f"{dice.choice(('G21', 'G20'))} G90 G94 F100", "G0 X0 Y0 Z0 A0 C0"]
    for _ in range(25):
        x, y, z = (dice.choice((f"{letter}{dice.randint(-9, 9)}", "")) for letter in "XYZ")
        kind = dice.random()
        if kind < 0.3:
            lines.append(f"G52 {x} {y or 'Y1'} {z}")
        elif kind < 0.4:
            lines.append(dice.choice(("G20", "G21", "G91", "G90")))
        elif kind < 0.75:
            lines.append(f"G90 G98 G81 X1 {y} Z-{dice.randint(1, 9)} R{dice.randint(0, 9)}\n{x or 'X2'}\nG80")
        else:
            lines.append(f"G1 {x} {y} {z or 'Z1'}")
    return "\n".join([*lines, "M2"]) + "\n"


@pytest.mark.rs274
@needs_rs274
@pytest.mark.parametrize("seed", range(12))
def test_g52_moves_as_linuxcnc_moves(seed: int, tmp_path: Path) -> None:
    agree(some_shifts(seed), tmp_path)


def test_trans_is_of_all_axes_and_atrans_goes_on() -> None:
    text = "TRANS X10 Y=2*1\nG1 X1 Y1\nATRANS X=5 Z-1\nX1 Z0\nTRANS Z7\nX1 Y1 Z1\nG0 SUPA X99\nTRANS\nG1 X=IC(1) Z=3\n"
    assert after("R1=2\n" + text.replace("2*1", "R1"), "siemens840d", LOST) == [
        "f 11 3 20",
        "f 16 3 -1",
        "f 1 1 8",
        "f 2 1 3",
    ]
    assert after("TRANS X10\nG0 X0 Y0\nG2 X2 Y0 I=AC(1) J=AC(0)\n", "siemens840d")[-1] == "f 12 0 20"


def test_shifts_of_klartext_are_absolute_or_on_and_by_parameters() -> None:
    text = (
        "CYCL DEF 7.0 NULLPUNKT\n5 CYCL DEF 7.1 X+10\n6 CYCL DEF 7.2 IY+5\nL X+1 Y+1 F100\nTRANS DATUM AXIS IX+1 Z+3\nL X+1 Z+1\n"
        "L Z+50 FMAX M91\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+Q1\nL X+0\nTRANS DATUM RESET\nL X+1 Y+1 Z+1\n"
    )
    expected = ["f 11 6 20", "f 12 6 4", "f 7 6 4", "f 1 1 1"]
    for one in ("Q1=7\n" + text, text.replace("Q1", "7")):
        assert after(one, "heidenhain", LOST) == expected
    centre = read(
        HEAD["heidenhain"] + "CYCL DEF 7.1 X+10\nL X+1 Y+0 FMAX\nCC X+0 Y+0\nC X-1 Y+0 DR+ F50\n",
        "heidenhain",
    )
    np.testing.assert_allclose(np.hypot(*(centre.words[1:, :2] - [10, 0]).T), 1.0, atol=1e-9)


def test_g54_of_a_heidenhain_program_in_iso_is_a_shift() -> None:
    program = read("%T G71\nN10 G90 G0 X+0 Y+0 Z+20 A+0 C+0\nN20 G54 X+10 Y+5\nN30 G1 X+1 Y+1 F100\nN40 G91 G54 X+2\n"
                   "N50 G90 X+1\nN60 G54 X+0 Y+0\nN70 X+1 Y+1\nN99 %T G71\n", "heidenhain")  # fmt: skip
    assert path(program) == ["f 11 6 20", "f 13 6 20", "f 1 1 20"] and not errors(program)


def moved(program: Program, origin: np.ndarray, turn: np.ndarray, points: np.ndarray = POINTS) -> None:
    assert not errors(program), program.findings
    tip, axis = poses(program, TRUNNION)
    np.testing.assert_allclose(tip[-5:], origin + points @ turn.T, atol=1e-9)
    np.testing.assert_allclose(axis[-5:], np.tile(turn[:, 2], (5, 1)), atol=1e-9)


PLANE = "PLANE SPATIAL SPA+30 SPB-20 SPC+10 TURN FMAX"
SHIFT = "CYCL DEF 7.0\nCYCL DEF 7.1 X+4\nCYCL DEF 7.2 Y-5\nCYCL DEF 7.3 Z+6"


def test_a_shift_before_a_plane_moves_its_zero_and_one_in_it_counts_there() -> None:
    shift = np.array([4.0, -5.0, 6.0])
    lies(klartext(f"{SHIFT}\n{PLANE}"), TRUNNION, (4, -5, 6), TURN)
    lies(klartext(f"{PLANE}\nTRANS DATUM AXIS X+4 Y-5 Z+6"), TRUNNION, tuple(TURN @ shift), TURN)
    lies(
        klartext(f"{SHIFT}\n{PLANE}\nTRANS DATUM AXIS IY+2"), TRUNNION, tuple(shift + TURN @ [0, 2, 0]), TURN
    )
    back = klartext(f"{SHIFT}\n{PLANE}\nL X+0 F100\nPLANE RESET STAY\nL X+1 Y+1 Z+50\nTRANS DATUM RESET")
    assert back.words[3, :3].tolist() == [5, -4, 56]
    swivelled = 'CYCLE800(0,"TC1",0,57,1,2,3,30,0,0,0,0,0,1)'
    about = Rotation.from_euler("x", 30, degrees=True).as_matrix()
    moved(swivel(f"TRANS X99\n{swivelled}"), np.array([1, 2, 3]), about)
    moved(swivel(f"{swivelled}\nTRANS X4 Y-5\nATRANS Z6"), np.array([1, 2, 3]) + about @ shift, about)


def test_g52_stands_before_the_plane_of_g68_2_and_not_in_it() -> None:
    text = "G21 G90 G94 F300\nG0 X0 Y0 Z100 C0 A0\n{}G68.2 X1 Y2 Z3 I0 J30 K0\nG53.1\n{}" + "".join(
        f"G1 X{x} Y{y} Z{z}\n" for x, y, z in POINTS
    )
    about = Rotation.from_euler("x", 30, degrees=True).as_matrix()
    moved(read_on(text.format("G52 X4 Y-5 Z6\n", ""), "fanuc"), np.array([5, -3, 9]), about)
    bare = text.replace("X1 Y2 Z3 ", "")
    moved(read_on(bare.format("G52 X4 Y-5 Z6\n", ""), "fanuc"), np.array([4, -5, 6]), about)
    within = read_on(text.format("", "G52 X4\n"), "fanuc")
    assert [
        (found.line, "tilted plane" in found.text)
        for found in within.findings
        if found.code == "offset-not-interpreted"
    ] == [(5, True)]


@pytest.mark.parametrize("end", ["PLANE RESET STAY", PLANE])
@pytest.mark.parametrize(
    ("then", "known"),
    [("", False), ("CYCL DEF 7.1 X+0", True), ("CYCL DEF 7.2 Y+0", False), ("TRANS DATUM RESET", True)],
)
def test_moves_after_a_plane_that_ends_with_a_shift_in_it_are_named(end: str, then: str, known: bool) -> None:
    program = klartext(f"{PLANE}\nTRANS DATUM AXIS X+4\nL X+1 F100\n{end}\n{then}\nL X+9")
    found = [one for one in program.findings if one.severity is Severity.ERROR]
    assert known != any(one.line == 6 and "reset the shift first" in one.text for one in found)
    assert known == (found == [])


def test_relative_planes_go_on_from_the_one_that_is_on() -> None:
    about = Rotation.from_euler("y", -25, degrees=True).as_matrix()
    lies(klartext("PLANE RELATIV SPB-25 TURN FMAX"), TRUNNION, (0, 0, 0), about)
    lies(klartext(f"{SHIFT}\n{PLANE}\nPLANE RELATIV SPB-25 TURN FMAX"), TRUNNION, (4, -5, 6), TURN @ about)
    lies(klartext(f"{PLANE}\nPLANE RESET STAY\nPLANE RELATIV SPC+40 TURN FMAX"), TRUNNION, (0, 0, 0),
         Rotation.from_euler("z", 40, degrees=True).as_matrix())  # fmt: skip


@pytest.mark.parametrize(
    ("controller", "line", "name"),
    [
        ("fanuc", "G87 X5. Y6. Z-3. R2. Q0.5 F100", "G87"), ("linuxcnc", "G87 X5 Y6 Z-3 R2 I1 J1 K1", "G87"), ("haas", "G77 X5. Y6. Z-3. R2. Q0.5", "G77"),
        ("fanuc", "G68.2 P1 Q1 X1. Y2. Z3. I10. J20. K30.", "P1"), ("fanuc", "G68.2 P2 Q0 X0. Y0. Z0. R0.", "P2"), ("fanuc", "G68.2 P2 Q1 X1. Y0. Z0.", "P2"),
        ("fanuc", "G68.2 P3 Q1 X0. Y0. Z0. I1. J0. K0.", "P3"), ("fanuc", "G68.2 P4 X0. Y0. Z0. I10. J0. K0.", "P4"), ("fanuc", "G68.3 X0. Y0. Z0. R0.", "G68.3"),
        ("fanuc", "G68.4 X0. Y0. Z0. I0. J0. K10.", "G68.4"), ("haas", "G268 X0. Y0. Z0. I0. J30. K0. Q121", "G268"),
        ("fanuc", "G52 C5.", "G52"), ("fanuc", "G92 X5.", "G92"), ("fanuc", "G68 R30.", "G68"), ("fanuc", "G10 L2 P1 X5.", "G10"),
        ("heidenhain", "PLANE AXIAL B+45 TURN FMAX", "PLANE AXIAL"), ("heidenhain", "PLANE PROJECTED PROPR+24 PROMIN+24 ROT+30 TURN FMAX", "PLANE PROJECTED"),
        ("heidenhain", "PLANE POINTS P1X+0 P1Y+0 P1Z+20 P2X+30 P2Y+31 P2Z+20 P3X+0 P3Y+41 P3Z+32 TURN FMAX", "PLANE POINTS"),
        ("heidenhain", "PLANE RELATIV SPA+Q5 TURN FMAX", "PLANE RELATIV"), ("heidenhain", "CYCL DEF 7.1 #5", "CYCL DEF 7.1"), ("heidenhain", "CYCL DEF 7.1 X+Q5", "CYCL DEF 7.1"),
        ("heidenhain", "TRANS DATUM TABLE TABLINE5", "TRANS DATUM"), ("heidenhain", "TRANS DATUM AXIS X+10 C+5", "TRANS DATUM"), ("heidenhain", "TRANS ROTATION ROT+30", "TRANS ROTATION"),
        ("heidenhain", "N50 G53 P01 5", "G53"), ("heidenhain", "N50 G54 X+10 B+5", "G54"), ("siemens840d", "TRANS X10 C5", "TRANS"), ("siemens840d", "ASCALE X2", "ASCALE"), ("siemens840d", "ATRANS C5\nROT Z0", "ATRANS"), ("siemens840d", "TRANS X=R7", "R7"),
    ],
)  # fmt: skip
def test_what_is_not_known_of_shifts_planes_and_boring_is_an_error_by_name_with_a_remedy(
    controller, line, name
) -> None:
    end = {"fanuc": "G69\nG80\n", "haas": "G69\nG80\n", "linuxcnc": "G80\n"}.get(controller, "")
    program = read(HEAD.get(controller, HEAD["fanuc"]) + line + "\n" + end + "L X+3 F100\n" * (controller == "heidenhain") +
                   "G1 X3. F100\n" * (controller != "heidenhain"), controller)  # fmt: skip
    found = [one for one in program.findings if one.severity is Severity.ERROR]
    assert any(name in one.text and one.line == 3 for one in found)
    assert any("post" in one.text.lower() for one in found)


def test_a_program_without_shifts_is_the_same_object() -> None:
    words = read_words(HEAD["linuxcnc"].encode() + b"X1\n")
    assert shifts.shift_words(words, Lines(words, Assumed()), codes.ISO)[0] is words
