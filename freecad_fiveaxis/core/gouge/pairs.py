# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pairs of a part of the way with a part of the surface: clusters, or stretches, with nodes, or facets; and
how they are divided."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree

from .swept_motion import Clusters, Poses

LONGER = 4.0
"""So many times smaller than a node a cluster may be and is divided all the same: bounds are close for
stretches."""


class Pairs(NamedTuple):
    """Pairs of stretches with facets, or parts of facets: ``block``, ``start``, ``end`` (n,), ``corner`` (3,
    3, n), ``leaf`` (n,)."""

    block: Ints
    start: Floats
    end: Floats
    corner: Floats
    leaf: Ints

    def take(self, rows: Ints | Bools) -> Pairs:
        """Return some of them."""
        return Pairs(
            self.block[rows], self.start[rows], self.end[rows], self.corner[..., rows], self.leaf[rows]
        )


class PairWays(NamedTuple):
    """The ways of pairs: poses at ``start`` and ``end``, what these leave the straight way by, ``bend`` mm
    and ``loose`` (n,), and how high above the tip their facets come, ``top`` (n,) mm."""

    start: Poses
    end: Poses
    bend: Floats
    loose: Floats
    top: Floats

    def take(self, rows: Ints) -> PairWays:
        """Return some of them."""
        start, end = (Poses(pose.tip[:, rows], pose.axis[:, rows]) for pose in (self.start, self.end))
        return PairWays(start, end, self.bend[rows], self.loose[rows], self.top[rows])


def divide_pairs(
    clusters: Clusters, tree: FacetTree, sweep: Ints, node: Ints, enters: Bools
) -> tuple[Ints, Ints]:
    """Return the larger partner of each pair replaced by its children; the cluster where it does enter,
    because only blocks can tell that they know of deeper places."""
    by_way = clusters.arity.take(sweep) > 0
    by_way &= enters | (node >= tree.leaf) | (LONGER * clusters.size.take(sweep) > tree.size.take(node))
    one, two = np.flatnonzero(by_way), np.flatnonzero(~by_way)
    first, count = clusters.child.take(sweep[one]), clusters.arity.take(sweep[one])
    below, many = tree.child.take(node[two]), tree.arity.take(node[two])
    ways = np.concatenate([family(first, count), np.repeat(sweep[two], many)])
    nodes = np.concatenate([np.repeat(node[one], count), family(below, many)])
    return ways, nodes


def family(first: Ints, count: Ints) -> Ints:
    """List the numbers (sum of count,) from each ``first`` on, ``count`` of each (k,)."""
    head = np.cumsum(count) - count
    return np.asarray(np.arange(int(count.sum())) + np.repeat(first - head, count))


def halve_pairs(left: Pairs, in_time: Bools) -> Pairs:
    """Each pair as two: the first and the second half of its stretch, or the facet parted across its longest
    side."""
    middle = 0.5 * (left.start + left.end)
    start = np.concatenate([left.start, np.where(in_time, middle, left.start)])
    end = np.concatenate([np.where(in_time, middle, left.end), left.end])
    one, two = halves_of_facets(left.corner)
    corner = np.concatenate(
        [np.where(in_time, left.corner, one), np.where(in_time, left.corner, two)], axis=2
    )  # fmt: skip
    return Pairs(np.tile(left.block, 2), start, end, corner, np.tile(left.leaf, 2))


def halves_of_facets(corner: Floats) -> tuple[Floats, Floats]:
    """Part each facet, corners (3, 3, n) mm, in the middle of its longest side: both halves, shaped alike."""
    side = ((corner - np.roll(corner, -1, axis=0)) ** 2).sum(axis=1)
    longest, at = side.argmax(axis=0), np.arange(corner.shape[2])
    a, b, c = (corner[(longest + k) % 3, :, at].T for k in range(3))
    middle = 0.5 * (a + b)
    return np.stack([a, middle, c]), np.stack([middle, b, c])
