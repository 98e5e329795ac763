# SPDX-License-Identifier: LGPL-2.1-or-later
"""A coarser copy of a mesh, for pictures that have to be drawn fast; nothing is computed from it.

Vertices are put into the cells of a cubic grid, and each goes to the mean of those in its cell (Rossignac and
Borrel's clustering). A facet with two corners in one cell has no area then and is left out. No vertex moves
by more than the diagonal of a cell, and no point of a facet that is kept does: **the whole copy lies within
the diagonal of a cell from the mesh.** What is thinner than a cell may be missing in it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.errors import MeshError
from freecad_fiveaxis.core.base.records import Floats, Ints

from .mesh import Mesh, from_faces

SMALL = 1000
"""Facets of a mesh that always stays as it is."""
ENOUGH = 0.7
"""Of the facets that a copy may have: a copy with so many is not made finer."""
ROUNDS = 6
"""Sizes of the cells that are tried."""
FINEST = 2.0**-20
"""Size of the smallest cell, as a share of the mesh's longest side: cells are numbered in 64 bits."""


class Reduced(NamedTuple):
    """``mesh``: the copy; ``cell`` mm: the side of a cell of the grid it was made on."""

    mesh: Mesh
    cell: float

    @property
    def deviation(self) -> float:
        """The most, mm, by which any point of the copy lies off the mesh."""
        return float(np.sqrt(3.0)) * self.cell


def share_facets(count: Sequence[int], most: int) -> list[int]:
    """Return how many facets the copies of meshes with so many facets each may have: all where they are at
    most ``most`` together, else shares of that by size; small meshes stay as they are."""
    total = sum(count)
    if total <= most:
        return list(count)
    return [min(one, max(SMALL, most * one // total)) for one in count]


def cluster_vertices(vertex: Floats, face: Ints, cell: float) -> tuple[Floats, Ints]:
    """Return the means (c, 3) mm of the vertices (v, 3) in each used cell of ``cell`` mm, and the facets
    (g, 3) of those that keep three cells, each once; their sense stays."""
    place = np.floor((vertex - vertex.min(axis=0)) / cell).astype(np.int64)
    width = place.max(axis=0) + 1
    key = (place[:, 0] * width[1] + place[:, 1]) * width[2] + place[:, 2]
    _, owner, count = np.unique(key, return_inverse=True, return_counts=True)
    owner = owner.reshape(-1)
    mean = np.stack([np.bincount(owner, column) for column in vertex.T], axis=1) / count[:, None]
    return mean, _without_doubled(owner[face])


def reduce_mesh(mesh: Mesh, most: int) -> Reduced | None:
    """Return a copy of at most ``most`` facets, nearly as many where the mesh has them everywhere; None where
    the mesh has no more itself, or where no copy keeps a facet."""
    if len(mesh.face) <= most:
        return None
    return _search(mesh.vertex, mesh.face, float(mesh.area.sum()), most)


def reduce_facets(vertex: Floats, face: Ints, most: int) -> Reduced | None:
    """Return the same of vertices (v, 3) mm and rows of them (f, 3), of which no mesh need be made first:
    facets without area and vertices that none uses may be among them."""
    if len(face) <= most:
        return None
    used = np.zeros(len(vertex), np.bool_)
    used[face] = True
    vertex, face = vertex[used], (np.cumsum(used) - 1)[face]
    a, b, c = vertex[face].transpose(1, 0, 2)
    area = 0.5 * float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())
    return _search(vertex, face, area, most)


def _search(vertex: Floats, face: Ints, area: float, most: int) -> Reduced | None:
    """Return the best of some sizes of the cells. ``area`` mm2: of all facets."""
    side = float(np.ptp(vertex, axis=0).max())
    cell, best, found = np.sqrt(3.0 * area / max(most, 1)), None, 0
    for _ in range(ROUNDS):
        cell = float(np.clip(cell, FINEST * side, side))
        mean, kept = cluster_vertices(vertex, face, cell)
        if found < len(kept) <= most:
            best, found = (mean, kept, cell), len(kept)
        if ENOUGH * most <= len(kept) <= most:
            break
        cell *= np.sqrt(max(len(kept), 1) / (0.5 * (1.0 + ENOUGH) * max(most, 1)))
    return None if best is None else _make(*best)


def _make(vertex: Floats, face: Ints, cell: float) -> Reduced | None:
    try:
        return Reduced(from_faces(vertex, face), cell)
    except MeshError:  # all that is kept is a line
        return None


def _without_doubled(face: Ints) -> Ints:
    """Return the facets with three corners, those with the same ones in the same sense once."""
    a, b, c = face.T
    face = face[(a != b) & (b != c) & (c != a)]
    turn = (face.argmin(axis=1)[:, None] + np.arange(3)) % 3
    first = np.take_along_axis(face, turn, axis=1)
    order = np.lexsort(first.T)
    new = np.ones(len(face), np.bool_)
    new[1:] = (np.diff(first[order], axis=0) != 0).any(axis=1)
    return np.asarray(face[np.sort(order[new])])
