# SPDX-License-Identifier: LGPL-2.1-or-later
"""The model of So et al. on their own example, near the pole of every kind of chain, and where it fails."""

from __future__ import annotations

import numpy as np
import pytest
from five_kinds import KINDS, TABLE_2, interleaved, kinematics_of, mikron_links

from freecad_fiveaxis.core.machine.kinematics import linear_words
from freecad_fiveaxis.core.motion.deviation import measure, so2008
from freecad_fiveaxis.core.motion.deviation.so2008 import line_deviation, model_tip
from freecad_fiveaxis.core.motion.trajectory import chain_motion, frames, inner, tip, tip_at


@pytest.fixture(params=KINDS)
def kinematics(request):
    return kinematics_of(request.param)


@pytest.fixture(scope="module")
def mikron():
    return mikron_links()


def blocks_at(kinematics, tilt, count=300, turn=30.0, seed=1, level=False):
    """Blocks with 1 mm chords, across U where ``level``, V within ``tilt`` deg of the pole and turning by up
    to 0.2 deg, U turning by up to ``turn``."""
    rng = np.random.default_rng(seed)
    first = np.stack([rng.uniform(-180, 180, count), rng.uniform(-tilt, tilt, count)], axis=1)
    last = first + np.stack(
        [rng.uniform(10, turn, count) * rng.choice((-1, 1), count), rng.uniform(-0.2, 0.2, count)], axis=1
    )
    tips, step = rng.uniform(-80, 80, (count, 3)), rng.normal(size=(count, 3))
    step -= level * (step @ kinematics.direction[3])[:, None] * kinematics.direction[3]
    step /= np.linalg.norm(step, axis=1)[:, None]
    ends = [(tips, np.radians(first)), (tips + step, np.radians(last))]
    start, end = (np.concatenate([linear_words(kinematics, p, q), np.degrees(q)], axis=1) for p, q in ends)
    return interleaved(start, end)


def test_table_2_line_deviation_is_within_a_micron_of_the_exact_one(mikron):
    model, exact = measure(mikron, TABLE_2, method="so2008"), measure(mikron, TABLE_2)
    assert model.line[1] == pytest.approx(exact.line[1], abs=1e-3)
    assert model.line[1] == pytest.approx(0.93845, abs=3e-4)
    assert model.u_line[1] == pytest.approx(0.40413, abs=1e-4)


def test_table_2_by_equation_8_as_printed_is_not_what_the_paper_prints(mikron):
    printed = measure(mikron, TABLE_2, method="so2008-printed")
    assert printed.u_line[1] == pytest.approx(0.4708, abs=1e-4)  # the paper: 0.4101
    assert printed.line[1] == pytest.approx(0.9192, abs=1e-4)  # the paper: 0.9383


def test_equation_8_is_the_printed_one_times_n(mikron):
    """Eqs. (7) and (8) by their own symbols on Table 2, for table-table chains, where G is zero."""
    frame = frames(mikron)
    move, poses = chain_motion(frame, TABLE_2)
    m0, slope, _ = so2008._linear_inner(inner(frame, poses))
    u = np.linspace(0.0, 1.0, 11)[:, None]
    ours, _ = so2008._eq_8(move, poses, frame, m0, slope, u)
    a, phi, turn = np.abs(slope), np.angle(slope), move.a_step
    a0 = (m0 * slope.conj()).real / a
    b = (m0.conj() * slope).imag / a  # with its sign, so that s beta = -atan2(b, a0 + u a)
    r, beta = np.hypot(a0 + u * a, b), -np.arctan2(b, a0 + u * a)
    slower, faster = (a0 + u * a) * a / r, r * (turn + a * b / r**2)  # r' and r (U' + beta')
    n, lean = np.hypot(slower, faster), np.arctan2(faster, slower)
    x, y, _ = tip(frame, poses)
    omega = np.arctan2(np.diff(y), np.diff(x))
    printed = np.sin(move.a + u * turn + phi - omega + beta + lean)
    assert ours / n == pytest.approx(printed, abs=1e-9)
    assert np.ptp(printed) > 0.5


def test_all_but_the_line_columns_are_exact(mikron):
    model, exact = measure(mikron, TABLE_2, method="so2008"), measure(mikron, TABLE_2)
    for name in ("segment", "u_segment", "bound", "axis", "place"):
        assert np.array_equal(getattr(model, name), getattr(exact, name)), name


def test_table_2_model_path_is_within_0_021_mm_of_the_real_one(mikron):
    u = np.linspace(0, 1, 1001)
    real = tip_at(mikron, TABLE_2[:1], TABLE_2[1:], u[None])
    off = np.linalg.norm(model_tip(mikron, TABLE_2, u) - real, axis=2).max()
    assert 0.020 < off < 0.0215


def test_table_2_foot_parameter_is_that_of_the_paper_s_example(mikron):
    """k from the two M by hand: M = Rx(A) applied to N - d, plus d, with d = (0, -49.934, 119.999)."""
    m = []
    for x, y, z, _, a in TABLE_2:
        a, dy, dz = np.radians(a), -49.934, 119.999
        m.append((x, dy + np.cos(a) * (y - dy) - np.sin(a) * (z - dz)))
    m0, slope = np.array(m[0]), np.array(m[1]) - np.array(m[0])
    k = -(m0 @ slope) / (slope @ slope)
    assert k == pytest.approx(0.5518, abs=1e-4)
    assert so2008._samples(np.array([k]))[:, 0] == pytest.approx([0, 0.5, k, 2 * k - 0.5, 1])


def test_polar_form_of_equation_4_is_the_same_path(mikron):
    """r, phi, beta of eq. (3) as printed, for the table-table chain where G is zero (eq. 4)."""
    u = np.linspace(0, 1, 101)
    path = model_tip(mikron, TABLE_2, u)[0]
    turn = np.radians(TABLE_2[:, 3])
    m0, m1 = (
        np.array([p[0] * np.cos(t) + p[1] * np.sin(t), p[1] * np.cos(t) - p[0] * np.sin(t)])
        for p, t in zip(path[[0, -1]], turn, strict=True)
    )
    a, phi = np.linalg.norm(m1 - m0), np.arctan2(*(m1 - m0)[::-1])
    a0 = m0 @ (m1 - m0) / a
    d = (m0[1] * m1[0] - m0[0] * m1[1]) / a  # the paper's b, with the sign -s of its beta
    theta = turn[0] + u * (turn[1] - turn[0]) + phi + np.arctan2(d, a0 + u * a)
    r = np.hypot(a0 + u * a, d)
    assert np.stack([r * np.cos(theta), r * np.sin(theta)], axis=1) == pytest.approx(path[:, :2], abs=1e-10)


def test_near_the_pole_it_agrees_with_the_exact_deviation(kinematics):
    words = blocks_at(kinematics, tilt=1.0)
    exact, model = (
        measure(kinematics, words).line[1::2],
        measure(kinematics, words, method="so2008").line[1::2],
    )
    assert np.median((exact - model) / exact) < 2e-3
    assert (model <= exact * (1 + 1e-5) + 1e-6).all()  # a distance of the real path, so never more


def shortfall(kinematics, words, method):
    exact, model = measure(kinematics, words).line[1::2], measure(kinematics, words, method=method).line[1::2]
    assert (model <= exact * (1 + 1e-5) + 1e-6).all()
    return np.percentile((exact - model) / exact, 95)


@pytest.mark.parametrize("kind", ["table_table", "nutating", "head_table"])
def test_with_level_chords_the_form_with_n_is_right_and_with_climbing_ones_the_printed_form_is_nearer(kind):
    kinematics = kinematics_of(kind)
    level, climbing = (blocks_at(kinematics, tilt=1.0, count=600, level=level) for level in (True, False))
    one, two = (
        [shortfall(kinematics, words, method) for words in (level, climbing)]
        for method in ("so2008", "so2008-printed")
    )
    assert one[0] < 1e-4 < 0.05 < two[0]
    assert 5.0 * two[1] < one[1]


def test_samples_keep_a_tenth_of_the_block_from_its_ends():
    k = np.linspace(-3.0, 4.0, 1401)
    samples = so2008._samples(k)
    between = samples[1:4]
    assert between.min() >= 0.1 - 1e-12 and between.max() <= 0.9 + 1e-12
    assert (np.diff(samples, axis=0) > 0.0).all()


def test_samples_as_printed_are_those_of_table_1_wherever_they_differ():
    k = np.array([-1.0, 0.3, 0.4, 0.7, 2.5])
    h = np.abs(0.5 - k)
    below, above = (
        [0 * k, 0.5 - 2 * h, 0.5 - h, 0 * k + 0.5, 0 * k + 1],
        [0 * k, 0 * k + 0.5, 0.5 + h, 0.5 + 2 * h, 0 * k + 1],
    )
    assert so2008._samples(k, printed=True) == pytest.approx(np.where(k < 0.5, below, above))
    for meeting in (0.25, 0.75):  # 0.5 -+ 2h is an end of the block
        samples = np.sort(so2008._samples(np.array([meeting]), printed=True)[:, 0])
        assert np.diff(samples).min() > 1e-3


@pytest.mark.parametrize("printed", [False, True])
def test_no_two_samples_coincide_wherever_the_middle_lies(printed):
    """k = 0 or 1 (h = 0.5) puts 0.5 +- h onto an end as h = 0.25 does 0.5 +- 2h; the system of eq. (9) is
    then singular."""
    k = np.concatenate([[-0.25, 0.0, 0.25, 0.4, 0.6, 0.75, 1.0, 1.25], np.linspace(-3.0, 4.0, 701)])
    u = np.sort(so2008._samples(k, printed), axis=0)
    assert np.diff(u, axis=0).min() > 0.9 * so2008.APART
    assert np.isfinite(so2008._quartic_roots(u, np.ones_like(u))).all()


@pytest.mark.parametrize("kind", ["head_table", "head_head"])
def test_its_path_near_the_pole_follows_heads_too(kind):
    kinematics = kinematics_of(kind)
    words = blocks_at(kinematics, tilt=1.0)
    start, end = words[0::2], words[1::2]
    u = np.linspace(0, 1, 101)
    real, model = tip_at(kinematics, start, end, u[None]), model_tip(kinematics, words, u)[0::2]
    off = np.linalg.norm(real - model, axis=2).max(axis=1)
    reach = np.linalg.norm(real - real[:, :1], axis=2).max(axis=1)
    assert np.median(off / reach) < 1e-3


def test_it_fails_where_the_second_axis_turns_much():
    kinematics = kinematics_of("table_table")
    rng = np.random.default_rng(3)
    start = np.concatenate(
        [rng.uniform(-100, 100, (200, 3)), np.zeros((200, 1)), rng.uniform(-80, 0, (200, 1))], axis=1
    )
    words = interleaved(start, start + [0, 0, 0, 60.0, 90.0])
    exact, model = measure(kinematics, words), measure(kinematics, words, method="so2008")
    assert (exact.line - model.line)[1::2].max() > 1.0
    assert (exact.bound >= exact.segment).all()  # whatever the model says, the bound is the exact one
    assert np.array_equal(exact.bound, model.bound)


def test_a_circle_about_the_pole_has_its_farthest_point_in_the_middle():
    kinematics = kinematics_of("table_table")
    line, u, _ = line_deviation(kinematics, np.array([[75.0, -14, 0, 0, 0], [75, -14, 0, 40, 0]]))
    assert u[1] == 0.5
    assert line[1] == pytest.approx(80 * (1 - np.cos(np.radians(20))))


def test_straight_moves_and_empty_programs_have_no_deviation():
    kinematics = kinematics_of("head_table")
    for words in (
        np.zeros((0, 5)),
        np.zeros((1, 5)),
        np.array([[0.0, 0, 0, 20, 30], [5, 6, 7, 20, 30], [5, 6, 7, 20, 30]]),
    ):
        found = measure(kinematics, words, method="so2008")
        assert len(found.line) == len(words)
        assert not (found.line > 1e-11).any()
        assert found.findings == ()


def test_blocks_without_a_root_are_named(monkeypatch):
    kinematics = kinematics_of("table_table")
    monkeypatch.setattr(so2008, "_quartic_roots", lambda u, f: np.full((4, f.shape[1]), 2.0 + 0.0j))
    words = blocks_at(kinematics, tilt=1.0, count=5)
    found = measure(kinematics, words, method="so2008")
    assert [finding.code for finding in found.findings] == ["so2008-no-root"]
    assert found.findings[0].value == 9.0
    assert (found.u_line[1:] == 0.5).all()


def test_quartic_roots_are_those_of_the_polynomial():
    roots = np.array([[0.2, 0.4], [0.7, -1.0], [1.5, 3.0], [-2.0, 9.0]])
    u = np.linspace(0, 1, 5)[:, None] * np.ones(2)
    found = so2008._quartic_roots(u, 3.0 * np.prod(u[:, None] - roots[None], axis=1))
    assert np.sort(found.real, axis=0) == pytest.approx(np.sort(roots, axis=0), abs=1e-9)


def test_a_cubic_has_its_roots_too():
    u = np.linspace(0, 1, 5)[:, None]
    found = so2008._quartic_roots(u, (u - 0.3) * (u - 0.6) * (u + 2))[:, 0]
    within = found[np.abs(found) < 10]
    assert np.sort(within.real) == pytest.approx([-2.0, 0.3, 0.6], abs=1e-6)
