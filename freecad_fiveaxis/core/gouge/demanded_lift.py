# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a tool must go up along its axis, facet by facet: what a drop cutter asks, of the points that are
in the tool.

A point that is in a convex piece stays in it until the piece has gone up past it. So all that one of them
demands is demanded, and the most of it can be gone at once; going by the deepest point alone takes many steps
where a flat or bull nose cutter meets facets with its rim, where a point is never deep and demands much.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.tool.body import Body, Piece, distance_off, way_out

from .bounds import pare_piece
from .deepest import deepest
from .edges import along
from .swept_motion import Poses, StraightSweep
from .touched import points_touched

SPARED = 0.5
"""Of the limit: so deep a touched point may stay. Over a steep place the last of it would take a long way
up."""

WITHIN = 1.01
"""Of the limit: so far within the side points are looked for that are in the piece by just more than it."""


def may_demand(body: Body, ways: StraightSweep, tree: FacetTree, node: Ints, lift: Floats) -> Bools:
    """Tell which nodes (n,) come so high above the body's bottom, at the start of ways along its axis, that
    something in them may demand more than ``lift`` (n,) mm."""
    box, low = tree.boxes(node), min(piece.low - piece.round for piece in body.pieces)
    reach = (np.abs(along(box.ways, ways.unit)) * box.half).sum(axis=0)
    top = ((box.middle - _start(ways)) * ways.unit).sum(axis=0) + reach - low
    return np.asarray(top > lift)


def demand_points(lift: Floats, block: Ints, body: Body, ways: StraightSweep, point: Floats) -> None:
    """Raise ``lift`` (m,) mm of blocks to what points (3, n) mm demand that are in the body somewhere on the
    ``ways`` along its axis of ``block`` (n,) of them."""
    np.maximum.at(lift, block, way_out(body, _start(ways).T, ways.unit.T, point.T))


def _start(ways: StraightSweep) -> Floats:
    return ways.tip if ways.travel is None else ways.tip - ways.travel


def raise_to_demand(
    lift: Floats, block: Ints, piece: Piece, body: Body, pose: Poses, way: Floats, corner: Floats,
    limit: float
) -> None:  # fmt: skip
    """Raise ``lift`` (m,) mm of blocks to what facets, corners (3, 3, n) mm, demand of the body in ``block``
    (n,) of them, on its ``way`` (n,) mm up from a pose: by their corners, their deepest points, and where
    they are highest on the piece's rim or first touched from above. Nothing is demanded where none of these
    is in the piece anywhere on the way by more than ``limit`` mm."""
    points = [*corner, deepest(piece, pose, corner).point, *_on_rim(piece, pose, corner, WITHIN * limit)]
    by, enters = _find_demanded_lift(piece, body, pose, way, points, limit)
    np.maximum.at(lift, block, np.where(enters, by, 0.0))
    if piece.round > 0.0:
        top = ((corner - pose.tip) * pose.axis).sum(axis=1).max(axis=0) - piece.low + piece.round
        rows = np.flatnonzero(top > lift.take(block))  # no other can demand more
        pose, way, corner = Poses(pose.tip[:, rows], pose.axis[:, rows]), way[rows], corner[..., rows]
        lean = Body(tuple(pare_piece(one, SPARED * limit)[0] for one in body.pieces if one.most > limit))
        by, more = _find_demanded_lift(piece, lean, pose, way, points_touched(piece, pose, corner), limit)
        np.maximum.at(lift, block[rows], np.where(enters[rows] | more, by, 0.0))


def _find_demanded_lift(
    piece: Piece, body: Body, pose: Poses, way: Floats, points: list[Floats], limit: float
) -> tuple[Floats, Bools]:
    """Return the lift (n,) mm that these points (3, n) of facets demand, and whether one of them is in the
    piece on its ``way`` (n,) mm up by more than ``limit`` mm. What is over the piece demands, too: where some
    of its facet is in the piece, it comes in."""
    lift, enters = np.zeros(len(way)), np.zeros(len(way), np.bool_)
    tip, axis, middle = pose.tip.T, pose.axis.T, 0.5 * (piece.low + piece.high)
    for point in points:
        arm = point.T - tip
        height = (arm * axis).sum(axis=1)
        radius, over = np.linalg.norm(arm - height[:, None] * axis, axis=1), np.maximum(height - middle, 0.0)
        deep = np.flatnonzero(-distance_off(piece, radius, height - over) > limit)
        lift[deep] = np.maximum(lift[deep], way_out(body, tip[deep], axis[deep], point.T[deep]))
        enters |= (
            -distance_off(piece, radius, height - np.minimum(over, way)) > limit
        )  # there on the way it is deepest
    return lift, enters


def _on_rim(piece: Piece, pose: Poses, corner: Floats, inside: float) -> list[Floats]:
    """Points (3, n) of facets ``inside`` mm within the side of a piece: where their edges cross that
    cylinder, and where they are highest on it. NaN where there is none."""
    radius = max(piece.low_radius, piece.high_radius) + piece.round - inside
    arms = corner - pose.tip
    heights = (arms * pose.axis).sum(axis=1)
    outs = arms - heights[:, None] * pose.axis
    points = [_highest_on_rim(outs, heights, radius, corner)]
    for k in range(3):
        begin, way = outs[k], outs[(k + 1) % 3] - outs[k]
        a, b, c = (
            (way * way).sum(axis=0),
            (begin * way).sum(axis=0),
            (begin * begin).sum(axis=0) - radius * radius,
        )
        root = np.sqrt(np.where((b * b - a * c >= 0.0) & (a > 0.0), b * b - a * c, np.nan))
        for share in ((-b - root) / a, (-b + root) / a):
            share = np.where((share >= 0.0) & (share <= 1.0), share, np.nan)
            points.append(corner[k] + share * (corner[(k + 1) % 3] - corner[k]))
    return points


def _highest_on_rim(outs: Floats, heights: Floats, radius: float, corner: Floats) -> Floats:
    """Return the point (3, n) of each facet's plane that is highest on the cylinder, where it lies in the
    facet; else NaN."""
    e, f, rise_e, rise_f = (
        outs[1] - outs[0],
        outs[2] - outs[0],
        heights[1] - heights[0],
        heights[2] - heights[0],
    )
    ee, ef, ff = (e * e).sum(axis=0), (e * f).sum(axis=0), (f * f).sum(axis=0)
    det = ee * ff - ef * ef
    det = np.where(det > 0.0, det, np.nan)
    up = (
        (ff * rise_e - ef * rise_f) * e + (ee * rise_f - ef * rise_e) * f
    ) / det  # the facet's gradient across the axis
    steep = np.sqrt((up * up).sum(axis=0))
    aim = radius * up / np.where(steep > 0.0, steep, np.nan) - outs[0]
    one, two = (aim * e).sum(axis=0), (aim * f).sum(axis=0)
    v, w = (ff * one - ef * two) / det, (ee * two - ef * one) / det
    v = np.where((v >= 0.0) & (w >= 0.0) & (v + w <= 1.0), v, np.nan)
    return np.asarray(corner[0] + v * (corner[1] - corner[0]) + w * (corner[2] - corner[0]))
