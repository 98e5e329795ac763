# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proven bounds: never below the truth, in extended precision too, and not far above it."""

from __future__ import annotations

import numpy as np
import pytest
from five_kinds import KINDS, interleaved, kinematics_of, random_blocks, sampled_deviation

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.machine.kinematics import forward, linear_words, words_to_q
from freecad_fiveaxis.core.motion.deviation import measure, quick_bound
from freecad_fiveaxis.core.motion.deviation.bound import (
    ABSOLUTE,
    RELATIVE,
    bending,
    close_levers,
    end_levers,
    quick_levers,
)
from freecad_fiveaxis.core.motion.deviation.quartic import POINT, REMAINDER
from freecad_fiveaxis.core.motion.deviation.search import (
    FIRST_PIECES,
    Chords,
    _compute_limit,
    _local,
    _Pieces,
    farthest,
)
from freecad_fiveaxis.core.motion.trajectory import at, derivatives, frames, inner, motion, tip, tip_at

STEPS = 16
LONG = np.longdouble
PI = LONG("3.14159265358979323846264338327950288")


@pytest.fixture(params=KINDS)
def kinematics(request):
    return kinematics_of(request.param)


def all_levers(kinematics, start, end):
    frame = frames(kinematics)
    move = motion(frame, start, end)
    ends = [inner(frame, at(move, np.full(len(start), u))) for u in (0.0, 1.0)]
    return [
        quick_levers(move),
        end_levers(move, *(np.hypot(y[0], y[1]) for y in ends)),
        close_levers(frame, move),
    ]


def sampled_bending(kinematics, start, end, order):
    """Largest difference quotient of the path: a mean of the derivative, so never above its largest value."""
    path = tip_at(kinematics, start, end, np.linspace(0, 1, STEPS + 1)[None])
    return np.linalg.norm(np.diff(path, order, axis=1), axis=2).max(axis=1) * STEPS**order


@pytest.mark.parametrize("order", [2, 3, 5])
def test_no_derivative_exceeds_its_bound(kinematics, order):
    start, end = random_blocks(kinematics, 400, 21)
    seen = sampled_bending(kinematics, start, end, order)
    rounding = 1e-12 * (2 * STEPS) ** order
    for levers in all_levers(kinematics, start, end):
        assert (bending(levers, order) + rounding >= seen).all()
    assert (0.5 * bending(levers, order) + rounding < seen).any()  # the comparison can fail


def test_closer_levers_bound_the_bending_more_closely(kinematics):
    start, end = random_blocks(kinematics, 400, 22)
    quick, ends, close = (bending(levers, 2) for levers in all_levers(kinematics, start, end))
    assert (close <= quick * (1 + 1e-12)).all()
    assert (close <= ends * (1 + 1e-12)).all()
    seen = sampled_bending(kinematics, start, end, 2)
    turned = seen > 1e-3
    assert np.median(close[turned] / seen[turned]) < 2.5  # up to 3 where the linear axes make up for the turn


def test_quick_bound_is_never_below_the_deviation(kinematics):
    start, end = random_blocks(kinematics, 500, 23)
    words = interleaved(start, end)
    bound = quick_bound(kinematics, words)
    assert bound.shape == (1000,)
    assert bound[0] == 0.0
    assert (bound[1::2] >= sampled_deviation(kinematics, start, end, 301)[0]).all()
    assert (bound >= measure(kinematics, words).segment * (1 - 1e-12)).all()


def test_quick_bound_needs_no_blocks(kinematics):
    assert quick_bound(kinematics, np.zeros((0, 5))).shape == (0,)
    assert quick_bound(kinematics, np.zeros((1, 5))).tolist() == [0.0]


def test_quick_bound_refuses_words_that_are_no_numbers(kinematics):
    with pytest.raises(
        ProgramError, match=r"word 1 of row 1 is nan; .* up to 1000000 mm or degrees: correct it"
    ):
        quick_bound(kinematics, [[0.0] * 5, [np.nan] * 5])


def test_bound_is_as_close_as_promised(kinematics):
    found = measure(kinematics, interleaved(*random_blocks(kinematics, 1000, 24)))
    assert (found.bound >= found.segment).all()
    assert (found.bound <= found.segment + np.maximum(1e-6, 1e-5 * found.segment)).all()


# ----------------------------------------------------------------------------------------- extended precision


def long_turn(vector, axis, angle):
    axis = np.array(axis, LONG)
    axis = axis / np.sqrt((axis**2).sum())
    along = (vector @ axis)[..., None] * axis
    cos, sin = np.cos(angle)[..., None], np.sin(angle)[..., None]
    return along + cos * (vector - along) + sin * np.cross(np.broadcast_to(axis, vector.shape), vector)


def long_tip(kinematics, words):
    """The tip from the words alone, by the definition of the chain, in extended precision."""
    words, slots = words.astype(LONG), np.array(kinematics.slot)
    angle = words[..., 3:] * (PI / 180)
    sums = [
        words[..., :3] @ (kinematics.direction[:3] * (slots == slot)[:, None]).astype(LONG)
        for slot in range(3)
    ]
    c1, c2 = kinematics.point1.astype(LONG), kinematics.point2.astype(LONG)
    y = c2 + long_turn(sums[2] - c2, kinematics.direction[4], angle[..., 1])
    return sums[0] + c1 + long_turn(sums[1] + y - c1, kinematics.direction[3], angle[..., 0])


def long_deviation(kinematics, start, end, samples=400):
    u = np.linspace(0, 1, samples + 1).astype(LONG)[:, None]
    path = np.stack(
        [
            long_tip(kinematics, s.astype(LONG) + u * (e.astype(LONG) - s))
            for s, e in zip(start, end, strict=True)
        ]
    )
    off, chord = path - path[:, :1], path[:, -1:] - path[:, :1]
    share = np.clip((off * chord).sum(2) / np.maximum((chord**2).sum(2), LONG(1e-40)), 0, 1)
    return np.sqrt(((off - share[:, :, None] * chord) ** 2).sum(2)).max(axis=1)


@pytest.mark.parametrize("turn", [0.0, 1e-9, 1e-6, 1e-3, 1.0, 100.0])
def test_rounding_never_takes_the_bound_below_the_truth(kinematics, turn):
    """Blocks so small that the deviation is rounding, and such as turn much, at large coordinates and many
    turns."""
    rng = np.random.default_rng(25)
    start = rng.uniform(-1, 1, (30, 5)) * (2000, 2000, 2000, 36000, 3600)
    end = start + rng.normal(size=(30, 5)) * (turn, turn, turn, turn, turn)
    truth = long_deviation(kinematics, start, end)
    words = interleaved(start, end)
    assert (measure(kinematics, words).bound[1::2] >= truth).all()
    assert (quick_bound(kinematics, words)[1::2] >= truth).all()


# ------------------------------------------------------------------------------------- chords that are points


def blocks_with_chords_of(kinematics, length, count=20):
    """Turns of 5 to 30 deg of both axes whose ends are so many mm apart; and their real path in extended
    precision."""
    rng = np.random.default_rng(27)
    start = rng.uniform(-1, 1, (5 * count, 5)) * (500, 500, 500, 180, 90)
    end = start + rng.uniform(5, 30, (5 * count, 5)) * (0, 0, 0, 1, 1) * rng.choice((-1, 1), (5 * count, 5))
    way = rng.normal(size=(5 * count, 3))
    tips = forward(kinematics, words_to_q(start))[0] + length * way / np.linalg.norm(way, axis=1)[:, None]
    end[:, :3] = linear_words(kinematics, tips, words_to_q(end)[:, 3:])
    near = np.flatnonzero(np.abs(end[:, :3]).max(axis=1) < 3000.0)[:count]
    u = np.linspace(0, 1, 1001).astype(LONG)[:, None]
    path = [
        long_tip(kinematics, s.astype(LONG) + u * (e.astype(LONG) - s))
        for s, e in zip(start[near], end[near], strict=True)
    ]
    return start[near], end[near], np.stack(path), u


@pytest.mark.parametrize("length", [1e-11, 1e-9, 1e-7, 0.9 * POINT])
def test_a_chord_too_short_for_a_direction_is_measured_from_its_point_of_the_same_u(kinematics, length):
    """Its direction is rounding, and so were its line deviation: up to 0.1 mm of it at 1e-9 mm."""
    start, end, path, u = blocks_with_chords_of(kinematics, length)
    same_u = np.linalg.norm(
        (path - path[:, :1] - u * (path[:, -1:] - path[:, :1])).astype(float), axis=2
    ).max(axis=1)
    found = measure(kinematics, interleaved(start, end))
    for distance in (found.line[1::2], found.segment[1::2]):
        assert distance == pytest.approx(same_u, rel=1e-5, abs=1e-6)
    assert (found.bound[1::2] >= same_u).all() and same_u.min() > 0.1


@pytest.mark.parametrize("length", [1.1 * POINT, 1e-4])
def test_a_chord_just_long_enough_for_a_direction_has_the_line_deviation_of_extended_precision(
    kinematics, length
):
    start, end, path, _ = blocks_with_chords_of(kinematics, length)
    off, chord = path - path[:, :1], path[:, -1:] - path[:, :1]
    foot = (off * chord).sum(axis=2, keepdims=True) / (chord * chord).sum(axis=2, keepdims=True)
    line = np.sqrt(((off - foot * chord) ** 2).sum(axis=2)).astype(float).max(axis=1)
    assert measure(kinematics, interleaved(start, end)).line[1::2] == pytest.approx(line, rel=1e-5, abs=1e-6)


# --------------------------------------------------------------------------------------------- the two proofs


def test_a_quintic_leaves_its_quartic_by_the_remainder():
    u = np.linspace(0, 1, 100_001)
    product = np.abs(u * (u - 0.25) * (u - 0.5) * (u - 0.75) * (u - 1)).max() / 120
    assert product <= REMAINDER <= product * (1 + 1e-4)


@pytest.mark.parametrize("pieces", [FIRST_PIECES, 64])
def test_a_piece_never_exceeds_its_bound(kinematics, pieces):
    start, end = random_blocks(kinematics, 100, 26)
    frame = frames(kinematics)
    move = motion(frame, start, end)
    ends = [tip(frame, at(move, np.full(100, u))) for u in (0.0, 1.0)]
    vector = np.array(ends[1]) - np.array(ends[0])
    size = np.linalg.norm(vector, axis=0)
    along = tuple(vector * (size > 1e-9) / np.maximum(size, 1e-9))
    levers = close_levers(frame, move)
    chords = Chords(
        move, ends[0], along, np.zeros(100), size, bending(levers, 2), bending(levers, 3), levers.turn
    )
    half = np.full(100 * pieces, 0.5 / pieces)
    block = np.repeat(np.arange(100), pieces)
    centre = np.tile((np.arange(pieces) + 0.5) / pieces, 100)
    local = _local(frame, chords, _Pieces(block, centre, half))
    most = np.zeros(len(block))
    for shift in np.linspace(-1, 1, 21):
        p, _, _ = derivatives(frame, move.take(block), centre + shift * half)
        off = np.array(p) - np.array(ends[0])[:, block]
        foot = np.clip((off * np.array(along)[:, block]).sum(0), 0, size[block])
        most = np.maximum(most, ((off - foot * np.array(along)[:, block]) ** 2).sum(0))
    assert (most <= local.bound * (1 + 1e-9) + 1e-18).all()
    assert (most > 0.9 * local.bound).any()  # the comparison can fail
    distance, _, bound = farthest(frame, chords)
    assert (np.sqrt(np.maximum.reduceat(most, np.arange(0, len(block), pieces))) <= bound).all()
    assert bound == pytest.approx(_compute_limit(distance))
    assert (bound - distance <= ABSOLUTE + 1.01 * RELATIVE * distance).all()
