# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a path is shown: what cuts is told from links and rapids, fewer passes where the part is small, and
the switches."""

from dataclasses import replace

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import pytest
from PySide import QtGui

try:
    from PySide import QtCore, QtWidgets
except ImportError:  # FreeCAD 0.20 keeps them here
    QtWidgets = QtGui

from freecad_fiveaxis import app
from freecad_fiveaxis.gui import attach, shown_parts

pytestmark = pytest.mark.usefixtures("kept")
SWITCHED = {
    "ShowCuts": "cuts",
    "ShowLinks": "links",
    "ShowRapids": "rapids",
    "ShowAxes": "axes",
    "ShowMarkers": "marks",
}


@pytest.fixture
def path(doc, until):
    """A toolpath over a low dome."""
    attach.register()
    base = doc.addObject("Part::Feature", "Dome")
    base.Shape = Part.makeSphere(60, FreeCAD.Vector(0, 0, -60)).common(
        Part.makeBox(40, 24, 20, FreeCAD.Vector(-20, -12, -16))
    )
    doc.recompute()
    result = app.create_toolpath(
        doc, base, passes="planes", machine="trunnion_ac", cutter="ball:10", stepover=1.0
    )
    until(lambda: drawn(result), 30000, "the path drawn")
    return result


def drawn(path):
    """The picture of a path, once it is drawn."""
    picture = path.ViewObject.Proxy.picture
    return picture if picture is not None and picture.drawing is not None and picture.styled else None


def shows(path, part):
    """Whether the nodes of a part are drawn."""
    return path.ViewObject.Proxy.picture.nodes.switches[SWITCHED[part]].whichChild.getValue() != -1


def strokes(node):
    """How many lines a node would draw."""
    from pivy import coin

    action = coin.SoGetPrimitiveCountAction()
    action.apply(node)
    return action.getLineCount()


def test_rapids_are_off_at_first_and_all_else_is_on(path):
    assert {part: shows(path, part) for part in SWITCHED} == {part: part != "ShowRapids" for part in SWITCHED}
    assert set(SWITCHED) == set(shown_parts.part_names())


@pytest.mark.parametrize("part", SWITCHED)
def test_each_part_has_a_switch_in_the_panel_and_in_the_menu(part, path, doc, field, click, until):
    from freecad_fiveaxis.gui.panels import toolpath

    toolpath.edit(path)
    before = shows(path, part)
    assert field(part).isChecked() == before
    box = field(part)
    click(
        box, QtCore.QPoint(8, box.height() // 2)
    )  # on the box itself: where the panel is wide its middle lies beside the words
    until(lambda: shows(path, part) != before, 20000, f"{part} switched in the panel")
    menu = QtWidgets.QMenu()
    path.ViewObject.Proxy.setupContextMenu(path.ViewObject, menu)
    entry = menu.findChild(QtWidgets.QMenu, "shown_parts").actions()[list(SWITCHED).index(part)]
    assert entry.isCheckable() and entry.isChecked() != before
    entry.trigger()
    until(lambda: shows(path, part) == before, 20000, f"{part} switched in the menu")


def test_the_switch_of_the_markers_is_that_of_the_markers_object_where_there_is_one(path, until):
    markers = app.annotate(path)
    assert shown_parts.is_shown(path, "ShowMarkers")
    shown_parts.show_part(path, "ShowMarkers", False)
    assert not markers.ViewObject.Visibility and not shown_parts.is_shown(path, "ShowMarkers")
    markers.Document.removeObject(markers.Name)
    assert shown_parts.is_shown(path, "ShowMarkers") and path.ViewObject.ShowMarkers


def test_where_markers_are_undone_and_redone_the_path_is_drawn_as_before(path, pump):
    """Undo keeps the object that it takes away, with a view that is gone."""
    doc = path.Document
    doc.openTransaction("Annotate")
    app.annotate(path)
    doc.commitTransaction()
    pump(300)
    for step in (doc.undo, doc.redo, doc.undo):
        step()
        drawn(path).refresh()
        pump(300)
        drawn(path).refresh()
    assert shown_parts.is_shown(path, "ShowMarkers")


@pytest.mark.parametrize("with_object", [False, True])
def test_label_and_curves_of_the_worst_blocks_go_with_the_markers_and_come_back(
    with_object, path, doc, field, click, until, screenshot
):
    from freecad_fiveaxis.gui.panels import toolpath

    markers = app.annotate(path) if with_object else None
    nodes = drawn(path).nodes
    assert strokes(nodes.groups["curves"]), "a worst block's curve, with white ends"

    def all_shown():
        curves, label = (nodes.switches[name].whichChild.getValue() != -1 for name in ("curves", "label"))
        return (curves, markers.ViewObject.Visibility if with_object else label)

    until(lambda: all_shown() == (True, True), 20000, "curves and label")
    toolpath.edit(path)
    box = field("ShowMarkers")
    for on in (False, True):
        click(box, QtCore.QPoint(8, box.height() // 2))
        until(lambda on=on: all_shown() == (on, on), 20000, f"curves and label {on}")
        screenshot(f"markers_{'on' if on else 'off'}{'_object' if with_object else ''}")
    if not with_object:
        path.ViewObject.ShowCurves = False
        until(lambda: all_shown() == (False, True), 20000, "the curves' own switch")


def test_a_new_path_has_no_switches_until_it_is_there(doc, field):
    from freecad_fiveaxis.gui.panels import toolpath

    base = doc.addObject("Part::Box", "Box")
    doc.recompute()
    panel = toolpath.create(base)
    assert not panel.shown_parts.isVisibleTo(panel.form)
    assert panel.calculate() and field("ShowRapids").isChecked() is False
    panel.reject()


def test_only_what_cuts_at_the_part_is_coloured_and_strong(path):
    picture = drawn(path)
    drawing, nodes = picture.drawing, picture.nodes
    assert 0 < drawing.cut.sum() < len(drawing.cut)
    assert strokes(nodes.groups["links"]) == (~drawing.cut).sum()
    assert sum(strokes(band) for band in nodes.cuts.bands) == drawing.cut.sum()
    assert nodes.cuts.style.lineWidth.getValue() == path.ViewObject.LineWidth == 2.0


@pytest.mark.parametrize("camera", ["Orthographic", "Perspective"])
def test_fewer_passes_are_drawn_where_the_part_is_small(camera, path, doc, pump, until, screenshot):
    """And all of them where the camera is near."""
    view, nodes = FreeCADGui.getDocument(doc.Name).ActiveView, drawn(path).nodes
    view.setCameraType(camera)
    view.viewTop()
    view.fitAll()
    eye, middle = (
        view.getCameraNode(),
        FreeCAD.Vector(*(0.5 * (drawn(path).drawing.low + drawn(path).drawing.high)).tolist()),
    )
    middle += path.WorkZero
    away = FreeCAD.Vector(*eye.position.getValue().getValue()) - middle
    height = eye.height.getValue() if camera == "Orthographic" else None
    left = {}
    for times in (0.1, 1.0, 4.0, 16.0):
        if height:
            eye.height = times * height
        else:
            eye.position.setValue(*(middle + away * times))
        nodes.cuts.coat = -1
        until(lambda: view.redraw() or nodes.cuts.coat >= 0, 20000, "a frame")
        pump(100)
        shown = [
            band
            for band, switch in zip(nodes.cuts.bands, nodes.cuts.switches, strict=True)
            if switch.whichChild.getValue() != -1
        ]
        left[times] = sum(strokes(band) for band in shown)
    view.setCameraType("Orthographic")
    assert left[0.1] == drawn(path).drawing.cut.sum()
    assert (np.diff(list(left.values())) <= 0).all() and 0 < left[16.0] < 0.5 * left[0.1], left


def test_the_legend_names_the_kinds_of_moves_that_are_shown(path):
    from freecad_fiveaxis.gui.scene import words

    picture = drawn(path)

    def texts(shown):
        legend = words.legend_of("Path", picture.figures, picture._look(), "", (), shown)
        return [text.split(",")[0].split(" ")[0] for _, text in legend.keys]

    assert picture._list_shown() == ["cuts", "links"]
    assert texts(picture._list_shown())[:2] == ["cut", "link"] and "rapid" not in texts(picture._list_shown())
    path.ViewObject.ShowRapids = True
    assert texts(picture._list_shown())[:3] == ["cut", "link", "rapid"]


def test_the_legend_ends_at_the_tolerance_or_at_the_largest_deviation(path):
    from freecad_fiveaxis.gui.scene import words
    from freecad_fiveaxis.gui.scene.units import length_text

    picture = drawn(path)
    largest = picture.figures.judged.segment[picture.figures.feeds].max()

    def legend(tolerance):
        return words.legend_of("Path", replace(picture.figures, tolerance=tolerance), picture._look(), "")

    calm, both = legend(10.0 * largest), legend(0.1 * largest)
    assert calm.marks[-1] == (1.0, length_text(10.0 * largest)) and calm.halves == ("within tolerance", "")
    assert len(calm.ramp) == len(both.ramp) / 2 and (calm.ramp == both.ramp[: len(calm.ramp)]).all(), (
        "no colour of what is over"
    )
    assert both.marks[-1] == (1.0, length_text(largest)) and both.halves[1] == "over tolerance"
    assert [text for level, text in both.marks if level == 0.5] == [length_text(0.1 * largest)]


def test_the_legend_folds_to_a_line_by_the_menu_and_unfolds(path, until, screenshot):
    size, view = drawn(path).legend.size, path.ViewObject

    def entry():
        menu.clear()
        view.Proxy.setupContextMenu(view, menu)
        return next(one for one in menu.actions() if one.objectName() == "FoldLegend")

    menu = QtWidgets.QMenu()
    assert not entry().isChecked()
    entry().trigger()
    until(lambda: 0 < drawn(path).legend.size[1] < 50, 20000, "one line")
    until(lambda: len(drawn(path).legend.box), 20000, "that line in the view")
    screenshot("legend_folded")
    assert view.FoldLegend and entry().isChecked() and drawn(path) is not None, "nothing else is drawn anew"
    entry().trigger()
    until(lambda: drawn(path).legend.size == size, 20000, "the whole legend")


def test_a_folded_legend_still_warns():
    from freecad_fiveaxis.gui.scene import overlay, words

    folded = words.empty_legend("Path", "The path is out of date").fold()
    assert folded.title == "Path: The path is out of date" and folded.ink == overlay.WARN
    assert overlay.legend_picture(folded).height() < 50
    long = words.empty_legend("Path", 40 * "words ").fold()
    assert len(long.title) <= overlay.FOLDED_WIDTH + 1 and long.title.endswith("…")


def test_a_document_of_an_earlier_version_shows_what_it_showed(path, doc, until, tmp_path, anew):
    """Rapids were on, and there was no property for cuts and links."""
    view, label = path.ViewObject, path.Label
    view.ShowRapids = True
    for name in ("ShowCuts", "ShowLinks", "FoldLegend"):
        assert view.removeProperty(name)
    doc.saveAs(str(tmp_path / "earlier.FCStd"))
    FreeCAD.closeDocument(doc.Name)
    anew()
    again = FreeCAD.openDocument(str(tmp_path / "earlier.FCStd"))
    try:
        opened = again.getObjectsByLabel(label)[0]
        until(lambda: drawn(opened), 30000, "the path drawn again")
        assert opened.ViewObject.ShowRapids and opened.ViewObject.ShowCuts and opened.ViewObject.ShowLinks
        assert all(shows(opened, part) for part in SWITCHED)
    finally:
        FreeCAD.closeDocument(again.Name)
