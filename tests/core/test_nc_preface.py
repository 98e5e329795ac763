# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands around a program and is none of it is a finding, not a refusal; what could move something is
never taken for it."""

from __future__ import annotations

import pytest
from test_nc_cycles import path, read

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Severity

BODY = "G21 G90 G94\nG0 X0. Y0. Z20. A0. C0.\nG1 X5. F100\nM30\n"
LISTING = (
    "====================\nInformation listing created by :  me\nDate                           :  1.1.2020 10:00:00\n"
    "Current work part              :  C:\\parts\\one.prt\nNode name                      :  here\n====================\n"
)


@pytest.mark.parametrize(
    ("text", "line", "severity"),
    [
        ("%\nO NONAME\n" + BODY + "%\n", 2, Severity.WARNING), ("%\nOFinal ToolPath\n" + BODY, 2, Severity.WARNING),
        ("O ENTER OP\n" + BODY, 1, Severity.WARNING), (LISTING + "\n%\nO1\n" + BODY + "%\n", 1, Severity.WARNING),
        ("%\n" + LISTING + BODY, 2, Severity.WARNING), (": G17\n" + BODY, 1, Severity.NOTE), (BODY + "\x03", 5, Severity.NOTE),
        ("%\n" + BODY + "%\n\x03\n", 7, Severity.NOTE), (BODY.replace("\n", "\r\n") + "\x04", 5, Severity.NOTE),
    ],
)  # fmt: skip
@pytest.mark.parametrize("controller", ["fanuc", "linuxcnc"])
def test_it_is_found_and_the_program_is_read(
    text: str, line: int, severity: Severity, controller: str
) -> None:
    program = read(text, controller)
    assert path(program) == ["f 5 0 20"]
    assert [(one.line, one.severity) for one in program.findings if one.code == "not-nc-text"] == [
        (line, severity)
    ]


def test_siemens_has_words_that_begin_with_o() -> None:
    body = "G710 G90\nTRAORI\nORIWKS ORIAXES\nG0 X0 Y0 Z20 A0 C0\nG1 X5 F100\nM30\n"
    assert not [one for one in read(body, "siemens840d").findings if one.code == "not-nc-text"]
    program = read("O NONAME\n" + LISTING + body, "siemens840d")
    assert [one.line for one in program.findings if one.code == "not-nc-text"] == [2, 1] and len(
        program.words
    ) == 2


@pytest.mark.parametrize(
    "text", ["O NONAME X5\n", "OFINAL G1X5\n", "Date: today\n", "A comment\n", "G1 X1\x03\n" + BODY]
)
def test_what_could_move_something_or_is_anything_else_is_refused(text: str) -> None:
    with pytest.raises(ProgramError):
        read(text + BODY, "fanuc")


def test_the_rest_of_a_line_with_a_colon_is_read() -> None:
    program = read("G21 G90\n: G0 X0. Y0. Z20. A0. C0.\n: G1 X5. F100\n:7\nX6.\n", "fanuc")
    assert path(program) == ["f 5 0 20", "f 6 0 20"]
    assert [(one.line, one.text[0]) for one in program.findings if one.code == "not-nc-text"] == [(2, "2")]


def test_words_of_linuxcnc_with_o_are_no_names() -> None:
    program = read(
        "O<NAME> SUB\nG1 X5 F100\nO<NAME> ENDSUB\nG21 G90\nG0 X0 Y0 Z20 A0 C0\nO<NAME> CALL\nM2\n", "linuxcnc"
    )
    assert path(program) == ["f 5 0 20"] and not [
        one for one in program.findings if one.code == "not-nc-text"
    ]


@pytest.mark.parametrize("controller", ["heidenhain", "fanuc", "linuxcnc"])
def test_din_iso_of_heidenhain_ends_with_its_name(controller: str) -> None:
    text = "%123 G71 *\nN10 G90 *\nN20 G0 X+0 Y+0 Z+20 A+0 C+0 *\nN30 G1 X+5 F100 *\nN9999 % 123 G71 *\n"
    program = read(text, controller)
    assert path(program) == ["f 5 0 20"]
    assert ("other-language" in [one.code for one in program.findings]) == (controller != "heidenhain")


@pytest.mark.parametrize("number", ["", "0 ", "1 ", "10 "])
def test_klartext_shows_its_language_whatever_number_its_first_block_has(number: str) -> None:
    program = read(
        f"{number}BEGIN PGM T MM\n; a note\nL X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\nL X+5 F100\nEND PGM T MM\n",
        "linuxcnc",
    )
    assert path(program) == ["f 5 0 20"] and [one.code for one in program.findings] == ["other-language"]


@pytest.mark.parametrize("mark", ["%", "%%", " % "])
@pytest.mark.parametrize(
    ("head", "severity"),
    [
        ("G0 X0. Y0. Z50. A0. C0.\nG1 X77. F100\nM99\n", Severity.WARNING), ("G21\n", Severity.NOTE),
        ("A TITLE OF THE SHOP\n", Severity.NOTE), ("TOOLS T1 D10\n\n", Severity.NOTE),
    ],
)  # fmt: skip
def test_the_leader_before_the_first_percent_sign_is_not_the_program(
    head: str, severity: Severity, mark: str
) -> None:
    program = read(f"{head}{mark}\nO1\n{BODY}{mark}\n", "haas")
    assert path(program) == ["f 5 0 20"]
    found = [one for one in program.findings if one.code == "not-nc-text"]
    assert [(one.line, one.severity) for one in found] == [(1, severity)]
    last = len(head.strip().split("\n"))
    assert f"1 to {last} " in found[0].text and "text-after-end" not in [one.code for one in program.findings]


def test_between_two_percent_signs_stands_a_head_without_moves() -> None:
    program = read("%\n(A HEAD)\n%\nO1\n" + BODY + "%\n", "haas")
    assert path(program) == ["f 5 0 20"] and program.line.tolist() == [6, 7]
    assert "not-nc-text" not in [one.code for one in program.findings]


@pytest.mark.parametrize("behind", ["", "G1 X99. F100\n", "(A NOTE)\nSEE THE DRAWING\n"])
def test_a_single_percent_sign_may_be_the_closing_one(behind: str) -> None:
    program = read(BODY + "%\n" + behind, "haas")
    assert path(program) == ["f 5 0 20"]
    assert [one.code for one in program.findings if one.line == 5] == ["text-after-end"] * bool(behind)


@pytest.mark.parametrize(
    "head",
    [
        "Information listing created by\tme\nDate\t15-Apr-2023 14:45:48\nCurrent work part\tD:\\A\\Part X5.prt\nNode name\tpc\n\n",
        LISTING.replace("one.prt\n", "a_long_name_\n5.prt\n"), LISTING.replace("one.prt", "one\nX7.prt"),
        "\ufeff" + LISTING.replace(" :", "\t"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("mark", ["%\n", ""])
def test_the_head_of_a_listing_has_tabs_or_a_path_of_two_lines(head: str, mark: str) -> None:
    program = read(head + mark + BODY + mark, "fanuc")
    assert path(program) == ["f 5 0 20"]
    assert program.line[0] == head.count("\n") + mark.count("\n") + 2
    assert [one.severity for one in program.findings if one.code == "not-nc-text"] == [Severity.WARNING]


def test_without_a_listing_its_words_are_refused() -> None:
    with pytest.raises(ProgramError):
        read("Date\t15-Apr-2023 14:45:48\n" + BODY, "fanuc")


@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_a_carriage_return_in_a_comment_ends_no_line(end: str) -> None:
    lines = [
        "BEGIN PGM T MM", "; A DRILL\r FLUTES X7", "TOOL CALL 1 Z S1000", "L X+0 Y+0 Z+20 A+0 C+0 R0 FMAX", "L X+5 F100",
        "END PGM T MM", "",
    ]  # fmt: skip
    program = read(end.join(lines), "heidenhain")
    assert path(program) == ["f 5 0 20"] and program.line.tolist() == [4, 5] and not program.findings


def test_a_carriage_return_alone_ends_lines_where_most_end_so() -> None:
    program = read(BODY.replace("\n", "\r") + "\n", "fanuc")
    assert path(program) == ["f 5 0 20"] and program.line.tolist() == [2, 3]


@pytest.mark.parametrize("controller", ["heidenhain", "fanuc", "siemens840d"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_din_iso_with_a_star_in_its_last_line_alone(controller: str, end: str) -> None:
    text = "% 12 G70\nN10 ; NOTE\nN20 G90\nN30 G0 X0 Y0 Z1 A0 C0\nN40 G1 X1. F100\nN99 % 12 G70 *\n\n"
    program = read(text.replace("\n", end), controller)
    assert path(program) == ["f 25.4 0 25.4"]
    assert ("other-language" in [one.code for one in program.findings]) == (controller != "heidenhain")


def test_a_percent_sign_within_a_line_of_other_controls_is_refused() -> None:
    with pytest.raises(ProgramError):
        read(BODY + "N99 % 12 G71\n", "fanuc")


def test_a_carriage_return_before_a_block_number_ends_the_line() -> None:
    program = read(BODY.replace("G1 X5. F100\n", "N1 G1 X5. F100\rN2 X6.\n"), "fanuc")
    assert path(program) == ["f 5 0 20", "f 6 0 20"] and program.line.tolist() == [2, 3, 4]


SECTIONS = (
    "%\nO1 (MAIN)\nG21 G90 G94 G17\nG0 X0 Y0 Z9 A0 C0\n{}\nG1 X7 F100\n{}%\n\n%\nO2000 (SUB)\nG91 G1 X2 F100\nG90\nM98 P3000\nM99\n%\n"
    "%\nO3000\nG1 Y5 F100\nM99\n%\n%\nO4000\nG1 Z-99 F100\nM99\n%\n"
)


@pytest.mark.parametrize("end", ["M30\n", ""])
@pytest.mark.parametrize(
    ("call", "places"),
    [("M98 P2000", [(2, 0), (2, 5), (7, 5)]), ("M98 P22000", [(2, 0), (2, 5), (4, 5), (4, 5), (7, 5)]), ("M98 P3000", [(0, 5), (7, 5)])],
)  # fmt: skip
def test_subprograms_behind_the_closing_mark_are_called(call, places, end):
    program = read(SECTIONS.format(call, end), "fanuc")
    assert program.words[1:, :2].tolist() == [list(place) for place in places]
    assert not [found for found in program.findings if found.severity is Severity.ERROR], program.findings
    (found,) = [one for one in program.findings if one.code == "text-after-end" and "are called" in one.text]
    assert "O3000" in found.text and "O4000" not in found.text
    assert (19 if end else 18) in program.line.tolist()


def test_what_is_not_called_behind_the_closing_mark_stays_unread():
    program = read(SECTIONS.format("X1", "M30\n"), "fanuc")
    assert program.words[:, 2].min() == 9 and "not read" in str([one.text for one in program.findings])
    lost = read(SECTIONS.format("M98 P5000", "M30\n"), "fanuc")
    assert "call-not-interpreted" in [found.code for found in lost.findings]
