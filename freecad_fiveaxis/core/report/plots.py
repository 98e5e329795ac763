# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a finished program that a machinist would look at, as SVG. Needs matplotlib; without it there are
none.

near     shaded: the blocks near the pole (singular blocks).
thinned  a program of millions of blocks is drawn by the largest and least value of each of BINS stretches:
         the worst block is always among them.

Figures are objects of their own (no pyplot, no global state), and the same input gives the same bytes.
"""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.motion.program import Program

from .figures import Figures, axis_rates
from .plot_style import BINS, BLUE, FLOOR, GREEN, GREY, ORANGE, RED, SKY, STYLE, WIDE, PlotText, spans, thin
from .views import sphere, worst_block


@dataclass(frozen=True)
class Plot:
    """One picture: ``alt`` says in words what it shows to those who cannot see it."""

    name: str
    title: str
    caption: str
    alt: str
    svg: bytes


def plots(figures: Figures, progress: Progress = silent) -> tuple[Plot, ...]:
    """All plots that this program has something to show in; none where matplotlib is missing or no block is
    at feed."""
    try:
        import matplotlib
        from matplotlib.figure import Figure
    except ImportError:
        return ()
    pictures: list[Plot] = []
    if not len(figures.feeds):
        return ()
    drawn: tuple[Callable[[Any, Figures], PlotText | None], ...] = (
        _along,
        worst_block,
        _angles,
        sphere,
        _rates,
    )
    for at, draw in enumerate(drawn):
        progress("plots", at / len(drawn))
        with matplotlib.rc_context(STYLE):
            figure = Figure(figsize=(WIDE, 3.6), layout="constrained")
            texts = draw(figure, figures)
            if texts:
                pictures.append(Plot(*texts, _svg(figure)))
    return tuple(pictures)


def _svg(figure: Any) -> bytes:
    out = io.BytesIO()
    nothing = dict.fromkeys(("Date", "Creator", "Format", "Type"))
    figure.savefig(out, format="svg", metadata=nothing)
    return out.getvalue()


def _shade(axes: Any, figures: Figures, x: Floats) -> None:
    near = np.zeros(len(x), bool)
    near[figures.feeds] = figures.singularity.singular[figures.feeds]
    bars, whole = spans(near, x), axes.get_xaxis_transform()
    if bars:
        axes.broken_barh(
            bars, (0, 1), transform=whole, color=ORANGE, alpha=0.3, lw=0, zorder=2.5, label="near the pole"
        )


def _abscissa(program: Program) -> Floats:
    """Return the NC line of each block, or its row where loops and subprograms come back to lines."""
    line = program.line.astype(float)
    return line if (np.diff(line) >= 0.0).all() else np.arange(len(line), dtype=float)


def _lines(axes: Any, program: Program, x: Floats) -> None:
    axes.set_xlabel("NC line" if np.array_equal(x, program.line) else "block")
    axes.set_xlim(x[0] - 0.5, x[-1] + 0.5)
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.xaxis.set_major_formatter("{x:.0f}")


def _steps(x: Floats, rows: Ints, values: Floats) -> tuple[Floats, Floats]:
    """Return what draws ``values`` (n,) of the blocks ``rows`` (n,) as steps that end at each block's
    line."""
    shown = thin(values, least=False)
    return np.append(x[rows[0] - 1], x[rows[shown]]), np.append(values[0], values[shown])


def _legend(axes: Any, columns: int = 6) -> None:
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(
        handles, labels, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=min(len(labels), columns),
        borderaxespad=0.2,
        handlelength=1.4, columnspacing=1.2,
    )  # fmt: skip


def _along(figure: Any, figures: Figures) -> PlotText:
    axes, deviation, x, rows = figure.subplots(), figures.judged, _abscissa(figures.program), figures.feeds
    segment, bound = np.maximum(deviation.segment[rows], FLOOR), np.maximum(deviation.bound[rows], FLOOR)
    _shade(axes, figures, x)
    axes.fill_between(
        *_steps(x, rows, bound), FLOOR, step="pre", color=SKY, alpha=0.45, lw=0, label="proven bound"
    )
    axes.plot(*_steps(x, rows, segment), color=BLUE, lw=0.9, drawstyle="steps-pre", label="deviation")
    over = np.flatnonzero(~(segment <= figures.tolerance))
    over = over[thin(segment[over], BINS // 4, least=False)]
    if len(over):
        axes.plot(x[rows[over]], segment[over], ".", color=RED, ms=5, label="over tolerance")
    axes.axhline(figures.tolerance, color=RED, ls="--", lw=1.1, label=f"tolerance {figures.tolerance:g} mm")
    top = max(float(bound.max()), figures.tolerance)
    axes.set(yscale="log", ylabel="deviation from the segment, mm")
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_formatter("")
    axes.set_ylim(max(FLOOR, min(figures.tolerance, top) * 1e-3), top * 3.0)
    _lines(axes, figures.program, x)
    _legend(axes)
    alt = (
        f"Deviation of each feed block against the NC line, logarithmic; tolerance {figures.tolerance:g} mm."
    )
    if len(figures.worst):  # none where the controller guides the tip in every block
        peak = figures.worst[0]
        alt += f" Largest {deviation.segment[peak]:.4g} mm at NC line {figures.program.line[peak]}."
    whose = "the tool tip" if figures.surface is None else "the ball's centre, which makes the surface,"
    caption = (
        f"One step for each feed block: how far {whose} leaves the straight segment that the program "
        "commands. Nothing leaves it by more than the proven bound. Rapids are left out."
    )
    return "along", "Deviation along the program", caption, alt


def _angles(figure: Any, figures: Figures) -> PlotText | None:
    program, x = figures.program, _abscissa(figures.program)
    turning = find_physical_columns(program.letters)[3:]
    if not turning:
        return None
    figure.set_size_inches(WIDE, 4.2)
    panels = figure.subplots(len(turning), 1, sharex=True, squeeze=False)[:, 0]
    phrases = []
    for axes, column, colour in zip(panels, turning, (BLUE, GREEN), strict=False):
        words, letter = program.words[:, column], program.letters[column]
        shown = thin(words)
        _shade(axes, figures, x)
        axes.plot(x[shown], words[shown], color=colour)
        _limits(axes, figures, column)
        axes.set_ylabel(f"{letter}, deg")
        phrases.append(f"{letter} runs from {words.min():.1f} to {words.max():.1f} deg")
    _lines(panels[-1], program, x)
    if panels[0].get_legend_handles_labels()[1]:
        _legend(panels[0])
    caption = (
        "The words as the controller gets them, full turns counted on. Where the tool comes near the pole, "
        f"{program.letters[3]} turns far within a few lines."
    )
    return "angles", "Rotary axes along the program", caption, "; ".join(phrases) + "."


def _limits(axes: Any, figures: Figures, column: int) -> None:
    """Draw the axis limits where the words come near them: far limits would flatten the curve."""
    low, high = axes.get_ylim()
    room = 0.25 * (high - low)
    for limit in np.degrees([figures.kinematics.low[column], figures.kinematics.high[column]]):
        if low - room < limit < high + room:
            axes.axhline(limit, color=RED, ls="--", lw=1.0, label="limit of the axis")


def _rates(figure: Any, figures: Figures) -> PlotText | None:
    program, x, rows = figures.program, _abscissa(figures.program), figures.feeds
    limit = figures.kinematics.rate * (1.0, 1.0, 1.0, *np.degrees([1.0, 1.0]))
    share = 100.0 * axis_rates(program)[rows] / limit
    if not share.any():
        return None
    axes, phrases = figure.subplots(), []
    _shade(axes, figures, x)
    for column, colour in zip(range(5), (SKY, GREY, "#111111", BLUE, GREEN), strict=True):
        peak = float(share[:, column].max())
        if peak > 0.0:
            shown = thin(share[:, column], BINS // 6, least=False)
            label = f"{program.letters[column]} {peak:.0f} %"
            axes.plot(
                x[rows[shown]], share[shown, column], color=colour, lw=1.2 if column > 2 else 0.8, label=label
            )
            phrases.append(f"{program.letters[column]} {peak:.0f} %")
    axes.axhline(100.0, color=RED, ls="--", lw=1.1)
    axes.set(ylabel="share of the axis's maximum rate, %", ylim=(0.0, max(108.0, 1.05 * float(share.max()))))
    _lines(axes, figures.program, x)
    _legend(axes)
    caption = (
        "Largest share in each stretch. At 100 % an axis runs as fast as it can, and the tool goes slower "
        "over the part than programmed."
    )
    return (
        "rates",
        "How busy each axis is",
        caption,
        "Peak share of each axis's maximum rate: " + ", ".join(phrases) + ".",
    )
