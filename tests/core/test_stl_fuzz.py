# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever bytes an STL file holds, reading it gives a mesh or an error of ours, never anything else."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mesh_shapes import box
from test_stl import ascii_lines, binary

from freecad_fiveaxis.core.base.errors import MeshError
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_triangles, read_stl
from freecad_fiveaxis.core.passes import slice_mesh

quick = settings(
    max_examples=150,
    deadline=None,
    derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
VALID = [binary(box()), binary(box(), b"solid "), "\n".join(ascii_lines(box())).encode()]


def read_or_refuse(data, folder):
    path = folder / "fuzz.stl"
    path.write_bytes(data)
    try:
        mesh = read_stl(path)
    except MeshError as refused:
        assert "\n" not in str(refused)
        return
    check_usable(mesh)


def check_usable(mesh):
    """Normals are unit, co-edges point to facets, and planes can cut it."""
    assert isinstance(mesh, Mesh)
    np.testing.assert_allclose(np.linalg.norm(mesh.normal, axis=1), 1.0, atol=1e-9)
    assert np.isin(mesh.coedge_face, np.arange(-1, len(mesh.face))).all()
    assert (
        (mesh.face_coedge[mesh.coedge_face[:, 0]] == np.arange(len(mesh.coedge_face))[:, None])
        .any(axis=1)
        .all()
    )
    path = slice_mesh(mesh, [0.0, 0.25, 1.0], 0.3)
    assert np.isfinite(path.point).all()


@quick
@given(st.binary(max_size=400))
def test_random_bytes(tmp_path, data):
    read_or_refuse(data, tmp_path)


@quick
@given(st.binary(max_size=60), st.integers(0, 2**32 - 1) | st.integers(0, 4), st.binary(max_size=200))
def test_random_bytes_behind_a_header(tmp_path, header, count, body):
    read_or_refuse(header.ljust(80, b"\0") + count.to_bytes(4, "little") + body, tmp_path)


@quick
@given(st.lists(st.binary(min_size=50, max_size=50), min_size=1, max_size=6))
def test_random_facets(tmp_path, facets):
    read_or_refuse(bytes(80) + len(facets).to_bytes(4, "little") + b"".join(facets), tmp_path)


@quick
@given(
    st.sampled_from(VALID),
    st.lists(st.tuples(st.floats(0, 1), st.integers(0, 2), st.binary(min_size=1, max_size=6)), max_size=4),
)
def test_valid_files_with_bytes_changed_added_and_taken_away(tmp_path, data, changes):
    for where, kind, new in changes:
        at = int(where * len(data))
        data = data[:at] + (b"" if kind == 0 else new) + data[at + (0 if kind == 1 else len(new)) :]
    read_or_refuse(data, tmp_path)


@quick
@given(
    st.lists(
        st.sampled_from(
            b"solid endsolid facet normal outer loop vertex endloop endfacet 0 1 -1e3 nan x \n".split(b" ")
        ),
        max_size=120,
    )
)
def test_words_of_stl_in_any_order(tmp_path, words):
    read_or_refuse(b"solid " + b" ".join(words), tmp_path)


@pytest.mark.thorough
@quick
@given(st.lists(st.tuples(*[st.integers(0, 3)] * 9), min_size=1, max_size=14))
def test_triangles_on_a_tiny_grid(corners):
    """Coincident, folded, doubled and flat facets of every kind."""
    try:
        mesh = from_triangles(np.array(corners, dtype=float).reshape(-1, 3, 3))
    except MeshError:
        return
    check_usable(mesh)
