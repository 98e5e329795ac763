# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a machine (:mod:`.bodies`) in its file, in and out."""

from __future__ import annotations

import math
import reprlib
from collections.abc import Sequence
from typing import Any

from freecad_fiveaxis.core.base.sentences import say

from .bodies import BOX, CONE, CYLINDER, FARTHEST, FILE, POINTS, RADII, SHAPES, MachineBody
from .keys import JsonObject, as_number, as_vector, fail, get_text
from .model import Vector


def read_bodies(given: Any, where: str, unit: float) -> tuple[MachineBody, ...]:
    """Read the list of bodies of a machine's file; ``unit``: mm for one of its lengths. Raises MachineError,
    with the key."""
    if not isinstance(given, list):
        text = say(
            '{given} is no list; write [{{"name": ..., "carrier": ..., "box": ...}}]',
            given=reprlib.repr(given),
        )
        raise fail(where, text, given)
    bodies = tuple(_read_body(one, f"{where}[{at}]", unit) for at, one in enumerate(given))
    names = [one.name for one in bodies]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise fail(where, say("two bodies are called {name}; give each a name of its own", name=twice), twice)
    return bodies


def write_bodies(bodies: Sequence[MachineBody]) -> list[dict[str, Any]]:
    """Write the bodies as the file holds them, mm."""
    return [_body_data(one) for one in bodies]


def _body_data(body: MachineBody) -> dict[str, Any]:
    data = {"name": body.name, "carrier": body.carrier, body.shape: _shape_data(body)}
    return data | ({"clearance": body.clearance} if body.clearance else {})


def _shape_data(body: MachineBody) -> Any:
    if body.shape == FILE:
        return body.file
    points = dict(zip(POINTS[body.shape], map(list, body.points), strict=True))
    return points | dict(zip(RADII[body.shape], body.radii, strict=True))


def _read_body(given: Any, where: str, unit: float) -> MachineBody:
    if not isinstance(given, dict):
        raise fail(where, say("{given} is not an object; write {{ ... }}", given=reprlib.repr(given)), given)
    name, carrier = (_name(given, where, key) for key in ("name", "carrier"))
    spare = [key for key in given if key not in ("name", "carrier", "clearance", *SHAPES)]
    if spare:
        raise fail(where, say("key {key} is not known; leave it out", key=spare[0]), spare)
    shapes = [key for key in given if key in SHAPES]
    if len(shapes) != 1:
        raise fail(where, say("it needs one of {shapes}", shapes=", ".join(SHAPES)), shapes)
    clearance = unit * as_number(given.get("clearance", 0.0), f"{where}.clearance")
    if not 0.0 <= clearance <= FARTHEST:
        text = say("{clearance} mm is no clearance; give 0 to {most} mm", clearance=clearance, most=FARTHEST)
        raise fail(f"{where}.clearance", text, clearance)
    if shapes[0] == FILE:
        return MachineBody(name, carrier, FILE, file=_name(given, where, FILE), clearance=clearance)
    sizes = _sizes(given[shapes[0]], shapes[0], f"{where}.{shapes[0]}", unit)
    return MachineBody(name, carrier, shapes[0], *sizes, clearance=clearance)


def _name(given: JsonObject, where: str, key: str) -> str:
    name = get_text(given, f"{where}.", key).strip()
    if not name:
        raise fail(f"{where}.{key}", say("it is empty; write a text in quotes"), name)
    return name


def _sizes(given: Any, shape: str, where: str, unit: float) -> tuple[tuple[Vector, ...], tuple[float, ...]]:
    wanted = (*POINTS[shape], *RADII[shape])
    if not isinstance(given, dict) or set(given) != set(wanted):
        raise fail(where, say("it needs {keys} and nothing else", keys=", ".join(wanted)), given)
    points = tuple(as_vector(given[key], f"{where}.{key}", unit, FARTHEST) for key in POINTS[shape])
    radii = tuple(unit * as_number(given[key], f"{where}.{key}") for key in RADII[shape])
    if any(radius < 0.0 or radius > FARTHEST for radius in radii) or (radii and max(radii) <= 0.0):
        raise fail(
            where,
            say("radius {radii} is not above 0, or beyond {most} mm", radii=radii, most=FARTHEST),
            radii,
        )
    if shape == BOX and not all(low < high for low, high in zip(*points, strict=True)):
        raise fail(where, say("low is not below high in each of X, Y, Z"), points)
    if shape in (CYLINDER, CONE) and math.dist(*points) <= 0.0:
        raise fail(where, say("low and high are one point"), points)
    return points, radii
