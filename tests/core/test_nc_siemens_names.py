# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variables with names, values worked out in place, and arcs with full turns, of Siemens 840D."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import errors, read

from freecad_fiveaxis.core.base.findings import Severity

HEAD = "G0 G90 G71 X0 Y0 Z20 A0 C0\nG1 F100\n"


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        ("DEF REAL _A, B=5\nG1 X=_A Y=B\nX=B\n", [0, 5]), ("DEF REAL _H_X\n_H_X=-3.5 \nX=_H_X+1 Y=2*( _H_X )\n", [-2.5]),
        ("_GUD=4\nX=_GUD\n", [4]), ("DEF INT X_NOTE=2\nX=IC(X_NOTE)\nX=IC(X_NOTE)\n", [2, 4]),
        ("DEF BOOL ON=TRUE\nIF ON AND 1\nX1\nENDIF\nIF ON==0\nX2\nENDIF\n", [1]), ("DEF REAL TOL=.02\nCYCLE832(TOL,1,1)\nX=TOL\n", [0.02]),
        ("DEF INT K=0\nWHILE K<2\nK=K+1\nX=K\nENDWHILE\n", [1, 2]), ("R1=2\nX=AC(R1*3) CR=R1\n", [6]),
        ("DEF REAL Z_HOME=9\nSUPA G0 Z=Z_HOME D0\nSUPA\nG0 Z20\nG1 X1\n", [0, 1]), ("DEF STRING[32] NAME\nX3\n", [3]),
    ],
)  # fmt: skip
def test_named_variables_are_read(text: str, ends: list[float]) -> None:
    program = read(HEAD + text, "siemens840d")
    assert not errors(program), program.findings
    assert program.words[1:, 0].tolist() == pytest.approx(ends)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("DEF REAL A[3]\n", "A"),
        ("DEF AXIS _X\nX=_X\n", "interpreted"),
        ("IF _B>1\nX2\nENDIF\n_B=1\n", "_B was never set"),
    ],
)
def test_variables_without_a_value_here_are_named(text: str, message: str) -> None:
    found = read(HEAD + text + "X8\n", "siemens840d").findings
    found = next(one for one in found if one.severity is Severity.ERROR)
    assert message in found.text and found.code == "macro-not-interpreted"


@pytest.mark.parametrize(
    ("turn", "turns"), [("", 0.25), ("TURN=0", 0.25), ("TURN=2", 2.25), ("TURN=TIMES", 3.25)]
)
def test_an_arc_with_turns_goes_round_and_ends_where_it_says(turn: str, turns: float) -> None:
    text = f"DEF INT TIMES=3\n{HEAD}X10\nG3 X0 Y10 Z0 I-10 J0 {turn}\n"
    program = read(text, "siemens840d")
    assert not errors(program)
    place = program.words[2:, :3]
    assert place[-1].tolist() == pytest.approx([0, 10, 0])
    angle = np.unwrap(np.arctan2(place[:, 1], place[:, 0]))
    assert angle[-1] == pytest.approx(2.0 * np.pi * turns)
    assert np.hypot(place[:, 0], place[:, 1]) == pytest.approx(10.0)
    assert place[:, 2] == pytest.approx(20.0 * (1.0 - angle / angle[-1]), abs=1e-6)


@pytest.mark.parametrize(
    ("line", "code"),
    [("X5 RNDM=2.0.0", "corner-not-interpreted"), ("X5 CHF=2.5.5", "corner-not-interpreted"), ("X5 ANG=3.0.0", "corner-not-interpreted"),
     ("DIAMON", "offset-not-interpreted"), ("G54\nX1\nG500\nX2", "offset-not-interpreted")],
)  # fmt: skip
def test_words_that_move_otherwise_are_errors(line: str, code: str) -> None:
    assert errors(read(HEAD + line + "\nX8\n", "siemens840d")) == [code]
    assert not errors(read(HEAD + "G500\nX1\nG54\nX2\n", "siemens840d"))


def test_a_program_that_fanuc_calls_from_outside_is_an_error() -> None:
    assert errors(read("G21 G90 G0 X0. Y0. Z0. A0. C0.\nM198 P100\nG1 X5. F9.\n", "fanuc")) == [
        "call-not-interpreted"
    ]
