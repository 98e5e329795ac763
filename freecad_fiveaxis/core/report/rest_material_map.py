# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of rest material, as heights of facets and colours: one place for reports and 3D views.

allowed   so much may stay on the part, mm: scallops and tolerance.
neutral   the colour of what is within the tolerance below and what is allowed above.
scale     from the borders of the neutral on the colours go on by powers of ten: a scallop and a corner that
          is left can both be read. Rest material is blue, what is taken off too deep is red; colour-blind
          readers tell them apart too.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.rest_material import RestMaterial, surface_parts

NO_HEIGHT = (0.60, 0.63, 0.66)
"""The colour of facets that are not machined, red green blue, 0 to 1."""

NEUTRAL = (0.93, 0.94, 0.90)
REST = ((0.72, 0.86, 0.95), (0.34, 0.66, 0.88), (0.00, 0.40, 0.70), (0.00, 0.16, 0.42))
"""Rest material, from little to the most."""
DEEP = ((0.99, 0.85, 0.62), (0.97, 0.60, 0.35), (0.84, 0.24, 0.10), (0.50, 0.00, 0.05))
"""What is taken off too deep, from little to the most."""

LEAST_SPAN = 2.0
"""The far end of the scale is at least so many times its neutral border."""

MARKS = (1.0, 2.0, 5.0)
"""Ends of the scale are these times a power of ten."""


class HeightScale(NamedTuple):
    """mm, all above 0: down to ``tolerance`` too deep and up to ``allowed`` above is neutral; ``deepest`` and
    ``highest``: where the colours end."""

    deepest: float
    tolerance: float
    allowed: float
    highest: float


def height_scale(remainder: RestMaterial, tolerance: float, allowed: float) -> HeightScale:
    """Return the scale that holds all heights; ``tolerance`` and ``allowed`` mm, above 0."""
    low, high = (float(side.max(initial=0.0)) for side in (-remainder.height, remainder.height))
    return HeightScale(
        _round_up(max(low, LEAST_SPAN * tolerance)),
        tolerance,
        allowed,
        _round_up(max(high, LEAST_SPAN * allowed)),
    )


def _round_up(value: float) -> float:
    """Return the next of 1, 2, 5, 10 ... that is not below."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(mark * power for mark in (*MARKS, 10.0) if mark * power >= value * (1.0 - 1e-9))


def height_levels(height: Floats, scale: HeightScale) -> Floats:
    """Where heights (k,) mm stand on the scale: -1 deepest, 0 neutral, 1 highest; NaN where there is none."""
    up, down = np.maximum(height, scale.allowed), np.maximum(-height, scale.tolerance)
    above = np.log(up / scale.allowed) / np.log(scale.highest / scale.allowed)
    below = np.log(down / scale.tolerance) / np.log(scale.deepest / scale.tolerance)
    return np.asarray(np.clip(above - below, -1.0, 1.0) + 0.0 * height)


def level_colours(level: Floats) -> Floats:
    """Red, green and blue (k, 3), 0 to 1, of levels (k,); NaN is the colour of what is not machined."""
    colour = np.tile(np.array(NEUTRAL), (len(level), 1))
    for side, ramp in ((level, REST), (-level, DEEP)):
        rows = np.flatnonzero(side > 0.0)
        stops = np.linspace(0.0, 1.0, len(ramp))
        colour[rows] = np.column_stack([np.interp(side[rows], stops, tone) for tone in np.array(ramp).T])
    colour[np.isnan(level)] = NO_HEIGHT
    return colour


def height_colours(height: Floats, scale: HeightScale) -> Floats:
    """Red, green and blue (k, 3), 0 to 1, of heights (k,) mm; NaN is the colour of what is not machined."""
    return level_colours(height_levels(height, scale))


def scale_marks(scale: HeightScale) -> tuple[tuple[float, float], ...]:
    """Level and height (mm) of the marks of a legend, deepest first: both ends, both borders of the neutral,
    round values."""
    up = [scale.allowed, *_powers(scale.allowed, scale.highest), scale.highest]
    down = [scale.tolerance, *_powers(scale.tolerance, scale.deepest), scale.deepest]
    height = np.array([*(-value for value in reversed(down)), *up])
    return tuple(zip(height_levels(height, scale).tolist(), height.tolist(), strict=True))


def _powers(low: float, high: float) -> list[float]:
    """Powers of ten well between the two; where that is none, 1, 2 and 5 times them."""
    return [
        value for value in round_values(low, high) if low * 100.0 > high or math.log10(value).is_integer()
    ]


def round_values(low: float, high: float, apart: float = 1.3) -> list[float]:
    """1, 2, 5 times powers of ten between the two (above 0), from each at least so many times apart."""
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    values = [float(f"{mark:g}e{power}") for power in powers for mark in MARKS]
    return [value for value in values if apart * low < value < high / apart]


def facet_heights(remainder: RestMaterial, facets: int, tolerance: float, allowed: float) -> Floats:
    """One height (f,) mm for each of so many facets: of its samples the one that stands farthest from the
    neutral, in shares of ``tolerance`` and ``allowed`` mm. NaN where a facet has none (it is not
    machined)."""
    share = np.where(remainder.height < 0.0, -remainder.height / tolerance, remainder.height / allowed)
    order = np.argsort(share, kind="stable")  # the worst is written last
    height = np.full(facets, np.nan)
    height[remainder.facet[order]] = remainder.height[order]
    return height


def rest_material_patches(mesh: Mesh, remainder: RestMaterial) -> Floats:
    """Return the triangles (k, 3, 3) mm that the samples of the remainder stand for: finer than facets where
    those are large."""
    return surface_parts(mesh, remainder.spacing, find_machined(mesh, remainder))[0]


def find_machined(mesh: Mesh, remainder: RestMaterial) -> Bools:
    """Return the facets (f,) that have samples."""
    mask = np.zeros(len(mesh.face), np.bool_)
    mask[remainder.facet] = True
    return mask
