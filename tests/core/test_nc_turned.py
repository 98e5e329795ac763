# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fanuc's G68 and G16: coordinates turned in the plane, and polar ones, by closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import errors, path, read

HEAD = "G21 G90 G94 G17 F100\nG0 X0 Y0 Z20 A0 C0\n"
HALF, COSINE = 0.5, float(np.cos(np.pi / 6))


@pytest.mark.parametrize("controller", ["fanuc", "haas"])
@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("G68 X0 Y0 R90.\nG1 X10 Y2", (-2, 10, 20)), ("G68 X1 Y1 R90.\nG1 X10 Y1", (1, 10, 20)), ("G68 X0 Y0 R30\nG1 X10 Y0 Z5", (10 * COSINE, 5, 5)),
        ("G68 X0 Y0 R90\nG1 X10\nG91 X2 Y1\nG90", (-1, 12, 20)), ("G68 X0 Y0 R90\nG69\nG1 X10", (10, 0, 20)), ("G18\nG68 X0 Z0 R90\nG1 X10 Z0", (0, 0, -10)),
        ("G52 X1\nG68 X0 Y0 R90\nG1 X10 Y0", (1, 10, 20)), ("G20\nG68 X1 Y0 R180\nG1 X0 Y0", (50.8, 0, 20)), ("G68 X0 Y0 R90\nG1 X1\nG69\nG68 X0 Y0 R180\nG1 X10 Y0", (-10, 0, 20)),
    ],
)  # fmt: skip
def test_g68_turns_the_coordinates_about_its_place(
    text: str, end: tuple[float, ...], controller: str
) -> None:
    program = read(f"{HEAD}{text}\nM30\n", controller)
    assert not errors(program), program.findings
    np.testing.assert_allclose(program.words[-1, :3], end, atol=1e-6)


def test_arcs_and_holes_stand_in_coordinates_that_are_turned() -> None:
    program = read(HEAD + "G68 X0 Y0 R90\nG1 X10 Y0\nG3 X0 Y10 I-10 J0\nM30\n", "fanuc")
    assert not errors(program) and program.words[-1, :2] == pytest.approx([-10, 0])
    np.testing.assert_allclose(np.hypot(*program.words[1:, :2].T), 10.0, atol=1e-9)
    holes = read(HEAD + "G68 X0 Y0 R90\nG0 X10 Y0 Z20\nG81 X10 Y0 Z-3 R2\nX12\nG80\nG69\nM30\n", "fanuc")
    assert not errors(holes), holes.findings
    assert sorted({(round(x, 9), round(y, 9)) for x, y in holes.words[holes.words[:, 2] == -3, :2]}) == [
        (0, 10), (0, 12),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("G16\nG1 X20 Y30", (20 * COSINE, 10)), ("G16\nG1 X20 Y30\nY90", (0, 20)), ("G16\nG1 X20 Y90\nX25", (0, 25)), ("G16 G1 X20 Y180\nG15\nX3 Y0", (3, 0)),
        ("G52 X1 Y1\nG16\nG1 X20 Y90", (1, 21)), ("G16\nG1 X5 Y90\nZ3", (0, 5)), ("G16\nG3 X10 Y0 R10\nG3 X10 Y90 R10", (0, 10)), ("G20\nG16\nG1 X1 Y90", (0, 25.4)),
        ("G16\nG81 X20 Y0 Z-1 R2\nY45\nY90\nG80\nG15", (0, 20)),
    ],
)  # fmt: skip
def test_g16_takes_radius_and_angle(text: str, end: tuple[float, ...]) -> None:
    program = read(f"{HEAD}{text}\nM30\n", "fanuc")
    assert not errors(program), program.findings
    np.testing.assert_allclose(program.words[-1, :2], end, atol=1e-6)


@pytest.mark.parametrize(
    ("text", "controller", "code"),
    [
        ("G68 X0 Y0", "fanuc", "offset-not-interpreted"), ("G68 R30", "fanuc", "offset-not-interpreted"), ("G91\nG68 X0 Y0 R30\nG90", "fanuc", "offset-not-interpreted"),
        ("G68 X0 Y0 R30\nG68 X0 Y0 R40", "fanuc", "offset-not-interpreted"), ("G68 X0 Y0 R30", "linuxcnc", "offset-not-interpreted"), ("G16\nG1 Y30", "fanuc", "polar-not-interpreted"),
        ("G16\nG91 G1 X3 Y30\nG90", "fanuc", "polar-not-interpreted"), ("G16\nG1 X3 Y30", "linuxcnc", "offset-not-interpreted"), ("G68.2 P1 X0 Y0 Z0 I1 J1 K1", "fanuc", "offset-not-interpreted"),
        ("G66 P9000 X1", "fanuc", "call-not-interpreted"),
    ],
)  # fmt: skip
def test_what_is_not_read_is_an_error(text: str, controller: str, code: str) -> None:
    assert code in errors(read(f"{HEAD}{text}\nG1 X7 Y1\nM30\n", controller))


def test_rows_of_holes_by_angles_lie_on_a_circle() -> None:
    program = read(HEAD + "G16\nG99 G81 X20 Y0 Z-1 R2\nY45\nY90\nG80\nG15\nM30\n", "fanuc")
    assert path(program) and not errors(program)
    bottom = program.words[program.words[:, 2] == -1, :2]
    expected = [(20 * np.cos(turn), 20 * np.sin(turn)) for turn in np.radians([0, 45, 90])]
    np.testing.assert_allclose(bottom, expected, atol=1e-6)
