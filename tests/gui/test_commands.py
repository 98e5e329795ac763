# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands: on the tool bar, with icon and tool tip, enabled when they can apply, and saying what to
select when not."""

import subprocess
import sys
from pathlib import Path

import FreeCAD
import FreeCADGui
import Mesh
import Part
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.gui import commands, selected
from freecad_fiveaxis.gui.qt import QtCore, QtWidgets

ROOT = Path(__file__).parents[2]
COARSE = {
    "passes": "planes",
    "cutter": "ball:6",
    "stepover": 6.0,
    "linear_deflection": 0.5,
    "angular_deflection": 45.0,
}

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def box(doc):
    """A block of 20 x 20 x 10 mm."""
    part = doc.addObject("Part::Box", "Box")
    part.Length = part.Width = 20
    doc.recompute()
    doc.clearUndos()
    return part


@pytest.fixture
def path(box):
    """A coarse path over the block."""
    result = app.create_toolpath(box.Document, box, **COARSE)
    box.Document.clearUndos()
    return result


def names(doc):
    return sorted(obj.Name for obj in doc.Objects)


def enabled(tool_button):
    tool_button(commands.NAMES[0])  # waits until all their states are renewed
    return {name.removeprefix("FiveAxis_") for name in commands.NAMES if tool_button(name, 0).isEnabled()}


@pytest.mark.parametrize("name", commands.NAMES)
def test_each_command_has_a_button_with_icon_and_tool_tip(window, tool_button, name):
    action = tool_button(name, 0).defaultAction()
    assert not action.icon().isNull() and action.text() and len(action.toolTip()) > 20
    assert (ROOT / "resources" / "icons" / f"{name}.svg").is_file()


def test_the_menu_lists_all_commands(window):
    menu = window.findChild(QtWidgets.QMenu, "Five-axis") or next(
        menu for menu in window.findChildren(QtWidgets.QMenu) if menu.title().replace("&", "") == "Five-axis"
    )
    assert [action.objectName() for action in menu.actions() if not action.isSeparator()] == commands.NAMES


ORDER = [
    ["JobSetup", "Tessellate", "Reach", "Toolpath", "Setup", "Compare"], ["Play", "Left", "Annotate"], ["PostProcess", "Audit"],
    ["ProveSigns", "Recover", "ImportMachine", "EditMachine"],
]  # fmt: skip
"""Of the work: plan, look, write and judge; then what is about machines."""


def groups_of(actions):
    """The names of our commands, divided where a line stands between them."""
    result = [[]]
    for action in actions:
        if action.isSeparator():
            result.append([])
        else:
            result[-1].append(action.objectName().removeprefix("FiveAxis_"))
    return [group for group in result if group]


def test_tool_bars_and_menu_follow_the_order_of_the_work(window):
    bars = {bar.objectName(): groups_of(bar.actions()) for bar in window.findChildren(QtWidgets.QToolBar)}
    assert bars["Five-axis"] == ORDER[:-1] and bars["Five-axis machines"] == ORDER[-1:]
    menu = next(
        menu for menu in window.findChildren(QtWidgets.QMenu) if menu.title().replace("&", "") == "Five-axis"
    )
    assert groups_of(menu.actions()) == ORDER


FILES_ONLY = {"Audit", "Recover", "ProveSigns", "ImportMachine", "EditMachine"}


def test_commands_are_enabled_when_they_can_apply(doc, tool_button, until):
    until(lambda: enabled(tool_button) == FILES_ONLY, 20000, "those for files alone")
    part = doc.addObject("Part::Box", "Box")
    doc.recompute()
    of_a_part = FILES_ONLY | {"JobSetup", "Tessellate", "Reach", "Toolpath", "Setup"}
    until(lambda: enabled(tool_button) == of_a_part, 20000, "those for a part")
    app.create_toolpath(doc, part, **COARSE)
    of_a_path = {command.removeprefix("FiveAxis_") for command in commands.NAMES}
    until(lambda: enabled(tool_button) == of_a_path, 20000, "all of them")


def test_no_command_is_enabled_while_a_panel_is_open(path, select, press, tool_button, until):
    select(path.Document.Box)
    press("FiveAxis_Toolpath")
    until(FreeCADGui.Control.activeDialog, 20000, "a task panel")
    until(lambda: enabled(tool_button) == set(), 20000, "all commands disabled")


def test_tessellate_makes_a_mesh_in_one_step(box, select, press, until):
    select(box, "Face6")
    press("FiveAxis_Tessellate")
    doc = box.Document
    result = until(lambda: doc.getObject("Tessellation"), 20000, "a mesh")
    assert result.Mesh.CountFacets == 12 and result.Base == (box, ["Face6"]) and doc.UndoCount == 1
    doc.undo()
    assert names(doc) == ["Box"]


def nothing(doc):
    return None


def sketch(doc):
    return doc.addObject("Sketcher::SketchObject", "Sketch")


def shell(doc):
    result = doc.addObject("Part::Feature", "Shell")
    result.Shape = Part.makePlane(10, 10)
    return result


def empty_mesh(doc):
    result = doc.addObject("Mesh::Feature", "Mesh")
    result.Mesh = Mesh.Mesh()
    return result


@pytest.mark.parametrize("command", ["FiveAxis_Tessellate", "FiveAxis_Toolpath"])
@pytest.mark.parametrize("make", [nothing, sketch, shell, empty_mesh])
def test_what_cannot_be_milled_says_what_to_select(box, make, command, select, press, modal, until):
    doc = box.Document
    wrong = make(doc)
    doc.recompute()
    before = names(doc)
    FreeCADGui.Selection.clearSelection()
    if wrong is not None:
        select(wrong)
    reported = modal("OK")
    press(command, wait=500)
    until(lambda: reported.texts, 20000, "what to select")
    assert "select a" in reported.texts[0].lower()
    assert names(doc) == before and not FreeCADGui.Control.activeDialog() and not doc.HasPendingTransaction


def a_compound(doc, box):
    result = doc.addObject("Part::Compound", "Compound")
    result.Links = [box]
    return result


def a_body(doc, box):
    body = doc.addObject("PartDesign::Body", "Body")
    body.newObject("PartDesign::AdditiveBox", "Block")
    return body


def a_mesh(doc, box):
    result = doc.addObject("Mesh::Feature", "Mesh")
    result.Mesh = Mesh.createBox(20, 20, 10)
    return result


@pytest.mark.parametrize("make", [a_compound, a_body, a_mesh])
def test_compound_body_and_mesh_can_be_milled(box, make, select, press, panel_button, until, panel_closed):
    doc = box.Document
    base = make(doc, box)
    doc.recompute()
    select(base)
    press("FiveAxis_Toolpath")
    form = until(
        lambda: FreeCADGui.getMainWindow().findChild(QtWidgets.QWidget, "FiveAxisPanel"), 20000, "the panel"
    )
    kind = form.findChild(QtWidgets.QComboBox, "spacing_kind")
    kind.setCurrentIndex(kind.findData("stepover"))
    form.findChild(QtWidgets.QWidget, "stepover").show_measured(6.0)
    panel_button("OK", wait=500)
    panel_closed()
    assert doc.Toolpath.Blocks > 0
    assert (doc.Toolpath.Mesh is base) == (make is a_mesh)


def test_annotate_marks_the_only_path_in_one_step(path, press, until):
    doc = path.Document
    FreeCADGui.Selection.clearSelection()
    press("FiveAxis_Annotate")
    until(lambda: doc.getObject("Markers"), 20000, "markers")
    assert doc.Markers.Path is path and doc.UndoCount == 1
    doc.undo()
    assert "Markers" not in names(doc)


def test_several_paths_ask_for_one_and_children_stand_for_theirs(path, press, select, modal, until):
    doc = path.Document
    other = app.create_toolpath(doc, doc.Box, **{**COARSE, "stepover": 5.0})
    FreeCADGui.Selection.clearSelection()
    reported = modal("OK")
    press("FiveAxis_Annotate")
    until(lambda: reported.texts, 20000, "a question")
    assert reported.texts == ["There are several paths: select the one to mark."]
    select(other.Mesh)
    press("FiveAxis_Annotate")
    until(lambda: doc.getObject("Markers"), 20000, "markers")
    assert [obj.Path for obj in doc.Objects if selected.kind_of(obj) == "Markers"] == [other]
    select(doc.Markers)
    assert selected.find_selected_path(selected.TOOLPATH) is other


def test_a_path_that_cannot_be_computed_says_why(path, press, modal, until):
    path.Machine = "no_such_machine"
    reported = modal("OK")
    press("FiveAxis_Annotate", wait=500)
    until(lambda: reported.texts, 20000, "what is wrong")
    assert "no_such_machine" in reported.texts[0] and "Markers" not in names(path.Document)


def test_stopped_work_leaves_the_document_as_it_was(box, select, press, monkeypatch, until):
    from freecad_fiveaxis.gui import waiting

    begin = waiting.Waiting.__call__

    def stopped(self, stage, fraction):
        QtCore.QTimer.singleShot(0, self.dialog.cancel)
        begin(self, stage, fraction)

    monkeypatch.setattr(waiting.Waiting, "__call__", stopped)
    select(box)
    press("FiveAxis_Tessellate")
    until(
        lambda: "Stopped" in FreeCADGui.getMainWindow().statusBar().currentMessage(),
        20000,
        "that it was stopped",
    )
    assert names(box.Document) == ["Box"] and box.Document.UndoCount == 0


def test_two_documents_keep_apart(box, select, press, until):
    other = FreeCAD.newDocument("Other")
    try:
        FreeCAD.setActiveDocument(box.Document.Name)
        select(box)
        press("FiveAxis_Tessellate")
        until(lambda: "Tessellation" in names(box.Document), 20000, "a mesh")
        assert names(other) == []
    finally:
        FreeCAD.closeDocument("Other")


def test_the_workbench_opens_without_numpy_and_scipy():
    """In a process of its own, with stand-ins for FreeCAD: start-up, and what FreeCAD asks of the commands
    meanwhile."""
    code = """
import sys, types
from unittest.mock import MagicMock
for name in ("FreeCAD", "FreeCADGui", "PySide", "PySide.QtCore", "PySide.QtGui", "PySide.QtWidgets", "pivy", "pivy.coin"):
    sys.modules[name] = MagicMock()
class Workbench: appendToolbar = appendMenu = appendContextMenu = lambda self, *a: None
class QObject:
    def __init__(self, *a): pass
sys.modules["FreeCADGui"].Workbench = Workbench
sys.modules["PySide"].QtCore.QObject = QObject
sys.modules["numpy"] = sys.modules["scipy"] = None
from freecad_fiveaxis.gui import workbench, commands
workbench.start()
workbench.FiveAxisWorkbench().Initialize()
sys.modules["FreeCAD"].ActiveDocument.findObjects.return_value = []
for command in commands.COMMANDS:
    command().IsActive()
    command().GetResources()
print("opened")
"""
    done = subprocess.run([sys.executable if "python" in Path(sys.executable).name else "python3", "-c", code],
                          capture_output=True, text=True, cwd=ROOT, timeout=60)  # fmt: skip
    assert done.stdout == "opened\n", done.stderr


@pytest.fixture
def pointers(monkeypatch):
    """The shapes that the pointer has while a panel gets its fields; None: the usual one."""
    from freecad_fiveaxis.gui.panels import form

    seen, make = [], form.Form.__init__

    def watched(self, *values, **named):
        pointer = QtWidgets.QApplication.overrideCursor()
        seen.append(None if pointer is None else pointer.shape())
        make(self, *values, **named)

    monkeypatch.setattr(form.Form, "__init__", watched)
    return seen


@pytest.mark.parametrize("name", ["Toolpath", "Audit", "Setup", "Reach"])
def test_the_pointer_is_busy_while_a_panel_gets_its_fields(
    name, box, select, press, pointers, panel_button, panel_closed
):
    select(box)
    press(f"FiveAxis_{name}")
    assert pointers and set(pointers) == {QtCore.Qt.WaitCursor}
    assert QtWidgets.QApplication.overrideCursor() is None
    panel_button("Cancel")
    panel_closed()


def test_the_pointer_is_busy_while_a_path_is_opened_by_a_double_click(path, pointers):
    assert path.ViewObject.Proxy.doubleClicked(path.ViewObject)
    assert pointers == [QtCore.Qt.WaitCursor] and QtWidgets.QApplication.overrideCursor() is None


def test_the_pointer_is_as_ever_over_the_message_of_what_cannot_be_milled(doc, box, press, modal):
    FreeCADGui.Selection.clearSelection()
    over = []

    def close(dialog):
        over.append(QtWidgets.QApplication.overrideCursor())
        dialog.close()

    reported = modal(close)
    press("FiveAxis_Toolpath")
    assert "Nothing is selected" in reported.texts[0] and over == [None]
