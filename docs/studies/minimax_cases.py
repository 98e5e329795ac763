# SPDX-License-Identifier: LGPL-2.1-or-later
"""What docs/minimax.md is made from: facet_mean and minimax on whole parts, and on profiles that one rotary
axis cuts.

part      the whole pipeline through, by ``lin_ye_parts.mill``: the deviation of the posted program's blocks.
profile   of ``lin_ye_profiles``, on an A-B table whose B axis has no travel: one rotary axis.
optimum   of a profile: the smallest largest deviation of all leans on a lattice, by an exact dynamic
          programme. It shares nothing with the core but the path: all moves lie in a plane, where a turn is a
          product of complex numbers.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace

import lin_ye_parts as parts
import lin_ye_profiles as profiles
import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, linear_words, q_to_words
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.orientation.minimax import minimax_axes
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, tool_axes
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

TILT = 5.0
"""deg, the default of ``--max-tilt``."""
TILTS = (0.2, 0.5, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0)
SEEDS = range(6)
FAMILIES = ("hill", "wavy", "hollow")
HALF = {"direction": 90.0, "stepover": 25.0}
"""The half cylinder: across it, so that one axis turns. Its passes are all alike."""
SHARES = (0.25, 0.5, 0.75)
"""Where on a block the dynamic programme looks."""


def part(
    name: str, table: str, depth: float | None, tilt: float = TILT, **others: float
) -> tuple[parts.Cuts, parts.Cuts]:
    """The cutting blocks by facet_mean and by minimax."""
    return parts.mill(name, table, "facet_mean", depth, **others), parts.mill(
        name, table, "minimax", depth, max_tilt=tilt, **others
    )


def ratio(both: tuple[parts.Cuts, parts.Cuts]) -> float:
    """How many times smaller the largest deviation became."""
    return float(both[0].deviation.max() / both[1].deviation.max())


# -------------------------------------------------------------------------------------------- one rotary axis


@functools.cache
def _table() -> tuple[float, float, float]:
    x, y, z = parts.MACHINE.rotary[1].point
    return x, y, z


def one_axis(axis_z: float) -> Chain:
    """The A-B table, its A axis at height ``axis_z`` mm and free, its B axis locked."""
    x, y, z = _table()
    kinematics = chain(parts.table_ab(), Setup((x, y, z - axis_z)))
    low, high = kinematics.low.copy(), kinematics.high.copy()
    low[3] = high[3] = 0.0
    low[4], high[4] = -np.pi, np.pi
    return replace(kinematics, low=low, high=high)


@dataclass(frozen=True, eq=False)
class Profile:
    """One pass over a profile: ``path``, the height of the A axis, and the leans (n,) rad towards +Y of both
    methods."""

    path: OffsetPath
    axis_z: float
    mean: Floats
    found: Floats

    def largest(self, lean: Floats) -> float:
        """The largest deviation, mm, by the core's own measure."""
        kinematics, angles = one_axis(self.axis_z), np.column_stack([0.0 * lean, -lean])
        words = q_to_words(np.column_stack([linear_words(kinematics, self.path.centre, angles), angles]))
        return float(measure(kinematics, words).segment.max())


@functools.cache
def profile(family: str, seed: int, depth: float | None, tilt: float = TILT) -> Profile:
    """A random profile with its leans."""
    points = profiles.profile(family, seed)
    path, axis_z = profiles.offset_path(points), profiles.axis_height(points, depth)
    axis = tool_axes(path, "facet_mean", AxisOptions())
    found = minimax_axes(path, axis, one_axis(axis_z), 0.0, np.radians(tilt))
    return Profile(path, axis_z, _lean(axis), _lean(found))


def _lean(axis: Floats) -> Floats:
    return np.arctan2(axis[:, 1], axis[:, 2])


def optimum(case: Profile, tilt: float, step: float) -> float:
    """The smallest largest deviation, mm, of all leans that are ``step`` deg apart, each within ``tilt`` deg
    of its range."""
    y, z = case.path.centre[:, 1], case.path.centre[:, 2] - case.axis_z
    place, lattice = z + 1j * y, np.radians(step) * np.arange(-round(110.0 / step), round(110.0 / step) + 1)
    ends = np.sort(np.stack([_lean(case.path.before), _lean(case.path.after)]), axis=0)
    room, wall = np.radians(tilt) + 1e-9, 0.5 * np.pi
    low, high = np.maximum(ends[0] - room, ends[1] - wall), np.minimum(ends[1] + room, ends[0] + wall)
    states = [lattice[(lattice >= one) & (lattice <= two)] for one, two in zip(low, high, strict=True)]
    value = np.zeros(len(states[0]))
    for row in range(1, len(states)):
        bows = _bows(place[row - 1], states[row - 1], place[row], states[row])
        value = np.maximum(value[:, None], bows).min(axis=0)
    return float(value.min())


def _bows(start: complex, one: Floats, end: complex, two: Floats) -> Floats:
    """Distances (m, m') mm from the chord of one block, from each lean of ``one`` to each of ``two``.

    Leaning the tool turns the work the other way: a work point p stands at ``p exp(-i lean)``, where the
    linear axes take the ball straight and evenly; back in the work that is ``exp(i lean(u)) ((1 - u) p0
    exp(-i lean0) + u p1 exp(-i lean1))``.
    """
    first, last = start * np.exp(-1j * one)[:, None], end * np.exp(-1j * two)[None]
    chord = end - start
    worst = np.zeros((len(one), len(two)))
    for u in SHARES:
        turn = np.exp(1j * ((1.0 - u) * one[:, None] + u * two[None]))
        off = turn * ((1.0 - u) * first + u * last) - start
        foot = np.clip((off * np.conj(chord)).real / max(abs(chord) ** 2, 1e-300), 0.0, 1.0)
        np.maximum(worst, np.abs(off - foot * chord), out=worst)
    return worst
