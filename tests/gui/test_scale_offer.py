# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part that is smaller than the cutter: the panel offers to scale it, and Cancel takes that back."""

import FreeCADGui
import pytest
from conftest import QtWidgets

from freecad_fiveaxis.gui.panels import toolpath

COARSE = {"passes": "planes", "cutter": "ball:6:30", "stepover": 6.0}


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
    doc, tiny, unit, size, click, pump, panel_button, screenshot, until, panel_closed
):
    panel = toolpath.create(tiny)
    assert not button(unit).isVisible()
    calculated(panel, pump)
    until(lambda: button(unit).isVisible(), 20000, "the offer")
    if unit == "metres":
        screenshot("scale_offer")
    click(button(unit))
    until(lambda: length(doc.Toolpath) == pytest.approx(size, rel=1e-5), 60000, f"a part of {size} mm")
    until(lambda: not tiny.ViewObject.Visibility, 20000, "the tiny part hidden")
    pump(700)
    until(
        lambda: button(unit).isVisible() is (size < 6.0),
        20000,
        "an offer only where 2 mm are still less than the cutter",
    )
    panel_button("OK")
    panel_closed()
    assert sorted(one.Label for one in doc.Objects) == [
        "Tessellation",
        "Tiny",
        f"Tiny x {'1000' if size > 6 else '25.4'}",
        "Toolpath",
    ]
    doc.undo()
    assert [one.Name for one in doc.Objects] == ["Tiny"] and tiny.ViewObject.Visibility


def test_cancel_takes_the_scale_back_from_a_path_that_was_there(
    doc, tiny, click, pump, panel_button, until, panel_closed
):
    calculated(toolpath.create(tiny), pump)
    panel_button("OK")
    panel_closed()
    before, zero = length(doc.Toolpath), tuple(doc.Toolpath.WorkZero)
    panel = toolpath.edit(doc.Toolpath)
    pump(300)
    until(lambda: button("metres").isVisible(), 20000, "the offer")
    click(button("metres"))
    until(lambda: length(doc.Toolpath) == pytest.approx(1000 * before, rel=1e-5), 60000, "a part in metres")
    until(lambda: panel.obj.Blocks > 0, 60000, "a path over it")
    panel_button("Cancel")
    panel_closed()
    assert (
        length(doc.Toolpath) == before
        and tuple(doc.Toolpath.WorkZero) == zero
        and doc.Toolpath.Mesh.Base[0] is tiny
    )
    assert not [one for one in doc.Objects if one.Name.startswith("Scaled")]
