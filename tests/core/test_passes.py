# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planes through a mesh: against closed forms, against facet-by-facet sections, and where vertices and edges
lie on a plane."""

import numpy as np
import pytest
from mesh_shapes import box, field, sphere

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles
from freecad_fiveaxis.core.passes import direction, slice_mesh
from freecad_fiveaxis.core.passes.slicing import levels

ANGLES = [0.0, 0.3, np.pi / 2, 2.0, np.pi, -1.1]


def vectors(angle):
    cosine, sine = direction(angle)
    return np.array([cosine, sine, 0.0]), np.array([-sine, cosine, 0.0])


def facet_sections(mesh, offsets, angle):
    """Facet by facet: {(plane, facet): length} of every cut longer than nothing, a vertex on the plane
    counting as above it."""
    _, across = vectors(angle)
    found = {}
    for k, offset in enumerate(offsets):
        for i, corner in enumerate(mesh.vertex[mesh.face]):
            d = corner @ across - offset
            ends = [
                corner[a] + d[a] / (d[a] - d[b]) * (corner[b] - corner[a])
                for a, b in ((0, 1), (1, 2), (2, 0))
                if (d[a] < 0) != (d[b] < 0)
            ]
            if ends and np.linalg.norm(ends[1] - ends[0]) > 1e-9:
                found[k, i] = np.linalg.norm(ends[1] - ends[0])
    return found


def lengths(path):
    return np.linalg.norm(path.point[1::2] - path.point[0::2], axis=1)


def check_path(mesh, path, offsets, angle):
    """Everything that ContactPath promises, row by row."""
    travel, across = vectors(angle)
    offsets = np.asarray(offsets, float)
    scale = np.abs(mesh.vertex).max()
    entry, exit_ = path.point[0::2], path.point[1::2]
    np.testing.assert_array_equal(path.segment, np.arange(len(path.face)) // 2)
    for column in (path.face, path.polyline, path.pass_):
        np.testing.assert_array_equal(column[0::2], column[1::2])
    np.testing.assert_array_equal(path.normal, mesh.normal[path.face])

    # on the plane, on the facet's plane, on the co-edge, which is one of the facet's
    np.testing.assert_allclose(path.point @ across, offsets[path.pass_], atol=1e-12 * scale, rtol=0)
    corner = mesh.vertex[mesh.face[path.face]]
    np.testing.assert_allclose(
        np.einsum("ij,ij->i", path.point - corner[:, 0], path.normal), 0.0, atol=1e-9 * scale
    )
    assert (mesh.face_coedge[path.face] == path.coedge[:, None]).any(axis=1).all()
    a, b = (mesh.vertex[mesh.coedge_vertex[path.coedge, side]] for side in (0, 1))
    detour = (
        np.linalg.norm(path.point - a, axis=1)
        + np.linalg.norm(path.point - b, axis=1)
        - np.linalg.norm(b - a, axis=1)
    )
    np.testing.assert_allclose(detour, 0.0, atol=1e-9 * scale)

    # along across x normal, never of no length
    sense = np.cross(across, path.normal[0::2])
    along = np.einsum("ij,ij->i", exit_ - entry, sense)
    assert (along > -1e-12 * scale).all()
    assert (entry != exit_).any(axis=1).all()

    # contiguous bit for bit, sharing a co-edge or, at a vertex, an end of one
    same = np.flatnonzero(path.polyline[1:-1:2] == path.polyline[2::2])
    np.testing.assert_array_equal(exit_[same], entry[same + 1])
    one, two = path.coedge[1::2][same], path.coedge[0::2][same + 1]
    ends = mesh.coedge_vertex
    shared = (one == two) | (ends[one][:, :, None] == ends[two][:, None, :]).any(axis=(1, 2))
    assert shared.all()

    # polylines and passes in order
    step = np.diff(path.polyline[0::2])
    assert np.isin(step, (0, 1)).all()
    first = np.flatnonzero(np.append(True, step > 0)) if len(step) or len(entry) else np.empty(0, int)
    start, pass_ = entry[first] @ travel, path.pass_[2 * first]
    assert (np.diff(path.pass_) >= 0).all()
    assert (np.diff(start)[np.diff(pass_) == 0] >= -1e-12 * scale).all()
    return first


def check_closed(path, first):
    last = np.append(first[1:], len(path.face) // 2) - 1
    np.testing.assert_array_equal(path.point[2 * first], path.point[2 * last + 1])


def test_a_box_cut_by_one_plane_is_a_rectangle():
    mesh = from_triangles(box(high=(4.0, 3.0, 2.0)))
    path = slice_mesh(mesh, [1.0], 0.0)
    check_closed(path, check_path(mesh, path, [1.0], 0.0))
    assert path.polyline.max() == 0
    assert lengths(path).sum() == pytest.approx(2.0 * (4.0 + 2.0), abs=1e-12)
    np.testing.assert_array_equal(path.point[:, 1], 1.0)
    # it starts where it turns upward, at the left end of the top, and goes along the travel first
    np.testing.assert_allclose(path.point[0], [0.0, 1.0, 2.0])
    assert path.normal[0, 2] == 1.0


def test_a_sphere_is_cut_in_circles_up_to_its_chords():
    radius, offsets = 10.0, np.linspace(-9.0, 9.0, 7)
    mesh = from_triangles(sphere(radius, rows=90, columns=180))
    for angle in ANGLES:
        path = slice_mesh(mesh, offsets, angle)
        check_closed(path, check_path(mesh, path, offsets, angle))
        for k, offset in enumerate(offsets):
            circle = 2.0 * np.pi * np.sqrt(radius**2 - offset**2)
            assert lengths(path)[path.pass_[0::2] == k].sum() == pytest.approx(circle, rel=1e-3)


@pytest.mark.parametrize("angle", ANGLES)
def test_every_facet_is_cut_just_as_facet_by_facet(angle):
    rng = np.random.default_rng(5)
    offsets = np.linspace(-9.5, 9.5, 5)
    mesh = from_triangles(sphere(rows=9, columns=11) + 0.2 * rng.normal(size=3))
    path = slice_mesh(mesh, offsets, angle)
    check_closed(path, check_path(mesh, path, offsets, angle))
    found = dict(
        zip(zip(path.pass_[0::2].tolist(), path.face[0::2].tolist(), strict=True), lengths(path), strict=True)
    )
    expected = facet_sections(mesh, offsets, angle)
    assert found.keys() == expected.keys()
    for key, length in expected.items():
        assert found[key] == pytest.approx(length, abs=1e-9)


def test_the_facet_by_facet_comparison_would_notice_a_missing_segment():
    mesh = from_triangles(sphere(rows=9, columns=11))
    keep = np.ones(len(mesh.face), dtype=bool)
    path = slice_mesh(mesh, [0.1], 0.0)
    keep[path.face[0]] = False
    assert len(slice_mesh(mesh, [0.1], 0.0, keep).face) < 2 * len(facet_sections(mesh, [0.1], 0.0))


def test_planes_on_the_faces_edges_and_vertices_of_a_cube():
    mesh = from_triangles(box(low=(-1.0, -1.0, -1.0)))
    for angle, offsets in (
        (0.0, [-1.0, 0.0, 1.0]),
        (np.pi / 4, np.sqrt(2.0) * np.array([-1.0, 0.0, 1.0])),
        (np.pi / 2, [-1, 0, 1]),
    ):
        path = slice_mesh(mesh, offsets, angle)
        check_closed(path, check_path(mesh, path, offsets, angle))
        # the plane through the middle gives one loop; the outer ones touch from one side or the other, and
        # lose nothing
        assert (path.pass_ == 1).sum() >= 8
        for k in (0, 2):
            loop = lengths(path)[path.pass_[0::2] == k].sum()
            assert loop == pytest.approx(0.0) or loop > 4.0 - 1e-9


def test_a_plane_in_a_face_is_cut_out_of_the_solid_below_it_only():
    mesh = from_triangles(box(high=(4.0, 3.0, 2.0)))
    path = slice_mesh(mesh, [0.0, 3.0], 0.0)
    assert set(path.pass_.tolist()) == {1}
    assert lengths(path).sum() == pytest.approx(12.0)
    check_closed(path, check_path(mesh, path, [0.0, 3.0], 0.0))


@pytest.mark.parametrize("angle", [0.0, np.pi / 2, np.pi / 4, np.pi])
def test_planes_on_the_lines_of_a_grid_give_one_unbroken_line_each(angle):
    n, spacing = 6, 1.0
    mesh = from_triangles(field(n, lambda x, y: np.sin(x) + 0.3 * y * y))
    across = vectors(angle)[1]
    if angle == np.pi / 4:
        spacing = np.sqrt(0.5)
    low = (mesh.vertex @ across).min()
    offsets = low + spacing * np.arange(2 * n + 1.0)
    path = slice_mesh(mesh, offsets, angle)
    first = check_path(mesh, path, offsets, angle)
    assert len(first) == len(set(path.pass_.tolist()))  # one polyline a pass
    expected = facet_sections(mesh, offsets, angle)
    assert lengths(path).sum() == pytest.approx(sum(expected.values()), abs=1e-9)
    if angle == 0.0:
        rows = path.pass_[0::2] == 3
        np.testing.assert_array_equal(
            path.point[0::2][rows][:, 0], np.arange(n)
        )  # on the grid line, from vertex to vertex
        assert rows.sum() == n


def test_the_tip_of_a_pyramid_on_the_plane_leaves_no_segment_of_no_length():
    tip, foot = [0.0, 1.0, 3.0], [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    mesh = from_faces([tip, *foot], [[1, 2, 3], [0, 2, 1], [0, 3, 2], [0, 1, 3]])
    assert len(slice_mesh(mesh, [1.0], 0.0).face) == 0
    path = slice_mesh(mesh, [0.0, 0.5, 1.0, 2.0], 0.0)
    assert set(path.pass_.tolist()) == {1}
    check_closed(path, check_path(mesh, path, [0.0, 0.5, 1.0, 2.0], 0.0))


@pytest.mark.parametrize("seed", range(8))
def test_random_surfaces_on_a_coarse_grid_keep_every_promise(seed):
    """Heights and offsets in whole numbers: vertices, edges and whole facets lie on planes all the time."""
    rng = np.random.default_rng(seed)
    n = 5
    heights = rng.integers(0, 3, (n + 1, n + 1)).astype(float)
    shift = rng.integers(0, 2, (2, n + 1, n + 1)) * 0.5
    corners = field(n, lambda x, y: heights)
    index = np.rint(corners[..., :2]).astype(int)
    corners[..., :2] += np.moveaxis(shift[:, index[..., 0], index[..., 1]], 0, -1)
    mesh = from_triangles(corners)
    keep = rng.random(len(mesh.face)) < 0.8
    for angle in (0.0, np.pi / 2, np.pi / 4, 0.3):
        offsets = np.arange(-8.0, 9.0, 0.5)
        expected = facet_sections(mesh, offsets, angle)
        path = slice_mesh(mesh, offsets, angle)
        check_path(mesh, path, offsets, angle)
        assert lengths(path).sum() == pytest.approx(sum(expected.values()), abs=1e-9)
        part = slice_mesh(mesh, offsets, angle, keep)
        check_path(mesh, part, offsets, angle)
        kept = sum(length for (_, facet), length in expected.items() if keep[facet])
        assert lengths(part).sum() == pytest.approx(kept, abs=1e-9)


def test_open_polylines_start_where_the_travel_starts_and_run_to_its_end():
    mesh = from_triangles(field(6, lambda x, y: np.cos(x) + np.sin(2.0 * y)))
    for angle in (0.0, np.pi / 2, np.pi):
        travel, across = vectors(angle)
        offsets = np.sort(np.array([0.25, 2.5, 4.75]) * (1.0 if (across >= 0).all() else -1.0))
        path = slice_mesh(mesh, offsets, angle)
        first = check_path(mesh, path, offsets, angle)
        assert len(first) == 3
        position = path.point @ travel
        assert (position[1::2] > position[0::2]).all()
        np.testing.assert_allclose(position[2 * first], min(0.0, 6.0 * travel.sum()), atol=1e-12)


def test_facets_left_out_end_the_polylines_at_their_coedges():
    mesh = from_triangles(sphere(rows=24, columns=36))
    offsets = np.linspace(-8.0, 8.0, 9)
    keep = mesh.normal[:, 2] > 0.2
    path = slice_mesh(mesh, offsets, 0.4, keep)
    first = check_path(mesh, path, offsets, 0.4)
    assert len(first) == 9
    assert keep[path.face].all()
    ends = np.concatenate(
        [path.coedge[2 * first], path.coedge[2 * np.append(first[1:], len(path.face) // 2) - 1]]
    )
    assert (keep[mesh.coedge_face[ends]].sum(axis=1) == 1).all()
    whole = slice_mesh(mesh, offsets, 0.4)
    assert lengths(path).sum() == pytest.approx(lengths(whole)[keep[whole.face[0::2]]].sum())


def test_a_pass_of_several_polylines_goes_along_the_travel():
    mesh = from_triangles(
        np.concatenate([box(low=(x, 0.0, 0.0), high=(x + 1.0, 1.0, 1.0)) for x in (6.0, 0.0, 3.0)])
    )
    path = slice_mesh(mesh, [0.5], 0.0)
    first = check_path(mesh, path, [0.5], 0.0)
    check_closed(path, first)
    np.testing.assert_allclose(path.point[2 * first][:, 0], [0.0, 3.0, 6.0])
    np.testing.assert_allclose(slice_mesh(mesh, [-0.5], np.pi).point[2 * first][:, 0], [7.0, 4.0, 1.0])


def test_open_and_closed_polylines_in_one_pass_are_distinguished():
    sheet = field(8, lambda x, y: -1.0 + 0.0 * x) - [4.0, 0.0, 0.0]
    mesh = from_triangles(
        np.concatenate(
            [box(low=(-2.0, 0.0, 0.0), high=(2.0, 8.0, 1.0)), sheet, box(low=(5, 0, 0), high=(6, 8, 1))]
        )
    )
    path = slice_mesh(mesh, [3.3, 4.1], 0.0)
    first = check_path(mesh, path, [3.3, 4.1], 0.0)
    np.testing.assert_allclose(path.point[2 * first][:, 0], [-4.0, -2.0, 5.0] * 2)
    last = np.append(first[1:], len(path.face) // 2) - 1
    np.testing.assert_array_equal(
        (path.point[2 * first] == path.point[2 * last + 1]).all(axis=1), [False, True, True] * 2
    )


def test_a_wall_without_top_is_cut_in_closed_loops_that_never_turn():
    """Two upright triangles back to back: no facet looks up, so nothing says where to start."""
    vertex = np.array([[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 1.0, 2.0]])
    mesh = from_faces(vertex, [[0, 1, 2], [0, 2, 1]])
    path = slice_mesh(mesh, [0.5, 1.5], 0.0)
    first = check_path(mesh, path, [0.5, 1.5], 0.0)
    check_closed(path, first)
    assert path.polyline.max() == 1
    assert lengths(path).sum() == pytest.approx(4.0)


def test_bodies_that_touch_in_an_edge_end_their_polylines_there():
    mesh = from_triangles(np.concatenate([box(), box(low=(1.0, 1.0, 0.0), high=(2.0, 2.0, 1.0))]))
    for angle in (0.0, 0.3, np.pi / 4):
        across = vectors(angle)[1]
        offset = float(np.array([1.0, 1.0, 0.0]) @ across)
        offsets = [offset - 0.1, offset, offset + 0.1]
        path = slice_mesh(mesh, offsets, angle)
        check_path(mesh, path, offsets, angle)
        assert lengths(path).sum() == pytest.approx(sum(facet_sections(mesh, offsets, angle).values()))


def test_no_planes_no_facets_and_planes_beside_the_part_give_an_empty_path():
    mesh = from_triangles(box())
    for path in (
        slice_mesh(mesh, [], 0.0),
        slice_mesh(mesh, [-5.0, 7.0], 0.3),
        slice_mesh(mesh, [0.5], 0.0, np.zeros(12, dtype=bool)),
        slice_mesh(mesh, [0.0], 0.0),
    ):
        assert path.point.shape == path.normal.shape == (0, 3)
        assert (
            len(path.face)
            == len(path.coedge)
            == len(path.segment)
            == len(path.polyline)
            == len(path.pass_)
            == 0
        )


def test_the_same_plane_twice_gives_the_same_pass_twice():
    mesh = from_triangles(sphere())
    path = slice_mesh(mesh, [2.0, 2.0], 0.3)
    one, two = (path.point[path.pass_ == k] for k in (0, 1))
    np.testing.assert_array_equal(one, two)


def test_a_turned_part_under_turned_planes_gives_the_turned_path():
    rng = np.random.default_rng(2)
    corners = sphere(rows=10, columns=14) * [1.0, 0.7, 0.5] + 0.1 * rng.normal(size=3)
    angle = 0.77
    cosine, sine = direction(angle)
    turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    mesh = from_triangles(corners)
    turned = from_faces(mesh.vertex @ turn.T, mesh.face)
    offsets = [-3.0, -1.01, 2.2]
    path, same = slice_mesh(mesh, offsets, 0.0), slice_mesh(turned, offsets, angle)
    np.testing.assert_allclose(same.point, path.point @ turn.T, atol=1e-12)
    np.testing.assert_array_equal(same.face, path.face)


def test_quarter_turns_are_exact():
    assert [direction(k * np.pi / 2) for k in range(4)] == [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)]
    assert direction(1e-9)[1] == 1e-9


def test_levels_count_the_planes_at_or_below():
    rng = np.random.default_rng(8)
    for offsets in (
        np.arange(10.0),
        np.sort(rng.normal(size=40)),
        np.array([1.0, 1.0, 2.0]),
        np.array([3.0]),
        np.empty(0),
    ):
        distance = np.concatenate(
            [
                rng.normal(size=500, scale=4.0),
                offsets,
                np.nextafter(offsets, -9e9),
                np.nextafter(offsets, 9e9),
            ]
        )
        np.testing.assert_array_equal(levels(distance, offsets), [(offsets <= d).sum() for d in distance])


@pytest.mark.parametrize(
    ("offsets", "angle", "keep", "message"),
    [
        ([1.0, 0.5], 0.0, None, "ascending"),
        ([np.nan], 0.0, None, "finite"),
        ([[1.0]], 0.0, None, "one ascending row"),
        (np.array([0.0, 3.0, 2.0]), 0.0, None, "2 follows 3"),
        ([0.5], np.inf, None, "angle"),
        ([0.5], 0.0, np.ones(11, dtype=bool), "12 facets"),
    ],
)
def test_settings_that_cannot_be_used_are_refused(offsets, angle, keep, message):
    with pytest.raises(SettingsError, match=message):
        slice_mesh(from_triangles(box()), offsets, angle, keep)


def test_progress_is_reported_from_nothing_to_all():
    heard = []
    slice_mesh(from_triangles(box()), [0.5], 0.0, None, lambda stage, fraction: heard.append(fraction))
    assert heard[0] == 0.0 and heard[-1] == 1.0 and heard == sorted(heard)


# ---- the other way round, and what is passed over
# -------------------------------------------------------------------------


def reversed_rows(path, turned):
    """The rows of a path with the passes ``turned`` the other way round."""
    return np.concatenate(
        [np.flatnonzero(path.pass_ == k)[:: -1 if k in turned else 1] for k in np.unique(path.pass_)]
    )


def block(height=3.0, count=24):
    """A block of 20 x 10 mm on a fan of facets about the middle of its underside; which facets lie there."""
    turn = np.arange(count) * 2 * np.pi / count
    rim = np.column_stack([10 * np.cos(turn), 5 * np.sin(turn)])
    vertex = np.concatenate(
        [[[0.7, 0.3, 0], [0, 0, height]], np.insert(rim, 2, 0, 1), np.insert(rim, 2, height, 1)]
    )
    one, two = np.arange(count), (np.arange(count) + 1) % count
    foot, top = 2 + one, 2 + count + one
    walls = [np.stack(side, 1) for side in ((foot, 2 + two, 2 + count + two), (foot, 2 + count + two, top))]
    under, over = np.stack([0 * one, 2 + two, foot], 1), np.stack([0 * one + 1, top, 2 + count + two], 1)
    return from_faces(vertex, np.concatenate([under, over, *walls])), np.arange(4 * count) < count


@pytest.mark.parametrize("angle", ANGLES)
def test_zigzag_cuts_every_other_pass_backwards(angle):
    mesh, offsets = from_triangles(sphere(9.0, 17, 23)), np.linspace(-8.0, 8.5, 7)
    path, back = slice_mesh(mesh, offsets, angle), slice_mesh(mesh, offsets, angle, order="zigzag")
    rows = reversed_rows(path, (1, 3, 5))
    for name in ("point", "normal", "face", "coedge", "pass_"):
        np.testing.assert_array_equal(getattr(back, name), getattr(path, name)[rows])
    np.testing.assert_array_equal(back.segment, path.segment)


def test_a_whole_pass_of_several_polylines_comes_the_other_way_round():
    mesh = from_triangles(field(12, lambda x, y: np.sin(x) + 0.1 * y))
    keep = np.random.default_rng(3).random(len(mesh.face)) < 0.7
    offsets = np.linspace(*np.quantile(mesh.vertex[:, 1], [0.1, 0.9]), 4)
    path, back = slice_mesh(mesh, offsets, 0.0, keep), slice_mesh(mesh, offsets, 0.0, keep, order="zigzag")
    assert len(np.unique(path.polyline[path.pass_ == 1])) > 2
    rows = reversed_rows(path, (1, 3))
    np.testing.assert_array_equal(back.point, path.point[rows])
    np.testing.assert_array_equal(np.diff(back.polyline) != 0, np.diff(path.polyline[rows]) != 0)
    assert (np.diff(back.polyline) >= 0).all() and back.polyline[-1] == path.polyline[-1]


def test_plain_facets_of_one_plane_make_one_segment():
    mesh, under = block()
    offsets = np.linspace(-4.0, 4.0, 9)
    whole, path = slice_mesh(mesh, offsets, 0.2), slice_mesh(mesh, offsets, 0.2, plain=under)
    above, there = (~under[each.face] for each in (whole, path))
    for name in ("point", "face", "coedge", "pass_"):
        np.testing.assert_array_equal(getattr(path, name)[there], getattr(whole, name)[above])
    for k in range(len(offsets)):
        assert np.count_nonzero(~above & (whole.pass_ == k)) > 8
        assert np.count_nonzero(~there & (path.pass_ == k)) == 2
    assert lengths(path).sum() == pytest.approx(lengths(whole).sum(), rel=1e-12)
    inside = path.polyline[1:] == path.polyline[:-1]
    np.testing.assert_array_equal(path.point[1::2][:-1][inside[1::2]], path.point[2::2][inside[1::2]])


def test_plain_facets_of_several_planes_stay_apart():
    mesh, _ = block()
    top = mesh.normal[:, 2] > 0.5
    path, whole = slice_mesh(mesh, [1.1], 0.0, plain=~top), slice_mesh(mesh, [1.1], 0.0)
    walls, under = np.abs(mesh.normal[:, 2]) < 0.5, mesh.normal[:, 2] < -0.5
    assert np.count_nonzero(walls[whole.face]) == 8  # two facets of each of two walls
    assert np.count_nonzero(walls[path.face]) == 4 and np.count_nonzero(under[path.face]) == 2


def test_a_pass_that_cuts_plain_facets_alone_does_not_change_the_zigzag():
    mesh, offsets = from_triangles(sphere(9.0, 17, 23)), np.linspace(-8.0, 8.0, 5)
    plain = mesh.vertex[mesh.face][:, :, 1].min(axis=1) < -5.0  # all that the first plane cuts
    path = slice_mesh(mesh, offsets, 0.0, plain=plain)
    back = slice_mesh(mesh, offsets, 0.0, plain=plain, order="zigzag")
    np.testing.assert_array_equal(back.point, path.point[reversed_rows(path, (2, 4))])


def test_an_unknown_order_is_refused():
    with pytest.raises(SettingsError, match="spiral"):
        slice_mesh(from_triangles(box()), [0.5], 0.0, order="spiral")
