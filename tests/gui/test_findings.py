# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of findings: what it says in plain words, and how it and the 3D view lead to each other."""

import FreeCAD
import FreeCADGui
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results
from freecad_fiveaxis.core import report
from freecad_fiveaxis.gui import attach, findings_panel

TABLE_2 = (
    "G90 G93\nG1 X-90.9595 Y7.3103 Z227.6341 A1.0664 C148.9685 F60\nG1 X-82.0656 Y-34.8175 Z228.3975 A1.1793 C121.5477 F60\n"
    "G1 X-72.0656 Y-34.8175 Z228.3975 A1.1793 C121.5477 F60\nM2\n"
)


@pytest.fixture
def audit(doc, pump, tmp_path):
    """The audit of So et al.'s Table 2, and a straight block after it."""
    attach.register()
    (tmp_path / "t2.ngc").write_text(TABLE_2)
    result = app.audit(doc, str(tmp_path / "t2.ngc"), "mikron_ucp710", work_zero=(10.0, 20.0, 30.0))
    pump(600)
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    view.viewIsometric()
    view.fitAll()
    pump(300)
    yield result
    findings_panel.forget(doc)


def test_a_marker_that_is_clicked_tells_its_finding(audit, view_click, pump, screenshot, until):
    markers = app.annotate(audit)
    pump(500)
    view_click(markers.Places[0])
    panel = until(lambda: findings_panel._docks.get("panel"), 20000, "a list of findings")
    until(lambda: panel.path is audit and panel.dock.isVisible(), 20000, "the list of the audit's findings")
    until(lambda: "NC line 3" in panel.text.toPlainText(), 20000, "what is found there")
    screenshot("finding-picked")
    text = panel.text.toPlainText()
    for word in ("What happens", "Why", "What helps"):
        assert word in text
    assert "2.126 mm" in text and "27.42" in text
    assert "Largest deviation" in text, "the largest deviation goes before what else stands there"
    until(lambda: panel.table.selectionModel().selectedRows(), 20000, "its row selected")


def test_a_marker_of_the_path_itself_can_be_clicked_too(audit, view_click, pump, until):
    place = [
        a + b
        for a, b in zip(report.markers(results.figures_of(audit))[0].place, (10.0, 20.0, 30.0), strict=True)
    ]
    view_click(place)
    panel = until(lambda: findings_panel._docks.get("panel"), 20000, "a list of findings")
    until(lambda: panel.path is audit, 20000, "the list of the audit's findings")
    until(lambda: "NC line 3" in panel.text.toPlainText(), 20000, "what is found there")


def test_a_row_that_is_picked_moves_the_view_there(audit, doc, pump, click, screenshot, until):
    panel = findings_panel.show(audit)
    pump(300)
    at = next(i for i, row in enumerate(panel.rows) if row.finding.place is not None)
    view = FreeCADGui.getDocument(doc.Name).ActiveView
    view.getCameraNode().position.setValue(500.0, 500.0, 500.0)
    click(panel.table.viewport(), panel.table.visualItemRect(panel.table.item(at, 0)).center())
    place = [a + b for a, b in zip(panel.rows[at].finding.place, (10.0, 20.0, 30.0), strict=True)]

    def in_the_middle():
        x, y = view.getPointOnScreen(FreeCAD.Vector(*place))
        width, height = view.getSize()
        return (x, y) == (pytest.approx(width / 2, abs=3), pytest.approx(height / 2, abs=3))

    until(in_the_middle, 20000, "the finding in the middle of the view")
    screenshot("finding-row")


def test_every_finding_and_every_marker_has_a_row(audit):
    figures = results.figures_of(audit)
    rows, of_marker = report.list_findings(figures)
    assert {row.finding for row in rows} >= set(figures.findings)
    for mark, at in zip(report.markers(figures), of_marker, strict=True):
        assert rows[at].finding.block == mark.block and rows[at].kind == mark.kind
    assert [row.finding.severity for row in rows] == sorted(
        (row.finding.severity for row in rows), reverse=True
    )
    panel = findings_panel.show(audit)
    assert panel.table.rowCount() == len(rows)


def test_every_row_tells_something_in_words(audit, pump):
    panel = findings_panel.show(audit)
    for at in range(panel.table.rowCount()):
        panel.table.selectRow(at)
        assert len(panel.text.toPlainText()) > 40
        assert "{" not in panel.text.toPlainText()


def test_the_list_follows_a_recompute_and_goes_with_its_document(audit, doc, pump, until):
    panel = findings_panel.show(audit)
    assert panel.table.rowCount() > 1
    audit.Tolerance = 5.0
    doc.recompute()
    until(
        lambda: "deviation-over-tolerance" not in [row.kind for row in panel.rows],
        20000,
        "the list of the new result",
    )
    doc.removeObject(audit.Name)
    until(lambda: panel.path is None and not panel.dock.isVisible(), 20000, "the list gone")


def test_where_the_tool_enters_the_part_is_listed_with_its_place(doc, pump, screenshot, until):
    attach.register()
    ball = doc.addObject("Part::Sphere", "Dome")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    given = {
        "machine": "trunnion_ac",
        "cutter": "bull:6:1.5:6",
        "lead": 60,
        "passes": "planes",
        "stepover": 12,
        "linear_deflection": 0.3,
    }
    path = app.create_toolpath(doc, ball, **given, holder="100x25", gouge="report")
    findings_panel.show(path)
    panel = findings_panel._docks["panel"]
    until(
        lambda: {"overcut", "holder-collision"} <= {row.finding.code for row in panel.rows},
        20000,
        "both findings",
    )
    codes = [row.finding.code for row in panel.rows]
    at = codes.index("holder-collision")
    cells = [panel.table.item(at, column).text() for column in range(panel.table.columnCount())]
    assert cells[1] == str(panel.rows[at].finding.line) and cells[2].endswith("mm") and all(cells)
    panel.table.selectRow(at)
    until(lambda: "holder" in panel.text.toPlainText().lower(), 20000, "what is found there")
    screenshot("findings-gouge")
    findings_panel.forget(doc)
