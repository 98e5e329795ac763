# SPDX-License-Identifier: LGPL-2.1-or-later
"""One polyline led past the pole: which way round, how evenly, and the tool axes that follow.

encounter  a stretch of a polyline on which the way of its axis comes within the allowed change of the pole.
           There the axis may be led through the pole itself.
through    on the other branch afterwards: the second rotary word changes its sign, the first one need not
           turn.
around     on the same branch: the first rotary word makes its turn, but over as long a way as the allowed
           change gives it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.ranges import OFF_POLE
from freecad_fiveaxis.core.base.records import Bools, Floats

from .drive import SHORT
from .even_word import cut_length, even_out_word, laziest, leash_of, least_rates
from .meridian import TURN, Globe, angle_between, runs

ZONE = 12.0
"""Half length of the way over which the axis is led, in allowed changes d. An axis that passes the pole at d,
along a straight line in the azimuthal view, then turns the first word by about 2 / ZONE rad on this way
instead of half a turn."""
GENTLE = 4.0
"""Rate that is always allowed, in rates of the first word at the rim of that zone, ``1 / (ZONE^2 d)`` of the
axis' own rate."""
SAME_WORD = 1e-12
"""A first rotary word that is led by less than this (rad) leaves its axis as it was given."""
CLOSED = 1e-9
"""mm; a polyline whose ends are nearer than this is closed, and has one axis there."""


@dataclass(frozen=True, eq=False)
class Given:
    """A polyline as it is driven without leading: ``axis`` (n, 3); ``along`` (n,) mm, its course; ``word``
    (n,) rad, the first rotary one; ``side`` (n,) rad; ``closed``: it ends where it began."""

    axis: Floats
    along: Floats
    word: Floats
    side: Floats
    closed: bool


def describe_polyline(globe: Globe, axis: Floats, centre: Floats, fill: Bools, word: Floats) -> Given:
    """Return the polyline with that axis (n, 3), ball centre (n, 3) mm, fill (n,) and first rotary word (n,)
    rad."""
    closed = bool(np.abs(centre[0] - centre[-1]).max() < CLOSED)
    return Given(axis, cut_length(centre, fill), word, globe.side(axis, word), closed)


def mirror_branch(line: Given) -> Given:
    """Return the polyline taken up on the other branch. On a machine of orthogonal axes it is led the same
    way; a nutating axis turns the first one along with it, on either branch in another sense."""
    return replace(line, word=line.word - 2.0 * line.side, side=-line.side)


@dataclass(frozen=True, eq=False)
class Route:
    """A polyline led: its ``axis`` (n, 3); ``peak`` rad/mm and ``travel`` rad of the first word on it;
    ``zone``: how far from the pole it leaves the given axes, in changes; ``swaps``: it ends on another branch
    than without leading."""

    axis: Floats
    peak: float
    travel: float
    zone: float
    swaps: bool


def lead(globe: Globe, line: Given, change: float) -> Iterator[Route]:
    """Yield the ways to lead a polyline past the pole within ``change`` rad, those that are possible and
    change anything: through the pole before around it, and of either the way that keeps to the given axes
    away from the pole before the one that turns least all along. Each is made when it is asked for."""
    allowed = change - OFF_POLE
    for through in (True, False):
        word, side = _meet_encounters(globe, line, allowed, through)
        below, above = globe.room(line.axis, side, allowed)
        if line.closed:
            below[[0, -1]] = above[[0, -1]] = 0.0
        rates = least_rates(line.along, word - below, word + above, _gentle_rate(globe, line, change))
        if rates is not None:
            met = Met(word, side, below, above, leash_of(line.along, rates))
            yield from (
                route
                for zone in (ZONE, math.inf)
                if (route := _reroute_line(globe, line, met, change, zone)) is not None
            )
        if np.array_equal(side, line.side):  # nothing to go through
            return


@dataclass(frozen=True, eq=False)
class Met:
    """How a polyline meets the pole: the ``word`` and ``side`` (n,) by which the given axes are taken up, the
    word's room ``below`` and ``above``, and the ``leash`` that it is led on, all (n,) rad."""

    word: Floats
    side: Floats
    below: Floats
    above: Floats
    leash: Floats


def _reroute_line(globe: Globe, line: Given, met: Met, change: float, zone: float) -> Route | None:
    """Return the way that keeps to the given axes beyond ``zone`` changes from the pole; None where that
    changes nothing."""
    low, high = _bound_word(globe, line, zone * change, met)
    rerouted = even_out_word(
        met.leash, laziest(low, high, float(met.word[0])), met.word - met.below, met.word + met.above
    )
    moved = np.flatnonzero(np.abs(rerouted - met.word) > SAME_WORD)
    if not len(moved):
        return None
    axis = line.axis.copy()
    axis[moved] = globe.nearest(line.axis[moved], rerouted[moved])
    travel, swaps = float(np.abs(np.diff(rerouted)).sum()), bool(met.side[-1] * line.side[-1] < 0.0)
    return Route(axis, peak_rate(line.along, rerouted), travel, zone, swaps)


def peak_rate(along: Floats, word: Floats) -> float:
    """Return the largest rate, rad/mm, of a word (n,) rad along a course (n,) mm."""
    return float((np.abs(np.diff(word)) / np.maximum(np.diff(along), SHORT)).max())


def _bound_word(globe: Globe, line: Given, reach: float, met: Met) -> tuple[Floats, Floats]:
    """Return the least and the most (n,) that the word may be to turn less: all its room next to the pole,
    none ``reach`` rad off it."""
    if reach == math.inf:
        return met.word - met.below, met.word + met.above
    angle = np.arcsin(np.minimum(np.linalg.norm(globe.across(line.axis), axis=1), 1.0))
    share = np.clip(2.0 - 2.0 * angle / min(reach, 0.5 * math.pi), 0.0, 1.0)
    with np.errstate(invalid="ignore"):
        low, high = (np.where(share > 0.0, share * part, 0.0) for part in (met.below, met.above))
    return met.word - low, met.word + high


def _gentle_rate(globe: Globe, line: Given, change: float) -> float:
    """Return the rate, rad/mm, that is always allowed: that of ZONE at the mean rate of the axis itself, as
    far as the zone goes."""
    travel, length = angle_between(line.axis[1:], line.axis[:-1]), np.diff(line.along)
    inside = globe.approach(line.axis) <= math.sin(min(ZONE * change, 0.5 * math.pi))
    mean = float(travel[inside].sum() / max(length[inside].sum(), CLOSED))
    return GENTLE * max(mean, CLOSED) / (ZONE**2 * change)


def _meet_encounters(globe: Globe, line: Given, change: float, through: bool) -> tuple[Floats, Floats]:
    """Return the words and sides (n,) by which the given axes are taken up when every encounter is passed the
    shorter way."""
    near = globe.approach(line.axis)
    side, step = line.side.copy(), _nearest(np.diff(line.word))
    for (begin, end), (first, last) in _encounters(near, change):
        at = begin + int(near[begin:end].argmin())
        turn, swap = _shorter(line, side, first, last, through)
        if swap:
            side[at + 1 :] *= -1.0
        step[first:] = _nearest(np.diff(_take_up_axes(line, side)[first:]))
        step[at] += turn - step[first:last].sum()
    return line.word[0] + np.concatenate([[0.0], np.cumsum(step)]), side


def _encounters(near: Floats, change: float) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """Return the first and last row of each encounter, and of the way in and out again: as far as the zone
    goes, but not into another encounter. ``near`` (n - 1,): how near each step comes to the pole."""
    met = runs(near <= math.sin(change))
    zones = runs(near <= math.sin(min(ZONE * change, 0.5 * math.pi)))
    routes = []
    for number, (begin, end) in enumerate(met):
        first, last = next(zone for zone in zones if zone[0] <= begin < zone[1])
        before = met[number - 1][1] if number else 0
        after = met[number + 1][0] if number + 1 < len(met) else len(near)
        routes.append(((begin, end), (max(first, before), min(last, after))))
    return routes


def _shorter(line: Given, side: Floats, first: int, last: int, through: bool) -> tuple[float, bool]:
    """Return the least turn of the first word from row ``first`` to row ``last``, and whether it is one that
    changes the branch."""
    word = _take_up_axes(line, side)
    stay = float(_nearest(np.array([word[last] - word[first]]))[0])
    swap = float(_nearest(np.array([word[last] - 2.0 * side[last] - word[first]]))[0])
    return (swap, True) if through and abs(swap) < abs(stay) else (stay, False)


def _take_up_axes(line: Given, side: Floats) -> Floats:
    """Return the words that take up the given axes on these sides, on any winding."""
    return line.word - line.side + side


def _nearest(step: Floats) -> Floats:
    return np.asarray(step - TURN * np.rint(step / TURN))
