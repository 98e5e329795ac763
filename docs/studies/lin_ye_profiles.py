# SPDX-License-Identifier: LGPL-2.1-or-later
"""Both strategies on random profiles that one rotary axis cuts: where eqs. (9) and (10) of Lin & Ye help, and
why.

profile   a polyline in the YZ plane, cut by a ball; its steps have lengths that differ up to eight times.
hill, hollow, wavy   the families, LENGTH long: bent one way up, one way down, or both in turn.
arc       a part of a circle of radius ARC; for it alone the radius of curvature is one number.
rig       what turns the tool: the A axis of a table at some depth, or a head. The other rotary axis stands
          still.
depth     of the A axis below the profile's lowest point, mm; None: through the part, at half its height.
ratio     largest deviation of step_weighted, divided by that of facet_mean, on the same profile.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from lin_ye_arc import ARC, BALL, trunnion

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, linear_words, q_to_words
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.orientation.strategies import AxisOptions, tool_axes
from freecad_fiveaxis.core.passes import ContactPath
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath, close_gaps

METHODS = ("facet_mean", "step_weighted")
DEPTHS = (None, 60.0, 150.0, 300.0)
PROFILES, COUNT, LENGTH = 20, 24, 100.0
OPENING = np.radians(100.0)
"""Of the arcs."""
TOOL = 50.0
"""mm, from the gauge point of the head to the ball's centre."""
COEDGE_TOLERANCE = 0.01
"""mm, the default of ``--coedge-tolerance``."""
SHORT = 1e-9
"""mm; a shorter chord has no direction."""


@dataclass(frozen=True)
class Rig:
    """``first`` rad: the rotary word that stands still; the other one leans the tool by ``sense`` x its word
    towards +Y."""

    kinematics: Chain
    first: float
    sense: float


def table(axis_z: float) -> Rig:
    """The trunnion with its A axis at height ``axis_z`` mm and C at rest. A positive A leans the tool towards
    -Y."""
    return Rig(trunnion(-axis_z), 0.0, -1.0)


def head() -> Rig:
    """The fork head with C at 90 deg, so that B leans the tool towards +Y."""
    machine = load_machine("fork_head_bc")
    return Rig(chain(machine, Setup(machine.origin, TOOL)), 0.5 * np.pi, 1.0)


def axis_height(points: Floats, depth: float | None) -> float:
    """z of the A axis, mm."""
    low, high = float(points[:, 1].min()), float(points[:, 1].max())
    return 0.5 * (low + high) if depth is None else low - depth


def depth_name(depth: float | None) -> str:
    """What the tables call it."""
    return "through the part" if depth is None else f"{depth:g} mm below"


# ------------------------------------------------------------------------------------------------ profiles


def _hill(y: Floats, rng: np.random.Generator) -> Floats:
    return np.asarray(rng.uniform(10.0, 30.0) * np.sin(np.pi * y / LENGTH))


def _wavy(y: Floats, rng: np.random.Generator) -> Floats:
    waves = np.arange(1, 5)[:, None]
    height, phase = rng.normal(0.0, 8.0, (4, 1)) / waves**2, rng.uniform(0.0, 2.0 * np.pi, (4, 1))
    return np.asarray((height * np.sin(waves * np.pi * y / LENGTH + phase)).sum(axis=0))


FAMILIES: dict[str, Callable[[Floats, np.random.Generator], Floats]] = {
    "hill": _hill,
    "hollow": lambda y, rng: -_hill(y, rng),
    "wavy": _wavy,
}


def _shares(rng: np.random.Generator, cuts: int) -> Floats:
    """Where the steps end, 0 to 1; each random step is cut into ``cuts`` equal ones."""
    step = np.repeat(rng.uniform(1.0, 8.0, COUNT), cuts)
    return np.concatenate([[0.0], np.cumsum(step)]) / step.sum()


def profile(family: str, seed: int, cuts: int = 1) -> Floats:
    """Points (COUNT x cuts + 1, 2) mm, y and z, of a random profile."""
    rng = np.random.default_rng(seed)
    y = LENGTH * _shares(rng, cuts)
    return np.column_stack([y, FAMILIES[family](y, rng)])


def arc_profile(seed: int) -> Floats:
    """Points (COUNT + 1, 2) mm of a random arc about the work zero, its top at z = ARC."""
    angle = OPENING * (_shares(np.random.default_rng(seed), 1) - 0.5)
    return ARC * np.column_stack([np.sin(angle), np.cos(angle)])


def offset_path(points: Floats) -> OffsetPath:
    """The ball's centre over the profile, its gaps closed: one pass over facets that are strips along X."""
    step = np.diff(points, axis=0)
    across = np.column_stack([-step[:, 1], step[:, 0]]) / np.linalg.norm(step, axis=1)[:, None]
    place = np.stack([points[:-1], points[1:]], axis=1).reshape(-1, 2)
    facet = np.repeat(np.arange(len(step)), 2)
    coedge, nothing = facet + np.tile([0, 1], len(step)), np.zeros(len(facet), np.int64)
    contact = ContactPath(
        _in_space(place), _in_space(across.repeat(2, axis=0)), facet, coedge, facet, nothing, nothing
    )
    strip = np.array([[(1.0, *points[0]), (1.0, *points[-1]), (-1.0, *points[0])]])
    return close_gaps(contact, from_triangles(strip), BALL, COEDGE_TOLERANCE)


def _in_space(flat: Floats) -> Floats:
    return np.column_stack([np.zeros(len(flat)), flat])


# ------------------------------------------------------------------------------------------------ deviations


def leans(path: OffsetPath, strategy: str) -> Floats:
    """Angle (n,) rad of the tool from upright, towards +Y."""
    _, y, z = tool_axes(path, strategy, AxisOptions()).T
    return np.arctan2(y, z)


def deviations(path: OffsetPath, strategy: str, rig: Rig) -> Floats:
    """Deviation (n,) mm of the ball's centre from the chord of each block."""
    lean = leans(path, strategy)
    angles = np.column_stack([np.full(len(lean), rig.first), rig.sense * lean])
    return measure(
        rig.kinematics,
        q_to_words(np.column_stack([linear_words(rig.kinematics, path.centre, angles), angles])),
    ).segment


def estimated(path: OffsetPath, strategy: str, axis_z: float) -> Floats:
    """The estimate of the document for a table, (n,) mm: ``|h alpha^2 / 8 - s alpha / 4|``.

    alpha rad: turn of the block towards +Y, negative in a hollow; s: length of its chord; h: from the A axis
    up to the chord, at right angles to it.
    """
    alpha, chord = np.diff(leans(path, strategy)), np.diff(path.centre, axis=0)[:, 1:]
    y, z = (path.centre[1:, 1:] - 0.5 * chord - (0.0, axis_z)).T
    length = np.linalg.norm(chord, axis=1)
    height = (chord[:, 0] * z - chord[:, 1] * y) / np.maximum(length, SHORT)
    return np.concatenate([[0.0], np.abs(height * alpha**2 / 8.0 - length * alpha / 4.0)])


def largest(family: str, rig: Callable[[Floats], Rig], cuts: int = 1) -> Floats:
    """Largest deviation (PROFILES, 2) mm of both methods, each profile on its own rig."""
    return np.array(
        [_worst(points, rig(points)) for points in (profile(family, seed, cuts) for seed in range(PROFILES))]
    )


def largest_below(family: str, depth: float | None, cuts: int = 1) -> Floats:
    """The same on the table, its axis at a depth."""
    return largest(family, lambda points: table(axis_height(points, depth)), cuts)


def largest_on_arcs(height: float) -> Floats:
    """Largest deviation (PROFILES, 2) mm on arcs whose top is ``height`` radii above the A axis, for the
    ball's centre."""
    rig = table((1.0 - height) * (ARC + BALL))
    return np.array([_worst(arc_profile(seed), rig) for seed in range(PROFILES)])


def _worst(points: Floats, rig: Rig) -> list[float]:
    path = offset_path(points)
    return [float(deviations(path, method, rig).max()) for method in METHODS]
