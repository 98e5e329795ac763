# SPDX-License-Identifier: LGPL-2.1-or-later
"""Merges rows of a pass that stand on the straight and evenly turned motion between their neighbours.

A finely tessellated surface gives two or three rows for each facet that is crossed, nearer to each other than
the tolerance can tell and than a controller can read. Rows are merged where they crowd, and nowhere else.

span      the motion between two neighbouring rows that are kept: its straight point goes straight, its axis
          turns evenly on a great arc.
miss      how far a row that was left out is from its span, as a share of what is allowed; at most 1.
          It is measured to one place of the span, and the places of consecutive rows need not be told apart
          further: between two rows both motions are straight, so the way given is nowhere farther from the
          span than at its rows; but for the axis, whose way is a great arc. Where it turns far in one step
          (TURNS) a hub that stands over the straight point would swing off between them: both rows stay.
crowd     rows that are on average nearer to each other than CROWD tolerances. Chords of that length leave an
          arc of a radius of 80 tolerances by a tenth of the tolerance: rows that crowd are more than even a
          path that turns as tightly as that would ask for.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, run_ids, take_rows
from freecad_fiveaxis.core.base.vectors import row_dot, slerp
from freecad_fiveaxis.core.passes import CREASE

from .cl_offset import keep_rows
from .coedge import OffsetPath

CROWD = 8.0
"""Of the tolerance. At the usual tolerance and feed a controller has to read 200 such blocks a second."""

FINE = 0.01
"""mm; a tolerance that is wider does not make rows crowd that every controller can read."""

TURNS = math.radians(5.0)
"""In one step. A chord of an arc of that angle is off it by a thousandth of the radius."""

PORTION = 32768
"""Spans looked at by one thread at a time."""


@dataclass(frozen=True)
class Allowance:
    """What a merged row may be off its span: ``off`` mm, the point that makes the surface, square to the
    surface; ``aside`` mm, that point in any direction; ``tip`` mm, the tip in any direction; ``turn`` rad,
    the axis."""

    off: float
    aside: float
    tip: float
    turn: float


@dataclass(frozen=True)
class ToolPoints:
    """Points of a tool on its axis: its hub stands ``rise`` mm above the point that goes straight between
    rows, and ``corner`` mm above the tip. ``ring`` mm: no point of its end is farther from the hub, but for
    what is round it like a ball; 0 for a ball."""

    rise: float
    corner: float
    ring: float


def rows_crowd(path: OffsetPath, tolerance: float) -> bool:
    """Tell whether the rows of the path, whose centres are the cutter's hubs, are on average nearer to each
    other than CROWD times the ``tolerance``, mm, or FINE where that is less."""
    joined = np.diff(path.polyline) == 0
    steps = np.linalg.norm(np.diff(path.centre, axis=0), axis=1)[joined]
    return bool(len(steps) and steps.mean() < CROWD * min(tolerance, FINE))


def find_kept_rows(path: OffsetPath, axis: Floats, tool: ToolPoints, allowed: Allowance) -> Ints:
    """Find the rows (k,) that are kept, so that every other one is within ``allowed`` of the span over it.

    ``path`` has the cutter's hubs for its centres, ``axis`` (n, 3) is unit. Ends of polylines stay, and the
    rows of sharp edges (CREASE) and of steps in which the axis turns far (TURNS).
    """
    line = path.polyline
    fixed = (np.diff(line, prepend=-1) != 0) | (np.diff(line, append=-1) != 0) | _is_sharp(path)
    far = _angle(np.diff(axis, axis=0)) > TURNS
    fixed |= np.append(far, False) | np.append(False, far)
    return _keep(_PassRows.of(path, axis, tool), fixed, allowed)


def merge_rows(path: OffsetPath, axis: Floats, rows: Ints) -> tuple[OffsetPath, Floats]:
    """Return the path with these ``rows`` (k,) of it, ascending, and their axes (k, 3): a move closes a gap
    where all moves did that are merged in it."""
    fill = np.logical_and.reduceat(path.fill, np.append(0, rows[:-1] + 1))
    return replace(keep_rows(path, rows), fill=fill), take_rows(axis, rows)


def _is_sharp(path: OffsetPath) -> Bools:
    """Find the rows (n,) at which the surface has a sharp edge: there normals jump."""
    return np.asarray(row_dot(path.before, path.after) < math.cos(CREASE))


@dataclass(frozen=True, eq=False)
class _PassRows:
    """The rows: ``straight`` points and ``hub`` (n, 3) mm; ``axis`` (n, 3); the ``normals`` (n, 3) of the
    surface; ``turned`` (n,) rad, the axis up to each row."""

    straight: Floats
    hub: Floats
    axis: Floats
    normals: tuple[Floats, ...]
    turned: Floats
    tool: ToolPoints

    @classmethod
    def of(cls, path: OffsetPath, axis: Floats, tool: ToolPoints) -> _PassRows:
        """Return the rows of a path, each array with its rows side by side in memory."""
        hub, axis, *normals = (
            np.ascontiguousarray(rows) for rows in (path.centre, axis, path.normal, path.before, path.after)
        )
        turned = np.append(0.0, np.cumsum(_angle(np.diff(axis, axis=0))))
        return cls(hub - tool.rise * axis, hub, axis, tuple(normals), turned, tool)

    def shares(self, begin: Ints, row: Ints, end: Ints, short: float) -> Floats:
        """How far (m,) along its span, 0 to 1, each row is: by its foot on the straight way; where that is
        ``short`` (mm), by the turn of the axis."""
        way = self.straight[end] - self.straight[begin]
        square, along = row_dot(way, way), row_dot(self.straight[row] - self.straight[begin], way)
        whole, part = self.turned[end] - self.turned[begin], self.turned[row] - self.turned[begin]
        goes = square > short * short
        over, whole = np.where(goes, along, part), np.where(goes, square, whole)
        return np.clip(np.divide(over, whole, out=np.zeros(len(row)), where=whole > 0.0), 0.0, 1.0)

    def misses(self, begin: Ints, row: Ints, end: Ints, allowed: Allowance) -> Floats:
        """How far each ``row`` (m,) is from the span between two others, as a share of what is allowed.

        A point of the tool within ``ring`` of the hub moves by no more than ``ring`` times the turn beside
        what the hub moves, so the corner circle's centre is off the surface by no more than both together.
        """
        share = self.shares(begin, row, end, allowed.off)
        axis = slerp(self.axis[begin], self.axis[end], share)
        part = share[:, None]
        straight = (1.0 - part) * self.straight[begin] + part * self.straight[end]
        off, lean = self.hub[row] - straight - self.tool.rise * axis, self.axis[row] - axis
        turn = _angle(lean)
        deep = np.max([np.abs(row_dot(off, normal[row])) for normal in self.normals], axis=0)
        swing = self.tool.ring * turn
        missed = np.maximum((deep + swing) / allowed.off, turn / allowed.turn)
        np.maximum(missed, (_length(off) + swing) / allowed.aside, out=missed)
        return np.asarray(np.maximum(missed, _length(off - self.tool.corner * lean) / allowed.tip))


def _length(rows: Floats) -> Floats:
    return np.asarray(np.sqrt(row_dot(rows, rows)))


def _angle(chord: Floats) -> Floats:
    """Angles (n,), rad, between unit vectors that differ by ``chord`` (n, 3)."""
    return np.asarray(2.0 * np.arcsin(np.clip(0.5 * _length(chord), 0.0, 1.0)))


def _keep(way: _PassRows, fixed: Bools, allowed: Allowance) -> Ints:
    """Return the rows (k,) that are kept: ``fixed`` (n,) ones, and others between which no further one can be
    left out.

    In each round every other row that is not settled yet is left out if all rows of the span that this makes
    are within the allowance, else it is settled: it stays. So each round settles or leaves out about half.
    Where rows are alike all spans end up as powers of two, so that they may be little longer than half of
    what would do; then two spans are laid in the place of three.
    """
    kept, settled = np.arange(len(fixed)), fixed
    while len(pick := _every_other(~settled)):
        out = _may_go(way, kept[pick - 1], kept[pick + 1], allowed)
        stays = np.ones(len(kept), np.bool_)
        stays[pick[out]] = False
        settled = settled.copy()
        settled[pick] = True
        kept, settled = kept[stays], settled[stays]
    for phase in range(3):
        kept = _lay_two_for_three(way, kept, fixed, phase, allowed)
    return kept


def _every_other(free: Bools) -> Ints:
    """Places (p,) of the first, third, fifth ... of each run of ``free`` (n,) ones."""
    place = np.arange(len(free))
    last = np.maximum.accumulate(np.where(free, -1, place))
    return np.flatnonzero(free & ((place - last) % 2 == 1))


def _lay_two_for_three(way: _PassRows, kept: Ints, fixed: Bools, phase: int, allowed: Allowance) -> Ints:
    """Return the rows (k,) with every three spans, from the one at ``phase`` on, made two where these are
    within the allowance: one row half-way instead of two."""
    first = np.arange(phase, len(kept) - 3, 3)
    first = first[~(fixed[kept[first + 1]] | fixed[kept[first + 2]])]
    begin, end = kept[first], kept[first + 3]
    middle = (begin + end) // 2
    fits = _may_go(way, np.append(begin, middle), np.append(middle, end), allowed).reshape(2, -1).all(axis=0)
    kept = kept.copy()
    kept[first[fits] + 1] = middle[fits]
    return np.delete(kept, first[fits] + 2)


def _may_go(way: _PassRows, begin: Ints, end: Ints, allowed: Allowance) -> Bools:
    """Find the spans (p,), from rows ``begin`` to rows ``end``, that no row between them misses by more than
    is allowed."""

    def look(part: slice) -> Bools:
        fits = np.ones(len(begin[part]), np.bool_)
        wide = np.flatnonzero(end[part] - begin[part] > 1)
        if len(wide):
            low, high = begin[part][wide], end[part][wide]
            count = high - low - 1
            first, span = np.cumsum(count) - count, run_ids(count)
            row = np.arange(len(span)) - first[span] + low[span] + 1
            missed = way.misses(low[span], row, high[span], allowed)
            fits[wide] = np.maximum.reduceat(missed, first) <= 1.0
        return fits

    return np.concatenate([np.zeros(0, np.bool_), *in_threads(look, chunks(len(begin), PORTION))])
