# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's machines with a nutating head over a turning table: ``xyzacb_trsrn`` and ``xyzbca_trsrn``
(2.10).

The head's C carries a second axis that leans by the pin nut-angle from Z: B about n = (0, sin, cos) in the YZ
plane, or A about n = (sin, 0, cos) in the XZ plane. With l = (0, y-pivot, z-pivot), for A (x-pivot, 0,
z-pivot), d = (x-offset, y-offset, 0), t the tool length, r a point of the table's line and Rn the turn about
n, the kinematics of tool centre point control are

    P - t ez = r + Rx(A)( J + d + l - Rz(C)( d + Rn(B)( l + t ez ) ) - r )          k = Rx(A) Rz(C) Rn(B) ez

for A: Ry(B) before, Rn(A) behind. All signs are those of ISO 841. C runs through d + l, the second axis
through l.

held    there are three rotary axes, and a machine file has two: the head's. The table stays at 0, where its
        line (y-, z-rot-axis, or x-) does not matter. A finding says so.

Source: ``xyzacb_trsrn.comp``, ``xyzbca_trsrn.comp``. Their pins pre-rot, primary-angle and secondary-angle
serve tilted planes.
"""

from __future__ import annotations

import math
from functools import partial

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.sentences import Number, say
from freecad_fiveaxis.core.machine import Vector

from .record import Given, Kinematics, Pin, Turn, Z

NUTATION = "nut-angle"
LEAST = 1e-3
"""Degrees; a head that leans by less never tilts the tool."""


def _head(given: Given, letter: str, along: int) -> tuple[Turn, ...]:
    """Return the head's C and the axis ``letter`` that it carries; ``along``: 0 where that leans towards X, 1
    for Y."""
    value = given.values
    if not LEAST < abs(value[NUTATION]) < 180.0 - LEAST:
        text = say(
            "{where}: nut-angle is {angle} degrees, so the head never tilts the tool; write setp {pin} with "
            "your head's angle",
            pin=f"{given.module}.{NUTATION}",
            where=given.where,
            angle=Number(value[NUTATION]),
        )
        raise MachineError(text, value[NUTATION])
    pivot = _in_plane(value[f"{'xy'[along]}-pivot"], value["z-pivot"], along)
    x, y, z = pivot
    angle = math.radians(value[NUTATION])
    leaning = _in_plane(math.sin(angle), math.cos(angle), along)
    return Turn("C", "head", Z, (x + value["x-offset"], y + value["y-offset"], z)), Turn(
        letter, "head", leaning, pivot
    )


def _in_plane(across: float, up: float, along: int) -> Vector:
    return (across, 0.0, up) if along == 0 else (0.0, across, up)


def _pins(across: str) -> tuple[Pin, ...]:
    lengths = (f"{across}-pivot", "z-pivot", "x-offset", "y-offset")
    return (*(Pin(name) for name in lengths), Pin(NUTATION, length=False))


NUTATING = (
    Kinematics(
        "xyzacb_trsrn", "XYZABC", "XYZBC", partial(_head, letter="B", along=1), prefix="xyzacb_trsrn_kins",
        spare="A",
        tool="tool-offset-z", pins=_pins("y"), fixed=True,
    ),
    Kinematics(
        "xyzbca_trsrn", "XYZABC", "XYZAC", partial(_head, letter="A", along=0), prefix="xyzbca_trsrn_kins",
        spare="B",
        tool="tool-offset-z", pins=_pins("x"), fixed=True,
    ),
)  # fmt: skip
