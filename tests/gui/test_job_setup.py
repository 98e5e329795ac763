# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Setup by clicks: made by the command, taken by new paths, edited from their panel, shared out of one."""

import pytest
from conftest import QtWidgets

from freecad_fiveaxis import app
from freecad_fiveaxis.gui.panels import job_setup, toolpath

COARSE = {
    "passes": "planes",
    "cutter": "ball:6:30",
    "stepover": 6.0,
    "linear_deflection": 0.3,
    "angular_deflection": 30.0,
}


@pytest.fixture
def dome(doc):
    part = doc.addObject("Part::Sphere", "Dome")
    part.Radius, part.Angle1 = 20, 0
    doc.recompute()
    doc.clearUndos()
    return part


def answer(values, button="Ok"):
    """Who fills the dialog of a setup and presses that button."""

    def fill(dialog):
        dialog.options.show_options(values)
        dialog.findChild(QtWidgets.QDialogButtonBox).button(
            getattr(QtWidgets.QDialogButtonBox, button)
        ).click()

    return fill


def test_the_command_makes_a_setup_in_one_step_and_edits_it(doc, dome, press, modal, until):
    reported = modal(answer({"setup_name": "Vice", "machine": "trunnion_bc", "work_zero": (0, 0, 20)}))
    press("FiveAxis_JobSetup", 600)
    until(lambda: reported.texts == ["New setup"] and doc.UndoCount == 1, 20000, "a setup made in one step")
    assert (doc.Setup.Label, doc.Setup.Machine, doc.Setup.WorkZero.z) == ("Vice", "trunnion_bc", 20)
    reported = modal(answer({"machine": "trunnion_ac"}))
    press("FiveAxis_JobSetup", 600)
    until(
        lambda: doc.Setup.Machine == "trunnion_ac" and doc.UndoCount == 2,
        20000,
        "the setup edited in one step",
    )
    assert reported.texts == ["Edit setup Vice"]
    assert doc.Setup.WorkZero.z == 20
    reported = modal(answer({"machine": "fork_head_bc", "tool_length": 100}, "Cancel"))
    press("FiveAxis_JobSetup", 600)
    until(lambda: reported.texts, 20000, "the dialog")
    assert doc.Setup.Machine == "trunnion_ac" and doc.UndoCount == 2


def test_a_new_path_takes_the_setup_and_follows_what_is_edited_from_its_panel(
    doc, dome, modal, click, pump, screenshot, until
):
    setup = app.create_setup(
        doc, machine="trunnion_bc", controller="fanuc", work_zero=(0, 0, 20), work_offset="G55"
    )
    panel = toolpath.create(dome)
    panel.options.show_options(COARSE)
    pump(300)
    fields = panel.options.fields
    assert panel.options.groups["machine"].header.toolTip() == "Machine — Setup, trunnion_bc, Fanuc"
    assert not fields["machine"].editor.isEnabled() and fields["work_zero"].value() == [0, 0, 20]
    assert fields["work_zero"].note.text() == "From setup Setup"
    screenshot("panel_setup")
    assert panel.calculate() and panel.obj.Setup is setup and panel.obj.WorkOffset == "G55"
    modal(answer({"work_offset": "G56"}))
    click(panel.setup.browse)
    until(
        lambda: setup.WorkOffset == "G56" == fields["work_offset"].value() and panel.stale,
        20000,
        "the setup edited",
    )
    assert panel.calculate() and panel.obj.WorkOffset == "G56" and not panel.stale
    panel.reject()
    assert setup.WorkOffset == "G55" and doc.getObject("Toolpath") is None


def test_the_values_of_a_path_are_shared(doc, dome, modal, click, pump, until):
    panel = toolpath.create(dome)
    panel.options.show_options(COARSE | {"machine": "trunnion_bc"})
    pump(300)
    assert panel.setup.value() is None and panel.options.fields["machine"].editor.isEnabled()
    modal(answer({"setup_name": "Shared"}))
    click(panel.setup.browse)
    until(
        lambda: doc.getObject("Setup") and panel.setup.value() is doc.Setup,
        20000,
        "a setup of the panel's values",
    )
    assert doc.Setup.Machine == "trunnion_bc"
    assert panel.calculate()
    panel.step.keep()
    path = panel.obj
    panel.setup.editor.setCurrentIndex(0)
    until(panel.options.fields["machine"].editor.isEnabled, 20000, "a machine of the path's own")
    assert panel.calculate() and path.Setup is None and path.Machine == "trunnion_bc"
    panel.reject()
    assert path.Setup is doc.Setup


def test_boxes_that_count_for_nothing_are_not_shown(doc, dome, pump, screenshot, until):
    result = app.create_setup(doc, machine="trunnion_bc", work_zero=(0, 0, 20))
    dialog = job_setup.SetupDialog(doc, {"setup_name": result.Label} | job_setup.read_values(result), result)
    dialog.show()
    pump(300)
    origin = dialog.options.fields["origin"]
    assert origin.none.isChecked() and not any(part.editor.isVisible() for part in origin.parts), (
        "the machine's file says it"
    )
    assert all(part.editor.isVisible() for part in dialog.options.fields["work_zero"].parts)
    screenshot("setup_edit")
    origin.none.setChecked(False)
    until(lambda: all(part.editor.isVisible() for part in origin.parts), 20000, "three boxes to type into")
    assert origin.value() == [0, 0, 0]
    dialog.close()
    dialog.deleteLater()
