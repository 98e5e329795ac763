# SPDX-License-Identifier: LGPL-2.1-or-later
"""A path's part in another unit: the copy is the part times the factor, stands where it stood, and its faces
are the same."""

import FreeCAD
import Mesh
import numpy as np
import Part
import pytest
from conftest import PLAIN

from freecad_fiveaxis import app
from freecad_fiveaxis.app import convert, results, tessellation
from freecad_fiveaxis.app.scaling import scale_part
from freecad_fiveaxis.core.base.errors import SettingsError

PLACE = FreeCAD.Placement(FreeCAD.Vector(0.01, 0.02, 0.03), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
OPTIONS = {"stepover": 4.0, "cutter": "ball:6:30", **PLAIN}


def solid():
    return Part.makeBox(0.08, 0.06, 0.04)


@pytest.fixture
def held(doc):
    """A tiny box, turned and moved, in a part that is moved as well."""
    part, box = doc.addObject("App::Part", "Holder"), doc.addObject("Part::Feature", "Tiny")
    box.Shape, box.Placement = solid(), PLACE
    part.addObject(box)
    part.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 0.5), FreeCAD.Rotation())
    doc.recompute()
    return box


def corners(path):
    return np.array([tuple(one) for one in (path.Mesh.Mesh.BoundBox.getPoint(k) for k in range(8))])


def corners_of(mesh):
    facets = convert.facets_of(mesh, FreeCAD.Vector())
    return np.array(sorted(map(tuple, np.round(convert.mesh_of(facets.stl()).vertex, 6))))


def suspected(path):
    return any(one.code == "unit-suspected" for one in results.figures_of(path).findings)


def test_a_solid_in_metres_is_milled_a_thousand_times_as_large_where_it_was(doc, held):
    path = app.create_toolpath(doc, held, faces=("Face6",), work_zero=(0.01, 0.0, 0.54), **OPTIONS)
    assert suspected(path)
    before, runs = corners(path), list(path.Mesh.FacetRuns)
    copy = scale_part(path, 1000.0)
    np.testing.assert_allclose(corners(path), 1000.0 * before, rtol=1e-6)
    assert tuple(path.WorkZero) == pytest.approx((10.0, 0.0, 540.0)) and copy.Label == "Tiny x 1000"
    assert tessellation.find_base_and_faces(path.Mesh) == (copy, ("Face6",)) and len(
        path.Mesh.FacetRuns
    ) == len(runs)
    doc.recompute()
    assert not suspected(path) and path.Blocks > 20
    normal = results.result_of(path).draft.mesh.normal[results.result_of(path).draft.keep]
    np.testing.assert_allclose(
        normal, np.tile([0.0, 0.0, 1.0], (len(normal), 1)), atol=1e-6
    )  # the top, and only the top


def test_a_mesh_in_inches_is_milled_in_millimetres(doc):
    base = doc.addObject("Mesh::Feature", "Inches")
    base.Mesh = Mesh.Mesh(solid().tessellate(0.01))
    base.Placement = PLACE
    path = app.create_toolpath(doc, base, **OPTIONS)
    before = corners_of(base)
    copy = scale_part(path, 25.4)
    np.testing.assert_allclose(corners_of(copy), 25.4 * before, rtol=1e-5, atol=1e-6)
    assert path.Mesh is copy and base.Placement == PLACE


@pytest.mark.parametrize("factor", [0.0, -1.0, float("nan"), float("inf"), 1e7])
def test_what_is_no_scale_is_refused(doc, held, factor):
    path = app.create_toolpath(doc, held, **OPTIONS)
    with pytest.raises(SettingsError, match="the factor is"):
        scale_part(path, factor)
    assert path.Mesh.Base[0] is held
