# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trajectory control in the tool path's panel: choices made by mouse and keys, and what the program then
is."""

import pytest
from conftest import picture
from test_clicks import command_line, look

from freecad_fiveaxis.app import results


@pytest.fixture
def dome(doc, parameters):
    """A half ball of 20 mm whose top passes the pole of trunnion_ac; the preferences are the defaults."""
    parameters("User parameter:BaseApp/Preferences/Mod/FiveAxis").Clear()
    ball = doc.addObject("Part::Sphere", "Dome")
    ball.Radius, ball.Angle1 = 20, 0
    doc.recompute()
    look(doc)
    return ball


@pytest.fixture
def panel(dome, tree_row, press, field, choose, type_into):
    """The panel of a new, coarse path over the dome, opened by clicks."""
    tree_row("Dome")
    press("FiveAxis_Toolpath")
    choose(field("spacing_kind"), "Stepover")
    type_into(field("stepover"), "4 mm")
    return dome


def shown(field, name):
    """Whether that widget is shown now."""
    try:
        return field(name, 0).isVisible()
    except TimeoutError:
        return False


def calculate(field, click, until):
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a summary")


def test_minimax_and_deform_by_clicks_give_the_bytes_of_the_command_line(panel, doc, field, choose, type_into, click, until,
                                                                         panel_button, panel_closed, screenshot,
                                                                         tmp_path):  # fmt: skip
    panel.Radius = 10  # made twice here, once by the command line
    doc.recompute()
    type_into(field("stepover"), "8 mm")
    type_into(field("tolerance"), "0.05 mm")
    assert not shown(field, "max_tilt") and not shown(field, "max_axis_change") and shown(field, "lead")
    choose(field("tool_axis"), "least deviation (minimax)")
    until(
        lambda: shown(field, "max_tilt") and not shown(field, "lead") and not shown(field, "tilt"),
        10000,
        "fields of minimax",
    )
    type_into(field("max_tilt"), "3 deg")
    choose(field("singularity"), "turn the axis past it")
    type_into(field("max_axis_change"), "1.5 deg")
    choose(field("linearize"), "on")
    calculate(field, click, until)
    screenshot("panel_minimax")
    panel_button("OK", 500)
    panel_closed()
    path = doc.Toolpath
    assert (path.ToolAxis, path.Singularity, path.Linearize) == ("minimax", "deform", "on")
    assert (path.MaxTilt.Value, path.MaxAxisChange.Value) == pytest.approx((3, 1.5))
    assert 0 < path.MaxSurfaceBound.Value <= 0.05 and path.OverTolerance == 0
    assert results.nc_of(path) == command_line(path, tmp_path)


def test_auto_and_links_over_the_part_by_clicks_give_the_bytes_of_the_command_line(panel, doc, field, choose, type_into, click, until,
                                                                                  panel_button, panel_closed, screenshot,
                                                                                  tmp_path):  # fmt: skip
    panel.Radius, panel.Angle1 = 10, 60  # a cap: the freedom of every facet is looked for twice
    doc.recompute()
    type_into(field("linear_deflection"), "0.1 mm")
    choose(field("tool_axis"), "free of the part (auto)")
    choose(field("links"), "always over the part")
    choose(field("spiral"), "on")
    calculate(field, click, until)
    screenshot("panel_auto")
    panel_button("OK", 500)
    panel_closed()
    path = doc.Toolpath
    assert (path.ToolAxis, path.Links, path.Spiral) == ("auto", "over", "on") and path.Proven
    assert results.nc_of(path) == command_line(path, tmp_path)


def test_an_angle_out_of_range_says_so_in_place_and_not_where_it_does_not_count(
    panel, field, choose, type_into, screenshot, until
):
    choose(field("singularity"), "turn the axis past it")
    type_into(field("max_axis_change"), "50 deg")
    until(lambda: "out of range" in field("max_axis_change_error").text(), 10000, "what is wrong")
    screenshot("panel_out_of_range")
    choose(field("singularity"), "only report")
    until(
        lambda: not shown(field, "max_axis_change") and not shown(field, "max_axis_change_error"),
        10000,
        "the field gone",
    )
    type_into(field("lead"), "5 deg")
    choose(field("tool_axis"), "least deviation (minimax)")  # has no lead: what was typed does not count
    assert not shown(field, "form_error")


def test_a_divided_path_is_drawn_marked_and_played_block_by_block(panel, doc, dome, field, choose, type_into, click, until, press,
                                                                  panel_button, panel_closed, tree_row, shown_pixels, screenshot,
                                                                  tmp_path):  # fmt: skip
    choose(field("passes"), "parallel planes")  # their axes come near the pole
    type_into(field("tolerance"), "0.005 mm")
    choose(field("singularity"), "turn the axis past it")
    choose(field("linearize"), "on")
    calculate(field, click, until)
    message = field("summary").text()
    screenshot("panel_cures")
    assert "turned past the pole" in message and "were divided into" in message, message
    panel_button("OK", 500)
    panel_closed()
    path = doc.Toolpath
    assert results.nc_of(path) == command_line(path, tmp_path)
    figures = results.figures_of(path)
    draft = results.result_of(path).draft
    assert len(draft.program.words) > len(draft.path.tip), (
        "no block was divided: this test would show nothing"
    )
    dome.ViewObject.hide()
    tree_row(path.Label)
    press("FiveAxis_Annotate", 500)
    until(lambda: shown_pixels("divided", path, "ColourGood") > 300, 30000, "the path")
    tree_row(path.Label)
    press("FiveAxis_Play", 800)
    click(field("worst"))
    until(lambda: str(path.WorstLine) in field("line").text(), 20000, "the worst block")
    before = picture(screenshot("divided-play"))
    for _ in range(3):
        click(field("forward"))

    def moved():
        return int((abs(before - picture(screenshot("divided-later"))).max(axis=2) > 40).sum())

    until(lambda: moved() > 50, 30000, "the tool elsewhere")
    panel_button("Close")
    panel_closed()
    assert path.Blocks == len(figures.program.words)


@pytest.fixture
def shown_pixels(pixels, screenshot, view_box):
    """shown_pixels(name, obj, colour): how many pixels of the view have that colour of the object's view."""

    def count(name, obj, colour):
        wanted = [round(255 * part) for part in tuple(getattr(obj.ViewObject, colour))[:3]]
        return pixels(screenshot(name), wanted, 24, view_box())

    return count
