# SPDX-License-Identifier: LGPL-2.1-or-later
"""What must not enter the part: cutter, shank and holder as one body of revolution about the tool axis.

body      a stack of convex pieces; heights are counted from the tip along the axis, towards the spindle, mm.
core      of a piece: a disc, a frustum, or a stretch of the axis; all points between the disc of
          ``low_radius`` at height ``low`` and the disc of ``high_radius`` at height ``high``.
bulge     of a core: its side is no straight line but an arc of that radius, which ends parallel to the axis
          at the high disc's radius and goes on as a cylinder to its height. With the round it is a barrel
          cutter, to the last bit, not in facets.
piece     all points within ``round`` of its core: a ball is a core of one point, a corner of a bull nose a
          rounded disc.
depth     of a point in the body: how far it is inside, mm; the largest over the pieces. Negative outside.
support   of a piece in a unit direction g: the largest ``g . x`` of its points x, here from a tip at 0.

Depth changes no faster than the body moves, and each piece is convex: its signed distance is a convex
function.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, say

from .barrel import Flank
from .cutter import Cutter

CUTTER, SHANK, HOLDER, SPINDLE = 0, 1, 2, 3
PARTS = (say("cutter"), say("shank"), say("holder"), say("spindle"))
"""What a piece belongs to."""

LARGEST = 1e4
"""mm; no tool reaches ten metres."""

UNDIRECTED_MM = 1e-30
"""mm; a distance from a tool's axis, or from the core of a piece, below this has no direction."""


class Piece(NamedTuple):
    """A convex piece, mm: the core's two discs and ``round``; ``part``: CUTTER, SHANK, HOLDER or SPINDLE;
    ``bulge``: radius of the arc between the discs, which begins on the axis (``low_radius`` 0) and is above
    ``high_radius``; 0: there is none."""

    low: float
    low_radius: float
    high: float
    high_radius: float
    round: float
    part: int = CUTTER
    bulge: float = 0.0

    @property
    def arc(self) -> tuple[float, float]:
        """Distance from the axis, below 0, and height above the tip, mm, of the middle of the bulge's arc."""
        middle = self.high_radius - self.bulge
        return middle, self.low + math.sqrt(self.bulge * self.bulge - middle * middle)

    @property
    def reach(self) -> float:
        """No point of the core lies farther from the tip than this; a turn of the axis by t moves none of
        them by more than t times as much."""
        return float(max(np.hypot(self.low, self.low_radius), np.hypot(self.high, self.high_radius)))

    @property
    def widest(self) -> float:
        """The largest distance of a point from the tool's axis, mm."""
        return float(max(self.low_radius, self.high_radius) + self.round)

    @property
    def most(self) -> float:
        """No point is deeper in the piece than this, mm."""
        thick = min(0.5 * (self.high - self.low), max(self.low_radius, self.high_radius))
        return float(self.round + thick)


class Body(NamedTuple):
    """Cutter, shank and holder: a stack of convex pieces."""

    pieces: tuple[Piece, ...]

    def only(self, *parts: int) -> Body:
        """Return the pieces of these parts."""
        return Body(tuple(piece for piece in self.pieces if piece.part in parts))

    @property
    def reach(self) -> float:
        """The largest reach of a piece with its round, mm."""
        return max((piece.reach + piece.round for piece in self.pieces), default=0.0)


def grow_body(body: Body, by: float) -> Body:
    """Grow every piece by ``by`` mm all round: what enters the grown body comes nearer than that."""
    return Body(tuple(piece._replace(round=piece.round + by) for piece in body.pieces))


def extend_way_out(body: Body, far: float) -> Body:
    """Put the body in all places at once that it takes while it is drawn out along its axis by ``far`` mm:
    above every piece that is wider than those below a cylinder stands, from where the piece is widest. A
    cutter's end, which lies partly in that, is its lower end, and no piece to be searched by itself."""
    pieces, widest = list[Piece](), 0.0
    for piece in sorted(body.pieces, key=lambda piece: piece.low - piece.round):
        start = piece.high if piece.high_radius >= piece.low_radius else piece.low
        if pieces and _goes_on(pieces[-1], piece):
            pieces[-1] = pieces[-1]._replace(low=piece.low)
            continue
        pieces.append(piece)
        if piece.widest > widest:
            widest = piece.widest
            pieces.append(frustum_piece(start, widest, min(start + far, LARGEST), widest, piece.part))
    return Body(tuple(pieces))


def _goes_on(over: Piece, piece: Piece) -> bool:
    """Tell whether two cylinders of one part, the second one begun lower and ended within the first, are
    equally wide: together they are one."""
    disc, part = (over.low_radius, over.high_radius, over.round, over.bulge), over.part
    alike = disc == (piece.low_radius, piece.high_radius, piece.round, piece.bulge) and part == piece.part
    return alike and over.low_radius == over.high_radius and piece.low <= over.low <= piece.high <= over.high


def round_piece(ring: float, corner: float, height: float, part: int = CUTTER) -> Piece:
    """Return the points within ``corner`` of a disc of radius ``ring`` at ``height``, mm: a ball where
    ``ring`` is 0."""
    return _check_piece(Piece(height, ring, height, ring, corner, part))


def frustum_piece(
    low: float, low_radius: float, high: float, high_radius: float, part: int = CUTTER
) -> Piece:
    """Return a cylinder or a cone frustum from height ``low`` to ``high``, mm."""
    return _check_piece(Piece(low, low_radius, high, high_radius, 0.0, part))


def _check_piece(piece: Piece) -> Piece:
    sizes = (*piece[:5], piece.bulge)
    if (
        not all(0.0 <= abs(size) <= LARGEST for size in sizes)
        or min(piece.low_radius, piece.high_radius, piece.round) < 0.0
    ):
        raise SettingsError(
            say(
                "a piece of the tool has sizes {sizes}; give radii of at least 0, up to {largest}",
                sizes=sizes,
                largest=Length(LARGEST),
            ),
            sizes,
        )
    if piece.high < piece.low or max(piece.low_radius, piece.high_radius, piece.round) == 0.0:
        raise SettingsError(
            say(
                "a piece of the tool from height {low} to {high} has no volume",
                low=Length(piece.low, bare=True),
                high=Length(piece.high),
            ),
            sizes,
        )
    return piece


def support(piece: Piece, along: Floats, loose: Floats | float = 0.0) -> Floats:
    """Return the support (n,) mm in unit directions that have ``along`` (n,) of the axis in them, where the
    axis may be off by a vector as long as ``loose`` (n,)."""
    low, high = (piece.low, piece.low_radius), (piece.high, piece.high_radius)
    across = (
        np.sqrt(np.maximum(1.0 - along * along, 0.0)) if piece.low_radius + piece.high_radius > 0.0 else 0.0
    )
    most = [
        _plus(z * along, r * across, (abs(z) + r) * loose) for z, r in ([low] if low == high else [low, high])
    ]
    reached = most[0] if len(most) == 1 else np.maximum(*most)
    if piece.bulge > 0.0:
        reached = np.maximum(reached, _bulge_support(piece, along, across, loose))
    return np.asarray(reached + piece.round)


def _bulge_support(piece: Piece, along: Floats, across: Floats | float, loose: Floats | float) -> Floats:
    """Return the support (n,) mm of a bulge's arc from a tip at 0; -inf in directions in which none of its
    points is the farthest."""
    middle, height = piece.arc
    reached = middle * across + piece.bulge + height * along + (abs(height) + piece.high_radius) * loose
    return np.where((along <= 0.0) & (along * piece.bulge >= piece.low - height), reached, -np.inf)


def _plus(column: Floats, *more: Floats | float) -> Floats:
    """Return the sum: a plain 0 takes no turn through the column."""
    for one in more:
        if not isinstance(one, float) or one != 0.0:
            column = column + one
    return column


def lower_body(body: Body, height: float) -> Body:
    """Count the heights of the body from ``height`` mm above the tip: its supports are then from the point
    there."""
    return Body(
        tuple(piece._replace(low=piece.low - height, high=piece.high - height) for piece in body.pieces)
    )


def body_support(body: Body, along: Floats) -> Floats:
    """Return the support mm of the body in unit directions that have ``along`` (any shape) of the axis in
    them, in the same shape."""
    return np.asarray(np.max([support(piece, along) for piece in body.pieces], axis=0))


def swing_support(body: Body, most: Floats) -> Floats:
    """Return the largest support (n,) mm of the body over all directions that have at most ``most`` (n,) of
    the axis in them: of each disc it is a sine of the angle, whose top counts where it is within."""
    discs = {(z, r, piece.round) for piece in body.pieces for z, r in (piece[:2], piece[2:4])}
    along = [np.minimum(z / max(math.hypot(z, r), UNDIRECTED_MM), most) for z, r, _ in discs]
    reach = [
        z * a + r * np.sqrt(np.maximum(1.0 - a * a, 0.0)) + c
        for (z, r, c), a in zip(discs, along, strict=True)
    ]
    level = np.minimum(most, 0.0)  # on a bulge, all of which is above the tip, the more along the farther
    reach += [support(piece, level) for piece in body.pieces if piece.bulge > 0.0]
    return np.asarray(np.max(reach, axis=0))


def body_of(
    cutter: Cutter, shank: Iterable[tuple[float, float]] = (), holder: Iterable[tuple[float, float]] = ()
) -> Body:
    """Return the body of a cutter up to its length, then shank and holder, after those that the cutter brings
    itself.

    ``shank``, ``holder``: (diameter, length) mm of stacked cylinders, from the cutter upwards. Raises
    SettingsError for sizes that no tool has.
    """
    pieces = [*_cutter_pieces(cutter), *(frustum_piece(*row, HOLDER) for row in cutter.holder)]
    top = max(cutter.length, cutter.corner)
    for part, rows in ((SHANK, shank), (HOLDER, holder)):
        for diameter, length in rows:
            pieces.append(frustum_piece(top, 0.5 * diameter, top + length, 0.5 * diameter, part))
            top += length
    return Body(tuple(pieces))


def _cutter_pieces(cutter: Cutter) -> list[Piece]:
    """One piece from the bottom up, so that no inner border makes a point seem less deep than it is: all
    points within the corner radius of a stretch of the axis (ball), a cylinder (bull nose) or a cone
    (tapered); and its end, which that rounds off, with so much below it that its own lower border does not
    count. Of a lollipop the ball, and its neck, which does not cut, as a shank; of a barrel all points within
    the corner radius of a bulge, and its end."""
    if cutter.stem:
        return [
            round_piece(cutter.ring, cutter.corner, cutter.corner),
            *(frustum_piece(*row, SHANK) for row in cutter.stem),
        ]
    if (barrel := cutter.barrel) is not None:
        return _barrel_pieces(cutter, barrel)
    corner, slope = cutter.corner, math.tan(cutter.taper)
    top = max(cutter.length, corner)
    last = min(max(top - corner, corner), top)
    pieces = [_check_piece(Piece(corner, cutter.ring, last, cutter.ring + (last - corner) * slope, corner))]
    if top > last:
        start = max(last - corner, min(corner, last))
        pieces.append(
            frustum_piece(start, cutter.top_radius - (cutter.length - start) * slope, top, cutter.top_radius)
        )
    return pieces


def _barrel_pieces(cutter: Cutter, barrel: Flank) -> list[Piece]:
    corner, wide, top, widest = cutter.corner, cutter.radius, cutter.length, cutter.corner + barrel.rise
    last = max(top - corner, widest)
    core = _check_piece(Piece(corner, 0.0, last, wide - corner, corner, bulge=barrel.radius - corner))
    start = max(last - corner, widest)
    return [core, *([frustum_piece(start, wide, top, wide)] if top > start else [])]


# ----------------------------------------------------------------------------------------- the meridian plane


class Off(NamedTuple):
    """``distance`` (n,) mm from the piece, negative inside; ``along`` and ``across`` (n,): its gradient along
    the axis and away from it, of length 1."""

    distance: Floats
    along: Floats
    across: Floats


def off_piece(piece: Piece, radius: Floats, height: Floats) -> Off:
    """Signed distance and its gradient at points ``radius`` (n,) from the axis and ``height`` (n,) above the
    tip, mm."""
    if piece.low == piece.high or (piece.low_radius == 0.0 and piece.high_radius == 0.0):
        near_radius = np.minimum(radius, piece.low_radius)
        near_height = np.clip(height, piece.low, piece.high)
        return _grow_by(_from_point(radius - near_radius, height - near_height), piece.round)
    if piece.bulge > 0.0:
        return _grow_by(_off_bulge(piece, radius, height), piece.round)
    return _grow_by(_off_frustum(piece, radius, height), piece.round)


def distance_off(piece: Piece, radius: Floats, height: Floats) -> Floats:
    """Return the distance (n,) mm of :func:`off_piece` alone."""
    if piece.low_radius != piece.high_radius:
        return off_piece(piece, radius, height).distance
    across, along = radius - piece.low_radius, np.maximum(piece.low - height, height - piece.high)
    inside = np.minimum(np.maximum(across, along), 0.0)
    across, along = np.maximum(across, 0.0), np.maximum(along, 0.0)
    return np.asarray(np.sqrt(across * across + along * along) + inside - piece.round)


def _grow_by(off: Off, by: float) -> Off:
    return Off(off.distance - by, off.along, off.across)


def _from_point(dr: Floats, dz: Floats) -> Off:
    distance = np.sqrt(dr * dr + dz * dz)
    safe = np.maximum(distance, UNDIRECTED_MM)
    across = np.where(distance > UNDIRECTED_MM, dr / safe, 1.0)  # in the core itself any direction is as good
    return Off(distance, dz / safe, across)


def _off_frustum(piece: Piece, radius: Floats, height: Floats) -> Off:
    """Inside: the nearest of bottom, side and top; outside: the nearest of their points."""
    r0, z0, r1, z1 = piece.low_radius, piece.low, piece.high_radius, piece.high
    slope = float(np.hypot(r1 - r0, z1 - z0))
    nr, nz = (z1 - z0) / slope, (r0 - r1) / slope  # outward across the side
    side = (radius - r0) * nr + (height - z0) * nz
    bottom, top = z0 - height, height - z1
    inner = np.maximum(np.maximum(bottom, top), side)
    by_side = side >= np.maximum(bottom, top)
    along_in = np.where(by_side, nz, np.where(bottom >= top, -1.0, 1.0))
    share = np.clip(((radius - r0) * (r1 - r0) + (height - z0) * (z1 - z0)) / slope**2, 0.0, 1.0)
    dr, dz = radius - r0 - share * (r1 - r0), height - z0 - share * (z1 - z0)
    square = dr * dr + dz * dz
    for level, rim in ((z0, r0), (z1, r1)):
        er, ez = radius - np.minimum(radius, rim), height - level
        nearer = er * er + ez * ez < square
        dr, dz = np.where(nearer, er, dr), np.where(nearer, ez, dz)
        square = np.where(nearer, er * er + ez * ez, square)
    outer = _from_point(dr, dz)
    inside = inner <= 0.0
    return Off(
        np.where(inside, inner, outer.distance),
        np.where(inside, along_in, outer.along),
        np.where(inside, np.where(by_side, nr, 0.0), outer.across),
    )


def _off_bulge(piece: Piece, radius: Floats, height: Floats) -> Off:
    """Of a core with a bulge: from its lowest point, its arc, its side or its top. No point of it is below
    the line from the middle of its arc to its lowest point, so inside only the arc, the side and the top are
    near."""
    middle, crest = piece.arc
    dr, dz = radius - middle, height - crest
    far = np.maximum(np.sqrt(dr * dr + dz * dz), UNDIRECTED_MM)
    by_arc = dz <= 0.0
    below = by_arc & (dz * piece.bulge < (piece.low - crest) * far)
    across, along = np.where(by_arc, far - piece.bulge, radius - piece.high_radius), height - piece.high
    out_across, out_along = np.where(by_arc, dr / far, 1.0), np.where(by_arc, dz / far, 0.0)
    corner = _from_point(np.maximum(radius - piece.high_radius, 0.0), np.maximum(along, 0.0))
    tip = _from_point(radius, height - piece.low)
    by_top = along > across
    side = Off(
        np.where(by_top, along, across), np.where(by_top, 1.0, out_along), np.where(by_top, 0.0, out_across)
    )
    side = Off(*(np.where(along > 0.0, one, two) for one, two in zip(corner, side, strict=True)))
    return Off(*(np.where(below, one, two) for one, two in zip(tip, side, strict=True)))


def depth_of(body: Body, tip: Floats, axis: Floats, point: Floats) -> Floats:
    """How deep points (n, 3) lie in the body whose tip (n, 3) mm and unit axis (n, 3), or (3,) each, are
    given: (n,) mm."""
    arm = np.asarray(point, float) - tip
    height = (arm * axis).sum(axis=-1)
    radius = np.linalg.norm(arm - height[..., None] * axis, axis=-1)
    depths = [-distance_off(piece, radius, height) for piece in body.pieces]
    return np.asarray(np.max(depths, axis=0))


def way_out(body: Body, tip: Floats, axis: Floats, point: Floats, more: Floats | float = 0.0) -> Floats:
    """How far (n,) mm bodies at tips and axes (n, 3) must go along their axes until points (n, 3) are below
    them: what a drop cutter calls the contact with a point. 0 where a point is below already, or beside the
    body all the way up. ``more`` (n,) mm: by which the body is grown all round."""
    arm = point - tip
    height = (arm * axis).sum(axis=-1)
    radius = np.linalg.norm(arm - height[..., None] * axis, axis=-1)
    floor = np.min([_underside(piece, radius, more) for piece in body.pieces], axis=0)
    return np.asarray(np.maximum(height - floor, 0.0))


def _underside(piece: Piece, radius: Floats, more: Floats | float) -> Floats:
    """Return the lowest height (n,) of a piece grown by so much so far from the axis, mm; infinite beside
    it."""
    if piece.bulge > 0.0:
        return _under_bulge(piece, radius, piece.round + more)
    r0, r1, c = piece.low_radius, piece.high_radius, piece.round + more
    over = np.maximum(radius - r0, 0.0)
    lowest = piece.low - np.sqrt(np.maximum(c * c - over * over, 0.0))
    under = np.where(over <= c, lowest, np.inf)
    if r1 > r0:  # the flank, moved out by the round, between the arcs about the rims of both discs
        slope, beyond = (piece.high - piece.low) / (r1 - r0), radius - r1
        lean = float(np.hypot(1.0, slope))
        begins = c * slope / lean
        rim = piece.high - np.sqrt(np.maximum(c * c - beyond * beyond, 0.0))
        flank = np.where(beyond <= begins, piece.low + over * slope - c * lean, rim)
        under = np.minimum(under, np.where((over >= begins) & (beyond <= c), flank, np.inf))
    return np.asarray(under)


def _under_bulge(piece: Piece, radius: Floats, round_: Floats | float) -> Floats:
    """Return the same of a bulge with so much round: below its lowest point a ball, then an arc as much
    larger."""
    middle, crest = piece.arc
    whole, out = piece.bulge + round_, radius - middle
    ball = piece.low - np.sqrt(np.maximum(round_ * round_ - radius * radius, 0.0))
    flank = crest - np.sqrt(np.maximum(whole * whole - out * out, 0.0))
    under = np.where(radius * piece.bulge <= -middle * round_, ball, flank)
    return np.where(out <= whole, under, np.inf)
