# SPDX-License-Identifier: LGPL-2.1-or-later
"""All places of a tool while each joint stands anywhere between two values, and how far they reach along a
direction.

box       of joints: the middle words and half the range of each; a joint that does not move has the half
          range 0.
corner    the poses with both rotary words at an end of their range, the linear ones in the middle: 4, 2 or 1.
travel    how far a linear joint carries the tip from the middle of its range to its end, at a corner.
bend      how far, at most, tip (mm) and axis (a pure number) leave what is bilinear between the corners.

**Why the corners are enough.** With the rotary words fixed the tip is linear in the linear ones. Between the
corners tip and axis leave their bilinear mean by at most ``a^2 / 2 |d2/da2| + b^2 / 2 |d2/db2|`` with the
half ranges a, b in rad (the error of linear interpolation, once for each word); the second derivatives are
the levers about the rotary axes, and 1 for the axis. A piece's support is convex in tip and axis together
(:mod:`.swept_motion`), so over the box it is at most the largest over the corners, with all travels added as
far as they go along the direction, thickened by the bend. For linear joints alone this is exact.
"""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, words_to_q
from freecad_fiveaxis.core.motion.trajectory import Frames, flat_length, frames
from freecad_fiveaxis.core.tool.body import Piece, support

from .swept_motion import Poses


class JointBoxes(NamedTuple):
    """``block`` (n,); ``middle``, ``half`` (n, 5) mm and **degrees**: the words of each box, from ``middle -
    half`` to ``middle + half``."""

    block: Ints
    middle: Floats
    half: Floats

    def take(self, rows: Ints) -> JointBoxes:
        """Pick some of them, by index (k,)."""
        return JointBoxes(self.block.take(rows), self.middle.take(rows, axis=0), self.half.take(rows, axis=0))

    def halve(self, joint: Ints) -> JointBoxes:
        """Halve each across one of its joints (n,): first all lower halves, then all upper ones."""
        half = self.half.copy()
        rows = np.arange(len(half))
        half[rows, joint] *= 0.5
        step = np.zeros_like(half)
        step[rows, joint] = half[rows, joint]
        middle = np.concatenate([self.middle - step, self.middle + step])
        return JointBoxes(np.tile(self.block, 2), middle, np.tile(half, (2, 1)))


class Hulls(NamedTuple):
    """Of n boxes: ``pose`` in the middle; at the c corners ``tip`` (c, 3, n) mm from the middle tip, unit
    ``axis`` (c, 3, n) and ``travel`` (c, 3, 3, n) mm of each linear joint; ``bend_tip`` (n,) mm and
    ``bend_axis`` (n,); ``size`` (n, 5) mm: each joint moves no point of the tool farther than that from the
    middle of its range."""

    pose: Poses
    tip: Floats
    axis: Floats
    travel: Floats
    bend_tip: Floats
    bend_axis: Floats
    size: Floats

    def take(self, rows: Ints) -> Hulls:
        """Pick some of them, by index (k,)."""
        pose = Poses(*(part.take(rows, axis=-1) for part in self.pose))
        tip, axis, travel, bend_tip, bend_axis = (
            part.take(rows, axis=-1)
            for part in (self.tip, self.axis, self.travel, self.bend_tip, self.bend_axis)
        )
        return Hulls(pose, tip, axis, travel, bend_tip, bend_axis, self.size.take(rows, axis=0))

    def compute_support(self, piece: Piece, g: Floats) -> Floats:
        """Give the support (n,) mm of the piece over the boxes in the unit directions g (3, n), from the
        middle tip."""
        travelled = np.abs((self.travel * g).sum(axis=2)).sum(axis=1)
        return np.asarray(
            (self._at_corners(piece, g, self.bend_axis) + travelled).max(axis=0) + self.bend_tip
        )

    def spread(self, piece: Piece, g: Floats) -> Floats:
        """Give what each joint (n, 5) adds to the support along g (3, n), mm: which of them to halve."""
        share = np.zeros_like(self.size)
        share[:, :3] = np.abs((self.travel * g).sum(axis=2)).max(axis=0).T
        value = self._at_corners(piece, g, 0.0)
        value = (
            value.reshape(1 + (len(value) > 1), -1, value.shape[1])
            if len(value) != 2
            else self._one_turns(value)
        )
        share[:, 3] = 0.5 * np.ptp(value, axis=0).max(axis=0)
        share[:, 4] = 0.5 * np.ptp(value, axis=1).max(axis=0)
        return share

    def _one_turns(self, value: Floats) -> Floats:
        return value[:, None] if self.size[:, 3].any() else value[None]

    def _at_corners(self, piece: Piece, g: Floats, loose: Floats | float) -> Floats:
        corners = zip(self.tip, self.axis, strict=True)
        return np.stack(
            [support(piece, (axis * g).sum(axis=0), loose) + (tip * g).sum(axis=0) for tip, axis in corners]
        )


class JointSpace(NamedTuple):
    """A machine, and how far above the tip the driven point lies, ``back`` mm."""

    kinematics: Chain
    frame: Frames
    back: float

    @classmethod
    def of(cls, kinematics: Chain, back: float = 0.0) -> JointSpace:
        """Take the machine's chain with its constants."""
        return cls(kinematics, frames(kinematics), back)

    def poses(self, words: Floats) -> Poses:
        """Give tip (3, n) mm and unit axis (3, n) at words (n, 5), mm and **degrees**."""
        tip, axis = forward(self.kinematics, words_to_q(words))
        return Poses(np.ascontiguousarray((tip - self.back * axis).T), np.ascontiguousarray(axis.T))

    def hulls(self, boxes: JointBoxes, reach: float) -> Hulls:
        """Give what each box holds; ``reach`` mm from the tip to the farthest point of the body."""
        middle, half = boxes.middle, boxes.half
        ways = np.eye(5)[:3] * half[:, :3].any(axis=0).reshape(3, 1)
        corners = self._corners(half)
        at = [middle, *(middle + turned + half * way for turned in corners for way in (np.zeros(5), *ways))]
        poses = self.poses(np.concatenate(at))
        tip, axis = (part.reshape(3, len(at), -1) for part in poses)
        pose = Poses(np.ascontiguousarray(tip[:, 0]), np.ascontiguousarray(axis[:, 0]))
        tips, axes = (np.moveaxis(part[:, 1:].reshape(3, len(corners), 4, -1), 0, 2) for part in (tip, axis))
        turn = np.deg2rad(half[:, 3:]).T
        lever = self._levers(middle, half) + abs(self.back)
        bend = 0.5 * turn * turn
        size = np.concatenate([half[:, :3], (turn * (lever + reach)).T], axis=1)
        bend_tip, bend_axis = (bend * lever).sum(axis=0), bend.sum(axis=0)
        return Hulls(
            pose, tips[:, 0] - pose.tip, axes[:, 0], tips[:, 1:] - tips[:, :1], bend_tip, bend_axis, size
        )

    @staticmethod
    def _corners(half: Floats) -> list[Floats]:
        """Return what leads to each corner (n, 5): the first axis' lower end first, of each the second's."""
        turns = [(-1.0, 1.0) if half[:, j].any() else (0.0,) for j in (3, 4)]
        return [half * np.array([0.0, 0.0, 0.0, a, b]) for a, b in product(*turns)]

    def _levers(self, middle: Floats, half: Floats) -> Floats:
        """(2, n) mm: no place of the box is farther from the first rotary axis, from the second, with the
        second word as it may be (the triangle inequality, as in
        :func:`~.motion.deviation.bound.quick_levers`)."""
        gain = self.frame.gain[3:]
        arm = np.abs(self.frame.offset[3:, None] + gain @ middle[:, :3].T) + np.abs(gain) @ half[:, :3].T
        second = flat_length(arm[3], arm[4])
        return np.stack([flat_length(arm[0], arm[1]) + flat_length(second, arm[5]), second])
