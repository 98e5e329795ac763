# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pass strategy of constant scallop: passes one admissible step apart, measured over the surface
(docs/passes.md).

source    where the distance begins: the border of the region (of a part without one its lowest place), a
          point or a curve.
piece     facets that hang together. Each has a source of its own, and its passes follow one another.
gap       what lies farther from every pass than half a step: where two fronts meet, or behind an edge over
          which the ball rolls. It is measured, whatever the reason, and passes half-way between the others
          are laid through it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.chunks import batches, in_threads
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .contact_path import slice_field
from .field import ALL_ROUND, PassField, PassOptions, Region
from .geodesic import (
    FLATTEST,
    Frames,
    as_tensor,
    distance,
    frames,
    gradient,
    scallop_metric,
    side_lengths,
    step_across,
)
from .high_scallops import find_turns
from .refine import Copy, drop_short, finer_copy, join_copies, take_facets
from .scallop import facet_curvature, flat_interval, refuse_high_scallop
from .sources import find_source, source_values
from .untouched import report_untouched

AIM = 0.92
"""Share of the scallop that the passes are laid for: facets and the field's own error leave as much as the
rest."""

LONGEST = 1.5
"""Sides of the facets that carry the field are no longer than so many steps."""

MOST_FACETS = 300_000
"""About so many facets carry a field: some seconds of work. A larger part has a coarser one, as far as its
own facets allow."""

MOST_SQUARES = 20_000_000
"""Squares of a step on the region, at most: passes as long as so many steps are a program of some
gigabytes."""

EVEN = 0.07
"""Area of a facet over the square of the longest side allowed, where sides are halved: 0.06 to 0.08 on real
parts."""

MANY = 1.2
"""Times MOST_FACETS that facets counted one by one may be: the count is a high one where they are wide."""

WIDER = 1.25
"""Times that the sides may be longer until there are not too many."""

FIRST = 0.5
"""Steps from the source to the first pass: the ball reaches half a step to either side."""

BETWEEN = 0.05
"""Steps by which a pass through a gap stands beyond the middle between two others, so that none runs along
the source."""

GAP = 1.45
"""Half steps from the nearest pass from which a place counts as left out: twice the scallop stays there. Less
would lay a short pass, with a retract of its own, into every corner of every pass."""

OVERLAP = 1.1
"""Half steps that what is wide and steep at its rim, the bottom of an end mill, covers at least: beyond it
nothing is cut, however little the step leaves between two passes."""

AMPLE = 1.001
"""Times the distance from which any place counts as left out: passes beyond it are not looked for."""

SURELY = 1.0 - 1e-12
"""Of a distance: what is so near is so by any rounding."""

BATCH = 16384
"""Facets that are asked for gaps at a time."""

DENSE = 0.2
"""Steps between the samples of a pass from which the gaps are measured."""

THIN = 0.01
"""Steps, and share of a unit between the normals, within which samples count as one: where slivers meet there
are thousands."""

FACING = 0.5
"""Steps on a flat that a difference of 1 between two unit normals counts for: no pass covers what lies round
an edge."""

SHORT = 1.0
"""Steps: what is shorter is no pass."""

BEND = 0.03
"""Steps by which a pass may be straighter inside a facet than the field's level is."""

PLACES = np.array(
    [[0.8, 0.1, 0.1], [0.1, 0.8, 0.1], [0.1, 0.1, 0.8], [0.45, 0.45, 0.1], [0.1, 0.45, 0.45],
        [0.45, 0.1, 0.45]]
)  # fmt: skip
"""Where on a facet gaps are looked for, in shares of its corners."""


@dataclass(frozen=True)
class OverSurface:
    """What strategies have in common whose passes lie over walls as over floors: they run in every
    direction."""

    text: str
    over_surface: bool = True

    def travels(self, options: PassOptions) -> tuple[float, ...]:
        """Every direction."""
        return ALL_ROUND

    def report_untouched(
        self, region: Region, options: PassOptions, field: PassField, touched: Ints
    ) -> tuple[Finding, ...]:
        """Return what no pass touches."""
        return field.findings + report_untouched(region, touched)


class ConstantScallop(OverSurface):
    """Level sets of the distance from a source, in steps that leave the scallop."""

    def check(self, region: Region, options: PassOptions) -> None:
        """Raise SettingsError for a source or a scallop that cannot be used and for more passes than any job
        can want."""
        survey_region(region, options)

    def field(self, region: Region, options: PassOptions) -> PassField:
        """Return steps from the source, the pieces of the region one after the other."""
        region.progress("placing passes", 0.0)
        ground = survey_region(region, options)
        surface = make_surface(region, ground)
        region.progress("placing passes", 0.3)
        steps = lay_steps(surface, ground.curve)
        region.progress("placing passes", 0.7)
        turns = find_turns(surface.frame, surface.copy.mesh, steps)
        return replace(lay_passes(region, surface, steps), turns=turns)


def lay_steps(surface: Surface, curve: Floats | None) -> Floats:
    """Measure the distance, in steps, of the vertices (v,) of the surface's copy from ``curve``, None: from
    its border."""
    source, known = source_values(surface.copy, surface.frame, surface.metric, curve)
    return distance(
        surface.copy.mesh.vertex, surface.copy.mesh.face, surface.frame, surface.metric, source, known
    )


def lay_passes(region: Region, surface: Surface, steps: Floats) -> PassField:
    """Lay passes one unit of ``steps`` (v,) apart, a field at the vertices of the surface's copy, the pieces
    one after the other; and half-way between them where a place is left out."""
    main = _field_from(surface.copy, steps, FIRST, 0.0)
    region.progress("placing passes", 0.8)
    gaps = _gaps(surface, steps, main, lambda share: region.progress("placing passes", 0.8 + 0.2 * share))
    if not gaps.any():
        return main
    between = take_facets(surface.copy, region.mesh, np.flatnonzero(gaps))
    more = _field_from(
        between,
        _carry_field(surface.copy, steps, gaps, between),
        BETWEEN,
        float(np.ceil(main.value.max())) + 1.0,
    )
    both = join_copies(surface.copy, between)
    region.progress("placing passes", 1.0)
    value, levels = np.concatenate([main.value, more.value]), np.concatenate([main.levels, more.levels])
    return PassField(value, levels, surface=both)


class Bends(NamedTuple):
    """Of n facets: the curvature ``tensor`` (6, n) 1/mm of surface and tool, less that of a ball of
    ``radius`` (n,) mm, the step ``flat`` (n,) mm of that ball on a flat, and the ``least`` (n,) of the
    metric."""

    tensor: Floats
    radius: Floats
    flat: Floats
    least: Floats

    def take(self, at: Ints) -> Bends:
        """Pick these facets (k,)."""
        return Bends(self.tensor[:, at], self.radius[at], self.flat[at], self.least[at])


class Ground(NamedTuple):
    """The region as it is: where passes begin (``curve``), its ``rows`` of the mesh, how surface and tool
    ``bends`` there, frames and metric; the largest step on a ``flat``, mm, and how many ``squares`` of a step
    it has."""

    curve: Floats | None
    rows: Ints
    bends: Bends
    frame: Frames
    metric: Floats
    flat: float
    squares: float

    @property
    def fine(self) -> float:
        """The smallest step on a flat, mm."""
        return float(self.bends.flat.min(initial=self.flat))


class Surface(NamedTuple):
    """The finer copy of the region, its frames and its metric, the largest step on a flat, mm, how far, mm, a
    place may be from the nearest pass at most, and the smallest step, mm."""

    copy: Copy
    frame: Frames
    metric: Floats
    flat: float
    covered: float = math.inf
    finest: float = math.inf

    @property
    def fine(self) -> float:
        """The smallest step on a flat, mm."""
        return min(self.flat, self.finest)


def survey_region(region: Region, options: PassOptions) -> Ground:
    """Measure the region as it is, a moment's work against what is then laid on it. Raises SettingsError,
    FileError."""
    flat, curve = _flat_step(region, options), find_source(options.source, region)
    mesh, rows = region.mesh, np.flatnonzero(region.keep)
    tensor = np.zeros((6, len(rows)))
    if options.stepover is None:
        tensor = facet_curvature(mesh)[:, rows]
    least = FLATTEST if region.widest is None else max(FLATTEST, 1.0 / region.widest**2)
    frame = frames(mesh.vertex, mesh.face[rows])
    bends = _bends_by_facet(region, options, rows, tensor, flat, least)
    metric = scallop_metric(frame, *bends)
    squares = float((frame.area * np.sqrt(metric[0] * metric[2] - metric[1] ** 2)).sum())
    if squares > MOST_SQUARES:
        text = say(
            "passes so close would be {length} long, more than any job can want; give a larger stepover or "
            "scallop, or check the units of the part",
            length=Length(squares * flat, ".3g"),
        )
        raise SettingsError(text, squares * flat)
    return Ground(curve, rows, bends, frame, metric, flat, squares)


def _bends_by_facet(
    region: Region, options: PassOptions, rows: Ints, tensor: Floats, flat: float, least: float
) -> Bends:
    """Return how surface and tool bend on the facets ``rows`` (n,)."""
    count, tool = len(rows), region.tool
    if tool is None or options.scallop is None or options.stepover is not None:
        return Bends(tensor, np.full(count, region.radius), np.full(count, flat), np.full(count, least))
    height, radius = AIM * options.scallop, tool.radius[rows]
    step = np.minimum(2.0 * np.sqrt(height * (2.0 * radius - height)), flat)
    narrowest = np.maximum(tool.least(rows), (step / flat) ** 2)
    return Bends(tensor + tool.bends(rows), radius, np.maximum(step, options.least), narrowest)


def make_surface(region: Region, ground: Ground) -> Surface:
    """Copy the region, its facets small against the steps, and measure the copy."""
    return measure_copy(region, ground, copy_region(region, ground))


def copy_region(region: Region, ground: Ground) -> Copy:
    """Copy the region, its facets small against the steps."""
    longest = _find_longest(region, ground)
    copy = finer_copy(region.mesh, ground.rows, as_tensor(ground.frame, ground.metric), longest)
    return replace(copy, bend=BEND * ground.fine, short=SHORT * ground.fine)


def _find_longest(region: Region, ground: Ground) -> float:
    """Find how long, in steps, the sides of the copy's facets may be, so that there are not many more than
    MOST_FACETS besides those of the part: of a facet of length a and height h there are about
    ``3 a / longest`` in a row, and of such rows where it is wide."""
    longest = max(LONGEST, math.sqrt(ground.squares / (EVEN * MOST_FACETS)))
    side = side_lengths(region.mesh.vertex, region.mesh.face[ground.rows], ground.frame, ground.metric).max(
        axis=0
    )
    density = np.sqrt(ground.metric[0] * ground.metric[2] - ground.metric[1] ** 2)
    height = 2.0 * ground.frame.area * density / side

    def count(length: float) -> float:
        in_row, rows = 3.0 * side / length, height / (6.0 * EVEN * length)
        return float((np.maximum(in_row, 1.0) * np.maximum(rows, 1.0)).sum())

    while count(longest) > MANY * MOST_FACETS + len(ground.rows):
        longest *= WIDER
    return longest


def measure_copy(region: Region, ground: Ground, copy: Copy) -> Surface:
    """Measure a copy of the region: its frames, and the metric of the facets in which its own lie."""
    frame, place = frames(copy.mesh.vertex, copy.mesh.face), np.full(len(region.mesh.face), -1)
    place[ground.rows] = np.arange(len(ground.rows))
    metric = scallop_metric(frame, *ground.bends.take(place[copy.parent]))
    return Surface(copy, frame, metric, ground.flat, region.covered or math.inf, ground.fine)


def _flat_step(region: Region, options: PassOptions) -> float:
    if options.stepover is not None:
        return options.stepover
    assert options.scallop is not None
    refuse_high_scallop(options.scallop, region.radius)
    flat = flat_interval(region.radius, AIM * options.scallop)
    if region.covered is not None:
        flat = min(flat, 2.0 * region.covered / OVERLAP)
    return max(flat, options.least)


def _touching(face: Ints, chosen: Bools) -> Bools:
    """Facets (f,) that are chosen, or have a vertex in common with one that is."""
    touched = np.zeros(int(face.max()) + 1, np.bool_)
    touched[face[chosen]] = True
    return np.asarray(touched[face].any(axis=1))


def _field_from(copy: Copy, steps: Floats, first: float, begin: float) -> PassField:
    """Return the field with the pieces one after the other from ``begin`` on, and the levels ``first`` beyond
    each whole number; of a piece in which there is none of those the middle."""
    pieces = int(copy.component.max(initial=-1)) + 1
    nearest, farthest = np.full(pieces, math.inf), np.zeros(pieces)
    np.minimum.at(nearest, copy.component, steps)
    np.maximum.at(farthest, copy.component, steps)
    below = np.floor(nearest)
    room = np.floor(farthest) - below + 1.0
    start = begin + np.cumsum(room) - room - below
    levels = begin + first + np.arange(int(room.sum()), dtype=np.float64)
    piece = np.repeat(np.arange(pieces), room.astype(np.int64))
    cuts = (levels > (start + nearest)[piece]) & (levels < (start + farthest)[piece])
    none = np.bincount(piece[cuts], minlength=pieces) == 0
    middle = (start + 0.5 * (nearest + farthest))[none]
    return PassField(
        start[copy.component] + steps, np.sort(np.concatenate([levels[cuts], middle])), surface=copy
    )


def _gaps(
    surface: Surface, steps: Floats, main: PassField, tell: Callable[[float], None] = lambda share: None
) -> Bools:
    """Facets (f,) of the copy that hold a place left out, and those that have a vertex in common with one."""
    mesh = surface.copy.mesh
    contact = drop_short(slice_field(mesh, main.value, main.levels), surface.copy.short)
    across = step_across(surface.metric, gradient(surface.frame, mesh.face, steps))
    tell(0.1)
    near, normal = _sample_segments(
        contact.point[::2], contact.point[1::2], contact.normal[::2], DENSE * surface.fine
    )
    tell(0.2)
    near, normal = _thin_points(near, normal, THIN * surface.fine)
    if not len(near):
        return np.ones(len(mesh.face), np.bool_)
    tell(0.4)
    facing = FACING * surface.flat
    samples = np.concatenate([near, facing * normal], axis=1)
    left = _find_left_out(
        mesh,
        samples,
        facing * mesh.normal,
        np.minimum(GAP * 0.5 * across, surface.covered),
        lambda share: tell(0.5 + 0.5 * share),
    )
    return _touching(mesh.face, left)


def _find_left_out(
    mesh: Mesh, samples: Floats, looking: Floats, enough: Floats, tell: Callable[[float], None] | None = None
) -> Bools:
    """Facets (f,) with a place that is more than ``enough`` (f,) from all ``samples`` (n, 6); a place is
    where it is, and where its facet is ``looking`` (f, 3)."""
    tree, most = scipy.spatial.cKDTree(samples), AMPLE * float(enough.max())

    def ask(some: slice) -> Bools:
        return _is_left_out(tree, mesh.vertex[mesh.face[some]], looking[some], enough[some], most)

    return np.concatenate(in_threads(ask, batches(len(mesh.face), BATCH), tell))


def _is_left_out(
    tree: scipy.spatial.cKDTree, corner: Floats, looking: Floats, enough: Floats, most: float
) -> Bools:
    """Return the same of facets with the ``corner`` (f, 3, 3), by a ``tree`` of the samples that is not asked
    beyond ``most``."""
    samples = tree.data
    far, nearest = tree.query(
        np.concatenate([corner.mean(axis=1), looking], axis=1), distance_upper_bound=most
    )
    found = np.flatnonzero(far <= most)
    place = (PLACES @ corner).reshape(-1, len(PLACES), 3)
    left: Bools = np.ones(place.shape[:2], np.bool_)
    to_one = samples[
        nearest[found]
    ]  # what is nearest to a facet's middle is near enough to most of its places
    off = ((place[found] - to_one[:, None, :3]) ** 2).sum(axis=2) + (
        (looking[found] - to_one[:, 3:]) ** 2
    ).sum(axis=1)[:, None]
    left[found] = np.sqrt(off) > SURELY * enough[found, None]
    row, at = np.nonzero(left)
    left[row, at] = (
        tree.query(np.concatenate([place[row, at], looking[row]], axis=1), distance_upper_bound=most)[0]
        > enough[row]
    )
    return np.asarray(left.any(axis=1))


def _sample_segments(entry: Floats, exit_: Floats, normal: Floats, step: float) -> tuple[Floats, Floats]:
    """Points (n, 3) of segments, at most ``step`` mm apart, and the normals there."""
    pieces = np.ceil(np.linalg.norm(exit_ - entry, axis=1) / step).astype(np.int64) + 1
    row, number = number_runs(pieces)
    share = number / np.maximum(pieces - 1, 1)[row]
    return entry[row] + share[:, None] * (exit_ - entry)[row], normal[row]


def _thin_points(point: Floats, normal: Floats, step: float) -> tuple[Floats, Floats]:
    """One of the points (n, 3), with its normal, in each cell of ``step`` mm and of ``THIN`` of the
    normal."""
    if not len(point):
        return point, normal
    cell = np.floor(np.concatenate([point / step, normal / THIN], axis=1)).astype(np.int64)
    cell -= cell.min(axis=0)
    size = cell.max(axis=0) + 1
    keys = [
        cell[:, 0],
        cell[:, 1] * size[2] + cell[:, 2],
        (cell[:, 3] * size[4] + cell[:, 4]) * size[5] + cell[:, 5],
    ]
    if math.prod(size[:3].tolist()) < 2**62:  # one key less to sort by, and the same order
        keys[:2] = [keys[1] * size[0] + keys[0]]
    order = np.lexsort(keys)
    new = np.append(True, np.any([np.diff(key[order]) != 0 for key in keys], axis=0))
    first = order[new]
    return point[first], normal[first]


def _carry_field(copy: Copy, steps: Floats, chosen: Bools, to: Copy) -> Floats:
    """Return the field (w,) at the vertices of ``to``, a copy of the ``chosen`` facets in their order."""
    value = np.empty(len(to.mesh.vertex))
    value[to.mesh.face] = steps[copy.mesh.face[chosen]]
    return value
