# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way out of the part and back: where the tool goes between one polyline and the next.

retract    away from the part along the tool axis, at feed.      approach   the same way back, at the plunge
           feed.
keep-out   the part's box inflated by the clearance and, to each side, by the support of the whole tool
           (cutter, shank, holder) against that side, at least by the ball's radius: while the ball's centre
           stays out of it, and the axis does not turn, the tool stays out of the part's box inflated by the
           clearance. Each axis has its own.
safe plane the height at which the centre goes across. The axis turns only there: whichever axis between
upright and the lowest
           of both ends the tool takes up, none of it reaches down to the part.

All of this is done with the centre of the ball; the tip follows from it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM
from freecad_fiveaxis.core.tool.body import Body, body_support, swing_support

SAFE_MARGIN = 2.0
"""mm between the keep-out and the safe plane, because joint moves that turn the axis bend the traverse."""

SIDE_MARGIN = 1e-3
"""mm by which the keep-out is larger than it must be, so that rounding of a point or a word never puts a
rapid inside."""


ROUNDING_MM = 0.1 * SIDE_MARGIN
"""mm by which a tool may reach farther than its ball before that counts: normals of walls are about 1e-7 off
level."""

LOOKS_DOWN = 1e-4
"""An axis with so much of -Z looks down; with less it may be that of a vertical wall."""

DIP = 0.25
"""Of the corner radius: so far the centre sinks, at most, where the tip goes straight while the axis turns
below level: a cosine leaves its chord by 0.21."""


class Keepout(NamedTuple):
    """``low`` and ``high`` (3,) or, for each axis, (m, 3) mm: what the centre avoids on rapids; ``safe`` mm,
    one or (m,): height of the safe plane."""

    low: Floats
    high: Floats
    safe: Floats | float


class WayOut(NamedTuple):
    """From m places to the safe plane: ``station`` (m, 3, 3) mm centres in order: end of the retract, beside
    the part, on the safe plane; ``needed`` (m, 3) False where a station is the same place as the one before
    it."""

    station: Floats
    needed: Bools


def keepout(low: Floats, high: Floats, radius: float, clearance: float) -> Keepout:
    """Keep-out and safe plane for the part's box ``low``, ``high`` (3,) mm."""
    off = radius + clearance + SIDE_MARGIN
    return Keepout(
        np.asarray(low, float) - off, np.asarray(high, float) + off, float(high[2]) + off + SAFE_MARGIN
    )


def tool_keepout(
    low: Floats, high: Floats, radius: float, clearance: float, body: Body, axis: Floats
) -> Keepout:
    """Keep-outs and safe planes of the whole tool with unit ``axis`` (m, 3), for the part's box ``low``,
    ``high`` (3,) mm.

    ``body`` as seen from the centre; ``radius`` mm: no side grows by less.
    """
    lowest = axis[:, 2]
    up, down, swing = body_support(body, axis), body_support(body, -axis), swing_support(body, -lowest)
    off, under, deep = (_beyond_ball(reach, radius) + clearance + SIDE_MARGIN for reach in (up, down, swing))
    dip = np.where(lowest < -LOOKS_DOWN, DIP * radius, 0.0)
    return Keepout(
        np.asarray(low, float) - off,
        np.asarray(high, float) + under,
        float(high[2]) + deep + SAFE_MARGIN + dip,
    )


def _beyond_ball(reach: Floats, radius: float) -> Floats:
    """Return the reach, mm, where it is more than the ball's, else the ball's."""
    return np.where(reach > radius + ROUNDING_MM, reach, radius)


def way_out(centre: Floats, axis: Floats, keep: Keepout) -> WayOut:
    """Along the axis until clear, sideways where the part is overhead, straight up to the safe plane.

    ``centre`` (m, 3) mm, unit ``axis`` (m, 3), or the direction in which the tool gets out instead. The
    sideways station is needed only where the axis looks down.
    """
    clear = centre + _reach_out(centre, axis, keep)[:, None] * axis
    beside = _beside(clear, keep)
    up = beside.copy()
    up[:, 2] = np.maximum(up[:, 2], keep.safe)
    station = np.stack([clear, beside, up], axis=1)
    before = np.stack([centre, clear, beside], axis=1)
    return WayOut(station, np.abs(station - before).max(axis=2) > COINCIDENT_MM)


def _reach_out(centre: Floats, axis: Floats, keep: Keepout) -> Floats:
    """How far along the axis the last point inside the keep-out lies, mm (0 where the ray is outside
    already): slab test."""
    with np.errstate(
        divide="ignore", invalid="ignore", over="ignore"
    ):  # an axis may lean by less than any number tells
        near, far = (keep.low - centre) / axis, (keep.high - centre) / axis
    level = axis == 0.0
    inside = (centre > keep.low) & (centre < keep.high)
    enter = np.where(level, np.where(inside, -np.inf, np.inf), np.minimum(near, far)).max(axis=1)
    leave = np.where(level, np.where(inside, np.inf, -np.inf), np.maximum(near, far)).min(axis=1)
    return np.asarray(np.where((enter < leave) & (leave > 0.0), leave, 0.0))


def _beside(place: Floats, keep: Keepout) -> Floats:
    """Return the place itself; where the part is overhead, the nearest place at the same height that has
    nothing above it."""
    overhead = ((place > keep.low) & (place < keep.high))[:, :2].all(axis=1) & (
        place[:, 2] <= keep.low[..., 2] + SIDE_MARGIN
    )
    row = np.flatnonzero(overhead)
    moved = place.copy()
    low, high = (np.broadcast_to(face, place.shape)[row, :2] for face in (keep.low, keep.high))
    sides = np.concatenate([place[row, :2] - low, high - place[row, :2]], axis=1)
    side = sides.argmin(axis=1)
    moved[row, side % 2] = np.concatenate([low, high], axis=1)[np.arange(len(row)), side]
    return moved
