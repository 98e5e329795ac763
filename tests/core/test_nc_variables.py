# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variables and expressions of NC programs: by hand, and as LinuxCNC's own interpreter works them out."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from rs274_judge import judged, needs_rs274
from test_nc_cycles import HEAD, errors, read

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.nc.reader.expressions import Parser, Unread, Variables


def value(text: str, fanuc: bool = False) -> float | None:
    parser = Parser(text, fanuc)
    parsed = parser.expression()
    assert not parser.rest()
    return parsed(Variables(fanuc, shared={100: 3.0, 101: 100.0}))


@pytest.mark.parametrize(
    ("text", "linuxcnc", "fanuc"),
    [
        ("1+2*3", 7, 7), ("[1+2]*3", 9, 9), ("2-3-4", -5, -5), ("8/4/2", 1, 1), ("-#100+5", 2, 2), ("##101", 3, 3), ("#[99+1]", 3, 3),
        ("SIN[30]", 0.5, 0.5), ("COS[60]", 0.5, 0.5), ("TAN[45]", 1, 1), ("ASIN[1]", 90, 90), ("ACOS[0]", 90, 90),
        ("ATAN[1]/[-1]", 135, 135), ("ATAN[-1]/[-1]", -135, 225), ("SQRT[16]", 4, 4), ("ABS[-2]", 2, 2), ("EXP[0]", 1, 1),
        ("LN[1]", 0, 0), ("ROUND[2.5]", 3, 3), ("ROUND[-2.5]", -3, -3), ("FIX[-2.5]", -3, -2), ("FUP[-2.5]", -2, -3),
        ("FIX[2.5]", 2, 2), ("FUP[2.5]", 3, 3), ("7MOD4", 3, 3), ("-7MOD4", 1, -3), ("1EQ1", 1, 1), ("1NE1", 0, 0), ("2GT1", 1, 1),
        ("2LE1", 0, 0), ("6AND3", 1, 2), ("6OR1", 1, 7), ("6XOR3", 0, 5), ("1+1AND2", 1, 1), ("2**3", 8, None), ("2**3**2", 64, None),
        ("2+2EQ4AND3GT1", 1, None), ("[#100GT1]AND[#100LT5]", 1, 1), ("#7EQ#0", 1, 1), ("#7EQ0", 1, 0), (".5*-2", -1, -1),
    ],
)  # fmt: skip
def test_expressions_are_worked_out_as_each_control_means_them(
    text: str, linuxcnc: float, fanuc: float | None
) -> None:
    assert value(text) == pytest.approx(linuxcnc)
    if fanuc is not None:
        assert value(text, True) == pytest.approx(fanuc)


@pytest.mark.parametrize(
    "text",
    [
        "[" * 60 + "1" + "]" * 60,
        "#" * 60 + "1",
        "1+",
        "FOO[1]",
        "__IMPORT__",
        "#[0.5]",
        "#-1",
        "#5220",
        "#<a>",
    ],
)
def test_what_is_no_expression_is_refused(text: str) -> None:
    with pytest.raises(Unread):
        value(text)


@pytest.mark.parametrize(
    ("text", "x"),
    [
        ("#1=5\nG1 X#1\n", 5), ("#1=5 #1=6\nG1 X#1\n", 6), ("G1 X#1 #1=7\nX#1\n", 7), ("#1=1\n#1=2 G1 X#1\n", 1), ("#<a b>=4\nG1 X#<AB>\n", 4),
        ("g1 x[1 + 2]y-[3]\n", 3), ("#1=2\nG#1 X4 I2\n", 4), ("#5=#6\nG1 X[#5+8]\n", 8), ("#1=[EXISTS[#<a>]]\nG1 X[#1+1]\n", 1),
    ],
)  # fmt: skip
def test_linuxcncs_words_and_settings(text: str, x: float) -> None:
    program = read(HEAD + text)
    assert program.words[-1, 0] == pytest.approx(x) and not errors(program)


def test_a_word_with_a_vacant_variable_is_left_out_on_fanuc_and_zero_on_linuxcnc() -> None:
    text = HEAD + "G1 X5 Y5\nG1 X#1 Y3\n"
    assert read(text, "fanuc").words[-1, :2].tolist() == [5, 3] and read(text).words[-1, :2].tolist() == [
        0,
        3,
    ]


def test_a_value_means_itself_where_words_count_the_least_increment() -> None:
    from freecad_fiveaxis.core.nc.reader import Assumed

    program = read(
        HEAD.replace("Z20", "Z20.") + "#100=5\nG1 X#100 Y5000\n", "fanuc", Assumed(decimal="least-increment")
    )
    assert program.words[-1, :2].tolist() == [5, 5]


@pytest.mark.parametrize(
    ("line", "message", "controller"),
    [
        ("G1 X#5021", "#5021", "haas"), ("#5221=3", "#5221", "linuxcnc"), ("#3000=1", "#3000", "fanuc"), ("G1 X#500", "#500", "haas"), ("G1 X#<_x>", "#<_x>", "linuxcnc"),
        ("G1 X[1/0]", "no number", "haas"), ("G1 X[SQRT[-1]]", "no number", "linuxcnc"), ("G1 X[EXP[999]]", "no number", "linuxcnc"),
        ("G1 X[1", "missing", "haas"), ("G1 X#<a>", "never set", "linuxcnc"), ("#1=", "no value", "linuxcnc"), ("G1 X[2**999]", "beyond", "linuxcnc"),
    ],
)  # fmt: skip
def test_a_value_that_nobody_knows_is_named_with_its_line(line: str, message: str, controller: str) -> None:
    program = read(HEAD + "G1 X3\n" + line + "\nG1 X7\n", controller)
    found = [one for one in program.findings if one.severity is Severity.ERROR]
    assert (
        [one.code for one in found] == ["macro-not-interpreted"]
        and message in found[0].text
        and found[0].line == 4
    )
    assert program.words[:, 0].tolist()[-1] == 7 and len(program.words) == 3


def some_expression(dice: random.Random, depth: int = 3) -> str:
    if depth == 0:
        return dice.choice((f"{dice.uniform(-5, 5):.3f}", "#1", "#2", "#<c>", f"#[{dice.choice('01')}+1]"))
    one, other = some_expression(dice, depth - 1), some_expression(dice, depth - 1)
    return dice.choice(
        (
            f"[{one} {dice.choice('+-*')} {other}]", f"[{one} {dice.choice(('AND', 'OR', 'XOR', 'EQ', 'NE', 'GT', 'LE'))} {other} + 1]",
            f"{dice.choice(('SIN', 'COS', 'ABS', 'FIX', 'FUP', 'ROUND'))}[{one}]", f"ATAN[{one}]/[{other}]", f"[{one} / [ABS[{other}] + 1]]",
            f"SQRT[ABS[{one}]]", f"[{one} MOD 3.5]", f"[ABS[{one}] ** 0.5 - {other} * 2]",
        )
    )  # fmt: skip


@pytest.mark.rs274
@needs_rs274
def test_any_expression_has_linuxcncs_value(tmp_path: Path) -> None:
    dice = random.Random(4)
    text = (
        HEAD
        + "#1=1.5\n#2=-2.25\n#<c>=3\n"
        + "".join(f"G1 X[{some_expression(dice)}] Y{k}\n" for k in range(300))
        + "M2\n"
    )
    (tmp_path / "a.ngc").write_text(text)
    message = judged(tmp_path / "a.ngc")
    assert not message.refused, message.refused
    assert abs(read(text).words[:, 0] - message.ends[-301:, 0]).max() <= message.off
