# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed polygons in a plane: which points lie inside, where straight pieces cross them, which triangles they
touch.

edge     a straight piece of a polygon, from ``start`` to ``end``.
slab     a strip of the plane, level along u: edges are looked for only in the slabs that a point or a piece
         lies in.
inside   by the even-odd rule: a ray from the point crosses an odd number of edges, so islands need no sense
         of their own. A point nearer to an edge than ``near`` lies on it, and counts as inside.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, run_ids

NEAR = 1e-10
"""Of the size of the polygons: nearer points are one."""

MOST_SLABS = 4096

PAIRS = 1_000_000
"""Pairs of a point and an edge that are looked at together: some ten MB a column."""

PARALLEL = 1e-13
"""Sine of the angle between two directions: below it they cross nowhere in particular."""


@dataclass(frozen=True, eq=False)
class PlaneCurves:
    """``start`` and ``end`` (e, 2) mm of the edges; ``near`` mm; ``low`` and ``step`` mm: where the slabs
    begin and how high they are; ``first`` (s + 1,) and ``edge``: the edges of each slab, one after
    another."""

    start: Floats
    end: Floats
    near: float
    low: float
    step: float
    first: Ints
    edge: Ints

    @classmethod
    def of(cls, polygons: list[Floats]) -> PlaneCurves:
        """Sort the edges of closed ``polygons``, (n, 2) mm each with the first point again at the end, into
        slabs."""
        start, end = (
            np.concatenate([one[part] for one in polygons]) for part in (slice(None, -1), slice(1, None))
        )
        some = (start != end).any(axis=1)
        start, end = start[some], end[some]
        corner = np.concatenate([start, end])
        size = float(np.ptp(corner, axis=0).max())
        near = NEAR * size + 4.0 * np.finfo(float).eps * float(np.abs(corner).max())
        low, height = float(corner[:, 1].min()) - near, float(np.ptp(corner[:, 1])) + 2.0 * near
        rise = float(np.abs(end[:, 1] - start[:, 1]).sum())
        slabs = int(np.clip(4.0 * height * len(start) / max(rise, height), 1, MOST_SLABS))
        step = height / slabs
        ends = np.stack([start[:, 1], end[:, 1]])
        lowest, highest = (
            _slab(value, low, step, slabs) for value in (ends.min(axis=0) - near, ends.max(axis=0) + near)
        )
        count = highest - lowest + 1
        edge = run_ids(count)
        slab = np.arange(len(edge)) + (lowest - np.cumsum(count) + count)[edge]
        order = np.argsort(slab, kind="stable")
        return cls(
            start, end, near, low, step, np.searchsorted(slab[order], np.arange(slabs + 1)), edge[order]
        )

    def inside(self, point: Floats) -> Bools:
        """Find which points (n, 2) mm lie inside."""
        parity, on = np.zeros(len(point), np.int64), np.zeros(len(point), np.bool_)
        for at, edge in self._pairs(point[:, 1], point[:, 1]):
            p, a, way = point[at], self.start[edge], self.end[edge] - self.start[edge]
            off = p - a
            spans = (a[:, 1] > p[:, 1]) != (self.end[edge, 1] > p[:, 1])
            left = (
                np.where(way[:, 1] > 0.0, 1.0, -1.0) * (way[:, 0] * off[:, 1] - way[:, 1] * off[:, 0]) > 0.0
            )
            parity += np.bincount(at[spans & left], minlength=len(point))
            share = np.clip((off * way).sum(axis=1) / (way * way).sum(axis=1), 0.0, 1.0)
            on[at[np.hypot(*(off - share[:, None] * way).T) <= self.near]] = True
        return np.asarray((parity % 2 == 1) | on)

    def crossings(self, start: Floats, end: Floats) -> tuple[Ints, Floats]:
        """Find where pieces from ``start`` to ``end`` (n, 2) mm cross the edges: the piece (k,) and the share
        (k,) of its way, in order, each once. Shares of 0 and 1 are left out: there something begins or ends
        anyway."""
        found_at, found_share = [np.empty(0, np.int64)], [np.empty(0)]
        length = np.hypot(*(end - start).T)
        for at, edge in self._pairs(start[:, 1], end[:, 1]):
            at, edge = _overlapping(start, end, self.start, self.end, at, edge, self.near)
            share, other = _shares(start[at], end[at], self.start[edge], self.end[edge])
            long = np.hypot(*(self.end[edge] - self.start[edge]).T)
            some = (share * length[at] > self.near) & ((1.0 - share) * length[at] > self.near)
            some &= (other * long >= -self.near) & ((1.0 - other) * long >= -self.near)
            found_at.append(at[some])
            found_share.append(share[some])
        piece, share = np.concatenate(found_at), np.concatenate(found_share)
        order = np.lexsort((share, piece))
        piece, share = piece[order], share[order]
        new = (np.diff(piece, prepend=-1) != 0) | (np.diff(share, prepend=-1.0) * length[piece] > self.near)
        return piece[new], share[new]

    def self_crossing(self) -> Floats | None:
        """Find a place (2,) mm where two edges cross that do not only touch; None where there is none."""
        for at, edge in self._pairs(self.start[:, 1], self.end[:, 1]):
            later = at < edge
            at, edge = _overlapping(self.start, self.end, self.start, self.end, at[later], edge[later], 0.0)
            share, other = _shares(self.start[at], self.end[at], self.start[edge], self.end[edge])
            crosses = np.ones(len(at), np.bool_)
            for part, of in ((share, at), (other, edge)):
                long = np.hypot(*(self.end[of] - self.start[of]).T)
                crosses &= (part * long > self.near) & ((1.0 - part) * long > self.near)
            if crosses.any():
                one = int(crosses.argmax())
                return np.asarray(
                    self.start[at[one]] + share[one] * (self.end[at[one]] - self.start[at[one]])
                )
        return None

    def find_touched(self, corner: Floats, within: float = 0.0) -> Bools:
        """Find which triangles (f, 3, 2) mm lie inside with some of their area, or nearer than ``within`` mm
        to what does; of those that lie aslant to an edge a few more. One that only touches an edge lies where
        its middle does."""
        found = self.inside(corner.mean(axis=1))
        low, high = corner.min(axis=1), corner.max(axis=1)
        for at, edge in self._pairs(low[:, 1] - within, high[:, 1] + within):
            at, edge = _overlapping(low - within, high + within, self.start, self.end, at, edge, 0.0)
            found[at[_gap(corner[at], self.start[edge], self.end[edge]) < within - self.near]] = True
        return found

    def _pairs(self, one: Floats, other: Floats) -> Iterator[tuple[Ints, Ints]]:
        """Pairs of a thing (k,) that reaches from v = ``one`` to ``other`` (n,) mm and an edge (k,) of the
        slabs that it lies in, some at a time; an edge may come more than once where the thing lies in several
        slabs."""
        slabs = len(self.first) - 1
        low, high = np.minimum(one, other), np.maximum(one, other)
        begin = self.first[_slab(low, self.low, self.step, slabs)]
        end = self.first[_slab(high, self.low, self.step, slabs) + 1]
        count = np.where((high < self.low) | (low > self.low + slabs * self.step), 0, end - begin)
        thing = np.flatnonzero(count)
        before = np.cumsum(count[thing]) - count[thing]
        cuts = np.append(np.flatnonzero(np.diff(before // PAIRS, prepend=-1)), len(thing))
        for first, last in zip(cuts[:-1].tolist(), cuts[1:].tolist(), strict=True):
            some = thing[first:last]
            run = run_ids(count[some])
            place = np.arange(len(run)) + (begin[some] - before[first:last] + before[first])[run]
            yield some[run], self.edge[place]


def _slab(value: Floats, low: float, step: float, slabs: int) -> Ints:
    """Return the slab of each height (n,) mm; those beyond all slabs have the one at that end."""
    return np.asarray(np.clip((value - low) / step, 0, slabs - 1).astype(np.int64))


def _overlapping(
    start: Floats, end: Floats, from_: Floats, to: Floats, at: Ints, edge: Ints, by: float
) -> tuple[Ints, Ints]:
    """Those of the pairs (k,) whose boxes overlap, or are no farther apart than ``by`` mm."""
    some = np.ones(len(at), np.bool_)
    for column in (0, 1):
        a, b, c, d = (
            ends[rows, column] for ends, rows in ((start, at), (end, at), (from_, edge), (to, edge))
        )
        some &= (np.maximum(a, b) >= np.minimum(c, d) - by) & (np.minimum(a, b) <= np.maximum(c, d) + by)
    return at[some], edge[some]


def _shares(start: Floats, end: Floats, from_: Floats, to: Floats) -> tuple[Floats, Floats]:
    """Where the lines through two pieces (k, 2) meet, as shares (k,) of either; NaN where they are
    parallel."""
    way, along, off = end - start, to - from_, from_ - start
    sine = way[:, 0] * along[:, 1] - way[:, 1] * along[:, 0]
    least = PARALLEL * np.hypot(*way.T) * np.hypot(*along.T)
    sine = np.where(np.abs(sine) > least, sine, np.nan)
    share = (off[:, 0] * along[:, 1] - off[:, 1] * along[:, 0]) / sine
    return np.asarray(share), np.asarray((off[:, 0] * way[:, 1] - off[:, 1] * way[:, 0]) / sine)


def _gap(corner: Floats, start: Floats, end: Floats) -> Floats:
    """How far (k,) mm triangles (k, 3, 2) and edges lie apart at least: the widest gap along the normals of
    their sides, below 0 where they overlap."""
    ways = (end - start, *(corner[:, (side + 1) % 3] - corner[:, side] for side in range(3)))
    gap = np.full(len(corner), -np.inf)
    for way in ways:
        length = np.hypot(*way.T)
        across = np.stack([-way[:, 1], way[:, 0]], axis=1) / np.where(length > 0.0, length, 1.0)[:, None]
        mine = np.einsum("kij,kj->ki", corner, across)
        its = np.stack([(start * across).sum(axis=1), (end * across).sum(axis=1)], axis=1)
        apart = np.maximum(mine.min(axis=1) - its.max(axis=1), its.min(axis=1) - mine.max(axis=1))
        gap = np.where(length > 0.0, np.maximum(gap, apart), gap)
    return gap
