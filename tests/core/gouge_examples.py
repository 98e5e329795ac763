# SPDX-License-Identifier: LGPL-2.1-or-later
"""Concave parts whose entries have closed forms, and a judge that knows nothing of trees and bounds."""

import numpy as np

from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.tool.body import depth_of


def prism(profile, length=40.0):
    """The closed part of a profile (k, 2) of y and z, counter-clockwise seen against x, from x = -length/2 to
    length/2."""
    profile = np.asarray(profile, float)
    k = len(profile)
    ends = [np.column_stack([np.full(k, x), profile]) for x in (-0.5 * length, 0.5 * length)]
    ring, after = np.arange(k), np.roll(np.arange(k), -1)
    wall = np.concatenate([np.stack([ring, after + k, ring + k], 1), np.stack([ring, after, after + k], 1)])
    ears = _ears(profile)
    face = np.concatenate([wall, ears[:, ::-1], ears + k])
    return from_faces(np.concatenate(ends), face)


def _ears(profile):
    """Triangles of a simple polygon, by cutting off ears."""
    left, found = list(range(len(profile))), []

    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    while len(left) > 2:
        for k in range(len(left)):
            i, j, m = left[k - 1], left[k], left[(k + 1) % len(left)]
            a, b, c = profile[[i, j, m]]
            others = [profile[o] for o in left if o not in (i, j, m)]
            clear = not any(turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0 for p in others)
            if turn(a, b, c) > 0 and clear:
                found.append((i, j, m))
                left.pop(k)
                break
        else:
            raise ValueError("no ear")
    return np.array(found)


def v_groove(half_angle, depth=10.0, side=30.0):
    """A block with a V groove along x, its bottom at y = z = 0."""
    reach = depth * np.tan(half_angle)
    return prism(
        [(-side, -20), (side, -20), (side, depth), (reach, depth), (0, 0), (-reach, depth), (-side, depth)]
    )


def round_groove(radius, steps=64, side=20.0, length=40.0):
    """A block with a half round groove of that radius along x about y = z = 0, its top at z = 0."""
    turn = np.linspace(0.0, np.pi, steps + 1)
    arc = np.column_stack([radius * np.cos(turn), -radius * np.sin(turn)])
    return prism([(-side, -20), (side, -20), (side, 0), *arc, (-side, 0)], length)


def step(height=6.0):
    """A floor at z = 0 and a wall at y = 0 up to a shelf for y > 0."""
    return prism([(-30, -10), (30, -10), (30, height), (0, height), (0, 0), (-30, 0)])


def shelf(gap=12.0, roof=4.0, back=15.0, length=40.0):
    """A floor at z = 0 from y = -25, a wall at y = ``back``, and a roof from y = 0 on, ``gap`` mm over the
    floor and ``roof`` mm thick."""
    wall, top = back + 5.0, gap + roof
    return prism(
        [(-25, -5), (wall, -5), (wall, top), (0, top), (0, gap), (back, gap), (back, 0), (-25, 0)], length
    )


def corner(side=20.0, thick=10.0):
    """Three walls that meet at 0 and stand along the positive axes: an inner corner, open towards (1, 1,
    1)."""
    cells = [np.array([x, y, z]) for x in (0, 1) for y in (0, 1) for z in (0, 1) if (x, y, z) != (1, 1, 1)]
    width = np.array([thick, side])
    quads = []
    for cell in cells:
        for axis in range(3):
            for way in (0, 1):
                beside = cell.copy()
                beside[axis] += 1 if way else -1
                if any((beside == other).all() for other in cells):
                    continue
                low, size = np.where(cell, 0.0, -thick), width[cell]
                u, v = (axis + 1) % 3, (axis + 2) % 3
                square = np.tile(low, (4, 1))
                square[:, axis] += size[axis] * way
                square[1:3, u] += size[u]
                square[2:4, v] += size[v]
                quads.append(square if way else square[::-1])
    vertex, row = np.unique(np.concatenate(quads).round(9), axis=0, return_inverse=True)
    row = row.reshape(-1, 4)
    return from_faces(vertex, np.concatenate([row[:, [0, 1, 2]], row[:, [0, 2, 3]]]))


def bowl(radius=15.0, cells=60, side=40.0):
    """A block with a ball-shaped hollow of that radius about z = 0, its rim at z = -radius / 2."""
    u = np.linspace(-0.5, 0.5, cells + 1) * side
    x, y = np.meshgrid(u, u, indexing="ij")
    z = -np.sqrt(np.maximum(radius**2 - x**2 - y**2, (0.5 * radius) ** 2))
    row = np.arange(x.size).reshape(x.shape)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    skin = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return from_faces(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), skin)


def relief(height, side=40.0, cells=80, floor=-12.0):
    """The closed block of that side under ``z = height(x, y)``, mm, down to the floor."""
    x, y = np.meshgrid(*2 * [np.linspace(-0.5, 0.5, cells + 1) * side], indexing="ij")
    top = np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3)
    row = np.arange(x.size).reshape(x.shape)
    border = np.concatenate([row[:-1, 0], row[-1, :-1], row[:0:-1, -1], row[0, :0:-1]])
    under, after = len(top) + np.arange(len(border)), len(top) + np.roll(np.arange(len(border)), -1)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    quads = [(a, b, c), (a, c, d), (border, under, after), (border, after, np.roll(border, -1))]
    middle = np.full(len(border), len(top) + len(border))
    foot = np.column_stack([top[border][:, :2], np.full(len(border), floor)])
    face = np.concatenate([np.stack(part, axis=1) for part in (*quads, (middle, after, under))])
    return from_faces(np.concatenate([top, foot, [(0.0, 0.0, floor)]]), face)


def bowl_block(radius=15.0, **more):
    """:func:`bowl` as a closed block."""
    return relief(
        lambda x, y: -np.sqrt(np.maximum(radius**2 - x**2 - y**2, (0.5 * radius) ** 2)), floor=-20.0, **more
    )


def knob_in_corner(radius=7.0, at=4.0, wall=9.0, **more):
    """A floor, two walls that meet, and a ball half sunk in the floor near them."""

    def height(x, y):
        knob = np.sqrt(np.maximum(radius**2 - (x - at) ** 2 - (y - at) ** 2, 0.0))
        return np.maximum(knob, np.where((x > 13.0) | (y > 13.0), wall, 0.0))

    return relief(height, **more)


def blade_beside_hub(hub=8.0, gap=5.0, tall=9.0, **more):
    """A round hub, and a blade that stands bent around a part of it, a narrow channel between them."""

    def height(x, y):
        away, turn = np.hypot(x, y), np.arctan2(y, x)
        blade = (np.abs(away - hub - gap - 1.2) < 1.2) & (np.abs(turn) < 1.2)
        return np.maximum(
            np.where(away < hub, 11.0 - 0.05 * away**2, 0.0), np.where(blade, tall - 1.5 * np.abs(turn), 0.0)
        )

    return relief(height, **more)


def dense_points(mesh, spacing):
    """Points (n, 3) all over the mesh."""
    return np.concatenate([_spread(*mesh.vertex[row], spacing) for row in mesh.face])


def _spread(a, b, c, spacing):
    """Rows of points along the longest side, one beside the other up to the corner across."""
    a, b, c = max(((a, b, c), (b, c, a), (c, a, b)), key=lambda t: np.linalg.norm(t[1] - t[0]))
    length = np.linalg.norm(b - a)
    rows = int(np.ceil(np.linalg.norm(np.cross(b - a, c - a)) / length / spacing))
    found = []
    for share in np.linspace(0.0, 1.0, rows + 1):
        along = np.linspace(0.0, 1.0, int(np.ceil(length * (1.0 - share) / spacing)) + 1)[:, None]
        found.append((a + share * (c - a)) * (1.0 - along) + (b + share * (c - b)) * along)
    return np.concatenate(found)


def sampled_depth(body, points, swept, block, samples=41):
    """The depth (mm) of the deepest of ``points`` (n, 3) at densely sampled poses of one block; 0 where none
    is inside. Only those in the box about all poses are asked: about the stretches of the tool's axis between
    the lowest and the highest disc of a piece, and as wide as its widest one."""
    pose = swept.pose(np.full(samples, block), np.linspace(0.0, 1.0, samples))
    tip, axis = pose.tip.T, pose.axis.T
    low, high = min(one.low for one in body.pieces), max(one.high for one in body.pieces)
    ends, wide = np.concatenate([tip + low * axis, tip + high * axis]), max(one.widest for one in body.pieces)
    points = points[((points >= ends.min(axis=0) - wide) & (points <= ends.max(axis=0) + wide)).all(axis=1)]
    return max(depth_of(body, one, way, points).max(initial=0.0) for one, way in zip(tip, axis, strict=True))


def brute_distance(mesh, place):
    """The distance of one place from all facets: over the facet's plane where the foot lies inside, else from
    its three edges."""
    corner = mesh.vertex[mesh.face]
    a = corner[:, 0]
    normal = np.cross(corner[:, 1] - a, corner[:, 2] - a)
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    height = ((place - a) * normal).sum(axis=1)
    foot = place - height[:, None] * normal
    best, inside = np.full(len(a), np.inf), np.ones(len(a), bool)
    for k in range(3):
        p, q = corner[:, k], corner[:, (k + 1) % 3]
        edge = q - p
        share = np.clip(((place - p) * edge).sum(axis=1) / (edge * edge).sum(axis=1), 0.0, 1.0)
        best = np.minimum(best, np.linalg.norm(place - p - share[:, None] * edge, axis=1))
        inside &= (np.cross(edge, foot - p) * normal).sum(axis=1) >= 0.0
    return np.where(inside, np.minimum(best, np.abs(height)), best).min()
