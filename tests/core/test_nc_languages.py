# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens, Heidenhain and guided ISO programs as other systems write them; damaged and hostile files in every
language."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from setup_examples import milled
from test_nc_reader import LINKS

from freecad_fiveaxis.core.base.errors import FiveAxisError, ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.cl_path import Motion

LANGUAGES = ("linuxcnc", "siemens840d", "heidenhain")


def read(text, controller):
    return read_nc(text if isinstance(text, bytes) else text.encode(), LINKS, DIALECTS[controller])


def codes_of(program, least=Severity.NOTE):
    return [found.code for found in program.findings if found.severity >= least]


def posed(program):
    return forward(LINKS, words_to_q(program.words))


S_HEAD = "G710 G90 G17\nG0 X0 Y0 Z0 A=0 C=0\n"


@pytest.mark.parametrize(
    "line",
    [
        "G1 X1 Y-2.5 A3 F100", "G1 X=1 Y=-2.5 A=3 F=100", "g1 x = 1.0 y=-2.5 a=3. f100", "N40 G01 X1Y-2.5A=3F100", "/N40 G1 X1 Y-2.5 A=3 F100",
        "G1 X=AC(1) Y=AC(-2.5) A=DC(3) F100", "G1 X=IC(1) Y=IC(-2.5) A=IC(3) F100 ; on (and) on", "G1 G64 SOFT FFWON X1 Y-2.5 A3 F100",
        "G1 X1 Y-2.5 A3 F100 CTOL=0.01 S3000 M3 D1", 'G1 X1 Y-2.5 A3 F100 M3 MSG("X9 (Y9)")', "START: G1 X1 Y-2.5 A=ACP(3) F100",
    ],
)  # fmt: skip
def test_every_way_to_write_a_siemens_block_reads_the_same(line):
    program = read(S_HEAD + line + "\n", "siemens840d")
    assert program.words[1].tolist() == [1, -2.5, 0, 0, 3]
    assert program.feed[1] == 100 and program.line.tolist() == [2, 3]
    assert [code for code in codes_of(program) if code not in ("block-skip", "rotary-direction")] == []


@pytest.mark.parametrize("line", ["G75 X0", "G74 X1=0 Z1=0", "N7 G75 FP=1 Z1=0"])
def test_a_fixed_point_of_siemens_ends_no_motion_mode(line):
    program = read(S_HEAD + "G1 X1 F100\n" + line + "\nX7\n", "siemens840d")
    assert program.words[:, 0].tolist() == [0, 1, 7] and "machine-position" in codes_of(program)


H_HEAD = "0 BEGIN PGM A MM\n1 L X+0 Y+0 Z+0 A+0 C+0 FMAX\n"


@pytest.mark.parametrize(
    "line",
    [
        "2 L X+1 Y-2.5 A+3 R0 F100", "2 L  X+1.0  Y-2.5  A+3  F100 M3 ; X9", "  2  l x1 y-2.5 a3 f100", "2LX+1Y-2.5A+3F100", "L X+1 Y-2.500 A+03. F100",
        "2 L IX+1 IY-2.5 IA+3 R0 F100", "/2 L X+1 Y-2.5 A+3 F100", "2 L\tX+1\tY-2.5\tA+3\tF100 M8", "/ 2 L X+1 Y-2.5 A+3 F100",
    ],
)  # fmt: skip
def test_every_way_to_write_a_heidenhain_block_reads_the_same(line):
    program = read(H_HEAD + line + "\n3 END PGM A MM\n", "heidenhain")
    assert program.words[1].tolist() == [1, -2.5, 0, 0, 3]
    assert program.feed[1] == 100 and program.line.tolist() == [2, 3]
    assert program.motion.tolist() == [Motion.RAPID, Motion.CUT]
    assert [code for code in codes_of(program) if code != "block-skip"] == []


def test_fmax_is_rapid_for_its_block_alone_and_f_stays():
    program = read(H_HEAD + "2 L X+1 F500\n3 L X+2 FMAX\n4 L X+3\n", "heidenhain")
    assert program.motion.tolist() == [3, 0, 3, 0] and program.feed.tolist() == [0, 500, 0, 500]


def test_inches_of_a_klartext_program_and_of_g70():
    assert read("0 BEGIN PGM A INCH\n1 L X+1 Y+0 Z+0 A+0 C+90 FMAX\n", "heidenhain").words[0].tolist() == [
        25.4,
        0,
        0,
        90,
        0,
    ]
    assert read("G700 G90\nG0 X1 Y0 Z0 A0 C90\nG710 G1 X2 F10\n", "siemens840d").words[:, 0].tolist() == [
        25.4,
        2,
    ]


TIPS = np.array([[0, 0, 50], [1, 2, 3], [4, -5, 6], [7, 8, 9.5]], float)
TURNS = np.array([[0, 0], [30, -20], [60, -10], [-45, 40]], float)  # C, A


def guided_texts():
    """One and the same guided path in every language, by rotary words and by vectors."""
    axis = forward(LINKS, np.column_stack([TIPS, np.radians(TURNS)]))[1]
    xyz = [f"X{x} Y{y} Z{z}" for x, y, z in TIPS.tolist()]
    ac = [f"A{a} C{c}" for c, a in TURNS.tolist()]
    vectors = [[f"{value:.9f}" for value in row] for row in axis.tolist()]

    def rows(first, others, reported):
        return "\n".join(
            f"{first if k == 0 else others} {place} {way}"
            for k, (place, way) in enumerate(zip(xyz, reported, strict=True))
        )

    ijk = ["I{} J{} K{}".format(*row) for row in vectors]
    abc = ["A3={} B3={} C3={}".format(*row) for row in vectors]
    txyz = ["TX{} TY{} TZ{}".format(*row) for row in vectors]
    return [
        ("fanuc", f"G21 G90 G94 F500\nG43.4 H1\n{rows('G0', 'G1', ac)}\nG49\nM30\n"),
        ("fanuc", f"G21 G90 G94 F500\nG43.5 H1\n{rows('G0', 'G1', ijk)}\nG49\nM30\n"),
        ("haas", f"G21 G90 G94 F500\nG234 H1\n{rows('G0', 'G1', ac)}\nG49\nM30\n"),
        ("linuxcnc", f"G21 G90 G94 F500\nM428\n{rows('G0', 'G1', ac)}\nM429\nM2\n"),
        ("siemens840d", f"G710 G90 F500\nTRAORI(1)\n{rows('G0', 'G1', ac)}\nTRAFOOF\nM30\n"),
        ("siemens840d", f"G710 G90 F500\nTRAORI\nORIWKS\n{rows('G0', 'G1', abc)}\nTRAFOOF\nM30\n"),
        ("heidenhain", f"BEGIN PGM A MM\nM128\nL F500\n{rows('L', 'L', ac)}\nM129\nEND PGM A MM\n"),
        (
            "heidenhain",
            f"BEGIN PGM A MM\nFUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR\nL F500\n{rows('LN', 'LN', txyz)}\nM30\n",
        ),
    ]


@pytest.mark.parametrize(("controller", "text"), guided_texts())
def test_the_same_guided_path_in_every_language_is_the_same_path(controller, text):
    program = read(text, controller)
    tip, axis = posed(program)
    assert np.abs(program.guided.tip - TIPS).max() == 0.0 and np.abs(tip - TIPS).max() < 1e-9
    assert np.abs(axis - forward(LINKS, np.column_stack([TIPS, np.radians(TURNS)]))[1]).max() < 1e-8
    assert codes_of(program, Severity.WARNING) == [] and "tip-guided-by-controller" in codes_of(program)


def test_where_the_guide_is_switched_the_same_pose_goes_on():
    text = "G21 G90 F500\nG0 X1 Y2 Z80 C0 A0\nM428\nG1 X5 Y6 Z7 C90 A10\nG1 C45\nM429\nG1 Z100\nM428\nG1 X1\nM2\n"
    program = read(text, "linuxcnc")
    assert program.guided.on.tolist() == [False, True, True, False, True]
    tip, _ = posed(program)
    assert tip[2] == pytest.approx([5, 6, 7])  # only C was told: the tip stays
    assert program.words[3, :2] == pytest.approx(program.words[2, :2])  # X and Y stay where the axes stood
    assert program.words[3, 2] == 100
    assert tip[4, 0] == pytest.approx(1) and tip[4, 1:] == pytest.approx(tip[3, 1:])


def test_a_length_offset_ends_the_guide_that_one_began_but_not_a_switch_of_kinematics():
    text = "G21 G90 F500\n{}\nG0 X0 Y0 Z50 A20 C30\nG49\nG43 H2\nG1 X1\nM429\nG1 X2\nM2\n"
    assert read(text.format("M428"), "linuxcnc").guided.on.tolist() == [True, True, False]
    assert read(text.format("G43.4 H1"), "fanuc").guided.on.tolist() == [True, False, False]


def test_vectors_stay_until_the_next_and_an_omitted_component_is_zero():
    text = "G21 G90 F500\nG43.5 H1\nG0 X0 Y0 Z50 I0 J0 K1\nG1 X1 J-1 K1\nX2\nX3 K1\nG49\nM30\n"
    _, axis = posed(read(text, "fanuc"))
    assert axis == pytest.approx(
        np.array([[0, 0, 1], [0, -(0.5**0.5), 0.5**0.5], [0, -(0.5**0.5), 0.5**0.5], [0, 0, 1]]), abs=1e-9
    )


@pytest.mark.parametrize(
    ("line", "code", "name"),
    [
        ("HOLES1(0,0,0,5,10,3)", "cycle-not-interpreted", "HOLES1"), ("MCALL CYCLE83(1)", "cycle-not-interpreted", "CYCLE83"), ("TRANS C10", "offset-not-interpreted", "TRANS"),
        ("HOLES2(0,0,10,0,60,6)", "cycle-not-interpreted", "HOLES2"), ("POCKET3(5,0,1,-9,9,9,1)", "cycle-not-interpreted", "POCKET3"), ("MCALL L10", "call-not-interpreted", "MCALL"),
        ("CYCLE81", "cycle-not-interpreted", "CYCLE81"), ("CYCLE802(111,1,9,9)", "cycle-not-interpreted", "CYCLE802"), ("G58 X5", "offset-not-interpreted", "G58"),
        ("SCALE X2", "offset-not-interpreted", "SCALE"), ("R1=R7", "macro-not-interpreted", "R7"), ("IF R1>5 GOTOF ENDE", "macro-not-interpreted", "ENDE"),
        ("CIP X1 Y1 Z9 I1=2 J1=3", "arc-not-interpreted", "CIP"), ("BSPLINE", "spline-not-interpreted", "BSPLINE"), ("WHATEVER(3)", "call-not-interpreted", "WHATEVER"),
        ("G1 AP=90", "polar-not-interpreted", "AP"), ("G1 X2 RP=IC(5)", "polar-not-interpreted", "RP"), ("AP=R1+5", "polar-not-interpreted", "AP"),
        ("DIAMON", "offset-not-interpreted", "DIAMON"), ("G1 A2=5 B2=7", "orientation-not-interpreted", "A2"), ("SUPA G0 Z500", "", ""), ("G1 A=ACN(5)", "rotary-direction", "A=ACN()"),
    ],
)  # fmt: skip
def test_what_siemens_text_is_not_interpreted_is_named_with_its_line(line, code, name):
    program = read(S_HEAD + "F100\nG1 X1\n" + line + "\nG1 X7\n", "siemens840d")
    found = [one for one in program.findings if one.code == code]
    assert (found and name in found[0].text and found[0].line == 5) or not code
    assert program.words[-1, 0] == 7 and 500 not in program.words[:, 2]


def test_words_beside_siemens_polar_coordinates_are_read():
    program = read(S_HEAD + "F100\nG1 X1\nG1 AP=90 RP=50 Z-3\nG1 X7\n", "siemens840d")
    assert program.words[-2, 2] == program.words[-1, 2] == -3.0


@pytest.mark.parametrize(
    ("line", "place"),
    [
        ("G91 X1 Y=AC(9)", (6, 9, 1)),
        ("G91 X=IC(1) Y=AC(-9) Z=AC(2.5)", (6, -9, 2.5)),
        ("G91 X1 Y9", (6, 14, 1)),
    ],
)
def test_siemens_ac_is_absolute_among_steps_too(line, place):
    program = read(S_HEAD + "F100\nG1 X5 Y5 Z1\n" + line + "\n", "siemens840d")
    assert program.words[-1, :3].tolist() == list(place)


def test_a_rotary_ac_among_steps_is_absolute():
    program = read(S_HEAD + "F100\nG1 X5 A10\nG91 A=AC(20)\nA5\n", "siemens840d")
    assert program.words[-2:, "XYZCA".index("A")].tolist() == [20.0, 25.0]


@pytest.mark.parametrize(
    ("line", "code", "name"),
    [
        ("5 CYCL DEF 251 POCKET ~\n Q200=+2 ;SET-UP ~\n Q201=-20 ;DEPTH", "cycle-not-interpreted", "CYCL DEF 251"), ("5 CYCL CALL", "cycle-not-interpreted", "CYCL CALL"),
        ("5 CALL LBL 1 REP 3", "macro-not-interpreted", "LBL 1 stands in no line"), ("5 PLANE SPATIAL SPA+10 SPB+0 SPC+0", "offset-not-interpreted", "PLANE SPATIAL"),
        ("5 CYCL DEF 7.1 #10", "offset-not-interpreted", "CYCL DEF 7.1"), ("5 TRANS DATUM TABLE TABLINE3", "offset-not-interpreted", "TRANS DATUM TABLE"), ("5 CYCL DEF 7.1 C+10", "offset-not-interpreted", "CYCL DEF 7"), ("5 Q1 = +Q5", "macro-not-interpreted", "Q5 was never set"), ("5 FN 18: SYSREAD Q1 = ID10", "macro-not-interpreted", "FN18:"),
        ("5 L X+Q1 F100", "macro-not-interpreted", "Q1 was never set"), ("5 CT X+3 Y+0", "arc-not-interpreted", "CT X+3"), ("5 FUNCTION TCPM F TCP AXIS SPAT PATHCTRL AXIS", "orientation", "FUNCTION TCPM"),
        ("5 L X+3 RL F100", "compensation-not-interpreted", "RL"), ("5 L X+3 FQ11", "feed-by-parameter", "FQ11"), ("5 L Z+500 R0 FMAX M91", "machine-position", "M91"),
        ("5 L X+3 M99", "cycle-not-interpreted", "M99"), ("5 WHATEVER 3", "unknown-code", "WHATEVER 3"),
    ],
)  # fmt: skip
def test_what_klartext_is_not_interpreted_is_named_with_its_line(line, code, name):
    program = read(H_HEAD + "3 L X+1 F100\n" + line + "\n7 L X+7\n", "heidenhain")
    found = [one for one in program.findings if one.code.startswith(code)]
    assert found and name in found[0].text and found[0].line == 4
    assert program.words[-1, 0] == 7 and 500 not in program.words[:, 2]


@pytest.mark.parametrize(
    "line",
    ["TOOL CALL 2 Z S5000", "TOOL DEF 2 L+0 R+5", "BLK FORM 0.1 Z X+0 Y+0 Z-40", "* - Roughing", "; note", "M3", "CYCL DEF 32.1 T0.01", "PLANE RESET STAY",
     "LBL 0", "STOP M0", "M126", "FUNCTION RESET TCPM"],
)  # fmt: skip
def test_harmless_klartext_is_passed_over(line):
    program = read(H_HEAD + "2 " + line + "\n3 L X+7 F100\n4 END PGM A MM\n", "heidenhain")
    assert program.words[:, 0].tolist() == [0, 7] and codes_of(program) == []


def test_a_text_of_another_language_than_reported_is_read_in_its_own_and_stated():
    program = read(H_HEAD + "2 L X+1 F100\n", "linuxcnc")
    assert program.words[1, 0] == 1 and codes_of(program) == ["other-language"]
    assert "other-language" in codes_of(read("G710 G90 F9\nTRAORI\nG1 X1 Y0 Z0 A0 C0\n", "fanuc"))


@pytest.mark.parametrize(
    ("controller", "name"), [("heidenhain_m128", "heidenhain"), ("siemens840d", "siemens840d"), ("fanuc", "")]
)
def test_a_text_whose_controller_nobody_has_stated_is_taken_as_its_own_signs_say(controller, name, tmp_path):
    posted = milled("trunnion_ac", controller=controller, feed_mode="g94", stepover=12.0, rings=6)
    (tmp_path / "a.nc").write_bytes(posted.nc)
    by_text, by_name = (
        job.run(build_settings("audit", str(tmp_path / "a.nc"), {"machine": "trunnion_ac"} | more))
        for more in ({}, {"controller": controller})
    )
    assert by_text.draft.dialect.name == (
        name or "linuxcnc"
    )  # a Fanuc program shows nothing that others have not
    assert ("read-as" in [finding.code for finding in by_text.findings]) == bool(name)
    assert np.array_equal(by_text.draft.program.seconds, by_name.draft.program.seconds) == bool(name), (
        "what F means"
    )


EXAMPLES = {
    "linuxcnc": "(p\u00e4rt)\nG21 G90\nG0 X0 Y0 Z0 A0 C0\n\tG01 X001.50 Y.5 F0100\nG1X2Y1A3\n",
    "siemens840d": "; p\u00e4rt\nG710 G90\nG0 X0 Y0 Z0 A=0 C=0\n\tG01 X=001.50 Y.5 F0100\nG1X2Y1A=3\n",
    "heidenhain": "0 BEGIN PGM P MM\n1 ; p\u00e4rt\n2 L X0 Y0 Z0 A0 C0 FMAX\n\t3 L X+001.50 Y+.5 F0100\n4 L X2Y1A3\n",
}


@pytest.mark.parametrize("controller", LANGUAGES)
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "latin-1", "mac_roman"])
@pytest.mark.parametrize("case", [str, str.lower])
def test_files_of_every_origin_read_the_same(controller, end, encoding, case):
    program = read(case(EXAMPLES[controller]).replace("\n", end).encode(encoding), controller)
    assert program.words.tolist() == [[0, 0, 0, 0, 0], [1.5, 0.5, 0, 0, 0], [2, 1, 0, 0, 3]]
    assert program.line.tolist() == [3, 4, 5] and codes_of(program) == []


@pytest.mark.parametrize("controller", LANGUAGES)
@pytest.mark.parametrize(
    "data", [b"\x00\x01\x02", "G0 X1\n".encode("utf-16"), b"G1 X1\n\x7fELF\x00", bytes(range(256))]
)
def test_a_binary_file_is_refused_in_one_line_with_line_and_column(controller, data):
    with pytest.raises(ProgramError, match=r"^line \d+, column \d+: .*plain text file$") as caught:
        read(data, controller)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("controller", "line", "where"),
    [
        ("siemens840d", "G1 X1..2", "line 3, column 4"), ("siemens840d", "N10 G1 X1,5", "line 3, column 10"), ("siemens840d", "G1 X=1 X=2", "line 3, column 8"),
        ("heidenhain", "2 L X+1,5,2", "line 3, column 5"), ("heidenhain", "2 L X+1 Y-", "line 3, column 9"), ("heidenhain", "2 L X+1 X+2", "line 3, column 9"),
    ],
)  # fmt: skip
def test_what_is_no_word_is_refused_with_line_and_column_in_every_language(controller, line, where):
    head = S_HEAD if controller == "siemens840d" else H_HEAD
    with pytest.raises(ProgramError) as caught:
        read(head + line + "\n", controller)
    assert where in str(caught.value)


def survives(text, controller):
    try:
        program = read_nc(text, LINKS, DIALECTS[controller])
        assert np.isfinite(program.words).all() and np.isfinite(program.seconds).all()
        assert program.guided is None or np.isfinite(program.guided.tip).all()
    except FiveAxisError as error:
        assert "\n" not in str(error)


@pytest.mark.parametrize("controller", LANGUAGES)
@settings(max_examples=150, deadline=None)
@given(data=st.binary(max_size=80))
def test_no_bytes_whatever_give_a_traceback(controller, data):
    survives(data, controller)


PIECES = {
    "linuxcnc": "G0 G1 G2 G3 G17 G18 G19 G20 G21 G28 G43.4 G43.5 G49 G53 G80 G81 G90 G91 G90.1 G93 G94 G234 M428 M429 M2 X1 X-9 Y2.5 Z3 A4 C500 "
    "I1 J2 K-1 R5 R-2 F1 F9999 #1=2 [ ] ( ) ; % / : , . - + 9999999999 E N10 O1 \n \n \n \t \r",
    "siemens840d": "G0 G1 G2 G3 G90 G91 G93 G94 G70 G71 G500 G505 G53 SUPA TRAORI TRAFOOF X1 X=2 X=AC(3) X=IC(4) A=DC(370) C=ACN(5) A3=1 B3=0 C3=-1 C3=0 "
    "CR=5 I=AC(2) I1 J2 R1=3 CYCLE81(1,2) MCALL IF GOTOF L1: ; MSG(\"a\") T=\"x\" ( ) = , $A \" F5 M30 / N5 9 . \n \n \n \t \r",
    "heidenhain": "L LN C CC CR CT L CP RND BEGIN PGM END MM INCH X+1 X-2.5 IX+3 IY-1 Y+2 Z9 A+400 IA-3 C+5 IC+1 TX+1 TY+0 TZ-1 TZ+1 NX+1 R0 RL RR DR+ DR- "
    "R+5 FMAX F500 FQ1 F AUTO Q1 = +5 FN 0: M128 M129 M91 M99 M30 FUNCTION TCPM RESET AXIS SPAT CYCL DEF 200 ~ TOOL CALL 1 ; * / 5 12 , \n \n \n \n \t \r",
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("controller", LANGUAGES)
@settings(max_examples=700, deadline=None)
@given(data=st.data())
def test_no_shuffled_program_gives_a_traceback(controller, data):
    words = [*PIECES[controller].split(" "), "\n"]
    pieces = data.draw(st.lists(st.tuples(st.sampled_from(words), st.sampled_from(["", " "])), max_size=40))
    survives("".join(word + blank for word, blank in pieces).encode(), controller)


@pytest.mark.parametrize("controller", LANGUAGES)
@settings(max_examples=150, deadline=None)
@given(place=st.integers(0, 400), byte=st.integers(0, 255), cut=st.integers(0, 3))
def test_one_wrong_byte_in_a_good_program_gives_no_traceback(controller, place, byte, cut):
    good = next(text for name, text in reversed(guided_texts()) if name == controller).encode()
    at = place % len(good)
    survives(good[:at] + bytes([byte]) + good[at + cut :], controller)


@pytest.mark.parametrize("controller", LANGUAGES)
def test_a_long_program_is_read_in_columns(controller):
    """Ten thousand lines in which the guide is switched on and off, and a great many blocks without: no line
    is lost."""
    block = {"linuxcnc": "G1 X{} F100\n", "siemens840d": "G1 X={} F100\n", "heidenhain": "L X+{} F100\n"}[
        controller
    ]
    head = {"linuxcnc": "G21 G90\nG0", "siemens840d": "G710 G90\nG0", "heidenhain": "BEGIN PGM A MM\nL"}[
        controller
    ]
    text = f"{head} X0 Y0 Z0 A0 C0\n" + "".join(block.format(k % 7) for k in range(100_000))
    program = read(text, controller)
    assert len(program.words) == 100_001 and program.line[-1] == 100_002
    assert program.words[1:, 0].tolist() == [k % 7 for k in range(100_000)]


KLARTEXT = "0 BEGIN PGM 1 MM\n1 L X+0 Y+0 Z+0 A+0 C+0 FMAX\n2 L X+5 F100\n"


@pytest.mark.parametrize(
    ("line", "places"),
    [("L M140 MB MAX", 2), ("M140 MB MAX", 2), ("L Z-1 R F MAX M91", 2), ("L X+6 R F MAX", 3)],
)
def test_klartext_with_blanks_in_its_words_is_read(line: str, places: int) -> None:
    program = read(f"{KLARTEXT}3 {line}\n", "heidenhain")
    assert len(program.words) == places and program.words[-1, 0] == (6 if places == 3 else 5)


def test_the_last_line_of_a_heidenhain_iso_program_is_its_name_once_more() -> None:
    text = "%123 G71 *\nN10 G00 G90 X+0 Y+0 Z+0 A+0 C+0*\nN20 G01 X+5 F100*\nN9999 % 123 G71\n"
    assert read(text, "heidenhain").words[:, 0].tolist() == [0, 5]


@pytest.mark.parametrize(
    ("first", "scale", "message"),
    [
        ("%123 G71 *", 1.0, True),
        ("% part1 G70*", 25.4, True),
        ("\n%G70 G70 *", 25.4, True),
        ("%G70 *", 1.0, False),
    ],
)
def test_the_first_line_of_a_heidenhain_iso_program_says_its_unit(
    first: str, scale: float, message: bool
) -> None:
    """A name may look like the unit's word where it begins right after the %."""
    program = read(
        f"{first}\nN10 G00 G90 X+0 Y+0 Z+0 A+0 C+0*\nN20 G01 X+5 A+3 F100*\nN9999 {first.strip()}\n",
        "heidenhain",
    )
    np.testing.assert_allclose(program.words[1, [0, 3, 4]], [5 * scale, 0, 3])
    assert ("units-not-said" in codes_of(program)) is not message


@pytest.mark.parametrize("line", ["M66E0L0", "M66 P0 L0", "M3 $0 S1", "(a (nested (twice)) comment X9)"])
def test_lines_of_linuxcnc_that_are_no_moves_are_read_without_a_word(line: str) -> None:
    program = read(f"G21 G90 G94 F100\nG0 X0 Y0 Z0 A0 C0\n{line}\nG1 X5\n", "linuxcnc")
    assert program.words[:, 0].tolist() == [0, 5] and program.findings == ()


def test_polar_words_are_stated_to_be_missing() -> None:
    program = read("G21 G90 G94 F100\nG0 X0 Y0 Z0 A0 C0\nG1 @5 ^30\nG1 X5\n", "linuxcnc")
    assert [found.code for found in program.findings] == ["macro-not-interpreted"]


@pytest.mark.parametrize(
    ("text", "cause"),
    [
        ("#1=5\nG1 X#5021\n", "variables"), ("%\nO\nG21\nG0 X0\n%\n", "no number"), ("PART ONE\nG21\nG0 X0\n", "before the program"),
    ],
)  # fmt: skip
def test_a_program_that_cannot_be_read_names_the_cause_and_the_remedy(text: str, cause: str) -> None:
    with pytest.raises(ProgramError, match=cause):
        read(text, "fanuc")
