# SPDX-License-Identifier: LGPL-2.1-or-later
"""How parallel planes cut a mesh, and how the cuts follow one another.

level      of a vertex: the number of planes at or below it. Plane k cuts the edges from level k or less to more than k, so a
           vertex on a plane belongs to the upper side and no case needs a tolerance (simulation of simplicity:
           Edelsbrunner & Muecke, ACM Transactions on Graphics 9 (1990), 66-104).
crossing   one plane through one co-edge. Both facets of the co-edge use the same crossing, so their points are the same bits.
node       one plane through one facet. Seen along the travel it is entered where the facet's boundary goes down through the
           plane and left where it goes up; the crossing by which it is left leads to the next node.
chain      a run of nodes, each next to the one before it; open, or closed.

The nodes of a facet are numbered one after another in order of plane, so the next node is ``base[next facet] + plane``:
nothing is searched for or sorted.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import depth_first_order

from .mesh import Mesh
from .records import Bools, Floats, Ints

NOWHERE = -(1 << 40)  # base of a facet that is not there; stays negative whatever plane is added


@dataclass(frozen=True, eq=False)
class Crossings:
    """All crossings of a mesh, one row each, and their nodes.

    ``coedge``, ``plane`` (x,); ``along`` and ``height`` (x,) mm: the point's coordinates along the travel and along z;
    ``leaves`` (x,) the facet that is left here; ``node_left`` and ``node_entered`` (x,), negative where there is none;
    ``rising`` rows where a facet that looks down is followed by one that looks up; ``nodes`` their number.
    """

    coedge: Ints
    plane: Ints
    along: Floats
    height: Floats
    leaves: Ints
    node_left: Ints
    node_entered: Ints
    rising: Ints
    nodes: int


def levels(distance: Floats, offsets: Floats) -> Ints:
    """Number of ascending ``offsets`` (k,) at or below each ``distance`` (v,)."""
    return np.searchsorted(offsets, distance, side="right").astype(np.int64, copy=False)


def find_crossings(mesh: Mesh, offsets: Floats, along: Floats, distance: Floats, keep: Bools | None) -> Crossings:
    """Crossings of the planes at ascending ``offsets`` (k,) with the facets that ``keep`` (f,) has.

    ``along`` and ``distance`` (v,): the vertices' coordinates along the travel and across it, mm.
    """
    level = levels(distance, offsets)
    base, nodes = _bases(mesh, level, keep)

    one, two = (level.take(v) for v in mesh.coedge_vertex.T)
    coedge = np.flatnonzero(one != two)
    one, two = one.take(coedge), two.take(coedge)
    down = (one > two) * len(mesh.coedge_vertex)  # shifts to the other end, the other side
    up = len(mesh.coedge_vertex) - down
    sides, ends = mesh.coedge_face.T.reshape(-1), mesh.coedge_vertex.T.reshape(-1)
    left, entered = sides.take(coedge + down), sides.take(coedge + up)
    bottom, top = ends.take(coedge + down), ends.take(coedge + up)

    low = np.minimum(one, two)
    count = np.maximum(one, two) - low
    first = np.cumsum(count) - count
    total = int(first[-1] + count[-1]) if len(count) else 0
    row = np.repeat(np.arange(len(coedge)), count)
    plane = np.arange(total) + (low - first).take(row)

    here, there = distance.take(top), distance.take(bottom)
    share = (here.take(row) - offsets.take(plane)) / (here - there).take(row)  # 0 at the top: a vertex on a plane is met exactly
    points = []
    for value in (along, mesh.vertex[:, 2]):
        here = value.take(top)
        points.append(here.take(row) + share * (value.take(bottom) - here).take(row))

    upward = np.append(mesh.normal[:, 2] > 0.0, False)
    rising = np.flatnonzero((upward[entered] & ~upward[left]).take(row))
    node_left, node_entered = (base.take(f).take(row) + plane for f in (left, entered))
    return Crossings(coedge.take(row), plane, points[0], points[1], left.take(row), node_left, node_entered, rising, nodes)


def _bases(mesh: Mesh, level: Ints, keep: Bools | None) -> tuple[Ints, int]:
    """First node of each facet less its first plane, NOWHERE for facets left out and for row -1; number of nodes."""
    a, b, c = (level.take(v) for v in mesh.face.T)
    low = np.minimum(np.minimum(a, b), c)
    count = np.maximum(np.maximum(a, b), c) - low
    if keep is not None:
        count *= keep
    base = np.empty(len(count) + 1, dtype=np.int64)
    np.cumsum(count, out=base[:-1])
    nodes = int(base[-2]) if len(count) else 0
    base[:-1] -= count
    base[:-1] -= low
    base[-1] = NOWHERE
    if keep is not None:
        base[:-1][~keep] = NOWHERE
    return base, nodes


def chain(cross: Crossings) -> tuple[Ints, Ints]:
    """All nodes as chains of crossings: the crossings of one chain after another, and the rows where chains begin.

    A chain of m nodes has m + 1 crossings; that of a closed one is the same at both ends. Chains go by plane, then by
    where they start along the travel; a closed chain starts at a place where it turns from looking down to looking up.
    """
    n = cross.nodes
    left, entered = np.maximum(cross.node_left, -1), cross.node_entered
    follower = np.full(n + 1, n)
    follower[left] = np.where(entered < 0, n, entered)
    leave = np.zeros(n + 1, dtype=np.int64)
    leave[left] = np.arange(len(left))

    opening = np.flatnonzero((left < 0) & (entered >= 0))
    turning = cross.rising.take(np.flatnonzero((left.take(cross.rising) >= 0) & (entered.take(cross.rising) >= 0)))
    turning = turning.take(np.argsort(cross.along.take(turning)))
    start = np.concatenate([opening, turning])
    order = _depth_first(follower, entered.take(start))
    if len(order) < n + len(start):
        missed = np.ones(n + 1, dtype=np.bool_)
        missed[np.minimum(order, n)] = False
        start = np.concatenate([start, np.flatnonzero((entered >= 0) & missed.take(entered, mode="clip"))])
        order = _depth_first(follower, entered.take(start))

    root = np.flatnonzero(order >= n)
    nodes = np.diff(root, append=len(order)) - 1
    used = np.flatnonzero(nodes)
    used = used.take(np.lexsort((cross.along.take(start.take(used)), cross.plane.take(start.take(used)))))
    root, nodes, start = root.take(used), nodes.take(used), start.take(used)
    first = np.cumsum(nodes + 1) - (nodes + 1)
    row = np.arange(int((nodes + 1).sum())) + np.repeat(root - first, nodes + 1)
    crossing = leave.take(order.take(row), mode="clip")
    crossing[first] = start
    return crossing, first


def _depth_first(follower: Ints, head: Ints) -> Ints:
    """Nodes in order of their chains; before each chain stands a row of n or more.

    The graph gives each head a root that leads to the head and then to the next root; a chain that ends leads to the
    first root, which has been visited already, as has a node that an earlier head reached.
    """
    n, roots = len(follower) - 1, len(head)
    if not roots:
        return head
    child = np.empty(n + 2 * roots, dtype=np.int32)
    child[:n] = follower[:n]
    child[n::2] = head
    child[n + 1 :: 2] = n + np.minimum(np.arange(1, roots + 1), roots - 1)
    begin = np.concatenate([np.arange(n, dtype=np.int32), np.arange(n, n + 2 * roots + 1, 2, dtype=np.int32)])
    graph = csr_matrix((np.ones(len(child)), child, begin), shape=(n + roots, n + roots))
    order: Ints = depth_first_order(graph, n, return_predecessors=False).astype(np.int64)
    return order
