# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reach map: where on the part the tool gets at all, before any pass is computed, and what is in the way elsewhere.

place     the surface is divided into triangles no larger than a spacing; each stands for its middle with its facet's normal.
          There the cutter is set on the part with many axes, the facet's normal first, then ever farther from it.
obstacle  what ends the tries: the one that the luckiest axis met. An axis first has to be within the machine's limits, the tool
          then above the table, then cutter, shank and holder out of the part.

It is as fine as its places and axes: what it calls reachable is (that axis was tried), what it does not may still be, under an
axis between those tried.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.collision.fixtures import Fixture, join_obstacles
from freecad_fiveaxis.core.collision.obstacles import Obstacle, Reacher, enters, obstacles
from freecad_fiveaxis.core.collision.rest_material import surface_samples
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import Body, round_piece

TILTS = tuple(math.radians(tilt) for tilt in (0.0, 10.0, 20.0, 30.0, 45.0, 60.0, 80.0))
"""rad: how far from the facet's normal the tool is tried, the least first."""

SPOKES = 8
"""Ways to either side of each tilt."""

PLACES = 10_000
"""Squares of the spacing into which the surface is divided, about; each holds two or three of the triangles."""

FINEST = 0.1
"""Of the cutter's radius: places are not laid closer than that, whatever the part's size."""

BATCH = 2048
"""Places tried at a time."""

UPRIGHT = 1e-6
"""rad: no tilt that counts, but it says on which side of a flat bottom the contact lies."""

TRIED = 1000
"""Places, about, at which a tool that sticks out farther is tried."""

LONGER = (5.0, 10.0, 20.0, 40.0, 80.0)
"""mm: so much farther the tool is tried to stick out where only the holder is in the way."""


@dataclass(frozen=True, eq=False)
class ReachMap:
    """Of each of k places: ``point`` (k, 3) mm, ``facet`` (k,), ``area`` (k,) mm2; ``obstacle`` (k,) of :class:`Obstacle`;
    ``tilt`` (k,) rad and unit ``axis`` (k, 3) of the first axis that is free, NaN where there is none. ``longer``: mm that the
    tool would have to stick out farther, and mm2 that it reaches then besides; ``spacing`` mm."""

    point: Floats
    facet: Ints
    area: Floats
    obstacle: Ints
    tilt: Floats
    axis: Floats
    longer: tuple[tuple[float, float], ...]
    spacing: float

    def area_of(self, obstacle: Obstacle) -> float:
        """mm2."""
        return float(self.area[self.obstacle == obstacle].sum())


def reach_map(
    mesh: Mesh, reacher: Reacher, facets: Bools | None = None, progress: Progress = silent, fixtures: Sequence[Fixture] = ()
) -> ReachMap:
    """Where the tool gets on these ``facets`` (f,), None: on all; ``fixtures``, work frame, are in its way as the part is. Raises
    SettingsError for sizes that no tool has."""
    spacing = _spacing(mesh, reacher.cutter, facets)
    point, facet, area = surface_samples(mesh, spacing, facets)
    tree, normal = facet_tree(join_obstacles(mesh, fixtures)), mesh.normal[facet]
    obstacle, tilt = np.full(len(point), int(Obstacle.LIMITS)), np.full(len(point), np.nan)
    axis = np.full((len(point), 3), np.nan)
    for part in batches(len(point)):
        progress("reach", 0.0)
        obstacle[part][_too_tight(reacher, tree, point[part], normal[part])] = Obstacle.CUTTER
    open_ = np.flatnonzero(obstacle == Obstacle.LIMITS)
    for k, angle in enumerate(TILTS):
        for part in batches(len(open_)):
            progress("reach", (k + part.start / len(open_)) / (len(TILTS) + 1))
            _try(reacher, tree, point, normal, angle, open_[part], obstacle, tilt, axis)
        open_ = open_[obstacle[open_] != Obstacle.NONE]
    longer = tuple(_longer(reacher, tree, point, normal, area, obstacle, progress))
    progress("reach", 1.0)
    return ReachMap(point, facet, area, obstacle, tilt, axis, longer, spacing)


def batches(count: int) -> list[slice]:
    """So many places at a time that a stop is heard soon."""
    return [slice(first, min(first + BATCH, count)) for first in range(0, count, BATCH)]


def _spacing(mesh: Mesh, cutter: Cutter, facets: Bools | None) -> float:
    area = float(mesh.area.sum() if facets is None else mesh.area[facets].sum())
    return max(math.sqrt(area / PLACES), FINEST * cutter.radius)


def _too_tight(reacher: Reacher, tree: FacetTree, point: Floats, normal: Floats) -> Ints:
    """The places (k,) where a ball end itself enters the part: no axis helps. Of other cutters nothing is known beforehand."""
    cutter = reacher.cutter
    if cutter.ring > 0.0:
        return np.empty(0, np.int64)
    ball = Body((round_piece(0.0, cutter.corner, cutter.corner),))
    return np.flatnonzero(enters(ball, tree, point, normal, reacher.limit))


def _try(
    reacher: Reacher, tree: FacetTree, point: Floats, normal: Floats, angle: float, open_: Ints, obstacle: Ints, tilt: Floats,
    axis: Floats,
) -> None:  # fmt: skip
    """Set the tool on the ``open_`` places (k,) with all axes of that angle; what is found goes into obstacle, tilt and axis."""
    turned = tried_axes(normal[open_], angle, reacher.cutter.ring)
    ways = turned.shape[1]
    place, turned = np.repeat(open_, ways), turned.reshape(-1, 3)
    met = obstacles(reacher, tree, point[place], normal[place], turned).reshape(-1, ways)
    best = met.argmax(axis=1)
    farthest = met.max(axis=1, initial=0)
    obstacle[open_] = np.maximum(obstacle[open_], farthest)
    free = farthest == Obstacle.NONE
    tilt[open_[free]] = angle
    axis[open_[free]] = turned.reshape(-1, ways, 3)[np.flatnonzero(free), best[free]]


def tried_axes(normal: Floats, angle: float, ring: float) -> Floats:
    """Unit axes (n, ways, 3) of that angle (rad) to unit ``normal`` (n, 3). Upright, a bottom with a ``ring`` (mm) may touch with
    its middle or with its edge on any side."""
    if angle > 0.0:
        return tilted_axes(normal, angle, SPOKES)
    edges = [tilted_axes(normal, UPRIGHT, SPOKES)] if ring > 0.0 else []
    return np.concatenate([normal[:, None], *edges], axis=1)


def tilted_axes(normal: Floats, angle: float, ways: int) -> Floats:
    """Unit axes (n, ways, 3) that make this angle (rad) with unit ``normal`` (n, 3), evenly about it."""
    least = np.eye(3)[np.abs(normal).argmin(axis=1)]
    one = np.cross(normal, least)
    one /= np.linalg.norm(one, axis=1)[:, None]
    two = np.cross(normal, one)
    turn = np.arange(ways) * (2.0 * math.pi / ways)
    out = one[:, None] * np.cos(turn)[:, None] + two[:, None] * np.sin(turn)[:, None]
    return np.asarray(math.cos(angle) * normal[:, None] + math.sin(angle) * out)


def _longer(
    reacher: Reacher, tree: FacetTree, point: Floats, normal: Floats, area: Floats, obstacle: Ints, progress: Progress
) -> list[tuple[float, float]]:
    """How far the tool would have to stick out at most, mm, and the area, mm2, that it reaches then of what only the holder is in
    the way of: an estimate from TRIED of those places. A shank as wide as the one there is, or as the cutter, fills the gap."""
    held = np.flatnonzero(obstacle == Obstacle.HOLDER)
    rows = held[:: max(1, len(held) // TRIED)]
    each, found, reached = float(area[held].sum()) / max(float(area[rows].sum()), 1e-30), list[tuple[float, float]](), 0.0
    width = reacher.shank[-1][0] if reacher.shank else reacher.cutter.diameter
    for k, step in enumerate(LONGER):
        if not len(rows):
            break
        progress("reach", (len(TILTS) + k / len(LONGER)) / (len(TILTS) + 1))
        longer = replace(reacher, shank=(*reacher.shank, (width, step)))
        met, tilt, axis = obstacle.copy(), np.empty(len(point)), np.empty((len(point), 3))
        for angle in TILTS:
            _try(longer, tree, point, normal, angle, rows[met[rows] != Obstacle.NONE], met, tilt, axis)
        free = met[rows] == Obstacle.NONE
        if free.any():
            reached += each * float(area[rows[free]].sum())
            found.append((step, reached))
        rows = rows[~free]
    return found
