# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file is meshed as a batch asks for it: STEP, BREP and documents, by the functions that the FreeCAD beside
it runs."""

import json
import os

import FreeCAD
import Mesh
import Part
import pytest

from freecad_fiveaxis.app import mesher, meshing, tessellation
from freecad_fiveaxis.core.batch import solids


def meshed(folder, path, named="", linear=solids.LINEAR):
    """What is left for the batch: made.json, and the mesh where there is one."""
    task = {"file": str(path), "named": named, "linear": linear, "angular": solids.ANGULAR}
    (folder / solids.TASK).write_text(json.dumps(task))
    (folder / solids.MESH).unlink() if (folder / solids.MESH).exists() else None
    mesher.main(str(folder))
    result = json.loads((folder / solids.OUTCOME).read_text())
    return result, Mesh.Mesh(str(folder / solids.MESH)) if (folder / solids.MESH).exists() else None


@pytest.fixture
def jig(tmp_path):
    """A document with a box in a group that stands elsewhere, made into a cut, and a pin."""
    doc = FreeCAD.newDocument()
    box, _, hole = (
        doc.addObject(f"Part::{kind}", name)
        for kind, name in (("Box", "Box"), ("Cylinder", "Pin"), ("Box", "Hole"))
    )
    box.Length, box.Width, box.Height = 20, 16, 12
    hole.Length, hole.Width, hole.Height = 5, 5, 30
    cut = doc.addObject("Part::Cut", "Cut")
    cut.Base, cut.Tool, cut.Label = box, hole, "Blade 2"
    group = doc.addObject("App::Part", "Group")
    group.addObject(cut)
    group.Placement.Base = FreeCAD.Vector(100, 0, 0)
    doc.recompute()
    path = tmp_path / "jig.FCStd"
    doc.saveAs(str(path))
    FreeCAD.closeDocument(doc.Name)
    return path


def test_step_and_brep_are_meshed_within_the_deflection(tmp_path):
    ball = Part.makeSphere(10)
    ball.exportStep(str(tmp_path / "ball.step"))
    ball.exportBrep(str(tmp_path / "ball.brep"))
    for ending in ("step", "brep"):
        result, mesh = meshed(tmp_path, tmp_path / f"ball.{ending}", linear=0.05)
        assert result == {"facets": mesh.CountFacets} and mesh.isSolid()
        centres = [facet.InCircle[0] for facet in mesh.Facets]
        assert all(
            10 - 3 * 0.05 < (centre[0] ** 2 + centre[1] ** 2 + centre[2] ** 2) ** 0.5 < 10.001
            for centre in centres
        )
        assert mesh.Volume == pytest.approx(ball.Volume, rel=0.02)


def test_of_a_document_the_solid_that_is_named_stands_where_it_stands(tmp_path, jig):
    for named in ("Blade 2", "Cut"):
        result, mesh = meshed(tmp_path, jig, named)
        assert mesh.BoundBox.XMin == pytest.approx(100) and mesh.Volume == pytest.approx(
            20 * 16 * 12 - 5 * 5 * 12
        )
    for named in ("", "Nobody"):
        result, mesh = meshed(tmp_path, jig, named)
        assert mesh is None and "Blade 2" in result["error"] and "Pin" in result["error"], (
            "neither box is: the cut is made of them"
        )
    assert not FreeCAD.listDocuments() or all(
        doc.FileName != str(jig) for doc in FreeCAD.listDocuments().values()
    )


def test_a_file_that_holds_no_solid_says_so(tmp_path):
    Part.makePlane(5, 5).exportStep(str(tmp_path / "plane.step"))
    assert "no solid" in meshed(tmp_path, tmp_path / "plane.step")[0]["error"]
    (tmp_path / "spoilt.step").write_text("nothing")
    result, mesh = meshed(tmp_path, tmp_path / "spoilt.step")
    assert mesh is None and result["error"].startswith("FreeCAD cannot read it (Error")
    assert result["error"].endswith("); export it again"), (
        "a sentence, not the dictionary that FreeCAD raises"
    )


def test_the_words_of_both_sides_are_the_same():
    ours = solids.FOLDER, solids.TASK, solids.MESH, solids.OUTCOME, solids.DOCUMENT
    assert ours == (mesher.FOLDER, mesher.TASK, mesher.STL, mesher.OUTCOME, mesher.DOCUMENT)
    assert os.path.samefile(mesher.__file__, solids.script()) and solids.NAMES == meshing.NAMES
    assert (solids.LINEAR, solids.ANGULAR) == (tessellation.LINEAR, tessellation.ANGULAR), (
        "as the window meshes"
    )
