# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two trees gone down together, over the way and over the surface: which stretches and facets may hold more
than is known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.tool.body import Body, Piece

from .bounds import box_bound, facet_bound, least_depth, pare_piece, plate_bound
from .demanded_lift import demand_points, may_demand
from .known_depths import KnownDepths
from .pairs import Pairs, divide_pairs
from .swept_motion import Clusters, MotionSegments

SLICE = 49152
"""Pairs at a time: fewer stay in the cache of one thread, but two threads wait for each other between short
calls."""

AT_BOXES = 12288
"""Pairs whose boxes are looked at together: their columns stay in the cache, and memory that small is not
given back to the system and asked for anew at each step."""

MOST_PAIRS = 2_000_000
"""Pairs of one batch beyond which the batch is halved."""


class TooManyPairs(Exception):
    """More pairs than memory should hold."""


@dataclass(frozen=True, eq=False)
class Traversal:
    """Of a ``body`` on a way, ``clusters``, and a surface, ``tree``: what becomes ``known`` on the way
    down clears what comes after it."""

    body: Body
    clusters: Clusters
    tree: FacetTree
    known: KnownDepths

    def pairs(self, piece: Piece, parts: MotionSegments, tick: Callable[[], None]) -> Pairs:
        """Return the pairs of stretches ``parts`` with facets that may hold more than is known, in a
        ``piece`` of the body; ``tick`` is called again and again. Raises TooManyPairs."""
        clusters = self.clusters
        sweep, node = np.arange(clusters.top), np.zeros(clusters.top, np.int64)
        owner = np.concatenate([np.full(clusters.first, len(self.known.reached)), parts.block])
        done: list[tuple[Ints, Ints]] = []
        while len(sweep):
            tick()
            sweep, node, enters = self._prune_pairs(piece, owner, sweep, node)
            whole = (clusters.arity.take(sweep) == 0) & (node >= self.tree.leaf)
            done.append((sweep[whole] - clusters.first, node[whole]))
            sweep, node = divide_pairs(clusters, self.tree, sweep[~whole], node[~whole], enters[~whole])
            if len(sweep) > MOST_PAIRS and len(parts.block) > 1 and parts.block[0] != parts.block[-1]:
                raise TooManyPairs
        segment, leaf = (np.concatenate(column) for column in zip(*done, strict=True))
        leaf = leaf - self.tree.leaf
        return Pairs(
            parts.block[segment], parts.start[segment], parts.end[segment], self.tree.corners(leaf), leaf
        )

    def _prune_pairs(self, piece: Piece, owner: Ints, sweep: Ints, node: Ints) -> tuple[Ints, Ints, Bools]:
        """Return the pairs that may hold more than is known, and which of them do enter; ``owner`` (n,) the
        place of their floors."""
        kept, deep = [], []
        for first in range(0, len(sweep), SLICE):
            some, place = sweep[first : first + SLICE], owner.take(sweep[first : first + SLICE])
            rows, enters = self._stay(piece, some, place, node[first : first + SLICE])
            kept.append(first + rows)
            deep.append(enters)
        rows = np.concatenate(kept)
        return sweep[rows], node[rows], np.concatenate(deep)

    def _stay(self, piece: Piece, sweep: Ints, place: Ints, node: Ints) -> tuple[Ints, Bools]:
        """:meth:`_prune_pairs` for so many that two threads do not wait for each other: which rows stay."""
        core, off = pare_piece(piece, self.known.limit if piece.most > self.known.limit else 0.0)
        floor = self.known.floors.take(place) - off - self.tree.most_of(node)
        most = np.full(len(node), piece.most - off)
        for first in range(0, len(node), AT_BOXES):
            some = slice(first, first + AT_BOXES)
            most[some] = np.minimum(
                most[some], box_bound(core, self.clusters.ways(sweep[some]), self.tree, node[some])
            )
        rows = np.flatnonzero(most > floor)
        demanded = None if self.tree.allowance is not None else self.known.lift
        if demanded is not None:
            there = self.clusters.ways(sweep.take(rows))
            known = demanded.take(place.take(rows))
            rows = rows[may_demand(self.body, there, self.tree, node.take(rows), known)]
        ways, node, floor, most = (
            self.clusters.ways(sweep.take(rows)),
            node.take(rows),
            floor.take(rows),
            most.take(rows),
        )
        most = np.minimum(most, plate_bound(core, ways, self.tree, node))
        left = np.flatnonzero(most > floor)
        rows, ways, node, floor, most = (
            rows.take(left),
            ways.take(left),
            node.take(left),
            floor.take(left),
            most.take(left),
        )
        if (node >= self.tree.leaf).any():
            most = np.minimum(most, facet_bound(core, ways, self.tree, node))
            left = np.flatnonzero(most > floor)
            rows, ways, node, most = rows.take(left), ways.take(left), node.take(left), most.take(left)
        least, place = (
            least_depth(piece, ways, self.tree.points(node)) + self.tree.least_of(node),
            place.take(rows),
        )
        enters = least > self.known.limit
        if not enters.any():  # nothing is learned that could clear one of them
            return rows, enters
        if self.known.lift is None:
            self.known.learn(place, least)
        elif demanded is not None:
            deep = np.flatnonzero(enters & (place < len(self.known.reached)))
            demand_points(
                demanded, place.take(deep), self.body, ways.take(deep), self.tree.points(node.take(deep))
            )
        left = np.flatnonzero(most > self.known.floors.take(place) - off - self.tree.most_of(node))
        return rows.take(left), enters.take(left)
