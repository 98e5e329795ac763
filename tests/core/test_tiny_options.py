# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options so small that the work would never end, or numbers overflow, are refused before it; a long mill is stopped at once."""

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from gouge_examples import blade_beside_hub, step
from thorough import some_in_core

from freecad_fiveaxis.core.geometry.mesh import write_stl

MILL = [sys.executable, "-W", "error", "-m", "freecad_fiveaxis", "mill"]


@pytest.mark.parametrize(
    "given",
    ["--clearance 1e-320", "--coedge-tolerance 1e-320", "--scallop 1e-9", "--stepover 1e-4", "--scallop 1e-320"]
    + ["--tolerance 1e-320", "--tolerance 1e-30", "--least-interval 1e-45"],
)
def test_an_option_that_is_too_small_is_refused_in_one_line(given, tmp_path):
    part, out = tmp_path / "part.stl", tmp_path / "part.ngc"
    write_stl(step(), part)
    more = [] if given.startswith(("--scallop", "--stepover")) else ["--stepover", "4"]
    words = [
        *MILL,
        part,
        "--machine",
        "trunnion_ac",
        "--tool-axis",
        "facet_mean",
        "--gouge",
        "off",
        *given.split(),
        *more,
        "-o",
        out,
        "--quiet",
    ]
    done = subprocess.run(words, capture_output=True, text=True, timeout=30)
    assert done.returncode == 2 and len(done.stderr.splitlines()) == 1 and not out.exists(), done.stderr
    assert "give a larger" in done.stderr or "at least" in done.stderr, done.stderr


@some_in_core("size", [1e-40, 1e-20, 1e-8])
def test_a_part_that_is_smaller_than_any_is_refused_with_its_size(size, tmp_path):
    """Its facets' areas are no numbers any more; a pass of them would be divided without end."""
    part, out = tmp_path / "part.stl", tmp_path / "part.ngc"
    corners = size * np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0.5]], [[1, 0, 0], [1, 1, 0], [0, 1, 0.5]]])
    lines = [
        f"facet normal 0 0 0\nouter loop\n{''.join(f'vertex {x} {y} {z}' + chr(10) for x, y, z in facet)}endloop\nendfacet"
        for facet in corners
    ]
    part.write_text("\n".join(["solid part", *lines, "endsolid part"]))
    words = [*MILL, part, "--machine", "trunnion_ac", "--scallop", "1e-6", "--least-interval", "1e-6", "-o", out, "--quiet"]
    done = subprocess.run(words, capture_output=True, text=True, timeout=30)
    assert done.returncode == 2 and len(done.stderr.splitlines()) == 1 and not out.exists(), done.stderr
    assert f"the whole part is {size:.4g} mm long" in done.stderr and "check the units" in done.stderr


def hear_ctrl_c():
    """A process takes over what its parent ignores: SIGINT behind an ampersand."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="Windows sends no SIGINT to one process")
@pytest.mark.parametrize("after", [2.0, 3.5, 5.0, *(pytest.param(late, marks=pytest.mark.large) for late in (8.0, 12.0))])
def test_a_long_mill_hears_ctrl_c_and_writes_nothing(after, tmp_path):
    """After 2 s it slices or lifts, later it lifts and checks; it takes more than 20 s in all. How soon: benchmarks/bench_stop.py."""
    part, out = tmp_path / "part.stl", tmp_path / "part.ngc"
    write_stl(blade_beside_hub(cells=120), part)
    words = [*MILL, part, "--machine", "trunnion_ac", "--scallop", "0.002", "--cutter", "ball:4", "-o", out]
    with subprocess.Popen(words, stderr=subprocess.PIPE, text=True, preexec_fn=hear_ctrl_c) as mill:
        time.sleep(after)
        assert mill.poll() is None, mill.stderr.read()
        mill.send_signal(signal.SIGINT)
        said = mill.communicate(timeout=60)[1]
    assert mill.returncode == 130, said
    assert "nothing was written" in said and not out.exists()
