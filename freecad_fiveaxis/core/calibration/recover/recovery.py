# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine that a post had in mind, from a CL path and the program that was made of it.

Every layout that explains the tool axes (:mod:`layouts`) is tried on the tips as table-table, head-table and
head-head, with and without a shifted linear zero; the plainest that explains the rows within their rounding
is taken, and fitted to all of them. What explains them as well is named.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import FARTHEST, Axis, Machine, Vector
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward_tip
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .fit import Fit, judge_fit, refine_fit, screen_guess
from .layouts import Guess, guesses, kinds, start_layout
from .matching import Sequences, align_pairs, in_order, realign_pairs, sequences
from .model import HEAD_HEAD, LINES, ROTARY_ZERO, TABLE_TABLE, Layout, across
from .pairs import AXIS_STEP, Pairs

TRIED, FITTED = 150, 20_000
"""Rows on which the layouts are tried, and rows that the last fit looks at, evenly spread over the
program."""
EQUAL = 3.0
"""Scales within this factor of each other, or of rounding, are no reason to prefer one layout."""
LEANING = 0.01
"""rad; tools that lean so far have joints other than their tips."""
PAIRED = 0.6
"""Where fewer of the rows fit, they are not paired rightly."""
ASSUMED_RATE, ASSUMED_TURN = 10_000.0, math.radians(3600.0)
"""mm/min, rad/min: what a machine file needs and rows do not tell."""


@dataclass(frozen=True, eq=False)
class Recovery:
    """``machine`` as written; ``fit`` of it; ``pairs`` it was fitted to; ``others``: fits of layouts that
    explain the rows as well; ``start``: the machine that was given, with ``start_miss`` mm: how far it leaves
    the tips, at most, in the good rows (infinite where its letters are others); ``setup`` for both machines;
    ``skipped``: blocks between the pairs without a row."""

    machine: Machine
    fit: Fit
    pairs: Pairs
    others: tuple[Fit, ...]
    start: Machine | None
    start_miss: float
    setup: Setup
    skipped: int
    findings: tuple[Finding, ...] = ()


def recover(
    path: CLPath, program: Program, start: Machine | None = None, setup: Setup | None = None,
    axis_step: float = AXIS_STEP,
    name: str = "recovered", progress: Progress = silent,
) -> Recovery:  # fmt: skip
    """Return the machine fitted to a path and its program; findings are left to :mod:`verdicts`.

    ``program.letters[3:]``: its two rotary letters, in any order. ``start``: a machine to compare with, whose
    limits, rates and undetermined coordinates are kept. ``setup``: where the work zero is to stand and the
    tool length, for the machine file. ``axis_step``: of the printed tool axes. Raises ProgramError for rows
    from which nothing can be learnt.
    """
    given, setup = sequences(path, program, axis_step), setup or Setup()
    progress("recover", 0.0)
    pairs = in_order(given)
    best = None if pairs is None else _best(pairs, start, setup)
    progress("recover", 0.4)
    if best is None or best[0].good.mean() < PAIRED:
        pairs, best = _align_and_fit(given, start, setup, best, pairs)
    assert pairs is not None  # _aligned has raised otherwise
    progress("recover", 0.8)
    base = base_points(best[0].layout, start, setup)
    sample = pairs.take(_spread(len(pairs.row), FITTED))
    rough = best[0]
    fit = refine_fit(judge_fit(rough.layout, rough.freedom, sample, base, rough.unknown), sample, base)
    machine = _machine(fit, base, start, setup, name)
    miss = _start_miss(sample.take(np.flatnonzero(fit.good)), start, setup)
    return Recovery(machine, fit, sample, tuple(best[1:]), start, miss, setup, _count_skipped(pairs))


def _align_and_fit(
    given: Sequences, start: Machine | None, setup: Setup, other: list[Fit] | None, other_pairs: Pairs | None
) -> tuple[Pairs, list[Fit]]:
    """By alignment, and once more with the machine found; as it was where that is no better."""
    pairs = align_pairs(given, start)
    best = _best(pairs, start, setup)
    pairs = realign_pairs(given, best[0].layout, base_points(best[0].layout, start, setup), best[0].unknown)
    best = _best(pairs, start, setup, [Guess(fit.layout, _rotary_zeros(fit), 0.0) for fit in best])
    if other is not None and other_pairs is not None and other[0].score <= best[0].score:
        return other_pairs, other
    return pairs, best


def _count_skipped(pairs: Pairs) -> int:
    return int(pairs.block[-1] - pairs.block[0] + 1) - len(pairs.block)


def _rotary_zeros(fit: Fit) -> tuple[float, float]:
    z1, z2 = fit.unknown[ROTARY_ZERO].tolist()
    return z1, z2


def _best(pairs: Pairs, start: Machine | None, setup: Setup, known: list[Guess] | None = None) -> list[Fit]:
    """Return the best fit, then those of other layouts that are as good; of the ``known`` layouts where these
    are given."""
    sample = pairs.take(_spread(len(pairs.row), TRIED))
    _check(sample)
    fits = _screen_fits(known or _kinds(guesses(sample, start, False), start), sample, start, setup)
    if (
        known is None and fits[0].scale > EQUAL
    ):  # only then can a shifted rotary zero be the plainest explanation
        fits = _screen_fits(_kinds(guesses(sample, start), start), sample, start, setup)
    best = fits[0]
    alike = [fit for fit in fits[1:] if _as_good(fit, best) and not _same(fit.layout, best.layout)]
    return [best, *alike]


def _kinds(found: list[Guess], start: Machine | None) -> list[Guess]:
    return [kind for guess in found for kind in kinds(guess, start)]


def _screen_fits(tried: list[Guess], pairs: Pairs, start: Machine | None, setup: Setup) -> list[Fit]:
    """Fits of the guesses, with and without a shifted linear zero, the best first."""
    fits = [
        screen_guess(guess, pairs, base_points(guess.layout, start, setup), linear_zero)
        for guess in tried
        for linear_zero in (False, True)
    ]
    return sorted(fits, key=lambda fit: fit.score)


def _as_good(fit: Fit, best: Fit) -> bool:
    return fit.strange <= max(best.strange, 0.0) + 0.5 and max(fit.scale, 1.0) <= EQUAL * max(best.scale, 1.0)


def _same(one: Layout, two: Layout) -> bool:
    return (one.slot, one.letters) == (two.slot, two.letters) and all(
        np.allclose(a, b, rtol=0, atol=1e-6)
        for a, b in (
            (one.direction1, two.direction1),
            (one.direction2, two.direction2),
            (one.linear, two.linear),
        )
    )


def _check(pairs: Pairs) -> None:
    """Raise ProgramError where the rows cannot tell anything."""
    farthest = max(
        float(np.abs(column).max(initial=0.0)) for column in (pairs.tip, pairs.linear, pairs.rotary)
    )
    if not farthest <= FARTHEST:
        raise ProgramError(
            say("a coordinate of {farthest} mm or rad is beyond any machine; correct it", farthest=farthest),
            farthest,
        )
    turned = float(np.ptp(pairs.rotary, axis=0).max())
    if turned < 1e-6:
        raise ProgramError(
            say("the rotary words never change: such rows say nothing of pivots; give a five-axis program"),
            turned,
        )
    leaning = np.linalg.norm(pairs.axis[:, :2], axis=1) > LEANING
    off = (
        float(np.median(np.linalg.norm(pairs.tip - pairs.linear, axis=1)[leaning]))
        if leaning.any()
        else math.inf
    )
    if off < 10.0 * (pairs.steps.tip + pairs.steps.linear):
        text = say(
            "X Y Z are the tips of the CL path although the rotary axes turn: the program leaves the pivots "
            "to the controller (RTCP); post it without tool centre point control"
        )
        raise ProgramError(text, off)


def _spread(count: int, most: int) -> Ints:
    return np.unique(np.linspace(0, count - 1, min(count, most)).astype(np.int64))


def base_points(layout: Layout, start: Machine | None, setup: Setup) -> Floats:
    """Return the points (2, 3) mm, work frame, from which the coordinates of the two lines count: those of
    the machine that is given where its axes come in the same order, else the work zero."""
    if start is None or "".join(axis.letter for axis in start.rotary) != layout.letters:
        return np.zeros((2, 3))
    kinematics = chain(start, setup)
    return np.array([kinematics.point1, kinematics.point2])


def _machine(fit: Fit, base: Floats, start: Machine | None, setup: Setup, name: str) -> Machine:
    """Return the fitted machine, such that the chain in this setup has the fitted lines."""
    empty = _without_points(fit.layout, start, name)
    kinematics = chain(empty, setup)
    lines = lines_of(fit, base) - np.array([kinematics.point1, kinematics.point2])
    points = {letter: _vector(line) for letter, line in zip(fit.layout.letters, lines, strict=True)}
    axes = tuple(replace(axis, point=points[axis.letter]) if axis.rotary else axis for axis in empty.axes)
    return replace(empty, axes=axes)


def lines_of(fit: Fit, base: Floats) -> Floats:
    """Points (2, 3) mm of both rotary lines in the work frame, the tip at the work zero."""
    u = fit.unknown[LINES]
    moved = [u[0:2] @ across(fit.layout.direction1), u[2:4] @ across(fit.layout.direction2)]
    return np.asarray(base + np.array(moved))


def _vector(values: Floats) -> Vector:
    x, y, z = (round(value, 6) + 0.0 for value in values.tolist())
    return x, y, z


def _without_points(layout: Layout, start: Machine | None, name: str) -> Machine:
    if start is not None:
        own = start_layout(start)
        if (own.slot, own.letters) == (layout.slot, layout.letters):
            given = dict(zip(layout.letters, (layout.direction1, layout.direction2), strict=True))
            given |= dict(zip("XYZ", layout.linear, strict=True))
            own_axes = (
                replace(axis, direction=given[axis.letter], point=(0.0, 0.0, 0.0)) for axis in start.axes
            )
            return replace(start, axes=tuple(own_axes), name=name)
    first, second = _rotary(layout, start)
    linear = tuple(_linear(layout, start))
    axes = {TABLE_TABLE: (first, second, *linear), HEAD_HEAD: (*linear, first, second)}.get(
        layout.slot, (first, *linear, second)
    )
    if start is None:
        return Machine(name, axes)
    return replace(start, axes=axes, name=name, description="")


def _rotary(layout: Layout, start: Machine | None) -> tuple[Axis, Axis]:
    sides = {TABLE_TABLE: ("table", "table"), HEAD_HEAD: ("head", "head")}.get(layout.slot, ("table", "head"))
    directions = (layout.direction1, layout.direction2)
    one, two = (
        replace(_drive(letter, True, start), side=side, direction=direction)  # type: ignore[arg-type]
        for letter, side, direction in zip(layout.letters, sides, directions, strict=True)
    )
    return one, two


def _linear(layout: Layout, start: Machine | None) -> list[Axis]:
    drives = (_drive(letter, False, start) for letter in "XYZ")
    return [
        replace(drive, side="head", direction=way) for drive, way in zip(drives, layout.linear, strict=True)
    ]


def _drive(letter: str, rotary: bool, start: Machine | None) -> Axis:
    """Limits, rate and wrap of the machine that is given; without one, no limits and assumed rates."""
    same = [] if start is None else [axis for axis in start.axes if axis.letter == letter]
    if same:
        return replace(same[0], point=(0.0, 0.0, 0.0))
    return Axis(letter, rotary, "head", (1.0, 0.0, 0.0), max_rate=ASSUMED_TURN if rotary else ASSUMED_RATE)


def _start_miss(pairs: Pairs, start: Machine | None, setup: Setup) -> float:
    """How far the tips of the machine that is given are off, at most, mm."""
    if start is None or {axis.letter for axis in start.rotary} != set(pairs.letters):
        return math.inf
    kinematics = chain(start, setup)
    order = [pairs.letters.index(letter) for letter in kinematics.letters[3:]]
    reached = forward_tip(kinematics, np.hstack([pairs.linear, pairs.rotary[:, order]]))
    return float(np.linalg.norm(reached - pairs.tip, axis=1).max(initial=0.0))
