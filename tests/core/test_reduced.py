# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coarser copies of meshes: how far they lie off, how many facets they have, and what stays as it is."""

import numpy as np
import pytest
from mesh_shapes import box, field, sphere

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.geometry.reduced import (
    ENOUGH,
    SMALL,
    cluster_vertices,
    reduce_facets,
    reduce_mesh,
    share_facets,
)

RADIUS = 50.0


@pytest.fixture(scope="module")
def ball():
    """A ball of 39,800 facets."""
    return from_triangles(sphere(RADIUS, 100, 200, centre=(7.0, -3.0, 11.0)))


def off_sphere(points):
    """How deep points lie below the ball's surface, mm."""
    return RADIUS - np.linalg.norm(points - (7.0, -3.0, 11.0), axis=-1)


def check_depth(points, deviation):
    """The mean of points of a sphere that are at most d apart lies at most r - sqrt(r^2 - d^2 / 2) below
    it."""
    depth = off_sphere(points)
    assert depth.min() >= -1e-9 and depth.max() <= RADIUS - np.sqrt(RADIUS**2 - deviation**2 / 2.0)


def test_a_ball_is_reduced_to_a_ball_within_the_closed_form(ball):
    copy = reduce_mesh(ball, 4000)
    assert ENOUGH * 4000 <= len(copy.mesh.face) <= 4000
    check_depth(copy.mesh.vertex, copy.deviation)
    middle = copy.mesh.vertex[copy.mesh.face].mean(axis=1)
    assert off_sphere(middle).max() < copy.deviation
    assert (copy.mesh.normal * (middle - (7.0, -3.0, 11.0))).sum(axis=1).min() > 0.0, "a facet looks inward"
    with pytest.raises(AssertionError):  # the comparison sees a vertex that lies too deep
        check_depth(copy.mesh.vertex * 0.9, copy.deviation)


@pytest.mark.parametrize("cell", [0.7, 3.0, 9.0])
def test_vertices_are_means_of_cells_and_facets_those_of_three(ball, cell):
    """Against a loop over all vertices and facets."""
    vertex, face = cluster_vertices(ball.vertex, ball.face, cell)
    low, cells = ball.vertex.min(axis=0), {}
    for row, point in enumerate(ball.vertex):
        cells.setdefault(tuple(np.floor((point - low) / cell).astype(int)), []).append(row)
    owner = np.empty(len(ball.vertex), int)
    for number, rows in enumerate(cells.values()):
        owner[rows] = number
    mean = np.array([ball.vertex[rows].mean(axis=0) for rows in cells.values()])
    assert np.allclose(np.sort(vertex, axis=0), np.sort(mean, axis=0))
    wanted = {turned(mean[owner[three]]) for three in ball.face if len(set(owner[three])) == 3}
    assert {turned(vertex[three]) for three in face} == wanted and len(face) == len(wanted)


def turned(corners):
    """The corners of a facet from the first on, in its sense."""
    rows = [tuple(np.round(one, 9).tolist()) for one in corners]
    first = rows.index(min(rows))
    return tuple(rows[first:] + rows[:first])


def test_no_point_of_the_copy_lies_farther_off_than_the_diagonal_of_a_cell():
    waves = from_triangles(field(60, lambda x, y: 4.0 * np.sin(x / 3.0) * np.cos(y / 5.0)))
    copy = reduce_mesh(waves, 1500)
    share = np.random.default_rng(5).dirichlet(np.ones(3), (len(copy.mesh.face), 8))
    points = np.einsum("fsk,fkx->fsx", share, copy.mesh.vertex[copy.mesh.face]).reshape(-1, 3)
    away = distances(waves, points)
    assert 0.05 * copy.deviation < away.max() <= copy.deviation
    assert distances(waves, points + (0.0, 0.0, 3.0 * copy.deviation)).max() > copy.deviation, "it can fail"


def distances(mesh, points):
    """The distance of points from a mesh, from many samples of its facets: too large by their spacing."""
    from scipy.spatial import cKDTree

    n = 6
    share = np.array([(i, j, n - i - j) for i in range(n + 1) for j in range(n + 1 - i)]) / n
    samples = np.einsum("sk,fkx->fsx", share, mesh.vertex[mesh.face]).reshape(-1, 3)
    return cKDTree(samples).query(points)[0]


def test_facets_that_are_no_mesh_yet_are_reduced_to_the_same_copy(ball):
    """With vertices that none uses, far off, and facets without area among them."""
    loose = np.concatenate([[(900.0, 0.0, 0.0)], ball.vertex, [(0.0, 0.0, -900.0)]])
    face = np.concatenate([ball.face + 1, [[1, 1, 2]] * 5])
    copy, same = reduce_facets(loose, face, 4000), reduce_mesh(ball, 4000)
    assert np.allclose(copy.mesh.vertex, same.mesh.vertex) and np.array_equal(copy.mesh.face, same.mesh.face)
    assert copy.deviation == pytest.approx(same.deviation)
    check_depth(copy.mesh.vertex, copy.deviation)
    assert reduce_facets(loose, face, len(face)) is None and reduce_facets(loose, face, 0) is None


def test_what_is_small_enough_or_leaves_nothing_has_no_copy(ball):
    cube = from_triangles(box())
    assert reduce_mesh(cube, 12) is None and reduce_mesh(ball, len(ball.face)) is None
    assert reduce_mesh(ball, 0) is None
    needle = from_triangles([[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1e-5, 0.0]]] * 2)
    assert reduce_mesh(needle, 0) is None
    vertex, face = cluster_vertices(cube.vertex, cube.face, 10.0)
    assert len(vertex) == 1 and face.shape == (0, 3)


def test_facets_in_one_sense_are_kept_once_and_both_sides_of_a_plate_stay():
    plate = from_triangles(box((0.0, 0.0, 0.0), (8.0, 8.0, 0.1)))
    vertex, face = cluster_vertices(plate.vertex, plate.face, 1.0)
    assert len(vertex) == 4 and len(face) == 4
    a, b, c = vertex[face].transpose(1, 0, 2)
    up = np.cross(b - a, c - a)[:, 2]
    assert sorted(np.sign(up)) == [-1.0, -1.0, 1.0, 1.0]
    twice = np.concatenate([plate.face, np.roll(plate.face, 1, axis=1)])
    assert len(cluster_vertices(plate.vertex, twice, 1.0)[1]) == 4


def test_budgets_are_shared_by_size_and_small_meshes_stay():
    assert share_facets([10, 20, 30], 60) == [10, 20, 30]
    assert share_facets([500, 300_000, 100_000], 40_000) == [500, 29962, 9987]
    assert share_facets([SMALL, 5000], 10) == [SMALL, SMALL]
    assert share_facets([], 10) == []
