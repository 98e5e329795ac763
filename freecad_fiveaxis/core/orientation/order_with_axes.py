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
from freecad_fiveaxis.core.passes.piece_order import find_better_tour, tour_rows
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
    if tour is None:
        return path, axis
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
