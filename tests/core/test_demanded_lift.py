# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far facets demand that a cutter goes up: by closed forms, and against dense samples of facets in any
place."""

import numpy as np
import pytest

from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge import refinement, traversal
from freecad_fiveaxis.core.gouge.search import find_demanded_lift
from freecad_fiveaxis.core.gouge.swept_motion import still_positions, ways_up
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import body_of, depth_of, way_out

LIMIT = 0.005
CUTTERS = {
    "flat": Cutter(10.0, 40.0, corner=0.0),
    "bull": Cutter(10.0, 40.0, corner=2.0),
    "ball": Cutter(10.0, 40.0),
}


def demanded(corners, cutter, tip, axis=(0.0, 0.0, 1.0)):
    tree = facet_tree(from_triangles(np.asarray(corners, float)))
    still = still_positions(np.atleast_2d(np.asarray(tip, float)), np.atleast_2d(np.asarray(axis, float)))
    return find_demanded_lift(body_of(cutter), tree, still, LIMIT)


def densely(corners, cutter, tip, axis, steps=160):
    """The most that any of many points of the facets demands."""
    i, j = np.meshgrid(np.arange(steps + 1), np.arange(steps + 1), indexing="ij")
    v, w = (one[i + j <= steps] / steps for one in (i, j))
    points = np.concatenate([a + v[:, None] * (b - a) + w[:, None] * (c - a) for a, b, c in corners])
    body = body_of(cutter)
    tips, axes = np.broadcast_to(tip, points.shape), np.broadcast_to(axis, points.shape)
    deep = depth_of(body, tips, axes, points) > LIMIT
    return way_out(body, tips[deep], axes[deep], points[deep]).max(initial=0.0)


def test_on_a_slope_a_flat_end_goes_up_until_its_rim_is_free_in_one_step():
    slope, far = 0.5, 100.0
    facet = [[(-far, -far, -far * slope), (far, -far, far * slope), (0.0, 2 * far, 0.0)]]
    expected = slope * (5.0 - 1.01 * LIMIT)
    assert demanded(facet, CUTTERS["flat"], (0.0, 0.0, 0.0))[0] == pytest.approx(expected, abs=1e-9)


def test_over_a_point_each_cutter_goes_up_by_its_own_shape():
    spike = [[(3.0, 0.0, 4.0), (3.0, 1e-3, -9.0), (3.0, -1e-3, -9.0)]]
    floor = {"flat": 0.0, "bull": 0.0, "ball": 5.0 - 4.0}
    for kind, cutter in CUTTERS.items():
        assert demanded(spike, cutter, (0.0, 0.0, 0.0))[0] == pytest.approx(4.0 - floor[kind], abs=1e-9), kind


def test_what_is_beside_or_below_or_grazes_demands_nothing():
    beside = [[(6.0, 0.0, 0.0), (6.0, 1.0, 9.0), (6.0, -1.0, 9.0)]]
    below = [[(0.0, 0.0, -1.0), (1.0, 0.0, -1.0), (0.0, 1.0, -1.0)]]
    grazes = [[(0.0, 0.0, 0.9 * LIMIT), (1.0, 0.0, 0.9 * LIMIT), (0.0, 1.0, 0.9 * LIMIT)]]
    for facets in (beside, below, grazes):
        assert demanded(facets, CUTTERS["flat"], (0.0, 0.0, 0.0))[0] == 0.0


@pytest.mark.thorough
@pytest.mark.parametrize("kind", CUTTERS)
def test_random_facets_demand_what_dense_samples_of_them_demand(kind):
    """Never more; and for a flat end, whose rim is looked at, never less than the samples find."""
    rng, cutter = np.random.default_rng(5), CUTTERS[kind]
    found, sampled = [], []
    for _ in range(30):
        corners = rng.uniform(-8.0, 8.0, (4, 3, 3))
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        found.append(demanded(corners, cutter, np.zeros(3), axis)[0])
        sampled.append(densely(corners, cutter, np.zeros(3), axis))
    found, sampled = np.array(found), np.array(sampled)
    assert (sampled > 0.0).sum() > 20 and ((found > 0.0) == (sampled > 0.0)).all()
    assert (found <= sampled + 0.25).all(), "a point of a facet demands so much, but for the samples' spacing"
    assert (found >= (1.0 if kind == "flat" else 0.6) * sampled - 1e-6).all()


@pytest.mark.thorough
@pytest.mark.parametrize("kind", CUTTERS)
def test_the_highest_requested_first_demand_what_all_requested_at_once_demand(kind, monkeypatch):
    rng, cutter = np.random.default_rng(8), CUTTERS[kind]
    facets = rng.uniform(-12.0, 12.0, (400, 1, 3)) + rng.normal(scale=2.0, size=(400, 3, 3))
    tree, axis = facet_tree(from_triangles(facets)), rng.normal(size=(30, 3))
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    up = ways_up(rng.uniform(-12.0, 12.0, (30, 3)), axis, np.full(30, 40.0))
    lifts, wanted, whole = [], [], refinement.raise_to_demand

    def counted(lift, block, *rest):
        wanted[-1] += len(block)
        whole(lift, block, *rest)

    monkeypatch.setattr(refinement, "raise_to_demand", counted)
    for at_once in (10**9, 16):
        monkeypatch.setattr(refinement, "FEW_AT_ONCE", at_once)
        wanted.append(0)
        lifts.append(find_demanded_lift(body_of(cutter), tree, up, LIMIT))
    np.testing.assert_array_equal(*lifts)
    assert (lifts[0] > 0.0).all() and wanted[1] < 0.9 * wanted[0], wanted


@pytest.mark.parametrize("still", [True, False])
def test_what_lies_too_low_to_demand_more_is_not_gone_into_and_nothing_is_lost_by_it(still, monkeypatch):
    """Deep in a cloud of facets, where what is known of one place spares most of the others."""
    rng, cutter = np.random.default_rng(9), CUTTERS["bull"]
    facets = rng.uniform(-12.0, 12.0, (6000, 1, 3)) + rng.normal(scale=0.5, size=(6000, 3, 3))
    tree, axis, tip = (
        facet_tree(from_triangles(facets)),
        rng.normal(size=(10, 3)),
        rng.uniform(-9, 9, (10, 3)),
    )
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    ways = still_positions(tip, axis) if still else ways_up(tip, axis, np.full(10, 40.0))
    lifts, wanted, whole, prune = [], [], traversal.facet_bound, traversal.may_demand

    def counted(piece, sweep, tree, node):
        wanted[-1] += len(node)
        return whole(piece, sweep, tree, node)

    monkeypatch.setattr(traversal, "facet_bound", counted)
    for may in (prune, lambda body, ways, tree, node, lift: np.ones(len(node), np.bool_)):
        monkeypatch.setattr(traversal, "may_demand", may)
        wanted.append(0)
        lifts.append(find_demanded_lift(body_of(cutter), tree, ways, LIMIT))
    np.testing.assert_allclose(*lifts, atol=1e-9)
    assert (lifts[0] > 0.0).all() and wanted[0] < 0.7 * wanted[1], wanted
