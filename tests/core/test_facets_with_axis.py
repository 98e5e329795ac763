# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `auto` cuts: facets and contacts are left out only where no axis is free, whatever way their normals
look."""

import math
from functools import cache

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings
from revolved import solid_of_revolution
from scipy.spatial import cKDTree
from test_axis_field import NODES as FEW
from test_axis_field import stemmed, take_nodes
from test_fewer_axes import table_a
from test_reach_map import block, slot
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import ReachError, SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.machine import save_machine
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.orientation.axis_field import NODES
from freecad_fiveaxis.core.orientation.facets_with_axis import find_axis_field, select_facets
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report.figures import summary
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.cl_path import Motion

OPTIONS = {
    "machine": "trunnion_ac",
    "cutter": "ball:6:40",
    "passes": "scallop",
    "stepover": 1.5,
    "tool_axis": "auto",
}
RIGHT = math.pi / 2


def milled(mesh, **options):
    return job.make(build_settings("mill", "part", {**OPTIONS, **options}), mesh=mesh)


@cache
def sphere_milled(nodes):
    with pytest.MonkeyPatch.context() as patch:
        take_nodes(patch, nodes)
        return milled(stemmed(), max_axis_angle=90)


@pytest.fixture(params=[FEW, pytest.param(NODES, marks=pytest.mark.thorough)])
def some_nodes(request, monkeypatch):
    """So many places are looked at."""
    take_nodes(monkeypatch, request.param)


def served(mesh, reacher, most=RIGHT):
    facets = np.ones(len(mesh.face), bool)
    return select_facets(find_axis_field(mesh, facets, reacher), mesh, facets, most)


def left_out_of(mesh, most):
    """Return what is told to be left out with a ball of 6 mm whose axis leans by ``most`` rad at most."""
    facets, reacher = np.ones(len(mesh.face), bool), Reacher(Cutter(6.0, 60.0), most=most)
    return select_facets(find_axis_field(mesh, facets, reacher), mesh, facets, most, reacher)[1]


def feed_places(outcome):
    """Tips and axes (k, 3) on the real way of all feed blocks, in the work frame, 20 for each."""
    words = outcome.program.words
    row = np.flatnonzero(outcome.program.motion[1:] != Motion.RAPID)
    share = np.linspace(0.0, 1.0, 20)[:, None, None]
    return forward(
        outcome.kinematics,
        words_to_q((words[row] + share * (words[row + 1] - words[row])).reshape(-1, words.shape[1])),
    )


def finished(outcome, points):
    """Which points of the surface the ball comes to within 0.2 mm (a stepover of 1.5 leaves 0.1 on a
    flat)."""
    tip, axis = feed_places(outcome)
    return cKDTree(tip + 3.0 * axis).query(points)[0] <= 3.0 + 0.2


@pytest.mark.thorough
@some_in_core("nodes", [FEW, NODES])
def test_the_underside_of_a_sphere_on_a_stem_is_cut_by_axes_that_do_not_look_up_from_below(nodes):
    """Normals of the sphere's lower half look down; a ball gets there from the side, its shank level at
    most."""
    outcome = sphere_milled(nodes)
    middle = outcome.mesh.vertex[outcome.mesh.face].mean(axis=1)
    under = (outcome.mesh.normal[:, 2] < -0.2) & (outcome.mesh.normal[:, 2] > -0.8) & (middle[:, 2] > 15.0)
    tip, axis = feed_places(outcome)
    assert under.sum() > 100 and finished(outcome, middle[under]).all()
    assert axis[:, 2].min() > -1e-3, "an axis beyond the largest angle"
    assert (tip[:, 2] + 3.0 * axis[:, 2]).min() > 0.0
    by_normals = milled(stemmed(), tool_axis="facet_mean")
    assert not finished(by_normals, middle[under & (outcome.mesh.normal[:, 2] < -0.4)]).all()


@some_in_core("nodes", [FEW, NODES])
def test_nothing_enters_and_nothing_is_reported_that_is_not_so(nodes):
    result = job.prove(sphere_milled(nodes))
    codes = {one.code for one in result.findings}
    assert not codes & {
        "overcut",
        "holder-collision",
        "rapid-collision",
        "facets-looking-down",
        "no-free-axis",
    }
    assert summary(job.figures(result))["unfinished_share"] < 0.05


@pytest.mark.usefixtures("some_nodes")
def test_the_underside_stays_out_as_long_as_the_axis_may_not_go_below_the_level():
    keep, findings = served(block(), Reacher(Cutter(6.0, 40.0), most=RIGHT))
    assert (keep == (block().normal[:, 2] > -0.5)).all()
    (one,) = findings
    assert (one.code, one.unit) == ("facets-looking-down", "mm2") and one.value == pytest.approx(1200.0)
    assert "within 90 deg" in one.text
    keep, findings = served(block(), Reacher(Cutter(6.0, 40.0)), math.pi)
    assert keep.all() and findings == ()


@pytest.mark.usefixtures("some_nodes")
def test_a_bore_from_below_is_not_too_tight_but_beyond_what_the_axis_may_lean():
    bored = solid_of_revolution([(0, 40), (15, 40), (15, 0), (5, 0), (5, 25), (0, 25)], 24)
    found = left_out_of(bored, math.radians(120.0))
    wall = next(one for one in found if "turn the part over" in one.text)
    assert wall.value == pytest.approx(2.0 * math.pi * 5.0 * 25.0, rel=0.25)
    assert wall.value > 3.0 * sum(one.value for one in found if "too tight" in one.text)
    assert all("too tight" in one.text for one in left_out_of(bored, math.pi))


@pytest.mark.usefixtures("some_nodes")
def test_a_closed_hollow_is_named_and_no_smaller_cutter_is_advised():
    hollow = from_triangles(
        np.concatenate([box((0, 0, 0), (40, 40, 30)), box((5, 5, 5), (35, 35, 25))[:, ::-1]])
    )
    (one,) = left_out_of(hollow, math.pi)
    assert "closed hollow" in one.text and one.value == pytest.approx(4200.0)


@pytest.mark.usefixtures("some_nodes")
def test_what_looks_down_is_not_to_be_had_by_a_larger_angle_where_any_is_allowed(monkeypatch):
    mesh = block()
    monkeypatch.setattr(
        "freecad_fiveaxis.core.orientation.axis_field.within_limits", lambda _, axis: axis[:, 2] > 0.0
    )
    monkeypatch.setattr(
        "freecad_fiveaxis.core.gouge.obstacles.within_limits", lambda _, axis: axis[:, 2] > 0.0
    )
    (one,) = served(mesh, Reacher(Cutter(6.0, 40.0)), math.pi)[1]
    assert "180" not in one.text and one.text.endswith("Turn the part over.")


@pytest.mark.usefixtures("some_nodes")
def test_a_table_is_named():
    mesh = block()
    keep, findings = served(mesh, Reacher(Cutter(6.0, 40.0), table=0.0), math.pi)
    assert not keep[mesh.normal[:, 2] < -0.5].any() and keep[mesh.normal[:, 2] > 0.5].all()
    assert "below the table" in findings[0].text and findings[0].value == pytest.approx(1200.0)


@pytest.mark.usefixtures("some_nodes")
@some_in_core(
    ("width", "tool", "words"),
    [
        (5.0, {"cutter": Cutter(6.0, 60.0)}, "too tight"),
        (12.0, {"cutter": Cutter(6.0, 5.0), "shank": ((16.0, 90.0),)}, "the shank"),
        (14.0, {"cutter": Cutter(6.0, 12.0), "holder": ((60.0, 30.0),), "most": 0.5}, "the holder"),
    ],
)
def test_each_reason_is_named_with_its_area(width, tool, words):
    mesh = slot(width, 40.0, 120.0)
    keep, findings = served(mesh, Reacher(**tool))
    floor = (mesh.normal[:, 2] > 0.5) & (mesh.vertex[mesh.face].mean(axis=1)[:, 2] < 20.0)
    assert floor.any() and not keep[floor].any()
    one = next(one for one in findings if one.code == "facets-without-free-axis" and words in one.text)
    assert one.value >= width * 120.0 * 0.99 and one.value <= mesh.area[~keep].sum() + 1e-9
    assert served(mesh, Reacher(Cutter(2.0, 200.0)))[0].all()


@pytest.mark.thorough
def test_contacts_without_a_free_axis_are_left_out_and_the_pass_goes_on_behind_them(monkeypatch):
    """The holder gets to the ends of the slot's floor, by leaning out of them, and not to its middle."""
    take_nodes(monkeypatch, FEW)
    outcome = milled(slot(14.0, 40.0, 100.0), cutter="ball:6:12", holder="24x60", passes="planes")
    (held,) = [one for one in outcome.findings if one.code == "no-free-axis"]
    assert held.value > 0 and "left out" in held.text
    at_floor = (np.abs(outcome.offset.point[:, 2] - 10.0) < 1e-6) & (np.abs(outcome.offset.point[:, 0]) < 4.0)
    along = outcome.offset.point[at_floor, 1]
    assert len(along) and not ((along > 40.0) & (along < 60.0)).any()
    assert "overcut" not in {one.code for one in job.prove(outcome).findings}


@pytest.mark.usefixtures("some_nodes")
def test_where_no_axis_is_free_at_all_an_error_says_so():
    mesh = slot(5.0, 40.0, 60.0)
    inside = (np.abs(mesh.vertex[mesh.face].mean(axis=1)[:, 0]) < 2.6) & (
        mesh.vertex[mesh.face].mean(axis=1)[:, 2] > 5.0
    )
    with pytest.raises(ReachError, match="too tight for the cutter; use a smaller one"):
        job.make(build_settings("mill", "part", OPTIONS), mesh=mesh, faces=inside)


def test_a_machine_of_one_rotary_axis_is_refused_by_name(tmp_path):
    save_machine(table_a(), tmp_path / "table_a.fcm")
    with pytest.raises(SettingsError, match=r"auto turns two rotary axes, machine table_a has fewer"):
        milled(block(), machine=str(tmp_path / "table_a.fcm"))
