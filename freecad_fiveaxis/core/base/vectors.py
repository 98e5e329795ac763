# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths, inner products and great arcs of many vectors: by rows (..., 3), or by columns: three arrays, or
one (3, ...)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from .records import Floats

Vectors = Sequence[Any] | Floats
"""Three columns x, y and z, of one shape or that of numbers."""

NO_DIRECTION = 1e-9
"""Pure number: a sum or a part of unit vectors that is no longer than this has no direction but that of
rounding. Two unit vectors of such a sum are opposite."""

COINCIDENT_MM = 1e-9
"""mm; two places nearer than this are one place: coordinates of a part are rounded to about 1e-13 mm."""

RIGHT_RAD = 1e-12
"""rad; an angle that near to whole quarter turns differs from these by its rounding alone."""


def row_dot(one: Floats, two: Floats) -> Floats:
    """Inner products (n,) of the rows of two (n, 3) arrays."""
    return np.asarray(np.einsum("ij,ij->i", one, two))


def dot(one: Vectors, two: Vectors) -> Floats:
    """Inner products of vectors by columns."""
    product: Floats = one[0] * two[0] + one[1] * two[1] + one[2] * two[2]
    return product


def length(vector: Vectors) -> Floats:
    """Lengths of vectors by columns."""
    return np.asarray(np.sqrt(dot(vector, vector)))


def slerp(start: Floats, end: Floats, share: Floats) -> Floats:
    """Return unit vectors (..., 3) at ``share`` (...) of the angle from ``start`` to ``end``, unit vectors by
    rows (..., 3).

    Spherical linear interpolation (Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985): on
    the great arc, at an angle that grows evenly with the share. Between equal vectors nothing turns. Opposite
    ones (:data:`NO_DIRECTION`) name no great arc: the way then goes over a direction that is square to
    ``start`` and to its smallest coordinate's axis.
    """
    wide = _norm(start + end)
    angle = 2.0 * np.arctan2(_norm(end - start), wide)
    rest = 1.0 - share
    mixed = _times(rest * np.sinc(rest * angle / np.pi), start) + _times(
        share * np.sinc(share * angle / np.pi), end
    )
    lost = wide <= NO_DIRECTION
    if lost.any():
        turn = (share * angle)[lost]
        mixed[lost] = _times(np.cos(turn), start[lost]) + _times(np.sin(turn), _square_to(start[lost]))
    return np.asarray(mixed / _norm(mixed)[..., None])


def _norm(rows: Floats) -> Floats:
    return length(np.moveaxis(rows, -1, 0))


def _times(factor: Floats, rows: Floats) -> Floats:
    return np.asarray(factor[..., None] * rows)


def _square_to(rows: Floats) -> Floats:
    """Return a unit vector (n, 3) square to each of ``rows`` (n, 3)."""
    across = np.cross(rows, np.eye(3)[np.abs(rows).argmin(axis=1)])
    return np.asarray(across / _norm(across)[:, None])


def away_from(point: Floats, through: Floats, about: Floats) -> tuple[Floats, Floats]:
    """Find the unit direction (n, 3) from the line ``through`` a point, mm, along the unit vector ``about``
    to each ``point`` (n, 3), mm, and the distance (n,), mm. On the line itself the direction is 0."""
    offset = point - through
    offset = offset - (offset @ about)[:, None] * about
    far = _norm(offset)
    return np.asarray(offset / np.where(far > COINCIDENT_MM, far, np.inf)[:, None]), far


def turn_about_fixed_axes(about_x: float, about_y: float, about_z: float, right: float = RIGHT_RAD) -> Floats:
    """Return the matrix (3, 3) of right-handed turns about X, then Y, then Z, rad, all three axes of the
    frame that stays (roll, pitch and yaw of URDF). Angles within ``right`` rad of quarter turns are these,
    exactly."""
    x, y, z = (_turn_about(k, angle, right) for k, angle in enumerate((about_x, about_y, about_z)))
    return np.asarray(z @ y @ x)


def _turn_about(axis: int, angle: float, right: float) -> Floats:
    """Return the right-handed turn (3, 3) about X, Y or Z."""
    cosine, sine = _cosine_sine(angle, right)
    found, (one, two) = np.eye(3), ((axis + 1) % 3, (axis + 2) % 3)
    found[one, one] = found[two, two] = cosine
    found[one, two], found[two, one] = -sine, sine
    return found


def _cosine_sine(angle: float, right: float) -> tuple[float, float]:
    """Cosine and sine of an angle, of whole quarter turns to the last digit."""
    quarters = round(angle / (0.5 * math.pi))
    if abs(angle - quarters * 0.5 * math.pi) < right:
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[quarters % 4]
    return math.cos(angle), math.sin(angle)
