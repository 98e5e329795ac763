# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of rest material as an SVG picture: three views of the part, its histogram by area, and the scale
of colours.

It needs no other library. The views are pixels inside the SVG, so that the finest mesh makes no larger file.
"""

from __future__ import annotations

import base64
import math

import numpy as np

from freecad_fiveaxis.core.base.records import Bytes, Floats, Ints
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge import RestMaterial

from .part_facts import histogram
from .raster import owners, png, view_from
from .rest_material_map import (
    HeightScale,
    find_machined,
    height_colours,
    height_levels,
    height_scale,
    level_colours,
    rest_material_patches,
    scale_marks,
)

WIDE, PANEL, GAP = 1000, 480, 40
"""Width of the picture, of a view, and what lies between two views."""

TALLEST = 400
FINE = 2
"""Pixels of a view for each of the picture's."""

VIEWS = (
    ("From above", -0.5 * math.pi, 0.5 * math.pi),
    ("From the front left", math.radians(-120.0), math.radians(30.0)),
    ("From the back right", math.radians(60.0), math.radians(30.0)),
)
"""Name, azimuth and elevation, rad."""

NEUTRAL_WIDE = 120
"""Of the scale's piece between too deep and rest material."""

LIGHT = np.array([-0.35, 0.45, 0.82])
"""Where the light comes from, in the view: right, up, towards."""
DARKEST = 0.72

MARGIN = 0.04
"""Around the machined surface, as a share of its size."""

INK, SOFT, LINE = "#1c2024", "#5b636b", "#b8bec4"
BLUE, RED = "#00286b", "#800010"
"""Of the marks at the most rest material and the deepest place."""


def rest_svg(mesh: Mesh, rest: RestMaterial, tolerance: float, allowed: float) -> bytes:
    """Return the picture; the same input gives the same bytes."""
    scale = height_scale(rest, tolerance, allowed)
    part = _colour_triangles(mesh, rest, scale)
    panels = [_view(part, rest, scale, *view) for view in VIEWS]
    panels.append(_histogram(rest, scale, min(height for _, height in panels[2:])))
    first, second = max(height for _, height in panels[:2]), max(height for _, height in panels[2:])
    places = ((0, 0), (PANEL + GAP, 0), (0, first + GAP), (PANEL + GAP, first + GAP))
    drawn = [
        f'<g transform="translate({x} {y})">{part}</g>'
        for (x, y), (part, _) in zip(places, panels, strict=True)
    ]
    bottom = first + GAP + second + 30
    drawn.append(f'<g transform="translate(0 {bottom})">{_legend(scale)}</g>')
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-10 -10 {WIDE + 20} {bottom + 80}" '
        f'width="{WIDE + 20}" '
    )
    head += f'height="{bottom + 80}" font-family="DejaVu Sans, sans-serif" font-size="13" fill="{INK}">'
    return (head + "\n".join(drawn) + "</svg>\n").encode()


def _text(x: float, y: float, label: str, anchor: str = "start", fill: str = INK, size: int = 13) -> str:
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{fill}" '
        f'font-size="{size}">{label}</text>'
    )


def _colour_triangles(mesh: Mesh, rest: RestMaterial, scale: HeightScale) -> tuple[Floats, Floats]:
    """Triangles (k, 3, 3) mm, the machined ones first, and their colours (k, 3)."""
    patch, others = rest_material_patches(mesh, rest), mesh.vertex[mesh.face[~find_machined(mesh, rest)]]
    height = np.append(rest.height, np.full(len(others), np.nan))
    return np.concatenate([patch, others]), height_colours(height, scale)


def _view(
    part: tuple[Floats, Floats],
    rest: RestMaterial,
    scale: HeightScale,
    name: str,
    azimuth: float,
    elevation: float,
) -> tuple[str, int]:
    """Return a view in the picture's units from its upper left corner on, and how tall it is."""
    (corner, colour), view = part, view_from(azimuth, elevation)
    flat = corner[: len(rest.height)].reshape(-1, 3) @ view[:2].T
    low, high = flat.min(axis=0), flat.max(axis=0)
    room = MARGIN * float((high - low).max())
    low, high = low - room, high + room
    size = min(PANEL / (high[0] - low[0]), TALLEST / (high[1] - low[1]))
    wide, tall = (max(math.ceil(extent * size), 1) for extent in high - low)
    owner = owners(corner, view, low, FINE * size, FINE * wide, FINE * tall)
    data = base64.b64encode(png(_pixels(corner, colour, view, owner))).decode()
    at = 24  # below the name
    drawn = [
        _text(0, 14, name, size=15),
        f'<image x="0" y="{at}" width="{wide}" height="{tall}" href="data:image/png;base64,{data}"/>',
        *_marks(rest, scale, owner, at),
        _ruler(float((high - low)[0]), size, at + tall + 14),
    ]
    return "".join(drawn), at + tall + 30


def _pixels(corner: Floats, colour: Floats, view: Floats, owner: Ints) -> Bytes:
    """Return the picture (height, width, 3): each triangle in its colour, a little darker where it turns away
    from the light."""
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]) @ view.T
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-30)[:, None]
    lit = DARKEST + (1.0 - DARKEST) * np.clip(normal @ (LIGHT / np.linalg.norm(LIGHT)), 0.0, 1.0)
    image = np.full((*owner.shape, 3), 255, np.uint8)
    seen = owner >= 0
    image[seen] = np.rint(255.0 * (colour * lit[:, None])[owner[seen]]).astype(np.uint8)
    return image


def _marks(rest: RestMaterial, scale: HeightScale, owner: Ints, top: int) -> list[str]:
    """Return a ring about the most rest material and about the deepest place, where they are beyond what may
    be and can be seen."""
    drawn = []
    for row, beyond, ink in (
        (int(rest.height.argmax()), rest.height.max() > scale.allowed, BLUE),
        (int(rest.height.argmin()), rest.height.min() < -scale.tolerance, RED),
    ):
        down, along = np.nonzero(owner == row)
        if beyond and len(down):
            x, y = float(along.mean() + 0.5) / FINE, top + float(down.mean() + 0.5) / FINE
            anchor, shift = ("end", -10) if x > 0.75 * owner.shape[1] / FINE else ("start", 10)
            label = f"{rest.height[row]:+.3g} mm"
            drawn += [
                f'<circle cx="{x:.1f}" cy="{y:.1f}" r="6" fill="none" stroke="#fff" stroke-width="4"/>',
                f'<circle cx="{x:.1f}" cy="{y:.1f}" r="6" fill="none" stroke="{ink}" stroke-width="2"/>',
                f'<text x="{x + shift:.1f}" y="{y + 4:.1f}" text-anchor="{anchor}" fill="{ink}" '
                'stroke="#fff" stroke-width="3" '
                f'paint-order="stroke" font-weight="600">{label}</text>',
            ]
    return drawn


def _ruler(extent: float, size: float, y: float) -> str:
    """Return a length of 1, 2 or 5 times a power of ten, about a fifth of the view."""
    power = 10.0 ** math.floor(math.log10(0.2 * extent))
    length = max(step * power for step in (1.0, 2.0, 5.0) if step * power <= 0.2 * extent)
    line = f'<path d="M0 {y - 4}v8m0 -4h{length * size:.1f}m0 -4v8" fill="none" stroke="{SOFT}"/>'
    return line + _text(length * size + 8, y + 4, f"{length:g} mm", fill=SOFT)


def _histogram(rest: RestMaterial, scale: HeightScale, tall: int) -> tuple[str, int]:
    """Area between each two borders, as bars from the top down, the most rest material first."""
    rows = histogram(rest, scale)[::-1]
    whole = float(rest.area.sum())
    most = max(row["area"] for row in rows)
    step = min((tall - 30) / len(rows), 30.0)
    colours = level_colours(height_levels(np.array([_inner(row["from"], row["to"]) for row in rows]), scale))
    drawn = [_text(0, 14, "Area by height above the part", size=15)]
    for at, (row, colour) in enumerate(zip(rows, colours, strict=True)):
        y, wide = 28 + at * step, 200.0 * row["area"] / most
        drawn.append(_text(150, y + 0.72 * step, f"{row['from']:.3g} to {row['to']:.3g} mm", "end"))
        if row["area"] > 0.0:
            bar = (
                f'<rect x="160" y="{y + 0.1 * step:.1f}" width="{max(wide, 1.0):.1f}" '
                f'height="{0.8 * step:.1f}" '
            )
            drawn.append(bar + f'fill="{_hex(colour)}" stroke="{LINE}" stroke-width="0.7"/>')
        label = f"{_area(row['area'])} mm2 ({_percent(row['area'] / whole)})" if row["area"] > 0.0 else "-"
        drawn.append(_text(160 + max(wide, 1.0) + 8, y + 0.7 * step, label, fill=SOFT))
    return "".join(drawn), int(28 + len(rows) * step)


def _inner(low: float, high: float) -> float:
    """Return a height between two borders that has the colour of most of what lies there."""
    return math.copysign(math.sqrt(low * high), low) if low * high > 0.0 else 0.0


def _area(area: float) -> str:
    return f"{area:.4g}" if area < 1000.0 else f"{area:.0f}"


def _percent(share: float) -> str:
    return f"{100.0 * share:.2g} %" if share < 0.995 else f"{100.0 * share:.4g} %"


def _legend(scale: HeightScale) -> str:
    """Return the scale of colours with its heights in mm: too deep, as it should be, rest material."""
    steps, x0, side = 60, 30.0, 0.5 * (WIDE - 60.0 - NEUTRAL_WIDE)
    ramp = (np.arange(steps) + 0.5) / steps
    colours = level_colours(np.concatenate([ramp - 1.0, [0.0], ramp]))
    widths = np.concatenate([np.full(steps, side / steps), [NEUTRAL_WIDE], np.full(steps, side / steps)])
    left = x0 + np.cumsum(widths) - widths
    bars = [
        f'<rect x="{x:.2f}" y="0" width="{wide + 0.5:.2f}" height="16" fill="{_hex(colour)}"/>'
        for x, wide, colour in zip(left, widths, colours, strict=True)
    ]
    frame = f'<rect x="{x0}" y="0" width="{WIDE - 60}" height="16" fill="none" stroke="{LINE}"/>'
    drawn = ['<g shape-rendering="crispEdges">', *bars, frame, "</g>"]
    for level, height in scale_marks(scale):
        x = x0 + (1.0 + level) * side + NEUTRAL_WIDE * (height > 0.0)
        drawn += [f'<path d="M{x:.1f} 16v5" stroke="{SOFT}"/>', _text(x, 35, f"{height:+.3g}", "middle")]
    drawn += [
        _text(x0, 54, "cut too deep, mm", fill=RED),
        _text(WIDE - x0, 54, "left on the part, mm", "end", BLUE),
    ]
    return "".join([*drawn, _text(0.5 * WIDE, 54, "as it should be", "middle", SOFT)])


def _hex(colour: Floats) -> str:
    return "#" + "".join(f"{round(255.0 * float(part)):02x}" for part in colour)
