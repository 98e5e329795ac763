# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rotary word that stays in its room along a pass and never turns faster than a rate.

course   where along the pass a row lies: the length that has been cut, mm. Moves that close a gap count
         nothing, so that all rows of one contact point stand at one place.
rate     of a word: rad per mm of the course.
leash    how far a word may turn along the course, at most: the integral of the rates that are allowed, rad at
         each row.
reach    of bounds on a leash: what a word can take up while it keeps within the bounds everywhere, which is
         their inf-convolution with a cone: ``min over t of high(t) + |leash(s) - leash(t)|`` (McShane's
         extension). A word on that leash exists if and only if the lower bounds' reach is nowhere above the
         upper bounds' reach.

A reach takes two running minima, so nothing here goes row by row.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats

SLACK = 1e-9
"""rad by which reaches may cross and still count as meeting."""
STEEPEST = 1e6
"""rad/mm; a word that has to turn faster than this jumps."""
RAISE = 1.2
"""Factor by which a rate that is too low is raised at a time: so close do the rates found come to the least
possible ones."""
SPARE = 1.1
"""The rate that is allowed, in rates found, where those had to be raised: the given word is then left alone
sooner."""


def cut_length(centre: Floats, fill: Bools) -> Floats:
    """Return the length (n,) mm cut up to each row of one polyline: ``centre`` (n, 3) mm, ``fill`` (n,) as in
    OffsetPath."""
    step = np.linalg.norm(np.diff(centre, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(np.where(fill[1:], 0.0, step))])


def upper_reach(leash: Floats, high: Floats) -> Floats:
    """Return the most (n,) that a word on the ``leash`` (n,) rad can be while it keeps below the bounds
    ``high`` (n,)."""
    ahead = np.minimum.accumulate(high - leash) + leash
    behind = np.minimum.accumulate((high + leash)[::-1])[::-1] - leash
    return np.asarray(np.minimum(ahead, behind))


def lower_reach(leash: Floats, low: Floats) -> Floats:
    """Return the least (n,), as :func:`upper_reach`."""
    return -upper_reach(leash, -low)


def least_rates(along: Floats, low: Floats, high: Floats, floor: float) -> Floats | None:
    """Rates (n - 1,) rad/mm between the places ``along`` (n,) mm, low and even, at which a word between the
    bounds (n,) exists; None where none does.

    They are ``floor`` wherever that will do, and are raised together where the reaches cross, that is between
    the bounds that need it.
    """
    step, rate = np.diff(along), np.full(len(along) - 1, floor)
    while True:
        leash = leash_of(along, rate)
        crossed = lower_reach(leash, low) > upper_reach(leash, high) + SLACK
        if not crossed.any():
            return np.where(rate > floor, SPARE * rate, rate)
        tight = (crossed[1:] | crossed[:-1]) & (step > 0.0)
        rate[tight] *= RAISE
        if not tight.any() or rate.max() > STEEPEST:
            return None


def laziest(low: Floats, high: Floats, start: float) -> Floats:
    """Return the word (n,) of least travel between the bounds (n,) that begins nearest to ``start``: it turns
    only when pushed by one.

    Being pushed is ``clip``, and two clips in a row are one: so the bounds of 2, 4, 8 ... rows are joined in
    turn.
    """
    low, high, span = low.copy(), high.copy(), 1
    while span < len(low):
        low_before, high_before = low[:-span].copy(), high[:-span].copy()
        low_here, high_here = low[span:].copy(), high[span:].copy()
        low[span:] = np.clip(low_before, low_here, high_here)
        high[span:] = np.clip(high_before, low_here, high_here)
        span *= 2
    return np.asarray(np.clip(start, low, high))


def leash_of(along: Floats, rate: Floats) -> Floats:
    """Return the leash (n,) rad at rates (n - 1,) rad/mm between the places ``along`` (n,) mm."""
    return np.concatenate([[0.0], np.cumsum(rate * np.diff(along))])


def even_out_word(leash: Floats, word: Floats, low: Floats, high: Floats) -> Floats:
    """Return a word (n,) between the bounds and on the leash, one that exists: the given one where that turns
    no faster.

    Where it does, the mean of its upper and its lower reach is taken, which of all words on the leash is the
    one that leaves it least (in the largest difference).
    """
    least, most = lower_reach(leash, low), upper_reach(leash, high)
    most = np.maximum(most, least)
    held = np.clip(word, least, most)
    middle = 0.5 * (upper_reach(leash, held) + lower_reach(leash, held))
    return np.asarray(np.clip(middle, least, most))
