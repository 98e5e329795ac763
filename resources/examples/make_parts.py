# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the example parts: ``python make_parts.py FOLDER`` writes them there as STL files.

Every part stands with its base on z = 0, centred on the work zero, as on a rotary table. Each function gives vertices
(v, 3) mm and facets (f, 3), counter-clockwise seen from outside.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from freecad_fiveaxis.core.mesh import from_faces
from freecad_fiveaxis.core.stl import write_stl

Solid = tuple[NDArray[np.float64], NDArray[np.int64]]


def dome(radius: float = 40.0, height: float = 16.0, plinth: float = 12.0, cells: int = 48) -> Solid:
    """A spherical cap on a round plinth: its top passes the pole of every machine whose C axis is vertical."""
    u, v = _square(2.0, 2.0, cells, cells)
    share = np.maximum(np.abs(u), np.abs(v))  # squares become circles
    turn, tilt = np.arctan2(v, u), share * np.arccos(1.0 - height / radius)
    x, y = radius * np.sin(tilt) * np.cos(turn), radius * np.sin(tilt) * np.sin(turn)
    return _standing(x, y, plinth + height - radius * (1.0 - np.cos(tilt)))


def blade(length: float = 90.0, chord: float = 44.0, thickness: float = 9.0, twist: float = 0.5) -> Solid:
    """A twisted, tapered blade lying on its pressure side; its suction side is milled from above. ``twist`` in rad."""
    angle = np.linspace(0.0, 2.0 * np.pi, 72, endpoint=False)
    camber = 0.16 * chord * np.cos(0.5 * np.pi * np.cos(angle))
    half = 0.5 * thickness * np.sin(angle)
    loops = []
    for station in np.linspace(0.0, 1.0, 41):
        scale, turn = 1.0 - 0.35 * station, twist * (station - 0.5)
        x, z = 0.5 * chord * scale * np.cos(angle), scale * (camber + half)
        y = np.full_like(x, length * (station - 0.5))
        loops.append(np.column_stack([x * np.cos(turn) - z * np.sin(turn), y, x * np.sin(turn) + z * np.cos(turn)]))
    vertex, face = _loft(loops, top=tuple(loops[0].mean(axis=0)), foot=tuple(loops[-1].mean(axis=0)))
    return vertex - (0.0, 0.0, vertex[:, 2].min()), face


def saddle(side: float = 70.0, rise: float = 9.0, middle: float = 25.0, cells: int = 44) -> Solid:
    """A hyperbolic paraboloid on a square block: convex one way, concave the other."""
    x, y = _square(side, side, cells, cells)
    return _standing(x, y, middle + rise * (x * x - y * y) / (side / 2) ** 2)


def half_cylinder(radius: float = 60.0, length: float = 80.0, sectors: int = 60, slices: int = 8) -> Solid:
    """Half a cylinder lying on its flat side, its axis along X (Lin & Ye, Fig. 10)."""
    angle = np.linspace(0.0, np.pi, sectors + 1)
    x = np.linspace(-length / 2, length / 2, slices + 1)
    arc = [np.column_stack([np.full_like(angle, at), -radius * np.cos(angle), radius * np.sin(angle)]) for at in x]
    for loop in arc:
        loop[[0, -1], 2] = 0.0
    return _loft(arc, top=(x[0], 0.0, radius / 2), foot=(x[-1], 0.0, radius / 2))


def freeform_233(length: float = 100.0, width: float = 60.0) -> Solid:
    """An open freeform surface of 233 facets of very different size, as on Lin & Ye's Fig. 16 (never published)."""
    rng = np.random.default_rng(233)
    rim, inner = 25, 105  # a triangulation of n points, h of them on the rim, has 2 n - 2 - h facets
    along = np.sort(rng.uniform(0.02, 0.98, rim - 4)) * 2.0 * (length + width)
    corner = np.array([(0, 0), (length, 0), (length, width), (0, width)], float)
    plan = np.concatenate([corner, _on_rim(along, length, width), _scattered(rng, inner, length, width)])
    face = Delaunay(plan).simplices.astype(np.int64)
    x, y = plan[:, 0] - length / 2, plan[:, 1] - width / 2
    z = 20.0 + 9.0 * np.sin(x / 17.0 + 0.4) * np.cos(y / 21.0) + 5.0 * np.cos(x / 31.0 - y / 25.0) - 0.003 * (x * x + y * y)
    return _upward(np.column_stack([x, y, z]), face)


PARTS: dict[str, Callable[[], Solid]] = {
    "dome": dome,
    "blade": blade,
    "saddle": saddle,
    "half_cylinder": half_cylinder,
    "freeform_233": freeform_233,
}


def _loft(loops: list[NDArray[np.float64]], top: tuple[float, ...], foot: tuple[float, ...]) -> Solid:
    """Closed loops joined by quads cut in two, the first and the last closed by fans to ``top`` and ``foot``."""
    n, count = len(loops[0]), len(loops)
    vertex = np.concatenate([*loops, [top, foot]])
    here = np.arange(n)
    after = np.roll(here, -1)
    rows = np.arange(count - 1)[:, None] * n
    a, b, c, d = (r.ravel() for r in (rows + here, rows + after, rows + n + after, rows + n + here))
    last = (count - 1) * n
    fans = [
        np.column_stack([here, after, np.full(n, len(vertex) - 2)]),
        np.column_stack([after, here, np.full(n, len(vertex) - 1)]),
    ]
    fans[1][:, :2] += last
    face = np.concatenate([np.column_stack([a, d, c]), np.column_stack([a, c, b]), *fans])
    return _outward(vertex, face)


def _square(length: float, width: float, nx: int, ny: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    x, y = np.meshgrid(np.linspace(-length / 2, length / 2, nx + 1), np.linspace(-width / 2, width / 2, ny + 1), indexing="ij")
    return x, y


def _standing(x: NDArray[np.float64], y: NDArray[np.float64], z: NDArray[np.float64]) -> Solid:
    """A grid of points as the top of a solid that stands on z = 0 with vertical walls."""
    top = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
    number = np.arange(len(top)).reshape(x.shape)
    a, b, c, d = (part.ravel() for part in (number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]))
    rim = np.concatenate([number[:-1, 0], number[-1, :-1], number[:0:-1, -1], number[0, :0:-1]])
    under = len(top) + np.arange(len(rim))
    vertex = np.concatenate([top, top[rim] * (1.0, 1.0, 0.0), [(0.0, 0.0, 0.0)]])
    rim2, under2, centre = np.roll(rim, -1), np.roll(under, -1), np.full(len(rim), len(vertex) - 1)
    cells = [np.column_stack([a, b, c]), np.column_stack([a, c, d])]
    walls = [
        np.column_stack([rim, under, under2]),
        np.column_stack([rim, under2, rim2]),
        np.column_stack([under2, under, centre]),
    ]
    return _outward(vertex, np.concatenate([*cells, *walls]))


def _on_rim(along: NDArray[np.float64], length: float, width: float) -> NDArray[np.float64]:
    """Points at a distance along the rim of a rectangle."""
    stops = np.cumsum([0.0, length, width, length, width])
    x = np.interp(along, stops, [0.0, length, length, 0.0, 0.0])
    y = np.interp(along, stops, [0.0, 0.0, width, width, 0.0])
    return np.column_stack([x, y])


def _scattered(rng: np.random.Generator, count: int, length: float, width: float) -> NDArray[np.float64]:
    """Points inside a rectangle, none too near to another or to the rim."""
    kept: list[NDArray[np.float64]] = []
    while len(kept) < count:
        point = rng.uniform((4.0, 4.0), (length - 4.0, width - 4.0))
        if all(np.hypot(*(point - other)) > 3.2 for other in kept):
            kept.append(point)
    return np.array(kept)


def _upward(vertex: NDArray[np.float64], face: NDArray[np.int64]) -> Solid:
    a, b, c = (vertex[face[:, k]] for k in range(3))
    down = np.cross(b - a, c - a)[:, 2] < 0.0
    return vertex, np.where(down[:, None], face[:, ::-1], face)


def _outward(vertex: NDArray[np.float64], face: NDArray[np.int64]) -> Solid:
    a, b, c = (vertex[face[:, k]] for k in range(3))
    volume = float(np.einsum("ij,ij->", a, np.cross(b, c)))
    return vertex, face[:, ::-1].copy() if volume < 0.0 else face


def main(folder: str) -> None:
    """Write every part into the folder."""
    Path(folder).mkdir(parents=True, exist_ok=True)
    for name, make in PARTS.items():
        mesh = from_faces(*make())
        write_stl(mesh, Path(folder) / f"{name}.stl")
        print(f"{name}.stl: {len(mesh.face)} facets, {np.ptp(mesh.vertex, axis=0).round(1).tolist()} mm")
        for finding in mesh.findings:
            print(f"  {finding.text}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: make_parts.py FOLDER")
    main(sys.argv[1])
