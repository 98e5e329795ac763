# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scale of a path's colours: it ends where the path's deviations do, and what is over the tolerance is
always seen to be."""

from dataclasses import replace

import numpy as np
import pytest
from report_examples import dome as example

from freecad_fiveaxis.core.report import draw, scale_end, scale_marks
from freecad_fiveaxis.core.report.deviation_scale import APART, level_of


@pytest.fixture(scope="module")
def dome():
    return example()


def test_the_scale_stands_about_the_tolerance_and_ends_at_the_largest_deviation():
    deviation = np.array([0.0, 1e-4, 1e-3, 0.01, 0.1, 1.0, 50.0, np.nan])
    assert level_of(deviation, 0.01, 1.0) == pytest.approx([0, 0, 0.25, 0.5, 0.75, 1, 1, 1])
    assert level_of(deviation[:6], 0.01, 0.1) == pytest.approx([0, 0, 0.25, 0.5, 1, 1])
    assert dict(scale_marks(0.01, 1.0)) == pytest.approx(
        {0.0: 1e-4, 0.25: 1e-3, 0.5: 1e-2, 0.75: 0.1, 1.0: 1.0}
    )
    assert dict(scale_marks(0.01, 0.03)) == pytest.approx({0.0: 1e-4, 0.25: 1e-3, 0.5: 1e-2, 1.0: 0.03})


def test_the_scale_of_a_path_within_the_tolerance_ends_there():
    assert dict(scale_marks(0.01, 0.01)) == pytest.approx({0.0: 1e-4, 0.25: 1e-3, 0.5: 1e-2})
    assert (level_of(np.linspace(0.0, 0.01, 1000), 0.01, 0.01) <= 0.5).all()


@pytest.mark.parametrize("end", [0.0100001, 0.0102, 0.03, 0.1, 0.11, 1.0, 2.126, 1e4])
def test_each_mark_stands_where_its_value_does_and_can_be_read(end):
    level, value = np.transpose(scale_marks(0.01, end))
    assert level_of(value, 0.01, end) == pytest.approx(level)
    assert value[-1] == end and level[-1] == 1.0
    assert (np.diff(level) >= 0.5 * APART).all() and level[-1] - level[-2] >= APART


@pytest.mark.parametrize("tolerance", [0.01, 0.003, 0.1 + 0.2])
@pytest.mark.parametrize("times", [1.0 + 1e-12, 1.5, 1e3, np.inf])
def test_the_least_bit_over_the_tolerance_is_above_the_middle_and_what_is_no_more_is_not(tolerance, times):
    end = max(np.nextafter(tolerance, 1.0), tolerance * min(times, 1e9))
    over = np.array([np.nextafter(tolerance, 1.0), end, np.nan])
    assert (level_of(over, tolerance, end) > 0.5).all() and level_of(over[1:], tolerance, 2.0 * tolerance)[
        -1
    ] == 1.0
    assert (level_of(np.array([tolerance, np.nextafter(tolerance, 0.0)]), tolerance, end) <= 0.5).all()


def test_a_program_is_coloured_on_its_own_scale(dome):
    largest = dome.judged.segment[dome.feeds].max()
    assert largest > dome.tolerance and scale_end(dome) == largest
    assert draw(dome).level.max() == 1.0
    assert ((draw(dome).level > 0.5) == (draw(dome).deviation > dome.tolerance)).all()
    wide = replace(dome, tolerance=2.0 * largest)
    assert scale_end(wide) == wide.tolerance and draw(wide).level.max() < 0.5
