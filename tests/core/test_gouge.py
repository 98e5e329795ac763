# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries of the tool into the part: closed forms, a judge by dense samples, and bad cases."""

import numpy as np
import pytest
from gouge_examples import (
    bowl,
    brute_distance,
    corner,
    dense_points,
    round_groove,
    sampled_depth,
    step,
    v_groove,
)

from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.gouge import (
    check,
    check_motion,
    find_entries,
    inside,
    is_closed,
    real_motion,
    refinement,
    straight_motion,
)
from freecad_fiveaxis.core.gouge.swept_motion import still_positions
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, linear_words
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import HOLDER, SHANK, Body, body_of, depth_of, frustum_piece, round_piece
from freecad_fiveaxis.core.toolpath.cl_path import Motion

UP = np.array([0.0, 0.0, 1.0])
LIMIT = 0.01


def ball(radius):
    """A ball that is driven by its centre."""
    return Body((round_piece(0.0, radius, 0.0),))


def course_through(*places):
    """Straight blocks of an upright tool."""
    return straight_motion(np.array(places, float), np.broadcast_to(UP, (len(places), 3)))


def entries(body, mesh, swept, limit=LIMIT, **more):
    return find_entries(body, facet_tree(mesh), swept, limit, **more)


def close(found, depth, block=0):
    """The depth found is right, and the bound is at or above it and not much more."""
    assert found.depth[block] == pytest.approx(depth, rel=0.011, abs=LIMIT / 10)
    assert depth - 1e-9 <= found.bound[block] <= 1.025 * depth + 2 * LIMIT


# ------------------------------------------------------------------------------------------------ the body


def test_the_depth_of_a_point_is_its_distance_from_the_body():
    rng = np.random.default_rng(1)
    body = Body(
        (
            round_piece(3.0, 2.0, 2.0),
            frustum_piece(2.0, 5.0, 30.0, 8.0),
            frustum_piece(30.0, 15.0, 50.0, 10.0, HOLDER),
        )
    )
    points = rng.uniform(-25, 60, (4000, 3))
    tip, axis = np.array([1.0, 2.0, 3.0]), np.array([0.6, 0.0, 0.8])
    depth = depth_of(body, tip, axis, points)
    moved = points + rng.normal(size=points.shape) * 0.3
    change = np.abs(depth_of(body, tip, axis, moved) - depth)
    assert (change <= np.linalg.norm(moved - points, axis=1) + 1e-12).all()
    height = (points - tip) @ axis
    radius = np.linalg.norm(points - tip - height[:, None] * axis, axis=1)
    in_cone = (height > 2) & (height < 30) & (radius < 5.0 + 3.0 * (height - 2.0) / 28.0)
    in_holder = (height > 30) & (height < 50) & (radius < 15.0 - 5.0 * (height - 30.0) / 20.0)
    out = np.maximum(radius - 3.0, 0.0)
    in_round = np.hypot(out, height - 2.0) < 2.0
    assert ((depth > 0) == (in_cone | in_holder | in_round)).all()


@pytest.mark.parametrize("sizes", [(-1.0, 2.0, 2.0), (0.0, 0.0, 1.0), (0.0, np.nan, 1.0), (0.0, 1e9, 1.0)])
def test_a_piece_that_no_tool_has_is_refused(sizes):
    with pytest.raises(SettingsError):
        round_piece(*sizes)


def test_the_body_of_a_ball_cutter_is_a_ball_and_a_cylinder_with_what_is_above():
    body = body_of(Cutter(10.0, 40.0), shank=[(12.0, 20.0)], holder=[(40.0, 30.0), (60.0, 10.0)])
    at = lambda r, z: depth_of(body, np.zeros(3), UP, np.array([[r, 0.0, z]]))[0]  # noqa: E731
    assert at(0, 0) == pytest.approx(0.0, abs=1e-12) and at(0, 5) == pytest.approx(5.0)
    assert (
        at(5, 39.9) == pytest.approx(0.0, abs=1e-12)
        and at(5.5, 20) < 0 < at(5.5, 45)
        and at(25, 95) > 0 > at(25, 85)
    )
    assert {piece.part for piece in body.only(SHANK, HOLDER).pieces} == {SHANK, HOLDER}


# ----------------------------------------------------------------------------------------------- closed forms


@pytest.mark.parametrize("half_angle", np.radians([20.0, 45.0, 70.0]))
def test_a_ball_in_a_v_groove(half_angle):
    radius, height = 4.0, 3.5
    found = entries(ball(radius), v_groove(half_angle), course_through((-5, 0, height), (5, 0, height)))
    close(found, radius - height * np.sin(half_angle))


def test_a_ball_that_touches_both_flanks_is_no_entry():
    radius, half = 3.0, np.radians(30.0)
    height = radius / np.sin(half)
    found = entries(ball(radius), v_groove(half), course_through((-5, 0, height), (5, 0, height)))
    assert found.depth[0] == 0.0 and found.bound[0] == LIMIT
    lower = entries(
        ball(radius), v_groove(half), course_through((-5, 0, height - 0.03), (5, 0, height - 0.03))
    )
    close(lower, 0.03 * np.sin(half))


def test_a_ball_in_a_groove_of_smaller_radius_enters_at_both_rims():
    groove, radius, height = 4.0, 5.0, 1.0
    found = entries(ball(radius), round_groove(groove), course_through((-5, 0, height), (5, 0, height)))
    close(found, radius - np.hypot(groove, height))


def test_a_step_is_entered_between_two_rows_that_are_free():
    radius = 3.0
    swept = course_through((0, -6.0, radius), (0, -1.0, 6.0 + radius), (0, 9.0, 6.0 + radius))
    found = entries(ball(radius), step(), swept)
    way = np.array([0.0, 5.0, 6.0]) / np.hypot(5.0, 6.0)
    edge = np.array([0.0, 6.0, 6.0 - radius])  # from the first centre to the edge
    close(found, radius - np.linalg.norm(edge - (edge @ way) * way))
    assert found.depth[1] == 0.0


@pytest.mark.parametrize("off", [(2.0, 2.5, 2.9), (2.9, 2.95, 2.0), (1.0, 2.0, 3.5)])
def test_a_ball_in_a_corner(off):
    found = entries(
        ball(3.0), corner(), course_through(np.array(off) + (8, 8, 8), off, np.array(off) + (4, 0, 0))
    )
    close(found, 3.0 - min(off))
    close(found, 3.0 - min(off[1:] + (off[0],)), 1)


def test_a_ball_in_a_bowl_enters_only_where_the_bowl_is_smaller():
    low = entries(ball(9.0), bowl(), course_through((0, 0, -6.4), (0.5, 0, -6.4)))
    assert low.depth[0] == pytest.approx(
        np.hypot(0.5, 6.4) + 9.0 - 15.0, abs=0.03
    )  # the facets' chords lie 0.015 inside
    assert entries(ball(9.0), bowl(), course_through((0, 0, -5.9), (0.1, 0, -5.9))).depth[0] == 0.0


def test_a_turning_tool_enters_between_its_ends():
    """The tip stands still over a floor and the axis swings: a flat end dips by radius x sin of the angle at
    the ends only."""
    swing = np.radians(8.0)
    axes = np.array([[0, np.sin(-swing), np.cos(swing)], [0, np.sin(swing), np.cos(swing)]])
    flat = Body((frustum_piece(0.0, 5.0, 20.0, 5.0),))
    swept = straight_motion(np.array([[0, -12.0, 0.1], [0, -12.0, 0.1]]), axes)
    found = entries(flat, step(), swept)
    dip = 5.0 * np.sin(swing) - 0.1
    assert dip / (np.sin(swing) + np.cos(swing)) == pytest.approx(
        found.depth[0], rel=0.02
    )  # depth in the tool's right angle


# ------------------------------------------------------------------------------------------------ the judge


def random_course(rng, count, reach, low):
    tips = rng.uniform(-reach, reach, (count, 3)) + (0, 0, low)
    axes = rng.normal(size=(count, 3)) * 0.4 + (0, 0, 1.5)
    return straight_motion(tips, axes / np.linalg.norm(axes, axis=1)[:, None])


BODIES = {
    "ball": ball(3.0),
    "bull": Body((round_piece(2.0, 1.0, 1.0), frustum_piece(1.0, 3.0, 15.0, 3.0))),
    "taper": Body((round_piece(0.0, 1.5, 1.5), frustum_piece(1.2, 1.45, 20.0, 5.0))),
    "tool": body_of(Cutter(4.0, 12.0), holder=[(18.0, 15.0)]),
}


@pytest.mark.parametrize("name", BODIES)
def test_depth_and_bound_stand_on_both_sides_of_what_dense_samples_find(name):
    rng = np.random.default_rng(5)
    mesh, swept = round_groove(6.0, 12, 12.0, 16.0), random_course(rng, 12, 8.0, 2.0)
    found, points = entries(BODIES[name], mesh, swept), dense_points(mesh, 0.4)
    worst = [sampled_depth(BODIES[name], points, swept, b, 21) for b in range(len(swept))]
    worst = np.array(worst)
    assert (found.bound >= worst - 1e-9).all()
    assert (worst[found.depth == 0.0] <= LIMIT).all() and (found.depth > 0).sum() > 5
    assert (found.bound[found.depth > 0] <= 1.05 * found.depth[found.depth > 0] + 2 * LIMIT).all()
    for block in np.flatnonzero(found.depth):
        pose = swept.pose(np.array([block]), found.u[block : block + 1])
        there = depth_of(BODIES[name], pose.tip[:, 0], pose.axis[:, 0], found.place[block : block + 1])[0]
        assert there == pytest.approx(found.depth[block], abs=1e-9)


@pytest.fixture(scope="module")
def balls_everywhere():
    """A wavy patch, 300 places about it, and what was found in balls about them."""
    x, y = np.meshgrid(np.linspace(-20, 20, 41), np.linspace(-20, 20, 41), indexing="ij")
    z = 2.0 * np.sin(x / 3.0) * np.cos(y / 4.0)
    row = np.arange(x.size).reshape(x.shape)
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    mesh = from_faces(
        np.stack([x, y, z], -1).reshape(-1, 3),
        np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]),
    )
    centres = np.random.default_rng(6).uniform((-22, -22, -6), (22, 22, 6), (300, 3))
    found = entries(ball(3.0), mesh, still_positions(centres, np.tile(UP, (300, 1))))
    return mesh, centres, found


@pytest.mark.thorough
def test_brute_force_over_all_facets_says_the_same(balls_everywhere):
    mesh, centres, found = balls_everywhere
    depth = np.array([3.0 - brute_distance(mesh, centre) for centre in centres])
    assert found.depth == pytest.approx(np.where(depth > LIMIT, depth, 0.0), rel=0.011, abs=LIMIT / 5)
    assert (
        (found.depth <= np.maximum(depth, 0.0) + 1e-9).all()
        and (found.bound >= depth).all()
        and (depth > LIMIT).sum() > 100
    )


@pytest.mark.thorough
def test_signed_distances_by_another_library_say_the_same(balls_everywhere):
    trimesh = pytest.importorskip("trimesh")
    mesh, centres, found = balls_everywhere
    _, distance, _ = trimesh.proximity.closest_point_naive(trimesh.Trimesh(mesh.vertex, mesh.face), centres)
    depth = np.where(3.0 - distance > LIMIT, 3.0 - distance, 0.0)
    assert found.depth == pytest.approx(depth, rel=0.011, abs=LIMIT / 5)


def test_the_judge_would_see_a_depth_that_is_too_small():
    mesh, swept = step(), course_through((0, -6.0, 3.0), (0, -1.0, 9.0))
    found = entries(ball(3.0), mesh, swept)
    worst = sampled_depth(ball(2.5), dense_points(mesh, 0.2), swept, 0)
    assert worst < 0.9 * found.depth[0]


@pytest.mark.parametrize("name", ["trunnion_ac", "fork_head_bc"])
def test_the_real_way_of_a_machine_is_checked_not_the_commanded_one(name):
    machine = load_machine(name)
    kinematics = chain(machine, Setup(machine.origin, tool_length=120.0))
    tips = np.array([[-10.0, -12.0, 3.005], [10.0, -12.0, 3.005]])
    angles = np.radians([[0.0, 0.0], [25.0, 20.0]])
    words = np.concatenate([linear_words(kinematics, tips, angles), np.degrees(angles)], axis=1)
    swept = real_motion(kinematics, words)
    found = entries(BODIES["ball"], step(), swept)
    worst = sampled_depth(BODIES["ball"], dense_points(step(), 0.2), swept, 0, 201)
    assert worst <= found.bound[0] and found.depth[0] == pytest.approx(worst, abs=max(0.02 * worst, 0.03))
    axes = swept.pose(np.zeros(2, int), np.array([0.0, 1.0])).axis.T
    straight = entries(BODIES["ball"], step(), straight_motion(tips, axes))
    assert found.depth[0] > 0.1 and straight.depth[0] == 0.0


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_finer_mesh_of_the_same_part_has_the_same_entries():
    swept = course_through((0, -6.0, 3.0), (0, -1.0, 9.0))
    coarse, fine = step(), step()
    for _ in range(5):
        a, b, c = fine.face.T
        middle = [(fine.vertex[p] + fine.vertex[q]) / 2 for p, q in ((a, b), (b, c), (c, a))]
        corners = [fine.vertex[r] for r in (a, b, c)]
        tri = [
            (corners[0], middle[0], middle[2]),
            (middle[0], corners[1], middle[1]),
            (middle[2], middle[1], corners[2]),
            middle,
        ]
        vertex, row = np.unique(
            np.concatenate([np.stack(t, 1) for t in tri]).reshape(-1, 3).round(9), axis=0, return_inverse=True
        )
        fine = from_faces(vertex, row.reshape(-1, 3))
    assert len(fine.face) > 1000 * len(coarse.face) / 2
    one, two = entries(ball(3.0), coarse, swept), entries(ball(3.0), fine, swept)
    assert one.depth[0] == pytest.approx(two.depth[0], rel=0.011)


# ------------------------------------------------------------------------------------------------ inside


def test_points_are_inside_where_the_profile_says_so():
    rng = np.random.default_rng(2)
    points = rng.uniform(-35, 35, (3000, 3)) * (0.7, 1.0, 0.5)
    x, y, z = points.T
    within = (np.abs(x) < 20) & (np.abs(y) < 30) & (z > -10) & (z < np.where(y > 0, 6.0, 0.0))
    assert (inside(facet_tree(step()), points) == within).all() and 100 < within.sum() < 2900


def test_a_cutter_that_goes_through_the_part_is_buried_in_the_middle():
    mesh = step()
    swept = course_through((0, -10, 8), (0, -10, -1), (0, -10, -5), (1, -10, -5), (0, -10, 8))
    done = check_motion(mesh, ball(1.0), swept, np.zeros(4, np.int8), LIMIT)
    assert done.buried.tolist() == [False, True, True, False] or done.buried.tolist() == [
        False,
        False,
        True,
        False,
    ]
    assert {f.code for f in done.findings} == {"overcut", "buried"}
    assert "at least 1 mm" in done.findings[0].text or "at least 0.99" in done.findings[0].text


# ------------------------------------------------------------------------------------------------ bad cases


def test_a_cutter_larger_than_the_part_is_found_and_does_not_hang():
    mesh = corner(4.0, 2.0)
    done = check_motion(
        mesh, ball(60.0), course_through((0, 0, 30.0), (5, 0, 30.0)), np.zeros(1, np.int8), LIMIT
    )
    assert [f.code for f in done.findings] == ["overcut"] and done.findings[0].value > 20.0


def test_a_holder_that_collides_everywhere_is_one_kind_of_finding():
    rows = np.linspace(-15, 15, 400)
    swept = course_through(*np.column_stack([rows, 0 * rows - 12.0, 0 * rows + 2.0]))
    body = body_of(Cutter(4.0, 6.0), holder=[(40.0, 30.0)])
    done = check_motion(step(height=12.0), body, swept, np.zeros(399, np.int8), LIMIT)
    assert {f.code for f in done.findings} == {"holder-collision"} and "399 blocks" in done.findings[0].text
    assert "holder" in done.findings[0].text


@pytest.mark.parametrize("depth", [0.06, 0.25])
def test_how_deep_a_holder_goes_at_the_end_of_a_block_is_known_to_one_percent(depth):
    """Beside a step of 12 mm the holder, 10 mm above the tip, comes down on its top; and slides on there."""
    body = body_of(Cutter(4.0, 6.0), holder=[(40.0, 30.0)])
    low = body.only(HOLDER).pieces[0].low
    places = [(0.0, -12.0, 12.0 - low + above) for above in (3.0, -0.5 * depth, -depth)]
    swept = course_through(*places, *((x, -12.0, 12.0 - low - depth) for x in np.linspace(0.1, 1.0, 9)))
    done = check_motion(step(height=12.0), body, swept, np.zeros(11, np.int8), LIMIT)
    assert done.findings[0].value == pytest.approx(depth, rel=0.011, abs=0.1 * LIMIT)
    assert done.above.depth[2:].min() > 0.9 * depth and done.above.bound.max() < 1.02 * depth + 2 * LIMIT


def test_only_blocks_that_may_be_deepest_are_looked_at_closely(monkeypatch):
    monkeypatch.setattr(check, "CLOSER", 1)
    monkeypatch.setattr(check, "ROUGHLY", 3.0)
    body = body_of(Cutter(4.0, 6.0), holder=[(40.0, 30.0)])
    low = body.only(HOLDER).pieces[0].low
    swept = course_through(*((x, -12.0, 12.0 - low - depth) for x, depth in ((0, 0.5), (1, 1.0), (2, 0.5))))
    found = check_motion(step(height=12.0), body, swept, np.zeros(2, np.int8), LIMIT)
    assert found.above.depth.max() == pytest.approx(1.0, rel=0.011)


def test_an_open_mesh_has_no_inside_but_its_surface_is_checked():
    mesh = bowl()
    assert not is_closed(mesh) and is_closed(step())
    done = check_motion(
        mesh, ball(2.0), course_through((0, 0, -14.0), (1, 0, -14.0)), np.zeros(1, np.int8), LIMIT
    )
    assert [f.code for f in done.findings] == ["overcut"]


def test_facets_that_look_inward_change_nothing():
    mesh, swept = bowl(), course_through((0, 0, -14.0), (1, 0, -14.0))
    turned = from_faces(mesh.vertex, mesh.face[:, ::-1])
    assert entries(ball(2.0), mesh, swept).depth[0] == pytest.approx(
        entries(ball(2.0), turned, swept).depth[0], rel=0.011
    )


def test_blocks_of_no_length_are_poses():
    found = entries(
        ball(3.0), step(), course_through((0, -12, 2.5), (0, -12, 2.5), (0, -12, 3.0), (0, -12, 3.0))
    )
    close(found, 0.5)
    assert found.depth[2] == 0.0


@pytest.mark.thorough
def test_pairs_divided_a_few_at_a_time_find_the_same(monkeypatch):
    mesh, rng = bowl(15.0, 24), np.random.default_rng(5)
    swept = course_through(*np.column_stack([rng.uniform(-6, 6, (30, 2)), rng.uniform(-12, -6, 30)]))
    whole = entries(ball(4.0), mesh, swept)
    shallow, known = 0.2, find_entries(ball(4.0), facet_tree(mesh), swept, 0.2, np.inf)
    monkeypatch.setattr(refinement, "AT_ONCE", 7)
    parts, reported = (
        entries(ball(4.0), mesh, swept),
        find_entries(ball(4.0), facet_tree(mesh), swept, shallow, np.inf),
    )
    assert (whole.depth > 0.0).sum() > 5 and np.allclose(
        parts.depth, whole.depth, rtol=0.011, atol=LIMIT / 10
    )
    assert (parts.bound >= whole.depth - 1e-9).all()
    assert ((reported.bound > shallow) == (known.bound > shallow)).all() and 0 < (
        reported.bound > shallow
    ).sum() < 29


def test_a_course_without_blocks_has_no_entries():
    found = entries(ball(3.0), step(), course_through((0, 0, 0)))
    assert len(found.depth) == 0


def test_a_mesh_of_one_facet():
    mesh = from_faces([[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    close(entries(ball(2.0), mesh, course_through((1, 1, 1.5), (1.2, 1, 1.5))), 0.5)


def test_rapids_that_enter_are_collisions_and_cuts_overcuts():
    swept = course_through((0, -12, 2.0), (1, -12, 2.0), (2, -12, 9.0), (3, -12, 2.0))
    motion = np.array([Motion.CUT, Motion.RAPID, Motion.RAPID], np.int8)
    done = check_motion(step(), ball(3.0), swept, motion, LIMIT, where=lambda block: (block + 7, block + 100))
    by_code = {f.code: f for f in done.findings}
    assert set(by_code) == {"overcut", "rapid-collision"}
    assert (by_code["overcut"].block, by_code["overcut"].line) == (7, 100)
    assert by_code["overcut"].value == pytest.approx(1.0, rel=0.011) and by_code["overcut"].limit == LIMIT


def test_the_check_can_be_stopped():
    def stop(stage, fraction):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        check_motion(
            step(),
            ball(3.0),
            course_through((0, -12, 2.5), (5, -12, 2.5)),
            np.zeros(1, np.int8),
            LIMIT,
            progress=stop,
        )
