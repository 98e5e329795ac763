# SPDX-License-Identifier: LGPL-2.1-or-later
"""R parameters and jumps of Siemens 840D."""

from __future__ import annotations

import pytest
from test_nc_cycles import errors, read

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.nc.reader import interpreter

HEAD = "G0 G90 G71 X0 Y0 Z20 A0 C0\nG1 F100\n"


@pytest.mark.parametrize(
    ("text", "ends"),
    [
        ("R1=5\nX=R1*2 Y=SIN(30)\nG1 X=R1+1 F=R1*100\n", [10, 6]), ("R1=2 R2=6\nN10 G1 X=(R1+R2)/4\n", [2]),
        ("R1=0\nWHILE R1<3\nR1=R1+1\nG1 X=R1\nENDWHILE\n", [1, 2, 3]), ("R1=2\nIF R1==2\nX1\nELSE\nX2\nENDIF\nX3\n", [1, 3]),
        ("R1=7\nIF R1>5 GOTOF ENDE\nX1\nENDE:\nX2\n", [2]), ("R1=0\nAGAIN: R1=R1+1\nX=R1\nIF R1<3 GOTOB AGAIN\nX9\n", [1, 2, 3, 9]),
        ("R1=0\nREPEAT\nR1=R1+1\nX=R1\nUNTIL R1>=2\n", [1, 2]), ("R1=0\nLOOP\nR1=R1+1\nIF R1==3 GOTOF N50\nX=R1\nENDLOOP\nN50 X=-R1\n", [1, 2, -3]),
        ("R1=1\nIF (R1>0) AND (R1<2)\nX4\nENDIF\nM30\nX=R1\n", [4]), ("R1=5\nMSG(\"R1=9\")\nX=AC(3) CR=2\nX=R1\n", [3, 5]),
    ],
)  # fmt: skip
def test_r_parameters_and_jumps_are_run(text: str, ends: list[float]) -> None:
    program = read(HEAD + text, "siemens840d")
    assert not errors(program), program.findings
    assert program.words[1:, 0].tolist() == pytest.approx(ends)


@pytest.mark.parametrize(
    ("line", "message"),
    [("X=R7", "R7 was never set"), ("R1=5 DIV 2", "not known"), ("IF R1==2", "no end"), ("GOTOF NOWHERE", "no line")],
)  # fmt: skip
def test_what_is_not_known_is_named_with_its_line(line: str, message: str) -> None:
    program = read(HEAD + line + "\nX8\n", "siemens840d")
    found = [one for one in program.findings if one.severity is Severity.ERROR]
    assert message in found[0].text and found[0].line == 3 + line.count("\n") and program.words[-1, 0] == 8


def test_a_loop_that_does_not_end_is_refused_and_findings_keep_their_lines(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(interpreter, "MOST", 20_000)
    with pytest.raises(ProgramError, match="does not end"):
        read(HEAD + "LOOP\nR1=1\nENDLOOP\n", "siemens840d")
    program = read(HEAD + "R1=0\nWHILE R1<3\nR1=R1+1\nX=R1\nENDWHILE\nSUBPROG\n", "siemens840d")
    assert [found.line for found in program.findings if found.code == "call-not-interpreted"] == [8]
    assert program.line.tolist() == [1, 6, 6, 6]


def test_lines_are_those_of_the_file_beside_a_line_that_is_left_out() -> None:
    program = read(
        "G90 G710\nG0 X0 Y0 Z9 A0 C0\nG1 F9\nAB: X5\nBC: X1\nREPEAT AB BC P=2\nX= IC( 3\nX7\nM30\n",
        "siemens840d",
    )
    assert program.line.tolist() == [2, *[4, 5] * 3, 8]
    assert [found.line for found in program.findings if found.code == "macro-not-interpreted"] == [7]
