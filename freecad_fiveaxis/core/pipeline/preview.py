# SPDX-License-Identifier: LGPL-2.1-or-later
"""The passes of the settings, laid without anything that comes after them: no tool axes, gouge cure, links,
joints and NC.

They are those of :func:`.milling.mill` but for what these later stages leave out or trim: places under which
the cutter does not fit, and where axes are chosen freely those that no axis gets to, which is not looked at
here. Of very many passes only some are laid, as far apart as every second, third, ... would be: a picture
shows no more, and what it takes grows with their square.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.orientation.axis_field import MARGIN
from freecad_fiveaxis.core.orientation.find_frames import find_frames
from freecad_fiveaxis.core.passes import (
    ContactPath,
    facets_under_axes,
    facets_within_limits,
    find_pass_strategy,
    with_room,
)
from freecad_fiveaxis.core.passes.scallop import flat_interval
from freecad_fiveaxis.core.toolpath.cl_offset import cl_offset_path

from .above_floors import find_floors
from .bounded import cut_by_hub
from .context import MillContext
from .fewer_axes import keeps_its_axis, suit_tool_axis
from .job import choose_facets
from .machine_around import bodies_in_pose
from .mill_context import Area, begin_context, find_area, find_region, find_standing, name_whole
from .options import machine_of, reacher_in, read_scallop
from .over_table import AUTO, largest_axis_angle
from .plan_passes import keep_off_faces, keep_within_boundary, offset_contacts, plan_passes
from .records import PlannedPasses
from .settings import FRAMES, Settings
from .stl_files import read_mesh

SQUARES = 3500.0
"""So many squares of an interval's side the passes may divide what is cut into; about a second of work."""
HIGHEST = 0.4
"""Of the cutter's radius: the largest scallop that passes are laid for here."""


@dataclass(frozen=True, eq=False)
class Preview:
    """``point`` (n, 3) mm, work frame, of the lines ``polyline`` (n,) that the cutter touches the part along,
    one row after the other; ``pass_`` (n,) that each is of; ``feed`` mm/min. ``findings``: what stays uncut,
    and how the facets were chosen. ``one_in``: of so many passes one is laid; length and time are then
    estimates of all."""

    point: Floats
    polyline: Ints
    pass_: Ints
    feed: float
    findings: tuple[Finding, ...] = ()
    one_in: int = 1

    def __post_init__(self) -> None:
        freeze(self, None, point="f3", polyline="i", pass_="i")

    @property
    def passes(self) -> int:
        """How many passes are laid."""
        return len(np.unique(self.pass_))

    @property
    def length(self) -> float:
        """Length of all lines, mm; links are not among them."""
        step = np.linalg.norm(np.diff(self.point, axis=0), axis=1)
        return self.one_in * float(step[np.diff(self.polyline) == 0].sum())

    @property
    def time(self) -> float:
        """How long cutting alone takes at the feed, s."""
        return 60.0 * self.length / self.feed

    @property
    def sizes(self) -> Ints:
        """How many rows (k,) each line has."""
        return np.diff(np.flatnonzero(np.diff(self.polyline, prepend=-1, append=-1)))


def preview_passes(
    settings: Settings, progress: Progress = silent, mesh: Mesh | None = None, faces: Bools | None = None
) -> Preview:
    """Lay the passes of the settings, and nothing more. ``mesh``: what to mill, where it is at hand and
    ``settings.source`` only its name; ``faces`` (f,): the facets of it that are to be cut, None: all. Raises
    FiveAxisError for what cannot be used."""
    settings = suit_tool_axis(settings, load_machine(settings.machine.machine))
    find_pass_strategy(settings.passes.passes)
    mesh = read_mesh(settings, settings.source, progress) if mesh is None else mesh
    mesh, faces, avoided, reports = choose_facets(settings, mesh, faces, progress)
    context, left_out = _context(settings, mesh, faces, progress, find_area(settings, mesh, faces, avoided))
    context, one_in = _sparser(context)
    passes = plan_passes(context, find_region(context.settings, mesh, context.keep, progress, context.frames))
    whole = context.boundary is None and context.keep_off is None
    columns = _cut_rows(passes.contact, context.keep) if whole else _within_boundary(context, passes)
    found = (*reports, *left_out, *passes.findings)
    return Preview(*_without_doubles(*columns), feed=settings.feeds.feed, findings=found, one_in=one_in)


def _sparser(context: MillContext) -> tuple[MillContext, int]:
    """With passes as far apart as every k-th of those asked for, and k: 1 where they are few, or a stepover
    gives their distance, which takes no time. On a flat a scallop between passes s apart is ``r - sqrt(r^2 -
    s^2 / 4)``, ``r`` the cutter's radius."""
    scallop, radius = read_scallop(context.settings), context.settings.cutter.cutter.radius
    if scallop is None or scallop >= HIGHEST * radius:
        return context, 1
    interval = flat_interval(radius, scallop)
    squares = float(context.mesh.area[context.keep].sum()) / interval**2
    most = int(flat_interval(radius, HIGHEST * radius) / interval)
    one_in = max(1, min(most, math.ceil(math.sqrt(squares / SQUARES))))
    if one_in == 1:
        return context, 1
    higher = radius - math.sqrt(radius**2 - 0.25 * (one_in * interval) ** 2)
    passes = replace(context.settings.passes, scallop=higher)
    return replace(context, settings=replace(context.settings, passes=passes)), one_in


def _context(
    settings: Settings, mesh: Mesh, faces: Bools | None, progress: Progress, area: Area
) -> tuple[MillContext, tuple[Finding, ...]]:
    """As :func:`.mill_context.mill_context`, with all facets over which an axis may lean where axes are
    chosen freely."""
    machine, kinematics, dialect = machine_of(settings)
    most = largest_axis_angle(settings, machine, mesh)
    context = begin_context(settings, mesh, machine, kinematics, dialect, progress, area)
    frames, left_out = None, tuple[Finding, ...]()
    if settings.tool_axis.tool_axis != AUTO:
        followed = None if keeps_its_axis(settings, machine) else kinematics
        keep, left_out = facets_within_limits(mesh, followed, most, area.facets)
    else:
        standing = find_standing(settings, mesh, faces)
        wanted = context.keep & ~standing
        keep = wanted & facets_under_axes(mesh, most)
        if settings.passes.passes == FRAMES:  # they are what the passes lie in
            bodies = bodies_in_pose(settings, machine, with_room(kinematics), mesh, (), progress, MARGIN)
            context = replace(context, bodies=bodies, floors=find_floors(context, standing))
            reacher, count = reacher_in(context), int(settings.passes.frames)
            frames, keep, left_out = find_frames(
                context.obstacles, wanted, reacher, most, count, progress, name_whole(mesh, context.chosen)
            )
    if not keep.any():
        raise ReachError(say("no facet can be cut: over none of those chosen the tool axis may stand"), None)
    return replace(context, keep=keep, frames=frames), area.findings + left_out


Columns = tuple[Floats, Ints, Ints]
"""Points (n, 3) mm, lines (n,) and passes (n,)."""


def _cut_rows(contact: ContactPath, keep: Bools) -> Columns:
    """Return the rows on facets that are cut; a line ends where others lie between."""
    rows = np.flatnonzero(keep[contact.face])
    segment, line = contact.segment[rows], contact.polyline[rows]
    begins = (np.diff(line, prepend=-1) != 0) | (np.diff(segment, prepend=-1) > 1)
    return contact.point[rows], np.cumsum(begins) - 1, contact.pass_[rows]


def _within_boundary(context: MillContext, passes: PlannedPasses) -> Columns:
    """Return the rows within the boundary and off the faces to avoid; the centre of a cutter that is no ball
    is taken as over the surface's normal."""
    offset = keep_off_faces(context, keep_within_boundary(context, offset_contacts(context, passes))).offset
    cutter = context.settings.cutter
    if (
        context.boundary is not None
        and context.settings.boundary.boundary_by == "centre"
        and not cutter.cutter.touches_as_ball
    ):
        seated, axis = cl_offset_path(offset, offset.normal, cutter.cutter, cutter.coedge_tolerance)
        offset, _ = cut_by_hub(context, seated, axis)
    return offset.point, offset.polyline, offset.pass_


def _without_doubles(point: Floats, line: Ints, pass_: Ints) -> Columns:
    """Without rows at the place of the one before, as where a facet's exit is the next one's entry."""
    same = (np.diff(line, prepend=-1) == 0) & (np.diff(point, axis=0, prepend=point[:1]) == 0.0).all(axis=1)
    return point[~same], line[~same], pass_[~same]
