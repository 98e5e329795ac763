# SPDX-License-Identifier: LGPL-2.1-or-later
"""Summary, findings, JSON, text and markers."""

import dataclasses
import json
import math
from pathlib import Path

import numpy as np
import pytest
from report_examples import TABLE2, TRUNNION, by_hand, dome, empty, figures_of, program_of, sampled, table2

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.motion.program.guided import Guided
from freecad_fiveaxis.core.report import as_json, as_text, markers
from freecad_fiveaxis.core.report.figures import axis_rates, summary, worst_first
from freecad_fiveaxis.core.report.json_text import plain
from freecad_fiveaxis.core.report.judgement import judge
from freecad_fiveaxis.core.report.text import duration, facts, number, path_verdict

CALM = np.array([[0, 0, 0, 0, 0], [1, 0, 0, 0, 0], [2, 0, 0, 0, 0.1], [2.5, 0, 0, 0, 0.2]], float)


def test_the_counts_are_those_counted_by_hand():
    numbers = summary(by_hand())
    assert (numbers["blocks"], numbers["feed_blocks"]) == (7, 5)
    assert (numbers["over_tolerance"], numbers["unproven"], numbers["singular_blocks"]) == (2, 1, 1)
    assert (numbers["max_segment_deviation"], numbers["max_bound"], numbers["max_line_deviation"]) == (
        0.03,
        0.031,
        0.015,
    )
    assert (numbers["worst_block"], numbers["worst_line"]) == (4, 7)
    assert numbers["passes"] == 2
    assert numbers["max_axis_deviation_deg"] == pytest.approx(math.degrees(0.001))
    assert numbers["rotary_travel_deg"] == {"A": 0.0, "C": 90.0}
    assert numbers["findings"] == {"error": 3, "warning": 2, "note": 0}


def test_each_largest_number_has_its_line():
    """Blocks stand in the lines 3 to 9; the ball's centre deviates most in another block than the tip."""
    figures = by_hand()
    centre = dataclasses.replace(figures.deviation, segment=np.array([0.0, 0.04, 0.0, 0.0, 0.0, 0.0, 0.0]))
    axis = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.002])
    tip = dataclasses.replace(figures.deviation, axis=axis)
    figures = dataclasses.replace(figures, surface=centre, deviation=tip)
    numbers = summary(figures)
    assert numbers["worst_line"] == 4 and numbers["worst_lines"] == {
        "max_surface_deviation": 4,
        "max_surface_bound": 7,
        "max_line_deviation": 7,
        "max_segment_deviation": 7,
        "max_bound": 7,
        "max_axis_deviation_deg": 9,
        "max_rapid_deviation": 6,
    }
    reported = dict(facts(numbers))
    assert reported["largest deviation of the ball's centre"] == "0.040000 mm (NC line 4)"
    assert reported["largest deviation of the tip"] == "0.030000 mm (NC line 7)"
    lines = summary(dataclasses.replace(figures, surface=None))["worst_lines"]
    assert lines["max_surface_deviation"] is None and lines["max_segment_deviation"] == 7


def test_a_rapid_is_not_judged_but_reported():
    assert summary(by_hand())["max_rapid_deviation"] == 0.5
    numbers = summary(dataclasses.replace(by_hand(), tolerance=0.04))
    assert numbers["over_tolerance"] == 0 and numbers["proven"]


@pytest.mark.parametrize(
    ("tolerance", "over", "unproven"),
    [(0.0301, 0, 1), (0.031, 0, 0), (0.02, 1, 1), (0.0199, 2, 0), (0.001, 5, 0)],
)
def test_a_block_is_over_only_beyond_the_tolerance(tolerance, over, unproven):
    numbers = summary(by_hand(tolerance))
    assert (numbers["over_tolerance"], numbers["unproven"]) == (over, unproven)
    assert numbers["proven"] == (over == unproven == 0)


def test_a_deviation_that_is_no_number_is_never_proven():
    figures = by_hand(1.0)
    segment = figures.deviation.segment.copy()
    segment[2] = math.nan
    figures = dataclasses.replace(figures, deviation=dataclasses.replace(figures.deviation, segment=segment))
    assert summary(figures)["over_tolerance"] == 1 and not summary(figures)["proven"]


def test_lengths_and_times_are_those_of_the_path():
    figures = figures_of(TRUNNION, CALM)
    numbers = summary(figures)
    chords = np.linalg.norm(np.diff(figures.tip, axis=0), axis=1)
    assert numbers["cut_length"] == pytest.approx(chords.sum())
    assert numbers["time_s"] == pytest.approx(chords.sum() / 1000 * 60)
    assert numbers["axes"]["X"]["travel"] == 2.5 and numbers["axes"]["X"]["largest"] == 2.5
    assert numbers["axes"]["A"]["high_limit"] == pytest.approx(120.0)
    assert numbers["axes"]["X"]["peak_rate"] == pytest.approx(1000.0)


def test_cuts_links_and_rapids_make_up_the_whole_way_and_the_whole_time():
    """By hand: the motions are rapid, link, cut, rapid, cut, fill, cut; each block is 1 mm long, but the one
    that turns the table."""
    figures = by_hand()
    seconds = np.array([9.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    numbers = summary(
        dataclasses.replace(figures, program=dataclasses.replace(figures.program, seconds=seconds))
    )
    turned = np.hypot(3.0, 4.0)  # C turns by 90 deg on the way from (3, 0, 0) to (0, 4, 0) or (0, -4, 0)
    assert numbers["cut_length"] == pytest.approx(3.0 + turned)
    assert numbers["link_length"] == numbers["rapid_length"] == pytest.approx(1.0)
    assert numbers["time_shares"] == pytest.approx({"cut": 17 / 21, "link": 1 / 21, "rapid": 3 / 21})
    reported = dict(facts(numbers))
    assert reported["length of links, of rapids"] == "1.0 mm, 1.0 mm"
    assert reported["time"] == "30.0 s (cut 81 %, link 5 %, rapid 14 %)"


def test_a_rate_is_travel_by_time_and_none_without_time():
    program = figures_of(TRUNNION, CALM).program
    rates = axis_rates(dataclasses.replace(program, seconds=np.array([0.0, 30.0, 0.0, 6.0])))
    np.testing.assert_allclose(rates[:, 0], [0.0, 2.0, 0.0, 5.0])
    np.testing.assert_allclose(rates[3, 4], 1.0)


# --------------------------------------------------------------------------------------------------- findings


def test_table_2_is_an_error_and_a_warning_with_their_numbers():
    over, near = table2().findings
    assert (over.code, over.severity, over.block, over.line, over.unit, over.limit) == (
        "deviation-over-tolerance",
        2,
        1,
        4,
        "mm",
        0.01,
    )
    assert over.value == pytest.approx(2.12642, abs=5e-5)
    assert "2.1264 mm" in over.text and "C turns 27.42 deg" in over.text and "1.122 mm" in over.text
    assert (near.code, near.severity, near.unit) == ("singular-block", Severity.WARNING, "deg")
    assert near.value == pytest.approx(TABLE2[0, 3] - TABLE2[1, 3])
    assert near.place == over.place == tuple(table2().deviation.place[1])


def near_pole(turn: float, feed: float, **more):
    """What is said of one block of 2 mm of tip travel near the pole in which C turns by ``turn`` deg,
    tolerance 1 mm."""
    kinematics = chain(TRUNNION, Setup())
    words = np.array([[0.0, 0.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, turn, 0.0]])
    program = dataclasses.replace(program_of(kinematics, words, feed=feed), **more)
    deviation, singularity = sampled(kinematics, program.words)
    assert singularity.singular[1]
    return judge(kinematics, program, deviation, singularity, 1.0)


def test_blocks_near_the_pole_that_hold_the_tolerance_at_their_feed_are_a_note():
    (one,) = near_pole(2.0, 500.0)
    assert (one.code, one.severity, one.block, one.value) == ("singular-block", Severity.NOTE, 1, 2.0)
    assert "C turns 2 deg" in one.text and "by proof" in one.text


def test_blocks_near_the_pole_are_a_warning_where_an_axis_is_held_back_or_nobody_knows():
    over = near_pole(120.0, 500.0)
    held, rate = near_pole(2.0, 50_000.0), np.rad2deg(chain(TRUNNION, Setup()).rate[3])
    unknown, guided = (
        near_pole(2.0, 500.0, seconds=np.zeros(2)),
        Guided(np.array([False, True]), np.zeros((2, 3))),
    )
    hidden = near_pole(2.0, 500.0, guided=guided)
    assert 2.0 / rate > 2.0 / 50_000.0, "the axis is slower than the feed here"
    for found in (over, held, unknown, hidden):
        assert [one.severity for one in found if one.code == "singular-block"] == [Severity.WARNING]


def test_findings_explain_themselves_in_plain_words():
    for one in table2().findings:
        assert "singular" not in one.text and "pole" in one.text and one.text.endswith(".")


def test_ten_single_blocks_follow_the_one_for_all_worst_first():
    figures = dome()
    for code in ("deviation-over-tolerance", "singular-block"):
        group = [one for one in figures.findings if one.code == code]
        assert len(group) == 11
        assert group[0].value == group[1].value and group[0].block == group[1].block
        values = [one.value for one in group[1:]]
        assert values == sorted(values, reverse=True) and len({one.block for one in group[1:]}) == 10
    assert str(summary(figures)["over_tolerance"]) in figures.findings[0].text


@pytest.mark.parametrize("most", [1, 2, 5, 40])
def test_the_first_of_the_worst_are_those_of_all(most):
    values = np.random.default_rng(4).integers(0, 6, 60).astype(float)  # many equals
    values[[7, 30]] = np.nan
    rows = np.arange(3, 50)
    np.testing.assert_array_equal(worst_first(rows, values, most), worst_first(rows, values)[:most])
    assert not len(worst_first(rows[:0], values, most))


def test_only_the_bound_over_the_tolerance_is_a_warning():
    (one,) = [one for one in by_hand().findings if one.code == "bound-over-tolerance"]
    assert (one.severity, one.block, one.value) == (Severity.WARNING, 5, 0.0101)


def test_a_calm_program_has_no_findings():
    assert figures_of(TRUNNION, CALM).findings == ()


# ------------------------------------------------------------------------------------------------------- JSON


def test_json_has_the_keys_that_scripts_rely_on():
    report = json.loads(
        as_json(table2(inputs={"machine": "mikron_ucp710", "origin": None, "report": ("a.json",)}))
    )
    assert report["version"] == 1
    wanted = {
        "blocks",
        "time_s",
        "max_line_deviation",
        "max_segment_deviation",
        "max_bound",
        "worst_line",
        "singular_blocks",
    }
    assert wanted | {
        "over_tolerance",
        "max_axis_deviation_deg",
        "tolerance",
        "passes",
        "cut_length",
        "proven",
    } <= set(report["summary"])
    assert report["summary"]["worst_line"] == 4 and report["summary"]["proven"] is False
    assert (
        report["findings"][0]["severity"] == "error"
        and report["findings"][0]["code"] == "deviation-over-tolerance"
    )
    assert len(report["findings"][0]["place"]) == 3
    assert report["inputs"] == {"machine": "mikron_ucp710", "origin": None, "report": ["a.json"]}
    assert report["worst_blocks"][0]["line"] == 4


def test_json_has_no_infinities_and_keeps_umlauts():
    text = as_json(table2(title="Gehäuse Ω.ngc"))
    assert "Gehäuse Ω.ngc" in text and "Infinity" not in text and "NaN" not in text
    assert json.loads(text)["summary"]["axes"]["C"]["high_limit"] is None


def test_plain_turns_everything_into_jsons_own_kinds():
    given = {
        "a": np.float64("nan"),
        "b": np.arange(3),
        "c": Path("x/y"),
        4: Severity.NOTE,
        "d": {1.5},
        "e": Finding(Severity.ERROR, "x", "y."),
        "f": np.bool_(True),
        "g": -math.inf,
    }
    result = plain(given)
    assert (result["a"], result["b"], result["c"], result["4"]) == (None, [0, 1, 2], str(Path("x/y")), "note")
    assert (result["d"], result["e"]["severity"], result["f"], result["g"]) == ([1.5], "error", True, None)
    json.dumps(result, allow_nan=False)
    with pytest.raises(ValueError, match="JSON"):
        json.dumps({"a": math.nan}, allow_nan=False)


# ------------------------------------------------------------------------------------------------------- text


@pytest.mark.parametrize("make", [table2, by_hand, dome, empty, lambda: figures_of(TRUNNION, CALM)])
def test_text_keeps_to_a_hundred_columns(make):
    figures = dataclasses.replace(make(), title="a very long name of a part " * 8)
    text = as_text(figures)
    assert max(map(len, text.splitlines())) <= 100
    assert text.endswith("\n")


def test_text_shows_the_worst_block_first():
    text = as_text(dome())
    rows = text[text.index("Worst blocks") :].splitlines()[2:12]
    values = [float(row.split()[2]) for row in rows]
    assert values == sorted(values, reverse=True) and len(values) == 10
    assert int(rows[0].split()[0]) == summary(dome())["worst_line"]
    assert len({len(row) for row in rows}) == 1


def test_text_columns_are_those_of_this_machine():
    text = as_text(table2())
    assert text.index("A turns") < text.index("C turns")
    assert "121.548  148.969" in text and "27.421" in text


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: figures_of(TRUNNION, CALM), "None of the 3 feed blocks leaves"),
        (table2, "1 block leaves the commanded path by more than 0.01 mm; the worst, line 4, by 2.126 mm."),
        (
            by_hand,
            "2 of 5 feed blocks leave the commanded path by more than 0.01 mm; the worst, line 7, by 0.03 mm.",
        ),
        (lambda: by_hand(0.0301), "Not proven: "),
        (empty, "Nothing to prove"),
    ],
)
def test_what_is_stated_of_the_path_is_one_plain_sentence(make, message):
    figures = make()
    assert path_verdict(figures, summary(figures)).startswith(message)
    assert message.split()[0] in as_text(figures)


@pytest.mark.parametrize(
    ("seconds", "message"),
    [
        (0.04, "0.0 s"),
        (59.94, "59.9 s"),
        (61.0, "1 min 01 s"),
        (3599.6, "1 h 00 min 00 s"),
        (7384, "2 h 03 min 04 s"),
    ],
)
def test_durations_read_well(seconds, message):
    assert duration(seconds) == message


def test_numbers_without_a_value_are_dashes_and_none_is_minus_zero():
    assert [number(value, 2) for value in (None, math.inf, math.nan, -0.001, 1.005)] == [
        "-",
        "-",
        "-",
        "0.00",
        "1.00",
    ]


# ---------------------------------------------------------------------------------------------------- markers


def test_markers_stand_at_the_worst_block_of_each_run():
    result = markers(by_hand())
    kinds = [one.kind for one in result]
    assert kinds == [
        "largest-deviation",
        "deviation-over-tolerance",
        "deviation-over-tolerance",
        "singular-block",
        "bound-over-tolerance",
    ]
    assert result[0].place == (4.0, 2.0, 3.0) and result[0].label == "0.03 mm, line 7"
    assert [one.place[0] for one in result[1:3]] == [4.0, 2.0]
    assert result[3].label == "turns 90 deg, line 7"
    assert result[0].finding is not None and result[0].finding.block == 4
    assert result[3].finding is not None and result[3].finding.code == "singular-block"


def test_a_run_of_neighbours_has_one_marker():
    figures = dome(passes=2, points=40, tolerance=1e-6)
    over = [one for one in markers(figures) if one.kind == "deviation-over-tolerance"]
    count = summary(figures)["over_tolerance"]
    flags = np.zeros(len(figures.program.words) + 1, bool)
    flags[figures.feeds] = figures.deviation.segment[figures.feeds] > 1e-6
    runs = int((np.diff(flags.astype(int)) == 1).sum())
    assert len(over) == runs < count


def test_other_findings_with_a_place_are_markers_too():
    found = (
        Finding(Severity.NOTE, "open-edge", "An edge is open.", place=(1.0, 2.0, 3.0)),
        Finding(Severity.NOTE, "x", "No place."),
    )
    result = markers(dataclasses.replace(figures_of(TRUNNION, CALM), findings=found))
    assert [(one.kind, one.label, one.place) for one in result[1:]] == [
        ("open-edge", "open edge", (1.0, 2.0, 3.0))
    ]


def test_a_program_without_blocks_has_no_markers():
    assert markers(empty()) == ()


def test_what_arithmetic_leaves_of_no_deviation_is_no_deviation():
    """Neither text nor page name a worst block, draw one, or give a number of it; the figures stay as they
    are."""
    figures = table2()
    exact = np.where(np.isfinite(figures.deviation.segment), 8e-15, np.nan)
    none = dataclasses.replace(
        figures, deviation=dataclasses.replace(figures.deviation, segment=exact, bound=exact), findings=()
    )
    assert "Worst blocks" in as_text(figures) and "Worst blocks" not in as_text(none)
    assert "largest deviation 0 mm, proven bound 1e-09 mm" in " ".join(as_text(none).split())
    assert summary(none)["max_segment_deviation"] == 8e-15
