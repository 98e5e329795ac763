# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts in several lumps: those written inside out are turned, cavities stay, and each stands on the table by
itself."""

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.geometry.mesh.triangles import join_loose
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.passes import standing_facets
from freecad_fiveaxis.core.pipeline import job

BLOCK, BESIDE, INNER = ((0, 0, 0), (30, 20, 10)), ((50, 0, 0), (70, 20, 12)), ((10, 5, 3), (20, 15, 7))


def inverted(corners):
    return corners[:, ::-1]


def solids(*corners):
    return join_loose(from_triangles(np.concatenate(corners)))


def volume(mesh):
    return float(np.linalg.det(mesh.vertex[mesh.face]).sum() / 6.0)


def reported(mesh):
    return [one for one in mesh.findings if one.code == "inward-facets"]


@pytest.mark.parametrize("first", [False, True])
def test_a_solid_inside_out_beside_a_right_one_is_turned_and_reported(first):
    """Whether it is the smaller of both or the larger, for then the whole mesh has been turned before."""
    large, small = box(*BLOCK), box(*BESIDE)
    mesh = solids(*((inverted(large), small) if first else (large, inverted(small))))
    assert volume(mesh) == pytest.approx(30 * 20 * 10 + 20 * 20 * 12)
    (one,) = reported(mesh)
    assert one.value == 12.0 and "looked inward beside others" in one.text
    assert (one.place[0] < 40.0) == first


def test_a_cavity_stays_and_a_solid_inside_out_in_a_cavity_is_turned():
    core = ((12, 7, 4), (18, 13, 6))
    hollow = solids(box(*BLOCK), inverted(box(*INNER)))
    assert volume(hollow) == pytest.approx(6000 - 400) and not reported(hollow)
    filled = solids(box(*BLOCK), inverted(box(*INNER)), inverted(box(*core)))
    assert volume(filled) == pytest.approx(6000 - 400 + 72) and len(reported(filled)) == 1


def test_a_solid_inside_out_beside_an_open_one_is_turned():
    mesh = solids(box(*BLOCK)[1:], inverted(box(*BESIDE)))
    right = mesh.vertex[mesh.face].mean(axis=1)[:, 0] > 40.0
    assert np.linalg.det(mesh.vertex[mesh.face[right]]).sum() / 6.0 == pytest.approx(20 * 20 * 12)


@pytest.mark.parametrize("lifted", [0.0, 5.0])
def test_each_lump_on_the_table_stands_by_itself(lifted):
    """Neither underside lies under the middle of both."""
    mesh = solids(box(*BLOCK), box((500, 0, lifted), (520, 20, 40 + lifted)))
    down = (mesh.normal[:, 2] < -0.9) & (mesh.vertex[mesh.face][:, :, 2].max(axis=1) == 0.0)
    assert np.array_equal(standing_facets(mesh), down) and down.sum() == (2 if lifted else 4)


def test_lumps_that_touch_stand_as_one():
    """A plate on a leg under its corner falls over, in one solid or in two."""
    mesh = solids(box((0, 0, 0), (4, 10, 10)), box((0, 0, 10), (40, 10, 14)))
    assert not standing_facets(mesh).any()


def left_out(**given):
    """The share that is told of a cavity, which no tool reaches."""
    options = {"machine": "trunnion_ac", "tool_length": 120, "cutter": "ball:6", "stepover": 3}
    settings = build_settings("mill", "part", {**options, "passes": "scallop", "tool_axis": "auto"})
    mesh = solids(box(*BLOCK), inverted(box(*INNER)))
    result = job.make(settings, mesh=mesh, **{name: of(mesh) for name, of in given.items()})
    return next(str(one.text) for one in result.findings if one.code == "facets-without-free-axis")


def test_shares_are_of_the_part_alone_or_of_the_faces_chosen():
    whole, cavity = 2.0 * (600 + 300 + 200), 2.0 * (100 + 40 + 40)
    stop = Fixture("stop", from_triangles(box((60, 0, 0), (160, 100, 100))))
    of_part = f"({100.0 * cavity / (whole + cavity):.3g} % of the part)"
    assert of_part in left_out() and of_part in left_out(fixtures=lambda mesh: (stop,))
    chosen = left_out(faces=lambda mesh: mesh.normal[:, 2] > 0.9)
    assert "(14.3 % of what is to be machined)" in chosen  # 100 of 600 and 100 mm2
