# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which polylines are led, and which way: tried out on the machine.

way       one manner of leading a polyline (:mod:`.rerouting`): through or around the pole, near it or all
          along.
parity    1 where the branch on which the machine comes to a polyline is the other one than in the given
          drive, else 0. On a nutating axis the other branch needs another way.
swap      a way that ends on another branch than the given axes: it turns the parity of what follows.

The machine's branch is chosen for the whole path, so one polyline led may change how another is driven.
Therefore all ways chosen are driven together; those that are no better, or make another polyline worse, are
replaced or given up, and all is driven again.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.passes import axes_within_limits
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

from .drive import Figures, drive, figures, starts
from .meridian import Globe
from .rerouting import Given, Route, describe_polyline, lead, mirror_branch, peak_rate

NEAR = 3.0
"""Passes that come within so many allowed changes of the pole are led, if that makes them better."""
ROUNDS = 6
"""Times that the ways led are driven and those that did not help are tried another way; as many times again
they are left as given, and if the rest still harms somebody, all are."""
ENOUGH = 0.1
"""Share of the given peak rate and travel of the first word that is low enough: of ways that reach it, the
one that leaves most of the pass alone is taken."""
AS_MEANT = 1.5
"""Times the meant peak rate up to which a way counts as driven the way it was meant."""
SAME_AXIS = 1e-9
"""Ways whose axes differ by less than this (rad) are one."""
LEAN = 1e-6
"""rad below the surface that rounding may make of an axis that lies in it."""


@dataclass(frozen=True, eq=False)
class Attempt:
    """A polyline (by its number in order) that comes near the pole: its ``rows``, how it is driven as given,
    and the ways to lead it, best first, each with the parity it is for. ``whole``: there are no other
    ways."""

    polyline: int
    rows: slice
    line: Given
    routes: tuple[tuple[int, Route], ...]
    whole: bool


@dataclass(frozen=True, eq=False)
class ReroutedAxes:
    """Tool ``axis`` (n, 3); ``near`` (p,) polylines that come near the pole, ``rerouted`` (p,) those whose
    axis was changed; figures of every polyline ``before`` and ``after``."""

    axis: Floats
    near: Bools
    rerouted: Bools
    before: Figures
    after: Figures


def near_polylines(offset: OffsetPath, axis: Floats, globe: Globe, angle: float) -> Bools:
    """Which polylines (p,) come within ``angle`` rad of the pole on the way from row to row."""
    begin = starts(offset.polyline)
    near = np.concatenate([[np.inf], globe.approach(axis)])
    near[begin] = np.inf
    return np.asarray(np.minimum.reduceat(near, begin) <= math.sin(min(angle, 0.5 * math.pi)))


def reroute_axes(
    offset: OffsetPath, axis: Floats, kinematics: Chain, change: float, progress: Progress = silent
) -> ReroutedAxes | None:
    """Return the axes (n, 3) led within ``change`` rad as in :func:`~.past_pole.apply.deform_axes`, with the
    figures; None where no polyline comes near the pole."""
    globe = Globe.of(kinematics)
    if not len(axis) or not (near := near_polylines(offset, axis, globe, NEAR * change)).any():
        return None
    words = drive(offset, axis, kinematics, progress)
    before = figures(offset, words)
    attempts = _attempts(offset, axis, kinematics, globe, words[:, 0], near, change, progress)
    dropped: list[set[int]] = [set() for _ in attempts]
    for round_ in range(2 * ROUNDS):
        progress("driving what is led", round_ / (2 * ROUNDS))
        chosen = _choose_ways(attempts, dropped)
        tried, rerouted = _assemble_axes(axis, attempts, chosen, len(near))
        after = figures(offset, drive(offset, tried, kinematics)) if chosen else before
        failed = _find_failed(attempts, chosen, rerouted, before, after)
        if not failed:
            return ReroutedAxes(tried, near, rerouted, before, after)
        for number, routes in failed.items():
            dropped[number] |= routes if round_ < ROUNDS else set(range(len(attempts[number].routes)))
            if not attempts[number].whole and round_ < ROUNDS:
                attempts[number] = _with_ways(attempts[number], offset, kinematics, globe, change, whole=True)
    return ReroutedAxes(axis, near, np.zeros(len(near), bool), before, before)


def _attempts(
    offset: OffsetPath,
    axis: Floats,
    kinematics: Chain,
    globe: Globe,
    word: Floats,
    near: Bools,
    change: float,
    progress: Progress,
) -> list[Attempt]:
    begin = starts(offset.polyline)
    end = np.append(begin[1:], len(axis))
    attempts = []
    for count, line in enumerate(np.flatnonzero(near).tolist()):
        progress("leading past the pole", count / int(near.sum()))
        rows = slice(int(begin[line]), int(end[line]))
        polyline = describe_polyline(globe, axis[rows], offset.centre[rows], offset.fill[rows], word[rows])
        attempt = Attempt(line, rows, polyline, (), False)
        attempts.append(_with_ways(attempt, offset, kinematics, globe, change))
    return attempts


def _with_ways(
    attempt: Attempt, offset: OffsetPath, kinematics: Chain, globe: Globe, change: float, whole: bool = False
) -> Attempt:
    """Return the attempt with more ways: up to one that is low enough, where parity says nothing; or all."""
    line, routes = attempt.line, [*attempt.routes]
    known = len(routes)
    for parity, polyline in [(0, line)] if globe.straight else [(0, line), (1, mirror_branch(line))]:
        for route in lead(globe, polyline, change) if len(line.word) > 1 else ():
            if any(np.allclose(route.axis, other.axis, atol=SAME_AXIS, rtol=0.0) for _, other in routes):
                continue
            if _usable(offset, kinematics, attempt.rows, route.axis):
                routes.append((parity, route))
                if globe.straight and not whole and not _rank(line, route)[0]:
                    return replace(
                        attempt, routes=tuple(sorted(routes, key=lambda found: _rank(line, found[1])))
                    )
    more = sorted(routes[known:], key=lambda found: _rank(line, found[1]))
    return replace(attempt, routes=(*routes[:known], *more), whole=True)


def _rank(line: Given, route: Route) -> tuple[bool, float, float]:
    """How good a way is, best first: low enough within the least zone; or else at the least cost."""
    step = np.abs(np.diff(line.word))
    peak, travel = peak_rate(line.along, line.word), float(step.sum())
    enough = route.peak <= ENOUGH * peak and route.travel <= ENOUGH * travel
    return not enough, route.zone if enough else 0.0, route.peak * route.travel


def _usable(offset: OffsetPath, kinematics: Chain, rows: slice, route: Floats) -> bool:
    """Whether the tool does not lean into the part, and stays within the rotary limits."""
    return bool(
        ((offset.normal[rows] * route).sum(1) >= -LEAN).all() and axes_within_limits(kinematics, route).all()
    )


def _choose_ways(attempts: list[Attempt], dropped: list[set[int]]) -> dict[int, int]:
    """Return the number of the best way left of each attempt that has one, by the attempt's number; a way for
    the parity that the ways before leave, if there is one."""
    parity, chosen = 0, {}
    for number, (attempt, bad) in enumerate(zip(attempts, dropped, strict=True)):
        left = [route for route in range(len(attempt.routes)) if route not in bad]
        if left:
            best = min(left, key=lambda route: (attempt.routes[route][0] != parity, route))
            parity = attempt.routes[best][0] ^ attempt.routes[best][1].swaps
            chosen[number] = best
    return chosen


def _assemble_axes(
    axis: Floats, attempts: list[Attempt], chosen: dict[int, int], count: int
) -> tuple[Floats, Bools]:
    """Return the axes with the chosen ways, and which of ``count`` polylines are led."""
    tried, rerouted = np.array(axis), np.zeros(count, bool)
    for number, route in chosen.items():
        attempt = attempts[number]
        tried[attempt.rows], rerouted[attempt.polyline] = attempt.routes[route][1].axis, True
    return tried, rerouted


def _find_failed(
    attempts: list[Attempt], chosen: dict[int, int], rerouted: Bools, before: Figures, after: Figures
) -> dict[int, set[int]]:
    """Return the ways that have to go, by attempt: those that are no better, or that the machine drives on
    another branch, far faster than meant; or, where there are none, what makes another polyline worse: the
    last swap before it, or else the nearest way."""
    better, failed = after.better(before), {}
    for number, route in chosen.items():
        line, meant = attempts[number].polyline, attempts[number].routes[route][1].peak
        if not better[line] or after.peak[line] > max(AS_MEANT * meant, ENOUGH * before.peak[line]):
            failed[number] = {route}
    if failed or not chosen:
        return failed
    swaps = {number for number, route in chosen.items() if attempts[number].routes[route][1].swaps}
    for line in np.flatnonzero(~rerouted & after.worse(before)).tolist():
        swap = max((number for number in swaps if attempts[number].polyline < line), default=None)
        if swap is None:
            nearest = min(chosen, key=lambda number: abs(attempts[number].polyline - line))
            failed[nearest] = {chosen[nearest]}
        else:
            failed[swap] = {number for number, (_, route) in enumerate(attempts[swap].routes) if route.swaps}
    return failed
