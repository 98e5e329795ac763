# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cure that keeps the passes: lift the tool along its axis until the cutter touches and no longer enters.

A row is lifted by the most that any facet in the cutter demands, then by what takes the deepest point that is
left out of it, as often as one is left: each of these lifts is demanded by a point, so the sum is never more
than the part demands. Then the blocks between the rows are checked. Where one enters between two rows that do
not, a row is put in at its deepest place and lifted in its turn.

lifted    a row that was moved. Only rows on the part are: ends of cuts and fills. Links and rapids stay.
aim       what a lifted cutter may still enter by: half the tolerance, so that the machine's way, which leaves
          the commanded one, does not use it up. What enters by more than the aim is lifted; a cutter with a
          ring rocks from facet to facet of a smooth surface by some of the tolerance, so nothing of its path
          is lifted unless some of it enters by more than that.
overhang  what is over the tool. Rows under it from which a lifted one beside them cannot be reached are
          lifted above it, and rows under it up to where a cut begins or ends, for the tool leaves and comes
          along its axis there.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, Point, say
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.search import find_demanded_lift, find_entries, which_enter
from freecad_fiveaxis.core.gouge.swept_motion import SweptMotion, still_positions, straight_motion
from freecad_fiveaxis.core.tool.body import CUTTER, Body, way_out
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .overhang import is_under, rise_above, under_with

AIM = 0.5
"""Of the tolerance."""

ROOM = 0.8
"""Of the aim: what a row that is lifted may still enter by. Blocks between such rows that are shorter than
the rest cannot enter by more than the aim, so putting in rows comes to an end."""

GRAZE = 0.1
"""Of the tolerance: entries of a ball below this are none. A level bottom that lies on facets would take long
to know so well."""

LIFTS = 200
"""Lifts of one row, each to the next point that is too deep."""

ROUNDS = 24
"""Times that rows are put in; each about halves the way between them where it must."""

ROUGHLY = 0.1
"""mm; so near to the deepest point is near enough to lift by. That nothing is deeper than the aim is known
all the same."""

STILL_MM = 1e-6
"""mm; a link move that is no longer than this goes nowhere: the next cut goes on from the same place."""

INNER = 0.05
"""Of a block: a row put in at its deepest place is at least so far from its ends."""

SHORT = 0.1
"""Of the cutter's thickness: rows put in only to stay low do not come nearer to each other."""

OVERHANGS = 8
"""Times that rows under overhangs are lifted above them; each may open the way to others."""

FEW = 1000
"""Rows that may be put in however few were given."""

MOST_ROWS = 8
"""Times as many rows as were given, beyond which no more are put in."""


@dataclass(frozen=True, eq=False)
class Lifted:
    """``path``: the very path given where nothing was to be lifted. ``row`` (n,): the row of the path given
    that each row is, or leads to; ``lift`` (n,) mm that it was moved along its axis (of rows put in: off the
    lifted way); ``left`` mm: no cut of the path enters by more than that, but for GRAZE and rocking."""

    path: CLPath
    row: Ints
    lift: Floats
    left: float


NO_ROWS = np.zeros(0, np.int64)


def lift_path(
    path: CLPath, tree: FacetTree, body: Body, tolerance: float, back: float = 0.0,
    progress: Progress = silent,
    above: float = 0.0, aside: Ints = NO_ROWS,
) -> Lifted:  # fmt: skip
    """Return the path with the cutter lifted out of the part, so that it is nowhere deeper in than half of
    ``tolerance`` mm.

    ``back`` mm: how far above the tip the point lies that the path gives; ``above`` mm: the one
    that goes straight; ``aside`` (k,): rows that the tool comes to and leaves across its axis, whatever is
    over them. Shank and holder are not looked at.
    """
    cutter, aim = body.only(CUTTER), AIM * tolerance
    tips = path.tip - back * path.axis
    cuts = np.isin(path.motion[1:], (Motion.CUT, Motion.FILL))
    swept, blocks = straight_motion(tips, path.axis, above), np.flatnonzero(cuts)
    going = _Going(progress)
    lifter, none = (
        _Lifter(swept, cutter, tree, aim, tolerance, going, above, aside),
        np.zeros(len(tips), np.bool_),
    )
    way = _LiftedPath(
        tips, path.axis, np.arange(len(tips), dtype=float), np.zeros(len(tips)), cuts, none[1:], none
    )
    trapped = len(lifter.find_trapped(way)) > 0
    rocks = min(cutter.pieces, key=lambda piece: piece.low - piece.round).low_radius > 0.0
    if rocks and not trapped and not which_enter(cutter, tree, swept, tolerance, blocks, going).any():
        return Lifted(path, np.arange(len(path.tip)), np.zeros(len(path.tip)), 0.0)
    limit, accuracy = (aim, ROUGHLY) if rocks else (GRAZE * tolerance, None)
    first = find_entries(cutter, tree, swept, limit, accuracy, blocks, going.stage(0.0, 0.2))
    deep = (first.depth > 0.0) & (first.bound > aim)
    if not deep.any() and not trapped:
        left = float(first.bound[first.depth > 0.0].max(initial=0.0))
        return Lifted(path, np.arange(len(path.tip)), np.zeros(len(path.tip)), left)
    touched = np.append(deep, False) | np.append(False, deep)
    tip, axis, lift, rows = tips.copy(), path.axis.copy(), np.zeros(len(tips)), np.flatnonzero(touched)
    going.stage(0.2, 0.4)
    tip[rows], axis[rows], _, lift[rows], _ = lifter.rows(rows.astype(float))
    way = replace(way, tip=tip, axis=axis, lift=lift)
    going.stage(0.4, 0.6)
    way = lifter.lower(way, SHORT * max(piece.most for piece in cutter.pieces), tolerance)
    dirty = (way.lift[1:] > 0.0) | (way.lift[:-1] > 0.0) | deep[way.key[:-1].astype(np.int64)]
    going.stage(0.6, 0.8)
    way = lifter.out_of_overhangs(lifter.between(way, way.cuts & dirty))
    progress("lift", 1.0)
    findings = (*path.findings, *_findings(path, way))
    return Lifted(replace(_rows(path, way, back), findings=findings), _row(way), way.lift, aim)


class _Going:
    """What the many searches tell that they go on: how much of the lifting is done, never less than
    before."""

    def __init__(self, progress: Progress) -> None:
        self._progress, self._stage, self._low, self._high, self._done = progress, (0.0, 0.0), 0.0, 0.0, 0.0

    def stage(self, low: float, high: float) -> _Going:
        """Return what comes next takes the whole from ``low`` to ``high``."""
        self._stage = low, high
        self.round(0, 1)
        return self

    def round(self, k: int, count: int) -> None:
        """Round k of at most ``count`` of the stage."""
        low, high = self._stage
        self._low, self._high = low + k * (high - low) / count, low + (k + 1) * (high - low) / count

    def __call__(self, _stage: str, fraction: float) -> None:
        self._done = max(self._done, self._low + fraction * (self._high - self._low))
        self._progress("lift", self._done)


@dataclass(frozen=True, eq=False)
class _LiftedPath:
    """Tips, axes (n, 3); ``key`` (n,) where each stands on the way given, block + u; its lift off that way;
    ``cuts`` (n - 1,): which blocks cut, ``clear`` (n - 1,): which are known to enter by no more than the aim,
    but for GRAZE; ``over`` (n,) rows that were lifted above an overhang."""

    tip: Floats
    axis: Floats
    key: Floats
    lift: Floats
    cuts: Bools
    clear: Bools
    over: Bools


class _Rows(NamedTuple):
    """Rows (k,) of a way, columns as in :class:`_LiftedPath`."""

    tip: Floats
    axis: Floats
    key: Floats
    lift: Floats
    over: Bools

    def take(self, rows: Ints) -> _Rows:
        return _Rows._make(column[rows] for column in self)


@dataclass(frozen=True, eq=False)
class _Lifter:
    """``given``: the way before anything is lifted; ``aim`` mm, what may be left of an entry; ``tolerance``
    mm, what a link may enter by; ``going`` is told that it goes on; ``above`` mm: how far over the tip the
    point lies that goes straight; ``aside`` as in :func:`lift_path`."""

    given: SweptMotion
    cutter: Body
    tree: FacetTree
    aim: float
    tolerance: float
    going: _Going
    above: float
    aside: Ints

    def find_trapped(self, way: _LiftedPath) -> Ints:
        """Return the rows (k,) where cuts begin or end and the way up, along which the tool comes or leaves,
        meets the part. Where the next cut goes on from the same place nothing comes or leaves."""
        link_moves = np.flatnonzero(~way.cuts & (np.abs(np.diff(way.tip, axis=0)).max(axis=1) > STILL_MM))
        cut = np.append(way.cuts, False) | np.append(False, way.cuts)
        ends: Ints = np.unique(np.concatenate([link_moves, link_moves + 1]))
        ends = ends[cut[ends]]
        ends = ends[~np.isin(way.key[ends], self.aside)]
        under = is_under(self.cutter, self.tree, way.tip[ends], way.axis[ends], self.tolerance, self.going)
        return ends[under]

    def rows(self, key: Floats, beside: Bools | None = None) -> _Rows:
        """Return the rows at these places (k,), lifted until the cutter is nowhere deeper in than ROOM of the
        aim; those that stand ``beside`` (k,) rows above an overhang until nothing of the part is over them,
        either."""
        block = np.minimum(key.astype(np.int64), len(self.given) - 1)
        pose = self.given.pose(block, key - block)
        tip, axis = pose.tip.T.copy(), pose.axis.T.copy()
        start, left = tip.copy(), np.arange(len(key))
        for _ in range(LIFTS):
            self._lift_by_demand(tip, axis, left)
            still = still_positions(tip[left], axis[left])
            entries = find_entries(
                self.cutter, self.tree, still, ROOM * self.aim, ROUGHLY, progress=self.going
            )
            deep = np.flatnonzero(entries.depth > 0.0)
            if not len(deep):
                break
            left = left[deep]
            more = self.tree.allowance_of(entries.facet[deep])
            by = way_out(self.cutter, tip[left], axis[left], entries.place[deep], more)
            tip[left] += np.maximum(by, 0.5 * self.aim)[:, None] * axis[left]
        rise = np.zeros(len(key))
        near = np.flatnonzero(beside) if beside is not None else left[:0]
        rise[near] = self._rise(tip[near], axis[near])
        tip += rise[:, None] * axis
        return _Rows(tip, axis, key, ((tip - start) * axis).sum(axis=1), rise > 0.0)

    def _lift_by_demand(self, tip: Floats, axis: Floats, left: Ints) -> None:
        """Tips (n, 3) mm of the rows ``left`` (k,) moved up their axes (n, 3) until facets demand no more."""
        for _ in range(LIFTS):
            by = find_demanded_lift(
                self.cutter, self.tree, still_positions(tip[left], axis[left]), ROOM * self.aim, self.going
            )
            left, by = left[by > 0.0], by[by > 0.0]
            if not len(left):
                break
            tip[left] += np.maximum(by, 0.5 * self.aim)[:, None] * axis[left]

    def _rise(self, tip: Floats, axis: Floats) -> Floats:
        return rise_above(self.cutter, self.tree, tip, axis, ROOM * self.aim, self.going)

    def lower(self, way: _LiftedPath, least: float, tolerance: float) -> _LiftedPath:
        """Rows put in where the way between two lifted rows stands more than ``tolerance`` mm higher than it
        must; blocks of up to ``least`` mm stay whole."""
        wait = np.ones(len(way.cuts), np.bool_)
        for k in range(ROUNDS):
            self.going.round(k, ROUNDS)
            long = np.linalg.norm(np.diff(way.tip, axis=0), axis=1) > least
            blocks = np.flatnonzero(
                way.cuts & wait & long & (np.maximum(way.lift[1:], way.lift[:-1]) > tolerance)
            )
            rows = self.rows(0.5 * (way.key[blocks] + way.key[blocks + 1]))
            high = np.flatnonzero(0.5 * (way.lift[blocks] + way.lift[blocks + 1]) - rows.lift > tolerance)
            if not len(high):
                break
            way, wait = _put_in(way, blocks[high], rows.take(high))
        return way

    def between(self, way: _LiftedPath, dirty: Bools) -> _LiftedPath:
        """Rows put in, and lifted, where blocks marked ``dirty`` (n - 1,) enter between their ends; not where
        these are too near to each other for that: what enters there goes up through the part, and no row
        between helps."""
        given, least = len(way.tip), (1.0 - ROOM) * self.aim
        for k in range(ROUNDS):
            self.going.round(k, ROUNDS)
            blocks = np.flatnonzero(dirty)
            length = _aside(way, blocks)
            blocks, length = blocks[length > least], length[length > least]
            swept = straight_motion(way.tip, way.axis, self.above, blocks)
            entries = find_entries(self.cutter, self.tree, swept, self.aim, ROUGHLY, progress=self.going)
            clear, enters = way.clear.copy(), entries.depth > 0.0
            clear[blocks] |= ~enters & (entries.bound <= self.aim + GRAZE * self.tolerance)
            way = replace(way, clear=clear)
            blocks, length, u = blocks[enters], length[enters], entries.u[enters]
            if not len(blocks) or len(way.tip) > MOST_ROWS * given + FEW:
                break
            inner = np.minimum(u, 1.0 - u)
            deepest = (k % 2 == 0) & (inner > INNER) & (inner * length > least)
            u = np.where(deepest, u, 0.5)  # before a wall only halving comes near it
            key = way.key[blocks] + u * (way.key[blocks + 1] - way.key[blocks])
            way, dirty = _put_in(way, blocks, self.rows(key, way.over[blocks] | way.over[blocks + 1]))
        return way

    def out_of_overhangs(self, way: _LiftedPath) -> _LiftedPath:
        """Where blocks to a lifted row still enter, the rows on their other side lifted above what is over
        them; so are those about trapped ends."""
        for k in range(OVERHANGS):
            low = 0.8 + 0.2 * k / OVERHANGS
            self.going.stage(low, low + 0.1 / OVERHANGS)
            high = self._under(way)
            if not high.any():
                break
            rise = np.zeros(len(way.tip))
            rise[high] = self._rise(way.tip[high], way.axis[high])
            if not rise.any():
                break
            moved = (rise[1:] > 0.0) | (rise[:-1] > 0.0)
            over, clear = way.over | high, way.clear & ~moved
            way = replace(
                way, tip=way.tip + rise[:, None] * way.axis, lift=way.lift + rise, over=over, clear=clear
            )
            self.going.stage(low + 0.1 / OVERHANGS, low + 0.2 / OVERHANGS)
            way = self.between(way, way.cuts & moved)
        return way

    def _under(self, way: _LiftedPath) -> Bools:
        """Return the rows (n,) from which the way up meets the part, in unbroken groups beside blocks to
        lifted rows that enter, or up to trapped ends."""
        lifted = np.flatnonzero(way.cuts & ~way.clear & ((way.lift[1:] > 0.0) | (way.lift[:-1] > 0.0)))
        swept, each = straight_motion(way.tip, way.axis, self.above, lifted), np.arange(len(lifted))
        blocks = lifted[which_enter(self.cutter, self.tree, swept, self.aim, each, self.going)]
        beside = blocks + (way.lift[blocks] > way.lift[blocks + 1])
        rows = np.concatenate([beside, self.find_trapped(way)])
        return under_with(self.cutter, self.tree, way.tip, way.axis, way.cuts, rows, self.aim, self.going)


def _aside(way: _LiftedPath, blocks: Ints) -> Floats:
    """How far (k,) mm the tool goes at most in each of these blocks (k,), but for what it is lifted: along
    the way given, and by the turn of its axis at its height above that."""
    (start, first, low), (end, last, high) = (
        (way.tip[rows], way.axis[rows], way.lift[rows]) for rows in (blocks, blocks + 1)
    )
    given = np.linalg.norm((end - high[:, None] * last) - (start - low[:, None] * first), axis=1)
    return np.asarray(given + np.maximum(high, low) * np.linalg.norm(last - first, axis=1))


def _put_in(way: _LiftedPath, blocks: Ints, rows: _Rows) -> tuple[_LiftedPath, Bools]:
    """Return the way with one of the rows (k,) in each of these blocks (k,), and which blocks are new."""
    cuts = np.insert(way.cuts, blocks, True)
    new, row = np.zeros(len(cuts), np.bool_), np.arange(1, len(blocks) + 1) + blocks
    new[row - 1] = new[row] = True
    put = {
        name: np.insert(getattr(way, name), blocks + 1, column, axis=0)
        for name, column in rows._asdict().items()
    }
    return _LiftedPath(cuts=cuts, clear=np.insert(way.clear, blocks, False) & ~new, **put), new


def _row(way: _LiftedPath) -> Ints:
    """Return the row (n,) of the path given that each row of the way is, or leads to."""
    return np.ceil(way.key).astype(np.int64)


def _rows(path: CLPath, way: _LiftedPath, back: float) -> CLPath:
    """Return the path with the rows of the way: those put in take face, normal and feed from the row that
    they lead to."""
    columns = {
        name: getattr(path, name)[_row(way)]
        for name in ("motion", "feed", "contact", "normal", "face", "coedge", "pass_")
    }
    return replace(path, tip=way.tip + back * way.axis, axis=way.axis, **columns)


def _findings(path: CLPath, way: _LiftedPath) -> tuple[Finding, ...]:
    """Return what was lifted, over which length, and where most."""
    if not (way.lift > 0.0).any():
        return ()
    worst = int(way.lift.argmax())
    blocks = way.cuts & ((way.lift[1:] > 0.0) | (way.lift[:-1] > 0.0))
    length = float(np.linalg.norm(np.diff(way.tip, axis=0), axis=1)[blocks].sum())
    x, y, z = path.contact[_row(way)[worst]].tolist()
    text = say(
        "The tool was lifted over {length} of the passes, most at {place}: by {lift} along its axis. What no "
        "other pass cuts there stays. Cut these places with a smaller cutter or another tool axis.",
        length=Length(length, ".4g"),
        place=Point((x, y, z), ".6g"),
        lift=Length(way.lift[worst], ".4g"),
    )
    return (report_finding(Code.LIFTED, text, float(way.lift[worst]), 0.0, place=(x, y, z)),)
