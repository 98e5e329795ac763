# SPDX-License-Identifier: LGPL-2.1-or-later
"""Along what bores and grooves of a part stand: the rulings of its hollow walls, which are tessellated into
strips.

A bore that stands askew has no normal along it. Its strips have their long sides along it, all alike; the
diagonals that divide them are all different, or short of that.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.vectors import dot
from freecad_fiveaxis.core.geometry.mesh import Mesh

MOST, LEAST = 4, 0.03
"""Rulings, at most: those along which most length lies, and at least such a share of all."""

LEAST_TURN, LARGEST_TURN = math.radians(0.5), math.radians(50.0)
"""rad from one facet to the next: about less they are flat, about more it is an inside corner."""

LONG = 3.0
"""A ruling is so many times as long as its facets are wide, at least."""

STRIPS = 5
"""So many parallel co-edges make a hollow wall: a fillet of a quarter of a turn, cut coarsely."""

ALIKE = 0.002
"""Of a unit vector: co-edges whose directions differ by less in each coordinate are taken for parallel."""

APART = math.cos(math.radians(3.0))
"""Cosine of the angle within which two rulings are worth no more than one."""


ASKEW = np.array([0.137, 0.293, 0.946])
"""Vectors that look against it are turned round: hardly any wall of a part is ruled square to it."""


def find_rulings(mesh: Mesh, known: Floats) -> Floats:
    """Find the unit vectors (d, 3), one way, along which hollow walls of the part are ruled, but for those
    that lie along the ``known`` ones (k, 3)."""
    found, count = known, len(known)
    coedge = mesh.coedge_vertex[_hollow_coedges(mesh)]
    for one in _parallel(_one_way(np.diff(mesh.vertex[coedge], axis=1)[:, 0])):
        if len(found) < count + MOST and (np.abs(found @ one) < APART).all():
            found = np.concatenate([found, one[None]])
    return found[count:]


def _parallel(along: Floats) -> Floats:
    """Return the unit directions (d, 3) in which many of these co-edges (n, 3) mm lie, those of most length
    first."""
    length = np.linalg.norm(along, axis=1)
    key = np.round(along / (ALIKE * length[:, None])).astype(np.int64)
    _, group, count = np.unique(key, axis=0, return_inverse=True, return_counts=True)
    total = np.bincount(group.ravel(), length)
    most = np.argsort(-total, kind="stable")
    most = most[(count[most] >= STRIPS) & (total[most] > LEAST * total.sum())]
    summed = np.stack([np.bincount(group.ravel(), side) for side in along.T], axis=1)[most]
    return np.asarray(summed / np.linalg.norm(summed, axis=1)[:, None])


def _one_way(along: Floats) -> Floats:
    """Turn round those of vectors (n, 3) that look to the other side of a plane askew to all of a frame's."""
    return np.where((along @ ASKEW < 0.0)[:, None], -along, along)


def _hollow_coedges(mesh: Mesh) -> Ints:
    """Return the co-edges (k,), long for their facets, about which two facets turn towards each other."""
    shared = np.flatnonzero(mesh.coedge_face[:, 1] >= 0)
    face = mesh.coedge_face[shared]
    one, other = mesh.normal[face[:, 0]].T, mesh.normal[face[:, 1]].T
    along = np.diff(mesh.vertex[mesh.coedge_vertex[shared]], axis=1)[:, 0]
    turn = np.arccos(np.clip(dot(one, other), -1.0, 1.0))
    bent = (turn > LEAST_TURN) & (turn < LARGEST_TURN)
    long = dot(along.T, along.T) > LONG * 2.0 * mesh.area[face].max(axis=1)
    towards = dot(np.cross(one.T, other.T).T, along.T) < 0.0
    return np.asarray(shared[bent & long & towards])
