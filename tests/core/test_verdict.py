# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict: one light over everything, errors first; and what the defaults of ``mill`` and ``post`` make
of a part."""

import json
from dataclasses import replace

import numpy as np
import pytest
from gouge_examples import dense_points, prism, round_groove, sampled_depth, step
from plain import build_settings
from report_examples import TRUNNION, by_hand, empty, figures_of, table2
from uncured import UNCURED

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.gouge import Entries, GougeCheck, program_motion
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report import (
    Light,
    as_html,
    as_json,
    as_text,
    find_largest_judged,
    html_page,
    summary,
    verdict,
)
from freecad_fiveaxis.core.tool.body import body_of
from freecad_fiveaxis.core.toolpath.apt import write_apt
from freecad_fiveaxis.core.toolpath.apt.head import of_cl_file
from freecad_fiveaxis.core.toolpath.coedge import trimming

MACHINE = {"machine": "trunnion_ac", "stepover": 3}


def filleted():
    """A block of 40 x 40 x 20 mm whose long upper edges are rounded by 8 mm: in the middle of a pass the tool
    leans over."""
    turn = np.radians(np.linspace(0.0, 90.0, 13))
    round_ = 8.0 * np.column_stack([np.cos(turn), np.sin(turn)])
    left = (-round_[::-1] * (1, -1)) + (-12.0, 12.0)
    return prism([(-20, 0), (20, 0), *(round_ + (12.0, 12.0)), *left])


@pytest.fixture(scope="module")
def outcome():
    """Results by part and options, each made once."""
    kept = {}

    def mill(part, **options):
        key = (part, *sorted(options.items()))
        if key not in kept:
            settings = build_settings("mill", "part.stl", {**MACHINE, "cutter": "ball:8", **options})
            kept[key] = job.prove(job.make(settings, mesh=part()))
        return kept[key]

    return mill


def list_reported(result_or_figures):
    figures = (
        job.figures(result_or_figures) if isinstance(result_or_figures, job.Result) else result_or_figures
    )
    return verdict(figures, summary(figures))


def test_entering_the_part_comes_before_every_proof(outcome):
    """A ball that is held upright cuts into the wall of a step: the machine keeps its path, and the part is
    scrap."""
    result = outcome(step, tool_axis="fixed", stepover=1, gouge="report")
    numbers, message = summary(job.figures(result)), list_reported(result)
    assert numbers["proven"], "the path alone is proven"
    depth = result.gouge.cutter.depth * (result.draft.program.motion[1:] <= 1)
    places = int(((depth > 0) & ~np.append(False, depth[:-1] > 0)).sum())
    assert message.light is Light.RED and numbers["overcut_places"] == places > 1
    line = int(result.draft.program.line[depth.argmax() + 1])
    assert message.text.startswith(
        f"NOT SAFE: enters the part at {places} places, {depth.max():.3g} mm deep (NC line {line})"
    )
    assert not any(line.lstrip().startswith("Proven") for line in as_text(job.figures(result)).splitlines())


def test_every_report_says_the_same_verdict(outcome, monkeypatch):
    monkeypatch.setattr(html_page, "plots", lambda *_: ())
    figures = job.figures(outcome(step, tool_axis="fixed", stepover=1, gouge="report"))
    message = list_reported(figures)
    record = json.loads(as_json(figures))["summary"]
    assert (record["light"], record["verdict"], record["reasons"]) == (
        "red",
        message.text,
        list(message.reasons),
    )
    assert f'<p class="verdict bad">{message.text}</p>' in as_html(figures)
    assert (
        " ".join(as_text(figures).split("\n\n")[0].splitlines()[1:]) == message.text
        and record["proven"] is True
    )


def test_the_defaults_keep_the_tolerance_and_stay_out_of_the_part(outcome):
    """The same two parts by default, and uncured: there the tool is far off its path, or deep in the part."""
    for part, more in ((filleted, {"direction": 90, "lead": 5}), (step, {"tool_axis": "fixed"})):
        uncured, cured = (outcome(part, **more, **given) for given in ({**UNCURED, "gouge": "report"}, {}))
        assert list_reported(uncured).light is Light.RED
        assert list_reported(cured).light is not Light.RED, list_reported(cured).text
        numbers = summary(job.figures(cured))
        assert numbers["proven"] and numbers["overcut_blocks"] == numbers["rapid_collision_blocks"] == 0
    assert (
        summary(job.figures(outcome(filleted, direction=90, lead=5, **UNCURED)))["max_segment_deviation"]
        > 0.1
    )


@pytest.mark.thorough
def test_the_step_by_default_is_entered_nowhere_by_dense_sampling(outcome):
    """A judge without trees: how deep densely set points of the part lie in the cutter, on all its real
    way."""
    result, points = outcome(step, tool_axis="fixed"), dense_points(step(), 0.5)
    uncured = outcome(step, tool_axis="fixed", **{**UNCURED, "gouge": "report"})
    for one, most in ((result, 0.0101), (uncured, np.inf)):
        course, body = (
            program_motion(one.draft.kinematics, one.draft.program),
            body_of(one.draft.settings.cutter.cutter),
        )
        deepest = max(sampled_depth(body, points, course, block, 9) for block in range(0, len(course), 5))
        assert deepest <= most
    assert deepest > 1.0, "the judge sees what the cure has cured"


def test_post_divides_by_default_and_says_that_no_part_was_looked_at(outcome, tmp_path):
    given = outcome(filleted, direction=90, lead=5, **UNCURED)
    (tmp_path / "a.apt").write_bytes(write_apt(given.draft.path, given.draft.settings.cutter.cutter, "a"))
    posted = job.run(build_settings("post", str(tmp_path / "a.apt"), {"machine": "trunnion_ac"}))
    assert summary(job.figures(posted))["proven"] and summary(job.figures(given))["over_tolerance"] > 0
    message = list_reported(posted)
    assert message.light is Light.AMBER and message.reasons[0] == "not checked against the part"


CALM = np.array([[0, 0, 0, 0, 0], [1, 0, 0, 0, 0], [2, 0, 0, 0, 0.1]], float)


def calm(**more):
    """A program that keeps its path, looked at against the part, which it does not enter."""
    none = np.zeros(2)
    entries = Entries(none, none, none, np.zeros((2, 3)), none.astype(int), none.astype(int))
    check = GougeCheck(entries, entries, none.astype(bool), ())
    return figures_of(TRUNNION, CALM, **({"gouge": check} | more))


def found(severity, code="rewind", text="Something is so: do it.", **more):
    return Finding(severity, code, text, **more)


def test_green_says_what_is_proven_and_what_was_looked_at():
    assert list_reported(calm()).text == (
        "SAFE: tolerance 0.01 mm held in all 2 feed blocks, proven; the cutter stays out of the part (no shank or holder given)."
    )
    assert list_reported(calm(inputs={"holder": "40x25"})).text.endswith(
        "proven; the tool stays out of the part."
    )
    assert list_reported(calm(findings=(found(Severity.NOTE),))).light is Light.GREEN


def test_what_is_open_is_amber_and_what_is_wrong_is_red_whatever_else_is_stated():
    unchecked = list_reported(calm(gouge=None))
    assert unchecked.light is Light.AMBER and unchecked.text == "CHECK: not checked against the part."
    off = list_reported(calm(findings=(found(Severity.WARNING, "spindle-off"), found(Severity.NOTE))))
    assert off.text == "CHECK: the spindle stays off."
    assert (
        list_reported(calm(findings=(found(Severity.WARNING),))).text
        == "CHECK: a rotary axis turns back inside a cut, with the tool retracted."
    )
    wrong = calm(
        gouge=None,
        findings=(found(Severity.WARNING), found(Severity.ERROR, "limit", value=40.0, unit="deg", line=3)),
    )
    assert list_reported(wrong).text == "NOT SAFE: an axis leaves its limits (40 deg, NC line 3)."
    assert (
        list_reported(table2()).text
        == "NOT SAFE: 1 of 1 feed blocks leaves the path by up to 2.13 mm, 0.01 mm allowed (NC line 4)."
    )
    assert (
        list_reported(by_hand(0.0301)).light is Light.AMBER
        and "not proven in 1 of 5" in list_reported(by_hand(0.0301)).text
    )
    assert "nothing is proven" in list_reported(empty()).text


def test_what_has_no_words_of_its_own_is_reported_by_its_code_with_value_and_line_and_never_by_its_text():
    given = {"value": 0.03, "line": 5}, {"value": 3.0, "unit": "1"}, {"value": 0.5, "unit": "mm"}
    errors = [
        found(Severity.ERROR, code, f"Text {code}.", **more)
        for code, more in zip(("arc-not-interpreted", "several-tools", "poor-fit"), given, strict=True)
    ]
    assert list_reported(calm(findings=tuple(errors))).reasons == (
        "arcs that the reader cannot follow (NC line 5)",
        "the file changes tools, and the program cuts all of it with one",
        "the rows are off the best machine by more than rounding (0.5 mm)",
    )
    of_cl = of_cl_file(
        found(Severity.ERROR, "several-tools", say("The file changes tools: choose one."), line=11)
    )
    assert of_cl.text == "CL file, line 11: The file changes tools: choose one."
    assert (
        list_reported(calm(findings=(of_cl,))).text
        == "NOT SAFE: the file changes tools, and the program cuts all of it with one."
    )


@pytest.mark.parametrize("code", [code for code in Code if code is not Code.BOUND_OVER_TOLERANCE])
def test_every_kind_of_finding_has_its_words(code):
    """As one clause of the verdict: of small letters, without a full stop, and not divided as the verdict
    divides its reasons."""
    (reason,) = list_reported(calm(findings=(found(Severity.WARNING, code),))).reasons
    assert reason and not reason.endswith(".")
    assert code.severity is Severity.NOTE or not set(reason) & set(":;") or code is Code.SINGULAR_BLOCK


def test_rewinds_are_one_reason_with_their_count():
    one = found(Severity.WARNING, "rewind", value=309.3, unit="deg", line=1458)
    all_of_them = found(Severity.WARNING, "rewinds", value=15.0, unit="1", line=1458)
    assert list_reported(calm(findings=(one, all_of_them))).reasons == (
        "a rotary axis turns back inside cuts, 15 times",
    )
    once = replace(all_of_them, value=1.0)
    assert list_reported(calm(findings=(once,))).reasons == ("a rotary axis turns back inside a cut",)


def test_what_a_least_interval_leaves_is_a_height_and_not_the_interval():
    figures = calm(findings=(found(Severity.WARNING, "least-interval", value=6.708, unit="mm"),))
    list_reported = verdict(figures, summary(figures)).text
    assert "no closer than the least interval, and up to 6.708 mm high stays between them" in list_reported


def test_errors_are_named_by_what_they_do_to_the_part_and_counted_beyond_three():
    codes = ("limit", "deviation-over-tolerance", "overcut", "axis-not-reachable", "rapid-collision")
    errors = tuple(found(Severity.ERROR, code, f"It is {code}. Help.", value=0.5, line=7) for code in codes)
    message = list_reported(replace(by_hand(), findings=errors))
    assert message.reasons[0] == "enters the part at 1 place, 0.5 mm deep (NC line 7)"
    assert message.reasons[1].startswith("hits the part between passes") and message.reasons[2].startswith(
        "2 of 5 feed blocks leave"
    )
    assert message.text.endswith("; and 2 more.") and len(message.reasons) == 5


# ---------------------------------------------------------------------------- what stays, and what is settled


def tiny():
    """A part of 0.09 mm, as one drawn in metres."""
    return prism([(-0.04, -0.01), (0.04, -0.01), (0.04, 0.01), (-0.04, 0.01)], 0.09)


def test_a_part_smaller_than_the_cutter_may_be_in_another_unit():
    settings = build_settings("mill", "part.stl", {**MACHINE, "cutter": "ball:6", "stepover": 0.02})
    result = job.prove(job.make(settings, mesh=tiny()))
    (found,) = [one for one in result.findings if one.code == "unit-suspected"]
    assert (found.severity, found.value, found.limit, found.unit) == (
        Severity.WARNING,
        pytest.approx(0.09),
        6.0,
        "mm",
    )
    assert "metres (90 mm)" in found.text and "inches (2.286 mm)" in found.text
    assert (
        list_reported(result).light is Light.AMBER
        and "in another unit (0.09 mm)" in list_reported(result).text
    )
    assert "unit-suspected" in {one["code"] for one in json.loads(as_json(job.figures(result)))["findings"]}
    assert "unit-suspected" in as_text(job.figures(result))


def test_a_part_larger_than_the_cutter_is_not_suspected(outcome):
    assert "unit-suspected" not in {one.code for one in outcome(step, tool_axis="fixed").findings}


@pytest.mark.parametrize(("how", "reported_of"), [("off", True), ("report", False), ("lift", False)])
def test_what_the_check_has_settled_is_withdrawn(how, reported_of, monkeypatch):
    """A groove of 3 mm radius under a ball of 4. What the closing of co-edges can only suspect, the check of
    the program knows: after it nothing says any more that the tool may cut into the part; and without it no
    depth is told, for none is known."""
    monkeypatch.setattr(trimming, "ROUNDS", 1)
    given = {"cutter": "ball:8", "direction": 90, "tool_axis": "fixed", "max_axis_angle": 85}
    settings = build_settings("mill", "part.stl", {**MACHINE, **given, "gouge": how})
    found = job.prove(job.make(settings, mesh=round_groove(3.0, 32, side=12.0, length=12.0))).findings
    suspected = [one for one in found if one.code == "surface-tighter-than-cutter"]
    assert bool(suspected) is reported_of
    assert all(one.value is None and "not known" in one.text and " mm" not in one.text for one in suspected)


def test_the_share_that_stays_unfinished_comes_first(outcome):
    """Walls of a block, 20 deg at most from Z: of the top, 40 x 40, and the four sides, 40 x 20 each, only
    the top is cut."""
    result = outcome(block, max_axis_angle=20)
    message, numbers = list_reported(result), summary(job.figures(result))
    assert numbers["unfinished_share"] == pytest.approx(3200.0 / 4800.0)
    assert message.text.startswith("CHECK: 67 % of the surface to be milled stays unfinished;")


def block():
    return prism([(-20, -20), (20, -20), (20, 0), (-20, 0)])


def sheet():
    return from_faces(
        np.array([(-9.0, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)]), np.array([(0, 1, 2), (0, 2, 3)])
    )


def test_of_a_part_that_is_finished_no_share_is_reported(outcome):
    assert "unfinished" not in list_reported(outcome(sheet)).text


def test_of_what_is_guided_no_bound_is_given_and_of_rounding_the_least():
    numbers = dict.fromkeys(("max_surface_deviation", "max_surface_bound"))
    assert find_largest_judged(numbers | {"max_segment_deviation": 0.0, "max_bound": 0.0}) == (0.0, 0.0)
    assert find_largest_judged(numbers | {"max_segment_deviation": 8e-15, "max_bound": 2e-14}) == (0.0, 1e-9)
    assert find_largest_judged(numbers | {"max_segment_deviation": 1e-3, "max_bound": 2e-3}) == (1e-3, 2e-3)
