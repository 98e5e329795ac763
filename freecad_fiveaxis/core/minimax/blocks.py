# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the tip leaves its chord in every block between the states of one row and those of the next.

state     one way to stand at a row: the two rotary words. Axis and linear words follow from them.
block     from a state of one row to a state of the next.
share     u of the block, at which the real tip is compared with the chord. The largest of a few shares stands for the largest
          of all: the middle alone is right to second order in the turn; quarters see a path that is bent like an S, too.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.kinematics import Chain, forward, joint_words
from freecad_fiveaxis.core.records import Floats
from freecad_fiveaxis.core.trajectory import Columns, Frames, Pose, combine, dot, frames, tip

MIDDLE = (0.5,)
QUARTERS = (0.25, 0.5, 0.75)
EDGES = 1 << 15
"""Blocks between states that are worked on at a time: their columns stay in the cache."""
TURN = 2.0 * np.pi
TINY = 1e-300
"""A chord of no length: distances are then measured from its start."""


@dataclass(frozen=True, eq=False)
class Ends:
    """States at one end of a block: ``arm`` (nine columns (k, m), or numbers), ``tip`` (3 columns (k, m), first frame) and the
    rotary words ``a``, ``b`` (k, m) rad."""

    arm: Columns
    tip: Columns
    a: Floats
    b: Floats

    def take(self, rows: slice) -> Ends:
        """Some of the rows."""
        arm, place = (tuple(c[rows] if c.ndim else c for c in columns) for columns in (self.arm, self.tip))
        return Ends(arm, place, self.a[rows], self.b[rows])


@dataclass(frozen=True, eq=False)
class States:
    """States (k, m) of k rows: ``axis`` (k, m, 3), and the ends that blocks have there."""

    axis: Floats
    ends: Ends


def states(links: Chain, angles: Floats, centre: Floats, reach: float) -> States:
    """The states with rotary words ``angles`` (k, m, 2) rad at ``centre`` (k, 3) mm of the ball; ``reach`` mm: from there down
    the axis to the point that the words drive."""
    shape, flat = angles.shape[:2], angles.reshape(-1, 2)
    axis = forward(links, np.column_stack([np.zeros((len(flat), 3)), flat]))[1].reshape(*shape, 3)
    return States(axis, _ends(links, frames(links), centre[:, None] - reach * axis, angles))


def _ends(links: Chain, frame: Frames, place: Floats, angles: Floats) -> Ends:
    shape = angles.shape[:2]
    words = joint_words(links, place.reshape(-1, 3), angles.reshape(-1, 2)).T.reshape(5, *shape)
    arm = tuple(combine(frame.gain[i], tuple(words[:3]), float(frame.offset[i])) for i in range(9))
    x, y, z = (np.ascontiguousarray(column) for column in np.moveaxis(place @ frame.first.T, -1, 0))
    return Ends(arm, (x, y, z), words[3], words[4])


def bow(links: Chain, start: Ends, end: Ends, shares: Sequence[float], nearest: bool = False) -> Floats:
    """The largest distance (k, m, m') mm of the real tip from the chord at the ``shares``, from every state of ``start`` to
    every one of ``end``; the ends' columns are (k, m) and (k, m'). ``nearest``: the first word turns the shorter way, whole turns
    left out (for the middle alone)."""
    frame, (count, width), height = frames(links), start.a.shape, end.a.shape[1]
    found = np.empty((count, width, height))
    portion = max(1, EDGES // (width * height))
    for low in range(0, count, portion):
        rows = slice(low, min(low + portion, count))
        one, two = start.take(rows), end.take(rows)
        worst = _square(frame, one, two, shares[0], nearest)
        for share in shares[1:]:
            np.maximum(worst, _square(frame, one, two, share, nearest), out=worst)
        np.sqrt(worst, out=found[rows])
    return found


def _square(frame: Frames, start: Ends, end: Ends, share: float, nearest: bool) -> Floats:
    """The squared distance at one share."""
    rest = 1.0 - share
    cos_a, sin_a = _mixed_turn(rest * start.a, share * end.a)
    if nearest:  # a whole turn more at the end is half a turn more in the middle
        sign = np.cos(np.pi * np.rint(_paired(-start.a, end.a) / TURN))
        cos_a, sin_a = sign * cos_a, sign * sin_a
    cos_b, sin_b = _mixed_turn(rest * start.b, share * end.b)
    arm = tuple(_paired(rest * p, share * q) if p.ndim else p for p, q in zip(start.arm, end.arm, strict=True))
    x, y, z = (c - p[:, :, None] for c, p in zip(tip(frame, Pose(arm, cos_a, sin_a, cos_b, sin_b)), start.tip, strict=True))
    cx, cy, cz = (q[:, None, :] - p[:, :, None] for p, q in zip(start.tip, end.tip, strict=True))
    foot = dot((x, y, z), (cx, cy, cz))
    foot /= dot((cx, cy, cz), (cx, cy, cz)) + TINY
    np.clip(foot, 0.0, 1.0, out=foot)
    off = (x - foot * cx, y - foot * cy, z - foot * cz)
    return dot(off, off)


def _paired(one: Floats, two: Floats) -> Floats:
    return np.asarray(one[:, :, None] + two[:, None, :])


def _mixed_turn(one: Floats, two: Floats) -> tuple[Floats, Floats]:
    """Cosine and sine of ``one`` (k, m) + ``two`` (k, m'), by the sums of angles: four products instead of trigonometry."""
    c1, s1, c2, s2 = np.cos(one)[:, :, None], np.sin(one)[:, :, None], np.cos(two)[:, None, :], np.sin(two)[:, None, :]
    return c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
