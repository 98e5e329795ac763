# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of pieces: how far the real path of rounded words leaves the commanded segment of the block that
was divided.

piece     a block of the divided program, between two rows of rounded words.
off       the distance of a row's real tip, as rounded, from the commanded segment.

A piece's path is within its own ``bound`` of the piece's chord; the chord's ends are within ``off`` of the
commanded segment, and so is the chord, because the distance from a segment is a convex function. So the path
is within ``bound`` + the larger off of the commanded segment, and within ``bound`` of the piece's own.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.motion.deviation.bound import Levers, allowance, bending, close_levers, end_levers
from freecad_fiveaxis.core.motion.deviation.quartic import (
    NODES,
    POINT,
    REMAINDER,
    SMALLEST,
    Chord,
    bow,
    chord,
    node_poses,
    subtract_chord_motion,
)
from freecad_fiveaxis.core.motion.deviation.search import Chords, farthest
from freecad_fiveaxis.core.motion.trajectory import (
    Frames,
    at,
    chain_motion,
    flat_length,
    inner,
    motion,
    outer,
    tip,
)

LARGEST = 1e6
"""mm or deg: words beyond this, and words that are no numbers, lead nowhere."""


@dataclass(frozen=True, eq=False)
class Judged:
    """Pieces (p,), mm. ``least``: a distance that the path takes from its chord; ``most``: the proven bound
    of it, infinite while it is not known; ``off``: the larger off of both ends."""

    least: Floats
    most: Floats
    off: Floats


def judge_pieces(
    frame: Frames, words: Floats, inside: Bools, off: Floats, limit: Floats, group: Ints | None = None
) -> Judged:
    """Judge the pieces between successive rows of ``words`` (p + 1, 5), mm and **degrees**, where ``inside``
    (p,).

    ``off`` (p + 1,) mm of the rows. What a piece does exactly is only searched where it decides whether
    ``most + off`` is within its ``limit`` (p,), and not in a ``group`` (p,) that holds a piece beyond its
    limit anyway.
    """
    usable = np.all(np.abs(words) <= LARGEST, axis=1)  # False for NaN
    words = words if usable.all() else np.where(usable[:, None], words, 0.0)
    move, poses = chain_motion(frame, words)
    y = inner(frame, poses)
    tips, reach = np.array(outer(poses, y)), flat_length(y[0], y[1])
    way, nodes, levers = (
        chord(tips[:, :-1], tips[:, 1:]),
        node_poses(move, poses),
        end_levers(move, reach[:-1], reach[1:]),
    )
    least, most = _by_quartic(way, np.array(tip(frame, nodes)), levers)
    most += allowance(move)
    worse = np.maximum(off[1:], off[:-1])
    beyond = inside & ~(least + worse <= limit)
    open_ = inside & ~beyond & (most + worse > limit)
    if group is not None:
        open_ &= np.bincount(group, beyond)[group] == 0.0
    rows = np.flatnonzero(open_)
    if len(rows):
        least[rows], most[rows] = search_deviation(frame, words[rows], words[rows + 1])
    lost = ~(usable[1:] & usable[:-1])
    least[lost] = most[lost] = np.inf
    return Judged(least, most, worse)


def _by_quartic(way: Chord, nodes: Floats, levers: Levers) -> tuple[Floats, Floats]:
    """Return a distance that each path takes from its chord, and a bound of all, infinite where there is no
    proof; ``nodes`` (3, 3, n).

    The bound of the distance from the infinite line is that of ``deviation.quartic``. Where the foot of the
    perpendicular may leave the chord, it overshoots it by at most ``(1 - u) (u G - L)``, G the longest
    g_along and L the chord (symbols there), that is by ``(G - L)^2 / 4G``; both are the sides of a right
    angle. In any case the point of the same u is at most ``|g| / 4`` away.
    """
    line = bow(replace(way, length=np.full_like(way.length, np.inf)), nodes, levers)
    full = _bows(way, nodes)
    reach = _longest([_dots(part, way.along) for part in full])
    over = np.where(reach > way.length, (reach - way.length) ** 2 / np.maximum(4.0 * reach, SMALLEST), 0.0)
    remainder = REMAINDER * bending(levers, 5)
    least, most = line.distance, np.where(line.proven, line.bound, np.inf)
    rows = np.flatnonzero((over > 0.0) | ~line.proven)
    least[rows] = np.maximum(
        _sample_distance(nodes[:, :, rows], way.start[:, rows], way.vector[:, rows]),
        least[rows] * line.proven[rows],
    )
    aside = np.sqrt(most[rows] ** 2 + over[rows] ** 2)
    same_u = 0.25 * _longest([np.sqrt(_dots(part, part)) for part in (bow_[:, rows] for bow_ in full)])
    most[rows] = np.minimum(aside, same_u) + remainder[rows]
    return least, most


def _bows(way: Chord, nodes: Floats) -> list[Floats]:
    """Return a, B, C (3, n) of g = A + B s + C s^2 through the nodes; ``u (1 - u) g`` is the way from the
    chord at the same u."""
    low, mid, high = (nodes[:, j] - way.start - u * way.vector for j, u in enumerate(NODES[:, 0]))
    return [4.0 * mid, (32.0 / 3.0) * (high - low), (128.0 / 3.0) * (low + high) - 64.0 * mid]


def _longest(sizes: list[Floats]) -> Floats:
    """Return the longest that g, or a part of it, can be, from the sizes of A, B and C: ``|s| <= 1/2``."""
    a, b, c = (np.abs(size) for size in sizes)
    return np.asarray(a + 0.5 * b + 0.25 * c)


def _sample_distance(points: Floats, start: Floats, vector: Floats) -> Floats:
    """Return the largest distance (n,) of points (3, k, n) from segments."""
    way = points - start[:, None]
    share = np.clip(_dots(way, vector) / np.maximum(_dots(vector, vector), SMALLEST), 0.0, 1.0)
    rest = way - share * vector[:, None]
    return np.asarray(np.sqrt(_dots(rest, rest)).max(axis=0))


def _dots(p: Floats, q: Floats) -> Floats:
    return np.asarray(p[0] * q[0] + p[1] * q[1] + p[2] * q[2])


def search_deviation(frame: Frames, start: Floats, end: Floats) -> tuple[Floats, Floats]:
    """Return the segment deviation (n,) mm of blocks from words ``start`` to ``end`` (n, 5), and its proven
    bound, by search."""
    move = motion(frame, start, end)
    ends = [np.array(tip(frame, at(move, np.full_like(move.a, u)))) for u in (0.0, 1.0)]
    way, levers = chord(ends[0], ends[1]), close_levers(frame, move)
    origin, along = (way.start[0], way.start[1], way.start[2]), (way.along[0], way.along[1], way.along[2])
    low, second, third = np.zeros_like(way.length), bending(levers, 2), bending(levers, 3)
    seen = subtract_chord_motion(move, way, way.length <= POINT)
    found, _, bound = farthest(
        frame, Chords(seen, origin, along, low, way.length, second, third, levers.turn)
    )
    return found, bound + allowance(move)


def off_segment(frame: Frames, words: Floats, start: Floats, vector: Floats) -> Floats:
    """Return the distance (n,) mm of the real tip at ``words`` (n, 5), mm and **degrees**, from the segments
    at ``start`` (n, 3) along ``vector`` (n, 3), work frame, mm."""
    move = motion(frame, words, words)
    points = np.array(tip(frame, at(move, np.zeros_like(move.a))))
    points[np.isnan(points)] = 0.0  # words that are no numbers are out of the question anyway
    return _sample_distance(points[:, None], frame.first @ start.T, frame.first @ vector.T)


def off_points(frame: Frames, words: Floats, tip_: Floats) -> Floats:
    """Return the distance (n,) mm of the real tip at ``words`` (n, 5), mm and **degrees**, from points (n, 3)
    of the work frame."""
    return off_segment(frame, words, tip_, np.zeros_like(tip_))
