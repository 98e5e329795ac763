# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a machine, under ``fiveaxis.bodies`` of its file: what the tool must not hit, and what carries the tool.

carrier  the axis of the table that carries the body, ``base`` for what stands still, ``spindle`` for what goes with the tool.
shape    ``box`` {low, high}, ``cylinder`` {low, high, radius}, ``cone`` {low, high, low_radius, high_radius} (low and high are
         the middles of its ends), ``sphere`` {centre, radius}, or ``file``, an STL in mm beside the machine's file.
place    all in the machine frame with every joint at zero, in the file's unit.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.sentences import say

Vector = tuple[float, float, float]

BASE, SPINDLE = "base", "spindle"
FILE, BOX, CYLINDER, CONE, SPHERE = "file", "box", "cylinder", "cone", "sphere"
POINTS = {BOX: ("low", "high"), CYLINDER: ("low", "high"), CONE: ("low", "high"), SPHERE: ("centre",)}
RADII = {BOX: (), CYLINDER: ("radius",), CONE: ("low_radius", "high_radius"), SPHERE: ("radius",)}
SHAPES = (FILE, *POINTS)

FARTHEST = 1e5
"""mm; no machine reaches a hundred metres."""


@dataclass(frozen=True)
class MachineBody:
    """``points`` and ``radii``, mm, machine frame, in the order of POINTS and RADII; ``file``: the STL instead, of a shape
    ``file``."""

    name: str
    carrier: str
    shape: str
    points: tuple[Vector, ...] = ()
    radii: tuple[float, ...] = ()
    file: str = ""


def read_bodies(given: Any, where: str, unit: float) -> tuple[MachineBody, ...]:
    """Read the list of bodies of a machine's file; ``unit``: mm for one of its lengths. Raises MachineError, with the key."""
    if not isinstance(given, list):
        raise _wrong(
            where, say('{given} is no list; write [{{"name": ..., "carrier": ..., "box": ...}}]', given=repr(given)[:40])
        )
    bodies = tuple(_read_body(one, f"{where}[{at}]", unit) for at, one in enumerate(given))
    names = [one.name for one in bodies]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise _wrong(where, say("two bodies are called {name}; give each a name of its own", name=twice))
    return bodies


def check_carriers(bodies: Sequence[MachineBody], table: Sequence[str], gauge: Vector) -> None:
    """Refuse a body whose carrier is no axis of the ``table``, and one on the spindle that does not turn with the tool about the
    line through the ``gauge`` point, mm. Raises MachineError."""
    for body in bodies:
        if body.carrier not in (BASE, SPINDLE, *table):
            known = ", ".join((BASE, SPINDLE, *table))
            text = say(
                "body {name}: {carrier} carries no body that is looked at; name one of {known}", name=body.name,
                carrier=body.carrier, known=known,
            )  # fmt: skip
            raise MachineError(text, body.carrier)
        if body.carrier == SPINDLE and not _is_round(body, gauge):
            text = say(
                "body {name}: what the spindle carries is a cylinder or a cone about the line through the gauge point, upright, "
                "its low end first; give one around it",
                name=body.name,
            )
            raise MachineError(text, body.name)


def _is_round(body: MachineBody, gauge: Vector) -> bool:
    if body.shape not in (CYLINDER, CONE):
        return False
    low, high = body.points
    return low[2] < high[2] and all(math.dist(one[:2], gauge[:2]) < 1e-6 for one in (low, high))


def write_bodies(bodies: Sequence[MachineBody]) -> list[dict[str, Any]]:
    """Write the bodies as the file holds them, mm."""
    return [{"name": one.name, "carrier": one.carrier, one.shape: _shape_data(one)} for one in bodies]


def _shape_data(body: MachineBody) -> Any:
    if body.shape == FILE:
        return body.file
    points = dict(zip(POINTS[body.shape], map(list, body.points), strict=True))
    return points | dict(zip(RADII[body.shape], body.radii, strict=True))


def _read_body(given: Any, where: str, unit: float) -> MachineBody:
    if not isinstance(given, dict):
        raise _wrong(where, say("{given} is not an object; write {{ ... }}", given=repr(given)[:40]))
    name, carrier = (_text(given, where, key) for key in ("name", "carrier"))
    shapes = [key for key in given if key in SHAPES]
    spare = [key for key in given if key not in ("name", "carrier", *SHAPES)]
    if spare or len(shapes) != 1:
        said = (
            say("key {key} is not known; leave it out", key=spare[0])
            if spare
            else say("it needs one of {shapes}", shapes=", ".join(SHAPES))
        )
        raise _wrong(where, said)
    shape = shapes[0]
    if shape == FILE:
        return MachineBody(name, carrier, shape, file=_text(given, where, FILE))
    return MachineBody(name, carrier, shape, *_sizes(given[shape], shape, f"{where}.{shape}", unit))


def _sizes(given: Any, shape: str, where: str, unit: float) -> tuple[tuple[Vector, ...], tuple[float, ...]]:
    wanted = (*POINTS[shape], *RADII[shape])
    if not isinstance(given, dict) or set(given) != set(wanted):
        raise _wrong(where, say("it needs {keys} and nothing else", keys=", ".join(wanted)))
    points = tuple(_point(given[key], f"{where}.{key}", unit) for key in POINTS[shape])
    radii = tuple(unit * _size(given[key], f"{where}.{key}") for key in RADII[shape])
    if any(radius < 0.0 or radius > FARTHEST for radius in radii) or (radii and max(radii) <= 0.0):
        raise _wrong(where, say("radius {radii} is not above 0, or beyond {most} mm", radii=radii, most=FARTHEST))
    if shape == BOX and not all(low < high for low, high in zip(*points, strict=True)):
        raise _wrong(where, say("low is not below high in each of X, Y, Z"))
    if shape in (CYLINDER, CONE) and math.dist(*points) <= 0.0:
        raise _wrong(where, say("low and high are one point"))
    return points, radii


def _point(given: Any, where: str, unit: float) -> Vector:
    if not isinstance(given, list) or len(given) != 3:
        raise _wrong(where, say("{value} is not a vector; write [x, y, z]", value=repr(given)[:40]))
    x, y, z = (unit * _size(one, where) for one in given)
    if max(abs(x), abs(y), abs(z)) > FARTHEST:
        raise _wrong(where, say("{value} is beyond {most} mm", value=repr(given)[:40], most=FARTHEST))
    return x, y, z


def _size(given: Any, where: str) -> float:
    if isinstance(given, bool) or not isinstance(given, int | float) or not math.isfinite(given):
        raise _wrong(where, say("{value} is not a finite number", value=repr(given)[:40]))
    return float(given)


def _text(given: Mapping[str, Any], where: str, key: str) -> str:
    value = given.get(key)
    if not isinstance(value, str) or not value.strip() or not value.isprintable():
        raise _wrong(f"{where}.{key}", say("{value} is not a text; write one in quotes", value=repr(value)[:40]))
    return value.strip()


def _wrong(where: str, problem: str) -> MachineError:
    return MachineError(say("{key}: {problem}", key=where, problem=problem), where)
