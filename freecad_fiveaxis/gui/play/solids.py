# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that the tool must not hit, as pictures: each drawn once, quiet, red while the tool or the spindle
is in it, and amber while they come nearer to it than is asked for.

Large ones are drawn from a coarser copy while they move."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.geometry.reduced import reduce_mesh, share_facets
from freecad_fiveaxis.core.geometry.shading import Shaded, order_outward, shade
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.report.standing_bodies import find_edges, find_sharp
from freecad_fiveaxis.gui.scene import nodes

GLOW = 0.3
"""How bright a body is where no light falls on it, as a share of its colour."""
EDGE = (0.16, 0.18, 0.22)
HIT: tuple[nodes.Colour, float] = ((0.88, 0.12, 0.08), 0.15)
NEAR: tuple[nodes.Colour, float] = ((0.90, 0.62, 0.0), 0.15)
"""Colour and transparency of what is hit, and of what nearly is (the orange of Okabe and Ito's palette); the
panel says which."""
BUDGET = 30_000
"""Facets of all bodies together that are drawn while they move, but for small ones: a frame has 40 ms, 30 of
which Mesa takes for a window of 1920 pixels with nothing in it."""
FACETS_AN_EDGE = 4
"""Of what is drawn while it moves."""
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


class DrawnMesh:
    """A mesh that must not be hit, below ``node``: as it is while it stands still, and while it moves its
    coarser copy of at most ``most`` facets, where it has more; None: it has none. ``copy``: that copy."""

    def __init__(self, mesh: Mesh, look: Look, most: int | None = None) -> None:
        self.copy = None if most is None else reduce_mesh(mesh, most)
        edges = find_edges(mesh)
        forms = [(face_node(light(mesh)), _edges(edges))]
        if self.copy is not None:
            copied = nodes.separate(blend_in_order(), face_node(light(self.copy.mesh, outward=True)))
            forms.append((copied, _edges(_longest(edges, (most or 0) // FACETS_AN_EDGE))))
        self._faces, self._edges = (nodes.choice(*column) for column in zip(*forms, strict=True))
        line = nodes.separate(nodes.flat(), nodes.colour(EDGE), nodes.style(1.0), self._edges)
        self.node = nodes.separate(nodes.separate(_facing(mesh), look.node, self._faces), line)

    def show(self, moving: bool) -> None:
        """Draw the copy while it moves, and the mesh while it stands."""
        if self.copy is not None:
            for node in (self._faces, self._edges):
                nodes.choose(node, int(moving))

    @property
    def reduced(self) -> bool:
        """Whether the copy is drawn."""
        return nodes.get_choice(self._faces) == 1


class DrawnFixtures:
    """The fixtures of a path, work frame. They are solids of the document, which FreeCAD draws where they
    stand and which turn with the work; here each is drawn red or amber over that, while it is hit or
    nearly."""

    def __init__(self, fixtures: Sequence[Fixture]) -> None:
        self.looks = [Look(*HIT) for _ in fixtures]
        self.drawn = draw_meshes([one.mesh for one in fixtures], self.looks)
        self.switches = [
            (one.name, nodes.switch(drawn.node, False))
            for one, drawn in zip(fixtures, self.drawn, strict=True)
        ]
        self.root = nodes.separate(nodes.nearer(BEFORE), *(switch for _, switch in self.switches))

    def show(self, hit: Collection[str], near: Collection[str], moving: bool = False) -> None:
        """Show those of these names."""
        for (name, switch), look, drawn in zip(self.switches, self.looks, self.drawn, strict=True):
            look.show(name in hit, name in near)
            drawn.show(moving)
            nodes.turn(switch, name in hit or name in near)


def draw_meshes(meshes: Sequence[Mesh], looks: Sequence[Look], beside: Sequence[int] = ()) -> list[DrawnMesh]:
    """Draw meshes that move together: their copies, and those of what else is drawn with so many facets each
    ``beside`` them, have ``BUDGET`` facets between them."""
    shares = share_facets([*(len(one.face) for one in meshes), *beside], BUDGET)[: len(meshes)]
    return [DrawnMesh(*one) for one in zip(meshes, looks, shares, strict=True)]


def mesh_node(mesh: Mesh, look: Look) -> Any:
    """Return the nodes of a mesh with its edges."""
    return DrawnMesh(mesh, look).node


def blend_in_order() -> Any:
    """Return what lets facets that are seen through be blended as they come. FreeCAD's views sort them in
    every frame, which takes longer than drawing them."""
    kind = coin.SoTransparencyType()
    kind.value = coin.SoTransparencyType.SORTED_OBJECT_BLEND
    return kind


def light(mesh: Mesh, outward: bool = False) -> Shaded:
    """Return a mesh with its normals. ``outward``: in the order in which it can be blended unsorted."""
    lit = shade(mesh, find_sharp(mesh))
    return order_outward(lit) if outward else lit


def face_node(lit: Shaded) -> Any:
    """Return facets with a normal for each of their vertices: so Coin hands them to the graphics as they
    stand in memory, and need not find normals for itself, one for each corner of each facet."""
    faces, drawn = coin.SoIndexedFaceSet(), nodes.vertices(lit.vertex)
    drawn.normal.setValues(0, len(lit.normal), np.ascontiguousarray(lit.normal, np.float32))
    drawn.normalBinding = coin.SoVertexProperty.PER_VERTEX_INDEXED
    faces.vertexProperty = drawn
    corners = np.full((len(lit.face), 4), -1, np.int32)
    corners[:, :3] = lit.face
    faces.coordIndex.setValues(0, corners.size, corners.reshape(-1))
    return faces


def _edges(edges: np.ndarray) -> Any:
    return nodes.lines(edges.reshape(-1, 3))


def _longest(edges: np.ndarray, most: int) -> np.ndarray:
    """Return so many of the edges (e, 2, 3), the longest: those of small features go where facets do."""
    if len(edges) <= most:
        return edges
    length = ((edges[:, 1] - edges[:, 0]) ** 2).sum(axis=1)
    return np.asarray(edges[np.sort(np.argpartition(-length, most)[:most])])


def _facing(mesh: Mesh) -> Any:
    """Of a closed mesh the back faces are left out, which would be blended with the front ones in any order;
    of an open one all are seen."""
    hints = coin.SoShapeHints()
    closed = bool((mesh.coedge_face >= 0).all())
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.SOLID if closed else coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    return hints
