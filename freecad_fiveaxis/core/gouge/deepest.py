# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deepest point of a facet in a piece at one pose, and the directions in which bounds are close there.

toward    the direction in which the distance from a piece grows; near its deepest point a bound in that
          direction is close.
mixed     where a point leaves a sharp rim no single direction is close along the whole way, but a mean of two
          bounds is.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.vectors import dot
from freecad_fiveaxis.core.tool.body import UNDIRECTED_MM, Piece, off_piece, support

from .swept_motion import Poses

Columns = tuple[Floats, ...]

STEPS = 6
"""Times that a facet's deepest point is improved; what is missing then is part of the bound."""

CROSSINGS = 4
"""Times that the best mean of two bounds is improved."""


def toward(piece: Piece, axis: Floats, arm: Floats) -> tuple[Floats, Floats]:
    """Signed distance (n,) mm from a piece of points ``arm`` (3, n) from the tip, and the unit direction (3,
    n) in which it grows; ``axis`` (3, n) unit."""
    height = (arm * axis).sum(axis=0)
    if piece.low_radius == 0.0 and piece.high_radius == 0.0:
        return _from_spine(piece, axis, arm, np.minimum(np.maximum(height, piece.low), piece.high))
    out = arm - height * axis
    radius = np.sqrt((out * out).sum(axis=0))
    off = off_piece(piece, radius, height)
    g = off.along * axis + (off.across * (radius > UNDIRECTED_MM) / np.maximum(radius, UNDIRECTED_MM)) * out
    bare = np.flatnonzero(radius <= 1e-9)  # on the axis the direction across it is any
    if len(bare):
        g[:, bare] = _unit_on_axis(axis[:, bare], off.along[bare])
    return off.distance, g


def _from_spine(piece: Piece, axis: Floats, arm: Floats, height: Floats) -> tuple[Floats, Floats]:
    """:func:`toward` for a core that is a stretch of the axis: balls, and cylinders with round ends."""
    out = arm - height * axis
    distance = np.sqrt((out * out).sum(axis=0))
    g = out / np.maximum(distance, UNDIRECTED_MM)
    bare = np.flatnonzero(distance <= UNDIRECTED_MM)
    if len(bare):
        g[:, bare] = _unit_on_axis(axis[:, bare], np.zeros(len(bare)))
    return distance - piece.round, g


def _unit_on_axis(axis: Floats, along: Floats) -> Floats:
    """Return unit directions (3, n) with ``along`` (n,) of the axis in them, and any way across it."""
    side = np.cross(axis, np.eye(3)[np.abs(axis).argmin(axis=0)].T, axis=0)
    side /= np.linalg.norm(side, axis=0)
    return np.asarray(along * axis + np.sqrt(np.maximum(1.0 - along * along, 0.0)) * side)


def support_at(
    piece: Piece, pose: Poses, g: Floats, loose: Floats | float = 0.0, high: Floats | None = None
) -> Floats:
    """Return the support (n,) mm of the piece at poses in the unit directions g (3, n), where the axis may be
    off by ``loose`` (n,); ``high`` (n,) mm: of as much of it as :func:`compute_needed_height` says."""
    along = (g * pose.axis).sum(axis=0)
    if high is None:
        return np.asarray((g * pose.tip).sum(axis=0) + support(piece, along, loose))
    disc = piece._replace(high=piece.low)
    more = np.maximum((high - piece.low) * (along + loose), 0.0)
    return np.asarray((g * pose.tip).sum(axis=0) + support(disc, along, loose) + more)


def find_top(start: Poses, end: Poses, corner: Floats, bend_tip: Floats, bend_axis: Floats) -> Floats:
    """Find how high (n,) mm above the tip triangles, corners (3, 3, n) mm, come on the ways from ``start`` to
    ``end``, which these leave by no more than the bends (n,).

    The height of a point, axis times its arm from the tip, is of second degree in u where tip and axis go
    straight, so between the ends it is at most a fourth of travel times turn above the higher one.
    """
    travel, turn = end.tip - start.tip, end.axis - start.axis
    heights = [((corner - pose.tip) * pose.axis).sum(axis=1).max(axis=0) for pose in (start, end)]
    far = np.sqrt(((corner - start.tip) ** 2).sum(axis=1).max(axis=0)) + _length(travel)
    bow = 0.25 * np.maximum((travel * turn).sum(axis=0), 0.0)
    return np.asarray(np.maximum(*heights) + bow + bend_tip + (far + bend_tip) * bend_axis)


def compute_needed_height(piece: Piece, top: Floats) -> Floats | None:
    """Find how high (n,) mm pieces need to be for triangles that come up to ``top`` (n,) mm above the tip;
    None for cones, whose sides are nearest elsewhere.

    What is no higher than h in a piece that is as wide above as below is as deep in the part of it that ends
    as far above h as it begins below. A long tool whose axis turns sweeps far with its upper end, and would
    be bounded by that all the way down.
    """
    if piece.low_radius != piece.high_radius:
        return None
    return np.asarray(np.clip(2.0 * top - piece.low, piece.low, piece.high))


def _length(vector: Floats) -> Floats:
    return np.asarray(np.sqrt((vector * vector).sum(axis=0)))


def end_and_side(piece: Piece, pose: Poses, point: Floats) -> tuple[Floats, Floats]:
    """Return the directions (3, n) of a frustum's nearer end and of its side at points (3, n). Where a facet
    is deepest both are equally near, and neither direction alone tells so."""
    arm = point - pose.tip
    height = (arm * pose.axis).sum(axis=0)
    out = arm - height * pose.axis
    out = out / np.maximum(np.sqrt((out * out).sum(axis=0)), UNDIRECTED_MM)
    slope = float(np.hypot(piece.high_radius - piece.low_radius, piece.high - piece.low))
    side = ((piece.high - piece.low) * out + (piece.low_radius - piece.high_radius) * pose.axis) / slope
    return np.where(2.0 * height < piece.low + piece.high, -1.0, 1.0) * pose.axis, side


def least_mixed(one: Floats, two: Floats) -> Floats:
    """About the least over shares s from 0 to 1 of the largest over rows of ``s one + (1 - s) two``, both (k,
    n), never below it.

    The mean of two bounds is a bound, too, at every corner and at both ends of a way. Where a rising point
    leaves the tool over its rim each bound alone is large at one end. The best share is looked for where the
    lines that are highest on both sides cross.
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
    """``point`` (3, n) mm on the facet, its signed ``distance`` (n,) mm from the piece, and the direction
    ``g`` (3, n) in which that grows."""

    point: Floats
    distance: Floats
    g: Floats


def deepest(piece: Piece, pose: Poses, corner: Floats) -> Deepest:
    """Return the point of each triangle, corners (3, 3, n), that is deepest in the piece, or nearly so.

    From a point of the facet to the nearest of the core, and back to the nearest of the facet: this comes as
    near as can be, and for a ball at once. Inside the core the way goes down the slope of the distance
    instead. The best of all is kept.
    """
    axis, tip = pose.axis, pose.tip
    middle = corner.mean(axis=0) - tip
    height = np.clip((middle * pose.axis).sum(axis=0), piece.low, piece.high)
    aim = tip + height * pose.axis
    point_core = piece.low == piece.high and piece.low_radius == 0.0
    size = np.sqrt(((corner - corner[0]) ** 2).sum(axis=1).max(axis=0))
    step = np.minimum(size, max(piece.low_radius, piece.high_radius))
    best: Deepest | None = None
    for _ in range(1 if point_core else STEPS):
        point = nearest_on_facet(corner, aim)
        distance, g = toward(piece, axis, point - tip)
        if (
            best is not None
        ):  # from the best point so far, ever more carefully where the way is not that of projections
            better = distance < best.distance
            point, distance, g = (
                np.where(better, new, old) for new, old in zip((point, distance, g), best, strict=True)
            )
        best = Deepest(point, distance, g)
        outside = distance + piece.round
        step = 0.6 * step
        aim = point - np.where(outside > 0.0, outside, step) * g
    assert best is not None
    return best


def nearest_on_facet(corner: Floats, place: Floats) -> Floats:
    """Return the point of each triangle, corners (3, 3, n), that is nearest to a place (3, n): Ericson,
    Real-Time Collision Detection, 5.1.5."""
    a, b, c = (tuple(one) for one in corner)
    ab, ac = _less(b, a), _less(c, a)
    ap, one, two, both = _less(tuple(place), a), dot(ab, ab), dot(ac, ac), dot(ab, ac)
    d1, d2 = dot(ab, ap), dot(ac, ap)
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
