# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far apart the passes of a level bottom may stand on each facet, by the free axes that the tool has
there.

level    on its bottom: as far apart as that is wide.
flank    with its side along a wall: along the axis as far apart as that, round it as those of a ball of the
         cutter's radius.
aslant   on its corner, which is a ring: its curvature is that of the corner in the plane of axis and normal,
         and ``sine / (ring + corner sine)`` across that plane, sine that of the angle between axis and
         normal (Meusnier). So passes along that plane may stand farther apart than those across it.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.records import Bools
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.passes.spacing_tool import SpacingTool
from freecad_fiveaxis.core.tool import Cutter

from .axis_field import unit
from .facets_with_axis import AxisField
from .level_bottom import stand_level

SQUARE = math.cos(math.radians(1.0))
"""Cosine to the normal from which a bottom lies on the surface."""

ALONG = math.sin(math.radians(1.0))
"""Sine to the surface below which the side of the cutter lies along it."""

SHARP = 0.2
"""Of its radius: a flat that stands aslant is taken to have such a corner; it has none, and would never be
done."""


def space_by_facet(
    field: AxisField, cutter: Cutter, mesh: Mesh, keep: Bools, wide: float, scallop: float
) -> SpacingTool | None:
    """Return how the cutter bends where it touches each facet (f,); ``wide`` mm: the radius of the ball whose
    passes may stand as far apart as those of the level bottom. None where it stands level everywhere."""
    rows = np.flatnonzero(keep)
    normal = mesh.normal[rows]
    axis = stand_level(field.at(mesh.vertex[mesh.face[rows]].mean(axis=1), normal), normal)
    cosine = (axis * normal).sum(axis=1)
    level, flank = cosine > SQUARE, np.abs(cosine) < ALONG
    if level.all():
        return None
    corner = max(cutter.corner, SHARP * cutter.radius, 1.001 * scallop)
    sine = np.sqrt(np.maximum(1.0 - cosine**2, 0.0))
    ring = max(cutter.radius - corner, 0.0)
    across = np.minimum(corner + ring / np.maximum(sine, 1e-3), wide)
    hard = np.where(level, wide, np.where(flank, np.minimum(cutter.radius, wide), np.minimum(corner, wide)))
    soft = np.where(level | flank, wide, np.maximum(across, hard))
    turned = unit(np.cross(normal, axis))
    way = np.where(flank[:, None], axis, turned)
    radius, softer, along = np.full(len(keep), wide), np.full(len(keep), wide), np.zeros((len(keep), 3))
    radius[rows], softer[rows], along[rows] = hard, soft, way
    return SpacingTool(radius, softer, along)
