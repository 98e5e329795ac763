# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest distance of a block's real path from its chord, found and proven by branch and bound over u.

It serves any block, whatever it turns: every interval of u is either shown not to exceed the best distance
found so far by more than the tolerance, or cut in two. What is left in the end is the global maximum, however
many maxima there are.

piece     an interval of u of one block, of half width ``half`` about its ``centre``.
inside    the foot of the perpendicular lies within the chord; outside, the nearest point of the chord is an
          end.

Let x be the vector from the nearest point of the chord to the tip, F = |x|^2, and at the centre F0, F0' = 2
x.p' and c = |x'|^2 + x.p''. F' is Lipschitz, and while the foot stays inside (or outside) ``F'' / 2 = |x'|^2
+ x.p''``, with x' the part of p' across the chord inside and p' itself outside; counting p' in full, the
right side is never less than F''/2. It changes by at most 3 T per unit of u, ``T = V M2 + X M3 / 3``, where V
and X bound |x'| and |x| on the piece, and M2 and M3 the second and third derivative of the path. Integrated
twice:

    ``F(u) <= F0 + F0' t + c t^2 + T |t|^3``  for ``t = u - centre``.

The same holds for the distance from the whole line, with p' across it, and ``F <= F_line + o^2`` where the
foot lies outside by no more than o: the bound of a piece that the foot leaves. The smaller of both counts.

Near a maximum c is negative and F0' small, so that the bound is of third order and the search ends after a
few rounds.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints, number_runs
from freecad_fiveaxis.core.base.vectors import dot
from freecad_fiveaxis.core.motion.trajectory import Frames, Motion, Vectors, derivatives

from .bound import ABSOLUTE, RELATIVE

FIRST_PIECES = 8
FIRST_TURN = 0.25
"""A block starts as at least so many pieces, of at most so many rad of summed rotary travel: fewer rounds,
few wasted pieces."""

POLISH, POLISH_REACH = 2, 0.01
"""Steps of Newton's method at the end, and how far in u they may lead: further away it would be another
peak."""

MOST_PIECES = 65536
"""Pieces worked on at a time: what bounds the memory where blocks turn by hundreds of turns."""


@dataclass(frozen=True, eq=False)
class Chords:
    """Blocks to search, one row each, in the first frame, mm.

    ``origin``: the start of the chord; ``along``: its unit vector, zero where the chord is a point; the chord
    holds the points from ``low`` to ``high`` along it (infinite for the whole line); ``second``, ``third``:
    bounds of the path's derivatives; ``turn`` rad: summed rotary travel.
    """

    move: Motion
    origin: Vectors
    along: Vectors
    low: Floats
    high: Floats
    second: Floats
    third: Floats
    turn: Floats

    def take(self, rows: Ints) -> Chords:
        """Return the chords of some blocks; an index may come more than once."""
        columns = (column[rows] for column in (self.low, self.high, self.second, self.third, self.turn))
        return Chords(
            self.move.take(rows), _take_rows(self.origin, rows), _take_rows(self.along, rows), *columns
        )


@dataclass(frozen=True, eq=False)
class _Pieces:
    block: Ints
    centre: Floats
    half: Floats

    def split(self) -> list[_Pieces]:
        middle = len(self.block) // 2
        return [
            _Pieces(self.block[s], self.centre[s], self.half[s]) for s in (slice(middle), slice(middle, None))
        ]


@dataclass(frozen=True, eq=False)
class _Local:
    """At the centres of pieces: F, F' and c, mm^2; and the upper bound of F on the whole piece."""

    square: Floats
    slope: Floats
    curve: Floats
    bound: Floats


def farthest(frame: Frames, chords: Chords) -> tuple[Floats, Floats, Floats]:
    """Return the largest distance (n,) mm of each block's path from its chord, its u, and an upper bound of
    that distance.

    The distance is one that the path takes at that u; the bound holds for every u, up to the rounding of the
    arithmetic.
    """
    best, best_u = np.zeros(len(chords.turn)), np.full(len(chords.turn), 0.5)
    load = np.cumsum(_first_count(chords.turn)) // MOST_PIECES
    for rows in np.split(np.arange(len(load)), np.flatnonzero(np.diff(load)) + 1):
        best[rows], best_u[rows] = _branch_and_bound(frame, chords.take(rows))
    return best, best_u, _compute_limit(best)


def _branch_and_bound(frame: Frames, chords: Chords) -> tuple[Floats, Floats]:
    best, best_u = np.zeros(len(chords.turn)), np.full(len(chords.turn), 0.5)
    waiting = [_first_pieces(chords.turn)]
    while waiting:
        pieces = waiting.pop()
        if len(pieces.block) > MOST_PIECES:
            waiting += pieces.split()
            continue
        here = _local(frame, chords, pieces)
        _improve(best, best_u, pieces.block, pieces.centre, here.square)
        _try_peaks(frame, chords, pieces, here, best, best_u)
        keep = np.flatnonzero(here.bound > _compute_limit(best)[pieces.block] ** 2)
        waiting += [_halve_pieces(pieces, keep)] if len(keep) else []
    _polish(frame, chords, best, best_u)
    return best, best_u


def _compute_limit(best: Floats) -> Floats:
    """Return the distance that no piece may exceed: what the search proves, and where it ends."""
    return best * (1.0 + RELATIVE) + ABSOLUTE


def _first_count(turn: Floats) -> Ints:
    return np.maximum(FIRST_PIECES, np.ceil(turn / FIRST_TURN)).astype(np.int64)


def _first_pieces(turn: Floats) -> _Pieces:
    count = _first_count(turn)
    block, index = number_runs(count)
    half = 0.5 / count[block]
    return _Pieces(block, (2 * index + 1) * half, half)


def _halve_pieces(pieces: _Pieces, keep: Ints) -> _Pieces:
    block, centre, half = (
        np.repeat(pieces.block[keep], 2),
        np.repeat(pieces.centre[keep], 2),
        np.repeat(pieces.half[keep], 2),
    )
    half *= 0.5
    centre[0::2] -= half[0::2]
    centre[1::2] += half[1::2]
    return _Pieces(block, centre, half)


def _improve(best: Floats, best_u: Floats, block: Ints, u: Floats, square: Floats) -> None:
    """Keep the largest distance of each block. ``block`` is sorted."""
    if not len(block):
        return
    first = np.flatnonzero(np.diff(block, prepend=-1))
    largest = np.sqrt(np.maximum.reduceat(square, first))
    better = largest > best[block[first]]
    best[block[first[better]]] = largest[better]
    at_best = np.flatnonzero(np.sqrt(square) == best[block])
    best_u[block[at_best]] = u[at_best]


def _try_peaks(
    frame: Frames, chords: Chords, pieces: _Pieces, here: _Local, best: Floats, best_u: Floats
) -> None:
    """Evaluate the vertex of each piece's parabola where it lies within the piece and promises more than the
    best."""
    bent = -2.0 * here.curve
    within = (bent > 0.0) & (np.abs(here.slope) < bent * pieces.half)
    promise = here.square + np.where(within, here.slope**2, 0.0) / (2.0 * np.where(within, bent, 1.0))
    chosen = np.flatnonzero(within & (promise > best[pieces.block] ** 2))
    block = pieces.block[chosen]
    u = pieces.centre[chosen] + here.slope[chosen] / bent[chosen]
    path, _, _ = derivatives(frame, chords.move.take(block), u)
    _, y, over = _split(path, chords, block)
    _improve(best, best_u, block, u, dot(y, y) + over * over)


def _polish(frame: Frames, chords: Chords, best: Floats, best_u: Floats) -> None:
    """Move each block's best u up to the peak that it lies at the foot of: the search ends a little short of
    it."""
    for _ in range(POLISH):
        room = np.minimum(np.minimum(best_u, 1.0 - best_u), POLISH_REACH)
        pieces = _Pieces(np.arange(len(best)), best_u.copy(), room)
        _try_peaks(frame, chords, pieces, _local(frame, chords, pieces), best, best_u)


def _split(path: Vectors, chords: Chords, block: Ints) -> tuple[Floats, Vectors, Floats]:
    """Position along the chord, the part across it, and how far the first lies outside the chord (signed)."""
    e = _take_rows(chords.along, block)
    x0, x1, x2 = (p - o for p, o in zip(path, _take_rows(chords.origin, block), strict=True))
    along = dot((x0, x1, x2), e)
    across = (x0 - along * e[0], x1 - along * e[1], x2 - along * e[2])
    return along, across, along - np.clip(along, chords.low[block], chords.high[block])


def _take_rows(vector: Vectors, block: Ints) -> Vectors:
    x, y, z = (column[block] for column in vector)
    return x, y, z


def _local(frame: Frames, chords: Chords, pieces: _Pieces) -> _Local:
    block, half = pieces.block, pieces.half
    path, first, bend = derivatives(frame, chords.move.take(block), pieces.centre)
    e, second, third = _take_rows(chords.along, block), chords.second[block], chords.third[block]
    along, y, over = _split(path, chords, block)
    pace = dot(first, e)
    across = (first[0] - pace * e[0], first[1] - pace * e[1], first[2] - pace * e[2])
    line, line_slope, line_curve = dot(y, y), 2.0 * dot(y, across), dot(across, across) + dot(y, bend)
    line_top = _top(line, line_slope, line_curve, np.sqrt(dot(across, across)), half, second, third)

    x = (y[0] + over * e[0], y[1] + over * e[1], y[2] + over * e[2])
    square, slope = line + over * over, line_slope + 2.0 * over * pace
    speed = dot(first, first)
    outer_curve = speed + dot(x, bend)
    outer_top = _top(square, slope, outer_curve, np.sqrt(speed), half, second, third)

    swing = np.abs(pace) * half + 0.5 * second * half * half
    outside = np.maximum(
        np.maximum(chords.low[block] - (along - swing), along + swing - chords.high[block]), 0.0
    )
    curve = np.where(over == 0.0, line_curve, outer_curve)
    return _Local(square, slope, curve, np.minimum(line_top + outside * outside, outer_top))


def _top(
    square: Floats, slope: Floats, curve: Floats, speed: Floats, half: Floats, second: Floats, third: Floats
) -> Floats:
    """Upper bound of F over a piece: the largest value of the parabola, and the third-order rest."""
    speed_most = speed + half * second
    reach_most = np.sqrt(square) + half * speed_most
    rest = (speed_most * second + reach_most * third / 3.0) * half**3
    steep = np.abs(slope)
    within = (curve < 0.0) & (steep < -2.0 * curve * half)
    vertex = 0.25 * slope * slope / np.where(within, -curve, 1.0)
    return np.asarray(square + np.where(within, vertex, (steep + curve * half) * half) + rest)
