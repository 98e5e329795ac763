# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes led through or around the pole, pass by pass, where that makes the machine turn less.

change     the angle between the axis that a strategy gives and the axis that is led; at most what the user allows.
lead       to change the axis of a pass near the pole such that the first rotary axis turns little and evenly; after the idea of
           Affouard et al. (Avoiding 5-axis singularities using tool path deformation, 2004), which moves the axis' path off a
           fixed cone. Here the way is found by :mod:`.leading`, and kept only where driving it on the machine proves it better.

Only the axis moves. Contact points and ball centres stay what they are, so a ball-end cutter cuts the same surface.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product

import numpy as np

from freecad_fiveaxis.core.coedge import OffsetPath
from freecad_fiveaxis.core.errors import SettingsError
from freecad_fiveaxis.core.findings import Finding, Severity
from freecad_fiveaxis.core.kinematics import Chain
from freecad_fiveaxis.core.passes import axes_within_limits
from freecad_fiveaxis.core.progress import Progress, silent
from freecad_fiveaxis.core.records import Bools, Floats

from .drive import Figures, drive, figures, starts
from .leading import ZONE, Given, Way, given, lead, mirrored, peak_rate
from .meridian import LEAST_TILT, Globe, angle_between

NEAR = 3.0
"""Passes that come within so many allowed changes of the pole are led, if that makes them better."""
LARGEST_CHANGE = math.radians(30.0)
"""rad; an axis that is led further than this has little to do with the strategy that was chosen."""
LEAST_CHANGE = 10.0 * LEAST_TILT
"""rad; below this there is no room to lead in."""
ROUNDS = 5
"""Times that the ways led are driven and those that did not help are tried another way; as many times again they are left as
given, and if the rest still harms somebody, all are."""
ENOUGH = 0.1
"""Share of the given peak rate and travel of the first word that is low enough: of ways that reach it, the one that leaves most
of the pass alone is taken."""
STEADY = math.radians(0.1)
"""rad/mm; a first word that turns no faster needs no leading, and no finding where there was none."""
SAME_AXIS = 1e-9
"""Ways whose axes differ by less than this (rad) are one."""
LEAN = 1e-6
"""rad below the surface that rounding may make of an axis that lies in it."""


@dataclass(frozen=True, eq=False)
class Attempt:
    """A polyline (by its number in order) that comes near the pole: its ``rows`` and the ways to lead it, best first, each
    with the parity it is for: 1 where the branch on arrival is the other one than in the given drive, else 0."""

    polyline: int
    rows: slice
    ways: tuple[tuple[int, Way], ...]


@dataclass(frozen=True, eq=False)
class Led:
    """Tool ``axis`` (n, 3); ``near`` (p,) polylines that come near the pole, ``led`` (p,) those whose axis was changed; figures
    of every polyline ``before`` and ``after``."""

    axis: Floats
    near: Bools
    led: Bools
    before: Figures
    after: Figures


def deform_axes(
    offset: OffsetPath, axis: Floats, links: Chain, max_change: float, progress: Progress = silent
) -> tuple[Floats, tuple[Finding, ...]]:
    """Unit tool axes (n, 3) led past the pole, and what there is to say about them.

    ``axis`` (n, 3) unit, one for each row of ``offset``, all within the machine's reach (:func:`~.feasible.feasible_rows`
    first); ``max_change`` rad: the largest angle between the given and the led axis. Rows of one contact point keep one axis
    between them; rows of passes that do not come near the pole, or that do not get better, keep the given axis to the last bit.
    Raises SettingsError for an angle out of range, ReachError for axes beyond the machine's limits.
    """
    check_change(max_change)
    found = led_axes(offset, np.asarray(axis, float), links, max_change, progress)
    if found is None:
        return axis, ()
    return found.axis, _findings(offset, axis, links, found, max_change)


def check_change(change: float) -> None:
    """Raises SettingsError for an allowed change (rad) that is none."""
    if not LEAST_CHANGE <= change <= LARGEST_CHANGE:
        raise SettingsError(
            f"the axis may change by {math.degrees(change):g} deg; give an angle from {math.degrees(LEAST_CHANGE):g} to "
            f"{math.degrees(LARGEST_CHANGE):g} deg",
            change,
        )


def near_polylines(offset: OffsetPath, axis: Floats, globe: Globe, angle: float) -> Bools:
    """Which polylines (p,) come within ``angle`` rad of the pole on the way from row to row."""
    begin = starts(offset.polyline)
    near = np.concatenate([[np.inf], globe.approach(axis)])
    near[begin] = np.inf
    return np.asarray(np.minimum.reduceat(near, begin) <= math.sin(min(angle, 0.5 * math.pi)))


def led_axes(offset: OffsetPath, axis: Floats, links: Chain, change: float, progress: Progress = silent) -> Led | None:
    """As :func:`deform_axes`, with the figures; None where no pass comes near the pole."""
    globe = Globe.of(links)
    if not len(axis) or not (near := near_polylines(offset, axis, globe, NEAR * change)).any():
        return None
    words = drive(offset, axis, links, progress)
    before = figures(offset, words)
    attempts = _attempts(offset, axis, links, globe, words[:, 0], near, change, progress)
    chosen: list[int | None]
    dropped: list[set[int]] = [set() for _ in attempts]
    after, made = before, axis
    for round_ in range(2 * ROUNDS + 1):
        progress("driving what is led", round_ / (2 * ROUNDS + 1))
        chosen = _chosen(attempts, dropped) if round_ < 2 * ROUNDS else [None for _ in attempts]
        made, led = _assembled(axis, attempts, chosen, len(near))
        after = figures(offset, drive(offset, made, links)) if led.any() else before
        failed = _failed(attempts, led, before, after)
        if not failed.any():
            break
        for number in np.flatnonzero(failed).tolist():
            tried = chosen[number]
            dropped[number] |= {tried} if tried is not None and round_ < ROUNDS else set(range(len(attempts[number].ways)))
    return Led(made, near, led, before, after)


def _attempts(
    offset: OffsetPath, axis: Floats, links: Chain, globe: Globe, word: Floats, near: Bools, change: float, progress: Progress
) -> list[Attempt]:
    begin = starts(offset.polyline)
    end = np.append(begin[1:], len(axis))
    attempts = []
    for count, line in enumerate(np.flatnonzero(near).tolist()):
        progress("leading past the pole", count / int(near.sum()))
        rows = slice(int(begin[line]), int(end[line]))
        polyline = given(globe, axis[rows], offset.centre[rows], offset.fill[rows], word[rows])
        ways = [(parity, way) for parity, way in _ways(globe, polyline, change) if _usable(offset, links, rows, way.axis)]
        if ways:
            attempts.append(Attempt(line, rows, tuple(sorted(ways, key=lambda found: _rank(polyline, found[1])))))
    return attempts


def _rank(line: Given, way: Way) -> tuple[bool, float, float]:
    """How good a way is, best first: low enough within the least zone; or else at the least cost."""
    step = np.abs(np.diff(line.word))
    peak, travel = peak_rate(line.along, line.word), float(step.sum())
    enough = way.peak <= ENOUGH * peak and way.travel <= ENOUGH * travel
    return not enough, way.zone if enough else 0.0, way.peak * way.travel


def _ways(globe: Globe, line: Given, change: float) -> list[tuple[int, Way]]:
    """The different ways to lead a polyline, and their parity; where one near the pole is enough, none that goes all along."""
    ways: list[tuple[int, Way]] = []
    taken = [(0, line)] if globe.straight else [(0, line), (1, mirrored(line))]
    for zone in (ZONE, math.inf) if len(line.word) > 1 else ():
        for through, (parity, polyline) in product((True, False), taken):
            way = lead(globe, polyline, change, through, zone)
            if way is not None and not any(np.allclose(way.axis, other.axis, atol=SAME_AXIS, rtol=0.0) for _, other in ways):
                ways.append((parity, way))
        if any(not _rank(line, way)[0] for _, way in ways):
            break
    return ways


def _usable(offset: OffsetPath, links: Chain, rows: slice, way: Floats) -> bool:
    """Whether the tool does not lean into the part, and stays within the rotary limits."""
    return bool(((offset.normal[rows] * way).sum(1) >= -LEAN).all() and axes_within_limits(links, way).all())


def _chosen(attempts: list[Attempt], dropped: list[set[int]]) -> list[int | None]:
    """The number of the best way left of each attempt, None where there is none; of those for the branch on which the machine
    arrives after the ways before, if there are any: on a nutating axis the other branch needs another way."""
    parity, chosen = 0, list[int | None]()
    for attempt, bad in zip(attempts, dropped, strict=True):
        left = [number for number in range(len(attempt.ways)) if number not in bad]
        best = min(left, key=lambda number: (attempt.ways[number][0] != parity, number), default=None)
        if best is not None:
            parity = attempt.ways[best][0] ^ attempt.ways[best][1].swaps
        chosen.append(best)
    return chosen


def _assembled(axis: Floats, attempts: list[Attempt], chosen: list[int | None], count: int) -> tuple[Floats, Bools]:
    """The axes with the chosen way of each attempt, and which of ``count`` polylines are led."""
    made, led = np.array(axis), np.zeros(count, bool)
    for attempt, number in zip(attempts, chosen, strict=True):
        if number is not None:
            made[attempt.rows], led[attempt.polyline] = attempt.ways[number][1].axis, True
    return made, led


def _failed(attempts: list[Attempt], led: Bools, before: Figures, after: Figures) -> Bools:
    """The attempts whose way has to go: it is no better; or, where all are, it makes another polyline worse, to which it is the
    nearest (the machine's branch is chosen for the whole path)."""
    failed = led & ~after.better(before)
    numbers = np.flatnonzero(led)
    if len(numbers) and not failed.any():
        for line in np.flatnonzero(~led & after.worse(before)).tolist():
            failed[numbers[np.abs(numbers - line).argmin()]] = True
    return np.array([failed[attempt.polyline] for attempt in attempts], bool)


def _findings(offset: OffsetPath, axis: Floats, links: Chain, found: Led, change: float) -> tuple[Finding, ...]:
    """What was led, and what still turns fast near the pole."""
    globe, letter, limit = Globe.of(links), links.letters[3], math.degrees(change)
    findings = []
    if found.led.any():
        most = math.degrees(float(angle_between(found.axis, axis).max()))
        before, after = (math.degrees(float(part.peak[found.led].max())) for part in (found.before, found.after))
        turned, turns = (math.degrees(float(part.first[found.led].sum())) for part in (found.before, found.after))
        text = (
            f"{int(found.led.sum())} passes are led past the pole: {letter} turns at most {after:.3g} instead of {before:.3g} "
            f"deg/mm on them, and {turns:.0f} instead of {turned:.0f} deg in all, for an axis changed by up to {most:.3f} deg."
        )
        worst = np.flatnonzero(found.led)[found.before.peak[found.led].argmax()]
        place = _nearest_place(offset, axis, globe, int(worst))
        findings.append(Finding(Severity.NOTE, "axis-led-past-pole", text, most, limit, "deg", place=place))
    left = np.flatnonzero(near_polylines(offset, axis, globe, change) & ~found.led & (found.after.peak > STEADY))
    if len(left):
        worst = left[found.after.peak[left].argmax()]
        rate = math.degrees(float(found.after.peak[worst]))
        text = (
            f"{len(left)} passes come within {limit:g} deg of the pole and could not be led past it any better: {letter} turns "
            f"up to {rate:.3g} deg/mm there. A larger angle, wider rotary limits or another setup may help."
        )
        place = _nearest_place(offset, axis, globe, int(worst))
        findings.append(Finding(Severity.NOTE, "axis-left-near-pole", text, rate, None, "deg/mm", place=place))
    return tuple(findings)


def _nearest_place(offset: OffsetPath, axis: Floats, globe: Globe, polyline: int) -> tuple[float, float, float]:
    """The contact point at which the axis of a polyline is nearest to the pole."""
    begin = starts(offset.polyline)
    rows = slice(int(begin[polyline]), int(np.append(begin, len(axis))[polyline + 1]))
    x, y, z = offset.point[rows.start + int(np.linalg.norm(globe.across(axis[rows]), axis=1).argmin())].tolist()
    return x, y, z
