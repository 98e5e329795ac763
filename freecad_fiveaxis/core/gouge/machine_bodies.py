# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a machine as meshes, and what the spindle carries as part of the tool."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_triangles, read_stl
from freecad_fiveaxis.core.geometry.solids import box_facets, frustum_facets, sphere_facets
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.bodies import BOX, CONE, FILE, SPHERE, SPINDLE, MachineBody, is_round
from freecad_fiveaxis.core.tool.body import SPINDLE as SPINDLE_PART
from freecad_fiveaxis.core.tool.body import Body, frustum_piece


def make_mesh(body: MachineBody, shift: Floats, progress: Progress = silent) -> Mesh:
    """Make the mesh of a body, mm, moved by ``shift`` (3,). Raises FiveAxisError for a file that is no
    mesh."""
    if body.shape == FILE:
        try:
            found = read_stl(body.file, progress)
        except FiveAxisError as error:
            raise FileError(say("body {name}: {error}", name=body.name, error=error), error.value) from error
        return from_triangles(found.vertex[found.face] + shift)
    points = np.array(body.points)
    if body.shape == BOX:
        corner = box_facets(*points)
    elif body.shape == SPHERE:
        corner = sphere_facets(points[0], body.radii[0])
    else:
        low, high = body.radii if body.shape == CONE else (body.radii[0], body.radii[0])
        corner = frustum_facets(points[0], points[1], low, high)
    return from_triangles(corner + shift)


def spindle_body(machine: Machine, length: float) -> Body:
    """Give what is round of what the spindle carries as pieces about the tool axis, heights from a driven
    point ``length`` mm below the gauge point."""
    pieces = []
    for body in find_round_bodies(machine):
        low, high = (point[2] - machine.gauge_point[2] + length for point in body.points)
        wide = body.radii if body.shape == CONE else (body.radii[0], body.radii[0])
        pieces.append(frustum_piece(low, wide[0], high, wide[1], SPINDLE_PART))
    return Body(tuple(pieces))


def find_round_bodies(machine: Machine) -> tuple[MachineBody, ...]:
    """Find what is round of what the spindle carries, in the order of the pieces of :func:`spindle_body`."""
    return tuple(
        one for one in machine.bodies if one.carrier == SPINDLE and is_round(one, machine.gauge_point)
    )
