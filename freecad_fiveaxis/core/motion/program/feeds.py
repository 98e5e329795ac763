# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a block takes, so that the tip moves over the part at the programmed feed.

travel    the length of the tip's real path over the part in one block, mm, while all axes move linearly.
held back a block that takes longer than its feed asks for, because an axis would exceed its maximum rate.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import Chain, forward_tip

TRAVEL_ERROR = 1e-3
"""Relative error of a travel: a tenth of what the coarsest feed setting (1 %) can tell."""
EVEN = (math.sqrt(16.0 * TRAVEL_ERROR**2 + 32.0 / 3.0 * TRAVEL_ERROR) - 4.0 * TRAVEL_ERROR) * 3.0 / 16.0
"""A path that may leave its straight and even course by so much of its length is longer by TRAVEL_ERROR at
most."""
TURN_PER_PIECE = 0.05
"""Rotary travel (rad) of one piece of a sampled path: the near-cusp of So et al.'s Table 2 then errs by less
than 3e-6."""
WIDE = 0.5
"""Rotary travel (rad) above which nothing is said of the course without looking."""
BENT = 0.12
"""A path that may leave its chord by so much of its length is sampled in two pieces at least: one would err
by 5e-4 of a parabola."""
HOOKED, HOOK_PIECES = 0.25, 4.0
"""A path that may leave its chord by so much of its length may turn back on itself, however little the axes
turn: it is measured by so many parabolas at least. On 40 000 such blocks of a bumpy part they err by 4.3e-4
at most."""
STEEP = 1e-2
"""Where the square of a parabola's change of slope is below this share of that of its chord, three points of
Gauss tell its length to 1e-9."""
MOST_SAMPLES = 100_000
"""Pieces that are sampled at a time: bounds the memory, whatever the number of turns."""
STILL = 1e-4
"""A travel below this (mm) is rounding of the words: the block only turns about the tip."""
ASSUMED_RATE = (10_000.0, 10_000.0, 10_000.0, 20.0 * np.pi, 20.0 * np.pi)
"""Where a machine states no maximum rate: mm/min and rad/min (10 turns a minute) for rapids and for turns
about the tip."""


def tip_travel(kinematics: Chain, q: Floats, wanted: Bools) -> Floats:
    """Travel (m - 1,) mm of the tip from each row of ``q`` (m, 5) mm and rad to the next; the chord where not
    ``wanted``.

    The chord where that is near enough by proof. With ``max|p''|`` at most 8 e chords the velocity leaves the
    chord by r(u), of mean 0, at most 4 e long, and with a mean square of at most (8 e)^2 / 12, that of a
    straight line (no function as steep has more). So the arc is at most 1 + (8 / 3) e^2 / (1 - 4 e) chords
    long.

    ``|p''| <= w^2 r + 2 w (|p'| + s)``, w the rotary travel, r the lever arm: what is turned by ``W`` and
    moves straight beneath it has ``p'' = 2 W p' - W^2 p``. s is the linear travel where the linear axes stand
    on several sides of a rotary one, else 0: on one side none of it is hidden. With ``|p'|`` at most a chord
    and half of ``max|p''|`` the latter is at most ``(w^2 r + 2 w (chord + s)) / (1 - w)``. Elsewhere the
    sampled path, extrapolated (Richardson), or parabolas through it.
    """
    tip, travel, curved, pieces = forward_tip(kinematics, q), np.empty(max(len(q) - 1, 0)), [], []
    for rows in chunks(len(travel)):
        ends = slice(rows.start, rows.stop + 1)
        chord, turned, bend = _chords(kinematics, q[ends], tip[ends])
        at = np.flatnonzero(wanted[rows] & (bend > EVEN * chord))
        travel[rows] = chord
        curved.append(rows.start + at)
        least = np.where(
            bend[at] > HOOKED * chord[at], HOOK_PIECES, np.where(bend[at] > BENT * chord[at], 2.0, 1.0)
        )
        pieces.append(np.ceil(np.log2(np.maximum(turned[at] / TURN_PER_PIECE, least))).astype(np.int64))
    _measure_curved(
        kinematics, q, tip, travel, np.concatenate([*curved, _NONE]), 2 ** np.concatenate([*pieces, _NONE])
    )
    return travel


_NONE = np.empty(0, np.int64)


def _chords(kinematics: Chain, q: Floats, tip: Floats) -> tuple[Floats, Floats, Floats]:
    """Chord (m,) mm and rotary travel (m,) rad of each block, and how far (mm) its tip may be off a straight
    and even course."""
    first, second = np.abs(np.diff(q[:, 3])), np.abs(np.diff(q[:, 4]))
    turned, chord = first + second, _length(np.diff(tip, axis=0).T)
    most = (
        chord
        if len(set(kinematics.slot)) == 1
        else chord + _travel_factor(kinematics) * _length(np.diff(q[:, :3], axis=0).T)
    )
    bend = turned * (turned * _lever_arms(kinematics, q) + 2.0 * most)
    bend /= 8.0 * (1.0 - np.minimum(turned, WIDE))
    bend[np.flatnonzero(turned > WIDE)] = np.inf
    return chord, turned, bend


def _measure_curved(
    kinematics: Chain, q: Floats, tip: Floats, travel: Floats, curved: Ints, pieces: Ints
) -> None:
    """Put the lengths of the sampled paths of the blocks ``curved`` into ``travel``."""
    for count in np.unique(pieces).tolist():
        alike = curved[pieces == count]
        portion = max(1, MOST_SAMPLES // count)
        for first in range(0, len(alike), portion):
            rows = alike[first : first + portion]
            words, place = ([table.T.take(rows + end, axis=1) for end in (0, 1)] for table in (q, tip))
            travel[rows] = _sample_length(kinematics, words, place, count)


def _length(vector: Floats) -> Floats:
    """Lengths of vectors by columns, (3 or more, ...): of the first three."""
    length: Floats = vector[0] * vector[0]
    length += vector[1] * vector[1]
    length += vector[2] * vector[2]
    return np.sqrt(length, out=length)


def _lever_arms(kinematics: Chain, q: Floats) -> Floats:
    """Return an upper bound, for each block (m - 1,), of the distance from either rotary line to what it
    turns, mm: that at its farther end, because the linear words go straight."""
    between = float(np.linalg.norm(kinematics.point2 - kinematics.point1)) + float(
        np.linalg.norm(kinematics.point2)
    )
    arm = _length(q.T)
    arm *= _travel_factor(kinematics)
    arm += between
    return np.maximum(arm[1:], arm[:-1])


def _travel_factor(kinematics: Chain) -> float:
    """How much farther than X Y Z tell all linear axes go at most, those on either side of a rotary one added
    up."""
    linear = np.abs(kinematics.direction[:3])
    return math.sqrt(len(set(kinematics.slot)) * float(linear.sum(axis=0).max() * linear.sum(axis=1).max()))


def _sample_length(kinematics: Chain, words: list[Floats], tip: list[Floats], pieces: int) -> Floats:
    """Length of the path sampled at both ends and in the middle of that many pieces; ``words`` [(5, m), (5,
    m)] and ``tip`` [(3, m), (3, m)] at both ends of the whole."""
    start, end = words
    u = np.arange(1, 2 * pieces)[:, None] / (2.0 * pieces)
    between = start[:, None] + u * (end - start)[:, None]
    inner = forward_tip(kinematics, between.reshape(5, -1).T).T.reshape(3, *between.shape[1:])
    path = np.concatenate([tip[0][:, None], inner, tip[1][:, None]], axis=1)
    return _by_parabolas(path) if pieces >= HOOK_PIECES else _extrapolate_length(path)


def _extrapolate_length(path: Floats) -> Floats:
    """Return the length of the chords between all points (3, 2 k + 1, m), corrected by that between every
    other one."""
    fine: Floats = _length(np.diff(path, axis=1)).sum(axis=0)
    coarse: Floats = _length(np.diff(path[:, ::2], axis=1)).sum(axis=0)
    length: Floats = fine + (fine - coarse) / 3.0
    return length


def _by_parabolas(path: Floats) -> Floats:
    """Return the length of the parabolas through each three of the points (3, 2 k + 1, m); a cusp is one of
    them.

    With chord c and sag s of the middle the course is ``c + 4 v s``, v from -1 to 1, and ``|c + 4 v s|^2 = a
    v^2 + b v + g``.
    """
    chord = path[:, 2::2] - path[:, :-1:2]
    sag = path[:, 1::2] - 0.5 * (path[:, 2::2] + path[:, :-1:2])
    a, b, g = 16.0 * (sag * sag).sum(axis=0), 8.0 * (chord * sag).sum(axis=0), (chord * chord).sum(axis=0)
    arc: Floats = sum(weight * np.sqrt(np.maximum((a * v + b) * v + g, 0.0)) for v, weight in _GAUSS)
    steep = np.nonzero(a > STEEP * g)
    arc[steep] = _parabola(a[steep], b[steep], g[steep])
    return np.asarray(arc.sum(axis=0))


_GAUSS = ((-math.sqrt(0.6), 5.0 / 18.0), (0.0, 8.0 / 18.0), (math.sqrt(0.6), 5.0 / 18.0))


def _parabola(a: Floats, b: Floats, g: Floats) -> Floats:
    """Half the integral of ``sqrt(a v^2 + b v + g)`` from -1 to 1, a above 0: that of ``sqrt(w^2 + d^2)``
    times sqrt(a)."""
    middle = b / (2.0 * a)
    square = np.maximum(g / a - middle * middle, 0.0)
    deep = np.sqrt(np.maximum(square, np.finfo(float).tiny))

    def half(w: Floats) -> Floats:
        return np.asarray(w * np.sqrt(w * w + square) + square * np.arcsinh(w / deep))

    return np.asarray(0.25 * np.sqrt(a) * (half(middle + 1.0) - half(middle - 1.0)))


def rapid_minutes(kinematics: Chain, change: Floats) -> Floats:
    """Time (n,) of a rapid: all axes together, the slowest at its maximum rate. ``change`` (n, 5) mm and
    rad."""
    rate = np.where(np.isfinite(kinematics.rate), kinematics.rate, ASSUMED_RATE)
    return least_minutes(rate, change)


def least_minutes(rate: Floats, change: Floats) -> Floats:
    """Return the shortest time (n,) in which no axis exceeds its ``rate`` (5,); ``change`` (n, 5) in the same
    units."""
    least: Floats = np.abs(change[:, 0]) / rate[0]
    for k in range(1, 5):
        np.maximum(least, np.abs(change[:, k]) / rate[k], out=least)
    return least


def feed_minutes(kinematics: Chain, change: Floats, travel: Floats, feed: Floats) -> tuple[Floats, Bools]:
    """Time (n,) of feed blocks and which of them are held back.

    ``change`` (n, 5) mm and rad, ``travel`` (n,) mm, ``feed`` (n,) mm/min above 0. A block that only turns
    about the tip has no travel to time it: it turns as fast as its rotary axes may.
    """
    minutes = travel / feed
    least = least_minutes(kinematics.rate, change)
    still: Ints = np.flatnonzero(travel < STILL)
    least[still] = np.maximum(least[still], rapid_minutes(kinematics, change[still]))
    held: Bools = least > minutes * (1.0 + TRAVEL_ERROR)
    held[still] = False
    return np.maximum(minutes, least), held
