# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gouge check on the real ways of a machine against a k-d tree of the facets' centres with exact distances at the positions
alone, and against OpenCAMLib's drop cutter (the three-axis part of it) where that can be imported; all in one run and in turns.
"""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.parts import bumpy
from benchmarks.timing import print_table
from freecad_fiveaxis.core import job
from freecad_fiveaxis.core.cutter import Cutter
from freecad_fiveaxis.core.gouge import body_of, facet_tree, find_entries, real_course, straight_course
from freecad_fiveaxis.core.gouge.bounds import nearest_on_facet
from freecad_fiveaxis.core.mesh import Mesh
from freecad_fiveaxis.core.records import Floats
from freecad_fiveaxis.core.settings import build_settings

FACETS = (10_000, 100_000, 1_000_000)
DIAMETER = 6.0
TOLERANCE = 0.01
POSITIONS, FEW = 60_000, 2_000  # of the check; of the peers, whose time grows with their number
ROUNDS = 3
ASKED = 50_000.0


def milled(mesh: Mesh) -> job.Milled:
    """A finishing program with its blocks divided to the tolerance."""
    options = {"machine": "trunnion_ac", "tool_length": 120, "stepover": 2, "cutter": f"ball:{DIAMETER}"}
    settings = build_settings("mill", "bumpy", {**options, "max_axis_angle": 60, "linearize": "on"})
    made = job.make(settings, mesh=mesh)
    assert isinstance(made, job.Milled)
    return made


class Neighbours:
    """The peer: facets whose centres are near, and their exact distances, position by position in plain numpy."""

    def __init__(self, mesh: Mesh) -> None:
        self.corner = mesh.vertex[mesh.face].transpose(1, 2, 0)
        centre = self.corner.mean(axis=0)
        self.wide = float(np.linalg.norm(self.corner - centre, axis=1).max())
        self.tree = cKDTree(centre.T)

    def depth(self, centres: Floats, radius: float) -> Floats:
        """How deep (n,) mm the part is in balls about these centres (n, 3)."""
        depth = np.zeros(len(centres))
        for row, near in enumerate(self.tree.query_ball_point(centres, radius + min(self.wide, 10.0))):
            if near:
                place = np.broadcast_to(centres[row][:, None], (3, len(near)))
                point = nearest_on_facet(self.corner[:, :, near], place)
                depth[row] = radius - np.linalg.norm(point - place, axis=0).min()
        return depth


def drop_cutter(mesh: Mesh, tips: Floats) -> float:
    """Seconds that OpenCAMLib's drop cutter takes at the same places; NaN where it is not installed."""
    try:
        import opencamlib as ocl
    except ImportError:
        return float("nan")
    surface = ocl.STLSurf()
    for a, b, c in mesh.vertex[mesh.face].tolist():
        surface.addTriangle(ocl.Triangle(*(ocl.Point(*corner) for corner in (a, b, c))))
    drop = ocl.BatchDropCutter()
    drop.setSTL(surface)
    drop.setCutter(ocl.BallCutter(DIAMETER, 50.0))
    for x, y, _ in tips.tolist():
        drop.appendPoint(ocl.CLPoint(x, y, -100.0))
    start = time.perf_counter()
    drop.run()
    return time.perf_counter() - start


def rates(facets: int) -> dict[str, float]:
    """The check's rates and the peers', positions a second."""
    mesh = bumpy(facets)
    made, tree = milled(mesh), facet_tree(mesh)
    real, straight = real_course(made.links, made.program.words), straight_course(made.path.tip, made.path.axis)
    body, few = body_of(Cutter(DIAMETER)), np.arange(1000, 1000 + FEW)
    centres = made.path.tip[few] + 0.5 * DIAMETER * made.path.axis[few]
    peer = Neighbours(mesh)
    found: dict[str, list[float]] = {name: [] for name in ("real", "straight", "tree", "peer", "drop")}
    for _ in range(ROUNDS):  # in turns: a busy machine slows all of them alike
        for name, course in (("real", real), ("straight", straight)):
            blocks = np.arange(min(POSITIONS, len(course)))
            found[name].append(
                len(blocks) / _seconds(lambda c=course, b=blocks: find_entries(body, tree, c, TOLERANCE, blocks=b))
            )
        found["peer"].append(FEW / _seconds(lambda: peer.depth(centres, 0.5 * DIAMETER)))
        found["drop"].append(FEW / drop_cutter(mesh, made.path.tip[few]))
        found["tree"].append(_seconds(lambda: facet_tree(mesh)))
    return {name: statistics.median(values) for name, values in found.items()}


def _seconds(call: Callable[[], object]) -> float:
    """Seconds of processor time: all of these use one processor, and another job's share of it is not theirs."""
    start = time.process_time()
    call()
    return time.process_time() - start


def main(facets: tuple[int, ...] = FACETS) -> None:
    """Print the table."""
    rows = []
    for count in facets:
        rate = rates(count)
        rows.append((
            f"{count}", f"{rate['tree']:.2f} s", f"{rate['straight'] / 1e3:.1f} k", f"{rate['real'] / 1e3:.1f} k",
            f"{rate['peer'] / 1e3:.2f} k", f"{rate['drop'] / 1e3:.2f} k", f"{rate['real'] / rate['peer']:.0f}",
        ))  # fmt: skip
    heads = ("facets", "tree", "straight", "real ways", "k-d tree, poses only", "drop cutter", "times k-d tree")
    print_table(f"Gouge check, ball {DIAMETER:g} mm with its cylinder: positions/s", heads, rows)
    print(f"{ASKED / 1e3:g} k positions/s are asked for at 100k facets")


if __name__ == "__main__":
    main(tuple(int(word) for word in sys.argv[1:]) or FACETS)
