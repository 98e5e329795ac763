# SPDX-License-Identifier: LGPL-2.1-or-later
"""Setups and the map of what each of them costs.

setup     where the work zero stands in the machine frame (mm), and how the part is turned there.
turn      the part turned counter-clockwise about Z through the work zero (rad). The work frame stays parallel
          to the machine's, so the path's tips and axes turn with the part.
region    the box of work zeros that are thinkable, the grid laid over it, and the turns that are tried.
map       one row a setup: the present one first, then the grid, then the places that the search found.
stands    whether the part's lowest place is not below the face of the table; everywhere where nobody says how
          high that is.
over      how far (mm) the linear axes would have to go beyond their limits, 0 within them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import IntEnum
from typing import TYPE_CHECKING

import numpy as np

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.machine import Vector
from freecad_fiveaxis.core.machine.kinematics import Setup

if TYPE_CHECKING:
    from .jaws import Clamping
    from .stick_out import StickOut

MOST_SETUPS = 20_000
"""Setups of one map: each is a program of its own that is posted and measured."""
FARTHEST = 1e5
"""mm; a work zero farther off than this is a slip of the pen."""
ALIKE = 1e-9
"""rad; turns that differ by less are alike, to one side and to the other."""

AS_GOOD = 1.01
"""Deviations that differ by no more than a hundredth are one to anybody who clamps a part by hand."""
WORD_STEP = 1e-4
"""mm; nor do differences of one step of a word with four decimals count."""


class Kind(IntEnum):
    """Why a setup is in the map."""

    PRESENT = 0
    GRID = 1
    FOUND = 2


@dataclass(frozen=True)
class Region:
    """``low``, ``high`` mm: corners of the box of work zeros, machine frame; ``count`` grid places along X,
    Y, Z (1: the middle only); ``turns`` rad. Raises SettingsError for a box turned inside out, a count below
    1, or too many setups."""

    low: Vector
    high: Vector
    count: tuple[int, int, int] = (9, 9, 1)
    turns: tuple[float, ...] = (0.0,)

    def __post_init__(self) -> None:
        numbers = (*self.low, *self.high, *self.turns)
        if not all(math.isfinite(number) and abs(number) <= FARTHEST for number in numbers):
            raise SettingsError(
                say(
                    "setup region {low} to {high} is not finite or beyond {farthest}",
                    low=self.low,
                    high=self.high,
                    farthest=Length(FARTHEST),
                ),
                numbers,
            )
        if any(low > high for low, high in zip(self.low, self.high, strict=True)):
            raise SettingsError(
                say(
                    "setup region {low} to {high}: the low corner is above the high; swap them",
                    low=self.low,
                    high=self.high,
                ),
                self.low,
            )
        if min(self.count) < 1 or not self.turns:
            raise SettingsError(
                say(
                    "setup grid {count} with {turns} turns has no place; give at least 1",
                    count=self.count,
                    turns=len(self.turns),
                ),
                self.count,
            )
        if self.size > MOST_SETUPS:
            raise SettingsError(
                say(
                    "{size} setups are more than {most}; take a coarser grid or fewer turns",
                    size=self.size,
                    most=MOST_SETUPS,
                ),
                self.size,
            )

    @property
    def size(self) -> int:
        """Setups of the grid, all turns together."""
        return math.prod(self.count) * len(self.turns)

    def lines(self) -> tuple[Floats, Floats, Floats]:
        """Return the coordinates of the grid along X, Y and Z, mm."""
        x, y, z = (
            np.linspace(low, high, count) if count > 1 else np.array([0.5 * (low + high)])
            for low, high, count in zip(self.low, self.high, self.count, strict=True)
        )
        return x, y, z

    def holds(self, origin: Floats) -> Bools:
        """Tell which work zeros (k, 3) mm lie in the region."""
        return np.asarray(((origin >= self.low) & (origin <= self.high)).all(axis=1))

    def grid(self) -> Floats:
        """Return the grid's work zeros (k, 3) mm, X fastest, then Y."""
        z, y, x = np.meshgrid(*reversed(self.lines()), indexing="ij")
        return np.column_stack([x.ravel(), y.ravel(), z.ravel()])


@dataclass(frozen=True, eq=False)
class SetupMap:
    """One row a setup: row 0 the present one; then the grid, turn after turn, each as ``region.grid()``; then
    what was found.

    ``origin`` (k, 3) mm and ``turn`` (k,) rad; ``max_deviation`` (k,) mm: of the feed blocks of the
    program that is posted in this setup, as rounded, of the point ``above`` mm over the driven one;
    ``rotary_travel`` (k,) rad and ``time`` (k,) s of the whole program; ``over`` (k,) mm,
    ``within_limits`` and ``stands`` (k,); ``rewinds`` (k,) retracts to turn back; ``kind`` (k,) of
    :class:`Kind`. Where the rotary limits allow no way at a turn, its rows are NaN and not within limits.
    ``best``: the recommended row, None where none is within limits and stands. ``least`` mm: no work zero
    of the region that stands, at the turns tried, has less deviation (but for rounding of words).
    ``table`` mm: height of the table's face, machine frame, None where it is not known; ``bottom`` mm:
    the part's lowest place over the work zero. ``hits`` (k,) mm: at least so deep tool or spindle go into
    the machine, 0 where they hit nothing, NaN where nobody knows (no bodies, or no need to look).
    ``stick_out``: the shortest of the tool that is free in the recommended setup, and ``clamping``: what
    is hit of the fixtures there, and how high jaws may reach; None: nobody has looked. ``least_hit``:
    where all that were tried hit the machine the row in which that is least; None: not all. ``enough`` mm: a
    deviation that needs no improvement.
    """

    machine: str
    base: Setup
    region: Region
    origin: Floats
    turn: Floats
    max_deviation: Floats
    rotary_travel: Floats
    time: Floats
    over: Floats
    within_limits: Bools
    stands: Bools
    rewinds: Ints
    kind: Bytes
    best: int | None
    least: float
    table: float | None
    bottom: float
    hits: Floats
    findings: tuple[Finding, ...] = ()
    stick_out: StickOut | None = None
    clamping: Clamping | None = None
    least_hit: int | None = None
    above: float = 0.0
    enough: float = 0.0

    def __post_init__(self) -> None:
        freeze(
            self, None, origin="f3", turn="f", max_deviation="f", rotary_travel="f", time="f", over="f",
            within_limits="b",
            stands="b", rewinds="i", kind="m", hits="f",
        )  # fmt: skip

    @property
    def able(self) -> Bools:
        """The setups (k,) that are within limits and stand, and in which nothing is known to be hit."""
        return self.within_limits & self.stands & ~(self.hits > 0.0)

    @property
    def level(self) -> float:
        """The deviation, mm, up to which setups of the region are as good as its best; NaN where it has
        none."""
        able = self.max_deviation[self.able & self.region.holds(self.origin)]
        able = able[np.isfinite(able)]
        return as_good_as(float(able.min()), self.enough) if len(able) else math.nan

    def grid(self, column: Floats | Bools) -> Floats:
        """Return the grid's part of a column, (turns, z, y, x)."""
        nx, ny, nz = self.region.count
        rows = np.asarray(column[self.kind == Kind.GRID], float)
        return rows.reshape(len(self.region.turns), nz, ny, nx)


def recommend_setup(
    origin: Floats, base: Vector, deviation: Floats, time: Floats, rewinds: Ints, within: Bools,
    enough: float, turn: Floats | float = 0.0,
) -> int | None:  # fmt: skip
    """Return the row to take, None where none is within limits.

    Of those with hardly more than the least deviation, or with less than is ``enough`` (mm): the fewest
    rewinds, then the shortest time (to 1 %), then the part turned least, then the least way from ``base``.
    Columns (k,), ``turn`` in rad, ``origin`` (k, 3).
    """
    rows = np.flatnonzero(within & np.isfinite(deviation))
    if not len(rows):
        return None
    rows = rows[deviation[rows] <= as_good_as(float(deviation[rows].min()), enough)]
    rows = rows[rewinds[rows] == rewinds[rows].min()]
    rows = rows[time[rows] <= AS_GOOD * time[rows].min()]
    turned = np.abs(np.angle(np.exp(1j * np.broadcast_to(turn, len(origin)))))[rows]
    rows = rows[turned <= turned.min() + ALIKE]
    return int(rows[np.linalg.norm(origin[rows] - np.array(base), axis=1).argmin()])


def as_good_as(deviation: float, enough: float) -> float:
    """Return the deviation up to which a setup is as good as one of ``deviation``, mm."""
    return max(enough, AS_GOOD * deviation + WORD_STEP)
