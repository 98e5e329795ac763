# SPDX-License-Identifier: LGPL-2.1-or-later
"""A finer copy of some facets, for a field that the facets of the part are too large for. The part itself
stays as it is.

longest   of a facet's sides is the one that is halved first; a facet with any halved side has its longest one
          halved too. So small angles are halved once at most, and obtuse ones go (Rivara, Int. J. Numer.
          Meth. Eng. 20 (1984), 745-756).
parent    the facet of the part in which a facet of the copy lies; its plane, and so its normal, are the
          parent's.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .contact_path import ContactPath

ROUNDS = 40
"""Times that sides are halved: from a kilometre to less than any rounding."""

ON = 1e-9
"""mm: vertices so near to where facets are divided lie on it."""

INNER = -1
"""Label of a side that lies inside its parent."""


@dataclass(frozen=True, eq=False)
class Copy:
    """``mesh``: facets of a copy, in which no vertex belongs to two components; ``parent`` (f,) the facets of
    the part in which they lie; ``coedge`` (e,) the co-edges of the part on which theirs lie, -1 for none;
    ``component`` (v,) of each vertex, counted from 0; ``bend`` mm: passes may be that much straighter inside
    a facet of the part than on the copy; polylines shorter than ``short`` mm are left out."""

    mesh: Mesh
    parent: Ints
    coedge: Ints
    component: Ints
    bend: float = 0.0
    short: float = 0.0

    def on_part(self, contact: ContactPath, part: Mesh) -> ContactPath:
        """Return the contact path with facets and co-edges of the part; one segment where it is straight
        within ``bend`` in a facet."""
        contact = drop_short(contact, self.short)
        face = self.parent[contact.face]
        first = _straight_runs(contact, face[::2], self.bend)
        last = np.append(first[1:], len(face) // 2)[: len(first)] - 1
        rows = np.stack([2 * first, 2 * last + 1], axis=1).reshape(-1)
        coedge = np.where(contact.coedge < 0, INNER, self.coedge[contact.coedge])[rows]
        face = face[rows]
        return replace(
            contact, point=contact.point[rows], normal=part.normal[face], face=face, coedge=coedge,
            segment=np.arange(len(rows)) >> 1, polyline=contact.polyline[rows], pass_=contact.pass_[rows],
        )  # fmt: skip


def drop_short(contact: ContactPath, short: float) -> ContactPath:
    """Return the polylines that are not shorter than ``short`` mm; all of a part so small that there are
    none."""
    segment = np.linalg.norm(contact.point[1::2] - contact.point[::2], axis=1)
    rows = np.flatnonzero((np.bincount(contact.polyline[::2], segment) >= short)[contact.polyline])
    if not len(rows):
        return contact
    columns = {name: getattr(contact, name)[rows] for name in ("point", "normal", "face", "coedge", "pass_")}
    polyline = np.unique(contact.polyline[rows], return_inverse=True)[1].astype(np.int64)
    return replace(contact, **columns, segment=np.arange(len(rows)) >> 1, polyline=polyline)


def _straight_runs(contact: ContactPath, parent: Ints, bend: float) -> Ints:
    """Segments (r,) at which runs begin that stay in one parent and within ``bend`` mm of their chords;
    ``parent`` (s,)."""
    entry, exit_, line = contact.point[::2], contact.point[1::2], contact.polyline[::2]
    begins = np.ones(len(parent), np.bool_)
    begins[1:] = (parent[1:] != parent[:-1]) | (line[1:] != line[:-1])
    rows = np.arange(len(parent))  # of runs that are not known to be straight, each of them whole
    while len(rows):
        here = begins[rows]
        first, run = np.flatnonzero(here), np.cumsum(here) - 1
        start = entry[rows[first]]
        chord = exit_[rows[np.append(first[1:], len(rows)) - 1]] - start
        along = np.einsum("ij,ij->i", chord, chord)[run]
        off = entry[rows] - start[run]
        share = np.clip(np.einsum("ij,ij->i", off, chord[run]) / np.where(along > 0.0, along, 1.0), 0.0, 1.0)
        away = np.linalg.norm(off - share[:, None] * chord[run], axis=1)
        worst = np.maximum.reduceat(away, first)
        split = (away == worst[run]) & (away > bend) & ~here
        begins[rows[split]] = True
        rows = rows[np.logical_or.reduceat(split, first)[run]]
    return np.flatnonzero(begins)


def finer_copy(part: Mesh, rows: Ints, metric: Floats, longest: float) -> Copy:
    """Return the facets ``rows`` (k,) of the part, divided until no side is longer than ``longest`` in the
    metric of its facet: a tensor (6, k) of xx, yy, zz, xy, yz, zx. Sides that lead from border to border
    through the inside are halved once more, so that no strip lies on the border with all of its vertices."""
    vertex, face, side, parent = (
        np.asarray(part.vertex),
        part.face[rows],
        part.face_coedge[rows],
        np.arange(len(rows)),
    )
    for _ in range(ROUNDS):
        halved = halve_long_sides(vertex, face, side, metric[:, parent], longest)
        if halved is None:
            break
        vertex, face, side, owner = halved
        parent = parent[owner]
    vertex, face, side, owner = _split_across(vertex, face, side)
    parent = parent[owner]
    return assemble_copy(part, vertex, face, side, rows[parent])


def copy_facets(part: Mesh, rows: Ints) -> Copy:
    """Copy the facets ``rows`` (k,) of the part as they are."""
    return assemble_copy(part, np.asarray(part.vertex), part.face[rows], part.face_coedge[rows], rows)


def take_facets(copy: Copy, part: Mesh, rows: Ints) -> Copy:
    """Return some facets (k,) of a copy as a copy of their own."""
    halved = assemble_copy(
        part,
        copy.mesh.vertex,
        copy.mesh.face[rows],
        copy.coedge[copy.mesh.face_coedge[rows]],
        copy.parent[rows],
    )
    return replace(halved, bend=copy.bend, short=copy.short)


def divide_copy(copy: Copy, part: Mesh, height: Floats) -> Copy:
    """Divide the facets of a copy where ``height`` (v,), linear over each, is 0, so that no facet has both
    signs."""
    mesh, height = copy.mesh, np.where(np.abs(height) < ON, 0.0, height)
    label, side = copy.coedge[mesh.face_coedge], number_sides(mesh.face)
    ends = np.empty((int(side.max(initial=-1)) + 1, 2), np.int64)
    ends[side] = np.stack([mesh.face, np.roll(mesh.face, -1, axis=1)], axis=2)
    one, two = height[ends].T
    marked = one * two < 0.0
    share = one[marked] / (one[marked] - two[marked])
    top = marked[side].argmax(axis=1)
    vertex, face, label, owner = split_sides(
        np.asarray(mesh.vertex), mesh.face, label, side, marked, top, share
    )
    return replace(
        assemble_copy(part, vertex, face, label, copy.parent[owner]), bend=copy.bend, short=copy.short
    )


def join_copies(one: Copy, two: Copy) -> Copy:
    """Both copies beside each other: one mesh in which nothing of the one hangs together with the other."""
    a, b = one.mesh, two.mesh
    vertices, facets, edges = len(a.vertex), len(a.face), len(a.coedge_face)
    other = np.where(b.coedge_face < 0, -1, b.coedge_face + facets)
    mesh = Mesh(
        np.concatenate([a.vertex, b.vertex]), np.concatenate([a.face, b.face + vertices]),
        np.concatenate([a.normal, b.normal]),
        np.concatenate([a.area, b.area]), np.concatenate([a.coedge_vertex, b.coedge_vertex + vertices]),
        np.concatenate([a.coedge_face, other]), np.concatenate([a.face_coedge, b.face_coedge + edges]),
    )  # fmt: skip
    component = np.concatenate([one.component, two.component + int(one.component.max(initial=-1)) + 1])
    return Copy(
        mesh,
        np.concatenate([one.parent, two.parent]),
        np.concatenate([one.coedge, two.coedge]),
        component,
        one.bend,
        one.short,
    )


def number_sides(face: Ints) -> Ints:
    """Return number the sides (f, 3) that half-edges are of: one number for all half-edges between the same
    two vertices."""
    low, high = np.minimum(face, np.roll(face, -1, axis=1)), np.maximum(face, np.roll(face, -1, axis=1))
    key = low * (int(face.max(initial=0)) + 1) + high
    return np.asarray(np.unique(key, return_inverse=True)[1].reshape(face.shape), np.int64)


def halve_long_sides(
    vertex: Floats, face: Ints, label: Ints, metric: Floats, longest: float
) -> tuple[Floats, Ints, Ints, Ints] | None:
    """Halve sides longer than ``longest`` in the metric (6, f), one round. Give vertices, facets, labels of
    their sides and owners; None where no side is too long."""
    x, y, z = (vertex[np.roll(face, -1, axis=1)] - vertex[face]).transpose(2, 1, 0)
    xx, yy, zz, xy, yz, zx = metric
    length = np.sqrt(xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + yz * y * z + zx * z * x)).T
    side, top = number_sides(face), length.argmax(axis=1)
    marked = np.zeros(int(side.max(initial=-1)) + 1, np.bool_)
    marked[side[length > longest]] = True
    if not marked.any():
        return None
    leading, count = side[np.arange(len(face)), top], -1
    while count != int(marked.sum()):
        count = int(marked.sum())
        marked[leading[marked[side].any(axis=1)]] = True
    return split_sides(vertex, face, label, side, marked, top)


def _split_across(vertex: Floats, face: Ints, label: Ints) -> tuple[Floats, Ints, Ints, Ints]:
    """Return the same after the sides inside are halved whose both ends lie on the border; of a facet alone
    its longest side first."""
    owner = np.arange(len(face))
    side, border = _border_sides(face, label)
    alone = border[side].all(axis=1)
    if alone.any():
        length = np.linalg.norm(vertex[np.roll(face, -1, axis=1)] - vertex[face], axis=2)
        top, marked = length.argmax(axis=1), np.zeros(len(border), np.bool_)
        marked[side[alone, top[alone]]] = True
        vertex, face, label, owner = split_sides(vertex, face, label, side, marked, top)
        side, border = _border_sides(face, label)
    rim = np.zeros(len(vertex), np.bool_)
    rim[face[border[side]]] = rim[np.roll(face, -1, axis=1)[border[side]]] = True
    marked = np.zeros(len(border), np.bool_)
    marked[side[rim[face] & rim[np.roll(face, -1, axis=1)]]] = True
    marked &= ~border
    vertex, face, label, again = split_sides(vertex, face, label, side, marked, marked[side].argmax(axis=1))
    return vertex, face, label, owner[again]


def _border_sides(face: Ints, label: Ints) -> tuple[Ints, Bools]:
    """Return the sides (f, 3) of :func:`number_sides`, and which (s,) of them are not of two facets that
    their label joins."""
    side = number_sides(face)
    count = np.bincount(side.reshape(-1))
    low, high = np.full(len(count), np.iinfo(np.int64).max), np.full(len(count), np.iinfo(np.int64).min)
    np.minimum.at(low, side.reshape(-1), label.reshape(-1))
    np.maximum.at(high, side.reshape(-1), label.reshape(-1))
    return side, (count != 2) | (low != high)


def split_sides(
    vertex: Floats, face: Ints, label: Ints, side: Ints, marked: Bools, top: Ints, share: Floats | None = None
) -> tuple[Floats, Ints, Ints, Ints]:
    """Give vertices, facets, labels and owners after the ``marked`` (s,) sides are halved, or divided at a
    ``share`` (m,) of each from the first vertex of the last facet that has it; ``top`` (f,): of a facet with
    such sides one of them."""
    count, turn = int(marked.sum()), (top[:, None] + np.arange(3)) % 3
    ends = np.empty((len(marked), 2), np.int64)
    ends[side] = np.stack([face, np.roll(face, -1, axis=1)], axis=2)
    face, label, side = (np.take_along_axis(table, turn, axis=1) for table in (face, label, side))
    middle = np.full(len(marked), -1)
    middle[marked] = len(vertex) + np.arange(count)
    start, end = vertex[ends[marked]].transpose(1, 0, 2)
    new = 0.5 * (start + end) if share is None else start + share[:, None] * (end - start)
    return np.concatenate([vertex, new]), *_divide_facets(face, label, middle[side])


def _divide_facets(face: Ints, label: Ints, middle: Ints) -> tuple[Ints, Ints, Ints]:
    """Facets, labels and owners of what facets become whose sides have a ``middle`` (f, 3), or -1; side 0 is
    the longest."""
    (a, b, c), (m, n, o), (p, q, r) = face.T, middle.T, label.T
    inner = np.full(len(face), INNER)
    whole, first, second = m < 0, (m >= 0) & (n >= 0), (m >= 0) & (o >= 0)
    no_first, no_second = (m >= 0) & (n < 0), (m >= 0) & (o < 0)
    pieces = [
        (whole, (a, b, c), (p, q, r)),
        (no_second, (a, m, c), (p, inner, r)), (second, (a, m, o), (p, inner, r)),
        (second, (m, c, o), (inner, r, inner)),
        (no_first, (m, b, c), (p, q, inner)), (first, (m, b, n), (p, q, inner)),
        (first, (m, n, c), (inner, q, inner)),
    ]  # fmt: skip
    corners = np.concatenate([np.stack(corner, axis=1)[which] for which, corner, _ in pieces])
    sides = np.concatenate([np.stack(side, axis=1)[which] for which, _, side in pieces])
    return corners, sides, np.concatenate([np.flatnonzero(which) for which, _, _ in pieces])


def assemble_copy(part: Mesh, vertex: Floats, face: Ints, label: Ints, parent: Ints) -> Copy:
    """Assemble the copy of facets, sides labelled with co-edges of the part. A side that the part does not
    join is joined nowhere: of two half-edges of one side and one label, in opposite senses, a co-edge is
    made."""
    count, half = len(face), number_sides(face).reshape(-1)
    start, end = face.reshape(-1), np.roll(face, -1, axis=1).reshape(-1)
    order = np.lexsort((start > end, label.reshape(-1), half))
    same = (
        (np.diff(half[order]) == 0)
        & (np.diff(label.reshape(-1)[order]) == 0)
        & (start[order[1:]] == end[order[:-1]])
    )
    same[1:] &= ~same[:-1]
    begins = np.append(True, ~same)[: len(order)]
    coedge = np.empty(len(half), np.int64)
    coedge[order] = np.cumsum(begins) - 1
    one, two = order[begins], order[1:][same]
    coedge_face = np.full((len(one), 2), -1)
    coedge_face[:, 0] = one // 3
    coedge_face[coedge[two], 1] = two // 3
    face, vertex, component = _apart(vertex, face, coedge_face)
    ends = face.reshape(-1)[one], np.roll(face, -1, axis=1).reshape(-1)[one]
    a, b, c = (vertex[corner] for corner in face.T)
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    mesh = Mesh(
        vertex, face, part.normal[parent], area, np.stack(ends, axis=1), coedge_face, coedge.reshape(count, 3)
    )
    return Copy(mesh, parent, label.reshape(-1)[one], component)


def _apart(vertex: Floats, face: Ints, coedge_face: Ints) -> tuple[Ints, Floats, Ints]:
    """Facets and vertices, those that two components share doubled, and the component of each vertex."""
    one, two = coedge_face[coedge_face[:, 1] >= 0].T
    graph = scipy.sparse.coo_matrix((np.ones(len(one)), (one, two)), shape=(len(face), len(face)))
    number = scipy.sparse.csgraph.connected_components(graph, directed=False)[1].astype(np.int64)
    key = number[:, None] * len(vertex) + face
    used, place = np.unique(key, return_inverse=True)
    return place.reshape(face.shape).astype(np.int64), vertex[used % len(vertex)], used // len(vertex)
