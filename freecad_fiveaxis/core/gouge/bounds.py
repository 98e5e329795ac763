# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep nodes and facets can be in a piece on its way: upper bounds that hold for every u.

Any unit direction g gives a bound: what a piece reaches along g, less what the node begins at along g. It
holds wherever g comes from; a well chosen g only makes it close. From the cheapest to the dearest:

box      from the piece to the nearest place of the node's box: clears what is beside or below the tool.
plate    the node's normal both ways: close where the tool touches a surface.
edges    from the piece to the nearest place of a facet's edges: close where the tool touches an edge or a
         corner. A facet whose plane is not clear of a convex piece is nearest to it on an edge, or goes into
         it.

**Less of the piece.** A point deeper than d in a piece is deeper than d - s in what is left of the piece when
everything up to s below its surface is taken off. Bounds are taken on that: a tool that touches is clear of
it, so the way to it has a direction.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import Boxes, FacetTree
from freecad_fiveaxis.core.tool.body import Piece, distance_off, support

from .deepest import nearest_on_facet, toward
from .edges import along, nearest_on_edges
from .swept_motion import StraightSweep

NEAR = 1e-12
"""mm; what is nearer to a core than this is taken to be in it."""


def pare_piece(piece: Piece, by: float) -> tuple[Piece, float]:
    """Return what is left of a piece when up to ``by`` mm are taken off all around, and how much was; of a
    cone's flanks only its round is taken. ``piece.most`` must be larger than ``by``."""
    off = min(by, piece.round)
    round_, more = piece.round - off, by - off
    if piece.low_radius != piece.high_radius or more == 0.0:
        return piece._replace(round=round_), off
    radius = piece.low_radius - more
    return piece._replace(
        low=piece.low + more, low_radius=radius, high=piece.high - more, high_radius=radius, round=round_
    ), by


def box_bound(piece: Piece, sweep: StraightSweep, tree: FacetTree, node: Ints) -> Floats:
    """Return the bound (n,) mm in the direction from the piece to the nearest place of the nodes' boxes."""
    g, begins = toward_box(piece, sweep.tip, sweep.unit, tree.boxes(node))
    return np.asarray(_compute_support(piece, sweep, g) - begins)


def toward_box(piece: Piece, tip: Floats, axis: Floats, box: Boxes) -> tuple[Floats, Floats]:
    """Find the direction (3, n) from the piece at tips (3, n) mm, with unit axes (3, n), to the nearest place
    of boxes, and where these begin along it (n,) mm from the tip."""
    arm = box.middle - tip
    height = _inner(arm, axis)
    core = np.minimum(np.maximum(height, piece.low), piece.high) * axis
    core -= arm  # its place on the axis, from the box's middle
    off = along(box.ways, core)
    np.minimum(np.maximum(off, -box.half, out=off), box.half, out=off)
    place = np.einsum("kn,kin->in", off, box.ways)
    place += arm
    g = _away(piece, axis, place)
    wide = along(box.ways, g)
    np.abs(wide, out=wide)
    wide *= box.half
    return g, _inner(g, arm) - wide.sum(axis=0)


def plate_bound(piece: Piece, sweep: StraightSweep, tree: FacetTree, node: Ints) -> Floats:
    """Return the smaller one of the bounds (n,) mm along the nodes' normals, both ways."""
    plate = tree.plates(node)
    place, lean = _inner(plate.normal, sweep.tip), _inner(plate.normal, sweep.unit)
    go, turn = _dot(plate.normal, sweep.travel), _dot(plate.normal, sweep.turn)
    up = _compute_swept_support(piece, sweep, go, lean, turn) + place - plate.bottom
    down = _compute_swept_support(piece, sweep, _opposite(go), -lean, _opposite(turn)) - place + plate.top
    return np.asarray(np.minimum(up, down))


def facet_bound(piece: Piece, sweep: StraightSweep, tree: FacetTree, node: Ints) -> Floats:
    """Return the bound (n,) mm for nodes that are facets; infinite for others."""
    bound, rows = np.full(len(node), np.inf), np.flatnonzero(node >= tree.leaf)
    some = sweep.take(rows)
    bound[rows] = _triangle_bound(piece, some, tree.corners(node.take(rows) - tree.leaf) - some.tip)
    return bound


def _triangle_bound(piece: Piece, sweep: StraightSweep, arm: Floats) -> Floats:
    """Return the bound (n,) mm for triangles, corners (3, 3, n) from the tip in the middle of the way."""
    g, begins = toward_triangle(piece, sweep.unit, arm)
    return np.asarray(_compute_support(piece, sweep, g) - begins)


def toward_triangle(piece: Piece, axis: Floats, arm: Floats) -> tuple[Floats, Floats]:
    """Find the same as :func:`toward_box` for triangles, corners (3, 3, n) from the tip."""
    if piece.low_radius == piece.high_radius:
        place = nearest_on_edges(piece, axis, arm)
    else:
        height = (arm.mean(axis=0) * axis).sum(axis=0)
        place = nearest_on_facet(arm, np.clip(height, piece.low, piece.high) * axis)
    g = _away(piece, axis, place)
    return g, along(arm, g).min(axis=0)


def least_depth(piece: Piece, sweep: StraightSweep, point: Floats) -> Floats:
    """(n,) mm: these points (3, n) of the part are that deep at a pose of the way, or negative."""
    arm = point - sweep.tip
    height = _inner(arm, sweep.unit)
    out = arm - height * sweep.unit
    off = distance_off(piece, np.sqrt(_inner(out, out)), height)
    short = 0.0 if sweep.cosine is None else np.abs(1.0 - sweep.cosine)
    if sweep.bend_tip is None or sweep.bend_axis is None:
        return np.asarray(-off - (piece.reach + piece.round) * short)
    return np.asarray(-off - sweep.bend_tip - (piece.reach + piece.round) * (sweep.bend_axis + short))


def _away(piece: Piece, axis: Floats, place: Floats) -> Floats:
    """Return the unit direction (3, n) in which the distance from the piece grows at places (3, n) from the
    tip.

    On a core without a room inside, the axis or a disc, it is 0: with it a bound is as large as any.
    """
    if piece.low_radius != piece.high_radius:
        return toward(piece, axis, place)[1]
    height = _inner(place, axis)
    g = height * axis
    np.subtract(place, g, out=g)
    if piece.low_radius > 0.0:
        radius = np.sqrt(_inner(g, g))
        g *= np.maximum(radius - piece.low_radius, 0.0) / np.maximum(radius, NEAR)
    g += (height - np.minimum(np.maximum(height, piece.low), piece.high)) * axis
    distance = np.sqrt(_inner(g, g))
    g /= np.maximum(distance, NEAR)
    if piece.low_radius > 0.0 and piece.high > piece.low:
        within = np.flatnonzero(distance <= NEAR)
        g[:, within] = toward(piece, axis[:, within], place[:, within])[1]
    return np.asarray(g)


def _compute_support(piece: Piece, sweep: StraightSweep, g: Floats) -> Floats:
    """Return the support (n,) mm of the piece over its way in the unit directions g (3, n), from the way's
    middle tip."""
    return _compute_swept_support(
        piece, sweep, _dot(g, sweep.travel), _inner(g, sweep.unit), _dot(g, sweep.turn)
    )


def _compute_swept_support(
    piece: Piece, sweep: StraightSweep, go: Floats | None, lean: Floats, turn: Floats | None
) -> Floats:
    """:func:`_compute_support` from what travel, unit axis and turn are along g; it is largest at one of the
    ends."""
    if go is None or sweep.bend_tip is None or sweep.bend_axis is None:  # both ends are the same
        return support(piece, lean if sweep.cosine is None else sweep.cosine * lean)
    if turn is None or sweep.cosine is None:
        return np.asarray(support(piece, lean, sweep.bend_axis) + np.abs(go) + sweep.bend_tip)
    middle = sweep.cosine * lean
    start, end = (support(piece, there, sweep.bend_axis) for there in (middle - turn, middle + turn))
    return np.asarray(np.maximum(start - go, end + go) + sweep.bend_tip)


def _dot(one: Floats, two: Floats | None) -> Floats | None:
    return None if two is None else _inner(one, two)


def _opposite(one: Floats | None) -> Floats | None:
    return None if one is None else -one


def _inner(one: Floats, two: Floats) -> Floats:
    """Inner products (n,) of columns (3, n)."""
    return np.asarray(np.einsum("in,in->n", one, two))
