# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets with an allowance: the gouge check of a part some of whose facets want room is that of a grown body
against these, and of the body itself against the others."""

import dataclasses

import numpy as np
import pytest
from gouge_examples import bowl, step

from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge import find_entries, straight_motion
from freecad_fiveaxis.core.gouge.joint_box import JointSpace
from freecad_fiveaxis.core.gouge.rapid_ways import find_way_entries
from freecad_fiveaxis.core.gouge.search import find_demanded_lift
from freecad_fiveaxis.core.gouge.swept_motion import still_positions
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import body_of, grow_body

LIMIT, ROOM = 0.01, 1.25
BODIES = {
    "ball": body_of(Cutter(6.0, 20.0), ((8.0, 20.0),), ((30.0, 25.0),)),
    "bull": body_of(Cutter(8.0, 20.0, corner=1.0), (), ((30.0, 25.0),)),
    "flat": body_of(Cutter(8.0, 20.0, corner=0.0)),
    "tapered": body_of(Cutter(4.0, 20.0, corner=1.0, taper=np.radians(8.0))),
}


def with_room(mesh, some, room=ROOM):
    return dataclasses.replace(mesh, allowance=np.where(some, room, 0.0))


def only(mesh, some):
    return from_triangles(mesh.vertex[mesh.face[some]])


def wandering(rng, count, far):
    """Ways whose places lie about the part and whose axes look up."""
    axis = rng.normal(size=(count, 3)) * (0.4, 0.4, 0.0) + (0.0, 0.0, 1.0)
    return rng.uniform(-far, far, (count, 3)), axis / np.linalg.norm(axis, axis=1)[:, None]


@pytest.mark.parametrize("kind", BODIES)
def test_depths_and_bounds_are_those_of_the_grown_body_where_facets_have_an_allowance(kind):
    mesh, body, rng = bowl(12.0), BODIES[kind], np.random.default_rng(5)
    some = mesh.vertex[mesh.face].mean(axis=1)[:, 0] > 0.0
    swept = straight_motion(*wandering(rng, 120, 14.0))
    near = find_entries(grow_body(body, ROOM), facet_tree(only(mesh, some)), swept, LIMIT)
    rest = find_entries(body, facet_tree(only(mesh, ~some)), swept, LIMIT)
    found = find_entries(body, facet_tree(with_room(mesh, some)), swept, LIMIT)
    deepest = np.maximum(near.depth, rest.depth)
    entered = deepest > 0.0
    assert 20 < entered.sum() < 120 and (near.depth > rest.depth).any() and (near.depth < rest.depth).any()
    assert ((found.depth > 0.0) == entered).all()
    assert np.abs(found.depth - deepest)[entered] == pytest.approx(0.0, abs=0.03 * deepest.max() + LIMIT)
    assert (found.bound >= deepest - 1e-9).all() and (found.bound >= found.depth - 1e-12).all()
    plain = find_entries(body, facet_tree(mesh), swept, LIMIT)
    assert (plain.depth < found.depth - 0.5).any(), "without the allowance less enters"


def test_an_allowance_of_nothing_changes_nothing_to_the_last_bit():
    mesh, body, rng = bowl(12.0), BODIES["bull"], np.random.default_rng(6)
    swept = straight_motion(*wandering(rng, 60, 14.0))
    one, other = (
        find_entries(body, facet_tree(part), swept, LIMIT)
        for part in (mesh, with_room(mesh, np.zeros(len(mesh.face), bool)))
    )
    for field in dataclasses.fields(one):
        assert (getattr(one, field.name) == getattr(other, field.name)).all(), field.name


def test_a_ball_beside_a_wall_is_as_deep_as_the_closed_form_says():
    mesh = step()
    wall = mesh.normal[:, 1] < -0.9
    wall &= np.abs(mesh.vertex[mesh.face][..., 1]).max(axis=1) == 0.0
    centre = np.array([[0.0, -away, 3.0 + 1e-9] for away in (3.0, 3.5, 4.24, 4.26, 6.0)])
    upward = np.tile([0.0, 0.0, 1.0], (len(centre), 1))
    still = still_positions(centre - 3.0 * upward, upward)
    depth = find_entries(body_of(Cutter(6.0, 20.0)), facet_tree(with_room(mesh, wall)), still, 1e-3).depth
    assert depth == pytest.approx([1.25, 0.75, 0.01, 0.0, 0.0], abs=1e-6)


@pytest.mark.parametrize("kind", BODIES)
def test_rapids_whose_axes_run_independently_keep_the_allowance_too(kind):
    mesh, body = bowl(12.0), BODIES[kind]
    some = mesh.vertex[mesh.face].mean(axis=1)[:, 0] > 0.0
    space = JointSpace.of(chain(load_machine("trunnion_ac"), Setup((0.0, 0.0, 0.0))))
    rng = np.random.default_rng(8)
    start = np.column_stack(
        [rng.uniform(-9.0, 9.0, (8, 2)), rng.uniform(-8.0, 4.0, 8), rng.uniform(-15.0, 15.0, (8, 2))]
    )
    words = np.stack(
        [start, start + rng.uniform(-1.0, 1.0, (8, 5)) * (2.0, 2.0, 2.0, 0.5, 0.5)], axis=1
    ).reshape(-1, 5)
    blocks = np.arange(0, 16, 2)
    ways = [
        find_way_entries(one, facet_tree(part), space, words, blocks, LIMIT, 0.1)
        for one, part in (
            (grow_body(body, ROOM), only(mesh, some)),
            (body, only(mesh, ~some)),
            (body, with_room(mesh, some)),
        )
    ]
    deepest = np.maximum(ways[0].depth, ways[1].depth)
    assert ((ways[2].depth > 0.0) == (deepest > 0.0)).all() and (deepest > 0.0).any()
    assert ways[2].depth == pytest.approx(deepest, rel=0.25, abs=0.2)
    assert (ways[2].bound >= deepest - 1e-9).all()


@pytest.mark.parametrize("kind", BODIES)
def test_what_must_go_up_goes_up_by_what_the_grown_body_demands(kind):
    mesh, body, rng = step(), BODIES[kind], np.random.default_rng(9)
    some = mesh.vertex[mesh.face].mean(axis=1)[:, 1] > 0.0
    tip, axis = wandering(rng, 40, 8.0)
    still = still_positions(tip, axis)
    near = find_demanded_lift(grow_body(body, ROOM), facet_tree(only(mesh, some)), still, LIMIT)
    rest = find_demanded_lift(body, facet_tree(only(mesh, ~some)), still, LIMIT)
    found = find_demanded_lift(body, facet_tree(with_room(mesh, some)), still, LIMIT)
    assert found == pytest.approx(np.maximum(near, rest), abs=1e-9) and (near > rest).any()
