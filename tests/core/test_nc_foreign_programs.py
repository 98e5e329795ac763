# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words of programs that other people's posts and hands write: none is passed over without a word."""

from __future__ import annotations

import pytest
from test_nc_cycles import errors, path, read

from freecad_fiveaxis.core.base.findings import Severity

ISO = "G21 G90 G94 F100\nG0 X0. Y0. Z20. A0. C0.\n"
SIEMENS = "G71 G90 G94 F100\nG0 X0 Y0 Z20 A0 C0\n"
KLARTEXT = "BEGIN PGM A MM\nL X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n"


def codes_of(program) -> dict[str, int]:
    return {found.code: found.line for found in program.findings if found.severity is not Severity.NOTE}


@pytest.mark.parametrize(
    "text",
    [
        "L X+5 ~\n  Y+3 F100\nL Z+1 ~ \n ~\n  Y+4\n", "/ L X+5 ~\nY+3 F100\n; ~\nL Z+1 ~\nY+4\n",
        "CC X+0 ~\nY+0\nLP PR+5 ~\nPA+0 ~\nF100\nL Y+3\nL Y+4 ~\nZ+1 \n", "Q1=5\nL X+Q1 ~\n  Y+3 F100\nL Z+1 ~\n  Y+4\n",
    ],
)  # fmt: skip
def test_a_klartext_line_that_goes_on_moves_by_all_its_words(text: str) -> None:
    program = read(KLARTEXT + text + "END PGM A MM\n", "heidenhain")
    assert not errors(program) and path(program)[-1] == "f 5 4 1"
    assert path(program)[0] in ("f 5 3 20", "f 5 0 20") and (program.feed[1:] == 100).all()


def test_a_klartext_vector_in_the_next_line_turns_the_tool() -> None:
    text = "FUNCTION TCPM F TCP AXIS POS ~\nPATHCTRL VECTOR\nLN X+5 Y+2 Z+1 ~\nTX0 TY0.6 TZ0.8 F100\n"
    program = read(KLARTEXT + text + "END PGM A MM\n", "heidenhain")
    assert program.line.tolist() == [2, 5] and program.guided.vector[1].tolist() == [0, 0.6, 0.8]


def test_a_machine_position_by_supa_between_blocks_is_named_as_g53_is() -> None:
    text = "G1 Z1\n{} G0 Z0\nG0 X6 Y1\nZ5\nG1 Z1\n{} G0 Z0\nM30\n"
    supa, g53 = (read(SIEMENS + text.format(name, name), "siemens840d") for name in ("SUPA", "G53"))
    assert codes_of(supa) == codes_of(g53) == {"machine-position": 4}
    assert "SUPA" in str([found.text for found in supa.findings])
    retract = read(SIEMENS + "G1 Z1\nSUPA G0 Z0 D0\nM30\n", "siemens840d")
    assert codes_of(retract) == {}
