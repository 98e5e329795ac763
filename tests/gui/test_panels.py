# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels, used as a user uses them: fields typed into, buttons clicked, what stands on the screen
read."""

import gc
import json
from pathlib import Path
from types import SimpleNamespace

import FreeCAD
import FreeCADGui
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results, tool_bit
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.gui import qt, waiting
from freecad_fiveaxis.gui.panels import audit, post, summary, toolpath
from freecad_fiveaxis.gui.qt import QtCore, QtGui, QtWidgets

pytestmark = pytest.mark.usefixtures("kept")
OPTIONS = {"cutter": "ball:6:30", "stepover": 4.0, "linear_deflection": 0.3, "angular_deflection": 30.0, "tool_axis": "facet_mean"}  # fmt: skip
"""A coarse path with the axis of the facets: what the tests are about hangs neither on its length nor on its
axes."""


@pytest.fixture
def dome(doc):
    """The upper half of a ball, 20 mm, standing on the ground; shown in the view."""
    part = doc.addObject("Part::Sphere", "Dome")
    part.Radius, part.Angle1 = 20, 0
    doc.recompute()
    FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
    FreeCADGui.ActiveDocument.ActiveView.fitAll()
    doc.clearUndos()
    return part


@pytest.fixture
def millimetres(doc):
    """A schema that shows lengths in mm and feeds in mm/min; the user's own comes back afterwards."""
    yield from _schema(6)


@pytest.fixture
def inches(doc):
    """Lengths in decimal inches, feeds in inches a minute."""
    yield from _schema(3)


def _schema(number):  # after the document: from FreeCAD 1.1 on each document brings its own
    before = FreeCAD.Units.getSchema()
    FreeCAD.Units.setSchema(number)
    yield
    FreeCAD.Units.setSchema(before)


@pytest.fixture
def panel(dome, pump, until):
    """The panel of a new, coarse path over the dome, in sight: where the panel of the test before has just
    been closed, FreeCAD may show the tree afterwards."""
    opened = toolpath.create(dome)
    opened.options.show_options(OPTIONS)
    pump(300)

    def in_sight():
        if not opened.form.isVisible():
            FreeCADGui.Control.showTaskView()
        return opened.form.isVisible()

    until(in_sight, 20000, "the panel in sight")
    return opened


def shown(name):
    """The widget of that name in the open panel: the last one that lies in what is seen, for the form of an
    earlier panel may not be gone yet, and come before or behind it."""
    found = FreeCADGui.getMainWindow().findChildren(QtWidgets.QWidget, name)
    assert found, name
    return max(reversed(found), key=lambda one: sum(part.isVisible() for part in around(one)))


def around(widget):
    """The widgets that hold it, the nearest first."""
    while (widget := widget.parentWidget()) is not None:
        yield widget


def names(doc):
    return sorted(obj.Name for obj in doc.Objects)


def test_calculate_shows_the_summary_and_ok_makes_one_step_of_undo(
    panel, doc, click, pump, panel_button, screenshot, until, panel_closed, anew
):
    click_calculate(panel, click, pump)
    until(lambda: "<b>" in shown("summary").text(), 60000, "a summary")
    path = doc.getObject("Toolpath")
    text = shown("summary").text()
    assert path.Blocks > 100 and f"<b>{path.Blocks}</b>" in text and f"<b>{path.Passes}</b>" in text
    assert f"<b>{path.SingularBlocks}</b>" in text and f"<b>{path.OverTolerance}</b>" in text
    screenshot("panel_calculated")
    panel_button("OK")
    panel_closed()
    assert names(doc) == ["Dome", "Tessellation", "Toolpath"] and doc.UndoCount == 1
    doc.undo()
    assert names(doc) == ["Dome"]
    doc.redo()
    assert names(doc) == ["Dome", "Tessellation", "Toolpath"] and doc.Toolpath.Blocks == path.Blocks


def click_calculate(panel, click, pump):
    button = shown("calculate")
    area = button.parentWidget()
    while not isinstance(area, QtWidgets.QScrollArea):
        area = area.parentWidget()
    area.ensureWidgetVisible(button)
    pump(100)
    click(button)
    pump(200)


def test_ok_calculates_what_was_not_calculated(panel, doc, panel_button, panel_closed):
    panel_button("OK")
    panel_closed()
    assert (
        doc.Toolpath.Blocks > 100
        and doc.Toolpath.CutterDiameter.Value == 6.0
        and doc.Toolpath.Stepover.Value == 4.0
    )


@pytest.mark.parametrize("how", ["Cancel", "Esc"])
def test_cancel_and_esc_leave_the_document_as_it_was(panel, doc, how, panel_button, pump, panel_closed):
    assert panel.calculate() and "Toolpath" in names(doc)
    pump(200)
    if how == "Esc":
        escape = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier)
        QtWidgets.QApplication.postEvent(shown("calculate"), escape)
        pump(300)
    else:
        panel_button("Cancel")
    panel_closed()
    assert names(doc) == ["Dome"] and doc.UndoCount == 0 and not doc.HasPendingTransaction


def test_a_value_that_cannot_be_used_says_why_in_place(panel, doc, panel_button, screenshot, pump, until):
    panel.options.fields["tolerance"].show_value(0.0)
    panel.options.fields["tolerance"].edited.emit()
    error = shown("tolerance_error")
    until(error.isVisible, 20000, "what is wrong")
    assert (
        error.text()
        == "Tolerance 0 mm is out of range; it must be at least 0.000001 mm and at most 1000000 mm"
    )
    assert "#d0342c" in error.styleSheet()
    screenshot("panel_error")
    panel_button("OK")
    assert FreeCADGui.Control.activeDialog() and names(doc) == ["Dome"]
    panel.options.fields["tolerance"].show_value(0.01)
    panel.options.fields["tolerance"].edited.emit()
    until(lambda: not error.isVisible(), 20000, "nothing wrong")


def test_what_the_core_refuses_later_is_stated_under_the_form(panel, doc, pump, until):
    panel.options.show_options({"work_offset": "G99"})
    assert not panel.calculate()
    until(
        lambda: "G99" in shown("form_error").text() and shown("form_error").isVisible(),
        20000,
        "what is wrong",
    )
    assert names(doc) == ["Dome"] and not doc.HasPendingTransaction


def test_stopping_the_calculation_leaves_the_document_as_it_was(panel, doc, monkeypatch, anew):
    begin = waiting.Waiting.__call__

    def stopped(self, stage, fraction):
        self.dialog.cancel()
        begin(self, stage + " ", fraction)

    monkeypatch.setattr(waiting.Waiting, "__call__", stopped)
    assert not panel.calculate()
    assert names(doc) == ["Dome"] and FreeCADGui.Control.activeDialog() and not doc.HasPendingTransaction
    monkeypatch.undo()
    assert panel.calculate()


def test_esc_stops_long_work_and_the_window_is_painted_meanwhile(window, key, screenshot):
    with waiting.waiting("Tool path") as reported:
        reported("slice", 0.37)
        bar = reported.dialog.findChild(QtWidgets.QProgressBar)
        assert (
            reported.dialog.isVisible()
            and bar.value() == 37
            and "cutting the mesh" in reported.dialog.labelText()
        )
        screenshot("waiting")
        with pytest.raises(Cancelled):
            key(reported.dialog, QtCore.Qt.Key_Escape)
            reported("deviation", 0.5)
    assert not reported.dialog.isVisible()


def test_a_tool_length_is_requested_where_the_head_turns(panel, doc, until):
    assert not shown("tool_length").isVisible()
    panel.options.fields["machine"].show_value("fork_head_bc")
    until(shown("tool_length").isVisible, 20000, "the tool's length")
    assert not panel.calculate() and "gauge point" in shown("tool_length_error").text()
    panel.options.fields["tool_length"].show_value(120.0)
    assert panel.calculate() and doc.Toolpath.ToolLength.Value == 120.0


def test_scallop_and_stepover_take_turns(panel, until):
    spacing = panel.options.fields["spacing"]
    stepover, scallop = (spacing.lengths[name].editor for name in ("stepover", "scallop"))
    assert spacing.value() == {"stepover": 4.0}
    until(lambda: stepover.isVisible() and not scallop.isVisible(), 20000, "the stepover alone")
    spacing.kind.show_value("scallop")
    assert spacing.value() == {"scallop": 0.01} and "stepover" not in panel.options.options()
    until(lambda: scallop.isVisible() and not stepover.isVisible(), 20000, "the scallop alone")


def test_the_cutter_comes_from_a_tool_file(panel, tmp_path):
    bit = {
        "version": 2,
        "name": "ball",
        "shape": "ballend.fcstd",
        "parameter": {"Diameter": "8 mm", "CuttingEdgeHeight": "25 mm"},
    }
    (tmp_path / "ball.fctb").write_text(json.dumps(bit))
    panel.options.fields["cutter"].read_file(str(tmp_path / "ball.fctb"))
    assert panel.options.options()["cutter"] == "ball:8.0:25.0"
    (tmp_path / "drill.fctb").write_text(json.dumps({**bit, "shape": "drill.fcstd"}))
    panel.options.fields["cutter"].read_file(str(tmp_path / "drill.fctb"))
    assert (
        "bull noses" in shown("cutter_error").text() and panel.options.options()["cutter"] == "ball:8.0:25.0"
    )
    bit["parameter"] |= {"TaperAngle": "10 deg", "FlatRadius": "3 mm"}
    for shape, text in (
        ("endmill", "flat:8.0:25.0"),
        ("bullnose", "bull:8.0:1.0:25.0"),
        ("taperedballnose", "taperball:8.0:5deg:25.0"),
    ):
        (tmp_path / "bit.fctb").write_text(json.dumps({**bit, "shape": shape + ".fcstd"}))
        panel.options.fields["cutter"].read_file(str(tmp_path / "bit.fctb"))
        assert panel.options.options()["cutter"] == text and not shown("cutter_error").isVisible()


CUTTER_SIZES = {
    "ball": (), "flat": (), "bull": ("corner",), "taperball": ("taper",), "taperbull": ("corner", "taper"), "lollipop": ("neck",),
    "barrel": ("flank", "corner"),
}  # fmt: skip


@pytest.mark.parametrize("kind", CUTTER_SIZES)
def test_each_kind_of_cutter_asks_for_its_own_sizes(
    panel, field, choose, type_into, kind, screenshot, pump, until
):
    from freecad_fiveaxis.app.labels import choice_label

    cutter = panel.options.fields["cutter"]
    if kind != "ball":
        choose(field("cutter_kind"), choice_label(kind))
    wanted = {"diameter", "length", *CUTTER_SIZES[kind]}

    def read_request(of):
        return {size for size, part in cutter.sizes.items() if of(part).isVisible()}

    until(lambda: read_request(lambda part: part.editor) == wanted, 20000, f"fields of {wanted}")
    until(
        lambda: read_request(lambda part: cutter.rows[part.name][0]) == wanted, 20000, f"labels of {wanted}"
    )
    sizes = {
        "corner": ("1.25 mm", "1.25"),
        "taper": ("7.5 deg", "7.5deg"),
        "neck": ("2.5 mm", "2.5"),
        "flank": ("70 mm", "70.0"),
    }
    for size in CUTTER_SIZES[kind]:
        type_into(field("cutter_" + size), sizes[size][0])
    text = ":".join([kind, "6.0", *(sizes[size][1] for size in CUTTER_SIZES[kind]), "30.0"])
    until(lambda: panel.options.options()["cutter"] == text, 20000, text)
    until(lambda: not cutter.says("error"), 20000, "nothing wrong")
    qt_scroll(field("cutter_kind"), pump)
    screenshot("panel_cutter_" + kind)


def test_a_corner_that_is_too_large_says_so_under_the_cutter_and_nothing_is_built(
    panel, doc, field, choose, type_into, screenshot, pump, until
):
    choose(field("cutter_kind"), "bull nose mill")
    type_into(field("cutter_corner"), "4 mm")
    error = shown("cutter_error")
    until(
        lambda: "corner radius is 4 mm; give 0 to 3 mm" in error.text() and error.isVisible(),
        20000,
        "what is wrong",
    )
    assert not panel.calculate() and names(doc) == ["Dome"]
    qt_scroll(field("cutter_kind"), pump)
    screenshot("panel_cutter_error")
    choose(field("cutter_kind"), "flat end mill")  # which has no corner: what was typed does not count
    until(
        lambda: not error.isVisible() and panel.options.options()["cutter"] == "flat:6.0:30.0",
        20000,
        "nothing wrong",
    )


def test_strategy_and_height_of_a_scallop_are_distinguished_and_no_choice_of_a_setup_is_cut_off(
    panel, field, pump, screenshot
):
    strategies, spacing, setups = (field(name) for name in ("passes", "spacing_kind", "setup"))
    assert {"constant scallop", "level planes"} <= {
        strategies.itemText(at) for at in range(strategies.count())
    }
    assert [spacing.itemText(at) for at in range(spacing.count())] == ["Scallop height", "Stepover"]
    qt_scroll(spacing, pump)
    screenshot("panel_scallop")
    qt_scroll(setups, pump)
    assert setups.itemText(0) == "own values"
    assert setups.fontMetrics().boundingRect(setups.itemText(0)).width() + 30 <= setups.width()


def test_the_tool_axis_follows_cutter_and_passes_until_another_is_chosen(dome, field, choose, until, pump):
    panel = toolpath.create(dome)
    pump(300)
    stands = lambda: panel.options.options()["tool_axis"]  # noqa: E731
    assert (panel.options.options()["passes"], stands()) == ("scallop", "auto")
    for name, choice, usual in (
        ("cutter_kind", "bull nose mill", "face_normal"),
        ("cutter_kind", "ball end mill", "auto"),
        ("passes", "parallel planes", "facet_mean"),
        ("passes", "constant scallop", "auto"),
        ("tool_axis", "least deviation (minimax)", "minimax"),
        ("cutter_kind", "flat end mill", "minimax"),
    ):
        choose(field(name), choice)
        until(lambda: stands() == usual, 20000, f"{usual} after {choice}")  # noqa: B023
    panel.reject()


def test_a_bull_nose_with_its_holder_by_clicks_gives_the_bytes_of_the_command_line(panel, doc, field, choose, type_into, panel_button,
                                                                                  modal, screenshot, pump, tmp_path,
                                                                                   until, panel_closed):  # fmt: skip
    from test_clicks import command_line

    choose(field("cutter_kind"), "bull nose mill")
    choose(field("passes"), "parallel planes")
    choose(field("tool_axis"), "surface normal")
    type_into(field("cutter_corner"), "1.5 mm")
    type_into(field("stepover"), "12 mm")
    type_into(field("lead"), "60 deg")
    choose(field("gouge"), "only report")
    type_into(field("cutter_length"), "6 mm")
    type_into(field("shank"), "5x1, 0.25inx1mm")
    type_into(field("holder"), "40x25x3")
    error = shown("holder_error")
    until(lambda: "diameter x length" in error.text() or "number" in error.text(), 20000, "what is wrong")
    type_into(field("holder"), "200x25,63x50")
    until(lambda: not error.isVisible(), 20000, "nothing wrong")
    qt_scroll(field("holder"), pump)
    screenshot("panel_gouge")
    assert panel.calculate()
    pump(300)
    screenshot("panel_gouge_summary")
    reported = modal("Keep anyway")
    panel_button("OK")
    until(lambda: reported.texts, 20000, "a question")
    assert "shank or holder hits the part" in reported.texts[0]
    panel_closed()
    path = doc.Toolpath
    assert (path.CutterKind, path.CutterCorner.Value, path.Gouge) == ("bull", 1.5, "report")
    assert (path.Shank, path.Holder) == ("5x1,6.35x1", "200x25,63x50")
    assert any(one.code == "holder-collision" for one in results.figures_of(path).findings)
    assert results.nc_of(path) == command_line(path, tmp_path)
    opened = toolpath.edit(path)
    pump(200)
    assert opened.options.options()["cutter"] == "bull:6.0:1.5:6.0" and not opened.stale
    assert opened.options.options()["holder"] == "200x25,63x50"
    opened.reject()


@pytest.mark.parametrize("code", ["lifted", "left-out", "tilted", "uncut"])
def test_what_a_cure_of_gouges_did_is_in_the_summary(code):
    found = (
        Finding(Severity.NOTE, code, "Something was done.", 0.0, 0.0, "mm"),
        Finding(Severity.NOTE, "other", "No cure.", 0.0, 0.0, "mm"),
    )
    last = SimpleNamespace(figures=SimpleNamespace(findings=found))
    assert summary.list_cures(SimpleNamespace(Proxy=SimpleNamespace(last=last))) == ["Something was done."]


def test_every_option_stands_in_the_group_that_the_property_editor_has_it_in_or_under_more(panel):
    from freecad_fiveaxis.app.properties import group_of, list_options

    for cls, leaf in list_options("mill"):
        name = {"scallop": "spacing", "stepover": "spacing"}.get(leaf.name, leaf.name)
        editor = panel.options.fields[name].editor
        (group,) = [group for group in panel.options.groups.values() if group.isAncestorOf(editor)]
        assert group.title in (group_of(cls, leaf), "More settings"), leaf.name


def test_largest_tilt_is_requested_where_either_choice_needs_it(panel, field, until):
    tilt, gouge, axis = (panel.options.fields[name] for name in ("max_tilt", "gouge", "tool_axis"))
    lead = panel.options.fields["lead"].editor
    for group in panel.options.groups.values():  # whatever tests before have folded
        group.unfold()
    assert not tilt.editor.isVisible()
    gouge.show_value("tilt")  # joins the list where the core has no such choice
    until(tilt.editor.isVisible, 20000, "the largest tilt")
    assert "max_tilt" in panel.options.options()
    axis.show_value("minimax")
    gouge.show_value("off")
    until(lambda: tilt.editor.isVisible() and not lead.isVisible(), 20000, "the largest tilt and no lead")
    axis.show_value("facet_mean")
    until(lambda: not tilt.editor.isVisible(), 20000, "no largest tilt")
    assert "max_tilt" not in panel.options.options()


def test_a_new_path_has_the_cutter_and_the_holder_of_the_preferences(dome, parameters, pump, until):
    group = parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis")
    for key, text in (("CutterKind", "bull"), ("Shank", "8x20"), ("Holder", "40x25")):
        group.SetString(key, text)
    group.SetFloat("CutterCorner", 6.0)  # more than half the diameter: the field says so
    panel = toolpath.create(dome)
    pump(200)
    options = panel.options.options()
    assert (options["cutter"], options["shank"], options["holder"]) == ("bull:10.0:6.0:50.0", "8x20", "40x25")
    until(lambda: "give 0 to 5 mm" in shown("cutter_error").text(), 20000, "what is wrong")
    panel.options.fields["cutter"].sizes["corner"].show_value(2.0)
    until(lambda: not shown("cutter_error").isVisible(), 20000, "nothing wrong")
    panel.reject()


def test_a_lollipop_is_chosen_with_the_diameter_of_its_neck(dome, field, choose, type_into, pump, until):
    panel = toolpath.create(dome)
    pump(200)
    assert not shown("cutter_neck").isVisible()
    choose(field("cutter_kind"), "lollipop")
    until(
        lambda: shown("cutter_neck").isVisible() and not shown("cutter_corner").isVisible(),
        20000,
        "a neck and no corner",
    )
    assert panel.options.options()["cutter"] == "lollipop:10.0:3.0:50.0", "another kind is a cutter at once"
    type_into(field("cutter_neck"), "0.25 in")
    assert panel.options.options()["cutter"] == "lollipop:10.0:6.35:50.0"
    type_into(field("cutter_neck"), "10 mm")
    until(lambda: "less than 10 mm" in shown("cutter_error").text(), 20000, "what is wrong")
    panel.reject()


def test_a_barrel_is_chosen_with_the_radius_of_its_flank(dome, field, choose, type_into, pump, until):
    panel = toolpath.create(dome)
    pump(200)
    assert not shown("cutter_flank").isVisible()
    choose(field("cutter_kind"), "barrel")
    until(
        lambda: shown("cutter_flank").isVisible() and shown("cutter_corner").isVisible(),
        20000,
        "a flank and a corner",
    )
    assert panel.options.options()["cutter"] == "barrel:10.0:85.0:1.0:50.0", (
        "another kind is a cutter at once"
    )
    type_into(field("cutter_flank"), "4 mm")
    until(lambda: "more than 5 mm" in shown("cutter_error").text(), 20000, "what is wrong")
    panel.reject()


def test_the_cutter_comes_from_a_tool_of_a_cam_job(dome, monkeypatch):
    from freecad_fiveaxis.app import cam
    from freecad_fiveaxis.core.tool import Cutter

    tools = [
        tool_bit.JobTool("Ball", 3, Cutter(5.0, 20.0)),
        tool_bit.JobTool("Drill", 4, None, "Drill is of no use"),
    ]
    monkeypatch.setattr(cam, "jobs_of", lambda doc: [doc])
    monkeypatch.setattr(tool_bit, "cutters_of_job", lambda job: tools)
    field = toolpath.create(dome).options.fields["cutter"]
    assert [field.job.box.itemText(at) for at in (1, 2)] == ["T3 Ball", "T4 Drill"]
    field.job.box.activated.emit(1)
    assert field.value() == "ball:5.0:20.0" and not field.error.text()
    field.job.box.activated.emit(2)
    assert field.value() == "ball:5.0:20.0" and field.error.text() == "Drill is of no use"


def test_the_work_zero_is_picked_in_the_view(panel, doc, dome, view_click, pump, until):
    field = panel.options.fields["work_zero"]
    field.button.click()
    FreeCADGui.Selection.addSelection(doc.Name, dome.Name, "Vertex1", 0.1, 0.2, 0.3)
    vertex = pytest.approx(list(dome.Shape.Vertexes[0].Point), abs=1e-12)
    until(lambda: field.value() == vertex and not field.button.isChecked(), 20000, "the place of the vertex")
    field.button.click()
    view_click((0, 0, 20))
    until(lambda: not field.pick.running, 20000, "the pick of a place")
    x, y, z = field.value()
    assert (x * x + y * y + z * z) ** 0.5 == pytest.approx(20.0, abs=0.05) and z > 18.0
    assert panel.options.read_values()["work_zero"] == [x, y, z]


def test_esc_ends_the_pick_and_not_the_panel(panel, doc, dome, key, pump, until):
    field = panel.options.fields["work_zero"]
    before = field.value()
    field.button.click()
    assert field.pick.running
    key(FreeCADGui.getMainWindow(), QtCore.Qt.Key_Escape)
    until(lambda: not field.pick.running, 20000, "the pick ended")
    pump(100)
    assert FreeCADGui.Control.activeDialog()
    FreeCADGui.Selection.addSelection(doc.Name, dome.Name, "Vertex1")
    pump(100)
    assert field.value() == before


def test_the_panel_of_a_path_shows_it_and_changes_it_in_one_step(
    panel, doc, pump, panel_button, until, panel_closed
):
    panel_button("OK")
    panel_closed()
    path, blocks = doc.Toolpath, doc.Toolpath.Blocks
    nc = results.nc_of(path)
    doc.clearUndos()
    opened = toolpath.edit(path)
    pump(200)
    assert opened.options.options()["cutter"] == "ball:6.0:30.0" and not opened.stale
    until(lambda: f"<b>{blocks}</b>" in shown("summary").text(), 20000, "the summary of the path")
    opened.options.fields["spacing"].show_value({"scallop": 0.2, "stepover": None})
    assert opened.stale and opened.calculate()
    assert path.Stepover.Value == 0.0 and path.Scallop.Value == 0.2 and path.Blocks != blocks
    pump(200)
    panel_button("Cancel")
    panel_closed()
    assert (
        path.Blocks == blocks
        and path.Stepover.Value == 4.0
        and results.nc_of(path) == nc
        and "Touched" not in path.State
    )
    opened = toolpath.edit(path)
    pump(200)
    opened.options.fields["lead"].show_value(5.0)
    opened.options.fields["linear_deflection"].show_value(0.2)
    panel_button("OK")
    panel_closed()
    assert path.Lead.Value == 5.0 and path.Mesh.LinearDeflection.Value == 0.2 and doc.UndoCount == 1
    doc.undo()
    doc.recompute()
    assert path.Lead.Value == 0.0 and results.nc_of(path) == nc


def test_a_double_click_in_the_tree_opens_the_panel_of_the_path(
    panel, doc, pump, panel_button, tree_row, until, panel_closed
):
    panel_button("OK")
    panel_closed()
    doc.clearUndos()
    tree_row("Toolpath", double=True)
    until(FreeCADGui.Control.activeDialog, 20000, "the panel of the path")
    until(lambda: shown("cutter_diameter").read_measure() == 6.0, 20000, "its cutter")
    panel_button("Cancel")
    panel_closed()
    assert doc.UndoCount == 0 and doc.Toolpath.Blocks > 100


def test_a_second_panel_is_refused(panel, dome, modal, pump, until):
    reported = modal("OK")
    toolpath.create(dome)
    until(lambda: reported.texts, 20000, "a refusal")
    assert reported.texts == ["Another task panel is open: close it first."]


def test_inches_show_inches_and_lose_nothing(inches, dome, type_into, pump, screenshot, until):
    panel = toolpath.create(dome)
    pump(300)
    fields = panel.options.fields
    assert fields["tolerance"].editor.property("text") == "0.00039 in" and fields["tolerance"].value() == 0.01
    assert fields["feed"].editor.property("text") == "39.3701 in/min" and fields["feed"].value() == 1000.0
    assert fields["feed"].words() == "F 39.3701 in/min"
    type_into(fields["cutter"].sizes["diameter"].editor, "0.5")
    until(lambda: fields["cutter"].value() == "ball:12.7:50.0", 20000, "half an inch")
    screenshot("panel_inches")


def test_what_is_typed_is_what_is_milled(millimetres, dome, field, type_into, pump, until):
    panel = toolpath.create(dome)
    pump(300)
    for name, text, value in (
        ("tolerance", "0.0125", 0.0125),
        ("feed", "1234.5", 1234.5),
        ("lead", "2.5", 2.5),
    ):
        area = field(name)
        qt_scroll(area, pump)
        type_into(area, text)
        wanted = pytest.approx(value, rel=1e-12)
        until(lambda: panel.options.fields[name].value() == wanted, 20000, f"{name} = {value}")  # noqa: B023


def qt_scroll(widget, pump):
    area = widget
    while not isinstance(area, QtWidgets.QScrollArea):
        area = area.parentWidget()
    area.ensureWidgetVisible(widget)
    pump(100)


def test_every_option_of_the_core_has_its_words():
    from freecad_fiveaxis.app import labels
    from freecad_fiveaxis.core.pipeline.settings import option_fields

    for _, leaf in option_fields():
        if leaf.metadata["kind"] not in ("path", "paths"):
            assert leaf.name in labels._options(), leaf.name
            assert set(leaf.metadata["choices"]) <= set(labels._choices()), leaf.name


@pytest.fixture
def path(panel, doc, panel_button, panel_closed):
    """A computed path."""
    panel_button("OK")
    panel_closed()
    doc.Toolpath.Spindle = 9000
    doc.recompute()
    return doc.Toolpath


@pytest.fixture
def post_to(path, pump):
    """post_to(file): the post panel of the path, opened, with that name in it."""

    def opened(file):
        panel = post.write(path)
        panel.file.show_value(str(file))
        pump(300)
        return panel

    return opened


def test_the_post_panel_writes_nc_and_report(
    path, doc, tmp_path, panel_button, screenshot, pump, parameters, panel_closed
):
    parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis").SetString("OutputFolder", str(tmp_path))
    path.Label = "my: part"
    panel = post.write(path)
    assert panel.file.value() == str(tmp_path / "my_ part.ngc")
    panel.reports["html"].setChecked(True)
    panel.reports["json"].setChecked(True)
    screenshot("post_panel")
    panel_button("OK")
    panel_closed()
    assert (tmp_path / "my_ part.ngc").read_bytes() == results.nc_of(path)
    assert json.loads((tmp_path / "my_ part.json").read_text())["summary"]["blocks"] == path.Blocks
    assert "<html" in (tmp_path / "my_ part.html").read_text()[:200]
    assert [obj.Name for obj in path.InList] == ["NCOutput"]


@pytest.mark.parametrize("answer", ["Cancel", "Replace"])
def test_a_file_that_is_there_is_replaced_only_when_the_user_says_so(
    path, tmp_path, panel_button, modal, post_to, answer, until
):
    file = tmp_path / "part.ngc"
    file.write_text("(somebody's own)")
    post_to(file)
    reported = modal(answer)
    panel_button("OK", wait=600)
    until(lambda: reported.texts, 20000, "a question")
    assert str(file) in reported.texts[0]
    until(
        lambda: bool(FreeCADGui.Control.activeDialog()) == (answer == "Cancel"),
        20000,
        "the panel open only after Cancel",
    )
    assert (file.read_bytes() == results.nc_of(path)) == (answer == "Replace")


def test_of_an_inch_document_it_is_stated_that_the_program_is_in_millimetres(
    path, inches, tmp_path, post_to, screenshot, until
):
    post_to(tmp_path / "part.ngc")
    until(
        lambda: "(G21)" in shown("post_units").text() and shown("post_units").isVisible(),
        20000,
        "the program's unit",
    )
    screenshot("post_inches")


def test_of_an_inch_document_a_program_in_inches_has_nothing_to_say_either(path, inches, tmp_path, post_to):
    path.ProgramUnits = "inch"
    panel = post_to(tmp_path / "part.ngc")
    assert panel.form.findChild(QtWidgets.QLabel, "post_units") is None


def test_of_a_metric_document_it_is_stated_that_the_program_is_in_inches(
    path, millimetres, tmp_path, post_to, until
):
    path.ProgramUnits = "inch"
    post_to(tmp_path / "part.ngc")
    until(lambda: "in inches (G20)" in shown("post_units").text(), 20000, "the program's unit")


def test_of_a_metric_document_the_programs_unit_is_nothing_to_say(path, millimetres, tmp_path, post_to):
    panel = post_to(tmp_path / "part.ngc")
    assert panel.form.findChild(QtWidgets.QLabel, "post_units") is None


def test_a_folder_that_is_not_there_is_stated_under_the_name(post_to, doc, tmp_path, panel_button, until):
    post_to(tmp_path / "nowhere" / "part.ngc")
    before = names(doc)
    panel_button("OK")
    until(lambda: "nowhere" in shown("post_error").text(), 20000, "what is wrong")
    assert FreeCADGui.Control.activeDialog()
    assert names(doc) == before


def test_the_preview_for_cam(post_to, doc, tmp_path, panel_button, panel_closed):
    panel = post_to(tmp_path / "part.ngc")
    panel.preview.setChecked(True)
    panel_button("OK")
    panel_closed()
    assert any(obj.TypeId == "Path::FeaturePython" for obj in doc.Objects)


TABLE_2 = "G21 G90 G94\nG1 X0 Y0 Z0 A0 C0 F500\nG1 X10 Y0 Z0 A5 C60\nM2\n"


def test_the_audit_panel_makes_audit_and_markers_in_one_step(
    doc, tmp_path, panel_button, screenshot, pump, panel_closed
):
    (tmp_path / "foreign.nc").write_text(TABLE_2)
    panel = audit.create(doc)
    pump(200)
    assert not panel.calculate() and "NC file" in shown("nc_file_error").text()
    panel.file.show_value(str(tmp_path / "foreign.nc"))
    panel.options.show_options({"machine": "mikron_ucp710", "tolerance": 0.02})
    assert panel.calculate()
    screenshot("audit_panel")
    panel_button("OK")
    panel_closed()
    assert names(doc) == ["Audit", "Markers"] and doc.UndoCount == 1
    assert doc.Audit.MaxSegmentDeviation.Value > 0.1 and doc.Audit.Tolerance.Value == 0.02
    assert doc.Markers.Path is doc.Audit and len(doc.Markers.Places) >= 1
    doc.undo()
    assert names(doc) == []


def test_the_holder_that_an_audit_draws_survives_its_panel(doc, tmp_path, until, panel_button, panel_closed):
    (tmp_path / "a.ngc").write_text("G21 G90 G94\nG1 X0 Y0 Z10 A0 C0 F100\nX10 A1\n")
    result = app.audit(doc, tmp_path / "a.ngc", "trunnion_ac", holder="40x60", cutter="taperball:6:5deg")
    opened = audit.edit(result)
    until(lambda: FreeCADGui.Control.activeDialog() and opened.form.isVisible(), 20000, "the panel")
    opened.options.fields["tolerance"].show_value(0.5)
    assert opened.calculate(), shown("form_error").text()
    panel_button("OK")
    panel_closed()
    until(lambda: result.Tolerance.Value == 0.5, 20000, "what OK keeps")
    assert (result.Holder, result.CutterKind, result.CutterTaper.Value) == ("40x60", "taperball", 5.0)


def test_an_nc_file_that_cannot_be_read_says_so(doc, tmp_path):
    (tmp_path / "bad.nc").write_text("G1 X1 Y Z\n")
    panel = audit.create(doc)
    panel.file.show_value(str(tmp_path / "bad.nc"))
    assert not panel.calculate()
    assert shown("form_error").text() and names(doc) == []


def test_resources_are_found():
    assert Path(qt.icon("FiveAxis_NoSuchCommand")).is_file() and Path(qt.resource("machines")).is_dir()


def test_panels_open_again_and_again(dome, pump):
    """FreeCAD deletes the widgets of a closed panel behind PySide's back; new ones may stand at their
    addresses."""
    before = gc.get_threshold()
    gc.set_threshold(100, 5, 5)  # so that old ones go at any moment
    try:
        for _ in range(15):
            panel = toolpath.create(dome)
            pump(30)
            assert panel.options.options()["cutter"] == "ball:10.0:50.0"
            panel.reject()
            pump(30)
    finally:
        gc.set_threshold(*before)


def test_a_part_that_is_deleted_under_the_panel_says_so(panel, doc, pump):
    assert panel.calculate()
    panel.step.take_back()
    doc.removeObject("Dome")
    assert not panel.calculate() and "deleted" in shown("form_error").text()
    panel.reject()
    assert names(doc) == []


def test_a_document_that_is_closed_under_the_panel_does_no_harm(panel, doc, pump, panel_closed):
    assert panel.calculate()
    FreeCAD.closeDocument(doc.Name)
    pump(100)
    panel.reject()
    panel_closed()


def test_every_stage_of_the_work_has_its_words(panel, monkeypatch, anew):
    panel.options.show_options({"tool_axis": "auto"})  # which has the most of them
    stages = set()
    say = waiting.Waiting.__call__
    monkeypatch.setattr(
        waiting.Waiting, "__call__", lambda self, stage, done: (stages.add(stage), say(self, stage, done))
    )
    assert panel.calculate()
    assert stages > {"slice", "deviation"} and stages <= set(waiting.stage_words())
