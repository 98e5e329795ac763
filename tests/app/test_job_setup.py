# SPDX-License-Identifier: LGPL-2.1-or-later
"""A Setup is shared by toolpaths: they take its values, follow its changes, and keep them when it goes."""

import pytest
from conftest import FAST

from freecad_fiveaxis import app
from freecad_fiveaxis.app import job_setup, results
from freecad_fiveaxis.core.base.errors import MachineError, SettingsError

OWN = {name: value for name, value in FAST.items() if name not in (*job_setup.OPTIONS, "work_zero")} | {
    "stepover": 8
}
GIVEN = {
    "machine": "fork_head_bc", "controller": "fanuc", "origin": (1, 2, 3), "tool_length": 120, "work_offset": "G55",
    "work_zero": (0, 0, 5),
}  # fmt: skip

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def setup(doc):
    doc.UndoMode = 1
    return app.create_setup(doc, **GIVEN)


def shared(obj):
    return [obj.Machine, obj.Controller, tuple(obj.Origin), obj.OriginFromMachine, obj.ToolLength.Value, obj.WorkOffset,
            tuple(obj.WorkZero)]  # fmt: skip


def test_a_path_takes_what_its_setup_says_and_makes_the_same_program_as_with_the_values_themselves(
    doc, ball, setup, anew
):
    path = app.create_toolpath(doc, ball, setup=setup, **OWN)
    assert shared(path) == shared(setup) == ["fork_head_bc", "fanuc", (1, 2, 3), False, 120, "G55", (0, 0, 5)]
    anew()
    alone = app.create_toolpath(doc, ball, setup=None, **OWN, **GIVEN)
    assert (
        alone.Setup is None and results.nc_of(path) == results.nc_of(alone) and path.State == ["Up-to-date"]
    )


def test_the_only_setup_is_taken_unless_something_of_the_kind_is_given(doc, ball, setup):
    assert app.create_toolpath(doc, ball, **OWN).Setup is setup
    assert app.create_toolpath(doc, ball, **OWN, machine="trunnion_ac").Setup is None
    other = app.create_setup(doc)
    assert other.Machine == "trunnion_ac" and app.create_toolpath(doc, ball, **OWN).Setup is None, (
        "which of the two?"
    )


def test_a_change_of_the_setup_is_a_change_of_its_paths(doc, ball, setup):
    one, two = (app.create_toolpath(doc, ball, setup=setup, **OWN) for _ in range(2))
    blocks = results.nc_of(one)
    setup.Machine, setup.WorkOffset = "trunnion_ac", "G54"
    assert one.Machine == two.Machine == "trunnion_ac" and "Touched" in one.State
    doc.recompute()
    assert results.nc_of(one) == results.nc_of(two) != blocks and one.State == ["Up-to-date"]
    assert "ReadOnly" in one.getEditorMode("Machine")


def test_undo_takes_the_paths_back_too(doc, ball, setup):
    path = app.create_toolpath(doc, ball, setup=setup, **OWN)
    doc.openTransaction("change")
    setup.Machine = "trunnion_ac"
    doc.commitTransaction()
    doc.undo()
    assert setup.Machine == path.Machine == "fork_head_bc"
    doc.redo()
    assert setup.Machine == path.Machine == "trunnion_ac"


def test_a_path_keeps_its_values_when_the_setup_is_deleted(doc, ball, setup):
    path = app.create_toolpath(doc, ball, setup=setup, **OWN)
    before = shared(path)
    doc.openTransaction("delete")
    doc.removeObject(setup.Name)
    doc.commitTransaction()
    assert path.Setup is None and shared(path) == before and path.getEditorMode("Machine") == []
    doc.undo()
    assert path.Setup is doc.Setup and "ReadOnly" in path.getEditorMode("Machine")


def test_it_survives_the_file_and_a_copy(doc, ball, setup, reopen):
    path = app.create_toolpath(doc, ball, setup=setup, **OWN)
    name = path.Name
    new = reopen(doc)
    path, setup = new.getObject(name), new.Setup
    assert (
        path.Setup is setup and shared(path) == shared(setup) and "ReadOnly" in path.getEditorMode("Machine")
    )
    setup.ToolLength = 130
    assert path.ToolLength.Value == 130
    copy = new.copyObject(path, False)
    assert copy.Setup is setup and copy.ToolLength.Value == 130
    setup.ToolLength = 140
    assert copy.ToolLength.Value == path.ToolLength.Value == 140


def test_a_recommended_work_zero_goes_to_the_setup_and_so_to_all_its_paths(doc, ball):
    setup = app.create_setup(doc, machine="trunnion_ac")
    one, two = (app.create_toolpath(doc, ball, setup=setup, **OWN) for _ in range(2))
    found = app.setup_map(one, region=(20, 20, 0), grid=(3, 3, 1))
    app.apply_setup(found)
    assert tuple(setup.Origin) == tuple(one.Origin) == tuple(two.Origin) == tuple(found.Recommended)


def test_what_cannot_be_used_leaves_no_setup(doc):
    with pytest.raises(MachineError, match="trunnion_ac"):
        app.create_setup(doc, machine="trunion_ac")
    with pytest.raises(SettingsError):
        app.create_setup(doc, tool_length=-1)
    assert doc.Objects == []


def test_an_older_path_has_no_setup_and_opens(doc, ball, reopen):
    path = app.create_toolpath(doc, ball, **OWN)
    assert path.removeProperty("Setup")
    again = reopen(doc).Toolpath
    assert again.Setup is None and again.getEditorMode("Machine") == []
