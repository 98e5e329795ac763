# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes that make the largest deviation of every pass as small as it can be on this machine and set-up.

The ball's centre stays where it is, and so does the surface: only the axis moves, at every row within
``max_tilt`` of the range between its two facet normals. (Where the words drive the tip, that moves with the
axis.) No rotary axis turns faster than its rate allows at the feed, but where it did so before.

Why a pass can be bettered so much: a block's deviation grows with the square of its turn. So turns are shared
out among long blocks and short ones and those that close a gap, over the whole range and the tilt beyond.
Near the pole a way leads through it.

kept      a run's new axes count only where its largest deviation, by the joint path and the words that they
          really get, is smaller than before. So no run, and no program, is worse than without.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.ranges import LEAST_TILT, MOST_TILT
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Angle, Choice, Option, say
from freecad_fiveaxis.core.machine.kinematics import Chain, q_to_words
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.motion.joint_path import solve
from freecad_fiveaxis.core.toolpath.cl_offset import hub_positions, seat_normal
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath
from freecad_fiveaxis.core.toolpath.feed_direction import feed_direction

from .blocks import Ring
from .corridor import GOOD, improve
from .pole import other_way
from .rows import Rows, find_rows, run_begins
from .steps import Task, axes_of, hastes, levels

GAIN = 0.99
"""A run's new axes are kept where its largest deviation is below this share of the old one: rounded words
then agree."""
AGAIN, OTHER, HASTE = 3, 1.1, 1.01
"""The joint path may take up the new axes on the other branch. A run that there deviates more by the second
is bettered there; one that turns faster than it may by the third is searched again with as much less turn: so
many times."""
INSTANT = 1e-15
"""Minutes that a block takes at least: no time for any turn, but an axis without a rate has one that is
infinite."""
CHECKS = 10
"""Runs influence each other's branch: after so many checks with some of them put back, all are."""
EQUAL_DEVIATION = 1e-9
"""mm, and a share: deviations that differ by less are the same."""
ROOM = 1e3
"""mm of clearance for the joint path that is only measured: wide, for nothing is cut by it."""


def minimax_axes(
    path: OffsetPath,
    axis: Floats,
    kinematics: Chain,
    reach: float,
    max_tilt: float,
    feed: float = math.inf,
    progress: Progress = silent,
    ring: float = 0.0,
) -> Floats:
    """Return unit axes (n, 3) for the rows of ``path`` with the smallest largest deviation that was found,
    run by run; those of ``axis`` (n, 3), the start, where nothing better was found.

    ``reach`` mm: from the ball's centre down the axis to the point that the words drive (the radius, or 0 for
    the centre); ``max_tilt`` rad: how far an axis may leave the great arc between the facet normals on either
    side of its row; ``feed`` mm/min of the ball, by which the machine's rates bound the turns (by default:
    they do not); ``ring`` mm of a cutter that is no ball: its hub moves with the axis, which leans only such
    that the contact stays in front of it. Raises SettingsError for a largest tilt beyond LEAST_TILT to
    MOST_TILT, ReachError for axes that the machine cannot take up.
    """
    if not LEAST_TILT <= max_tilt <= MOST_TILT:
        raise SettingsError(
            say(
                "{max_tilt} {tilt} is out of range; give {least} to {most}, or choose {facet_mean}",
                max_tilt=Option("max_tilt", flag=False),
                facet_mean=Choice("tool_axis", ("facet_mean",), alone=True),
                tilt=Angle(math.degrees(max_tilt)),
                least=Angle(math.degrees(LEAST_TILT), bare=True),
                most=Angle(math.degrees(MOST_TILT)),
            ),
            max_tilt,
        )
    if len(axis) == 0:
        return axis
    start, before = _drive_axes(path, axis, kinematics, reach, ring)
    at = find_rows(path)
    length = np.linalg.norm(np.diff(at.centre, axis=0, prepend=at.centre[:1]), axis=1)
    minutes = np.maximum(length / feed, INSTANT) if feed < math.inf else np.full(len(length), math.inf)
    sits = Ring(ring, seat_normal(path, ring), feed_direction(path, axis)) if ring > 0.0 else None
    task = Task(kinematics, reach, max_tilt, minutes, np.abs(np.diff(start, axis=0, prepend=start[:1])), sits)
    found = _follow_branches(path, task, at, start, progress)
    return _keep_improved(path, axis, found, task, at, before)


def _follow_branches(path: OffsetPath, task: Task, at: Rows, start: Floats, progress: Progress) -> Floats:
    """Return the axes (k, 3) of small levels on the branches that the joint path will take them up on, and
    within the rates there."""
    words, room, kinematics = _best(task, at, start, progress), np.ones(len(at.first)), task.kinematics
    for _ in range(AGAIN):
        taken, after = _drive_axes(path, axes_of(kinematics, words), kinematics, task.reach, task.ring_radius)
        haste = hastes(task, at, taken)
        fast, other = haste > HASTE, after > OTHER * levels(task, at, words) + EQUAL_DEVIATION
        if not (fast | other).any():
            break
        room /= np.where(fast, HASTE * haste, 1.0)
        for runs, search, begin in ((fast, _best, start), (other & ~fast, improve, taken)):
            some, rows = at.take(np.flatnonzero(runs))
            if len(rows):
                own = task.take(rows)
                words[rows] = search(
                    replace(own, minutes=own.minutes * room[at.run[rows]]), some, begin[rows], progress
                )
    return axes_of(kinematics, words)


def _best(task: Task, at: Rows, start: Floats, progress: Progress) -> Floats:
    """Rotary words (k, 2): from the way that is known, or another one by the pole, whichever leads to the
    lower level."""
    better = improve(task, at, start, progress)
    bad = np.flatnonzero(levels(task, at, better) > GOOD)
    if not len(bad):
        return better
    some, rows = at.take(bad)
    runs, way = other_way(task.take(rows), some, start[rows], levels(task, at, start)[bad])
    if len(runs):
        part, own = some.take(runs)
        rows, own_task = rows[own], task.take(rows[own])
        found = improve(own_task, part, way[own], progress)
        lower = (levels(own_task, part, found) < levels(own_task, part, better[rows]))[part.run]
        better[rows[lower]] = found[lower]
    return better


def _keep_improved(
    path: OffsetPath, axis: Floats, found: Floats, task: Task, at: Rows, before: Floats
) -> Floats:
    """``found`` in the runs where the largest deviation is really smaller than ``before`` (p,) and no axis
    too fast, ``axis`` in the others."""
    keep = np.ones(len(before), bool)
    for _ in range(CHECKS):
        mixed = np.where(keep[at.run][:, None], found, axis)
        words, after = _drive_axes(path, mixed, task.kinematics, task.reach, task.ring_radius)
        worse = np.where(
            keep, after >= GAIN * before, after > before * (1.0 + EQUAL_DEVIATION) + EQUAL_DEVIATION
        )
        worse |= keep & (hastes(task, at, words) > HASTE)
        if not worse.any():
            return mixed
        if not (keep & worse).any():
            break
        keep &= ~worse
    return axis


def _drive_axes(
    path: OffsetPath, axis: Floats, kinematics: Chain, reach: float, ring: float = 0.0
) -> tuple[Floats, Floats]:
    """Rotary words (n, 2) rad of all rows as the joint path chooses them, and the largest deviation (p,) mm
    of each run's blocks. Between runs the path goes in one rapid: the axes, not the way, decide on
    branches."""
    begins = run_begins(path)
    motion = np.where(path.fill, Motion.FILL, Motion.CUT).astype(np.int8)
    motion[begins] = Motion.RAPID
    labels = {name: getattr(path, name) for name in ("normal", "face", "coedge", "pass_")}
    tip = hub_positions(path, axis, ring) - reach * axis
    driven = CLPath(
        tip=tip,
        axis=axis,
        motion=motion,
        feed=np.where(motion == Motion.RAPID, 0.0, 1.0),
        contact=path.point,
        **labels,
    )
    below = np.full(
        3, float(tip[:, 2].min()) - 2.0 * ROOM
    )  # every rapid is above the part: branches are free between runs
    joints = solve(driven, kinematics, below, below, ROOM)
    deviation = np.where(
        joints.path.motion <= Motion.FILL, measure(kinematics, q_to_words(joints.q)).segment, 0.0
    )
    worst = np.maximum.reduceat(deviation, np.searchsorted(joints.row, np.flatnonzero(begins)))
    last = np.searchsorted(joints.row, np.arange(len(axis)), side="right") - 1
    return joints.q[last, 3:], worst
