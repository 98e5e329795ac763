# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field of tool axes: what it promises on any part, and parts on which the axes are known in closed
form."""

import math
from dataclasses import replace
from functools import cache, partial
from types import SimpleNamespace

import numpy as np
import pytest
from gouge_examples import dense_points
from scipy.spatial.transform import Rotation
from test_reach_map import BALL, block, profile, slot
from thorough import some_in_core

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles
from freecad_fiveaxis.core.gouge import obstacles as obstacles_module
from freecad_fiveaxis.core.gouge.obstacles import Reacher, obstacles, part_heights, tip_at
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.orientation import auto_axis, facets_with_axis
from freecad_fiveaxis.core.orientation import axis_field as module
from freecad_fiveaxis.core.orientation.auto_axis import Free, auto_axes, divide_path, refine_field
from freecad_fiveaxis.core.orientation.facets_with_axis import find_axis_field
from freecad_fiveaxis.core.orientation.rulings import find_rulings
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, facet_mean
from freecad_fiveaxis.core.passes import axes_within_limits, slice_mesh
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import depth_of
from freecad_fiveaxis.core.toolpath.coedge import close_gaps

SHORT = Cutter(6.0, 12.0)
HOLDER = ((24.0, 30.0),)
NODES, MORE = 200, 300
"""Fewer than the product takes: what takes its own number of them is thorough. MORE: where an angle is known
by closed form."""


def trunnion(most=None):
    """The chain of a table-table machine, with its A axis within ``most`` deg."""
    machine = load_machine("trunnion_ac")
    kinematics = chain(machine, Setup(machine.origin))
    if most is None:
        return kinematics
    low, high = kinematics.low.copy(), kinematics.high.copy()
    low[4], high[4] = -math.radians(most), math.radians(most)
    return replace(kinematics, low=low, high=high)


def corner():
    """A floor 40 mm wide beside a wall 30 mm high at X 0, both 40 mm long in Y: its ends are open."""
    return profile(np.array([(0, 30), (-10, 30), (-10, -1), (40, -1), (40, 0), (0, 0)]), 40.0)


def stemmed():
    """A sphere of radius 10 about (0, 0, 30) on a stem of radius 3 that stands on Z 0."""
    bow = np.radians(np.linspace(-72.0, 88.0, 17))
    line = np.concatenate([[(3.0, 0.0)], np.stack([10.0 * np.cos(bow), 30.0 + 10.0 * np.sin(bow)], axis=1)])
    turn = np.linspace(0.0, 2.0 * math.pi, 25)[:-1]
    vertex = np.stack(
        [line[:, :1] * np.cos(turn), line[:, :1] * np.sin(turn), np.repeat(line[:, 1:], 24, 1)], axis=-1
    ).reshape(-1, 3)
    row = np.arange(len(line) * 24).reshape(-1, 24)
    a, b, c, d = (
        part.ravel() for part in (row[:-1], np.roll(row[:-1], -1, 1), np.roll(row[1:], -1, 1), row[1:])
    )
    return from_faces(vertex, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]))


def hollows():
    """Hills and hollows without any symmetry, too steep for a short tool in places."""
    x, y = np.meshgrid(np.linspace(-20, 20, 18), np.linspace(-20, 20, 18), indexing="ij")
    height = 7 * np.sin(x / 6 + 0.3) * np.cos(y / 7 - 0.2) - 0.01 * x * x + 0.1 * y
    vertex = np.stack([x, y, height], axis=-1).reshape(-1, 3)
    row = np.arange(18 * 18).reshape(18, 18)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    return from_faces(vertex, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]))


def plate():
    return from_triangles(
        np.array([[(0, 0, 0), (40, 0, 0), (40, 30, 0)], [(0, 0, 0), (40, 30, 0), (0, 30, 0)]], float)
    )


@cache
def found(shape, cutter=SHORT, holder=HOLDER, most=None, turn=0.0, count=NODES):
    """Nodes, freedom and field of a part, part and directions turned about Z by ``turn`` rad."""
    mesh, direction = shape(), module.even_directions()
    mesh = from_faces(mesh.vertex @ turned(turn).T, mesh.face)
    kinematics = None if most is None else trunnion(most)
    reacher, tree = Reacher(cutter, holder=holder, kinematics=kinematics), facet_tree(mesh)
    nodes = module.surface_nodes(mesh, np.ones(len(mesh.face), np.bool_), reacher, tree, count)
    freedom = module.find_freedom(nodes, reacher, tree, direction @ turned(turn).T)
    return mesh, reacher, nodes, freedom, module.find_field(nodes, freedom, reacher, tree)


def turned(angle):
    return np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])


def angle(one, two):
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(one, two), axis=-1), (one * two).sum(-1)))


def narrow_bore(radius=3.4, depth=60.0, sides=36):
    """The wall of a bore about Z, open at both ends, little wider than the tool."""
    turn = 2.0 * math.pi * np.arange(sides) / sides
    ring = radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    low, high = (np.column_stack([ring, np.full(sides, z)]) for z in (-depth, 0.0))
    at = np.arange(sides)
    after = (at + 1) % sides
    one, two = (
        np.stack([at, at + sides, after], axis=1),
        np.stack([after, at + sides, after + sides], axis=1),
    )
    return from_faces(np.concatenate([low, high]), np.concatenate([one, two]))


def bore_askew():
    """The narrow bore on its side: it leans by 35 deg, and no facet looks along it."""
    mesh, turn = narrow_bore(), Rotation.from_rotvec(math.radians(35.0) * np.array([0.6, 0.8, 0.0]))
    return from_faces(mesh.vertex @ turn.as_matrix().T, mesh.face)


def freed_of_bore(shape=narrow_bore):
    """Nodes of a narrow bore's wall, which of them a long tool has an axis at, and these axes."""
    mesh = shape()
    reacher, tree = Reacher(Cutter(6.0, 80.0)), facet_tree(mesh)
    nodes = module.surface_nodes(mesh, np.ones(len(mesh.face), np.bool_), reacher, tree, NODES)
    direction = np.concatenate([module.even_directions(), module.main_directions(mesh)])
    freedom = module.find_freedom(nodes, reacher, tree, direction)
    return nodes, freedom.some, module.find_field(nodes, freedom, reacher, tree)


def test_in_a_bore_little_wider_than_the_tool_it_stands_along_the_wall():
    nodes, some, axis = freed_of_bore()
    assert (nodes.normal[:, :2] * nodes.point[:, :2] < 1e-9).all(), "the wall looks at the bore's axis"
    deep = np.abs(nodes.point[:, 2] + 30.0) < 10.0
    assert some.all() and deep.any() and (np.abs(axis[deep, 2]) > math.cos(math.radians(3.5))).all()


def test_in_a_bore_that_stands_askew_the_tool_stands_along_its_rulings():
    assert freed_of_bore(bore_askew)[1].all()


def test_rulings_are_those_of_hollow_walls_and_none_that_are_known():
    mesh = bore_askew()
    along = [
        0.8 * math.sin(math.radians(35.0)),
        -0.6 * math.sin(math.radians(35.0)),
        math.cos(math.radians(35.0)),
    ]
    ruling = find_rulings(mesh, np.eye(3))
    np.testing.assert_allclose(ruling, [along], atol=1e-9)
    assert (
        len(find_rulings(mesh, ruling))
        == len(find_rulings(from_faces(mesh.vertex, mesh.face[:, ::-1]), np.eye(3)))
        == 0
    )
    assert len(find_rulings(plate(), np.eye(3))) == 0


def test_without_axes_along_walls_that_bore_would_be_out_of_reach(monkeypatch):
    monkeypatch.setattr(module, "ALONG", module.WIDEST)
    assert not freed_of_bore()[1].all()


def deep_slot():
    return slot(14.0, 20.0)


PARTS = [plate, block, corner, hollows, stemmed, deep_slot]
NAMES = ["plate", "block", "corner", "hollows", "sphere on a stem", "slot"]


@some_in_core("shape", PARTS, ids=NAMES, kept=(1, 3, 5))
def test_a_unit_axis_at_every_node_that_is_free_and_within_the_limits_wherever_one_is(shape):
    mesh, reacher, nodes, freedom, axis = found(shape, most=70.0)
    np.testing.assert_allclose(np.linalg.norm(axis, axis=1), 1.0, atol=1e-12)
    some = freedom.some
    assert some.any() and axes_within_limits(reacher.kinematics, axis[some]).all()
    tree = facet_tree(mesh)
    assert module.are_free(reacher, tree, nodes.stand[some], nodes.normal[some], axis[some]).all()
    tips = tip_at(reacher.cutter, nodes.stand, nodes.normal, axis)
    points = points_on(shape, 1.0)
    assert deepest(reacher, tips[some], axis[some], points).max() <= 2.0 * reacher.limit


@cache
def points_on(shape, spacing):
    """Points all over a part, found once for all tests that look at it."""
    return dense_points(shape(), spacing)


def deepest(reacher, tip, axis, points):
    """mm: how deep the deepest of the points lies in the tool, for each place of the tool."""
    body = reacher.body
    return np.array([depth_of(body, one, way, points).max() for one, way in zip(tip, axis, strict=True)])


def test_normals_alone_would_not_be_free():
    _, reacher, nodes, freedom, _ = found(deep_slot)
    some = freedom.some & ~freedom.upright
    points = points_on(deep_slot, 1.0)
    tips = tip_at(reacher.cutter, nodes.stand, nodes.normal, nodes.normal)
    assert some.any() and deepest(reacher, tips[some], nodes.normal[some], points).min() > 2.0 * reacher.limit


@pytest.mark.parametrize("shape", PARTS, ids=NAMES)
def test_some_axis_is_free_exactly_where_brute_force_says_so(shape):
    _, reacher, nodes, freedom, _ = found(shape, most=70.0)
    rows = np.random.default_rng(3).choice(len(nodes.point), 20, replace=False)
    direction = np.concatenate([freedom.direction, np.zeros((1, 3))])
    assert (freedom.some[rows] == by_force(shape, reacher, nodes, direction, rows)).all()


def by_force(shape, reacher, nodes, direction, rows):
    """Whether (k,) at these nodes any of the directions, or the own normal (in the last one's place), has the
    tool out of dense points."""
    points, body, free = points_on(shape, 0.7), reacher.body, []
    for row in rows:
        ways = np.where(direction.any(axis=1)[:, None], direction, nodes.normal[row])
        ways = ways[
            (ways @ nodes.normal[row] > math.cos(module.WIDEST))
            & axes_within_limits(reacher.kinematics, ways)
        ]
        tips = tip_at(
            reacher.cutter,
            *(np.broadcast_to(one[row], ways.shape) for one in (nodes.stand, nodes.normal)),
            ways,
        )
        depth = (
            depth_of(body, tips[k], ways[k], points).max() for k in np.argsort(-ways @ nodes.normal[row])
        )  # one is enough
        free.append(nodes.fits[row] and any(one <= 1.5 * reacher.limit for one in depth))
    return np.array(free)


def test_brute_force_would_notice_a_holder_that_was_forgotten():
    _, reacher, nodes, freedom, _ = found(deep_slot, most=40.0)
    bare = found(deep_slot, holder=(), most=40.0)[3]
    rows = np.flatnonzero(bare.some & ~freedom.some)[:5]
    direction = np.concatenate([freedom.direction, np.zeros((1, 3))])
    assert len(rows) and not by_force(deep_slot, reacher, nodes, direction, rows).any()


def test_the_field_turns_with_the_part():
    (_, _, nodes, freedom, here), there = found(hollows, most=70.0), found(hollows, most=70.0, turn=0.7)[4]
    assert (freedom.some & ~freedom.upright).any() and len(nodes.point) > 0.7 * NODES
    assert angle(here @ turned(0.7).T, there).max() < 1e-6
    assert np.median(angle(here, there)) > 5.0


def test_on_an_open_plate_the_axis_is_the_normal():
    axis = found(plate, most=70.0)[4]
    np.testing.assert_allclose(axis, np.broadcast_to((0.0, 0.0, 1.0), axis.shape), atol=1e-12)


def test_in_a_slot_the_axis_lies_in_its_plane_as_far_as_the_tool_has_room():
    """The floor of a slot 14 mm wide and 40 mm deep: a cutter of 6 mm leans across by no more than the gap
    over the height."""
    _, _, nodes, freedom, axis = found(lambda: slot(14.0, 40.0, 60.0), Cutter(6.0, 60.0), ())
    floor = np.isclose(nodes.point[:, 2], 10.0) & (np.abs(nodes.point[:, 0]) < 3.9) & freedom.some
    room = (14.0 - 6.0) / 40.0
    assert floor.any() and (np.abs(axis[floor, 0]) <= room + 0.02).all()
    wall = (
        np.isclose(np.abs(nodes.point[:, 0]), 7.0)
        & (nodes.point[:, 2] > 15.0)
        & (nodes.point[:, 2] < 25.0)
        & freedom.some
    )
    assert wall.any() and not freedom.upright[wall].any() and (np.abs(axis[wall, 0]) < 0.45).all()


def test_beside_a_wall_the_axis_leans_away_from_it():
    """With a holder 24 mm wide 12 mm above the tip the floor within 12 mm of the wall is free only so."""
    _, _, nodes, freedom, axis = found(corner, count=MORE)
    near = (nodes.normal[:, 2] > 0.9) & (nodes.point[:, 2] < 1.0) & (nodes.point[:, 0] < 10.0) & freedom.some
    assert near.any() and not freedom.upright[near].any() and (axis[near, 0] > 0.1).all()
    far = (nodes.normal[:, 2] > 0.9) & (nodes.point[:, 2] < 1.0) & (nodes.point[:, 0] > 32.0)
    assert (angle(axis[far], nodes.normal[far]) < 15.0).all() and freedom.upright[far].all()


def test_the_sphere_on_a_stem_is_reached_by_its_normals_and_the_stem_by_what_passes_the_sphere():
    _, _, nodes, freedom, axis = found(stemmed, Cutter(6.0, 40.0), (), count=MORE)
    top = nodes.point[:, 2] > 30.0
    assert (angle(axis[top], nodes.normal[top]) < 15.0).all() and freedom.upright[top].all()
    stem = (nodes.point[:, 2] < 12.0) & (nodes.point[:, 2] > 4.0)
    assert freedom.some[stem].all()


def test_a_turn_is_spread_over_the_surface_about_an_edge():
    """At the rim of a block the normals turn by 90 deg at once; the field takes several nodes for that."""
    _, _, nodes, _, axis = found(block, Cutter(6.0, 40.0), (), count=MORE)
    top = np.isclose(nodes.point[:, 2], 20.0) & (nodes.point[:, 1] > 8.0) & (nodes.point[:, 1] < 22.0)
    rim = top & (nodes.point[:, 0] > 38.5)
    middle = top & (np.abs(nodes.point[:, 0] - 20.0) < 5.0)
    assert (angle(axis[rim], nodes.normal[rim]) > 8.0).all() and (
        angle(axis[middle], nodes.normal[middle]) < 6.0
    ).all()


def test_a_ball_is_raised_out_of_a_shallow_crease_and_does_not_fit_into_a_narrow_slot():
    _, _, nodes, freedom, _ = found(lambda: slot(5.0, 20.0), BALL, ())
    inside = (np.abs(nodes.point[:, 0]) < 2.6) & (np.abs(nodes.point[:, 2] - 15.0) < 10.0)
    assert inside.any() and not nodes.fits[inside].any() and not freedom.some[inside].any()
    crease = profile(np.array([(-20, -5), (20, -5), (20, 0), (0, -2), (-20, 0)]), 20.0)
    point, normal = np.array([[0.1, 10.0, -1.99]]), crease.normal[[4]]
    stand, fits = module.raise_contacts(Reacher(BALL), facet_tree(crease), point, normal)
    assert fits.all() and 0.001 < np.linalg.norm(stand - point) < 0.05


# ----------------------------------------------------------------------------------------------- the contacts


def take_nodes(patch, count):
    """Let `auto` look at so many places of the part; NODES are the product's."""
    patch.setattr(facets_with_axis, "surface_nodes", partial(module.surface_nodes, count=count))


@cache
def contacts_on(shape):
    """Passes over what looks up of a part, with its mesh and these facets."""
    mesh = shape()
    facets = mesh.normal[:, 2] > -0.01
    contact = slice_mesh(mesh, np.linspace(3.0, 27.0, 9), 0.0, facets)
    return close_gaps(contact, mesh, SHORT.corner, 0.05), mesh, facets


@cache
def field_on(shape, reacher, nodes):
    """The field over what is milled of a part, refined where its contacts ask for it: the same however the
    tool leans."""
    path, mesh, facets = contacts_on(shape)
    with pytest.MonkeyPatch.context() as patch:
        take_nodes(patch, nodes)
        field = find_axis_field(mesh, facets, reacher)
    assert len(field.nodes.point) <= nodes
    return refine_field(field, path, mesh, reacher)


@cache
def reacher_of(most):
    """The short tool in its holder, on a machine whose A axis stays within ``most`` deg, None: on any."""
    return Reacher(SHORT, holder=HOLDER, kinematics=None if most is None else trunnion(most))


@cache
def milled(shape, most=None, nodes=module.NODES, **lean):
    """Passes over a part, what facet_mean gives, and the axes of `auto` with its findings."""
    path, mesh, _ = contacts_on(shape)
    given, reacher = facet_mean(path, AxisOptions()), reacher_of(most)
    field = field_on(shape, reacher, nodes)
    return path, given, auto_axes(path, given, field, mesh, reacher, AxisOptions(**lean)), mesh, reacher


@some_in_core("nodes", [NODES, module.NODES])
@some_in_core("lean", [{}, {"lead": 0.1, "tilt": -0.1}], ids=["upright", "leaned"], kept=(1,))
def test_all_rows_of_one_contact_share_one_unit_axis(lean, nodes):
    path, _, (axis, _, _), _, _ = milled(corner, nodes=nodes, **lean)
    np.testing.assert_allclose(np.linalg.norm(axis, axis=1), 1.0, atol=1e-12)
    same = (np.abs(np.diff(path.point, axis=0)) < 1e-9).all(axis=1) & (np.diff(path.polyline) == 0)
    same &= (path.before[1:] == path.before[:-1]).all(axis=1) & (path.after[1:] == path.after[:-1]).all(
        axis=1
    )
    assert same.any() and (axis[1:][same] == axis[:-1][same]).all()


@pytest.mark.thorough
@some_in_core("nodes", [NODES, module.NODES])
def test_contacts_are_free_with_auto_where_they_are_not_with_the_normals(nodes):
    path, given, (axis, free, _), _, reacher = milled(hollows, nodes=nodes)
    points, row = points_on(hollows, 1.0), slice(None, None, 2)
    point, normal = path.point[row], path.normal[row]
    by_normal, by_field = (
        deepest(reacher, tip_at(SHORT, point, normal, way[row]), way[row], points) for way in (given, axis)
    )
    held = by_normal > 0.2
    assert np.count_nonzero(held) > 5 and free.all()
    assert (by_field[held] < 0.1).mean() > 0.9 and by_field.max() < 0.2


@pytest.mark.parametrize(("held", "severity"), [(0, None), (5, Severity.NOTE), (6, Severity.WARNING)])
def test_single_contacts_without_a_free_axis_are_a_note(held, severity):
    free = np.where(np.arange(1000) < held, Free.NONE, Free.WAY_OUT)
    contacts = SimpleNamespace(all_fit=np.ones(1000, bool), point=np.zeros((1000, 3)))
    assert [one.severity for one in auto_axis._findings(free, contacts)] == [severity][: int(held > 0)]


@pytest.mark.thorough
def test_where_no_axis_is_free_the_given_one_stays_and_is_distinguished_and_counted():
    """The holder does not go into the slot, and within 20 deg the tool cannot lean out of its ends."""
    path, given, (axis, free, findings), _, _ = milled(deep_slot, 20.0, nodes=NODES)
    floor = (
        np.isclose(path.point[:, 2], 10.0)
        & (np.abs(path.point[:, 0]) < 3.9)
        & (np.abs(path.point[:, 1] - 15.0) < 5.0)
    )
    assert floor.any() and (axis[floor] == given[floor]).all() and not free[floor].any() and free.any()
    (finding,) = findings
    assert finding.code == "no-free-axis" and finding.value > 9 and "no tool axis was found" in finding.text
    assert milled(plate, nodes=NODES)[2][2] == () and milled(plate, nodes=NODES)[2][1].all()


@pytest.mark.thorough
def test_lead_goes_on_top_where_that_is_free():
    _, _, (axis, _, _), _, _ = milled(plate, nodes=NODES, lead=0.2)
    np.testing.assert_allclose(angle(axis, np.array([0.0, 0.0, 1.0])), math.degrees(0.2), atol=1e-9)


def test_rows_are_put_between_those_of_wide_facets_so_that_the_field_is_followed_there():
    path, _, _ = contacts_on(corner)
    given = facet_mean(path, AxisOptions())
    fine, axis = divide_path(path, given, 3.0, 0.0)
    away = np.linalg.norm(np.diff(fine.point, axis=0), axis=1)[np.diff(fine.polyline) == 0]
    assert away.max() <= 3.0 + 1e-6 and len(fine.point) == len(axis) > len(path.point)
    again, _ = divide_path(fine, axis, 3.0, 0.0)
    assert again is fine
    sparse = np.linalg.norm(np.diff(path.point, axis=0), axis=1)[np.diff(path.polyline) == 0]
    assert sparse.max() > 10.0


@pytest.mark.parametrize("count", [0, 1, module.IN_CACHE, 2 * module.IN_CACHE + 1])
def test_the_nearest_free_direction_is_the_one_of_the_largest_cosine_however_many_are_requested(count):
    random = np.random.default_rng(count)
    direction, axis, normal = (module.unit(random.normal(size=(k, 3))) for k in (7, count, count))
    free, upright = random.random((count, 7)) < 0.2, random.random(count) < 0.2
    found, got = module.nearest_free(
        axis, normal, module.Freedom(direction, free, upright, np.zeros(count, np.int64))
    )
    for k in range(count):
        allowed = [*direction[free[k]], *([normal[k]] if upright[k] else [])]
        assert got[k] == bool(allowed)
        assert np.array_equal(found[k], max(allowed, key=lambda one: float(one @ axis[k]), default=axis[k]))


@pytest.mark.thorough
@pytest.mark.parametrize("shape", [block, stemmed, hollows, corner, plate])
def test_what_stands_above_the_whole_part_is_found_by_its_support_and_the_answers_are_the_same(
    shape, monkeypatch
):
    mesh, random = shape(), np.random.default_rng(8)
    tree, reacher = (
        facet_tree(mesh),
        Reacher(SHORT, holder=HOLDER, table=float(mesh.vertex[:, 2].min()) - 1.0),
    )
    facet = random.choice(len(mesh.face), 4000, p=mesh.area / mesh.area.sum())
    point, normal = mesh.vertex[mesh.face[facet]].mean(axis=1), mesh.normal[facet]
    axis = module.unit(normal + module.unit(random.normal(size=(4000, 3))))
    wanted, enters = [0], obstacles_module.enters

    def counted(body, tree, tip, *more):
        wanted[0] += len(tip)
        return enters(body, tree, tip, *more)

    monkeypatch.setattr(obstacles_module, "enters", counted)
    plain = obstacles(reacher, tree, point, normal, axis)
    most, wanted[0] = wanted[0], 0
    np.testing.assert_array_equal(
        obstacles(reacher, tree, point, normal, axis, part_heights(tree, normal)), plain
    )
    assert wanted[0] <= most and (shape is not block or wanted[0] < 0.5 * most)
    low = part_heights(tree, normal) - 5.0  # with too low a support some would be taken for free
    assert shape is not hollows or (obstacles(reacher, tree, point, normal, axis, low) != plain).any()


def test_the_part_reaches_as_far_as_its_farthest_corner():
    mesh, normal = stemmed(), module.unit(np.random.default_rng(3).normal(size=(200, 3)))
    np.testing.assert_allclose(
        part_heights(facet_tree(mesh), normal), (normal @ mesh.vertex.T).max(axis=1), atol=1e-9
    )
    assert np.isinf(part_heights(facet_tree(plate()), normal)).all() and not len(
        part_heights(facet_tree(mesh), normal[:0])
    )


def test_where_all_nodes_near_by_lie_on_another_face_the_tool_stands_along_the_normal():
    """On a shaft of slivers all nodes near a contact may be those of its end: here all are on top of the
    sphere, and no axis that is free there is free below its equator."""
    mesh, reacher = stemmed(), reacher_of(None)
    all_round = np.ones(len(mesh.face), bool)
    path = close_gaps(slice_mesh(mesh, np.linspace(-6.0, 6.0, 5), 0.0, all_round), mesh, SHORT.corner, 0.05)
    whole = field_on(stemmed, reacher, NODES)
    top = np.flatnonzero(whole.nodes.normal[:, 2] > 0.9)
    field = facets_with_axis.AxisField(whole.nodes.take(top), whole.freedom.of(top), whole.axis[top])
    axis, free, _ = auto_axes(path, facet_mean(path, AxisOptions()), field, mesh, reacher, AxisOptions())
    below = (path.normal[:, 2] < -0.3) & (path.normal[:, 2] > -0.6)
    assert below.sum() > 20 and (free[below] > Free.NONE).mean() > 0.9
    assert (axis[below] * path.normal[below]).sum(axis=1).min() > 0.9
