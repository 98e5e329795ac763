# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's machines with both rotary axes in the table: ``xyzac-trt-kins``, ``xyzbc-trt-kins`` and
``xyzab_tdr_kins``.

trt    a trunnion A (or B) carries the table C. With r = (x-, y-, z-rot-point) and d = (0, y-offset, z-offset
       + t), for B d = (x-offset, 0, z-offset + t),
           P = r + Rz(-C)( d + Rx(-A)( J - r - d ) )          k = Rz(-C) Rx(-A) ez
       The C line runs through r, the trunnion's through r + d. The **table** turns by +A and +C, against ISO
       841, unless the pin conventional-directions, which newer versions have, is set. Source: ``trtfuncs.c``,
       checked against the binary.
tdr    an axle B carries the table A. With r as above and d = (0, 0, z-offset),
           P - t ez = r + d + Rx(A)( Ry(B)( J - t ez - r ) - d )          k = Rx(A) Ry(B) ez
       The B line runs through r, the A line through r + d; both have the signs of ISO 841. The pin x-offset
       cancels out. Source: ``xyzab_tdr_kins.comp``.
"""

from __future__ import annotations

from functools import partial

from freecad_fiveaxis.core.machine import Vector

from .record import Given, Kinematics, Pin, Turn, X, Y, Z, apply_sense

CONVENTIONAL = Pin("conventional-directions", required=False, length=False)
CENTRE = tuple(Pin(f"{letter}-rot-point", required=False) for letter in "xyz")


def _centre(given: Given) -> Vector:
    """Return the point r of the formulas, mm."""
    x, y, z = (given.values[pin.name] for pin in CENTRE)
    return x, y, z


def _trunnion(given: Given, letter: str, direction: Vector) -> tuple[Turn, ...]:
    """Return the table C on the trunnion ``letter``."""
    value, (x, y, z) = given.values, _centre(given)
    sense = 1.0 if value["conventional-directions"] else -1.0
    shifted = (x + value.get("x-offset", 0.0), y + value.get("y-offset", 0.0), z + value["z-offset"])
    return Turn("C", "table", apply_sense(Z, sense), (x, y, z)), Turn(
        letter, "table", apply_sense(direction, sense), shifted
    )


def _dual_rotary(given: Given) -> tuple[Turn, ...]:
    """Return the table A on the axle B."""
    x, y, z = _centre(given)
    return Turn("A", "table", X, (x, y, z + given.values["z-offset"])), Turn("B", "table", Y, (x, y, z))


TABLES = (
    Kinematics(
        "xyzac-trt-kins", "XYZAC", "XYZAC", partial(_trunnion, letter="A", direction=X), spare="UVW",
        tool="tool-offset",
        pins=(*CENTRE, CONVENTIONAL, Pin("y-offset"), Pin("z-offset")), unused=("x-offset",),
    ),
    Kinematics(
        "xyzbc-trt-kins", "XYZBC", "XYZBC", partial(_trunnion, letter="B", direction=Y), spare="UVW",
        tool="tool-offset",
        pins=(*CENTRE, CONVENTIONAL, Pin("x-offset"), Pin("z-offset")), unused=("y-offset",),
    ),
    Kinematics(
        "xyzab_tdr_kins", "XYZAB", "XYZAB", _dual_rotary, tool="tool-offset-z",
        pins=(*CENTRE, Pin("z-offset")), fixed=True,
    ),
)  # fmt: skip
