# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole pipeline on one page: from a solid's STL to a proven program.

Three ways in: ``mill`` starts at the STL, ``post`` at a CL file, ``audit`` at a finished NC file; all three end at the same
proof of the rounded words, because that is what the machine gets. ``run`` makes and proves; :mod:`.outputs` writes. What the
settings ask for in the terms of the packages is in :mod:`.options`, what keeps the tool out of the part in
:mod:`.collision_avoidance`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from freecad_fiveaxis.core.audit import Audit, AuditOptions, audit_program
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.cl.apt import cutter_note, cutter_taken, of_cl_file, read_cl_file
from freecad_fiveaxis.core.cl.cl_offset import cl_offset_path, corner_radius, spacing_radius
from freecad_fiveaxis.core.cl.cl_path import CLPath, LinkOptions, Motion, link_passes
from freecad_fiveaxis.core.cl.coedge import OffsetPath, close_gaps
from freecad_fiveaxis.core.cl.feasible import feasible_rows
from freecad_fiveaxis.core.cl.tool_axis import find_strategy, tool_axes
from freecad_fiveaxis.core.collision import GougeCheck, RestMaterial
from freecad_fiveaxis.core.collision.faces import facets_on
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.corrections.deform import deform_axes, trade_findings
from freecad_fiveaxis.core.corrections.linearize import linearize
from freecad_fiveaxis.core.corrections.minimax import minimax_axes
from freecad_fiveaxis.core.geometry.mesh import Mesh, read_stl
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain, q_to_words
from freecad_fiveaxis.core.motion.deviation import Deviation, measure, without_guided
from freecad_fiveaxis.core.motion.joint_path import JointPath, solve
from freecad_fiveaxis.core.motion.program import Program, block_findings, build_program
from freecad_fiveaxis.core.motion.singularity import Singularity, find_singular, in_cone
from freecad_fiveaxis.core.nc.head import slot_texts
from freecad_fiveaxis.core.nc.reader import Assumed, dialect_of_text, read_nc
from freecad_fiveaxis.core.nc.writer import write_nc
from freecad_fiveaxis.core.passes import (
    ContactPath,
    PassStrategy,
    Region,
    cut,
    facets_within_limits,
    find_pass_strategy,
    flat_interval,
)
from freecad_fiveaxis.core.report import Figures, judge

from .collision_avoidance import (
    allowed,
    cutting,
    driven_free,
    entered,
    find_left,
    left_out_rows,
    lifted,
    rest_material_findings,
    still_true,
    tilted,
    tool_body,
    uncut_by_cure,
    unfinished_share,
)
from .fewer_axes import keeps_its_axis
from .options import (
    axis_options,
    cl_reading,
    driven_to_hub,
    machine_of,
    nc_title,
    pass_options,
    post_options,
    title_of,
    with_head,
)
from .part_size import unit_suspected
from .safe_start import Box, start_findings, start_plane, started
from .settings import AUDIT, MILL, POST, Settings, flat_options, is_part


@dataclass(frozen=True, eq=False)
class Made:
    """A program of rounded words, not yet proven, with the machine that it is for."""

    settings: Settings
    machine: Machine
    kinematics: Chain
    dialect: Dialect
    program: Program
    findings: tuple[Finding, ...]


@dataclass(frozen=True, eq=False)
class Posted(Made):
    """A program made here: the CL path, the joints and the NC file's bytes."""

    path: CLPath
    joints: JointPath
    nc: bytes


@dataclass(frozen=True, eq=False)
class Milled(Posted):
    """A program made from a mesh. ``axis`` (n, 3): the strategy's tool axes, before any cure, one for each row of ``offset``;
    ``keep`` (f,): the facets that are machined."""

    mesh: Mesh
    contact: ContactPath
    offset: OffsetPath
    axis: Floats
    keep: Bools


@dataclass(frozen=True, eq=False)
class Result:
    """A proven program. ``findings`` of every stage, in the order of the pipeline. ``audit``: only of a program not made here;
    ``gouge`` and ``left``: what enters the part on the real way, and what stays on it, where the settings ask for that."""

    made: Made
    deviation: Deviation
    singularity: Singularity
    findings: tuple[Finding, ...]
    audit: Audit | None = None
    gouge: GougeCheck | None = None
    left: RestMaterial | None = None


def run(settings: Settings, progress: Progress = silent) -> Result:
    """Do the task that the settings name. Raises FiveAxisError for input that cannot be used; writes nothing."""
    return prove(make(settings, progress), progress)


def make(settings: Settings, progress: Progress = silent, mesh: Mesh | None = None, faces: Bools | None = None) -> Made:
    """The program, not yet proven. ``mesh``: what to mill, where it is at hand and ``settings.source`` only its name;
    ``faces`` (f,): the facets of it that are to be cut, None: all. Raises FiveAxisError for input that cannot be used."""
    machine, kinematics, dialect = machine_of(settings)
    if settings.task in (MILL, POST):
        dialect = _told(settings, machine, dialect)
    if settings.task == MILL:
        find_strategy(settings.tool_axis.tool_axis)
        find_pass_strategy(settings.passes.passes)
        mesh = read_stl(settings.source, progress) if mesh is None else mesh
        faces, said = _faces(settings, mesh, faces, progress)
        milled = mill(settings, mesh, machine, kinematics, dialect, progress, faces)
        return replace(milled, findings=said + milled.findings) if said else milled
    if settings.task == POST:
        return post(settings, machine, kinematics, dialect, progress)
    text = read_bytes(settings.source, "NC file")
    dialect, found = (dialect, ()) if settings.machine.controller else dialect_of_text(text, dialect)
    program = read_nc(text, kinematics, dialect, progress, Assumed(settings.reading.units, settings.reading.decimal))
    return Made(settings, machine, kinematics, dialect, program, found + program.findings)


def _faces(settings: Settings, mesh: Mesh, faces: Bools | None, progress: Progress) -> tuple[Bools | None, tuple[Finding, ...]]:
    """The facets to cut: those chosen already, else those on the faces that the settings name. Raises FiveAxisError."""
    name = settings.faces.faces
    if faces is not None or name is None:
        return faces, ()
    return facets_on(mesh, read_stl(name, progress), settings.proof.tolerance, Path(name).name, progress)


def _told(settings: Settings, machine: Machine, dialect: Dialect) -> Dialect:
    """The dialect as it is to be written: safe start, high-speed mode, tip guided. Raises SettingsError, before the long
    work, for what the controller has not, and for a head that cannot be written."""
    dialect = started(dialect, machine)
    dialect = dialect.fast() if settings.head.high_speed == "on" else dialect
    dialect = dialect if settings.head.rtcp == "off" else dialect.guided(settings.head.rtcp)
    slot_texts(dialect, "", post_options(settings), inverse_time=False)
    return dialect


def mill(
    settings: Settings, mesh: Mesh, machine: Machine, kinematics: Chain, dialect: Dialect, progress: Progress = silent,
    faces: Bools | None = None,
) -> Milled:  # fmt: skip
    """From a mesh to a program: the pipeline itself. ``faces`` (f,): the facets to cut; the others are still kept clear of."""
    cutter = settings.cutter.cutter
    low, high = mesh.vertex.min(axis=0), mesh.vertex.max(axis=0)
    followed = None if keeps_its_axis(settings, machine) else kinematics
    keep, left_out = facets_within_limits(mesh, followed, settings.passes.max_axis_angle, faces)
    strategy, options = find_pass_strategy(settings.passes.passes), pass_options(settings)
    region = _region(settings, mesh, keep, strategy, progress)
    field = strategy.field(region, options)
    contact = cut(region, field, settings.links.order)
    spacing = strategy.untouched(region, options, field, contact.face)
    closed = close_gaps(
        contact, mesh, corner_radius(cutter), settings.cutter.coedge_tolerance, None if keep.all() else keep, progress
    )
    axis = tool_axes(closed, settings.tool_axis.tool_axis, axis_options(settings))
    offset, axis = feasible_rows(closed, axis, kinematics, cutter.taper)
    led, said = _led(settings, offset, axis, kinematics, progress)
    turned, led = tilted(settings, offset, led, mesh, kinematics, progress)
    way = linked(settings, turned, led, mesh, progress)
    path, entering = lifted(settings, way, mesh, progress)

    def drive(path: CLPath) -> JointPath:
        return _driven(settings, path, low, high, machine, kinematics, dialect, progress, entering)

    path, joints = driven_free(settings, path, mesh, kinematics, drive, progress)
    uncut = uncut_by_cure(settings, path, mesh, keep, progress)
    sized = mesh.findings + unit_suspected(mesh, cutter)
    found = sized + left_out + spacing + contact.findings + turned.findings + said + path.findings + uncut
    posted = _posted(settings, path, joints, machine, kinematics, dialect, (low, high), found, progress)
    return Milled(**vars(posted), mesh=mesh, contact=contact, offset=offset, axis=axis, keep=keep)


def _region(settings: Settings, mesh: Mesh, keep: Bools, strategy: PassStrategy, progress: Progress) -> Region:
    """What is to be cut, with the ball whose passes may stand as far apart as the cutter's. For what is no ball: at most as far
    apart as on a flat, for beyond that its bottom ends."""
    options, cutter = pass_options(settings), settings.cutter.cutter
    radius, scallop = cutter.radius, options.scallop
    interval = options.stepover or flat_interval(radius, min(scallop or 0.0, 0.5 * radius))
    if scallop is None or cutter.ring == 0.0:
        return Region(mesh, keep, radius, interval, progress=progress)
    stand = (settings.tool_axis.tool_axis, axis_options(settings))
    radii = [spacing_radius(cutter, mesh, keep, angle, *stand, scallop) for angle in strategy.travels(options)]
    return Region(mesh, keep, min(radii), interval, 1.0, progress)


def linked(settings: Settings, offset: OffsetPath, axis: Floats, mesh: Mesh, progress: Progress = silent) -> CLPath:
    """The CL path through the contacts with tool axes ``axis`` (n, 3), one for each row of ``offset``: the cutter sits anew on
    each of them, whatever led its axis there."""
    options = LinkOptions(
        clearance=settings.links.clearance, feed=settings.feeds.feed, plunge_feed=settings.feeds.plunge_feed,
        control_point=settings.machine.control_point,
    )  # fmt: skip
    low, high = mesh.vertex.min(axis=0), mesh.vertex.max(axis=0)
    sat, axis = cl_offset_path(offset, axis, settings.cutter.cutter, settings.cutter.coedge_tolerance)
    sat, axis = left_out_rows(settings, sat, axis, mesh, progress)
    path = link_passes(sat, axis, settings.cutter.cutter, low, high, options, progress)
    return path if sat is offset else replace(path, findings=sat.findings[len(offset.findings) :] + path.findings)


def _led(
    settings: Settings, offset: OffsetPath, axis: Floats, kinematics: Chain, progress: Progress
) -> tuple[Floats, tuple[Finding, ...]]:
    """The strategy's axes, led where the settings ask for it: to the least deviation, then past the pole."""
    tool, cure, distance, ring = settings.tool_axis, settings.cure, driven_to_hub(settings), settings.cutter.cutter.ring
    if tool.tool_axis == "minimax":
        axis = minimax_axes(offset, axis, kinematics, distance, tool.max_tilt, settings.feeds.feed, progress, ring)
    if cure.singularity != "deform":
        return axis, ()
    made, led = deform_axes(offset, axis, kinematics, cure.max_axis_change, progress)
    tolerance = settings.proof.tolerance
    if not led:
        return made, led
    return made, led + trade_findings(offset, axis, kinematics, cure.max_axis_change, tolerance, distance, progress, ring)


def post(settings: Settings, machine: Machine, kinematics: Chain, dialect: Dialect, progress: Progress = silent) -> Posted:
    """From a CL file (APT) to a program. The part is not known: rapids that are added stay off the box of the feed moves."""
    file = read_cl_file(read_bytes(settings.source, "CL file"), cl_reading(settings), progress)
    given, path = settings, file.path
    settings = with_head(given, file.head)
    feeding = path.tip[path.motion != Motion.RAPID] if (path.motion != Motion.RAPID).any() else path.tip
    low, high = feeding.min(axis=0), feeding.max(axis=0)
    joints = _driven(settings, path, low, high, machine, kinematics, dialect, progress)
    taken = settings.cutter is not given.cutter
    found = path.findings + (cutter_taken(settings.cutter.cutter) if taken else cutter_note(file.head, settings.cutter.cutter))
    return _posted(settings, path, joints, machine, kinematics, dialect, (low, high), found, progress)


def _posted(
    settings: Settings, path: CLPath, joints: JointPath, machine: Machine, kinematics: Chain, dialect: Dialect,
    box: Box, found: tuple[Finding, ...], progress: Progress,
) -> Posted:  # fmt: skip
    program = build_program(joints, kinematics, dialect, settings.feeds.feed_mode == "g93", progress)
    height, said = start_plane(settings, machine, kinematics, program, box)
    nc = write_nc(program, dialect, nc_title(settings, machine), post_options(settings), progress, height)
    said += start_findings(settings, machine, dialect, kinematics, program, box)
    findings = found + block_findings(joints.findings, program) + program.findings + said
    return Posted(settings, machine, kinematics, dialect, program, findings, path, joints, nc)


def _driven(
    settings: Settings, path: CLPath, low: Floats, high: Floats, machine: Machine, kinematics: Chain, dialect: Dialect,
    progress: Progress, entering: float = 0.0,
) -> JointPath:  # fmt: skip
    """The joint path through ``path``, its blocks divided where the settings ask for that. ``low``, ``high`` (3,) mm: the part's
    box; ``entering`` mm: so much of the tolerance the path itself uses up."""
    joints = solve(path, kinematics, low, high, settings.links.clearance, settings.cutter.cutter.radius, progress)
    return _linearized(settings, joints, machine, kinematics, dialect, settings.proof.tolerance - entering, progress)


def _linearized(
    settings: Settings,
    joints: JointPath,
    machine: Machine,
    kinematics: Chain,
    dialect: Dialect,
    tolerance: float,
    progress: Progress,
) -> JointPath:
    """The joint path with the blocks divided that the settings name: all feed blocks over tolerance, or those in the cone."""
    cure = settings.cure
    if cure.linearize == "on":
        return linearize(joints, kinematics, dialect, tolerance, None, progress)
    if cure.singularity == "linearize":
        near = in_cone(kinematics, q_to_words(joints.q), machine.singular_cone)
        return linearize(joints, kinematics, dialect, tolerance, near, progress)
    return joints


def prove(made: Made, progress: Progress = silent) -> Result:
    """The deviation of every block of a program, its proven bound, and the blocks near the pole.

    Where the controller guides the tip there is nothing to measure, and nothing is proven but the blocks' ends.
    """
    proof, words = made.settings.proof, made.program.words
    deviation = measure(made.kinematics, words, proof.method, progress)
    if (guided := made.program.guided) is not None:
        deviation = without_guided(deviation, guided.on, guided.tip)
    singularity = find_singular(made.kinematics, words, made.machine.singular_cone)
    judged = judge(made.kinematics, made.program, deviation, singularity, proof.tolerance)
    gouge, left, entries = _against_part(made, progress)
    found = still_true(made.findings, gouge) + deviation.findings + entries + judged
    if made.settings.task != AUDIT:
        return Result(made, deviation, singularity, found, gouge=gouge, left=left)
    against = _compared(made.settings, progress)
    audited = _audited(made, deviation, against, progress)
    of_path = tuple(of_cl_file(one) for one in against.findings) if isinstance(against, CLPath) else ()
    return Result(made, deviation, singularity, found + of_path + audited.findings, audited)


def _audited(made: Made, deviation: Deviation, against: CLPath | Mesh | None, progress: Progress) -> Audit:
    """Limits and rates (of a program made here they hold by its making), and the comparison that the settings ask for."""
    settings, proof = made.settings, made.settings.proof
    gouge = settings.gouge
    body = tool_body(settings) if gouge.gouge != "off" or gouge.shank or gouge.holder else None
    options = AuditOptions(proof.tolerance, settings.audit.axis_tolerance, settings.cutter.cutter, body)
    return audit_program(made.kinematics, made.program, deviation, against, options, progress)


def _compared(settings: Settings, progress: Progress) -> CLPath | Mesh | None:
    """The CL path or the part that a program is audited against. Raises FiveAxisError where it cannot be read."""
    path = settings.audit.against
    if path is None:
        return None
    if is_part(path):
        return read_stl(path, progress)
    return read_cl_file(read_bytes(path, "CL file"), cl_reading(settings), progress).path


def _against_part(made: Made, progress: Progress) -> tuple[GougeCheck | None, RestMaterial | None, tuple[Finding, ...]]:
    """What enters the part, what is left on it, and what is to be said of both; of a program made from a mesh."""
    if not isinstance(made, Milled):
        return None, None, ()
    settings, mesh, keep = made.settings, made.mesh, made.keep
    gouge = entered(settings, mesh, made.kinematics, made.program, progress)
    left = rest_material_of(made, progress) if settings.gouge.left == "on" and len(cutting(made.program.motion)) else None
    return gouge, left, (gouge.findings if gouge else ()) + rest_material_findings(left, settings, mesh, keep)


def rest_material_of(made: Milled, progress: Progress = silent) -> RestMaterial:
    """What the cutter leaves on the machined facets on its real way. Raises SettingsError where no block cuts."""
    return find_left(made.settings, made.mesh, made.keep, made.kinematics, made.program, progress)


def figures(result: Result) -> Figures:
    """What the report is made from."""
    made = result.made
    return Figures(
        title=title_of(made.settings), kind=made.settings.task, machine=made.machine, kinematics=made.kinematics,
        program=made.program, deviation=result.deviation, singularity=result.singularity,
        tolerance=made.settings.proof.tolerance, findings=result.findings, inputs=flat_options(made.settings),
        audit=result.audit, gouge=result.gouge, left=result.left,
        allowed=allowed(made.settings, made.mesh, made.keep) if result.left and isinstance(made, Milled) else 0.0,
        mesh=made.mesh if isinstance(made, Milled) else None,
        unfinished=unfinished_share(result.findings, made.mesh, made.keep) if isinstance(made, Milled) else 0.0,
    )  # fmt: skip
