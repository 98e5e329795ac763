# SPDX-License-Identifier: LGPL-2.1-or-later
"""Canned cycles written out as moves: by hand, and as LinuxCNC's own interpreter moves."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest
from rs274_judge import judged, moving, needs_rs274

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.machine import Axis, Machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.reader import Assumed, read_nc
from freecad_fiveaxis.core.toolpath.cl_path import Motion

HEAD = "G21 G90 G94 F100\nG0 X0 Y0 Z20 A0 C0\n"


def trunnion():
    linear = [
        Axis(name, False, "head", tuple(row), max_rate=6000.0)
        for name, row in zip("XYZ", np.eye(3), strict=True)
    ]
    return chain(
        Machine(
            "trunnion", (Axis("C", True, "table", (0, 0, 1)), Axis("A", True, "table", (1, 0, 0)), *linear)
        ),
        Setup(),
    )


LINKS = trunnion()


def read(text: str, controller: str = "linuxcnc", assumed: Assumed = Assumed()) -> Program:  # noqa: B008
    return read_nc(text.encode(), LINKS, DIALECTS[controller], assumed=assumed)


def path(program: Program) -> list[str]:
    """The moves after the first, as r for rapids and f for feeds with X Y Z."""
    letter = np.where(program.motion == Motion.RAPID, "r", "f")
    return [
        f"{one} {x:g} {y:g} {z:g}" for one, (x, y, z) in zip(letter[1:], program.words[1:, :3], strict=True)
    ]


def errors(program: Program) -> list[str]:
    return [found.code for found in program.findings if found.severity is Severity.ERROR]


@pytest.mark.parametrize("controller", ["fanuc", "haas"])
def test_drilling_goes_to_r_by_rapid_and_back_to_the_initial_level_or_to_r(controller: str) -> None:
    program = read(HEAD + "G98 G81 X5 Y6 Z-3 R2\nX7\nG99 Y8\nX9 Z-4 R3\nG80\nG0 X0\n", controller)
    assert path(program) == [
        "r 5 6 20", "r 5 6 2", "f 5 6 -3", "r 5 6 20",
        "r 7 6 20", "r 7 6 2", "f 7 6 -3", "r 7 6 20",
        "r 7 8 20", "r 7 8 2", "f 7 8 -3", "r 7 8 2",
        "r 9 8 2", "r 9 8 3", "f 9 8 -4", "r 9 8 3", "r 0 8 3",
    ]  # fmt: skip
    assert program.line.tolist() == [2, *[3] * 4, *[4] * 4, *[5] * 4, *[6] * 4, 8]
    assert program.feed[3] == 100 and not errors(program)


@pytest.mark.parametrize(
    ("cycle", "moves"),
    [
        ("G73 Z-5 R2 Q3", ["r 0 0 2", "f 0 0 -1", "r 0 0 0", "f 0 0 -4", "r 0 0 -3", "f 0 0 -5", "r 0 0 20"]),
        ("G83 Z-5 R2 Q3.5", ["r 0 0 2", "f 0 0 -1.5", "r 0 0 2", "r 0 0 -0.5", "f 0 0 -5", "r 0 0 20"]),
        ("G85 Z-5 R2", ["r 0 0 2", "f 0 0 -5", "f 0 0 2", "r 0 0 20"]), ("G84 Z-5 R2", ["r 0 0 2", "f 0 0 -5", "f 0 0 2", "r 0 0 20"]),
        ("G82 Z-5 R2 P500", ["r 0 0 2", "f 0 0 -5", "r 0 0 20"]), ("G86 Z-5 R2", ["r 0 0 2", "f 0 0 -5", "r 0 0 20"]),
        ("G89 Z-5 R2 P500", ["r 0 0 2", "f 0 0 -5", "f 0 0 2", "r 0 0 20"]), ("G74 Z-5 R2", ["r 0 0 2", "f 0 0 -5", "f 0 0 2", "r 0 0 20"]),
    ],
)  # fmt: skip
def test_each_cycle_goes_down_and_out_in_its_own_way(cycle: str, moves: list[str]) -> None:
    program = read(HEAD + cycle + "\nG80\n", "fanuc")
    assert path(program)[1:] == moves and not errors(program)
    assert ("peck-clearance" in [found.code for found in program.findings]) == ("Q" in cycle)


@pytest.mark.parametrize(("controller", "letter"), [("fanuc", "K"), ("haas", "L"), ("linuxcnc", "L")])
def test_repeats_under_g91_make_a_row_of_holes(controller: str, letter: str) -> None:
    program = read(HEAD + f"G91 G99 G81 X10 Y1 Z-6 R-18 {letter}3\nG80\nG0 X1 A5\nG90 X0\n", controller)
    assert [one for one in path(program) if one.startswith("f")] == ["f 10 1 -4", "f 20 2 -4", "f 30 3 -4"]
    assert path(program)[-2:] == ["r 31 3 2", "r 0 3 2"]


def test_no_repeat_keeps_the_words_for_the_holes_that_follow() -> None:
    assert path(read(HEAD + "G98 G81 Z-3 R2 L0\nX5\nG80\n", "haas")) == [
        "r 5 0 20",
        "r 5 0 2",
        "f 5 0 -3",
        "r 5 0 20",
    ]


def test_rotary_words_of_a_cycle_turn_before_it_and_g91_stays_in_force() -> None:
    program = read(HEAD + "G98 G81 A30 Z-3 R2\nG91 A15\nG80\nG1 A1 X1\n", "haas")
    assert program.words[:, 4].tolist() == [0, 30, 30, 30, 30, 45, 45, 45, 45, 46]
    assert program.words[-1, 0] == 1


def test_inches_and_the_least_increment_count_for_the_words_of_cycles_too() -> None:
    inch = read("G20 G90 F10\nG0 X0 Y0 Z1 A0 C0\nG98 G83 X1 Z-1 R0.5 Q1\nG80\n", "haas")
    assert inch.words[1:, 2] == pytest.approx([25.4, 12.7, -12.7, 12.7, -11.7, -25.4, 25.4])
    small = read(
        "G21 G90 F10\nG0 X0 Y0 Z1000 A0 C0\nG98 G83 X1 Z-1000 R500 Q1000\nG80\n",
        "haas",
        Assumed(decimal="least-increment"),
    )
    assert small.words[1:, 2] == pytest.approx([1, 0.5, -0.5, 0.5, 0.5, -1, 1])


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("G83 X1 Z-5 R2", "no Q"), ("G81 X1 Z-5", "no R"), ("G81 X1 R2", "no depth"), ("G81 X1 Z5 R2", "above R"),
        ("G83 X1 Z-5 R2 I3 J1 K1 Q1", "get smaller"), ("G81 X1 Z-5 R2 L1.5", "whole number"), ("G83 X1 Z-5 R2 Q0.0000001", "too many"),
        ("G93 G81 X1 Z-5 R2 F1", "inverse"),
    ],
)  # fmt: skip
def test_a_cycle_that_cannot_be_written_out_is_refused_by_name_with_its_line(line: str, message: str) -> None:
    before, line_of = ("G98 G81 X3 Z-1 R1\n", 4) if "no" not in message else ("", 3)
    program = read(HEAD + before + line + "\nX9\nG80\nG94 G0 X0 F10\n", "haas")
    found = [one for one in program.findings if one.code == "cycle-not-interpreted"]
    assert any(message in one.text and one.line == line_of for one in found)
    assert 1 not in program.words[:, 0]


def test_a_program_without_cycles_is_the_same_object() -> None:
    from freecad_fiveaxis.core.nc.reader import canned_cycles, codes, lines, words

    read_in = words.read_words(HEAD.encode() + b"G1 X1\nG80\n")
    assert (
        canned_cycles.write_out_cycles(read_in, lines.Lines(read_in, Assumed()), codes.ISO, "haas")[0]
        is read_in
    )


def agree(text: str, tmp_path: Path) -> None:
    """Position by position as rs274, without moves of no length."""
    file = tmp_path / "cycles.ngc"
    file.write_text(text)
    message = judged(file)
    assert not message.refused
    program = read(text)
    assert not errors(program), program.findings
    ours, theirs = program.words[:, [0, 1, 2, 4]], message.ends[:, :4]
    mine, his = moving(ours, 1e-6), moving(theirs, 1e-6)
    np.testing.assert_allclose(ours[mine], theirs[his], atol=message.off)
    assert [program.motion[row] == Motion.RAPID for row in mine[1:]] == [
        message.kinds[row] == "rapid" for row in his[1:]
    ]


def some_cycles(seed: int) -> str:
    """A program of cycles as LinuxCNC accepts them."""
    dice = random.Random(seed)
    plane, across, along = dice.choice(
        [("G17", "XY", "Z"), ("G17", "XY", "Z"), ("G18", "XZ", "Y"), ("G19", "YZ", "X")]
    )
    lines = [
        f"{dice.choice(('G21', 'G20'))} G90 G94 {plane} F100",
        "G0 X0 Y0 Z0 A0 C0",
        f"G0 {along}{dice.randint(-3, 20)}",
        "M3 S100",
    ]
    for _ in range(6):
        code = dice.choice(
            (73, 81, 82, 83, 85, 86, 89, *((84,) if plane == "G17" else ()))
        )  # rs274 2.9 taps G18 and G19 along wrong axes
        steps = dice.random() < 0.4
        r, depth = (
            (dice.randint(-4, 4), -dice.randint(1, 9)) if steps else (dice.randint(0, 4), -dice.randint(1, 9))
        )
        own = {73: " Q2.1", 83: " Q3", 82: " P0", 86: " P0", 89: " P0"}.get(code, "")
        lines.append(
            f"{dice.choice(('G98', 'G99', ''))} {'G91' if steps else 'G90'} G{code} {across[0]}{dice.randint(1, 9)} R{r} {along}{depth}{own}{dice.choice(('', ' L2'))}"
        )
        for _ in range(dice.randint(0, 3)):
            lines.append(
                f"{dice.choice(('G98', 'G99', ''))} {across[0]}{dice.randint(1, 9)} {across[1]}{dice.randint(1, 9)}{dice.choice(('', f' R{r + 1}', ' L3'))}"
            )
        if dice.random() < 0.5:
            lines += [
                "G80",
                f"G1 {across[0]}3" if dice.random() < 0.5 else "G90 G0 X0 Y0 Z0",
                f"G90 G0 {along}{dice.randint(0, 9)}",
            ]
    return "\n".join([*lines, "G80", "M2"]) + "\n"


@pytest.mark.rs274
@needs_rs274
@pytest.mark.parametrize("seed", range(60))
def test_cycles_move_as_linuxcnc_moves(seed: int, tmp_path: Path) -> None:
    agree(some_cycles(seed), tmp_path)


@pytest.mark.parametrize("controller", ["fanuc", "haas"])
def test_fine_boring_is_read_without_its_shift_and_stated_so(controller: str) -> None:
    program = read(HEAD + "G98 G76 X5 Y6 Z-3 R2 Q0.5 P100\nX7\nG80\n", controller)
    assert path(program) == [
        "r 5 6 20",
        "r 5 6 2",
        "f 5 6 -3",
        "r 5 6 20",
        "r 7 6 20",
        "r 7 6 2",
        "f 7 6 -3",
        "r 7 6 20",
    ]
    assert [found.line for found in program.findings if found.code == "boring-shift"] == [3] and not errors(
        program
    )


def test_threads_of_linuxcnc_and_back_boring_are_named() -> None:
    assert errors(read(HEAD + "G76 P1 Z-3 I-1 J0.1 K0.5\nG80\nG0 X1\n"))
    assert errors(read(HEAD + "G87 X5 Y6 Z-3 R2 Q0.5\nG80\nG0 X1\n", "fanuc")) == ["cycle-not-interpreted"]


ROW = [f"{one} {x} 0 {z}" for x in (10, 20, 30, 40) for one, z in (("r", 15), ("f", 5), ("r", 15))]


@pytest.mark.parametrize(("controller", "letter"), [("fanuc", "K"), ("haas", "L")])
def test_a_row_in_steps_takes_r_from_the_initial_level_and_z_from_r(controller: str, letter: str) -> None:
    program = read(HEAD + f"G91 G99 G81 X10. R-5. Z-10. {letter}4\nG80\nG90 G0 X0.\n", controller)
    assert path(program) == ["r 10 0 20", *ROW, "r 0 0 15"] and not errors(program)
    again = read(HEAD + f"G90 G98 G81 X5. Y5. R2. Z-10. {letter}2\nG80\n", controller)
    assert path(again) == ["r 5 5 20", "r 5 5 2", "f 5 5 -10", "r 5 5 20"] * 2


@pytest.mark.parametrize(("controller", "letter"), [("fanuc", "K"), ("haas", "L")])
def test_heights_reported_before_the_way_of_counting_changes_stay_where_they_are(
    controller: str, letter: str
) -> None:
    hole = ["r {0} 5 2", "f {0} 5 -10", "r {0} 5 2"]
    row = read(HEAD + f"G99 G81 X5. Y5. R2. Z-10.\nG91 X10. {letter}3\nG90 X3.\nG80\n", controller)
    there = [move.format(x) for x in (5, 15, 25, 35, 3) for move in hole]
    assert path(row) == ["r 5 5 20", *there] and not errors(row)
    kept = read(HEAD + f"G91 G99 G81 R-18. Z-12. {letter}0\nG90 X5. Y5.\nG91 Z-2. X1.\nG80\n", controller)
    assert path(kept) == ["r 5 5 20", *[move.format(5) for move in hole], "r 6 5 2", "f 6 5 0", "r 6 5 2"]


def test_one_finding_tells_a_cycle_that_is_refused_with_its_holes() -> None:
    holes = "".join(f"X{k}.\n" for k in range(2, 23))
    program = read(
        HEAD + "G1 X1.\nG81 X1. Z5. R2.\n" + holes + "G80\nG81 X1. R2.\nX3.\nG80\nG1 X9.\n", "fanuc"
    )
    found = [one for one in program.findings if "not written out" in one.text]
    assert [(one.code, one.line, one.value) for one in found] == [
        ("cycle-not-interpreted", 4, 22.0), ("cycle-not-interpreted", 27, 2.0)
    ]  # fmt: skip
    assert "22 holes" in found[0].text
    assert "word-not-interpreted" not in [one.code for one in program.findings]
