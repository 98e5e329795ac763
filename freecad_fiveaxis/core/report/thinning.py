# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fewer passes for a small picture: which strokes are left out where passes would stand nearer together than
can be told apart.

coat      all strokes that are left at one distance: its passes stand at least that far apart over most of
          their length. Coats are nested: what a wide one keeps, all narrower ones keep.
run       strokes that follow one another; one that is longer than the part is cut, for a spiral is a single
          run.
"""

from __future__ import annotations

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs

COATS = 8
"""So many distances, beside that at which all is drawn."""
FINEST, WIDER = 1.0 / 256.0, 1.5
"""The least distance as a share of the part's diagonal, and each one as a multiple of the one before."""
COVERED = 0.5
"""A run that others cover over more than this share of its length is left out."""
MOST_PLACES = 60_000
"""At more places it is not looked at how far runs are apart."""


def distances(diagonal: float) -> Floats:
    """How far apart (COATS,) mm the passes of each coat stand, of a part with this ``diagonal`` mm."""
    return np.asarray(diagonal * FINEST * WIDER ** np.arange(COATS))


def coats(start: Floats, end: Floats, diagonal: float) -> Ints:
    """Return the widest coat (k,) that each stroke from ``start`` to ``end`` (k, 3) mm belongs to, 0 to
    COATS; 0: none."""
    widest = np.zeros(len(start), np.int64)
    if not len(start) or not diagonal > 0.0:
        return widest
    run = _runs(start, end, diagonal)
    kept = np.ones(run[-1] + 1, bool)
    for coat, apart in enumerate(distances(diagonal).tolist(), 1):
        rows = np.flatnonzero(kept[run])
        places, owner = _spread(start[rows], end[rows], run[rows], apart)
        if len(places) <= MOST_PLACES:
            kept &= _choose_runs(places, owner, apart, len(kept))
        widest[kept[run]] = coat
    return widest


def _runs(start: Floats, end: Floats, longest: float) -> Ints:
    """Return the run (k,) of each stroke."""
    length = np.linalg.norm(end - start, axis=1)
    new = np.zeros(len(start), bool)
    new[1:] = (start[1:] != end[:-1]).any(axis=1)
    along = np.cumsum(length) - length
    first = np.flatnonzero(np.append(True, new[1:]))
    since = along - np.repeat(along[first], np.diff(first, append=len(start)))
    turn = (since / longest).astype(np.int64)
    new[1:] |= turn[1:] != turn[:-1]
    return np.cumsum(new)


def _spread(start: Floats, end: Floats, run: Ints, step: float) -> tuple[Floats, Ints]:
    """Places (n, 3) mm every ``step`` along the strokes, at least one on each run, and the run of each."""
    length = np.linalg.norm(end - start, axis=1)
    at = np.cumsum(length)
    marks = np.floor(at / step)
    due = np.diff(marks, prepend=0.0) > 0.0
    due[np.flatnonzero(np.diff(run, prepend=-1))] = True
    count = np.where(due, np.maximum(np.floor(length / step), 1.0), 0.0).astype(np.int64)
    rows, number = number_runs(count)
    share = ((number + 0.5) / count[rows])[:, None]
    return start[rows] + share * (end - start)[rows], run[rows]


def _choose_runs(places: Floats, owner: Ints, apart: float, runs: int) -> Bools:
    """Which of ``runs`` are drawn: one after the other, those that the drawn ones before do not cover."""
    pairs = scipy.spatial.cKDTree(places).query_pairs(apart, output_type="ndarray")
    pairs = pairs[owner[pairs[:, 0]] != owner[pairs[:, 1]]]
    pairs = np.concatenate([pairs, pairs[:, ::-1]])
    pairs = pairs[np.argsort(owner[pairs[:, 0]], kind="stable")]
    reached, of = pairs[:, 1], np.searchsorted(owner[pairs[:, 0]], np.arange(runs + 1))
    begin = np.searchsorted(owner, np.arange(runs + 1))
    chosen, covered = np.zeros(runs, bool), np.zeros(len(places), bool)
    for run in range(runs):  # each one's place depends on those before it
        own = covered[begin[run] : begin[run + 1]]
        if len(own) and own.mean() <= COVERED:
            chosen[run] = True
            covered[reached[of[run] : of[run + 1]]] = True
    return chosen
