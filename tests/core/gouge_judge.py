# SPDX-License-Identifier: LGPL-2.1-or-later
"""A judge of entries that shares nothing with the check: libigl's distances to the mesh, and the machine's
forward kinematics of interpolated words.

entry     how deep a point of the part is in the cutter. A point x of the cutter that lies ``a`` below its
          skin and ``b`` from the part tells of an entry of at least ``a - b``, and of the whole of it where x
          lies behind the deepest point. So the points on the axis and on the cones to it from the bottom's
          edge (or the corner's ring) and from the rim, where all ways inward end, tell all of it.
dug       how deep a point of the cutter's skin is in the part: what is taken off too deep. On smooth surfaces
          it is the entry.

How deep a point lies below the cutter's skin is measured against the outline of tests/core/cutter_body.py.
"""

from collections.abc import Callable
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
import pytest
from cutter_body import meridian
from scipy.spatial import cKDTree

from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q

CELL = 0.5


def libigl():
    """The library, or a skip that says how to get it."""
    return pytest.importorskip("igl", reason="libigl is not installed: pip install libigl")


@dataclass(frozen=True)
class Cloud:
    """Points (k, 3) mm of a cutter at 0 along z, and how far (k,) each lies below its skin."""

    point: np.ndarray
    below: np.ndarray


def cloud(cutter, rings=4):
    """The points where all ways inward end: on the axis, and on the cones to it from the bottom's edge and
    from the rim."""
    step = cutter.radius / rings
    reach = np.linspace(cutter.ring, 0.0, int(np.ceil(cutter.ring / step)) + 1)
    height = cutter.corner + (cutter.ring - reach)
    up = np.arange(height[-1] + step, max(cutter.length - cutter.radius, height[-1] + step), step)
    top = np.linspace(0.0, cutter.radius, rings + 1)[
        :-1
    ]  # and where the end on top and the flank are equally near
    reach, height = (
        np.concatenate([reach, 0.0 * up, top]),
        np.concatenate([height, up, cutter.length - cutter.radius + top]),
    )
    return _turned(cutter, reach, height, step)


def skin(cutter, arc=24, flank=8, step=None):
    """Points of the skin."""
    reach, height = meridian(cutter, arc=arc, flank=flank).T
    return _turned(cutter, reach, height, cutter.radius / 12 if step is None else step)


def _turned(cutter, reach, height, step):
    outline = meridian(cutter, arc=4000, flank=8000)
    top = np.column_stack([np.linspace(0.0, outline[-1, 0], 2000), np.full(2000, cutter.length)])
    bottom = np.column_stack([np.linspace(0.0, cutter.ring, 2000), np.zeros(2000)])
    below = cKDTree(np.concatenate([outline, top, bottom])).query(np.column_stack([reach, height]))[0]
    count = np.maximum(np.ceil(2 * np.pi * reach / step), 1).astype(int)
    turn = np.concatenate([2 * np.pi * np.arange(n) / n for n in count])
    reach, height, below = (np.repeat(part, count) for part in (reach, height, below))
    return Cloud(np.column_stack([reach * np.cos(turn), reach * np.sin(turn), height]), below)


def poses(kinematics, words, blocks, u, back=0.0):
    """Tips and axes (n, 3) at u (n,) of blocks (n,): the words linearly between their rows."""
    rows = words[blocks] + u[:, None] * (words[blocks + 1] - words[blocks])
    tip, axis = forward(kinematics, words_to_q(rows))
    return tip - back * axis, axis


def spread(blocks, count):
    """Blocks and u (n,): of each of these blocks (b,) ``count`` (b,) places, evenly spread, both ends among
    them."""
    block, last = np.repeat(blocks, count), np.repeat(count - 1, count)
    return block, (np.arange(len(block)) - np.repeat(np.cumsum(count) - count, count)) / last


def placed(points, tip, axis):
    """Points (k, 3) of a body at tips and axes (n, 3): (n, k, 3)."""
    aside = np.cross(axis, np.eye(3)[np.abs(axis).argmin(axis=1)])
    aside /= np.linalg.norm(aside, axis=1)[:, None]
    frame = np.stack([aside, np.cross(axis, aside), axis], axis=1)
    return tip[:, None] + points @ frame


_TREES = WeakKeyDictionary()
"""libigl's tree of each mesh that distances were asked of."""


def distances(mesh, points, signed=False):
    """Distances (n,) mm of points (n, 3) from the mesh; inside negative where ``signed`` (by winding numbers:
    gaps do not matter)."""
    igl, face = libigl(), np.asarray(mesh.face, np.int64)
    if signed:
        kind = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
        return igl.signed_distance(np.ascontiguousarray(points), mesh.vertex, face, kind)[0]
    if mesh not in _TREES:
        _TREES[mesh] = igl.AABB()
        _TREES[mesh].init(mesh.vertex, face)
    return np.sqrt(_TREES[mesh].squared_distance(mesh.vertex, face, np.ascontiguousarray(points))[0])


def entries(mesh, tip, axis, inner):
    """The entry (n,) mm at each of these poses (n, 3), negative where the cutter stays off by more.

    Of each cell of points one is asked first. No other tells of more than what it lies below the skin and
    away from that one, less that one's distance: cells that cannot exceed what is found at their pose are
    left out. The result is that of all points, to the last digits.
    """
    first, cell, apart = _cells(inner)
    most = np.full(len(first), -np.inf)
    np.maximum.at(most, cell, inner.below + apart)
    off = _distances_at(mesh, inner.point[first], tip, axis)
    best = (inner.below[first] - off).max(axis=1)
    pose, point = np.nonzero(((most - off) > best[:, None])[:, cell] & (apart > 0.0))
    np.maximum.at(
        best, pose, inner.below[point] - distances(mesh, _each(inner.point[point], tip[pose], axis[pose]))
    )
    return best


def dug(mesh, tip, axis, outer):
    """How deep (n,) mm the skin of the cutter is in the part at each of these poses (n, 3)."""
    return -_distances_at(mesh, outer.point, tip, axis, signed=True).min(axis=1)


def _cells(points):
    """A point (c,) of each cell, and the cell (k,) of each point and how far (k,) mm it is from that one.
    Cells are cubes, CELL of the most that a point lies below the skin wide."""
    cube = np.floor(points.point / (CELL * points.below.max())).astype(int)
    _, first, cell = np.unique(cube, axis=0, return_index=True, return_inverse=True)
    cell = cell.reshape(-1)
    return first, cell, np.linalg.norm(points.point - points.point[first[cell]], axis=1)


def _distances_at(mesh, points, tip, axis, signed=False):
    """Distances (n, k) mm of points (k, 3) of a body at tips and axes (n, 3)."""
    return distances(mesh, placed(points, tip, axis).reshape(-1, 3), signed).reshape(len(tip), -1)


def _each(points, tip, axis):
    """Points (n, 3) of a body, each at its own tip and axis (n, 3)."""
    return np.einsum("nj,nji->ni", points, placed(np.eye(3), 0.0 * tip, axis)) + tip


@dataclass(frozen=True)
class Verdict:
    """``entry`` (b,) mm of each block, found at a few places in it; ``worst`` mm, of the worst blocks found
    at many; ``dug`` mm, what the skin digs into the part in those, which is worked out for who asks."""

    entry: np.ndarray
    worst: float
    _dug: Callable[[], np.ndarray]

    @property
    def dug(self):
        return float(self._dug().max())


def judged(mesh, cutter, kinematics, words, blocks, back=0.0, finest=33, deepest=12):
    """The verdict over blocks (b,) of a program, the worst of them looked at closely."""
    way = np.linalg.norm(np.diff(forward(kinematics, words_to_q(words))[0], axis=0), axis=1)[blocks]
    count = np.clip(np.ceil(way / (0.1 * cutter.radius)) + 1, 3, 400).astype(int)
    block, u = spread(blocks, count)
    entry = entries(mesh, *poses(kinematics, words, block, u, back), cloud(cutter))
    worst, of = np.argsort(-entry)[:deepest], 1.0 / (np.repeat(count, count) - 1)
    near = np.clip(u[worst, None] + of[worst, None] * np.linspace(-1.0, 1.0, finest), 0.0, 1.0)
    tip, axis = poses(kinematics, words, np.repeat(block[worst], finest), near.ravel(), back)
    top = np.argsort(-entries(mesh, tip, axis, cloud(cutter, rings=8)))[:8]
    fine = entries(mesh, tip[top], axis[top], cloud(cutter, rings=32))
    most = np.maximum.reduceat(entry, np.cumsum(count) - count)
    return Verdict(
        most, float(max(fine.max(), entry.max())), lambda: dug(mesh, tip[top], axis[top], skin(cutter))
    )
