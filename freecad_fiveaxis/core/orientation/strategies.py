# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool-axis strategies: from the offset path to a unit axis for every row.

axis       unit vector from the tip to the holder, in the work frame.
feed       unit direction of travel over the part, made perpendicular to the axis.
left       axis x feed: to the left for one who stands on the part with the axis upwards and looks along the feed.
lead       how far the tool leans forward: a positive lead turns the axis about *left*, towards the feed.
tilt       how far the tool leans sideways: a positive tilt turns the axis right-handed about the feed, to the right.

A strategy is one function and one line in STRATEGIES; lead and tilt go on top of any. All rows of one contact point have the
same facet normals on either side, so they get the same axis: the tool does not turn while it closes a gap at a co-edge.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.base.vectors import away_from
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

Vector = tuple[float, float, float]

OPPOSED = 1e-6
"""Below this length the sum of two unit vectors has no direction that rounding does not make."""

SHORT = 1e-9
"""mm; a step shorter than this has no direction: contact points are that far off by rounding."""


@dataclass(frozen=True)
class AxisOptions:
    """``fixed``: the axis of the strategy of that name, any length; ``lead`` and ``tilt`` in rad; ``through``, mm, and ``about``,
    any length: the axis that the strategy ``from_axis`` points at."""

    fixed: Vector = (0.0, 0.0, 1.0)
    lead: float = 0.0
    tilt: float = 0.0
    through: Vector = (0.0, 0.0, 0.0)
    about: Vector = (0.0, 0.0, 1.0)


def tool_axes(path: OffsetPath, strategy: str, options: AxisOptions) -> Floats:
    """Unit axis (n, 3) of every row: the strategy, then lead and tilt.

    Raises SettingsError for an unknown strategy, a lead or tilt that is no number, and a fixed axis of no length.
    Lead and tilt follow the order of the rows: order and reverse passes first (:func:`..passes.field.cut`).
    """
    find = find_strategy(strategy)
    for name in ("lead", "tilt"):
        if not np.isfinite(getattr(options, name)):
            raise SettingsError(
                say("{name} is {value}; give an angle", name=name, value=getattr(options, name)), getattr(options, name)
            )
    axis = find(path, options)
    if (options.lead == 0.0 and options.tilt == 0.0) or not len(axis):
        return axis
    return leaned(axis, feed_direction(path, axis), options.lead, options.tilt)


def facet_mean(path: OffsetPath, options: AxisOptions) -> Floats:
    """the arithmetic mean of the facet normals on either side of the contact (the conventional method)

    Lin & Ye, Fig. 15 (a). Where the two are opposed the row's own normal is taken.
    """
    axis = np.empty((3, len(path.point))).T

    def fill(rows: slice) -> None:
        axis[rows] = _unit(path.before[rows] + path.after[rows], path.normal[rows])

    in_threads(fill, chunks(len(axis)))
    return axis


def step_weighted(path: OffsetPath, options: AxisOptions) -> Floats:
    """divides the angle between the two facet normals by the steps on either side (Lin & Ye, eqs. 9, 10)

    The angle from the first normal is ``S2 / (S1 + S2)`` of the angle between them: the longer step keeps its normal more
    nearly. So the axis turns less over a long step and more over a short one.
    """
    total = path.step_before + path.step_after
    share = np.divide(path.step_after, total, out=np.full(len(total), 0.5), where=total > SHORT)
    return _slerp(path.before, path.after, share, path.normal)


def minimax(path: OffsetPath, options: AxisOptions) -> Floats:
    """the smallest largest deviation of each pass on this machine and set-up, within --max-tilt of the facet normals

    It needs the machine: here it is only begun, as facet_mean. The correction of that name goes on from there
    (``orientation.axis_corrections``).
    """
    return facet_mean(path, options)


def auto(path: OffsetPath, options: AxisOptions) -> Floats:
    """a smooth field of axes on the surface with which cutter, shank and holder are free of the part, within the machine's limits

    It needs part and machine: here it is only begun, as facet_mean. The correction of that name goes on from there
    (``orientation.axis_corrections``).
    """
    return facet_mean(path, options)


def fixed(path: OffsetPath, options: AxisOptions) -> Floats:
    """one axis everywhere (three-axis milling, or 3 + 2 with a tilted axis)"""
    vector = np.array(options.fixed, float)
    length = float(np.linalg.norm(vector))
    if vector.shape != (3,) or not np.isfinite(length) or length == 0.0:
        raise SettingsError(
            say("fixed tool axis {fixed} has no direction; give three numbers, as 0,0,1", fixed=options.fixed), options.fixed
        )
    return np.repeat((vector / length)[:, None], len(path.point), axis=1).T


def from_axis(path: OffsetPath, options: AxisOptions) -> Floats:
    """square to a rotary axis and pointing at it: one rotary axis turns the part under the tool

    The way from that axis to the contact. A contact on the axis takes what its normal has across it.
    """
    about = _direction_of(options.about)
    outward, _ = away_from(path.point, np.array(options.through, float), about)
    lost = np.flatnonzero(_is_zero(outward))
    if len(lost):
        square = np.broadcast_to(np.cross(about, np.eye(3)[np.abs(about).argmin()]), (len(lost), 3))
        outward[lost] = _across(path.normal[lost], np.broadcast_to(about, (len(lost), 3)))
        lost = lost[_is_zero(outward[lost])]
        outward[lost] = square[: len(lost)] / np.linalg.norm(square[0])
    return outward


def _direction_of(about: Vector) -> Floats:
    vector = np.array(about, float)
    length = float(np.linalg.norm(vector))
    if not np.isfinite(length) or length == 0.0:
        raise SettingsError(say("axis {about} has no direction; give three numbers, as 1,0,0", about=about), about)
    return np.asarray(vector / length)


Strategy = Callable[[OffsetPath, AxisOptions], Floats]
"""From an offset path to a unit axis (n, 3) for each of its rows."""

STRATEGIES: dict[str, Strategy] = {
    "facet_mean": facet_mean,
    "step_weighted": step_weighted,
    "minimax": minimax,
    "auto": auto,
    "fixed": fixed,
    "from_axis": from_axis,
}


def find_strategy(name: str) -> Strategy:
    """The strategy of that name. Raises SettingsError that lists those known."""
    if name not in STRATEGIES:
        raise SettingsError(
            say(
                "unknown tool-axis strategy {name}; choose one of {strategies}", name=repr(name), strategies=", ".join(STRATEGIES)
            ),
            name,
        )
    return STRATEGIES[name]


def feed_direction(path: OffsetPath, axis: Floats) -> Floats:
    """Unit direction of travel (n, 3) at every row, perpendicular to ``axis`` (n, 3).

    The mean of the last cutting step before the row and the first one after it, so that all rows of one contact point
    share it; moves that close gaps do not count. A closed polyline goes on over its seam. Where there is no such direction
    (a single point, a reversal, travel along the axis) the step before alone is taken, then the direction of the row before,
    and at last any perpendicular.
    """
    behind, ahead = _steps(path)
    feed = _across(behind + ahead, axis)
    lost = np.flatnonzero(_is_zero(feed))
    if len(lost):
        feed[lost] = _across(behind[lost], axis[lost])
        feed = _carried_on(feed, axis)
    return feed


def _steps(path: OffsetPath) -> tuple[Floats, Floats]:
    """Unit cutting step before and after each row, (n, 3) each; zero where the polyline has none."""
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
    closed = _closed(path, first, last)
    behind = np.where(none_behind & closed, behind[last], behind)
    ahead = np.where(none_ahead & closed, ahead[first], ahead)
    return _taken(move, behind, first, last), _taken(move, ahead, first, last)


def _closed(path: OffsetPath, first: Ints, last: Ints) -> Bools:
    return np.asarray(np.abs(path.centre[first] - path.centre[last]).max(axis=1) < SHORT)


def _taken(move: Floats, at: Ints, first: Ints, last: Ints) -> Floats:
    """Rows ``at`` of ``move``, zero where that lies outside the row's own polyline."""
    inside = (at > first) & (at <= last)
    taken = np.ascontiguousarray(move.T).take(np.where(inside, at, 0), axis=1)
    return np.asarray(np.where(inside, taken, 0.0).T)


def _carried_on(feed: Floats, axis: Floats) -> Floats:
    """Zero rows filled from the row before, and where that does not help with any perpendicular."""
    lost = np.flatnonzero(_is_zero(feed))
    known = np.where(_is_zero(feed), -1, np.arange(len(feed)))
    source = np.maximum.accumulate(known)[lost]
    feed[lost] = np.where((source >= 0)[:, None], _across(feed[np.maximum(source, 0)], axis[lost]), 0.0)
    lost = lost[_is_zero(feed[lost])]
    flat = np.hypot(axis[lost, 0], axis[lost, 1]) > OPPOSED
    feed[lost] = _across(np.where(flat[:, None], np.cross((0.0, 0.0, 1.0), axis[lost]), (1.0, 0.0, 0.0)), axis[lost])
    return feed


def leaned(axis: Floats, feed: Floats, lead: float, tilt: float) -> Floats:
    """The axis turned by ``lead`` about left, then by ``tilt`` about the feed (Rodrigues for perpendicular vectors)."""
    right = np.cross(feed, axis)
    return np.asarray(np.cos(lead) * (np.cos(tilt) * axis + np.sin(tilt) * right) + np.sin(lead) * feed)


def _across(vector: Floats, axis: Floats) -> Floats:
    """``vector`` without its part along ``axis``, unit; zero where nothing is left."""
    rest = vector - np.einsum("ij,ij->i", vector, axis)[:, None] * axis
    return _unit(rest, np.broadcast_to(0.0, rest.shape))


def _unit(vector: Floats, instead: Floats) -> Floats:
    """``vector`` made unit in its place; rows of ``instead`` where there is no direction."""
    length = np.sqrt(np.einsum("ij,ij->i", vector, vector))
    lost = np.flatnonzero(length <= OPPOSED)
    length[lost] = 1.0
    vector /= length[:, None]
    vector[lost] = instead[lost]
    return vector


def _is_zero(vector: Floats) -> Bools:
    return np.asarray(~vector.any(axis=1))


def _slerp(start: Floats, end: Floats, share: Floats, instead: Floats) -> Floats:
    """Unit rows at ``share`` of the angle from ``start`` to ``end``; ``instead`` where they are opposed.

    Not :func:`~.vectors.slerp`: its last digits differ, and programs with step weighting would."""
    wide = np.linalg.norm(start + end, axis=1)
    angle = 2.0 * np.arctan2(np.linalg.norm(end - start, axis=1), wide)
    angle = np.maximum(angle, np.finfo(float).tiny)
    mixed = (np.sin((1.0 - share) * angle) / np.sin(angle))[:, None] * start
    mixed += (np.sin(share * angle) / np.sin(angle))[:, None] * end
    opposed = np.flatnonzero(wide <= OPPOSED)
    mixed[opposed] = instead[opposed]
    return _unit(mixed, instead)
