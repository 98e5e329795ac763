# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sequence numbers in columns 73 to 80 of CL files, and statements that only reach there."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.toolpath.apt import read_apt

LINES = [
    ("FEDRAT/ 300.0000,MMPM", "FED    1"),
    ("GOTO  /    0.00000,    0.00000,   50.00000", "PT     1"),
    ("GOTO  /   10.00000,    0.00000,   50.00000, 0.000000, 0.000000, 1.000000", "PT     2"),
    ("GOTO  /   10.00000,   20.00000,   50.00000", "00000030"),
    ("CIRCLE/ 10.00000, 30.00000, 50.00000,$", "CIR    1"),
    (" 0.00000, 0.00000, 1.00000, 10.00000", "00000031"),
    ("GOTO  /   20.00000,   30.00000,   50.00000", "PT     3"),
]


def _card(statement: str, number: str) -> str:
    return f"{statement:72}{number}"


def test_sequence_numbers_are_no_part_of_statements() -> None:
    plain = read_apt("\n".join(statement for statement, _ in LINES))
    cards = read_apt("PARTNO X\nUNITS/MM\n" + "\n".join(_card(*line) for line in LINES) + "\nFINI\n")
    assert (
        len(plain.tip) > 20
        and np.array_equal(plain.tip, cards.tip)
        and np.array_equal(plain.feed, cards.feed)
    )
    assert plain.findings == cards.findings == ()


def test_numbers_may_stand_right_behind_a_statement() -> None:
    filled = f"{'GOTO/1.0,2.0,':66}3.0000"
    assert len(filled) == 72
    path = read_apt(f"FEDRAT/9\n{filled}00000010\n{filled}00000020\n{filled}00000030\n")
    assert path.tip.tolist() == [[1, 2, 3]] * 3


@pytest.mark.parametrize(
    ("last", "tip"),
    [
        ("GOTO/" + " " * 50 + "10.0,20.0,       300", [10, 20, 300]),  # the number belongs to the statement
        ("GOTO/10.000000000000000000000000,20.000000000000000000000000,300.0000000000000000", [10, 20, 300]),
        ("GOTO/" + " " * 50 + "10.0,20.0,30.00000.5", None),
    ],
)  # fmt: skip
def test_a_long_statement_keeps_its_numbers(last: str, tip: list[float] | None) -> None:
    assert len(last) > 72
    text = f"FEDRAT/9\nGOTO/1,2,3\n{last}\n"
    if tip is None:
        with pytest.raises(ProgramError, match="line 3"):
            read_apt(text)
    else:
        assert read_apt(text).tip[-1].tolist() == tip


def test_the_last_decimals_of_long_statements_are_no_sequence_numbers() -> None:
    text = "FEDRAT/9\n" + "\n".join(f"GOTO/{1:>40},{2:>10},{k}.{'0' * 13}{k}25" for k in range(1, 6))
    assert {len(line) for line in text.split("\n")[1:]} == {75}
    assert read_apt(text).tip[:, 2].tolist() == [float(f"{k}.{'0' * 13}{k}25") for k in range(1, 6)]
    filled = f"{'GOTO/1.0,2.0,':66}3.0000"
    assert (
        read_apt(f"FEDRAT/9\n{filled}00000010\n{filled}00000020\n").tip[:, 2] > 3.0
    ).all()  # two lines are too few to tell


@pytest.mark.parametrize(
    "numbers",
    [("PT     2", "PT     1"), ("PT     1", "PT     1"), ("PT     1", "P1.5"), ("PT     1", "PT      12345")],
)
def test_what_does_not_count_up_is_reported_as_before(numbers: tuple[str, str]) -> None:
    text = "\n".join(_card(f"GOTO/{k},0,0", number) for k, number in enumerate(numbers))
    with pytest.raises(ProgramError, match="line 1"):
        read_apt(text)


def test_errors_name_the_place_in_the_file_with_its_numbers() -> None:
    text = "\n".join(_card(statement, f"{k:8d}") for k, statement in enumerate(["GOTO/1,2,3", "GOTO/1,X2,3"]))
    with pytest.raises(ProgramError, match="line 2, column 8"):
        read_apt(text)
