# SPDX-License-Identifier: LGPL-2.1-or-later
"""The best work zero at one turn: a convex problem, solved with a proof.

Let p be the real tip at share u of a block. Its place over the part is affine in the work zero o: the rotary
words do not depend on o, the linear words and both rotary lines shift evenly with it. The block's chord does
not depend on o at all. A distance from a fixed convex set is convex, a convex function of an affine one is
convex, and a maximum of convex functions is convex:

    the largest deviation of a program is a convex function of the work zero (words not rounded),

and so is the excess over each linear limit. There is one valley: no start can be wrong, and a minimum can be
proven.

cut     at a block that was measured at o, with x the vector from the chord to the point at its worst u: for
        **every** o' the largest deviation is at least ``|x| + x/|x| . (p(o') - p(o))``, a plane under the
        valley (Kelley 1960, J. SIAM 8). For a limit: the excess of a row is itself a plane.
least   the lowest place above all planes, by linear programming: no work zero of the region can be better
        than this.
level   what is as good as the best found. In the end the work zero nearest to the present one that keeps the
        level is taken: where a direction does not matter (Z of a head-table machine, all of a head-head
        machine) the part stays where it is.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
import scipy

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.joint_path.plan import LINEAR_SLACK
from freecad_fiveaxis.core.motion.trajectory import tip_at

from .driven import Driven, worst_blocks
from .setups import Region, as_good_as

ROUNDS = 40
"""Work zeros measured in search of the least deviation; a dozen are usual."""
NEARER = 6
"""And in search of the nearest one to the present that is as good."""
HALVINGS = 7
"""Of the way to the nearest one where that is not found: a hundredth of it is left."""
BLOCKS = 16
"""Blocks that give a cut in each round."""
SHIFT = 64.0
"""mm between the work zeros whose difference gives a slope: what is affine has the same slope at any."""


@dataclass(frozen=True, eq=False)
class Found:
    """``origin`` (3,) mm of the best work zero, None where the limits leave none; ``least`` mm: none of the
    region is better; ``over`` mm: with no work zero within limits, by how much they are exceeded at least."""

    origin: Floats | None
    least: float
    over: float = 0.0


@dataclass(eq=False)
class _Planes:
    """Planes ``value + slope . (o - at)`` under the valley: ``low`` of the deviation, ``bar`` of the limits
    (mm)."""

    low: list[Floats] = field(default_factory=list)
    low_rest: list[Floats] = field(default_factory=list)
    bar: list[Floats] = field(default_factory=list)
    bar_rest: list[Floats] = field(default_factory=list)

    def add(self, value: Floats, slope: Floats, at: Floats, limit: bool) -> None:
        """``value`` (k,), ``slope`` (k, 3) of planes through the work zero ``at`` (3,)."""
        slopes, rests = (self.bar, self.bar_rest) if limit else (self.low, self.low_rest)
        slopes.append(slope)
        rests.append(value - slope @ at)

    def lowest(self, region: Region) -> tuple[Floats, float] | None:
        """Return the work zero of the least deviation that the planes allow, and that deviation; None where
        the limits allow none."""
        low = np.concatenate(self.low)
        rows = np.concatenate(
            [np.column_stack([low, -np.ones(len(low))]), *(_wide(slope, 0.0) for slope in self.bar)]
        )
        right = np.concatenate(
            [-np.concatenate(self.low_rest), *(LINEAR_SLACK - rest for rest in self.bar_rest)]
        )
        solved = scipy.optimize.linprog(
            (0.0, 0.0, 0.0, 1.0), rows, right, bounds=[*_box(region), (0.0, None)], method="highs"
        )
        return (np.array(solved.x[:3]), float(solved.x[3])) if solved.status == 0 else None

    def nearest(self, region: Region, to: Floats, level: float) -> Floats | None:
        """Return the work zero nearest to ``to`` (sum of the shifts) at which the planes allow a deviation of
        no more than ``level``."""
        slopes = [np.column_stack([slope, np.zeros((len(slope), 3))]) for slope in (*self.low, *self.bar)]
        eye = np.eye(3)
        rows = np.concatenate([*slopes, np.hstack([eye, -eye]), np.hstack([-eye, -eye])])
        right = [
            *(level - rest for rest in self.low_rest),
            *(LINEAR_SLACK - rest for rest in self.bar_rest),
            to,
            -to,
        ]
        bounds = [*_box(region), *[(0.0, None)] * 3]
        solved = scipy.optimize.linprog(
            (0.0, 0.0, 0.0, 1.0, 1.0, 1.0), rows, np.concatenate(right), bounds=bounds, method="highs"
        )
        return np.array(solved.x[:3]) if solved.status == 0 else None

    def least_over(self, region: Region) -> float:
        """Return the least excess over the limits (mm) that any work zero of the region has, as far as the
        planes tell."""
        rows = np.concatenate([_wide(slope, -1.0) for slope in self.bar])
        right = -np.concatenate(self.bar_rest)
        solved = scipy.optimize.linprog(
            (0.0, 0.0, 0.0, 1.0), rows, right, bounds=[*_box(region), (0.0, None)], method="highs"
        )
        return float(solved.x[3]) if solved.status == 0 else math.nan


def _wide(slope: Floats, last: float) -> Floats:
    return np.column_stack([slope, np.full(len(slope), last)])


def _box(region: Region) -> list[tuple[float, float]]:
    return list(zip(region.low, region.high, strict=True))


def best_origin(
    driven: Driven, region: Region, present: Floats, enough: float, progress: Progress = silent
) -> Found:
    """Return the work zero of least deviation within limits, and of those as good the nearest to ``present``
    (3,) mm.

    ``enough`` mm: a deviation that needs no improvement.
    """
    planes, middle = _Planes(), 0.5 * (np.array(region.low) + np.array(region.high))
    at, best, value, least = middle, None, math.inf, 0.0
    for round_ in range(ROUNDS):
        progress("setup map", round_ / ROUNDS)
        deviation, over = _measure_at(driven, at, planes)
        if over <= LINEAR_SLACK and deviation < value:
            best, value = at, deviation
        lowest = planes.lowest(region)
        if lowest is None:
            return Found(None, math.nan, planes.least_over(region))
        at, least = lowest
        if value <= as_good_as(least, enough):
            break
    if best is None:
        return Found(None, least, planes.least_over(region))
    return Found(_nearer(driven, region, present, planes, best, as_good_as(value, enough), progress), least)


def _nearer(
    driven: Driven, region: Region, present: Floats, planes: _Planes, best: Floats, level: float,
    progress: Progress
) -> Floats:  # fmt: skip
    """Return the nearest to ``present`` that keeps ``level``, or a place on the way there from ``best``.

    What keeps the level is a convex set: halving the way from a place inside to one outside ends at its
    border.
    """
    outside = present
    for _ in range(NEARER):
        progress("setup map", 1.0)
        at = planes.nearest(region, present, level)
        if at is None:
            return best
        if _keeps(driven, at, planes, level):
            return at
        outside = at
    for _ in range(HALVINGS):
        progress("setup map", 1.0)
        middle = 0.5 * (best + outside)
        if _keeps(driven, middle, planes, level):
            best = middle
        else:
            outside = middle
    return best


def _keeps(driven: Driven, at: Floats, planes: _Planes, level: float) -> bool:
    deviation, over = _measure_at(driven, at, planes)
    return deviation <= level and over <= LINEAR_SLACK


def _measure_at(driven: Driven, origin: Floats, planes: _Planes) -> tuple[float, float]:
    """Deviation and excess over limits at one work zero, mm, of words before rounding; its planes are put to
    the others."""
    stations = [driven.kinematics(origin), *(driven.kinematics(origin + SHIFT * way) for way in np.eye(3))]
    words = driven.words(stations[0])
    worst = worst_blocks(*driven.raise_to_surface(stations[0], words), driven.feeds, BLOCKS)
    rows, u = worst.row[:BLOCKS], worst.u[:BLOCKS]
    tips = [_tips(driven, kinematics, rows, u) for kinematics in stations]
    start, end = (_tips(driven, stations[0], rows, np.full(len(rows), at)) for at in (0.0, 1.0))
    x = off_chord(start, end, tips[0])
    distance = np.linalg.norm(x, axis=1)
    toward = x / np.maximum(distance, np.finfo(float).tiny)[:, None]
    planes.add(distance, _slopes([(tip * toward).sum(axis=1) for tip in tips]), origin, limit=False)
    excess = [_excess(driven, kinematics, _extremes(words)) for kinematics in stations]
    known = np.isfinite(excess[0])
    planes.add(excess[0][known], _slopes([values[known] for values in excess]), origin, limit=True)
    return float(worst.segment.max(initial=0.0)), float(excess[0][known].max(initial=0.0))


def _slopes(values: list[Floats]) -> Floats:
    """Slopes (k, 3) of affine functions, from their values (k,) at a work zero and at three that are shifted
    along X, Y, Z."""
    return np.stack([(value - values[0]) / SHIFT for value in values[1:]], axis=1)


def _tips(driven: Driven, kinematics: Chain, rows: Ints, u: Floats) -> Floats:
    """Return where the point that makes the surface really is (k, 3) at ``u`` (k,) of the blocks that end in
    ``rows``."""
    raised, start = driven.raise_to_surface(kinematics, driven.words(kinematics, rows - 1))
    return tip_at(raised, start, driven.raise_to_surface(kinematics, driven.words(kinematics, rows))[1], u)


def off_chord(start: Floats, end: Floats, place: Floats) -> Floats:
    """Return the vectors (k, 3) to ``place`` from the nearest points of the chords from ``start`` to ``end``,
    all (k, 3) mm."""
    chord = end - start
    square = np.maximum((chord * chord).sum(axis=1), np.finfo(float).tiny)
    share = np.clip(((place - start) * chord).sum(axis=1) / square, 0.0, 1.0)
    return np.asarray(place - start - share[:, None] * chord)


def _extremes(words: Floats) -> Ints:
    """Return the rows (6,) of the largest X, Y, Z and of the least ones."""
    return np.concatenate([words[:, :3].argmax(axis=0), words[:, :3].argmin(axis=0)])


def _excess(driven: Driven, kinematics: Chain, rows: Ints) -> Floats:
    """How far (6,) mm these rows are beyond the linear limits, negative within them; infinite where there is
    no limit."""
    words, axis = driven.words(kinematics, rows), np.arange(3)
    return np.concatenate(
        [words[axis, axis] - kinematics.high[:3], kinematics.low[:3] - words[axis + 3, axis]]
    )
