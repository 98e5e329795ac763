# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the tip leaves its chord in every block between the states of one row and those of the next.

state     one way to stand at a row: the two rotary words. Axis and linear words follow from them. Columns of
          states are (m, k), m for each of k rows: the long side is the last one, for numpy's sake.
block     from a state of one row to a state of the next.
share     u of the block, at which the real tip is compared with the chord. The largest of a few shares stands
          for the largest of all: the middle alone is right to second order in the turn; quarters see a path
          that is bent like an S, too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.vectors import dot
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, joint_words
from freecad_fiveaxis.core.motion.trajectory import Columns, Frames, Pose, combine, frames, tip
from freecad_fiveaxis.core.tool.contact import ring_direction

MIDDLE = (0.5,)
QUARTERS = (0.25, 0.5, 0.75)
EDGES = 1 << 13
"""Blocks between states that are worked on at a time: their columns stay in the cache."""
FEWEST = 16
"""Rows that are worked on at a time at least."""
TURN = 2.0 * np.pi
TINY = 1e-300
"""A chord of no length: distances are then measured from its start."""


@dataclass(frozen=True, eq=False)
class Ends:
    """States at one end of a block: ``arm`` (nine columns (m, k), or numbers), ``tip`` (3 columns (m, k),
    first frame) and the rotary words ``a``, ``b`` (m, k) rad."""

    arm: Columns
    tip: Columns
    a: Floats
    b: Floats

    def take(self, rows: slice) -> Ends:
        """Return some of the rows."""
        arm, place = (tuple(c[:, rows] if c.ndim else c for c in columns) for columns in (self.arm, self.tip))
        return Ends(arm, place, self.a[:, rows], self.b[:, rows])


@dataclass(frozen=True, eq=False)
class States:
    """States: ``axis`` (3, m, k), and the ends that blocks have there."""

    axis: Floats
    ends: Ends


@dataclass(frozen=True, eq=False)
class Ring:
    """How a cutter that is no ball sits: its ``radius`` mm, ``normal`` (k, 3) of the surface and ``feed`` (k,
    3), unit."""

    radius: float
    normal: Floats
    feed: Floats

    def take(self, rows: Ints) -> Ring:
        """Return some of the rows."""
        return Ring(self.radius, self.normal[rows], self.feed[rows])

    def out(self, axis: Floats) -> Floats:
        """From the centre of the corner circle to the hub (m k, 3) mm, for axes (m k, 3) of m states of all k
        rows."""
        normal, feed = (np.tile(column, (len(axis) // len(column), 1)) for column in (self.normal, self.feed))
        return self.radius * ring_direction(normal, axis, feed, self.radius)


def states(
    kinematics: Chain, angles: Floats, centre: Floats, reach: float, ring: Ring | None = None
) -> States:
    """Return the states with rotary words ``angles`` (2, m, k) rad at ``centre`` (k, 3) mm of the ball;
    ``reach`` mm: from there, or from the hub of a cutter with a ``ring``, down the axis to the point that the
    words drive."""
    flat, shape, frame = angles.reshape(2, -1).T, angles.shape[1:], frames(kinematics)
    axis = forward(kinematics, np.column_stack([np.zeros((len(flat), 3)), flat]))[1]
    place = np.broadcast_to(centre, (*shape, 3)).reshape(-1, 3) - reach * axis
    if ring is not None:
        place = place + ring.out(axis)
    words = joint_words(kinematics, place, flat).T.reshape(5, *shape)
    arm = tuple(combine(frame.gain[i], tuple(words[:3]), float(frame.offset[i])) for i in range(9))
    x, y, z = (frame.first @ place.T).reshape(3, *shape)
    return States(axis.T.reshape(3, *shape), Ends(arm, (x, y, z), words[3], words[4]))


def bow(kinematics: Chain, start: Ends, end: Ends, shares: Sequence[float], nearest: bool = False) -> Floats:
    """Return the largest distance (m, m', k) mm of the real tip from the chord at the ``shares``, from every
    state of ``start`` to every one of ``end``; the ends' columns are (m, k) and (m', k). ``nearest``: the
    first word turns the shorter way, whole turns left out (for the middle alone)."""
    frame, (width, count), height = frames(kinematics), start.a.shape, len(end.a)
    found = np.empty((width, height, count))
    portion = max(FEWEST, EDGES // (width * height))
    for low in range(0, count, portion):
        rows = slice(low, min(low + portion, count))
        one, two = start.take(rows), end.take(rows)
        worst = _square(frame, one, two, shares[0], nearest)
        for share in shares[1:]:
            np.maximum(worst, _square(frame, one, two, share, nearest), out=worst)
        np.sqrt(worst, out=found[..., rows])
    return found


def _square(frame: Frames, start: Ends, end: Ends, share: float, nearest: bool) -> Floats:
    """Return the squared distance at one share."""
    rest = 1.0 - share
    cos_a, sin_a = _mix_turns(rest * start.a, share * end.a)
    if nearest:  # a whole turn more at the end is half a turn more in the middle
        sign = np.cos(np.pi * np.rint(_add_pairs(-start.a, end.a) / TURN))
        cos_a, sin_a = sign * cos_a, sign * sin_a
    cos_b, sin_b = _mix_turns(rest * start.b, share * end.b)
    arm = tuple(
        _add_pairs(rest * p, share * q) if p.ndim else p for p, q in zip(start.arm, end.arm, strict=True)
    )
    x, y, z = (
        c - p[:, None]
        for c, p in zip(tip(frame, Pose(arm, cos_a, sin_a, cos_b, sin_b)), start.tip, strict=True)
    )
    cx, cy, cz = (_add_pairs(-p, q) for p, q in zip(start.tip, end.tip, strict=True))
    foot = dot((x, y, z), (cx, cy, cz))
    foot /= dot((cx, cy, cz), (cx, cy, cz)) + TINY
    np.clip(foot, 0.0, 1.0, out=foot)
    off = (x - foot * cx, y - foot * cy, z - foot * cz)
    return dot(off, off)


def _add_pairs(one: Floats, two: Floats) -> Floats:
    return np.asarray(one[:, None] + two[None])


def _mix_turns(one: Floats, two: Floats) -> tuple[Floats, Floats]:
    """Cosine and sine of ``one`` (m, k) + ``two`` (m', k), by the sums of angles: four products instead of
    trigonometry."""
    c1, s1, c2, s2 = np.cos(one)[:, None], np.sin(one)[:, None], np.cos(two)[None], np.sin(two)[None]
    return c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
