# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our document objects in the tree and in the 3D view: drawn, coloured, out of date, undone, and drawn again
after opening."""

import time

import FreeCAD
import FreeCADGui
import Part
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results
from freecad_fiveaxis.core import report
from freecad_fiveaxis.gui import attach, foremost, view_providers

pytestmark = pytest.mark.usefixtures("kept")
TABLE_2 = "G90 G93\nG1 X-90.9595 Y7.3103 Z227.6341 A1.0664 C148.9685 F60\nG1 X-82.0656 Y-34.8175 Z228.3975 A1.1793 C121.5477 F60\nM2\n"


@pytest.fixture
def path(doc, pump):
    """A toolpath over a dome whose top passes the pole, on trunnion_ac."""
    attach.register()
    base = doc.addObject("Part::Feature", "Dome")
    base.Shape = Part.makeSphere(60, FreeCAD.Vector(0, 0, -60)).common(
        Part.makeBox(40, 24, 20, FreeCAD.Vector(-20, -12, -16))
    )
    doc.recompute()
    result = app.create_toolpath(
        doc, base, passes="planes", machine="trunnion_ac", cutter="ball:10", stepover=2.0
    )
    _settled(result, pump)
    FreeCADGui.getDocument(doc.Name).ActiveView.viewIsometric()
    FreeCADGui.getDocument(doc.Name).ActiveView.fitAll()
    pump(200)
    return result


@pytest.fixture
def audit(doc, pump, tmp_path):
    """The audit of So et al.'s Table 2."""
    attach.register()
    (tmp_path / "t2.ngc").write_text(TABLE_2)
    result = app.audit(doc, str(tmp_path / "t2.ngc"), "mikron_ucp710")
    _settled(result, pump)
    return result


def _settled(obj, pump, ms=30000):
    """Let the window work until the path is drawn."""
    end = time.monotonic() + ms / 1000
    while time.monotonic() < end:
        pump(50)
        picture = obj.ViewObject.Proxy.picture
        if (
            picture is not None
            and picture.figures is not None
            and picture.styled
            and picture.checked is not None
        ):
            return picture
    raise AssertionError("the path was not drawn")


def _images(group):
    """How many pictures (label, legend) there are below a node."""
    from pivy import coin

    search = coin.SoSearchAction()
    search.setType(coin.SoImage.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(group)
    return search.getPaths().getLength()


def test_every_object_has_its_view_and_its_icon(path, audit, doc, tmp_path, pump):
    markers = app.annotate(path)
    written = app.post_process(path, str(tmp_path / "dome.ngc"))
    pump(200)
    kinds = {
        "PathView": (path, audit),
        "TessellationView": (path.Mesh,),
        "MarkersView": (markers,),
        "NCOutputView": (written,),
    }
    icons = set()
    for name, objects in kinds.items():
        for obj in objects:
            assert type(obj.ViewObject.Proxy) is getattr(view_providers, name)
            icons.add(obj.ViewObject.Proxy.getIcon())
    assert len(icons) == 5 and not any("fiveaxis.svg" in icon for icon in icons)
    assert path.ViewObject.Proxy.claimChildren() == [path.Mesh, markers, written]
    assert not path.Mesh.ViewObject.Visibility and doc.getObject("Dome").ViewObject.Visibility


def _parents(window, label):
    """The labels above each row of that label, in every tree of the window."""
    from PySide import QtCore, QtGui

    try:
        from PySide import QtWidgets
    except ImportError:
        QtWidgets = QtGui
    found = []

    def walk(model, index, above):
        for row in range(model.rowCount(index)):
            child = model.index(row, 0, index)
            found.extend([above] if child.data() == label else [])
            walk(model, child, child.data())

    for tree in window.findChildren(QtWidgets.QTreeWidget):
        walk(tree.model(), QtCore.QModelIndex(), None)
    return found


def test_the_tree_shows_markers_below_their_path(audit, window, pump, until):
    markers = app.annotate(audit)
    until(
        lambda: set(_parents(window, markers.Label)) == {audit.Label}, 20000, "the markers below their path"
    )
    assert audit.State == ["Up-to-date"]


def test_what_is_drawn_is_what_the_core_says(path):
    figures = results.figures_of(path)
    picture = path.ViewObject.Proxy.picture
    assert picture.figures is figures
    assert picture.drawing.markers == report.markers(figures)
    assert figures.singularity.singular[figures.feeds].sum() == path.SingularBlocks > 0
    near = [mark for mark in picture.drawing.markers if mark.kind == "singular-block"]
    assert near and all(
        abs(mark.place[0]) < 10 and abs(mark.place[1]) < 10 for mark in near
    )  # the pole is at the dome's top


def test_the_markers_object_stands_where_the_core_says(path, until):
    markers = app.annotate(path)
    expected = report.markers(results.figures_of(path))
    assert [tuple(place) for place in markers.Places] == [
        pytest.approx(mark.place, abs=1e-5) for mark in expected
    ]
    switches = path.ViewObject.Proxy.picture.nodes.switches

    def shown(name):
        return switches[name].whichChild.getValue()

    until(lambda: shown("marks") == shown("label") == -1, 20000, "the path leaves them to the Markers object")
    markers.Document.removeObject(markers.Name)
    until(lambda: shown("marks") == -3, 20000, "the path's own marks")


def test_the_colours_are_seen_and_can_be_changed(path, pump, screenshot, pixels, view_box, until):
    view = path.ViewObject
    before = pixels(screenshot("path"), (255, 0, 255), 8, view_box())
    view.ColourGood = (1.0, 0.0, 1.0)
    view.ShowLegend = False

    def seen(name):
        return pixels(screenshot(name), (255, 0, 255), 8, view_box())

    until(lambda: seen("path-coloured") > before + 300, 30000, "the path in another colour")
    view.Visibility = False
    until(lambda: seen("path-hidden") < 20, 30000, "no path")


@pytest.mark.usefixtures("whole_screen")
def test_every_part_can_be_switched_off(path, pump, until, screenshot, view_box):
    from PySide import QtGui

    def seen():
        left, top, width, height = view_box()
        return QtGui.QImage(screenshot("part")).copy(left, top, width, height)

    path.ViewObject.ShowRapids = True
    parts = {"ShowCuts": "cuts", "ShowLinks": "links", "ShowAxes": "axes", "ShowMarkers": "marks", "ShowCurves": "curves", "ShowRapids": "rapids", "ShowLegend": "legend",
             "ShowLabel": "label"}  # fmt: skip
    pump(300)
    for prop, part in parts.items():
        switch, before = path.ViewObject.Proxy.picture.nodes.switches[part], seen()
        setattr(path.ViewObject, prop, False)
        until(lambda before=before: seen() != before, 20000, f"{part} seen to go")
        until(lambda switch=switch: switch.whichChild.getValue() == -1, 20000, f"{part} gone")
        setattr(path.ViewObject, prop, True)
        pump(300)
        until(lambda switch=switch: switch.whichChild.getValue() == -3, 20000, f"{part} back")


@pytest.mark.usefixtures("whole_screen")
def test_a_path_that_is_out_of_date_says_so_in_the_view(path, doc, pump, screenshot, pixels, view_box, until):
    from freecad_fiveaxis.gui.scene.overlay import WARN

    picture = path.ViewObject.Proxy.picture
    assert picture.checked == ""
    picture.nodes.turn("cuts", False)
    before = pixels(screenshot("current"), WARN, 12, view_box())
    path.Feed = "700 mm/min"
    until(lambda: picture.checked, 20000, "a change of a setting noticed")
    until(lambda: pixels(screenshot("out-of-date"), WARN, 12, view_box()) > before + 40, 30000, "the warning")
    doc.recompute()
    _settled(path, pump)
    until(lambda: picture.checked == "", 20000, "a path that is current")
    doc.getObject("Dome").Placement.Base.z = 1.0
    until(lambda: picture.checked, 20000, "a change of the solid noticed")
    doc.recompute()
    until(lambda: picture.checked == "", 20000, "a path that is current")
    until(lambda: picture.figures is results.figures_of(path), 20000, "the picture of the new result")


def test_the_work_zero_moves_the_drawing(doc, pump):
    attach.register()
    base = doc.addObject("Part::Box", "Box")
    base.Placement.Base = FreeCAD.Vector(100, 50, 30)
    doc.recompute()
    path = app.create_toolpath(
        doc, base, passes="planes", machine="trunnion_ac", stepover=4.0, work_zero=(105, 55, 40)
    )
    picture = _settled(path, pump)
    assert picture.nodes.origin.translation.getValue().getValue() == pytest.approx((105, 55, 40))
    low, high = picture.drawing.low + (105, 55, 40), picture.drawing.high + (105, 55, 40)
    assert low[0] < 101 and high[0] > 109 and high[2] > 39.9  # over the box where it stands


def test_table_2_is_drawn_with_its_label_and_a_curve_that_overshoots(audit, doc, pump, screenshot):
    import numpy as np

    picture = audit.ViewObject.Proxy.picture
    doc_view = FreeCADGui.getDocument(doc.Name).ActiveView
    doc_view.viewIsometric()
    doc_view.fitAll()
    pump(300)
    screenshot("table2")
    assert audit.MaxSegmentDeviation.Value == pytest.approx(2.12642, abs=1e-4) and audit.WorstLine == 3
    start, end = picture.drawing.chord
    along = (end - start) / np.linalg.norm(end - start)
    beyond = ((picture.drawing.curve - start) @ along).max() - np.linalg.norm(end - start)
    assert beyond == pytest.approx((2.74 - 1.0) * 1.122, abs=0.02)
    first = picture.drawing.markers[0]
    assert first.kind == "largest-deviation"
    foot, place = picture.drawing.spoke
    assert place == pytest.approx(first.place) and np.linalg.norm(place - foot) == pytest.approx(
        2.12642, abs=1e-4
    )
    assert _images(picture.nodes.groups["label"]) == 1, "one label, no more"


@pytest.mark.parametrize(("schema", "value"), [(0, "2.126 mm"), (3, "0.08372 in")])
def test_the_label_honours_the_users_units(audit, schema, value):
    from freecad_fiveaxis.gui.scene import words

    try:
        FreeCAD.Units.setSchema(schema)
        message = words.label_text(audit.MaxSegmentDeviation.Value, audit.WorstLine, audit.Tolerance.Value)
    finally:
        FreeCAD.Units.setSchema(0)
    assert message.startswith(f"{value}, NC line 3: over ")


def test_a_document_that_is_opened_again_shows_its_picture(path, doc, pump, tmp_path, screenshot, anew):
    app.annotate(path)
    path.ViewObject.LineWidth = 3.0
    pump(200)
    label, before = path.Label, path.ViewObject.Proxy.picture.drawing
    doc.saveAs(str(tmp_path / "again.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    pump(200)
    anew()
    again = FreeCAD.openDocument(str(tmp_path / "again.FCStd"))
    try:
        path = again.getObjectsByLabel(label)[0]
        picture = _settled(path, pump)
        screenshot("opened-again")
        assert picture.checked == "" and path.ViewObject.LineWidth == 3.0
        assert (picture.drawing.stroke == before.stroke).all() and (
            picture.drawing.level == before.level
        ).all()
        assert [one.Name for one in path.ViewObject.Proxy.claimChildren()] == ["Tessellation", "Markers"]
        assert path.ViewObject.Proxy.getIcon().endswith("/Toolpath.svg")
        assert again.getObject("Markers").ViewObject.Proxy.picture is not None
    finally:
        FreeCAD.closeDocument(again.Name)


def test_a_picture_that_cannot_be_computed_says_why(audit, doc, pump, tmp_path, until):
    label = audit.Label
    doc.saveAs(str(tmp_path / "gone.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    (tmp_path / "t2.ngc").unlink()
    again = FreeCAD.openDocument(str(tmp_path / "gone.FCStd"))
    try:
        audit = again.getObjectsByLabel(label)[0]
        picture = until(lambda: audit.ViewObject.Proxy.picture, 20000, "a picture")
        until(lambda: "t2.ngc" in (picture.failed or ""), 20000, "why there is none")
        until(lambda: _images(picture.nodes.groups["legend"]) == 1, 20000, "that in the view")
        assert "Touched" in audit.State
    finally:
        FreeCAD.closeDocument(again.Name)


def test_undo_takes_the_picture_away_and_redo_brings_it_back(doc, pump):
    attach.register()
    base = doc.addObject("Part::Box", "Box")
    doc.recompute()
    doc.openTransaction("path")
    path = app.create_toolpath(doc, base, passes="planes", machine="trunnion_ac", stepover=4.0)
    doc.commitTransaction()
    _settled(path, pump)
    doc.undo()
    pump(300)
    assert [one.Name for one in doc.Objects] == ["Box"]
    doc.redo()
    pump(300)
    path = doc.getObject("Toolpath")
    assert _settled(path, pump).drawing is not None


@pytest.fixture
def second(path, doc, pump):
    """Another path over the dome, whose making can be undone."""
    doc.openTransaction("second")
    result = app.create_toolpath(
        doc, doc.Dome, passes="planes", machine="trunnion_ac", stepover=8, linear_deflection=0.2
    )
    doc.commitTransaction()
    _settled(result, pump)
    return result


@pytest.fixture
def legend_of(doc, until):
    """legend_of(obj, why): the view comes to have one legend, that of this object."""

    def legends():
        drawn = [
            obj
            for obj in doc.Objects
            if obj.ViewObject.isVisible() and getattr(obj.ViewObject, "ShowLegend", False)
        ]
        return [obj.Label for obj in drawn if len(foremost.legend_of(obj).box)]

    def check(obj, why):
        until(lambda: legends() == [obj.Label], 20000, why)

    return check


def test_of_two_objects_that_is_shown_last_has_the_legend_and_that_selected_before_it(
    path, second, doc, legend_of, tmp_path, pump
):
    legend_of(second, "two are shown, one legend: that shown last")
    FreeCADGui.Selection.addSelection(path)
    legend_of(path, "that of the selected one")
    second.ViewObject.Visibility = False
    second.ViewObject.Visibility = True
    legend_of(path, "still that of the selected one")
    FreeCADGui.Selection.clearSelection()
    legend_of(second, "that shown last, as nothing is selected")
    markers = app.annotate(path)
    pump(300)
    FreeCADGui.Selection.addSelection(markers)
    legend_of(path, "markers stand for their path")
    FreeCADGui.Selection.clearSelection()
    legend_of(path, "that selected last")
    path.ViewObject.Visibility = False
    legend_of(second, "the next one that is shown")
    path.ViewObject.Visibility = True
    legend_of(path, "that shown last")
    path.ViewObject.ShowLegend = False
    legend_of(second, "that of the only one which is to have one")


def test_the_panel_of_a_path_shows_the_legend_of_that_path(path, second, legend_of, tree_row, until):
    """A row of the tree is selected by the mouse."""
    legend_of(second, "that shown last")
    tree_row(path.Label)
    legend_of(path, "that whose row was clicked")


@pytest.mark.usefixtures("whole_screen")
def test_a_legend_goes_with_its_object_and_comes_back_with_it(
    path, second, doc, pump, until, screenshot, pixels, view_box
):
    """Hidden itself, hidden with the part that holds it, deleted, brought back by undo: on the screen."""
    from freecad_fiveaxis.gui.scene.overlay import INK

    path.ViewObject.ShowLabel = second.ViewObject.ShowLabel = False
    second.Label = (
        "A path whose name is so long that its legend is wider than the other one, and is known by that alone"
    )
    pump(300)

    def width():
        """Pixels from the view's left edge to the end of the legend's head."""
        left, top, _, _ = view_box()
        shot = screenshot("legend")
        return max(
            (
                end
                for end in range(100, 900, 40)
                if pixels(shot, INK, 30, (left + end - 40, top + 12, 40, 26)) > 10
            ),
            default=0,
        )

    long = 600

    def shows(expected, why):
        until(
            lambda: (
                (width() > long) if expected is second else (0 < width() < long) if expected else not width()
            ),
            30000,
            why,
        )

    shows(second, "the legend of the second one")
    second.ViewObject.Visibility = False
    shows(path, "that of the first one")
    second.ViewObject.Visibility = True
    shows(second, "the second one's again")
    holder = doc.addObject("App::Part", "Holder")
    holder.addObject(second)
    holder.ViewObject.Visibility = False
    shows(path, "the first one's, as the second one's holder is hidden")
    holder.ViewObject.Visibility = True
    shows(second, "the second one's with its holder")
    path.ViewObject.Visibility = False
    doc.openTransaction("delete")
    doc.removeObject(second.Name)
    doc.commitTransaction()
    shows(None, "none")
    doc.undo()
    shows(second, "the second one's after undo")


def test_a_replaced_file_is_reported_the_same_everywhere_and_refresh_computes_it(
    audit, doc, pump, tmp_path, until
):
    marks = app.annotate(audit)
    picture = _settled(audit, pump)
    old = audit.WorstLine
    labels = until(
        lambda: marks.ViewObject.Proxy.picture and marks.ViewObject.Proxy.picture.labels, 20000, "the markers"
    )
    until(lambda: len(labels.places), 20000, "a label")
    (tmp_path / "t2.ngc").write_text(TABLE_2.replace("G90 G93\n", "G90 G93\n(another)\n(program)\n"))
    results.figures_of(audit)  # as Play and the list of findings ask for them
    audit.ViewObject.Proxy.look_again()
    until(lambda: picture.checked, 20000, "the change of the file noticed")
    assert (
        picture.figures is not audit.Proxy.last.figures
        and audit.WorstLine == old
        and "Touched" in audit.State
    )
    FreeCADGui.runCommand("Std_Refresh")
    until(
        lambda: picture.checked == "" and picture.figures is audit.Proxy.last.figures,
        20000,
        "the new program",
    )
    assert audit.WorstLine == old + 2 and "Touched" not in audit.State
    until(lambda: len(labels.places), 20000, "its label")


def test_a_file_that_was_replaced_while_the_document_was_closed_has_no_old_label(
    audit, doc, pump, tmp_path, until
):
    name = app.annotate(audit).Name
    doc.saveAs(str(tmp_path / "other.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    (tmp_path / "t2.ngc").write_text(TABLE_2.replace("G90 G93\n", "G90 G93\n(another)\n(program)\n"))
    again = FreeCAD.openDocument(str(tmp_path / "other.FCStd"))
    try:
        result, marks = again.getObject(audit_name(again)), again.getObject(name)
        picture = _settled(result, pump)
        until(lambda: picture.checked and "Touched" in result.State, 20000, "that it is old")
        labels = until(
            lambda: marks.ViewObject.Proxy.picture and marks.ViewObject.Proxy.picture.labels,
            20000,
            "the markers",
        )
        until(lambda: not len(labels.places), 20000, "no label of the old program")
        FreeCADGui.runCommand("Std_Refresh")
        until(lambda: picture.checked == "" and len(labels.places), 20000, "the label of the new one")
        assert result.WorstLine == int(picture.figures.program.line[picture.figures.worst[0]])
    finally:
        FreeCAD.closeDocument(again.Name)


def audit_name(doc):
    return next(one.Name for one in doc.Objects if one.Name.startswith("Audit"))
