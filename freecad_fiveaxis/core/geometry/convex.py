# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convex pieces, and how far two of them are apart in many poses at once.

piece      all points within ``round`` of the convex hull of some corners.
gap        of two pieces along a unit direction g: the least ``g . x`` of the one less the largest ``g . y``
           of the other. They are never nearer to each other than their gap along any direction whatever, so a
           gap above 0 is a proof.
difference all ``x - y``: its point next to 0 is the shortest way between the pieces.

The search is that of Gilbert, Johnson and Keerthi: a simplex of at most four points of the difference goes
towards 0, and the way from 0 to the simplex is the next direction. All poses go at once; those that are
decided leave.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

MOST_STEPS = 64
"""Of the search; ten are usual. What is not decided then is not proven, and is divided or told as met."""

AT_ONCE = 2_000_000
"""Products of directions and corners at a time."""

EVEN = 1e-7
"""The share of a distance to which it is found; a simplex is flat where its area or volume is such a share of
the most."""

LEVELS = 32
"""By so many depths a piece is kept pared."""

NOTHING = 1e-9
"""mm; pieces that are nearer than this touch."""

EDGES = np.array(list(combinations(range(4), 2)))
SIDES = np.array(list(combinations(range(4), 3)))


@dataclass(frozen=True, eq=False)
class Convex:
    """``corner`` (v, 3) mm; ``plane`` (f, 4): outward unit normals and offsets of the hull's planes, ``n . x
    + d <= 0`` inside, none where the corners lie in a plane; ``round`` mm."""

    corner: Floats
    plane: Floats
    round: float = 0.0

    @cached_property
    def middle(self) -> Floats:
        """The middle (3,) mm of the box about it."""
        return np.asarray(0.5 * (self.corner.min(axis=0) + self.corner.max(axis=0)))

    @cached_property
    def reach(self) -> float:
        """How far its farthest point is from the middle, mm."""
        return float(np.linalg.norm(self.corner - self.middle, axis=1).max()) + self.round

    @cached_property
    def inmost(self) -> tuple[Floats, float]:
        """The point (3,) mm that is deepest in the hull, and how deep, mm."""
        from scipy.optimize import (
            linprog,
        )  # here, for few programs have bodies to look at, and scipy's solvers start slowly

        if not len(self.plane):
            return self.middle, 0.0
        table = np.column_stack([self.plane[:, :3], np.ones(len(self.plane))])
        found = linprog((0, 0, 0, -1), table, -self.plane[:, 3], bounds=[(None, None)] * 3 + [(0, None)])
        return (np.asarray(found.x[:3]), float(found.x[3])) if found.status == 0 else (self.middle, 0.0)

    def facing(self, point: Floats) -> Floats:
        """Give the normals (n, 3) of the planes that points (n, 3) mm are farthest outside of; without
        planes, the way from the middle."""
        if len(self.plane):
            return np.asarray(self.plane[(point @ self.plane[:, :3].T + self.plane[:, 3]).argmax(axis=1), :3])
        way = point - self.middle
        return np.asarray(way / np.maximum(np.linalg.norm(way, axis=1), NOTHING)[:, None])

    def pare(self, by: float) -> Convex:
        """Give what lies deeper than ``by`` mm in the hull, which must be less than ``inmost``."""
        if by <= 0.0 or not len(self.plane):
            return self
        if (known := self._pared.get(by)) is None:
            if len(self._pared) >= LEVELS:
                self._pared.clear()
            known = self._pared[by] = self._pare(by)
        return known

    @cached_property
    def _pared(self) -> dict[float, Convex]:
        """What was pared off it: of many pairs each begins with the same."""
        return {}

    def _pare(self, by: float) -> Convex:
        from scipy.spatial import HalfspaceIntersection

        plane = self.plane + (0.0, 0.0, 0.0, by)
        return Convex(
            np.unique(HalfspaceIntersection(plane, self.inmost[0]).intersections, axis=0), plane, self.round
        )


def convex_hull(points: Floats, round_: float = 0.0) -> Convex:
    """Take the hull of points (n, 3) mm, at least one, with a ``round_`` mm about it."""
    from scipy.spatial import ConvexHull, QhullError

    flat = np.empty((0, 4))
    if len(points) < 4:
        return Convex(np.array(points, float), flat, round_)
    try:
        hull = ConvexHull(points)
    except QhullError:  # all in a plane: no inside
        return Convex(np.unique(points, axis=0), flat, round_)
    return Convex(np.ascontiguousarray(points[hull.vertices]), np.unique(hull.equations, axis=0), round_)


class Poses(NamedTuple):
    """``turn`` (n, 3, 3) and ``shift`` (n, 3) mm: where a piece stands, seen from another."""

    turn: Floats
    shift: Floats

    def take(self, rows: Ints | Bools) -> Poses:
        """Pick some of them."""
        return Poses(self.turn[rows], self.shift[rows])

    def place(self, point: Floats) -> Floats:
        """Return where (n, 3) mm a point (3,) of the moved piece is, seen from the standing one."""
        return np.asarray(self.turn @ point + self.shift)


class Gaps(NamedTuple):
    """Of n poses: ``way`` (n, 3), the unit direction from the standing piece to the moved one along which
    ``least`` (n,) mm was found, the largest gap so far, rounds taken off; ``met`` (n,): whether they are no
    farther apart than was asked for; ``place`` (n, 3) mm: a point of the moved piece next to the standing
    one, seen from that."""

    way: Floats
    least: Floats
    met: Bools
    place: Floats


def find_gaps(
    moved: Convex, standing: Convex, poses: Poses, within: float, need: Floats, guess: Floats
) -> Gaps:
    """Find how far two pieces are apart, mm, less ``within``: a pose is decided when that is more than
    ``need`` (n,), or when the pieces are met, no farther apart than ``within``. ``guess`` (n, 3): unit
    directions to begin with."""
    off = moved.round + standing.round + within
    count = len(poses.shift)
    found = Gaps(guess.copy(), np.full(count, -np.inf), np.zeros(count, np.bool_), np.zeros((count, 3)))
    step = max(1, AT_ONCE // (len(moved.corner) + len(standing.corner)))
    for first in range(0, count, step):
        rows = np.arange(first, min(first + step, count))
        _search(_Simplices.of(moved, standing, poses.take(rows), rows, guess[rows]), off, need, found)
    return found


def find_met_poses(moved: Convex, standing: Convex, poses: Poses, within: float) -> Bools:
    """Tell in which poses (n,) two pieces are not proven to be more than ``within`` mm apart. Balls about
    them, balls in them and the way between their middles decide most."""
    middle = poses.place(moved.middle)
    way = middle - standing.middle
    apart = np.linalg.norm(way, axis=1)
    (deepest, depth), (other, other_depth) = moved.inmost, standing.inmost
    inner = np.linalg.norm(poses.place(deepest) - other, axis=1)
    met = inner < depth + other_depth + moved.round + standing.round + within
    rows = np.flatnonzero(~met & (apart <= moved.reach + standing.reach + within))
    g = way[rows] / np.maximum(apart[rows], NOTHING)[:, None]
    rows = rows[~(support_gap(moved, standing, poses.take(rows), g) > within)]
    gaps = find_gaps(
        moved, standing, poses.take(rows), within, np.zeros(len(rows)), standing.facing(middle[rows])
    )
    met[rows] = ~(gaps.least > 0.0)
    return np.asarray(met)


def support_gap(
    moved: Convex, standing: Convex, poses: Poses, g: Floats, tilt: Floats | None = None
) -> Floats:
    """Give the gaps (n,) mm along unit directions ``g`` (n, 3), rounds taken off; with a ``tilt`` (n, 3) the
    moved piece's least along ``g + tilt`` instead."""
    step, parts = max(1, AT_ONCE // (len(moved.corner) + len(standing.corner))), [np.zeros(0)]
    along = g if tilt is None else g + tilt
    for first in range(0, len(g), step):
        rows = slice(first, first + step)
        turn, shift = poses.turn[rows], poses.shift[rows]
        near = (_local(turn, along[rows]) @ moved.corner.T).min(axis=1) + (along[rows] * shift).sum(axis=1)
        parts.append(near - (g[rows] @ standing.corner.T).max(axis=1))
    return np.asarray(np.concatenate(parts) - (moved.round + standing.round))


def cross_rows(one: Floats, other: Floats) -> Floats:
    """Give the cross products (..., 3); numpy's own is slow for few rows."""
    a, b, c = one[..., 0], one[..., 1], one[..., 2]
    x, y, z = other[..., 0], other[..., 1], other[..., 2]
    return np.stack([b * z - c * y, c * x - a * z, a * y - b * x], axis=-1)


def _local(turn: Floats, g: Floats) -> Floats:
    """Directions (n, 3) as the moved piece has them."""
    return np.asarray(np.matmul(g[:, None, :], turn)[:, 0])


@dataclass(eq=False)
class _Simplices:
    """``rows`` (n,): which of the poses; ``point`` (n, 4, 3) of the difference, ``own`` (n, 4) the moved
    piece's corners in them, ``weight`` (n, 4) those of the point next to 0, ``near`` (n, 3)."""

    moved: Convex
    standing: Convex
    poses: Poses
    rows: Ints
    point: Floats
    own: Ints
    weight: Floats
    near: Floats

    @classmethod
    def of(cls, moved: Convex, standing: Convex, poses: Poses, rows: Ints, guess: Floats) -> _Simplices:
        """Begin with one point, that of the guess."""
        count = len(rows)
        weight = np.tile((1.0, 0.0, 0.0, 0.0), (count, 1))
        new = cls(
            moved,
            standing,
            poses,
            rows,
            np.empty((count, 4, 3)),
            np.empty((count, 4), np.int64),
            weight,
            guess,
        )
        point, own = new.farthest(guess)
        new.point[:], new.own[:], new.near = point[:, None], own[:, None], guess
        return new

    def take(self, keep: Ints) -> _Simplices:
        """Keep some of them."""
        poses, weight, near = self.poses.take(keep), self.weight[keep], self.near[keep]
        rows, point, own = self.rows[keep], self.point[keep], self.own[keep]
        return _Simplices(self.moved, self.standing, poses, rows, point, own, weight, near)

    def farthest(self, g: Floats) -> tuple[Floats, Ints]:
        """Return the points (n, 3) of the difference that are least along g (n, 3), and the moved piece's
        corners in them."""
        own = (_local(self.poses.turn, g) @ self.moved.corner.T).argmin(axis=1)
        other = (g @ self.standing.corner.T).argmax(axis=1)
        at = np.matmul(self.poses.turn, self.moved.corner[own][:, :, None])[:, :, 0] + self.poses.shift
        return at - self.standing.corner[other], own

    def place(self) -> Floats:
        """Return the moved piece's point (n, 3) next to the standing one."""
        own = (self.weight[:, :, None] * self.moved.corner[self.own]).sum(axis=1)
        return np.asarray(np.matmul(self.poses.turn, own[:, :, None])[:, :, 0] + self.poses.shift)

    def put(self, point: Floats, own: Ints) -> None:
        """Put a point in the place of one that counts for nothing, and find the simplices' points next to
        0."""
        at, every = self.weight.argmin(axis=1), np.arange(len(point))
        self.point[every, at], self.own[every, at] = point, own
        self.weight = nearest_weights(self.point)
        best = self.weight.argmax(axis=1)
        idle = self.weight <= 0.0
        self.point = np.where(idle[:, :, None], self.point[every, best][:, None], self.point)
        self.own = np.where(idle, self.own[every, best][:, None], self.own)
        self.near = (self.weight[:, :, None] * self.point).sum(axis=1)


def _search(some: _Simplices, off: float, need: Floats, found: Gaps) -> None:
    """Fill in what is found of these poses."""
    for step in range(MOST_STEPS + 1):
        length = np.linalg.norm(some.near, axis=1)
        g = some.near / np.maximum(length, NOTHING)[:, None]
        point, own = some.farthest(g)
        gap = (g * point).sum(axis=1) - off
        better = (gap > found.least[some.rows]) & (length > NOTHING)
        found.way[some.rows[better]], found.least[some.rows[better]] = g[better], gap[better]
        met = (length <= max(off, NOTHING)) & (step > 0)
        free = gap > need[some.rows]
        even = (length - off - gap <= EVEN * length) & (step > 0)
        done = met | free | even | (step == MOST_STEPS)
        ended = some.take(np.flatnonzero(done))
        found.met[ended.rows], found.place[ended.rows] = (met & ~free)[done], ended.place()
        keep = np.flatnonzero(~done)
        if not len(keep):
            return
        some = some.take(keep)
        some.put(point[keep], own[keep])


def nearest_weights(point: Floats) -> Floats:
    """Give the weights (n, 4) of the point of each simplex (n, 4, 3) that is next to 0; corners may come
    twice. All are above 0 only where 0 is inside."""
    count = len(point)
    weight = np.zeros((count, 11, 4))
    weight[:, :6] = _on_edges(point)
    weight[:, 6:10], flat = _on_sides(point)
    weight[:, 10], outside = _in_all(point)
    near = (np.matmul(weight, point) ** 2).sum(axis=2)
    near[:, 6:10][flat] = np.inf
    near[:, 10] = np.where(outside, np.inf, -1.0)
    return np.asarray(weight[np.arange(count), near.argmin(axis=1)])


def _on_edges(point: Floats) -> Floats:
    one, way = point[:, EDGES[:, 0]], point[:, EDGES[:, 1]] - point[:, EDGES[:, 0]]
    long = (way * way).sum(axis=2)
    share = np.clip(-(one * way).sum(axis=2) / np.where(long > 0.0, long, 1.0), 0.0, 1.0)
    weight = np.zeros((len(point), 6, 4))
    every = np.arange(6)
    weight[:, every, EDGES[:, 0]], weight[:, every, EDGES[:, 1]] = 1.0 - share, share
    return weight


def _on_sides(point: Floats) -> tuple[Floats, Bools]:
    """Return the weights (n, 4, 4) of the feet on the planes of the sides, and which have none within (n,
    4)."""
    one = point[:, SIDES[:, 0]]
    u, v = point[:, SIDES[:, 1]] - one, point[:, SIDES[:, 2]] - one
    uu, uv, vv = (u * u).sum(axis=2), (u * v).sum(axis=2), (v * v).sum(axis=2)
    ou, ov = -(one * u).sum(axis=2), -(one * v).sum(axis=2)
    area = uu * vv - uv * uv
    flat = area <= EVEN * EVEN * uu * vv
    area = np.where(flat, 1.0, area)
    a, b = (ou * vv - ov * uv) / area, (ov * uu - ou * uv) / area
    weight, every = np.zeros((len(point), 4, 4)), np.arange(4)
    for k, share in enumerate((1.0 - a - b, a, b)):
        weight[:, every, SIDES[:, k]] = share
    return weight, flat | (weight < 0.0).any(axis=2)


def _in_all(point: Floats) -> tuple[Floats, Bools]:
    """Return the weights (n, 4) of 0 in the simplices, and which do not hold it (n,)."""
    one = point[:, 0]
    u, v, w = (point[:, k] - one for k in (1, 2, 3))
    vw, wu, uv = cross_rows(v, w), cross_rows(w, u), cross_rows(u, v)
    volume = (u * vw).sum(axis=1)
    size = np.linalg.norm(u, axis=1) * np.linalg.norm(v, axis=1) * np.linalg.norm(w, axis=1)
    flat = np.abs(volume) <= EVEN * size
    volume = np.where(flat, 1.0, volume)
    a, b, c = (-(one * across).sum(axis=1) / volume for across in (vw, wu, uv))
    weight = np.stack([1.0 - a - b - c, a, b, c], axis=1)
    return weight, flat | (weight < 0.0).any(axis=1)
