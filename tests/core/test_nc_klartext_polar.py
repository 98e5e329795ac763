# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext's polar lines, arcs and helices, against their closed forms; what is not known stays an error."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import errors, read

from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.reader.heidenhain_polar import without_polar

HEAD = "0 BEGIN PGM T MM\n1 L X+30 Y+20 Z+20 A+0 C+0 R0 FMAX\n2 L Z+5 F100\n3 CC X+20 Y+20\n"


def klartext(text: str) -> Program:
    return read(HEAD + text + "L Z+50 FMAX\nEND PGM T MM\n", "heidenhain")


def turned(program: Program, line: int) -> tuple[float, np.ndarray]:
    """deg that the tool goes round (20, 20) in that line, and its places (n, 3)."""
    rows = np.flatnonzero(program.line == line)
    place = program.words[np.append(rows[0] - 1, rows), :3]
    return float(np.degrees(np.ptp(np.unwrap(np.arctan2(place[:, 1] - 20.0, place[:, 0] - 20.0))))), place


@pytest.mark.parametrize(
    ("words", "sweep", "end"),
    [
        ("IPA+1080 IZ-9 DR+", 1080, (30, 20, -4)), ("IPA-1080 IZ-9 DR-", 1080, (30, 20, -4)), ("IPA+360 DR+", 360, (30, 20, 5)),
        ("IPA+450 Z-1 DR+", 450, (20, 30, -1)), ("IPA+90 DR+ RL F50", 90, (20, 30, 5)), ("IPA-90 IZ+2 DR-", 90, (20, 10, 7)),
        ("IPA+90 DR-", 270, (20, 30, 5)), ("PA+180 DR+", 180, (10, 20, 5)), ("PA180 IZ-1 DR-", 180, (10, 20, 4)),
    ],
)  # fmt: skip
def test_an_arc_and_a_helix_go_round_the_pole(words: str, sweep: float, end: tuple[float, ...]) -> None:
    program = klartext(f"4 CP {words}\n")
    assert errors(program) == (["compensation-not-interpreted"] if "RL" in words else [])
    angle, place = turned(program, 5)
    assert angle == pytest.approx(sweep) and place[-1] == pytest.approx(end, abs=1e-6)
    assert np.abs(np.hypot(*(place[:, :2] - 20.0).T) - 10.0).max() < 1e-6
    height = 5.0 + (end[2] - 5.0) * np.arange(len(place)) / (len(place) - 1)
    assert np.abs(place[:, 2] - height).max() < 1e-9


def test_one_turn_after_the_other_goes_on_from_where_it_ends() -> None:
    program = klartext("4 CP IPA+90 DR+\n5 CP IPA+90 DR+\n6 CP IPA+540 IZ-3 DR+\n")
    assert not errors(program)
    assert [turned(program, line)[0] for line in (5, 6, 7)] == pytest.approx([90, 90, 540])
    assert program.words[program.line == 7][-1, :3] == pytest.approx([30, 20, 2])


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        ("4 LP PR+10 PA+90 F200\n5 LP IPA+90\n6 LP PR+5\n", [(20, 30), (10, 20), (15, 20)]),
        ("4 LP IPR+2 PA+0\n5 LP PA+180 IPR-2 IZ-1\n", [(32, 20), (10, 20)]), ("4 LP IPA-90\n", [(20, 10)]),
        ("4 CC IX+10 IY+0\n5 LP PR+5 PA+90\n", [(40, 25)]), ("4 L X+1 IY+2\n5 CC\n6 LP PR+5 PA+0\n", [(1, 22), (6, 22)]),
        ("4 CYCL DEF 9.0 DWELL\n5 CYCL DEF 9.1 DWELL 2\n6 LP PR+10 PA+90\n", [(20, 30)]),
    ],
)  # fmt: skip
def test_polar_lines_lead_to_their_radius_and_angle(text: str, ends: list[tuple[float, float]]) -> None:
    program = klartext(text)
    assert not errors(program)
    assert program.words[2:-1, :2] == pytest.approx(np.array(ends))


def test_parameters_and_repeats_are_run_first() -> None:
    program = klartext("4 Q1 = 90\n5 LBL 1\n6 CP IPA+Q1 IZ-1 DR+\n7 CALL LBL 1 REP 3\n")
    assert not errors(program) and program.words[-2, :3] == pytest.approx([30, 20, 1])


@pytest.mark.parametrize(
    "text",
    ["4 CP IPA+90\n", "4 CP IPA+0 DR+\n", "4 CP IPA-400 DR+\n", "4 TRANS DATUM AXIS X+5\n5 CP IPA+90 DR+\n", "4 CC X+1 Z+2\n5 CP IPA+90 DR+\n", "4 L X+0 M91\n5 LP IPA+3\n", "4 CC X+30 Y+20\n5 CP IPA+90 DR+\n"],
)  # fmt: skip
def test_what_is_not_known_stays_an_error(text: str) -> None:
    assert "arc-not-interpreted" in errors(klartext(text))


def test_every_line_stays_where_it_is_and_others_as_they_are() -> None:
    text = b"1 L X+1 Y+2\n2 CC X+0 Y+0\n3 CP IPA+90 DR+ M8\n4 STOP\n/5 LP PR+1 PA+0\n"
    result = without_polar(text).split(b"\n")
    assert (
        result[0] == b"1 L X+1 Y+2"
        and result[1] == b"2 CC X+0 Y+0"
        and result[3] == b"4 STOP"
        and len(result) == 6
    )
    assert (
        result[2] == b"3 C X-2.000000000 Y+1.000000000 DR+ M8"
        and result[4] == b"/5 L X+1.000000000 Y+0.000000000"
    )
