# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order in which polylines are cut, for little way between them.

piece   a polyline; it may be cut from either end.
air     the straight distance from where one piece ends to where the next begins, summed over all of them.
tour    pieces in their order, and which of them are cut backwards: from each piece to the nearest end that is
        left, then stretches of the tour turned round as long as that saves air (2-opt).
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
import scipy

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM

from .contact_path import ContactPath

WORTH = 0.8
"""Of the air in the order of the passes: a tour that does not spare more than the rest is not worth leaving
that order for."""

NEAR = 16
"""Ends that are looked at first from each end; only where all of them are used up all that are left are."""

TURNS = 4
"""Times, at most, that the whole tour is gone through for stretches to turn round."""

STRETCH = 500
"""Pieces, at most, that are turned round together."""

LITTLE = 0.01
"""Of the air: when a whole time has saved no more, it is enough."""


class Tour(NamedTuple):
    """``piece`` (p,) the polylines in order; ``back`` (p,) True where one is cut from its end to its
    start."""

    piece: Ints
    back: Bools


def order_pieces(contact: ContactPath) -> ContactPath:
    """Give the polylines in an order, and each the way round, that spares air; the very path where that is
    not worth it."""
    if not len(contact.point):
        return contact
    first = np.flatnonzero(np.diff(contact.polyline, prepend=-1))
    last = np.append(first[1:], len(contact.point)) - 1
    tour = find_better_tour(np.stack([contact.point[first], contact.point[last]], axis=1))
    return contact if tour is None else arrange_pieces(contact, first, last, tour)


def find_better_tour(ends: Floats) -> Tour | None:
    """Find a tour of pieces with these ``ends`` (p, 2, d), start and end of each, that spares enough of the
    air to leave their order for it; None where there is none."""
    tour = find_tour(ends)
    now = Tour(np.arange(len(ends)), np.zeros(len(ends), bool))
    return None if air(ends, tour) > WORTH * air(ends, now) else tour


def air(ends: Floats, tour: Tour) -> float:
    """Return the way between the pieces, mm; ``ends`` (p, 2, d) mm: start and end of each piece."""
    leaves, enters = _doors(ends, tour)
    return float(np.linalg.norm(enters[1:] - leaves[:-1], axis=1).sum())


def find_tour(ends: Floats) -> Tour:
    """Begin with the first piece as it is, go to the nearest end that is left, again and again; then turn
    stretches round."""
    return _improve_tour(ends, _nearest(ends))


def _doors(ends: Floats, tour: Tour) -> tuple[Floats, Floats]:
    """Where each piece of the tour is left and entered, (p, 3) each."""
    side = tour.back.astype(np.int64)
    return ends[tour.piece, 1 - side], ends[tour.piece, side]


def _nearest(ends: Floats) -> Tour:
    """Return the nearest neighbours' tour."""
    count, places = len(ends), ends.reshape(2 * len(ends), -1)
    near = (
        scipy.spatial.cKDTree(places)
        .query(places, k=min(NEAR, len(places)))[1]
        .reshape(len(places), -1)
        .tolist()
    )
    open_, order = np.ones(count, bool), [0]
    open_[0], at = False, 1  # place 2i is the start of piece i, 2i + 1 its end
    for _ in range(count - 1):
        into = next((one for one in near[at] if open_[one >> 1]), None)
        if into is None:
            left = np.repeat(2 * np.flatnonzero(open_), 2) + np.tile([0, 1], int(open_.sum()))
            into = int(left[np.linalg.norm(places[left] - places[at], axis=1).argmin()])
        order.append(into)
        open_[into >> 1], at = False, into ^ 1
    entered = np.array(order)
    return Tour(entered >> 1, (entered & 1).astype(bool))


def _improve_tour(ends: Floats, tour: Tour) -> Tour:
    """2-opt: of each piece the stretch behind it whose turning saves most; ``tour`` is changed in place."""
    for _ in range(TURNS):
        saved, doors = 0.0, _doors(ends, tour)
        for i in range(len(tour.piece) - 1):
            size, saving = _best_turn(*doors, i)
            if saving > COINCIDENT_MM:
                stretch = slice(i + 1, i + 1 + size)
                tour.piece[stretch], tour.back[stretch] = tour.piece[stretch][::-1], ~tour.back[stretch][::-1]
                doors[0][stretch], doors[1][stretch] = (
                    doors[1][stretch][::-1].copy(),
                    doors[0][stretch][::-1].copy(),
                )
                saved += saving
        if saved <= LITTLE * air(ends, tour):
            break
    return tour


def _best_turn(leaves: Floats, enters: Floats, i: int) -> tuple[int, float]:
    """How many pieces behind piece i are best turned round together, and what that saves, mm: then the end of
    i leads to the end of the last of them, and the start of the first to the start of the piece behind."""
    left, behind = leaves[i + 1 : i + 1 + STRETCH], enters[i + 2 : i + 2 + STRETCH]
    end = np.zeros(len(left) - len(behind))  # behind the last piece nothing is entered
    now = np.append(np.linalg.norm(behind - left[: len(behind)], axis=1), end) + np.linalg.norm(
        enters[i + 1] - leaves[i]
    )
    new = np.append(np.linalg.norm(behind - enters[i + 1], axis=1), end) + np.linalg.norm(
        left - leaves[i], axis=1
    )
    best = int((now - new).argmax())
    return best + 1, float(now[best] - new[best])


def arrange_pieces(contact: ContactPath, first: Ints, last: Ints, tour: Tour) -> ContactPath:
    """Return the rows of the polylines in the order of the tour."""
    row, piece, _ = tour_rows(first, last, tour)
    columns = {name: getattr(contact, name)[row] for name in ("point", "normal", "face", "coedge", "pass_")}
    return replace(contact, segment=np.arange(len(row)) >> 1, polyline=piece, **columns)


def tour_rows(first: Ints, last: Ints, tour: Tour) -> tuple[Ints, Ints, Bools]:
    """Give the rows (n,) of the pieces, each from its ``first`` to its ``last`` (p,), as the tour takes them;
    to which place in the tour each belongs (n,), and whether it is taken backwards (n,)."""
    size = (last - first + 1)[tour.piece]
    piece, within = number_runs(size)
    start, step = np.where(tour.back, last[tour.piece], first[tour.piece]), np.where(tour.back, -1, 1)
    return start[piece] + step[piece] * within, piece, tour.back[piece]
