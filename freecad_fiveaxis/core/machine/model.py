# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine: an ordered list of axes from the work to the tool.

side      a table axis carries the work, a head axis the tool.
joint     where an axis stands: mm or rad from its zero. With all joints zero the spindle's gauge point stands
          at ``gauge_point``, and the ``point`` of each rotary axis is where its line runs then.
word      what the controller is told: mm for linear axes, degrees for rotary ones (radians inside the core).
          A rotary word is the joint; a linear word is counted from the work zero to the tip.
sign      ISO 841: a positive word moves the **tool relative to the work** along, or right-handed about,
          ``direction``. A machine of the other habit has the reversed direction.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.sentences import Angle, Length, Number, Point, measure, say

from .bodies import MachineBody, check_carriers
from .no_motion import check_names
from .safe_start import SafeStart

Vector = tuple[float, float, float]

LINEAR_LETTERS = ("X", "Y", "Z")
ROTARY_LETTERS = ("A", "B", "C")
WRAPS = ("unwound", "modulo", "rezero")

UNIT_ROUNDING = 4.0 * sys.float_info.epsilon
"""A direction whose length is that near 1 is kept as given: dividing it again would only stir its last
digits."""

SHORTEST_DIRECTION = 1e-6
"""A direction shorter than this is taken for a forgotten one, as FreeCAD's Machine editor does."""


STAND_INS = ("-", "_")
"""Letters of the rotary axes that a machine of three or four axes has not: no controller knows them."""
OUT_OF_REACH = 1e-4
"""A tool axis that leans by less than this (rad) where a machine has no rotary axis is what CL files print
with four decimals."""

FARTHEST = 1e6
"""No point of a machine lies farther from its zero, mm: a kilometre. Beyond it a file has the wrong unit or a
slip."""


@dataclass(frozen=True)
class Axis:
    """One axis. ``direction`` is made unit; ``point`` a point of the axis with all joints zero, machine
    frame, mm.

    ``low`` and ``high`` in mm or rad, of the joint (for a rotary axis that is its word), infinite where there
    is no limit; ``max_rate`` mm/min or rad/min. ``wrap``: how the controller takes a rotary word: ``unwound``
    (absolute, any number of turns), ``modulo`` or ``rezero``. ``max_acceleration`` mm/s^2 or rad/s^2,
    infinite where it is not known: nothing reckons with it. Raises MachineError for values that no axis can
    have.
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
    max_acceleration: float = math.inf

    @property
    def fitted(self) -> bool:
        """False for the stand-in of a rotary axis that the machine has not: its word is always 0, and never
        written."""
        return self.letter not in STAND_INS

    def __post_init__(self) -> None:
        letters = STAND_INS if not self.fitted else ROTARY_LETTERS if self.rotary else LINEAR_LETTERS
        kind = say("rotary") if self.rotary else say("linear")
        self._need(
            self.letter in letters,
            say("a {kind} axis is called one of {letters}", kind=kind, letters=" ".join(letters)),
            self.letter,
        )
        self._need(
            self.side in ("table", "head"),
            say("side {side} is neither table nor head", side=repr(self.side)),
            self.side,
        )
        object.__setattr__(self, "direction", self._unit())
        object.__setattr__(
            self,
            "point",
            finite_vector(self.point, say("axis {letter}: joint origin", letter=self.letter), FARTHEST),
        )
        low, high, unit = (
            (math.degrees(self.low), math.degrees(self.high), "deg")
            if self.rotary
            else (self.low, self.high, "mm")
        )
        self._need(
            low < high,
            say(
                "limits min {low} is not below max {high}; swap or widen them",
                low=measure(low, unit),
                high=measure(high, unit),
            ),
            self.low,
        )
        self._need(
            self.max_rate > 0,
            say(
                "maximum rate {max_rate} is not positive; give what the drive reaches",
                max_rate=Number(self.max_rate),
            ),
            self.max_rate,
        )
        self._need(
            self.max_acceleration > 0,
            say(
                "maximum acceleration {max_acceleration} is not positive; give what the drive reaches",
                max_acceleration=Number(self.max_acceleration),
            ),
            self.max_acceleration,
        )
        self._need(
            self.wrap in WRAPS,
            say("wrap_strategy {wrap} is none of {wraps}", wrap=repr(self.wrap), wraps=", ".join(WRAPS)),
            self.wrap,
        )

    def _need(self, good: bool, problem: str, value: object) -> None:
        if not good:
            raise MachineError(say("axis {letter}: {problem}", letter=self.letter, problem=problem), value)

    def _unit(self) -> Vector:
        x, y, z = finite_vector(self.direction, say("axis {letter}: joint axis", letter=self.letter))
        length = math.hypot(x, y, z)
        self._need(
            length > SHORTEST_DIRECTION,
            say(
                "joint axis {place} has no direction; give a unit vector",
                place=Point((x, y, z), "g", bare=True),
            ),
            (x, y, z),
        )
        return (x, y, z) if abs(length - 1.0) <= UNIT_ROUNDING else (x / length, y / length, z / length)


@dataclass(frozen=True)
class Machine:
    """``axes`` from work to tool, the table's before the head's: X, Y, Z and up to two rotary. Where there
    are fewer, stand-ins that never turn follow (:attr:`Axis.fitted`): records have five columns.
    ``gauge_point`` mm, machine frame.

    ``singular_cone`` rad: half angle about the first rotary axis within which a block counts as near the
    pole. ``origin``: where the work zero stands unless the setup says otherwise, machine frame, mm.
    ``controller``: name of the dialect that the machine speaks unless the settings say otherwise, or empty.
    ``safe_start``: how its programs begin and end. ``rapids``: how its controller drives the axes in a rapid,
    one of :data:`~.base.rapids.RAPIDS`, or empty: as its dialect says. ``table`` mm: height of the table's
    face in the machine frame, all joints zero; None where it is not known. ``no_motion``: its control's
    functions that move nothing (:mod:`.no_motion`). ``bodies``: what the tool must not hit, and what carries
    it. Raises MachineError for axes that do not make a machine of three to five axes, and for such a function
    that moves. ``output_inch``: its programs are in inches unless the settings say otherwise.
    """

    name: str
    axes: tuple[Axis, ...]
    gauge_point: Vector = (0.0, 0.0, 0.0)
    origin: Vector = (0.0, 0.0, 0.0)
    singular_cone: float = math.radians(5.0)
    description: str = ""
    controller: str = ""
    safe_start: SafeStart = SafeStart()
    table: float | None = None
    rapids: str = ""
    no_motion: tuple[str, ...] = ()
    bodies: tuple[MachineBody, ...] = ()
    output_inch: bool = False
    letters: str = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "axes", with_stand_ins(self.name, tuple(self.axes)))
        object.__setattr__(self, "letters", "".join(axis.letter for axis in self.axes))
        object.__setattr__(self, "no_motion", check_names(self.no_motion))
        for name in ("gauge_point", "origin"):
            object.__setattr__(self, name, finite_vector(getattr(self, name), name, FARTHEST))
        if self.table is not None and not abs(self.table) <= FARTHEST:
            raise MachineError(
                say(
                    "machine {name}: table {table} is beyond {farthest}",
                    name=self.name,
                    table=Length(self.table),
                    farthest=Number(FARTHEST),
                ),
                self.table,
            )
        self._check_axes()
        check_carriers(self.bodies, [axis.letter for axis in self.fitted])
        if not 0.0 <= self.singular_cone <= math.pi / 2:
            cone = math.degrees(self.singular_cone)
            raise MachineError(
                say(
                    "machine {name}: singular_cone {cone} is not between 0 and 90",
                    name=self.name,
                    cone=Angle(cone),
                ),
                cone,
            )

    def _check_axes(self) -> None:
        kinds = [axis.rotary for axis in self.axes]
        if kinds.count(True) > 2 or kinds.count(False) != 3:
            count = f"{kinds.count(False)} linear and {kinds.count(True)} rotary axes"
            raise MachineError(
                say("machine {name} has {count}; needs 3 and at most 2", name=self.name, count=count),
                self.letters,
            )
        if len(set(self.letters)) != len(self.letters):
            raise MachineError(
                say(
                    "machine {name} has two axes of the same letter: {letters}",
                    name=self.name,
                    letters=self.letters,
                ),
                self.letters,
            )
        sides = [axis.side for axis in self.axes]
        if sides != sorted(sides, reverse=True):
            raise MachineError(
                say(
                    "machine {name}: {letters} does not name the table's axes before the head's",
                    name=self.name,
                    letters=self.letters,
                ),
                self.letters,
            )

    @property
    def rotary(self) -> tuple[Axis, Axis]:
        """The two rotary axes, the one nearer to the work first; stand-ins last."""
        first, second = (axis for axis in self.axes if axis.rotary)
        return first, second

    @property
    def fitted(self) -> tuple[Axis, ...]:
        """The axes that the machine really has."""
        return tuple(axis for axis in self.axes if axis.fitted)

    @property
    def rotaries(self) -> int:
        """How many rotary axes the machine really has."""
        return sum(axis.rotary for axis in self.fitted)

    @property
    def linear(self) -> tuple[Axis, Axis, Axis]:
        """The three linear axes in the chain's order."""
        a, b, c = (axis for axis in self.axes if not axis.rotary)
        return a, b, c

    @property
    def has_head(self) -> bool:
        """True where a rotary axis carries the tool: then the tool length enters the words."""
        return any(axis.rotary and axis.fitted and axis.side == "head" for axis in self.axes)


def find_physical_columns(letters: str) -> list[int]:
    """Return the columns of the words whose axes the machine really has, by the letters of all ("XYZA-": 0 1
    2 3)."""
    return [column for column, letter in enumerate(letters) if letter not in STAND_INS]


def with_stand_ins(name: str, axes: tuple[Axis, ...]) -> tuple[Axis, ...]:
    """Return the axes with stand-ins for the rotary ones that are missing, nearest to the tool, where they
    move nothing.

    Beside one axis stands one across it and the tool: no axis that the machine reaches is then near a pole.
    Raises MachineError where a single rotary axis is parallel to the tool.
    """
    rotary = [axis for axis in axes if axis.rotary]
    if not rotary:
        return (*axes, _stand_in(0, (1.0, 0.0, 0.0)), _stand_in(1, (0.0, 1.0, 0.0)))
    if len(rotary) > 1:
        return axes
    x, y, _ = rotary[0].direction
    if math.hypot(x, y) < SHORTEST_DIRECTION:
        text = say(
            "machine {name}: its only rotary axis {letter} is parallel to the tool and never tilts it; leave "
            "it out of the file",
            name=name,
            letter=rotary[0].letter,
        )
        raise MachineError(text, rotary[0].direction)
    return (*axes, _stand_in(0, (-y + 0.0, x, 0.0)))


def _stand_in(which: int, direction: Vector) -> Axis:
    return Axis(STAND_INS[which], True, "head", direction, low=-OUT_OF_REACH, high=OUT_OF_REACH)


def finite_vector(value: Sequence[float], what: str, most: float = sys.float_info.max) -> Vector:
    """Three finite numbers, none larger than ``most``, as a tuple of floats; else MachineError naming
    ``what``."""
    try:
        x, y, z = (float(component) for component in value)
    except (TypeError, ValueError, OverflowError):
        raise MachineError(say("{what} is not a vector of three numbers", what=what), value) from None
    if not all(math.isfinite(component) and abs(component) <= most for component in (x, y, z)):
        raise MachineError(
            say(
                "{what} {place} is not finite or beyond {most}",
                what=what,
                place=Point((x, y, z), "g", bare=True),
                most=Number(most),
            ),
            value,
        )
    return x, y, z
