# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes from guide to guide and about an axis, chosen in the panel: each choice asks for what it needs, and
is computed."""

from pathlib import Path

import FreeCAD
import pytest

from freecad_fiveaxis.gui.panels import toolpath

FOUR_AXES = str(Path(__file__).parents[2] / "examples" / "mill_xyza.fcm")
COARSE = {"cutter": "ball:6", "scallop": 0.1, "max_axis_angle": 50.0, "tool_axis": "facet_mean"}
WANTED = {
    "frames": {"frames", "within_frames"}, "scallop": {"from_"}, "morph": {"from_", "to", "direction"}, "radial": {"pass_centre", "pass_axis"}, "planes": {"direction"},
    "rotary": {"pass_centre", "pass_axis", "rotary_by"},
}  # fmt: skip


@pytest.fixture
def ball(doc):
    result = doc.addObject("Part::Sphere", "Knob")
    result.Radius = 12
    doc.recompute()
    return result


def test_each_choice_of_passes_asks_for_what_it_needs(ball, pump, unfold):
    panel = toolpath.create(ball)
    pump(200)
    unfold()
    for passes, wanted in WANTED.items():
        panel.options.show_options({"passes": passes})
        pump(100)
        shown = {
            name for name in set().union(*WANTED.values()) if panel.options.fields[name].editor.isVisible()
        }
        assert shown == wanted, passes
    panel.reject()


@pytest.mark.parametrize("passes", ["morph", "radial"])
def test_passes_that_are_corrected_are_computed_and_edited_again(ball, pump, unfold, screenshot, passes):
    panel = toolpath.create(ball)
    panel.options.show_options({**COARSE, "passes": passes})
    pump(200)
    unfold()
    assert panel.calculate()
    pump(600)
    screenshot(f"passes_{passes}")
    path = panel.obj
    assert path.PassStrategy == passes and path.Passes > 10
    assert panel.accept()
    pump(200)
    again = toolpath.edit(path)
    pump(200)
    unfold()
    assert again.options.fields["passes"].value() == passes
    if passes == "radial":
        again.options.show_options({"pass_centre": "4,0,0"})
        assert again.calculate() and path.PassCentre == "4,0,0"
    else:
        again.options.show_options({"to": "nowhere"})
        assert not again.calculate() and path.Passes > 10, "what cannot be used is said, and nothing is lost"
    screenshot(f"passes_{passes}_edited")
    assert again.reject()


def test_a_boundary_asks_along_what_and_by_what_and_holds_the_passes(
    ball, pump, unfold, screenshot, tmp_path
):
    panel, more = toolpath.create(ball), ("boundary_axis", "boundary_by")
    panel.options.show_options({**COARSE, "passes": "planes"})
    pump(200)
    unfold()
    assert not any(panel.options.fields[name].editor.isVisible() for name in more)
    curve = tmp_path / "square.csv"
    curve.write_text("-4,-4,0\n4,-4,0\n4,4,0\n-4,4,0\n-4,-4,0\n")
    panel.options.show_options({"boundary": str(curve)})
    pump(200)
    assert all(panel.options.fields[name].editor.isVisible() for name in more)
    assert panel.calculate()
    pump(600)
    screenshot("passes_boundary")
    path = panel.obj
    assert (
        path.Boundary == str(curve) and tuple(path.BoundaryAxis) == (0, 0, 1) and path.BoundaryBy == "contact"
    )
    less = path.CutLength
    assert panel.accept()
    again = toolpath.edit(path)
    pump(200)
    unfold()
    assert again.options.fields["boundary"].value() == str(curve)
    again.options.show_options({"boundary_by": "centre"})
    assert again.calculate() and path.BoundaryBy == "centre" and path.CutLength < less
    curve.write_text("-4,-4,0\n4,-4,0\n4,4,0\n")
    assert not again.calculate(), "a curve that is open is said"
    assert again.reject()


def test_steep_and_shallow_is_requested_but_for_level_planes_and_is_off_where_empty(
    ball, pump, unfold, screenshot
):
    panel = toolpath.create(ball)
    panel.options.show_options({**COARSE, "passes": "planes"})
    pump(200)
    unfold()
    steep = panel.options.fields["steep_shallow"]
    assert steep.editor.isVisible() and steep.editor.text() == "off" and steep.value() is None
    assert panel.calculate()
    pump(600)
    plain = panel.obj.CutLength.Value
    panel.options.show_options({"steep_shallow": 30})
    assert panel.calculate()
    pump(600)
    screenshot("passes_steep_shallow")
    path = panel.obj
    assert path.SteepShallow.Value == 30 and path.CutLength.Value != plain
    panel.options.show_options({"passes": "zlevel"})
    pump(200)
    assert not steep.editor.isVisible(), "level planes are not divided from themselves"
    panel.options.show_options({"passes": "planes"})
    assert panel.accept()
    again = toolpath.edit(path)
    pump(200)
    unfold()
    assert again.options.fields["steep_shallow"].value() == 30
    assert again.reject()


def test_frames_are_computed_with_as_many_as_may_be(ball, pump, unfold, screenshot):
    panel = toolpath.create(ball)
    panel.options.show_options({"cutter": "ball:6", "scallop": 0.2, "passes": "frames", "frames": 2})
    pump(200)
    unfold()
    assert panel.calculate()
    pump(600)
    screenshot("passes_frames")
    path = panel.obj
    assert path.PassStrategy == "frames" and path.Frames == 2 and path.ToolAxis == "auto"
    codes = {one.code: one for one in path.Proxy.last.result.findings}
    assert codes["frames"].value == 2 and "outside-frames" in codes
    length = path.CutLength.Value
    assert not panel.options.fields["direction"].editor.isVisible()
    panel.options.show_options({"within_frames": "planes"})
    pump(200)
    assert panel.options.fields["direction"].editor.isVisible()
    assert panel.calculate() and path.WithinFrames == "planes" and path.CutLength.Value != length
    pump(600)
    screenshot("passes_frames_planes")
    panel.options.show_options({"passes": "scallop"})
    pump(200)
    assert not panel.options.fields["direction"].editor.isVisible(), (
        "planes in frames count where there are frames"
    )
    panel.options.show_options({"passes": "frames"})
    assert panel.accept()


def test_rotary_passes_take_the_tool_axis_and_the_machines_axis(doc, pump, unfold, screenshot):
    """On a machine of four axes the tool points at its rotary axis by itself, and spirals make one helix of
    the rings."""
    result = doc.addObject("Part::Cylinder", "Shaft")
    result.Radius, result.Height = 6, 20
    result.Placement.Rotation = FreeCAD.Rotation(FreeCAD.Vector(0, 1, 0), 90)
    doc.recompute()
    panel = toolpath.create(result)
    panel.options.show_options(
        {"machine": FOUR_AXES, "cutter": "ball:6", "scallop": 0.1, "passes": "rotary", "spiral": "on"}
    )
    pump(200)
    unfold()
    assert panel.options.fields["tool_axis"].value() == "from_axis"
    assert panel.calculate()
    pump(600)
    screenshot("passes_rotary")
    path = panel.obj
    assert path.PassStrategy == "rotary" and path.RotaryBy == "around" and path.Passes == 1
    assert panel.accept()
