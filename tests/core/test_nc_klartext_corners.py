# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext's RND and CHF: by closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import errors, read

HEAD = "BEGIN PGM A MM\nTOOL CALL 1 Z S1000\nL X+0 Y+0 Z+5 A+0 C+0 R0 FMAX\n"
END = "END PGM A MM\n"


def test_a_chamfer_takes_its_length_off_both_lines() -> None:
    program = read(HEAD + "5 L X+10 F100\n6 CHF 2 F50\n\n7 L Y+10\n" + END, "heidenhain")
    assert not errors(program), program.findings
    assert program.words[1:, :2].tolist() == [[8, 0], [10, 2], [10, 10]]
    assert program.feed[1:].tolist() == [100, 100, 100]


@pytest.mark.parametrize("word", ["RND R3", "RND R+3 F500", "RND R QL1"])
def test_a_rounding_is_tangent_to_both_lines(word: str) -> None:
    program = read(f"{HEAD}QL1=3\nL X+10 F100\n{word}\nL Y+10\n{END}", "heidenhain")
    assert not errors(program), program.findings
    arc = program.words[1:-1, :2]
    np.testing.assert_allclose(np.hypot(*(arc - (7, 3)).T), 3.0, atol=1e-9)
    assert arc[0] == pytest.approx((7, 0)) and arc[-1] == pytest.approx((10, 3))


def test_a_rounding_between_a_line_and_an_arc_is_tangent_to_both() -> None:
    """The line of the X axis and the circle of 10 about the zero, within which the corner of 2 lies."""
    program = read(HEAD + "CC X+0 Y+0\nL X+10 F100\nRND R2\nC X+0 Y+10 DR+\n" + END, "heidenhain")
    assert not errors(program), program.findings
    centre = np.array((60.0**0.5, 2.0))
    off = np.hypot(*(program.words[1:, :2] - centre).T)
    assert off[0] == pytest.approx(2.0) and np.hypot(*program.words[1:, :2].T).max() <= 10.0 + 1e-6
    assert (np.abs(off - 2.0) < 1e-6).sum() > 10


@pytest.mark.parametrize(
    "text",
    ["L X+10 F100\nRND R30\nL Y+10\n", "L X+10 FMAX\nRND R3\nL Y+10 F100\n", "L X+10 F100\nRND R3\nL Z+10\n", "L X+10 F100\nL X+20 Y+1\nCHF 2\nM3\nL X+9\n",
     "L X+10 F100\nRND R0\nL Y+10\n", "L X+10 F100\nRND R3\nRND R4\nL Y+10\n", "L X+10 F100\nCHF 2\nLBL 1\nL Y+10\n"],
)  # fmt: skip
def test_a_corner_that_cannot_be_is_an_error(text: str) -> None:
    found = errors(read(HEAD + text + END, "heidenhain"))
    assert {"corner-not-interpreted", "arc-not-interpreted"} & set(found)
