# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the tool stands: the strategy's axes, corrections that know the machine, the tool tilted out of the
part."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import silent
from freecad_fiveaxis.core.base.records import Floats, Ints, take_rows
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.orientation.auto_axis import (
    auto_axes,
    divide_path,
    refine_field,
    select_rows_with_way_out,
)
from freecad_fiveaxis.core.orientation.axis_corrections import AXIS_CORRECTIONS
from freecad_fiveaxis.core.orientation.contacts import find_contacts, slide_path
from freecad_fiveaxis.core.orientation.facets_with_axis import AxisField
from freecad_fiveaxis.core.orientation.free_in_frames import by_frame, free_in_frames
from freecad_fiveaxis.core.orientation.free_turns import divide_blocked_turns
from freecad_fiveaxis.core.orientation.no_way_out import report_no_way_out
from freecad_fiveaxis.core.orientation.order_with_axes import order_with_axes
from freecad_fiveaxis.core.orientation.sideways import add_retreats, neck_entering
from freecad_fiveaxis.core.orientation.strategies import FACE_NORMAL, tool_axes
from freecad_fiveaxis.core.orientation.tilt import tilt_free
from freecad_fiveaxis.core.passes import turns_within_limits
from freecad_fiveaxis.core.passes.frames import Frames
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath, break_polylines, lasting_rows, take_path_rows
from freecad_fiveaxis.core.toolpath.feasible import feasible_rows

from .blockers import list_blockers
from .context import MillContext
from .mill_context import find_region
from .options import axis_corrections, axis_options, reacher_in, tip_to_surface, tool_body
from .records import AssignedAxes, OffsetContacts

_NOTHING_FREE = say(
    "no facet can be cut: at no contact of the passes a tool axis is free; use a smaller cutter or holder"
)


def assign_axes(context: MillContext, passes: OffsetContacts) -> AssignedAxes:
    """Give each contact the strategy's tool axis, and leave out the rows that cannot be cut with it."""
    settings, offset, frame, found = context.settings, passes.offset, passes.frame, tuple[Finding, ...]()
    axis = tool_axes(offset, settings.tool_axis.tool_axis, axis_options(settings))
    offset = replace(offset, middle=settings.tool_axis.tool_axis == FACE_NORMAL)
    if context.frames is not None and frame is not None and len(axis):
        offset, axis, found = select_framed_rows(context, context.frames, offset, frame)
    if context.field is not None and len(axis):
        offset, axis, found = free_rows(context, context.field, offset, axis)
    cutter, wanted = (
        settings.cutter.cutter,
        context.field is not None or context.frames is not None,
    )  # whether the neck is free
    offset, axis = feasible_rows(
        offset, axis, context.kinematics, cutter.taper, cutter.undercut if wanted else 0.0
    )
    offset = replace(offset, findings=measure_area_beyond_limits(context, offset.findings))
    whole = vars(passes) | {"offset": offset}
    return AssignedAxes(**whole, axis=axis, cut=offset, corrected=axis, axis_findings=found)


def measure_area_beyond_limits(context: MillContext, findings: tuple[Finding, ...]) -> tuple[Finding, ...]:
    """Add to findings on stretches beyond the machine's limits the area beside them: their length times the
    passes' distance on a flat."""
    if not any(one.code == Code.AXIS_BEYOND_LIMITS for one in findings):
        return findings
    interval = find_region(context.settings, context.mesh, context.keep, silent).interval
    return tuple(
        replace(one, within=(one.value or 0.0) * interval) if one.code == Code.AXIS_BEYOND_LIMITS else one
        for one in findings
    )


def free_rows(
    context: MillContext, field: AxisField, offset: OffsetPath, axis: Floats
) -> tuple[OffsetPath, Floats, tuple[Finding, ...]]:
    """Return the rows at which the field gives an axis that is free; a pass goes on behind contacts that have
    none."""
    settings, cutter = context.settings, context.settings.cutter.cutter
    reacher = reacher_in(context)
    offset, axis = divide_path(offset, axis, cutter.radius, cutter.ring, cutter.barrel)
    if cutter.has_level_bottom:
        offset = slide_path(replace(offset, middle=True), field, context.obstacles, reacher, context.progress)
    stand, mesh, progress = axis_options(settings), context.obstacles, context.progress
    progress("axis field", 0.0)
    contacts = find_contacts(offset, mesh, reacher)
    progress("axis field", 0.0)
    field = refine_field(field, offset, mesh, reacher, progress, contacts)
    axis, free, found = auto_axes(
        offset, axis, field, mesh, reacher, stand, progress, contacts, list_blockers(context)
    )
    free = add_retreats(offset, axis, free, mesh, reacher, progress)
    offset, axis, free, blocked = divide_blocked_turns(
        offset, axis, free, field, mesh, reacher, stand, progress
    )
    blocked = blocked | neck_entering(offset, axis, mesh, reacher, progress)
    offset = break_polylines(offset, blocked[1:])
    offset, axis, free = _keep_rows(offset, axis, free, np.flatnonzero(free))
    offset = break_polylines(offset, ~turns_within_limits(context.kinematics, axis[:-1], axis[1:]))
    free = add_retreats(offset, axis, free, mesh, reacher, progress)
    rows = select_rows_with_way_out(free, offset.polyline)
    found += report_no_way_out(offset, rows, context.mesh, reacher)
    offset, axis, free = _keep_rows(offset, axis, free, rows)
    if not len(free):
        raise ReachError(_NOTHING_FREE, None)
    if settings.links.order == "zigzag" and not (
        stand.lead or stand.tilt
    ):  # these lean with the way of the feed
        offset, axis = order_with_axes(offset, axis)
    return offset, axis, found


def select_framed_rows(
    context: MillContext, frames: Frames, offset: OffsetPath, frame: Ints
) -> tuple[OffsetPath, Floats, tuple[Finding, ...]]:
    """Return the rows, frame by frame, at which the tool is free with the axis of the frame of their pass,
    and these axes (n, 3)."""
    settings, cutter = context.settings, context.settings.cutter.cutter
    reacher = reacher_in(context)
    offset, axis = divide_path(
        offset, frames.axis[frame[offset.pass_]], cutter.radius, cutter.ring, cutter.barrel
    )
    axis = frames.axis[frame[offset.pass_]]
    free, found = free_in_frames(offset, frames, frame, context.obstacles, reacher, context.progress)
    offset, axis, free = _keep_rows(offset, axis, free, np.flatnonzero(free))
    free = add_retreats(offset, axis, free, context.obstacles, reacher, context.progress)
    rows = select_rows_with_way_out(free, offset.polyline)
    found += report_no_way_out(offset, rows, context.mesh, reacher)
    offset, axis, free = _keep_rows(offset, axis, free, rows)
    if not len(free):
        raise ReachError(_NOTHING_FREE, None)
    return *by_frame(offset, frames, frame, settings.links.order == "zigzag"), found


def _keep_rows(offset: OffsetPath, axis: Floats, free: Ints, rows: Ints) -> tuple[OffsetPath, Floats, Ints]:
    """Those of ``rows`` (ascending) that have a neighbour among them."""
    rows = lasting_rows(offset, rows)
    return (
        (offset, axis, free)
        if len(rows) == len(free)
        else (take_path_rows(offset, rows), take_rows(axis, rows), free[rows])
    )


def correct_axes(context: MillContext, passes: AssignedAxes) -> AssignedAxes:
    """Correct the axes where the settings ask for that: by a strategy that knows the machine, then past the
    pole."""
    settings, axis, found = context.settings, passes.corrected, passes.axis_findings
    options = axis_corrections(context)
    strategy = settings.tool_axis.tool_axis if context.field is None and context.frames is None else ""
    for name in (strategy, settings.cure.singularity):
        if (correction := AXIS_CORRECTIONS.get(name)) is not None:
            given = axis
            axis, new = correction.axes(passes.cut, given, context.kinematics, options, context.progress)
            traded = (
                correction.trade(passes.cut, given, context.kinematics, options, context.progress)
                if new
                else ()
            )
            found += new + traded
    return replace(passes, corrected=axis, axis_findings=found)


def tilt_axes(context: MillContext, passes: AssignedAxes) -> AssignedAxes:
    """Tilt the tool free of the part, where the settings ask for that."""
    settings = context.settings
    if settings.gouge.gouge != "tilt":
        return passes
    tree = facet_tree(context.obstacles)
    cutter, most, tolerance = settings.cutter.cutter, settings.tool_axis.max_tilt, settings.proof.tolerance
    body, above = tool_body(settings), tip_to_surface(settings)
    cut, corrected = tilt_free(
        passes.cut,
        passes.corrected,
        cutter,
        body,
        tree,
        context.kinematics,
        most,
        tolerance,
        context.progress,
        above,
    )
    return replace(passes, cut=cut, corrected=corrected)
