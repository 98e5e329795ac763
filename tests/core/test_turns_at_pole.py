# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks in which an axis turns while the tool stands at the pole: a note of their own, no reason to check."""

from dataclasses import replace

import numpy as np
import pytest
from gouge_examples import prism
from report_examples import TRUNNION, program_of, sampled

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.gouge import Entries, GougeCheck
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward_tip, words_to_q
from freecad_fiveaxis.core.motion.program.guided import Guided
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.report import Light, list_findings, markers, summary, verdict
from freecad_fiveaxis.core.report.figures import Figures
from freecad_fiveaxis.core.report.judgement import judge
from freecad_fiveaxis.core.report.turns_at_pole import assume_programmed_feed

UPRIGHT = [(0, 0, 0, 0, 0), (2, 0, 0, 30, 0), (4, 0, 0, 70, 0)]
"""C turns by 30 and 40 deg while the tool stands along it; the blocks are 2 and more mm long."""


def found_in(words, feed=600.0, wanted=600.0, tolerance=3.0, **more):
    """Return the figures, judged, of blocks at ``feed`` where ``asked`` mm/min was meant."""
    kinematics = chain(TRUNNION, Setup())
    words = np.array(words, float)
    program = replace(program_of(kinematics, words, feed=feed), **more)
    deviation, singularity = sampled(kinematics, program.words)
    wanted = None if wanted is None else np.full(len(words), wanted)
    found = judge(kinematics, program, deviation, singularity, tolerance, programmed=wanted)
    none = np.zeros(len(words) - 1)
    entries = Entries(none, none, none, np.zeros((len(none), 3)), none.astype(int), none.astype(int))
    return Figures(
        "part.stl", "mill", TRUNNION, kinematics, program, deviation, singularity, tolerance, found,
        gouge=GougeCheck(entries, entries, none.astype(bool), ()), programmed_feed=wanted,
    )  # fmt: skip


def named(figures):
    return [(one.code, one.severity) for one in figures.findings]


def test_a_tool_that_stands_at_the_pole_gives_one_note_and_no_check():
    figures = found_in(UPRIGHT)
    assert summary(figures)["singular_blocks"] == summary(figures)["blocks_at_pole"] == 2
    assert named(figures) == [("turns-at-pole", Severity.NOTE)]
    (one,) = figures.findings
    assert (one.value, one.unit, one.block, one.line) == (pytest.approx(70.0), "deg", 2, 5)
    assert "C turns 70 deg in all in 2 feed blocks" in one.text and "NC line 5, 40 deg" in one.text
    assert "by proof" in one.text and "100 % of its feed" in one.text
    assert verdict(figures, summary(figures)).light is Light.GREEN


def test_a_machine_at_its_rate_that_hardly_slows_the_tool_is_a_note_and_one_that_dwells_a_warning():
    """C turns at its maximum rate in both: 14400 deg/min."""
    words = np.array(UPRIGHT[:2], float)
    speed = 2.0 / (30.0 / 14400.0)  # mm/min that the tip has then
    slow, dwells = (found_in(words, feed=1e5, wanted=speed / share) for share in (0.8, 0.7))
    assert named(slow) == [("turns-at-pole", Severity.NOTE)] and "80 % of its feed" in slow.findings[0].text
    assert named(dwells)[0] == ("singular-block", Severity.WARNING)
    assert verdict(dwells, summary(dwells)).text == "CHECK: 1 block near the pole."


@pytest.mark.parametrize(
    "more",
    [
        {"wanted": None},
        {"tolerance": 0.1},
        {"seconds": np.zeros(3)},
        {"guided": Guided(np.array([False, True, True]), np.zeros((3, 3)))},
    ],
    ids=["feed not known", "tolerance left", "time not known", "guided"],
)
def test_what_is_not_known_or_does_not_hold_is_near_the_pole_as_ever(more):
    codes = {code for code, _ in named(found_in(UPRIGHT, **more))}
    assert "singular-block" in codes and "turns-at-pole" not in codes


@pytest.mark.parametrize("lean", [-0.002, 0.002, 2.0])
def test_a_tool_that_leans_is_not_at_the_pole_and_by_rounding_it_does_not_lean(lean):
    leaning = [(0, 0, 0, 0, lean), (2, 0, 0, 30, lean)]
    assert {code for code, _ in named(found_in(leaning))} == {"singular-block"}
    rounded = [(0, 0, 0, 0, 0.0005), (2, 0, 0, 30, -0.0005)]
    assert named(found_in(rounded)) == [("turns-at-pole", Severity.NOTE)]


def test_a_tool_that_turns_over_and_back_leaves_the_pole_between():
    codes = {
        code for code, _ in named(found_in([(0, 0, 0, 0, 0), (2, 0, 0, 30, 360)], wanted=1.0, tolerance=1e3))
    }
    assert codes == {"singular-block"}


def test_what_passes_near_the_pole_stays_a_warning_that_counts_itself_alone():
    figures = found_in([*UPRIGHT, (4, 0, 0, 70, 2), (4.01, 0, 0, 130, 2)], feed=1e5)
    assert summary(figures)["singular_blocks"] == 3 and summary(figures)["blocks_at_pole"] == 2
    warning, note = figures.findings
    assert (warning.code, warning.severity, warning.block) == ("singular-block", Severity.WARNING, 4)
    assert warning.text.startswith("1 feed block lies near the pole") and note.code == "turns-at-pole"
    assert verdict(figures, summary(figures)).text == "CHECK: 1 block near the pole."


def test_a_plain_box_is_not_to_be_checked_for_turns_on_its_flat_top():
    """The path is put on the pole there, and the turn that is needed anyway spread over the cuts. The feed
    that is asked for is that of the path: with another one, five times as fast, the tool dwells."""
    box = prism([(-8, 0), (8, 0), (8, 12), (-8, 12)], 20.0)
    given = {"machine": "trunnion_ac", "cutter": "ball:8", "scallop": 0.4, "gouge": "off", "spindle": 8000}
    draft = job.make(build_settings("mill", "box", given), mesh=box)
    result = job.prove(draft)
    numbers = summary(job.figures(result))
    assert numbers["blocks_at_pole"] == numbers["singular_blocks"] > 10
    codes = [one.code for one in result.findings]
    assert codes.count("turns-at-pole") == 1 and "singular-block" not in codes
    path = draft.joints.path
    fast = replace(draft, joints=replace(draft.joints, path=replace(path, feed=5.0 * path.feed)))
    assert "singular-block" in {one.code for one in job.prove(fast).findings}


@pytest.mark.parametrize("controller", ["linuxcnc", "heidenhain"])
def test_an_audit_counts_the_blocks_at_the_pole_as_the_making_of_the_program_does(controller, tmp_path):
    block = prism([(-8, 0), (8, 0), (8, 12), (-8, 12)], 20.0)
    given = {"machine": "trunnion_ac", "cutter": "ball:8", "scallop": 0.4, "spindle": 8000}
    outcome = job.prove(
        job.make(build_settings("mill", "box", given | {"controller": controller}), mesh=block)
    )
    (tmp_path / "p.nc").write_bytes(outcome.draft.nc)
    read = job.run(build_settings("audit", str(tmp_path / "p.nc"), {"machine": "trunnion_ac"}))
    wanted, counted = (summary(job.figures(one))["blocks_at_pole"] for one in (outcome, read))
    assert counted == wanted > 10
    codes = [one.code for one in read.findings]
    assert codes.count("turns-at-pole") == 1 and "singular-block" not in codes


def test_a_program_of_others_is_held_against_the_feed_that_it_mostly_has():
    """One block dwells while C turns, all others go at 600 mm/min: so much is taken as programmed."""
    words = np.array([(2.0 * k, 0, 0, 0, 0) for k in range(8)], float)
    words[5:, 3] = 30.0
    kinematics = chain(TRUNNION, Setup())
    program = program_of(kinematics, words, feed=600.0)
    seconds = np.append(
        0.0, np.linalg.norm(np.diff(forward_tip(kinematics, words_to_q(words)), axis=0), axis=1) / 10
    )
    program = replace(program, seconds=seconds)
    usual = assume_programmed_feed(kinematics, program)
    assert usual == pytest.approx(np.full(8, 600.0))
    deviation, singularity = sampled(kinematics, words)
    for slower, code in ((1.0, "turns-at-pole"), (2.0, "singular-block")):
        late = replace(program, seconds=np.where(np.arange(8) == 5, slower, 1.0) * seconds)
        usual = assume_programmed_feed(kinematics, late)
        found = judge(kinematics, late, deviation, singularity, 30.0, programmed=usual)
        assert [one.code for one in found] == [code]


def test_without_any_time_no_feed_is_taken_as_programmed():
    kinematics = chain(TRUNNION, Setup())
    program = program_of(kinematics, np.array(UPRIGHT, float))
    assert assume_programmed_feed(kinematics, replace(program, seconds=np.zeros(3))) is None


def test_a_tool_that_does_not_lean_by_the_turn_is_not_reported_of_as_leaning_by_0_deg():
    (still,) = found_in(UPRIGHT[:2], wanted=None).findings
    assert (
        "C turns 30 deg and the tool leans as before" in still.text and "lean the tool by" not in still.text
    )
    (leaning,) = found_in([(0, 0, 0, 0, 0), (2, 0, 0, 30, 0.1)], wanted=None).findings
    assert "C turns 30 deg and A 0.1 deg to lean the tool by 0.1 deg" in leaning.text


def test_each_place_has_its_marker_and_its_row():
    figures = found_in([*UPRIGHT, (6, 0, 0, 70, 0), (8, 0, 0, 90, 0)])
    marks = [mark for mark in markers(figures) if mark.kind != "largest-deviation"]
    assert [(mark.kind, mark.block) for mark in marks] == [("turns-at-pole", 2), ("turns-at-pole", 4)]
    assert marks[0].finding is figures.findings[0] and marks[0].label == "turns 40 deg, line 5"
    rows, _ = list_findings(figures)
    assert {row.finding.severity for row in rows if row.kind == "turns-at-pole"} == {Severity.NOTE}
    assert len([row for row in rows if row.kind == "turns-at-pole"]) == 2
