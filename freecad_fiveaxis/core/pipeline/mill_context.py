# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the stages of a mill job take: the part, where it stands, and which of its facets are cut with which
axes."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools
from freecad_fiveaxis.core.base.sentences import Option, say
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.orientation.axis_field import MARGIN
from freecad_fiveaxis.core.orientation.facets_with_axis import (
    OF_PART,
    OF_WANTED,
    AxisField,
    Whole,
    find_axis_field,
    select_facets,
)
from freecad_fiveaxis.core.orientation.find_frames import find_frames
from freecad_fiveaxis.core.orientation.free_in_frames import stands_in
from freecad_fiveaxis.core.orientation.spacing_by_facet import space_by_facet
from freecad_fiveaxis.core.orientation.spacing_radius import scallop_of, spacing_radius
from freecad_fiveaxis.core.passes import (
    Region,
    facets_around,
    facets_under_axes,
    facets_within_limits,
    find_pass_strategy,
    flat_interval,
    report_far_side,
    report_standing,
    standing_facets,
    with_room,
)
from freecad_fiveaxis.core.passes.boundary import Boundary
from freecad_fiveaxis.core.passes.frames import Frames
from freecad_fiveaxis.core.passes.keep_off import KeepOff
from freecad_fiveaxis.core.passes.radial_passes import unit_axis

from .above_floors import find_floors
from .avoided import facets_off, keep_off_of
from .blockers import list_blockers
from .bounded import boundary_of, facets_inside
from .collision_avoidance import tells_of_less
from .context import MillContext, obstacles_of
from .fewer_axes import keeps_its_axis
from .machine_around import bodies_in_pose
from .options import axis_options, pass_options, reacher_in, travels
from .over_table import AUTO, largest_axis_angle, report_part_in_table
from .overlapping import find_buried_facets, measure_partly_buried, report_buried
from .settings import FRAMES, Settings
from .settings.tree import BY_FACET, FROM_AXIS


class Area(NamedTuple):
    """What may be machined of a mesh: ``facets`` (f,), None: all; within which ``boundary``, and what the
    tool is to ``keep_off``, None where there is none; ``findings``: what is left out for that."""

    facets: Bools | None
    boundary: Boundary | None
    keep_off: KeepOff | None
    findings: tuple[Finding, ...]


def find_area(settings: Settings, mesh: Mesh, faces: Bools | None, avoided: Bools | None) -> Area:
    """Return what the settings let be machined of ``faces`` (f,), None: all, beside those ``avoided`` (f,),
    None: none. Raises SettingsError, FileError."""
    keep_off, boundary = keep_off_of(settings, mesh, avoided), boundary_of(settings)
    inside, outside = facets_inside(settings, boundary, mesh, faces)
    inside, near = facets_off(keep_off, mesh, inside)
    buried = find_buried_facets(mesh)
    whole = boundary is None and keep_off is None and not buried.any()
    partly = measure_partly_buried(mesh, inside & ~buried)
    found = outside + near + report_buried(mesh, inside & buried, partly)
    return Area(faces if whole else inside & ~buried, boundary, keep_off, found)


def begin_context(
    settings: Settings, mesh: Mesh, machine: Machine, kinematics: Chain, dialect: Dialect, progress: Progress,
    area: Area, fixtures: tuple[Fixture, ...] = (),
) -> MillContext:  # fmt: skip
    """Return the context in which all of the area is cut."""
    joined, box = obstacles_of(mesh, fixtures, area.keep_off)
    keep = np.ones(len(mesh.face), np.bool_) if area.facets is None else area.facets
    return MillContext(
        settings, machine, kinematics, dialect, box, progress, mesh, keep, None, joined, area.facets,
        area.boundary, None, area.keep_off, fixtures=fixtures,
    )  # fmt: skip


def mill_context(
    settings: Settings, mesh: Mesh, machine: Machine, kinematics: Chain, dialect: Dialect, progress: Progress,
    faces: Bools | None = None, fixtures: tuple[Fixture, ...] = (), avoided: Bools | None = None,
) -> tuple[MillContext, tuple[Finding, ...]]:  # fmt: skip
    """Return the job's context, and what there is to say of facets that stay uncut. ``faces`` (f,): the
    facets to cut, None: all. ``fixtures``: what is kept clear of as the rest of the part is; ``avoided``
    (f,): the facets on faces to avoid, None: no such faces."""
    area = find_area(settings, mesh, faces, avoided)
    context = begin_context(settings, mesh, machine, kinematics, dialect, progress, area, fixtures)
    if settings.tool_axis.tool_axis == AUTO:
        context, left_out = _choose_with_axes(context, faces)
    else:
        keep, left_out = _choose_by_angle(context)
        context = replace(context, keep=keep)
    context = replace(context, unreached=tells_of_less(left_out))
    return context, area.findings + report_far_side(mesh) + left_out


def _choose_with_axes(context: MillContext, faces: Bools | None) -> tuple[MillContext, tuple[Finding, ...]]:
    """Return the context with the facets on which an axis is free, and these axes."""
    settings, mesh, machine, progress = context.settings, context.mesh, context.machine, context.progress
    most, standing = largest_axis_angle(settings, machine, mesh), find_standing(settings, mesh, faces)
    facets = context.keep & ~standing
    if not facets.any():
        raise ReachError(
            say(
                "no facet can be cut: the part stands on all that is to be cut; turn it over, or have it cut "
                "as it lies with {max_axis_angle}",
                max_axis_angle=Option("max_axis_angle"),
            ),
            None,
        )
    check_passes(settings, mesh, facets & facets_under_axes(mesh, most))
    within = with_room(context.kinematics)
    bodies = bodies_in_pose(settings, machine, within, mesh, context.fixtures, progress, MARGIN)
    context = replace(context, bodies=bodies, floors=find_floors(context, standing))
    reacher = reacher_in(context)
    to_cut = np.append(facets, np.zeros(len(context.obstacles.face) - len(facets), np.bool_))
    reports = report_standing(mesh, standing & context.keep) + report_part_in_table(settings, machine, mesh)
    field, frames, whole = None, None, name_whole(mesh, context.chosen)
    if settings.passes.passes == FRAMES:
        count = int(settings.passes.frames)
        frames, keep, left_out = find_frames(context.obstacles, to_cut, reacher, most, count, progress, whole)
    else:
        field = find_axis_field(context.obstacles, to_cut, reacher, progress)
        fixtures = [one for one in list_blockers(context) if one.name]
        keep, left_out = select_facets(field, context.obstacles, to_cut, most, reacher, fixtures, whole)
    context = replace(context, keep=keep[: len(facets)], field=field, frames=frames)
    return context, reports + left_out


def _choose_by_angle(context: MillContext) -> tuple[Bools, tuple[Finding, ...]]:
    """Return the facets (f,) over which the machine stands as the strategy wants."""
    settings, machine, mesh, kinematics = context.settings, context.machine, context.mesh, context.kinematics
    most = largest_axis_angle(settings, machine, mesh)
    if settings.tool_axis.tool_axis == FROM_AXIS:
        stand = axis_options(settings)
        through, about = np.array(stand.through), unit_axis(stand.about)
        return facets_around(mesh, kinematics, through, about, most, context.chosen)
    far_from_normals = keeps_its_axis(settings, machine) or settings.cutter.cutter.barrel is not None
    return facets_within_limits(mesh, None if far_from_normals else kinematics, most, context.chosen)


def find_standing(settings: Settings, mesh: Mesh, faces: Bools | None) -> Bools:
    """Return the facets (f,) that the part stands on, which stay uncut where axes are chosen freely and
    nobody says which are cut."""
    return np.asarray(standing_facets(mesh) & (faces is None and settings.passes.max_axis_angle is None))


def name_whole(mesh: Mesh, chosen: Bools | None) -> Whole:
    """Return of what shares of a part are told: of all its surface, or of the facets ``chosen`` (f,)."""
    if chosen is None:
        return Whole(float(mesh.area.sum()), OF_PART)
    return Whole(float(mesh.area[chosen].sum()), OF_WANTED)


def check_passes(settings: Settings, mesh: Mesh, keep: Bools) -> None:
    """Refuse, before the long work of the axis field, passes that cannot be laid on the facets ``keep`` (f,),
    over which an axis may lean. Raises SettingsError, FileError."""
    if keep.any():
        strategy = find_pass_strategy(settings.passes.passes)
        strategy.check(find_region(settings, mesh, keep, silent), pass_options(settings))


def find_region(
    settings: Settings,
    mesh: Mesh,
    keep: Bools,
    progress: Progress,
    frames: Frames | None = None,
    field: AxisField | None = None,
) -> Region:
    """Return the facets ``keep`` (f,), which are to be cut, with the ball whose passes may stand as far apart
    as the cutter's. For what is no ball: at most as far apart as on a flat, for beyond that its bottom
    ends."""
    options, cutter = pass_options(settings), settings.cutter.cutter
    radius, scallop = cutter.radius, options.scallop
    interval = options.stepover or flat_interval(radius, min(scallop or 0.0, 0.5 * radius))
    region = Region(mesh, keep, radius, interval, progress=progress, frames=frames)
    if cutter.touches_as_ball:
        return region
    stands = [(keep, (settings.tool_axis.tool_axis, axis_options(settings)))]
    if frames is not None:
        own = [keep & facets for facets in frames.facets(mesh)]
        each = list(zip(own, stands_in(frames), strict=True))
        stands = [one for one in each if one[0].any()] or [(keep, stand) for _, stand in each]
    ways = [(cutter, mesh, cut, angle, *stand) for angle in travels(settings) for cut, stand in stands]

    def find_radius(height: float) -> float:
        """Return the radius of the ball that leaves ``height`` mm at the same step, where that is least."""
        return min(spacing_radius(*way, height) for way in ways)

    if scallop is None:
        assert options.stepover is not None
        scallop = max(scallop_of(*way, options.stepover) for way in ways)
    else:
        radius = find_radius(scallop)
        if cutter.barrel is not None:
            interval = flat_interval(radius, min(scallop, 0.5 * radius))
        tool = None
        if field is not None and cutter.has_level_bottom:
            tool = space_by_facet(field, cutter, mesh, keep, radius, scallop)
        if tool is not None and settings.passes.passes != BY_FACET:
            radius, tool = tool.narrowest(mesh.area * keep), None
        region = replace(region, radius=radius, interval=interval, widest=1.0, tool=tool)
    twice = 2.0 * scallop
    return replace(region, covered=0.5 * flat_interval(find_radius(twice), twice))
