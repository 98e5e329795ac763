# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a point of the tool really goes in the blocks of a program, and the largest value that something
takes on the way.

driven    the point that is followed: on the tool axis, ``height`` mm above the tip (0: the tip, the radius:
          the ball's centre).
bend      a bound of the second derivative of the driven point by u, mm. Between two samples, h of the block
          apart, the point is then within ``bend h^2 / 8`` of the straight line between them, and travels at
          most ``|chord| + bend h^2 / 2``.
guided    where the controller guides the tip, the driven point is taken to go straight: how it does is the
          controller's affair.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.columns import cache_chunks
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.deviation.bound import bending, quick_levers
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.motion.trajectory import axis_at, frames, motion, tip_at

MOST_HALVINGS = 14
"""Of a block: pieces of a sixteen-thousandth. What is then not proven keeps its bound, and the report shows
it."""
FAR = 1e-3
"""Relative error that does not matter of what is far beyond the tolerance."""
MOST_OPEN = 2_000_000
"""Pieces that are looked at in one round: bounds the memory; where there are more, the rest keep their
bounds."""


@dataclass(frozen=True, eq=False)
class RealPath:
    """The driven point of all blocks of ``program``."""

    kinematics: Chain
    program: Program
    height: float = 0.0

    def places(self, row: Ints, u: Floats) -> Floats:
        """Return the driven point (n, 3) mm, work frame, at ``u`` (n,) of the blocks ``row`` (n,)."""
        place = np.empty((len(row), 3))
        for part in cache_chunks(len(row)):
            place[part] = self._places(row[part], u[part])
        return place

    def _places(self, row: Ints, u: Floats) -> Floats:
        real = self._place_driven_point(row, u)
        if self.program.guided is None or not (on := self.program.guided.on[row]).any():
            return real
        start, end = (
            self._place_driven_point(row, np.zeros(len(row))),
            self._place_driven_point(row, np.ones(len(row))),
        )
        return np.where(on[:, None], start + u[:, None] * (end - start), real)

    def _place_driven_point(self, row: Ints, u: Floats) -> Floats:
        words = self.program.words
        start, end = words[np.maximum(row - 1, 0)], words[row]
        tip = tip_at(self.kinematics, start, end, u)
        return tip + self.height * axis_at(self.kinematics, start, end, u) if self.height else tip

    def bend(self, row: Ints) -> Floats:
        """Return a bound (n,) mm of the driven point's second derivative by u in the blocks ``row`` (n,)."""
        bent, words, frame = np.empty(len(row)), self.program.words, frames(self.kinematics)
        for part in cache_chunks(len(row)):
            move = motion(frame, words[row[part] - 1], words[row[part]])
            levers = quick_levers(move)
            bent[part] = bending(levers, 2) + self.height * levers.turn**2
        return bent if self.program.guided is None else np.where(self.program.guided.on[row], 0.0, bent)


@dataclass(frozen=True, eq=False)
class Ends:
    """Pieces of blocks by their two ends: ``block`` (n,) counts the blocks asked for; ``u`` (2, n); ``place``
    (2, n, 3) mm; ``value`` (2, n, w): what is measured there; ``bend`` (n,) mm of the piece itself (bend of
    the block times h^2)."""

    block: Ints
    u: Floats
    place: Floats
    value: Floats
    bend: Floats

    def take(self, rows: Any) -> Ends:
        """Return some of the pieces."""
        return Ends(
            self.block[rows], self.u[:, rows], self.place[:, rows], self.value[:, rows], self.bend[rows]
        )

    @property
    def travel(self) -> Floats:
        """A bound (n,) mm of the way between the ends."""
        return np.asarray(self.chord + 0.5 * self.bend)

    @property
    def chord(self) -> Floats:
        """The distance (n,) mm of the ends."""
        return np.asarray(np.linalg.norm(self.place[1] - self.place[0], axis=1))


@dataclass(frozen=True, eq=False)
class Peaks:
    """One row a block asked for: ``value`` (n,) the largest found, at ``u`` (n,) and ``place`` (n, 3) mm;
    ``bound`` (n,) what it cannot exceed."""

    value: Floats
    u: Floats
    place: Floats
    bound: Floats


Measured = Callable[[Floats], Floats]
"""What is measured at places (n, 3): (n, w), the value that is to be largest in column 0."""


def peaks(
    path: RealPath,
    rows: Ints,
    measured: Measured,
    upper: Callable[[Ends], Floats],
    tolerance: float,
    progress: Progress = silent,
) -> Peaks:
    """Return the largest value in each of the blocks ``rows`` (n,), none of them row 0.

    ``upper`` (n,) bounds the value between the ends of pieces. Pieces are halved until their bound exceeds
    neither the largest value found in their block nor ``tolerance`` by more than a tenth of the latter (or a
    thousandth of the former).
    """
    ends = _whole_blocks(path, rows, measured)
    best = Peaks(
        np.full(len(rows), -np.inf),
        np.zeros(len(rows)),
        np.zeros((len(rows), 3)),
        np.full(len(rows), -np.inf),
    )
    for side in (0, 1):
        _raise(best, ends.block, ends.u[side], ends.place[side], ends.value[side, :, 0])
    for turn in range(MOST_HALVINGS + 1):
        progress("between the blocks' ends", turn / MOST_HALVINGS)
        bound = upper(ends)
        found = best.value[ends.block]
        wide = bound > np.maximum(found, tolerance) + np.maximum(0.1 * tolerance, FAR * found)
        wide &= (turn < MOST_HALVINGS) & (np.cumsum(wide) <= MOST_OPEN)
        np.maximum.at(best.bound, ends.block[~wide], bound[~wide])
        ends = _halves(path, rows, ends.take(wide), measured, best)
        if not len(ends.block):
            break
    return replace(best, bound=np.maximum(best.bound, best.value))


def _whole_blocks(path: RealPath, rows: Ints, measured: Measured) -> Ends:
    """Return the blocks as pieces. An end that begins the next block is measured once."""
    both = np.unique(np.concatenate([rows - 1, rows]))
    place = path.places(both, np.ones(len(both)))
    value, at = measured(place), np.stack([np.searchsorted(both, rows - 1), np.searchsorted(both, rows)])
    u = np.stack([np.zeros(len(rows)), np.ones(len(rows))])
    return Ends(np.arange(len(rows)), u, place[at], value[at], path.bend(rows))


def _halves(path: RealPath, rows: Ints, ends: Ends, measured: Measured, best: Peaks) -> Ends:
    """Both halves of the pieces; ``best`` is raised by what is found between."""
    if not len(ends.block):
        return ends
    u = ends.u.mean(axis=0)
    place = path.places(rows[ends.block], u)
    value = measured(place)
    _raise(best, ends.block, u, place, value[:, 0])

    def halves(ends_of: Floats, middle: Floats) -> Floats:
        return np.stack([np.concatenate([ends_of[0], middle]), np.concatenate([middle, ends_of[1]])])

    columns = halves(ends.u, u), halves(ends.place, place), halves(ends.value, value)
    return Ends(np.tile(ends.block, 2), *columns, np.tile(ends.bend / 4.0, 2))


def _raise(best: Peaks, block: Ints, u: Floats, place: Floats, value: Floats) -> None:
    """Put in what is larger than before; of several pieces of one block the largest counts."""
    order = np.argsort(value, kind="stable")
    larger = order[value[order] > best.value[block[order]]]
    at = block[larger]  # numpy keeps the last of equal indices: the largest
    best.value[at], best.u[at], best.place[at] = value[larger], u[larger], place[larger]
