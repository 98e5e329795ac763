# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures of a tool path: solids of the document, which the path goes around; what changes them makes it out
of date."""

import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import changes, results
from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.gouge.fixtures import Fixture, check_fixtures
from freecad_fiveaxis.core.pipeline.options import tip_to_driven, tool_body

GIVEN = {
    "machine": "trunnion_ac",
    "cutter": "ball:6",
    "passes": "planes",
    "stepover": 2,
    "max_axis_angle": 30,
    "tool_length": 120,
}

pytestmark = pytest.mark.usefixtures("kept")


def solid(doc, name, low, size):
    one = doc.addObject("Part::Box", name)
    one.Length, one.Width, one.Height = size
    one.Placement.Base = low
    return one


@pytest.fixture
def plate(doc):
    import FreeCAD

    result = (
        solid(doc, "Plate", FreeCAD.Vector(0, 0, 0), (30, 20, 10)),
        solid(doc, "Clamp", FreeCAD.Vector(10, -8, 0), (10, 7, 25)),
    )
    doc.recompute()
    return result


def hits(path, low, size):
    """What the path's program enters of a box."""
    from freecad_fiveaxis.core.geometry.mesh import from_faces

    corner = [
        (low[0] + i * size[0], low[1] + j * size[1], low[2] + k * size[2])
        for i in (0, 1)
        for j in (0, 1)
        for k in (0, 1)
    ]
    face = [
        (0, 1, 3),
        (0, 3, 2),
        (4, 6, 7),
        (4, 7, 5),
        (0, 4, 5),
        (0, 5, 1),
        (2, 3, 7),
        (2, 7, 6),
        (0, 2, 6),
        (0, 6, 4),
        (1, 5, 7),
        (1, 7, 3),
    ]
    result = results.result_of(path).draft
    fixture = Fixture("box", from_faces(corner, face))
    return check_fixtures(
        (fixture,),
        tool_body(result.settings),
        result.kinematics,
        result.program,
        0.01,
        tip_to_driven(result.settings),
    )


def test_a_path_goes_around_a_solid_that_holds_the_part_and_says_so(doc, plate):
    part, clamp = plate
    bare = app.create_toolpath(doc, part, **GIVEN)
    assert hits(bare, (10, -8, 0), (10, 7, 25))
    path = app.create_toolpath(doc, part, fixtures=[clamp], **GIVEN)
    assert path.Fixtures == [clamp] and not results.out_of_date(path)
    assert not hits(path, (10, -8, 0), (10, 7, 25))
    assert results.figures_of(path).fixtures == ("Clamp",)


def test_a_fixture_that_moves_or_is_taken_away_makes_the_path_another(doc, plate):
    part, clamp = plate
    path = app.create_toolpath(doc, part, fixtures=[clamp], **GIVEN)
    before = results.nc_of(path)
    clamp.Placement.Base.y = -30
    assert "Clamp was changed" in results.out_of_date(path)
    doc.recompute()
    far = results.nc_of(path)
    assert not results.out_of_date(path) and far != before
    clamp.Placement.Base.y = -8
    doc.recompute()
    assert results.nc_of(path) == before
    changes.change_toolpath(path, GIVEN)
    assert path.Fixtures == [clamp], "what is not named stays"
    changes.change_toolpath(path, {**GIVEN, "fixtures": []})
    assert not path.Fixtures and results.nc_of(path) != before


def test_where_the_work_zero_is_elsewhere_the_fixture_goes_with_the_part(doc, plate):
    part, clamp = plate
    path = app.create_toolpath(doc, part, fixtures=[clamp], work_zero=(15, 10, 10), **GIVEN)
    assert not hits(path, (-5, -18, -10), (10, 7, 25))
    assert hits(app.create_toolpath(doc, part, work_zero=(15, 10, 10), **GIVEN), (-5, -18, -10), (10, 7, 25))


def test_the_part_itself_and_what_is_no_solid_are_no_fixtures(doc, plate):
    part, _ = plate
    many = len(doc.Objects)
    with pytest.raises(FiveAxisError, match="is the part that is milled"):
        app.create_toolpath(doc, part, fixtures=[part], **GIVEN)
    with pytest.raises(FiveAxisError):
        app.create_toolpath(doc, part, fixtures=[doc.addObject("App::FeaturePython", "Note")], **GIVEN)
    assert len(doc.Objects) == many + 1


def test_fixtures_are_kept_in_the_file_of_the_document(doc, plate, reopen, anew):
    part, clamp = plate
    path = app.create_toolpath(doc, part, fixtures=[clamp], **GIVEN)
    nc, name = results.nc_of(path), path.Name
    again = reopen(doc).getObject(name)
    anew()
    assert [one.Label for one in again.Fixtures] == ["Clamp"]
    assert not results.out_of_date(again) and results.nc_of(again) == nc
