# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boxes of lengths and angles: a machinist's text in every unit schema, and the very value back that was
given."""

import FreeCAD
import pytest

from freecad_fiveaxis.gui.panels.fields import QuantityField
from freecad_fiveaxis.gui.panels.measure_box import MeasureBox
from freecad_fiveaxis.gui.panels.summary import length
from freecad_fiveaxis.gui.play.readout import joint_text

SCHEMAS = {0: "mm", 1: "mm", 2: "in", 3: "in", 4: "mm", 5: "in", 6: "mm"}
TEXTS = {
    "mm": ["0.01 mm", "9.525 mm", "0.00002 mm", "0 mm"],
    "in": ["0.00039 in", "0.375 in", "0.00000079 in", "0 in"],
}


@pytest.fixture(params=SCHEMAS)
def schema(request):
    before = FreeCAD.Units.getSchema()
    FreeCAD.Units.setSchema(request.param)
    yield request.param
    FreeCAD.Units.setSchema(before)


def test_text_and_value_of_a_field(schema):
    field = QuantityField("tolerance", "length")
    for mm, text in zip((0.01, 9.525, 0.00002, 0.0), TEXTS[SCHEMAS[schema]], strict=True):
        field.show_value(mm)
        assert field.editor.text() == text
        assert field.value() == mm  # exactly, though the box shows a rounded one


def test_what_is_typed_is_read_in_any_unit(schema):
    box = MeasureBox("length")
    inch = SCHEMAS[schema] == "in"
    for text, mm in (
        ("0.5in", 12.7),
        ("10 µm", 0.01),
        ("2", 50.8 if inch else 2.0),
        ("1/4 in", 6.35),
        ("3 mm", 3.0),
    ):
        box.lineEdit().setText(text)
        box.interpretText()
        assert box.read_measure() == pytest.approx(mm, rel=1e-9), text
    box.lineEdit().setText("rubbish")
    box.interpretText()
    assert box.read_measure() == pytest.approx(3.0) and box.text().startswith(
        "0.11811 in" if inch else "3 mm"
    )


def test_angles():
    box = MeasureBox("angle")
    box.show_measured(27.5)
    assert box.text() == "27.5°"
    box.lineEdit().setText("0.1 rad")
    box.interpretText()
    assert box.read_measure() == pytest.approx(5.72957795, rel=1e-6)


def test_summary_and_readout(schema):
    inch = SCHEMAS[schema] == "in"
    assert length(FreeCAD.Units.Quantity(0.0123456, FreeCAD.Units.Length)) == (
        "0.00049 in" if inch else "0.0123 mm"
    )
    assert (
        joint_text(25.4, False) == ("1.00000 in" if inch else "25.4000 mm")
        and joint_text(25.4, True) == "25.4000°"
    )


def test_an_angle_that_is_found_where_none_is_given_says_so():
    field = QuantityField("max_axis_angle", "angle", optional=True)
    assert field.editor.text() == "automatic" and field.value() is None
    for typed, text, value in (
        ("120", "120°", 120.0),
        ("automatic", "automatic", None),
        ("90 °", "90°", 90.0),
        ("0", "automatic", None),
    ):
        field.editor.lineEdit().setText(typed)
        field.editor.interpretText()
        assert (field.editor.text(), field.value()) == (text, value)
    assert QuantityField("tool_length", "length", optional=True).editor.text().startswith("0 ")
