# SPDX-License-Identifier: LGPL-2.1-or-later
"""How programs begin and end on a machine: where the tool is before the rotary axes turn.

machine    Z goes to a machine coordinate, as ``G53 Z-1``.
reference  Z goes to its reference point, as ``G28 G91 Z0``.
clearance  Z goes to a plane above the part, wherever the rotary axes stand and turn: in work coordinates.
none       the first block drives all five axes from wherever they stand.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.sentences import Length, say

BY_MACHINE, BY_REFERENCE, BY_CLEARANCE, BY_NOTHING = "machine", "reference", "clearance", "none"
RETRACTS = (BY_MACHINE, BY_REFERENCE, BY_CLEARANCE, BY_NOTHING)


@dataclass(frozen=True)
class SafeStart:
    """``retract``: one of RETRACTS; ``z`` mm: the machine coordinate of ``machine``, None for the others.
    Raises MachineError."""

    retract: str = BY_CLEARANCE
    z: float | None = None

    def __post_init__(self) -> None:
        if self.retract not in RETRACTS:
            raise MachineError(
                say(
                    "retract {retract} is none of {retracts}",
                    retract=repr(self.retract),
                    retracts=", ".join(RETRACTS),
                ),
                self.retract,
            )
        if (self.z is None) == (self.retract == BY_MACHINE):
            remedy = say("give Z, a machine coordinate") if self.z is None else say("leave Z out")
            raise MachineError(
                say("retract {retract}: {remedy}", retract=self.retract, remedy=remedy), self.z
            )
        if self.z is not None and not math.isfinite(self.z):
            raise MachineError(
                say("retract Z {z} is not finite; give a machine coordinate", z=Length(self.z, bare=True)),
                self.z,
            )
