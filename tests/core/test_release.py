# SPDX-License-Identifier: LGPL-2.1-or-later
"""``scripts/release`` in a small repository: the branch for FreeCAD's Addon Manager, and nothing else
changed."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / "scripts" / "release"
FILES = (
    "Init.py",
    "package.xml",
    "freecad_fiveaxis/a.py",
    "resources/tests/b.svg",
    "tests/core/c.py",
    "scripts/d",
    "benchmarks/e.py",
    "Makefile",
)

pytestmark = [
    pytest.mark.texts,
    pytest.mark.skipif(os.name != "posix" or shutil.which("git") is None, reason="a shell script over git"),
]


def git(folder, *words):
    who = ["-c", "user.name=a", "-c", "user.email=a@b"]
    done = subprocess.run(
        ["git", *who, *words], cwd=folder, capture_output=True, text=True, timeout=60, check=True
    )
    return done.stdout.strip()


@pytest.fixture
def project(tmp_path):
    """A repository with some of what ours has, the script in it, and a change that nobody has committed."""
    for name in FILES:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(f"of {name}\n")
    (tmp_path / "package.xml").write_text(
        '<version>1.2.3</version>\n<url type="repository" branch="main">here</url>\n'
    )
    shutil.copy(SCRIPT, tmp_path / "scripts" / "release")
    git(tmp_path, "init", "-q", "-b", "main")
    for key, value in (("user.name", "a"), ("user.email", "a@b")):
        git(tmp_path, "config", key, value)
    git(tmp_path, "add", "-A")
    git(tmp_path, "commit", "-qm", "one")
    (tmp_path / "Init.py").write_text("changed\n")
    (tmp_path / "new.py").write_text("staged\n")
    git(tmp_path, "add", "new.py")
    return tmp_path


def release(folder, *branch):
    return subprocess.run(
        ["bash", folder / "scripts" / "release", *branch],
        cwd=folder.parent,
        capture_output=True,
        text=True,
        timeout=60,
    )


def test_the_branch_has_what_freecad_needs_and_names_itself(project):
    assert release(project).returncode == 0
    assert git(project, "ls-tree", "-r", "--name-only", "release").split() == [
        "Init.py", "freecad_fiveaxis/a.py", "package.xml", "resources/tests/b.svg",
    ]  # fmt: skip
    assert git(project, "show", "release:Init.py") == "of Init.py"
    assert 'branch="release"' in git(project, "show", "release:package.xml")
    assert git(project, "log", "-1", "--format=%s", "release") == "Release 1.2.3"
    assert git(project, "rev-parse", "HEAD") in git(project, "log", "-1", "--format=%B", "release")


def test_neither_the_work_tree_nor_the_index_nor_head_is_touched(project):
    before = [
        git(project, *words) for words in (("status", "--porcelain"), ("rev-parse", "HEAD"), ("write-tree",))
    ]
    assert release(project, "addon").returncode == 0
    assert [
        git(project, *words) for words in (("status", "--porcelain"), ("rev-parse", "HEAD"), ("write-tree",))
    ] == before
    assert git(project, "branch", "--format=%(refname:short)").split() == ["addon", "main"]
    assert (project / "tests" / "core" / "c.py").is_file() and (
        project / "Init.py"
    ).read_text() == "changed\n"


def test_a_later_release_follows_the_one_before_and_the_same_makes_none(project):
    release(project)
    first = git(project, "rev-parse", "release")
    assert "already" in release(project).stdout and git(project, "rev-parse", "release") == first
    git(project, "commit", "-qam", "two")
    assert release(project).returncode == 0
    assert (
        git(project, "rev-parse", "release^") == first
        and git(project, "show", "release:Init.py") == "changed"
    )


def test_no_branch_of_others_is_written(project):
    git(project, "branch", "theirs")
    theirs = git(project, "rev-parse", "theirs")
    for branch, why in (
        ("main", "checked out"),
        ("theirs", "not made by this script"),
        ("no..name", "no name"),
    ):
        done = release(project, branch)
        assert done.returncode == 2 and why in done.stderr and len(done.stderr.splitlines()) == 1
    assert git(project, "rev-parse", "theirs") == theirs


def test_what_is_left_out_is_there_and_what_the_package_names_is_not_left_out():
    line = next(
        line for line in SCRIPT.read_text(encoding="utf-8").splitlines() if line.startswith("LEFT_OUT=(")
    )
    left_out = set(line.removeprefix("LEFT_OUT=(").removesuffix(")").split())
    assert {"tests", "benchmarks", "out"} <= left_out and not left_out & {
        "freecad_fiveaxis",
        "resources",
        "Init.py",
        "package.xml",
    }
    assert all((ROOT / name).exists() for name in left_out - {"out"})
