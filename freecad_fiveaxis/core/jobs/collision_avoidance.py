# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool kept out of the part, as the settings ask: the cures on the way to the program, and check and map of the finished one.

cure      ``lift``, ``tilt`` or ``leave-out``: what is done where the tool would enter. Nothing is done where nothing enters.
allowed   so much may stay on the part, mm: scallops and tolerance.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.rapids import INTERPOLATED
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.cl.cl_offset import scallop_of
from freecad_fiveaxis.core.cl.cl_path import CLPath, Motion
from freecad_fiveaxis.core.cl.coedge import OffsetPath
from freecad_fiveaxis.core.collision import (
    CURES,
    DIVIDE,
    GougeCheck,
    RestMaterial,
    SweptMotion,
    check_program,
    find_rest_material,
    program_motion,
    real_motion,
    straight_motion,
    too_deep_finding,
    uncut_finding,
    which_enter,
)
from freecad_fiveaxis.core.collision.table_check import check_table
from freecad_fiveaxis.core.corrections.divide_rapids import RapidClearance, divide_rapids
from freecad_fiveaxis.core.corrections.lead_in import lead_in
from freecad_fiveaxis.core.corrections.leave_out import leave_out
from freecad_fiveaxis.core.corrections.left_alone import lead_over_others
from freecad_fiveaxis.core.corrections.lift import AIM, lift_path
from freecad_fiveaxis.core.corrections.near_links import LOCKED, MOST_TURN, stay_near
from freecad_fiveaxis.core.corrections.sideways import rows_left_aside
from freecad_fiveaxis.core.corrections.tilt import tilt_free
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine.kinematics import q_to_words
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.passes.keep_off import FACETS_NEAR_AVOIDED, NEAR_AVOIDED
from freecad_fiveaxis.core.tool.body import CUTTER, body_of

from .bounded import counted_places, leads_outside
from .context import MillContext
from .driving import drive
from .options import (
    axis_options,
    driven_to_surface,
    kept_off,
    lead_options,
    rapids_of,
    tip_to_driven,
    tip_to_surface,
    tool_body,
    travels,
    wanted_scallop,
)
from .over_table import table_looked_at
from .settings import Settings

LEFT_SPACING = 0.1
"""Of the cutter's diameter: how far apart, at most, the surface is looked at for what is left on it."""

FINEST = 0.02
"""The same for the map, at least: that is as fine as SAMPLES allow."""

SAMPLES = 10_000
"""Squares of the spacing into which the map divides the surface, about; each holds two or three of its triangles."""


CURED = frozenset({"lifted", "left-out"})
"""The codes of findings that tell of a path changed by a cure."""

JUDGED = frozenset({"surface-tighter-than-cutter", "heel-in-hollow"})
"""The codes of findings that only suspect what the check of the finished program then knows, cured or not."""

NOT_CUT = (
    "facets-beyond-axis-angle", "facets-beyond-machine", "facets-without-free-axis", "outside-frames", FACETS_NEAR_AVOIDED,
)  # fmt: skip
"""The codes of findings on facets that are not among those to be cut."""

HALVINGS = 6
"""Times that blocks of a cured path are halved."""


def tilted(context: MillContext, offset: OffsetPath, axis: Floats) -> tuple[OffsetPath, Floats]:
    """The path with the tool tilted free of the part, where the settings ask for that; else what is given."""
    settings = context.settings
    if settings.gouge.gouge != "tilt":
        return offset, axis
    tree = facet_tree(context.obstacles)
    cutter, most, tolerance = settings.cutter.cutter, settings.tool_axis.max_tilt, settings.proof.tolerance
    body, above = tool_body(settings), tip_to_surface(settings)
    return tilt_free(offset, axis, cutter, body, tree, context.kinematics, most, tolerance, context.progress, above)


def left_out_rows(context: MillContext, sat: OffsetPath, axis: Floats) -> tuple[OffsetPath, Floats]:
    """The rows that can be cut without entering the part, where the settings ask to leave out the others. ``sat``: with hubs."""
    settings = context.settings
    if settings.gouge.gouge != "leave-out":
        return sat, axis
    body, cutter, tolerance = tool_body(settings), settings.cutter.cutter, settings.proof.tolerance
    limit = AIM * tolerance if cutter.ring == 0.0 else tolerance  # a ring rocks from facet to facet
    tree, above = facet_tree(context.obstacles), tip_to_surface(settings)
    return leave_out(sat, axis, tree, body, limit, cutter.corner, context.progress, above)


def lifted(context: MillContext, path: CLPath) -> tuple[CLPath, float]:
    """The path with the tool lifted out of the part, where the settings ask for that, else the very path given; and how deep, mm,
    what a cure leaves of entries may still be."""
    settings, tolerance = context.settings, context.settings.proof.tolerance
    if settings.gouge.gouge in ("lift", "tilt"):
        body, tree = tool_body(settings), facet_tree(context.obstacles)
        driven, above = tip_to_driven(settings), tip_to_surface(settings)
        aside = rows_left_aside(path, settings.cutter.cutter)
        lifted = lift_path(path, tree, body, tolerance, driven, context.progress, above, aside)
        return lifted.path, lifted.left
    return path, AIM * tolerance if any(finding.code == "left-out" for finding in path.findings) else 0.0


def near_the_part(context: MillContext, path: CLPath) -> CLPath:
    """The path with links that stay near the part wherever the tool is free there; the very path where nothing is looked at."""
    settings = context.settings
    if settings.gouge.gouge == "off" or settings.links.links == "over":
        return path
    radius, limit = settings.cutter.cutter.radius, AIM * settings.proof.tolerance
    tree, driven, above = facet_tree(context.obstacles), tip_to_driven(settings), tip_to_surface(settings)
    body, kinematics = tool_body(settings), context.kinematics
    spared = None if context.chosen is None else lambda begin, end: _leads_where_nothing_is_cut(context, path, begin, end)
    turned = MOST_TURN if context.frames is None else LOCKED
    return stay_near(path, tree, body, radius, limit, driven, above, context.progress, kinematics, spared, turned)


def _leads_where_nothing_is_cut(context: MillContext, path: CLPath, begin: Ints, end: Ints) -> Bools:
    """Which straight ways from rows ``begin`` to rows ``end`` (w,) of the path lead over facets that are not machined, or out of
    the boundary."""
    chosen = np.ones(len(context.mesh.face), np.bool_) if context.chosen is None else context.chosen
    over = lead_over_others(path.contact[begin], path.contact[end], context.mesh, chosen)
    return np.asarray(over | leads_outside(context, path, begin, end))


def led_in(context: MillContext, path: CLPath) -> CLPath:
    """Enter and leave passes on arcs, where the settings ask for that; else give the very path."""
    settings = context.settings
    if settings.links.lead_in == 0.0:
        return path
    return lead_in(path, facet_tree(context.obstacles), kept_off(settings), lead_options(context), context.progress)


def drive_free(context: MillContext, path: CLPath, entering: float) -> tuple[CLPath, JointPath]:
    """The path and its joint path (:func:`.driving.drive`). Where a cure is asked for and blocks may be divided, rows are put in
    half-way where the tool still enters on its real way though the path itself does not: the machine turns the axis otherwise
    than on a great arc, and with the tip within the tolerance the rest of the cutter may swing farther."""
    settings, joints = context.settings, drive(context, path, entering)
    if settings.cure.linearize != "on" or settings.gouge.gouge in ("off", "report"):
        return path, joints
    asked = np.arange(len(path.tip))
    for _ in range(HALVINGS):
        rows = _entering(context, path, joints, asked)
        if not len(rows):
            break
        path = _halved(path, rows, driven_to_surface(settings))
        joints = drive(context, path, entering)
        fresh = rows + np.arange(len(rows))
        asked = np.union1d(fresh, fresh + 1)  # both halves; of all else the machine goes the way that was clear
    return path, joints


def keep_rapids_clear(context: MillContext, joints: JointPath) -> JointPath:
    """Divide the rapids that are clear only if interpolated, where the controller may drive their axes independently and the part
    is looked at; else give the very joint path."""
    settings = context.settings
    if settings.gouge.gouge == "off" or rapids_of(settings, context.machine, context.dialect) == INTERPOLATED:
        return joints
    body, limit, back = tool_body(settings), settings.proof.tolerance, tip_to_driven(settings)
    clearance = RapidClearance(body, facet_tree(context.obstacles), back, limit, context.progress)
    return divide_rapids(joints, context.kinematics, context.dialect, clearance)


def _entering(context: MillContext, path: CLPath, joints: JointPath, asked: Ints) -> Ints:
    """Find the rows (k,) of the path, of those ``asked`` (n,) for, to which the machine leads the cutter through the part, and
    the path itself does not."""
    settings, progress = context.settings, context.progress
    cutter, tree, limit = tool_body(settings).only(CUTTER), facet_tree(context.obstacles), settings.proof.tolerance
    real = real_motion(context.kinematics, q_to_words(joints.q), tip_to_driven(settings))
    fed = np.flatnonzero((joints.path.motion[1:] != Motion.RAPID) & np.isin(joints.row[1:], asked))  # links near the part too
    blocks = np.flatnonzero(which_enter(cutter, tree, real, limit, fed, progress))
    rows = np.unique(joints.row[blocks + 1])
    rows = rows[rows > 0]
    commanded = _commanded(settings, path)
    return rows[~which_enter(cutter, tree, commanded, limit, rows - 1, progress)[rows - 1]]


def _commanded(settings: Settings, path: CLPath) -> SweptMotion:
    """The way that the path commands: the point straight that makes the surface."""
    return straight_motion(path.tip - tip_to_driven(settings) * path.axis, path.axis, tip_to_surface(settings))


def _halved(path: CLPath, rows: Ints, above: float = 0.0) -> CLPath:
    """The path with a row half-way to each of these rows (k,), of which it takes all but its place and axis; the point ``above``
    mm over the driven one goes straight."""
    pose = straight_motion(path.tip, path.axis, above).pose(rows - 1, np.full(len(rows), 0.5))
    given = {name: getattr(path, name) for name in ("motion", "feed", "contact", "normal", "face", "coedge", "pass_")}
    columns = {name: np.insert(column, rows, column[rows], axis=0) for name, column in given.items()}
    tip, axis = np.insert(path.tip, rows, pose.tip.T, axis=0), np.insert(path.axis, rows, pose.axis.T, axis=0)
    return replace(path, tip=tip, axis=axis, **columns)


def uncut_by_cure(context: MillContext, path: CLPath) -> tuple[Finding, ...]:
    """What a cure leaves on the facets that are cut beyond scallops and tolerance; nothing is looked for where there was no
    cure, or where the map of what is left tells it."""
    settings, mesh, keep = context.settings, context.mesh, context.keep
    if settings.gouge.left == "on" or not CURED & {finding.code for finding in path.findings}:
        return ()
    cutter = settings.cutter.cutter
    swept = _commanded(settings, path)
    spacing, above, blocks = LEFT_SPACING * cutter.diameter, allowed(settings, mesh, keep), cutting(path.motion)
    within = counted_places(context)
    left = find_rest_material(mesh, body_of(cutter).only(CUTTER), swept, blocks, spacing, keep, context.progress, above, within)
    return uncut_finding(left, above)


def allowed(settings: Settings, mesh: Mesh, keep: Bools) -> float:
    """So much may stay on the facets ``keep`` (f,), mm: twice the scallop, which is that of a flat, and the tolerance."""
    return 2.0 * _left_scallop(settings, mesh, keep) + settings.proof.tolerance


def _left_scallop(settings: Settings, mesh: Mesh, keep: Bools) -> float:
    """The scallop, mm, that the passes leave: the one asked for, or that of the stepover."""
    cutter, passes, tool = settings.cutter.cutter, settings.passes, settings.tool_axis
    if passes.stepover is None:
        return wanted_scallop(settings) or 0.0
    turned = tool.max_tilt if settings.gouge.gouge == "tilt" else 0.0
    stand = (tool.tool_axis, replace(axis_options(settings), tilt=max(abs(tool.tilt), turned)))
    return max(scallop_of(cutter, mesh, keep, angle, *stand, passes.stepover) for angle in travels(settings))


# ------------------------------------------------------------------------------------------------ the finished program


def cutting(motion: Bytes) -> Ints:
    """The blocks (k,) that cut, of a path or program with these motions (n,) of its rows; block i leads to row i + 1."""
    return np.flatnonzero(np.isin(motion[1:], (Motion.CUT, Motion.FILL)))


def entered(context: MillContext, program: Program) -> GougeCheck | None:
    """What the tool enters of the part on its real way, where the settings ask for the check."""
    settings, tolerance = context.settings, context.settings.proof.tolerance
    if settings.gouge.gouge == "off":
        return None
    body, driven = tool_body(settings), tip_to_driven(settings)
    rapids = rapids_of(settings, context.machine, context.dialect)
    return check_program(
        context.mesh, body, context.kinematics, program, tolerance, driven, context.progress, _remedy(settings), rapids
    )


def enters_table(context: MillContext, program: Program) -> tuple[Finding, ...]:
    """What of the tool goes below the machine's table on its real way, where the settings ask for the check of gouges and it is
    known where the table is."""
    settings = context.settings
    table = table_looked_at(settings, context.machine, context.mesh)
    if table is None:
        return ()
    rapids = rapids_of(settings, context.machine, context.dialect)
    return check_table(
        table, tool_body(settings), context.kinematics, program, settings.proof.tolerance, tip_to_driven(settings),
        context.progress, rapids,
    )  # fmt: skip


def _remedy(settings: Settings) -> str:
    """What helps against an overcut: a cure, and where that has been at work already, the machine kept on its path."""
    if settings.gouge.gouge == "report":
        return CURES
    divisible = settings.cure.linearize == "off" and settings.head.rtcp == "off"  # a guided tip excludes division
    way = say("let blocks be divided ({divide})", divide=DIVIDE) if divisible else say("ask for a smaller tolerance")
    return say("The path itself is free of the part there, but the machine leaves it between the ends of blocks: {way}.", way=way)


def still_true(findings: tuple[Finding, ...], check: GougeCheck | None) -> tuple[Finding, ...]:
    """The findings without those that the check of the finished program, where there was one, has settled."""
    return findings if check is None else tuple(one for one in findings if one.code not in JUDGED)


def unfinished_share(findings: tuple[Finding, ...], mesh: Mesh, keep: Bools) -> float:
    """The share, 0 to 1, of the surface asked for that findings say stays unfinished; what faces away from the spindle is not
    counted. ``keep`` (f,): the facets that are cut."""
    out = area_of(findings, *NOT_CUT)
    whole = float(mesh.area[keep].sum()) + out
    return (out + rest_area(findings)) / whole


def finished_area(findings: tuple[Finding, ...], mesh: Mesh, keep: Bools) -> float:
    """The area, mm2, of the facets that are cut, ``keep`` (f,), less what findings say stays on them."""
    return float(mesh.area[keep].sum()) - rest_area(findings)


def rest_area(findings: tuple[Finding, ...]) -> float:
    """The area, mm2, that stays of the facets that are cut, the strip beside faces to avoid too. Sides that no pass touches are
    uncut as well: the larger counts."""
    return max(area_of(findings, "uncut"), area_of(findings, "side-not-machined")) + area_of(findings, NEAR_AVOIDED)


def area_of(findings: tuple[Finding, ...], *codes: str) -> float:
    """The area, mm2, that findings of these codes name."""
    return float(sum(one.value or 0.0 for one in findings if one.code in codes and one.unit == "mm2"))


def find_left(context: MillContext, program: Program) -> RestMaterial:
    """What the cutter leaves on the facets that are cut on its real way. Raises SettingsError where no block cuts."""
    settings, mesh, keep = context.settings, context.mesh, context.keep
    cutter, swept = settings.cutter.cutter, program_motion(context.kinematics, program, tip_to_driven(settings))
    even = math.sqrt(float(mesh.area[keep].sum()) / SAMPLES)
    spacing = min(max(even, FINEST * cutter.diameter), LEFT_SPACING * cutter.diameter)
    blocks, within = cutting(program.motion), counted_places(context)
    return find_rest_material(mesh, body_of(cutter).only(CUTTER), swept, blocks, spacing, keep, context.progress, counts=within)


def rest_material_findings(left: RestMaterial | None, context: MillContext) -> tuple[Finding, ...]:
    """Where more stays than may, and, where no check tells it, where too much is taken off."""
    if left is None:
        return ()
    settings = context.settings
    deep = too_deep_finding(left, settings.proof.tolerance) if settings.gouge.gouge == "off" else ()
    return uncut_finding(left, allowed(settings, context.mesh, context.keep)) + deep
