# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed hollows of a part: room inside it that no way leads to from outside.

shell     facets that hang together without a border.
inward    a shell whose volume is below zero: its facets look at what it encloses.
hollow    what an inward shell within an outward one encloses. All facets that look into it are in it, those
          of a solid that lies loose in there too.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_triangles
from freecad_fiveaxis.core.passes.sides import number_connected

from .inside import inside

OVER = 1e-5
"""Of the part's size: so far over a facet is looked."""

NOTHING = 1e-12
"""Of the cube about the part: a volume whose sign is rounding."""


def find_hollow_facets(mesh: Mesh) -> Bools:
    """Find the facets (f,) that look into a closed hollow; none where no shell encloses another one."""
    every = np.arange(len(mesh.face))
    shell = number_connected(mesh, every >= 0, every)
    volume = _measure_volumes(mesh, shell)
    enough = NOTHING * _size(mesh) ** 3
    inner, outer = np.flatnonzero(volume < -enough), volume > enough
    if not len(inner) or not outer.any():
        return np.zeros(len(every), np.bool_)
    place = _middle(mesh, _choose_largest(mesh, shell)[inner])
    hollow = np.isin(shell, inner[_inside_of(mesh, outer[shell], place)])
    if not hollow.any():
        return hollow
    return _inside_of(mesh, hollow, _middle(mesh, every) + OVER * _size(mesh) * mesh.normal)


def _measure_volumes(mesh: Mesh, shell: Ints) -> Floats:
    """Measure what each shell encloses (s,) mm3, below zero where its facets look inward; 0 of one that has a
    border, and encloses nothing."""
    a, b, c = (mesh.vertex[corner] - mesh.vertex.mean(axis=0) for corner in mesh.face.T)
    volume = np.bincount(shell, np.einsum("fx,fx->f", a, np.cross(b, c)) / 6.0)
    volume[shell[mesh.coedge_face[_find_borders(mesh), 0]]] = 0.0
    return np.asarray(volume)


def _find_borders(mesh: Mesh) -> Ints:
    """Find the edges (k,) of an odd number of facets: at an edge of four two solids touch, none is open."""
    alone = np.flatnonzero(mesh.coedge_face[:, 1] < 0)
    low, high = np.sort(mesh.coedge_vertex[alone], axis=1).T
    _, edge, count = np.unique(low * len(mesh.vertex) + high, return_inverse=True, return_counts=True)
    return np.asarray(alone[count[edge] % 2 == 1])


def _choose_largest(mesh: Mesh, shell: Ints) -> Ints:
    """Choose the largest facet (s,) of each shell."""
    order = np.lexsort((-mesh.area, shell))
    return np.asarray(order[np.searchsorted(shell[order], np.arange(int(shell.max()) + 1))])


def _inside_of(mesh: Mesh, some: Bools, place: Floats) -> Bools:
    """Find the places (n, 3) mm (n,) within the shells of ``some`` facets (f,), whichever way these look."""
    return inside(facet_tree(from_triangles(mesh.vertex[mesh.face[some]])), place)


def _middle(mesh: Mesh, facet: Ints) -> Floats:
    return np.asarray(mesh.vertex[mesh.face[facet]].mean(axis=1))


def _size(mesh: Mesh) -> float:
    return float(np.ptp(mesh.vertex, axis=0).max())
