# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rapids of our own programs are clear whichever way the controller drives the axes: divided, on the
commanded way, nowhere else."""

import dataclasses
from functools import cache

import numpy as np
import pytest
from gouge_examples import knob_in_corner, step
from mesh_shapes import box
from plain import build_settings
from rapid_simulation import points_of, simulated
from thorough import some_in_core

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.controllers import find_dialect
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.joint_box import JointSpace
from freecad_fiveaxis.core.gouge.rapid_check import independent_rapids
from freecad_fiveaxis.core.links import divide_rapids as stage
from freecad_fiveaxis.core.links.divide_rapids import (
    RapidClearance,
    RapidWays,
    divide_rapids,
    find_cuts,
    rapid_ways,
)
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.pipeline import job, milling
from freecad_fiveaxis.core.pipeline.options import tool_body
from freecad_fiveaxis.core.pipeline.solve_joints import keep_rapids_clear
from freecad_fiveaxis.core.report.markers import markers
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import body_of
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

PARTS = {"step": lambda: step(6.0), "knob": lambda: knob_in_corner(cells=12)}
OPTIONS = {
    "cutter": "ball:8:40",
    "stepover": 4.0,
    "max_axis_angle": 60,
    "links": "over",
    "tool_length": 120,
    "tool": 1,
    "lead": 20,
}
CASES = [
    ("fork_head_bc", "step", {"controller": "haas"}),
    ("head_b_table_c", "knob", {"controller": "mach3", "stepover": 8}),
    ("trunnion_ac", "knob", {"controller": "fanuc", "stepover": 6, "lead": 15}),
    ("fork_head_bc", "step", {"controller": "fanuc", "rtcp": "angles"}),
    ("fork_head_bc", "step", {"controller": "fanuc", "control_point": "centre"}),
]
BLOCK = from_triangles(box((-20.0, -20.0, 0.0), (20.0, 20.0, 20.0)))
"""40 x 40 x 20 mm on Z 0 to 20."""
LIMIT = 0.01


def milled_anew(machine, part, **options):
    return job.make(
        build_settings("mill", "part", {"machine": machine, **OPTIONS, **options}), mesh=PARTS[part]()
    )


milled = cache(milled_anew)
"""The program, made once for all tests that ask for the same."""


@cache
def undivided(machine, part, **options):
    """The same program without the stage."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(milling, "STAGES", tuple(one for one in milling.STAGES if one is not keep_rapids_clear))
        return milled_anew(machine, part, **options)


def codes(outcome):
    return {one.code for one in job.prove(outcome).findings}


@pytest.mark.thorough
@some_in_core(("machine", "part", "options"), CASES)
def test_no_rapid_of_our_own_is_clear_only_if_interpolated(machine, part, options):
    assert "independent-rapid" in codes(undivided(machine, part, **options)), "the stage has something to do"
    outcome = milled(machine, part, **options)
    assert not {"independent-rapid", "rapid-unproven", "rapid-collision"} & codes(outcome)
    reported = [one for one in outcome.findings if one.code == "rapids-divided"]
    assert len(reported) == 1 and reported[0].severity is Severity.NOTE


def added(outcome, plain):
    """The rows that the program has beside those of the other, which it all has in order; and the row of that
    before each."""
    rows, before, at = [], [], 0
    for k, words in enumerate(outcome.program.words):
        if at < len(plain.program.words) and (words == plain.program.words[at]).all():
            at += 1
        else:
            rows.append(k)
            before.append(at - 1)
    assert at == len(plain.program.words)
    return np.array(rows), np.array(before)


@some_in_core(("machine", "part", "options"), CASES[:4], kept=(0, 3))
def test_rows_that_are_put_in_are_rapids_on_the_commanded_way(machine, part, options):
    outcome, plain = milled(machine, part, **options), undivided(machine, part, **options)
    rows, before = added(outcome, plain)
    reported = next(one for one in outcome.findings if one.code == "rapids-divided")
    assert (
        len(rows) == reported.value
        and (outcome.program.motion[rows] == Motion.RAPID).all()
        and not outcome.program.feed[rows].any()
    )

    def commanded(program):
        if program.guided is None:
            return program.words
        return np.column_stack([program.guided.tip, program.words[:, 3:]])

    start, end, here = (
        commanded(plain.program)[before],
        commanded(plain.program)[before + 1],
        commanded(outcome.program)[rows],
    )
    longest = np.abs(end - start).argmax(axis=1)[:, None]
    share = np.take_along_axis(here - start, longest, 1) / np.take_along_axis(end - start, longest, 1)
    assert ((share > 0.0) & (share < 1.0)).all()
    assert np.abs(start + share * (end - start) - here).max() < 1.1e-3, "a step of the words"
    assert plain.nc.count(b"\n") + len(rows) == outcome.nc.count(b"\n"), "a line a row"


@pytest.mark.thorough
@pytest.mark.parametrize(("machine", "part", "options"), CASES[:1])
def test_dense_simulation_over_random_rates_finds_no_entry(machine, part, options):
    outcome, plain = milled(machine, part, **options), undivided(machine, part, **options)
    rows, before = added(outcome, plain)
    space, points = JointSpace.of(outcome.kinematics), points_of(outcome.mesh)
    body, blocks = tool_body(outcome.settings), np.unique(np.concatenate([rows - 1, rows]))
    assert simulated(outcome.program.words, body, space, points, 3, blocks, 6).max() <= LIMIT
    assert simulated(plain.program.words, body, space, points, 3, np.unique(before), 6).max() > 1.0, (
        "it would notice"
    )


@pytest.mark.parametrize(
    "options", [{"controller": "linuxcnc"}, {"controller": "haas", "rapids": "interpolated"}]
)
def test_programs_for_controls_that_interpolate_rapids_stay_as_they_are(options):
    assert milled("fork_head_bc", "step", **options).nc == undivided("fork_head_bc", "step", **options).nc


def test_rapids_stay_where_nothing_is_looked_at():
    options = {"controller": "haas", "gouge": "off"}
    assert milled("fork_head_bc", "step", **options).nc == undivided("fork_head_bc", "step", **options).nc


def clearance(mesh=BLOCK):
    return RapidClearance(body_of(Cutter(10.0)), facet_tree(mesh), 0.0, LIMIT)


def kinematics(**modulo):
    machine = load_machine("trunnion_ac")
    axes = tuple(dataclasses.replace(axis, wrap=modulo.get(axis.letter, axis.wrap)) for axis in machine.axes)
    outcome = dataclasses.replace(machine, axes=axes)
    return chain(outcome, Setup(outcome.origin))


def ways(*rapids):
    """Rapids on the trunnion machine, each from words to words, mm and degrees."""
    start, end = (np.array([one[k] for one in rapids], float) for k in (0, 1))
    return RapidWays(kinematics(), find_dialect("haas"), start, end - start)


OVER = ((-60.0, 0.0, 60.0, 0.0, 0.0), (60.0, 0.0, 10.0, 0.0, 0.0))
"""Straight over the block; on the way of X alone, then Z, into none, on that of Z alone, then X, through the
block."""


def test_a_rapid_is_divided_no_more_than_needed():
    cuts = find_cuts(ways(OVER), clearance())
    assert cuts.rapid.tolist() == [0] * len(cuts.rapid) and (np.diff(cuts.end) > 0.0).all()
    ends = np.array([0.0, *cuts.end, 1.0])
    pieces = stage.Pieces(np.zeros(len(ends) - 1, np.int64), ends[:-1], ends[1:])
    assert not clearance().find_blocked(ways(OVER), pieces).any()
    wider = stage.Pieces(np.zeros(1, np.int64), np.zeros(1), np.ones(1))
    assert clearance().find_blocked(ways(OVER), wider).all() and 1 <= len(cuts.end) <= 3


def test_a_rapid_that_enters_on_its_commanded_way_is_left_as_it_is():
    through = ((-60.0, 0.0, 25.0, 0.0, 0.0), (60.0, 0.0, 10.0, 0.0, 0.0))
    assert find_cuts(ways(through, OVER), clearance()).rapid.tolist() == find_cuts(
        ways(OVER), clearance()
    ).rapid.size * [1]


def test_pieces_that_stay_blocked_after_the_last_halving_are_left_to_the_check(monkeypatch):
    monkeypatch.setattr(stage, "HALVINGS", 0)
    assert "independent-rapid" in codes(milled_anew("fork_head_bc", "step", controller="haas"))


def joints(kinematics_, words, findings=()):
    q = words_to_q(np.array(words, float))
    tip, axis = forward(kinematics_, q)
    n = len(q)
    none, lost = np.zeros(n), np.full(n, -1)
    path = CLPath(tip, axis, np.full(n, Motion.RAPID, np.int8), none, tip, axis, lost, lost, lost)
    return JointPath(path, np.arange(n), q, np.zeros(n, np.int8), none, findings)


def test_an_axis_that_takes_the_shorter_way_is_divided_on_that_way():
    turned = [(0.0, 0.0, 50.0, 0.0, 10.0), (50.0, 0.0, 50.0, 0.0, 350.0)]
    for wrap, step_ in (("unwound", 340.0), ("modulo", -20.0)):
        machine = kinematics(C=wrap)
        column = machine.letters.index("C")
        words = [np.insert(np.delete(row, 4), column, row[4]) for row in np.array(turned)]
        rows, found = rapid_ways(joints(machine, words), machine, find_dialect("haas"))
        assert rows.tolist() == [1] and found.step[0, column] == pytest.approx(step_)


def test_findings_stay_with_their_rows():
    machine = kinematics()
    words = [(-60.0, 0.0, 90.0, 0.0, 0.0), *OVER, (60.0, 5.0, 10.0, 0.0, 0.0)]
    findings = tuple(Finding(Severity.NOTE, "here", "Here.", block=k) for k in range(4))
    given = joints(machine, words, findings)
    outcome = divide_rapids(given, machine, find_dialect("haas"), clearance())
    assert len(outcome.q) > len(given.q)
    at = [one.block for one in outcome.findings if one.code == "here"]
    assert outcome.q[at] == pytest.approx(given.q) and outcome.row[at].tolist() == [0, 1, 2, 3]
    assert outcome.path.tip[at] == pytest.approx(given.path.tip)


def test_a_rapid_that_is_clear_only_if_interpolated_has_a_marker_in_each_run():
    machine, part, options = CASES[2]
    result = job.prove(undivided(machine, part, **options))
    marked = [one for one in markers(job.figures(result)) if one.kind == "independent-rapid"]
    depth = result.gouge.ways.depth
    assert marked and marked[0].block == depth.argmax() + 1 and marked[0].finding is not None
    assert {one.block for one in marked} <= set((independent_rapids(result.draft.program) + 1).tolist())
    assert f"{depth.max():.4g} mm in the part" in marked[0].label


@pytest.mark.parametrize(("machine", "part", "options"), [CASES[0], CASES[3]])
def test_an_audit_of_our_own_file_finds_none_either(tmp_path, machine, part, options):
    wanted = {
        "machine": machine,
        "tool_length": 120,
        "cutter": "ball:8:40",
        "gouge": "report",
        "controller": options["controller"],
    }
    write_stl(PARTS[part](), tmp_path / "part.stl")
    for outcome, clear in (
        (milled(machine, part, **options), True),
        (undivided(machine, part, **options), False),
    ):
        (tmp_path / "own.nc").write_bytes(outcome.nc)
        given = {**wanted, "against": str(tmp_path / "part.stl")}
        found = {
            one.code for one in job.run(build_settings("audit", str(tmp_path / "own.nc"), given)).findings
        }
        assert ("independent-rapid" not in found) == clear and "rapid-collision" not in found
