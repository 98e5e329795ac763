# SPDX-License-Identifier: LGPL-2.1-or-later
"""The arrays of the 3D view: every block is in them, the worst is never lost, and the curves are the real
ones."""

import numpy as np
import pytest
import report_examples as examples

from freecad_fiveaxis.core.report import draw, list_findings, markers, spot, summary
from freecad_fiveaxis.core.report.drawing import AXES_ACROSS, CURVE_POINTS
from freecad_fiveaxis.core.toolpath.cl_path import Motion


@pytest.fixture(scope="module")
def dome():
    return examples.dome()


@pytest.fixture(scope="module")
def picture(dome):
    return draw(dome)


def test_every_feed_block_has_its_stroke(dome, picture):
    assert np.array_equal(picture.block, dome.feeds)
    assert np.array_equal(picture.stroke[1::2], dome.tip[dome.feeds])
    assert np.array_equal(picture.stroke[::2], dome.tip[dome.feeds - 1])
    assert np.array_equal(picture.deviation, dome.deviation.segment[dome.feeds])


@pytest.mark.parametrize("most", [700, 300, 90, 25])
def test_a_long_program_is_thinned_and_keeps_its_worst_blocks(dome, most):
    thin = draw(dome, most)
    runs = summary(dome)["passes"] * 2  # each pass is led up to by one link
    assert len(thin.block) <= most + runs
    assert thin.deviation.max() == dome.deviation.segment[dome.feeds].max()
    assert set(thin.block) <= set(dome.feeds)
    assert np.isclose(thin.stroke.min(axis=0), dome.tip[dome.feeds].min(axis=0), atol=3.0).all()


def test_no_stroke_spans_a_rapid(dome):
    thin = draw(dome, 25)
    kinds = dome.program.motion
    for start, end, block in zip(thin.stroke[::2], thin.stroke[1::2], thin.block, strict=True):
        first = int(np.flatnonzero((dome.tip == start).all(axis=1))[0])
        last = int(np.flatnonzero((dome.tip == end).all(axis=1))[-1])
        assert first < block <= last
        assert len(set(kinds[first + 1 : last + 1])) == 1 and kinds[last] != Motion.RAPID


def test_the_markers_are_those_of_the_core_and_name_their_block(dome, picture):
    assert picture.markers == markers(dome)
    assert picture.markers[0].block == summary(dome)["worst_block"]
    for one in picture.markers:
        assert one.place == pytest.approx(dome.deviation.place[one.block])


def test_tool_axes_stand_apart(dome, picture):
    assert 50 < len(picture.foot) < len(dome.feeds)
    cell = np.floor((picture.foot - picture.low) / ((picture.high - picture.low).max() / AXES_ACROSS))
    assert len(np.unique(cell, axis=0)) == len(cell)
    assert np.linalg.norm(picture.axis, axis=1) == pytest.approx(1.0)
    rows = [int(np.flatnonzero((dome.tip == foot).all(axis=1))[0]) for foot in picture.foot]
    assert np.array_equal(dome.axis[rows], picture.axis)


def test_the_curve_of_table_2_overshoots_its_chord():
    figures = examples.table2()
    picture = draw(figures)
    start, end = picture.chord
    along = (end - start) / np.linalg.norm(end - start)
    beyond = (picture.curve - start) @ along
    assert len(picture.curve) == CURVE_POINTS
    assert picture.curve[[0, -1]] == pytest.approx(picture.chord)
    assert beyond.max() / np.linalg.norm(end - start) == pytest.approx(
        2.74, abs=0.01
    )  # the paper: k runs to 2.74
    foot, place = picture.spoke
    assert np.linalg.norm(place - foot) == pytest.approx(2.12642, abs=1e-4)
    assert np.linalg.norm(np.diff(picture.curve, axis=0), axis=1).sum() == pytest.approx(5.46, abs=0.01)


def test_a_spot_tells_the_numbers_of_table_2():
    reported = spot(examples.table2(), 1)
    assert reported.deviation == pytest.approx(2.12642, abs=1e-4) and reported.bound >= reported.deviation
    assert reported.turns[0] == ("C", pytest.approx(27.4208)) and reported.turns[1] == (
        "A",
        pytest.approx(0.1129),
    )
    assert reported.step == pytest.approx(1.122, abs=1e-3) and reported.singular and reported.line == 4


def test_every_finding_and_every_marker_has_a_row_in_the_list(dome):
    rows, of_marker = list_findings(dome)
    assert {row.finding for row in rows} >= set(dome.findings)
    severity = [row.finding.severity for row in rows]
    assert severity == sorted(severity, reverse=True)
    assert len(of_marker) == len(markers(dome)) and len(set(of_marker)) == len(of_marker)
    for mark, at in zip(markers(dome), of_marker, strict=True):
        assert (rows[at].kind, rows[at].finding.block, rows[at].whole) == (mark.kind, mark.block, False)
        if mark.kind != "singular-block":
            assert rows[at].finding.value == dome.deviation.segment[mark.block]
    assert [row.kind for row in rows if row.whole] == ["deviation-over-tolerance", "singular-block"]


def test_rapids_are_drawn_where_they_really_go(dome, picture):
    rows = np.flatnonzero(dome.program.motion == Motion.RAPID)[1:]
    assert len(picture.rapid) == 2 * 16 * len(rows)
    assert picture.rapid[::32] == pytest.approx(dome.tip[rows - 1], abs=1e-9)
    assert picture.rapid[31::32] == pytest.approx(dome.tip[rows], abs=1e-9)


def test_a_program_without_blocks_has_an_empty_picture():
    nothing = draw(examples.empty())
    assert (
        not len(nothing.stroke) and not len(nothing.foot) and not nothing.markers and not len(nothing.curve)
    )


def test_a_program_whose_blocks_all_stand_at_one_point_has_a_picture():
    words = np.tile([10.0, 0.0, 0.0, 0.0, 0.0], (4, 1))
    picture = draw(examples.figures_of(examples.TRUNNION, words))
    assert len(picture.block) == 3 and len(picture.foot) == 1 and not len(picture.curve)


@pytest.mark.slow
def test_a_million_blocks_are_thinned_and_the_worst_stays():
    small = examples.by_hand()
    count = 1_000_000
    words = np.zeros((count, 5))
    turn = np.linspace(0.0, 200.0, count)
    words[:, 0], words[:, 1], words[:, 4] = 40 * np.cos(turn), 40 * np.sin(turn), 10.0
    program = examples.program_of(small.kinematics, words)
    zero = np.zeros(count)
    segment = 0.01 * np.abs(np.sin(turn))
    segment[777_777] = 3.0
    result = type(small.deviation)(zero, zero, segment, zero, segment, zero, np.zeros((count, 3)))
    near = type(small.singularity)(zero, zero, zero, zero.astype(bool))
    figures = type(small)("long", "audit", small.machine, small.kinematics, program, result, near, 0.01)
    picture = draw(figures)
    assert len(picture.block) <= 600_000 and picture.deviation.max() == 3.0 and 777_777 in picture.block
