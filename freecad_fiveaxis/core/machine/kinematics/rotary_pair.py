# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two rotary axes: from a tool axis to the angles that take it up, exactly at the pole and next to it too.

pole     the tool axis parallel to the first rotary axis: the angle of the first is then free, and taken as 0.
branch   0 where the second angle lies on the positive side of its position at the pole (or nearest to it), 1
         on the other.
measure  of singularity, ``|a1 . (a2 x k)|``: how fast the tool axis k can leave, 0 at the pole, the sine of
         the tilt for orthogonal axes.

Let a1 and a2 be the directions of the axes, the one nearer to the work first, p be a1 or -a1, whichever the
tool comes nearer to, and n, t, p a right-handed frame with a2 in its (n, p) plane at the angle g from p; b is
the angle between a2 and the tool with both angles zero, ez. The second axis turns the tool on a cone,

    R2 ez = (cos b sin g - sin b cos g cos d) n - sin b sin d t + (cos b cos g + sin b sin g cos d) p

where ``d = q2 - best`` counts from the position next to the pole. The p part gives cos d, hence both branches
+d and -d; q1 is the angle about a1 from that vector to the axis wanted. d is taken from its half, and the n
and t parts without the factor sin(d/2) that they share, so that nothing cancels next to the pole. On most
machines g = b = 90 deg, and d is just the angle between p and the axis.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.columns import (
    TINY,
    Column,
    Matrix,
    Turn,
    clean,
    dot,
    map_vectors,
    plus,
    split,
    times,
)
from freecad_fiveaxis.core.base.records import Floats

BEYOND = 1e-12
"""An axis that far outside the cone of reach (as a cosine) is taken for one on its rim; further out it is
unreachable."""

AT_POLE = 1e-140
"""An axis nearer to the pole than this (rad) is at the pole: the squares of its components would
underflow."""

Turns = tuple[Floats, Floats, Floats, Floats]
"""cos q1, sin q1, cos q2, sin q2, each (m,)."""

Pose = tuple[tuple[Floats, Floats], Turns]
"""(q1, q2) rad, and their cosines and sines."""

_Half = tuple[Floats, Floats]
"""sin(d/2), cos(d/2)."""


@dataclass(frozen=True)
class RotaryPair:
    """What the formulas need of two directions. Symbols as at the head of the module.

    ``sign`` +1 where p = a1, -1 where p = -a1; ``frame`` rows n, t, p; ``reach`` = sin b sin g; ``near`` =
    cos(g - b) - 1; ``far`` = cos(g + b); ``aside`` = sin(g - b) / (2 sin b), 0 where the pole is in reach;
    ``straight`` where g = b = 90 deg.
    """

    turn1: Turn
    turn2: Turn
    sign: float
    frame: Matrix
    best: float
    cos_best: float
    sin_best: float
    cos_g: float
    reach: float
    near: float
    far: float
    aside: float
    straight: bool

    @staticmethod
    def of(a1: Floats, a2: Floats) -> RotaryPair:
        """Return the pair with unit directions ``a1``, ``a2`` (3,); they must not be parallel, nor a2
        parallel to ez."""
        cos_b, towards = _clean_value(float(a2[2])), _clean_value(float(a1 @ a2) * float(a2[2]))
        sign = -1.0 if towards < 0.0 or (towards == 0.0 and a1[2] < -TINY) else 1.0
        p = sign * a1
        cos_g = _clean_value(float(p @ a2))
        sin_g, sin_b = float(np.linalg.norm(np.cross(p, a2))), float(np.hypot(a2[0], a2[1]))
        n = clean(np.asarray((a2 - cos_g * p) / sin_g, float))
        e = sin_g * p - cos_g * n  # across a2, towards the pole
        cos_best, sin_best = _clean_value(e[2] / sin_b), _clean_value((a2[1] * e[0] - a2[0] * e[1]) / sin_b)
        reach = sin_b * sin_g
        return RotaryPair(
            turn1=Turn.about(a1),
            turn2=Turn.about(a2),
            sign=sign,
            frame=[n.tolist(), clean(np.cross(p, n)).tolist(), p.tolist()],
            best=float(np.arctan2(sin_best, cos_best)),
            cos_best=cos_best,
            sin_best=sin_best,
            cos_g=cos_g,
            reach=reach,
            near=_clean_value(cos_g * cos_b + reach - 1.0),
            far=_clean_value(cos_g * cos_b - reach),
            aside=_clean_value(sin_g * cos_b - cos_g * sin_b) / (2.0 * sin_b),
            straight=cos_g == 0.0 and cos_b == 0.0,
        )


def _clean_value(value: float) -> float:
    return 0.0 if abs(value) < TINY else float(value)


def poses(k: RotaryPair, axis: Floats) -> tuple[Floats, list[Pose]]:
    """Return the singularity measure (m,), and the pose of each branch, for axes (m, 3)."""
    with np.errstate(invalid="ignore", divide="ignore"):
        x, y, z = split(axis)
        length = np.sqrt(x * x + y * y + z * z)
        n, t, p = (
            np.asarray(column) for column in map_vectors(k.frame, (x / length, y / length, z / length))
        )
        across = np.sqrt(n * n + t * t)
        if k.straight:
            half, delta, cos, sin = None, np.arctan2(across, p), p, across
        else:
            half, delta, cos, sin = _half_tilt(k, p, across)
        branches: list[Pose] = []
        for way in (1.0, -1.0):
            q1, cos1, sin1 = _first(k, n, t, across, *_standing(k, way, half))
            cos2 = np.asarray(dot((k.cos_best, -way * k.sin_best), (cos, sin)))
            sin2 = np.asarray(dot((k.sin_best, way * k.cos_best), (cos, sin)))
            branches.append(((q1, _half_open(np.asarray(k.best + way * delta))), (cos1, sin1, cos2, sin2)))
    return k.reach * sin, branches


def _half_tilt(k: RotaryPair, p: Floats, across: Floats) -> tuple[_Half, Floats, Floats, Floats]:
    """Return the half angle, then d, cos d and sin d; NaN beyond the reach."""
    one_less_p = 0.5 * (
        across * across + (1.0 - p) * (1.0 - p)
    )  # 1 - p of a unit vector, without cancellation
    squares = (k.near + one_less_p) / (2.0 * k.reach), (p - k.far) / (2.0 * k.reach)
    sin, cos = (np.sqrt(np.where(square < -BEYOND, np.nan, np.maximum(square, 0.0))) for square in squares)
    cos = cos + 0.0 * sin  # NaN in either is NaN in both
    return (sin, cos), 2.0 * np.arctan2(sin, cos), cos * cos - sin * sin, 2.0 * sin * cos


def _standing(k: RotaryPair, way: float, half: _Half | None) -> tuple[Column, Column]:
    """Return the n and t parts of R2 ez on the branch d = way |d|, divided by what they have in common and
    vanishes at the pole."""
    if half is None:
        return 0.0, -way
    sin, cos = half
    if k.aside == 0.0:
        return k.cos_g * sin, -way * cos
    return k.aside + k.cos_g * sin * sin, -way * sin * cos


def _first(
    k: RotaryPair, n: Floats, t: Floats, across: Floats, from_n: Column, from_t: Column
) -> tuple[Floats, Floats, Floats]:
    """q1, its cosine and its sine: the turn about a1 from (from_n, from_t) to (n, t)."""
    along = np.asarray(plus(times(n, from_n), times(t, from_t)))
    aside = (
        np.asarray(plus(times(t, k.sign * from_n), times(n, -k.sign * from_t))) + 0.0
    )  # -0 would turn pi into -pi
    length = across if k.straight else np.sqrt(along * along + aside * aside)
    q1, cos, sin = np.arctan2(aside, along), along / length, aside / length
    pole = np.flatnonzero(across < AT_POLE)
    if pole.size:
        q1[pole], cos[pole], sin[pole] = 0.0, 1.0, 0.0
    return q1, cos, sin


def _half_open(angle: Floats) -> Floats:
    """Return an angle of less than a turn and a half brought into (-pi, pi]; changes it in place."""
    angle[np.flatnonzero(angle <= -np.pi)] += 2.0 * np.pi
    angle[np.flatnonzero(angle > np.pi)] -= 2.0 * np.pi
    return angle
