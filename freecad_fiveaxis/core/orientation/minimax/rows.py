# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rows of an offset path as the search sees them, and where the tool axis may stand at each.

run       rows that follow each other without the tool leaving the part: one polyline, or several that touch.
range     of a row: the great arc between the facet normals on either side of its contact point. An axis is
          allowed where it is within ``max_tilt`` of that.

Rows of one contact point have the same range but not the same axis: while the ball closes a gap it rolls
about that point, and turning then, too, halves the largest turn of a block. The deviation goes with its
square.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

ONE_NORMAL = 1e-9
"""Sine of the angle between two facet normals below which their arc is a point."""
EDGE = 1e-9
"""An axis that is beyond its range by so much (as a sine) is on its edge."""


@dataclass(frozen=True, eq=False)
class Rows:
    """``first`` (p,): the row that each run begins with; ``size`` (p,) rows of each run; ``run`` (k,);
    ``centre`` (k, 3) mm of the ball; ``before``, ``after`` (k, 3): the facet normals on either side."""

    first: Ints
    size: Ints
    run: Ints
    centre: Floats
    before: Floats
    after: Floats

    def take(self, runs: Ints) -> tuple[Rows, Ints]:
        """Return some of the runs, with the rows (k',) that are left."""
        size = self.size[runs]
        first = np.cumsum(size) - size
        rows = np.arange(int(size.sum())) + np.repeat(self.first[runs] - first, size)
        run = np.repeat(np.arange(len(runs)), size)
        return Rows(first, size, run, self.centre[rows], self.before[rows], self.after[rows]), rows


def find_rows(path: OffsetPath) -> Rows:
    """Return the rows of ``path``, which has at least one."""
    begins = run_begins(path)
    first = np.flatnonzero(begins)
    return Rows(
        first, np.diff(first, append=len(begins)), np.cumsum(begins) - 1, path.centre, path.before, path.after
    )


def run_begins(path: OffsetPath) -> Bools:
    """Return the rows (n,) with which a run begins."""
    begins = np.diff(path.polyline, prepend=path.polyline[0] - 1) != 0
    begins[1:] &= np.abs(np.diff(path.centre, axis=0)).max(axis=1, initial=0.0) >= COINCIDENT_MM
    return np.asarray(begins)


def is_allowed(before: Floats, after: Floats, max_tilt: float, axis: Floats) -> Bools:
    """Whether unit ``axis`` (3, m, k) is within ``max_tilt`` rad of the range between ``before`` and
    ``after`` (k, 3): (m, k).

    An axis that leans below a facet beside its contact is not allowed: the shank would stand in the part.
    """
    across = np.cross(before, after)
    sine = np.linalg.norm(across, axis=1)
    point = sine < ONE_NORMAL
    across /= np.where(point, 1.0, sine)[:, None]
    near, far = _along(axis, before), _along(axis, after)
    beside = np.abs(_along(axis, across)) <= math.sin(max_tilt) + EDGE
    beside &= (_along(axis, np.cross(across, before)) >= 0.0) & (_along(axis, np.cross(after, across)) >= 0.0)
    beside &= ~point
    at_end = np.maximum(near, far) >= math.cos(max_tilt) - EDGE * max(max_tilt, EDGE)
    return np.asarray((beside | at_end) & (np.minimum(near, far) >= 0.0))


def _along(axis: Floats, vector: Floats) -> Floats:
    return np.asarray(axis[0] * vector[:, 0] + axis[1] * vector[:, 1] + axis[2] * vector[:, 2])
