# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the stages of a mill job take: the part, where it stands, and which of its facets are cut with which
axes."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.orientation.axis_field import MARGIN
from freecad_fiveaxis.core.orientation.facets_with_axis import find_axis_field, select_facets
from freecad_fiveaxis.core.orientation.find_frames import find_frames
from freecad_fiveaxis.core.orientation.free_in_frames import stands_in
from freecad_fiveaxis.core.orientation.spacing_radius import scallop_of, spacing_radius
from freecad_fiveaxis.core.passes import (
    Region,
    facets_around,
    facets_under_axes,
    facets_within_limits,
    find_pass_strategy,
    flat_interval,
    report_standing,
    standing_facets,
    with_room,
)
from freecad_fiveaxis.core.passes.frames import Frames
from freecad_fiveaxis.core.passes.radial_passes import unit_axis

from .avoided import facets_off, keep_off_of
from .bounded import boundary_of, facets_inside
from .context import MillContext, obstacles_of
from .fewer_axes import keeps_its_axis
from .machine_around import bodies_in_pose
from .options import axis_options, pass_options, reacher_of, travels
from .over_table import AUTO, largest_axis_angle, report_part_in_table
from .settings import FRAMES, Settings
from .settings.tree import FROM_AXIS


def mill_context(
    settings: Settings, mesh: Mesh, machine: Machine, kinematics: Chain, dialect: Dialect, progress: Progress,
    faces: Bools | None = None, fixtures: tuple[Fixture, ...] = (), avoided: Bools | None = None,
) -> tuple[MillContext, tuple[Finding, ...]]:  # fmt: skip
    """Return the job's context, and what there is to say of facets that stay uncut. ``faces`` (f,): the
    facets to cut, None: all. ``fixtures``: what is kept clear of as the rest of the part is; ``avoided``
    (f,): the facets on faces to avoid, None: no such faces."""
    keep_off = keep_off_of(settings, mesh, avoided)
    joined, box = obstacles_of(mesh, fixtures, keep_off)
    boundary, most = boundary_of(settings), largest_axis_angle(settings, machine, mesh)
    inside, reports = facets_inside(settings, boundary, mesh, faces)
    chosen = faces if boundary is None else inside
    if keep_off is not None:
        inside, near = facets_off(keep_off, mesh, inside)
        reports, chosen = reports + near, inside
    field, frames, bodies = None, None, None
    if settings.tool_axis.tool_axis == AUTO:
        standing = find_standing(settings, mesh, faces)
        faces = (~standing if faces is None else faces) & inside
        check_passes(settings, mesh, faces & facets_under_axes(mesh, most))
        bodies = bodies_in_pose(settings, machine, with_room(kinematics), mesh, fixtures, progress, MARGIN)
        reacher = reacher_of(settings, machine, kinematics, mesh, bodies)
        to_cut = np.append(faces, np.zeros(len(joined.face) - len(faces), np.bool_))
        reports += (*report_standing(mesh, standing & inside), *report_part_in_table(settings, machine, mesh))
        if settings.passes.passes == FRAMES:
            frames, keep, left_out = find_frames(
                joined, to_cut, reacher, most, int(settings.passes.frames), progress
            )
        else:
            field = find_axis_field(joined, to_cut, reacher, progress)
            keep, left_out = select_facets(field, joined, to_cut, most, reacher)
        keep = keep[: len(faces)]
    elif settings.tool_axis.tool_axis == FROM_AXIS:
        stand = axis_options(settings)
        keep, left_out = facets_around(
            mesh, kinematics, np.array(stand.through), unit_axis(stand.about), most, chosen
        )
    else:
        leans = (
            keeps_its_axis(settings, machine) or settings.cutter.cutter.barrel is not None
        )  # far from the normals
        followed = None if leans else kinematics
        keep, left_out = facets_within_limits(mesh, followed, most, chosen)
    context = MillContext(
        settings,
        machine,
        kinematics,
        dialect,
        box,
        progress,
        mesh,
        keep,
        field,
        joined,
        chosen,
        boundary,
        frames,
        keep_off,
        bodies,
        fixtures,
    )
    return context, (*reports, *left_out)


def find_standing(settings: Settings, mesh: Mesh, faces: Bools | None) -> Bools:
    """Return the facets (f,) that the part stands on, which stay uncut where axes are chosen freely and
    nobody says which are cut."""
    return np.asarray(standing_facets(mesh) & (faces is None and settings.passes.max_axis_angle is None))


def check_passes(settings: Settings, mesh: Mesh, keep: Bools) -> None:
    """Refuse, before the long work of the axis field, passes that cannot be laid on the facets ``keep`` (f,),
    over which an axis may lean. Raises SettingsError, FileError."""
    if keep.any():
        strategy = find_pass_strategy(settings.passes.passes)
        strategy.check(find_region(settings, mesh, keep, silent), pass_options(settings))


def find_region(
    settings: Settings, mesh: Mesh, keep: Bools, progress: Progress, frames: Frames | None = None
) -> Region:
    """Return the facets ``keep`` (f,), which are to be cut, with the ball whose passes may stand as far apart
    as the cutter's. For what is no ball: at most as far apart as on a flat, for beyond that its bottom
    ends."""
    options, cutter = pass_options(settings), settings.cutter.cutter
    radius, scallop = cutter.radius, options.scallop
    interval = options.stepover or flat_interval(radius, min(scallop or 0.0, 0.5 * radius))
    if cutter.touches_as_ball:
        return Region(mesh, keep, radius, interval, progress=progress, frames=frames)
    stands = [(settings.tool_axis.tool_axis, axis_options(settings))] if frames is None else stands_in(frames)

    def find_radius(height: float) -> float:
        """Return the radius of the ball that leaves ``height`` mm at the same step, where that is least."""
        return min(
            spacing_radius(cutter, mesh, keep, angle, *stand, height)
            for angle in travels(settings)
            for stand in stands
        )

    if scallop is None:
        assert options.stepover is not None
        left = max(
            scallop_of(cutter, mesh, keep, angle, *stand, options.stepover)
            for angle in travels(settings)
            for stand in stands
        )
        covered = 0.5 * flat_interval(find_radius(2.0 * left), 2.0 * left)
        return Region(mesh, keep, radius, interval, progress=progress, frames=frames, covered=covered)
    radius = find_radius(scallop)
    if cutter.barrel is not None:
        interval = flat_interval(radius, min(scallop, 0.5 * radius))
    twice = 2.0 * scallop
    covered = 0.5 * flat_interval(find_radius(twice), twice)
    return Region(mesh, keep, radius, interval, 1.0, progress, frames, covered)
