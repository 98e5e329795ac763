# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rapids whose axes run independently: closed forms, dense simulation over random rates, and a bound that is
too small on purpose."""

import dataclasses

import numpy as np
import pytest
from mesh_shapes import box
from rapid_simulation import points_of, simulated
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import MachineError, SettingsError
from freecad_fiveaxis.core.base.rapids import INDEPENDENT, INTERPOLATED, RAPIDS, UNKNOWN
from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.controllers import DIALECTS, find_dialect
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge import check_program, find_entries, real_motion
from freecad_fiveaxis.core.gouge.joint_box import JointBoxes, JointSpace
from freecad_fiveaxis.core.gouge.rapid_check import independent_rapids
from freecad_fiveaxis.core.gouge.rapid_ways import RELATIVE, boxes_of, find_way_entries
from freecad_fiveaxis.core.machine import load_machine, save_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.options import rapids_of
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report.part_facts import part_numbers, part_verdict
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import body_of, depth_of, support

LIMIT = 0.01
BLOCK = from_triangles(box((-20.0, -20.0, 0.0), (20.0, 20.0, 20.0)))
"""40 x 40 x 20 mm on Z 0 to 20."""
OVER = ("G90 G21", "G0 Z60 A0 C0", "G0 X-60 Y0", "G0 X-60 Y0 Z60 A0 C0", "G0 X60 Z10", "G93 G1 Z9 F10", "M30")
"""Straight from one side of the block to the other it is clear by far; with equal rates Z is at 10 when X is
at -10."""
MACHINES = ("trunnion_ac", "fork_head_bc", "head_b_table_c", "nutating_table_b45")


@pytest.fixture
def audited(tmp_path):
    """An audit of the program against the block."""
    write_stl(BLOCK, tmp_path / "block.stl")
    (tmp_path / "over.ngc").write_text("\n".join(OVER) + "\n", encoding="utf-8")

    def run(**options):
        given = {
            "machine": "trunnion_ac",
            "against": str(tmp_path / "block.stl"),
            "cutter": "ball:10",
            **options,
        }
        return job.run(build_settings("audit", str(tmp_path / "over.ngc"), given))

    return run


def codes(result):
    return [one.code for one in result.findings]


@pytest.mark.parametrize("controller", ["fanuc", "haas"])
def test_a_rapid_that_is_clear_only_if_interpolated_is_an_error_that_names_block_and_depth(
    audited, controller
):
    list_reported = [
        one for one in audited(controller=controller).findings if one.code == "independent-rapid"
    ]
    assert (
        len(list_reported) == 1 and list_reported[0].severity.name == "ERROR" and list_reported[0].line == 5
    )
    assert 0.9 * 5.0 < list_reported[0].value <= 5.0, (
        "a point of the block is no deeper in the ball than its radius"
    )
    assert "interpolated" in list_reported[0].text and "--rapids" in str(list_reported[0].text)


def test_the_same_rapid_is_clear_where_rapids_are_interpolated(audited):
    assert "independent-rapid" not in codes(audited(controller="fanuc", rapids="interpolated"))
    assert "independent-rapid" not in codes(audited(controller="linuxcnc"))
    assert "independent-rapid" in codes(audited(controller="linuxcnc", rapids="unknown"))


@pytest.mark.parametrize(("low", "enters"), [(20.0 + LIMIT, False), (20.0 - 3 * LIMIT, True)])
def test_what_the_ball_just_passes_over_is_reported_from_what_it_touches(low, enters):
    """The box of X and Z reaches down to the last Z: its entry is how far that lies below the block's top."""
    words = np.array([[-60.0, 0.0, 60.0, 0.0, 0.0], [60.0, 0.0, low, 0.0, 0.0]])
    found = find_way_entries(
        body_of(Cutter(10.0)), facet_tree(BLOCK), space("trunnion_ac"), words, np.array([0]), LIMIT, 0.001
    )
    assert (found.depth[0] > 0.0) == enters and (found.bound[0] <= LIMIT) == (not enters)
    if enters:
        assert found.depth[0] == pytest.approx(3 * LIMIT, rel=RELATIVE)


def space(machine, back=0.0):
    outcome = load_machine(machine)
    return JointSpace.of(chain(outcome, Setup(outcome.origin, 100.0)), back)


def some_rapids(seed, count):
    """Rapids about the block: all words, or some of them, go from one place to another."""
    rng = np.random.default_rng(seed)
    low, high = np.array([-45.0, -45.0, 10.0, -30.0, -30.0]), np.array([45.0, 45.0, 60.0, 30.0, 30.0])
    words = low + rng.random((count + 1, 5)) * (high - low)
    still = rng.random((count, 5)) < 0.3
    for i in range(count):
        words[i + 1, still[i]] = words[i, still[i]]
    return words


@pytest.mark.thorough
@some_in_core("machine", MACHINES)
def test_dense_simulation_over_random_rates_finds_nothing_that_the_bound_does_not(machine):
    body, there = body_of(Cutter(10.0), [(8.0, 20.0)], [(30.0, 20.0)]), space(machine)
    words = some_rapids(7, 24)
    found = find_way_entries(body, facet_tree(BLOCK), there, words, np.arange(24), LIMIT, 0.1)
    deepest = simulated(words, body, there, points_of(BLOCK), 11)
    assert (deepest <= found.bound + 1e-9).all()
    assert (found.bound[found.depth == 0.0] <= LIMIT).all(), "nothing stays open"
    hit = found.depth > 0.0
    assert hit.any() and not hit.all() and (deepest > LIMIT).any()
    assert (found.bound[hit] <= found.depth[hit] + np.maximum(0.1, RELATIVE * found.depth[hit]) + 1e-9).all()
    at = there.poses(found.words[hit])
    depth = [
        depth_of(body, tip, k, p[None])[0]
        for tip, k, p in zip(at.tip.T, at.axis.T, found.place[hit], strict=True)
    ]
    assert depth == pytest.approx(found.depth[hit], abs=1e-6), "each depth is that of a place on a way"


def test_the_simulation_would_notice_a_bound_that_looks_at_the_straight_way_only():
    body, there, words = body_of(Cutter(10.0)), space("trunnion_ac"), some_rapids(7, 24)
    found = find_entries(body, facet_tree(BLOCK), real_motion(there.kinematics, words), LIMIT)
    assert (simulated(words, body, there, points_of(BLOCK), 11) > found.bound + LIMIT).any()


@pytest.mark.parametrize("machine", MACHINES)
@pytest.mark.parametrize("back", [0.0, 5.0])
def test_no_pose_of_a_box_reaches_farther_than_its_hull(machine, back):
    rng, there, piece = np.random.default_rng(3), space(machine, back), body_of(Cutter(10.0)).pieces[0]
    boxes = boxes_of(some_rapids(2, 40), np.arange(40))
    hulls = there.hulls(boxes, 30.0)
    for _ in range(40):
        words = boxes.middle + (2.0 * rng.random((40, 5)) - 1.0) * boxes.half
        g = rng.normal(size=(3, 40))
        g /= np.linalg.norm(g, axis=0)
        at = there.poses(words)
        reached = piece_support(piece, at, g) - (g * hulls.pose.tip).sum(axis=0)
        assert (reached <= hulls.compute_support(piece, g) + 1e-9).all()


def piece_support(piece, at, g):
    """The support of a piece at single poses along g (3, n)."""
    return support(piece, (g * at.axis).sum(axis=0)) + (g * at.tip).sum(axis=0)


def test_boxes_of_linear_joints_are_exact():
    """Far corners of the box: the support is the largest over its eight corners."""
    there, piece = space("trunnion_ac"), body_of(Cutter(10.0)).pieces[0]
    box_ = JointBoxes(
        np.zeros(1, np.int64), np.array([[1.0, 2.0, 30.0, 40.0, 50.0]]), np.array([[5.0, 7.0, 9.0, 0.0, 0.0]])
    )
    hulls = there.hulls(box_, 30.0)
    g = np.array([[0.6], [0.0], [0.8]])
    signs = np.array([[a, b, c, 0.0, 0.0] for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)])
    at = there.poses(box_.middle + signs * box_.half)
    each = piece_support(piece, at, np.tile(g, 8))
    assert hulls.compute_support(piece, g)[0] + (g[:, 0] * hulls.pose.tip[:, 0]).sum() == pytest.approx(
        each.max(), abs=1e-9
    )


def test_only_rapids_of_several_axes_have_more_than_one_way():
    text = "\n".join(
        ("G90 G21", "G0 X0 Y0 Z60 A0 C0", "G0 Z50", "G0 X5 Y5", "G93 G1 X6 Y6 F10", "G0 Z60 A10", "M30")
    ).encode()
    outcome = load_machine("trunnion_ac")
    program = read_nc(text, chain(outcome, Setup(outcome.origin)), find_dialect("linuxcnc"))
    assert program.line[independent_rapids(program) + 1].tolist() == [4, 6]


def test_a_rapid_that_enters_anyhow_is_reported_once():
    text = "\n".join(("G90 G21", "G0 X-60 Y0 Z60 A0 C0", "G0 X60 Y1 Z-40", "M30")).encode()
    outcome = load_machine("trunnion_ac")
    kinematics = chain(outcome, Setup(outcome.origin))
    program = read_nc(text, kinematics, find_dialect("linuxcnc"))
    check = check_program(BLOCK, body_of(Cutter(10.0)), kinematics, program, LIMIT, rapids=UNKNOWN)
    assert [one.code for one in check.findings] == ["rapid-collision"]
    assert check.ways is not None and not check.ways.depth.any()


def test_a_report_does_not_call_a_program_gouge_free_that_is_so_only_if_interpolated():
    outcome = load_machine("trunnion_ac")
    kinematics = chain(outcome, Setup(outcome.origin))
    program = read_nc("\n".join(OVER).encode(), kinematics, find_dialect("linuxcnc"))

    def list_reported(rapids):
        check = check_program(BLOCK, body_of(Cutter(10.0)), kinematics, program, LIMIT, rapids=rapids)
        numbers = part_numbers(program, check, None, LIMIT, 0.0)
        return numbers.get("independent_rapid_blocks"), [kind for _, kind in part_verdict(numbers, LIMIT)]

    assert list_reported(INTERPOLATED) == (None, ["good"]) and list_reported(UNKNOWN) == (1, ["bad"])


# ------------------------------------------------------------------------------------------------ who says it


def test_each_controller_says_how_it_drives_rapids():
    message = {name: dialect.rapids for name, dialect in DIALECTS.items()}
    assert set(message.values()) <= set(RAPIDS)
    assert (
        message["haas"] == INDEPENDENT
        and message["fanuc"] == message["mach3"] == UNKNOWN
        and message["linuxcnc"] == INTERPOLATED
    )


def test_the_option_is_stronger_than_the_machine_file_and_that_than_the_controller():
    dialect, machine = find_dialect("haas"), load_machine("trunnion_ac")
    wanted = {"machine": "trunnion_ac"}
    plain, list_reported = (
        build_settings("mill", "p.stl", {**wanted, **more}) for more in ({}, {"rapids": "unknown"})
    )
    own = dataclasses.replace(machine, rapids=INTERPOLATED)
    assert (
        rapids_of(plain, machine, dialect) == INDEPENDENT and rapids_of(plain, own, dialect) == INTERPOLATED
    )
    assert rapids_of(list_reported, own, dialect) == UNKNOWN


def test_the_machine_file_keeps_it(tmp_path):
    machine = dataclasses.replace(load_machine("trunnion_ac"), rapids=INTERPOLATED)
    save_machine(machine, tmp_path / "own.fcm")
    assert load_machine(tmp_path / "own.fcm") == machine and load_machine("trunnion_ac").rapids == ""


@pytest.mark.parametrize("value", ['"straight"', "true", "3", '""'])
def test_a_value_that_is_none_of_them_is_refused_with_those_on_offer(tmp_path, value, capsys):
    save_machine(dataclasses.replace(load_machine("trunnion_ac"), rapids=UNKNOWN), tmp_path / "own.fcm")
    text = (
        (tmp_path / "own.fcm")
        .read_text(encoding="utf-8")
        .replace('"rapids": "unknown"', f'"rapids": {value}')
    )
    (tmp_path / "bad.fcm").write_text(text, encoding="utf-8")
    with pytest.raises(MachineError, match=r"fiveaxis\.rapids"):
        load_machine(tmp_path / "bad.fcm")
    (tmp_path / "p.ngc").write_text("\n".join(OVER), encoding="utf-8")
    assert main(["audit", str(tmp_path / "p.ngc"), "--machine", str(tmp_path / "bad.fcm")]) == 2
    message = capsys.readouterr().err
    assert message.count("\n") == 1 and "fiveaxis.rapids" in message


def test_a_value_of_a_job_file_that_is_none_of_them_is_refused():
    with pytest.raises(SettingsError, match=r"rapids.*straight.*interpolated"):
        build_settings("audit", "p.ngc", {"machine": "trunnion_ac", "rapids": "straight"})
