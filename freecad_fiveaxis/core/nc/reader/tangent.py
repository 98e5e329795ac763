# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arc that is tangent to two pieces of a contour that meet in a corner, each a line or an arc in the
working plane.

side     1 where the contour turns to the left in the corner, -1 to the right: there the arc's centre lies,
         its radius off both.
offset   of a line: the line so far to that side; of an arc: the circle with its centre, smaller by that where
         it bends to that side, else larger. The centre is where both offsets meet.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Floats

from .arcs import ARC_TOLERANCE

EQUAL = 1e-9
STRAIGHT, BACK = 1e-6, 1e-3
"""rad: pieces that go on in one direction have no corner; one that comes straight back has none that can be
rounded."""


@dataclass(frozen=True, eq=False)
class Piece:
    """From ``start`` to ``end`` (2,) mm; ``centre`` (2,) of an arc, None of a line; ``turn``: 1
    counter-clockwise, -1 clockwise, 0 of a line; ``length`` mm."""

    start: Floats
    end: Floats
    centre: Floats | None
    turn: float
    length: float

    @property
    def radius(self) -> float:
        """Of an arc, mm."""
        return 0.0 if self.centre is None else float(np.hypot(*(self.start - self.centre)))

    def tangent(self, place: Floats) -> Floats:
        """Return the direction (2,) at a place on it."""
        if self.centre is None:
            return (self.end - self.start) / self.length
        out = (place - self.centre) / np.hypot(*(place - self.centre))
        return self.turn * np.array([-out[1], out[0]])

    def along(self, place: Floats) -> float:
        """How far a place on it is from its start, mm; what lies before the start of a line is below 0, of an
        arc far on."""
        if self.centre is None:
            return float((place - self.start) @ self.tangent(self.start))
        one, two = (np.arctan2(*(at - self.centre)[::-1]) for at in (self.start, place))
        angle = float(np.mod(self.turn * (two - one), 2.0 * np.pi))
        return self.radius * (angle - 2.0 * np.pi if angle > 2.0 * np.pi - STRAIGHT else angle)

    def foot(self, centre: Floats) -> Floats:
        """Return the place on it, or on its line or circle, that is nearest to ``centre`` (2,)."""
        if self.centre is None:
            way = self.tangent(self.start)
            return self.start + ((centre - self.start) @ way) * way
        out = centre - self.centre
        return self.centre + self.radius * out / max(float(np.hypot(*out)), EQUAL)


@dataclass(frozen=True, eq=False)
class Rounding:
    """The arc about ``centre`` (2,) from ``first`` to ``last`` (2,), to the ``side``."""

    centre: Floats
    first: Floats
    last: Floats
    side: float

    def places(self) -> Floats:
        """Places (k, 2) of it from the first to the last, as far apart as chords may be."""
        out, end = self.first - self.centre, self.last - self.centre
        radius, begin = float(np.hypot(*out)), float(np.arctan2(out[1], out[0]))
        sweep = self.side * float(np.mod(self.side * (np.arctan2(end[1], end[0]) - begin), 2.0 * np.pi))
        count = max(int(np.ceil(abs(sweep) / (2.0 * np.arccos(1.0 - min(ARC_TOLERANCE / radius, 1.0))))), 1)
        angle = begin + sweep * np.linspace(0.0, 1.0, count + 1)
        points = self.centre + radius * np.column_stack([np.cos(angle), np.sin(angle)])
        points[-1] = self.last
        return np.asarray(points)


def corner(one: Piece, two: Piece) -> tuple[float, float]:
    """Return the angle by which the contour turns where they meet, rad, and the side to which it does."""
    before, after = one.tangent(one.end), two.tangent(two.start)
    cross = float(before[0] * after[1] - before[1] * after[0])
    return abs(float(np.arctan2(cross, before @ after))), 1.0 if cross > 0.0 else -1.0


def rounding(one: Piece, two: Piece, radius: float, taken: float) -> Rounding | None:
    """Return the arc of that radius between two pieces, the nearest to their corner; None where they are too
    short for it. ``taken`` mm of the first by the corner before."""
    side, best, least = corner(one, two)[1], None, np.inf
    for centre in _centres(one, two, side * radius):
        first, last = one.foot(centre), two.foot(centre)
        from_end, from_start = one.length - one.along(first), two.along(last)
        fits = (
            -ARC_TOLERANCE <= from_end <= one.length - taken + ARC_TOLERANCE and from_start >= -ARC_TOLERANCE
        )
        if fits and from_start <= two.length + ARC_TOLERANCE and from_end < least:
            best, least = Rounding(centre, first, last, side), from_end
    return best


def _centres(one: Piece, two: Piece, off: float) -> Iterator[Floats]:
    """Yield the places (2,) that lie ``off`` mm to the left of both, on whole lines and circles."""
    if one.centre is None:
        one, two = two, one
    if one.centre is None:
        return
    reach = one.radius - one.turn * off
    if reach <= EQUAL:
        return
    if two.centre is None:
        way = two.tangent(two.start)
        foot = two.start + off * np.array([-way[1], way[0]])
        foot = foot + ((one.centre - foot) @ way) * way
        high = reach**2 - float((foot - one.centre) @ (foot - one.centre))
    else:
        apart, other = two.centre - one.centre, two.radius - two.turn * off
        distance = float(np.hypot(*apart))
        if distance <= EQUAL or other <= EQUAL:
            return
        ahead = (reach**2 - other**2 + distance**2) / (2.0 * distance)
        foot, way = one.centre + ahead * apart / distance, np.array([-apart[1], apart[0]]) / distance
        high = reach**2 - ahead**2
    if high >= -EQUAL:
        root = float(np.sqrt(max(high, 0.0)))
        yield from (foot - root * way, foot + root * way)
