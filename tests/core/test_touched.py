# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a round piece touches facets first: against dense points of the same facets."""

import numpy as np
import pytest

from freecad_fiveaxis.core.gouge.swept_motion import Poses
from freecad_fiveaxis.core.gouge.touched import points_touched
from freecad_fiveaxis.core.tool.body import round_piece

COUNT = 200
PIECES = {"ball": (0.0, 5.0, 5.0), "bull nose": (3.0, 2.0, 2.0), "shallow": (4.5, 0.5, 0.5)}
"""Ring, corner and height, mm."""


def facets(seed):
    """Corners (3, 3, COUNT) mm of random facets about a piece, and its poses."""
    random = np.random.default_rng(seed)
    corner = 8.0 * random.normal(size=(3, 3, COUNT))
    axis = random.normal(size=(3, COUNT))
    return corner, Poses(random.normal(size=(3, COUNT)), axis / np.linalg.norm(axis, axis=0))


def demand(piece, pose, point):
    """How far (n,) mm the piece must rise from its pose for points (3, n) to lie under its bottom; -inf
    beside it."""
    arm = point - pose.tip
    height = (arm * pose.axis).sum(axis=0)
    over = np.maximum(np.linalg.norm(arm - height * pose.axis, axis=0) - piece.low_radius, 0.0)
    with np.errstate(invalid="ignore"):
        under = piece.low - np.sqrt(piece.round**2 - over**2)
    return np.where(over <= piece.round, height - under, -np.inf)


def dense(corner, steps=60):
    """Points (3, n, k) mm of the facets."""
    u, v = (grid.ravel() for grid in np.meshgrid(*2 * [np.linspace(0.0, 1.0, steps)]))
    u, v = u[u + v <= 1.0], v[u + v <= 1.0]
    return (
        corner[0][..., None] + (corner[1] - corner[0])[..., None] * u + (corner[2] - corner[0])[..., None] * v
    )


def most_of(piece, pose, points):
    with np.errstate(invalid="ignore"):
        return np.nanmax([np.nan_to_num(demand(piece, pose, one), nan=-np.inf) for one in points], axis=0)


@pytest.mark.parametrize("name", PIECES)
def test_no_point_of_a_facet_demands_more_than_those_that_are_touched(name):
    piece = round_piece(*PIECES[name])
    corner, pose = facets(3)
    samples = dense(corner)
    least = most_of(piece, pose, [samples[..., k] for k in range(samples.shape[-1])])
    reported = most_of(piece, pose, [*corner, *points_touched(piece, pose, corner)])
    under = np.isfinite(least)
    assert under.sum() > 50
    assert (reported[under] >= least[under] - 1e-6).all()
    assert (reported[under] <= least[under] + 1.5).all(), "nor are places told that no facet has"


def test_corners_alone_would_not_do():
    """The comparison above can fail."""
    piece = round_piece(*PIECES["ball"])
    corner, pose = facets(3)
    samples = dense(corner)
    least = most_of(piece, pose, [samples[..., k] for k in range(samples.shape[-1])])
    assert (most_of(piece, pose, list(corner)) < least - 0.1).any()


def test_the_points_lie_on_their_facets():
    corner, pose = facets(5)
    for point in points_touched(round_piece(*PIECES["bull nose"]), pose, corner):
        there = np.isfinite(point).all(axis=0)
        ab, ac, arm = corner[1] - corner[0], corner[2] - corner[0], point - corner[0]
        normal = np.cross(ab, ac, axis=0)
        off = (arm * normal).sum(axis=0) / np.linalg.norm(normal, axis=0)
        assert there.any() and np.abs(off[there]).max() < 1e-9
