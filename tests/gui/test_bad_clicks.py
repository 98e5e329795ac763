# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user does wrong, by clicks: each time a sentence says what to do, and the document stays as it
was."""

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
    result = doc.addObject("Part::Box", "Box")
    result.Length = result.Width = 20
    doc.recompute()
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    view.viewIsometric()
    view.fitAll()
    return result


@pytest.fixture
def planned(box, doc):
    """A tool path over the box."""
    from freecad_fiveaxis import app

    return app.create_toolpath(doc, box, passes="planes", machine="trunnion_ac", stepover=4)


def state(doc):
    """What saving would keep of each object: name, label, links and values (a shape by what it measures),
    sorted lines."""

    def text(value):
        return str((value.Volume, value.Area) if hasattr(value, "Volume") else value).split(" at 0x")[0]

    return sorted(
        f"{obj.Name}.{name} = {text(getattr(obj, name))}"
        for obj in doc.Objects
        for name in obj.PropertiesList
    )


def test_without_a_part_the_buttons_cannot_be_pressed(doc, tool_button, until):
    for command in ("Tessellate", "Toolpath", "PostProcess", "Annotate", "Play"):
        until(lambda: not tool_button("FiveAxis_" + command).isEnabled(), 20000, f"{command} disabled")  # noqa: B023
    until(lambda: tool_button("FiveAxis_Audit").isEnabled(), 20000, "Audit enabled")


@pytest.mark.parametrize("command", ["FiveAxis_Tessellate", "FiveAxis_Toolpath"])
def test_nothing_selected_says_what_to_select(command, box, doc, press, modal, until):
    FreeCADGui.Selection.clearSelection()
    answer = modal("OK")
    press(command)
    until(lambda: answer.texts, 20000, "what to select")
    assert answer.texts == [
        "Nothing is selected: select a solid, faces of a solid, a body, a compound of solids, or a mesh."
    ]
    assert [obj.Name for obj in doc.Objects] == ["Box"]
    assert not FreeCADGui.Control.activeDialog()


def test_a_sketch_says_what_to_select(doc, select, press, modal, screenshot, until):
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
    until(lambda: answer.texts, 20000, "what to select")
    assert len(answer.texts) == 1
    assert "a sketch" in answer.texts[0]
    assert "select a solid" in answer.texts[0]
    assert [obj.Name for obj in doc.Objects] == ["Sketch"]


def test_an_invalid_value_says_why_in_place_and_ok_keeps_the_panel(
    box, doc, select, press, field, type_into, panel_button, screenshot, until, panel_closed
):
    select(box)
    press("FiveAxis_Toolpath")
    before = state(doc)
    type_into(field("tolerance"), "-1 mm")
    until(lambda: field("tolerance_error").text(), 20000, "what is wrong")
    screenshot("invalid-value")
    panel_button("OK")
    assert FreeCADGui.Control.activeDialog()
    assert state(doc) == before
    panel_button("Cancel")
    panel_closed()


def test_escape_closes_the_panel_and_takes_a_calculation_back(
    box, doc, select, press, field, click, real_key, until, panel_closed, window
):
    before, steps = state(doc), doc.UndoCount
    select(box)
    press("FiveAxis_Toolpath")
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
    assert len(doc.Objects) == 3
    real_key(window, "Escape")
    panel_closed()
    until(lambda: state(doc) == before, 20000, "the document as it was")
    assert doc.UndoCount == steps


def test_escape_halfway_through_the_work_leaves_the_document_as_it_was(doc, select, press, field, choose, type_into, click,
                                                                      real_key, pump, panel_button, screenshot,
                                                                       until, panel_closed):  # fmt: skip
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
    until(lambda: seen, 60000, "progress shown")
    pump(1000)
    timer.stop()
    screenshot("escaped")
    assert "<table>" not in field("summary").text(), "the work was not stopped"
    assert state(doc) == before
    panel_button("Cancel")
    panel_closed()
    assert state(doc) == before


def test_a_deleted_base_is_stated_and_breaks_nothing(
    planned, box, doc, press, select, screenshot, pump, tree_row, until
):
    doc.removeObject(box.Name)
    doc.recompute()
    until(lambda: "Invalid" in planned.Mesh.State, 20000, "an invalid mesh")
    pump(500)
    tree_row(planned.Label)
    screenshot("deleted-base")
    planned.Stepover = 3
    doc.recompute()
    assert planned.Mesh.getStatusString() not in ("Valid", "")


def test_a_file_that_is_there_is_replaced_only_when_confirmed(
    planned, doc, press, field, type_into, panel_button, modal, tmp_path, until
):
    there = tmp_path / "precious.ngc"
    there.write_text("(mine)\n")
    FreeCADGui.Selection.clearSelection()
    press("FiveAxis_PostProcess")
    type_into(field("nc_path"), str(there))
    type_into(field("spindle"), "9000")
    no = modal("Cancel")
    panel_button("OK", 500)
    until(lambda: no.texts, 20000, "a question")
    assert len(no.texts) == 1
    assert there.read_text() == "(mine)\n"
    yes = modal("Replace")
    panel_button("OK", 500)
    until(lambda: yes.texts, 20000, "a question")
    assert len(yes.texts) == 1
    until(lambda: there.read_text() != "(mine)\n", 20000, "the file replaced")


def test_a_folder_that_cannot_be_written_is_stated_in_the_panel(
    planned, doc, press, field, type_into, panel_button, tmp_path, until
):
    (tmp_path / "file").write_text("no folder")
    objects = len(doc.Objects)
    press("FiveAxis_PostProcess")
    type_into(field("nc_path"), str(tmp_path / "file" / "part.ngc"))
    type_into(field("spindle"), "9000")
    panel_button("OK", 500)
    until(lambda: field("post_error").text(), 20000, "what is wrong")
    assert len(doc.Objects) == objects
    panel_button("Cancel")


def test_a_machine_file_that_vanished_marks_the_path(
    planned, doc, tmp_path, pump, tree_row, screenshot, until
):
    import shutil

    from freecad_fiveaxis.gui.qt import resource

    machine = tmp_path / "mine.fcm"
    shutil.copy(resource("machines", "trunnion_ac.fcm"), machine)
    planned.Machine = str(machine)
    doc.recompute()
    until(lambda: "Up-to-date" in planned.State, 20000, "a path that is up to date")
    machine.unlink()
    planned.touch()
    doc.recompute()
    until(lambda: "Invalid" in planned.State, 20000, "an invalid path")
    pump(500)
    tree_row(planned.Label)
    screenshot("machine-vanished")
    assert "mine.fcm" in planned.getStatusString()


def test_an_nc_file_that_is_none_is_stated_in_the_panel(
    doc, press, field, type_into, panel_button, tmp_path, screenshot, until
):
    poem = tmp_path / "poem.ngc"
    poem.write_text("roses are red\n")
    press("FiveAxis_Audit")
    type_into(field("nc_file"), str(poem))
    panel_button("OK", 500)
    until(lambda: field("form_error").text(), 20000, "what is wrong")
    screenshot("audit-refused")
    assert FreeCADGui.Control.activeDialog()
    assert not doc.Objects
    panel_button("Cancel")
