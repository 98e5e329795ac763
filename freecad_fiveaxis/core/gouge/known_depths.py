# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of the depths in each block while they are searched: what is found, and what a pair must be
able to exceed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints

RELATIVE = 0.01
"""A depth is known to this share of itself, or to the accuracy asked for where that is more."""

SURELY = 0.999
"""Of a depth that is known to be reached, what is not lost by rounding."""


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

    @classmethod
    def none(cls, m: int) -> Entries:
        """Return those of m blocks of which nothing is found."""
        column = np.zeros(m), np.zeros(m), np.zeros(m), np.zeros((m, 3))
        return cls(*column, np.full(m, -1), np.zeros(m, np.int64))

    def replace_rows(self, other: Entries, blocks: Ints) -> None:
        """Take the entries of these ``blocks`` (k,) from another search of the same m blocks."""
        for name, column in vars(other).items():
            getattr(self, name)[blocks] = column[blocks]


@dataclass(frozen=True, eq=False)
class KnownDepths:
    """Of m blocks, of which depths above ``limit`` mm are looked for, to ``accuracy`` mm: what is ``found``;
    ``reached`` (m,) mm: so deep a block is known to be, though not yet where; ``floors`` (m + 1,) mm: what a
    pair of a block must be able to exceed; that of a cluster, in the last place, is the limit. ``lift`` (m +
    1,) mm: what is demanded of blocks so far, where only that is asked; nothing of a cluster, and it stays at
    -inf. What is known of a block clears others of its pairs."""

    limit: float
    accuracy: float
    found: Entries
    reached: Floats
    floors: Floats
    lift: Floats | None = None

    @classmethod
    def none(cls, m: int, limit: float, accuracy: float, lift: Floats | None = None) -> KnownDepths:
        """Return what is known before anything is looked at."""
        return cls(limit, accuracy, Entries.none(m), np.zeros(m), np.full(m + 1, limit), lift)

    def learn(self, place: Ints, least: Floats) -> None:
        """Take depths ``least`` (n,) mm into account that are known to be reached, though not yet where, in
        blocks ``place`` (n,), or clusters."""
        deep = np.flatnonzero((least > self.limit) & (place < len(self.reached)))
        if len(deep):
            block = place.take(deep)
            np.maximum.at(self.reached, block, SURELY * least.take(deep))
            self._raise_floors(block)

    def note(self, block: Ints, u: Floats, depth: Floats, point: Floats, facet: Ints, part: int) -> None:
        """Keep the deepest entry of each ``block`` (n,): at ``u`` (n,) a ``point`` (3, n) mm of a ``facet``
        (n,) is so deep (n,) mm in a ``part`` of the tool."""
        found = self.found
        rows = np.flatnonzero((depth > self.limit) & (depth > found.depth.take(block)))
        if not len(rows):
            return
        order = rows[np.argsort(depth[rows], kind="stable")]  # what is written last, the deepest, stays
        block = block[order]
        found.depth[block], found.u[block], found.place[block] = depth[order], u[order], point.T[order]
        found.facet[block], found.part[block] = facet[order], part
        self._raise_floors(block)

    def _raise_floors(self, block: Ints) -> None:
        """Work out the floors of these blocks anew."""
        placed, known = self.found.depth[block], self.reached[block]
        if self.accuracy == np.inf:  # that it enters is all that is asked
            floor = np.where(np.maximum(placed, known) > 0.0, np.inf, self.limit)
        else:
            floor = np.maximum(self.limit, known)
            floor = np.where(
                placed > 0.0, np.maximum(floor, placed + np.maximum(self.accuracy, RELATIVE * placed)), floor
            )
        self.floors[block] = floor
