# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distance over a surface, in the metric of the scallop: one unit is one admissible step.

scallop   between two passes of a ball of radius r that are d apart: with the curvature tensor T of the
          surface (1/mm, convex positive) the tube of the ball about a pass at x leaves ``x . (1 + r T) x /
          2r`` over the point at 0, to second order. The nearest point of a pass at ``d / 2`` along unit c
          gives the height ``d^2 / (8 r c . (1 + r T)^-1 c)``.
metric    ``G = (1 + r T) / s^2``, s the step on a flat: level sets one unit of G apart leave that scallop
          whichever way they run (Kim, Computer-Aided Design 39 (2007), 477-489; Zou et al., Computer-Aided
          Design 53 (2014), 117-125).
heat      the distance by the heat method (Crane, Weischedel, Wardetzky, ACM Trans. Graph. 32 (2013), 152):
          heat flows from the source for a short time; its gradient says which way the distance grows; a
          Poisson equation finds the function that grows that way with slope 1.

All arrays are plain: ``vertex`` (v, 3) mm, ``face`` (f, 3); a metric is (3, f): G11, G12, G22 in the facet's
:func:`frames`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.chunks import meanwhile
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.vectors import row_dot

FLATTEST = 1.0 / 16.0
"""Least ``1 + r curvature``: in a hollow of nearly the ball's radius a step would have no end; it is at most
four of a flat."""

FADED = 300.0
"""Units of heat's decay from the source to the farthest place at most: e^-300 is still a number with all its
digits."""

ROUNDS = 2
"""Times that the slope is set right once more: where fronts of heat meet aslant the first direction is
smeared."""

TINY = 1e-300


class Frames(NamedTuple):
    """``one`` and ``two`` (f, 3): unit and perpendicular, in the facets; ``slope`` (3, 2, f): the gradients
    of the corners' hat functions in them, 1/mm; ``area`` (f,) mm2."""

    one: Floats
    two: Floats
    slope: Floats
    area: Floats


def frames(vertex: Floats, face: Ints) -> Frames:
    """Of facets with an area."""
    a, b, c = (vertex[corner] for corner in face.T)
    normal = np.cross(b - a, c - a)
    twice = np.linalg.norm(normal, axis=1)
    one = (b - a) / np.linalg.norm(b - a, axis=1)[:, None]
    two = np.cross(normal / twice[:, None], one)
    slope = np.empty((3, 2, len(face)))
    for corner, side in enumerate(
        (c - b, a - c, b - a)
    ):  # the hat of a corner falls towards the side opposite
        slope[corner] = -row_dot(side, two) / twice, row_dot(side, one) / twice
    return Frames(one, two, slope, 0.5 * twice)


def scallop_metric(
    frame: Frames,
    tensor: Floats,
    radius: Floats | float,
    flat: Floats | float,
    least: Floats | float = FLATTEST,
) -> Floats:
    """Return the metric (3, f) 1/mm2 of a ball of ``radius`` mm whose passes stand ``flat`` mm apart on a
    flat; ``tensor`` (6, f) 1/mm as of :func:`~.scallop.facet_curvature`; ``least``: of ``1 + r curvature``.
    Radius, step and least are one for all facets or (f,)."""
    xx, yy, zz, xy, yz, zx = tensor

    def bend(one: Floats, two: Floats) -> Floats:
        x, y, z = one.T
        u, v, w = two.T
        return np.asarray(
            xx * x * u
            + yy * y * v
            + zz * z * w
            + xy * (x * v + y * u)
            + yz * (y * w + z * v)
            + zx * (z * u + x * w)
        )

    a, b, d = (
        1.0 + radius * bend(frame.one, frame.one),
        radius * bend(frame.one, frame.two),
        radius * bend(frame.two, frame.two),
    )
    return _at_least(np.array([a, b, 1.0 + d]), least) / (flat * flat)


def as_tensor(frame: Frames, metric: Floats) -> Floats:
    """Return the metric as a tensor (6, f) in space: xx, yy, zz, xy, yz, zx."""
    (a, b, d), one, two = metric, frame.one.T, frame.two.T
    rows, columns = [0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]
    mixed = one[rows] * two[columns] + two[rows] * one[columns]
    return np.asarray(a * one[rows] * one[columns] + b * mixed + d * two[rows] * two[columns])


def _at_least(metric: Floats, least: Floats | float) -> Floats:
    """Return the metric with no eigenvalue below ``least``."""
    a, b, d = metric
    mean, half, turn = 0.5 * (a + d), 0.5 * np.hypot(a - d, 2.0 * b), 0.5 * np.arctan2(2.0 * b, a - d)
    high, low = np.maximum(mean + half, least), np.maximum(mean - half, least)
    cosine, sine = np.cos(turn), np.sin(turn)
    both = high * cosine**2 + low * sine**2, (high - low) * cosine * sine, high * sine**2 + low * cosine**2
    return np.array(both)


def side_lengths(vertex: Floats, face: Ints, frame: Frames, metric: Floats) -> Floats:
    """Return the lengths (3, f) of the sides in the metric, in steps; side k joins corners k and k + 1."""
    side = np.roll(face, -1, axis=1).T, face.T
    way = [vertex[end] - vertex[start] for end, start in zip(*side, strict=True)]
    local = np.array([(row_dot(one, frame.one), row_dot(one, frame.two)) for one in way])
    x, y = local[:, 0], local[:, 1]
    return np.asarray(np.sqrt(metric[0] * x * x + 2.0 * metric[1] * x * y + metric[2] * y * y))


def gradient(frame: Frames, face: Ints, value: Floats) -> Floats:
    """(2, f) of a field (v,) at the vertices, in the frames, 1/mm."""
    return np.asarray(sum(value[corner] * slope for corner, slope in zip(face.T, frame.slope, strict=True)))


def steepness(metric: Floats, slope: Floats) -> Floats:
    """Return the length (f,) of a gradient (2, f) in the metric: 1 where one level more is one admissible
    step."""
    (a, b, d), (x, y) = metric, slope
    return np.asarray(np.sqrt(np.maximum((d * x * x - 2.0 * b * x * y + a * y * y) / (a * d - b * b), 0.0)))


def step_across(metric: Floats, slope: Floats) -> Floats:
    """Return the admissible step (f,) mm across level sets with a gradient (2, f), along that gradient over
    the surface."""
    length = np.hypot(*slope)
    x, y = np.where(length > 0.0, slope / np.maximum(length, TINY), np.array([[1.0], [0.0]]))
    (a, b, d) = metric
    return np.asarray(np.sqrt((d * x * x - 2.0 * b * x * y + a * y * y) / (a * d - b * b)))


def distance(
    vertex: Floats, face: Ints, frame: Frames, metric: Floats, source: Ints, known: Floats
) -> Floats:
    """Return the distance (v,), in units of the metric, from ``source`` (m,) vertices where it is ``known``
    (m,), at least 0.

    Every component of the surface needs a source.
    """
    count = len(vertex)
    weight = frame.area * np.sqrt(metric[0] * metric[2] - metric[1] ** 2)
    free = np.ones(count, np.bool_)
    free[source] = False
    inner = np.flatnonzero(free)
    stiff = _stiffness(face, frame, metric, count, clipped=False)
    factored: list[Factored] = []

    def spread() -> tuple[Floats, Floats]:
        length = side_lengths(vertex, face, frame, metric)
        bound = _along_sides(face, length, source, known, count)
        step = max(float(np.sqrt(np.mean(length * length))), float(bound.max()) / FADED)
        return bound, _warmth(face, frame, metric, weight, source, known, step, inner, count)

    bound, warmth = meanwhile(lambda: factored.append(Factored(stiff, inner)), spread)
    value, way, poisson = np.zeros(count), -gradient(frame, face, warmth), factored[0]
    value[source] = known
    lost = ~(np.hypot(*way) > TINY)
    way[:, lost] = gradient(frame, face, bound)[:, lost]
    for _ in range(1 + ROUNDS):
        fixed = np.where(free, 0.0, value)
        value[inner] = poisson.solve(_outflow(face, frame, metric, weight, way, count) - stiff @ fixed)
        way = gradient(frame, face, value)
    return np.clip(value, 0.0, bound)


def _warmth(
    face: Ints,
    frame: Frames,
    metric: Floats,
    weight: Floats,
    source: Ints,
    known: Floats,
    step: float,
    inner: Ints,
    count: int,
) -> Floats:
    """How warm (v,) each vertex is a ``step`` of time after heat was let in at the source, less where its
    distance is larger."""
    mass = np.bincount(face.T.reshape(-1), np.tile(weight / 3.0, 3), count)
    heat = scipy.sparse.csc_matrix(_stiffness(face, frame, metric, count, clipped=True) * (step * step))
    heat.setdiag(heat.diagonal() + mass)
    warmth = np.zeros(count)
    warmth[source] = np.exp(-known / step)
    warmth[inner] = np.maximum(Factored(heat, inner).solve(-(heat @ warmth)), 0.0)
    return warmth


def spread_between(face: Ints, frame: Frames, metric: Floats, low: Ints, high: Ints) -> Floats:
    """Solve the Laplace equation of the metric: a field (v,) that is 0 at the vertices ``low`` (m,) and 1 at
    ``high`` (k,), between them without summit or basin, and level across every other border. 0 where a
    component has vertices of one of them only."""
    count = int(face.max(initial=-1)) + 1
    stiff, value, free = (
        _stiffness(face, frame, metric, count, clipped=True),
        np.zeros(count),
        np.ones(count, np.bool_),
    )
    value[high], free[low], free[high] = 1.0, False, False
    component = scipy.sparse.csgraph.connected_components(stiff, directed=False)[1]
    free &= np.isin(component, np.intersect1d(component[low], component[high]))
    value[~np.isin(component, component[low])] = 0.0
    inner = np.flatnonzero(free)
    if len(inner):
        value[inner] = np.clip(Factored(stiff, inner).solve(-(stiff @ value)), 0.0, 1.0)
    return value


def _along_sides(face: Ints, length: Floats, source: Ints, known: Floats, count: int) -> Floats:
    """Return the distance (v,) along sides of facets only: never less than that over the surface."""
    start, end = face.T.reshape(-1), np.roll(face, -1, axis=1).T.reshape(-1)
    root = np.full(len(source), count)
    rows, columns = np.concatenate([start, end, root]), np.concatenate([end, start, source])
    weight = np.concatenate([np.tile(length.reshape(-1), 2), known])
    order = _order_by_count(columns, count + 1)
    order = order[_order_by_count(rows[order], count + 1)]
    rows, columns = rows[order], columns[order]
    first = np.flatnonzero(np.append(True, (np.diff(rows) != 0) | (np.diff(columns) != 0)))
    shortest = np.minimum.reduceat(weight[order], first)  # of two facets on one side the shorter counts
    graph = scipy.sparse.coo_matrix(
        (np.maximum(shortest, 1e-12), (rows[first], columns[first])), (count + 1, count + 1)
    ).tocsr()
    return np.asarray(scipy.sparse.csgraph.dijkstra(graph, indices=count)[:count])


def _order_by_count(key: Ints, count: int) -> Ints:
    """Return the order (n,) of keys (n,) from 0 to ``count`` - 1 by counting them, equal ones as they come:
    rows of a sparse matrix are filled so, in far less time than sorting takes."""
    place = np.arange(len(key))
    return np.asarray(
        scipy.sparse.coo_matrix((np.ones(len(key), np.int8), (key, place)), (count, len(key))).tocsr().indices
    )


def _stiffness(
    face: Ints, frame: Frames, metric: Floats, count: int, clipped: bool
) -> scipy.sparse.csc_matrix:
    """Return the Laplacian of the metric, positive (cotangent weights for a flat one). ``clipped``: without
    what flows uphill over obtuse corners, so that no heat ever is negative."""
    (a, b, d), root = metric, np.sqrt(metric[0] * metric[2] - metric[1] ** 2)
    rows, columns, values = [], [], []
    for k in range(3):
        (x, y), (u, v) = frame.slope[k], frame.slope[(k + 1) % 3]
        flow = -frame.area * (d * x * u - b * (x * v + y * u) + a * y * v) / root
        flow = np.maximum(flow, 0.0) if clipped else flow
        i, j = face[:, k], face[:, (k + 1) % 3]
        rows += [i, j, i, j]
        columns += [j, i, i, j]
        values += [-flow, -flow, flow, flow]
    whole: Any = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
    return scipy.sparse.coo_matrix(whole, (count, count)).tocsc()


def _outflow(face: Ints, frame: Frames, metric: Floats, weight: Floats, way: Floats, count: int) -> Floats:
    """Return what (v,) the field of slope 1 along ``way`` (2, f), a gradient, takes out of each vertex: the
    Poisson equation's side."""
    (a, b, d), (x, y) = metric, way / np.maximum(steepness(metric, way), TINY)
    determinant = a * d - b * b
    up = weight * (d * x - b * y) / determinant, weight * (a * y - b * x) / determinant
    flows = [slope[0] * up[0] + slope[1] * up[1] for slope in frame.slope]
    return np.asarray(np.bincount(face.T.reshape(-1), np.concatenate(flows), count), np.float64)


SYMMETRIC: Any = {
    "permc_spec": "MMD_AT_PLUS_A", "diag_pivot_thresh": 0.0, "relax": 1, "panel_size": 4,
    "options": {"SymmetricMode": True},
}  # fmt: skip
"""For SuperLU. With ``relax`` of its own, 10 to 20, subtrees of few columns are taken for dense ones: 7 times
slower here."""


class Factored:
    """A symmetric system in some of its unknowns, factored once and solved often."""

    def __init__(self, matrix: scipy.sparse.csc_matrix, inner: Ints) -> None:
        self._inner = inner
        own = matrix[inner][:, inner].tocsc()
        self._factors = scipy.sparse.linalg.splu(own, **SYMMETRIC) if len(inner) else None

    def solve(self, right: Floats) -> Floats:
        """Return the inner unknowns (m,) for a right side (v,)."""
        return np.empty(0) if self._factors is None else np.asarray(self._factors.solve(right[self._inner]))
