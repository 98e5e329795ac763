# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tool meets while its axis turns from one free contact to the next.

blocked   a move between two rows whose axis turns so far that what lies between is asked, and is not free
          somewhere there. More contacts are put into it, each with a free axis of its own; where that does
          not help either, the pass is broken there.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, take_rows
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.orientation.strategies import AxisOptions
from freecad_fiveaxis.core.toolpath.cl_offset import rows_between, seat_normal
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath, take_path_rows

from .auto_axis import Free, auto_axes
from .axis_field import are_free
from .facets_with_axis import AxisField
from .raised_contacts import raise_contacts

TURN, STEP = math.radians(2.0), math.radians(5.0)
"""Turns below the first are not asked: at 100 mm from the tip the way bulges by 0.015 mm. Between samples the
axis turns by no more than the second."""
MOST = 16
"""Samples within one move, at most."""
PARTS = 4
"""Parts into which a blocked move is divided; twice where that is not enough."""
ROUNDS = 2


def find_blocked_turns(
    path: OffsetPath,
    axis: Floats,
    mesh: Mesh,
    reacher: Reacher,
    progress: Progress = silent,
    chosen: Bools | None = None,
) -> Bools:
    """Find the rows (n,) that the tool comes to through the part while its axis (n, 3) turns evenly from the
    row before; of rows that are not ``chosen`` (n,) none, None: all are."""
    blocked, cosine = np.zeros(len(axis), np.bool_), (axis[1:] * axis[:-1]).sum(axis=1)
    turning = (np.diff(path.polyline) == 0) & (True if chosen is None else chosen[1:])
    turn = np.where(turning, np.arccos(np.clip(cosine, -1.0, 1.0)), 0.0)
    pieces = np.ones(len(axis), np.int64)
    pieces[1:][turn > TURN] = np.clip(np.ceil(turn[turn > TURN] / STEP), 2, MOST)
    if not (pieces > 1).any():
        return blocked
    cutter, tree = reacher.cutter, facet_tree(mesh)
    fine, turned, row = rows_between(path, axis, pieces, cutter.ring, cutter.barrel)
    new = np.flatnonzero(row[:-1] == row[1:])
    normal = (seat_normal(fine, cutter.ring) if cutter.has_level_bottom else fine.normal)[new]
    point = fine.centre[new] - cutter.corner * normal
    stand, fits = raise_contacts(reacher, tree, point, normal)
    anywhere = replace(reacher, kinematics=None, most=math.pi)
    free = are_free(anywhere, tree, stand, normal, turned[new], progress)
    blocked[row[new[fits & ~free]]] = True
    return blocked


def lead_out(polyline: Ints, free: Ints) -> Bools:
    """Find the rows (n,) to which moves lead that begin or end in a piece with a way out: rows on end of a
    ``polyline`` (n,) at which the tool is ``free`` (n,), and can be drawn out at one. What else there is,
    :func:`.select_rows_with_way_out` drops."""
    breaks = np.diff(polyline) != 0
    piece = np.cumsum(np.append(False, breaks | (np.diff(free > Free.NONE))))
    out: Bools = np.isin(piece, piece[free == Free.WAY_OUT])
    out[1:] |= out[:-1] & ~breaks
    return out


def divide_blocked_turns(
    path: OffsetPath, axis: Floats, free: Ints, field: AxisField, mesh: Mesh, reacher: Reacher,
    options: AxisOptions,
    progress: Progress = silent,
) -> tuple[OffsetPath, Floats, Ints, Bools]:  # fmt: skip
    """Put contacts into the blocked moves of ``path``, with axes of their own from the ``field``.

    ``axis`` (n, 3), ``free`` (n,): as of :func:`.auto_axes`. Returns path, axes and what is free, of all
    rows, and whether the move to each row is blocked still.
    """
    cutter = reacher.cutter
    blocked = find_blocked_turns(path, axis, mesh, reacher, progress, lead_out(path.polyline, free))
    for _ in range(ROUNDS):
        if not blocked.any():
            break
        path, axis, row = rows_between(path, axis, np.where(blocked, PARTS, 1), cutter.ring, cutter.barrel)
        added, free = np.append(row[:-1] == row[1:], False), free[row]
        new = np.flatnonzero(added)
        more, given = take_path_rows(path, new), take_rows(axis, new)
        axis = np.array(axis)
        axis[new], free[new], _ = auto_axes(more, given, field, mesh, reacher, options, progress)
        beside = added | np.append(False, added[:-1])  # the other moves are as they were, and not blocked
        blocked = find_blocked_turns(
            path, axis, mesh, reacher, progress, beside & lead_out(path.polyline, free)
        )
    return path, axis, free, blocked
