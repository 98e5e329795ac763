# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole way as a user goes it: a part, every button, panels filled by mouse and keys, and what the screen
then shows.

shown: pixels of the 3D view that have the colours of a drawn path, counted in a picture of the screen.
"""

import json

import FreeCAD
import FreeCADGui
import pytest
from conftest import QtWidgets, close_all, picture

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results
from freecad_fiveaxis.core import cli, report

pytestmark = pytest.mark.usefixtures("kept")
HIDDEN = "the part hides the path"


@pytest.fixture(autouse=True)
def _quick_preferences(parameters, tmp_path):
    """Preferences under which a small part takes a moment; the NC goes into the test's own folder."""
    group = parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis")
    group.Clear()
    group.SetString("OutputFolder", str(tmp_path))


@pytest.fixture
def dome(doc):
    """A half ball of 12 mm made by Part's own command; its top passes the pole of trunnion_ac."""
    ball = doc.addObject("Part::Sphere", "Dome")
    ball.Radius, ball.Angle1 = 12, 0
    doc.recompute()
    look(doc)
    return ball


def look(doc):
    """The whole of the document from above and aside."""
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    view.viewIsometric()
    view.fitAll()


@pytest.fixture
def shown(pixels, screenshot, view_box):
    """shown(name, obj, colour): take the picture `name`; how many pixels of the view have that colour of the
    object's view."""

    def count(name, obj, *colours):
        box, picture = view_box(), screenshot(name)
        wanted = [
            [round(255 * part) for part in tuple(getattr(obj.ViewObject, colour))[:3]] for colour in colours
        ]
        return [pixels(picture, rgb, 24, box) for rgb in wanted]

    return count


@pytest.fixture
def plan(press, panel_button, panel_closed, field, choose, type_into, until, click):
    """plan(doc, stepover, passes): press Toolpath, fill the panel, calculate, accept; the new Toolpath
    object. ``passes`` None: as the panel has them."""

    def make(doc, stepover="1.5 mm", tolerance="0.05 mm", passes="parallel planes"):
        before = {obj.Name for obj in doc.Objects}
        press("FiveAxis_Toolpath")
        if passes:
            choose(field("passes"), passes)
        choose(field("spacing_kind"), "Stepover")
        type_into(field("stepover"), stepover)
        type_into(field("tolerance"), tolerance)
        click(field("calculate"))
        until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
        panel_button("OK", 500)
        panel_closed()
        (path,) = [obj for obj in doc.Objects if obj.Name not in before and obj.isDerivedFrom("App::FeaturePython")
                   and hasattr(obj, "Stepover")]  # fmt: skip
        return path

    return make


def command_line(path, folder):
    """The NC file that the command line makes from the mesh and the settings of a path."""
    app.tessellate(path.Mesh, folder / "part.stl")
    job = {**results.figures_of(path).inputs, "source": "part.stl", "output": "line.ngc"}
    (folder / "job.json").write_text(json.dumps(job))
    assert cli.main(["run", str(folder / "job.json"), "--quiet"]) < 2
    return (folder / "line.ngc").read_bytes()


def names(doc):
    return [obj.Name for obj in doc.Objects]


@pytest.fixture
def annotate(press, until, doc):
    """annotate(): press Markers; the object that is made in the document."""

    def make():
        press("FiveAxis_Annotate", 500)
        (markers,) = until(lambda: [obj for obj in doc.Objects if hasattr(obj, "Places")], 20000, "markers")
        return markers

    return make


@pytest.mark.short
def test_a_solid_built_by_clicks_gets_passes_markers_nc_and_play(window, dome, doc, press, tree_row, plan, shown, tmp_path,
                                                                annotate, panel_button, panel_closed, field, type_into, until):  # fmt: skip
    tree_row("Dome")
    press("FiveAxis_Tessellate", 500)
    (mesh,) = until(
        lambda: [obj for obj in doc.Objects if obj.isDerivedFrom("Mesh::Feature")], 20000, "a mesh"
    )
    until(lambda: mesh.Mesh.CountFacets > 500, 20000, "its facets")
    press("Std_Undo")
    until(lambda: names(doc) == ["Dome"], 20000, "undone")
    press("Std_Redo")
    until(lambda: len(names(doc)) == 2, 20000, "done again")

    tree_row("Dome")
    path = plan(doc, passes=None)
    assert path.Passes > 8
    assert path.Blocks > 100
    dome.ViewObject.hide()
    FreeCADGui.Selection.clearSelection()
    until(lambda: shown("toolpath", path, "ColourGood")[0] > 300, 30000, HIDDEN)
    until(lambda: shown("toolpath", path, "ColourBad")[0] > 20, 30000, "the legend's colours")

    tree_row(path.Label)
    markers = annotate()
    expected = report.markers(results.figures_of(path))
    assert [tuple(place) for place in markers.Places] == [pytest.approx(mark.place) for mark in expected]
    assert list(markers.Labels) == [mark.label for mark in expected]
    FreeCADGui.Selection.clearSelection()
    view = markers.ViewObject  # in one colour whatever the largest deviation is, and not in one of the path's
    view.ColourGood = view.ColourBad = view.ColourSingular
    until(
        lambda: shown("markers", markers, "ColourSingular")[0] > 40,
        30000,
        "the marker of the largest deviation",
    )

    tree_row(path.Label)
    press("FiveAxis_PostProcess")
    nc = tmp_path / "dome.ngc"
    type_into(field("nc_path"), str(nc))
    type_into(field("spindle"), "9000")
    panel_button("OK", 500)
    panel_closed()
    assert nc.read_bytes() == results.nc_of(path) == command_line(path, tmp_path)
    shown("posted", path, "ColourGood")


def test_a_marker_picked_in_the_view_shows_its_finding(
    dome, doc, plan, tree_row, annotate, view_click, window, screenshot, pump, until, shown
):
    tree_row("Dome")
    path = plan(doc)
    assert path.SingularBlocks > 0
    tree_row(path.Label)
    markers = annotate()
    FreeCADGui.Selection.clearSelection()
    until(lambda: shown("markers", markers, "ColourSingular")[0] > 40, 30000, "a marker of a singular block")
    dome.ViewObject.hide()
    path.ViewObject.hide()
    path.Mesh.ViewObject.hide()
    FreeCADGui.getDocument(doc.Name).ActiveView.viewTop()
    look(doc)
    FreeCADGui.Selection.clearSelection()
    pump(300)
    largest = report.markers(results.figures_of(path))[0]
    view_click(markers.Places[0])
    table = until(
        lambda: window.findChild(QtWidgets.QTableWidget, "FiveAxisFindingsTable"), 20000, "a list of findings"
    )
    text = window.findChild(QtWidgets.QTextBrowser, "FiveAxisFindingsText")
    until(table.isVisible, 20000, "a list of findings that is shown")
    until(lambda: table.selectionModel().selectedRows(), 20000, "a row that is chosen")
    line = largest.finding.line if largest.finding else path.WorstLine
    until(lambda: f"NC line {line}" in text.toPlainText(), 20000, "what is found there")
    screenshot("picked")


def test_a_row_of_the_findings_moves_the_view(
    dome, doc, plan, tree_row, press, window, click, pump, screenshot, until
):
    from freecad_fiveaxis.gui import findings_panel

    tree_row("Dome")
    path = plan(doc)
    panel = findings_panel.show(path)
    text = window.findChild(QtWidgets.QTextBrowser, "FiveAxisFindingsText")
    until(
        lambda: all(message in text.toPlainText() for message in ("Proven:", "Assumed:", "Not known:")),
        20000,
        "what that rests on",
    )
    pump(300)
    screenshot("findings-scope")
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    before = view.getCamera()
    table = window.findChild(QtWidgets.QTableWidget, "FiveAxisFindingsTable")
    row, place = next(
        (at, row.finding.place) for at, row in enumerate(panel.rows) if row.finding.place is not None
    )
    click(table.viewport(), table.visualItemRect(table.item(row, 0)).center())
    until(lambda: view.getCamera() != before, 20000, "the view moved")

    def in_the_middle():
        return all(
            abs(at - size / 2) < size / 4
            for at, size in zip(view.getPointOnScreen(*place), view.getSize(), strict=True)
        )

    until(in_the_middle, 20000, "the finding in the middle of the view")
    screenshot("findings-row")


@pytest.mark.short
def test_undo_redo_and_a_document_reopened(
    dome, doc, plan, tree_row, press, shown, pump, tmp_path, anew, until
):
    tree_row("Dome")
    path = plan(doc)
    label, blocks, nc = path.Label, path.Blocks, results.nc_of(path)
    after = names(doc)
    press("Std_Undo")
    until(lambda: names(doc) == ["Dome"], 20000, "one step of undo for one press of OK")
    press("Std_Redo")
    until(lambda: names(doc) == after, 20000, "all of it done again")
    if doc.isTouched():  # FreeCAD 1.0 and later leave what redo brings back to be recomputed, plain boxes too
        press("Std_Refresh", 500)
        until(lambda: not doc.isTouched(), 20000, "recomputed")
    file = str(tmp_path / "dome.FCStd")
    doc.saveAs(file)
    FreeCAD.closeDocument(doc.Name)
    pump(300)
    anew()
    again = FreeCAD.openDocument(file)
    try:
        pump(500)
        path = again.getObjectsByLabel(label)[0]
        assert path.Blocks == blocks
        assert "Touched" not in path.State
        again.getObject("Dome").ViewObject.hide()
        look(again)
        tree_row(label)
        press("FiveAxis_Annotate", 500)
        FreeCADGui.Selection.clearSelection()
        until(lambda: shown("reopened", path, "ColourGood")[0] > 300, 30000, HIDDEN)
        assert results.nc_of(path) == nc
        again.getObject("Dome").Radius = 9
        assert "Touched" in again.getObject("Dome").State
        press("Std_Refresh", 500)
        until(
            lambda: 0 < path.Blocks < blocks and "Up-to-date" in path.State,
            60000,
            "a path over the smaller ball",
        )
    finally:
        close_all(again.Name)


def _faces(doc):
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    return box, ("Face6",)


def _body(doc):
    body = doc.addObject("PartDesign::Body", "Body")
    ball = doc.addObject("PartDesign::AdditiveSphere", "Sphere")
    body.addObject(ball)
    ball.Radius, ball.Angle1 = 15, 0
    doc.recompute()
    return body, ()


def _compound(doc):
    parts = [doc.addObject("Part::Box", name) for name in ("Left", "Right")]
    parts[1].Placement.Base.x = 20
    compound = doc.addObject("Part::Compound", "Both")
    compound.Links = parts
    doc.recompute()
    return compound, ()


def _mesh(doc):
    import MeshPart
    import Part

    mesh = doc.addObject("Mesh::Feature", "Loose")
    mesh.Mesh = MeshPart.meshFromShape(
        Shape=Part.makeBox(20, 20, 5), LinearDeflection=0.1, AngularDeflection=0.3
    )
    doc.recompute()
    return mesh, ()


@pytest.mark.parametrize("make", [_faces, _body, _compound, _mesh], ids=lambda make: make.__name__[1:])
def test_what_can_be_selected_gets_a_path_that_is_seen(make, doc, select, plan, shown, until):
    base, faces = make(doc)
    look(doc)
    select(base, *faces)
    path = plan(doc, "2 mm")
    assert path.Blocks > 5
    for obj in doc.Objects:
        if obj is not path and obj.Name != path.Name:
            obj.ViewObject.hide()
    FreeCADGui.Selection.clearSelection()
    until(
        lambda: sum(shown(f"from-{make.__name__[1:]}", path, "ColourGood", "ColourBad")) > 150, 30000, HIDDEN
    )


def test_inches_in_the_panel_and_in_the_summary(dome, doc, tree_row, press, field, choose, type_into, click, until, panel_button,
                                                panel_closed, parameters, screenshot):  # fmt: skip
    units = parameters("User parameter:BaseApp/Preferences/Units")
    units.SetInt("UserSchema", 3)
    FreeCAD.Units.setSchema(3)
    try:
        tree_row("Dome")
        press("FiveAxis_Toolpath")
        choose(field("passes"), "parallel planes")
        choose(field("spacing_kind"), "Stepover")
        type_into(field("stepover"), "0.125")
        click(field("calculate"))
        until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
        screenshot("inches")
        assert "in" in field("summary").text() or '"' in field("summary").text()
        panel_button("OK", 500)
        panel_closed()
        (path,) = [obj for obj in doc.Objects if hasattr(obj, "Stepover")]
        assert path.Stepover.Value == pytest.approx(3.175)
    finally:
        FreeCAD.Units.setSchema(0)


@pytest.mark.short
def test_play_moves_tool_and_table(dome, doc, plan, tree_row, press, screenshot, view_box, panel_button, panel_closed, field,
                                   click, until):  # fmt: skip
    tree_row("Dome")
    path = plan(doc)
    before = names(doc)
    tree_row(path.Label)
    press("FiveAxis_Play", 800)
    click(field("worst"))
    until(lambda: str(path.WorstLine) in field("line").text(), 20000, "the worst block")
    worst = screenshot("play-worst")
    for _ in range(3):
        click(field("forward"))
    until(lambda: differing(worst, screenshot("play-later"), view_box()) > 200, 30000, "the tool moved")
    later = screenshot("play-later")
    click(field("machine"))
    until(lambda: differing(later, screenshot("play-machine"), view_box()) > 2000, 30000, "the table turned")
    slider = field("slider")
    start = slider.value()
    click(field("play"))
    until(lambda: slider.value() > start, 20000, "the slider moved")
    click(field("play"))
    panel_button("Close")
    panel_closed()
    assert names(doc) == before


def differing(first, second, box):
    """How many pixels of the 3D view differ between two pictures."""
    left, top, width, height = box
    parts = [picture(path)[top : top + height, left : left + width] for path in (first, second)]
    return int((abs(parts[0] - parts[1]).max(axis=2) > 40).sum())
