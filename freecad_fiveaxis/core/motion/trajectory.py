# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the tip and the tool axis really go while all five axes move linearly.

block     the move from one row of words to the next: every word runs linearly from start to end.
u         how much of the block is done, 0 to 1, the same for all axes.
arm       the three vectors of the chain's product form, each of which moves linearly within a block:
          ``tip = s + R1(a) (w + R2(b) v)``, with ``a`` and ``b`` the two rotary words. ``s`` and ``w`` are
          given in the first frame, ``v`` in the second.
frame     the first frame has its z along the first rotary axis, the second frame along the second one. In
          them a turn is a turn of two components, and lengths and distances are those of the work frame.
column    one component for all blocks. A component that no word moves stays a single number (a 0-d array).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Number, say
from freecad_fiveaxis.core.machine.kinematics import Chain

ROUNDED_TO_ZERO = 4e-16
"""A product of unit vectors below this is rounding of a zero; a zero costs no arithmetic."""

PARALLEL = 1e-12
"""The sine below which two unit vectors are one direction: what is left of it is rounding."""

FARTHEST_WORD = 1e6
"""mm or deg: a kilometre, or 2777 turns. Beyond this a word is a mistake."""

Columns = tuple[Floats, ...]
Vectors = tuple[Floats, Floats, Floats]
"""Columns x, y, z."""


@dataclass(frozen=True, eq=False)
class Frames:
    """The chain's constants in its two rotary frames.

    ``first`` (3, 3): rows are the first frame's axes in the work frame; ``mix`` (3, 3) takes the second
    frame's components to the first frame; ``tool`` (3,) is the tool axis in the second frame with both rotary
    words zero; the nine components of the arm are ``offset`` (9,) + ``gain`` (9, 3) @ (X, Y, Z), mm.
    """

    first: Floats
    mix: Floats
    tool: Floats
    gain: Floats
    offset: Floats


@dataclass(frozen=True, eq=False)
class Pose:
    """The chain at some words. ``arm``: nine columns, mm; cosines and sines of the two rotary words."""

    arm: Columns
    cos_a: Floats
    sin_a: Floats
    cos_b: Floats
    sin_b: Floats


@dataclass(frozen=True, eq=False)
class Motion:
    """Blocks: the ``start`` words' arm and angles, and what each gains from u = 0 to u = 1."""

    arm: Columns
    arm_step: Columns
    a: Floats
    a_step: Floats
    b: Floats
    b_step: Floats

    def take(self, rows: Any) -> Motion:
        """Return the motion of some blocks, by index or slice; an index may come more than once."""

        def pick(column: Floats) -> Floats:
            return np.asarray(column[rows]) if column.ndim else column

        arm, arm_step = tuple(map(pick, self.arm)), tuple(map(pick, self.arm_step))
        return Motion(arm, arm_step, pick(self.a), pick(self.a_step), pick(self.b), pick(self.b_step))


def frames(kinematics: Chain) -> Frames:
    """Return the chain's constants in its two rotary frames."""
    x, z = np.array((1.0, 0.0, 0.0)), np.array((0.0, 0.0, 1.0))
    first, second = _basis(kinematics.direction[3], x), _basis(kinematics.direction[4], z)
    gain = np.zeros((9, 3))
    for j, slot in enumerate(kinematics.slot):
        basis = second if slot == 2 else first
        gain[3 * slot : 3 * slot + 3, j] = basis @ kinematics.direction[j]
    offset = np.concatenate(
        [
            first @ kinematics.point1,
            first @ (kinematics.point2 - kinematics.point1),
            -(second @ kinematics.point2),
        ]
    )
    return Frames(
        first, _clean_values(first @ second.T), _clean_values(second @ z), _clean_values(gain), offset
    )


def _basis(z: Floats, hint: Floats) -> Floats:
    """Rows x, y, z of a right-handed frame about unit ``z``, its x as near to ``hint`` as can be, so that
    ``hint`` has no y in it however near to ``z`` it lies: :func:`axis` relies on that."""
    across = [v - (v @ z) * z for v in (hint, np.roll(hint, 1))]
    x = across[0] if np.linalg.norm(across[0]) > PARALLEL else across[1]
    x = x / np.linalg.norm(x)
    return _clean_values(np.stack([x, np.cross(z, x), z]))


def _clean_values(values: Floats) -> Floats:
    return np.where(np.abs(values) < ROUNDED_TO_ZERO, 0.0, values)


def combine(factors: Floats, columns: Sequence[Floats], constant: float = 0.0) -> Floats:
    """``constant`` plus the sum of factor x column, without the work for factors of zero and one."""
    total: Floats | None = None if constant == 0.0 else np.asarray(constant)
    for factor, column in zip(factors.tolist(), columns, strict=True):
        if factor == 0.0:
            continue
        term = column if factor == 1.0 else factor * column
        total = term if total is None else total + term
    return np.asarray(0.0) if total is None else total


def turn_vector(x: Floats, y: Floats, cos: Floats, sin: Floats) -> tuple[Floats, Floats]:
    """Return the vector (x, y) turned by the angle of ``cos``, ``sin``."""
    return cos * x - sin * y, sin * x + cos * y


def flat_length(x: Floats, y: Floats) -> Floats:
    """Return the length of (x, y): four times as fast as np.hypot, and no component here is near the ends of
    a float's range."""
    return np.asarray(np.sqrt(x * x + y * y))


def check_words(words: ArrayLike) -> Floats:
    """``words`` as floats (m, 5). Raises ProgramError for another shape, and for words that are no numbers or
    too large."""
    rows = np.asarray(words, float)
    if rows.ndim != 2 or rows.shape[1] != 5:
        raise ProgramError(
            say("words have shape {shape}; give one row of five words for each block", shape=rows.shape),
            rows.shape,
        )
    good = np.abs(rows) <= FARTHEST_WORD  # False for NaN
    if not good.all():
        row, word = (int(i) for i in np.argwhere(~good)[0])
        value = float(rows[row, word])
        raise ProgramError(
            say(
                "word {word} of row {row} is {value}; words are numbers up to {farthest_word} mm or "
                "degrees: correct it, or the unit of the file",
                word=word + 1,
                row=row,
                value=Number(value),
                farthest_word=Number(FARTHEST_WORD, ".0f"),
            ),
            value,
        )
    return rows


def motion(frame: Frames, start: Floats, end: Floats) -> Motion:
    """Return the blocks that lead from words ``start`` to words ``end``, both (m, 5), mm and **degrees**."""
    arm, a, b = _arm(frame, start)
    end_arm, end_a, end_b = _arm(frame, end)
    return Motion(arm, tuple(q - p for p, q in zip(arm, end_arm, strict=True)), a, end_a - a, b, end_b - b)


def _arm(frame: Frames, words: Floats) -> tuple[Columns, Floats, Floats]:
    x, y, z, a, b = (np.ascontiguousarray(words[:, j]) for j in range(5))
    arm = tuple(combine(frame.gain[i], (x, y, z), float(frame.offset[i])) for i in range(9))
    return arm, np.deg2rad(a), np.deg2rad(b)


def chain_motion(frame: Frames, words: Floats) -> tuple[Motion, Pose]:
    """Return the m - 1 blocks between successive rows of words (m, 5), mm and **degrees**; and the poses of
    all rows."""
    arm, a, b = _arm(frame, words)
    step = tuple(np.diff(p) if p.ndim else np.asarray(0.0) for p in arm)
    start = tuple(p[:-1] if p.ndim else p for p in arm)
    move = Motion(start, step, a[:-1], np.diff(a), b[:-1], np.diff(b))
    return move, Pose(arm, np.cos(a), np.sin(a), np.cos(b), np.sin(b))


def at(move: Motion, u: Floats) -> Pose:
    """Return the poses at ``u``, which is of the columns' shape or broadcasts with it."""
    arm = tuple(p if p.ndim == 0 else p + u * step for p, step in zip(move.arm, move.arm_step, strict=True))
    a, b = move.a + u * move.a_step, move.b + u * move.b_step
    return Pose(arm, np.cos(a), np.sin(a), np.cos(b), np.sin(b))


def inner(frame: Frames, at_: Pose) -> Vectors:
    """``y = w + R2(b) v``: the tip as seen from the first rotary axis before it turns; columns of the first
    frame."""
    _, _, _, wx, wy, wz, vx, vy, vz = at_.arm
    x, y = turn_vector(vx, vy, at_.cos_b, at_.sin_b)
    return (
        wx + combine(frame.mix[0], (x, y, vz)),
        wy + combine(frame.mix[1], (x, y, vz)),
        wz + combine(frame.mix[2], (x, y, vz)),
    )


def outer(at_: Pose, y: Vectors) -> Vectors:
    """``tip = s + R1(a) y``: columns of the first frame."""
    sx, sy, sz, *_ = at_.arm
    px, py = turn_vector(y[0], y[1], at_.cos_a, at_.sin_a)
    return sx + px, sy + py, sz + y[2]


def tip(frame: Frames, at_: Pose) -> Vectors:
    """Return the tip, columns of the first frame, mm."""
    return outer(at_, inner(frame, at_))


def axis(frame: Frames, at_: Pose) -> Vectors:
    """Return the unit tool axis, columns of the first frame."""
    tx, tz = (
        float(frame.tool[0]),
        np.asarray(frame.tool[2]),
    )  # the second frame's x is chosen so that tool[1] is zero
    columns = (tx * at_.cos_b, tx * at_.sin_b, tz)
    x, y, z = (combine(row, columns) for row in frame.mix)
    return (*turn_vector(x, y, at_.cos_a, at_.sin_a), z)


def to_work(frame: Frames, vector: Vectors) -> Vectors:
    """Columns of the first frame as columns of the work frame."""
    x, y, z = (combine(column, vector) for column in frame.first.T)
    return x, y, z


def derivatives(frame: Frames, move: Motion, u: Floats) -> tuple[Vectors, Vectors, Vectors]:
    """Return the tip and its first and second derivative by u, columns of the first frame, mm. ``u`` has the
    columns' shape.

    With ``J`` the quarter turn about an axis and ``'`` the derivative by u (w, v, s, a, b are linear in u):
    ``y' = w' + R2 (v' + b' J v)``, ``y'' = R2 (2 b' J v' - b'^2 v_across)``, and the same once more about the
    first axis: ``p' = s' + R1 (y' + a' J y)``, ``p'' = R1 (y'' + 2 a' J y' - a'^2 y_across)``.
    """
    now = at(move, u)
    ds, dw, dv = move.arm_step[0:3], move.arm_step[3:6], move.arm_step[6:9]
    v, da, db = now.arm[6:9], move.a_step, move.b_step
    first_v = (dv[0] - db * v[1], dv[1] + db * v[0], dv[2])
    second_v = (-2.0 * db * dv[1] - db * db * v[0], 2.0 * db * dv[0] - db * db * v[1])
    y = inner(frame, now)
    dy = _turn_into_frame(frame, first_v, now)
    dy = (dw[0] + dy[0], dw[1] + dy[1], dw[2] + dy[2])
    ddy = _turn_into_frame(frame, (*second_v, np.asarray(0.0)), now)
    dp = turn_vector(dy[0] - da * y[1], dy[1] + da * y[0], now.cos_a, now.sin_a)
    ddp = turn_vector(
        ddy[0] - 2.0 * da * dy[1] - da * da * y[0],
        ddy[1] + 2.0 * da * dy[0] - da * da * y[1],
        now.cos_a,
        now.sin_a,
    )
    return outer(now, y), (ds[0] + dp[0], ds[1] + dp[1], ds[2] + dy[2]), (*ddp, ddy[2])


def _turn_into_frame(frame: Frames, v: Vectors, now: Pose) -> Vectors:
    """``R2 v`` in the first frame."""
    x, y = turn_vector(v[0], v[1], now.cos_b, now.sin_b)
    mx, my, mz = (combine(row, (x, y, v[2])) for row in frame.mix)
    return mx, my, mz


def axis_motion(frame: Frames, move: Motion) -> Motion:
    """Return the motion whose tip is the tool axis: no lever but the tool's unit vector, the same two
    turns."""
    arm = tuple(np.asarray(value) for value in (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, *frame.tool))
    return Motion(arm, (np.asarray(0.0),) * 9, move.a, move.a_step, move.b, move.b_step)


# ------------------------------------------------------------------------------------------ rows in, rows out


def tip_at(kinematics: Chain, start: ArrayLike, end: ArrayLike, u: ArrayLike) -> Floats:
    """Return the real tip, work frame, mm: (m, 3) for ``u`` (m,) or a number, (m, k, 3) for ``u`` (m, k) or
    (1, k).

    ``start``, ``end`` (m, 5): the words at u = 0 and u = 1, mm and **degrees**.
    """
    frame = frames(kinematics)
    move, at_u = _broadcast(frame, start, end, u)
    return _rows(to_work(frame, tip(frame, at(move, at_u))), move, at_u)


def axis_at(kinematics: Chain, start: ArrayLike, end: ArrayLike, u: ArrayLike) -> Floats:
    """Return the real unit tool axis, work frame; shapes as in :func:`tip_at`."""
    frame = frames(kinematics)
    move, at_u = _broadcast(frame, start, end, u)
    return _rows(to_work(frame, axis(frame, at(move, at_u))), move, at_u)


def tip_derivatives_at(
    kinematics: Chain, start: ArrayLike, end: ArrayLike, u: ArrayLike
) -> tuple[Floats, Floats, Floats]:
    """Return the real tip and its first and second derivative by u, work frame, mm; shapes as in
    :func:`tip_at`."""
    frame = frames(kinematics)
    move, at_u = _broadcast(frame, start, end, u)
    p, first, second = (_rows(to_work(frame, v), move, at_u) for v in derivatives(frame, move, at_u))
    return p, first, second


def _broadcast(frame: Frames, start: ArrayLike, end: ArrayLike, u: ArrayLike) -> tuple[Motion, Floats]:
    first, last, at_u = np.asarray(start, float), np.asarray(end, float), np.asarray(u, float)
    move = motion(frame, first, last)
    return (move.take((slice(None), None)) if at_u.ndim == 2 else move), at_u


def _rows(vector: Vectors, move: Motion, u: Floats) -> Floats:
    shape = np.broadcast_shapes(move.a.shape, u.shape)
    return np.stack([np.broadcast_to(column, shape) for column in vector], axis=-1)
