# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pass strategy of frames: constant scallop, or planes, in each of a few 3+2 positions, one after the
other.

frame      a position of the rotary axes, that is a tool axis fixed while passes are cut
           (orientation/find_frames.py finds them).
territory  what of the surface is cut in a frame: of the places about which the frame was chosen those that it
           sees flattest.
planes     contain the frame's axis, as upright ones do on a machine of three axes.
overlap    where two territories meet on a smooth surface each is cut beyond their seam by a step.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .field import PassField, PassOptions, Region
from .frames import Frames
from .refine import Copy, join_copies, take_facets
from .scallop import hand_curvature_on
from .scallop_passes import (
    ConstantScallop,
    Ground,
    copy_region,
    lay_passes,
    lay_steps,
    measure_copy,
    survey_region,
)
from .spacing import WIDEST, prepare_planes

OVERLAP = 1.0
"""Steps beyond the seam."""

ALIKE = 0.5
"""Difference of unit normals beyond which there is no smooth seam between them: about 29 deg."""

ALONG = 1e-6
"""Sine between a frame's axis and the travel below which the travel runs along the axis."""

SCALLOP, PLANES = "scallop", "planes"
"""What is laid within a frame."""

SEEN = 0.05
"""Cosine between an axis and the normal of what may be cut with it beyond a seam."""


class FramePasses(ConstantScallop):
    """Level sets of the distance from the border of each territory, or of that across planes, frame after
    frame."""

    def field(self, region: Region, options: PassOptions) -> PassField:
        """Return steps from the border of the territories, or mm across planes in them, one after the other.
        Where there are no frames the whole region is one, of constant scallop."""
        if region.frames is None:
            return super().field(region, options)
        region.progress("placing passes", 0.0)
        ground = survey_region(region, options)
        whole = copy_region(region, ground)
        fields = list[_InFrame]()
        for frame, rows in _territories(whole, region.frames, ground.flat):
            part = take_facets(whole, region.mesh, rows)
            region.progress("placing passes", frame / len(region.frames.axis))
            if options.within == PLANES:
                fields.append(_InFrame(frame, _lay_planes(region, options, part, region.frames.axis[frame])))
            else:
                fields.append(_InFrame(frame, _cut_whole(region, ground, part)))
        return _one_after_the_other(fields)


class _InFrame(NamedTuple):
    frame: int
    field: PassField


def _cut_whole(region: Region, ground: Ground, part: Copy) -> PassField:
    surface = measure_copy(region, ground, part)
    return lay_passes(region, surface, lay_steps(surface, ground.curve))


def _lay_planes(region: Region, options: PassOptions, part: Copy, axis: Floats) -> PassField:
    """Planes along the axis (3,) of a frame, and along the direction as far as that lies across it; mm from
    the first facet."""
    hand_curvature_on(region.mesh, part.mesh, part.parent)
    across = _across(axis, options.direction)
    place = prepare_planes(
        part.mesh, options.direction, region.radius, stepover=options.stepover, scallop=options.scallop,
        least=options.least,
        progress=region.progress, widest=region.widest or WIDEST, normal=across,
    )  # fmt: skip
    levels, found = place()
    value = part.mesh.vertex @ across
    low = float(value.min())
    return PassField(value - low, levels - low, found, surface=part)


def _across(axis: Floats, angle: float) -> Floats:
    """Return the unit normal (3,) of planes that contain the axis and the travel at ``angle`` rad from X;
    where that runs along the axis, the level one across."""
    travel = np.array([math.cos(angle), math.sin(angle), 0.0])
    across = np.cross(axis, travel)
    length = float(np.linalg.norm(across))
    return across / length if length > ALONG else np.array([-travel[1], travel[0], 0.0])


def _territories(whole: Copy, frames: Frames, step: float) -> list[tuple[int, Ints]]:
    """Return the frames that have any, with the facets of the copy in them, beyond seams too."""
    middle, normal = whole.mesh.vertex[whole.mesh.face].mean(axis=1), np.asarray(whole.mesh.normal)
    owner = frames.at(middle, normal)
    found = list[tuple[int, Ints]]()
    for frame, axis in enumerate(frames.axis):
        own = owner == frame
        if own.any():
            found.append((frame, np.flatnonzero(own | _beyond_seam(whole, own, normal @ axis > SEEN, step))))
    return found


def _beyond_seam(whole: Copy, own: Bools, seen: Bools, step: float) -> Bools:
    """Facets (f,) of the copy that are not in a territory but nearer than OVERLAP to one that looks the same
    way."""
    out, mesh = np.zeros(len(own), np.bool_), whole.mesh
    rows, inside = np.flatnonzero(~own & seen), np.flatnonzero(own)
    if not len(rows):
        return out
    reach = OVERLAP * step
    turn = reach / ALIKE * np.asarray(mesh.normal)
    corner, middle = mesh.vertex[mesh.face[inside]].reshape(-1, 3), mesh.vertex[mesh.face[rows]].mean(axis=1)
    place, sought = np.hstack([corner, np.repeat(turn[inside], 3, axis=0)]), np.hstack([middle, turn[rows]])
    out[rows] = np.isfinite(scipy.spatial.cKDTree(place).query(sought, distance_upper_bound=reach)[0])
    return out


def _one_after_the_other(fields: list[_InFrame]) -> PassField:
    """Return the fields of frames as one: none of a frame hangs together with another's, and its levels lie
    behind those before it."""
    surface, begin = fields[0].field.surface, 0.0
    value, levels, frame, findings = list[Floats](), list[Floats](), list[Ints](), list[Finding]()
    for k, (number, one) in enumerate(fields):
        assert one.surface is not None and surface is not None
        surface = surface if k == 0 else join_copies(surface, one.surface)
        value.append(one.value + begin)
        levels.append(one.levels + begin)
        frame.append(np.full(len(one.levels), number))
        findings += one.findings
        begin += float(np.ceil(one.value.max())) + 1.0
    return PassField(
        np.concatenate(value),
        np.concatenate(levels),
        tuple(findings),
        surface=surface,
        frame=np.concatenate(frame),
    )
