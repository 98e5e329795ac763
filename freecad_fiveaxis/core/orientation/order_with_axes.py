# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of polylines once more, now that their tool axes are known and rows without a free axis are gone.

The passes were ordered by the places of their ends alone. Between two places side by side whose axes differ
the tool has to be drawn out, turned and let in again: an end is a place *and* an axis, and a turn of one
radian counts as LEVER mm of way.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, take_rows
from freecad_fiveaxis.core.passes.piece_order import Tour, find_better_tour, tour_rows
from freecad_fiveaxis.core.toolpath.coedge import ROW_COLUMNS, OffsetPath

LEVER = 30.0
"""mm of way for a radian of turn: about as far as a tool is drawn out before it turns by that."""


def order_with_axes(path: OffsetPath, axis: Floats) -> tuple[OffsetPath, Floats]:
    """Give the polylines of ``path`` and the unit ``axis`` (n, 3) of its rows in an order, and each polyline
    the way round, that spares way and turns; the very path where that is not worth it."""
    first = np.flatnonzero(np.diff(path.polyline, prepend=-1))
    last = np.append(first[1:], len(path.point)) - 1
    pose = np.hstack([path.point, LEVER * axis])
    tour = find_better_tour(np.stack([pose[first], pose[last]], axis=1)) if len(first) > 1 else None
    return (path, axis) if tour is None else take_tour(path, axis, tour)


def order_by_time(path: OffsetPath, axis: Floats, when: Ints) -> tuple[OffsetPath, Floats]:
    """Give the polylines, and the ``axis`` (n, 3) of the rows, in the order of the least ``when`` (n,) of
    each, open ones the way round in which it mostly grows; closed ones run as they do."""
    edge = np.flatnonzero(np.diff(path.polyline, prepend=-1, append=-1))
    first, last = edge[:-1], edge[1:] - 1
    step = np.sign(np.diff(when, append=when[-1:]))
    step[last] = 0
    begins, grows = np.minimum.reduceat(when, first), np.add.reduceat(step, first)
    back = (grows < 0) & (path.point[first] != path.point[last]).any(axis=1)
    order = np.argsort(begins, kind="stable")
    return take_tour(path, axis, Tour(order, back[order]))


def take_tour(path: OffsetPath, axis: Floats, tour: Tour) -> tuple[OffsetPath, Floats]:
    """Return the polylines and the ``axis`` (n, 3) of their rows as the tour takes them."""
    first = np.flatnonzero(np.diff(path.polyline, prepend=-1))
    last = np.append(first[1:], len(path.point)) - 1
    rows, piece, back = tour_rows(first, last, tour)
    return _arrange_rows(path, rows, piece, back), take_rows(axis, rows)


def _arrange_rows(path: OffsetPath, rows: Ints, piece: Ints, back: Bools) -> OffsetPath:
    """Return the ``rows`` (n,) as polylines ``piece`` (n,): where they are taken ``back`` (n,), what was
    before a row is after it."""
    columns = {name: getattr(path, name)[rows] for name in ROW_COLUMNS}
    for one, other in (("before", "after"), ("step_before", "step_after")):
        turned = back[:, None] if columns[one].ndim == 2 else back
        columns[one], columns[other] = (
            np.where(turned, columns[to], columns[it]) for it, to in ((one, other), (other, one))
        )
    arrives = np.where(
        back, np.append(path.fill[1:], False)[rows], columns["fill"]
    )  # backwards: by the move that left the row
    begins = np.diff(piece, prepend=-1) != 0
    return replace(path, **columns | {"fill": arrives & ~begins, "polyline": piece})
