# SPDX-License-Identifier: LGPL-2.1-or-later
"""What reports say about the part: where the tool enters it and what is left, in numbers, words, tables,
markers and a picture."""

import csv
import io
import json
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from gouge_examples import step
from plain import build_settings

from freecad_fiveaxis.core.gouge import program_motion
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report import (
    as_html,
    as_json,
    as_text,
    blocks_csv,
    html_page,
    list_findings,
    markers,
    summary,
)
from freecad_fiveaxis.core.report.rest_material_picture import rest_svg
from freecad_fiveaxis.core.tool.body import body_of, depth_of

OPTIONS = {
    "machine": "trunnion_ac",
    "cutter": "ball:8",
    "stepover": 2,
    "tool_axis": "fixed",
    "linearize": "on",
    "rest": "on",
}


@pytest.fixture(scope="module")
def entered():
    """A step milled with an upright ball that enters its wall, and a holder that enters its shelf."""
    options = {**OPTIONS, "cutter": "ball:8:4", "gouge": "report", "holder": "12x20"}
    return job.prove(job.make(build_settings("mill", "step.stl", options), mesh=step()))


@pytest.fixture(scope="module")
def clear():
    """The same, but rows that enter are left out."""
    return job.prove(
        job.make(build_settings("mill", "step.stl", {**OPTIONS, "gouge": "leave-out"}), mesh=step())
    )


def test_requested_not_to_nothing_is_looked_for_and_reports_stay_as_they_were():
    options = {**OPTIONS, "gouge": "off", "rest": "off"}
    result = job.prove(job.make(build_settings("mill", "step.stl", options), mesh=step()))
    assert result.gouge is None and result.rest is None
    reported = json.loads(as_json(job.figures(result)))
    assert not {"gouge", "left"} & set(reported) and "max_left" not in reported["summary"]
    assert "enters the part" not in as_text(job.figures(result))
    assert b"depth" not in blocks_csv(
        result.draft.program, result.deviation, result.singularity, gouge=result.gouge
    )


def test_the_summary_has_the_deepest_entries_and_the_judge_finds_them_too(entered):
    reported = summary(job.figures(entered))
    assert (
        reported["max_overcut"] == pytest.approx(entered.gouge.cutter.depth.max())
        and reported["overcut_blocks"] > 0
    )
    assert reported["max_overcut"] <= reported["cutter_bound"] and reported["max_holder_collision"] > 1.0
    row = entered.draft.program.line.tolist().index(reported["overcut_line"])
    course = program_motion(entered.draft.kinematics, entered.draft.program)
    pose = course.pose(np.full(200, row - 1), np.linspace(0, 1, 200))
    place = np.tile(entered.gouge.cutter.place[row - 1], (200, 1))
    body = body_of(entered.draft.settings.cutter.cutter)
    assert depth_of(body, pose.tip.T, pose.axis.T, place).max() == pytest.approx(
        reported["max_overcut"], rel=0.02
    )


def test_json_has_the_deepest_places_and_the_histogram_holds_all_the_area(entered):
    reported = json.loads(as_json(job.figures(entered)))
    rows = reported["gouge"]["deepest"]
    assert 0 < len(rows) <= 10 and [row["depth"] for row in rows] == sorted(
        (row["depth"] for row in rows), reverse=True
    )
    assert {row["kind"] for row in rows} <= {"overcut", "rapid-collision", "holder-collision"}
    left = reported["left"]
    assert sum(bar["area"] for bar in left["histogram"]) == pytest.approx(left["machined_area"])
    assert all(a["to"] == b["from"] for a, b in zip(left["histogram"], left["histogram"][1:], strict=False))
    assert left["most_left"]["height"] == pytest.approx(entered.rest.height.max())
    above = sum(bar["area"] for bar in left["histogram"] if bar["from"] >= left["allowed"] - 1e-12)
    assert above == pytest.approx(left["left"]["area"])
    assert left["most_too_deep"]["line"] in entered.draft.program.line


def test_words_tell_good_from_bad(entered, clear):
    bad, good = (" ".join(as_text(job.figures(result)).split()) for result in (entered, clear))
    assert "The tool enters the part by more than 0.01 mm: deepest overcut" in bad and "Gouge-free" not in bad
    assert "Gouge-free: nowhere does the tool enter the part by more than 0.01 mm." in good
    assert "More is left than may be on" in good and "largest left" not in good
    assert "deepest overcut none above 0.01 mm" in good, "what enters by less is not measured, and not 0"
    assert "deepest overcut none" not in bad


def test_markers_stand_where_the_part_is_entered_and_say_how_deep(entered):
    figures = job.figures(entered)
    marks = [
        mark for mark in markers(figures) if mark.kind in ("overcut", "holder-collision", "rapid-collision")
    ]
    assert {"overcut", "holder-collision"} <= {mark.kind for mark in marks}
    for mark in marks:
        entries = entered.gouge.above if mark.kind == "holder-collision" else entered.gouge.cutter
        assert mark.place == pytest.approx(entries.place[mark.block - 1])
        assert f"{entries.depth[mark.block - 1]:.4g} mm in the part" in mark.label
        assert mark.label.endswith(f"line {figures.program.line[mark.block]}")
    deepest = next(mark for mark in marks if mark.kind == "overcut")
    assert deepest.finding is not None and deepest.finding.code == "overcut"
    rows, places = list_findings(figures)
    assert len(places) == len(markers(figures)) and max(places) < len(rows)


def test_the_table_of_blocks_has_the_depth_of_each(entered):
    text = blocks_csv(
        entered.draft.program, entered.deviation, entered.singularity, gouge=entered.gouge
    ).decode()
    rows = list(csv.DictReader(io.StringIO(text)))
    depth = np.array([float(row["depth"]) for row in rows])
    assert len(rows) == len(entered.draft.program.words) and depth[0] == 0.0
    assert depth[1:] == pytest.approx(
        np.maximum(entered.gouge.cutter.depth, entered.gouge.above.depth), abs=1e-6
    )


def test_the_page_shows_the_places_and_the_map(entered, clear, monkeypatch):
    monkeypatch.setattr(html_page, "plots", lambda *_: ())  # the others take their time
    page = as_html(job.figures(entered))
    assert (
        "Where the tool enters the part" in page
        and "holder-collision" in page
        and "What is left on the part" in page
    )
    assert 'class="verdict bad">NOT SAFE: ' in page and '<li class="bad">The tool enters the part' in page
    assert "<p>Nowhere.</p>" in as_html(job.figures(clear))


@pytest.mark.thorough
def test_the_picture_is_sound_small_and_the_same_every_time(clear):
    figures = job.figures(clear)
    outcome = rest_svg(figures.mesh, figures.rest, figures.tolerance, figures.allowed)
    assert (
        outcome == rest_svg(figures.mesh, figures.rest, figures.tolerance, figures.allowed)
        and len(outcome) < 400_000
    )
    root = ET.fromstring(outcome)
    words = " ".join(text for text in root.itertext())
    assert (
        "From above" in words
        and "Area by height" in words
        and f"{figures.rest.height.max():+.3g} mm" in words
    )
    assert len(list(root.iter("{http://www.w3.org/2000/svg}image"))) == 3


def test_what_a_cure_leaves_is_reported_once(clear):
    assert [finding.code for finding in clear.findings].count("uncut") == 1


def test_a_program_whose_tip_is_guided_has_its_map_too():
    options = {**OPTIONS, "controller": "heidenhain", "rtcp": "angles", "gouge": "report"}
    del options["linearize"]
    result = job.prove(job.make(build_settings("mill", "step.stl", options), mesh=step()))
    assert result.rest is not None and result.gouge is not None and result.rest.height.min() > -8.0


def test_without_a_check_the_map_tells_what_is_cut_too_deep():
    result = job.prove(job.make(build_settings("mill", "step.stl", {**OPTIONS, "gouge": "off"}), mesh=step()))
    assert "cut-too-deep" in {finding.code for finding in result.findings} and result.gouge is None
