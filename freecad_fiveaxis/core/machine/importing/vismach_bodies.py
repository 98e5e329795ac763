# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes of a vismach model as bodies of a machine, mm in the machine frame with every joint at zero.

box      stays one where it stands along X, Y and Z, and is a mesh where it leans.
mesh     an STL file in the folder of the model, or where its name leads from there.
spindle  takes what is round about the tool's line above the gauge point and carried as the tool is: that is
         proven as part of the tool. All else goes with the axis that carries it.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from freecad_fiveaxis.core.base.errors import FiveAxisError, MachineError
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_triangles, read_corners
from freecad_fiveaxis.core.geometry.solids import box_facets
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.machine.bodies import (
    BOX,
    CONE,
    CYLINDER,
    FILE,
    SPHERE,
    SPINDLE,
    MachineBody,
    free_body_name,
    is_round,
)
from freecad_fiveaxis.core.machine.bodies_file import read_bodies, write_bodies

from .urdf_bodies import is_straight, move_points
from .vismach_file import wrong
from .vismach_parts import Part
from .vismach_tree import Placed

MOST = 500
"""Bodies of one machine."""
ALONG = {"CylinderX": (1.0, 0.0, 0.0), "CylinderY": (0.0, 1.0, 0.0), "CylinderZ": (0.0, 0.0, 1.0)}


def make_bodies(
    shapes: Sequence[Placed], carrier: Callable[[Placed], tuple[str, bool]], gauge: Vector, path: Path
) -> tuple[tuple[MachineBody, ...], dict[str, Mesh], list[tuple[int, str]]]:
    """Make a body of each shape, with the meshes of those of the shape ``file`` by their names, and say by
    line why what makes none does not.

    ``shapes``: placed in mm in the machine frame; ``carrier``: of a shape, with whether that carries the
    tool, too. Raises MachineError for a mesh that is not there, FileError."""
    bodies: list[MachineBody] = []
    meshes: dict[str, Mesh] = {}
    left: list[tuple[int, str]] = []
    for shape in shapes[: MOST + 1]:
        name = free_body_name(shape.name, [body.name for body in bodies])
        try:
            letter, with_tool = carrier(shape)
            body = _body(name, letter, shape)
            _check(body)
        except MachineError as error:
            left.append((shape.part.line, say("{text}: {error}", text=shape.part.text, error=error)))
            continue
        bodies.append(_on_spindle(body, gauge) if with_tool else body)
        if body.shape == FILE:
            meshes[name] = _mesh(shape, path)
    if len(bodies) > MOST:
        text = say("it has more than {most} shapes; give a model of fewer, larger ones", most=MOST)
        raise wrong(path, text)
    return tuple(bodies), meshes, left


def _check(body: MachineBody) -> None:
    """Refuse what the machine's file could not be read with. Raises MachineError."""
    named = replace(body, file=body.name) if body.shape == FILE else body
    read_bodies(write_bodies([named]), "bodies", 1.0)


def _on_spindle(body: MachineBody, gauge: Vector) -> MachineBody:
    if not is_round(body, gauge) or body.points[0][2] < gauge[2] - 1e-6:
        return body
    return replace(body, carrier=SPINDLE)


def _body(name: str, carrier: str, shape: Placed) -> MachineBody:
    """Make the body of a shape, of the shape ``file`` still without its file. Raises MachineError for a flat
    box."""
    part, place = shape.part, shape.place
    if part.kind == "AsciiSTL":
        return MachineBody(name, carrier, FILE)
    if part.kind == "Sphere":
        *centre, radius = part.numbers("x", "y", "z", "r")
        return MachineBody(name, carrier, SPHERE, _points([centre], place), (_scale_length(radius, place),))
    if part.kind in ALONG:
        return _round(name, carrier, part, place)
    ends = np.array(_ends(part))
    if not is_straight(place / _scale(place)):
        return MachineBody(name, carrier, FILE)
    return MachineBody(name, carrier, BOX, _round_points(np.sort(move_points(ends, place), axis=0)))


def _ends(part: Part) -> tuple[Floats, Floats]:
    """Return the lowest and the highest corner of a box. Raises MachineError for a flat one."""
    given = part.given
    if part.kind == "Box":
        one, other = part.numbers("x1", "y1", "z1"), part.numbers("x2", "y2", "z2")
    else:
        x, y, z = part.numbers("xw", "yw", "zw")
        high = z if part.kind == "BoxCenteredXY" else 0.5 * given["zw"]
        one, other = (-0.5 * x, -0.5 * y, high - z), (0.5 * x, 0.5 * y, high)
    low, high_corner = np.sort(np.array([one, other]), axis=0)
    if not np.all(low < high_corner):
        raise MachineError(say("it is flat"), part.text)
    return low, high_corner


def _round(name: str, carrier: str, part: Part, place: Floats) -> MachineBody:
    """Make the body of a cylinder or a cone, its lower end first."""
    along = np.array(ALONG[part.kind])
    axis = part.kind[-1].lower()
    heights, radii = part.numbers(f"{axis}1", f"{axis}2"), part.numbers("r1", "r2")
    points = _points([height * along for height in heights], place)
    wide = tuple(_scale_length(radius, place) for radius in radii)
    if points[0][2] > points[1][2]:
        points, wide = points[::-1], wide[::-1]
    alike = wide[0] == wide[1]
    return MachineBody(name, carrier, CYLINDER if alike else CONE, points, wide[:1] if alike else wide)


def _scale(place: Floats) -> float:
    """Return mm for a unit of the model."""
    return float(np.linalg.norm(place[:3, 0]))


def _scale_length(length: float, place: Floats) -> float:
    return round(length * _scale(place), 9)


def _points(points: Sequence[Sequence[float] | Floats], place: Floats) -> tuple[Vector, ...]:
    return _round_points(move_points(np.array(points, float), place))


def _round_points(points: Floats) -> tuple[Vector, ...]:
    return tuple((x, y, z) for x, y, z in (np.round(points, 9) + 0.0).tolist())


def _mesh(shape: Placed, path: Path) -> Mesh:
    """Make the mesh, mm, of an STL file, or of a box that leans. Raises MachineError, FileError."""
    part = shape.part
    facets = _facets(part, path) if part.kind == "AsciiSTL" else box_facets(*_ends(part))
    try:
        return from_triangles(move_points(facets, shape.place))
    except FiveAxisError as error:
        raise wrong(path, say("line {line}: {error}", line=part.line, error=error)) from error


def _facets(part: Part, path: Path) -> Floats:
    """Return the facets (f, 3, 3) of a mesh as its file has them. Raises MachineError, FileError."""
    file = path.absolute().parent / part.given["filename"]
    if not os.path.isfile(file):
        text = say(
            "line {line}: {file} is not found; put it beside the model", line=part.line, file=str(file)[-120:]
        )
        raise wrong(path, text)
    return read_corners(file)
