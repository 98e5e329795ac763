# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facets of a mesh in a tree of nodes, so that most of them are never looked at.

node      some facets that lie together: a plate, a box, and one point of the part among them. The last nodes
          are the facets.
plate     what lies between two planes across their mean normal; that of a facet has no thickness.
box       around them, either as they lie - along their mean normal, along the way they spread most across it,
          and along the third direction - or along x, y, z: the one with the smaller surface. On a slope the
          first is far thinner, over walls and floors of a part that stands straight the second.
level     all nodes with equally many facets; the nodes of all levels stand in one table, the root first.
allowance of a facet: how far a tool keeps off it, mm. A facet is as deep in a tool as its points are, and
that much deeper: it is
          so deep in the tool grown by it all round.

The tree is perfectly balanced: at each level the facets of every node are parted at the median of what
spreads most, place or normal, all nodes at once. It is filled up with copies of the last facets.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple
from weakref import WeakKeyDictionary

import numpy as np

from freecad_fiveaxis.core.base.chunks import batches, in_threads
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .mesh import Mesh

LEAF = 2
"""At least so many facets hang on each of the last nodes but one (fewer where the mesh has fewer)."""

BEND = 0.2
"""What a change of the normals by 1 counts for in parting, as a share of the node's size."""

TOP = 6
"""Times that all facets are parted level by level; what they are then in, a thread parts to the end by
itself."""

AT_ONCE = 16384
"""Facets whose nodes are measured at a time."""

ROWS = 3, 3, 1, 5, 15, 3
"""Of the tables of nodes: middle, half, size, plate, box, point."""


class Plates(NamedTuple):
    """Of n nodes: the unit ``normal`` (3, n), and how far along it the plate's sides are, ``top`` and
    ``bottom`` (n,) mm."""

    normal: Floats
    top: Floats
    bottom: Floats


class Boxes(NamedTuple):
    """Of n nodes: ``middle`` (3, n) mm of the box; ``ways`` (3, 3, n), its three directions, unit, and
    ``half`` (3, n) mm, half its sizes along them."""

    middle: Floats
    ways: Floats
    half: Floats


@dataclass(frozen=True, eq=False)
class FacetTree:
    """``facet`` (k,) row of the mesh of each leaf, ``corner`` (9, k) its corners a, b, c, mm; ``facet_first``
    (k,) False for copies. Of all nodes: ``middle``, ``half`` (3, n) mm their extent along x, y, z, and
    ``size`` (n,) mm half its diagonal; ``child`` (n,) the first child and ``arity`` (n,) how many, 0 at a
    leaf; ``leaf`` the first node that is a facet. ``plate`` (5, n) and ``box`` (15, n), rows as in
    :class:`Plates` and :class:`Boxes`, and ``point`` (3, n) mm one of the part's points. ``allowance`` (2, n)
    mm: the largest and the least of the facets of each node; ``facet_allowance`` (f,) mm: the mesh's own;
    None where a tool may touch all."""

    facet: Ints
    corner: Floats
    facet_first: Bools
    middle: Floats
    half: Floats
    size: Floats
    child: Ints
    arity: Ints
    leaf: int
    plate: Floats
    box: Floats
    point: Floats
    allowance: Floats | None = None
    facet_allowance: Floats | None = None

    @property
    def most_allowance(self) -> float:
        """The largest of all, mm."""
        return 0.0 if self.allowance is None else float(self.allowance[0, 0])

    def allowance_of(self, facet: Ints) -> Floats | float:
        """Return the allowance (n,) mm of these facets (n,) of the mesh; 0 where no facet has one."""
        return 0.0 if self.facet_allowance is None else self.facet_allowance[facet]

    def most_of(self, node: Ints) -> Floats | float:
        """Return the largest allowance (n,) mm of the facets of these nodes (n,); 0 where no facet has
        one."""
        return 0.0 if self.allowance is None else self.allowance[0].take(node)

    def least_of(self, node: Ints) -> Floats | float:
        """Return the least allowance (n,) mm of the facets of these nodes (n,); 0 where no facet has one."""
        return 0.0 if self.allowance is None else self.allowance[1].take(node)

    def plates(self, node: Ints) -> Plates:
        """Those of these nodes (n,)."""
        column = _columns(self.plate, node)
        return Plates(column[:3], column[3], column[4])

    def boxes(self, node: Ints) -> Boxes:
        """Those of these nodes (n,)."""
        column = _columns(self.box, node)
        return Boxes(column[:3], column[3:12].reshape(3, 3, -1), column[12:])

    def points(self, node: Ints) -> Floats:
        """Those of these nodes (n,): (3, n) mm."""
        return _columns(self.point, node)

    def corners(self, leaf: Ints) -> Floats:
        """Those of these facets (n,), counted from the first leaf: (3, 3, n) mm."""
        return _columns(self.corner, leaf).reshape(3, 3, -1)


def _columns(table: Floats, rows: Ints) -> Floats:
    return table.take(rows, axis=1)


_TREES: WeakKeyDictionary[Mesh, FacetTree] = WeakKeyDictionary()


def facet_tree(mesh: Mesh) -> FacetTree:
    """Return the tree over all facets of a mesh: made once, and kept as long as the mesh is, for cures and
    checks ask for it in turn."""
    if mesh not in _TREES:
        _TREES[mesh] = build_facet_tree(mesh)
    return _TREES[mesh]


def build_facet_tree(mesh: Mesh) -> FacetTree:
    """Return the tree, made anew."""
    a, b, c = (mesh.vertex.take(column, axis=0) for column in mesh.face.T)
    order, depth = _part_facets(((a + b) + c) / 3.0, mesh.normal)
    corner, normal = _take_columns(order, a, b, c), _take_columns(order, mesh.normal)
    del a, b, c
    counts = [2**k for k in range(depth % 2, depth + 1, 2)] if depth else [1]
    counts = ([1] if counts[0] != 1 else []) + counts + [len(order)]
    if counts[-1] == counts[-2]:
        counts.pop()
    tables = [np.empty((height, sum(counts))) for height in ROWS]
    child, arity, start = [], [], 0
    for count, more in zip(counts, [*counts[1:], 0], strict=True):
        _fill_level(corner, normal, count, [table[:, start : start + count] for table in tables])
        start += count
        child.append(start + np.arange(count) * (more // count))
        arity.append(np.full(count, more // count))
    middle, half, size, plate, box, point = tables
    once = np.zeros(len(order), np.bool_)
    once[_first_places(order, len(mesh.face))] = True
    children, arities, leaf = np.concatenate(child), np.concatenate(arity), start - counts[-1]
    allowance = None if mesh.allowance is None else _allowances(mesh.allowance[order], counts)
    boxes = (middle, half, size[0], children, arities, leaf, plate, box, point)
    return FacetTree(order, corner, once, *boxes, allowance, mesh.allowance)


def _take_columns(order: Ints, *tables: Floats) -> Floats:
    """Return the rows ``order`` (k,) of tables (f, 3) as columns (3 times as many as tables, k)."""
    columns = np.empty((3 * len(tables), len(order)))
    for place, column in enumerate(column for table in tables for column in table.T):
        np.take(column, order, out=columns[place])
    return columns


def _first_places(order: Ints, count: int) -> Ints:
    """Where (count,) each of 0 to ``count`` - 1 comes first in ``order`` (k,), which has all of them."""
    first = np.empty(count, np.int64)
    first[order[::-1]] = np.arange(len(order))[::-1]  # of those that come again the last one written stays
    return first


def _allowances(of_leaf: Floats, counts: list[int]) -> Floats:
    """Return the largest and the least allowance (2, n) mm of the nodes of all levels, from those of the
    leaves."""
    most, least = (
        [find(of_leaf.reshape(count, -1), axis=1) for count in counts] for find in (np.max, np.min)
    )
    return np.stack([np.concatenate(most), np.concatenate(least)])


def _part_facets(centre: Floats, normal: Floats) -> tuple[Ints, int]:
    """Return the facets in the order of the leaves, filled up with copies, and how often they are parted."""
    depth = max(int(np.floor(np.log2(max(len(centre), 1) / LEAF))), 0)
    width = -(-len(centre) // 2**depth)  # so every node has an even number of facets to part
    order = np.minimum(np.arange(width * 2**depth), len(centre) - 1)[None]
    feature, top = np.concatenate([centre.T, normal.T]), min(depth, TOP)
    for _ in range(top):
        order = np.concatenate(in_threads(lambda node: _part_once(feature, node[None]), list(order)))
    below = in_threads(lambda node: _part_often(feature, node[None], depth - top), list(order))
    return np.concatenate(below), depth


def _part_often(feature: Floats, order: Ints, times: int) -> Ints:
    """Return the facets (k,) of nodes (n, k / n) after these are parted so many ``times``."""
    for _ in range(times):
        order = _part_once(feature, order)
    return order.reshape(-1)


def _part_once(feature: Floats, order: Ints) -> Ints:
    """Twice as many nodes (2 n, f / 2) as there are in ``order`` (n, f): parted by the one of ``feature`` (6,
    .), place and normal, that spreads most in each."""
    value = feature[:, order]  # (6, nodes, facets)
    spread = value.max(axis=2) - value.min(axis=2)
    spread[3:] *= BEND * np.linalg.norm(spread[:3], axis=0)
    key = np.take_along_axis(value, spread.argmax(axis=0)[None, :, None], axis=0)[0]
    order = np.take_along_axis(order, np.argpartition(key, order.shape[1] // 2, axis=1), axis=1)
    return order.reshape(2 * len(order), -1)


def _fill_level(corner: Floats, normal: Floats, count: int, tables: list[Floats]) -> None:
    """Fill in the tables, of :data:`ROWS`, of ``count`` nodes of equally many facets, some nodes at a time:
    their columns stay in the cache, and memory that is asked for once is used again."""
    width = corner.shape[1] // count
    rows = 2 * max(AT_ONCE // (2 * width), 1)

    def fill(some: slice) -> None:
        facets = slice(some.start * width, some.stop * width)
        level = _level(corner[:, facets], normal[:, facets], some.stop - some.start)
        for table, part in zip(tables, level, strict=True):
            table[:, some] = part

    in_threads(fill, batches(count, rows))


def _level(corner: Floats, normal: Floats, count: int) -> tuple[Floats, ...]:
    """Middle, half, size, plate (5, count), box (15, count) and point of ``count`` nodes of equally many
    facets."""
    corners = corner.reshape(3, 3, count, -1)  # corner, x y z, node, facet
    top, bottom = corners.max(axis=(0, 3)), corners.min(axis=(0, 3))
    middle, half = 0.5 * (top + bottom), 0.5 * (top - bottom)
    arm, mean = corners - middle[:, :, None], _mean(normal.reshape(3, count, -1))
    ways, low, high = _lying(arm, mean)
    place, off = (mean * middle).sum(axis=0), arm.mean(axis=0)  # x y z, node, facet
    box = _smaller(ways, low, high, half)
    box[:3] += middle
    nearest = (off * off).sum(axis=0).argmin(axis=1)
    point = middle + np.take_along_axis(off, nearest[None, :, None], axis=2)[:, :, 0]
    return (
        middle,
        half,
        np.linalg.norm(half, axis=0),
        np.concatenate([mean, [place + high[0], place + low[0]]]),
        box,
        point,
    )


def _mean(normal: Floats) -> Floats:
    """Return the unit mean (3, n) of normals (3, n, facets), or the first of them where they are opposite."""
    mean = normal.mean(axis=2)
    length = np.linalg.norm(mean, axis=0)
    mean = np.where(length > 1e-3, mean / np.maximum(length, 1e-3), normal[:, :, 0])
    return np.asarray(mean / np.linalg.norm(mean, axis=0))


def _lying(arm: Floats, normal: Floats) -> tuple[Floats, Floats, Floats]:
    """Directions (3, 3, n) of the boxes that lie as corners (3, 3, n, facets) do, and from where to where (3,
    n) these go."""
    one = np.cross(normal, np.eye(3)[np.abs(normal).argmin(axis=0)].T, axis=0)
    one = one / np.linalg.norm(one, axis=0)
    two = np.cross(normal, one, axis=0)
    x, y = (np.einsum("in,cinf->cnf", way, arm) for way in (one, two))
    x, y = x - x.mean(axis=(0, 2))[:, None], y - y.mean(axis=(0, 2))[:, None]
    turn = 0.5 * np.arctan2(2.0 * (x * y).sum(axis=(0, 2)), (x * x - y * y).sum(axis=(0, 2)))
    side = np.cos(turn) * one + np.sin(turn) * two
    ways = np.stack([normal, side, np.cross(normal, side, axis=0)])
    along = np.einsum("kin,cinf->kcnf", ways, arm)
    return ways, along.min(axis=(1, 3)), along.max(axis=(1, 3))


def _smaller(ways: Floats, low: Floats, high: Floats, half: Floats) -> Floats:
    """Columns (15, n) of the box with the smaller surface: that from ``low`` to ``high`` along ``ways``, or
    the straight one of ``half`` about 0."""
    wide, straight = 0.5 * (high - low), np.broadcast_to(np.eye(3)[:, :, None], ways.shape)
    lying = np.concatenate([np.einsum("kn,kin->in", 0.5 * (low + high), ways), *ways, wide])
    upright = np.concatenate([np.zeros_like(half), *straight, half])
    a, b = (size[0] * size[1] + size[1] * size[2] + size[2] * size[0] for size in (wide, half))
    return np.where(a < b, lying, upright)
