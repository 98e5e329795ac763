# SPDX-License-Identifier: LGPL-2.1-or-later
"""The runner itself, from outside FreeCAD: a failing, a hanging and a crashing test each end it with a code
and a line that says so."""

import os
import pathlib
import shutil
import subprocess

import pytest

RUN = pathlib.Path(__file__).with_name("run")
BAD = {
    "fails": ("assert False", "headless FAILED (pytest's code 1)"),
    "hangs": ("import time; time.sleep(60)", "takes longer than 2 s"),
    "crashes": ("import os; os.abort()", "before the tests did"),
    "leaves": ("import os; os._exit(0)", "before the tests did"),
}

KILLED = "import os; os.abort()"
CAUGHT = "import faulthandler, os, sys; faulthandler.dump_traceback(sys.__stderr__); os._exit(1)"
"""A signal ends FreeCAD, or it says where it was and leaves by itself."""


@pytest.mark.skipif(not shutil.which("freecadcmd"), reason="there is no FreeCAD here")
@pytest.mark.parametrize("kind", BAD)
def test_a_bad_test_ends_the_run_with_a_code_and_a_line(kind, tmp_path):
    code, line = BAD[kind]
    (tmp_path / "test_bad.py").write_text(f"def test_bad():\n    {code}\n")
    environment = {**os.environ, "FIVEAXIS_TEST_LIMIT": "2", "FIVEAXIS_RUN_LIMIT": "60"}
    done = subprocess.run(
        ["bash", RUN, "headless", tmp_path],
        env=environment,
        capture_output=True,
        text=True,
        timeout=90,
        check=False,
    )
    assert done.returncode == 1, done.stdout
    assert line in done.stdout


@pytest.mark.skipif(
    not (shutil.which("freecad") and shutil.which("xvfb-run")),
    reason="there is no FreeCAD with a window here",
)
@pytest.mark.parametrize(
    ("times", "code", "end"), [(1, 0, KILLED), (1, 0, CAUGHT), (2, 1, KILLED), (2, 1, CAUGHT)]
)
def test_a_window_that_crashes_once_goes_on_from_there_and_twice_fails(times, code, end, tmp_path):
    """FreeCAD ends by the signal, or catches it and leaves with 1."""
    body = f"    with open({str(tmp_path / 'log')!r}, 'a+') as log:\n        log.seek(0)\n        seen = len(log.read())\n"
    tests = "def test_before():\n{0}        log.write('b')\n\ndef test_bad():\n{0}        log.write('c')\n    if seen < {1}:\n        {2}\n"
    (tmp_path / "test_bad.py").write_text(tests.format(body, 1 + times, end))
    done = subprocess.run(
        ["bash", RUN, "window", tmp_path], capture_output=True, text=True, timeout=150, check=False
    )
    assert done.returncode == code, done.stdout
    assert (tmp_path / "log").read_text() == "bcc", "the crash, and the second try of that test alone"
    assert done.stdout.count("test_bad: tried once more from there") == 1
    assert 'File "' in done.stdout, "where it was is said"


@pytest.mark.skipif(
    not (shutil.which("freecad") and shutil.which("xvfb-run")),
    reason="there is no FreeCAD with a window here",
)
@pytest.mark.parametrize(("times", "code"), [(1, 0), (2, 1)])
def test_what_fails_in_a_part_is_tried_once_more_when_the_others_have_ended(times, code, tmp_path):
    log = f"    with open({str(tmp_path / 'log')!r}, 'a+') as log:\n        log.write"
    bad = (
        f"def test_bad():\n{log}('b')\n        log.seek(0)\n        assert log.read().count('b') > {times}\n"
    )
    (tmp_path / "test_bad.py").write_text(bad)
    (tmp_path / "test_slow.py").write_text(f"import time\ndef test_slow():\n    time.sleep(20)\n{log}('s')\n")
    environment = {**os.environ, "FIVEAXIS_PARTS": "2"}
    done = subprocess.run(
        ["bash", RUN, "window", tmp_path],
        env=environment,
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )
    assert done.returncode == code, done.stdout
    assert (tmp_path / "log").read_text() == "bsb", "once beside the slow one, once after it"
    assert "tried once more, by themselves:" in done.stdout and "test_bad.py::test_bad" in done.stdout


def test_without_freecad_it_says_that_it_skipped(tmp_path):
    for tool in ("bash", "dirname", "pwd"):
        (tmp_path / tool).symlink_to(shutil.which(tool))
    done = subprocess.run(
        ["bash", RUN], env={"PATH": str(tmp_path)}, capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr
    assert "SKIPPED" in done.stdout
