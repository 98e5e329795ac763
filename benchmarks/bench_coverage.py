# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of a part is finished, by how long a cut, and how long the tool is under way beside it: real
meshes, each strategy.

The judge knows nothing of how a program is made: the ball is swept along the real way of the program's words
(a forward map of the chain for each sample), and area samples of the surface look for the nearest place of
its centre. *Finished*: no more than WITHIN left and no deeper; *share*: of what such a ball finishes wherever
it fits, from any side (libigl, where it is there). *Cut*, *links*, *rapids*: length over finished area /
stepover on a flat. *Overcut*: deepest sample, mm. *95 %*: of what is left, mm.
Arguments: names of parts, then strategies as PASSES/AXIS or PASSES/AXIS/WITHIN_FRAMES (``head
scallop/facet_mean``); none: all that are here, every strategy.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from benchmarks.timing import print_table
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh, read_stl
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.passes import flat_interval
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.toolpath.cl_path import Motion

MESHES = Path(os.environ.get("FIVEAXIS_MESHES", "/usr/share/opencascade/data/stl"))
PARTS = ("sh1", "bearing", "head", "video_part", "propeller")
STRATEGIES = ("planes/facet_mean", "scallop/facet_mean", "frames/auto", "frames/auto/planes")
DIAMETER, SCALLOP, MACHINE = 6.0, 0.02, "trunnion_ac"
WITHIN = 0.05  # mm
SAMPLES, CONTACTS = 20_000, 400_000  # of the judge; of all places at which the ball is set down
STEP = 0.06  # mm between places of the ball
BATCH = 20_000  # blocks at a time


def area_samples(mesh: Mesh, count: int) -> tuple[Floats, Floats, float]:
    """Points (count, 3) mm spread evenly over the area, unit normals (count, 3), and the whole area, mm2."""
    random, corner = np.random.default_rng(7), mesh.vertex[mesh.face]
    across = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    area = np.linalg.norm(across, axis=1)
    face, share = random.choice(len(area), count, p=area / area.sum()), random.random((count, 2))
    share = np.where(share.sum(axis=1, keepdims=True) > 1.0, 1.0 - share, share)
    sides = corner[face, 1:] - corner[face, :1]
    return (
        corner[face, 0] + (share[..., None] * sides).sum(axis=1),
        across[face] / area[face, None],
        float(area.sum() / 2.0),
    )


def swept_centres(outcome: job.ProgramDraft) -> Floats:
    """Places (k, 3) mm of the ball's centre along the real way of all feed blocks, STEP apart or nearer."""
    words, feeding, radius = outcome.program.words, outcome.program.motion[1:] != Motion.RAPID, DIAMETER / 2.0
    tip, axis = forward(outcome.kinematics, words_to_q(words))
    length = np.linalg.norm(np.diff(tip + radius * axis, axis=0), axis=1)
    turn = np.abs(np.diff(words, axis=0)).max(axis=1)
    count = np.maximum(2, np.ceil(np.maximum(length, 0.05 * turn) / STEP)).astype(np.int64)
    found = []
    for rows in np.array_split(np.flatnonzero(feeding), feeding.sum() // BATCH + 1):
        row = np.repeat(rows, count[rows])
        ends = np.cumsum(count[rows])
        share = (np.arange(len(row)) - np.repeat(ends - count[rows], count[rows])) / np.repeat(
            count[rows], count[rows]
        )
        tip, axis = forward(
            outcome.kinematics, words_to_q(words[row] + share[:, None] * (words[row + 1] - words[row]))
        )
        found.append(tip + radius * axis)
    return np.concatenate(found)


def fitting_centres(mesh: Mesh) -> Floats:
    """Places (k, 3) mm of the ball's centre, set down all over the surface, where it keeps out of the
    part."""
    import igl

    point, normal, _ = area_samples(mesh, CONTACTS)
    centre = point + 0.5 * DIAMETER * normal
    square = np.asarray(igl.point_mesh_squared_distance(centre, mesh.vertex, mesh.face)[0]).ravel()
    return centre[np.sqrt(square) >= 0.5 * DIAMETER - 0.5 * WITHIN]


def gaps(centre: Floats, point: Floats) -> Floats:
    """Return what stands above the ball's envelope at each point, mm; below 0: it has gone deeper."""
    return np.asarray(cKDTree(centre).query(point, workers=2)[0]) - 0.5 * DIAMETER


def measured(name: str, strategy: str, fits: Floats | None) -> list[str]:
    """One row of the table."""
    mesh = read_stl(str(MESHES / f"{name}.stl"))
    passes, axis, *within = strategy.split("/")
    options = {"machine": MACHINE, "tool_length": 120, "cutter": f"ball:{DIAMETER}", "scallop": SCALLOP,
        "passes": passes,
               "tool_axis": axis, "within_frames": within[0] if within else None}  # fmt: skip
    begin = time.process_time()
    result = job.prove(job.make(build_settings("mill", name, options), mesh=mesh))
    seconds = time.process_time() - begin
    point, _, area = area_samples(mesh, SAMPLES)
    left = gaps(swept_centres(result.draft), point)
    share = float((np.abs(left) <= WITHIN).mean())
    can = float((gaps(fits, point) <= WITHIN).mean()) if fits is not None else float("nan")
    numbers = summary(job.figures(result))
    ideal = share * area / flat_interval(0.5 * DIAMETER, SCALLOP)
    lengths = [f"{numbers[key] / ideal:.1f}" for key in ("cut_length", "link_length", "rapid_length")]
    high = float(np.percentile(left[np.abs(left) <= WITHIN], 95))
    return [name, strategy, str(len(mesh.face)), f"{share:.3f}", f"{can:.3f}", f"{share / can:.3f}", *lengths,
            f"{max(0.0, -left.min()):.3f}", f"{high:.3f}", f"{seconds:.0f}"]  # fmt: skip


def main(arguments: list[str]) -> None:
    """Measure the parts and strategies that are named, or all."""
    names = [one for one in arguments if "/" not in one] or [
        one for one in PARTS if (MESHES / f"{one}.stl").exists()
    ]
    strategies = [one for one in arguments if "/" in one] or list(STRATEGIES)
    if not names:
        print(f"no real meshes in {MESHES}: install Debian's occt-misc, or name a folder in FIVEAXIS_MESHES")
    rows = []
    for name in names:
        try:
            fits = fitting_centres(read_stl(str(MESHES / f"{name}.stl")))
        except ImportError:
            print("libigl is not installed: what the ball can finish at all is left out")
            fits = None
        rows += [measured(name, strategy, fits) for strategy in strategies]
    heads = [
        "part",
        "strategy",
        "facets",
        "finished",
        "ball can",
        "share",
        "cut x",
        "links x",
        "rapids x",
        "overcut",
        "95 %",
        "cpu s",
    ]
    print_table(f"coverage: ball {DIAMETER}, scallop {SCALLOP}, {MACHINE}", heads, rows)


if __name__ == "__main__":
    main(sys.argv[1:])
