# SPDX-License-Identifier: LGPL-2.1-or-later
"""Integers of 32 bits where numpy 1 on Windows makes them: the same bytes come out of every stage."""

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest
from thorough import some_in_core

from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.geometry.mesh import from_faces, write_stl

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
RUN = "import windows_integers\nfrom freecad_fiveaxis.core.cli import main\nsys.exit(main(sys.argv[1:]))"
MILL = [
    "mill",
    "dome.stl",
    "--machine",
    "trunnion_ac",
    "--stepover",
    "12",
    "--max-axis-angle",
    "50",
    "--tolerance",
    "0.1",
]
FILES = ["-o", "a.ngc", "--cl", "a.apt", "--blocks", "a.csv", "--report", "a.json"]


@pytest.fixture
def folder(tmp_path):
    """A folder with a coarse dome, whose top passes the pole."""
    result = ROOT / "resources" / "examples" / "make_parts.py"
    spec = importlib.util.spec_from_file_location("make_parts", result)
    parts = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(parts)
    write_stl(from_faces(*parts.dome(radius=20.0, rings=6, sectors=24)), tmp_path / "dome.stl")
    return tmp_path


def files(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.mark.thorough
@pytest.mark.oldest
@some_in_core(
    "options",
    [
        ["--tool-axis", "minimax", "--gouge", "off"],
        ["--singularity", "deform", "--rest", "on", "--cutter", "bull:10:2"],
    ],
    kept=(1,),
)
def test_a_part_is_milled_to_the_same_bytes(folder, options, monkeypatch):
    monkeypatch.chdir(folder)
    assert main([*MILL, *options, *FILES]) in (0, 1)
    here = files(folder)
    assert len(here) == 5
    for name in here.keys() - {"dome.stl"}:
        (folder / name).unlink()
    around = f"import sys; sys.path[:0] = [{str(HERE)!r}, {str(ROOT)!r}]\n{RUN}"
    words = [sys.executable, "-c", around, *MILL, *options, *FILES]
    done = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert done.returncode in (0, 1), done.stderr
    assert files(folder) == here


def test_a_mesh_with_vertices_that_no_facet_uses_is_taken():
    code = (
        f"import sys; sys.path[:0] = [{str(HERE)!r}, {str(ROOT)!r}]\nimport windows_integers, numpy as np\n"
        "from freecad_fiveaxis.core.geometry.mesh import from_faces\n"
        "print(from_faces(np.eye(4, 3), np.array([[0, 1, 3]])).face.dtype)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert (done.stdout.strip(), done.returncode) == ("int64", 0), done.stderr


def test_the_integers_are_narrow_for_the_core_alone():
    code = (
        f"import sys; sys.path[:0] = [{str(HERE)!r}]\nimport windows_integers, numpy as np\n"
        "core = compile('found = np.arange(3), np.full(3, 1), np.cumsum([True] == np.ones(2)), np.arange(3.0)', 'freecad_fiveaxis/x.py', 'exec')\n"
        "names = {'np': np}; exec(core, names)\nprint(*(one.dtype for one in (*names['found'], np.arange(3))))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.stdout.split() == ["int32", "int32", "int32", "float64", "int64"], done.stderr
