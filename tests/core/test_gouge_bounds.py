# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bounds of the gouge check against dense samples: no point of a node is deeper at any pose of a way."""

import gc
import weakref

import numpy as np
import pytest
from gouge_examples import bowl, step
from thorough import some_in_core

from benchmarks.parts import bumpy
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles
from freecad_fiveaxis.core.gouge import find_entries, real_motion, refinement, straight_motion
from freecad_fiveaxis.core.gouge.bounds import box_bound, facet_bound, least_depth, pare_piece, plate_bound
from freecad_fiveaxis.core.gouge.deepest import compute_needed_height, deepest, find_top, support_at, toward
from freecad_fiveaxis.core.gouge.edges import nearest_on_edges
from freecad_fiveaxis.core.gouge.swept_motion import Poses, clusters_of, segments_of, still_positions
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import (
    Body,
    Piece,
    body_of,
    depth_of,
    distance_off,
    frustum_piece,
    off_piece,
    round_piece,
    support,
    way_out,
)

LIMIT = 0.01
PIECES = {
    "ball": round_piece(0.0, 3.0, 3.0),
    "ball cutter": Piece(3.0, 0.0, 20.0, 0.0, 3.0),
    "bull nose": Piece(1.0, 4.0, 20.0, 4.0, 1.0),
    "ring": round_piece(4.0, 1.0, 1.0),
    "flat": frustum_piece(0.0, 5.0, 20.0, 5.0),
    "tapered": Piece(1.0, 0.5, 20.0, 4.0, 1.0),
    "cone": frustum_piece(0.0, 2.0, 12.0, 6.0),
    "cone upside down": frustum_piece(0.0, 6.0, 12.0, 2.0),
}
STRAIGHT = [name for name, piece in PIECES.items() if piece.low_radius == piece.high_radius]


def directions(rng, count):
    way = rng.normal(size=(count, 3))
    return way / np.linalg.norm(way, axis=1)[:, None]


def leaning_axes(rng, count, by):
    axes = np.array([0.0, 0.0, 1.0]) + by * rng.normal(size=(count, 3))
    return axes / np.linalg.norm(axes, axis=1)[:, None]


def steps(rng, mesh, count):
    """A walk about a corner of the part, in and out of it."""
    return mesh.vertex[rng.integers(len(mesh.vertex))] + np.cumsum(rng.normal(0.0, 0.5, (count, 3)), axis=0)


def courses(rng, mesh):
    machine = load_machine("trunnion_ac")
    words = np.column_stack([steps(rng, mesh, 18), np.cumsum(rng.normal(0.0, 4.0, (18, 2)), axis=0)])
    return {
        "still": still_positions(steps(rng, mesh, 17), leaning_axes(rng, 17, 0.5)),
        "upright": straight_motion(steps(rng, mesh, 18), np.broadcast_to((0.0, 0.0, 1.0), (18, 3))),
        "turning": straight_motion(steps(rng, mesh, 18), leaning_axes(rng, 18, 0.15)),
        "anyhow": straight_motion(steps(rng, mesh, 18), directions(rng, 18)),
        "machine": real_motion(chain(machine, Setup()), words),
    }


def clusters(swept):
    parts = segments_of(swept, np.arange(len(swept)), 30.0, 0.05)
    return parts, clusters_of(swept, parts, 30.0)


def stretches_under(table, row):
    """The stretches of a row of the table."""
    return _last(table, row) - table.first


def facets_under(tree, node):
    return _last(tree, node) - tree.leaf


def _last(table, row):
    rows = np.array([row])
    while table.arity[rows[0]]:
        rows = np.concatenate([table.child[one] + np.arange(table.arity[one]) for one in rows])
    return rows


def depths(piece, swept, parts, stretches, tree, facets, rng):
    """How deep the part goes into the piece, by samples of these facets and stretches."""
    u = parts.start[stretches, None] + np.linspace(0.0, 1.0, 9) * (parts.end - parts.start)[stretches, None]
    pose = swept.pose(np.repeat(parts.block[stretches], 9), u.ravel())
    share = np.concatenate([np.eye(3), rng.dirichlet((1.0, 1.0, 1.0), 12)])
    points = np.einsum("sk,kif->sfi", share, tree.corners(facets)).reshape(-1, 3)
    return depth_of(Body((piece,)), pose.tip.T[:, None], pose.axis.T[:, None], points[None])


def pairs(rng, table, tree):
    """Rows of clusters and nodes, as many small as large ones, half of the nodes among the nearest."""
    levels = [(0, table.top), (table.top, table.first), (table.first, len(table.size))]
    way = np.concatenate([rng.integers(*level, 16) for level in levels if level[1] > level[0]])
    node = rng.integers(0, len(tree.size), (400, len(way)))
    off = np.linalg.norm(tree.middle[:, node] - table.ways(way).tip[:, None], axis=0) + tree.size[
        node
    ] * rng.uniform(0.5, 2.0, node.shape)
    nearest = np.take_along_axis(node, off.argmin(axis=0)[None], axis=0)[0]
    return way, np.where(rng.uniform(size=len(way)) < 0.7, nearest, node[0])


def lowest_bounds(piece, ways, tree, node):
    core, off = pare_piece(piece, LIMIT)
    return {
        bound.__name__: bound(core, ways, tree, node) + off for bound in (box_bound, plate_bound, facet_bound)
    }


@some_in_core("name", PIECES, kept=(0, 2, 5))
def test_no_sample_is_deeper_than_any_of_the_bounds(name):
    rng, piece, near = np.random.default_rng(4), PIECES[name], 0
    for mesh in (bowl(20.0), step(), bumpy(400)):
        tree = facet_tree(mesh)
        for kind, swept in courses(rng, mesh).items():
            parts, table = clusters(swept)
            way, node = pairs(rng, table, tree)
            bounds = lowest_bounds(piece, table.ways(way), tree, node)
            for k in range(len(way)):
                found = depths(
                    piece,
                    swept,
                    parts,
                    stretches_under(table, way[k]),
                    tree,
                    facets_under(tree, node[k]),
                    rng,
                ).max()
                for bound, most in bounds.items():
                    assert found <= max(most[k], LIMIT) + 1e-9, (kind, bound, k)
                near += found > LIMIT
    assert near > 30  # enough of them do enter


def test_the_samples_see_a_bound_that_forgets_what_the_way_bends():
    rng, mesh, piece = np.random.default_rng(4), bumpy(400), PIECES["ball cutter"]
    tree, swept = facet_tree(mesh), courses(rng, mesh)["machine"]
    parts, table = clusters(swept)
    way, node = np.arange(table.top).repeat(40), rng.integers(tree.leaf, len(tree.size), 40 * table.top)
    ways = table.ways(way)
    ways.column[9:11] = 0.0
    assert not ways.bend_tip.any() and not ways.bend_axis.any()
    most = np.min(list(lowest_bounds(piece, ways, tree, node).values()), axis=0)
    found = [
        depths(piece, swept, parts, stretches_under(table, row), tree, facets_under(tree, leaf), rng).max()
        for row, leaf in zip(way, node, strict=True)
    ]
    assert (np.array(found) > most + 1e-3).any()


def test_a_point_stated_to_be_deep_is_so_at_some_pose():
    rng, mesh, piece, deep = np.random.default_rng(5), bumpy(400), PIECES["bull nose"], 0
    tree = facet_tree(mesh)
    for swept in [swept for _ in range(12) for swept in courses(rng, mesh).values()]:
        parts, table = clusters(swept)
        way, node = pairs(rng, table, tree)
        points = tree.points(node)
        least = least_depth(piece, table.ways(way), points)
        for k in np.flatnonzero(least > 0.0):
            u = np.linspace(0.0, 1.0, 40)
            rows = stretches_under(table, way[k])
            share = parts.start[rows, None] + u * (parts.end - parts.start)[rows, None]
            pose = swept.pose(np.repeat(parts.block[rows], 40), share.ravel())
            found = depth_of(Body((piece,)), pose.tip.T, pose.axis.T, points[:, k]).max()
            assert found > least[k] - 0.05
            deep += 1
    assert deep > 10


# ------------------------------------------------------------------------------------------------ touching


def touching(name, count, rng):
    """Triangles (3, 3, n) that a piece with its tip at 0 and its axis up touches from outside, by sampling
    their distance."""
    piece, found = PIECES[name], []
    share = np.concatenate([np.eye(3), rng.dirichlet((1.0, 1.0, 1.0), 400), _along_edges(200)])
    for _ in range(count):
        size = 10.0 ** rng.uniform(-1.0, 1.5)
        middle = np.array([0.0, 0.0, 4.0]) + rng.normal(0.0, 4.0, 3) * (1.0, 1.0, 0.5)
        corner = middle + size * rng.normal(size=(3, 3)) * (1.0, 1.0, 0.3)
        off, g = _nearest(piece, corner, share, rng)
        if off + piece.round > 1e-3 and g[2] < 1e-3:  # not in the core, and not over the tool
            found.append(corner - off * g)
    return piece, np.array(found).transpose(1, 2, 0)


def _along_edges(count):
    t = np.linspace(0.0, 1.0, count)[:, None]
    return np.concatenate([(1.0 - t) * np.eye(3)[k] + t * np.eye(3)[(k + 1) % 3] for k in range(3)])


def _nearest(piece, corner, share, rng):
    """How far a triangle is from the piece, and which way: samples, ever nearer to the best."""
    for scale in 0.02 * 0.4 ** np.arange(16):
        point = (share @ corner).T
        distance, g = toward(piece, np.broadcast_to([[0.0], [0.0], [1.0]], point.shape), point)
        k = distance.argmin()
        best = share[k], distance[k], g[:, k]
        share = np.maximum(
            best[0] + scale * rng.normal(size=(150, 3)) * (rng.uniform(size=(150, 3)) < 0.6), 0.0
        )
        share = np.concatenate([best[:1], share / share.sum(axis=1)[:, None]])
    return best[1], best[2]


@some_in_core("name", STRAIGHT, kept=(0, 3))
def test_a_tool_that_touches_a_facet_anywhere_is_cleared_of_it_at_once(name):
    rng = np.random.default_rng(6)
    piece, corner = touching(name, 300, rng)
    assert corner.shape[2] > 25
    cleared = clearances(piece, corner) <= LIMIT
    assert cleared.mean() > 0.98


def clearances(piece, corner):
    """The best bound for triangles, each a tree of its own, of a piece that stands at 0."""
    best = []
    for k in range(corner.shape[2]):
        mesh = from_faces(corner[:, :, k], np.array([[0, 1, 2]]))
        tree, swept = facet_tree(mesh), still_positions(np.zeros((1, 3)), np.array([[0.0, 0.0, 1.0]]))
        _, table = clusters(swept)
        row, node = np.array([table.first]), np.array([len(tree.size) - 1])
        best.append(
            min(float(bound[0]) for bound in lowest_bounds(piece, table.ways(row), tree, node).values())
        )
    return np.array(best)


@pytest.mark.thorough
def test_without_the_edges_many_touched_facets_are_not_cleared(monkeypatch):
    rng = np.random.default_rng(6)
    piece, corner = touching("bull nose", 300, rng)
    monkeypatch.setitem(globals(), "facet_bound", plate_bound)
    assert (clearances(piece, corner) <= LIMIT).mean() < 0.8


@pytest.mark.parametrize("name", STRAIGHT)
def test_the_nearest_place_of_the_edges_is_that_of_dense_samples(name):
    rng, piece = np.random.default_rng(7), PIECES[name]
    corner = rng.normal(0.0, 5.0, (3, 3, 400)) + np.array([0.0, 0.0, -3.0])[:, None]
    axis = np.broadcast_to([[0.0], [0.0], [1.0]], (3, 400))
    core = piece._replace(round=0.0, high=100.0)
    place = nearest_on_edges(piece, axis, corner)
    samples = np.einsum("sk,kin->sin", _along_edges(400), corner)
    off = [
        np.maximum(distance_off(core, np.hypot(x, y), z), 0.0)
        for x, y, z in (place, samples.transpose(1, 0, 2))
    ]
    close = off[0] <= off[1].min(axis=0) * 1.001 + 1e-3
    assert close.mean() > 0.985 and (off[0] <= off[1].min(axis=0) * 1.2 + 0.02).all()


@pytest.mark.parametrize("name", ["ball", "ball cutter", "ring"])
def test_the_deepest_point_of_a_facet_beside_a_tool_is_that_of_dense_samples(name):
    rng, piece, count = np.random.default_rng(11), PIECES[name], 300
    middle = 4.0 * rng.normal(size=(3, count)) + np.array([0.0, 0.0, 3.0])[:, None]
    corner = middle + 6.0 * rng.normal(size=(3, 3, count))
    pose = Poses(np.zeros((3, count)), np.broadcast_to([[0.0], [0.0], [1.0]], (3, count)))
    a, b = (one.ravel()[:, None] for one in np.meshgrid(*2 * [np.linspace(0.0, 1.0, 41)]))
    x, y, z = np.einsum("sk,kin->isn", np.hstack([1.0 - a, a * (1.0 - b), a * b]), corner)
    sampled = distance_off(piece, np.hypot(x, y), z).min(axis=0)
    beside = sampled > 0.0
    over = (deepest(piece, pose, corner).distance - sampled)[beside]
    assert beside.sum() > 100 and np.percentile(over, 95) < 0.1


# ------------------------------------------------------------------------------------------- pieces and nodes


@pytest.mark.parametrize("name", PIECES)
def test_the_way_out_leads_just_off_the_underside_by_samples_along_the_axis(name):
    piece, radius, height = PIECES[name], np.linspace(0.0, 8.0, 161), np.linspace(-1.0, 25.0, 5201)
    within = distance_off(piece, radius[:, None], height) <= 0.0
    low = np.where(within.any(axis=1), height[within.argmax(axis=1)], np.inf)
    tip, point = np.zeros((161, 3)), np.column_stack([radius, 0.0 * radius, np.full(161, 25.0)])
    by = way_out(Body((piece,)), tip, np.broadcast_to((0.0, 0.0, 1.0), (161, 3)), point)
    rim = (
        np.abs(radius - max(piece.low_radius, piece.high_radius) - piece.round) < 0.1
    )  # a hair beside it there is nothing
    assert by[~rim] == pytest.approx(np.maximum(25.0 - low, 0.0)[~rim], abs=0.006)


@pytest.mark.parametrize("name", PIECES)
@pytest.mark.parametrize("by", [0.01, 1.5])
def test_a_pared_piece_holds_what_is_deeper_by_so_much_less(name, by):
    rng, piece = np.random.default_rng(8), PIECES[name]
    core, off = pare_piece(piece, by)
    radius, height = rng.uniform(0.0, 8.0, 20000), rng.uniform(-2.0, 24.0, 20000)
    before, after = (-distance_off(one, radius, height) for one in (piece, core))
    deep = before > off
    assert off <= by and deep.sum() > (100 if by < 1.0 or piece.most > 2.0 else -1)
    assert (after[deep] >= before[deep] - off - 1e-12).all()
    assert (after[~deep] <= 1e-12).all()


@pytest.mark.parametrize("name", PIECES)
def test_support_and_distance_of_a_piece_are_those_of_its_points(name):
    rng, piece = np.random.default_rng(9), PIECES[name]
    height, radius = rng.uniform(-1.0, 25.0, 40000), rng.uniform(0.0, 9.0, 40000)
    distance = off_piece(piece, radius, height).distance
    np.testing.assert_allclose(distance_off(piece, radius, height), distance, rtol=0.0, atol=1e-12)
    along = np.linspace(-1.0, 1.0, 21)
    inside = distance <= 0.0
    reach = along[:, None] * height[inside] + np.sqrt(1.0 - along[:, None] ** 2) * radius[inside]
    assert (reach.max(axis=1) <= support(piece, along) + 1e-9).all()
    assert (reach.max(axis=1) >= support(piece, along) - 0.4).all()
    assert (support(piece, along, 0.1) >= support(piece, along)).all()


@pytest.mark.parametrize("mesh", [bowl(20.0), step(), bumpy(400)], ids=["bowl", "step", "bumpy"])
def test_every_corner_is_in_the_boxes_and_plates_of_its_nodes(mesh):
    tree = facet_tree(mesh)
    for node in range(len(tree.size)):
        corner = tree.corners(facets_under(tree, node)).transpose(1, 0, 2).reshape(3, -1)
        box, plate = tree.boxes(np.array([node])), tree.plates(np.array([node]))
        along = np.einsum("kin,im->km", box.ways, corner - box.middle)
        assert (np.abs(along) <= box.half + 1e-9).all()
        height = plate.normal[:, 0] @ corner
        assert plate.bottom[0] - 1e-9 <= height.min() and height.max() <= plate.top[0] + 1e-9
        assert np.linalg.norm(corner - tree.middle[:, [node]], axis=0).max() <= tree.size[node] + 1e-9


def test_the_tree_of_a_mesh_is_built_once_and_goes_with_it():
    mesh = step()
    tree = facet_tree(mesh)
    assert facet_tree(mesh) is tree and facet_tree(step()) is not tree
    gone = weakref.ref(tree)
    del tree, mesh
    gc.collect()
    assert gone() is None


def test_boxes_lie_as_the_facets_do_on_slopes_and_straight_over_walls_and_floors():
    slope, stairs = facet_tree(bumpy(4000)), facet_tree(step())
    straight = np.abs(np.abs(stairs.boxes(np.arange(len(stairs.size))).ways).max(axis=1) - 1.0) < 1e-9
    assert straight[:, :1].all()  # the whole block
    leaves = slope.boxes(np.arange(slope.leaf, len(slope.size)))
    assert (leaves.half.min(axis=0) < 1e-9).mean() > 0.9  # no thicker than a facet


@pytest.mark.parametrize("name", STRAIGHT)
def test_a_facet_is_as_deep_in_the_shortened_piece_at_every_pose(name):
    """All poses of real ways, bends and all, against points spread over the facets; a piece that ends at
    their height would not do."""
    rng, piece, kinematics = (
        np.random.default_rng(11),
        PIECES[name],
        chain(load_machine("fork_head_bc"), Setup(tool_length=60.0)),
    )
    words = np.cumsum(rng.normal(0.0, [4.0, 4.0, 4.0, 8.0, 8.0], (80, 5)), axis=0)
    swept, block = real_motion(kinematics, words), np.arange(79)
    start, end = swept.pose(block, np.zeros(79)), swept.pose(block, np.ones(79))
    reach = rng.uniform(-4.0, 18.0, 79) * start.axis
    corner = start.tip + reach + rng.normal(0.0, 2.0, (3, 3, 79))
    bend_tip, bend_axis = 0.125 * swept.bend_tip, 0.125 * swept.bend_axis
    top = find_top(start, end, corner, bend_tip, bend_axis)
    high = compute_needed_height(piece, top)
    assert (high < piece.high).sum() > 10 or piece.low == piece.high
    differs = False
    share = rng.dirichlet(np.ones(3), 200)
    point = np.concatenate([np.einsum("pk,kin->pin", share, corner), corner])
    for u in np.linspace(0.0, 1.0, 9):
        pose = swept.pose(block, np.full(79, u))
        arm = point - pose.tip
        height = (arm * pose.axis).sum(axis=1)
        assert (height <= top + 1e-9).all()
        radius = np.sqrt(np.maximum((arm * arm).sum(axis=1) - height * height, 0.0))
        for k in range(79):
            whole = -distance_off(piece, radius[:, k], height[:, k])
            short = -distance_off(piece._replace(high=float(high[k])), radius[:, k], height[:, k])
            inside = whole > 0.0
            assert short[inside] == pytest.approx(whole[inside], abs=1e-9) and (short[~inside] <= 1e-9).all()
            low = piece._replace(high=max(0.5 * (float(high[k]) + piece.low), piece.low + 1e-6))
            differs |= bool(
                (-distance_off(low, radius[:, k], height[:, k])[inside] < whole[inside] - 1e-3).any()
            )
    assert (
        differs or piece.low_radius == 0.0 or piece.low == piece.high
    )  # a ball's is as deep wherever it ends above the facet


def test_a_point_passed_under_is_highest_half_way_as_its_top_says():
    """A tip on a straight way across a point, the axis leaning back and then forward: the point is below the
    bottom at both ends and on it in the middle."""
    s, lean, none = 2.0, 0.2, np.zeros(1)
    start, end = (
        Poses(np.array([[side * s], [0.0], [0.0]]), np.array([[side * np.sin(lean)], [0.0], [np.cos(lean)]]))
        for side in (-1.0, 1.0)
    )
    point = np.zeros((3, 3, 1))
    assert ((point[0] - start.tip) * start.axis).sum() == pytest.approx(-s * np.sin(lean))
    assert ((point[0] - end.tip) * end.axis).sum() == pytest.approx(-s * np.sin(lean))
    assert find_top(start, end, point, none, none) == pytest.approx(0.0, abs=1e-12)


def test_what_stays_below_a_level_bottom_that_turns_is_clear_of_it_without_being_divided(monkeypatch):
    """A flat end mill over the ridge between two faces, turning from square on one to square on the other."""
    roof = from_triangles(
        np.array([[(0, -9, 0), (0, 9, 0), (9, -9, -2)], [(0, 9, 0), (0, -9, 0), (-9, 9, -2)]], float)
    )
    lean = np.arctan2(2.0, 9.0)
    axis = np.array([(-np.sin(lean), 0.0, np.cos(lean)), (np.sin(lean), 0.0, np.cos(lean))])
    swept, body = straight_motion(np.zeros((2, 3)), axis), body_of(Cutter(6.0, corner=0.0))
    rounds, halve = [], refinement.halve_pairs
    monkeypatch.setattr(refinement, "halve_pairs", lambda *given: rounds.append(1) or halve(*given))
    found = find_entries(body, facet_tree(roof), swept, 0.005)
    assert found.depth[0] == 0.0 and found.bound[0] <= 0.005 and not rounds
    monkeypatch.setattr(refinement, "find_top", lambda start, *_: np.full(start.tip.shape[1], np.inf))
    monkeypatch.setattr(refinement, "compute_needed_height", lambda piece, top: None)
    assert find_entries(body, facet_tree(roof), swept, 0.005).bound[0] <= 0.005 and len(rounds) > 3


def test_the_support_of_a_shortened_piece_is_that_of_the_piece_so_short():
    rng = np.random.default_rng(12)
    g, axis = directions(rng, 300).T, leaning_axes(rng, 300, 0.5).T
    pose, along = Poses(np.zeros((3, 300)), axis), (g * axis).sum(axis=0)
    loose, share = rng.uniform(0.0, 0.01, 300), rng.uniform(0.0, 1.0, 300)
    for name in STRAIGHT:
        piece = PIECES[name]
        high = piece.low + share * (piece.high - piece.low)
        for off in (0.0, loose):
            rows = zip(high.tolist(), along.tolist(), np.broadcast_to(off, 300).tolist(), strict=True)
            exact = np.array(
                [float(support(piece._replace(high=end), np.float64(a), o)) for end, a, o in rows]
            )
            given = support_at(piece, pose, g, off, high)
            assert (given >= exact - 1e-9).all() and (given <= exact + 2.0 * off * piece.high + 1e-9).all()
