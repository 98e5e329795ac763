# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stretches with facets, divided in time or across the facet until depth and bound are as near as asked for;
and what they demand of a tool that goes up."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.tool.body import Body, Piece, grow_body

from .deepest import compute_needed_height, deepest, end_and_side, find_top, least_mixed, support_at
from .demanded_lift import raise_to_demand
from .known_depths import KnownDepths
from .pairs import Pairs, PairWays, halve_pairs
from .swept_motion import Poses, SweptMotion
from .traversal import MOST_PAIRS

ROUNDS = 40
"""Divisions of a pair; after that the bound is what it is."""

AT_ONCE = 32768
"""Stretches with facets that are divided together."""

FEW_AT_ONCE = 4096
"""Pairs whose demands are asked together."""


@dataclass(frozen=True, eq=False)
class Refinement:
    """Of pairs of a ``swept`` motion with facets of a ``tree``: what is ``known`` of the blocks grows."""

    tree: FacetTree
    swept: SweptMotion
    known: KnownDepths

    def refine(self, piece: Piece, left: Pairs, tick: Callable[[], None]) -> None:
        """Refine the depth of the pairs, some of each block at a time: what they tell makes many of the
        others superfluous."""
        parts = -(-len(left.block) // AT_ONCE)
        for k in range(parts):
            rows = np.arange(k, len(left.block), parts)
            some = left.take(rows)
            rows = np.flatnonzero(piece.most > self.known.floors.take(some.block) - self._more(some))
            self._refine_some(piece, some.take(rows), tick)

    def _refine_some(self, piece: Piece, left: Pairs, tick: Callable[[], None]) -> None:
        for _ in range(ROUNDS):
            tick()
            left, ways = self._above_bottom(piece, left)
            if not len(left.block):
                return
            middle = 0.5 * (left.start + left.end)
            pose = self.swept.pose(left.block, middle)
            deep, more = deepest(piece, pose, left.corner), self._more(left)
            facet = self.tree.facet[left.leaf]
            self.known.note(left.block, middle, more - deep.distance, deep.point, facet, piece.part)
            most, in_time, half_way = self._most(piece, left, ways, pose, deep.point, deep.g)
            rows = np.flatnonzero(np.minimum(most, piece.most) > self.known.floors.take(left.block) - more)
            left, most = left.take(rows), most[rows]
            if len(rows) > MOST_PAIRS:
                break
            across = (half_way + deep.distance)[rows]
            left, most = halve_pairs(left, in_time[rows] >= across), np.tile(most, 2)
        np.maximum.at(self.known.found.bound, left.block, most + self._more(left))

    def _above_bottom(self, piece: Piece, left: Pairs) -> tuple[Pairs, PairWays]:
        """Return the pairs without those that stay below the bottom of the piece, and their ways: a level
        bottom turns with the tool, so no direction that stands still is close under it."""
        start, end = self.swept.pose(left.block, left.start), self.swept.pose(left.block, left.end)
        share = 0.125 * (left.end - left.start) ** 2
        bend, loose = share * self.swept.bend_tip[left.block], share * self.swept.bend_axis[left.block]
        ways = PairWays(start, end, bend, loose, find_top(start, end, left.corner, bend, loose))
        if piece.low_radius == 0.0:
            return left, ways
        most = ways.top - piece.low + piece.round
        rows = np.flatnonzero(most > self.known.floors.take(left.block) - self._more(left))
        return left.take(rows), ways.take(rows)

    def _most(
        self, piece: Piece, left: Pairs, ways: PairWays, pose: Poses, point: Floats, g: Floats
    ) -> tuple[Floats, Floats, Floats]:
        """Return the bound (n,) mm over the stretch; along g, how much of it comes from the way between the
        poses, and what is left half-way.

        Only along g do both shrink as the pair is divided; the normal's bound may be the better one, but it
        does not become better.
        """
        start, end, bend, loose, top = ways
        high = compute_needed_height(piece, top)

        def compute_ends(g: Floats) -> tuple[Floats, Floats]:
            over = np.maximum(*(support_at(piece, there, g, loose, high) for there in (start, end))) + bend
            return over, (g * left.corner).sum(axis=1).min(axis=0)

        over, begins = compute_ends(g)
        half_way = support_at(piece, pose, g, high=high)
        most, in_time, flat = over - begins, over - half_way, half_way - begins
        normal = self.tree.plates(self.tree.leaf + left.leaf).normal
        for direction in (normal, -normal):
            over, begins = compute_ends(direction)
            most = np.minimum(most, over - begins)
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

    def _more(self, left: Pairs) -> Floats | float:
        """Return the allowance (n,) mm of the facets of pairs."""
        return self.tree.most_of(self.tree.leaf + left.leaf)

    def demand(self, piece: Piece, body: Body, left: Pairs, lift: Floats) -> None:
        """Raise ``lift`` (m,) to what the pairs demand, of a body grown by the allowance of their facets."""
        if self.tree.allowance is None:
            return self._demand_alike(piece, body, left, lift)
        more = self.tree.most_of(self.tree.leaf + left.leaf)
        for by in np.unique(more).tolist():
            self._demand_alike(
                piece._replace(round=piece.round + by), grow_body(body, by), left.take(more == by), lift
            )
        return None

    def _demand_alike(self, piece: Piece, body: Body, left: Pairs, lift: Floats) -> None:
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
                raise_to_demand(lift, some.block, piece, body, pose, way, some.corner, self.known.limit)
