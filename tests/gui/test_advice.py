# SPDX-License-Identifier: LGPL-2.1-or-later
"""*What would finish more?* in the panel of a path: offered where something stays, tried, told, taken over,
stopped by Esc."""

import FreeCADGui
import Part
import pytest

from freecad_fiveaxis.app import advising
from freecad_fiveaxis.core.pipeline import advice
from freecad_fiveaxis.gui.panels import toolpath
from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets

COARSE = {
    "passes": "planes", "cutter": "ball:6", "scallop": 0.5, "tool_length": 120.0, "spindle": 8000, "tool_axis": "facet_mean",
    "max_axis_angle": 90.0, "rest": "on",
}  # fmt: skip


@pytest.fixture
def panel(doc, pump, monkeypatch):
    monkeypatch.setattr(advice, "SMALLER", ())
    block = doc.addObject("Part::Feature", "Block")
    block.Shape = Part.makeBox(24, 16, 10)
    doc.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    opened = toolpath.create(block)
    opened.options.show_options(COARSE)
    pump(300)
    return opened


@pytest.mark.usefixtures("whole_screen")
def test_it_is_offered_tried_reported_and_taken_over(doc, panel, field, click, pump, until, screenshot):
    offer = panel.advice_offer
    assert offer.isHidden()
    assert panel.calculate() and not offer.isHidden() and offer.line.isHidden() and offer.use.isHidden()
    objects = len(doc.Objects)
    click(offer.ask)
    until(lambda: offer.line.text(), 60000, "the advice")
    assert (
        "constant scallop" in offer.line.text()
        and "would finish" in offer.line.text()
        and "mm" in offer.line.text()
    )
    assert len(doc.Objects) == objects and not panel.stale
    pump(300)
    screenshot("advice_told")
    click(offer.use)
    pump(100)
    assert panel.options.fields["passes"].value() == "scallop" and panel.stale and offer.isHidden()
    assert panel.calculate() and panel.obj.Passes
    panel.reject()


def test_esc_stops_it_and_the_panel_stays(panel, pump, monkeypatch):
    def endless(result, run):
        for _ in range(1000):
            run(result.draft.settings)
        raise AssertionError("nobody stopped it")

    def escape():
        for box in QtWidgets.QApplication.topLevelWidgets():
            if box.objectName() == "FiveAxisWaiting" and box.isVisible():
                key = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier)
                QtWidgets.QApplication.postEvent(box, key)

    assert panel.calculate()
    timer = QtCore.QTimer()
    timer.timeout.connect(escape)
    monkeypatch.setattr(advising, "try_others", endless)
    timer.start(300)
    try:
        assert not panel.ask_advice()
    finally:
        timer.stop()
    assert panel.advice_offer.line.isHidden() and not panel.advice_offer.isHidden() and not panel.stale
    panel.reject()
