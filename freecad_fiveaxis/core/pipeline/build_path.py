# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stages from contacts with axes to the CL path: links, the tool lifted out of the part, links near the part,
lead-ins."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge.leave_out import leave_out
from freecad_fiveaxis.core.gouge.left_alone import lead_over_others
from freecad_fiveaxis.core.gouge.lift import AIM, Lifted
from freecad_fiveaxis.core.gouge.lift import lift_path as lift_free
from freecad_fiveaxis.core.links.lead_in import lead_in
from freecad_fiveaxis.core.links.near_links import LOCKED, MOST_TURN, stay_near
from freecad_fiveaxis.core.orientation.sideways import path_retreats, rows_left_aside
from freecad_fiveaxis.core.toolpath.cl_offset import cl_offset_path
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, LinkOptions
from freecad_fiveaxis.core.toolpath.cl_path import link_passes as link_rows
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

from .avoided import far_enough_rows
from .bounded import cut_by_hub, leads_outside
from .context import MillContext
from .merged import merge_crowded_rows
from .options import choose_rapid_body, lead_options, reacher_in, tip_to_driven, tip_to_surface, tool_body
from .records import AssignedAxes, LinkedPath
from .rotary_axis import turns_the_part
from .settings.tree import FROM_AXIS


def link_passes(context: MillContext, passes: AssignedAxes) -> LinkedPath:
    """Set the cutter on every contact, leave out what would enter where that is asked for, merge rows where
    they crowd, and link the passes over the part."""
    path, left_out, merged = _link_free_contacts(context, passes.cut, passes.corrected)
    entering = AIM * context.settings.proof.tolerance if left_out else 0.0
    return LinkedPath(**vars(passes), path=path, cured=left_out, entering=entering + merged)


def link_contacts(context: MillContext, offset: OffsetPath, axis: Floats) -> CLPath:
    """Return the CL path through the contacts with tool axes ``axis`` (n, 3), one for each row of ``offset``:
    the cutter sits anew on each of them, whatever led its axis there."""
    return _link_free_contacts(context, offset, axis)[0]


def _link_free_contacts(context: MillContext, offset: OffsetPath, axis: Floats) -> tuple[CLPath, bool, float]:
    """Return the same, whether rows were left out because the tool would enter the part there, and what
    merging rows uses up of the tolerance, mm."""
    settings, cutter = context.settings, context.settings.cutter.cutter
    options = LinkOptions(
        clearance=settings.links.clearance, feed=settings.feeds.feed, plunge_feed=settings.feeds.plunge_feed,
        control_point=settings.machine.control_point,
        turning=settings.tool_axis.tool_axis == FROM_AXIS and turns_the_part(context.kinematics),
    )  # fmt: skip
    offset = replace(offset, findings=())  # what was to say of it has been said
    seated, axis = cl_offset_path(offset, axis, cutter, settings.cutter.coedge_tolerance)
    seated, axis = cut_by_hub(context, seated, axis)
    free, axis = leave_out_rows(context, seated, axis)
    left_out = free is not seated
    seated, axis = far_enough_rows(context, free, axis)
    seated, axis, merged = merge_crowded_rows(context, seated, axis)
    path = link_rows(
        seated,
        axis,
        cutter,
        *context.box,
        options,
        context.progress,
        choose_rapid_body(settings),
        _retreats(context, seated, axis),
    )
    return replace(path, findings=seated.findings + path.findings), left_out, merged


def _retreats(context: MillContext, seated: OffsetPath, axis: Floats) -> Floats | None:
    """Find the directions (n, 3) in which the tool leaves the rows, where these are not its axes: where axes
    are chosen freely, only there rows are kept that it cannot leave along its axis."""
    if context.field is None and context.frames is None:
        return None
    reacher = reacher_in(context)
    return path_retreats(seated, axis, context.obstacles, reacher, context.progress)


def leave_out_rows(context: MillContext, seated: OffsetPath, axis: Floats) -> tuple[OffsetPath, Floats]:
    """Return the rows that can be cut without entering the part, where the settings ask to leave out the
    others. ``seated``: with hubs."""
    settings = context.settings
    if settings.gouge.gouge != "leave-out":
        return seated, axis
    body, cutter, tolerance = tool_body(settings), settings.cutter.cutter, settings.proof.tolerance
    limit = AIM * tolerance if cutter.touches_as_ball else tolerance  # a ring rocks from facet to facet
    tree, above = facet_tree(context.obstacles), tip_to_surface(settings)
    return leave_out(seated, axis, tree, body, limit, cutter.corner, context.progress, above)


def lift_path(context: MillContext, linked: LinkedPath) -> LinkedPath:
    """Lift the tool out of the part, where the settings ask for that."""
    if context.settings.gouge.gouge not in ("lift", "tilt"):
        return linked
    lifted = lift_rows(context, linked.path)
    cured, entering = linked.cured or bool((lifted.lift > 0.0).any()), max(linked.entering, lifted.left)
    return replace(linked, path=lifted.path, cured=cured, entering=entering)


def lift_rows(context: MillContext, path: CLPath) -> Lifted:
    """Lift the tool along its axis where it would enter part or fixtures."""
    settings = context.settings
    body, tree = tool_body(settings), facet_tree(context.obstacles)
    driven, above = tip_to_driven(settings), tip_to_surface(settings)
    aside = rows_left_aside(path, settings.cutter.cutter)
    return lift_free(path, tree, body, settings.proof.tolerance, driven, context.progress, above, aside)


def keep_links_near(context: MillContext, linked: LinkedPath) -> LinkedPath:
    """Take links that stay near the part wherever the tool is free there; leave the path where nothing is
    looked at."""
    settings, path = context.settings, linked.path
    if settings.gouge.gouge == "off" or settings.links.links == "over":
        return linked
    radius, limit = settings.cutter.cutter.radius, AIM * settings.proof.tolerance
    tree, driven, above = facet_tree(context.obstacles), tip_to_driven(settings), tip_to_surface(settings)
    body, kinematics = tool_body(settings), context.kinematics
    spared = (
        None
        if context.chosen is None
        else lambda begin, end: _leads_where_nothing_is_cut(context, path, begin, end)
    )
    turned = MOST_TURN if context.frames is None else LOCKED
    near = stay_near(
        path, tree, body, radius, limit, driven, above, context.progress, kinematics, spared, turned
    )
    return replace(linked, path=near)


def _leads_where_nothing_is_cut(context: MillContext, path: CLPath, begin: Ints, end: Ints) -> Bools:
    """Which straight ways from rows ``begin`` to rows ``end`` (w,) of the path lead over facets that are not
    machined, or out of the boundary."""
    chosen = np.ones(len(context.mesh.face), np.bool_) if context.chosen is None else context.chosen
    over = lead_over_others(path.contact[begin], path.contact[end], context.mesh, chosen)
    return np.asarray(over | leads_outside(context, path, begin, end))


def lead_in_and_out(context: MillContext, linked: LinkedPath) -> LinkedPath:
    """Enter and leave passes on arcs, where the settings ask for that."""
    settings = context.settings
    if settings.links.lead_in == 0.0:
        return linked
    tree = facet_tree(context.obstacles)
    return replace(
        linked,
        path=lead_in(linked.path, tree, choose_rapid_body(settings), lead_options(context), context.progress),
    )
