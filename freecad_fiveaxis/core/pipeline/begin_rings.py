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
from freecad_fiveaxis.core.passes.ring_starts import begin_at, find_closed, find_start
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .assign_axes import assign_axes, correct_axes, tilt_axes
from .build_path import keep_links_near, lead_in_and_out, lift_path, link_passes
from .context import MillContext
from .plan_passes import keep_off_faces, keep_within_boundary, offset_contacts
from .records import PlannedPasses, SolvedJoints
from .solve_joints import solve_joints

TURN = 2.0 * math.pi
TO_JOINTS: tuple[Callable[[MillContext, Any], Any], ...] = (
    offset_contacts, keep_within_boundary, keep_off_faces, assign_axes, correct_axes, tilt_axes, link_passes,
    lift_path, keep_links_near, lead_in_and_out, solve_joints,
)  # fmt: skip
"""The stages from the passes to the joints; passes that begin elsewhere go through them once more."""


def begin_rings_within_limits(context: MillContext, solved: SolvedJoints) -> SolvedJoints:
    """Begin closed passes elsewhere, where a rotary axis then turns back inside cuts less often."""
    contact = _turn_rings(context, solved)
    if contact is None:
        return solved
    record: Any = PlannedPasses(contact, solved.frame, solved.findings)
    for stage in TO_JOINTS:
        record = stage(context, record)
    joints: JointPath = record.joints
    if (joints.inside, joints.rewinds) >= (solved.joints.inside, solved.joints.rewinds):
        return solved
    found = _report_rings(context, solved.joints.inside, joints.inside)
    turned: SolvedJoints = replace(record, joints=replace(joints, findings=(*joints.findings, found)))
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


def _wide_axis(context: MillContext) -> int | None:
    """Return the column of the rotary axis whose limits hold a turn and not two: with less no ring fits, with
    more each does wherever it begins."""
    width = context.kinematics.high[3:] - context.kinematics.low[3:]
    wide = np.flatnonzero((width >= TURN) & (width < 2.0 * TURN))
    return 3 + int(wide[0]) if len(wide) else None


def _words_at(joints: JointPath, contact: ContactPath, axis: int) -> Floats:
    """Return the word (n,), rad, of one axis at each contact: of the row that cuts nearest to it, on the same
    facet where several are at one place."""
    path = joints.path
    cuts = np.flatnonzero((path.pass_ >= 0) & (path.motion < Motion.LINK))
    tree = scipy.spatial.cKDTree(np.column_stack([path.contact[cuts], path.normal[cuts]]))
    nearest: Ints = tree.query(np.column_stack([contact.point, contact.normal]))[1]
    return np.asarray(joints.q[cuts[nearest], axis])


def _report_rings(context: MillContext, before: int, after: int) -> Finding:
    """Say that closed passes begin elsewhere, and what that spares."""
    text = say(
        "Closed passes begin where {letter} has room for their whole turn within its limits: inside cuts it "
        "turns back {after} times instead of {before}.",
        letter=context.kinematics.letters[_wide_axis(context) or 3],
        after=after,
        before=before,
    )
    return report_finding(Code.RINGS_BEGUN_ELSEWHERE, text, float(before - after), unit="1")
