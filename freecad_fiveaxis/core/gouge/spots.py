# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the tool enters: blocks that follow one another and all enter are one spot."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import Sentence, say

MOST_SPOTS = 10
"""Findings of one kind; more would bury each other."""


def spots(depth: Floats) -> tuple[Ints, int]:
    """Return the deepest block of each spot, deepest first, and how many blocks (m,) have a depth above 0."""
    rows = np.flatnonzero(depth > 0.0)
    if not len(rows):
        return rows, 0
    spot = np.cumsum(np.diff(rows, prepend=rows[0]) > 1)
    order = np.lexsort((-depth[rows], spot))
    worst = rows[order[np.flatnonzero(np.diff(spot[order], prepend=-1))]]
    return worst[np.argsort(-depth[worst], kind="stable")], len(rows)


def deepest_of(blocks: int, places: int) -> Sentence:
    """Say of how many blocks, in how many places, the one just named is the deepest."""
    if places == 1:
        return say(" This is the deepest of {blocks} blocks there.", blocks=blocks)
    return say(" This is the deepest of {blocks} blocks in {places} places.", blocks=blocks, places=places)
