# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of fixtures in the panels of a tool path and an audit: ticked by mouse, kept, shown when it is
edited, taken back by undo."""

import contextlib

import FreeCAD
import pytest
from conftest import QtCore

from freecad_fiveaxis.gui.panels import audit, toolpath

COARSE = {
    "passes": "planes",
    "cutter": "ball:6",
    "stepover": 2.0,
    "max_axis_angle": 30.0,
    "tool_length": 120.0,
}


@pytest.fixture
def parts(doc):
    result = [doc.addObject("Part::Box", name) for name in ("Plate", "Clamp")]
    for one, size, low in zip(result, ((30, 20, 10), (10, 7, 25)), ((0, 0, 0), (10, -8, 0)), strict=True):
        one.Length, one.Width, one.Height = size
        one.Placement.Base = FreeCAD.Vector(*low)
    doc.recompute()
    return result


def tick(editor, row, click, until):
    """Click the square of a row once it stands still, for the groups that were unfolded move it; wait until
    it is turned."""
    before, seen = editor.item(row).checkState(), []

    def at_rest():
        item = editor.item(row)
        editor.scrollToItem(item)
        seen.append(editor.viewport().mapToGlobal(editor.visualItemRect(item).center()))
        return editor.visualItemRect(item).isValid() and seen[-2:-1] == seen[-1:]

    for _ in range(4):  # a click beside it, where the panel is laid out anew at that moment, turns nothing
        until(at_rest, 20000, "a row that stands still")
        rect = editor.visualItemRect(editor.item(row))
        click(editor.viewport(), QtCore.QPoint(rect.left() + 10, rect.center().y()))
        with contextlib.suppress(TimeoutError):
            until(lambda: editor.item(row).checkState() != before, 3000, "the row turned")
            return
    raise TimeoutError("the row never turned")


def labels(editor):
    return [editor.item(row).text() for row in range(editor.count())]


def test_a_clamp_is_ticked_and_the_path_goes_around_it(doc, parts, pump, click, unfold, screenshot, until):
    part, clamp = parts
    panel = toolpath.create(part)
    panel.options.show_options(COARSE)
    pump(300)
    unfold()
    editor = panel.options.fields["fixtures"].editor
    assert labels(editor) == ["Clamp"], "the part itself is none"
    tick(editor, 0, click, until)
    assert panel.options.fields["fixtures"].words() == "Clamp"
    screenshot("fixtures_ticked")
    assert panel.calculate()
    pump(600)
    screenshot("fixtures_panel")
    path = panel.obj
    assert path.Fixtures == [clamp]
    assert panel.accept()
    pump(200)

    again = toolpath.edit(path)
    pump(300)
    unfold()
    assert again.options.fields["fixtures"].value() == [clamp]
    assert labels(again.options.fields["fixtures"].editor) == ["Clamp"]
    tick(again.options.fields["fixtures"].editor, 0, click, until)
    assert again.calculate() and not path.Fixtures
    assert again.reject()
    pump(200)
    assert path.Fixtures == [clamp], "Cancel takes it back"


def test_without_another_solid_the_list_says_so(doc, parts, pump, unfold):
    part, clamp = parts
    doc.removeObject(clamp.Name)
    panel = toolpath.create(part)
    pump(300)
    unfold()
    pump(100)
    field = panel.options.fields["fixtures"]
    assert field.value() == [] and "no other solid" in field.note.text()
    panel.reject()


def test_an_audit_has_a_clamp_ticked_and_says_what_hits_it(
    doc, parts, tmp_path, pump, click, unfold, screenshot, until
):
    _, clamp = parts
    program = tmp_path / "given.ngc"
    program.write_text("G21 G90 G94\nG1 X15 Y-30 Z40 A0 C0 F2000\nG1 X15 Y-30 Z20\nG1 X15 Y20 Z20\nM2\n")
    panel = audit.create(doc)
    panel.options.show_options(
        {"nc_file": str(program), "machine": "trunnion_ac", "cutter": "flat:6:30", "part": clamp}
    )
    pump(300)
    unfold()
    field = panel.options.fields["fixtures"]
    assert labels(field.editor) == ["Plate", "Clamp"]
    tick(field.editor, 1, click, until)
    assert not panel.calculate() and "the part to compare with" in panel.options.error.text()
    panel.options.fields["part"].show_value(None)
    assert panel.calculate()
    pump(600)
    screenshot("fixtures_audit")
    result = panel.obj
    assert result.Fixtures == [clamp] and any("into the fixture Clamp" in text for text in result.Findings)
    assert panel.accept()
    pump(200)

    again = audit.edit(result)
    pump(300)
    unfold()
    assert again.options.fields["fixtures"].value() == [clamp]
    tick(again.options.fields["fixtures"].editor, 1, click, until)
    assert again.calculate() and not result.Fixtures
    assert not any("fixture Clamp" in text for text in result.Findings), "what was told is the clamp's"
    assert again.reject()
    pump(200)
    assert result.Fixtures == [clamp], "Cancel takes it back"
