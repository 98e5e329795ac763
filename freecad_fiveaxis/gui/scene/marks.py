# SPDX-License-Identifier: LGPL-2.1-or-later
"""Markers as points that can be picked: one set of points for each kind.

Each point has a rim in the opposite lightness, so that it shows on any ground. Kinds differ in size as well
as in colour: where a block is over the tolerance and near the pole, one stands within the other. Where the
tool enters the part stands a target: a point with a spot of another colour in its middle.

Where the part is small on the screen its markers are smaller, but never too small to be seen, and of those
near the pole, which may be thousands, only so many are drawn that they leave the part to be seen.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from pivy import coin

from . import nodes
from .zoom import Zoom

LARGEST, OVER, SINGULAR = "largest-deviation", "deviation-over-tolerance", "singular-block"
"""The kinds of the core that have a look of their own; all others look alike."""
OVERCUT, RAPID_COLLISION, HOLDER_COLLISION = "overcut", "rapid-collision", "holder-collision"
INDEPENDENT_RAPID = "independent-rapid"
"""Those of a tool that enters the part."""
OTHER_COLOUR = (0.35, 0.71, 0.91)
RIM, DARK, WHITE = 4.0, (0.05, 0.05, 0.05), (1.0, 1.0, 1.0)
YELLOW, BLUE = (0.94, 0.89, 0.26), (0.0, 0.45, 0.70)
GOUGE_COLOURS = {OVERCUT: YELLOW, RAPID_COLLISION: DARK, INDEPENDENT_RAPID: DARK, HOLDER_COLLISION: BLUE}
NOTHING = 5e-5
"""mm; a largest deviation below this is none: its marker would show the way to nowhere."""
SPOT = 0.4
"""Size of a target's middle, as a share of it."""
WHOLE = 400.0
"""Pixels from corner to corner of a part whose markers have their whole size."""
LEAST, LEAST_SHARE = 4.0, 0.4
"""No marker is smaller than so many pixels, nor than this share of its whole size."""
COVERED, FEW = 0.1, 25
"""The share of the part's box on the screen that markers near the pole may cover; and so many are always
drawn."""
_NAME = re.compile(r"FiveAxisMarks_(\d+)_(\d+)")
_serial = itertools.count()


def largest_colour(
    deviation: float, tolerance: float, good: nodes.Colour, bad: nodes.Colour
) -> nodes.Colour | None:
    """Return the colour of the marker and the label at the largest deviation (mm): calm within the tolerance,
    loud over it or where the deviation is not known; None where there is nothing to show."""
    if deviation < NOTHING:
        return None
    return good if deviation <= tolerance else bad


def least_size(whole: float) -> float:
    """Return the pixels of a marker on a part that is far away; ``whole``: of the same on a near one."""
    return min(whole, max(LEAST, LEAST_SHARE * whole))


def choose_size(part: float, least: float, whole: float) -> float:
    """Return the pixels of a marker of a part that is ``part`` pixels from corner to corner: from ``least``
    to ``whole``."""
    return least + (whole - least) * min(max(part / WHOLE, 0.0), 1.0)


def choose_count(part: float, count: int, size: float) -> int:
    """How many of ``count`` markers of ``size`` pixels are drawn on a part that is ``part`` pixels from
    corner to corner."""
    return int(min(count, max(FEW, COVERED * 0.5 * (part / size) ** 2)))


@dataclass(frozen=True)
class _Look:
    """Colours of a point and its rim, size in pixels; ``depth``: how much nearer it is drawn
    (``nodes.nearer``); ``spot``: the colour of its middle, where that has another; ``many``: there may be so
    many that only some are drawn."""

    fill: nodes.Colour
    rim: nodes.Colour
    size: float
    depth: float
    spot: nodes.Colour | None = None
    many: bool = False


class Marks:
    """The nodes of some markers; ``root`` goes into the scene."""

    def __init__(self) -> None:
        self.root, self.drawn, self.zoom = coin.SoSeparator(), coin.SoSeparator(), Zoom(self)
        for node in (self.zoom.root, self.drawn):
            self.root.addChild(node)
        self.root.renderCaching = self.drawn.renderCaching = coin.SoSeparator.OFF
        self.serial = next(_serial)
        self.rows: list[np.ndarray] = []
        self.part = np.inf
        self.sizes: list[tuple[Any, float, float]] = []
        self.many: list[tuple[Any, int, float]] = []

    def show(
        self,
        places: np.ndarray,
        kinds: Sequence[str],
        largest: nodes.Colour | None,
        bad: nodes.Colour,
        singular: nodes.Colour,
        size: float,
    ) -> None:
        """Draw markers at ``places`` (k, 3) mm; ``largest``: the colour of the largest deviation, None: it is
        not drawn; ``size`` pixels."""
        self.drawn.removeAllChildren()
        self.rows, self.sizes, self.many = [], [], []
        if not len(places):
            return
        self.zoom.middle = places.mean(axis=0)
        self.drawn.addChild(nodes.flat())
        kind = np.asarray(kinds)
        known = np.isin(kind, (OVER, SINGULAR, LARGEST, *GOUGE_COLOURS))
        # the mouse takes the first where several stand at one place, and that one is drawn over the others
        looks = (
            *([] if largest is None else [(kind == LARGEST, _Look(largest, DARK, size + 5.0, 1.0))]),
            (kind == OVERCUT, _Look(YELLOW, DARK, size + 4.0, 0.035, DARK)),
            (kind == HOLDER_COLLISION, _Look(BLUE, WHITE, size + 4.0, 0.034, WHITE)),
            (
                np.isin(kind, (RAPID_COLLISION, INDEPENDENT_RAPID)),
                _Look(DARK, WHITE, size + 4.0, 0.033, YELLOW),
            ),
            (kind == OVER, _Look(bad, WHITE, size, 0.032)),
            (kind == SINGULAR, _Look(singular, DARK, size + 7.0, 0.031, many=True)),
            (~known, _Look(OTHER_COLOUR, DARK, size, 0.03)),
        )
        for chosen, look in looks:
            self._add(places, np.flatnonzero(chosen), look)

    def stand_on(self, low: np.ndarray, high: np.ndarray) -> None:
        """Take the markers for those of a part between two corners (3,) mm: they are as large as suits that
        on the screen."""
        self.part = float(np.linalg.norm(high - low))

    def zoom_to(self, pixels_per_mm: float) -> None:
        """Have the markers as large, and as many, as suits the part's size on the screen; called within a
        frame."""
        pixels = self.part * pixels_per_mm
        if np.isnan(pixels):  # a part of no size behind the eye
            return
        for style, least, whole in self.sizes:
            style.pointSize = choose_size(pixels, least, whole)
        for shape, count, size in self.many:
            shape.numPoints = choose_count(pixels, count, choose_size(pixels, least_size(size), size))

    def _add(self, places: np.ndarray, rows: np.ndarray, look: _Look) -> None:
        if not len(rows):
            return
        if look.many and len(rows) > FEW:
            rows = np.random.default_rng(0).permutation(rows)  # the first of them stand everywhere
        inner, outer = nodes.points(places[rows]), nodes.points(places[rows])
        inner.setName(f"FiveAxisMarks_{self.serial}_{len(self.rows)}")
        self.rows.append(rows)
        least = least_size(look.size)
        rim = (
            nodes.unpickable(),
            nodes.colour(look.rim),
            self._style_sizes(least + 0.5 * RIM, look.size + RIM),
            outer,
        )
        fill = (
            nodes.on_top_for_picking(),
            nodes.colour(look.fill),
            self._style_sizes(least, look.size),
            inner,
        )
        self._draw(nodes.nearer(look.depth, covers=False), *rim)
        self._draw(nodes.nearer(look.depth), *fill)
        if look.spot is not None:
            spot, middle = self._style_sizes(SPOT * least, SPOT * look.size), nodes.points(places[rows])
            self._draw(
                nodes.nearer(look.depth + 0.0005), nodes.unpickable(), nodes.colour(look.spot), spot, middle
            )
        for shape in (inner, outer) if look.many else ():
            shape.enableNotify(False)
            self.many.append((shape, len(rows), look.size))

    def _style_sizes(self, least: float, whole: float) -> Any:
        """Return a style for points whose size in pixels is between these."""
        style = nodes.style(point=whole)
        style.enableNotify(False)  # what a frame changes must not ask for the next frame
        self.sizes.append((style, least, whole))
        return style

    def _draw(self, *children: Any) -> None:
        separator = nodes.separate(*children)
        separator.renderCaching = coin.SoSeparator.OFF
        self.drawn.addChild(separator)

    def find_picked_marker(self, point: Any) -> int | None:
        """Return the row of the marker that a picked point (SoPickedPoint) lies on."""
        tail = point.getPath().getTail()
        named = _NAME.match(tail.getName().getString())
        detail = point.getDetail()
        if not named or int(named[1]) != self.serial or detail is None:
            return None
        found = coin.cast(detail, "SoPointDetail") if not hasattr(detail, "getCoordinateIndex") else detail
        return int(self.rows[int(named[2])][found.getCoordinateIndex()])
