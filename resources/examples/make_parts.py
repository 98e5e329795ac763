# SPDX-License-Identifier: LGPL-2.1-or-later
"""Example parts, made by formula: ``python resources/examples/make_parts.py FOLDER`` writes them as STL
files.

dome           spherical cap R 40 on a round plinth; its top is the pole of every machine with an upright
               rotary axis.
blade          thin twisted blade of lens section, lying, to be milled from above.
saddle         block with a hyperbolic paraboloid on top: convex one way, concave the other.
half_cylinder  lying half cylinder, R 60 in Lin & Ye's Fig. 10.
freeform_233   wavy open patch of 233 facets of uneven size, after Lin & Ye's Fig. 16 (that part itself was
               never published).

Each function returns ``vertex`` (v, 3) mm and ``face`` (f, 3), counter-clockwise seen from outside. The
solids stand on z = 0 about the z axis; freeform_233 is open, for an odd number of facets cannot close.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Part = tuple[NDArray[np.float64], NDArray[np.int64]]


def dome(
    radius: float = 40.0, half_angle: float = 60.0, plinth: float = 10.0, rings: int = 60, sectors: int = 180
) -> Part:
    """Cap of ``half_angle`` deg about +Z with a vertex at the pole, on a cylinder ``plinth`` mm high."""
    tilt = np.radians(half_angle) * np.arange(1, rings + 1) / rings
    reach, height = radius * np.sin(tilt), radius * (np.cos(tilt) - np.cos(tilt[-1])) + plinth
    reach, height = np.append(reach, reach[-1]), np.append(height, 0.0)
    turn = 2.0 * np.pi * np.arange(sectors) / sectors
    x, y, z = np.outer(reach, np.cos(turn)), np.outer(reach, np.sin(turn)), np.outer(height, np.ones(sectors))
    pole = (0.0, 0.0, radius * (1.0 - np.cos(tilt[-1])) + plinth)
    vertex = np.concatenate([[pole, (0.0, 0.0, 0.0)], np.stack([x, y, z], axis=-1).reshape(-1, 3)])
    ring = 2 + np.arange((rings + 1) * sectors).reshape(rings + 1, sectors)
    upper, lower = ring[0], ring[-1]
    top = np.stack([np.zeros_like(upper), upper, np.roll(upper, -1)], axis=1)
    bottom = np.stack([np.ones_like(lower), np.roll(lower, -1), lower], axis=1)
    wall = _quads(ring[:-1], ring[1:], np.roll(ring, -1, axis=1)[1:], np.roll(ring, -1, axis=1)[:-1])
    return vertex, np.concatenate([top, wall, bottom])


def blade(length: float = 100.0, stations: int = 80, points: int = 40) -> Part:
    """Lens sections along X: chord 44 to 28 mm, thickness 7 to 3 mm, twisted from -15 to 20 deg about X."""
    share = np.linspace(0.0, 1.0, stations + 1)[:, None]
    chord, thick, twist = 44.0 - 16.0 * share, 7.0 - 4.0 * share, np.radians(-15.0 + 35.0 * share)
    over = np.linspace(1.0, -1.0, points + 1)  # +y to -y over the upper side, and back below
    across = np.concatenate([over, -over[1:-1]])
    side = np.concatenate([np.ones(points + 1), -np.ones(points - 1)])
    y, z = 0.5 * chord * across, 0.5 * thick * side * (1.0 - across**2)
    y, z = y * np.cos(twist) - z * np.sin(twist), y * np.sin(twist) + z * np.cos(twist)
    x = np.broadcast_to(length * (share - 0.5), y.shape)
    vertex = np.stack([x, y, z - z.min()], axis=-1).reshape(-1, 3)
    row = np.arange(len(vertex)).reshape(y.shape)
    skin = _quads(np.roll(row, -1, axis=1)[:-1], np.roll(row, -1, axis=1)[1:], row[1:], row[:-1])
    return vertex, np.concatenate([skin, _lens_cap(row[0], points)[:, ::-1], _lens_cap(row[-1], points)])


def _lens_cap(ring: NDArray[np.int64], points: int) -> NDArray[np.int64]:
    """Facets across one end section, upper points joined to the lower ones below them."""
    upper = ring[: points + 1]
    lower = np.append(ring[points:], ring[0])[::-1]  # both from +y to -y; the two ends are shared
    faces = _quads(upper[:-1], upper[1:], lower[1:], lower[:-1])
    corners = np.sort(faces, axis=1)
    return faces[(corners[:, 1:] != corners[:, :-1]).all(axis=1)]


def saddle(
    length: float = 80.0, width: float = 60.0, base: float = 20.0, bend: float = 160.0, cells: int = 80
) -> Part:
    """Block with the top ``z = base + (x^2 - y^2) / bend``, mm."""
    x, y = np.linspace(-0.5, 0.5, cells + 1) * length, np.linspace(-0.5, 0.5, cells + 1) * width
    x, y = np.meshgrid(x, y, indexing="ij")
    return _block(x, y, base + (x**2 - y**2) / bend)


def half_cylinder(radius: float = 60.0, length: float = 80.0, facets: int = 180) -> Part:
    """Half cylinder along X on its flat side; ``facets`` strips of two facets over the half circle."""
    turn = np.pi * np.arange(facets + 1) / facets
    y, z = radius * np.cos(turn), radius * np.sin(turn)
    z[[0, -1]] = 0.0
    ends = [np.column_stack([np.full(facets + 1, x), y, z]) for x in (-0.5 * length, 0.5 * length)]
    near, far = np.arange(facets + 1), np.arange(facets + 1) + facets + 1
    skin = _quads(near[:-1], near[1:], far[1:], far[:-1])
    cap = np.stack([np.zeros(facets - 1, dtype=np.int64), near[1:-1], near[2:]], axis=1)
    floor = _quads(far[:1], far[-1:], near[-1:], near[:1])
    return np.concatenate(ends), np.concatenate([skin, cap[:, ::-1], cap + facets + 1, floor])


def freeform_233() -> Part:
    """Open patch of 100 x 60 x 22 mm: 13 x 8 uneven cells, the 12 largest facets cut in three, one at the
    border in two."""
    rng = np.random.default_rng(233)
    x, y = np.meshgrid(np.linspace(-50.0, 50.0, 14), np.linspace(-30.0, 30.0, 9), indexing="ij")
    x[1:-1] += rng.uniform(-2.2, 2.2, x[1:-1].shape)
    y[:, 1:-1] += rng.uniform(-2.2, 2.2, y[:, 1:-1].shape)
    point = [np.array(p) for p in zip(x.ravel(), y.ravel(), strict=True)]
    row = np.arange(x.size).reshape(x.shape)
    face = _short_diagonals(
        np.array(point),
        row[:-1, :-1].ravel(),
        row[1:, :-1].ravel(),
        row[1:, 1:].ravel(),
        row[:-1, 1:].ravel(),
    )
    for _ in range(12):
        area = _plan_area(np.array(point), face)
        a, b, c = face[np.argmax(area)]
        point.append(np.array([point[a], point[b], point[c]]).mean(axis=0))
        new = len(point) - 1
        face = np.concatenate(
            [np.delete(face, np.argmax(area), axis=0), [[a, b, new], [b, c, new], [c, a, new]]]
        )
    a, b, c = next(
        np.roll(f, -k) for f in face for k in range(3) if set(np.roll(f, -k)[:2]) == {row[6, 0], row[7, 0]}
    )
    point.append(0.5 * (point[a] + point[b]))
    face = face[~(np.sort(face, axis=1) == np.sort([a, b, c])).all(axis=1)]
    face = np.concatenate([face, [[a, len(point) - 1, c], [len(point) - 1, b, c]]])
    flat = np.array(point)
    return np.column_stack([flat, _wave(flat[:, 0], flat[:, 1])]), face


def _wave(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    bump = 11.0 * np.exp(-((x - 18.0) ** 2 + (y + 6.0) ** 2) / 500.0)
    height: NDArray[np.float64] = 12.0 + 6.0 * np.sin(x / 17.0) * np.cos(y / 21.0) + bump - 0.06 * y
    return height


def _block(x: NDArray[np.float64], y: NDArray[np.float64], z: NDArray[np.float64]) -> Part:
    """Return closed block under the grid of heights ``z``, down to z = 0."""
    top = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    row = np.arange(x.size).reshape(x.shape)
    border = np.concatenate(
        [row[:-1, 0], row[-1, :-1], row[:0:-1, -1], row[0, :0:-1]]
    )  # counter-clockwise from above
    below = len(top) + np.arange(len(border))
    foot = top[border] * (1.0, 1.0, 0.0)
    skin = _quads(row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:])
    wall = _quads(border, below, np.roll(below, -1), np.roll(border, -1))
    centre = len(top) + len(border)
    floor = np.stack([np.full(len(border), centre), np.roll(below, -1), below], axis=1)
    return np.concatenate([top, foot, [[0.0, 0.0, 0.0]]]), np.concatenate([skin, wall, floor])


def _quads(
    a: NDArray[np.int64], b: NDArray[np.int64], c: NDArray[np.int64], d: NDArray[np.int64]
) -> NDArray[np.int64]:
    """Two facets for each quadrangle a b c d."""
    a, b, c, d = (corner.ravel() for corner in (a, b, c, d))
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def _short_diagonals(
    point: NDArray[np.float64],
    a: NDArray[np.int64],
    b: NDArray[np.int64],
    c: NDArray[np.int64],
    d: NDArray[np.int64],
) -> NDArray[np.int64]:
    """Two facets for each quadrangle, cut along its shorter diagonal."""
    other = np.linalg.norm(point[b] - point[d], axis=1) < np.linalg.norm(point[a] - point[c], axis=1)
    return np.concatenate(
        [_quads(a[~other], b[~other], c[~other], d[~other]), _quads(b[other], c[other], d[other], a[other])]
    )


def _plan_area(point: NDArray[np.float64], face: NDArray[np.int64]) -> NDArray[np.float64]:
    u, v = point[face[:, 1]] - point[face[:, 0]], point[face[:, 2]] - point[face[:, 0]]
    area: NDArray[np.float64] = 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    return area


PARTS = {part.__name__: part for part in (dome, blade, saddle, half_cylinder, freeform_233)}


def write_parts(folder: Path) -> list[Path]:
    """Write every part into ``folder`` as a binary STL file; the paths written."""
    from freecad_fiveaxis.core.geometry.mesh import from_faces, write_stl

    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for name, part in PARTS.items():
        paths.append(folder / f"{name}.stl")
        write_stl(from_faces(*part()), paths[-1])
    return paths


if __name__ == "__main__":
    sys.path.insert(
        0, str(Path(__file__).resolve().parents[2])
    )  # the package beside this folder, installed or not
    if len(sys.argv) != 2:
        sys.exit("usage: python resources/examples/make_parts.py FOLDER")
    for path in write_parts(Path(sys.argv[1])):
        print(path)
