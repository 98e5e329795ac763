# SPDX-License-Identifier: LGPL-2.1-or-later
"""Haas' dynamic work offset (G254) and tool center point control (G234), as programs for a UMC-750 have them:
by hand."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from test_nc_cycles import errors
from test_nc_planes import MIXED, TRUNNION, poses, read

from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.reader import Assumed, read_nc

ZERO = np.array([11.0, -7.0, 23.0])
CENTRES = ((np.array([3.0, 4.0, 0.0]), "z"), (np.array([0.0, 5.0, -60.0]), "x"))
"""Of the turntable C and of the trunnion A, in the machine, as test_nc_planes has them."""
HEAD = "%\nO10 (OURS)\nG00 G17 G40 G80 G90 G94 G21\nG53 G00 Z0.\nT3 M06\nS6000 M03\nG54\n"
TURNED = "M11\nM13\nG00 A30. C40.\nM10\nM12\n"


def carried(c: float, a: float) -> np.ndarray:
    """How far the table carries the work zero, mm along X, Y and Z of the machine: turns about its centres,
    from the work out."""
    place = ZERO
    for angle, (centre, letter) in zip((c, a), CENTRES, strict=True):
        place = centre + Rotation.from_euler(letter, angle, degrees=True).inv().apply(place - centre)
    return place - ZERO


def haas(text: str, kinematics: Chain = TRUNNION) -> Program:
    return read(f"{HEAD}{text}M30\n%\n", "haas", kinematics)


def reasons(program: Program) -> list[tuple[str, int | None]]:
    return [(found.text, found.line) for found in program.findings if found.code == "offset-not-interpreted"]


def test_the_zero_of_g254_goes_with_the_table_about_the_centres_of_rotation() -> None:
    program = haas(TURNED + "G254\nG00 X7. Y3.\nG43 Z50. H03\nG01 Z-1. F800.\nX9. Y4.\nG255\n")
    reported = np.array([[7, 3, 50], [7, 3, -1], [9, 4, -1]], float)
    assert not errors(program), program.findings
    np.testing.assert_allclose(program.words[-3:, :3], reported + carried(40.0, 30.0), atol=1e-9)
    assert (program.words[-3:, 3:] == (40.0, 30.0)).all()
    tip, axis = poses(program, TRUNNION)
    assert np.linalg.norm(tip[-1] - tip[-2]) == pytest.approx(5**0.5) and (tip[-1] - tip[-2]) @ axis[
        -1
    ] == pytest.approx(0.0)


def test_after_g255_the_words_are_those_of_the_axes_again() -> None:
    program = haas(TURNED + "G254\nG00 X7. Y3.\nZ50.\nG255\nG00 X1. Y2.\nZ90.\n")
    np.testing.assert_allclose(program.words[-1, :3], [1, 2, 90], atol=1e-9)


def test_cycles_arcs_steps_and_inches_are_meant_under_g254() -> None:
    program = haas(
        TURNED
        + "G254\nG00 X7. Y3.\nZ50.\nG98 G81 X12. Y6. Z-5. R2. F200.\nG80\nG91 G01 X-1.\nG90 G20 G01 X1. Y1. Z1.\nG255\n"
    )
    zero = carried(40.0, 30.0)
    assert not errors(program), program.findings
    rows = np.array(
        [[12, 6, 50], [12, 6, 2], [12, 6, -5], [12, 6, 50], [11, 6, 50], [25.4, 25.4, 25.4]], float
    )
    np.testing.assert_allclose(program.words[-6:, :3], rows + zero, atol=1e-9)


def test_a_shift_by_g52_goes_with_the_table_too() -> None:
    plain, shifted = (
        haas(f"{shift}{TURNED}G254\nG00 X7. Y3.\nZ50.\nG255\n") for shift in ("", "G52 X2. Y-1. Z4.\n")
    )
    assert not errors(shifted), shifted.findings
    np.testing.assert_allclose(
        poses(shifted, TRUNNION)[0][-1] - poses(plain, TRUNNION)[0][-1], [2, -1, 4], atol=1e-9
    )


def test_each_call_takes_the_table_as_it_stands() -> None:
    program = haas(
        "G00 A30. C40.\nG254\nX0. Y0.\nZ10.\nG255\nG53 G00 Z0.\nG00 A0. C-90.\nG254\nX0. Y0.\nZ10.\nG255\n"
    )
    np.testing.assert_allclose(program.words[-1, :3], carried(-90.0, 0.0) + (0, 0, 10), atol=1e-9)


@pytest.mark.parametrize(
    ("text", "line", "why"),
    [
        ("G254\nG00 X0. Y0.\nZ9.\nG00 C50.\nX3.\n", 16, "rotary axes turn before G255"),
        ("G254\nG00 X0. Y0.\nZ9.\nG234 H03 X0. Y0. Z9.\nG49\n", 16, "the tip is guided"),
        ("G234 H03\nG254\nG00 X0. Y0.\nZ9.\n", 14, "the tip is guided"),
    ],
)
def test_what_the_manual_forbids_under_g254_is_an_error_with_its_reason(
    text: str, line: int, why: str
) -> None:
    program = haas(TURNED + text)
    assert [(why in message, at) for message, at in reasons(program)] == [(True, line)]


def test_words_of_rotary_axes_that_stand_already_are_no_turn() -> None:
    assert not errors(haas(TURNED + "G254\nG00 X0. Y0. A30. C40.\nZ9.\nG255\n"))


def test_where_the_centres_of_rotation_are_not_known_g254_and_planes_are_errors_with_that_reason() -> None:
    """As for ``recover``, which looks for them."""
    text = f"{HEAD}{TURNED}G254\nG00 X7. Y3.\nZ50.\nG255\nM30\n%\n"
    for one, name in (
        (text, "G254"),
        (text.replace("G254", "G68.2 X0. Y0. Z0. I0. J30. K0.").replace("G255", "G69"), "G68.2"),
    ):
        program = read_nc(one.encode(), TRUNNION, DIALECTS["haas"], assumed=Assumed(centres=False))
        (found,) = [message for message, _ in reasons(program)]
        assert found.startswith(name) and "centres of rotation" in found
        np.testing.assert_allclose(program.words[-1, :3], [7, 3, 50], atol=1e-9)


def test_a_head_that_turns_has_no_g254() -> None:
    program = read(f"{HEAD}G00 B30. C40.\nG254\nG00 X0. Y0.\nZ9.\nM30\n", "haas", MIXED)
    assert [("B turns the head" in message, at) for message, at in reasons(program)] == [(True, 9)]


def test_g234_of_a_umc_guides_until_g49() -> None:
    program = haas(
        "G00 A10. C20.\nG93\nG234 H03 X0. Y0. Z60. A10. C20.\nG01 X5. A12. C25. F90.\nG94\nG49\nG00 A0. C0.\nG53 G00 Z0.\n"
    )
    assert not errors(program) and program.guided is not None
    assert program.guided.on.tolist() == [True, True, False] and program.guided.tip[:2].tolist() == [
        [0, 0, 60],
        [5, 0, 60],
    ]


def test_m128_of_haas_is_a_relay_of_the_owner() -> None:
    program = haas("M128\nG1 X5 A10 F500\nM129\n")
    assert program.guided is None
    assert read("G21 G90\nG0 X0 Y0 Z9 A0 C0\nM128\nG1 X5 A10 F500\nM129\n", "linuxcnc").guided is not None
