# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where passes of constant scallop leave more than the scallop, found from the passes themselves.

ridge   where two fronts of the field meet: passes turn in a corner there, and inside the corner the next pass
        is farther away than a step. So it is where they end at an edge aslant, and inside the innermost.
        The field turns there, and nowhere else does a pass stand farther off than a step; so only facets at
        which it turns are looked at, a tenth of a part.
height  of a place over which no centre of the ball passes nearer than that: its distance to the nearest
        centre, less the radius. No place is higher once the tool has followed the passes; where
        it is lifted off them or does not fit, other findings tell.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Area, Choice, Length, Number, Option, Point, say
from freecad_fiveaxis.core.base.vectors import row_dot
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .contact_path import ContactPath
from .field import PassOptions, Region
from .geodesic import Frames, gradient
from .untouched import sample_lines

ABOVE = 1.02
"""Scallops from which a place counts as higher: facets and the samples' own error make up for less."""

WORTH = 0.0001
"""Share of the area on which scallops are higher, from which it is told."""

TURNS = 0.98
"""Mean of the directions in which the field rises about a vertex, 1 where they are one: below it the field
turns there, by 23 degrees between two halves. Fronts that meet leave more than the scallop from 50 on."""

DENSE = 20.0
"""Places for each square of a step."""

FEWEST, MOST = 4_000, 40_000
"""Places that are looked at, whatever the size."""

FINE = 0.1
"""Steps between samples of a pass; places are measured to the straight piece that the nearest is of."""

MOST_SAMPLES = 1_000_000
"""About so many samples at most, farther apart on longer passes."""

NEAR = 2.0
"""Steps: pieces of passes that are farther from every place are not sampled."""

NEARLY = 0.8
"""Of the largest height: facets with such a place are looked at once more, for the largest one."""

CLOSER = 16.0
"""Times the density then."""

GOLDEN = np.array([0.7548776662466927, 0.5698402909980532])
"""Steps of a sequence that fills a square evenly (Roberts 2018: the plastic number)."""

AROUND = np.stack(np.meshgrid(*3 * [np.arange(-1, 2)], indexing="ij"), axis=-1).reshape(-1, 3)
"""From a cell to itself and those about it."""


class Places(NamedTuple):
    """``point`` (n, 3) mm, each on its ``facet`` (n,)."""

    point: Floats
    facet: Ints


def find_turns(frame: Frames, mesh: Mesh, steps: Floats) -> Ints:
    """Find the facets (k,) about whose vertices a field of ``steps`` (v,) turns."""
    slope = gradient(frame, mesh.face, steps)
    rise = slope[0] * frame.one.T + slope[1] * frame.two.T
    rise /= np.maximum(np.linalg.norm(rise, axis=0), 1e-300)
    corner, count = mesh.face.ravel(), len(mesh.vertex)
    weight = np.repeat(frame.area, 3)
    total = [np.bincount(corner, weight * np.repeat(part, 3), count) for part in rise]
    turns = np.linalg.norm(total, axis=0) < TURNS * np.bincount(corner, weight, count)
    return np.flatnonzero(turns[mesh.face].any(axis=1))


def report_high_scallops(
    region: Region, options: PassOptions, contact: ContactPath, mesh: Mesh, rows: Ints
) -> tuple[Finding, ...]:
    """Return a note where passes leave more than the scallop on facets ``rows`` (k,) of ``mesh``, a copy of
    the region, if that is more than a little of the region; none for passes by stepover, or of a cutter that
    is no ball."""
    scallop = options.scallop
    if scallop is None or options.stepover is not None or region.covered is not None:
        return ()
    if not len(contact.point) or not len(rows):
        return ()
    places = sample_places(mesh, rows, DENSE / region.interval**2)
    height = measure_heights(region, contact, places.point)
    high = float((height > ABOVE * scallop).mean()) * float(mesh.area[rows].sum())
    if high <= WORTH * float(region.mesh.area[region.keep].sum()):
        return ()
    closer = _look_closer(mesh, places, height)
    point = np.concatenate([places.point, closer.point])
    height = np.concatenate([height, measure_heights(region, contact, closer.point)])
    return (_say_high(region, scallop, high, float(height.max()), point[height.argmax()]),)


def _say_high(region: Region, scallop: float, area: float, worst: float, where: Floats) -> Finding:
    x, y, z = where.tolist()
    text = say(
        "Passes leave more than {scallop} where they turn in corners or end at edges: on at least {area}, "
        "{percent} % of what is cut, most at {place}: {height}. The map of what is left ({left}) measures "
        "the program itself. A smaller {option} leaves less there.",
        scallop=Length(scallop),
        area=Area(area, ".3g"),
        percent=Number(100.0 * area / float(region.mesh.area[region.keep].sum()), ".2g"),
        place=Point((x, y, z), ".4g"),
        height=Length(worst, ".3g"),
        left=Choice("rest", ("on",)),
        option=Option("scallop", flag=False),
    )
    return report_finding(Code.HIGH_SCALLOPS, text, worst, scallop, place=(x, y, z))


def measure_heights(region: Region, contact: ContactPath, point: Floats) -> Floats:
    """Measure what (n,) mm the ball leaves over points (n, 3) of the region when it follows the passes; below
    0 where it enters them, -inf where a place is farther than NEAR steps from every pass: no scallop is that,
    and what passes do not touch has findings of its own."""
    near = _are_near(contact, point, NEAR * region.interval)
    start = (contact.point[::2] + region.radius * contact.normal[::2])[near]
    end = (contact.point[1::2] + region.radius * contact.normal[::2])[near]
    if not len(start):
        return np.full(len(point), -np.inf)
    length = float(np.linalg.norm(end - start, axis=1).sum())
    sample, of = sample_lines(start, end, max(FINE * region.interval, length / MOST_SAMPLES))
    there = of[scipy.spatial.cKDTree(sample).query(point)[1]]
    way = end[there] - start[there]
    off = point - start[there]
    along = row_dot(off, way) / np.maximum(row_dot(way, way), 1e-300)
    off -= np.clip(along, 0.0, 1.0)[:, None] * way
    distance = np.sqrt(row_dot(off, off))
    beyond = np.hypot(region.radius, NEAR * region.interval)
    return np.asarray(np.where(distance > beyond, -np.inf, distance - region.radius))


def _are_near(contact: ContactPath, point: Floats, reach: float) -> Bools:
    """Tell which pieces (n,) of passes may lie within ``reach`` mm of one of the points (m, 3): those in its
    cell, or in one about it."""
    start, end = contact.point[::2], contact.point[1::2]
    size = reach + 0.5 * float(np.linalg.norm(end - start, axis=1).max())
    low = np.minimum(point.min(axis=0), contact.point.min(axis=0)) - size
    count = (
        np.ceil((np.maximum(point.max(axis=0), contact.point.max(axis=0)) - low) / size).astype(np.int64) + 2
    )
    step = np.array([count[1] * count[2], count[2], 1])
    cell = np.unique(((point - low) // size).astype(np.int64), axis=0)
    filled = np.unique((cell[:, None] + AROUND).reshape(-1, 3) @ step)
    return np.isin(((0.5 * (start + end) - low) // size).astype(np.int64) @ step, filled)


def sample_places(mesh: Mesh, rows: Ints, density: float, most: int = MOST) -> Places:
    """Spread places evenly over the facets ``rows`` (k,), ``density`` of them on a mm2, at least FEWEST and
    no more than ``most``."""
    behind = np.cumsum(mesh.area[rows])
    count = int(np.clip(density * behind[-1], FEWEST, most))
    number = np.arange(count)
    facet = rows[np.searchsorted(behind, (number + 0.5) / count * behind[-1])]
    one, two = ((number[:, None] + 1.0) * GOLDEN % 1.0).T
    turned = one + two > 1.0
    one, two = np.where(turned, 1.0 - one, one), np.where(turned, 1.0 - two, two)
    return Places(_place(mesh, facet, np.array([1.0 - one - two, one, two])), facet)


def _look_closer(mesh: Mesh, places: Places, height: Floats) -> Places:
    """Return more places on the facets of the highest ones."""
    rows = np.unique(places.facet[height >= NEARLY * height.max()])
    density = CLOSER * len(places.point) / float(mesh.area[np.unique(places.facet)].sum())
    return sample_places(mesh, rows, density, MOST // 2)


def _place(mesh: Mesh, facet: Ints, share: Floats) -> Floats:
    """Return the points (n, 3) of facets (n,) at ``share`` (3, n) of their corners."""
    return np.asarray((share.T[:, :, None] * mesh.vertex[mesh.face[facet]]).sum(axis=1))
