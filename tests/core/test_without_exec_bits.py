# SPDX-License-Identifier: LGPL-2.1-or-later
"""A folder unpacked from a ZIP: no file in it may be executed, and every target works all the same."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SCRIPTS = ("scripts", ".ci", "tests/freecad", "tests/sitting")
BOTH = ("lint", "core", "sitting")
SHORT = (*BOTH, "headless-short", "interpreter", "window-short")
ALL = (
    *BOTH,
    "headless",
    "slow",
    "window",
    "linuxcnc",
    "runner",
    "large",
    "oldest",
    "docs",
    "demo",
    "chroots",
    "trixie",
    "forky",
)
TARGETS = (
    "demo",
    "test",
    "test-all",
    "changed",
    *sorted({*SHORT, *ALL}),
    "freecad",
    "test-matrix",
    "install",
    "bench",
    "bench-window",
)

pytestmark = [
    pytest.mark.texts,
    pytest.mark.skipif(
        os.name != "posix" or not shutil.which("make") or not shutil.which("bash"),
        reason="needs make and bash",
    ),
]


@pytest.fixture
def unpacked(tmp_path):
    """Makefile and scripts, none of them executable, with a Python, a pip and a make that only tell how they
    were called."""
    folder = tmp_path / "unpacked"
    for part in SCRIPTS:
        shutil.copytree(ROOT / part, folder / part, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "Makefile", folder)
    for path in folder.rglob("*"):
        if path.is_file():
            path.chmod(0o644)
    for name in (".venv/bin/python", ".venv/bin/pip", "tools/make"):
        stub(folder / name)
    return folder


def stub(path):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f'#!/bin/sh\necho "{path.name} $*"\n')
    path.chmod(0o755)


def run(folder, *words, **more):
    around = {"HOME": str(folder / "home"), "PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", **more}
    return subprocess.run(words, cwd=folder, env=around, capture_output=True, text=True, timeout=60)


def test_no_target_executes_a_script_by_its_name(unpacked):
    done = run(unpacked, shutil.which("make"), "-n", *TARGETS)
    assert done.returncode == 0, done.stderr
    scripts = re.findall(r"^.*(?:scripts/|tests/\w+/run\b).*$", done.stdout, re.MULTILINE)
    assert len(scripts) > len(TARGETS)
    assert not [line for line in scripts if not line.startswith(("bash ", ".venv/bin/python "))]
    inner = [line for line in scripts if re.search(r"freecad_chroot \w+ .", line)]
    assert inner and all(re.search(r"freecad_chroot \w+ bash ", line) for line in inner)


def test_the_demo_runs_to_its_end(unpacked):
    done = run(unpacked, shutil.which("make"), "demo")
    assert done.returncode == 0, done.stderr
    assert "pip install" in done.stdout and done.stdout.count("-m freecad_fiveaxis mill") == 3
    assert done.stdout.endswith("out/saddle_cured.html\n")


def test_the_add_on_is_installed(unpacked):
    done = run(
        unpacked,
        "bash",
        "-c",
        f"PATH={unpacked}/tools:$PATH; exec {shutil.which('make')} install",
        PATH=without_freecad(unpacked),
    )
    assert done.returncode == 0, done.stderr
    links = [path for path in (unpacked / "home").rglob("FiveAxis") if path.is_symlink()]
    assert [link.resolve() for link in links] == [unpacked.resolve()]


def without_freecad(folder):
    """A PATH on which there is no FreeCAD to be asked where its folder is."""
    bare = folder / "bare"
    bare.mkdir()
    for tool in (
        "bash",
        "sh",
        "dirname",
        "mkdir",
        "ln",
        "find",
        "readlink",
        "sed",
        "sort",
        "head",
        "cat",
        "rm",
    ):
        (bare / tool).symlink_to(shutil.which(tool))
    return str(bare)


def test_what_ci_runs_goes_through_make(unpacked):
    done = run(unpacked, "bash", ".ci/run", PATH=f"{unpacked}/tools:/usr/bin:/bin")
    assert done.returncode == 0, done.stderr
    assert "make test-all\n" in done.stdout


@pytest.mark.parametrize(("target", "rings"), [("test", SHORT), ("test-all", ALL)])
def test_each_ring_is_run_once(unpacked, target, rings):
    """What ``test`` has in short, LinuxCNC's interpreter and the way of a user, ``test-all`` has whole."""
    done = run(unpacked, shutil.which("make"), target, PATH=f"{unpacked}/tools:/usr/bin:/bin")
    assert done.returncode == 0, done.stdout + done.stderr
    assert sorted(re.findall(r"^make --no-print-directory (\S+)$", done.stdout, re.MULTILINE)) == sorted(
        rings
    )


@pytest.mark.parametrize("script", ["tests/freecad/run", "tests/sitting/run"])
def test_a_ring_in_freecad_starts(unpacked, script):
    done = run(unpacked, "bash", script, PATH=without_freecad(unpacked))
    assert done.returncode == 0, done.stderr
    assert "SKIPPED" in done.stdout
