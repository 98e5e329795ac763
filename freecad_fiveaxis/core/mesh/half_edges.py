# SPDX-License-Identifier: LGPL-2.1-or-later
"""The half-edges of a mesh, sorted so that those of one edge stand next to each other.

sense  of a half-edge: 0 from the lower to the higher vertex number, 1 back.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.kinematics import chunks
from freecad_fiveaxis.core.records import Ints

from .weld import Words


@dataclass(frozen=True)
class HalfEdges:
    """All half-edges of a mesh, sorted by edge and sense.

    ``word`` (3 f,) ascending: lower vertex, upper vertex, sense (0 from lower to upper), and below them ``low + 2`` bits for
    the half-edge k << low | i, which leaves corner k of facet i; where that is too wide, ``half`` has the half-edges.
    """

    word: Words
    half: Ints | None
    low: int

    def pick(self, row: slice | Ints) -> tuple[Words, Ints]:
        """Edge with sense, and half-edge, of the given rows."""
        word = self.word[row]
        if self.half is not None:
            return word, self.half[row]
        bits = self.low + 2
        return word >> np.uint64(bits), (word & np.uint64((1 << bits) - 1)).view(np.int64)

    def paired(self) -> bool:
        """True where each edge has two half-edges of opposite senses, which then stand in rows 2 i and 2 i + 1."""
        if len(self.word) % 2:
            return False
        shift = np.uint64(0 if self.half is not None else self.low + 2)
        rows = (self.word[2 * part.start : 2 * part.stop] for part in chunks(len(self.word) // 2))
        return all(bool(((row[0::2] ^ row[1::2]) >> shift == 1).all()) for row in rows)


def sorted_half_edges(face: Ints, vertices: int) -> HalfEdges:
    """The half-edges of ``face`` (f, 3), rows of so many ``vertices``.

    Edge and half-edge share one word while they fit, since sorting words is several times faster than argsort.
    """
    f = len(face)
    width, low = int(vertices - 1).bit_length(), int(f - 1).bit_length()
    fits = 2 * width + 1 + low + 2 <= 64
    shift = np.uint64(low + 2 if fits else 0)
    column = face.T.view(np.uint64)
    key = np.empty((3, f), dtype=np.uint64)
    for part in chunks(f):
        number = np.arange(part.start, part.stop, dtype=np.uint64)
        for k in range(3):
            start, end = column[k, part], column[(k + 1) % 3, part]
            word = np.minimum(start, end, out=key[k, part])
            word <<= np.uint64(width)
            word |= np.maximum(start, end)
            word <<= np.uint64(1)
            word |= start > end
            if fits:
                word <<= shift
                word |= number
                word |= np.uint64(k << low)
    word = key.reshape(-1)
    if fits:
        word.sort()
        return HalfEdges(word, None, low)
    order = np.argsort(word, kind="stable")
    return HalfEdges(word[order], order // f << low | order % f, low)


def partners(key: Words) -> tuple[Ints, Ints]:
    """Rows of ``key`` (3 f,), edges with sense, whose partner is the next row, and rows without a partner.

    Partners are the only two half-edges of their edge and run in opposite senses.
    """
    edge = key >> np.uint64(1)
    same = np.equal(edge[1:], edge[:-1])
    partner = same & (key[1:] != key[:-1])
    partner[1:] &= ~same[:-1]
    partner[:-1] &= ~same[1:]
    first = np.flatnonzero(partner)
    alone = np.ones(len(key), dtype=np.bool_)
    alone[first] = alone[first + 1] = False
    return first, np.flatnonzero(alone)
