# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be milled, and what is said of all else."""

import FreeCAD
import Mesh
import numpy as np
import Part
import pytest
from conftest import FAST, PLAIN, half_ball

from freecad_fiveaxis import app
from freecad_fiveaxis.app import convert, selection, signs, tessellation
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.base.errors import FiveAxisError

WHAT = "select a solid, faces of a solid, a body, a compound of solids, or a mesh"


def feature(doc, shape, name="Thing"):
    obj = doc.addObject("Part::Feature", name)
    obj.Shape = shape
    doc.recompute()
    return obj


def test_a_selection_error_is_ours_and_a_value_error():
    assert issubclass(SelectionError, FiveAxisError) and issubclass(SelectionError, ValueError)


def test_picking_a_solid_and_its_faces(ball):
    assert selection.pick([(ball, [])]) == (ball, ())
    assert selection.pick([(ball, ["Face2", "Face1", "Face2"])]) == (ball, ("Face2", "Face1"))
    assert selection.pick([(ball, ["Face1"]), (ball, ["Face2"])]) == (ball, ("Face1", "Face2"))
    assert selection.pick([(ball, ["Edge1"])]) == (ball, ())
    assert selection.pick([(ball, ["Pad.;#1:2;FAC.Face2"])]) == (ball, ("Face2",))


def test_picking_in_a_part_takes_the_solid_in_it(doc, ball):
    part = doc.addObject("App::Part", "Holder")
    part.addObject(feature(doc, Part.makeBox(1, 1, 1), "Cube"))
    part.addObject(ball)
    part.Placement.Base = FreeCAD.Vector(100, 0, 0)
    doc.recompute()
    assert selection.pick([(part, ["Ball.Face2"])]) == (ball, ("Face2",))
    whole, _ = selection.solids(part)
    assert len(whole.Solids) == 2 and whole.BoundBox.XMin == pytest.approx(80)


def test_picking_a_face_of_a_body_stays_with_the_body(doc):
    body = doc.addObject("PartDesign::Body", "Body")
    body.addObject(doc.addObject("PartDesign::AdditiveBox", "Box"))
    doc.recompute()
    assert selection.pick([(body, ["Box.Face2"])]) == (body, ("Face2",))


def test_a_link_to_a_solid_is_the_solid_where_the_link_stands(doc, ball):
    link = doc.addObject("App::Link", "Link")
    link.LinkedObject = ball
    link.Placement.Base = FreeCAD.Vector(0, 0, 50)
    doc.recompute()
    assert selection.pick([(link, ["Face1"])]) == (link, ("Face1",))
    assert selection.solids(link)[0].BoundBox.ZMin == pytest.approx(50)
    assert app.create_toolpath(doc, link, **{**FAST, "stepover": 5}).Blocks > 100


def test_picking_a_mesh_takes_the_whole_of_it(dome):
    assert selection.pick([(dome, ["Facet12"])]) == (dome, ())


def test_nothing_selected():
    with pytest.raises(SelectionError, match="Nothing is selected: " + WHAT):
        selection.pick([])
    with pytest.raises(SelectionError, match="Nothing is selected"):
        app.create_toolpath(FreeCAD.newDocument("Empty"), None)
    FreeCAD.closeDocument("Empty")


def test_two_objects_selected(doc, ball):
    other = feature(doc, Part.makeBox(1, 1, 1), "Other")
    with pytest.raises(SelectionError, match=r"Ball, Other.*select one"):
        selection.pick([(ball, []), (other, [])])


def bad_shapes(doc):
    import Sketcher  # noqa: F401  (its type is known once the module is loaded)

    yield doc.addObject("Sketcher::SketchObject", "Sketch"), "no solid"
    sketch = doc.addObject("Sketcher::SketchObject", "Drawn")
    sketch.addGeometry(Part.LineSegment(FreeCAD.Vector(), FreeCAD.Vector(1, 0, 0)))
    doc.recompute()
    yield sketch, "a sketch"
    yield feature(doc, Part.makeLine((0, 0, 0), (1, 0, 0))), "an? edge"
    yield feature(doc, Part.makePlane(10, 10)), "a face"
    yield feature(doc, Part.makeCompound([Part.makePlane(10, 10)])), "without solids"
    yield doc.addObject("App::DocumentObjectGroup", "Group"), "no solid"
    yield doc.addObject("PartDesign::Body", "Body"), "no solid"


def test_other_shapes_are_shown_what_to_select_instead(doc):
    for obj, says in bad_shapes(doc):
        count = len(doc.Objects)
        for act in (
            lambda obj=obj: selection.pick([(obj, [])]),
            lambda obj=obj: app.create_toolpath(doc, obj),
            lambda obj=obj: app.tessellate(obj),
        ):
            with pytest.raises(SelectionError, match=says) as reported:
                act()
            assert obj.Label in str(reported.value) and WHAT in str(reported.value)
        assert len(doc.Objects) == count


def test_an_invalid_solid_is_reported(doc):
    square = [
        FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 10, 0), (10, 0, 0), (0, 10, 0), (0, 0, 0))
    ]  # crosses itself
    shape = Part.Face(Part.makePolygon(square)).extrude(FreeCAD.Vector(0, 0, 5))
    assert not shape.isValid()
    with pytest.raises(SelectionError, match=r"Thing is invalid.*repair it"):
        app.create_toolpath(doc, feature(doc, shape))


def test_an_empty_mesh_is_reported(doc):
    with pytest.raises(SelectionError, match="Blank is an empty mesh"):
        app.create_toolpath(doc, doc.addObject("Mesh::Feature", "Blank"))


def test_a_reversed_solid_is_milled_as_it_should_have_been(doc, ball):
    inside_out = feature(doc, half_ball().reversed())
    assert inside_out.Shape.Volume < 0
    right, turned = (
        app.tessellate(ball, linear_deflection=0.1),
        app.tessellate(inside_out, linear_deflection=0.1),
    )
    assert all(facet.Normal.dot(_centre(facet) - FreeCAD.Vector(0, 0, 5)) > 0 for facet in turned.Mesh.Facets)
    assert turned.Mesh.CountFacets == right.Mesh.CountFacets


def _centre(facet):
    return FreeCAD.Vector(*[sum(axis) / 3 for axis in zip(*facet.Points, strict=True)])


def test_faces_are_known_again_on_the_solids_of_a_compound(doc):
    loose = Part.makePlane(5, 5, FreeCAD.Vector(50, 50, 50))
    compound = feature(doc, Part.makeCompound([loose, Part.makeBox(10, 10, 10), half_ball().reversed()]))
    whole, rows = selection.solids(compound, ["Face2", "Face7"])
    assert rows == [0, 5] and len(whole.Solids) == 2
    assert app.tessellate(compound).Mesh.Volume == pytest.approx(1000 + 2 / 3 * 3.14159 * 20**3, rel=0.01), (
        "both outside out"
    )
    with pytest.raises(SelectionError, match="no Face1 on a solid"):
        selection.solids(compound, ["Face1"])
    with pytest.raises(SelectionError, match="no Face99"):
        app.create_toolpath(doc, (compound, ["Face99"]))


def test_faces_of_a_mesh_are_reported(doc, dome):
    with pytest.raises(SelectionError, match="has no faces to choose"):
        app.create_toolpath(doc, dome, faces=("Face1",))


def test_a_base_of_another_document_is_reported(doc, ball):
    other = FreeCAD.newDocument("Other")
    try:
        with pytest.raises(SelectionError, match="another document"):
            app.create_toolpath(other, ball)
    finally:
        FreeCAD.closeDocument(other.Name)


def test_what_stands_in_a_moved_part_is_taken_where_it_is_seen(doc, ball):
    part = doc.addObject("App::Part", "Holder")
    part.addObject(ball)
    part.Placement.Base = FreeCAD.Vector(100, 0, 0)
    ball.Placement.Base = FreeCAD.Vector(0, 10, 0)
    doc.recompute()
    box = app.tessellate(ball, linear_deflection=0.1).Mesh.BoundBox
    assert (box.XMin, box.YMin) == pytest.approx((80, -10), abs=0.5)


def test_a_part_design_body_a_compound_and_a_mesh_are_milled(doc):
    body = doc.addObject("PartDesign::Body", "Body")
    prism = doc.addObject("PartDesign::AdditiveBox", "Box")
    body.addObject(prism)
    compound = feature(
        doc, Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(5, 5, 5, FreeCAD.Vector(30, 0, 0))])
    )
    mesh = doc.addObject("Mesh::Feature", "Mesh")
    mesh.Mesh = Mesh.createBox(10, 10, 10)
    doc.recompute()
    settings = {"machine": "trunnion_ac", "stepover": 4, **PLAIN}
    blocks = [app.create_toolpath(doc, base, **settings).Blocks for base in (body, compound, mesh)]
    assert min(blocks) > 10 and blocks[1] > blocks[2]


def test_a_mesh_that_was_moved_is_milled_where_it_is(doc, tmp_path):
    mesh = doc.addObject("Mesh::Feature", "Mesh")
    mesh.Mesh = Mesh.createBox(10, 10, 10)
    mesh.Placement.Base = FreeCAD.Vector(7, 0, 0)
    doc.recompute()
    from freecad_fiveaxis.app import results

    result = results.result_of(
        app.create_toolpath(
            doc, mesh, **{"machine": "trunnion_ac", "stepover": 4, "work_zero": (0, 0, 5), **PLAIN}
        )
    )
    assert result.draft.mesh.vertex.min(axis=0).tolist() == [2.0, -5.0, -10.0]


class Unread:
    """A mesh object whose property Mesh may not be read as an attribute."""

    def __init__(self, obj):
        self.obj = obj

    def getLinkedObject(self):
        return self

    def __getattr__(self, name):
        assert name != "Mesh", "FreeCAD 1.1 will crash when it quits"
        return getattr(self.obj, name)


def test_the_property_of_a_mesh_is_never_read(doc, tmp_path):
    mesh = doc.addObject("Mesh::Feature", "Mesh")
    mesh.Mesh = Mesh.createSphere(10.0, 20)
    mesh.Placement.Base = FreeCAD.Vector(1, 2, 3)
    unread = Unread(mesh)
    assert selection.is_mesh(unread) and selection.pick([(unread, ())]) == (unread, ())
    mesh.Mesh.write(Filename=str(tmp_path / "mesh.stl"), Format="STL")
    assert convert.stl_bytes(unread) == (tmp_path / "mesh.stl").read_bytes(), (
        "the facets are the same, to the last bit"
    )
    assert signs.top_of([unread]) == mesh.Mesh.BoundBox.ZMax
    assert tessellation._copy_mesh(unread, ()).CountFacets == mesh.Mesh.CountFacets


@pytest.mark.parametrize("turned", [False, True])
def test_the_stl_of_a_mesh_is_freecad_s_own_to_the_last_bit(doc, tmp_path, turned):
    corner = np.random.default_rng(3).normal(size=(300, 3, 3)).astype(np.float32)
    corner[7, 2], corner[8] = corner[7, 1], corner[8, 0]  # a line and a point, which have no normal
    mesh = doc.addObject("Mesh::Feature", "Mesh")
    mesh.Mesh = Mesh.Mesh(corner.reshape(-1, 3).tolist())
    mesh.Placement = FreeCAD.Placement(
        FreeCAD.Vector(1.1, 2.2, 3.3), FreeCAD.Rotation(10, 20, 30) if turned else FreeCAD.Rotation()
    )
    selection.copy_of_mesh(mesh).write(Filename=str(tmp_path / "mesh.stl"), Format="STL")
    assert convert.stl_bytes(mesh) == (tmp_path / "mesh.stl").read_bytes()


def test_a_link_to_a_mesh_is_a_mesh(doc):
    mesh = doc.addObject("Mesh::Feature", "Mesh")
    mesh.Mesh = Mesh.createBox(10, 10, 10)
    link = doc.addObject("App::Link", "Link")
    link.LinkedObject = mesh
    doc.recompute()
    assert selection.is_mesh(link) and selection.copy_of_mesh(link).CountFacets == 12
    assert not selection.is_mesh(doc.addObject("Part::Box", "Box"))
