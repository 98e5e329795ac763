# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facets of a mesh in a tree of nodes, so that most of them are never looked at.

node      some facets that lie together: a box around them along x, y, z, a plate, and one point of the part among them. The last
          nodes are the facets themselves, whose plate has no thickness.
plate     a box around them that lies as they do: along their mean normal, along the way they spread most across it, and along
          the third direction. Of facets on a slope it is far thinner than the box along x, y, z.
level     all nodes with equally many facets; the nodes of all levels stand in one table, the root first.

The tree is perfectly balanced: at each level the facets of every node are parted at the median of what spreads most, place or
normal, all nodes at once. It is filled up with copies of the last facets.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.mesh import Mesh
from freecad_fiveaxis.core.records import Bools, Floats, Ints

LEAF = 2
"""At least so many facets hang on each of the last nodes but one (fewer where the mesh has fewer)."""

Columns = tuple[Floats, ...]

BEND = 0.2
"""What a change of the normals by 1 counts for in parting, as a share of the node's size."""


class Plates(NamedTuple):
    """Of n nodes, columns x, y, z each: ``middle`` mm of the plate, ``normal`` and ``side`` unit the first two of its directions,
    ``wide`` mm half its sizes along the three, ``point`` mm one of the part's points."""

    middle: Columns
    normal: Columns
    side: Columns
    wide: Columns
    point: Columns

    def take(self, rows: Ints) -> Plates:
        """Some of them."""
        return Plates(*(tuple(column.take(rows) for column in part) for part in self))


@dataclass(frozen=True, eq=False)
class FacetTree:
    """``facet`` (k,) row of the mesh of each leaf, ``corner`` (9, k) its corners a, b, c, mm. Of all nodes: ``middle``, ``half``
    (3, n) mm the box; ``plate`` (n, 15), a node in one row because they are looked up in any order: columns as in
    :class:`Plates`; ``size`` (n,) mm half the box's diagonal; ``child`` (n,) the first child and ``arity`` (n,) how many, 0 at a
    leaf; ``leaf`` the first node that is a facet; ``facet_first`` (k,) False for copies."""

    facet: Ints
    corner: Floats
    middle: Floats
    half: Floats
    plate: Floats
    size: Floats
    child: Ints
    arity: Ints
    leaf: int
    facet_first: Bools

    def plates(self, node: Ints) -> Plates:
        """Those of these nodes (n,)."""
        column = tuple(np.ascontiguousarray(self.plate.take(node, axis=0).T))
        return Plates(*(column[k : k + 3] for k in range(0, 15, 3)))


def facet_tree(mesh: Mesh) -> FacetTree:
    """The tree over all facets of a mesh."""
    corner = mesh.vertex[mesh.face]  # (f, 3, 3)
    order, depth = _parted(corner.mean(axis=1), mesh.normal)
    corner = np.ascontiguousarray(corner[order].reshape(-1, 9).T)
    normal = np.ascontiguousarray(mesh.normal[order].T)
    counts = [2**k for k in range(depth % 2, depth + 1, 2)] if depth else [1]
    counts = ([1] if counts[0] != 1 else []) + counts + [len(order)]
    if counts[-1] == counts[-2]:
        counts.pop()
    levels = [_level(corner, normal, count) for count in counts]
    child, arity, start = [], [], 0
    for count, more in zip(counts, [*counts[1:], 0], strict=True):
        start += count
        child.append(start + np.arange(count) * (more // count))
        arity.append(np.full(count, more // count))
    middle, half, *plate, size = (np.concatenate(part, axis=-1) for part in zip(*levels, strict=True))
    once = np.zeros(len(order), np.bool_)
    once[np.unique(order, return_index=True)[1]] = True
    children, arities = np.concatenate(child), np.concatenate(arity)
    leaf = start - counts[-1]
    table = np.ascontiguousarray(np.concatenate(plate).T)
    return FacetTree(order, corner, middle, half, table, size, children, arities, leaf, once)


def _parted(centre: Floats, normal: Floats) -> tuple[Ints, int]:
    """The facets in the order of the leaves, filled up with copies, and how often they are parted."""
    depth = max(int(np.floor(np.log2(max(len(centre), 1) / LEAF))), 0)
    width = -(-len(centre) // 2**depth)  # so every node has an even number of facets to part
    order = np.minimum(np.arange(width * 2**depth), len(centre) - 1)[None]
    feature = np.concatenate([centre, normal], axis=1).T.copy()
    for k in range(depth):
        order = order.reshape(2**k, -1)
        value = feature[:, order]  # (6, nodes, facets)
        spread = value.max(axis=2) - value.min(axis=2)
        spread[3:] *= BEND * np.linalg.norm(spread[:3], axis=0)
        key = np.take_along_axis(value, spread.argmax(axis=0)[None, :, None], axis=0)[0]
        order = np.take_along_axis(order, np.argpartition(key, order.shape[1] // 2, axis=1), axis=1)
    return order.ravel(), depth


def _level(corner: Floats, normal: Floats, count: int) -> tuple[Floats, ...]:
    """Box, plate, point and size of ``count`` nodes of equally many facets."""
    corners = corner.reshape(3, 3, count, -1)  # corner, x y z, node, facet
    top, bottom = corners.max(axis=(0, 3)), corners.min(axis=(0, 3))
    middle, half = 0.5 * (top + bottom), 0.5 * (top - bottom)
    mean = normal.reshape(3, count, -1).mean(axis=2)
    length = np.linalg.norm(mean, axis=0)
    first = normal.reshape(3, count, -1)[:, :, 0]
    mean = np.where(length > 1e-3, mean / np.maximum(length, 1e-3), first)
    mean = mean / np.linalg.norm(mean, axis=0)
    plate, side, wide = _plate(corners - middle[:, :, None], mean)
    centre = corners.mean(axis=0)  # x y z, node, facet
    off = ((centre - middle[:, :, None]) ** 2).sum(axis=0).argmin(axis=1)
    point = np.take_along_axis(centre, off[None, :, None], axis=2)[:, :, 0]
    return middle, half, middle + plate, mean, side, wide, point, np.linalg.norm(half, axis=0)


def _plate(corners: Floats, normal: Floats) -> tuple[Floats, Floats, Floats]:
    """Middle (3, n), second direction (3, n) and half sizes (3, n) of the plates around corners (3, 3, n, facets)."""
    one = np.cross(normal, np.eye(3)[np.abs(normal).argmin(axis=0)].T, axis=0)
    one = one / np.linalg.norm(one, axis=0)
    two = np.cross(normal, one, axis=0)
    x, y = (np.einsum("in,cinf->cnf", way, corners) for way in (one, two))
    x, y = x - x.mean(axis=(0, 2))[:, None], y - y.mean(axis=(0, 2))[:, None]
    turn = 0.5 * np.arctan2(2.0 * (x * y).sum(axis=(0, 2)), (x * x - y * y).sum(axis=(0, 2)))
    side = np.cos(turn) * one + np.sin(turn) * two
    ways = np.stack([normal, side, np.cross(normal, side, axis=0)])
    along = np.einsum("kin,cinf->kcnf", ways, corners)
    low, high = along.min(axis=(1, 3)), along.max(axis=(1, 3))
    return np.einsum("kn,kin->in", 0.5 * (low + high), ways), side, 0.5 * (high - low)
