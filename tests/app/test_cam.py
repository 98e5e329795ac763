# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview for CAM lies where the tool goes, and a CAM Job gives model, tool and feeds."""

from types import SimpleNamespace

import FreeCAD
import numpy as np
import pytest
from cam_jobs import make_job
from conftest import PLAIN, UNCURED

from freecad_fiveaxis import app
from freecad_fiveaxis.app import cam
from freecad_fiveaxis.app.results import figures_of
from freecad_fiveaxis.app.selection import SelectionError
from freecad_fiveaxis.app.tool_bit import JobTool
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.cl_path import Motion

pytestmark = pytest.mark.usefixtures("kept")


@pytest.fixture
def dome(doc):
    result = doc.addObject("Part::Sphere", "Dome")
    result.Radius, result.Angle1 = 10, 0
    doc.recompute()
    return result


def mill(dome, **settings):
    return app.create_toolpath(
        dome.Document,
        dome,
        machine="trunnion_ac",
        cutter="ball:6",
        stepover=5,
        linear_deflection=0.2,
        **PLAIN,
        **settings,
    )


def xyz(commands):
    return np.array([[one.Parameters[letter] for letter in "XYZ"] for one in commands])


def test_the_preview_is_the_tips_way_without_rotary_words(dome):
    toolpath = mill(dome, feed=600)
    obj = cam.preview(toolpath)
    figures, commands = figures_of(toolpath), obj.Path.Commands
    assert obj.isDerivedFrom("Path::Feature") and "Touched" not in obj.State
    assert np.allclose(xyz(commands), figures.tip, atol=1e-9)
    rapid = figures.program.motion == Motion.RAPID
    assert [one.Name for one in commands] == np.where(rapid, "G0", "G1").tolist()
    assert not [one for one in commands if set(one.Parameters) & set("ABC")]


def test_feeds_are_mm_a_second_and_give_the_programs_time(dome):
    toolpath = mill(dome, feed=600)
    figures, commands = figures_of(toolpath), cam.preview(toolpath).Path.Commands
    feeds = figures.program.motion != Motion.RAPID
    speed = np.array([one.Parameters.get("F", np.nan) for one in commands])
    assert np.isnan(speed[~feeds]).all()
    assert speed[feeds].max() == pytest.approx(
        10.0, rel=0.01
    )  # 600 mm/min; less where the real way is longer than the segment
    length = np.linalg.norm(np.diff(xyz(commands), axis=0, prepend=xyz(commands)[:1]), axis=1)
    assert (length[feeds] / speed[feeds]).sum() == pytest.approx(
        figures.program.seconds[feeds].sum(), rel=1e-3
    )


def test_the_preview_lies_on_the_part_wherever_the_work_zero_is(dome):
    dome.Placement.Base = FreeCAD.Vector(100, 50, 0)
    dome.Document.recompute()
    moved = xyz(cam.preview(mill(dome, work_zero=(100, 50, 0))).Path.Commands)
    assert moved[:, 0].min() > 80 and moved[:, 0].max() < 120
    assert np.abs(moved[:, 1] - 50).max() < 20
    figures = figures_of(mill(dome, work_zero=(100, 50, 0)))
    assert np.allclose(moved, figures.tip + (100, 50, 0), atol=1e-6)


def test_there_is_one_preview_and_it_follows_the_toolpath(dome):
    toolpath = mill(dome)
    obj = cam.preview(toolpath)
    before = obj.Path.Size
    assert cam.preview(toolpath) is obj
    toolpath.Stepover = 2
    dome.Document.recompute()
    assert obj.Path.Size == toolpath.Blocks != before


def test_the_preview_survives_saving_and_opening(dome, tmp_path):
    toolpath, file = mill(dome), str(tmp_path / "dome.FCStd")
    expected = xyz(cam.preview(toolpath).Path.Commands)
    dome.Document.saveCopy(file)
    again = FreeCAD.openDocument(file)
    try:
        (obj,) = [one for one in again.Objects if one.isDerivedFrom("Path::Feature")]
        assert isinstance(obj.Proxy, cam.Preview)
        assert np.allclose(xyz(obj.Path.Commands), expected, atol=1e-5)
    finally:
        FreeCAD.closeDocument(again.Name)


def test_a_preview_without_its_toolpath_says_so(dome):
    toolpath = mill(dome)
    obj = cam.preview(toolpath)
    dome.Document.removeObject(toolpath.Name)
    with pytest.raises(SelectionError, match="delete the preview"):
        obj.Proxy.execute(obj)


def figures_like(tip, motion, seconds):
    return SimpleNamespace(
        tip=np.asarray(tip, float),
        program=SimpleNamespace(motion=np.asarray(motion), seconds=np.asarray(seconds, float)),
    )


def test_where_only_the_tool_turns_the_feed_of_the_block_before_stays():
    tip = [(0, 0, 0), (10, 0, 0), (10, 0, 0), (10, 5, 0)]
    figures = figures_like(tip, [Motion.RAPID, Motion.CUT, Motion.CUT, Motion.CUT], [0, 2, 1, 0.5])
    assert cam.tip_feeds(figures)[1:].tolist() == [5, 5, 10]


def test_a_path_of_rapids_alone_and_an_empty_one():
    assert cam.path_of(figures_like([(0, 0, 0), (1, 0, 0)], [Motion.RAPID] * 2, [0, 0])).Size == 2
    assert cam.path_of(figures_like(np.empty((0, 3)), [], [])).Size == 0


def test_a_hundred_thousand_blocks_are_previewed():
    n = 100_000
    figures = figures_like(
        np.random.default_rng(1).uniform(-100, 100, (n, 3)), np.zeros(n, int), np.full(n, 0.1)
    )
    assert cam.path_of(figures).Size == n


def test_a_job_gives_its_model_its_ball_end_and_its_feeds(dome):
    job = make_job(dome.Document, dome)
    assert cam.jobs_of(dome.Document) == [job]
    assert cam.job_of(dome) is job and cam.job_of(job.Model.Group[0]) is job
    model, settings = cam.settings_from_job(job)
    assert model == job.Model.Group
    assert settings == {
        "cutter": Cutter(6.0, 40.0),
        "tool": 3,
        "feed": 1000.0,
        "plunge_feed": 200.0,
        "spindle": 12000.0,
    }


def test_a_jobs_settings_make_a_toolpath(dome):
    (model,), settings = cam.settings_from_job(make_job(dome.Document, dome))
    settings = {"stepover": 5, "linear_deflection": 0.2, **PLAIN, **settings}
    toolpath = app.create_toolpath(dome.Document, model, machine="trunnion_ac", **settings)
    assert toolpath.CutterDiameter.Value == 6 and toolpath.CutterLength.Value == 40
    assert toolpath.Feed.getValueAs("mm/min").Value == pytest.approx(1000) and toolpath.Tool == 3
    assert cam.preview(toolpath) not in cam.jobs_of(dome.Document)


def test_a_job_without_a_tool_of_use_says_which_tools_it_has(dome, monkeypatch):
    job = make_job(dome.Document, dome)
    with pytest.raises(SelectionError, match="no tool 7"):
        cam.settings_from_job(job, 7)
    monkeypatch.setattr(
        cam, "cutters_of_job", lambda job: [JobTool("Drill", 1, None, "Drill is a tool of the shape drill")]
    )
    with pytest.raises(SelectionError, match="Job: Drill is a tool of the shape drill"):
        cam.settings_from_job(job)


def test_a_ball_end_is_taken_before_others_and_any_of_use_by_its_number(dome, monkeypatch):
    job = make_job(dome.Document, dome)
    assert cam.settings_from_job(job)[1]["cutter"] == Cutter(6.0, 40.0)
    flat = cam.settings_from_job(job, 1)[1]["cutter"]
    assert (flat.diameter, flat.corner) == (5.0, 0.0)
    path = app.create_toolpath(dome.Document, dome, machine="trunnion_ac", cutter=flat, stepover=5,
                               linear_deflection=0.2, **PLAIN, **UNCURED)  # fmt: skip
    assert path.CutterKind == "flat" and path.Blocks > 0
    tools = [one for one in cam.cutters_of_job(job) if one.number == 1]
    monkeypatch.setattr(cam, "cutters_of_job", lambda job: tools)
    assert cam.settings_from_job(job)[1]["cutter"] == flat


def test_an_object_in_no_job_has_none(dome):
    job = make_job(dome.Document, dome)
    other = dome.Document.addObject("Part::Box", "Box")
    assert cam.job_of(other) is None
    job.Model.Group = []
    assert cam.job_of(dome) is None
    with pytest.raises(SelectionError, match="has no model"):
        cam.settings_from_job(job)


def test_a_body_in_a_job_is_found_from_its_features(doc):
    body = doc.addObject("PartDesign::Body", "Body")
    box = body.newObject("PartDesign::AdditiveBox", "Block")
    doc.recompute()
    job = make_job(doc, body)
    assert cam.job_of(body) is job and cam.job_of(box) is job
