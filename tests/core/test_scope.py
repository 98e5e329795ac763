# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a verdict rests on: nothing is called proven that was not, and nothing that was not looked at is
passed over."""

import json
from dataclasses import replace

import pytest
from mesh_shapes import box
from plain import build_settings
from report_examples import by_hand, dome

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.report import as_html, as_json, as_text, scope, summary


def scope_of(figures):
    return scope(figures, summary(figures))


@pytest.fixture(scope="module")
def milled():
    """Figures of a box in planes, by what is asked of it."""
    mesh = from_triangles(box((0, 0, 0), (12, 10, 6)))
    kept = {}

    def figures(**options):
        key = tuple(sorted(options.items()))
        if key not in kept:
            wanted = {"machine": "trunnion_ac", "stepover": 3, "cutter": "ball:6", **options}
            kept[key] = job.figures(job.prove(job.make(build_settings("mill", "box.stl", wanted), mesh=mesh)))
        return kept[key]

    return figures


def test_a_program_alone_says_that_the_part_is_not_known():
    found = scope_of(dome())
    assert not any("part" in one for one in found.proven) and any(
        "enters it was not looked at" in one for one in found.unknown
    )


def test_blocks_over_tolerance_are_not_counted_as_proven():
    figures = by_hand()
    numbers = summary(figures)
    held = numbers["feed_blocks"] - numbers["guided_blocks"] - numbers["over_tolerance"] - numbers["unproven"]
    assert 0 < held < numbers["feed_blocks"]
    assert (
        scope_of(figures).proven[0].startswith(f"in {held} of {numbers['feed_blocks']} feed blocks the tip")
    )


def test_the_tool_is_named_as_far_as_it_is_given(milled):
    bare, whole = scope_of(milled()), scope_of(milled(shank="6x30", holder="30x20"))
    assert any(one.startswith("the cutter stays out of the part") for one in bare.proven)
    assert "shank and holder: none were given" in bare.unknown
    assert any(one.startswith("cutter, shank and holder stay out") for one in whole.proven)
    assert not any("none w" in one for one in whole.unknown)


def test_rapids_are_assumed_or_proven_as_the_controller_drives_them(milled):
    straight, any_way = scope_of(milled()), scope_of(milled(rapids="independent"))
    assert any("in a rapid all axes run in proportion" in one for one in straight.assumed)
    assert not any("rate at which" in one for one in straight.proven)
    assert any("each rate at which the axes may run" in one for one in any_way.proven)
    assert not any("in a rapid all axes" in one for one in any_way.assumed)


def test_what_enters_the_part_or_is_open_is_not_proven(milled):
    figures = milled(rapids="independent")
    for code, severity, lost in (
        ("overcut", Severity.ERROR, "stays out"),
        ("rapid-unproven", Severity.WARNING, "each rate"),
    ):
        finding = Finding(severity, code, "text", 1.0, 0.0, "mm")
        found = scope_of(replace(figures, findings=(finding,)))
        assert any(lost in one for one in scope_of(figures).proven) and not any(
            lost in one for one in found.proven
        )


def test_without_the_gouge_check_nothing_is_stated_of_the_part(milled):
    found = scope_of(milled(gouge="off"))
    assert not any("the part" in one for one in found.proven) and any(
        "not looked at" in one for one in found.unknown
    )


def test_every_report_has_the_box(milled):
    figures = milled()
    found = scope_of(figures)
    text, page = " ".join(as_text(figures).split()), as_html(figures)
    for one in (*found.proven, *found.assumed, *found.unknown):
        assert " ".join(one.split()) in text and one.replace("'", "&#x27;") in page
    assert json.loads(as_json(figures))["scope"] == {
        name: list(message) for name, message in found._asdict().items()
    }
