# SPDX-License-Identifier: LGPL-2.1-or-later
"""`recover` and `prove-signs` as the command line has them: exit codes, files, messages."""

import json

import pytest
from recover_examples import line_errors
from setup_examples import milled

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.toolpath.apt import write_apt


def run(*words):
    return cli.main([str(word) for word in words])


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """The cap's CL path and its program, by a machine with a rotary head."""
    folder = tmp_path_factory.mktemp("cap")
    result = milled("head_b_table_c", stepover=12.0, rings=8, tool_length=90.0, origin="12,-7,5")
    (folder / "cap.apt").write_bytes(write_apt(result.path, result.settings.cutter.cutter, "cap"))
    (folder / "cap.ngc").write_bytes(result.nc)
    return folder / "cap.apt", folder / "cap.ngc"


PLACE = ("--origin", "12,-7,5", "--tool-length", "90")


def test_a_posted_path_gives_the_machine_back(files, tmp_path, capsys):
    out, report = tmp_path / "m.fcm", tmp_path / "r.json"
    assert (
        run("recover", *files, *PLACE, "-o", out, "--report", report, "--report", tmp_path / "r.html")
        == cli.DONE
    )
    message = capsys.readouterr().out
    assert (
        "head-table, C nearer to the work turning about Z, B about Y" in message and f"wrote {out}" in message
    )
    found, truth = load_machine(out), load_machine("head_b_table_c")
    assert line_errors(found, truth, Setup((12.0, -7.0, 5.0), 90.0)).max() < 1e-4
    record = json.loads(report.read_text())
    assert (
        record["layout"]["kind"] == "head-table" and len(record["parameters"]) == 9 and not record["others"]
    )
    assert record["points"]["B"] == pytest.approx([0, 0, 120], abs=1e-4)
    assert "certain within" in (tmp_path / "r.html").read_text(encoding="utf-8")
    assert found.name == "m" and "cap.apt and cap.ngc" in found.description


@pytest.mark.oldest
@pytest.mark.thorough
def test_the_report_s_inputs_are_a_job(files, tmp_path, capsys):
    run("recover", *files, *PLACE, "-o", tmp_path / "m.fcm", "--report", tmp_path / "r.json", "--quiet")
    inputs = json.loads((tmp_path / "r.json").read_text())["inputs"]
    (tmp_path / "job.json").write_text(json.dumps(inputs | {"machine_file": "again.fcm", "report": []}))
    assert run("run", tmp_path / "job.json", "--quiet") == cli.DONE
    assert load_machine(tmp_path / "again.fcm").axes == load_machine(tmp_path / "m.fcm").axes


def test_another_machine_is_named_and_the_exit_code_says_so(files, tmp_path, capsys):
    assert (
        run("recover", *files, *PLACE, "--machine", "fork_head_bc", "-o", tmp_path / "m.fcm")
        == cli.DONE_WITH_ERRORS
    )
    message = " ".join(capsys.readouterr().out.split())
    assert "The machine that the post had in mind is head-table, fork_head_bc is head-head" in message
    assert (tmp_path / "m.fcm").exists()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ((), "no machine file named; give one with -o"),
        (("-o", "m.ngc"), "does not end in .fcm"),
        (("-o", "there.fcm"), "exists already"),
        (("-o", "m.fcm", "--report", "r.pdf"), "needs one of the endings"),
    ],
)
def test_what_cannot_be_used_is_stated_before_the_work(words, message, files, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "there.fcm").write_text("mine")
    assert run("recover", *files, *words) == cli.UNUSABLE
    assert message in capsys.readouterr().err
    assert (tmp_path / "there.fcm").read_text() == "mine" and not (tmp_path / "m.fcm").exists()


def test_a_program_without_two_rotary_letters_is_refused(files, tmp_path, capsys):
    (tmp_path / "p.ngc").write_text("G21 G90\nG1 X1 Y2 Z3 C10 F100\nM2\n")
    assert run("recover", files[0], tmp_path / "p.ngc", "-o", tmp_path / "m.fcm") == cli.UNUSABLE
    assert "rotary words of C" in capsys.readouterr().err and not (tmp_path / "m.fcm").exists()


@pytest.mark.parametrize("controller", ["linuxcnc", "fanuc"])
def test_prove_signs_writes_a_program_and_a_sheet(controller, tmp_path, capsys):
    nc, sheet = tmp_path / "p.ngc", tmp_path / "sheet.html"
    words = (
        "--machine",
        "trunnion_bc",
        "--controller",
        controller,
        "--origin",
        "0,0,20",
        "--mark",
        "40,25,10",
        "--tool",
        "7",
    )
    assert (
        run("prove-signs", *words, "-o", nc, "--report", sheet, "--report", tmp_path / "s.json") == cli.DONE
    )
    assert "stop 8" in capsys.readouterr().out and "Proving the signs" in sheet.read_text(encoding="utf-8")
    record = json.loads((tmp_path / "s.json").read_text())
    kinematics = milled("trunnion_bc", stepover=12.0, rings=8).kinematics
    program = read_nc(nc.read_bytes(), kinematics)
    assert {row["line"] for row in record["stops"]} <= set(program.line.tolist())
    assert b"T7 M6" in nc.read_bytes()
    (tmp_path / "job.json").write_text(json.dumps(record["inputs"] | {"output": "again.ngc", "report": []}))
    assert run("run", tmp_path / "job.json", "--quiet") == cli.DONE
    assert (tmp_path / "again.ngc").read_bytes() == nc.read_bytes()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--machine", "trunnion_ac"), "no NC file named"),
        (("-o", "p.ngc"), "no machine given"),
        (("--machine", "fork_head_bc", "-o", "p.ngc"), "give --tool-length"),
        (("--machine", "trunnion_ac", "-o", "p.ngc", "--angle", "80"), "out of range"),
        (("--machine", "trunnion_ac", "-o", "p.ngc", "--origin", "0,0,495"), "would leave its limits"),
    ],
)
def test_prove_signs_refuses_what_it_cannot_do(words, message, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("prove-signs", *words) == cli.UNUSABLE
    assert message in capsys.readouterr().err and not (tmp_path / "p.ngc").exists()
