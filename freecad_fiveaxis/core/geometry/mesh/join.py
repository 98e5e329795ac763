# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that ought to hang together are joined where that is safe: doubled facets, corners a rounding apart,
T-junctions.

doubled     a facet with the same corners in the same sense as another: one is kept.
cluster     corners on the border that lie nearer than :func:`_near`: one vertex of them.
T-junction  a vertex on the side of a facet that ends there: that facet is divided at it.
flawed      an edge with more than two facets, with two that run along it in the same sense, or that fold back
            onto each other as both sides of a thin wall do. What would make one, or a facet without area,
            stays as it is.

Only facets with a vertex on the border are looked at; arrays of half-edges (3 f,) have side k of facet i in
row 3 i + k.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

NEAR = 1e-2
"""Of the shortest side at a corner: another corner that is nearer lies there, where it is nearer than ``GAP``
too."""

ON_SIDE = 1e-5
"""Of the shortest side at a place: a vertex that is nearer to a side lies on it. Where corners are too far
apart to be joined, more would divide facets at each of them, over and over."""

GAP = 2e-3
"""mm: a wider gap between facets is never closed. An STL file's own rounding is 1e-7 of the part's size; what
is joined moves the surface by less than a fifth of the usual tolerance."""

FOLDED = 0.14
"""Sum of two unit normals that is shorter: facets at less than 8 deg from each other, as the two sides of a
thin wall."""

NEIGHBOURS = 12
"""Corners at one place, at most; a vertex of a usual mesh has six facets."""

HALVINGS = 40
"""Of a side, until few vertices are near each of its pieces."""

ROUNDS = 8
"""Times that facets are divided: once for each of their sides, and for those of what they became."""


class Joined(NamedTuple):
    """``face`` (f, 3) facets as rows of the old vertices; ``doubled`` (d,) a vertex of each facet left out,
    ``corners`` (c,) vertices that others stand for now, ``junctions`` (t,) vertices at which facets were
    divided."""

    face: Ints
    doubled: Ints
    corners: Ints
    junctions: Ints


def join_facets(vertex: Floats, face: Ints, rim: Bools) -> Joined | None:
    """Return what becomes of facets (f, 3) of vertices (v, 3) mm of which those in ``rim`` (v,) lie on the
    border; None: nothing."""
    near = rim[face].any(axis=1)
    kept, doubled = _without_doubled(np.ascontiguousarray(face[near]))
    kept, corners = _join_corners(vertex, kept, rim)
    kept, junctions = _split_junctions(vertex, kept, rim)
    if not len(doubled) + len(corners) + len(junctions):
        return None
    return Joined(np.concatenate([face[~near], kept]), doubled, corners, junctions)


class Sides(NamedTuple):
    """``start``, ``end`` (3 f,) vertices of the half-edges, ``edge`` (3 f,) their edges, ``shared`` (3 f,)
    half-edges of it."""

    start: Ints
    end: Ints
    edge: Ints
    shared: Ints


def number_edges(face: Ints) -> Sides:
    """Give the edges of facets (f, 3) numbers, one for all half-edges between the same two vertices."""
    start, end = face.reshape(-1), np.roll(face, -1, axis=1).reshape(-1)
    key = np.minimum(start, end) * (int(face.max(initial=0)) + 1) + np.maximum(start, end)
    _, edge, count = np.unique(key, return_inverse=True, return_counts=True)
    edge = edge.reshape(-1).astype(np.int64)
    return Sides(start, end, edge, count[edge])


def _open(side: Sides, rim: Bools) -> Bools:
    """Half-edges (3 f,) on the border."""
    return np.asarray((side.shared == 1) & rim[side.start] & rim[side.end])


def _find_flawed(vertex: Floats, face: Ints, side: Sides) -> Bools:
    """Half-edges (3 f,) of flawed edges."""
    turn = np.bincount(side.edge, np.where(side.start < side.end, 1.0, -1.0))[side.edge]
    normal = np.repeat(_normals(vertex, face), 3, axis=0)
    both = np.array([np.bincount(side.edge, column)[side.edge] for column in normal.T])
    folded = np.linalg.norm(both, axis=0) < FOLDED
    flawed: Bools = (side.shared > 2) | ((side.shared == 2) & ((turn != 0.0) | folded))
    return flawed


def _normals(vertex: Floats, face: Ints) -> Floats:
    """Return unit normals (f, 3), 0 of facets without area."""
    a, b, c = (vertex[corner] for corner in face.T)
    normal = np.cross(b - a, c - a)
    size = np.linalg.norm(normal, axis=1)
    return np.asarray(normal / np.where(size > 0.0, size, 1.0)[:, None])


def _shortest(vertex: Floats, side: Sides) -> Floats:
    """Return the shortest side (v,) mm at each vertex; without end where there is none."""
    shortest, length = (
        np.full(len(vertex), np.inf),
        np.linalg.norm(vertex[side.end] - vertex[side.start], axis=1),
    )
    for at in (side.start, side.end):
        np.minimum.at(shortest, at, length)
    return shortest


def _near(shortest: Floats) -> Floats:
    """Return how near (n,) mm what lies at one place is, by the ``shortest`` sides (n,) mm there."""
    return np.minimum(NEAR * shortest, GAP)


# --------------------------------------------------------------------------------------------- doubled facets


def _without_doubled(face: Ints) -> tuple[Ints, Ints]:
    """Return the facets but those that are there twice, and the first vertices (d,) of those."""
    turn = (face.argmin(axis=1)[:, None] + np.arange(3)) % 3
    _, first = np.unique(np.take_along_axis(face, turn, axis=1), axis=0, return_index=True)
    again = np.ones(len(face), np.bool_)
    again[first] = False
    return face[~again], face[again, 0]


# ------------------------------------------------------------------------------------------------ corners


def _join_corners(vertex: Floats, face: Ints, rim: Bools) -> tuple[Ints, Ints]:
    """Return the facets with the clusters of their corners joined, and the vertices (c,) that are gone."""
    side = number_edges(face)
    was_open = _open(side, rim)
    place, shortest = _clusters(vertex, side, was_open), _shortest(vertex, side)
    while True:
        gone = np.flatnonzero(place != np.arange(len(place)))
        if not len(gone):
            return face, gone
        wrong = _unfit(vertex, face, place, was_open) | _find_scattered(vertex, place, gone, shortest)
        if not wrong.any():
            return place[face], gone
        place = np.where(wrong[place], np.arange(len(place)), place)


def _clusters(vertex: Floats, side: Sides, was_open: Bools) -> Ints:
    """For each vertex (v,) the first one of its cluster."""
    place, corner = (
        np.arange(len(vertex)),
        np.unique(np.concatenate([side.start[was_open], side.end[was_open]])),
    )
    near = _near(_shortest(vertex, side)[corner])
    if len(corner) < 2:
        return place
    away, other = scipy.spatial.cKDTree(vertex[corner]).query(
        vertex[corner], k=min(NEIGHBOURS, len(corner)), distance_upper_bound=1.001 * float(near.max())
    )
    one, rank = np.nonzero(away <= near[:, None])
    two = other[one, rank]
    close = away[one, rank] <= near[two]
    graph = scipy.sparse.coo_matrix(
        (np.ones(int(close.sum())), (one[close], two[close])), (len(corner), len(corner))
    )
    number = scipy.sparse.csgraph.connected_components(graph, directed=False)[1]
    place[corner] = corner[np.unique(number, return_index=True)[1]][number]
    return place


def _unfit(vertex: Floats, face: Ints, place: Ints, was_open: Bools) -> Bools:
    """First vertices (v,) of clusters that would make a facet without area or a flawed edge, or that close no
    edge."""
    new = place[face]
    side, merged, wrong = number_edges(new), np.zeros(len(place), np.bool_), np.zeros(len(place), np.bool_)
    merged[place[place != np.arange(len(place))]] = True
    thin = (new == np.roll(new, -1, axis=1)).any(axis=1)
    wrong[new[thin]] = True
    flawed = _find_flawed(vertex, new, side)
    useful = np.zeros(len(place), np.bool_)
    for ends in (side.start, side.end):
        wrong[ends[flawed]] = True
        useful[ends[was_open & (side.shared == 2)]] = True
    return merged & (wrong | ~useful)


def _find_scattered(vertex: Floats, place: Ints, gone: Ints, shortest: Floats) -> Bools:
    """First vertices (v,) of clusters with a corner too far from the first one."""
    away = np.linalg.norm(vertex[gone] - vertex[place[gone]], axis=1)
    wrong = np.zeros(len(place), np.bool_)
    wrong[place[gone[away > _near(np.minimum(shortest[gone], shortest[place[gone]]))]]] = True
    return wrong


# ------------------------------------------------------------------------------------------------ T-junctions


def _split_junctions(vertex: Floats, face: Ints, rim: Bools) -> tuple[Ints, Ints]:
    """Return the facets, divided at vertices that lie on their sides, and those vertices (t,)."""
    found = [np.empty(0, np.int64)]
    for _ in range(ROUNDS):
        half, at, share = _junctions(vertex, face, rim)
        usable = np.ones(len(face), np.bool_)
        while len(half):
            split, owner = _divide_facets(face, half, at, share)
            bad = _unfit_parts(vertex, face, split, owner)
            if not bad.any():
                break
            usable &= ~bad
            row = usable[half // 3]
            half, at, share = half[row], at[row], share[row]
        if not len(half):
            break
        found.append(at)
        face = split
    return face, np.unique(np.concatenate(found))


def _junctions(vertex: Floats, face: Ints, rim: Bools) -> tuple[Ints, Ints, Floats]:
    """Half-edges (j,) on the border on which other vertices (j,) of it lie, and where: shares (j,); one side
    of a facet only."""
    side = number_edges(face)
    half = np.flatnonzero(_open(side, rim))
    corner = np.unique(side.start[half])
    if len(corner) < 2:
        return half[:0], corner[:0], np.empty(0)
    shortest = _shortest(vertex, side)
    near = ON_SIDE * np.minimum(shortest[side.start[half]], shortest[side.end[half]])
    row, at = _candidates(vertex[corner], vertex[side.start[half]], vertex[side.end[half]], near)
    half, at, near = half[row], corner[at], np.minimum(near[row], ON_SIDE * shortest[corner[at]])
    start, way = vertex[side.start[half]], vertex[side.end[half]] - vertex[side.start[half]]
    length = np.linalg.norm(way, axis=1)
    along = np.einsum("ij,ij->i", vertex[at] - start, way) / length
    off = np.linalg.norm(vertex[at] - start - (along / length)[:, None] * way, axis=1)
    on = (
        (off <= near)
        & (along > near)
        & (along < length - near)
        & (face[half // 3] != at[:, None]).all(axis=1)
    )
    half, at, share = half[on], at[on], (along / length)[on]
    first = np.full(len(face), 3)
    np.minimum.at(first, half // 3, half % 3)
    on = half % 3 == first[half // 3]
    return half[on], at[on], share[on]


def _candidates(point: Floats, start: Floats, end: Floats, near: Floats) -> tuple[Ints, Ints]:
    """Pairs of segments (s,) and of points (p, 3) that may be nearer to them than ``near``: segments are
    halved until few points are about each."""
    tree, row, low, size = scipy.spatial.cKDTree(point), np.arange(len(start)), np.zeros(len(start)), 1.0
    length, segments, points = np.linalg.norm(end - start, axis=1), [], []
    most = min(NEIGHBOURS, len(point))
    for _ in range(HALVINGS):
        middle = start[row] + (low + 0.5 * size)[:, None] * (end - start)[row]
        about = 0.5 * size * length[row] * (1.0 + 1e-9) + near[row]
        few = tree.query_ball_point(middle, about, return_length=True) <= most
        other = tree.query(middle[few], k=list(range(1, most + 1)))[1]
        segments.append(np.repeat(row[few], most))
        points.append(other.reshape(-1))
        size *= 0.5
        row, low = np.repeat(row[~few], 2), np.repeat(low[~few], 2)
        low[1::2] += size
        if not len(row):
            break
    pair = np.unique(np.stack([np.concatenate(segments), np.concatenate(points)]), axis=1)
    return pair[0], pair[1]


def _divide_facets(face: Ints, half: Ints, at: Ints, share: Floats) -> tuple[Ints, Ints]:
    """Facets divided at vertices ``at`` (j,) of their half-edges (j,), and whose part (g,) each is; its side
    0 lies on the side that was divided."""
    facet, first = np.unique(half // 3, return_index=True)
    turn = (half[first] % 3)[:, None] + np.arange(3)
    a, b, c = np.take_along_axis(face[facet], turn % 3, axis=1).T
    count = len(facet)
    owner = np.concatenate([half // 3, facet, facet])
    order = np.lexsort((np.concatenate([share, np.full(count, -1.0), np.full(count, 2.0)]), owner))
    owner, point = owner[order], np.concatenate([at, a, b])[order]
    inner = owner[1:] == owner[:-1]
    owner = owner[:-1][inner]
    parts = np.stack([point[:-1][inner], point[1:][inner], c[np.searchsorted(facet, owner)]], axis=1)
    whole = np.setdiff1d(np.arange(len(face)), facet)
    return np.concatenate([face[whole], parts]), np.concatenate([whole, owner])


def _unfit_parts(vertex: Floats, face: Ints, split: Ints, owner: Ints) -> Bools:
    """Facets (f,) whose parts would turn over, have a flawed edge, or close no edge."""
    side, divided = number_edges(split), np.bincount(owner, minlength=len(face)) > 1
    turned = (_normals(vertex, split) * _normals(vertex, face)[owner]).sum(axis=1) < 0.9
    flawed = _find_flawed(vertex, split, side).reshape(-1, 3)[:, 0]
    closes = np.bincount(owner, side.shared.reshape(-1, 3)[:, 0] == 2, len(face)) > 0
    return divided & ((np.bincount(owner, turned | flawed, len(face)) > 0) | ~closes)
