# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guides, boundary, centre and axis of passes that are links: they are what the solid says, follow it, and
are missed when they are gone."""

import itertools
import math

import FreeCAD
import Part
import pytest
from conftest import FAST, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import changes, convert, guides, results
from freecad_fiveaxis.app.selection import SelectionError

GIVEN = {
    **FAST,
    **UNCURED,
    "passes": "radial",
    "cutter": "ball:6",
    "max_axis_angle": 40,
    "work_zero": (1.0, 2.0, 3.0),
}


@pytest.fixture
def disc(doc):
    result = doc.addObject("Part::Feature", "Disc")
    result.Shape = Part.makeCylinder(15, 5, FreeCAD.Vector(20, 10, 0))
    doc.recompute()
    return result


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
    assert guides.links_of(path)["pass_centre"] == (again.Disc, edge) and settings(path).pass_centre == (
        24.0,
        8.0,
        2.0,
    )


def test_a_name_that_is_gone_and_a_wrong_one_are_reported(doc, disc):
    path = app.create_toolpath(doc, disc, picked={"pass_centre": (disc, rim(disc))}, **GIVEN)
    disc.Shape = Part.makeSphere(12)
    doc.recompute()
    assert results.out_of_date(path) and path.Findings, "the edge of that name is another one now, or none"
    with pytest.raises(SelectionError, match="which was picked: pick pass-centre anew"):
        guides.options_of({"pass_centre": (disc, "Edge9")}, (0, 0, 0))
    for option, name, message in (
        ("pass_centre", "Edge9", "has no Edge9"),
        ("pass_axis", "Vertex1", "has no axis"),
        ("pass_axis", "Face1", "has no axis"),
    ):
        with pytest.raises(SelectionError, match=message):
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
    with pytest.raises(SelectionError, match="is no vertex or edge: pick one, or name a CSV file of a curve"):
        guides.options_of({"to": (disc, wall(disc))}, (0, 0, 0))


def test_other_settings_leave_the_links_unless_they_are_given(doc, disc):
    path = app.create_toolpath(doc, disc, picked={"pass_centre": (disc, rim(disc))}, **GIVEN)
    options = convert.options_of(path, "mill") | {"stepover": 3}
    changes.change_toolpath(path, options)
    assert guides.links_of(path)
    changes.change_toolpath(path, {**options, "picked": {}})
    assert not guides.links_of(path)


def points(text):
    """The points of each curve of an option's text."""
    return [[tuple(map(float, point.split(","))) for point in curve.split(";")] for curve in text.split(";;")]


def length(curve):
    return sum(math.dist(one, other) for one, other in itertools.pairwise(curve))


def edge_at(obj, *middle):
    rows = [one.CenterOfMass.distanceToPoint(FreeCAD.Vector(*middle)) < 1e-6 for one in obj.Shape.Edges]
    return f"Edge{rows.index(True) + 1}"


def face_at(obj, z):
    rows = [abs(one.BoundBox.ZMin - z) + abs(one.BoundBox.ZMax - z) < 1e-6 for one in obj.Shape.Faces]
    return f"Face{rows.index(True) + 1}"


@pytest.fixture
def pocketed(doc):
    """40 x 30 x 10 mm with upright edges rounded by 5 mm and a hole of 4 mm radius in its middle."""
    result = doc.addObject("Part::Feature", "Pocketed")
    block = Part.makeBox(40, 30, 10)
    block = block.makeFillet(5, [one for one in block.Edges if abs(one.tangentAt(0).z) > 0.9])
    result.Shape = block.cut(Part.makeCylinder(4, 10, FreeCAD.Vector(20, 15, 0)))
    doc.recompute()
    return result


def test_edges_lead_morphing_passes_as_their_points_do(doc):
    block = doc.addObject("Part::Feature", "Block")
    block.Shape = Part.makeBox(20, 10, 5)
    doc.recompute()
    given = {**GIVEN, "passes": "morph", "stepover": None, "scallop": 0.2, "faces": [face_at(block, 5)]}
    picked = {"from_": (block, edge_at(block, 10, 0, 5)), "to": (block, edge_at(block, 10, 10, 5))}
    path = app.create_toolpath(doc, block, picked=picked, **given)
    assert settings(path).from_ in ("-1,-2,2;19,-2,2", "19,-2,2;-1,-2,2"), settings(path).from_
    typed = app.create_toolpath(doc, block, from_="-1,-2,2;19,-2,2", to="-1,8,2;19,8,2", **given)
    across = app.create_toolpath(doc, block, from_="-1,-2,2;-1,8,2", to="19,-2,2;19,8,2", **given)
    assert results.nc_of(path) == results.nc_of(typed) != results.nc_of(across)
    block.Shape = Part.makeBox(30, 10, 5)
    doc.recompute()
    assert "29,-2,2" in settings(path).from_ and not results.out_of_date(path)


def test_an_edge_goes_on_smoothly_round_the_part_and_stops_at_corners(doc, pocketed):
    (outline,) = points(
        guides.options_of({"from_": (pocketed, edge_at(pocketed, 20, 0, 10))}, (0, 0, 0))["from_"]
    )
    assert outline[0] == pytest.approx(outline[-1]) and len(set(outline)) >= len(outline) - 1
    assert length(outline) == pytest.approx(2 * (30 + 20) + 2 * math.pi * 5, rel=1e-3)
    assert max(math.dist(*pair) for pair in itertools.pairwise(outline)) == pytest.approx(30)
    (hole,) = points(guides.options_of({"to": (pocketed, edge_at(pocketed, 20, 15, 10))}, (20, 15, 0))["to"])
    assert length(hole) == pytest.approx(2 * math.pi * 4, rel=1e-3) and all(
        math.hypot(x, y) == pytest.approx(4) for x, y, _ in hole
    )
    box = doc.addObject("Part::Box", "Box")
    doc.recompute()
    assert len(points(guides.options_of({"from_": (box, "Edge1")}, (0, 0, 0))["from_"])[0]) == 2


def test_a_face_bounds_the_passes_with_its_hole_and_an_edge_with_its_wire(doc, pocketed):
    outline, hole = points(
        guides.options_of({"boundary": (pocketed, face_at(pocketed, 10))}, (0, 0, 0))["boundary"]
    )
    assert length(outline) == pytest.approx(100 + 10 * math.pi, rel=1e-3) and length(hole) == pytest.approx(
        8 * math.pi, rel=1e-3
    )
    assert outline[0] == pytest.approx(outline[-1]) and hole[0] == pytest.approx(hole[-1])
    (alone,) = points(
        guides.options_of({"boundary": (pocketed, edge_at(pocketed, 20, 0, 10))}, (0, 0, 0))["boundary"]
    )
    assert length(alone) == pytest.approx(length(outline)) and all(z == pytest.approx(10) for *_, z in alone)
    sketch = doc.addObject("Part::Feature", "Drawn")
    corners = [
        FreeCAD.Vector(*at) for at in ((10, 5, 10), (30, 5, 10), (30, 25, 10), (10, 25, 10), (10, 5, 10))
    ]
    sketch.Shape = Part.makePolygon(corners)
    doc.recompute()
    link = {"boundary": (sketch, "Edge3")}
    given = {**GIVEN, "passes": "planes", "stepover": 1.0}
    path = app.create_toolpath(doc, pocketed, picked=link, **given)
    typed = app.create_toolpath(doc, pocketed, boundary="9,3,7;29,3,7;29,23,7;9,23,7;9,3,7", **given)
    free = app.create_toolpath(doc, pocketed, **given)
    assert results.nc_of(path) == results.nc_of(typed) != results.nc_of(free)
    sketch.Placement.Base = FreeCAD.Vector(0, 2, 0)
    doc.recompute()
    assert results.nc_of(path) != results.nc_of(typed) and guides.links_of(path) == link
    for name in ("Vertex1", "Edge9"):
        with pytest.raises(
            SelectionError, match="bounds nothing: pick a face" if name == "Vertex1" else "has no Edge9"
        ):
            guides.options_of({"boundary": (sketch, name)}, (0, 0, 0))


def test_a_guide_curve_in_a_file_that_has_changed_makes_the_path_out_of_date(doc, disc, tmp_path):
    curve = tmp_path / "curve.csv"
    given = {
        **GIVEN,
        "passes": "scallop",
        "scallop": 0.2,
        "stepover": None,
        "faces": [face_at(disc, 5)],
        "from_": str(curve),
    }
    given["work_zero"] = (20.0, 10.0, 3.0)
    curve.write_text("-10,0,2\n10,0,2\n")
    path = app.create_toolpath(doc, disc, **given)
    nc = results.nc_of(path)
    assert not results.out_of_date(path)
    curve.write_text("0,-10,2\n0,10,2\n")
    path.touch()
    doc.recompute()
    assert results.nc_of(path) != nc
