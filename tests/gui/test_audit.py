# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an audit proposes what was posted from the document, and compares it with the solid on the
screen."""

import os

import pytest
from test_clicks import look

from freecad_fiveaxis import app
from freecad_fiveaxis.gui.panels import audit

pytestmark = pytest.mark.usefixtures("kept")
COARSE = {"passes": "planes", "cutter": "ball:6:30", "stepover": 6.0, "spindle": 9000}
MACHINE = {
    "machine": "trunnion_bc",
    "controller": "fanuc",
    "tolerance": 0.02,
    "origin": (0, 0, 50),
    "work_zero": (0, 0, 20),
}


@pytest.fixture
def dome(doc):
    part = doc.addObject("Part::Sphere", "Dome")
    part.Radius, part.Angle1 = 20, 0
    doc.recompute()
    look(doc)
    return part


@pytest.fixture
def posted(dome, doc, tmp_path):
    """Two tool paths, each with its file; that of the first one is the newest."""
    first = app.create_toolpath(doc, dome, holder="30x40", **COARSE, **MACHINE)
    second = app.create_toolpath(doc, dome, machine="trunnion_ac", **COARSE)
    for age, (path, name) in enumerate(((first, "first.nc"), (second, "second.ngc"))):
        app.post_process(path, tmp_path / name)
        os.utime(tmp_path / name, (1e9 - age, 1e9 - age))
    doc.clearUndos()
    return first, second


def read_message(panel):
    return panel.options.read_values()


def test_the_newest_posted_program_its_machine_its_tool_and_its_solid_are_proposed(
    posted, doc, dome, tmp_path, press, field, until, click, panel_button, panel_closed, screenshot
):
    press("FiveAxis_Audit")
    until(lambda: field("nc_file").text() == str(tmp_path / "first.nc"), 20000, "the newest file proposed")
    assert field("machine").currentText() == "trunnion_bc" and field("part").currentText() == "Dome"
    screenshot("audit_proposed")
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
    screenshot("audit_with_part")
    panel_button("OK", 500)
    panel_closed()
    result = doc.Audit
    assert result.Part is dome and result.NCFile == str(tmp_path / "first.nc") and doc.UndoCount == 1
    assert (result.Machine, result.Controller, result.Tolerance.Value) == ("trunnion_bc", "fanuc", 0.02)
    assert tuple(result.Origin) == (0, 0, 50) and tuple(result.WorkZero) == (0, 0, 20)
    assert result.CutterDiameter.Value == 6 and result.Holder == "30x40"
    assert not any("too deep" in text for text in result.Findings), (
        "where it is milled, the program fits the solid"
    )


def test_of_a_selected_path_its_own_file_is_proposed(
    posted, tmp_path, tree_row, press, field, until, panel_button
):
    tree_row(posted[1].Label)
    press("FiveAxis_Audit")
    until(
        lambda: field("nc_file").text() == str(tmp_path / "second.ngc"),
        20000,
        "the file of the selected path",
    )
    assert field("machine").currentText() == "trunnion_ac"
    panel_button("Cancel")


def test_a_file_that_is_gone_is_not_proposed(posted, doc, tmp_path):
    (tmp_path / "first.nc").unlink()
    panel = audit.create(doc)
    assert (
        read_message(panel)["nc_file"] == str(tmp_path / "second.ngc")
        and read_message(panel)["machine"] == "trunnion_ac"
    )
    panel.reject()
    (tmp_path / "second.ngc").unlink()
    panel = audit.create(doc)
    assert read_message(panel)["nc_file"] == "" and read_message(panel)["part"] is None
    panel.reject()
    panel = audit.create(doc, [posted[0]])
    assert read_message(panel)["nc_file"] == "" and read_message(panel)["machine"] == "trunnion_bc", (
        "what the path says without a file"
    )
    panel.reject()


def test_what_the_user_typed_stays_whatever_he_chooses_next(
    posted, doc, dome, tmp_path, field, type_into, choose, until, pump
):
    (tmp_path / "own.nc").write_text("G21 G90 G94\nG1 X0 Y0 Z0 A0 C0 F500\nM2\n")
    panel = audit.create(doc)
    pump(300)
    type_into(field("nc_file"), str(tmp_path / "own.nc"))
    choose(field("part"), "none, or a file")
    choose(field("machine"), "trunnion_ac")
    choose(field("part"), "Dome")
    assert (
        read_message(panel)["nc_file"] == str(tmp_path / "own.nc")
        and read_message(panel)["machine"] == "trunnion_ac"
    )
    assert read_message(panel)["part"] is dome
    panel.reject()


def test_solids_and_meshes_can_be_chosen_and_a_part_in_place_of_a_file(
    doc, dome, posted, pump, until, field, choose
):
    panel = audit.create(doc)
    pump(300)
    listed = [field("part").itemText(at) for at in range(field("part").count())]
    assert listed == ["none, or a file", "Dome"], "not the tessellations of the paths"
    assert panel.options.rows["against"][0].isHidden()
    choose(field("part"), "none, or a file")
    until(field("against").isVisible, 20000, "the file to compare with")
    panel.reject()


def test_another_solid_puts_the_audit_out_of_date_and_its_panel_keeps_the_part(
    doc, dome, posted, pump, until, field
):
    result = app.audit(
        doc,
        doc.NCOutput.File,
        "trunnion_bc",
        part=dome,
        controller="fanuc",
        work_zero=(0, 0, 20),
        cutter="ball:6:30",
    )
    before = result.Fingerprint
    dome.Radius = 22
    doc.recompute()
    assert result.Fingerprint != before and any("too deep into the part" in text for text in result.Findings)
    panel = audit.edit(result)
    pump(300)
    assert read_message(panel)["part"] is dome and not panel.stale
    panel.options.fields["part"].show_value(None)
    assert panel.stale and panel.calculate() and result.Part is None
    panel.reject()
    assert result.Part is dome


def test_the_cutter_that_the_chosen_program_names_is_shown_and_taken_until_one_is_typed(
    doc, dome, tmp_path, field, type_into, choose, click, until, pump
):
    for name, head in (("six", "(BALL 6 MM)\n"), ("none", "")):
        (tmp_path / f"{name}.nc").write_text(f"G21 G90 G94\n{head}G1 X0 Y0 Z50 A0 C0 F500\nG1 X9\nM2\n")

    def shown():
        return panel.options.fields["cutter"].sizes["diameter"].value()

    panel = audit.create(doc)
    pump(300)
    choose(field("part"), "Dome")
    type_into(field("nc_file"), str(tmp_path / "six.nc"))
    until(lambda: shown() == 6, 20000, "the diameter of the program's cutter")
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
    assert panel.obj.CutterFromProgram and panel.obj.CutterDiameter.Value == 6
    assert any("the one that the program names is taken" in text for text in panel.obj.Findings)
    type_into(field("nc_file"), str(tmp_path / "none.nc"))
    until(lambda: shown() == 10, 20000, "the diameter of before")
    type_into(field("cutter_diameter"), "8 mm")
    type_into(field("nc_file"), str(tmp_path / "six.nc"))
    pump(300)
    assert shown() == 8, "what the user typed stays"
    click(field("calculate"))
    until(lambda: "<table>" in field("summary").text(), 60000, "a summary")
    assert not panel.obj.CutterFromProgram and panel.obj.CutterDiameter.Value == 8
    panel.reject()
