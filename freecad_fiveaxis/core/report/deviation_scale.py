# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scale that a path's deviations are coloured by: logarithmic, its middle is the tolerance, its end what
is really there.

level   0 to 1. Up to 0.5 is within the tolerance: 0 a hundredth of it or less, 0.5 the tolerance. Above 0.5
        is over it: 1 is the largest deviation of the path. A path within its tolerance has no upper half.
"""

from __future__ import annotations

import math

import numpy as np

from freecad_fiveaxis.core.base.records import Floats

from .figures import Figures

DECADES = 2.0
"""Powers of ten from the lower end of the scale to the tolerance; and to its upper end where no largest
deviation is known."""
APART = 0.08
"""Two marks nearer to each other than this part of the scale could not be read."""
OVER = float(np.nextafter(0.5, 1.0))


def scale_end(figures: Figures) -> float:
    """Where the scale of a program ends, mm: at its largest deviation or at the tolerance, whichever is
    larger. Where a deviation is no number, which counts as the largest, the scale leaves room for it."""
    deviation = figures.judged.segment[figures.feeds]
    known = deviation[np.isfinite(deviation)]
    least = figures.tolerance if len(known) == len(deviation) else figures.tolerance * 10.0**DECADES
    return max(float(known.max(initial=0.0)), least)


def level_of(deviation: Floats, tolerance: float, end: float) -> Floats:
    """Where deviations (k,) mm stand on the scale, 0 to 1; what is over the tolerance is always above 0.5.
    NaN counts as the largest."""
    value = np.nan_to_num(np.asarray(deviation, float), nan=np.inf)
    with np.errstate(divide="ignore"):
        decades = np.log10(value / tolerance)
    upper = math.log10(end / tolerance) if end > tolerance else DECADES
    level = 0.5 + 0.5 * decades / np.where(value > tolerance, upper or DECADES, DECADES)
    return np.asarray(np.where(value > tolerance, np.clip(level, OVER, 1.0), np.clip(level, 0.0, 0.5)))


def scale_marks(tolerance: float, end: float) -> tuple[tuple[float, float], ...]:
    """Return the marks of the scale: level and deviation, mm, lowest first; powers of ten about the
    tolerance, and the end."""
    lower = [(0.5 - 0.5 * power / DECADES, tolerance / 10.0**power) for power in range(int(DECADES), -1, -1)]
    if end <= tolerance:
        return tuple(lower)
    powers = range(1, math.ceil(math.log10(end / tolerance)))
    values = np.array([tolerance * 10.0**power for power in powers])
    upper = zip(level_of(values, tolerance, end).tolist(), values.tolist(), strict=True)
    return (*lower, *((level, value) for level, value in upper if level < 1.0 - APART), (1.0, end))
