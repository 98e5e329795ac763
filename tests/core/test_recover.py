# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines recovered from rows: against the machines that made them, LinuxCNC's formulas and So et al.'s
Table 2."""

import re
from dataclasses import replace

import numpy as np
import pytest
from bare_machines import BARE
from recover_examples import SETUP, TABLE_2, cl_path, line_errors, poses, posted, program
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.calibration.recover import (
    find_axis_step,
    parameters,
    recover,
    recovery_findings,
    rotary_letters,
)
from freecad_fiveaxis.core.calibration.recover.fit import refine_fit, screen_guess
from freecad_fiveaxis.core.calibration.recover.layouts import Guess, start_layout
from freecad_fiveaxis.core.calibration.recover.matching import (
    _table,
    _trace_matches,
    align_pairs,
    in_order,
    sequences,
)
from freecad_fiveaxis.core.calibration.recover.model import UNKNOWNS, rows_of
from freecad_fiveaxis.core.calibration.recover.pairs import Pairs, Steps, step_of
from freecad_fiveaxis.core.calibration.tasks import recover_machine
from freecad_fiveaxis.core.machine import Axis, Machine, load_machine, save_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward
from freecad_fiveaxis.core.pipeline.settings import build_settings

NEAR = 0.01  # mm, what is asked for


def codes(found, tolerance=0.01):
    return [one.code for one in recovery_findings(found, tolerance)]


def list_reported(found, tolerance=0.01):
    return " ".join(one.text for one in recovery_findings(found, tolerance))


# What is asked for


@pytest.mark.parametrize("start", [None, "mikron_ucp710"])
def test_table_2_gives_the_offsets_of_the_ucp_710_within_their_certainty(start):
    tip, axis, words = TABLE_2
    start = start and load_machine(start)
    found = recover(cl_path(tip, axis), program("XYZCA", words), start, axis_step=1e-7)
    values = {one.name: one for one in parameters(found)}
    for name, true in (
        ("C line, X", 0.0),
        ("C line, Y", 0.0),
        ("A line, Y", -49.934),
        ("A line, Z", 119.999),
    ):
        assert abs(values[name].value - true) <= values[name].certainty < 0.03
    assert values["A line, Z"].certainty > values["A line, Y"].certainty > 0.001  # A turns by 0.1 deg only
    assert found.fit.layout.kind == "table-table" and not found.others
    assert [axis.direction for axis in found.machine.rotary] == [(0, 0, 1), (1, 0, 0)]
    assert (
        found.fit.miss.max() < 1e-4 and not values["A line, Z"].certainty_free < 1.0
    )  # with zeros unknown nothing is left


@pytest.mark.parametrize("wrong", [0.0, 0.05])
@pytest.mark.parametrize("name", BARE)
def test_50_rows_of_every_shipped_machine_give_it_back(name, wrong, tmp_path):
    path, result, bad = posted(name, seed=7 if wrong else 3, wrong=wrong)
    found = recover(path, result, setup=SETUP)
    save_machine(found.machine, tmp_path / "m.fcm")
    assert line_errors(load_machine(tmp_path / "m.fcm"), load_machine(name)).max() < NEAR / 20
    np.testing.assert_array_equal(np.flatnonzero(~found.fit.good), bad)
    assert not found.others and {"poor-fit", "not-determined"}.isdisjoint(codes(found))


def test_plain_least_squares_would_be_misled_by_5_per_cent_of_wrong_rows():
    path, result, bad = posted("trunnion_ac", wrong=0.05)
    pairs = in_order(sequences(path, result, 1e-4))
    rows = rows_of(start_layout(load_machine("trunnion_ac")), pairs, np.zeros((2, 3)), np.zeros(UNKNOWNS))
    misled = np.linalg.lstsq(
        rows.jacobian[:, :3, :4].reshape(-1, 4), rows.residual[:, :3].reshape(-1), rcond=None
    )[0]
    assert len(bad) == 3 and np.abs(misled - (-10.0, 5.0, 5.0, -70.0)).max() > 1.0


def screened_fit(layout, pairs, base):
    return screen_guess(Guess(layout, (0.0, 0.0), 0.0), pairs, base, False)


# Second routes


def test_words_by_linuxcnc_s_own_formulas_give_its_offsets_and_its_signs():
    y, z = 23.0, -41.5
    tip, _ = poses(40, 5)
    rng = np.random.default_rng(6)
    a, c = (
        np.radians(np.round(np.degrees(rng.uniform(-0.8, 0.8, 40)), 4)),
        np.radians(np.round(rng.uniform(-180, 180, 40), 4)),
    )
    d = np.array([0.0, y, z])
    u = (
        np.column_stack(
            [
                np.cos(c) * tip[:, 0] - np.sin(c) * tip[:, 1],
                np.sin(c) * tip[:, 0] + np.cos(c) * tip[:, 1],
                tip[:, 2],
            ]
        )
        - d
    )
    joints = (
        np.column_stack(
            [u[:, 0], np.cos(a) * u[:, 1] - np.sin(a) * u[:, 2], np.sin(a) * u[:, 1] + np.cos(a) * u[:, 2]]
        )
        + d
    )
    k = np.column_stack(
        [np.sin(a) * np.sin(c), np.sin(a) * np.cos(c), np.cos(a)]
    )  # J = d + Rx(A)(Rz(C) P - d)
    words = np.round(np.column_stack([joints, np.degrees(a), np.degrees(c)]), 4)
    found = recover(cl_path(tip, np.round(k, 6)), program("XYZAC", words), axis_step=1e-6)
    assert [axis.direction for axis in found.machine.rotary] == [(0, 0, -1), (-1, 0, 0)]
    values = {one.name: one.value for one in parameters(found)}
    assert values["A line, Y"] == pytest.approx(y, abs=2e-3) and values["A line, Z"] == pytest.approx(
        z, abs=2e-3
    )
    assert codes(found).count("turns-against-iso") == 2


def test_words_by_5axiskins_give_its_pivot_length_and_a_fork():
    length = 173.25
    tip, _ = poses(40, 5)
    rng = np.random.default_rng(6)
    b, c = (
        np.radians(np.round(rng.uniform(-60, 60, 40), 4)),
        np.radians(np.round(rng.uniform(-180, 180, 40), 4)),
    )
    k = np.column_stack([-np.cos(c) * np.sin(b), -np.sin(c) * np.sin(b), np.cos(b)])  # Rz(C) Ry(-B) ez
    joints = tip - (0, 0, length) + length * k  # P = J + (0, 0, L) - L k
    words = np.round(np.column_stack([joints, np.degrees(b), np.degrees(c)]), 4)
    found = recover(cl_path(tip, np.round(k, 6)), program("XYZBC", words), axis_step=1e-6)
    assert (
        found.fit.layout.kind == "head-head" and "".join(axis.letter for axis in found.machine.rotary) == "CB"
    )
    assert [axis.direction for axis in found.machine.rotary] == [(0, 0, 1), (0, -1, 0)]
    assert found.machine.rotary[1].point == pytest.approx((0, 0, length), abs=1e-3)
    assert "tool-length-included" in codes(found)


@pytest.mark.parametrize("name", BARE)
def test_the_model_is_the_kinematics_and_its_derivative_that_of_differences(name):
    machine = load_machine(name)
    kinematics = chain(machine, SETUP)
    path, result, _ = posted(name, 12)
    q = np.column_stack([result.words[:, :3], np.radians(result.words[:, 3:])])
    tip, axis = forward(kinematics, q)
    pairs = in_order(sequences(replace(path, tip=tip, axis=axis), result, 1e-4))
    layout, base = start_layout(machine), np.array([kinematics.point1, kinematics.point2])
    rows = rows_of(layout, pairs, base, np.zeros(UNKNOWNS))
    assert np.abs(rows.residual).max() < 1e-10
    rng = np.random.default_rng(1)
    at, step = rng.uniform(-0.3, 0.3, UNKNOWNS), 1e-6
    jacobian = rows_of(layout, pairs, base, at).jacobian
    for k, way in enumerate(np.eye(UNKNOWNS) * step):
        ends = [rows_of(layout, pairs, base, at + sign * way).residual for sign in (-1, 1)]
        np.testing.assert_allclose((ends[0] - ends[1]) / (2 * step), jacobian[:, :, k], rtol=0, atol=1e-6)


@pytest.mark.thorough
def test_certainties_are_what_many_roundings_show():
    machine = load_machine("trunnion_bc")
    layout, base = start_layout(machine), np.zeros((2, 3))
    off, inside = [], []
    for seed in range(40):
        path, result, _ = posted("trunnion_bc", 20, seed)
        pairs = in_order(sequences(path, result, 1e-4))
        fit = refine_fit(screened_fit(layout, pairs, base), pairs, base)
        sigma = np.sqrt(np.diag(fit.covariance))[:4]
        error = fit.unknown[:4] - (-10.0, 5.0, -10.0, -80.0)
        off.append(error / sigma)
        inside.append(np.abs(error) < fit.factor * sigma)
    assert 0.7 < np.sqrt(np.mean(np.square(off))) < 1.3
    assert 0.9 < np.mean(inside) < 0.995


@pytest.mark.parametrize("coarse", ["tip", "axis", "linear", "rotary"])
def test_whitened_residuals_of_rounded_numbers_have_unit_covariance(coarse):
    """2000 roundings of one column each, of random poses: each of the six whitened residuals, and any two of
    them."""
    machine = load_machine("trunnion_ac")
    kinematics, layout = chain(machine, SETUP), start_layout(machine)
    fine = {
        "tip": 1e-4,
        "axis": 1e-7,
        "linear": 1e-4,
        "rotary": 1e-7,
    }  # the least that keeps the covariance regular
    steps = Steps(**{**fine, coarse: {"tip": 0.1, "axis": 1e-3, "linear": 0.1, "rotary": 1e-4}[coarse]})
    rng = np.random.default_rng(8)
    q = np.column_stack([rng.uniform(-100, 100, (2000, 3)), rng.uniform(-1, 1, (2000, 2))])
    tip, axis = forward(kinematics, q)
    tip, axis = (np.round(column / step) * step for column, step in ((tip, steps.tip), (axis, steps.axis)))
    linear, rotary = (
        np.round(column / step) * step
        for column, step in ((q[:, :3], steps.linear), (q[:, 3:], steps.rotary))
    )
    order = [kinematics.letters[3:].index(letter) for letter in sorted(kinematics.letters[3:])]
    pairs = Pairs(
        "AC", tip, axis, linear, rotary[:, order], np.arange(2000), np.arange(2000), steps, np.arange(2000)
    )
    rows = rows_of(layout, pairs, np.array([kinematics.point1, kinematics.point2]), np.zeros(UNKNOWNS))
    white = np.einsum("nij,nj->ni", rows.whitener, rows.residual)
    assert white.T @ white / 2000 == pytest.approx(np.eye(6), abs=0.15)


@pytest.mark.parametrize("seed", range(8))
def test_rows_and_blocks_are_aligned_as_the_best_of_all_pairings_in_order(seed):
    rng = np.random.default_rng(seed)
    alike = rng.uniform(0.0, 1.0, (5, 6)) * (rng.uniform(size=(5, 6)) < 0.7)

    def best(i, j):
        """Over all ways to pair the first i rows with the first j blocks, each at most once and in order."""
        if not i or not j:
            return 0.0
        return max(best(i - 1, j), max(best(i - 1, k) + alike[i - 1, k] for k in range(j)))

    assert _table(alike)[-1, -1] == pytest.approx(best(5, 6))
    rows, blocks = _trace_matches(alike)
    assert alike[rows, blocks].sum() == pytest.approx(best(5, 6))
    assert (np.diff(rows) > 0).all() and (np.diff(blocks) > 0).all()


# What else can be said


@some_in_core(
    ("name", "shift"),
    [
        ("trunnion_ac", (5.0, -3.0, 100.0, 0.0, 0.0)),
        ("head_b_table_c", (0.0, 0.0, 0.0, 0.5, 0.0)),
        ("nutating_table_b45", (0.0, 0.0, 0.0, 0.0, -0.2)),
        ("trunnion_bc", (1.0, 2.0, 3.0, 170.0, 0.3)),
    ],
    kept=(0, 2),
)
def test_shifted_zeros_are_found_and_named(name, shift):
    path, result, _ = posted(name, 50, 2, 0.05, shift)
    found = recover(path, result, setup=SETUP)
    values = [one.value for one in parameters(found)[4:]]
    assert line_errors(found.machine, load_machine(name)).max() < NEAR
    np.testing.assert_allclose(values, shift, rtol=0, atol=2e-3)
    named = [one for one in recovery_findings(found, 0.01) if one.code == "zero-elsewhere"]
    linear = np.count_nonzero(shift[:3])
    assert len(named) == min(linear, 1) + np.count_nonzero(shift[3:]) and "cannot hold" in named[0].text
    if linear > 1:  # one cause, told once, with every amount
        list_reported = [float(number) for number in re.findall(r"-?\d+\.\d{4}", named[0].text)]
        assert "work zero is shifted" in named[0].text
        np.testing.assert_allclose(list_reported, shift[:3], rtol=0, atol=2e-3)
        assert named[0].value == pytest.approx(np.linalg.norm(shift[:3]), abs=5e-3)


def test_a_machine_file_with_a_wrong_pivot_is_named_with_the_amount():
    path, result, _ = posted("mikron_ucp710")
    axes = [
        replace(axis, point=(0.0, -49.934, 120.064)) if axis.letter == "A" else axis
        for axis in load_machine("mikron_ucp710").axes
    ]
    found = recover(path, result, replace(load_machine("mikron_ucp710"), axes=tuple(axes)), SETUP)
    named = [one for one in recovery_findings(found, 0.01) if one.code == "post-and-machine-differ"]
    assert (
        len(named) == 1
        and named[0].severity is Severity.ERROR
        and named[0].value == pytest.approx(0.065, abs=1e-3)
    )
    assert named[0].text.startswith("A line, Z: the post has 119.99") and "0.0650 mm apart" in named[0].text
    same = recover(path, result, load_machine("mikron_ucp710"), SETUP)
    assert "post-and-machine-differ" not in codes(same) and same.start_miss < 1e-3
    assert same.machine.rotary[0].high == load_machine("mikron_ucp710").rotary[0].high  # limits are kept


def test_a_wrong_sign_and_a_wrong_kind_and_wrong_letters_are_named():
    path, result, _ = posted("linuxcnc_xyzac_trt")
    assert "A turns the other way: the post's positive A is the negative one of trunnion_ac" in list_reported(
        recover(path, result, load_machine("trunnion_ac"), SETUP)
    )
    path, result, _ = posted("fork_head_bc")
    assert "head-head, trunnion_bc is table-table" in list_reported(
        recover(path, result, load_machine("trunnion_bc"), SETUP)
    )
    assert "rotary words C and B, trunnion_ac has C and A" in list_reported(
        recover(path, result, load_machine("trunnion_ac"), SETUP)
    )


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_lean_that_is_not_among_the_layouts_comes_from_the_machine_given():
    lean = (0.0, np.sin(np.radians(40)), np.cos(np.radians(40)))
    base = load_machine("nutating_table_b45")
    axes = [
        replace(axis, direction=lean, point=(0.0, 3.0, -50.0)) if axis.letter == "B" else axis
        for axis in base.axes
    ]
    truth = replace(base, axes=tuple(axes))
    path, result, _ = posted(truth, lean=0.6)
    given = replace(
        truth, axes=tuple(replace(axis, point=(0.0, 0.0, 0.0)) if axis.rotary else axis for axis in axes)
    )
    assert line_errors(recover(path, result, given, SETUP).machine, truth).max() < NEAR
    assert "poor-fit" in codes(recover(path, result, None, SETUP))


@pytest.mark.oldest
@pytest.mark.thorough
def test_what_the_rows_do_not_determine_is_stated_and_kept_as_given():
    path, result, _ = posted("trunnion_ac")
    kinematics = chain(load_machine("trunnion_ac"), SETUP)
    words = result.words.copy()
    words[:, 4] = 0.0  # A never turns: its line cannot be known
    q = np.column_stack([words[:, :3], np.radians(words[:, 3:])])
    tip, axis = forward(kinematics, q)
    found = recover(
        replace(path, tip=np.round(tip, 4), axis=axis),
        program(result.letters, words),
        load_machine("trunnion_ac"),
        SETUP,
    )
    lost = [one for one in parameters(found) if one.name.startswith("A line")]
    assert not any(one.determined for one in lost) and all(one.apart < 1e-6 for one in lost)
    assert codes(found).count("not-determined") == 2
    without = recover(
        replace(path, tip=np.round(tip, 4), axis=axis), program(result.letters, words), None, SETUP
    )
    assert "layout-not-determined" in codes(without)  # how A turns is not known either


def test_rows_from_which_nothing_can_be_learnt_are_refused():
    path, result, _ = posted("trunnion_ac")
    words = result.words.copy()
    words[:, 3:] = 0.0
    with pytest.raises(ProgramError, match="rotary words never change"):
        recover(path, program(result.letters, words))
    words = result.words.copy()
    words[:, :3] = path.tip
    with pytest.raises(ProgramError, match="tool centre point control"):
        recover(path, program(result.letters, words))


@pytest.mark.slow
def test_a_program_of_another_path_is_a_poor_fit_or_refused():
    path, _, _ = posted("trunnion_ac", seed=1)
    _, result, _ = posted("trunnion_ac", seed=2)
    try:
        found = recover(path, result, setup=SETUP)
    except ProgramError as error:
        assert "give a program that was posted from this CL path" in str(error)
    else:
        assert "poor-fit" in codes(found)


@pytest.mark.thorough
def test_rows_with_an_upright_tool_do_not_look_like_tool_centre_point_control():
    path, result, _ = posted("trunnion_ac", 30)
    upright = np.arange(30) < 20
    words, axis = result.words.copy(), path.axis.copy()
    words[upright] = np.column_stack([path.tip[upright], np.zeros((20, 2))])
    axis[upright] = (0.0, 0.0, 1.0)
    found = recover(replace(path, axis=axis), program(result.letters, words), setup=SETUP)
    assert line_errors(found.machine, load_machine("trunnion_ac")).max() < NEAR


def test_an_inch_program_is_as_good_as_its_rounding():
    path, result, _ = posted("trunnion_ac")
    words = result.words.copy()
    words[:, :3] = np.round(words[:, :3] / 25.4, 4) * 25.4
    found = recover(path, program(result.letters, words), setup=SETUP)
    assert found.pairs.steps.linear == pytest.approx(25.4e-4) and 0.5 < found.fit.scale < 1.5
    assert line_errors(found.machine, load_machine("trunnion_ac")).max() < NEAR


@pytest.mark.slow
def test_axes_that_do_not_fit_and_numbers_beyond_any_machine_are_noticed():
    path, result, _ = posted("trunnion_ac", 20, 2)
    assert "poor-fit" in codes(
        recover(cl_path(path.tip, np.tile((1.0, 0.0, 0.0), (20, 1))), result)
    )  # the tips alone would fit
    huge = result.words.copy()
    huge[3, 0] = 1e200
    with pytest.raises(ProgramError, match="beyond any machine"):
        recover(path, program(result.letters, huge))
    with pytest.raises(ProgramError, match="only 1 of 1 CL rows"):
        recover(*posted("trunnion_ac", 1)[:2])


# Pairing


def test_blocks_of_the_post_s_own_and_rows_left_out_do_not_disturb_the_pairing():
    path, result, _ = posted("trunnion_bc", 120, 4)
    rng = np.random.default_rng(9)
    keep, extra = (
        np.setdiff1d(np.arange(120), rng.choice(120, 6, replace=False)),
        np.sort(rng.choice(110, 12)),
    )
    words = np.insert(result.words[keep], extra, np.round(rng.uniform(-90, 90, (12, 5)), 4), axis=0)
    truth = np.insert(keep, extra, -1)
    found = recover(path, program(result.letters, words), setup=SETUP)
    assert line_errors(found.machine, load_machine("trunnion_bc")).max() < NEAR
    right = truth[found.pairs.line - 10] == found.pairs.row
    assert right[found.fit.good].all() and found.fit.good.sum() > 100
    assert "blocks-without-row" in codes(found)


@pytest.mark.thorough
def test_a_program_that_comes_back_to_its_lines_counts_the_blocks_without_a_row():
    path, result, _ = posted("trunnion_bc", 120, 4)
    extra = np.arange(5, 100, 10)
    words = np.insert(
        result.words, extra, np.round(np.random.default_rng(9).uniform(-90, 90, (10, 5)), 4), axis=0
    )
    straight = program(result.letters, words)
    looped = replace(straight, line=10 + np.arange(130) % 13)
    skipped = [recover(path, one, setup=SETUP).skipped for one in (straight, looped)]
    assert skipped == [10, 10]


def test_rows_that_do_not_move_are_passed_over_as_posts_do():
    path, result, _ = posted("trunnion_bc", 30, 4)
    twice = np.sort(np.append(np.arange(30), [4, 4, 17]))
    doubled = replace(
        path,
        **{
            name: getattr(path, name)[twice]
            for name in ("tip", "axis", "motion", "feed", "contact", "normal", "face", "coedge", "pass_")
        },
    )
    pairs = in_order(sequences(doubled, result, 1e-4))
    np.testing.assert_array_equal(doubled.tip[pairs.row], path.tip)
    assert in_order(sequences(path, program(result.letters, result.words[:-1]), 1e-4)) is None
    assert len(align_pairs(sequences(path, program(result.letters, result.words[:-1]), 1e-4)).row) == 29


HAAS = Machine(
    "haas",
    (
        Axis("B", True, "table", (0.0, 0.0, 1.0), (3.0, 7.0, 0.0), max_rate=30.0),
        Axis("A", True, "table", (-1.0, 0.0, 0.0), (0.0, 4.0, -60.0), max_rate=30.0),
        *(
            Axis(letter, False, "head", way, max_rate=9000.0)
            for letter, way in zip("XYZ", ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), strict=True)
        ),
    ),
)
"""A about -X, B about Z: B is not the letter of its axis."""


@pytest.mark.oldest
@pytest.mark.thorough
def test_unusual_letters_with_rows_dropped_on_either_side():
    path, result, _ = posted(HAAS, 90, 6)
    rows, blocks = np.setdiff1d(np.arange(90), (7, 31, 32, 60)), np.setdiff1d(np.arange(90), (12, 45, 80))
    found = recover(
        cl_path(path.tip[rows], path.axis[rows]), program(result.letters, result.words[blocks]), setup=SETUP
    )
    np.testing.assert_array_equal(
        rows[found.pairs.row[found.fit.good]], blocks[found.pairs.line[found.fit.good] - 10]
    )
    assert found.fit.good.sum() > 70
    assert line_errors(found.machine, HAAS).max() < NEAR


@pytest.mark.thorough
def test_one_operation_is_found_in_the_whole_program():
    path, result, _ = posted("trunnion_ac", 1407, 8)
    one = slice(700, 985)
    found = recover(cl_path(path.tip[one], path.axis[one]), result, setup=SETUP)
    np.testing.assert_array_equal(
        found.pairs.row[found.fit.good] + 700, found.pairs.line[found.fit.good] - 10
    )
    assert found.fit.good.sum() > 250
    assert line_errors(found.machine, load_machine("trunnion_ac")).max() < NEAR


@pytest.mark.parametrize(
    ("controller", "on"),
    [("fanuc", "G43.4 H1"), ("siemens840d", "TRAORI"), ("heidenhain", "M128"), ("linuxcnc", "M428")],
)
def test_a_guided_program_is_refused_by_name(tmp_path, controller, on):
    apt, nc = tmp_path / "path.apt", tmp_path / "path.nc"
    apt.write_text(
        "UNITS/MM\nMULTAX/ON\nFEDRAT/800\nGOTO/0,0,60,0,0,1\nGOTO/10,0,40,0.1,0.2,0.974679434\nFINI\n"
    )
    lines = (
        ["L X0 Y0 Z60 A0 C0 FMAX", "L X10 Y0 Z40 A10 C20 F800"]
        if controller == "heidenhain"
        else ["G0 X0 Y0 Z60 A0 C0", "G1 X10 Z40 A10 C20 F800"]
    )
    head = ["BEGIN PGM T MM"] if controller == "heidenhain" else ["G21 G90"]
    nc.write_text(
        "\n".join([*head, on, *lines, "END PGM T MM" if controller == "heidenhain" else "M30"]) + "\n"
    )
    given = {"program": str(nc), "machine_file": str(tmp_path / "out.fcm"), "controller": controller}
    with pytest.raises(ProgramError, match=r"controller guides the tip .*post it again without"):
        recover_machine(build_settings("recover", str(apt), given))
    assert not (tmp_path / "out.fcm").exists()


# Texts


def test_steps_and_letters_are_read_from_what_is_printed():
    assert step_of(np.array([1.25, 3.0, -7.125])) == pytest.approx(1e-3)
    assert step_of(np.array([1.0, 0.0])) == 1e-3 and step_of(np.array([np.pi])) < 1e-8
    inch = np.round(np.random.default_rng(1).uniform(-5, 5, 20), 4) * 25.4
    assert step_of(inch) == pytest.approx(25.4e-4) and step_of(inch, False) == pytest.approx(1e-5)
    apt = b"GOTO/1.0,2,3\nGOTO / 1,2,3, 0.00959,.12, 0.9998268 $$ note 1.23456789012\n"
    assert find_axis_step(apt) == pytest.approx(1e-7) and find_axis_step(b"GOTO/1,2,3") == 1e-4
    assert rotary_letters(b"(B axis) G1 X1 A10. c-5 ; B7\n") == "AC" and rotary_letters(b"G1X1B=3C=5") == "BC"
    with pytest.raises(ProgramError, match="rotary words of C"):
        rotary_letters(b"G1 X1 C2")
    assert Steps().tip > 0.0


def test_a_recovered_machine_needs_no_start_to_be_saved(tmp_path):
    found = recover(*posted("head_b_table_c")[:2], setup=Setup())
    assert isinstance(found.machine, Machine) and isinstance(found.machine.axes[0], Axis)
    save_machine(found.machine, tmp_path / "a.fcm")
    assert load_machine(tmp_path / "a.fcm").axes == found.machine.axes
    assert "limits-unknown" in codes(found)


@pytest.mark.parametrize(
    ("start", "of"), [("fork_head_bc", None), ("trunnion_ac", "Limits of B are left open")]
)
def test_of_a_machine_that_has_other_letters_no_limits_are_known(start, of):
    found = recover(*posted("head_b_table_c")[:2], start=load_machine(start), setup=Setup())
    message = [finding.text for finding in recovery_findings(found, 0.01) if finding.code == "limits-unknown"]
    assert [text for text in message if of and of in text] == message and bool(message) == bool(of)
