# SPDX-License-Identifier: LGPL-2.1-or-later
"""How high jaws may reach beside the part: closed forms, and dense samples of the program that ``mill``
makes."""

import numpy as np
import pytest
from plain import build_settings
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.geometry.solids import box_facets
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.studies.setup_map import jaws
from freecad_fiveaxis.core.studies.study import try_setups
from freecad_fiveaxis.core.toolpath.apt.writer import write_apt

GIVEN = {
    "machine": "trunnion_ac", "cutter": "ball:6", "holder": "40x30", "passes": "planes",
    "tool_axis": "facet_mean", "stepover": 4.0, "origin": (0.0, 0.0, 0.0), "max_axis_angle": 10.0,
    "gouge": "off",
}  # fmt: skip
"""The jaws stand where no pass is lifted: but for one that looks at that, and samples, these are made without
it."""
MAP = {"region": (20.0, 0.0, 0.0), "grid": (2.0, 1.0, 1.0)}


def stepped(shelf=-6.0):
    """A plate with its top at 0 and its bottom at -10, and a shelf on its +X side."""
    boxes = [((-30.0, -20.0, -10.0), (30.0, 20.0, 0.0)), ((30.0, -20.0, -10.0), (45.0, 20.0, shelf))]
    return from_triangles(np.concatenate([box_facets(*np.array(one)) for one in boxes]))


def vise(tmp_path, low, high, name="beside.stl"):
    write_stl(from_triangles(box_facets(np.array(low, float), np.array(high, float))), tmp_path / name)
    return str(tmp_path / name)


def charted(tmp_path, mesh=None, **more):
    beside = vise(tmp_path, (-80, -90, -10), (80, -70, -9))
    return try_setups(
        build_settings("setup", "p.stl", GIVEN | MAP | {"fixture": (beside,)} | more), mesh=mesh or stepped()
    ).chart


def tops(chart):
    return {jaw.side: jaw.top for jaw in chart.clamping.jaws}


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_jaw_beside_a_shelf_reaches_as_high_as_the_shelf(tmp_path):
    """The ball goes down to the shelf up to its edge, and on the other side to the top of the plate. In Y the
    last pass is not over the edge: there the ball leaves room for a little more."""
    found = tops(charted(tmp_path, gouge="lift"))
    assert found["-X"] == pytest.approx(0.0) and found["+X"] == pytest.approx(-6.0)
    assert -6.0 <= found["-Y"] < -5.0 and -6.0 <= found["+Y"] < -5.0


@pytest.mark.parametrize("clearance", [1.0, 2.5])
def test_the_clearance_is_kept_below_the_ball(tmp_path, clearance):
    """Over the edge the ball's lowest point is straight above the jaw's: grown, it reaches so far down."""
    found = tops(charted(tmp_path, fixture_clearance=clearance))
    assert found["-X"] == pytest.approx(-clearance) and found["+X"] == pytest.approx(-6.0 - clearance)


@pytest.mark.oldest
@pytest.mark.thorough
def test_thin_jaws_reach_higher_than_thick_ones_under_a_holder_that_leans_over_them(tmp_path):
    """Of a holder 12 mm above the ball's centre, 20 mm in radius and leant by 50 deg, the lowest place is 3 +
    12 cos 50 - 20 sin 50 mm over the part's top, 22 mm beside the tip: over a jaw of 40 mm, beyond one of
    5 mm."""
    leans = {"tilt": 50.0, "max_axis_angle": 60.0, "cutter": "ball:6:15", "gouge": "off", "direction": 90.0}
    strip = from_triangles(box_facets(np.array((-5.0, -30.0, -10.0)), np.array((5.0, 30.0, 0.0))))
    thick = charted(tmp_path, strip, **leans)
    thin = charted(tmp_path, strip, **leans, jaw_thickness=5.0)
    lowest = 3.0 + 12.0 * np.cos(np.radians(50.0)) - 20.0 * np.sin(np.radians(50.0))
    for side in ("-X", "+X"):
        assert tops(thick)[side] == pytest.approx(lowest, abs=0.15) and tops(thin)[side] == pytest.approx(0.0)
    message = next(one.text for one in thin.findings if one.code == "jaws-free")
    assert "Jaws 5 mm thick" in message and "sticks out 15 mm" in message


@pytest.mark.parametrize("wrong", ["0", "-3", "20000", "thick"])
def test_a_thickness_that_cannot_be_is_refused_by_name(wrong):
    with pytest.raises(SettingsError, match=f"jaw.thickness.*{wrong}"):
        build_settings("setup", "p.stl", GIVEN | {"jaw_thickness": wrong})


def test_a_fixture_that_is_hit_is_reported_and_one_that_is_free_is_not(tmp_path):
    free = charted(tmp_path)
    assert free.clamping.hits == () and "jaws-free" in [one.code for one in free.findings]
    hit = charted(tmp_path, fixture=(vise(tmp_path, (-5, -5, 1), (5, 5, 20), "on.stl"),), gouge="off")
    reported = [one for one in hit.findings if one.code == "fixture-collision"]
    assert bool(reported) and "+X: Z -6 mm" in next(
        one.text for one in hit.findings if one.code == "jaws-free"
    )


def test_what_is_hit_of_a_fixture_is_reported_of_a_cl_file_too_and_no_jaws_or_stick_out_are(tmp_path):
    """Nobody knows the part there: a jaw beside it, or the holder over it, would be a guess."""
    plain = {name: value for name, value in GIVEN.items() if name != "origin"}
    draft = job.make(build_settings("mill", "p.stl", plain | {"spindle": "off"}), mesh=stepped())
    cutter = draft.settings.cutter.cutter
    (tmp_path / "x.apt").write_bytes(write_apt(draft.path, cutter, "part"))
    given = {
        "machine": "trunnion_ac",
        "holder": "40x30",
        "fixture": (vise(tmp_path, (-5, -5, -9), (5, 5, 5), "in.stl"),),
    }
    chart = try_setups(build_settings("setup", str(tmp_path / "x.apt"), given | MAP)).chart
    reported = {one.code for one in chart.findings}
    assert "fixture-collision" in reported and chart.clamping.jaws == () and chart.stick_out is None
    assert not reported & {"jaws-free", "stick-out-enough", "stick-out-too-short"}


def test_without_a_fixture_nothing_is_reported(tmp_path):
    chart = charted(tmp_path, fixture=())
    assert chart.clamping is None and "jaws-free" not in [one.code for one in chart.findings]


def ball_in_jaw(chart, top, side, **more):
    """How deep the ball of 6 mm of the program that ``mill`` makes goes into a jaw at most, by samples."""
    origin = tuple(chart.origin[chart.best].tolist())
    draft = job.make(
        build_settings("mill", "p.stl", GIVEN | {"origin": origin, "spindle": "off"} | more), mesh=stepped()
    )
    _, axis, out = next(one for one in jaws.SIDES if one[0] == side)
    low, high = jaws.jaw_corners(stepped().box, axis, out, chart.clamping.thick, top)
    share = np.linspace(0.0, 1.0, 40, endpoint=False)[:, None, None]
    words = ((1.0 - share) * draft.program.words[:-1] + share * draft.program.words[1:]).reshape(-1, 5)
    tip, lean = forward(draft.kinematics, words_to_q(words))
    centre = tip + 3.0 * lean
    return float((3.0 - np.linalg.norm(centre - np.clip(centre, low, high), axis=1)).max())


@pytest.mark.thorough
@some_in_core("side", ["-X", "+X", "-Y", "+Y"])
def test_samples_enter_no_jaw_and_one_that_is_half_a_millimetre_higher(tmp_path, side):
    chart = charted(tmp_path, gouge="lift")
    top = tops(chart)[side]
    assert ball_in_jaw(chart, top, side, gouge="lift") <= 0.01 + 1e-6
    assert side == "-X" or ball_in_jaw(chart, top + 0.5, side, gouge="lift") > 0.1


def test_a_jaw_on_the_wrong_side_would_be_noticed(tmp_path, monkeypatch):
    """The comparison can fail: with the sides taken for each other the samples enter the jaw."""
    monkeypatch.setattr(jaws, "SIDES", tuple((name, axis, -out) for name, axis, out in jaws.SIDES))
    chart = charted(tmp_path)
    wrong = tops(chart)["+X"]
    monkeypatch.undo()
    assert ball_in_jaw(chart, wrong, "+X") > 1.0
