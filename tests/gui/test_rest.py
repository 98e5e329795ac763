# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rest material, and where the tool enters the part: seen, clicked, undone, stopped, and drawn again after
opening."""

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import pytest
from conftest import QtCore, close_all
from test_clicks import look

from freecad_fiveaxis import app
from freecad_fiveaxis.app import rest, results
from freecad_fiveaxis.core import report
from freecad_fiveaxis.gui import attach, findings_panel, messages
from freecad_fiveaxis.gui.scene import marks, rest_nodes

ZERO = (5.0, 2.0, 3.0)
GROOVE = {
    "machine": "trunnion_ac",
    "cutter": "ball:10",
    "stepover": 1,
    "direction": 90,
    "tool_axis": "fixed",
    "tolerance": 0.02,
}

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def groove(doc):
    """A block of 48 x 16 mm whose top has a V groove of 90 deg along Y, 6 mm deep, its bottom at x = 0, z =
    0."""
    attach.register()
    profile = [(-24, 6), (-6, 6), (0, 0), (6, 6), (24, 6), (24, -8), (-24, -8), (-24, 6)]
    obj = doc.addObject("Part::Feature", "Groove")
    obj.Shape = Part.Face(Part.makePolygon([(x, 0, z) for x, z in profile])).extrude(FreeCAD.Vector(0, 16, 0))
    doc.recompute()
    return obj


@pytest.fixture
def make_path(groove, doc, pump):
    """make_path(**settings): a path over the groove's top, drawn."""

    def make(**settings):
        up = [f"Face{at}" for at, face in enumerate(groove.Shape.Faces, 1) if face.normalAt(0, 0).z > 0.5]
        result = app.create_toolpath(doc, (groove, up), **GROOVE, work_zero=ZERO, **settings)
        doc.clearUndos()
        look(doc)
        pump(1500)
        return result

    yield make
    findings_panel.forget(doc)


def drawn(obj):
    """The picture of a map."""
    return obj.ViewObject.Proxy.picture


def in_the_middle(view, place):
    """Whether that place of the document is drawn there."""
    x, y = view.getPointOnScreen(FreeCAD.Vector(*place))
    width, height = view.getSize()
    return (x, y) == (pytest.approx(width / 2, abs=3), pytest.approx(height / 2, abs=3))


def seen(pixels, picture, rgb, box, tolerance=14):
    return pixels(picture, [round(255 * part) for part in rgb], tolerance, box)


@pytest.mark.usefixtures("whole_screen")
def test_the_map_is_seen_in_colours_and_undone_in_one_step(make_path, doc, press, tree_row, until, pump, screenshot, pixels,
                                                           view_box):  # fmt: skip
    path = make_path(gouge="report")
    names = [obj.Name for obj in doc.Objects]
    tree_row(path.Label)
    press("FiveAxis_Left", wait=1000)
    result = until(lambda: doc.getObject("LeftMap"), 60000, "a map")
    until(lambda: drawn(result) is not None and drawn(result).heights is not None, 20000, "the map")
    FreeCADGui.Selection.clearSelection()
    ramp = rest_nodes.scale_ramp()

    def red():
        shot = screenshot("rest_map")
        return sum(seen(pixels, shot, ramp[row], view_box(), 12) for row in range(0, 60, 10))

    as_it_should_be = ramp[len(ramp) // 2]
    until(
        lambda: seen(pixels, screenshot("rest_map"), as_it_should_be, view_box(), 30) > 30000,
        30000,
        "what is as it should be",
    )
    until(lambda: red() > 1000, 30000, "what is cut too deep")
    assert result.LargestOvercut.Value > 1.0 and result.UpToDate
    assert not path.ViewObject.Visibility and path.ViewObject.Proxy.claimChildren()[-1] is result
    assert result.ViewObject.Proxy.getIcon().endswith("RestMap.svg") and doc.UndoCount == 1
    view = type(result.ViewObject.Proxy)
    assert f"{view.__module__}.{view.__name__}" == "freecad_fiveaxis.gui.left_view.LeftMapView"
    assert tuple(drawn(result).origin.translation.getValue().getValue()) == pytest.approx(ZERO)
    doc.undo()
    until(lambda: [obj.Name for obj in doc.Objects] == names and path.ViewObject.Visibility, 20000, "undone")
    pump(500)
    doc.redo()
    again = doc.LeftMap
    until(lambda: drawn(again) is not None and drawn(again).heights is not None, 20000, "the map after redo")
    until(lambda: drawn(again).warned == "", 20000, "a map that is no longer called old")
    assert again.UpToDate and again.Path is path


def test_what_stays_uncut_is_seen_in_blue(make_path, doc, press, until, pump, screenshot, pixels, view_box):
    make_path(gouge="lift", rest="on")
    press("FiveAxis_Left", wait=1000)
    result = until(lambda: doc.getObject("LeftMap"), 60000, "a map")
    until(lambda: drawn(result) is not None and drawn(result).heights is not None, 20000, "the map")
    ramp = rest_nodes.scale_ramp()

    def blue():
        shot = screenshot("rest_uncut")
        return sum(seen(pixels, shot, ramp[-row], view_box(), 12) for row in range(1, 60, 10))

    until(lambda: blue() > 500, 30000, "what stays uncut")
    assert result.LargestUndercut.Value == pytest.approx(5.0 * (np.sqrt(2.0) - 1.0), rel=0.12)


def test_a_stopped_map_leaves_the_document_as_it_was(anew, make_path, doc, press, monkeypatch, pump, until):
    from freecad_fiveaxis.gui import waiting

    path = make_path()
    names, begin = [obj.Name for obj in doc.Objects], waiting.Waiting.__call__

    def stopped(self, stage, fraction):
        QtCore.QTimer.singleShot(0, self.dialog.cancel)
        begin(self, stage, fraction)

    message = []
    monkeypatch.setattr(waiting.Waiting, "__call__", stopped)
    monkeypatch.setattr(messages, "status", message.append)
    press("FiveAxis_Left", wait=500)
    until(lambda: message, 20000, "that it was stopped")
    assert [obj.Name for obj in doc.Objects] == names and doc.UndoCount == 0
    assert path.ViewObject.Visibility and path.State == ["Up-to-date"]
    assert message == ["Stopped; the document is as it was."]


def test_a_reopened_map_is_drawn_again_and_says_when_it_is_old(
    make_path, doc, pump, until, tmp_path, screenshot, pixels, view_box
):
    result = app.left_map(make_path(gouge="report"))
    area = result.OvercutArea.Value
    file = str(tmp_path / "rest.FCStd")
    doc.saveAs(file)
    FreeCAD.closeDocument(doc.Name)
    pump(300)
    again = FreeCAD.openDocument(file)
    try:
        result = again.LeftMap
        assert result.OvercutArea.Value == pytest.approx(area) and result.Proxy.last is None
        until(lambda: drawn(result) is not None and drawn(result).heights is not None, 20000, "the map")
        look(again)
        pump(500)
        until(
            lambda: drawn(result).warned == "" and rest.out_of_date(result) == "",
            20000,
            "a map that is not old",
        )
        again.Toolpath.Stepover = 2
        until(lambda: "recompute" in drawn(result).warned, 20000, "a map that is old")
        warning = (1.0, 205 / 255, 70 / 255)
        until(
            lambda: seen(pixels, screenshot("rest_old"), warning, view_box()) > 20,
            30000,
            "the legend's warning",
        )
        again.recompute()
        until(
            lambda: drawn(result).warned == "" and drawn(result).heights is result.Proxy.last,
            20000,
            "the new map",
        )
    finally:
        close_all(again.Name)


def test_gouges_have_their_own_marks_labels_and_words(
    make_path, doc, pump, screenshot, pixels, view_box, view_click, click, until
):
    path = make_path(gouge="report")
    result = app.annotate(path)
    pump(800)
    at = list(result.Kinds).index("overcut")
    assert result.Depths[at] == pytest.approx(max(result.Depths)) and result.Depths[at] > 1.0
    doc.Groove.ViewObject.Visibility = True
    look(doc)
    until(
        lambda: seen(pixels, screenshot("gouge_marks"), marks.YELLOW, view_box()) > 60,
        30000,
        "a mark of an overcut",
    )
    panel = findings_panel.show(path)
    pump(300)
    row = next(i for i, one in enumerate(panel.rows) if one.kind == "overcut")
    click(panel.table.viewport(), panel.table.visualItemRect(panel.table.item(row, 0)).center())
    for message in ("Cut too deep", "What happens", "too deep into the part", "Why", "What helps", "lifted"):
        until(lambda: message in panel.text.toPlainText(), 20000, f"{message!r}")  # noqa: B023
    screenshot("gouge_finding")
    place = [a + b for a, b in zip(panel.rows[row].finding.place, ZERO, strict=True)]
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    until(lambda: in_the_middle(view, place), 20000, "the overcut in the middle of the view")
    panel.table.clearSelection()
    view_click(place)
    until(lambda: panel.table.selectionModel().selectedRows(), 20000, "a selected row")
    assert panel.table.selectionModel().selectedRows()[0].row() == row


@pytest.mark.parametrize("cure", ["report", "lift", "leave-out"])
def test_every_gouge_has_one_row_in_the_list_of_findings(cure, make_path):
    figures = results.figures_of(make_path(gouge=cure, rest="on"))
    rows, of_marker = report.list_findings(figures)
    assert {row.finding for row in rows} >= set(figures.findings)
    assert len({(row.kind, row.finding.block, row.finding.place) for row in rows}) == len(rows), (
        "a finding is listed twice"
    )
    for mark, at in zip(report.markers(figures), of_marker, strict=True):
        assert rows[at].kind == mark.kind and rows[at].finding.block == mark.block
