# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links, retracts and rewinds go round bodies of the machine: by the proof of the finished program, by dense
samples of the joints' way with turns of their own, and by the height that a closed form gives."""

from dataclasses import replace

import numpy as np
import pytest
from mesh_shapes import box, sphere
from plain import build_settings
from test_machine_bodies import LENGTH, frames, joints_at, skin_of

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.links.raise_links import FINE, find_gaps, raise_links
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import forward
from freecad_fiveaxis.core.motion.joint_path.rewind import ROUND
from freecad_fiveaxis.core.pipeline import job, milling, options, round_bodies
from freecad_fiveaxis.core.toolpath.cl_path import Motion

RADIUS, LONG, TOP = 3.0, 25.0, 10.0
PADS = from_triangles(np.concatenate([box((-40, -15, 0), (-15, 15, TOP)), box((15, -15, 0), (40, 15, TOP))]))
MILL = {
    "cutter": "ball:6:25",
    "passes": "planes",
    "stepover": 6,
    "max_axis_angle": 60,
    "spindle": "off",
    "tool_length": LENGTH,
    "gouge": "report",  # what stays uncut is not looked for
}
UPRIGHT, LEANING = {"tool_axis": "fixed", "max_axis_angle": 10}, {"tool_axis": "facet_mean", "lead": 8}


def slope(left, right, low, high):
    """A box whose top rises from ``low`` at its left side to ``high`` at its right one."""
    facets = np.array(box((left, -15, 0), (right, 15, 1)), float)
    top = low + (facets[..., 0] - left) / (right - left) * (high - low)
    facets[..., 2] = np.where(facets[..., 2] > 0.5, top, 0.0)
    return facets


SLOPES = from_triangles(np.concatenate([slope(-40, -10, 9, 12), slope(10, 40, 12, 9)]))
NOSE = MachineBody("nose", "spindle", "cylinder", ((0.0, 0.0, 0.0), (0.0, 0.0, 60.0)), (35.0,))


def post(top, half=2.0):
    """A clamp between the pads, on whatever carries the part."""
    return (-half, -30.0, -50.0), (half, 30.0, top)


def with_post(monkeypatch, name, top, rest=(), half=2.0):
    """The machine with a post, and what else the function ``rest`` of the part's carrier gives."""
    plain = load_machine(name)
    carrier = next((one.letter for one in plain.fitted if one.side == "table"), "base")
    low, high = (tuple(np.add(plain.origin, corner)) for corner in post(top, half))
    machine = replace(plain, bodies=(MachineBody("post", carrier, "box", (low, high)), *rest))
    monkeypatch.setattr(options, "load_machine", lambda name: machine)
    monkeypatch.setattr(job, "load_machine", lambda name: machine)
    return machine


def milled(machine, mesh=PADS, **more):
    return job.prove(
        job.make(build_settings("mill", "part", {**MILL, "machine": machine, **more}), mesh=mesh)
    )


def codes(result):
    return {one.code for one in result.findings}


def left_as_they_were(monkeypatch):
    stages = tuple(one for one in milling.STAGES if one is not round_bodies.keep_links_off_bodies)
    monkeypatch.setattr(milling, "STAGES", stages)


def sampled_depth(machine, program, body, count=24):
    """How deep a point of the surface of the box ``body`` is in the cutter at most, on the straight way of the
    joints of every link and rapid: seen from the tool, by points on a grid."""
    tip = np.array(machine.gauge_point) - (0.0, 0.0, LENGTH)
    grid, corner = skin_of(body, 25), skin_of(body, 2)
    rows, share = 1 + np.flatnonzero(program.motion[1:] >= Motion.LINK), np.linspace(0.0, 1.0, count)
    before = program.words[rows - 1]
    words = before[:, None] + share[:, None] * (program.words[rows] - before)[:, None]
    carried, tool = frames(machine, joints_at(machine, words.reshape(-1, 5), machine.origin))
    seen = np.linalg.inv(tool) @ carried[body.carrier]
    turn, away = seen[:, :3, :3].swapaxes(1, 2), seen[:, None, :3, 3] - tip
    about = corner @ turn + away
    apart = (about.min(axis=1) > (RADIUS, RADIUS, LONG)) | (about.max(axis=1) < (-RADIUS, -RADIUS, 0.0))
    deepest = 0.0
    for k in np.flatnonzero(
        ~apart.any(axis=1)
    ):  # the box that holds it is not off the one that holds the tool
        off = grid @ turn[k] + away[k]
        across, height = np.hypot(off[:, 0], off[:, 1]), off[:, 2]
        shank = np.minimum(RADIUS - across, np.minimum(height - RADIUS, LONG - height))
        ball = RADIUS - np.hypot(across, height - RADIUS)
        deepest = max(deepest, float(np.maximum(shank, ball).max()))
    return deepest


def test_the_gaps_of_a_path_are_found_with_a_rewind_and_a_link_near_the_part_among_them():
    """The way in, a cut, a rewind, a cut, a near link, a cut and the way out."""
    cut, link, rapid = Motion.CUT, Motion.LINK, Motion.RAPID
    motion = np.array([rapid, rapid, link, cut, *ROUND, cut, link, link, link, cut, link, rapid], np.int8)
    gaps = find_gaps(motion)
    assert gaps.begin.tolist() == [0, 4, 12, 16] and gaps.end.tolist() == [2, 11, 15, 18]
    assert gaps.out.tolist() == [0, 5, 12, 17] and gaps.back.tolist() == [1, 10, 15, 18]
    assert gaps.opens.tolist() == [True, False, False, False]
    assert gaps.closes.tolist() == [False, False, False, True]


@pytest.mark.parametrize(
    ("name", "stand"),
    [
        ("trunnion_ac", UPRIGHT),
        ("trunnion_ac", LEANING),
        ("head_b_table_c", LEANING),
        ("fork_head_bc", LEANING),
        pytest.param("nutating_table_b45", LEANING, marks=pytest.mark.slow),
    ],
)
def test_links_that_hit_a_clamp_go_over_it(monkeypatch, name, stand):
    """Cutting is free of it, the way over the part is not; the proof of the program and dense samples of its
    words say the same of both."""
    machine = with_post(monkeypatch, name, 30.0)
    free = milled(name, **stand)
    assert not codes(free) & {"machine-collision", "machine-unproven", "no-way-round", "rapid-collision"}
    assert "links-raised" in codes(free)
    assert sampled_depth(machine, free.draft.program, machine.bodies[0]) < 0.01
    left_as_they_were(monkeypatch)
    old = milled(name, **stand)
    assert "machine-collision" in codes(old)
    assert sampled_depth(machine, old.draft.program, machine.bodies[0]) > 1.0
    cuts = [one.draft.program.words[one.draft.program.motion == Motion.CUT] for one in (free, old)]
    np.testing.assert_array_equal(*cuts)


def test_an_upright_tool_goes_as_high_as_the_clamp_and_the_clearance_over_it(monkeypatch):
    with_post(monkeypatch, "trunnion_ac", 40.0)
    program = milled("trunnion_ac", **UPRIGHT, clearance=7).draft.program
    assert 47.0 - 0.01 <= program.words[:, 2].max() <= 47.0 + FINE


def test_rapids_of_independent_axes_go_over_the_clamp_too(monkeypatch):
    with_post(monkeypatch, "trunnion_ac", 40.0)
    free = milled("trunnion_ac", **UPRIGHT, rapids="independent")
    assert not codes(free) & {"machine-collision", "machine-unproven"} and "links-raised" in codes(free)


@pytest.mark.oldest
@pytest.mark.thorough
def test_where_the_travel_ends_it_is_reported_how_much_is_missing(monkeypatch):
    """A clamp 700 mm high, and with the tool of 80 mm the word of Z goes to 420 mm."""
    with_post(monkeypatch, "trunnion_ac", 700.0)
    reported = milled("trunnion_ac", **UPRIGHT)
    (one,) = [each for each in reported.findings if each.code == "no-way-round"]
    assert "machine-collision" in codes(reported) and "links-raised" not in codes(reported)
    assert 280.0 - 0.01 <= one.value <= 280.0 + FINE
    assert "Z would have to go 280" in one.text and "higher than its limit 420 mm" in one.text


@pytest.mark.oldest
@pytest.mark.thorough
def test_where_a_longer_tool_would_help_it_is_reported_by_how_much(monkeypatch):
    """Beside a tower the spindle hits at every height that the tower has; 30 mm of tool more is above it."""
    nose = MachineBody("nose", "spindle", "cylinder", ((0.0, 0.0, 0.0), (0.0, 0.0, 60.0)), (35.0,))
    tower = MachineBody("tower", "C", "box", ((60.0, -30.0, -100.0), (90.0, 30.0, 110.0)))
    with_post(monkeypatch, "trunnion_ac", 40.0, (nose, tower))
    (one,) = [each for each in milled("trunnion_ac", **UPRIGHT).findings if each.code == "no-way-round"]
    assert one.value is None and "With a tool that sticks out 20 mm farther there is a way." in one.text
    reported = codes(milled("trunnion_ac", **{**UPRIGHT, "tool_length": LENGTH + 20.0}))
    assert "links-raised" in reported and not reported & {"machine-collision", "no-way-round"}


def test_a_rewind_is_raised_as_links_are(monkeypatch):
    """Round a ball with C from -150 to 150 deg the tool rewinds. Where turning below Z 150 mm counts as a hit,
    every rapid that turns is at 150 mm or higher, and no cut has changed."""
    plain = load_machine("trunnion_ac")
    most = np.radians(150.0)
    axes = tuple(replace(one, low=-most, high=most) if one.letter == "C" else one for one in plain.axes)
    monkeypatch.setattr(options, "load_machine", lambda name: replace(plain, axes=axes))
    mesh = from_triangles(sphere(20.0))
    given = {**MILL, "machine": "trunnion_ac", "passes": "zlevel", "tool_axis": "facet_mean", "links": "over"}
    height = mesh.normal[:, 2]
    draft = job.make(build_settings("mill", "part", given), mesh=mesh, faces=(height > 0.5) & (height < 0.8))

    def hits(joints, rows, tool):
        turns = np.abs(np.diff(joints.q[:, 3], prepend=joints.q[0, 3])) > 1e-6
        low = np.minimum(joints.q[:, 2], np.append(joints.q[0, 2], joints.q[:-1, 2])) < 150.0 - 1e-9
        return (turns & low & (joints.path.motion == Motion.RAPID))[rows]

    old, kinematics = draft.joints, draft.kinematics
    every = np.arange(1, len(old.q))
    raised = raise_links(old, kinematics, hits, 5.0)
    new = raised.joints
    assert old.rewinds > 0 and hits(old, every, True).any()
    assert (raised.height > 0.0).all() and not hits(new, np.arange(1, len(new.q)), True).any()
    tip, axis = forward(kinematics, new.q)
    np.testing.assert_allclose(tip, new.path.tip, atol=1e-3)  # words are as printed
    np.testing.assert_allclose(axis, new.path.axis, atol=1e-4)
    cuts = [one.q[np.isin(one.path.motion, (Motion.CUT, Motion.FILL))] for one in (old, new)]
    np.testing.assert_array_equal(*cuts)
    reported = [(one.code, one.place) for one in new.findings if one.code == "rewind"]
    assert reported == [(one.code, one.place) for one in old.findings if one.code == "rewind"]


def test_without_bodies_or_where_nothing_is_hit_the_program_is_the_same(monkeypatch):
    plain = milled("trunnion_ac", **UPRIGHT).draft.nc
    with_post(monkeypatch, "trunnion_ac", TOP)
    assert milled("trunnion_ac", **UPRIGHT).draft.nc == plain


def test_a_check_that_sees_no_bodies_would_be_noticed(monkeypatch):
    machine = with_post(monkeypatch, "trunnion_ac", 30.0)
    monkeypatch.setattr(
        round_bodies.MachineBlocks,
        "which_hit",
        lambda self, program, blocks, tool: np.zeros(len(blocks), np.bool_),
    )
    blind = milled("trunnion_ac", **UPRIGHT)
    assert "machine-collision" in codes(blind)
    assert sampled_depth(machine, blind.draft.program, machine.bodies[0]) > 1.0


@pytest.mark.parametrize("name", ["trunnion_ac", "nutating_table_b45"])
def test_links_near_the_part_hold_the_tolerance_when_they_are_raised(monkeypatch, name):
    """They were divided for where they were: higher up a link at feed would swing farther."""
    with_post(monkeypatch, name, 40.0, half=1.0)
    more = {**LEANING, "links": "near", "linearize": "on", "max_axis_angle": 50, "clearance": 40}
    outcome = milled(name, mesh=SLOPES, **more)
    assert "links-raised" in codes(outcome) and "deviation-over-tolerance" not in codes(outcome)
    raised = outcome.draft.program.words[:, 2] > 60.0
    assert raised.any() and (outcome.draft.program.motion[np.flatnonzero(raised)[1:]] == Motion.RAPID).all()


def test_a_longer_tool_for_which_the_axis_has_no_travel_is_no_way(monkeypatch):
    """Its nose would stand over the tower; but Z ends where this tool just reaches the cuts."""
    tower = MachineBody("tower", "C", "box", ((60.0, -30.0, -100.0), (90.0, 30.0, 110.0)))
    machine = replace(load_machine("trunnion_ac"), bodies=(NOSE, tower))
    axes = tuple(replace(one, high=100.0) if one.letter == "Z" else one for one in machine.axes)
    for module in (job, options):
        monkeypatch.setattr(module, "load_machine", lambda name: replace(machine, axes=axes))
    (reported,) = (one for one in milled("trunnion_ac", **UPRIGHT).findings if one.code == "no-way-round")
    assert "farther" not in reported.text


def test_what_is_missing_is_counted_from_the_limit_where_the_path_is_beyond_it(monkeypatch):
    machine = with_post(monkeypatch, "trunnion_ac", 40.0)
    axes = tuple(replace(one, high=90.0) if one.letter == "Z" else one for one in machine.axes)
    monkeypatch.setattr(job, "load_machine", lambda name: replace(machine, axes=axes))
    monkeypatch.setattr(options, "load_machine", lambda name: replace(machine, axes=axes))
    outcome = milled("trunnion_ac", **UPRIGHT)
    (reported,) = (one for one in outcome.findings if one.code == "no-way-round")
    above = outcome.draft.program.words[:, 2].max() - outcome.draft.kinematics.high[2]
    assert above > 5.0 and reported.value > above + 20.0


@pytest.mark.oldest
@pytest.mark.thorough
def test_what_blocks_an_axis_is_the_body_though_fixtures_stand_about_the_part(monkeypatch):
    """The part is the part: not the hull about it and all that holds it."""
    roof = MachineBody("roof", "C", "box", ((-0.5, -30.0, 11.5), (45.0, 30.0, 14.0)))
    ram = MachineBody("ram", "spindle", "box", ((-10.0, -10.0, 0.0), (10.0, 10.0, 100.0)))
    machine = replace(load_machine("trunnion_ac"), bodies=(roof, ram))
    monkeypatch.setattr(job, "load_machine", lambda name: machine)
    monkeypatch.setattr(options, "load_machine", lambda name: machine)
    part = from_triangles(np.concatenate([box((-20, -10, 0), (-4, 10, 10)), box((4, -10, 0), (20, 10, 10))]))
    walls = tuple(
        Fixture(name, from_triangles(box((at, -30, 0), (at + 4, 30, 60))))
        for name, at in (("left", -64), ("right", 60))
    )
    given = {**MILL, "machine": "trunnion_ac", "tool_axis": "auto", "tool_length": 40.0, "stepover": 4}
    for fixtures in ((), walls):
        outcome = job.make(build_settings("mill", "part", given), mesh=part, fixtures=fixtures)
        assert any("blocked by roof" in one.text for one in outcome.findings)
