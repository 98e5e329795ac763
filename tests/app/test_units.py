# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths as a machinist reads them, whatever unit schema the user has: mm or inches, no exponent, no
fraction, no other multiple."""

import re

import FreeCAD
import pytest

from freecad_fiveaxis.app import units, wording
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.sentences import IN_FULL, Angle, Area, Feed, Length, Point, Turn, Volume, say

METRIC = {"standard": 0, "MKS": 1, "building Euro": 4, "metric small parts": 6, "FEM": 8}
IMPERIAL = {"US customary": 2, "imperial decimal": 3, "building US": 5, "civil": 7}


@pytest.fixture
def schema():
    before = FreeCAD.Units.getSchema()
    yield FreeCAD.Units.setSchema
    FreeCAD.Units.setSchema(before)


@pytest.mark.parametrize("number", METRIC.values(), ids=METRIC)
def test_metric(schema, number):
    schema(number)
    texts = [
        units.length_text(mm) for mm in (0.0, 1e-5, 0.0001, 0.0123456, 0.01, 2.12642, 123.456789, 3000.0)
    ]
    assert texts == [
        "0 mm",
        "<0.0001 mm",
        "0.0001 mm",
        "0.0123 mm",
        "0.01 mm",
        "2.126 mm",
        "123.5 mm",
        "3000 mm",
    ]
    assert (
        units.area_text(12.5) == "12.5 mm²"
        and units.feed_text(1000.0) == "1000 mm/min"
        and units.angle_text(27.4156) == "27.42°"
    )


@pytest.mark.parametrize("number", IMPERIAL.values(), ids=IMPERIAL)
def test_imperial(schema, number):
    schema(number)
    texts = [units.length_text(mm) for mm in (0.0, 1e-5, 0.01, 25.4 * 0.00001, 9.525, 50.8, 2540.0)]
    assert texts == ["0 in", "<0.00001 in", "0.00039 in", "0.00001 in", "0.375 in", "2 in", "100 in"]
    assert (
        units.area_text(645.16) == "1 in²"
        and units.feed_text(1016.0) == "40 in/min"
        and units.angle_text(0.5) == "0.5°"
    )


@pytest.mark.parametrize(
    ("measure", "metric", "imperial"),
    [
        (Length(25.4, ".3f"), "25.4 mm", "1 in"),
        (Length(1.23456, ".3f"), "1.235 mm", "0.0486 in"),
        (Length((25.4, 50.8), "g", bare=True), "25.4, 50.8 mm", "1, 2 in"),
        (Point((25.4, 0.0, -12.7)), "(25.4, 0, -12.7) mm", "(1, 0, -0.5) in"),
        (Area(6451.6, ".4g"), "6452 mm²", "10 in²"),
        (Volume(16387.064, ".6g"), "16387.1 mm³", "1 in³"),
        (Feed(2540.0), "2540 mm/min", "100 in/min"),
        (Turn(2.0), "2 °/mm", "50.8 °/in"),
        (Angle(0.1234567, ".6g"), "0.1235°", "0.1235°"),
        (Length(1e-6, IN_FULL), "0.000001 mm", "0.00000003937008 in"),
        (Length(1e6, IN_FULL), "1000000 mm", "39370.08 in"),
    ],
)
def test_measures_of_sentences(schema, measure, metric, imperial):
    for number, text in ((0, metric), (3, imperial), (5, imperial)):
        schema(number)
        assert units.measure_text(measure) == text


@pytest.mark.parametrize("number", [*METRIC.values(), *IMPERIAL.values()])
def test_no_size_brings_an_exponent_a_fraction_or_another_unit(schema, number):
    schema(number)
    unit = "in" if units.inches() else "mm"
    for power in range(-12, 9):
        for mm in (10.0**power, -3.7 * 10.0**power):
            assert re.fullmatch(rf"[-<]?\d+(\.\d+)? {unit}", units.length_text(mm)), mm
            assert re.fullmatch(r"-?\d+(\.\d+)?", units.field_text(mm, 5)), mm


def test_what_is_edited_keeps_its_value():
    assert [units.field_text(value, 4) for value in (0.01, 10.0, 12.34567, 0.00002, 0.0)] == [
        "0.01",
        "10",
        "12.3457",
        "0.00002",
        "0",
    ]


def test_findings_and_errors_are_reported_in_the_users_units(schema):
    message = say("The tool enters the part by {depth} at {count} places.", depth=Length(5.08), count=203)
    schema(3)
    assert wording.localize(message) == "The tool enters the part by 0.2 in at 203 places."
    assert (
        wording.localize(SettingsError(say("tolerance is {tolerance}", tolerance=Length(0.0)), 0.0))
        == "tolerance is 0 in"
    )
    assert wording.localize("C:{x}") == "C:{x}" and wording.localize(ValueError("plain")) == "plain"
