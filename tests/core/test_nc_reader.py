# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC text to Program: words, modes, units, line numbers, and what is not interpreted."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bare_machines import BARE
from hypothesis import given, settings
from hypothesis import strategies as st

from freecad_fiveaxis.core.base.errors import FiveAxisError, ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.machine import Axis, Machine, load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.reader import Assumed, read_nc
from freecad_fiveaxis.core.toolpath.cl_path import Motion

ERROR, WARNING, NOTE = Severity.ERROR, Severity.WARNING, Severity.NOTE


def trunnion() -> Chain:
    x, y, z = (
        Axis(name, False, "head", tuple(row), max_rate=6000.0)
        for name, row in zip("XYZ", np.eye(3), strict=True)
    )
    c = Axis("C", True, "table", (0, 0, 1), max_rate=np.pi)
    a = Axis("A", True, "table", (1, 0, 0), max_rate=np.pi)
    return chain(Machine("trunnion", (c, a, x, y, z)), Setup())


LINKS = trunnion()
HEAD = b"G21 G90 G94 F100\nG0 X0 Y0 Z0 A0 C0\n"


def read(text: bytes) -> Program:
    return read_nc(text, LINKS, DIALECTS["linuxcnc"])


def kinds(program: Program) -> list[tuple[str, Severity]]:
    return [(found.code, found.severity) for found in program.findings]


def test_words_are_kept_in_the_machines_order_with_their_lines() -> None:
    program = read(b"G21 G90\n\n(a comment)\nG0 X1 Y2 Z3 A4 C5\nG1 X1.5 F100\n")
    assert program.letters == "XYZCA"
    assert program.words.tolist() == [[1, 2, 3, 5, 4], [1.5, 2, 3, 5, 4]]
    assert program.line.tolist() == [4, 5]
    assert program.motion.tolist() == [Motion.RAPID, Motion.CUT]
    assert program.feed.tolist() == [0, 100]
    assert program.row.tolist() == [-1, -1] and program.findings == ()


@pytest.mark.parametrize(
    "line",
    [
        b"G1X1.Y-2.5A+3F100", b"f100 a3 y-2.5 x1 g1", b"N10 G01 X1.0000 Y-2.5 A3. F100", b"\tG1\tX 1 Y - 2 . 5 A3 F100",
        b"G1 X01 Y-2.50 (feed) A3 F100 ; end", b"/G1 X1 Y-2.5 A3 F100", b"/2 N7 G1 X1 Y-2.5 A3 F100",
        b"G1 X1 Y-02.5 A3. F100.0 S3000 M3 T1 H1 D2 P3 Q1 L2", b"M8 G1 X1 Y-2.5 A3 F100 (one)(two)",
    ],
)  # fmt: skip
def test_every_way_to_write_a_block_reads_the_same(line: bytes) -> None:
    program = read(HEAD + line)
    assert program.words[1].tolist() == [1, -2.5, 0, 0, 3]
    assert program.feed[1] == 100 and program.motion[1] == Motion.CUT and program.line[1] == 3
    assert not [found for found in program.findings if found.severity > NOTE]


@pytest.mark.parametrize("end", [b"\n", b"\r\n", b"\r"])
@pytest.mark.parametrize("start", [b"", b"\xef\xbb\xbf"])
def test_every_line_ending_and_a_byte_order_mark_give_the_same_lines(end: bytes, start: bytes) -> None:
    program = read(start + (HEAD + b"G1 X1\n\nG1 X2\n").replace(b"\n", end))
    assert program.line.tolist() == [2, 3, 5]


def test_a_tape_between_percent_signs_is_read_and_no_more() -> None:
    program = read(b"\n%\nO1234 (PART)\n" + HEAD + b"G1 X1\nM30\n%\nG1 X99\n")
    assert program.words[-1, 0] == 1 and program.line.tolist() == [5, 6]
    assert ("text-after-end", NOTE) in kinds(program)


@pytest.mark.parametrize("end", [b"M2", b"M30", b"m02", b"M99"])
def test_nothing_after_the_end_of_the_program_is_read(end: bytes) -> None:
    program = read(HEAD + b"G1 X1\n" + end + b"\nG1 X2\n")
    assert len(program.words) == 2
    assert kinds(program) == [("text-after-end", NOTE)] and program.findings[0].line == 5


def test_modes_stay_until_another_comes() -> None:
    program = read(HEAD + b"G1 X1\nY2\nG0 Z3\nX4\nG1\nX5\n")
    assert program.motion.tolist() == [3, 0, 0, 3, 3, 0]
    assert program.words[:, 0].tolist() == [0, 1, 1, 1, 4, 5]


def test_incremental_words_add_up_and_absolute_ones_start_anew() -> None:
    program = read(HEAD + b"G91 G1 X1 A2\nX1\nG90 X10\nG91 X-0.5 C3\nX-0.5\n")
    assert program.words[:, 0].tolist() == [0, 1, 2, 10, 9.5, 9]
    assert program.words[:, 4].tolist() == [0, 2, 2, 2, 2, 2]
    assert program.words[:, 3].tolist() == [0, 0, 0, 0, 3, 3]


def test_inches_become_millimetres_and_degrees_and_inverse_times_stay() -> None:
    program = read(b"G20 G90\nG0 X0 Y0 Z0 A0 C0\nG1 X1 A90 F10\nG93 X2 F10\nG21 G94 X1 F10\n")
    assert program.words[:, 0].tolist() == [0, 25.4, 50.8, 1]
    assert program.words[1, 4] == 90
    assert program.feed.tolist() == [0, 254, 10, 10]
    assert program.inverse_time.tolist() == [False, False, True, False]


def test_times_are_what_the_words_say() -> None:
    program = read(HEAD + b"G1 X3 Y4\nG1 A30 C40\nG93 G1 X9 F2\nG0 X19 C41\n")
    assert program.seconds[1:] == pytest.approx(
        [60 * 5 / 100, 60 * 50 / 100, 30, max(60 * 10 / 6000, 60 * np.radians(1) / np.pi)]
    )
    assert program.seconds[0] == 0
    fanuc = read_nc(HEAD + b"G1 X20 C40 F300\n", LINKS, DIALECTS["fanuc"])
    assert fanuc.seconds[1] == pytest.approx(60 * 0.14907, rel=1e-4)  # B-63174EN, 4.2


def test_a_feed_dies_with_its_feed_mode_as_on_linuxcnc() -> None:
    program = read(HEAD + b"G93 G1 X1 F50\nG94 G1 X2\nG1 X3 F70\n")
    assert program.feed.tolist() == [0, 50, 0, 70]
    assert kinds(program) == [("no-feed", ERROR)] and program.findings[0].line == 4


def test_an_inverse_time_block_without_its_own_f_is_an_error() -> None:
    program = read(HEAD + b"G93 G1 X1 F50\nX2\n")
    assert kinds(program) == [("inverse-feed-missing", ERROR)] and program.findings[0].line == 4


def test_axes_that_the_first_block_does_not_name_are_stated_to_be_taken_as_zero() -> None:
    program = read(b"G21\nG0 X5 C7\nG1 Z3 F1\n")
    assert program.words.tolist() == [[5, 0, 0, 7, 0], [5, 0, 3, 7, 0]]
    assert kinds(program) == [("position-unknown", NOTE)] and "A, Y, Z" in program.findings[0].text


@pytest.mark.parametrize(
    ("line", "code", "severity"),
    [
        (b"G2 X1 I1 J0", "arc-without-centre", ERROR),
        (b"G03 X100 R5", "arc-without-centre", ERROR),
        (b"G2 X5 Y1", "arc-without-centre", ERROR),
        (b"G87 X1 Z-1 R2", "cycle-not-interpreted", ERROR),
        (b"G5.2 X1 P1 L3", "spline-not-interpreted", ERROR),
        (b"#1=#5221", "macro-not-interpreted", ERROR),
        (b"G1 X[#5420+2]", "macro-not-interpreted", ERROR),
        (b"GOTO 10", "macro-not-interpreted", ERROR),
        (b"M98 P1000", "call-not-interpreted", ERROR),
        (b"G65 P9000 X1", "call-not-interpreted", ERROR),
        (b"G10 L2 P1 X5", "offset-not-interpreted", ERROR),
        (b"G92 X0", "offset-not-interpreted", ERROR),
        (b"G68 X0 Y0 R30", "offset-not-interpreted", ERROR),
        (b"G253", "offset-not-interpreted", ERROR),
        (b"G53.1", "offset-not-interpreted", ERROR),
        (b"G41 D1", "compensation-not-interpreted", ERROR),
        (b"G28 Z0", "machine-position", WARNING),
        (b"G91 G30 Z0", "machine-position", WARNING),
        (b"G53 G0 Z0", "machine-position", WARNING),
        (b"G95 G1 X1 F0.1", "feed-per-turn", WARNING),
        (b"G123", "unknown-code", WARNING),
        (b"G1 B3", "unknown-axis", ERROR),
        (b"G1 X1 I0 J0 K1", "word-not-interpreted", WARNING),
        (b"/G1 X1", "block-skip", NOTE),
        (b"G55", "work-offset-change", WARNING),
    ],
)
def test_what_is_not_interpreted_is_a_finding_with_its_line(
    line: bytes, code: str, severity: Severity
) -> None:
    program = read(b"G54\n" + HEAD + b"G1 X3\n" + line + b"\nG1 X7\n")
    found = [finding for finding in program.findings if finding.code == code]
    assert found and found[0].severity is severity
    assert found[0].line in (5, 3)  # work offsets: the first motion line
    assert program.words[-1, 0] == 7 or b"G91" in line


@pytest.mark.parametrize(
    ("word", "named"), [(b"D0", False), (b"D00", False), (b"D1", True), (b"", True), (b"\nD0", True)]
)
def test_a_compensation_by_d0_is_none(word: bytes, named: bool) -> None:
    program = read(HEAD + b"G41 G1 X3 " + word + b"\nG1 X7\nG40\n")
    assert ("compensation-not-interpreted" in [found.code for found in program.findings]) is named


def test_a_full_circle_needs_no_word_of_an_axis() -> None:
    program = read(HEAD + b"G2 I1 J0\nG1 X5\n")
    assert len(program.words) > 50 and program.words[1:-1, 0].max() == pytest.approx(2, abs=0.002)
    assert program.words[-2, :2] == pytest.approx([0, 0], abs=1e-9) and program.findings == ()


def test_an_arc_without_a_centre_is_taken_as_straight_and_a_cycle_left_out() -> None:
    program = read(HEAD + b"G2 X1 I1 J0\nX2 I1\nG87 X5 Z-1 R2\nX6\nG80\nG1 X7\n")
    assert program.words[:, 0].tolist() == [0, 1, 2, 7]
    assert not [
        found for found in program.findings if found.code == "word-not-interpreted" and "I" in found.text
    ]


def test_moves_to_machine_positions_and_dwells_are_no_blocks() -> None:
    assert len(read(HEAD + b"G28 Z0\nG53 G0 Z0\nG4 X1.5\nG10 L2 P1 X1\n").words) == 1


def test_axis_words_before_any_motion_code_are_stated_to_be_taken_as_g1() -> None:
    program = read(b"G21 F100\nX1 Y0 Z0 A0 C0\nG1 X2\n")
    assert kinds(program) == [("no-motion-code", WARNING)] and program.motion[0] == Motion.CUT


def test_a_program_that_says_no_units_gets_a_note() -> None:
    assert kinds(read(b"G0 X0 Y0 Z0 A0 C0\nG1 X1 F1\n")) == [("units-not-said", WARNING)]


@pytest.mark.parametrize(
    ("line", "where"),
    [
        (b"G1 X1,5", "line 3, column 6"), (b"G1 X", "line 3, column 4"), (b"G1 X1.2.3", "line 3, column 4"),
        (b"G1 X1-2", "line 3, column 6"), (b"5 G1 X1", "line 3, column 1"), (b"G1 X1e-5", "line 3, column 6"),
        (b"G1 (open", "line 3, column 4"), (b"G1 X1) Y2", "line 3, column 6"), (b"G1 X--1", "line 3, column 6"),
        (b"HELLO", "line 3, column 1"), (b"G1 X1 X2", "line 3, column 7"), (b"G1 X" + b"9" * 400, "line 3, column 4"), (b"G1 Y2 X123456789", "line 3, column 7"),
        (b"L X+1 FMAX", "line 3, column 1"), (b"G1 X\xe9", "line 3, column 5"), (b"  G1   Y  .", "line 3, column 8"),
    ],
)  # fmt: skip
def test_what_is_no_word_is_refused_with_line_and_column(line: bytes, where: str) -> None:
    with pytest.raises(ProgramError) as caught:
        read(HEAD + line + b"\nG1 X2\n")
    assert where in str(caught.value)


@pytest.mark.parametrize(
    "text",
    [
        b"",
        b"\n\n",
        b"(only a comment)",
        b"M30\n",
        b"G0\nG1 F5\n",
        b"T1 M6\nS1000 M3\n",
        b"M2\nG0 X1\n",
        b"G1 B5 F1\n",
    ],
)
def test_a_text_without_motion_is_refused(text: bytes) -> None:
    with pytest.raises(ProgramError, match="no motion blocks"):
        read(text)


@pytest.mark.parametrize(
    "data", [b"\x00\x01\x02", b"G0 X1\x00", bytes(range(256)), "G0 X1\n".encode("utf-16")]
)
def test_a_binary_file_is_refused(data: bytes) -> None:
    with pytest.raises(ProgramError, match="text file"):
        read(data)


@settings(max_examples=300, deadline=None)
@given(st.binary(max_size=80))
def test_no_bytes_whatever_give_a_traceback(data: bytes) -> None:
    try:
        read(data)
    except FiveAxisError as error:
        assert "\n" not in str(error)


@settings(max_examples=500, deadline=None)
@given(st.text(alphabet="GXYZACFNMO0123456789.-+ ()%/;\n\r#[]=:BIR", max_size=60))
def test_no_text_of_nc_characters_gives_a_traceback(text: str) -> None:
    try:
        program = read(text.encode())
        assert np.isfinite(program.words).all() and np.isfinite(program.seconds).all()
    except FiveAxisError as error:
        assert "\n" not in str(error)


def test_a_plain_reader_of_one_line_at_a_time_finds_the_same_words() -> None:
    random = np.random.default_rng(5)
    position, lines, expected = dict.fromkeys("XYZCA", 0.0), [HEAD.decode().strip()], [[0.0] * 5]
    for _ in range(500):
        chosen = [letter for letter in "XYZCA" if random.random() < 0.5] or ["X"]
        for letter in chosen:
            position[letter] = float(f"{random.normal(0, 100):.4f}")
        random.shuffle(chosen)
        lines.append(" ".join(["G1", *(f"{letter}{position[letter]:.4f}" for letter in chosen)]))
        expected.append([position[letter] for letter in "XYZCA"])
    assert read("\n".join(lines).encode()).words.tolist() == expected


@pytest.mark.parametrize("line", [b"G4 P0.1 G1 X5 Y5 F10", b"G1 G4 P0.1 X5 Y5 F10", b"F10\nG1\nG04 P1 X5 Y5"])
def test_a_dwell_takes_its_time_and_leaves_the_move_and_its_feed(line: bytes) -> None:
    program = read(HEAD + line + b"\nX6\n")
    assert program.words[1:, :2].tolist() == [[5, 5], [6, 5]] and program.feed[1:].tolist() == [10, 10]


@pytest.mark.parametrize("controller", DIALECTS)
def test_a_dwell_alone_is_no_move_and_no_feed(controller: str) -> None:
    times = {"iso": (b"P2", b"X2.5", b"U7", b"P500"), "siemens": (b"F2", b"S30"), "heidenhain": (b"F2",)}
    for time in times[DIALECTS[controller].language]:
        program = read_nc(HEAD + b"G1 X1 F100\nG4 " + time + b"\nG1 X2\n", LINKS, DIALECTS[controller])
        assert program.words[:, 0].tolist() == [0, 1, 2] and program.feed.tolist() == [0, 100, 100]


@pytest.mark.parametrize("word", [b"I99999999999999999999", b"R1000000000", b"J-88888888 I1"])
def test_an_arc_whose_centre_is_beyond_any_machine_is_refused_with_its_place(word: bytes) -> None:
    with pytest.raises(ProgramError, match=r"line 3, column [0-9]+: [IJR].* is beyond"):
        read(HEAD + b"G2 X1 Y1 " + word + b"\n")


FAR_AXIS = b"""0 BEGIN PGM 1 MM
1 FUNCTION TCPM F TCP AXIS POS PATHCTRL VECTOR
2 LN X+0 Y+0 Z+80 TX+0 TY+0 TZ+1 FMAX
3 LN X+1 Y+19 Z+10 TX-0.1765610 TY+0.2881214 TZ-1 F1000
4 LN X+2 TX-0.18 TY+0.28 TZ+0.94
5 END PGM 1 MM
"""


@pytest.mark.parametrize("machine", BARE)
def test_an_axis_beyond_the_limits_comes_to_an_end_and_stands_where_it_is_reported(machine: str) -> None:
    kinematics = chain(load_machine(machine), Setup((0.0, 0.0, 0.0), 100.0))
    program = read_nc(FAR_AXIS, kinematics, DIALECTS["heidenhain"])
    lost = [found for found in program.findings if found.code == "axis-not-reachable"]
    reported = np.array([[0, 0, 1], [-0.1765610, 0.2881214, -1], [-0.18, 0.28, 0.94]])
    reported /= np.linalg.norm(reported, axis=1)[:, None]
    off = np.linalg.norm(forward(kinematics, words_to_q(program.words))[1] - reported, axis=1)
    assert off[[0, 2]].max() < 1e-9 and (off[1] < 1e-9 or lost)


def test_a_vector_that_only_leads_beyond_the_limits_comes_to_an_end_in_iso_too() -> None:
    kinematics = chain(load_machine("fork_head_bc"), Setup((0.0, 0.0, 0.0), 100.0))
    text = b"G21 G90 G94\nG43.5 H1\nG1 X0 Y0 Z50 I0 J0 K1 F500\nX1 I-0.1765610 J0.2881214 K-1\nX2 I-0.18 J0.28 K0.94\n"
    assert len(read_nc(text, kinematics, DIALECTS["fanuc"]).words) == 3


@pytest.mark.parametrize("controller", ["haas", "linuxcnc", "fanuc"])
def test_the_machine_file_rules_how_a_rotary_word_is_taken(controller: str) -> None:
    text = b"G21 G90 G94 F100\nG0 X0 Y0 Z0 A0 C350\nG1 C359.857\nC7.501\n"
    by_file = {}
    for wrap in ("modulo", "unwound", "rezero"):
        axes = tuple(replace(axis, wrap=wrap) if axis.rotary else axis for axis in LINKS.axes)
        by_file[wrap] = read_nc(text, replace(LINKS, axes=axes), DIALECTS[controller])
    assert np.diff(by_file["modulo"].words[:, 3]).tolist() == pytest.approx([9.857, 7.644])
    for wrap in ("unwound", "rezero"):
        assert by_file[wrap].words[:, 3].tolist() == [350, 359.857, 7.501]
        assert ("wrap-contradicted", WARNING) in kinds(by_file[wrap])
    message = [found for found in by_file["modulo"].findings if found.code == "wrap-contradicted"]
    assert len(message) == (0 if controller == "fanuc" else 1) and all(
        "only if it is set" in one.text for one in message
    )


def test_words_that_count_on_contradict_a_machine_file_that_says_modulo() -> None:
    axes = tuple(replace(axis, wrap="modulo") if axis.rotary else axis for axis in LINKS.axes)
    program = read_nc(HEAD + b"G1 C200\nC400\nC700\n", replace(LINKS, axes=axes), DIALECTS["haas"])
    assert ("wrap-contradicted", WARNING) in kinds(program) and program.words[:, 3].tolist() == [
        0,
        -160,
        -320,
        -380,
    ]


UNSAID = b"G90 G94\nG0 X0 Y0 Z0 A0 C0\nG1 X10 A90 F40\nG2 X12 Y0 I1 J0\n"


def test_units_that_nobody_stated_are_a_warning_that_weighs_size_and_feed() -> None:
    (doubted,) = [found for found in read(UNSAID).findings if found.code == "units-not-said"]
    assert doubted.severity is WARNING and "rather those of inches" in doubted.text and "12" in doubted.text
    (taken,) = [
        found for found in read(UNSAID.replace(b"F40", b"F900")).findings if found.code == "units-not-said"
    ]
    assert "taken as mm" in taken.text and "rather those" not in taken.text and "--units" in str(taken.text)


@pytest.mark.parametrize(
    ("mode", "message"),
    [("G93", "No F is per minute"), ("G95", "No F is per minute"), ("G94", "at F up to 900")],
)
def test_an_f_that_is_not_per_minute_says_nothing_of_the_units(mode: str, message: str) -> None:
    program = read(UNSAID.replace(b"G94", mode.encode()).replace(b"F40", b"F900").replace(b"J0", b"J0 F900"))
    (found,) = [found for found in program.findings if found.code == "units-not-said"]
    assert message in found.text and "up to 0" not in found.text
    assert "moves 90 mm" not in found.text and "moves 12 mm" in found.text


@pytest.mark.parametrize(("units", "scale"), [("mm", 1.0), ("inch", 25.4)])
def test_units_that_are_reported_hold_where_the_program_says_none(units: str, scale: float) -> None:
    program = read_nc(UNSAID, LINKS, DIALECTS["linuxcnc"], assumed=Assumed(units))
    assert program.words[1].tolist() == [10 * scale, 0, 0, 0, 90] and program.feed[1] == pytest.approx(
        40 * scale
    )
    assert program.words[-1, 0] == pytest.approx(12 * scale)
    top = program.words[2:, 1].max()
    assert top == pytest.approx(scale, rel=1e-2)  # the arc is of radius 1 in the same units
    assert "units-not-said" not in [found.code for found in program.findings]
    message = read_nc(b"G21 " + UNSAID, LINKS, DIALECTS["linuxcnc"], assumed=Assumed(units))
    assert message.words[1, 0] == 10  # what the program says goes before


BARE = b"O1\nG21 G90 G94\nG0 X0 Y0 Z10\nA0 C0\nG1 X100 Y50. Z0 F1000\nX150 A10 C5\nM30\n"


@pytest.mark.parametrize("controller", DIALECTS)
def test_words_without_a_point_are_counted_where_the_controller_may_take_them_for_increments(
    controller: str,
) -> None:
    found = [
        one for one in read_nc(BARE, LINKS, DIALECTS[controller]).findings if one.code == "no-decimal-point"
    ]
    assert len(found) == (controller in ("fanuc", "haas"))
    for one in found:
        assert (
            (one.severity, one.value, one.line) == (NOTE, 5.0, 3)
            and "Z10 is 10" in one.text
            and "0.01" in one.text
        )


@pytest.mark.parametrize(("head", "step"), [(b"G21", 1e-3), (b"G20", 25.4e-4)])
def test_least_increments_are_thousandths_of_a_millimetre_and_a_degree_or_ten_thousandths_of_an_inch(
    head, step
) -> None:
    program = read_nc(
        BARE.replace(b"G21", head), LINKS, DIALECTS["haas"], assumed=Assumed(decimal="least-increment")
    )
    inch = 25.4 if head == b"G20" else 1.0
    assert program.words[-1] == pytest.approx([150 * step, 50 * inch, 0, 0.005, 0.01])
    assert program.feed[-1] == pytest.approx(1000 * inch)  # F is no word of a place
    assert "no-decimal-point" not in [found.code for found in program.findings]
