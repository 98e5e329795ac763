# SPDX-License-Identifier: LGPL-2.1-or-later
"""Centre and axis of radial passes that are links: they are what the solid says, follow it, and are missed when they are gone."""

import FreeCAD
import Part
import pytest
from conftest import FAST, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import changes, convert, guides, results
from freecad_fiveaxis.app.selection import SelectionError

GIVEN = {**FAST, **UNCURED, "passes": "radial", "cutter": "ball:6", "max_axis_angle": 40, "work_zero": (1.0, 2.0, 3.0)}


@pytest.fixture
def disc(doc):
    made = doc.addObject("Part::Feature", "Disc")
    made.Shape = Part.makeCylinder(15, 5, FreeCAD.Vector(20, 10, 0))
    doc.recompute()
    return made


def named(obj, kind, test):
    rows = [test(one) for one in getattr(obj.Shape, {"Edge": "Edges", "Face": "Faces"}[kind])]
    return f"{kind}{rows.index(True) + 1}"


def rim(obj):
    return named(obj, "Edge", lambda one: one.Curve.TypeId == "Part::GeomCircle" and one.BoundBox.ZMin > 1)


def wall(obj):
    return named(obj, "Face", lambda one: one.Surface.TypeId == "Part::GeomCylinder")


def settings(path):
    return path.Proxy.task(path).settings.passes


def test_links_say_centre_and_axis_about_the_work_zero_and_follow_the_solid(doc, disc, reopen):
    picked = {"pass_centre": (disc, rim(disc)), "pass_axis": (disc, wall(disc))}
    path = app.create_toolpath(doc, disc, picked=picked, **GIVEN)
    assert settings(path).pass_centre == (19.0, 8.0, 2.0) and guides.links_of(path) == picked
    typed = app.create_toolpath(doc, disc, pass_centre="19,8,2", pass_axis=settings(path).pass_axis, **GIVEN)
    assert results.nc_of(typed) == results.nc_of(path) and not guides.links_of(typed)
    disc.Placement = FreeCAD.Placement(FreeCAD.Vector(5, 0, 0), FreeCAD.Rotation())
    assert results.out_of_date(path)
    doc.recompute()
    assert settings(path).pass_centre == (24.0, 8.0, 2.0) and not results.out_of_date(path)
    name, edge = path.Name, rim(disc)
    again = reopen(doc)
    path = again.getObject(name)
    assert guides.links_of(path)["pass_centre"] == (again.Disc, edge) and settings(path).pass_centre == (24.0, 8.0, 2.0)


def test_a_name_that_is_gone_and_a_wrong_one_are_told(doc, disc):
    path = app.create_toolpath(doc, disc, picked={"pass_centre": (disc, rim(disc))}, **GIVEN)
    disc.Shape = Part.makeSphere(12)
    doc.recompute()
    assert results.out_of_date(path) and path.Findings, "the edge of that name is another one now, or none"
    with pytest.raises(SelectionError, match="which was picked: pick pass-centre anew"):
        guides.options_of({"pass_centre": (disc, "Edge9")}, (0, 0, 0))
    for option, name, said in (
        ("pass_centre", "Edge9", "has no Edge9"),
        ("pass_axis", "Vertex1", "has no axis"),
        ("pass_axis", "Face1", "has no axis"),
    ):
        with pytest.raises(SelectionError, match=said):
            guides.options_of({option: (disc, name)}, (0, 0, 0))
    assert guides.options_of({"pass_centre": (disc, "Face1")}, (0, 0, 0)) == {"pass_centre": "0,0,0"}


def test_of_a_straight_edge_the_axis_runs_along_it_also_in_a_moved_part(doc):
    part, box = doc.addObject("App::Part", "Held"), doc.addObject("Part::Box", "Box")
    part.addObject(box)
    part.Placement = FreeCAD.Placement(FreeCAD.Vector(7, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
    doc.recompute()
    for at, edge in enumerate(box.Shape.Edges):
        along = guides.options_of({"pass_axis": (box, f"Edge{at + 1}")}, (0, 0, 0))["pass_axis"]
        own = part.Placement.Rotation.multVec(edge.Vertexes[-1].Point - edge.Vertexes[0].Point).normalize()
        assert tuple(own.cross(FreeCAD.Vector(*along))) == pytest.approx((0, 0, 0), abs=1e-9)
        assert along[::-1] > (0, 0, 0) and FreeCAD.Vector(*along).Length == pytest.approx(1)
    corner = guides.options_of({"pass_centre": (box, "Vertex1")}, (0, 0, 0))["pass_centre"]
    own = part.Placement.multVec(box.Shape.Vertexes[0].Point)
    assert [float(at) for at in corner.split(",")] == pytest.approx(list(own), abs=1e-9)


def test_a_vertex_is_where_scallop_passes_begin_and_where_morphing_ones_end(doc, disc):
    given = {
        **GIVEN,
        "passes": "scallop",
        "scallop": 0.2,
        "stepover": None,
        "faces": [named(disc, "Face", lambda one: one.CenterOfMass.z > 4.9)],
    }
    corner = next(at for at, one in enumerate(disc.Shape.Vertexes) if one.Z > 4)
    place = disc.Shape.Vertexes[corner].Point - FreeCAD.Vector(*GIVEN["work_zero"])
    path = app.create_toolpath(doc, disc, picked={"from_": (disc, f"Vertex{corner + 1}")}, **given)
    typed = app.create_toolpath(doc, disc, from_=",".join(f"{at:.12g}" for at in place), **given)
    border = app.create_toolpath(doc, disc, **given)
    assert results.nc_of(path) == results.nc_of(typed) != results.nc_of(border)
    assert settings(path).from_ == pytest.approx(tuple(place))
    with pytest.raises(SelectionError, match="is no vertex: pick a vertex, or name a CSV file of a curve"):
        guides.options_of({"to": (disc, rim(disc))}, (0, 0, 0))


def test_other_settings_leave_the_links_unless_they_are_given(doc, disc):
    path = app.create_toolpath(doc, disc, picked={"pass_centre": (disc, rim(disc))}, **GIVEN)
    options = convert.options_of(path, "mill") | {"stepover": 3}
    changes.change_toolpath(path, options)
    assert guides.links_of(path)
    changes.change_toolpath(path, {**options, "picked": {}})
    assert not guides.links_of(path)
