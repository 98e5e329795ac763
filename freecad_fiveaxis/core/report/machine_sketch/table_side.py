# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table's side of a sketch: what carries the part."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.report.playback import sides

from .shapes import (
    ACROSS,
    GAP,
    UP,
    WALL,
    Body,
    Box,
    Cylinder,
    Frame,
    corners,
    find_carrier,
    find_frame,
    find_nearest,
    point_of,
    turn_towards,
)  # fmt: skip

ROOM = 1.12
"""How much wider than what it has to clear a body is."""
SLIM = 0.8
"""Width of a riser, in widths of its part."""
LEAST_RISER = 0.1
"""mm under a part that are drawn."""
UPRIGHT = 0.999
"""Cosine from which a platter lies level."""
ANGLES = 73
"""Positions between a rotary axis's limits at which its swing is looked at."""


def draw_table(kinematics: Chain, low: Floats, high: Floats, least: float, table: float | None) -> list[Body]:
    """Return what carries the part with the box ``low``, ``high`` (3,) mm: ``least`` mm is the least radius
    of a platter; ``table`` as in :func:`.both_sides.sketch`."""
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
        line = find_nearest(
            point_of(kinematics, first), point_of(kinematics, turning[1]), kinematics.direction[turning[1]]
        )
        middle = find_nearest(0.5 * (low + high), point_of(kinematics, first), up)
        radius = max(radius, 0.5 * float(np.linalg.norm(line - middle)))
    base = point_of(kinematics, first)
    face = base + float(((part - base) @ up).min()) * up
    thick = WALL * radius
    platter = [Body("platter", first, Cylinder(face - thick * up, face, radius))]
    if up[2] > UPRIGHT:
        platter += _riser(low, high, float(face[2]), first)
    if len(turning) == 1:
        frame = Frame(face - (1.0 + GAP) * thick * up, find_frame(up))
        foot = frame.slab(1.1 * radius, 1.1 * radius, -0.5 * radius, -GAP * radius)
        return [*platter, Body("base", find_carrier(order, first), foot)]
    second = turning[1]
    draw = _cradle if abs(float(kinematics.direction[second] @ up)) <= ACROSS else _table_knuckle
    ring = _ring(face, up, radius, float(((part - face) @ up).max()))
    return [
        *platter,
        *draw(kinematics, second, find_carrier(order, second), face - thick * up, up, radius, ring),
    ]


def _riser(low: Floats, high: Floats, face: float, carrier: int | None) -> list[Body]:
    """Return a block on a level face at the height ``face`` mm, under the part with the box ``low``,
    ``high``; none where the part stands on the face."""
    middle, half = 0.5 * (low + high), 0.5 * SLIM * (high - low)
    if low[2] - face <= LEAST_RISER:
        return []
    frame = Frame(np.array([middle[0], middle[1], face]), np.eye(3))
    return [Body("riser", carrier, frame.slab(half[0], half[1], 0.0, low[2] - face))]


def _plain_table(part: Floats, carrier: int | None, least: float) -> Body:
    low, high = part.min(axis=0), part.max(axis=0)
    middle, half = 0.5 * (low + high), np.maximum(0.5 * ROOM * (high - low), least)
    frame = Frame(np.array([middle[0], middle[1], low[2]]), np.eye(3))
    return Body("table", carrier, frame.slab(half[0], half[1], -WALL * half[:2].max(), 0.0))


def _upwards(kinematics: Chain, first: int, others: list[int], part: Floats) -> Floats:
    """Return the direction of the platter's axis that points out of its face: upwards, or for a level one
    from the next line to the part."""
    axis = kinematics.direction[first]
    if abs(axis[2]) > ACROSS or not others:
        return turn_towards(axis, UP)
    return turn_towards(axis, part.mean(axis=0) - point_of(kinematics, others[0]))


def _compute_swept_radius(kinematics: Chain, axis: int, part: Floats) -> float:
    """Return the radius of a platter that has room for the part."""
    offset = part - point_of(kinematics, axis)
    across = offset - (offset @ kinematics.direction[axis])[:, None] * kinematics.direction[axis]
    return ROOM * float(np.linalg.norm(across, axis=1).max())


def _ring(face: Floats, up: Floats, radius: float, height: float) -> Floats:
    """Points (32, 3) about all that turns on the platter."""
    around = np.linspace(0.0, 2.0 * np.pi, 16, endpoint=False)
    circle = radius * np.stack([np.cos(around), np.sin(around)], axis=1) @ find_frame(up)[:2]
    return np.concatenate([face + circle, face + circle + height * up])


def _cradle(
    kinematics: Chain, axis: int, carrier: int | None, under: Floats, up: Floats, radius: float, ring: Floats
) -> list[Body]:
    """Return a U about the platter, in the coordinates (along its line, across, up) of the platter's
    underside, and its bearings."""
    direction, wall, gap = kinematics.direction[axis], WALL * radius, GAP * radius
    frame = Frame(under, find_frame(up, direction))
    _, across, height = frame.of(point_of(kinematics, axis)[None])[0].tolist()
    inner, boss, deep = radius + gap, max(0.26 * radius, 1.5 * wall), -gap - wall
    outer = inner + wall
    ends = (-1.0, 1.0) if abs(direction[2]) < 0.7 else (-float(np.sign(direction[2])),)
    half = max(0.7 * radius, abs(across) + boss)
    plate = frame.slab(outer, half, deep, -gap)
    arms = [
        frame.box(
            (end * inner, -half, min(deep, height - boss)), (end * outer, half, max(-gap, height + boss))
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
        frame.box((end * near, across - wide, floor), (end * far, across + wide, height + wide))
        for end in ends
    ]
    ground = frame.box((-far, across - half - wall, floor - wall), (far, across + half + wall, floor))
    return [
        *(Body("cradle", axis, shape) for shape in cradle),
        *(Body("base", carrier, shape) for shape in (*bearings, ground)),
    ]


def _deepest(
    kinematics: Chain, axis: int, frame: Frame, points: Floats, across: float, height: float
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
    direction = turn_towards(kinematics.direction[axis], up)
    crossing = find_nearest(under, point_of(kinematics, axis), direction)
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
    frame, deep = Frame(end, find_frame(up)), -(0.8 * 2.0**0.5 * side / lean + GAP) * radius
    foot = frame.slab(0.8 * radius, 0.8 * radius, deep - wall, deep)
    post = Cylinder(end, end + deep * up, 0.5 * disc)
    return [
        *(Body("cradle", axis, shape) for shape in (neck, Cylinder(joint, top, disc))),
        *(Body("base", carrier, shape) for shape in (lower, post, foot)),
    ]
