# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a machine, under ``fiveaxis.bodies`` of its file: what must not hit each other, and what the tool
must not hit.

carrier  the axis that carries the body, ``base`` for what stands still, ``spindle`` for what goes with the
         tool.
shape    ``box`` {low, high}, ``cylinder`` {low, high, radius}, ``cone`` {low, high, low_radius, high_radius}
         (low and high are the middles of its ends), ``sphere`` {centre, radius}, or ``file``, an STL in mm
         beside the machine's file.
clearance  how near tool, spindle and other bodies may come.
place    all in the machine frame with every joint at zero, in the file's unit.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from itertools import count

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
    """``points`` and ``radii``, mm, machine frame, in the order of POINTS and RADII; ``file``: the STL
    instead, of a shape ``file``; ``clearance`` mm: what comes nearer is told, 0: what is asked for of all."""

    name: str
    carrier: str
    shape: str
    points: tuple[Vector, ...] = ()
    radii: tuple[float, ...] = ()
    file: str = ""
    clearance: float = 0.0


def check_carriers(bodies: Sequence[MachineBody], letters: Sequence[str]) -> None:
    """Refuse a body whose carrier is no axis of these ``letters``. Raises MachineError."""
    for body in bodies:
        if body.carrier not in (BASE, SPINDLE, *letters):
            known = ", ".join((BASE, SPINDLE, *letters))
            text = say(
                "body {name}: {carrier} carries no body; name one of {known}",
                name=body.name,
                carrier=body.carrier,
                known=known,
            )
            raise MachineError(text, body.carrier)


def free_body_name(label: str, taken: Collection[str]) -> str:
    """Name a body after a label, unlike all that are ``taken``."""
    label = label.strip() or "body"
    numbered = (f"{label} {number}" for number in count(2))
    return label if label not in taken else next(name for name in numbered if name not in taken)


def is_round(body: MachineBody, gauge: Vector) -> bool:
    """Tell whether a body of the spindle turns with the tool about the line through the ``gauge`` point, mm:
    a cylinder or a cone, upright. It is then proven as part of the tool."""
    if body.shape not in (CYLINDER, CONE):
        return False
    low, high = body.points
    return low[2] < high[2] and all(math.dist(one[:2], gauge[:2]) < 1e-6 for one in (low, high))
