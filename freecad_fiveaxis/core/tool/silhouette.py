# SPDX-License-Identifier: LGPL-2.1-or-later
"""How wide a cutter cuts: what it sweeps on its way, seen along the way.

shadow    of the cutter along its way. A straight pass leaves just this section, so scallops stand between
          neighbouring shadows.
support   of a convex body in a direction d: the largest d . x of its points. Seen along the way, the support
          in a direction across it is that of the body itself: so a shadow needs no hidden line.

With w the angle, at the contact, between the direction across and the plane of axis and normal, and t the
sine of the angle between axis and normal, the shadow of a ring with a corner has at its contact the radius
``corner + ring sin(w)^2 / t``: the support function's second derivatives are the body's radii of curvature,
corner in that plane and ring / t + corner square to it.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.vectors import row_dot

LEVEL = 1e-12
"""Sine below which a level bottom lies on the surface."""

STEPS = 360
"""Directions of the shadow's outline on each side: its chords lie within it, by less than 1e-4 of its
radius."""

PIECE = 72
"""Of these are looked at together."""

CHUNK = 256
"""Rows whose outlines are held at a time."""


def effective_radius(normal: Floats, axis: Floats, direction: Floats, ring: float, corner: float) -> Floats:
    """Radius (n,) mm of the shadow at the contact; see :meth:`.Cutter.effective_radius`."""
    across = _tangent(direction, normal)
    meridian = axis - row_dot(axis, normal)[:, None] * normal
    square = row_dot(meridian, meridian)  # t^2
    beside = np.maximum(square - row_dot(across, meridian) ** 2, 0.0)  # (t sin w)^2
    level = square <= LEVEL**2
    cubed = np.where(level, 1.0, square * np.sqrt(square))
    return np.asarray(corner + ring * np.where(level, np.inf if ring > 0.0 else 0.0, beside / cubed))


def width_at(
    normal: Floats, axis: Floats, direction: Floats, height: float, discs: Floats, bend: float = 0.0
) -> Floats:
    """Width (n,) mm of the shadow ``height`` mm above the contact.

    ``discs`` (k, 5): radius, rounding and height along the axis of the discs whose hull the body is, and from
    which to which part along the axis of a direction they support it. ``bend`` 1/mm: curvature of
    the surface along the way, convex positive: what cuts a distance b before or behind the contact cuts
    ``bend b^2 / 2`` less.
    """
    width = np.empty(len(normal))
    across = _tangent(direction, normal)
    for low in range(0, len(normal), CHUNK):
        rows = slice(low, low + CHUNK)
        sides = (
            _reach(normal[rows], axis[rows], side * across[rows], height, discs, bend) for side in (1.0, -1.0)
        )
        width[rows] = sum(sides)
    return width


def _reach(normal: Floats, axis: Floats, across: Floats, height: float, discs: Floats, bend: float) -> Floats:
    """How far (n,) the shadow reaches towards ``across`` at that height, from the hub. Most rise to it near
    the contact: the outline is followed piece by piece, until it is higher."""
    angle = np.linspace(0.0, np.pi, STEPS + 1)
    angle = np.pi * (angle / np.pi) ** 2  # finer near the contact, where scallops are
    reach, rows = np.empty(len(normal)), np.arange(len(normal))
    low = aside = top = np.zeros((len(normal), 1))
    for begin in range(0, STEPS, PIECE):
        piece = angle[begin : begin + PIECE + 1]  # up to where the next one begins
        x, y, z = _outline(normal[rows], axis[rows], across[rows], piece, discs)
        if begin == 0:
            low, aside, top = y[:, :1], z[:, :1], np.full((len(y), 1), -np.inf)
        y = y - low + 0.5 * bend * (z - aside) ** 2
        y = np.maximum(np.maximum.accumulate(y, axis=1), top)
        ends = (y[:, -1] > height) | (begin + PIECE >= STEPS)
        reach[rows[ends]] = _cross(x[ends], y[ends], height)
        rows, low, aside, top = rows[~ends], low[~ends], aside[~ends], y[~ends, -1:]
        if not len(rows):
            break
    return reach


def _cross(x: Floats, y: Floats, height: float) -> Floats:
    """Where (n,) lines through the places ``x``, ``y`` (n, m), which rise, are at that height."""
    last = np.clip((y <= height).sum(axis=1) - 1, 0, y.shape[1] - 2)
    row = np.arange(len(y))
    rise = y[row, last + 1] - y[row, last]
    share = np.clip((height - y[row, last]) / np.where(rise > 0.0, rise, 1.0), 0.0, 1.0)
    return np.asarray(x[row, last] + share * (x[row, last + 1] - x[row, last]))


def _outline(
    normal: Floats, axis: Floats, across: Floats, angle: Floats, discs: Floats
) -> tuple[Floats, Floats, Floats]:
    """Places (n, m) across, above and along the way of the points that support the body in directions
    ``angle`` (m,) from straight down."""
    down, aside = -np.cos(angle), np.sin(angle)
    up_axis, side_axis = row_dot(normal, axis)[:, None], row_dot(across, axis)[:, None]
    along = down * up_axis + aside * side_axis
    radial_up, radial_side = down - along * up_axis, aside - along * side_axis
    length = np.sqrt(np.maximum(1.0 - along * along, LEVEL))
    best = np.full(along.shape, -np.inf)
    way_axis = row_dot(np.cross(across, normal), axis)[:, None]
    x, y, z = np.zeros(along.shape), np.zeros(along.shape), np.zeros(along.shape)
    for radius, rounding, height, least, most in discs:
        support = radius * length + rounding + height * along
        support[(along < least) | (along > most)] = -np.inf
        more = support > best
        best = np.where(more, support, best)
        x = np.where(more, radius * radial_side / length + rounding * aside + height * side_axis, x)
        y = np.where(more, radius * radial_up / length + rounding * down + height * up_axis, y)
        z = np.where(more, (height - radius * along / length) * way_axis, z)
    return x, y, z


def _tangent(direction: Floats, normal: Floats) -> Floats:
    across = direction - row_dot(direction, normal)[:, None] * normal
    return np.asarray(across / np.sqrt(row_dot(across, across))[:, None])
