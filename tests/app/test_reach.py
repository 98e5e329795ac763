# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reach map on the document side: the numbers of the command line, areas in closed form, and it follows
its part."""

import json
import math

import FreeCAD
import numpy as np
import Part
import pytest

from freecad_fiveaxis import app
from freecad_fiveaxis.app import reach, results
from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError
from freecad_fiveaxis.core.gouge.obstacles import Obstacle
from freecad_fiveaxis.core.studies import reach_map as module

TOOL = {"machine": "trunnion_ac", "cutter": "ball:6:20", "holder": "40x30", "tolerance": 0.02}

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture(autouse=True)
def coarse(monkeypatch):
    monkeypatch.setattr(module, "PLACES", 80)


def slot_shape(length=160.0):
    """A block 60 mm wide and 40 high with a slot 14 wide and 30 deep down its middle, open at both ends."""
    profile = [(-30, 0), (30, 0), (30, 40), (7, 40), (7, 10), (-7, 10), (-7, 40), (-30, 40), (-30, 0)]
    return Part.Face(Part.makePolygon([(x, 0, z) for x, z in profile])).extrude(FreeCAD.Vector(0, length, 0))


@pytest.fixture
def slot(doc):
    obj = doc.addObject("Part::Feature", "Slot")
    obj.Shape = slot_shape()
    doc.recompute()
    return obj


def floor(obj):
    """The object, and the name of its face at z = 10, the slot's floor."""
    (name,) = [
        f"Face{at}" for at, face in enumerate(obj.Shape.Faces, 1) if abs(face.CenterOfMass.z - 10.0) < 1e-6
    ]
    return obj, [name]


def test_the_holder_keeps_the_tool_from_the_floor_of_a_slot_that_is_narrower_than_it(doc, slot):
    """A tool that sticks out 20 mm does not get to the floor 30 mm deep below a holder of 40 mm, save beside
    the open ends, where it leans out; and near the walls not even the ball does."""
    result = app.reach_map(floor(slot), **TOOL)
    whole = 14.0 * 160.0
    assert result.WholeArea.Value == pytest.approx(whole)
    held, tight = result.HolderInTheWay.Value, result.TighterThanCutter.Value
    ends = 2 * 14.0 * 25.0
    assert whole - ends - 2 * 3.5 * 160.0 < held <= whole - 2 * 2.0 * 160.0 + 1.0
    assert tight == pytest.approx(
        2 * 3.0 * 160.0, rel=0.4
    ) and result.ReachableArea.Value + held + tight == pytest.approx(whole)
    assert result.StickOut.Value == 30.0 - 20.0 and result.StickOutArea.Value >= reach.ENOUGH * held
    assert "stick out 10 mm farther and it reaches" in result.Advice and "mm²" in result.Advice
    assert "holder in the way" in result.Verdict and result.ReachableShare == pytest.approx(
        100 * result.ReachableArea.Value / whole
    )
    assert result.State == ["Up-to-date"] and result.UpToDate and not reach.out_of_date(result)


def test_the_stick_out_that_is_named_frees_nine_tenths_of_what_the_holder_held(slot):
    result = app.reach_map(floor(slot), **TOOL)
    held = result.HolderInTheWay.Value
    longer = app.reach_map(result.Mesh, **TOOL, shank=f"6x{result.StickOut.Value}")
    assert longer.HolderInTheWay.Value <= (1.0 - reach.ENOUGH) * held + 1.0
    shorter = app.reach_map(result.Mesh, **TOOL, shank="6x5")
    assert shorter.HolderInTheWay.Value > (1.0 - reach.ENOUGH) * held


@pytest.mark.thorough
def test_the_numbers_are_those_of_the_command_line(slot, tmp_path):
    file, report = tmp_path / "slot.stl", tmp_path / "reach.json"
    mesh = app.tessellate(slot, file)
    result = app.reach_map(mesh, **TOOL)
    assert cli.main(["reach", str(file), "--machine", "trunnion_ac", "--cutter", "ball:6:20", "--holder", "40x30", "--tolerance",
                     "0.02", "--report", str(report), "--quiet"]) == 0  # fmt: skip
    reported = json.loads(report.read_text(encoding="utf-8"))["summary"]
    assert (
        result.WholeArea.Value == reported["area"]
        and result.ReachableArea.Value == reported["reachable_area"]
    )
    assert result.ReachableShare == pytest.approx(100.0 * reported["reachable_share"], rel=1e-12)
    keys = {"TighterThanCutter": "tighter_than_cutter", "BeyondMachine": "beyond_machine", "BelowTable": "below_table",
            "ShankInTheWay": "shank", "HolderInTheWay": "holder"}  # fmt: skip
    assert {name: getattr(result, name).Value for name in keys} == {
        name: reported["by_reason"][key] for name, key in keys.items()
    }
    assert {"longer": result.StickOut.Value, "area": result.StickOutArea.Value} in reported["stick_out"]
    other = app.reach_map(mesh, **{**TOOL, "cutter": "ball:6:30"})
    assert other.HolderInTheWay.Value != reported["by_reason"]["holder"], "another tool has other numbers"


def test_a_toolpath_gives_its_machine_tool_part_and_fixtures(doc, slot):
    clamp = doc.addObject("Part::Box", "Clamp")
    clamp.Length, clamp.Width, clamp.Height = 14, 20, 25
    clamp.Placement.Base = FreeCAD.Vector(-7, 70, 10)
    doc.recompute()
    settings = {"machine": "trunnion_bc", "cutter": "ball:6:60", "holder": "30x30", "work_zero": (1, 2, 3)}
    path = app.create_toolpath(
        doc, floor(slot), **settings, passes="planes", stepover=6, gouge="off", linearize="off"
    )
    free = app.reach_map(path)
    assert (free.Machine, free.Holder, free.CutterLength.Value, tuple(free.WorkZero)) == (
        "trunnion_bc",
        "30x30",
        60,
        (1, 2, 3),
    )
    assert free.Mesh is path.Mesh and free.WholeArea.Value == pytest.approx(14.0 * 160.0)
    path.Fixtures = [clamp]
    held = app.reach_map(path)
    assert held.Fixtures == [clamp]
    lost = free.ReachableArea.Value - held.ReachableArea.Value
    assert lost >= 8.0 * 20.0, "the floor below the clamp, but for what is beside the walls"
    assert held.FixtureInTheWay.Value == pytest.approx(lost) and free.FixtureInTheWay.Value == 0.0
    assert "Without the fixture Clamp the tool reaches about" in held.Advice
    assert "holder, fixture or machine" in held.Advice and "fixture" not in free.Advice


def test_a_fixture_that_stands_in_the_part_is_refused_and_nothing_is_computed(doc, slot):
    names = [one.Name for one in doc.Objects]
    pin = doc.addObject("Part::Box", "Pin")
    pin.Placement.Base = FreeCAD.Vector(10, 70, 5)
    doc.recompute()
    with pytest.raises(FiveAxisError, match="Pin stands in the part"):
        app.reach_map(floor(slot), **TOOL, fixtures=[pin])
    assert [one.Name for one in doc.Objects] == [*names, "Pin"]


def test_an_axis_that_may_lean_less_reaches_less(slot):
    sides = [
        f"Face{at}"
        for at, face in enumerate(slot.Shape.Faces, 1)
        if abs(abs(face.CenterOfMass.x) - 30.0) < 1e-6
    ]
    mesh = app.tessellate(slot, faces=sides)
    tool = {"machine": "trunnion_ac", "cutter": "ball:6:60", "table_height": -1000}
    assert app.reach_map(mesh, **tool).ReachableShare > 99.0
    upright = app.reach_map(mesh, **tool, largest_axis_angle=5)
    assert upright.ReachableArea.Value == 0.0 and upright.BeyondMachine.Value == pytest.approx(
        2 * 40.0 * 160.0
    )
    found = reach.find_map(app.reach_map(mesh, **tool, largest_axis_angle=60))
    _, axis = reach.axis_field(found)
    assert len(axis) and (axis[:, 2] >= math.cos(math.radians(60.0)) - 1e-9).all()
    for wrong in (0, 200):
        with pytest.raises(FiveAxisError, match="largest axis angle"):
            app.reach_map(mesh, **tool, largest_axis_angle=wrong)


def test_the_map_follows_its_part_and_says_when_it_is_old(doc, slot):
    result = app.reach_map(slot, **TOOL)
    before = result.HolderInTheWay.Value
    result.Holder = ""
    assert "recompute" in reach.out_of_date(result)
    doc.recompute()
    assert (
        not reach.out_of_date(result)
        and result.HolderInTheWay.Value == 0.0 < before
        and "stick out" not in result.Advice
    )
    slot.Shape = slot_shape(80.0)
    doc.recompute()
    assert result.UpToDate and result.WholeArea.Value == pytest.approx(slot.Shape.Area, rel=1e-5)


@pytest.mark.thorough
def test_a_reopened_map_keeps_its_numbers_and_finds_its_places_when_requested(slot, reopen, anew):
    result = app.reach_map(floor(slot), **TOOL, work_zero=(1, 2, 3), largest_axis_angle=120)
    kept = {
        name: result.getPropertyByName(name)
        for name in ("Verdict", "Advice", "UpToDate", "Fingerprint", "LargestAxisAngle")
    }
    areas = {name: getattr(result, name).Value for name in reach.AREAS.values()}
    places = reach.find_map(result).chart.obstacle
    anew()
    result = reopen(slot.Document).ReachMap
    assert result.Proxy.last is None and {name: result.getPropertyByName(name) for name in kept} == kept
    assert {name: getattr(result, name).Value for name in areas} == pytest.approx(areas, rel=1e-12)
    assert reach.out_of_date(result) == ""
    np.testing.assert_array_equal(reach.find_map(result).chart.obstacle, places)


def test_a_deleted_solid_and_a_deleted_mesh_are_reported(doc, slot):
    result = app.reach_map(floor(slot), **TOOL)
    doc.removeObject("Slot")
    assert "was deleted" in reach.out_of_date(result)
    doc.recompute()
    assert not result.UpToDate or "Invalid" in result.Mesh.State
    doc.removeObject(result.Mesh.Name)
    doc.recompute()
    assert "Invalid" in result.State and "was deleted" in result.getStatusString() and not result.UpToDate


def test_what_cannot_be_leaves_nothing_behind(anew, doc, slot):
    names = [one.Name for one in doc.Objects]
    wrong = (
        {"cutter": "ball:-6"},
        {"machine": "no_such"},
        {"wings": 2},
        {"fixtures": [slot]},
        {"holder": "40"},
    )
    for settings in wrong:
        with pytest.raises(FiveAxisError):
            app.reach_map(slot, **{**TOOL, **settings})
        assert [one.Name for one in doc.Objects] == names, settings
    for nothing in (None, "Slot", doc.addObject("App::FeaturePython", "Other")):
        with pytest.raises(FiveAxisError, match="select a solid"):
            app.reach_map(nothing, **TOOL)
    doc.removeObject("Other")

    def stop(stage, fraction):
        if stage == "reach":
            raise Cancelled("stopped")

    from freecad_fiveaxis.app.long_work import reporting

    with pytest.raises(Cancelled), reporting(stop):
        app.reach_map(slot, **TOOL)
    assert [one.Name for one in doc.Objects] == names


def test_the_places_of_the_picture_are_those_of_the_map(slot):
    from freecad_fiveaxis.core.gouge.rest_material import surface_parts

    found = reach.find_map(app.reach_map(floor(slot), **TOOL))
    corner, _ = surface_parts(found.mesh, found.chart.spacing, reach.find_chosen_facets(found))
    np.testing.assert_allclose(corner.mean(axis=1), found.chart.point)
    held = found.chart.point[found.chart.obstacle == Obstacle.HOLDER]
    assert np.isclose(held[:, 2], 10.0).all() and (np.abs(held[:, 0]) < 7.0 - 2.0).all()
    assert results.out_of_date(found and slot.Document.ReachMap) == ""


@pytest.mark.thorough
def test_of_a_tool_path_other_faces_are_chosen_on_its_part(doc, slot):
    path = app.create_toolpath(
        doc,
        floor(slot),
        passes="planes",
        stepover=6,
        linear_deflection=0.1,
        gouge="off",
        linearize="off",
        **TOOL,
    )
    as_it_is = app.reach_map(path)
    assert as_it_is.Mesh is path.Mesh and as_it_is.WholeArea.Value == pytest.approx(14.0 * 160.0)
    (top,) = [f"Face{at}" for at, face in enumerate(slot.Shape.Faces, 1) if abs(face.CenterOfMass.y) < 1e-6]
    other = app.reach_map(path, faces=[top])
    assert other.WholeArea.Value == pytest.approx(slot.Shape.Faces[int(top[4:]) - 1].Area)
    assert other.Mesh is not path.Mesh and other.Mesh.Base[0] is slot and other.Holder == "40x30"
    assert other.Mesh.LinearDeflection.Value == pytest.approx(0.1)
    before = [one.Name for one in doc.Objects]
    with pytest.raises(FiveAxisError, match="Face99"):
        app.reach_map(path, faces=["Face99"])
    with pytest.raises(FiveAxisError, match="Face99"):
        app.reach_map(path, avoid="Face99")
    assert [one.Name for one in doc.Objects] == before
