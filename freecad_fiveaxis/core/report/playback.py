# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where everything stands at any moment of a program: the tool over the work, and table and head in the
machine.

moment    a block and its u, or a time in seconds from the program's start. Within a block all words move
          linearly, so the tip leaves the chord as it does on the machine; where the controller guides the
          tip, the rotary words do, and the others keep the tip on the chord. Block 0 is the first position;
          nothing is claimed of the way to it.
clock     the time at which each block ends: the sum of ``Program.seconds``. A block that moves but of which
          the program says no time (a foreign file without F) is shown for UNTIMED seconds.
machine   frame parallel to the machine's, its zero where the work zero stands while all words are 0. With all
          words 0 the tool's tip stands there too, so work, machine and tool frame are then one and the same.
tool      frame with its zero in the driven point (the tip) and z along the tool axis, from the tip to the
          holder.

A positive word moves the tool relative to the work; the axes stand in one order from work to tool, M1 ... Mk
of the table and Mk+1 ... M5 of the head. So ``work_from_tool = M1 ... M5``, ``machine_from_work = (M1 ...
Mk)^-1``, and ``machine_from_tool = Mk+1 ... M5``.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property, reduce

import numpy as np
from numpy.typing import ArrayLike, NDArray

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.deviation import Deviation
from freecad_fiveaxis.core.motion.program import (
    Program,
    block_starts,
    feed_blocks,
    find_unknown_ways,
    standing,
)
from freecad_fiveaxis.core.motion.trajectory import axis_at, tip_at
from freecad_fiveaxis.core.nc.reader.preface import with_line_feeds

from .figures import worst_first

UNTIMED = 0.1
"""s for which a block of unknown time is shown."""
FINEST_TURN = 2.0
"""deg of rotary travel between two points of a drawn curve: 0.03 mm of sagitta on a lever of 200 mm."""
MOST_POINTS = 1001
"""Points of a drawn curve, however many turns its block makes."""


@dataclass(frozen=True, eq=False)
class Pose:
    """One or many moments; every array begins with the shape that was asked for, () for a single moment.

    ``block``, ``u`` the moment; ``seconds`` its time; ``words`` (..., 5) mm and **degrees**; ``tip`` (..., 3)
    mm and ``axis`` (..., 3) unit, work frame; ``point`` (..., 3) mm: the point whose deviation is played, the
    tip or a ball's centre, and ``foot`` (..., 3) mm: the point of its commanded segment that is nearest to
    it, work frame; ``to_chord`` mm: the distance of the two. Placements (..., 4, 4), mm: ``work_from_tool``,
    ``machine_from_work``, ``work_from_machine``, ``machine_from_tool``. The rotary axes' lines as they stand,
    the one nearer to the work first: ``line_point`` (..., 2, 3) mm, ``line_direction`` (..., 2, 3) unit,
    machine frame.
    """

    block: Ints
    u: Floats
    seconds: Floats
    words: Floats
    tip: Floats
    axis: Floats
    point: Floats
    foot: Floats
    to_chord: Floats
    work_from_tool: Floats
    machine_from_work: Floats
    work_from_machine: Floats
    machine_from_tool: Floats
    machine_from_carried: Floats
    line_point: Floats
    line_direction: Floats


@dataclass(frozen=True, eq=False)
class Playback:
    """A program ready to be played on its machine. ``clock`` (m,) s: the time at which each block ends.

    ``program`` and ``deviation`` have one row a block and are for the machine of ``kinematics``;
    ``deviation`` is that of the tip or of a ball's centre. Raises ProgramError for a program without a block.
    """

    kinematics: Chain
    program: Program
    deviation: Deviation
    clock: Floats = field(init=False)

    def __post_init__(self) -> None:
        if not len(self.program.words):
            raise ProgramError(say("the program has no block that moves; there is nothing to play"), 0)
        clock = np.cumsum(compute_shown_seconds(self.program))
        clock.flags.writeable = False
        object.__setattr__(self, "clock", clock)

    @property
    def seconds(self) -> float:
        """The time of the whole program, s."""
        return float(self.clock[-1])

    @cached_property
    def worst(self) -> int | None:
        """The feed block of the largest deviation from its segment; None where no block feeds."""
        rows = worst_first(feed_blocks(self.program), self.deviation.segment)
        return int(rows[0]) if len(rows) else None

    def spot(self, time: ArrayLike) -> tuple[Ints, Floats]:
        """Return the block and its u at ``time`` s (any shape); before the start the first position, after
        the end the last."""
        at = np.clip(np.asarray(time, float), 0.0, self.seconds)
        block = np.minimum(np.searchsorted(self.clock, at), len(self.clock) - 1)
        left, whole = self.clock[block] - at, self.clock[block] - self._begin(block)
        u = 1.0 - np.divide(left, whole, out=np.zeros_like(left), where=whole > 0.0)
        return block, np.clip(u, 0.0, 1.0)

    def time(self, block: ArrayLike, u: ArrayLike) -> Floats:
        """Return the time, s, of a moment given by block and u, the inverse of :meth:`spot`."""
        row = np.asarray(block, int)
        before = self._begin(row)
        return np.asarray(before + np.asarray(u, float) * (self.clock[row] - before))

    def at(self, time: ArrayLike) -> Pose:
        """Return the pose at ``time`` s, of any shape."""
        return self.at_block(*self.spot(time))

    def at_block(self, block: ArrayLike, u: ArrayLike) -> Pose:
        """Return the pose at ``u`` (0 to 1) of ``block``; the two broadcast. Raises ProgramError for a block
        that is not there."""
        rows, at_u = np.broadcast_arrays(np.asarray(block, int), np.asarray(u, float))
        self._check(rows)
        row, flat_u = rows.reshape(-1), at_u.reshape(-1)
        ends = self._ends(row)
        foot_ends = (self._points(*ends, np.full_like(flat_u, edge)) for edge in (0.0, 1.0))
        words, start, end = self._guide(row, *ends, flat_u)
        point = self._points(start, end, flat_u)
        foot = segment_foot(point, *foot_ends)
        columns = {
            "block": row, "u": flat_u, "seconds": self.time(row, flat_u), "words": words,
            "tip": tip_at(self.kinematics, start, end, flat_u),
            "axis": axis_at(self.kinematics, start, end, flat_u),
            "point": point, "foot": foot, "to_chord": np.linalg.norm(point - foot, axis=1),
        } | placements(self.kinematics, words)  # fmt: skip
        return Pose(
            **{name: column.reshape(rows.shape + column.shape[1:]) for name, column in columns.items()}
        )

    def curve(self, block: int) -> Floats:
        """Return the real path of ``Pose.point`` in one block (n, 3) mm, work frame, ends included, fine
        enough to be drawn."""
        row = np.array([block])
        self._check(row)
        start, end = self._ends(row)
        count = min(int(np.abs(end - start)[0, 3:].sum() / FINEST_TURN) + 2, MOST_POINTS)
        u, one = np.linspace(0.0, 1.0, count), np.zeros(count, np.int64)
        _, start, end = self._guide(row[one], start[one], end[one], u)
        return self._points(start, end, u)

    def _guide(self, row: Ints, start: Floats, end: Floats, u: Floats) -> tuple[Floats, Floats, Floats]:
        """Return the words (n, 5) at ``u`` (n,) of blocks between words ``start`` and ``end`` (n, 5), and
        these; in blocks whose tip the controller guides all three are those at u."""
        words, guided = start + u[:, None] * (end - start), self.program.guided
        on = np.flatnonzero(guided.on[row]) if guided is not None else row[:0]
        if not len(on):
            return words, start, end
        first, last = (
            tip_at(self.kinematics, start[on], end[on], np.full(len(on), edge)) for edge in (0.0, 1.0)
        )
        words[on] = standing(self.kinematics, first + u[on, None] * (last - first), words[on, 3:])
        start, end = start.copy(), end.copy()
        start[on] = end[on] = words[on]
        return words, start, end

    def _points(self, start: Floats, end: Floats, u: Floats) -> Floats:
        """Return the point whose deviation is played: as ``tip_at``."""
        kinematics, begin = self.deviation.raise_words(self.kinematics, start)
        return tip_at(kinematics, begin, self.deviation.raise_words(self.kinematics, end)[1], u)

    def _begin(self, block: NDArray[np.int64]) -> Floats:
        return np.where(block > 0, self.clock[np.maximum(block - 1, 0)], 0.0)

    def _ends(self, row: Ints) -> tuple[Floats, Floats]:
        return block_starts(self.program, row), self.program.words[row]

    def _check(self, rows: NDArray[np.int64]) -> None:
        bad = rows[(rows < 0) | (rows >= len(self.clock))]
        if bad.size:
            raise ProgramError(
                say(
                    "there is no block {flat}; the last one is {count}",
                    flat=bad.flat[0],
                    count=len(self.clock) - 1,
                ),
                int(bad.flat[0]),
            )


def compute_shown_seconds(program: Program) -> Floats:
    """How long each block (m,) is shown, s: its own time, or UNTIMED where it moves and no time is
    known. What comes from a position of the machine is there at once."""
    known = np.isfinite(program.seconds) & (program.seconds > 0.0)
    moves = np.ones(len(known), bool)
    moves[:1] = False
    moves[1:] = (program.words[1:] != program.words[:-1]).any(axis=1) & ~find_unknown_ways(program)
    return np.where(known, program.seconds, np.where(moves, UNTIMED, 0.0))


def following(rows: Ints, block: int) -> int | None:
    """Return the first of the ascending ``rows`` after ``block``, from the last on the first again; None
    where there is none."""
    return int(rows[np.searchsorted(rows, block, side="right") % len(rows)]) if len(rows) else None


class NCLines:
    """The lines of an NC file, counted from 1 as the reader counts them. Only the places of the line ends are
    kept."""

    def __init__(self, nc: bytes) -> None:
        self._text = with_line_feeds(nc)
        ends = np.flatnonzero(np.frombuffer(self._text, np.uint8) == ord("\n"))
        self._edges = np.concatenate([[-1], ends, [len(self._text)]])

    def __getitem__(self, line: int) -> str:
        """Return the text of a line without its end; nothing for a line that the file does not have."""
        if not 0 < line < len(self._edges):
            return ""
        return self._text[self._edges[line - 1] + 1 : self._edges[line]].decode("utf-8", "replace").strip()


def segment_foot(point: Floats, start: Floats, end: Floats) -> Floats:
    """Return the point (n, 3) of each segment between ``start`` and ``end`` (n, 3) that is nearest to
    ``point`` (n, 3), mm."""
    chord = end - start
    length2 = (chord * chord).sum(axis=-1)
    share = np.divide(
        ((point - start) * chord).sum(axis=-1), length2, out=np.zeros_like(length2), where=length2 > 0.0
    )
    return np.asarray(start + np.clip(share, 0.0, 1.0)[..., None] * chord)


def rotary_lines(pose: Pose, near: Floats, reach: float) -> Floats:
    """Return ends (2, 2, 3) mm, machine frame, of the two rotary lines at a single moment: ``reach`` mm to
    either side of where each comes nearest to ``near`` (3,) mm, a point of the work in the work frame."""
    placed = pose.machine_from_work[:3, :3] @ near + pose.machine_from_work[:3, 3]
    along = pose.line_direction
    middle = pose.line_point + ((placed - pose.line_point) * along).sum(axis=-1, keepdims=True) * along
    return np.stack([middle - reach * along, middle + reach * along], axis=1)


# ------------------------------------------------------------------------------------------------ placements


def placements(kinematics: Chain, words: Floats) -> dict[str, Floats]:
    """Return the placements and rotary lines of a :class:`Pose` for ``words`` (n, 5) mm and **degrees**."""
    table, head = sides(kinematics)
    moves = {j: _axis_motion(kinematics, j, words[:, j]) for j in (*table, *head)}
    still = np.broadcast_to(np.eye(4), (len(words), 4, 4))
    work_from_machine = _product(still, (moves[j] for j in table))
    machine_from_tool = _product(still, (moves[j] for j in head))
    machine_from_work = rigid_inverse(work_from_machine)
    carried = {
        j: machine_from_work @ _product(still, (moves[i] for i in table[:at])) for at, j in enumerate(table)
    }
    carried |= {j: _product(still, (moves[i] for i in head[: at + 1])) for at, j in enumerate(head)}
    point, direction = (kinematics.point1, kinematics.point2), kinematics.direction[3:]
    return {
        "work_from_tool": work_from_machine @ machine_from_tool,
        "machine_from_work": machine_from_work,
        "work_from_machine": work_from_machine,
        "machine_from_tool": machine_from_tool,
        "machine_from_carried": np.stack([carried[j] for j in range(5)], axis=1),
        "line_point": np.stack(
            [carried[3 + i][:, :3, :3] @ point[i] + carried[3 + i][:, :3, 3] for i in range(2)], axis=1
        ),
        "line_direction": np.stack([carried[3 + i][:, :3, :3] @ direction[i] for i in range(2)], axis=1),
    }


def rigid_inverse(placement: Floats) -> Floats:
    """Return the inverse of rigid placements (..., 4, 4)."""
    inverse = np.zeros_like(placement)
    turn = np.swapaxes(placement[..., :3, :3], -1, -2)
    inverse[..., :3, :3] = turn
    inverse[..., :3, 3] = -(turn @ placement[..., :3, 3:])[..., 0]
    inverse[..., 3, 3] = 1.0
    return inverse


def sides(kinematics: Chain) -> tuple[list[int], list[int]]:
    """Return the columns of the table's and of the head's words, each in the order from work to tool."""
    place = [2 * slot for slot in kinematics.slot] + [
        1,
        3,
    ]  # linear axes before, between and after the two rotary ones
    order = sorted(range(5), key=lambda j: place[j])
    table = [j for j in order if kinematics.axes[j].side == "table"]
    return table, [j for j in order if kinematics.axes[j].side == "head"]


def _axis_motion(kinematics: Chain, j: int, word: Floats) -> Floats:
    """Return the motion (n, 4, 4) of the tool relative to the work by one axis, ``word`` (n,) mm or
    **degrees**."""
    motion = np.tile(np.eye(4), (len(word), 1, 1))
    if j < 3:
        motion[:, :3, 3] = word[:, None] * kinematics.direction[j]
        return motion
    point, turn = (
        (kinematics.point1, kinematics.point2)[j - 3],
        _turn(kinematics.direction[j], np.radians(word)),
    )
    motion[:, :3, :3] = turn
    motion[:, :3, 3] = point - turn @ point
    return motion


def _turn(axis: Floats, angle: Floats) -> Floats:
    """Rotation matrices (n, 3, 3) about unit ``axis`` by ``angle`` (n,) rad, right-handed (Rodrigues)."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    across = cross @ cross
    return np.asarray(
        np.eye(3) + np.sin(angle)[:, None, None] * cross + (1.0 - np.cos(angle))[:, None, None] * across
    )


def _product(first: Floats, others: Iterable[Floats]) -> Floats:
    return reduce(np.matmul, others, first)
