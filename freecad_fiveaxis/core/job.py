# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole street on one page: from a solid's STL to a proven program.

Three ways in: ``mill`` starts at the STL, ``post`` at a CL file, ``audit`` at a finished NC file; all three end at the same
proof of the rounded words, because that is what the machine gets. ``run`` makes and proves; ``write_outputs`` writes.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from freecad_fiveaxis.core.audit import Audit, AuditOptions, audit_program
from freecad_fiveaxis.core.cl_path import CLPath, LinkOptions, Motion, link_passes, order_passes
from freecad_fiveaxis.core.coedge import OffsetPath, close_gaps
from freecad_fiveaxis.core.deform import deform_axes, trade_findings
from freecad_fiveaxis.core.deviation import Deviation, measure, without_guided
from freecad_fiveaxis.core.gouge import (
    AIM,
    Body,
    GougeCheck,
    Remainder,
    body_of,
    check_program,
    facet_tree,
    find_remainder,
    leave_out,
    lift_path,
    program_course,
    straight_course,
    tilt_free,
    too_deep_finding,
    uncut_finding,
)
from freecad_fiveaxis.core.joint_path import JointPath, solve
from freecad_fiveaxis.core.kinematics import Chain, Setup, chain, q_to_words
from freecad_fiveaxis.core.linearize import linearize
from freecad_fiveaxis.core.machine import Machine, load_machine
from freecad_fiveaxis.core.mesh import Mesh, read_stl
from freecad_fiveaxis.core.minimax import minimax_axes
from freecad_fiveaxis.core.nc_reader import dialect_of_text, read_nc
from freecad_fiveaxis.core.passes import ContactPath, place_planes, reachable_facets, slice_mesh
from freecad_fiveaxis.core.program import Program, block_findings, build_program
from freecad_fiveaxis.core.report import Figures, as_html, as_json, as_text, blocks_csv, judge, rates_csv

from .apt import ClHead, cutter_note, read_cl_file, write_apt
from .cutter import cutter_name
from .errors import SettingsError
from .faces import facets_on
from .feasible import feasible_rows
from .files import check_writable, read_bytes, write_whole
from .findings import Finding
from .post import Dialect, PostOptions, find_dialect
from .post.head import slot_texts
from .post.writer import write_nc
from .progress import Progress, silent
from .records import Bools, Floats
from .seating import corner_radius, scallop_of, seated, spacing_radius
from .settings import AUDIT, MILL, POST, Settings, flat_options, is_part
from .singularity import Singularity, find_singular, in_cone
from .tool_axis import AxisOptions, find_strategy, tool_axes

DEFAULT_CONTROLLER = "linuxcnc"
DEFAULT_SCALLOP = 0.01
"""mm, where neither a scallop nor a stepover is asked for: a usual finishing quality."""

LEFT_SPACING = 0.1
"""Of the cutter's diameter: how far apart the surface is looked at for what is left on it."""


@dataclass(frozen=True, eq=False)
class Made:
    """A program of rounded words, not yet proven, with the machine that it is for."""

    settings: Settings
    machine: Machine
    links: Chain
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
    """A proven program. ``findings`` of every stage, in the order of the street. ``audit``: only of a program not made here;
    ``gouge`` and ``left``: what enters the part on the real way, and what stays on it, where the settings ask for that."""

    made: Made
    deviation: Deviation
    singularity: Singularity
    findings: tuple[Finding, ...]
    audit: Audit | None = None
    gouge: GougeCheck | None = None
    left: Remainder | None = None


def run(settings: Settings, progress: Progress = silent) -> Result:
    """Do the task that the settings name. Raises FiveAxisError for input that cannot be used; writes nothing."""
    return prove(make(settings, progress), progress)


def make(settings: Settings, progress: Progress = silent, mesh: Mesh | None = None, faces: Bools | None = None) -> Made:
    """The program, not yet proven. ``mesh``: what to mill, where it is at hand and ``settings.source`` only its name;
    ``faces`` (f,): the facets of it that are to be cut, None: all. Raises FiveAxisError for input that cannot be used."""
    machine, links, dialect = _machine(settings)
    if settings.task in (MILL, POST):
        dialect = _told(settings, dialect)
    if settings.task == MILL:
        find_strategy(settings.tool_axis.tool_axis)
        mesh = read_stl(settings.source, progress) if mesh is None else mesh
        faces, said = _faces(settings, mesh, faces, progress)
        milled = mill(settings, mesh, machine, links, dialect, progress, faces)
        return replace(milled, findings=said + milled.findings) if said else milled
    if settings.task == POST:
        return post(settings, machine, links, dialect, progress)
    text = read_bytes(settings.source, "NC file")
    dialect, found = (dialect, ()) if settings.machine.controller else dialect_of_text(text, dialect)
    program = read_nc(text, links, dialect, progress)
    return Made(settings, machine, links, dialect, program, found + program.findings)


def _faces(settings: Settings, mesh: Mesh, faces: Bools | None, progress: Progress) -> tuple[Bools | None, tuple[Finding, ...]]:
    """The facets to cut: those chosen already, else those on the faces that the settings name. Raises FiveAxisError."""
    name = settings.faces.faces
    if faces is not None or name is None:
        return faces, ()
    return facets_on(mesh, read_stl(name, progress), settings.proof.tolerance, Path(name).name, progress)


def _told(settings: Settings, dialect: Dialect) -> Dialect:
    """The dialect as it is to be written: high-speed mode, tip guided. Raises SettingsError, before the long work, for what the
    controller has not, and for a head that cannot be written."""
    dialect = dialect.fast() if settings.head.high_speed == "on" else dialect
    dialect = dialect if settings.head.rtcp == "off" else dialect.guided(settings.head.rtcp)
    slot_texts(dialect, "", _head(settings), inverse_time=False)
    return dialect


def mill(
    settings: Settings, mesh: Mesh, machine: Machine, links: Chain, dialect: Dialect, progress: Progress = silent,
    faces: Bools | None = None,
) -> Milled:  # fmt: skip
    """From a mesh to a program: the street itself. ``faces`` (f,): the facets to cut; the others are still kept clear of."""
    passes, cutter = settings.passes, settings.cutter.cutter
    low, high = mesh.vertex.min(axis=0), mesh.vertex.max(axis=0)
    keep, left_out = reachable_facets(mesh, links, passes.max_axis_angle, faces)
    planes, spacing = _planes(settings, mesh, keep, progress)
    contact = slice_mesh(mesh, planes, passes.direction, progress=progress)
    closed = close_gaps(
        contact, mesh, corner_radius(cutter), settings.cutter.coedge_tolerance, None if keep.all() else keep, progress
    )
    ordered = order_passes(closed, settings.links.order)
    axis = tool_axes(ordered, settings.tool_axis.tool_axis, _axis_options(settings))
    offset, axis = feasible_rows(ordered, axis, links, cutter.taper)
    led, said = _led(settings, offset, axis, links, progress)
    turned, led = _tilted(settings, offset, led, mesh, links, progress)
    way = linked(settings, turned, led, mesh, progress)
    path, entering = _lifted(settings, way, mesh, progress)
    uncut = _uncut(settings, path, mesh, keep, progress)
    found = mesh.findings + left_out + spacing + contact.findings + turned.findings + said + path.findings + uncut
    posted = _posted(settings, path, low, high, machine, links, dialect, found, progress, entering)
    return Milled(**vars(posted), mesh=mesh, contact=contact, offset=offset, axis=axis, keep=keep)


def _planes(settings: Settings, mesh: Mesh, keep: Bools, progress: Progress) -> tuple[Floats, tuple[Finding, ...]]:
    """Where the planes lie. For what is no ball: at most as far apart as on a flat, for beyond that its bottom ends."""
    passes, cutter, scallop = settings.passes, settings.cutter.cutter, _scallop(settings)
    radius, more = cutter.radius, {}
    if scallop is not None and cutter.ring > 0.0:
        stand = (settings.tool_axis.tool_axis, _axis_options(settings))
        radius, more = spacing_radius(cutter, mesh, keep, passes.direction, *stand, scallop), {"widest": 1.0}
    return place_planes(
        mesh, passes.direction, radius, stepover=passes.stepover, scallop=scallop, least=passes.least_interval, keep=keep,
        progress=progress, **more,
    )  # fmt: skip


def tool_body(settings: Settings) -> Body:
    """Cutter, shank and holder."""
    return body_of(settings.cutter.cutter, settings.gouge.shank, settings.gouge.holder)


def _tilted(
    settings: Settings, offset: OffsetPath, axis: Floats, mesh: Mesh, links: Chain, progress: Progress
) -> tuple[OffsetPath, Floats]:
    """The path with the tool tilted free of the part, where the settings ask for that; else what is given."""
    if settings.gouge.gouge != "tilt":
        return offset, axis
    cutter, most, tolerance = settings.cutter.cutter, settings.tool_axis.max_tilt, settings.proof.tolerance
    return tilt_free(offset, axis, cutter, tool_body(settings), facet_tree(mesh), links, most, tolerance, progress)


def _left_out(settings: Settings, sat: OffsetPath, axis: Floats, mesh: Mesh, progress: Progress) -> tuple[OffsetPath, Floats]:
    """The rows that can be cut without entering the part, where the settings ask to leave out the others. ``sat``: with hubs."""
    if settings.gouge.gouge != "leave-out":
        return sat, axis
    body, back = tool_body(settings), settings.cutter.cutter.corner
    return leave_out(sat, axis, facet_tree(mesh), body, AIM * settings.proof.tolerance, back, progress)


def _lifted(settings: Settings, path: CLPath, mesh: Mesh, progress: Progress) -> tuple[CLPath, float]:
    """The path with the tool lifted out of the part, where the settings ask for that, else the very path given; and how deep, mm,
    what a cure leaves of entries may still be."""
    tolerance = settings.proof.tolerance
    if settings.gouge.gouge in ("lift", "tilt"):
        lifted = lift_path(path, facet_tree(mesh), tool_body(settings), tolerance, _back(settings), progress)
        return lifted.path, lifted.left
    return path, AIM * tolerance if any(finding.code == "left-out" for finding in path.findings) else 0.0


def _uncut(settings: Settings, path: CLPath, mesh: Mesh, keep: Bools, progress: Progress) -> tuple[Finding, ...]:
    """What a cure leaves on the facets ``keep`` (f,) beyond scallops and tolerance; nothing is looked for where there was no
    cure, or where the map of what is left tells it."""
    if settings.gouge.left == "on" or not {"lifted", "left-out"} & {finding.code for finding in path.findings}:
        return ()
    cutter = settings.cutter.cutter
    course = straight_course(path.tip - _back(settings) * path.axis, path.axis)
    cuts = np.flatnonzero(np.isin(path.motion[1:], (Motion.CUT, Motion.FILL)))
    left = find_remainder(mesh, body_of(cutter), course, cuts, LEFT_SPACING * cutter.diameter, keep, progress)
    return uncut_finding(left, allowed(settings, mesh, keep))


def allowed(settings: Settings, mesh: Mesh, keep: Bools) -> float:
    """So much may stay on the facets ``keep`` (f,), mm: twice the scallop, which is that of a flat, and the tolerance."""
    return 2.0 * _left_scallop(settings, mesh, keep) + settings.proof.tolerance


def _left_scallop(settings: Settings, mesh: Mesh, keep: Bools) -> float:
    """The scallop, mm, that the passes leave: the one asked for, or that of the stepover."""
    cutter, passes, tool = settings.cutter.cutter, settings.passes, settings.tool_axis
    if passes.stepover is None:
        return _scallop(settings) or 0.0
    turned = tool.max_tilt if settings.gouge.gouge == "tilt" else 0.0
    stand = (tool.tool_axis, replace(_axis_options(settings), tilt=max(abs(tool.tilt), turned)))
    return scallop_of(cutter, mesh, keep, passes.direction, *stand, passes.stepover)


def linked(settings: Settings, offset: OffsetPath, axis: Floats, mesh: Mesh, progress: Progress = silent) -> CLPath:
    """The CL path through the contacts with tool axes ``axis`` (n, 3), one for each row of ``offset``: the cutter sits anew on
    each of them, whatever led its axis there."""
    options = LinkOptions(
        clearance=settings.links.clearance, feed=settings.feeds.feed, plunge_feed=settings.feeds.plunge_feed,
        control_point=settings.machine.control_point,
    )  # fmt: skip
    low, high = mesh.vertex.min(axis=0), mesh.vertex.max(axis=0)
    sat, axis = seated(offset, axis, settings.cutter.cutter, settings.cutter.coedge_tolerance)
    sat, axis = _left_out(settings, sat, axis, mesh, progress)
    path = link_passes(sat, axis, settings.cutter.cutter, low, high, options, progress)
    return path if sat is offset else replace(path, findings=sat.findings[len(offset.findings) :] + path.findings)


def _led(
    settings: Settings, offset: OffsetPath, axis: Floats, links: Chain, progress: Progress
) -> tuple[Floats, tuple[Finding, ...]]:
    """The strategy's axes, led where the settings ask for it: to the least deviation, then past the pole."""
    tool, cure, distance, ring = settings.tool_axis, settings.cure, reach(settings), settings.cutter.cutter.ring
    if tool.tool_axis == "minimax":
        axis = minimax_axes(offset, axis, links, distance, tool.max_tilt, settings.feeds.feed, progress, ring)
    if cure.singularity != "deform":
        return axis, ()
    made, led = deform_axes(offset, axis, links, cure.max_axis_change, progress)
    tolerance = settings.proof.tolerance
    if not led:
        return made, led
    return made, led + trade_findings(offset, axis, links, cure.max_axis_change, tolerance, distance, progress, ring)


def reach(settings: Settings) -> float:
    """From the driven point to the hub (the ball's centre), mm."""
    return settings.cutter.cutter.corner if settings.machine.control_point == "tip" else 0.0


def post(settings: Settings, machine: Machine, links: Chain, dialect: Dialect, progress: Progress = silent) -> Posted:
    """From a CL file (APT) to a program. The part is not known: rapids that are added stay off the box of the feed moves."""
    file = read_cl_file(read_bytes(settings.source, "CL file"), settings.feeds.feed, progress)
    settings, path = with_head(settings, file.head), file.path
    feeding = path.tip[path.motion != Motion.RAPID] if (path.motion != Motion.RAPID).any() else path.tip
    low, high = feeding.min(axis=0), feeding.max(axis=0)
    return _posted(
        settings,
        path,
        low,
        high,
        machine,
        links,
        dialect,
        path.findings + cutter_note(file.head, settings.cutter.cutter),
        progress,
    )


def with_head(settings: Settings, said: ClHead) -> Settings:
    """The settings with the tool, speed and coolant of a CL file where they have none of their own."""
    given = settings.head
    head = replace(
        given, tool=said.tool if given.tool is None else given.tool, spindle=given.spindle or said.speed,
        coolant="on" if said.coolant else given.coolant,
    )  # fmt: skip
    return replace(settings, head=head)


def _posted(
    settings: Settings, path: CLPath, low: Floats, high: Floats, machine: Machine, links: Chain, dialect: Dialect,
    found: tuple[Finding, ...], progress: Progress, entering: float = 0.0,
) -> Posted:  # fmt: skip
    """``entering`` mm: so much of the tolerance the path itself uses up."""
    joints = solve(path, links, low, high, settings.links.clearance, settings.cutter.cutter.radius, progress)
    joints = _linearized(settings, joints, machine, links, dialect, settings.proof.tolerance - entering, progress)
    program = build_program(joints, links, dialect, settings.feeds.feed_mode == "g93", progress)
    nc = write_nc(program, dialect, _nc_title(settings, machine), _head(settings), progress)
    findings = found + block_findings(joints.findings, program) + program.findings
    return Posted(settings, machine, links, dialect, program, findings, path, joints, nc)


def _linearized(
    settings: Settings, joints: JointPath, machine: Machine, links: Chain, dialect: Dialect, tolerance: float, progress: Progress
) -> JointPath:
    """The joint path with the blocks divided that the settings name: all feed blocks over tolerance, or those in the cone."""
    cure = settings.cure
    if cure.linearize == "on":
        return linearize(joints, links, dialect, tolerance, None, progress)
    if cure.singularity == "linearize":
        near = in_cone(links, q_to_words(joints.q), machine.singular_cone)
        return linearize(joints, links, dialect, tolerance, near, progress)
    return joints


def prove(made: Made, progress: Progress = silent) -> Result:
    """The deviation of every block of a program, its proven bound, and the blocks near the pole.

    Where the controller guides the tip there is nothing to measure, and nothing is proven but the blocks' ends.
    """
    proof, words = made.settings.proof, made.program.words
    deviation = measure(made.links, words, proof.method, progress)
    if (guided := made.program.guided) is not None:
        deviation = without_guided(deviation, guided.on, guided.tip)
    singularity = find_singular(made.links, words, made.machine.singular_cone)
    judged = judge(made.links, made.program, deviation, singularity, proof.tolerance)
    gouge, left = _entered(made, progress), _left(made, progress)
    entered = (gouge.findings if gouge else ()) + (_said_of(left, made) if left is not None and isinstance(made, Milled) else ())
    found = made.findings + deviation.findings + entered + judged
    if made.settings.task != AUDIT:
        return Result(made, deviation, singularity, found, gouge=gouge, left=left)
    audited = _audited(made, deviation, progress)
    return Result(made, deviation, singularity, found + audited.findings, audited)


def _audited(made: Made, deviation: Deviation, progress: Progress) -> Audit:
    """Limits and rates (of a program made here they hold by its making), and the comparison that the settings ask for."""
    settings, proof = made.settings, made.settings.proof
    gouge = settings.gouge
    body = tool_body(settings) if gouge.gouge != "off" or gouge.shank or gouge.holder else None
    options = AuditOptions(proof.tolerance, settings.audit.axis_tolerance, settings.cutter.cutter, body)
    return audit_program(made.links, made.program, deviation, _compared(settings, progress), options, progress)


def _compared(settings: Settings, progress: Progress) -> CLPath | Mesh | None:
    """The CL path or the part that a program is audited against. Raises FiveAxisError where it cannot be read."""
    path = settings.audit.against
    if path is None:
        return None
    if is_part(path):
        return read_stl(path, progress)
    return read_cl_file(read_bytes(path, "CL file"), settings.feeds.feed, progress).path


def _entered(made: Made, progress: Progress) -> GougeCheck | None:
    """What the tool enters of the part on its real way, where it is known and the settings ask for the check."""
    if not isinstance(made, Milled) or made.settings.gouge.gouge == "off":
        return None
    tolerance = made.settings.proof.tolerance
    return check_program(made.mesh, tool_body(made.settings), made.links, made.program, tolerance, _back(made.settings), progress)


def _left(made: Made, progress: Progress) -> Remainder | None:
    """What the cutter leaves, where the part is known and the settings ask for it."""
    return what_is_left(made, progress) if isinstance(made, Milled) and made.settings.gouge.left == "on" else None


def what_is_left(made: Milled, progress: Progress = silent) -> Remainder:
    """What the cutter leaves on the machined facets on its real way. Raises SettingsError where no block cuts."""
    cutter, course = made.settings.cutter.cutter, program_course(made.links, made.program, _back(made.settings))
    cuts = np.flatnonzero(np.isin(made.program.motion[1:], (Motion.CUT, Motion.FILL)))
    return find_remainder(made.mesh, body_of(cutter), course, cuts, LEFT_SPACING * cutter.diameter, made.keep, progress)


def _said_of(left: Remainder, made: Milled) -> tuple[Finding, ...]:
    """Where more stays than may, and, where no check tells it, where too much is taken off."""
    settings = made.settings
    deep = too_deep_finding(left, settings.proof.tolerance) if settings.gouge.gouge == "off" else ()
    return uncut_finding(left, allowed(settings, made.mesh, made.keep)) + deep


def _back(settings: Settings) -> float:
    """How far above the tip the point lies that the words drive, mm."""
    return settings.cutter.cutter.corner - reach(settings)


def figures(result: Result) -> Figures:
    """What the report is made from."""
    made = result.made
    return Figures(
        title=_title(made.settings), kind=made.settings.task, machine=made.machine, links=made.links,
        program=made.program, deviation=result.deviation, singularity=result.singularity,
        tolerance=made.settings.proof.tolerance, findings=result.findings, inputs=flat_options(made.settings),
        audit=result.audit, gouge=result.gouge, left=result.left,
        allowed=allowed(made.settings, made.mesh, made.keep) if isinstance(made, Milled) else 0.0,
        mesh=made.mesh if isinstance(made, Milled) else None,
    )  # fmt: skip


def check_outputs(settings: Settings) -> None:
    """Before the long work: every file can be written, has a known ending, and is not the source. Raises FiveAxisError."""
    output = settings.output
    named = (output.output, output.cl, output.blocks, settings.recover.machine_file, output.rates, *output.report)
    targets = [path for path in named if path]
    given = (settings.source, settings.recover.program, settings.audit.against, settings.faces.faces)
    reads = [read for read in given if read]
    for path in targets:
        check_writable(path)
        if os.path.realpath(path) in map(os.path.realpath, reads):
            raise SettingsError(f"{path} is the file that is read; name another output", path)
    if len({os.path.realpath(path) for path in targets}) < len(targets):
        raise SettingsError("two outputs have the same name; name each file apart", targets)
    for path in output.report:
        if Path(path).suffix.lower() not in REPORTS:
            raise SettingsError(f"report {path} needs one of the endings {', '.join(REPORTS)}", path)


REPORTS = {".json": as_json, ".html": as_html, ".htm": as_html, ".txt": as_text}


def write_outputs(result: Result, progress: Progress = silent) -> list[str]:
    """Write the files that the settings name, each whole or not at all; returns their names. Raises FileError."""
    files = {**_program_files(result.made), **_report_files(result, progress)}
    for path, data in files.items():
        write_whole(path, data)
    return list(files)


def _program_files(made: Made) -> dict[str, bytes]:
    output, files = made.settings.output, {}
    if isinstance(made, Posted) and output.output:
        files[output.output] = made.nc
    if isinstance(made, Posted) and output.cl:
        files[output.cl] = write_apt(
            made.path, made.settings.cutter.cutter, _title(made.settings), head=_cl_head(made.settings)
        )  # fmt: skip
    return files


def _report_files(result: Result, progress: Progress) -> dict[str, bytes]:
    output, files = result.made.settings.output, {}
    if output.blocks:
        files[output.blocks] = blocks_csv(result.made.program, result.deviation, result.singularity, progress, result.gouge)
    if (rates := output.rates) and result.audit is not None:
        files[rates] = rates_csv(result.made.links, result.made.program, result.audit, progress)
    if output.report:
        sheets = figures(result)
        files |= {path: REPORTS[Path(path).suffix.lower()](sheets).encode("utf-8", "backslashreplace") for path in output.report}
    return files


def _machine(settings: Settings) -> tuple[Machine, Chain, Dialect]:
    machine, setup, dialect = clamped(settings)
    return machine, chain(machine, setup), dialect


def dialect_for(controller: str | None, machine: Machine | None) -> Dialect:
    """The dialect of the controller that is named, else of the machine's own, else the usual one. Raises SettingsError."""
    return find_dialect(controller or (machine.controller if machine else "") or DEFAULT_CONTROLLER)


def clamped(settings: Settings) -> tuple[Machine, Setup, Dialect]:
    """The machine, where the part stands on it, and its dialect."""
    given = settings.machine
    machine = load_machine(given.machine)
    dialect = dialect_for(given.controller, machine)
    if given.tool_length is None and machine.has_head:
        raise SettingsError(f"machine {machine.name} has a rotary head: give --tool-length, gauge point to tip", None)
    length = given.tool_length or 0.0
    if given.control_point == "centre":
        length -= settings.cutter.cutter.corner
    return machine, Setup(machine.origin if given.origin is None else given.origin, length), dialect


def _scallop(settings: Settings) -> float | None:
    passes = settings.passes
    return DEFAULT_SCALLOP if passes.scallop is None and passes.stepover is None else passes.scallop


def _axis_options(settings: Settings) -> AxisOptions:
    tool = settings.tool_axis
    return AxisOptions(fixed=tool.axis, lead=tool.lead, tilt=tool.tilt)


def _head(settings: Settings) -> PostOptions:
    head = settings.head
    tool = None if head.tool is None else int(head.tool)
    return PostOptions(tool, head.spindle, head.coolant == "on", head.work_offset, blend=head.blend)


def _cl_head(settings: Settings) -> ClHead:
    options = _head(settings)
    return ClHead(options.tool, options.speed, options.coolant)


def _nc_title(settings: Settings, machine: Machine) -> str:
    """What the machinist must have ready. No file's name: the same solid and settings give the same bytes from anywhere."""
    return f"{machine.name}, {cutter_name(settings.cutter.cutter)}"


def _title(settings: Settings) -> str:
    return Path(settings.source).name
