# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a surface is steep: a copy of the part divided along the line on which its slope has a bound.

slope     of a facet: the angle between it and a level plane, from 0 to 90 deg; an underside has that of the
          same face turned up. Of a corner: the mean of the facets that meet there without a sharp edge
          between them, by their angles and areas. It is linear over each facet, so the line runs smoothly
          through facets, and no farther from a level than the facets are.
line      where the slope crosses the bound. A sharp edge between what is steeper and what is not needs none.
strip     what lies within the overlap of the line, on either side; no farther than half-way from the bound to
          level ground and to an upright wall, on which level planes and upright ones find no end.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.vectors import row_dot
from freecad_fiveaxis.core.geometry.mesh import Mesh

from .refine import Copy, assemble_copy, halve_long_sides, number_sides, split_sides
from .scallop import CREASE

EXACT = np.radians(0.01)
"""rad beyond the bound within which a facet counts as not steeper: so much comes from the rounding of
coordinates."""

BESIDE = 1e-4
"""Share of a side: a line that crosses it nearer to one of its ends runs through that end."""

FINE = 0.5
"""Of the overlap: sides beside the line are no longer, so that the distance from it is nearly linear over
each facet."""

DENSE = 0.1
"""Of the overlap: between samples of the line."""

FACING = 0.5
"""Cosine between the normals of a facet and of the line next to it from which the facet lies beside the line,
not behind it."""

FAR = 1e-24
"""Of the metric near the line: facets far from it are only divided as their neighbours ask for."""

ROUNDS = 40


@dataclass(frozen=True, eq=False)
class Slopes:
    """``copy`` of all facets of the part, divided at the line and at the rims of the strip; of its facets
    (f,) which are ``steep`` and which lie in the ``strip``."""

    copy: Copy
    steep: Bools
    strip: Bools


class _Pieces(NamedTuple):
    """Facets (f, 3) of ``vertex`` (v, 3), the ``label`` (f, 3) of their sides, the facets of the part that
    they are of, ``owner`` (f,), the ``slope`` (f, 3) of their corners less the bound, rad, and which are
    ``steep`` (f,)."""

    vertex: Floats
    face: Ints
    label: Ints
    owner: Ints
    slope: Floats
    steep: Bools


def corner_slopes(mesh: Mesh) -> Floats:
    """Find the slope (f, 3), rad, of the corners of all facets."""
    level = np.hypot(mesh.normal[:, 0], mesh.normal[:, 1])
    slope = np.arctan2(level, np.abs(mesh.normal[:, 2]))
    fan = _fans(mesh).reshape(-1)
    weight = (mesh.area[:, None] * _angles(mesh)).reshape(-1)
    mean = np.bincount(fan, weight * np.repeat(slope, 3)) / np.bincount(fan, weight)
    return np.asarray(mean[fan].reshape(-1, 3))


def divide_by_slope(mesh: Mesh, bound: float, overlap: float) -> Slopes:
    """Divide the facets of the part where their slope crosses ``bound``, rad, and at the rims of a strip that
    reaches ``overlap``, mm, to either side of that line."""
    excess = corner_slopes(mesh) - (bound + EXACT)
    count = len(mesh.face)
    whole = _Pieces(
        np.asarray(mesh.vertex),
        mesh.face,
        mesh.face_coedge,
        np.arange(count),
        excess,
        np.zeros(count, np.bool_),
    )
    pieces = _split_at(whole, excess)
    pieces = pieces._replace(steep=pieces.slope.mean(axis=1) > 0.0)
    line, normal = _line(mesh, pieces, DENSE * overlap)
    strip = np.zeros(len(pieces.face), np.bool_)
    if overlap > 0.0 and len(line):
        pieces, strip = _with_strip(mesh, pieces, bound, overlap, line, normal)
    copy = assemble_copy(mesh, pieces.vertex, pieces.face, pieces.label, pieces.owner)
    return Slopes(copy, pieces.steep, strip)


def _fans(mesh: Mesh) -> Ints:
    """Which corners (f, 3) are of facets that meet at one vertex without a sharp edge between them: one
    number for all these."""
    edge = np.flatnonzero(mesh.coedge_face[:, 1] >= 0)
    one, two = mesh.coedge_face[edge].T
    smooth = row_dot(mesh.normal[one], mesh.normal[two]) > np.cos(CREASE)
    edge, one, two = edge[smooth], one[smooth], two[smooth]
    pairs = [
        [
            3 * facet + (mesh.face[facet] == mesh.coedge_vertex[edge, end][:, None]).argmax(axis=1)
            for facet in (one, two)
        ]
        for end in (0, 1)
    ]
    rows, columns = np.concatenate(pairs, axis=1)
    graph = scipy.sparse.coo_matrix(
        (np.ones(len(rows)), (rows, columns)), shape=(mesh.face.size, mesh.face.size)
    )
    return np.asarray(
        scipy.sparse.csgraph.connected_components(graph, directed=False)[1].reshape(-1, 3), np.int64
    )


def _angles(mesh: Mesh) -> Floats:
    """Return the angles (f, 3), rad, of facets at their corners."""
    corner = mesh.vertex[mesh.face]
    ahead, back = np.roll(corner, -1, axis=1) - corner, np.roll(corner, 1, axis=1) - corner
    return np.asarray(np.arctan2(2.0 * mesh.area[:, None], (ahead * back).sum(axis=2)))


def _split_at(pieces: _Pieces, value: Floats) -> _Pieces:
    """Return the pieces divided where ``value`` (f, 3) at their corners crosses 0. At a sharp edge, to whose
    sides it may have other values, both sides are divided at the one place, so that passes go over it."""
    side, other = number_sides(pieces.face), np.roll(value, -1, axis=1)
    share = value / np.where(value == other, 1.0, value - other)
    crossed = (value * other < 0.0) & (share > BESIDE) & (share < 1.0 - BESIDE)
    count = int(side.max(initial=-1)) + 1
    begin, marked, at = np.empty(count, np.int64), np.zeros(count, np.bool_), np.full(count, 0.5)
    begin[side] = pieces.face  # the last facet that has the side says where it begins, as in split_sides
    marked[side[crossed]] = True
    at[side[crossed]] = np.where(pieces.face == begin[side], share, 1.0 - share)[crossed]
    if not marked.any():
        return pieces
    top = np.where(crossed.any(axis=1), crossed.argmax(axis=1), marked[side].argmax(axis=1))
    halved = split_sides(pieces.vertex, pieces.face, pieces.label, side, marked, top, at[marked])
    return _hand_on(pieces, *halved)


def _hand_on(pieces: _Pieces, vertex: Floats, face: Ints, label: Ints, of: Ints) -> _Pieces:
    """Return what pieces became, with all that was known of those that they are ``of`` (f,)."""
    slope = _between(pieces.vertex[pieces.face[of]], pieces.slope[of], vertex[face])
    return _Pieces(vertex, face, label, pieces.owner[of], slope, pieces.steep[of])


def _between(corner: Floats, value: Floats, place: Floats) -> Floats:
    """Return what values (f, 3) at corners (f, 3, 3), linear between them, are at places (f, 3, 3) in the
    same facets."""
    first, second = (corner[:, k] - corner[:, 0] for k in (1, 2))
    off = place - corner[:, :1]
    aa, ab, bb = row_dot(first, first), row_dot(first, second), row_dot(second, second)
    pa, pb = ((off * way[:, None]).sum(axis=2) for way in (first, second))
    scale = np.maximum(aa * bb - ab * ab, np.finfo(float).tiny)[:, None]
    one = (pa * bb[:, None] - pb * ab[:, None]) / scale
    two = (pb * aa[:, None] - pa * ab[:, None]) / scale
    rise = value - value[:, :1]
    return np.asarray(value[:, :1] + one * rise[:, 1:2] + two * rise[:, 2:3])


def _line(mesh: Mesh, pieces: _Pieces, gap: float) -> tuple[Floats, Floats]:
    """Return samples (n, 3) of the line, at most ``gap`` mm apart, and the normals of facets there; of sharp
    edges none."""
    side = number_sides(pieces.face).reshape(-1)
    order = np.argsort(side, kind="stable")
    pair = np.flatnonzero(np.diff(side[order]) == 0)
    one, two = order[pair], order[pair + 1]
    normal = mesh.normal[pieces.owner]
    parted = pieces.steep[one // 3] != pieces.steep[two // 3]
    parted &= row_dot(normal[one // 3], normal[two // 3]) > np.cos(CREASE)
    one = one[parted]
    start, end = (table.reshape(-1)[one] for table in (pieces.face, np.roll(pieces.face, -1, axis=1)))
    way = pieces.vertex[end] - pieces.vertex[start]
    number = (
        np.ceil(np.linalg.norm(way, axis=1) / gap).astype(np.int64) + 1
        if gap > 0.0
        else np.ones(len(one), np.int64)
    )
    row, place = number_runs(number)
    share = place / np.maximum(number - 1, 1)[row]
    return pieces.vertex[start][row] + share[:, None] * way[row], normal[one // 3][row]


def _with_strip(
    mesh: Mesh, pieces: _Pieces, bound: float, overlap: float, line: Floats, normal: Floats
) -> tuple[_Pieces, Bools]:
    """Return the pieces, fine beside the line and divided at the rims of the strip, and which (f,) lie in
    it."""
    tree = scipy.spatial.cKDTree(line)
    pieces = _finer(pieces, tree, overlap)
    inside = _inside(pieces, tree, bound, overlap)
    pieces = _split_at(pieces, inside)
    middle = pieces.vertex[pieces.face].mean(axis=1)
    near = tree.query(middle)[1]
    facing = row_dot(mesh.normal[pieces.owner], normal[near]) > FACING
    return pieces, (_inside(pieces, tree, bound, overlap).mean(axis=1) > 0.0) & facing


def _finer(pieces: _Pieces, tree: scipy.spatial.cKDTree, overlap: float) -> _Pieces:
    """Return the pieces with short sides beside the line."""
    for _ in range(ROUNDS):
        corner = pieces.vertex[pieces.face]
        middle = corner.mean(axis=1)
        reach = np.linalg.norm(corner - middle[:, None], axis=2).max(axis=1)
        near = (
            tree.query(middle, distance_upper_bound=float(reach.max()) + 2.0 * overlap)[0] < reach + overlap
        )
        metric = np.zeros((6, len(near)))
        metric[:3] = np.where(near, 1.0, FAR)
        halved = halve_long_sides(pieces.vertex, pieces.face, pieces.label, metric, FINE * overlap)
        if halved is None:
            break
        pieces = _hand_on(pieces, *halved)
    return pieces


def _inside(pieces: _Pieces, tree: scipy.spatial.cKDTree, bound: float, overlap: float) -> Floats:
    """Return a value (f, 3) at the corners that is positive within the strip and negative outside."""
    off = tree.query(pieces.vertex)[0][pieces.face]
    room = np.where(pieces.steep, 0.5 * (0.5 * np.pi - bound), 0.5 * bound)[:, None]
    return np.asarray(np.minimum(1.0 - off / overlap, 1.0 - np.abs(pieces.slope) / np.maximum(room, EXACT)))
