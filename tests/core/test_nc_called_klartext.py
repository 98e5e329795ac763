# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext programs in files of their own: by hand."""

from __future__ import annotations

from pathlib import Path

import pytest
from test_nc_cycles import LINKS, errors, path

from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.reader import Assumed, called_klartext, read_nc

HEAD = "0 BEGIN PGM MAIN MM\n1 L X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n2 Q1 = 5\n"
SIDE = """0 BEGIN PGM SIDE MM ; "quoted" ; note
1 * - a heading with M30
2 L X+Q1 F100 ; never M2
3 Q1 = Q1 + 1
4 CALL LBL 1
5 FN 9: IF +0 EQU +0 GOTO LBL 9
6 LBL 1
7 L IY+1
8 LBL 0
9 LBL 9
10 CALL PGM DEEP
11 END PGM SIDE MM
"""
DEEP = (
    "0 BEGIN PGM DEEP MM\n1 LBL 1\n2 L IZ-1\n3 LBL 0\n4 CYCL DEF 201 REAM ~\n   Q200=1\n5 END PGM DEEP MM\n"
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "Side.h").write_bytes(SIDE.replace("\n", "\r\n").encode())
    (tmp_path / "deep.H").write_text(DEEP)
    return tmp_path


def read(text: str, *folders: Path) -> Program:
    return read_nc(
        text.encode(), LINKS, DIALECTS["heidenhain"], assumed=Assumed(search=tuple(map(str, folders)))
    )


def test_a_call_runs_the_file_its_own_labels_and_the_calls_in_it(folder: Path) -> None:
    text = (
        HEAD
        + "3 CALL PGM TNC:\\nc\\SIDE.H\n4 LBL 1\n5 L Y+50 F100\n6 LBL 0\n7 CALL PGM SIDE\n8 M30\n9 END PGM MAIN MM\n"
    )
    program = read(text, folder)
    assert not errors(program), program.findings
    assert path(program) == [
        "f 5 0 20",
        "f 5 1 20",
        "f 5 1 19",
        "f 5 50 19",
        "f 6 50 19",
        "f 6 51 19",
        "f 6 51 18",
    ]
    assert program.line.tolist() == [2, 4, 4, 4, 6, 8, 8, 8]


def test_a_call_that_repeats_comes_back_each_time(folder: Path) -> None:
    program = read(HEAD + "3 LBL 5\n4 CALL PGM DEEP\n5 CALL LBL 5 REP 2\n6 END PGM MAIN MM\n", folder)
    assert path(program) == ["f 0 0 19", "f 0 0 18", "f 0 0 17"]


@pytest.mark.parametrize(
    ("name", "other"),
    [("NOWHERE", ""), ("SIDE", SIDE.replace("SIDE MM", "SIDE INCH")), ("SIDE", SIDE.replace("LBL 0", "LBL 0\nL Z+0 M30")), ("QS5", "")],
)  # fmt: skip
def test_a_program_that_cannot_be_run_stays_named(folder: Path, name: str, other: str) -> None:
    if other:
        (folder / "Side.h").write_text(other)
    program = read(HEAD + f"3 CALL PGM {name}\n4 L X+1 F100\n5 END PGM MAIN MM\n", folder)
    found = next(one for one in program.findings if one.code == "call-not-interpreted")
    assert found.line == 4 and path(program) == ["f 1 0 20"]


def test_what_is_not_understood_in_a_program_that_is_called_has_the_line_of_the_call(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "deep.H").write_text("0 BEGIN PGM DEEP MM\n1 L X+Q77\n2 END PGM DEEP MM\n")
    text = HEAD + "3 L X+1 F100\n4 CALL PGM DEEP\n5 END PGM MAIN MM\n"
    found = next(one for one in read(text, folder).findings if one.code == "macro-not-interpreted")
    assert found.line == 5 and "Q77" in found.text
    (folder / "deep.H").write_text(DEEP.replace("2 L IZ-1", "2 CYCL CALL"))
    drilled = read(text.replace("L X+1", "CYCL DEF 201 R ~\n Q200=1\nL X+1"), folder)
    assert [one.line for one in drilled.findings if one.code == "cycle-not-interpreted"] == [7]
    monkeypatch.setattr(called_klartext, "MOST", 0)
    assert "more than 0 programs" in read(text, folder).findings[0].text


def test_a_program_that_calls_itself_does_not_hang(folder: Path) -> None:
    (folder / "deep.H").write_text("0 BEGIN PGM DEEP MM\n1 L IX+1 F100\n2 CALL PGM DEEP\n3 END PGM DEEP MM\n")
    with pytest.raises(Exception, match="nested deeper"):
        read(HEAD + "3 CALL PGM DEEP\n4 END PGM MAIN MM\n", folder)
