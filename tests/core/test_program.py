# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rounded words, feeds and times of a Program, against closed forms, dense sampling and hand computation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from bare_machines import BARE

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.controllers.dialect import feed_distance
from freecad_fiveaxis.core.machine import Axis, Machine, load_machine
from freecad_fiveaxis.core.machine.kinematics import Chain, Setup, chain, forward, inverse
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.program import Program, build_program, feeds, shorter_turns, take_up_axes
from freecad_fiveaxis.core.nc.writer import write_nc
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

LINEAR_RATE, ROTARY_RATE = 10_000.0, np.radians(7200.0)  # mm/min, rad/min
UCP710_ROWS = np.array(
    [[-90.9595, 7.3103, 227.6341, 148.9685, 1.0664], [-82.0656, -34.8175, 228.3975, 121.5477, 1.1793]]
)
"""So et al. 2008, Table 2: mm and degrees (the angles belong to the order C, A)."""


def trunnion(
    limited: bool = True, rotary_point: tuple[float, float, float] = (0.0, -49.934, 119.999)
) -> Chain:
    rates = {"max_rate": LINEAR_RATE} if limited else {}
    turns = {"max_rate": float(ROTARY_RATE)} if limited else {}
    x, y, z = (
        Axis(name, False, "head", tuple(row), **rates) for name, row in zip("XYZ", np.eye(3), strict=True)
    )
    c = Axis("C", True, "table", (0, 0, 1), **turns)
    a = Axis("A", True, "table", (1, 0, 0), rotary_point, **turns)
    return chain(Machine("trunnion", (c, a, x, y, z)), Setup())


def joints_of(
    q: Floats, kinematics: Chain, motion: list[int] | None = None, feed: float = 1000.0
) -> JointPath:
    """A joint path through words ``q`` (n, 5) mm and rad."""
    tip, axis = forward(kinematics, q)
    rows = len(q)
    kind = np.array(motion if motion is not None else [Motion.RAPID] + [Motion.CUT] * (rows - 1), np.int8)[
        :rows
    ]
    none = np.full(rows, -1)
    path = CLPath(tip, axis, kind, np.where(kind == Motion.RAPID, 0.0, feed), tip, axis, none, none, none)
    return JointPath(path, np.arange(rows), q, np.zeros(rows, np.int8), np.ones(rows))


def wander(rows: int, seed: int = 0, turn: float = 0.02) -> Floats:
    random = np.random.default_rng(seed)
    steps = random.normal(0, 1, (rows, 5)) * (0.5, 0.5, 0.5, turn, turn)
    return np.cumsum(steps, axis=0)


def dense_travel(kinematics: Chain, start: Floats, end: Floats, samples: int = 20001) -> float:
    u = np.linspace(0, 1, samples)[:, None]
    tip = forward(kinematics, start + u * (end - start))[0]
    return float(np.linalg.norm(np.diff(tip, axis=0), axis=1).sum())


def in_radians(words: Floats) -> Floats:
    return np.concatenate([words[:, :3], np.radians(words[:, 3:])], axis=1)


MODES = [
    (dialect, inverse)
    for dialect in DIALECTS.values()
    for inverse in (True, False)
    if dialect.inverse_time or not inverse
]
REPORTED = [f"{dialect.name}-{'g93' if inverse else 'g94'}" for dialect, inverse in MODES]


@pytest.mark.parametrize(("dialect", "inverse_time"), MODES, ids=REPORTED)
class TestEveryDialectAndMode:
    def test_words_are_the_decimals_that_are_printed(self, dialect, inverse_time) -> None:
        kinematics, q = trunnion(), wander(300)
        words = build_program(joints_of(q, kinematics), kinematics, dialect, inverse_time).words
        exact = np.concatenate([q[:, :3], np.degrees(q[:, 3:])], axis=1)
        for k in range(5):
            assert all(float(f"{value:.{dialect.decimals(k)}f}") == value for value in words[:, k])
            assert np.abs(words - exact)[:, k].max() <= 0.5 * 10.0 ** -dialect.decimals(k) * (1 + 1e-9)
        assert not np.signbit(words[words == 0]).any()

    def test_no_axis_exceeds_its_rate_and_no_tip_its_feed(self, dialect, inverse_time) -> None:
        kinematics, q = replace(trunnion(), rate=np.array([1e4, 1e4, 1e4, 4.0, 4.0])), wander(400)
        program = build_program(joints_of(q, kinematics), kinematics, dialect, inverse_time)
        minutes = program.seconds[1:] / 60
        change = np.abs(np.diff(in_radians(program.words), axis=0))
        assert (change / kinematics.rate <= minutes[:, None] * (1 + 1e-8)).all()
        travel = [
            dense_travel(kinematics, *in_radians(program.words[i : i + 2]), samples=2001)
            for i in range(0, 399, 7)
        ]
        speed = np.array(travel) / minutes[::7]
        assert (speed <= 1000 * (1 + 2e-3)).all()
        free = (change / kinematics.rate).max(axis=1)[::7] < 0.9 * minutes[::7]
        capped = program.feed[1:][::7] >= (dialect.largest_inverse if inverse_time else dialect.largest_feed)
        slack = 2e-3 + 10.0**-(dialect.feed_decimals) / program.feed[1:][::7]
        assert (np.abs(speed / 1000 - 1) <= slack)[free & ~capped].all()
        assert free.any() and not free.all()

    def test_seconds_are_what_the_controller_makes_of_f(self, dialect, inverse_time) -> None:
        kinematics, q = trunnion(), wander(100)
        program = build_program(joints_of(q, kinematics), kinematics, dialect, inverse_time)
        change = np.diff(program.words, axis=0)
        linear, rotary = np.linalg.norm(change[:, :3], axis=1), np.linalg.norm(change[:, 3:], axis=1)
        distance = np.hypot(linear, rotary) if dialect.rotary_in_feed else linear
        distance = np.where(linear == 0.0, rotary, distance)
        expected = 60 / program.feed[1:] if inverse_time else 60 * distance / program.feed[1:]
        assert np.allclose(program.seconds[1:], expected, rtol=1e-12)
        assert program.seconds[0] == 0 and program.feed[0] == 0

    def test_block_i_stands_in_the_line_that_the_program_says(self, dialect, inverse_time) -> None:
        kinematics = trunnion()
        program = build_program(joints_of(wander(50), kinematics), kinematics, dialect, inverse_time)
        lines = write_nc(program, dialect, "t").decode().split(dialect.newline)
        for i, number in enumerate(program.line):
            start = f"{number - 1} " if dialect.number_all else ""
            assert lines[number - 1].startswith(f"{start}{(dialect.rapid, dialect.straight)[i > 0]} ")
            assert f"X{program.words[i, 0]:{'+' if dialect.plus else ''}.4f}" in lines[number - 1]
        assert len(lines) == len(dialect.head) + len(program.words) + len(dialect.tail) + 1

    def test_f_is_never_zero_and_a_finding_tells_of_the_step(self, dialect, inverse_time) -> None:
        kinematics = trunnion(limited=False)
        slow = joints_of(np.array([[0.0, 0, 0, 0, 0], [1, 0, 0, 0, 0]]), kinematics, feed=1e-6)
        program = build_program(slow, kinematics, dialect, inverse_time)
        assert program.feed[1] == 10.0 ** -(
            dialect.inverse_decimals if inverse_time else dialect.feed_decimals
        )
        assert [(found.code, found.severity) for found in program.findings] == [
            ("feed-below-step", Severity.WARNING)
        ]

    def test_an_empty_path_gives_an_empty_program_that_can_be_written(self, dialect, inverse_time) -> None:
        kinematics = trunnion()
        program = build_program(joints_of(np.empty((0, 5)), kinematics), kinematics, dialect, inverse_time)
        assert program.words.shape == (0, 5) and program.findings == ()
        assert write_nc(program, dialect, "t").count(b"\n") == len(dialect.head) + len(dialect.tail)


def g93(q: Floats, kinematics: Chain, **more) -> Program:
    return build_program(joints_of(q, kinematics, **more), kinematics, DIALECTS["linuxcnc"], True)


def test_blocks_without_any_move_after_rounding_are_left_out_and_their_rows_are_kept() -> None:
    kinematics = trunnion()
    q = np.array(
        [[0.0, 0, 0, 0, 0], [1e-5, 0, 0, 0, 0], [1, 0, 0, 0, 0], [1, 0, 0, 1e-8, 0], [1, 0, 0, 0, 1]]
    )
    program = g93(q, kinematics)
    assert program.row.tolist() == [0, 2, 4]
    assert program.words[:, 0].tolist() == [0, 1, 1]


def test_a_small_drift_is_not_lost_by_leaving_blocks_out() -> None:
    kinematics = trunnion()
    q = np.zeros((1001, 5))
    q[:, 0] = np.arange(1001) * 1e-5
    assert g93(q, kinematics).words[-1, 0] == 0.01


def test_a_straight_block_takes_its_length_over_its_feed() -> None:
    kinematics = trunnion()
    program = g93(np.array([[0.0, 0, 0, 0.3, 0.2], [3, 4, 0, 0.3, 0.2]]), kinematics, feed=500.0)
    assert program.feed[1] == 100.0  # 5 mm at 500 mm/min: 1/100 min
    assert program.seconds[1] == pytest.approx(0.6)


def test_a_block_turning_about_a_far_axis_is_timed_by_the_arc() -> None:
    kinematics = trunnion(limited=False)
    q = np.array([[100.0, 0, 0, 0, 0], [100, 0, 0, np.pi, 0]])
    program = g93(q, kinematics, feed=1000.0)
    assert program.seconds[1] == pytest.approx(
        60 * 100 * np.pi / 1000, rel=1e-4
    )  # half a circle of radius 100, not its chord


def test_the_real_path_of_so_et_al_table_2_is_5_46_mm_long() -> None:
    kinematics = trunnion()
    travel = feeds.tip_travel(kinematics, in_radians(UCP710_ROWS), np.array([True]))
    assert travel[0] == pytest.approx(5.46, abs=0.005)
    assert travel[0] == pytest.approx(dense_travel(kinematics, *in_radians(UCP710_ROWS)), rel=1e-5)


@pytest.mark.parametrize("turn", [1e-4, 0.003, 0.05, 0.5, 3.0])
def test_travel_agrees_with_dense_sampling_whatever_the_turn(turn: float) -> None:
    kinematics, q = trunnion(), wander(40, seed=3, turn=turn)
    travel = feeds.tip_travel(kinematics, q, np.ones(39, bool))
    dense = np.array([dense_travel(kinematics, q[i], q[i + 1], 4001) for i in range(39)])
    assert np.abs(travel / dense - 1).max() < feeds.TRAVEL_ERROR


@pytest.mark.parametrize("name", BARE)
def test_travel_agrees_with_dense_sampling_on_every_kind_of_chain(name: str) -> None:
    """Linear axes on one side of the rotary ones or on several: short blocks, of which many are taken for
    their chords."""
    kinematics = chain(load_machine(name), Setup(tool_length=120.0))
    rng = np.random.default_rng(5)
    lean = (0.3, 0.2) + rng.normal(0, 1, (1500, 2)) * 10.0 ** rng.uniform(-4.0, -1.5, (1500, 1))
    axis = np.column_stack([lean, np.ones(1500)])
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    tip = np.cumsum(rng.normal(0, 1, (1500, 3)) * rng.choice([0.05, 0.5, 3.0], (1500, 1)), axis=0)
    q = inverse(kinematics, tip, axis)[0][0]
    q = q[np.isfinite(q).all(axis=1)]
    q[:, 3:] = np.unwrap(q[:, 3:], axis=0)
    travel = feeds.tip_travel(kinematics, q, np.ones(len(q) - 1, bool))
    u = np.linspace(0, 1, 401)[:, None, None]
    path, _ = forward(kinematics, (q[:-1] * (1 - u) + q[1:] * u).reshape(-1, 5))
    dense = np.linalg.norm(np.diff(path.reshape(401, -1, 3), axis=0), axis=2).sum(axis=0)
    chord = np.linalg.norm(np.diff(forward(kinematics, q)[0], axis=0), axis=1)
    assert (
        50 < np.count_nonzero(np.isclose(travel, chord, rtol=1e-15, atol=0)) < len(chord) - 50
    )  # some so, some sampled
    np.testing.assert_allclose(travel, dense, rtol=feeds.TRAVEL_ERROR)


def test_the_chord_alone_would_be_far_off() -> None:
    kinematics = trunnion()
    chord = feeds.tip_travel(kinematics, in_radians(UCP710_ROWS), np.array([False]))
    assert chord[0] == pytest.approx(1.122, abs=0.001)


def test_many_turns_in_one_block_are_timed() -> None:
    kinematics = trunnion(limited=False)
    q = np.array([[10.0, 0, 0, 0, 0], [10, 0, 0, 200 * np.pi, 0]])
    assert feeds.tip_travel(kinematics, q, np.array([True]))[0] == pytest.approx(100 * 20 * np.pi, rel=1e-3)


def test_a_turn_about_the_tip_goes_as_fast_as_the_axis_may() -> None:
    kinematics = trunnion()
    q = np.array([[0.0, 0, 50, 0, 0], [0, 0, 50, np.pi, 0]])  # the tip stands on the C axis
    program = g93(q, kinematics)
    assert program.seconds[1] == pytest.approx(60 * np.pi / ROTARY_RATE, rel=1e-5)
    assert program.findings == ()


def test_held_back_blocks_are_counted_in_a_note() -> None:
    kinematics, q = replace(trunnion(), rate=np.array([1e4, 1e4, 1e4, 4.0, 4.0])), wander(300)
    program = g93(q, kinematics)
    change = np.abs(np.diff(in_radians(program.words), axis=0))
    travel = [dense_travel(kinematics, *in_radians(program.words[i : i + 2]), 1001) for i in range(299)]
    least, wanted = (change / kinematics.rate).max(axis=1), np.array(travel) / 1000
    count = int((least > wanted * (1 + feeds.TRAVEL_ERROR)).sum())
    note = next(found for found in program.findings if found.code == "feed-held-back")
    assert 0 < count < 299 and note.value == pytest.approx(count, abs=1) and note.severity is Severity.NOTE
    assert note.block == int((least > wanted).argmax()) + 1 and note.line == program.line[note.block]
    real = np.median((np.array(travel) / least)[least > wanted * (1 + feeds.TRAVEL_ERROR)])
    assert 0.0 < real < 1000.0 and f"half of them at less than {real:.3g} mm/min" in note.text


def test_a_rapid_takes_the_time_of_its_slowest_axis() -> None:
    kinematics = trunnion()
    q = np.array([[0.0, 0, 0, 0, 0], [100, 0, 0, 0, 0], [100, 50, 0, np.pi, 0]])
    program = g93(q, kinematics, motion=[Motion.RAPID] * 3)
    assert program.seconds[1] == pytest.approx(60 * 100 / LINEAR_RATE)
    assert program.seconds[2] == pytest.approx(60 * np.pi / ROTARY_RATE)
    assert not program.feed.any()


def test_a_machine_without_rates_still_gives_times() -> None:
    kinematics = trunnion(limited=False)
    q = np.array([[0.0, 0, 50, 0, 0], [0, 0, 50, np.pi, 0], [100, 0, 50, np.pi, 0]])
    seconds = g93(q, kinematics, motion=[Motion.RAPID, Motion.CUT, Motion.RAPID]).seconds
    assert (seconds[1:] > 0).all() and np.isfinite(seconds).all()


def test_both_feed_modes_give_the_same_times() -> None:
    kinematics, q = trunnion(), wander(200)
    for dialect in DIALECTS.values():
        free = replace(dialect, largest_inverse=1e9)
        first, second = (
            build_program(joints_of(q, kinematics), kinematics, free, mode).seconds for mode in (True, False)
        )
        assert np.allclose(first, second, rtol=1e-4)


def test_an_f_beyond_the_controllers_largest_is_cut_with_a_note() -> None:
    kinematics, fanuc = trunnion(), DIALECTS["fanuc"]
    q = np.array([[0.0, 0, 0, 0, 0], [0.001, 0, 0, 0, 0]])
    program = build_program(joints_of(q, kinematics), kinematics, fanuc, True)
    assert program.feed[1] == fanuc.largest_inverse
    assert [found.code for found in program.findings] == ["feed-above-largest"]
    real = 0.001 * fanuc.largest_inverse
    assert f"half of them at less than {real:.3g} mm/min" in program.findings[0].text


def test_fanucs_own_example_of_a_combined_feed() -> None:
    """B-63174EN, 4.2: G91 G01 X20.0 C40.0 F300.0 takes 0.14907 min."""
    distance = feed_distance(DIALECTS["fanuc"], np.array([[20.0, 0, 0, 40, 0]]))
    assert distance[0] / 300 == pytest.approx(0.14907, abs=1e-5)


def test_linuxcnc_measures_f_over_xyz_and_degrees_where_only_rotary_axes_move() -> None:
    change = np.array([[3.0, 4, 0, 100, 0], [0, 0, 0, 30, 40]])
    assert feed_distance(DIALECTS["linuxcnc"], change).tolist() == [5, 50]
    assert feed_distance(None, change).tolist() == [5, 50]


def test_a_feed_move_without_a_feed_is_refused_with_its_row() -> None:
    kinematics = trunnion()
    with pytest.raises(ProgramError, match="row 3"):
        joints = joints_of(wander(5), kinematics)
        feed = np.array(joints.path.feed)
        feed[3] = 0.0
        build_program(
            replace(joints, path=replace(joints.path, feed=feed)), kinematics, DIALECTS["linuxcnc"], True
        )


def test_a_path_that_starts_with_a_feed_move_starts_in_rapid_and_says_so() -> None:
    kinematics = trunnion()
    program = g93(wander(5), kinematics, motion=[Motion.CUT] * 5)
    assert program.motion[0] == Motion.RAPID
    assert [found.code for found in program.findings] == ["first-position-rapid"]


def test_motions_and_feeds_are_those_of_the_rows_kept() -> None:
    kinematics = trunnion()
    kinds = [Motion.RAPID, Motion.LINK, Motion.CUT, Motion.FILL, Motion.RAPID]
    program = g93(wander(5), kinematics, motion=kinds)
    assert program.motion.tolist() == kinds
    assert (program.feed > 0).tolist() == [False, True, True, True, False]


def test_whoever_watches_can_stop_the_work() -> None:
    class Stop(Exception):
        pass

    def stop(stage: str, fraction: float) -> None:
        raise Stop

    kinematics = trunnion()
    with pytest.raises(Stop):
        build_program(joints_of(wander(5), kinematics), kinematics, DIALECTS["linuxcnc"], True, stop)


def test_a_blocks_travel_does_not_depend_on_the_blocks_around_it() -> None:
    kinematics, q = trunnion(), wander(200, seed=8, turn=0.01)
    q[150] += (5000.0, 0, 0, 0, 0)  # a far row must not change how others are measured
    whole = feeds.tip_travel(kinematics, q, np.ones(199, bool))
    alone = np.array([feeds.tip_travel(kinematics, q[i : i + 2], np.array([True]))[0] for i in range(199)])
    np.testing.assert_allclose(whole, alone, rtol=1e-12)


def test_a_path_whose_chord_is_taken_for_it_is_hardly_longer():
    """A parabola beside its chord by all that is let pass, and one that is uneven along it too, against dense
    sampling."""
    u, off = np.linspace(0, 1, 20001), feeds.EVEN
    for aslant in (0.0, 0.5):
        sag = 4 * off * u * (1 - u)
        path = np.stack([u + np.sin(aslant) * sag, np.cos(aslant) * sag])
        longer = np.linalg.norm(np.diff(path, axis=1), axis=0).sum() - 1
        assert 0.6 * feeds.TRAVEL_ERROR < longer < feeds.TRAVEL_ERROR


def test_a_short_path_that_turns_back_on_itself_is_measured_closely():
    """Chords of a fifth of a millimetre with three degrees of turn at a long lever: the tip may run back and
    forth."""
    kinematics = chain(load_machine("fork_head_bc"), Setup(tool_length=120.0))
    rng = np.random.default_rng(11)
    axis = rng.normal(0, 0.01, (400, 2)) + (0.3, 0.2)
    axis = (
        np.column_stack([axis, np.ones(400)])
        / np.linalg.norm(np.column_stack([axis, np.ones(400)]), axis=1)[:, None]
    )
    tip = np.cumsum(rng.normal(0, 0.1, (400, 3)), axis=0)
    q = inverse(kinematics, tip, axis)[0][0]
    travel = feeds.tip_travel(kinematics, q, np.ones(399, bool))
    u = np.linspace(0, 1, 2001)[:, None, None]
    path, _ = forward(kinematics, (q[:-1] * (1 - u) + q[1:] * u).reshape(-1, 5))
    dense = np.linalg.norm(np.diff(path.reshape(2001, -1, 3), axis=0), axis=2).sum(axis=0)
    assert (dense > 1.2 * np.linalg.norm(np.diff(tip, axis=0), axis=1)).any()  # some do bend
    np.testing.assert_allclose(travel, dense, rtol=feeds.TRAVEL_ERROR)


def test_words_of_0_to_360_are_taken_the_shorter_way_all_along():
    """The turns add up: after 350 to 10, which counts on to 370, every later word is a turn more, too."""
    word = np.array([350.0, 10.0, 20.0, 200.0, 190.0, 20.0, 350.0, 10.0])
    assert shorter_turns(word).tolist() == [0, 1, 1, 1, 1, 1, 0, 1]
    walk = np.cumsum(np.random.default_rng(4).uniform(-179.0, 179.0, 500))
    folded = np.mod(walk, 360.0)
    assert folded + 360.0 * (shorter_turns(folded) + walk[0] // 360.0) == pytest.approx(walk, abs=1e-6)


def test_an_axis_vector_is_taken_up_on_the_winding_nearest_to_the_words_before():
    kinematics, rng = trunnion(), np.random.default_rng(5)
    wanted = np.column_stack(
        [rng.uniform(-1500.0, 1500.0, 300), rng.uniform(5.0, 85.0, 300) * rng.choice((-1.0, 1.0), 300)]
    )
    vector = forward(kinematics, in_radians(np.column_stack([np.zeros((300, 3)), wanted])))[1]
    near = wanted + rng.uniform(-4.0, 4.0, wanted.shape)
    assert take_up_axes(kinematics, vector, near) == pytest.approx(wanted, abs=1e-9)
