# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the settings ask of the finished program: that the tool keeps out of the part, and how much may stay
on it.

allowed   so much may stay on the part, mm: scallops and tolerance.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Bytes, Ints
from freecad_fiveaxis.core.base.sentences import Choice, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge import (
    CURES,
    DIVIDE,
    FREEING,
    GougeCheck,
    RestMaterial,
    SweptMotion,
    check_program,
    find_rest_material,
    program_motion,
    report_uncut,
    straight_motion,
    too_deep_finding,
)
from freecad_fiveaxis.core.gouge.table_check import check_table
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.orientation.spacing_radius import scallop_of
from freecad_fiveaxis.core.report.unfinished import BY_SETTINGS, WHY, Unfinished
from freecad_fiveaxis.core.tool.body import CUTTER, body_of
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .blockers import report_blocked
from .bounded import make_place_test
from .context import MillContext
from .options import (
    axis_options,
    rapids_of,
    read_scallop,
    steps_over_strips,
    tip_to_driven,
    tip_to_surface,
    tool_body,
    travels,
)
from .over_table import table_looked_at
from .settings import Settings

REST_SPACING = 0.1
"""Of the cutter's diameter: how far apart, at most, the surface is looked at for rest material."""

FINEST = 0.02
"""The same for the map, at least: that is as fine as SAMPLES allow."""

SAMPLES = 10_000
"""Squares of the spacing into which the map divides the surface, about; each holds two or three of its
triangles."""


STRETCHES = frozenset({
    Code.AXIS_BEYOND_LIMITS, Code.AXIS_INTO_PART, Code.FLANK_INTO_PART, Code.NO_FREE_AXIS, Code.NO_WAY_OUT,
})  # fmt: skip
"""The codes of findings on stretches of passes that are left out for the tool axis."""


OUT_OF_REACH = (
    Code.FACETS_BEYOND_AXIS_ANGLE, Code.FACETS_BEYOND_MACHINE, Code.FACETS_WITHOUT_FREE_AXIS,
    Code.OUTSIDE_FRAMES,
)  # fmt: skip
"""The codes of findings on facets that are not cut because nothing reaches them."""

NOT_CUT = (*OUT_OF_REACH, Code.FACETS_NEAR_AVOIDED)
"""The codes of findings on facets that are not among those to be cut."""


def compute_commanded_motion(settings: Settings, path: CLPath) -> SweptMotion:
    """Return the way that the path commands: the point straight that makes the surface."""
    return straight_motion(
        path.tip - tip_to_driven(settings) * path.axis, path.axis, tip_to_surface(settings)
    )


def find_uncut(context: MillContext, path: CLPath) -> tuple[Finding, ...]:
    """Find what the path leaves on the facets that are cut beyond scallops and tolerance: where a cure left
    something out, and where passes are as far apart as a bottom is wide only where it lies level. Nothing is
    looked for where the map of rest material tells it."""
    settings, mesh, keep = context.settings, context.mesh, context.keep
    if settings.gouge.rest == "on":
        return ()
    cutter = settings.cutter.cutter
    swept = compute_commanded_motion(settings, path)
    spacing, above, blocks = (
        REST_SPACING * cutter.diameter,
        compute_allowed_rest(settings, mesh, keep),
        cutting(path.motion),
    )
    within = make_place_test(context)
    rest = find_rest_material(
        mesh, body_of(cutter).only(CUTTER), swept, blocks, spacing, keep, context.progress, above, within
    )
    return report_uncut(rest, above) + report_blocked(rest, context, above)


def leaves_out(findings: Sequence[Finding]) -> bool:
    """Tell whether places on facets that are cut were left out, of which only a map tells how much stays."""
    return any(one.within is not None or (one.code in STRETCHES and one.value) for one in findings)


def tells_of_less(findings: Sequence[Finding]) -> bool:
    """Tell whether places out of reach were found of which more may stay than is known: beside facets that
    are left out, and in corners."""
    return any(one.code in (*OUT_OF_REACH, Code.CORNER_NOT_REACHED) for one in findings)


def compute_allowed_rest(settings: Settings, mesh: Mesh, keep: Bools) -> float:
    """So much may stay on the facets ``keep`` (f,), mm: twice the scallop, which is that of a flat, and the
    tolerance."""
    return 2.0 * _rest_scallop(settings, mesh, keep) + settings.proof.tolerance


def _rest_scallop(settings: Settings, mesh: Mesh, keep: Bools) -> float:
    """Return the scallop, mm, that the passes leave: the one asked for, or that of the stepover."""
    cutter, passes, tool = settings.cutter.cutter, settings.passes, settings.tool_axis
    if passes.stepover is None:
        return read_scallop(settings) or 0.0
    if steps_over_strips(settings):  # no scallop stands between such passes
        return 0.0
    turned = tool.max_tilt if settings.gouge.gouge == "tilt" else 0.0
    lean = axis_options(settings)
    stand = (tool.tool_axis, replace(lean, tilt=max(abs(lean.tilt), turned)))
    return max(scallop_of(cutter, mesh, keep, angle, *stand, passes.stepover) for angle in travels(settings))


# --------------------------------------------------------------------------------------- the finished program


def cutting(motion: Bytes) -> Ints:
    """Return the blocks (k,) that cut, of a path or program with these motions (n,) of its rows; block i
    leads to row i + 1."""
    return np.flatnonzero(np.isin(motion[1:], (Motion.CUT, Motion.FILL)))


def check_for_gouges(context: MillContext, program: Program) -> GougeCheck | None:
    """Return what the tool enters of the part on its real way, where the settings ask for the check."""
    settings, tolerance = context.settings, context.settings.proof.tolerance
    if settings.gouge.gouge == "off":
        return None
    body, driven = tool_body(settings), tip_to_driven(settings)
    rapids = rapids_of(settings, context.machine, context.dialect)
    return check_program(
        context.mesh,
        body,
        context.kinematics,
        program,
        tolerance,
        driven,
        context.progress,
        _remedy(settings),
        rapids,
        _choose_freeing(settings),
    )


def enters_table(context: MillContext, program: Program) -> tuple[Finding, ...]:
    """Return what of the tool goes below the machine's table on its real way, where the settings ask for the
    check of gouges and it is known where the table is."""
    settings = context.settings
    table = table_looked_at(settings, context.machine, context.mesh)
    if table is None:
        return ()
    rapids = rapids_of(settings, context.machine, context.dialect)
    return check_table(
        table, tool_body(settings), context.kinematics, program, settings.proof.tolerance,
        tip_to_driven(settings),
        context.progress, rapids,
    )  # fmt: skip


def _remedy(settings: Settings) -> str:
    """Return what helps against an overcut: a cure, and where that has been at work already, the machine kept
    on its path."""
    if settings.gouge.gouge == "report":
        return CURES
    divisible = (
        settings.cure.linearize == "off" and settings.head.rtcp == "off"
    )  # a guided tip excludes division
    way = (
        say("let blocks be divided ({divide})", divide=DIVIDE)
        if divisible
        else say("ask for a smaller tolerance")
    )
    return say(
        "The path itself is free of the part there, but the machine leaves it between the ends of blocks: "
        "{way}.",
        way=way,
    )


def _choose_freeing(settings: Settings) -> str:
    """Return what helps against an entry of shank or holder, besides a cure at work already."""
    if settings.gouge.gouge == "tilt":
        return say(
            "No tilt that was tried frees it there. Use a longer tool or a smaller holder, or leave these "
            "places out ({leave_out}); between cuts use a larger clearance.",
            leave_out=Choice("gouge", ("leave-out",)),
        )
    if settings.gouge.gouge == "leave-out":
        return say("Use a longer tool or a smaller holder; between cuts use a larger clearance.")
    return FREEING


def compute_unfinished_share(findings: tuple[Finding, ...], mesh: Mesh, keep: Bools) -> float:
    """Return the share, 0 to 1, of the surface asked for that findings say stays unfinished; what faces away
    from the spindle is not counted. ``keep`` (f,): the facets that are cut."""
    out = _area_not_cut(findings, *NOT_CUT)
    whole = _measure_kept(findings, mesh, keep) + out
    return (out + rest_area(findings)) / whole


def divide_unfinished(
    findings: tuple[Finding, ...], mesh: Mesh, keep: Bools, mapped: bool = False
) -> Unfinished:
    """Return the share of :func:`compute_unfinished_share` with its parts: what findings say is out of reach,
    and what the settings leave. ``mapped``: whether all that stays is known from a map."""
    whole = _measure_kept(findings, mesh, keep) + _area_not_cut(findings, *NOT_CUT)
    beyond = {code: _area_not_cut(findings, code) / whole for code in WHY}
    for code, area in _divide_uncut(findings).items():
        beyond[code] += area / whole
    share = compute_unfinished_share(findings, mesh, keep)
    codes = {one.code for one in findings if one.severity is not Severity.NOTE}
    at_least = Code.CORNER_NOT_REACHED in codes and Code.UNCUT not in codes and not mapped
    return Unfinished(share, beyond, area_of(findings, *BY_SETTINGS) / whole, at_least)


def _area_not_cut(findings: Sequence[Finding], *codes: str) -> float:
    """Return the area, mm2, that findings of these codes name, but for what lies on facets that are cut."""
    return area_of(findings, *codes) - sum(
        one.within or 0.0 for one in findings if one.code in codes and one.unit == "mm2"
    )


def _divide_uncut(findings: Sequence[Finding]) -> dict[Code, float]:
    """Return how much, mm2, of what stays on facets that are cut is out of reach of other causes than those
    that are known of it by itself, by the code of WHY; no more in all than stays besides those."""
    known = (
        Code.UNCUT_TOO_TIGHT, Code.UNCUT_AT_TABLE, Code.UNCUT_AT_FIXTURE, Code.SIDE_NOT_MACHINED
    )  # fmt: skip
    room, found = area_of(findings, Code.UNCUT) - area_of(findings, *known), dict[Code, float]()
    for code in WHY:
        within = sum(one.within or 0.0 for one in findings if one.code == code)
        found[code] = min(within, max(room, 0.0))
        room -= found[code]
    return found


def compute_finished_area(findings: tuple[Finding, ...], mesh: Mesh, keep: Bools) -> float:
    """Return the area, mm2, of the facets that are cut, ``keep`` (f,), less what findings say stays on
    them."""
    return _measure_kept(findings, mesh, keep) - rest_area(findings)


def _measure_kept(findings: Sequence[Finding], mesh: Mesh, keep: Bools) -> float:
    """Return the area, mm2, of the facets ``keep`` (f,), without what of them lies inside another solid."""
    buried = sum(one.within or 0.0 for one in findings if one.code == Code.FACETS_INSIDE)
    return float(mesh.area[keep].sum()) - buried


def rest_area(findings: tuple[Finding, ...]) -> float:
    """Return the area, mm2, that stays of the facets that are cut, the strip beside faces to avoid too. Sides
    that no pass touches are uncut as well, where no map tells what is: the larger counts."""
    return max(area_of(findings, Code.UNCUT), area_of(findings, Code.SIDE_NOT_MACHINED)) + area_of(
        findings, Code.NEAR_AVOIDED_FACES
    )


def area_of(findings: Sequence[Finding], *codes: str) -> float:
    """Return the area, mm2, that findings of these codes name."""
    return float(sum(one.value or 0.0 for one in findings if one.code in codes and one.unit == "mm2"))


def find_rest_of_program(context: MillContext, program: Program) -> RestMaterial:
    """Return what the cutter leaves on the facets that are cut on its real way. Raises SettingsError where no
    block cuts."""
    settings, mesh, keep = context.settings, context.mesh, context.keep
    cutter, swept = (
        settings.cutter.cutter,
        program_motion(context.kinematics, program, tip_to_driven(settings)),
    )
    even = math.sqrt(float(mesh.area[keep].sum()) / SAMPLES)
    spacing = min(max(even, FINEST * cutter.diameter), REST_SPACING * cutter.diameter)
    blocks, within = cutting(program.motion), make_place_test(context)
    return find_rest_material(
        mesh, body_of(cutter).only(CUTTER), swept, blocks, spacing, keep, context.progress, counts=within
    )


def rest_material_findings(
    rest: RestMaterial | None, context: MillContext, earlier: Sequence[Finding] = ()
) -> tuple[Finding, ...]:
    """Where more stays than may, and, where no check tells it, where too much is taken off. ``earlier``
    findings tell what no pass touches."""
    if rest is None:
        return ()
    settings = context.settings
    deep = too_deep_finding(rest, settings.proof.tolerance) if settings.gouge.gouge == "off" else ()
    above = compute_allowed_rest(settings, context.mesh, context.keep)
    untouched = area_of(earlier, Code.SIDE_NOT_MACHINED)
    return report_uncut(rest, above, untouched) + report_blocked(rest, context, above) + deep
