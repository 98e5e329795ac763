# SPDX-License-Identifier: LGPL-2.1-or-later
"""From an STL file to facet adjacency: this project, trimesh (load, then face_adjacency) and meshlib (load)
in one run.

Ours includes unit normals, the check of the orientation and the co-edge columns. It sorts in a second thread;
meshlib uses all cores. Peers are optional:
``pip install trimesh meshlib``.
"""

from __future__ import annotations

import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.parts import bumpy
from benchmarks.timing import print_table, run_seconds
from freecad_fiveaxis.core.base.memory import keep_freed_memory
from freecad_fiveaxis.core.geometry.mesh import read_stl, write_stl

COMPARED = (200_000, 1_000_000)  # facets
ROUNDS = 9
GROWING = (20_000, 60_000, 200_000, 600_000, 2_000_000)


def peers() -> dict[str, Callable[[str], object]]:
    """Return the peers that are installed, each reading a file up to its adjacency."""
    found: dict[str, Callable[[str], object]] = {}
    try:
        import trimesh

        found["trimesh"] = lambda path: trimesh.load(path).face_adjacency
    except ImportError:
        print("trimesh is not installed: left out")
    try:
        from meshlib import mrmeshpy

        found["meshlib"] = mrmeshpy.loadMesh  # builds its half-edges while it loads
    except ImportError:
        print("meshlib is not installed: left out")
    return found


def alternating(calls: Sequence[Callable[[], object]]) -> list[float]:
    """Return the median seconds of each call: all run in turn, so that a busy spell of the machine meets each
    of them.

    The first rounds do not count: until then the process still takes memory that later runs find at hand.
    """
    seconds = [run_seconds(call, 1) for call in calls]
    for _ in range(ROUNDS):
        for call, taken in zip(calls, seconds, strict=True):
            start = time.perf_counter()
            call()
            taken.append(time.perf_counter() - start)
    return [statistics.median(taken[1:]) for taken in seconds]


def compare(folder: Path) -> None:
    """Ours and the peers on the same files."""
    readers: dict[str, Callable[[str], object]] = {"this project": read_stl, **peers()}
    rows = []
    for facets in COMPARED:
        path = folder / f"{facets}.stl"
        write_stl(bumpy(facets), path)
        seconds = alternating([partial(read, str(path)) for read in readers.values()])
        for name, taken in zip(readers, seconds, strict=True):
            rows.append([f"{facets:,}", name, f"{1e3 * taken:.0f}", f"{taken / seconds[0]:.1f}"])
    print_table("STL to adjacency", ("facets", "by", "ms", "times ours"), rows)


def grow(folder: Path) -> None:
    """Cost a facet as parts grow; about the same on every line where the cost is linear.

    The fastest run counts: memory that the process takes for the first time costs up to as much again, on
    some machines.
    """
    rows = []
    for facets in GROWING:
        path = folder / "growing.stl"
        write_stl(bumpy(facets), path)
        taken = min(run_seconds(lambda path=path: read_stl(path), 7))
        rows.append([f"{facets:,}", f"{1e3 * taken:.1f}", f"{1e9 * taken / facets:.0f}"])
    print_table("STL to adjacency, this project", ("facets", "ms", "ns a facet"), rows)


if __name__ == "__main__":
    keep_freed_memory()  # as on the command line; the peers in this process have the same
    with tempfile.TemporaryDirectory() as name:
        compare(Path(name))
        grow(Path(name))
