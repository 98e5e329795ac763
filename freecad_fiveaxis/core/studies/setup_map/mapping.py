# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of setups: the grid, the best work zero at each turn, and what to recommend."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import ReachError, SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import Angle, Length, Option, say
from freecad_fiveaxis.core.base.spread import spread
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .collisions import Look, choose_free
from .driven import Cost, Posting, part_box
from .search import Found
from .setups import Kind, Region, SetupMap, recommend_setup
from .trials import Ground, Trial, Tried, carry_out, drive, trials_of

BELOW = 1e-6
"""mm below the table that are rounding."""
Collide = Callable[[float, Setup, Chain, Program], tuple[Finding, ...]]
"""What of the machine is hit at a turn, rad, with the program of a setup."""
NO_COST = Cost(math.nan, math.nan, math.nan, math.nan)


@dataclass(frozen=True, eq=False)
class _Row:
    origin: Floats
    turn: float
    cost: Cost
    rewinds: int
    kind: Kind


def setup_map(
    path: CLPath, machine: Machine, base: Setup, region: Region, posting: Posting, enough: float = 0.0,
    progress: Progress = silent, table: float | None = None, executor: Executor | None = None,
    collide: Collide | None = None, held: float = math.inf,
) -> SetupMap:  # fmt: skip
    """Return what the program of ``path`` costs wherever the part may stand, and where it should.

    ``path`` in the work frame of the present setup ``base``, turn 0; the tool length is that of ``base``.
    Each setup of the grid is posted, rounded and measured as a full run would; then the least deviation of
    each turn is searched over the whole region, with a proof (module ``search``). ``enough`` mm: setups below
    this deviation are equally good, and time decides. ``table`` mm: height of the table's face in the machine
    frame; no setup below it is searched or recommended, nor one in which fixtures, whose lowest place is
    ``held`` mm high in the work frame, reach farther below it than in the present setup. ``collide``: what
    of the machine is hit in a setup; no setup in which that is anything is recommended. ``executor``: whose
    workers do the trials, with the same result to the last bit; None: they are done here. Raises
    SettingsError for a path without rows and a negative ``enough``, ReachError where no turn is within the
    rotary limits.
    """
    if not len(path.tip):
        raise SettingsError(say("there is no path to set up: it has no rows"), 0)
    if not enough >= 0.0:
        raise SettingsError(
            say("a deviation of {enough} cannot be enough; give 0 or more", enough=Length(enough)), enough
        )
    present, bottom = np.array(base.origin, float), float(part_box(path, posting.part)[0][2])
    stand = _Stand(table, bottom, held, base.origin[2])
    ground = Ground(path, machine, base, posting, stand.above(region), enough)
    trials = list(trials_of(region, present, ground.searched is not None))
    tried = spread(
        carry_out, ground, trials, executor, progress, "setup map", [trial.weight for trial in trials]
    )
    rows = [row for trial, one in zip(trials, tried, strict=True) for row in _rows(trial, one)]
    found = [one.found for one in tried if one.found is not None]
    lost = {
        (trial.kind, trial.turn): one.lost
        for trial, one in zip(trials, tried, strict=True)
        if one.lost is not None
    }
    if all((Kind.GRID, turn) in lost for turn in region.turns):
        raise lost[Kind.GRID, region.turns[-1]]
    look = None if collide is None else _look(ground, collide, progress)
    return _build_map(
        machine,
        base,
        region,
        enough,
        sorted(rows, key=lambda row: row.kind),
        found,
        lost,
        stand,
        look,
        posting.above,
    )


def _look(ground: Ground, collide: Collide, progress: Progress) -> Look:
    """Return what the program of a turn and a work zero hits."""

    def look(turn: float, origin: Floats) -> tuple[Finding, ...]:
        driven = drive(ground, turn, progress)
        kinematics = driven.kinematics(origin)
        return collide(turn, driven.setup(origin), kinematics, driven.post(kinematics)[1])

    return look


@dataclass(frozen=True)
class _Stand:
    """``table`` mm: height of its face, machine frame, None: not known; ``bottom`` mm: the part's lowest
    place, ``held`` mm: that of its fixtures, work frame; ``present`` mm: the present Z of the work zero."""

    table: float | None
    bottom: float
    held: float
    present: float

    @property
    def least(self) -> float:
        """The least Z of a work zero, mm. Fixtures may reach as far below the face as they do now, as bolts
        in its slots, where the part does not."""
        if self.table is None:
            return -math.inf
        of_part, of_fixtures = self.table - self.bottom, self.table - self.held
        return max(of_part, of_fixtures if self.present < of_part else min(of_fixtures, self.present))

    def above(self, region: Region) -> Region | None:
        """Return what of the region is not below the table; None where nothing is."""
        low, high = region.low, region.high
        if high[2] < self.least - BELOW:
            return None
        return replace(region, low=(low[0], low[1], min(max(low[2], self.least), high[2])))


def _rows(trial: Trial, tried: Tried) -> Iterator[_Row]:
    """Yield the rows that came of one trial."""
    if trial.zeros is None:
        if tried.origin is not None:
            yield _Row(tried.origin, trial.turn, tried.costs[0], tried.rewinds, Kind.FOUND)
        return
    for origin, cost in zip(trial.zeros, tried.costs or [NO_COST] * len(trial.zeros), strict=True):
        yield _Row(origin, trial.turn, cost, tried.rewinds, trial.kind)


def _build_map(
    machine: Machine, base: Setup, region: Region, enough: float, rows: list[_Row], found: list[Found],
    lost: dict[tuple[Kind, float], ReachError], stand: _Stand, look: Look | None, above: float,
) -> SetupMap:  # fmt: skip
    origin, costs = np.array([row.origin for row in rows]), [row.cost for row in rows]
    deviation, time = np.array([cost.deviation for cost in costs]), np.array([cost.time for cost in costs])
    rewinds, within = np.array([row.rewinds for row in rows]), np.array([cost.within for cost in costs])
    stands = origin[:, 2] >= stand.least - BELOW
    eligible = within & stands & region.holds(origin)
    turn = np.array([row.turn for row in rows])
    choice = choose_free(
        lambda able: recommend_setup(origin, base.origin, deviation, time, rewinds, able, enough, turn),
        origin, turn, eligible, bool(within[0] & stands[0]), look,
    )  # fmt: skip
    least = min((one.least for one in found if one.origin is not None), default=math.nan)
    best, none_free = choice.best, choice.best is None and bool(eligible.any())
    findings = (
        *(() if none_free else _findings(region, origin, best, found)),
        *choice.findings,
        *_table_findings(stand, stands),
        *_report_lost(lost),
    )
    return SetupMap(
        machine=machine.name, base=base, region=region, origin=origin, turn=turn,
        max_deviation=deviation, rotary_travel=np.array([cost.travel for cost in costs]), time=time,
        over=np.array([cost.over for cost in costs]), within_limits=within, stands=stands, rewinds=rewinds,
        kind=np.array([row.kind for row in rows], np.int8), best=best, least=least, table=stand.table,
        bottom=stand.bottom, hits=choice.hits, findings=findings, least_hit=choice.least, above=above,
        enough=enough,
    )  # fmt: skip


def _findings(region: Region, origin: Floats, best: int | None, found: list[Found]) -> Iterator[Finding]:
    if best is None and not found:
        text = say(
            "No work zero of the setup region puts the part on the table. Move the region up ({origin}), or "
            "widen it.",
            origin=Option("origin"),
        )
        yield report_finding(Code.NO_SETUP_ON_THE_TABLE, text)
        return
    if best is None:
        over = min(one.over for one in found)
        text = say(
            "No work zero of the setup region keeps the linear axes within their limits: they are exceeded "
            "by {over} at least. Widen the region ({region}), begin with a work zero that brings the part "
            "near the rotary axes ({origin}), turn the part, or take a larger machine.",
            over=Length(over, ".4g"),
            origin=Option("origin"),
            region=Option("region"),
        )
        yield report_finding(Code.NO_SETUP_WITHIN_LIMITS, text, over, 0.0)
        return
    low, high = np.array(region.low), np.array(region.high)
    edges = [
        f"{letter} {end[axis]:g}"
        for axis, letter in enumerate("XYZ")
        for end in (low, high)
        if high[axis] > low[axis] and abs(origin[best, axis] - end[axis]) < 1e-6
    ]
    if edges:
        text = say(
            "The recommended setup lies on the edge of the region ({edges}); beyond it may be a better one.",
            edges=", ".join(edges),
        )
        yield report_finding(Code.SETUP_AT_EDGE, text, float(len(edges)))


def _table_findings(stand: _Stand, stands: Bools) -> Iterator[Finding]:
    if stand.table is None:
        text = say(
            "The height of the table is not known: check that the part stands on it, or give {table_height}.",
            table_height=Option("table_height"),
        )
        yield report_finding(Code.TABLE_UNKNOWN, text)
    elif not stands[0]:
        text = say(
            "In the present setup the part reaches below the table: its work zero must stand at Z {least} "
            "or higher. Give another {origin}.",
            least=Length(stand.least),
            origin=Option("origin"),
        )
        yield report_finding(Code.PART_BELOW_TABLE, text, stand.least)


def _report_lost(lost: dict[tuple[Kind, float], ReachError]) -> Iterator[Finding]:
    for (_, turn), error in lost.items():
        angle = math.degrees(turn)
        text = say(
            "With the part turned by {angle} the rotary limits allow no way: {error}.",
            angle=Angle(angle),
            error=error,
        )
        yield report_finding(Code.TURN_OUT_OF_REACH, text, angle)
