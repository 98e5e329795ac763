# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normals by which a mesh is lit."""

import numpy as np
import pytest
from mesh_shapes import box, field, sphere

from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles
from freecad_fiveaxis.core.geometry.shading import order_outward, shade
from freecad_fiveaxis.core.geometry.solids import frustum_facets
from freecad_fiveaxis.core.report.standing_bodies import SHARP, find_sharp


def by_loop(mesh, sharp):
    """The normal at each corner of each facet: of those round its vertex, over edges that are not sharp."""
    joined = {}
    for (one, other), parted in zip(mesh.coedge_face.tolist(), sharp, strict=True):
        if other >= 0 and not parted:
            joined.setdefault(one, []).append(other)
            joined.setdefault(other, []).append(one)
    normal = np.empty((len(mesh.face), 3, 3))
    for facet, corners in enumerate(mesh.face.tolist()):
        for k, vertex in enumerate(corners):
            found, ahead = {facet}, [facet]
            while ahead:
                near = [one for one in joined.get(ahead.pop(), []) if vertex in mesh.face[one]]
                ahead += [one for one in near if one not in found]
                found |= set(near)
            normal[facet, k] = (mesh.normal[list(found)] * mesh.area[list(found), None]).sum(axis=0)
    return normal / np.linalg.norm(normal, axis=2)[..., None]


CUT = sphere(10.0, 8, 12)
SHAPES = {
    "box": box((0.0, 0.0, 0.0), (3.0, 2.0, 1.0)),
    "ball": sphere(10.0, 16, 24),
    "open ball": CUT[CUT[:, :, 2].min(axis=1) > -5.0],
    "drum": frustum_facets(np.zeros(3), np.array([0.0, 0.0, 5.0]), 4.0, 4.0),
    "waves": field(8, lambda x, y: np.sin(x) * y),
}


@pytest.mark.parametrize("name", SHAPES)
def test_it_is_what_a_loop_over_the_facets_round_each_corner_finds(name):
    mesh = from_triangles(SHAPES[name])
    sharp = find_sharp(mesh)
    lit = shade(mesh, sharp)
    assert np.array_equal(lit.vertex[lit.face], mesh.vertex[mesh.face])
    assert np.allclose(lit.normal[lit.face], by_loop(mesh, sharp), atol=1e-9)


def test_a_cube_is_flat_and_a_ball_is_round():
    cube, ball = from_triangles(box()), from_triangles(sphere(10.0, 60, 90))
    lit = shade(cube, find_sharp(cube))
    assert len(lit.vertex) == 24 and np.allclose(lit.normal[lit.face], cube.normal[:, None])
    round_ = shade(cube, np.zeros(len(cube.coedge_face), bool))
    assert len(round_.vertex) == 8 and not np.allclose(round_.normal[round_.face], cube.normal[:, None])
    lit = shade(ball, find_sharp(ball))
    assert len(lit.vertex) == len(ball.vertex)
    assert (lit.normal * lit.vertex).sum(axis=1).min() > 10.0 * np.cos(np.radians(1.5))


def test_two_sides_of_one_plate_are_lit_by_one_of_them_at_least():
    """Facets that lie on each other have no mean normal."""
    vertex = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    mesh = from_faces(vertex, [[0, 1, 2], [0, 2, 1]])
    lit = shade(mesh, np.zeros(len(mesh.coedge_face), bool))
    assert np.allclose(np.abs(lit.normal), (0.0, 0.0, 1.0))
    assert find_sharp(mesh).all() and SHARP > 0.0


@pytest.mark.parametrize("name", ["ball", "drum", "waves"])
def test_ordered_outward_all_facets_are_there_and_the_deepest_begin(name):
    mesh = from_triangles(SHAPES[name])
    lit = shade(mesh, find_sharp(mesh))
    found = order_outward(lit)
    both = [np.concatenate([one.vertex[one.face], one.normal[one.face]], axis=2) for one in (lit, found)]
    wanted, drawn = ({turned(rows) for rows in of} for of in both)
    assert wanted == drawn and len(drawn) == len(found.face)
    middle = 0.5 * (lit.vertex.min(axis=0) + lit.vertex.max(axis=0))
    out = (found.normal * (found.vertex - middle)).sum(axis=1)
    assert (np.diff(out) >= 0.0).all() and (np.diff(found.face[:, 0]) >= 0).all()
    assert (found.face[:, :1] <= found.face).all()


def turned(corners):
    """The corners of a facet from the first on, in its sense."""
    rows = [tuple(one) for one in corners.tolist()]
    first = rows.index(min(rows))
    return tuple(rows[first:] + rows[:first])


def test_the_floor_of_a_bowl_is_blended_before_its_walls():
    outer, inner = (frustum_facets(np.zeros(3), np.array([0.0, 0.0, 20.0]), r, r) for r in (10.0, 8.0))
    hollow = inner[:, ::-1] + (0.0, 0.0, 0.5)
    mesh = from_triangles(np.concatenate([outer, hollow]))
    found = order_outward(shade(mesh, find_sharp(mesh)))
    corner = found.vertex[found.face]
    inside = np.linalg.norm(corner[..., :2], axis=2).max(axis=1) < 8.5
    assert inside[: inside.sum()].all(), "facets of the hollow come first"
