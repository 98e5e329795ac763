# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a map of setups. Each has a rim, so that it shows on any ground; all are seen through the
part."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from pivy import coin

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from . import colours, nodes

BEST, PRESENT, BEYOND = "setup-best", "setup-present", "setup-beyond-limits"
"""The kinds of the core that have a look of their own; every other is a place of the grid."""
PRESENT_COLOUR, BEYOND_COLOUR, DARK = (0.35, 0.71, 0.91), (0.55, 0.55, 0.55), (0.05, 0.05, 0.05)
RIM, LARGER = 3.0, 6.0
"""Pixels: of a rim, and by which the recommended place and the present one are larger."""
FEW, SAME_HEIGHT = 30, 1e-3
"""So many places are shown all together; places of one layer differ by no more, mm."""


def layer_rows(places: Floats, kinds: Sequence[str]) -> Ints:
    """Return the rows of the places (k, 3) that are shown: all where they are few, else the recommended one,
    the present one, and of the grid the layer that is nearest to the recommended one in height: of a block of
    points no depth can be read."""
    kind = np.asarray(kinds)
    named = (kind == BEST) | (kind == PRESENT)
    if len(kind) <= FEW or not named.any():
        return np.arange(len(kind))
    off = np.abs(places[:, 2] - places[np.flatnonzero(named)[0], 2])
    return np.flatnonzero(named | (off <= off[~named].min() + SAME_HEIGHT))


def setup_points(
    places: Floats,
    kinds: Sequence[str],
    levels: Floats,
    within: Bools,
    good: nodes.Colour,
    bad: nodes.Colour,
    size: float,
) -> Any:
    """Points at ``places`` (k, 3) mm, coloured by ``levels`` (k,), those ``within`` the tolerance in the
    ``good`` colour; ``size`` in pixels. The recommended place has a white ring about its colour."""
    kind = np.asarray(kinds)
    rgba = colours.pack_heat(levels, bad)
    rgba[within] = colours.pack(good)
    rgba[kind == BEYOND] = colours.pack(BEYOND_COLOUR)
    rgba[kind == PRESENT] = colours.pack(PRESENT_COLOUR)
    root = nodes.separate(nodes.unpickable(), nodes.flat())
    rows = np.flatnonzero((kind != BEST) & (kind != PRESENT))
    looks: list[Any] = [(rows, ((DARK, size + RIM),), size, 0.9)]
    for name, rims in (
        (PRESENT, ((DARK, RIM),)),
        (BEST, ((DARK, LARGER + RIM), (nodes.WHITE, LARGER))),
    ):  # before all
        own = size + LARGER
        looks.append(
            (np.flatnonzero(kind == name), tuple((rim, own + width) for rim, width in rims), own, 1.0)
        )
    for chosen, rims, inner, depth in looks:
        if not len(chosen):
            continue
        for rim, width in rims:
            ring = (nodes.colour(rim), nodes.style(point=width), nodes.points(places[chosen]))
            root.addChild(nodes.separate(_depth(depth, covers=False), *ring))
        spot = (nodes.style(point=inner), nodes.points(places[chosen], rgba[chosen]))
        root.addChild(nodes.separate(_depth(depth), *spot))
    return root


def _depth(depth: float, covers: bool = True) -> Any:
    """As ``nodes.nearer``; at 1 drawn over what stands at the view's near end as well, as the foremost corner
    of a map does."""
    depth_buffer = nodes.nearer(depth, covers)
    if depth == 1.0:
        depth_buffer.function = coin.SoDepthBuffer.ALWAYS
    return depth_buffer
