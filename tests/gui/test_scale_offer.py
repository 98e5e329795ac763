# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part that is smaller than the cutter: the panel offers to scale it, and Cancel takes that back."""

import FreeCADGui
import pytest
from conftest import QtWidgets

from freecad_fiveaxis.gui.panels import toolpath

COARSE = {"cutter": "ball:6:30", "stepover": 6.0}


@pytest.fixture
def tiny(doc):
    """A box of 0.08 x 0.06 x 0.04: 80 mm long where it was meant in metres."""
    part = doc.addObject("Part::Box", "Tiny")
    part.Length, part.Width, part.Height = 0.08, 0.06, 0.04
    doc.recompute()
    doc.clearUndos()
    return part


def button(unit):
    return FreeCADGui.getMainWindow().findChild(QtWidgets.QWidget, f"scale_{unit}")


def length(path):
    return path.Mesh.Mesh.BoundBox.XLength


def calculated(opened, pump):
    opened.options.show_options(COARSE)
    pump(300)
    assert opened.calculate()
    pump(200)
    return opened


@pytest.mark.parametrize(("unit", "size"), [("metres", 80.0), ("inches", 2.032)])
def test_a_tiny_part_is_scaled_by_one_click_and_it_is_one_step_of_undo(
    doc, tiny, unit, size, click, pump, panel_button, screenshot
):
    panel = toolpath.create(tiny)
    assert not button(unit).isVisible()
    calculated(panel, pump)
    assert button(unit).isVisible()
    if unit == "metres":
        screenshot("scale_offer")
    click(button(unit))
    pump(700)
    assert length(doc.Toolpath) == pytest.approx(size, rel=1e-5) and not tiny.ViewObject.Visibility
    assert button(unit).isVisible() is (size < 6.0)  # 2 mm are still less than the cutter
    panel_button("OK")
    assert sorted(one.Label for one in doc.Objects) == [
        "Tessellation",
        "Tiny",
        f"Tiny x {'1000' if size > 6 else '25.4'}",
        "Toolpath",
    ]
    doc.undo()
    assert [one.Name for one in doc.Objects] == ["Tiny"] and tiny.ViewObject.Visibility


def test_cancel_takes_the_scale_back_from_a_path_that_was_there(doc, tiny, click, pump, panel_button):
    calculated(toolpath.create(tiny), pump)
    panel_button("OK")
    before, zero = length(doc.Toolpath), tuple(doc.Toolpath.WorkZero)
    panel = toolpath.edit(doc.Toolpath)
    pump(300)
    assert button("metres").isVisible()
    click(button("metres"))
    pump(700)
    assert length(doc.Toolpath) == pytest.approx(1000 * before, rel=1e-5) and panel.obj.Blocks > 0
    panel_button("Cancel")
    assert length(doc.Toolpath) == before and tuple(doc.Toolpath.WorkZero) == zero and doc.Toolpath.Mesh.Base[0] is tiny
    assert not [one for one in doc.Objects if one.Name.startswith("Scaled")]
