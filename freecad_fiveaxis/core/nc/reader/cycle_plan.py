# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a drilling or boring cycle does in a hole: its rapids and feeds along the drilling axis, whatever
language called it.

Sources: those of :mod:`.canned_cycles` and :mod:`.siemens_cycles`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

READ = (730, 740, 810, 820, 830, 840, 850, 860, 880, 890)
"""The cycles that are written out; the others stay as they are, and are named."""
FINE = 760
"""Fine boring on Fanuc and Haas: as G86, but the spindle stops oriented and the tool leaves the wall before
it rises."""
PECKING = (730, 830)
EQUAL_HEIGHT = 1e-6
"""mm, inch where a Siemens call is in inches: heights of a hole that differ by less are one."""
Steps = list[tuple[bool, float]]
"""Whether it is a rapid, and the height where it ends."""


@dataclass(frozen=True)
class Ways:
    """What controls do differently. ``to_r``: the level at first is R (G99), not the initial one; ``peck``:
    mm that a rapid keeps above the depth reached (Fanuc: parameters 5114, 5115; Haas: settings 22, 52);
    ``rises``: below R, LinuxCNC rises first; ``feeds_out``: cycles that feed out to the level, not to R;
    ``stays``: G88 ends at the bottom; ``repeats``: their letter; ``read``: the cycles that are written
    out."""

    to_r: bool = False
    peck: float = 1.0
    rises: bool = False
    feeds_out: tuple[int, ...] = ()
    stays: bool = False
    repeats: str = "L"
    read: tuple[int, ...] = READ


LINUXCNC = Ways(True, 0.254, True, (740, 840, 890), True)
WAYS = {"fanuc": Ways(repeats="K", read=(*READ, FINE)), "haas": Ways(read=(*READ, FINE))}


@dataclass(eq=False)
class Hole:
    """What stays from hole to hole, mm: the words ``programmed_r``, ``programmed_z``, ``q``; the heights
    ``initial``, ``r`` and ``z``."""

    code: int = 0
    initial: float = 0.0
    programmed_r: float = np.nan
    programmed_z: float = np.nan
    q: float = np.nan
    r: float = np.nan
    z: float = np.nan


def steps_of(hole: Hole, clear: float, ways: Ways) -> Steps:
    """Return what a cycle does between R and the level, as (fast, height)."""
    r, z, code = hole.r, hole.z, hole.code
    if code in PECKING:
        return [*pecks(r, even_depths(r, z, hole.q), z, ways.peck, code == 830), (True, clear)]
    if code == 880 and ways.stays:
        return [(False, z)]
    if code in ways.feeds_out:
        return [(False, z), (False, clear)]
    if code in (740, 840, 850, 890):
        return [(False, z), (False, r), *([(True, clear)] if clear != r else [])]
    return [(False, z), (True, clear)]


def even_depths(r: float, z: float, q: float) -> list[float]:
    """Return the depths above ``z`` that pecks of ``q`` reach."""
    depths: list[float] = (r - q * np.arange(1, int(np.ceil((r - z) / q - 1e-9)))).tolist()
    return depths


def pecks(r: float, depths: Sequence[float], z: float, back: float, full: bool, fast: bool = True) -> Steps:
    """Down to each of the depths and to ``z``; between, up to R and down again (``full``), or up by ``back``
    only, by rapid or feed (``fast``)."""
    moves = Steps()
    for depth in depths:
        moves += [(False, depth), *([(True, r)] if full else []), (fast, min(depth + back, r))]
    return [*moves, (False, z)]
