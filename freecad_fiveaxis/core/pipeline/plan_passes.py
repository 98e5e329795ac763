# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stages from the facets to what the cutter follows: passes, their offset, and what is not to be cut taken
off them."""

from __future__ import annotations

from dataclasses import replace

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Length, Option, say
from freecad_fiveaxis.core.passes import Division, Region, cut, find_pass_strategy, lay_by_slope
from freecad_fiveaxis.core.toolpath.cl_offset import corner_radius
from freecad_fiveaxis.core.toolpath.coedge import close_gaps

from .avoided import cut_clear_of_faces
from .bounded import cut_to_boundary
from .context import MillContext
from .options import pass_options, steps_over_strips
from .records import OffsetContacts, PlannedPasses
from .settings import Settings
from .settings.tree import STEEP


def plan_passes(context: MillContext, region: Region) -> PlannedPasses:
    """Cut level sets of the pass strategy's field on the region, and find what no pass touches."""
    strategy, options = find_pass_strategy(context.settings.passes.passes), pass_options(context.settings)
    order, spiral = context.settings.links.order, context.settings.links.spiral == "on"
    if (bound := context.settings.passes.steep_shallow) is not None:
        division = Division(bound, find_pass_strategy(STEEP), strategy, order, spiral)
        contact, untouched = lay_by_slope(region, options, division)
        return PlannedPasses(contact, None, untouched + contact.findings + _report_strips(context.settings))
    field = strategy.field(region, options)
    contact = cut(region, field, order, spiral)
    untouched = strategy.report_untouched(region, options, field, contact.face)
    found = untouched + contact.findings + _report_strips(context.settings)
    return PlannedPasses(contact, field.frame, found)


def _report_strips(settings: Settings) -> tuple[Finding, ...]:
    """Say that strips between the passes are not touched, where these are farther apart than the cutter is
    wide."""
    stepover, width = settings.passes.stepover, settings.cutter.cutter.diameter
    if stepover is None or not steps_over_strips(settings):
        return ()
    text = say(
        "Passes are {stepover} apart and the cutter is {width} wide: strips between them stay uncut. Give a "
        "smaller {option}, or the {scallop} that may stay.",
        stepover=Length(stepover),
        width=Length(width),
        option=Option("stepover", flag=False),
        scallop=Option("scallop", flag=False),
    )
    return (report_finding(Code.STEPOVER_BEYOND_CUTTER, text, stepover, width),)


def offset_contacts(context: MillContext, passes: PlannedPasses) -> OffsetContacts:
    """Offset the passes by the corner radius, close the gaps at co-edges and trim the overlaps (Lin & Ye,
    II.D)."""
    cutter, keep = context.settings.cutter, None if context.keep.all() else context.keep
    radius = corner_radius(cutter.cutter)
    offset = close_gaps(passes.contact, context.mesh, radius, cutter.coedge_tolerance, keep, context.progress)
    return OffsetContacts(**vars(passes), offset=offset)


def keep_within_boundary(context: MillContext, passes: OffsetContacts) -> OffsetContacts:
    """Cut the passes at the boundary, where there is one."""
    return replace(passes, offset=cut_to_boundary(context, passes.offset))


def keep_off_faces(context: MillContext, passes: OffsetContacts) -> OffsetContacts:
    """Cut the passes where the tool would come nearer to faces to avoid than their allowance."""
    return replace(passes, offset=cut_clear_of_faces(context, passes.offset))
