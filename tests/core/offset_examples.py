# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact paths by hand, parts, and distances by brute force, for the tests of co-edges, tool axes and
links."""

import numpy as np
from scipy.spatial import ConvexHull

from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles
from freecad_fiveaxis.core.passes import ContactPath


def prism(profile, skew=(0.0, 1.0, 0.0), closed=False):
    """One polyline in the plane y = 0 over facets that run on along ``skew``; normals to the left of the
    travel."""
    corner = np.array([(x, 0.0, z) for x, z in profile])
    corner = np.vstack([corner, corner[:1]]) if closed else corner
    step = np.diff(corner, axis=0)
    normal = np.cross(step, skew)
    with np.errstate(invalid="ignore"):
        normal = np.nan_to_num(normal / np.linalg.norm(normal, axis=1)[:, None]) + (normal == 0).all(axis=1)[
            :, None
        ] * (0, 0, 1)
    count = len(step)
    point = np.empty((2 * count, 3))
    point[::2], point[1::2] = corner[:-1], corner[1:]
    segment = np.repeat(np.arange(count), 2)
    coedge = np.arange(2 * count) // 2 + np.arange(2 * count) % 2
    coedge[-1] = 0 if closed else -1
    coedge[0] = 0 if closed else -1
    label = np.zeros(2 * count, int)
    return ContactPath(point, normal[segment], segment, coedge, segment, label, label)


def joined(*paths, same_pass=False):
    """Contact paths one after the other, each a polyline of its own."""
    segment = np.cumsum([0] + [len(path.point) // 2 for path in paths])
    columns = {
        name: np.concatenate([getattr(path, name) for path in paths])
        for name in ("point", "normal", "face", "coedge")
    }
    line = np.repeat(np.arange(len(paths)), np.diff(segment) * 2)
    return ContactPath(
        **columns,
        segment=np.repeat(np.arange(segment[-1]), 2),
        polyline=line,
        pass_=0 * line if same_pass else line,
    )


def hull(points):
    """The convex hull as a mesh."""
    found = ConvexHull(points)
    face = found.simplices.copy()
    normal = np.cross(points[face[:, 1]] - points[face[:, 0]], points[face[:, 2]] - points[face[:, 0]])
    inward = (normal * found.equations[:, :3]).sum(axis=1) < 0
    face[inward] = face[inward][:, ::-1]
    return from_triangles(points[face])


def ball(count=400, scale=(20.0, 20.0, 20.0), seed=1):
    """Random points on an ellipsoid."""
    point = np.random.default_rng(seed).normal(size=(count, 3))
    return hull(point / np.linalg.norm(point, axis=1)[:, None] * scale)


def field(height, count=21, half=20.0, seed=None):
    """A surface z = height(x, y) on a grid; with a seed the grid is uneven."""
    x, y = np.meshgrid(np.linspace(-half, half, count), np.linspace(-half, half, count), indexing="ij")
    if seed is not None:
        x, y = (
            c + np.random.default_rng(seed + k).uniform(-0.3, 0.3, c.shape) * 2 * half / count
            for k, c in enumerate((x, y))
        )
    row = np.arange(count * count).reshape(count, count)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    face = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return from_faces(np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3), face)


def distance(point, triangle):
    """From points (..., 3) to triangles (..., 3, 3), shapes broadcast: plane where the foot is inside, else
    the edges."""
    corner = [triangle[..., k, :] for k in range(3)]
    normal = np.cross(corner[1] - corner[0], corner[2] - corner[0])
    normal = normal / np.linalg.norm(normal, axis=-1, keepdims=True)
    height = ((point - corner[0]) * normal).sum(-1)
    inside, nearest = np.ones(height.shape, bool), np.full(height.shape, np.inf)
    for k in range(3):
        edge = corner[(k + 1) % 3] - corner[k]
        inside &= (np.cross(normal, edge) * (point - corner[k])).sum(-1) >= 0
        t = np.clip(((point - corner[k]) * edge).sum(-1) / (edge * edge).sum(-1), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(point - corner[k] - t[..., None] * edge, axis=-1))
    return np.where(inside, np.abs(height), nearest)


def chords(path, samples=9):
    """Points (samples, c, 3) on the chords of the offset path, and the row (c,) at which each begins."""
    row = np.flatnonzero(path.polyline[1:] == path.polyline[:-1])
    u = np.linspace(0, 1, samples)[:, None, None]
    return path.centre[row] * (1 - u) + path.centre[row + 1] * u, row


def clearance(path, mesh, samples=9):
    """The least distance of every chord from the whole mesh, (c,)."""
    point, _ = chords(path, samples)
    flat = point.reshape(-1, 3)
    parts = [
        distance(flat[k : k + 100, None], mesh.vertex[mesh.face]).min(axis=1)
        for k in range(0, len(flat), 100)
    ]
    return np.concatenate(parts).reshape(samples, -1).min(axis=0)


def own_clearance(path, mesh, samples=9):
    """The least distance of every chord from the facets of the rows at its two ends, (c,), and the row it
    begins at."""
    point, row = chords(path, samples)
    corner = mesh.vertex[mesh.face]
    return np.minimum(
        distance(point, corner[path.face[row]]), distance(point, corner[path.face[row + 1]])
    ).min(axis=0), row
