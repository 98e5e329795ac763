# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links that stay near the part: from the end of one polyline to the start of the next without going up to
the safe plane.

gap        from the last row of a polyline to the first of the next, which the path bridges by rapids over the
           part.
near link  straight from the one to the other, at feed: on the surface itself where they are nearer than the
           cutter's radius, else lifted by one of a few heights along the tool axes at either end. The axis
           turns on the way.

The lowest near link on which cutter, shank and holder keep out of the part as commanded, and that is worth
it, takes the place of the rapids; ``pipeline.solve_joints.drive_free`` and the last check look at what the
machine makes of it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.vectors import dot
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.search import which_enter
from freecad_fiveaxis.core.gouge.swept_motion import straight_motion
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.passes import turns_within_limits
from freecad_fiveaxis.core.tool.body import CUTTER, Body
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

HEIGHTS = (0.0, 1.0, 3.0, 10.0, 30.0, 100.0)
"""mm along the tool axes, the lowest first."""

MARGIN = 0.5
"""mm by which shank and holder keep off on a near link: the machine's way leaves the commanded one."""

RAPID_WORTH = 0.25
"""A millimetre of rapid is worth so many of feed."""

MOST_TURN = np.pi / 2
"""rad; where the axis turns by more the tool goes over the part."""

LOCKED = 1e-6
"""rad: the same where rotary axes are to be locked as long as the tool is near the part."""


class Gaps(NamedTuple):
    """``last``, ``first`` (g,) rows: the end of a polyline and the start of the next; ``worth`` (g,) mm of
    feed that a near link may be long."""

    last: Ints
    first: Ints
    worth: Floats


def stay_near(
    path: CLPath, tree: FacetTree, body: Body, radius: float, limit: float, driven: float, above: float,
    progress: Progress = silent, kinematics: Chain | None = None,
    spared: Callable[[Ints, Ints], Bools] | None = None,
    most_turn: float = MOST_TURN,
) -> CLPath:  # fmt: skip
    """Replace the rapids between polylines by near links where the tool enters the part by no more than
    ``limit`` mm on them.

    ``radius`` mm of the cutter; ``driven`` and ``above`` mm: how far above the tip the points lie that the
    path's tips are and that goes straight; ``kinematics``: the machine that must take up the axes on the way,
    None: any will do; ``spared``: tells of ways from rows (w,) to rows (w,) of the path which must not be
    gone on the surface, None: all may; ``most_turn`` rad: where the axis turns by more the tool goes over the
    part. Gives the very path where nothing is replaced.
    """
    gaps = _within_limits(_turning_less(find_gaps(path), path, most_turn), path, kinematics)
    height = np.full(len(gaps.last), np.nan)
    for part, lift in enumerate(HEIGHTS):
        progress("linking passes", part / len(HEIGHTS))
        rows = np.flatnonzero(np.isnan(height) & _worthwhile(path, gaps, lift, radius))
        if spared is not None and lift == 0.0:
            rows = rows[~spared(gaps.last[rows], gaps.first[rows] + 1)]
        free = _free(
            path, gaps.last[rows], gaps.first[rows], lift, tree, with_margin(body), limit, driven, above
        )
        height[rows[free]] = lift
    chosen = np.flatnonzero(np.isfinite(height))
    return _insert_links(path, gaps.last[chosen], gaps.first[chosen], height[chosen]) if len(chosen) else path


def find_gaps(path: CLPath) -> Gaps:
    """Find where the path leaves one polyline by rapids for the next."""
    cut = np.isin(path.motion, (Motion.CUT, Motion.FILL))
    last = np.flatnonzero(cut[:-1] & ~cut[1:])
    first = np.flatnonzero(~cut[:-1] & cut[1:])  # the row that ends an approach stands on the part
    first = first[first > last[0]] if len(last) else first[:0]
    last = last[: len(first)]
    length = np.append(0.0, np.linalg.norm(np.diff(path.tip, axis=0), axis=1))
    rapid = path.motion == Motion.RAPID
    worth, rapids = np.cumsum(np.where(rapid, RAPID_WORTH, 1.0) * length), np.cumsum(rapid)
    by_rapid = np.flatnonzero(rapids[first] > rapids[last])
    return Gaps(last[by_rapid], first[by_rapid], (worth[first] - worth[last])[by_rapid])


def _turning_less(gaps: Gaps, path: CLPath, most: float) -> Gaps:
    """Return the gaps over which the axis turns by no more than ``most`` rad."""
    rows = np.flatnonzero(dot(path.axis[gaps.last].T, path.axis[gaps.first].T) >= np.cos(most))
    return gaps if len(rows) == len(gaps.last) else Gaps(gaps.last[rows], gaps.first[rows], gaps.worth[rows])


def _within_limits(gaps: Gaps, path: CLPath, kinematics: Chain | None) -> Gaps:
    """Return the gaps over which the axis turns straight without leaving the machine's limits."""
    if kinematics is None:
        return gaps
    rows = np.flatnonzero(turns_within_limits(kinematics, path.axis[gaps.last], path.axis[gaps.first]))
    return Gaps(gaps.last[rows], gaps.first[rows], gaps.worth[rows])


def _worthwhile(path: CLPath, gaps: Gaps, lift: float, radius: float) -> Bools:
    """Which gaps (g,) a near link so high bridges sooner than the rapids do; on the surface only the
    nearest."""
    apart = np.linalg.norm(path.tip[gaps.first] - path.tip[gaps.last], axis=1)
    return np.asarray((apart + 2.0 * lift < gaps.worth) & ((lift > 0.0) | (apart <= radius)))


def with_margin(body: Body) -> Body:
    """Make shank and holder of the body larger by the margin all round."""
    return Body(
        tuple(one if one.part == CUTTER else one._replace(round=one.round + MARGIN) for one in body.pieces)
    )


def _free(
    path: CLPath,
    last: Ints,
    first: Ints,
    lift: float,
    tree: FacetTree,
    body: Body,
    limit: float,
    driven: float,
    above: float,
) -> Bools:
    """Which (g,) near links so high keep the body out of the part: three blocks each."""
    if not len(last):
        return np.zeros(0, bool)
    ends = np.stack([last, last, first, first], axis=1)
    axis = path.axis[ends]
    tip = path.tip[ends] + (np.array([0.0, lift, lift, 0.0])[:, None] - driven) * axis
    blocks = np.flatnonzero(np.arange(4 * len(last)) % 4 < 3)
    enters = which_enter(
        body, tree, straight_motion(tip.reshape(-1, 3), axis.reshape(-1, 3), above), limit, blocks
    )
    return np.asarray(~enters[blocks].reshape(-1, 3).any(axis=1))


def _insert_links(path: CLPath, last: Ints, first: Ints, height: Floats) -> CLPath:
    """Return the path with near links (g,) in place of what lies between these rows."""
    between = np.zeros(len(path.tip) + 1, np.int64)
    between[last + 1] += 1
    between[first] -= 1
    kept, up = np.flatnonzero(np.cumsum(between)[:-1] == 0), np.flatnonzero(height > 0.0)
    place = np.concatenate(
        [kept, last[up] + 0.25, first[up] - 0.25]
    )  # the new rows after the end and before the start
    order = np.argsort(place, kind="stable")
    source, lift = (
        np.concatenate([kept, last[up], first[up]]),
        np.concatenate([0.0 * kept, height[up], height[up]]),
    )
    feed = np.concatenate([path.feed[kept], path.feed[last[up]], path.feed[last[up]]])
    source, lift, feed, new = source[order], lift[order], feed[order], order >= len(kept)
    axis = path.axis[source]
    motion = np.where(new, np.int8(Motion.LINK), path.motion[source])
    return take_path_rows(path, source, new, path.tip[source] + lift[:, None] * axis, axis, motion, feed)


def take_path_rows(
    path: CLPath, source: Ints, new: Bools, tip: Floats, axis: Floats, motion: Bytes, feed: Floats
) -> CLPath:
    """Return the path of the rows ``source`` (n,) with these tips, axes, motions and feeds; those that are
    ``new`` (n,) lie off the part."""
    row, off = new[:, None], np.int64(-1)
    return replace(
        path, tip=tip, axis=axis, motion=motion, feed=feed,
        contact=np.where(row, tip, path.contact[source]), normal=np.where(row, axis, path.normal[source]),
        face=np.where(new, off, path.face[source]), coedge=np.where(new, off, path.coedge[source]),
        pass_=np.where(new, off, path.pass_[source]),
    )  # fmt: skip
