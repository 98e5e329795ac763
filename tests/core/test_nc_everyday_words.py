# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words that stand in everyday programs: feeds of the tool, words of an M function, look-ahead, spindles."""

from __future__ import annotations

import pytest
from test_nc_planes import read

from freecad_fiveaxis.core.motion.program import Program

KLARTEXT = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000{}\n2 L X+0 Y+0 Z+10 A+0 C+0 FMAX\n"
ISO = "G21 G90 G94\nG0 X0. Y0. Z0. A0. C0.\n"


def klartext(lines: str, feed: str = " F800") -> Program:
    return read(KLARTEXT.format(feed) + lines, "heidenhain")


def iso(lines: str, controller: str = "fanuc") -> Program:
    return read(ISO + lines, controller)


def kinds(program: Program) -> list[tuple[str, int | None]]:
    return [(str(found.code), found.line) for found in program.findings]


@pytest.mark.parametrize("word", ["F AUTO", "FAUTO", "R0 F AUTO M3", "F  AUTO", ""])
def test_f_auto_is_the_feed_of_the_tool_call_and_stays(word: str) -> None:
    program = klartext(f"3 L X+5 {word}\n4 L X+6\n5 L X+7 F300\n6 L X+8 F MAX\n7 L X+9 FAUTO\n")
    assert program.feed.tolist() == [0, 800, 800, 300, 0, 800]
    assert program.words[:, 0].tolist() == [0, 5, 6, 7, 8, 9]
    assert kinds(program) == []


@pytest.mark.parametrize(
    ("call", "feed"),
    [
        ('TOOL CALL "MILL_F9" Z S6000 F12500', 12500),
        ('TOOL CALL "MILL F9" Z S6000 F1250', 1250),
        ("TOOL CALL 2 Z S6000 F900 DL+0 DR+0", 900),
        ("TOOL CALL S6000", 800),
        ("TOOL CALL F950", 950),
        ("TOOL DEF 7", 800),
    ],
)
def test_the_last_tool_call_says_the_feed(call: str, feed: float) -> None:
    program = klartext(f"3 {call}\n4 L X+5 R0 F300\n5 L X+6 R0  F AUTO  M8\n")
    assert program.feed[-1] == feed and kinds(program) == []


@pytest.mark.parametrize("call", ["", 'TOOL CALL "F9" Z S6000', "TOOL CALL 2 Z S6000", "TOOL CALL 5 Z"])
def test_a_tool_call_without_f_gives_one_finding_and_no_time(call: str) -> None:
    program = klartext(f"3 {call}\n4 L X+5 FAUTO\n5 L X+6\n6 L X+7 F300\n", " F800" if call else "")
    assert kinds(program) == [("feed-by-parameter", 5)]
    assert program.seconds[1:3].tolist() == [0, 0] and program.feed[-1] == 300


@pytest.mark.parametrize("word", ["FZ0.1", "FU 0.2", "FT3", "F MAXT", "FZ.1"])
def test_a_feed_of_a_tooth_or_of_a_time_changes_no_place(word: str) -> None:
    program = klartext(f"3 L X+5 Y+2 {word}\n")
    assert program.words[-1, :2].tolist() == [5, 2] and kinds(program) == [("feed-by-parameter", 4)]


@pytest.mark.parametrize(
    "word",
    [
        "M120 LA5",
        "M120LA 5",
        "M128 F1000",
        "M128 FMAX",
        "M118 X0.1 Y1 W10",
        "M138 A C",
        "M94 C",
        "M94",
        "M120",
    ],
)
@pytest.mark.parametrize("line", ["L X+5 F500 {}\n", "L X+5 F500\n{}\n", "{}\nL X+5 F500\n"])
def test_the_words_of_an_m_function_are_no_places_and_no_feeds(word: str, line: str) -> None:
    program = klartext(line.format(word))
    assert program.words[-1].tolist() == [5, 0, 10, 0, 0] and program.feed[-1] == 500
    assert {code for code, _ in kinds(program)} <= {"tip-guided-by-controller"}


def test_m128_with_a_feed_guides_and_words_behind_m94_stay() -> None:
    assert klartext("3 M128 F1000\n4 L X+5\n").guided is not None
    program = klartext("3 L M94 C X+5 A+3\n")
    assert program.words[-1, [0, 4]].tolist() == [5, 3]


def test_m103_lowers_the_feed_of_plunging_only() -> None:
    program = klartext("3 L X+5 F500 M103 F20\n4 L X+6\n")
    assert program.feed.tolist() == [0, 500, 500] and kinds(program) == [("feed-by-parameter", 4)]


def test_m136_is_a_feed_per_turn_until_m137() -> None:
    program = klartext("3 L X+5 F0.1 M136\n4 L X+6\n5 L X+7 F600 M137\n")
    assert program.seconds.tolist() == pytest.approx([0, 0, 0, 0.1]) and kinds(program) == [
        ("feed-per-turn", 4)
    ]


def test_a_surface_normal_moves_nothing() -> None:
    plain = klartext("3 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n4 LN X+1 Y+2 Z+3 TX0.6 TY+0 TZ0.8 F500\n")
    text = "3 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n4 LN X+1 Y+2 Z+3 NX0 NY-0.6 NZ.8 TX0.6 TY+0 TZ0.8 F500\n"
    assert (klartext(text).words == plain.words).all() and kinds(klartext(text)) == kinds(plain)


@pytest.mark.parametrize(
    ("controller", "word"),
    [
        ("fanuc", "G5.1 Q1 R1"), ("fanuc", "G05.1 Q1 R5"), ("fanuc", "G05.3 P1"), ("fanuc", "G40.1"),
        ("fanuc", "G62"), ("fanuc", "G67"), ("fanuc", "G25"), ("haas", "G187 P3 E0.0100"), ("haas", "G187 E.01"),
        ("haas", "G154 P5"), ("haas", "G103 P1"), ("haas", "G103"),
    ],
)  # fmt: skip
def test_a_word_of_fanuc_or_haas_that_moves_nothing_is_no_finding(controller: str, word: str) -> None:
    program = iso(f"{word}\nG1 X1. F100.\n", controller)
    assert kinds(program) == [] and program.words[-1].tolist() == [1, 0, 0, 0, 0]


@pytest.mark.parametrize(
    ("word", "code"), [("G07.1 C10.", "polar-not-interpreted"), ("G10.9 X1.", "unknown-code")]
)
def test_a_radius_or_a_way_of_counting_is_no_place(word: str, code: str) -> None:
    program = iso(f"{word}\nG1 Y1. F100.\n")
    assert program.words[-1].tolist() == [0, 1, 0, 0, 0] and kinds(program) == [(code, 3)]


@pytest.mark.parametrize(
    ("lines", "count"),
    [
        ("G154 P5\nG1 X1. F100.\n", 0), ("G154 P5\nG1 X1. F100.\nG154 P5\nX2.\n", 0),
        ("G154 P5\nG1 X1. F100.\nG154 P6\nX2.\n", 2), ("G54\nG1 X1. F100.\nG154 P6\nX2.\n", 2),
        ("G54.1 P1\nG1 X1. F100.\nG54.1 P2\nX2.\nG54.1 P3\nX3.\n", 3), ("G54\nG1 X1. F100.\nG55\nX2.\n", 2),
    ],
)  # fmt: skip
def test_each_numbered_work_offset_is_another(lines: str, count: int) -> None:
    found = [one.text for one in iso(lines, "haas").findings if one.code == "work-offset-change"]
    assert len(found) == (count > 0) and all(f"uses {count} " in text for text in found)


@pytest.mark.parametrize(
    "word",
    [
        "SPOS=0", "SPOS[1]=90", "SPOS = DC(0)", "SPOSA=180", "SPOSA[2]=IC(-90)", "LIMS=5000", "ACC[X]=50",
        "VELOLIM[C]=50", "FL[C]=100", "STOLF=10", "SPCON", "COMPPATH", "WALIMON", "G62", "CDON", "TOROTOF",
    ],
)  # fmt: skip
def test_a_word_of_siemens_for_spindle_or_drives_is_no_finding(word: str) -> None:
    head = "G710 G90 G94\nG0 X0 Y0 Z0 A0 C0\n"
    program = read(f"{head}{word}\nG1 X1 F100\nM30\n", "siemens840d")
    assert kinds(program) == [] and program.words[-1].tolist() == [1, 0, 0, 0, 0] and program.feed[-1] == 100
    inline = read(f"{head}G1 X1 {word} F100\nM30\n", "siemens840d") if "=" in word else program
    assert kinds(inline) == [] and inline.words[-1].tolist() == [1, 0, 0, 0, 0] and inline.feed[-1] == 100


@pytest.mark.parametrize(
    ("lines", "begin"),
    [
        ("G1 X1. E2. F100.\n", "The word E in NC line 3 is not interpreted"),
        ("G1 X1. F100.\nX2. E2.\nX3. E3.\n", "2 words E, the first in NC line 4, are not interpreted"),
        ("G5.1 Q1 R1\nG1 X1. F100.\nX2. R2.\n", "The word R in NC line 5 is not interpreted"),
    ],
)
def test_a_word_that_is_not_interpreted_is_stated_with_its_line_and_a_remedy(lines: str, begin: str) -> None:
    (found,) = (one for one in iso(lines).findings if one.code == "word-not-interpreted")
    assert found.text.startswith(begin) and "Post without" in found.text
    assert f"NC line {found.line}" in found.text
