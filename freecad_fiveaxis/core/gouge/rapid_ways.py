# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep a tool can get into the part on a rapid whose axes run independently, with a bound that holds for
every way.

way       of a rapid whose rates are not known: each joint goes from its one end to its other and never back.
          Any words between the ends are on some way, so all ways together are a box of joints.
pair      a box, or a part of it, with a node of the facet tree, or with a facet. It is dropped when its bound
          says that nothing in it is deeper than asked for, or than what its block is known to hold already;
          else the larger partner is divided.

Most rapids go far over the part and are dropped whole, as one pair. What the tool meets is found as in
:mod:`.search`: depth and bound are brought together by division, across whatever adds most to the bound.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import NamedTuple, TypeVar

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.tool.body import Body, Piece

from .bounds import pare_piece, toward_box, toward_triangle
from .deepest import deepest, end_and_side, support_at
from .edges import along
from .joint_box import Hulls, JointBoxes, JointSpace
from .pairs import family, halves_of_facets
from .search import find_entries
from .swept_motion import still_positions

SLICE = 4096
"""Pairs at a time."""

ROUNDS = 100
"""Divisions of a pair; after that the bound is what it is."""

FEW_ROUNDS = 8
"""The same where it is only asked whether a rapid is clear: to divide it costs less than to prove what is
nearly not so."""

RELATIVE = 0.1
"""A depth is known to this share of itself, or to the accuracy asked for where that is more."""

EVEN_SHARE = 0.05
"""Of what a joint moves the tool so much counts as if it lay along the bound's direction: across it, it
loosens the bound too."""

ROUGH = 0.1
"""mm; so well is the depth of a sample known: the search that follows begins there."""

LONGER = 2.0
"""A box is divided where it is so many times as long as its node."""


@dataclass(frozen=True, eq=False)
class WayEntries:
    """Of each of m blocks: ``depth`` (m,) mm that a point of the part is in the body at some ``words`` (m,
    5), mm and **degrees**, between the block's ends, at ``place`` (m, 3) mm; 0 where no depth above the limit
    was found. ``bound`` (m,) mm: no point is deeper on any way; ``part`` (m,) CUTTER, SHANK or HOLDER."""

    depth: Floats
    bound: Floats
    words: Floats
    place: Floats
    part: Ints


class _Pairs(NamedTuple):
    """``boxes`` (n) with nodes ``node`` (n,); ``turns`` (n,): so often they were divided."""

    turns: Ints
    boxes: JointBoxes
    node: Ints

    def take(self, rows: Ints) -> _Pairs:
        return _Pairs(self.turns.take(rows), self.boxes.take(rows), self.node.take(rows))


class _FacetPairs(NamedTuple):
    """``boxes`` (n) with facets ``leaf`` (n,), or what is left of them, ``corner`` (3, 3, n) mm."""

    turns: Ints
    boxes: JointBoxes
    leaf: Ints
    corner: Floats

    def take(self, rows: Ints) -> _FacetPairs:
        return _FacetPairs(
            self.turns.take(rows), self.boxes.take(rows), self.leaf.take(rows), self.corner.take(rows, axis=2)
        )


def boxes_of(words: Floats, blocks: Ints) -> JointBoxes:
    """Lay a box over the ends of each of these blocks (k,); block i leads from row i to row i + 1 of
    ``words`` (m, 5), mm and **degrees**."""
    start, end = words[blocks], words[blocks + 1]
    return JointBoxes(blocks, 0.5 * (start + end), 0.5 * np.abs(end - start))


def find_way_entries(
    body: Body, tree: FacetTree, space: JointSpace, words: Floats, blocks: Ints, limit: float,
    accuracy: float,
    progress: Progress = silent,
) -> WayEntries:  # fmt: skip
    """Find the entries deeper than ``limit`` mm on any way of these ``blocks`` (k,) of a program's ``words``
    (m + 1, 5), mm and **degrees**; those of other blocks stay empty.

    None deeper than the limit is missed; depth and bound differ by at most ``accuracy`` mm or RELATIVE, but
    where ROUNDS divisions leave more.
    """
    search = _Search.of(body, tree, space, limit, accuracy, len(words) - 1)
    return search.find(boxes_of(words, blocks), progress)


def which_ways_enter(
    body: Body,
    tree: FacetTree,
    space: JointSpace,
    boxes: JointBoxes,
    limit: float,
    progress: Progress = silent,
) -> Bools:
    """Tell which of these boxes (k,), whose ``block`` is their place among them, are not proven, in
    FEW_ROUNDS divisions, to be entered by at most ``limit`` mm on every way; how deep is not asked."""
    search = _Search.of(body, tree, space, limit, np.inf, len(boxes.block), FEW_ROUNDS)
    return np.asarray(search.find(boxes, progress).bound > limit)


Some = TypeVar("Some", _Pairs, _FacetPairs)


@dataclass(frozen=True, eq=False)
class _Search:
    """``floors`` (m,) mm: what a pair of a block must be able to exceed. ``rounds``: a block of which a pair
    was divided so often is given up; it counts as entered to any depth."""

    body: Body
    tree: FacetTree
    space: JointSpace
    limit: float
    accuracy: float
    found: WayEntries
    floors: Floats
    rounds: float = np.inf

    @classmethod
    def of(
        cls, body: Body, tree: FacetTree, space: JointSpace, limit: float, accuracy: float, count: int,
        rounds: float = np.inf
    ) -> _Search:  # fmt: skip
        """Begin with nothing known of ``count`` blocks."""
        none = np.zeros(count)
        found = WayEntries(
            none, none.copy(), np.zeros((count, 5)), np.zeros((count, 3)), np.zeros(count, np.int64)
        )
        return cls(body, tree, space, limit, accuracy, found, np.full(count, limit), rounds)

    def find(self, boxes: JointBoxes, progress: Progress) -> WayEntries:
        """Find the entries of the blocks of these boxes."""
        turning = boxes.half[:, 3:].any(axis=1)
        order = np.argsort(turning, kind="stable")  # among themselves, boxes without a turn have one corner
        for first in range(0, len(order), SLICE):
            progress("gouge", first / len(order))
            self.run(boxes.take(order[first : first + SLICE]))
        block = boxes.block
        self.found.bound[block] = np.maximum(self.found.bound[block], self.floors[block])
        return self.found

    def run(self, boxes: JointBoxes) -> None:
        """Fill in the entries of these blocks."""
        self._sample(boxes)
        for piece in sorted(self.body.pieces, key=lambda piece: -piece.most):
            if piece.most + self.tree.most_allowance <= self.limit:
                continue
            none = np.zeros(len(boxes.block), np.int64)
            nodes, facets = _slice_pairs(_Pairs(none, boxes, none)), list[_FacetPairs]()
            while (
                nodes or facets
            ):  # facets first, the last first: what is found deep makes others superfluous, and few are open
                if facets:
                    for pairs in self._facets(piece, _take_slice(facets)):
                        facets += _slice_pairs(pairs)
                else:
                    *parts, found = self._nodes(piece, nodes.pop())
                    nodes += [some for part in parts for some in _slice_pairs(part)]
                    facets += _slice_pairs(found)

    def _sample(self, boxes: JointBoxes) -> None:
        """Look at the middle and the corners of boxes that reach the part: most of those that enter it are
        known at once."""
        none = np.zeros(len(boxes.block), np.int64)
        pairs, hulls = _Pairs(none, boxes, none), self.space.hulls(boxes, self.body.reach)
        enough = self.limit - self.tree.most_allowance
        rows = [self._open(piece, pairs, hulls) for piece in self.body.pieces if piece.most > enough]
        near = boxes.take(np.unique(np.concatenate([none[:0], *rows])))
        owner, words = _samples(near)
        still = still_positions(*(part.T for part in self.space.poses(words)))
        deep = find_entries(self.body, self.tree, still, self.limit, max(self.accuracy, ROUGH))
        self._note(near.block[owner], deep.part, words, deep.depth, deep.place)

    def _nodes(self, piece: Piece, pairs: _Pairs) -> tuple[_Pairs, _Pairs, _FacetPairs]:
        """Divide the pairs that may hold more than is known."""
        hulls = self.space.hulls(pairs.boxes, self.body.reach)
        rows = self._open(piece, pairs, hulls)
        rows = rows[~self._give_up(pairs.take(rows))]
        pairs, size = pairs.take(rows), hulls.size.take(rows, axis=0)
        leaf = pairs.node >= self.tree.leaf
        facets = pairs.take(np.flatnonzero(leaf))
        rows = np.flatnonzero(~leaf)
        pairs, size = pairs.take(rows), size[rows]
        by_box = size.sum(axis=1) > LONGER * self.tree.size.take(pairs.node)
        one, two = pairs.take(np.flatnonzero(by_box)), pairs.take(np.flatnonzero(~by_box))
        many = self.tree.arity.take(two.node)
        owner = np.repeat(np.arange(len(many)), many)
        halves = one.boxes.halve(size[by_box].argmax(axis=1))
        corner = self.tree.corners(facets.node - self.tree.leaf)
        return (
            _Pairs(
                two.turns.take(owner), two.boxes.take(owner), family(self.tree.child.take(two.node), many)
            ),
            _Pairs(np.tile(one.turns + 1, 2), halves, np.tile(one.node, 2)),
            _FacetPairs(facets.turns, facets.boxes, facets.node - self.tree.leaf, corner),
        )

    def _give_up(self, pairs: _Pairs | _FacetPairs) -> Bools:
        """Which of the pairs (n,) belong to blocks that are given up."""
        block = pairs.boxes.block
        self.floors[block[pairs.turns >= self.rounds]] = np.inf
        return np.isinf(self.floors[block])

    def _open(self, piece: Piece, pairs: _Pairs, hulls: Hulls) -> Ints:
        """Return the rows (k,) whose bounds are all above what is known; from the cheapest bound to the
        dearest."""
        core, off = self._core(piece)
        rows, floor = (
            np.arange(len(pairs.node)),
            self.floors.take(pairs.boxes.block) - off - self.tree.most_of(pairs.node),
        )
        most = np.full(len(rows), piece.most - off)
        for bound in (self._toward_node, self._along_box, self._along_normal):
            some = np.flatnonzero(most > floor.take(rows))
            rows, hulls = rows.take(some), hulls.take(some)
            most = np.minimum(most.take(some), bound(core, hulls, pairs.node.take(rows)))
        return rows.take(np.flatnonzero(most > floor.take(rows)))

    def _core(self, piece: Piece) -> tuple[Piece, float]:
        """Return what is left of the piece without the limit, and what was taken off; all of a piece that is
        no thicker than that."""
        return pare_piece(piece, self.limit if piece.most > self.limit else 0.0)

    def _toward_node(self, piece: Piece, hulls: Hulls, node: Ints) -> Floats:
        g, begins = toward_box(piece, hulls.pose.tip, hulls.pose.axis, self.tree.boxes(node))
        return hulls.compute_support(piece, g) - begins

    def _along_box(self, piece: Piece, hulls: Hulls, node: Ints) -> Floats:
        """Return the least of the bounds along the directions of the node's box: wide boxes of joints are
        beside it in one of them."""
        box = self.tree.boxes(node)
        arm = along(box.ways, box.middle - hulls.pose.tip)
        ways = zip(box.ways, arm, box.half, strict=True)
        bounds = [hulls.compute_support(piece, s * g) - s * a + h for g, a, h in ways for s in (1, -1)]
        return np.asarray(np.min(bounds, axis=0))

    def _along_normal(self, piece: Piece, hulls: Hulls, node: Ints) -> Floats:
        plate = self.tree.plates(node)
        place = (plate.normal * hulls.pose.tip).sum(axis=0)
        up = hulls.compute_support(piece, plate.normal) + place - plate.bottom
        down = hulls.compute_support(piece, -plate.normal) - place + plate.top
        return np.asarray(np.minimum(up, down))

    def _facets(self, piece: Piece, pairs: _FacetPairs) -> list[_FacetPairs]:
        """Note how deep the facets are in the middle of the boxes; divide what may hold more than is
        known."""
        more = self.tree.most_of(self.tree.leaf + pairs.leaf)
        rows = np.flatnonzero(
            ~self._give_up(pairs) & (piece.most > self.floors.take(pairs.boxes.block) - more)
        )
        pairs = pairs.take(rows)
        if not len(rows):
            return []
        more = self.tree.most_of(self.tree.leaf + pairs.leaf)
        hulls = self.space.hulls(pairs.boxes, self.body.reach)
        deep = deepest(piece, hulls.pose, pairs.corner)
        part = np.full(len(pairs.leaf), piece.part)
        self._note(pairs.boxes.block, part, pairs.boxes.middle, more - deep.distance, deep.point.T)
        arm = pairs.corner - hulls.pose.tip
        most, g = self._facet_bound(
            piece, hulls, arm, (deep.g, *self._directions(piece, hulls, pairs, deep.point, arm))
        )
        most = np.minimum(most, piece.most) + more
        flat = (
            support_at(piece, hulls.pose, g)
            - (g * hulls.pose.tip).sum(axis=0)
            - along(arm, g).min(axis=0)
            + deep.distance
        )
        flat[_longest_side(pairs.corner) < hulls.size.sum(axis=1)] = (
            0.0  # a short facet is not what makes the bound loose
        )
        open_ = most > self.floors.take(pairs.boxes.block)
        last = np.flatnonzero(open_ & (pairs.turns >= ROUNDS))
        np.maximum.at(self.found.bound, pairs.boxes.block[last], most[last])
        rows = np.flatnonzero(open_ & (pairs.turns < ROUNDS))
        spread = (hulls.spread(piece, g) + EVEN_SHARE * hulls.size)[rows]
        return _halves(pairs.take(rows), spread, flat[rows])

    def _directions(
        self, piece: Piece, hulls: Hulls, pairs: _FacetPairs, point: Floats, arm: Floats
    ) -> list[Floats]:
        normal = self.tree.plates(self.tree.leaf + pairs.leaf).normal
        core, _ = self._core(piece)
        found = [normal, -normal, toward_triangle(core, hulls.pose.axis, arm)[0]]
        return found if piece.round else [*found, *end_and_side(piece, hulls.pose, point)]

    def _facet_bound(
        self, piece: Piece, hulls: Hulls, arm: Floats, directions: tuple[Floats, ...]
    ) -> tuple[Floats, Floats]:
        """Return the least of the bounds (n,) mm along these directions (3, n), and the direction it is
        along."""
        most, best = np.full(arm.shape[2], np.inf), directions[0]
        for g in directions:
            bound = hulls.compute_support(piece, g) - along(arm, g).min(axis=0)
            best = np.where(bound < most, g, best)
            most = np.minimum(most, bound)
        return most, best

    def _note(self, block: Ints, part: Ints, words: Floats, depth: Floats, place: Floats) -> None:
        """Keep the deepest entry of each block, with its place; the columns are those of :class:`WayEntries`,
        ``block`` (n,)."""
        found = self.found
        rows = np.flatnonzero((depth > self.limit) & (depth > found.depth.take(block)))
        order = rows[
            np.argsort(depth[rows], kind="stable")
        ]  # where a block comes again, the deepest is written last
        at = block[order]
        found.depth[at], found.words[at], found.place[at], found.part[at] = (
            depth[order],
            words[order],
            place[order],
            part[order],
        )
        known = found.depth[at]
        self.floors[at] = known + np.maximum(self.accuracy, RELATIVE * known)


def _samples(boxes: JointBoxes) -> tuple[Ints, Floats]:
    """Give the middle and the corners of each box: whose they are (n,), and their words (n, 5) mm and
    **degrees**."""
    ends = np.array([np.zeros(5), *product((1.0, -1.0), repeat=5)])
    new = ~((ends[:, None] < 0.0) & (boxes.half == 0.0)).any(axis=2)  # a joint that stands has one end
    which, owner = np.nonzero(new)
    return owner, boxes.middle[owner] + ends[which] * boxes.half[owner]


def _halves(pairs: _FacetPairs, spread: Floats, flat: Floats) -> list[_FacetPairs]:
    """Each pair as two: its box halved across the joint that adds most to the bound, or its facet where that
    adds more."""
    by_box = spread.max(axis=1, initial=0.0) >= flat
    one, two = pairs.take(np.flatnonzero(by_box)), pairs.take(np.flatnonzero(~by_box))
    boxes, owner = one.boxes.halve(spread[by_box].argmax(axis=1)), np.tile(np.arange(len(one.leaf)), 2)
    same = two.take(np.tile(np.arange(len(two.leaf)), 2))
    halves = np.concatenate(halves_of_facets(two.corner), axis=2)
    return [
        _FacetPairs(same.turns + 1, same.boxes, same.leaf, halves),
        _FacetPairs(one.turns.take(owner) + 1, boxes, one.leaf.take(owner), one.corner.take(owner, axis=2)),
    ]


def _longest_side(corner: Floats) -> Floats:
    return np.asarray(np.sqrt(((corner - np.roll(corner, -1, axis=0)) ** 2).sum(axis=1).max(axis=0)))


def _take_slice(open_: list[_FacetPairs]) -> _FacetPairs:
    """Take the last of them from the list, as many as make a slice."""
    taken, count = [open_.pop()], 0
    while open_ and (count := count + len(taken[-1].leaf)) + len(open_[-1].leaf) <= SLICE:
        taken.append(open_.pop())
    boxes = JointBoxes(*(np.concatenate(part) for part in zip(*(one.boxes for one in taken), strict=True)))
    turns, leaf = (
        np.concatenate(part) for part in ([one.turns for one in taken], [one.leaf for one in taken])
    )
    return _FacetPairs(turns, boxes, leaf, np.concatenate([one.corner for one in taken], axis=2))


def _slice_pairs(pairs: Some) -> list[Some]:
    count = len(pairs.boxes.block)
    if count <= SLICE:
        return [pairs] if count else []
    return [pairs.take(np.arange(first, min(first + SLICE, count))) for first in range(0, count, SLICE)]
