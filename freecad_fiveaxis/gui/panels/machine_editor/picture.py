# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine of a draft in a 3D view: its bodies, a sketch of what has none, and its axes, moved by the
joints.

part, tool   a cube on the table and a plain cutter, made up: they show what moves, and are as large as the
             machine has room for.
lines        a rotary axis is drawn through its point, a linear one from the tip; the letter stands at the
             positive end.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.geometry.solids import box_facets, frustum_facets
from freecad_fiveaxis.core.gouge.machine_check import zero_words
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.report.machine_sketch import ToolRoom, sketch
from freecad_fiveaxis.core.report.playback import placements
from freecad_fiveaxis.core.report.standing_bodies import leave_out, stand_bodies
from freecad_fiveaxis.gui.play.machine import DrawnMachine
from freecad_fiveaxis.gui.play.solids import Look, mesh_node
from freecad_fiveaxis.gui.scene import nodes
from freecad_fiveaxis.gui.scene.on_screen import Label, Labels

USUAL_HEIGHT, LEAST, MOST = 150.0, 10.0, 100.0
"""mm: from the table to the gauge point where that is not known; the smallest and the largest part and
tool."""
SLIM = 0.08
"""Radius of the tool, in lengths of it."""
REACH = 2.5
"""How far the axes are drawn, in sizes of the part."""
BRASS, WORK = (0.95, 0.76, 0.20), (0.45, 0.62, 0.45)
COLOURS = {
    "X": (0.85, 0.15, 0.15), "Y": (0.10, 0.60, 0.10), "Z": (0.25, 0.55, 1.00),
    "A": (0.85, 0.15, 0.15), "B": (0.10, 0.60, 0.10), "C": (0.25, 0.55, 1.00),
}  # fmt: skip
"""As FreeCAD colours X, Y and Z."""
DASHES = 0x3FF3


class MachinePicture:
    """Nodes in a view's scene ``graph``. ``shown``: the machine that is drawn, None as long as none could
    be."""

    def __init__(self, graph: Any) -> None:
        self.root = nodes.separate(nodes.unpickable())
        self.shown: Machine | None = None
        self.root.setName("FiveAxisMachine")
        self._graph: Any = graph
        for node in (self.root, graph):
            node.ref()
        graph.addChild(self.root)

    def show(self, machine: Machine, joints: Mapping[str, float]) -> None:
        """Draw a machine whose axes stand at ``joints``, mm and degrees by their letters. Raises
        FiveAxisError for a body whose file is no mesh; then the picture stays."""
        model = _Model(machine)
        self.root.removeAllChildren()
        self.root.addChild(nodes.unpickable())
        self.root.addChild(model.root)
        self.shown, self.model = machine, model
        self.move(joints)

    def move(self, joints: Mapping[str, float]) -> None:
        """Move the machine's axes to ``joints``."""
        if self.shown is not None:
            self.model.move(joints)

    def remove(self) -> None:
        """Take the nodes out of the view; may be called twice, and after the view has gone."""
        if self._graph is None:
            return
        if self._graph.findChild(self.root) >= 0:
            self._graph.removeChild(self.root)
        for node in (self.root, self._graph):
            node.unref()
        self._graph = None


class _Model:
    """One machine's nodes below ``root``. ``zero`` (5,): the words at which all joints are at zero, mm and
    degrees."""

    def __init__(self, machine: Machine) -> None:
        room = USUAL_HEIGHT if machine.table is None else machine.gauge_point[2] - machine.table
        self.size = float(np.clip(0.4 * room, LEAST, MOST))
        setup = Setup(machine.origin, float(np.clip(0.5 * room, LEAST, MOST)))
        self.kinematics = chain(machine, setup)
        self.letters = [axis.letter for axis in self.kinematics.axes if axis.fitted]
        self.zero = zero_words(machine, setup, self.kinematics)
        table = None if machine.table is None else machine.table - machine.origin[2]
        foot = np.array([0.0, 0.0, table or 0.0])
        self.low, self.high = (
            foot - self.size * np.array([0.5, 0.5, 0.0]),
            foot + self.size * np.array([0.5, 0.5, 0.6]),
        )
        standing = stand_bodies(machine, setup, self.kinematics, setup.tool_length)
        tool = ToolRoom(setup.tool_length, SLIM * setup.tool_length)
        sketched = sketch(self.kinematics, self.low, self.high, tool, table)
        self.drawn = DrawnMachine(leave_out(sketched, standing, self.kinematics), standing)
        self.work, self.tool = coin.SoMatrixTransform(), coin.SoMatrixTransform()
        self.lines, self.labels = coin.SoVertexProperty(), Labels()
        self.labels.show([Label((0.0, 0.0, 0.0), letter, COLOURS[letter]) for letter in self.letters])
        self.root = self._root(tool)

    def _root(self, tool: ToolRoom) -> Any:
        cutter = frustum_facets(np.zeros(3), np.array([0.0, 0.0, tool.height]), tool.radius, tool.radius)
        part = box_facets(self.low, self.high)
        return nodes.separate(
            self.drawn.root,
            nodes.separate(self.work, mesh_node(from_triangles(part), Look(WORK, 0.0))),
            nodes.separate(self.tool, mesh_node(from_triangles(cutter), Look(BRASS, 0.0))),
            nodes.without_box(self._axis_lines()),
        )

    def _axis_lines(self) -> Any:
        group = nodes.separate(nodes.flat(), nodes.style(2.0, pattern=DASHES))
        for at, letter in enumerate(self.letters):
            line = coin.SoLineSet()
            line.startIndex, line.vertexProperty = 2 * at, self.lines
            line.numVertices.setValue(2)
            group.addChild(nodes.separate(nodes.colour(COLOURS[letter]), line))
        group.addChild(self.labels.root)
        return group

    def move(self, joints: Mapping[str, float]) -> None:
        """Move the axes to ``joints``."""
        words = self.zero + [joints.get(letter, 0.0) for letter in self.kinematics.letters]
        placed = {name: place[0] for name, place in placements(self.kinematics, words[None]).items()}
        self.drawn.show(placed["machine_from_carried"])
        _put(self.work, placed["machine_from_work"])
        _put(self.tool, placed["machine_from_tool"])
        ends = self._ends(placed)
        self.lines.vertex.setNum(2 * len(ends))
        self.lines.vertex.setValues(0, 2 * len(ends), np.ascontiguousarray(ends.reshape(-1, 3), np.float32))
        self.labels.move(ends[:, 1])

    def _ends(self, placed: Mapping[str, np.ndarray]) -> np.ndarray:
        """Both ends (n, 2, 3) of the line of each axis: of a rotary one on either side of where it is nearest
        to the part."""
        tip = placed["machine_from_tool"][:3, 3]
        work = placed["machine_from_work"]
        part = work[:3, :3] @ (0.5 * (self.low + self.high)) + work[:3, 3]
        along, point = placed["line_direction"], placed["line_point"]
        middle = point + ((part - point) * along).sum(axis=1, keepdims=True) * along
        reach = REACH * self.size
        linear = np.stack(
            [np.broadcast_to(tip, (3, 3)), tip + 0.5 * reach * self.kinematics.direction[:3]], axis=1
        )
        rotary = np.stack([middle - reach * along, middle + reach * along], axis=1)
        return np.concatenate([linear, rotary])[: len(self.letters)]


def _put(node: Any, placement: np.ndarray) -> None:
    """Coin multiplies rows from the left: its matrix is ours turned over."""
    node.matrix.setValue(coin.SbMatrix(*(float(value) for value in placement.T.reshape(-1))))
