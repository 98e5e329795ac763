# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curvature of the surface along a pass from two neighbouring contact points and their normals (Lin & Ye,
III.B, eq. 8).

normal lines   of two successive points meet in the centre of a circle; its distances R1 and R2 from them
               differ, because a mesh is no smooth surface. The paper takes their mean R.
circle         of radius R through both points (eq. 8): its centre lies R from either.

In the plane of the chord L and the mean normal, with the normals leaning by a1 and a2 from across the chord
towards the travel,

    ``R1 = L cos a2 / sin(a2 - a1)``, ``R2 = L cos a1 / sin(a2 - a1)``, so ``R = L cos((a1 + a2) / 2) / (2
    sin((a2 - a1) / 2))``.

The curvature 1/R is positive where the surface is convex, and 0 where the normals are parallel. It is a look
at one facet and the co-edges on its two sides: exact on an arc, and without bound on a sliver, whose turn is
a whole facet's. The intervals of the passes use the mean over a facet's neighbourhood instead
(``scallop.facet_curvature``); docs/lin-ye.md compares them.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats

from .contact_path import ContactPath

SHORT = 1e-9
"""mm; two points nearer than this say nothing of a curvature."""


def arc_curvature(one: Floats, two: Floats, normal_one: Floats, normal_two: Floats) -> Floats:
    """1/R (n,) 1/mm between points (n, 3) mm with unit normals (n, 3); NaN where the points are one or a
    normal is along the chord."""
    return _arc(one, two, normal_one, normal_two)[0]


def arc_centre(one: Floats, two: Floats, normal_one: Floats, normal_two: Floats) -> Floats:
    """Return the centre (n, 3) mm of the circle of eq. (8): R from either point, in the plane of chord and
    mean normal. NaN where there is none: on a flat, and where R is shorter than half the chord."""
    curvature, across, length = _arc(one, two, normal_one, normal_two)
    with np.errstate(divide="ignore", invalid="ignore"):
        radius = 1.0 / curvature
        height = np.sign(radius) * np.sqrt(radius * radius - 0.25 * length * length)
        centre: Floats = 0.5 * (one + two) - np.where(np.isfinite(height), height, np.nan)[:, None] * across
    return centre


def _arc(one: Floats, two: Floats, normal_one: Floats, normal_two: Floats) -> tuple[Floats, Floats, Floats]:
    """1/R (n,), the unit direction (n, 3) across the chord in the plane of the mean normal, and the chord's
    length (n,)."""
    chord, mean = two - one, normal_one + normal_two
    length = np.linalg.norm(chord, axis=1)
    along = chord / np.maximum(length, SHORT)[:, None]
    across = mean - (mean * along).sum(axis=1)[:, None] * along
    size = np.linalg.norm(across, axis=1)
    across = across / np.maximum(size, SHORT)[:, None]
    lean_one, lean_two = (
        np.arctan2((normal * along).sum(axis=1), (normal * across).sum(axis=1))
        for normal in (normal_one, normal_two)
    )
    share = length * np.cos(0.5 * (lean_one + lean_two))
    usable = (length > SHORT) & (size > SHORT) & (share > SHORT)
    curvature = 2.0 * np.sin(0.5 * (lean_two - lean_one)) / np.where(usable, share, 1.0)
    return np.where(usable, curvature, np.nan), across, length


def pass_curvature(contact: ContactPath) -> Floats:
    """Return the curvature (s,) 1/mm along each segment of the contact path, from its co-edge normals: the
    mean of both facets' at either end (Lin & Ye, Fig. 7). NaN at the ends of open polylines, where one
    neighbour is missing, and on segments of no length."""
    normal, point, line = contact.normal[::2], contact.point, contact.polyline[::2]
    s = len(normal)
    before, after = np.arange(-1, s - 1), np.arange(1, s + 1)
    first = np.flatnonzero(np.diff(line, prepend=-1))
    last = np.append(first[1:], s)[: len(first)] - 1
    closed = (point[2 * first] == point[2 * last + 1]).all(axis=1)
    before[first], after[last] = np.where(closed, last, -1), np.where(closed, first, -1)
    ends = []
    for beside in (before, after):
        mean = normal + normal[beside]
        ends.append(mean / np.maximum(np.linalg.norm(mean, axis=1), SHORT)[:, None])
    found = arc_curvature(point[::2], point[1::2], *ends)
    return np.where((before < 0) | (after < 0), np.nan, found)
