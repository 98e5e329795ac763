# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fewest pieces of each block, found for all blocks of a portion at once.

trial     one round: all blocks in a number of pieces each, judged; then each block's next number is chosen,
          and its shares are balanced anew. So a block is not stepped through from start to end: all its
          pieces move together, they end up alike, and no scrap is left at its end.
count     of pieces. ``lower``: too few; ``best``: the fewest so far that hold.

Why this finds the fewest. Let a step that is part of another never deviate more than that. Of two divisions
of a block into the same count, some piece of the one holds a piece of the other. So where **all** pieces of
one trial exceed the tolerance, no division into this count holds it, and the longest feasible steps one after
the other would not either. Balancing goes on until that is seen, or all pieces hold. The rounding of the
words is noise on this: a block that stays between both is taken for one that needs a little more, and where
that leaves a doubt, it is compared with halving (``halving``).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.trajectory import frames

from .balance import balance_shares, even_shares, first_rows
from .commanded_moves import CommandedMoves, Steps, follow
from .proof import judge_pieces, off_segment

ROUNDS = 200
"""A stop that no block needs: the slowest were seen to take 30."""
FIRST = 0.5
"""Share of the count that the whole block's deviation asks for: half as many pieces show the load as well."""
FEW = 8
"""Pieces up to which the deviation is not yet a matter of the square of the length: more trials are made."""
PATIENCE_FEW, PATIENCE_CALM, PATIENCE = 4, 2, 1
"""Trials with the same count, where pieces are few; where the load with the most rounding seen asks for no
more; elsewhere."""
TIE = 0.1
"""A load may exceed the count by so much, and the count be tried again."""
CLOSE, CLOSE_LEAST, CLOSE_MOST = 0.05, 0.3, 0.5
"""One piece less is not tried where the load exceeds it by this share of the count, within these limits."""
MOST_MORE = 0.1
"""Share of the count that is added at most at a time."""
STUCK = 8
"""Additions after which rounding is what keeps a block from holding."""
RELAXED = 8
"""How often the tolerance of such a block is doubled."""
LEAST_ROOM = 0.3
"""Share of the tolerance that is left to the deviation, however much rounding takes, when loads are worked
out."""
LARGEST_LOAD = 1e4
"""Load of a piece without usable words."""


@dataclass(frozen=True, eq=False)
class Divided:
    """``count`` (b,) pieces of each block, 1 where it is left whole; of the rows between pieces, in order:
    ``share`` (r,) and ``words`` (r, 5) mm and degrees; ``goal`` (b,) mm: the tolerance asked of it in the
    end, and ``held`` (b,) mm: what is proven of its worst piece, both infinite where nothing is; ``doubt``
    (b,): fewer pieces may do."""

    count: Ints
    share: Floats
    words: Floats
    goal: Floats
    held: Floats
    doubt: Bools

    def take(self, blocks: Ints) -> Divided:
        """Return the division of some blocks, ascending."""
        rows = np.flatnonzero(np.isin(np.repeat(np.arange(len(self.count)), self.count - 1), blocks))
        goal, held = self.goal[blocks], self.held[blocks]
        return Divided(self.count[blocks], self.share[rows], self.words[rows], goal, held, self.doubt[blocks])

    def with_others(self, rows: Ints, others: Divided) -> Divided:
        """Return the same with the blocks ``rows`` as they are in ``others``."""
        count, goal, held, doubt = self.count.copy(), self.goal.copy(), self.held.copy(), self.doubt.copy()
        count[rows], goal[rows], held[rows], doubt[rows] = (
            others.count,
            others.goal,
            others.held,
            others.doubt,
        )
        block = np.repeat(np.arange(len(self.count)), self.count - 1)
        own = np.flatnonzero(~np.isin(block, rows))
        order = np.argsort(np.concatenate([block[own], np.repeat(rows, others.count - 1)]), kind="stable")
        share = np.concatenate([self.share[own], others.share])[order]
        return Divided(
            count, share, np.concatenate([self.words[own], others.words])[order], goal, held, doubt
        )


@dataclass(eq=False)
class _State:
    """What is known of the blocks that are not done.

    ``row`` in the portion; the ``count`` tried now; counts that are ``lower`` than needed, and ``proven`` to
    be so; the ``best`` (0: none yet); ``tries`` at this count; how often ``stuck`` and ``relaxed``; ``goal``
    mm; ``limit`` of the count.
    """

    row: Ints
    count: Ints
    lower: Ints
    best: Ints
    proven: Ints
    tries: Ints
    stuck: Ints
    relaxed: Ints
    goal: Floats
    limit: Ints

    def take(self, rows: Ints) -> _State:
        return _State(*(column[rows] for column in vars(self).values()))


@dataclass(frozen=True, eq=False)
class _Trial:
    """Rows of all pieces' ends: ``share``, ``words``, ``block``, and ``load`` with the most rounding of the
    block's rows.

    Blocks (b,): ``worst`` mm, what is proven of the worst piece; ``least`` mm, what the best piece takes at
    least; ``need``: the whole load with each piece's own rounding.
    """

    share: Floats
    words: Floats
    block: Ints
    load: Floats
    worst: Floats
    least: Floats
    need: Floats


def divide(
    kinematics: Chain, way: CommandedMoves, deviation: Floats, limit: Ints, tolerance: float, steps: Steps
) -> Divided:
    """Divide blocks into the fewest pieces whose rounded words are proven to stay within ``tolerance`` (mm).

    ``deviation`` (b,) mm of the undivided blocks, for a first guess; ``limit`` (b,) of pieces, beyond which a
    block counts as impossible and is left whole. Blocks that rounding keeps from holding get twice the
    tolerance, or four times, and so on.
    """
    size = len(way.tip)
    guess = np.minimum(np.sqrt(deviation / tolerance), limit)
    count = np.maximum(2, np.ceil(FIRST * guess)).astype(np.int64)
    one, best, proven, tries, stuck, relaxed = np.zeros((6, size), np.int64) + np.array(
        [[1], [0], [1], [0], [0], [0]]
    )
    state = _State(
        np.arange(size),
        count,
        one,
        best,
        proven,
        tries,
        stuck,
        relaxed,
        np.full(size, float(tolerance)),
        limit,
    )
    share, chosen = even_shares(count), np.full(size, -1)
    goal, held, doubt, records = np.full(size, np.inf), np.full(size, np.inf), np.zeros(size, bool), []
    for round_ in range(ROUNDS):
        trial = _try_division(kinematics, way, state, share, steps)
        good = trial.worst <= state.goal
        chosen[state.row[good]], goal[state.row[good]], held[state.row[good]] = (
            round_,
            state.goal[good],
            trial.worst[good],
        )
        records.append(_record(trial, state.row, good, round_))
        before = state.count
        going, doubt[state.row] = _decide(state, trial, good)
        if not len(going):
            break
        calm = (state.tries + state.stuck > 0) & (state.count > FEW)
        share = balance_shares(trial.share, trial.load, before, calm, going, state.count[going])
        state = state.take(going)
    return _gather_rounds(records, chosen, goal, held, doubt)


def _try_division(
    kinematics: Chain, way: CommandedMoves, state: _State, share: Floats, steps: Steps
) -> _Trial:
    frame, first = frames(kinematics), first_rows(state.count)
    block = np.repeat(np.arange(len(first)), state.count + 1)
    at, piece, inside = state.row[block], block[1:], block[1:] == block[:-1]
    words = follow(kinematics, way, at, share, steps)
    off = off_segment(frame, words, way.tip[at], way.chord[at])
    judged = judge_pieces(frame, words, inside, off, state.goal[piece], piece)
    rounding = np.where(inside, judged.off, 0.0)
    most_rounding = np.maximum.reduceat(np.append(rounding, 0.0), first)[piece]
    need, load = (
        _load(judged.least, state.goal[piece], taken, inside) for taken in (rounding, most_rounding)
    )
    worst = np.append(np.where(inside, judged.most + rounding, 0.0), 0.0)
    least = np.append(np.where(inside, judged.least + rounding, np.inf), np.inf)
    worst, least, need = (
        np.maximum.reduceat(worst, first),
        np.minimum.reduceat(least, first),
        np.add.reduceat(need, first),
    )
    return _Trial(share, words, block, load, worst, least, need)


def _load(deviation: Floats, goal: Floats, rounding: Floats, inside: Bools) -> Floats:
    """Return the load of all rows from that of the pieces between them."""
    room = np.maximum(goal - rounding, LEAST_ROOM * goal)
    return np.append(np.where(inside, np.minimum(np.sqrt(deviation / room), LARGEST_LOAD), 0.0), 0.0)


def _decide(state: _State, trial: _Trial, good: Bools) -> tuple[Ints, Bools]:
    """Choose each block's next count, in ``state``. Returns the blocks that go on, and where fewer pieces may
    do."""
    count, need = state.count, trial.need
    wanted = np.maximum(np.ceil(need).astype(np.int64), state.lower + 1)
    state.best[good] = count[good]
    too_few = ~good & (trial.least > state.goal)
    state.lower[too_few] = np.maximum(state.lower, count)[too_few]
    state.proven[too_few] = np.maximum(state.proven, count)[too_few]
    calm = np.bincount(trial.block, trial.load) <= count
    patience = np.where(count <= FEW, PATIENCE_FEW, np.where(calm, PATIENCE_CALM, PATIENCE))
    again = ~good & ~too_few & (need <= count + TIE) & (state.tries < patience)
    state.tries = np.where(again, state.tries + 1, 0)
    _add(state, trial, ~good & ~too_few & ~again, wanted)
    after = np.where(
        good, np.minimum(wanted, count - 1), np.where(again, count, np.maximum(wanted, state.lower + 1))
    )
    enough = good & (need > count - 1 + np.clip(CLOSE * count, CLOSE_LEAST, CLOSE_MOST))
    done = (state.best > 0) & ((after <= state.lower) | (after >= state.best) | enough)
    endless = (state.best == 0) & (after > state.limit)
    state.goal[endless] = np.inf
    _relax(state, (state.best == 0) & ~endless & (state.stuck > STUCK), after)
    state.count = after
    return np.flatnonzero(~done & np.isfinite(state.goal)), done & (~enough | (state.best <= FEW)) & (
        state.best - 1 > state.proven
    )


def _add(state: _State, trial: _Trial, tie: Bools, wanted: Ints) -> None:
    """Take it that more pieces are needed where trials stayed undecided: as many more as the worst piece asks
    for."""
    excess = np.sqrt(np.minimum(trial.worst / state.goal, 4.0)) - 1.0
    more = np.floor(np.clip(excess, 0.0, MOST_MORE) * state.count).astype(np.int64)
    more[state.count <= FEW] = 0
    state.lower[tie] = np.maximum(state.lower, state.count + more)[tie]
    state.stuck[tie & (wanted <= state.count + 1 + more)] += 1


def _relax(state: _State, lost: Bools, after: Ints) -> None:
    """Allow twice as much to the blocks that are lost; they are given up where that has been done too
    often."""
    state.relaxed[lost] += 1
    state.goal[lost] *= np.where(state.relaxed[lost] > RELAXED, np.inf, 2.0)
    state.lower[lost], state.proven[lost], state.stuck[lost], state.tries[lost] = 1, 1, 0, 0
    after[lost] = np.clip(0.75 * after[lost], 2, state.limit[lost]).astype(np.int64)


_Record = tuple[Ints, Ints, Floats, Floats]


def _record(trial: _Trial, row: Ints, good: Bools, round_: int) -> _Record:
    """Round, block, share and words of the rows between the pieces of blocks that hold."""
    inner = np.flatnonzero(good[trial.block] & (trial.share > 0.0) & (trial.share < 1.0))
    return np.full(len(inner), round_), row[trial.block[inner]], trial.share[inner], trial.words[inner]


def _gather_rounds(records: list[_Record], chosen: Ints, goal: Floats, held: Floats, doubt: Bools) -> Divided:
    """Of each block the rows of the round that was ``chosen`` last."""
    round_, row, share, words = (np.concatenate(parts) for parts in zip(*records, strict=True))
    last = np.flatnonzero(chosen[row] == round_)
    order = last[np.argsort(row[last], kind="stable")]
    count = np.bincount(row[order], minlength=len(chosen)) + 1
    return Divided(count, share[order], words[order], goal, held, doubt & np.isfinite(goal))
