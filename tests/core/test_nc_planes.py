# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tilted working planes: by hand, and by forward kinematics against scipy's rotations."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from test_nc_cycles import errors

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.machine import Axis, Machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.toolpath.cl_path import Motion

POINTS = np.array([[0.0, 0.0, 5.0], [7.0, 0.0, 5.0], [7.0, 3.0, 5.0], [7.0, 3.0, -1.0], [-2.0, 4.5, 1.25]])
LIMIT = np.radians(120.0)


def machine(*rotary: Axis) -> Chain:
    """Axes X Y Z in the head, with these two rotary axes, and a setup off all centres."""
    linear = [
        Axis(name, False, "head", tuple(row), max_rate=6000.0)
        for name, row in zip("XYZ", np.eye(3), strict=True)
    ]
    table = [axis for axis in rotary if axis.side == "table"]
    head = [axis for axis in rotary if axis.side == "head"]
    return chain(Machine("one", (*table, *linear, *head)), Setup((11.0, -7.0, 23.0), 130.0))


TURNTABLE = Axis("C", True, "table", (0, 0, 1), (3.0, 4.0, 0.0))
TRUNNION = machine(TURNTABLE, Axis("A", True, "table", (1, 0, 0), (0.0, 5.0, -60.0), low=-LIMIT, high=LIMIT))
NARROW = machine(TURNTABLE, Axis("A", True, "table", (1, 0, 0), (0.0, 5.0, -60.0), low=-LIMIT, high=0.2))
MIXED = machine(TURNTABLE, Axis("B", True, "head", (0, 1, 0), (0.0, 0.0, 40.0), low=-LIMIT, high=LIMIT))
FORK = machine(
    Axis("C", True, "head", (0, 0, 1)),
    Axis("B", True, "head", (0, 1, 0), (1.0, 0.0, 60.0), low=-LIMIT, high=LIMIT),
)
NUTATING = machine(TURNTABLE, Axis("B", True, "table", (0, 0.5**0.5, 0.5**0.5), (0.0, 9.0, -30.0)))
MACHINES = {"trunnion": TRUNNION, "mixed": MIXED, "fork": FORK}


def read(text: str, controller: str, kinematics: Chain = TRUNNION) -> Program:
    return read_nc(text.encode(), kinematics, DIALECTS[controller])


def iso(plane: str, points: str = "", kinematics: Chain = TRUNNION, align: str = "G53.1\n") -> Program:
    first = (
        " ".join(f"{letter}0" for letter in kinematics.letters[:3])
        + f" {kinematics.letters[3]}0 {kinematics.letters[4]}0"
    )
    points = points or "".join(f"G1 X{x} Y{y} Z{z}\n" for x, y, z in POINTS)
    return read(f"G21 G90 G94 F300\nG0 {first}\nG0 Z100\n{plane}\n{align}{points}G69\n", "fanuc", kinematics)


def klartext(plane: str, kinematics: Chain = TRUNNION, points: str = "") -> Program:
    first = f"L X+0 Y+0 Z+100 {kinematics.letters[3]}+0 {kinematics.letters[4]}+0 R0 FMAX"
    points = points or "".join(f"L X{x:+} Y{y:+} Z{z:+} F300\n" for x, y, z in POINTS)
    return read(
        f"BEGIN PGM T MM\n{first}\n{plane}\n{points}PLANE RESET STAY\nEND PGM T MM\n",
        "heidenhain",
        kinematics,
    )


def swivel(call: str, kinematics: Chain = TRUNNION) -> Program:
    first = f"G0 X0 Y0 Z100 {kinematics.letters[3]}0 {kinematics.letters[4]}0"
    points = "".join(f"G1 X{x} Y={y} Z{z}\n" for x, y, z in POINTS)
    return read(f"G71 G90 G94 F300\n{first}\n{call}\n{points}CYCLE800()\n", "siemens840d", kinematics)


def poses(program: Program, kinematics: Chain) -> tuple[np.ndarray, np.ndarray]:
    return forward(kinematics, words_to_q(program.words))


def lies(program: Program, kinematics: Chain, origin: tuple[float, ...], turn: np.ndarray) -> None:
    """The last five blocks lead to the points in that plane, the tool along its normal, and the rotary axes
    rest."""
    assert not errors(program), program.findings
    tip, axis = poses(program, kinematics)
    np.testing.assert_allclose(tip[-5:], np.array(origin) + POINTS @ turn.T, atol=1e-9)
    np.testing.assert_allclose(axis[-5:], np.tile(turn[:, 2], (5, 1)), atol=1e-9)
    assert (program.words[-5:, 3:] == program.words[-1, 3:]).all()
    assert (program.motion[-5:] == Motion.CUT).all() and program.guided is None


@pytest.mark.parametrize("name", MACHINES)
@pytest.mark.parametrize(
    "angles", [(0, 0, 0), (30, 0, 0), (0, 30, 0), (0, 0, 30), (20, 40, 0), (90, -35, -20), (200, 50, 170)]
)
def test_fanucs_euler_angles_are_about_z_then_x_then_z(name: str, angles: tuple[float, float, float]) -> None:
    kinematics, (i, j, k) = MACHINES[name], angles
    program = iso(f"G68.2 X1 Y-2 Z3 I{i} J{j} K{k}", kinematics=kinematics)
    lies(program, kinematics, (1, -2, 3), Rotation.from_euler("ZXZ", angles, degrees=True).as_matrix())


@pytest.mark.parametrize("name", MACHINES)
@pytest.mark.parametrize(
    "angles", [(0, 0, 0), (30, 0, 0), (0, 30, 0), (0, 0, 30), (20, -40, 0), (10, 20, 30), (-15, 5, 100)]
)
def test_spatial_angles_are_about_the_axes_of_the_work(name: str, angles: tuple[float, float, float]) -> None:
    kinematics, (a, b, c) = MACHINES[name], angles
    turn = Rotation.from_euler("xyz", angles, degrees=True).as_matrix()
    lies(
        klartext(f"PLANE SPATIAL SPA{a:+} SPB{b:+} SPC{c:+} TURN FMAX", kinematics),
        kinematics,
        (0, 0, 0),
        turn,
    )
    lies(
        klartext(f"PLANE SPATIAL SPA{a:+} SPB{b:+} SPC{c:+} TURN F2000 COORD ROT", kinematics),
        kinematics,
        (0, 0, 0),
        turn,
    )


@pytest.mark.parametrize("name", MACHINES)
@pytest.mark.parametrize(
    ("mode", "order"), [(57, "XYZ"), (54, "YXZ"), (45, "XZY"), (39, "ZXY"), (30, "YZX"), (27, "ZYX")]
)
def test_cycle800_turns_axis_by_axis(name: str, mode: int, order: str) -> None:
    kinematics = MACHINES[name]
    program = swivel(f'CYCLE800(0,"TC1",0,{mode},1,2,3,10,-25,40,4,5,6,1,100,1)', kinematics)
    turn = Rotation.from_euler(order, [10, -25, 40], degrees=True).as_matrix()
    lies(program, kinematics, tuple(np.array([1, 2, 3]) + turn @ [4, 5, 6]), turn)


def test_planes_by_hand() -> None:
    # about X by 30: the plane's Y is (0, cos 30, sin 30), so p = (7, 3, 5) stands at y = 3 cos - 5 sin, z = 3
    # sin + 5 cos
    tip, axis = poses(klartext("PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN FMAX"), TRUNNION)
    np.testing.assert_allclose(tip[4], [7, 3 * 0.75**0.5 - 2.5, 1.5 + 5 * 0.75**0.5], atol=1e-12)
    np.testing.assert_allclose(axis[4], [0, -0.5, 0.75**0.5], atol=1e-12)
    # about Y by 90: X points down, Z along X
    tip, axis = poses(swivel('CYCLE800(0,"TC1",0,57,0,0,0,0,90,0,0,0,0,-1)'), TRUNNION)
    np.testing.assert_allclose(tip[4], [5, 3, -7], atol=1e-12)
    np.testing.assert_allclose(axis[4], [1, 0, 0], atol=1e-12)
    # about Z by 90: X along Y
    tip, axis = poses(iso("G68.2 X10 Y0 Z0 I90 J0 K0"), TRUNNION)
    np.testing.assert_allclose(tip[5], [10 - 3, 7, 5], atol=1e-12)
    np.testing.assert_allclose(axis[5], [0, 0, 1], atol=1e-12)


def test_vectors_and_euler_angles_of_heidenhain() -> None:
    turn = Rotation.from_euler("ZXZ", [20, 30, -40], degrees=True).as_matrix()
    lies(klartext("PLANE EULER EULPR+20 EULNU+30 EULROT-40 TURN FMAX"), TRUNNION, (0, 0, 0), turn)
    b, n = turn[:, 0] * 3.0 + turn[:, 2], turn[:, 2] * 0.5
    reported = " ".join(
        f"{name}{value:+.12f}"
        for name, value in zip(("BX", "BY", "BZ", "NX", "NY", "NZ"), (*b, *n), strict=True)
    )
    lies(klartext(f"PLANE VECTOR {reported} TURN FMAX SEQ+"), TRUNNION, (0, 0, 0), turn)


def test_turn_stands_and_move_keeps_the_tip() -> None:
    text = "PLANE SPATIAL SPA+30 SPB+0 SPC+10 {} FMAX"
    turn, move = klartext(text.format("TURN")), klartext(text.format("MOVE"))
    assert (turn.words[1, :3] == turn.words[0, :3]).all() and turn.line[1] == 3
    tip, axis = poses(move, TRUNNION)
    np.testing.assert_allclose(tip[1], tip[0], atol=1e-9)
    assert move.guided is not None and move.guided.on.tolist() == [False, True, *[False] * 5]
    tip, axis = poses(klartext(text.format("MOVE DIST50")), TRUNNION)
    np.testing.assert_allclose(tip[1] - 50 * axis[1], tip[0] - 50 * axis[0], atol=1e-9)
    assert (move.motion[:2] == Motion.RAPID).all() and (turn.motion[:2] == Motion.RAPID).all()


def test_stay_leaves_the_turning_to_the_words_of_the_program() -> None:
    tilt = "PLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY\n"
    points = "".join(f"L X{x:+} Y{y:+} Z{z:+} F300\n" for x, y, z in POINTS)
    turn = Rotation.from_euler("x", 30, degrees=True).as_matrix()
    program = klartext(tilt + "L A+30 C+0 FMAX\n" + points)
    lies(program, TRUNNION, (0, 0, 0), turn)
    assert (program.words[1, :3] == program.words[0, :3]).all() and program.words[1].tolist()[3:] == [0, 30]
    off = klartext(tilt + points)
    assert errors(off) == ["plane-not-taken"] and "30 deg" in next(
        one.text for one in off.findings if one.code == "plane-not-taken"
    )
    lies(iso("G0 A30\nG68.2 I0 J30 K0", align=""), TRUNNION, (0, 0, 0), turn)


@pytest.mark.parametrize(("seq", "angle"), [("SEQ+", 30), ("SEQ-", -30)])
def test_seq_says_the_sign_of_the_axis_nearest_to_the_tool(seq: str, angle: float) -> None:
    program = klartext(f"PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN FMAX {seq}")
    assert program.words[-1, 4] == pytest.approx(angle)
    assert not errors(program)


@pytest.mark.parametrize(("way", "angle"), [(1, 30), (-1, -30)])
def test_dir_says_the_higher_or_lower_value(way: int, angle: float) -> None:
    program = swivel(f'CYCLE800(0,"TC1",0,57,0,0,0,30,0,0,0,0,0,{way})')
    assert program.words[-1, 4] == pytest.approx(angle)


def test_fanuc_takes_the_least_way_of_the_master_axis() -> None:
    # C stands at 170: A-30 C180 turns A by 30 as A30 C0 does; of two as long in A the shorter one in C
    program = read("G21 G90 F300\nG0 X0 Y0 Z50 C170 A0\nG68.2 I0 J30 K0\nG53.1\nG1 X1 Y1 Z1\n", "fanuc")
    assert program.words[-1, 3:].tolist() == pytest.approx([180, -30])
    # of a table and a head the table goes first, however long the head's way is
    program = read(
        "G21 G90 F300\nG0 X0 Y0 Z50 C100 B90\nG68.2 I90 J30 K0\nG53.1\nG1 X1 Y1 Z1\n", "fanuc", MIXED
    )
    assert program.words[-1, 3:].tolist() == pytest.approx([180, -30])
    only = read("G21 G90 F300\nG0 X0 Y0 Z50 C0 A0\nG68.2 I0 J30 K0\nG53.1\nG1 X1 Y1 Z1\n", "fanuc", NARROW)
    assert abs(only.words[-1, 3]) == pytest.approx(180) and only.words[-1, 4] == pytest.approx(-30)


def test_what_cannot_be_taken_up_is_named() -> None:
    seq = klartext("PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN FMAX SEQ+", NARROW)
    assert "axis-not-reachable" in errors(seq) and any(
        "SEQ asks" in found.text and found.line == 3 for found in seq.findings
    )
    steep = iso("G68.2 I0 J130 K0", kinematics=TRUNNION)
    assert "axis-not-reachable" in errors(steep)
    nutating = iso("G68.2 I0 J120 K0", kinematics=NUTATING)
    assert any("cannot take up" in found.text for found in nutating.findings)


@pytest.mark.parametrize(("letter", "axis"), [("I", "X"), ("J", "Y"), ("K", "Z")])
def test_one_angle_about_x_y_or_z_of_the_work(letter: str, axis: str) -> None:
    program = iso(f"G68.2 P1 Q123 X1 Y2 Z3 {letter}-30")
    turn = Rotation.from_euler(axis, -30, degrees=True).as_matrix()
    lies(program, TRUNNION, (1.0, 2.0, 3.0), turn)
    lies(iso("G68.2 P1 X1 Y2 Z3 I0 J0 K0"), TRUNNION, (1.0, 2.0, 3.0), np.eye(3))


@pytest.mark.parametrize(
    ("plane", "message"),
    [
        ("G68.2 P1 X0 Y0 Z0 I10 J20 K30", "P1"), ("G68.2 P2 Q1 X0 Y0 Z0", "P2"), ("G68.2 X0 Y0 Z0 I10 J20 K30 R5", "R is not"),
        ("G68.2 I0 J30 K0\nG68.2 I0 J20 K0", "another plane"), ("\nG69", "no tilted plane"),
    ],
)  # fmt: skip
def test_forms_of_fanuc_that_are_not_known_are_named(plane: str, message: str) -> None:
    program = iso(plane)
    found = [one for one in program.findings if one.code == "offset-not-interpreted"]
    assert message in found[0].text and found[0].line == (
        6 if message == "no tilted plane" else 4 + plane.count("\n")
    )
    assert found[0].severity is Severity.ERROR


@pytest.mark.parametrize(
    "plane",
    [
        "PLANE AXIAL B+30 TURN FMAX", "PLANE SPATIAL SPA+10 SPB+0 TURN FMAX", "PLANE RELATIV SPB+10 SPA+1 TURN FMAX", "PLANE POINTS P1X+0",
        "PLANE PROJECTED PROPR+24 PROMIN+24 ROT+30 TURN FMAX", "PLANE POINTS P1X+0 P1Y+0 P1Z+20 P2X+30 P2Y+31 P2Z+20 P3X+0 P3Y+41 P3Z+32 TURN FMAX",
        "PLANE SPATIAL SPA+10 SPB+0 SPC+0 TURN FMAX SYM+", "PLANE VECTOR BX+1 BY+0 BZ+0 NX+1 NY+0 NZ+0 TURN FMAX",
        "PLANE SPATIAL SPA+Q1 SPB+0 SPC+0 TURN FMAX",
    ],
)  # fmt: skip
def test_forms_of_heidenhain_that_are_not_known_are_named(plane: str) -> None:
    program = klartext(plane)
    found = next(one for one in program.findings if one.code == "offset-not-interpreted")
    assert found.line == 3 and found.severity is Severity.ERROR
    np.testing.assert_allclose(program.words[-5:, :3], POINTS)


@pytest.mark.parametrize(
    "call",
    [
        '1,"T",2,57,0,0,0,9,0,0,0,0,0,1',
        '1,"T",11,57,0,0,0,9,0,0,0,0,0,1',
        '0,"T",0,64,0,0,0,9,0,0,0,0,0,1',
        '0,"T",0,192,0,0,0,9,0,0,0,0,0,1',
        "A,B",
    ],
)
def test_forms_of_siemens_that_are_not_known_are_named(call: str) -> None:
    program = swivel(f"CYCLE800({call})")
    assert [found.line for found in program.findings if found.code == "offset-not-interpreted"] == [3]


def test_values_beyond_all_words_are_named() -> None:
    far = "9" * 320
    for program in (
        klartext(f"PLANE SPATIAL SPA+{far} SPB+0 SPC+0 TURN FMAX"),
        swivel(f'CYCLE800(0,"T",0,57,0,0,0,{far},0,0,0,0,0,1)'),
        swivel(f'CYCLE800(0,"T",0,{far},0,0,0,1,0,0,0,0,0,1)'),
        iso("G68.2 X0 I99999999 J0 K0"),
    ):
        assert any("beyond all words" in found.text for found in program.findings)


def test_resets_turn_back_or_not_and_a_retract_by_setting_is_named() -> None:
    program = swivel(
        'CYCLE800(1,"TC1",0,57,0,0,0,30,0,0,0,0,0,1)\nG1 X1\nCYCLE800(0,"TC1",0,57,0,0,0,0,0,0,0,0,0,1)'
    )
    assert program.words[-1, 3:].tolist() == [0, 0] and [
        one.line for one in program.findings if one.code == "machine-position"
    ] == [3]
    np.testing.assert_allclose(program.words[-5:, :3], POINTS, atol=1e-9)
    for reset in ("CYCLE800()", "CYCLE800", "N10 CYCLE800 ", 'CYCLE800(0,"0",0,57,0,0,0,0,0,0,0,0,0,1)'):
        program = swivel(f'CYCLE800(0,"TC1",0,57,0,0,0,30,0,0,0,0,0,1)\nG1 X1\n{reset}')
        assert (
            program.words[-1, 4] == pytest.approx(30)
            and program.words[-1, :3].tolist() == POINTS[-1].tolist()
        )
    program = klartext("PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN FMAX\nPLANE RESET TURN FMAX")
    assert program.words[-1].tolist() == [*POINTS[-1], 0, 0] and not errors(program)


def test_in_a_plane_steps_arcs_cycles_inches_and_unnamed_words_mean_the_plane() -> None:
    turn = Rotation.from_euler("ZXZ", [20, 40, 0], degrees=True).as_matrix()
    head = "G68.2 X1 Y2 Z3 I20 J40 K0"
    tip, _ = poses(iso(head, "G0 X5 Y6 Z10\nG91 X1\nY2 Z-1\nG90 X0\n"), TRUNNION)
    np.testing.assert_allclose(
        (tip[-4:] - [1, 2, 3]) @ turn, [[5, 6, 10], [6, 6, 10], [6, 8, 9], [0, 8, 9]], atol=1e-9
    )
    tip, _ = poses(iso(head, "G0 X5 Y0 Z2\nG3 X-5 I-5 J0\n"), TRUNNION)
    place = (tip - [1, 2, 3]) @ turn
    np.testing.assert_allclose(np.hypot(place[-20:, 0], place[-20:, 1]), 5, atol=1e-9)
    np.testing.assert_allclose(place[-1], [-5, 0, 2], atol=1e-9)
    tip, _ = poses(iso(head, "G0 X5 Y6 Z10\nG81 X5 Y6 Z-3 R2\nX7\nG80\n"), TRUNNION)
    np.testing.assert_allclose(((tip - [1, 2, 3]) @ turn)[-8:, 2], [10, 2, -3, 10, 10, 2, -3, 10], atol=1e-9)
    inch = read("G20 G90 F10\nG0 X0 Y0 Z5 A0 C0\nG68.2 X1 Y0 Z0 I0 J40 K0\nG53.1\nG1 X1 Y1 Z0\n", "fanuc")
    np.testing.assert_allclose(
        poses(inch, TRUNNION)[0][-1] / 25.4, [2, np.cos(np.radians(40)), np.sin(np.radians(40))], atol=1e-9
    )


def test_a_cycle_that_begins_where_nobody_knows_is_named() -> None:
    for points, bad in (
        ("G81 X5 Y6 Z-3 R2\n", True),
        ("G0 Z9\nG81 X5 Z-3 R2\n", True),
        ("G0 Z9\nG81 X5 Y6 Z-3 R2\n", False),
    ):
        program = iso("G68.2 I0 J30 K0", points + "G80\n")
        assert any("where it begins is not known" in found.text for found in program.findings) is bad
        assert np.isfinite(program.words).all()
    plain = read("G21 G90 G69 F300\nG0 X0 Y0 Z50 C0 A0\nG69\nG81 X5 Y6 Z-3 R2\n", "fanuc")
    assert not errors(plain) and len(plain.line) == 5


def test_after_the_plane_words_mean_the_axes_and_what_is_not_named_stands() -> None:
    program = read(
        "G21 G90 F300\nG0 X0 Y0 Z50 C0 A0\nG68.2 I0 J30 K0\nG53.1\nG1 X1 Y2 Z3\nG69\nG0 Z80\nG0 X5\n", "fanuc"
    )
    assert program.words[-2, :2].tolist() == program.words[-3, :2].tolist() and program.words[-2, 2] == 80
    assert program.words[-1, 0] == 5 and program.line.tolist() == [2, 4, 5, 7, 8]


def test_a_safe_start_in_a_plane_and_the_axes_in_rows_of_their_own() -> None:
    program = read("G21 G90 F300\nG68.2 X0 Y0 Z0 I0 J30 K0\nG53.1\nG0 X1 Y2\nG43 H1 Z30\nG1 Z3\n", "fanuc")
    tip, _ = poses(program, TRUNNION)
    assert not errors(program) and program.line.tolist() == [5, 6]
    np.testing.assert_allclose(
        tip @ Rotation.from_euler("x", 30, degrees=True).as_matrix(), [[1, 2, 30], [1, 2, 3]], atol=1e-9
    )


def test_random_planes_on_random_places_by_all_three_controls() -> None:
    rng = np.random.default_rng(5)
    for kinematics in MACHINES.values():
        for _ in range(10):
            a, b, c = rng.uniform(-60, 60, 3).round(3)
            turn = Rotation.from_euler("xyz", [a, b, c], degrees=True).as_matrix()
            z1, x, z2 = Rotation.from_matrix(turn).as_euler("ZXZ", degrees=True)
            lies(
                klartext(f"PLANE SPATIAL SPA{a:+} SPB{b:+} SPC{c:+} TURN FMAX", kinematics),
                kinematics,
                (0, 0, 0),
                turn,
            )
            lies(
                iso(f"G68.2 I{z1:.12f} J{x:.12f} K{z2:.12f}", kinematics=kinematics),
                kinematics,
                (0, 0, 0),
                turn,
            )
            lies(
                swivel(f'CYCLE800(0,"TC",200000,27,0,0,0,{c},{b},{a},0,0,0,1)', kinematics),
                kinematics,
                (0, 0, 0),
                turn,
            )
