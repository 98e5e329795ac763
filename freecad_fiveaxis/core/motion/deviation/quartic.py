# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest distance of an ordinary block's real path from its chord, from five points of the path, and its
proof.

A block that turns by a few degrees is a smooth arc: the quartic through the path at u = 0, 1/4, 1/2, 3/4, 1
leaves it by less than can be measured, and the largest distance of a quartic from its chord is the root of a
polynomial. Every step has a bound; a block for which one of them is not small enough is not ``proven`` and
goes to ``search``.

bow       g in ``tip = start + u chord + u (1 - u) g(s)``, ``s = u - 1/2``: a parabola g = A + B s + C s^2 for
          the quartic.
across    the part of a vector across the chord; along, its component in the chord's direction.

1. The quartic leaves the path by at most ``max |(u-0)...(u-1)| / 5! max |tip^(5)|``, so every distance by no
   more.
2. f = |u (1-u) g_across|^2 is the squared distance from the line, and ``f' = (1/4 - s^2) H(s)`` with a
   quintic H. Where the coefficients show that H' <= -m < 0 on the block, there is one maximum, and at an s
   where H is nearly zero f is less than that maximum by at most ``H(s)^2 / (4 m)``.
3. Where |g_along| is nowhere longer than the chord, the foot of the perpendicular stays within the chord
   (``u + u (1-u) g_along / chord`` runs from 0 to 1 without leaving them): then the line is the segment.
4. Where the path cannot bend by more than :data:`NOTHING` at all (``bound``), nothing of this is needed.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.motion.trajectory import Motion, Pose, turn_vector

from .bound import ABSOLUTE, RELATIVE, Levers, bending

NODES = np.array([[0.25], [0.5], [0.75]])
"""u of the points between the ends; columns at the nodes have the shape (3, n)."""

REMAINDER = 3.6315 / 4.0**5 / 120.0
"""``max |u (u - 1/4) (u - 1/2) (u - 3/4) (u - 1)| / 5!``, rounded up: ``|t (t^2 - 1) (t^2 - 4)| <= 3.6315``
for |t| <= 2."""

POINT = 1e-5
"""mm: a chord shorter than this, a tenth of the finest step that controllers print, has no direction and
counts as a point: where it points is the rounding of words and arithmetic, and so would be any distance from
the line through it. Distances are then measured from its point of the same u, which makes them larger by no
more than this."""

NOTHING = 5e-7
"""mm: half the accuracy that is promised for the deviation."""

MOST_TURN = 0.35
"""rad: beyond this summed travel the quartic is not tried."""

STEEP = 0.25
"""H' must be at least this share of |A|^2 below zero (it is 4 |A|^2 for a parabola): far more than rounding
can take away."""

SMALLEST = 1e-150
"""Keeps a quotient defined where its numerator is zero too, or its row is not used."""


@dataclass(frozen=True, eq=False)
class Chord:
    """``start``, ``vector`` (3, n) mm; ``along`` (3, n): its unit vector, zero for a point; ``length`` (n,)
    mm. First frame."""

    start: Floats
    vector: Floats
    along: Floats
    length: Floats


@dataclass(frozen=True, eq=False)
class Bow:
    """One row a block: the largest ``distance`` mm at ``u``, its ``bound`` mm without rounding, the ``place``
    (3, n) there."""

    distance: Floats
    u: Floats
    bound: Floats
    place: Floats
    proven: Bools


def chord(start: Floats, end: Floats) -> Chord:
    """Return the chords of blocks between the tips (3, n) at their ends."""
    vector = end - start
    length = _lengths(vector)
    return Chord(start, vector, vector * ((length > POINT) / np.maximum(length, POINT)), length)


def subtract_chord_motion(move: Motion, way: Chord, blocks: Bools) -> Motion:
    """Return the motion, in these ``blocks`` (n,) less the even motion along their chords: the path then
    begins and ends at the chord's start, and is as far from it as the real path is from the chord's point of
    the same u."""
    start = tuple(np.broadcast_to(p, way.length.shape) for p in move.arm[:3])
    step = tuple(p - np.where(blocks, v, 0.0) for p, v in zip(move.arm_step[:3], way.vector, strict=True))
    return replace(move, arm=start + move.arm[3:], arm_step=step + move.arm_step[3:])


def node_poses(move: Motion, rows: Pose) -> Pose:
    """Return the poses at the nodes, by angle addition from those of the ``rows`` (n + 1) between the
    blocks."""
    arm = tuple(
        p if p.ndim == 0 else p + NODES * step for p, step in zip(move.arm, move.arm_step, strict=True)
    )
    cos_a, sin_a = _add_quarters(rows.cos_a[:-1], rows.sin_a[:-1], move.a_step)
    cos_b, sin_b = _add_quarters(rows.cos_b[:-1], rows.sin_b[:-1], move.b_step)
    return Pose(arm, cos_a, sin_a, cos_b, sin_b)


def _add_quarters(cos: Floats, sin: Floats, step: Floats) -> tuple[Floats, Floats]:
    quarter_cos, quarter_sin = np.cos(0.25 * step), np.sin(0.25 * step)
    cosines, sines = np.empty((3, len(step))), np.empty((3, len(step)))
    for node in range(3):
        cos, sin = turn_vector(cos, sin, quarter_cos, quarter_sin)
        cosines[node], sines[node] = cos, sin
    return cosines, sines


def bow(way: Chord, nodes: Floats, levers: Levers) -> Bow:
    """Return the largest distance from the chord of the paths through ``nodes``: components, nodes, blocks
    (3, 3, n), mm; from a chord that is a point, from its point of the same u."""
    full = _coefficients(way, nodes)
    along = [_dots(v, way.along) for v in full]
    a, b, c = (v - part * way.along for v, part in zip(full, along, strict=True))
    n0, *n = _square(a, b, c)
    h = _quintic(n0, *n)
    fall = -h[1] - (np.abs(h[2]) + 0.75 * np.abs(h[3]) + 0.5 * np.abs(h[4]) + 0.3125 * np.abs(h[5]))
    least_fall = STEEP * n0
    s, left = _root(h)
    factor = 0.25 - s * s
    distance = factor * _lengths(a + s * (b + s * c))
    short_of_peak = 0.25 * left * left / (np.maximum(fall, least_fall) + SMALLEST)
    bound = np.sqrt(distance * distance + short_of_peak) + REMAINDER * bending(levers, 5)
    close = bound - distance <= ABSOLUTE + RELATIVE * distance
    foot_inside = np.abs(along[0]) + 0.5 * np.abs(along[1]) + 0.25 * np.abs(along[2]) <= way.length
    proven = close & foot_inside & (fall > least_fall)
    most = 0.125 * bending(levers, 2)
    flat = np.flatnonzero(~proven & (most <= NOTHING))
    bound[flat] = np.maximum(most[flat], distance[flat])
    proven[flat] = True
    place = way.start + (s + 0.5) * way.vector + factor * (full[0] + s * (full[1] + s * full[2]))
    return Bow(distance, s + 0.5, bound, place, proven & (levers.turn <= MOST_TURN))


def _coefficients(way: Chord, nodes: Floats) -> tuple[Floats, Floats, Floats]:
    """Return a, B, C (3, n) of the bow through the nodes: g there is the way from the same-u point, over u (1
    - u)."""
    low, mid, high = (nodes[:, j] - (way.start + u * way.vector) for j, u in enumerate(NODES[:, 0].tolist()))
    return 4.0 * mid, (32.0 / 3.0) * (high - low), (128.0 / 3.0) * (low + high) - 64.0 * mid


def _dots(p: Floats, q: Floats) -> Floats:
    products = p * q
    return np.asarray(products[0] + products[1] + products[2])


def _lengths(p: Floats) -> Floats:
    return np.asarray(np.sqrt(_dots(p, p)))


def _square(a: Floats, b: Floats, c: Floats) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """Coefficients of ``N = |a + b s + c s^2|^2``, lowest first."""
    return _dots(a, a), 2.0 * _dots(a, b), _dots(b, b) + 2.0 * _dots(a, c), 2.0 * _dots(b, c), _dots(c, c)


def _quintic(n0: Floats, n1: Floats, n2: Floats, n3: Floats, n4: Floats) -> list[Floats]:
    """Coefficients of ``H = (1/4 - s^2) N' - 4 s N``, lowest first."""
    return [0.25 * n1, 0.5 * n2 - 4.0 * n0, 0.75 * n3 - 5.0 * n1, n4 - 6.0 * n2, -7.0 * n3, -8.0 * n4]


def _root(h: list[Floats]) -> tuple[Floats, Floats]:
    """s where H is nearly zero, by two steps of Newton's method from the middle of the block, and H there."""
    s = np.clip(h[0] / np.maximum(-h[1], SMALLEST), -0.4, 0.4)
    slope = h[1] + s * (2.0 * h[2] + s * (3.0 * h[3] + s * (4.0 * h[4] + s * (5.0 * h[5]))))
    s = np.clip(s - _value(h, s) / np.minimum(slope, -SMALLEST), -0.5, 0.5)
    return s, _value(h, s)


def _value(h: list[Floats], s: Floats) -> Floats:
    return h[0] + s * (h[1] + s * (h[2] + s * (h[3] + s * (h[4] + s * h[5]))))
