# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arcs of an NC program as chords: against closed forms, in every plane, form of the centre and language."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_reader import LINKS

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.nc.reader.arcs import ARC_TOLERANCE

HEAD = "G21 G90 G94 F600\nG0 X10 Y0 Z0 A0 C0\n"


def read(text, controller="linuxcnc"):
    return read_nc(text.encode(), LINKS, DIALECTS[controller])


def arc(line, head=HEAD, controller="linuxcnc"):
    """The rows of the arc in line 3, the start included."""
    program = read(head + line + "\nG1 X99\n", controller)
    return program.words[
        np.flatnonzero(program.line == 3).min() - 1 : np.flatnonzero(program.line == 3).max() + 1
    ], program


@pytest.mark.parametrize(
    ("line", "turn"),
    [
        ("G3 X0 Y10 I-10 J0", 90), ("G2 X0 Y10 I-10 J0", -270), ("G3 X10 Y0 I-10", 360), ("G2 X10 I-10", -360),
        ("G3 X0 Y10 R10", 90), ("G3 X0 Y10 R-10", 270), ("G2 X0 Y-10 R10", -90), ("G90.1 G3 X0 Y10 I0 J0", 90),
        ("G3 X-10 Y0 R10", 180), ("G91 G3 X-10 Y10 I-10 J0", 90),
    ],
)  # fmt: skip
def test_every_point_lies_on_the_circle_and_the_turn_is_that_of_the_code(line, turn):
    rows, program = arc(line)
    centre = np.array([10.0, 10.0]) if line == "G3 X0 Y10 R-10" else np.zeros(2)
    spoke = rows[:, :2] - centre
    assert np.abs(np.hypot(*spoke.T) - 10.0).max() < 1e-9
    angles = np.unwrap(np.arctan2(spoke[:, 1], spoke[:, 0]))
    assert np.degrees(angles[-1] - angles[0]) == pytest.approx(turn, abs=1e-6)
    assert not [found for found in program.findings if found.severity is Severity.ERROR]


@pytest.mark.parametrize("radius", [0.5, 10.0, 3000.0])
def test_the_chords_keep_to_the_tolerance_and_are_no_more_than_needed(radius):
    program = read(f"G21 F600\nG0 X{radius} Y0 Z0 A0 C0\nG3 X{-radius} Y0 R{radius}\nG1 X{-radius} Y1\n")
    rows = program.words[:-1]
    middle = 0.5 * (rows[1:, :2] + rows[:-1, :2])
    sagitta = radius - np.hypot(*middle.T)
    assert 0.0 < sagitta.max() <= ARC_TOLERANCE * (1 + 1e-6)
    assert len(rows) - 1 <= np.ceil(np.pi / (2 * np.arccos(1 - ARC_TOLERANCE / radius))) + 1


@pytest.mark.parametrize(("plane", "words", "u", "v"), [("G18", "Z0 X10", 2, 0), ("G19", "Y10 Z0", 1, 2)])
def test_planes_turn_right_handed_about_the_third_axis(plane, words, u, v):
    start = {"G18": "X0 Y0 Z10", "G19": "X0 Y10 Z0"}[plane]
    end = {"G18": "X10 Z0 K-10 I0", "G19": "Y0 Z10 J-10 K0"}[plane]
    rows, _ = arc(f"{plane} G3 {end}", f"G21 G90 F600\nG0 {start} A0 C0\n")
    angles = np.unwrap(np.arctan2(rows[:, v], rows[:, u]))
    assert np.degrees(angles[-1] - angles[0]) == pytest.approx(90.0)


def test_a_helix_and_the_rotary_words_go_evenly_with_the_arc():
    rows, program = arc("G3 X0 Y10 I-10 J0 Z5 A30")
    share = np.linspace(0.0, 1.0, len(rows))
    assert rows[:, 2] == pytest.approx(5.0 * share) and rows[:, 4] == pytest.approx(30.0 * share)
    assert (program.feed[program.line == 3] == 600.0).all()


def test_the_time_of_an_arc_is_that_of_its_length_under_g94_and_of_f_under_g93():
    _, program = arc("G3 X0 Y10 I-10 J0")
    assert program.seconds[program.line == 3].sum() == pytest.approx(60 * 5 * np.pi / 600, rel=1e-4)
    _, program = arc("G93 G3 X0 Y10 I-10 J0 F4")
    assert program.seconds[program.line == 3].sum() == pytest.approx(15.0)


def test_inches_scale_the_centre_too():
    rows, _ = arc("G3 X0 Y1 I-1 J0", "G20 G90 F10\nG0 X1 Y0 Z0 A0 C0\n")
    assert np.abs(np.hypot(*rows[:, :2].T) - 25.4).max() < 1e-9


THREE_ARCS = "G21 G90 F600\nG0 X10 Y0 Z0 A0 C0\nG3 X0 Y10 I-10 J0\nG2 X-10 Y20 R10\nG3 X-20 Y10 I0 J-10\n"
SIEMENS = "; a part\nG710 G90 F600\nG0 X10 Y0 Z0 A0 C0\nG3 X0 Y10 I-10 J0\nG2 X-10 Y=20 CR=10\nG3 X-20 Y10 I=AC(-10) J=AC(10)\nM30\n"
KLARTEXT = (
    "0 BEGIN PGM A MM\n1 L X+10 Y+0 Z+0 A+0 C+0 FMAX\n2 CC X+0 Y+0\n3 C X+0 Y+10 DR+ F600\n4 CR X-10 Y+20 R+10 DR-\n"
    "5 CC X-10 Y+10\n6 C X-20 Y+10 DR+\n7 M30\n8 END PGM A MM\n"
)


@pytest.mark.parametrize(("text", "controller"), [(SIEMENS, "siemens840d"), (KLARTEXT, "heidenhain")])
def test_the_same_arcs_in_every_language_are_the_same_rows(text, controller):
    plain, other = read(THREE_ARCS), read(text, controller)
    assert other.words == pytest.approx(plain.words, abs=1e-9)
    assert not [found for found in other.findings if found.severity > Severity.NOTE]


@pytest.mark.parametrize(
    "line", ["G2 X0 Y10 R1", "G3 X0 Y10", "G3 X0 Y10 I0 J0", "G2 X0 Y3 I-10 J0", "G3 X10 Y0 R5"]
)
def test_an_arc_without_a_centre_that_fits_is_straight_and_an_error(line):
    rows, program = arc(line)
    assert len(rows) == 2
    assert [found.line for found in program.findings if found.code == "arc-without-centre"] == [3]


def test_arcs_in_a_guided_stretch_are_arcs_of_the_tip():
    program = read("G21 G90 F600\nM428\nG0 X10 Y0 Z0 A20 C30\nG3 X0 Y10 I-10 J0 C60\nM429\nM2\n")
    tip = program.guided.tip
    assert program.guided.on.all() and len(tip) > 10
    assert np.abs(np.hypot(*tip[:, :2].T) - 10.0).max() < 1e-9
    assert program.words[:, 3] == pytest.approx(np.linspace(30.0, 60.0, len(tip)))


def test_arcs_that_would_fill_the_memory_are_refused():
    lines = "".join(f"G2 X{(-1) ** k * 9e6:.0f} Y0 R9e6\n".replace("R9e6", "R9000000") for k in range(1, 100))
    with pytest.raises(ProgramError, match="chords"):
        read("G21 F600\nG0 X9000000 Y0 Z0 A0 C0\n" + lines)
