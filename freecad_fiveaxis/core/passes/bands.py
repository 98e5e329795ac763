# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which closed passes lie round one another, one after the other: what a spiral may run through.

loop      a closed level line of the field, no border on it.
band      facets between two levels that hang together. It leads from one loop to the next where these two are
          all that bounds it, with no hole, no branch and no handle: its Euler characteristic is that of a
          ring, 0.
chain     bands one on the other, each leading from the loop below it to the one above it. It ends where
          passes part or meet, where one is open, and where two neighbouring levels lie apart otherwise than
          the next two.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.mesh import Mesh

EVEN = 1.3
"""Times that levels may lie farther apart than their neighbours: a turn of a spiral lies between both."""

FEWEST = 2
"""Bands of a chain at least. One band would be cut by three turns where two loops do."""


class Loops(NamedTuple):
    """The level lines: of each co-edge on them (c,) the facets ``under`` and ``over`` it and the line that it
    belongs to, ``of``; of each line (l,) whether it is ``closed``."""

    under: Ints
    over: Ints
    of: Ints
    closed: Bools


def find_chains(mesh: Mesh, slab: Ints, levels: Floats) -> tuple[Bools, Ints]:
    """Find the facets (f,) of a mesh, divided at ``levels`` (k,), that lie in chains, and the facets (n, 2)
    to either side of all co-edges on loops of chains, the lower ones first; ``slab`` (f,) of each facet."""
    loops = find_loops(mesh, slab)
    band = _group_facets(mesh, slab)
    low, high = _only_lines(band, loops, loops.over), _only_lines(band, loops, loops.under)
    leads = (low >= 0) & (high >= 0) & (_euler(mesh, band) == 0)
    level = np.zeros(len(leads), np.int64)
    level[band] = slab
    leads = _long_enough(leads & _even(leads, low, high, level, levels), low, high, len(loops.closed))
    ridden = np.zeros(len(loops.closed), np.bool_)
    ridden[low[leads]] = ridden[high[leads]] = True
    on = ridden[loops.of]
    return leads[band], np.stack([loops.under[on], loops.over[on]], axis=1)


def find_loops(mesh: Mesh, slab: Ints) -> Loops:
    """Find the level lines of a mesh whose facets lie in one ``slab`` (f,) each."""
    two = mesh.coedge_face[:, 1] >= 0
    coedge = np.flatnonzero(two & (slab[mesh.coedge_face[:, 0]] != slab[mesh.coedge_face[:, 1]]))
    side, ends = mesh.coedge_face[coedge], mesh.coedge_vertex[coedge]
    first = slab[side[:, 0]] < slab[side[:, 1]]
    of = np.unique(_components(ends[:, 0], ends[:, 1], len(mesh.vertex))[ends[:, 0]], return_inverse=True)[
        1
    ].astype(np.int64)
    single = np.bincount(ends.reshape(-1), minlength=len(mesh.vertex))[ends] != 2
    closed = np.bincount(of, single.any(axis=1), int(of.max(initial=-1)) + 1) == 0
    return Loops(np.where(first, side[:, 0], side[:, 1]), np.where(first, side[:, 1], side[:, 0]), of, closed)


def _components(one: Ints, two: Ints, count: int) -> Ints:
    graph = scipy.sparse.coo_matrix((np.ones(len(one)), (one, two)), shape=(count, count))
    return np.asarray(scipy.sparse.csgraph.connected_components(graph, directed=False)[1], np.int64)


def _group_facets(mesh: Mesh, slab: Ints) -> Ints:
    """Return the band (f,) of each facet."""
    one, two = mesh.coedge_face[mesh.coedge_face[:, 1] >= 0].T
    same = slab[one] == slab[two]
    return _components(one[same], two[same], len(mesh.face))


def _only_lines(band: Ints, loops: Loops, beside: Ints) -> Ints:
    """Of each band (b,) the closed line that its facets lie ``beside`` (c,) on one side of; -1 where it is
    not the only one."""
    pair = np.unique(np.stack([band[beside], loops.of], axis=1), axis=0)
    line, count = (
        np.full(int(band.max(initial=-1)) + 1, -1),
        np.bincount(pair[:, 0], minlength=int(band.max(initial=-1)) + 1),
    )
    line[pair[:, 0]] = pair[:, 1]
    line[(count != 1) | ~np.append(loops.closed, False)[line]] = -1
    return line


def _euler(mesh: Mesh, band: Ints) -> Ints:
    """Vertices less sides and facets of each band (b,)."""
    count = int(band.max(initial=-1)) + 1
    side = np.where(mesh.coedge_face < 0, -1, band[mesh.coedge_face])
    other = (side[:, 1] >= 0) & (side[:, 1] != side[:, 0])
    edges = np.bincount(np.concatenate([side[:, 0], side[other, 1]]), minlength=count)
    corner = np.unique(np.repeat(band, 3) * len(mesh.vertex) + mesh.face.reshape(-1)) // max(
        len(mesh.vertex), 1
    )
    return np.bincount(corner, minlength=count) - edges + np.bincount(band, minlength=count)


def _even(leads: Bools, low: Ints, high: Ints, level: Ints, levels: Floats) -> Bools:
    """Bands (b,) that are not wider between their levels than the leading bands they hang on."""
    gap = np.append(np.diff(levels, prepend=-np.inf), np.inf)[level]
    rows = np.flatnonzero(leads)
    widest, lines = np.full(len(leads), np.inf), int(max(low.max(initial=-1), high.max(initial=-1))) + 1
    for mine, other in ((low, high), (high, low)):
        beside = np.full(lines, np.inf)
        beside[other[rows]] = gap[rows]
        widest[rows] = np.minimum(widest[rows], beside[mine[rows]])
    return np.asarray(gap <= EVEN * widest)


def _long_enough(leads: Bools, low: Ints, high: Ints, lines: int) -> Bools:
    """Of the bands (b,) that lead on those that enough others hang on."""
    rows = np.flatnonzero(leads)
    chain = _components(low[rows], high[rows], max(lines, 1))[low[rows]]
    long = np.zeros(len(leads), np.bool_)
    long[rows] = (np.bincount(chain, minlength=1)[chain]) >= FEWEST if len(rows) else False
    return long
