# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links and rapids laid higher where the machine would be in their way.

gap       the rows between two cuts: retract, rapids and approach of a link, or of a rewind; the way to the
          first cut, and the way after the last.
raised    all axes go as they did, the vertical one so much higher: it goes up first where the rapids begin
          (where the link leaves the part, if it has none), and down again last.

Heights are tried one after the other, each gap by itself, until its way is proven; what is below the lowest
that is free is then halved, and what is found is raised by the clearance, too, where that is free. A gap that
no height within the travel frees is left as it was.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints, number_runs
from freecad_fiveaxis.core.machine.kinematics import Chain, forward
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .near_links import take_path_rows

HEIGHTS = (5.0, 10.0, 20.0, 40.0, 80.0, 160.0, 320.0, 640.0, 1280.0)
"""mm, the lowest first."""

PRINTED = 1e-3
"""mm that words keep off the limit, for they are rounded when they are printed."""

FINE = 1.0
"""mm; the step below the lowest free height is halved down to it."""

Hits = Callable[[JointPath, Ints, bool], Bools]
"""Which of the rows (k,) of a joint path are not proven to be reached without hitting anything; whether it is
asked, too, what the tool does to the part."""


class Gaps(NamedTuple):
    """``begin``, ``end`` (g,) rows about each gap: where the tool stands before it and after it. ``out``,
    ``back`` (g,): between these it is raised; ``opens``, ``closes`` (g,): whether the path begins or ends
    with it."""

    begin: Ints
    end: Ints
    out: Ints
    back: Ints
    opens: Bools
    closes: Bools

    def take(self, rows: Ints) -> Gaps:
        """Pick some of them."""
        begin, end, out, back = (column[rows] for column in self[:4])
        return Gaps(begin, end, out, back, self.opens[rows], self.closes[rows])


@dataclass(frozen=True, eq=False)
class Raised:
    """``joints`` with gaps raised. ``height`` (g,) mm by which each gap of those hit was raised, 0 where it
    stays as it was; ``wanted`` (g,) mm that would free it, NaN where none does; ``room`` (g,) mm that the
    travel has; ``row`` (g,) of ``joints`` where each gap begins."""

    joints: JointPath
    height: Floats
    wanted: Floats
    room: Floats
    row: Ints


def find_gaps(motion: Bytes) -> Gaps:
    """Find the gaps of a path with these motions (n,) of its rows."""
    n, off = len(motion), motion >= Motion.LINK
    first = np.flatnonzero(off & ~np.append(False, off[:-1]))
    last = np.flatnonzero(off & ~np.append(off[1:], False))
    rapid = np.flatnonzero(motion == Motion.RAPID)
    low, high = np.searchsorted(rapid, first), np.searchsorted(rapid, last, side="right")
    some, padded = high > low, np.append(rapid, 0)
    begin, opens, closes = (
        np.maximum(first - 1, 0),
        first == 0,
        (last == n - 1) & (motion[last] == Motion.RAPID),
    )
    out = np.where(some, padded[np.minimum(low, len(rapid))] - 1, begin)
    back = np.where(some, padded[np.maximum(high - 1, 0)], last)
    out = np.where(opens, 0, out)
    return Gaps(begin, last, out, back, opens, closes)


def raising_axis(kinematics: Chain) -> int:
    """Pick the linear axis that raises the tool over the table."""
    return int(np.abs(kinematics.direction[:3, 2]).argmax())


def raise_links(joints: JointPath, kinematics: Chain, hits: Hits, clearance: float) -> Raised:
    """Raise the gaps of a joint path in which something is hit until nothing is; ``clearance`` mm by which
    they go higher than they must."""
    gaps = find_gaps(joints.path.motion)
    gaps = gaps.take(np.flatnonzero(_hit(joints, gaps, hits)))
    trial = _Trial(joints, kinematics, hits, gaps)
    wanted = trial.lowest_free(clearance)
    height = np.where(wanted <= trial.room, wanted, 0.0)
    chosen = np.flatnonzero(height > 0.0)
    raised = _raise_gaps(joints, kinematics, gaps.take(chosen), height[chosen]) if len(chosen) else None
    if raised is None:
        return Raised(joints, height, wanted, trial.room, gaps.begin)
    return Raised(raised.joints, height, wanted, trial.room, raised.moved[gaps.begin])


@dataclass(frozen=True, eq=False)
class _Trial:
    """What heights are tried with, of the ``gaps`` of a joint path that are hit."""

    joints: JointPath
    kinematics: Chain
    hits: Hits
    gaps: Gaps

    @property
    def up(self) -> int:
        """The axis that raises the tool."""
        return raising_axis(self.kinematics)

    @property
    def room(self) -> Floats:
        """How far each gap (g,) can be raised within the travel, mm; below 0 where it is beyond it."""
        sign = np.sign(self.kinematics.direction[self.up, 2])
        words = np.append(sign * self.joints.q[:, self.up], -np.inf)
        ends = np.stack([self.gaps.out, self.gaps.back + 1], axis=1).ravel()
        most = np.maximum.reduceat(words, ends)[::2] if len(ends) else np.empty(0)
        limit = self.kinematics.high[self.up] if sign > 0.0 else -self.kinematics.low[self.up]
        return np.asarray(float(limit) - PRINTED - most)

    def free(self, rows: Ints, height: Floats) -> Bools:
        """Which of the gaps ``rows`` (k,) are free if raised by ``height`` (k,) mm."""
        part, gaps = _only(self.joints, self.gaps.take(rows))
        raised = _raise_gaps(part, self.kinematics, gaps, height)
        return ~_hit_by(raised.joints, raised.gap, len(rows), self.hits)

    def lowest_free(self, clearance: float) -> Floats:
        """Find the lowest heights (g,) mm that free the gaps, NaN where none does."""
        count, room = len(self.gaps.begin), self.room
        found, hit = np.full(count, np.nan), np.zeros(count)
        for height in HEIGHTS:
            rows = np.flatnonzero(np.isnan(found))
            tried = np.where((hit < room) & (height > room), room, height)[rows]
            free = self.free(rows, tried) if len(rows) else np.zeros(0, np.bool_)
            found[rows[free]], hit[rows[~free]] = tried[free], tried[~free]
        while len(rows := np.flatnonzero(found - hit > FINE)):
            middle = 0.5 * (found[rows] + hit[rows])
            free = self.free(rows, middle)
            found[rows[free]], hit[rows[~free]] = middle[free], middle[~free]
        rows = np.flatnonzero(found <= room)
        if len(rows):
            more = np.minimum(found[rows] + clearance, room[rows])
            free = self.free(rows, more)
            found[rows[free]] = more[free]
        return found


class _Path(NamedTuple):
    """A joint path with raised gaps: ``gap`` (n,) to which of them each row belongs, from the first raised
    one to the row where it is down again, -1 elsewhere; ``moved`` (m,) where the rows of the given path
    are."""

    joints: JointPath
    gap: Ints
    moved: Ints


def _raise_gaps(joints: JointPath, kinematics: Chain, gaps: Gaps, height: Floats) -> _Path:
    """Return the joint path with these gaps raised by ``height`` (g,) mm."""
    n, up = len(joints.q), raising_axis(kinematics)
    gap, lifted = _between(gaps.out, gaps.back)
    kept = np.ones(n, np.bool_)
    kept[lifted] = False
    kept[gaps.out[~gaps.opens]] = kept[gaps.back[~gaps.closes]] = True
    rows = np.flatnonzero(kept)
    key = np.concatenate([rows, lifted + np.where(lifted == gaps.back[gap], -0.25, 0.25)])
    order = np.argsort(key, kind="stable")
    source, of = np.append(rows, lifted)[order], np.append(np.full(len(rows), -1), gap)[order]
    new = of >= 0
    q = joints.q[source].copy()
    q[new, up] += np.sign(kinematics.direction[up, 2]) * height[of[new]]
    moved = np.empty(n, np.int64)
    moved[source[new]] = np.flatnonzero(new)
    moved[source[~new]] = np.flatnonzero(~new)
    first = np.zeros(len(source), np.bool_)
    first[1:] = new[1:] & ~new[:-1]
    of[moved[gaps.back[~gaps.closes]]] = np.flatnonzero(~gaps.closes)
    return _Path(_with_rows(joints, kinematics, q, source, new, first, moved), of, moved)


def _with_rows(
    joints: JointPath, kinematics: Chain, q: Floats, source: Ints, new: Bools, first: Bools, moved: Ints
) -> JointPath:
    """Return the joint path of rows ``q`` (n, 5), each with what its ``source`` (n,) has; ``new`` ones cut
    nothing, and the ``first`` of each gap is reached as the row after it is. The others are rapids, of links
    near the part too: these were divided for where they were, and higher up they swing farther."""
    path = joints.path
    tip, axis = path.tip[source], path.axis[source]
    if new.any():
        tip[new], axis[new] = forward(kinematics, q[new])
    lead = np.where(first, np.minimum(source + 1, len(path.tip) - 1), source)
    up = np.maximum(path.motion[lead], np.int8(Motion.LINK))
    motion = np.where(new, np.where(first, up, np.int8(Motion.RAPID)), path.motion[source])
    feed = np.where(motion == Motion.RAPID, 0.0, path.feed[np.where(new, lead, source)])
    longer = take_path_rows(path, source, new, tip, axis, motion.astype(np.int8), feed)
    findings = tuple(
        one if one.block is None else replace(one, block=int(moved[one.block])) for one in joints.findings
    )
    return JointPath(
        longer, joints.row[source], q, joints.branch[source], joints.sine[source], findings, joints.rewinds
    )


def _only(joints: JointPath, gaps: Gaps) -> tuple[JointPath, Gaps]:
    """Return the rows of these gaps alone, one gap after the other, and the gaps in them."""
    _, rows = _between(gaps.begin, gaps.end)
    path, length = joints.path, gaps.end - gaps.begin + 1
    names = ("tip", "axis", "motion", "feed", "contact", "normal", "face", "coedge", "pass_")
    part = replace(path, **{name: getattr(path, name)[rows] for name in names})
    shift = np.cumsum(length) - length - gaps.begin
    found = JointPath(part, joints.row[rows], joints.q[rows], joints.branch[rows], joints.sine[rows])
    begin, end, out, back = (column + shift for column in gaps[:4])
    return found, Gaps(begin, end, out, back, gaps.opens, gaps.closes)


def _between(first: Ints, last: Ints) -> tuple[Ints, Ints]:
    """Return the runs (m,) and rows (m,) from ``first`` (k,) to ``last`` (k,), both included."""
    run, number = number_runs(last - first + 1)
    return run, first[run] + number


def _hit(joints: JointPath, gaps: Gaps, hits: Hits) -> Bools:
    """In which gaps (g,) the machine is hit on the way that can be raised; what the tool does to the part has
    been seen to, where a link can help it."""
    gap = np.full(len(joints.q), -1)
    of, row = _between(gaps.out + 1, gaps.back)
    gap[row] = of
    return _hit_by(joints, gap, len(gaps.out), hits, tool=False)


def _hit_by(joints: JointPath, gap: Ints, count: int, hits: Hits, tool: bool = True) -> Bools:
    """In which of ``count`` gaps something is hit on the way to a row that is of it, ``gap`` (n,)."""
    rows = np.flatnonzero(gap >= 0)
    rows = rows[rows > 0]
    hit = np.zeros(count, np.bool_)
    hit[gap[rows[hits(joints, rows, tool)]]] = True
    return hit
