# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces to leave alone in the panel of a tool path: clicked in the 3D view, added and removed, kept by the
path, taken back by undo."""

import FreeCADGui
import Mesh
import numpy as np
import Part
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results, tessellation
from freecad_fiveaxis.gui.panels import toolpath

COARSE = {
    "passes": "planes", "cutter": "ball:4", "stepover": 2.0, "max_axis_angle": 30.0, "tool_length": 120.0, "spindle": 8000,
    "tool_axis": "facet_mean",
}  # fmt: skip


@pytest.fixture
def step(doc):
    """Two floors side by side: z = 10 up to x = 10, z = 5 beyond it; from above in the view."""
    result = doc.addObject("Part::Feature", "Step")
    result.Shape = Part.makeBox(20, 20, 5).fuse(Part.makeBox(10, 20, 10)).removeSplitter().Solids[0]
    doc.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    doc.clearUndos()
    return result


def face_at(obj, **middle):
    rows = [
        all(abs(getattr(one.CenterOfMass, axis) - at) < 1e-6 for axis, at in middle.items())
        for one in obj.Shape.Faces
    ]
    return f"Face{rows.index(True) + 1}"


@pytest.fixture
def panel(step, pump, unfold):
    opened = toolpath.create(step)
    opened.options.show_options(COARSE)
    pump(300)
    unfold()
    pump(200)
    return opened


def pick(field, row, click, pump):
    field.list.scrollToItem(field.list.item(row))
    pump(100)
    click(field.list.viewport(), field.list.visualItemRect(field.list.item(row)).center())


def lit():
    """Objects and sub-elements that are selected in the 3D view."""
    return [(one.Object.Name, one.SubElementNames) for one in FreeCADGui.Selection.getSelectionEx()]


def pick_until_lit(field, row, click, pump, until):
    """Click the row until its face is selected: while other panels are still being laid out, FreeCAD's tree
    takes a selection back."""
    wanted = [(field.base.Name, (field.list.item(row).text(),))]

    def clicked():
        pick(field, row, click, pump)
        return lit() == wanted

    until(clicked, 20000, "the view shows which face the row is")


def low_cuts(path):
    """How many contacts of the path lie on the low floor, work frame and document being one."""
    result = results.result_of(path).draft.path
    return int((result.tip[result.motion == 0][:, 2] < 7.0).sum())


def nearest_low(path):
    """The least X, mm, of contacts on the low floor."""
    result = results.result_of(path).draft.path
    tip = result.tip[result.motion == 0]
    return tip[np.abs(tip[:, 2] - 5.0) < 0.05, 0].min()


def test_a_face_is_clicked_added_and_not_milled(
    doc, step, panel, field, view_click, click, pump, until, screenshot, panel_button, panel_closed
):
    low = face_at(step, z=5, x=15)
    avoid = panel.options.fields["avoid"]
    assert avoid.value() == () and not avoid.remove.isEnabled()
    view_click((15, 10, 5))
    click(field("avoid_add"))
    assert avoid.value() == (low,) and not avoid.error.text() and panel.stale
    assert low in panel.options.groups["part"].state
    pump(200)
    screenshot("avoid_added")
    assert panel.calculate()
    until(lambda: not panel.stale, 60000, "a result")
    pump(600)
    screenshot("avoid_panel")
    panel_button("OK")
    panel_closed()
    path = doc.Toolpath
    assert path.Mesh.Avoid == (step, [low]) and path.Blocks and not low_cuts(path)
    whole = app.create_toolpath(doc, step, **COARSE)
    assert low_cuts(whole) > 10 and results.nc_of(whole) != results.nc_of(path)


def test_the_tool_keeps_off_by_what_its_field_says(
    doc, step, panel, field, type_into, pump, until, screenshot, panel_button, panel_closed
):
    """The wall between the floors: the field is there with the first face to avoid, and the way ends so far
    beside it."""
    panel.options.show_options({"avoid": [face_at(step, x=10, z=7.5)]})
    type_into(field("avoid_allowance"), "1 mm")
    screenshot("avoid_allowance_field")
    assert panel.stale and panel.calculate()
    until(lambda: not panel.stale, 60000, "a result")
    pump(600)
    field("avoid_allowance")
    screenshot("avoid_allowance")
    panel_button("OK")
    panel_closed()
    path = doc.Toolpath
    assert path.AvoidAllowance.Value == 1.0 and path.Mesh.AvoidedRuns
    assert nearest_low(path) >= 10.0 + 2.0 + 1.0 - 0.02, "the ball's radius and 1 mm beside the wall"
    plain = app.create_toolpath(doc, step, avoid=path.Mesh.Avoid[1], **COARSE)
    assert nearest_low(plain) < 10.0 + 2.0 + 1.0 - 0.5, "and nearer without"


def test_without_faces_to_avoid_there_is_no_field_of_their_allowance(step, panel, pump):
    allowance, avoid = (panel.options.fields[name] for name in ("avoid_allowance", "avoid"))
    assert avoid.value() == () and not allowance.editor.isVisible()
    panel.options.show_options({"avoid": ["Face1"]})
    pump(100)
    assert allowance.editor.isVisible()
    panel.reject()


def test_what_is_selected_wrongly_is_reported_and_the_list_stays(
    doc, step, panel, field, select, click, pump
):
    other = doc.addObject("Part::Box", "Other")
    doc.recompute()
    avoid = panel.options.fields["avoid"]
    avoid.show_value(["Face1"])
    for chosen, message in (
        ((step, "Edge1"), "Edge1 is no face: select faces of Step"),
        ((other, "Face1"), "Face1 is a face of Other: select faces of Step"),
        ((step,), "Step is no face"),
    ):
        select(*chosen)
        click(field("avoid_add"))
        pump(50)
        assert (
            message in avoid.error.text()
            and avoid.error.isVisibleTo(avoid.error.parentWidget())
            and avoid.value() == ("Face1",)
        )
    FreeCADGui.Selection.clearSelection()
    click(field("avoid_add"))
    assert "Nothing is selected" in avoid.error.text()
    select(step, "Face2", "Face1", "Face3")
    click(field("avoid_add"))
    assert avoid.value() == ("Face1", "Face2", "Face3") and not avoid.error.text()
    panel.reject()


def test_rows_are_removed_cancel_and_undo_take_back(
    doc, step, field, click, pump, unfold, panel_button, panel_closed, press, until, screenshot
):
    low, high = face_at(step, z=5, x=15), face_at(step, z=10)
    path = app.create_toolpath(doc, step, avoid=[high, low], **{**COARSE, "max_axis_angle": 91})
    nc = results.nc_of(path)
    panel = toolpath.edit(path)
    pump(300)
    unfold()
    avoid = panel.options.fields["avoid"]
    assert avoid.value() == (high, low) and not panel.stale
    pick_until_lit(avoid, 0, click, pump, until)
    screenshot("avoid_lit_up")
    click(field("avoid_remove"))
    assert avoid.value() == (low,) and panel.stale
    assert panel.calculate() and tessellation.name_avoided(path.Mesh) == (low,)
    pump(200)
    panel_button("Cancel")
    panel_closed()
    assert tessellation.name_avoided(path.Mesh) == (high, low) and results.nc_of(path) == nc

    panel = toolpath.edit(path)
    pump(300)
    panel.options.show_options({"avoid": [low]})
    panel_button("OK")
    panel_closed()
    assert tessellation.name_avoided(path.Mesh) == (low,) and results.nc_of(path) != nc
    press("Std_Undo", 500)
    until(lambda: tessellation.name_avoided(path.Mesh) == (high, low), 20000, "undone")
    assert results.nc_of(path) == nc and not results.out_of_date(path)


def test_all_faces_and_a_face_that_is_gone_are_reported_in_the_panel(doc, step, panel, pump):
    every = [f"Face{at + 1}" for at in range(len(step.Shape.Faces))]
    panel.options.show_options({"avoid": every})
    assert not panel.calculate()
    assert (
        "Face1, Face2" in panel.options.error.text()
        and "out of Faces to leave alone" in panel.options.error.text()
    )
    panel.options.show_options({"avoid": every[-1:]})
    assert panel.calculate() and panel.accept()
    pump(200)
    path = doc.Toolpath
    step.Shape = Part.makeBox(20, 20, 5)
    doc.recompute()
    again = toolpath.edit(path)
    pump(200)
    assert again.options.fields["avoid"].value() == (every[-1],) and again.stale
    assert not again.calculate()
    assert f"Step has no {every[-1]} on a solid, which was to be left alone" in again.options.error.text()
    again.options.show_options({"avoid": ()})
    assert again.calculate() and not again.options.error.text() and again.accept()
    pump(200)


def test_a_row_that_is_clicked_while_a_point_is_picked_is_no_point(step, panel, field, click, pump, until):
    avoid = panel.options.fields["avoid"]
    avoid.show_value(["Face1", "Face2"])
    before = panel.options.fields["work_zero"].value()
    click(field("work_zero_pick"))
    pick(avoid, 1, click, pump)
    pump(300)
    assert field("work_zero_pick").isChecked() and panel.options.fields["work_zero"].value() == before
    assert not lit()
    click(field("work_zero_pick"))
    pick_until_lit(avoid, 1, click, pump, until)
    panel.reject()


def test_over_a_mesh_the_field_says_what_does_it(doc, step, pump, unfold):
    mesh = doc.addObject("Mesh::Feature", "Facets")
    mesh.Mesh = Mesh.Mesh(step.Shape.tessellate(0.1))
    doc.recompute()
    panel = toolpath.create(mesh)
    pump(300)
    unfold()
    avoid = panel.options.fields["avoid"]
    assert "--avoid" in avoid.note.text() and not avoid.add.isEnabled() and avoid.value() == ()
    panel.options.show_options(COARSE)
    assert panel.calculate() and panel.reject()


def test_a_face_of_a_body_is_picked_as_one_of_the_body(doc, field, view_click, click, pump, unfold):
    body = doc.addObject("PartDesign::Body", "Body")
    cube = doc.addObject("PartDesign::AdditiveBox", "Cube")
    body.addObject(cube)
    cube.Length = cube.Width = cube.Height = 20
    doc.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    panel = toolpath.create(body)
    pump(300)
    unfold()
    view_click((10, 10, 20))
    assert FreeCADGui.Selection.getSelectionEx()
    click(field("avoid_add"))
    assert panel.options.fields["avoid"].value() == (face_at(body, z=20),), panel.options.fields[
        "avoid"
    ].error.text()
    panel.reject()
