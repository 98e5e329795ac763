# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stage that begins closed passes elsewhere, where a rotary axis would have to turn back inside them."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import scipy

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Ints
from freecad_fiveaxis.core.base.sentences import plural, say
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.orientation.order_with_axes import order_by_time
from freecad_fiveaxis.core.passes import ContactPath
from freecad_fiveaxis.core.passes.ring_chain import TURNING
from freecad_fiveaxis.core.passes.ring_starts import (
    begin_at,
    find_closed,
    find_sense,
    find_start,
    find_turn,
    reverse,
)
from freecad_fiveaxis.core.toolpath.cl_path import Motion
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

from .assign_axes import assign_axes, correct_axes, tilt_axes
from .build_path import keep_links_near, lead_in_and_out, lift_path, link_passes
from .context import MillContext
from .plan_passes import keep_off_faces, keep_within_boundary, offset_contacts
from .records import AssignedAxes, PlannedPasses, SolvedJoints
from .ring_chains import chain_rings
from .solve_joints import solve_joints

TURN = 2.0 * math.pi
Begun = tuple[ContactPath, Code]
"""Passes whose rings begin elsewhere or run the other way round, and the code that says which."""
RAPID = 0.1
"""Way at feed, mm, that takes as long as a mm of a rapid, about."""
SPARED = 30.0
"""Way at feed, mm, that is worth going to spare a turn back, besides that of the turn itself."""
TO_JOINTS: tuple[Callable[[MillContext, Any], Any], ...] = (
    offset_contacts, keep_within_boundary, keep_off_faces, assign_axes, correct_axes, tilt_axes, link_passes,
    lift_path, keep_links_near, lead_in_and_out, solve_joints,
)  # fmt: skip
"""The stages from the passes to the joints; passes that begin elsewhere go through them once more."""


def begin_rings_within_limits(context: MillContext, solved: SolvedJoints) -> SolvedJoints:
    """Begin closed passes elsewhere, and run some the other way round, where a rotary axis then turns back
    less often."""
    best, spared = solved, dict[Code, tuple[JointPath, JointPath]]()
    for change in (_turn_rings, _reverse_rings, _chain_rings, _chain_rings):
        begun = change(context, best) if best.joints.rewinds else None
        if begun is None:
            continue
        contact, code = begun
        other = _solve_again(context, best, contact, change is _chain_rings)
        if _turns_back(other) < _turns_back(best) and (change is not _chain_rings or _is_worth(other, best)):
            spared[code] = (spared.get(code, (best.joints, best.joints))[0], other.joints)
            best = other
        elif change is _chain_rings:
            break  # the next would be the same
    found = [REPORTS[code](context, *joints) for code, joints in spared.items()]
    return replace(best, joints=replace(best.joints, findings=(*best.joints.findings, *found)))


def _solve_again(
    context: MillContext, solved: SolvedJoints, contact: ContactPath, ordered: bool
) -> SolvedJoints:
    """Return the joints of other passes, made by all stages from the passes on; ``ordered``: cut in the order
    of before, for a tour between them would part what follows one another."""
    record: Any = PlannedPasses(contact, solved.frame, solved.findings)
    within = _without_tour(context) if ordered else context
    for stage in TO_JOINTS:
        record = stage(within, record)
        if ordered and stage is assign_axes:
            record = _order_as_before(record, solved.joints)
    again: SolvedJoints = record
    return again


def _without_tour(context: MillContext) -> MillContext:
    """Return the same for passes that stay in the order they are in."""
    settings = context.settings
    return replace(context, settings=replace(settings, links=replace(settings.links, order="one_way")))


def _order_as_before(passes: AssignedAxes, joints: JointPath) -> AssignedAxes:
    """Return the passes in the order in which joints of before cut the same places."""
    when = _rows_at(joints, passes.cut)
    cut, axis = order_by_time(passes.cut, passes.corrected, when)
    return replace(passes, cut=cut, corrected=axis)


def _turns_back(solved: SolvedJoints) -> tuple[int, int]:
    return solved.joints.inside, solved.joints.rewinds


def _is_worth(other: SolvedJoints, best: SolvedJoints) -> bool:
    """Return whether passes that turn back less often are the better ones: with fewer marks always, else
    where the way between the cuts, with the turns back, takes hardly longer."""
    spared = best.joints.rewinds - other.joints.rewinds
    more = _air(other.joints) - _air(best.joints)
    return other.joints.inside < best.joints.inside or more <= SPARED * spared


def _air(joints: JointPath) -> float:
    """Return the way, mm at feed, between the cuts: rapids count for less, but turn their axes."""
    motion, way = joints.path.motion[1:], np.linalg.norm(np.diff(joints.path.tip, axis=0), axis=1)
    turn = TURNING * np.abs(np.diff(joints.q[:, 3:], axis=0)).max(axis=1)
    rapid = np.maximum(RAPID * way, turn)[motion == Motion.RAPID]
    return float(way[motion == Motion.LINK].sum() + rapid.sum())


def _chain_rings(context: MillContext, solved: SolvedJoints) -> Begun | None:
    """Return the passes with each ring begun, and run, so that the axis goes on from the one before it; None
    where nothing is to be gained."""
    axis = _axis_with_limits(context)
    if axis is None:
        return None
    rows = _rows_at(solved.joints, solved.contact)
    chained = chain_rings(context, solved, rows, axis)
    if chained is None:
        return None
    return chained[0], Code.RINGS_REVERSED if chained[1] else Code.RINGS_BEGUN_ELSEWHERE


def _turn_rings(context: MillContext, solved: SolvedJoints) -> Begun | None:
    """Return the passes with their rings begun where they fit best; None where nothing is to be gained."""
    axis = _wide_axis(context)
    closed = np.empty((0, 2), np.int64) if axis is None else find_closed(solved.contact, context.keep)
    if axis is None or not len(closed):
        return None
    low, high = context.kinematics.low[axis], context.kinematics.high[axis]
    words = solved.joints.q[_rows_at(solved.joints, solved.contact), axis]
    start = np.array([find_start(words[first:behind], low, high) for first, behind in closed.tolist()])
    if not (start > 0).any():
        return None
    return begin_at(solved.contact, closed[start > 0], start[start > 0]), Code.RINGS_BEGUN_ELSEWHERE


def _reverse_rings(context: MillContext, solved: SolvedJoints) -> Begun | None:
    """Return the passes with rings reversed, so that the axis turns to and fro from one to the next; None
    where the passes are to run all one way, or nothing is to be gained."""
    axis = _wide_axis(context)
    if axis is None or context.settings.links.order != "zigzag":
        return None
    closed = find_closed(solved.contact, context.keep)
    when = _rows_at(solved.joints, solved.contact)
    words = solved.joints.q[when, axis]
    turn = np.array(
        [find_turn(words[first:behind]) * find_sense(when[first:behind]) for first, behind in closed.tolist()]
    )
    begun = np.array([when[first:behind].min() for first, behind in closed.tolist()])
    rings = np.flatnonzero(np.abs(turn) > math.pi)
    rings = rings[np.argsort(begun[rings], kind="stable")] if len(rings) else rings
    wrong = np.sign(turn[rings]) != np.sign(turn[rings[:1]]) * (-1.0) ** np.arange(len(rings))
    return (reverse(solved.contact, closed[rings[wrong]]), Code.RINGS_REVERSED) if wrong.any() else None


def _wide_axis(context: MillContext) -> int | None:
    """Return the column of the rotary axis whose limits hold a turn and not two: with less no ring fits, with
    more each does wherever it begins."""
    width = context.kinematics.high[3:] - context.kinematics.low[3:]
    wide = np.flatnonzero((width >= TURN) & (width < 2.0 * TURN))
    return 3 + int(wide[0]) if len(wide) else None


def _axis_with_limits(context: MillContext) -> int | None:
    """Return the column of the first rotary axis with limits that hold a turn."""
    width = context.kinematics.high[3:] - context.kinematics.low[3:]
    limited = np.flatnonzero((width >= TURN) & np.isfinite(width))
    return 3 + int(limited[0]) if len(limited) else None


def _rows_at(joints: JointPath, contact: ContactPath | OffsetPath) -> Ints:
    """Return the row (n,) that cuts nearest to each contact, on the same facet where several are at one
    place."""
    path = joints.path
    cuts = np.flatnonzero((path.pass_ >= 0) & (path.motion < Motion.LINK))
    tree = scipy.spatial.cKDTree(np.column_stack([path.contact[cuts], path.normal[cuts]]))
    nearest: Ints = tree.query(np.column_stack([contact.point, contact.normal]))[1]
    return np.asarray(cuts[nearest])


def _report_rings(context: MillContext, before: JointPath, after: JointPath) -> Finding:
    """Say that closed passes begin elsewhere, and what that spares."""
    letter = context.kinematics.letters[_axis_with_limits(context) or 3]
    begin = say("Closed passes begin where {letter} has room for them within its limits.", letter=letter)
    return _report_spared(Code.RINGS_BEGUN_ELSEWHERE, begin, letter, before, after)


def _report_reversed(context: MillContext, before: JointPath, after: JointPath) -> Finding:
    """Say that closed passes run the other way round, and what that spares."""
    letter = context.kinematics.letters[_axis_with_limits(context) or 3]
    begin = say(
        "Closed passes run by turns one way round and the other, so that {letter} goes to and fro within its "
        "limits.",
        letter=letter,
    )
    return _report_spared(Code.RINGS_REVERSED, begin, letter, before, after)


def _report_spared(code: Code, begin: str, letter: str, before: JointPath, after: JointPath) -> Finding:
    """Say how often the axis still turns back: inside cuts where that has changed, else between them too."""
    if after.inside < before.inside:
        times, was = after.inside, before.inside
        text = _say_inside(times, was, letter)
    else:
        times, was = after.rewinds, before.rewinds
        text = _say_times(times, was, letter)
    return report_finding(code, say("{begin} {text}", begin=begin, text=text), float(was - times), unit="1")


def _say_inside(times: int, before: int, letter: str) -> str:
    """Say how often the axis turns back inside cuts."""
    if not times:
        return plural(
            before,
            "{letter} no longer turns back inside a cut, as it had to once.",
            "{letter} no longer turns back inside cuts, as it had to {count} times.",
            letter=letter,
        )
    return plural(
        times,
        "{letter} turns back inside a cut once instead of {before} times.",
        "{letter} turns back inside cuts {count} instead of {before} times.",
        letter=letter,
        before=before,
    )


def _say_times(times: int, before: int, letter: str) -> str:
    """Say how often the axis turns back."""
    if not times:
        return plural(
            before,
            "{letter} no longer turns back, as it had to once.",
            "{letter} no longer turns back, as it had to {count} times.",
            letter=letter,
        )
    return plural(
        times,
        "{letter} turns back once instead of {before} times.",
        "{letter} turns back {count} instead of {before} times.",
        letter=letter,
        before=before,
    )


REPORTS: dict[Code, Callable[[MillContext, JointPath, JointPath], Finding]] = {
    Code.RINGS_BEGUN_ELSEWHERE: _report_rings,
    Code.RINGS_REVERSED: _report_reversed,
}
"""What is said of passes that were changed: of the joints before and after."""
