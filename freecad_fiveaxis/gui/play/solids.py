# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that the tool must not hit, as pictures: each drawn once, quiet, and red while the tool or the spindle is in it."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.collision.fixtures import Fixture
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.report.standing_bodies import SHARP, find_edges
from freecad_fiveaxis.gui.scene import nodes

GLOW = 0.3
"""How bright a body is where no light falls on it, as a share of its colour."""
EDGE = (0.16, 0.18, 0.22)
HIT: tuple[nodes.Colour, float] = ((0.88, 0.12, 0.08), 0.15)
CREASE = math.acos(SHARP)
"""rad: facets that meet at less are lit as one round face; those at more have their edge drawn."""
BEFORE = 0.001
"""Share of the scene's depth by which a red fixture lies before the document's own picture of it."""


class Look:
    """The colour of a body, which a collision changes; ``node`` goes before its shape."""

    def __init__(self, rgb: nodes.Colour, transparency: float) -> None:
        self._quiet, self.node = (rgb, transparency), coin.SoMaterial()
        self.hit = False
        self._put(*self._quiet)

    def show(self, hit: bool) -> None:
        """Red while the body is hit, else as it was."""
        if hit is not self.hit:
            self.hit = hit
            self._put(*(HIT if hit else self._quiet))

    def _put(self, rgb: nodes.Colour, transparency: float) -> None:
        self.node.diffuseColor.setValue(*rgb)
        self.node.emissiveColor.setValue(*(GLOW * part for part in rgb))
        self.node.transparency = transparency


class DrawnFixtures:
    """The fixtures of a path, work frame. They are solids of the document, which FreeCAD draws where they stand and which turn
    with the work; here each is drawn red over that, while it is hit."""

    def __init__(self, fixtures: Sequence[Fixture]) -> None:
        self.switches = [(one.name, nodes.switch(mesh_node(one.mesh, Look(*HIT)), False)) for one in fixtures]
        self.root = nodes.separate(nodes.nearer(BEFORE), *(switch for _, switch in self.switches))

    def show(self, hit: Collection[str]) -> None:
        """Show those of these names."""
        for name, switch in self.switches:
            nodes.turn(switch, name in hit)


def mesh_node(mesh: Mesh, look: Look) -> Any:
    """The nodes of a mesh with its edges."""
    faces, drawn = coin.SoIndexedFaceSet(), nodes.vertices(mesh.vertex)
    faces.vertexProperty = drawn
    corners = np.full((len(mesh.face), 4), -1, np.int32)
    corners[:, :3] = mesh.face
    faces.coordIndex.setValues(0, corners.size, corners.reshape(-1))
    edges = nodes.separate(nodes.flat(), nodes.colour(EDGE), nodes.style(1.0), nodes.lines(find_edges(mesh).reshape(-1, 3)))
    return nodes.separate(nodes.separate(_facing(mesh), look.node, faces), edges)


def _facing(mesh: Mesh) -> Any:
    """Of a closed mesh the back faces are left out, which would be blended with the front ones in any order; of an open one all
    are seen."""
    made = coin.SoShapeHints()
    closed = bool((mesh.coedge_face >= 0).all())
    made.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    made.shapeType = coin.SoShapeHints.SOLID if closed else coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    made.creaseAngle = CREASE
    return made
