# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a path cuts at the part, and fewer passes for a small picture: those that stay are apart, and
nothing bad is left out."""

import numpy as np
import pytest
import report_examples as examples

from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.report import draw
from freecad_fiveaxis.core.report.near_part import NEAR, near_part, stand_of
from freecad_fiveaxis.core.report.thinning import COATS, coats, distances
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.cl_path import Motion

SQUARE = np.array([[[0, 0, 0], [40, 0, 0], [40, 40, 0]], [[0, 0, 0], [40, 40, 0], [0, 40, 0]]], float)


def lines(spacing, count, length=40.0, steps=20):
    """Straight passes along x beside each other: start and end of their strokes, and the pass of each."""
    x = np.linspace(0.0, length, steps + 1)
    rows = np.stack(np.broadcast_arrays(x[None, :], spacing * np.arange(count)[:, None], 0.0), axis=-1)
    return rows[:, :-1].reshape(-1, 3), rows[:, 1:].reshape(-1, 3), np.repeat(np.arange(count), steps)


def test_passes_of_each_coat_are_apart_and_the_coats_are_nested():
    start, end, owner = lines(0.25, 161)
    diagonal = 40.0 * np.sqrt(2.0)
    widest, apart = coats(start, end, diagonal), distances(diagonal)
    assert len(apart) == COATS
    left = [np.unique(owner[widest >= coat]) for coat in range(COATS + 1)]
    assert len(left[0]) == 161 and left[-1][0] == 0
    for coat, passes in enumerate(left[1:]):
        gap = 0.25 * np.diff(passes)
        assert gap.min() > 0.8 * apart[coat] and gap.max() < 2.0 * apart[coat] + 0.5, coat
        assert set(passes) <= set(left[coat])
    assert all((np.unique(widest[owner == one]).size == 1) for one in range(161)), "whole passes are left out"


def test_a_spiral_is_thinned_too_though_it_is_one_pass():
    turn = np.linspace(0.0, 100.0 * np.pi, 8001)
    points = np.stack(
        [0.4 * turn / (2 * np.pi) * np.cos(turn), 0.4 * turn / (2 * np.pi) * np.sin(turn), 0.0 * turn],
        axis=-1,
    )
    widest = coats(points[:-1], points[1:], 57.0)
    left = [(widest >= coat).sum() for coat in range(COATS + 1)]
    assert left[0] == 8000 and left[-1] < 0.25 * 8000
    assert (np.diff(left) <= 0).all()


@pytest.mark.parametrize(("count", "diagonal"), [(0, 10.0), (1, 0.0)])
def test_nothing_and_a_point_are_no_error(count, diagonal):
    assert (coats(np.zeros((count, 3)), np.zeros((count, 3)), diagonal) == 0).all()


def test_what_is_over_the_tolerance_is_in_every_coat_and_so_are_links():
    picture = draw(examples.dome())
    assert (picture.coat[picture.level > 0.5] == COATS).all()
    assert (picture.coat[~picture.cut] == COATS).all()
    assert picture.coat[picture.cut].min() < COATS


def test_without_a_part_all_but_links_cut():
    figures = examples.dome()
    picture = draw(figures)
    assert figures.mesh is None
    assert (picture.cut == (figures.program.motion[picture.block] != Motion.LINK)).all()


def test_places_that_are_lifted_off_the_part_are_reported_from_those_at_it():
    mesh = from_triangles(SQUARE)
    place = np.array(
        [
            [5.0, 5.0, 0.0],
            [5.0, 5.0, NEAR - 0.01],
            [5.0, 5.0, NEAR + 0.01],
            [5.0, 5.0, 50.0],
            [-3.0, 5.0, 0.0],
        ]
    )
    assert near_part(mesh, place, 0.0).tolist() == [True, True, False, False, False]
    assert near_part(mesh, place, 3.0).tolist() == [True, True, True, False, True]


def test_a_flat_tool_that_leans_may_stand_off_and_one_that_stands_upright_may_not():
    up, lean = np.array([[0.0, 0.0, 1.0]]), np.array([[np.sin(0.1), 0.0, np.cos(0.1)]])
    assert stand_of(Cutter(10.0, corner=1.0), up, up) == 0.0
    assert stand_of(Cutter(10.0, corner=1.0), up, lean) == pytest.approx(
        4.0 * np.sin(0.1) + 1.0 - np.cos(0.1)
    )
    assert stand_of(Cutter(10.0), up, lean) < 0.03


def test_strokes_to_lifted_rows_do_not_cut():
    from dataclasses import replace

    figures = examples.by_hand()
    low, high = figures.tip.min(axis=0), figures.tip.max(axis=0)
    far = from_triangles(SQUARE + low - (0.0, 0.0, 100.0))
    assert draw(figures).cut.any()
    assert not draw(replace(figures, mesh=far)).cut.any() and (high >= low).all()
