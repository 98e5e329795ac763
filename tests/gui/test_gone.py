# SPDX-License-Identifier: LGPL-2.1-or-later
"""Undo is pressed, or something deleted, while a panel is open that has computed it: the panel shows nothing
that is not in the document, works on, and Cancel still takes all of it back."""

import FreeCADGui
import pytest
from conftest import QtWidgets, close_all

from freecad_fiveaxis import app
from freecad_fiveaxis.gui.panels import post, reach, toolpath
from freecad_fiveaxis.gui.panels.path_panel import DRAWN

pytestmark = pytest.mark.usefixtures("kept")
OPTIONS = {"machine": "trunnion_ac", "cutter": "ball:6:30", "stepover": 8.0, "linear_deflection": 0.3,
           "angular_deflection": 30.0, "gouge": "off", "linearize": "off"}  # fmt: skip
GONE = "What this panel changes was deleted or undone meanwhile: press Cancel."


@pytest.fixture
def panel(dome, pump):
    """The panel of a new path that was just calculated."""
    dome.Document.clearUndos()
    opened = toolpath.create(dome)
    opened.options.show_options(OPTIONS)
    assert opened.calculate()
    pump(100)
    return opened


def labels(doc):
    return [one.Label for one in doc.Objects]


WHOLE = ["Dome", "Tessellation", "Toolpath"]


def test_after_undo_ok_calculates_anew_and_cancel_takes_it_back(
    panel, doc, until, press, modal, panel_button, panel_closed
):
    press("Std_Undo")
    until(lambda: labels(doc) == ["Dome"] and panel.stale and panel.obj is None, 10000, "forgotten")
    panel.options.show_options({"stepover": 9.0})
    assert panel.calculate() and labels(doc) == WHOLE
    panel.reject()
    assert labels(doc) == ["Dome"]
    opened = toolpath.create(doc.Dome)
    opened.options.show_options(OPTIONS)
    assert opened.calculate()
    press("Std_Undo")
    until(lambda: labels(doc) == ["Dome"], 10000, "undone")
    modal("Keep anyway")
    panel_button("OK")
    panel_closed()
    assert labels(doc) == WHOLE and doc.UndoNames == ["Tool path"]


def test_a_path_that_is_deleted_under_its_panel_is_computed_again(panel, doc, until):
    doc.removeObject("Toolpath")
    until(lambda: panel.stale and panel.obj is None, 10000, "forgotten")
    panel.options.show_options({"stepover": 9.0})
    assert panel.calculate() and panel.options.error.text() == ""


def test_a_changed_path_is_taken_back_by_cancel_after_an_undo(doc, dome, press, until):
    path = app.create_toolpath(doc, dome, **OPTIONS)
    opened = toolpath.edit(path)
    for stepover in (9.0, 10.0):
        opened.options.show_options({"stepover": stepover})
        assert opened.calculate()
        if stepover == 9.0:
            press("Std_Undo")
            until(lambda: path.Stepover.Value == 8.0 and opened.stale, 10000, "undone")
    opened.reject()
    assert path.Stepover.Value == 8.0


def test_what_was_there_before_and_goes_is_named(doc, dome, until):
    found = app.create_toolpath(doc, dome, **OPTIONS)
    opened = toolpath.edit(found)
    doc.removeObject(found.Name)
    until(lambda: opened.gone, 10000, "gone")
    assert not opened.calculate() and opened.options.error.text() == GONE
    assert not opened.accept() and opened.reject()
    doc.removeObject("Tessellation")
    opened = reach.create(dome)
    assert opened.calculate()
    doc.removeObject(opened.obj.Name)
    until(lambda: opened.obj is None and not opened.axes_box.isEnabled(), 10000, "the map gone")
    opened.reject()


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("", "is a folder; name a file"),
        ("a.html", "a.html is the name of the report too: name the NC file otherwise."),
        ("doc.FCStd", "doc.FCStd is this document: name another file."),
    ],
)
def test_a_name_that_is_no_name_for_a_program_is_refused_unasked(name, text, doc, dome, tmp_path):
    path = app.create_toolpath(doc, dome, **OPTIONS)
    doc.saveAs(str(tmp_path / "doc.FCStd"))
    before = sorted(one.name for one in tmp_path.iterdir())
    opened = post.write(path)
    opened.reports["html"].setChecked(True)
    opened.file.show_value(str(tmp_path / name))
    assert not opened.accept() and text in opened.error.text()
    assert sorted(one.name for one in tmp_path.iterdir()) == before
    FreeCADGui.Control.closeDialog()


def test_a_document_that_is_closed_right_after_calculate_does_no_harm(doc, dome, pump):
    opened = reach.create(dome)
    assert opened.calculate()
    opened.reject()
    close_all(doc.Name)
    pump(2 * DRAWN)  # a message box of an error that nobody foresaw would fail the test
    assert FreeCADGui.getMainWindow() and QtWidgets.QApplication.activeModalWidget() is None
