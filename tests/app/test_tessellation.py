# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tessellation: within the deflection, face by face, fast, and a file that the core reads."""

import math

import FreeCAD
import numpy as np
import Part
import pytest
from conftest import half_ball

from freecad_fiveaxis import app
from freecad_fiveaxis.app import convert, long_work, results
from freecad_fiveaxis.core.base.errors import Cancelled, FileError, SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_triangles, read_stl
from freecad_fiveaxis.core.toolpath.cl_path import Motion


def corners(stl):
    return np.frombuffer(stl, convert.STL, offset=84)["corner"].astype(float)


def test_the_facets_keep_within_the_deflection(doc, ball):
    coarse, fine = (
        app.tessellate(ball, linear_deflection=size, angular_deflection=60) for size in (0.5, 0.05)
    )
    for result, size in ((coarse, 0.5), (fine, 0.05)):
        middle = corners(convert.stl_bytes(result)).mean(axis=1)
        off = 20.0 - np.linalg.norm(middle[middle[:, 2] > 0.01], axis=1)
        assert 0.0 < off.max() < 1.5 * size
    assert fine.Facets > 4 * coarse.Facets and coarse.Facets == coarse.Mesh.CountFacets


def test_the_angular_deflection_is_in_degrees(doc, ball):
    counts = [
        app.tessellate(ball, linear_deflection=10, angular_deflection=angle).Facets for angle in (30, "5 deg")
    ]
    assert counts[1] > 10 * counts[0]


def test_the_facets_of_the_chosen_faces_lie_on_them(doc, ball):
    flat = next(i for i, face in enumerate(ball.Shape.Faces) if isinstance(face.Surface, Part.Plane))
    result = app.tessellate(ball, linear_deflection=0.1, faces=(f"Face{flat + 1}",))
    stl = convert.stl_bytes(result)
    chosen = convert.facet_mask(stl, convert.mesh_of(stl), result.FacetRuns)
    assert 0 < chosen.sum() < len(chosen)
    np.testing.assert_allclose(corners(stl)[chosen][..., 2], 0.0, atol=1e-5)
    assert (corners(stl)[~chosen][..., 2].max(axis=1) > 1e-3).all()


def test_a_toolpath_of_a_face_cuts_that_face_only(doc):
    box = doc.addObject("Part::Box", "Box")
    step = doc.addObject("Part::Box", "Step")
    step.Placement.Base = FreeCAD.Vector(10, 0, 0)
    step.Height = 5
    both = doc.addObject("Part::Fuse", "Both")
    both.Base, both.Tool = box, step
    doc.recompute()
    low = next(
        f"Face{i + 1}"
        for i, face in enumerate(both.Shape.Faces)
        if face.BoundBox.ZMin == face.BoundBox.ZMax == 5
    )
    path = app.create_toolpath(doc, (both, [low]), machine="trunnion_ac", cutter="ball:2", stepover=2)
    result = results.result_of(path).draft.path
    cut = result.tip[result.motion == Motion.CUT]
    assert len(cut) and cut[:, 0].min() >= 11.0 - 1e-6  # the ball keeps its radius off the wall at x = 10
    np.testing.assert_allclose(cut[:, 2], 5.0, atol=1e-6)


def test_facets_without_area_do_not_shift_the_chosen_ones():
    rng = np.random.default_rng(5)
    triangles = rng.uniform(-10, 10, (40, 3, 3)).astype(np.float32)
    triangles[[3, 17, 18]] = triangles[[3, 17, 18]][:, :1]  # a point
    triangles[30, 2] = triangles[30, 0]  # a line
    record = np.zeros(40, convert.STL)
    record["corner"] = triangles
    stl = bytes(80) + (40).to_bytes(4, "little") + record.tobytes()
    mesh = convert.mesh_of(stl)
    assert len(mesh.face) == 36
    mask = convert.facet_mask(stl, mesh, (2, 5, 16, 20, 29, 32))
    want = [i for i in range(40) if (2 <= i < 5 or 16 <= i < 20 or 29 <= i < 32) and i not in (3, 17, 18, 30)]
    np.testing.assert_array_equal(mesh.vertex[mesh.face][mask], triangles[want].astype(float))
    assert convert.facet_mask(stl, mesh, ()) is None


def test_the_stl_is_what_the_core_would_make_of_the_facets(doc, ball, tmp_path):
    result = app.tessellate(ball, tmp_path / "ball.stl", linear_deflection=0.1)
    file, direct = (
        read_stl(tmp_path / "ball.stl"),
        from_triangles(corners(convert.stl_bytes(result)).astype(np.float32)),
    )
    np.testing.assert_array_equal(file.vertex[file.face], direct.vertex[direct.face])
    assert len(file.face) == result.Facets and not file.findings
    low, high = file.vertex.min(axis=0), file.vertex.max(axis=0)
    np.testing.assert_allclose(low, (-20, -20, 0), atol=0.1)
    np.testing.assert_allclose(high, (20, 20, 20), atol=0.1)


def test_a_file_is_replaced_only_where_requested(doc, ball, tmp_path):
    target = tmp_path / "ball.stl"
    target.write_bytes(b"mine")
    with pytest.raises(FileError, match="is there already"):
        app.tessellate(ball, target)
    assert target.read_bytes() == b"mine" and len(doc.Objects) == 1
    result = app.tessellate(ball, target, overwrite=True, linear_deflection=0.1)
    assert target.stat().st_size == 84 + 50 * result.Facets
    target.write_bytes(b"")
    assert app.tessellate(result, target) is result and len(doc.Objects) == 2
    assert target.stat().st_size == 84 + 50 * result.Facets


def test_a_folder_that_is_not_there_is_reported_before_the_work(doc, ball, tmp_path):
    with pytest.raises(FileError, match="does not exist; make it first"):
        app.tessellate(ball, tmp_path / "no" / "ball.stl")
    assert len(doc.Objects) == 1


@pytest.mark.parametrize(
    "settings",
    [{"linear_deflection": -1}, {"angular_deflection": 0}, {"deflection": 1}, {"linear_deflection": "1 kg"}],
)
def test_bad_deflections_leave_nothing_behind(doc, ball, settings):
    with pytest.raises(SettingsError):
        app.tessellate(ball, **settings)
    assert [one.Name for one in doc.Objects] == ["Ball"]


def test_a_deflection_of_0_in_the_property_is_reported(doc, ball):
    result = app.tessellate(ball, linear_deflection=0.1)
    result.LinearDeflection = 0
    doc.recompute()
    assert "Invalid" in result.State and "must be above 0" in result.getStatusString()
    result.LinearDeflection = 0.2
    doc.recompute()
    assert result.State == ["Up-to-date"]


def test_it_can_be_stopped(doc, ball):
    def stop(stage, fraction):
        raise Cancelled("stopped")

    with long_work.reporting(stop), pytest.raises(Cancelled):
        app.tessellate(ball)
    assert [one.Name for one in doc.Objects] == ["Ball"]


def test_a_curved_solid_gets_no_more_facets_than_its_deflection_asks_for(doc):
    """``shape.tessellate`` makes ten times as many of this ring, and takes ten times as long
    (benchmarks/freecad)."""
    obj = doc.addObject("Part::Torus", "Ring")
    obj.Radius1, obj.Radius2 = 15, 5
    doc.recompute()
    result = app.tessellate(obj, linear_deflection=0.1, angular_deflection=30)
    assert 1_000 < result.Facets < 0.5 * len(obj.Shape.copy().tessellate(0.1)[1])


def test_half_ball_is_a_solid():
    assert half_ball().Volume == pytest.approx(2 / 3 * math.pi * 8000)
