# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loose triangle corners become vertices.

weld   corners with equal coordinates become one vertex; corners that merely lie close do not.
stray  a corner whose key is that of a vertex with other coordinates.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.columns import cache_chunks
from freecad_fiveaxis.core.base.records import Ints

from .words import T, Words, sort_during

Reals = NDArray[np.floating]  # float32 as in an STL file, or float64

_CELLS = 255.0  # of the bounding box along each of its two longer sides, that number the vertices
_SHORTEST = 1e-30  # mm; a side that no cell can divide in 32-bit floats
_FACTORS = np.array(
    (0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0xD6E8FEB86659FD93), dtype=np.uint64
)  # odd, with well mixed bits


def weld(column: Reals, low: Reals, high: Reals, work: Callable[[], T]) -> tuple[Reals, Ints, T]:
    """Vertices (3, v), the vertex row (n,) of each of the n corners whose x, y, z are the rows of ``column``,
    and what ``work`` gives, done in the meantime. :func:`separate` has to follow.

    ``low`` and ``high`` (3,) bound the corners. Sorts words of cell, hash and corner number. The cell (of the
    bounding box, seen along its shortest side) goes first so that vertices that lie close get close numbers:
    everything that follows then runs in the cache.
    """
    bits = int(column.shape[1] - 1).bit_length()
    key = _corner_keys(column, low, high, bits)
    done = sort_during(key, work)
    row, first = _number(key, bits)
    return column.take(first, axis=1), row, done


def _corner_keys(column: Reals, low: Reals, high: Reals, bits: int) -> Words:
    """Words (n,) of 16 bits cell, 48 - ``bits`` bits hash, ``bits`` bits corner number."""
    size = high.astype(np.float64) - low
    scale = np.where(size > _SHORTEST, _CELLS / np.maximum(size, _SHORTEST), 0.0).astype(column.dtype)
    _, j, i = np.argsort(size)
    raw = column.view(np.uint32 if column.dtype == np.float32 else np.uint64)
    hash_bits = np.uint64((1 << 48) - (1 << bits))
    key = np.empty(column.shape[1], dtype=np.uint64)

    def fill(part: slice) -> None:
        corner = column[:, part]
        corner += 0.0  # turns -0.0 into 0.0, so that equal coordinates have equal bits
        word = np.multiply(raw[0, part], _FACTORS[0], out=key[part], dtype=np.uint64)
        for axis in (1, 2):
            word += np.multiply(raw[axis, part], _FACTORS[axis], dtype=np.uint64)
        word >>= np.uint64(16)  # the upper bits of a product are the well mixed ones
        word &= hash_bits
        cell = ((corner[i] - low[i]) * scale[i]).astype(np.int32) << 8
        cell |= ((corner[j] - low[j]) * scale[j]).astype(np.int32)
        word |= cell.astype(np.uint64) << np.uint64(48)
        word |= np.arange(part.start, part.stop, dtype=np.uint64)

    in_threads(fill, chunks(len(key)))
    return key


def _number(key: Words, bits: int) -> tuple[Ints, Ints]:
    """Vertex row (n,) of each corner and the first corner (v,) of each vertex, from ascending keys; these
    lose ``bits`` bits."""
    row = np.empty(len(key), dtype=np.int64)
    first: list[Ints] = []
    before, vertices = np.uint64((1 << 64) - 1), 0  # no key, which has fewer bits
    for part in cache_chunks(len(key)):
        word = key[part]
        corner = (word & np.uint64((1 << bits) - 1)).view(np.int64)
        word >>= np.uint64(bits)
        new = np.empty(len(word), dtype=np.bool_)
        new[0] = word[0] != before
        np.not_equal(word[1:], word[:-1], out=new[1:])
        start = np.flatnonzero(new)
        first.append(corner.take(start))
        bound = np.concatenate(
            ([0], start, [len(word)])
        )  # the first rows may be those of the last vertex before
        row[corner] = np.arange(vertices - 1, vertices + len(start)).repeat(bound[1:] - bound[:-1])
        before, vertices = word[-1], vertices + len(start)
    return row, np.concatenate(first)


def separate(column: Reals, vertex: Reals, row: Ints) -> Reals:
    """Give strays, in ``row``, vertices of their own; all vertices then. There are hardly ever any."""
    strayed = []
    for part in cache_chunks(len(row)):
        at = row[part]
        wrong = vertex[0].take(at) != column[0, part]
        wrong |= vertex[1].take(at) != column[1, part]
        wrong |= vertex[2].take(at) != column[2, part]
        if wrong.any():
            strayed.append(np.flatnonzero(wrong) + part.start)
    if strayed:
        corner = np.concatenate(strayed)
        more, which = np.unique(column[:, corner], axis=1, return_inverse=True)
        row[corner] = vertex.shape[1] + which.reshape(-1)
        vertex = np.concatenate([vertex, more], axis=1)
    return vertex
