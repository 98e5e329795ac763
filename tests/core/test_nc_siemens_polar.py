# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polar words of Siemens 840D, and arcs by an opening angle or a point between: by closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import errors, read

HEAD = "G71 G90 G17 G94 F100\nG0 X10 Y0 Z5 A0 C0\n"
HALF, COSINE = 0.5, float(np.cos(np.pi / 6))


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("G1 RP=20 AP=30", (20 * COSINE, 10)), ("G111 X10 Y5\nG1 AP=90 RP=4", (10, 9)), ("G110 X5 Y=1\nG1 AP=180 RP=4", (11, 1)),
        ("G111 X1 Y1\nG112 X2 Y3\nG1 AP=0 RP=4", (7, 4)), ("G110 AP=90 RP=5\nG1 AP=0 RP=1", (11, 5)),
        ("G1 RP=20 AP=30\nAP=IC(60)", (0, 20)), ("G1 RP=20 AP=90\nRP=IC(5)", (0, 25)), ("R1=20 R2=30\nG1 RP=R1 AP=R2*3", (0, 20)),
        ("G111 X0 Y0\nG1 AP=180 RP=5\nTRANS X100\nG111 X=1 Y=1\nAP=0 RP=1", (102, 1)),
        ("G0 X0 Y0 Z5\nG18\nG111 Z0 X0\nG1 AP=90 RP=3\nG17", (3, 0)), ("G111 X3 Y0\nMCALL CYCLE81(10,0,2,-5)\nAP=90 RP=5\nMCALL", (3, 5)),
    ],
)  # fmt: skip
def test_polar_words_lead_about_the_pole(text: str, end: tuple[float, float]) -> None:
    program = read(HEAD + text + "\nM30\n", "siemens840d")
    assert not errors(program), program.findings
    np.testing.assert_allclose(program.words[-1, :2], end, atol=1e-6)


@pytest.mark.parametrize(
    ("text", "centre", "end", "sweep"),
    [
        ("G3 RP=10 AP=90", (0, 0), (0, 10), 90), ("G2 RP=10 AP=90", (0, 0), (0, 10), 270), ("G3 X0 Y10 AR=90", (0, 0), (0, 10), 90),
        ("G3 X0 Y10 AR=270", (10, 10), (0, 10), 270), ("G2 X0 Y10 AR=90", (10, 10), (0, 10), 90), ("G3 I-10 J0 AR=135", (0, 0), (-10 * 2**-0.5, 10 * 2**-0.5), 135),
        ("G2 I=AC(0) J=AC(0) AR=45", (0, 0), (10 * 2**-0.5, -10 * 2**-0.5), 45), ("CIP X0 Y10 I1=0 J1=-10", (0, 0), (0, 10), 270),
        ("CIP X=IC(-10) Y=IC(10) I1=IC(-20) J1=0 Z5 K1=5", (0, 0), (0, 10), 270), ("G91\nG3 X-10 Y10 AR=90", (0, 0), (0, 10), 90),
        ("N5 CIP X-10 Y0 I1=0 J1=10\nN6 G1 X-10", (0, 0), (-10, 0), 180),
    ],
)  # fmt: skip
def test_arcs_go_round_their_centre_so_far(
    text: str, centre: tuple[float, float], end: tuple[float, float], sweep: float
) -> None:
    program = read(HEAD + text + "\nM30\n", "siemens840d")
    assert not errors(program), program.findings
    off = program.words[:, :2] - centre
    np.testing.assert_allclose(np.hypot(*off.T), 10.0, atol=1e-6)
    np.testing.assert_allclose(program.words[-1, :2], end, atol=1e-6)
    angle = np.unwrap(np.arctan2(off[:, 1], off[:, 0]))
    assert abs(np.degrees(angle[-1] - angle[0])) == pytest.approx(sweep, abs=1e-4)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("G91\nG1 AP=30 RP=5", "polar-not-interpreted"), ("G111 X5\nG1 AP=30 RP=5", "polar-not-interpreted"), ("G1 AP=30", "polar-not-interpreted"),
        ("G1 AP=30 RP=5 X3", "polar-not-interpreted"), ("G111 X5 Y5\nROT Z30\nG1 AP=30 RP=5", "polar-not-interpreted"), ("G1 AP=30 RP=-5", "polar-not-interpreted"),
        ("G111 X5 Y5\nG18\nG1 AP=30 RP=5", "polar-not-interpreted"), ("ROT Z30\nG3 X0 Y10 AR=90", "arc-not-interpreted"), ("G3 X0 Y10 AR=0", "arc-not-interpreted"),
        ("CIP X0 Y10 I1=0 J1=-10 K1=7", "arc-not-interpreted"), ("CIP X0 Y10 Z7 I1=0 J1=-10", "arc-not-interpreted"), ("CIP X20 Y0 I1=15 J1=0", "arc-not-interpreted"),
        ("G3 X0 Y10 I=AC(0) J=AC(0)\nG3 X-10 Y0", "arc-without-centre"), ("CIP X0 Y10 I1=0 J1=-10\nX5", "arc-without-centre"),
    ],
)  # fmt: skip
def test_what_is_not_known_stays_an_error(text: str, code: str) -> None:
    assert code in errors(read(HEAD + text + "\nG1 X1 Y1\nM30\n", "siemens840d"))
