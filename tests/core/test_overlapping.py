# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of one part that overlap: what lies inside another one is left out, and that is said."""

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.collision_avoidance import compute_unfinished_share
from freecad_fiveaxis.core.pipeline.overlapping import (
    find_buried_facets,
    measure_partly_buried,
    report_buried,
)


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


def two_blocks():
    """Blocks of 12 facets each, which reach out of each other: 17 by 20 by 10 mm of room in common."""
    return from_triangles(np.concatenate([box((-15, -15, 0), (15, 15, 10)), box((-2, -7, 0), (18, 13, 20))]))


def test_what_reaches_out_of_another_solid_counts_only_where_it_does():
    mesh = two_blocks()
    buried = find_buried_facets(mesh)
    partly = measure_partly_buried(mesh, ~buried)
    in_common = 340 + 200 + 200 + 170 + 170
    assert partly + mesh.area[buried].sum() == pytest.approx(in_common, rel=0.02)
    (found,) = report_buried(mesh, buried, partly)
    assert found.value == pytest.approx(in_common, rel=0.02) and found.within == partly
    assert measure_partly_buried(from_triangles(box((0, 0, 0), (9, 9, 9))), np.ones(12, bool)) == 0.0


def test_what_lies_inside_another_solid_is_neither_finished_nor_left():
    """The map finds up to 10 mm left where no surface of the part is, on half of what it looks at."""
    options = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6", "stepover": 3, "rest": "on"}
    settings = build_settings("mill", "part", {**options, "passes": "scallop", "tool_axis": "auto"})
    result = job.prove(job.make(settings, mesh=two_blocks()))
    x, y, z = result.rest.point.T
    inside = (np.abs(x - 8) < 9.9) & (np.abs(y - 3) < 9.9) & (z < 19.9)
    inside |= (np.abs(x) < 14.9) & (np.abs(y) < 14.9) & (z < 9.9)
    assert not (inside & (z > 0.1)).any() and result.rest.height.max() < 3.0
    draft = result.draft
    (found,) = (one for one in result.findings if one.code == "facets-inside")
    share = compute_unfinished_share(result.findings, draft.mesh, draft.keep)
    left = sum(one.value for one in result.findings if one.code == "uncut")
    assert share == pytest.approx(left / (draft.mesh.area[draft.keep].sum() - found.within))
