# SPDX-License-Identifier: LGPL-2.1-or-later
"""The trials of which a map of setups is made: each stands by itself, so any worker may do it.

ground    what all trials of a map have in common.
trial     some work zeros at one turn, each of them posted and measured; or the search for the best one there.

Nearly all the time of a map goes into them: into measuring, some 0.1 s a work zero where a path has 25,000
rows, and as much again for each of the two dozen steps of a search. The path at one turn is driven once by
each worker.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from freecad_fiveaxis.core.base.errors import ReachError
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import Setup
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .driven import Cost, Driven, Posting, drive_turned
from .search import Found, best_origin
from .setups import Kind, Region

SEARCH_WORTH = 16
"""Setups of the grid that take as long as one search: for the progress only."""
SET_DECIMALS = 3
"""Of a work zero, mm: nobody sets one finer than a micrometre."""
TOGETHER = 4
"""Work zeros of a trial, at least: few, so that no worker waits long for the last one."""
MOST_TRIALS = 512
"""Of a map, about: so many that their way to the workers and back takes no time worth telling."""


@dataclass(frozen=True, eq=False)
class Ground:
    """``path`` as it lies at turn 0, ``base`` the present setup, ``searched`` what of the region is searched
    (None: nothing), ``enough`` mm as in :func:`~.mapping.setup_map`. ``driven``: the path at the last turn it
    was driven at, or why it cannot."""

    path: CLPath
    machine: Machine
    base: Setup
    posting: Posting
    searched: Region | None
    enough: float
    driven: dict[float, Driven | ReachError] = field(default_factory=dict, repr=False)


@dataclass(frozen=True, eq=False)
class Trial:
    """``zeros`` (k, 3) mm to be measured at this ``turn`` rad; None: the best one is searched."""

    turn: float
    kind: Kind
    zeros: Floats | None = None

    @property
    def weight(self) -> float:
        """How long it takes, in setups of the grid."""
        return SEARCH_WORTH if self.zeros is None else len(self.zeros)


@dataclass(frozen=True, eq=False)
class Tried:
    """``costs`` (k,) of the work zeros, or of the one that was found at ``origin`` (3,) mm; ``found``: of a
    search alone; ``lost``: why the turn is out of reach, and then there is nothing else."""

    costs: tuple[Cost, ...] = ()
    rewinds: int = 0
    found: Found | None = None
    origin: Floats | None = None
    lost: ReachError | None = None


def trials_of(region: Region, present: Floats, searched: bool) -> Iterator[Trial]:
    """All trials of a map, those of a turn side by side, and its search first: that one takes longest."""
    yield Trial(0.0, Kind.PRESENT, present[None])
    grid = region.grid()
    together = max(TOGETHER, -(-region.size // MOST_TRIALS))
    for turn in region.turns:
        if searched:
            yield Trial(turn, Kind.GRID)
        for first in range(0, len(grid), together):
            yield Trial(turn, Kind.GRID, grid[first : first + together])


def carry_out(ground: Ground, trial: Trial, progress: Progress) -> Tried:
    """Do one trial; a turn out of reach is a result."""
    progress("", 0.0)
    try:
        driven = drive(ground, trial.turn, progress)
    except ReachError as error:
        return Tried(lost=error)
    if trial.zeros is not None:
        return Tried(tuple(_costs(driven, trial.zeros, progress)), driven.rewinds)
    assert ground.searched is not None
    found = best_origin(driven, ground.searched, np.array(ground.base.origin, float), ground.enough, progress)
    if found.origin is None:
        return Tried((), driven.rewinds, found)
    origin, cost = _to_set(driven, ground.searched, found.origin)
    return Tried((cost,), driven.rewinds, found, origin)


def _costs(driven: Driven, zeros: Floats, progress: Progress) -> Iterator[Cost]:
    for at, origin in enumerate(zeros):
        progress("", at / len(zeros))
        yield driven.cost(origin)


def _to_set(driven: Driven, region: Region, found: Floats) -> tuple[Floats, Cost]:
    """Return the work zero in steps that somebody can set; the one that was found where these would leave the
    limits."""
    origin = np.clip(np.round(found, SET_DECIMALS), region.low, region.high)
    cost = driven.cost(origin)
    return (origin, cost) if cost.within else (found, driven.cost(found))


def drive(ground: Ground, turn: float, progress: Progress) -> Driven:
    """Drive the path at one turn; the last one is kept. Threads may both drive the same: it is the same,
    too."""
    solved = ground.driven.get(turn)
    if solved is None:
        try:
            solved = drive_turned(
                ground.path, ground.machine, ground.base, ground.posting, turn, _without_share(progress)
            )
        except ReachError as error:
            solved = error
        ground.driven.clear()
        ground.driven[turn] = solved
    if isinstance(solved, ReachError):
        raise solved
    return solved


def _without_share(progress: Progress) -> Progress:
    """Return the progress of a stage that counts for nothing, but may be cancelled."""
    return lambda stage, fraction: progress(stage, 0.0)
