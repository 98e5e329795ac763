# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is left, and where the tool enters the part: seen, clicked, undone, stopped, and drawn again after opening."""

import FreeCAD
import FreeCADGui
import numpy as np
import Part
import pytest
from conftest import QtCore, close_all
from test_clicks import look

from freecad_fiveaxis import app
from freecad_fiveaxis.app import left, results
from freecad_fiveaxis.core import report
from freecad_fiveaxis.gui import attach, findings_panel, messages
from freecad_fiveaxis.gui.scene import left_nodes, marks

ZERO = (5.0, 2.0, 3.0)
GROOVE = {"machine": "trunnion_ac", "cutter": "ball:10", "stepover": 1, "direction": 90, "tool_axis": "fixed", "tolerance": 0.02}


@pytest.fixture
def groove(doc):
    """A block of 48 x 16 mm whose top has a V groove of 90 deg along Y, 6 mm deep, its bottom at x = 0, z = 0."""
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
        made = app.create_toolpath(doc, (groove, up), **GROOVE, work_zero=ZERO, **settings)
        doc.clearUndos()
        look(doc)
        pump(1500)
        return made

    yield make
    findings_panel.forget(doc)


def drawn(obj):
    """The picture of a map."""
    return obj.ViewObject.Proxy.picture


def seen(pixels, picture, rgb, box, tolerance=14):
    return pixels(picture, [round(255 * part) for part in rgb], tolerance, box)


def test_the_map_is_seen_in_colours_and_undone_in_one_step(make_path, doc, press, tree_row, until, pump, screenshot, pixels,
                                                           view_box):  # fmt: skip
    path = make_path(gouge="report")
    names = [obj.Name for obj in doc.Objects]
    tree_row(path.Label)
    press("FiveAxis_Left", wait=1000)
    made = doc.LeftMap
    until(lambda: drawn(made) is not None and drawn(made).heights is not None, 20000, "the map")
    FreeCADGui.Selection.clearSelection()
    pump(800)
    shot, box = screenshot("left_map"), view_box()
    ramp = left_nodes.scale_ramp()
    assert seen(pixels, shot, ramp[len(ramp) // 2], box, 30) > 30000, "what is as it should be is not seen"
    red = sum(seen(pixels, shot, ramp[row], box, 12) for row in range(0, 60, 10))
    assert red > 1000, "what is cut too deep is not seen"
    assert made.LargestOvercut.Value > 1.0 and made.UpToDate
    assert not path.ViewObject.Visibility and path.ViewObject.Proxy.claimChildren()[-1] is made
    assert made.ViewObject.Proxy.getIcon().endswith("LeftMap.svg") and doc.UndoCount == 1
    assert tuple(drawn(made).origin.translation.getValue().getValue()) == pytest.approx(ZERO)
    doc.undo()
    pump(500)
    assert [obj.Name for obj in doc.Objects] == names and path.ViewObject.Visibility
    doc.redo()
    again = doc.LeftMap
    until(lambda: drawn(again) is not None and drawn(again).heights is not None, 20000, "the map after redo")
    until(lambda: drawn(again).warned == "", 3000, "a map that is no longer called old")
    assert again.UpToDate and again.Path is path


def test_what_stays_uncut_is_seen_in_blue(make_path, doc, press, until, pump, screenshot, pixels, view_box):
    make_path(gouge="lift", left="on")
    press("FiveAxis_Left", wait=1000)
    made = doc.LeftMap
    until(lambda: drawn(made) is not None and drawn(made).heights is not None, 20000, "the map")
    pump(800)
    shot, box = screenshot("left_uncut"), view_box()
    ramp = left_nodes.scale_ramp()
    blue = sum(seen(pixels, shot, ramp[-row], box, 12) for row in range(1, 60, 10))
    assert blue > 500, "what stays uncut is not seen"
    assert made.LargestUndercut.Value == pytest.approx(5.0 * (np.sqrt(2.0) - 1.0), rel=0.12)


def test_a_stopped_map_leaves_the_document_as_it_was(make_path, doc, press, monkeypatch, pump):
    from freecad_fiveaxis.gui import waiting

    path = make_path()
    names, begin = [obj.Name for obj in doc.Objects], waiting.Waiting.__call__

    def stopped(self, stage, fraction):
        QtCore.QTimer.singleShot(0, self.dialog.cancel)
        begin(self, stage, fraction)

    said = []
    monkeypatch.setattr(waiting.Waiting, "__call__", stopped)
    monkeypatch.setattr(messages, "status", said.append)
    press("FiveAxis_Left", wait=500)
    assert [obj.Name for obj in doc.Objects] == names and doc.UndoCount == 0
    assert path.ViewObject.Visibility and path.State == ["Up-to-date"]
    assert said == ["Stopped; the document is as it was."]


def test_a_reopened_map_is_drawn_again_and_says_when_it_is_old(
    make_path, doc, pump, until, tmp_path, screenshot, pixels, view_box
):
    made = app.left_map(make_path(gouge="report"))
    area = made.OvercutArea.Value
    file = str(tmp_path / "left.FCStd")
    doc.saveAs(file)
    FreeCAD.closeDocument(doc.Name)
    pump(300)
    again = FreeCAD.openDocument(file)
    try:
        made = again.LeftMap
        assert made.OvercutArea.Value == pytest.approx(area) and made.Proxy.last is None
        until(lambda: drawn(made) is not None and drawn(made).heights is not None, 20000, "the map")
        look(again)
        pump(500)
        assert drawn(made).warned == "" and left.out_of_date(made) == ""
        again.Toolpath.Stepover = 2
        pump(800)
        assert "recompute" in drawn(made).warned
        shot = screenshot("left_old")
        assert seen(pixels, shot, (1.0, 205 / 255, 70 / 255), view_box()) > 20, "the legend does not warn"
        again.recompute()
        pump(1500)
        assert drawn(made).warned == "" and drawn(made).heights is made.Proxy.last
    finally:
        close_all(again.Name)


def test_gouges_have_their_own_marks_labels_and_words(
    make_path, doc, pump, screenshot, pixels, view_box, view_click, click, until
):
    path = make_path(gouge="report")
    made = app.annotate(path)
    pump(800)
    at = list(made.Kinds).index("overcut")
    assert made.Depths[at] == pytest.approx(max(made.Depths)) and made.Depths[at] > 1.0
    doc.Groove.ViewObject.Visibility = True
    look(doc)
    pump(500)
    shot = screenshot("gouge_marks")
    assert seen(pixels, shot, marks.YELLOW, view_box()) > 60, "no mark of an overcut is seen"
    panel = findings_panel.show(path)
    pump(300)
    row = next(i for i, one in enumerate(panel.rows) if one.kind == "overcut")
    click(panel.table.viewport(), panel.table.visualItemRect(panel.table.item(row, 0)).center())
    pump(500)
    screenshot("gouge_finding")
    text = panel.text.toPlainText()
    for said in ("Cut too deep", "What happens", "too deep into the part", "Why", "What helps", "lifted"):
        assert said in text
    place = [a + b for a, b in zip(panel.rows[row].finding.place, ZERO, strict=True)]
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    x, y = view.getPointOnScreen(FreeCAD.Vector(*place))
    width, height = view.getSize()
    assert (x, y) == (pytest.approx(width / 2, abs=3), pytest.approx(height / 2, abs=3))
    panel.table.clearSelection()
    view_click(place)
    until(lambda: panel.table.selectionModel().selectedRows(), 3000, "a selected row")
    assert panel.table.selectionModel().selectedRows()[0].row() == row


@pytest.mark.parametrize("cure", ["report", "lift", "leave-out"])
def test_every_gouge_has_one_row_in_the_list_of_findings(cure, make_path):
    figures = results.figures_of(make_path(gouge=cure, left="on"))
    rows, of_marker = report.listed(figures)
    assert {row.finding for row in rows} >= set(figures.findings)
    assert len({(row.kind, row.finding.block, row.finding.place) for row in rows}) == len(rows), "a finding is listed twice"
    for mark, at in zip(report.markers(figures), of_marker, strict=True):
        assert rows[at].kind == mark.kind and rows[at].finding.block == mark.block
