# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that face the other way than their neighbours are turned round.

Two facets of one edge face the same way where they run along it in opposite senses. Of facets that hang
together by such edges each way of facing is one class: a graph with two nodes a facet, as it is and turned,
falls into two mirrored parts. The part that keeps the larger area as it is holds; where both are one part the
surface has one side only (a Moebius strip), and nothing is turned.
"""

from __future__ import annotations

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .join import number_edges


def find_turned(face: Ints, area: Floats) -> Bools:
    """Find the facets (f,) of ``face`` (f, 3) that face the other way than most of the ``area`` (f,) mm2
    which hangs together with them."""
    count = len(face)
    one, two, alike = _neighbours(face)
    other = np.where(alike, count, 0)  # two that run alike along their edge: one of them is to be turned
    rows, columns = np.concatenate([one, one + count]), np.concatenate([two + other, two + count - other])
    graph = scipy.sparse.coo_matrix((np.ones(len(rows), np.int8), (rows, columns)), (2 * count, 2 * count))
    part = scipy.sparse.csgraph.connected_components(graph, directed=False)[1].astype(np.int64)
    kept, turned = part[:count], part[count:]
    kept_area = np.bincount(kept, area, int(part.max()) + 1)
    less, equal = kept_area[kept] < kept_area[turned], kept_area[kept] == kept_area[turned]
    return np.asarray(less | (equal & (kept > turned)))


def _neighbours(face: Ints) -> tuple[Ints, Ints, Bools]:
    """Return both facets (e,), (e,) of each edge that has two, and whether these run along it in the same
    sense."""
    side = number_edges(face)
    half = np.flatnonzero(side.shared == 2)
    one, two = half[np.argsort(side.edge[half], kind="stable")].reshape(-1, 2).T
    return one // 3, two // 3, side.start[one] == side.start[two]
