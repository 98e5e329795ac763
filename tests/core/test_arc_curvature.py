# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lin & Ye's radius of curvature (eq. 8): arcs by hand, the paper's own way with two normal lines, meshes of
known shapes."""

import sys
from pathlib import Path

import numpy as np
import pytest
from offset_examples import prism

sys.path.insert(0, str(Path(__file__).parents[2] / "docs" / "studies"))

import lin_ye_curvature as study

from freecad_fiveaxis.core.passes import arc_centre, arc_curvature, pass_curvature


def turned(rng, *columns):
    """The same vectors in a frame turned at random."""
    frame = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    frame *= np.sign(np.linalg.det(frame))
    return [column @ frame.T for column in columns]


def on_arc(radius, start, end):
    """Points and normals (n, 3) of arcs about 0 in the plane y = 0, convex for a radius above 0."""
    one, two = (np.column_stack([np.sin(angle), 0 * angle, np.cos(angle)]) for angle in (start, end))
    return abs(radius) * one, abs(radius) * two, np.sign(radius) * one, np.sign(radius) * two


@pytest.mark.parametrize("radius", [0.3, 60.0, -25.0])
def test_on_an_arc_radius_and_centre_are_exact_whatever_the_step(radius):
    rng = np.random.default_rng(1)
    start = rng.uniform(-np.pi, np.pi, 50)
    end = start + np.sign(radius) * 10.0 ** rng.uniform(-5, 0.4, 50)
    points = turned(rng, *on_arc(radius, start, end))
    assert arc_curvature(*points) == pytest.approx(1.0 / radius, rel=1e-6)
    wide = np.abs(end - start) > 1e-3
    assert arc_centre(*(column[wide] for column in points)) == pytest.approx(0.0, abs=1e-6 * abs(radius))


def test_radius_and_centre_are_those_of_the_paper_s_construction():
    """Where the two normal lines meet, by least squares; R the mean of its distances; the centre has both
    equations of (8)."""
    rng = np.random.default_rng(2)
    count = 200
    one, two = (
        np.zeros((count, 3)),
        np.column_stack([rng.uniform(0.5, 5.0, count), np.zeros(count), np.zeros(count)]),
    )
    lean = np.sort(rng.uniform(-0.6, 0.6, (count, 2)), axis=1)
    lean[::2] = lean[::2, ::-1]  # hollow
    normals = [np.column_stack([np.sin(angle), 0 * angle, np.cos(angle)]) for angle in lean.T]
    curvature, centre = arc_curvature(one, two, *normals), arc_centre(one, two, *normals)
    for k in range(count):
        lines = np.column_stack([normals[0][k, [0, 2]], -normals[1][k, [0, 2]]])
        away = np.linalg.solve(
            lines, (two - one)[k, [0, 2]]
        )  # signed distances from both points to where the lines meet
        assert -1.0 / curvature[k] == pytest.approx(away.mean(), rel=1e-9)
    round_ = np.isfinite(centre).all(axis=1)
    for point in (one, two):
        assert np.linalg.norm(point - centre, axis=1)[round_] == pytest.approx(
            1.0 / np.abs(curvature[round_]), rel=1e-9
        )
    assert (np.sign(centre[round_, 2]) == -np.sign(curvature[round_])).all() and round_.sum() > 150


def test_flats_and_points_that_are_one_have_no_circle():
    up, one = np.tile([0.0, 0.0, 1.0], (2, 1)), np.zeros((2, 3))
    two = np.array([[3.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    assert arc_curvature(one, two, up, up) == pytest.approx([0.0, np.nan], nan_ok=True)
    assert np.isnan(arc_centre(one, two, up, up)).all()


def test_along_a_polygon_in_a_circle_it_is_that_of_the_mean_normals_and_open_ends_have_none():
    angle = np.radians([160, 150, 125, 100, 88, 60, 45, 20])
    corner = 60.0 * np.column_stack([np.cos(angle), np.sin(angle)])
    found = pass_curvature(prism(corner))
    assert np.isnan(found[[0, -1]]).all()
    turn = -np.diff(angle)  # of each chord; the normals of its ends lean by a1 and a2
    a1, a2 = -0.25 * (turn[:-2] + turn[1:-1]), 0.25 * (turn[1:-1] + turn[2:])
    chord = 120.0 * np.sin(0.5 * turn[1:-1])
    assert found[1:-1] == pytest.approx(2.0 * np.sin(0.5 * (a2 - a1)) / (chord * np.cos(0.5 * (a1 + a2))))
    angle = 2.0 - 0.2 * np.arange(9)
    even = pass_curvature(prism(60.0 * np.column_stack([np.cos(angle), np.sin(angle)])))
    assert even[1:-1] == pytest.approx(1.0 / 60.0)  # the mean normals are then the circle's own


def test_a_closed_polyline_has_a_curvature_at_its_seam_too():
    corner = 10.0 * np.column_stack([np.cos(-np.arange(12) * np.pi / 6), np.sin(-np.arange(12) * np.pi / 6)])
    assert pass_curvature(prism(corner, closed=True)) == pytest.approx(0.1)


@pytest.mark.parametrize("surface", study.SURFACES)
def test_on_meshes_it_is_right_in_the_mean_over_a_pass_and_the_neighbourhood_step_by_step(surface):
    by_arc, by_mean, exact, length = study.curvatures(study.SURFACES[surface]())
    whole = (exact * length).sum()
    assert (by_arc * length).sum() == pytest.approx(whole, rel=0.15)
    assert (by_mean * length).sum() == pytest.approx(whole, rel=0.05)
    off_arc, off_mean = (np.percentile(np.abs(found - exact), 50) for found in (by_arc, by_mean))
    assert off_mean < 0.5 * off_arc
