# SPDX-License-Identifier: LGPL-2.1-or-later
"""The placements of a played program against the kinematics, LinuxCNC's formulas, and Table 2 of So et al."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from bare_machines import BARE
from five_kinds import KINDS, TABLE_2, kinematics_of, mikron_links, random_blocks
from report_examples import by_hand, dome, empty, program_of

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.motion.deviation import measure
from freecad_fiveaxis.core.report.playback import (
    UNTIMED,
    NCLines,
    Playback,
    following,
    rigid_inverse,
    rotary_lines,
    segment_foot,
)

CLOSE = 1e-9  # mm: levers of some 500 mm, a few dozen roundings
WORST_U, WORST = 0.54543, 2.12642  # Table 2's largest distance from the segment


def played(kinematics, words) -> Playback:
    program = program_of(kinematics, np.asarray(words, float))
    return Playback(kinematics, program, measure(kinematics, program.words))


def shipped(name, tool_length=137.0):
    machine = load_machine(name)
    return chain(machine, Setup(machine.origin, tool_length if machine.has_head else 0.0))


def random_words(kinematics, count=60, seed=4):
    return np.round(random_blocks(kinematics, count, seed)[0], 4)


@pytest.fixture(params=[*BARE, *KINDS])
def kinematics(request):
    return kinematics_of(request.param) if request.param in KINDS else shipped(request.param)


@pytest.fixture
def many(kinematics):
    play = played(kinematics, random_words(kinematics))
    rng = np.random.default_rng(5)
    return play, play.at_block(rng.integers(1, 60, 200), rng.uniform(0, 1, 200))


# ------------------------------------------------------------------------------------------------ placements


def test_tip_axis_and_tool_placement_are_those_of_the_kinematics(kinematics, many):
    _, pose = many
    tip, axis = forward(kinematics, words_to_q(pose.words))
    assert np.abs(pose.tip - tip).max() < CLOSE
    assert np.abs(pose.axis - axis).max() < 1e-13
    assert np.abs(pose.work_from_tool[:, :3, 3] - tip).max() < CLOSE
    assert np.abs(pose.work_from_tool[:, :3, 2] - axis).max() < 1e-13


def test_the_way_through_the_machine_ends_at_the_tool(many):
    _, pose = many
    assert np.abs(pose.work_from_machine @ pose.machine_from_tool - pose.work_from_tool).max() < CLOSE
    assert np.abs(pose.machine_from_work @ pose.work_from_machine - np.eye(4)).max() < CLOSE


def test_placements_are_rigid(many):
    _, pose = many
    for name in ("work_from_tool", "machine_from_work", "work_from_machine", "machine_from_tool"):
        placement = getattr(pose, name)
        turn = placement[:, :3, :3]
        assert np.abs(turn @ turn.swapaxes(1, 2) - np.eye(3)).max() < 1e-13, name
        assert np.abs(np.linalg.det(turn) - 1.0).max() < 1e-13, name
        assert (placement[:, 3] == (0, 0, 0, 1)).all(), name


def test_a_table_axis_never_moves_the_tool_and_a_head_axis_never_the_work(kinematics):
    words = np.zeros((11, 5))
    words[1:6], words[6:] = np.eye(5) * 10.0, np.eye(5) * 10.0
    pose = played(kinematics, words).at_block(np.arange(1, 6), 1.0)
    for j, axis in enumerate(kinematics.axes):
        held = pose.machine_from_tool if axis.side == "table" else pose.machine_from_work
        moved = pose.machine_from_work if axis.side == "table" else pose.machine_from_tool
        assert np.array_equal(held[j], np.eye(4)), axis.letter
        assert np.abs(moved[j] - np.eye(4)).max() > 0.1, axis.letter


def test_with_all_words_zero_work_machine_and_tool_are_one(kinematics):
    pose = played(kinematics, np.zeros((1, 5))).at(0.0)
    for name in ("work_from_tool", "machine_from_work", "machine_from_tool"):
        assert np.array_equal(getattr(pose, name), np.eye(4))
    assert np.allclose(pose.line_point, [kinematics.point1, kinematics.point2])
    assert np.array_equal(pose.line_direction, kinematics.direction[3:])


def test_rotary_lines_stand_still_while_their_own_axis_turns_and_carry_it(kinematics):
    rows = np.repeat(random_words(kinematics, 8), 3, axis=0)
    for which in range(2):
        turned = rows.copy()
        turned[1::3, 3 + which] += 31.0
        turned[2::3, 3 + which] -= 77.0
        pose = played(kinematics, turned).at_block(np.arange(24), 1.0)
        point, direction = pose.line_point[:, which], pose.line_direction[:, which]
        for other in (1, 2):
            assert np.abs(np.cross(point[other::3] - point[::3], direction[::3])).max() < 1e-8
            assert np.abs(direction[other::3] - direction[::3]).max() < 1e-12
        table = kinematics.axes[3 + which].side == "table"
        placed = pose.machine_from_work if table else pose.machine_from_tool
        before, after = placed[::3], placed[1::3]
        stays = rigid_inverse(before) @ np.concatenate([point[::3], np.ones((8, 1))], axis=1)[..., None]
        assert (
            np.abs((after @ stays)[:, :3, 0] - point[::3]).max() < 1e-8
        )  # a point of the line is not moved by the turn


def rx(a):
    return np.array([[1, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]])


def ry(b):
    return np.array([[math.cos(b), 0, math.sin(b)], [0, 1, 0], [-math.sin(b), 0, math.cos(b)]])


def rz(c):
    return np.array([[math.cos(c), -math.sin(c), 0], [math.sin(c), math.cos(c), 0], [0, 0, 1]])


@pytest.mark.parametrize(("name", "tilt"), [("linuxcnc_xyzac_trt", rx), ("linuxcnc_xyzbc_trt", ry)])
def test_linuxcnc_trunnions_turn_the_work_by_plus_c_then_tilt_it(name, tilt):
    """xyzac-trt and xyzbc-trt: P = Rz(-C)(d + R(-A)(J - d)), so the work stands at R(A)(Rz(C) P - d) + d;
    tables turn by + words."""
    kinematics = shipped(name)
    pose = played(kinematics, random_words(kinematics)).at_block(np.arange(60), 1.0)
    d = {"linuxcnc_xyzac_trt": (0, 20.0, 10.0), "linuxcnc_xyzbc_trt": (-20.0, 0, -15.0)}[name]
    for words, placement, tool in zip(
        pose.words, pose.machine_from_work, pose.machine_from_tool, strict=True
    ):
        c, a = np.radians(words[3:])
        turn = tilt(a) @ rz(c)
        assert np.abs(placement[:3, :3] - turn).max() < 1e-13
        assert np.abs(placement[:3, 3] - (np.array(d) - tilt(a) @ d)).max() < CLOSE
        assert np.abs(tool[:3, 3] - words[:3]).max() < CLOSE and np.array_equal(tool[:3, :3], np.eye(3))


def test_a_fork_head_carries_the_tool_as_5axiskins_says():
    """5axiskins: k = Rz(C) Ry(-B) ez and tip = J + (0, 0, L) - (L + W) k, with B ISO in our file; the work
    never turns."""
    kinematics = shipped("fork_head_bc", 137.0)
    pose = played(kinematics, random_words(kinematics)).at_block(np.arange(60), 1.0)
    assert np.array_equal(pose.machine_from_work[:, :3, :3], np.tile(np.eye(3), (60, 1, 1)))
    lever = 150.0 + 137.0
    for words, placement in zip(pose.words, pose.work_from_tool, strict=True):
        c, b = np.radians(words[3:])
        k = rz(c) @ ry(b) @ (0, 0, 1)
        assert np.abs(placement[:3, 2] - k).max() < 1e-13
        assert np.abs(placement[:3, 3] - (words[:3] + (0, 0, lever) - lever * k)).max() < CLOSE


def test_a_turning_table_and_a_leaning_head_as_maxkins_says():
    """maxkins: J = Rz(-C) P + L Ry(-B) ez - (0, 0, L), ISO words here: the table turns by -C, the head leans
    by B."""
    kinematics = shipped("head_b_table_c", 137.0)
    pose = played(kinematics, random_words(kinematics)).at_block(np.arange(60), 1.0)
    lever, at = 120.0 + 137.0, [kinematics.letters.index(letter) for letter in "BC"]
    for words, work, tip in zip(pose.words, pose.machine_from_work, pose.tip, strict=True):
        b, c = np.radians(words[at])
        joint = rz(-c) @ tip + lever * ry(b) @ (0, 0, 1) - (0, 0, lever)
        assert np.abs(work[:3, :3] - rz(-c)).max() < 1e-13
        assert np.abs(joint - words[:3]).max() < CLOSE


# --------------------------------------------------------------------------------------------- within a block


def test_the_tip_leaves_the_chord_of_table_2_by_2_126_mm():
    play = played(mikron_links(), TABLE_2)
    pose = play.at_block(1, WORST_U)
    assert play.worst == 1
    assert pose.to_chord == pytest.approx(WORST, abs=1e-5)
    u = np.linspace(0, 1, 20001)
    distance = play.at_block(1, u).to_chord
    assert distance.max() == pytest.approx(WORST, abs=1e-5)
    assert u[distance.argmax()] == pytest.approx(WORST_U, abs=1e-4)
    assert distance[[0, -1]].max() < 1e-9


def test_table_2_overshoots_the_end_of_its_chord():
    curve = played(mikron_links(), TABLE_2).curve(1)
    chord = curve[-1] - curve[0]
    share = (curve - curve[0]) @ chord / (chord @ chord)
    assert np.linalg.norm(chord) == pytest.approx(1.122, abs=1e-3)
    assert share.max() == pytest.approx(2.74, abs=0.01)
    assert np.linalg.norm(np.diff(curve, axis=0), axis=1).sum() == pytest.approx(5.46, abs=0.01)


@pytest.mark.thorough
def test_the_largest_distance_in_each_block_is_its_deviation(kinematics):
    start, end = random_blocks(kinematics, 20, 8)
    words = np.stack([start, end], axis=1).reshape(-1, 5)
    play = played(kinematics, words)
    distance = play.at_block(np.arange(1, 40)[:, None], np.linspace(0, 1, 2001)[None]).to_chord
    assert distance.shape == (39, 2001)
    assert distance.max(axis=1) == pytest.approx(play.deviation.segment[1:], rel=1e-4, abs=1e-4)


def test_foot_on_a_segment_counts_its_ends_and_a_point():
    start, end = np.zeros((3, 3)), np.array([[10.0, 0, 0], [10.0, 0, 0], [0.0, 0, 0]])
    point = np.array([[5.0, 3, 0], [13.0, 4, 0], [0.0, 0, 2]])
    assert segment_foot(point, start, end).tolist() == [[5.0, 0, 0], [10.0, 0, 0], [0.0, 0, 0]]


def test_drawn_rotary_lines_pass_by_the_work(kinematics):
    pose, near = played(kinematics, random_words(kinematics, 3)).at_block(2, 0.3), np.array([3.0, -4.0, 5.0])
    ends = rotary_lines(pose, near, 80.0)
    placed = (pose.machine_from_work @ [*near, 1.0])[:3]
    for which in range(2):
        low, high = ends[which]
        assert np.linalg.norm(high - low) == pytest.approx(160.0)
        assert np.abs(np.cross(pose.line_point[which] - low, pose.line_direction[which])).max() < 1e-8
        assert (placed - (low + high) / 2) @ pose.line_direction[which] == pytest.approx(0.0, abs=1e-9)


# ------------------------------------------------------------------------------------------------ time


def test_the_clock_is_the_programs_time():
    figures = dome()
    play = Playback(figures.kinematics, figures.program, figures.deviation)
    assert play.seconds == pytest.approx(figures.program.seconds.sum())
    assert play.worst == figures.worst[0]
    middle = play.clock[40] + 0.25 * figures.program.seconds[41]
    block, u = play.spot(middle)
    assert block == 41 and u == pytest.approx(0.25)


def test_time_and_spot_are_inverse_and_end_at_the_ends():
    figures = dome()
    play = Playback(figures.kinematics, figures.program, figures.deviation)
    times = np.random.default_rng(1).uniform(0, play.seconds, 500)
    assert play.time(*play.spot(times)) == pytest.approx(times, abs=1e-9)
    block, u = play.spot([-5.0, 0.0, play.seconds, play.seconds + 5.0])
    assert block.tolist() == [0, 0, len(play.clock) - 1, len(play.clock) - 1]
    assert u.tolist() == [1.0] * 4


def test_many_times_give_what_each_gives_alone():
    figures = dome()
    play = Playback(figures.kinematics, figures.program, figures.deviation)
    times = np.linspace(0, play.seconds, 12).reshape(3, 4)
    many = play.at(times)
    assert (
        many.tip.shape == (3, 4, 3)
        and many.machine_from_work.shape == (3, 4, 4, 4)
        and many.line_point.shape == (3, 4, 2, 3)
    )
    for i, j in np.ndindex(3, 4):
        alone = play.at(times[i, j])
        assert alone.tip.shape == (3,) and alone.block == many.block[i, j]
        assert np.allclose(alone.tip, many.tip[i, j], atol=1e-12)
    assert many.seconds == pytest.approx(times)


def test_no_moments_give_no_poses():
    pose = played(mikron_links(), TABLE_2).at(np.empty(0))
    assert pose.tip.shape == (0, 3) and pose.work_from_tool.shape == (0, 4, 4) and pose.to_chord.shape == (0,)


def test_a_block_of_unknown_time_is_shown_for_a_moment_and_one_that_does_not_move_is_not():
    figures = by_hand()
    words = figures.program.words.copy()
    words[3] = words[2]
    untimed = replace(
        figures.program, words=words, seconds=np.array([0.0, 0.0, 1.0, 0.0, np.nan, np.inf, 2.0])
    )
    play = Playback(figures.kinematics, untimed, figures.deviation)
    assert np.diff(play.clock, prepend=0.0) == pytest.approx([0.0, UNTIMED, 1.0, 0.0, UNTIMED, UNTIMED, 2.0])
    assert int(play.spot(UNTIMED + 1.0)[0]) == 2


def test_the_first_position_comes_from_nowhere():
    play = played(mikron_links(), TABLE_2)
    start, later = play.at_block(0, 0.0), play.at_block(0, 1.0)
    assert np.array_equal(start.words, TABLE_2[0]) and np.array_equal(start.tip, later.tip)


@pytest.mark.parametrize("block", [-1, 2])
def test_a_block_that_is_not_there_is_named(block):
    play = played(mikron_links(), TABLE_2)
    with pytest.raises(ProgramError, match=f"no block {block}"):
        play.at_block(block, 0.5)
    with pytest.raises(ProgramError, match=f"no block {block}"):
        play.curve(block)


def test_a_program_without_a_block_cannot_be_played():
    figures = empty()
    with pytest.raises(ProgramError, match="nothing to play"):
        Playback(figures.kinematics, figures.program, figures.deviation)


def test_following_goes_round():
    rows = np.array([3, 7, 9])
    assert [following(rows, block) for block in (0, 3, 8, 9, 20)] == [3, 7, 9, 3, 3]
    assert following(rows[:0], 5) is None


def test_lines_are_counted_as_the_reader_counts_them():
    for newline in (b"\n", b"\r\n", b"\r"):
        lines = NCLines(newline.join([b"%", b"", b"N10 G1 X1 ", b"M2"]))
        assert [lines[i] for i in range(6)] == ["", "%", "", "N10 G1 X1", "M2", ""]
    lines = NCLines(
        b"N10 G1 X1 (A\rB)\nN20 X2\nM2\n"
    )  # among lines of LF a CR alone is a blank, as to the reader
    assert (lines[2], lines[3]) == ("N20 X2", "M2")
    assert NCLines(b"")[1] == ""
    assert NCLines(b"(\xfc)")[1] == "(\ufffd)"
