# SPDX-License-Identifier: LGPL-2.1-or-later
"""app.preview_passes: the passes of a part or a tool path, about its work zero, with the document as it
was."""

import numpy as np
import pytest
from conftest import FAST, UNCURED
from scipy.spatial import cKDTree

from freecad_fiveaxis import app
from freecad_fiveaxis.app import results
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.toolpath.cl_path import Motion

ABOUT = {"max_axis_angle": 50, "cutter": "ball:6", "work_zero": (3.0, -2.0, 5.0)}


def test_a_solid_and_its_path_have_the_same_passes_and_the_document_stays(doc, ball):
    found = app.preview_passes(ball, **FAST, **ABOUT)
    assert [one.Name for one in doc.Objects] == ["Ball"]
    path = app.create_toolpath(doc, ball, **FAST, **ABOUT, **UNCURED)
    nc = results.nc_of(path)
    again = app.preview_passes(path)
    assert (
        (again.point == found.point).all()
        and (again.polyline == found.polyline).all()
        and again.passes == path.Passes
    )
    result = results.result_of(path).draft.path
    cut = result.contact[result.motion == Motion.CUT]
    assert cKDTree(again.point).query(cut)[0].max() < 1e-6, (
        "each contact is where a pass crosses an edge of a facet"
    )
    assert cKDTree(again.point + (0, 0, 0.01)).query(cut)[0].max() > 1e-4, "the comparison can fail"
    assert again.time == pytest.approx(again.length / path.Feed.Value)
    assert results.nc_of(path) == nc and path.State == ["Up-to-date"]


def test_other_settings_of_a_path_and_another_mesh_are_not_kept(doc, ball):
    path = app.create_toolpath(doc, ball, **FAST, **ABOUT)
    usual = app.preview_passes(path)
    given = {**FAST, "max_axis_angle": 50, "cutter": "ball:6"}
    finer = app.preview_passes(path, **{**given, "stepover": 2, "linear_deflection": 0.02})
    assert finer.passes > 1.7 * usual.passes and len(finer.point) > 2 * len(usual.point)
    assert (
        path.Mesh.LinearDeflection.Value == 0.1 and path.Stepover.Value == 4 and path.State == ["Up-to-date"]
    )
    ball.Shape = ball.Shape.copy().scale(0.5)
    shrunk = app.preview_passes(path)
    assert np.ptp(shrunk.point[:, 0]) < 0.6 * np.ptp(usual.point[:, 0]), "of the solid as it is now"


def test_faces_and_those_to_avoid_count(doc, ball):
    top = next(
        f"Face{at + 1}" for at, one in enumerate(ball.Shape.Faces) if one.Surface.TypeId == "Part::GeomSphere"
    )
    whole = app.preview_passes(ball, **FAST)
    assert app.preview_passes((ball, [top]), **FAST).passes == whole.passes
    with pytest.raises(FiveAxisError):
        app.preview_passes(ball, **FAST, avoid=[f"Face{at + 1}" for at in range(len(ball.Shape.Faces))])


def test_a_mesh_is_taken_as_it_is(doc, dome):
    found = app.preview_passes(dome, **FAST)
    assert found.passes > 5 and [one.Name for one in doc.Objects] == ["Dome"]
    with pytest.raises(SelectionError, match="have no names"):
        app.preview_passes(dome, **FAST, avoid=["Face1"])


def test_of_a_path_other_faces_count(doc):
    part = doc.addObject("Part::Cone", "Cone")
    part.Radius1, part.Radius2, part.Height = 12, 6, 6
    doc.recompute()
    (top,) = [f"Face{at + 1}" for at, one in enumerate(part.Shape.Faces) if one.CenterOfMass.z > 5.9]
    path = app.create_toolpath(doc, part, **FAST, **UNCURED)
    given = {**FAST, "cutter": "ball:6"}
    whole, upper = app.preview_passes(path, **given), app.preview_passes(path, **given, faces=top)
    assert whole.point[:, 2].min() < 5.0 and upper.point[:, 2].min() > 5.9
    assert app.preview_passes(path, **given).passes == whole.passes
    with pytest.raises(SelectionError, match="Face99"):
        app.preview_passes(path, **given, faces=["Face99"])
