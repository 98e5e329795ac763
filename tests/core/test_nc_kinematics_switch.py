# SPDX-License-Identifier: LGPL-2.1-or-later
"""G12.1 P and G13.1, the coming switch of LinuxCNC's kinematics: the same as M428 and M429."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_languages import codes_of, read

from freecad_fiveaxis.core.base.findings import Severity

TEXT = "G21 G90 G94 F500\nG0 X0 Y0 Z50 A0 C0\n{on}\nG0 X1 Y2 Z40 A20 C30\nG1 X5 C45\n{off}\nG1 Z90\nM2\n"


@pytest.mark.parametrize(
    ("on", "off"), [("G12.1 P0", "G13.1"), ("G12.1 P0", "G12.1 P1"), ("G12.1P0", "G13.1")]
)
def test_the_codes_switch_as_the_remaps_do(on: str, off: str) -> None:
    remap, code = (
        read(TEXT.format(on="M428", off="M429"), "linuxcnc"),
        read(TEXT.format(on=on, off=off), "linuxcnc"),
    )
    assert code.guided is not None and code.guided.on.tolist() == [False, True, True, False]
    np.testing.assert_array_equal(code.words, remap.words)
    assert codes_of(code, Severity.WARNING) == [] and codes_of(code).count("kinematics-number") == 1


def test_g49_ends_no_kinematics_that_g12_1_selected_and_g13_1_needs_no_number() -> None:
    program = read(
        "G21 G90 F500\nG12.1 P0\nG0 X0 Y0 Z50 A20 C30\nG49\nG43 H2\nG1 X1\nG13.1\nG1 X2\nM2\n", "linuxcnc"
    )
    assert program.guided is not None and program.guided.on.tolist() == [True, True, False]


def test_g13_1_ends_what_g43_4_and_g43_5_began() -> None:
    for on in ("G43.4 H1", "G43.5 H1"):
        program = read(f"G21 G90 F500\n{on}\nG0 X0 Y0 Z50 A20 C30\nG13.1\nG1 X2\nM2\n", "linuxcnc")
        assert program.guided is not None and program.guided.on.tolist() == [True, False]


def test_a_vector_under_g43_5_leads_where_its_rotary_words_lead() -> None:
    head = "G21 G90 F500\nG12.1 P0\nG43.5 H1\nG0 X0 Y0 Z50 A0 C0\n"
    words = read(head + "G1 X5 A-30 C0\nM2\n", "linuxcnc")
    vector = read(head + "G1 X5 I0 J0.5 K0.8660254037844387\nM2\n", "linuxcnc")
    np.testing.assert_allclose(vector.words, words.words, atol=1e-7)


def test_a_number_that_is_not_known_and_one_that_is_not_reported_are_errors() -> None:
    other = read("G21 G90 F500\nG0 X0 Y0 Z50 A0 C0\nG12.1 P2\nG1 X2\nM2\n", "linuxcnc")
    assert [(found.code, found.line) for found in other.findings if found.severity is Severity.ERROR] == [
        ("kinematics-not-known", 3)
    ]
    polar = read("G21 G90 F500\nG0 X0. Y0. Z50. A0. C0.\nG12.1\nG1 X2. C3.\nG13.1\nM30\n", "fanuc")
    assert [(found.code, found.line) for found in polar.findings if found.severity is Severity.ERROR] == [
        ("polar-not-interpreted", 3)
    ]
