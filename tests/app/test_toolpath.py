# SPDX-License-Identifier: LGPL-2.1-or-later
"""The toolpath object: parametric, saved and copied, undone in one step; the same bytes as the command
line."""

import os
import subprocess
import sys

import FreeCAD
import numpy as np
import pytest
from conftest import FAST, PLAIN, ROOT, half_ball

from freecad_fiveaxis import app
from freecad_fiveaxis.app import long_work, results, wording
from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import Cancelled, FileError, FiveAxisError
from freecad_fiveaxis.core.machine import load_machine, save_machine
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report import summary

PYTHON = os.path.join(sys.exec_prefix, "bin", "python3")

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def path(doc, ball):
    return app.create_toolpath(doc, ball, **FAST)


def command_line(*words):
    """Run the command line here; what it computes is no result that was kept."""
    assert cli.main([str(word) for word in words]) < 2


def own_command_line(*words):
    """Run the command line in a process of its own, with FreeCAD's own Python."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [PYTHON, "-m", "freecad_fiveaxis", *map(str, words)], env=environment, capture_output=True, text=True
    )
    assert done.returncode < 2, done.stderr


def test_it_is_computed_and_shows_the_cores_figures(path):
    reported = summary(results.figures_of(path))
    assert path.State == ["Up-to-date"] and results.out_of_date(path) == ""
    shown = [path.Passes, path.Blocks, path.SingularBlocks, path.OverTolerance, path.WorstLine, path.Proven]
    wanted = [
        reported[name]
        for name in ("passes", "blocks", "singular_blocks", "over_tolerance", "worst_line", "proven")
    ]
    assert shown == wanted and path.Passes == 10 and path.Blocks > 100
    assert path.MaxSegmentDeviation.Value == reported["max_segment_deviation"] > 0
    assert path.MaxSurfaceDeviation.Value == reported["max_surface_deviation"] > 0
    assert path.MaxSurfaceBound.Value == reported["max_surface_bound"] >= path.MaxSurfaceDeviation.Value
    assert path.MaxLineDeviation.Value == reported["max_line_deviation"]
    assert path.MaxBound.Value == reported["max_bound"] >= path.MaxSegmentDeviation.Value
    assert path.CutLength.Value == reported["cut_length"] > 100
    assert getattr(path.Time, "Value", path.Time) == reported["time_s"] > 1
    assert (
        list(path.Findings)
        == [wording.localize(finding.text) for finding in results.figures_of(path).findings]
        and path.Findings
    )


@pytest.mark.parametrize(
    "settings",
    [
        {}, {"controller": "fanuc", "feed": "35in/min", "direction": 30, "scallop": 0.2, "stepover": None, "lead": 5},
        {"machine": "fork_head_bc", "tool_length": 150, "cutter": "ball:0.25in", "feed_mode": "g94"},
        {"cutter": "taperbull:8:1:7.5deg", "lead": 8, "gouge": "report", "holder": "40x25,63x50", "shank": "0.25inx20"},
        {"cutter": "flat:6", "lead": 10, "stepover": 8, "tolerance": 0.05, "gouge": "lift", "holder": "40x25"},
        {"cutter": "ball:10:20", "gouge": "leave-out", "holder": "80x40"},
    ],
)  # fmt: skip
def test_the_bytes_are_those_of_the_command_line(doc, ball, tmp_path, settings):
    options = {
        name: value
        for name, value in {**FAST, **settings}.items()
        if value is not None and name != "linear_deflection"
    }
    path = app.create_toolpath(doc, ball, linear_deflection=0.1, **options)
    app.tessellate(path.Mesh, tmp_path / "part.stl")
    words = [word for name, value in options.items() for word in ("--" + name.replace("_", "-"), value)]
    command_line("mill", tmp_path / "part.stl", *words, "--quiet", "-o", tmp_path / "cli.ngc")
    assert results.nc_of(path) == (tmp_path / "cli.ngc").read_bytes()
    app.post_process(path, tmp_path / "gui.ngc")
    assert (tmp_path / "gui.ngc").read_bytes() == (tmp_path / "cli.ngc").read_bytes()


def test_the_same_solid_tessellated_again_gives_the_same_bytes(doc, ball, tmp_path):
    app.tessellate(ball, tmp_path / "part.stl", linear_deflection=0.1)
    path = app.create_toolpath(doc, ball, **FAST)
    own_command_line(
        "mill",
        tmp_path / "part.stl",
        "--machine",
        "trunnion_ac",
        "--stepover",
        "4",
        "--passes",
        "planes",
        "--tool-axis",
        "facet_mean",
        "--quiet",
        "-o",
        tmp_path / "cli.ngc",
    )
    assert results.nc_of(path) == (tmp_path / "cli.ngc").read_bytes()


def test_the_work_zero_is_taken_off_the_mesh(doc, ball):
    plain, moved = (
        results.result_of(app.create_toolpath(doc, ball, **FAST, work_zero=zero)).draft
        for zero in ((0, 0, 0), "2,4,20")
    )
    np.testing.assert_allclose(moved.mesh.vertex, plain.mesh.vertex - (2, 4, 20), atol=4e-6)
    np.testing.assert_allclose(moved.path.tip.min(axis=0), plain.path.tip.min(axis=0) - (2, 4, 20), atol=1e-3)


def test_a_change_of_the_base_reaches_the_toolpath(doc):
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    path = app.create_toolpath(doc, box, machine="trunnion_ac", stepover=2, **PLAIN)
    before, facets = path.CutLength.Value, results.nc_of(path)
    box.Length = 20
    assert results.out_of_date(path) == "Box was changed: recompute the document"
    doc.recompute()
    assert path.Mesh.Mesh.BoundBox.XMax == pytest.approx(20)
    assert path.CutLength.Value > 1.15 * before and results.nc_of(path) != facets
    assert results.out_of_date(path) == "" and path.State == path.Mesh.State == ["Up-to-date"]


def test_a_change_of_a_setting_touches_and_recomputes(path):
    blocks = path.Blocks
    path.Stepover = 2
    assert "Touched" in path.State and "shows the result of other settings" in results.out_of_date(path)
    path.Document.recompute()
    assert path.State == ["Up-to-date"] and path.Blocks > 1.5 * blocks and path.Passes > 15


def test_a_change_of_the_deflection_makes_a_new_mesh_and_path(path):
    facets, mark = path.Mesh.Facets, path.Fingerprint
    path.Mesh.LinearDeflection = 0.4
    path.Document.recompute()
    assert path.Mesh.Facets < facets and path.Fingerprint != mark


def test_nothing_is_computed_twice(anew, path, monkeypatch):
    calls = []
    real = job.make
    monkeypatch.setattr(job, "make", lambda *given, **named: calls.append(1) or real(*given, **named))
    result = results.result_of(path)
    path.touch()
    path.Document.recompute()
    path.Mesh.Label = path.Label = "Another name"
    assert results.result_of(path) is result and results.out_of_date(path) == "" and not calls
    path.Stepover = 5
    path.Document.recompute()
    assert len(calls) == 1
    assert results.result_of(path) is not result and len(calls) == 1


def test_settings_that_cannot_be_used_mark_the_object_and_clear_the_numbers(path):
    path.Machine = "no_such_machine"
    path.Document.recompute()
    assert "Invalid" in path.State and "no machine is called 'no_such_machine'" in path.getStatusString()
    assert path.Blocks == 0 and not path.Proven and "no machine is called" in path.Findings[0]
    assert "no machine is called" in results.out_of_date(path)
    path.Machine = "trunnion_ac"
    path.Document.recompute()
    assert path.State == ["Up-to-date"] and path.Blocks > 100


def test_a_machine_file_that_vanished_is_reported(doc, ball, tmp_path):
    file = tmp_path / "mine.fcm"
    save_machine(load_machine("trunnion_ac"), file)
    path = app.create_toolpath(doc, ball, **{**FAST, "machine": str(file)})
    content = file.read_bytes()
    file.unlink()
    with pytest.raises(FileError, match=r"mine.fcm cannot be read.*choose another machine"):
        results.result_of(path)
    assert "mine.fcm" in results.out_of_date(path)
    path.touch()
    doc.recompute()
    assert "Invalid" in path.State and "choose another machine" in path.getStatusString()
    file.write_bytes(content)
    doc.recompute()
    assert path.State == ["Up-to-date"] and path.Blocks > 100


def test_a_machine_file_that_changed_makes_another_result(doc, ball, tmp_path):
    file = tmp_path / "mine.fcm"
    save_machine(load_machine("trunnion_ac"), file)
    path = app.create_toolpath(doc, ball, **{**FAST, "machine": str(file)})
    save_machine(load_machine("trunnion_bc"), file, overwrite=True)
    assert "recompute" in results.out_of_date(path)
    path.touch()
    doc.recompute()
    assert results.out_of_date(path) == "" and b"B" in results.nc_of(path)


def test_a_deleted_base_is_reported_and_undone(doc, ball):
    doc.UndoMode = 1
    path = app.create_toolpath(doc, ball, **FAST)
    doc.openTransaction("Delete")
    doc.removeObject(ball.Name)
    doc.commitTransaction()
    doc.recompute()
    assert "Invalid" in path.Mesh.State and "The part was deleted: undo that" in path.Mesh.getStatusString()
    assert results.out_of_date(path).startswith(
        "The part that Tessellation was made of was deleted: undo that"
    )
    doc.undo()
    doc.recompute()
    assert results.out_of_date(path) == "" and path.Mesh.State == ["Up-to-date"]


def test_a_deleted_mesh_is_reported(path):
    path.Document.removeObject(path.Mesh.Name)
    path.Document.recompute()
    assert "Invalid" in path.State and "was deleted: undo that" in path.getStatusString()


def test_what_is_no_toolpath_is_reported(ball):
    for obj in (ball, None):
        with pytest.raises(FiveAxisError, match="no toolpath and no audit"):
            results.result_of(obj)


def test_it_survives_the_file(path, reopen, anew):
    path.ToolLength, path.Feed = 1 / 3, "1234.5 mm/min"
    path.Document.recompute()
    nc, shown = results.nc_of(path), [path.Blocks, path.MaxBound.Value, list(path.Findings), path.Fingerprint]
    anew()
    again = reopen(path.Document).Toolpath
    assert again.State == again.Mesh.State == ["Up-to-date"] and results.out_of_date(again) == ""
    assert [
        again.Blocks,
        pytest.approx(again.MaxBound.Value),
        list(again.Findings),
        again.Fingerprint,
    ] == shown
    assert results.nc_of(again) == nc
    again.Stepover = 5
    again.Document.recompute()
    assert again.State == ["Up-to-date"] and again.Blocks < shown[0]


def test_another_process_reads_the_file(path, tmp_path):
    nc = results.nc_of(path)
    path.Document.saveAs(str(tmp_path / "part.FCStd"))
    script = (
        "import sys, os, FreeCAD\ntry:\n"
        f"    sys.path.insert(0, {str(ROOT)!r})\n"
        "    from freecad_fiveaxis.app import results\n"
        f"    doc = FreeCAD.openDocument({str(tmp_path / 'part.FCStd')!r})\n"
        "    assert results.out_of_date(doc.Toolpath) == '', results.out_of_date(doc.Toolpath)\n"
        f"    open({str(tmp_path / 'again.ngc')!r}, 'wb').write(results.nc_of(doc.Toolpath))\n"
        "finally:\n    os._exit(0)\n"
    )
    (tmp_path / "again.py").write_text(script)
    done = subprocess.run(
        ["freecadcmd", str(tmp_path / "again.py")],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert (tmp_path / "again.ngc").exists(), done.stdout[-3000:] + done.stderr[-3000:]
    assert (tmp_path / "again.ngc").read_bytes() == nc


def test_a_copy_lives_on_its_own(path):
    copy = path.Document.copyObject(path, False)
    assert copy.Mesh is path.Mesh and type(copy.Proxy) is type(path.Proxy) and copy.Proxy is not path.Proxy
    copy.Stepover = 5
    path.Document.recompute()
    assert copy.Blocks < path.Blocks and path.Stepover.Value == 4
    deep = path.Document.copyObject(path, True)
    deep = deep[-1] if isinstance(deep, (tuple, list)) else deep
    path.Document.recompute()
    assert deep.Mesh is not path.Mesh and deep.State == deep.Mesh.State == ["Up-to-date"]
    assert deep.Blocks == pytest.approx(
        path.Blocks, rel=0.05
    )  # the copied solid is rounded to 15 decimals, as in a file


def test_several_documents_do_not_mix(path):
    other = FreeCAD.newDocument("Other")
    try:
        obj = other.addObject("Part::Feature", "Ball")
        obj.Shape = half_ball(10)
        FreeCAD.setActiveDocument(path.Document.Name)
        second = app.create_toolpath(other, obj, **FAST)
        assert second.Document is other and second.Blocks < path.Blocks
        assert {one.Name for one in path.Document.Objects} == {one.Name for one in other.Objects}
        path.Stepover = 5
        path.Document.recompute()
        assert second.Stepover.Value == 4 and results.out_of_date(second) == ""
    finally:
        FreeCAD.closeDocument("Other")


def test_undo_and_redo_take_one_step(doc, ball, anew):
    doc.UndoMode = 1
    doc.openTransaction("Toolpath")
    path = app.create_toolpath(doc, ball, **FAST)
    doc.commitTransaction()
    nc = results.nc_of(path)
    assert doc.UndoNames == ["Toolpath"]
    doc.undo()
    assert [one.Name for one in doc.Objects] == ["Ball"]
    doc.redo()
    anew()
    assert results.nc_of(doc.Toolpath) == nc
    doc.recompute()  # FreeCAD 1.1 touches what redo brings back
    assert results.nc_of(doc.Toolpath) == nc and results.out_of_date(doc.Toolpath) == ""
    doc.openTransaction("Change")
    doc.Toolpath.Stepover = 6
    doc.recompute()
    doc.commitTransaction()
    fewer = doc.Toolpath.Blocks
    doc.undo()
    doc.recompute()
    assert (
        doc.Toolpath.Stepover.Value == 4 and doc.Toolpath.Blocks > fewer and results.nc_of(doc.Toolpath) == nc
    )


@pytest.mark.parametrize("stage", ["tessellate", "weld", "passes", "deviation"])
def test_stopped_halfway_the_document_is_as_it_was(anew, doc, ball, stage):
    seen = []

    def listener(name, fraction):
        seen.append(name)
        if stage in name:
            raise Cancelled("stopped")

    with long_work.reporting(listener), pytest.raises(Cancelled):
        app.create_toolpath(doc, ball, **FAST)
    assert [one.Name for one in doc.Objects] == ["Ball"] and ball.State == ["Up-to-date"]


def test_stopped_in_a_recompute_the_object_keeps_its_result_says_so_and_can_go_on(anew, path, tmp_path):
    def stop(name, fraction):
        raise Cancelled("stopped by the user")

    file, blocks = app.post_process(path, tmp_path / "part.ngc"), path.Blocks
    path.Stepover = 3
    with long_work.reporting(stop):
        path.Document.recompute()
    assert "Invalid" in path.State and "Touched" in path.State and path.Blocks == blocks and not file.UpToDate
    assert "stopped by the user" in path.getStatusString() and "stopped by the user" in results.out_of_date(
        path
    )
    path.Document.recompute()
    assert path.State == ["Up-to-date"] and path.Blocks > blocks and not results.out_of_date(path)


def test_a_tessellation_that_is_there_is_milled_and_not_copied(doc, ball):
    mesh = app.tessellate(ball, linear_deflection=0.1)
    path = app.create_toolpath(doc, mesh, machine="trunnion_ac", stepover=4, **PLAIN)
    assert path.Mesh is mesh and len(doc.Objects) == 3
    with pytest.raises(FiveAxisError, match="is a mesh already"):
        app.create_toolpath(doc, mesh, machine="trunnion_ac", stepover=4, linear_deflection=0.5)


def test_without_a_machine_it_is_the_trunnion(doc, ball):
    assert app.create_toolpath(doc, ball, stepover=4, linear_deflection=0.1, **PLAIN).Machine == "trunnion_ac"


def test_a_base_that_waits_for_its_recompute_is_computed_first(doc):
    box = doc.addObject("Part::Box", "Box")
    path = app.create_toolpath(doc, box, stepover=3)
    assert path.Blocks > 10 and path.State == box.State == ["Up-to-date"]


def test_by_default_the_path_keeps_its_tolerance_and_stays_out_of_the_part(doc, ball):
    path = app.create_toolpath(doc, ball, **FAST)
    assert (path.Linearize, path.Gouge) == ("on", "lift")
    assert path.Proven and path.OverTolerance == 0 and path.MaxSurfaceBound.Value <= path.Tolerance.Value
    assert path.Light == "amber" and path.Verdict.startswith("CHECK: ") and "near the pole" in path.Verdict
    path.Linearize, path.Gouge = "off", "off"
    doc.recompute()
    assert path.Light == "red" and path.Verdict.startswith("NOT SAFE: ") and not path.Proven
    assert f"{path.OverTolerance} of" in path.Verdict


def test_a_guided_tip_and_the_default_do_not_contradict_each_other(doc, ball):
    path = app.create_toolpath(doc, ball, **FAST, controller="heidenhain", rtcp="angles")
    assert (
        path.GuidedBlocks > 0
        and path.Light == "amber"
        and "the path between them is under RTCP" in path.Verdict
    )
    with pytest.raises(FiveAxisError, match="give one"):
        app.create_toolpath(doc, ball, **FAST, controller="heidenhain", rtcp="angles", linearize="on")
