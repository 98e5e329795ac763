# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scallop that a ball end leaves between two passes (Lin & Ye, II.C), on slopes and curved surfaces too.

scallop    height of the cusp between two neighbouring passes above the surface (Lin & Ye, Fig. 4).
chord      straight distance of two neighbouring contact points, measured over the surface, not between the
           planes.
curvature  normal curvature of the surface across the passes, 1/mm; positive where the surface is convex.
kink       what the normal turns between two contact points beyond what the curvature accounts for: the edge
           between two facets, be it a sharp edge of the part or a step of the tessellation.
"""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.geometry.mesh import Mesh

CREASE = np.radians(30.0)
"""Facets that meet at a larger angle meet in a sharp edge of the part; below it they approximate a smooth
surface."""

FINE_KINK = 0.15
"""``q`` of :func:`kink_factor` below which the kink may be the sum of many edges and the worst place is taken
for theirs."""

TINY = 1e-12
"""mm: points nearer than this coincide; keeps divisions safe and is far below any coordinate's rounding."""


def refuse_high_scallop(scallop: float, radius: float) -> None:
    """Raise SettingsError for a ``scallop`` that no ball of ``radius`` leaves, both mm."""
    if scallop >= radius:
        text = say(
            "scallop {scallop} is not below the cutter radius {radius}; give a smaller scallop",
            scallop=Length(scallop), radius=Length(radius),
        )  # fmt: skip
        raise SettingsError(text, scallop)


def scallop_height(chord: Floats, radius: float, curvature: Floats) -> Floats:
    """Height (n,) mm of the cusp over the circle through two contacts ``chord`` (n,) mm apart, for a ball of
    ``radius`` mm.

    Eq. (1) of Lin & Ye for ``curvature`` (n,) 1/mm = 0; else the same triangle over the circle of that
    curvature. Where the two balls do not meet, half the distance of their centres stands for it.
    """
    spread = np.maximum(1.0 + radius * curvature, 0.0)  # of the centres; 0 where the ball fills the hollow
    x = 0.5 * spread * chord
    inside = np.sqrt(np.maximum(radius * radius - x * x, 0.0))
    half_sine = np.minimum(np.abs(0.5 * curvature * chord), 1.0)
    bulge = 0.25 * spread * curvature * chord * chord / (1.0 + np.sqrt(1.0 - half_sine * half_sine))
    return np.where(x < radius, np.maximum(x * x / (radius + inside) - bulge, 0.0), x)


def flat_interval(radius: float, scallop: float) -> float:
    """Eq. (2) of Lin & Ye without its approximation: the interval on a flat, mm; ``scallop`` below
    ``radius``, both mm."""
    return 2.0 * float(np.sqrt(scallop * (2.0 * radius - scallop)))


def kink_factor(chord: Floats, radius: float, kink: Floats, along: Floats, far: Floats) -> Floats:
    """How much (n,) at most a kink between two contacts raises the scallop, 1 to 4.

    ``kink`` (n,) rad: its part across the passes, positive where convex; ``along`` (n,) rad: its part along
    them, not 0 where the edge runs aslant; ``far`` (n,): the larger distance of the edge from a contact, 0.5
    to 1 chord. Both balls stand equally high over the wider facet at ``far - (2 far - 1) / (2 (1 + q))`` of
    the chord, ``q = radius kink / chord``; the height goes with its square. Where the edge runs at an angle p
    to the passes, the ball that rolls over it at the crossing cuts the other facet too, and no point is
    further than ``1 / (1 + tan p)`` of the chord from a contact.
    """
    convex = np.maximum(kink, 0.0)
    q = radius * convex / np.maximum(chord, TINY)
    fine = np.minimum(q, FINE_KINK)
    known = 2.0 * far - (2.0 * far - 1.0) / (1.0 + q)
    aslant = 2.0 * convex / np.maximum(convex + along, TINY)
    share = np.maximum(np.minimum(np.maximum(known, 2.0 - 1.0 / (1.0 + fine)), aslant), 1.0)
    return share * share


# ------------------------------------------------------------------------------------------------ curvature


_TENSORS: WeakKeyDictionary[Mesh, Floats] = WeakKeyDictionary()


def facet_curvature(mesh: Mesh) -> Floats:
    """Curvature tensor (6, f) of each facet, 1/mm: xx, yy, zz, xy, yz, zx; ``c . T c`` is the curvature along
    unit tangent c.

    Each co-edge turns the surface by its dihedral angle about itself; the tensor is the mean of these turns
    over the facet and its neighbours (Cohen-Steiner & Morvan 2003), exact on average for any tessellation of
    a sphere or a cylinder. Sharp edges bend no surface and do not count. Computed once, and kept as long
    as the mesh is: checks and strategies ask in turn.
    """
    if mesh not in _TENSORS:
        _TENSORS[mesh] = _mean_turns(mesh)
        _TENSORS[mesh].setflags(write=False)
    return _TENSORS[mesh]


def hand_curvature_on(mesh: Mesh, to: Mesh, parent: Ints) -> None:
    """Let facets (f,) of another mesh, pieces of ``parent`` (f,) facets of this one, have the curvature of
    those."""
    _TENSORS[to] = facet_curvature(mesh)[:, parent]
    _TENSORS[to].setflags(write=False)


def _mean_turns(mesh: Mesh) -> Floats:
    """Return the tensor (6, f) of each facet."""
    first, second, turned = _smooth_turns(mesh)
    rows = len(mesh.face)
    columns = np.concatenate([turned, np.zeros((1, len(first)))])
    total = np.array(
        [np.bincount(first, c, rows) + np.bincount(second, c, rows) for c in columns], np.float64
    )
    total[6] = mesh.area
    own = total.copy()
    for sums, values in zip(total, own, strict=True):
        sums += np.bincount(first, values[second], rows) + np.bincount(second, values[first], rows)
    tensor: Floats = total[:6] / total[6]
    return tensor


def _smooth_turns(mesh: Mesh) -> tuple[Ints, Ints, Floats]:
    """Both facets (m,), (m,) of each co-edge that is no sharp edge, and the half (6, m) of its turn that each
    gets, mm."""
    edge = np.flatnonzero(mesh.coedge_face[:, 1] >= 0)
    first, second = mesh.coedge_face[edge].T
    smooth = (mesh.normal[first] * mesh.normal[second]).sum(axis=1) > np.cos(CREASE)
    edge, first, second = edge[smooth], first[smooth], second[smooth]
    start, end = mesh.coedge_vertex[edge].T
    along = mesh.vertex[end] - mesh.vertex[start]  # counter-clockwise for the first facet
    twice_turn = (np.cross(mesh.normal[first], mesh.normal[second]) * along).sum(
        axis=1
    )  # angle times length, small angles
    across = np.cross(along, mesh.normal[first] + mesh.normal[second])
    x, y, z = (across / np.maximum(np.linalg.norm(across, axis=1), TINY)[:, None]).T
    return first, second, 0.5 * twice_turn * np.array([x * x, y * y, z * z, x * y, y * z, z * x])


def compute_turn(tensor: Floats, direction: Floats) -> Floats:
    """How the normal turns (n, 3), 1/mm, along unit ``direction`` (n, 3), for tensors (6, n) of
    :func:`facet_curvature`."""
    x, y, z = direction.T
    xx, yy, zz, xy, yz, zx = tensor
    return np.array([xx * x + xy * y + zx * z, xy * x + yy * y + yz * z, zx * x + yz * y + zz * z]).T
