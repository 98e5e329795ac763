# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext's mirror image, rotation and scalings (cycles 8, 10, 11, 26), by hand and by closed forms; what
cannot be run exactly is an error by name."""

from __future__ import annotations

import numpy as np
import pytest
from test_nc_cycles import errors, read

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.motion.program import Program

HEAD = "0 BEGIN PGM T MM\n1 L X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n"
HALF, COSINE = 0.5, float(np.cos(np.pi / 6))
SHIFT = "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+{}\nCYCL DEF 7.2 Y+{}\n"
ROT = "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 {}\n"
MIRROR = "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 {}\n"
SCALE = "CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 {}\n"
STRETCH = "CYCL DEF 26.0 AXIS-SPECIFIC SCALING\nCYCL DEF 26.1 {}\n"
TURNED = ROT.format("ROT+90")


def klartext(text: str) -> Program:
    return read(HEAD + text + "END PGM T MM\n", "heidenhain")


def named(program: Program) -> list[str]:
    return [one.text for one in program.findings if one.severity is Severity.ERROR]


@pytest.mark.parametrize(
    ("frame", "ends"),
    [
        (TURNED, (-2, 10, 5)), (ROT.format("ROT +30"), (10 * COSINE - 2 * HALF, 10 * HALF + 2 * COSINE, 5)),
        (ROT.format("ROT+60") + ROT.format("IROT+30"), (-2, 10, 5)), (TURNED + ROT.format("ROT+0"), (10, 2, 5)),
        (MIRROR.format("X"), (-10, 2, 5)), (MIRROR.format("X Y"), (-10, -2, 5)), (MIRROR.format("X") + MIRROR.format("Y"), (10, -2, 5)),
        (MIRROR.format("Z"), (10, 2, -5)), (MIRROR.format("X") + MIRROR.format(""), (10, 2, 5)),
        (SCALE.format("SCL 0.9"), (9, 1.8, 4.5)), (SCALE.format("SCL0.9") + SCALE.format("SCL1"), (10, 2, 5)),
        (STRETCH.format("X1.5 Y2 CCX+2 CCY+1"), (14, 3, 5)), (STRETCH.format("X 1.5") + STRETCH.format("X1"), (10, 2, 5)),
        (SHIFT.format(3, 4) + TURNED, (1, 14, 5)), (SHIFT.format(3, 4) + MIRROR.format("X"), (-7, 6, 5)),
        (SHIFT.format(3, 4) + TURNED + SHIFT.format(0, 0), (-2, 10, 5)), (SHIFT.format(3, 4) + TURNED + ROT.format("ROT+0"), (13, 6, 5)),
        (MIRROR.format("X") + TURNED, (2, 10, 5)), (TURNED + SCALE.format("SCL 2"), (-4, 20, 10)), (TURNED + MIRROR.format("X Y"), (2, -10, 5)),
        (SHIFT.format(3, 4) + MIRROR.format("X") + TURNED + SCALE.format("SCL 2"), (7, 24, 10)),
        ("Q1 = 90\n" + ROT.format("ROT+Q1"), (-2, 10, 5)), ("TOOL CALL 1 Y S100\n" + TURNED, (5, 2, -10)), (TURNED + "PLANE RESET STAY\n", (-2, 10, 5)),
    ],
)  # fmt: skip
def test_cycles_change_coordinates_in_the_order_of_the_manual(frame: str, ends: tuple[float, ...]) -> None:
    program = klartext(f"{frame}L X+10 Y+2 Z+5 F100\n")
    assert not errors(program), program.findings
    np.testing.assert_allclose(program.words[-1, :3], ends, atol=1e-9)


def test_what_ends_them_alone_is_silent_in_a_tilted_plane_too() -> None:
    off = ROT.format("ROT+0") + MIRROR.format("") + SCALE.format("SCL1")
    for plane in ("", "PLANE SPATIAL SPA+0 SPB+0 SPC+30 STAY\n"):
        text = plane + "{}L X+10 Y+2 Z+5 F100\n"
        with_them, without = klartext(text.format(off)), klartext(text.format(""))
        assert [one.text for one in with_them.findings] == [one.text for one in without.findings]
        assert with_them.words.tolist() == without.words.tolist()


def test_the_manuals_loop_goes_round_in_steps() -> None:
    part = "L X+10 Y+0 FMAX\nL Z+1 F100\nL Z+20 FMAX\n"
    loop = (
        SHIFT.format(65, 65)
        + "LBL 10\n"
        + ROT.format("IROT+45")
        + part
        + "CALL LBL 10 REP 6/6\n"
        + ROT.format("ROT+0")
        + SHIFT.format(0, 0)
        + "L X+1 Y+1 FMAX\n"
    )
    program = klartext(loop)
    assert not errors(program)
    place = program.words[1:-1:3, :2] - 65.0
    angle = np.radians(45.0 * np.arange(1, 8))
    np.testing.assert_allclose(place, 10.0 * np.column_stack([np.cos(angle), np.sin(angle)]), atol=1e-9)
    np.testing.assert_allclose(program.words[-1, :2], 1.0, atol=1e-9)


@pytest.mark.parametrize(
    ("frame", "middle", "radius", "sweep"),
    [
        (TURNED, (0, 10), 10, 90), (MIRROR.format("X"), (-10, 0), 10, -90), (MIRROR.format("X Y"), (-10, 0), 10, 90),
        (SCALE.format("SCL 0.5"), (5, 0), 5, 90), (MIRROR.format("X") + TURNED, (0, 10), 10, -90), (STRETCH.format("X2 Y2"), (20, 0), 20, 90),
    ],
)  # fmt: skip
def test_arcs_stay_round_and_a_mirror_image_turns_their_sense(
    frame: str, middle: tuple[float, ...], radius: float, sweep: float
) -> None:
    for arc in ("CC X+10 Y+0\nC X+10 Y+10 DR-\n", "CR X+10 Y+10 R+10 DR-\n"):
        program = klartext(frame + "L X+0 Y+0 Z+5 F100\n" + arc)
        assert not errors(program), program.findings
        place = program.words[program.line == program.line[-1], :2] - middle
        np.testing.assert_allclose(np.hypot(*place.T), radius, atol=1e-9)
        before = program.words[np.flatnonzero(program.line == program.line[-1])[0] - 1, :2] - middle
        angle = np.unwrap(np.arctan2(*np.vstack([before, place]).T[::-1]))
        assert np.degrees(angle[-1] - angle[0]) == pytest.approx(-sweep)


def test_words_that_stay_steps_and_inches_count_in_the_coordinates() -> None:
    program = klartext(TURNED + "L X+10 F100\nL IX+1\nL IY+2 Z+1\n" + ROT.format("ROT+0") + "L X+3\n")
    np.testing.assert_allclose(
        program.words[1:, :3], [(0, 10, 20), (0, 11, 20), (-2, 11, 1), (3, 11, 1)], atol=1e-9
    )
    inches = read((HEAD + TURNED + "L X+1 F100\n").replace("T MM", "T INCH"), "heidenhain")
    np.testing.assert_allclose(inches.words[-1, :2], (0, 25.4), atol=1e-9)


def test_f_is_that_of_the_scaled_way() -> None:
    program = klartext(
        SCALE.format("SCL 0.5") + "L X+0 Y+0 Z+0 F60\nL X+10\n" + MIRROR.format("X") + "L X+20\n"
    )
    np.testing.assert_allclose(program.words[2:, 0], (5, -10), atol=1e-9)
    np.testing.assert_allclose(program.seconds[2:], (5, 15))


def test_a_scaling_of_z_is_a_warning_of_older_controls() -> None:
    (found,) = klartext(SCALE.format("SCL 0.9") + "L X+10 F100\n").findings
    assert found.severity is Severity.WARNING and "MP7410" in found.text and found.line == 4


PLANE = "PLANE SPATIAL SPA+0 SPB+0 SPC+30 STAY\n"


@pytest.mark.parametrize(
    ("text", "name", "reason", "line"),
    [
        (TURNED + MIRROR.format("X"), "CYCL DEF 8", "comes first", 6), (STRETCH.format("X2") + TURNED, "CYCL DEF 10", "comes first", 6),
        (TURNED + "CYCL DEF 7.0\nCYCL DEF 7.1 X+5\n", "CYCL DEF 7", "comes first", 6), (PLANE + TURNED, "CYCL DEF 10", "tilted plane is on", 5),
        (TURNED + PLANE, "PLANE SPATIAL", "is on; end it", 5), (TURNED + "PLANE RESET TURN FMAX\n", "PLANE RESET", "is on; end it", 5),
        (MIRROR.format("X C"), "CYCL DEF 8", "rotary axis", 4), (MIRROR.format("Q5 5"), "CYCL DEF 8", "", 4), (SCALE.format("SCL 0"), "CYCL DEF 11", "0 or less", 4),
        (SCALE.format("SCL 11"), "CYCL DEF 11", "more than 10", 4), (ROT.format("ROT"), "CYCL DEF 10", "in this form", 4), (ROT.format("ROT+Q7"), "", "Q7", 4),
        (STRETCH.format("X2") + "L X+0 Y+0 F100\nCR X+10 Y+10 R+10 DR-\n", "CYCL DEF 26", "unlike factors", 6),
        (STRETCH.format("X2") + "L X+0 Y+5 F100\nRND R1\nL X+9\n", "CYCL DEF 26", "unlike factors", 5),
        ("CC X+10 Y+0\n" + TURNED + "L X+0 Y+0 F100\nC X+10 Y+10 DR-\n", "CC", "give CC again", 7),
        (TURNED + "M128\nLN X+1 Y+2 Z+3 TX+0.1 TY+0 TZ+0.99 F100\nM129\n", "LN", "by vectors", 6),
        (MIRROR.format("X") + "M128\nL X+9 A+5 F100\n", "CYCL DEF 8", "guides the tip", 6),
    ],
)  # fmt: skip
def test_what_cannot_be_run_exactly_is_named(text: str, name: str, reason: str, line: int) -> None:
    program = klartext(text + "L X+10 Y+2 Z+5 F100\n")
    found = [one for one in program.findings if one.severity is Severity.ERROR]
    assert any(name in one.text and reason in one.text and one.line == line for one in found), found


def test_a_refused_change_leaves_the_coordinates_as_they_were() -> None:
    program = klartext(TURNED + "CYCL DEF 7.0\nCYCL DEF 7.1 X+5\n" + MIRROR.format("X") + "L X+10 Y+2 F100\n")
    np.testing.assert_allclose(program.words[-1, :2], (-2, 10), atol=1e-9)
    assert len(named(program)) == 2


DRILLED = (
    "CYCL DEF 200 DRILLING Q200=2 Q201=-5 Q206=100 Q202=5 Q210=0 Q203=+0 Q204=2 Q211=0\n"
    "{}L X+10 Y+2 FMAX M99\nL Z+20 FMAX\n"
)


def test_holes_turn_with_the_coordinates_and_are_named_where_these_are_mirrored_or_scaled() -> None:
    program = klartext(DRILLED.format(TURNED))
    low = program.words[program.words[:, 2].argmin(), :3]
    np.testing.assert_allclose(low, (-2, 10, -5), atol=1e-9)
    assert not errors(program)
    for frame in (MIRROR.format("X"), SCALE.format("SCL 0.5"), STRETCH.format("Z2")):
        assert any("CYCL DEF 200 is not written out" in one for one in named(klartext(DRILLED.format(frame))))
    for frame in (MIRROR.format("X") + MIRROR.format(""), SCALE.format("SCL 0.5") + SCALE.format("SCL 1")):
        assert not errors(klartext(DRILLED.format(frame)))


BORED = (
    "; DM=6\nTOOL CALL 1 Z S1000\nL X+10 Y+2 FMAX\n{}CYCL DEF 208 BORE MILLING Q200=2 Q201=-5 Q206=100 Q334=1 Q203=+0 "
    "Q204=2 Q335=12\n{}L Z+20 FMAX M99\n"
)


@pytest.mark.parametrize("change", [TURNED, SHIFT.format(5, 0), ROT.format("ROT+0")])
def test_a_bore_about_a_place_from_before_a_change_of_the_coordinates_is_named(change: str) -> None:
    assert any("X and Y are not told before it" in one for one in named(klartext(BORED.format(change, ""))))
    program = klartext(BORED.format(change, "L X+10 Y+2 FMAX\n"))
    assert not errors(program)
    middle = {TURNED: (-2, 10), SHIFT.format(5, 0): (15, 2)}.get(change, (10, 2))
    low = program.words[program.words[:, 2] < -4.999, :2] - middle
    assert np.hypot(*low.T).max() == pytest.approx(3.0)
