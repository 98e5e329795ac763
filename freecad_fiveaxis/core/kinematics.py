# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forward and inverse kinematics: one generic chain for every machine of two rotary axes.

work frame   parallel to the machine frame, zero at the setup's origin. With both rotary words zero the linear words are
             the tip's work coordinates, whatever the offsets.
first        the rotary axis nearer to the work; its direction never moves in the work frame.
pole         the tool axis parallel to the first rotary axis: the first rotary word is then free.
branch       0 where the second rotary word lies on the positive side of the pole position, 1 on the other.

The motion of the tool relative to the work is a product of the axes' motions in the order from work to tool:
``tip = L0 + T1(L1 + T2(L2))`` with ``T(x) = c + R(x - c)`` the turn about a rotary line and ``L`` the sum of the linear
words that stand before, between and after the two rotary axes; ``axis = R1 R2 ez``.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .errors import MachineError
from .machine import Axis, Machine, Vector
from .records import Bytes, Floats

TINY = 1e-14
"""Below this a direction's component is rounding of a unit vector, not geometry."""


@dataclass(frozen=True)
class Setup:
    """``origin``: the work zero in the machine frame, mm; ``tool_length``: gauge point to the driven point, mm."""

    origin: Vector = (0.0, 0.0, 0.0)
    tool_length: float = 0.0


@dataclass(frozen=True, eq=False)
class Chain:
    """The constants of one machine in one setup; word order X Y Z, first rotary, second rotary.

    ``direction`` (5, 3) unit; ``point1`` and ``point2`` (3,) of the rotary lines in the work frame with the tip at the work
    zero, mm; ``slot`` (3,) for X Y Z: 0 before the first rotary axis, 1 between, 2 after the second; ``low``, ``high``
    (5,) limits **of the words** in mm and rad; ``rate`` (5,) mm/min and rad/min.
    """

    letters: str
    direction: Floats
    point1: Floats
    point2: Floats
    slot: tuple[int, int, int]
    low: Floats
    high: Floats
    rate: Floats
    axes: tuple[Axis, ...]


def chain(machine: Machine, setup: Setup) -> Chain:
    """The machine's constants in this setup. Raises MachineError for a chain without a solution."""
    linear = sorted(machine.linear, key=lambda axis: axis.letter)
    axes = (*linear, *machine.rotary)
    direction = np.array([axis.direction for axis in axes], float)
    rotary_at = [i for i, axis in enumerate(machine.axes) if axis.rotary]
    slot = tuple(sum(machine.axes.index(axis) > at for at in rotary_at) for axis in linear)
    tip = np.array(machine.gauge_point) - (0.0, 0.0, setup.tool_length)
    points = [np.array(axis.point) - (tip if axis.side == "head" else setup.origin) for axis in machine.rotary]
    _check_solvable(machine, direction)
    shift = np.linalg.solve(direction[:3].T, np.array(setup.origin) - tip)
    moved = np.concatenate([shift, (0.0, 0.0)])
    low, high, rate = (np.array([getattr(axis, name) for axis in axes]) for name in ("low", "high", "max_rate"))
    letters = "".join(axis.letter for axis in axes)
    return Chain(letters, direction, points[0], points[1], (slot[0], slot[1], slot[2]), low - moved, high - moved, rate, axes)


def _check_solvable(machine: Machine, direction: Floats) -> None:
    first, second = direction[3], direction[4]
    if np.linalg.norm(np.cross(first, second)) < 1e-9:
        raise MachineError(f"machine {machine.name}: both rotary axes are parallel; no tool axis can be reached", machine.name)
    if np.linalg.norm(np.cross(second, (0, 0, 1))) < 1e-9:
        raise MachineError(f"machine {machine.name}: the second rotary axis is parallel to the tool and never tilts it", machine.name)
    if abs(np.linalg.det(direction[:3])) < 1e-9:
        raise MachineError(f"machine {machine.name}: the linear axes do not span space", machine.name)


def turn(vector: Floats, axis: Floats, cos: Floats, sin: Floats) -> Floats:
    """Rodrigues: ``vector`` (n, 3) turned about unit ``axis`` (3,) by the angle of ``cos``, ``sin`` (n,)."""
    along = (vector @ axis)[:, None] * axis
    return along + cos[:, None] * (vector - along) + sin[:, None] * np.cross(axis, vector)


def forward(links: Chain, q: Floats) -> tuple[Floats, Floats]:
    """Tip (n, 3) mm and unit tool axis (n, 3) in the work frame, for words ``q`` (n, 5) mm and rad."""
    q = np.asarray(q, float)
    first, second = links.direction[3], links.direction[4]
    c1, s1, c2, s2 = np.cos(q[:, 3]), np.sin(q[:, 3]), np.cos(q[:, 4]), np.sin(q[:, 4])
    sums = [q[:, :3] @ (links.direction[:3] * (np.array(links.slot) == slot)[:, None]) for slot in range(3)]
    inner = links.point2 + turn(sums[2] - links.point2, second, c2, s2)
    tip = sums[0] + links.point1 + turn(sums[1] + inner - links.point1, first, c1, s1)
    axis = turn(turn(np.broadcast_to((0.0, 0.0, 1.0), (len(q), 3)), second, c2, s2), first, c1, s1)
    return tip, axis


def inverse(links: Chain, tip: Floats, axis: Floats) -> tuple[Floats, Floats]:
    """All branches: words (2, n, 5) mm and rad, rotary in (-pi, pi], and the singularity measure (n,).

    NaN rows where the machine cannot take up the axis. At the pole the first rotary word is 0. The measure is
    ``|a1 . (a2 x k)|``: how fast the axis can leave, 0 at the pole, sin(tilt) for a machine of orthogonal axes.
    """
    angles, sine = inverse_axis(links, axis)
    words = np.empty((2, len(axis), 5))
    for branch in range(2):
        words[branch, :, 3:] = angles[branch]
        words[branch, :, :3] = linear_words(links, tip, angles[branch])
    return words, sine


def inverse_axis(links: Chain, axis: Floats) -> tuple[Floats, Floats]:
    """Both rotary words (2, n, 2) rad for unit ``axis`` (n, 3), and the singularity measure (n,).

    ``a1 . R2(q2) ez = D + H cos(q2 - q2*)``: the half angle of ``q2 - q2*`` comes from the chord between k and a1, so that
    nothing cancels near the pole.
    """
    a1, a2 = links.direction[3], links.direction[4]
    k = np.asarray(axis, float)
    near = np.cross(a2, np.cross(a1, a2))  # the part of a1 across a2
    ez = np.array((0.0, 0.0, 1.0))
    cos_part, sin_part = ez @ near, np.cross(a2, ez) @ near
    reach = float(np.hypot(cos_part, sin_part))
    best = float(np.arctan2(sin_part, cos_part))
    gap = (a1 @ a2) * (a2 @ ez) + reach - 1.0
    far = (a1 @ a2) * (a2 @ ez) - reach + 1.0
    gap, far = (0.0 if abs(value) < TINY else float(value) for value in (gap, far))
    sin2 = (gap + 0.5 * ((k - a1) ** 2).sum(1)) / (2 * reach)
    cos2 = (0.5 * ((k + a1) ** 2).sum(1) - far) / (2 * reach)
    outside = (sin2 < -1e-12) | (cos2 < -1e-12)
    half_sin, half_cos = np.sqrt(np.maximum(sin2, 0.0)), np.sqrt(np.maximum(cos2, 0.0))
    delta = 2.0 * np.arctan2(half_sin, half_cos)
    top = turn(ez[None], a2, np.array([np.cos(best)]), np.array([np.sin(best)]))[0]
    across = [_across(v, a1) for v in (top, np.cross(a2, top), np.cross(a2, np.cross(a2, top)))]
    sin_delta, versine = 2.0 * half_sin * half_cos, 2.0 * half_sin**2
    k_across = k - (k @ a1)[:, None] * a1
    angles = np.empty((2, len(k), 2))
    for branch, sign in enumerate((1.0, -1.0)):
        w = across[0] + sign * sin_delta[:, None] * across[1] + versine[:, None] * across[2]
        angles[branch, :, 0] = np.arctan2(np.cross(w, k_across) @ a1, (w * k_across).sum(1))
        angles[branch, :, 1] = _fold(best + sign * delta)
    angles[:, outside] = np.nan
    return angles, np.where(outside, np.nan, reach * sin_delta)


def _across(vector: Floats, axis: Floats) -> Floats:
    rest = vector - (vector @ axis) * axis
    return np.where(np.abs(rest) < TINY, 0.0, rest)


def _fold(angle: Floats) -> Floats:
    return angle - 2.0 * np.pi * np.ceil((angle - np.pi) / (2.0 * np.pi))


def linear_words(links: Chain, tip: Floats, angles: Floats) -> Floats:
    """The linear words X Y Z (n, 3) mm that put the tip (n, 3) mm, work frame, in place at rotary words (n, 2) rad."""
    at_zero = np.concatenate([np.zeros((len(angles), 3)), angles], axis=1)
    rest = tip - forward(links, at_zero)[0]
    columns = np.empty((len(angles), 3, 3))
    for j in range(3):
        vector = np.broadcast_to(links.direction[j], (len(angles), 3))
        for level in range(links.slot[j], 0, -1):
            vector = turn(vector, links.direction[2 + level], np.cos(angles[:, level - 1]), np.sin(angles[:, level - 1]))
        columns[:, :, j] = vector
    return np.linalg.solve(columns, rest[:, :, None])[:, :, 0]


def branch_of(links: Chain, second: Floats) -> Bytes:
    """The branch (n,) to which a second rotary word (n,) rad belongs."""
    a1, a2 = links.direction[3], links.direction[4]
    near = np.cross(a2, np.cross(a1, a2))
    best = np.arctan2(np.cross(a2, (0.0, 0.0, 1.0)) @ near, near[2])
    return np.asarray(_fold(second - best) < 0.0, np.int8)


def q_to_words(q: Floats) -> Floats:
    """Words (n, 5) in mm and degrees from q (n, 5) in mm and rad."""
    words = np.array(q, float)
    words[..., 3:] = np.rad2deg(words[..., 3:])
    return words


def words_to_q(words: Floats) -> Floats:
    """q (n, 5) in mm and rad from words (n, 5) in mm and degrees."""
    q = np.array(words, float)
    q[..., 3:] = np.deg2rad(q[..., 3:])
    return q
