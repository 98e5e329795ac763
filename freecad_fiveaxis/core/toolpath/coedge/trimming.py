# SPDX-License-Identifier: LGPL-2.1-or-later
"""Offset polylines where the trims of concave junctions use up whole segments.

crossing   where the line of one chord meets the plane of the other, both ways; both points lie on the line in
           which the two planes cross, so the path between them keeps off both facets.
used up    a chord whose trims from its two ends overlap. It is dropped and its neighbours are trimmed against
           each other: the ball never touches what lay under it, because it already touches both sides.
           Where the ball is free on it the path is broken beside it instead (:mod:`.breaks`).

Of neighbouring used-up chords the one that a smaller ball would use up first is dropped first, as the offset
of a polygon shrinks; all that do not disturb each other are dropped in one round.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM, dot, length

from .breaks import Part, break_unmet, spare_free
from .chord import Chords, drop_chords, height_above, make_chords, place_on
from .junction import (
    FLAT,
    FLAT_GAP,
    GRAZING,
    Junctions,
    Rows,
    Segments,
    arc_weights,
    arcs_needed,
    direction,
    one_is_cut,
)

ROUNDS = 1000
"""A run of used-up chords is halved in most rounds; only one that tightens steadily needs a round for each
chord."""

UNCUT = 0.05
"""mm that would stay beside a trim that the part does not ask for, before the path is broken there."""


class Trimmed(NamedTuple):
    """``rows`` of the offset path in short form, each of polyline ``line``; ``begins`` True where a path
    begins: once in each polyline, and wherever it is broken; segments that the ball may
    ``cut_into`` and ``depth`` mm, above 0 where it does; segments that it does not reach, ``missed``, and
    ``height`` mm by which it stays off.
    """

    rows: Rows
    line: Ints
    begins: Bools
    cut_into: Ints
    depth: Floats
    missed: Ints
    height: Floats


def find_used_up(segments: Segments, junctions: Junctions) -> Ints:
    """Polylines in which the trims of some segment overlap."""
    start = np.zeros(len(segments.live))
    follows = segments.following >= 0
    start[segments.following[follows]] = junctions.trim_start[follows]
    overlap = np.flatnonzero(start - junctions.trim_end > segments.length[segments.live])
    return np.unique(segments.line[overlap])


def trim_polylines(
    segments: Segments,
    junctions: Junctions,
    at: Ints,
    radius: float,
    tolerance: float,
    part: Part,
    cut: Bools | None = None,
) -> Trimmed:
    """Return the offset of whole polylines, ``at`` (m,) their positions in order: trimmed until no chord is
    used up. ``part``: what keeps the ball off. ``cut``: which segments of the contact path are cut, None:
    all; where chords of one that is and one that is not meet, each has a row."""
    quarter = int(arcs_needed(np.array([0.5 * np.pi]), radius, tolerance)[0])
    chords = make_chords(segments, junctions, at, radius, quarter)
    _drop_used_up(chords, part)
    break_unmet(chords, part, UNCUT)
    rows, line, begins = _rows(chords, segments, junctions, cut)
    return Trimmed(rows, line, begins, *_what_is_left(chords, segments))


def _drop_used_up(chords: Chords, part: Part) -> None:
    """Drop used-up chords, in rounds, until there are none; marks those that are left after all rounds as
    ``stuck``. Those on which the ball is free of the part stay, and the path is broken beside them."""
    fresh, waiting = np.flatnonzero(chords.crosses & (chords.after >= 0)), np.empty(0, np.int64)
    marked = np.zeros(len(chords.at), bool)
    for _ in range(ROUNDS):
        fresh = fresh[chords.alive[fresh] & (chords.after[fresh] >= 0)]
        _cross(chords, fresh)
        marked[fresh] = marked[chords.after[fresh]] = marked[waiting] = True
        touched = np.flatnonzero(marked)
        marked[touched] = False
        used = touched[chords.alive[touched] & (chords.start[touched] - chords.stop[touched] > COINCIDENT_MM)]
        if not len(used):
            return
        fresh, waiting = drop_chords(chords, spare_free(chords, part, _first_to_go(chords, used))), used
    chords.stuck[used] = True
    chords.start[used], chords.stop[used] = chords.low[used], chords.high[used]


def _cross(chords: Chords, one: Ints) -> None:
    """Trim chords ``one`` and the chords after them against each other."""
    two = chords.after[one]
    chords.stop[one] = _meets(chords, one, two, chords.high[one], 1.0)
    chords.start[two] = _meets(chords, two, one, chords.low[two], -1.0)


def _meets(chords: Chords, one: Ints, two: Ints, end: Floats, sense: float) -> Floats:
    """Where line ``one`` goes below plane ``two`` when followed in ``sense`` towards its ``end``: the end
    itself where that lies on the plane or above, or where the line comes up to it; nowhere (infinite) where
    the two planes face each other and the line stays below."""
    tip = place_on(chords, one, end)
    height = dot(chords.normal.take(two, axis=1), tip - chords.origin.take(two, axis=1))
    falls = -sense * dot(chords.along.take(one, axis=1), chords.normal.take(two, axis=1))
    below, down = height < -COINCIDENT_MM, falls > GRAZING
    faces = dot(chords.normal.take(one, axis=1), chords.normal.take(two, axis=1)) < 0.0
    place = np.where(below & down, end + sense * height / np.where(down, falls, 1.0), end)
    return np.where(below & ~down & faces, -sense * np.inf, place)


def _first_to_go(chords: Chords, used: Ints) -> Ints:
    """Of the used-up chords those that go before any used-up neighbour.

    Of two neighbours goes first the one that a smaller ball uses up; but where each is trimmed on one side
    only, as where two arcs meet over a slot, the one that lies deeper below the plane of the other.
    """
    trims = (chords.start[used] - chords.low[used]) + (chords.high[used] - chords.stop[used])
    share = (
        chords.high[used] - chords.low[used]
    ) / trims  # the part of the radius at which the chord is just used up
    rank = np.full(len(chords.at), -1)
    rank[used[np.lexsort((chords.tie[used], share))]] = np.arange(len(used))
    one = used[(chords.after[used] >= 0) & (rank[chords.after[used]] >= 0)]
    two = chords.after[one]
    single = ~(chords.crosses[chords.before[one]] & (chords.before[one] >= 0)) & ~(
        chords.crosses[two] & (chords.after[two] >= 0)
    )
    single &= np.isfinite(chords.start[one]) & np.isfinite(chords.stop[two])
    gone = rank[one] < rank[two]
    one_high = height_above(chords, two, place_on(chords, one, np.where(single, chords.start[one], 0.0)))
    two_high = height_above(chords, one, place_on(chords, two, np.where(single, chords.stop[two], 0.0)))
    gone = np.where(single & (np.abs(one_high - two_high) > COINCIDENT_MM), one_high < two_high, gone)
    stays = np.zeros(len(chords.at), bool)
    stays[np.where(gone, two, one)] = True
    return used[~stays[used]]


class _Spot(NamedTuple):
    """Places on chords: ``t`` mm along ``chord``; ``ending`` True where the chord ends there; ``flat`` True
    where two offsets that meet share one point; ``left`` and ``right`` segments on either side; ``fill`` as
    in OffsetPath; ``lift`` the chord to whose start the path goes from here over a point above both planes,
    -1 for none."""

    chord: Ints
    t: Floats
    ending: Bools
    flat: Bools
    left: Ints
    right: Ints
    fill: Bools
    lift: Ints


def _rows(
    chords: Chords, segments: Segments, junctions: Junctions, cut: Bools | None
) -> tuple[Rows, Ints, Bools]:
    """Return the rows of what is left, the polyline of each, and where paths begin."""
    (spot, begins), radius = _spots(chords, segments, junctions, cut), chords.radius
    at, t, real = chords.at[spot.chord], spot.t, chords.real[spot.chord]
    segment, nxt = segments.live[at], segments.following[at]
    far = segments.live[np.where(nxt < 0, at, nxt)]
    theta = np.maximum(junctions.theta(at), np.finfo(float).tiny)
    angle = np.where(real, 0.0, chords.angle[spot.chord] + np.arctan2(t, radius))
    w1, w2, w3 = arc_weights(theta, np.where(spot.flat, 0.5 * theta, angle))
    w1 = np.where(real & ~spot.flat, 1.0, w1)
    reach = np.where(real, radius, np.hypot(radius, t))
    shift = np.where(real & ~spot.flat, np.where(spot.ending, t - segments.length[segment], t), 0.0)
    base = 2 * segment + (spot.ending | ~real)
    lifted = np.flatnonzero(spot.lift >= 0)
    centre = _lift_corner(chords, spot.chord[lifted], spot.lift[lifted])
    rows = Rows(base, far, spot.left, spot.right, w1, w2, w3, reach, shift, spot.fill, lifted, centre)
    return rows, segments.line[at], begins


def _spots(
    chords: Chords, segments: Segments, junctions: Junctions, cut: Bools | None
) -> tuple[_Spot, Bools]:
    """Where each path begins, and for each chord: its end, a lifted point, and the start of the next, where
    needed; then which of these begin a path."""
    one, first = _paths(chords, segments)
    two = chords.after[one]
    opened = (two < 0) | chords.ghost[two]
    two = np.where(opened, one, two)
    left, right = _real_sides(chords, segments, one, first, opened)
    crosses = chords.crosses[one] & ~opened
    leaves = chords.final[one] & ~crosses & ~opened  # the arc's last point belongs to the segment after it
    real, yes, none = chords.real[one], np.ones(len(one), bool), np.full(len(one), -1)
    flat = real & ~crosses & ~opened & (junctions.kind[chords.at[one]] == FLAT)
    chord, t = np.where(leaves, two, one), np.where(leaves, chords.start[two], chords.stop[one])
    end = _Spot(chord, t, ~leaves, flat, left, right, ~real, none)
    lift = _Spot(one, chords.stop[one], yes, ~yes, left, right, yes, two)
    start = _Spot(two, chords.start[two], ~yes, ~yes, left, right, yes, none)
    stop, go = place_on(chords, one, chords.stop[one]), place_on(chords, two, chords.start[two])
    border = one_is_cut(segments, chords.at[one], chords.at[two], cut)
    apart = crosses & ((np.abs(stop - go).max(axis=0) >= COINCIDENT_MM) | border)
    dips = np.minimum(height_above(chords, two, stop), height_above(chords, one, go)) < -FLAT_GAP
    facing = dot(chords.normal.take(one, axis=1), chords.normal.take(two, axis=1))
    dips &= facing > 0.0  # nothing is above two planes that face each other
    last = np.append(first[1:], len(one))[: len(first)] - 1
    used = np.stack([np.zeros(len(one), bool), yes, apart & dips, apart], axis=1)
    used[first, 0] = True
    seam = [np.where(apart[last], b[last], a[last]) for a, b in zip(end, start, strict=True)]
    begin = _Spot(one, chords.start[one], ~yes, ~yes, left, left, ~yes, none)
    head = _Spot(*(np.where(opened[last], a[first], b) for a, b in zip(begin, seam, strict=True)))._replace(
        fill=~yes[first]
    )
    place = np.cumsum(used).reshape(used.shape) - 1
    over, on = np.flatnonzero(used[:, 2]), np.flatnonzero(apart)
    interleaved: list[Any] = []
    for begins, ends, lifts, starts in zip(head, end, lift, start, strict=True):
        column = np.empty(int(used.sum()), ends.dtype)
        column[place[first, 0]], column[place[:, 1]] = begins, ends
        column[place[over, 2]], column[place[on, 3]] = lifts[over], starts[on]
        interleaved.append(column)
    heads = np.zeros(int(used.sum()), bool)
    heads[place[first, 0]] = True
    return _Spot(*interleaved), heads


def _paths(chords: Chords, segments: Segments) -> tuple[Ints, Ints]:
    """Return the chords that are left, path by path, and the places among them at which a path begins. A ring
    that is broken begins behind its first break."""
    one = np.flatnonzero(chords.alive & ~chords.ghost)
    line, before = segments.line[chords.at[one]], chords.before[one]
    opens = (before < 0) | chords.ghost[before]
    broken = np.zeros(len(segments.first), bool)
    broken[line[opens]] = True
    whole = ~broken[line]
    early = ~whole & (np.maximum.accumulate(np.where(opens, line, -1)) < line)
    order = np.lexsort((early, line))
    one, line, opens, whole = one[order], line[order], opens[order], whole[order]
    return one, np.flatnonzero(opens | (whole & (np.diff(line, prepend=-1) != 0)))


def _lift_corner(chords: Chords, one: Ints, two: Ints) -> Floats:
    """Half-way from the end of chord ``one`` to the start of chord ``two``, moved out along the mean normal
    until it is above the planes of both (between the two ends of a convex junction: the paper's p + R m)."""
    middle = 0.5 * (place_on(chords, one, chords.stop[one]) + place_on(chords, two, chords.start[two]))
    mean = chords.normal.take(one, axis=1) + chords.normal.take(two, axis=1)
    mean /= np.sqrt(dot(mean, mean))
    low = np.minimum(height_above(chords, one, middle), height_above(chords, two, middle))
    return np.asarray(middle - low / dot(mean, chords.normal.take(one, axis=1)) * mean)


def _real_sides(
    chords: Chords, segments: Segments, one: Ints, first: Ints, opened: Bools
) -> tuple[Ints, Ints]:
    """Return the nearest segments that are left before and after the end of each chord, round a seam, else
    the chord's own."""
    n, row, real = len(one), np.arange(len(one)), chords.real[one]
    size = np.diff(first, append=n)
    low, high = np.repeat(first, size), np.repeat(first + size - 1, size)
    before = np.maximum.accumulate(np.where(real, row, -1))
    onward = np.append(
        np.minimum.accumulate(np.where(real, row, n)[::-1])[::-1], n
    )  # the first one from here
    after = onward[1:]
    closed = ~opened[high]
    before = np.where((before < low) & closed, before[high], before)
    after = np.where((after > high) & closed, onward[low], after)
    none_before, none_after = before < low, after > high
    before, after = np.where(none_before, after, before), np.where(none_after, before, after)
    segment = np.append(segments.live[chords.at[one]], -1)
    nothing = none_before & none_after
    return segment[np.where(nothing, row, before)], segment[np.where(nothing, row, after)]


def _what_is_left(chords: Chords, segments: Segments) -> tuple[Ints, Floats, Ints, Floats]:
    """Segments that the ball cuts into and how deep, mm; segments that were dropped and how far from each it
    stays, mm.

    Measured where two chords that did not meet before are trimmed against each other: from there to the
    nearest point of their segments and of the segments dropped between them, and to the further end of the
    latter (infinite where nothing is left of the polyline).
    """
    gone = np.flatnonzero(~chords.alive & chords.real)
    heir = chords.heir
    for _ in range(len(heir).bit_length()):  # each round doubles how far an heir's heir is followed
        heir = heir[heir]
    beyond = (chords.after < 0) | chords.ghost[chords.after]
    nothing = ~chords.alive | (chords.ghost & beyond)
    heir[gone] = np.where(nothing[heir[gone]], _beside_breaks(chords, segments, gone), heir[gone])
    lost, gone = gone[nothing[heir[gone]]], gone[~nothing[heir[gone]]]
    heir = heir[gone]
    head = (chords.before[heir] < 0) & (heir > gone)  # all before it is gone
    onward = np.where(head | (chords.after[heir] < 0), heir, chords.after[heir])
    stop = place_on(chords, heir, np.where(head, chords.start[heir], chords.stop[heir]))
    go = np.where(onward == heir, stop, place_on(chords, onward, chords.start[onward]))
    near = [
        _to_segment(chords, segments, *pair)
        for pair in ((gone, stop), (gone, go), (onward, stop), (heir, go))
    ]
    ends = [segments.point.take(2 * segments.live[chords.at[gone]] + side, axis=1) for side in (0, 1)]
    near += [_to_chord(chords, chord, end) for chord in (heir, onward) for end in ends]
    depth = chords.radius - np.min(near, axis=0)
    far = [np.minimum(length(stop - end), length(go - end)) for end in ends]
    height = np.maximum(*far) - chords.radius
    stuck = np.flatnonzero(chords.alive & chords.stuck)
    depth = np.concatenate([depth, np.full(len(stuck), chords.radius)])  # not known, so the worst
    missed, height = np.concatenate([gone, lost]), np.concatenate([height, np.full(len(lost), np.inf)])
    segment = segments.live[chords.at]
    return segment[np.concatenate([gone, stuck])], depth, segment[missed], height


def _beside_breaks(chords: Chords, segments: Segments, gone: Ints) -> Ints:
    """Return for chords of a path of which nothing is left the one of the same polyline that is left before
    it, or else after it, or else the chord itself."""
    left, line = np.flatnonzero(chords.alive & ~chords.ghost), segments.line[chords.at]
    if not len(left):
        return gone
    place = np.searchsorted(left, gone)
    before, after = left[np.maximum(place - 1, 0)], left[np.minimum(place, len(left) - 1)]
    heir = np.where(line[after] == line[gone], after, gone)
    return np.where((place > 0) & (line[before] == line[gone]), before, heir)


def _to_segment(chords: Chords, segments: Segments, chord: Ints, place: Floats) -> Floats:
    """From ``place`` (3, c) to the nearest point of the contact segments of chords, (c,) mm."""
    segment = segments.live[chords.at[chord]]
    along, off = direction(segments, segment), place - segments.point.take(2 * segment, axis=1)
    return length(off - np.clip(dot(off, along), 0.0, segments.length[segment]) * along)


def _to_chord(chords: Chords, chord: Ints, place: Floats) -> Floats:
    """From ``place`` (3, c) to the nearest point of what is left of chords, (c,) mm."""
    along, off = chords.along.take(chord, axis=1), place - chords.origin.take(chord, axis=1)
    return length(off - np.clip(dot(off, along), chords.start[chord], chords.stop[chord]) * along)
