# SPDX-License-Identifier: LGPL-2.1-or-later
"""Subprograms of Siemens 840D in folders, and the option that names these."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from test_nc_cycles import errors, read

from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.nc.reader import Assumed

HEAD = "G0 G90 G71 X0 Y0 Z20 A0 C0\nG1 F100\n"
PROGRAMS = {
    "L100.SPF": "G91 X1\nG90\nM17\n", "row.spf": "%_N_ROW_SPF\nPROC ROW(REAL FAR, INT TIMES=2) SAVE ; a row\nDEF INT K\nNEXT: K=K+1\n"
    "X=FAR*K\nIF K<TIMES GOTOB NEXT\nRET\nX99\n", "OUTER.MPF": "ROW(10,1)\nR1=R1+1\nY=R1\nM30\n", "LOOP.SPF": "LOOP\nRET\n",
}  # fmt: skip


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name, text in PROGRAMS.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    return tmp_path


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        ("L100\nX5\n", [(1, 0), (5, 0)]), ("N10 L100 P3\n", [(1, 0), (2, 0), (3, 0)]), ("ROW(3)\nX0\n", [(3, 0), (6, 0), (0, 0)]),
        ("R1=1\nROW(R1+1,3)\n", [(2, 0), (4, 0), (6, 0)]), ("R1=6\nOUTER\nX=R1\n", [(10, 0), (10, 7), (7, 7)]),
        ('EXTCALL "SUB/L100.SPF"\n', [(1, 0)]), ('CALL "L100"\n', [(1, 0)]), ("PCALL ROW(4,1)\n", [(4, 0)]), ("IF 1\nL100\nENDIF\n", [(1, 0)]),
    ],
)  # fmt: skip
def test_called_programs_are_found_and_run(text: str, ends: list[tuple[float, float]], folder: Path) -> None:
    program = read(HEAD + text, "siemens840d", Assumed(search=(str(folder),)))
    assert not errors(program), program.findings
    np.testing.assert_allclose(program.words[1:, :2], ends, atol=1e-9)
    assert program.line[1] in (3, 4)  # that of the call


@pytest.mark.parametrize(
    "text", ["L100", "N20 L7 P2", "ROW(3)", "ROW", 'EXTCALL "ROW.SPF"', "CALL ROW", "MCALL L100"]
)
def test_a_call_that_is_not_found_is_an_error_with_its_line(text: str) -> None:
    program = read(HEAD + text + "\nX8\n", "siemens840d")
    found = [one for one in program.findings if one.code == "call-not-interpreted"]
    assert found and found[0].line == 3 and errors(program) and program.words[-1, 0] == 8


def test_values_beyond_the_head_are_named_and_the_place_of_a_call_alone_counts(folder: Path) -> None:
    program = read(HEAD + "ROW(1,2,3)\n", "siemens840d", Assumed(search=(str(folder),)))
    assert "more values" in program.findings[0].text and program.findings[0].line == 3
    assert not errors(
        read(
            HEAD + "TRAORI\nTRAFOOF\nCYCLE832(0.1)\nSUPA\nX1\n", "siemens840d", Assumed(search=(str(folder),))
        )
    )


def test_the_program_lies_beside_or_in_a_folder_that_is_named(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    apart = folder / "apart"
    apart.mkdir()
    text = HEAD + "L100\nX8\nM30\n"
    for place in (folder, apart):
        (place / "main.mpf").write_text(text, encoding="utf-8")
    job = ["audit", "--machine", "trunnion_ac", "--controller", "siemens840d", "--quiet"]
    assert main([*job, str(folder / "main.mpf")]) == 0
    assert main([*job, str(apart / "main.mpf")]) == 1
    assert main([*job, str(apart / "main.mpf"), "--search", str(apart), "--search", str(folder)]) == 0
    capsys.readouterr()
    assert main([*job, str(apart / "main.mpf"), "--search", "nowhere"]) == 2
    message = capsys.readouterr().err.splitlines()
    assert len(message) == 1 and "--search nowhere is no folder; name one" in message[0]
