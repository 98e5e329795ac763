# SPDX-License-Identifier: LGPL-2.1-or-later
"""One turn of the part, driven once: what is the same for all work zeros is worked out here, the rest in each
of them.

The rotary words follow from the tool axes alone. So branch, winding, rewinds and the rows that these insert
are the same wherever the work zero stands; and the linear words, and with them the real path at any u, are
**affine** in the work zero, because the chain's two lines shift evenly with it. Only the rapids are cut into
other pieces: ``joint_path`` is asked once, its pieces are joined again, and each work zero cuts the rapids as
it needs.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.controllers.dialect import Dialect
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.kinematics import (
    Chain,
    Setup,
    chain,
    joint_words,
    lift_of,
    q_to_words,
    raise_chain,
)
from freecad_fiveaxis.core.motion.deviation import measure, quick_bound
from freecad_fiveaxis.core.motion.joint_path import JointPath, solve
from freecad_fiveaxis.core.motion.joint_path.plan import LINEAR_SLACK
from freecad_fiveaxis.core.motion.joint_path.rewind import Drive, subdivide_rapids
from freecad_fiveaxis.core.motion.program import Program, build_program, feed_blocks
from freecad_fiveaxis.core.toolpath.cl_path import SAFE_MARGIN, CLPath, Motion

EVEN = 1e-9
"""mm and rad: steps that differ by less are pieces of one rapid."""
FIRST_BATCH = 64
"""Blocks measured first, those of the largest quick bound; each further batch is twice as large."""


@dataclass(frozen=True, eq=False)
class Posting:
    """How a path becomes a program: ``dialect`` and feed mode; ``clearance`` mm of rapids; ``radius`` mm of
    the ball; ``part`` (v, 3) mm: points of the part, whose box the rewinds keep out of; None: of the path's
    feed moves. ``above`` mm: so far over the driven point stands the one that makes the surface (a ball's
    centre), whose deviation counts."""

    dialect: Dialect
    inverse_time: bool = True
    clearance: float = 5.0
    radius: float = 0.0
    part: Floats | None = None
    above: float = 0.0


@dataclass(frozen=True, eq=False)
class Worst:
    """Blocks of the largest deviation, largest first: ``row`` (k,) where each ends, ``segment`` (k,) mm,
    ``u`` (k,)."""

    row: Ints
    segment: Floats
    u: Floats


@dataclass(frozen=True, eq=False)
class Cost:
    """One setup: the program's largest deviation mm, rotary travel rad, time s, and how far it goes over
    limits mm."""

    deviation: float
    travel: float
    time: float
    over: float

    @property
    def within(self) -> bool:
        """Say whether all axes stay within their ranges."""
        return self.over <= LINEAR_SLACK


@dataclass(frozen=True, eq=False)
class Driven:
    """A path, turned, as the machine drives it. ``drive`` has every rapid in one piece; ``rewinds``: retracts
    inside cuts."""

    machine: Machine
    tool_length: float
    posting: Posting
    turn: float
    drive: Drive
    rewinds: int

    def setup(self, origin: Floats) -> Setup:
        """Return the setup with the work zero at ``origin`` (3,) mm."""
        x, y, z = origin.tolist()
        return Setup((x, y, z), self.tool_length)

    def kinematics(self, origin: Floats) -> Chain:
        """Return the machine in that setup."""
        return chain(self.machine, self.setup(origin))

    def words(self, kinematics: Chain, rows: Ints | slice = slice(None)) -> Floats:
        """Words (n, 5) mm and degrees, before rounding."""
        return q_to_words(joint_words(kinematics, self.drive.path.tip[rows], self.drive.angles[rows]))

    def raise_to_surface(self, kinematics: Chain, words: Floats) -> tuple[Chain, Floats]:
        """Raise chain and ``words`` (n, 5) mm and degrees so that the tip of both is the point that makes the
        surface, whose deviation counts."""
        if self.posting.above == 0.0:
            return kinematics, words
        dialect = self.posting.dialect
        lift = lift_of(kinematics, self.posting.above, dialect.linear_decimals, dialect.unit)
        return raise_chain(kinematics, lift), words + np.append(lift, (0.0, 0.0))

    @property
    def feeds(self) -> Ints:
        """The rows that a feed block ends in."""
        rows = np.flatnonzero(self.drive.path.motion != Motion.RAPID)
        return rows[rows > 0]

    def post(self, kinematics: Chain) -> tuple[JointPath, Program]:
        """Joints and program in one setup: the same as ``solve`` and ``build_program`` make there."""
        drive = subdivide_rapids(
            self.drive, kinematics, min(0.5 * self.posting.clearance, SAFE_MARGIN)
        )  # as joint_path.solve
        q = joint_words(kinematics, drive.path.tip, drive.angles)
        joints = JointPath(drive.path, drive.row, q, drive.branch, np.zeros(len(q)))
        return joints, build_program(joints, kinematics, self.posting.dialect, self.posting.inverse_time)

    def cost(self, origin: Floats) -> Cost:
        """Return what the setup costs, of the program's rounded words."""
        kinematics = self.kinematics(origin)
        joints, program = self.post(kinematics)
        worst = worst_blocks(*self.raise_to_surface(kinematics, program.words), feed_blocks(program))
        travel = np.abs(np.diff(np.radians(program.words[:, 3:]), axis=0)).sum()
        over = np.maximum(joints.q[:, :3] - kinematics.high[:3], kinematics.low[:3] - joints.q[:, :3]).max(
            initial=0.0
        )
        return Cost(
            float(worst.segment.max(initial=0.0)), float(travel), float(program.seconds.sum()), float(over)
        )


def turn_path(path: CLPath, turn: float) -> CLPath:
    """Return the path of a part that is turned counter-clockwise by ``turn`` rad about Z through the work
    zero."""
    if turn == 0.0:
        return path
    columns: dict[str, Any] = {
        name: turn_points(getattr(path, name), turn) for name in ("tip", "axis", "contact", "normal")
    }
    return replace(path, **columns)


def turn_points(points: Floats, turn: float) -> Floats:
    """Points or vectors (n, 3), turned counter-clockwise about Z."""
    cos, sin = np.cos(turn), np.sin(turn)
    x, y, z = np.asarray(points).T
    return np.stack([cos * x - sin * y, sin * x + cos * y, z]).T


def part_box(path: CLPath, part: Floats | None, turn: float = 0.0) -> tuple[Floats, Floats]:
    """Low and high corner (3,) mm of the part's box when turned; the box of the feed moves where the part is
    not known."""
    feeding = path.motion != Motion.RAPID
    points = (path.tip[feeding] if feeding.any() else path.tip) if part is None else np.asarray(part)
    points = turn_points(points, turn) if turn else points
    return points.min(axis=0), points.max(axis=0)


def drive_turned(
    path: CLPath, machine: Machine, base: Setup, posting: Posting, turn: float, progress: Progress = silent
) -> Driven:
    """Return the path at one turn. Raises ReachError where the rotary limits allow no way, whatever the work
    zero."""
    low, high = part_box(path, posting.part, turn)
    kinematics = chain(machine, base)
    joints = solve(turn_path(path, turn), kinematics, low, high, posting.clearance, posting.radius, progress)
    return Driven(machine, base.tool_length, posting, turn, _whole_rapids(joints), joints.rewinds)


def _whole_rapids(joints: JointPath) -> Drive:
    """Return the joint path with the pieces of each rapid joined: rows go where a rapid goes on evenly to the
    same row."""
    path, angles = joints.path, joints.q[:, 3:]
    step = np.diff(np.column_stack([path.tip, angles]), axis=0)
    even = np.abs(np.diff(step, axis=0)).max(axis=1, initial=0.0) <= EVEN
    rapid = path.motion == Motion.RAPID
    inner = np.zeros(len(angles), bool)
    inner[1:-1] = even & rapid[1:-1] & rapid[2:] & (joints.row[1:-1] == joints.row[2:])
    return Drive(pick_path_rows(path, ~inner), joints.row[~inner], angles[~inner], joints.branch[~inner])


def pick_path_rows(path: CLPath, keep: Bools) -> CLPath:
    """Return some rows of a CL path."""
    return replace(
        path, **{one.name: getattr(path, one.name)[keep] for one in fields(path) if one.name != "findings"}
    )


def worst_blocks(kinematics: Chain, words: Floats, feeds: Ints, count: int = 1) -> Worst:
    """At least the ``count`` largest deviations of the blocks that end in the rows ``feeds``, largest first.

    ``words`` (m, 5) mm and degrees. A block is measured only while its quick bound promises more than what
    was found.
    """
    bound = quick_bound(kinematics, words)[feeds]
    order = np.argsort(-bound, kind="stable")
    row, segment, u = np.empty(0, np.int64), np.empty(0), np.empty(0)
    at, batch = 0, max(FIRST_BATCH, count)
    while at < len(order) and (
        len(segment) < count or bound[order[at]] > np.partition(segment, -count)[-count]
    ):
        rows = feeds[order[at : at + batch]]
        ends = np.unique(np.concatenate([rows - 1, rows]))  # a block's two ends are neighbours here, too
        found, own = measure(kinematics, words[ends]), np.searchsorted(ends, rows)
        row = np.concatenate([row, rows])
        segment, u = np.concatenate([segment, found.segment[own]]), np.concatenate([u, found.u_segment[own]])
        at, batch = at + batch, 2 * batch
    order = np.argsort(-segment, kind="stable")
    return Worst(row[order], segment[order], u[order])
