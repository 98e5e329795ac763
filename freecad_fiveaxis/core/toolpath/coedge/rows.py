# SPDX-License-Identifier: LGPL-2.1-or-later
"""From some polylines of segments to the rows of their offset, in short form and in their order.

easy      a polyline in which no segment is used up: its rows follow from each junction alone.
tight     any other; its rows come from :mod:`.trimming`.
number    of a row: its place among all rows of these polylines, those that are left out counted too.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Ints, run_ids

from .breaks import Part
from .junction import CHUNK, Junctions, Rows, Segments, find_junctions, junction_rows, pick_plain_rows
from .trimming import Trimmed, find_used_up, trim_polylines

NO_ROWS = np.empty(0, np.int64)


class Closed(NamedTuple):
    """``rows`` in their order; ``begins`` (n,) where a polyline begins, None where all rows are kept;
    ``trimmed`` the tight polylines, None where there are none. In rows ``beside`` (b,) the ball also touches
    the segment ``wall`` (b,), which is not cut. Where ``begins`` is None, a polyline is broken, and
    begins anew, at rows ``breaks`` (c,)."""

    rows: Rows
    begins: Bools | None
    trimmed: Trimmed | None
    beside: Ints = NO_ROWS
    wall: Ints = NO_ROWS
    breaks: Ints = NO_ROWS


class _Numbered(NamedTuple):
    """Rows with their ``number`` and ``line``, the polyline, (n,) each; where a polyline is broken, all paths
    but the first have numbers of their own, behind those of all polylines."""

    number: Ints
    line: Ints
    rows: Rows


def close_rows(segments: Segments, radius: float, tolerance: float, cut: Bools | None, part: Part) -> Closed:
    """Return the rows of whole polylines. ``part``: what keeps the ball off. ``cut``: which segments of the
    contact path are cut, None: all; of the others no row stays, nor a row that has no neighbour left."""
    junctions = find_junctions(segments, radius, tolerance, cut)
    tight = find_used_up(segments, junctions)
    if not len(tight):
        place = _places(segments, junctions.rows)
        found, trimmed = _easy(segments, junctions, _near(segments, None, cut), place, radius, 0), None
        if cut is None:
            return Closed(found.rows, None, None)
        order = np.arange(len(found.number))
    else:
        tight_line = np.zeros(len(segments.first), bool)
        tight_line[tight] = True
        is_tight = tight_line.take(segments.line)
        trimmed = trim_polylines(segments, junctions, np.flatnonzero(is_tight), radius, tolerance, part, cut)
        place = _places(segments, np.where(is_tight, 0, junctions.rows), tight_line, trimmed.line)
        easy = _easy(segments, junctions, _near(segments, is_tight, cut), place, radius, len(trimmed.line))
        found = _with_tight(easy, segments, place, trimmed)
        order = np.argsort(found.number, kind="stable")
    if cut is None:
        line = found.line[order]
        breaks = np.flatnonzero((np.diff(line, prepend=-1) != 0) & (line >= len(segments.first)))
        return Closed(_pick_rows(found.rows, order), None, trimmed, breaks=breaks)
    rows, begins, beside, wall = _lasting(found, order, cut)
    return Closed(rows, begins, trimmed, beside, wall)


def _places(segments: Segments, count: Ints, tight: Bools | None = None, line: Ints | None = None) -> Ints:
    """Return the number (m + 1,) of the first row of each position, ``count`` (m,) rows each and one where a
    polyline begins; all rows of a ``tight`` (p,) polyline stand at its first position, ``line`` of each."""
    place = np.zeros(len(count) + 1, np.int64)
    place[1:] = count
    place[1 + segments.first] += 1
    if tight is not None and line is not None:
        place[1 + segments.first[tight]] = np.bincount(line, minlength=len(segments.first))[tight]
    return np.cumsum(place, out=place)


def _near(segments: Segments, tight: Bools | None, cut: Bools | None) -> Ints:
    """Return the positions whose junction lies beside a segment that is cut, but for those of tight
    polylines."""
    m = len(segments.live)
    here = np.ones(m, bool) if cut is None else cut.take(segments.live)
    near = here | here.take(np.where(segments.following < 0, np.arange(m), segments.following))
    return np.flatnonzero(near if tight is None else near & ~tight)


def _easy(
    segments: Segments, junctions: Junctions, at: Ints, place: Ints, radius: float, more: int
) -> _Numbered:
    """Return the rows of junctions at positions ``at`` (k,), and room for ``more`` after them; step -1 is the
    row where a polyline begins: its first contact, or the last row of its seam."""
    last = np.full(len(segments.live), -1, dtype=np.int64)
    last[segments.first] = segments.last
    low = place[at]
    count = place[at + 1] - low
    head, owner = np.cumsum(count) - count, run_ids(count)
    n, row = len(owner), np.arange(len(owner))
    found = _room(n + more)
    np.add(row, (low - head).take(owner), out=found.number[:n])
    step = row - (head + (last[at] >= 0)).take(owner)
    at = at.take(owner)
    segments.line.take(at, out=found.line[:n], mode="clip")
    begin = np.flatnonzero(step < 0)
    first, end = at[begin], last[at[begin]]
    closed = segments.following[end] >= 0
    at[begin], step[begin] = np.where(closed, end, first), np.where(closed, junctions.rows[end] - 1, 0)
    rows = found.rows
    for start in range(0, n, CHUNK):
        part = slice(start, min(start + CHUNK, n))
        _put(rows, part, junction_rows(segments, junctions, at[part], step[part], radius))
    rows.fill[begin] = False
    opened, segment = begin[~closed], segments.live[first[~closed]]
    for column, value in (
        (rows.w1, 1.0),
        (rows.w2, 0.0),
        (rows.w3, 0.0),
        (rows.reach, radius),
        (rows.shift, 0.0),
    ):
        column[opened] = value
    rows.base[opened], rows.left[opened], rows.right[opened] = 2 * segment, segment, segment
    return found


def _room(count: int) -> _Numbered:
    """Columns of so many rows, yet to be filled."""
    whole, real = np.empty((6, count), np.int64), np.empty((5, count))
    number, line, *places = whole
    return _Numbered(
        number, line, Rows._make([*places, *real, np.empty(count, bool), NO_ROWS, np.empty((3, 0))])
    )


def _put(rows: Rows, where: slice, new: Rows) -> None:
    for column, values in zip(rows[:-2], new[:-2], strict=True):
        column[where] = values


def _with_tight(easy: _Numbered, segments: Segments, place: Ints, trimmed: Trimmed) -> _Numbered:
    """Return the rows of the tight polylines put into the room behind the others."""
    line = trimmed.line
    rest = slice(len(easy.number) - len(line), len(easy.number))
    start = np.flatnonzero(np.diff(line, prepend=-1))
    shift = place[segments.first[line[start]]] - start
    easy.number[rest] = np.arange(len(line)) + np.repeat(shift, np.diff(start, append=len(line)))
    new = np.flatnonzero(trimmed.begins & (np.diff(line, prepend=-1) == 0))
    path = np.cumsum(trimmed.begins)
    easy.line[rest] = line
    later = np.isin(path, path[new])
    easy.line[rest][later] = len(segments.first) + path[later]
    _put(easy.rows, rest, trimmed.rows)
    return easy._replace(
        rows=easy.rows._replace(lifted=trimmed.rows.lifted + rest.start, centre=trimmed.rows.centre)
    )


def _pick_rows(rows: Rows, index: Ints) -> Rows:
    """Return the rows ``index`` (k,), in that order."""
    picked = pick_plain_rows(rows, index)
    if not len(rows.lifted):
        return picked
    place = np.full(len(rows.base), -1)
    place[index] = np.arange(len(index))
    lifted = place[rows.lifted]
    return picked._replace(lifted=lifted[lifted >= 0], centre=rows.centre[:, lifted >= 0])


def _lasting(found: _Numbered, order: Ints, cut: Bools) -> tuple[Rows, Bools, Ints, Ints]:
    """Return the rows, in that ``order``, that stand over what is cut and have a neighbour, and which of them
    begin a polyline. The segments on their sides become ones that are cut. Then ``beside`` and ``wall`` of
    Closed: rows that were trimmed against a segment that is not cut."""
    rows = found.rows
    left, right = cut.take(rows.left), cut.take(rows.right)
    border, stays = np.flatnonzero(left != right), cut.take(rows.base >> 1)
    stays[border[(rows.w2[border] != 0.0) | (rows.w3[border] != 0.0)]] = (
        False  # on its way round an edge to a left-out facet
    )
    kept = order[stays.take(order)]
    begins = row_begins(found.number.take(kept), found.line.take(kept))
    size = np.diff(np.flatnonzero(begins), append=len(kept))
    lasting = np.repeat(size > 1, size)
    kept = kept[lasting]
    one, two, touches = rows.left.copy(), rows.right.copy(), np.zeros(len(left), bool)
    one[border] = two[border] = np.where(left[border], rows.left[border], rows.right[border])
    touches[border] = rows.shift[border] != 0.0
    beside = np.flatnonzero(touches.take(kept))
    at = kept[beside]
    wall = np.where(left[at], rows.right[at], rows.left[at])
    return _pick_rows(rows._replace(left=one, right=two), kept), begins[lasting], beside, wall


def row_begins(number: Ints, line: Ints) -> Bools:
    """Which rows begin a polyline when only those of these numbers, of that polyline each, are left."""
    return np.asarray((np.diff(number, prepend=-2) != 1) | (np.diff(line, prepend=-1) != 0))
