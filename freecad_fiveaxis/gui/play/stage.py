# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of a played program in one 3D view.

The document is the work: FreeCAD draws part, mesh, path and markers, and two nodes are put before them into
this view's scene. The first holds what is our own: tool, rotary axes, the block's commanded segment and its
real curve. The second turns everything that FreeCAD draws after it as the table turns the work. No document
object is touched; taking the two nodes out again leaves the view as it was. While the picture moves, large
solids and meshes of the document are drawn from coarser copies.

over the part   the part stands still and the tool moves over it.
on the machine  everything moves as it really will: the table with the part on it, and the tool on its head;
                about them stand the bodies of the machine's file, and a sketch of what that does not name.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.report.playback import Pose, rotary_lines
from freecad_fiveaxis.gui.qt import translate
from freecad_fiveaxis.gui.scene import nodes
from freecad_fiveaxis.gui.scene.on_screen import Label, Labels, LegendBox
from freecad_fiveaxis.gui.scene.overlay import Legend

from .document_copies import DocumentCopies
from .machine import DrawnMachine
from .player import Struck
from .solids import DrawnFixtures
from .tool import DrawnTool, tool_node

CHORD, CURVE, TIP = (1.0, 1.0, 1.0), (0.90, 0.30, 0.0), (0.0, 0.0, 0.0)
LETTER_COLOURS = {"A": (0.85, 0.15, 0.15), "B": (0.10, 0.60, 0.10), "C": (0.25, 0.55, 1.00)}
"""As FreeCAD colours X, Y and Z, about which the axes of these letters turn."""
DASHES, WIDTH, DOT = 0x3FF3, 3.0, 7.0
IDENTITY = np.eye(4)
_NOTHING = Struck()


class Stage:
    """Nodes in a view's scene. ``graph``: the scene graph of a 3D view; ``zero`` (3,) mm: the work zero in
    the document; ``letters``: of the rotary axes it has; ``centre`` (3,) and ``reach`` mm: middle of the path
    and how far the axes are drawn. ``tip`` (3,) mm: where the tip is drawn, document coordinates."""

    def __init__(
        self,
        graph: Any,
        tool: DrawnTool,
        machine: DrawnMachine,
        fixtures: DrawnFixtures,
        document: DocumentCopies,
        zero: np.ndarray,
        letters: str,
        centre: np.ndarray,
        reach: float,
    ) -> None:
        self.machine, self.fixtures, self.document = machine, fixtures, document
        self.zero, self.centre, self.reach = np.asarray(zero, float), np.asarray(centre, float), reach
        self.tool, self.work, self.turn = (coin.SoMatrixTransform() for _ in range(3))
        self.axes, self.chord, self.curve, self.gap, self.dots = (_vertices() for _ in range(5))
        self.letters = Labels()
        self.letters.show([Label((0.0, 0.0, 0.0), letter, LETTER_COLOURS[letter]) for letter in letters])
        self._lines = len(letters)
        self.curve_line = coin.SoLineSet()
        self.root = self._root(tool, letters)
        self._graph, self.tip = graph, np.zeros(3)
        graph.ref()
        for at, node in enumerate((self.root, self.turn)):
            node.ref()
            graph.insertChild(node, at)

    @property
    def shown(self) -> bool:
        """Whether the nodes are in the view."""
        return self._graph is not None

    def show(
        self,
        pose: Pose,
        curve: np.ndarray | None,
        on_machine: bool,
        struck: Struck = _NOTHING,
        near: Struck = _NOTHING,
        moving: bool = False,
    ) -> None:
        """Draw a single moment; ``curve`` (n, 3): the judged point's real path in its block, None where it is
        drawn already; ``struck``: what is hit then, ``near``: what is come near to; ``moving``: whether the
        next moment follows at once."""
        scene_from_work = pose.machine_from_work if on_machine else IDENTITY
        scene_from_machine = IDENTITY if on_machine else pose.work_from_machine
        _put(self.work, scene_from_work)
        _put(self.tool, scene_from_machine @ pose.machine_from_tool)
        _put(self.turn, _about(scene_from_work, self.zero))
        if on_machine and self.sketch.whichChild.getValue() == coin.SO_SWITCH_NONE:
            self.legend.come_forward(
                chosen=True
            )  # how much of the machine is a sketch must be seen whatever is selected
        nodes.turn(self.sketch, on_machine)
        if on_machine:
            self.machine.show(pose.machine_from_carried, moving)
        self.machine.show_struck(struck, near)
        self.fixtures.show(struck.fixtures, near.fixtures, moving)
        self.document.show(moving)
        self._draw_axes(rotary_lines(pose, self.centre, self.reach), scene_from_machine)
        if curve is not None:
            _fill(self.curve, curve)
            _fill(self.chord, curve[[0, -1]])
            self.curve_line.numVertices.setValue(len(curve))
        _fill(self.gap, np.stack([pose.point, pose.foot]))
        _fill(self.dots, pose.point[None])
        self.tip = scene_from_work[:3, :3] @ pose.tip + scene_from_work[:3, 3] + self.zero

    def remove(self) -> None:
        """Take the nodes out of the view; it is then as it was. May be called twice, and after the view has
        gone."""
        if self._graph is None:
            return
        self.document.remove()
        for node in (self.turn, self.root):
            if self._graph.findChild(node) >= 0:
                self._graph.removeChild(node)
            node.unref()
        self._graph.unref()
        self._graph = None

    def _draw_axes(self, ends: np.ndarray, scene_from_machine: np.ndarray) -> None:
        placed = ends @ scene_from_machine[:3, :3].T + scene_from_machine[:3, 3]
        _fill(self.axes, placed.reshape(-1, 3))
        self.letters.move(placed[: self._lines, 1])

    def _root(self, tool: DrawnTool, letters: str) -> Any:
        zero = coin.SoTranslation()
        zero.translation.setValue(*self.zero)
        root = nodes.separate(nodes.unpickable(), zero, nodes.separate(self.tool, tool_node(tool)))
        root.setName("FiveAxisPlay")
        self.legend = LegendBox()
        self.legend.show(_legend_of(self.machine))
        self.sketch = nodes.switch(nodes.separate(self.machine.root, self.legend.root), False)
        root.addChild(self.sketch)
        root.addChild(nodes.separate(self.work, self.fixtures.root))
        root.addChild(nodes.without_box(self._axis_lines(letters)))
        over = coin.SoAnnotation()
        for child in (nodes.flat(), self.work, *self._block_lines()):
            over.addChild(child)
        root.addChild(nodes.without_box(over))
        return root

    def _axis_lines(self, letters: str) -> Any:
        group = nodes.separate(nodes.flat(), nodes.style(2.0, pattern=DASHES))
        for at, letter in enumerate(letters):
            line, colour = coin.SoLineSet(), nodes.colour(LETTER_COLOURS[letter])
            line.startIndex = 2 * at
            line.vertexProperty = self.axes
            line.numVertices.setValue(2)
            group.addChild(nodes.separate(colour, line))
        group.addChild(self.letters.root)
        return group

    def _block_lines(self) -> list[Any]:
        return [
            nodes.separate(nodes.colour(CHORD), nodes.style(WIDTH), _line(self.chord)),
            nodes.separate(nodes.colour(CURVE), nodes.style(WIDTH), _line(self.curve, self.curve_line)),
            nodes.separate(nodes.colour(CURVE), nodes.style(1.0), _line(self.gap)),
            nodes.separate(nodes.colour(TIP), nodes.style(point=DOT), _dots(self.dots)),
        ]


def _legend_of(machine: DrawnMachine) -> Legend:
    """Return what the legend says of the machine: how much of it is a sketch."""
    notes: tuple[str, ...] = (
        translate("FiveAxis", "The machine is a sketch from its axes: not to scale."),
        translate("FiveAxis", "Collisions are not checked against it."),
    )
    if machine.standing:
        own = translate("FiveAxis", "The machine's bodies are those of its file.")
        rest = translate("FiveAxis", "What stands beside them is a sketch: not to scale, not checked.")
        notes = (own, rest) if machine.bodies else (own,)
    return Legend(translate("FiveAxis", "On the machine"), np.zeros((0, 3)), (), ("", ""), (), notes)


def _vertices() -> Any:
    return coin.SoVertexProperty()


def _fill(vertices: Any, points: np.ndarray) -> None:
    vertices.vertex.setNum(len(points))
    vertices.vertex.setValues(0, len(points), np.ascontiguousarray(points, np.float32))


def _line(vertices: Any, line: Any = None) -> Any:
    line = line or coin.SoLineSet()
    line.vertexProperty = vertices
    return line


def _dots(vertices: Any) -> Any:
    dots = coin.SoPointSet()
    dots.vertexProperty = vertices
    return dots


def _put(node: Any, placement: np.ndarray) -> None:
    """Coin multiplies rows from the left: its matrix is ours turned over."""
    node.matrix.setValue(coin.SbMatrix(*(float(value) for value in placement.T.reshape(-1))))


def _about(placement: np.ndarray, zero: np.ndarray) -> np.ndarray:
    """Return a placement given in the work frame as one of document coordinates, in which the work zero
    stands at ``zero``."""
    moved = placement.copy()
    moved[:3, 3] += zero - placement[:3, :3] @ zero
    return moved
