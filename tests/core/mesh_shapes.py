# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small solids and surfaces for the tests: triangle corners (f, 3, 3), mm."""

import numpy as np

CUBE_FACES = np.array(
    [
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ]
)


def box(low=(0.0, 0.0, 0.0), high=(1.0, 1.0, 1.0)):
    """Twelve facets of a box."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    vertex = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]) * (high - low) + low
    return vertex[CUBE_FACES]


def sphere(radius=10.0, rows=12, columns=20, centre=(0.0, 0.0, 0.0)):
    """A closed sphere of latitude and longitude facets, vertices on the sphere."""
    polar = np.linspace(0.0, np.pi, rows + 1)
    turn = np.linspace(0.0, 2.0 * np.pi, columns + 1)
    sine = np.sin(polar)
    sine[[0, -1]] = 0.0
    p = np.stack(
        [
            np.outer(sine, np.cos(turn)),
            np.outer(sine, np.sin(turn)),
            np.outer(np.cos(polar), np.ones(columns + 1)),
        ],
        -1,
    )
    p[:, -1] = p[:, 0]
    a, b, c, d = p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]
    upper, lower = np.stack([a, b, d], 2).reshape(-1, 3, 3), np.stack([b, c, d], 2).reshape(-1, 3, 3)
    upper = upper.reshape(rows, columns, 3, 3)[1:].reshape(-1, 3, 3)
    lower = lower.reshape(rows, columns, 3, 3)[:-1].reshape(-1, 3, 3)
    return radius * np.concatenate([upper, lower]) + np.asarray(centre, float)


def field(n, height, spacing=1.0):
    """An open height field of 2 n n facets over the square from 0 to n spacing; ``height`` is a function of x
    and y."""
    x, y = np.meshgrid(spacing * np.arange(n + 1.0), spacing * np.arange(n + 1.0), indexing="ij")
    p = np.stack([x, y, height(x, y)], -1)
    a, b, c, d = p[:-1, :-1], p[1:, :-1], p[1:, 1:], p[:-1, 1:]
    return np.concatenate(
        [np.stack([a, b, c], 2).reshape(-1, 3, 3), np.stack([a, c, d], 2).reshape(-1, 3, 3)]
    )
