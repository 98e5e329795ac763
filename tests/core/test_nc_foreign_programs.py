# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words of programs that other people's posts and hands write: none is passed over without a word."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import LINKS, errors, path, read

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.nc.reader import Assumed, read_nc

ISO = "G21 G90 G94 F100\nG0 X0. Y0. Z20. A0. C0.\n"
SIEMENS = "G71 G90 G94 F100\nG0 X0 Y0 Z20 A0 C0\n"
KLARTEXT = "BEGIN PGM A MM\nL X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n"


def codes_of(program) -> dict[str, int]:
    return {found.code: found.line for found in program.findings if found.severity is not Severity.NOTE}


@pytest.mark.parametrize(
    "text",
    [
        "L X+5 ~\n  Y+3 F100\nL Z+1 ~ \n ~\n  Y+4\n", "/ L X+5 ~\nY+3 F100\n; ~\nL Z+1 ~\nY+4\n",
        "CC X+0 ~\nY+0\nLP PR+5 ~\nPA+0 ~\nF100\nL Y+3\nL Y+4 ~\nZ+1 \n", "Q1=5\nL X+Q1 ~\n  Y+3 F100\nL Z+1 ~\n  Y+4\n",
    ],
)  # fmt: skip
def test_a_klartext_line_that_goes_on_moves_by_all_its_words(text: str) -> None:
    program = read(KLARTEXT + text + "END PGM A MM\n", "heidenhain")
    assert not errors(program) and path(program)[-1] == "f 5 4 1"
    assert path(program)[0] in ("f 5 3 20", "f 5 0 20") and (program.feed[1:] == 100).all()


def test_a_klartext_vector_in_the_next_line_turns_the_tool() -> None:
    text = "FUNCTION TCPM F TCP AXIS POS ~\nPATHCTRL VECTOR\nLN X+5 Y+2 Z+1 ~\nTX0 TY0.6 TZ0.8 F100\n"
    program = read(KLARTEXT + text + "END PGM A MM\n", "heidenhain")
    assert program.line.tolist() == [2, 5] and program.guided.vector[1].tolist() == [0, 0.6, 0.8]


def test_a_machine_position_by_supa_between_blocks_is_named_as_g53_is() -> None:
    text = "G1 Z1\n{} G0 Z0\nG0 X6 Y1\nZ5\nG1 Z1\n{} G0 Z0\nM30\n"
    supa, g53 = (read(SIEMENS + text.format(name, name), "siemens840d") for name in ("SUPA", "G53"))
    assert codes_of(supa) == codes_of(g53) == {"machine-position": 4}
    assert "SUPA" in str([found.text for found in supa.findings])
    retract = read(SIEMENS + "G1 Z1\nSUPA G0 Z0 D0\nM30\n", "siemens840d")
    assert codes_of(retract) == {}


def minutes(program) -> list[float]:
    return (program.seconds[1:] / 60.0).tolist()


def test_in_inches_f_of_rotary_axes_alone_is_in_degrees_a_minute() -> None:
    text = "G20 G90 G94\nG0 X0 Y0 Z0 A0 C0\nG1 A90. F45.\nX1. F10.\nG21 A0\nG20 A90. C90.\nM30\n"
    for controller in ("linuxcnc", "haas", "mach3", "fanuc"):
        program = read(text, controller)
        assert minutes(program) == pytest.approx([2.0, 0.1, 9.0, 9.0 * 2**0.5])
        assert program.feed[1:].tolist() == pytest.approx([45, 254, 10, 10])


def test_a_full_circle_in_inches_keeps_its_f() -> None:
    for controller in ("linuxcnc", "fanuc"):
        program = read("G20 G90 G94\nG0 X0 Y0 Z0 A0 C0\nG1 X1 F10.\nG2 I1. J0.\nM2\n", controller)
        assert program.seconds.sum() / 60 == pytest.approx(0.1 + 0.2 * np.pi, rel=1e-3)


def test_where_f_is_measured_over_all_axes_a_degree_counts_as_an_inch() -> None:
    """B-63324EN, 4.3: X and the angle make the way, each in the unit of F."""
    text = "G20 G90 G94\nG0 X0 Y0 Z0 A0 C0\nG1 X3. A4. F2.\nG21 X0 A0 F254\nM30\n"
    assert minutes(read(text, "fanuc")) == pytest.approx([2.5, np.hypot(76.2, 4.0) / 254.0])
    assert minutes(read(text, "haas")) == pytest.approx([1.5, 0.3])
    assert minutes(read(text.replace("G94", "G93"), "fanuc"))[0] == 0.5


def test_klartext_in_inches_has_f_in_tenths_of_an_inch() -> None:
    head = "BEGIN PGM A INCH\nTOOL CALL 1 Z S1000 F50\nL X+0 Y+0 Z+2 A+0 C+0 R0 FMAX\n"
    program = read(head + "L X+1\nL X+2 F100\nL A+90\nEND PGM A INCH\n", "heidenhain")
    assert program.feed[1:].tolist() == pytest.approx([127, 254, 100])
    assert minutes(program) == pytest.approx([0.2, 0.1, 0.9])


def length(program) -> float:
    return float(np.linalg.norm(np.diff(program.words[:, :3], axis=0), axis=1).sum())


def test_an_arc_of_linuxcnc_goes_round_as_often_as_p_says() -> None:
    text = "G1 Z0\nG2 X0 Y0 Z-6 I5 J0 P3\nG3 X10 Y0 R5 P2\nG2 X0 Y0 R5\nM2\n"
    way = 20 + 3 * np.hypot(10 * np.pi, 2) + 1.5 * 10 * np.pi + 5 * np.pi
    for controller in ("linuxcnc", "grbl"):
        assert length(read(ISO + text, controller)) == pytest.approx(way, abs=0.05)
    assert length(read(ISO + text, "fanuc")) == pytest.approx(
        20 + np.hypot(10 * np.pi, 6) + 10 * np.pi, abs=0.05
    )


def test_p_of_another_word_in_the_line_of_an_arc_is_no_turn() -> None:
    text = ISO + "{} G2 X0 Y0 I5 J0\nM2\n"
    for word in ("G64 P0.01", "M64 P3", "M67 E0 Q2", "G4 P3\n"):
        assert length(read(text.format(word), "linuxcnc")) == pytest.approx(10 * np.pi, abs=0.05)


@pytest.mark.parametrize("controller", ["linuxcnc", "grbl"])
@pytest.mark.parametrize("line", ["G43.1 Z100", "G43.1 X1 Z10", "G43.2 X1 Z10", "G43.2 H3"])
def test_the_words_of_a_length_are_no_move(controller: str, line: str) -> None:
    assert path(read(f"{ISO}{line}\nG0 X5\nG49\nX6\nM2\n", controller)) == ["r 5 0 20", "r 6 0 20"]


@pytest.mark.parametrize(
    ("controller", "line", "code"),
    [
        ("fanuc", "G51.1 X0. Y5.", "offset"), ("fanuc", "G51 X0. Y9. Z0. P2000", "offset"), ("fanuc", "G50.1 X0", "offset"),
        ("haas", "G101 X9.", "offset"), ("haas", "G143 H1", "offset"), ("fanuc", "G54.2 P1", "offset"), ("fanuc", "G43.1 H1", "offset"),
        ("mach3", "G68 X3 Y9 R30", "offset"), ("fanuc", "G7.1 C20.", "polar"), ("haas", "G107 A0 Y9. R2.", "polar"),
        ("haas", "G12 I5. D1", "cycle"), ("mach3", "G13 I5", "cycle"), ("haas", "G150 P1 X9. Z-5. R2. Q1. J1.", "cycle"), ("haas", "G47 P0 X9. Z-.1 J5.", "cycle"),
        ("haas", "G70 I10. J0. L4", "cycle"), ("haas", "G72 I10. J0. K5. L4", "cycle"), ("fanuc", "G31 Z-5. F50", "cycle"), ("fanuc", "G37 Z-5.", "cycle"),
        ("linuxcnc", "G5.1 I1 J3 X5 Y5", "spline"),
    ],
)  # fmt: skip
def test_what_turns_mirrors_scales_or_makes_a_pocket_is_an_error_and_its_words_are_no_move(
    controller: str, line: str, code: str
) -> None:
    program = read(f"{ISO}{line}\nG1 X6.\nM30\n", controller)
    assert errors(program) == [f"{code}-not-interpreted"]
    assert program.findings[[one.code for one in program.findings].index(errors(program)[0])].line == 3
    first = line.split()[0]
    assert first in next(one.text for one in program.findings if one.code.startswith(code))
    assert path(program)[-1] == ("f 6 5 20" if code == "spline" else "f 6 0 20")


def test_work_offsets_of_haas_are_known_and_a_second_one_is_named() -> None:
    one, two = (read(f"G110\n{ISO}{line}\nG1 X5.\nM30\n", "haas") for line in ("G110", "G129"))
    assert codes_of(one) == {} and list(codes_of(two)) == ["work-offset-change"]


def test_smoothing_of_fanuc_is_no_spline() -> None:
    assert codes_of(read(ISO + "G05.1 Q1 R3\nG1 X5.\nG05.1 Q0\nM30\n", "fanuc")) == {}


def test_a_second_work_offset_is_named_where_it_comes_into_force() -> None:
    program = read(f"G54\n{ISO}G1 X5.\nG54.1 P2 G0 X0\nG54\nG55\nX1.\nM30\n", "fanuc")
    (found,) = [one for one in program.findings if one.code == "work-offset-change"]
    assert found.line == 5 and "3 work offsets: G54 (1), G54.1 P2 (5), G55 (7)" in found.text


@pytest.mark.parametrize(
    ("controller", "text"),
    [
        ("fanuc", "G4 P500\nG1 X5.\nG4 X2.\nM30\n"), ("siemens840d", "G4 F2\nG1 X5\nG4 S30\nM30\n"),
        ("heidenhain", "CYCL DEF 9.0 DWELL\nCYCL DEF 9.1 DWELL 2\nL X+5 F100\nFUNCTION DWELL TIME3\nEND PGM A MM\n"),
    ],
)  # fmt: skip
def test_a_dwell_is_in_no_time_and_that_is_noted(controller: str, text: str) -> None:
    head = {"fanuc": ISO, "siemens840d": SIEMENS, "heidenhain": KLARTEXT}[controller]
    program = read(head + text, controller)
    (found,) = [one for one in program.findings if one.code == "dwell"]
    assert found.severity is Severity.NOTE and found.line == 3 and program.seconds.sum() == pytest.approx(3)


@pytest.mark.parametrize("line", ["/L X+5 F100", "/ L X+5 F100", "/14 L X+5 F100", "14 /L X+5 F100"])
def test_a_klartext_line_may_begin_with_block_skip_and_no_blank(line: str) -> None:
    for before in ("", "Q1=5\n"):
        text = before + line.replace("+5", "+Q1") if before else line
        program = read(f"{KLARTEXT}{text}\n/CC X+0 Y+0\n/C X-5 Y+0 DR+\nEND PGM A MM\n", "heidenhain")
        assert path(program)[0] == "f 5 0 20" and path(program)[-1] == "f -5 0 20"
        assert [one.code for one in program.findings] == ["block-skip"] and len(program.words) > 20


def test_klartext_arcs_lie_in_the_plane_across_the_tool() -> None:
    """DR+ goes with the right hand about the tool's axis: from X to -Z about Y, from Y to Z about X."""
    arcs = (
        ("Y", "X", "Z", -1.0),
        ('"F 8 Z" X S100', "Y", "Z", 1.0),
        ("5 Z", "X", "Y", 1.0),
        ("S500", "X", "Y", 1.0),
    )
    for call, first, second, sense in arcs:
        text = f"TOOL CALL {call}\nL {first}+10 {second}+0 F100\nCC {first}+0 {second}+0\nC {first}-10 {second}+0 DR+\n"
        program = read(KLARTEXT + text + "END PGM A MM\n", "heidenhain")
        middle = program.words[1 + (len(program.words) - 1) // 2]
        assert not errors(program)
        assert middle["XYZ".index(second)] * sense == pytest.approx(10.0, abs=0.01)


def test_what_klartext_measures_from_another_point_is_an_error() -> None:
    for line in (
        "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CENTER-CENTER",
        "M144",
        "L Z+20 FMAX M130",
    ):
        program = read(f"{KLARTEXT}L X+1 F100\n{line}\nL X+2 F100\nEND PGM A MM\n", "heidenhain")
        assert errors(program) == ["offset-not-interpreted"]
    tip = "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT TIP-TIP\n"
    assert not errors(read(f"{KLARTEXT}{tip}L X+2 F100\nEND PGM A MM\n", "heidenhain"))


def test_a_hole_along_another_axis_is_not_written_along_z() -> None:
    text = "TOOL CALL 5 {} S100\nCYCL DEF 200 DRILLING ~\nQ200=2 ~\nQ201=-3 ~\nQ206=150 ~\nQ202=4 ~\nQ203=0 ~\nQ204=9\nL X+5 FMAX M99\nEND PGM A MM\n"
    along_y = read(KLARTEXT + text.format("Y"), "heidenhain")
    assert errors(along_y) == ["cycle-not-interpreted"] and along_y.words[:, 2].tolist() == [20, 20]
    assert read(KLARTEXT + text.format("Z"), "heidenhain").words[:, 2].min() == -3


def test_f_under_g70_is_in_the_basic_system_of_the_control_and_under_g700_in_inches() -> None:
    text = "{} G90 G94\nG0 X0 Y0 Z0 A0 C0\nG1 X1 F254\nA90 F90\nMCALL CYCLE84(1,0,.1,-.9,,,,,2,,100)\nX2\nMCALL\nM30\n"
    metric, g700, g70, basic = (
        read_nc(text.format(unit).encode(), LINKS, DIALECTS["siemens840d"], assumed=Assumed(units=units))
        for unit, units in (("G70", "mm"), ("G700", "file"), ("G70", "file"), ("G70", "inch"))
    )
    assert minutes(metric)[:2] == pytest.approx([0.1, 1.0])
    for one in (g700, g70, basic):
        assert minutes(one)[:2] == pytest.approx([0.1 / 25.4, 1.0])
    (found,) = [one for one in g70.findings if one.code == "units-not-said"]
    assert found.line == 3 and "G700" in found.text
    others = (*g700.findings, *basic.findings, *metric.findings)
    assert {one.code for one in others}.isdisjoint({"units-not-said"})
    threads = [one.seconds[4:].sum() for one in (metric, g70, g700, basic)]
    assert np.ptp(threads) == pytest.approx(0.0, abs=1e-9), "a thread takes its pitch times the speed"


def test_an_axis_by_its_number_that_this_machine_has_not_is_an_error() -> None:
    program = read(SIEMENS + "G75 FP=1 Z1=0\nG1 X1=5 C1=-3.5\nG74 X1=0 Y1=0\nX2\nM30\n", "siemens840d")
    assert errors(program) == ["unknown-axis", "feed-from-machine-position"]
    (found,) = [one for one in program.findings if one.code == "unknown-axis"]
    assert found.line == 4 and "X1 (4)" in found.text and "C1 (4)" in found.text
    assert read(SIEMENS + "G1 Y1\nX1=5", "siemens840d").findings[-1].line == 4


def test_the_inclination_of_a_vector_is_an_error() -> None:
    text = ISO + "G43.5 H1\nG1 X1. Y0. Z0. I0 J0 K1.{}\nG49\nG83 X1. Z-1. R2. Q1.\nG80\nM30\n"
    assert errors(read(text.format(" Q2."), "fanuc")) == ["orientation-not-interpreted"]
    assert not errors(read(text.format(" Q0"), "fanuc")) and not errors(read(text.format(""), "fanuc"))


def test_f_of_grbl_in_inches_counts_mm_whatever_moves() -> None:
    """gcode.c of grbl-Mega-5X: values.f *= MM_PER_INCH."""
    program = read("G20 G90 G94\nG0 X0 Y0 Z0 A0 C0\nG1 A90. F10.\nX1. A0.\nM30\n", "grbl")
    assert minutes(program) == pytest.approx([90 / 254, np.hypot(25.4, 90) / 254])


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("G11 R+10 H+30", "polar"), ("G10 R+10 H+30", "polar"), ("G13 R+10 H+30", "polar"), ("G72 F0.9", "offset"),
        ("G25 R2", "arc"), ("G24 R2", "arc"),
    ],
)  # fmt: skip
def test_din_iso_of_heidenhain_is_named_where_it_is_not_moved(line: str, code: str) -> None:
    head = "%A G71 *\nN10 G30 G17 X+0 Y+0 Z-40*\nN20 G31 G90 X+100 Y+100 Z+0*\nN30 G00 G90 X+0 Y+0 Z+9 A+0 C+0*\n"
    program = read(f"{head}N40 G01 X+1 F100*\nN50 {line}*\nN60 G01 X+2*\nN99 %A G71*\n", "heidenhain")
    assert errors(program) == [f"{code}-not-interpreted"] and program.words[:, 0].tolist() == [0, 1, 2]
    assert next(one.line for one in program.findings if one.code.startswith(code)) == 6
    assert not any("G30" in one.text or "G31" in one.text for one in program.findings)


@pytest.mark.parametrize("controller", ["fanuc", "haas"])
def test_what_a_macro_writes_to_a_port_moves_nothing(controller: str) -> None:
    text = "POPEN\nN10 DPRNT[X#1[53]*AT*Y[#2]]\n/ BPRNT[C*X#100[3]]\n#1=3.\nG1 X#1\nDPRNT[]\nPCLOS\nM30\n"
    program = read(ISO + text, controller)
    assert path(program) == ["f 3 0 20"] and codes_of(program) == {}
    assert errors(read(ISO + "DPRNT[X#1] G1 X3\nG1 X5.\nM30\n", controller)) == ["macro-not-interpreted"]


@pytest.mark.parametrize(
    ("lines", "moves"),
    [
        ("MIRROR X0\nG1 X5 Y2", ["f 5 2 20"]), ("G1 X1\nASCALE X3 Y3\nX5", ["f 1 0 20", "f 5 0 20"]),
        ("G58 X5\nG1 X4", ["f 4 0 20"]), ("G1 X1\nG59 Y3\nX2", ["f 1 0 20", "f 2 0 20"]), ("AROTS X9 Y9\nG1 X2", ["f 2 0 20"]),
        ("TOFFL=1.5\nG1 X2", ["f 2 0 20"]), ("TOFFL[2]=-1 G1 X2", ["f 2 0 20"]), ("TOFF[Z]=0.5\nG1 X2", ["f 2 0 20"]),
    ],
)  # fmt: skip
def test_what_moves_or_scales_the_zero_of_siemens_is_an_error_and_no_move(
    lines: str, moves: list[str]
) -> None:
    program = read(SIEMENS + lines + "\nM30\n", "siemens840d")
    assert errors(program) == ["offset-not-interpreted"] and path(program) == moves


def test_a_tool_length_changed_by_nothing_is_no_error() -> None:
    assert codes_of(read(SIEMENS + "TOFFL=0 TOFFR=2\nG1 X2 OFFN=0\nM30\n", "siemens840d")) == {}


def test_a_thread_without_a_cycle_is_an_error_and_no_rapid() -> None:
    program = read(SIEMENS + "G331 Z-5 K1 S100\nG332 Z5 K1\nZ7\nG0 X5\nM30\n", "siemens840d")
    assert codes_of(program) == {"cycle-not-interpreted": 3} and path(program) == ["r 5 0 20"]


def test_a_semicolon_in_a_string_begins_no_comment() -> None:
    text = 'MSG("a;b") ; not "this\nG1 X5 ; nor "this;"\nT="D6;R1" D1\nX6\nM30\n'
    program = read(SIEMENS + text, "siemens840d")
    assert codes_of(program) == {} and path(program) == ["f 5 0 20", "f 6 0 20"]


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("R1=0\nIF R1==0 GOTOF AA\nG1 X5\nAA:G1 X6 Y1", "f 6 1 20"),
        ("R1=0\nAA: R1=R1+1\nG1 X=R1\nIF R1<3 GOTOB AA\nGOTO EE\nX99\nEE: M30", "f 3 0 20"),
        ("R1=2\nGOTOF AA\nG1 X5\nAA: IF R1>1\nG1 X7\nENDIF", "f 7 0 20"),
        ("R1=30\nG1 X=SIN(30)*10 Y=SQRT(16) Z=ABS(-3)\nX=R1*SIN(R1)", "f 15 4 3"),
        ("G91\nFOR R1=1 TO 3\nG1 X5\nENDFOR", "f 15 0 20"), ("FOR R1=3 TO 1\nG1 X5\nENDFOR\nG1 X=R1", "f 3 0 20"),
        ("DEF INT I\nFOR I=1 TO 2\nN5 FOR R2 = I TO 2*2\nG1 X=I Y=R2\nENDFOR\nENDFOR", "f 2 4 20"),
        ("R[1]=5\nG1 X=R1\nX=R[1]+1", "f 6 0 20"), ("G91\nN20 LAB: G1 X5\nY1\nN30 REPEATB LAB P=2", "f 15 1 20"),
        ("G91\nLAB: G1 X5\nY1\nN30 REPEAT LAB P=2\nZ1\nREPEAT N30", "f 25 5 22"), ("G91 G1\nAB:\nX5\nBC: Y1\nZ1\nREPEAT AB BC", "f 10 2 21"),
        ("G91 G1\nAB: X5\nENDLABEL:\nZ1\nREPEAT AB P=2", "f 15 0 21"), ("G91 G1 X1\nREPEAT AB BC P=2\nY1\nAB: X5\nBC: Z1", "f 16 1 23"),
        ("PROC MAIN SAVE DISPLOF\nG1 X5\nRET\nX9", "f 5 0 20"),
    ],
)  # fmt: skip
def test_loops_labels_and_functions_of_siemens_are_run(text: str, end: str) -> None:
    program = read(SIEMENS + text + "\nM30\n", "siemens840d")
    assert codes_of(program) == {} and path(program)[-1] == end


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("REPEAT AB P=2", "AB stands in no line"), ("CD: G1 X5\nREPEAT CD AB", "AB stands in no line"), ("CD: G1 X5\nREPEAT CD P=9999999", "more than 200000"),
        ("CD: GOTOF EE\nEE:\nREPEAT CD P=2", "jumps or repeats"), ("DEF REAL V[3]=(1,2,3)\nDEF INT I, K\nFOR I=1 TO V[1]\nG1 X=I\nENDFOR", "V[3]"),
        ("CASE R1 OF 1 GOTOF AA 2 GOTOF BB", "CASE"),
    ],
)  # fmt: skip
def test_lines_of_siemens_that_are_not_run_are_one_error_and_no_move(line: str, reason: str) -> None:
    """The rest of the program is read: no field and no loop refuses it."""
    program = read(SIEMENS + f"G1 Y1\n{line}\nY2\nM30\n", "siemens840d")
    (found,) = [one for one in program.findings if one.severity is Severity.ERROR]
    assert found.code == "macro-not-interpreted" and reason in found.text
    assert path(program)[0] == "f 0 1 20" and path(program)[-1].endswith(" 2 20")


def test_m99_of_the_main_program_goes_on_at_its_block() -> None:
    onward = read(ISO + "M99 P100\nG1 X5.\nN100 G1 X9.\nX8.\nM30\n", "fanuc")
    assert path(onward) == ["f 9 0 20", "f 8 0 20"] and codes_of(onward) == {}
    again = read(ISO + "N100 G1 X9.\n/M99 P100\nX8.\nM30\n", "fanuc")
    assert path(again) == ["f 9 0 20"]
    nowhere = read(ISO + "M99 P100\nG1 X5.\nM30\n", "fanuc")
    assert errors(nowhere) == ["call-not-interpreted"]


def test_a_call_of_mach3_says_by_q_how_often() -> None:
    text = ISO + "M98 P1000 Q2\nM30\nO1000\nG91\nG1 X5.\nG90\nM99\n"
    assert path(read(text, "mach3")) == ["f 5 0 20", "f 10 0 20"]
    assert "call-not-interpreted" in errors(read(text, "fanuc"))


def test_a_slash_between_words_switches_the_rest_off_and_is_read() -> None:
    program = read(ISO + "G1 X5. /2 Y3.\n/X6.\nX[10/2]\n#1=8/2\nX#1\nM30\n", "fanuc")
    assert path(program) == ["f 5 3 20", "f 6 3 20", "f 5 3 20", "f 4 3 20"] and errors(program) == []
    assert [(one.code, one.line) for one in program.findings] == [("block-skip", 4), ("block-skip", 3)]
    numbered = read(SIEMENS + "N10 /G1 X7\nR1=4\nX=R1/2\nM30\n", "siemens840d")
    assert path(numbered) == ["f 7 0 20", "f 2 0 20"]


def test_lines_for_the_control_of_grbl_are_no_blocks() -> None:
    text = "$X\n$H\nG1 X5\n$H\nG0 Z5\nX1 Y2 Z5 A0 C0\nG1 Z1\n$100=80\n$J=G91 X5 F9\n$G\nX4\nM30\n"
    program = read(ISO + text, "grbl")
    assert codes_of(program) == {"unknown-code": 10, "machine-position": 4}
    assert path(program)[0] == "f 5 0 20" and path(program)[-2:] == ["f 1 2 1", "f 4 2 1"]
    assert "$H" in str([one.text for one in program.findings])
    assert codes_of(read("$H\n$X\n" + ISO + "G1 X5\nM30\n", "grbl")) == {}


def test_two_slashes_are_a_comment_of_mach3() -> None:
    program = read(ISO + "//G1 X9\nG1 X5 // hi, (a\nX6\nM30\n", "mach3")
    assert path(program) == ["f 5 0 20", "f 6 0 20"] and program.findings == ()


@pytest.mark.parametrize(
    ("controller", "lines", "code"),
    [
        ("fanuc", "G112\nG1 X10.\nG113", "polar"), ("linuxcnc", "G7\nG1 X10.\nG8", "offset"), ("fanuc", "G51 X0 Y0 P2000\nG1 X10.\nG50", "offset"), ("linuxcnc", "G68 X0 Y0 R9.\nG1 X10.\nG69", "offset"),
        ("linuxcnc", "G10 L2 P1 R9\nG1 X10", "offset"),
    ],
)  # fmt: skip
def test_what_changes_the_meaning_of_x_is_one_error(controller: str, lines: str, code: str) -> None:
    program = read(f"{ISO}{lines}\nM30\n", controller)
    assert codes_of(program) == {f"{code}-not-interpreted": 3} and path(program)[-1] == "f 10 0 20"


def test_what_klartext_writes_and_strings_move_nothing() -> None:
    text = (
        'FN 14: ERROR = 1000\nFN 16: F-PRINT A.A / B.B\nFN 26: TABOPEN X\nQS1 = "A Q5"\nQ2 = 3\nL X+Q2 F100\n'
    )
    text += 'DECLARE STRING QS3 = "Q7"\nQ2 = TONUMB ( SRC_QS1 )\nQS2 = QS1 || "b"\nL Y+1\n'
    program = read(KLARTEXT + text + "END PGM A MM\n", "heidenhain")
    assert codes_of(program) == {} and path(program) == ["f 3 0 20", "f 3 1 20"]
    unknown = read(KLARTEXT + text + "L X+Q2\nEND PGM A MM\n", "heidenhain")
    assert errors(unknown) == ["macro-not-interpreted"] and "Q2 was never set" in str(unknown.findings)


def test_a_parameter_is_shown_as_it_is_and_without_noise() -> None:
    text = "Q1 = 0.1\nQ1 = Q1 + 0.2\nL X+Q1 F100\nFOO X-Q1\nQ2 = 100\nL Y+Q2\nEND PGM A MM\n"
    program = read(KLARTEXT + text, "heidenhain")
    assert "FOO X-0.3 " in str([one.text for one in program.findings]) and path(program)[-1] == "f 0.3 100 20"


def test_an_arc_of_fanuc_goes_round_as_often_as_l_says() -> None:
    """B-63324EN, 4.8: L is the count of turns, K the height of one."""
    arc = ISO + "G2 X10. Y0 Z-10. I5. J0 {} F100.\nM30\n"
    way = np.hypot(2.5 * 10 * np.pi, 30)
    for word in ("L3", "K12. L3"):
        program = read(arc.format(word), "fanuc")
        assert codes_of(program) == {} and length(program) == pytest.approx(way, abs=0.05)
    assert length(read(arc.format("L1"), "fanuc")) == pytest.approx(np.hypot(5 * np.pi, 30), abs=0.05)


def test_a_height_for_each_turn_that_an_arc_has_not_is_an_error() -> None:
    """Posts tell it for a turn or for a radian; K under G17 without a height is a lathe's program, without its G18."""
    arc = ISO + "G2 X10. Y0 Z-10. I5. J0 {} F100.\nM30\n"
    for word in ("K12.", "K0.5", "K-3.3333"):
        for controller in ("fanuc", "linuxcnc"):
            program = read(arc.format(word), controller)
            assert codes_of(program) == {"arc-not-interpreted": 3} and "G18" in str(program.findings)
    for word in ("K0", "K60.", "K-60.0", "K9.549", ""):
        assert codes_of(read(arc.format(word), "fanuc")) == {}
    turn = {"G17": "X10. Y0 I5. J0 K5.", "G18": "X10. Z20. I5. J5. K0", "G19": "Y10. Z20. I5. J5. K0"}
    for plane, words in turn.items():
        assert errors(read(f"{ISO}{plane} G3 {words}\nM30\n", "fanuc")) == ["arc-not-interpreted"]


@pytest.mark.parametrize(
    ("controller", "lines", "code", "end"),
    [
        ("haas", "G84.2 X5. Z-5. R1.\nX6.\nG80", "cycle", "r 0 0 20"), ("haas", "G174 X5. Z-5. S100", "cycle", "r 0 0 20"), ("haas", "G77 X5. Z-5. R1.", "cycle", "r 0 0 20"),
        ("fanuc", "G2.2 X9. I1. J0\nX7.", "arc", "f 7 0 20"), ("fanuc", "G3.4 X9. I1. J0\nX7.", "arc", "f 7 0 20"),
    ],
)  # fmt: skip
def test_curves_and_threads_of_other_forms_are_no_rapids(
    controller: str, lines: str, code: str, end: str
) -> None:
    program = read(f"{ISO}{lines}\nG0 Z21.\nM30\n", controller)
    assert errors(program) == [f"{code}-not-interpreted"] and path(program)[-1].endswith(" 21")
    assert path(program)[-2:-1] == ([end] if code == "arc" else [])


def test_a_return_by_g29_is_a_machine_position() -> None:
    program = read(ISO + "G30 P2 X0\nG29 X5.\nG0 X6.\nG1 X7.\nM30\n", "fanuc")
    assert codes_of(program) == {"machine-position": 3} and path(program) == ["r 6 0 20", "f 7 0 20"]


def test_the_depth_of_a_peck_without_a_point_is_noted() -> None:
    program = read(ISO + "G83 X5. Z-5. R1. Q2000\nG80\nM30\n", "fanuc")
    (found,) = [one for one in program.findings if one.code == "no-decimal-point"]
    assert found.line == 3 and "Q2000" in found.text


DIN = "%A G71 *\nN10 G00 G40 G90 X+0 Y+0 Z+20 A+0 C+0*\n"


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("N20 G98 L1*\nN30 G91 G01 X+5 F100*\nN40 G90*\nN50 L1,2*", "f 15 0 20"),
        ("N20 L5,0*\nN25 G00 Z+5 M2*\nN30 G98 L5*\nN31 G01 X+5 F100*\nN40 G98 L0*", "r 5 0 5"),
    ],
)  # fmt: skip
def test_din_iso_of_heidenhain_calls_its_labels(text: str, end: str) -> None:
    program = read(f"{DIN}{text}\nN99 %A G71*\n", "heidenhain")
    assert codes_of(program) == {} and path(program)[-1] == end


def test_centres_of_din_iso_are_absolute_and_stay() -> None:
    """A whole circle fits any centre: about one a radius aside it would be read without a word."""
    text = "N20 G01 X+10 F100*\nN30 G02 X+10 Y+0 I+5 J+0*\nN40 G03 X+0*\nN50 G03 X+0 Y+0*\nN60 G91 G02 X+10 Y+0 I+5 J+0*"
    program = read(f"{DIN}{text}\nN99 %A G71*\n", "heidenhain")
    assert codes_of(program) == {} and length(program) == pytest.approx(10 + 30 * np.pi, abs=0.1)
    assert (
        program.words[:, 0].min() == pytest.approx(0.0, abs=1e-6) and program.words[:, 0].max() <= 10.0 + 1e-6
    )


@pytest.mark.parametrize(
    ("lines", "code"),
    [
        ("N30 G80 A+30 B+0 C+0*", "offset"), ("N30 G73 G90 H+30*", "offset"), ("N30 G79*", "cycle"), ("N30 G83 P01 +2 P02 -20 P03 5*", "cycle"),
        ("N30 G01 G41 X+1*", "compensation"), ("N30 G06 X+1 Y+0*", "arc"), ("N30 G05 X+1 Y+0*", "arc"),
    ],
)  # fmt: skip
def test_what_din_iso_means_otherwise_is_an_error_and_turns_no_axis(lines: str, code: str) -> None:
    program = read(f"{DIN}N20 G01 X+1 F100*\n{lines}\nN40 X+2*\nN99 %A G71*\n", "heidenhain")
    assert codes_of(program) == {f"{code}-not-interpreted": 4}
    assert program.words[-1].tolist() == [2, 0, 20, 0, 0]


@pytest.mark.parametrize("line", ["WHILE Q1 < 3", "FOR Q1 = 1 TO 3", "ELSE", "END IF", "END WHILE"])
def test_a_loop_or_branch_that_klartext_does_not_know_is_an_error(line: str) -> None:
    program = read(f"{KLARTEXT}Q1 = 0\n{line}\nL X+1 F100\nEND PGM A MM\n", "heidenhain")
    assert codes_of(program) == {"macro-not-interpreted": 4}


def test_values_of_siemens_are_worked_out_without_any_variable() -> None:
    text = 'G1 X=5+3 Y=(2+3)*2 F=100*2\nX=-(3) Y=5-1\nX=IC(2*3) Y=AC(-3+1)\nMSG("a=(b)")\nC=DC(90+10)\nZ=SIN(90)\n'
    program = read(SIEMENS + text + "M30\n", "siemens840d")
    assert codes_of(program) == {} and path(program) == [
        "f 8 10 20",
        "f -3 4 20",
        "f 3 -2 20",
        "f 3 -2 20",
        "f 3 -2 1",
    ]
    assert (program.feed[1:] == 200).all() and program.words[-1, 3] == 100


def test_a_limit_of_the_speed_is_no_shift() -> None:
    assert codes_of(read(ISO + "G92 S3000\nG1 X5.\nM30\n", "fanuc")) == {}
    assert errors(read(ISO + "G92 X0 S3000\nG1 X5.\nM30\n", "fanuc")) == ["offset-not-interpreted"]
