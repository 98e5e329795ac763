# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which points lie inside a closed part, and which blocks are buried in it without touching a facet.

buried    a block all of whose cutter is so deep in the part that no facet, or only a far one, is in it. A
          tool cannot get there without its core crossing the surface, where its depth is at least the
          cutter's inner radius; so one point decides for a whole run of blocks between such crossings.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.tool.body import Body, Piece

from .swept_motion import SweptMotion

ASIDE = (3.1e-8, 1.7e-8)
"""Shares of the part's size by which points are moved in x and y, so that the ray up from them meets no
edge."""

CROSSED = 0.9
"""Of the inner radius: a block with an entry that deep may cross the surface with its core."""


def is_closed(mesh: Mesh) -> bool:
    """Whether every co-edge has a facet on both sides: only then has the part an inside."""
    return bool((mesh.coedge_face[:, 1] >= 0).all())


def inside(tree: FacetTree, points: Floats) -> Bools:
    """Which points (n, 3) mm lie inside the closed part."""
    return np.asarray(np.abs(count_solids(tree, points)) > 0.5)


def count_solids(tree: FacetTree, points: Floats) -> Floats:
    """Return in how many solids of the closed part points (n, 3) mm lie (n,): the facets above them, each
    counted with the sense in which it looks."""
    whole = tree.half[:, 0]
    x, y, z = np.asarray(points, float).T
    x, y = x + 2.0 * ASIDE[0] * whole[0], y + 2.0 * ASIDE[1] * whole[1]
    row, node, turns = np.arange(len(x)), np.zeros(len(x), np.int64), np.zeros(len(x))
    while len(row):
        middle, half = tree.middle[:, node], tree.half[:, node]
        near = (np.abs(x[row] - middle[0]) <= half[0]) & (np.abs(y[row] - middle[1]) <= half[1])
        near &= z[row] <= middle[2] + half[2]
        row, node = row[near], node[near]
        leaf = tree.arity[node] == 0
        turns += _above(tree, x, y, z, row[leaf], node[leaf] - tree.leaf)
        row, node = row[~leaf], node[~leaf]
        many = tree.arity[node]
        head = np.cumsum(many) - many
        row, node = (
            np.repeat(row, many),
            np.arange(int(many.sum())) + np.repeat(tree.child[node] - head, many),
        )
    return turns


def _above(tree: FacetTree, x: Floats, y: Floats, z: Floats, row: Ints, leaf: Ints) -> Floats:
    """+1 for every facet above a point that looks up, -1 for one that looks down, summed up (n,)."""
    first = tree.facet_first[leaf]
    row, leaf = row[first], leaf[first]
    a, b, c = tree.corners(leaf)
    px, py, pz = x[row], y[row], z[row]

    def area(p: Floats, q: Floats) -> Floats:
        return np.asarray((p[0] - px) * (q[1] - py) - (p[1] - py) * (q[0] - px))

    wa, wb, wc = area(b, c), area(c, a), area(a, b)
    total = wa + wb + wc
    over = ((wa > 0) & (wb > 0) & (wc > 0)) | ((wa < 0) & (wb < 0) & (wc < 0))
    height = (wa * a[2] + wb * b[2] + wc * c[2]) / np.where(total == 0.0, 1.0, total)
    return np.asarray(
        np.bincount(row, weights=np.where(over & (height > pz), np.sign(total), 0.0), minlength=len(x)), float
    )


def find_buried_blocks(tree: FacetTree, body: Body, swept: SweptMotion, depth: Floats) -> Bools:
    """Which blocks (m,) of a swept motion through a closed part are buried; ``depth`` (m,) mm: their entries'
    depth."""
    m = len(swept)
    if not m or not body.pieces:
        return np.zeros(m, np.bool_)
    height, _ = _middle(body.pieces[0])
    crosses = depth >= crossing_depth(body)
    run = np.cumsum(crosses | np.append(True, crosses[:-1])) - 1
    first = np.flatnonzero(np.diff(run, prepend=-1))
    pose = swept.pose(first, np.zeros(len(first)))
    within = inside(tree, (pose.tip + height * pose.axis).T)
    return np.asarray(within[run] & ~crosses)


def crossing_depth(body: Body) -> float:
    """Return the depth (mm) from which on the body's core may be through the surface."""
    return CROSSED * _middle(body.pieces[0])[1] if body.pieces else np.inf


def _middle(piece: Piece) -> tuple[float, float]:
    """Return a point on the axis, its height, and the radius of a ball about it that lies in the piece,
    mm."""
    if piece.round > 0.0:
        return piece.low, piece.round
    return 0.5 * (piece.low + piece.high), min(
        0.5 * (piece.high - piece.low), piece.low_radius, piece.high_radius
    )
