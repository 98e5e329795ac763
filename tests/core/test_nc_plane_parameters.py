# SPDX-License-Identifier: LGPL-2.1-or-later
"""Q120 to Q122 after PLANE: against the examples of Heidenhain's manual, by forward kinematics, and what
leaves them unset."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import errors
from test_nc_planes import LIMIT, MIXED, POINTS, TRUNNION, TURNTABLE, lies, machine, poses, read

from freecad_fiveaxis.core.machine import Axis
from freecad_fiveaxis.core.machine.kinematics import Chain

LOW_A = machine(
    TURNTABLE,
    Axis("A", True, "table", (1, 0, 0), (0.0, 5.0, -60.0), low=np.radians(-90.0), high=np.radians(10.0)),
)
DUO = machine(
    TURNTABLE, Axis("B", True, "head", (0, 0.5**0.5, 0.5**0.5), (0.0, 0.0, 40.0), low=-LIMIT / 4, high=np.pi)
)
"""A head on an axis at 45 degrees: at B180 the tool is level."""
CUTS = "".join(f"L X{x:+} Y{y:+} Z{z:+} F300\n" for x, y, z in POINTS)


def program(
    text: str, kinematics: Chain = TRUNNION, stand: tuple[float, float] = (0.0, 0.0), cuts: str = CUTS
):
    first, second = kinematics.letters[3:]
    start = f"L X+0 Y+0 Z+100 {first}{stand[0]:+} {second}{stand[1]:+} R0 FMAX"
    return read(f"BEGIN PGM T MM\n{start}\n{text}\n{cuts}END PGM T MM\n", "heidenhain", kinematics)


@pytest.mark.parametrize(
    ("kinematics", "c", "seq", "a_c"),
    [
        (TRUNNION, 0, "", (45, 90)), (TRUNNION, 0, "SEQ+", (45, 90)), (TRUNNION, 0, "SEQ-", (-45, -90)),
        (TRUNNION, -105, "", (-45, -90)), (TRUNNION, -105, "SEQ+", (45, 90)), (TRUNNION, -105, "SEQ-", (-45, -90)),
        (LOW_A, 0, "", (-45, -90)), (TRUNNION, -135, "SEQ+", (45, 90)),
    ],
)  # fmt: skip
def test_the_examples_of_the_manual(kinematics: Chain, c: float, seq: str, a_c: tuple[float, float]) -> None:
    """iTNC 530, DIN/ISO programming, 6/2010, page 404: a rotary table C on a tilting table A, SPA+0 SPB+45
    SPC+0."""
    result = program(
        f"PLANE SPATIAL SPA+0 SPB+45 SPC+0 STAY {seq}\nL A+Q120 C+Q122 R0 FMAX", kinematics, (c, 0)
    )
    assert not errors(result), result.findings
    assert result.words[1, 4] == pytest.approx(a_c[0]) and (
        result.words[1, 3] - a_c[1]
    ) % 360 == pytest.approx(0, abs=1e-9)
    axis = poses(result, kinematics)[1]
    np.testing.assert_allclose(axis[-1], [0.5**0.5, 0, 0.5**0.5], atol=1e-9)


@pytest.mark.parametrize(
    ("plane", "b_c"),
    [("SPA90 SPB0 SPC90", (180, 270)), ("SPA-90 SPB0 SPC-90", (180, 270)), ("SPA90 SPB0 SPC180", (180, 0)), ("SPA0 SPB0 SPC0", (0, 0))],
)  # fmt: skip
def test_a_head_at_its_rim_is_no_pole(plane: str, b_c: tuple[float, float]) -> None:
    result = program(f"PLANE SPATIAL {plane} STAY SEQ+ TABLE ROT\nL B+Q121 C+Q122 R0 F MAX M126", DUO)
    assert not errors(result), result.findings
    assert result.words[-1, 4] == pytest.approx(b_c[0]) and (
        result.words[-1, 3] - b_c[1]
    ) % 360 == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("kinematics", [TRUNNION, MIXED])
def test_a_free_table_turns_with_the_plane_where_it_shall(kinematics: Chain) -> None:
    turning = f"L {kinematics.letters[4]}+Q12{'AB'.index(kinematics.letters[4])} C+Q122 FMAX"
    cuts = "L X+0 Y+0 Z+5 F300\nL X+10\n"
    table = program(f"PLANE SPATIAL SPA+0 SPB+0 SPC+90 STAY TABLE ROT\n{turning}", kinematics, (20, 0), cuts)
    assert table.words[-1, 3] == pytest.approx(90)
    np.testing.assert_allclose(
        table.words[-1, :3] - table.words[-2, :3], [10, 0, 0], atol=1e-9
    )  # the plane's X is the machine's
    for reported in ("COORD ROT", ""):
        stays = program(
            f"PLANE SPATIAL SPA+0 SPB+0 SPC+90 STAY {reported}\n{turning}", kinematics, (20, 0), cuts
        )
        assert stays.words[-1, 3] == pytest.approx(20)


def test_turn_with_table_rot_turns_the_free_table_too() -> None:
    result = program("PLANE SPATIAL SPA+0 SPB+0 SPC+90 TURN FMAX TABLE ROT")
    assert result.words[1, 3] == pytest.approx(90) and not errors(result)


def test_labels_formulas_and_jumps_read_the_angles() -> None:
    text = (
        "CALL LBL 7\nQ5 = Q120 * 2\nFN 12: IF +Q5 LT +50 GOTO LBL 9\nL A+Q120 C+Q122 FMAX\nFN 9: IF +0 EQU +0 GOTO LBL 8\n"
        "LBL 7\nPLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY SEQ+\nLBL 0\nLBL 9\nSTOP\nLBL 8"
    )
    result = program(text)
    lies(result, TRUNNION, (0, 0, 0), np.array([[1, 0, 0], [0, 0.75**0.5, -0.5], [0, 0.5, 0.75**0.5]]))
    notes = [found for found in result.findings if found.code == "plane-solution"]
    assert [found.line for found in notes] == [9]


def test_planes_that_add_turn_or_end_go_on_from_where_the_axes_stand() -> None:
    result = program(
        "PLANE SPATIAL SPA+10 SPB+0 SPC+0 STAY SEQ+\nPLANE RELATIV SPA+20 STAY SEQ+\nL A+Q120 C+Q122 FMAX\nL X+1 FMAX",
        cuts="",
    )
    assert result.words[-1, 4] == pytest.approx(30)
    result = program(
        "L C+270 FMAX\nL IC+80 FMAX\nPLANE SPATIAL SPA+0 SPB+0 SPC+0 STAY\nL C+Q122 A+Q120 FMAX\nL X+1 FMAX",
        cuts="",
    )
    assert result.words[-1, 3] == pytest.approx(350)
    result = program(
        "PLANE SPATIAL SPA+30 SPB+0 SPC+0 TURN FMAX\nPLANE RESET STAY\nL A+Q120 C+Q122 FMAX\nL X+1 FMAX",
        cuts="",
    )
    assert result.words[-1, 3:].tolist() == [0, 0] and not errors(result)


def test_what_leaves_them_unset_or_unreachable_is_named() -> None:
    before = program("L A+Q120 C+Q122 FMAX\nPLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY")
    assert any("Q120 was never set" in found.text and found.line == 3 for found in before.findings)
    unread = program("PLANE AXIAL B+30 STAY\nL A+Q120 C+Q122 FMAX")
    assert any("Q120 was never set" in found.text for found in unread.findings)
    never = program("PLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY\nQ5 = Q120")
    assert "plane-not-taken" in errors(never)
    steep = program(
        "PLANE SPATIAL SPA+130 SPB+0 SPC+0 STAY\nL A+Q120 C+Q122 FMAX\nCALL LBL 2\nM30\nLBL 2\nL X+4 F100\nLBL 0"
    )
    assert errors(steep)[0] == "axis-not-reachable" and "call-not-interpreted" not in errors(steep)
    other = program("PLANE SPATIAL SPA+30 SPB+0 SPC+0 STAY\nL B+Q121 C+Q122 FMAX")
    assert {"unknown-axis", "plane-not-taken"} <= set(errors(other))
