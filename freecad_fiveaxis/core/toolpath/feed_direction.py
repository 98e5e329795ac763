# SPDX-License-Identifier: LGPL-2.1-or-later
"""The direction of travel at every row of an offset path, perpendicular to the tool's axis there."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .coedge import OffsetPath

OPPOSED = 1e-6
"""Below this length the sum of two unit vectors has no direction that rounding does not make."""

SHORT = 1e-9
"""mm; a step shorter than this has no direction: contact points are that far off by rounding."""


def feed_direction(path: OffsetPath, axis: Floats) -> Floats:
    """Return unit direction of travel (n, 3) at every row, perpendicular to ``axis`` (n, 3).

    The mean of the last cutting step before the row and the first one after it, so that all rows of one
    contact point share it; moves that close gaps do not count. A closed polyline goes on over its seam. Where
    there is no such direction (a single point, a reversal, travel along the axis) the step before alone is
    taken, then the direction of the row before, and at last any perpendicular.
    """
    behind, ahead = _steps(path)
    feed = across(behind + ahead, axis)
    lost = np.flatnonzero(is_zero(feed))
    if len(lost):
        feed[lost] = across(behind[lost], axis[lost])
        feed = _carry_on(feed, axis)
    return feed


def _steps(path: OffsetPath) -> tuple[Floats, Floats]:
    """Return unit cutting step before and after each row, (n, 3) each; zero where the polyline has none."""
    n = len(path.point)
    row = np.arange(n)
    start = np.flatnonzero(np.diff(path.polyline, prepend=path.polyline[0] - 1))
    size = np.diff(start, append=n)
    first, last = np.repeat(start, size), np.repeat(start + size - 1, size)
    move = np.zeros((3, n)).T
    move[1:] = path.centre[1:] - path.centre[:-1]  # while it cuts, the centre moves just as the contact does
    length = np.sqrt(np.einsum("ij,ij->i", move, move))
    cuts = (row > first) & ~path.fill & (length > SHORT)
    move = np.divide(move, length[:, None], out=np.zeros_like(move), where=cuts[:, None])
    behind = np.maximum.accumulate(np.where(cuts, row, -1))
    ahead = np.append(np.minimum.accumulate(np.where(cuts, row, n)[::-1])[::-1][1:], n)
    none_behind, none_ahead = behind <= first, ahead > last
    closed = _is_closed(path, first, last)
    behind = np.where(none_behind & closed, behind[last], behind)
    ahead = np.where(none_ahead & closed, ahead[first], ahead)
    return _take_moves(move, behind, first, last), _take_moves(move, ahead, first, last)


def _is_closed(path: OffsetPath, first: Ints, last: Ints) -> Bools:
    return np.asarray(np.abs(path.centre[first] - path.centre[last]).max(axis=1) < SHORT)


def _take_moves(move: Floats, at: Ints, first: Ints, last: Ints) -> Floats:
    """Rows ``at`` of ``move``, zero where that lies outside the row's own polyline."""
    inside = (at > first) & (at <= last)
    taken = np.ascontiguousarray(move.T).take(np.where(inside, at, 0), axis=1)
    return np.asarray(np.where(inside, taken, 0.0).T)


def _carry_on(feed: Floats, axis: Floats) -> Floats:
    """Zero rows filled from the row before, and where that does not help with any perpendicular."""
    lost = np.flatnonzero(is_zero(feed))
    known = np.where(is_zero(feed), -1, np.arange(len(feed)))
    source = np.maximum.accumulate(known)[lost]
    feed[lost] = np.where((source >= 0)[:, None], across(feed[np.maximum(source, 0)], axis[lost]), 0.0)
    lost = lost[is_zero(feed[lost])]
    flat = np.hypot(axis[lost, 0], axis[lost, 1]) > OPPOSED
    feed[lost] = across(
        np.where(flat[:, None], np.cross((0.0, 0.0, 1.0), axis[lost]), (1.0, 0.0, 0.0)), axis[lost]
    )
    return feed


def across(vector: Floats, axis: Floats) -> Floats:
    """``vector`` without its part along ``axis``, unit; zero where nothing is left."""
    rest = vector - np.einsum("ij,ij->i", vector, axis)[:, None] * axis
    return unit_or(rest, np.broadcast_to(0.0, rest.shape))


def unit_or(vector: Floats, instead: Floats) -> Floats:
    """``vector`` made unit in its place; rows of ``instead`` where there is no direction."""
    length = np.sqrt(np.einsum("ij,ij->i", vector, vector))
    lost = np.flatnonzero(length <= OPPOSED)
    length[lost] = 1.0
    vector /= length[:, None]
    vector[lost] = instead[lost]
    return vector


def is_zero(vector: Floats) -> Bools:
    """Say of each row (n, 3) whether it is zero."""
    return np.asarray(~vector.any(axis=1))
