# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts with sides that look down, and a tool with shank and holder that has to get there and away again."""

import numpy as np
from gouge_examples import prism
from mesh_shapes import box

from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles


def block():
    """A box 30 x 24 x 16 mm."""
    return from_triangles(box((-15, -12, 0), (15, 12, 16)))


def tee():
    """A T along x whose stem widens upwards: its sides look down by 15 deg, the flanges' undersides by 73
    deg."""
    half = [(6, 0), (6, 8), (11, 26), (24, 30), (24, 38)]
    return prism(half + [(-y, z) for y, z in half[::-1]], length=36.0)


def mushroom(rows=24):
    """A cap of 20 mm radius on a stem that widens upwards: the profile turned about Z; looks down by 15 and
    by 69 deg."""
    profile = np.array([(0, 0), (7, 0), (7, 8), (12, 25), (20, 28), (20, 33), (12, 38), (0, 38)], float)
    turn = 2.0 * np.pi * np.arange(rows) / rows
    ring = profile[1:-1]
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    sides = [np.column_stack([r * circle, np.full(rows, z)]) for r, z in ring]
    vertex = np.concatenate([[(0, 0, profile[0, 1])], *sides, [(0, 0, profile[-1, 1])]])
    at, after = np.arange(rows), np.roll(np.arange(rows), -1)
    face = [np.column_stack([0 * at, 1 + after, 1 + at])]
    for k in range(len(ring) - 1):
        low, high = 1 + k * rows, 1 + (k + 1) * rows
        face += [
            np.column_stack([low + at, low + after, high + at]),
            np.column_stack([low + after, high + after, high + at]),
        ]
    last = 1 + (len(ring) - 1) * rows
    face.append(np.column_stack([last + at, last + after, 0 * at + len(vertex) - 1]))
    return from_faces(vertex, np.concatenate(face))


PARTS = {"block": block, "tee": tee, "mushroom": mushroom}
