# SPDX-License-Identifier: LGPL-2.1-or-later
"""The half-edges of a mesh, sorted so that those of one edge stand next to each other, and put
together to co-edges.

sense  of a half-edge: 0 from the lower to the higher vertex number, 1 back.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.columns import cache_chunks
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Floats, Ints

from .faults import report_edges
from .words import T, Words, sort_during


@dataclass(frozen=True)
class HalfEdges:
    """All half-edges of a mesh, sorted by edge and sense.

    ``word`` (3 f,) ascending: lower vertex, upper vertex, sense (0 from lower to upper), and below them ``low
    + 2`` bits for the half-edge k << low | i, which leaves corner k of facet i; where that is too wide,
    ``half`` has the half-edges.
    """

    word: Words
    half: Ints | None
    low: int

    def keys(self, row: slice | Ints) -> Words:
        """Edge with sense of the given rows."""
        return self.word[row] >> np.uint64(0 if self.half is not None else self.low + 2)

    def numbers(self, row: slice | Ints) -> Ints:
        """Half-edge of the given rows."""
        if self.half is not None:
            return self.half[row]
        return (self.word[row] & np.uint64((1 << self.low + 2) - 1)).view(np.int64)

    def is_paired(self) -> bool:
        """Return True where each edge has two half-edges of opposite senses, which then stand in rows 2 i and
        2 i + 1."""
        if len(self.word) % 2:
            return False
        bits = 0 if self.half is not None else self.low + 2
        least, most = (
            np.uint64(1 << bits),
            np.uint64((2 << bits) - 1),
        )  # where two words differ in the sense and below it
        for part in cache_chunks(len(self.word) // 2):
            row = self.word[2 * part.start : 2 * part.stop]
            differ = row[0::2] ^ row[1::2]
            if differ.min() < least or differ.max() > most:
                return False
        return True


def sort_half_edges(face: Ints, vertices: int, work: Callable[[], T]) -> tuple[HalfEdges, T]:
    """Return the half-edges of ``face`` (f, 3), rows of so many ``vertices``, and what ``work`` gives, done
    in the meantime.

    Edge and half-edge share one word while they fit.
    """
    f = len(face)
    width, low = int(vertices - 1).bit_length(), int(f - 1).bit_length()
    if 2 * width + 1 + low + 2 <= 64:
        word = _words(face, width, low)
        done = sort_during(word, work)
        return HalfEdges(word, None, low), done
    word = _words(face, width, None)
    order = np.argsort(word, kind="stable")
    return HalfEdges(word[order], order // f << low | order % f, low), work()


def _words(face: Ints, width: int, low: int | None) -> Words:
    """Words (3 f,) of edge and sense, ``width`` bits a vertex, and below them the half-edge where ``low`` is
    given.

    Written from start to end and, with a sense of 1, from end to start, the smaller word has the lower vertex
    first.
    """
    shift = 0 if low is None else low + 2
    start, end, sense = np.uint64(shift + 1 + width), np.uint64(shift + 1), np.uint64(1 << shift)
    column = face.T.view(np.uint64)
    word = np.empty(column.shape, dtype=np.uint64)

    def fill(part: slice) -> None:
        first = column[:, part] << start
        second = column[:, part] << end
        if low is not None:
            second |= np.arange(part.start, part.stop, dtype=np.uint64)
        for k, after in enumerate((1, 2, 0)):
            there = np.bitwise_or(first[k], second[after], out=word[k, part])
            back = first[after] | second[k]
            back |= sense
            np.minimum(there, back, out=there)
            there |= np.uint64(0 if low is None else k << low)

    in_threads(fill, chunks(len(face)))
    return word.reshape(-1)


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


@dataclass(frozen=True)
class Coedges:
    """The co-edge columns of a Mesh (``vertex``, ``face``, ``of_face``), findings, and whether the mesh is
    closed."""

    vertex: Ints
    face: Ints
    of_face: Ints
    findings: list[Finding]
    closed: bool


def find_coedges(vertex: Floats, face: Ints, halves: HalfEdges) -> Coedges:
    """Return the co-edges of the facets (f, 3) whose half-edges these are."""
    findings: list[Finding] = []
    number, alone, closed = len(halves.word) // 2, np.empty(0, dtype=np.int64), True
    pairs: Iterator[tuple[slice | Ints, slice | Ints]]
    if halves.is_paired():
        pairs = (
            (slice(2 * at.start, 2 * at.stop, 2), slice(2 * at.start + 1, 2 * at.stop, 2))
            for at in chunks(number)
        )
    else:
        first, alone = partners(halves.keys(slice(None)))
        number = len(first)
        pairs = ((first[at], first[at] + 1) for at in chunks(number))
        findings, closed = report_edges(halves.keys(alone), halves.numbers(alone), halves.low, vertex, face)
    width, facet = int(len(vertex) - 1).bit_length(), (1 << halves.low) - 1
    ends, sides = np.empty((2, 2, number + len(alone)), dtype=np.int64)
    of_face = np.empty(
        3 << halves.low, dtype=np.int64
    )  # as wide as half-edge numbers are, so that they address it

    def fill(at: slice, there: slice | Ints, back: slice | Ints) -> None:
        _put_ends(halves.keys(there), width, ends[:, at])
        one, two = halves.numbers(there), halves.numbers(back)
        np.bitwise_and(one, facet, out=sides[0, at])
        np.bitwise_and(two, facet, out=sides[1, at])
        of_face[one] = of_face[two] = np.arange(at.start, at.stop)

    in_threads(
        lambda rows: fill(*rows), [(at, *pair) for at, pair in zip(chunks(number), pairs, strict=True)]
    )
    edge, one = halves.keys(alone), halves.numbers(alone)
    _put_ends(edge, width, ends[:, number:])
    against = number + np.flatnonzero(edge & np.uint64(1))
    ends[:, against] = ends[::-1, against]
    sides[0, number:], sides[1, number:] = one & facet, -1
    of_face[one] = np.arange(number, number + len(alone))
    return Coedges(ends.T, sides.T, of_face.reshape(3, -1)[:, : len(face)].T, findings, closed)


def _put_ends(edge: Words, width: int, out: Ints) -> None:
    """Lower and upper vertex of edges with sense into the two rows of ``out``; ``width`` bits a vertex."""
    lower, upper = out.view(np.uint64)
    np.right_shift(edge, np.uint64(width + 1), out=lower)
    np.right_shift(edge, np.uint64(1), out=upper)
    upper &= np.uint64((1 << width) - 1)
