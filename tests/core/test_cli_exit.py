# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a command ends: exit codes, one line of words, no litter; whatever the input and whenever a signal
comes."""

import json
import os
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
from plain import PLAIN_WORDS
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base import files
from freecad_fiveaxis.core.cli import tasks
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.pipeline import job, job_file

ROOT = Path(__file__).parents[2]
posix = pytest.mark.skipif(os.name != "posix", reason="signals and pipes of POSIX")
STOPS = [("SIGINT", 130), ("SIGTERM", 143), ("SIGHUP", 129)]
NC = "G90 G93\nG1 X-90.9595 Y7.3103 Z227.6341 A1.0664 C148.9685 F60\nG1 X-82.0656 Y-34.8175 Z228.3975 A1.1793 C121.5477 F60\nM2\n"
AUDIT = ("--machine", "mikron_ucp710")


@pytest.fixture
def dome(tmp_path):
    """A cap, 40 x 40 mm, of 800 facets."""
    u = np.linspace(-20.0, 20.0, 21)
    x, y = np.meshgrid(u, u)
    grid = np.stack([x, y, 10.0 - (x**2 + y**2) / 100.0], axis=-1)
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
    write_stl(
        from_triangles(np.stack([[a, b, c], [a, c, d]]).transpose(0, 2, 3, 1, 4).reshape(-1, 3, 3)),
        tmp_path / "dome.stl",
    )
    return tmp_path / "dome.stl"


@pytest.fixture
def nc(tmp_path):
    (tmp_path / "p.ngc").write_text(NC)
    return tmp_path / "p.ngc"


def run(*words):
    return cli.main([os.fspath(word) for word in words])


def one_line(capsys):
    error = capsys.readouterr().err
    assert error.count("\n") == 1 and error.endswith("\n") and "Traceback" not in error
    return error


# ------------------------------------------------------------------------------------------------ faults


@pytest.mark.parametrize(
    "fault", [ZeroDivisionError("two\nlines"), MemoryError(), AssertionError(), RecursionError("too deep")]
)
def test_a_fault_is_one_line_that_says_where_to_report_it(fault, nc, tmp_path, monkeypatch, capsys):
    def fail(settings, progress):
        raise fault

    monkeypatch.setattr(job, "run", fail)
    monkeypatch.delenv(cli.TRACEBACK, raising=False)
    assert run("audit", nc, *AUDIT, "--blocks", tmp_path / "a.csv") == cli.FAULT == 3
    error = one_line(capsys)
    assert type(fault).__name__ in error and cli.REPORT_TO in error and "test_cli_exit.py line" in error
    assert ("out of memory" in error) == isinstance(fault, MemoryError)
    assert "nothing was written" in error and os.listdir(tmp_path) == ["p.ngc"]


def test_the_traceback_is_shown_where_it_is_requested(nc, monkeypatch, capsys):
    monkeypatch.setattr(job, "run", lambda settings, progress: 1 / 0)
    monkeypatch.setenv(cli.TRACEBACK, "1")
    assert run("audit", nc, *AUDIT) == cli.FAULT
    lines = capsys.readouterr().err.splitlines()
    assert (
        lines[0].startswith("Traceback") and "ZeroDivisionError" in lines[-2] and cli.REPORT_TO in lines[-1]
    )


def test_a_fault_after_the_files_are_written_says_so(nc, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(tasks, "_show_report", lambda parts, written: 1 / 0)
    assert run("audit", nc, *AUDIT, "--blocks", tmp_path / "a.csv") == cli.FAULT
    assert f"written before: {tmp_path / 'a.csv'};" in one_line(capsys)


@pytest.mark.parametrize("name", ["numpy", "scipy"])
def test_a_package_that_is_missing_is_named_with_what_to_type(name, tmp_path):
    (tmp_path / f"{name}.py").write_text(f"raise ModuleNotFoundError('no {name}', name='{name}')\n")
    nc = tmp_path / "part.ngc"
    nc.write_text("G0 X0 Y0 Z0\nG1 X1 F100\n")
    words = [sys.executable, "-m", "freecad_fiveaxis", "audit", str(nc), "--machine", "trunnion_ac"]
    done = subprocess.run(
        words, cwd=ROOT, env={**os.environ, "PYTHONPATH": str(tmp_path)}, capture_output=True, text=True
    )
    assert done.returncode == cli.UNUSABLE and done.stdout == ""
    assert (
        done.stderr.startswith(f"fiveaxis: {name} is not installed")
        and "pip install numpy scipy" in done.stderr
    )
    assert done.stderr.count("\n") == 1


def test_a_module_of_our_own_that_is_missing_is_a_fault(nc, tmp_path, monkeypatch, capsys):
    def lost(*_):
        raise ModuleNotFoundError("No module named 'freecad_fiveaxis.lost'", name="freecad_fiveaxis.lost")

    monkeypatch.setattr("freecad_fiveaxis.core.pipeline.job.make", lost)
    assert run("audit", str(nc), "--machine", "trunnion_ac") == cli.FAULT
    assert cli.REPORT_TO in capsys.readouterr().err


def test_faults_are_reported_where_the_package_says():
    tracker = [url.text for url in ET.parse(ROOT / "package.xml").iter() if url.get("type") == "bugtracker"]
    assert tracker == [cli.REPORT_TO]


# ------------------------------------------------------------------------------------------------ signals


HEARS = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP"):
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
"""
"""A process takes over what its parent ignores: SIGHUP under nohup, SIGINT behind an ampersand."""


def start(*words, head=""):
    """The command line in a process of its own; ``head``: Python to run before."""
    code = f"{HEARS}\n{head}\nimport sys, runpy\nsys.argv[0] = 'fiveaxis'\nrunpy.run_module('freecad_fiveaxis', run_name='__main__')"
    command = [sys.executable, "-c", code, *(os.fspath(word) for word in words)]
    return subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def mill(dome, stepover, head=""):
    folder = dome.parent
    words = (
        "--machine",
        "trunnion_ac",
        "--stepover",
        stepover,
        "-o",
        folder / "a.ngc",
        "--cl",
        folder / "a.apt",
        "--blocks",
        folder / "a.csv",
        *PLAIN_WORDS,
    )
    return start("mill", dome, *words, head=head)


@posix
@some_in_core(("name", "code"), STOPS)
def test_a_signal_during_the_work_leaves_nothing(name, code, dome, tmp_path):
    mark = tmp_path / "mark"  # made when the work has begun
    head = f"from freecad_fiveaxis.core.pipeline import job; old = job.run\ndef run(*given):\n    open({str(mark)!r}, 'w'); return old(*given)\njob.run = run"
    done = mill(dome, "0.05", head)  # seconds of work, also for whoever sees the mark late
    until(mark.exists)
    done.send_signal(getattr(signal, name))
    _, error = done.communicate(timeout=300)
    assert (done.returncode, error) == (code, b"stopped; nothing was written\n")
    assert sorted(os.listdir(tmp_path)) == ["dome.stl", "mark"]


DELETED = """
import signal
from freecad_fiveaxis.core.pipeline import job
class Last:
    def __del__(self):
        signal.raise_signal(signal.SIGINT)
old = job.run
def run(*given):
    Last()
    return old(*given)
job.run = run
"""


@posix
def test_a_signal_that_comes_where_python_ignores_exceptions_ends_the_work_before_anything_is_written(
    dome, tmp_path
):
    done = mill(dome, "10", DELETED)
    _, error = done.communicate(timeout=300)
    assert (done.returncode, error) == (130, b"stopped; nothing was written\n")
    assert os.listdir(tmp_path) == ["dome.stl"]


SLOW = """
import os, time
old = os.replace
def replace(*names):
    time.sleep(0.15)
    old(*names)
os.replace = replace
"""


@posix
@some_in_core(("name", "code"), STOPS)
def test_a_signal_while_files_take_their_place_waits_for_them(name, code, dome, tmp_path):
    done = mill(dome, "10", SLOW)
    until(lambda: any(name.endswith(".part") for name in os.listdir(tmp_path)))
    done.send_signal(getattr(signal, name))
    _, error = done.communicate(timeout=300)
    assert done.returncode == code
    assert error.startswith(b"stopped; written before: ") and error.count(b"\n") == 1 and b"a.csv" in error
    assert sorted(os.listdir(tmp_path)) == ["a.apt", "a.csv", "a.ngc", "dome.stl"]
    assert (tmp_path / "a.ngc").read_bytes().rstrip().endswith(b"M2")


@posix
def test_a_second_signal_ends_at_once_and_a_signal_that_is_ignored_stays_so(tmp_path, nc):
    head = """
import os, signal
from freecad_fiveaxis.core.pipeline import job
signal.signal(signal.SIGHUP, signal.SIG_IGN)
def run(*given):
    os.kill(os.getpid(), signal.SIGHUP)
    try:
        os.kill(os.getpid(), signal.SIGTERM)
    finally:
        os.kill(os.getpid(), signal.SIGINT)
        raise RuntimeError("still there")
job.run = run
"""
    done = start("audit", nc, *AUDIT, head=head)
    assert done.communicate(timeout=300)[1] == b"stopped; nothing was written\n" and done.returncode == 143


@pytest.mark.thorough
@posix
def test_a_signal_that_a_module_makes_another_error_of_is_still_a_signal(nc):
    head = """
import os, signal
from freecad_fiveaxis.core.pipeline import job
def run(*given):
    try:
        os.kill(os.getpid(), signal.SIGINT)
    except KeyboardInterrupt:
        raise ImportError("numpy.core.multiarray failed to import")
job.run = run
"""
    done = start("audit", nc, *AUDIT, head=head)
    assert done.communicate(timeout=300)[1] == b"stopped; nothing was written\n" and done.returncode == 130


def until(happens, seconds=300.0):
    end = time.monotonic() + seconds
    while not happens():
        assert time.monotonic() < end
        time.sleep(0.005)


# ------------------------------------------------------------------------------------------------ names


@posix
def test_control_characters_in_names_are_shown_escaped(nc, tmp_path, capsys):
    assert run("audit", "gone\n\x1b[2J.ngc", *AUDIT) == cli.UNUSABLE
    assert "gone\\n\\x1b[2J.ngc does not exist" in one_line(capsys)
    named, blocks = tmp_path / "p\n.ngc", tmp_path / "b\r.csv"
    nc.rename(named)
    assert (
        run("audit", named, *AUDIT, "--blocks", blocks, "--report", tmp_path / "a.txt")
        == cli.DONE_WITH_ERRORS
    )
    shown = capsys.readouterr().out
    assert (
        shown.startswith("p\\n.ngc: audit on") and "b\\r.csv" in shown.splitlines()[-2] and "\r" not in shown
    )
    assert (tmp_path / "a.txt").read_text().startswith("p\\n.ngc: audit on") and blocks.exists()


def test_words_that_are_no_options_are_shown_on_one_line_too(capsys):
    with pytest.raises(SystemExit, match="2"):
        run("machines", "--no\nsuch")
    assert capsys.readouterr().err.splitlines()[-1].endswith("unrecognized arguments: --no\\nsuch")


# ---------------------------------------------------------------------------------------------- hostile input


@posix
@pytest.mark.parametrize("what", ["/dev/zero", "pipe"])
@pytest.mark.parametrize(
    "words",
    [("run", "IT"), ("audit", "IT", *AUDIT), ("audit", "p.ngc", "--machine", "IT.fcm"), ("audit", "p.ngc", *AUDIT, "--against", "IT.stl"),
     ("audit", "p.ngc", *AUDIT, "--against", "IT.apt"), ("post", "IT.apt", *AUDIT, "-o", "a.ngc"), ("mill", "IT.stl", *AUDIT, "-o", "a.ngc"),
     ("recover", "p.ngc", "IT", "-o", "a.fcm"), ("import-machine", "IT.ini", "-o", "a.fcm"), ("import-machine", "hal.ini", "-o", "a.fcm"),
     ("mill", "dome.stl", "--faces", "IT.stl", *AUDIT, "-o", "a.ngc")],
)  # fmt: skip
def test_what_has_no_end_is_refused_at_once(words, what, nc, dome, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    os.mkfifo("pipe")
    for ending in ("", ".fcm", ".stl", ".apt", ".ini"):
        os.symlink(what, "IT" + ending)
    (tmp_path / "hal.ini").write_text(
        "[HAL]\nHALFILE = IT\n[KINS]\nKINEMATICS = xyzac-trt-kins\n[TRAJ]\nCOORDINATES = XYZAC\n"
    )
    before = sorted(os.listdir())
    assert run(*words) == cli.UNUSABLE
    assert "no ordinary file" in one_line(capsys) and sorted(os.listdir()) == before


HAL = "[HAL]\nHALFILE = {}\n[KINS]\nKINEMATICS = xyzac-trt-kins\n[TRAJ]\nCOORDINATES = XYZAC\n"


@pytest.mark.parametrize(
    ("hal", "named", "message"),
    [({"a.hal": "source a.hal\n" * 10}, "a.hal", "a.hal line 1: a.hal and others include one another in a circle"),
     ({f"{i}.hal": f"source {i + 1}.hal\n" * 10 * (i < 7) for i in range(8)}, "0.hal", "more than 200 files"),
     ({}, "~nosuchuser/x", "b.ini line 2: ~nosuchuser/x begins with the folder of a user who is not known")],
)  # fmt: skip
def test_hal_files_come_to_an_end(hal, named, message, tmp_path, capsys):
    for name, text in hal.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "b.ini").write_text(HAL.format(named))
    assert run("import-machine", tmp_path / "b.ini", "-o", tmp_path / "b.fcm") == cli.UNUSABLE
    assert message in one_line(capsys)


NEST = "[" * 900 + "]" * 900


@pytest.mark.parametrize(
    ("option", "named"),
    [('"tolerance": [1]', "tolerance"), ('"shank": [[]]', "shank"), ('"shank": [["10x10"]]', "shank"), (f'"shank": {NEST}', "shank"),
     (f'"tolerance": {NEST}', "tolerance"), (f'"report": {NEST}', "report"), (f'"machine": {NEST}', "machine"), (f'"origin": {NEST}', "origin"),
     (f'"cutter": {NEST}', "cutter"), ('"tolerance": true', "tolerance"), ('"tolerance": "much"', "tolerance"), ('"tolerance": {}', "tolerance"),
     ('"tolerance": 1' + "0" * 400, "tolerance"), ('"tolerance": NaN', "NaN"), ('"tolerance": 1, "tolerance": 2', "tolerance"),
     ('"max-tilt": 1, "max_tilt": 2', "max_tilt"), ('"report": {"a.html": 1}', "report"), ('"origin": [1, 2]', "origin"),
     ('"gouge": ["off"]', "gouge"), ('"output": 5', "output")],
)  # fmt: skip
def test_a_value_of_the_wrong_kind_is_named(option, named, tmp_path, capsys):
    machine = "" if '"machine"' in option else '"machine": "trunnion_ac", '
    (tmp_path / "job.json").write_text(f'{{"task": "mill", "source": "a.stl", {machine}{option}}}')
    assert run("run", tmp_path / "job.json") == cli.UNUSABLE
    error = one_line(capsys)
    assert named.replace("_", "-") in error.replace("_", "-") and len(error) < 600


def test_numbers_may_be_texts_as_the_command_line_has_them(tmp_path):
    (tmp_path / "job.json").write_text(
        json.dumps({"task": "mill", "source": "a.stl", "machine": "trunnion_ac", "tolerance": "0.5in"})
    )
    assert job_file.read_job(str(tmp_path / "job.json")).proof.tolerance == pytest.approx(12.7)


def program(*words, **environment):
    kept = {name: value for name, value in os.environ.items() if name in ("PATH", "SYSTEMROOT")}
    command = [sys.executable, "-m", "freecad_fiveaxis", *(os.fspath(word) for word in words)]
    return subprocess.run(command, cwd=ROOT, env=kept | environment, capture_output=True, timeout=300)


@pytest.mark.thorough
def test_without_docstrings_the_lists_and_the_help_are_still_there():
    for words in (["strategies"], ["mill", "--help"]):
        done = program(*words, PYTHONOPTIMIZE="2")
        assert (done.returncode, done.stderr) == (0, b"") and b"facet_mean" in done.stdout


@pytest.mark.thorough
def test_a_plain_locale_without_a_home_is_enough(nc, tmp_path):
    named = tmp_path / "Stück.ngc"
    nc.rename(named)
    done = program("audit", named, *AUDIT, LANG="C", LC_ALL="C", PYTHONUTF8="0", PYTHONCOERCECLOCALE="0")
    assert (done.returncode, done.stderr) == (1, b"") and b": audit on mikron_ucp710" in done.stdout


APT = "PARTNO X\nUNITS/MM\nCUTTER/10\nMULTAX\nFEDRAT/1E300,MMPM\nGOTO/0,0,0,0,0,1\n{}\nGOTO/20,0,0,0,1,1\nFINI\n"


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("GOTO/1E300,0,0,0,0,1", 2),
        ("GODLTA/-2E7", 2),
        ("GOTO/1,1,1,0,0,1E300", 2),
        ("SPINDL/1E300\nFEDRAT/1E300,MMPR", 0),
        ("MOVARC/1E200,0,0,0,0,1,1E200,ANGLE,90", 1),
    ],
)
def test_numbers_beyond_all_bounds_make_no_warnings(line, code, tmp_path, capsys):
    (tmp_path / "a.apt").write_text(APT.format(line))
    words = (
        "post",
        tmp_path / "a.apt",
        "--machine",
        "trunnion_ac",
        "--tolerance",
        "100",
        "-o",
        tmp_path / "a.ngc",
        "--quiet",
    )
    assert run(*words) == code, capsys.readouterr().err  # a warning here is an error, so a fault
    assert ("line" in capsys.readouterr().err) == (code == 2)


@pytest.mark.thorough
def test_a_warning_of_numpys_does_not_reach_the_terminal(nc):
    head = "import numpy as np\nfrom freecad_fiveaxis.core.pipeline import job\nold = job.run\ndef run(*given):\n    np.array(1e300) * 1e300\n    return old(*given)\njob.run = run"
    done = start("audit", nc, *AUDIT, head=head)
    assert done.communicate(timeout=300)[1] == b"" and done.returncode == 1


def test_what_was_written_is_of_this_command_alone(nc, tmp_path, capsys):
    files.written.append("something else")
    assert run("audit", nc, *AUDIT, "--blocks", tmp_path / "a.csv", "--quiet") == cli.DONE_WITH_ERRORS
    assert files.written == [str(tmp_path / "a.csv")]
