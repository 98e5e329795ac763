# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stays unfinished, divided into what the tool cannot reach, what the settings leave and what it missed."""

import math
from dataclasses import replace

import numpy as np
import pytest
from gouge_examples import prism, step
from revolved import solid_of_revolution
from thorough import some_in_core

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import report_finding
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge import RestMaterial, report_uncut, too_tight
from freecad_fiveaxis.core.gouge.rest_material import surface_samples
from freecad_fiveaxis.core.gouge.too_tight import find_ball, find_too_tight
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.collision_avoidance import divide_unfinished, leaves_out
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.pipeline.settle_findings import still_true
from freecad_fiveaxis.core.report import as_text, summary, verdict
from freecad_fiveaxis.core.report.unfinished import Unfinished, name_unfinished
from freecad_fiveaxis.core.tool import parse_cutter
from freecad_fiveaxis.core.tool.body import CUTTER, body_of

pytestmark = pytest.mark.usefixtures("fields_kept")

BLOCK = prism([(-5, 0), (5, 0), (5, 10), (-5, 10)], 10.0)
"""600 mm2, all of which is to be cut here."""


def divided(**areas):
    found = tuple(report_finding(Code[name.upper()], "So.", area, unit="mm2") for name, area in areas.items())
    return divide_unfinished(found, BLOCK, np.ones(len(BLOCK.face), bool))


def test_the_parts_are_those_of_the_findings_and_make_up_the_whole():
    parts = divided(
        facets_without_free_axis=100.0, facets_beyond_machine=50.0, facets_beyond_axis_angle=30.0,
        outside_frames=20.0, uncut=60.0, uncut_too_tight=45.0, near_avoided_faces=10.0,
    )  # fmt: skip
    assert parts.parts() == pytest.approx(
        {"out_of_reach": 195.0 / 800.0, "left_by_settings": 40.0 / 800.0, "missed": 35.0 / 800.0}
    )
    assert sum(parts.parts().values()) == pytest.approx(parts.whole) == pytest.approx(270.0 / 800.0)


def test_the_verdict_names_what_the_tool_cannot_reach_and_why():
    parts = divided(facets_without_free_axis=100.0, facets_beyond_axis_angle=35.0, uncut=80.0, uncut_too_tight=40.0)  # fmt: skip
    assert name_unfinished(parts.whole, parts) == (
        "29 % of the surface to be milled stays unfinished: 19 % the tool cannot reach (no free axis, "
        "tighter than the cutter), 4.8 % the settings leave out, 5.4 % it missed"
    )
    alone = divided(facets_beyond_machine=200.0)
    assert name_unfinished(alone.whole, alone).endswith(
        "25 % of the surface to be milled stays unfinished: the tool cannot reach it (beyond the machine's limits)"
    )


def test_where_nothing_is_known_to_be_out_of_reach_the_words_are_as_ever():
    for parts in (divided(uncut=60.0), divided(facets_beyond_axis_angle=60.0), None):
        share = 0.1 if parts is None else parts.whole
        assert name_unfinished(share, parts).endswith(" % of the surface to be milled stays unfinished")


def found_of(code, value, within):
    return report_finding(code, say("So."), value, within=within)


def divided_of(*found, **more):
    return divide_unfinished(found, BLOCK, np.ones(len(BLOCK.face), bool), **more)


def test_what_lies_on_facets_that_are_cut_is_counted_once_and_by_what_stays_there():
    """Of 100 mm2 that no axis frees 20 are facets of their own; of the other 80 no more than stays at all."""
    parts = divided_of(
        found_of(Code.FACETS_WITHOUT_FREE_AXIS, 100.0, 80.0), found_of(Code.UNCUT, 60.0, None),
        found_of(Code.UNCUT_TOO_TIGHT, 45.0, None),
    )  # fmt: skip
    assert parts.whole == parts.out_of_reach == pytest.approx(80.0 / 620.0)
    alone = divided_of(found_of(Code.FACETS_WITHOUT_FREE_AXIS, 100.0, 80.0))
    assert alone.whole == pytest.approx(20.0 / 620.0), "swept from beside, by the map"


def test_stretches_beyond_the_limits_are_out_of_reach_as_far_as_something_stays():
    given = found_of(Code.AXIS_BEYOND_LIMITS, 30.0, 40.0), found_of(Code.FACETS_BEYOND_MACHINE, 60.0, None)
    parts = divided_of(*given, found_of(Code.UNCUT, 50.0, None))
    assert parts.whole == pytest.approx(110.0 / 660.0) and parts.missed == pytest.approx(10.0 / 660.0)
    assert str(name_unfinished(parts.whole, parts)).count("beyond the machine's limits") == 1


def test_corners_of_which_nothing_is_known_make_it_at_least():
    corner = report_finding(Code.CORNER_NOT_REACHED, say("A corner."), 3.0)
    reach = found_of(Code.FACETS_BEYOND_MACHINE, 60.0, None)
    least, mapped = divided_of(corner, reach), divided_of(corner, reach, mapped=True)
    uncut = divided_of(corner, reach, found_of(Code.UNCUT, 5.0, None))
    assert str(name_unfinished(least.whole, least)).startswith("at least 9.1 %")
    assert not mapped.at_least and not uncut.at_least and not divided_of(reach).at_least


def test_more_cannot_be_out_of_reach_than_stays():
    parts = Unfinished(0.1, {Code.UNCUT_TOO_TIGHT: 0.2}, 0.0)
    assert (parts.out_of_reach, parts.missed) == (0.1, 0.0)


@pytest.mark.parametrize("above", [0.05, 0.3])
def test_a_corner_between_two_walls_is_too_tight_for_a_ball_as_far_as_by_hand(above):
    """A ball of radius r in a corner of 90 deg: its middle is r from both walls, and at x from the corner it
    leaves sqrt((r - x)^2 + r^2) - r. Besides, the ball finds its place everywhere."""
    part, radius, spacing = step(), 4.0, 0.4
    point, facet, area = surface_samples(part, spacing)
    tight = find_too_tight(facet_tree(part), radius, point, part.normal[facet], above)
    strip = radius - math.sqrt((radius + above) ** 2 - radius**2)
    assert area[tight].sum() == pytest.approx(2 * 40.0 * strip, rel=0.03)
    assert np.abs(point[tight, 1:]).max() < strip + spacing


def test_only_a_ball_is_set_on_the_part():
    ends = {"ball:8": 4.0, "lollipop:8:4": 4.0, "flat:8": None, "bull:8:1": None, "barrel:10:85:2": None}
    assert {name: find_ball(body_of(parse_cutter(name)).only(CUTTER)) for name in ends} == ends


def rest_of(part, height, **more):
    point, facet, area = surface_samples(part, 1.0)
    return RestMaterial(point, facet, area, np.full(len(point), height), np.zeros(len(point), int), 1.0, **more)  # fmt: skip


def test_what_is_too_tight_is_a_note_beside_the_warning_where_part_and_ball_are_known():
    body = body_of(parse_cutter("ball:8")).only(CUTTER)
    uncut, tight = report_uncut(rest_of(step(), 0.5, mesh=step(), body=body), 0.05)
    assert (uncut.code, tight.code, tight.severity.name) == ("uncut", "uncut-too-tight", "NOTE")
    assert 0.0 < tight.value < 0.1 * uncut.value and "tighter than the cutter" in tight.text
    assert [one.code for one in report_uncut(rest_of(step(), 0.5), 0.05)] == ["uncut"]
    flat = rest_of(step(), 0.5, mesh=step(), body=body_of(parse_cutter("flat:8")).only(CUTTER))
    assert [one.code for one in report_uncut(flat, 0.05)] == ["uncut"]
    open_ = rest_of(BLOCK, 0.5, mesh=BLOCK, body=body)
    assert [one.code for one in report_uncut(open_, 0.05)] == ["uncut"]


def test_of_many_places_some_stand_for_all(monkeypatch):
    """What is too tight in the step's corner, of all that is left on it, by a fifth of the places."""
    body = body_of(parse_cutter("ball:8")).only(CUTTER)
    left = rest_of(step(), 0.5, mesh=step(), body=body)
    every = report_uncut(left, 0.05)[1].value
    monkeypatch.setattr(too_tight, "MOST_PLACES", len(left.area) // 5)
    assert report_uncut(left, 0.05)[1].value == pytest.approx(every, rel=0.25)


def test_a_step_says_how_much_of_what_stays_is_its_inside_corner():
    """The sides at the ends are missed, for planes lie along them; the corner is too tight."""
    given = {"machine": "trunnion_ac", "cutter": "ball:8", "stepover": 1, "passes": "planes", "direction": 0,
             "tool_axis": "facet_mean", "max_axis_angle": 60, "rest": "on"}  # fmt: skip
    figures = job.figures(job.prove(job.make(build_settings("mill", "part", given), mesh=step())))
    numbers = summary(figures)
    parts = numbers["unfinished_parts"]
    assert sum(parts.values()) == pytest.approx(numbers["unfinished_share"])
    assert parts["out_of_reach"] > 0.0 and parts["left_by_settings"] > 0.0
    assert "the tool cannot reach (tighter than the cutter)" in verdict(figures, numbers).text
    assert f"(out of reach {100.0 * parts['out_of_reach']:.1f} %" in " ".join(as_text(figures).split())


def test_whole_stretches_in_a_corner_have_what_stays_looked_for():
    corner = report_finding(Code.CORNER_NOT_REACHED, say("A corner."))
    assert leaves_out((replace(corner, within=0.0),)) and not leaves_out((corner,))
    assert leaves_out((found_of(Code.AXIS_INTO_PART, 3.0, None),)) and not leaves_out(())


@some_in_core("rest", ["off", "on"])
@pytest.mark.parametrize(("scallop", "severity"), [(0.2, Severity.NOTE), (0.01, Severity.WARNING)])
def test_a_corner_in_which_the_map_finds_nothing_is_a_note(scallop, severity, rest):
    """A valley whose sides rise by 0.35 in 1: a ball of 3 mm leaves 3 (1 / cos 19.3 deg - 1) = 0.18 mm in
    it."""
    valley = prism([(-10, 0), (10, 0), (10, 6), (0, 2.5), (-10, 6)], 10.0)
    given = {"machine": "trunnion_ac", "cutter": "ball:6", "scallop": scallop, "spindle": "off", "rest": rest}
    result = job.prove(job.make(build_settings("mill", "valley", given), mesh=valley))
    (corner,) = [one for one in result.findings if one.code == Code.CORNER_NOT_REACHED]
    assert (Code.UNCUT in {one.code for one in result.findings}) == (severity is Severity.WARNING)
    severity = severity if rest == "on" else Severity.WARNING  # the quick look is too coarse for a corner
    assert corner.severity is severity
    figures = job.figures(result)
    assert ("inside corner" in verdict(figures, summary(figures)).text) == (severity is Severity.WARNING)


GROOVE = prism([(-15, 0), (15, 0), (15, 10), (6, 10), (3, 2), (-3, 2), (-6, 10), (-15, 10)], 20.0)
"""The floor is 6 mm wide, its sides lean by 21 degrees."""


def milled_groove(cutter, rest):
    given = {"machine": "trunnion_ac", "cutter": cutter, "scallop": 0.3, "spindle": "off", "rest": rest}
    return job.prove(job.make(build_settings("mill", "groove", given), mesh=GROOVE))


@pytest.mark.oldest
@pytest.mark.thorough
@pytest.mark.parametrize("cutter", ["ball:10", "ball:11"])
def test_beside_what_is_out_of_reach_as_much_stays_as_the_map_finds(cutter):
    """No cure changes anything here, and the floor alone, which no ball of 10 touches, is half of it."""
    quick, mapped = (milled_groove(cutter, rest) for rest in ("off", "on"))
    assert quick.draft.nc == mapped.draft.nc
    share, exact = (summary(job.figures(one))["unfinished_share"] for one in (quick, mapped))
    floor = sum(
        one.value for one in quick.findings if one.code == Code.FACETS_WITHOUT_FREE_AXIS
    ) / GROOVE.area[quick.draft.keep].sum()  # fmt: skip
    assert share == pytest.approx(exact, rel=0.1) and share > 1.3 * floor > 0.0


def turning():
    """A cylinder that passes about its axis cut as far as A leads."""
    return solid_of_revolution([(0.0, 15.0), (10.0, 15.0), (10.0, 0.0), (0.0, 0.0)], 48)


def test_stretches_that_the_limits_leave_out_count_as_much_as_on_the_map():
    figures = {rest: judged(turning(), passes="rotary", scallop=0.3, rest=rest) for rest in ("off", "on")}
    (found, off, message), (_, on, _) = figures.values()
    assert found["axis-beyond-limits"].within > 0.0
    assert (
        off["unfinished_share"] == pytest.approx(on["unfinished_share"], rel=0.01)
        and on["unfinished_share"] > 0.4
    )
    beyond, uncut = found["facets-beyond-machine"].value, found["uncut"].value
    whole = turning().area.sum() - found["facets-across-axis"].value  # those are no part of such passes
    assert off["unfinished_share"] == pytest.approx((beyond + uncut) / whole, rel=1e-6)
    assert "A (-120 to 120 deg)" in found["facets-beyond-machine"].text
    assert "inf" not in found["facets-beyond-machine"].text and "beyond the machine's limits" in message.text


# ------------------------------------------------------------------------------ what is suspected, and what is known

ON_TRUNNION = {"machine": "trunnion_ac", "cutter": "ball:6", "spindle": "off"}


def judged(mesh, **options):
    """Findings, figures and verdict of a part."""
    result = job.prove(job.make(build_settings("mill", "part", {**ON_TRUNNION, **options}), mesh=mesh))
    figures = job.figures(result)
    return {one.code: one for one in result.findings}, summary(figures), verdict(figures, summary(figures))


@some_in_core("rest", ["off", "on"], kept=(1,))
@pytest.mark.parametrize("passes", ["planes", "scallop"])
def test_passes_farther_apart_than_the_cutter_is_wide_leave_strips_and_are_never_safe(passes, rest):
    """On flat ground 20 mm apart a ball of 6 mm touches lines; what it sweeps to a hundredth is a millimetre."""
    found, numbers, message = judged(step(), passes=passes, stepover=20, rest=rest)
    strips = found["stepover-beyond-cutter"]
    assert (strips.value, strips.limit) == (20.0, 6.0) and "uncut" in found
    assert numbers["unfinished_share"] > 0.8 and message.light.name == "AMBER"
    assert "passes are farther apart than the cutter is wide" in message.text


def test_passes_within_the_cutters_width_leave_scallops():
    found, numbers, _ = judged(step(), passes="scallop", stepover=5.9, rest="on")
    assert "stepover-beyond-cutter" not in found and numbers["unfinished_share"] < 0.3


def rest_at(heights, areas):
    """Rest material of these heights on these areas."""
    point, none = np.zeros((len(heights), 3)), np.zeros(len(heights), int)
    return RestMaterial(point, none, np.array(areas), np.array(heights), none, 1.0)


@pytest.mark.parametrize(
    ("height", "area", "severity"), [(0.09, 0.05, "NOTE"), (0.09, 0.5, "WARNING"), (0.2, 0.05, "WARNING")]
)
def test_hardly_more_on_hardly_anything_is_a_note(height, area, severity):
    (found,) = report_uncut(rest_at([0.01, height], [1000.0, area]), 0.05)
    assert (found.code, found.value, found.severity.name) == ("uncut", area, severity)


@pytest.mark.parametrize(("uncut", "stays"), [(0.0, False), (40.0, False), (60.0, True)])
def test_a_side_that_no_pass_touches_is_left_to_the_map_where_there_is_one(uncut, stays):
    side = report_finding(Code.SIDE_NOT_MACHINED, say("a side"), 100.0)
    map_, reported = rest_at([0.0], [1.0]), [report_finding(Code.UNCUT, say("rest"), uncut, unit="mm2")]
    assert still_true((side,), None, map_, reported) == ((side,) if stays else ())
    assert still_true((side,), None, None, ()) == (side,)


@pytest.mark.oldest
@pytest.mark.thorough
def test_rings_of_slivers_narrower_than_the_passes_are_apart_are_no_sides():
    """A cup with a fillet of many narrow rings: passes go round between them, and the ball sweeps all."""
    angle = np.linspace(-math.pi / 2.0, 0.0, 14)
    fillet = [(6.0 + 5.0 * math.cos(one), 5.0 + 5.0 * math.sin(one)) for one in angle]
    outside = [(0.0, -4.0), (15.0, -4.0), (15.0, 12.0), (11.0, 12.0)]
    cup = solid_of_revolution([*outside, *fillet[::-1], (0.0, 0.0)][::-1], 36)
    found, numbers, _ = judged(cup, passes="scallop", scallop=0.05)
    assert "side-not-machined" not in found and numbers["unfinished_share"] < 0.01
