# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep nodes and facets can be in a piece on its way: upper bounds that hold for every u, and the facet's deepest point.

Any unit direction g gives a bound: what a piece reaches along g, less what the node begins at along g. It holds wherever g comes
from; a well chosen g only makes it close. Two choices are tried: away from the piece towards the node's point, which is close
where the node is small, and the node's normal both ways, which is close where the tool touches a surface.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.records import Floats, Ints

from .body import NOWHERE, Piece, off_piece
from .course import Columns, Poses, Way
from .facet_tree import Plates

STEPS = 6
"""Times that a facet's deepest point is improved; what is missing then is part of the bound."""

CROSSINGS = 4
"""Times that the best mean of two bounds is improved."""


def _dot(p: Columns | Floats, q: Columns | Floats) -> Floats:
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def _discs(piece: Piece) -> list[tuple[float, float]]:
    low, high = (piece.low, piece.low_radius), (piece.high, piece.high_radius)
    return [low] if low == high else [low, high]


def supports(piece: Piece, way: Way, g: Columns, both: bool) -> tuple[Floats, Floats]:
    """The support of the piece over its way in the unit directions g, and in -g where ``both`` is asked for, mm."""
    m, h, a, w = (_dot(g, vector) for vector in way[:4])
    there, back = [], []
    for z, r in _discs(piece):
        swing = np.abs(h + z * w) if r == 0.0 else None
        if swing is not None:
            there.append(m + z * a + swing)
            back.append(swing - m - z * a)
            continue
        one, two = a + w, a - w
        reach_one, reach_two = r * np.sqrt(np.maximum(1.0 - one * one, 0.0)), r * np.sqrt(np.maximum(1.0 - two * two, 0.0))
        first, last = m + h + z * one, m - h + z * two
        there.append(np.maximum(first + reach_one, last + reach_two))
        if both:
            back.append(np.maximum(reach_one - first, reach_two - last))
    lever = max(abs(z) + r for z, r in _discs(piece))
    more = piece.round + way.bend_tip + lever * way.bend_axis
    up = (there[0] if len(there) == 1 else np.maximum(*there)) + more
    if not both:
        return up, up
    return up, (back[0] if len(back) == 1 else np.maximum(*back)) + more


def plate_bound(piece: Piece, way: Way, plate: Plates) -> Floats:
    """The bound (n,) mm in the direction from the piece, half-way, to the nearest place of the plate."""
    arm = tuple(plate.middle[k] - way.tip[k] for k in range(3))
    ways = (plate.normal, plate.side, _cross(plate.normal, plate.side))
    height = np.clip(_dot(arm, way.unit), piece.low, piece.high)
    core = tuple(height * way.unit[k] - arm[k] for k in range(3))  # the core's place on the axis, from the plate's middle
    at = tuple(np.clip(_dot(core, ways[i]), -plate.wide[i], plate.wide[i]) for i in range(3))
    place = tuple(arm[k] + at[0] * ways[0][k] + at[1] * ways[1][k] + at[2] * ways[2][k] for k in range(3))
    _, g = toward(piece, way.unit, place)
    over = supports(piece, way, g, both=False)[0] - _dot(g, plate.middle)
    for i in range(3):
        over += np.abs(_dot(g, ways[i])) * plate.wide[i]
    return over


def facet_bound(piece: Piece, way: Way, corner: Floats) -> Floats:
    """The bound (n,) mm in the direction from the piece, half-way, to the nearest place of triangles, corners (9, n)."""
    tip, unit, corners = np.stack(way.tip), np.stack(way.unit), corner.reshape(3, 3, -1)
    height = ((corners.mean(axis=0) - tip) * unit).sum(axis=0)
    place = nearest_on_facet(corners, tip + np.clip(height, piece.low, piece.high) * unit)
    _, g = toward(piece, way.unit, tuple(place - tip))
    begins = np.minimum(np.minimum(_dot(g, corner[:3]), _dot(g, corner[3:6])), _dot(g, corner[6:]))
    return supports(piece, way, g, both=False)[0] - begins


def least_depth(piece: Piece, way: Way, plate: Plates) -> Floats:
    """(n,) mm: a point of the part in the node is that deep at a pose of the way, or negative."""
    off, _ = toward(piece, way.unit, tuple(plate.point[k] - way.tip[k] for k in range(3)))
    short = np.abs(1.0 - _dot(way.axis, way.unit))
    return -off - way.bend_tip - (piece.reach + piece.round) * (way.bend_axis + short)


def _cross(p: Columns, q: Columns) -> Columns:
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def toward(piece: Piece, axis: Columns, arm: Columns) -> tuple[Floats, Columns]:
    """Signed distance (n,) mm of the points ``arm`` from the tip, and the unit direction in which it grows."""
    height = _dot(arm, axis)
    if piece.low_radius == 0.0 and piece.high_radius == 0.0:
        return _from_spine(piece, axis, arm, np.clip(height, piece.low, piece.high))
    out = tuple(arm[k] - height * axis[k] for k in range(3))
    radius = np.sqrt(_dot(out, out))
    off = off_piece(piece, radius, height)
    across = np.where(radius > NOWHERE, off.across / np.maximum(radius, NOWHERE), 0.0)
    g = tuple(off.along * axis[k] + across * out[k] for k in range(3))
    bare = np.flatnonzero(radius <= 1e-9)  # on the axis the direction across it is any
    if len(bare):
        g = _unit_on_axis(g, axis, off.along, bare)
    return off.distance, g


def _from_spine(
    piece: Piece, axis: Columns, arm: Columns, height: Floats
) -> tuple[Floats, Columns]:  # fmt: skip
    """:func:`toward` for a core that is a stretch of the axis: balls, and cylinders with round ends."""
    out = tuple(arm[k] - height * axis[k] for k in range(3))
    distance = np.sqrt(_dot(out, out))
    inverse = 1.0 / np.maximum(distance, NOWHERE)
    g = tuple(part * inverse for part in out)
    bare = np.flatnonzero(distance <= NOWHERE)
    if len(bare):
        g = _unit_on_axis(g, axis, np.zeros(len(distance)), bare)
    return distance - piece.round, g


def _unit_on_axis(
    g: Columns, axis: Columns, along: Floats, rows: Ints
) -> Columns:  # fmt: skip
    k = np.stack([part[rows] for part in axis])
    least = np.eye(3)[np.abs(k).argmin(axis=0)].T
    side = np.cross(k, least, axis=0)
    length = np.linalg.norm(side, axis=0)
    side = np.where(length > NOWHERE, side / np.maximum(length, NOWHERE), least)  # of opposite axes no mean is left
    share = along[rows]
    made = share * k + np.sqrt(np.maximum(1.0 - share * share, 0.0)) * side
    for column, value in zip(g, made, strict=True):
        column[rows] = value
    return g


def slab(piece: Piece, way: Way, plate: Plates) -> Floats:
    """The smaller one of the bounds (n,) mm along the plates' normals, both ways."""
    up, down = supports(piece, way, plate.normal, both=True)
    middle = _dot(plate.normal, plate.middle)
    return np.minimum(up - middle, down + middle) + plate.wide[0]


# ------------------------------------------------------------------------------------------------ facets


def support_at(piece: Piece, pose: Poses, g: Floats) -> Floats:
    """The support (n,) mm of the piece at poses in the unit directions g (3, n)."""
    along = (g * pose.axis).sum(axis=0)
    across = np.sqrt(np.maximum(1.0 - along * along, 0.0))
    reach = [z * along + r * across for z, r in _discs(piece)]
    most = reach[0] if len(reach) == 1 else np.maximum(*reach)
    return np.asarray((g * pose.tip).sum(axis=0) + most + piece.round)


def end_and_side(piece: Piece, pose: Poses, point: Floats) -> tuple[Floats, Floats]:
    """The directions (3, n) of a frustum's nearer end and of its side at points (3, n). Where a facet is deepest both are equally
    near, and neither direction alone tells so."""
    arm = point - pose.tip
    height = (arm * pose.axis).sum(axis=0)
    out = arm - height * pose.axis
    out = out / np.maximum(np.sqrt((out * out).sum(axis=0)), NOWHERE)
    slope = float(np.hypot(piece.high_radius - piece.low_radius, piece.high - piece.low))
    side = ((piece.high - piece.low) * out + (piece.low_radius - piece.high_radius) * pose.axis) / slope
    return np.where(2.0 * height < piece.low + piece.high, -1.0, 1.0) * pose.axis, side


def least_mixed(one: Floats, two: Floats) -> Floats:
    """About the least over shares s from 0 to 1 of the largest over rows of ``s one + (1 - s) two``, both (k, n), never below it.

    The mean of two bounds is a bound, too, at every corner and at both ends of a way. Where a rising point leaves the tool over
    its rim each bound alone is large at one end. The best share is looked for where the lines that are highest on both sides
    cross.
    """
    at = np.arange(one.shape[1])
    left, right = two.argmax(axis=0), one.argmax(axis=0)  # the highest lines at s = 0 and at s = 1
    best = np.minimum(one[right, at], two[left, at])
    for _ in range(CROSSINGS):
        rise = one - two
        down, up = two[left, at], two[right, at]
        change = rise[right, at] - rise[left, at]
        share = np.clip((down - up) / np.where(change == 0.0, 1.0, change), 0.0, 1.0)
        line = two + share * rise
        highest = line.argmax(axis=0)
        best = np.minimum(best, line[highest, at])
        falls = rise[highest, at] < 0.0
        left, right = np.where(falls, highest, left), np.where(falls, right, highest)
    return np.asarray(best)


class Deepest(NamedTuple):
    """``point`` (3, n) mm on the facet, its signed ``distance`` (n,) mm from the piece, and the direction ``g`` (3, n) in which
    that grows."""

    point: Floats
    distance: Floats
    g: Floats


def deepest(piece: Piece, pose: Poses, corner: Floats) -> Deepest:
    """The point of each triangle, corners (3, 3, n), that is deepest in the piece, or nearly so.

    From a point of the facet to the nearest of the core, and back to the nearest of the facet: this comes as near as can be, and
    for a ball at once. Inside the core the way goes down the slope of the distance instead. The best of all is kept.
    """
    axis, tip = tuple(pose.axis), pose.tip
    middle = corner.mean(axis=0) - tip
    height = np.clip((middle * pose.axis).sum(axis=0), piece.low, piece.high)
    aim = tip + height * pose.axis
    point_core = piece.low == piece.high and piece.low_radius == 0.0
    step = min(max(piece.low_radius, piece.high_radius), np.sqrt(float(((corner - corner[0]) ** 2).sum(axis=1).max(initial=0.0))))
    best: Deepest | None = None
    for _ in range(1 if point_core else STEPS):
        point = nearest_on_facet(corner, aim)
        distance, direction = toward(piece, axis, tuple(point - tip))
        g = np.stack(direction)
        if best is not None:  # from the best point so far, ever more carefully where the way is not that of projections
            better = distance < best.distance
            point, distance, g = (np.where(better, new, old) for new, old in zip((point, distance, g), best, strict=True))
        best = Deepest(point, distance, g)
        outside = distance + piece.round
        step *= 0.6
        aim = point - np.where(outside > 0.0, outside, step) * g
    assert best is not None
    return best


def nearest_on_facet(corner: Floats, place: Floats) -> Floats:
    """The point of each triangle, corners (3, 3, n), that is nearest to a place (3, n): Ericson, Real-Time Collision Detection,
    5.1.5."""
    a, b, c = (tuple(one) for one in corner)
    ab, ac = _less(b, a), _less(c, a)
    ap, one, two, both = _less(tuple(place), a), _dot(ab, ab), _dot(ac, ac), _dot(ab, ac)
    d1, d2 = _dot(ab, ap), _dot(ac, ap)
    d3, d4, d5, d6 = d1 - one, d2 - both, d1 - both, d2 - two
    va, vb, vc = d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2
    total = _safe(va + vb + vc)
    v, w = vb / total, vc / total
    share = (d4 - d3) / _safe((d4 - d3) + (d5 - d6))
    on = (va <= 0.0) & (d4 >= d3) & (d5 >= d6)
    v, w = np.where(on, 1.0 - share, v), np.where(on, share, w)
    on = (vb <= 0.0) & (d2 >= 0.0) & (d6 <= 0.0)
    v, w = np.where(on, 0.0, v), np.where(on, d2 / _safe(d2 - d6), w)
    on = (vc <= 0.0) & (d1 >= 0.0) & (d3 <= 0.0)
    v, w = np.where(on, d1 / _safe(d1 - d3), v), np.where(on, 0.0, w)
    for at, one_, two_ in (
        ((d6 >= 0.0) & (d5 <= d6), 0.0, 1.0),
        ((d3 >= 0.0) & (d4 <= d3), 1.0, 0.0),
        ((d1 <= 0.0) & (d2 <= 0.0), 0.0, 0.0),
    ):
        v, w = np.where(at, one_, v), np.where(at, two_, w)
    return np.stack([a[k] + v * ab[k] + w * ac[k] for k in range(3)])


def _less(p: Columns, q: Columns) -> Columns:
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def _safe(value: Floats) -> Floats:
    return np.where(value == 0.0, 1.0, value)
