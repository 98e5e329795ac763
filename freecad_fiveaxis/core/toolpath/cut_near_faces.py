# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes cut where the cutter's corner ball comes nearer to faces to avoid than their allowance.

Like a boundary (:mod:`.cut_at_boundary`) this cuts passes that are offset and closed, exactly where the ball
is as near as it may be; what the rest of the tool needs is asked later, once its axes are known.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.passes.keep_off import TOUCHING, KeepOff

from .coedge import OffsetPath
from .cut_at_boundary import Nodes, cut_at_nodes, goes_on, without_touches

STEP = 0.1
"""Of the least distance: so far apart a move is looked at. What dips in between is less than what later
stages see."""

BISECTIONS = 40


def cut_near_faces(path: OffsetPath, keep_off: KeepOff) -> OffsetPath:
    """Cut the passes where the corner ball comes too near, each piece that keeps off a polyline of its own;
    the path itself where all of it does. May leave no rows."""
    if not len(path.point):
        return path
    return cut_at_nodes(path, _find_nodes(path, keep_off), True, None)[0]


def _find_nodes(path: OffsetPath, keep_off: KeepOff) -> Nodes:
    """All rows, and the places within moves where the ball becomes too near or stops being so."""
    end = np.flatnonzero(goes_on(path.polyline))
    move, share = _crossings(path.centre[end - 1], path.centre[end], keep_off)
    row = np.concatenate([np.arange(len(path.point)), end[move]])
    share = np.concatenate([np.ones(len(path.point)), share])
    order = np.lexsort((share, row))
    row, share = row[order], share[order]
    start = path.centre[np.maximum(row - 1, 0)]
    where = np.where(
        (share < 1.0)[:, None], start + share[:, None] * (path.centre[row] - start), path.centre[row]
    )
    arrives = np.append(False, keep_off.room(0.5 * (where[:-1] + where[1:])) >= -TOUCHING)
    arrives[1:] &= (keep_off.room(where[:-1]) >= -2.0 * TOUCHING) & (
        keep_off.room(where[1:]) >= -2.0 * TOUCHING
    )
    return without_touches(Nodes(row, share, path.polyline[row], arrives & goes_on(path.polyline[row])))


def _crossings(start: Floats, end: Floats, keep_off: KeepOff) -> tuple[Ints, Floats]:
    """Return the moves (k,) in which straight ways from ``start`` to ``end`` (m, 3) mm begin or end to be too
    near, and where (k,), 0 to 1."""
    length = np.linalg.norm(end - start, axis=1)
    near = np.flatnonzero(keep_off.room(0.5 * (start + end)) < 0.5 * length)
    parts = np.maximum(np.ceil(length[near] / (STEP * keep_off.least)), 1).astype(np.int64)
    row, part = number_runs(parts + 1)
    move, share = near[row], part / parts[row]
    clear = _room_at(start, end, move, share, keep_off) >= 0.0
    change = np.flatnonzero((move[1:] == move[:-1]) & (clear[1:] != clear[:-1]))
    low, high, rises, move = share[change], share[change + 1], clear[change + 1], move[change]
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        before: Bools = (_room_at(start, end, move, middle, keep_off) >= 0.0) != rises
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    at = np.where(rises, high, low)  # on the side that keeps off
    inner = np.flatnonzero((at > 0.0) & (at < 1.0))
    return move[inner], at[inner]


def _room_at(start: Floats, end: Floats, move: Ints, share: Floats, keep_off: KeepOff) -> Floats:
    return keep_off.room(start[move] + share[:, None] * (end - start)[move])
