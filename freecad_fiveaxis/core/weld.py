# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loose triangle corners become vertices.

weld  corners with equal coordinates become one vertex; corners that merely lie close do not.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .columns import CHUNK, chunks
from .records import Floats, Ints

Words = NDArray[np.uint64]
Reals = NDArray[np.floating]  # float32 as in an STL file, or float64

_CELLS = 255.0  # of the bounding box along each of its two longer sides, that number the vertices
_SHORTEST = 1e-30  # mm; a side that no cell can divide in 32-bit floats
_FACTORS = (0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0xD6E8FEB86659FD93)  # odd, with well mixed bits


def weld(column: Reals) -> tuple[Floats, Ints]:
    """Vertices (v, 3) and the vertex row (n,) of each of the n corners whose x, y, z are the rows of ``column``.

    Sorts words of cell, hash and corner number. The cell (of the bounding box, seen along its shortest side) goes first so
    that vertices that lie close get close numbers: everything that follows then runs in the cache.
    """
    n = column.shape[1]
    bits = int(n - 1).bit_length()
    key = _corner_keys(column, bits)
    key.sort()
    corner = (key & np.uint64((1 << bits) - 1)).view(np.int64)
    key >>= np.uint64(bits)
    new = np.zeros(n, dtype=np.bool_)
    np.not_equal(key[1:], key[:-1], out=new[1:])
    row = np.empty(n, dtype=np.int64)
    row[corner] = np.cumsum(new, out=key.view(np.int64))  # fresh memory would cost more than the sum itself
    new[0] = True
    vertex = column.take(corner.take(np.flatnonzero(new)), axis=1)
    return _separate(column, vertex, row)


def _corner_keys(column: Reals, bits: int) -> Words:
    """Words (n,) of 16 bits cell, 48 - ``bits`` bits hash, ``bits`` bits corner number."""
    low = column.min(axis=1)
    size = column.max(axis=1).astype(np.float64) - low
    scale = np.where(size > _SHORTEST, _CELLS / np.maximum(size, _SHORTEST), 0.0).astype(column.dtype)
    _, j, i = np.argsort(size)
    raw = column.view(np.uint32 if column.dtype == np.float32 else np.uint64)
    number = np.arange(CHUNK, dtype=np.uint64)
    hash_bits = np.uint64((1 << 48) - (1 << bits))
    key = np.empty(column.shape[1], dtype=np.uint64)
    for part in chunks(len(key)):
        word = raw[0, part].astype(np.uint64) * np.uint64(_FACTORS[0])
        for axis in (1, 2):
            word += raw[axis, part].astype(np.uint64) * np.uint64(_FACTORS[axis])
        word >>= np.uint64(16)  # the upper bits of a product are the well mixed ones
        word &= hash_bits
        cell = ((column[i, part] - low[i]) * scale[i]).astype(np.uint32) << np.uint32(8)
        cell |= ((column[j, part] - low[j]) * scale[j]).astype(np.uint32)
        word |= cell.astype(np.uint64) << np.uint64(48)
        np.bitwise_or(word, number[: len(word)], out=key[part])
        number += np.uint64(CHUNK)
    return key


def _separate(column: Reals, vertex: Reals, row: Ints) -> tuple[Floats, Ints]:
    """Give corners that share a key but not the coordinates vertices of their own; there are hardly ever any."""
    strayed = []
    for part in chunks(len(row)):
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
    return vertex.astype(np.float64).T, row
