# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pass strategy of half planes about an axis: passes radiate from it; along a part that is round about the axis they run
lengthwise.

seam   a plane through the axis, along which the surface is divided: on either side of it the angle about the axis rises without
       a jump.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import Option, say

from .even_steps import count_in_steps
from .field import ALL_ROUND, PassField, PassOptions, Region, Vector
from .geodesic import frames, scallop_metric
from .passes import direction
from .planes import area_left
from .refine import divided_by, joined, taken
from .scallop_passes import Ground, Surface, lay_passes, make_surface, survey_region
from .sources import BORDER

MIDDLE = "middle"

SHORTEST = 1e-9
"""Length of an axis whose direction is lost in rounding."""

STEEP = 0.9
"""Cosine between the axis and the travel from which the seam lies along Z instead."""


@dataclass(frozen=True)
class Radial:
    """Level sets of the angle about an axis, as close as the place farthest from it asks for."""

    text: str
    over_surface: bool = True

    def travels(self, options: PassOptions) -> tuple[float, ...]:
        """Every direction."""
        return ALL_ROUND

    def check(self, region: Region, options: PassOptions) -> None:
        """Raise SettingsError for an axis and a scallop that cannot be used and for more passes than any job can want."""
        _axis(options.axis)
        _centre(region, options.centre)
        survey_region(region, replace(options, source=BORDER))

    def field(self, region: Region, options: PassOptions) -> PassField:
        """Steps about the axis, the two sides of the seam one after the other."""
        region.progress("placing passes", 0.0)
        along, centre = _axis(options.axis), _centre(region, options.centre)
        ground = survey_region(region, replace(options, source=BORDER))
        across = _across(along, options.direction)
        surface = _divided(region, make_surface(region, ground), ground, centre, across)
        region.progress("placing passes", 0.5)
        offset = surface.copy.mesh.vertex - centre
        side = _sides(surface, offset @ across)
        turned = np.arctan2(np.maximum(side * (offset @ across), 0.0), side * (offset @ np.cross(across, along)))
        region.progress("placing passes", 0.7)
        return lay_passes(region, surface, count_in_steps(surface, turned))

    def untouched(self, region: Region, options: PassOptions, field: PassField, touched: Ints) -> tuple[Finding, ...]:
        """What no pass touches."""
        return field.findings + area_left(region, touched)


def _axis(given: Vector) -> Floats:
    """The unit axis (3,). Raises SettingsError."""
    if math.hypot(*given) < SHORTEST:
        text = say(
            "{option} {given} has no direction; give I,J,K along the axis, as 0,0,1", option=Option("pass_axis"),
            given=",".join(f"{number:g}" for number in given),
        )  # fmt: skip
        raise SettingsError(text, given)
    return np.array(given, dtype=np.float64) / math.hypot(*given)


def _centre(region: Region, given: str | Vector) -> Floats:
    """The point (3,) mm of the axis; the middle is that of the region's area. Raises SettingsError."""
    if not isinstance(given, str):
        return np.array(given, dtype=np.float64)
    if given != MIDDLE:
        text = say(
            "{option} {given} is neither {middle} nor X,Y,Z; give one of them", option=Option("pass_centre"), given=repr(given),
            middle=MIDDLE,
        )  # fmt: skip
        raise SettingsError(text, given)
    mesh, rows = region.mesh, np.flatnonzero(region.keep)
    middle = mesh.vertex[mesh.face[rows]].mean(axis=1)
    return np.asarray(mesh.area[rows] @ middle / mesh.area[rows].sum())


def _across(along: Floats, travel: float) -> Floats:
    """The unit normal (3,) of the seam: of the plane through the axis in which the travel, rad, lies, else Z."""
    cosine, sine = direction(travel)
    level = np.array([cosine, sine, 0.0])
    across = np.cross(along, level if abs(float(level @ along)) < STEEP else np.array([0.0, 0.0, 1.0]))
    return np.asarray(across / np.linalg.norm(across))


def _divided(region: Region, surface: Surface, ground: Ground, centre: Floats, across: Floats) -> Surface:
    """The surface whose facets on either side of the plane hang together with none of the other."""
    copy = divided_by(surface.copy, region.mesh, (surface.copy.mesh.vertex - centre) @ across)
    middle = (copy.mesh.vertex[copy.mesh.face].mean(axis=1) - centre) @ across
    both = joined(*(taken(copy, region.mesh, np.flatnonzero(half)) for half in (middle >= 0.0, middle < 0.0)))
    frame, place = frames(both.mesh.vertex, both.mesh.face), np.full(len(region.mesh.face), -1)
    place[ground.rows] = np.arange(len(ground.rows))
    tensor = ground.tensor[:, place[both.parent]]
    return Surface(both, frame, scallop_metric(frame, tensor, region.radius, ground.flat, ground.least), ground.flat)


def _sides(surface: Surface, height: Floats) -> Floats:
    """1 or -1 (v,): on which side of the plane the component of each vertex lies; ``height`` (v,) mm over it."""
    component = surface.copy.component
    high, low = np.full(int(component.max(initial=-1)) + 1, -np.inf), np.full(int(component.max(initial=-1)) + 1, np.inf)
    np.maximum.at(high, component, height)
    np.minimum.at(low, component, height)
    return np.where(high > -low, 1.0, -1.0)[component]
