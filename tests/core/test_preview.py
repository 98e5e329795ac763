# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes laid before anything is computed: they are those of the computed path, their length and time follow
from closed forms."""

import math

import numpy as np
import pytest
from mesh_shapes import box, field
from plain import build_settings

from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.pipeline import job, preview
from freecad_fiveaxis.core.pipeline.preview import preview_passes
from freecad_fiveaxis.core.toolpath.cl_path import Motion

GIVEN = {"machine": "trunnion_ac", "cutter": "ball:6", "gouge": "off", "linearize": "off"}
WAYS = [
    {"passes": "planes", "stepover": 1.5, "direction": 20},
    {"passes": "planes", "scallop": 0.05},
    {"passes": "zlevel", "stepover": 0.4},
    {"passes": "scallop", "scallop": 0.05},
    {"passes": "scallop", "scallop": 0.05, "spiral": "on"},
    {"passes": "radial", "scallop": 0.05},
    {"passes": "morph", "scallop": 0.05},
    {"passes": "scallop", "scallop": 0.05, "steep_shallow": 20},
    {"passes": "frames", "scallop": 0.05, "tool_axis": "auto"},
    {
        "passes": "rotary",
        "scallop": 0.05,
        "tool_axis": "from_axis",
        "pass_axis": (1, 0, 0),
        "pass_centre": "10,10,-5",
    },
]


def dome():
    """An open, convex dome over a square of 20 mm: no place is too tight for a ball, all normals lean less
    than 40 deg."""
    return from_triangles(field(14, lambda x, y: 8.0 - 0.04 * ((x - 10) ** 2 + (y - 10) ** 2), 20 / 14))


def settings(**more):
    return build_settings("mill", "dome.stl", GIVEN | more)


def off_lines(point, preview):
    """The distance (n,) of points from the nearest place of the preview's lines, by every pair of them."""
    end = np.flatnonzero(np.diff(preview.polyline) == 0) + 1
    start, way = preview.point[end - 1], preview.point[end] - preview.point[end - 1]
    square = np.maximum((way * way).sum(axis=1), 1e-30)
    least = np.full(len(point), np.inf)
    for at in range(0, len(point), 200):
        to = point[at : at + 200, None] - start
        share = np.clip((to * way).sum(axis=2) / square, 0.0, 1.0)[..., None]
        least[at : at + 200] = np.sqrt(((to - share * way) ** 2).sum(axis=2)).min(axis=1)
    return least


@pytest.mark.oldest
@pytest.mark.thorough
@pytest.mark.parametrize("way", WAYS, ids=lambda way: "-".join(map(str, way.values())))
def test_every_cut_contact_of_the_path_lies_on_a_line(way):
    mesh, wanted = dome(), settings(**way)
    found, result = preview_passes(wanted, mesh=mesh), job.make(wanted, mesh=mesh)
    cut = result.path.contact[result.path.motion == Motion.CUT]
    assert len(cut) > 300 and off_lines(cut, found).max() < 1e-6
    assert found.passes == len(np.unique(result.offset.pass_)) and len(found.sizes) == found.polyline[-1] + 1
    line = result.offset
    on = np.flatnonzero((np.diff(line.polyline) == 0) & ~line.fill[1:])
    assert found.length == pytest.approx(
        np.linalg.norm(line.point[on + 1] - line.point[on], axis=1).sum(), rel=1e-9
    )
    moved = cut + (0.0, 0.0, 1e-5)
    assert off_lines(moved, found).max() > 2e-6, "the comparison can fail"


def test_on_a_plate_number_length_and_time_are_closed_forms():
    mesh = from_triangles(box((0, 0, 0), (40, 30, 10)))
    found = preview_passes(
        settings(passes="planes", stepover=2, direction=0, max_axis_angle=20, feed=600), mesh=mesh
    )
    assert found.passes == len(found.sizes) and math.isclose(found.length, 40.0 * found.passes)
    assert found.passes in (15, 16) and found.time == pytest.approx(found.length / 10.0)
    assert (np.abs(found.point[:, 2] - 10.0) < 1e-12).all() and (
        found.sizes == np.bincount(found.polyline)
    ).all()


@pytest.mark.parametrize("passes", ["scallop", "planes"])
def test_of_very_many_passes_some_are_planned_and_length_and_time_are_those_of_all(passes, monkeypatch):
    mesh, wanted = dome(), settings(passes=passes, scallop=0.01)
    monkeypatch.setattr(preview, "SQUARES", math.inf)
    whole = preview_passes(wanted, mesh=mesh)
    monkeypatch.setattr(preview, "SQUARES", 400.0)
    some = preview_passes(wanted, mesh=mesh)
    assert whole.one_in == 1 and some.one_in == 3 and len(some.point) < 0.5 * len(whole.point)
    assert some.length == pytest.approx(whole.length, rel=0.08) and some.time == pytest.approx(
        60.0 * some.length / some.feed
    )
    assert some.passes < 0.6 * whole.passes and len(some.sizes) < 0.6 * len(whole.sizes)
    wanted = settings(
        passes=passes, scallop=1.5
    )  # no passes are laid that leave a multiple of the cutter's radius
    assert preview_passes(wanted, mesh=mesh).one_in == 1


def test_faces_and_boundary_leave_out_what_they_leave_out_of_the_path(tmp_path):
    mesh, curve = dome(), tmp_path / "square.csv"
    curve.write_text("4,4,0\n16,4,0\n16,16,0\n4,16,0\n4,4,0\n")
    faces = mesh.vertex[mesh.face].mean(axis=1)[:, 0] < 12.0
    for more in ({}, {"boundary": str(curve)}, {"boundary": str(curve), "boundary_by": "centre"}):
        wanted = settings(passes="planes", stepover=1, direction=30, **more)
        found, result = (
            preview_passes(wanted, mesh=mesh, faces=faces),
            job.make(wanted, mesh=mesh, faces=faces),
        )
        cut = result.path.contact[result.path.motion == Motion.CUT]
        assert len(cut) and off_lines(cut, found).max() < 1e-6
        assert off_lines(found.point, found).max() == 0.0 and found.point[:, 0].max() < 13.5
        if more:
            assert found.point[:, :2].min() > 4 - 1.5 and found.point[:, 1].max() < 17.5


def test_a_bull_nose_held_by_its_centre_ends_near_the_boundary(tmp_path):
    curve = tmp_path / "square.csv"
    curve.write_text("4,4,0\n16,4,0\n16,16,0\n4,16,0\n4,4,0\n")
    wanted = settings(
        passes="planes",
        stepover=1,
        cutter="bull:6:1",
        boundary=str(curve),
        boundary_by="centre",
        tool_axis="facet_mean",
    )
    found = preview_passes(wanted, mesh=dome())
    assert found.point[:, :2].min() > 1.0 and found.point[:, :2].max() < 19.0 and found.passes > 9


def test_where_axes_are_free_no_axis_is_sought():
    message = []
    mesh = dome()
    wanted = build_settings(
        "mill",
        "dome.stl",
        {"machine": "trunnion_ac", "cutter": "ball:6", "passes": "scallop", "tool_axis": "auto"},
    )
    found = preview_passes(wanted, lambda stage, _: message.append(stage), mesh=mesh)
    assert found.passes > 5 and "axis field" not in message and "joint path" not in message and message


def test_what_cannot_be_planned_is_stated_and_work_can_be_stopped():
    below = from_triangles(dome().vertex[dome().face][:, ::-1])
    with pytest.raises(FiveAxisError, match="no facet can be cut"):
        preview_passes(settings(passes="planes", stepover=1, max_axis_angle=10, tool_axis="auto"), mesh=below)

    def stop(*_):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        preview_passes(settings(passes="scallop", scallop=0.05), stop, mesh=dome())
