# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole command line, with start, proof and file, on a smooth wavy surface where the ball fits
everywhere, against ``%`` formatting of as many rows: processor seconds of both, for other work on the machine
makes wall clocks run.

``python bench_million.py [SIDE]``; SIDE vertices along each side, without an argument 708, which makes 1M
facets.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

import numpy as np
from timing import print_table

import freecad_fiveaxis
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl

SIZE = 200.0
PASSES = 500
MILL = (
    "mill", "wavy.stl", "--machine", "trunnion_ac", "--controller", "linuxcnc", "--cutter", "ball:6",
    "--spindle", "off",
    "--quiet", "-o", "wavy.ngc",
)  # fmt: skip
PLANES = ("--passes", "planes", "--stepover", str(SIZE / PASSES))
CASES = {
    "planes, nothing checked": (*PLANES, "--gouge", "off", "--linearize", "off"),
    "planes": PLANES,
    "scallop, axes chosen": ("--scallop", str((SIZE / PASSES) ** 2 / 24.0)),  # as far apart on a flat
}
ROWS_FOR_PERCENT = 200_000


class Cost(NamedTuple):
    """``processor`` and ``wall`` seconds, ``memory`` GB at most."""

    processor: float
    wall: float
    memory: float


def write_wavy(side: int, file: Path) -> int:
    """Write an open surface of gentle waves, radii of 54 mm and more; returns its facets."""
    x, y = np.meshgrid(*[np.linspace(0.0, SIZE, side)] * 2, indexing="ij")
    z = 4.0 * np.sin(2.0 * np.pi * x / 100.0) + 3.0 * np.cos(2.0 * np.pi * y / 80.0)
    point, row = np.stack([x, y, z], axis=-1).reshape(-1, 3), np.arange(side * side).reshape(side, side)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    mesh = from_triangles(point[np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])])
    write_stl(mesh, file)
    return len(mesh.face)


def run(options: tuple[str, ...], folder: str) -> Cost:
    """Return the command line in a process of its own."""
    command = [sys.executable, "-m", "freecad_fiveaxis", *MILL, *options]
    start = time.perf_counter()
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    environment = {**os.environ, "PYTHONPATH": str(Path(freecad_fiveaxis.__file__).parents[1])}
    code = subprocess.run(command, cwd=folder, env=environment, check=False).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert code in (0, 1), code
    used = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return Cost(used, time.perf_counter() - start, after.ru_maxrss / 1e6)


def percent_seconds(rows: int) -> float:
    """Processor seconds of plain ``%`` formatting of so many rows."""
    words = np.random.default_rng(0).uniform(-100.0, 100.0, (ROWS_FOR_PERCENT, 5))
    start = time.process_time()
    "".join(["G1 X%.4f Y%.4f Z%.4f A%.4f C%.4f F%.4f\n" % (*row, 100.0) for row in words])  # noqa: UP031 the peer
    return (time.process_time() - start) * rows / ROWS_FOR_PERCENT


def main(side: int) -> None:
    """Print one row a case; memory is the most of it and of those above."""
    table = []
    with tempfile.TemporaryDirectory() as folder:
        facets = write_wavy(side, Path(folder) / "wavy.stl")
        for name, options in CASES.items():
            cost = run(options, folder)
            lines = (Path(folder) / "wavy.ngc").read_bytes().count(b"\n")
            text = percent_seconds(lines)
            seconds = (
                f"{cost.processor:.1f}",
                f"{cost.wall:.1f}",
                f"{text:.2f}",
                f"{cost.processor / text:.1f}",
            )
            table.append((name, f"{facets / 1e6:.2f}", lines, *seconds, f"{cost.memory:.2f}"))
    heads = ("case", "M facets", "lines", "processor s", "wall s", "% rows, processor s", "ratio", "GB")
    print_table("The whole command line", heads, table)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 708)
