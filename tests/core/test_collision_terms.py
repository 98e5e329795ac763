# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each term of the gouge check's and the lift's proofs is needed: motions on which the bound without it is
exceeded."""

import math
from dataclasses import replace

import numpy as np
import pytest
from gouge_examples import prism, round_groove

from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge import find_entries
from freecad_fiveaxis.core.gouge.deepest import deepest, toward
from freecad_fiveaxis.core.gouge.inside import find_buried_blocks
from freecad_fiveaxis.core.gouge.lift import lift_path
from freecad_fiveaxis.core.gouge.swept_motion import (
    MOST_PARTS,
    MotionSegments,
    Poses,
    SweptMotion,
    clusters_of,
    straight_motion,
)
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import Body, Piece, body_of, frustum_piece, round_piece
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

TOLERANCE, GROOVE, RADIUS = 0.01, 4.0, 5.0
UP = np.array([[0.0], [0.0], [1.0]])


def upright(height, bend):
    """One block in which a tip on the axis goes up and down: ``height`` of u, mm, its second derivative
    within ``bend`` mm."""

    def pose(block, u):
        return Poses(np.stack([0.0 * u, 0.0 * u, height(u)]), np.broadcast_to(UP, (3, len(u))))

    return SweptMotion(pose, np.array([bend]), np.zeros(1))


# ------------------------------------------------------------------------------------------------ bends


def test_a_dip_between_poses_that_are_all_clear_is_in_the_bound():
    """At both ends and in the middle of each of the first stretches the tool stands over the part; a quarter
    of one further on it dips in."""
    waves = 2.0 * MOST_PARTS
    half = 0.4
    swept = upright(
        lambda u: 0.1 - half * (1.0 - np.cos(2.0 * math.pi * waves * u)), half * (2.0 * math.pi * waves) ** 2
    )
    tree = facet_tree(prism([(-30, -10), (30, -10), (30, 0), (-30, 0)]))
    found = find_entries(Body((frustum_piece(0.0, 3.0, 20.0, 3.0),)), tree, swept, TOLERANCE)
    assert found.bound[0] >= 2.0 * half - 0.1 - 1e-9 and found.depth[0] > 2.0 * half - 0.1 - 0.02


def test_a_stretch_is_thickened_by_all_that_a_parabola_leaves_its_chord():
    sag = 0.3
    table = clusters_of(
        upright(lambda u: 4.0 * sag * u * (1.0 - u), 8.0 * sag),
        MotionSegments(*np.array([[0], [0], [1]])),
        30.0,
    )
    assert table.ways(np.array([table.first])).bend_tip[0] >= sag * (1.0 - 1e-12)


# ------------------------------------------------------------------------------ deepest points, buried blocks


@pytest.mark.parametrize(
    "piece", [frustum_piece(0.0, 5.0, 20.0, 5.0), Piece(1.0, 4.0, 20.0, 4.0, 1.0)], ids=["flat", "bull nose"]
)
def test_the_deepest_point_of_a_facet_across_a_core_is_nearly_that_of_dense_samples(piece):
    rng, count = np.random.default_rng(13), 300
    corner = np.array([0.0, 0.0, 6.0])[:, None] + rng.normal(0.0, 6.0, (3, 3, count))
    pose = Poses(np.zeros((3, count)), np.repeat(UP, count, axis=1))
    share = np.concatenate([np.eye(3), rng.dirichlet((1.0, 1.0, 1.0), 1500)])
    samples = np.einsum("sk,kin->isn", share, corner).reshape(3, -1)
    best = (
        toward(piece, np.broadcast_to(UP, samples.shape), samples)[0].reshape(len(share), count).min(axis=0)
    )
    behind = (deepest(piece, pose, corner).distance - best)[best < -piece.round - 0.2]
    assert len(behind) > 100 and behind.mean() < 0.2


@pytest.mark.parametrize(("centre", "buried"), [(-1.5, True), (1.5, False)])
def test_an_entry_half_as_deep_as_the_core_does_not_cross_the_surface_with_it(centre, buried):
    tree = facet_tree(prism([(-30, -11), (30, -11), (30, 0), (-30, 0)]))
    tips = np.array([[-2.0, 0.3, centre - 3.0], [2.0, 0.3, centre - 3.0]])
    swept = straight_motion(tips, np.tile([0.0, 0.0, 1.0], (2, 1)))
    assert find_buried_blocks(tree, Body((round_piece(0.0, 3.0, 3.0),)), swept, np.array([1.5])).tolist() == [
        buried
    ]


# ------------------------------------------------------------------------------------------------ lift


def over_groove(points):
    """A path along the groove that gives these points, the tool upright."""
    tips, n = np.array(points, float), len(points)
    motion, none = np.full(n, Motion.CUT, np.int8), np.full(n, -1)
    motion[0] = Motion.RAPID
    axes = np.tile([0.0, 0.0, 1.0], (n, 1))
    return CLPath(
        tips, axes, motion, np.where(motion == Motion.CUT, 500.0, 0.0), tips, axes, none, none, none
    )


def lifted(back, sideways=0.0):
    """The path at the groove's bottom lifted, its points ``back`` mm over the tips."""
    path = over_groove([(x, 0.0, -GROOVE) for x in (-5.0, 0.0, 5.0)])
    given = replace(path, tip=path.tip + back * path.axis)
    return lift_path(
        given, facet_tree(round_groove(GROOVE)), body_of(Cutter(2.0 * RADIUS)), TOLERANCE, back
    ).path


def test_a_path_of_centres_is_lifted_as_that_of_its_tips_is():
    tips, centres = lifted(0.0), lifted(RADIUS)
    np.testing.assert_allclose(centres.tip - RADIUS * centres.axis, tips.tip, atol=1e-9)


@pytest.mark.parametrize(("share", "lifts"), [(0.7, True), (0.4, False)])
def test_a_ball_that_enters_both_rims_by_more_than_half_the_tolerance_is_lifted(share, lifts):
    """The ball's middle over the groove's edges at y = 4: ``hypot(4, height)`` from both."""
    height = np.sqrt((RADIUS - share * TOLERANCE) ** 2 - GROOVE**2)
    path = over_groove([(x, 0.0, height - RADIUS) for x in (-5.0, 0.0, 5.0)])
    found = lift_path(path, facet_tree(round_groove(GROOVE)), body_of(Cutter(2.0 * RADIUS)), TOLERANCE)
    assert (found.lift > 0.0).any() == lifts
    enters = RADIUS - np.hypot(GROOVE, found.path.tip[:, 2] + RADIUS)
    assert (enters <= 0.5 * TOLERANCE).all()
