# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a chain with unknown lines and zeros makes of the words, and how that depends on the unknowns.

kind      table-table, head-table or head-head: where the linear axes stand among the rotary ones (``slot`` of
          a Chain).
layout    all that is discrete: kind, which letter is the rotary axis nearer to the work, the directions, and
          so the signs.
unknowns  nine numbers: two coordinates of each rotary line (across its direction), the zero of the linear
          words (three), the zeros of the rotary words (two). With a1, a2 and all nine given (symbols of
          kinematics, words w and l):

              tip = L0 + c1 + R1 (L1 + c2 - c1 + R2 (L2 - c2)),   axis = R1 R2 ez,   R_i = R(a_i, w_i - z_i),
              L of (l - e)

          At given rotary zeros the tip is **linear** in the other seven: they are found without a first
          guess.
noise     every printed number is off by its rounding. A rotary word's error moves tip and axis together, by
          its lever arm: the covariance (6, 6) of each row says so, and residuals are whitened with it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine import Vector

from .pairs import Pairs

TABLE_TABLE, HEAD_TABLE, HEAD_HEAD = (2, 2, 2), (1, 1, 1), (0, 0, 0)
KINDS = {TABLE_TABLE: "table-table", HEAD_TABLE: "head-table", HEAD_HEAD: "head-head"}
LINES, LINEAR_ZERO, ROTARY_ZERO = slice(0, 4), slice(4, 7), slice(7, 9)
UNKNOWNS = 9
TIP_FLOOR, AXIS_FLOOR = 1e-7, 1e-10
"""mm and 1: nothing is known better than this, whatever the number of its digits."""
EVEN = math.sqrt(12.0)

XYZ = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True)
class Layout:
    """``letters``: first rotary axis (nearer to the work), second; ``direction1``, ``direction2`` unit;
    ``linear``: directions of X Y Z; ``strange``: how far it is from what the letters and ISO 841 lead to
    expect, 0 for the plainest."""

    slot: tuple[int, int, int]
    letters: str
    direction1: Vector
    direction2: Vector
    linear: tuple[Vector, Vector, Vector] = XYZ
    strange: float = 0.0

    @property
    def kind(self) -> str:
        """In words."""
        return KINDS.get(self.slot, "linear axes between the rotary ones")


def across(direction: Vector) -> Floats:
    """Two unit vectors (2, 3) across a direction: coordinate axes where that is along one."""
    a = np.array(direction)
    first = np.array(XYZ[int(np.argmin(np.abs(a)))])
    first = first - (first @ a) * a
    first /= np.linalg.norm(first)
    second = np.cross(a, first)
    second *= 1.0 if second[int(np.argmax(np.abs(second)))] > 0.0 else -1.0
    rows = np.array([first, second])
    return rows[np.argsort([int(np.argmax(np.abs(row))) for row in rows], kind="stable")]


def turns(direction: Vector, angle: Floats) -> Floats:
    """Rotation matrices (n, 3, 3) about a unit direction (Rodrigues)."""
    x, y, z = direction
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    along = np.outer(direction, direction)
    cos, sin = np.cos(angle)[:, None, None], np.sin(angle)[:, None, None]
    return np.asarray(along + cos * (np.eye(3) - along) + sin * cross)


@dataclass(frozen=True, eq=False)
class Rows:
    """Residuals of one layout: ``residual`` (n, 6) tip mm and axis, ``jacobian`` (n, 6, 9) of what the words
    give, ``whitener`` (n, 6, 6): times the residual it has unit covariance."""

    residual: Floats
    jacobian: Floats
    whitener: Floats


def rows_of(layout: Layout, pairs: Pairs, base: Floats, unknown: Floats) -> Rows:
    """Residual, derivative and noise of every pair. ``base`` (2, 3): points from which the lines' coordinates
    count, mm; ``unknown`` (9,) mm and rad."""
    order = [pairs.letters.index(letter) for letter in layout.letters]
    turned = pairs.rotary[:, order] - unknown[ROTARY_ZERO]
    first, second = turns(layout.direction1, turned[:, 0]), turns(layout.direction2, turned[:, 1])
    both = first @ second
    basis1, basis2 = across(layout.direction1), across(layout.direction2)
    c1, c2 = base[0] + unknown[0:2] @ basis1, base[1] + unknown[2:4] @ basis2
    linear, slot = pairs.linear - unknown[LINEAR_ZERO], np.array(layout.slot)
    moves = np.array(layout.linear)
    sums = [(linear * (slot == level)) @ moves for level in range(3)]
    arm2 = np.einsum("nij,nj->ni", second, sums[2] - c2)
    arm1 = np.einsum("nij,nj->ni", first, sums[1] + c2 - c1 + arm2)
    reached = both[:, :, 2]
    residual = np.concatenate([pairs.tip - (sums[0] + c1 + arm1), pairs.axis - reached], axis=1)
    jacobian = np.zeros((len(residual), 6, UNKNOWNS))
    jacobian[:, :3, 0:2] = (np.eye(3) - first) @ basis1.T
    jacobian[:, :3, 2:4] = (first - both) @ basis2.T
    carried = np.stack(
        [(np.broadcast_to(np.eye(3), first.shape), first, both)[at] @ moves[j] for j, at in enumerate(slot)],
        axis=2,
    )
    jacobian[:, :3, LINEAR_ZERO] = -carried
    turning = np.zeros((len(residual), 6, 2))
    turning[:, :3, 0] = np.cross(layout.direction1, arm1)
    turning[:, :3, 1] = np.einsum("nij,nj->ni", first, np.cross(layout.direction2, arm2))
    turning[:, 3:, 0] = np.cross(layout.direction1, reached)
    turning[:, 3:, 1] = np.einsum("nij,nj->ni", first, np.cross(layout.direction2, second[:, :, 2]))
    jacobian[:, :, ROTARY_ZERO] = -turning
    return Rows(residual, jacobian, _whitener(pairs, carried, turning))


def _whitener(pairs: Pairs, carried: Floats, turning: Floats) -> Floats:
    steps = pairs.steps
    own = [max(steps.tip / EVEN, TIP_FLOOR) ** 2] * 3 + [max(steps.axis / EVEN, AXIS_FLOOR) ** 2] * 3
    covariance = np.zeros((len(turning), 6, 6))
    covariance[:] = np.diag(own)
    covariance[:, :3, :3] += (steps.linear / EVEN) ** 2 * (carried @ carried.transpose(0, 2, 1))
    covariance += (steps.rotary / EVEN) ** 2 * (turning @ turning.transpose(0, 2, 1))
    return np.asarray(np.linalg.inv(np.linalg.cholesky(covariance)))
