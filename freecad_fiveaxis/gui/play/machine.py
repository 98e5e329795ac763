# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine as a picture: the bodies of its file, and of the core's sketch where that names none, each on
its axis. Playing moves them and never makes them anew."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.machine.bodies import SPINDLE
from freecad_fiveaxis.core.report.machine_sketch import Body, Box, Cylinder, ToolRoom, corners, sketch
from freecad_fiveaxis.core.report.playback import Playback, placements
from freecad_fiveaxis.core.report.standing_bodies import StandingBody, leave_out
from freecad_fiveaxis.gui.scene import nodes

from .player import Struck
from .solids import EDGE, Look, draw_meshes
from .tool import DrawnTool, size_of

LOOKS: dict[str, tuple[nodes.Colour, float]] = {
    "platter": ((0.80, 0.83, 0.86), 0.20),
    "table": ((0.80, 0.83, 0.86), 0.20),
    "riser": ((0.72, 0.74, 0.78), 0.30),
    "cradle": ((0.66, 0.76, 0.86), 0.50),
    "base": ((0.74, 0.76, 0.80), 0.60),
    "spindle": ((0.84, 0.86, 0.88), 0.30),
    "fork": ((0.66, 0.76, 0.86), 0.50),
    "ram": ((0.74, 0.76, 0.80), 0.60),
}
"""Quiet colours, and how much of the cut is seen through each body."""
TURNS = 48
MOMENTS = 200
"""Moments of the program at which the room of all bodies is looked at."""


class DrawnMachine:
    """The bodies of a machine below ``root``, in the machine frame: ``bodies`` of the sketch, ``standing`` of
    its file; ``beside``: facets of what else is drawn in many."""

    def __init__(
        self, bodies: tuple[Body, ...], standing: Sequence[StandingBody] = (), beside: Sequence[int] = ()
    ) -> None:
        self.bodies, self.standing = bodies, tuple(standing)
        self.looks = [Look(*LOOKS[one.place]) for one in self.standing]
        carriers = [*(one.carrier for one in bodies), *(one.carrier for one in self.standing)]
        self.carriers = {carrier: coin.SoMatrixTransform() for carrier in carriers}
        self.drawn = draw_meshes([one.mesh for one in self.standing], self.looks, beside)
        self.root = nodes.separate(_solid())
        for carrier, placed in self.carriers.items():
            group = nodes.separate(placed)
            for body in bodies:
                if body.carrier == carrier:
                    group.addChild(_body_node(body))
            for one, drawn in zip(self.standing, self.drawn, strict=True):
                if one.carrier == carrier:
                    group.addChild(drawn.node)
            self.root.addChild(group)

    def show(self, machine_from_carried: np.ndarray, moving: bool = False) -> None:
        """Put every body where its axis carries it; ``machine_from_carried`` (5, 4, 4) as in a Pose;
        ``moving``: draw large ones from their coarser copies."""
        for drawn in self.drawn:
            drawn.show(moving)
        for carrier, placed in self.carriers.items():
            if carrier is not None:
                placed.matrix.setValue(
                    coin.SbMatrix(*(float(value) for value in machine_from_carried[carrier].T.reshape(-1)))
                )

    def show_struck(self, struck: Struck, near: Struck) -> None:
        """Draw red what is hit, and the spindle where that hits; amber what is only come near to."""
        for one, look in zip(self.standing, self.looks, strict=True):
            look.show(
                *(one.name in by.bodies or (by.spindle and one.place == SPINDLE) for by in (struck, near))
            )

    def room(self, playback: Playback) -> tuple[np.ndarray, np.ndarray]:
        """Return the box (two corners (3,) mm, machine frame) in which the bodies move while the program is
        played."""
        words = playback.program.words
        chosen = np.unique(np.linspace(0, len(words) - 1, MOMENTS).astype(int))
        carried = placements(playback.kinematics, words[chosen])["machine_from_carried"]
        shapes = [(body.carrier, corners(body.shape)) for body in self.bodies]
        shapes += [(one.carrier, _corners(*one.mesh.box)) for one in self.standing]
        reached = [_find_extent(carrier, points, carried) for carrier, points in shapes]
        return np.min([low for low, _ in reached], axis=0), np.max([high for _, high in reached], axis=0)


def machine_of(
    playback: Playback,
    low: np.ndarray,
    high: np.ndarray,
    tool: DrawnTool,
    table: float | None = None,
    standing: Sequence[StandingBody] = (),
    held: bool = False,
    beside: Sequence[int] = (),
) -> DrawnMachine:
    """Return the machine of a program whose part has the box ``low``, ``high`` (3,) mm, work frame; ``table``
    mm: height of the table's face there, None where it is not known; ``standing``: the bodies of its file;
    ``held``: whether the part's fixtures are known, so that nothing is made up for them; ``beside``: facets
    of what else is drawn in many."""
    radius, height = size_of(tool)
    sketched = sketch(playback.kinematics, low, high, ToolRoom(height, radius), table)
    left = leave_out(sketched, standing, playback.kinematics)
    kept = tuple(body for body in left if not (held and body.name == "riser"))
    return DrawnMachine(kept, standing, beside)


def _corners(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Return the corners (8, 3) of a box."""
    return 0.5 * (low + high) + 0.5 * _SIGNS * (high - low)


def _find_extent(
    carrier: int | None, points: np.ndarray, carried: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    if carrier is not None:
        placement = carried[:, carrier]
        points = (points @ np.swapaxes(placement[:, :3, :3], 1, 2) + placement[:, None, :3, 3]).reshape(-1, 3)
    return points.min(axis=0), points.max(axis=0)


def _body_node(body: Body) -> Any:
    shape, edges = _box(body.shape) if isinstance(body.shape, Box) else _cylinder(body.shape)
    drawn = nodes.separate(nodes.flat(), nodes.colour(EDGE), nodes.style(1.0), edges)
    return nodes.separate(nodes.separate(Look(*LOOKS[body.name]).node, shape), drawn)


def _solid() -> Any:
    """Bodies are closed: their back faces are left out, which would be blended with the front ones in any
    order."""
    hints = coin.SoShapeHints()
    hints.vertexOrdering, hints.shapeType = coin.SoShapeHints.COUNTERCLOCKWISE, coin.SoShapeHints.SOLID
    return hints


def _place_shape(rows: np.ndarray, centre: np.ndarray) -> Any:
    """Where a shape stands whose own axes are the unit ``rows`` (3, 3)."""
    transform = coin.SoMatrixTransform()
    placement = np.eye(4)
    placement[:3, :3], placement[3, :3] = rows, centre
    transform.matrix.setValue(coin.SbMatrix(*(float(value) for value in placement.reshape(-1))))
    return transform


_SIGNS = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
_EDGES = np.array(
    [
        (one, other)
        for one in range(8)
        for other in range(one)
        if np.abs(_SIGNS[one] - _SIGNS[other]).sum() == 2.0
    ]
)


def _box(box: Box) -> tuple[Any, Any]:
    cube = coin.SoCube()
    cube.width, cube.height, cube.depth = (2.0 * float(half) for half in box.half)
    corner = box.centre + (_SIGNS * box.half) @ box.along
    return nodes.separate(_place_shape(box.along, box.centre), cube), nodes.lines(
        corner[_EDGES].reshape(-1, 3)
    )


def _cylinder(shape: Cylinder) -> tuple[Any, Any]:
    axis = shape.end - shape.start
    length = float(np.linalg.norm(axis))
    up = axis / length
    side = np.cross(up, np.eye(3)[np.abs(up).argmin()])
    side = side / np.linalg.norm(side)
    drawn = coin.SoCylinder()
    drawn.radius, drawn.height = shape.radius, length
    rows = np.stack([side, up, np.cross(side, up)])  # Coin's cylinder stands along y
    around = np.linspace(0.0, 2.0 * np.pi, TURNS + 1)
    circle = shape.radius * (np.cos(around)[:, None] * rows[0] + np.sin(around)[:, None] * rows[2])
    rims = nodes.lines(np.concatenate([shape.start + circle, shape.end + circle]), TURNS + 1)
    return nodes.separate(_place_shape(rows, 0.5 * (shape.start + shape.end)), drawn), rims
