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
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.passes import ContactPath
from freecad_fiveaxis.core.passes.ring_starts import begin_at, find_closed, find_start, find_turn, reverse
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .assign_axes import assign_axes, correct_axes, tilt_axes
from .build_path import keep_links_near, lead_in_and_out, lift_path, link_passes
from .context import MillContext
from .plan_passes import keep_off_faces, keep_within_boundary, offset_contacts
from .records import PlannedPasses, SolvedJoints
from .solve_joints import solve_joints

TURN = 2.0 * math.pi
Report = Callable[[MillContext, JointPath, JointPath], Finding]
"""What is said of passes that were changed: the joints before and after."""
TO_JOINTS: tuple[Callable[[MillContext, Any], Any], ...] = (
    offset_contacts, keep_within_boundary, keep_off_faces, assign_axes, correct_axes, tilt_axes, link_passes,
    lift_path, keep_links_near, lead_in_and_out, solve_joints,
)  # fmt: skip
"""The stages from the passes to the joints; passes that begin elsewhere go through them once more."""


def begin_rings_within_limits(context: MillContext, solved: SolvedJoints) -> SolvedJoints:
    """Begin closed passes elsewhere, and run some the other way round, where a rotary axis then turns back
    less often."""
    begun = _take_better(context, solved, _turn_rings(context, solved), _report_rings)
    return _take_better(context, begun, _reverse_rings(context, begun), _report_reversed)


def _take_better(
    context: MillContext, solved: SolvedJoints, contact: ContactPath | None, report: Report
) -> SolvedJoints:
    """Return the joints of other passes and what ``report`` says of them, where the axis then turns back less
    often; else, and where there are none, the ``solved`` ones."""
    if contact is None:
        return solved
    record: Any = PlannedPasses(contact, solved.frame, solved.findings)
    for stage in TO_JOINTS:
        record = stage(context, record)
    joints: JointPath = record.joints
    if (joints.inside, joints.rewinds) >= (solved.joints.inside, solved.joints.rewinds):
        return solved
    kept = [one for one in solved.joints.findings if one.code is Code.RINGS_BEGUN_ELSEWHERE]
    found = (*joints.findings, *kept, report(context, solved.joints, joints))
    turned: SolvedJoints = replace(record, joints=replace(joints, findings=found))
    return turned


def _turn_rings(context: MillContext, solved: SolvedJoints) -> ContactPath | None:
    """Return the passes with their rings begun where they fit best; None where nothing is to be gained."""
    axis = _wide_axis(context) if solved.joints.rewinds else None
    closed = np.empty((0, 2), np.int64) if axis is None else find_closed(solved.contact, context.keep)
    if axis is None or not len(closed):
        return None
    low, high = context.kinematics.low[axis], context.kinematics.high[axis]
    words = _words_at(solved.joints, solved.contact, axis)
    start = np.array([find_start(words[first:behind], low, high) for first, behind in closed.tolist()])
    return begin_at(solved.contact, closed[start > 0], start[start > 0]) if (start > 0).any() else None


def _reverse_rings(context: MillContext, solved: SolvedJoints) -> ContactPath | None:
    """Return the passes with rings reversed, so that the axis turns to and fro from one to the next; None
    where the passes are to run all one way, or nothing is to be gained."""
    axis = _wide_axis(context) if solved.joints.rewinds else None
    if axis is None or context.settings.links.order != "zigzag":
        return None
    closed = find_closed(solved.contact, context.keep)
    words, when = _words_at(solved.joints, solved.contact, axis), _rows_at(solved.joints, solved.contact)
    turn = np.array(
        [find_turn(words[first:behind]) * _sense(when[first:behind]) for first, behind in closed.tolist()]
    )
    begun = np.array([when[first:behind].min() for first, behind in closed.tolist()])
    rings = np.flatnonzero(np.abs(turn) > math.pi)
    rings = rings[np.argsort(begun[rings], kind="stable")] if len(rings) else rings
    wrong = np.sign(turn[rings]) != np.sign(turn[rings[:1]]) * (-1.0) ** np.arange(len(rings))
    return reverse(solved.contact, closed[rings[wrong]]) if wrong.any() else None


def _sense(rows: Ints) -> float:
    """Return 1.0 where contacts are cut in their order, by the ``rows`` (n,) that cut them, and -1.0 where a
    later stage has turned them round, as the tour of the pieces does."""
    return float(np.sign(np.sign(np.diff(rows)).sum()))


def _wide_axis(context: MillContext) -> int | None:
    """Return the column of the rotary axis whose limits hold a turn and not two: with less no ring fits, with
    more each does wherever it begins."""
    width = context.kinematics.high[3:] - context.kinematics.low[3:]
    wide = np.flatnonzero((width >= TURN) & (width < 2.0 * TURN))
    return 3 + int(wide[0]) if len(wide) else None


def _words_at(joints: JointPath, contact: ContactPath, axis: int) -> Floats:
    """Return the word (n,), rad, of one axis at each contact."""
    return np.asarray(joints.q[_rows_at(joints, contact), axis])


def _rows_at(joints: JointPath, contact: ContactPath) -> Ints:
    """Return the row (n,) that cuts nearest to each contact, on the same facet where several are at one
    place."""
    path = joints.path
    cuts = np.flatnonzero((path.pass_ >= 0) & (path.motion < Motion.LINK))
    tree = scipy.spatial.cKDTree(np.column_stack([path.contact[cuts], path.normal[cuts]]))
    nearest: Ints = tree.query(np.column_stack([contact.point, contact.normal]))[1]
    return np.asarray(cuts[nearest])


def _report_rings(context: MillContext, before: JointPath, after: JointPath) -> Finding:
    """Say that closed passes begin elsewhere, and what that spares."""
    letter = context.kinematics.letters[_wide_axis(context) or 3]
    if after.inside == before.inside:
        text, spared = say(
            "Closed passes begin where {letter} has room for their whole turn within its limits: it turns "
            "back {after} instead of {before} times.",
            letter=letter, after=after.rewinds, before=before.rewinds,
        ), before.rewinds - after.rewinds  # fmt: skip
    else:
        text, spared = say(
            "Closed passes begin where {letter} has room for their whole turn within its limits: inside cuts "
            "it turns back {after} instead of {before} times.",
            letter=letter, after=after.inside, before=before.inside,
        ), before.inside - after.inside  # fmt: skip
    return report_finding(Code.RINGS_BEGUN_ELSEWHERE, text, float(spared), unit="1")


def _report_reversed(context: MillContext, before: JointPath, after: JointPath) -> Finding:
    """Say that closed passes run the other way round, and what that spares."""
    text = say(
        "Closed passes run by turns one way round and the other, so that {letter} goes to and fro within its "
        "limits: it turns back {after} instead of {before} times.",
        letter=context.kinematics.letters[_wide_axis(context) or 3],
        after=after.rewinds,
        before=before.rewinds,
    )
    return report_finding(Code.RINGS_REVERSED, text, float(before.rewinds - after.rewinds), unit="1")
