# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nearest place of a facet's edges to the core of a piece that is as wide above as below: balls, bull
noses, cylinders.

meridian   heights along the axis, counted from the core's low disc, and distances from the axis squared.
           Along an edge, from one corner to the next, the height is linear in the share t of the edge and the
           square quadratic: ``height = rise_0 + t rise`` and ``square = square_0 + 2 t mixed + t^2 square``.

The distance from a convex core is a convex function along an edge, so Newton's way finds its least. What lies
above the core is taken to be beside it: the direction found is as good or a worse one, and what is made of it
holds all the same.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.tool.body import Piece

FIRST, THEN = 4, 4
"""Steps along an edge to the place nearest to a core that is a disc: so many along all edges, then along the
nearest."""

RIM = 1.0 - 1e-9
"""Of the disc's radius: from there on the way bends as it does outside, else steps would go to and fro
between rim and height."""

TINY = 1e-30


class _Edges(NamedTuple):
    """Columns (3, n): an edge of each facet in a row."""

    rise_0: Floats
    rise: Floats
    square_0: Floats
    mixed: Floats
    square: Floats

    def at(self, t: Floats) -> tuple[Floats, Floats]:
        """How far below the core's low disc (0 where above it, else negative) and how far from the axis."""
        below = np.minimum(self.rise_0 + t * self.rise, 0.0)
        return below, np.sqrt(np.maximum(self.square_0 + t * (2.0 * self.mixed + t * self.square), 0.0))


def nearest_on_edges(piece: Piece, axis: Floats, corner: Floats) -> Floats:
    """Return the place (3, n) of the edges that is nearest to the core, or nearly so; mm from the tip, as
    ``corner`` (3, 3, n) of the triangles are; ``axis`` (3, n) unit."""
    side = corner[[1, 2, 0]] - corner
    low, rise = along(corner, axis), along(side, axis)
    mixed = np.einsum("kin,kin->kn", corner, side) - low * rise
    edges = _Edges(low - piece.low, rise, _across(corner, low), mixed, _across(side, rise))
    at, wide = np.arange(axis.shape[1]), piece.low_radius
    t = (
        _nearest_to_spine(edges)
        if wide == 0.0
        else _nearest_to_disc(edges, wide, _clip_share(_nearest_to_axis(edges)), FIRST)
    )
    best = _off(edges, wide, t).argmin(axis=0)
    t, edge = t[best, at], _Edges(*(column[best, at] for column in edges))
    if wide > 0.0:
        t = _nearest_to_disc(edge, wide, t, THEN)
    return np.asarray(corner[best, :, at].T + t * side[best, :, at].T)


def along(vectors: Floats, way: Floats) -> Floats:
    """How far (3, n) three vectors each (3, 3, n) go along ways (3, n)."""
    return np.asarray(np.einsum("kin,in->kn", vectors, way))


def _across(vector: Floats, height: Floats) -> Floats:
    return np.asarray(np.maximum(np.einsum("kin,kin->kn", vector, vector) - height * height, 0.0))


def _clip_share(t: Floats) -> Floats:
    return np.asarray(np.minimum(np.maximum(t, 0.0), 1.0))


def _nearest_to_axis(edges: _Edges) -> Floats:
    return np.asarray(-edges.mixed / (edges.square + TINY))


def _nearest_to_spine(edges: _Edges) -> Floats:
    """Nearest to the axis from the low disc upwards: where that is below the disc, nearest to the disc's
    middle instead."""
    beside = _nearest_to_axis(edges)
    whole = edges.mixed + edges.rise_0 * edges.rise
    under = -whole / (edges.square + edges.rise * edges.rise + TINY)
    return _clip_share(np.where(edges.rise_0 + beside * edges.rise < 0.0, under, beside))


def _off(edges: _Edges, wide: float, t: Floats) -> Floats:
    """Return the distance from the core, squared."""
    below, radius = edges.at(t)
    beside = np.maximum(radius - wide, 0.0)
    return np.asarray(beside * beside + below * below)


def _nearest_to_disc(edges: _Edges, wide: float, t: Floats, steps: int) -> Floats:
    """Newton's way from t to the least of half the distance squared, ``beside^2 + below^2``."""
    for _ in range(steps):
        below, radius = edges.at(t)
        radius = radius + TINY
        beside, outward = np.maximum(radius - wide, 0.0), (edges.mixed + t * edges.square) / radius
        slope, turn = beside * outward + below * edges.rise, outward * outward
        bend = (radius > RIM * wide) * (turn + beside * (edges.square - turn) / radius) + (
            below < 0.0
        ) * edges.rise * edges.rise
        t = _clip_share(t - slope / (bend + TINY))
    return t
