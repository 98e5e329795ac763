# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which Python works beside FreeCAD, by where it lies in each kind of installation; and that only one that
says so is taken."""

import os
import sys

import pytest

from freecad_fiveaxis.app import interpreters
from freecad_fiveaxis.app.interpreters import Around, candidates, find_worker
from freecad_fiveaxis.core.base import workers

# home, system, executables, prefix, the files there are, those that are candidates, in their order
LAYOUTS = {
    "Debian": (
        "usr/lib/freecad", "linux", ("usr/bin/freecad",), "usr",
        ("usr/bin/freecad", "usr/bin/python3.11", "usr/bin/python3", "usr/bin/python3.12"), ("usr/bin/python3.11", "usr/bin/python3"),
    ),
    "AppImage": (
        "mnt/usr", "linux", ("mnt/usr/bin/freecad",), "mnt/usr", ("mnt/usr/bin/freecad", "mnt/usr/bin/python3.11", "usr/bin/python3.11"),
        ("mnt/usr/bin/python3.11",),
    ),
    "AppImage without a prefix": ("mnt/usr", "linux", ("",), "", ("mnt/usr/bin/python",), ("mnt/usr/bin/python",)),
    "Windows": (
        "FreeCAD 1.0", "win32", ("FreeCAD 1.0/bin/FreeCAD.exe",), "FreeCAD 1.0/bin",
        ("FreeCAD 1.0/bin/FreeCAD.exe", "FreeCAD 1.0/bin/python.exe", "FreeCAD 1.0/bin/pythonw.exe"), ("FreeCAD 1.0/bin/python.exe",),
    ),
    "Windows, conda": (
        "env/Library", "win32", ("env/Library/bin/FreeCAD.exe",), "env", ("env/Library/bin/FreeCAD.exe", "env/python.exe"), ("env/python.exe",),
    ),
    "macOS": (
        "FreeCAD.app/Contents/Resources", "darwin", ("FreeCAD.app/Contents/MacOS/FreeCAD",), "elsewhere",
        ("FreeCAD.app/Contents/MacOS/FreeCAD", "FreeCAD.app/Contents/Resources/bin/python3.11"),
        ("FreeCAD.app/Contents/Resources/bin/python3.11",),
    ),
    "macOS, home unknown": (
        "", "darwin", ("FreeCAD.app/Contents/MacOS/FreeCAD",), "", ("FreeCAD.app/Contents/Resources/bin/python",),
        ("FreeCAD.app/Contents/Resources/bin/python",),
    ),
    "FreeCAD as a module of Python": ("env", "linux", ("env/bin/python3.11",), "env", ("env/bin/python3.11",), ("env/bin/python3.11",)),
    "none": ("usr/lib/freecad", "linux", ("usr/bin/freecad",), "usr", ("usr/bin/freecad", "usr/bin/python2.7"), ()),
}  # fmt: skip


@pytest.mark.parametrize("name", LAYOUTS)
def test_the_python_that_belongs_to_freecad_is_found(name, tmp_path):
    home, system, executables, prefix, files, expected = LAYOUTS[name]
    for file in files:
        result = tmp_path / file
        result.parent.mkdir(parents=True, exist_ok=True)
        result.touch(mode=0o755)
    home, prefix = (str(tmp_path / one) if one else "" for one in (home, prefix))
    around = Around(
        home, "", system, tuple(str(tmp_path / one) if one else "" for one in executables), (prefix,), (3, 11)
    )
    assert candidates(around) == [tmp_path / one for one in expected]


@pytest.mark.skipif(os.name != "posix", reason="permissions of POSIX")
def test_a_python_that_may_not_be_run_is_none(tmp_path):
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "python3.11").touch(mode=0o644)
    assert candidates(Around(str(tmp_path), "", "linux", (), (), (3, 11))) == []


def around_here(*executables, without_window=""):
    return Around("", without_window, executables=executables, prefixes=())


@pytest.fixture(autouse=True)
def forgetful(monkeypatch):
    monkeypatch.setattr(interpreters, "_proven", {})


def test_a_python_that_computes_with_our_versions_is_taken_and_requested_once(tmp_path, monkeypatch):
    around = around_here(sys.executable)
    assert find_worker(around, str(tmp_path)).words[:2] == (
        sys.executable,
        "-c",
    ) and not interpreters.has_no_worker(around)
    monkeypatch.setattr(interpreters, "is_proven", None)
    assert find_worker(around, str(tmp_path)).words[0] == sys.executable and os.listdir(tmp_path) == []


def test_one_with_other_versions_is_not(tmp_path, monkeypatch):
    monkeypatch.setattr(interpreters, "identity", lambda: "0.2.0 3.11 1.0.0 1.0.0")
    around = around_here(sys.executable)
    assert find_worker(around, str(tmp_path)) is None and interpreters.has_no_worker(around)


def test_where_there_is_no_python_freecad_without_a_window_is_requested(tmp_path, monkeypatch):
    """By a file, for FreeCAD takes no code."""
    around = around_here(without_window=sys.executable)
    command = find_worker(around, str(tmp_path))
    assert command.words == (sys.executable, str(tmp_path / "serve.py")) and command.environment[
        "FREECAD_USER_HOME"
    ] == str(tmp_path)
    process = workers.start(command)
    workers.skip_greeting(process.stdout)
    process.communicate(timeout=60)
    assert process.returncode == 0


@pytest.mark.parametrize(
    "words",
    [("no-such-program",), (sys.executable, "-c", "print('Python')"), (sys.executable, "-c", "input()")],
)
def test_a_program_that_says_something_else_is_not_proven(words):
    assert not interpreters.is_proven(workers.Command(words))


def test_one_that_hangs_is_killed_and_not_proven():
    assert not interpreters.is_proven(
        workers.Command((sys.executable, "-c", "import time; time.sleep(3600)")), 0.1
    )
