# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of files to write: a name that is typed without a folder goes into the folder that is proposed, and
the field shows where the file is."""

import os

import pytest

from freecad_fiveaxis.app import machines
from freecad_fiveaxis.gui.panels.files import SaveField, new_machine
from freecad_fiveaxis.gui.panels.post import PostPanel


@pytest.fixture
def show(window, pump):
    """show(widget): in a window of its own."""
    shown = []

    def place(widget):
        widget.resize(400, 60)
        widget.show()
        widget.activateWindow()
        shown.append(widget)
        pump(100)

    yield place
    for widget in shown:
        widget.close()


def test_a_name_without_a_folder_goes_into_the_proposed_one(show, tmp_path):
    field = SaveField("nc_file", "", "")
    field.propose(str(tmp_path / "first.ngc"))
    show(field.editor)
    for typed, path in (
        ("mine.ngc", tmp_path / "mine.ngc"),
        (os.path.join("deep", "mine.ngc"), tmp_path / "deep" / "mine.ngc"),
        (str(tmp_path.parent / "a.ngc"), tmp_path.parent / "a.ngc"),
    ):
        field.editor.setText(typed)
        assert field.value() == str(path)
        field.editor.editingFinished.emit()
        assert field.editor.text() == str(path)
    field.propose(str(tmp_path / "second.ngc"))
    assert field.value() == str(tmp_path.parent / "a.ngc"), "the user's own name stays"


def test_a_machine_file_goes_into_the_folder_of_the_user_before_any_is_proposed(window):
    field = new_machine()
    field.show_value("mine.fcm")
    assert field.value() == str(machines.user_folder() / "mine.fcm")


def test_the_nc_file_goes_into_the_folder_of_the_document(planned_path, show, type_into, tmp_path, pump):
    panel = PostPanel(planned_path)
    show(panel.form)
    panel.form.resize(500, 400)
    type_into(panel.file.editor, "mine.ngc")
    pump(50)
    assert panel.file.editor.text() == str(tmp_path / "mine.ngc") == panel._nc_path()
    panel.reports["html"].setChecked(True)
    assert panel._report_paths() == {"html": str(tmp_path / "mine.html")}


@pytest.fixture
def planned_path(dome, doc, tmp_path):
    from freecad_fiveaxis import app

    doc.saveAs(str(tmp_path / "part.FCStd"))
    return app.create_toolpath(
        doc, dome, machine="trunnion_ac", cutter="ball:10", stepover=5.0, spindle=8000.0
    )


def test_what_was_written_is_shown_until_something_else_is_proposed(window, tmp_path):
    field = SaveField("machine_file", "", "", new=True)
    field.propose(str(tmp_path / "one.fcm"))
    field.show_value(str(tmp_path / "other.fcm"))
    field.show_written(str(tmp_path / "other.fcm"))
    assert field.value() == str(tmp_path / "other.fcm") and not field.says("error")
    field.propose(str(tmp_path / "two.fcm"))
    assert field.value() == str(tmp_path / "two.fcm")
