# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows that a joint path needs besides those of the CL path: rewinds at breaks, and rapids cut into blocks.

rewind    retract along the tool axis out of the part, rise above it, turn the rotary axes there, come down
          and re-engage along the tool axis. The tool leaves where the old words reach their limit and
          re-enters where the new ones are within theirs: at the same place wherever both are.
rapid     its tip goes straight and its rotary words go evenly, the tip put back on its chord at every block's
          end. Between the ends the real tip leaves the chord;
          :mod:`~freecad_fiveaxis.core.motion.deviation.bound` proves by how much at most.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.chunks import in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Insertion, Ints
from freecad_fiveaxis.core.base.sentences import Angle, Length, plural, say
from freecad_fiveaxis.core.base.vectors import slerp
from freecad_fiveaxis.core.machine.kinematics import (
    Chain,
    branch_of,
    forward,
    inverse_axis,
    joint_words,
    q_to_words,
)
from freecad_fiveaxis.core.motion.deviation import quick_bound
from freecad_fiveaxis.core.tool.body import Body
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion, tool_keepout, way_out

from .branches import POLE_ANGLE, SLACK, TURN

STILL = 1e-12
"""Rotary travel (rad) below which a rapid is straight: at a lever of 1 m the tip leaves its chord by 1e-9
mm."""
SAME_PLACE = 1e-9
"""Share of a step below which two places on it are one."""
HALVINGS = 50
"""Steps of bisection: they leave 1e-15 of the step."""
ROUND = (
    Motion.CUT,
    Motion.LINK,
    Motion.RAPID,
    Motion.RAPID,
    Motion.RAPID,
    Motion.RAPID,
    Motion.RAPID,
    Motion.LINK,
)
"""Motions to the tips of a rewind: leave, clear of the part, beside it, above it; turned there, beside,
clear, enter."""
NO_ROOM = np.radians(0.1)
"""Room (rad) that an axis has beyond a cut below which no place to begin it is found."""
LISTED = 20
"""Rewinds that get a finding of their own; one more finding gives the number of all."""


@dataclass(frozen=True, eq=False)
class Drive:
    """A CL path and how it is driven: ``row`` (n,) of the given path that each row leads to; rotary words
    ``angles`` (n, 2) rad; ``branch`` (n,)."""

    path: CLPath
    row: Ints
    angles: Floats
    branch: Bytes


@dataclass(frozen=True, eq=False)
class Place:
    """Where the tool leaves or re-enters each broken step: ``share`` (b,) of the step, ``tip``, ``axis`` (b,
    3), ``angles`` (b, 2)."""

    share: Floats
    tip: Floats
    axis: Floats
    angles: Floats


def insert_rewinds(
    drive: Drive,
    kinematics: Chain,
    breaks: Ints,
    low: Floats,
    high: Floats,
    clearance: float,
    radius: float,
    tool: Body,
) -> tuple[Drive, Floats]:
    """Retract, rewind and re-engage within each step of ``breaks`` (b,), the steps' first rows.

    ``low``, ``high`` (3,) mm: the part's box; ``radius`` mm of the ball; ``tool`` as seen from the driven
    point. Returns the longer drive and the lengths (b,) mm that stay uncut because neither the old nor the
    new words reach them.
    """
    if len(breaks) == 0:
        return drive, np.empty(0)
    leave, enter = _places(drive, kinematics, breaks)
    tip, keep = _way_round(drive.path, leave, enter, low, high, clearance, radius, tool)
    motion = np.broadcast_to(np.array(ROUND, np.int8), keep.shape)
    axis, angles = (
        np.repeat(np.stack(pair, 1), 4, axis=1)
        for pair in ((leave.axis, enter.axis), (leave.angles, enter.angles))
    )
    contact = tip.copy()
    contact[:, 0] = _part_way(drive.path.contact, breaks, leave.share)
    at = np.broadcast_to(breaks[:, None] + 1, keep.shape)
    uncut = np.linalg.norm(enter.tip - leave.tip, axis=1)
    longer = insert_rows(
        _enter_by_link(drive, breaks, enter),
        kinematics,
        at[keep],
        tip[keep],
        axis[keep],
        angles[keep],
        motion[keep],
        contact[keep],
    )
    return longer, np.where(enter.share - leave.share > SAME_PLACE, uncut, 0.0)


def _places(drive: Drive, kinematics: Chain, breaks: Ints) -> tuple[Place, Place]:
    """Leave where the old words' reach ends, or where the new words' begins if that is earlier; enter where
    that begins."""
    old_reach = _reach(drive, kinematics, breaks, 0)
    new_reach = _reach(drive, kinematics, breaks, 1)
    shares = (np.minimum(old_reach, new_reach), new_reach)
    places = []
    for end, share in enumerate(shares):
        angles = np.clip(
            _follow(drive, kinematics, breaks, share, end), kinematics.low[3:], kinematics.high[3:]
        )
        places.append(
            Place(
                share, _part_way(drive.path.tip, breaks, share), _axis_at(drive.path, breaks, share), angles
            )
        )
    return places[0], places[1]


def _reach(drive: Drive, kinematics: Chain, breaks: Ints, end: int) -> Floats:
    """How far along the step, seen from its ``end`` (0 or 1), that end's words stay within the rotary limits:
    a share (b,)."""

    def fits(share: Floats) -> Bools:
        angles = _follow(drive, kinematics, breaks, share, end)
        return np.asarray(
            ((angles >= kinematics.low[3:] - SLACK) & (angles <= kinematics.high[3:] + SLACK)).all(1)
        )

    inside = np.full(len(breaks), float(end))
    outside = 1.0 - inside
    whole = fits(outside)
    inside[whole] = outside[whole]
    for _ in range(HALVINGS):
        middle = 0.5 * (inside + outside)
        good = fits(middle)
        inside, outside = np.where(good, middle, inside), np.where(good, outside, middle)
    return inside


def _follow(drive: Drive, kinematics: Chain, breaks: Ints, share: Floats, end: int) -> Floats:
    """Rotary words (b, 2) at a share of the step, on the branch and next to the words of its ``end``; NaN out
    of reach."""
    axis = _axis_at(drive.path, breaks, share)
    known = drive.angles[breaks + end]
    angles = inverse_axis(kinematics, axis)[0][drive.branch[breaks + end], np.arange(len(breaks))]
    angles += TURN * np.rint((known - angles) / TURN)
    pole = np.linalg.norm(np.cross(axis, kinematics.direction[3]), axis=1) <= POLE_ANGLE
    angles[pole, 0] = known[pole, 0]
    return np.asarray(angles)


def _axis_at(path: CLPath, breaks: Ints, share: Floats) -> Floats:
    """Return the commanded axis (b, 3) at a share of the step: along the great arc (slerp)."""
    return slerp(path.axis[breaks], path.axis[breaks + 1], share)


def _part_way(points: Floats, breaks: Ints, share: Floats) -> Floats:
    return np.asarray(points[breaks] + share[:, None] * (points[breaks + 1] - points[breaks]))


def _way_round(
    path: CLPath,
    leave: Place,
    enter: Place,
    low: Floats,
    high: Floats,
    clearance: float,
    radius: float,
    tool: Body,
) -> tuple[Floats, Bools]:
    """Eight tips (b, 8, 3) of each rewind, from leave to enter as in ROUND; and which of them are needed (b,
    8).

    The part's box grows by the clearance and by the ball's diameter: from the driven point, be it tip or
    centre, the ball reaches no further; shank and holder may. The rapids' height is kept where it is higher.
    """
    own, its = (
        tool_keepout(low, high, 2.0 * radius, clearance, tool, place.axis) for place in (leave, enter)
    )
    rapids = float(path.tip[path.motion == Motion.RAPID, 2].max())
    safe = np.maximum(np.maximum(own.safe, its.safe), rapids)
    out = way_out(leave.tip, leave.axis, own._replace(safe=safe))
    back = way_out(enter.tip, enter.axis, its._replace(safe=safe))
    tip = np.concatenate([leave.tip[:, None], out.station, back.station[:, ::-1], enter.tip[:, None]], 1)
    needed = np.ones((len(tip), 8), bool)
    needed[:, 0] = leave.share > SAME_PLACE
    needed[:, 1:4] = out.needed
    needed[:, 5:8] = back.needed[:, ::-1]
    needed[:, 7] &= enter.share < 1.0 - SAME_PLACE
    return tip, needed


def _enter_by_link(drive: Drive, breaks: Ints, enter: Place) -> Drive:
    """Where the new words begin at the step's end only, the row there is reached by the re-engaging link
    itself."""
    whole = enter.share >= 1.0 - SAME_PLACE
    motion = drive.path.motion.copy()
    motion[breaks[whole] + 1] = Motion.LINK
    return replace(drive, path=replace(drive.path, motion=motion))


def insert_rows(
    drive: Drive,
    kinematics: Chain,
    at: Ints,
    tip: Floats,
    axis: Floats,
    angles: Floats,
    motion: Bytes,
    contact: Floats,
) -> Drive:
    """Put rows in before the rows ``at`` (m,), which ascend: ``tip``, ``axis``, ``contact`` (m, 3),
    ``angles`` (m, 2) rad.

    Links and rapids touch nothing; other rows cut what the row that they lead to cuts.
    """
    path = drive.path
    cuts = motion < Motion.LINK
    new: dict[str, Any] = {
        "tip": tip,
        "axis": axis,
        "motion": np.where(cuts, path.motion[at], motion),
        "feed": np.where(motion == Motion.RAPID, 0.0, path.feed[at]),
        "contact": contact,
        "normal": np.where(cuts[:, None], path.normal[at], axis),
    }
    new |= {name: np.where(cuts, getattr(path, name)[at], -1) for name in ("face", "coedge", "pass_")}
    put = Insertion(len(drive.row), at)
    columns = in_threads(lambda name: put.interleave(getattr(path, name), new[name]), list(new))
    longer = replace(path, **dict(zip(new, columns, strict=True)))
    branch = put.interleave(drive.branch, branch_of(kinematics, angles[:, 1]))
    return Drive(
        longer,
        put.interleave(drive.row, drive.row.take(put.source)),
        put.interleave(drive.angles, angles),
        branch,
    )


def subdivide_rapids(drive: Drive, kinematics: Chain, tolerance: float) -> Drive:
    """Cut rapids that turn a rotary axis until the real tip provably stays within ``tolerance`` (mm) of the
    chord."""
    arrival = np.flatnonzero(drive.path.motion[1:] == Motion.RAPID) + 1
    arrival = arrival[np.abs(drive.angles[arrival] - drive.angles[arrival - 1]).sum(1) > STILL]
    pieces = np.ones(len(arrival), np.int64)
    todo = np.arange(len(arrival))
    while len(todo):
        tip, angles, first = _evenly(drive, arrival[todo], pieces[todo])
        bound = quick_bound(kinematics, q_to_words(joint_words(kinematics, tip, angles)))
        bound[first] = 0.0  # from the end of one rapid to the start of the next
        worst = np.maximum.reduceat(bound, first)
        todo, worst = todo[worst > tolerance], worst[worst > tolerance]
        pieces[todo] = np.maximum(
            pieces[todo] + 1, np.ceil(pieces[todo] * np.sqrt(worst / tolerance)).astype(np.int64)
        )
    arrival, pieces = arrival[pieces > 1], pieces[pieces > 1]
    if len(arrival) == 0:
        return drive
    tip, angles, first = _evenly(drive, arrival, pieces)
    inner = np.ones(len(tip), bool)
    inner[first] = inner[first + pieces] = False
    tip, angles, at = tip[inner], angles[inner], np.repeat(arrival, pieces - 1)
    axis = forward(kinematics, np.column_stack([np.zeros_like(tip), angles]))[1]
    return insert_rows(drive, kinematics, at, tip, axis, angles, np.full(len(at), Motion.RAPID, np.int8), tip)


def _evenly(drive: Drive, arrival: Ints, pieces: Ints) -> tuple[Floats, Floats, Ints]:
    """Tips and rotary words at the ends of equal pieces of each step, both step ends included, and where each
    step begins."""
    count = pieces + 1
    first = np.cumsum(count) - count
    share = ((np.arange(int(count.sum())) - np.repeat(first, count)) / np.repeat(pieces, count))[:, None]
    end = np.repeat(arrival, count)
    tip, angles = (
        (1.0 - share) * values[end - 1] + share * values[end] for values in (drive.path.tip, drive.angles)
    )
    return tip, angles, first


def rewind_findings(
    given: Drive,
    driven: Drive,
    kinematics: Chain,
    breaks: Ints,
    uncut: Floats,
    cutting: Bools,
    between: Bools,
) -> tuple[Finding, ...]:
    """Return a warning for each of the first breaks inside cuts, one with their number, a note with the
    number of those between cuts, and a warning for what they leave uncut. ``cutting`` (n - 1,): steps of
    ``given`` on which the words cannot jump; ``between`` (n - 1,): those that touch nothing."""
    findings = []
    inside, stays = breaks[~between[breaks]], cutting & ~between
    for step in inside[:LISTED].tolist():
        block = int(np.searchsorted(driven.row, step + 1))
        before, after = np.degrees(given.angles[step : step + 2])
        axis = int(np.abs(after - before).argmax())
        text = say(
            "{letter} has to turn back from {before} to {after} inside a cut: the tool retracts, turns "
            "above the part and re-engages, which may leave a mark. {remedy}",
            letter=kinematics.letters[3 + axis],
            before=Angle(before[axis], ".3f", bare=True),
            after=Angle(after[axis], ".3f"),
            remedy=_say_remedy(
                kinematics, 3 + axis, _whole_turn(given, kinematics, breaks, stays, step, axis)
            ),
        )
        place = _point(given.path.tip[step])
        findings.append(
            report_finding(Code.REWIND, text, float(abs(after - before)[axis]), block=block, place=place)
        )
    if len(inside) > 1:
        text = say(
            "The rotary limits make the tool retract, turn back and re-engage inside cuts, {count} times.",
            count=len(inside),
        )
        findings.append(
            replace(findings[0], code=Code.REWINDS, text=text, value=float(len(inside)), unit="1")
        )
    findings += _report_between(given, driven, kinematics, breaks[between[breaks]])
    if (uncut > 0.0).any():
        worst = int(uncut.argmax())
        text = say(
            "{length} of the path stay uncut at {count} rewinds: on neither side of them do the rotary "
            "limits allow the tool axis that is needed. Wider limits or another setup avoid it.",
            length=Length(uncut.sum(), ".4f"),
            count=int((uncut > 0.0).sum()),
        )
        place = _point(given.path.tip[breaks[worst]])
        block = int(np.searchsorted(driven.row, breaks[worst] + 1))
        findings.append(
            report_finding(Code.UNCUT, text, float(uncut[worst]), 0.0, block, place=place, unit="mm")
        )
    return tuple(findings)


def _report_between(given: Drive, driven: Drive, kinematics: Chain, breaks: Ints) -> list[Finding]:
    """Say how many of the ``breaks`` (b,) lie between two cuts, where they harm nothing."""
    if not len(breaks):
        return []
    step = int(breaks[0])
    axis = int(np.abs(given.angles[step + 1] - given.angles[step]).argmax())
    text = plural(
        len(breaks),
        "Once the tool retracts between two cuts and {letter} turns back above the part, within its limits: "
        "that takes time and leaves no mark.",
        "{count} times the tool retracts between two cuts and {letter} turns back above the part, within its "
        "limits: that takes time and leaves no mark.",
        letter=kinematics.letters[3 + axis],
    )
    block, place = int(np.searchsorted(driven.row, step + 1)), _point(given.path.tip[step])
    return [report_finding(Code.REWINDS_BETWEEN_CUTS, text, float(len(breaks)), block=block, place=place)]


def _whole_turn(given: Drive, kinematics: Chain, breaks: Ints, stays: Bools, step: int, axis: int) -> float:
    """How far, rad, a rotary word spans along the cut that has the break, if it goes on in place of turning
    back. ``stays`` (n - 1,): steps of cuts."""
    free = np.flatnonzero(~stays)
    at = int(np.searchsorted(free, step))
    rows = slice(int(free[at - 1]) + 1 if at else 0, int(free[at]) + 1 if at < len(free) else None)
    word = _words_going_on(given, kinematics, breaks, rows, axis)
    turn = np.diff(word)
    turn -= TURN * np.rint(turn / TURN)
    return float(np.ptp(np.concatenate([[0.0], np.cumsum(turn)])))


def _words_going_on(given: Drive, kinematics: Chain, breaks: Ints, rows: slice, axis: int) -> Floats:
    """Return a rotary word at the ``rows``, but for whole turns, as if no break changed the branch; without
    rows at the pole where one does."""
    branch, tool = given.branch[rows], given.path.axis[rows]
    begin = rows.start
    within = breaks[(breaks >= begin) & (breaks < begin + len(branch) - 1)] - begin
    changes = np.zeros(len(branch), np.bool_)
    changes[within + 1] = branch[within + 1] != branch[within]
    other = np.flatnonzero(np.cumsum(changes) % 2)
    word = given.angles[rows, axis].copy()
    word[other] = inverse_axis(kinematics, tool[other])[0][1 - branch[other], np.arange(len(other)), axis]
    pole = np.linalg.norm(np.cross(tool[other], kinematics.direction[3]), axis=1) <= POLE_ANGLE
    word[other[pole]] = np.nan
    return np.asarray(word[~np.isnan(word)])


def _say_remedy(kinematics: Chain, axis: int, whole: float) -> str:
    """Say what avoids a rewind, and whether the axis is too short for the path or only lies otherwise.
    ``whole`` rad as :func:`_whole_turn` gives it."""
    width = float(kinematics.high[axis] - kinematics.low[axis])
    if not np.isfinite(width):
        return say("Wider limits or another setup avoid it.")
    given = {"letter": kinematics.letters[axis], "whole": Angle(np.degrees(whole), ".1f", bare=True)}
    if whole > width - NO_ROOM:
        return say(
            "In this cut {letter} takes {whole} and has {width}: wider limits or shorter passes avoid it.",
            width=Angle(np.degrees(width), ".1f"),
            **given,
        )
    return say(
        "In this cut {letter} takes {whole} and has {width}, but begins where that does not fit: the part "
        "turned about {letter}, or limits that lie otherwise, avoid it.",
        width=Angle(np.degrees(width), ".1f"),
        **given,
    )


def _point(tip: Floats) -> tuple[float, float, float]:
    x, y, z = tip.tolist()
    return x, y, z
