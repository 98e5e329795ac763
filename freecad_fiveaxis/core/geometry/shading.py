# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normals by which a mesh is lit: round where it is round, and sharp at its sharp edges.

corner  of a facet; those at one vertex that are joined over edges that are not sharp have one normal.

A picture that is given these draws the mesh as it stands in memory, and has nothing to find out itself.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .mesh import Mesh


class Shaded(NamedTuple):
    """``vertex`` (s, 3) mm, one for each normal at it; ``normal`` (s, 3) unit; ``face`` (f, 3) rows of
    both, in the mesh's order."""

    vertex: Floats
    normal: Floats
    face: Ints


def shade(mesh: Mesh, sharp: Bools) -> Shaded:
    """Divide the vertices of a mesh along its edges that are ``sharp`` (e,), and find the normal of each: the
    mean of those of its facets, by their areas."""
    corner = _number_corners(mesh, sharp | (mesh.coedge_face[:, 1] < 0))
    facet = np.repeat(np.arange(len(mesh.face)), 3)
    vertex = np.empty((int(corner.max()) + 1, 3))
    vertex[corner] = mesh.vertex[mesh.face.reshape(-1)]
    weighted = mesh.normal * mesh.area[:, None]
    normal = np.stack([np.bincount(corner, column[facet]) for column in weighted.T], axis=1)
    size, any_of = np.linalg.norm(normal, axis=1), np.empty(len(normal), np.int64)
    any_of[corner] = facet
    opposed = size <= 1e-9 * mesh.area[any_of]
    normal[opposed], size[opposed] = mesh.normal[any_of[opposed]], 1.0
    return Shaded(vertex, normal / size[:, None], corner.reshape(-1, 3))


def order_outward(lit: Shaded) -> Shaded:
    """Return the same facets, those first that lie deepest within the mesh, seen along their own normals, and
    those of its hull last: so blended over each other unsorted, they look right from most sides.

    Vertices are numbered in that order and facets begin with their first one: graphics that sort facets by
    their vertices keep it.
    """
    middle = 0.5 * (lit.vertex.min(axis=0) + lit.vertex.max(axis=0))
    order = np.argsort((lit.normal * (lit.vertex - middle)).sum(axis=1), kind="stable")
    rank = np.empty(len(order), np.int64)
    rank[order] = np.arange(len(order))
    face = rank[lit.face]
    face = np.take_along_axis(face, (face.argmin(axis=1)[:, None] + np.arange(3)) % 3, axis=1)
    return Shaded(lit.vertex[order], lit.normal[order], face[np.argsort(face[:, 0], kind="stable")])


def _number_corners(mesh: Mesh, parting: Bools) -> Ints:
    """Return a number for each corner (3 f,) of the facets, the same for those at one vertex that no
    ``parting`` (e,) edge parts."""
    at = mesh.face.reshape(-1)
    touched = np.zeros(len(mesh.vertex), np.bool_)
    touched[mesh.coedge_vertex[parting]] = True
    loose = np.flatnonzero(touched[at])
    local = np.zeros(len(at), np.int64)
    local[loose] = np.arange(len(loose))
    edge = np.flatnonzero(~parting & touched[mesh.coedge_vertex].any(axis=1))
    one, other = (part[touched[at[part]]] for part in _pair_corners(mesh, edge))
    graph = scipy.sparse.coo_matrix((np.ones(len(one)), (local[one], local[other])), (len(loose), len(loose)))
    number = at.copy()
    number[loose] = len(mesh.vertex) + scipy.sparse.csgraph.connected_components(graph, directed=False)[1]
    used = np.zeros(int(number.max()) + 1, np.bool_)
    used[number] = True
    return np.asarray((np.cumsum(used) - 1)[number])


def _pair_corners(mesh: Mesh, edge: Ints) -> tuple[Ints, Ints]:
    """Return the corners (2 e,) on the one side of edges and those on the other, at the same vertices."""
    (one, first), (other, second) = (
        (facet, (mesh.face_coedge[facet] == edge[:, None]).argmax(axis=1))
        for facet in mesh.coedge_face[edge].T
    )
    return (
        np.concatenate([3 * one + first, 3 * one + (first + 1) % 3]),
        np.concatenate([3 * other + (second + 1) % 3, 3 * other + second]),
    )
