# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where one facet segment of a contact polyline meets the next, and what that does to their offsets.

junction   the place where a segment ends and the next one begins, on a co-edge; in a closed polyline the last
           one is the seam.
flat       both offsets meet (nearly): one point.          convex    a gap opens: an arc about the contact.
concave    each offset ends inside the other: both are trimmed to where they cross.       end   the end of an
           open polyline.
theta      the angle between the two facet normals.        arcs      k, the number of equal sub-steps of theta
           in an arc.

An offset plane is a facet's plane moved out by the radius. Every chord made here lies in an offset plane of a
facet, or in a plane that touches the ball of that radius about the contact of a convex junction.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM, dot
from freecad_fiveaxis.core.passes import ContactPath

END, FLAT, CONVEX, CONCAVE = range(4)

FLAT_GAP = 1e-6
"""mm between the two offsets of a contact below which one point serves both: the point is on both offset
planes, and this far below the step of any controller beside the contact."""

STEP_ROUNDING = 1e-9
"""Share of a sub-step: an angle that is larger than k of them by no more is one of k, for its last digit is
rounded."""

GRAZING = 1e-6
"""A path that runs along a co-edge within this angle (rad) does not say on which side of it the facets rise:
taken as convex."""

KNIFE = 1e-6
"""rad; nearer than this to half a turn two normals do not span a plane. The arc then goes round in the
direction of travel."""

BROAD = 0.5
"""Length of the sum of two unit normals above which its direction is theirs to the last digits."""

GROUP = 400_000
"""Segments that are closed together, at most about so many, half as many as rows: the many calls for the few
tight polylines among them then cost little beside the work on all."""

CHUNK = 65536
"""Rows handled at a time: calls long enough for two threads to work side by side."""


@dataclass(frozen=True, eq=False)
class Segments:
    """The segments of a contact path that have a length.

    ``point`` and ``normal`` (3, n) of the contact path; ``length`` (s,) mm of each of its segments; ``live``
    (m,) the segments that are longer than COINCIDENT_MM; ``following`` (m,) position in ``live`` of the next
    one, -1 at the end of an open polyline, the first one again at the end of a closed one; ``first`` (p,)
    positions where the polylines begin.
    """

    point: Floats
    normal: Floats
    length: Floats
    live: Ints
    following: Ints
    first: Ints

    @property
    def last(self) -> Ints:
        """Positions (p,) where the polylines end."""
        return np.append(self.first[1:], len(self.live)) - 1

    @cached_property
    def line(self) -> Ints:
        """The polyline (m,) of each position, counted from 0."""
        return np.repeat(
            np.arange(len(self.first), dtype=np.int64), np.diff(self.first, append=len(self.live))
        )


@dataclass(frozen=True, eq=False)
class Junctions:
    """The junction after each live segment, (m,) each.

    ``kind``; ``rows`` how many rows it makes; ``arcs`` k; ``gap`` = 2 sin(theta / 2) and ``wide`` = 2
    cos(theta / 2): the lengths of the difference and of the sum of both normals; ``trim_end`` (at most 0) and
    ``trim_start`` (at least 0) mm by which a concave junction moves the end of the segment before it and the
    start of the one after it.
    """

    kind: Bytes
    rows: Ints
    arcs: Ints
    gap: Floats
    wide: Floats
    trim_end: Floats
    trim_start: Floats

    def theta(self, at: Ints) -> Floats:
        """theta (k,) rad of junctions ``at`` (k,)."""
        return 2.0 * np.arctan2(self.gap.take(at), self.wide.take(at))


class Rows(NamedTuple):
    """Rows of an offset path in short form, (n,) each.

    Contact: row ``base`` of the contact path, moved by ``shift`` mm along its segment. Normal: ``w1`` x the
    normal of that row + ``w2`` x the normal of segment ``far`` + ``w3`` x the direction of the row's segment.
    Centre: contact + ``reach`` x normal. ``left``, ``right``: the segments on either side. ``fill`` as in
    OffsetPath. Rows ``lifted`` (l,) have their centre at ``centre`` (3, l) instead.
    """

    base: Ints
    far: Ints
    left: Ints
    right: Ints
    w1: Floats
    w2: Floats
    w3: Floats
    reach: Floats
    shift: Floats
    fill: Bools
    lifted: Ints
    centre: Floats


def pick_plain_rows(rows: Rows, which: slice | Ints) -> Rows:
    """Return some of the rows, without what is said of lifted ones."""
    columns = [column[which] if isinstance(which, slice) else column.take(which) for column in rows[:-2]]
    return Rows._make([*columns, np.empty(0, np.int64), np.empty((3, 0))])


def find_segments(contact: ContactPath) -> Segments:
    """Return the segments of a contact path in their order, without those that have no length (a plane
    through a vertex)."""
    point, normal = np.ascontiguousarray(contact.point.T), np.ascontiguousarray(contact.normal.T)
    length = np.empty(point.shape[1] // 2)

    def measure(part: slice) -> None:
        step = point[:, 2 * part.start + 1 : 2 * part.stop : 2] - point[:, 2 * part.start : 2 * part.stop : 2]
        np.sqrt(dot(step, step), out=length[part])

    in_threads(measure, chunks(len(length)))
    live = np.flatnonzero(length > COINCIDENT_MM)
    label = contact.polyline.take(2 * live)
    first = np.flatnonzero(np.diff(label, prepend=label[:1] - 1))
    last = np.append(first[1:], len(live))[: len(first)] - 1
    seam = np.abs(point.take(2 * live[last] + 1, axis=1) - point.take(2 * live[first], axis=1)).max(
        axis=0, initial=0.0
    )
    following = np.arange(1, len(live) + 1)
    following[last] = np.where((seam < COINCIDENT_MM) & (last > first), first, -1)
    return Segments(point, normal, length, live, following, first)


def groups(segments: Segments) -> list[Segments]:
    """Return the same in parts of whole polylines: an even number of them, alike, so that both threads have
    as much to do."""
    ends = np.append(segments.first[1:], len(segments.live))[: len(segments.first)]
    count = len(segments.live)
    size = max((part.stop - part.start for part in chunks(count, GROUP)), default=1)
    bounds = ends[np.diff((ends - 1) // size, append=-1) != 0].tolist()
    parts = []
    for low, high in zip([0, *bounds], bounds, strict=False):
        following, first = segments.following[low:high], segments.first
        here = first[(first >= low) & (first < high)] - low
        following = np.where(following < 0, -1, following - low)
        parts.append(replace(segments, live=segments.live[low:high], following=following, first=here))
    return parts


def find_junctions(
    segments: Segments, radius: float, tolerance: float, cut: Bools | None = None
) -> Junctions:
    """Kind, trims and arcs of every junction, for a ball of ``radius`` mm and R - r at most ``tolerance`` mm.
    ``cut``: which segments of the contact path are cut, None: all; where only one of two is, a concave
    junction has a row on either."""
    m = len(segments.live)
    kind, rows, arcs = np.empty(m, np.int8), np.empty(m, np.int64), np.empty(m, np.int64)
    gap, wide, trim_end, trim_start = np.empty((4, m))
    for low in range(0, m, CHUNK):
        part = slice(low, min(low + CHUNK, m))
        n1, n2, d1, d2 = _sides(segments, part)
        apart, ahead, behind = n1 - n2, dot(d1, n2), dot(d2, n1)
        gap[part], wide[part] = np.sqrt(dot(apart, apart)), _length_of_sum(n1, n2)
        kind[part] = _kinds(segments.following[part], radius * gap[part], ahead, behind, gap[part])
        arcs[part] = _arcs(gap[part], wide[part], radius, tolerance)
        rows[part] = np.where(kind[part] == CONVEX, arcs[part] + 2, 1)
        trim_end[part], trim_start[part] = 0.0, 0.0
        hollow = np.flatnonzero(kind[part] == CONCAVE)
        rise = 0.5 * radius * gap[part][hollow] ** 2  # r (1 - cos theta)
        end, start = rise / ahead[hollow], rise / behind[hollow]
        trim_end[part][hollow], trim_start[part][hollow] = end, start
        meet = (
            radius * apart.take(hollow, axis=1)
            + end * d1.take(hollow, axis=1)
            - start * d2.take(hollow, axis=1)
        )
        border = one_is_cut(segments, hollow + low, segments.following[part][hollow], cut)
        rows[part][hollow] += (dot(meet, meet) >= COINCIDENT_MM**2) | border
    return Junctions(kind, rows, arcs, gap, wide, trim_end, trim_start)


def _sides(segments: Segments, part: slice) -> tuple[Floats, Floats, Floats, Floats]:
    """Return normals before and after the junctions, then directions before and after, (3, k) each; after an
    end those before it."""
    own = segments.live[part.start : part.stop + 1]
    count, row = part.stop - part.start, np.arange(part.start, part.stop)
    following = segments.following[part]
    odd = np.flatnonzero(following != row + 1)
    other = segments.live.take(np.where(following[odd] < 0, row[odd], following[odd]))
    sides = []
    along = _ascending(segments.point, own, 1) - _ascending(segments.point, own, 0)
    along /= segments.length.take(own)
    facing = _ascending(segments.normal, own, 0)
    for one, two in ((facing, segments.normal.take(2 * other, axis=1)), (along, direction(segments, other))):
        after = np.empty((3, count))
        after[:, : len(own) - 1] = one[:, 1:]
        after[:, odd] = two
        sides.append((one[:, :count], after))
    return sides[0][0], sides[0][1], sides[1][0], sides[1][1]


def one_is_cut(segments: Segments, one: Ints, two: Ints, cut: Bools | None) -> Bools:
    """Whether just one of the two segments at positions ``one`` and ``two`` (k,) is cut; ``cut``: which are,
    None: all."""
    if cut is None:
        return np.zeros(len(one), bool)
    return np.asarray(cut.take(segments.live.take(one)) != cut.take(segments.live.take(two)))


def _length_of_sum(one: Floats, two: Floats) -> Floats:
    both = one + two
    return np.asarray(np.sqrt(dot(both, both)))


def _ascending(table: Floats, segment: Ints, end: int) -> Floats:
    """Of a (3, n) ``table`` of the contact path the entries (``end`` 0) or exits (1) of ascending segments
    (k,); a view where these follow one another, as they mostly do."""
    if segment[-1] - segment[0] == len(segment) - 1:
        return table[:, 2 * segment[0] + end : 2 * segment[-1] + end + 1 : 2]
    return table.take(2 * segment + end, axis=1)


def _kinds(following: Ints, gap: Floats, ahead: Floats, behind: Floats, sine: Floats) -> Bytes:
    """Return the profile turns towards the normals (concave) where the path before runs into the facet after,
    and the other way."""
    concave = (ahead < -GRAZING * sine) & (behind > GRAZING * sine)
    kind = np.where(gap < FLAT_GAP, FLAT, np.where(concave, CONCAVE, CONVEX))
    return np.where(following < 0, END, kind).astype(np.int8)


def arcs_needed(theta: Floats, radius: float, tolerance: float) -> Ints:
    """Return the fewest sub-steps with ``radius / cos(theta / 2k) - radius <= tolerance`` (eq. 4 for each
    sub-step)."""
    widest = 2.0 * np.arctan2(np.sqrt(tolerance * (2.0 * radius + tolerance)), radius)
    fewest = np.ceil(theta / widest - STEP_ROUNDING).astype(
        np.int64
    )  # an angle of just k steps needs k, whatever its last digit
    return np.asarray(np.maximum(fewest, 1))


def _arcs(gap: Floats, wide: Floats, radius: float, tolerance: float) -> Ints:
    """As arcs_needed, of junctions with ``gap`` and ``wide``: an angle only where one sub-step may not do."""
    sine, cosine = (
        np.sqrt(tolerance * (2.0 * radius + tolerance)),
        radius,
    )  # of the widest sub-step's half, times R
    arcs = np.ones(len(gap), np.int64)
    more = np.flatnonzero(gap * (cosine * (1.0 + STEP_ROUNDING)) > wide * sine)
    arcs[more] = arcs_needed(2.0 * np.arctan2(gap[more], wide[more]), radius, tolerance)
    return arcs


def direction(segments: Segments, segment: Ints) -> Floats:
    """Return unit direction of travel (3, k) of segments of the contact path."""
    step = segments.point.take(2 * segment + 1, axis=1) - segments.point.take(2 * segment, axis=1)
    step /= segments.length.take(segment)
    return np.asarray(step)


def arc_weights(theta: Floats, angle: Floats) -> tuple[Floats, Floats, Floats]:
    """w1, w2, w3 of the unit normal at ``angle`` from the first of two normals that are ``theta`` apart (rad,
    not 0)."""
    knife = np.flatnonzero(np.pi - theta < KNIFE)
    sine, third = np.sin(theta), np.zeros(len(theta))
    sine[knife], third[knife] = 1.0, np.sin(angle[knife])
    first, second = np.sin(theta - angle) / sine, np.sin(angle) / sine
    first[knife], second[knife] = np.cos(angle[knife]), 0.0
    return first, second, third


def junction_rows(segments: Segments, junctions: Junctions, at: Ints, step: Ints, radius: float) -> Rows:
    """Row ``step`` (counted from 0) of the junction at position ``at``, (k,) each.

    Convex, eqs. 4 and 5 and Fig. 7 (k = 1): p + r N1; p + r / cos(delta / 2) n at the middle of each sub-step
    delta; p + r N2. Concave: where the offset line of the segment before meets the offset plane of the facet
    after, and where the offset line of the segment after meets the offset plane of the facet before.
    """
    kind, count = junctions.kind.take(at), junctions.rows.take(at)
    before = segments.live.take(at)
    nxt = segments.following.take(at)
    after = segments.live.take(np.where(nxt < 0, at, nxt))
    final = (step > 0) & (step == count - 1)
    middle = np.flatnonzero((kind == FLAT) | ((kind == CONVEX) & (step > 0) & ~final))
    w1, w2, w3, reach = (
        np.ones(len(at)),
        np.zeros(len(at)),
        np.zeros(len(at)),
        np.full(len(at), float(radius)),
    )
    wide = junctions.wide.take(at[middle])
    w1[middle] = w2[middle] = 1.0 / np.maximum(wide, BROAD)  # the unit mean normal: theta is all one sub-step
    reach[middle] = 2.0 * radius * w1[middle]
    several = middle[((kind[middle] != FLAT) & (junctions.arcs.take(at[middle]) > 1)) | (wide < BROAD)]
    theta = junctions.theta(at[several])
    half = 0.5 * theta / np.where(kind[several] == FLAT, 1, junctions.arcs.take(at[several]))
    w1[several], w2[several], w3[several] = arc_weights(theta, np.maximum(2 * step[several] - 1, 1) * half)
    reach[several] = radius / np.cos(half)
    shift = np.where(step > 0, junctions.trim_start.take(at), junctions.trim_end.take(at))
    base = np.where(final, 2 * after, 2 * before + 1)
    return Rows(
        base,
        after,
        before,
        after,
        w1,
        w2,
        w3,
        reach,
        shift,
        step > 0,
        np.empty(0, np.int64),
        np.empty((3, 0)),
    )
