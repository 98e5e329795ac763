# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a solid to a program: :func:`mill` is the pipeline, a stage a line."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, take_rows
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.cl.cl_offset import cl_offset_path, corner_radius, spacing_radius
from freecad_fiveaxis.core.cl.cl_path import CLPath, LinkOptions, link_passes
from freecad_fiveaxis.core.cl.coedge import OffsetPath, break_polylines, close_gaps, lasting_rows, take_path_rows
from freecad_fiveaxis.core.cl.feasible import feasible_rows
from freecad_fiveaxis.core.cl.tool_axis import tool_axes
from freecad_fiveaxis.core.collision.fixtures import Fixture
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.corrections.auto_axis import (
    auto_axes,
    divided,
    find_contacts,
    refine_field,
    report_no_way_out,
    select_rows_with_way_out,
)
from freecad_fiveaxis.core.corrections.axis_corrections import AXIS_CORRECTIONS
from freecad_fiveaxis.core.corrections.facets_with_axis import AxisField, find_axis_field, select_facets
from freecad_fiveaxis.core.corrections.find_frames import find_frames
from freecad_fiveaxis.core.corrections.free_in_frames import by_frame, free_in_frames, stands_in
from freecad_fiveaxis.core.corrections.free_turns import divide_blocked_turns
from freecad_fiveaxis.core.corrections.order_with_axes import order_with_axes
from freecad_fiveaxis.core.corrections.sideways import add_retreats, neck_entering, path_retreats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.passes import (
    ContactPath,
    Division,
    Region,
    cut,
    facets_around,
    facets_under_axes,
    facets_within_limits,
    find_pass_strategy,
    flat_interval,
    lay_by_slope,
    report_standing,
    standing_facets,
    turns_within_limits,
)
from freecad_fiveaxis.core.passes.frames import Frames
from freecad_fiveaxis.core.passes.radial_passes import unit_axis

from .avoided import facets_off, far_enough_rows, keep_off_of, kept_off_faces
from .bounded import boundary_of, bounded, bounded_by_hub, facets_inside
from .collision_avoidance import (
    drive_free,
    keep_rapids_clear,
    led_in,
    left_out_rows,
    lifted,
    near_the_part,
    tilted,
    uncut_by_cure,
)
from .context import MillContext, obstacles_of
from .driving import posted
from .fewer_axes import keeps_its_axis
from .made import Milled
from .options import (
    axis_corrections,
    axis_options,
    kept_off,
    pass_options,
    reacher_of,
    travels,
)
from .over_table import AUTO, largest_axis_angle, report_part_in_table
from .rotary_axis import turns_the_part
from .settings import FRAMES, Settings
from .settings.settings import FROM_AXIS, STEEP

_NOTHING_FREE = say("no facet can be cut: at no contact of the passes a tool axis is free; use a smaller cutter or holder")


def mill_context(
    settings: Settings, mesh: Mesh, machine: Machine, kinematics: Chain, dialect: Dialect, progress: Progress,
    faces: Bools | None = None, fixtures: tuple[Fixture, ...] = (), avoided: Bools | None = None,
) -> tuple[MillContext, tuple[Finding, ...]]:  # fmt: skip
    """The job's context, and what there is to say of facets that stay uncut. ``faces`` (f,): the facets to cut, None: all.
    ``fixtures``: what is kept clear of as the rest of the part is; ``avoided`` (f,): the facets on faces to avoid, None: no such
    faces."""
    keep_off = keep_off_of(settings, mesh, avoided)
    joined, box = obstacles_of(mesh, fixtures, keep_off)
    boundary, most = boundary_of(settings), largest_axis_angle(settings, machine, mesh)
    inside, said = facets_inside(settings, boundary, mesh, faces)
    chosen = faces if boundary is None else inside
    if keep_off is not None:
        inside, near = facets_off(keep_off, mesh, inside)
        said, chosen = said + near, inside
    if settings.tool_axis.tool_axis == AUTO:
        standing = find_standing(settings, mesh, faces)
        faces = (~standing if faces is None else faces) & inside
        check_passes(settings, mesh, faces & facets_under_axes(mesh, most))
        reacher = reacher_of(settings, machine, kinematics, mesh)
        to_cut = np.append(faces, np.zeros(len(joined.face) - len(faces), np.bool_))
        about = (*said, *report_standing(mesh, standing & inside), *report_part_in_table(settings, machine, mesh))
        if settings.passes.passes == FRAMES:
            frames, keep, left_out = find_frames(joined, to_cut, reacher, most, int(settings.passes.frames), progress)
            context = MillContext(settings, machine, kinematics, dialect, box, progress, mesh, keep[: len(faces)], None, joined)
            return replace(context, chosen=chosen, boundary=boundary, frames=frames, keep_off=keep_off), (*about, *left_out)
        field = find_axis_field(joined, to_cut, reacher, progress)
        keep, left_out = select_facets(field, joined, to_cut, most)
        keep = keep[: len(faces)]
        context = MillContext(settings, machine, kinematics, dialect, box, progress, mesh, keep, field, joined, chosen, boundary)
        return replace(context, keep_off=keep_off), (*about, *left_out)
    if settings.tool_axis.tool_axis == FROM_AXIS:
        stand = axis_options(settings)
        keep, left_out = facets_around(mesh, kinematics, np.array(stand.through), unit_axis(stand.about), most, chosen)
        context = MillContext(settings, machine, kinematics, dialect, box, progress, mesh, keep, None, joined, chosen, boundary)
        return replace(context, keep_off=keep_off), (*said, *left_out)
    followed = None if keeps_its_axis(settings, machine) else kinematics
    keep, left_out = facets_within_limits(mesh, followed, most, chosen)
    left_out = (*said, *left_out)
    context = MillContext(settings, machine, kinematics, dialect, box, progress, mesh, keep, None, joined, chosen, boundary)
    return replace(context, keep_off=keep_off), left_out


def find_standing(settings: Settings, mesh: Mesh, faces: Bools | None) -> Bools:
    """The facets (f,) that the part stands on, which stay uncut where axes are chosen freely and nobody says which are cut."""
    return np.asarray(standing_facets(mesh) & (faces is None and settings.passes.max_axis_angle is None))


def check_passes(settings: Settings, mesh: Mesh, keep: Bools) -> None:
    """Refuse, before the long work of the axis field, passes that cannot be laid on the facets ``keep`` (f,), over which an axis
    may lean. Raises SettingsError, FileError."""
    if keep.any():
        strategy = find_pass_strategy(settings.passes.passes)
        strategy.check(find_region(settings, mesh, keep, silent), pass_options(settings))


def mill(context: MillContext) -> Milled:
    """From a mesh to a program: passes, CL offset, tool axes, links, the tool kept out of the part, joints, NC blocks."""
    contact, untouched, frame = laid(context)
    offset, axis, held = oriented(context, kept_off_faces(context, bounded(context, closed(context, contact))), frame)
    led, said = rerouted(context, offset, axis)
    turned, led = tilted(context, offset, led)
    path, entering = lifted(context, linked(context, turned, led))
    path = led_in(context, near_the_part(context, path))
    path, joints = drive_free(context, path, entering)
    joints = keep_rapids_clear(context, joints)
    found = untouched + contact.findings + turned.findings + held + said + path.findings + uncut_by_cure(context, path)
    program = posted(context, path, joints, found)
    return Milled(
        **vars(program), mesh=context.mesh, contact=contact, offset=offset, axis=axis, keep=context.keep,
        boundary=context.boundary, keep_off=context.keep_off,
    )  # fmt: skip


def laid(context: MillContext) -> tuple[ContactPath, tuple[Finding, ...], Ints | None]:
    """The passes on the facets, what they do not touch, and the frame (k,) of each pass, where there are frames."""
    strategy, options = find_pass_strategy(context.settings.passes.passes), pass_options(context.settings)
    region = find_region(context.settings, context.mesh, context.keep, context.progress, context.frames)
    order, spiral = context.settings.links.order, context.settings.links.spiral == "on"
    if (bound := context.settings.passes.steep_shallow) is not None:
        return *lay_by_slope(region, options, Division(bound, find_pass_strategy(STEEP), strategy, order, spiral)), None
    field = strategy.field(region, options)
    contact = cut(region, field, order, spiral)
    return contact, strategy.untouched(region, options, field, contact.face), field.frame


def find_region(settings: Settings, mesh: Mesh, keep: Bools, progress: Progress, frames: Frames | None = None) -> Region:
    """The facets ``keep`` (f,), which are to be cut, with the ball whose passes may stand as far apart as the cutter's. For what
    is no ball: at most as far apart as on a flat, for beyond that its bottom ends."""
    options, cutter = pass_options(settings), settings.cutter.cutter
    radius, scallop = cutter.radius, options.scallop
    interval = options.stepover or flat_interval(radius, min(scallop or 0.0, 0.5 * radius))
    if scallop is None or cutter.ring == 0.0:
        return Region(mesh, keep, radius, interval, progress=progress, frames=frames)
    stands = [(settings.tool_axis.tool_axis, axis_options(settings))] if frames is None else stands_in(frames)
    radii = [spacing_radius(cutter, mesh, keep, angle, *stand, scallop) for angle in travels(settings) for stand in stands]
    return Region(mesh, keep, min(radii), interval, 1.0, progress, frames)


def closed(context: MillContext, contact: ContactPath) -> OffsetPath:
    """The passes offset by the corner radius, gaps at co-edges closed and overlaps trimmed."""
    cutter, keep = context.settings.cutter, None if context.keep.all() else context.keep
    return close_gaps(contact, context.mesh, corner_radius(cutter.cutter), cutter.coedge_tolerance, keep, context.progress)


def oriented(context: MillContext, offset: OffsetPath, frame: Ints | None) -> tuple[OffsetPath, Floats, tuple[Finding, ...]]:
    """The rows that can be cut and the strategy's tool axes (n, 3) there, and what there is to say of the others. ``frame`` (k,):
    of each pass, where the rotary axes are locked."""
    settings, found = context.settings, tuple[Finding, ...]()
    axis = tool_axes(offset, settings.tool_axis.tool_axis, axis_options(settings))
    if context.frames is not None and frame is not None and len(axis):
        offset, axis, found = framed_rows(context, context.frames, offset, frame)
    if context.field is not None and len(axis):
        offset, axis, found = free_rows(context, context.field, offset, axis)
    cutter, asked = settings.cutter.cutter, context.field is not None or context.frames is not None  # whether the neck is free
    undercut = cutter.undercut if asked else 0.0
    return *feasible_rows(offset, axis, context.kinematics, cutter.taper, undercut), found


def free_rows(
    context: MillContext, field: AxisField, offset: OffsetPath, axis: Floats
) -> tuple[OffsetPath, Floats, tuple[Finding, ...]]:
    """The rows at which the field gives an axis that is free; a pass goes on behind contacts that have none."""
    settings, cutter = context.settings, context.settings.cutter.cutter
    reacher = reacher_of(settings, context.machine, context.kinematics, context.mesh)
    offset, axis = divided(offset, axis, cutter.radius, cutter.ring)
    stand, mesh, progress = axis_options(settings), context.obstacles, context.progress
    progress("axis field", 0.0)
    contacts = find_contacts(offset, mesh, reacher)
    progress("axis field", 0.0)
    field = refine_field(field, offset, mesh, reacher, progress, contacts)
    axis, free, found = auto_axes(offset, axis, field, mesh, reacher, stand, progress, contacts)
    free = add_retreats(offset, axis, free, mesh, reacher, progress)
    offset, axis, free, blocked = divide_blocked_turns(offset, axis, free, field, mesh, reacher, stand, progress)
    blocked = blocked | neck_entering(offset, axis, mesh, reacher, progress)
    offset = break_polylines(offset, blocked[1:])
    offset, axis, free = _keep_rows(offset, axis, free, np.flatnonzero(free))
    offset = break_polylines(offset, ~turns_within_limits(context.kinematics, axis[:-1], axis[1:]))
    free = add_retreats(offset, axis, free, mesh, reacher, progress)
    rows = select_rows_with_way_out(free, offset.polyline)
    found += report_no_way_out(offset, rows)
    offset, axis, free = _keep_rows(offset, axis, free, rows)
    if not len(free):
        raise ReachError(_NOTHING_FREE, None)
    if settings.links.order == "zigzag" and not (stand.lead or stand.tilt):  # these lean with the way of the feed
        offset, axis = order_with_axes(offset, axis)
    return offset, axis, found


def framed_rows(
    context: MillContext, frames: Frames, offset: OffsetPath, frame: Ints
) -> tuple[OffsetPath, Floats, tuple[Finding, ...]]:
    """The rows, frame by frame, at which the tool is free with the axis of the frame of their pass, and these axes (n, 3)."""
    settings, cutter = context.settings, context.settings.cutter.cutter
    reacher = reacher_of(settings, context.machine, context.kinematics, context.mesh)
    offset, axis = divided(offset, frames.axis[frame[offset.pass_]], cutter.radius, cutter.ring)
    axis = frames.axis[frame[offset.pass_]]
    free, found = free_in_frames(offset, frames, frame, context.obstacles, reacher, context.progress)
    offset, axis, free = _keep_rows(offset, axis, free, np.flatnonzero(free))
    free = add_retreats(offset, axis, free, context.obstacles, reacher, context.progress)
    rows = select_rows_with_way_out(free, offset.polyline)
    found += report_no_way_out(offset, rows)
    offset, axis, free = _keep_rows(offset, axis, free, rows)
    if not len(free):
        raise ReachError(_NOTHING_FREE, None)
    return *by_frame(offset, frames, frame, settings.links.order == "zigzag"), found


def _keep_rows(offset: OffsetPath, axis: Floats, free: Ints, rows: Ints) -> tuple[OffsetPath, Floats, Ints]:
    """Those of ``rows`` (ascending) that have a neighbour among them."""
    rows = lasting_rows(offset, rows)
    return (offset, axis, free) if len(rows) == len(free) else (take_path_rows(offset, rows), take_rows(axis, rows), free[rows])


def rerouted(context: MillContext, offset: OffsetPath, axis: Floats) -> tuple[Floats, tuple[Finding, ...]]:
    """The axes (n, 3) corrected where the settings ask for that: by a strategy that knows the machine, then past the pole."""
    settings, found = context.settings, tuple[Finding, ...]()
    options = axis_corrections(context)
    strategy = settings.tool_axis.tool_axis if context.field is None and context.frames is None else ""
    for name in (strategy, settings.cure.singularity):
        if (correction := AXIS_CORRECTIONS.get(name)) is not None:
            given = axis
            axis, said = correction.axes(offset, given, context.kinematics, options, context.progress)
            found += said + (correction.trade(offset, given, context.kinematics, options, context.progress) if said else ())
    return axis, found


def _retreats(context: MillContext, sat: OffsetPath, axis: Floats) -> Floats | None:
    """The directions (n, 3) in which the tool leaves the rows, where these are not its axes: where axes are chosen freely, only
    there rows are kept that it cannot leave along its axis."""
    if context.field is None and context.frames is None:
        return None
    reacher = reacher_of(context.settings, context.machine, context.kinematics, context.mesh)
    return path_retreats(sat, axis, context.obstacles, reacher, context.progress)


def linked(context: MillContext, offset: OffsetPath, axis: Floats) -> CLPath:
    """The CL path through the contacts with tool axes ``axis`` (n, 3), one for each row of ``offset``: the cutter sits anew on
    each of them, whatever led its axis there."""
    settings, cutter = context.settings, context.settings.cutter.cutter
    options = LinkOptions(
        clearance=settings.links.clearance, feed=settings.feeds.feed, plunge_feed=settings.feeds.plunge_feed,
        control_point=settings.machine.control_point,
    )  # fmt: skip
    sat, axis = cl_offset_path(offset, axis, cutter, settings.cutter.coedge_tolerance)
    sat, axis = bounded_by_hub(context, sat, axis)
    sat, axis = far_enough_rows(context, *left_out_rows(context, sat, axis))
    path = link_passes(
        sat, axis, cutter, *context.box, options, context.progress, kept_off(settings), _retreats(context, sat, axis)
    )
    if settings.tool_axis.tool_axis == FROM_AXIS and turns_the_part(context.kinematics):
        path = replace(path, findings=tuple(one for one in path.findings if one.code != "retract-below-part"))
    return path if sat is offset else replace(path, findings=sat.findings[len(offset.findings) :] + path.findings)
