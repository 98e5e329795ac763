# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outline of a body in its meridian plane, for whoever draws what is checked.

outline   from the tip along bottom, corner, flank, shank and holder to the axis again: short straight
          stretches, which turned about the axis make the body's surface. Faces between two pieces, inside the
          body, are not in it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.tool.body import Body, Piece

NOTHING = 1e-9
"""mm; a stretch that is shorter is rounding, and its direction any."""

STRETCHES = 16
"""Of a quarter of a circle: 0.5 % of the radius is the farthest that the outline leaves it."""


class Outline(NamedTuple):
    """``start``, ``end`` (n, 2): distance from the axis and height above the tip, mm; ``start_normal``,
    ``end_normal`` (n, 2): away from the body there, unit; ``part`` (n,): CUTTER, SHANK or HOLDER."""

    start: Floats
    end: Floats
    start_normal: Floats
    end_normal: Floats
    part: Ints


def outline(body: Body) -> Outline:
    """Return the outline of a body whose pieces stand upon each other in their order, as
    :func:`~.body.body_of` makes them. Of a cutter that ends within its corner circles the body holds all of
    them; the outline ends where the next piece begins."""
    rows: list[Outline] = []
    at, part = np.array([0.0, body.pieces[0].low - body.pieces[0].round]), body.pieces[0].part
    for piece, after in zip(body.pieces, (*body.pieces[1:], None), strict=True):
        points, normals = _side(_above(piece, float(at[1])), after)
        rows.append(_straight(at, points[0], piece.part if points[0, 0] >= at[0] else part))
        rows.append(
            Outline(points[:-1], points[1:], normals[:-1], normals[1:], np.full(len(points) - 1, piece.part))
        )
        at, part = points[-1], piece.part
    rows.append(_straight(at, np.array([0.0, at[1]]), part))
    return Outline(*(np.concatenate(columns) for columns in zip(*map(_with_length, rows), strict=True)))


def _above(piece: Piece, height: float) -> Piece:
    """Return what of a frustum is above that height; it may begin within the piece below it."""
    if piece.round > 0.0 or not piece.low < height < piece.high:
        return piece
    share = (height - piece.low) / (piece.high - piece.low)
    return piece._replace(
        low=height, low_radius=piece.low_radius + share * (piece.high_radius - piece.low_radius)
    )


def _with_length(row: Outline) -> Outline:
    some = np.flatnonzero(np.linalg.norm(row.end - row.start, axis=1) > NOTHING)
    return Outline(*(column[some] for column in row))  # type: ignore[arg-type]


def _straight(start: Floats, end: Floats, part: int) -> Outline:
    along = end - start
    normal = np.array([along[1], -along[0]]) / max(float(np.hypot(*along)), np.finfo(float).tiny)
    return Outline(start[None], end[None], normal[None], normal[None], np.array([part]))


def _side(piece: Piece, after: Piece | None) -> tuple[Floats, Floats]:
    """Points (n, 2) and normals (n, 2) along a piece: lower rounding, flank, and the upper rounding up to the
    piece that follows it; nothing of it where that begins within the core."""
    if piece.bulge > 0.0:
        return _bulging_side(piece)
    lean = (
        math.atan2(piece.high_radius - piece.low_radius, piece.high - piece.low)
        if piece.high > piece.low
        else 0.0
    )
    low, high = (piece.low_radius, piece.low), (piece.high_radius, piece.high)
    if piece.round == 0.0:
        normal = np.array([math.cos(lean), -math.sin(lean)])
        return np.array([low, high]), np.array([normal, normal])
    lower = np.linspace(-0.5 * math.pi, -lean, STRETCHES + 1)
    ends = (
        0.5 * math.pi
        if after is None
        else math.asin(min(max((after.low - piece.high) / piece.round, 0.0), 1.0))
    )
    upper = np.linspace(-lean, ends, STRETCHES + 1) if after is None or ends > 0.0 else np.array([-lean])
    turn = np.concatenate([lower, upper])
    normals = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    cores = np.repeat([low, high], [len(lower), len(upper)], axis=0)
    return cores + piece.round * normals, normals


def _bulging_side(piece: Piece) -> tuple[Floats, Floats]:
    """Return the same along a piece with a bulge: lower rounding, arc, and the side up to where its core
    ends."""
    middle, crest = piece.arc
    begins = math.asin((piece.low - crest) / piece.bulge)
    lower, arc = np.linspace(-0.5 * math.pi, begins, STRETCHES + 1), np.linspace(begins, 0.0, STRETCHES + 1)
    turn = np.concatenate([lower, arc, [0.0]])
    normals = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    about = np.repeat(
        [(0.0, piece.low), (middle, crest), (piece.high_radius, piece.high)],
        [len(lower), len(arc), 1],
        axis=0,
    )
    far = np.repeat([piece.round, piece.bulge + piece.round, piece.round], [len(lower), len(arc), 1])
    return about + far[:, None] * normals, normals
