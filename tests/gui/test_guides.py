# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guides, boundary, centre and axis of passes picked in the 3D view: taken, named, lit up, let go, followed
and missed."""

import FreeCAD
import FreeCADGui
import Part
import pytest

from freecad_fiveaxis.app import guides
from freecad_fiveaxis.gui.panels import toolpath

COARSE = {
    "passes": "radial", "cutter": "ball:6", "scallop": 0.2, "max_axis_angle": 40.0, "tool_length": 120.0, "spindle": 8000,
    "tool_axis": "facet_mean",
}  # fmt: skip


@pytest.fixture
def disc(doc):
    """A disc of 15 mm radius and 5 mm about (20, 10)."""
    result = doc.addObject("Part::Feature", "Disc")
    result.Shape = Part.makeCylinder(15, 5, FreeCAD.Vector(20, 10, 0))
    doc.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewTop()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    return result


@pytest.fixture
def panel(disc, pump, unfold):
    opened = toolpath.create(disc)
    opened.options.show_options(COARSE)
    pump(300)
    unfold()
    pump(200)
    return opened


def named(obj, kind, test):
    rows = [
        test(one)
        for one in getattr(obj.Shape, {"Edge": "Edges", "Face": "Faces", "Vertex": "Vertexes"}[kind])
    ]
    return f"{kind}{rows.index(True) + 1}"


def wall(obj):
    return named(obj, "Face", lambda one: one.Surface.TypeId == "Part::GeomCylinder")


def rim(obj):
    return named(obj, "Edge", lambda one: one.Curve.TypeId == "Part::GeomCircle" and one.BoundBox.ZMin > 1)


def pick(panel, name, obj, element, click, field, until):
    """Press Pick, and select an element as a click in the view does."""
    click(field(name + "_pick"))
    FreeCADGui.Selection.addSelection(obj.Document.Name, obj.Name, element, 0.0, 0.0, 0.0)
    until(lambda: not field(name + "_pick").isChecked(), 20000, "the pick")


def test_centre_and_axis_are_picked_named_lit_up_and_kept(
    doc, disc, panel, click, field, until, pump, screenshot
):
    fields = panel.options.fields
    pick(panel, "pass_centre", disc, rim(disc), click, field, until)
    assert (
        fields["pass_centre"].value() == "20,10,5"
        and field("pass_centre_picked").text() == f"{rim(disc)} of Disc"
    )
    (lit,) = FreeCADGui.Selection.getSelectionEx()
    assert lit.Object is disc and lit.SubElementNames == (rim(disc),)
    pick(panel, "pass_axis", disc, wall(disc), click, field, until)
    assert [abs(part) for part in fields["pass_axis"].value()] == [0, 0, 1]
    assert panel.options.read_values()["picked"] == {
        "pass_centre": (disc, rim(disc)),
        "pass_axis": (disc, wall(disc)),
    }
    pump(300)
    screenshot("guides_picked")
    panel.options.show_options({"work_zero": (1.0, 2.0, 3.0)})
    assert fields["pass_centre"].value() == "19,8,2" and fields["pass_centre"].link, (
        "about the work zero of the form"
    )
    assert panel.preview_passes() and panel.calculate(), panel.options.error.text()
    path = panel.obj
    assert guides.links_of(path) == panel.options.read_values()["picked"] and path.Passes > 10
    assert panel.accept()
    pump(200)
    again = toolpath.edit(path)
    pump(200)
    assert again.options.read_values()["picked"] == guides.links_of(path) and not again.stale
    again.options.fields["pass_centre"].line.textEdited.emit("0,0,0")
    again.options.show_options({"pass_centre": "18,10,0"})
    assert again.stale and "pass_centre" not in again.options.read_values()["picked"]
    assert again.calculate() and set(guides.links_of(path)) == {"pass_axis"}
    again.reject()


def test_where_passes_begin_and_end_is_picked_too(disc, panel, click, field, until, pump):
    panel.options.show_options({"passes": "morph"})
    pump(200)
    for name in ("from_", "to"):
        pick(panel, name, disc, "Vertex1", click, field, until)
        assert panel.options.fields[name].value() == ",".join(
            f"{at:.12g}" for at in disc.Shape.Vertexes[0].Point
        )
        assert field(name + "_picked").text() == "Vertex1 of Disc"
    assert set(panel.options.read_values()["picked"]) == {"from_", "to"}
    panel.options.show_options({"passes": "planes"})
    assert panel.options.read_values()["picked"] == {}, "what counts for nothing is not linked"
    panel.reject()


def test_a_wrong_pick_says_what_is_needed_and_nothing_changes(disc, panel, click, field, until):
    fields, before = panel.options.fields, panel.options.fields["pass_centre"].value()
    pick(panel, "pass_centre", disc, wall(disc), click, field, until)
    assert "has no centre: pick a vertex, a circle or a sphere" in fields["pass_centre"].error.text()
    assert fields["pass_centre"].value() == before and fields["pass_centre"].link is None
    pick(panel, "pass_axis", disc, "Vertex1", click, field, until)
    assert (
        "has no axis: pick a straight or circular edge" in fields["pass_axis"].error.text()
        and fields["pass_axis"].link is None
    )
    panel.reject()


def test_the_mouse_picks_a_face_of_a_body_whose_axis_is_kept(
    doc, field, view_click, click, pump, until, unfold, screenshot
):
    body = doc.addObject("PartDesign::Body", "Body")
    round_ = doc.addObject("PartDesign::AdditiveCylinder", "Round")
    body.addObject(round_)
    round_.Radius, round_.Height = 12, 20
    body.Placement.Base = FreeCAD.Vector(5, 6, 0)
    doc.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewFront()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    panel = toolpath.create(body)
    panel.options.show_options(COARSE)
    pump(300)
    unfold()
    click(field("pass_axis_pick"))
    view_click((5, -6, 10))
    until(lambda: panel.options.fields["pass_axis"].link, 20000, "the pick")
    link = panel.options.fields["pass_axis"].link
    assert link[1].startswith("Face") and panel.options.fields["pass_axis"].value() == [0, 0, 1]
    pump(300)
    screenshot("guides_clicked")
    panel.options.show_options({"pass_centre": "0,0,0"})
    assert guides.options_of({"pass_centre": (link[0], "Vertex1")}, (5, 6, 0))["pass_centre"].split(",")[
        0
    ] in ("12", "-12")
    assert panel.calculate(), panel.options.error.text()
    assert guides.links_of(panel.obj) == {"pass_axis": link}
    panel.reject()


def test_a_face_is_picked_as_boundary_and_an_edge_as_guide(
    doc, disc, panel, click, field, until, pump, screenshot
):
    top = named(disc, "Face", lambda one: one.CenterOfMass.z > 4.9)
    panel.options.show_options({"passes": "scallop", "boundary": "missing.csv"})
    assert not panel.options.check() and "missing.csv" in panel.options.fields["boundary"].error.text()
    pick(panel, "boundary", disc, top, click, field, until)
    text = panel.options.fields["boundary"].value()
    assert (
        text.count(";") > 20 and field("boundary_picked").text() == f"{top} of Disc" and panel.options.check()
    )
    pick(panel, "from_", disc, rim(disc), click, field, until)
    assert panel.options.read_values()["picked"] == {"boundary": (disc, top), "from_": (disc, rim(disc))}
    pump(300)
    screenshot("boundary_picked")
    assert panel.preview_passes() and panel.calculate(), panel.options.error.text()
    assert guides.links_of(panel.obj) == panel.options.read_values()["picked"] and panel.obj.Passes > 3
    pick(panel, "boundary", disc, "Vertex1", click, field, until)
    assert (
        "bounds nothing: pick a face, or an edge of a closed wire"
        in panel.options.fields["boundary"].error.text()
    )
    assert panel.options.fields["boundary"].value() == text
    panel.reject()


def test_the_words_of_a_place_are_those_of_the_users_language(german, panel):
    for name, word, local in (("from_", "border", "Rand"), ("pass_centre", "middle", "Mitte")):
        place = panel.options.fields[name]
        place.show_value(word)
        assert place.line.text() == local and place.value() == word
        place.line.setText(word)
        assert place.value() == word
        place.show_value("1,2,3")
        assert place.line.text() == "1,2,3" == place.value()
    hint = panel.options.fields["rapids"].editor.toolTip()
    assert "machine:" not in hint and "„die der Maschine“" in hint
    panel.reject()
