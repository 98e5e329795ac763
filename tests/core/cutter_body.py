# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutters as bodies of points, by a second route: from their sizes alone, without a formula of the core."""

import numpy as np
from scipy.spatial import cKDTree


def meridian(cutter, arc=300, flank=40):
    """Points (m, 2) mm of the outline from the middle of the bottom up to the rim: distance from the axis,
    height above the tip."""
    lowest = np.linspace(-np.pi / 2, -cutter.taper, arc)
    corner = np.stack(
        [cutter.ring + cutter.corner * np.cos(lowest), cutter.corner + cutter.corner * np.sin(lowest)], axis=1
    )
    height = np.linspace(corner[-1, 1], cutter.length, flank)
    cone = np.stack([corner[-1, 0] + (height - height[0]) * np.tan(cutter.taper), height], axis=1)
    bottom = np.stack([np.linspace(0.0, corner[0, 0], 10), np.zeros(10)], axis=1)
    return np.concatenate([bottom, corner, cone[1:]])


def body(cutter, turns=1200, **counts):
    """Points (n, 3) mm of the cutter's skin, tip at zero, axis along z."""
    outline, turn = meridian(cutter, **counts), np.linspace(0.0, 2 * np.pi, turns, endpoint=False)
    radius, height = outline.T
    return np.stack(
        [
            np.outer(np.cos(turn), radius),
            np.outer(np.sin(turn), radius),
            np.broadcast_to(height, (turns, len(height))),
        ],
        axis=-1,
    ).reshape(-1, 3)


def placed(points, tip, axis):
    """Points of a body that stands at ``tip`` (3,) along ``axis`` (3,); how it is turned about its axis does
    not matter."""
    side = np.cross(axis, np.eye(3)[np.abs(axis).argmin()])
    side /= np.linalg.norm(side)
    return tip + points @ np.stack([side, np.cross(axis, side), axis])


def support(outline, axis, direction):
    """The largest ``direction . x`` of the body's points x for unit directions (n, 3): around the axis exact,
    for the farthest point of a circle is known."""
    along = direction @ axis
    across = np.sqrt(np.maximum(1 - along**2, 0))
    return (across[:, None] * outline[:, 0] + along[:, None] * outline[:, 1]).max(axis=1)


def depth(cutter, tip, axis, points, most=150):
    """How deep (n,) mm the deepest of ``points`` (k, 3) lies in a cutter at each tip (n, 3) along axis (n,
    3), or at ``most`` of them; outside it is negative, and only right near the skin. The flank goes on
    upwards for ever."""
    some = np.unique(np.linspace(0, len(tip) - 1, most).astype(int))
    tip, axis = tip[some], axis[some]
    tree, reach, found = (
        cKDTree(points, balanced_tree=False, compact_nodes=False),
        cutter.radius + 1.0,
        np.full(len(tip), -np.inf),
    )
    hub = tip + cutter.corner * axis
    for row, near in enumerate(tree.query_ball_point(hub, reach)):
        if near:
            found[row] = inside(cutter, points[near] - hub[row], axis[row]).max()
    return found


def inside(cutter, from_hub, axis):
    """Depth (n,) mm of points given from the hub (n, 3), of a cutter along ``axis``, (3,) or (n, 3)."""
    height = (from_hub * axis).sum(axis=1)
    radius = np.linalg.norm(from_hub - height[:, None] * axis, axis=1)
    below = cutter.corner - np.hypot(np.maximum(radius - cutter.ring, 0), height)
    sine, cosine = np.sin(cutter.taper), np.cos(cutter.taper)
    flank = cutter.corner + (cutter.ring - radius) * cosine + height * sine
    rounded = (
        height * cosine + (radius - cutter.ring) * sine < 0
    )  # nearest to the corner circle, not to the flank
    above = np.where(rounded & (radius > cutter.ring), np.minimum(below, flank), flank)
    return np.where(height < 0, below, np.minimum(above, height + cutter.corner))


def facet_points(mesh, step):
    """Points (n, 3) mm on every facet, about ``step`` apart."""
    corner = mesh.vertex[mesh.face]
    longest = np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2).max(axis=1)
    parts = []
    for count in range(1, 1 + int(np.ceil(longest / step).clip(1, 60).max())):
        u, v = np.meshgrid(np.arange(count + 1) / count, np.arange(count + 1) / count)
        u, v = u[u + v < 1 + 1e-9], v[u + v < 1 + 1e-9]
        a, b, c = corner[np.ceil(longest / step).clip(1, 60) == count].transpose(1, 0, 2)
        parts.append(
            (a[:, None] + u[:, None] * (b - a)[:, None] + v[:, None] * (c - a)[:, None]).reshape(-1, 3)
        )
    return np.concatenate(parts)
