# SPDX-License-Identifier: LGPL-2.1-or-later
"""examples/batch.py as a user runs it: a folder of parts in, NC and reports out, true exit codes."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import FreeCAD
import Part
import pytest
from cam_jobs import make_job
from conftest import PLAIN

from freecad_fiveaxis import app
from freecad_fiveaxis.app.results import nc_of

BATCH = Path(__file__).parents[2] / "examples" / "batch.py"
SETTINGS = {
    "machine": "trunnion_ac",
    "cutter": "ball:6",
    "stepover": "5",
    "tolerance": "50",
    "linear_deflection": "0.2",
    **PLAIN,
}


def batch(*words, **environment):
    """Exit code, and the script's own lines."""
    command = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    assert command, "no freecadcmd on the path"
    done = subprocess.run(
        [command, str(BATCH), *(["--", *map(str, words)] if words else [])], stdin=subprocess.DEVNULL, timeout=120,
        capture_output=True, text=True, errors="replace", env=os.environ | environment,
    )  # fmt: skip
    return done.returncode, done.stdout.splitlines()


def words(**more):
    return [f"{name}={value}" for name, value in (SETTINGS | more).items()]


def dome():
    return Part.makeSphere(10, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 0, 90, 360)


def saved(file, fill):
    """A document's file; ``fill`` puts into the document what it shall hold."""
    doc = FreeCAD.newDocument("Saved")
    try:
        fill(doc)
        doc.recompute()
        doc.saveCopy(str(file))
    finally:
        FreeCAD.closeDocument(doc.Name)


def solids(doc):
    for label, visible in (("Left", True), ("Right", True), ("Tool", False)):
        obj = doc.addObject("Part::Box", "Box")
        obj.Label, obj.Visibility = label, visible


def a_toolpath(doc):
    obj = doc.addObject("Part::Feature", "Dome")
    obj.Shape = dome()
    settings = {"cutter": "ball:4", "stepover": 6, "tolerance": 50, "linear_deflection": 0.2, **PLAIN}
    app.create_toolpath(doc, obj, machine="trunnion_bc", **settings)


def a_cut(doc):
    base, tool, cut = (
        doc.addObject("Part::Box", "Base"),
        doc.addObject("Part::Box", "Hole"),
        doc.addObject("Part::Cut", "Cut"),
    )
    tool.Length, cut.Base, cut.Tool = 5, base, tool


@pytest.fixture
def step(tmp_path):
    dome().exportStep(str(tmp_path / "dome.step"))
    return tmp_path / "dome.step"


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """Parts of every kind, good and bad, and what one run made of them."""
    parts, out = tmp_path_factory.mktemp("parts"), tmp_path_factory.mktemp("work") / "new" / "nc"
    dome().exportStep(str(parts / "dome.STP"))
    saved(parts / "pair.FCStd", solids)
    saved(parts / "path.FCStd", a_toolpath)
    saved(parts / "cut.FCStd", a_cut)
    saved(parts / "job.FCStd", lambda doc: make_job(doc, doc.addObject("Part::Box", "Box")))
    saved(parts / "empty.FCStd", lambda doc: None)
    Part.makePlane(5, 5).exportStep(str(parts / "sheet.step"))
    (parts / "broken.step").write_text("no STEP at all")
    (parts / "broken.FCStd").write_text("no document at all")
    (parts / "notes.txt").write_text("no part")
    given = [word for word in words() if "cutter" not in word]
    return out, *batch(parts, out, *given)


@pytest.mark.thorough
def test_every_part_has_nc_and_reports_and_no_other_file_is_there(folders):
    out, _, lines = folders
    names = ("cut", "dome", "job", "pair-Left", "pair-Right", "path")
    expected = sorted(f"{name}.{kind}" for name in names for kind in ("ngc", "html", "json"))
    assert sorted(path.name for path in out.iterdir()) == expected, lines
    for name in names:
        assert json.loads((out / f"{name}.json").read_text())["summary"]["blocks"] > 10
        assert "<html" in (out / f"{name}.html").read_text()


def test_failures_are_reported_in_one_line_each_and_stop_no_other(folders):
    _, code, lines = folders
    failed = [line.split(": FAILED: ") for line in lines if "FAILED" in line]
    assert sorted(name.strip() for name, _ in failed) == [
        "broken.FCStd",
        "broken.step",
        "empty.FCStd",
        "sheet.step",
    ]
    assert all(len(reason) > 10 and "{" not in reason for _, reason in failed)
    assert code == 1


def test_the_table_comes_last_with_a_line_for_each_part(folders):
    _, _, lines = folders
    table = lines[[line.split()[:1] for line in lines].index(["part"]) :]
    assert len(table) == 1 + 10 + 1
    assert table[-1] == "10 parts: 6 well, 0 with errors in the findings, 4 failed"


def test_a_toolpath_in_a_document_keeps_its_own_settings(folders):
    report = json.loads((folders[0] / "path.json").read_text())
    assert report["inputs"]["stepover"] == 6 and report["inputs"]["machine"] == "trunnion_bc"


def test_a_job_gives_its_ball_end(folders):
    inputs = json.loads((folders[0] / "job.json").read_text())["inputs"]
    assert inputs["cutter"].startswith("ball:6") and inputs["tool"] == 3 and inputs["stepover"] == 5


def test_the_nc_is_what_the_macro_makes(folders, doc):
    obj = doc.addObject("Part::Feature", "Part")
    obj.Shape = dome()
    settings = {name: value for name, value in SETTINGS.items() if name != "cutter"}
    assert (folders[0] / "dome.ngc").read_bytes() == nc_of(app.create_toolpath(doc, obj, **settings))


def test_settings_come_from_the_environment_and_all_well_is_exit_0(step, tmp_path):
    given = {f"FIVEAXIS_{name.upper()}": value for name, value in SETTINGS.items()}
    code, lines = batch(
        FIVEAXIS_PARTS=str(step), FIVEAXIS_OUT=str(tmp_path / "out"), FIVEAXIS_SCALOP="1", **given
    )
    assert code == 0, lines
    assert (tmp_path / "out" / "dome.ngc").stat().st_size > 500
    assert any("FIVEAXIS_SCALOP is no setting" in line for line in lines)


def test_a_program_ends_as_its_controller_has_it(step, tmp_path):
    code, lines = batch(step, tmp_path / "out", *words(controller="siemens840d"))
    assert code == 0, lines
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [
        "dome.html",
        "dome.json",
        "dome.mpf",
    ]


def test_nothing_is_overwritten_unasked(step, tmp_path):
    (tmp_path / "dome.json").write_text("mine")
    code, lines = batch(step, tmp_path, *words())
    assert code == 2 and any("FAILED" in line and "dome.json exists" in line for line in lines)
    assert (tmp_path / "dome.json").read_text() == "mine" and not (tmp_path / "dome.ngc").exists()
    code, lines = batch(step, tmp_path, *words(overwrite="yes"))
    assert code == 0, lines
    assert json.loads((tmp_path / "dome.json").read_text())["version"] == 1


def test_findings_of_severity_error_are_exit_1(step, tmp_path):
    code, lines = batch(step, tmp_path, *words(tolerance="0.000001", linearize="off", gouge="off"))
    assert code == 1 and lines[-1] == "1 parts: 0 well, 1 with errors in the findings, 0 failed", lines
    assert (tmp_path / "dome.ngc").exists()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"scalop": "1"}, "scalop is no setting"),
        ({"machine": ""}, "no machine given"),
        ({"stepover": "-1"}, "stepover -1 is out of range"),
        ({"parts": "/no/such/folder"}, "holds no FCStd and no STEP file"),
    ],
)
def test_what_cannot_be_used_is_exit_2_and_leaves_no_file(step, tmp_path, change, message):
    code, lines = batch(step, tmp_path / "out", *words(**change))
    assert code == 2 and len(lines) == lines.index(next(line for line in lines if message in line)) + 1
    assert not (tmp_path / "out").exists()
