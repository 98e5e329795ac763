# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the ends of a block's pieces go, so that all its pieces deviate alike.

load      of a piece: sqrt(deviation / tolerance). The deviation grows with the square of a piece's length, so
          a piece's load is the number of pieces that it should be, and a block's whole load the number that
          it needs.
balance   the shares at which the load, summed along the move, is even (de Boor's equidistribution).

Rows are the ends of all pieces, block after block: a block of n pieces has n + 1 rows, from share 0 to share
1. The load of a row is that of the piece which begins there; the last row of a block has none.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints


def even_shares(count: Ints) -> Floats:
    """Return the shares of all rows of blocks in ``count`` (b,) pieces of equal length."""
    first = first_rows(count)
    row = np.arange(int((count + 1).sum())) - np.repeat(first, count + 1)
    return np.asarray(row / np.repeat(count, count + 1))


def first_rows(count: Ints) -> Ints:
    """Return the row (b,) that each block begins at."""
    return np.asarray(np.cumsum(count + 1) - (count + 1))


def balance_shares(
    share: Floats, load: Floats, before: Ints, calm: Bools, blocks: Ints, after: Ints
) -> Floats:
    """Return the shares of all rows of the ``blocks``, in ``after`` pieces of even load.

    ``share``, ``load``: of all rows as they were, of ``before`` (b,) pieces; ``calm`` (b,): blocks whose
    loads differ by the noise of rounding, which is taken off; ``blocks`` (g,) that go on.
    """
    first, block = first_rows(before), np.repeat(np.arange(len(before)), before + 1)
    load = np.where(calm[block], _calm_load(load, block), load)
    load = np.where(
        (np.add.reduceat(load, first) == 0.0)[block] & ~_ends(block), 1.0, load
    )  # straight blocks: no load at all
    sums = np.concatenate([[0.0], np.cumsum(load / np.add.reduceat(load, first)[block])[:-1]])
    sums = (
        np.minimum(sums - sums[first][block], 1.0) + block
    )  # rises through all blocks: one search finds the place in each
    result = even_shares(after)
    inner = np.flatnonzero((result > 0.0) & (result < 1.0))
    result[inner] = _between(sums, share, np.repeat(blocks, after + 1)[inner] + result[inner])
    return result


def _ends(block: Ints) -> Bools:
    """Which rows no piece begins at."""
    return np.append(block[1:] != block[:-1], True)


def _calm_load(load: Floats, block: Ints) -> Floats:
    """Each piece lends a quarter of what it has more to its neighbour in the block."""
    ends = _ends(block)
    lend = np.where(ends[1:] | ends[:-1], 0.0, 0.25 * np.diff(load))
    calmed = load.copy()
    calmed[1:] -= lend
    calmed[:-1] += lend
    return calmed


def _between(x: Floats, y: Floats, at: Floats) -> Floats:
    """``y`` at ``at`` on a smooth curve through (x, y) that rises wherever they do.

    Cubics with the harmonic mean of both neighbours' slopes at each point (Fritsch and Butland 1984). From
    block to block, where y falls, each side keeps its own slope.
    """
    run, rise = np.diff(x), np.diff(y)
    slope = np.where((run > 0.0) & (rise >= 0.0), rise / np.where(run > 0.0, run, 1.0), np.inf)
    pair = slope[1:] + slope[:-1]
    joined = np.isfinite(pair) & (pair > 0.0)
    low, high = np.where(joined, slope[1:], 0.0), np.where(joined, slope[:-1], 0.0)
    mean = 2.0 * low * high / np.where(joined, pair, 1.0)
    alone = ~np.isfinite(pair)
    left = np.append(slope[:1], np.where(alone, slope[1:], mean))
    right = np.append(np.where(alone, slope[:-1], mean), slope[-1:])
    j = np.clip(np.searchsorted(x, at, side="right") - 1, 0, len(run) - 1)
    t, d = (at - x[j]) / run[j], rise[j]
    a, b = np.minimum(run[j] * left[j], 3.0 * d), np.minimum(run[j] * right[j], 3.0 * d)
    return np.asarray(
        np.clip(y[j] + t * (a + t * (3.0 * d - 2.0 * a - b + t * (a + b - 2.0 * d))), y[j], y[j + 1])
    )
