# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nothing fails silently: an error in a slot of ours is seen in the panel that is open, or in a message box.
And nothing of ours dies or changes by itself: fields live on while garbage is collected, and the wheel
scrolls."""

import gc

import FreeCAD
import FreeCADGui
import pytest

from freecad_fiveaxis.gui import commands, comparison_table, failures, findings_panel, qt
from freecad_fiveaxis.gui.panels import toolpath, work_panel
from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets

COARSE = {
    "passes": "planes",
    "cutter": "ball:6:30",
    "stepover": 4.0,
    "linear_deflection": 0.3,
    "angular_deflection": 30.0,
}


@pytest.fixture
def box(doc):
    part = doc.addObject("Part::Box", "Box")
    doc.recompute()
    return part


@pytest.fixture
def panel(box, pump):
    opened = toolpath.create(box)
    opened.options.show_options(COARSE)
    pump(300)
    return opened


def fails(*_):
    raise ZeroDivisionError("one by nought")


def ours(function):
    """The function as if it stood in a file of ours, for that is how the hook knows its own."""
    code = function.__code__.replace(co_filename=failures.OURS + "made_up.py")
    return type(function)(code, function.__globals__)


@pytest.fixture
def printed(monkeypatch):
    """What goes to the report view as an error."""
    message = []
    before = FreeCAD.Console.PrintError
    monkeypatch.setattr(
        failures.FreeCAD.Console, "PrintError", lambda text: (message.append(text), before(text))
    )
    return message


def red(panel):
    line = panel.form.findChild(QtWidgets.QLabel, "failure")
    return line.text() if line.isVisible() else ""


def test_an_error_in_calculate_stands_red_in_the_panel_and_the_document_is_as_before(
    panel, field, click, pump, doc, until
):
    panel.compute = ours(fails)
    click(panel.calculate_button)
    until(lambda: "one by nought" in red(panel), 20000, "the error")
    assert "report view" in red(panel)
    assert [obj.Name for obj in doc.Objects] == ["Box"]


def test_an_error_behind_ok_stands_red_and_the_panel_stays(panel, panel_button, printed, until):
    panel.compute = fails
    panel_button("OK")
    until(lambda: "one by nought" in red(panel), 20000, "the error")
    assert FreeCADGui.Control.activeDialog()
    assert any("Traceback" in text for text in printed)


def test_an_error_of_a_timer_and_of_a_field_stands_red(panel, pump, until):
    QtCore.QTimer.singleShot(0, ours(fails))
    until(lambda: "one by nought" in red(panel), 20000, "the error")
    panel.form.findChild(QtWidgets.QLabel, "failure").hide()
    heard = ours(fails)
    panel.options.fields["feed"].edited.connect(heard)
    panel.options.fields["feed"].editor.setValue(123)
    until(lambda: "one by nought" in red(panel), 20000, "the error")


def test_an_error_of_somebody_else_is_not_ours_to_tell(panel, pump):
    QtCore.QTimer.singleShot(0, fails)
    pump(200)
    assert red(panel) == ""


def shown_boxes():
    """Of the main window's own: PySide2 crashes now and then where all widgets of FreeCAD are asked for."""
    boxes = FreeCADGui.getMainWindow().findChildren(QtWidgets.QMessageBox, "FiveAxisFailure")
    return [one for one in boxes if one.isVisible()]


def closed_box(until, pump):
    """The text of the message box that has come; it is closed."""
    found = until(shown_boxes, 20000, "a message box")[0]
    text = found.text()
    found.close()
    pump(100)
    return text


def test_without_a_panel_a_message_box_says_it_once_however_often_it_fails(doc, until, pump):
    for _ in range(3):
        QtCore.QTimer.singleShot(0, ours(fails))
    until(shown_boxes, 20000, "a message box")
    pump(300)
    assert len(shown_boxes()) == 1
    assert "one by nought" in closed_box(until, pump)


def test_an_error_of_a_command_is_reported(doc, until, pump, printed, monkeypatch):
    monkeypatch.setattr("freecad_fiveaxis.gui.selected.job_or_part", fails)
    doc.addObject("Part::Box", "Box")
    doc.recompute()
    FreeCADGui.runCommand("FiveAxis_Toolpath")
    assert "one by nought" in closed_box(until, pump)
    assert any("Traceback" in text for text in printed)


def test_all_commands_and_observers_are_guarded():
    from freecad_fiveaxis.gui import attach
    from freecad_fiveaxis.gui.panels.picking import Pick
    from freecad_fiveaxis.gui.play.watch import Watch

    for cls in (attach.Observer, findings_panel.Watcher, Pick, Watch):
        slots = [getattr(cls, name) for name in dir(cls) if name.startswith(("slot", "addSelection"))]
        assert slots
        assert all(hasattr(slot, "__wrapped__") for slot in slots)
    assert commands.NAMES


def test_an_error_of_an_observer_is_reported(doc, until, pump, monkeypatch):
    from freecad_fiveaxis.gui import attach

    monkeypatch.setattr(attach, "_look_again", fails)
    doc.addObject("Part::Box", "Box").Label = "other"
    assert "one by nought" in closed_box(until, pump)


def turn(editor, notches, pump):
    """The wheel over an editor, as the server sends it: Qt offers it to the widgets around where the editor
    leaves it."""
    middle = editor.rect().center()
    event = QtGui.QWheelEvent(
        QtCore.QPointF(middle), QtCore.QPointF(editor.mapToGlobal(middle)), QtCore.QPoint(), QtCore.QPoint(0, -120 * notches),
        QtCore.Qt.NoButton, QtCore.Qt.NoModifier, QtCore.Qt.NoScrollPhase, False,
    )  # fmt: skip
    QtWidgets.QApplication.sendEvent(editor, event)
    pump(50)


@pytest.mark.parametrize("name", ["feed", "controller", "cutter_diameter", "tolerance"])
def test_the_wheel_changes_a_field_only_with_the_focus(panel, pump, name, until):
    editor = panel.form.findChild(QtWidgets.QWidget, name)
    read = lambda: editor.currentText() if hasattr(editor, "currentText") else editor.property("text")  # noqa: E731
    before = read()
    panel.form.setFocus()
    turn(editor, 1, pump)
    assert read() == before
    assert not editor.hasFocus()
    editor.setFocus()
    until(editor.hasFocus, 20000, "the focus")
    turn(editor, 1, pump)
    until(lambda: read() != before, 20000, "another value")


def test_fields_live_while_garbage_is_collected_and_windows_of_ours_open(panel, pump):
    for _ in range(3):
        gc.collect()
        pump(200)
        window = qt.main_window()
        assert window is qt.main_window()
        window = None
        gc.collect()
        for name, field in panel.options.fields.items():
            field.value()
            assert field.editor.objectName() == name
    assert panel.calculate()
    gc.collect()
    findings_panel.show(panel.obj)
    gc.collect()
    pump(300)
    assert panel.options.read_values()
    assert panel.accept()


def test_the_table_of_a_comparison_outlives_collected_garbage_and_has_the_whole_width(
    doc, pump, monkeypatch, until
):
    monkeypatch.setattr(comparison_table.Table, "show_rows", lambda *_: None)
    shown = comparison_table.show(None, None)
    for _ in range(3):
        gc.collect()
        pump(100)
    until(shown.dock.isVisible, 20000, "the table")
    until(lambda: shown.dock.width() > 0.8 * qt.main_window().width(), 20000, "the whole width for it")
    assert comparison_table.show(None, None) is shown
    shown.dock.hide()


def test_a_panel_without_a_document_is_given_one_where_the_task_view_may_be_hidden(monkeypatch):
    monkeypatch.setattr(FreeCAD, "Version", lambda: ["0", "20", "2"])
    assert not work_panel.may_lie_over_a_view()
    monkeypatch.setattr(FreeCAD, "Version", lambda: ["1", "1", "3"])
    assert work_panel.may_lie_over_a_view()
    monkeypatch.setattr(FreeCAD, "Version", lambda: ["26", "3", "0"])
    assert work_panel.may_lie_over_a_view()
