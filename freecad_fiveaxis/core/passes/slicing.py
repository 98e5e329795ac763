# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the level sets of a field cut a mesh, and how the cuts follow one another. Parallel planes are those of
a linear field.

field      a value at each vertex, linear over each facet. What is said here of planes is true of the level
           sets of any field.
level      of a vertex: the number of planes at or below it. Plane k cuts the edges from level k or less to
           more than k, so a vertex on a plane belongs to the upper side and no case needs a tolerance
           (simulation of simplicity: Edelsbrunner & Muecke, ACM Transactions on Graphics 9 (1990), 66-104).
crossing   one plane through one co-edge. Both facets of the co-edge use the same crossing, so their points
           are the same bits.
node       one plane through one facet. Seen along the travel it is entered where the facet's boundary goes
           down through the plane and left where it goes up; the crossing by which it is left leads to the
           next node.
chain      a run of nodes, each next to the one before it; open, or closed.

The nodes of a facet are numbered one after another in order of plane, so the next node is ``base[next facet]
+ plane``: nothing is searched for or sorted.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.memory import check_memory
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, run_ids
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.mesh import Mesh

NO_FACET = -(1 << 40)  # base of a facet that is not there; stays negative whatever plane is added

MOST_SEGMENTS = 20_000_000
"""More than any job can want: a program of them is a file of some gigabytes."""

BYTES = 200
"""Of memory for each segment at least, slicing alone: two crossings, and twice two rows of a path."""


@dataclass(frozen=True, eq=False)
class Starts:
    """Crossings at which a chain may begin: ``crossing``, the ``node`` that is entered, ``along`` in mm, (s,)
    each."""

    crossing: Ints
    node: Ints
    along: Floats

    @classmethod
    def none(cls) -> Starts:
        """No rows."""
        return cls(np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64), np.empty(0))

    @classmethod
    def join(cls, parts: list[Starts]) -> Starts:
        """Return the rows of all parts, one after another."""
        return cls(
            np.concatenate([p.crossing for p in parts]),
            np.concatenate([p.node for p in parts]),
            np.concatenate([p.along for p in parts]),
        )

    def take(self, row: Ints) -> Starts:
        """Return the given rows."""
        return Starts(self.crossing.take(row), self.node.take(row), self.along.take(row))


@dataclass(frozen=True, eq=False)
class Crossings:
    """All crossings of a mesh, one row each, and how they link its nodes.

    ``coedge`` (x,); ``left`` (x,) the facet that is left here; ``place`` (c, x) mm: the columns that tell
    where the point is, the first one along the travel; ``next_node`` (n + 1,), n where there is none;
    ``exit`` (n + 1,) the crossing by which a node is left; ``base`` (f + 1,) as first_nodes gives it;
    ``opening`` the starts of open chains; ``turning`` places where the path turns from downward facets to
    upward ones: starts for closed chains. Row n belongs to no node.
    """

    coedge: Ints
    left: Ints
    place: Floats
    next_node: Ints
    exit: Ints
    base: Ints
    opening: Starts
    turning: Starts

    @property
    def along(self) -> Floats:
        """Where the points (x,) lie along the travel, mm."""
        along: Floats = self.place[0]
        return along


@dataclass(frozen=True, eq=False)
class _Piece:
    """Some crossings, a row each: ``coedge``, its vertices ``top`` and ``bottom``, facets ``left`` and
    ``entered``, ``plane``."""

    coedge: Ints
    top: Ints
    bottom: Ints
    left: Ints
    entered: Ints
    plane: Ints


def levels(distance: Floats, offsets: Floats) -> Ints:
    """Return number of ascending ``offsets`` (k,) at or below each ``distance`` (v,)."""
    level = np.empty(len(distance), dtype=np.int64)

    def fill(part: slice) -> None:
        level[part] = np.searchsorted(offsets, distance[part], side="right")

    in_threads(fill, chunks(len(distance)))
    return level


def first_nodes(mesh: Mesh, level: Ints, keep: Bools | None) -> tuple[Ints, int]:
    """First node of each facet less its first plane, NO_FACET for facets left out and for row -1; number of
    nodes."""
    base = np.empty(len(mesh.face) + 1, dtype=np.int64)

    def count(part: slice) -> int:
        """Return the number of nodes in the part; its first nodes, yet without those of the parts before it,
        go into ``base``."""
        a, b, c = (level.take(v) for v in mesh.face[part].T)
        low = np.minimum(np.minimum(a, b), c)
        number = np.maximum(np.maximum(a, b), c) - low
        if keep is not None:
            number *= keep[part]
        last = np.cumsum(number)
        np.subtract(last - number, low, out=base[:-1][part])
        return int(last[-1])

    parts = chunks(len(mesh.face))
    counts = in_threads(count, parts)
    for part, before in zip(parts, np.cumsum([0, *counts]).tolist(), strict=False):
        base[:-1][part] += before
    base[-1] = NO_FACET
    if keep is not None:
        base[:-1][~keep] = NO_FACET
    return base, sum(counts)


def _pieces(mesh: Mesh, level: Ints, keep: Bools | None) -> list[_Piece]:
    """Return the crossings of the facets that are kept, in pieces."""
    number = len(mesh.coedge_face)
    ends, sides = mesh.coedge_vertex.T.reshape(-1), mesh.coedge_face.T.reshape(-1)
    used = None if keep is None else np.append(keep, False)

    def of(part: slice) -> list[_Piece]:
        one, two = (level.take(v) for v in mesh.coedge_vertex[part].T)
        crossed = one != two
        if used is not None:
            first, second = mesh.coedge_face[part].T
            crossed &= used.take(first) | used.take(second)
        cut = np.flatnonzero(crossed)
        one, two = one.take(cut), two.take(cut)
        cut += part.start
        # entries of ``ends``: the end on the upper side; and of ``sides``: the facet that runs along the
        # co-edge downward
        upper = (two > one) * number + cut
        lower = 2 * cut + number - upper
        low = np.minimum(one, two)
        count = np.maximum(one, two) - low
        row = run_ids(count)
        plane = np.arange(len(row)) + (low + count - np.cumsum(count)).take(row)
        cuts = []
        for piece in chunks(len(row)):
            at = row[piece]
            up, down = upper.take(at), lower.take(at)
            cuts.append(
                _Piece(
                    cut.take(at),
                    ends.take(up),
                    ends.take(down),
                    sides.take(down),
                    sides.take(up),
                    plane[piece],
                )
            )
        return cuts

    return [piece for pieces in in_threads(of, chunks(number)) for piece in pieces]


def find_crossings(
    mesh: Mesh, offsets: Floats, columns: tuple[Floats, ...], distance: Floats, keep: Bools | None
) -> Crossings:
    """Crossings of the planes at ascending ``offsets`` (k,) with the facets that ``keep`` (f,) has.

    ``distance`` (v,): the field at the vertices, for planes the coordinate across the travel, mm; ``columns``
    of (v,) each: what is to be known of the crossings' places, the first one along the travel, mm.
    """
    level = levels(distance, offsets)
    base, nodes = first_nodes(mesh, level, keep)
    _check_size(nodes)
    present = base != NO_FACET
    upward = np.append(mesh.normal[:, 2] > 0.0, False)
    downward = present & ~upward
    upward &= present
    # every node has two crossings, so there are at most 2 n; memory that stays unused costs nothing
    label, place = np.empty((2, 2 * nodes), dtype=np.int64), np.empty((len(columns), 2 * nodes))
    next_node, exit_ = np.empty((2, nodes + 1), dtype=np.int64)

    def fill(piece: _Piece, here: slice) -> tuple[Starts, Starts]:
        label[0, here], label[1, here] = piece.coedge, piece.left
        _interpolate(piece, offsets, distance, columns, place[:, here])
        leave, enter = (base.take(facet) + piece.plane for facet in (piece.left, piece.entered))
        both = Starts(np.arange(here.start, here.stop), enter, place[0, here])
        outside = np.flatnonzero(leave < 0)
        opening = both.take(outside.take(np.flatnonzero(enter.take(outside) >= 0)))
        leave[outside] = nodes
        next_node[leave] = np.where(enter < 0, nodes, enter)
        exit_[leave] = both.crossing
        return opening, both.take(np.flatnonzero(upward.take(piece.entered) & downward.take(piece.left)))

    pieces = _pieces(mesh, level, keep)
    bounds = np.cumsum([0, *(len(piece.plane) for piece in pieces)]).tolist()
    total, none = bounds[-1], Starts.none()
    starts = in_threads(lambda at: fill(pieces[at], slice(bounds[at], bounds[at + 1])), range(len(pieces)))
    opening, turning = ([none, *(pair[end] for pair in starts)] for end in (0, 1))
    coedge, left = label[0, :total], label[1, :total]
    return Crossings(
        coedge, left, place[:, :total], next_node, exit_, base, Starts.join(opening), Starts.join(turning)
    )


def _check_size(segments: int) -> None:
    """Raise SettingsError, before the work, for more segments than any job can want or than can be held."""
    finer = say("give a larger stepover or scallop, or check the units of the part")
    if segments > MOST_SEGMENTS:
        text = say(
            "the planes cut the facets {segments} times, more than {most}; {remedy}",
            segments=segments,
            most=MOST_SEGMENTS,
            remedy=finer,
        )
        raise SettingsError(text, segments)
    check_memory(BYTES * segments, say("{segments} segments of passes", segments=segments), finer)


def _interpolate(
    piece: _Piece, offsets: Floats, distance: Floats, values: tuple[Floats, ...], out: Floats
) -> None:
    """``values`` at the crossings into the rows of ``out``, linear along each co-edge, exact where a vertex
    lies on the plane."""
    share = distance.take(piece.top)
    length = share - distance.take(piece.bottom)
    share -= offsets.take(piece.plane)
    share /= length
    for value, result in zip(values, out, strict=True):
        top = value.take(piece.top)
        np.subtract(value.take(piece.bottom), top, out=result)
        result *= share
        result += top


def chain(cross: Crossings) -> tuple[Ints, Ints, Ints]:
    """All nodes as chains of crossings: the crossings of one chain after another, the rows where chains
    begin, their planes.

    A chain of m nodes has m + 1 crossings; that of a closed one is the same at both ends. Chains go by plane,
    then by where they start along the travel; a closed chain starts at the first place along the travel where
    it turns upward.
    """
    turning = cross.turning.take(np.argsort(cross.turning.along, kind="stable"))
    starts = Starts.join([cross.opening, turning])
    order = _depth_first(cross.next_node, starts.node)
    n = len(cross.next_node) - 1
    if len(order) < n + len(starts.node):  # closed chains that never turn, as on an upright wall
        starts = Starts.join([starts, _anywhere(cross, order)])
        order = _depth_first(cross.next_node, starts.node)
    root = np.flatnonzero(order >= n)
    nodes = np.diff(root, append=len(order)) - 1
    used = np.flatnonzero(nodes)
    plane = _planes(cross, order.take(root.take(used) + 1))
    by_place = np.lexsort((starts.along.take(used), plane))
    used = used.take(by_place)
    root, nodes = root.take(used), nodes.take(used)
    first = np.cumsum(nodes + 1) - (nodes + 1)
    row = np.arange(len(used) + int(nodes.sum())) + np.repeat(root - first, nodes + 1)
    crossing = cross.exit.take(order.take(row), mode="clip")
    crossing[first] = starts.crossing.take(used)
    return crossing, first, plane.take(by_place)


def _planes(cross: Crossings, node: Ints) -> Ints:
    """Return the planes of nodes."""
    return node - cross.base.take(cross.left.take(cross.exit.take(node)))


def _anywhere(cross: Crossings, order: Ints) -> Starts:
    """Return the nodes that ``order`` lacks as starts, in order along the travel. All of them belong to
    closed chains."""
    missed = np.ones(len(cross.next_node), dtype=np.bool_)
    missed[np.minimum(order, len(missed) - 1)] = missed[-1] = False
    crossing = cross.exit[missed]
    starts = Starts(crossing, cross.next_node[missed], cross.along.take(crossing))
    return starts.take(np.argsort(starts.along, kind="stable"))


def _depth_first(next_node: Ints, head: Ints) -> Ints:
    """Nodes in order of their chains; before each chain stands a row of n or more.

    The graph gives each head a root that leads to the head and then to the next root. A chain that ends leads
    to the first root, which has been visited already; so has a node that an earlier head reached.
    """
    n, roots = len(next_node) - 1, len(head)
    if not roots:
        return head
    child = np.empty(n + 2 * roots, dtype=np.int32)
    child[:n] = next_node[:n]
    child[n::2] = head
    child[n + 1 :: 2] = n + np.minimum(np.arange(1, roots + 1), roots - 1)
    begin = np.concatenate([np.arange(n, dtype=np.int32), np.arange(n, n + 2 * roots + 1, 2, dtype=np.int32)])
    graph = scipy.sparse.csr_matrix((np.ones(len(child)), child, begin), shape=(n + roots, n + roots))
    order: Ints = scipy.sparse.csgraph.depth_first_order(graph, n, return_predecessors=False).astype(np.int64)
    return order
