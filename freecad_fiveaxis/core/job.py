# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole street on one page: from a solid's STL to a proven program.

Three ways in: ``mill`` starts at the STL, ``post`` at a CL file, ``audit`` at a finished NC file; all three end at the same
proof of the rounded words, because that is what the machine gets.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from . import apt, report
from .block_table import blocks_csv
from .cl_path import CLPath, LinkOptions, link_passes
from .coedge import OffsetPath, close_gaps
from .deviation import Deviation, measure
from .errors import SettingsError
from .files import check_writable, read_bytes, write_whole
from .findings import Finding
from .joint_path import JointPath, solve
from .kinematics import Chain, Setup, chain
from .machine import Machine
from .machine_file import load_machine
from .mesh import Mesh
from .nc_reader import read_nc
from .passes import ContactPath, slice_mesh
from .post import Dialect, find_dialect
from .post.writer import write_nc
from .program import Program, build_program
from .progress import Progress, silent
from .reach import reachable_facets
from .records import Floats
from .report_html import as_html
from .settings import AUDIT, MILL, POST, Settings, flat_options
from .singularity import Singularity, find_singular
from .spacing import place_planes
from .stl import read_stl
from .tool_axis import AxisOptions, tool_axes

DEFAULT_SCALLOP = 0.01
"""mm, where neither a scallop nor a stepover is asked for: a usual finishing quality."""


@dataclass(frozen=True, eq=False)
class Result:
    """A proven program with all that led to it. ``findings`` of every stage, in the order of the street."""

    settings: Settings
    machine: Machine
    links: Chain
    dialect: Dialect
    program: Program
    deviation: Deviation
    singularity: Singularity
    findings: tuple[Finding, ...]


@dataclass(frozen=True, eq=False)
class PostResult(Result):
    """A program made here: the CL path, the joints and the NC file's bytes."""

    path: CLPath
    joints: JointPath
    nc: bytes


@dataclass(frozen=True, eq=False)
class MillResult(PostResult):
    """A program made from a mesh."""

    mesh: Mesh
    contact: ContactPath
    offset: OffsetPath


def run(settings: Settings, progress: Progress = silent) -> Result:
    """Do the task that the settings name. Raises FiveAxisError for input that cannot be used; writes nothing."""
    return {MILL: mill, POST: post, AUDIT: audit}[settings.task](settings, progress)


def mill(settings: Settings, progress: Progress = silent) -> MillResult:
    """From an STL file to a proven program."""
    machine, links, dialect = _machine(settings)
    mesh = read_stl(settings.source, progress)
    return mill_mesh(settings, mesh, machine, links, dialect, progress)


def mill_mesh(
    settings: Settings, mesh: Mesh, machine: Machine, links: Chain, dialect: Dialect, progress: Progress = silent
) -> MillResult:
    """From a mesh to a proven program: the street itself."""
    passes, cutter, link = settings.passes, settings.cutter.cutter, settings.links
    low, high = mesh.vertex.min(axis=0), mesh.vertex.max(axis=0)
    keep, left_out = reachable_facets(mesh, links, passes.max_axis_angle)
    planes, spacing = place_planes(
        mesh, passes.direction, cutter.radius, stepover=passes.stepover, scallop=_scallop(settings),
        least=passes.least_interval, keep=keep, progress=progress,
    )  # fmt: skip
    contact = slice_mesh(mesh, planes, passes.direction, keep, progress)
    offset = close_gaps(contact, mesh, cutter.radius, settings.cutter.coedge_tolerance, progress)
    axis = tool_axes(offset, settings.tool_axis.tool_axis, _axis_options(settings))
    options = LinkOptions(
        order=link.order, clearance=link.clearance, feed=settings.feeds.feed, plunge_feed=settings.feeds.plunge_feed,
        control_point=settings.machine.control_point,
    )  # fmt: skip
    path = link_passes(offset, axis, cutter, low, high, options, progress)
    found = mesh.findings + left_out + spacing + contact.findings + offset.findings + path.findings
    posted = _post(settings, path, low, high, machine, links, dialect, found, progress)
    return MillResult(**vars(posted), mesh=mesh, contact=contact, offset=offset)


def post(settings: Settings, progress: Progress = silent) -> PostResult:
    """From a CL file (APT) to a proven program."""
    machine, links, dialect = _machine(settings)
    path = apt.read_apt(read_bytes(settings.source, "CL file"), feed=settings.feeds.feed)
    low, high = path.tip.min(axis=0), path.tip.max(axis=0)
    return _post(settings, path, low, high, machine, links, dialect, path.findings, progress)


def _post(
    settings: Settings, path: CLPath, low: Floats, high: Floats, machine: Machine, links: Chain, dialect: Dialect,
    found: tuple[Finding, ...], progress: Progress,
) -> PostResult:  # fmt: skip
    joints = solve(path, links, low, high, settings.links.clearance, progress)
    program = build_program(joints, links, dialect, settings.feeds.feed_mode == "g93", progress)
    nc = write_nc(program, dialect, _title(settings))
    proven = prove(settings, machine, links, dialect, program, found + joints.findings + program.findings, progress)
    return PostResult(**vars(proven), path=path, joints=joints, nc=nc)


def audit(settings: Settings, progress: Progress = silent) -> Result:
    """A finished NC file of any origin."""
    machine, links, dialect = _machine(settings)
    program = read_nc(read_bytes(settings.source, "NC file"), links, dialect)
    return prove(settings, machine, links, dialect, program, program.findings, progress)


def prove(
    settings: Settings, machine: Machine, links: Chain, dialect: Dialect, program: Program, found: tuple[Finding, ...],
    progress: Progress = silent,
) -> Result:  # fmt: skip
    """The deviation of every block of a program, its proven bound, and the blocks near the pole."""
    deviation = measure(links, program.words, settings.proof.method, progress)
    singularity = find_singular(links, program.words, machine.singular_cone)
    judged = report.judge(links, program, deviation, singularity, settings.proof.tolerance)
    findings = found + deviation.findings + judged
    return Result(settings, machine, links, dialect, program, deviation, singularity, findings)


def figures(result: Result) -> report.Figures:
    """What the report is made from."""
    return report.Figures(
        title=_title(result.settings), kind=result.settings.task, machine=result.machine, links=result.links,
        program=result.program, deviation=result.deviation, singularity=result.singularity,
        tolerance=result.settings.proof.tolerance, findings=result.findings, inputs=flat_options(result.settings),
    )  # fmt: skip


def check_outputs(settings: Settings) -> None:
    """Before the long work: every file can be written, has a known ending, and is not the source. Raises FiveAxisError."""
    output = settings.output
    targets = [path for path in (output.output, output.cl, output.blocks, *output.report) if path]
    for path in targets:
        check_writable(path)
        if settings.source and os.path.realpath(path) == os.path.realpath(settings.source):
            raise SettingsError(f"{path} is the file that is read; name another output", path)
    if len({os.path.realpath(path) for path in targets}) < len(targets):
        raise SettingsError("two outputs have the same name; name each file apart", targets)
    for path in output.report:
        if Path(path).suffix.lower() not in REPORTS:
            raise SettingsError(f"report {path} needs one of the endings {', '.join(REPORTS)}", path)


REPORTS = {".json": report.as_json, ".html": as_html, ".htm": as_html, ".txt": report.as_text}


def write_outputs(result: Result) -> list[str]:
    """Write the files that the settings name, each whole or not at all; returns their names. Raises FileError."""
    output, sheets = result.settings.output, figures(result)
    made: list[tuple[str, bytes]] = []
    if output.output and isinstance(result, PostResult):
        made.append((output.output, result.nc))
    if output.cl and isinstance(result, PostResult):
        made.append((output.cl, apt.write_apt(result.path, result.settings.cutter.cutter, _title(result.settings))))
    if output.blocks:
        made.append((output.blocks, blocks_csv(result.program, result.deviation, result.singularity)))
    made += [(path, REPORTS[Path(path).suffix.lower()](sheets).encode()) for path in output.report]
    for path, data in made:
        write_whole(path, data)
    return [path for path, _ in made]


def _machine(settings: Settings) -> tuple[Machine, Chain, Dialect]:
    dialect = find_dialect(settings.machine.controller)
    machine = load_machine(settings.machine.machine)
    given = settings.machine
    if given.tool_length is None and machine.has_head:
        raise SettingsError(f"machine {machine.name} has a rotary head: give --tool-length, gauge point to tip", None)
    length = given.tool_length or 0.0
    if given.control_point == "centre":
        length -= settings.cutter.cutter.radius
    setup = Setup(machine.origin if given.origin is None else given.origin, length)
    return machine, chain(machine, setup), dialect


def _scallop(settings: Settings) -> float | None:
    passes = settings.passes
    return DEFAULT_SCALLOP if passes.scallop is None and passes.stepover is None else passes.scallop


def _axis_options(settings: Settings) -> AxisOptions:
    tool = settings.tool_axis
    return AxisOptions(fixed=tool.axis, lead=tool.lead, tilt=tool.tilt)


def _title(settings: Settings) -> str:
    return Path(settings.source).name
