# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces that are left alone: no contact of the program lies on them, by dense samples of it; what is kept of
them, and what is said where they cannot be used."""

import FreeCAD
import numpy as np
import Part
import pytest
from conftest import PLAIN

from freecad_fiveaxis import app
from freecad_fiveaxis.app import changes, convert, previewing, results, selection, tessellation
from freecad_fiveaxis.app.scaling import scale_part
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.core.base.errors import FiveAxisError
from freecad_fiveaxis.core.toolpath.cl_path import Motion

GIVEN = {"machine": "trunnion_ac", "cutter": "ball:4", "stepover": 1.5, "max_axis_angle": 30, **PLAIN}
RADIUS, WIDE = 2.0, 20.0

pytestmark = pytest.mark.usefixtures("kept")


def face_at(obj, **middle):
    """The name of the face with that middle, as ``z=5``."""
    for at, face in enumerate(obj.Shape.Faces):
        if all(abs(getattr(face.CenterOfMass, axis) - value) < 1e-6 for axis, value in middle.items()):
            return f"Face{at + 1}"
    raise AssertionError(middle)


@pytest.fixture
def step(doc):
    """Two floors side by side: z = 10 up to x = 10, z = 5 beyond it."""
    result = doc.addObject("Part::Feature", "Step")
    low, high = Part.makeBox(20, WIDE, 5), Part.makeBox(10, WIDE, 10)
    result.Shape = low.fuse(high).removeSplitter().Solids[0]
    doc.recompute()
    return result


def contacts(path):
    """Where the ball's lowest point goes, sampled along every feed block, cuts and links, two hundred times:
    mm, document."""
    result = results.result_of(path).draft.path
    begin = np.flatnonzero(result.motion[1:] != Motion.RAPID)
    end = begin + 1
    share = np.linspace(0.0, 1.0, 201)[:, None, None]
    tip = (result.tip[begin] * (1 - share) + result.tip[end] * share).reshape(-1, 3)
    axis = (result.axis[begin] * (1 - share) + result.axis[end] * share).reshape(-1, 3)
    centre = tip + RADIUS * axis / np.linalg.norm(axis, axis=1, keepdims=True)
    return centre - (0.0, 0.0, RADIUS) + np.array(tuple(path.WorkZero))  # all floors are level


def on(contact, obj, name):
    """How many of the contacts lie on a level face, by its box."""
    box = obj.Shape.getElement(name).BoundBox
    level = np.abs(contact[:, 2] - box.ZMax) < 0.05
    return int((level & (contact[:, 0] > box.XMin + 0.05) & (contact[:, 0] < box.XMax - 0.05)).sum())


def test_no_contact_lies_on_a_face_that_is_left_alone(doc, step):
    low, high = face_at(step, z=5, x=15), face_at(step, z=10)
    whole = app.create_toolpath(doc, step, **GIVEN)
    some = app.create_toolpath(doc, step, avoid=[low], **GIVEN)
    before, after = contacts(whole), contacts(some)
    assert on(before, step, low) > 1000, "without it the face is milled, and the count can fail"
    assert on(after, step, low) == 0 and on(after, step, high) > 0.8 * on(before, step, high)
    assert results.nc_of(some) != results.nc_of(whole)
    assert results.result_of(some).draft.keep.sum() < results.result_of(whole).draft.keep.sum()
    other = app.create_toolpath(doc, step, avoid=high, **GIVEN)
    assert on(contacts(other), step, high) == 0 < on(contacts(other), step, low)


def test_the_tool_keeps_the_allowance_off_a_face_that_is_left_alone(doc, step):
    low, wall = face_at(step, z=5, x=15), face_at(step, x=10, z=7.5)

    def nearest_on_floor(path):
        there = contacts(path)
        return there[np.abs(there[:, 2] - 5.0) < 0.05, 0].min()

    plain = app.create_toolpath(doc, step, avoid=[wall], **GIVEN)
    path = app.create_toolpath(doc, step, avoid=[wall], avoid_allowance=1, **GIVEN)
    assert nearest_on_floor(plain) < 12.0 + 0.05
    assert 13.0 - 0.02 <= nearest_on_floor(path) < 13.0 + 0.05, "the ball's radius and 1 mm beside the wall"
    assert on(contacts(path), step, low) > 500
    result = results.result_of(path).draft
    assert [
        one.value for one in result.findings if one.code == "near-avoided-faces"
    ] and result.keep_off.some.any()
    changes.change_toolpath(path, {**GIVEN, "avoid": [wall], "avoid_allowance": 2})
    assert 14.0 - 0.02 <= nearest_on_floor(path) < 14.0 + 0.05
    with pytest.raises(FiveAxisError, match="allowance on faces to avoid, and there are none"):
        app.create_toolpath(doc, step, avoid_allowance=1, **GIVEN)


def test_of_chosen_faces_those_left_alone_are_taken_away(doc, step):
    low, high, wall = face_at(step, z=5, x=15), face_at(step, z=10), face_at(step, x=0)
    both = app.tessellate(step, faces=[low, high, wall], avoid=[high])
    alone = app.tessellate(step, faces=[low, wall])
    assert both.FacetRuns == alone.FacetRuns and both.FacetRuns != app.tessellate(step, faces=[low]).FacetRuns
    rest = app.tessellate(step, avoid=[high])
    count = sum(rest.FacetRuns[1::2]) - sum(rest.FacetRuns[::2])
    assert 0 < count < rest.Facets
    stl = convert.stl_bytes(rest)
    mask = convert.facet_mask(stl, convert.mesh_of(stl), rest.FacetRuns)
    corner = np.frombuffer(stl, convert.STL, offset=84)["corner"]
    assert (corner[~mask][..., 2] == 10).all() and not (corner[mask][..., 2] == 10).all(axis=1).any()


def test_where_nothing_is_left_it_is_stated_and_not_taken_for_all(doc, step):
    every = [f"Face{at + 1}" for at in range(len(step.Shape.Faces))]
    for given in ({"avoid": every}, {"faces": [every[0]], "avoid": every[:2]}):
        with pytest.raises(
            SelectionError,
            match=r"All that is to be milled of Step is to be left alone too: take Face1, Face2",
        ):
            app.create_toolpath(doc, step, **given, **GIVEN)
    assert [one.Name for one in doc.Objects] == ["Step"]
    assert app.tessellate(step, avoid=every[1:]).FacetRuns


@pytest.mark.parametrize("avoid", ["Face99", ["Edge1"], ["Face1", 3], 5])
def test_what_is_no_face_is_refused(doc, step, avoid):
    with pytest.raises(FiveAxisError, match=r"which of its faces are not machined|list of names"):
        app.create_toolpath(doc, step, avoid=avoid, **GIVEN)
    assert [one.Name for one in doc.Objects] == ["Step"]


def test_a_mesh_has_no_faces_to_leave_alone(doc, dome, step):
    count = len(doc.Objects)
    with pytest.raises(
        SelectionError, match=r"Dome is a mesh, whose faces have no names: .*--avoid FACES\.stl"
    ):
        app.create_toolpath(doc, dome, avoid=["Face1"], **GIVEN)
    assert len(doc.Objects) == count
    ready = app.tessellate(step)
    with pytest.raises(SelectionError, match="is a mesh, whose faces have no names"):
        app.create_toolpath(doc, ready, avoid=["Face1"], **GIVEN)


def test_it_is_kept_in_the_file_changed_and_taken_back(doc, step, reopen, anew):
    low, high = face_at(step, z=5, x=15), face_at(step, z=10)
    path = app.create_toolpath(doc, step, avoid=[low], **GIVEN)
    nc, name = results.nc_of(path), path.Name
    again = reopen(doc)
    anew()
    path, step = again.getObject(name), again.getObject("Step")
    assert path.Mesh.Avoid == (step, [low]) and not results.out_of_date(path) and results.nc_of(path) == nc
    changes.change_toolpath(path, GIVEN)
    assert tessellation.name_avoided(path.Mesh) == (low,), "what is not named stays"
    again.UndoMode = 1
    again.openTransaction("change")
    changes.change_toolpath(path, {**GIVEN, "avoid": [high]})
    again.commitTransaction()
    assert tessellation.name_avoided(path.Mesh) == (high,) and results.nc_of(path) != nc
    again.undo()
    assert tessellation.name_avoided(path.Mesh) == (low,) and results.nc_of(path) == nc
    changes.change_toolpath(path, {**GIVEN, "avoid": ()})
    assert path.Mesh.Avoid is None and not path.Mesh.FacetRuns and on(contacts(path), step, low)
    with pytest.raises(SelectionError, match="which of its faces"):
        changes.change_toolpath(path, {**GIVEN, "avoid": ["Face77"]})


def test_a_property_changed_by_hand_makes_the_path_another(doc, step):
    low = face_at(step, z=5, x=15)
    path = app.create_toolpath(doc, step, **GIVEN)
    before, result_of = results.nc_of(path), path.Mesh.MadeOf
    path.Mesh.Avoid = (step, [low])
    assert "was changed" in results.out_of_date(path)
    doc.recompute()
    assert not results.out_of_date(path) and results.nc_of(path) != before and path.Mesh.MadeOf != result_of
    path.Mesh.Avoid = None
    doc.recompute()
    assert results.nc_of(path) == before and path.Mesh.MadeOf == result_of


def test_a_face_that_is_gone_is_reported_and_nothing_is_posted_without_it(doc, step, tmp_path):
    last = f"Face{len(step.Shape.Faces)}"
    path = app.create_toolpath(doc, step, avoid=[last], **GIVEN)
    step.Shape = Part.makeBox(20, WIDE, 5)
    doc.recompute()
    gone = rf"Step has no {last} on a solid, which was to be left alone: choose anew"
    assert (
        "Invalid" in path.Mesh.State
        and last in path.Mesh.getStatusString()
        and last in results.out_of_date(path)
    )
    with pytest.raises(SelectionError, match=gone):
        app.post_process(path, tmp_path / "a.ngc")
    assert not (tmp_path / "a.ngc").exists()
    with pytest.raises(SelectionError, match=gone):
        changes.change_toolpath(path, {**GIVEN, "avoid": tessellation.name_avoided(path.Mesh)})
    changes.change_toolpath(path, {**GIVEN, "avoid": []})
    assert not results.out_of_date(path) and app.post_process(path, tmp_path / "a.ngc").UpToDate


def test_faces_of_another_solid_than_the_base_are_reported(doc, step):
    path = app.create_toolpath(doc, step, **GIVEN)
    other = doc.addObject("Part::Box", "Other")
    path.Mesh.Avoid = (other, ["Face1"])
    doc.recompute()
    assert "Face1 to be left alone is of Other: choose faces of Step" in path.Mesh.getStatusString()
    changes.change_toolpath(path, {**GIVEN, "avoid": ["Face1"]})
    assert path.Mesh.Avoid == (step, ["Face1"])


def test_an_older_document_opens_unchanged(doc, step, reopen, anew):
    path = app.create_toolpath(doc, step, **GIVEN)
    nc, name, result_of = results.nc_of(path), path.Name, path.Mesh.MadeOf
    path.Mesh.removeProperty("Avoid")
    doc.recompute()
    again = reopen(doc).getObject(name)
    anew()
    assert again.Mesh.Avoid is None and again.Mesh.MadeOf == result_of and again.Mesh.State == ["Up-to-date"]
    assert not results.out_of_date(again) and results.nc_of(again) == nc
    assert tessellation.hash_inputs(again.Mesh) == result_of


@pytest.mark.parametrize("faces", [(), ("wall", "low", "high")])
def test_an_older_document_finds_its_faces_to_avoid_when_an_allowance_is_requested(
    doc, step, reopen, faces, anew
):
    """Earlier versions did not keep which facets lie on them: the allowance was refused as one without
    faces."""
    named = {"low": face_at(step, z=5, x=15), "high": face_at(step, z=10), "wall": face_at(step, x=10, z=7.5)}
    given = {**GIVEN, "faces": [named[one] for one in faces], "avoid": [named["wall"]]}
    path = app.create_toolpath(doc, step, **given)
    request = app.create_toolpath(doc, step, **given, avoid_allowance=1)
    nc, wanted, name = results.nc_of(path), results.nc_of(request), path.Name
    assert path.Mesh.AvoidedRuns and nc != wanted
    path.Mesh.removeProperty("AvoidedRuns")
    doc.recompute()
    again = reopen(doc).getObject(name)
    anew()
    assert not again.Mesh.AvoidedRuns and not results.out_of_date(again) and results.nc_of(again) == nc
    again.AvoidAllowance = 1
    again.Document.recompute()
    assert (
        again.State == ["Up-to-date"]
        and again.Mesh.State == ["Up-to-date"]
        and results.nc_of(again) == wanted
    )
    options = {name: value for name, value in given.items() if name not in ("faces", "avoid")}
    part = previewing.part_of(again, {})
    assert previewing.lay(again.Document, part, {**options, "avoid_allowance": 1}, (0, 0, 0)).length > 0


def test_a_mesh_that_is_another_today_is_requested_to_be_recomputed(doc, step):
    wall = face_at(step, x=10, z=7.5)
    path = app.create_toolpath(doc, step, avoid=[wall], **GIVEN)
    path.Mesh.AvoidedRuns, path.Mesh.FacetRuns = [], [0, 2]
    path.AvoidAllowance = 1
    with pytest.raises(SelectionError, match=r"Tessellation was made by an earlier version.*recompute"):
        results.nc_of(path)
    path.Mesh.touch()
    doc.recompute()
    assert path.Mesh.AvoidedRuns and not results.out_of_date(path)


def test_a_part_that_is_scaled_leaves_the_same_faces_alone(doc, step):
    low = face_at(step, z=5, x=15)
    path = app.create_toolpath(doc, step, faces=[face_at(step, z=10), low], avoid=[low], **GIVEN)
    runs = list(path.Mesh.FacetRuns)
    copy = scale_part(path, 2.0)
    assert list(path.Mesh.FacetRuns) == runs and path.Mesh.Avoid[0] is copy
    assert copy.Shape.getElement(path.Mesh.Avoid[1][0]).BoundBox.ZMin == pytest.approx(10.0)
    doc.recompute()
    assert on(contacts(path), copy, path.Mesh.Avoid[1][0]) == 0


def test_faces_are_taken_from_what_is_selected(doc, step, dome):
    other = doc.addObject("Part::Box", "Other")
    doc.recompute()
    assert selection.faces_of(step, [(step, ["Face3", "Face1", "Face3"])]) == ("Face3", "Face1")
    for chosen, message in (
        ([], "Nothing is selected: click faces of Step"),
        ([(step, [])], "Step is no face: select faces of Step"),
        ([(step, ["Face1", "Edge2"])], "Edge2 is no face: select faces of Step"),
        ([(other, ["Face1"])], "Face1 is a face of Other: select faces of Step"),
        ([(dome, ["Facet1"])], "Facet1 is no face"),
    ):
        with pytest.raises(SelectionError, match=message):
            selection.faces_of(step, chosen)


def test_a_face_of_what_is_inside_the_base_is_the_base_s_own(doc, step):
    body = doc.addObject("PartDesign::Body", "Body")
    body.addObject(doc.addObject("PartDesign::AdditiveBox", "Cube"))
    part = doc.addObject("App::Part", "Holder")
    part.addObject(step)
    part.Placement.Base = FreeCAD.Vector(0, 0, 7)
    doc.recompute()
    cube = doc.getObject("Cube")
    found = selection.faces_of(body, [(cube, ["Face2"])])
    assert body.Shape.getElement(found[0]).CenterOfMass.isEqual(
        cube.Shape.getElement("Face2").CenterOfMass, 1e-9
    )
    assert len(selection.faces_of(part, [(step, ["Face1", "Face2"])])) == 2
    with pytest.raises(SelectionError, match="is a face of Step"):
        selection.faces_of(body, [(step, ["Face1"])])
