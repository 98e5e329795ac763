# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where to clamp: the command pressed, the map seen as coloured points, the recommendation applied, saved and
undone."""

import FreeCAD
import pytest
from conftest import QtWidgets, close_all
from test_clicks import look
from test_fixtures import labels, tick

from freecad_fiveaxis import app
from freecad_fiveaxis.gui.scene import colours
from freecad_fiveaxis.gui.view_properties import rgb

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def dome(doc, parameters, tmp_path):
    """A half ball of 20 mm; what is saved goes into the test's own folder."""
    group = parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis")
    group.Clear()
    group.SetString("OutputFolder", str(tmp_path))
    group.SetFloat("Scallop", 0.3)
    ball = doc.addObject("Part::Sphere", "Dome")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    look(doc)
    return ball


@pytest.fixture
def path(dome, doc, pump):
    """A coarse path over the dome, off the rotary centre; its blocks are not divided, so that the place
    decides the deviation."""
    result = app.create_toolpath(
        doc,
        dome,
        passes="planes",
        machine="trunnion_ac",
        stepover=6,
        linear_deflection=0.1,
        linearize="off",
        gouge="off",
    )
    doc.clearUndos()
    pump(500)
    return result


@pytest.fixture
def ask_small(field, type_into, click):
    """Fill the panel with a region of 40 mm and a map of 3 x 3 x 2 places."""

    def fill():
        for letter in "xyz":
            type_into(field(f"region_{letter}"), "40 mm")
        box = field("grid").findChild(QtWidgets.QCheckBox)
        if box.isChecked():
            click(box)
        for letter, count in zip("xyz", "332", strict=True):
            type_into(field(f"grid_{letter}"), count)

    return fill


def seen(pixels, picture, rgba, box):
    return pixels(picture, [round(255 * part) for part in rgba], 16, box)


def test_the_map_is_seen_and_applying_it_lowers_the_deviation(path, doc, dome, tree_row, press, field, ask_small, click, until,
                                                              panel_button, screenshot, pixels, view_box, pump,
                                                              panel_closed):  # fmt: skip
    before = path.MaxSegmentDeviation.Value
    tree_row(path.Label)
    press("FiveAxis_Setup")
    screenshot("setup_panel")
    until(
        lambda: field("table_height").placeholderText() == "-100 mm",
        20000,
        "how high the table is, of the machine file",
    )
    assert not field("apply").isEnabled() and not field("page").isEnabled()
    ask_small()
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a recommendation")
    (result,) = [obj for obj in doc.Objects if hasattr(obj, "Recommended")]
    assert tuple(result.Region) == (40, 40, 40) and tuple(result.Grid) == (3, 3, 2)
    dome.ViewObject.hide()
    path.ViewObject.hide()
    ramp = colours.heat(rgb(result.ViewObject.ColourBad))
    for colour, what in (
        (ramp[-1], "the place of the largest deviation"),
        ((0.35, 0.71, 0.91), "the present work zero"),
    ):
        until(lambda: seen(pixels, screenshot("setup_map"), colour, view_box()) > 60, 30000, what)  # noqa: B023
    click(field("apply"))
    until(lambda: path.MaxSegmentDeviation.Value < before, 60000, "a lower deviation")
    message = field("summary")
    until(lambda: message.text().startswith("<p><b>Applied: "), 20000, "that it is applied")
    until(lambda: message.visibleRegion().boundingRect().top() == 0, 20000, "that, seen without scrolling")
    screenshot("setup_applied")
    panel_button("OK")
    panel_closed()
    assert tuple(path.Origin) == pytest.approx(tuple(result.Recommended)) and not path.OriginFromMachine
    assert (
        path.MaxSegmentDeviation.Value == pytest.approx(result.DeviationAfter.Value, abs=1e-9)
        and result.UpToDate
    )
    assert doc.UndoCount == 1
    doc.undo()
    assert path.OriginFromMachine and not [obj for obj in doc.Objects if "SetupMap" in obj.Name]


def test_deviations_of_blocks_that_will_be_divided_say_so(dome, doc, path):
    from freecad_fiveaxis.gui.panels import setup

    def list_reported(result):
        return [row[0] for row in setup.rows(result)], result.Verdict

    labels, verdict = list_reported(app.setup_map(path, region=(40, 40, 0), grid=(2, 2, 1)))
    assert "Largest deviation" in labels and "not yet divided" not in verdict
    path.Linearize = "on"
    doc.recompute()
    result = app.setup_map(path, region=(40, 40, 0), grid=(2, 2, 1))
    labels, verdict = list_reported(result)
    assert "Largest deviation, blocks not yet divided" in labels and "not yet divided" in verdict
    assert result.DeviationBefore > path.Tolerance >= path.MaxSurfaceDeviation, (
        "which is why that has to be said"
    )
    assert setup.describe_applied(path).startswith(
        "Applied: the largest deviation of the divided blocks is now 0.00"
    )


def test_boxes_of_three_numbers_stand_below_each_other_where_they_have_no_room(window, pump, until):
    from freecad_fiveaxis.gui.panels.picking import PointField
    from freecad_fiveaxis.gui.panels.triple import TripleField

    for field in (TripleField("region", "point", width=90), PointField("work_zero")):
        field.show_value((123.4567, 123.4567, 123.4567))
        field.editor.show()
        for width, below in ((200, True), (700, False)):
            field.editor.resize(width, 200)
            until(lambda: field.below is below, 20000, "boxes below each other, or beside")  # noqa: B023
            pump(200)
            boxes = [part.editor for part in field.parts] + [getattr(field, "button", field.parts[0].editor)]
            places = list({box: box.geometry() for box in boxes}.values())
            assert not any(one.intersects(other) for at, one in enumerate(places) for other in places[:at])
            assert all(part.editor.width() >= field._needs(part) for part in field.parts)
        field.show_value((0.0, 0.0, 0.0))
        field.editor.close()


def test_cancel_leaves_the_document_as_it_was(
    path, doc, tree_row, press, field, ask_small, click, until, panel_button, panel_closed
):
    names = [obj.Name for obj in doc.Objects]
    tree_row(path.Label)
    press("FiveAxis_Setup")
    ask_small()
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a recommendation")
    click(field("apply"))
    panel_button("Cancel")
    panel_closed()
    assert (
        [obj.Name for obj in doc.Objects] == names and path.OriginFromMachine and "Touched" not in path.State
    )


@pytest.mark.usefixtures("whole_screen")
def test_what_holds_the_part_is_ticked_and_the_findings_say_how_high_jaws_reach(
    path, doc, tree_row, press, field, ask_small, click, until, panel_button, panel_closed, screenshot, pump
):
    jaw = doc.addObject("Part::Box", "Jaw")
    jaw.Length, jaw.Width, jaw.Height = 20, 40, 10
    jaw.Placement.Base = FreeCAD.Vector(25, -20, 0)
    path.Holder = "30x20"
    doc.recompute()
    tree_row(path.Label)
    press("FiveAxis_Setup")
    ask_small()
    editor = field("fixtures")
    assert labels(editor) == ["Jaw"], "the part itself is none"
    tick(editor, 0, click, until)
    screenshot("setup_fixture_ticked")
    click(field("calculate"))
    until(lambda: "Jaws 40 mm thick" in field("summary").text(), 60000, "how high jaws reach")
    assert "Tool stick-out" in field("summary").text() and path.Fixtures == [jaw]
    pump(600)
    bar = field("summary").parent().parent().verticalScrollBar()
    bar.setValue(bar.maximum())
    screenshot("setup_fixtures")
    panel_button("OK")
    panel_closed()
    (result,) = [obj for obj in doc.Objects if hasattr(obj, "Recommended")]
    jaw.Height = 12
    doc.recompute()
    assert not result.UpToDate
    tree_row(path.Label)
    press("FiveAxis_Setup")
    tick(field("fixtures"), 0, click, until)
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a map without it")
    assert not path.Fixtures and "Jaws" not in field("summary").text()
    panel_button("Cancel")
    panel_closed()
    assert path.Fixtures == [jaw] and not result.UpToDate, "Cancel takes it back"


def test_a_solid_without_a_path_gets_one_in_the_same_step(
    dome, doc, tree_row, press, field, ask_small, panel_button, screenshot, panel_closed
):
    doc.clearUndos()
    tree_row("Dome")
    press("FiveAxis_Setup")
    ask_small()
    panel_button("OK", 1000)
    panel_closed()
    screenshot("setup_over_solid")
    assert [obj.Name for obj in doc.Objects] == [
        "Dome",
        "Tessellation",
        "Toolpath",
        "SetupMap",
    ] and doc.UndoCount == 1
    assert doc.Toolpath.ViewObject.Proxy.claimChildren() == [doc.Tessellation, doc.SetupMap]
    doc.undo()
    assert [obj.Name for obj in doc.Objects] == ["Dome"]


def test_a_region_without_a_choice_says_so_and_nothing_selected_is_reported(dome, path, doc, tree_row, press, field, type_into, click,
                                                                        until, panel_button, pump):  # fmt: skip
    tree_row(path.Label)
    press("FiveAxis_Setup")
    for letter in "xyz":
        type_into(field(f"region_{letter}"), "0 mm")
    click(field("calculate"))
    until(lambda: "one setup only" in field("form_error").text(), 20000, "what is wrong")
    type_into(field("turns"), "0")
    until(lambda: "out of range" in field("turns_error").text(), 20000, "what is wrong")
    panel_button("Cancel")


def test_the_page_is_saved_where_the_user_says_and_replaces_nothing_unasked(
    path, doc, monkeypatch, modal, pump, tmp_path
):
    from freecad_fiveaxis.gui.panels import setup

    result = app.setup_map(path, region=(40, 40, 0), grid=(3, 3, 1))
    panel = setup.edit(result)
    pump(300)
    file = tmp_path / "map.html"
    monkeypatch.setattr(setup, "ask_file", lambda *_: str(file))
    panel.save()
    assert "Where the part should stand" in file.read_text(encoding="utf-8")
    file.write_text("mine")
    met = modal("Cancel")
    panel.save()
    assert met.texts and file.read_text() == "mine"
    modal("Replace")
    panel.save()
    assert file.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


@pytest.mark.usefixtures("whole_screen")
def test_a_reopened_map_is_drawn_and_says_when_it_is_old(
    path, doc, pump, until, tmp_path, screenshot, pixels, view_box, tree_row, press
):
    app.setup_map(path, region=(40, 40, 0), grid=(3, 3, 1))
    file = str(tmp_path / "map.FCStd")
    doc.saveAs(file)
    FreeCAD.closeDocument(doc.Name)
    pump(300)
    again = FreeCAD.openDocument(file)
    try:
        again.Dome.ViewObject.hide()
        again.Toolpath.ViewObject.hide()
        again.Toolpath.Stepover = 8
        again.recompute()
        pump(800)
        look(again)
        result = again.SetupMap
        assert result.Proxy.last is None and not result.UpToDate
        worst = colours.heat(rgb(result.ViewObject.ColourBad))[-1]
        until(
            lambda: seen(pixels, screenshot("setup_reopened"), worst, view_box()) > 60,
            30000,
            "the colours of the map",
        )
        warning = (1.0, 205 / 255, 70 / 255)
        until(
            lambda: seen(pixels, screenshot("setup_reopened"), warning, view_box()) > 20,
            30000,
            "the legend's warning",
        )
        assert result.ViewObject.Proxy.getIcon().endswith("SetupMap.svg")
    finally:
        close_all(again.Name)


def test_the_legend_of_the_map_is_as_that_of_a_path(path, doc, until, screenshot, pump):
    """Halves of the scale that say what they are, and how many places each colour has; it folds as the others
    do."""
    from freecad_fiveaxis.app import setups
    from freecad_fiveaxis.gui.scene.on_screen import LegendBox

    result = app.setup_map(path, region=(300, 300, 0), grid=(3, 3, 1))
    look(doc)
    picture = until(lambda: result.ViewObject.Proxy.picture, 20000, "the map drawn")
    assert type(picture.legend) is LegendBox is type(path.ViewObject.Proxy.picture.legend)
    scale = setups.scale(result)
    legend = picture._legend(scale, (0, 1, 0), (1, 0, 0), len(result.Places))
    assert legend.halves == ("smaller deviation", "larger deviation") and len(legend.marks) == 5
    counts = [int(text.split(": ")[1].split(" ")[0]) for _, text in legend.keys if ": " in text]
    beyond = sum(kind == "setup-beyond-limits" for kind in result.Kinds)
    within = sum(deviation <= path.Tolerance.Value for deviation in result.Deviations)
    assert counts == [within, beyond]
    until(lambda: len(picture.legend.box), 20000, "the legend in the view")
    screenshot("setup_legend")
    result.ViewObject.FoldLegend = True
    until(lambda: 0 < picture.legend.size[1] < 50, 20000, "one line")
