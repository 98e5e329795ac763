# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stages from the facets to what the cutter follows: passes, their offset, and what is not to be cut taken
off them."""

from __future__ import annotations

from dataclasses import replace

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Length, Option, say
from freecad_fiveaxis.core.passes import (
    Division,
    Region,
    cut,
    find_pass_strategy,
    flat_interval,
    lay_by_slope,
    report_high_scallops,
)
from freecad_fiveaxis.core.toolpath.cl_offset import corner_radius
from freecad_fiveaxis.core.toolpath.coedge import close_gaps

from .avoided import cut_clear_of_faces
from .bounded import cut_to_boundary
from .context import MillContext
from .options import pass_options, steps_over_strips
from .records import OffsetContacts, PlannedPasses
from .settings import Settings
from .settings.tree import STEEP

NARROW = 0.25
"""Of a ball's step: passes nearer to each other are worth a word."""


def plan_passes(context: MillContext, region: Region) -> PlannedPasses:
    """Cut level sets of the pass strategy's field on the region, and find what no pass touches."""
    strategy, options = find_pass_strategy(context.settings.passes.passes), pass_options(context.settings)
    order, spiral = context.settings.links.order, context.settings.links.spiral == "on"
    spacing = _report_spacing(context.settings, region)
    if (bound := context.settings.passes.steep_shallow) is not None:
        division = Division(bound, find_pass_strategy(STEEP), strategy, order, spiral)
        contact, untouched = lay_by_slope(region, options, division)
        return PlannedPasses(contact, None, untouched + contact.findings + spacing)
    field = strategy.field(region, options)
    contact = cut(region, field, order, spiral)
    untouched = strategy.report_untouched(region, options, field, contact.face)
    if field.turns is not None and field.surface is not None:
        spacing += report_high_scallops(region, options, contact, field.surface.mesh, field.turns)
    return PlannedPasses(contact, field.frame, untouched + contact.findings + spacing)


def _report_spacing(settings: Settings, region: Region) -> tuple[Finding, ...]:
    return _report_strips(settings) + _report_narrow(settings, region)


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


def _report_narrow(settings: Settings, region: Region) -> tuple[Finding, ...]:
    """Say that the passes of a cutter that is no ball are many times as many as a ball's, because it stands
    aslant on the surface and cuts with its edge."""
    scallop, cutter = settings.passes.scallop, settings.cutter.cutter
    if scallop is None or settings.passes.stepover is not None or cutter.touches_as_ball:
        return ()
    step, ball = flat_interval(region.radius, scallop), flat_interval(cutter.radius, scallop)
    if step >= NARROW * ball:
        return ()
    text = say(
        "Passes are only {step} apart, because the cutter touches with its edge where the surface is aslant "
        "to its axis; a ball of its diameter would take {ball}. Use a ball or a bull nose cutter, or a tool "
        "axis that follows the surface.",
        step=Length(step, ".3g"),
        ball=Length(ball, ".3g"),
    )
    return (report_finding(Code.NARROW_PASSES, text, step, ball),)


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
