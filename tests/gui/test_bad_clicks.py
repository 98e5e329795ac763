# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user does wrong, by clicks: each time a sentence says what to do, and the document stays as it was."""

import FreeCAD
import FreeCADGui
import pytest
from conftest import QtCore, QtWidgets


@pytest.fixture(autouse=True)
def _preferences(parameters, tmp_path):
    """The defaults, and the test's own folder for NC files."""
    group = parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis")
    group.Clear()
    group.SetString("OutputFolder", str(tmp_path))


@pytest.fixture
def box(doc):
    made = doc.addObject("Part::Box", "Box")
    made.Length = made.Width = 20
    doc.recompute()
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    view.viewIsometric()
    view.fitAll()
    return made


@pytest.fixture
def planned(box, doc):
    """A tool path over the box."""
    from freecad_fiveaxis import app

    return app.create_toolpath(doc, box, machine="trunnion_ac", stepover=4)


def state(doc):
    """What saving would keep of each object: name, label, links and values (a shape by what it measures), sorted lines."""

    def text(value):
        return str((value.Volume, value.Area) if hasattr(value, "Volume") else value).split(" at 0x")[0]

    return sorted(f"{obj.Name}.{name} = {text(getattr(obj, name))}" for obj in doc.Objects for name in obj.PropertiesList)


def test_without_a_part_the_buttons_cannot_be_pressed(doc, tool_button):
    for command in ("Tessellate", "Toolpath", "PostProcess", "Annotate", "Play"):
        assert not tool_button("FiveAxis_" + command).isEnabled(), command
    assert tool_button("FiveAxis_Audit").isEnabled()


@pytest.mark.parametrize("command", ["FiveAxis_Tessellate", "FiveAxis_Toolpath"])
def test_nothing_selected_says_what_to_select(command, box, doc, press, modal):
    FreeCADGui.Selection.clearSelection()
    answer = modal("OK")
    press(command)
    assert answer.said == ["Nothing is selected: select a solid, faces of a solid, a body, a compound of solids, or a mesh."]
    assert [obj.Name for obj in doc.Objects] == ["Box"]
    assert not FreeCADGui.Control.activeDialog()


def test_a_sketch_says_what_to_select(doc, select, press, modal, screenshot):
    import Part

    sketch = doc.addObject("Sketcher::SketchObject", "Sketch")
    sketch.addGeometry(Part.LineSegment(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(10, 0, 0)))
    doc.recompute()
    select(sketch)

    def look(dialog):
        screenshot("message-sketch")
        dialog.buttons()[0].click()

    answer = modal(look)
    press("FiveAxis_Toolpath")
    assert len(answer.said) == 1
    assert "a sketch" in answer.said[0]
    assert "select a solid" in answer.said[0]
    assert [obj.Name for obj in doc.Objects] == ["Sketch"]


def test_an_invalid_value_says_why_in_place_and_ok_keeps_the_panel(
    box, doc, select, press, field, type_into, panel_button, screenshot
):
    select(box)
    press("FiveAxis_Toolpath")
    before = state(doc)
    type_into(field("tolerance"), "-1 mm")
    screenshot("invalid-value")
    assert field("tolerance_error").text()
    panel_button("OK")
    assert FreeCADGui.Control.activeDialog()
    assert state(doc) == before
    panel_button("Cancel")
    assert not FreeCADGui.Control.activeDialog()


def test_escape_closes_the_panel_and_takes_a_calculation_back(
    box, doc, select, press, field, click, real_key, until, pump, window
):
    before, steps = state(doc), doc.UndoCount
    select(box)
    press("FiveAxis_Toolpath")
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
    assert len(doc.Objects) == 3
    real_key(window, "Escape")
    pump(500)
    assert not FreeCADGui.Control.activeDialog()
    assert state(doc) == before
    assert doc.UndoCount == steps


def test_escape_halfway_through_the_work_leaves_the_document_as_it_was(doc, select, press, field, choose, type_into, click,
                                                                      real_key, pump, panel_button, screenshot):  # fmt: skip
    ball = doc.addObject("Part::Sphere", "Ball")
    ball.Radius, ball.Angle1 = 60, 0
    doc.recompute()
    before = state(doc)
    select(ball)
    press("FiveAxis_Toolpath")
    choose(field("spacing_kind"), "Stepover")
    type_into(field("stepover"), "0.01 mm")
    seen = []

    def escape():
        dialog = QtWidgets.QApplication.activeModalWidget()
        if isinstance(dialog, QtWidgets.QProgressDialog):
            seen.append(dialog.labelText())
            real_key(dialog, "Escape")

    timer = QtCore.QTimer()
    timer.timeout.connect(escape)
    timer.start(50)
    click(field("calculate"))
    pump(1000)
    timer.stop()
    screenshot("escaped")
    assert seen, "no progress was shown"
    assert "<table>" not in field("summary").text(), "the work was not stopped"
    assert state(doc) == before
    panel_button("Cancel")
    assert state(doc) == before


def test_a_deleted_base_is_said_and_breaks_nothing(planned, box, doc, press, select, screenshot, pump, tree_row):
    doc.removeObject(box.Name)
    doc.recompute()
    pump(500)
    tree_row(planned.Label)
    screenshot("deleted-base")
    assert "Invalid" in planned.Mesh.State
    planned.Stepover = 3
    doc.recompute()
    assert planned.Mesh.getStatusString() not in ("Valid", "")


def test_a_file_that_is_there_is_replaced_only_when_asked(planned, doc, press, field, type_into, panel_button, modal, tmp_path):
    there = tmp_path / "precious.ngc"
    there.write_text("(mine)\n")
    FreeCADGui.Selection.clearSelection()
    press("FiveAxis_PostProcess")
    type_into(field("nc_path"), str(there))
    no = modal("Cancel")
    panel_button("OK", 500)
    assert len(no.said) == 1
    assert there.read_text() == "(mine)\n"
    yes = modal("Replace")
    panel_button("OK", 500)
    assert len(yes.said) == 1
    assert there.read_text() != "(mine)\n"


def test_a_folder_that_cannot_be_written_is_said_in_the_panel(planned, doc, press, field, type_into, panel_button, tmp_path):
    (tmp_path / "file").write_text("no folder")
    objects = len(doc.Objects)
    press("FiveAxis_PostProcess")
    type_into(field("nc_path"), str(tmp_path / "file" / "part.ngc"))
    panel_button("OK", 500)
    assert field("post_error").text()
    assert len(doc.Objects) == objects
    panel_button("Cancel")


def test_a_machine_file_that_vanished_marks_the_path(planned, doc, tmp_path, pump, tree_row, screenshot):
    import shutil

    from freecad_fiveaxis.gui.qt import resource

    machine = tmp_path / "mine.fcm"
    shutil.copy(resource("machines", "trunnion_ac.fcm"), machine)
    planned.Machine = str(machine)
    doc.recompute()
    assert "Up-to-date" in planned.State
    machine.unlink()
    planned.touch()
    doc.recompute()
    pump(500)
    tree_row(planned.Label)
    screenshot("machine-vanished")
    assert "Invalid" in planned.State
    assert "mine.fcm" in planned.getStatusString()


def test_an_nc_file_that_is_none_is_said_in_the_panel(doc, press, field, type_into, panel_button, tmp_path, screenshot):
    poem = tmp_path / "poem.ngc"
    poem.write_text("roses are red\n")
    press("FiveAxis_Audit")
    type_into(field("nc_file"), str(poem))
    panel_button("OK", 500)
    screenshot("audit-refused")
    assert FreeCADGui.Control.activeDialog()
    assert field("form_error").text()
    assert not doc.Objects
    panel_button("Cancel")
