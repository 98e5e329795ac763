# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes that keep off the machine: beside closed forms, beside every pose by turns of their own, and in
programs of `auto`."""

import math
from dataclasses import replace

import numpy as np
import pytest
from mesh_shapes import box
from plain import build_settings
from test_axis_field import NODES, take_nodes
from test_machine_bodies import (
    EXAMPLE,
    LENGTH,
    NOSE,
    ORIGIN,
    RADIUS,
    TOOL,
    carriers,
    frames,
    joints_at,
    program_of,
)

from freecad_fiveaxis.core.geometry.convex import Poses, convex_hull, find_gaps
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge import machine_in_pose as module
from freecad_fiveaxis.core.gouge.carried_pieces import _tool_piece
from freecad_fiveaxis.core.gouge.machine_check import InMachine, check_machine
from freecad_fiveaxis.core.gouge.machine_in_pose import machine_in_pose
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import (
    Setup,
    chain,
    forward,
    inverse_axis,
    joint_words,
    q_to_words,
    words_to_q,
)
from freecad_fiveaxis.core.pipeline import job, mill_context
from freecad_fiveaxis.core.studies.reach_map import reach_map
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import Body, frustum_piece, grow_body

FAR = facet_tree(from_triangles(box((900, 900, 900), (901, 901, 901))))
"""A part that is nowhere near."""


def standing(machine, length=LENGTH, setup=None, margin=0.0):
    setup = Setup(ORIGIN, LENGTH) if setup is None else setup
    return machine_in_pose(
        InMachine(machine, setup, chain(machine, setup), TOOL, length), None, 0.01, margin=margin
    )


def leaning(degrees):
    """Unit axes (n, 3) that lean towards +X."""
    angle = np.deg2rad(degrees)
    return np.stack([np.sin(angle), np.zeros(len(angle)), np.cos(angle)], axis=1)


def wall(carrier, x=25.0):
    """A wall across X beside the work zero."""
    low, high = np.array([x, -400.0, -300.0]) + ORIGIN, np.array([x + 60.0, 400.0, 600.0]) + ORIGIN
    return MachineBody("wall", carrier, "box", (tuple(low), tuple(high)))


def test_directions_that_lean_into_a_wall_on_the_table_are_not_free_and_those_away_are():
    """A holder of 15 mm from 40 to 80 mm above a tip that stands 25 mm beside a wall: in closed form it
    touches where 80 sin + 15 cos is 25. Nothing is known of the tool's length, and need not be."""
    machine = replace(load_machine("trunnion_ac"), bodies=(wall("C"),))
    lean = np.linspace(-60.0, 60.0, 241)
    axis = leaning(lean)
    reach = np.max([h * axis[:, 0] + 15.0 * axis[:, 2] for h in (40.0, LENGTH)], axis=0)
    hits = standing(machine, None).hits(TOOL, FAR, np.zeros_like(axis), axis, 0.01)
    sure = np.abs(reach - 25.0) > 0.05
    assert sure.sum() > 235 and (hits == (reach > 25.0))[sure].all() and hits[-1] and not hits[0]
    thick = standing(machine, None, margin=2.0).hits(TOOL, FAR, np.zeros_like(axis), axis, 0.01)
    assert (thick == (reach + 2.0 > 25.0))[np.abs(reach - 23.0) > 0.05].all()


def test_one_branch_is_enough_and_a_limit_takes_it_away():
    """On a head that leans by B the wall of the base stands on one side: the other branch turns the table and
    leans away from it."""
    plain = load_machine("head_b_table_c")
    head = next(axis for axis in plain.axes if axis.letter == "B")
    machine = replace(plain, bodies=(wall("base"),))
    setup = Setup(ORIGIN, LENGTH)
    axis = leaning([-50.0, 50.0])
    angles, _ = inverse_axis(chain(plain, setup), axis)
    one = standing(machine, setup=setup)
    by_branch = np.array([one.is_blocked(np.zeros((2, 3)), axis, branch) for branch in angles])
    assert (by_branch.sum(axis=0) == 1).all(), "one branch leans into the wall, the other one away from it"
    assert not one.hits(TOOL, FAR, np.zeros((2, 3)), axis, 0.01).any()
    into = angles[:, 0, 1][by_branch[:, 0]][0]
    limits = (-0.1, 1.6) if into > 0.0 else (-1.6, 0.1)
    axes = tuple(replace(one, low=limits[0], high=limits[1]) if one is head else one for one in machine.axes)
    assert (
        standing(replace(machine, axes=axes), setup=setup).hits(TOOL, FAR, np.zeros((2, 3)), axis, 0.01).all()
    )


def brute(machine, words, body, tool):
    """Gaps (n,) mm, by convex.py, of the tool's pieces and what the spindle carries to a box in every pose,
    with turns of the test's own; below 0: they are in each other."""
    tip = np.array(machine.gauge_point) - (0.0, 0.0, LENGTH)
    corner = np.array(np.meshgrid(*np.array(body.points).T, indexing="ij")).reshape(3, -1).T
    carried, tool_at = frames(machine, joints_at(machine, words))
    seen = np.linalg.inv(carried[body.carrier]) @ tool_at
    turn, place = seen[:, :3, :3], seen[:, :3, 3]
    none, up = np.zeros(len(words)), np.tile((0.0, 0.0, 1.0), (len(words), 1))
    gaps = [
        find_gaps(
            _tool_piece(piece, tuple(tip)), convex_hull(corner), Poses(turn, place), 0.0, none + 1e9, up
        )
        for piece in tool.pieces
    ]
    return np.min([np.where(gap.met, -1.0, gap.least) for gap in gaps], axis=0)


STACK = Body((*TOOL.pieces, frustum_piece(LENGTH, 35.0, LENGTH + 60.0, 35.0, 3)))


@pytest.mark.parametrize("name", ["trunnion_ac", "head_b_table_c", "fork_head_bc"])
def test_every_pose_is_reported_as_the_shortest_ways_between_the_pieces_tell_it(name):
    """Random boxes on each carrier, random places and axes: a pose that a tool smaller by 0.1 mm hits is
    blocked, one that keeps 0.1 mm off is not."""
    rng, plain = np.random.default_rng(3), load_machine(name)
    blocked = free = 0
    for carrier in carriers(plain) * 3:
        middle, half = rng.uniform(-60, 60, 3) + ORIGIN, rng.uniform(10, 40, 3)
        body = MachineBody("box", carrier, "box", (tuple(middle - half), tuple(middle + half)))
        machine = replace(plain, bodies=(body, NOSE))
        words = np.concatenate([rng.uniform(-60, 60, (80, 3)), rng.uniform(-80, 80, (80, 2))], axis=1)
        q = words_to_q(words)
        tip, axis = forward(chain(machine, Setup(ORIGIN, LENGTH)), q)
        reported = standing(machine).is_blocked(tip, axis, q[:, 3:])
        smaller = Body(tuple(one._replace(low_radius=max(one.low_radius - 0.1, 0.0), high_radius=max(one.high_radius - 0.1, 0.0),
                                          round=max(one.round - 0.1, 0.0)) for one in STACK.pieces))  # fmt: skip
        assert reported[brute(machine, words, body, smaller) < 0.0].all(), carrier
        assert not reported[brute(machine, words, body, grow_body(STACK, 0.1)) > 0.0].any(), carrier
        blocked, free = blocked + reported.sum(), free + (~reported).sum()
    assert blocked > 20 and free > 40


def test_an_axis_that_is_not_locked_would_be_noticed(monkeypatch):
    monkeypatch.setattr(module, "find_locked_letters", lambda machine, body: "")
    with pytest.raises(AssertionError):
        test_every_pose_is_reported_as_the_shortest_ways_between_the_pieces_tell_it("trunnion_ac")


def test_directions_of_mixed_up_lengths_would_be_noticed(monkeypatch):
    """As they were once: sorted, but with the lengths of before."""
    monkeypatch.setattr(module, "WAYS", module.WAYS * np.linspace(0.5, 1.5, 26)[:, None])
    with pytest.raises(AssertionError):
        test_every_pose_is_reported_as_the_shortest_ways_between_the_pieces_tell_it("trunnion_ac")


@pytest.mark.thorough
@pytest.mark.parametrize("length", [LENGTH, None])
def test_poses_are_reported_as_the_check_of_the_finished_program_tells_them(length):
    """All bodies of trunnion_with_bodies, and these against each other: a program that stands
    still in the pose."""
    rng, machine, setup = np.random.default_rng(8), load_machine(str(EXAMPLE)), Setup((0.0, 0.0, -40.0), 45.0)
    kinematics = chain(machine, setup)
    tip, axis = rng.uniform(-60, 60, (20, 3)), rng.normal(size=(20, 3))
    axis = np.abs(axis) / np.linalg.norm(axis, axis=1)[:, None]
    angles, _ = inverse_axis(kinematics, axis)
    given = InMachine(machine, setup, kinematics, TOOL, None if length is None else 45.0)
    part = from_triangles(box((-200, -20, -40), (-195, 20, 100)))
    reported = machine_in_pose(given, part, 0.01).is_blocked(tip, axis, angles[0])
    words = q_to_words(joint_words(kinematics, tip, angles[0]))
    for k, word in enumerate(words):
        found = check_machine(given, program_of(machine, np.array([word, word])), part, 0.01)
        hits = {
            one.hit.enters
            for one in found
            if one.hit is not None and (one.hit.enters, one.hit.entered) != ("spindle", "")
        }
        assert bool(hits) == reported[k], (word, hits)
    assert 3 < reported.sum() < 17


def test_at_the_pole_the_tool_is_free_whatever_its_neighbours_turn_the_table_to():
    """Upright beside a wall of the base: 20 mm from the table's middle the holder of 15 mm may come to 35 mm
    from it."""
    machine, setup = load_machine("trunnion_ac"), Setup((0.0, 0.0, 0.0), LENGTH)
    tip, up = np.array([[20.0, 0.0, 0.0]]), np.array([[0.0, 0.0, 1.0]])
    for x, met in ((34.0, True), (36.0, False)):
        low, high = (-400.0, -x - 60.0, -400.0), (400.0, -x, 600.0)
        one = replace(machine, bodies=(MachineBody("wall", "base", "box", (low, high)),))
        assert standing(one, setup=setup).hits(TOOL, FAR, tip, up, 0.01)[0] == met
        assert not standing(one, setup=setup).is_blocked(tip, up, np.array([[0.0, 0.0]]))[0]


PART = from_triangles(box((-30, -20, -90), (30, 20, -50)))
MILL = {
    "machine": str(EXAMPLE),
    "cutter": "ball:6:25",
    "passes": "scallop",
    "stepover": 6,
    "tool_axis": "auto",
    "spindle": "off",
}


def milled(**options):
    return job.prove(job.make(build_settings("mill", "part", {**MILL, **options}), mesh=PART))


@pytest.mark.thorough
def test_a_part_on_the_trunnion_is_cut_free_of_its_bodies_where_the_spindle_hit_the_platter(monkeypatch):
    """With a stub of a tool the spindle went into the platter beside the part; now nothing is hit, and all is
    cut."""
    take_nodes(monkeypatch, NODES)
    free = milled(tool_length=45)
    codes = {one.code for one in free.findings}
    assert not codes & {"machine-collision", "facets-without-free-axis", "no-free-axis", "no-way-out"}
    monkeypatch.setattr(mill_context, "bodies_in_pose", lambda *given: None)
    (hit,) = [one for one in milled(tool_length=45).findings if one.code == "machine-collision"]
    assert hit.value > 5.0 and hit.hit.entered == "platter"


@pytest.mark.slow
def test_what_no_axis_frees_of_the_machine_is_reported_by_its_area_and_what_a_longer_tool_would_free(
    monkeypatch,
):
    """A wall on the platter 12 mm beside one side of the part, as high as the clearance: a spindle as near to
    the tip finds no room there."""
    take_nodes(monkeypatch, NODES)
    plain = load_machine(str(EXAMPLE))
    machine = replace(
        plain, bodies=(*plain.bodies, MachineBody("wall", "C", "box", ((42, -80, -100), (60, 80, -20))))
    )
    monkeypatch.setattr("freecad_fiveaxis.core.pipeline.options.load_machine", lambda name: machine)
    found = milled(tool_length=27).findings
    assert not [one for one in found if one.code == "machine-collision"]
    (one,) = [one for one in found if one.code == "facets-without-free-axis"]
    assert one.value == pytest.approx(40.0 * 40.0, rel=0.5) and "the machine is in the way" in one.text
    assert "Most of that is blocked by wall." in one.text
    assert "farther an axis is free" in one.text


@pytest.mark.oldest
@pytest.mark.thorough
def test_where_a_machine_has_no_bodies_nothing_is_requested_and_bodies_far_away_change_no_byte(monkeypatch):
    take_nodes(monkeypatch, NODES)
    plain, far = (
        load_machine("trunnion_ac"),
        MachineBody("far", "base", "box", ((900, 900, 900), (950, 950, 950))),
    )
    result = []
    for bodies in ((), (far,)):
        machine = replace(plain, bodies=bodies)
        monkeypatch.setattr(
            "freecad_fiveaxis.core.pipeline.options.load_machine", lambda name, machine=machine: machine
        )
        result.append(job.make(build_settings("mill", "part", {**MILL, "machine": "trunnion_ac"}), mesh=PART))
        monkeypatch.setattr(module.MachineInPose, "hits", None)  # with bodies it is asked
        if bodies == ():
            monkeypatch.undo()
            take_nodes(monkeypatch, NODES)
    assert result[0].nc == result[1].nc


@pytest.mark.thorough
@pytest.mark.oldest
def test_the_reach_map_tells_where_the_machine_is_in_the_way_and_a_longer_tool_helps():
    """A wall of the table 12 mm beside a block: the nose of a spindle close above a short tool hits it, over
    a longer one it does not."""
    mesh = from_triangles(box((-20, -20, 0), (20, 20, 40)))
    bodies = (MachineBody("wall", "C", "box", ((32, -80, 0), (50, 80, 70))), replace(NOSE, radii=(35.0,)))
    machine, setup = replace(load_machine("trunnion_ac"), bodies=bodies), Setup((0.0, 0.0, 0.0), 30.0)
    cutter = Cutter(2.0 * RADIUS, 30.0)
    reacher = Reacher(cutter, kinematics=chain(machine, setup), most=math.radians(60.0), table=0.0)
    given = InMachine(machine, setup, reacher.kinematics, reacher.body, 30.0)
    found = reach_map(mesh, replace(reacher, machine=machine_in_pose(given, mesh, 0.01)))
    beside = (found.point[:, 0] > 19.9) & (found.point[:, 2] > 8.0) & (found.point[:, 2] < 25.0)
    assert (found.obstacle[beside] == Obstacle.MACHINE).all() and beside.any()
    assert (found.obstacle[found.point[:, 0] < -19.9] != Obstacle.MACHINE).all()
    assert reach_map(mesh, reacher).area_of(Obstacle.MACHINE) == 0.0
    assert found.longer and found.longer[-1][1] > 0.25 * found.area_of(Obstacle.MACHINE)
