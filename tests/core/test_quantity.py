# SPDX-License-Identifier: LGPL-2.1-or-later
import math

import pytest

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.quantity import (
    LENGTHS,
    parse_angle,
    parse_feed,
    parse_length,
    parse_stack,
    parse_triple,
    stack_text,
)


@pytest.mark.parametrize(
    ("text", "mm"),
    [
        ("12", 12),
        ("12mm", 12),
        ("0.5in", 12.7),
        ('0.5"', 12.7),
        ("1.2 cm", 12),
        ("1e-2", 0.01),
        (3, 3),
        ("-.5", -0.5),
    ],
)
def test_lengths_come_out_in_mm(text, mm):
    assert parse_length(text) == pytest.approx(mm, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "rad"), [("180", math.pi), ("2deg", math.pi / 90), ("0.25rad", 0.25), ("90°", math.pi / 2)]
)
def test_angles_come_out_in_radians(text, rad):
    assert parse_angle(text) == pytest.approx(rad, rel=1e-15)


def test_feeds_come_out_in_mm_per_minute():
    assert parse_feed("10ipm") == 254.0
    assert parse_feed("2m/min") == 2000.0


@pytest.mark.parametrize(
    "text", ["", "mm", "1,5", "12 parsec", "1e999", "nan", "0x10", "1 2", "--3", None, [1]]
)
def test_what_is_no_length_is_named_in_the_error(text):
    with pytest.raises(SettingsError, match="is not a number") as error:
        parse_length(text, "scallop")
    assert "scallop" in str(error.value) and error.value.value is text


def test_an_angle_is_no_length():
    with pytest.raises(SettingsError):
        parse_length("5deg")


def test_triples_are_three_quantities():
    assert parse_triple("0,1in,-2", LENGTHS, "origin") == (0.0, 25.4, -2.0)
    assert parse_triple([1, 2, 3], LENGTHS, "origin") == (1.0, 2.0, 3.0)
    with pytest.raises(SettingsError, match="three numbers"):
        parse_triple("1,2", LENGTHS, "origin")


@pytest.mark.parametrize("stack", [(), ((40.0, 25.0), (63.5, 1 / 3)), ((1e-5, 1e4),)])
def test_a_stack_comes_back_from_its_text(stack):
    text = stack_text(stack)
    assert (parse_stack(text) if text else ()) == stack


def test_a_stack_is_written_as_people_do():
    assert stack_text(((40.0, 25.0), (63.5, 50.0))) == "40x25,63.5x50"
