# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which way from its contact the middle of a cutter lies.

out       unit vector perpendicular to the axis, from the contact's side of the ring towards the hub: hub =
          contact + corner x normal + ring x out. It is the part of the normal across the axis, made unit.
square    the axis along the normal: every point of a level bottom touches, and out is not defined. There the
          contact is the foremost point of the bottom, out = against the feed, which is the limit of a small
          positive lead. Where a path asks for it, it is the middle of the bottom instead, out = 0
          (:attr:`~..toolpath.coedge.OffsetPath.middle`).
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.vectors import NO_DIRECTION

SLIP = 5e-5
"""mm; the axis counts as square where the bottom, whichever way out points, dips below the plane by no more
than this: half of a word's last digit, and half of what may be between the cutter and its contact."""


def ring_direction(normal: Floats, axis: Floats, feed: Floats, ring: float) -> Floats:
    """Out (n, 3) for unit ``normal``, ``axis`` and ``feed`` (n, 3) and a ring of radius ``ring`` mm.

    With out off by any angle the bottom dips by ``ring (sine - out . normal) <= 2 ring sine``, sine that of
    the angle between normal and axis: that is what SLIP bounds. A feed along the axis, where it is needed, is
    replaced by any perpendicular.
    """
    out = _across(normal, axis)
    sine = np.sqrt(np.einsum("ij,ij->i", out, out))
    square = np.flatnonzero(_is_square(sine, ring))
    if len(square):
        back = -_across(feed[square], axis[square])
        lost = np.flatnonzero(np.einsum("ij,ij->i", back, back) <= NO_DIRECTION**2)
        least = np.abs(axis[square[lost]]).argmin(axis=1)
        back[lost] = _across(np.eye(3)[least], axis[square[lost]])
        out[square], sine[square] = back, np.sqrt(np.einsum("ij,ij->i", back, back))
    out /= sine[:, None]
    return out


def stands_square(normal: Floats, axis: Floats, ring: float) -> Bools:
    """Find where (n,) a bottom with a ring of radius ``ring`` mm and unit ``axis`` (n, 3) lies level on the
    surface with unit ``normal`` (n, 3)."""
    return _is_square(np.linalg.norm(_across(normal, axis), axis=1), ring)


def _is_square(sine: Floats, ring: float) -> Bools:
    return np.asarray(2.0 * ring * sine <= SLIP)


def _across(vector: Floats, axis: Floats) -> Floats:
    """Return the part (n, 3) of ``vector`` perpendicular to the unit ``axis``."""
    return np.asarray(vector - np.einsum("ij,ij->i", vector, axis)[:, None] * axis)
