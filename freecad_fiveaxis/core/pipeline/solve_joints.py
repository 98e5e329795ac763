# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stages from the CL path to the program: joints, blocks divided where the machine leaves the path, rapids
kept clear, NC."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.records import Ints
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge import real_motion, straight_motion, which_enter
from freecad_fiveaxis.core.links.divide_rapids import RapidClearance, divide_rapids
from freecad_fiveaxis.core.machine.kinematics import q_to_words
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.tool.body import CUTTER
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .below_part import count_below_part, report_dip
from .collision_avoidance import (
    compute_commanded_motion,
    find_uncut,
    leaves_out,
    tells_of_less,
)
from .context import MillContext
from .driving import drive, post_path
from .options import (
    compute_driven_to_hub,
    compute_driven_to_surface,
    rapids_of,
    steps_over_strips,
    tip_to_driven,
    tool_body,
)
from .programs import MilledProgram
from .records import LinkedPath, SolvedJoints

HALVINGS = 6
"""Times that blocks of a cured path are halved."""


def solve_joints(context: MillContext, linked: LinkedPath) -> SolvedJoints:
    """Lead the machine along the path; halve blocks on which a cured path is entered by the machine alone."""
    path, joints = drive_free(context, linked.path, linked.entering)
    return SolvedJoints(**(vars(linked) | {"path": path}), joints=joints)


def drive_free(context: MillContext, path: CLPath, entering: float) -> tuple[CLPath, JointPath]:
    """Return the path and its joint path (:func:`.driving.drive`). Where a cure is asked for and blocks may
    be divided, rows are put in half-way where the tool still enters on its real way though the path itself
    does not: the machine turns the axis otherwise than on a great arc, and with the tip within the tolerance
    the rest of the cutter may swing farther."""
    settings, joints = context.settings, drive(context, path, entering)
    if settings.cure.linearize != "on" or settings.gouge.gouge in ("off", "report"):
        return path, joints
    wanted = np.arange(len(path.tip))
    for _ in range(HALVINGS):
        rows = _entering(context, path, joints, wanted)
        if not len(rows):
            break
        path = _halve_blocks(path, rows, compute_driven_to_surface(settings))
        joints = drive(context, path, entering)
        fresh = rows + np.arange(len(rows))
        wanted = np.union1d(
            fresh, fresh + 1
        )  # both halves; of all else the machine goes the way that was clear
    return path, joints


def _entering(context: MillContext, path: CLPath, joints: JointPath, wanted: Ints) -> Ints:
    """Find the rows (k,) of the path, of those ``wanted`` (n,) for, to which the machine leads the cutter
    through the part, and the path itself does not."""
    settings, progress = context.settings, context.progress
    cutter, tree, limit = (
        tool_body(settings).only(CUTTER),
        facet_tree(context.obstacles),
        settings.proof.tolerance,
    )
    real = real_motion(context.kinematics, q_to_words(joints.q), tip_to_driven(settings))
    fed = np.flatnonzero(
        (joints.path.motion[1:] != Motion.RAPID) & np.isin(joints.row[1:], wanted)
    )  # links near the part too
    blocks = np.flatnonzero(which_enter(cutter, tree, real, limit, fed, progress))
    rows = np.unique(joints.row[blocks + 1])
    rows = rows[rows > 0]
    commanded = compute_commanded_motion(settings, path)
    return rows[~which_enter(cutter, tree, commanded, limit, rows - 1, progress)[rows - 1]]


def _halve_blocks(path: CLPath, rows: Ints, above: float = 0.0) -> CLPath:
    """Return the path with a row half-way to each of these rows (k,), of which it takes all but its place and
    axis; the point ``above`` mm over the driven one goes straight."""
    pose = straight_motion(path.tip, path.axis, above).pose(rows - 1, np.full(len(rows), 0.5))
    given = {
        name: getattr(path, name)
        for name in ("motion", "feed", "contact", "normal", "face", "coedge", "pass_")
    }
    columns = {name: np.insert(column, rows, column[rows], axis=0) for name, column in given.items()}
    tip, axis = np.insert(path.tip, rows, pose.tip.T, axis=0), np.insert(path.axis, rows, pose.axis.T, axis=0)
    return replace(path, tip=tip, axis=axis, **columns)


def keep_rapids_clear(context: MillContext, solved: SolvedJoints) -> SolvedJoints:
    """Divide the rapids that are clear only if interpolated, where the controller may drive their axes
    independently and the part is looked at."""
    settings = context.settings
    if settings.gouge.gouge == "off" or rapids_of(settings, context.machine, context.dialect) == INTERPOLATED:
        return solved
    body, limit, back = tool_body(settings), settings.proof.tolerance, tip_to_driven(settings)
    clearance = RapidClearance(body, facet_tree(context.obstacles), back, limit, context.progress)
    return replace(
        solved, joints=divide_rapids(solved.joints, context.kinematics, context.dialect, clearance)
    )


def write_program(context: MillContext, solved: SolvedJoints) -> MilledProgram:
    """Round the words, write the NC file, and collect what all stages have found."""
    found = solved.findings + solved.cut.findings + solved.axis_findings + solved.path.findings
    settings = context.settings
    above, radius = compute_driven_to_hub(settings), settings.cutter.cutter.radius
    found = count_below_part(found, solved.path, context.mesh, above, radius)
    found += report_dip(context, solved.path)
    wide = settings.cutter.cutter.has_level_bottom or steps_over_strips(settings)
    suspected = solved.cured or wide or context.unreached or leaves_out(found) or tells_of_less(found)
    uncut = find_uncut(context, solved.path) if suspected else ()
    program = post_path(context, solved.path, solved.joints, found + uncut)
    return MilledProgram(
        **vars(program), mesh=context.mesh, contact=solved.contact, offset=solved.offset, axis=solved.axis,
        keep=context.keep,
        boundary=context.boundary, keep_off=context.keep_off, entering=solved.entering,
    )  # fmt: skip
