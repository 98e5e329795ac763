# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every machine file in resources/machines must do; a new file is found and held to it by itself."""

from __future__ import annotations

import math

import numpy as np
import pytest

from freecad_fiveaxis.core.machine import list_shipped_machines, load_machine, save_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, branch_of, chain, forward, inverse
from freecad_fiveaxis.core.machine.machine_file import machine_folder

ROWS = 500
CLOSE = 1e-9  # mm and rad

machines = pytest.mark.parametrize("name", sorted(path.stem for path in machine_folder().glob("*.fcm")))


@machines
def test_is_listed_under_its_own_name_with_a_description(name):
    machine = load_machine(name)
    assert name in list_shipped_machines()
    assert machine.name == name
    assert machine.description and machine.controller


@machines
def test_saved_and_loaded_again_it_is_the_same(name, tmp_path):
    machine = load_machine(name)
    save_machine(machine, tmp_path / "again.fcm")
    again = load_machine(tmp_path / "again.fcm")
    assert again == machine
    assert again.letters == machine.letters


@machines
def test_its_limits_and_rates_make_sense(name):
    for axis in load_machine(name).axes:
        assert axis.low <= 0.0 <= axis.high
        assert 0.0 < axis.max_rate < math.inf
        if not axis.rotary:
            assert axis.high - axis.low < 10_000  # a linear axis ends somewhere
        else:
            assert math.isfinite(axis.low) == math.isfinite(axis.high)


@machines
def test_its_limits_hold_the_upright_tool_at_the_work_zero(name):
    machine = load_machine(name)
    kinematics = chain(machine, Setup(machine.origin))
    assert (kinematics.low <= 0.0).all() and (kinematics.high >= 0.0).all()


@machines
def test_its_tilt_reaches_at_least_45_degrees_on_some_branch_in_every_direction(name):
    machine = load_machine(name)
    kinematics = chain(machine, Setup(machine.origin))
    heading = np.linspace(-np.pi, np.pi, 73)
    axis = np.column_stack([np.cos(heading), np.sin(heading), np.ones(73)]) / math.sqrt(2)
    both, _ = inverse(kinematics, np.zeros((73, 3)), axis)
    inside = ((both[:, :, 3:] >= kinematics.low[3:]) & (both[:, :, 3:] <= kinematics.high[3:])).all(axis=2)
    assert inside.any(axis=0).all()


@machines
@pytest.mark.parametrize(("origin", "length"), [((0.0, 0.0, 0.0), 0.0), ((35.0, -20.0, 80.0), 120.0)])
def test_forward_of_inverse_is_the_pose_on_both_branches(name, origin, length):
    kinematics = chain(load_machine(name), Setup(origin, length))
    rng = np.random.default_rng(20)
    q = np.column_stack([rng.uniform(-300, 300, (ROWS, 3)), rng.uniform(-np.pi, np.pi, (ROWS, 2))])
    tip, axis = forward(kinematics, q)
    both, _ = inverse(kinematics, tip, axis)
    assert np.isfinite(both).all()
    for branch, rows in enumerate(both):
        again = forward(kinematics, rows)
        np.testing.assert_allclose(again[0], tip, rtol=0, atol=CLOSE)
        np.testing.assert_allclose(again[1], axis, rtol=0, atol=CLOSE)
        np.testing.assert_array_equal(branch_of(kinematics, rows[:, 4]), branch)


@machines
def test_inverse_of_forward_holds_the_branch(name):
    kinematics = chain(load_machine(name), Setup((35.0, -20.0, 80.0), 120.0))
    rng = np.random.default_rng(21)
    q = np.column_stack([rng.uniform(-300, 300, (ROWS, 3)), rng.uniform(-3.1, 3.1, (ROWS, 2))])
    q[: ROWS // 2, 4] = rng.choice([-1, 1], ROWS // 2) * 10.0 ** rng.uniform(
        -15, -3, ROWS // 2
    )  # next to the pole
    both, _ = inverse(kinematics, *forward(kinematics, q))
    back = both[branch_of(kinematics, q[:, 4]), np.arange(ROWS)]
    np.testing.assert_allclose(back, q, rtol=0, atol=CLOSE)


@machines
def test_at_the_pole_every_first_word_gives_the_same_axis(name):
    kinematics = chain(load_machine(name), Setup((35.0, -20.0, 80.0), 120.0))
    q = np.zeros((9, 5))
    q[:, :3] = (10.0, 20.0, 30.0)
    q[:, 3] = np.linspace(-np.pi, np.pi, 9)
    tip, axis = forward(kinematics, q)
    np.testing.assert_array_equal(axis, np.tile((0.0, 0.0, 1.0), (9, 1)))
    both, sine = inverse(kinematics, tip, axis)
    assert not sine.any() and not both[:, :, 3:].any()
    for branch in both:
        np.testing.assert_allclose(forward(kinematics, branch)[0], tip, rtol=0, atol=CLOSE)
