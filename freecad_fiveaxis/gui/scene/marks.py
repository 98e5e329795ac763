# SPDX-License-Identifier: LGPL-2.1-or-later
"""Markers as points that can be picked: one set of points for each kind.

Each point has a rim in the opposite lightness, so that it shows on any ground. Kinds differ in size as well as in colour: where
a block is over the tolerance and near the pole, one stands within the other. Where the tool enters the part stands a target: a
point with a spot of another colour in its middle.
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
_NAME = re.compile(r"FiveAxisMarks_(\d+)_(\d+)")
_serial = itertools.count()


def largest_colour(deviation: float, tolerance: float, good: nodes.Colour, bad: nodes.Colour) -> nodes.Colour | None:
    """The colour of the marker and the label at the largest deviation (mm): calm within the tolerance, loud over it or where the
    deviation is not known; None where there is nothing to show."""
    if deviation < NOTHING:
        return None
    return good if deviation <= tolerance else bad


@dataclass(frozen=True)
class _Look:
    """Colours of a point and its rim, size in pixels; ``depth``: how much nearer it is drawn (``nodes.nearer``); ``spot``: the
    colour of its middle, where that has another."""

    fill: nodes.Colour
    rim: nodes.Colour
    size: float
    depth: float
    spot: nodes.Colour | None = None


class Marks:
    """The nodes of some markers; ``root`` goes into the scene."""

    def __init__(self) -> None:
        self.root = coin.SoSeparator()
        self.serial = next(_serial)
        self.rows: list[np.ndarray] = []

    def show(
        self,
        places: np.ndarray,
        kinds: Sequence[str],
        largest: nodes.Colour | None,
        bad: nodes.Colour,
        singular: nodes.Colour,
        size: float,
    ) -> None:
        """Draw markers at ``places`` (k, 3) mm; ``largest``: the colour of the largest deviation, None: it is not drawn; ``size``
        pixels."""
        self.root.removeAllChildren()
        self.rows = []
        if not len(places):
            return
        self.root.addChild(nodes.flat())
        kind = np.asarray(kinds)
        known = np.isin(kind, (OVER, SINGULAR, LARGEST, *GOUGE_COLOURS))
        looks = (  # the mouse takes the first where several stand at one place, and that one is drawn over the others
            *([] if largest is None else [(kind == LARGEST, _Look(largest, DARK, size + 5.0, 1.0))]),
            (kind == OVERCUT, _Look(YELLOW, DARK, size + 4.0, 0.035, DARK)),
            (kind == HOLDER_COLLISION, _Look(BLUE, WHITE, size + 4.0, 0.034, WHITE)),
            (np.isin(kind, (RAPID_COLLISION, INDEPENDENT_RAPID)), _Look(DARK, WHITE, size + 4.0, 0.033, YELLOW)),
            (kind == OVER, _Look(bad, WHITE, size, 0.032)),
            (kind == SINGULAR, _Look(singular, DARK, size + 7.0, 0.031)),
            (~known, _Look(OTHER_COLOUR, DARK, size, 0.03)),
        )
        for chosen, look in looks:
            self._add(places, np.flatnonzero(chosen), look)

    def _add(self, places: np.ndarray, rows: np.ndarray, look: _Look) -> None:
        if not len(rows):
            return
        inner, outer = nodes.points(places[rows]), nodes.points(places[rows])
        inner.setName(f"FiveAxisMarks_{self.serial}_{len(self.rows)}")
        self.rows.append(rows)
        rim = (nodes.unpickable(), nodes.colour(look.rim), nodes.style(point=look.size + RIM), outer)
        fill = (nodes.on_top_for_picking(), nodes.colour(look.fill), nodes.style(point=look.size), inner)
        self.root.addChild(nodes.separate(nodes.nearer(look.depth, covers=False), *rim))
        self.root.addChild(nodes.separate(nodes.nearer(look.depth), *fill))
        if look.spot is not None:
            middle = (
                nodes.unpickable(),
                nodes.colour(look.spot),
                nodes.style(point=SPOT * look.size),
                nodes.points(places[rows]),
            )
            self.root.addChild(nodes.separate(nodes.nearer(look.depth + 0.0005), *middle))

    def picked(self, point: Any) -> int | None:
        """The row of the marker that a picked point (SoPickedPoint) lies on."""
        tail = point.getPath().getTail()
        named = _NAME.match(tail.getName().getString())
        detail = point.getDetail()
        if not named or int(named[1]) != self.serial or detail is None:
            return None
        found = coin.cast(detail, "SoPointDetail") if not hasattr(detail, "getCoordinateIndex") else detail
        return int(self.rows[int(named[2])][found.getCoordinateIndex()])
