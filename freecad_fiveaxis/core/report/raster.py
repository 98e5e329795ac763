# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles as a picture of pixels, and that as a PNG file: no mesh is too fine for it, and what is hidden
stays hidden.

view      three unit rows (3, 3): to the right, up, and towards the eye. The picture is a parallel projection.
owner     of a pixel: the triangle that is seen there, -1 where none is.
"""

from __future__ import annotations

import math
import struct
import zlib

import numpy as np

from freecad_fiveaxis.core.base.records import Bytes, Floats, Ints, number_runs

PIXELS = 1_000_000
"""Pixels that are looked at in one go."""

EDGE = 1e-9
"""So far, as a share of the triangle, a pixel may lie outside: neighbours leave no gap between them."""


def view_from(azimuth: float, elevation: float) -> Floats:
    """Return the view from a direction, rad: azimuth counter-clockwise from X, elevation above the XY plane;
    from above X is right."""
    (ca, sa), (ce, se) = ((math.cos(angle), math.sin(angle)) for angle in (azimuth, elevation))
    return np.array([(-sa, ca, 0.0), (-se * ca, -se * sa, ce), (ce * ca, ce * sa, se)])


def owners(corner: Floats, view: Floats, low: Floats, scale: float, width: int, height: int) -> Ints:
    """Return the owner (height, width) of each pixel, the top row first.

    ``corner`` (k, 3, 3) mm, counter-clockwise seen from outside: those seen from behind are left out. ``low``
    (2,) mm: where the picture's lower left corner is, right and up; ``scale`` pixels a mm.
    """
    seen = (corner @ view.T).transpose(2, 1, 0)  # right, up, towards; corner; triangle
    x, y = (seen[0] - low[0]) * scale, height - (seen[1] - low[1]) * scale
    twice = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (
        y[1] - y[0]
    )  # below 0 where it faces the eye, for y is down
    left, right = _span(x, width)
    top, bottom = _span(y, height)
    count = np.where(twice < -1e-12, (right - left) * (bottom - top), 0)
    near, owner = np.full(width * height, -np.inf), np.full(width * height, -1)
    shown = np.flatnonzero(count > 0)
    for rows in np.split(shown, np.flatnonzero(np.diff(np.cumsum(count[shown]) // PIXELS)) + 1):
        run, part = number_runs(count[rows])
        of = rows[run]
        down, along = np.divmod(part, (right - left)[of])
        px, py = left[of] + along, top[of] + down
        share = [
            ((x[j, of] - px - 0.5) * (y[k, of] - py - 0.5) - (x[k, of] - px - 0.5) * (y[j, of] - py - 0.5))
            / twice[of]
            for j, k in ((1, 2), (2, 0), (0, 1))
        ]
        inside = np.flatnonzero(np.minimum(np.minimum(share[0], share[1]), share[2]) >= -EDGE)
        of, pixel = of[inside], (py * width + px)[inside]
        depth = sum(part[inside] * seen[2, corner_, of] for corner_, part in enumerate(share))
        np.maximum.at(near, pixel, depth)
        first = np.asarray(depth) >= near[pixel]
        owner[pixel[first]] = of[first]
    return owner.reshape(height, width)


def _span(values: Floats, size: int) -> tuple[Ints, Ints]:
    """First pixel and the one after the last whose middles may lie in triangles with these corners (3, k)."""
    first = np.clip(np.ceil(values.min(axis=0) - 0.5 - 1e-6), 0, size).astype(np.int64)
    return first, np.maximum(
        np.clip(np.floor(values.max(axis=0) - 0.5 + 1e-6) + 1, 0, size).astype(np.int64), first
    )


def png(pixel: Bytes) -> bytes:
    """Return a PNG file of pixels (height, width, 3), red green blue, 0 to 255."""
    height, width = pixel.shape[:2]
    rows = np.concatenate(
        [np.zeros((height, 1), np.uint8), pixel.reshape(height, -1)], axis=1
    )  # filter 0 at each row's head
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    parts = ((b"IHDR", head), (b"IDAT", zlib.compress(rows.tobytes(), 9)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in parts
    )
