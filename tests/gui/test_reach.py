# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reach map: pressed, calculated, seen in colours, stopped, undone, taken from a tool path, and drawn
again after opening."""

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import pytest
from conftest import QtCore, close_all
from conftest import picture as pixels_of
from test_clicks import look

from freecad_fiveaxis import app
from freecad_fiveaxis.app import reach
from freecad_fiveaxis.core.gouge.obstacles import Obstacle
from freecad_fiveaxis.core.studies import reach_map as module
from freecad_fiveaxis.gui import attach, messages
from freecad_fiveaxis.gui.scene import rest_nodes
from freecad_fiveaxis.gui.scene.reach_nodes import COLOURS

TOOL = {"machine": "trunnion_ac", "cutter": "ball:6:20", "holder": "40x30", "tolerance": 0.02}
HELD, FREE, TIGHT = COLOURS[Obstacle.HOLDER], COLOURS[Obstacle.NONE], COLOURS[Obstacle.CUTTER]

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture(autouse=True)
def coarse(monkeypatch):
    monkeypatch.setattr(module, "PLACES", 200)


@pytest.fixture
def slot(doc, parameters):
    """A block 60 mm wide and 40 high with a slot 14 wide and 30 deep down its middle, open at both ends."""
    group = parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis")
    group.Clear()
    group.SetFloat("CutterDiameter", 6)
    group.SetString("Holder", "40x30")
    attach.register()
    profile = [(-30, 0), (30, 0), (30, 40), (7, 40), (7, 10), (-7, 10), (-7, 40), (-30, 40), (-30, 0)]
    obj = doc.addObject("Part::Feature", "Slot")
    obj.Shape = Part.Face(Part.makePolygon([(x, 0, z) for x, z in profile])).extrude(
        FreeCAD.Vector(0, 160, 0)
    )
    doc.recompute()
    look(doc)
    return obj


def upper(obj):
    """The names of the faces that look up: the slot's floor, and the top on both sides of it."""
    return [f"Face{at}" for at, face in enumerate(obj.Shape.Faces, 1) if face.normalAt(0, 0).z > 0.5]


def drawn(obj):
    """The picture of a map, once there is something on it."""
    picture = obj.ViewObject.Proxy.picture
    return picture if picture is not None and picture.found is not None else None


def level(rgb):
    """A colour on a face that looks up, 0 to 255, as it is drawn."""
    bright = rest_nodes.SHADE + (1.0 - rest_nodes.SHADE) * rest_nodes.LIGHT[2]
    return [round(255 * part * bright) for part in rgb]


def colour_at(picture, place, view_point, view_box):
    """The colour on the screen of the 5 x 5 pixels about a place of the document: their median."""
    point, (left, top, *_) = view_point(place), view_box()
    seen = pixels_of(picture)[
        top + point.y() - 2 : top + point.y() + 3, left + point.x() - 2 : left + point.x() + 3
    ]
    return np.median(seen.reshape(-1, 3), axis=0).tolist()


@pytest.mark.usefixtures("whole_screen")
def test_the_map_is_calculated_seen_in_its_colours_kept_and_undone(
    slot,
    doc,
    select,
    press,
    field,
    click,
    until,
    panel_button,
    panel_closed,
    screenshot,
    view_point,
    view_box,
    pump,
    type_into,
):
    """From above: the slot's floor in the colour of the holder, the top in that of what is reached."""
    doc.clearUndos()
    select(slot, *upper(slot))
    press("FiveAxis_Reach")
    assert not field("show_axes").isEnabled()
    type_into(field("cutter_length"), "20 mm")
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "the areas")
    (result,) = [obj for obj in doc.Objects if hasattr(obj, "ReachableShare")]
    assert (result.Holder, result.CutterKind, result.CutterLength.Value) == ("40x30", "ball", 20.0)
    assert field("verdict").text() == result.Verdict and "stick out 10 mm farther" in field("summary").text()
    until(lambda: drawn(result), 20000, "the map")
    FreeCADGui.getDocument(doc.Name).ActiveView.viewTop()
    FreeCADGui.getDocument(doc.Name).ActiveView.fitAll()
    FreeCADGui.Selection.clearSelection()

    def has(place, rgb):
        found = colour_at(screenshot("reach_map"), place, view_point, view_box)
        return all(abs(a - b) <= 14 for a, b in zip(found, level(rgb), strict=True))

    until(lambda: has((0, 80, 10), HELD), 30000, "the floor in the colour of the holder")
    assert has((-18, 80, 40), FREE) and has((18, 40, 40), FREE)
    click(field("show_axes"), QtCore.QPoint(8, field("show_axes").height() // 2))
    until(lambda: result.ViewObject.ShowAxes and drawn(result).strokes.getNumChildren(), 20000, "the axes")
    FreeCADGui.getDocument(doc.Name).ActiveView.viewIsometric()
    pump(300)
    screenshot("reach_axes")
    panel_button("OK", 1000)
    panel_closed()
    assert doc.UndoCount == 1 and result.ViewObject.Proxy.claimChildren() == [doc.Tessellation]
    assert (
        result.ViewObject.Proxy.getIcon().endswith("ReachMap.svg")
        and not doc.Tessellation.ViewObject.Visibility
    )
    doc.undo()
    until(lambda: [obj.Name for obj in doc.Objects] == ["Slot"], 20000, "undone")
    pump(300)
    doc.redo()
    again = doc.ReachMap
    until(lambda: drawn(again) and drawn(again).warned == "", 20000, "the map after redo, not called old")


def test_a_stopped_map_leaves_the_document_as_it_was(
    anew, slot, doc, select, press, field, click, until, monkeypatch, panel_button
):
    from freecad_fiveaxis.gui import waiting

    doc.clearUndos()
    begin, message = waiting.Waiting.__call__, []

    def stopped(self, stage, fraction):
        QtCore.QTimer.singleShot(0, self.dialog.cancel)  # what Esc does
        begin(self, stage, fraction)

    select(slot)
    press("FiveAxis_Reach")
    monkeypatch.setattr(waiting.Waiting, "__call__", stopped)
    monkeypatch.setattr(messages, "status", message.append)
    monkeypatch.setattr("freecad_fiveaxis.gui.panels.path_panel.status", message.append)
    click(field("calculate"))
    until(lambda: message, 20000, "that it was stopped")
    assert message == ["Stopped; the document is as it was."] and [obj.Name for obj in doc.Objects] == [
        "Slot"
    ]
    panel_button("Cancel")
    assert doc.UndoCount == 0


def test_a_tool_path_gives_the_panel_its_machine_and_tool(
    slot, doc, tree_row, press, field, panel_button, panel_closed, until
):
    settings = {
        "machine": "trunnion_bc",
        "cutter": "ball:6:60",
        "passes": "planes",
        "stepover": 6,
        "work_zero": (1, 2, 3),
    }
    path = app.create_toolpath(doc, (slot, upper(slot)), **settings, gouge="off", linearize="off")
    doc.clearUndos()
    tree_row(path.Label)
    press("FiveAxis_Reach")
    panel_button("OK", 1000)
    panel_closed()
    result = doc.ReachMap
    assert (result.Machine, result.CutterLength.Value, tuple(result.WorkZero)) == (
        "trunnion_bc",
        60.0,
        (1, 2, 3),
    )
    assert result.Mesh is path.Mesh and not path.ViewObject.Visibility and doc.UndoCount == 1
    assert result.ViewObject.Proxy.claimChildren() == [], "the tessellation stays below its tool path"
    until(lambda: drawn(result), 20000, "the map")
    assert tuple(drawn(result).origin.translation.getValue().getValue()) == pytest.approx((1, 2, 3))
    result.ViewObject.Proxy.doubleClicked(result.ViewObject)
    until(lambda: "<table>" in field("summary").text(), 20000, "the result that is there")
    panel_button("Cancel")


@pytest.mark.usefixtures("whole_screen")
def test_a_reopened_map_is_drawn_again_and_says_when_it_is_old_or_its_solid_gone(
    slot, doc, pump, until, tmp_path
):
    area = app.reach_map((slot, upper(slot)), **TOOL).ReachableArea.Value
    file = str(tmp_path / "reach.FCStd")
    doc.saveAs(file)
    FreeCAD.closeDocument(doc.Name)
    pump(300)
    again = FreeCAD.openDocument(file)
    try:
        result = again.ReachMap
        assert result.ReachableArea.Value == pytest.approx(area)
        until(lambda: drawn(result) and drawn(result).warned == "", 20000, "the map, not called old")
        legend = drawn(result)._legend()
        assert [colour for colour, _ in legend.keys] == [FREE, TIGHT, HELD]
        assert all("mm²" in text and "%" in text for _, text in legend.keys)
        result.Holder = "20x30"
        until(lambda: "recompute" in drawn(result).warned, 20000, "a map that is old")
        again.recompute()
        until(
            lambda: drawn(result).warned == "" and drawn(result).found is result.Proxy.last,
            20000,
            "the new map",
        )
        again.removeObject("Slot")
        until(lambda: "was deleted" in drawn(result).warned, 20000, "that the solid is gone")
        assert reach.out_of_date(result)
    finally:
        close_all(again.Name)
