# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface of a reach map in the colours of its reasons, and the axes with which its places are
reached."""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.gouge.obstacles import Obstacle
from freecad_fiveaxis.core.gouge.rest_material import surface_parts

from . import nodes
from .rest_nodes import NEARER, outside_only, shade_faces

COLOURS: dict[Obstacle, nodes.Colour] = {
    Obstacle.NONE: (0.60, 0.82, 0.62), Obstacle.CUTTER: (0.95, 0.75, 0.10),
    Obstacle.FLANK: (0.98, 0.93, 0.62),
    Obstacle.SHANK: (0.25, 0.62, 0.90),
    Obstacle.HOLDER: (0.83, 0.28, 0.10), Obstacle.FIXTURE: (0.10, 0.45, 0.45),
    Obstacle.MACHINE: (0.90, 0.45, 0.65),
    Obstacle.TABLE: (0.50, 0.38, 0.28),
    Obstacle.LIMITS: (0.58, 0.40, 0.74), Obstacle.HOLLOW: (0.35, 0.36, 0.40),
}  # fmt: skip
"""One for each reason; those who see no red and green tell them apart by their brightness."""
STROKES = 1500
"""Axes that are drawn, at most: evenly of all."""
SHARE = 0.03
"""Of the part's size: so long is a stroke where nobody asks for another length."""


def reach_surface(corner: Floats, obstacle: Any) -> Any:
    """Triangles ``corner`` (k, 3, 3) mm, each in the colour of its ``obstacle`` (k,); work frame."""
    rgb = np.array([COLOURS[one] for one in sorted(COLOURS)])[obstacle]
    return nodes.separate(
        nodes.unpickable(), nodes.flat(), outside_only(), nodes.nearer(NEARER), shade_faces(corner, rgb)
    )


def reach_axes(point: Floats, axis: Floats, length: float, colour: nodes.Colour) -> Any:
    """Return a stroke of ``length`` mm from some of the places ``point`` (k, 3) mm along their unit ``axis``
    (k, 3)."""
    some = slice(None, None, -(-len(point) // STROKES) or 1)
    ends = np.stack([point[some], point[some] + length * axis[some]], axis=1).reshape(-1, 3)
    return nodes.separate(
        nodes.unpickable(),
        nodes.flat(),
        nodes.nearer(2.0 * NEARER),
        nodes.colour(colour),
        nodes.style(line=1.5),
        nodes.lines(ends),
    )


def patches(mesh: Any, chart: Any, facets: Any) -> Floats:
    """Return the triangles (k, 3, 3) mm that the map's places stand for, in their order."""
    return surface_parts(mesh, chart.spacing, facets)[0]
