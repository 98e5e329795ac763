# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures of docs/lin-ye.md. Numbers come from the other modules of this folder; here they are only
drawn."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import lin_ye_arc as arc
import lin_ye_parts as parts
import lin_ye_profiles as profiles
import matplotlib
import numpy as np

from freecad_fiveaxis.core.motion.deviation import lin_ye_deviation
from freecad_fiveaxis.core.motion.trajectory import tip_at
from freecad_fiveaxis.core.report.plot_style import BLUE, GREEN, GREY, ORANGE, RED, STYLE, WIDE

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm
from matplotlib.ticker import MaxNLocator

COLOUR = {"facet_mean": BLUE, "step_weighted": ORANGE}
DPI = 95
ROOM = 1.45
"""Height of a panel in largest values: the legend needs room."""


def draw_all(folder: Path) -> list[str]:
    """Draw every picture into ``folder``; returns their names."""
    folder.mkdir(parents=True, exist_ok=True)
    result = []
    with plt.rc_context(STYLE):
        for name, draw in PICTURES.items():
            figure = draw()
            figure.savefig(folder / f"lin-ye-{name}.png", dpi=DPI, metadata={"Software": None})
            plt.close(figure)
            result.append(f"lin-ye-{name}.png")
    return result


def half_circle() -> Any:
    """Figs. 10 and 11: the half circle with the real path, and the deviation along it."""
    psi = arc.half_circle(np.radians(20))
    kinematics, radius = arc.trunnion(arc.PAPER_R0), arc.ARC + arc.BALL
    words, u = arc.arc_words(kinematics, radius, psi), np.linspace(0.0, 1.0, arc.SAMPLES)
    real = tip_at(kinematics, words[:-1], words[1:], np.broadcast_to(u, (len(psi) - 1, arc.SAMPLES))).reshape(
        -1, 3
    )
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDE, 3.3), layout="constrained")
    fine = np.linspace(0.0, np.pi, 500)
    left.plot(radius * np.cos(fine), radius * np.sin(fine), color=GREEN, label="arc that is wanted")
    left.plot(real[:, 1], real[:, 2], color=BLUE, label="real path of the ball's centre")
    left.plot(radius * np.cos(psi), radius * np.sin(psi), "o", color=GREY, markersize=4, label="block ends")
    left.set(aspect="equal", xlabel="Y, mm", ylabel="Z, mm", title="Half circle, 20 deg steps", ylim=(-5, 75))
    left.legend(loc="lower center")
    angle = (psi[:-1, None] + u * np.diff(psi)[:, None]).ravel()
    off = arc.off_the_arc(kinematics, radius, psi).ravel()
    right.plot(np.degrees(angle), off, color=BLUE)
    worst = int(np.argmin(off))
    right.annotate(
        f"{-off[worst]:.2f} mm overcut at {np.degrees(angle[worst]):.0f} deg",
        (np.degrees(angle[worst]), off[worst]),
        (0, -14), textcoords="offset points", ha="center",
    )  # fmt: skip
    right.axhline(0.0, color=GREEN)
    right.set(
        xlabel="place on the circle, deg",
        ylabel="off the arc, mm (negative: overcut)",
        title="Deviation along it",
        ylim=(-3.2, 0.3),
    )
    right.set_xticks(np.arange(0, 181, 30))
    return figure


def steps() -> Any:
    """Fig. 12: deviation by R0 and step angle; lines are eq. (6), dots are measured."""
    figure, axes = plt.subplots(figsize=(WIDE * 0.6, 3.2), layout="constrained")
    distance = np.linspace(0.0, 300.0, 13)
    for step, colour in ((5, GREEN), (10, BLUE), (15, ORANGE), (20, RED)):
        axes.plot(distance, lin_ye_deviation(distance, np.radians(step)), color=colour, label=f"{step} deg")
        axes.plot(distance, [arc.shift_measured(d, np.radians(step)) for d in distance], ".", color=colour)
    axes.plot(
        [arc.PAPER_R0],
        [arc.shift_measured(arc.PAPER_R0, np.radians(20))],
        "o",
        mfc="none",
        color="black",
        label="the paper's 2.7 mm",
    )
    axes.set(
        xlabel="R0, from the rotary axis to the arc's centre, mm",
        ylabel="deviation, mm",
        title="Lines: eq. (6). Dots: measured",
    )
    axes.legend()
    return figure


def height() -> Any:
    """Arcs: medians of both methods' largest deviation, by the height above the rotary axis in radii."""
    radii = np.linspace(0.0, 4.0, 25)
    worst = np.array([np.median(profiles.largest_on_arcs(h), axis=0) for h in radii])
    figure, axes = plt.subplots(figsize=(WIDE * 0.6, 3.2), layout="constrained")
    for number, method in enumerate(profiles.METHODS):
        axes.plot(radii, worst[:, number], color=COLOUR[method], label=method)
    axes.set(
        xlabel="height above the rotary axis, in radii of curvature", ylabel="largest deviation, mm",
        title=f"Arcs of uneven steps: medians of {profiles.PROFILES}", ylim=(0, None), xlim=(0, 4),
    )  # fmt: skip
    axes.legend()
    return figure


def second_pass() -> Any:
    """Fig. 18: deviation along the second pass, for each depth of the rotary axes."""
    figure, axes = plt.subplots(2, 2, figsize=(WIDE, 4.8), layout="constrained", sharex=True)
    for panel, below in zip(axes.flat, profiles.DEPTHS, strict=True):
        most = 0.0
        for method in profiles.METHODS:
            cuts = parts.mill(parts.PART, "table_ab", method, below)
            way, deviation = (
                np.concatenate([[0.0], column[cuts.pass_ == 2]]) for column in (cuts.along, cuts.deviation)
            )
            label = f"{method}, largest {deviation.max():.3f} mm"
            panel.plot(
                way, deviation, color=COLOUR[method], drawstyle="steps-pre", linewidth=1.0, label=label
            )
            most = max(most, deviation.max())
        panel.set(title=f"axes {profiles.depth_name(below)}", ylim=(0.0, ROOM * most))
        panel.legend(loc="upper center")
    for panel in axes[1]:
        panel.set_xlabel("way along the second pass, mm")
    for panel in axes[:, 0]:
        panel.set_ylabel("deviation, mm")
    return figure


def whole_part() -> Any:
    """Figs. 19 to 21: deviation over the whole part by either method, and both by passes."""
    figure, axes = plt.subplots(2, 3, figsize=(WIDE * 1.2, 4.8), layout="constrained", width_ratios=(1, 1, 1))
    for row, below in zip(axes, (None, 150.0), strict=True):
        result = {method: parts.mill(parts.PART, "table_ab", method, below) for method in profiles.METHODS}
        most = max(cuts.deviation.max() for cuts in result.values())
        for panel, (method, cuts) in zip(row, result.items(), strict=False):
            lines = _blocks(cuts, LogNorm(parts.LEAST, most))
            panel.add_collection(lines)
            panel.autoscale()
            panel.set(
                aspect="equal",
                title=f"{method},\naxes {profiles.depth_name(below)}",
                xlabel="X, mm",
                ylabel="Y, mm",
            )
            panel.grid(False)
            row[2].plot(
                np.arange(len(cuts.per_pass)) + 1, cuts.per_pass, ".-", color=COLOUR[method],
                label=f"{method}, largest {cuts.deviation.max():.3f} mm",
            )  # fmt: skip
        figure.colorbar(lines, ax=list(row[:2]), label="deviation, mm", shrink=0.9, location="left")
        row[2].set(
            xlabel="pass", ylabel="largest deviation, mm",
            title=f"both, by passes,\naxes {profiles.depth_name(below)}",
            ylim=(0.0, ROOM * most),
        )  # fmt: skip
        row[2].xaxis.set_major_locator(MaxNLocator(integer=True))
        row[2].legend(loc="upper center", fontsize=7.5)
    for panel in axes.flat:
        panel.title.set_size(9)
    return figure


def _blocks(cuts: parts.Cuts, scale: LogNorm) -> LineCollection:
    """Each block as a line seen from above, coloured by its deviation."""
    ends = np.stack([cuts.start[:, :2], cuts.end[:, :2]], axis=1)
    return LineCollection(
        ends, array=np.maximum(cuts.deviation, parts.LEAST), cmap="viridis_r", norm=scale, linewidths=3.0
    )


PICTURES = {
    "half-circle": half_circle,
    "steps": steps,
    "height": height,
    "pass-2": second_pass,
    "part": whole_part,
}
