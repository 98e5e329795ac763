# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the real tool axis leaves the plane of a block's two end axes.

plane     spanned by the tool axes at both ends: a controller that swings the axis straight from one to the
          other stays in it. Where the end axes coincide or are opposite there is no such plane, and the angle
          from the start axis counts.
swing     the largest angle off that plane (or axis) within the block, rad. It has no proof; the samples lie
          close enough for every maximum, and Newton's method polishes the largest.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.vectors import dot
from freecad_fiveaxis.core.motion.trajectory import (
    Frames,
    Motion,
    Vectors,
    at,
    axis,
    axis_motion,
    derivatives,
)

from .quartic import SMALLEST

COINCIDENT = 1e-12
"""Sine of the angle of two axes that span no plane: what rounding leaves of it is then no direction."""

SAMPLE_TURN = 0.1
"""rad of summed rotary travel between samples; the swing's shortest wave is a whole turn."""

FEWEST_SAMPLES = 16
POLISH = 3
"""Steps of Newton's method from a sample next to the maximum: its error is squared in each."""

CELLS = 65536
"""Samples worked on at a time."""


def _normal(start: Vectors, end: Vectors) -> tuple[Vectors, Bools]:
    """Return the unit normal of the plane of both axes; the start axis where there is none, and where that is
    so."""
    x, y, z = start
    n = (y * end[2] - z * end[1], z * end[0] - x * end[2], x * end[1] - y * end[0])
    sine = np.sqrt(dot(n, n))
    none = sine <= COINCIDENT
    scale = 1.0 / (sine + SMALLEST)
    normal = (n[0] * scale, n[1] * scale, n[2] * scale)
    if none.any():
        for column, other in zip(normal, start, strict=True):
            np.copyto(column, other, where=none)
    return normal, none


def small_swing(start: Vectors, end: Vectors, nodes: Vectors) -> Floats:
    """Return the swing (n,) rad of blocks that turn little, from the axes at both ends and at the nodes,
    columns (3, n).

    The sine is ``u (1 - u)`` times a parabola through the nodes, like the bow of the tip's path.
    """
    normal, none = _normal(start, end)
    low, mid, high = dot(nodes, normal)
    a, b, c = 4.0 * mid, (32.0 / 3.0) * (high - low), (128.0 / 3.0) * (low + high) - 64.0 * mid
    bent = 2.0 * a - 0.5 * c
    s = np.clip(0.25 * b / (bent + SMALLEST), -0.25, 0.25)  # an S has its peaks out there
    b3, c4 = 3.0 * b, 4.0 * c
    slope = 0.25 * b - s * (bent + s * (b3 + s * c4))
    s = np.clip(s + slope / (bent + s * (2.0 * b3 + 3.0 * s * c4) + SMALLEST), -0.5, 0.5)
    sine = np.abs((0.25 - s * s) * (a + s * (b + s * c)))
    sine = np.maximum(np.maximum(np.abs(mid), sine), np.maximum(np.abs(low), np.abs(high)))
    swing = np.arcsin(np.minimum(sine, 1.0))
    alone = np.flatnonzero(none)
    swing[alone] = _angle(_some(start, alone), _some(nodes, alone)).max(axis=0)
    return np.asarray(swing)


def _some(vector: Vectors, rows: Ints) -> Vectors:
    x, y, z = (column[..., rows] for column in vector)
    return x, y, z


def swing(frame: Frames, move: Motion) -> Floats:
    """Return the swing (n,) rad of blocks that turn by any amount, from samples and Newton's method."""
    turn = np.abs(move.a_step) + np.abs(move.b_step)
    doublings = np.ceil(np.log2(np.maximum(turn / (SAMPLE_TURN * FEWEST_SAMPLES), 1.0))).astype(np.int64)
    result = np.empty(len(turn))
    for doubling in np.unique(doublings).tolist():
        samples = FEWEST_SAMPLES << doubling
        rows = np.flatnonzero(doublings == doubling)
        for part in np.array_split(rows, -(-len(rows) * samples // CELLS)):
            result[part] = _sample_swing(frame, move.take(part), samples)
    return result


def _sample_swing(frame: Frames, move: Motion, samples: int) -> Floats:
    start, end = (axis(frame, at(move, np.full_like(move.a, u))) for u in (0.0, 1.0))
    normal, none = _normal(start, end)
    u = np.arange(1, samples)[:, None] / samples
    height = dot(axis(frame, at(move, u)), normal)
    best = np.argmax(np.where(none, -height, np.abs(height)), axis=0)
    best_u = u[best, 0]
    peak = _polish_peaks(frame, move, normal, best_u, 1.0 / samples)
    swings = []
    for at_u in (best_u, peak):
        k = axis(frame, at(move, at_u))
        swings.append(np.where(none, _angle(start, k), np.arcsin(np.minimum(np.abs(dot(k, normal)), 1.0))))
    return np.maximum(swings[0], swings[1])


def _polish_peaks(frame: Frames, move: Motion, normal: Vectors, u: Floats, reach: float) -> Floats:
    """u nearby where the axis is level with ``normal``'s plane for a moment, by Newton's method."""
    spin, low, high = axis_motion(frame, move), np.maximum(u - reach, 0.0), np.minimum(u + reach, 1.0)
    for _ in range(POLISH):
        _, first, second = derivatives(frame, spin, u)
        slope, curve = dot(first, normal), dot(second, normal)
        u = np.clip(u - slope / np.where(curve == 0.0, 1.0, curve), low, high)
    return u


def _angle(start: Vectors, k: Vectors) -> Floats:
    """Return the angle between two unit vectors, rad, exact for small ones."""
    x, y, z = (q - p for p, q in zip(start, k, strict=True))
    return np.asarray(2.0 * np.arcsin(np.minimum(0.5 * np.sqrt(x * x + y * y + z * z), 1.0)))
