# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of one part that overlap: what lies inside another one is left out, and that is said."""

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.overlapping import find_buried_facets, report_buried


def divided(corners, times=3):
    """Each facet in four, so many times."""
    for _ in range(times):
        a, b, c = corners.transpose(1, 0, 2)
        ab, bc, ca = 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)
        corners = np.concatenate(
            [np.stack(one, axis=1) for one in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
        )
    return corners


def post_in_plate(low=-2.0):
    """A post 8 mm square in the middle of a plate from Z 0 to 4, from ``low`` to Z 10."""
    return from_triangles(
        np.concatenate([divided(box((0, 0, 0), (32, 32, 4))), divided(box((12, 12, low), (20, 20, 10)))])
    )


def middles(mesh, rows):
    return mesh.vertex[mesh.face[rows]].mean(axis=1)


def test_what_lies_inside_the_other_solid_is_found_and_nothing_else():
    mesh = post_in_plate()
    buried = find_buried_facets(mesh)
    x, y, z = middles(mesh, slice(None)).T
    in_plate = (np.abs(x - 16.0) < 4.1) & (np.abs(y - 16.0) < 4.1) & (z > 1e-6) & (z < 4.0 - 1e-6)
    in_post = (
        (np.abs(x - 16.0) < 4.0 - 1e-6)
        & (np.abs(y - 16.0) < 4.0 - 1e-6)
        & ((np.abs(z) < 1e-6) | (np.abs(z - 4.0) < 1e-6))
    )
    assert (buried <= (in_plate | in_post)).all(), "nothing of the skin"
    corner = mesh.vertex[mesh.face]
    wholly = in_post | (
        in_plate & (corner[:, :, 2] >= 0.0).all(axis=1) & (corner[:, :, 2] <= 4.0).all(axis=1)
    )
    assert (buried >= wholly).all() and buried.any()
    (found,) = report_buried(mesh, buried)
    assert found.value == pytest.approx(mesh.area[buried].sum()) and "Unite the solids" in found.text


def test_undersides_in_one_plane_are_the_parts_skin():
    mesh = post_in_plate(low=0.0)
    down = mesh.normal[:, 2] < -0.5
    assert not find_buried_facets(mesh)[down & (middles(mesh, slice(None))[:, 2] < 1e-6)].any()
    assert find_buried_facets(mesh).any()


@pytest.mark.parametrize("other", [box((40, 0, 0), (50, 10, 10)), box((8, 8, 1), (24, 24, 3))[:, ::-1]])
def test_solids_that_stand_apart_and_a_hollow_have_nothing_inside(other):
    mesh = from_triangles(np.concatenate([box((0, 0, 0), (32, 32, 4)), other]))
    assert not find_buried_facets(mesh).any() and report_buried(mesh, find_buried_facets(mesh)) == ()


def test_a_program_leaves_them_out_and_says_so_instead_of_calling_them_too_tight():
    given = {
        "machine": "trunnion_ac",
        "cutter": "ball:3",
        "tool_length": 120,
        "stepover": 2.0,
        "linearize": "off",
    }
    draft = job.make(build_settings("mill", "part.stl", given | {"gouge": "off"}), mesh=post_in_plate())
    codes = {one.code: one for one in draft.findings}
    assert "facets-inside" in codes and codes["facets-inside"].value > 200.0
