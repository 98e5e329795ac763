# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facets of a mesh in a tree of nodes, so that most of them are never looked at.

node      some facets that lie together: a box around them, a slab between two parallel planes across their mean normal, and one
          point of the part among them. The last nodes are the facets themselves, whose slab has no thickness.
level     all nodes with equally many facets; the nodes of all levels stand in one table, the root first.

The tree is perfectly balanced: at each level the facets of every node are parted at the median of what spreads most, place or
normal, all nodes at once. It is filled up with copies of the last facets.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.mesh import Mesh
from freecad_fiveaxis.core.records import Bools, Floats, Ints

LEAF = 4
"""At least so many facets hang on each of the last nodes but one (fewer where the mesh has fewer)."""

BEND = 0.2
"""What a change of the normals by 1 counts for in parting, as a share of the node's size."""


@dataclass(frozen=True, eq=False)
class FacetTree:
    """``facet`` (k,) row of the mesh of each leaf, ``corner`` (9, k) its corners a, b, c, mm. Of all nodes: ``middle``, ``half``
    (3, n) mm the box, ``normal`` (3, n) unit, ``low``, ``high`` (n,) mm the slab, ``point`` (3, n) mm one of the part's points,
    ``size`` (n,) mm half the box's diagonal; ``child`` (n,) the first child and ``arity`` (n,) how many, 0 at a leaf; ``leaf``
    the first node that is a facet; ``facet_first`` (k,) False for copies."""

    facet: Ints
    corner: Floats
    middle: Floats
    half: Floats
    normal: Floats
    low: Floats
    high: Floats
    point: Floats
    size: Floats
    child: Ints
    arity: Ints
    leaf: int
    facet_first: Bools


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
    middle, half, mean, low, high, point, size = (np.concatenate(part, axis=-1) for part in zip(*levels, strict=True))
    once = np.zeros(len(order), np.bool_)
    once[np.unique(order, return_index=True)[1]] = True
    children, arities = np.concatenate(child), np.concatenate(arity)
    leaf = start - counts[-1]
    return FacetTree(order, corner, middle, half, mean, low, high, point, size, children, arities, leaf, once)


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
    """Box, slab, point and size of ``count`` nodes of equally many facets."""
    corners = corner.reshape(3, 3, count, -1)  # corner, x y z, node, facet
    top, bottom = corners.max(axis=(0, 3)), corners.min(axis=(0, 3))
    middle, half = 0.5 * (top + bottom), 0.5 * (top - bottom)
    mean = normal.reshape(3, count, -1).mean(axis=2)
    length = np.linalg.norm(mean, axis=0)
    first = normal.reshape(3, count, -1)[:, :, 0]
    mean = np.where(length > 1e-3, mean / np.maximum(length, 1e-3), first)
    mean = mean / np.linalg.norm(mean, axis=0)
    along = np.einsum("in,cinf->cnf", mean, corners)
    centre = corners.mean(axis=0)  # x y z, node, facet
    off = ((centre - middle[:, :, None]) ** 2).sum(axis=0).argmin(axis=1)
    point = np.take_along_axis(centre, off[None, :, None], axis=2)[:, :, 0]
    return middle, half, mean, along.min(axis=(0, 2)), along.max(axis=(0, 2)), point, np.linalg.norm(half, axis=0)
