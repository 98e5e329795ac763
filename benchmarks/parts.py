# SPDX-License-Identifier: LGPL-2.1-or-later
"""Large parts for the benchmarks, made by numpy alone."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_faces

SIDE = 200.0  # mm


def bumpy_faces(facets: int) -> tuple[Floats, Ints]:
    """Vertices (v, 3) mm and facets (f, 3) of :func:`bumpy`."""
    n = max(2, round(np.sqrt(facets / 2)))
    u = np.linspace(-1.0, 1.0, n + 1)
    x, y = (g.ravel() for g in np.meshgrid(u, u))
    z = 40.0 + 30.0 * (1.0 - 0.5 * (x * x + y * y)) + 4.0 * np.sin(7.0 * x + 1.0) * np.cos(6.0 * y)
    top = np.column_stack([0.5 * SIDE * x, 0.5 * SIDE * y, z])

    row = np.arange((n + 1) * (n + 1)).reshape(n + 1, n + 1)
    a, b, c, d = row[:-1, :-1].ravel(), row[:-1, 1:].ravel(), row[1:, 1:].ravel(), row[1:, :-1].ravel()
    cells = np.column_stack([a, b, c, a, c, d]).reshape(-1, 3)

    rim = np.concatenate(
        [row[0, :-1], row[:-1, -1], row[-1, :0:-1], row[:0:-1, 0]]
    )  # counter-clockwise from above
    foot = len(top) + np.arange(len(rim))
    rim_next, foot_next, centre = np.roll(rim, -1), np.roll(foot, -1), np.full(len(rim), len(top) + len(rim))
    walls = np.column_stack([rim, foot, foot_next, rim, foot_next, rim_next]).reshape(-1, 3)
    base = np.column_stack([foot_next, foot, centre])

    low = top[rim] * (1.0, 1.0, 0.0)
    vertex = np.concatenate([top, low, np.zeros((1, 3))])
    return vertex, np.concatenate([cells, walls, base]).astype(np.int64)


def bumpy(facets: int) -> Mesh:
    """Return a closed block of 200 x 200 mm with a domed and bumpy top of about ``facets`` facets (the walls
    add a few)."""
    return from_faces(*bumpy_faces(facets))
