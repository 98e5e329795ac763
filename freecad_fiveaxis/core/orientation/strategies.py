# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool-axis strategies: from the offset path to a unit axis for every row.

axis       unit vector from the tip to the holder, in the work frame.
feed       unit direction of travel over the part, made perpendicular to the axis.
left       axis x feed: to the left for one who stands on the part with the axis upwards and looks along the
           feed.
lead       how far the tool leans forward: a positive lead turns the axis about *left*, towards the feed.
tilt       how far the tool leans sideways: a positive tilt turns the axis right-handed about the feed, to the
           right.

A strategy is one function and one line in STRATEGIES; lead and tilt go on top of any. All rows of one contact
point have the same facet normals on either side, so they get the same axis: the tool does not turn while it
closes a gap at a co-edge. Only ``face_normal`` turns it there, over edges that are sharp.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.base.vectors import away_from, row_dot
from freecad_fiveaxis.core.toolpath.cl_offset import seat_normal
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath
from freecad_fiveaxis.core.toolpath.feed_direction import (
    OPPOSED,
    SHORT,
    across,
    feed_direction,
    is_zero,
    unit_or,
)

Vector = tuple[float, float, float]

UPPER = (1e-6, 1e-7, 1.0)
"""What is up; of sides that are level the one towards +X, then +Y, so that passes in either sense lean to the
same one."""

FACE_NORMAL = "face_normal"
"""The strategy whose level bottom stands on its contact with its middle."""

FOLLOWING = ("facet_mean", FACE_NORMAL, "step_weighted")
"""Strategies whose axes are the surface's normals, on which a barrel has to lean."""


@dataclass(frozen=True)
class AxisOptions:
    """``fixed``: the axis of the strategy of that name, any length; ``lead`` and ``tilt`` in rad;
    ``through``, mm, and ``about``, any length: the axis that the strategy ``from_axis`` points at;
    ``upwards``: the tilt may be to the left instead, for a whole pass, where the axis is more upright so;
    ``ring``, mm: the cutter's radius less that of its corner."""

    fixed: Vector = (0.0, 0.0, 1.0)
    lead: float = 0.0
    tilt: float = 0.0
    through: Vector = (0.0, 0.0, 0.0)
    about: Vector = (0.0, 0.0, 1.0)
    upwards: bool = False
    ring: float = 0.0


def tool_axes(path: OffsetPath, strategy: str, options: AxisOptions) -> Floats:
    """Return unit axis (n, 3) of every row: the strategy, then lead and tilt.

    Raises SettingsError for an unknown strategy, a lead or tilt that is no number, and a fixed axis of no
    length. Lead and tilt follow the order of the rows: order and reverse passes first
    (:func:`..passes.field.cut`).
    """
    find = find_strategy(strategy)
    for name in ("lead", "tilt"):
        if not np.isfinite(getattr(options, name)):
            raise SettingsError(
                say("{name} is {value}; give an angle", name=name, value=getattr(options, name)),
                getattr(options, name),
            )
    axis = find(path, options)
    if (options.lead == 0.0 and options.tilt == 0.0) or not len(axis):
        return axis
    feed = feed_direction(path, axis)
    tilt = options.tilt * _upper_side(path, axis, feed) if options.upwards else options.tilt
    return lean_axis(axis, feed, options.lead, tilt)


def _upper_side(path: OffsetPath, axis: Floats, feed: Floats) -> Floats:
    """1 for the rows (n, 1) of each polyline along which the right of the tool is on the whole its upper
    side, else -1."""
    start = np.flatnonzero(np.diff(path.polyline, prepend=path.polyline[0] - 1))
    rise = np.add.reduceat(np.cross(feed, axis) @ np.array(UPPER), start)
    return np.repeat(np.where(rise < 0.0, -1.0, 1.0), np.diff(start, append=len(axis)))[:, None]


def facet_mean(path: OffsetPath, options: AxisOptions) -> Floats:
    """the arithmetic mean of the facet normals on either side of the contact (the conventional method)

    Lin & Ye, Fig. 15 (a). Where the two are opposed the row's own normal is taken.
    """
    axis = np.empty((3, len(path.point))).T

    def fill(rows: slice) -> None:
        axis[rows] = unit_or(path.before[rows] + path.after[rows], path.normal[rows])

    in_threads(fill, chunks(len(axis)))
    return axis


def face_normal(path: OffsetPath, options: AxisOptions) -> Floats:
    """the normal of the face, up to its edges: over a sharp edge the tool turns while its contact stays there

    Smooth co-edges, which approximate one surface, and inside corners: as facet_mean. So a level bottom lies
    on plane faces from edge to edge, and passes may be as far apart as it is wide.
    """
    axis = facet_mean(path, options)
    if not len(axis):
        return axis
    over = np.flatnonzero(row_dot(path.after - path.before, feed_direction(path, axis)) > 0.0)
    axis[over] = seat_normal(path, options.ring)[over]
    return axis


def step_weighted(path: OffsetPath, options: AxisOptions) -> Floats:
    """divides the angle between the two facet normals by the steps on either side (Lin & Ye, eqs. 9, 10)

    The angle from the first normal is ``S2 / (S1 + S2)`` of the angle between them: the longer step keeps its
    normal more nearly. So the axis turns less over a long step and more over a short one.
    """
    total = path.step_before + path.step_after
    share = np.divide(path.step_after, total, out=np.full(len(total), 0.5), where=total > SHORT)
    return _slerp(path.before, path.after, share, path.normal)


def minimax(path: OffsetPath, options: AxisOptions) -> Floats:
    """the smallest largest deviation of each pass on this machine and set-up, within --max-tilt of the facet
    normals

    It needs the machine: here it is only begun, as facet_mean. The correction of that name goes on from there
    (``orientation.axis_corrections``).
    """
    return facet_mean(path, options)


def auto(path: OffsetPath, options: AxisOptions) -> Floats:
    """a smooth field of axes on the surface with which cutter, shank and holder are free of the part, within
    the machine's limits

    It needs part and machine: here it is only begun, as facet_mean, or as face_normal for a level bottom. The
    correction of that name goes on from there (``orientation.axis_corrections``).
    """
    return face_normal(path, options) if options.ring > 0.0 else facet_mean(path, options)


def fixed(path: OffsetPath, options: AxisOptions) -> Floats:
    """one axis everywhere (three-axis milling, or 3 + 2 with a tilted axis)"""
    vector = np.array(options.fixed, float)
    length = float(np.linalg.norm(vector))
    if vector.shape != (3,) or not np.isfinite(length) or length == 0.0:
        raise SettingsError(
            say(
                "fixed tool axis {fixed} has no direction; give three numbers, as 0,0,1", fixed=options.fixed
            ),
            options.fixed,
        )
    return np.repeat((vector / length)[:, None], len(path.point), axis=1).T


def from_axis(path: OffsetPath, options: AxisOptions) -> Floats:
    """square to a rotary axis and pointing at it: one rotary axis turns the part under the tool

    The way from that axis to the contact. A contact on the axis takes what its normal has across it.
    """
    about = _direction_of(options.about)
    outward, _ = away_from(path.point, np.array(options.through, float), about)
    lost = np.flatnonzero(is_zero(outward))
    if len(lost):
        square = np.broadcast_to(np.cross(about, np.eye(3)[np.abs(about).argmin()]), (len(lost), 3))
        outward[lost] = across(path.normal[lost], np.broadcast_to(about, (len(lost), 3)))
        lost = lost[is_zero(outward[lost])]
        outward[lost] = square[: len(lost)] / np.linalg.norm(square[0])
    return outward


def _direction_of(about: Vector) -> Floats:
    vector = np.array(about, float)
    length = float(np.linalg.norm(vector))
    if not np.isfinite(length) or length == 0.0:
        raise SettingsError(
            say("axis {about} has no direction; give three numbers, as 1,0,0", about=about), about
        )
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
    FACE_NORMAL: face_normal,
}


def find_strategy(name: str) -> Strategy:
    """Return the strategy of that name. Raises SettingsError that lists those known."""
    if name not in STRATEGIES:
        raise SettingsError(
            say(
                "unknown tool-axis strategy {name}; choose one of {strategies}",
                name=repr(name),
                strategies=", ".join(STRATEGIES),
            ),
            name,
        )
    return STRATEGIES[name]


def lean_axis(axis: Floats, feed: Floats, lead: float, tilt: Floats | float) -> Floats:
    """Return the axis turned by ``lead`` about left, then by ``tilt``, one or (n, 1), about the feed
    (Rodrigues for perpendicular vectors)."""
    right = np.cross(feed, axis)
    return np.asarray(np.cos(lead) * (np.cos(tilt) * axis + np.sin(tilt) * right) + np.sin(lead) * feed)


def _slerp(start: Floats, end: Floats, share: Floats, instead: Floats) -> Floats:
    """Return unit rows at ``share`` of the angle from ``start`` to ``end``; ``instead`` where they are
    opposed.

    Not :func:`~.vectors.slerp`: its last digits differ, and programs with step weighting would."""
    wide = np.linalg.norm(start + end, axis=1)
    angle = 2.0 * np.arctan2(np.linalg.norm(end - start, axis=1), wide)
    angle = np.maximum(angle, np.finfo(float).tiny)
    mixed = (np.sin((1.0 - share) * angle) / np.sin(angle))[:, None] * start
    mixed += (np.sin(share * angle) / np.sin(angle))[:, None] * end
    opposed = np.flatnonzero(wide <= OPPOSED)
    mixed[opposed] = instead[opposed]
    return unit_or(mixed, instead)
