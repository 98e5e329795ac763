# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two neighbouring passes and the scallop between them, measured on the facets.

strip     the facets in the order in which the planes reach them, so that a trial plane looks only at those
          near it.
opposite  the nearest point of the other pass, where the way there runs across the passes.
samples   points of a pass, at least one in each facet segment and no further apart than a given step.
centres   where the ball's centre runs over a pass: beside each facet at the radius, and on an arc about each
          co-edge.

The scallop is that over the circle through two opposite contacts, with the curvature of the smooth surface
behind the facets. The ball is steered by facet normals, so it stands a little aside of where the smooth
surface would put it. How far is measured from the centres themselves; the worst case of one edge between the
two contacts bounds it.
"""

from __future__ import annotations

import math
from functools import cached_property

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.vectors import row_dot
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .scallop import TINY, compute_turn, facet_curvature, flat_interval, kink_factor, scallop_height

ACROSS = 0.5
"""Largest cosine between a pass and the way to the other one: beyond it the other pass ends there and lies
not opposite."""

DENSE = 0.25
"""Step of the centres, in steps of the samples: half of it, along the pass, adds 1 % to the distance
across."""

NEARLY = 0.9
"""Share of the largest bound above which samples are measured first: the largest scallop is mostly among
them."""

LEVEL = 1e-3
"""Least slope and least spread of the centres that a prediction divides by."""


class FacetPass:
    """What one plane cuts, in no order, for measuring.

    ``start`` and ``way`` (m, 3) mm of each facet segment; ``normal`` (m, 3) unit and ``tensor`` (6, m) 1/mm
    of its facet; ``coedge`` (2, m) that it starts and ends on; ``point`` (n, 3) mm and ``segment`` (n,) of
    each sample.
    """

    def __init__(
        self, start: Floats, end: Floats, normal: Floats, tensor: Floats, coedge: Ints, step: float
    ) -> None:
        self.start, self.way, self.normal, self.tensor, self.coedge, self._step = (
            start,
            end - start,
            normal,
            tensor,
            coedge,
            step,
        )
        self.point, self.segment = self._samples(step)

    def __len__(self) -> int:
        return len(self.point)

    @cached_property
    def tree(self) -> scipy.spatial.cKDTree:
        """Of the samples."""
        return scipy.spatial.cKDTree(self.point)

    def centre_tree(self, radius: float) -> scipy.spatial.cKDTree:
        """Of the ball's centres over the pass; ``radius`` mm, always the same."""
        if self._centre_tree is None:
            point, segment = self._samples(DENSE * self._step)
            self._centre_tree = scipy.spatial.cKDTree(
                np.concatenate([point + radius * self.normal[segment], self._arcs(radius)])
            )
        return self._centre_tree

    _centre_tree: scipy.spatial.cKDTree | None = None

    def _samples(self, step: float) -> tuple[Floats, Ints]:
        segment, share = _split(np.linalg.norm(self.way, axis=1), step)
        point: Floats = self.start[segment] + share[:, None] * self.way[segment]
        return point, segment

    def _arcs(self, radius: float) -> Floats:
        """Centres (n, 3) about the co-edges that two segments share."""
        coedge = self.coedge.reshape(-1)
        order = np.argsort(coedge, kind="stable")
        pair = np.flatnonzero(coedge[order][1:] == coedge[order][:-1])
        one, other = order[pair], order[pair + 1]
        count = len(self.start)
        at = self.start[one % count] + (one >= count)[:, None] * self.way[one % count]
        first, second = self.normal[one % count], self.normal[other % count]
        arc, share = _split(radius * np.linalg.norm(second - first, axis=1), DENSE * self._step)
        normal = first[arc] + share[:, None] * (second - first)[arc]
        length = np.maximum(np.linalg.norm(normal, axis=1), TINY)
        centres: Floats = at[arc] + (radius / length)[:, None] * normal
        return centres


def _split(length: Floats, step: float) -> tuple[Ints, Floats]:
    """Pieces of at most ``step``: the row of each and the share of its length at which its middle lies."""
    pieces = np.maximum(np.ceil(length / step), 1.0).astype(np.int64)
    row, place = number_runs(pieces)
    return row, (place + 0.5) / pieces[row]


class Strip:
    """The facets that are cut, in the order in which planes reach them, so that a plane looks only at those
    near it.

    ``ranges``: the spans of offsets, mm, that facets cover without a gap; ``area`` mm2 of all of them.
    """

    def __init__(self, mesh: Mesh, across: Floats, rows: Ints) -> None:
        self._mesh, self.across = mesh, across
        height = (mesh.vertex @ across)[mesh.face[rows]]
        low = height.min(axis=1)
        order = np.argsort(low, kind="stable")
        self._rows, self._corner, self._low = rows[order], height[order], low[order]
        self._high = self._corner.max(axis=1)
        self._active, self._taken = np.empty(0, dtype=np.int64), 0
        self._last: tuple[tuple[float, float], FacetPass] | None = None
        self.ranges = self._find_covered()
        self.area = float(mesh.area[rows].sum())

    def _find_covered(self) -> list[tuple[float, float]]:
        rows = np.flatnonzero(self._high > self._low)  # a facet that lies in a plane is cut by none
        if not len(rows):
            return []
        low, top = self._low[rows], np.maximum.accumulate(self._high[rows])
        gap = np.flatnonzero(low[1:] > top[:-1])
        return [
            *zip(low[np.append(0, gap + 1)].tolist(), top[np.append(gap, len(top) - 1)].tolist(), strict=True)
        ]

    @cached_property
    def _tensor(self) -> Floats:
        return facet_curvature(self._mesh)

    def cut(self, offset: float, step: float) -> FacetPass:
        """Return the pass of the plane at ``offset``, mm, with samples at most ``step`` mm apart; the last
        one is remembered."""
        if self._last is None or self._last[0] != (offset, step):
            self._last = (offset, step), self._cut(offset, step)
        return self._last[1]

    def _cut(self, offset: float, step: float) -> FacetPass:
        begun = int(np.searchsorted(self._low, offset, side="right"))
        if begun > self._taken:
            self._active = np.concatenate([self._active, np.arange(self._taken, begun)])
            self._taken = begun
        at = self._active[(self._low[self._active] <= offset) & (self._high[self._active] > offset)]
        height, row = self._corner[at] - offset, self._rows[at]
        above = height > 0.0
        lone = np.argmax(
            above == (above.sum(axis=1) == 1)[:, None], axis=1
        )  # the corner alone on its side of the plane
        start, end = (self._crossing(row, height, lone, (lone + k) % 3) for k in (1, 2))
        sides = self._mesh.face_coedge[row]
        coedge = np.array([sides[np.arange(len(at)), k % 3] for k in (lone, lone + 2)])
        return FacetPass(start, end, self._mesh.normal[row], self._tensor[:, row], coedge, step)

    def _crossing(self, face: Ints, height: Floats, one: Ints, other: Ints) -> Floats:
        """Where the edges (n,) from corner ``one`` to corner ``other`` cross the plane that ``height`` (n, 3)
        is counted from."""
        row = np.arange(len(face))
        corner = self._mesh.face[face]
        a, b = height[row, one], height[row, other]
        start, end = self._mesh.vertex[corner[row, one]], self._mesh.vertex[corner[row, other]]
        point: Floats = start + (a / (a - b))[:, None] * (end - start)
        return point

    def pass_by(self, offset: float) -> None:
        """Forget the facets that end before ``offset``: no plane comes back to them."""
        self._active = self._active[self._high[self._active] > offset]

    def rewind(self, offset: float) -> None:
        """Go back to ``offset``."""
        self._taken = int(np.searchsorted(self._low, offset, side="right"))
        self._active = np.flatnonzero(self._high[: self._taken] > offset)


def smallest_interval(here: FacetPass, across: Floats, radius: float, scallop: float) -> float:
    """Return the smallest interval along a pass, mm: eq. (2) of Lin & Ye for the local slope and curvature.

    ``across`` (3,) unit, from plane to plane; ``radius``, ``scallop`` mm.
    """
    side = across - (here.normal @ across)[:, None] * here.normal
    slope = np.linalg.norm(side, axis=1)
    side /= np.maximum(slope, LEVEL)[:, None]
    spread = 1.0 + radius * row_dot(compute_turn(here.tensor, side), side)
    share = slope / np.sqrt(np.maximum(spread, LEVEL))
    return flat_interval(radius, scallop) * float(share.min(initial=1.0 / LEVEL))


def scallop_between(one: FacetPass, other: FacetPass, radius: float) -> tuple[float, Floats]:
    """Return the largest scallop between two neighbouring passes, mm, and the contact (3,) next to it; 0
    where none lie opposite."""
    worst, place = 0.0, np.zeros(3)
    for a, b in ((one, other), (other, one)):
        if len(a) and len(b):
            row, height = _largest(_Opposite(a, b, radius))
            if height > worst:
                worst, place = height, a.point[row]
    return worst, place


def _largest(pairs: _Opposite) -> tuple[int, float]:
    """Row and value of the largest scallop. The centres are asked only where the bound leaves room for a
    larger one."""
    row, largest, low, high = 0, 0.0, NEARLY * float(pairs.bound.max()), math.inf
    while high > largest:
        rows = np.flatnonzero((pairs.bound > low) & (pairs.bound <= high))
        height = pairs.measure(rows)
        if len(rows) and height.max() > largest:
            row, largest = int(rows[np.argmax(height)]), float(height.max())
        low, high = largest, low
    return row, largest


class _Opposite:
    """The samples of one pass with the opposite points of another one.

    ``bound`` (n,) mm: the worst case of the scallop, an edge between the contacts; 0 where nothing lies
    opposite.
    """

    def __init__(self, one: FacetPass, other: FacetPass, radius: float) -> None:
        self._one, self._other, self._radius = one, other, radius
        there = other.segment[other.tree.query(one.point)[1]]
        self._across, self._chord, opposite = _way_over(one.point, other.start[there], other.way[there])
        turned = compute_turn(0.5 * (one.tensor[:, one.segment] + other.tensor[:, there]), self._across)
        self._curvature = row_dot(turned, self._across)
        first, second = one.normal[one.segment], other.normal[there]
        self._upward = _unit(first + second)
        kink = second - first - self._chord[:, None] * turned
        travel = np.cross(self._across, self._upward)
        down, up = np.abs(row_dot(second, self._across)), np.abs(row_dot(first, self._across))
        far = np.maximum(down, up) / np.maximum(down + up, TINY)  # where the planes of both facets meet
        factor = kink_factor(
            self._chord, radius, row_dot(kink, self._across), np.abs(row_dot(kink, travel)), far
        )
        height = scallop_height(self._chord, radius, self._curvature) * factor
        self.bound = np.where(opposite, height, 0.0)

    def measure(self, rows: Ints) -> Floats:
        """Scallop (n,) mm at these samples, from the nearest centres on both sides.

        Over a circle ``d^2 = r^2 + (1 + r curvature) c^2``: d from the surface to the centre, c to the
        contact below it. From a point midway both c together are the chord that would leave the same scallop.
        """
        chord, curvature, upward = self._chord[rows], self._curvature[rows], self._upward[rows]
        middle = self._one.point[rows] + (0.5 * chord)[:, None] * self._across[rows]
        middle += (0.125 * curvature * chord * chord)[:, None] * upward
        spread = np.maximum(1.0 + self._radius * curvature, LEVEL)
        reach = np.zeros(len(rows))
        for side in (self._one, self._other):
            distance = side.centre_tree(self._radius).query(middle)[0]
            reach += np.sqrt(np.maximum(distance * distance - self._radius**2, 0.0) / spread)
        return np.minimum(scallop_height(reach, self._radius, curvature), self.bound[rows])


def _way_over(point: Floats, start: Floats, way: Floats) -> tuple[Floats, Floats, Bools]:
    """Return unit way (n, 3) across, its length (n,) mm, and whether it is one: from points to the segments
    of another pass.

    Where the other pass ends the way leans along it; only the part across counts.
    """
    length = np.maximum(np.linalg.norm(way, axis=1), TINY)
    along = way / length[:, None]
    share = np.clip(((point - start) * along).sum(axis=1), 0.0, length)
    across = start + share[:, None] * along - point
    past = (across * along).sum(axis=1)
    opposite = np.abs(past) <= ACROSS * np.linalg.norm(across, axis=1)
    across -= past[:, None] * along
    chord = np.maximum(np.linalg.norm(across, axis=1), TINY)
    return across / chord[:, None], chord, opposite


def _unit(vector: Floats) -> Floats:
    result: Floats = vector / np.maximum(np.linalg.norm(vector, axis=1), TINY)[:, None]
    return result
