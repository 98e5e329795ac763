# SPDX-License-Identifier: LGPL-2.1-or-later
"""How what one axis of the machine carries moves, seen from what another one carries.

carrier   an axis, ``base``, or ``spindle`` (the last axis of the head). The work stands on the first axis of
          the table.
step      of the way from the one carrier to the other: an axis between them, with the sign by which its joint
          moves the far one. With joints q the far one stands at ``M1(q1) M2(q2) ... Mk(qk)``, each a turn
          about a line or a shift, given at all joints zero.
cell      joints about a middle, each up to its half range to both sides: all of them (``joined`` False), or
          in step from the one end to the other (True), as an axis interpolates.
lever     of a step: no point of the moved piece is farther from its line than this, mm; 1 for a linear axis.

**How far a cell reaches.** From the middle c of a cell the joints go to c + d one after the other, the one
next to the seeing carrier first. Step i then moves a point, turned by what went before, by ``(M(d_i) - 1) y``
with y at the middle: that is its velocity there times d_i, but for ``d_i^2 / 2 lever``; and what went before
has turned it by at most ``phi_i``, the sum of the half ranges of the rotary steps before it, which moves it
by at most ``phi_i d_i lever``. So along any direction g no point goes farther than its velocities say, and
``sum of half (half / 2 + phi) lever``, where a linear axis has no ``half / 2``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.geometry.convex import Convex, Poses, cross_rows, support_gap
from freecad_fiveaxis.core.machine import Axis, Machine
from freecad_fiveaxis.core.machine.bodies import BASE, SPINDLE


class Step(NamedTuple):
    """An axis and the sign of its joint."""

    axis: Axis
    sign: float


class Cells(NamedTuple):
    """``middle``, ``half`` (n, k), mm and rad, one column a step; ``owner`` (n,): the block of each; ``u``,
    ``wide`` (n,): the middle and half the length of its part of that block; ``guess`` (n, 3): a direction
    along which it may be free."""

    owner: Ints
    middle: Floats
    half: Floats
    u: Floats
    wide: Floats
    guess: Floats

    def take(self, rows: Ints | Bools) -> Cells:
        """Pick some of them."""
        owner, middle, half, u, wide, guess = self
        return Cells(owner[rows], middle[rows], half[rows], u[rows], wide[rows], guess[rows])


class Lines(NamedTuple):
    """Of n cells, seen from the standing piece: the moved one's ``poses`` in the middle, and of each step the
    ``direction`` (k, n, 3) unit and a ``point`` (k, n, 3) mm of its line; ``lever`` (k, n)."""

    poses: Poses
    direction: Floats
    point: Floats
    lever: Floats

    def take(self, rows: Ints | Bools) -> Lines:
        """Pick some of them."""
        return Lines(self.poses.take(rows), self.direction[:, rows], self.point[:, rows], self.lever[:, rows])


def carriers_from_base(machine: Machine, carrier: str) -> tuple[list[Axis], float]:
    """Give the axes from the base to what carries a body, that one included, and the sign of their joints."""
    table = [axis for axis in machine.fitted[::-1] if axis.side == "table"]
    head = [axis for axis in machine.fitted if axis.side == "head"]
    if carrier == BASE:
        return [], 1.0
    if carrier == SPINDLE:
        return head, 1.0
    axes, sign = (table, -1.0) if any(axis.letter == carrier for axis in table) else (head, 1.0)
    return axes[: [axis.letter for axis in axes].index(carrier) + 1], sign


def work_carrier(machine: Machine) -> str:
    """Name what carries the work: the axis of the table next to it, or the base."""
    return next((axis.letter for axis in machine.fitted if axis.side == "table"), BASE)


def steps_between(machine: Machine, seen_from: str, moved: str) -> tuple[Step, ...]:
    """Give the steps from one carrier to another, none where they stand still to each other."""
    (near, down), (far, up) = (carriers_from_base(machine, one) for one in (seen_from, moved))
    same = sum(1 for one, other in zip(near, far, strict=False) if one is other)
    return (*(Step(axis, -down) for axis in near[same:][::-1]), *(Step(axis, up) for axis in far[same:]))


@dataclass(frozen=True, eq=False)
class CarriedMotion:
    """The ``steps`` to what is ``moved``, as it stands at all joints zero."""

    steps: tuple[Step, ...]
    moved: Convex

    @property
    def rotary(self) -> Bools:
        """Which steps (k,) turn."""
        return np.array([step.axis.rotary for step in self.steps], np.bool_)

    def lines(self, middle: Floats) -> Lines:
        """Place the moved piece at joints ``middle`` (n, k), mm and rad."""
        count, (*before, (turn, shift)) = len(middle), self._frames(middle)
        directions, points = np.zeros((2, len(self.steps), count, 3))
        for k, ((axis, sign), frame) in enumerate(zip(self.steps, before, strict=True)):
            directions[k] = sign * (frame.turn @ np.array(axis.direction))
            points[k] = frame.place(np.array(axis.point))
        lever = np.ones((len(self.steps), count))
        off = turn @ self.moved.middle + shift - points
        across = off - (off * directions).sum(axis=2)[:, :, None] * directions
        lever[self.rotary] = np.linalg.norm(across[self.rotary], axis=2) + self.moved.reach
        return Lines(Poses(turn, shift), directions, points, lever)

    def place(self, joints: Floats) -> Poses:
        """Tell where the moved piece stands at ``joints`` (n, k), mm and rad, seen from the standing one."""
        *_, last = self._frames(joints)
        return last

    def _frames(self, joints: Floats) -> Iterator[Poses]:
        """Give the poses before each step, and after the last."""
        turn, shift = np.broadcast_to(np.eye(3), (len(joints), 3, 3)), np.zeros((len(joints), 3))
        yield Poses(turn, shift)
        turned = False
        for k, (axis, sign) in enumerate(self.steps):
            direction, by = np.array(axis.direction), sign * joints[:, k]
            if axis.rotary:
                new, point = _turns(direction, by), np.array(axis.point)
                arm = point - new @ point
                shift = shift + (np.matmul(turn, arm[:, :, None])[:, :, 0] if turned else arm)
                turn, turned = np.matmul(turn, new) if turned else new, True
            else:
                shift = shift + by[:, None] * (turn @ direction)
            yield Poses(turn, shift)

    def travel(self, lines: Lines, half: Floats) -> tuple[Floats, Floats]:
        """Tell by how much no point of the moved piece goes farther in cells of ``half`` (n, k) than its
        velocities say, mm (n,), and how far it goes at most, (n,)."""
        size = np.abs(half).T
        turned = size * self.rotary[:, None]
        before = np.cumsum(turned, axis=0) - turned
        bend = (size * lines.lever * (0.5 * turned + before)).sum(axis=0)
        return bend, (size * lines.lever).sum(axis=0)

    def least_gap(self, standing: Convex, lines: Lines, half: Floats, g: Floats, joined: bool) -> Floats:
        """Give the gaps (n,) mm along unit ``g`` (n, 3) that are left all over cells of ``half`` (n, k),
        rounds taken off.

        With the velocities of the middle the place of each corner along ``g`` is linear in the joints, so the
        least of all corners is least at an end of the cell: at one of both where the joints go in step, else
        of all that the joints that turn make.
        """
        bend, _ = self.travel(lines, half)
        axis = cross_rows(g, lines.direction) * self.rotary[:, None, None]
        flat = np.where(
            self.rotary[:, None], -(axis * lines.point).sum(axis=2), (g * lines.direction).sum(axis=2)
        )
        axis, flat = axis * half.T[:, :, None], flat * half.T
        if joined:
            ways = [np.ones(len(self.steps)), -np.ones(len(self.steps))]
        else:  # what a linear axis does is the same for every point
            bend = bend + np.abs(flat[~self.rotary]).sum(axis=0)
            ways = [self._turning(signs) for signs in product((1.0, -1.0), repeat=int(self.rotary.sum()))]
        gaps = [
            support_gap(self.moved, standing, lines.poses, g,
                np.tensordot(way, axis, 1)) + way @ flat for way in ways
        ]  # fmt: skip
        return np.asarray(np.min(gaps, axis=0) - bend)

    def _turning(self, signs: Sequence[float]) -> Floats:
        """Return these signs (k,) for the steps that turn, 0 for the others."""
        way = np.zeros(len(self.steps))
        way[self.rotary] = signs
        return way


def _turns(axis: Floats, angle: Floats) -> Floats:
    """Return the turns (n, 3, 3) about a unit axis (3,) by angles (n,), rad."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    sin, cos = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.asarray(cos * np.eye(3) + sin * cross + (1.0 - cos) * np.outer(axis, axis))
