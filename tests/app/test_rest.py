# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of rest material: its numbers are the core's and those of closed forms, and it follows its
toolpath."""

import FreeCAD
import numpy as np
import Part
import pytest
from conftest import UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import convert, left, rest, results
from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError, SettingsError
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import MILL, build_settings

GROOVE = {
    "machine": "trunnion_ac",
    "cutter": "ball:10",
    "stepover": 1,
    "direction": 90,
    "tool_axis": "fixed",
    "tolerance": 0.02,
}
"""Passes along the groove, the tool upright."""

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def groove(doc):
    """A block of 48 x 16 mm whose top has a V groove of 90 deg along Y, 6 mm deep, its bottom at x = 0, z =
    0."""
    profile = [(-24, 6), (-6, 6), (0, 0), (6, 6), (24, 6), (24, -8), (-24, -8), (-24, 6)]
    obj = doc.addObject("Part::Feature", "Groove")
    obj.Shape = Part.Face(Part.makePolygon([(x, 0, z) for x, z in profile])).extrude(FreeCAD.Vector(0, 16, 0))
    doc.recompute()
    return obj


def top(obj):
    """The object, and the names of its faces that look up."""
    return obj, [f"Face{at}" for at, face in enumerate(obj.Shape.Faces, 1) if face.normalAt(0, 0).z > 0.5]


def test_a_ball_leaves_the_bottom_of_a_groove_that_is_too_narrow_for_it(doc, groove):
    """A ball of radius R in a V of half angle a stays R (1 / sin a - 1) away from its bottom, where it enters
    neither wall."""
    path = app.create_toolpath(doc, top(groove), **GROOVE, gouge="lift")
    outcome = app.left_map(path)
    assert outcome.LargestUndercut.Value == pytest.approx(
        5.0 * (np.sqrt(2.0) - 1.0), rel=0.12
    )  # samples lie beside the bottom
    assert outcome.LargestOvercut.Value <= 0.02 and outcome.OvercutArea.Value == 0.0
    bare = np.sqrt(
        (5.0 + outcome.Allowed.Value) ** 2 - 5.0**2
    )  # from where the ball touches to where more than allowed is left
    assert outcome.UncutArea.Value == pytest.approx(2.0 * (5.0 - bare) * 16.0, rel=0.03)
    assert "is left, at most" in outcome.Verdict and outcome.State == ["Up-to-date"] and outcome.UpToDate


def test_a_ball_that_is_not_lifted_cuts_the_other_wall(doc, groove):
    outcome = app.left_map(app.create_toolpath(doc, top(groove), **GROOVE, **UNCURED))
    assert outcome.LargestOvercut.Value > 0.5 and outcome.OvercutArea.Value > 10.0
    assert "cut too deep, at most by" in outcome.Verdict


def test_the_map_is_that_of_the_core(anew, doc, groove, tmp_path):
    file = str(tmp_path / "groove.stl")
    mesh = app.tessellate(groove, file)
    wanted = job.run(build_settings("mill", file, {**GROOVE, "rest": "on"})).rest
    for settings in (GROOVE, {**GROOVE, "rest": "on"}):
        outcome = app.left_map(app.create_toolpath(doc, mesh, **settings))
        found = rest.heights_of(outcome).rest
        np.testing.assert_array_equal(found.height, wanted.height)
        np.testing.assert_array_equal(found.point, wanted.point)
    assert results.result_of(outcome.Path).rest is found, "the path's own map is found a second time"
    assert outcome.MachinedArea.Value == pytest.approx(wanted.area.sum())


def test_a_path_has_one_map_that_follows_it(doc, groove):
    path = app.create_toolpath(doc, top(groove), **GROOVE, gouge="lift")
    outcome = app.left_map(path)
    assert app.left_map(path) is outcome is rest.of(path)
    before = outcome.LargestUndercut.Value
    path.CutterDiameter = 4
    assert "recompute" in rest.out_of_date(outcome)
    doc.recompute()
    assert rest.out_of_date(outcome) == "" and outcome.LargestUndercut.Value < 0.6 * before
    path.Machine = "no_such_machine"
    doc.recompute()
    assert not outcome.UpToDate and rest.out_of_date(outcome)


def test_documents_and_macros_of_earlier_versions_find_what_they_name(doc, groove):
    """Documents have the proxy's path and the property ``Left``; macros the option ``left`` and the heights
    in ``app.left``."""
    path = app.create_toolpath(doc, top(groove), **GROOVE, left="on")
    assert path.Left == "on" and "Rest" not in path.PropertiesList
    assert (
        path.Proxy.last.result.draft.settings.gouge.rest == "on"
        and convert.options_of(path, MILL)["rest"] == "on"
    )
    outcome = app.left_map(path)
    assert (
        f"{type(outcome.Proxy).__module__}.{type(outcome.Proxy).__name__}"
        == "freecad_fiveaxis.app.left.LeftMap"
    )
    assert left.heights_of(outcome).left is rest.heights_of(outcome).rest


def test_an_option_under_both_its_names_makes_no_path(doc, groove):
    with pytest.raises(SettingsError, match="give rest alone"):
        app.create_toolpath(doc, top(groove), **GROOVE, left="on", rest="on")
    assert [obj.Name for obj in doc.Objects] == ["Groove"]


def test_a_reopened_map_keeps_its_numbers_and_finds_its_heights_when_requested(doc, groove, reopen, anew):
    outcome = app.left_map(app.create_toolpath(doc, top(groove), **GROOVE, work_zero=(1, 2, 3)))
    numbers = (
        outcome.LargestUndercut.Value,
        outcome.LargestOvercut.Value,
        outcome.UncutArea.Value,
        outcome.MachinedArea.Value,
    )
    height = rest.heights_of(outcome).rest.height
    anew()
    again = reopen(doc).LeftMap
    kept = (
        again.LargestUndercut.Value,
        again.LargestOvercut.Value,
        again.UncutArea.Value,
        again.MachinedArea.Value,
    )
    assert again.Proxy.last is None and kept == pytest.approx(numbers, rel=1e-12) and again.Verdict
    assert rest.out_of_date(again) == "" and type(again.Proxy) is left.LeftMap
    np.testing.assert_array_equal(rest.heights_of(again).rest.height, height)


def test_only_toolpaths_are_mapped_and_nothing_is_left_behind(doc, groove, tmp_path):
    for wrong in (None, groove):
        with pytest.raises(FiveAxisError, match="select a toolpath"):
            app.left_map(wrong)
    path = app.create_toolpath(doc, top(groove), **GROOVE)
    app.post_process(path, tmp_path / "groove.ngc")
    audit = app.audit(doc, tmp_path / "groove.ngc", "trunnion_ac")
    names = [one.Name for one in doc.Objects]
    with pytest.raises(FiveAxisError, match="select a toolpath"):
        app.left_map(audit)
    assert [one.Name for one in doc.Objects] == names


def test_stopped_work_leaves_nothing_behind(anew, doc, groove):
    from freecad_fiveaxis.app.long_work import reporting

    path = app.create_toolpath(doc, top(groove), **GROOVE)
    names = [one.Name for one in doc.Objects]

    def stop(stage, fraction):
        if stage == "what is left":
            raise Cancelled("stopped")

    with pytest.raises(Cancelled), reporting(stop):
        app.left_map(path)
    assert [one.Name for one in doc.Objects] == names and path.State == ["Up-to-date"]


def test_a_map_without_a_path_is_reported(doc, groove):
    outcome = app.left_map(app.create_toolpath(doc, top(groove), **GROOVE))
    doc.removeObject(outcome.Path.Name)
    doc.recompute()
    assert (
        "Invalid" in outcome.State
        and "was deleted" in outcome.getStatusString()
        and "was deleted" in rest.out_of_date(outcome)
    )


# ------------------------------------------------------------------------------------------------ faces


@pytest.fixture
def step(doc):
    """A block of 40 x 30 x 10 mm, and on its half beyond x = 20 a step of another 30 mm."""
    obj = doc.addObject("Part::Feature", "Step")
    obj.Shape = (
        Part.makeBox(40, 30, 10).fuse(Part.makeBox(20, 30, 30, FreeCAD.Vector(20, 0, 10))).removeSplitter()
    )
    doc.recompute()
    return obj


def face_at(obj, **where):
    """The name of the face whose middle has these coordinates."""
    for at, face in enumerate(obj.Shape.Faces, 1):
        if all(abs(getattr(face.CenterOfMass, axis) - value) < 1e-6 for axis, value in where.items()):
            return f"Face{at}"
    raise AssertionError(where)


FACES = {
    "machine": "trunnion_ac",
    "cutter": "ball:6:12",
    "passes": "planes",
    "stepover": 2,
    "gouge": "report",
    "clearance": 10,
}


def test_a_wall_that_is_not_selected_stops_the_holder_and_the_map_covers_what_is_selected(doc, step):
    chosen = (face_at(step, z=10.0), face_at(step, z=40.0))
    path = app.create_toolpath(doc, (step, chosen), **FACES, holder="40x30", rest="on")
    result = results.result_of(path)
    mesh, keep = result.draft.mesh, result.draft.keep
    assert 0 < keep.sum() < len(keep) and set(np.round(mesh.vertex[mesh.face[keep]][..., 2].ravel(), 6)) == {
        10.0,
        40.0,
    }
    (first, *_) = [one for one in result.findings if one.code == "holder-collision"]
    assert first.place[0] >= 20.0 - 1e-6 and first.value > 1.0, "the wall beyond x = 20 stops the holder"
    outcome = app.left_map(path)
    assert outcome.MachinedArea.Value == pytest.approx(2 * 20.0 * 30.0, rel=1e-6)
    assert set(result.rest.facet) == set(np.flatnonzero(keep))
    slim = app.create_toolpath(doc, (step, chosen), **{**FACES, "cutter": "ball:6:60"})
    assert not [one for one in results.result_of(slim).findings if one.code == "holder-collision"]


def test_the_cutter_itself_is_checked_against_the_wall_that_is_not_selected(doc, step):
    """Passes over the floor along the wall: the last ones are nearer to it than the ball's radius."""
    settings = {**FACES, "direction": 90}
    path = app.create_toolpath(doc, (step, (face_at(step, z=10.0),)), **settings)
    deep = [one for one in results.result_of(path).findings if one.code == "overcut"]
    assert deep and 1.0 < deep[0].value <= 3.0 and deep[0].place[0] >= 20.0 - 1e-6
    cured = app.create_toolpath(doc, (step, (face_at(step, z=10.0),)), **{**settings, "gouge": "leave-out"})
    assert not [one for one in results.result_of(cured).findings if one.code == "overcut"]
    outcome = app.left_map(cured)
    assert outcome.MachinedArea.Value == pytest.approx(20.0 * 30.0, rel=1e-6)
    assert outcome.UncutArea.Value > 0.0, "beside the wall a ball leaves a fillet"
