# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh: welding, co-edges, orientation, and what is said about bad input."""

import numpy as np
import pytest
from mesh_shapes import box, field, sphere

from freecad_fiveaxis.core.base.errors import MeshError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles
from freecad_fiveaxis.core.geometry.mesh import weld as weld_module
from freecad_fiveaxis.core.geometry.mesh.half_edges import sort_half_edges
from freecad_fiveaxis.core.geometry.mesh.words import sort_during


def codes(mesh):
    return [f.code for f in mesh.findings]


def brute_force_edges(face):
    """Sorted vertex pair -> list of (facet, column, forward)."""
    edges = {}
    for i, row in enumerate(face.tolist()):
        for k in range(3):
            a, b = row[k], row[(k + 1) % 3]
            edges.setdefault((min(a, b), max(a, b)), []).append((i, k, a < b))
    return edges


def check_coedges(mesh):
    """The co-edge columns against a dictionary of edges."""
    seen = 0
    for pair, uses in brute_force_edges(mesh.face).items():
        rows = {int(mesh.face_coedge[i, k]) for i, k, _ in uses}
        if len(uses) == 2 and uses[0][2] != uses[1][2]:
            assert len(rows) == 1
            row = rows.pop()
            assert set(mesh.coedge_face[row].tolist()) == {uses[0][0], uses[1][0]}
            seen += 1
        else:
            assert len(rows) == len(uses)
            assert {(int(mesh.coedge_face[r, 0]), int(mesh.coedge_face[r, 1])) for r in rows} == {
                (i, -1) for i, _, _ in uses
            }
            seen += len(uses)
        for i, k, _ in uses:
            row = mesh.face_coedge[i, k]
            assert set(mesh.coedge_vertex[row].tolist()) == set(pair)
            along = mesh.face[i, [k, (k + 1) % 3]].tolist()
            assert mesh.coedge_vertex[row].tolist() == (
                along if mesh.coedge_face[row, 0] == i else along[::-1]
            )
    assert len(mesh.coedge_face) == seen


def check_normals(mesh):
    a, b, c = (mesh.vertex[mesh.face[:, k]] for k in range(3))
    n = np.cross(b - a, c - a)
    np.testing.assert_allclose(mesh.normal, n / np.linalg.norm(n, axis=1)[:, None], atol=1e-12)


def check_areas(mesh):
    a, b, c = (mesh.vertex[mesh.face[:, k]] for k in range(3))
    np.testing.assert_allclose(mesh.area, 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1), rtol=1e-9)


def volume(mesh):
    a, b, c = (mesh.vertex[mesh.face[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0


def test_a_cube_has_8_vertices_18_coedges_and_no_findings():
    mesh = from_triangles(box())
    assert (len(mesh.vertex), len(mesh.face), len(mesh.coedge_face)) == (8, 12, 18)
    assert not mesh.findings
    assert volume(mesh) == pytest.approx(1.0)
    check_coedges(mesh)
    check_normals(mesh)
    check_areas(mesh)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_welding_gives_back_the_corners_and_joins_all_that_are_equal(dtype):
    corners = sphere(rows=30, columns=40, centre=(3.0, -70.0, 0.5)).astype(dtype)
    mesh = from_triangles(corners)
    np.testing.assert_array_equal(mesh.vertex[mesh.face], corners.astype(np.float64))
    assert len(mesh.vertex) == len(np.unique(corners.reshape(-1, 3), axis=0))
    assert not mesh.findings
    check_coedges(mesh)


def test_minus_zero_equals_zero_and_the_next_float_does_not():
    corners = box(low=(0.0, 0.0, 0.0))
    first = corners[0].copy()
    corners[0][corners[0] == 0.0] = -0.0
    assert len(from_triangles(corners).vertex) == 8
    corners[0] = first
    corners[0][first == 0.0] = np.nextafter(0.0, 1.0)
    assert len(from_triangles(corners).vertex) > 8


def test_colliding_hashes_do_not_join_what_differs(monkeypatch):
    corners = sphere(rows=20, columns=20)
    good = from_triangles(corners)
    monkeypatch.setattr(weld_module, "_FACTORS", (0, 0, 0))
    poor = from_triangles(corners)
    np.testing.assert_array_equal(poor.vertex[poor.face], good.vertex[good.face])
    assert len(poor.vertex) == len(good.vertex)
    assert not poor.findings


def test_colliding_hashes_and_flat_facets_do_not_mix_up_the_co_edges(monkeypatch):
    corners = sphere(rows=9, columns=11)
    flat = np.concatenate([corners[:3][:, [0, 1, 1]], corners, corners[:3][:, [2, 0, 2]]])
    monkeypatch.setattr(weld_module, "_FACTORS", (0, 0, 0))
    mesh = from_triangles(flat)
    np.testing.assert_array_equal(mesh.vertex[mesh.face], corners)
    assert codes(mesh) == ["degenerate-facets"]
    check_coedges(mesh)
    check_normals(mesh)
    check_areas(mesh)


def test_what_is_done_during_a_sort_comes_back_and_so_does_its_error():
    word = np.arange(9, dtype=np.uint64)[::-1].copy()
    assert sort_during(word, lambda: "done") == "done"
    np.testing.assert_array_equal(word, np.arange(9))
    with pytest.raises(ZeroDivisionError):
        sort_during(word, lambda: 1 / 0)


def test_welding_does_not_depend_on_the_order_of_the_facets():
    rng = np.random.default_rng(3)
    corners = sphere()
    shuffled = from_triangles(corners[rng.permutation(len(corners))])
    assert len(shuffled.vertex) == len(from_triangles(corners).vertex)
    assert not shuffled.findings


def test_a_flat_sheet_in_any_coordinate_plane_is_welded():
    for axis in range(3):
        corners = np.roll(field(3, lambda x, y: 0.0 * x), axis, axis=2)
        mesh = from_triangles(corners.astype(np.float32))
        assert len(mesh.vertex) == 16
        assert codes(mesh) == ["open-shell"]


def test_faces_and_triangles_give_the_same_mesh():
    corners = sphere()
    mesh = from_triangles(corners)
    again = from_faces(mesh.vertex, mesh.face)
    for name in ("vertex", "face", "normal", "coedge_vertex", "coedge_face", "face_coedge"):
        np.testing.assert_array_equal(getattr(again, name), getattr(mesh, name))


def test_the_caller_keeps_its_arrays():
    vertex, face = box().reshape(-1, 3), np.arange(36).reshape(12, 3)
    mesh = from_faces(np.asfortranarray(vertex), np.asfortranarray(face))
    vertex[:] = 7.0
    face[:] = 0
    assert mesh.vertex.max() == 1.0
    assert not mesh.vertex.flags.writeable


def test_vertices_that_no_facet_uses_are_left_out():
    vertex = np.array([[9.0, 9.0, 9.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    mesh = from_faces(vertex, [[1, 2, 3]])
    assert len(mesh.vertex) == 3
    assert mesh.vertex.max() == 1.0


def test_half_edges_too_wide_for_one_word_are_paired_all_the_same():
    # 8 million vertices need 23 bits twice, a facet 1 to 3: beside a long table of vertices few facets still
    # fit or not
    corners = sphere(rows=14, columns=30)
    mesh = from_triangles(corners)
    many = 1 << 29
    wide, packed = (
        sort_half_edges(mesh.face, vertices, lambda: None)[0] for vertices in (many, len(mesh.vertex))
    )
    every = slice(None)
    key, narrow = wide.keys(every), packed.keys(every)
    assert wide.half is not None and packed.half is None
    np.testing.assert_array_equal(wide.numbers(every), packed.numbers(every))
    assert wide.low == packed.low and wide.is_paired() and packed.is_paired()
    np.testing.assert_array_equal(np.diff(key) > 0, np.diff(narrow) > 0)


def test_an_inward_solid_is_turned_outward_with_a_note():
    corners = sphere()
    good, mesh = from_triangles(corners), from_triangles(corners[:, ::-1])
    assert codes(mesh) == ["inward-facets"]
    assert mesh.findings[0].severity == Severity.NOTE
    assert volume(mesh) == pytest.approx(volume(good))
    check_coedges(mesh)
    check_normals(mesh)
    check_areas(mesh)


def test_a_void_stays_a_void():
    corners = np.concatenate(
        [box(high=(9.0, 9.0, 9.0)), box(low=(3.0, 3.0, 3.0), high=(6.0, 6.0, 6.0))[:, ::-1]]
    )
    mesh = from_triangles(corners)
    assert not mesh.findings
    assert volume(mesh) == pytest.approx(9.0**3 - 27.0)


def test_the_orientation_does_not_depend_on_where_the_solid_stands():
    for centre in ((0.0, 0.0, 0.0), (5e5, -5e5, 9e5), (0.0, 0.0, -9e5)):
        assert codes(from_triangles(sphere(centre=centre))) == []
        assert codes(from_triangles(sphere(centre=centre)[:, ::-1])) == ["inward-facets"]


def test_an_open_shell_keeps_its_sense_and_says_so_with_the_first_place():
    corners = field(4, lambda x, y: 0.1 * x * y)[:, ::-1]
    mesh = from_triangles(corners)
    assert codes(mesh) == ["open-shell"]
    assert (mesh.normal[:, 2] < 0.0).all()
    assert mesh.findings[0].value == 16.0
    assert (mesh.coedge_face[:, 1] < 0).sum() == 16
    x, y, _ = mesh.findings[0].place
    assert min(x, y) == 0.0 or max(x, y) == 4.0
    check_coedges(mesh)


def test_a_facet_with_a_vertex_twice_goes_and_its_neighbours_stay_joined():
    corners = box()
    a, b, _ = corners[0]
    mesh = from_triangles(np.concatenate([corners, [[a, b, b]]]))
    assert codes(mesh) == ["degenerate-facets"]
    assert mesh.findings[0].place == pytest.approx(tuple((a + 2.0 * b) / 3.0))
    assert len(mesh.face) == 12
    check_coedges(mesh)


def test_a_needle_on_a_straight_line_goes_and_leaves_a_crack():
    right = [
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
        [[0.1, 0.1, 0.1], [0.2, 0.2, 0.2], [0.4, 0.4, 0.4]],
    ]
    for shift in (0.0, 100.0, 1e5):
        mesh = from_triangles(np.array(right) + shift)
        assert codes(mesh) == ["degenerate-facets", "open-shell"]
        assert len(mesh.face) == 1


def test_a_thin_facet_that_has_an_area_stays():
    mesh = from_triangles([[[100.0, 0.0, 0.0], [101.0, 0.0, 0.0], [100.5, 1e-9, 0.0]]])
    assert len(mesh.face) == 1
    np.testing.assert_allclose(mesh.normal, [[0.0, 0.0, 1.0]])


def test_two_boxes_that_share_an_edge_are_cut_apart_there():
    corners = np.concatenate([box(), box(low=(1.0, 1.0, 0.0), high=(2.0, 2.0, 1.0))])
    mesh = from_triangles(corners)
    assert codes(mesh) == ["non-manifold-edges"]
    assert mesh.findings[0].value == 1.0
    assert mesh.findings[0].place == (1.0, 1.0, 0.5)
    check_coedges(mesh)
    turned = from_triangles(corners[:, ::-1])
    assert set(codes(turned)) == {"non-manifold-edges", "inward-facets"}
    check_coedges(turned)


def test_a_facet_that_runs_the_wrong_way_is_found():
    corners = box()
    corners[5] = corners[5, ::-1]
    mesh = from_triangles(corners)
    assert codes(mesh) == ["inconsistent-winding"]
    assert mesh.findings[0].value == 3.0
    assert mesh.findings[0].severity == Severity.WARNING
    check_coedges(mesh)


@pytest.mark.parametrize("seed", range(6))
def test_any_soup_of_triangles_gets_coedges(seed):
    rng = np.random.default_rng(seed)
    face = rng.integers(0, 9, (40, 3))
    face = face[(face[:, 0] != face[:, 1]) & (face[:, 1] != face[:, 2]) & (face[:, 0] != face[:, 2])]
    mesh = from_faces(rng.normal(size=(9, 3)), face)
    assert mesh.findings
    check_coedges(mesh)
    check_normals(mesh)
    check_areas(mesh)


def test_no_facets_are_refused():
    for nothing in (np.empty((0, 3, 3)), []):
        with pytest.raises(MeshError, match="no facets"):
            from_triangles(nothing)
    with pytest.raises(MeshError, match="no facets"):
        from_faces(np.zeros((3, 3)), np.empty((0, 3), dtype=int))


@pytest.mark.parametrize(
    ("value", "message"),
    [(np.nan, "finite"), (np.inf, "finite"), (-np.inf, "finite"), (1e9, "units"), (-1.1e6, "units")],
)
def test_a_coordinate_that_no_part_has_is_refused_with_facet_and_value(value, message):
    corners = box().astype(np.float32)
    corners[7, 1, 2] = value
    with pytest.raises(MeshError, match=f"facet 8 of 12 has z = .*{message}") as caught:
        from_triangles(corners)
    np.testing.assert_equal(caught.value.value, float(np.float32(value)))
    with pytest.raises(MeshError, match=f"vertex 2 of 3 has x = .*{message}"):
        from_faces([[0, 0, 0], [value, 0, 0], [0, 1, 0]], [[0, 1, 2]])


def test_facets_that_all_lack_an_area_are_refused():
    for corners in (np.ones((4, 3, 3)), np.zeros((1, 3, 3)), np.linspace(0, 1, 9).reshape(1, 3, 3)):
        for dtype in (np.float32, np.float64):
            with pytest.raises(MeshError, match="has an area"):
                from_triangles(corners.astype(dtype))


def test_a_vertex_row_that_does_not_exist_is_refused():
    for face, wrong in (([[0, 1, 3]], "3"), ([[0, 1, -1]], "-1")):
        with pytest.raises(MeshError, match=f"vertex {wrong}"):
            from_faces(np.eye(3), face)
    with pytest.raises(MeshError, match="integer"):
        from_faces(np.eye(3), [[0.0, 1.0, 2.0]])


@pytest.mark.parametrize(
    "corners", [np.ones(9), np.ones((2, 3, 2)), [["a", "b"]], [[1.0], [1.0, 2.0]], np.ones((1, 3, 3)) * 1j]
)
def test_what_is_no_table_of_triangles_is_refused(corners):
    with pytest.raises(MeshError):
        from_triangles(corners)
