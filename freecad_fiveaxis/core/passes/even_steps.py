# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the levels of any field on a surface lie, so that neighbouring passes are nowhere more than a step
apart.

step    of the metric of the scallop (:mod:`.geodesic`): what two passes may be apart.
widest  place between two levels: it says how many steps the field's piece there is worth (T. Kim, *Constant
        cusp height tool paths as geodesic parallels on an abstract Riemannian manifold*, Computer-Aided
        Design 39 (2007), 477-489, for the metric).
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints, number_runs

from .geodesic import gradient, steepness
from .scallop_passes import Surface

PIECES = 512
"""Of the range of a field within which its levels are evenly spaced."""

USUAL = 0.9
"""Of the area of a piece of the range, what asks for least: the rest is unusual."""

MOST = 1.5
"""Times what the usual asks for: a place that wants more gets passes of its own, as a gap does, or a single
flat corner would crowd all passes together."""

FLAT = 1e-9
"""Of the range: facets over which the field rises by less carry no level."""


def count_in_steps(surface: Surface, value: Floats) -> Floats:
    """Count a field (v,) in steps (v,): within each component from 0 to a whole number, rising with the
    field; where one level more is one step at the widest place between both, but for places that are wider
    than others by far."""
    component, face = surface.copy.component, surface.copy.mesh.face
    share = _shares(component, value)
    corner, number = share[face], component[face[:, 0]]
    rises = np.flatnonzero(np.ptp(corner, axis=1) > FLAT)
    slope = steepness(surface.metric, gradient(surface.frame, face, share))
    rises = rises[slope[rises] > 0.0]
    first, last = (
        np.minimum(PIECES * end[rises], PIECES - 1).astype(np.int64)
        for end in (corner.min(axis=1), corner.max(axis=1))
    )
    row, piece = _spread(first, last)
    place = number[rises][row] * PIECES + piece
    wanted = _sum_worth(
        place,
        1.0 / slope[rises][row],
        (surface.frame.area[rises] / (last - first + 1))[row],
        (int(component.max(initial=-1)) + 1) * PIECES,
    )
    return _count_steps(component, share, wanted.reshape(-1, PIECES) / PIECES)


def _shares(component: Ints, value: Floats) -> Floats:
    """Return the field (v,) as a share of its range in the component, 0 to 1; 0 where it has none."""
    count = int(component.max(initial=-1)) + 1
    low, high = np.full(count, np.inf), np.full(count, -np.inf)
    np.minimum.at(low, component, value)
    np.maximum.at(high, component, value)
    span = (high - low)[component]
    return np.clip(
        np.where(span > 0.0, (value - low[component]) / np.where(span > 0.0, span, 1.0), 0.0), 0.0, 1.0
    )


def _spread(first: Ints, last: Ints) -> tuple[Ints, Ints]:
    """Rows and pieces (m,): each row once for every piece from its ``first`` (n,) to its ``last`` (n,)."""
    row, number = number_runs(last - first + 1)
    return row, first[row] + number


def _sum_worth(place: Ints, steps: Floats, weight: Floats, count: int) -> Floats:
    """Return the steps (count,) that the range is worth at each place, by those (m,) of the facets there, and
    their ``weight`` (m,)."""
    order = np.lexsort((steps, place))
    place, steps, weight = place[order], steps[order], weight[order]
    last = np.append(np.flatnonzero(np.diff(place)), len(place) - 1)[: len(place)]
    total = np.cumsum(weight)
    before = np.append(0.0, total[last[:-1]])
    usual = np.minimum(np.searchsorted(total, before + USUAL * (total[last] - before)), last)
    wanted = np.zeros(count)
    wanted[place[last]] = np.minimum(steps[last], MOST * steps[usual])
    return wanted


def _count_steps(component: Ints, share: Floats, worth: Floats) -> Floats:
    """Return the steps (v,) from the low end of each component, where the pieces of its range are ``worth``
    (c, PIECES) so many; in all a whole number."""
    total = worth.sum(axis=1, keepdims=True)
    worth = worth * np.where(total > 0.0, np.ceil(total) / np.where(total > 0.0, total, 1.0), 0.0)
    before = np.cumsum(worth, axis=1) - worth
    piece = np.minimum(PIECES * share, PIECES - 1).astype(np.int64)
    return np.asarray(before[component, piece] + worth[component, piece] * (PIECES * share - piece))
