# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a finished program that a machinist would look at, as SVG. Needs matplotlib; without it there are none.

map      the orientation sphere seen from the pole: distance from the middle is the angle to the pole, in degrees, and the
         direction is that of the tool's lean.
near     shaded: the blocks near the pole (singular blocks).
thinned  a program of millions of blocks is drawn by the largest and least value of each of BINS stretches: the worst
         block is always among them.

Figures are objects of their own (no pyplot, no global state), and the same input gives the same bytes.
"""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from .figures import Figures, axis_rates, inner_words
from .kinematics import forward
from .progress import Progress, silent
from .records import Bools, Floats, Ints

BINS = 1200
"""Stretches of a thinned plot: about one for every pixel of its width."""
FLOOR = 1e-6
"""mm: smaller deviations are rounding of the arithmetic and are drawn at this height."""
STYLE = {
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
BLUE, SKY, ORANGE, RED, GREEN, PURPLE, GREY = "#0072B2", "#56B4E9", "#E69F00", "#C4320A", "#007A55", "#9B4F96", "#777777"
"""Okabe and Ito's palette, darkened where text is set in it: told apart by colour-blind readers too."""
WIDE = 8.0
"""Inches: the width of every figure."""


@dataclass(frozen=True)
class Plot:
    """One picture: ``alt`` says in words what it shows to those who cannot see it."""

    name: str
    title: str
    caption: str
    alt: str
    svg: bytes


def plots(figures: Figures, progress: Progress = silent) -> tuple[Plot, ...]:
    """All plots that this program has something to show in; none where matplotlib is missing or no block is at feed."""
    try:
        import matplotlib
        from matplotlib.figure import Figure
    except ImportError:
        return ()
    made: list[Plot] = []
    if not len(figures.feeds):
        return ()
    drawn: tuple[Callable[[Any, Figures], tuple[str, str, str, str] | None], ...] = (
        _along,
        _worst,
        _angles,
        _sphere,
        _rates,
    )
    for at, draw in enumerate(drawn):
        progress("plots", at / len(drawn))
        with matplotlib.rc_context(STYLE):
            figure = Figure(figsize=(WIDE, 3.6), layout="constrained")
            told = draw(figure, figures)
            if told:
                made.append(Plot(*told, _svg(figure)))
    return tuple(made)


def _svg(figure: Any) -> bytes:
    out = io.BytesIO()
    nothing = dict.fromkeys(("Date", "Creator", "Format", "Type"))
    figure.savefig(out, format="svg", metadata=nothing)
    return out.getvalue()


def thin(values: Floats, bins: int = BINS) -> Ints:
    """Rows, ascending, that draw ``values`` (n,) like all of them: the largest and the least of each of ``bins`` stretches."""
    if len(values) <= 2 * bins:
        return np.arange(len(values))
    edge = np.linspace(0, len(values), bins + 1).astype(np.int64)
    wide = int(np.diff(edge).max())
    rows = np.minimum(edge[:-1, None] + np.arange(wide), edge[1:, None] - 1)
    block = values[rows]
    high, low = (np.take_along_axis(rows, pick(block, axis=1)[:, None], 1)[:, 0] for pick in (np.argmax, np.argmin))
    return np.unique(np.concatenate([high, low, [0, len(values) - 1]]))


def spans(chosen: Bools, x: Floats, bins: int = BINS // 4) -> list[tuple[float, float]]:
    """Left end and width of each run of ``chosen`` blocks (n,) on the axis of ``x`` (n,); runs nearer than a bin are one.

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


def _shade(axes: Any, figures: Figures, x: Floats) -> None:
    near = spans(figures.singularity.singular[figures.feeds], x[figures.feeds])
    if near:
        axes.broken_barh(near, (0, 1), transform=axes.get_xaxis_transform(), color=ORANGE, alpha=0.28, lw=0, label="near the pole")


def _legend(axes: Any) -> None:
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles, labels, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=len(labels), borderaxespad=0.2, handlelength=1.4)


def _along(figure: Any, figures: Figures) -> tuple[str, str, str, str]:
    axes, deviation, x = figure.subplots(), figures.deviation, figures.program.line.astype(float)
    rows = figures.feeds
    segment, bound = np.maximum(deviation.segment[rows], FLOOR), np.maximum(deviation.bound[rows], FLOOR)
    shown, over = thin(bound), np.flatnonzero(~(segment <= figures.tolerance))
    over = over[thin(segment[over], BINS // 4)]
    _shade(axes, figures, x)
    axes.fill_between(x[rows[shown]], FLOOR, bound[shown], color=SKY, alpha=0.45, lw=0, label="proven bound")
    shown = thin(segment)
    axes.plot(x[rows[shown]], segment[shown], color=BLUE, lw=0.9, label="deviation")
    axes.plot(x[rows[over]], segment[over], ".", color=RED, ms=5, label="over tolerance") if len(over) else None
    axes.axhline(figures.tolerance, color=RED, ls="--", lw=1.1, label=f"tolerance {figures.tolerance:g} mm")
    top = max(float(bound.max()), figures.tolerance)
    axes.set(yscale="log", xlabel="NC line", ylabel="deviation from the segment, mm")
    axes.set_ylim(max(FLOOR, min(figures.tolerance, top) * 1e-3), top * 3.0)
    axes.set_xlim(x[rows[0]] - 1.0, x[rows[-1]] + 1.0)
    _legend(axes)
    peak = figures.worst[0]
    alt = (
        f"Deviation of each feed block against the NC line, logarithmic. Largest {deviation.segment[peak]:.4g} mm at NC line "
        f"{figures.program.line[peak]}; tolerance {figures.tolerance:g} mm."
    )
    caption = (
        "Each point is one feed block: how far the tool tip leaves the straight segment that the program commands. Nothing "
        "leaves it by more than the proven bound. Rapids are left out."
    )
    return "along", "Deviation along the program", caption, alt


def _angles(figure: Any, figures: Figures) -> tuple[str, str, str, str]:
    program, x = figures.program, figures.program.line.astype(float)
    figure.set_size_inches(WIDE, 4.2)
    panels = figure.subplots(2, 1, sharex=True)
    said = []
    for axes, column, colour in zip(panels, (3, 4), (BLUE, GREEN), strict=True):
        words, letter = program.words[:, column], program.letters[column]
        shown = thin(words)
        _shade(axes, figures, x)
        axes.plot(x[shown], words[shown], color=colour)
        _limits(axes, figures, column)
        axes.set_ylabel(f"{letter}, deg")
        said.append(f"{letter} runs from {words.min():.1f} to {words.max():.1f} deg")
    panels[1].set_xlabel("NC line")
    panels[1].set_xlim(x[0] - 1.0, x[-1] + 1.0)
    if panels[0].get_legend_handles_labels()[1]:
        _legend(panels[0])
    caption = "The words as the controller gets them, full turns counted on. Near the pole the upper axis turns far in a few lines."
    return "angles", "Rotary axes along the program", caption, "; ".join(said) + "."


def _limits(axes: Any, figures: Figures, column: int) -> None:
    """The axis limits, where the words come near them: far limits would flatten the curve."""
    low, high = axes.get_ylim()
    room = 0.25 * (high - low)
    for limit in np.degrees([figures.links.low[column], figures.links.high[column]]):
        if low - room < limit < high + room:
            axes.axhline(limit, color=RED, ls="--", lw=1.0, label="limit of the axis")


def _rates(figure: Any, figures: Figures) -> tuple[str, str, str, str] | None:
    program, x, rows = figures.program, figures.program.line.astype(float), figures.feeds
    limit = figures.links.rate * (1.0, 1.0, 1.0, *np.degrees([1.0, 1.0]))
    share = 100.0 * axis_rates(program)[rows] / limit
    if not share.any():
        return None
    axes, said = figure.subplots(), []
    _shade(axes, figures, x)
    for column, colour in zip(range(5), (SKY, GREY, "#111111", BLUE, GREEN), strict=True):
        peak = float(share[:, column].max())
        if peak > 0.0:
            shown = thin(share[:, column])
            label = f"{program.letters[column]} (peak {peak:.0f} %)"
            axes.plot(x[rows[shown]], share[shown, column], color=colour, lw=1.2 if column > 2 else 0.8, label=label)
            said.append(f"{program.letters[column]} {peak:.0f} %")
    axes.axhline(100.0, color=RED, ls="--", lw=1.1)
    axes.set(xlabel="NC line", ylabel="share of the axis's maximum rate, %", ylim=(0.0, max(108.0, 1.05 * float(share.max()))))
    axes.set_xlim(x[rows[0]] - 1.0, x[rows[-1]] + 1.0)
    _legend(axes)
    caption = "At 100 % an axis runs as fast as it can, and the tool goes slower over the part than programmed."
    return "rates", "How busy each axis is", caption, "Peak share of each axis's maximum rate: " + ", ".join(said) + "."
