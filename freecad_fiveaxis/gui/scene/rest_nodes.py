# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface of a map of rest material, and the scale beside it. The colours are the core's, so that reports
show the same.

band    the middle of the legend's bar: as it should be. Above it the rest material, below it what is cut too
        deep.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge import RestMaterial
from freecad_fiveaxis.core.report.rest_material_map import (
    HeightScale,
    facet_heights,
    height_colours,
    level_colours,
    rest_material_patches,
    scale_marks,
)

from . import colours, nodes

MOST_PATCHES = 400_000
"""Parts of facets that are drawn each in its own colour; where there are more, each facet has one: that of
its worst part."""
NEARER = 0.0005
"""The map lies in the part's own surface: it is drawn before that and behind the path, by this share of the
scene's depth."""
LIGHT, SHADE = np.array([-0.36, -0.48, 0.80]), 0.78
"""Where the light comes from, and how bright it is beside it."""
BAND = 0.12
"""Share of the legend's bar that is its neutral middle."""
APART = 0.075
"""Marks of the legend stand at least so far apart, as a share of the bar."""


def rest_surface(mesh: Mesh, rest: RestMaterial, scale: HeightScale) -> Any:
    """Return the machined facets, one triangle for each sample of ``rest``, coloured by its height; work
    frame."""
    if len(rest.height) <= MOST_PATCHES:
        corner, height = rest_material_patches(mesh, rest), rest.height
    else:
        whole = facet_heights(rest, len(mesh.face), scale.tolerance, scale.allowed)
        rows = np.flatnonzero(~np.isnan(whole))
        corner, height = mesh.vertex[mesh.face[rows]], whole[rows]
    look = (nodes.unpickable(), nodes.flat(), outside_only(), nodes.nearer(NEARER))
    return nodes.separate(*look, shade_faces(corner, height_colours(height, scale)))


def shade_faces(corner: Floats, rgb: Floats) -> Any:
    """Triangles ``corner`` (k, 3, 3), each in one colour ``rgb`` (k, 3), somewhat darker where it looks away
    from the light.

    The view's own light would shade the colours until nobody finds them in the legend.
    """
    across = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    facing = np.abs(across @ LIGHT) / np.maximum(np.linalg.norm(across, axis=1), 1e-30)
    properties = nodes.vertices(
        corner.reshape(-1, 3), colours.pack_rows(rgb * (SHADE + (1.0 - SHADE) * facing)[:, None])
    )
    properties.materialBinding = coin.SoVertexProperty.PER_FACE
    faces = coin.SoFaceSet()
    faces.vertexProperty = properties
    faces.numVertices.setValues(0, len(corner), np.full(len(corner), 3, np.int32))
    return faces


def outside_only() -> Any:
    """Faces are seen from outside the part only: those of its far side would shine through thin walls."""
    hints = coin.SoShapeHints()
    hints.vertexOrdering, hints.shapeType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.SOLID
    return hints


def scale_ramp() -> Floats:
    """Return the colours (SHADES, 3) of the legend's bar, from the deepest cut up to the most rest
    material."""
    side = np.linspace(-1.0, 1.0, colours.SHADES)
    return level_colours(np.sign(side) * np.maximum(np.abs(side) - BAND, 0.0) / (1.0 - BAND))


def bar_marks(scale: HeightScale) -> list[tuple[float, float]]:
    """Where on the bar (0 to 1) the heights (mm) of its marks stand: both ends and both edges of the band,
    and between them what has room."""
    marks = [
        (0.5 + 0.5 * np.sign(height) * (BAND + (1.0 - BAND) * abs(level)), height)
        for level, height in scale_marks(scale)
    ]
    named = (-scale.deepest, -scale.tolerance, scale.allowed, scale.highest)
    chosen = [mark for mark in marks if mark[1] in named]
    for mark in marks:
        if all(abs(mark[0] - other[0]) >= APART for other in chosen):
            chosen.append(mark)
    return sorted((float(at), float(height)) for at, height in chosen)
