# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rapids divided until the tool stays clear of the part whichever way the controller drives its axes between
their ends.

way       of a rapid as it is commanded: all axes go evenly; where the controller guides the tip, tip and
          rotary words do.
piece     a stretch of it. In a piece each axis may run at a rate of its own: all places between its ends are
          a box of joints, which is the smaller the shorter the piece. So pieces are halved until their boxes
          are clear: that ends wherever the commanded way keeps some distance from the part, and the tool
          stays on that way.

What is proven are the words as the controller gets them, rounded. A rapid whose commanded way enters the part
is left as it is.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Insertion, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.joint_box import JointBoxes, JointSpace
from freecad_fiveaxis.core.gouge.rapid_ways import which_ways_enter
from freecad_fiveaxis.core.gouge.search import which_enter
from freecad_fiveaxis.core.gouge.swept_motion import real_motion, straight_motion
from freecad_fiveaxis.core.machine.kinematics import (
    Chain,
    RotaryPair,
    forward,
    joint_words,
    q_to_words,
    words_to_q,
)
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.joint_path.rewind import Drive, insert_rows
from freecad_fiveaxis.core.motion.program.wrapping import CIRCLE
from freecad_fiveaxis.core.tool.body import Body
from freecad_fiveaxis.core.toolpath.cl_path import Motion

HALVINGS = 8
"""Times that a rapid is halved, at most: of 1000 mm pieces of 4 mm are left, less than the clearance that is
usual."""


@dataclass(frozen=True, eq=False)
class RapidWays:
    """The commanded ways of k rapids: ``start``, ``step`` (k, 5) are joints, or tip and rotary words where
    ``guided``; mm and **degrees**."""

    kinematics: Chain
    dialect: Dialect
    start: Floats
    step: Floats

    @property
    def guided(self) -> bool:
        """Whether the controller guides the tip."""
        return self.dialect.guide is not None

    def words(self, rapid: Ints, share: Floats) -> Floats:
        """Give the words (n, 5) of the joints, mm and **degrees**, as the controller gets them at shares (n,)
        of rapids (n,)."""
        words = self.start[rapid] + share[:, None] * self.step[rapid]
        printed = np.column_stack([self.dialect.round_word(words[:, k], k) for k in range(5)])
        return self._joints(printed) if self.guided else printed

    def _joints(self, words: Floats) -> Floats:
        return q_to_words(joint_words(self.kinematics, words[:, :3], np.radians(words[:, 3:])))

    def take(self, rapids: Ints) -> RapidWays:
        """Pick some of them, by index (n,)."""
        return replace(self, start=self.start[rapids], step=self.step[rapids])

    def boxes(self, pieces: Pieces) -> JointBoxes:
        """Lay a box over the ends of each piece (n,)."""
        start, end = self.words(pieces.rapid, pieces.begin), self.words(pieces.rapid, pieces.end)
        return JointBoxes(np.arange(len(start)), 0.5 * (start + end), 0.5 * np.abs(end - start))


class Pieces(NamedTuple):
    """Of the way of ``rapid`` (n,) the pieces from share ``begin`` to ``end`` (n,)."""

    rapid: Ints
    begin: Floats
    end: Floats

    def take(self, rows: Ints | Bools) -> Pieces:
        """Pick some of them."""
        return Pieces(self.rapid[rows], self.begin[rows], self.end[rows])

    def halve(self) -> Pieces:
        """Halve each of them: first all first halves, then all second ones."""
        middle = 0.5 * (self.begin + self.end)
        return Pieces(np.tile(self.rapid, 2), np.append(self.begin, middle), np.append(middle, self.end))


@dataclass(frozen=True, eq=False)
class RapidClearance:
    """What tells whether rapids are clear: ``body`` as seen from the tip, which lies ``back`` mm below the
    driven point, the part's ``tree``, and ``limit`` mm: an entry up to that is none."""

    body: Body
    tree: FacetTree
    back: float
    limit: float
    progress: Progress = silent

    def find_blocked(self, ways: RapidWays, pieces: Pieces) -> Bools:
        """Which pieces (n,) are not proven clear on every way of independent axes."""
        space = JointSpace.of(ways.kinematics, self.back)
        return which_ways_enter(self.body, self.tree, space, ways.boxes(pieces), self.limit, self.progress)

    def find_entering(self, ways: RapidWays) -> Bools:
        """Which rapids (k,) enter the part on their commanded way."""
        count = len(ways.start)
        ends = ways.words(np.repeat(np.arange(count), 2), np.tile([0.0, 1.0], count))
        if ways.guided:
            tip, axis = forward(ways.kinematics, words_to_q(ends))
            swept = straight_motion(tip - self.back * axis, axis)
        else:
            swept = real_motion(ways.kinematics, ends, self.back)
        rows = 2 * np.arange(count)  # what lies between leads from one rapid to the next
        return which_enter(self.body, self.tree, swept, self.limit, rows, self.progress)[rows]


def divide_rapids(
    joints: JointPath, kinematics: Chain, dialect: Dialect, clearance: RapidClearance
) -> JointPath:
    """Put rows into the rapids of a joint path until each piece is clear on every way between its ends.

    The rows lie on the commanded ways, rounded as ``dialect`` prints them; all other rows, and rapids that
    are clear as they are, stay. Pieces that are still not clear after HALVINGS stay as they are then. A
    finding gives the number of rapids.
    """
    rows, ways = rapid_ways(joints, kinematics, dialect)
    cuts = find_cuts(ways, clearance)
    if not len(cuts.rapid):
        return joints
    words = ways.words(cuts.rapid, cuts.end)
    longer = _insert_words(joints, kinematics, rows[cuts.rapid], words)
    count = len(np.unique(cuts.rapid))
    return replace(longer, findings=(*longer.findings, _report_divided(count, len(words), dialect)))


def rapid_ways(joints: JointPath, kinematics: Chain, dialect: Dialect) -> tuple[Ints, RapidWays]:
    """Give the rows (k,) that rapids of several axes lead to, and their commanded ways."""
    rows = np.flatnonzero(joints.path.motion[1:] == Motion.RAPID) + 1
    words = q_to_words(joints.q)
    if dialect.guide is not None:
        words = np.column_stack([joints.path.tip, words[:, 3:]])
    start, step = words[rows - 1], words[rows] - words[rows - 1]
    for k, axis in enumerate(kinematics.axes[3:], 3):
        if axis.wrap == "modulo":  # the control takes the shorter way
            step[:, k] -= CIRCLE * np.rint(step[:, k] / CIRCLE)
    ways = RapidWays(kinematics, dialect, start, step)
    each = np.arange(len(rows))
    ends = [ways.words(each, np.full(len(rows), share)) for share in (0.0, 1.0)]
    several = np.flatnonzero((ends[0] != ends[1]).sum(axis=1) > 1)
    return rows[several], ways.take(several)


def find_cuts(ways: RapidWays, clearance: RapidClearance) -> Pieces:
    """Find the pieces that end between the ends of their rapids, ordered by rapid and share: a row is needed
    at each ``end``."""
    count = len(ways.start)
    pieces = Pieces(np.arange(count), np.zeros(count), np.ones(count))
    blocked = pieces.take(clearance.find_blocked(ways, pieces))
    if len(blocked.rapid):
        blocked = blocked.take(~clearance.find_entering(ways.take(blocked.rapid)))
    cuts = [blocked.take(np.arange(0))]
    for _ in range(HALVINGS):
        if not len(blocked.rapid):
            break
        pieces = blocked.halve()
        cuts.append(pieces.take(np.arange(len(blocked.rapid))))
        blocked = pieces.take(clearance.find_blocked(ways, pieces))
    every = Pieces(*(np.concatenate(column) for column in zip(*cuts, strict=True)))
    return every.take(np.lexsort((every.end, every.rapid)))


def _insert_words(joints: JointPath, kinematics: Chain, at: Ints, words: Floats) -> JointPath:
    """Put rapids to ``words`` (n, 5), mm and **degrees**, in before the rows ``at`` (n,), which ascend."""
    q, path = words_to_q(words), joints.path
    tip, axis = forward(kinematics, q)
    motion = np.full(len(at), Motion.RAPID, np.int8)
    drive = Drive(path, joints.row, joints.q[:, 3:], joints.branch)
    drive = insert_rows(drive, kinematics, at, tip, axis, q[:, 3:], motion, tip)
    put, pair = Insertion(len(path.tip), at), RotaryPair.of(kinematics.direction[3], kinematics.direction[4])
    sine = put.interleave(joints.sine, pair.reach * np.abs(np.sin(q[:, 4] - pair.best)))
    findings = tuple(_move_finding(finding, at) for finding in joints.findings)
    return JointPath(
        drive.path, drive.row, put.interleave(joints.q, q), drive.branch, sine, findings, joints.rewinds
    )


def _move_finding(finding: Finding, at: Ints) -> Finding:
    """Return the finding at the row that its own has become."""
    if finding.block is None:
        return finding
    return replace(finding, block=finding.block + int(np.searchsorted(at, finding.block, side="right")))


def _report_divided(rapids: int, rows: int, dialect: Dialect) -> Finding:
    text = say(
        "{count} rapids are divided by {rows} more blocks, so that the tool stays clear of the part on "
        "whichever way {name} drives the axes between their ends.",
        count=rapids, rows=rows, name=dialect.name,
    )  # fmt: skip
    return report_finding(Code.RAPIDS_DIVIDED, text, float(rows))
