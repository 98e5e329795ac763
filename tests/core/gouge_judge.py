# SPDX-License-Identifier: LGPL-2.1-or-later
"""A judge of entries that shares nothing with the check: libigl's distances to the mesh, and the machine's forward kinematics of
interpolated words.

entry     how deep a point of the part is in the cutter. A point x of the cutter that lies ``a`` below its skin and ``b`` from
          the part tells of an entry of at least ``a - b``, and of the whole of it where x lies behind the deepest point. So the
          points on the axis and on the cones to it from the bottom's edge (or the corner's ring) and from the rim, where all ways
          inward end, tell all of it.
dug       how deep a point of the cutter's skin is in the part: what is taken off too deep. On smooth surfaces it is the entry.

How deep a point lies below the cutter's skin is measured against the outline of tests/core/cutter_body.py.
"""

from dataclasses import dataclass

import numpy as np
import pytest
from cutter_body import meridian
from scipy.spatial import cKDTree

from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q


def libigl():
    """The library, or a skip that says how to get it."""
    return pytest.importorskip("igl", reason="libigl is not installed: pip install libigl")


@dataclass(frozen=True)
class Cloud:
    """Points (k, 3) mm of a cutter at 0 along z, and how far (k,) each lies below its skin."""

    point: np.ndarray
    below: np.ndarray


def cloud(cutter, rings=4):
    """The points where all ways inward end: on the axis, and on the cones to it from the bottom's edge and from the rim."""
    step = cutter.radius / rings
    reach = np.linspace(cutter.ring, 0.0, int(np.ceil(cutter.ring / step)) + 1)
    height = cutter.corner + (cutter.ring - reach)
    up = np.arange(height[-1] + step, max(cutter.length - cutter.radius, height[-1] + step), step)
    top = np.linspace(0.0, cutter.radius, rings + 1)[:-1]  # and where the end on top and the flank are equally near
    reach, height = np.concatenate([reach, 0.0 * up, top]), np.concatenate([height, up, cutter.length - cutter.radius + top])
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
    """Blocks and u (n,): of each of these blocks (b,) ``count`` (b,) places, evenly spread, both ends among them."""
    block, last = np.repeat(blocks, count), np.repeat(count - 1, count)
    return block, (np.arange(len(block)) - np.repeat(np.cumsum(count) - count, count)) / last


def placed(points, tip, axis):
    """Points (k, 3) of a body at tips and axes (n, 3): (n, k, 3)."""
    aside = np.cross(axis, np.eye(3)[np.abs(axis).argmin(axis=1)])
    aside /= np.linalg.norm(aside, axis=1)[:, None]
    frame = np.stack([aside, np.cross(axis, aside), axis], axis=1)
    return tip[:, None] + points @ frame


def distances(mesh, points, signed=False):
    """Distances (n,) mm of points (n, 3) from the mesh; inside negative where ``signed`` (by winding numbers: gaps do not matter)."""
    igl = libigl()
    kind = "FAST_WINDING_NUMBER" if signed else "UNSIGNED"
    face = np.asarray(mesh.face, np.int64)
    return igl.signed_distance(
        np.ascontiguousarray(points), mesh.vertex, face, getattr(igl.SignedDistanceType, f"SIGNED_DISTANCE_TYPE_{kind}")
    )[0]


def entries(mesh, tip, axis, inner):
    """The entry (n,) mm at each of these poses (n, 3), negative where the cutter stays off by more."""
    points = placed(inner.point, tip, axis)
    return (inner.below - distances(mesh, points.reshape(-1, 3)).reshape(points.shape[:2])).max(axis=1)


def dug(mesh, tip, axis, outer):
    """How deep (n,) mm the skin of the cutter is in the part at each of these poses (n, 3)."""
    points = placed(outer.point, tip, axis)
    return -distances(mesh, points.reshape(-1, 3), signed=True).reshape(points.shape[:2]).min(axis=1)


@dataclass(frozen=True)
class Verdict:
    """``entry`` (b,) mm of each block, found at a few places in it; ``worst`` mm, of the worst blocks found at many; ``dug`` mm,
    what the skin digs into the part in those."""

    entry: np.ndarray
    worst: float
    dug: float


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
    return Verdict(most, float(max(fine.max(), entry.max())), float(dug(mesh, tip[top], axis[top], skin(cutter)).max()))
