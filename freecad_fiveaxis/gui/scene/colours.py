# SPDX-License-Identifier: LGPL-2.1-or-later
"""One colour map for deviations.

level   0 to 1, the tolerance at 0.5 (``core.report.drawing``).
calm    the lower half, from the good colour to a deep one. loud: the upper half, from a pale colour to the
        bad one. In both halves darker is more, and at the tolerance the map steps from dark to bright: order
        and step are seen without seeing the hue. Colours are mixed in Oklab, where even steps look even.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats

Colour = tuple[float, float, float]

DEEP, PALE = (0.02, 0.13, 0.24), (1.0, 0.87, 0.42)
"""What the good colour goes to, and the bad one comes from."""
DARK = (0.24, 0.0, 0.08)
"""The largest deviation of a map of setups."""
SHADES = 256

_LMS = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_LAB = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)
"""Oklab (Ottosson, 2020): linear red, green and blue to cones, and their cube roots to lightness and two
hues."""


def ramp(good: Colour, bad: Colour) -> Floats:
    """Return the colours (SHADES, 3) of even levels from 0 to 1."""
    half = np.linspace(0.0, 1.0, SHADES // 2)[:, None]
    deep, pale = _mix_colours(good, DEEP, 0.75), _mix_colours(bad, PALE, 0.75)
    return np.concatenate([_mix_colours(good, deep, half), _mix_colours(pale, bad, half)])


def pack_levels(levels: Floats, good: Colour, bad: Colour) -> np.ndarray:
    """0xRRGGBBAA (k,) for levels (k,): at most 0.5 is calm."""
    table = pack_rows(ramp(good, bad))
    half = SHADES // 2
    calm = np.minimum(levels * 2.0 * half, half - 1)
    loud = half + np.minimum((levels - 0.5) * 2.0 * half, half - 1)
    return table[np.where(levels <= 0.5, calm, loud).astype(np.int64)].astype(np.uint32)


def heat(bad: Colour) -> Floats:
    """Return the colours (SHADES, 3) of a map: from the pale colour over the bad one to a dark one, ever
    darker."""
    half = np.linspace(0.0, 1.0, SHADES // 2)[:, None]
    return np.concatenate([_mix_colours(PALE, bad, half), _mix_colours(bad, DARK, half)])


def pack_heat(levels: Floats, bad: Colour) -> np.ndarray:
    """0xRRGGBBAA (k,) for levels (k,) on the ramp :func:`heat`."""
    table = pack_rows(heat(bad))
    return table[np.minimum(levels * SHADES, SHADES - 1).astype(np.int64)].astype(np.uint32)


def pack(colour: Colour) -> int:
    """One colour as 0xRRGGBBAA."""
    red, green, blue = (round(255 * part) for part in colour)
    return red << 24 | green << 16 | blue << 8 | 255


def pack_rows(rgb: Floats) -> np.ndarray:
    """0xRRGGBBAA (k,) of colours (k, 3), 0 to 1."""
    part = np.round(rgb * 255.0).astype(np.uint32)
    return (part[:, 0] << 24 | part[:, 1] << 16 | part[:, 2] << 8 | np.uint32(255)).astype(np.uint32)


def _mix_colours(first: Colour | Floats, second: Colour | Floats, share: float | Floats) -> Floats:
    """Between the two colours in Oklab: ``share`` 0 is the first."""
    lab = _to_lab(np.asarray(first, float)) * (1.0 - share) + _to_lab(np.asarray(second, float)) * share
    linear = np.clip((lab @ np.linalg.inv(_LAB).T) ** 3 @ np.linalg.inv(_LMS).T, 0.0, 1.0)
    return np.asarray(np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055))


def _to_lab(colour: Floats) -> Floats:
    linear = np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)
    return np.asarray(np.cbrt(linear @ _LMS.T) @ _LAB.T)
