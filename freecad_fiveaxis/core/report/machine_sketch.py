# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine drawn from its axes alone: plain boxes and cylinders about the rotary lines, as large as the part
and the tool ask.

A sketch, not to scale: a machine file tells where the axes are and nothing of the bodies. Where the lines run
and how each body moves is exact; how wide and how thick the bodies are is made up, so that the part and the
tool find room.

platter   carries the work: a disc about the table axis that is nearest to it, its face under the part; a
          plain table where no rotary axis carries the work.
riser     stands under a part that is clamped above the table's face, so that it does not float; what clamps
          it is not known.
cradle    carries the platter: a U that hangs in the next table axis; a knuckle about its line where that is
          inclined.
base      carries the cradle or the platter: two bearings and a floor, below all that swings within the axis's
          limits.
spindle   carries the tool. fork: what the spindle swings in; a knuckle where the line is inclined. ram: what
          carries the fork or the spindle.

frame     machine frame as in :mod:`.playback`: parallel to the machine's, its zero where the work zero stands
          while all words are 0, and so does the tip. Bodies are given as they stand then;
          :func:`.playback.placements` says where they go.
carrier   the column of the words (0 to 4) whose axis carries a body; None for what stands still.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine.kinematics import Chain

from .playback import sides

ROOM = 1.12
"""How much wider than what it has to clear a body is."""
WALL = 0.16
"""Thickness of walls and plates, as a share of the radius that they surround."""
GAP = 0.03
"""Between bodies that move against each other, as a share of the same radius."""
ACROSS = 0.35
"""Cosine up to which two axes count as standing across each other: a cradle, a fork. Beyond it: an inclined
knuckle."""
LEAST_RADIUS = 12.0
"""mm, of a spindle."""
WIDER = 2.2
"""Radius of a platter, in radii of the spindle, that a small part has, too."""
SLIM = 0.8
"""Width of a riser, in widths of its part."""
LEAST_RISER = 0.1
"""mm under a part that are drawn."""
UPRIGHT = 0.999
"""Cosine from which a platter lies level."""
ANGLES = 73
"""Positions between a rotary axis's limits at which its swing is looked at."""


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


@dataclass(frozen=True)
class ToolRoom:
    """What the sketch needs of a tool: ``height`` mm of its top above the driven point, ``radius`` mm where
    it is widest."""

    height: float
    radius: float


def sketch(
    kinematics: Chain, low: Floats, high: Floats, tool: ToolRoom, table: float | None = None
) -> tuple[Body, ...]:
    """Return the bodies of a machine that has a part with the box ``low``, ``high`` (3,) mm, work frame, on
    its table.

    ``table`` mm: height of the table's face, work frame, where it is known; the face never stands in the
    part.
    """
    low, high = np.asarray(low, float), np.asarray(high, float)
    spindle = max(1.25 * tool.radius, LEAST_RADIUS)
    return (*_table(kinematics, low, high, WIDER * spindle, table), *_head(kinematics, tool.height, spindle))


def corners(shape: Box | Cylinder) -> Floats:
    """Return the corners (8, 3) mm of a box, or of the box about a cylinder."""
    if isinstance(shape, Box):
        return shape.centre + (_SIGNS * shape.half) @ shape.along
    axis = shape.end - shape.start
    length = float(np.linalg.norm(axis))
    half = np.array([shape.radius, shape.radius, 0.5 * length])
    return np.asarray(0.5 * (shape.start + shape.end) + (_SIGNS * half) @ _frame(axis / length))


_SIGNS = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])


class _Frame(NamedTuple):
    """Bodies are laid out in coordinates of their own: ``zero`` (3,) mm, unit rows of ``along`` (3, 3)."""

    zero: Floats
    along: Floats

    def box(self, low: Iterable[float], high: Iterable[float]) -> Box:
        """Return the box between two corners."""
        least, most = np.array(list(low), float), np.array(list(high), float)
        return Box(self.zero + 0.5 * (least + most) @ self.along, self.along, 0.5 * (most - least))

    def of(self, points: Floats) -> Floats:
        """Points (n, 3) of the machine frame in these coordinates."""
        return np.asarray((points - self.zero) @ self.along.T)


def _frame(up: Floats, first: Floats | None = None) -> Floats:
    """Return unit rows: ``first`` made square to ``up`` (any direction where that is not given), the one
    square to both, ``up``."""
    guess = np.eye(3)[np.abs(up).argmin()] if first is None else first
    side = guess - (guess @ up) * up
    side = side / np.linalg.norm(side)
    return np.stack([side, np.cross(up, side), up])


def _point(kinematics: Chain, axis: int) -> Floats:
    return kinematics.point1 if axis == 3 else kinematics.point2


def _nearest(point: Floats, line: Floats, direction: Floats) -> Floats:
    """Return the point of a line that is nearest to ``point``."""
    return np.asarray(line + ((point - line) @ direction) * direction)


def _beyond(order: list[int], axis: int | None) -> int | None:
    """Return the axis that carries ``axis``; ``order`` from the base outwards."""
    at = order.index(axis) if axis in order else 0
    return order[at - 1] if at else None


# ------------------------------------------------------------------------------------------- the table's side


def _table(kinematics: Chain, low: Floats, high: Floats, least: float, table: float | None) -> list[Body]:
    order = sides(kinematics)[0][::-1]
    turning = [axis for axis in reversed(order) if axis >= 3 and kinematics.axes[axis].fitted]
    stand = low if table is None else np.array([low[0], low[1], min(low[2], table)])
    part = corners(Box(0.5 * (stand + high), np.eye(3), 0.5 * (high - stand)))
    if not turning:
        plain = _plain_table(part, order[-1] if order else None, least)
        return [plain, *_riser(low, high, float(part[:, 2].min()), plain.carrier)]
    first = turning[0]
    up, radius = (
        _upwards(kinematics, first, turning[1:], part),
        max(_compute_swept_radius(kinematics, first, part), least),
    )
    if len(turning) > 1:
        line = _nearest(
            _point(kinematics, first), _point(kinematics, turning[1]), kinematics.direction[turning[1]]
        )
        middle = _nearest(0.5 * (low + high), _point(kinematics, first), up)
        radius = max(radius, 0.5 * float(np.linalg.norm(line - middle)))
    base = _point(kinematics, first)
    face = base + float(((part - base) @ up).min()) * up
    thick = WALL * radius
    platter = [Body("platter", first, Cylinder(face - thick * up, face, radius))]
    if up[2] > UPRIGHT:
        platter += _riser(low, high, float(face[2]), first)
    if len(turning) == 1:
        frame = _Frame(face - (1.0 + GAP) * thick * up, _frame(up))
        foot = frame.box(
            (-1.1 * radius, -1.1 * radius, -0.5 * radius), (1.1 * radius, 1.1 * radius, -GAP * radius)
        )
        return [*platter, Body("base", _beyond(order, first), foot)]
    second = turning[1]
    draw = _cradle if abs(float(kinematics.direction[second] @ up)) <= ACROSS else _table_knuckle
    ring = _ring(face, up, radius, float(((part - face) @ up).max()))
    return [*platter, *draw(kinematics, second, _beyond(order, second), face - thick * up, up, radius, ring)]


def _riser(low: Floats, high: Floats, face: float, carrier: int | None) -> list[Body]:
    """Return a block on a level face at the height ``face`` mm, under the part with the box ``low``,
    ``high``; none where the part stands on the face."""
    middle, half = 0.5 * (low + high), 0.5 * SLIM * (high - low)
    if low[2] - face <= LEAST_RISER:
        return []
    shape = _Frame(np.array([middle[0], middle[1], face]), np.eye(3)).box(
        (-half[0], -half[1], 0.0), (half[0], half[1], low[2] - face)
    )
    return [Body("riser", carrier, shape)]


def _plain_table(part: Floats, carrier: int | None, least: float) -> Body:
    low, high = part.min(axis=0), part.max(axis=0)
    middle, half = 0.5 * (low + high), np.maximum(0.5 * ROOM * (high - low), least)
    frame = _Frame(np.array([middle[0], middle[1], low[2]]), np.eye(3))
    return Body(
        "table", carrier, frame.box((-half[0], -half[1], -WALL * half[:2].max()), (half[0], half[1], 0.0))
    )


def _upwards(kinematics: Chain, first: int, others: list[int], part: Floats) -> Floats:
    """Return the direction of the platter's axis that points out of its face: upwards, or for a level one
    from the next line to the part."""
    axis = kinematics.direction[first]
    if abs(axis[2]) > ACROSS or not others:
        return np.asarray(axis if axis[2] >= 0.0 else -axis)
    away = part.mean(axis=0) - _point(kinematics, others[0])
    return np.asarray(axis if away @ axis >= 0.0 else -axis)


def _compute_swept_radius(kinematics: Chain, axis: int, part: Floats) -> float:
    """Return the radius of a platter that has room for the part."""
    offset = part - _point(kinematics, axis)
    across = offset - (offset @ kinematics.direction[axis])[:, None] * kinematics.direction[axis]
    return ROOM * float(np.linalg.norm(across, axis=1).max())


def _ring(face: Floats, up: Floats, radius: float, height: float) -> Floats:
    """Points (32, 3) about all that turns on the platter."""
    around = np.linspace(0.0, 2.0 * np.pi, 16, endpoint=False)
    circle = radius * np.stack([np.cos(around), np.sin(around)], axis=1) @ _frame(up)[:2]
    return np.concatenate([face + circle, face + circle + height * up])


def _cradle(
    kinematics: Chain, axis: int, carrier: int | None, under: Floats, up: Floats, radius: float, ring: Floats
) -> list[Body]:
    """Return a U about the platter, in the coordinates (along its line, across, up) of the platter's
    underside, and its bearings."""
    direction, wall, gap = kinematics.direction[axis], WALL * radius, GAP * radius
    frame = _Frame(under, _frame(up, direction))
    _, across, height = frame.of(_point(kinematics, axis)[None])[0].tolist()
    inner, boss, deep = radius + gap, max(0.26 * radius, 1.5 * wall), -gap - wall
    outer = inner + wall
    ends = (-1.0, 1.0) if abs(direction[2]) < 0.7 else (-float(np.sign(direction[2])),)
    half = max(0.7 * radius, abs(across) + boss)
    plate = frame.box((-outer, -half, deep), (outer, half, -gap))
    arms = [
        frame.box(
            *_order_ends(
                (end * inner, -half, min(deep, height - boss)), (end * outer, half, max(-gap, height + boss))
            )
        )
        for end in ends
    ]
    line = frame.zero + np.array([0.0, across, height]) @ frame.along
    pins = [
        Cylinder(
            line + end * outer * frame.along[0],
            line + end * (outer + 2.5 * wall) * frame.along[0],
            0.8 * boss,
        )
        for end in ends
    ]
    cradle: list[Box | Cylinder] = [plate, *arms, *pins]
    swing = np.concatenate([ring, *(corners(shape) for shape in cradle)])
    floor = height - ROOM * _deepest(kinematics, axis, frame, swing, across, height)
    near, far, wide = outer + gap, outer + 2.0 * wall, 1.2 * boss
    bearings = [
        frame.box(*_order_ends((end * near, across - wide, floor), (end * far, across + wide, height + wide)))
        for end in ends
    ]
    ground = frame.box((-far, across - half - wall, floor - wall), (far, across + half + wall, floor))
    return [
        *(Body("cradle", axis, shape) for shape in cradle),
        *(Body("base", carrier, shape) for shape in (*bearings, ground)),
    ]


def _order_ends(one: tuple[float, float, float], other: tuple[float, float, float]) -> tuple[Floats, Floats]:
    return np.minimum(one, other), np.maximum(one, other)


def _deepest(
    kinematics: Chain, axis: int, frame: _Frame, points: Floats, across: float, height: float
) -> float:
    """How far (mm) below its line any of the points comes that swing with the axis, between its limits."""
    _, y, z = (frame.of(points) - (0.0, across, height)).T
    low, high = np.clip((kinematics.low[axis], kinematics.high[axis]), -np.pi, np.pi)
    turn = -float(kinematics.direction[axis] @ frame.along[0]) * np.linspace(low, high, ANGLES)[:, None]
    return float(-(y * np.sin(turn) + z * np.cos(turn)).min())


def _table_knuckle(
    kinematics: Chain, axis: int, carrier: int | None, under: Floats, up: Floats, radius: float, ring: Floats
) -> list[Body]:
    """Return a nutating table: a neck under the platter, and two discs about the inclined line that turn upon
    each other."""
    direction = kinematics.direction[axis] * (1.0 if kinematics.direction[axis] @ up > 0.0 else -1.0)
    crossing = _nearest(under, _point(kinematics, axis), direction)
    lean = float(direction @ up)
    side = float(np.sqrt(1.0 - lean * lean))
    disc, wall = 0.62 * radius, 1.6 * WALL * radius
    least = float(((np.concatenate([ring, _ring(under, up, radius, 0.0)]) - crossing) @ direction).min())
    top = (
        crossing + min(least - GAP * radius, 0.0) * direction
    )  # what turns stays above the joint, what stands below it
    joint, end = top - wall * direction, top - 2.0 * wall * direction
    start = top - 0.5 * wall * direction
    slant = (under - start) / np.linalg.norm(under - start)
    neck = Cylinder(
        start, under - 0.42 * radius * float(np.linalg.norm(np.cross(slant, up))) * up, 0.42 * radius
    )
    lower = Cylinder(end, joint - GAP * radius * direction, disc)
    frame, deep = _Frame(end, _frame(up)), -(0.8 * 2.0**0.5 * side / lean + GAP) * radius
    foot = frame.box((-0.8 * radius, -0.8 * radius, deep - wall), (0.8 * radius, 0.8 * radius, deep))
    post = Cylinder(end, end + deep * up, 0.5 * disc)
    return [
        *(Body("cradle", axis, shape) for shape in (neck, Cylinder(joint, top, disc))),
        *(Body("base", carrier, shape) for shape in (lower, post, foot)),
    ]


# -------------------------------------------------------------------------------------------- the head's side


def _head(kinematics: Chain, height: float, radius: float) -> list[Body]:
    order = [axis for axis in sides(kinematics)[1] if kinematics.axes[axis].fitted]
    last = order[-1] if order else None
    turning = [axis for axis in reversed(order) if axis >= 3 and kinematics.axes[axis].fitted]
    if not turning:
        top = height + 2.0 * radius
        frame = _Frame(np.array([0.0, 0.0, top]), np.eye(3))
        ram = frame.box((-1.3 * radius, -1.3 * radius, 0.0), (1.3 * radius, 1.3 * radius, 1.5 * radius))
        return [_spindle(last, height, top, radius), Body("ram", last, ram)]
    axis = turning[0]
    direction = kinematics.direction[axis] * (1.0 if kinematics.direction[axis][2] >= 0.0 else -1.0)
    pivot = _crossing(_point(kinematics, axis), direction)
    draw = _fork if abs(float(direction[2])) <= ACROSS else _head_knuckle
    return draw(kinematics, order, turning, pivot, direction, min(height, float(pivot[2]) - radius), radius)


def _crossing(point: Floats, direction: Floats) -> Floats:
    """Return the point of a rotary line that is nearest to the spindle's axis."""
    level = np.array([direction[0], direction[1], 0.0])
    return np.asarray(point - float(point @ level) / max(float(level @ level), 1e-12) * direction)


def _spindle(carrier: int | None, low: float, high: float, radius: float) -> Body:
    return Body("spindle", carrier, Cylinder(np.array([0.0, 0.0, low]), np.array([0.0, 0.0, high]), radius))


def _fork(
    kinematics: Chain,
    order: list[int],
    turning: list[int],
    pivot: Floats,
    direction: Floats,
    low: float,
    radius: float,
) -> list[Body]:
    """Return a fork over the spindle, in the coordinates (along its line, across, up) of the pivot, and what
    carries it."""
    axis, carrier = turning[0], _beyond(order, turning[0])
    frame = _Frame(pivot, _frame(np.array([0.0, 0.0, 1.0]), direction))
    offset = float(np.hypot(*frame.of(np.array([[0.0, 0.0, pivot[2]]]))[0, :2]))
    rise, wall, gap = 0.7 * radius, 0.45 * radius, 2.0 * GAP * radius
    inner = radius + offset + gap
    clear = float(np.hypot(radius + offset, rise)) + gap
    wide, beam = 0.75 * radius, clear + 0.6 * radius
    outer = inner + wall
    cheeks = [
        frame.box(*_order_ends((end * inner, -wide, -wide), (end * outer, wide, clear)))
        for end in (-1.0, 1.0)
    ]
    bridge = frame.box((-outer, -wide, clear), (outer, wide, beam))
    pin = Cylinder(pivot - outer * frame.along[0], pivot + outer * frame.along[0], 0.5 * radius)
    return [
        _spindle(order[-1], low, float(pivot[2]) + rise, radius),
        Body("spindle", axis, pin),
        *(Body("fork", carrier, shape) for shape in (*cheeks, bridge)),
        *_carrying(kinematics, order, turning[1:], carrier, frame.zero + beam * frame.along[2], radius),
    ]


def _head_knuckle(
    kinematics: Chain,
    order: list[int],
    turning: list[int],
    pivot: Floats,
    direction: Floats,
    low: float,
    radius: float,
) -> list[Body]:
    """Return a nutating head: two discs about the inclined line, above the spindle, that turn upon each
    other."""
    axis, carrier = turning[0], _beyond(order, turning[0])
    near, thick, gap = 0.8 * radius, 0.7 * radius, GAP * radius
    below, middle, above = (pivot + share * direction for share in (near, near + thick, near + 2.0 * thick))
    return [
        _spindle(order[-1], low, float(pivot[2]) + 0.5 * radius, radius),
        Body("spindle", axis, Cylinder(pivot, below, 0.7 * radius)),
        Body("spindle", axis, Cylinder(below, middle, 1.3 * radius)),
        Body("fork", carrier, Cylinder(middle + gap * direction, above, 1.3 * radius)),
        *_carrying(
            kinematics, order, turning[1:], carrier, above + 0.6 * radius * np.array([0.0, 0.0, 1.0]), radius
        ),
    ]


def _carrying(
    kinematics: Chain, order: list[int], others: list[int], carrier: int | None, top: Floats, radius: float
) -> list[Body]:
    """Return what carries a fork that ends at ``top`` (3,): a disc about the next rotary line where that
    carries it, then a ram."""
    up, draw = np.array([0.0, 0.0, 1.0]), []
    if others and carrier == others[0]:
        direction = kinematics.direction[others[0]] * (
            1.0 if kinematics.direction[others[0]][2] >= 0.0 else -1.0
        )
        start = _nearest(top, _point(kinematics, others[0]), direction) if abs(direction[2]) > ACROSS else top
        draw.append(Body("fork", carrier, Cylinder(start, start + 0.8 * radius * direction, 1.5 * radius)))
        top, carrier = start + (0.8 + GAP) * radius * direction, _beyond(order, carrier)
    frame = _Frame(top, _frame(up))
    return [
        *draw,
        Body(
            "ram",
            carrier,
            frame.box((-1.7 * radius, -1.7 * radius, 0.0), (1.7 * radius, 1.7 * radius, 3.5 * radius)),
        ),
    ]
