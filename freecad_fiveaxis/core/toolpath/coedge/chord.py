# SPDX-License-Identifier: LGPL-2.1-or-later
"""The chords of an offset polyline, one by one, with their lines and planes.

chord      a straight piece of an offset polyline: the offset of a facet segment, or one of the k + 1 pieces
           of an arc. Each lies in a plane of its own: the offset plane of the facet, or a plane that touches
           the ball about the arc's contact.
ghost      a piece of an arc about the end of an open polyline, a quarter turn away from the part. The tool
           does not go there; it keeps the ball off the border when the segment at the border is used up.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, run_ids
from freecad_fiveaxis.core.base.vectors import dot

from .junction import CONCAVE, CONVEX, END, Junctions, Segments, arc_weights, direction

SPREAD = np.uint64(0x9E3779B97F4A7C15)
"""Multiplier that spreads row numbers (golden ratio), so that ties do not fall in order of the path."""


@dataclass(eq=False)
class Chords:
    """Chords in the order of the path; ``low`` to ``high`` (c,) mm is the chord on its line ``origin`` + t
    ``along`` (3, c).

    ``normal`` (3, c) of its plane; ``at`` (c,) its position among the live segments; ``real`` False for the
    pieces of an arc, which stand at ``angle`` (c,) from the normal of the segment; ``final`` True for the
    last piece of an arc between two segments; ``ghost``. ``before`` and ``after`` (c,) its neighbours, -1 for
    none; ``crosses`` True where it is trimmed against the one after it; ``start`` and ``stop`` (c,) what the
    trims leave of it; ``alive``; ``heir`` the chord before it when it was dropped (itself till then);
    ``stuck`` True where it should have been dropped and was not; ``tie`` decides between equals; ``next`` the
    chord after it before any was dropped. ``radius`` mm of the ball.
    """

    origin: Floats
    along: Floats
    normal: Floats
    low: Floats
    high: Floats
    at: Ints
    real: Bools
    angle: Floats
    final: Bools
    ghost: Bools
    before: Ints
    after: Ints
    crosses: Bools
    start: Floats
    stop: Floats
    alive: Bools
    heir: Ints
    stuck: Bools
    tie: Ints
    next: Ints
    radius: float


def make_chords(segments: Segments, junctions: Junctions, at: Ints, radius: float, quarter: int) -> Chords:
    """All chords: of each segment a ghost arc before it (open beginnings), its own, and the arc after it
    (convex, open ends)."""
    kind, first = junctions.kind[at], np.diff(segments.line[at], prepend=-1) != 0
    opened = first & (junctions.kind[segments.last[segments.line[at]]] == END)
    ahead = np.where(opened, quarter + 1, 0)
    behind = np.where(kind == CONVEX, junctions.arcs[at] + 1, np.where(kind == END, quarter + 1, 0))
    count = ahead + 1 + behind
    head = np.cumsum(count) - count
    owner = run_ids(count)
    where = at.take(owner)
    step = np.arange(len(where)) - (head + ahead).take(
        owner
    )  # 0: the segment itself; else the pieces of its arcs
    arcs = np.where((step > 0) & (junctions.kind[where] == CONVEX), junctions.arcs[where], quarter)
    piece = np.where(step > 0, step - 1, step + quarter + 1)  # 0 to k
    real, ghost = step == 0, (step < 0) | ((step > 0) & (junctions.kind[where] == END))
    theta = np.where(ghost, np.pi, junctions.theta(where))
    delta = np.where(ghost, 0.5 * np.pi, theta) / arcs
    angle = np.where(real, 0.0, np.where(step < 0, piece - quarter, piece) * delta)
    origin, normal, along = _frames(segments, where, step, theta, angle)
    reach = radius * np.tan(0.5 * delta)
    low = np.where(real | (piece == 0), 0.0, -reach)
    high = np.where(real, segments.length[segments.live[where]], np.where(piece == arcs, 0.0, reach))
    before, after = _neighbours(segments, at, head, count)
    crosses, final = real & (junctions.kind[where] == CONCAVE), ~real & ~ghost & (piece == arcs)
    row = np.arange(len(where))
    start = np.flatnonzero(np.diff(segments.line[where], prepend=-1))
    tie = ((row - np.repeat(start, np.diff(start, append=len(row)))).astype(np.uint64) * SPREAD).astype(
        np.int64
    )
    return Chords(
        origin + radius * normal, along, normal, low, high, where, real, angle, final, ghost, before, after,
        crosses,
        low.copy(), high.copy(), np.ones(len(row), bool), row, np.zeros(len(row), bool), tie,
        after.copy(), radius,
    )  # fmt: skip


def _frames(
    segments: Segments, where: Ints, step: Ints, theta: Floats, angle: Floats
) -> tuple[Floats, Floats, Floats]:
    """Contact, normal and direction of each chord, (3, c) each."""
    segment, nxt = segments.live[where], segments.following[where]
    along, normal = direction(segments, segment), segments.normal.take(2 * segment, axis=1)
    origin = segments.point.take(2 * segment + (step > 0), axis=1)
    arc = np.flatnonzero(step)
    far = segments.normal.take(2 * segments.live[np.where(nxt < 0, where, nxt)[arc]], axis=1)
    one, two = normal.take(arc, axis=1), along.take(arc, axis=1)
    normal[:, arc] = _mix(arc_weights(theta[arc], angle[arc]), one, far, two)
    along[:, arc] = _mix(
        arc_weights(theta[arc], angle[arc] + 0.5 * np.pi), one, far, two
    )  # the normal turns that way
    return origin, normal, along


def _mix(weights: tuple[Floats, Floats, Floats], one: Floats, far: Floats, travel: Floats) -> Floats:
    return np.asarray(weights[0] * one + weights[1] * far + weights[2] * travel)


def _neighbours(segments: Segments, at: Ints, head: Ints, count: Ints) -> tuple[Ints, Ints]:
    """Return the chords before and after each chord, round the seam of a closed polyline, -1 beyond an open
    end."""
    n = int(count.sum())
    before, after = np.arange(-1, n - 1), np.arange(1, n + 1)
    place = np.full(len(segments.live), -1)
    place[at] = head
    tail = head + count - 1
    nxt = segments.following[at]
    after[tail] = np.where(nxt < 0, -1, place[nxt])
    before[head] = -1
    joined = nxt >= 0
    before[after[tail[joined]]] = tail[joined]
    return before, after


def place_on(chords: Chords, chord: Ints, t: Floats) -> Floats:
    """Find the places (3, c) ``t`` (c,) mm along chords, mm."""
    return np.asarray(chords.origin.take(chord, axis=1) + t * chords.along.take(chord, axis=1))


def height_above(chords: Chords, chord: Ints, place: Floats) -> Floats:
    """Height (c,) of ``place`` (3, c) above the planes of chords, mm."""
    return dot(chords.normal.take(chord, axis=1), place - chords.origin.take(chord, axis=1))


def drop_chords(chords: Chords, gone: Ints) -> Ints:
    """Take chords out; returns the chords that must now be trimmed against the one after them.

    Beyond an open end nothing remains to trim against: the neighbour keeps the trim that the dropped chord
    gave it.
    """
    before, after = chords.before[gone], chords.after[gone]
    chords.alive[gone] = False
    chords.heir[gone] = np.where(before >= 0, before, np.where(after >= 0, after, gone))
    chords.after[before[before >= 0]] = after[before >= 0]
    chords.before[after[after >= 0]] = before[after >= 0]
    fresh = before[(before >= 0) & (after >= 0)]
    alone = fresh[chords.after[fresh] == fresh]  # a ring of one chord is no path
    chords.alive[alone] = False
    chords.crosses[fresh] = True
    return np.asarray(fresh)
