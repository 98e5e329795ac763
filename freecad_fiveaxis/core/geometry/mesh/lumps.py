# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lumps of a mesh: facets that hang together by their edges; and those of them that look inward.

A closed lump looks inward where its signed volume is below zero. Within the material of others it is a
cavity, and right; elsewhere it is a solid whose facets were written inside out.
"""

from __future__ import annotations

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

SAMPLES = 16
"""Corners of a lump that are looked at, at most: it lies within another where all of them do."""

ENDS = 1e-9
"""Of the size of a mesh: boxes no farther apart touch."""


def number_lumps(coedge_face: Ints, count: int) -> Ints:
    """Return the number (f,) of the lump of each of ``count`` facets; ``coedge_face`` (e, 2): the facets
    beside each edge, below zero for none."""
    one, other = coedge_face[coedge_face[:, 1] >= 0].T
    graph = scipy.sparse.coo_matrix((np.ones(len(one), np.int8), (one, other)), shape=(count, count))
    return np.asarray(scipy.sparse.csgraph.connected_components(graph, directed=False)[1], np.int64)


def find_boxes(vertex: Floats, face: Ints, lump: Ints) -> tuple[Floats, Floats]:
    """Return the low and the high corner (k, 3) mm of the box of each lump."""
    count = int(lump.max()) + 1
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    for corner in face.T:
        np.minimum.at(low, lump, vertex[corner])
        np.maximum.at(high, lump, vertex[corner])
    return low, high


def pair_boxes(low: Floats, high: Floats) -> Ints:
    """Find the pairs (p, 2) of boxes, low and high corner (k, 3) mm, that have a place in common."""
    wide = np.argsort(low[:, 0])
    low, high = low[wide], high[wide]
    last, pairs = np.searchsorted(low[:, 0], high[:, 0], side="right"), [np.empty((0, 2), np.int64)]
    for one in np.flatnonzero(last > np.arange(len(low)) + 1).tolist():  # lumps, not facets: few
        others = np.arange(one + 1, last[one])
        met = others[((low[others] <= high[one]) & (high[others] >= low[one])).all(axis=1)]
        pairs.append(np.column_stack([np.full(len(met), one), met]))
    return np.asarray(wide[np.concatenate(pairs)])


def number_apart(vertex: Floats, face: Ints, lump: Ints) -> Ints:
    """Return the numbers (f,) of the lumps, those whose boxes touch counted as one."""
    low, high = find_boxes(vertex, face, lump)
    room = ENDS * float(np.ptp(vertex, axis=0).max())
    one, other = pair_boxes(low - room, high + room).T
    graph = scipy.sparse.coo_matrix((np.ones(len(one), np.int8), (one, other)), shape=(len(low), len(low)))
    return np.asarray(scipy.sparse.csgraph.connected_components(graph, directed=False)[1][lump], np.int64)


def find_inward(vertex: Floats, face: Ints, lump: Ints, closed: Bools) -> Bools:
    """Find the facets (f,) of lumps that look inward and are no cavities of others; only those ``closed``
    (k,) count."""
    if not closed.any():
        return np.zeros(len(face), np.bool_)
    corner = vertex[face] - vertex.mean(axis=0)
    volume = np.bincount(lump, np.linalg.det(corner) / 6.0)
    inward, (low, high) = np.zeros(len(volume), np.bool_), find_boxes(vertex, face, lump)
    for one in np.flatnonzero(closed & (volume < 0.0)).tolist():
        around = np.flatnonzero(closed & (low < low[one]).all(axis=1) & (high > high[one]).all(axis=1))
        places = vertex[np.unique(face[lump == one])]
        places = places[:: -(-len(places) // SAMPLES)]
        inward[one] = sum(_is_within(places, vertex[face[lump == other]]) for other in around) % 2 == 0
    return np.asarray(inward[lump])


def _is_within(place: Floats, corner: Floats) -> bool:
    """Tell whether all places (n, 3) mm lie within closed facets (k, 3, 3), by the angle in which these are
    seen from there (van Oosterom and Strackee 1983)."""
    return all(_measure_angle(corner - one) > 2.0 * np.pi for one in place)


def _measure_angle(corner: Floats) -> float:
    """Measure the solid angle of facets (k, 3, 3) seen from the origin, without its sign."""
    a, b, c = corner.transpose(1, 0, 2)
    la, lb, lc = (np.linalg.norm(one, axis=1) for one in (a, b, c))
    below = la * lb * lc + (a * b).sum(axis=1) * lc + (b * c).sum(axis=1) * la + (c * a).sum(axis=1) * lb
    return float(abs(2.0 * np.arctan2(np.linalg.det(corner), below).sum()))
