# SPDX-License-Identifier: LGPL-2.1-or-later
"""``make changed``: the tests that reach a change by imports, nearest first, and none that does not."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from import_graph import build_graph, distances, imports_of

pytestmark = pytest.mark.texts

ROOT = Path(__file__).parents[2]
FILES = {
    "house/__init__.py": "from .roof import tiles\nfrom .wall import bricks\n",
    "house/roof.py": "from .wood import beam\n\n\ndef tiles():\n    return beam\n",
    "house/wall.py": "bricks = 1\n",
    "house/wood.py": "beam = 2\n",
    "house/plan.txt": "north\n",
    "tests/core/test_roof.py": "from house import tiles\n\n\ndef test_tiles():\n    assert tiles() == 2\n",
    "tests/core/test_wall.py": "from house import bricks\n\n\ndef test_bricks():\n    assert bricks == 1\n",
    "tests/core/test_wood.py": "from house.wood import beam\n\n\ndef test_beam():\n    assert beam == 2\n",
    "tests/core/test_plan.py": "def test_plan():\n    from pathlib import Path\n\n    assert Path('house/plan.txt').read_text()\n",
    "tests/gui/test_window.py": "from house.roof import tiles\n",
}


@pytest.fixture
def house(tmp_path):
    """A small project, committed."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    for name in ("tests/import_graph.py", "tests/conftest.py", "scripts/changed"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    (tmp_path / "pyproject.toml").write_text(
        '[tool.pytest.ini_options]\nmarkers = ["rs274", "slow"]\npythonpath = ["."]\n'
    )
    git(tmp_path, "init", "-q")
    commit(tmp_path)
    return tmp_path


def git(folder, *words):
    around = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    who = ["-c", "user.name=Somebody", "-c", "user.email=somebody@users.noreply.github.com"]
    subprocess.run(["git", *who, *words], cwd=folder, env=around, check=True, capture_output=True)


def commit(folder):
    git(folder, "add", "-A")
    git(folder, "commit", "-qm", "house")


def changed(folder, *words, **around):
    command = [sys.executable, "scripts/changed", *words]
    around = {
        **os.environ,
        "PYTEST_ADDOPTS": "-p no:cacheprovider",
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "",
        **around,
    }
    return subprocess.run(
        command, cwd=folder, env=around, capture_output=True, text=True, timeout=120, check=False
    )


def listed(folder, *words):
    done = changed(folder, "--list", *words)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()[1:]


def test_the_tests_that_reach_a_change_are_named_nearest_first(house):
    (house / "house/wood.py").write_text("beam = 3\n")
    assert listed(house) == [
        "1 tests/core/test_wood.py",
        "2 tests/core/test_roof.py",
        "2 tests/gui/test_window.py",
    ]
    commit(house)
    assert len(listed(house)) == 3, "nothing is changed: the last commit counts"
    (house / "house/wall.py").write_text("bricks = 2\n")
    assert listed(house) == ["1 tests/core/test_wall.py"], (
        "what a package brings together is used by who takes it"
    )
    assert len(listed(house, "HEAD~1")) == 4


def test_a_file_that_is_no_python_is_reached_by_those_that_name_it(house):
    (house / "house/plan.txt").write_text("south\n")
    assert "0 tests/core/test_plan.py" in listed(house) and len(listed(house)) == 5, (
        "and by the files of its own folder"
    )
    (house / "house/plan.txt").write_text("north\n")
    (house / "README.md").write_text("roof\n")
    assert listed(house) == []


def test_they_are_run_and_a_failure_is_reported(house):
    (house / "house/wood.py").write_text("beam = 3\n")
    done = changed(house)
    assert done.returncode == 1 and "2 failed" in done.stdout, done.stdout + done.stderr
    assert "1 files of tests/gui reach it too: make window" in done.stdout


def test_what_is_left_when_the_minute_is_over_is_counted(house):
    text = (house / "scripts/changed").read_text()
    (house / "scripts/changed").write_text(text.replace("MINUTE = 45.0", "MINUTE = -1.0"))
    (house / "house/wood.py").write_text("beam = 3\n")
    done = changed(house)
    assert done.returncode == 0 and "2 skipped" in done.stdout, done.stdout + done.stderr


def test_an_unknown_commit_is_one_line(house):
    done = changed(house, "nowhere")
    assert done.returncode == 1 and "nowhere" in done.stderr and "Traceback" not in done.stderr


def test_the_graph_of_this_project_leads_from_a_module_to_its_tests():
    core = ROOT / "freecad_fiveaxis/core"
    files = [*core.rglob("*.py"), ROOT / "tests/core/test_vectors.py", ROOT / "tests/core/test_quantity.py"]
    steps = distances(
        build_graph(files, [ROOT, ROOT / "tests", ROOT / "tests/core"]), [core / "base/vectors.py"]
    )
    assert steps[ROOT / "tests/core/test_vectors.py"] == 1 and steps[core / "pipeline/job.py"] > 1
    assert core / "base/errors.py" not in steps and ROOT / "tests/core/test_quantity.py" not in steps
    assert core / "base/vectors.py" in set(imports_of(ROOT / "tests/core/test_vectors.py", [ROOT]))
