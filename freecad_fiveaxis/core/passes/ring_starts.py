# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where closed passes begin: anywhere will do for the part, but not for a rotary axis with limits.

ring      a closed pass along which a rotary word makes a whole turn. All in one it takes a turn of the axis,
          and what the axes waver more; whether that lies within the limits is settled by where it begins.
margin    how far, rad, the words of a ring stay within the limits at their nearest whole turn; negative where
          they do not fit.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .contact_path import ContactPath

TURN = 2.0 * math.pi


def find_closed(contact: ContactPath, keep: Bools) -> Ints:
    """Return the first row and the one behind the last (r, 2) of each closed polyline that lies on facets to
    ``keep`` (f,) all along."""
    edge = np.flatnonzero(np.diff(contact.polyline, prepend=-1, append=-1))
    first, behind = edge[:-1], edge[1:]
    closed = (contact.point[first] == contact.point[behind - 1]).all(axis=1)
    kept = np.logical_and.reduceat(keep[contact.face], first) if len(first) else closed
    return np.asarray(np.stack([first, behind], axis=1)[closed & kept])


def find_start(word: Floats, low: float, high: float) -> int:
    """Return the row, an even one, at which a closed polyline best begins: all of its words, rad, given
    ``word`` (n,) but for whole turns, then lie deepest within ``low`` and ``high``. -1 where the words make
    no whole turn along it: it may begin anywhere."""
    step = _steps(word)
    net = float(step.sum())
    if abs(net) < math.pi:
        return -1
    way = word[0] + np.concatenate([[0.0], np.cumsum(step[:-1])])
    return 2 * int(_margins(np.concatenate([way, way + net]), len(way), low, high)[::2].argmax())


def find_turn(word: Floats) -> float:
    """Return how far, rad, a closed polyline turns an axis whose words are ``word`` (n,), given but for whole
    turns: whole turns, or 0."""
    return float(_steps(word).sum())


def _steps(word: Floats) -> Floats:
    step = np.diff(word, append=word[:1])
    return np.asarray(step - TURN * np.rint(step / TURN))


def _margins(way: Floats, count: int, low: float, high: float) -> Floats:
    """Return the margin (count,) of ``count`` words from each row on, of a ring's words unwound twice round
    (2 count,)."""
    least, most = _ranges(way, count)
    off = 0.5 * (low + high) - 0.5 * (most + least)
    off -= TURN * np.rint(off / TURN)
    return np.asarray(0.5 * (high - low) - 0.5 * (most - least) - np.abs(off))


def _ranges(way: Floats, count: int) -> tuple[Floats, Floats]:
    """Return the least and the most (count,) of ``count`` words from each row on, of the same."""
    ahead = -(count // 2)  # the window begins at the row, and is not centred on it
    most = scipy.ndimage.maximum_filter1d(way, count, origin=ahead)[:count]
    least = scipy.ndimage.minimum_filter1d(way, count, origin=ahead)[:count]
    return least, most


def unwind_ring(word: Floats) -> tuple[Floats, float]:
    """Return the words (n, 4), rad, of a closed polyline begun at each of its rows: the first, the last, the
    least and the most of them, unwound; and how far it turns the axis. ``word`` (n,) but for whole turns."""
    step = _steps(word)
    net = float(step.sum())
    way = word[0] + np.concatenate([[0.0], np.cumsum(step[:-1])])
    ranges = _ranges(np.concatenate([way, way + net]), len(way))
    return np.stack([way, way + net, *ranges], axis=1), net


def begin_at(contact: ContactPath, closed: Ints, start: Ints) -> ContactPath:
    """Return the passes with the ``closed`` polylines (r, 2) begun ``start`` (r,) rows later, an even number
    each; their sense and the order of all stay."""
    order = np.arange(len(contact.point))
    for (first, behind), rows in zip(closed.tolist(), start.tolist(), strict=True):
        order[first:behind] = np.roll(order[first:behind], -rows)
    columns = {name: getattr(contact, name)[order] for name in ("point", "normal", "face", "coedge")}
    return replace(contact, **columns)


def reverse(contact: ContactPath, closed: Ints) -> ContactPath:
    """Return the passes with the ``closed`` polylines (r, 2) in the other sense; each begins where it did."""
    order = np.arange(len(contact.point))
    for first, behind in closed.tolist():
        order[first:behind] = order[first:behind][::-1]
    columns = {name: getattr(contact, name)[order] for name in ("point", "normal", "face", "coedge")}
    return replace(contact, **columns)


def find_sense(when: Ints) -> float:
    """Find whether contacts are cut in their order, 1.0, or a later stage has turned them round, -1.0, as the
    tour of the pieces does; ``when`` (n,): the rows that cut them. 0.0 where it is neither more."""
    return float(np.sign(np.sign(np.diff(when)).sum()))
