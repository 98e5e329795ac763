# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool axes: the paper's equations by hand, signs of lead and tilt, and every way in which a direction can be
missing."""

from dataclasses import replace

import numpy as np
import pytest
from offset_examples import joined, prism

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.orientation.strategies import STRATEGIES, AxisOptions, find_strategy, tool_axes
from freecad_fiveaxis.core.toolpath.coedge import close_gaps
from freecad_fiveaxis.core.toolpath.feed_direction import feed_direction

MESH = from_faces([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
UNEVEN = [(0, 0), (3, 4), (13, 4), (25, -1), (40, -1), (60, 9)]


def offset(*profiles, skew=(0.0, 1.0, 0.0), closed=False):
    parts = [prism(profile, skew, closed) for profile in profiles]
    return close_gaps(parts[0] if len(parts) == 1 else joined(*parts), MESH, 2.0, 0.1)


def angle(one, two):
    return np.arctan2(np.linalg.norm(np.cross(one, two), axis=-1), (one * two).sum(-1))


def plain(strategy, path, **options):
    return tool_axes(path, strategy, AxisOptions(**options))


def test_facet_mean_halves_the_angle_between_the_facet_normals():
    path = offset(UNEVEN, skew=(0.2, 1, 0.1))
    axis = plain("facet_mean", path)
    np.testing.assert_allclose(angle(path.before, axis), angle(axis, path.after), atol=1e-12)
    np.testing.assert_allclose(angle(path.before, axis) * 2, angle(path.before, path.after), atol=1e-12)


def test_step_weighted_divides_the_angle_as_equations_9_and_10():
    path = offset(UNEVEN, skew=(0.2, 1, 0.1))
    axis = plain("step_weighted", path)
    theta, total = angle(path.before, path.after), path.step_before + path.step_after
    np.testing.assert_allclose(angle(path.before, axis), path.step_after / total * theta, atol=1e-12)
    np.testing.assert_allclose(angle(axis, path.after), path.step_before / total * theta, atol=1e-12)
    assert np.abs(axis - plain("facet_mean", path)).max() > 0.01


def test_step_weighted_is_nearly_the_mean_weighted_with_the_lengths():
    path = offset([(0, 0), (4, 0), (16, -1)])
    mean = path.step_before[:, None] * path.before + path.step_after[:, None] * path.after
    mean /= np.linalg.norm(mean, axis=1)[:, None]
    assert angle(plain("step_weighted", path), mean).max() < 1e-4


def test_equal_steps_give_the_conventional_axis():
    path = offset([(0, 0), (10, 5), (20, 0), (30, 5)])
    np.testing.assert_allclose(plain("step_weighted", path), plain("facet_mean", path), atol=1e-14)


@pytest.mark.parametrize("strategy", [name for name in STRATEGIES if name != "face_normal"])
@pytest.mark.parametrize("options", [{}, {"lead": 0.2, "tilt": -0.1}])
def test_all_rows_of_one_contact_point_share_the_axis(strategy, options):
    path = offset(UNEVEN, skew=(0.2, 1, 0.1))
    axis = plain(strategy, path, **options)
    same = (path.before[1:] == path.before[:-1]).all(axis=1) & (path.after[1:] == path.after[:-1]).all(axis=1)
    assert np.count_nonzero(same & path.fill[1:]) > 4
    np.testing.assert_allclose(axis[1:][same], axis[:-1][same], atol=1e-14)


def test_the_fixed_axis_is_built_unit():
    axis = plain("fixed", offset(UNEVEN), fixed=(0, 3, 4))
    np.testing.assert_allclose(axis, np.broadcast_to((0, 0.6, 0.8), axis.shape), atol=1e-16)


@pytest.mark.parametrize("fixed", [(0, 0, 0), (np.nan, 0, 1), (np.inf, 0, 0)])
def test_a_fixed_axis_without_direction_is_refused(fixed):
    with pytest.raises(SettingsError, match="give three numbers"):
        plain("fixed", offset(UNEVEN), fixed=fixed)


def test_an_unknown_strategy_is_refused_with_those_known():
    with pytest.raises(
        SettingsError, match="'magic'; choose one of facet_mean, step_weighted, minimax, auto, fixed"
    ):
        plain("magic", offset(UNEVEN))
    assert find_strategy("fixed") is STRATEGIES["fixed"]


@pytest.mark.parametrize("name", ["lead", "tilt"])
def test_a_lean_that_is_no_number_is_refused(name):
    with pytest.raises(SettingsError, match=name):
        plain("fixed", offset(UNEVEN), **{name: np.nan})


def test_positive_lead_leans_forward_along_the_feed():
    axis = plain("fixed", offset([(0, 0), (10, 0), (30, 0)]), lead=0.3)
    np.testing.assert_allclose(axis, np.broadcast_to((np.sin(0.3), 0, np.cos(0.3)), axis.shape), atol=1e-15)


def test_positive_tilt_leans_to_the_right_of_the_feed():
    axis = plain("fixed", offset([(0, 0), (10, 0), (30, 0)]), tilt=0.3)
    np.testing.assert_allclose(axis, np.broadcast_to((0, -np.sin(0.3), np.cos(0.3)), axis.shape), atol=1e-15)


def test_lead_and_tilt_turn_by_the_angles_that_were_requested():
    path = offset(UNEVEN, skew=(0.2, 1, 0.1))
    axis = plain("facet_mean", path)
    for options in ({"lead": 0.4}, {"tilt": -0.25}):
        np.testing.assert_allclose(
            angle(axis, plain("facet_mean", path, **options)), abs(next(iter(options.values()))), atol=1e-12
        )
    feed, leaned = feed_direction(path, axis), plain("facet_mean", path, lead=0.3, tilt=0.2)
    np.testing.assert_allclose((leaned * feed).sum(1), np.sin(0.3), atol=1e-12)
    np.testing.assert_allclose((leaned * np.cross(feed, axis)).sum(1), np.cos(0.3) * np.sin(0.2), atol=1e-12)


def test_the_feed_is_the_mean_of_the_cutting_steps_on_either_side():
    path = offset([(0, 0), (10, 0), (20, 10)])
    feed = feed_direction(path, np.tile((0.0, 1.0, 0.0), (len(path.point), 1)))  # an axis across both steps
    slope = np.array([1, 0, 1]) / 2**0.5
    middle = slope + (1, 0, 0)
    expected = [(1, 0, 0), *[middle / np.linalg.norm(middle)] * (len(feed) - 2), slope]
    np.testing.assert_allclose(feed, expected, atol=1e-12)


def test_the_axis_at_the_seam_of_a_closed_polyline_is_one():
    path = offset([(0, 0), (1, 12), (14, 13), (12, 1)], skew=(0.1, 1, 0.2), closed=True)
    for strategy in STRATEGIES:
        axis = plain(strategy, path, lead=0.2, tilt=0.1)
        np.testing.assert_allclose(axis[0], axis[-1], atol=1e-14)


def test_a_polyline_does_not_look_at_its_neighbours():
    one, two = [(0, 0), (10, 5), (20, 0)], [(50, 0), (40, 8), (20, 0)]
    both = plain("facet_mean", offset(one, two), lead=0.3)
    np.testing.assert_allclose(
        both, np.concatenate([plain("facet_mean", offset(part), lead=0.3) for part in (one, two)]), atol=1e-14
    )


def single(path):
    """The first row of the path alone."""
    columns = {
        name: getattr(path, name)[:1]
        for name in path.__dataclass_fields__
        if name not in ("findings", "middle")
    }
    return replace(path, **columns)


def test_a_single_point_without_direction_leans_across_some_perpendicular():
    for fixed in ((0, 0, 1), (1, 2, 0.5)):
        axis = plain("fixed", single(offset(UNEVEN)), fixed=fixed, lead=0.3)
        assert np.isfinite(axis).all()
        assert angle(axis, np.array([fixed]))[0] == pytest.approx(0.3)


def test_travel_along_the_axis_takes_the_direction_before():
    path = offset([(0, 0), (10, 0), (10, -30)])
    axis = plain("fixed", path, lead=0.3)
    np.testing.assert_allclose(axis, np.broadcast_to((np.sin(0.3), 0, np.cos(0.3)), axis.shape), atol=1e-12)


def test_opposed_normals_fall_back_on_the_rows_own():
    path = offset([(0, 0), (10, 0), (1, 0)])
    for strategy in ("facet_mean", "step_weighted"):
        axis = plain(strategy, path, lead=0.1)
        np.testing.assert_allclose(np.linalg.norm(axis, axis=1), 1, atol=1e-12)


@pytest.mark.parametrize("off", [0.0, 3e-7])
def test_opposed_normals_take_the_rows_own_however_far_opposed_ones_may_be_rounded(off):
    path = offset([(0, 0), (10, 5), (20, 0)])
    across = np.broadcast_to((0.0, off, 0.0), path.before.shape)
    path = replace(
        path, after=across - path.before, normal=np.broadcast_to((0.6, 0.8, 0.0), path.before.shape).copy()
    )
    np.testing.assert_array_equal(plain("step_weighted", path), path.normal)


def test_a_step_without_length_halves_the_angle():
    path = offset([(0, 0), (10, 5), (20, 0)])
    path = replace(path, step_before=0 * path.step_before, step_after=0 * path.step_after)
    np.testing.assert_allclose(plain("step_weighted", path), plain("facet_mean", path), atol=1e-14)


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_no_rows_give_no_axes(strategy):
    path = offset(UNEVEN)
    columns = {
        name: getattr(path, name)[:0]
        for name in path.__dataclass_fields__
        if name not in ("findings", "middle")
    }
    assert plain(strategy, replace(path, **columns), lead=0.1, tilt=0.1).shape == (0, 3)
