# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far round a ring a place is: a share of a turn, that grows by 1 along every loop of the ring.

ring      a component of a mesh with two borders, one round the other.
seam      a row of facets from the one border to the other. The sides that it crosses are where the share
          loses its turn.
share     is in balance at every vertex: the mean of its neighbours', each worth one over the length of the
          side to it. So it grows with the way along the loops, and has no summit and no basin.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .geodesic import Factored

SHORT = 1e-3
"""Of the mean length of sides: what is shorter counts as that long."""

TOUCH = 1e-5
"""Turns: no vertex lies nearer to where a turn begins."""


def find_turns(mesh: Mesh, component: Ints, height: Floats) -> Floats:
    """Find the share of a turn (f, 3) at the corners of facets of rings: 0 somewhere on a seam, with the
    whole turns that belong to the corner in its facet, so that it is linear over each facet. It grows along
    loops with what is higher to their left. ``component`` (v,); ``height`` (v,): least on the lower border of
    each ring, most on its upper one."""
    jump = _seam_jumps(mesh, component, height)
    share = _balance_share(mesh, component, jump)
    near = np.abs(share - np.round(share)) < TOUCH
    share = np.where(near, np.round(share) + TOUCH, share)
    sense = np.where(mesh.coedge_face[mesh.face_coedge, 0] == np.arange(len(mesh.face))[:, None], 1, -1)
    jump = (jump[mesh.face_coedge] * sense).astype(np.int64)
    first = -np.floor(share[mesh.face[:, 0]]).astype(np.int64)
    whole = np.stack([first, first - jump[:, 0], first + jump[:, 2]], axis=1)
    return np.asarray(share[mesh.face] + whole)


def _seam_jumps(mesh: Mesh, component: Ints, height: Floats) -> Floats:
    """Return what (e,) the share gains beyond its way along each co-edge: 1 or -1 across a seam, else 0."""
    border = np.flatnonzero(mesh.coedge_face[:, 1] < 0)
    piece = component[mesh.coedge_vertex[border, 0]]
    middle = np.zeros((2, int(component.max(initial=-1)) + 1))
    middle[0], middle[1] = np.inf, -np.inf
    np.minimum.at(middle[0], component, height)
    np.maximum.at(middle[1], component, height)
    lower = height[mesh.coedge_vertex[border, 0]] < middle.mean(axis=0)[piece]
    on, before, entry, exit_ = _seam(mesh, border[lower], border[~lower], piece[~lower])
    jump = np.zeros(len(mesh.coedge_face))
    jump[entry], jump[exit_] = -1.0, 1.0
    facet = np.flatnonzero(on & (before >= 0))
    same = mesh.face_coedge[facet][:, :, None] == mesh.face_coedge[before[facet]][:, None, :]
    crossed = mesh.face_coedge[facet, same.any(axis=2).argmax(axis=1)]
    jump[crossed] = np.where(mesh.coedge_face[crossed, 0] == before[facet], 1.0, -1.0)
    return jump


def _seam(mesh: Mesh, lower: Ints, upper: Ints, piece: Ints) -> tuple[Bools, Ints, Ints, Ints]:
    """Facets (f,) on the shortest way of each ring from its ``lower`` border to its ``upper`` one, the facet
    before each, and the border co-edges by which the ways begin and end; ``piece``: the ring of each upper
    co-edge."""
    count, middle = len(mesh.face), mesh.vertex[mesh.face].mean(axis=1)
    one, two = mesh.coedge_face[mesh.coedge_face[:, 1] >= 0].T
    way = np.maximum(np.linalg.norm(middle[one] - middle[two], axis=1), 1e-9)
    graph = scipy.sparse.coo_matrix(
        (np.tile(way, 2), (np.append(one, two), np.append(two, one))), (count, count)
    ).tocsr()
    begins = mesh.coedge_face[lower, 0]
    off, before, _ = scipy.sparse.csgraph.dijkstra(
        graph, indices=np.unique(begins), return_predecessors=True, min_only=True
    )
    order = np.lexsort((off[mesh.coedge_face[upper, 0]], piece))
    exit_ = upper[order[np.flatnonzero(np.diff(piece[order], prepend=-1))]]
    on = _with_all_before(before, mesh.coedge_face[exit_, 0])
    first = np.full(count, -1)
    first[begins] = lower
    entry = first[on & (before < 0)]
    return on, before, entry, exit_


def _with_all_before(before: Ints, ends: Ints) -> Bools:
    """Rows (n,) from which ``before`` (n,), negative at a beginning, leads back from the ``ends``."""
    count = len(before)
    on, leap = np.zeros(count + 1, np.bool_), np.append(np.where(before < 0, count, before), count)
    on[ends] = True
    for _ in range(count.bit_length()):  # each round doubles how far it leads back
        on[leap[on]] = True
        leap = leap[leap]
    return on[:-1]


def _balance_share(mesh: Mesh, component: Ints, jump: Floats) -> Floats:
    """Return the share (v,) of least change along the co-edges, each less its ``jump`` (e,)."""
    (one, two), count = mesh.coedge_vertex.T, len(mesh.vertex)
    length = np.linalg.norm(mesh.vertex[two] - mesh.vertex[one], axis=1)
    weight = 1.0 / np.maximum(length, SHORT * float(length.mean()))
    rows, columns = np.concatenate([one, two, one, two]), np.concatenate([two, one, one, two])
    whole: Any = (np.concatenate([-weight, -weight, weight, weight]), (rows, columns))
    stiff = scipy.sparse.coo_matrix(whole, (count, count)).tocsc()
    right = (np.bincount(two, weight * jump, count) - np.bincount(one, weight * jump, count)).astype(
        np.float64
    )
    pinned = np.unique(component, return_index=True)[1]
    inner, share = np.setdiff1d(np.arange(count), pinned), np.zeros(count)
    share[inner] = Factored(stiff, inner).solve(right)
    return share
