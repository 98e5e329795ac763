# SPDX-License-Identifier: LGPL-2.1-or-later
"""The map of what is left: closed forms, and the same by brute force."""

import numpy as np
import pytest
from gouge_examples import step, v_groove

from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.gouge import find_rest_material, straight_motion
from freecad_fiveaxis.core.gouge.rest_material import (
    surface_parts,
    surface_samples,
    too_deep_finding,
    uncut_finding,
)
from freecad_fiveaxis.core.tool.body import Body, depth_of, frustum_piece, round_piece

BALL = Body((round_piece(0.0, 3.0, 3.0),))


def upright(*tips):
    return straight_motion(np.array(tips, float), np.tile([0.0, 0.0, 1.0], (len(tips), 1)))


def test_the_samples_share_the_whole_area_and_lie_on_their_facets():
    mesh = step()
    point, facet, area = surface_samples(mesh, 1.5)
    a, b, c = (mesh.vertex[mesh.face[:, k]] for k in range(3))
    whole = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    assert np.bincount(facet, area) == pytest.approx(whole)
    assert np.abs(((point - mesh.vertex[mesh.face[facet, 0]]) * mesh.normal[facet]).sum(axis=1)).max() < 1e-12


def test_the_parts_of_a_facet_keep_its_sense_and_have_no_long_sides():
    mesh = step()
    corner, facet = surface_parts(mesh, 2.0)
    twice = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    assert ((twice * mesh.normal[facet]).sum(axis=1) > 0.0).all()
    assert np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2).max() <= 3.0


def test_between_two_passes_on_a_floor_the_scallop_is_left():
    swept = upright((-15, -12, 0), (15, -12, 0), (15, -10, 0), (-15, -10, 0))
    mesh = step()
    point, _, _ = surface_samples(mesh, 1.0)
    left = find_rest_material(mesh, BALL, swept, np.array([0, 2]), 1.0)
    floor = (np.abs(point[:, 2]) < 1e-9) & (np.abs(point[:, 0]) < 14) & (np.abs(point[:, 1] + 11) < 1.0)
    off = 1.0 - np.abs(point[floor][:, 1] + 11.0)  # from the nearer pass
    assert left.height[floor] == pytest.approx(np.hypot(3.0, off) - 3.0, abs=1e-5) and floor.sum() > 30


def test_at_the_bottom_of_a_v_groove_the_ball_leaves_what_the_angle_demands():
    half = np.radians(40.0)
    height = 3.0 / np.sin(half) - 3.0  # of the tip when both flanks are touched
    left = find_rest_material(
        v_groove(half), BALL, upright((-20, 0, height), (20, 0, height)), np.array([0]), 0.8
    )
    near = (np.linalg.norm(left.point[:, 1:], axis=1) < 1.0) & (np.abs(left.point[:, 0]) < 15)
    assert left.height[near].max() == pytest.approx(height, abs=0.4) and left.height.min() > -1e-9
    lower = find_rest_material(
        v_groove(half), BALL, upright((-20, 0, height - 0.1), (20, 0, height - 0.1)), np.array([0]), 0.8
    )
    assert lower.height.min() == pytest.approx(-0.1 * np.sin(half), abs=0.01)


@pytest.mark.parametrize(
    "body",
    [BALL, Body((round_piece(2.0, 1.0, 1.0), frustum_piece(1.0, 3.0, 15.0, 3.0)))],
    ids=["ball", "bull"],
)
def test_brute_force_over_dense_poses_finds_no_lower_height(body):
    rng = np.random.default_rng(4)
    tips = np.column_stack(
        [np.linspace(-15, 15, 16), -8 + np.cumsum(rng.normal(size=16)), 0.2 + 0.2 * rng.uniform(size=16)]
    )
    axes = rng.normal(size=(16, 3)) * 0.15 + (0, 0, 1)
    swept = straight_motion(tips, axes / np.linalg.norm(axes, axis=1)[:, None])
    left = find_rest_material(step(), body, swept, np.arange(15), 3.0)
    pose = swept.pose(np.repeat(np.arange(15), 60), np.tile(np.linspace(0, 1, 60), 15))
    depth = np.array([depth_of(body, pose.tip.T, pose.axis.T, point).max() for point in left.point])
    near = left.height < 2.0
    assert (
        (left.height[near] <= -depth[near] + 0.02).all()
        and (left.height >= -depth - 0.05).all()
        and near.sum() > 50
    )


@pytest.mark.parametrize(("ring", "corner"), [(8.0, 0.0), (8.0, 2.0)], ids=["flat", "bull"])
def test_a_wide_cutter_that_leans_touches_far_from_its_middle(ring, corner):
    lean, side = np.radians(15.0), np.linspace(-20, 20, 41)
    axis = np.array([-np.sin(lean), 0.0, np.cos(lean)])  # the rim at +x is the lowest
    hub = corner + ring * np.sin(lean)
    rows = [(x, y, hub) for y in side for x in ((-25, 25) if round(y) % 2 else (25, -25))]
    tips = np.array(rows) - corner * axis
    swept = straight_motion(tips, np.tile(axis, (len(tips), 1)))
    tool = frustum_piece(0.0, ring, 30.0, ring) if corner == 0.0 else round_piece(ring, corner, corner)
    left = find_rest_material(step(), Body((tool,)), swept, np.arange(0, len(tips) - 1, 2), 2.0)
    floor = (
        (np.abs(left.point[:, 2]) < 1e-9)
        & (np.abs(left.point[:, 0]) < 14)
        & (np.abs(left.point[:, 1] + 10) < 8)
    )
    assert floor.sum() > 50 and left.height[floor].min() > -1e-6
    assert left.height[floor].max() < 0.02  # under its middle it would be 2 mm and more


def test_what_is_left_is_reported_with_its_area():
    left = find_rest_material(step(), BALL, upright((-20, -12, 0), (20, -12, 0)), np.array([0]), 3.0)
    (finding,) = uncut_finding(left, 1.0)
    assert (
        finding.code == "uncut"
        and finding.value == pytest.approx(left.area[left.height > 1.0].sum())
        and finding.unit == "mm2"
    )
    assert uncut_finding(left, 1e3) == ()


def test_what_is_cut_too_deep_is_reported_with_its_depth():
    left = find_rest_material(step(), BALL, upright((-20, -12, -0.3), (20, -12, -0.3)), np.array([0]), 1.0)
    (finding,) = too_deep_finding(left, 0.01)
    assert (
        finding.code == "cut-too-deep"
        and finding.value == pytest.approx(0.3, abs=0.05)
        and finding.limit == 0.01
    )
    area, volume = left.sum_overcut(0.0)  # of the groove: a segment of a circle of radius 3
    half = np.arccos(2.7 / 3.0)
    assert volume == pytest.approx(40.0 * 9.0 * (half - np.sin(half) * np.cos(half)), rel=0.1)
    assert area == pytest.approx(40.0 * 2.0 * 3.0 * np.sin(half), rel=0.15)
    assert too_deep_finding(left, 0.31) == ()


def test_a_long_search_says_how_far_it_is_and_can_be_stopped():
    reported = []

    def listen(what, share):
        reported.append(share)
        if share > 0.3:
            raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        find_rest_material(
            step(), BALL, upright((-20, -12, 0), (20, -12, 0)), np.array([0]), 0.25, progress=listen
        )
    assert reported == sorted(reported) and 0.0 < reported[-2] <= 0.3 < reported[-1] < 1.0


def test_without_cuts_nothing_can_be_stated():
    with pytest.raises(SettingsError):
        find_rest_material(step(), BALL, upright((0, 0, 0), (1, 0, 0)), np.empty(0, int), 1.0)


def test_a_wide_cutter_that_only_rocks_about_its_middle_is_seen_at_every_lean():
    """The middle of its bottom stands still; its rim sweeps, and the way is as long as the rim's."""
    lean, radius, middle = np.radians(20.0), 8.0, 8.0 * np.sin(np.radians(20.0))
    axes = np.array([[np.sin(turn), 0.0, np.cos(turn)] for turn in (-lean, lean)])
    swept = straight_motion(np.tile([0.0, -12.0, middle], (2, 1)), axes)
    flat = Body((frustum_piece(0.0, radius, 30.0, radius),))
    left = find_rest_material(step(), flat, swept, np.array([0]), 1.0)
    along, across = left.point[:, 0], np.abs(left.point[:, 1] + 12.0)
    floor = (np.abs(left.point[:, 2]) < 1e-9) & (np.hypot(along, across) < 7.0)
    turns = np.linspace(-lean, lean, 4001)[:, None]  # the plane of the bottom, the points are within its rim
    height = (middle * np.cos(turns) - np.abs(along[floor]) * np.sin(turns)).min(axis=0)
    assert floor.sum() > 50 and left.height[floor] == pytest.approx(height, abs=0.05)
    assert np.ptp(height) > 1.5


def test_what_is_enough_is_not_looked_at_closer_and_what_is_more_is_the_same():
    half = np.radians(40.0)
    height = 3.0 / np.sin(half) - 3.0
    wanted = v_groove(half), BALL, upright((-20, 0, height), (20, 0, height)), np.array([0]), 0.8
    exact, rough = find_rest_material(*wanted), find_rest_material(*wanted, enough=0.5)
    more = exact.height > 0.5
    assert (rough.height[more] == exact.height[more]).all() and (rough.block == exact.block)[more].all()
    assert (
        (rough.height >= exact.height - 1e-4).all()
        and (rough.height[~more] <= 0.5).all()
        and 10 < more.sum() < len(more) - 10
    )
    assert rough.uncut(0.5) == exact.uncut(0.5) and (rough.height > exact.height + 1e-9).any()
