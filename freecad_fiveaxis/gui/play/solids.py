# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that the tool must not hit, as pictures: each drawn once, quiet, red while the tool or the spindle
is in it, and amber while they come nearer to it than is asked for."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.report.standing_bodies import SHARP, find_edges
from freecad_fiveaxis.gui.scene import nodes

GLOW = 0.3
"""How bright a body is where no light falls on it, as a share of its colour."""
EDGE = (0.16, 0.18, 0.22)
HIT: tuple[nodes.Colour, float] = ((0.88, 0.12, 0.08), 0.15)
NEAR: tuple[nodes.Colour, float] = ((0.90, 0.62, 0.0), 0.15)
"""Colour and transparency of what is hit, and of what nearly is (the orange of Okabe and Ito's palette); the
panel says which."""
CREASE = math.acos(SHARP)
"""rad: facets that meet at less are lit as one round face; those at more have their edge drawn."""
BEFORE = 0.001
"""Share of the scene's depth by which a coloured fixture lies before the document's own picture of it."""


class Look:
    """The colour of a body, which a collision or a near miss changes; ``node`` goes before its shape."""

    def __init__(self, rgb: nodes.Colour, transparency: float) -> None:
        self._quiet, self.node = (rgb, transparency), coin.SoMaterial()
        self.hit = self.near = False
        self._put(*self._quiet)

    def show(self, hit: bool, near: bool) -> None:
        """Red while the body is hit, amber while something is only near to it, else as it was."""
        if (hit, near) != (self.hit, self.near):
            self.hit, self.near = hit, near
            self._put(*(HIT if hit else NEAR if near else self._quiet))

    def _put(self, rgb: nodes.Colour, transparency: float) -> None:
        self.node.diffuseColor.setValue(*rgb)
        self.node.emissiveColor.setValue(*(GLOW * part for part in rgb))
        self.node.transparency = transparency


class DrawnFixtures:
    """The fixtures of a path, work frame. They are solids of the document, which FreeCAD draws where they
    stand and which turn with the work; here each is drawn red or amber over that, while it is hit or
    nearly."""

    def __init__(self, fixtures: Sequence[Fixture]) -> None:
        self.looks = [Look(*HIT) for _ in fixtures]
        drawn = [mesh_node(one.mesh, look) for one, look in zip(fixtures, self.looks, strict=True)]
        self.switches = [
            (one.name, nodes.switch(node, False)) for one, node in zip(fixtures, drawn, strict=True)
        ]
        self.root = nodes.separate(nodes.nearer(BEFORE), *(switch for _, switch in self.switches))

    def show(self, hit: Collection[str], near: Collection[str]) -> None:
        """Show those of these names."""
        for (name, switch), look in zip(self.switches, self.looks, strict=True):
            look.show(name in hit, name in near)
            nodes.turn(switch, name in hit or name in near)


def mesh_node(mesh: Mesh, look: Look) -> Any:
    """Return the nodes of a mesh with its edges."""
    faces, drawn = coin.SoIndexedFaceSet(), nodes.vertices(mesh.vertex)
    faces.vertexProperty = drawn
    corners = np.full((len(mesh.face), 4), -1, np.int32)
    corners[:, :3] = mesh.face
    faces.coordIndex.setValues(0, corners.size, corners.reshape(-1))
    edges = nodes.separate(
        nodes.flat(), nodes.colour(EDGE), nodes.style(1.0), nodes.lines(find_edges(mesh).reshape(-1, 3))
    )
    return nodes.separate(nodes.separate(_facing(mesh), look.node, faces), edges)


def _facing(mesh: Mesh) -> Any:
    """Of a closed mesh the back faces are left out, which would be blended with the front ones in any order;
    of an open one all are seen."""
    hints = coin.SoShapeHints()
    closed = bool((mesh.coedge_face >= 0).all())
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.SOLID if closed else coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    hints.creaseAngle = CREASE
    return hints
