# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool as a picture: cutter, shank and holder, along z, with its driven point at zero.

What is drawn is the very body that the gouge check looks at, its outline turned about the axis.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.gouge import Outline, outline
from freecad_fiveaxis.core.tool.body import CUTTER, HOLDER, SHANK, Body
from freecad_fiveaxis.gui.scene import nodes

COLOURS = {CUTTER: (0.95, 0.76, 0.20), SHANK: (0.72, 0.74, 0.76), HOLDER: (0.45, 0.50, 0.58)}
"""Brass against the part's usual greys, bright steel and dark steel."""
TRANSPARENCY = {CUTTER: 0.0, SHANK: 0.0, HOLDER: 0.35}
TURNS = 48
"""Flat faces around the tool."""


@dataclass(frozen=True)
class DrawnTool:
    """``driven``, mm: how far the driven point lies above the tip: 0, or the corner radius where the hub is
    driven."""

    body: Body
    driven: float = 0.0


def tool_of(obj: Any, centre_driven: bool = False) -> DrawnTool:
    """Return the tool of a Toolpath or an Audit, from its properties. Raises SettingsError for one that
    cannot be."""
    from freecad_fiveaxis.app import convert

    cutter, body = convert.tool_of(obj)
    return DrawnTool(body, cutter.corner if centre_driven else 0.0)


def size_of(tool: DrawnTool) -> tuple[float, float]:
    """Return the tool's largest radius and the height of its top above the driven point, mm."""
    profile = outline(tool.body)
    points = np.concatenate([profile.start, profile.end])
    return float(points[:, 0].max()), float(points[:, 1].max()) - tool.driven


def tool_node(tool: DrawnTool) -> Any:
    """Return the tool's nodes in the tool frame."""
    shift, profile = coin.SoTranslation(), outline(tool.body)
    shift.translation.setValue(0.0, 0.0, -tool.driven)
    parts = [(part, np.flatnonzero(profile.part == part)) for part in COLOURS]
    return nodes.separate(
        shift,
        *(
            nodes.separate(
                _material(COLOURS[part], TRANSPARENCY[part]),
                _turn_outline(Outline._make(column[rows] for column in profile)),
            )
            for part, rows in parts
            if len(rows)
        ),
    )


def _turn_outline(line: Outline) -> Any:
    """Return the surface of an outline turned about z: two rings of points for each stretch, so that edges
    stay sharp."""
    around = np.linspace(0.0, 2.0 * np.pi, TURNS + 1)
    mesh, drawn = coin.SoQuadMesh(), coin.SoVertexProperty()
    points, normals = (
        _rings(np.stack([first, last], axis=1).reshape(-1, 2), around)
        for first, last in ((line.start, line.end), (line.start_normal, line.end_normal))
    )
    drawn.vertex.setValues(0, len(points), points)
    drawn.normal.setValues(0, len(normals), normals)
    drawn.normalBinding = coin.SoVertexProperty.PER_VERTEX
    mesh.vertexProperty = drawn
    mesh.verticesPerRow, mesh.verticesPerColumn = len(around), 2 * len(line.part)
    return mesh


def _rings(rows: np.ndarray, around: np.ndarray) -> np.ndarray:
    """Pairs (n, 2) of distance from the axis and height, turned: (n * turns, 3), ring by ring."""
    rings = np.empty((len(rows), len(around), 3), np.float32)
    rings[..., 0], rings[..., 1] = rows[:, :1] * np.cos(around), rows[:, :1] * np.sin(around)
    rings[..., 2] = rows[:, 1:]
    return rings.reshape(-1, 3)


def _material(rgb: nodes.Colour, transparency: float = 0.0) -> Any:
    material = coin.SoMaterial()
    material.diffuseColor.setValue(*rgb)
    material.ambientColor.setValue(*(0.4 * part for part in rgb))
    material.specularColor.setValue(0.3, 0.3, 0.3)
    material.shininess, material.transparency = 0.4, transparency
    return material
