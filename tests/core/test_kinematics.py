# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forward and inverse kinematics against published formulas, a published table, and a route by 4x4
matrices."""

from __future__ import annotations

import math

import numpy as np
import pytest
from bare_machines import BARE
from scipy.spatial.transform import Rotation

from freecad_fiveaxis.core.base.columns import CHUNK, cos_sin
from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.machine import Axis, Machine, load_machine
from freecad_fiveaxis.core.machine.kinematics import (
    Setup,
    branch_of,
    chain,
    forward,
    forward_tip,
    inverse,
    inverse_axis,
    joint_words,
    linear_words,
)
from freecad_fiveaxis.core.machine.kinematics import (
    serial_chain as formulas,
)

X, Y, Z = np.eye(3)
ROWS = 1000
CLOSE = 1e-9  # mm: what the formulas of other programs must agree to
ROUNDING = 1e-12  # of lengths up to a metre, and of angles
UNIT_ROUNDING = 2e-15  # of the components of a unit vector


def make(*axes, gauge_point=(0, 0, 0)):
    """A machine from (letter, side, direction, point) in the order from work to tool."""
    built = tuple(
        Axis(letter, letter in "ABC", side, tuple(direction), tuple(point))
        for letter, side, direction, point in axes
    )
    return Machine("test", built, gauge_point)


def linear(side):
    return [(letter, side, axis, (0, 0, 0)) for letter, axis in zip("XYZ", np.eye(3), strict=True)]


def words(rng, rows=ROWS, span=300.0):
    return np.column_stack([rng.uniform(-span, span, (rows, 3)), rng.uniform(-np.pi, np.pi, (rows, 2))])


def turn_about(axis, angle):
    return Rotation.from_rotvec(np.outer(angle, axis))


def angle_between(a, b):
    return np.abs((a - b + np.pi) % (2 * np.pi) - np.pi)


# Against LinuxCNC's own formulas. J joints, P tip in the work.


def test_xyzac_trt_agrees_with_linuxcnc():
    rng = np.random.default_rng(1)
    q, tool, y, z, r = words(rng), 40.0, 20.0, 10.0, np.array((7.0, -5.0, 3.0))
    a, c = q[:, 4], q[:, 3]
    d = np.array((0, y, z + tool))
    tip = r + turn_about(Z, -c).apply(d + turn_about(X, -a).apply(q[:, :3] - r - d))
    axis = np.column_stack([np.sin(a) * np.sin(c), np.sin(a) * np.cos(c), np.cos(a)])
    machine = make(("C", "table", -Z, r), ("A", "table", -X, r + d), *linear("head"))
    check_against(chain(machine, Setup()), q, tip, axis)


def test_xyzbc_trt_agrees_with_linuxcnc():
    rng = np.random.default_rng(2)
    q, tool, x, z, r = words(rng), 25.0, -20.0, -15.0, np.array((1.0, 2.0, -30.0))
    b, c = q[:, 4], q[:, 3]
    d = np.array((x, 0, z + tool))
    tip = r + turn_about(Z, -c).apply(d + turn_about(Y, -b).apply(q[:, :3] - r - d))
    axis = np.column_stack([-np.sin(b) * np.cos(c), np.sin(b) * np.sin(c), np.cos(b)])
    machine = make(("C", "table", -Z, r), ("B", "table", -Y, r + d), *linear("head"))
    check_against(chain(machine, Setup()), q, tip, axis)


@pytest.mark.parametrize(
    ("name", "offset"), [("linuxcnc_xyzac_trt", (0, 20, 10)), ("linuxcnc_xyzbc_trt", (-20, 0, -15))]
)
def test_the_shipped_linuxcnc_machines_have_the_offsets_of_its_simulation(name, offset):
    q = words(np.random.default_rng(3))
    tilt_axis = X if "xyzac" in name else Y
    d = np.array(offset)
    tip = turn_about(Z, -q[:, 3]).apply(d + turn_about(tilt_axis, -q[:, 4]).apply(q[:, :3] - d))
    axis = turn_about(Z, -q[:, 3]).apply(turn_about(tilt_axis, -q[:, 4]).apply(Z))
    check_against(chain(load_machine(name), Setup()), q, tip, axis)


def test_5axiskins_agrees_with_linuxcnc():
    rng = np.random.default_rng(4)
    q, pivot, tool = words(rng), 250.0, 63.0
    axis = turn_about(Z, q[:, 3]).apply(turn_about(Y, -q[:, 4]).apply(Z))
    tip = q[:, :3] + (pivot + tool) * Z - (pivot + tool) * axis
    machine = make(*linear("head"), ("C", "head", Z, (0, 0, 0)), ("B", "head", -Y, (0, 0, pivot)))
    check_against(chain(machine, Setup(tool_length=tool)), q, tip, axis)


def test_maxkins_inverse_agrees_with_linuxcnc():
    rng = np.random.default_rng(5)
    angles, tip, lever = rng.uniform(-np.pi, np.pi, (ROWS, 2)), rng.uniform(-300, 300, (ROWS, 3)), 180.0
    c, b = angles.T
    joints = turn_about(Z, -c).apply(tip) + lever * turn_about(Y, -b).apply(Z) - lever * Z
    machine = make(("C", "table", Z, (0, 0, 0)), *linear("head"), ("B", "head", -Y, (0, 0, lever)))
    axis = turn_about(Z, c).apply(turn_about(Y, -b).apply(Z))
    check_against(chain(machine, Setup()), np.column_stack([joints, angles]), tip, axis)


def check_against(kinematics, q, tip, axis):
    """Forward gives tip and axis; inverse gives q back on its branch, and the same pose on both."""
    got_tip, got_axis = forward(kinematics, q)
    np.testing.assert_allclose(got_tip, tip, rtol=0, atol=CLOSE)
    np.testing.assert_allclose(got_axis, axis, rtol=0, atol=CLOSE)
    both, _ = inverse(kinematics, tip, axis)
    back = both[branch_of(kinematics, q[:, 4]), np.arange(len(q))]
    np.testing.assert_allclose(back[:, :3], q[:, :3], rtol=0, atol=CLOSE)
    assert angle_between(back[:, 3:], q[:, 3:]).max() < CLOSE
    for words_of_branch in both:
        again = forward(kinematics, words_of_branch)
        np.testing.assert_allclose(again[0], tip, rtol=0, atol=CLOSE)
        np.testing.assert_allclose(again[1], axis, rtol=0, atol=CLOSE)


def test_the_comparison_sees_a_wrong_sign():
    q = words(np.random.default_rng(6))
    machine = make(("C", "table", Z, (0, 0, 0)), ("A", "table", -X, (0, 20, 10)), *linear("head"))
    right = make(("C", "table", -Z, (0, 0, 0)), ("A", "table", -X, (0, 20, 10)), *linear("head"))
    with pytest.raises(AssertionError):
        check_against(chain(machine, Setup()), q, *forward(chain(right, Setup()), q))


# Against So et al. 2008, Table 2.

CL_ROWS = np.array(
    [
        (75.2110, -51.4295, 228.6808, 0.0095944, 0.0159479, 0.9998268),
        (74.5130, -50.5510, 228.6857, 0.0175393, 0.0107682, 0.9997882),
    ]
)
NC_ROWS = np.array(
    [(-90.9595, 7.3103, 227.6341, 148.9685, 1.0664), (-82.0656, -34.8175, 228.3975, 121.5477, 1.1793)]
)


def test_table_2_of_so_et_al_goes_both_ways():
    kinematics = chain(load_machine("mikron_ucp710"), Setup())
    both, _ = inverse(kinematics, CL_ROWS[:, :3], CL_ROWS[:, 3:])
    np.testing.assert_allclose(formulas.q_to_words(both[0]), NC_ROWS, atol=1e-3)
    tip, axis = forward(kinematics, formulas.words_to_q(NC_ROWS))
    np.testing.assert_allclose(tip, CL_ROWS[:, :3], atol=1e-3)
    np.testing.assert_allclose(axis, CL_ROWS[:, 3:], atol=1e-6)


# Against 4x4 matrices built axis by axis as the iron moves: the table's axes move the work the other way.


def by_matrices(machine, setup, q):
    """Tip and axis for one row of words, by homogeneous matrices and the joints' real positions."""
    origin = np.array(setup.origin)
    tip = np.array(machine.gauge_point) - (0, 0, setup.tool_length)
    directions = np.array([axis.direction for axis in sorted(machine.linear, key=lambda axis: axis.letter)])
    joints = q[:3] + np.linalg.inv(directions.T) @ (origin - tip)
    value = dict(zip("XYZ", joints, strict=True)) | {
        axis.letter: angle for axis, angle in zip(machine.rotary, q[3:], strict=True)
    }
    machine_from_work, machine_from_tool = np.eye(4), np.eye(4)
    for axis in reversed(
        [axis for axis in machine.axes if axis.side == "table"]
    ):  # from the base to the work
        machine_from_work = machine_from_work @ motion(axis, -value[axis.letter])
    for axis in [axis for axis in machine.axes if axis.side == "head"]:  # from the base to the tool
        machine_from_tool = machine_from_tool @ motion(axis, value[axis.letter])
    machine_from_work = machine_from_work @ shift(origin)
    work_from_tool = np.linalg.inv(machine_from_work) @ machine_from_tool @ shift(tip)
    return work_from_tool[:3, 3], work_from_tool[:3, 2]


def motion(axis, value):
    if not axis.rotary:
        return shift(np.array(axis.direction) * value)
    turn = np.eye(4)
    turn[:3, :3] = Rotation.from_rotvec(np.array(axis.direction) * value).as_matrix()
    return shift(np.array(axis.point)) @ turn @ shift(-np.array(axis.point))


def shift(by):
    matrix = np.eye(4)
    matrix[:3, 3] = by
    return matrix


def check_by_matrices(machine, setup, rng, rows):
    q = words(rng, rows)
    tip, axis = forward(chain(machine, setup), q)
    expected = [by_matrices(machine, setup, row) for row in q]
    np.testing.assert_allclose(tip, [pair[0] for pair in expected], rtol=0, atol=CLOSE)
    np.testing.assert_allclose(axis, [pair[1] for pair in expected], rtol=0, atol=CLOSE)


@pytest.mark.parametrize("name", BARE)
def test_forward_is_the_motion_of_the_iron(name):
    check_by_matrices(load_machine(name), Setup((12.0, -7.0, 31.0), 85.0), np.random.default_rng(7), 50)


def leaning(rng):
    vector = rng.normal(size=3)
    return tuple(vector / np.linalg.norm(vector))


def random_machine(rng):
    """Any order of the axes, any directions and points, the split between table and head anywhere."""
    letters = rng.permutation([*"XYZ", *rng.permutation([*"ABC"])[:2]])
    split = rng.integers(0, 6)
    return make(
        *(
            (str(letter), "table" if i < split else "head", leaning(rng), rng.uniform(-90, 90, 3))
            for i, letter in enumerate(letters)
        ),
        gauge_point=tuple(rng.uniform(-90, 90, 3)),
    )


@pytest.mark.parametrize("seed", range(30))
def test_any_chain_forward_is_the_motion_of_the_iron(seed):
    rng = np.random.default_rng(seed)
    check_by_matrices(random_machine(rng), Setup(tuple(rng.uniform(-90, 90, 3)), rng.uniform(0, 90)), rng, 10)


@pytest.mark.parametrize("seed", range(30))
def test_any_chain_inverse_gives_the_pose_back_on_both_branches(seed):
    rng = np.random.default_rng(seed)
    machine = random_machine(rng)
    kinematics = chain(machine, Setup(tuple(rng.uniform(-90, 90, 3)), rng.uniform(0, 90)))
    q = words(rng, 200)
    tip, axis = forward(kinematics, q)
    both, sine = inverse(kinematics, tip, axis)
    back = both[branch_of(kinematics, q[:, 4]), np.arange(len(q))]
    plain = (
        sine > 1e-3
    )  # the angles are ill-conditioned next to the pole and the rim of the reach, the pose never is
    assert angle_between(back[plain, 3:], q[plain, 3:]).max() < 1e-9
    for branch in both:
        flat = np.isnan(branch[:, 0])
        assert not flat.any()
        again_tip, again_axis = forward(kinematics, branch)
        np.testing.assert_allclose(again_axis, axis, rtol=0, atol=1e-14)
        largest = np.abs(branch[:, :3]).max()  # nearly flat linear axes make long words
        np.testing.assert_allclose(again_tip, tip, rtol=0, atol=1e-12 * largest)


def test_measure_is_how_fast_the_axis_leaves_the_cone_of_the_first_axis():
    rng = np.random.default_rng(8)
    for seed in range(10):
        kinematics = chain(random_machine(np.random.default_rng(seed)), Setup())
        q = words(rng, 100)
        axis = forward(kinematics, q)[1]
        a1, k = kinematics.direction[3], axis
        a2 = turn_about(a1, q[:, 3]).apply(kinematics.direction[4])
        np.testing.assert_allclose(
            inverse_axis(kinematics, axis)[1], np.abs(np.cross(a2, k) @ a1), rtol=0, atol=1e-7
        )


# At the pole and next to it.


@pytest.mark.parametrize("name", BARE)
@pytest.mark.parametrize("exponent", range(-15, -5))
def test_next_to_the_pole_inverse_is_exact(name, exponent):
    kinematics = chain(load_machine(name), Setup((3.0, -4.0, 5.0), 60.0))
    rng = np.random.default_rng(9)
    q = words(rng, 200)
    q[:, 4] = np.where(rng.random(200) < 0.5, 1, -1) * rng.uniform(1, 10, 200) * 10.0**exponent
    tip, axis = forward(kinematics, q)
    both, sine = inverse(kinematics, tip, axis)
    back = both[branch_of(kinematics, q[:, 4]), np.arange(200)]
    assert np.array_equal(branch_of(kinematics, q[:, 4]), (q[:, 4] < 0).astype(int))
    np.testing.assert_allclose(back[:, 4], q[:, 4], rtol=1e-9)
    assert angle_between(back[:, 3], q[:, 3]).max() < 1e-9
    np.testing.assert_allclose(back[:, :3], q[:, :3], rtol=0, atol=1e-9)
    assert (sine > 0).all()
    for branch in both:
        np.testing.assert_allclose(forward(kinematics, branch)[1], axis, rtol=0, atol=UNIT_ROUNDING)
        np.testing.assert_allclose(forward(kinematics, branch)[0], tip, rtol=0, atol=ROUNDING)


@pytest.mark.parametrize("name", BARE)
def test_axes_with_tiny_components_keep_their_direction(name):
    kinematics = chain(load_machine(name), Setup())
    heading = np.linspace(-np.pi, np.pi, 101)
    for tilt in (1e-6, 1e-9, 1e-12, 1e-15, 1e-100):
        axis = np.column_stack([tilt * np.cos(heading), tilt * np.sin(heading), np.ones(101)])
        for angles in inverse_axis(kinematics, axis)[0]:
            got = forward(kinematics, np.column_stack([np.zeros((101, 3)), angles]))[1]
            np.testing.assert_allclose(got[:, :2], axis[:, :2], rtol=0, atol=1e-12 * tilt)
            np.testing.assert_allclose(got[:, 2], 1.0, rtol=0, atol=tilt * tilt + UNIT_ROUNDING)


@pytest.mark.parametrize("name", BARE)
def test_at_the_pole_the_first_word_is_zero_and_both_branches_agree(name):
    kinematics = chain(load_machine(name), Setup((1.0, 2.0, 3.0), 40.0))
    tip = np.array([(10.0, 20.0, 30.0)])
    both, sine = inverse(kinematics, tip, np.array([(0.0, 0.0, 1.0)]))
    assert sine[0] == 0.0
    np.testing.assert_allclose(both[0], [(10.0, 20.0, 30.0, 0.0, 0.0)], rtol=0, atol=ROUNDING)
    np.testing.assert_array_equal(both[:, :, 3:], 0.0)
    np.testing.assert_array_equal(both[0], both[1])
    assert not np.signbit(both[:, :, 3:]).any()


def test_a_tool_pointing_up_is_the_other_pole_of_a_straight_machine():
    kinematics = chain(load_machine("trunnion_ac"), Setup())
    both, sine = inverse(kinematics, np.zeros((1, 3)), np.array([(0.0, 0.0, -1.0)]))
    assert sine[0] == 0.0
    np.testing.assert_array_equal(both[:, 0, 3:], [(0.0, np.pi)] * 2)


def test_rotary_words_lie_in_the_half_open_turn():
    heading = np.radians(np.arange(-360, 361, 45))
    tilt = np.radians(np.arange(-180, 181, 45))[:, None]
    axis = np.stack(
        [np.sin(tilt) * np.cos(heading), np.sin(tilt) * np.sin(heading), np.cos(tilt) + 0 * heading], -1
    ).reshape(-1, 3)
    axis = np.concatenate([np.round(axis, 15), -0.0 - np.round(axis, 15)])  # exact zeros of both signs
    for name in BARE:
        angles, _ = inverse_axis(chain(load_machine(name), Setup()), axis)
        reached = ~np.isnan(angles)
        assert (angles[reached] > -np.pi).all() and (angles[reached] <= np.pi).all()


def test_a_machine_whose_pole_is_off_zero_tilt():
    """A carries B, both on the table: the tool axis is parallel to the first rotary axis B at A = 90 deg
    only."""
    machine = make(("B", "table", Y, (0, 0, 10)), ("A", "table", X, (0, 0, -10)), *linear("head"))
    kinematics = chain(machine, Setup())
    both, sine = inverse(kinematics, np.zeros((1, 3)), Y[None])
    assert sine[0] == 0.0
    assert both[0, 0, 4] == pytest.approx(-np.pi / 2, abs=1e-15)
    assert branch_of(kinematics, np.radians([-80.0, -100.0, 280.0, 260.0])).tolist() == [0, 1, 0, 1]


def test_branches_hold_over_windings():
    kinematics = chain(load_machine("trunnion_ac"), Setup())
    turns = 2 * np.pi * np.arange(-3, 4)
    assert branch_of(kinematics, 0.3 + turns).tolist() == [0] * 7
    assert branch_of(kinematics, -0.3 + turns).tolist() == [1] * 7


# Beyond reach, and other rows without an answer.


def test_the_nutating_table_reaches_the_upper_half_and_nothing_else():
    kinematics = chain(load_machine("nutating_table_b45"), Setup())
    tilt = np.radians([0, 45, 89.9, 90, 90.1, 135, 180])
    axis = np.column_stack([np.sin(tilt), np.zeros(7), np.cos(tilt)])
    both, sine = inverse(kinematics, np.ones((7, 3)), axis)
    assert np.isnan(both).all(axis=(0, 2)).tolist() == [False] * 4 + [True] * 3
    assert np.isnan(both).any(axis=(0, 2)).tolist() == [False] * 4 + [True] * 3
    assert np.isnan(sine).tolist() == [False] * 4 + [True] * 3
    np.testing.assert_allclose(forward(kinematics, both[0, :4])[1], axis[:4], atol=UNIT_ROUNDING)
    b = np.arccos(2 * np.cos(tilt[:3]) - 1)  # by hand: a cone of 45 deg has cos tilt = (1 + cos b) / 2
    np.testing.assert_allclose(both[0, :3, 4], b, rtol=0, atol=1e-12)
    assert both[0, 3, 4] == pytest.approx(
        np.pi, abs=1e-7
    )  # on the rim of the reach the angle is free to first order


@pytest.mark.parametrize(
    ("beyond", "reached"),
    [(-1e-6, True), (0.0, True), (1e-13, True), (1e-9, False), (1e-6, False), (3e-5, False)],
)
def test_an_axis_beyond_the_rim_of_the_reach_by_more_than_rounding_is_out_of_reach(beyond, reached):
    """On the rim a table of 45 deg leans the tool by 90 deg; an axis beyond it by ``beyond`` rad is another
    axis."""
    kinematics = chain(load_machine("nutating_table_b45"), Setup())
    axis = np.array([[np.cos(beyond), 0.0, -np.sin(beyond)]])
    words, _ = inverse_axis(kinematics, axis)
    assert np.isfinite(words).all() == reached and np.isfinite(words).any() == reached
    if reached:
        place = np.column_stack([np.zeros((1, 3)), words[0]])
        assert forward(kinematics, place)[1] == pytest.approx(axis, abs=1e-12)


@pytest.mark.parametrize("name", BARE)
def test_rows_of_nan_stay_nan_and_leave_the_others_alone(name):
    kinematics = chain(load_machine(name), Setup())
    tip, axis = np.ones((3, 3)), np.tile((0.6, 0.0, 0.8), (3, 1))
    axis[1] = np.nan
    both, sine = inverse(kinematics, tip, axis)
    assert np.isnan(both[:, 1]).all() and np.isnan(sine[1])
    np.testing.assert_array_equal(both[:, 0], both[:, 2])
    assert np.isfinite(both[:, 0]).all()
    axis[1] = 0.0  # no direction at all
    assert np.isnan(inverse(kinematics, tip, axis)[0][:, 1]).all()
    assert np.isnan(forward(kinematics, both[0])[0][1]).all()


def test_linear_axes_that_lie_flat_give_nan():
    """Z between the rotary axes, X before them: at B = 90 deg the table has brought Z along X."""
    machine = make(("X", "table", X, (0, 0, 0)), ("B", "table", Y, (0, 0, 0)), ("Z", "table", Z, (0, 0, 0)),
                   ("Y", "head", Y, (0, 0, 0)), ("A", "head", X, (0, 0, 0)))  # fmt: skip
    kinematics = chain(machine, Setup())
    assert kinematics.slot == (0, 1, 1)
    got = linear_words(kinematics, np.ones((2, 3)), np.array([(0.0, 0.3), (np.pi / 2, 0.3)]))
    assert np.isfinite(got[0]).all() and np.isnan(got[1]).all()


def test_empty_input_is_empty_output():
    kinematics = chain(load_machine("fork_head_bc"), Setup())
    none = np.empty((0, 3))
    assert forward(kinematics, np.empty((0, 5)))[0].shape == (0, 3)
    assert inverse(kinematics, none, none)[0].shape == (2, 0, 5)
    assert linear_words(kinematics, none, np.empty((0, 2))).shape == (0, 3)


# The pieces that other modules use.


@pytest.mark.parametrize("name", BARE)
def test_linear_words_are_those_of_inverse_at_any_winding(name):
    kinematics = chain(load_machine(name), Setup((5.0, 6.0, 7.0), 90.0))
    rng = np.random.default_rng(10)
    tip, axis = forward(kinematics, words(rng, 300))
    both, _ = inverse(kinematics, tip, axis)
    for branch in both:
        turned = branch[:, 3:] + 2 * np.pi * rng.integers(-3, 4, (300, 2))
        np.testing.assert_allclose(linear_words(kinematics, tip, turned), branch[:, :3], rtol=0, atol=1e-10)
        np.testing.assert_array_equal(inverse_axis(kinematics, axis)[0][0], both[0][:, 3:])


def test_with_rotary_words_zero_the_linear_words_are_the_work_coordinates():
    for name in BARE:
        q = np.array([(11.0, 22.0, 33.0, 0.0, 0.0)])
        tip, axis = forward(chain(load_machine(name), Setup((40.0, 50.0, 60.0), 70.0)), q)
        np.testing.assert_allclose(tip, q[:, :3], atol=ROUNDING)
        np.testing.assert_array_equal(axis, [(0, 0, 1)])


def test_memory_order_and_chunks_make_no_difference():
    kinematics = chain(load_machine("trunnion_bc"), Setup())
    q = words(np.random.default_rng(11), CHUNK + 7)
    tip, axis = forward(kinematics, q)
    for order in "CF":
        again = forward(kinematics, np.array(q, order=order))
        np.testing.assert_array_equal(again, (tip, axis))
        both = inverse(kinematics, np.array(tip, order=order), np.array(axis, order=order))[0]
        one = inverse(kinematics, tip[-9:], axis[-9:])[0]
        np.testing.assert_allclose(both[:, -9:], one, rtol=0, atol=ROUNDING)
    assert tip.flags.f_contiguous and both[0].flags.f_contiguous


def test_degrees_are_only_the_rotary_columns():
    q = np.array([(1.0, 2.0, 3.0, np.pi, -np.pi / 2)])
    np.testing.assert_allclose(formulas.q_to_words(q), [(1, 2, 3, 180, -90)])
    np.testing.assert_allclose(formulas.words_to_q(formulas.q_to_words(q)), q)
    assert q[0, 3] == np.pi


def test_limits_are_of_the_words():
    """The joints stand at the words moved by work zero and tool length; a rotary joint is its word."""
    axes = list(make(("C", "table", Z, (0, 0, 0)), ("A", "table", X, (0, 0, 0)), *linear("head")).axes)
    axes[4] = Axis("Z", False, "head", (0, 0, 1), low=-400.0, high=0.0)
    axes[1] = Axis("A", True, "table", (1, 0, 0), low=-1.0, high=2.0)
    kinematics = chain(
        Machine("test", tuple(axes), gauge_point=(0, 0, 500)), Setup((10.0, 20.0, 30.0), 100.0)
    )
    assert kinematics.letters == "XYZCA"
    assert (kinematics.low[2], kinematics.high[2]) == (-400 + 500 - 100 - 30, 500 - 100 - 30)
    assert (kinematics.low[4], kinematics.high[4]) == (-1.0, 2.0)


@pytest.mark.parametrize(
    ("axes", "problem"),
    [
        ((("C", "table", Z, (0, 0, 0)), ("A", "table", (0, 0, -1), (0, 0, 0)), *linear("head")), "parallel"),
        ((("A", "table", X, (0, 0, 0)), ("C", "table", Z, (0, 0, 0)), *linear("head")), "never tilts"),
        (
            (
                ("C", "table", Z, (0, 0, 0)),
                ("A", "table", X, (0, 0, 0)),
                *linear("head")[:2],
                ("Z", "head", X, (0, 0, 0)),
            ),
            "plane",
        ),
    ],
)
def test_a_chain_without_a_solution_is_refused(axes, problem):
    with pytest.raises(MachineError, match=problem):
        chain(make(*axes), Setup())


def test_turn_is_rodrigues():
    rng = np.random.default_rng(12)
    vectors, angle, axis = rng.normal(size=(50, 3)), rng.uniform(-4, 4, 50), np.array(leaning(rng))
    got = formulas.turn(vectors, axis, np.cos(angle), np.sin(angle))
    np.testing.assert_allclose(got, turn_about(axis, angle).apply(vectors), atol=1e-14)


def test_a_quarter_turn_by_hand():
    """ISO 841: C90 takes the tool from the work's x to its y side; A90 lays the tool's axis from z to -y of
    the work."""
    kinematics = chain(
        make(("C", "table", Z, (0, 0, 0)), ("A", "table", X, (0, 0, 0)), *linear("head")), Setup()
    )
    tip, axis = forward(
        kinematics, np.array([(10.0, 0.0, 0.0, math.pi / 2, 0.0), (0.0, 0.0, 5.0, 0.0, math.pi / 2)])
    )
    np.testing.assert_allclose(tip, [(0, 10, 0), (0, -5, 0)], atol=ROUNDING)
    np.testing.assert_allclose(axis, [(0, 0, 1), (0, -1, 0)], atol=ROUNDING)


def test_cosine_and_sine_through_the_tangent_are_right_to_rounding_at_any_angle():
    quarters = np.arange(-9, 10) * 0.5 * np.pi
    angle = np.concatenate(
        [np.random.default_rng(4).uniform(-50.0, 50.0, 20_000), quarters, quarters + 1e-9, quarters - 1e-9]
    )
    cos, sin = cos_sin(angle)
    np.testing.assert_allclose(cos, [math.cos(one) for one in angle], rtol=0, atol=5e-16)
    np.testing.assert_allclose(sin, [math.sin(one) for one in angle], rtol=0, atol=5e-16)
    small = np.array([0.0, 1e-300, -1e-9, 1e-5])
    np.testing.assert_allclose(cos_sin(small)[1], small, rtol=1e-10)


@pytest.mark.parametrize("name", BARE)
def test_the_tip_alone_and_all_words_are_those_of_forward_and_linear_words(name):
    kinematics = chain(load_machine(name), Setup((1.0, 2.0, 3.0), 100.0))
    q = np.random.default_rng(3).uniform(-1.0, 1.0, (50, 5)) * [100.0, 100.0, 100.0, 3.0, 1.0]
    tip = forward_tip(kinematics, q)
    np.testing.assert_array_equal(tip, forward(kinematics, q)[0])
    words = joint_words(kinematics, tip, q[:, 3:])
    np.testing.assert_array_equal(words[:, 3:], q[:, 3:])
    np.testing.assert_allclose(words, q, rtol=0, atol=1e-9)
