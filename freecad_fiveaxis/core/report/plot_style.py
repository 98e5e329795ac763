# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the plots look, and how a long program is thinned for them.

thinned  a program of millions of blocks is drawn by the largest and least value of each of BINS stretches:
         the worst block is always among them.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

PlotText = tuple[str, str, str, str]
"""What is said of a plot: name, title, caption, and what it shows in words."""

BINS = 1200
"""Stretches of a thinned plot: about one for every pixel of its width."""
FLOOR = 1e-6
"""mm: smaller deviations are rounding of the arithmetic and are drawn at this height."""
STYLE: dict[Any, Any] = {
    "svg.hashsalt": "freecad-fiveaxis",  # ids in the SVG are then the same every time
    "svg.fonttype": "path",
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e3e3e3",
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "axes.edgecolor": "#666666",
    "axes.formatter.useoffset": False,
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "lines.linewidth": 1.2,
}
BLUE, SKY, ORANGE, RED, GREEN, PURPLE, GREY = (
    "#0072B2",
    "#56B4E9",
    "#E69F00",
    "#C4320A",
    "#007A55",
    "#9B4F96",
    "#777777",
)
"""Okabe and Ito's palette, darkened where text is set in it: told apart by colour-blind readers too."""
WIDE = 8.0
"""Inches: the width of every figure."""


def thin(values: Floats, bins: int = BINS, least: bool = True) -> Ints:
    """Rows, ascending, that draw ``values`` (n,) like all of them.

    The largest of each of ``bins`` stretches, the least too where ``least``, and both ends.
    """
    if len(values) <= 2 * bins:
        return np.arange(len(values))
    edge = np.linspace(0, len(values), bins + 1).astype(np.int64)
    rows = np.minimum(edge[:-1, None] + np.arange(np.diff(edge).max()), edge[1:, None] - 1)
    block, stretch = values[rows], np.arange(bins)
    picks = [rows[stretch, block.argmax(axis=1)]] + ([rows[stretch, block.argmin(axis=1)]] if least else [])
    return np.unique(np.concatenate([*picks, [0, len(values) - 1]]))


def spans(chosen: Bools, x: Floats, bins: int = BINS // 4) -> list[tuple[float, float]]:
    """Left end and width of each run of ``chosen`` blocks (n,) on the axis of ``x`` (n,); runs nearer than a
    bin are one.

    A block spans from the x of the row before it to its own.
    """
    rows = np.flatnonzero(chosen)
    if not len(rows):
        return []
    least = max((x[-1] - x[0]) / bins, 1e-9)
    left, right = x[np.maximum(rows - 1, 0)], x[rows]
    new = np.concatenate([[True], left[1:] - right[:-1] > least])
    starts, ends = left[new], right[np.concatenate([new[1:], [True]])]
    return [(float(a), float(max(b - a, least))) for a, b in zip(starts, ends, strict=True)]
