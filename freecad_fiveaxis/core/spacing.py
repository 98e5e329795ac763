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
from .progress import Progress, silent
from .records import Bools, Floats, Ints
from .scallop import PassSamples, curvature_along, facet_curvature, flat_interval, sample_pass, scallop_between

MOST_PLANES = 200_000
"""More planes than any job can want: a unit or a setting is wrong."""

TOP, AIM, BOTTOM = 0.985, 0.95, 0.90
"""Shares of the scallop asked for: the measured one must not exceed the first, is aimed at the second, good from the last."""

TRIALS = 16
"""Trial planes per interval; bisection alone then leaves 1e-4 of the first bracket."""

FINE = 0.03
"""A bracket this narrow (share of the interval) is closed: the scallop jumps within it, at an edge along the pass."""

GROWTH = 2.0
"""A trial interval grows or shrinks at most by this square per step: far from the solution the square law does not hold."""

WIDEST = 4.0
"""Largest interval in intervals of a flat: in a hollow of nearly the ball's radius it would have no end."""

STRETCH = 30.0
"""Over this many last intervals the rest is spread, so that no last interval is needlessly small."""

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
    strip = _Strip(mesh, across, np.arange(len(mesh.face)) if keep is None else np.flatnonzero(keep))
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


# ------------------------------------------------------------------------------------------------ trial passes


class _Strip:
    """The facets that are cut, in the order in which planes reach them, so that a plane looks only at those near it.

    ``ranges``: the spans of offsets, mm, that facets cover without a gap.
    """

    def __init__(self, mesh: Mesh, across: Floats, rows: Ints) -> None:
        self._mesh, self._across = mesh, across
        height = (mesh.vertex @ across)[mesh.face[rows]]
        low = height.min(axis=1)
        order = np.argsort(low, kind="stable")
        self._rows, self._corner, self._low = rows[order], height[order], low[order]
        self._high = self._corner.max(axis=1)
        self._tensor: Floats | None = None
        self._active, self._taken = np.empty(0, dtype=np.int64), 0
        self.ranges = self._covered()

    def _covered(self) -> list[tuple[float, float]]:
        rows = np.flatnonzero(self._high > self._low)  # a facet that lies in a plane is cut by none
        if not len(rows):
            return []
        low, top = self._low[rows], np.maximum.accumulate(self._high[rows])
        gap = np.flatnonzero(low[1:] > top[:-1])
        return [*zip(low[np.append(0, gap + 1)].tolist(), top[np.append(gap, len(top) - 1)].tolist(), strict=True)]

    def cut(self, offset: float, step: float) -> PassSamples:
        """The pass of the plane at ``offset``, mm, with samples at most ``step`` mm apart."""
        begun = int(np.searchsorted(self._low, offset, side="right"))
        if begun > self._taken:
            self._active = np.concatenate([self._active, np.arange(self._taken, begun)])
            self._taken = begun
        at = self._active[(self._low[self._active] <= offset) & (self._high[self._active] > offset)]
        height = self._corner[at] - offset
        above = height > 0.0
        lone = np.argmax(above == (above.sum(axis=1) == 1)[:, None], axis=1)
        face, height = self._mesh.face[self._rows[at]], height
        start, end = (self._crossing(face, height, lone, (lone + k) % 3) for k in (1, 2))
        if self._tensor is None:
            self._tensor = facet_curvature(self._mesh)
        rows = self._rows[at]
        return sample_pass(start, end, self._mesh.normal[rows], self._tensor[:, rows], step)

    def _crossing(self, face: Ints, height: Floats, one: Ints, other: Ints) -> Floats:
        """Where the edges (n,) from corner ``one`` to corner ``other`` cross the plane that ``height`` is counted from."""
        row = np.arange(len(face))
        a, b = height[row, one], height[row, other]
        start, end = self._mesh.vertex[face[row, one]], self._mesh.vertex[face[row, other]]
        point: Floats = start + (a / (a - b))[:, None] * (end - start)
        return point

    def pass_by(self, offset: float) -> None:
        """Forget the facets that end before ``offset``: no plane comes back to them."""
        self._active = self._active[self._high[self._active] > offset]

    def predicted(self, here: PassSamples, radius: float, scallop: float) -> float:
        """The smallest interval along a pass by local slope and curvature: eq. (2) for a slope and a curved surface, mm."""
        side = self._across - (here.normal @ self._across)[:, None] * here.normal
        slope = np.linalg.norm(side, axis=1)
        safe = np.maximum(slope, INSIDE)
        spread = np.maximum(1.0 + radius * curvature_along(here.tensor, side / safe[:, None]), INSIDE)
        return flat_interval(radius, scallop) * float((slope / np.sqrt(spread)).min(initial=1.0 / math.sqrt(INSIDE)))


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

    def __init__(self, strip: _Strip, radius: float, scallop: float, least: float, progress: Progress) -> None:
        self._strip, self._radius, self._scallop, self._least, self._progress = strip, radius, scallop, least, progress
        self._flat = flat_interval(radius, scallop)
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
        interval: float | None = 0.0
        while interval is not None:
            offset += interval
            self._planes.append(offset)
            self._report(offset)
            self._strip.pass_by(offset)
            interval = None
            if high - offset > 2.0 * inside:
                step = self._step(offset, high - inside)
                interval = self._fitted(step, high - offset)
                if interval is not None and step.height > self._scallop:
                    self._bound.append(step)

    def _step(self, offset: float, end: float) -> _Step:
        """The interval from the pass at ``offset`` to the next one, not beyond ``end``: trial, measure, correct."""
        here = self._strip.cut(offset, self._flat)
        most = min(end - offset, WIDEST * self._flat)
        predicted = self._strip.predicted(here, self._radius, AIM * self._scallop)
        trial = min(max(self._bias * predicted, self._least), most)
        good, bad = _Step(0.0, 0.0, np.zeros(3), False), math.inf
        for left in reversed(range(TRIALS)):
            height, place = scallop_between(here, self._strip.cut(offset + trial, self._flat), self._radius)
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

    def _fitted(self, step: _Step, rest: float) -> float | None:
        """The interval to take where ``rest`` mm are left of the part; None where no further plane is needed.

        The last plane must stand within half an interval of the part's end. Where it would not, the last intervals shrink
        a little together, so that one more plane fits.
        """
        full = step.interval
        if step.ends:
            full *= math.sqrt(max(AIM * self._scallop / max(step.height, INSIDE * self._scallop), 1.0))
        count = rest / full
        spare = count - math.floor(count)
        if spare > 0.5 and count < STRETCH:
            full = max(rest / (math.floor(count) + 1.1), min(self._least, full))
        return full if count > 0.5 and full < rest else None

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
