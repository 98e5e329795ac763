# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare machines: ticked and pressed, read from the table, sorted by a click, saved where the user says."""

import json
import math

import FreeCAD
import FreeCADGui
import pytest
from conftest import QtCore, QtWidgets
from test_clicks import look

from freecad_fiveaxis import app
from freecad_fiveaxis.app import comparing

COLUMNS = {
    "machine": 0,
    "cure": 1,
    "guided": 2,
    "deviation": 3,
    "blocks": 5,
    "time": 6,
    "linear": 7,
    "first": 8,
}

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def path(doc, pump):
    """A coarse path over a half ball of 20 mm."""
    ball = doc.addObject("Part::Sphere", "Dome")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    look(doc)
    toolpath = app.create_toolpath(
        doc, ball, passes="planes", machine="trunnion_ac", stepover=8, linear_deflection=0.1
    )
    pump(500)
    return toolpath


def tick(until, box, click, *values):
    """Tick these lines of a list by the mouse, and no others."""
    for at in range(box.count()):
        line = box.item(at)
        if (line.checkState() == QtCore.Qt.Checked) != (line.data(QtCore.Qt.UserRole) in values):
            box.scrollToItem(line)
            spot = box.visualItemRect(line)
            click(box.viewport(), QtCore.QPoint(spot.left() + 10, spot.center().y()))
        wanted = line.data(QtCore.Qt.UserRole) in values
        until(
            lambda: (line.checkState() == QtCore.Qt.Checked) == wanted,  # noqa: B023
            10000,
            f"{line.text()} ticked: {wanted}",
        )


def field_text(window, name):
    return window.findChild(QtWidgets.QLabel, name).text()


def rows_of(table):
    read = []
    for row in range(table.rowCount()):
        read.append([table.item(row, column) for column in range(table.columnCount())])
    return read


def test_the_table_says_what_the_core_says_and_is_sorted_by_a_click(path, doc, tree_row, press, field, click, until, window,
                                                                    panel_button, screenshot, pump):  # fmt: skip
    names = [obj.Name for obj in doc.Objects]
    tree_row(path.Label)
    press("FiveAxis_Compare")
    tick(until, field("machines"), click, "trunnion_ac", "trunnion_bc", "head_b_table_c")
    tick(until, field("cures"), click, "none", "linearize")
    click(field("calculate"))
    until(
        lambda: "give the tool length" in field("compare_error").text(),
        20000,
        "that one of them has a head that turns",
    )
    tick(until, field("machines"), click, "trunnion_ac", "trunnion_bc")
    click(field("calculate"))
    until(lambda: not field_text(window, "compare_error"), 20000, "nothing wrong")
    table = until(
        lambda: window.findChild(QtWidgets.QTableWidget, "FiveAxisComparisonTable"), 60000, "a table"
    )
    pump(300)
    screenshot("compare")
    expected = comparing.compare(path, ["trunnion_ac", "trunnion_bc"], ["none", "linearize"]).rows
    shown = rows_of(table)
    assert len(shown) == len(expected) == 8
    for cells, row in zip(shown, expected, strict=True):
        number = {name: cells[at].data(QtCore.Qt.UserRole) for name, at in COLUMNS.items()}
        assert cells[0].text() == row.machine
        assert (
            number["deviation"] == row.deviation
            and number["blocks"] == row.blocks
            and number["time"] == row.time
        )
        assert number["linear"] == max(row.peak_rate[:3]) and number["first"] == row.peak_rate[3]
        assert f"{math.degrees(row.peak_rate[3]):.0f}°" in cells[COLUMNS["first"]].text()
    (same,) = [
        row
        for row in expected
        if (row.machine, row.cure, row.tool_centre) == ("trunnion_ac", "linearize", False)
    ]
    assert same.deviation == pytest.approx(path.MaxSurfaceDeviation.Value, abs=1e-12), (
        "the path as it is, its blocks divided"
    )
    head = table.horizontalHeader()
    spot = QtCore.QPoint(head.sectionViewportPosition(COLUMNS["blocks"]) + 15, head.height() // 2)
    click(head.viewport(), spot)

    def is_sorted():
        blocks = [int(cells[COLUMNS["blocks"]].text()) for cells in rows_of(table)]
        return blocks == sorted(blocks) and len(set(blocks)) > 1

    until(is_sorted, 20000, "the rows by their blocks")
    panel_button("Close")
    assert [obj.Name for obj in doc.Objects] == names and table.isVisible()


def test_nothing_ticked_and_a_stop_leave_no_table_and_esc_closes(path, tree_row, press, field, click, until, real_key, monkeypatch, pump,
                                                                 window):  # fmt: skip
    from freecad_fiveaxis.core.base.errors import Cancelled
    from freecad_fiveaxis.gui import waiting

    tree_row(path.Label)
    press("FiveAxis_Compare")
    tick(until, field("cures"), click)
    click(field("calculate"))
    until(lambda: "Tick at least one" in field("compare_error").text(), 20000, "what is missing")
    tick(until, field("cures"), click, "none")

    def stop(self, stage, fraction):
        raise Cancelled("stopped by the user")

    monkeypatch.setattr(waiting.Waiting, "__call__", stop)
    click(field("calculate"))
    until(lambda: "Stopped" in window.statusBar().currentMessage(), 20000, "that it was stopped")
    assert not field_text(window, "compare_error")
    pump(300)
    real_key(window, "Escape")
    until(lambda: not FreeCADGui.Control.activeDialog(), 20000, "Esc to close the panel")


def test_the_table_is_saved_where_the_user_says_and_replaces_nothing_unasked(
    path, monkeypatch, modal, tmp_path
):
    from freecad_fiveaxis.gui import comparison_table
    from freecad_fiveaxis.gui.panels import setup

    shown = comparison_table.show(path, comparing.compare(path, ["trunnion_ac"], ["none"]))
    file = tmp_path / "table.json"
    monkeypatch.setattr(setup, "ask_file", lambda *_: str(file))
    shown.save()
    assert len(json.loads(file.read_text(encoding="utf-8"))["rows"]) == 2
    file.write_text("mine")
    met = modal("Cancel")
    shown.save()
    assert met.texts and file.read_text() == "mine"
    file = tmp_path / "table.html"
    shown.save()
    assert "trunnion_ac" in file.read_text(encoding="utf-8")
    file = tmp_path / "table.png"
    shown.save()
    assert "endings" in shown.error.text() and not file.exists()
    shown.dock.close()


def test_the_table_closes_with_its_document_and_with_no_other(path, doc, until):
    from freecad_fiveaxis.gui import comparison_table

    shown = comparison_table.show(path, comparing.compare(path, ["trunnion_ac"], ["none"]))
    until(shown.dock.isVisible, 20000, "the table")
    FreeCAD.closeDocument(FreeCAD.newDocument().Name)
    assert shown.dock.isVisible() and shown.table.rowCount() == 2
    FreeCAD.closeDocument(doc.Name)
    until(lambda: not shown.dock.isVisible(), 20000, "no table of a document that is closed")
    assert shown.table.rowCount() == 0


def test_without_a_toolpath_the_command_is_disabled(doc, tool_button, until):
    doc.addObject("Part::Box", "Box")
    doc.recompute()
    until(lambda: tool_button("FiveAxis_Setup").isEnabled(), 20000, "Setup enabled")
    assert not tool_button("FiveAxis_Compare").isEnabled()


def test_fixtures_of_the_path_are_ticked_and_what_is_ticked_stands_in_the_table_alone(path, doc, tree_row, press, field, click, until,
                                                                                      window, panel_button, screenshot):  # fmt: skip
    """A post over the dome, half a mm above its top: the path has it as a fixture, and is not lifted out of it.
    Untick it, and the table says nothing of fixtures; the path keeps it."""
    post = doc.addObject("Part::Box", "Post")
    post.Length, post.Width, post.Height = 10, 10, 40
    post.Placement.Base = FreeCAD.Vector(-5, -5, 20.5)
    path.Fixtures, path.Gouge = [post], "off"
    doc.recompute()
    before = path.Fingerprint
    tree_row(path.Label)
    press("FiveAxis_Compare")
    editor = field("fixtures")
    assert [editor.item(at).text() for at in range(editor.count())] == ["Post"]
    assert editor.item(0).checkState() == QtCore.Qt.Checked
    tick(until, field("cures"), click, "none")
    click(field("calculate"))
    table = until(
        lambda: window.findChild(QtWidgets.QTableWidget, "FiveAxisComparisonTable"), 60000, "a table"
    )
    last = table.columnCount() - 1
    until(lambda: table.rowCount() == 2 and not table.isColumnHidden(last), 60000, "a column of fixtures")
    expected = comparing.compare(path, ["trunnion_ac"], ["none"]).rows
    for row, core in enumerate(expected):
        text = table.item(row, last).text()
        assert "in Post" in text and "Post" in core.fixtures[0].text, "as the core says"
    screenshot("compare_fixtures")
    tick(until, editor, click)
    click(field("calculate"))
    until(lambda: table.isColumnHidden(last), 60000, "no column of fixtures")
    panel_button("Close")
    assert path.Fixtures == [post] and path.Fingerprint == before


def test_the_table_says_what_goes_into_the_part_and_what_nobody_has_looked_at(path, doc):
    from freecad_fiveaxis.gui import comparison_table

    shown = comparison_table.show(path, comparing.compare(path, ["trunnion_ac"], ["linearize"]))
    part = comparison_table.heads().index("Part")
    assert [shown.table.item(row, part).text() for row in range(2)] == ["free", "free"]
    assert "checked" not in shown.verdict.text()
    path.Gouge = "off"
    doc.recompute()
    shown = comparison_table.show(path, comparing.compare(path, ["trunnion_ac"], ["linearize"]))
    assert [shown.table.item(row, part).text() for row in range(2)] == ["not checked", "not checked"]
    assert "In 2 of 2 ways it is not checked" in shown.verdict.text()
    shown.dock.close()
