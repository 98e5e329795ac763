# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is typed into boxes is read as it was meant, or refused with a reason: never as another number, and
never so that FreeCAD ends."""

import math

import FreeCAD
import pytest

from freecad_fiveaxis.app.typed import check_range, read_typed
from freecad_fiveaxis.core.base.errors import SettingsError

READ = [
    ("45 deg 30'", "angle", 45.5), ("45° 30' 15\"", "angle", 45.5 + 15 / 3600), ("45° 30'' ", "angle", 45 + 30 / 3600),
    ("-45°30'", "angle", -45.5), ("30'", "angle", 0.5), ("0.1 rad", "angle", math.degrees(0.1)), ("30 gon", "angle", 27.0),
    ("0,5", "number", 0.5), ("0.5", "number", 0.5), ("1/2", "number", 0.5), (",5", "number", 0.5), ("-3/4", "number", -0.75),
    ("1e3", "number", 1000.0), ("(2+3)*4 - 2^3", "number", 12.0), ("pi", "number", math.pi), ("1 1/4", "number", 1.25),
    ("1/4 in", "length", 6.35), ("1 1/4 in", "length", 31.75), ("10 mm / 3", "length", 10 / 3), ("10 µm", "length", 0.01),
    ("5' 3 1/2\"", "length", 1612.9), ("-5' 3\"", "length", -1600.2), ("2 m + 3 cm - 1 mm", "length", 2029.0),
    ("−3 mm", "length", -3.0), ("0,125", "length", 0.125), ("2 mm²/mm", "length", 2.0), ("1.125", "length", 1.125),
    ("4/2", "whole", 2.0), ("5", "whole", 5.0),
]  # fmt: skip
REFUSED = [
    ("30 mm", "angle"), ("30 deg", "length"), ("30 mm", "number"), ("2 mm^2", "length"), ("1 mm + 1 deg", "length"),
    ("1 mm + 2", "length"), ("2 mm^100", "length"), ("5 mm^200", "length"), ("mm mm mm", "length"), ("1/0", "number"),
    ("1e999", "number"), ("nan", "number"), ("inf", "number"), ("1_000", "number"), ("1 2", "number"), ("1,2,3", "number"),
    ("0x10", "number"), ("", "number"), ("(", "number"), ("(" * 150, "number"), ("1" * 300, "number"), ("9^4^4^4", "number"),
    ("1 kg", "length"), ("1 e", "number"), ("rubbish", "length"), ("1.5", "whole"), ("1/2", "whole"), ("(-8)^(1/3)", "number"),
    ("1e200^4", "number"), ("1..5", "number"), ("45 deg 30' x", "angle"), ("@", "length"), ("50%", "number"), ("0^-1", "number"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "kind", "number"), READ)
def test_numbers_fractions_and_sums_with_units_are_read(text, kind, number):
    assert read_typed(text, kind) == pytest.approx(number, rel=1e-12)


@pytest.mark.parametrize(("text", "kind"), REFUSED)
def test_what_is_not_meant_so_is_refused_with_the_text(text, kind):
    with pytest.raises(SettingsError) as refused:
        read_typed(text, kind)
    assert str(refused.value).startswith(f"{text} is no ")


def test_the_unit_of_a_box_may_stand_behind_the_number_and_others_are_turned_into_it():
    for text, feed in (
        ("1000", 1000),
        ("1000 mm/min", 1000),
        ("10 mm/s", 600),
        ("1 m/min", 1000),
        ("100 in/min", 2540),
    ):
        assert read_typed(text, "feed", 1 / 60, tail=" mm/min") == pytest.approx(feed), text
    assert read_typed("254 mm/min", "feed", 25.4 / 60, tail=" in/min") == pytest.approx(10.0)
    assert read_typed("8000 1/min", "whole", tail=" 1/min") == 8000.0
    assert read_typed("6 °/s", "turns", 1 / 60, tail=" °/min") == pytest.approx(360.0)
    assert read_typed("2 m/s^2", "acceleration", tail=" mm/s²") == pytest.approx(2000.0)
    assert read_typed("2 m/s²", "acceleration", tail=" mm/s²") == pytest.approx(2000.0)
    assert read_typed("2 in", "length", 25.4) == pytest.approx(2.0) and read_typed("2", "length", 25.4) == 2.0


@pytest.mark.parametrize(("text", "point"), [("1,000", "."), ("12.500", ","), ("1.000 mm", ",")])
def test_a_sign_that_may_be_that_of_thousands_is_refused(text, point):
    with pytest.raises(SettingsError, match="two ways; type "):
        read_typed(text, "length", point=point)


def test_a_number_that_a_box_does_not_hold_is_refused():
    check_range("5", 5.0, 0.0, 1e7)
    with pytest.raises(SettingsError, match=r"^1e99 is out of range; type 0 to 10000000$"):
        check_range("1e99", 1e99, 0.0, 1e7)


def test_every_unit_of_length_that_freecad_knows_is_known():
    for name in ("nm", "um", "µm", "mm", "cm", "dm", "m", "km", "in", "ft", "thou", "mil", "yd", "mi"):
        assert read_typed(f"3 {name}", "length") == pytest.approx(
            FreeCAD.Units.Quantity(f"3 {name}").Value
        ), name
