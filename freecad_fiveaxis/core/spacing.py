# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the parallel planes lie (Lin & Ye, II.B and C).

across     horizontal direction from plane to plane, (-sin angle, cos angle, 0); a plane's offset is across . p.
interval   distance of two neighbouring planes.
stepover   a constant interval. The outermost planes lie equally far, at most half an interval, inside the part.
scallop    largest scallop that may be left; each plane stands as far from the one before it as that allows.
least      no interval is smaller. A wall that the planes hardly cross would otherwise take passes without end.

With a scallop each interval starts from the smallest one along the pass before it, as in the paper, but for the local slope
and curvature. Then the scallop between that pass and the trial pass is measured and the trial plane moved until the
largest scallop between the two is just below what was asked. The strips outside the outermost passes are at most half
an interval wide.
"""

from __future__ import annotations

import math
import time
from dataclasses import dataclass

import numpy as np

from .errors import SettingsError
from .findings import Finding, Severity
from .mesh import Mesh
from .pass_pair import Strip, scallop_between, smallest_interval
from .progress import Progress, silent
from .records import Bools, Floats
from .scallop import flat_interval

MOST_PLANES = 200_000
"""More planes than any job can want: a unit or a setting is wrong."""

TOP, AIM, BOTTOM = 0.97, 0.95, 0.92
"""Shares of the scallop asked for: the measured one must not exceed the first, is aimed at the second, good from the last."""

TRIALS = 16
"""Trial planes per interval; bisection alone then leaves 1e-4 of the first bracket."""

FINE = 0.03
"""A bracket this narrow (share of the interval) is closed: the scallop jumps within it, at an edge along the pass."""

SAMPLE = 0.5
"""Step of the samples on a pass, in intervals of a flat."""

GROWTH = 2.0
"""A trial interval grows or shrinks at most by this square per step: far from the solution the square law does not hold."""

WIDEST = 4.0
"""Largest interval in intervals of a flat: in a hollow of nearly the ball's radius it would have no end."""

STRETCH = 60.0
"""Over this many last intervals the rest is spread, so that no last interval is needlessly small."""

SPARE = 0.2
"""Share of an interval that is planned to be left beyond the last plane; half an interval may be."""

INSIDE = 1e-3
"""Share of the least interval by which a trial plane stays inside the part, where it surely cuts facets."""

PERIOD = 0.25
"""Seconds between two reports of progress."""


def place_planes(
    mesh: Mesh,
    angle: float,
    radius: float,
    *,
    stepover: float | None = None,
    scallop: float | None = None,
    least: float = 0.05,
    keep: Bools | None = None,
    progress: Progress = silent,
) -> tuple[Floats, tuple[Finding, ...]]:
    """Offsets (k,) mm, ascending, of the planes that travel along ``angle`` rad, and what is poor about them.

    ``radius`` of the ball, ``stepover`` or ``scallop``, and ``least``, mm; ``keep`` (f,) the facets that are cut, None for all.
    Raises SettingsError for values out of range, both or none of stepover and scallop, and too many planes.
    """
    _check(angle, radius, stepover, scallop, least)
    across = np.array((-math.sin(angle), math.cos(angle), 0.0))
    strip = Strip(mesh, across, np.arange(len(mesh.face)) if keep is None else np.flatnonzero(keep))
    if not strip.ranges:
        raise SettingsError(f"no facet lies across planes at {math.degrees(angle):g} deg; turn the direction", angle)
    if stepover is not None:
        return _even_planes(strip.ranges[0][0], strip.ranges[-1][1], stepover), ()
    assert scallop is not None
    return _March(strip, radius, scallop, least, progress).run()


def _check(angle: float, radius: float, stepover: float | None, scallop: float | None, least: float) -> None:
    if not math.isfinite(angle):
        raise SettingsError(f"direction {angle} is no angle; give a number of degrees", angle)
    lengths = {"cutter radius": radius, "least interval": least, "stepover": stepover, "scallop": scallop}
    for name, value in lengths.items():
        if value is not None and not 0.0 < value < math.inf:
            raise SettingsError(f"{name} {value:g} mm is out of range; give more than 0 mm", value)
    if (stepover is None) == (scallop is None):
        given = "neither" if stepover is None else f"both stepover {stepover:g} mm and scallop {scallop:g} mm"
        raise SettingsError(f"{given} given; give either a stepover or a scallop", stepover)
    if scallop is not None and scallop >= radius:
        raise SettingsError(
            f"scallop {scallop:g} mm is not below the cutter radius {radius:g} mm; give a smaller scallop", scallop
        )


def _check_count(planes: float, what: str, value: float) -> None:
    if planes > MOST_PLANES:
        remedy = f"more than {MOST_PLANES} planes; give a larger {what} or check the units of the part"
        raise SettingsError(f"{what} {value:g} mm needs {remedy}", value)


def _even_planes(low: float, high: float, stepover: float) -> Floats:
    """As few planes as leave no more than half a stepover outside the outermost ones, both edges alike."""
    _check_count((high - low) / stepover, "stepover", stepover)
    planes = max(math.ceil((high - low) / stepover - INSIDE), 1)
    first = 0.5 * (low + high - (planes - 1) * stepover)
    return first + stepover * np.arange(planes, dtype=np.float64)


# ------------------------------------------------------------------------------------------------ the march


@dataclass(frozen=True)
class _Step:
    """One interval, mm, the largest scallop that it leaves, mm, and where; ``ends`` if the part ends before the scallop binds."""

    interval: float
    height: float
    place: Floats
    ends: bool


class _March:
    """Places the planes of all ranges one after the other, for a scallop."""

    def __init__(self, strip: Strip, radius: float, scallop: float, least: float, progress: Progress) -> None:
        self._strip, self._radius, self._scallop, self._least, self._progress = strip, radius, scallop, least, progress
        self._flat = flat_interval(radius, scallop)
        self._sample = SAMPLE * self._flat
        self._bias = 1.0  # of the prediction, learnt from the interval before
        self._planes: list[float] = []
        self._bound: list[_Step] = []  # where the least interval is larger than the scallop allows
        self._told = 0.0
        _check_count(sum(high - low for low, high in strip.ranges) / self._flat, "scallop", scallop)

    def run(self) -> tuple[Floats, tuple[Finding, ...]]:
        for low, high in self._strip.ranges:
            self._cover(low, high)
        return np.array(self._planes), self._findings()

    def _cover(self, low: float, high: float) -> None:
        """Planes from ``low`` to ``high``, the outermost at most half an interval inside."""
        inside = INSIDE * min(self._least, high - low)
        offset = low + 0.5 * min(self._step(low + inside, high - inside).interval, high - low)
        self._share, self._fit_below = 1.0, STRETCH
        interval: float | None = 0.0
        while interval is not None:
            offset += interval
            self._planes.append(offset)
            self._report(offset)
            self._strip.pass_by(offset)
            interval = None
            if high - offset > 2.0 * inside:
                step = self._step(offset, high - inside)
                interval = self._fitted(step, offset, high)
                if interval is not None and step.height > self._scallop:
                    self._bound.append(step)

    def _step(self, offset: float, end: float) -> _Step:
        """The interval from the pass at ``offset`` to the next one, not beyond ``end``: trial, measure, correct."""
        here = self._strip.cut(offset, self._sample)
        most = min(end - offset, WIDEST * self._flat)
        predicted = smallest_interval(here, self._strip.across, self._radius, AIM * self._scallop)
        trial = min(max(self._bias * predicted, self._least), most)
        good, bad = _Step(0.0, 0.0, np.zeros(3), False), math.inf
        for left in reversed(range(TRIALS)):
            there = self._strip.cut(offset + trial, self._sample)
            height, place = scallop_between(here, there, self._radius)
            if height <= TOP * self._scallop or trial <= self._least or (not left and not good.interval):
                good = _Step(trial, height, place, trial >= end - offset)
            else:
                bad = trial
            found = good.interval == trial and height >= BOTTOM * self._scallop
            if found or good.interval >= most or bad - good.interval <= FINE * bad:
                break
            change = math.sqrt(AIM * self._scallop / max(height, 1e-9 * self._scallop))
            trial *= min(max(change, 1.0 / GROWTH), GROWTH)
            if not good.interval < trial < bad:
                trial = 0.5 * (good.interval + bad)
            trial = min(max(trial, self._least), most)
        self._bias = min(max(good.interval / max(predicted, self._least), 1.0 / WIDEST), WIDEST)
        return good

    def _fitted(self, step: _Step, offset: float, end: float) -> float | None:
        """The interval to take from the pass at ``offset`` where the part ends at ``end``; None where no plane is needed.

        The last plane must stand within half an interval of the end. Where it would not, the intervals on the way there
        shrink a little together, so that one more plane fits.
        """
        full = step.interval
        if step.ends:
            full *= math.sqrt(max(AIM * self._scallop / max(step.height, INSIDE * self._scallop), 1.0))
        count = (end - offset) / full
        if count <= 0.5:
            return None
        if count < 1.0:
            return (end - offset) / (1.0 + SPARE)
        if count < self._fit_below:
            self._fit_below = 0.5 * count
            count = 1.0 + self._count(offset + full, end)
            self._share = count / (math.floor(count - 2.0 * SPARE) + 1.0 + SPARE)
        return max(full * min(self._share, 1.0), min(full, self._least))

    def _count(self, offset: float, end: float) -> float:
        """How many intervals lie between, by the prediction alone; the last one in part."""
        count = 0.0
        while True:
            here = self._strip.cut(offset, self._sample)
            predicted = smallest_interval(here, self._strip.across, self._radius, AIM * self._scallop)
            interval = min(max(self._bias * predicted, self._least), WIDEST * self._flat)
            if offset + interval >= end or count > 2.0 * STRETCH:  # many more than thought: nothing to spread
                return count + (end - offset) / interval
            offset, count = offset + interval, count + 1.0

    def _report(self, offset: float) -> None:
        _check_count(len(self._planes), "scallop", self._scallop)
        now = time.monotonic()
        if now - self._told > PERIOD:
            low, high = self._strip.ranges[0][0], self._strip.ranges[-1][1]
            self._progress("placing planes", (offset - low) / (high - low))
            self._told = now

    def _findings(self) -> tuple[Finding, ...]:
        if not self._bound:
            return ()
        worst = max(self._bound, key=lambda step: step.height)
        x, y, z = (float(v) for v in worst.place)
        text = (
            f"The least interval of {self._least:g} mm binds {len(self._bound)} times and leaves scallops up to "
            f"{worst.height:.4g} mm where {self._scallop:g} mm are asked: give a smaller least interval or turn the direction "
            "along the steep walls."
        )
        value, limit = worst.height, self._scallop
        return (Finding(Severity.WARNING, "least-interval", text, value=value, limit=limit, unit="mm", place=(x, y, z)),)
