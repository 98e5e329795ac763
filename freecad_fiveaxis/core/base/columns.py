# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vector algebra by columns: a field of vectors is three columns, and what is zero costs nothing.

column  the values of one component in all rows (m,), or a plain float where they are the same in all rows.
turn    a rotation about a fixed unit axis, by an angle of each row given by its cosine and sine.

Machines have mostly axes along X, Y and Z through points with zeros in them: leaving out the products with 0
and 1 makes one general formula as fast as one written for each machine.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np

from .records import Floats

TINY = 1e-14
"""Below this a component of a unit vector, or a sum of two, is rounding, not geometry."""

CHUNK = 16384
"""Rows worked on at a time: the few dozen columns of a chunk stay in the processor's cache."""

Column = Floats | float
Columns = Sequence[Column]
Matrix = list[list[float]]


def cache_chunks(count: int) -> Iterator[slice]:
    """Slices of at most CHUNK rows that make up ``count`` rows."""
    return (slice(start, min(start + CHUNK, count)) for start in range(0, count, CHUNK))


def split(rows: Floats) -> list[Floats]:
    """Return the contiguous columns of an array (m, k) of any memory order: views where they are contiguous,
    not to be changed."""
    columns = rows.T
    return list(columns if columns.strides[-1] == columns.itemsize else np.ascontiguousarray(columns))


def empty_rows(*shape: int) -> Floats:
    """Return an uninitialised array of that shape whose columns (last index) are contiguous."""
    return np.empty((*shape[:-2], shape[-1], shape[-2])).swapaxes(-1, -2)


def put(target: Floats, columns: Columns) -> None:
    """Write columns into the rows ``target`` (m, k)."""
    for j, column in enumerate(columns):
        target[:, j] = column


def clean(values: Floats) -> Floats:
    """Return the values with what is only rounding made 0."""
    return np.where(np.abs(values) < TINY, 0.0, values)


def cos_sin(angle: Floats) -> tuple[Floats, Floats]:
    """Cosine and sine of the angles (m,) rad, within 4e-16: through the tangent of the half angle, one
    function instead of two, and one that numpy has as vector code on many processors, where it has neither
    cosine nor sine."""
    tan: Floats = np.tan(0.5 * angle)
    scale: Floats = tan * tan
    scale += 1.0
    np.divide(2.0, scale, out=scale)
    tan *= scale
    scale -= 1.0
    return scale, tan


def is_zero(a: Column) -> bool:
    """Return True for the plain number 0; a column is not looked at."""
    return isinstance(a, float) and a == 0.0


def plus(a: Column, b: Column) -> Column:
    """Return a + b."""
    return b if is_zero(a) else a if is_zero(b) else a + b


def minus(a: Column, b: Column) -> Column:
    """Return a - b."""
    return a if is_zero(b) else -b if is_zero(a) else a - b


def times(a: Column, b: Column) -> Column:
    """Return a b."""
    return 0.0 if is_zero(a) or is_zero(b) else a * b


def dot(row: Sequence[float], columns: Columns) -> Column:
    """Return the sum of the columns, each times a number of ``row``; factors 0, 1 and -1 are not
    multiplied."""
    total: Column = 0.0
    for factor, column in zip(row, columns, strict=True):
        if factor != 0.0:
            total = plus(
                total, column if factor == 1.0 else -column if factor == -1.0 else times(factor, column)
            )
    return total


def map_vectors(matrix: Matrix, columns: Columns) -> list[Column]:
    """Return the matrix (3, 3) times the vectors."""
    return [dot(row, columns) for row in matrix]


def add_vectors(a: Columns, b: Columns) -> list[Column]:
    """Return the vectors a + b."""
    return [plus(x, y) for x, y in zip(a, b, strict=True)]


def less(a: Columns, b: Columns) -> list[Column]:
    """Return the vectors a - b."""
    return [minus(x, y) for x, y in zip(a, b, strict=True)]


def scalar(a: Columns, b: Columns) -> Column:
    """Return the scalar products a . b."""
    return plus(times(a[0], b[0]), plus(times(a[1], b[1]), times(a[2], b[2])))


def cross_vectors(a: Columns, b: Columns) -> list[Column]:
    """Return the vector products a x b."""
    return [minus(times(a[i], b[j]), times(a[j], b[i])) for i, j in ((1, 2), (2, 0), (0, 1))]


@dataclass(frozen=True)
class Turn:
    """The matrices (3, 3) of the turns about a unit axis: ``R = along + cos across + sin cross``
    (Rodrigues)."""

    along: Matrix
    across: Matrix
    cross: Matrix

    @staticmethod
    def about(axis: Floats) -> Turn:
        """Return the turns about ``axis`` (3,), unit."""
        along = np.outer(axis, axis)
        matrices = (along, np.eye(3) - along, np.cross(np.eye(3), axis))
        return Turn(*(cast(Matrix, clean(matrix).tolist()) for matrix in matrices))

    def of(self, v: Columns, cos: Column, sin: Column) -> list[Column]:
        """Return the vectors ``v``, turned."""
        parts = zip(
            map_vectors(self.along, v), map_vectors(self.across, v), map_vectors(self.cross, v), strict=True
        )
        return [plus(along, plus(times(cos, across), times(sin, cross))) for along, across, cross in parts]

    def of_ez(self, cos: Floats, sin: Floats) -> list[Column]:
        """ez turned; where the axis leans, 1 - cos is taken without cancellation, so that a small tilt keeps
        its direction."""
        x, y, z = self.of((0.0, 0.0, 1.0), cos, sin)
        if not is_zero(self.along[0][2]) or not is_zero(self.along[1][2]):
            # where cos is not above 0 the other branch counts; its size keeps the one that does not from
            # dividing by 0
            versine = np.where(cos > 0.0, sin * sin / (1.0 + np.abs(cos)), 1.0 - cos)
            x, y = (plus(times(versine, self.along[i][2]), times(sin, self.cross[i][2])) for i in (0, 1))
        return [x, y, z]
