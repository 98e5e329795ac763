# SPDX-License-Identifier: LGPL-2.1-or-later
"""A copy of facets divided along the levels of a field, so that each facet lies in one slab.

slab      what lies between two neighbouring levels: slab j from level j - 1 to level j.
corner    values stand at the corners of facets, (f, 3), not at vertices: a field that gains a whole number
          once round has the same levels from either side of a seam, as long as these are whole numbers too.
strip     of a facet with corners A, B, C, ascending, what lies in one slab: its corners are the lower and the
          upper place on AC, those on ABC, and B where it lies between them. It makes up to three facets about
          its lower place on AC.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .refine import INNER, Copy, assemble_copy


class Divided(NamedTuple):
    """``vertex`` (v, 3 or more) mm and what is carried along; ``face`` (f, 3), ``label`` (f, 3) of their
    sides, ``owner`` (f,) the facets that were divided; ``slab`` (f,); ``value`` (f, 3) at the corners, exact
    on levels."""

    vertex: Floats
    face: Ints
    label: Ints
    owner: Ints
    slab: Ints
    value: Floats


def assemble(copy: Copy, part: Mesh, divided: Divided) -> Copy:
    """Make a copy of what a copy was divided into."""
    return assemble_copy(part, divided.vertex[:, :3], divided.face, divided.label, copy.parent[divided.owner])


def divide(copy: Copy, value: Floats, levels: Floats, carried: Floats | None = None) -> Divided:
    """Divide the facets of a copy where ``value`` (f, 3), at their corners and linear between them, has the
    ascending ``levels`` (k,); no corner may lie on one. ``carried`` (v, w): what else is known of the
    vertices, linear along sides."""
    mesh = copy.mesh
    table = np.asarray(mesh.vertex) if carried is None else np.column_stack([mesh.vertex, carried])
    level = np.searchsorted(levels, value, side="right")
    new, base = _crossings(mesh, table, value, level, levels)
    strips, order = _strips(copy, value, level, base + len(table))
    pieces = _pieces(strips, levels)
    strip = np.concatenate([np.flatnonzero(which) for which, _, _ in pieces])
    face, at = (_rows(pieces, [[place[k] for place in places] for _, places, _ in pieces]) for k in (0, 1))
    label, odd = (
        _rows(pieces, [sides for _, _, sides in pieces]),
        np.flatnonzero(_odd(order)[strips.facet[strip]]),
    )
    face[odd], at[odd], label[odd] = face[odd][:, [0, 2, 1]], at[odd][:, [0, 2, 1]], label[odd][:, ::-1]
    return Divided(np.concatenate([table, new]), face, label, strips.facet[strip], strips.slab[strip], at)


def _rows(pieces: list[_Piece], columns: Sequence[Sequence[NDArray[Any]]]) -> Any:
    """Return the columns (f, 3) of the facets that there are."""
    parts = [np.stack(column, axis=1)[which] for (which, _, _), column in zip(pieces, columns, strict=True)]
    return np.concatenate(parts)


def _crossings(mesh: Mesh, table: Floats, value: Floats, level: Ints, levels: Floats) -> tuple[Floats, Ints]:
    """Return the new rows of the table, those of a co-edge one after the other, upwards; and the first of
    each co-edge (e,)."""
    count = len(mesh.coedge_face)
    facet = mesh.coedge_face[:, 0]
    start = (mesh.face_coedge[facet] == np.arange(count)[:, None]).argmax(axis=1)
    ends = np.stack([start, (start + 1) % 3], axis=1)
    low = np.take_along_axis(value[facet], ends, axis=1).argmin(axis=1)[:, None]
    one, two = (np.take_along_axis(ends, side, axis=1)[:, 0] for side in (low, 1 - low))
    begin, number = level[facet, one], level[facet, two] - level[facet, one]
    edge = np.repeat(np.arange(count), number)
    base = np.cumsum(number) - number
    plane = levels[begin[edge] + np.arange(len(edge)) - base[edge]]
    under, over = value[facet, one][edge], value[facet, two][edge]
    share = ((plane - under) / (over - under))[:, None]
    from_, to = (table[mesh.face[facet, corner]][edge] for corner in (one, two))
    return from_ + share * (to - from_), base


class _Strips(NamedTuple):
    """The ``facet`` and the ``slab`` (n,) of each strip; its ``corner`` vertices A, B, C, values ``at`` them,
    ``label`` of the sides AB, BC, AC and the vertex that would be ``first`` on each of these if a level 0
    crossed it, (3, n) each; the slabs of the corners, ``span`` (3, n)."""

    facet: Ints
    slab: Ints
    corner: Ints
    at: Floats
    label: Ints
    first: Ints
    span: Ints


_Place = tuple[Ints, Floats]
"""Vertices and values (n,)."""

_Piece = tuple[Bools, tuple[_Place, _Place, _Place], tuple[Ints, Ints, Ints]]
"""Of which strips there is such a facet, its corners, and the labels of its sides."""


def _strips(copy: Copy, value: Floats, level: Ints, base: Ints) -> tuple[_Strips, Ints]:
    """Return the strips, and the corners (f, 3) of the facets in ascending order; ``base`` (e,) the first new
    vertex of each co-edge."""
    order = np.argsort(value, axis=1, kind="stable")
    span = np.take_along_axis(level, order, axis=1)
    count = span[:, 2] - span[:, 0] + 1
    facet, number = number_runs(count)
    slab = span[facet, 0] + number
    coedge = _sort_sides(copy.mesh, order)
    first = base[coedge] - span[:, [0, 1, 0]]
    corner = np.take_along_axis(copy.mesh.face, order, axis=1), np.take_along_axis(value, order, axis=1)
    columns: list[Any] = [table[facet].T for table in (*corner, copy.coedge[coedge], first, span)]
    return _Strips(facet, slab, *columns), order


def _place(strips: _Strips, levels: Floats, plane: Ints, side: Ints, end: Bools, corner: int) -> _Place:
    """Where a plane crosses a ``side`` (n,); at an ``end`` a corner instead."""
    crossed = np.take_along_axis(strips.first, side[None], axis=0)[0] + plane
    height = levels[plane.clip(0, len(levels) - 1)]
    return np.where(end, strips.corner[corner], crossed), np.where(end, strips.at[corner], height)


def _pieces(strips: _Strips, levels: Floats) -> list[_Piece]:
    """Return what facets strips are made of: the first lies on the lower level, the second has B, the third
    lies on the upper level."""
    (ab, bc, ac), slab, (a, b, c) = strips.label, strips.slab, strips.span
    bottom, middle, top = slab == a, slab == b, slab == c
    long, inner = np.full(len(slab), 2), np.full(len(slab), INNER)
    low = _place(strips, levels, slab - 1, long, bottom, 0)
    near = _place(strips, levels, slab - 1, np.where(slab - 1 < b, 0, 1), bottom, 0)
    high = _place(strips, levels, slab, long, top, 2)
    far = _place(strips, levels, slab, np.where(slab < b, 0, 1), top, 2)
    mid = np.where(middle, strips.corner[1], far[0]), np.where(middle, strips.at[1], far[1])
    return [
        (~bottom, (low, near, mid), (inner, np.where(slab <= b, ab, bc), np.where(top & ~middle, ac, inner))),
        (middle, (low, mid, far), (np.where(bottom, ab, inner), bc, np.where(top, ac, inner))),
        (~top, (low, far, high), (np.where(bottom & ~middle, ab, inner), inner, ac)),
    ]


def _sort_sides(mesh: Mesh, order: Ints) -> Ints:
    """Return the co-edges (f, 3) between the first and the second, the second and the third, the first and
    the third corner."""
    a, b, c = order.T
    column = [np.where(two == (one + 1) % 3, one, two) for one, two in ((a, b), (b, c), (a, c))]
    return np.asarray(np.take_along_axis(mesh.face_coedge, np.stack(column, axis=1), axis=1))


def _odd(order: Ints) -> Bools:
    """Where the corners in their order run the other way round."""
    return np.asarray((order[:, 1] - order[:, 0]) % 3 == 2)
