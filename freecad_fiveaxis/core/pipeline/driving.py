# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a CL path to a program: the machine led along it, blocks divided where that is asked for, the words
and the NC file."""

from __future__ import annotations

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.machine.kinematics import q_to_words
from freecad_fiveaxis.core.motion.joint_path import JointPath, solve
from freecad_fiveaxis.core.motion.linearize import linearize
from freecad_fiveaxis.core.motion.program import block_findings, build_program
from freecad_fiveaxis.core.motion.singularity import in_cone
from freecad_fiveaxis.core.nc.writer import write_nc
from freecad_fiveaxis.core.tool.body import lower_body
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .context import JobContext, MillContext
from .options import choose_rapid_body, compute_driven_to_surface, nc_title, post_options, tip_to_driven
from .programs import PostedProgram
from .safe_start import find_spindle_off, start_findings
from .start_plane import find_start_plane


def drive(context: JobContext, path: CLPath, entering: float = 0.0) -> JointPath:
    """Return the joint path through ``path``; its blocks divided where the settings ask for that: all feed
    blocks over tolerance, or those in the cone about the pole; over tolerance is what the point leaves that
    makes the surface (of a ball the centre). ``entering`` mm: so much of the tolerance the path itself uses
    up."""
    settings, kinematics = context.settings, context.kinematics
    clearance, radius = settings.links.clearance, settings.cutter.cutter.radius
    tool = lower_body(choose_rapid_body(settings), tip_to_driven(settings))
    blocked = (
        context.bodies.is_blocked if isinstance(context, MillContext) and context.bodies is not None else None
    )
    joints = solve(path, kinematics, *context.box, clearance, radius, context.progress, tool, blocked)
    if settings.cure.linearize == "on":
        near = None
    elif settings.cure.singularity == "linearize":
        near = in_cone(kinematics, q_to_words(joints.q), context.machine.singular_cone)
    else:
        return joints
    above, tolerance = compute_driven_to_surface(settings), settings.proof.tolerance - entering
    return linearize(joints, kinematics, context.dialect, tolerance, near, context.progress, above)


def post_path(
    context: JobContext, path: CLPath, joints: JointPath, found: tuple[Finding, ...]
) -> PostedProgram:
    """Return the program and its NC file. ``found``: what the stages before have found."""
    settings, machine, kinematics, dialect = (
        context.settings,
        context.machine,
        context.kinematics,
        context.dialect,
    )
    program = build_program(joints, kinematics, dialect, settings.feeds.feed_mode == "g93", context.progress)
    plane = find_start_plane(context, program)
    nc = write_nc(
        program,
        dialect,
        nc_title(settings, machine),
        post_options(settings),
        context.progress,
        plane.z or 0.0,
    )
    findings = (
        found
        + block_findings(joints.findings, program)
        + program.findings
        + plane.findings
        + start_findings(context, program)
    )
    findings += find_spindle_off(settings)
    return PostedProgram(
        settings, machine, kinematics, dialect, program, findings, path, joints, nc, plane=plane
    )
