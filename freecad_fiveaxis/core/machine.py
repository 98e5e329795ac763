# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine: an ordered list of axes from the work to the tool.

side      a table axis carries the work, a head axis the tool.
word      what the controller is told: mm for linear axes, degrees for rotary ones (radians inside the core).
sign      ISO 841: a positive word moves the **tool relative to the work** along, or right-handed about, ``direction``.
          A machine of the other habit has the reversed direction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal

from .errors import MachineError

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Axis:
    """One axis. ``direction`` unit; ``point`` a point of the axis with all joints zero, machine frame, mm.

    ``low`` and ``high`` in mm or rad, of the joint (for a rotary axis that is its word); ``max_rate`` mm/min or rad/min.
    ``wrap``: how the controller takes a rotary word: ``unwound`` (absolute, any number of turns), ``modulo`` or ``rezero``.
    """

    letter: str
    rotary: bool
    side: Literal["table", "head"]
    direction: Vector
    point: Vector = (0.0, 0.0, 0.0)
    low: float = -math.inf
    high: float = math.inf
    max_rate: float = math.inf
    wrap: str = "unwound"


@dataclass(frozen=True)
class Machine:
    """``axes`` ordered from work to tool: three linear and two rotary. ``gauge_point`` mm, machine frame.

    ``singular_cone`` rad: half angle about the first rotary axis within which a block counts as near the pole.
    ``origin``: where the work zero stands unless the setup says otherwise, machine frame, mm.
    """

    name: str
    axes: tuple[Axis, ...]
    gauge_point: Vector = (0.0, 0.0, 0.0)
    origin: Vector = (0.0, 0.0, 0.0)
    singular_cone: float = math.radians(5.0)
    description: str = ""
    letters: str = field(init=False)

    def __post_init__(self) -> None:
        kinds = [axis.rotary for axis in self.axes]
        if kinds.count(True) != 2 or kinds.count(False) != 3:
            raise MachineError(f"machine {self.name} has {kinds.count(False)} linear and {kinds.count(True)} rotary axes; needs 3 and 2", self.name)
        object.__setattr__(self, "letters", "".join(axis.letter for axis in self.axes))

    @property
    def rotary(self) -> tuple[Axis, Axis]:
        """The two rotary axes, the one nearer to the work first."""
        first, second = (axis for axis in self.axes if axis.rotary)
        return first, second

    @property
    def linear(self) -> tuple[Axis, Axis, Axis]:
        """The three linear axes in the chain's order."""
        a, b, c = (axis for axis in self.axes if not axis.rotary)
        return a, b, c

    @property
    def has_head(self) -> bool:
        """True where a rotary axis carries the tool: then the tool length enters the words."""
        return any(axis.rotary and axis.side == "head" for axis in self.axes)
