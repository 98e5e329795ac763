# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC files: whole or not at all, never over a user's file unasked, and marked when the toolpath has
changed."""

import os

import FreeCAD
import pytest
from conftest import PLAIN, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app.nc_output import NCOutput, is_ours, out_of_date
from freecad_fiveaxis.app.results import nc_of
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.base.errors import Cancelled, FileError, FiveAxisError


@pytest.fixture
def toolpath(doc):
    dome = doc.addObject("Part::Sphere", "Dome")
    dome.Radius, dome.Angle1 = 10, 0
    doc.recompute()
    settings = {"cutter": "ball:6", "stepover": 5, "linear_deflection": 0.2, **PLAIN, **UNCURED}
    return app.create_toolpath(doc, dome, machine="trunnion_ac", **settings)


def test_the_file_holds_what_the_toolpath_makes(toolpath, tmp_path):
    obj = app.post_process(toolpath, tmp_path / "dome.ngc")
    assert (tmp_path / "dome.ngc").read_bytes() == nc_of(toolpath)
    assert isinstance(obj.Proxy, NCOutput)
    assert (obj.Path, obj.File, obj.UpToDate) == (toolpath, str(tmp_path / "dome.ngc"), True)
    assert obj in toolpath.InList and "Touched" not in obj.State


def test_a_users_file_is_left_alone(toolpath, tmp_path):
    path = tmp_path / "mine.ngc"
    path.write_text("my work of weeks")
    with pytest.raises(FileError, match=r"mine\.ngc exists"):
        app.post_process(toolpath, path)
    assert path.read_text() == "my work of weeks"
    assert not [
        obj
        for obj in toolpath.Document.Objects
        if isinstance(obj.Proxy if hasattr(obj, "Proxy") else None, NCOutput)
    ]


def test_a_users_file_is_replaced_where_requested(toolpath, tmp_path):
    path = tmp_path / "mine.ngc"
    path.write_text("old")
    app.post_process(toolpath, path, overwrite=True)
    assert path.read_bytes() == nc_of(toolpath)


def test_an_empty_file_is_replaced(toolpath, tmp_path):
    (tmp_path / "new.ngc").touch()
    assert app.post_process(toolpath, tmp_path / "new.ngc").UpToDate


def test_what_was_written_last_is_replaced_and_renews_its_object(toolpath, tmp_path):
    path, doc = tmp_path / "dome.ngc", toolpath.Document
    first = app.post_process(toolpath, path)
    before, written = path.read_bytes(), first.Written
    toolpath.Stepover = 4
    doc.recompute()
    assert app.post_process(toolpath, path) is first
    assert path.read_bytes() == nc_of(toolpath) != before
    assert first.Written != written and first.UpToDate


def test_what_was_written_and_then_edited_is_the_users(toolpath, tmp_path):
    path = tmp_path / "dome.ngc"
    app.post_process(toolpath, path)
    path.write_bytes(path.read_bytes() + b"(note of the operator)\n")
    assert not is_ours(toolpath.Document, path)
    with pytest.raises(FileError, match="exists"):
        app.post_process(toolpath, path)
    assert path.read_bytes().endswith(b"(note of the operator)\n")


def test_another_file_gets_another_object(toolpath, tmp_path):
    first, second = (app.post_process(toolpath, tmp_path / name) for name in ("one.ngc", "two.ngc"))
    assert first is not second and first.UpToDate and second.UpToDate


def test_a_changed_toolpath_marks_its_file(toolpath, tmp_path):
    obj = app.post_process(toolpath, tmp_path / "dome.ngc")
    toolpath.Stepover = 4
    toolpath.Document.recompute()
    assert not obj.UpToDate
    toolpath.Stepover = 5
    toolpath.Document.recompute()
    assert obj.UpToDate


def test_a_changed_solid_marks_the_file(toolpath, tmp_path):
    obj = app.post_process(toolpath, tmp_path / "dome.ngc")
    toolpath.Document.getObject("Dome").Radius = 12
    toolpath.Document.recompute()
    assert not obj.UpToDate


def test_a_setting_that_changes_no_byte_leaves_the_file_up_to_date(toolpath, tmp_path):
    obj = app.post_process(toolpath, tmp_path / "dome.ngc")
    toolpath.Tolerance = 0.5
    toolpath.Document.recompute()
    assert obj.UpToDate


def test_a_path_that_fails_marks_the_file_and_leaves_it(toolpath, tmp_path):
    obj = app.post_process(toolpath, tmp_path / "dome.ngc")
    before = (tmp_path / "dome.ngc").read_bytes()
    toolpath.Machine = "no such machine"
    toolpath.Document.recompute()
    assert not obj.UpToDate
    with pytest.raises(FiveAxisError, match="no such machine"):
        app.post_process(toolpath, tmp_path / "dome.ngc")
    assert (tmp_path / "dome.ngc").read_bytes() == before
    toolpath.Machine = "trunnion_ac"
    toolpath.Document.recompute()
    assert obj.UpToDate


@pytest.mark.parametrize("change", ["gone", "edited"])
def test_a_file_that_is_not_what_was_written_is_out_of_date(toolpath, tmp_path, change):
    obj = app.post_process(toolpath, tmp_path / "dome.ngc")
    (tmp_path / "dome.ngc").unlink() if change == "gone" else (tmp_path / "dome.ngc").write_text("edited")
    obj.touch()
    toolpath.Document.recompute()
    assert not obj.UpToDate


def test_out_of_date_says_why_at_any_time(toolpath, tmp_path):
    obj, doc = app.post_process(toolpath, tmp_path / "dome.ngc"), toolpath.Document
    assert out_of_date(obj) == ""
    toolpath.Stepover = 4
    assert "recompute" in out_of_date(obj)
    doc.recompute()
    assert "has changed since" in out_of_date(obj)
    app.post_process(toolpath, tmp_path / "dome.ngc")
    assert out_of_date(obj) == ""
    (tmp_path / "dome.ngc").write_text("edited")
    assert "changed by somebody else" in out_of_date(obj)
    (tmp_path / "dome.ngc").unlink()
    assert "post-process again" in out_of_date(obj)
    doc.removeObject(toolpath.Name)
    assert "deleted" in out_of_date(obj)


def test_a_folder_that_cannot_be_written_is_stated_before_the_long_work(toolpath, tmp_path, monkeypatch):
    monkeypatch.setattr("freecad_fiveaxis.app.results.nc_of", lambda *_: pytest.fail("worked for nothing"))
    closed = "/proc"  # where nobody writes, root neither
    if os.geteuid():
        closed = tmp_path / "closed"
        closed.mkdir(mode=0o555)
    with pytest.raises(FileError, match="cannot be written"):
        app.post_process(toolpath, f"{closed}/dome.ngc")
    with pytest.raises(FileError, match="does not exist"):
        app.post_process(toolpath, tmp_path / "no" / "dome.ngc")
    with pytest.raises(FileError, match="is a folder"):
        app.post_process(toolpath, tmp_path)


@pytest.mark.parametrize("kind", [None, "Part::Box"])
def test_what_is_no_toolpath_is_refused(doc, tmp_path, kind):
    with pytest.raises(SelectionError, match="select a toolpath"):
        app.post_process(kind and doc.addObject(kind, "Box"), tmp_path / "dome.ngc")
    assert list(tmp_path.iterdir()) == []


def test_esc_halfway_writes_nothing(toolpath, tmp_path, monkeypatch):
    def stopped(*_):
        raise Cancelled("stopped")

    monkeypatch.setattr("freecad_fiveaxis.app.results.nc_of", stopped)
    with pytest.raises(Cancelled):
        app.post_process(toolpath, tmp_path / "dome.ngc")
    assert list(tmp_path.iterdir()) == []


def test_it_survives_saving_and_opening(toolpath, tmp_path):
    """With the passes and axes of the default: what is saved gives the same bytes again."""
    doc, nc = toolpath.Document, tmp_path / "dome.ngc"
    toolpath.PassStrategy, toolpath.ToolAxis, toolpath.Stepover = "scallop", "auto", 8
    doc.recompute()
    app.post_process(toolpath, nc)
    doc.saveCopy(str(tmp_path / "dome.FCStd"))
    again = FreeCAD.openDocument(str(tmp_path / "dome.FCStd"))
    try:
        (obj,) = [one for one in again.Objects if isinstance(getattr(one, "Proxy", None), NCOutput)]
        assert obj.UpToDate and obj.File == str(nc) and "Touched" not in obj.State
        assert (
            app.post_process(obj.Path, nc) is obj
        )  # it still is ours, and the same solid and settings make the same bytes
        assert obj.UpToDate
    finally:
        FreeCAD.closeDocument(again.Name)


def test_undo_takes_the_object_back_in_one_step(toolpath, tmp_path):
    doc = toolpath.Document
    doc.UndoMode = 1
    count = len(doc.Objects)
    doc.openTransaction("Post-process")
    app.post_process(toolpath, tmp_path / "dome.ngc")
    doc.commitTransaction()
    doc.undo()
    assert len(doc.Objects) == count
    doc.redo()
    assert len(doc.Objects) == count + 1


def test_the_program_and_its_reports_are_written_all_or_none(toolpath, tmp_path):
    path, page = tmp_path / "dome.ngc", tmp_path / "dome.html"
    with pytest.raises(FileError, match="gone"):
        app.post_process(
            toolpath, path, also={str(page): b"page", str(tmp_path / "gone" / "dome.json"): b"{}"}
        )
    assert os.listdir(tmp_path) == []
    app.post_process(toolpath, path, also={str(page): b"page"})
    assert path.read_bytes() == nc_of(toolpath) and page.read_bytes() == b"page"
