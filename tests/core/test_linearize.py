# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divided blocks: as few as can be, proven, sampled densely, on every kind of chain, at the pole, and where
it cannot be done."""

from __future__ import annotations

import math
import os
from dataclasses import replace

import numpy as np
import pytest
from five_kinds import (
    KINDS,
    TABLE_2,
    interleaved,
    kinematics_of,
    mikron_links,
    random_blocks,
    sampled_deviation,
)
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import Cancelled, ProgramError, SettingsError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import (
    Setup,
    chain,
    forward,
    joint_words,
    q_to_words,
    words_to_q,
)
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.motion.joint_path import solve
from freecad_fiveaxis.core.motion.linearize import linearize, linearize_words
from freecad_fiveaxis.core.motion.linearize.balance import balance_shares
from freecad_fiveaxis.core.motion.linearize.commanded_moves import (
    Steps,
    compute_commanded_moves,
    follow,
    most_off,
)
from freecad_fiveaxis.core.motion.linearize.proof import judge_pieces, off_segment
from freecad_fiveaxis.core.motion.program import build_program
from freecad_fiveaxis.core.motion.trajectory import frames, tip_at
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

BLOCKS = int(os.environ.get("LINEARIZE_BLOCKS", "80"))
"""Random blocks of each kind of chain; 2000 for the full run."""
U = np.linspace(0.0, 1.0, 2001)


def rounded_blocks(kinematics, count, seed):
    start, end = random_blocks(kinematics, count, seed)
    return np.round(start, 4), np.round(end, 4)


def divided(kinematics, start, end, tolerance, decimals=4):
    """Words of all pieces, for each the row it ends in, the number of the block it is of, and findings."""
    feeds = np.arange(2 * len(start)) % 2 == 1
    words, row, findings = linearize_words(
        kinematics, interleaved(start, end), (decimals, decimals), tolerance, feeds
    )
    piece = np.flatnonzero(row % 2 == 1)
    return words, piece, row[piece] // 2, findings


def from_segment(points, start, end):
    """The largest distance (m,) of points (m, k, 3) from segments (m, 3) to (m, 3)."""
    way, chord = points - start[:, None], (end - start)[:, None]
    share = np.clip((way * chord).sum(2) / np.maximum((chord**2).sum(2), 1e-30), 0.0, 1.0)
    return np.linalg.norm(way - share[:, :, None] * chord, axis=2).max(1)


def sampled(kinematics, words, piece, start, end, block, u=U):
    """The largest distance (p,) of the real path of each piece from the commanded segment of its block, by
    dense sampling."""
    p0, p1 = (forward(kinematics, words_to_q(w))[0] for w in (start, end))
    parts = np.array_split(np.arange(len(piece)), max(1, len(piece) * len(u) // 400_000))
    return np.concatenate(
        [
            from_segment(
                tip_at(kinematics, words[piece[p] - 1], words[piece[p]], u[None]), p0[block[p]], p1[block[p]]
            )
            for p in parts
        ]
    )


def course_of(kinematics, start, end):
    words = interleaved(start, end)
    q = words_to_q(words)
    return compute_commanded_moves(
        kinematics, forward(kinematics, q)[0], q[:, 3:], words, np.arange(1, len(words), 2)
    )


def holds(kinematics, way, block, low, high, tolerance, steps):
    """Whether pieces are proven to hold: what ``linearize`` asks of them, at given ends."""
    at = np.repeat(block, 2)
    words = follow(kinematics, way, at, np.stack([low, high], 1).ravel(), steps)
    off = off_segment(frames(kinematics), words, way.tip[at], way.chord[at])
    inside = np.arange(len(words) - 1) % 2 == 0
    judged = judge_pieces(frames(kinematics), words, inside, off, np.full(len(inside), tolerance))
    return (judged.most + judged.off <= tolerance)[::2]


def bisected(kinematics, start, end, tolerance, steps, most):
    """How many pieces (b,) halving at midpoints takes; 0 where that is over ``most`` (b,)."""
    way, count = course_of(kinematics, start, end), np.zeros(len(start), np.int64)
    block, low, high = np.arange(len(start)), np.zeros(len(start)), np.ones(len(start))
    for _ in range(50):
        good = holds(kinematics, way, block, low, high, tolerance, steps)
        count += np.bincount(block[good], minlength=len(count))
        going = ~good & (count + np.bincount(block, minlength=len(count)) <= most)[block]
        count[block[~good & ~going]] = 2 * most.max()
        block, low, high, middle = block[going], low[going], high[going], 0.5 * (low + high)[going]
        block, low, high = np.tile(block, 2), np.append(low, middle), np.append(middle, high)
        if not len(block):
            return np.where(count <= most, count, 0)
    raise AssertionError("halving came to no end")


def longest_steps(kinematics, start, end, tolerance, steps, most=400):
    """How many pieces (b,) the longest step that holds takes, one after the other, each found by halving."""
    way, count, low = course_of(kinematics, start, end), np.zeros(len(start), np.int64), np.zeros(len(start))
    block = np.arange(len(start))
    for _ in range(most):
        good, bad = low[block], np.ones(len(block))
        whole = holds(kinematics, way, block, low[block], bad, tolerance, steps)
        for _ in range(24):
            middle = 0.5 * (good + bad)
            fits = holds(kinematics, way, block, low[block], middle, tolerance, steps)
            good, bad = np.where(fits, middle, good), np.where(fits, bad, middle)
        low[block] = np.where(whole, 1.0, good)
        count[block] += 1
        block = block[~whole]
        if not len(block):
            return count
    raise AssertionError("the longest steps came to no end")


# ------------------------------------------------------------------------------------------------ Table 2


@pytest.mark.parametrize(
    ("tolerance", "decimals", "most", "halving"),
    [(0.1, 4, 4, 4), (0.05, 4, 5, 7), (0.01, 4, 10, 16), (0.001, 4, 40, None), (0.001, 7, 31, 32)],
)
def test_table_2_takes_as_few_blocks_as_is_requested_and_all_are_proven(tolerance, decimals, most, halving):
    kinematics, start, end = mikron_links(), TABLE_2[:1], TABLE_2[1:]
    words, row, findings = linearize_words(kinematics, TABLE_2, (decimals, decimals), tolerance)
    assert len(words) - 1 <= most
    assert (words[0] == TABLE_2[0]).all()
    assert (words[-1] == TABLE_2[1]).all()
    assert row.tolist() == [0] + [1] * (len(words) - 1)
    assert np.abs(words - np.round(words, decimals)).max() < 1e-12
    assert measure(kinematics, words).bound.max() <= tolerance
    piece = np.arange(1, len(words))
    assert sampled(kinematics, words, piece, start, end, piece * 0).max() <= tolerance
    assert [finding.code for finding in findings] == ["linearized"]
    if halving:
        assert bisected(
            kinematics, start, end, tolerance, Steps(decimals, decimals), np.array([99])
        ).tolist() == [halving]


def test_the_undivided_block_and_one_piece_less_are_over_tolerance():
    """The comparisons above can fail."""
    kinematics, start, end = mikron_links(), TABLE_2[:1], TABLE_2[1:]
    assert sampled(kinematics, TABLE_2, np.array([1]), start, end, np.array([0])).max() > 2.0
    way = course_of(kinematics, start, end)
    for share in (np.linspace(0, 1, 10), np.linspace(0, 1, 10) ** 1.2):
        assert not holds(
            kinematics, way, np.zeros(9, np.int64), share[:-1], share[1:], 0.01, Steps(4, 4)
        ).all()


def test_linear_words_make_up_for_the_rounding_of_the_rotary_words():
    kinematics = mikron_links()
    words, _, _ = linearize_words(kinematics, TABLE_2, (4, 2), 0.01)  # 0.01 deg at 140 mm is 0.024 mm
    assert measure(kinematics, words).bound.max() <= 0.01
    tips = forward(kinematics, words_to_q(words))[0][1:-1]
    p0, p1 = forward(kinematics, words_to_q(TABLE_2))[0]
    assert from_segment(tips[None], p0[None], p1[None])[0] <= most_off(kinematics, Steps(4, 2)) + 1e-9
    assert most_off(kinematics, Steps(4, 2)) == pytest.approx(0.5e-4 * math.sqrt(3.0))


# ---------------------------------------------------------------------------------------- every kind of chain


@pytest.mark.thorough
@pytest.mark.parametrize("kind", KINDS)
def test_random_blocks_hold_and_never_take_more_pieces_than_halving(kind):
    kinematics = kinematics_of(kind)
    start, end = rounded_blocks(kinematics, BLOCKS, 61)
    words, piece, block, findings = divided(kinematics, start, end, 0.01)
    assert "linearize-rounding" not in {finding.code for finding in findings}
    count = np.bincount(block, minlength=len(start))
    found = measure(kinematics, words)
    whole = (count == 1) & (sampled_deviation(kinematics, start, end, 301)[0] > 0.01)
    assert not whole.any() or kind == "linear_axes_everywhere"
    assert whole.sum() == sum(finding.value for finding in findings if finding.code == "linearize-impossible")
    held = ~whole[block]
    assert found.bound[piece[held]].max() <= 0.01
    assert (
        sampled(
            kinematics, words, piece[held], start, end, block[held], U[:: 1 if BLOCKS > 1000 else 20]
        ).max()
        <= 0.01
    )
    halving = bisected(kinematics, start, end, 0.01, Steps(4, 4), np.full(len(start), 4 * count.max()))
    assert (count <= halving)[halving > 0].all()
    assert (halving > 0)[~whole].mean() > 0.95
    many = halving > 4
    assert np.median(count[many] / halving[many]) <= 0.8
    first, last = (
        words[piece[np.flatnonzero(np.diff(block, prepend=-1))] - 1],
        words[piece[np.diff(block, append=-1) != 0]],
    )
    assert (first == start).all() and (last == end).all()  # the whole rotary change is kept


@pytest.mark.thorough
@some_in_core("kind", ["table_table", "nutating", "head_head"])
def test_no_block_takes_more_pieces_than_the_longest_steps_one_after_the_other(kind):
    kinematics = kinematics_of(kind)
    start, end = rounded_blocks(kinematics, 40, 62)
    few = measure(kinematics, interleaved(start, end)).segment[1::2] < 2.0
    start, end = start[few], end[few]
    _, _, block, _ = divided(kinematics, start, end, 0.01, 7)
    count, steps = np.bincount(block), longest_steps(kinematics, start, end, 0.01, Steps(7, 7))
    assert steps.max() > 5
    assert (count <= steps).all()


@pytest.mark.parametrize("kind", KINDS)
def test_the_axis_stays_on_the_great_arc_and_the_tip_on_the_chord(kind):
    kinematics = kinematics_of(kind)
    start, end = rounded_blocks(kinematics, 60, 63)
    words, piece, block, findings = divided(kinematics, start, end, 0.05)
    way = course_of(kinematics, start, end)
    inner = (words[piece] != end[block]).any(1) & ~way.even[block]
    tip, axis = forward(kinematics, words_to_q(words[piece[inner]]))
    at = block[inner]
    normal = np.cross(way.axis0[at], way.axis1[at])
    size = np.linalg.norm(normal, axis=1)
    aside = np.abs((axis * normal).sum(1))[size > 1e-3] / size[size > 1e-3]
    assert aside.max() < 2.0 * math.radians(1e-4)  # the rounding of two words
    assert (
        from_segment(tip[:, None], way.tip[at], way.tip[at] + way.chord[at]).max()
        < most_off(kinematics, Steps(4, 4)) + 1e-9
    )
    even = [finding.value for finding in findings if finding.code == "rotary-words-even"]
    assert inner.any()
    assert sum(even) <= way.even.sum() + (0 if kind != "linear_axes_everywhere" else len(start))


def test_halving_is_the_answer_where_it_is_the_fewest():
    """One rotary axis, an even course: 2^n pieces that just hold are the fewest, and rounding must not make
    it one more."""
    kinematics = kinematics_of("table_table")
    start = np.array([[100.0, 0.0, 50.0, 0.0, 30.0]])
    tip = forward(kinematics, words_to_q(start))[0]
    end = np.concatenate(
        [joint_words(kinematics, tip, np.radians([[40.0, 30.0]]))[:, :3], [[40.0, 30.0]]], axis=1
    )
    end = np.round(end, 4)
    way = course_of(kinematics, start, end)
    shares = np.linspace(0.0, 1.0, 17)
    words = follow(kinematics, way, np.zeros(17, np.int64), shares, Steps(4, 4))
    off = off_segment(frames(kinematics), words, np.repeat(way.tip, 17, 0), np.repeat(way.chord, 17, 0))
    judged = judge_pieces(frames(kinematics), words, np.ones(16, bool), off, np.full(16, 1.0))
    tolerance = float((judged.most + judged.off).max()) * (1.0 + 1e-9)
    assert len(divided(kinematics, start, end, tolerance)[1]) <= 16


# ------------------------------------------------------------------------------------------------ the pole


def trunnion_block(start_ca, end_ca, move):
    """Words of a block of the Table 2 machine from C, A to C, A in degrees while the tip moves by
    ``move``."""
    kinematics = mikron_links()
    tip = np.array([[20.0, 30.0, 40.0], [20.0, 30.0, 40.0]]) + np.array([[0.0, 0.0, 0.0], move])
    words = q_to_words(joint_words(kinematics, tip, np.radians([start_ca, end_ca])))
    return kinematics, np.round(words, 4)


@pytest.mark.parametrize(
    ("start", "end", "even"),
    [
        (
            (0.0, 0.0),
            (90.0, 5.0),
            0,
        ),  # leaves the pole in another direction than its word gives: a pure rotation first
        ((10.0, 5.0), (100.0, 0.0), 0),  # arrives at the pole, and turns there
        ((0.0, 10.0), (180.0, 10.0), 0),  # the great arc leads through the pole itself, on one branch
        ((0.0, 0.001), (120.0, 0.002), 0),  # passes close by
        ((0.0, 0.0), (170.0, 0.0), 1),  # both ends at the pole
        ((0.0, 10.0), (20.0, -10.0), 1),  # onto the other branch
        ((0.0, 10.0), (350.0, 10.0), 1),  # the longer way round
        ((0.0, 10.0), (720.0, 12.0), 1),  # two turns and back again
    ],
)
@pytest.mark.parametrize("move", [(0.0, 0.0, 0.0), (3.0, 1.0, 0.0)])
def test_blocks_at_the_pole_are_divided_and_keep_their_whole_rotary_change(start, end, even, move):
    kinematics, words = trunnion_block(start, end, move)
    found, _, findings = linearize_words(kinematics, words, (4, 4), 0.01)
    piece = np.arange(1, len(found))
    assert [f.code for f in findings] == ["linearized"] + ["rotary-words-even"] * even
    assert measure(kinematics, found).bound.max() <= 0.01
    assert sampled(kinematics, found, piece, words[:1], words[1:], piece * 0).max() <= 0.01
    assert (found[[0, -1]] == words).all()
    turn = np.abs(np.diff(found[:, 3]))
    assert abs(turn.sum() - abs(end[0] - start[0])) < 0.01  # no detour of C
    assert turn.max() < 30.0


@pytest.mark.parametrize(
    ("start", "end"),
    [
        ((19.9648, 50.5413, -6.0386, -141.3082, 39.1437), (17.0544, 12.6993, 16.0, -144.2947, 0.0)),
        ((23.6719, 41.0415, 4.4274, -113.9918, 22.5328), (26.2281, 12.7472, 16.0, -111.8642, 0.0)),
    ],
)
def test_a_block_whose_arc_cannot_be_held_turns_evenly_instead(start, end):
    """Its first word turns by some degrees at the pole, on a piece of the arc that is too short to divide:
    that was put down to the decimals of its words."""
    machine = load_machine("trunnion_ac")
    kinematics, words = chain(machine, Setup(machine.origin)), np.array([start, end])
    found, _, findings = linearize_words(kinematics, words, (4, 4), 0.005)
    assert [one.code for one in findings] == ["linearized", "rotary-words-even"]
    assert measure(kinematics, found).bound.max() <= 0.005


def test_a_block_that_only_turns_is_divided_evenly():
    kinematics, words = trunnion_block((0.0, 20.0), (60.0, 20.0), (0.0, 0.0, 0.0))
    found, _, _ = linearize_words(kinematics, words, (4, 4), 0.01)
    tips = forward(kinematics, words_to_q(found))[0]
    assert np.linalg.norm(tips - tips[0], axis=1).max() < 2e-4
    assert measure(kinematics, found).bound.max() <= 0.01


# ---------------------------------------------------------------------------------------- what cannot be done


@pytest.mark.parametrize("tolerance", [0.0, -1.0, math.nan, math.inf])
def test_a_tolerance_that_is_no_number_above_zero_is_refused(tolerance):
    with pytest.raises(SettingsError, match="tolerance is") as caught:
        linearize_words(mikron_links(), TABLE_2, (4, 4), tolerance)
    assert caught.value.value is tolerance


def test_words_that_are_no_numbers_are_refused():
    with pytest.raises(ProgramError, match="nan"):
        linearize_words(mikron_links(), np.full((2, 5), np.nan), (4, 4), 0.01)


@pytest.mark.parametrize(("tolerance", "decimals"), [(1e-5, 4), (1e-6, 4), (0.001, 2)])
def test_a_tolerance_below_the_rounding_is_stated_with_its_place_and_comes_to_an_end(tolerance, decimals):
    kinematics, words = mikron_links(), np.round(TABLE_2, decimals)
    found, _, findings = linearize_words(kinematics, words, (decimals, decimals), tolerance)
    finding = next(f for f in findings if f.code == "linearize-rounding")
    assert finding.severity == Severity.WARNING
    assert finding.limit == tolerance
    assert finding.block == len(found) - 1
    tip = forward(kinematics, words_to_q(found[-1:]))[0][0]
    assert np.allclose(finding.place, tip)
    assert tolerance < finding.value
    assert measure(kinematics, found).bound.max() <= finding.value  # what it says is held
    assert len(found) < 2000


def test_linear_axes_that_turn_into_one_plane_are_stated_and_the_block_is_left_whole():
    kinematics = kinematics_of("linear_axes_everywhere")
    words = np.array([[10.0, 20.0, 0.0, 60.0, 10.0], [30.0, -10.0, 5.0, 120.0, 20.0]])
    found, _, findings = linearize_words(kinematics, words, (4, 4), 0.01)
    assert [f.code for f in findings] == ["linearize-impossible"]
    assert findings[0].place is not None
    assert (found == words).all()


@pytest.mark.parametrize("rows", [0, 1])
def test_a_program_without_blocks_stays_as_it_is(rows):
    words, row, findings = linearize_words(mikron_links(), np.zeros((rows, 5)), (4, 4), 0.01)
    assert words.shape == (rows, 5)
    assert row.tolist() == list(range(rows))
    assert findings == ()


def test_a_straight_block_that_only_rounding_keeps_over_tolerance_is_not_divided_for_nothing():
    kinematics, steps = mikron_links(), (4, 4)
    words = np.array(
        [
            [10.0, 20.0, 30.0, 5.0, 7.0],
            [10.00004, 20.00004, 29.99996, 5.0, 7.0],
            [40.00004, 0.0, 0.0, 5.0, 7.0],
        ]
    )
    found, _, findings = linearize_words(kinematics, words, steps, 1e-5)
    assert len(found) == 3
    (finding,) = findings
    assert finding.code == "linearize-rounding"
    assert finding.value == pytest.approx(0.4e-4 * math.sqrt(3.0), rel=1e-3)
    assert finding.value <= most_off(kinematics, Steps(*steps))


# --------------------------------------------------------------------------------------- through the pipeline


def path_of(tip, axis, motion):
    tip, axis, motion = np.array(tip, float), np.array(axis, float), np.array(motion, np.int8)
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    cut = motion < Motion.LINK
    none, face = np.full(len(tip), -1), np.where(cut, np.arange(len(tip)), -1)
    feed = np.where(motion == Motion.RAPID, 0.0, 800.0 + np.arange(len(tip)))
    return CLPath(tip, axis, motion, feed, tip, axis, face, none, none)


def near_the_pole():
    """Joints of a trunnion: a rapid, a link that turns, cuts that pass the pole, and away again."""
    tip = [[0, 0, 60], [0, 0, 10], [5, 0, 10], [10, 1, 10], [15, 1, 10], [15, 1, 60], [-50, 30, 60]]
    axis = [[1, 1, 5], [1, 0, 5], [0.2, 0.1, 5], [0.0, -0.3, 5], [1, -1, 5], [1, -1, 5], [-1, 0, 5]]
    motion = [Motion.RAPID, Motion.LINK, Motion.CUT, Motion.FILL, Motion.CUT, Motion.LINK, Motion.RAPID]
    machine = load_machine("trunnion_ac")
    kinematics = chain(machine, Setup(machine.origin))
    path = path_of(tip, axis, motion)
    return kinematics, solve(path, kinematics, np.array([-5.0, -5.0, 0.0]), np.array([20.0, 20.0, 15.0]), 5.0)


@pytest.mark.parametrize("dialect", DIALECTS.values(), ids=DIALECTS)
def test_the_program_of_a_divided_path_is_proven(dialect):
    kinematics, joints = near_the_pole()
    before = build_program(joints, kinematics, dialect, True)
    assert measure(kinematics, before.words).bound[before.motion != Motion.RAPID].max() > 0.01
    longer = linearize(joints, kinematics, dialect, 0.01)
    program = build_program(longer, kinematics, dialect, True)
    feed = program.motion != Motion.RAPID
    assert measure(kinematics, program.words).bound[feed].max() <= 0.01
    assert q_to_words(longer.q)[program.row] == pytest.approx(
        program.words, abs=1e-9
    )  # nothing is rounded a second time
    assert [f.code for f in longer.findings if f.code.startswith("linear")] == ["linearized"]


def test_inserted_rows_carry_what_the_row_they_lead_to_carries():
    kinematics, joints = near_the_pole()
    longer = linearize(joints, kinematics, DIALECTS["linuxcnc"], 0.01)
    own = np.arange(len(longer.row))
    given = list(zip(joints.path.tip, joints.path.motion, strict=True))
    place = [
        np.flatnonzero((longer.path.tip == tip).all(1) & (longer.path.motion == motion))[-1]
        for tip, motion in given
    ]
    leads_to = np.searchsorted(place, own)
    for name in ("motion", "feed", "face", "coedge", "pass_"):
        assert (getattr(longer.path, name) == getattr(joints.path, name)[leads_to]).all()
    assert (longer.row == joints.row[leads_to]).all()
    inserted = np.bincount(leads_to) - 1
    assert (inserted[joints.path.motion == Motion.RAPID] == 0).all()
    assert (inserted[[1, 2, 3, 4]] > 0).all()  # link, cut, fill, cut
    tip, axis = forward(kinematics, longer.q)
    assert np.abs(tip - longer.path.tip).max() < 1e-4
    assert np.abs(axis - longer.path.axis).max() < math.radians(1e-4)


def test_a_path_within_tolerance_keeps_its_rows():
    kinematics, joints = near_the_pole()
    same = linearize(joints, kinematics, DIALECTS["linuxcnc"], 100.0)
    assert (same.row == joints.row).all()
    assert (same.path.tip == joints.path.tip).all()
    assert np.abs(same.q - joints.q).max() < 5e-4
    assert same.findings == joints.findings


def test_limits_that_only_inserted_rows_break_are_stated():
    kinematics, words = trunnion_block((0.0, 60.0), (170.0, 60.0), (3.0, 1.0, 0.0))
    found, _, findings = linearize_words(kinematics, words, (4, 4), 0.01)
    assert found[:, 4].min() < 10.0  # the great arc passes near the pole
    assert not [f for f in findings if f.code == "linearize-limit"]
    narrow = replace(kinematics, low=kinematics.low + [0, 0, 0, 0, math.radians(30.0) - kinematics.low[4]])
    limit = next(f for f in linearize_words(narrow, words, (4, 4), 0.01)[2] if f.code == "linearize-limit")
    assert limit.severity == Severity.ERROR
    assert limit.limit == pytest.approx(30.0)
    assert limit.place is not None


def test_long_work_says_where_it_stands_and_can_be_stopped():
    def stop(stage, fraction):
        raise Cancelled(f"{stage} {fraction}")

    with pytest.raises(Cancelled, match="linearize"):
        linearize_words(mikron_links(), TABLE_2, (4, 4), 0.01, None, stop)


def test_balanced_shares_spread_the_load_evenly():
    """Against the closed form: a load density of 2 s on [0, 1] is even at the square roots."""
    share = np.concatenate([np.linspace(0, 1, 41), np.linspace(0, 1, 21)])
    load = np.concatenate([np.diff(np.linspace(0, 1, 41) ** 2), [0.0], np.diff(np.linspace(0, 1, 21)), [0.0]])
    calm = np.zeros(2, bool)
    found = balance_shares(share, load, np.array([40, 20]), calm, np.array([0, 1]), np.array([9, 4]))
    assert np.abs(found[:10] - np.sqrt(np.arange(10) / 9)).max() < 2e-3
    assert np.abs(found[10:] - np.arange(5) / 4).max() < 1e-12


def test_a_block_without_any_load_keeps_its_shares():
    share, load = np.array([0.0, 0.3, 1.0, 0.0, 0.5, 1.0]), np.array([0.0, 0.0, 0.0, 1.0, 3.0, 0.0])
    found = balance_shares(
        share, load, np.array([2, 2]), np.zeros(2, bool), np.array([0, 1]), np.array([2, 2])
    )
    assert np.abs(found[:3] - (0.0, 0.3, 1.0)).max() < 1e-12
    assert (found[[3, 5]] == (0.0, 1.0)).all() and 0.5 < found[4] < 0.8


def test_words_on_the_arc_stay_on_the_winding_of_their_block():
    """The first axis of a nutating table turns by 255 deg while the tool axis turns by less than half a turn:
    what follows the arc goes from the start's own words to the end's, whole turns included."""
    kinematics = kinematics_of("nutating")
    start, end = np.array([[0.0, 0, 0, -62.8391, 173.4297]]), np.array([[0.0, 0, 0, 191.7896, 8.6368]])
    way = course_of(kinematics, start, end)
    assert not way.even.any()
    share = np.linspace(0.0, 1.0, 2001)
    words = follow(kinematics, way, np.zeros(2001, int), share, Steps(4, 4))
    axis = forward(kinematics, words_to_q(words))[1]
    assert (
        np.abs(np.diff(words[:, 3:], axis=0)).max() < 15.0
        and words[0, 3] == start[0, 3]
        and words[-1, 3] == end[0, 3]
    )
    ends = axis[[0, -1]]
    angle = np.arccos(ends[0] @ ends[1])
    sine = np.sin(np.stack([1.0 - share, share]) * angle) / np.sin(angle)
    assert axis == pytest.approx(sine.T @ ends, abs=3e-6)
