# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cure that turns the tool: tilt its axis until shank, holder and, where that can help, the cutter are
free of the part.

offset    of a row: a vector across the given axis; its length (rad) says how far the axis is turned, its
          direction which way.
state     one of the offsets that a row may choose.
window    the rows near a block that enters, with rows put in between; no other row is touched.

The offsets of a run are those of the least ``sum of |offset|^2 ds + SPREAD^2 |change of offset|^2 / ds + a
penalty for every mm that enters``: the smallest tilt that frees, spread over the rows before and behind like
a strip that is pulled aside there and springs back. It is found by dynamic programming over a coarse fan of
states, then over ever finer ones about the offsets found. Whether a state enters is asked of whole blocks,
with both their ends in that state.

The contact stays; a cutter that is no ball sits anew. A run that the search does not better keeps its axes.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Angle, Length, Option, Point, say
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.known_depths import Entries
from freecad_fiveaxis.core.gouge.lift import AIM
from freecad_fiveaxis.core.gouge.search import find_entries, which_enter
from freecad_fiveaxis.core.gouge.swept_motion import SweptMotion, straight_motion
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.orientation.minimax.sweep import cheapest
from freecad_fiveaxis.core.passes import axes_within_limits
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import CUTTER, HOLDER, SHANK, Body, round_piece
from freecad_fiveaxis.core.toolpath.cl_offset import hub_positions, keep_rows, rows_between
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath, take_path_rows
from freecad_fiveaxis.core.toolpath.feed_direction import feed_direction

SPREAD = 5.0
"""mm, at least, over which a turn springs back by the factor e; the cutter's diameter where that is more."""

REACH, FINE = 4.0, 0.25
"""Of the spread: how far from what enters rows may turn, and how far apart the rows there are at most."""

RINGS, SPOKES = 3, 8
"""The first states: so many tilts, so many ways each."""

FINEST = math.radians(0.1)
"""rad; offsets are not searched more finely."""

ABOVE, OF_CUTTER = 1e3, 3e2
"""Penalties for a mm of the way on which shank or holder, or the cutter, enter, where a radian over a mm
costs 1."""

RESTLESS = 0.1
"""rad: what a turn of a ring cutter's contact about its bottom by a radian counts as."""

ROUGHLY = 0.1
"""mm; so well is known how deep what could not be freed is in the part."""

MARGIN = 0.05
"""mm by which shank and holder are to stay off the part: the machine's way is not quite the commanded one."""

TOGETHER = 4096
"""Rows worked on at a time, whole runs."""

SHORTEST = 0.02
"""Of the spread: blocks count as at least so long."""

LEAN = 1e-6
"""rad; what rounding may make of an axis that lies in the flank's plane."""


def tilt_free(
    path: OffsetPath, axis: Floats, cutter: Cutter, body: Body, tree: FacetTree, kinematics: Chain,
    max_tilt: float,
    tolerance: float, progress: Progress = silent, above: float = 0.0,
) -> tuple[OffsetPath, Floats]:  # fmt: skip
    """Return the path, with rows put in, and axes turned by at most ``max_tilt`` rad so that the body stays
    out of the part but for ``tolerance`` mm wherever that can be; findings say what was turned, and what
    could not be freed.

    ``axis`` (n, 3) unit, one for each row. Axes stay within the rotary limits of ``kinematics``. Where
    nothing enters that a tilt could free, the very path and axes given come back. ``above`` mm: how far over
    the tip the point lies that goes straight.
    """
    task = _Task(cutter, body, tree, kinematics, max_tilt, tolerance, max(cutter.diameter, SPREAD), above)
    hit = task.entering(path, axis)
    if not hit.any():
        return path, axis
    window = _near(path, hit, REACH * task.spread)
    pieces = np.ones(len(axis), np.int64)
    length = np.linalg.norm(np.diff(path.centre, axis=0), axis=1)
    cuts = np.flatnonzero(window & ~path.fill[1:])
    pieces[cuts + 1] = np.maximum(np.ceil(length[cuts] / (FINE * task.spread)), 1)
    fine, given, row = rows_between(path, axis, pieces, cutter.ring, cutter.barrel)
    window = window[row[1:] - 1] & (np.diff(fine.polyline) == 0)
    offset = _offsets(task, fine, given, window, progress)
    turned: Bools = np.asarray(offset.any(axis=1))
    beside = turned | np.append(False, turned[:-1]) | np.append(turned[1:], False)
    kept = np.flatnonzero(beside | np.append(row[1:] != row[:-1], True))
    fine, tilted = keep_rows(fine, kept), np.where(turned[:, None], _turn_axes(given, offset), given)[kept]
    fine, tilted, offset = (fine, tilted, offset[kept]) if turned.any() else (path, axis, np.zeros_like(axis))
    swept = straight_motion(task.tips(fine, tilted), tilted, above)
    joined = np.flatnonzero(np.diff(fine.polyline) == 0)
    left = find_entries(body.only(SHANK, HOLDER), tree, swept, tolerance, ROUGHLY, joined)
    findings = (*path.findings, *_findings(fine, offset, left, max_tilt))
    return replace(fine, findings=findings), tilted


class _Hits(NamedTuple):
    """Of blocks (m,), or of each state's (k, m): whether shank or holder enter, and whether the cutter
    does."""

    above: Bools
    cutter: Bools


@dataclass(frozen=True, eq=False)
class _Task:
    cutter: Cutter
    body: Body
    tree: FacetTree
    kinematics: Chain
    max_tilt: float
    tolerance: float
    spread: float
    above: float

    def tips(self, path: OffsetPath, axis: Floats) -> Floats:
        """Where the tips (n, 3) stand under these axes (n, 3)."""
        return np.asarray(
            hub_positions(path, axis, self.cutter.ring, self.cutter.barrel) - self.cutter.corner * axis
        )

    def entering(self, path: OffsetPath, axis: Floats) -> Bools:
        """Return the blocks (n - 1,) along the path under these axes (n, 3) where something enters that a
        tilt might free."""
        swept, joined = (
            straight_motion(self.tips(path, axis), axis, self.above),
            np.flatnonzero(np.diff(path.polyline) == 0),
        )
        hits = self.hits(swept, joined, self.hopeless(swept, joined))
        return np.asarray(hits.above | hits.cutter)

    def hopeless(self, swept: SweptMotion, blocks: Ints) -> Ints:
        """Those of the blocks where a ball itself enters: no axis frees that."""
        if self.cutter.ring > 0.0:
            return blocks[:0]
        ball = Body((round_piece(0.0, self.cutter.corner, self.cutter.corner),))
        return np.flatnonzero(which_enter(ball, self.tree, swept, AIM * self.tolerance, blocks))

    def hits(self, swept: SweptMotion, blocks: Ints, hopeless: Ints, margin: float = 0.0) -> _Hits:
        """Return what enters these blocks; ``hopeless``: where the cutter is not looked at; ``margin`` mm for
        shank and holder."""
        limit = self.tolerance
        above = tuple(
            piece._replace(round=piece.round + margin) for piece in self.body.only(SHANK, HOLDER).pieces
        )
        lower = which_enter(self.body.only(CUTTER), self.tree, swept, limit, np.setdiff1d(blocks, hopeless))
        return _Hits(which_enter(Body(above), self.tree, swept, limit, blocks), lower)


def _turn_axes(axis: Floats, offset: Floats) -> Floats:
    """Return unit axes (..., 3) turned by offsets (..., 3) across them."""
    angle = np.linalg.norm(offset, axis=-1, keepdims=True)
    return np.asarray(np.cos(angle) * axis + np.sinc(angle / np.pi) * offset)


def _near(path: OffsetPath, blocks: Bools, reach: float) -> Bools:
    """Return the blocks (n - 1,) within ``reach`` mm of the way, on their own polyline, of those marked."""
    step = np.linalg.norm(np.diff(path.centre, axis=0), axis=1)
    way = np.append(0.0, np.cumsum(step + (np.diff(path.polyline) != 0) * 4.0 * reach))
    at = np.flatnonzero(blocks)
    behind = np.searchsorted(at, np.arange(len(step)), side="right") - 1
    ahead = np.minimum(behind + 1, len(at) - 1)
    after = way[:-1] - way[at[np.maximum(behind, 0)] + 1]
    before = way[at[ahead]] - way[1:]
    near = ((behind >= 0) & (after <= reach)) | ((at[ahead] > np.arange(len(step))) & (before <= reach))
    return np.asarray(near & (np.diff(path.polyline) == 0))


def _offsets(task: _Task, path: OffsetPath, axis: Floats, window: Bools, progress: Progress) -> Floats:
    """Return the offsets (n, 3) of all rows, zero outside the ``window`` (n - 1,) of blocks; some runs at a
    time."""
    offset = np.zeros_like(axis)
    runs = np.unique(path.polyline[1:][window])
    rows = np.flatnonzero(np.isin(path.polyline, runs))
    start = np.flatnonzero(np.diff(path.polyline[rows], prepend=-1))
    part = start // TOGETHER
    for number, group in enumerate(np.split(start, np.flatnonzero(np.diff(part)) + 1)):
        end = np.append(start, len(rows))[np.searchsorted(start, group[-1]) + 1]
        some = rows[group[0] : end]
        run = _Runs.of(
            task, take_path_rows(path, some), axis[some], window[np.minimum(some, len(window) - 1)]
        )
        offset[some] = run.find_offsets(partial(_tell, progress, number, int(part[-1]) + 1))
    progress("tilt", 1.0)
    return offset


def _tell(progress: Progress, number: int, groups: int, share: float) -> None:
    progress("tilt", (number + share) / groups)


@dataclass(frozen=True, eq=False)
class _Runs:
    """Some whole runs: ``window`` blocks (w,), ``hopeless`` ones among them; ``weight`` (n - 1,) mm of each
    block; the ``frame`` (2, n, 3) across the axes; ``first`` and ``size`` (p,)."""

    task: _Task
    path: OffsetPath
    axis: Floats
    window: Ints
    hopeless: Ints
    weight: Floats
    frame: Floats
    first: Ints
    size: Ints

    @classmethod
    def of(cls, task: _Task, path: OffsetPath, axis: Floats, window: Bools) -> _Runs:
        """``window`` (n,): whether the block from each row on may turn."""
        step = np.linalg.norm(np.diff(path.centre, axis=0), axis=1)
        feed = feed_direction(path, axis)
        first = np.flatnonzero(np.diff(path.polyline, prepend=-1))
        blocks = np.flatnonzero(window[:-1] & (np.diff(path.polyline) == 0))
        hopeless = task.hopeless(straight_motion(task.tips(path, axis), axis, task.above), blocks)
        frame = np.stack([feed, np.cross(axis, feed)])
        weight = np.maximum(step, SHORTEST * task.spread)
        return cls(task, path, axis, blocks, hopeless, weight, frame, first, np.diff(first, append=len(axis)))

    def find_offsets(self, tell: Callable[[float], None]) -> Floats:
        """Return the offsets (n, 3); none in runs that are no freer by them."""
        most = self.task.max_tilt
        angle = np.arange(SPOKES) * (2.0 * np.pi / SPOKES)
        spokes = np.stack([np.cos(angle), np.sin(angle)])
        fan = np.concatenate(
            [np.zeros((2, 1)), *(spokes * most * (k + 1) / RINGS for k in range(RINGS))], axis=1
        )
        cross = np.stack(np.meshgrid([0.0, -1.0, 1.0], [0.0, -1.0, 1.0])).reshape(2, -1)
        step = 0.5 * most / RINGS
        rounds = max(math.ceil(math.log2(step / FINEST)), 0) + 1
        offset = np.zeros_like(self.axis)
        for k in range(rounds + 1):
            tell(k / (rounds + 1.0))
            states = fan if k == 0 else cross * step * 0.5 ** (k - 1)
            offset = self.choose_way(offset, states)
        return self.better(offset)

    def choose_way(self, offset: Floats, states: Floats) -> Floats:
        """Return the best way through ``offset`` (n, 3) and, about it, the ``states`` (2, k), of which the
        first is none."""
        tried = offset + np.einsum("ks,knc->snc", states, self.frame)
        size = np.linalg.norm(tried, axis=2)
        tried *= np.minimum(1.0, self.task.max_tilt / np.maximum(size, self.task.max_tilt))[:, :, None]
        axes = _turn_axes(self.axis, tried)
        axes /= np.linalg.norm(axes, axis=2, keepdims=True)
        entry = np.where(self.is_allowed(axes), (tried * tried).sum(axis=2) * self.share(self.weight), np.inf)
        tips = self.standing(axes)
        entry += self.penalty(tips, axes)
        state = cheapest(self.change(tried, tips, axes), entry, self.first, self.size)
        return np.asarray(tried[state, np.arange(len(state))])

    def standing(self, axes: Floats) -> Floats:
        """Tips (k, n, 3) under axes (k, n, 3)."""
        return np.stack([self.task.tips(self.path, axis) for axis in axes])

    def is_allowed(self, axes: Floats) -> Bools:
        """Which states (k, n) a row may take: none but the first outside the window, nor beyond the rotary
        limits, nor where the flank would lean into the facet."""
        count, n = axes.shape[:2]
        inner = np.zeros(n, np.bool_)
        inner[self.window] = inner[self.window + 1] = True
        good = axes_within_limits(self.task.kinematics, axes.reshape(-1, 3)).reshape(count, n) & inner
        good &= (axes * self.path.normal).sum(axis=2) >= math.sin(self.task.cutter.taper) - LEAN
        good[0] = True
        return np.asarray(good)

    def penalty(self, tips: Floats, axes: Floats) -> Floats:
        """Return what the entering blocks cost the rows (k, n) at their ends."""
        hits = self.hits(tips, axes)
        return self.share((ABOVE * hits.above + OF_CUTTER * hits.cutter) * self.weight)

    def hits(self, tips: Floats, axes: Floats) -> _Hits:
        """Of every block (k, n - 1) under each state."""
        count, n = axes.shape[:2]
        every = (np.arange(count) * n)[:, None]
        blocks, hopeless = (every + self.window).ravel(), (every + self.hopeless).ravel()
        swept = straight_motion(tips.reshape(-1, 3), axes.reshape(-1, 3), self.task.above)
        hits = self.task.hits(swept, blocks, hopeless, MARGIN)
        return _Hits(*(np.append(column, False).reshape(count, n)[:, :-1] for column in hits))

    def share(self, block: Floats) -> Floats:
        """Return what blocks (..., n - 1) give to the rows (..., n) at their ends, half each."""
        none = np.zeros((*block.shape[:-1], 1))
        return np.asarray(
            0.5 * (np.concatenate([block, none], axis=-1) + np.concatenate([none, block], axis=-1))
        )

    def change(self, offset: Floats, tips: Floats, axes: Floats) -> Floats:
        """Return the cost (k, k, n - 1) of going from state to state: of turning the axis, and the contact
        about a ring's bottom."""
        kind = offset
        if (ring := self.task.cutter.ring) > 0.0:
            seat = (tips + self.task.cutter.corner * axes - self.path.centre) / ring
            kind = np.concatenate([offset, RESTLESS * seat], axis=2)
        square = (kind * kind).sum(axis=2)
        both = np.matmul(kind[:, :-1].transpose(1, 0, 2), kind[:, 1:].transpose(1, 2, 0))
        apart = square[:, :-1].T[:, :, None] + square[:, 1:].T[:, None, :] - 2.0 * both
        return np.asarray(
            np.moveaxis(np.maximum(apart, 0.0) * (self.task.spread**2 / self.weight)[:, None, None], 0, -1)
        )

    def better(self, offset: Floats) -> Floats:
        """Return the offsets of the runs that enter over less of their way than without."""
        axes = np.stack([self.axis, _turn_axes(self.axis, offset)])
        summed = np.add.reduceat(self.penalty(self.standing(axes), axes), self.first, axis=1)
        return np.where(np.repeat(summed[1] < summed[0], self.size)[:, None], offset, 0.0)


def _findings(path: OffsetPath, offset: Floats, left: Entries, max_tilt: float) -> tuple[Finding, ...]:
    """How many rows were tilted and by how much at most; where shank or holder are not free all the same."""
    found, most = [], math.degrees(max_tilt)
    angle = np.degrees(np.linalg.norm(offset, axis=1))
    if angle.any():
        worst = int(angle.argmax())
        place = _place(path.point[worst])
        text = say(
            "The tool axis was tilted in {count} rows, most by {angle} at {place}, so that the tool stays "
            "out of the part.",
            count=np.count_nonzero(angle),
            angle=Angle(angle[worst], ".3g"),
            place=Point(place),
        )
        found.append(report_finding(Code.TILTED, text, float(angle[worst]), most, place=place))
    if left.depth.any():
        length = float(np.linalg.norm(np.diff(path.point, axis=0), axis=1)[left.depth > 0.0].sum())
        place = _place(left.place[int(left.depth.argmax())])
        text = say(
            "Over {length} of the passes no tilt of up to {most} keeps shank and holder out of the part, the "
            "deepest entry at {place}. Allow more tilt ({max_tilt}), use a longer tool, or leave these "
            "places out.",
            length=Length(length, ".4g"),
            most=Angle(most, ".4g"),
            place=Point(place),
            max_tilt=Option("max_tilt"),
        )
        found.append(report_finding(Code.NOT_FREED, text, length, 0.0, place=place))
    return tuple(found)


def _place(point: Floats) -> tuple[float, float, float]:
    x, y, z = point.tolist()
    return x, y, z
