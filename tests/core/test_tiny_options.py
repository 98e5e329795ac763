# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options so small that the work would never end, or numbers overflow, are refused before it; a long mill is
stopped at once."""

import os
import signal
import subprocess
import sys

import numpy as np
import pytest
from gouge_examples import blade_beside_hub, step
from thorough import some_in_core

from freecad_fiveaxis.core.geometry.mesh import write_stl

MILL = [sys.executable, "-W", "error", "-m", "freecad_fiveaxis", "mill"]


@pytest.mark.parametrize(
    "given",
    [
        "--clearance 1e-320",
        "--coedge-tolerance 1e-320",
        "--scallop 1e-9",
        "--stepover 1e-4",
        "--scallop 1e-320",
    ]
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
    done = subprocess.run(words, capture_output=True, text=True, timeout=300)
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
    words = [
        *MILL,
        part,
        "--machine",
        "trunnion_ac",
        "--scallop",
        "1e-6",
        "--least-interval",
        "1e-6",
        "-o",
        out,
        "--quiet",
    ]
    done = subprocess.run(words, capture_output=True, text=True, timeout=300)
    assert done.returncode == 2 and len(done.stderr.splitlines()) == 1 and not out.exists(), done.stderr
    assert f"the whole part is {size:.4g} mm long" in done.stderr and "check the units" in done.stderr


def hear_ctrl_c():
    """A process takes over what its parent ignores: SIGINT behind an ampersand."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


SHOWN = """
import sys, runpy
sys.stderr.isatty = lambda: True
sys.modules["tqdm"] = None
sys.argv[0] = "fiveaxis"
runpy.run_module("freecad_fiveaxis", run_name="__main__")
"""
"""The command line that shows its stages, as at a terminal without tqdm."""


def read_until(stream, stage):
    """Read on until the stage is shown; whether it is."""
    shown = b""
    while stage.encode() not in shown and (more := os.read(stream.fileno(), 65536)):
        shown = shown[-len(stage) :] + more
    return stage.encode() in shown


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="Windows sends no SIGINT to one process")
@pytest.mark.parametrize(
    ("passes", "stage"),
    [("scallop", "axis field"), ("planes", "placing planes"), ("planes", "lift")]
    + [
        pytest.param("planes", late, marks=pytest.mark.large)
        for late in ("slice", "closing co-edges", "linking passes")
    ],
)
def test_a_long_mill_hears_ctrl_c_and_writes_nothing(passes, stage, tmp_path):
    """It is sent when the stage is shown: before most of the work, for that is the lift. How soon:
    benchmarks/bench_stop.py. Planes are placed by scallop, which takes ten seconds of the processor, only
    where that is the stage. The lift begins after two seconds on the coarser part, and takes six."""
    part, out = tmp_path / "part.stl", tmp_path / "part.ngc"
    coarse = stage == "lift"
    write_stl(blade_beside_hub(cells=60 if coarse else 120), part)
    spaced = ("--stepover", "0.3" if coarse else "0.18")
    if stage in ("axis field", "placing planes"):
        spaced = ("--scallop", "0.002")
    words = [part, "--machine", "trunnion_ac", "--passes", passes, *spaced, "--cutter", "ball:4", "-o", out]
    command = [sys.executable, "-W", "error", "-c", SHOWN, "mill", *words]
    with subprocess.Popen(command, stderr=subprocess.PIPE, preexec_fn=hear_ctrl_c) as mill:
        assert read_until(mill.stderr, stage), "the mill ended before the stage was shown"
        mill.send_signal(signal.SIGINT)
        message = mill.communicate(timeout=300)[1]
    assert mill.returncode == 130, message
    assert b"nothing was written" in message and not out.exists()
