# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bodies of a sketch, and the coordinates in which they are laid out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine.kinematics import Chain

WALL = 0.16
"""Thickness of walls and plates, as a share of the radius that they surround."""
GAP = 0.03
"""Between bodies that move against each other, as a share of the same radius."""
ACROSS = 0.35
"""Cosine up to which two axes count as standing across each other: a cradle, a fork. Beyond it: an inclined
knuckle."""
UP = np.array([0.0, 0.0, 1.0])
SIGNS = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
Triple = tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class Box:
    """``centre`` (3,) mm; rows of ``along`` (3, 3) its unit edges; ``half`` (3,) mm half their lengths."""

    centre: Floats
    along: Floats
    half: Floats


@dataclass(frozen=True, eq=False)
class Cylinder:
    """From ``start`` to ``end`` (3,) mm, with ``radius`` mm."""

    start: Floats
    end: Floats
    radius: float


@dataclass(frozen=True, eq=False)
class Body:
    """One body of the sketch: ``name`` as at the head of the module; ``carrier`` a column of the words, or
    None."""

    name: str
    carrier: int | None
    shape: Box | Cylinder


def corners(shape: Box | Cylinder) -> Floats:
    """Return the corners (8, 3) mm of a box, or of the box about a cylinder."""
    if isinstance(shape, Box):
        return shape.centre + (SIGNS * shape.half) @ shape.along
    axis = shape.end - shape.start
    length = float(np.linalg.norm(axis))
    half = np.array([shape.radius, shape.radius, 0.5 * length])
    return np.asarray(0.5 * (shape.start + shape.end) + (SIGNS * half) @ find_frame(axis / length))


class Frame(NamedTuple):
    """Bodies are laid out in coordinates of their own: ``zero`` (3,) mm, unit rows of ``along`` (3, 3)."""

    zero: Floats
    along: Floats

    def box(self, one: Triple, other: Triple) -> Box:
        """Return the box between two opposite corners."""
        low, high = np.minimum(one, other), np.maximum(one, other)
        return Box(self.zero + 0.5 * (low + high) @ self.along, self.along, 0.5 * (high - low))

    def slab(self, x: float, y: float, low: float, high: float) -> Box:
        """Return the box about the third axis, half as wide as ``x``, ``y``, from ``low`` to ``high``."""
        return self.box((-x, -y, low), (x, y, high))

    def of(self, points: Floats) -> Floats:
        """Points (n, 3) of the machine frame in these coordinates."""
        return np.asarray((points - self.zero) @ self.along.T)


def find_frame(up: Floats, first: Floats | None = None) -> Floats:
    """Return unit rows: ``first`` made square to ``up`` (any direction where that is not given), the one
    square to both, ``up``."""
    guess = np.eye(3)[np.abs(up).argmin()] if first is None else first
    side = guess - (guess @ up) * up
    side = side / np.linalg.norm(side)
    return np.stack([side, np.cross(up, side), up])


def point_of(kinematics: Chain, axis: int) -> Floats:
    """Return the point (3,) of a rotary axis, a column of the words."""
    return kinematics.point1 if axis == 3 else kinematics.point2


def turn_towards(direction: Floats, way: Floats) -> Floats:
    """Return the direction, or its reverse, that does not lead against ``way`` (3,)."""
    return np.asarray(direction if direction @ way >= 0.0 else -direction)


def find_nearest(point: Floats, line: Floats, direction: Floats) -> Floats:
    """Return the point of a line that is nearest to ``point``."""
    return np.asarray(line + ((point - line) @ direction) * direction)


def find_carrier(order: list[int], axis: int | None) -> int | None:
    """Return the axis that carries ``axis``; ``order`` from the base outwards."""
    at = order.index(axis) if axis in order else 0
    return order[at - 1] if at else None
