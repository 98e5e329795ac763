# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens' drilling cycles: by hand, against the same holes written in straight moves, and named where they
are not known."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from test_nc_cycles import errors, path
from test_nc_cycles import read as read_iso
from test_nc_planes import TRUNNION, poses
from test_nc_planes import read as read_on

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.reader import Assumed, codes, siemens_holes
from freecad_fiveaxis.core.nc.reader.lines import Lines
from freecad_fiveaxis.core.nc.reader.words import read_words

HEAD = "G71 G90 G94 G17 F100 S500 M3\nG0 X5 Y6 Z50 A0 C0\n"


def read(text: str) -> Program:
    return read_iso(HEAD + text, "siemens840d")


def same(one: Program, other: Program) -> None:
    """The same moves at the same feeds."""
    assert not errors(one) and not errors(other), (one.findings, other.findings)
    np.testing.assert_allclose(one.words, other.words, atol=1e-9)
    np.testing.assert_allclose(one.feed, other.feed, atol=1e-9)
    assert (one.motion == other.motion).all()


@pytest.mark.parametrize(
    ("cycle", "moves", "feeds"),
    [
        ("CYCLE81(10,0,2,-5)", "r2 f-5 r10", [100]), ("CYCLE81(10,0,2,,5)", "r2 f-5 r10", [100]),
        ("CYCLE81(10, 1, 2, -5, , 0, 0, 10)", "r3 f-5 r10", [100]), ("CYCLE81(10,0,2,-5,,0.5,0,1,10)", "r2 f-5 r10", [100]),
        ("CYCLE82(10,1,2,-5,6,1.5)", "r3 f-5 r10", [100]), ("CYCLE82(2*5,0,2,-(2+3))", "r2 f-5 r10", [100]),
        ("CYCLE83(10,0,2,-9,,-4,,0,,,1,1)", "r2 f-4 r2 r-3.4 f-8 r2 r-7.4 f-9 r10", [100] * 3),
        ("CYCLE83(10,0,2,-9,,-4,,0,,,1,1,,,,,2)", "r2 f-4 r2 r-2 f-8 r2 r-6 f-9 r10", [100] * 3),
        ("CYCLE83(10,0,2,-9,,,4,0,0,0,0.5,0)", "r2 f-4 f-3 f-8 f-7 f-9 r10", [50, 100, 100, 100, 100]),
        ("CYCLE83(10,0,2,-9,,,4,0,0,0,,0,,,0.25)", "r2 f-4 f-3.75 f-8 f-7.75 f-9 r10", [100] * 5),
        ("CYCLE83(10,0,2,-100,,-99,,0,,,,1)", "r2 f-99 r2 r-97 f-100 r10", [100] * 2),
        ("CYCLE84(10,0,2,-9,,0.1,3,,1.25,0,200,400)", "r2 f-9 f2 r10", [250, 500]), ("CYCLE84(10,0,2,-9,,,3,8)", "r2 f-9 f2 r10", [625, 625]),
        ("CYCLE84(10,0,2,-9,,,3,,-20,0,300,,,3)", "r2 f-9 f2 r10", [381, 381]), ("CYCLE840(10,0,2,-9,,,4,3,1)", "r2 f-9 f2 r10", [100, 100]),
        ("CYCLE840(10,0,2,-9,,,4,3,0,,1.5)", "r2 f-9 f2 r10", [750, 750]), ("CYCLE85(10,0,2,-9,,0.2,30,60)", "r2 f-9 f2 r10", [30, 60]),
        ("CYCLE85(10,0,2,-9)", "r2 f-9 f2 r10", [100, 100]), ("CYCLE86(10,0,2,-9,,0,3,0,0,0,45)", "r2 f-9 r10", [100]),
        ("CYCLE87(10,0,2,-9,,3)", "r2 f-9 r10", [100]), ("CYCLE88(10,0,2,-9,,1,4)", "r2 f-9 r10", [100]),
        ("CYCLE89(10,0,2,-9,,1)", "r2 f-9 f2 r10", [100, 100]),
    ],
)  # fmt: skip
def test_each_cycle_goes_down_and_out_in_its_own_way(cycle: str, moves: str, feeds: list[float]) -> None:
    program = read(f"N30 {cycle}\nG1 X9\n")
    assert path(program)[:-1] == [f"{one[0]} 5 6 {one[1:]}" for one in moves.split()]
    assert path(program)[-1] == "f 9 6 10" and program.feed[-1] == 100 and not errors(program)
    assert program.feed[1:-1][program.motion[1:-1] == program.motion[-1]] == pytest.approx(feeds)
    assert program.line.tolist() == [2, *[3] * (len(program.line) - 2), 4]


@pytest.mark.parametrize(
    ("values", "depths"),
    [
        ("-20,,,8,2", [-8, -14, -18, -20]), ("-21,,,8,2", [-8, -14, -18, -19.5, -21]), ("-15.2,,,8,-0.5", [-8, -12, -14, -15, -15.2]),
        ("-17,,,8,-0.5,,,,0,,3", [-8, -12, -15, -17]), ("-20,,,8,0", [-8, -16, -20]), ("-3,,,0.5,1", [-0.5, -1.5, -2.25, -3]),
        ("-5,,,9", [-5]),
    ],
)  # fmt: skip
def test_pecks_get_smaller_as_they_are_reported(values: str, depths: list[float]) -> None:
    program = read(f"CYCLE83(10,0,2,{values})\n")
    down = program.words[1:, 2][np.diff(program.words[:, 2]) < 0]
    down = down[1:]  # after the rapid to the safety clearance
    assert down[: len(depths)] == pytest.approx(depths)
    assert down[-1] == float(values.split(",")[0]) and (np.diff(down) < 1e-9).all()


def test_a_modal_cycle_runs_after_each_block_that_moves_until_mcall() -> None:
    modal = read(
        "MCALL CYCLE85(10,0,2,-9,,,30,60)\nX10 Y10\nM8\nG1 X20 F200\nS900\nG2 X30 I5 J0\nMCALL\nG0 X0\nCYCLE81(10,0,2,-5)\nX1\n"
    )
    hole = "G0 Z2\nG1 Z-9 F30\nZ2 F60\nG0 Z10\n"
    plain = (
        f"G0 X10 Y10\n{hole}G1 X20 F200\n{hole}G2 X30 I5 J0 F200\n{hole}G0 X0\nZ2\nG1 Z-5 F200\nG0 Z10\nX1\n"
    )
    same(modal, read(plain))
    assert {4, 6, 8, 10, 11, 12} == set(modal.line[1:].tolist())


def test_steps_inches_planes_and_what_was_in_force_stay() -> None:
    same(read("G91\nMCALL CYCLE81(10,0,2,-5)\nX1\nY1 C90\nMCALL\nG1 Z3\n"),
         read("G0 X6\nZ2\nG1 Z-5\nG0 Z10\nY7 C90\nZ2\nG1 Z-5\nG0 Z10\nG1 Z13\n"))  # fmt: skip
    same(read("G70\nCYCLE83(1,0,.1,-.5,,,.2,,,,,1)\nG1 X1\n"),
         read("G70\nZ.1\nG1 Z-.2\nG0 Z.1\nZ=-.2+.6/25.4\nG1 Z-.4\nG0 Z.1\nZ=-.4+.6/25.4\nG1 Z-.5\nG0 Z1\nG1 X1\n"
              .replace("=-.2+.6/25.4", f"{-0.2 + 0.6 / 25.4:.9f}").replace("=-.4+.6/25.4", f"{-0.4 + 0.6 / 25.4:.9f}")))  # fmt: skip
    same(read("G18\nCYCLE82(10,0,2,-5)\nG19\nMCALL CYCLE82(10,0,2,-5)\nZ3\n"),
         read("Y2\nG1 Y-5\nG0 Y10\nZ3\nX2\nG1 X-5\nG0 X10\n"))  # fmt: skip
    same(read("G95 F0.1\nCYCLE84(10,0,2,-9,,,3,,1.5)\n"), read("Z2\nG95 G1 Z-9 F1.5\nZ2\nG0 Z10\n"))


def test_values_by_parameters_are_worked_out_where_the_cycle_is_called() -> None:
    text = "R1=4 R2=-2\nAGAIN: MCALL CYCLE82(R1+6,0,2,R2*(1+ABS(R2)),,R5)\nX=R1\nMCALL\nR1=R1+1\nIF R1<6 GOTOB AGAIN\n"
    program = read("R5=1\n" + text)
    assert path(program) == [
        "r 4 6 50",
        "r 4 6 2",
        "f 4 6 -6",
        "r 4 6 10",
        "r 5 6 10",
        "r 5 6 2",
        "f 5 6 -6",
        "r 5 6 11",
    ]
    assert set(program.line[1:].tolist()) == {6} and not errors(program)
    unset = read(text)
    assert any("R5" in found.text and found.severity is Severity.ERROR for found in unset.findings)


def test_a_cycle_after_trans_and_in_a_tilted_plane_drills_along_its_axis() -> None:
    same(read("TRANS X1 Y2 Z-3\nX5 Y5\nCYCLE81(10,0,2,-5)\n"), read("X6 Y7\nZ-1\nG1 Z-8\nG0 Z7\n"))
    text = 'G71 G90 G94 F300\nG0 X0 Y0 Z100 A0 C0\nCYCLE800(0,"TC",0,57,1,2,3,30,0,0,0,0,0,1)\nMCALL CYCLE81(20,0,2,-5)\nX4 Y5 Z20\nX8\nMCALL\n'
    program = read_on(text, "siemens840d", TRUNNION)
    tip, axis = poses(program, TRUNNION)
    turn = Rotation.from_euler("x", 30, degrees=True).as_matrix()
    assert not errors(program), program.findings
    expected = [[4, 5, 20], [4, 5, 2], [4, 5, -5], [4, 5, 20], [8, 5, 20], [8, 5, 2], [8, 5, -5], [8, 5, 20]]
    np.testing.assert_allclose((tip[-8:] - [1, 2, 3]) @ turn, expected, atol=1e-9)
    np.testing.assert_allclose(axis[-8:], np.tile(turn[:, 2], (8, 1)), atol=1e-9)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        ("CYCLE84(10,0,2,-9,,,3,,1,0,200,200,,,,3,3,1)", "_VARI=3"), ("CYCLE84(10,0,2,-9,,,3,,1,0,200,200,,,,2)", "no _DAM"),
        ("CYCLE81(10,0,2,-5,,0,1,0,0)", "_GMODE=1"), ("CYCLE82(10,0,2,-5,,0,1)", "_GMODE=1"), ("CYCLE82(10,0,2,-5,,0,0,0,10,0,0,0,3,50)", "S_ZD=3"),
        ("CYCLE84(10,0,2,-9,,,3,,1,0,200,200,,,,1,-3,1)", "_DAM=-3"), ("CYCLE83(10,0,2,-9,,,4,,,,,2)", "VARI=2"), ("CYCLE83(10,0,2,-9)", "FDEP, FDPR"),
        ("CYCLE83(10,0,2,-9,,1)", "first depth"), ("CYCLE83(10,0,2,-9,,-4,5)", "FDEP and FDPR"), ("CYCLE83(10,0,2,-9,,,0.0001)", "too many pecks"),
        ("CYCLE81(10,0,2,-5,6)", "DP and DPR"), ("CYCLE81(10,0,2)", "no DP, DPR"), ("CYCLE81(10)", "no RFP"), ("CYCLE81(10,0,2,5)", "one below the other"),
        ("CYCLE81(-1,0,2,-5)", "one below the other"), ("CYCLE81(10,0,2,-5,,0,0,2,0)", "_DMODE=2"), ("CYCLE83(10,0,2,-20,,,8,-0.5)", "too many pecks"), ("CYCLE83(10,0,2,-9,,,4,,,,,1,1)", "_AXN=1"),
        ("CYCLE89(10,0,2,-5,,0,0,0,0,7)", "more values"), ("CYCLE81(10,0,2,-5,", ""), ("CYCLE81(10,0,2,A)", "no value"), ("CYCLE81(10,0,2,-5/0)", "no number"),
        ("CYCLE84(10,0,2,-9,,,3,7)", "MPIT=7"), ("CYCLE81(10,0,2,-99999999)", "beyond"), ("CYCLE81(10,0,2,1e5)", "not known"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("modal", ["", "MCALL "])
def test_what_is_not_known_of_a_cycle_is_named_and_drills_nothing(
    call: str, message: str, modal: str
) -> None:
    program = read(f"G1 X7\n{modal}{call}\nX9\n{modal}\nX8\n")
    found = [one for one in program.findings if one.severity is Severity.ERROR]
    assert message in found[0].text and found[0].line in (4, 5) and "post" in found[0].text
    assert path(program) == ["f 7 6 50", "f 9 6 50", "f 8 6 50"]


@pytest.mark.parametrize("text", ["CYCLE81(1,2)9", "MCALL CYCLE81(1,2)9\nX1", "CYCLE800(1)9\nX1"])
def test_digits_behind_a_call_are_not_read_as_a_part_of_it(text: str) -> None:
    """Such a line once made the number of the call ten times as large, and the reader fell."""
    with pytest.raises(ProgramError, match="9"):
        read(text)


def test_at_machine_positions_and_under_g93_a_cycle_is_named() -> None:
    program = read("MCALL CYCLE81(10,0,2,-5)\nG0 SUPA X1\nMCALL\nX2\n")
    assert [
        (found.line, "machine position" in found.text)
        for found in program.findings
        if found.severity is Severity.ERROR
    ] == [(4, True)]
    fixed = read("MCALL CYCLE81(10,0,2,-5)\nG75 X1\nMCALL\nG111 X3 Y3\nX2\n")
    assert "cycle-not-interpreted" in errors(fixed) and fixed.line.tolist() == [2, 7]
    assert errors(read("G93 G1 X1 F10\nCYCLE81(10,0,2,-5)\nG94\n")) == ["cycle-not-interpreted"]


def test_a_modal_call_of_something_else_ends_the_cycle_and_is_named() -> None:
    program = read("MCALL CYCLE81(10,0,2,-5)\nX1\nMCALL L10\nX2\nMCALL\nX3\n")
    assert path(program)[-3:] == ["r 1 6 10", "r 2 6 10", "r 3 6 10"] and errors(program) == [
        "call-not-interpreted"
    ]
    pattern = read("MCALL CYCLE81(10,0,2,-5)\nHOLES1(0,0,0,5,10,3)\nMCALL\nX1\n")
    assert errors(pattern) == ["cycle-not-interpreted"] and path(pattern) == ["r 1 6 50"]


def test_a_program_without_cycles_is_the_same_object_and_too_many_moves_are_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    words = read_words(HEAD.encode() + b"X1\n", "siemens")
    assert siemens_holes.holes_written_out(words, Lines(words, Assumed()), codes.SIEMENS)[0] is words
    monkeypatch.setattr(siemens_holes, "MOST", 5)
    with pytest.raises(Exception, match="line 6: the cycles make more than 5 moves; divide the program"):
        read("MCALL CYCLE81(10,0,2,-5)\nX1\nX2\nX3\nX4\n")


def test_cycle86_goes_aside_at_the_bottom_and_back_over_the_middle() -> None:
    program = read("G0 X5 Y6\nCYCLE86(10,0,2,-5,,0,3,-0.5,0.25,1,0)\nG1 X8\n")
    assert not errors(program), program.findings
    assert path(program)[-6:] == [
        "r 5 6 2",
        "f 5 6 -5",
        "r 4.5 6.25 -4",
        "r 4.5 6.25 2",
        "r 5 6 10",
        "f 8 6 10",
    ]
    along = read("G18 G0 X5 Z6\nCYCLE86(10,0,2,-5,,0,3,-0.5,0.25,0,0)\nG1 X8\n")
    assert path(along)[-4:-1] == ["r 5.25 -5 5.5", "r 5.25 2 5.5", "r 5 10 6"]


def test_cycle84_cuts_a_thread_in_infeeds() -> None:
    breaks = read("G0 X5 Y6\nCYCLE84(10,0,2,-9,,,3,,1.5,0,200,300,,,,1,4,0.5)\nG1 X8\n")
    assert not errors(breaks), breaks.findings
    assert path(breaks)[-8:-1] == [
        "f 5 6 -4",
        "f 5 6 -3.5",
        "f 5 6 -8",
        "f 5 6 -7.5",
        "f 5 6 -9",
        "f 5 6 2",
        "r 5 6 10",
    ]
    assert breaks.feed[-8:-2].tolist() == [300, 450, 300, 450, 300, 450]
    whole = read("G0 X5 Y6\nMCALL CYCLE84(10,0,2,-9,,,3,,1.5,0,200,200,,,,2,4,0.5)\nX7\nMCALL\nG1 X8\n")
    assert path(whole)[-8:-1] == [
        "f 7 6 -4",
        "f 7 6 2",
        "f 7 6 -8",
        "f 7 6 2",
        "f 7 6 -9",
        "f 7 6 2",
        "r 7 6 10",
    ]
