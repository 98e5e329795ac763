# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the parallel planes lie (Lin & Ye, II.B and C).

across     horizontal direction from plane to plane, (-sin angle, cos angle, 0); a plane's offset is across .
           p.
interval   distance of two neighbouring planes.
stepover   a constant interval. The outermost planes lie equally far, at most half an interval, inside the
           part.
scallop    largest scallop that may be left; each plane stands as far from the one before it as that allows.
least      no interval is smaller. A wall that the planes hardly cross would otherwise take passes without
           end.

With a scallop each interval starts from the smallest one along the pass before it, as in the paper, but for
the local slope and curvature. Then the scallop between that pass and the trial pass is measured and the trial
plane moved until the largest scallop between the two is just below what was asked. The strips outside the
outermost passes are at most half an interval wide, or the least interval. Where passes end aslant, the corner
between two ends belongs to the border, not to the scallop between them: where the border runs nearly along
the passes up to four times the scallop may stand there.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Angle, Length, Number, Option, Template, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .pass_pair import Strip, scallop_between, smallest_interval
from .scallop import flat_interval, refuse_high_scallop

MOST_PLANES = 200_000
"""More planes than any job can want: a unit or a setting is wrong."""

MOST_SAMPLES = 200_000_000
"""Samples of all passes between which scallops are measured: some minutes of work. More need a coarser
scallop."""

TOP, AIM, BOTTOM = 0.96, 0.945, 0.92
"""Shares of the scallop asked for: the measured one must not exceed the first, is aimed at the second, good
from the last."""

TRIALS = 16
"""Trial planes per interval; bisection alone then leaves 1e-4 of the first bracket."""

FINE = 0.03
"""A bracket this narrow (share of the interval) is closed: the scallop jumps within it, at an edge along the
pass."""

SAMPLE = 0.5
"""Step of the samples on a pass, in intervals of a flat."""

GROWTH = 2.0
"""A trial interval grows or shrinks at most by this square per step: far from the solution the square law
does not hold."""

WIDEST = 4.0
"""Largest interval in intervals of a flat: in a hollow of nearly the ball's radius it would have no end."""

STRETCH = 60
"""So many last intervals share what a further plane takes, so that no last interval is needlessly small."""

REPEATS = 4
"""Marches over the last intervals until they fit; more only where the scallop jumps from facet to facet."""

SPARE = 0.2
"""Share of an interval that is planned to be left beyond the last plane; half an interval may be."""

TINY_HEIGHT = 1e-9
"""Share of the scallop that stands for none at all."""

INSIDE = 1e-3
"""Share of the least interval by which a trial plane stays inside the part, where it surely cuts facets."""

BOUND = Template(
    "On steep walls {count} of the passes stand no closer than {least}: scallops up to {height} stay where "
    "{scallop} are asked. Give a smaller {option}, or turn the passes along the walls."
)
BOUND_APART = Template(
    "On steep walls {count} of the passes stand no closer than {least}: material up to {height} high stays "
    "between them where "
    "scallops of {scallop} are asked. Give a smaller {option}, or turn the passes along the walls."
)
"""Higher than the cutter's radius: no scallop, for between two passes of a ball none is."""
PERIOD = 0.25
"""Seconds between two reports of progress."""

PlacePlanes = Callable[[], tuple[Floats, tuple[Finding, ...]]]
"""Long work that gives the offsets (k,) mm, ascending, of planes, and what is poor about them."""


def prepare_planes(
    mesh: Mesh,
    angle: float,
    radius: float,
    *,
    stepover: float | None = None,
    scallop: float | None = None,
    least: float = 0.05,
    keep: Bools | None = None,
    progress: Progress = silent,
    widest: float = WIDEST,
    normal: Floats | None = None,
) -> PlacePlanes:
    """Check what is asked of the planes, and give the long work that places them.

    ``radius`` of the ball, ``stepover`` or ``scallop``, and ``least``, mm; ``keep`` (f,) the facets that are
    cut, None for all; ``widest``: the largest interval, in intervals of a flat. ``normal`` (3,) unit: of the
    planes, which else are upright and travel along ``angle`` rad. Raises SettingsError for values out of
    range, both or none of stepover and scallop, and too many planes.
    """
    _check(angle, radius, stepover, scallop, least)
    across = np.array((-math.sin(angle), math.cos(angle), 0.0)) if normal is None else normal
    rows = np.arange(len(mesh.face)) if keep is None else np.flatnonzero(keep)
    low, high = _extent(mesh, across, rows)
    if not low < high:
        raise _nothing_across(angle, normal)
    if stepover is not None:
        _check_count((high - low) / stepover, "stepover", stepover)
        return lambda: (_even_planes(low, high, stepover), ())
    assert scallop is not None
    return _March(Strip(mesh, across, rows), radius, scallop, least, progress, widest).run


def _nothing_across(angle: float, normal: Floats | None) -> SettingsError:
    if normal is None:
        text = say(
            "no facet lies across planes at {angle}; turn the direction", angle=Angle(math.degrees(angle))
        )
        return SettingsError(text, angle)
    given = ",".join(f"{number:.4g}" for number in normal.tolist())
    return SettingsError(
        say("no facet lies across planes of the normal {given}; turn the normal", given=given), given
    )


def _check(angle: float, radius: float, stepover: float | None, scallop: float | None, least: float) -> None:
    if not math.isfinite(angle):
        raise SettingsError(
            say("direction {angle} is no angle; give a number of degrees", angle=angle), angle
        )
    lengths = {"cutter radius": radius, "least interval": least, "stepover": stepover, "scallop": scallop}
    for name, value in lengths.items():
        if value is not None and not 0.0 < value < math.inf:
            raise SettingsError(
                say("{name} {value} is out of range; give more than 0 mm", name=name, value=Length(value)),
                value,
            )
    if (stepover is None) == (scallop is None):
        given = say("neither")
        if stepover is not None and scallop is not None:
            given = say(
                "both stepover {stepover} and scallop {scallop}",
                stepover=Length(stepover),
                scallop=Length(scallop),
            )
        raise SettingsError(say("{given} given; give either a stepover or a scallop", given=given), stepover)
    if scallop is not None:
        refuse_high_scallop(scallop, radius)


def _extent(mesh: Mesh, across: Floats, rows: Ints) -> tuple[float, float]:
    """Least and largest offset, mm, of the facets ``rows`` that planes cut: one that lies in a plane is cut
    by none."""
    offset = mesh.vertex @ across

    def of(part: slice) -> tuple[float, float]:
        a, b, c = (offset.take(corner) for corner in mesh.face.T.take(rows[part], axis=1))
        low, high = np.minimum(np.minimum(a, b), c), np.maximum(np.maximum(a, b), c)
        cut = high > low
        return float(low.min(where=cut, initial=math.inf)), float(high.max(where=cut, initial=-math.inf))

    lows, highs = zip((math.inf, -math.inf), *in_threads(of, chunks(len(rows))), strict=True)
    return min(lows), max(highs)


def _check_count(planes: float, what: str, value: float) -> None:
    if planes > MOST_PLANES:
        remedy = say(
            "more than {most_planes} planes; give a larger {what} or check the units of the part",
            most_planes=MOST_PLANES,
            what=what,
        )
        raise SettingsError(
            say("{what} {value} needs {remedy}", what=what, value=Length(value), remedy=remedy), value
        )


def _even_planes(low: float, high: float, stepover: float) -> Floats:
    """As few planes as leave no more than half a stepover outside the outermost ones, both edges alike."""
    planes = max(math.ceil((high - low) / stepover - INSIDE), 1)
    first = 0.5 * (low + high - (planes - 1) * stepover)
    return first + stepover * np.arange(planes, dtype=np.float64)


# ------------------------------------------------------------------------------------------------ the march


@dataclass(frozen=True)
class _Step:
    """One interval, mm, the largest scallop that it leaves, mm, and where; ``ends`` if the part ends before
    the scallop binds."""

    interval: float
    height: float
    place: Floats
    ends: bool


class _March:
    """Places the planes of all ranges one after the other, for a scallop."""

    def __init__(
        self, strip: Strip, radius: float, scallop: float, least: float, progress: Progress, widest: float
    ) -> None:
        self._strip, self._radius, self._scallop, self._least, self._progress = (
            strip,
            radius,
            scallop,
            least,
            progress,
        )
        self._flat = flat_interval(radius, scallop)
        self._widest = widest * self._flat
        self._sample = SAMPLE * self._flat
        self._bias = 1.0  # of the prediction, learnt from the interval before
        self._planes: list[float] = []
        self._bound: list[_Step] = []  # where the least interval is larger than the scallop allows
        self._reported, self._far = 0.0, 0.0
        _check_count(sum(high - low for low, high in strip.ranges) / self._flat, "scallop", scallop)
        self._check_samples()

    def _check_samples(self) -> None:
        """Raise SettingsError where the scallop needs more samples than can be measured: area by interval and
        by sample."""
        samples = self._strip.area / (max(self._flat, self._least) * self._sample)
        if samples > MOST_SAMPLES:
            raise SettingsError(
                say(
                    "scallop {value} needs about {samples} samples of its passes, more than {most}; give a "
                    "larger scallop or check the units of the part",
                    value=Length(self._scallop),
                    samples=Number(samples, ".2g"),
                    most=MOST_SAMPLES,
                ),
                self._scallop,
            )

    def run(self) -> tuple[Floats, tuple[Finding, ...]]:
        for low, high in self._strip.ranges:
            self._cover(low, high)
        return np.array(self._planes), self._findings()

    def _cover(self, low: float, high: float) -> None:
        """Planes from ``low`` to ``high``, the outermost at most half an interval inside.

        Where the last full interval ends too far from the end for that, the march goes back and takes a share
        of each interval on the way there, so that one more plane fits and no single interval is needlessly
        small.
        """
        edge = min(self._step(low + self._inside(low, high), high).interval, high - low)
        start, share, kept = low + 0.5 * edge, 1.0, 0
        planes: list[float] = []
        steps: list[_Step] = []
        for _ in range(REPEATS):
            offsets, more, beyond = self._march(start, high, share)
            planes, steps = planes[:kept] + offsets, steps[:kept] + more
            if beyond <= 0.5 or len(planes) == 1:
                break
            start, share, kept = self._again(planes, share, beyond, low, edge)
            self._strip.rewind(start)
        rest = high - planes[-1]
        if beyond > 0.5 and rest > self._least:
            last = self._step(planes[-1], high)
            steps.append(last)
            planes.append(planes[-1] + min(last.interval, max(rest / (1.0 + SPARE), self._least)))
        self._planes += planes
        self._bound += [step for step in steps if step.height > self._scallop]

    @staticmethod
    def _again(
        planes: list[float], share: float, beyond: float, low: float, edge: float
    ) -> tuple[float, float, int]:
        """Where to march again from, the share of each interval to take, and how many planes before it
        stay."""
        redone = min(len(planes) - 1, STRETCH)
        full = share * redone + beyond
        if redone < len(planes) - 1:
            return planes[-1 - redone], _share(full), len(planes) - 1 - redone
        inset, share = _inset((planes[0] - low) / edge + full)
        return low + inset * edge, share, 0

    def _march(self, offset: float, end: float, share: float) -> tuple[list[float], list[_Step], float]:
        """Offsets from ``offset`` on, the steps between them, and the part of an interval that is left beyond
        the last one."""
        offsets, steps = [offset], list[_Step]()
        while True:
            self._report(len(self._planes) + len(offsets), offset)
            self._strip.pass_by(offset)
            if end - offset <= self._least:
                return offsets, steps, 0.0
            step = self._step(offset, end)
            full = step.interval
            if step.ends:
                full *= math.sqrt(max(AIM * self._scallop / max(step.height, INSIDE * self._scallop), 1.0))
            interval = max(share * full, min(full, self._least))
            if interval >= end - offset:
                return offsets, steps, (end - offset) / full
            offset += interval
            offsets.append(offset)
            steps.append(step)

    def _inside(self, low: float, high: float) -> float:
        return INSIDE * min(self._least, high - low)

    def _step(self, offset: float, end: float) -> _Step:
        """Return the interval from the pass at ``offset`` to the next one, before ``end``: trial, measure,
        correct."""
        here = self._strip.cut(offset, self._sample)
        rest = end - self._inside(offset, end) - offset
        most = min(rest, self._widest)
        predicted = smallest_interval(here, self._strip.across, self._radius, AIM * self._scallop)
        trial = min(max(self._bias * predicted, self._least), most)
        good, bad = _Step(0.0, 0.0, np.zeros(3), False), math.inf
        for left in reversed(range(TRIALS)):
            height, place = scallop_between(here, self._strip.cut(offset + trial, self._sample), self._radius)
            if height <= TOP * self._scallop or trial <= self._least or (not left and not good.interval):
                good = _Step(trial, height, place, trial >= rest)
            else:
                bad = trial
            found = good.interval == trial and height >= BOTTOM * self._scallop
            if found or good.interval >= most or good.interval >= (1.0 - FINE) * bad:
                break
            trial = self._next_trial(trial, height, good.interval, bad)
            trial = min(max(trial, self._least), most)
        self._bias = min(max(good.interval / max(predicted, self._least), 1.0 / WIDEST), WIDEST)
        return good

    def _next_trial(self, trial: float, height: float, good: float, bad: float) -> float:
        """Return the interval at which the square law puts the scallop that is aimed at, or the middle of the
        bracket."""
        change = math.sqrt(AIM * self._scallop / max(height, TINY_HEIGHT * self._scallop))
        trial *= min(max(change, 1.0 / GROWTH), GROWTH)
        return trial if good < trial < bad else 0.5 * (good + bad)

    def _report(self, planes: int, offset: float) -> None:
        _check_count(planes, "scallop", self._scallop)
        now = time.monotonic()
        if now - self._reported > PERIOD:
            low, high = self._strip.ranges[0][0], self._strip.ranges[-1][1]
            self._far = max(
                self._far, (offset - low) / (high - low)
            )  # a march that is repeated does not count back
            self._progress("placing planes", self._far)
            self._reported = now

    def _findings(self) -> tuple[Finding, ...]:
        if not self._bound:
            return ()
        worst = max(self._bound, key=lambda step: step.height)
        x, y, z = (float(v) for v in worst.place)
        template = BOUND_APART if worst.height > self._radius else BOUND
        text = template.say(
            least=Length(self._least),
            count=len(self._bound),
            height=Length(worst.height, ".4g"),
            scallop=Length(self._scallop),
            option=Option("least_interval"),
        )
        value, limit = worst.height, self._scallop
        return (report_finding(Code.LEAST_INTERVAL, text, value, limit, place=(x, y, z)),)


def _share(count: float) -> float:
    """Return the share of each interval to take so that ``count`` full ones end with less than half of one
    left."""
    beyond = count % 1.0
    if 0.25 * SPARE < beyond < 0.5 - 0.25 * SPARE:
        return 1.0
    return min(count / (math.floor(count - 2.0 * SPARE) + 1.0 + SPARE), 1.0)


def _inset(count: float) -> tuple[float, float]:
    """For a part ``count`` full intervals wide: how many the first plane stands inside, and the share of each
    to take."""
    planes = math.floor(count - SPARE)
    spare = count - planes
    if spare > 1.0 - SPARE:
        return 0.5 * SPARE, (count - SPARE) / (planes + 1.0)
    return 0.5 * spare, 1.0
