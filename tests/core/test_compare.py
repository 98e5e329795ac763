# SPDX-License-Identifier: LGPL-2.1-or-later
"""The comparison: every cell against a run of its own, tool-centre control against dense sampling."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest
from plain import build_settings
from setup_examples import cap, milled, posting
from uncured import UNCURED, UNDIVIDED

from freecad_fiveaxis.core.base.errors import Cancelled, MachineError, ReachError, SettingsError
from freecad_fiveaxis.core.controllers import find_dialect
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, joint_words
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.program import build_program
from freecad_fiveaxis.core.orientation.axis_corrections import AxisCorrection
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.options import DEFAULT_CONTROLLER
from freecad_fiveaxis.core.report import summary
from freecad_fiveaxis.core.report.figures import axis_rates, feed_blocks
from freecad_fiveaxis.core.report.text import duration
from freecad_fiveaxis.core.studies import corrections as cure_table
from freecad_fiveaxis.core.studies.compare import (
    compare,
    compare_html,
    compare_json,
    compare_text,
    guide,
    solve_path,
    station,
)
from freecad_fiveaxis.core.studies.compare.stations import Share
from freecad_fiveaxis.core.studies.compare.words import verdict
from freecad_fiveaxis.core.studies.corrections import CURES, cures, leading
from freecad_fiveaxis.core.studies.study import try_machines
from freecad_fiveaxis.core.toolpath.apt import write_apt
from freecad_fiveaxis.core.toolpath.cl_path import Motion

COARSE = {"stepover": 12.0, "rings": 8}
COARSER = {"stepover": 20.0, "rings": 8}
"""Where every correction is tried."""
MACHINES = ("trunnion_ac", "mikron_ucp710", "head_b_table_c")


def stations(result, names=MACHINES):
    how = posting(result)
    for name in names:
        machine = load_machine(name)
        dialect = find_dialect(machine.controller or DEFAULT_CONTROLLER)
        yield station(machine, Setup(machine.origin, 80.0), replace(how, dialect=dialect))


def halved(path, where, progress):
    """A cure for the tests: every feed block in two, tip and rotary words half way."""
    joints = solve_path(path, where, progress)
    first = np.flatnonzero(joints.path.motion[1:] != Motion.RAPID)
    at = np.sort(np.concatenate([np.arange(len(joints.q)), first + 0.5]))
    low, high = np.floor(at).astype(int), np.ceil(at).astype(int)

    def middle(column):
        return 0.5 * (column[low] + column[high])

    taken = {
        name: getattr(joints.path, name)[high]
        for name in joints.path.__dataclass_fields__
        if name != "findings"
    }
    longer = replace(
        joints.path, **(taken | {name: middle(getattr(joints.path, name)) for name in ("tip", "contact")})
    )
    q = joint_words(where.kinematics, longer.tip, middle(joints.q[:, 3:]))
    return JointPath(longer, joints.row[high], q, joints.branch[high], joints.sine[high])


def leaned(offset, axis, kinematics, options, progress):
    """Axes half way to the vertical."""
    axis = axis + (0.0, 0.0, 1.0)
    return axis / np.linalg.norm(axis, axis=1)[:, None], ()


def separate(path, where, cure):
    """The figures of one cell, by the pipeline's own calls."""
    joints = cure(path, where, lambda stage, fraction: None)
    program = build_program(joints, where.kinematics, where.posting.dialect, True)
    deviation, feeds = job.measure(where.kinematics, program.words), feed_blocks(program)
    rates = axis_rates(program)[feeds].max(axis=0) * np.array(
        [1.0, 1.0, 1.0, math.pi / 180.0, math.pi / 180.0]
    )
    largest = [column[feeds].max() for column in (deviation.segment, deviation.bound, deviation.axis)]
    return [*largest, len(program.words), len(feeds), program.seconds.sum(), *rates]


def cells(row):
    return [
        row.deviation,
        row.bound,
        row.axis_deviation,
        row.blocks,
        row.feed_blocks,
        row.time,
        *row.peak_rate,
    ]


@pytest.mark.slow
def test_every_cell_is_that_of_a_separate_run_with_every_cure():
    result = milled(tool_length=80.0, **COARSER)
    tried = {**cures(result), "halved": halved, "leaned": leading(AxisCorrection(leaned), result)}
    places = list(stations(result))
    rows = compare(result.path, places, tried, guided=(False,))
    assert [(row.machine, row.cure) for row in rows] == [
        (where.name, name) for where in places for name in tried
    ]
    for row, (where, name) in zip(rows, [(where, name) for where in places for name in tried], strict=True):
        assert cells(row) == pytest.approx(separate(result.path, where, tried[name]), rel=1e-12)
    by_cure = {name: [row for row in rows if row.cure == name] for name in tried}
    for none, half, lean in zip(by_cure["none"], by_cure["halved"], by_cure["leaned"], strict=True):
        assert (
            half.deviation < 0.5 * none.deviation and half.feed_blocks > 1.9 * none.feed_blocks
        )  # the cures do what they say
        assert lean.deviation != none.deviation
    assert cells(rows[0]) != pytest.approx(cells(rows[len(tried)]), rel=1e-3)  # and machines differ


def test_a_cl_file_compared_is_the_same_as_posted_to_each_machine(tmp_path):
    result = milled(tool_length=80.0, **COARSE)
    source = tmp_path / "cap.apt"
    source.write_bytes(write_apt(result.path, result.settings.cutter.cutter, "cap"))
    given = {"tool_length": 80.0, "feed_mode": "g94"}
    found = try_machines(build_settings("compare", str(source), {"machines": ",".join(MACHINES), **given}))
    rows = [row for row in found.rows if not row.tool_centre and row.cure == "none"]
    for row, name in zip(rows, MACHINES, strict=True):
        numbers = summary(
            job.figures(job.run(build_settings("post", str(source), {"machine": name, **given, **UNDIVIDED})))
        )
        assert row.machine == name
        assert [row.deviation, row.bound, row.blocks, row.feed_blocks, row.time] == pytest.approx(
            [
                numbers[key]
                for key in ("max_surface_deviation", "max_surface_bound", "blocks", "feed_blocks", "time_s")
            ],
            rel=1e-12,
        )
        peaks = {letter: numbers["axes"][letter]["peak_rate"] for letter in row.letters}
        ours = dict(
            zip(row.letters, [*row.peak_rate[:3], *map(math.degrees, row.peak_rate[3:])], strict=True)
        )
        assert ours == pytest.approx(peaks, rel=1e-9)


OPTIONS = {
    "none": {}, "linearize": {"linearize": "on"}, "minimax": {"tool_axis": "minimax"}, "auto": {"tool_axis": "auto"}, "deform": {"singularity": "deform"},
}  # fmt: skip
"""The options of `mill` that each cure of the table stands for."""


@pytest.mark.slow
def test_a_solid_compared_is_the_same_as_milled_on_the_first_machine_with_each_cure():
    assert set(OPTIONS) == set(CURES)
    options, mesh = {"stepover": COARSER["stepover"], "tool_length": 80.0}, cap(rings=8, sectors=24)
    found = try_machines(
        build_settings(
            "compare", "cap.stl", {"machines": "trunnion_ac,mikron_ucp710", "gouge": "off", **options}
        ),
        mesh=mesh,
    )
    seen = set()
    for row in found.rows[: 2 * len(CURES) : 2]:
        settings = build_settings(
            "mill", "cap.stl", {"machine": "trunnion_ac", **UNCURED, **options, **OPTIONS[row.cure]}
        )
        numbers = summary(job.figures(job.prove(job.make(settings, mesh=mesh))))
        assert (row.machine, row.tool_centre) == ("trunnion_ac", False)
        assert [row.deviation, row.bound, row.blocks, row.time] == [
            numbers[key] for key in ("max_surface_deviation", "max_surface_bound", "blocks", "time_s")
        ]
        seen.add((row.deviation, row.blocks))
    assert len(seen) > 2, "the cures change nothing on this part: the comparison shows nothing"


def test_peaks_under_tool_centre_control_are_those_of_dense_sampling():
    kinematics = chain(load_machine("mikron_ucp710"), Setup())
    rng = np.random.default_rng(7)
    tip, angles = rng.uniform(-60.0, 60.0, (12, 3)), rng.uniform(-1.0, 1.0, (12, 2)) * (2.0, 0.4)
    motion, feed = np.full(12, Motion.CUT, np.int8), np.full(12, 1000.0)
    course = guide(kinematics, tip, angles, motion, feed)
    u = np.linspace(0.0, 1.0, 4001)[:, None]
    for row in range(1, 12):
        place, turned = ((1.0 - u) * one[row - 1] + u * one[row] for one in (tip, angles))
        q = joint_words(kinematics, place, turned)
        assert np.abs(forward(kinematics, q)[0] - place).max() < 1e-9  # the tip is on its chord
        slope = np.abs(np.gradient(q, u[:, 0], axis=0)).max(axis=0)
        assert course.peak[row] == pytest.approx(slope, rel=2e-3, abs=1e-6)
        least = max(
            np.linalg.norm(tip[row] - tip[row - 1]) / 1000.0, (course.peak[row] / kinematics.rate).max()
        )
        assert course.seconds[row] == pytest.approx(60.0 * least)
    assert (course.rates(np.arange(1, 12)) <= kinematics.rate * (1.0 + 1e-9)).all()


@pytest.mark.parametrize("name", ["trunnion_ac", "mikron_ucp710", "head_b_table_c"])
def test_under_tool_centre_control_a_block_that_goes_nowhere_takes_no_time_and_asks_no_rate(name):
    kinematics = chain(load_machine(name), Setup(tool_length=80.0))
    tip = np.repeat(np.random.default_rng(3).uniform(-60.0, 60.0, (20, 3)), 2, axis=0)
    angles = np.repeat(np.random.default_rng(4).uniform(-0.4, 0.4, (20, 2)), 2, axis=0)
    course = guide(kinematics, tip, angles, np.full(40, Motion.CUT, np.int8), np.full(40, 1000.0))
    stay = np.arange(1, 40, 2)
    assert not course.seconds[stay].any() and not course.rates(stay).any()
    assert (course.rates(stay[:-1] + 1) > 0.0).all(), "the others do move"


def test_with_tool_centre_control_the_tip_stays_on_its_chord_and_the_axes_pay():
    result = milled(tool_length=80.0, **COARSE)
    off, on = compare(result.path, list(stations(result, ["trunnion_ac"])))
    assert (
        (off.tool_centre, on.tool_centre) == (False, True)
        and off.deviation > 0.01
        and on.deviation == on.bound == 0.0
    )
    assert max(on.peak_rate[:3]) > max(off.peak_rate[:3]) and on.blocks == off.blocks


def test_a_machine_that_cannot_and_a_cure_that_refuses_are_rows_with_their_reason():
    result = milled(**COARSE)

    def refusing(path, where, progress):
        raise SettingsError("this cure wants 2 deg at least")

    beneath = replace(result.path, axis=result.path.axis * (1.0, 1.0, -1.0))
    rows = compare(
        beneath, list(stations(result, ["mikron_ucp710"])), {"none": solve_path, "refusing": refusing}
    )
    assert all(row.problem and math.isnan(row.deviation) for row in rows) and len(rows) == 4
    with pytest.raises(ReachError):
        solve_path(beneath, next(stations(result, ["mikron_ucp710"])))
    assert (
        "None of the machines" in verdict(rows)
        and "impossible" in compare_text(rows)
        and "wants 2 deg" in compare_html(rows)
    )
    assert json.loads(compare_json(rows))["rows"][0]["deviation"] is None


def test_a_cure_that_leads_the_axes_needs_the_solid():
    result = milled(**COARSE)
    posted = job.PostedProgram(
        **{
            name: value
            for name, value in vars(result).items()
            if name in job.PostedProgram.__dataclass_fields__
        }
    )
    row, _ = compare(
        result.path,
        list(stations(result, ["trunnion_ac"])),
        {"leaned": leading(AxisCorrection(leaned), posted)},
    )
    assert "STL" in row.problem


def test_nothing_to_compare_is_refused():
    result = milled(**COARSE)
    with pytest.raises(SettingsError, match="at least one machine"):
        compare(result.path, [])
    empty = replace(
        result.path,
        **{
            name: getattr(result.path, name)[:0]
            for name in result.path.__dataclass_fields__
            if name != "findings"
        },
    )
    with pytest.raises(SettingsError, match="no rows"):
        compare(empty, list(stations(result)))


def test_an_unknown_cure_is_named_with_those_that_there_are():
    with pytest.raises(SettingsError, match="unknown correction 'magic'; known: none"):
        cures(milled(**COARSE), ["none", "magic"])


@pytest.mark.slow
def test_a_new_line_in_the_table_of_cures_is_compared(monkeypatch):
    monkeypatch.setattr(cure_table, "CURES", {**CURES, "halved": lambda result: halved})
    settings = build_settings(
        "compare", "cap.stl", {"machines": "trunnion_ac", "stepover": COARSER["stepover"]}
    )
    found = try_machines(settings, mesh=cap(rings=8, sectors=24))
    assert [row.cure for row in found.rows] == [name for name in (*CURES, "halved") for _ in range(2)]
    one = try_machines(
        build_settings(
            "compare",
            "cap.stl",
            {"machines": "trunnion_ac", "stepover": COARSER["stepover"], "cures": "halved"},
        ),
        mesh=cap(rings=8, sectors=24),
    )
    assert one.rows == found.rows[-2:]


def test_an_unknown_machine_is_refused_before_the_work():
    def never(stage, fraction):
        raise AssertionError("work has begun")

    with pytest.raises(MachineError, match="no_such"):
        try_machines(
            build_settings("compare", "cap.stl", {"machines": "trunnion_ac,no_such"}),
            never,
            mesh=cap(rings=8, sectors=24),
        )


def test_the_words_name_the_quickest_that_holds_the_tolerance():
    result = milled(tool_length=80.0, **COARSE)
    rows = compare(result.path, list(stations(result)))
    best = min((row for row in rows if row.tool_centre), key=lambda row: row.time)
    reported = f"{best.machine} with no correction, tool-centre control, {duration(best.time)}."
    guided = (
        "In 3 of these the controller guides the tip: only the end points of blocks are verified there, the "
        "path between them is under RTCP."
    )
    assert verdict(rows, 0.001) == f"3 of 6 ways hold 0.001 mm; the quickest is {reported} {guided}"
    straight = [row for row in rows if not row.tool_centre]
    assert "RTCP" not in verdict(straight, 10.0) and "hold 10 mm" in verdict(straight, 10.0)
    lines = compare_text(rows, 0.001).splitlines()
    assert sum(line.count("ends only") for line in lines) == 2 * 3 and "0.00000" not in "".join(lines)
    assert verdict([rows[0]], 1e-9).startswith("Nothing here holds 1e-09 mm")
    assert verdict(rows).startswith("Least deviation")
    record = json.loads(compare_json(rows, {"task": "compare"}))
    assert record["rows"][0]["peak_rate"]["C"] == pytest.approx(math.degrees(rows[0].peak_rate[3]))
    page = compare_html(rows, "cap.stl", 0.001)
    assert page.count("<tr>") == 1 + len(rows) and "<script" not in page and "src=" not in page


def test_the_progress_of_cures_with_many_stages_never_goes_back():
    seen = []
    reported = Share(lambda stage, fraction: seen.append(fraction), 1, 4)
    for stage in ("", "joint path", "minimax axes", "minimax axes", "gouge"):
        for step in range(11):
            reported(stage, step / 10)
    assert seen == sorted(seen) and seen[0] == 0.25 and 0.45 < seen[-1] < 0.5
    assert max(np.diff(seen)) < 0.02, "and it moves with each word of a cure"


def test_progress_runs_to_1_and_may_be_cancelled():
    result, seen = milled(**COARSE), []
    places = list(stations(result, ["trunnion_ac", "trunnion_bc"]))
    compare(result.path, places, progress=lambda stage, fraction: seen.append(fraction))
    assert seen == sorted(seen) and seen[-1] == 1.0

    def stop(stage, fraction):
        raise Cancelled(stage)

    with pytest.raises(Cancelled):
        compare(result.path, places, progress=stop)
