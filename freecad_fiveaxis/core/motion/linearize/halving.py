# SPDX-License-Identifier: LGPL-2.1-or-later
"""Halving: a block that does not hold is cut in two at the middle of its share, and each half again until all
hold.

It is what posts commonly do. It mostly takes more pieces than are needed, but where halves of halves happen
to be just short enough, the rounding of the words may favour them: so blocks in ``doubt`` are compared with
it.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.trajectory import frames

from .commanded_moves import CommandedMoves, Steps, follow
from .division import FEW, Divided
from .proof import judge_pieces, off_segment

DEPTH = 50
"""Halvings that leave a share as fine as a double is."""


LIKELY, LIKELY_FEW = 1.1, 2.0
"""A half of so many balanced pieces may hold in one: their loads are a little less than 1, and not known to
the last."""


def promising(pieces: Divided, blocks: Ints) -> Ints:
    """Those of the ``blocks``, ascending, of which halving may make fewer pieces: counted on the load, which
    the balanced pieces share evenly, and so without any judging."""
    here = pieces.take(blocks)
    own = np.repeat(np.arange(len(blocks)), here.count - 1)
    first = np.cumsum(here.count) - here.count
    at = np.concatenate([own + 0.5 * here.share, np.arange(len(blocks)), np.arange(len(blocks)) + 0.5])
    inner = np.arange(len(own)) - (first - np.arange(len(blocks)))[own] + 1
    load = np.concatenate([inner, np.zeros(len(blocks)), here.count])
    order = np.argsort(at, kind="stable")
    at, load = at[order], load[order]
    count, block = np.zeros(len(blocks), np.int64), np.arange(len(blocks))
    likely = np.where(here.count <= FEW, LIKELY_FEW, LIKELY)
    low, width = np.zeros(len(blocks)), 1.0
    for _ in range(DEPTH):
        low_load, high_load = (np.interp(block + 0.5 * (low + end), at, load) for end in (0.0, width))
        holds = high_load - low_load <= likely[block]
        count += np.bincount(block[holds], minlength=len(blocks))
        waiting = count + 2 * np.bincount(block[~holds], minlength=len(blocks))
        count = np.where(waiting >= here.count, here.count, count)
        going = ~holds & (waiting < here.count)[block]
        width *= 0.5
        block, low = np.repeat(block[going], 2), np.repeat(low[going], 2)
        low[1::2] += width
        if not len(block):
            break
    return blocks[count < here.count]


def halve_blocks(kinematics: Chain, way: CommandedMoves, limit: Ints, goal: Floats, steps: Steps) -> Divided:
    """Halve blocks until all pieces hold their ``goal`` (b,) mm; those that would take ``limit`` (b,) pieces
    or more are left whole, with an infinite goal."""
    size, frame = len(limit), frames(kinematics)
    count, block, low, high = np.zeros(size, np.int64), np.arange(size), np.zeros(size), np.ones(size)
    held = np.zeros(size)
    records: list[tuple[Ints, Floats, Floats]] = []
    for _ in range(DEPTH):
        at, share = np.repeat(block, 2), np.stack([low, high], axis=1).ravel()
        words = follow(kinematics, way, at, share, steps)
        off = off_segment(frame, words, way.tip[at], way.chord[at])
        inside = np.arange(len(words) - 1) % 2 == 0
        judged = judge_pieces(frame, words, inside, off, goal[at[1:]])
        most = (judged.most + judged.off)[::2]
        holds = most <= goal[block]
        np.maximum.at(held, block[holds], most[holds])
        records.append((block[holds], high[holds], words[1::2][holds]))
        count += np.bincount(block[holds], minlength=size)
        going = ~holds & (count + 2 * np.bincount(block[~holds], minlength=size) < limit)[block]
        count[block[~holds & ~going]] = limit[block[~holds & ~going]]
        block, low, high = np.repeat(block[going], 2), np.repeat(low[going], 2), np.repeat(high[going], 2)
        low[1::2] = high[0::2] = 0.5 * (low[0::2] + high[0::2])
        if not len(block):
            break
    count[block] = limit[block]
    whole = count >= limit
    return _gather_pieces(records, whole, np.where(whole, np.inf, goal), np.where(whole, np.inf, held))


def _gather_pieces(
    records: list[tuple[Ints, Floats, Floats]], whole: Bools, goal: Floats, held: Floats
) -> Divided:
    row, share, words = (np.concatenate(parts) for parts in zip(*records, strict=True))
    inner = np.flatnonzero(~whole[row] & (share < 1.0))
    order = inner[np.lexsort((share[inner], row[inner]))]
    count = np.bincount(row[order], minlength=len(whole)) + 1
    return Divided(count, share[order], words[order], goal, held, np.zeros(len(whole), bool))
