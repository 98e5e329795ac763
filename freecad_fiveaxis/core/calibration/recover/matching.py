# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which row of the CL path a block of the program came from.

Mostly the n-th block comes from the n-th row, or from the n-th that moves. Where a post has put in rapids or
left rows out, the two sequences are aligned: the pairing, in order, with the largest sum of likenesses
(Needleman & Wunsch 1970, gaps cost nothing).

likeness   before a machine is known: how near the tool axis of a trial layout comes to that of the row, and
           whether the last step was equally long (where the rotary words rest, the length of a step is the
           same in both). Once it is known: how near the tip comes.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.toolpath.cl_path import CLPath

from .layouts import every_layout
from .model import UNKNOWNS, Layout, rows_of
from .pairs import Pairs, Steps, step_of

MOST = 2000
"""Rows and blocks that are aligned, or as many more of the one as there are fewer of the other: time and
memory grow with their product."""
PROBE = 250
"""Rows and blocks by which the layout for the alignment is chosen."""
STRANGE, ENOUGH = 2.0, 0.3
"""Layouts as strange as that are tried where the others make a smaller share of the rows alike than this."""
AXIS_ALIKE, LENGTH_ALIKE, TIP_ALIKE = 1e-3, 2e-3, 0.05
"""rad, mm, mm: beyond these two are not alike at all."""
STILL = (0.0, 1e-6, 1e-5, 5e-5, 1e-4)
"""mm and 1: rows that move by less are the same to a post, which may leave them out."""
LEAST = 2


@dataclass(frozen=True, eq=False)
class Sequences:
    """All rows of the path and all blocks of the program, columns as in Pairs, not yet paired."""

    letters: str
    tip: Floats
    axis: Floats
    row: Ints
    linear: Floats
    rotary: Floats
    line: Ints
    steps: Steps

    def pair_rows(self, rows: Ints, blocks: Ints) -> Pairs:
        """Return the pairs with both ends. Raises ProgramError where hardly any are left."""
        if len(rows) < LEAST:
            text = say(
                "only {count} of {rows} CL rows can be paired with the program's {blocks} blocks; give a "
                "program that was posted from this CL path",
                count=len(rows),
                rows=len(self.row),
                blocks=len(self.line),
            )
            raise ProgramError(text, len(rows))
        columns = (
            self.tip[rows],
            self.axis[rows],
            self.linear[blocks],
            self.rotary[blocks],
            self.row[rows],
            self.line[blocks],
        )
        return Pairs(self.letters, *columns, self.steps, blocks)


def sequences(path: CLPath, program: Program, axis_step: float) -> Sequences:
    """Return what can be paired: the moving rows of the path, the blocks of the program."""
    own = program.letters[3:]
    letters = "".join(sorted(own))
    degrees = program.words[:, [3 + own.index(letter) for letter in letters]]
    steps = Steps(
        step_of(path.tip),
        axis_step,
        step_of(program.words[:, :3]),
        float(np.radians(step_of(degrees, False))),
    )
    every = np.arange(len(path.tip))
    return Sequences(
        letters,
        path.tip,
        path.axis,
        every,
        program.words[:, :3],
        np.radians(degrees),
        np.asarray(program.line),
        steps,
    )


def in_order(given: Sequences) -> Pairs | None:
    """Return the n-th block with the n-th row, or with the n-th that moves; None where the numbers differ."""
    blocks = np.arange(len(given.line))
    pose = np.hstack([given.tip, given.axis])
    step = np.abs(np.diff(pose, axis=0)).max(axis=1, initial=0.0)
    for still in (-1.0, *STILL):
        rows = np.flatnonzero(np.concatenate([[True], step > still]))
        if len(rows) == len(blocks):
            return given.pair_rows(rows, blocks)
    return None


def align_pairs(given: Sequences, start: Machine | None = None) -> Pairs:
    """Paired by the likeness of the axes of that layout which makes most of them alike. Raises ProgramError
    where none does."""
    head, every = _probe(given), list(every_layout(given.letters, start))
    usual = [layout for layout in every if layout.strange < STRANGE]
    sum_, best = _likest(head, usual)
    if sum_ < ENOUGH * min(len(head.row), len(head.line)):  # letters that are not those of their axes
        sum_, best = max(
            (sum_, best),
            _likest(head, [one for one in every if one not in usual]),
            key=lambda found: found[0],
        )
    whole = _whole(given)
    return whole.pair_rows(*_trace_matches(_axis_likeness(whole, best)))


def _likest(head: Sequences, layouts: list[Layout]) -> tuple[float, Layout]:
    """Return the largest sum of likenesses, and the layout that has it."""
    sums = [float(_table(_axis_likeness(head, layout))[-1, -1]) for layout in layouts]
    best = int(np.argmax(sums))
    return sums[best], layouts[best]


def realign_pairs(given: Sequences, layout: Layout, base: Floats, unknown: Floats) -> Pairs:
    """Paired by the likeness of the tips, with a machine that is known."""
    whole = _whole(given)
    tip, axis = _reach_poses(whole, layout, base, unknown)
    alike = _alike(_distance(whole.tip, tip), TIP_ALIKE) * (_distance(whole.axis, axis) < 10.0 * AXIS_ALIKE)
    return whole.pair_rows(*_trace_matches(alike))


def _probe(given: Sequences) -> Sequences:
    """Return the first rows and blocks; of the longer sequence as many more as it is longer, for the shorter
    may begin so late."""
    late = min(abs(len(given.row) - len(given.line)), MOST - PROBE)
    rows, blocks = (PROBE + late, PROBE) if len(given.row) > len(given.line) else (PROBE, PROBE + late)
    return _head(given, rows, blocks)


def _whole(given: Sequences) -> Sequences:
    """All rows and blocks, or the first of them where there are too many to align."""
    shorter = max(1, min(len(given.row), len(given.line), MOST))
    return _head(given, MOST * MOST // shorter, MOST * MOST // shorter)


def _head(given: Sequences, rows: int, blocks: int) -> Sequences:
    cl, nc = slice(0, rows), slice(0, blocks)
    return Sequences(
        given.letters, given.tip[cl], given.axis[cl], given.row[cl], given.linear[nc], given.rotary[nc],
        given.line[nc],
        given.steps,
    )  # fmt: skip


def _reach_poses(given: Sequences, layout: Layout, base: Floats, unknown: Floats) -> tuple[Floats, Floats]:
    nothing = np.zeros((len(given.line), 3))
    words = Pairs(
        given.letters,
        nothing,
        nothing,
        given.linear,
        given.rotary,
        given.line,
        given.line,
        given.steps,
        given.line,
    )
    reached = -rows_of(layout, words, base, unknown).residual
    return reached[:, :3], reached[:, 3:]


def _axis_likeness(given: Sequences, layout: Layout) -> Floats:
    _, axis = _reach_poses(given, layout, np.zeros((2, 3)), np.zeros(UNKNOWNS))
    lengths = (
        np.linalg.norm(np.diff(where, axis=0, prepend=where[:1]), axis=1)
        for where in (given.tip, given.linear)
    )
    one, two = lengths
    even = _alike(np.abs(one[:, None] - two[None, :]), LENGTH_ALIKE)
    alike = _alike(_distance(given.axis, axis), AXIS_ALIKE)
    return np.asarray(alike * (0.6 + 0.4 * even))


def _alike(distance: Floats, most: float) -> Floats:
    return np.asarray(np.maximum(0.0, 1.0 - distance / most))


def _distance(one: Floats, two: Floats) -> Floats:
    """Distances (n, m) of every point of one (n, 3) from every point of two (m, 3)."""
    square = sum((one[:, None, k] - two[None, :, k]) ** 2 for k in range(3))
    return np.asarray(np.sqrt(square))


def _table(alike: Floats) -> Floats:
    """Return the largest sums (n + 1, m + 1) of likenesses of pairs in order, up to each row and block."""
    sums = np.zeros((alike.shape[0] + 1, alike.shape[1] + 1))
    for i, row in enumerate(alike):
        here = sums[i].copy()
        np.maximum(here[1:], sums[i, :-1] + row, out=here[1:])
        np.maximum.accumulate(here, out=sums[i + 1])
    return sums


def _trace_matches(alike: Floats) -> tuple[Ints, Ints]:
    sums = _table(alike)
    i, j = alike.shape
    found = []
    while i and j:
        if sums[i, j] == sums[i - 1, j]:
            i -= 1
        elif sums[i, j] == sums[i, j - 1]:
            j -= 1
        else:
            i, j = i - 1, j - 1
            found.append((i, j))
    rows = np.array(found[::-1], np.int64).reshape(-1, 2)
    return rows[:, 0], rows[:, 1]
