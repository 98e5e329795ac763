# SPDX-License-Identifier: LGPL-2.1-or-later
"""The gouge check on the real ways of a machine against a k-d tree of the facets' centres with exact
distances at the positions alone; and on real meshes (Debian's occt-misc) against OpenCAMLib's drop cutter,
which does the three-axis part of it, at the same points, one above each of the places where that lets the
cutter down. All in one run and in turns, in processor time.
"""

from __future__ import annotations

import os
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.parts import bumpy
from benchmarks.timing import print_table
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.facet_tree import build_facet_tree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh, read_stl
from freecad_fiveaxis.core.gouge import find_entries, real_motion, straight_motion
from freecad_fiveaxis.core.gouge.deepest import nearest_on_facet
from freecad_fiveaxis.core.gouge.swept_motion import still_positions
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import body_of

FACETS = (10_000, 100_000, 1_000_000)
DIAMETER = 6.0
PLAIN = {"passes": "planes", "tool_axis": "facet_mean"}
TOLERANCE = 0.01
POSITIONS, FEW = 60_000, 2_000  # of the check; of the peers, whose time grows with their number
ROUNDS = 3
WANTED = 50_000.0
MESHES = Path(os.environ.get("FIVEAXIS_MESHES", "/usr/share/opencascade/data/stl"))
REAL = {"head": 10.0, "motor": 8.0, "propeller": 30.0, "bearing": 4.0, "video_part": 15.0}  # diameter, mm
ALONG, ACROSS, EDGE = 500, 24, 50.0  # points along and across the mesh; length of the edge, mm


def milled(mesh: Mesh) -> job.MilledProgram:
    """Return a finishing program with its blocks divided to the tolerance, and no place lifted."""
    options = {"machine": "trunnion_ac", "tool_length": 120, "stepover": 2, "cutter": f"ball:{DIAMETER}"}
    settings = build_settings(
        "mill", "bumpy", {**options, **PLAIN, "max_axis_angle": 60, "linearize": "on", "gouge": "off"}
    )
    result = job.make(settings, mesh=mesh)
    assert isinstance(result, job.MilledProgram)
    return result


class Neighbours:
    """The peer: facets whose centres are near, and their exact distances, position by position in plain
    numpy."""

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


def rates(facets: int) -> dict[str, float]:
    """Return the check's rates and the peers', positions a second."""
    mesh = bumpy(facets)
    result, tree = milled(mesh), facet_tree(mesh)
    real, straight = (
        real_motion(result.kinematics, result.program.words),
        straight_motion(result.path.tip, result.path.axis),
    )
    body, few = body_of(Cutter(DIAMETER)), np.arange(1000, 1000 + FEW)
    centres = result.path.tip[few] + 0.5 * DIAMETER * result.path.axis[few]
    peer = Neighbours(mesh)
    found: dict[str, list[float]] = {name: [] for name in ("real", "straight", "tree", "peer")}
    for _ in range(ROUNDS):  # in turns: a busy machine slows all of them alike
        for name, swept in (("real", real), ("straight", straight)):
            blocks = np.arange(min(POSITIONS, len(swept)))
            found[name].append(
                len(blocks)
                / _seconds(lambda c=swept, b=blocks: find_entries(body, tree, c, TOLERANCE, blocks=b))
            )
        found["peer"].append(FEW / _seconds(lambda: peer.depth(centres, 0.5 * DIAMETER)))
        found["tree"].append(_seconds(lambda: build_facet_tree(mesh)))
    return {name: statistics.median(values) for name, values in found.items()}


def dropped(mesh: Mesh, shape: Any, places: Floats) -> tuple[Floats, float]:
    """Return the tips (n, 3) that OpenCAMLib's drop cutter finds at these places (n, 2), and how many it
    finds in a second."""
    import opencamlib as ocl

    surface = ocl.STLSurf()
    for corners in mesh.vertex[mesh.face].tolist():
        surface.addTriangle(ocl.Triangle(*(ocl.Point(*corner) for corner in corners)))
    drop = ocl.BatchDropCutter()
    drop.setSTL(surface)
    drop.setThreads(1)
    drop.setCutter(shape)
    low = float(mesh.vertex[:, 2].min())
    for x, y in places.tolist():
        drop.appendPoint(ocl.CLPoint(x, y, low))
    rate = len(places) / _seconds(drop.run)
    return np.column_stack([places, [point.z for point in drop.getCLPoints()]]), rate


def real_rows(name: str, diameter: float) -> list[tuple[str, ...]]:
    """Return the check and the drop cutter at the same points over one of the real meshes, with a ball, a
    bull nose and a flat."""
    import opencamlib as ocl

    mesh = read_stl(str(MESHES / f"{name}.stl"))
    tree, (low, high), corner = (
        facet_tree(mesh),
        (mesh.vertex.min(axis=0), mesh.vertex.max(axis=0)),
        0.2 * diameter,
    )
    x, y = np.meshgrid(np.linspace(low[0], high[0], ALONG), np.linspace(low[1], high[1], ACROSS))
    x[1::2] = x[1::2, ::-1]  # to and fro
    shapes = {
        "ball": (ocl.BallCutter(diameter, EDGE), Cutter(diameter, EDGE)),
        "bull": (ocl.BullCutter(diameter, corner, EDGE), Cutter(diameter, EDGE, corner)),
        "flat": (ocl.CylCutter(diameter, EDGE), Cutter(diameter, EDGE, 0.0)),
    }
    rows = []
    for kind, (theirs, ours) in shapes.items():
        body, rates_ = body_of(ours), {"peer": [], "still": [], "way": []}
        for _ in range(ROUNDS):
            tips, rate = dropped(mesh, theirs, np.column_stack([x.ravel(), y.ravel()]))
            rates_["peer"].append(rate)
            axes = np.broadcast_to((0.0, 0.0, 1.0), tips.shape)
            for key, swept in (("still", still_positions(tips, axes)), ("way", straight_motion(tips, axes))):
                rates_[key].append(
                    len(tips) / _seconds(lambda b=body, c=swept: find_entries(b, tree, c, TOLERANCE))
                )
        rate = {key: statistics.median(values) for key, values in rates_.items()}
        deepest = find_entries(body, tree, still_positions(tips, axes), TOLERANCE).depth.max()
        rows.append((
            name, f"{len(mesh.face)}", f"{kind} {diameter:g}", f"{rate['peer'] / 1e3:.2f} k",
            f"{rate['still'] / 1e3:.1f} k",
            f"{rate['still'] / rate['peer']:.1f}", f"{rate['way'] / 1e3:.1f} k", f"{deepest:.3f}",
        ))  # fmt: skip
    return rows


def real_meshes() -> None:
    """Print the table of the real meshes, or why there is none."""
    try:
        import opencamlib  # noqa: F401
    except ImportError:
        return print(
            "\nno OpenCAMLib here (pip install opencamlib): the check is not timed beside its drop cutter"
        )
    there = {name: size for name, size in REAL.items() if (MESHES / f"{name}.stl").exists()}
    if not there:
        return print(
            f"\nno real meshes in {MESHES}: install Debian's occt-misc, or name another folder in "
            "FIVEAXIS_MESHES"
        )
    heads = (
        "mesh",
        "facets",
        "cutter",
        "drop cutter",
        "check",
        "times",
        "with the ways between",
        "deepest, mm",
    )
    rows = [row for name, size in there.items() for row in real_rows(name, size)]
    print_table("Gouge check at the points of OpenCAMLib's drop cutter: positions/s", heads, rows)
    ratio = [float(row[5]) for row in rows]
    print(
        f"times: median {statistics.median(ratio):.1f}, least {min(ratio):.1f}, most {max(ratio):.1f}; 10 "
        "are asked for"
    )


def _seconds(call: Callable[[], object]) -> float:
    """Seconds of processor time: all of these use one processor, and another job's share of it is not
    theirs."""
    start = time.process_time()
    call()
    return time.process_time() - start


def main(facets: tuple[int, ...] = FACETS) -> None:
    """Print the table."""
    rows = []
    for count in facets:
        rate = rates(count)
        rows.append((
            f"{count}", f"{rate['tree']:.2f} s", f"{rate['straight'] / 1e3:.1f} k",
            f"{rate['real'] / 1e3:.1f} k",
            f"{rate['peer'] / 1e3:.2f} k", f"{rate['real'] / rate['peer']:.0f}",
        ))  # fmt: skip
    heads = ("facets", "tree", "straight", "real ways", "k-d tree, poses only", "times")
    print_table(f"Gouge check, ball {DIAMETER:g} mm with its cylinder: positions/s", heads, rows)
    print(f"{WANTED / 1e3:g} k positions/s are asked for at 100k facets")
    real_meshes()


if __name__ == "__main__":
    main(tuple(int(word) for word in sys.argv[1:]) or FACETS)
