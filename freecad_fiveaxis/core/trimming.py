# SPDX-License-Identifier: LGPL-2.1-or-later
"""Offset polylines where the trims of concave junctions use up whole segments.

chord      a straight piece of an offset polyline: the offset of a facet segment, or one of the k + 1 pieces of an arc. Each
           lies in a plane of its own: the offset plane of the facet, or a plane that touches the ball about the arc's contact.
crossing   where the line of one chord meets the plane of the other, both ways; both points lie on the line in which the two
           planes cross, so the path between them keeps off both facets.
used up    a chord whose trims from its two ends overlap. It is dropped and its neighbours are trimmed against each other:
           the ball never touches what lay under it, because it already touches both sides.

Of neighbouring used-up chords the one that a smaller ball would use up first is dropped first, as the offset of a polygon
shrinks; all that do not disturb each other are dropped in one round.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from .junction import CONCAVE, CONVEX, FLAT, FLAT_GAP, GRAZING, SAME, Junctions, Rows, Segments, arc_weights, direction, dot
from .records import Bools, Floats, Ints

ROUNDS = 1000
"""A run of used-up chords is halved in most rounds; only one that tightens steadily needs a round for each chord."""

SPREAD = np.uint64(0x9E3779B97F4A7C15)
"""Multiplier that spreads row numbers (golden ratio), so that ties do not fall in order of the path."""


class Trimmed(NamedTuple):
    """``rows`` of the offset path in short form, each of polyline ``line``; segments that the ball may ``cut_into`` and
    ``depth`` mm, above 0 where it does; segments that it does not reach, ``missed``, and ``height`` mm by which it stays off.
    """

    rows: Rows
    line: Ints
    cut_into: Ints
    depth: Floats
    missed: Ints
    height: Floats


@dataclass(eq=False)
class _Chords:
    """Chords in the order of the path; ``low`` to ``high`` (c,) mm is the chord on its line ``origin`` + t ``along`` (3, c).

    ``normal`` (3, c) of its plane; ``at`` (c,) its position among the live segments; ``real`` False for the pieces of an arc,
    which stand at ``angle`` (c,) from the normal of the segment; ``final`` True for the last piece of an arc. ``before`` and
    ``after`` (c,) its neighbours, -1 for none; ``crosses`` True where it is trimmed against the one after it; ``start`` and
    ``stop`` (c,) what the trims leave of it; ``alive``; ``heir`` the chord before it when it was dropped (itself till then);
    ``stuck`` True where it should have been dropped and was not; ``tie`` decides between equals. ``radius`` mm of the ball.
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
    before: Ints
    after: Ints
    crosses: Bools
    start: Floats
    stop: Floats
    alive: Bools
    heir: Ints
    stuck: Bools
    tie: Ints
    radius: float


def find_used_up(segments: Segments, junctions: Junctions) -> Ints:
    """Polylines in which the trims of some segment overlap."""
    start = np.zeros(len(segments.live))
    follows = segments.following >= 0
    start[segments.following[follows]] = junctions.trim_start[follows]
    overlap = np.flatnonzero(start - junctions.trim_end > segments.length[segments.live])
    return np.unique(segments.line[overlap])


def trim_polylines(segments: Segments, junctions: Junctions, at: Ints, radius: float) -> Trimmed:
    """The offset of whole polylines, ``at`` (m,) their positions in order: trimmed until no chord is used up."""
    chords = _chords(segments, junctions, at, radius)
    _drop_used_up(chords)
    rows, line = _rows(chords, segments, junctions)
    return Trimmed(rows, line, *_what_is_left(chords, segments))


def _chords(segments: Segments, junctions: Junctions, at: Ints, radius: float) -> _Chords:
    convex = junctions.kind[at] == CONVEX
    count = np.where(convex, junctions.arcs[at] + 2, 1)
    head = np.cumsum(count) - count
    where = np.repeat(at, count)
    step = np.arange(len(where)) - np.repeat(head, count) - 1  # -1: the segment itself; 0 to k: the pieces of its arc
    real, arcs, theta = step < 0, junctions.arcs[where], junctions.theta[where]
    segment = segments.live[where]
    travel, normal = direction(segments, segment), segments.normal.take(2 * segment, axis=1)
    origin, high = segments.point.take(2 * segment, axis=1), segments.length[segment]
    low, angle = np.zeros(len(where)), np.zeros(len(where))
    arc = np.flatnonzero(~real)
    origin[:, arc] = segments.point.take(2 * segment[arc] + 1, axis=1)
    delta = theta[arc] / arcs[arc]
    angle[arc] = step[arc] * delta
    far = segments.normal.take(2 * segments.live[segments.following[where[arc]]], axis=1)
    one, two = normal[:, arc], travel[:, arc]
    normal[:, arc] = _mixed(arc_weights(theta[arc], angle[arc]), one, far, two)
    travel[:, arc] = _mixed(_slope(theta[arc], angle[arc]), one, far, two)
    reach = radius * np.tan(0.5 * delta)
    low[arc], high[arc] = np.where(step[arc] > 0, -reach, 0.0), np.where(step[arc] < arcs[arc], reach, 0.0)
    final = ~real & (step == arcs)
    start = np.flatnonzero(np.diff(segments.line[where], prepend=-1))
    tie = np.arange(len(where)) - np.repeat(start, np.diff(start, append=len(where)))
    tie = (tie.astype(np.uint64) * SPREAD).astype(np.int64)
    before, after = _neighbours(segments, at, head, count)
    crosses = real & (junctions.kind[where] == CONCAVE)
    return _Chords(
        origin + radius * normal, travel, normal, low, high, where, real, angle, final, before, after, crosses, low.copy(),
        high.copy(), np.ones(len(where), bool), np.arange(len(where)), np.zeros(len(where), bool), tie, radius,
    )  # fmt: skip


def _mixed(weights: tuple[Floats, Floats, Floats], one: Floats, far: Floats, travel: Floats) -> Floats:
    return np.asarray(weights[0] * one + weights[1] * far + weights[2] * travel)


def _slope(theta: Floats, angle: Floats) -> tuple[Floats, Floats, Floats]:
    """Weights of the direction in which the normal at ``angle`` turns: those of the normal a quarter turn further."""
    return arc_weights(theta, angle + 0.5 * np.pi)


def _neighbours(segments: Segments, at: Ints, head: Ints, count: Ints) -> tuple[Ints, Ints]:
    """The chords before and after each chord, round the seam of a closed polyline, -1 beyond an open end."""
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


def _drop_used_up(chords: _Chords) -> None:
    """Drop used-up chords, in rounds, until there are none; marks those that are left after all rounds as ``stuck``."""
    fresh, waiting = np.flatnonzero(chords.crosses & (chords.after >= 0)), np.empty(0, np.int64)
    for _ in range(ROUNDS):
        fresh = fresh[chords.alive[fresh]]
        _cross(chords, fresh)
        touched = np.unique(np.concatenate([fresh, chords.after[fresh], waiting]))
        used = touched[chords.alive[touched] & (chords.start[touched] - chords.stop[touched] > SAME)]
        if not len(used):
            return
        fresh, waiting = _drop(chords, _first_to_go(chords, used)), used
    chords.stuck[used] = True
    chords.start[used], chords.stop[used] = chords.low[used], chords.high[used]


def _cross(chords: _Chords, one: Ints) -> None:
    """Trim chords ``one`` and the chords after them against each other."""
    two = chords.after[one]
    chords.stop[one] = _meets(chords, one, two, chords.high[one], 1.0)
    chords.start[two] = _meets(chords, two, one, chords.low[two], -1.0)


def _meets(chords: _Chords, one: Ints, two: Ints, end: Floats, sense: float) -> Floats:
    """Where line ``one`` goes below plane ``two`` when followed in ``sense`` towards its ``end``: the end itself where that
    lies on the plane or above, or where the line comes up to it; nowhere (infinite) where the two planes face each other and
    the line stays below."""
    tip = _place(chords, one, end)
    height = dot(chords.normal[:, two], tip - chords.origin[:, two])
    falls = -sense * dot(chords.along[:, one], chords.normal[:, two])
    below, down = height < -SAME, falls > GRAZING
    faces = dot(chords.normal[:, one], chords.normal[:, two]) < 0.0
    place = np.where(below & down, end + sense * height / np.where(down, falls, 1.0), end)
    return np.where(below & ~down & faces, -sense * np.inf, place)


def _first_to_go(chords: _Chords, used: Ints) -> Ints:
    """Of the used-up chords those that go before any used-up neighbour.

    Of two neighbours goes first the one that a smaller ball uses up; but where each is trimmed on one side only, as where
    two arcs meet over a slot, the one that lies deeper below the plane of the other.
    """
    trims = (chords.start[used] - chords.low[used]) + (chords.high[used] - chords.stop[used])
    share = (chords.high[used] - chords.low[used]) / trims  # the part of the radius at which the chord is just used up
    rank = np.full(len(chords.at), -1)
    rank[used[np.lexsort((chords.tie[used], share))]] = np.arange(len(used))
    one = used[(chords.after[used] >= 0) & (rank[chords.after[used]] >= 0)]
    two = chords.after[one]
    single = ~(chords.crosses[chords.before[one]] & (chords.before[one] >= 0)) & ~(chords.crosses[two] & (chords.after[two] >= 0))
    single &= np.isfinite(chords.start[one]) & np.isfinite(chords.stop[two])
    gone = rank[one] < rank[two]
    one_high = _height(chords, two, _place(chords, one, np.where(single, chords.start[one], 0.0)))
    two_high = _height(chords, one, _place(chords, two, np.where(single, chords.stop[two], 0.0)))
    gone = np.where(single & (np.abs(one_high - two_high) > SAME), one_high < two_high, gone)
    stays = np.zeros(len(chords.at), bool)
    stays[np.where(gone, two, one)] = True
    return used[~stays[used]]


def _drop(chords: _Chords, gone: Ints) -> Ints:
    """Take chords out; returns the chords that must now be trimmed against the one after them.

    Beyond an open end nothing remains to trim against: the neighbour keeps the trim that the dropped chord gave it.
    """
    before, after = chords.before[gone], chords.after[gone]
    chords.alive[gone] = False
    chords.heir[gone] = np.where(before >= 0, before, after)
    chords.after[before[before >= 0]] = after[before >= 0]
    chords.before[after[after >= 0]] = before[after >= 0]
    fresh = before[(before >= 0) & (after >= 0)]
    alone = fresh[chords.after[fresh] == fresh]  # a ring of one chord is no path
    chords.alive[alone] = False
    chords.crosses[fresh] = True
    return np.asarray(fresh)


class _Spot(NamedTuple):
    """Places on chords: ``t`` mm along ``chord``; ``ending`` True where the chord ends there; ``flat`` True where two offsets
    that meet share one point; ``left`` and ``right`` segments on either side; ``fill`` as in OffsetPath; ``lift`` the chord
    to whose start the path goes from here over a point above both planes, -1 for none."""

    chord: Ints
    t: Floats
    ending: Bools
    flat: Bools
    left: Ints
    right: Ints
    fill: Bools
    lift: Ints


def _rows(chords: _Chords, segments: Segments, junctions: Junctions) -> tuple[Rows, Ints]:
    """The rows of what is left, and the polyline of each."""
    spot, radius = _spots(chords, segments, junctions), chords.radius
    at, t, real = chords.at[spot.chord], spot.t, chords.real[spot.chord]
    segment, nxt = segments.live[at], segments.following[at]
    far = segments.live[np.where(nxt < 0, at, nxt)]
    theta = np.maximum(junctions.theta[at], np.finfo(float).tiny)
    angle = np.where(real, 0.0, chords.angle[spot.chord] + np.arctan2(t, radius))
    w1, w2, w3 = arc_weights(theta, np.where(spot.flat, 0.5 * theta, angle))
    w1 = np.where(real & ~spot.flat, 1.0, w1)
    reach = np.where(real, radius, np.hypot(radius, t))
    reach = np.where(spot.flat, radius / np.cos(0.5 * theta), reach)
    shift = np.where(real & ~spot.flat, np.where(spot.ending, t - segments.length[segment], t), 0.0)
    base = 2 * segment + (spot.ending | ~real)
    lifted = np.flatnonzero(spot.lift >= 0)
    centre = _lifted(chords, spot.chord[lifted], spot.lift[lifted])
    rows = Rows(base, far, spot.left, spot.right, w1, w2, w3, reach, shift, spot.fill, lifted, centre)
    return rows, segments.line[at]


def _spots(chords: _Chords, segments: Segments, junctions: Junctions) -> _Spot:
    """Where each polyline begins, and for each chord: its end, a lifted point, and the start of the next, where needed."""
    one = np.flatnonzero(chords.alive)
    two = chords.after[one]
    opened = two < 0
    two = np.where(opened, one, two)
    left, right = _real_sides(chords, segments, one, opened)
    crosses = chords.crosses[one] & ~opened
    leaves = chords.final[one] & ~crosses & ~opened  # the arc's last point belongs to the segment after it
    real, yes, none = chords.real[one], np.ones(len(one), bool), np.full(len(one), -1)
    flat = real & ~crosses & (junctions.kind[chords.at[one]] == FLAT)
    chord, t = np.where(leaves, two, one), np.where(leaves, chords.start[two], chords.stop[one])
    end = _Spot(chord, t, ~leaves, flat, left, right, ~real, none)
    lift = _Spot(one, chords.stop[one], yes, ~yes, left, right, yes, two)
    start = _Spot(two, chords.start[two], ~yes, ~yes, left, right, yes, none)
    stop, go = _place(chords, one, chords.stop[one]), _place(chords, two, chords.start[two])
    apart = crosses & (np.abs(stop - go).max(axis=0) >= SAME)
    dips = np.minimum(_height(chords, two, stop), _height(chords, one, go)) < -FLAT_GAP
    dips &= dot(chords.normal[:, one], chords.normal[:, two]) > 0.0  # nothing is above two planes that face each other
    first = np.flatnonzero(np.diff(segments.line[chords.at[one]], prepend=-1))
    last = np.append(first[1:], len(one))[: len(first)] - 1
    used = np.stack([np.zeros(len(one), bool), yes, apart & dips, apart], axis=1)
    used[first, 0] = True
    seam = [np.where(apart[last], b[last], a[last]) for a, b in zip(end, start, strict=True)]
    begin = _Spot(one, chords.start[one], ~yes, ~yes, right, right, ~yes, none)
    head = _Spot(*(np.where(opened[last], a[first], b) for a, b in zip(begin, seam, strict=True)))._replace(fill=~yes[first])
    woven = []
    for begins, *others in zip(head, end, lift, start, strict=True):
        four = np.stack([others[0], *others], axis=1)
        four[first, 0] = begins
        woven.append(four[used])
    return _Spot(*woven)


def _height(chords: _Chords, chord: Ints, place: Floats) -> Floats:
    """Height (c,) of ``place`` (3, c) above the planes of chords, mm."""
    return dot(chords.normal[:, chord], place - chords.origin[:, chord])


def _lifted(chords: _Chords, one: Ints, two: Ints) -> Floats:
    """Half-way from the end of chord ``one`` to the start of chord ``two``, moved out along the mean normal until it is
    above the planes of both (between the two ends of a convex junction: the paper's p + R m)."""
    middle = 0.5 * (_place(chords, one, chords.stop[one]) + _place(chords, two, chords.start[two]))
    mean = chords.normal[:, one] + chords.normal[:, two]
    mean /= np.sqrt(dot(mean, mean))
    low = np.minimum(_height(chords, one, middle), _height(chords, two, middle))
    return np.asarray(middle - low / dot(mean, chords.normal[:, one]) * mean)


def _real_sides(chords: _Chords, segments: Segments, one: Ints, opened: Bools) -> tuple[Ints, Ints]:
    """The nearest segments that are left before and after the end of each chord, round a seam, else the chord's own."""
    n, row, real = len(one), np.arange(len(one)), chords.real[one]
    first = np.flatnonzero(np.diff(segments.line[chords.at[one]], prepend=-1))
    size = np.diff(first, append=n)
    low, high = np.repeat(first, size), np.repeat(first + size - 1, size)
    before = np.maximum.accumulate(np.where(real, row, -1))
    onward = np.append(np.minimum.accumulate(np.where(real, row, n)[::-1])[::-1], n)  # the first one from here
    after = onward[1:]
    closed = ~opened[high]
    before = np.where((before < low) & closed, before[high], before)
    after = np.where((after > high) & closed, onward[low], after)
    none_before, none_after = before < low, after > high
    before, after = np.where(none_before, after, before), np.where(none_after, before, after)
    segment = np.append(segments.live[chords.at[one]], -1)
    nothing = none_before & none_after
    return segment[np.where(nothing, row, before)], segment[np.where(nothing, row, after)]


def _place(chords: _Chords, chord: Ints, t: Floats) -> Floats:
    return np.asarray(chords.origin[:, chord] + t * chords.along[:, chord])


def _what_is_left(chords: _Chords, segments: Segments) -> tuple[Ints, Floats, Ints, Floats]:
    """Segments that the ball cuts into and how deep, mm; segments that were dropped and how far from each it stays, mm.

    Measured where two chords that did not meet before are trimmed against each other: from there to the nearest point of
    their segments and of the segments dropped between them, and to the further end of the latter (infinite where nothing is
    left of the polyline).
    """
    gone = np.flatnonzero(~chords.alive & chords.real)
    heir = chords.heir
    while not np.array_equal(heir, heir[heir]):
        heir = heir[heir]
    lost, gone = gone[~chords.alive[heir[gone]]], gone[chords.alive[heir[gone]]]
    heir = heir[gone]
    head = (chords.before[heir] < 0) & (heir > gone)  # all before it is gone
    onward = np.where(head | (chords.after[heir] < 0), heir, chords.after[heir])
    stop = _place(chords, heir, np.where(head, chords.start[heir], chords.stop[heir]))
    go = np.where(onward == heir, stop, _place(chords, onward, chords.start[onward]))
    near_stop, far_stop = _distances(chords, segments, gone, stop)
    near_go, far_go = _distances(chords, segments, gone, go)
    nearest = np.minimum(np.minimum(near_stop, near_go), _distances(chords, segments, onward, stop)[0])
    depth = chords.radius - np.minimum(nearest, _distances(chords, segments, heir, go)[0])
    height = np.minimum(far_stop, far_go).max(axis=0) - chords.radius
    stuck = np.flatnonzero(chords.alive & chords.stuck)
    depth = np.concatenate([depth, np.full(len(stuck), chords.radius)])  # not known, so the worst
    missed, height = np.concatenate([gone, lost]), np.concatenate([height, np.full(len(lost), np.inf)])
    segment = segments.live[chords.at]
    return segment[np.concatenate([gone, stuck])], depth, segment[missed], height


def _distances(chords: _Chords, segments: Segments, chord: Ints, place: Floats) -> tuple[Floats, Floats]:
    """From ``place`` (3, c) to the nearest point (c,) and to both ends (2, c) of the contact segments of chords, mm."""
    segment = segments.live[chords.at[chord]]
    along, length = direction(segments, segment), segments.length[segment]
    off = place - segments.point.take(2 * segment, axis=1)
    ends = (np.clip(dot(off, along), 0.0, length), np.zeros(len(chord)), length)
    near, start, stop = (np.sqrt(dot(rest, rest)) for rest in (off - t * along for t in ends))
    return near, np.stack([start, stop])
