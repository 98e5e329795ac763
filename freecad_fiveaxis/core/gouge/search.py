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

import numpy as np

from freecad_fiveaxis.core.base.chunks import in_threads
from freecad_fiveaxis.core.base.errors import Cancelled
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.tool.body import Body

from .known_depths import Entries, KnownDepths
from .refinement import Refinement
from .swept_motion import SweptMotion, clusters_of, segments_of
from .traversal import TooManyPairs, Traversal

BATCH = 8192
"""Blocks at a time: enough of them, and no more than a thread is done with in a second or two."""

FEW = 2048
"""Blocks that are not worth a second thread."""

PAUSE = 0.2
"""s between two words on how far the work is."""

BENT = 0.3
"""Stretches bend at most by this share of the limit where MOST_PARTS allow."""


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
    known = KnownDepths.none(len(swept), limit, 0.1 * limit if accuracy is None else accuracy)
    wanted = np.arange(len(swept)) if blocks is None else blocks
    _Search(tree, swept, body, known).batches(wanted, progress)
    progress("gouge", 1.0)
    found = known.found
    found.bound[wanted] = np.maximum(found.bound[wanted], known.floors[wanted])
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
    :func:`~.demanded_lift.raise_to_demand` misses may demand more."""
    lift = np.append(np.zeros(len(up)), -np.inf)
    known = KnownDepths.none(len(up), limit, np.inf, lift)
    _Search(tree, up, body, known).batches(np.arange(len(up)), progress)
    return lift[:-1]


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


@dataclass(frozen=True, eq=False)
class _Search:
    """``known``: of the blocks of ``swept``, filled in."""

    tree: FacetTree
    swept: SweptMotion
    body: Body
    known: KnownDepths

    def batches(self, blocks: Ints, progress: Progress) -> None:
        """:meth:`batch` for any number of blocks, on all threads: what is found of one depends on none of
        another batch."""
        ticks = _Ticks(progress)
        count = 2 * -(-len(blocks) // (2 * BATCH)) if len(blocks) > FEW else min(len(blocks), 1)
        parts = np.array_split(blocks, count) if count else []
        in_threads(lambda some: self.batch(some, ticks), parts, ticks.tell)

    def batch(self, blocks: Ints, ticks: _Ticks) -> None:
        """Fill in the entries of these blocks, or only the lift that they demand; ``ticks`` are called again
        and again."""
        limit, lift = self.known.limit, self.known.lift
        deep = [piece for piece in self.body.pieces if piece.most + self.tree.most_allowance > limit]
        if not deep:  # no shank or holder was given: nothing to lay out for
            return
        parts = segments_of(self.swept, blocks, self.body.reach, BENT * limit)
        clusters = clusters_of(self.swept, parts, self.body.reach)
        traversal = Traversal(self.body, clusters, self.tree, self.known)
        refinement = Refinement(self.tree, self.swept, self.known)
        try:
            for piece in sorted(deep, key=lambda one: -one.most):  # what can be deeper spares the others
                left = traversal.pairs(piece, parts, ticks)
                if lift is None:
                    refinement.refine(piece, left, ticks)
                else:
                    refinement.demand(piece, self.body, left, lift)
        except TooManyPairs:
            half = len(blocks) // 2
            for some in (blocks[:half], blocks[half:]):
                self.batch(some, ticks)
