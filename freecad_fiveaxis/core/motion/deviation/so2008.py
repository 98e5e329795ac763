# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line deviation by the analytic model of So, Park, Cho, Kim, Song and Ko (2008), for comparison with the
exact one.

It is a model of blocks near the pole, where the first rotary axis turns much and the second little.

U, V      the rotary axis about the pole direction, and the other: in every chain U is the one nearer to the
          work. All is seen in the frame with U as z (``trajectory``: the first frame), so that U need not be
          the machine's Z.
G, M      eq. (2): the tip in the plane across U is ``G(u) + Rot(U) M(u)``. G is what the linear axes between
          work and U give (the arm ``s``), M what comes after U (the arm's ``y = w + R2(V) v``): table-table G
          constant, M by X Y Z and V; head-table with a linear axis on the table G by that one, M by the rest;
          head-head G by X Y Z, M by V alone. The model takes M as linear in u between its values at both
          ends; G is so.
k         the foot of the perpendicular from the U axis on the line M0 M1, as a share of the way from M0 to
          M1: the apex.

Eq. (3) in polar form, ``r (cos theta, sin theta)``, is ``Rot(U) (M0 + u (M1 - M0))`` written out; here it
stays Cartesian.
n(u)      the speed of the rotating part, eq. (7).

Two forms. ``so2008`` takes eq. (8) times n(u): the zeros are the same, but the quartic of eq. (9) is another
one, and only this one reproduces the paper's own example (Table 2): u = 0.40413 as the real maximum. Eq. (8)
as printed (``so2008-printed``) gives u = 0.4708 there, though it mostly is nearer on other blocks; the table
is in docs/deviation.md. Table 1 is silent where its samples leave the block or meet its ends: so2008 limits h
there, so2008-printed does not.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.base.vectors import dot
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.trajectory import (
    Frames,
    Motion,
    Pose,
    Vectors,
    at,
    chain_motion,
    frames,
    inner,
    outer,
    tip,
    to_work,
)

from .bound import CHUNK
from .quartic import POINT, SMALLEST

SYMMETRIC = 1e-3
"""Table 1's "k about 0.5": nearer than this the samples about 0.5 nearly coincide and u = 0.5 is taken, as
there."""

MOST_H = 0.2
"""Largest h of Table 1: at 0.25 the sample 0.5 +- 2h is an end of the block and eq. (9) has no solution."""

APART, MOST_PRINTED = 1e-3, 1e3
"""As printed h is any number, but so far from 0.25 and 0.5, where a sample is an end of the block, and no
larger: the fourth power of 2h would leave no digits."""

STRAIGHT = 1e-12
"""mm per unit of u, of each mm of radius: a cross product below this is rounding; the model's path is then
straight."""

FLAT_LEAD = 1e-9
"""A leading coefficient of eq. (9) below this share of the largest is raised to it: that moves roots within a
block by 1e-9 and gives the companion matrix of a cubic a far root instead of an infinite one."""

REAL = 1e-7
"""Largest imaginary part of a real root: a double root, the worst case, is split by the root of the
rounding."""


def line_deviation(
    kinematics: Chain, words: Floats, printed: bool = False, progress: Progress = silent
) -> tuple[Floats, Floats, tuple[Finding, ...]]:
    """Return the largest distance (m,) mm from the infinite line by the model, and its u; row 0 zero.

    ``words`` (m, 5) mm and **degrees**; ``printed``: eq. (8) and Table 1 to the letter. u is the model's
    (eqs. 7 to 9), the distance that of the real tip at this u (eq. 6). Where the quartic has several roots
    within the block, the one with the largest distance counts; where it has none, u is 0.5 and a finding says
    of how many blocks this is so.
    """
    frame, count = frames(kinematics), len(words)
    line, u_line, rootless = np.zeros(count), np.zeros(count), 0
    for first in range(0, count - 1, CHUNK):
        last = min(first + CHUNK, count - 1)
        move, poses = chain_motion(frame, words[first : last + 1])
        candidates, valid = _candidates(frame, move, poses, printed)
        line[first + 1 : last + 1], u_line[first + 1 : last + 1] = _farthest(
            frame, move, poses, candidates, valid
        )
        rootless += int(np.count_nonzero(~valid.any(axis=0)))
        progress("deviation by So et al.", last / count)
    return line, u_line, _rootless_finding(rootless, count - 1)


def model_tip(kinematics: Chain, words: Floats, u: Floats) -> Floats:
    """Eq. (3) at ``u`` (k,) of every block: (m - 1, k, 3) mm, work frame. ``words`` (m, 5) mm and
    **degrees**."""
    frame = frames(kinematics)
    move, poses = chain_motion(frame, words)
    m0, slope, z = _linear_inner(inner(frame, poses))
    s = [p[:, None] + u * step[:, None] for p, step in zip(*_wide(move), strict=True)]
    flat = np.exp(1j * (move.a[:, None] + u * move.a_step[:, None])) * (m0[:, None] + u * slope[:, None])
    height = z[:-1, None] + u * np.diff(z)[:, None]
    return np.stack(to_work(frame, (s[0] + flat.real, s[1] + flat.imag, s[2] + height)), axis=-1)


def _wide(move: Motion) -> tuple[list[Floats], list[Floats]]:
    """Return the arm ``s`` and its step with every column of full length."""
    shape = move.a.shape
    return [np.broadcast_to(p, shape) for p in move.arm[:3]], [
        np.broadcast_to(p, shape) for p in move.arm_step[:3]
    ]


def _linear_inner(y: Vectors) -> tuple[Floats, Floats, Floats]:
    """M0 and M1 - M0 of every block, x + iy; and the height z of every row."""
    flat = y[0] + 1j * y[1]
    return flat[:-1], np.diff(flat), y[2]


def _candidates(frame: Frames, move: Motion, poses: Pose, printed: bool) -> tuple[Floats, Bools]:
    """u (4, n) where the model's path may be farthest, and which of them are roots within the block."""
    m0, slope, _ = _linear_inner(inner(frame, poses))
    square = np.abs(slope) ** 2
    still = square <= STRAIGHT**2 * np.abs(m0) ** 2  # a circle about U: the farthest point is in the middle
    k = np.where(still, 0.5, -(m0 * slope.conj()).real / np.where(still, 1.0, square))
    u = _samples(k, printed)
    f, scale = _eq_8(move, poses, frame, m0, slope, u)
    middle = (np.abs(k - 0.5) < SYMMETRIC) | (np.abs(f).max(axis=0) <= STRAIGHT * scale)
    if printed:
        f = f / np.maximum(np.abs(slope + 1j * move.a_step * (m0 + u * slope)), STRAIGHT * scale + SMALLEST)
    roots = _quartic_roots(u, np.where(middle, 1.0, f))
    valid = (np.abs(roots.imag) <= REAL) & (roots.real >= 0.0) & (roots.real <= 1.0) & ~middle
    valid[0] |= middle
    return np.where(valid & ~middle, roots.real, 0.5), valid


def _samples(k: Floats, printed: bool = False) -> Floats:
    """Table 1: the five u (5, n), with h = |0.5 - k| no larger than :data:`MOST_H` and no smaller than
    :data:`SYMMETRIC`; or, as printed, any h but where two of them coincide."""
    h = np.clip(np.abs(0.5 - k), SYMMETRIC, MOST_PRINTED if printed else MOST_H)
    for end in (0.25, 0.5):
        h = np.where(np.abs(h - end) < APART, end - APART, h)
    low, high = np.zeros_like(h), np.ones_like(h)
    below = np.stack([low, 0.5 - 2.0 * h, 0.5 - h, low + 0.5, high])
    above = np.stack([low, low + 0.5, 0.5 + h, 0.5 + 2.0 * h, high])
    return np.where(k < 0.5, below, above)


def _eq_8(
    move: Motion, poses: Pose, frame: Frames, m0: Floats, slope: Floats, u: Floats
) -> tuple[Floats, Floats]:
    """Eq. (8) times n(u) at ``u`` (5, n): how fast the model's path leaves the direction of the chord, seen
    along U, mm.

    ``G' + d/du Rot(U) M = G' + Rot(U) (M' + U' J M)``. Also the size (n,) that its rounding is relative to.
    """
    x, y, _ = tip(frame, poses)
    chord = np.diff(x) + 1j * np.diff(y)
    length = np.abs(chord)
    g = move.arm_step[0] + 1j * move.arm_step[1]
    turning = np.exp(1j * (move.a + u * move.a_step)) * (slope + 1j * move.a_step * (m0 + u * slope))
    size = np.abs(m0) + np.abs(slope) + np.abs(g)
    direction = np.where(length > POINT, chord, 0.0) / np.maximum(length, POINT)
    return (direction.conj() * (g + turning)).imag, size


def _quartic_roots(u: Floats, f: Floats) -> Floats:
    """Return the four roots (4, n) of the quartic through ``f`` at ``u``, both (5, n): eq. (9), as
    eigenvalues of the companion."""
    powers = u.T[:, :, None] ** np.arange(4, -1, -1)
    c = np.linalg.solve(powers, f.T[:, :, None])[:, :, 0]
    least = FLAT_LEAD * np.abs(c).max(axis=1)
    c[:, 0] = np.where(np.abs(c[:, 0]) < least, np.copysign(least, c[:, 0]), c[:, 0])
    companion = np.zeros((len(c), 4, 4))
    companion[:, 0] = -c[:, 1:] / c[:, :1]
    companion[:, (1, 2, 3), (0, 1, 2)] = 1.0
    return np.asarray(np.linalg.eigvals(companion).T)


def _farthest(frame: Frames, move: Motion, poses: Pose, u: Floats, valid: Bools) -> tuple[Floats, Floats]:
    """Return the largest distance (eq. 6) of the real tip at the candidates from the line through the chord,
    and its u."""
    start = outer(poses, inner(frame, poses))
    vector = tuple(np.diff(p) for p in start)
    square = dot((vector[0], vector[1], vector[2]), (vector[0], vector[1], vector[2]))
    x, y, z = (p - q[:-1] for p, q in zip(tip(frame, at(move, u)), start, strict=True))
    foot = (x * vector[0] + y * vector[1] + z * vector[2]) / np.maximum(square, POINT**2)
    share = np.where(square > POINT**2, foot, u)
    across = (x - share * vector[0], y - share * vector[1], z - share * vector[2])
    distance = np.where(valid, np.sqrt(dot(across, across)), -1.0)
    distance[0] = np.where(valid.any(axis=0), distance[0], np.sqrt(dot(across, across))[0])
    best = distance.argmax(axis=0)[None]
    return np.take_along_axis(distance, best, 0)[0], np.take_along_axis(u, best, 0)[0]


def _rootless_finding(rootless: int, blocks: int) -> tuple[Finding, ...]:
    if not rootless:
        return ()
    text = say(
        "The model of So et al. finds no farthest point in {rootless} of {blocks} blocks and takes the middle"
        " there; use the exact line deviation.",
        rootless=rootless,
        blocks=blocks,
    )
    return (report_finding(Code.SO2008_NO_ROOT, text, float(rootless), 0.0),)
