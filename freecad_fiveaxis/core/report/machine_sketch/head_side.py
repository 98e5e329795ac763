# SPDX-License-Identifier: LGPL-2.1-or-later
"""The head's side of a sketch: what carries the tool."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.report.playback import sides

from .shapes import (
    ACROSS,
    GAP,
    UP,
    Body,
    Cylinder,
    Frame,
    find_carrier,
    find_frame,
    find_nearest,
    point_of,
    turn_towards,
)  # fmt: skip


def draw_head(kinematics: Chain, height: float, radius: float) -> list[Body]:
    """Return what carries a tool whose top is ``height`` mm above the driven point, ``radius`` mm: of the
    spindle."""
    order = [axis for axis in sides(kinematics)[1] if kinematics.axes[axis].fitted]
    last = order[-1] if order else None
    turning = [axis for axis in reversed(order) if axis >= 3 and kinematics.axes[axis].fitted]
    if not turning:
        top = height + 2.0 * radius
        ram = Frame(top * UP, np.eye(3)).slab(1.3 * radius, 1.3 * radius, 0.0, 1.5 * radius)
        return [_spindle(last, height, top, radius), Body("ram", last, ram)]
    axis = turning[0]
    direction = turn_towards(kinematics.direction[axis], UP)
    pivot = _crossing(point_of(kinematics, axis), direction)
    draw = _fork if abs(float(direction[2])) <= ACROSS else _head_knuckle
    return draw(kinematics, order, turning, pivot, direction, min(height, float(pivot[2]) - radius), radius)


def _crossing(point: Floats, direction: Floats) -> Floats:
    """Return the point of a rotary line that is nearest to the spindle's axis."""
    level = np.array([direction[0], direction[1], 0.0])
    return np.asarray(point - float(point @ level) / max(float(level @ level), 1e-12) * direction)


def _spindle(carrier: int | None, low: float, high: float, radius: float) -> Body:
    return Body("spindle", carrier, Cylinder(low * UP, high * UP, radius))


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
    axis, carrier = turning[0], find_carrier(order, turning[0])
    frame = Frame(pivot, find_frame(UP, direction))
    offset = float(np.hypot(*frame.of(pivot[2] * UP[None])[0, :2]))
    rise, wall, gap = 0.7 * radius, 0.45 * radius, 2.0 * GAP * radius
    inner = radius + offset + gap
    clear = float(np.hypot(radius + offset, rise)) + gap
    wide, beam = 0.75 * radius, clear + 0.6 * radius
    outer = inner + wall
    cheeks = [frame.box((end * inner, -wide, -wide), (end * outer, wide, clear)) for end in (-1.0, 1.0)]
    bridge = frame.slab(outer, wide, clear, beam)
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
    axis, carrier = turning[0], find_carrier(order, turning[0])
    near, thick, gap = 0.8 * radius, 0.7 * radius, GAP * radius
    below, middle, above = (pivot + share * direction for share in (near, near + thick, near + 2.0 * thick))
    return [
        _spindle(order[-1], low, float(pivot[2]) + 0.5 * radius, radius),
        Body("spindle", axis, Cylinder(pivot, below, 0.7 * radius)),
        Body("spindle", axis, Cylinder(below, middle, 1.3 * radius)),
        Body("fork", carrier, Cylinder(middle + gap * direction, above, 1.3 * radius)),
        *_carrying(kinematics, order, turning[1:], carrier, above + 0.6 * radius * UP, radius),
    ]


def _carrying(
    kinematics: Chain, order: list[int], others: list[int], carrier: int | None, top: Floats, radius: float
) -> list[Body]:
    """Return what carries a fork that ends at ``top`` (3,): a disc about the next rotary line where that
    carries it, then a ram."""
    plate = list[Body]()
    if others and carrier == others[0]:
        direction = turn_towards(kinematics.direction[others[0]], UP)
        start = (
            find_nearest(top, point_of(kinematics, others[0]), direction)
            if abs(direction[2]) > ACROSS
            else top
        )
        plate = [Body("fork", carrier, Cylinder(start, start + 0.8 * radius * direction, 1.5 * radius))]
        top, carrier = start + (0.8 + GAP) * radius * direction, find_carrier(order, carrier)
    ram = Frame(top, find_frame(UP)).slab(1.7 * radius, 1.7 * radius, 0.0, 3.5 * radius)
    return [*plate, Body("ram", carrier, ram)]
