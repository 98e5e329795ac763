# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool in all places of its way out at once: the same as looking at each of them, and what `auto` makes
of that."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from gouge_examples import blade_beside_hub, bowl_block, step
from test_axis_field import NODES as FEW
from test_axis_field import take_nodes, trunnion
from test_facets_with_axis import milled
from test_reach_map import profile
from thorough import some_in_core

from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge.obstacles import Reacher, within_limits
from freecad_fiveaxis.core.gouge.overhang import is_under
from freecad_fiveaxis.core.gouge.search import which_enter
from freecad_fiveaxis.core.gouge.swept_motion import ways_up
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.orientation import contacts as contacts_module
from freecad_fiveaxis.core.orientation.auto_axis import Free, select_rows_with_way_out
from freecad_fiveaxis.core.orientation.axis_field import NODES
from freecad_fiveaxis.core.orientation.contacts import Contacts
from freecad_fiveaxis.core.passes import axes_within_limits, turns_within_limits, with_room
from freecad_fiveaxis.core.passes import within_limits as limits_module
from freecad_fiveaxis.core.tool import Cutter, parse_cutter
from freecad_fiveaxis.core.tool.body import body_of, depth_of, extend_way_out

BODIES = {
    "ball": body_of(Cutter(6.0, 20.0)),
    "bull": body_of(parse_cutter("bull:10:2:30")),
    "thinner shank": body_of(Cutter(8.0, 5.0), ((4.0, 30.0),), ((30.0, 10.0), (20.0, 20.0))),
}
UP = np.array([0.0, 0.0, 1.0])


def on_way(body, point, far):
    """The largest depth (n,) of the points in the body at any of 2000 places of its way out."""
    return np.max([depth_of(body, t * UP, UP, point) for t in np.linspace(0.0, far, 2000)], axis=0)


@pytest.mark.parametrize("name", BODIES)
def test_a_body_drawn_out_holds_the_points_that_it_holds_anywhere_on_its_way(name):
    body, random = BODIES[name], np.random.default_rng(5)
    point = random.uniform((-20, -20, -5), (20, 20, 60), (3000, 3))
    at_once, one_by_one = (
        depth_of(extend_way_out(body, 50.0), np.zeros(3), UP, point),
        on_way(body, point, 50.0),
    )
    clear = np.abs(one_by_one) > 0.05
    assert ((at_once > 0.0) == (one_by_one > 0.0))[clear].all()
    assert (at_once > 0.0).any() and (at_once < 0.0).any()
    standing = depth_of(body, np.zeros(3), UP, point)
    assert ((standing > 0.0) != (one_by_one > 0.0)).any(), "a body that stays where it is would be noticed"


@pytest.mark.parametrize(("name", "count"), [("ball", 2), ("bull", 2), ("thinner shank", 6)])
def test_a_cutters_end_is_no_piece_of_its_own_in_a_body_drawn_out(name, count):
    body, random = BODIES[name], np.random.default_rng(6)
    drawn = extend_way_out(body, 50.0)
    assert len(drawn.pieces) == count
    point = random.uniform((-20, -20, -5), (20, 20, 110), (3000, 3))
    for part in {piece.part for piece in body.pieces}:
        all_over, standing = (depth_of(one.only(part), np.zeros(3), UP, point) for one in (drawn, body))
        assert (all_over >= standing).all(), "what is left out is nowhere deeper"


@pytest.mark.parametrize(
    "part", [lambda: step(6.0), lambda: bowl_block(11.0, cells=16), lambda: blade_beside_hub(cells=16)]
)
def test_what_is_under_the_part_is_what_enters_on_its_way_up(part):
    mesh, random = part(), np.random.default_rng(2)
    tree, cutter = facet_tree(mesh), body_of(Cutter(4.0, 12.0))
    tip = random.uniform(*mesh.box, (300, 3))
    axis = random.normal(size=(300, 3))
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    far = np.full(300, 2.0 * np.ptp(mesh.vertex, axis=0).sum())
    swept = which_enter(cutter, tree, ways_up(tip, axis, far), 0.01, np.arange(300))
    under = is_under(cutter, tree, tip, axis, 0.01)
    assert (under == swept).all() and under.any() and not under.all()


def t_slot():
    """A slot 10 mm wide at its mouth and 26 mm wide below, its ends open."""
    outline = [
        (-30, 0),
        (30, 0),
        (30, 40),
        (5, 40),
        (5, 25),
        (13, 25),
        (13, 10),
        (-13, 10),
        (-13, 25),
        (-5, 25),
        (-5, 40),
        (-30, 40),
    ]
    return profile(np.array(outline, float), 60.0)


@pytest.mark.thorough
@some_in_core("nodes", [FEW, NODES])
def test_what_lies_under_a_lip_is_left_out_and_not_lifted_over_the_part(nodes, monkeypatch):
    """The ball stands freely at the sides of the slot's floor, under its lips, but nothing can be drawn out
    within 25 deg."""
    take_nodes(monkeypatch, nodes)
    result = milled(t_slot(), cutter="ball:6:8", max_axis_angle=25, passes="planes", stepover=3.0)
    codes = {one.code: one for one in result.findings}
    assert codes["no-way-out"].value > 50.0 and "get out along its axis" in codes["no-way-out"].text
    lifted = codes["lifted"].value if "lifted" in codes else 0.0
    assert lifted < 3.0, "more than out of a corner"
    floor = np.isclose(result.offset.point[:, 2], 10.0) & (np.abs(result.offset.point[:, 0]) < 20.0)
    assert floor.any() and (np.abs(result.offset.point[floor, 0]) < 9.0).all()


def test_only_what_lies_between_ways_out_is_kept():
    none, standing, out = (int(one) for one in Free)
    free = np.array([standing, out, standing, out, standing, standing, standing, out, out, standing])
    polyline = np.array([0, 0, 0, 0, 0, 1, 1, 2, 2, 2])
    assert select_rows_with_way_out(free, polyline).tolist() == [1, 2, 3, 7, 8]
    assert not len(select_rows_with_way_out(free[:0], polyline[:0]))
    assert not len(select_rows_with_way_out(np.full(3, standing), np.zeros(3, np.int64))) and none == 0


def test_a_contact_is_free_where_all_its_rows_are_and_none_is_requested_in_vain(monkeypatch):
    random, wanted_rows = np.random.default_rng(3), []
    contact = np.append(
        np.repeat(np.arange(200), random.integers(1, 5, 200)), 0
    )  # the end of a closed pass is its start
    n, first = len(contact), np.unique(contact, return_index=True)[1]
    stand, normal, fits = random.normal(size=(n, 3)), np.tile(UP, (n, 1)), random.random(n) < 0.95
    normal[random.random(n) < 0.1] = -UP
    known = Contacts(stand[first], first, first, normal[first], contact, stand, normal, fits)

    def answered(_reacher, _tree, stand, *_):
        wanted_rows.append(len(stand))
        return stand[:, 0] > -0.5

    monkeypatch.setattr(contacts_module, "are_free", answered)
    wanted = random.random(200) < 0.8
    free = known.free(np.tile(UP, (200, 1)), wanted, SimpleNamespace(cutter=Cutter(6.0)), None, None)
    row_free = (stand[:, 0] > -0.5) & fits & (normal[:, 2] > 0)
    assert free.tolist() == [bool(wanted[k] and row_free[contact == k].all()) for k in range(200)]
    maybe = [k for k in range(200) if wanted[k] and (fits & (normal[:, 2] > 0))[contact == k].all()]
    assert wanted_rows == [len(maybe), sum((contact == k).sum() - 1 for k in maybe if row_free[first[k]])]


def test_axes_keep_room_to_the_limits_and_their_turns_are_requested_too():
    kinematics = trunnion(60.0)
    narrow = with_room(kinematics, math.radians(2.0))
    lean = np.radians([57.9, 58.1, 60.1])
    axis = np.stack([np.sin(lean), 0.0 * lean, np.cos(lean)], axis=1)
    assert axes_within_limits(narrow, axis).tolist() == [True, False, False]
    assert axes_within_limits(kinematics, axis).tolist() == [True, True, False]
    one = np.array([[np.sin(1.0), 0.0, np.cos(1.0)]] * 2)
    near, opposite = np.array([np.cos(0.1), np.sin(0.1)]), np.array([-1.0, 0.0])
    other = np.array([[*(np.sin(1.0) * way), np.cos(1.0)] for way in (near, opposite)])
    assert turns_within_limits(kinematics, one, other).all(), "over the pole all is within"
    below = trunnion(120.0)
    lean = np.array([[np.sin(2.0), 0.0, np.cos(2.0)], [*(np.sin(2.0) * near), np.cos(2.0)]])
    assert turns_within_limits(below, lean[:1], lean[1:]).all()
    assert not turns_within_limits(below, lean[:1], lean[:1] * (-1.0, 1.0, 1.0)).any(), "straight through -Z"


def test_the_largest_axis_angle_counts_as_a_limit():
    axis = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.8, 0.0, -0.6]])
    assert within_limits(Reacher(Cutter(6.0)), axis).all()
    assert within_limits(Reacher(Cutter(6.0), most=math.pi / 2), axis).tolist() == [True, True, False]


def turns_by_dense_samples(name, count=20_000):
    """What is told of random turns up to 100 deg between axes that lean 70 deg and more, within the limits,
    and what 300 places of each say."""
    machine = load_machine(name)
    kinematics, rng = chain(machine, Setup(machine.origin)), np.random.default_rng(3)
    one, other = (
        vector / np.linalg.norm(vector, axis=1)[:, None] for vector in rng.normal(size=(2, count, 3))
    )
    kept = (one * other).sum(axis=1) > math.cos(math.radians(100.0))
    kept &= np.maximum(one[:, 2], other[:, 2]) < math.cos(math.radians(70.0))
    kept &= axes_within_limits(kinematics, one) & axes_within_limits(kinematics, other)
    one, other = one[kept], other[kept]
    angle = np.arccos((one * other).sum(axis=1))[:, None]
    dense = np.ones(len(one), np.bool_)
    for share in np.linspace(0.0, 1.0, 300):
        between = (np.sin((1.0 - share) * angle) * one + np.sin(share * angle) * other) / np.sin(angle)
        dense &= axes_within_limits(kinematics, between)
    return turns_within_limits(kinematics, one, other), dense


@pytest.mark.parametrize("name", ["trunnion_ac", "trunnion_bc"])
def test_a_turn_that_leaves_the_limits_anywhere_is_reported(name):
    reported, dense = turns_by_dense_samples(name)
    assert not (reported & ~dense).any() and (reported[dense]).mean() > 0.999 and not reported.all()


def test_a_few_places_of_a_turn_would_miss_where_it_leaves_the_limits(monkeypatch):
    monkeypatch.setattr(limits_module, "_find_extremes", lambda *_: ())
    reported, dense = turns_by_dense_samples("trunnion_ac")
    assert (reported & ~dense).any()
