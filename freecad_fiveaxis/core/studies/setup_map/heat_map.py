# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a map of setups, as SVG. Needs matplotlib; without it there are none.

slice    the grid cut along two of X, Y, Z through the place nearest to the recommended one, at its turn;
         along one axis only where the grid has no more.
"""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Iterator
from itertools import combinations
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.report.plot_style import BLUE, GREEN, RED, STYLE, WIDE, PlotText
from freecad_fiveaxis.core.report.plots import Plot

from .setups import Kind, SetupMap

LOG_SPREAD = 20.0
"""Deviations that differ by more than this are coloured by their logarithm."""
HATCH, PRESENT = "#b8b8b8", "#000000"
FLOOR = 1e-6
"""mm: what is below is drawn as this where logarithms are taken."""


def heat_maps(chart: SetupMap) -> tuple[Plot, ...]:
    """Return a heat map for each pair of axes along which the grid has places, or a curve; and what the turns
    cost."""
    return tuple(Plot(*words, _svg(figure)) for words, figure in pictures(chart))


def pictures(chart: SetupMap) -> Iterator[tuple[PlotText, Any]]:
    """Yield the pictures as matplotlib's figures, each to be saved before the next is drawn; none without
    matplotlib."""
    try:
        import matplotlib
        from matplotlib.figure import Figure
    except ImportError:
        return
    for draw in _drawings(chart):
        with matplotlib.rc_context(STYLE):
            figure = Figure(figsize=(WIDE, 3.7), layout="constrained")
            yield draw(figure), figure


def _svg(figure: Any) -> bytes:
    out = io.BytesIO()
    figure.savefig(out, format="svg", metadata=dict.fromkeys(("Date", "Creator", "Format", "Type")))
    return out.getvalue()


def _drawings(chart: SetupMap) -> list[Callable[[Any], PlotText]]:
    if not np.isfinite(chart.grid(chart.max_deviation)[_turn_at(chart)]).any():
        return []
    several = [axis for axis in range(3) if chart.region.count[axis] > 1]
    drawn: list[Callable[[Any], PlotText]] = [
        lambda figure, pair=pair: _heat(figure, chart, *pair)  # type: ignore[misc]
        for pair in combinations(several, 2)
    ]
    if len(several) == 1:
        drawn.append(lambda figure: _curve(figure, chart, several[0]))
    if len(chart.region.turns) > 1:
        drawn.append(lambda figure: _turns(figure, chart))
    return drawn


def _choose_shown(chart: SetupMap) -> int:
    """Return the setup that the slices pass: the recommended one, or the present one."""
    return 0 if chart.best is None else chart.best


def _turn_at(chart: SetupMap) -> int:
    return int(np.abs(np.array(chart.region.turns) - chart.turn[_choose_shown(chart)]).argmin())


def _slice_grid(chart: SetupMap, column: Floats | Bools, axes: tuple[int, ...]) -> Floats:
    """Return the grid's values along ``axes`` (ascending), the last axis first, through the place nearest to
    the shown setup."""
    origin, lines = chart.origin[_choose_shown(chart)], chart.region.lines()
    at: list[Any] = [_turn_at(chart)]
    at += [
        slice(None) if axis in axes else int(np.abs(lines[axis] - origin[axis]).argmin())
        for axis in (2, 1, 0)
    ]
    return np.asarray(chart.grid(column)[tuple(at)])


def _where(chart: SetupMap, axes: tuple[int, ...]) -> str:
    """Where the slice lies, in words."""
    origin, lines = chart.origin[_choose_shown(chart)], chart.region.lines()
    held = [
        f"{'XYZ'[axis]} {lines[axis][np.abs(lines[axis] - origin[axis]).argmin()]:g} mm"
        for axis in range(3)
        if axis not in axes
    ]
    turn = chart.region.turns[_turn_at(chart)]
    return " and ".join([*held, f"a turn of {math.degrees(turn):g} deg"])


def _heat(figure: Any, chart: SetupMap, across: int, up: int) -> PlotText:
    from matplotlib.colors import LogNorm

    axes = (across, up)
    deviation, time = (_slice_grid(chart, column, axes) for column in (chart.max_deviation, chart.time))
    outside = ~_slice_grid(chart, chart.able, axes).astype(bool)
    low, high = np.nanmin(deviation), np.nanmax(deviation)
    log = low > 0.0 and high > LOG_SPREAD * low
    left, right = figure.subplots(1, 2)
    norm = LogNorm(max(low, FLOOR), high) if log else None
    _panel(figure, left, chart, axes, deviation, outside, ("largest deviation, mm", "cividis_r", norm))
    _panel(figure, right, chart, axes, time / 60.0, outside, ("time, min", "cividis_r", None))
    names = f"{'XYZ'[across]} and {'XYZ'[up]}"
    caption = (
        f"Each cell is the program as posted with the work zero there, at {_where(chart, axes)}. Star: "
        "recommended; cross: present. Hatched: an axis would leave its limits, the part would reach below "
        "the table, or the tool hit the machine."
    )
    alt = f"Largest deviation over the work zero along {names}: from {low:.4g} to {high:.4g} mm."
    return (
        f"heat-{'xyz'[across]}{'xyz'[up]}",
        f"Deviation and time over the work zero along {names}",
        caption,
        alt,
    )


def _panel(
    figure: Any,
    axes: Any,
    chart: SetupMap,
    pair: tuple[int, int],
    values: Floats,
    outside: Bools,
    look: tuple[str, str, Any],
) -> None:
    lines = chart.region.lines()
    edges = [_edges(lines[axis]) for axis in pair]
    title, colours, norm = look
    drawn = axes.pcolormesh(*edges, np.ma.masked_invalid(values), cmap=colours, norm=norm, rasterized=False)
    axes.add_collection(_hatch_cells(edges[0], edges[1], outside))
    figure.colorbar(drawn, ax=axes, label=title, format="%.4g")
    for row, mark, colour in ((0, "x", PRESENT), (chart.best, "*", RED)):
        if row is not None:
            _mark(axes, chart.origin[row, list(pair)], mark, colour)
    axes.set(xlabel=f"work zero {'XYZ'[pair[0]]}, mm", ylabel=f"work zero {'XYZ'[pair[1]]}, mm")
    axes.grid(False)


def _mark(axes: Any, place: Floats, mark: str, colour: str) -> None:
    """Draw a mark with a white rim, which is seen on dark and light cells."""
    rim = {"mec": "white", "mew": 1.0} if mark == "*" else {"mew": 2.6}
    if mark == "x":
        axes.plot(*place, mark, color="white", ms=11, mew=5.0, zorder=5)
    axes.plot(*place, mark, color=colour, ms=15 if mark == "*" else 10, zorder=6, **rim)


def _hatch_cells(x: Floats, y: Floats, chosen: Bools) -> Any:
    """Return the cells that are ``chosen`` (len(y) - 1, len(x) - 1), hatched."""
    from matplotlib.collections import PolyCollection

    row, column = np.nonzero(chosen)
    corners = [(x[column + i], y[row + j]) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    cells = np.array(corners).transpose(2, 0, 1)
    return PolyCollection(list(cells), facecolors="none", edgecolors=HATCH, hatch="////", linewidths=0.0)


def _edges(line: Floats) -> Floats:
    """Return the borders (n + 1,) of cells about the places (n,) of a grid line."""
    half = 0.5 * (line[1] - line[0])
    return np.append(line - half, line[-1] + half)


def _curve(figure: Any, chart: SetupMap, axis: int) -> PlotText:
    line, letter = chart.region.lines()[axis], "XYZ"[axis]
    deviation, time = (_slice_grid(chart, column, (axis,)) for column in (chart.max_deviation, chart.time))
    left, right = figure.subplots(1, 2)
    for axes, values, label in (
        (left, deviation, "largest deviation, mm"),
        (right, time / 60.0, "time, min"),
    ):
        axes.plot(line, values, "o-", color=BLUE)
        axes.set(xlabel=f"work zero {letter}, mm", ylabel=label)
    outside = ~_slice_grid(chart, chart.able, (axis,)).astype(bool)
    left.plot(
        line[outside],
        deviation[outside],
        "x",
        color=RED,
        ms=9,
        label="beyond limits, below the table or in the machine",
    )
    if chart.best is not None:
        left.plot(
            chart.origin[chart.best, axis],
            chart.max_deviation[chart.best],
            "*",
            color=GREEN,
            ms=12,
            label="recommended",
        )
    left.legend() if left.get_legend_handles_labels()[0] else None
    caption = f"Each dot is the program as posted with the work zero there, at {_where(chart, (axis,))}."
    alt = (
        f"Largest deviation along {letter}: from {np.nanmin(deviation):.4g} to {np.nanmax(deviation):.4g} mm."
    )
    return f"curve-{letter.lower()}", f"Deviation and time over the work zero along {letter}", caption, alt


def _turns(figure: Any, chart: SetupMap) -> PlotText:
    turns = np.degrees(chart.region.turns)
    found = chart.kind != Kind.PRESENT
    least = np.array(
        [_least(chart.max_deviation, found & (chart.turn == turn)) for turn in chart.region.turns]
    )
    travel = np.degrees(
        [_least(chart.rotary_travel, found & (chart.turn == turn)) for turn in chart.region.turns]
    )
    left, right = figure.subplots(1, 2)
    left.plot(turns, least, "o-", color=BLUE)
    left.set(xlabel="turn of the part, deg", ylabel="least largest deviation, mm", ylim=(0.0, None))
    right.plot(turns, travel, "o-", color=BLUE)
    right.set(xlabel="turn of the part, deg", ylabel="rotary travel, deg", ylim=(0.0, None))
    caption = (
        "The best work zero at each turn of the part about Z. A missing dot: no work zero within "
        "the limits was found."
    )
    alt = (
        f"Least deviation over {len(turns)} turns: from {np.nanmin(least):.4g} to {np.nanmax(least):.4g} mm."
    )
    return "turns", "What turning the part brings", caption, alt


def _least(column: Floats, rows: Bools) -> float:
    values = column[rows & np.isfinite(column)]
    return float(values.min()) if len(values) else math.nan
