# SPDX-License-Identifier: LGPL-2.1-or-later
"""Both strategies on random profiles that one rotary axis cuts: where eqs. (9) and (10) of Lin & Ye help, and why.

profile   a polyline in the YZ plane, LENGTH long, of COUNT steps whose lengths differ up to eight times.
hill, hollow, wavy   the families: bent one way up, one way down, or both in turn.
depth     of the A axis below the profile's lowest point, mm; None: through the part, at half its height.
ratio     largest deviation of step_weighted, divided by that of facet_mean, on the same profile.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from lin_ye_arc import BALL, trunnion

from freecad_fiveaxis.core.coedge import OffsetPath, close_gaps
from freecad_fiveaxis.core.deviation import measure
from freecad_fiveaxis.core.kinematics import linear_words, q_to_words
from freecad_fiveaxis.core.mesh import from_triangles
from freecad_fiveaxis.core.passes import ContactPath
from freecad_fiveaxis.core.records import Floats
from freecad_fiveaxis.core.tool_axis import AxisOptions, tool_axes

LENGTH, COUNT = 100.0, 24
PROFILES = 20
COEDGE_TOLERANCE = 0.01
SHORT = 1e-9
"""mm; a shorter chord has no direction."""
DEPTHS = (None, 60.0, 150.0, 300.0)
METHODS = ("facet_mean", "step_weighted")


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


def profile(family: str, seed: int, cuts: int = 1) -> Floats:
    """Points (COUNT x cuts + 1, 2) mm, y and z, of a random profile; each of its steps cut into ``cuts`` on the same curve."""
    rng = np.random.default_rng(seed)
    step = np.repeat(rng.uniform(1.0, 8.0, COUNT), cuts)
    y = np.concatenate([[0.0], np.cumsum(step)]) * (LENGTH / step.sum())
    return np.column_stack([y, FAMILIES[family](y, rng)])


def contact_path(points: Floats) -> ContactPath:
    """The profile as one pass over facets that are strips along X: entry and exit of each."""
    step = np.diff(points, axis=0)
    across = np.column_stack([-step[:, 1], step[:, 0]]) / np.linalg.norm(step, axis=1)[:, None]
    place = np.stack([points[:-1], points[1:]], axis=1).reshape(-1, 2)
    facet = np.repeat(np.arange(len(step)), 2)
    coedge = facet + np.tile([0, 1], len(step))
    nothing = np.zeros(len(facet), np.int64)
    return ContactPath(_in_space(place), _in_space(across.repeat(2, axis=0)), facet, coedge, facet, nothing, nothing)


def _in_space(flat: Floats) -> Floats:
    return np.column_stack([np.zeros(len(flat)), flat])


def offset_path(points: Floats) -> OffsetPath:
    """The ball's centre over the profile, its gaps closed."""
    y, z = points.T
    strip = np.array([[[x, y[i], z[i]] for x, i in ((-1.0, 0), (1.0, 0), (1.0, -1))]])
    return close_gaps(contact_path(points), from_triangles(strip), BALL, COEDGE_TOLERANCE)


def height_of_axis(points: Floats, depth: float | None) -> float:
    """z of the A axis, mm."""
    low, high = float(points[:, 1].min()), float(points[:, 1].max())
    return 0.5 * (low + high) if depth is None else low - depth


def deviations(path: OffsetPath, strategy: str, axis_z: float) -> tuple[Floats, Floats]:
    """Deviation (n,) mm of every block from its chord, measured, and by the estimate of the document.

    The estimate: ``|alpha (h alpha - 2 s)| / 8``, for a turn alpha (rad), a chord s, and h from the A axis up to the chord,
    at right angles to it.
    """
    axis = tool_axes(path, strategy, AxisOptions())
    links = trunnion(-axis_z)
    angles = np.column_stack([np.zeros(len(axis)), np.arctan2(-axis[:, 1], axis[:, 2])])
    words = q_to_words(np.column_stack([linear_words(links, path.centre, angles), angles]))
    measured = measure(links, words).segment
    alpha, chord = -np.diff(angles[:, 1]), np.diff(path.centre, axis=0)
    middle, length = path.centre[1:] - 0.5 * chord, np.linalg.norm(chord, axis=1)
    level = (chord[:, 1] * (middle[:, 2] - axis_z) - chord[:, 2] * middle[:, 1]) / np.maximum(length, SHORT)
    estimate = 0.125 * np.abs(alpha * (level * alpha - 2.0 * length))
    return measured, np.concatenate([[0.0], estimate])


def largest(family: str, depth: float | None, cuts: int = 1) -> Floats:
    """Largest deviation (PROFILES, 2) mm of both methods."""
    worst = np.empty((PROFILES, 2))
    for seed in range(PROFILES):
        points = profile(family, seed, cuts)
        path = offset_path(points)
        worst[seed] = [deviations(path, method, height_of_axis(points, depth))[0].max() for method in METHODS]
    return worst


def depth_name(depth: float | None) -> str:
    """What the tables call it."""
    return "through the part" if depth is None else f"{depth:g} mm below"
