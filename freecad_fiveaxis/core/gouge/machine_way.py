# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way of all axes in a program, in pieces in which they go in step, for what is checked against the
machine.

guided    a block whose tip the controller guides: at the share u of it the driven point is on its chord and
          the rotary words are their ends' mixture; the linear axes do what keeps the point there.
piece     a part of a guided block between two rows that are put in, each where the axes then really stand; a
          block of another kind is one piece.
off       mm: no point that linear axes carry is farther at any u from where it would be if all axes went in
          step through the piece.

**Why that is a proof.** At the same share of a piece the rotary words of both ways are the same, and so is
how everything is turned; only the linear joints differ, by e. The driven point differs by ``M e``, the
columns of M being the linear axes as they stand, and by no more than d, the bound of the deviation at the
same u (:func:`~.motion.deviation.bound.quick_bound`). So ``|e| <= d / s``, s the least singular value of M.
What any of the linear axes carry differs by their sum of ``e_j`` times a unit vector: where no rotary axis
stands between linear ones no more than ``S |e|``, S the largest singular value (one, like s, where the axes
are square to each other); else no more than ``sqrt(3) |e|``. What no linear axis moves does not differ. A
collision that is deeper than the tolerance on the real way is therefore deeper than the tolerance less
``off`` on the way in step; and one of depth d on the way in step is at least ``d - off`` deep on the real
one.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, number_runs
from freecad_fiveaxis.core.machine.kinematics import Chain, forward_tip, words_to_q
from freecad_fiveaxis.core.motion.deviation.bound import quick_bound
from freecad_fiveaxis.core.motion.program import Program, find_unknown_ways, standing
from freecad_fiveaxis.core.motion.trajectory import FARTHEST_WORD

from .check import GougeCheck
from .known_depths import Entries

SHARE = 0.25
"""Of the tolerance: so much ``off`` is at most."""

MOST_PARTS, MOST_ROWS = 8192, 3_000_000
"""Pieces of a block, and of a program."""

ROUNDS = 12
"""Of division: the bound of a piece is seldom exactly that of its block by the square of their number."""

ROOM = 1.05
"""So many times more pieces than the square root asks for: spares a round."""

UNBOUNDED = 4.0
"""So many times more where the bound of a piece says nothing, because it turns too far."""

LEAST_SINGULAR = 1e-3
"""Linear axes that nearly lie in a plane bound nothing."""


class MachineWay(NamedTuple):
    """``program``: as it is, m rows; ``in_step``: with the rows of all pieces, not guided. Of each of k
    pieces the ``block`` (k,) of the program to which it belongs, its ``begin`` and ``width`` (k,) as shares
    of it; ``off`` mm of the worst one. ``undecided`` (m - 1,): guided blocks that cannot be divided finely
    enough; of these the ends alone are in ``in_step``."""

    program: Program
    in_step: Program
    block: Ints
    begin: Floats
    width: Floats
    off: float
    undecided: Bools

    def with_words(self, words: Floats, in_step: Floats) -> MachineWay:
        """Give the same pieces with other words (m, 5) and (k + 1, 5), mm and degrees, of rows that are not
        guided."""
        return self._replace(
            program=replace(self.program, words=words, guided=None),
            in_step=replace(self.in_step, words=in_step),
        )

    def locate(self, piece: int, u: float | None) -> tuple[int, float | None]:
        """Tell of a piece and u the block of the program, and u there."""
        return int(self.block[piece]), None if u is None else float(self.begin[piece] + u * self.width[piece])

    def fold(self, check: GougeCheck) -> GougeCheck:
        """Give a check of the pieces as one of the program's blocks: of each the deepest piece."""
        first = np.flatnonzero(np.diff(self.block, prepend=-1))
        buried = np.logical_or.reduceat(check.buried, first) if len(first) else check.buried
        return GougeCheck(self._fold(check.cutter, first), self._fold(check.above, first), buried, ())

    def _fold(self, found: Entries, first: Ints) -> Entries:
        if not len(first):
            return found
        order = np.lexsort((found.depth, self.block))
        best = order[np.append(first[1:], len(order)) - 1]
        depth = found.depth[best]
        return Entries(
            np.where(depth > 0.0, depth - self.off, 0.0),
            np.maximum.reduceat(found.bound, first) + self.off,
            self.begin[best] + found.u[best] * self.width[best],
            found.place[best],
            found.facet[best],
            found.part[best],
        )


def plain_way(program: Program) -> MachineWay:
    """Give the way of a program in whose blocks all axes go in step."""
    every = np.arange(max(len(program.words) - 1, 0))
    zero = np.zeros(len(every))
    return MachineWay(program, program, every, zero, zero + 1.0, 0.0, np.zeros(len(every), np.bool_))


def lay_way(kinematics: Chain, program: Program, tolerance: float) -> MachineWay:
    """Give the way of a program, its guided blocks in the fewest pieces that keep ``off`` within SHARE of
    ``tolerance`` mm."""
    if program.guided is None or len(program.words) < 2:
        return plain_way(program)
    most = SHARE * tolerance
    guided: Bools = np.asarray(program.guided.on[1:] & ~find_unknown_ways(program))
    parts, lost = np.ones(len(guided), np.int64), np.zeros(len(guided), np.bool_)
    for _ in range(ROUNDS):
        way, off = _divide(kinematics, program, parts, guided)
        worst = np.where(guided & ~lost, _worst_of(way, off), 0.0)
        wide = worst > most
        if not wide.any():
            break
        parts, lost = _more_parts(parts, worst, most, wide, lost)
    lost |= wide
    if lost.any():
        way, off = _divide(kinematics, program, np.where(lost, 1, parts), guided)
        way = _ends_alone(way, lost)
    return way._replace(off=float(np.max(off, initial=0.0, where=(guided & ~lost)[way.block])))


def _worst_of(way: MachineWay, off: Floats) -> Floats:
    """Give of each block the worst of its pieces (m - 1,)."""
    return np.asarray(np.maximum.reduceat(off, np.flatnonzero(np.diff(way.block, prepend=-1))))


def _more_parts(parts: Ints, worst: Floats, most: float, wide: Bools, lost: Bools) -> tuple[Ints, Bools]:
    """Give more parts to blocks that are too ``wide``, as far as there may be; those that would be too many
    are lost, the longest first."""
    more = np.where(np.isfinite(worst), ROOM * np.sqrt(worst / most), UNBOUNDED)
    wanted = np.where(wide, np.ceil(parts * more), parts)
    gone: Bools = np.asarray(lost | ~(wanted <= MOST_PARTS))
    wanted = np.where(gone, 1.0, wanted)
    order = np.argsort(wanted, kind="stable")
    gone[order] |= np.cumsum(wanted[order]) > MOST_ROWS + len(parts)
    return np.where(gone, 1.0, wanted).astype(np.int64), gone


def _ends_alone(way: MachineWay, lost: Bools) -> MachineWay:
    unknown = np.concatenate([[False], find_unknown_ways(way.in_step) | lost[way.block]])
    return way._replace(in_step=replace(way.in_step, unknown_way=unknown), undecided=lost)


def _divide(kinematics: Chain, program: Program, parts: Ints, guided: Bools) -> tuple[MachineWay, Floats]:
    """Put rows into the blocks, each then of so many ``parts`` (m - 1,); and tell how far (k,) mm the guided
    pieces are off, inf where that is not bounded."""
    block, step = number_runs(parts)
    share = 1.0 / parts[block]
    owner = np.concatenate([[0], block + 1])
    columns = ("feed", "inverse_time", "motion", "seconds", "row", "line")
    taken = {name: getattr(program, name)[owner] for name in columns}
    unknown = None if program.unknown_way is None else program.unknown_way[owner]
    words = _put_in(kinematics, program, block, step, parts)
    bad: Bools = np.asarray(~(np.abs(words) <= FARTHEST_WORD).all(axis=1))  # NaN, too
    words[bad] = program.words[owner[bad]]
    in_step = replace(program, words=words, guided=None, unknown_way=unknown, findings=(), **taken)
    off = np.where(guided[block], _bound_off(kinematics, words), 0.0)
    off[(bad[1:] | bad[:-1]) & guided[block]] = np.inf
    way = MachineWay(program, in_step, block, step * share, share, 0.0, np.zeros(len(parts), np.bool_))
    return way, off


def _put_in(kinematics: Chain, program: Program, block: Ints, step: Ints, parts: Ints) -> Floats:
    """Give the words (k + 1, 5) mm and degrees at which the pieces end, after those of row 0: of the last
    piece of each block those of the program, as they are."""
    words: Floats = program.words[np.concatenate([[0], block + 1])]
    inside = np.flatnonzero(step + 1 < parts[block])
    before = block[inside]
    u = ((step[inside] + 1) / parts[before])[:, None]
    tip = forward_tip(kinematics, words_to_q(program.words))
    angles = program.words[:, 3:]
    words[inside + 1] = standing(
        kinematics,
        tip[before] + u * (tip[before + 1] - tip[before]),
        angles[before] + u * (angles[before + 1] - angles[before]),
    )
    return words


def _bound_off(kinematics: Chain, words: Floats) -> Floats:
    """Bound how far (k,) mm what linear axes carry is from where it would be in step, between rows of words
    (k + 1, 5)."""
    bound = quick_bound(kinematics, words)[1:]
    if len(set(kinematics.slot)) == 1:
        singular = np.linalg.svd(kinematics.direction[:3], compute_uv=False)
        return np.asarray(bound * (singular[0] / singular[-1]))
    least = _least_singular(kinematics, words)
    return np.where(
        least > LEAST_SINGULAR, bound * (math.sqrt(3.0) / np.maximum(least, LEAST_SINGULAR)), np.inf
    )


def _least_singular(kinematics: Chain, words: Floats) -> Floats:
    """Bound from below the least singular value (k,) of the linear axes as they stand anywhere in a piece: in
    its middle, less what the turns to its ends can change, which is at most as much in each of the three."""
    middle = words_to_q(0.5 * (words[1:] + words[:-1]))
    here = forward_tip(kinematics, middle)
    columns = [forward_tip(kinematics, middle + np.eye(5)[j]) - here for j in range(3)]
    least = np.linalg.svd(np.stack(columns, axis=-1), compute_uv=False)[:, -1]
    turned = 0.5 * np.radians(np.abs(np.diff(words[:, 3:], axis=0)).sum(axis=1))
    return np.asarray(least - math.sqrt(3.0) * turned)
