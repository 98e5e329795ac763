# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets of plain solids.

around   a round solid gets flat sides that touch it from outside: nothing of it sticks out of them.
"""

from __future__ import annotations

import itertools
import math

import numpy as np

from freecad_fiveaxis.core.base.records import Floats

SIDES = 48
"""Of a round solid: its facets make it at most 0.2 % wider."""


def box_facets(low: Floats, high: Floats) -> Floats:
    """Give the facets (12, 3, 3), mm, of a box from its ``low`` to its ``high`` corner, seen from outside
    counterclockwise."""
    corner = np.array(
        [[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    )
    sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return np.asarray(corner[[[side[0], *two] for side in sides for two in (side[1:3], side[2:4])]])


def frustum_facets(low: Floats, high: Floats, low_radius: float, high_radius: float) -> Floats:
    """Give facets (f, 3, 3), mm, around a cylinder or a frustum, from the middle of the one end to that of
    the other."""
    way = (high - low) / np.linalg.norm(high - low)
    across = np.cross(way, np.eye(3)[np.abs(way).argmin()])
    across /= np.linalg.norm(across)
    angle = 2.0 * math.pi * np.arange(SIDES) / SIDES
    ring = (np.cos(angle)[:, None] * across + np.sin(angle)[:, None] * np.cross(way, across)) / math.cos(
        math.pi / SIDES
    )
    return _lathe([low, low + low_radius * ring, high + high_radius * ring, high])


def sphere_facets(centre: Floats, radius: float) -> Floats:
    """Give facets (f, 3, 3), mm, around a sphere."""
    rows = SIDES // 2
    polar = math.pi * (np.arange(rows) + 0.5) / rows
    wide = radius / math.cos(math.pi / SIDES) ** 2
    angle = 2.0 * math.pi * np.arange(SIDES) / SIDES
    flat = np.stack([np.cos(angle), np.sin(angle), np.zeros(SIDES)], axis=1)
    up = np.array([0.0, 0.0, wide])
    rings = [centre - math.cos(at) * up + wide * math.sin(at) * flat for at in polar]
    return _lathe([centre - up, *rings, centre + up])


def _lathe(rings: list[Floats]) -> Floats:
    """Return the facets of a body of rings (SIDES, 3) from its first point to its last."""
    full = [np.broadcast_to(ring, (SIDES, 3)) for ring in rings]
    found = []
    for one, other in itertools.pairwise(full):
        a, b, c, d = one, np.roll(one, -1, axis=0), np.roll(other, -1, axis=0), other
        found += [np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]
    facet = np.concatenate(found)
    area = np.linalg.norm(np.cross(facet[:, 1] - facet[:, 0], facet[:, 2] - facet[:, 0]), axis=1)
    return np.asarray(facet[area > 0.0])
