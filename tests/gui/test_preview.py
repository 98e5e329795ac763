# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes drawn before they are computed: the button, the lines in the view, the line of words, and when both
go away again."""

import time

import FreeCADGui
import Part
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.core.pipeline import preview
from freecad_fiveaxis.gui import preview_picture
from freecad_fiveaxis.gui.panels import toolpath
from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets

COARSE = {
    "passes": "planes", "cutter": "ball:6", "stepover": 2.0, "direction": 0.0, "max_axis_angle": 50.0, "feed": 600.0,
    "tool_axis": "facet_mean", "tool_length": 120.0, "spindle": 8000,
}  # fmt: skip
PINK = tuple(round(255 * part) for part in preview_picture.COLOUR)


@pytest.fixture
def block(doc):
    """40 x 30 x 10 mm, from above in the view."""
    result = doc.addObject("Part::Feature", "Block")
    result.Shape = Part.makeBox(40, 30, 10)
    doc.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    doc.clearUndos()
    return result


@pytest.fixture
def panel(block, pump):
    opened = toolpath.create(block)
    opened.options.show_options(COARSE)
    pump(300)
    return opened


def drawn(panel):
    """How many of our groups of lines stand in the view's scene."""
    scene = FreeCADGui.ActiveDocument.ActiveView.getSceneGraph()
    root = panel.preview.picture.root if panel.preview.picture is not None else None
    return 0 if root is None else int(scene.findChild(root) >= 0)


def test_passes_are_drawn_and_reported_and_the_document_stays(
    doc, panel, field, click, until, pump, screenshot, pixels
):
    before = len(doc.Objects), doc.UndoCount
    bare = pixels(screenshot("preview_before"), PINK, 40)
    click(field("preview_passes"))
    until(lambda: panel.preview.line.isVisible(), 20000, "the line")
    found = app.preview_passes((panel.base, panel.faces), **panel.options.read_values())
    message = panel.preview.line.text()
    assert (
        message.startswith(f"{found.passes} passes, ")
        and f"{found.length:.0f} mm" in message
        and "links not counted" in message
    )
    assert f"{int(found.length / 10) // 60}:" in message, message
    assert (
        drawn(panel) == 1
        and (len(doc.Objects), doc.UndoCount) == before
        and panel.obj is None
        and panel.stale
    )
    pump(300)
    assert pixels(screenshot("preview_passes"), PINK, 40) > bare + 300, "they are seen"
    panel.reject()
    assert drawn(panel) == 0


def test_they_are_seen_too_where_the_part_is_hidden(block, panel, pump, screenshot, pixels):
    """Nothing else is drawn then that says how deep the view is."""
    block.ViewObject.Visibility = False
    pump(200)
    bare = pixels(screenshot("preview_hidden_before"), PINK, 40)
    assert panel.preview_passes()
    pump(300)
    assert pixels(screenshot("preview_hidden"), PINK, 40) > bare + 300
    panel.reject()


def test_they_go_when_a_field_is_changed_a_path_computed_the_part_changed_or_the_panel_closed(
    doc, block, panel, until, pump
):
    def lay():
        assert panel.preview_passes(), panel.options.error.text()
        assert drawn(panel) == 1 and panel.preview.line.isVisible()

    lay()
    panel.options.show_options({"stepover": 3.0})
    pump(100)
    assert drawn(panel) == 0 and not panel.preview.line.text()
    lay()
    assert panel.calculate()
    pump(300)
    assert drawn(panel) == 0 and not panel.preview.line.isVisible() and panel.obj.Passes > 5
    lay()
    assert not panel.stale, "what is computed stays"
    block.Shape = Part.makeBox(40, 30, 12)
    until(lambda: drawn(panel) == 0, 20000, "no line")
    assert not panel.preview.line.text()
    lay()
    assert panel.reject()
    pump(100)
    assert drawn(panel) == 0


def test_what_cannot_be_planned_is_reported_in_the_panel(panel, pump):
    panel.options.show_options({"avoid": [f"Face{at}" for at in range(1, 7)]})
    pump(100)
    assert not panel.preview_passes()
    assert "out of Faces to leave alone" in panel.options.error.text() and drawn(panel) == 0
    panel.options.show_options({"avoid": ()})
    assert panel.preview_passes() and drawn(panel) == 1
    panel.reject()


def test_esc_stops_it_and_the_panel_stays(panel, monkeypatch, pump):
    def endless(settings, progress, *_):
        for _ in range(1000):
            progress("placing passes", 0.0)
            time.sleep(0.05)
        raise AssertionError("nobody stopped it")

    def escape():
        for box in QtWidgets.QApplication.topLevelWidgets():
            if box.objectName() == "FiveAxisWaiting" and box.isVisible():
                QtWidgets.QApplication.postEvent(
                    box, QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier)
                )

    timer = QtCore.QTimer()
    timer.timeout.connect(escape)
    monkeypatch.setattr(preview, "preview_passes", endless)
    timer.start(300)
    try:
        assert not panel.preview_passes() and drawn(panel) == 0
    finally:
        timer.stop()
    monkeypatch.undo()
    assert panel.preview_passes() and FreeCADGui.Control.activeDialog()
    panel.reject()


def test_a_path_that_is_there_is_previewed_with_the_fields_of_its_panel(doc, block, pump):
    path = app.create_toolpath(doc, block, **COARSE)
    blocks = path.Blocks
    panel = toolpath.edit(path)
    pump(200)
    panel.options.show_options({"stepover": 1.0})
    assert panel.preview_passes()
    fine = int(panel.preview.line.text().split()[0])
    assert fine > path.Passes * 1.8 and path.Blocks == blocks and path.Stepover.Value == 2
    panel.reject()
