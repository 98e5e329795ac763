# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a round piece that comes down along its axis touches facets first: in their planes, and on their
edges."""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.tool.body import Piece

from .swept_motion import Poses

GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)

STEPS = 24
"""Times that the stretch in which an edge demands most is made shorter."""

AXIAL = 1e-12
"""Of a unit normal across the axis: below this the facet is level, and touched anywhere."""


def points_touched(piece: Piece, pose: Poses, corner: Floats) -> list[Floats]:
    """Return the points (3, n) mm of facets, corners (3, 3, n) mm, that the piece touches: one of the facet's
    plane, NaN where it is not in the facet, and one of each edge, where what it demands is concave."""
    edges = [_highest_over(piece, pose, corner[k], corner[(k + 1) % 3]) for k in range(3)]
    return [_find_touched_points(piece, pose, corner), *edges]


def _find_touched_points(piece: Piece, pose: Poses, corner: Floats) -> Floats:
    """Return the point (3, n) of each facet's plane at which a piece that comes down touches it, where that
    is in the facet; or NaN."""
    a, ab, ac = corner[0], corner[1] - corner[0], corner[2] - corner[0]
    normal = np.cross(ab, ac, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        normal /= np.sqrt((normal * normal).sum(axis=0))
        up = (normal * pose.axis).sum(axis=0)
        normal, up = np.where(up < 0.0, -normal, normal), np.abs(up)
        out = normal - up * pose.axis
        ring = piece.low_radius * out / np.maximum(np.sqrt((out * out).sum(axis=0)), AXIAL)
        point = pose.tip + piece.low * pose.axis - ring - piece.round * normal
        point += ((a - point) * normal).sum(axis=0) / up * pose.axis
        return np.where(_in_facet(point - a, ab, ac), point, np.nan)


def _in_facet(arm: Floats, ab: Floats, ac: Floats) -> Bools:
    """Whether points ``arm`` (3, n) from a facet's corner, in its plane, lie in the facet of edges (3, n)
    from there."""
    one, two, both = (ab * ab).sum(axis=0), (ac * ac).sum(axis=0), (ab * ac).sum(axis=0)
    along, across, det = (arm * ab).sum(axis=0), (arm * ac).sum(axis=0), one * two - both * both
    v, w = two * along - both * across, one * across - both * along
    return np.asarray((v >= 0.0) & (w >= 0.0) & (v + w <= det) & (det > 0.0))


def _highest_over(piece: Piece, pose: Poses, begin: Floats, end: Floats) -> Floats:
    """Return the point (3, n) from ``begin`` to ``end`` (3, n) that is highest over the underside of a piece,
    by golden section; about the nearest to the axis where none is under it."""
    arm, way = begin - pose.tip, end - begin
    height, rise = (arm * pose.axis).sum(axis=0), (way * pose.axis).sum(axis=0)
    out, go = arm - height * pose.axis, way - rise * pose.axis
    a, b, c = (go * go).sum(axis=0), (out * go).sum(axis=0), (out * out).sum(axis=0)
    wide, round_ = piece.low_radius + piece.round, piece.round

    def find_demand(share: Floats) -> Floats:
        radius = np.sqrt(np.maximum(c + share * (2.0 * b + share * a), 0.0))
        over = np.maximum(radius - piece.low_radius, 0.0)
        up = height + share * rise + np.sqrt(np.maximum(round_ * round_ - over * over, 0.0))
        return np.asarray(np.where(radius <= wide, up, -1e6 * radius))

    low, high = np.zeros(len(a)), np.ones(len(a))
    one, two = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    first, second = find_demand(one), find_demand(two)
    for _ in range(STEPS):
        left = first > second
        low, high = np.where(left, low, one), np.where(left, two, high)
        one, two = (
            np.where(left, high - GOLDEN * (high - low), two),
            np.where(left, one, low + GOLDEN * (high - low)),
        )
        fresh = find_demand(np.where(left, one, two))
        first, second = np.where(left, fresh, second), np.where(left, first, fresh)
    return np.asarray(begin + 0.5 * (low + high) * way)
