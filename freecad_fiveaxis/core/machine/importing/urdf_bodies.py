# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes of a URDF file's links as bodies of a machine, mm in the machine frame with every joint at zero.

box      stays one where it stands along X, Y and Z, and is a mesh where it leans.
mesh     an STL file, scaled and moved to where it stands. ``package://NAME/...`` is looked for in the folders
         above the URDF: in one that is called NAME, or that holds one of that name.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from urllib.parse import unquote, urlsplit

import numpy as np

from freecad_fiveaxis.core.base.errors import FiveAxisError, MachineError
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_triangles, read_corners
from freecad_fiveaxis.core.geometry.solids import box_facets
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.machine.bodies import BOX, CYLINDER, FILE, SPHERE, MachineBody, free_body_name

from .urdf_file import Robot, Shape, wrong

MM = 1000.0
STRAIGHT = 1e-9
"""How far from 0 an element of a turn may be that is one of quarters."""


def make_bodies(
    robot: Robot, places: Mapping[str, Floats], carriers: Mapping[str, str], path: Path
) -> tuple[tuple[MachineBody, ...], dict[str, Mesh]]:
    """Make a body of each shape of each link, and the meshes of those of the shape ``file`` by their names.
    Raises MachineError for what is no shape of a body, FileError for a mesh that cannot be read."""
    bodies: list[MachineBody] = []
    meshes: dict[str, Mesh] = {}
    for link, shapes in robot.links.items():
        for shape in shapes:
            name = free_body_name(link, [body.name for body in bodies])
            body, mesh = _body(name, carriers[link], shape, places[link] @ shape.place, path)
            bodies.append(body)
            if mesh is not None:
                meshes[name] = mesh
    return tuple(bodies), meshes


def _body(
    name: str, carrier: str, shape: Shape, place: Floats, path: Path
) -> tuple[MachineBody, Mesh | None]:
    if not all(size > 0.0 for size in shape.sizes if shape.kind != "mesh"):
        raise wrong(
            path,
            say(
                "{name}: the sizes {sizes} of its {kind} are not above 0; give others",
                name=name,
                sizes=_text(shape.sizes),
                kind=shape.kind,
            ),
        )
    if shape.kind == "mesh" or (shape.kind == "box" and not is_straight(place)):
        corners = _file_corners(name, shape, path) if shape.kind == "mesh" else _box_corners(shape)
        return MachineBody(name, carrier, FILE), _mesh(name, MM * move_points(corners, place), path)
    return MachineBody(name, carrier, *_solid(shape, place)), None


def _solid(shape: Shape, place: Floats) -> tuple[str, tuple[Vector, ...], tuple[float, ...]]:
    """Shape, points and radii, mm, of what is no mesh."""
    if shape.kind == "sphere":
        return SPHERE, _points(np.zeros((1, 3)), place), (MM * shape.sizes[0],)
    if shape.kind == "cylinder":
        radius, length = shape.sizes
        return (
            CYLINDER,
            _points(np.array([[0.0, 0.0, -0.5 * length], [0.0, 0.0, 0.5 * length]]), place),
            (MM * radius,),
        )
    corners = move_points(_box_corners(shape), place).reshape(-1, 3)
    return BOX, _points(np.stack([corners.min(axis=0), corners.max(axis=0)]), np.eye(4)), ()


def _text(sizes: Iterable[float]) -> str:
    return " ".join(f"{size:g}" for size in sizes)


def _points(points: Floats, place: Floats) -> tuple[Vector, ...]:
    return tuple((x, y, z) for x, y, z in np.round(MM * move_points(points, place), 9).tolist())


def move_points(points: Floats, place: Floats) -> Floats:
    """Move points (..., 3) by a place 4x4."""
    return np.asarray(points @ place[:3, :3].T + place[:3, 3])


def is_straight(place: Floats) -> bool:
    """Tell whether a place 4x4 turns by quarters alone."""
    turn = np.abs(place[:3, :3])
    return bool(np.all((turn < STRAIGHT) | (turn > 1.0 - STRAIGHT)))


def _box_corners(shape: Shape) -> Floats:
    half = 0.5 * np.array(shape.sizes)
    return box_facets(-half, half)


def _file_corners(name: str, shape: Shape, path: Path) -> Floats:
    """Return the facets (f, 3, 3), m, of a mesh in its link's frame, outside out for a scale that mirrors
    too."""
    if not all(shape.sizes):
        raise wrong(
            path,
            say(
                "{name}: the scale {scale} of its mesh has a 0; give three others",
                name=name,
                scale=_text(shape.sizes),
            ),
        )
    file = _find(name, shape.file, path)
    if file.suffix.lower() != ".stl":
        text = say(
            "{name}: the mesh {file} is no STL file; convert it, or give a collision shape",
            name=name,
            file=shape.file[:80],
        )
        raise wrong(path, text)
    corners = read_corners(file) * np.array(shape.sizes)
    return np.asarray(corners[:, ::-1] if np.prod(shape.sizes) < 0.0 else corners)


def _find(name: str, given: str, path: Path) -> Path:
    """Return the file of a mesh. Raises MachineError where there is none."""
    for one in _candidates(given, path.absolute().parent):
        if os.path.isfile(one):
            return one
    raise wrong(
        path,
        say("{name}: its mesh {file} is not found; put it beside the URDF file", name=name, file=given[:120]),
    )


def _candidates(given: str, folder: Path) -> Iterator[Path]:
    try:
        parts = urlsplit(given) if "://" in given else None
    except ValueError:  # brackets that hold no address
        return
    if parts is None:
        yield folder / given
    elif parts.scheme == "package":
        inside = unquote(parts.path).lstrip("/")
        for above in (folder, *folder.parents):
            yield (above if above.name == parts.netloc else above / parts.netloc) / inside
    elif parts.scheme == "file":
        yield Path(unquote(parts.path))


def _mesh(name: str, corners: Floats, path: Path) -> Mesh:
    try:
        return from_triangles(corners)
    except FiveAxisError as error:
        raise MachineError(
            say("{path}: {name}: {error}", path=path, name=name, error=error), error.value
        ) from error
