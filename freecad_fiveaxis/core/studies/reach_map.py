# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reach map: where on the part the tool gets at all, before any pass is computed, and what is in the way
elsewhere.

place     the surface is divided into triangles no larger than a spacing; each stands for its middle with its
          facet's normal. There the cutter is set on the part with many axes, the facet's normal first, then
          ever farther from it.
obstacle  what ends the tries: the one that the luckiest axis met. An axis first has to be within the
          machine's limits, the tool then above the table, then cutter, shank and holder out of the part, then
          all of it out of the fixtures, then bodies of the machine out of the way. Of the cutter its end is
          asked first: where that enters, the place is tighter than the cutter; where only what is above it
          does, the flank is in the way. What looks into a closed hollow is not tried: the tool may stand
          freely in there, but never gets in.
end       of a ball, or of a cutter that ends in one, that ball; of others as much from the bottom up as they
          are wide.

It is as fine as its places and axes: what it calls reachable is (that axis was tried), what it does not may
still be, under an axis between those tried.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from freecad_fiveaxis.core.base.chunks import batches
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.spread import spread
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree, facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.fixtures import Fixture, join_obstacles
from freecad_fiveaxis.core.gouge.hollows import find_hollow_facets
from freecad_fiveaxis.core.gouge.obstacles import (
    Obstacle,
    Reacher,
    enters,
    obstacles,
    stick_out_farther,
    tip_at,
)
from freecad_fiveaxis.core.gouge.rest_material import surface_samples
from freecad_fiveaxis.core.orientation.axis_field import ALONG, main_directions, with_way_out
from freecad_fiveaxis.core.orientation.rulings import find_rulings
from freecad_fiveaxis.core.passes.keep_off import KeepOff
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import CUTTER, Body, body_of, round_piece
from freecad_fiveaxis.core.tool.stick_out import LONGER_BY

TILTS = tuple(math.radians(tilt) for tilt in (0.0, 10.0, 20.0, 30.0, 45.0, 60.0, 80.0))
"""rad: how far from the facet's normal the tool is tried, the least first."""

UNDERCUTS = tuple(math.radians(tilt) for tilt in (90.0, 100.0, 110.0, 120.0, 135.0, 150.0))
"""rad: how far besides a lollipop is tried, as far as its undercut lets it."""

SPOKES = 8
"""Ways to either side of each tilt."""

PLACES = 10_000
"""Squares of the spacing into which the surface is divided, about; each holds two or three of the
triangles."""

FINEST = 0.1
"""Of the cutter's radius: places are not laid closer than that, whatever the part's size."""

BATCH = 2048
"""Places tried at a time."""

PORTIONS = 32
"""Of all places, one for a worker at a time."""

FEW = 128
"""Places of a portion, at least, of those at which a tool that sticks out farther is tried."""

UPRIGHT = 1e-6
"""rad: no tilt that counts, but it says on which side of a flat bottom the contact lies."""

TRIED = 1000
"""Places, about, at which a tool that sticks out farther is tried; and as many at which its way out is."""

LONGER = (5.0, *LONGER_BY)
"""mm: so much farther the tool is tried to stick out where LONGER_HELPS."""

LONGER_HELPS = (Obstacle.HOLDER, Obstacle.FIXTURE, Obstacle.MACHINE)
"""What a tool that sticks out farther may get past."""


@dataclass(frozen=True, eq=False)
class ReachMap:
    """Of each of k places: ``point`` (k, 3) mm, ``facet`` (k,), ``area`` (k,) mm2; ``obstacle`` (k,) of
    :class:`Obstacle`; ``tilt`` (k,) rad and unit ``axis`` (k, 3) of the first axis that is free, NaN where
    there is none. ``longer``: mm that the tool would have to stick out farther, and mm2 that it reaches then
    besides; ``without``: the name of each fixture that is in the way, and mm2, an estimate, that the tool
    reaches besides where it alone is taken away; ``spacing`` mm. ``shut``: mm2, an estimate, where the tool
    is free but cannot be drawn out along any axis tried; ``standing``: mm2 it reaches of what the part stands
    on, where ``mill`` leaves that out."""

    point: Floats
    facet: Ints
    area: Floats
    obstacle: Ints
    tilt: Floats
    axis: Floats
    longer: tuple[tuple[float, float], ...]
    spacing: float
    shut: float = 0.0
    standing: float = 0.0
    without: tuple[tuple[str, float], ...] = ()

    def area_of(self, obstacle: Obstacle) -> float:
        """mm2."""
        return float(self.area[self.obstacle == obstacle].sum())


def reach_map(
    mesh: Mesh, reacher: Reacher, facets: Bools | None = None, progress: Progress = silent,
    fixtures: Sequence[Fixture] = (),
    executor: Executor | None = None, keep_off: KeepOff | None = None,
) -> ReachMap:  # fmt: skip
    """Where the tool gets on these ``facets`` (f,), None: on all; ``fixtures``, work frame, are in its way
    too. ``keep_off``: faces to avoid on which there is an allowance; places that the cutter cannot touch for
    it are not in the map. ``executor``: whose workers do a portion of the places each, with the same result
    to the last bit; None: all is done here, which is quicker for a part of a few thousand places. Raises
    SettingsError for sizes that no tool has."""
    spacing = _spacing(mesh, reacher.cutter, facets)
    point, facet, area = surface_samples(mesh, spacing, facets)
    reacher, solid = with_fixtures(reacher, fixtures), mesh
    if keep_off is not None:
        some, solid = keep_off.allows(mesh, point, facet), keep_off.obstacle(mesh)
        point, facet, area = point[some], facet[some], area[some]
    ground, normal, tilts = Ground(reacher, solid), mesh.normal[facet], len(TILTS) / (len(TILTS) + 1)
    open_ = np.flatnonzero(~find_hollow_facets(mesh)[facet])
    parts = list(_split_places(point[open_], normal[open_], BATCH if executor else len(open_)))
    tried = spread(
        _try_all,
        ground,
        parts,
        executor,
        _scale_progress(progress, 0.0, tilts),
        "reach",
        [len(one) for one in parts],
    )
    obstacle, tilt, axis = _fill_in(open_, len(point), *map(np.concatenate, zip(*tried, strict=True)))
    held = np.flatnonzero(np.isin(obstacle, LONGER_HELPS))
    rows = held[:: max(1, len(held) // TRIED)]
    parts = list(_split_places(point[rows], normal[rows], FEW if executor else len(rows)))
    scaled = _scale_progress(progress, tilts, 1.0)
    steps = spread(_try_longer, ground, parts, executor, scaled, "reach", [len(one) for one in parts])
    longer = tuple(_estimate_reach(area, held, rows, np.concatenate([np.empty(0, np.int64), *steps])))
    free = np.flatnonzero(obstacle == Obstacle.NONE)
    shut = _estimate_shut(ground, Places(point[free], normal[free]), area[free])
    without = tuple(_estimate_without(ground, fixtures, Places(point, normal), area, obstacle, scaled))
    return ReachMap(point, facet, area, obstacle, tilt, axis, longer, spacing, shut, without=without)


def with_fixtures(reacher: Reacher, fixtures: Sequence[Fixture]) -> Reacher:
    """Return the same with these in its way; the very one where there are none."""
    if not fixtures:
        return reacher
    return replace(reacher, fixtures=join_obstacles(fixtures[0].mesh, fixtures[1:]))


def _estimate_without(
    ground: Ground, fixtures: Sequence[Fixture], places: Places, area: Floats, obstacle: Ints,
    progress: Progress,
) -> Iterator[tuple[str, float]]:  # fmt: skip
    """Estimate how much more, mm2, the tool reaches of ``places`` with these areas (k,) without each of the
    fixtures that keep it from some, from about TRIED of those where they are in the way."""
    held = np.flatnonzero(obstacle == Obstacle.FIXTURE)
    rows = held[:: max(1, len(held) // TRIED)]
    some, every = Places(places.point[rows], places.normal[rows]), np.arange(len(rows))
    for one in fixtures if len(rows) else ():
        others = [other for other in fixtures if other is not one]
        left = with_fixtures(replace(ground.reacher, fixtures=None), others)
        met, _, _ = _set_on(left, ground, some, every, _scale_progress(progress, 1.0, 1.0))
        if (freed := float(area[rows[met == Obstacle.NONE]].sum())) > 0.0:
            yield one.name, freed * float(area[held].sum() / area[rows].sum())


def _estimate_shut(ground: Ground, places: Places, area: Floats) -> float:
    """Estimate over which area, mm2, of the free ``places`` with these areas (k,) the tool cannot be drawn
    out along any axis tried, from about TRIED of them."""
    rows = np.arange(0, len(places), max(1, len(places) // TRIED))
    if not len(rows):
        return 0.0
    some = Places(places.point[rows], places.normal[rows])
    drawn = _draw_out(ground)
    met, _, _ = _set_on(drawn, ground, some, np.arange(len(rows)), silent)
    return float(area.sum() * area[rows[met != Obstacle.NONE]].sum() / area[rows].sum())


def _draw_out(ground: Ground) -> Reacher:
    """Return the tool in all places at once on its way out of the box of part and fixtures."""
    drawn, fixtures = with_way_out(ground.reacher, ground.tree), ground.reacher.fixtures
    if fixtures is None:
        return drawn
    low, high = (np.stack(ends) for ends in zip(ground.mesh.box, fixtures.box, strict=True))
    way = float(np.linalg.norm(high.max(axis=0) - low.min(axis=0)))
    return replace(drawn, far=max(drawn.far, way + ground.tree.most_allowance))


def _fill_in(open_: Ints, count: int, *met: Floats | Ints) -> Met:
    """Give what was met at the ``open_`` places (k,) to all of ``count`` places; the others are in a closed
    hollow."""
    obstacle, tilt = np.full(count, int(Obstacle.HOLLOW)), np.full(count, np.nan)
    axis = np.full((count, 3), np.nan)
    for column, found in zip((obstacle, tilt, axis), met, strict=True):
        column[open_] = found
    return obstacle, tilt, axis


def _scale_progress(progress: Progress, first: float, last: float) -> Progress:
    return lambda stage, fraction: progress(stage, first + (last - first) * fraction)


@dataclass(frozen=True, eq=False)
class Ground:
    """What all places have in common: the tool, and what is in its way. The tree is not sent: it is four
    times as large."""

    reacher: Reacher
    mesh: Mesh

    @property
    def tree(self) -> FacetTree:
        """Of the facets, grown once in each process."""
        return facet_tree(self.mesh)

    @cached_property
    def bores(self) -> Floats:
        """Unit vectors (d, 3), both ways, along which bores and other hollow walls of the part stand."""
        one = find_rulings(self.mesh, np.empty((0, 3)))
        return np.concatenate([one, -one])

    @cached_property
    def walls(self) -> Floats:
        """Unit vectors (d, 3) along which pockets and walls of the part most likely stand: those that
        ``auto`` tries besides its own."""
        return main_directions(self.mesh)


@dataclass(frozen=True, eq=False)
class Places:
    """``point`` (k, 3) mm and unit ``normal`` (k, 3) of some places."""

    point: Floats
    normal: Floats

    def __len__(self) -> int:
        return len(self.point)


def _split_places(point: Floats, normal: Floats, least: int) -> Iterator[Places]:
    """Yield these places in up to PORTIONS of at least so many; an empty one where there are none."""
    size = max(least, -(-len(point) // PORTIONS), 1)
    for first in range(0, max(len(point), 1), size):
        yield Places(point[first : first + size], normal[first : first + size])


Met = tuple[Ints, Floats, Floats]
"""Obstacle (k,), tilt (k,) rad and axis (k, 3) as in :class:`ReachMap`."""


def _try_all(ground: Ground, places: Places, progress: Progress) -> Met:
    """Return what is in the way of each place."""
    reacher, tight = ground.reacher, np.zeros(len(places), np.bool_)
    for part in batches(len(places), BATCH):
        progress("reach", 0.0)
        tight[part] = _too_tight(reacher, ground.tree, places.point[part], places.normal[part])
    met = _set_on(reacher, ground, places, np.flatnonzero(~tight), progress)
    met[0][tight] = Obstacle.CUTTER
    return met


def _try_longer(ground: Ground, places: Places, progress: Progress) -> Ints:
    """Return the first of LONGER (k,) by which the tool has to stick out farther to get there; len(LONGER)
    where it never does."""
    reacher, step, none = ground.reacher, np.full(len(places), len(LONGER)), len(LONGER)
    for k, more in enumerate(LONGER):
        rows = np.flatnonzero(step == none)
        longer = stick_out_farther(reacher, more)
        met, _, _ = _set_on(longer, ground, places, rows, _scale_progress(progress, k / none, (k + 1) / none))
        step[met == Obstacle.NONE] = k
    return step


def _set_on(reacher: Reacher, ground: Ground, places: Places, open_: Ints, progress: Progress) -> Met:
    """Set the tool on the ``open_`` places with all axes of each tilt, the least first, until one is free;
    then, where only the flank is in the way, along the part's own walls, as in a bore. The others stay as
    they are before any try."""
    tree = ground.tree
    obstacle, tilt = np.full(len(places), int(Obstacle.LIMITS)), np.full(len(places), np.nan)
    axis = np.full((len(places), 3), np.nan)
    tilts = (*TILTS, *(tilt for tilt in UNDERCUTS if tilt < 0.5 * math.pi + reacher.cutter.undercut))
    for k, angle in enumerate(tilts):
        for part in batches(len(open_), BATCH):
            progress("reach", (k + part.start / len(open_)) / len(tilts))
            _try(reacher, tree, places.point, places.normal, angle, open_[part], obstacle, tilt, axis)
        open_ = open_[obstacle[open_] != Obstacle.NONE]
    open_ = open_[obstacle[open_] == Obstacle.FLANK]
    for part in batches(len(open_), BATCH):
        _try_along_walls(reacher, ground, places, open_[part], (obstacle, tilt, axis))
    return obstacle, tilt, axis


def _try_along_walls(reacher: Reacher, ground: Ground, places: Places, rows: Ints, met: Met) -> None:
    """Set the tool on the places ``rows`` (k,) along the part's bores, then along its other walls; what is
    free goes into ``met``, the axis nearest to the normal. In a bore the tool is drawn out along it;
    elsewhere it has to end outside the part's box: a short tool that lies level under a roof is free, but
    nothing can hold it there."""
    obstacle, tilt, axis = met
    for direction, bore in ((ground.bores, True), (ground.walls, False)):
        rows = rows[obstacle[rows] == Obstacle.FLANK]
        along = places.normal[rows] @ direction.T
        place, way = np.nonzero((along > math.cos(ALONG)) & (along < math.cos(TILTS[-1])))
        point, normal, tried = places.point[rows[place]], places.normal[rows[place]], direction[way]
        some = np.flatnonzero(bore | _ends_outside(reacher, ground.mesh, point, normal, tried))
        hit = obstacles(reacher, ground.tree, point[some], normal[some], tried[some])
        some = some[hit == Obstacle.NONE]
        some = some[np.lexsort((-along[place[some], way[some]], place[some]))]
        place, first = np.unique(place[some], return_index=True)
        at, way = rows[place], way[some[first]]
        obstacle[at], axis[at] = Obstacle.NONE, direction[way]
        tilt[at] = np.minimum(np.arccos(along[place, way]), UNDERCUTS[0])


def _ends_outside(reacher: Reacher, mesh: Mesh, point: Floats, normal: Floats, axis: Floats) -> Bools:
    """Whether (n,) the upper end of the tool on these contacts lies out of the part's box."""
    end = tip_at(reacher.cutter, point, normal, axis) + reacher.body.reach * axis
    low, high = mesh.box
    return np.asarray(((end < low) | (end > high)).any(axis=1))


def _spacing(mesh: Mesh, cutter: Cutter, facets: Bools | None) -> float:
    area = float(mesh.area.sum() if facets is None else mesh.area[facets].sum())
    return max(math.sqrt(area / PLACES), FINEST * cutter.radius)


def _too_tight(reacher: Reacher, tree: FacetTree, point: Floats, normal: Floats) -> Bools:
    """Whether (k,) a ball end itself enters the part: no axis helps. Of other cutters nothing is known
    beforehand."""
    cutter = reacher.cutter
    if cutter.ring > 0.0:
        return np.zeros(len(point), np.bool_)
    ball = Body((round_piece(0.0, cutter.corner, cutter.corner),))
    return enters(ball, tree, point, normal, reacher.limit)


def _try(
    reacher: Reacher, tree: FacetTree, point: Floats, normal: Floats, angle: float, open_: Ints,
    obstacle: Ints, tilt: Floats,
    axis: Floats,
) -> None:  # fmt: skip
    """Set the tool on the ``open_`` places (k,) with all axes of that angle; what is found goes into
    obstacle, tilt and axis."""
    turned = choose_trial_axes(normal[open_], angle, reacher.cutter.ring)
    ways = turned.shape[1]
    place, turned = np.repeat(open_, ways), turned.reshape(-1, 3)
    met = obstacles(reacher, tree, point[place], normal[place], turned)
    most = np.maximum(obstacle[open_], met.reshape(-1, ways).max(axis=1, initial=0))
    rows = np.flatnonzero((met == Obstacle.CUTTER) & np.repeat(most == Obstacle.CUTTER, ways))
    only = _only_flank_enters(reacher, tree, point[place[rows]], normal[place[rows]], turned[rows])
    met[rows[only]] = Obstacle.FLANK
    met = met.reshape(-1, ways)
    best = met.argmax(axis=1)
    farthest = met.max(axis=1, initial=0)
    obstacle[open_] = np.maximum(obstacle[open_], farthest)
    free = farthest == Obstacle.NONE
    tilt[open_[free]] = angle
    axis[open_[free]] = turned.reshape(-1, ways, 3)[np.flatnonzero(free), best[free]]


def _only_flank_enters(
    reacher: Reacher, tree: FacetTree, point: Floats, normal: Floats, axis: Floats
) -> Bools:
    """Whether (n,) the end of a cutter that enters does not. The ball at an end has been asked before any
    axis was; a lollipop's cutter is nothing but its end."""
    cutter = reacher.cutter
    if cutter.ring == 0.0:
        return np.full(len(point), cutter.neck is None)
    end = body_of(replace(cutter, length=min(cutter.length, cutter.diameter))).only(CUTTER)
    return ~enters(end, tree, tip_at(cutter, point, normal, axis), axis, reacher.limit)


def choose_trial_axes(normal: Floats, angle: float, ring: float) -> Floats:
    """Return unit axes (n, ways, 3) of that angle (rad) to unit ``normal`` (n, 3). Upright, a bottom with a
    ``ring`` (mm) may touch with its middle or with its edge on any side."""
    if angle > 0.0:
        return tilt_about_normal(normal, angle, SPOKES)
    edges = [tilt_about_normal(normal, UPRIGHT, SPOKES)] if ring > 0.0 else []
    return np.concatenate([normal[:, None], *edges], axis=1)


def tilt_about_normal(normal: Floats, angle: float, ways: int) -> Floats:
    """Return unit axes (n, ways, 3) that make this angle (rad) with unit ``normal`` (n, 3), evenly about
    it."""
    least = np.eye(3)[np.abs(normal).argmin(axis=1)]
    one = np.cross(normal, least)
    one /= np.linalg.norm(one, axis=1)[:, None]
    two = np.cross(normal, one)
    turn = np.arange(ways) * (2.0 * math.pi / ways)
    out = one[:, None] * np.cos(turn)[:, None] + two[:, None] * np.sin(turn)[:, None]
    return np.asarray(math.cos(angle) * normal[:, None] + math.sin(angle) * out)


def _estimate_reach(area: Floats, held: Ints, rows: Ints, step: Ints) -> Iterator[tuple[float, float]]:
    """How far the tool would have to stick out at most, mm, and the area, mm2, that it reaches then of the
    places ``held``, where only holder or machine are in the way: an estimate from ``rows``, of which ``step``
    is the first of LONGER that helps."""
    each, reached = float(area[held].sum()) / max(float(area[rows].sum()), 1e-30), 0.0
    for k, more in enumerate(LONGER):
        free = rows[step == k]
        if len(free):
            reached += each * float(area[free].sum())
            yield more, reached
