# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact distance of many points from many segments or facets.

element   a segment or a facet.
piece     a part of an element, small enough to be found by its middle; long elements make many.
reach     the largest distance of any point of a piece from the middle of its piece.

The k pieces with the nearest middles are tried. An element that is not among them has no point nearer than
the k-th middle less the reach: where the best found is nearer than that, it is the nearest of all, and so are
all that are as near (:func:`search`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats, Ints, freeze, number_runs
from freecad_fiveaxis.core.base.vectors import dot

FIRST_TRIED, MORE = 8, 4
"""Pieces tried for each point, and how many times as many in the next round."""
NEARLY = 0.05
"""Relative error of far places: among many lines that are all far, the very nearest takes long to find, and
tells no more."""
TOGETHER = 4096
"""Points worked on at a time in the first round: their columns stay in the processor's cache."""
SPARE = 4096
"""Pieces that are allowed beside two for each element, so that a few large elements are cut small as well."""
MOST_ROUNDS = 40
"""Of halving facets: the largest is then a millionth of what it was."""


@dataclass(frozen=True, eq=False)
class Pieces:
    """``middle`` (p, 3) mm; ``element`` (p,) the row of the element; ``reach`` mm."""

    middle: Floats
    element: Ints
    reach: float

    def __post_init__(self) -> None:
        freeze(self, None, middle="f3", element="i")
        object.__setattr__(self, "tree", scipy.spatial.cKDTree(self.middle))

    def clear_by(self, points: Floats) -> Floats:
        """Return a distance (n,) mm that no element is nearer to the points (n, 3) than."""
        far: Floats = self.tree.query(points)[0]  # type: ignore[attr-defined]
        return np.maximum(far - self.reach, 0.0)


Squared = Callable[[Floats, Ints], Floats]
"""Squared distance (n, k) of points (n, 3 or more) from elements (n, k)."""
Resolve = Callable[[Floats, Ints, Floats], Floats]
"""What is wanted of points (n, 3 or more), from the elements (n, k) tried and their squared distances (n, k):
(n, w)."""


def search(
    points: Floats,
    pieces: Pieces,
    squared: Squared,
    resolve: Resolve,
    width: int,
    rough: float = np.inf,
    progress: Progress = silent,
) -> Floats:
    """``resolve`` (n, ``width``) of every point; the nearest elements are among those that it is given.

    ``points`` (n, 3) mm, or wider: what follows the place is handed on to ``squared`` and ``resolve``. Places
    that are farther than ``rough`` times the pieces' reach get an element that is at most ``NEARLY`` and the
    reach farther than the nearest.
    """
    most = len(pieces.middle)
    result = np.empty((len(points), width))
    open_, count = np.arange(len(points)), min(FIRST_TRIED, most)
    if np.isfinite(rough):
        far, at = pieces.tree.query(points[:, :3], 1, eps=NEARLY)  # type: ignore[attr-defined]
        rows = np.flatnonzero(far > (1.0 + NEARLY) * rough * pieces.reach)
        element = pieces.element[at[rows]][:, None]
        result[rows] = resolve(points[rows], element, squared(points[rows], element))
        open_ = np.setdiff1d(open_, rows)
    while len(open_):
        left, together = [], max(TOGETHER * FIRST_TRIED // count, 1)
        for first in range(0, len(open_), together):
            progress("nearest places", 1.0 - (len(open_) - first) / len(points))
            rows = open_[first : first + together]
            here = points[rows]
            far, at = (found.reshape(len(rows), count) for found in pieces.tree.query(here[:, :3], count))  # type: ignore[attr-defined]
            element = pieces.element[at]
            distance2 = squared(here, element)
            certain = np.maximum(far[:, -1] - pieces.reach, 0.0)
            done = (certain**2 >= distance2.min(axis=1)) | (count == most)
            result[rows[done]] = resolve(here[done], element[done], distance2[done])
            left.append(rows[~done])
        open_, count = np.concatenate(left), min(count * MORE, most)
    return result


def nearest(points: Floats, elements: Ints, distance2: Floats) -> Floats:
    """Return a ``resolve``: distance mm and row of the nearest element."""
    best = distance2.argmin(axis=1)
    rows = np.arange(len(best))
    return np.column_stack([np.sqrt(distance2[rows, best]), elements[rows, best]])


# ------------------------------------------------------------------------------------------------ segments


@dataclass(frozen=True, eq=False)
class Segments:
    """``start``, ``end`` (s, 3) mm; a segment may be a point. ``table`` (7, s): start, direction, squared
    length."""

    start: Floats
    end: Floats

    def __post_init__(self) -> None:
        freeze(self, None, start="f3", end="f3")
        along = self.end - self.start
        object.__setattr__(
            self, "table", np.concatenate([self.start.T, along.T, (along * along).sum(axis=1)[None]])
        )

    def share(self, points: Floats, element: Ints) -> Floats:
        """Where on the segments ``element`` (n, k) the feet of ``points`` (n, 3) lie, 0 to 1."""
        return self._foot(points, element)[0]

    def square_distances(self, points: Floats, element: Ints) -> Floats:
        """Squared distances (n, k) of ``points`` (n, 3) from the segments ``element`` (n, k)."""
        share, off, along = self._foot(points, element)
        result = np.zeros_like(share)
        for p, v in zip(off, along, strict=True):
            p -= share * v
            p *= p
            result += p
        return result

    def _foot(self, points: Floats, element: Ints) -> tuple[Floats, list[Floats], list[Floats]]:
        table: Floats = self.table  # type: ignore[attr-defined]
        off = [points[:, j, None] - table[j].take(element) for j in range(3)]
        along = [table[3 + j].take(element) for j in range(3)]
        ahead, length2 = dot(off, along), table[6].take(element)
        share = np.divide(ahead, length2, out=np.zeros_like(ahead), where=length2 > 0.0)
        return np.clip(share, 0.0, 1.0, out=share), off, along

    def pieces(self) -> Pieces:
        """Segments longer than half the mean are cut into pieces no longer than that."""
        length = np.linalg.norm(self.end - self.start, axis=1)
        longest = max(float(length.sum()) / (2.0 * len(length) + SPARE), 1e-9)
        count = np.maximum(np.ceil(length / longest), 1.0).astype(np.int64)
        element, step = number_runs(count)
        share = ((step + 0.5) / count[element])[:, None]
        middle = self.start[element] + share * (self.end - self.start)[element]
        return Pieces(middle, element, float((length / count).max(initial=0.0)) / 2.0)


# ------------------------------------------------------------------------------------------------ facets


@dataclass(frozen=True, eq=False)
class Facets:
    """``corner`` (3, f, 3) mm and the outward unit ``normal`` (f, 3). ``table`` (15, f): first corner, the
    sides b and c from there to the others, the normal, and b.b, b.c, c.c."""

    corner: Floats
    normal: Floats

    def __post_init__(self) -> None:
        a, b, c = self.corner[0].T, (self.corner[1] - self.corner[0]).T, (self.corner[2] - self.corner[0]).T
        squares = [(b * b).sum(axis=0)[None], (b * c).sum(axis=0)[None], (c * c).sum(axis=0)[None]]
        object.__setattr__(self, "table", np.concatenate([a, b, c, self.normal.T, *squares]))

    def square_distances(self, points: Floats, element: Ints) -> Floats:
        """Squared distances (n, k) of ``points`` (n, 3) from the facets ``element`` (n, k): from the plane
        over the facet, else from its nearest side. All from the inner products of the point (from the first
        corner) with the sides."""
        table: Floats = self.table  # type: ignore[attr-defined]
        off = [points[:, j, None] - table[j].take(element) for j in range(3)]
        along_b, along_c, height = (
            dot(off, [table[first + j].take(element) for j in range(3)]) for first in (3, 6, 9)
        )
        bb, bc, cc = (table[j].take(element) for j in (12, 13, 14))
        square = dot(off, off)
        v, w = cc * along_b - bc * along_c, bb * along_c - bc * along_b
        inside = (v >= 0.0) & (w >= 0.0) & (v + w <= bb * cc - bc * bc)
        best = np.minimum(_to_side(square, along_b, bb), _to_side(square, along_c, cc))
        third = _to_side(square - 2.0 * along_b + bb, along_c - along_b - bc + bb, bb - 2.0 * bc + cc)
        return np.where(inside, height * height, np.maximum(np.minimum(best, third), height * height))

    def sign_distances(self, points: Floats, elements: Ints, distance2: Floats) -> Floats:
        """Return a ``resolve``: distance mm, below 0 inside the part, and row of the nearest facet.

        Of facets that are as near (their common edge or corner is nearest) the one decides which is seen most
        from its face.
        """
        least = distance2.min(axis=1)
        tied = distance2 <= (least * (1.0 + 1e-9) + 1e-18)[:, None]
        height = ((points[:, None] - self.corner[0][elements]) * self.normal[elements]).sum(axis=-1)
        best = np.where(tied, np.abs(height), -1.0).argmax(axis=1)
        rows = np.arange(len(best))
        inside = height[rows, best] < 0.0
        return np.column_stack([np.where(inside, -1.0, 1.0) * np.sqrt(least), elements[rows, best]])

    def pieces(self) -> Pieces:
        """Facets halved across their longest side until none reaches farther than a mean facet."""
        a, b, c = self.corner
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2.0
        wanted = max(float(np.sqrt(2.0 * area / (len(a) + SPARE))), 1e-9)
        corner, element, middles, owners, reach = self.corner, np.arange(len(a)), [], [], 0.0
        for turn in range(MOST_ROUNDS):
            middle = corner.mean(axis=0)
            far = np.linalg.norm(corner - middle, axis=2).max(axis=0)
            small = (far <= wanted) | (turn == MOST_ROUNDS - 1)
            middles.append(middle[small])
            owners.append(element[small])
            reach = max(reach, float(far[small].max(initial=0.0)))
            if small.all():
                break
            corner, element = _halve_triangles(corner[:, ~small]), np.tile(element[~small], 2)
        return Pieces(np.concatenate(middles), np.concatenate(owners), reach)


def _to_side(square: Floats, along: Floats, length2: Floats) -> Floats:
    """Squared distance from a side of that squared length, from its beginning's and the inner product with
    it."""
    share = np.clip(along / length2, 0.0, 1.0)
    return np.asarray(square - share * (2.0 * along - share * length2))


def _halve_triangles(corner: Floats) -> Floats:
    """Both halves (3, 2 n, 3) of triangles (3, n, 3), cut from the middle of the longest side."""
    length = np.linalg.norm(np.roll(corner, -1, axis=0) - corner, axis=2)
    first = length.argmax(axis=0)
    at = np.arange(corner.shape[1])
    a, b, c = (corner[(first + k) % 3, at] for k in range(3))
    middle = (a + b) / 2.0
    return np.concatenate([np.stack([a, middle, c]), np.stack([middle, b, c])], axis=1)
