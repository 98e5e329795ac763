# SPDX-License-Identifier: LGPL-2.1-or-later
"""The allowance on curved faces to avoid, a boss's side and a dome on a plate, and on a face of a real part:
by dense samples of the way that the machine goes."""

import math
import os
from pathlib import Path

import numpy as np
import pytest
from plain import build_settings
from revolved import solid_of_revolution
from scipy.spatial import cKDTree

from freecad_fiveaxis.core.geometry.mesh import from_triangles, read_stl, write_stl
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.pipeline import job

RADIUS, ROUND, TOLERANCE, COLUMNS = 3.0, 8.0, 0.01, 64
SAG = ROUND * (1.0 - math.cos(math.pi / COLUMNS))
"""mm: so far facets lie within what they stand for, across."""
OPTIONS = {
    "machine": "trunnion_ac",
    "tool_length": 120,
    "cutter": "ball:6",
    "scallop": 0.1,
    "linearize": "on",
}
REAL = Path(os.environ.get("FIVEAXIS_MESHES", "/usr/share/opencascade/data/stl")) / "sh1.stl"


def boss():
    """A cylinder on a round plate, whose side is avoided."""
    mesh = solid_of_revolution([(0, 10), (ROUND, 10), (ROUND, 0), (20, 0), (20, -5), (0, -5)], COLUMNS)
    return mesh, (np.abs(mesh.normal[:, 2]) < 0.1) & (mesh.vertex[mesh.face][..., 2].min(axis=1) >= 0.0)


def dome():
    """Half a ball on a round plate, all of which is avoided."""
    polar = np.linspace(0.0, math.pi / 2.0, COLUMNS // 4 + 1)
    cap = [(ROUND * math.sin(one), ROUND * math.cos(one)) for one in polar[:-1]]
    mesh = solid_of_revolution([*cap, (ROUND, 0.0), (20, 0), (20, -5), (0, -5)], COLUMNS)
    return mesh, (mesh.vertex[mesh.face][..., 2].max(axis=1) > 1e-6)


def from_cylinder(centre, radius):
    """How far (n,) mm points are from the boss's side of a radius."""
    aside = np.abs(np.hypot(centre[:, 0], centre[:, 1]) - radius)
    return np.hypot(aside, np.maximum(np.maximum(-centre[:, 2], centre[:, 2] - 10.0), 0.0))


def from_ball(centre, radius):
    """How far (n,) mm points above the plate are from the half ball of a radius."""
    return np.linalg.norm(centre, axis=1) - radius


PARTS = {"boss": (boss, from_cylinder), "dome": (dome, from_ball)}


def run_beside(mesh, some, allowance, folder, **options):
    """The proven program of a part that keeps an allowance, mm, off some (f,) of its facets."""
    write_stl(mesh, folder / "part.stl")
    write_stl(from_triangles(mesh.vertex[mesh.face[some]]), folder / "faces.stl")
    given = {**OPTIONS, "avoid": str(folder / "faces.stl"), "avoid_allowance": allowance, **options}
    return job.run(build_settings("mill", str(folder / "part.stl"), given))


def centres(result, many=40):
    """The middle of the ball (n, 3) mm on the real way of all blocks, rapids too."""
    q, u = words_to_q(result.draft.program.words), np.linspace(0.0, 1.0, many)[:, None, None]
    tip, axis = forward(result.draft.kinematics, (q[:-1] * (1.0 - u) + q[1:] * u).reshape(-1, 5))
    return tip + RADIUS * axis


@pytest.mark.slow
@pytest.mark.parametrize("name", PARTS)
def test_the_ball_keeps_the_allowance_off_curved_faces_and_without_one_it_comes_nearer(name, tmp_path):
    (mesh, some), distance = PARTS[name][0](), PARTS[name][1]
    for allowance, scallop in ((1.0, 0.1), (0.0, 0.25)):
        result = run_beside(mesh, some, allowance, tmp_path, scallop=scallop)
        centre, least = centres(result), RADIUS + allowance
        centre = centre[centre[:, 2] > 0.0]
        assert distance(centre, ROUND).min() < least + 0.05, "no farther off than it must"
        assert distance(centre, ROUND - 2.0 * SAG).min() >= least - TOLERANCE
        assert not {"avoided-faces-near", "overcut"} & {one.code for one in result.findings}


def spread(corner, count):
    """Points (count, 3) mm on triangles (f, 3, 3), evenly over their area."""
    random = np.random.default_rng(5)
    area = np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
    facet, share = random.choice(len(corner), count, p=area / area.sum()), random.random((count, 2))
    share = np.where(share.sum(1, keepdims=True) > 1.0, 1.0 - share, share)
    return corner[facet, 0] + (share[..., None] * (corner[facet, 1:] - corner[facet, :1])).sum(axis=1)


@pytest.mark.slow
@pytest.mark.skipif(
    not REAL.exists(), reason="the mesh sh1 of OCCT's samples is not here (Debian's occt-misc)"
)
def test_on_a_real_part_the_ball_keeps_the_allowance_off_its_faces(tmp_path):
    """What lies in the middle third of the part's height: curved, and level. 21 000 blocks are enough to come
    as near as they may."""
    mesh = read_stl(str(REAL))
    middle, (low, high) = mesh.vertex[mesh.face].mean(axis=1)[:, 2], np.asarray(mesh.box)[:, 2]
    some = np.abs(middle - 0.5 * (low + high)) < (high - low) / 6.0
    cloud = cKDTree(spread(mesh.vertex[mesh.face[some]], 200_000))
    near = {}
    for allowance in (1.0, 0.0):
        result = run_beside(mesh, some, allowance, tmp_path, scallop=1.0)
        near[allowance] = cloud.query(centres(result, 15), distance_upper_bound=6.0)[0].min()
        assert not {"avoided-faces-near", "overcut"} & {one.code for one in result.findings}
    assert RADIUS + 1.0 - TOLERANCE <= near[1.0] < RADIUS + 1.05 and near[0.0] < RADIUS + 0.1
