# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sphere of tool axes as the two rotary axes divide it: poles and meridians.

pole      the axes parallel to the first rotary axis: there any first rotary word will do.
meridian  the axes that the tool takes up while the first rotary word stands still and the second one turns: a
          circle about the second rotary axis. On a machine of orthogonal axes a great circle through the
          pole, as on a globe.
room      how far the first rotary word may leave the given one while its meridian stays within an angle of
          the given axis.
side      the angle about the first rotary axis from the tool axis to the second rotary axis. The other branch
          has it negated.

With a1, a2 the directions of the axes at rest, b the angle between a2 and ez, g between a1 and a2, and k a
tool axis at t from a1, the meridian of word q1 has its centre at ``R1(q1) a2``, and

    ``k . R1(q1) a2 = cos t cos g + sin t sin g cos(side)``.

The meridian is within an angle e of k where this is between ``cos(b + e)`` and ``cos(b - e)``: two intervals
of the word, one a branch, which grow together near the pole.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.ranges import OFF_POLE
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.machine.kinematics import Chain

TINY = 1e-300
"""Stands for a sine of zero in a division: the quotient is then beyond every cosine."""
BLURRED = 1e-12
"""Sine of the angle from the pole below which an axis has no azimuth that rounding does not make."""
STRAIGHT = 1e-9
"""Cosine below which two directions are perpendicular."""
TURN = 2.0 * math.pi


@dataclass(frozen=True, eq=False)
class Globe:
    """``pole``, ``second`` (3,) unit: a1 and a2; ``frame`` (2, 3): two directions across a1, right-handed
    with it; ``rest`` rad: azimuth of a2 in that frame; ``circle`` and ``lean`` rad: b and g."""

    pole: Floats
    second: Floats
    frame: Floats
    rest: float
    circle: float
    lean: float

    @staticmethod
    def of(kinematics: Chain) -> Globe:
        """Return the globe of a machine."""
        pole, second = kinematics.direction[3], kinematics.direction[4]
        across = np.linalg.svd(pole[None])[2][1]
        frame = np.array([across, np.cross(pole, across)])
        x, y = (float(value) for value in frame @ second)
        lean = math.atan2(math.hypot(x, y), float(pole @ second))
        return Globe(
            pole, second, frame, math.atan2(y, x), math.acos(min(1.0, max(-1.0, float(second[2])))), lean
        )

    @property
    def straight(self) -> bool:
        """Whether every meridian is a great circle through the pole, as on a globe: both branches then share
        them."""
        return max(abs(math.cos(self.lean)), abs(math.cos(self.circle))) < STRAIGHT

    def across(self, axis: Floats) -> Floats:
        """Return the parts (n, 2) of the axes (n, 3) across the first rotary axis: the azimuthal view, pole
        at zero."""
        return np.asarray((self.frame @ axis.T).T)

    def centre(self, word: Floats) -> Floats:
        """Centres (n, 3) of the meridians of first rotary words (n,) rad: the second rotary axis, turned."""
        out = (
            math.sin(self.lean)
            * np.column_stack([np.cos(self.rest + word), np.sin(self.rest + word)])
            @ self.frame
        )
        return np.asarray(out + math.cos(self.lean) * self.pole)

    def approach(self, axis: Floats) -> Floats:
        """How near (n - 1,) the way from each axis to the next comes to the pole, as a sine; inf from one
        half of the sphere to the other. The way is taken as straight in the azimuthal view."""
        place, along = self.across(axis), axis @ self.pole
        step = np.diff(place, axis=0)
        length2 = np.maximum((step * step).sum(1), TINY)
        share = np.clip(-(place[:-1] * step).sum(1) / length2, 0.0, 1.0)
        near = np.linalg.norm(place[:-1] + share[:, None] * step, axis=1)
        return np.where(along[1:] * along[:-1] > 0.0, near, np.inf)

    def side(self, axis: Floats, word: Floats) -> Floats:
        """Return the side (n,) rad in (-pi, pi] of the axes as the words (n,) take them up; next to the pole
        that of the row before."""
        x, y = self.across(axis).T
        side = math.pi - np.mod(math.pi - (self.rest + word - np.arctan2(y, x)), TURN)
        known = np.hypot(x, y) > BLURRED
        if known.all() or not known.any():
            return np.asarray(side)
        source = np.maximum.accumulate(np.where(known, np.arange(len(side)), int(np.argmax(known))))
        return np.asarray(side[source])

    def room(self, axis: Floats, side: Floats, change: float) -> tuple[Floats, Floats]:
        """How far (n,) rad below and above the word that takes up ``axis`` (n, 3) on ``side`` (n,) a word may
        lie, so that its meridian stays within ``change`` rad of the axis; inf where every word may."""
        x, y = self.across(axis).T
        scale = np.maximum(np.hypot(x, y) * math.sin(self.lean), TINY)
        level = axis @ self.pole * math.cos(self.lean)
        with np.errstate(over="ignore"):
            least = (math.cos(min(self.circle + change, math.pi)) - level) / scale
            most = (math.cos(max(self.circle - change, 0.0)) - level) / scale
        size = np.abs(side)
        inner = np.maximum(size - np.arccos(np.clip(most, -1.0, 1.0)), 0.0)
        outer = np.maximum(np.arccos(np.clip(least, -1.0, 1.0)) - size, 0.0)
        free = (least <= -1.0) & (most >= 1.0)
        below, above = np.where(side > 0.0, inner, outer), np.where(side > 0.0, outer, inner)
        return np.where(free, np.inf, below), np.where(free, np.inf, above)

    def nearest(self, axis: Floats, word: Floats) -> Floats:
        """Return the axis (n, 3) on the meridian of each word (n,) that is nearest to ``axis``, OFF_POLE off
        the pole at least."""
        centre = self.centre(word)
        rest = axis - (axis * centre).sum(1)[:, None] * centre
        rerouted = (
            math.cos(self.circle) * centre
            + math.sin(self.circle) * rest / np.linalg.norm(rest, axis=1)[:, None]
        )
        return self._off_pole(rerouted, centre)

    def _off_pole(self, rerouted: Floats, centre: Floats) -> Floats:
        near = np.flatnonzero(np.linalg.norm(self.across(rerouted), axis=1) < OFF_POLE)
        if len(near):
            along = np.cross(self.pole, centre[near])
            along /= np.linalg.norm(along, axis=1)[:, None]
            away = np.where((rerouted[near] * along).sum(1) < 0.0, -1.0, 1.0)
            pole = np.copysign(1.0, rerouted[near] @ self.pole)
            rerouted[near] = (
                math.cos(OFF_POLE) * pole[:, None] * self.pole + (math.sin(OFF_POLE) * away)[:, None] * along
            )
        return np.asarray(rerouted / np.linalg.norm(rerouted, axis=1)[:, None])


def angle_between(one: Floats, other: Floats) -> Floats:
    """Angle (n,) rad between unit rows, from the chord, so that small ones are exact."""
    return np.asarray(2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(one - other, axis=1), 0.0, 1.0)))


def runs(flag: Bools) -> list[tuple[int, int]]:
    """Begin and end (exclusive) of each run of True."""
    edge = np.flatnonzero(np.diff(np.concatenate([[False], flag, [False]]).astype(np.int8)))
    return [(int(begin), int(end)) for begin, end in edge.reshape(-1, 2)]
