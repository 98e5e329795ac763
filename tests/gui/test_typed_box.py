# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is typed into the boxes of a panel, key by key: it is read as it was meant, or it stays as it was
typed, the box keeps its number, and the field says why."""

import pytest
from conftest import QtCore, QtWidgets

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.gui.panels.fields import FeedField, NumberField, QuantityField, SpindleField
from freecad_fiveaxis.gui.panels.machine_editor.boxes import AccelerationField, OpenField, RateField
from freecad_fiveaxis.gui.panels.rows import Rows
from freecad_fiveaxis.gui.panels.triple import RatioField, TripleField


@pytest.fixture
def show(window, pump):
    """show(field): a field and another one to go to, in a window of their own."""
    shown = []

    def place(field):
        rows = Rows()
        rows.add(field)
        rows.add(NumberField("other"))
        rows.resize(400, 300)
        rows.show()
        rows.activateWindow()
        shown.append(rows)
        pump(100)
        return field

    yield place
    for rows in shown:
        rows.close()


FIELDS = {
    "length": lambda: QuantityField("tolerance", "length"),
    "angle": lambda: QuantityField("lead", "angle"),
    "feed": lambda: FeedField("feed"),
    "rate": lambda: _rate(),
    "acceleration": lambda: _acceleration(),
    "number": lambda: NumberField("jump"),
    "ratio": lambda: RatioField("pass_axis_x"),
    "count": lambda: NumberField("tool", whole=True, optional=True),
    "speed": lambda: SpindleField("spindle"),
}


def _rate():
    field = RateField("axis_rate", "")
    field.show_rate(None, True)
    return field


def _acceleration():
    field = AccelerationField("axis_acceleration", "")
    field.show_acceleration(100.0, False)
    return field


@pytest.mark.parametrize(
    ("kind", "text", "value", "label"),
    [
        ("angle", "45 deg 30'", 45.5, "45.5°"),
        ("angle", "45° 30' 36\"", 45.51, "45.51°"),
        ("length", "0,5", 0.5, "0.5 mm"),
        ("length", "1 1/4 in", 31.75, "31.75 mm"),
        ("feed", "0,5", 0.5, "0.50 mm/min"),
        ("feed", "1/2", 0.5, "0.50 mm/min"),
        ("feed", "100 in/min", 2540.0, "2540.00 mm/min"),
        ("rate", "1/2", 0.5, "0.50 °/min"),
        ("rate", "6 °/s", 360.0, "360.00 °/min"),
        ("acceleration", "2 m/s²", 2000.0, "2000.00 mm/s²"),
        ("number", "0,005", 0.005, "0.005"),
        ("number", "1/2", 0.5, "0.50"),
        ("ratio", "-1/2", -0.5, "-0.500000"),
        ("count", "4/2", 2, "2"),
        ("count", "0", None, "not given"),
        ("speed", "8000 1/min", 8000.0, "8000 1/min"),
    ],
)
def test_what_is_typed_is_read_as_it_was_meant(show, type_into, pump, kind, text, value, label):
    field = show(FIELDS[kind]())
    type_into(field.editor, text)
    pump(50)
    got = field.value()
    assert (got is None and value is None) or got == pytest.approx(value)
    assert field.editor.text() == label and not field.says("error")
    field.check()


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        ("angle", "30 mm"),
        ("angle", "45 deg 30' rubbish"),
        ("length", "30 deg"),
        ("length", "45 deg 30'"),
        ("length", "5 mm^200"),
        ("length", "1e99"),
        ("length", "nan"),
        ("feed", "1e99"),
        ("feed", "-100"),
        ("feed", "12a"),
        ("rate", "30 mm"),
        ("number", "1e99"),
        ("number", "1,2,3"),
        ("ratio", "0.5.5"),
        ("count", "1.5"),
        ("count", "-5"),
        ("count", "1e99"),
        ("speed", "8000.5"),
        ("speed", "1,000"),
    ],
)
def test_what_cannot_be_read_stays_as_typed_and_the_field_keeps_its_value(show, type_into, pump, kind, text):
    field = show(FIELDS[kind]())
    field.show_value(7.0)
    before, heard = field.value(), []
    field.edited.connect(lambda: heard.append(field.value()))
    type_into(field.editor, text)
    pump(50)
    assert field.editor.text() == text and field.value() == before and heard[-1] == before
    assert field.says("error").startswith(text) and field.error.isVisible()
    with pytest.raises(SettingsError, match="type "):
        field.check()
    type_into(field.editor, "3")
    pump(50)
    assert field.value() == 3.0 and not field.says("error") and not field.error.isVisible()
    field.check()


def test_a_value_that_is_shown_or_stepped_to_takes_the_refused_text_away(show, type_into, key, pump):
    field = show(QuantityField("lead", "angle"))
    type_into(field.editor, "rubbish")
    field.show_value(5.0)
    assert field.editor.text() == "5°" and not field.says("error")
    type_into(field.editor, "rubbish")
    assert field.editor.text() == "rubbish"
    key(field.editor, QtCore.Qt.Key_Up)
    pump(50)
    assert field.editor.text() == "6°" and field.value() == 6.0 and not field.says("error")


def test_a_box_that_is_emptied_means_none_where_there_may_be_none(show, key, until):
    for field, value, text in (
        (NumberField("tool", whole=True, optional=True), None, "not given"),
        (OpenField("axis_low", "none", -float("inf"), ""), -float("inf"), "none"),
        (QuantityField("lead", "angle"), 7.0, ""),
    ):
        show(field).show_value(7.0)
        line = field.editor.findChild(QtWidgets.QLineEdit)
        line.setFocus()
        until(line.hasFocus, 5000, "the keys")
        line.selectAll()
        key(line, QtCore.Qt.Key_Delete)
        key(line, QtCore.Qt.Key_Tab)
        until(lambda line=line: not line.hasFocus(), 5000, "another box")
        assert (field.value(), field.editor.text()) == (value, text)
        assert bool(field.says("error")) == (not text)


def test_enter_keeps_the_digits_that_a_box_does_not_show(show, type_into, key):
    for field, value in (
        (QuantityField("tolerance", "length"), 0.0123456),
        (FeedField("feed"), 1000.12345),
    ):
        show(field)
        field.show_value(value)
        key(field.editor.findChild(QtWidgets.QLineEdit), QtCore.Qt.Key_Return)
        assert field.value() == value


def test_a_point_says_which_of_its_numbers_cannot_be_read(show, type_into, pump):
    field = show(TripleField("mark", "point"))
    type_into(field.parts[1].editor, "2 deg")
    pump(50)
    assert field.says("error").startswith("2 deg is no length") and field.value() == [0.0, 0.0, 0.0]
    assert not [one for one in QtWidgets.QApplication.topLevelWidgets() if one.objectName() == "mark_y_error"]
    type_into(field.parts[1].editor, "2")
    pump(50)
    assert not field.says("error") and field.value() == [0.0, 2.0, 0.0]


@pytest.mark.parametrize("text", ["∞", "inf", "none"])
def test_a_limit_that_there_is_not_is_typed_as_an_infinity(show, type_into, pump, text):
    for opened, sign in ((-float("inf"), "-"), (float("inf"), "+")):
        field = show(OpenField("axis_low", "none", opened, ""))
        field.show_measure(30.0, "angle")
        type_into(field.editor, text)
        pump(50)
        assert (field.value(), field.editor.text()) == (opened, "none")
        field.show_measure(30.0, "angle")
        type_into(field.editor, f"{sign}∞")
        pump(50)
        assert (field.value(), field.editor.text()) == (opened, "none")
        field.show_measure(30.0, "angle")
        type_into(field.editor, f"{'+' if sign == '-' else '-'}inf")
        pump(50)
        assert field.value() == 30.0 and "is no angle" in field.says("error")


def test_a_height_that_is_not_known_is_no_infinity(show, type_into, pump):
    field = show(OpenField("table_height", "not known", None, ""))
    field.show_value(100.0)
    type_into(field.editor, "inf")
    pump(50)
    assert field.value() == 100.0 and field.says("error").startswith("inf is no length")
