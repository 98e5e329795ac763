# SPDX-License-Identifier: LGPL-2.1-or-later
"""Q parameters, labels and drilling cycles of Heidenhain klartext, by hand and against Python's own
arithmetic."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from test_nc_cycles import errors, path, read

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.nc.reader import heidenhain_run

HEAD = "0 BEGIN PGM T MM\n1 L X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n2 L F100\n"


def klartext(text: str):
    return read(HEAD + text, "heidenhain")


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        ("3 Q1 = +5\n4 L X+Q1\n5 L X-Q1 Y+Q1\n", [5, -5]), ("FN 0: Q5 = +60\nFN 1: Q1 = -Q5 + -5\nL X+Q1\n", [-65]),
        ("FN 2: Q1 = +10 - +5\nFN 3: Q2 = +3 * +Q1\nFN 4: Q4 = +Q2 DIV +2\nL X+Q4\n", [7.5]), ("QL1 = 2\nQR7 = QL1 ^ 3\nL XQR7\n", [8]),
        ("FN 5: Q20 = SQRT 16\nFN 6: Q21 = SIN +30\nFN 7: Q22 = COS -60\nL X+Q20\nL X+Q21\nL X+Q22\n", [4, 0.5, 0.5]),
        ("FN 8: Q1 = +3 LEN +4\nFN 13: Q2 = +1 ANG -1\nL X+Q1\nL X+Q2\n", [5, 135]),
        ("Q4 = 30\nQ2 = 1\nQ1 = Q2 + 3 * SIN Q4\nL X+Q1\n", [2.5]), ("Q1 = (2 + 3) * -2\nL IX+Q1\nL IX+Q1\n", [-10, -20]),
        ("Q1 = 0\nLBL 7\nQ1 = Q1 + 1\nL X+Q1\nFN 12: IF +Q1 LT +3 GOTO LBL 7\nL X+9\n", [1, 2, 3, 9]),
        ("Q1 = 4\nFN 9: IF +Q1 EQU +4 GOTO LBL \"END\"\nL X+1\nLBL \"END\"\nL X+2\n", [2]),
        ("Q1 = 4\nFN 10: IF +Q1 NE +4 GOTO LBL 1\nL X+1\nLBL 1\nFN 11: IF +Q1 GT +3 GOTO LBL 2\nL X+5\nLBL 2\nL X+2\n", [1, 2]),
        ("LBL 1\nL IX+1\nCALL LBL 1 REP 3\nL X+0\n", [1, 2, 3, 4, 0]), ("LBL 1\nL IX+1\nCALL LBL 1 REP 2/2\n", [1, 2, 3]),
        ("L X+1\nCALL LBL 5\nL X+3\nM30\nLBL 5\nL X+2\nLBL 0\nL X+8\n", [1, 2, 3]),
        ("CALL LBL 5\nM30\nLBL 5\nLBL 6\nL IX+1\nCALL LBL 6 REP 1\nLBL 0\n", [1, 2]),
        ("Q1 = 7 ;note\n/ 12 L X+Q1\n", [7]), ("Q1 = 7\nCC X+0 Y+0\nL X+Q1 Y+0\nC X-Q1 Y+0 DR+\n", [7, -7]),
    ],
)  # fmt: skip
def test_parameters_and_labels_are_run(text: str, ends: list[float]) -> None:
    program = klartext(text)
    assert not errors(program), program.findings
    last = (
        np.flatnonzero(np.diff(program.line, append=-1) != 0)
        if "C X" in text
        else np.arange(len(program.line))
    )
    found = program.words[last[1:], 0].tolist()
    assert found == pytest.approx(ends)


def test_feeds_by_parameter_and_lines_of_the_file() -> None:
    program = klartext("Q1 = 250\nL X+1 FQ1\nLBL 1\nL IX+1\nCALL LBL 1 REP 1\nL X+3 FQ9\n")
    assert program.feed[1:].tolist()[:3] == [250] * 3 and program.line.tolist() == [2, 5, 7, 7, 9]
    assert [found.line for found in program.findings if found.code == "feed-by-parameter"] == [9]


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("L X+Q7", "Q7 was never set"), ("FN 18: SYSREAD Q1 = ID210", "not known"), ("Q1 = SYSREAD", "no value"), ("Q1 = 1 / 0", "no number"),
        ("CALL LBL 4", "no line"), ("Q1 = " + "(" * 60 + "1" + ")" * 60, "brackets"), ("Q1 = (2", "missing"), ("Q1 = 2 3 X", "not known"),
    ],
)  # fmt: skip
def test_what_is_not_known_is_named_with_its_line(line: str, message: str) -> None:
    program = klartext("L X+1\n" + line + "\nL X+8\n")
    found = [one for one in program.findings if one.severity is Severity.ERROR and message in one.text]
    assert found and found[0].line == 5 and program.words[-1, 0] == 8


def test_what_does_not_end_is_refused_with_its_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(heidenhain_run, "MOST", 20_000)
    with pytest.raises(ProgramError, match=r"line [456]: the loop does not end"):
        klartext("LBL 1\nQ1 = 1\nFN 9: IF +Q1 EQU +1 GOTO LBL 1\n")
    with pytest.raises(ProgramError, match="nested deeper"):
        klartext("LBL 1\nCALL LBL 1\nLBL 0\n")


def drill(number: int, **words: float) -> str:
    reported = " ~\n".join(f"   {name}={value:+} ;NOTE" for name, value in words.items())
    return f"4 CYCL DEF {number} DRILLING ~\n{reported}\n"


WORDS = {"Q200": 2, "Q201": -10, "Q206": 150, "Q202": 4, "Q210": 0, "Q203": 1, "Q204": 30, "Q211": 0.1}


def test_cycle_200_by_hand() -> None:
    program = klartext(drill(200, **WORDS) + "L X+5 Y+6 FMAX M99\nL X+7 FMAX\nCYCL CALL\nL Y+1\n")
    hole = [
        "r {x} 6 3",
        "f {x} 6 -3",
        "r {x} 6 3",
        "r {x} 6 -1",
        "f {x} 6 -7",
        "r {x} 6 3",
        "r {x} 6 -5",
        "f {x} 6 -9",
        "r {x} 6 3",
        "r {x} 6 31",
    ]
    assert path(program) == [
        "r 5 6 20",
        *(one.format(x=5) for one in hole),
        "r 7 6 31",
        *(one.format(x=7) for one in hole),
        "f 7 1 31",
    ]
    assert not errors(program) and program.feed[3] == 150 and program.feed[-1] == 100
    assert set(program.line[1:12].tolist()) == {13} and program.line[-1] == 16


def test_cycle_203_leaves_by_its_own_feed_and_what_is_not_simple_is_named() -> None:
    program = klartext(
        drill(203, **(WORDS | {"Q202": 20, "Q204": 0, "Q208": 500, "Q212": 0, "Q213": 0}))
        + "L X+5 Y+6 FMAX M99\n"
    )
    assert path(program) == ["r 5 6 20", "r 5 6 3", "f 5 6 -9", "f 5 6 3"] and program.feed[-1] == 500
    for words, message in (
        ({"Q213": 3}, "Q256"),
        ({"Q395": 1}, "Q395"),
        ({"Q201": 5}, "depth"),
        ({"Q202": 0}, "infeed"),
    ):
        program = klartext(drill(203, **(WORDS | words)) + "L X+5 Y+6 FMAX M99\n")
        assert any(message in found.text for found in program.findings if found.severity is Severity.ERROR)
    program = klartext(drill(251, Q200=2, Q201=-10) + "L X+5 Y+6 FMAX M99\n")
    assert errors(program) == ["cycle-not-interpreted"] * 2


def test_a_cycle_after_another_that_is_not_known_is_not_called_for_it() -> None:
    program = klartext(drill(200, **WORDS) + drill(251, Q200=2) + "L X+5 Y+6 FMAX M99\n")
    assert path(program) == ["r 5 6 20"] and "cycle-not-interpreted" in errors(program)


def test_cycles_in_a_tilted_plane_and_parameters_as_spatial_angles() -> None:
    text = (
        "Q1 = 30\nPLANE SPATIAL SPA+Q1 SPB+0 SPC+0 TURN FMAX\n"
        + drill(200, **WORDS)
        + "L X+5 Y+6 Z+40 FMAX M99\n"
    )
    program = klartext(text)
    assert not errors(program) and (program.words[2:, 4] == program.words[-1, 4]).all()
    assert program.words[-1, 4] == pytest.approx(30)


def test_random_formulas_as_python_works_them_out() -> None:
    rng, known = random.Random(3), {"Q1": 1.75, "Q2": -0.4, "QL3": 2.5}
    names = {
        "SIN": "sin(radians({}))",
        "COS": "cos(radians({}))",
        "ABS": "abs({})",
        "NEG": "-({})",
        "SQ": "({})**2",
        "INT": "trunc({})",
    }

    def make_result(depth: int) -> tuple[str, str]:
        kind = rng.random()
        if depth == 0 or kind < 0.25:
            one = rng.choice([*known, "3", "0.5", "12.25"])
            return one, str(known.get(one, one)) if one != "Q2" else "(-0.4)"
        a, b = make_result(depth - 1), make_result(depth - 1)
        if kind < 0.45:
            name = rng.choice([*names])
            return f"{name} ({a[0]})", "(" + names[name].format(a[1]) + ")"
        sign = rng.choice("+-*")
        return f"({a[0]} {sign} {b[0]})", f"({a[1]} {sign} {b[1]})"

    for _ in range(200):
        own, python = make_result(4)
        reported = heidenhain_run.Formula(own.replace(" ", ""), lambda name: known[f"Q{name}"]).sum()
        assert reported == pytest.approx(eval(python, vars(math) | {"abs": abs}), rel=1e-12, abs=1e-12)
    assert heidenhain_run.Formula("2+3*4-6/2^2", float).sum() == 12.5


def test_a_plain_program_is_not_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(heidenhain_run, "run_heidenhain", None)
    assert klartext("L X+1 FMAX M3\nTOOL CALL 3 Z S900\nL X+2\nEND PGM T MM\n").words[-1, 0] == 2
