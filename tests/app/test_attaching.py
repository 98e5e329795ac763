# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is selected becomes a surface where it stands in the document: in parts, through links, of several
documents."""

import FreeCAD
import Mesh
import numpy as np
import pytest

from freecad_fiveaxis.app import attaching
from freecad_fiveaxis.app.attaching import Chosen
from freecad_fiveaxis.core.base.errors import FiveAxisError

Vector = FreeCAD.Vector


@pytest.fixture
def held(doc):
    """A box 10 mm and a mesh 1 x 2 x 3 mm in a part that is turned and moved, and a link to that."""
    part, box, mesh = (doc.addObject(kind, name) for kind, name in
                       (("App::Part", "Holder"), ("Part::Box", "Block"), ("Mesh::Feature", "Net")))  # fmt: skip
    part.Placement = FreeCAD.Placement(Vector(100, 0, 0), FreeCAD.Rotation(Vector(0, 0, 1), 90))
    box.Placement.Base = Vector(0, 10, 0)
    mesh.Mesh = Mesh.createBox(1, 2, 3)  # about its middle
    mesh.Placement.Base = Vector(0, 0, 7)
    part.addObjects([box, mesh])
    link = doc.addObject("App::Link", "Copy")
    link.LinkedObject = part
    link.Placement.Base = Vector(0, 0, 1000)
    doc.recompute()
    return part, box, mesh, link


def box_of(chosen, zero=(0.0, 0.0, 0.0)):
    (found,) = attaching.surfaces(attaching.paths(chosen), zero)
    return [tuple(np.round(one, 4)) for one in found.mesh.box]


BLOCK, NET = [(80.0, 0.0, 0.0), (90.0, 10.0, 10.0)], [(99.0, -0.5, 5.5), (101.0, 0.5, 8.5)]
"""Turned by 90 deg and moved by 100 mm along X."""


def test_a_solid_and_a_mesh_stand_where_the_part_that_holds_them_has_them(held):
    part, box, mesh, _ = held
    assert box_of([(box, ())]) == BLOCK and box_of([(part, ("Block.Face1", "Block.Face3"))]) == BLOCK
    assert box_of([(mesh, ())]) == NET and box_of([(part, ("Net.",))]) == NET
    assert box_of([(part, ())]) == [(80.0, -0.5, 0.0), (101.0, 10.0, 10.0)], "all that it holds"
    assert box_of([(box, ())], (80.0, 0.0, 4.0)) == [(0.0, 0.0, -4.0), (10.0, 10.0, 6.0)]


def test_what_a_link_shows_stands_where_the_link_does(held):
    link = held[3]
    assert box_of([(link, ("Block.Face1",))]) == [(0.0, 10.0, 1000.0), (10.0, 20.0, 1010.0)], (
        "it has no place of the part's"
    )
    assert box_of([(link, ("Net.",))]) == [(-0.5, -1.0, 1005.5), (0.5, 1.0, 1008.5)]
    assert box_of([(link, ())]) == [(-0.5, -1.0, 1000.0), (10.0, 20.0, 1010.0)]


def test_a_link_in_a_part_stands_where_that_does_by_its_path_and_by_itself(held, doc):
    part, box = held[:2]
    inner = doc.addObject("App::Link", "Inner")
    inner.LinkedObject, inner.LinkTransform = box, False
    inner.Placement.Base = Vector(0, 0, 50)
    part.addObject(inner)
    doc.recompute()
    expected = [(90.0, 0.0, 50.0), (100.0, 10.0, 60.0)]
    assert box_of([(part, ("Inner.Face2",))]) == expected and box_of([(inner, ())]) == expected


def test_hidden_things_of_a_part_do_not_count(held):
    part, mesh = held[0], held[2]
    mesh.Visibility = False
    assert box_of([(part, ())]) == BLOCK
    assert box_of([(mesh, ())]) == NET, "but where they are meant"


def test_each_is_chosen_once_and_a_body_stands_for_its_features(doc):
    body = doc.addObject("PartDesign::Body", "Body")
    pad = doc.addObject("PartDesign::AdditiveBox", "Pad")
    body.addObject(pad)
    doc.recompute()
    assert attaching.paths([(body, ("Pad.Face1", "Pad.Face2")), (body, ())]) == [Chosen(body)]
    assert box_of([(body, ("Pad.Face1",))]) == [(0.0, 0.0, 0.0), (10.0, 10.0, 10.0)]


def test_facets_lie_within_the_deviation_that_is_requested(doc):
    ball = doc.addObject("Part::Sphere", "Ball")
    ball.Radius = 50
    doc.recompute()
    counts = []
    for linear in (0.1, 2.0):
        (found,) = attaching.surfaces([Chosen(ball)], (0, 0, 0), linear)
        middle = found.mesh.vertex[found.mesh.face].mean(axis=1)
        assert 0.0 < 50.0 - np.linalg.norm(middle, axis=1).min() < 1.5 * linear
        counts.append(len(found.mesh.face))
    assert counts[0] > counts[1]


def test_what_has_no_surface_is_named_with_the_remedy(held, doc):
    sketch, empty = doc.addObject("Sketcher::SketchObject", "Drawing"), doc.addObject("App::Part", "Empty")
    doc.recompute()
    for one in (sketch, empty):
        with pytest.raises(FiveAxisError, match=f"{one.Label} .* holds neither a solid nor a mesh: select"):
            attaching.surfaces([Chosen(held[1]), Chosen(one)], (0, 0, 0))
    with pytest.raises(FiveAxisError, match="0 mm is not above 0"):
        attaching.surfaces([Chosen(held[1])], (0, 0, 0), 0.0)
