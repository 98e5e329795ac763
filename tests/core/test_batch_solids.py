# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a batch that FreeCAD meshes first. FreeCAD is stood in for by a program that gives a known mesh;
the real one is asked in tests/app/test_mesher.py."""

import json
import os
import sys
import time

import pytest
from roofs import WAY, write_roof

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import Cancelled, FileError
from freecad_fiveaxis.core.batch import plan, solids, work

STAND_IN = """#!{python}
import json, os, shutil, sys, time
folder = os.environ["FIVEAXIS_MESHER"]
task = json.load(open(os.path.join(folder, "task.json")))
with open({log!r}, "a") as file:
    file.write(json.dumps(task) + "\\n")
if task["named"] == "Endless":
    with open({log!r} + ".pid", "w") as file:
        file.write(str(os.getpid()))
    time.sleep(600)
if task["named"] == "Nothing":
    sys.exit(0)
made = {{"error": "it holds Pin, Blade"}} if task["named"] == "Several" else {{"facets": 1}}
shutil.copy({stl!r}, os.path.join(folder, "mesh.stl"))
json.dump(made, open(os.path.join(folder, "made.json"), "w"))
"""

pytestmark = pytest.mark.skipif(os.name == "nt", reason="the stand-in begins with the name of its Python")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder with a part as STL and as STEP, a document, and the program that meshes them all to the
    same."""
    parts = tmp_path / "parts"
    parts.mkdir()
    write_roof(parts / "stl_roof.stl")
    (parts / "roof.step").write_text("ISO-10303-21;")
    (parts / "jig.FCStd").write_text("PK")
    program = tmp_path / "freecad"
    program.write_text(
        STAND_IN.format(python=sys.executable, log=str(tmp_path / "log"), stl=str(parts / "stl_roof.stl"))
    )
    program.chmod(0o755)
    monkeypatch.setenv(solids.PROGRAM, str(program))
    monkeypatch.setattr(solids, "_kept", {})
    return parts


def wanted_of(folder):
    path = folder.parent / "log"
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


@pytest.mark.thorough
def test_a_step_file_and_a_named_solid_are_milled_as_their_mesh_and_meshed_once(folder, tmp_path):
    table = folder / "jobs.json"
    table.write_text(
        json.dumps(
            {"parts": ["stl_roof.stl", "roof.step", "jig.FCStd:Blade 2"], "options": {"stepover": [5, 7]}}
        )
    )
    out = tmp_path / "out"
    out.mkdir()
    jobs = plan.read_jobs(
        str(table), {name: value for name, value in WAY.items() if name != "stepover"}, str(out)
    )
    names = [os.path.basename(job.stem) for job in jobs]
    assert names[2:] == [
        "roof.stepover=5",
        "roof.stepover=7",
        "jig-Blade2.stepover=5",
        "jig-Blade2.stepover=7",
    ]
    ended = [work.run_one(job) for job in jobs]
    assert [one.error for one in ended] == [""] * 6
    programs = [(out / f"{name}.ngc").read_bytes() for name in names]
    assert (
        programs[0] == programs[2] == programs[4] and programs[1] == programs[3] == programs[5] != programs[0]
    )
    assert [(os.path.basename(one["file"]), one["named"]) for one in wanted_of(folder)] == [
        ("roof.step", ""),
        ("jig.FCStd", "Blade 2"),
    ]
    assert (wanted_of(folder)[0]["linear"], wanted_of(folder)[0]["angular"]) == (0.02, 15.0)
    assert work.read_finished(jobs[2]) is not None
    (folder / "roof.step").write_text("ISO-10303-21; changed")
    assert work.read_finished(jobs[2]) is None


@pytest.mark.parametrize(
    ("named", "message"), [("Several", "it holds Pin, Blade"), ("Nothing", "ended before it was meshed")]
)
def test_what_freecad_says_is_why_the_job_fails(folder, named, message):
    with pytest.raises(FileError, match=message):
        solids.mesh_solid(solids.Solid(str(folder / "jig.FCStd"), named))


def test_without_freecad_the_command_ends_before_any_work_with_the_remedy(
    folder, tmp_path, capsys, monkeypatch
):
    words = ["batch", str(folder), "--out", str(tmp_path / "out"), "--machine", "trunnion_ac"]
    for given in (str(folder / "roof.step"), ""):
        monkeypatch.setenv(solids.PROGRAM, given)
        monkeypatch.setenv("PATH", str(tmp_path))
        assert cli.main(words) == cli.UNUSABLE
        reported = capsys.readouterr().err
        assert (
            reported.count("\n") == 1
            and solids.PROGRAM in reported
            and "STL" in reported
            and not (tmp_path / "out").exists()
        )


def test_a_part_that_is_not_there_is_reported(folder):
    with pytest.raises(FileError, match=r"gone\.step cannot be read"):
        solids.mesh_solid(solids.Solid(str(folder / "gone.step")))


def test_who_stops_it_ends_the_process_too(folder):
    mark = folder.parent / "log.pid"

    def stop(stage, fraction):
        if mark.exists() and mark.read_text():
            raise Cancelled("enough")

    with pytest.raises(Cancelled):
        solids.mesh_solid(solids.Solid(str(folder / "jig.FCStd"), "Endless"), stop)
    number, due = int(mark.read_text()), time.monotonic() + 30
    while os.path.exists(f"/proc/{number}") and time.monotonic() < due:
        time.sleep(0.05)
    with pytest.raises(ProcessLookupError):
        os.kill(number, 0)


@pytest.mark.parametrize(("text", "solid"), [
    ("a.stl", ("a.stl", "")), ("C:/x/a.FCStd", ("C:/x/a.FCStd", "")), ("C:/x/a.fcstd:B: 1", ("C:/x/a.fcstd", "B: 1")),
    ("a.step:B", ("a.step:B", "")),
])  # fmt: skip
def test_the_solid_of_a_document_stands_behind_its_file(text, solid):
    assert solids.read_part(text) == solids.Solid(*solid)
