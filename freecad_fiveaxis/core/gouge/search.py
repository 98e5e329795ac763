# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deepest entry of a body into the part in every block of a swept motion, with an upper bound for the
whole way.

pair      a cluster, or a stretch, with a node, or a facet. It is dropped when its bound says that nothing in
          it is deeper than asked for, or than what its block is known to hold already. Of the others the
          larger partner is divided.

Two trees are gone down together, so whole clusters are cleared of whole regions at once. What is left,
stretches with facets, is divided in time or across the facet until bound and depth are as near as asked for.

A facet with an allowance is that much deeper: depths in a convex piece and bounds of them grow by as much as
the piece does.
"""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.chunks import in_threads
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.tool.body import Body, Piece, grow_body

from .bounds import box_bound, facet_bound, least_depth, pare_piece, plate_bound
from .deepest import compute_needed_height, deepest, end_and_side, find_top, least_mixed, support_at
from .demanded_lift import demand_points, may_demand, raise_to_demand
from .swept_motion import Clusters, MotionSegments, Poses, SweptMotion, clusters_of, segments_of

BATCH = 8192
"""Blocks at a time: enough of them, and no more than a thread is done with in a second or two."""

FEW = 2048
"""Blocks that are not worth a second thread."""

SLICE = 49152
"""Pairs at a time: fewer stay in the cache of one thread, but two threads wait for each other between short
calls."""

AT_BOXES = 12288
"""Pairs whose boxes are looked at together: their columns stay in the cache, and memory that small is not
given back to the system and asked for anew at each step."""

ROUNDS = 40
"""Divisions of a pair; after that the bound is what it is."""

MOST_PAIRS = 2_000_000
"""Pairs of one batch beyond which the batch is halved."""

AT_ONCE = 32768
"""Stretches with facets that are divided together."""

FEW_AT_ONCE = 4096
"""Pairs whose demands are asked together."""

RELATIVE = 0.01
"""A depth is known to this share of itself, or to the accuracy asked for where that is more."""

PAUSE = 0.2
"""s between two words on how far the work is."""

SURELY = 0.999
"""Of a depth that is known to be reached, what is not lost by rounding."""

LONGER = 4.0
"""So many times smaller than a node a cluster may be and is divided all the same: bounds are close for
stretches."""

BENT = 0.3
"""Stretches bend at most by this share of the limit where MOST_PARTS allow."""


@dataclass(frozen=True, eq=False)
class Entries:
    """Of each of m blocks: ``depth`` (m,) mm that a point of the part is in the body at ``u`` (m,), at
    ``place`` (m, 3) mm, of facet ``facet`` (m,); all of it 0, facet -1, where no depth above the limit was
    found. ``bound`` (m,) mm: no point is deeper at any u; ``part`` (m,) CUTTER, SHANK or HOLDER."""

    depth: Floats
    bound: Floats
    u: Floats
    place: Floats
    facet: Ints
    part: Ints


def find_entries(
    body: Body, tree: FacetTree, swept: SweptMotion, limit: float, accuracy: float | None = None,
    blocks: Ints | None = None,
    progress: Progress = silent,
) -> Entries:  # fmt: skip
    """Return the entries deeper than ``limit`` mm in these ``blocks`` (k,), all where None is given; the
    others' stay empty.

    Depth and bound differ by at most ``accuracy`` mm (a tenth of the limit) or RELATIVE, but for blocks that
    bend too much.
    """
    m = len(swept)
    found = Entries(
        np.zeros(m), np.zeros(m), np.zeros(m), np.zeros((m, 3)), np.full(m, -1), np.zeros(m, np.int64)
    )
    wanted = np.arange(m) if blocks is None else blocks
    floors = np.full(m + 1, limit)
    search = _Search(
        tree,
        swept,
        limit,
        0.1 * limit if accuracy is None else accuracy,
        body.reach,
        found,
        np.zeros(m),
        floors,
    )
    search.batches(body, wanted, progress)
    progress("gouge", 1.0)
    found.bound[wanted] = np.maximum(found.bound[wanted], floors[wanted])
    return found


def which_enter(
    body: Body, tree: FacetTree, swept: SweptMotion, limit: float, blocks: Ints, progress: Progress = silent
) -> Bools:
    """Which blocks (m,) of the swept motion enter by more than ``limit`` mm, of these ``blocks`` (k,); how
    deep is not asked."""
    return np.asarray(find_entries(body, tree, swept, limit, np.inf, blocks, progress).bound > limit)


def find_demanded_lift(
    body: Body, tree: FacetTree, up: SweptMotion, limit: float, progress: Progress = silent
) -> Floats:
    """How far (m,) mm a body that stands still, or goes up along its axis, must go at least: the most that
    facets demand of which a point is in it by more than ``limit`` mm; 0 where none is. Points that
    :func:`raise_to_demand` misses may demand more."""
    m, lift = len(up), np.zeros(len(up))
    found = Entries(
        np.zeros(m), np.zeros(m), np.zeros(m), np.zeros((m, 3)), np.full(m, -1), np.zeros(m, np.int64)
    )
    search = _Search(tree, up, limit, np.inf, body.reach, found, np.zeros(m), np.full(m + 1, limit), lift)
    search.batches(body, np.arange(m), progress)
    return lift


class _Ticks:
    """Says how far the work is, a few times a second at most and on the thread that it was made on; where
    that is refused (:class:`~freecad_fiveaxis.core.base.errors.Cancelled`), other threads end at their next
    tick."""

    def __init__(self, progress: Progress) -> None:
        self.progress, self.caller, self.last = progress, threading.get_ident(), time.monotonic()
        self.share, self.refused = 0.0, False

    def __call__(self) -> None:
        if threading.get_ident() != self.caller:
            if self.refused:
                raise Cancelled(say("stopped"))
        elif time.monotonic() - self.last > PAUSE:
            self.last = time.monotonic()
            self.tell(self.share)

    def tell(self, share: float) -> None:
        """Say that this share of the work, 0 to 1, is done."""
        self.share = share
        try:
            self.progress("gouge", share)
        except BaseException:
            self.refused = True
            raise


class _Left(NamedTuple):
    """Pairs of stretches with facets, or parts of facets: ``block``, ``start``, ``end`` (n,), ``corner`` (3,
    3, n), ``leaf`` (n,)."""

    block: Ints
    start: Floats
    end: Floats
    corner: Floats
    leaf: Ints

    def take(self, rows: Ints | Bools) -> _Left:
        return _Left(
            self.block[rows], self.start[rows], self.end[rows], self.corner[..., rows], self.leaf[rows]
        )


class _Ways(NamedTuple):
    """The ways of pairs: poses at ``start`` and ``end``, what these leave the straight way by, ``bend`` mm
    and ``loose`` (n,), and how high above the tip their facets come, ``top`` (n,) mm."""

    start: Poses
    end: Poses
    bend: Floats
    loose: Floats
    top: Floats

    def take(self, rows: Ints) -> _Ways:
        start, end = (Poses(pose.tip[:, rows], pose.axis[:, rows]) for pose in (self.start, self.end))
        return _Ways(start, end, self.bend[rows], self.loose[rows], self.top[rows])


class _TooMany(Exception):
    """More pairs than memory should hold."""


@dataclass(frozen=True, eq=False)
class _Search:
    """``known`` (m,) mm: so deep a block is known to be, though not yet where; ``floors`` (m + 1,) mm: what a
    pair of a block must be able to exceed; that of a cluster, in the last place, is the limit. ``lift`` (m,)
    mm: what is demanded of blocks so far, where only that is asked. What is known of a block clears others of
    its pairs."""

    tree: FacetTree
    swept: SweptMotion
    limit: float
    accuracy: float
    reach: float
    found: Entries
    known: Floats
    floors: Floats
    lift: Floats | None = None

    def batches(self, body: Body, blocks: Ints, progress: Progress) -> None:
        """:meth:`batch` for any number of blocks, on all threads: what is found of one depends on none of
        another batch."""
        ticks = _Ticks(progress)
        count = 2 * -(-len(blocks) // (2 * BATCH)) if len(blocks) > FEW else min(len(blocks), 1)
        parts = np.array_split(blocks, count) if count else []
        in_threads(lambda some: self.batch(body, some, ticks), parts, ticks.tell)

    def batch(self, body: Body, blocks: Ints, ticks: _Ticks) -> None:
        """Fill in the entries of these blocks, or only the lift that they demand; ``ticks`` are called again
        and again."""
        deep = [piece for piece in body.pieces if piece.most + self.tree.most_allowance > self.limit]
        if not deep:  # no shank or holder was given: nothing to lay out for
            return
        parts = segments_of(self.swept, blocks, self.reach, BENT * self.limit)
        clusters = clusters_of(self.swept, parts, self.reach)
        try:
            for piece in sorted(
                deep, key=lambda piece: -piece.most
            ):  # what can be deeper makes the others superfluous
                left = self._traverse(piece, body, clusters, parts, ticks)
                if self.lift is None:
                    self._refine(piece, left, ticks)
                else:
                    self._demand(piece, body, left, self.lift)
        except _TooMany:
            half = len(blocks) // 2
            for some in (blocks[:half], blocks[half:]):
                self.batch(body, some, ticks)

    def _raise(self, block: Ints) -> None:
        """Work out the floors of these blocks anew."""
        placed, known = self.found.depth[block], self.known[block]
        if self.accuracy == np.inf:  # that it enters is all that is asked
            floor = np.where(np.maximum(placed, known) > 0.0, np.inf, self.limit)
        else:
            floor = np.maximum(self.limit, known)
            floor = np.where(
                placed > 0.0, np.maximum(floor, placed + np.maximum(self.accuracy, RELATIVE * placed)), floor
            )
        self.floors[block] = floor

    def _traverse(
        self, piece: Piece, body: Body, clusters: Clusters, parts: MotionSegments, ticks: _Ticks
    ) -> _Left:
        sweep, node = np.arange(clusters.top), np.zeros(clusters.top, np.int64)
        owner = np.concatenate([np.full(clusters.first, len(self.known)), parts.block])
        done: list[tuple[Ints, Ints]] = []
        while len(sweep):
            ticks()
            sweep, node, enters = self._prune_pairs(piece, body, clusters, owner, sweep, node)
            whole = (clusters.arity.take(sweep) == 0) & (node >= self.tree.leaf)
            done.append((sweep[whole] - clusters.first, node[whole]))
            sweep, node = _divide_pairs(clusters, self.tree, sweep[~whole], node[~whole], enters[~whole])
            if len(sweep) > MOST_PAIRS and len(parts.block) > 1 and parts.block[0] != parts.block[-1]:
                raise _TooMany
        segment, leaf = (np.concatenate(column) for column in zip(*done, strict=True))
        leaf = leaf - self.tree.leaf
        return _Left(
            parts.block[segment], parts.start[segment], parts.end[segment], self.tree.corners(leaf), leaf
        )

    def _prune_pairs(
        self, piece: Piece, body: Body, clusters: Clusters, owner: Ints, sweep: Ints, node: Ints
    ) -> tuple[Ints, Ints, Bools]:
        """Return the pairs that may hold more than is known, and which of them do enter; ``owner`` (n,) the
        place of their floors."""
        kept, deep = [], []
        for first in range(0, len(sweep), SLICE):
            some, place = sweep[first : first + SLICE], owner.take(sweep[first : first + SLICE])
            rows, enters = self._stay(piece, body, clusters, some, place, node[first : first + SLICE])
            kept.append(first + rows)
            deep.append(enters)
        rows = np.concatenate(kept)
        return sweep[rows], node[rows], np.concatenate(deep)

    def _stay(
        self, piece: Piece, body: Body, clusters: Clusters, sweep: Ints, place: Ints, node: Ints
    ) -> tuple[Ints, Bools]:
        """:meth:`_prune_pairs` for so many that two threads do not wait for each other: which rows stay."""
        core, off = pare_piece(piece, self.limit if piece.most > self.limit else 0.0)
        floor = self.floors.take(place) - off - self.tree.most_of(node)
        most = np.full(len(node), piece.most - off)
        for first in range(0, len(node), AT_BOXES):
            some = slice(first, first + AT_BOXES)
            most[some] = np.minimum(
                most[some], box_bound(core, clusters.ways(sweep[some]), self.tree, node[some])
            )
        rows = np.flatnonzero(most > floor)
        ways, node, floor, most = (
            clusters.ways(sweep.take(rows)),
            node.take(rows),
            floor.take(rows),
            most.take(rows),
        )
        demanded = None if self.lift is None or self.tree.allowance is not None else self.lift
        for bound in (plate_bound, facet_bound):
            most = np.minimum(most, bound(core, ways, self.tree, node))
            may = most > floor
            if demanded is not None and bound is plate_bound:
                may &= may_demand(body, ways, self.tree, node, np.append(demanded, -np.inf)[place.take(rows)])
            left = np.flatnonzero(may)
            rows, ways, node, floor, most = (
                rows.take(left),
                ways.take(left),
                node.take(left),
                floor.take(left),
                most.take(left),
            )
        least, place = (
            least_depth(piece, ways, self.tree.points(node)) + self.tree.least_of(node),
            place.take(rows),
        )
        if self.lift is None:
            self._learn(place, least)
        elif demanded is not None:
            deep = np.flatnonzero((least > self.limit) & (place < len(demanded)))
            demand_points(
                demanded, place.take(deep), body, ways.take(deep), self.tree.points(node.take(deep))
            )
        left = np.flatnonzero(most > self.floors.take(place) - off - self.tree.most_of(node))
        return rows.take(left), least.take(left) > self.limit

    def _learn(self, place: Ints, least: Floats) -> None:
        """Depths that are known to be reached, though not yet where."""
        deep = np.flatnonzero((least > self.limit) & (place < len(self.known)))
        if len(deep):
            block = place.take(deep)
            np.maximum.at(self.known, block, SURELY * least.take(deep))
            self._raise(block)

    def _demand(self, piece: Piece, body: Body, left: _Left, lift: Floats) -> None:
        """Raise ``lift`` (m,) to what the pairs demand, of a body grown by the allowance of their facets."""
        if self.tree.allowance is None:
            return self._demand_alike(piece, body, left, lift)
        more = self.tree.most_of(self.tree.leaf + left.leaf)
        for by in np.unique(more).tolist():
            self._demand_alike(
                piece._replace(round=piece.round + by), grow_body(body, by), left.take(more == by), lift
            )
        return None

    def _demand_alike(self, piece: Piece, body: Body, left: _Left, lift: Floats) -> None:
        """Raise ``lift`` (m,) to what the pairs demand, those that may demand most first: many others then
        cannot demand more."""
        start, low = self.swept.pose(left.block, left.start), min(one.low - one.round for one in body.pieces)
        most = ((left.corner - start.tip) * start.axis).sum(axis=1).max(axis=0) - low
        order = np.argsort(-most, kind="stable")
        for first in range(0, len(order), FEW_AT_ONCE):
            rows = order[first : first + FEW_AT_ONCE]
            rows = rows[most[rows] > lift.take(left.block[rows])]
            if len(rows):
                some, pose = left.take(rows), Poses(start.tip[:, rows], start.axis[:, rows])
                way = ((self.swept.pose(some.block, some.end).tip - pose.tip) * pose.axis).sum(axis=0)
                raise_to_demand(lift, some.block, piece, body, pose, way, some.corner, self.limit)

    def _refine(self, piece: Piece, left: _Left, ticks: _Ticks) -> None:
        """Refine the depth of the pairs, some of each block at a time: what they tell makes many of the
        others superfluous."""
        parts = -(-len(left.block) // AT_ONCE)
        for k in range(parts):
            rows = np.arange(k, len(left.block), parts)
            some = left.take(rows)
            rows = np.flatnonzero(piece.most > self.floors.take(some.block) - self._more(some))
            self._refine_some(piece, some.take(rows), ticks)

    def _more(self, left: _Left) -> Floats | float:
        """Return the allowance (n,) mm of the facets of pairs."""
        return self.tree.most_of(self.tree.leaf + left.leaf)

    def _refine_some(self, piece: Piece, left: _Left, ticks: _Ticks) -> None:
        for _ in range(ROUNDS):
            ticks()
            left, ways = self._above_bottom(piece, left)
            if not len(left.block):
                return
            middle = 0.5 * (left.start + left.end)
            pose = self.swept.pose(left.block, middle)
            deep, more = deepest(piece, pose, left.corner), self._more(left)
            self._note(piece, left, middle, more - deep.distance, deep.point)
            most, in_time, half_way = self._most(piece, left, ways, pose, deep.point, deep.g)
            rows = np.flatnonzero(np.minimum(most, piece.most) > self.floors.take(left.block) - more)
            left, most = left.take(rows), most[rows]
            if len(rows) > MOST_PAIRS:
                break
            across = (half_way + deep.distance)[rows]
            left, most = _halve_pairs(left, in_time[rows] >= across), np.tile(most, 2)
        np.maximum.at(self.found.bound, left.block, most + self._more(left))

    def _above_bottom(self, piece: Piece, left: _Left) -> tuple[_Left, _Ways]:
        """Return the pairs without those that stay below the bottom of the piece, and their ways: a level
        bottom turns with the tool, so no direction that stands still is close under it."""
        start, end = self.swept.pose(left.block, left.start), self.swept.pose(left.block, left.end)
        share = 0.125 * (left.end - left.start) ** 2
        bend, loose = share * self.swept.bend_tip[left.block], share * self.swept.bend_axis[left.block]
        ways = _Ways(start, end, bend, loose, find_top(start, end, left.corner, bend, loose))
        if piece.low_radius == 0.0:
            return left, ways
        most = ways.top - piece.low + piece.round
        rows = np.flatnonzero(most > self.floors.take(left.block) - self._more(left))
        return left.take(rows), ways.take(rows)

    def _most(
        self, piece: Piece, left: _Left, ways: _Ways, pose: Poses, point: Floats, g: Floats
    ) -> tuple[Floats, Floats, Floats]:
        """Return the bound (n,) mm over the stretch; along g, how much of it comes from the way between the
        poses, and what is left half-way.

        Only along g do both shrink as the pair is divided; the normal's bound may be the better one, but it
        does not become better.
        """
        start, end, bend, loose, top = ways
        high = compute_needed_height(piece, top)

        def compute_bounds(g: Floats) -> tuple[Floats, Floats, Floats]:
            over = np.maximum(*(support_at(piece, there, g, loose, high) for there in (start, end))) + bend
            begins, half_way = (
                (g * left.corner).sum(axis=1).min(axis=0),
                support_at(piece, pose, g, high=high),
            )
            return over - begins, over - half_way, half_way - begins

        most, in_time, flat = compute_bounds(g)
        normal = self.tree.plates(self.tree.leaf + left.leaf).normal
        for direction in (normal, -normal):
            most = np.minimum(most, compute_bounds(direction)[0])
        if piece.round == 0.0:
            ends = []
            for g in end_and_side(piece, pose, point):
                begins = (g * left.corner).sum(axis=1)
                ends.append(
                    np.concatenate(
                        [support_at(piece, there, g, loose, high) + bend - begins for there in (start, end)]
                    )
                )
            most = np.minimum(most, least_mixed(*ends))
        if piece.low_radius > 0.0:
            most = np.minimum(most, top - piece.low + piece.round)
        return most, in_time, flat

    def _note(self, piece: Piece, left: _Left, u: Floats, depth: Floats, point: Floats) -> None:
        """Keep the deepest entry of each block, with its place."""
        found = self.found
        rows = np.flatnonzero((depth > self.limit) & (depth > found.depth.take(left.block)))
        if not len(rows):
            return
        order = rows[
            np.argsort(depth[rows], kind="stable")
        ]  # where a block comes again, the deepest is written last
        block = left.block[order]
        found.depth[block], found.u[block], found.place[block] = depth[order], u[order], point.T[order]
        found.facet[block], found.part[block] = self.tree.facet[left.leaf[order]], piece.part
        self._raise(block)


def _divide_pairs(
    clusters: Clusters, tree: FacetTree, sweep: Ints, node: Ints, enters: Bools
) -> tuple[Ints, Ints]:
    """Return the larger partner of each pair replaced by its children; the cluster where it does enter,
    because only blocks can tell that they know of deeper places."""
    by_way = clusters.arity.take(sweep) > 0
    by_way &= enters | (node >= tree.leaf) | (LONGER * clusters.size.take(sweep) > tree.size.take(node))
    one, two = np.flatnonzero(by_way), np.flatnonzero(~by_way)
    first, count = clusters.child.take(sweep[one]), clusters.arity.take(sweep[one])
    below, many = tree.child.take(node[two]), tree.arity.take(node[two])
    ways = np.concatenate([family(first, count), np.repeat(sweep[two], many)])
    nodes = np.concatenate([np.repeat(node[one], count), family(below, many)])
    return ways, nodes


def family(first: Ints, count: Ints) -> Ints:
    """List the numbers (sum of count,) from each ``first`` on, ``count`` of each (k,)."""
    head = np.cumsum(count) - count
    return np.asarray(np.arange(int(count.sum())) + np.repeat(first - head, count))


def _halve_pairs(left: _Left, in_time: Bools) -> _Left:
    """Each pair as two: the first and the second half of its stretch, or the facet parted across its longest
    side."""
    middle = 0.5 * (left.start + left.end)
    start = np.concatenate([left.start, np.where(in_time, middle, left.start)])
    end = np.concatenate([np.where(in_time, middle, left.end), left.end])
    one, two = halves_of_facets(left.corner)
    corner = np.concatenate(
        [np.where(in_time, left.corner, one), np.where(in_time, left.corner, two)], axis=2
    )  # fmt: skip
    return _Left(np.tile(left.block, 2), start, end, corner, np.tile(left.leaf, 2))


def halves_of_facets(corner: Floats) -> tuple[Floats, Floats]:
    """Part each facet, corners (3, 3, n) mm, in the middle of its longest side: both halves, shaped alike."""
    side = ((corner - np.roll(corner, -1, axis=0)) ** 2).sum(axis=1)
    longest, at = side.argmax(axis=0), np.arange(corner.shape[2])
    a, b, c = (corner[(longest + k) % 3, :, at].T for k in range(3))
    middle = 0.5 * (a + b)
    return np.stack([a, middle, c]), np.stack([middle, b, c])
