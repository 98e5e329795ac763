# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of revolution."""

import math

import numpy as np

from freecad_fiveaxis.core.geometry.mesh import from_faces


def solid_of_revolution(profile, columns):
    """A solid (mesh) of a profile (k, 2) of radius and height mm, from the axis above to the axis below,
    turned about Z."""
    inner, turn = np.asarray(profile[1:-1]), 2.0 * math.pi * np.arange(columns) / columns
    ring = [
        np.outer(inner[:, 0], np.cos(turn)),
        np.outer(inner[:, 0], np.sin(turn)),
        np.repeat(inner[:, 1:], columns, 1),
    ]
    point, row = np.stack(ring, axis=-1).reshape(-1, 3), np.arange(len(inner) * columns).reshape(-1, columns)
    after = np.roll(row, -1, axis=1)
    a, b, c, d = (part.ravel() for part in (row[:-1], row[1:], after[1:], after[:-1]))
    top, low = np.full(columns, len(point)), np.full(columns, len(point) + 1)
    face = [[top, row[0], after[0]], [low, after[-1], row[-1]], [a, b, c], [a, c, d]]
    ends = [[0.0, 0.0, profile[0][1]], [0.0, 0.0, profile[-1][1]]]
    return from_faces(np.concatenate([point, ends]), np.concatenate([np.stack(one, 1) for one in face]))
