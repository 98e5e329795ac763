# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forward and inverse kinematics: one generic chain for every machine of two rotary axes.

work frame   parallel to the machine frame, zero at the setup's origin. With both rotary words zero the linear
             words are the tip's work coordinates, whatever the offsets.
first        the rotary axis nearer to the work; its direction a1 never moves in the work frame. a2 is the
             second one's.

The motion of the tool relative to the work is a product of the axes' motions in the order from work to tool:
``tip = L0 + T1(L1 + T2(L2))`` with ``T(x) = c + R(x - c)`` the turn about a rotary line and ``L`` the sum of
the linear words that stand before, between and after the two rotary axes; ``axis = R1 R2 ez``.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import cast

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.columns import (
    Column,
    Columns,
    Matrix,
    add_vectors,
    clean,
    cos_sin,
    cross_vectors,
    empty_rows,
    less,
    map_vectors,
    put,
    scalar,
    split,
)
from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.number_text import round_as_printed
from freecad_fiveaxis.core.base.records import Bytes, Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import Axis, Machine, Vector

from .rotary_pair import RotaryPair, Turns, poses

PARALLEL = 1e-9
"""Sine below which two directions count as parallel, and determinant below which three lie in a plane."""


@dataclass(frozen=True)
class Setup:
    """``origin``: the work zero in the machine frame, mm; ``tool_length``: gauge point to the driven point,
    mm."""

    origin: Vector = (0.0, 0.0, 0.0)
    tool_length: float = 0.0


@dataclass(frozen=True, eq=False)
class Chain:
    """The constants of one machine in one setup; word order X Y Z, first rotary, second rotary.

    ``direction`` (5, 3) unit; ``point1`` and ``point2`` (3,) of the rotary lines in the work frame with the
    tip at the work zero, mm; ``slot`` (3,) for X Y Z: 0 before the first rotary axis, 1 between, 2 after the
    second; ``low``, ``high`` (5,) limits **of the words** in mm and rad; ``rate`` (5,) mm/min and rad/min.
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
    """Return the machine's constants in this setup. Raises MachineError for a chain without a solution."""
    linear = sorted(machine.linear, key=lambda axis: axis.letter)
    axes = (*linear, *machine.rotary)
    direction = np.array([axis.direction for axis in axes], float)
    rotary_at = [i for i, axis in enumerate(machine.axes) if axis.rotary]
    slot = tuple(sum(machine.axes.index(axis) > at for at in rotary_at) for axis in linear)
    tip = np.array(machine.gauge_point) - (0.0, 0.0, setup.tool_length)
    _check_solvable(machine, direction)
    shift = np.linalg.solve(direction[:3].T, np.array(setup.origin) - tip)
    moves = (
        shift[:, None] * direction[:3]
    )  # with the tip at the work zero, the linear axes before a rotary line carry it there
    before = [[place <= i for place in slot] for i in range(2)]
    points = [
        np.array(axis.point) - setup.origin + moves[mask].sum(axis=0)
        for axis, mask in zip(machine.rotary, before, strict=True)
    ]
    moved = np.concatenate([shift, (0.0, 0.0)])
    low, high, rate = (
        np.array([getattr(axis, name) for axis in axes]) for name in ("low", "high", "max_rate")
    )
    letters = "".join(axis.letter for axis in axes)
    return Chain(
        letters,
        direction,
        points[0],
        points[1],
        (slot[0], slot[1], slot[2]),
        low - moved,
        high - moved,
        rate,
        axes,
    )


def raise_chain(kinematics: Chain, lift: Floats) -> Chain:
    """Return the chain whose driven point stands ``lift`` (3,) mm, in words X Y Z, above that of
    ``kinematics`` and turns with the tool: its words are those of ``kinematics`` and ``lift``."""
    moves, slot = lift[:, None] * kinematics.direction[:3], np.array(kinematics.slot)
    point1, point2 = (
        point - moves[slot <= i].sum(axis=0) for i, point in enumerate((kinematics.point1, kinematics.point2))
    )
    moved = np.concatenate([lift, (0.0, 0.0)])
    return replace(
        kinematics, point1=point1, point2=point2, low=kinematics.low + moved, high=kinematics.high + moved
    )


def lift_of(kinematics: Chain, height: float, decimals: int, unit: float = 1.0) -> Floats:
    """Return the linear words (3,) mm that move the tool ``height`` mm along its axis where both rotary words
    are zero, rounded to ``decimals`` in ``unit`` mm: added to rounded words they give rounded words."""
    return round_as_printed(
        np.asarray(np.linalg.solve(kinematics.direction[:3].T, (0.0, 0.0, height)), float), decimals, unit
    )


def _check_solvable(machine: Machine, direction: Floats) -> None:
    problem: str = ""
    first, second = direction[3], direction[4]
    if np.linalg.norm(np.cross(first, second)) < PARALLEL:
        problem = say("both rotary axes are parallel; tilt one of them")
    elif np.linalg.norm(np.cross(second, (0, 0, 1))) < PARALLEL:
        problem = say(
            "the second rotary axis is parallel to the tool and never tilts it; is the order of the two "
            "right?"
        )
    elif abs(np.linalg.det(direction[:3])) < PARALLEL:
        problem = say("the linear axes X, Y, Z lie in one plane; correct their directions")
    if problem:
        raise MachineError(say("machine {name}: {problem}", name=machine.name, problem=problem), machine.name)


def turn(vector: Floats, axis: Floats, cos: Floats, sin: Floats) -> Floats:
    """Rodrigues: ``vector`` (n, 3) turned about unit ``axis`` (3,) by the angle of ``cos``, ``sin`` (n,)."""
    along = (vector @ axis)[:, None] * axis
    return along + cos[:, None] * (vector - along) + sin[:, None] * np.cross(axis, vector)


def forward(kinematics: Chain, q: Floats) -> tuple[Floats, Floats]:
    """Tip (n, 3) mm and unit tool axis (n, 3) in the work frame, for words ``q`` (n, 5) mm and rad. NaN stays
    NaN."""
    q = np.asarray(q, float)
    k, tip, axis = _constants(kinematics), empty_rows(len(q), 3), empty_rows(len(q), 3)

    def fill(rows: slice) -> None:
        *words, q1, q2 = split(q[rows])
        turns = _turns(q1, q2)
        put(tip[rows], _tip(k, [map_vectors(matrix, words) for matrix in k.sums], turns))
        put(axis[rows], k.pair.turn1.of(k.pair.turn2.of_ez(turns[2], turns[3]), turns[0], turns[1]))

    in_threads(fill, chunks(len(q)))
    return tip, axis


def forward_tip(kinematics: Chain, q: Floats) -> Floats:
    """Return the tip (n, 3) mm alone, as forward."""
    q = np.asarray(q, float)
    k, tip = _constants(kinematics), empty_rows(len(q), 3)

    def fill(rows: slice) -> None:
        *words, q1, q2 = split(q[rows])
        put(tip[rows], _tip(k, [map_vectors(matrix, words) for matrix in k.sums], _turns(q1, q2)))

    in_threads(fill, chunks(len(q)))
    return tip


def inverse(kinematics: Chain, tip: Floats, axis: Floats) -> tuple[Floats, Floats]:
    """All branches: words (2, n, 5) mm and rad, rotary in (-pi, pi], and the singularity measure (n,).

    NaN rows where the machine cannot take up the axis. At the pole the first rotary word is 0. The measure is
    ``|a1 . (a2 x k)|``: how fast the axis can leave, 0 at the pole, sin(tilt) for a machine of orthogonal
    axes.
    """
    tip, axis = np.asarray(tip, float), np.asarray(axis, float)
    k, words, sine = _constants(kinematics), empty_rows(2, len(axis), 5), np.empty(len(axis))

    def fill(rows: slice) -> None:
        place = split(tip[rows])
        sine[rows], branches = poses(k.pair, axis[rows])
        for branch, (angles, turns) in enumerate(branches):
            put(words[branch, rows], [*_linear(kinematics, k, place, turns), *angles])

    in_threads(fill, chunks(len(axis)))
    return words, sine


def inverse_axis(kinematics: Chain, axis: Floats) -> tuple[Floats, Floats]:
    """Both rotary words (2, n, 2) rad in (-pi, pi] for unit ``axis`` (n, 3), and the singularity measure
    (n,), as inverse."""
    axis = np.asarray(axis, float)
    k, words, sine = _constants(kinematics), empty_rows(2, len(axis), 2), np.empty(len(axis))

    def fill(rows: slice) -> None:
        sine[rows], branches = poses(k.pair, axis[rows])
        for branch, (angles, _) in enumerate(branches):
            put(words[branch, rows], angles)

    in_threads(fill, chunks(len(axis)))
    return words, sine


def linear_words(kinematics: Chain, tip: Floats, angles: Floats) -> Floats:
    """Return the linear words X Y Z (n, 3) mm alone, as joint_words."""
    return joint_words(kinematics, tip, angles)[:, :3]


def joint_words(kinematics: Chain, tip: Floats, angles: Floats) -> Floats:
    """Return the words (n, 5) mm and rad that put the tip (n, 3) mm, work frame, in place at rotary words
    ``angles`` (n, 2) rad.

    NaN linear words where the linear axes lie in a plane, which only happens to those on different sides of a
    rotary axis.
    """
    tip, angles = np.asarray(tip, float), np.asarray(angles, float)
    k, words = _constants(kinematics), empty_rows(len(tip), 5)

    def fill(rows: slice) -> None:
        rotary = split(angles[rows])
        put(words[rows], [*_linear(kinematics, k, split(tip[rows]), _turns(*rotary)), *rotary])

    in_threads(fill, chunks(len(tip)))
    return words


def branch_of(kinematics: Chain, second: Floats) -> Bytes:
    """Return the branch (n,) to which a second rotary word (n,) rad of any winding belongs."""
    turns = (np.asarray(second, float) - _constants(kinematics).pair.best) / (2.0 * np.pi)
    with np.errstate(invalid="ignore"):
        return np.asarray(turns - np.ceil(turns - 0.5) < 0.0, np.int8)


def q_to_words(q: Floats) -> Floats:
    """Words (..., 5) in mm and degrees from q (..., 5) in mm and rad."""
    return _rescale_words(q, 180.0 / np.pi)


def words_to_q(words: Floats) -> Floats:
    """q (..., 5) in mm and rad from words (..., 5) in mm and degrees."""
    return _rescale_words(words, np.pi / 180.0)


def _rescale_words(values: Floats, factor: float) -> Floats:
    copy = np.array(values, float, order="K")
    copy[..., 3:] *= factor
    return copy


# The constants of a chain, and the formulas for one chunk of rows, by columns.


@dataclass(frozen=True)
class _Constants:
    """What the formulas need of a chain.

    ``point1``, ``point2`` (3,) the feet of the rotary lines; ``sums`` from X Y Z to L0, L1, L2; ``words``
    from a shift of the tool back to X Y Z.
    """

    pair: RotaryPair
    point1: list[float]
    point2: list[float]
    sums: list[Matrix]
    words: Matrix


@lru_cache(maxsize=64)
def _constants(kinematics: Chain) -> _Constants:
    """Worked out once: a Chain compares by identity and never changes."""
    moves, slot = kinematics.direction[:3], np.array(kinematics.slot)
    return _Constants(
        pair=RotaryPair.of(kinematics.direction[3], kinematics.direction[4]),
        point1=_foot(kinematics.point1, kinematics.direction[3]),
        point2=_foot(kinematics.point2, kinematics.direction[4]),
        sums=[cast(Matrix, (moves * (slot == level)[:, None]).T.tolist()) for level in range(3)],
        words=cast(Matrix, clean(np.asarray(np.linalg.inv(moves.T), float)).tolist()),
    )


def _foot(point: Floats, direction: Floats) -> list[float]:
    """Return the point of the line that is nearest to the work zero: any of its points gives the same
    turns."""
    return cast("list[float]", clean(point - float(point @ direction) * direction).tolist())


def _turns(q1: Floats, q2: Floats) -> Turns:
    return *cos_sin(q1), *cos_sin(q2)


def _tip(k: _Constants, sums: list[list[Column]], turns: Turns) -> list[Column]:
    """``L0 + T1(L1 + T2(L2))``."""
    cos1, sin1, cos2, sin2 = turns
    point = add_vectors(k.point2, k.pair.turn2.of(less(sums[2], k.point2), cos2, sin2))
    point = add_vectors(k.point1, k.pair.turn1.of(less(add_vectors(sums[1], point), k.point1), cos1, sin1))
    return add_vectors(sums[0], point)


def _linear(kinematics: Chain, k: _Constants, place: Columns, turns: Turns) -> list[Column]:
    """Return the linear words for tips at known rotary words."""
    cos1, sin1, cos2, sin2 = turns
    rest = less(place, _tip(k, [[0.0] * 3] * 3, turns))
    if len(set(kinematics.slot)) > 1:
        return _solve_linear_words(kinematics, k, rest, turns)
    if kinematics.slot[0] > 0:
        rest = k.pair.turn1.of(rest, cos1, -sin1)
    if kinematics.slot[0] > 1:
        rest = k.pair.turn2.of(rest, cos2, -sin2)
    return map_vectors(k.words, rest)


def _solve_linear_words(kinematics: Chain, k: _Constants, rest: Columns, turns: Turns) -> list[Column]:
    """Linear axes on different sides of a rotary one: Cramer's rule on their directions as they stand in each
    row."""
    x, y, z = (
        _carry_direction(k, cast("list[float]", kinematics.direction[j].tolist()), kinematics.slot[j], turns)
        for j in range(3)
    )
    volume = np.asarray(scalar(x, cross_vectors(y, z)))
    volume = np.where(np.abs(volume) < PARALLEL, np.nan, volume)
    return [scalar(rest, cross_vectors(a, b)) / volume for a, b in ((y, z), (z, x), (x, y))]


def _carry_direction(k: _Constants, direction: Columns, slot: int, turns: Turns) -> Columns:
    cos1, sin1, cos2, sin2 = turns
    if slot > 1:
        direction = k.pair.turn2.of(direction, cos2, sin2)
    return k.pair.turn1.of(direction, cos1, sin1) if slot > 0 else direction
