# SPDX-License-Identifier: LGPL-2.1-or-later
"""The public face: exit codes, messages, files. Small parts; the numbers are proven in the modules' own
tests."""

import csv
import errno
import io
import json
import os
import struct
import subprocess
import sys

import numpy as np
import pytest
from plain import PLAIN, PLAIN_WORDS, build_settings
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base import terminal
from freecad_fiveaxis.core.base.errors import Cancelled, FileError
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.machine import list_shipped_machines
from freecad_fiveaxis.core.pipeline import job

TABLE_2 = "G90 G93\nG1 X-90.9595 Y7.3103 Z227.6341 A1.0664 C148.9685 F60\nG1 X-82.0656 Y-34.8175 Z228.3975 A1.1793 C121.5477 F60\nM2\n"


@pytest.fixture
def roof(tmp_path):
    """A gable roof on a block, 40 x 30 mm: two slopes that meet in one convex co-edge."""
    low = [(0, 0, 0), (40, 0, 0), (40, 30, 0), (0, 30, 0)]
    high = [(0, 0, 10), (40, 0, 10), (40, 30, 10), (0, 30, 10), (20, 0, 18), (20, 30, 18)]
    v = np.array(low + high, float) - (20, 15, 0)
    faces = [(0, 2, 1), (0, 3, 2), (0, 1, 5), (0, 5, 8), (0, 8, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 9), (2, 9, 6),
             (3, 0, 4), (3, 4, 7), (5, 6, 9), (5, 9, 8), (4, 8, 9), (4, 9, 7)]  # fmt: skip
    path = tmp_path / "roof.stl"
    write_stl(from_triangles(v[np.array(faces)]), path)
    return path


def run(*words):
    return cli.main([str(word) for word in words])


def table(path):
    with path.open(newline="") as stream:
        return list(csv.DictReader(stream))


def test_mill_writes_every_file_that_is_requested(roof, tmp_path, capsys):
    out = {name: tmp_path / name for name in ("a.ngc", "a.apt", "a.csv", "a.json", "a.html", "a.txt")}
    code = run("mill", roof, "--machine", "trunnion_ac", "--stepover", "5", "--tolerance", "100", *PLAIN_WORDS,
               "-o", out["a.ngc"], "--cl", out["a.apt"], "--blocks", out["a.csv"], "--report", out["a.json"], "--report", out["a.html"], "--report", out["a.txt"])  # fmt: skip
    assert code == cli.DONE
    assert all(path.stat().st_size > 100 for path in out.values())
    assert sorted(os.listdir(tmp_path)) == sorted([*out, "roof.stl"])
    data = json.loads(out["a.json"].read_text())
    rows = table(out["a.csv"])
    assert data["version"] == 1 and data["summary"]["blocks"] == len(rows)
    lines = out["a.ngc"].read_text().splitlines()
    for row in rows[:: max(1, len(rows) // 20)]:
        assert (
            f"X{float(row['X']):.4f}" in lines[int(row["line"]) - 1] or "X" not in lines[int(row["line"]) - 1]
        )
    assert "wrote" in capsys.readouterr().out


def test_the_inputs_of_a_report_are_a_job_file_that_makes_the_same_bytes(roof, tmp_path):
    first, second, report = tmp_path / "1.ngc", tmp_path / "2.ngc", tmp_path / "1.json"
    words = (
        "--machine",
        "trunnion_bc",
        "--scallop",
        "0.5",
        "--direction",
        "20",
        "--tolerance",
        "100",
        "--quiet",
    )
    assert run("mill", roof, *words, "-o", first, "--report", report) == 0
    inputs = json.loads(report.read_text())["inputs"]
    (tmp_path / "job.json").write_text(json.dumps(inputs | {"output": str(second), "report": []}))
    assert run("run", tmp_path / "job.json", "--quiet") == 0
    assert first.read_bytes() == second.read_bytes()


@some_in_core("words", [("--left", "on"), ("--left=on",), ("--left",)], kept=(2,))
def test_the_former_name_of_an_option_makes_the_same_files_and_is_noted(words, roof, tmp_path, capsys):
    plain = ("mill", roof, "--machine", "trunnion_ac", "--stepover", "5", "--tolerance", "100")
    old, new, report = tmp_path / "old.ngc", tmp_path / "new.ngc", tmp_path / "old.json"
    assert run(*plain, *words, "-o", old, "--report", report) == 0
    assert "--left is called --rest now" in capsys.readouterr().err
    assert run(*plain, "--rest", "on", "-o", new) == 0 and "--left" not in capsys.readouterr().err
    assert old.read_bytes() == new.read_bytes()
    data = json.loads(report.read_text())
    assert data["inputs"]["rest"] == "on" and data["left"]["left"]["area"] >= 0.0


def test_the_former_name_is_not_noted_where_all_is_quiet_and_a_job_file_has_it(roof, tmp_path, capsys):
    job = {
        "task": "mill",
        "source": "roof.stl",
        "machine": "trunnion_ac",
        "stepover": 5,
        "tolerance": 100,
        "left": "on",
    }
    (tmp_path / "job.json").write_text(json.dumps(job | {"output": "a.ngc", "report": ["a.json"]}))
    assert run("run", tmp_path / "job.json", "--quiet") == 0
    assert "left" in json.loads((tmp_path / "a.json").read_text()) and capsys.readouterr().err == ""


def test_no_word_at_all_is_answered_with_the_usage(capsys):
    with pytest.raises(SystemExit) as ended:
        run()
    assert ended.value.code == 2 and "COMMAND" in capsys.readouterr().err


def test_an_option_without_effect_is_named_unless_all_is_quiet(roof, tmp_path, capsys):
    words = (
        "mill",
        roof,
        "--machine",
        "trunnion_ac",
        "--stepover",
        "9",
        "--gouge",
        "off",
        "--passes",
        "planes",
    )
    words = (*words, "--frames", "3", "--direction", "20", "-o", tmp_path / "a.ngc")
    assert run(*words) in (0, 1)
    shown = capsys.readouterr().err
    assert "--frames has no effect: it is for --passes frames" in shown and "--direction" not in shown
    assert run(*words, "--quiet") in (0, 1) and capsys.readouterr().err == ""


def test_paths_in_a_job_file_are_relative_to_it(roof, tmp_path, monkeypatch):
    (tmp_path / "sub").mkdir()
    monkeypatch.chdir(tmp_path / "sub")
    job_file = {
        "task": "mill",
        "source": "roof.stl",
        "machine": "trunnion_ac",
        "stepover": 10,
        "tolerance": 100,
        **PLAIN,
        "output": "roof.ngc",
    }
    (tmp_path / "job.json").write_text(json.dumps(job_file))
    assert run("run", "../job.json", "--quiet") == 0
    assert (tmp_path / "roof.ngc").exists()


def test_table_2_of_so_is_audited(tmp_path):
    (tmp_path / "t2.ngc").write_text(TABLE_2)
    code = run("audit", tmp_path / "t2.ngc", "--machine", "mikron_ucp710", "--report", tmp_path / "t2.json", "--blocks", tmp_path / "t2.csv",
               "--quiet")  # fmt: skip
    assert code == cli.DONE_WITH_ERRORS
    summary = json.loads((tmp_path / "t2.json").read_text())["summary"]
    assert summary["max_line_deviation"] == pytest.approx(0.9384, abs=3e-4)
    assert summary["max_segment_deviation"] == pytest.approx(2.1264, abs=5e-4)
    assert summary["worst_line"] == 3 and summary["singular_blocks"] == 1 and summary["over_tolerance"] == 1
    row = table(tmp_path / "t2.csv")[1]
    assert float(row["u_line"]) == pytest.approx(0.404, abs=1e-3)
    assert float(row["u_segment"]) == pytest.approx(0.5454, abs=1e-3)


def test_post_takes_the_cl_file_that_mill_wrote(roof, tmp_path):
    words = ("--machine", "trunnion_ac", "--tolerance", "100", "--quiet")
    assert (
        run(
            "mill",
            roof,
            "--stepover",
            "10",
            *PLAIN_WORDS,
            *words,
            "-o",
            tmp_path / "a.ngc",
            "--cl",
            tmp_path / "a.apt",
        )
        == 0
    )
    assert run("post", tmp_path / "a.apt", *words, "-o", tmp_path / "b.ngc") == 0
    assert (tmp_path / "b.ngc").stat().st_size > 100


def mills(roof, machine, *words):
    code = run("mill", roof, "--machine", machine, "--stepover", "10", "--tolerance", "500", "--tool-length", "100", "--quiet",
               "-o", roof.with_name("a.ngc"), *words)  # fmt: skip
    assert code in (cli.DONE, cli.DONE_WITH_ERRORS)


@some_in_core("machine", list_shipped_machines())
def test_every_shipped_machine_mills_the_roof(machine, roof):
    mills(roof, machine)


@pytest.mark.parametrize("machine", list_shipped_machines())
def test_every_shipped_machine_mills_the_roof_in_planes(machine, roof):
    mills(roof, machine, *PLAIN_WORDS)


BAD_STL = {
    "empty": b"",
    "text": b"this is no STL at all, just some words that somebody wrote",
    "truncated": b"\0" * 80 + struct.pack("<I", 10) + b"\0" * 120,
    "no facets": b"\0" * 80 + struct.pack("<I", 0),
    "lying count": b"\0" * 80 + struct.pack("<I", 1000000) + b"\0" * 100,
    "nan": b"\0" * 80 + struct.pack("<I", 1) + struct.pack("<12fH", *[float("nan")] * 12, 0),
    "infinite": b"\0" * 80 + struct.pack("<I", 1) + struct.pack("<12fH", *[float("inf")] * 12, 0),
    "huge": b"\0" * 80
    + struct.pack("<I", 1)
    + struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1e9, 0, 0, 0, 1e9, 0, 0),
}


def refused(capsys, tmp_path, *words):
    """Exit 2, one clear line on stderr, no output file; returns the line."""
    before = sorted(os.listdir(tmp_path))
    assert run(*words) == cli.UNUSABLE
    error = capsys.readouterr().err
    assert error.count("\n") == 1 and "Traceback" not in error and len(error) > 20
    assert sorted(os.listdir(tmp_path)) == before
    return error


@pytest.mark.parametrize("kind", BAD_STL)
def test_a_bad_stl_is_refused(kind, tmp_path, capsys):
    (tmp_path / "bad.stl").write_bytes(BAD_STL[kind])
    refused(
        capsys, tmp_path, "mill", tmp_path / "bad.stl", "--machine", "trunnion_ac", "-o", tmp_path / "a.ngc"
    )


@pytest.mark.parametrize(
    ("words", "named"),
    [(["--machine", "no_such"], "no_such"), (["--machine", "trunnion_ac", "--cutter", "ball:0"], "0"),
     (["--machine", "trunnion_ac", "--scallop", "-0.01"], "-0.01"), (["--machine", "trunnion_ac", "--scallop", "5", "--tool-axis", "facet_mean"], "5"),
     (["--machine", "trunnion_ac", "--controller", "hal9000"], "hal9000"), (["--machine", "gone.fcm"], "gone.fcm"),
     (["--machine", "trunnion_ac", "--tool-axis", "best"], "best"), (["--machine", "fork_head_bc"], "tool-length"),
     (["--machine", "trunnion_ac", "--tool-axis", "fixed", "--axis", "0,0,0"], "0"), ([], "machine")],
)  # fmt: skip
def test_a_bad_option_is_refused_and_named(words, named, roof, tmp_path, capsys):
    assert named in refused(capsys, tmp_path, "mill", roof, *words, "-o", tmp_path / "a.ngc")


def test_a_missing_file_a_missing_folder_and_the_source_as_output_are_refused(roof, tmp_path, capsys):
    machine = ("--machine", "trunnion_ac")
    assert "gone.stl" in refused(
        capsys, tmp_path, "mill", tmp_path / "gone.stl", *machine, "-o", tmp_path / "a.ngc"
    )
    assert "nowhere" in refused(
        capsys, tmp_path, "mill", roof, *machine, "-o", tmp_path / "nowhere" / "a.ngc"
    )
    assert "roof.stl" in refused(capsys, tmp_path, "mill", roof, *machine, "-o", roof)
    assert "-o" in refused(capsys, tmp_path, "mill", roof, *machine)
    assert ".pdf" in refused(
        capsys, tmp_path, "mill", roof, *machine, "-o", tmp_path / "a.ngc", "--report", tmp_path / "a.pdf"
    )


@pytest.mark.parametrize("text", ["", "[]", "{", '{"task": "mill"}', '{"task": "dance", "source": "a"}', '{"task": "mill", "source": 3}',
                                  '{"task": "mill", "source": "a.stl", "machine": "trunnion_ac", "speed": 3}', "[" * 100000])  # fmt: skip
def test_a_bad_job_file_is_refused(text, tmp_path, capsys):
    (tmp_path / "job.json").write_text(text)
    refused(capsys, tmp_path, "run", tmp_path / "job.json")


def test_a_cancelled_job_writes_nothing(roof, tmp_path, monkeypatch, capsys):
    def stop(settings, progress):
        raise Cancelled("by the user")

    monkeypatch.setattr(job, "run", stop)
    assert run("mill", roof, "--machine", "trunnion_ac", "-o", tmp_path / "a.ngc") == cli.STOPPED
    assert os.listdir(tmp_path) == ["roof.stl"]


def test_cancelling_from_the_progress_call_stops_the_pipeline(roof):
    def stop(stage, fraction):
        raise Cancelled(stage)

    with pytest.raises(Cancelled):
        job.run(build_settings("mill", str(roof), {"machine": "trunnion_ac", "stepover": 5}), stop)


def test_the_lists_name_what_is_there(capsys):
    for word, known in (
        ("machines", "mikron_ucp710"),
        ("controllers", "fanuc"),
        ("strategies", "step_weighted"),
    ):
        assert run(word) == 0
        assert known in capsys.readouterr().out


def test_the_module_runs_as_a_program():
    done = subprocess.run(
        [sys.executable, "-m", "freecad_fiveaxis", "machines"], capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0 and "trunnion_ac" in done.stdout
    done = subprocess.run(
        [sys.executable, "-m", "freecad_fiveaxis", "mill"], capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 2


def program(*words, head="", **how):
    """The command line in a process of its own; ``head``: Python to run before."""
    code = f"{head}\nimport sys\nfrom freecad_fiveaxis.core.cli import main\nsys.exit(main(sys.argv[1:]))"
    how = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "timeout": 60} | how
    return subprocess.run([sys.executable, "-c", code, *(os.fspath(word) for word in words)], **how)


@pytest.mark.parametrize("controller", ["linuxcnc", "fanuc"])
@pytest.mark.parametrize(
    "offset", ["G57.3", "G59.4", "G53", "G54.1 P0", "G54.1 P301", "g54", "G54 P1", "G54.1P\u0661"]
)
def test_a_work_offset_that_the_controller_has_not_is_refused(controller, offset, roof, tmp_path, capsys):
    words = (
        "--machine",
        "trunnion_ac",
        "--stepover",
        "20",
        "--controller",
        controller,
        "--work-offset",
        offset,
    )
    error = refused(capsys, tmp_path, "mill", roof, *words, "-o", tmp_path / "a.ngc")
    assert "work offset" in error and "G54 to G59" in error


@pytest.mark.parametrize(
    ("controller", "other", "offset"),
    [("fanuc", "linuxcnc", "G54.1 P1"), ("fanuc", "linuxcnc", "G54.1P48"), ("fanuc", "linuxcnc", "G54.1 P300"),
     ("linuxcnc", "fanuc", "G59.1"), ("linuxcnc", "fanuc", "G59.3")],
)  # fmt: skip
def test_a_work_offset_of_another_controller_is_refused_by_name(
    controller, other, offset, roof, tmp_path, capsys
):
    words = (
        "--machine",
        "trunnion_ac",
        "--stepover",
        "20",
        "--work-offset",
        offset,
        "--quiet",
        *PLAIN_WORDS,
        "-o",
        tmp_path / "a.ngc",
    )
    assert f"unknown to {other}" in refused(capsys, tmp_path, "mill", roof, *words, "--controller", other)
    assert run("mill", roof, *words, "--controller", controller) != cli.UNUSABLE
    assert offset in (tmp_path / "a.ngc").read_text().splitlines()


@pytest.mark.parametrize("controller", ["linuxcnc", "fanuc"])
@pytest.mark.parametrize("offset", ["G54", "G59"])
def test_a_work_offset_stands_in_the_head(controller, offset, roof, tmp_path):
    words = (
        "--machine",
        "trunnion_ac",
        "--stepover",
        "20",
        "--controller",
        controller,
        "--work-offset",
        offset,
        "--quiet",
        *PLAIN_WORDS,
    )
    assert run("mill", roof, *words, "-o", tmp_path / "a.ngc") != cli.UNUSABLE
    assert offset in (tmp_path / "a.ngc").read_text().splitlines()


@pytest.mark.thorough
def test_a_file_name_that_is_no_unicode_is_milled_reported_and_run_again(roof, tmp_path):
    source = os.path.join(os.fsencode(tmp_path), b"bad\xff.stl")
    try:
        os.rename(roof, source)
    except OSError:
        pytest.skip("this file system takes Unicode names only")
    words = ("--machine", "trunnion_ac", "--stepover", "20", "--tolerance", "100")
    done = program("mill", source, *words, "-o", tmp_path / "1.ngc", "--report", tmp_path / "1.json")
    assert done.returncode == 0, done.stderr
    assert b"bad\\udcff.stl" in done.stdout
    inputs = json.loads((tmp_path / "1.json").read_text("utf-8"))["inputs"]
    assert os.fsencode(inputs["source"]) == source
    (tmp_path / "job.json").write_text(json.dumps(inputs | {"output": str(tmp_path / "2.ngc"), "report": []}))
    assert run("run", tmp_path / "job.json", "--quiet") == 0
    assert (tmp_path / "1.ngc").read_bytes() == (tmp_path / "2.ngc").read_bytes()


@pytest.mark.parametrize("bad", ["a\0b", "a\ud800b"])
@pytest.mark.parametrize("name", ["source", "output", "cl", "report", "blocks", "machine"])
def test_a_name_that_no_file_can_have_is_refused_in_a_job_file(name, bad, roof, tmp_path, capsys):
    given = {"task": "mill", "source": "roof.stl", "machine": "trunnion_ac", "output": "a.ngc"} | {name: bad}
    (tmp_path / "job.json").write_text(json.dumps(given))
    assert name in refused(capsys, tmp_path, "run", tmp_path / "job.json")


def test_a_name_that_no_file_can_have_is_refused_as_an_option(roof, tmp_path, capsys):
    assert "output" in refused(
        capsys, tmp_path, "mill", roof, "--machine", "trunnion_ac", "-o", f"{tmp_path}/a\0.ngc"
    )
    refused(capsys, tmp_path, "run", f"{tmp_path}/job\0.json")


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no /dev/full")
def test_where_stdout_is_full_one_line_says_that_the_files_are_written(tmp_path):
    (tmp_path / "t2.ngc").write_text(TABLE_2)
    words = ("audit", tmp_path / "t2.ngc", "--machine", "mikron_ucp710", "--blocks", tmp_path / "t2.csv")
    with open("/dev/full", "w") as full:
        done = program(*words, stdout=full)
        lists = program("machines", stdout=full)
    assert done.returncode == lists.returncode == cli.UNUSABLE
    assert done.stderr.count(b"\n") == lists.stderr.count(b"\n") == 1
    assert b"No space left" in done.stderr and b"t2.csv" in done.stderr and (tmp_path / "t2.csv").exists()


def test_a_reader_that_goes_away_does_not_change_the_exit_code(tmp_path):
    (tmp_path / "t2.ngc").write_text(TABLE_2)
    reader, writer = os.pipe()
    os.close(reader)
    with os.fdopen(writer, "w") as gone:
        done = program("audit", tmp_path / "t2.ngc", "--machine", "mikron_ucp710", stdout=gone)
    assert (done.returncode, done.stderr) == (cli.DONE_WITH_ERRORS, b"")


def test_a_reader_that_goes_away_on_windows_is_an_invalid_argument(monkeypatch):
    class Gone(io.StringIO):
        def write(self, text):
            raise OSError(errno.EINVAL, "Invalid argument")

    with pytest.raises(FileError, match="cannot be shown"):
        terminal.show("text", Gone())
    monkeypatch.setattr(terminal, "GONE", (errno.EPIPE, errno.EINVAL))
    terminal.show("text", Gone())


STOP_AT = """
import sys
class Stop:
    def find_spec(self, name, path=None, target=None):
        if name == {name!r}:
            raise KeyboardInterrupt
sys.meta_path.insert(0, Stop())
"""


@some_in_core(
    "name", ["numpy", "freecad_fiveaxis.core.pipeline.settings", "freecad_fiveaxis.core.pipeline.job"]
)
def test_an_interrupt_while_the_core_is_loaded_stops_quietly(name, roof, tmp_path):
    words = ("mill", roof, "--machine", "trunnion_ac", "-o", tmp_path / "a.ngc")
    done = program(*words, head=STOP_AT.format(name=name))
    assert done.returncode == cli.STOPPED and done.stderr == b"stopped; nothing was written\n"


def test_an_interrupt_before_the_command_line_is_loaded_stops_quietly():
    head = STOP_AT.format(name="freecad_fiveaxis.core.cli")
    code = head + "import runpy\nrunpy.run_module('freecad_fiveaxis', run_name='__main__')"
    done = subprocess.run([sys.executable, "-c", code, "machines"], capture_output=True, timeout=60)
    assert (done.returncode, done.stdout, done.stderr) == (
        cli.STOPPED,
        b"",
        b"stopped; nothing was written\n",
    )


def test_a_source_that_is_a_folder_or_cannot_be_a_file_is_named_for_what_it_is(roof, tmp_path, capsys):
    for source, message in ((tmp_path, "is a folder"), (roof / "x", "Not a directory"), (tmp_path / ("a" * 300), "name too long"),
                         (tmp_path / "gone", "does not exist")):  # fmt: skip
        assert message in refused(
            capsys, tmp_path, "mill", source, "--machine", "trunnion_ac", "-o", tmp_path / "a.ngc"
        )


def test_an_output_whose_name_is_too_long_is_refused_before_the_work(roof, tmp_path, capsys):
    long = tmp_path / ("a" * 300)
    assert "name too long" in refused(capsys, tmp_path, "mill", roof, "--machine", "trunnion_ac", "-o", long)


def test_the_cutter_is_an_option_of_post_too(roof, tmp_path):
    words = ("--machine", "trunnion_ac", "--tolerance", "100", "--quiet")
    assert (
        run(
            "mill",
            roof,
            "--stepover",
            "20",
            *PLAIN_WORDS,
            *words,
            "-o",
            tmp_path / "a.ngc",
            "--cl",
            tmp_path / "a.apt",
        )
        == 0
    )
    assert run("post", tmp_path / "a.apt", "--cutter", "ball:6", *words, "-o", tmp_path / "b.ngc") == 0
