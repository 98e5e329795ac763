# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of a pass are merged as far as the motion between those left stands for them, measured by
brute force; ends, kinks and sharp edges stay."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import cKDTree

from freecad_fiveaxis.core.toolpath import merge_rows as merging
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath
from freecad_fiveaxis.core.toolpath.merge_rows import (
    CROWD,
    Allowance,
    ToolPoints,
    find_kept_rows,
    merge_rows,
    rows_crowd,
)

ALLOWED = Allowance(0.001, 0.01, 0.02, math.radians(0.5))
BALL = ToolPoints(0.0, 5.0, 0.0)
FLAT = ToolPoints(0.0, 0.0, 5.0)
UP = np.array([0.0, 0.0, 1.0])


def merged_by(path, axis, tool, allowed):
    """The path of the rows that are kept, and their axes."""
    return merge_rows(path, axis, find_kept_rows(path, axis, tool, allowed))


def path_of(hub, normal=None, line=None, fill=None, after=None):
    """A path whose facet normals are its axes."""
    hub = np.asarray(hub, float)
    count = len(hub)
    normal = np.broadcast_to(UP, hub.shape) if normal is None else np.asarray(normal, float)
    none, far = np.zeros(count, np.int64), np.zeros(count)
    return OffsetPath(
        point=hub - 5.0 * normal, centre=hub, normal=normal, before=normal,
        after=normal if after is None else after,
        step_before=far, step_after=far, face=none, coedge=none - 1, segment=none,
        polyline=none if line is None else np.asarray(line), pass_=none,
        fill=np.zeros(count, bool) if fill is None else fill,
    )  # fmt: skip


def straight(count, spacing):
    return np.arange(count)[:, None] * np.array([spacing, 0.0, 0.0])


def leaning(angle):
    """Unit vectors that lean towards X by ``angle`` (n,)."""
    return np.stack([np.sin(angle), 0.0 * angle, np.cos(angle)], axis=1)


def arc(radius, spacing, count):
    """A hub on an arc, its axis along the radius, and how far round it is."""
    angle = np.arange(count) * spacing / radius
    return path_of(radius * leaning(angle), leaning(angle)), leaning(angle), angle


def dense_motion(path, axis, tool, pieces):
    """Hubs, tips and axes of the commanded motion, ``pieces`` to each block, by sines of the great arc."""
    straight = path.centre - tool.rise * axis
    share = np.tile(np.arange(pieces) / pieces, len(axis) - 1)[:, None]
    start = np.repeat(np.arange(len(axis) - 1), pieces)
    whole = np.arccos(np.clip((axis[start] * axis[start + 1]).sum(axis=1), -1.0, 1.0))[:, None]
    with np.errstate(invalid="ignore", divide="ignore"):
        turned = (
            np.sin((1.0 - share) * whole) * axis[start] + np.sin(share * whole) * axis[start + 1]
        ) / np.sin(whole)
    turned = np.where(whole < 1e-6, axis[start], turned)
    hub = (1.0 - share) * straight[start] + share * straight[start + 1] + tool.rise * turned
    return hub, hub - tool.corner * turned, turned


def wander(seed, count=200):
    """A random path: smooth, rough to the side and across the surface, with an axis that trembles."""
    random = np.random.default_rng(seed)
    along = np.cumsum(random.uniform(0.0, 0.1, count))
    rough = random.normal(0.0, (0.0, 0.004, 0.0006), (count, 3))
    hub = np.stack([along, 0.2 * np.sin(along), 0.3 * np.cos(0.5 * along)], axis=1) + rough
    angle = 0.3 * np.sin(0.2 * along) + random.normal(0.0, 0.001, count)
    return path_of(hub, leaning(angle)), leaning(angle)


def test_points_on_a_line_with_even_turn_collapse_to_two():
    axis = leaning(np.linspace(0.0, 0.7, 300))
    merged, turned = merged_by(path_of(straight(300, 0.05), axis), axis, BALL, ALLOWED)
    assert np.array_equal(merged.centre, straight(300, 0.05)[[0, -1]])
    assert np.array_equal(turned, axis[[0, -1]])


def test_a_turn_on_the_spot_collapses_to_two():
    axis = leaning(np.linspace(0.0, 0.7, 300) ** 2)
    merged, _ = merged_by(path_of(np.zeros((300, 3)), axis), axis, BALL, ALLOWED)
    assert len(merged.centre) == 2


@pytest.mark.parametrize("radius", [5.0, 12.0, 40.0])
def test_an_arc_keeps_rows_by_the_chord_formula(radius):
    spacing, count = 0.004, 3500
    path, axis, angle = arc(radius, spacing, count)
    merged, turned = merged_by(path, axis, BALL, ALLOWED)
    kept = np.sort(np.arctan2(turned[:, 0], turned[:, 2]))
    chord, widest = 2.0 * radius * np.sin(0.5 * np.diff(kept)), math.sqrt(8.0 * 0.001 * radius)
    assert chord.max() <= widest + spacing
    assert len(merged.centre) <= 1.4 * radius * angle[-1] / widest + 2
    assert len(merged.centre) >= radius * angle[-1] / widest + 1


def test_a_kink_stays_and_so_do_the_ends():
    hub = np.concatenate(
        [straight(150, 0.05), straight(150, 0.05)[-1] + np.arange(1, 150)[:, None] * 0.05 * UP]
    )
    merged, _ = merged_by(path_of(hub), np.tile(UP, (299, 1)), BALL, ALLOWED)
    assert np.array_equal(merged.centre, hub[[0, 149, -1]])


def test_an_axis_that_leans_out_and_back_stays():
    angle = np.zeros(300)
    angle[150] = math.radians(0.6)
    merged, turned = merged_by(path_of(straight(300, 0.05)), leaning(angle), BALL, replace(ALLOWED, tip=1.0))
    assert len(merged.centre) == 5
    assert np.isclose(turned, leaning(angle)[150]).all(axis=1).any()
    angle[150] = math.radians(0.4)
    assert (
        len(merged_by(path_of(straight(300, 0.05)), leaning(angle), BALL, replace(ALLOWED, tip=1.0))[1]) == 2
    )
    assert len(merged_by(path_of(straight(300, 0.05)), leaning(angle), BALL, ALLOWED)[1]) == 5  # for the tip


def test_a_level_bottom_counts_what_its_rim_swings():
    angle = np.zeros(300)
    angle[150] = 0.9 * 0.001 / 5.0
    path, axis = path_of(straight(300, 0.05)), leaning(angle)
    assert len(merged_by(path, axis, FLAT, ALLOWED)[1]) == 2
    assert len(merged_by(path, leaning(2.0 * angle), FLAT, ALLOWED)[1]) == 5
    assert len(merged_by(path, leaning(2.0 * angle), BALL, ALLOWED)[1]) == 2


def test_along_the_surface_a_row_may_be_farther_off_than_across_it():
    for side, number in (([0.0, 0.009, 0.0], 2), ([0.0, 0.011, 0.0], 5), ([0.0, 0.0, 0.0011], 5)):
        hub = straight(300, 0.05)
        hub[150] += side
        assert len(merged_by(path_of(hub), np.tile(UP, (300, 1)), BALL, ALLOWED)[1]) == number


def test_rows_crowd_where_they_are_on_average_nearer_than_some_tolerances():
    line = np.repeat([0, 1], 50)  # the way from one polyline to the next does not count
    for spacing, crowd in ((0.99, True), (1.01, False)):
        path = path_of(straight(50, spacing * CROWD * 0.01))
        assert rows_crowd(path, 0.01) == crowd
        far = np.concatenate([path.centre, path.centre + 1000.0])
        assert rows_crowd(path_of(far, line=line), 0.01) == crowd
    assert not rows_crowd(path_of(straight(2, 0.0)[:1]), 0.01)
    assert rows_crowd(path_of(straight(50, 0.07)), 0.5) and not rows_crowd(path_of(straight(50, 0.09)), 0.5)


def test_polylines_and_sharp_edges_stay():
    count = 500
    line, after = np.repeat([0, 1], 250), np.tile(UP, (count, 1))
    after[100:103] = leaning(np.full(3, math.radians(31.0)))
    path = path_of(straight(count, 0.01), line=line, after=after)
    merged, _ = merged_by(path, np.tile(UP, (count, 1)), BALL, ALLOWED)
    assert np.array_equal(np.round(merged.centre[:, 0] / 0.01), [0, 100, 101, 102, 249, 250, 499])
    assert np.array_equal(merged.polyline, [0, 0, 0, 0, 0, 1, 1])


def test_a_merged_move_closes_a_gap_only_where_all_its_moves_did():
    fill = np.zeros(300, bool)
    fill[60:] = True
    hub = straight(300, 0.05)
    hub[149:] += 0.5 * UP
    merged, _ = merged_by(path_of(hub, fill=fill), np.tile(UP, (300, 1)), BALL, ALLOWED)
    assert merged.fill.tolist() == [False, False, True, True]


@pytest.mark.parametrize("tool", [BALL, FLAT, ToolPoints(5.0, 5.0, 0.0)], ids=["ball", "flat", "guided"])
@pytest.mark.parametrize("seed", range(2))
def test_what_is_left_out_is_near_the_motion_by_brute_force(seed, tool):
    path, axis = wander(seed)
    merged, turned = merged_by(path, axis, tool, ALLOWED)
    assert 3 < len(turned) < 0.8 * len(axis) or tool is FLAT  # which swings too much to leave out many
    assert_near(path, axis, merged, turned, tool)


def test_between_the_rows_left_out_it_is_as_near():
    path, axis = wander(7)
    merged, turned = merged_by(path, axis, BALL, ALLOWED)
    hub, _, fine = dense_motion(path, axis, BALL, 4)
    finer = replace(path_of(hub, fine), polyline=np.zeros(len(hub), np.int64))
    assert_near(finer, fine, merged, turned, BALL)


ASIDE = 0.005 / (1.1 * ALLOWED.off)
"""Along the surface a place may be as many times farther off than across it."""
GUIDED = ToolPoints(5.0, 5.0, 0.0)
"""A ball whose tip goes straight: its hub swings with the axis."""


def jumps(degrees, seed, count=60):
    """A hub that stands nearly still while the axis, which trembles, jumps to and fro every third row."""
    random, row = np.random.default_rng(seed), np.arange(count)
    angle = np.where(row % 6 < 3, 0.0, math.radians(degrees)) + random.normal(0.0, 1e-3, count)
    hub = np.stack([5e-5 * row, 0.0 * row, 0.0 * row], axis=1)
    axis = np.stack([np.sin(angle), random.normal(0.0, 1e-3, count), np.cos(angle)], axis=1)
    axis /= np.linalg.norm(axis, axis=1)[:, None]
    return path_of(hub, np.tile([0.0, 0.0, 1.0], (count, 1))), axis


def largest_between(path, axis, pieces=16):
    """How far, mm, places between the rows of a guided path are across its surface from the merged one,
    or along it, where that counts ASIDE times less."""
    merged, turned = merged_by(path, axis, GUIDED, ALLOWED)
    given, _, _ = dense_motion(path, axis, GUIDED, pieces)
    near, _, _ = dense_motion(merged, turned, GUIDED, 4000)
    scale = np.array([1.0 / ASIDE, 1.0 / ASIDE, 1.0])
    return cKDTree(near * scale).query(given * scale, p=np.inf)[0].max()


@pytest.mark.parametrize("degrees", [10.0, 29.0, 70.0])
def test_where_the_axis_jumps_a_hub_over_the_straight_point_is_near_between_rows_too(degrees):
    path, axis = jumps(degrees, 1)
    assert largest_between(path, axis) <= 1.1 * ALLOWED.off


def test_a_jump_whose_rows_are_merged_would_be_noticed(monkeypatch):
    monkeypatch.setattr(merging, "TURNS", math.pi)
    path, axis = jumps(70.0, 1)
    assert largest_between(path, axis) > 1.5 * ALLOWED.off


def test_brute_force_would_notice():
    path, axis = wander(0)
    wide = replace(ALLOWED, off=0.004, aside=0.04, tip=0.08)
    with pytest.raises(AssertionError):
        assert_near(path, axis, *merged_by(path, axis, BALL, wide), BALL)


def assert_near(path, axis, merged, turned, tool):
    """Every row is within what is allowed of some place of the motion, found among thousands."""
    hub, tip, lean = dense_motion(merged, turned, tool, 12_000 // len(turned) + 200)
    for row in range(len(axis)):
        near = np.abs(hub - path.centre[row]).max(axis=1) < 0.02
        off, turn = path.centre[row] - hub[near], np.linalg.norm(axis[row] - lean[near], axis=1)
        swing = tool.ring * turn
        fits = np.abs(off @ path.normal[row]) + swing <= 1.05 * ALLOWED.off
        fits &= np.linalg.norm(off, axis=1) + swing <= 1.05 * ALLOWED.aside
        fits &= (
            np.linalg.norm(path.centre[row] - tool.corner * axis[row] - tip[near], axis=1)
            <= 1.05 * ALLOWED.tip
        )
        fits &= turn <= 1.05 * ALLOWED.turn
        assert fits.any(), row


def test_long_paths_are_looked_at_in_portions_and_come_out_the_same(monkeypatch):
    path, axis = wander(3, 1500)
    one = merged_by(path, axis, BALL, ALLOWED)
    monkeypatch.setattr(merging, "PORTION", 50)
    other = merged_by(path, axis, BALL, ALLOWED)
    assert np.array_equal(one[0].centre, other[0].centre)
    assert np.array_equal(one[1], other[1])
