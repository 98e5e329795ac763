# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two views of the tool: the worst block's real curve beside its chord, and the tool axis on the orientation
sphere.

chord   the straight segment that the block commands.
map     the orientation sphere seen from the pole: distance from the middle is the angle to the pole in
        degrees, and the direction is that of the tool's lean.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.ranges import ROUNDING
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.machine.kinematics import Chain, forward

from .figures import Figures, inner_words
from .plot_style import BINS, BLUE, GREEN, GREY, ORANGE, RED, SKY, WIDE, PlotText, thin

SAMPLES = 401
"""Points of the worst block's curve: an even step of u, so that its middle is a point."""
FLAT = 0.04
"""A curve flatter than this share of its length is drawn stretched: at true scale it would be a line."""
SPOT = 1e-6
"""A chord shorter than this share of its curve is a turn on the spot: its direction says nothing."""
RINGS = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 45.0)
"""Degrees between the circles of the map: the least that makes at most four."""
VIEW = (math.radians(-60.0), math.radians(28.0))
"""Azimuth and elevation from which the sphere is seen, about the pole."""


def worst_block(figure: Any, figures: Figures) -> PlotText | None:
    """Return the block of the largest deviation, seen on the plane through the chord in which its curve
    spreads most; None where it does not deviate."""
    row = int(figures.worst[0])
    value, u = float(figures.judged.segment[row]), float(figures.judged.u_segment[row])
    if value < ROUNDING:
        return None
    steps = np.append(np.linspace(0.0, 1.0, SAMPLES), u)
    kinematics, (start, end) = figures.judged.raise_words(
        figures.kinematics, figures.program.words[row - 1 : row + 1]
    )
    curve = _place_real_tip(kinematics, start, end, steps)
    flat, chord = _on_plane(curve)
    spread = np.ptp(flat, axis=0)
    if not spread.max() > 0.0:
        return None
    figure.set_size_inches(WIDE, 4.4)
    side, profile = figure.subplots(1, 2, width_ratios=(1.7, 1.0))
    stretch = _stretch(spread)
    _draw_curve(side, figures, flat, chord, value, stretch)
    _draw_profile(profile, figures, steps[:-1], _to_segment(curve[:-1], curve[0], curve[SAMPLES - 1]), row)
    line = figures.program.line[row]
    scale = "True scale." if stretch == 1.0 else f"Drawn {stretch:g} times too large across the chord."
    whose = "the tip" if figures.surface is None else "the ball's centre"
    caption = (
        f"NC line {line}: the program commands the straight chord, {whose} drives the curve while the axes "
        "move evenly. Dots "
        f"are tenths of the block's time. {scale} Seen on the plane through the chord in which the curve "
        "spreads most."
    )
    alt = (
        f"Real path of {whose} in NC line {line} beside its chord of {chord:.4g} mm; largest distance "
        f"{value:.4g} mm at "
        f"u = {u:.4f}."
    )
    return "worst", f"The worst block: NC line {line}", caption, alt


def _place_real_tip(kinematics: Chain, start: Floats, end: Floats, u: Floats) -> Floats:
    """Return the real tip (k, 3) at the shares ``u`` (k,) of a block whose axes all move evenly."""
    return forward(kinematics, inner_words(start + u[:, None] * (end - start)))[0]


def _on_plane(curve: Floats) -> tuple[Floats, float]:
    """Return the curve (k, 2) in the plane of its chord (along x, from 0) and its widest spread (y), and the
    chord's length."""
    rest = curve - curve[0]
    along = rest[SAMPLES - 1]
    chord = float(np.linalg.norm(along))
    if chord <= SPOT * float(np.abs(rest).max()):  # any two widest directions
        first, second = np.linalg.svd(rest, full_matrices=False)[2][:2]
        return np.column_stack([rest @ first, rest @ second]), chord
    along = along / chord
    across = rest - (rest @ along)[:, None] * along
    second = np.linalg.svd(across, full_matrices=False)[2][0]
    second = second if (across @ second).sum() >= 0.0 else -second
    return np.column_stack([rest @ along, across @ second]), chord


def _stretch(spread: Floats) -> float:
    """1 at true scale; a power of ten for flat curves."""
    share = float(spread[1] / spread[0])
    return 1.0 if share >= FLAT or share == 0.0 else 10.0 ** math.ceil(math.log10(FLAT / share))


def _to_segment(point: Floats, start: Floats, end: Floats) -> Floats:
    along = end - start
    length = float(along @ along)
    foot = np.clip((point - start) @ along / length, 0.0, 1.0) if length > 0.0 else np.zeros(len(point))
    return np.asarray(np.linalg.norm(point - start - foot[:, None] * along, axis=1))


def _draw_curve(
    axes: Any, figures: Figures, flat: Floats, chord: float, value: float, stretch: float
) -> None:
    x, y = flat[:SAMPLES].T
    peak = flat[-1]
    foot = (min(max(float(peak[0]), 0.0), chord), 0.0)
    axes.plot([0.0, chord], [0.0, 0.0], color=GREEN, lw=3.0, solid_capstyle="round", label="commanded chord")
    axes.plot(x, y, color=BLUE, lw=1.6, label="real path")
    axes.plot(x[:: SAMPLES // 10], y[:: SAMPLES // 10], ".", color=BLUE, ms=6)
    axes.plot([peak[0], foot[0]], [peak[1], foot[1]], color=RED, lw=1.3, label=f"{value:.4g} mm off")
    axes.plot(*peak, "o", color=RED, ms=5)
    for name, at in (("start", 0.0), ("end", chord)):
        axes.plot(at, 0.0, "s", color=GREEN, ms=6)
        axes.annotate(
            name, (at, 0.0), (0, -7), textcoords="offset points", ha="center", va="top", color=GREEN
        )
    axes.set_aspect(stretch, adjustable="datalim")
    axes.margins(0.12)
    times = "" if stretch == 1.0 else f" (drawn {stretch:g} times too large)"
    axes.set(xlabel="along the chord, mm", ylabel=f"across, mm{times}")
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=3, borderaxespad=0.2, handlelength=1.4)


def _draw_profile(axes: Any, figures: Figures, u: Floats, off: Floats, row: int) -> None:
    axes.plot(u, off, color=BLUE)
    axes.axhline(figures.judged.bound[row], color=SKY, lw=1.5, label="proven bound")
    axes.axhline(figures.tolerance, color=RED, ls="--", lw=1.1, label="tolerance")
    axes.set(xlabel="u, share of the block's time", ylabel="distance from the chord, mm", xlim=(0.0, 1.0))
    axes.set_ylim(0.0, 1.12 * max(float(figures.judged.bound[row]), figures.tolerance, 1e-9))
    axes.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=2, borderaxespad=0.2, handlelength=1.4)


def sphere(figure: Any, figures: Figures) -> PlotText | None:
    """Return the tool axis over the whole program: as a map seen from the pole, and on the sphere; None where
    the tool cannot turn."""
    if not find_physical_columns(figures.program.letters)[3:]:
        return None
    pole, first, second = _frame(figures)
    paths = _axis_paths(figures)
    local = paths @ np.column_stack([first, second, pole])
    cone = figures.machine.singular_cone
    near = figures.feeds[figures.singularity.singular[figures.feeds]]
    spots = figures.axis[near[thin(near.astype(float), BINS // 4)]] @ np.column_stack([first, second, pole])
    figure.set_size_inches(WIDE, 4.2)
    figure.set_layout_engine("none")
    _draw_map(figure.add_axes((0.055, 0.07, 0.43, 0.86), projection="polar"), local, spots, cone)
    figure.axes[0].set_thetagrids(
        (0, 90, 180, 270), [_name_direction(way) for way in (first, second, -first, -second)]
    )
    _draw_sphere(figure.add_axes((0.535, 0.02, 0.45, 0.96)), local, spots, cone, figures.program.letters[3])
    tilt = np.degrees(np.arccos(np.clip(local[:, 2], -1.0, 1.0)))
    letter, low, high = figures.program.letters[3], float(np.nanmin(tilt)), float(np.nanmax(tilt))
    caption = (
        f"The pole is the direction of the {letter} axis. In the shaded cone of {math.degrees(cone):g} deg "
        f"around it {letter} "
        "must turn far to lean the tool a little: a path round the cone is calm, a path across it is not. "
        "Red: the blocks near "
        "the pole. Left, the map seen from the pole, in degrees from it; right, the same on the sphere."
    )
    alt = (
        f"Tool axis on the orientation sphere: between {low:.2f} and {high:.1f} deg from the pole; "
        f"{len(near)} blocks near the "
        f"pole, where the shaded cone has a half angle of {math.degrees(cone):g} deg."
    )
    return "sphere", "Where the tool points", caption, alt


def _frame(figures: Figures) -> tuple[Floats, Floats, Floats]:
    """Return the pole (that end of the first rotary axis which the tool is nearer to) and two directions
    across it, unit."""
    pole = figures.kinematics.direction[3]
    pole = pole if float((figures.axis @ pole).sum()) >= 0.0 else -pole
    guide = np.eye(3)[int(np.argmin(np.abs(pole)))] if abs(pole[0]) > 0.9 else np.array((1.0, 0.0, 0.0))
    first = guide - (guide @ pole) * pole
    first = first / np.linalg.norm(first)
    return pole, first, np.cross(pole, first)


def _name_direction(way: Floats) -> str:
    """Return a direction of the work frame, as "X+"; empty where it is none of the six."""
    at = int(np.abs(way).argmax())
    return "XYZ"[at] + ("+" if way[at] > 0.0 else "−") if abs(way[at]) > 1.0 - 1e-9 else ""


def _axis_paths(figures: Figures) -> Floats:
    """Return the tool axis along the feed blocks (k, 3); a NaN row ends each run.

    A short program is drawn with the real axis inside each block; a long one by an even choice of block ends,
    and inside its blocks nearest to the pole.
    """
    rows = figures.feeds
    if len(rows) <= 4 * BINS:
        return _inside_blocks(figures, rows)
    near = rows[figures.singularity.singular[rows]]
    least = near[np.argsort(figures.singularity.least_sine[near], kind="stable")[:BINS]]
    even = rows[np.linspace(0, len(rows) - 1, 6 * BINS).astype(np.int64)]
    return np.concatenate([_through_ends(figures, even), _inside_blocks(figures, np.sort(least))])


def _inside_blocks(figures: Figures, rows: Ints) -> Floats:
    u = np.linspace(0.0, 1.0, 1 + max(1, min(16, 8 * BINS // max(len(rows), 1))))
    start, end = figures.program.words[rows - 1], figures.program.words[rows]
    words = start[:, None] + u[None, :, None] * (end - start)[:, None]
    axis = forward(figures.kinematics, inner_words(words.reshape(-1, 5)))[1].reshape(len(rows), len(u), 3)
    return np.concatenate([axis, np.full((len(rows), 1, 3), np.nan)], axis=1).reshape(-1, 3)


def _through_ends(figures: Figures, rows: Ints) -> Floats:
    """Return the axes at the ends of the blocks ``rows``, joined where no rapid lies between them."""
    off = np.ones(len(figures.program.words), np.int64)
    off[figures.feeds] = 0
    breaks = np.flatnonzero(np.diff(np.cumsum(off)[rows])) + 1
    return np.insert(figures.axis[rows], breaks, np.nan, axis=0)


def _draw_map(axes: Any, path: Floats, spots: Floats, cone: float) -> None:
    """Distance from the middle: the angle to the pole, deg; direction: that of the lean."""
    round_ = np.linspace(0.0, 2.0 * np.pi, 181)
    axes.fill(round_, np.full(181, np.degrees(cone)), color=ORANGE, alpha=0.28, lw=0)
    axes.plot(round_, np.full(181, np.degrees(cone)), color=ORANGE, lw=1.0)
    axes.plot(*_polar(path), color=BLUE, lw=0.8)
    axes.plot(*_polar(spots), ".", color=RED, ms=4)
    reach = float(np.nanmax(_polar(path)[1], initial=0.0))
    reach = min(180.0, 1.08 * max(reach, 1.6 * np.degrees(cone)))
    ring = next((step for step in RINGS if 4.0 * step >= reach), RINGS[-1])
    axes.set_rgrids(np.arange(ring, reach, ring), angle=67.5, fmt="%g°")
    axes.set_rlim(0.0, reach)
    for label in axes.yaxis.get_ticklabels():
        label.set(fontsize=8.0, bbox={"color": "white", "alpha": 0.75, "pad": 0.5})


def _polar(points: Floats) -> tuple[Floats, Floats]:
    tilt = np.degrees(np.arctan2(np.hypot(points[:, 0], points[:, 1]), points[:, 2]))
    return np.arctan2(points[:, 1], points[:, 0]), tilt


def _draw_sphere(axes: Any, path: Floats, spots: Floats, cone: float, letter: str) -> None:
    """Orthographic; what lies behind is pale."""
    for line in _graticule():
        _draw_on_sphere(axes, line, "#b0b0b0", 0.6)
    rim = _ring(cone)
    flat, front = _project_points(rim)
    if front.all():
        axes.fill(*flat.T, color=ORANGE, alpha=0.28, lw=0)
    _draw_on_sphere(axes, rim, ORANGE, 1.2)
    outline = np.linspace(0.0, 2.0 * np.pi, 181)
    axes.plot(np.cos(outline), np.sin(outline), color=GREY, lw=0.9)
    _draw_on_sphere(axes, path, BLUE, 0.9)
    dots, front = _project_points(spots)
    axes.plot(*dots[front].T, ".", color=RED, ms=4, label="blocks near the pole")
    top = _project_points(np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 1.25]]))[0]
    axes.annotate("", top[1], top[0], arrowprops={"arrowstyle": "->", "color": "#333333", "lw": 1.2})
    axes.annotate(f"{letter} axis", top[1], (4, 0), textcoords="offset points", color="#333333")
    axes.set_aspect("equal")
    axes.set_axis_off()
    axes.set(xlim=(-1.1, 1.1), ylim=(-1.1, 1.3))


def _draw_on_sphere(axes: Any, line: Floats, colour: str, width: float) -> None:
    flat, front = _project_points(line)
    axes.plot(*np.where(front[:, None], np.nan, flat).T, color=colour, lw=0.6 * width, alpha=0.3)
    axes.plot(*np.where(front[:, None], flat, np.nan).T, color=colour, lw=width)


def _project_points(points: Floats) -> tuple[Floats, Bools]:
    """Where points (k, 3) of the sphere stand in the picture (k, 2), and which are on the near side (k,)."""
    (ca, sa), (ce, se) = ((math.cos(angle), math.sin(angle)) for angle in VIEW)
    right, up, towards = np.array([(-sa, ca, 0.0), (-se * ca, -se * sa, ce), (ce * ca, ce * sa, se)])
    return np.column_stack([points @ right, points @ up]), points @ towards >= 0.0


def _ring(tilt: float) -> Floats:
    turn = np.linspace(0.0, 2.0 * np.pi, 121)
    return np.column_stack(
        [np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.full(121, np.cos(tilt))]
    )


def _graticule() -> list[Floats]:
    """Parallels every 30 deg from the pole to the equator, meridians every 30 deg."""
    tilt = np.linspace(0.0, np.pi / 2.0, 46)
    meridians = [
        np.column_stack([np.sin(tilt) * math.cos(turn), np.sin(tilt) * math.sin(turn), np.cos(tilt)])
        for turn in np.radians(np.arange(0.0, 360.0, 30.0))
    ]
    return [_ring(math.radians(angle)) for angle in (30.0, 60.0, 90.0)] + meridians
