# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a cutter that is no ball sits on the offset path: from the corner circle's centre to the hub.

corner path  what co-edges are closed for: the path of a ball of the corner radius. A ball cutter needs no
             more.
ring      a bull nose is that ball swept round a ring: its hub lies one ring radius further, along *out*
          (core/tool/cutter.py).
sharp     the corner of a flat: a ball of some nanometres, so that edges get their arc of normals.
smooth    a co-edge between facets that approximate one surface. All rows of its contact take out from the
          mean of both normals, as the tool axis does, and the bottom rocks from facet to facet; at any other
          co-edge each row takes its own normal, and the bottom slides over the edge.
barrel    its flank touches where the axis leans far from the normal: its hub, the centre of the ball at its
          tip, is shifted from where that ball would touch (core/tool/barrel.py).
heel      the side of the bottom away from the contact: in a hollow it meets the part although the contact is
          tangent.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.sentences import Angle, Choice, Length, Option, Point, say
from freecad_fiveaxis.core.base.vectors import row_dot, slerp
from freecad_fiveaxis.core.passes import CREASE
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.barrel import Flank
from freecad_fiveaxis.core.tool.contact import ring_direction, stands_square

from .coedge import ROW_COLUMNS, OffsetPath
from .feed_direction import feed_direction

SHARP = 5e-5
"""mm: the corner radius of a flat on its way round edges, half of a word's last digit. Co-edges of more than
a degree open a gap that counts with it (``junction.FLAT_GAP``)."""

ROCKING = 0.01
"""mm: by so much the bottom may enter a facet between two smooth co-edges; what rocks further is no smooth
surface. It is half of what such facets leave the surface behind them by, at most."""

ONE_HUB_MM = 2.0 * SHARP
"""mm; hubs nearer than this, under one axis, are one place."""

NOTABLE = 0.01
"""mm of a heel in the part before it is worth a finding: a usual finishing tolerance."""

SWING_HALVINGS = 8
"""Times that a move over an edge is halved at most."""

MOST_PIECES = 64
"""Pieces of a block at most: half a turn of the axis in steps of less than 3 degrees."""


def corner_radius(cutter: Cutter) -> float:
    """Return the radius, mm, of the ball for which co-edges are closed."""
    return max(cutter.corner, min(SHARP, cutter.radius))


def hub_positions(path: OffsetPath, axis: Floats, ring: float, barrel: Flank | None = None) -> Floats:
    """Return the hubs (n, 3) mm of a cutter with that ring (mm), or the flank of a barrel, and tool axes (n,
    3); ``path.centre`` itself for a ball (ring 0)."""
    if barrel is not None and len(axis):
        return np.asarray(path.centre + barrel.hub_shift(seat_normal(path, ring, barrel), axis))
    if ring == 0.0 or not len(axis):
        return path.centre
    seat = seat_normal(path, ring)
    out = ring_direction(seat, axis, feed_direction(path, axis), ring)
    if path.middle:
        out[stands_square(seat, axis, ring)] = 0.0
    return np.asarray(path.centre + ring * out)


def seat_normal(path: OffsetPath, ring: float, barrel: Flank | None = None) -> Floats:
    """Return the unit normal (n, 3) of the surface on which a cutter with that ring (mm), or that flank, sits
    at each row.

    Smooth: over a facet of length L whose normal the axis leaves by half of a co-edge's turn t at both its
    ends, the bottom enters it at most by ``t min(L, 16 ring) / 16``: at the share s of the way it leans by t
    (1 - 2 s) / 2 and has s L of facet behind it. What is round there, as the flank of a barrel is along its
    pass with half its diameter r at most, enters by ``r t^2 / 8``.
    """
    mean = path.before + path.after
    turn = np.linalg.norm(path.after - path.before, axis=1)
    way = np.minimum(np.maximum(path.step_before, path.step_after), 16.0 * ring)
    deep = way * turn / 16.0 if barrel is None else (barrel.radius + barrel.ring) * turn * turn / 8.0
    smooth = (turn <= 2.0 * np.sin(0.5 * CREASE)) & (deep <= ROCKING)
    length = np.linalg.norm(np.where(smooth[:, None], mean, path.normal), axis=1)
    return np.asarray(np.where(smooth[:, None], mean, path.normal) / length[:, None])


def cl_offset_path(
    path: OffsetPath, axis: Floats, cutter: Cutter, tolerance: float
) -> tuple[OffsetPath, Floats]:
    """Return the path with the cutter's hubs for its centres, and its axes; what it says of hollows is in the
    findings.

    A block in which the axis turns so much that the bottom, half-way, would leave the surface by more than
    ``tolerance`` mm gets rows between. A ball's path comes back as it is.
    """
    if cutter.touches_as_ball or not len(axis):
        return path, axis
    path, axis = _swing_hubs(*_divide_turns(path, axis, cutter, tolerance), cutter, tolerance)
    hub = hub_positions(path, axis, cutter.ring, cutter.barrel)
    seated = replace(path, centre=hub, findings=path.findings + _findings_of(path, hub, axis, cutter))
    rows = np.flatnonzero(~_stands_still(seated, axis))
    return (seated, axis) if len(rows) == len(axis) else (keep_rows(seated, rows), axis[rows])


def _columns(path: OffsetPath, rows: Ints) -> dict[str, Any]:
    """Rows (k,) of every column of a path, ready to be changed; its polylines go on over what is left out."""
    return {name: getattr(path, name)[rows] for name in ROW_COLUMNS}


def _stands_still(path: OffsetPath, axis: Floats) -> Bools:
    """Rows (n,) that close a gap and neither move nor turn the tool."""
    moved = np.abs(np.diff(path.centre, axis=0, prepend=path.centre[:1])).max(axis=1)
    turned = np.abs(np.diff(axis, axis=0, prepend=axis[:1])).max(axis=1)
    return np.asarray(path.fill & (moved <= ONE_HUB_MM) & (turned == 0.0))


# ----------------------------------------------------------------------------------------------- rows between


def _divide_turns(
    path: OffsetPath, axis: Floats, cutter: Cutter, tolerance: float
) -> tuple[OffsetPath, Floats]:
    """Rows put between those of cutting moves in which the axis turns by more than the tolerance allows.

    The bottom's lowest point, or the flank's contact, moves on a circle of at most its distance from the hub
    while that goes straight: over a turn a the two part by at most ``distance a^2 / 8``.
    """
    moves = np.diff(path.polyline, prepend=-1) == 0
    turn = 2.0 * np.arcsin(
        np.clip(0.5 * np.linalg.norm(np.diff(axis, axis=0, prepend=axis[:1]), axis=1), 0.0, 1.0)
    )
    widest = np.sqrt(8.0 * tolerance / cutter.contact_reach)
    pieces = np.where(moves, np.clip(np.ceil(turn / widest), 1, MOST_PIECES), 1).astype(np.int64)
    if (pieces == 1).all():
        return path, axis
    return rows_between(path, axis, pieces, cutter.ring, cutter.barrel)[:2]


def _swing_hubs(
    path: OffsetPath, axis: Floats, cutter: Cutter, tolerance: float
) -> tuple[OffsetPath, Floats]:
    """Rows put between those that close a gap over an edge, where the hub swings round the contact.

    Where an edge crosses the level bottom's plane aslant, the normal passes the axis at its side, and out
    swings round with it; hubs on the chord of that swing dip the bottom by ``ring (sine - out . normal)``
    into the edge, see :func:`ring_direction`. They may use up half of the tolerance; the other half is the
    chord's of the corner circle.
    """
    for _ in range(SWING_HALVINGS):
        fills = path.fill & (np.diff(path.polyline, prepend=-1) == 0)
        row = np.flatnonzero(fills)
        deep = row[_swing_depth(path, axis, row, cutter) > 0.5 * tolerance]
        if not len(deep):
            break
        pieces = np.ones(len(axis), np.int64)
        pieces[deep] = 2
        path, axis = rows_between(path, axis, pieces, cutter.ring, cutter.barrel)[:2]
    return path, axis


def _swing_depth(path: OffsetPath, axis: Floats, row: Ints, cutter: Cutter) -> Floats:
    """How deep (k,) mm the bottom's rim, or the flank, dips half-way of the moves that arrive at ``row``
    (k,), for the chord of the hub's swing."""
    ring, half = cutter.ring, np.full(len(row), 0.5)
    seat, feed = seat_normal(path, ring, cutter.barrel), feed_direction(path, axis)
    normal, upright = slerp(seat[row - 1], seat[row], half), slerp(axis[row - 1], axis[row], half)
    if (barrel := cutter.barrel) is not None:
        ends = barrel.hub_shift(seat, axis)
        return np.asarray(
            row_dot(barrel.hub_shift(normal, upright) - 0.5 * (ends[row - 1] + ends[row]), normal)
        )
    out = ring_direction(seat, axis, feed, ring)
    chord = 0.5 * (out[row - 1] + out[row])
    sine = np.linalg.norm(np.cross(normal, upright), axis=1)
    return np.asarray(ring * (sine - row_dot(chord, normal)))


def rows_between(
    path: OffsetPath, axis: Floats, pieces: Ints, ring: float, barrel: Flank | None = None
) -> tuple[OffsetPath, Floats, Ints]:
    """Return the move that arrives at each row in ``pieces`` (n,) equal parts (1: as it is): the path, its
    axes, and the row (k,) of the path given that each row is, or leads to. ``ring`` mm of the cutter, or the
    flank of a barrel."""
    row, number = number_runs(pieces)
    share = (number + 1) / pieces[row]
    new = np.flatnonzero(share < 1.0)
    seat = seat_normal(path, ring, barrel) if ring > 0.0 or barrel is not None else None
    return *_with_rows(path, axis, row, new, share[new], seat), row


def keep_rows(path: OffsetPath, rows: Ints) -> OffsetPath:
    """Rows (k,) of a path, ascending; its polylines go on over what is left out."""
    return OffsetPath(**_columns(path, rows), middle=path.middle, findings=path.findings)


def _with_rows(
    path: OffsetPath, axis: Floats, row: Ints, new: Ints, share: Floats, seat: Floats | None
) -> tuple[OffsetPath, Floats]:
    """Rows ``row`` (k,) of the path, those at ``new`` moved to ``share`` of the way from the row before,
    inside its facet, or round its co-edge where both are rows of one contact.

    Corner circles go straight there, along the facet; axis and ``seat`` (n, 3) turn evenly. A ball, which has
    no seat, sits on the facet itself."""
    end, swung = row[new], axis[row]
    start, part = end - 1, share[:, None]
    normal = slerp(seat[start], seat[end], share) if seat is not None else path.before[end]
    columns = _columns(path, row)
    for name in ("point", "centre"):
        given = getattr(path, name)
        columns[name][new] = (1.0 - part) * given[start] + part * given[end]
    columns["normal"][new] = normal
    inside = ~(
        path.fill[end] & (path.point[start] == path.point[end]).all(axis=1)
    )  # at a vertex one contact has two co-edges
    for name in ("before", "after"):
        columns[name][new[inside]] = normal[inside]
    columns["coedge"][new[inside]] = -1
    swung[new] = slerp(axis[start], axis[end], share)
    return OffsetPath(**columns, middle=path.middle, findings=path.findings), swung


# ------------------------------------------------------------------------------------------------ hollows


def _findings_of(path: OffsetPath, hub: Floats, axis: Floats, cutter: Cutter) -> tuple[Finding, ...]:
    """Return what there is to say of a ring in hollows, or of a barrel."""
    if (barrel := cutter.barrel) is not None:
        return _report_off_flank(path, axis, barrel)
    return _heel_findings(path, hub, axis, cutter)


def _report_off_flank(path: OffsetPath, axis: Floats, barrel: Flank) -> tuple[Finding, ...]:
    """Say over which length of the passes it is not the flank that touches."""
    off = ~barrel.touches(seat_normal(path, 0.0, barrel), axis)
    steps, joined = np.linalg.norm(np.diff(path.point, axis=0), axis=1), np.diff(path.polyline) == 0
    length = float(steps[joined & (off[1:] | off[:-1])].sum())
    if length <= NOTABLE:
        return ()
    x, y, z = path.point[int(off.argmax())].tolist()
    text = say(
        "Over {length} of the passes, the first at {place}, the barrel touches with the ball of {corner} at "
        "its tip, not with its flank, and scallops are as high as that ball leaves them. Let the axis lean "
        "by {begins} to {most} from the normal, as with {tilt} {middle}.",
        length=Length(length, ".4g"), place=Point((x, y, z), "g"), corner=Length(barrel.corner),
        tilt=Option("tilt"),
        begins=Angle(math.degrees(barrel.begins), ".1f"), most=Angle(90.0, "g"),
        middle=Angle(math.degrees(barrel.middle), ".0f"),
    )  # fmt: skip
    return (report_finding(Code.OFF_FLANK, text, length, 0.0, place=(x, y, z)),)


def _heel_findings(path: OffsetPath, hub: Floats, axis: Floats, cutter: Cutter) -> tuple[Finding, ...]:
    """Report that it does; how deep is not told, for across the pass the bottom may stand far deeper than
    along it."""
    depth = heel_depth(path, hub, axis, cutter)
    deep = np.flatnonzero(depth > NOTABLE)
    if not len(deep):
        return ()
    worst = int(deep[depth[deep].argmax()])
    x, y, z = path.point[worst].tolist()
    text = say(
        "In hollows along the passes the cutter's bottom stands in the part behind its contact or before "
        "it, over {count} rows; how deep is not known here. Give more lead, take a smaller cutter or a "
        "ball, or have the path checked against the part ({report}), or lifted out of it ({lift}).",
        count=len(deep),
        report=Choice("gouge", ("report",)),
        lift=Choice("gouge", ("lift",)),
    )
    return (report_finding(Code.HEEL_IN_HOLLOW, text, place=(x, y, z)),)


def heel_depth(path: OffsetPath, hub: Floats, axis: Floats, cutter: Cutter) -> Floats:
    """About how deep (n,) mm the bottom stands in the surface along its pass; below 0: how far it stays off.

    The ring's hindmost point is ``ring (out - feed) . normal`` above the plane of the contact, its foremost
    one ``ring (out + feed) . normal``; the surface there rises over that plane by what the pass, unrolled,
    does.
    """
    feed, normal = feed_direction(path, axis), seat_normal(path, cutter.ring)
    out = (hub - path.centre) / cutter.ring
    profile = _Profile.of(path, normal, feed)
    first, last = _ends(path.polyline)
    depth = np.full(len(axis), -np.inf)
    for sense in (-1.0, 1.0):
        way = sense * cutter.ring * (1.0 + sense * row_dot(out, feed))
        there = np.clip(profile.length + way, profile.length[first], profile.length[last])
        rise = (
            np.interp(there, profile.length, profile.height)
            - profile.height
            - profile.slope * (there - profile.length)
        )
        depth = np.maximum(depth, rise - cutter.ring * row_dot(out + sense * feed, normal))
    return depth


class _Profile(NamedTuple):
    """The passes unrolled, one row after the other: ``length`` (n,) mm of all contacts up to each row;
    ``height`` (n,) mm of the surface there, its turns upwards summed up; ``slope`` (n,) rad of the plane on
    which the cutter sits."""

    length: Floats
    height: Floats
    slope: Floats

    @classmethod
    def of(cls, path: OffsetPath, normal: Floats, feed: Floats) -> _Profile:
        """All rows of a contact have its co-edge's whole turn; it counts once."""
        step = np.linalg.norm(np.diff(path.point, axis=0, prepend=path.point[:1]), axis=1)
        slope = np.cumsum(np.where(path.fill, 0.0, -row_dot(path.after - path.before, feed)))
        height = np.cumsum(step * np.append(0.0, slope[:-1]))
        return cls(np.cumsum(step), height, slope + row_dot(path.after - normal, feed))


def _ends(polyline: Ints) -> tuple[Ints, Ints]:
    """First and last row of the polyline of each row."""
    start = np.flatnonzero(np.diff(polyline, prepend=polyline[:1] - 1))
    size = np.diff(start, append=len(polyline))
    return np.repeat(start, size), np.repeat(start + size - 1, size)


# ------------------------------------------------------------------------------------------------ spacing
