# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pass strategy of half planes about an axis: passes radiate from it; along a part that is round about
the axis they run lengthwise.

seam   a plane through the axis, along which the surface is divided: on either side of it the angle about the
       axis rises without a jump.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Option, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .contact_path import direction
from .even_steps import count_in_steps
from .field import PassField, PassOptions, Region, Vector
from .refine import Copy, divide_copy, join_copies, take_facets
from .scallop_passes import OverSurface, copy_region, lay_passes, measure_copy, survey_region
from .sources import BORDER

MIDDLE = "middle"

SHORTEST = 1e-9
"""Length of an axis whose direction is lost in rounding."""

STEEP = 0.9
"""Cosine between the axis and the travel from which the seam lies along Z instead."""


class Radial(OverSurface):
    """Level sets of the angle about an axis, as close as the place farthest from it asks for."""

    def check(self, region: Region, options: PassOptions) -> None:
        """Raise SettingsError for an axis and a scallop that cannot be used and for more passes than any job
        can want."""
        unit_axis(options.axis)
        centre_of(region, options.centre)
        survey_region(region, replace(options, source=BORDER))

    def field(self, region: Region, options: PassOptions) -> PassField:
        """Return steps about the axis, the two sides of the seam one after the other."""
        region.progress("placing passes", 0.0)
        along, centre = unit_axis(options.axis), centre_of(region, options.centre)
        ground = survey_region(region, replace(options, source=BORDER))
        across = seam_normal(along, options.direction)
        copy, side = divide_at_seam(copy_region(region, ground), region.mesh, centre, across)
        surface = measure_copy(region, ground, copy)
        region.progress("placing passes", 0.5)
        turned = angle_about(copy, side, centre, along, across)
        region.progress("placing passes", 0.7)
        return lay_passes(region, surface, count_in_steps(surface, turned))


def unit_axis(given: Vector) -> Floats:
    """Make the axis a unit vector (3,). Raises SettingsError."""
    if math.hypot(*given) < SHORTEST:
        text = say(
            "{option} {given} has no direction; give I,J,K along the axis, as 0,0,1",
            option=Option("pass_axis"),
            given=",".join(f"{number:g}" for number in given),
        )  # fmt: skip
        raise SettingsError(text, given)
    return np.array(given, dtype=np.float64) / math.hypot(*given)


def check_centre(given: str | Vector) -> None:
    """Raise SettingsError for a word that is no centre."""
    if isinstance(given, str) and given != MIDDLE:
        text = say(
            "{option} {given} is neither {middle} nor X,Y,Z; give one of them", option=Option("pass_centre"),
            given=repr(given),
            middle=MIDDLE,
        )  # fmt: skip
        raise SettingsError(text, given)


def centre_of(region: Region, given: str | Vector) -> Floats:
    """Find the point (3,) mm of the axis; the middle is that of the region's area. Raises SettingsError."""
    check_centre(given)
    if not isinstance(given, str):
        return np.array(given, dtype=np.float64)
    mesh, rows = region.mesh, np.flatnonzero(region.keep)
    middle = mesh.vertex[mesh.face[rows]].mean(axis=1)
    return np.asarray(mesh.area[rows] @ middle / mesh.area[rows].sum())


def seam_normal(along: Floats, travel: float) -> Floats:
    """Find the unit normal (3,) of the seam: of the plane through the axis in which the travel, rad, lies,
    else Z."""
    cosine, sine = direction(travel)
    level = np.array([cosine, sine, 0.0])
    across = np.cross(along, level if abs(float(level @ along)) < STEEP else np.array([0.0, 0.0, 1.0]))
    return np.asarray(across / np.linalg.norm(across))


def divide_at_seam(copy: Copy, part: Mesh, centre: Floats, across: Floats) -> tuple[Copy, Floats]:
    """Divide the copy: its facets on either side of the plane hang together with none of the other, and on
    which side each of its vertices (v,) is: 1 or -1."""
    copy = divide_copy(copy, part, (copy.mesh.vertex - centre) @ across)
    over = (copy.mesh.vertex[copy.mesh.face].mean(axis=1) - centre) @ across >= 0.0
    one, other = (take_facets(copy, part, np.flatnonzero(half)) for half in (over, ~over))
    return join_copies(one, other), np.repeat([1.0, -1.0], [len(one.mesh.vertex), len(other.mesh.vertex)])


def angle_about(copy: Copy, side: Floats, centre: Floats, along: Floats, across: Floats) -> Floats:
    """Measure the angle (v,), rad, of a divided copy's vertices about the axis: on either side of the seam
    from 0 to pi."""
    offset = copy.mesh.vertex - centre
    return np.asarray(
        np.arctan2(np.maximum(side * (offset @ across), 0.0), side * (offset @ np.cross(across, along)))
    )
