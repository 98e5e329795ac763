# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heights of facets, the scale of colours, and the picture of pixels, each against what can be reckoned by
hand."""

import struct
import zlib

import numpy as np
import pytest
from gouge_examples import step

from freecad_fiveaxis.core.gouge import find_rest_material, straight_motion
from freecad_fiveaxis.core.report.raster import owners, png, view_from
from freecad_fiveaxis.core.report.rest_material_map import (
    NEUTRAL,
    NO_HEIGHT,
    facet_heights,
    height_colours,
    height_levels,
    height_scale,
    rest_material_patches,
    round_values,
    scale_marks,
)
from freecad_fiveaxis.core.tool.body import Body, round_piece

BALL = Body((round_piece(0.0, 3.0, 3.0),))


@pytest.fixture(scope="module")
def rest():
    """One cut 0.2 mm too deep along the floor of a step."""
    mesh = step()
    course = straight_motion(
        np.array([(-20.0, -12.0, -0.2), (20.0, -12.0, -0.2)]), np.tile([0.0, 0.0, 1.0], (2, 1))
    )
    floor = (mesh.vertex[mesh.face][..., 2] == 0.0).all(axis=1)
    return mesh, floor, find_rest_material(mesh, BALL, course, np.array([0]), 0.5, floor)


def test_the_height_of_a_facet_is_that_of_its_worst_sample_and_others_have_none(rest):
    mesh, floor, remainder = rest
    height = facet_heights(
        remainder, len(mesh.face), 0.01, 1e6
    )  # what is left never matters, however much it is
    assert np.isnan(height[~floor]).all() and floor.sum() == 2
    for facet in np.flatnonzero(floor):
        assert height[facet] == remainder.height[remainder.facet == facet].min()
    other = facet_heights(remainder, len(mesh.face), 1e6, 0.01)
    for facet in np.flatnonzero(floor):
        assert other[facet] == remainder.height[remainder.facet == facet].max()


def test_the_patches_are_those_of_the_samples(rest):
    mesh, _, remainder = rest
    patch = rest_material_patches(mesh, remainder)
    area = 0.5 * np.linalg.norm(np.cross(patch[:, 1] - patch[:, 0], patch[:, 2] - patch[:, 0]), axis=1)
    assert patch.mean(axis=1) == pytest.approx(remainder.point) and area == pytest.approx(remainder.area)


def test_levels_go_by_powers_of_ten_from_the_borders_of_the_neutral(rest):
    scale = height_scale(rest[2], 0.01, 0.03)
    assert scale.tolerance == 0.01 and scale.allowed == 0.03 and scale.deepest == pytest.approx(0.2)
    assert scale.highest >= rest[2].height.max() > 0.4 * scale.highest
    middle = np.sqrt(scale.tolerance * scale.deepest)
    levels = height_levels(
        np.array([-9.0, -scale.deepest, -middle, -0.01, 0.0, 0.03, scale.highest, 1e3, np.nan]), scale
    )
    assert levels[:-1] == pytest.approx([-1, -1, -0.5, 0, 0, 0, 1, 1]) and np.isnan(levels[-1])


def test_too_deep_is_red_left_is_blue_and_within_the_tolerance_is_neither(rest):
    scale = height_scale(rest[2], 0.01, 0.03)
    deep, much, right, none = height_colours(np.array([-0.15, 20.0, 0.02, np.nan]), scale)
    assert deep[0] > deep[2] + 0.3 and much[2] > much[0] + 0.3
    assert tuple(right) == NEUTRAL and tuple(none) == NO_HEIGHT and np.ptp(right) < 0.1


def test_the_marks_of_the_scale_ascend_and_name_its_borders(rest):
    scale = height_scale(rest[2], 0.01, 0.03)
    level, height = np.array(scale_marks(scale)).T
    assert (np.diff(height) > 0.0).all() and (np.diff(level) >= 0.0).all()
    assert {-0.01, 0.03} <= set(height.tolist()) and level[0] == -1.0 and level[-1] == 1.0
    assert height_levels(height, scale) == pytest.approx(level)


def test_round_values_lie_between_and_are_written_shortly():
    assert round_values(0.01, 1.0) == [0.02, 0.05, 0.1, 0.2, 0.5]
    assert round_values(0.3, 0.31) == []


# ------------------------------------------------------------------------------------------------ pixels

ABOVE = view_from(-0.5 * np.pi, 0.5 * np.pi)


def test_from_above_x_is_to_the_right_and_y_is_up():
    assert pytest.approx(np.eye(3), abs=1e-12) == ABOVE
    for view in (ABOVE, view_from(0.3, 0.6)):
        assert view @ view.T == pytest.approx(np.eye(3), abs=1e-12) and np.linalg.det(view) == pytest.approx(
            1.0
        )


def test_the_upper_of_two_triangles_is_seen_and_none_from_behind():
    flat = np.array([[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0]])
    high = 0.5 * flat + (0, 0, 1.0)
    seen = owners(np.stack([flat, high]), ABOVE, np.zeros(2), 10.0, 100, 100)
    assert (seen == 1).sum() == pytest.approx(0.125e4, rel=0.03) and (seen == 0).sum() == pytest.approx(
        0.375e4, rel=0.03
    )
    assert seen[-1, 0] == 1 and seen[-1, 95] == 0 and seen[0, 99] == -1  # the lowest row is the last
    assert (
        owners(np.stack([flat, high])[::-1], ABOVE, np.zeros(2), 10.0, 100, 100)
        == np.where(seen < 0, -1, 1 - seen)
    ).all()
    assert (owners(flat[None, ::-1], ABOVE, np.zeros(2), 10.0, 100, 100) == -1).all()


def test_the_pixels_are_those_of_a_ray_through_each_of_them():
    rng = np.random.default_rng(7)
    corner = rng.uniform(-5, 5, (40, 3, 3))
    view, low, scale = view_from(0.7, 0.4), np.array([-6.0, -6.0]), 4.0
    seen = owners(corner, view, low, scale, 48, 48)
    flat = corner @ view.T
    for row, column in rng.integers(0, 48, (120, 2)):
        x, y = low[0] + (column + 0.5) / scale, low[1] + (48 - row - 0.5) / scale
        best, of = -np.inf, -1
        for k, (a, b, c) in enumerate(flat):
            share = np.linalg.lstsq(
                np.array([[a[0], b[0], c[0]], [a[1], b[1], c[1]], [1, 1, 1]]), [x, y, 1], rcond=None
            )[0]
            facing = np.cross(b - a, c - a)[2] > 0.0
            if facing and share.min() > 0.0 and share @ (a[2], b[2], c[2]) > best:
                best, of = share @ (a[2], b[2], c[2]), k
        assert seen[row, column] == of
    assert len(np.unique(seen)) > 10


def test_the_png_holds_the_pixels():
    pixel = np.random.default_rng(1).integers(0, 256, (7, 5, 3)).astype(np.uint8)
    file = png(pixel)
    assert file.startswith(b"\x89PNG\r\n\x1a\n") and struct.unpack(">II", file[16:24]) == (5, 7)
    start = file.index(b"IDAT") + 4
    size = struct.unpack(">I", file[start - 8 : start - 4])[0]
    rows = np.frombuffer(zlib.decompress(file[start : start + size]), np.uint8).reshape(7, 16)
    assert (rows[:, 0] == 0).all() and (rows[:, 1:].reshape(7, 5, 3) == pixel).all()
