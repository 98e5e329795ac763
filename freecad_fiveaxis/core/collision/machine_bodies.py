# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a machine as meshes, and what the spindle carries as part of the tool.

around   a round body's mesh has flat sides that touch it from outside: nothing of the body sticks out of them.
"""

from __future__ import annotations

import itertools
import math

import numpy as np

from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_triangles, read_stl
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.bodies import BOX, CONE, FILE, SPHERE, SPINDLE, MachineBody
from freecad_fiveaxis.core.tool.body import SPINDLE as SPINDLE_PART
from freecad_fiveaxis.core.tool.body import Body, frustum_piece

SIDES = 48
"""Of a round body: its mesh is at most 0.2 % wider."""


def make_mesh(body: MachineBody, shift: Floats, progress: Progress = silent) -> Mesh:
    """Make the mesh of a body, mm, moved by ``shift`` (3,). Raises FiveAxisError for a file that is no mesh."""
    if body.shape == FILE:
        try:
            found = read_stl(body.file, progress)
        except FiveAxisError as error:
            raise FileError(say("body {name}: {error}", name=body.name, error=error), error.value) from error
        return from_triangles(found.vertex[found.face] + shift)
    points = np.array(body.points)
    if body.shape == BOX:
        corner = _box(*points)
    elif body.shape == SPHERE:
        corner = _sphere(points[0], body.radii[0])
    else:
        low, high = body.radii if body.shape == CONE else (body.radii[0], body.radii[0])
        corner = _frustum(points[0], points[1], low, high)
    return from_triangles(corner + shift)


def spindle_body(machine: Machine, length: float) -> Body:
    """Give what the spindle carries as pieces about the tool axis, heights from a driven point ``length`` mm below the gauge
    point."""
    pieces = []
    for body in machine.bodies:
        if body.carrier == SPINDLE:
            low, high = (point[2] - machine.gauge_point[2] + length for point in body.points)
            wide = body.radii if body.shape == CONE else (body.radii[0], body.radii[0])
            pieces.append(frustum_piece(low, wide[0], high, wide[1], SPINDLE_PART))
    return Body(tuple(pieces))


def _box(low: Floats, high: Floats) -> Floats:
    """The facets (12, 3, 3) of a box."""
    corner = np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
    sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return np.asarray(corner[[[side[0], *two] for side in sides for two in (side[1:3], side[2:4])]])


def _frustum(low: Floats, high: Floats, low_radius: float, high_radius: float) -> Floats:
    """The facets (f, 3, 3) around a cylinder or a frustum, from the middle of the one end to that of the other."""
    way = (high - low) / np.linalg.norm(high - low)
    across = np.cross(way, np.eye(3)[np.abs(way).argmin()])
    across /= np.linalg.norm(across)
    angle = 2.0 * math.pi * np.arange(SIDES) / SIDES
    ring = (np.cos(angle)[:, None] * across + np.sin(angle)[:, None] * np.cross(way, across)) / math.cos(math.pi / SIDES)
    return _lathe([low, low + low_radius * ring, high + high_radius * ring, high])


def _sphere(centre: Floats, radius: float) -> Floats:
    """The facets (f, 3, 3) around a sphere."""
    rows = SIDES // 2
    polar = math.pi * (np.arange(rows) + 0.5) / rows
    wide = radius / math.cos(math.pi / SIDES) ** 2
    angle = 2.0 * math.pi * np.arange(SIDES) / SIDES
    flat = np.stack([np.cos(angle), np.sin(angle), np.zeros(SIDES)], axis=1)
    up = np.array([0.0, 0.0, wide])
    rings = [centre - math.cos(at) * up + wide * math.sin(at) * flat for at in polar]
    return _lathe([centre - up, *rings, centre + up])


def _lathe(rings: list[Floats]) -> Floats:
    """The facets of a body of rings (SIDES, 3) from its first point to its last."""
    full = [np.broadcast_to(ring, (SIDES, 3)) for ring in rings]
    found = []
    for one, other in itertools.pairwise(full):
        a, b, c, d = one, np.roll(one, -1, axis=0), np.roll(other, -1, axis=0), other
        found += [np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]
    facet = np.concatenate(found)
    area = np.linalg.norm(np.cross(facet[:, 1] - facet[:, 0], facet[:, 2] - facet[:, 0]), axis=1)
    return np.asarray(facet[area > 0.0])
