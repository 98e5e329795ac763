# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gaps at co-edges: points by hand, chords against the mesh by brute force."""

import numpy as np
import pytest
from offset_examples import ball, clearance, distance, field, hull, joined, own_clearance, prism
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.passes import slice_mesh
from freecad_fiveaxis.core.toolpath.coedge import close_gaps, columns, gaps, junction, trimming

ROOF = [(0, 0), (10, 5), (20, 0)]
ANGLE = np.radians(17.0)


def closed(contact, radius=5.0, tolerance=0.01):
    mesh = from_faces([[900, 0, 0], [901, 0, 0], [900, 1, 0]], [[0, 1, 2]])  # no facet is where the path is
    return close_gaps(contact, mesh, radius, tolerance)


def codes(path):
    return [finding.code for finding in path.findings]


@pytest.fixture
def worst(monkeypatch):
    """A list of the worst depth and the worst height, mm, that are behind the findings of each path closed
    (None: none notable)."""
    seen, over = [], gaps._over

    def spied(*given):
        seen.append(over(*given))
        return seen[-1]

    monkeypatch.setattr(gaps, "_over", spied)
    return seen


def test_a_path_that_goes_on_along_the_co_edge_of_a_groove_is_taken_as_convex():
    """Where its second offset would be trimmed to, no number says."""
    contact = prism([(0, 0), (10, 0), (20, 5)])
    contact.point.flags.writeable = True
    contact.point[3] = contact.point[2] + (0.0, 10.0, 0.0)
    found = junction.find_junctions(junction.find_segments(contact), 5.0, 0.01)
    assert found.kind[0] == junction.CONVEX and found.trim_start[0] == 0.0


# ---- convex
# ----------------------------------------------------------------------------------------------------------


def test_a_convex_co_edge_gets_the_three_points_of_the_paper():
    path = closed(prism(ROOF), tolerance=1.0)
    n1, n2 = np.array([-1, 0, 2]) / 5**0.5, np.array([1, 0, 2]) / 5**0.5
    cos_half = 2 / 5**0.5  # half the angle between the normals is that of one slope
    p = np.array([10.0, 0, 5])
    expected = [5 * n1, p + 5 * n1, p + (0, 0, 5 / cos_half), p + 5 * n2, (20, 0, 0) + 5 * n2]
    np.testing.assert_allclose(path.centre, expected, atol=1e-12)
    np.testing.assert_allclose(path.normal[1:4], [n1, (0, 0, 1), n2], atol=1e-12)
    np.testing.assert_allclose(path.point[1:4], [p, p, p], atol=0)
    assert path.fill.tolist() == [False, False, True, True, False]


def test_rows_keep_their_provenance():
    path = closed(prism(ROOF), tolerance=1.0)
    assert path.face.tolist() == path.segment.tolist() == [0, 0, 0, 1, 1]
    assert path.coedge.tolist() == [-1, 1, 1, 1, -1]
    slopes = np.array([[-1, 0, 2], [1, 0, 2]]) / 5**0.5
    np.testing.assert_allclose(path.before, slopes[[0, 0, 0, 0, 1]], atol=1e-15)
    np.testing.assert_allclose(path.after, slopes[[0, 1, 1, 1, 1]], atol=1e-15)


def test_steps_are_the_contact_segments_on_either_side():
    path = closed(prism([(0, 0), (3, 4), (13, 4)]), tolerance=10.0)
    assert path.step_before.tolist() == [5, 5, 5, 5, 10]
    assert path.step_after.tolist() == [5, 10, 10, 10, 10]


@pytest.mark.parametrize("tolerance", [1.0, 0.1, 0.01, 0.001])
def test_an_arc_has_the_fewest_steps_within_the_tolerance(tolerance):
    path = closed(prism(ROOF), tolerance=tolerance)
    middle = path.centre[2:-2] - (10, 0, 5)
    steps, theta = len(middle), 2 * np.arctan(0.5)
    np.testing.assert_allclose(np.linalg.norm(middle, axis=1), 5 / np.cos(theta / 2 / steps), rtol=1e-14)
    assert 5 / np.cos(theta / 2 / steps) - 5 <= tolerance
    assert steps == 1 or 5 / np.cos(theta / 2 / (steps - 1)) - 5 > tolerance
    angle = np.arctan2(middle[:, 0], middle[:, 2])
    np.testing.assert_allclose(angle, -theta / 2 + theta / steps * (np.arange(steps) + 0.5), atol=1e-14)


def test_the_straight_line_across_a_gap_would_cut_the_co_edge():
    path = closed(prism(ROOF), tolerance=1.0)
    middle = (path.centre[1] + path.centre[3]) / 2
    assert np.linalg.norm(middle - (10, 0, 5)) < 5 - 0.5


def test_nearly_flat_co_edges_get_one_point_on_both_offset_planes():
    bend = 1e-8
    path = closed(prism([(0, 0), (10, 0), (20, -10 * bend), (30, -10 * bend)]))
    assert len(path.point) == 4 and not path.fill.any()
    np.testing.assert_allclose(path.centre[:, 2] - path.point[:, 2], 5, atol=1e-14)


def test_a_knife_edge_is_rounded_in_the_direction_of_travel():
    path = closed(prism([(0, 0), (10, 0), (1, 0)]), tolerance=0.1)
    assert np.isfinite(path.centre).all()
    np.testing.assert_allclose(np.linalg.norm(path.normal, axis=1), 1, atol=1e-14)
    reach = np.linalg.norm(path.centre[1:-1] - (10, 0, 0), axis=1)
    assert reach.min() > 5 - 1e-12 and reach.max() <= 5.1
    assert path.centre[:, 0].max() > 14.9


CONVEX = {
    "sphere": lambda: ball(120),
    "ellipsoid": lambda: ball(90, (20.0, 10.0, 14.0), 2),
    "box": lambda: hull(
        np.array([[x, y, z] for x in (-15.0, 15.0) for y in (-10.0, 10.0) for z in (0.0, 20.0)])
    ),
    "half cylinder": lambda: hull(
        np.array(
            [[18 * np.cos(t), y, 18 * np.sin(t)] for t in np.linspace(0, np.pi, 25) for y in (-20.0, 20.0)]
        )
    ),
    "dome": lambda: hull(
        np.array(
            [
                [a * np.cos(b), a * np.sin(b), (900 - a * a) ** 0.5]
                for a in np.linspace(1, 28, 9)
                for b in np.arange(0, 6.2, 0.4)
            ]
        )
    ),
}


@pytest.mark.parametrize("tolerance", [10.0, 0.01])
@some_in_core("part", CONVEX)
def test_chords_on_convex_parts_keep_off_the_whole_mesh(part, tolerance):
    mesh = CONVEX[part]()
    for angle in (0.0, ANGLE, np.pi / 2):
        contact = slice_mesh(mesh, np.array([-9.5, 0.0, 6.5]), angle)
        path = close_gaps(contact, mesh, 5.0, tolerance)
        assert not path.findings
        assert len(path.point) > len(contact.point) / 2
        assert clearance(path, mesh, 5).min() > 5 - 1e-6


def test_the_clearance_check_notices_a_path_that_is_too_near():
    mesh = CONVEX["sphere"]()
    contact = slice_mesh(mesh, np.array([3.0]), ANGLE)
    path = close_gaps(contact, mesh, 5.0 - 2e-6, 10.0)
    assert clearance(path, mesh).min() < 5 - 1e-6


# ---- concave
# ---------------------------------------------------------------------------------------------------------


def test_a_groove_is_trimmed_where_the_offsets_cross():
    path = closed(prism([(0, 10), (10, 0), (20, 10)]))
    np.testing.assert_allclose(path.centre[1], (10, 0, 5 * 2**0.5), atol=1e-12)
    assert len(path.point) == 3  # one point: both lines lie in one plane here
    np.testing.assert_allclose(path.point[1] + 5 * path.normal[1], path.centre[1], atol=1e-12)
    np.testing.assert_allclose(path.before[1] + path.after[1], (0, 0, 2**0.5), atol=1e-12)


@pytest.mark.parametrize("seed", range(20))
def test_both_points_of_a_skew_groove_are_on_both_offset_planes(seed):
    rng = np.random.default_rng(seed)
    skew = np.array([rng.uniform(-0.6, 0.6), 1.0, rng.uniform(-0.3, 0.3)])
    contact = prism([(-60, rng.uniform(1, 30)), (0, 0), (60, rng.uniform(1, 30))], skew)
    path = closed(contact)
    n1, n2 = contact.normal[0], contact.normal[2]
    for row in range(1, len(path.point) - 1):
        np.testing.assert_allclose([path.centre[row] @ n1, path.centre[row] @ n2], [5, 5], atol=1e-12)
    for row, (one, two) in ((1, (0, 1)), (len(path.point) - 2, (2, 3))):
        line = contact.point[two] - contact.point[one]
        np.testing.assert_allclose(np.cross(path.point[row] - contact.point[one], line), 0, atol=1e-10)
        np.testing.assert_allclose(path.point[row] + 5 * path.normal[row], path.centre[row], atol=1e-12)
        assert path.coedge[row] == -1


def valley(turn):
    """Two half planes that meet in a line through the origin at ``turn`` rad to the y axis, sloping 20 and 35
    deg."""
    along, across = np.array([np.sin(turn), np.cos(turn), 0]), np.array([np.cos(turn), -np.sin(turn), 0])
    corner = [-60 * along, 60 * along]
    for side, slope in ((-1, 0.36), (1, 0.7)):
        corner += [end + side * 60 * across + (0, 0, 60 * slope) for end in corner[:2]]
    return from_faces(np.array(corner), [[0, 1, 3], [0, 3, 2], [0, 4, 5], [0, 5, 1]])


@pytest.mark.parametrize("turn", np.radians([0, 10, -35, 60]))
def test_chords_in_a_groove_keep_off_both_sides(turn):
    mesh = valley(turn)
    path = close_gaps(slice_mesh(mesh, np.array([-7.3, 0.4, 5.0]), 0.0), mesh, 5.0, 0.01)
    assert path.fill.any() == bool(turn)
    assert clearance(path, mesh, 33).min() > 5 - 1e-6


def test_untrimmed_offsets_would_cut_into_a_groove():
    mesh = valley(0.3)
    contact = slice_mesh(mesh, np.array([0.4]), 0.0)
    assert distance((contact.point + 5 * contact.normal)[:, None], mesh.vertex[mesh.face]).min() < 4.9


FIELDS = {
    "bowl": lambda x, y: -np.sqrt(40.0**2 - x * x - y * y),
    "saddle": lambda x, y: (x * x - y * y) / 40,
    "waves": lambda x, y: 1.5 * np.sin(x / 5) * np.cos(y / 6),
}


@pytest.mark.parametrize("seed", [None, 5])
@pytest.mark.parametrize("angle", [0.0, ANGLE])
@pytest.mark.parametrize("part", FIELDS)
def test_chords_on_hollow_parts_keep_off_their_own_facets(part, angle, seed):
    mesh = field(FIELDS[part], seed=seed)
    path = close_gaps(slice_mesh(mesh, np.linspace(-15.3, 15.1, 7), angle), mesh, 5.0, 0.01)
    own, row = own_clearance(path, mesh)
    cut = np.isin(path.segment, path.segment[~path.fill])
    whole = (
        (path.segment[row + 1] - path.segment[row] <= 1) & cut[row] & cut[row + 1]
    )  # no segment was used up here
    assert np.count_nonzero(whole) > 0.85 * len(row)
    assert own[whole].min() > 5 - 1e-6
    assert own.min() > 5 - 0.1  # elsewhere no worse than the facets' own steps


# ---- where trims use segments up
# --------------------------------------------------------------------------------------


def test_a_step_lower_than_the_radius_is_rolled_over():
    path = closed(prism([(0, 0), (20, 0), (20, -2), (40, -2)]))
    reach = np.linalg.norm(path.centre - (20, 0, 0), axis=1)
    assert (reach[1:-1] > 5 - 1e-12).all() and (reach[1:-1] < 5.011).all()
    assert path.centre[:, 2].min() == pytest.approx(3, abs=1e-12)
    assert path.centre[-2, 0] == pytest.approx(
        24, abs=0.05
    )  # a ball on the floor that touches the edge: 20 + (25 - 9) ** 0.5
    assert {tuple(row) for row in np.round(path.before, 12)} == {
        (0.0, 0.0, 1.0)
    }  # the wall is gone, and the axis stays upright
    assert codes(path) == ["corner-not-reached"]


def test_a_step_upwards_is_the_same_the_other_way_round():
    down = closed(prism([(0, 0), (20, 0), (20, -2), (40, -2)]))
    up = closed(prism([(0, -2), (20, -2), (20, 0), (40, 0)]))
    np.testing.assert_allclose(up.centre[::-1] * (-1, 1, 1) + (40, 0, 0), down.centre, atol=1e-9)


def test_a_slot_narrower_than_the_cutter_is_bridged(worst):
    path = closed(prism([(0, 0), (20, 0), (20, -9), (26, -9), (26, 0), (46, 0)]))
    lowest = path.centre[path.centre[:, 2].argmin()]
    np.testing.assert_allclose(lowest, (23, 0, 4), atol=0.05)  # the ball sits on both edges: 5, 3, 4
    edges = np.array([(20.0, 0, 0), (26.0, 0, 0)])
    u = np.linspace(0, 1, 9)[:, None, None]
    chord = path.centre[:-1] * (1 - u) + path.centre[1:] * u
    assert np.linalg.norm(chord[..., None, :] - edges, axis=-1).min() > 5 - 1e-9
    finding = path.findings[0]
    assert (finding.code, finding.severity) == ("corner-not-reached", Severity.WARNING)
    assert "an inside corner is tighter than the cutter" in finding.text and "facet" not in finding.text
    assert "known here" not in finding.text and "where that is asked for (rest on)" in finding.text
    assert worst[1].worst == pytest.approx(np.hypot(3, 13) - 5, abs=0.05)


@pytest.mark.parametrize("radius", [2.0, 3.0])
@pytest.mark.parametrize("count", [5, 40])
def test_a_fillet_tighter_than_the_cutter_becomes_a_corner(radius, count, worst):
    angle = np.linspace(np.pi, 1.5 * np.pi, count)
    fillet = [(radius * np.cos(t), radius + radius * np.sin(t)) for t in angle]
    path = closed(prism([(-radius, 30.0), *fillet, (30.0, 0.0)]))
    np.testing.assert_allclose(path.centre, [(5 - radius, 0, 30), (5 - radius, 0, 5), (30, 0, 5)], atol=1e-9)
    assert path.segment.tolist() == [0, 0, count]
    gap = (2**0.5 - 1) * (5 - radius)  # between the arc of the fillet and that of the ball, at 45 deg
    assert codes(path) == ["corner-not-reached"] and worst[1].worst == pytest.approx(gap, rel=0.05)


def test_a_fillet_wider_than_the_cutter_is_followed():
    angle = np.linspace(np.pi, 1.5 * np.pi, 41)
    path = closed(prism([(-8.0, 30.0), *((8 * np.cos(t), 8 + 8 * np.sin(t)) for t in angle), (30.0, 0.0)]))
    assert len(np.unique(path.segment)) == 42 and not path.findings
    reach = np.linalg.norm(path.centre[2:-2] - (0, 0, 8), axis=1)
    np.testing.assert_allclose(reach, 3, atol=0.02)


def test_a_short_facet_at_the_border_is_dropped_and_still_kept_off():
    path = closed(prism([(-0.5, 0.5), (0, 0), (30, 0)]))
    assert path.segment.tolist() == [1, 1]
    np.testing.assert_allclose(
        path.centre[0], ((25 - 4.5**2) ** 0.5 - 0.5, 0, 5), atol=0.01
    )  # on the floor, at the border
    assert np.linalg.norm(path.centre[0] - (-0.5, 0, 0.5)) > 5 - 1e-12
    back = closed(prism([(-30, 0), (0, 0), (0.5, 0.5)]))
    np.testing.assert_allclose(back.centre[::-1] * (-1, 1, 1), path.centre, atol=1e-12)


def test_a_slot_at_the_border_is_bridged_from_edge_to_edge():
    path = closed(prism([(4, -1), (4, -6), (5, -1), (13, -1)]))
    np.testing.assert_allclose(path.centre[0], (4.5, 0, -1 + (25 - 0.25) ** 0.5), atol=0.02)
    assert np.linalg.norm(path.centre[0] - (4, 0, -1)) > 5 - 1e-12


def test_a_dent_too_small_for_the_ball_is_bridged():
    path = closed(prism([(0, 0), (10, 0), (10.2, -0.3), (10.4, 0), (20, 0)]))
    assert path.centre[:, 2].min() > 4.99
    assert set(path.segment[~path.fill]) == {0, 3}


def test_a_hole_that_the_cutter_does_not_enter_leaves_nothing():
    path = closed(prism([(0, 0), (6, 0), (6, 6), (0, 6)], closed=True))
    assert len(path.point) == 0 and codes(path) == ["corner-not-reached"]
    assert path.findings[0].value is None


def random_profile(rng):
    """Ups and downs of any slope, or stairs with walls and slots."""
    count = rng.integers(3, 25)
    if rng.random() < 0.5:
        return np.cumsum(rng.uniform(0.01, 5, count)), rng.normal(0, rng.choice([0.1, 1, 5]), count)
    x, z = np.cumsum(rng.choice([0.0, 1, 4, 10], count)), np.cumsum(rng.choice([0.0, 0, 1, -1, 5, -5], count))
    fin = (x[1:-1] == x[:-2]) & (x[2:] == x[1:-1])  # no wall on a wall
    keep = np.concatenate([[True], ~fin, [True]])
    return x[keep], z[keep]


@pytest.mark.parametrize("seed", range(150))
def test_random_profiles_are_kept_off_or_it_is_stated(seed):
    rng = np.random.default_rng(seed)
    contact = prism(list(zip(*random_profile(rng), strict=True)))
    path = closed(contact, tolerance=rng.choice([0.01, 1.0]))
    start, step = contact.point[::2], contact.point[1::2] - contact.point[::2]
    u = np.linspace(0, 1, 7)[:, None, None]
    chord = (path.centre[:-1] * (1 - u) + path.centre[1:] * u).reshape(-1, 1, 3)
    t = np.clip(((chord - start) * step).sum(-1) / np.maximum((step * step).sum(-1), 1e-30), 0, 1)
    near = np.linalg.norm(chord - start - t[..., None] * step, axis=-1).min(initial=5.0)
    assert near > 5 - 0.01 or "surface-tighter-than-cutter" in codes(path)


def test_what_cannot_be_resolved_is_stated(monkeypatch):
    monkeypatch.setattr(trimming, "ROUNDS", 1)
    angle = np.linspace(np.pi, 1.5 * np.pi, 40)
    fillet = [(3 * np.cos(t), 3 + 3 * np.sin(t)) for t in angle]
    path = closed(prism([(-3.0, 30.0), *fillet, (30.0, 0.0)]))
    assert "surface-tighter-than-cutter" in codes(path)
    assert np.isfinite(path.centre).all()


def test_rough_ground_gives_finite_rows_and_says_where_it_is_poor():
    rng = np.random.default_rng(3)
    mesh = field(lambda x, y: rng.normal(size=x.shape), 25)
    for radius in (0.5, 5.0):
        path = close_gaps(slice_mesh(mesh, np.linspace(-15, 15, 5), ANGLE), mesh, radius, 0.01)
        assert np.isfinite(path.centre).all()
        np.testing.assert_allclose(np.linalg.norm(path.normal, axis=1), 1, atol=1e-12)
        assert "corner-not-reached" in codes(path)
        assert all(finding.place is not None for finding in path.findings)


@pytest.mark.parametrize("radius", [4.0, 5.0])
def test_on_wavy_ground_no_height_is_reported_that_is_not_known(radius, worst):
    """More stays than is measured to the facets that were dropped: by brute force over all segments against
    all chords."""
    mesh = field(lambda x, y: 1.5 * np.sin(x / 1.5) * np.cos(y / 2.0), 31)
    contact = slice_mesh(mesh, np.linspace(-15, 15, 7), ANGLE)
    path = close_gaps(contact, mesh, radius, 0.01)
    (corner,) = [one for one in path.findings if one.code == "corner-not-reached"]
    start, step = path.centre[:-1], np.diff(path.centre, axis=0)
    whole = np.diff(path.polyline) == 0
    stays = 0.0
    for share in np.linspace(0.0, 1.0, 7):
        off = ((1.0 - share) * contact.point[::2] + share * contact.point[1::2])[:, None] - start[whole]
        t = np.clip((off * step[whole]).sum(-1) / np.maximum((step[whole] ** 2).sum(-1), 1e-30), 0, 1)
        stays = max(
            stays, np.linalg.norm(off - t[..., None] * step[whole], axis=-1).min(axis=1).max() - radius
        )
    assert stays > 1.2 * worst[1].worst
    assert corner.value is None and "not known" in corner.text and " mm" not in corner.text


# ---- polylines
# -------------------------------------------------------------------------------------------------------


def test_a_closed_polyline_ends_where_it_began():
    for corners in (
        [(0, 0), (0, 12), (12, 12), (12, 0)],
        [(0, 0), (16, 0), (16, 16), (0, 16)],
        [(0, 0), (2, 21), (29, 29), (25, -3)],
    ):
        for profile in (corners, corners[::-1]):
            path = closed(prism(profile, (0.2, 1.0, 0.1), closed=True))
            assert len(path.point) >= 4
            for name in ("point", "centre", "normal", "before", "after"):
                np.testing.assert_array_equal(getattr(path, name)[0], getattr(path, name)[-1])
            assert not path.fill[0]


def test_a_box_all_round_has_an_arc_at_every_corner():
    path = closed(prism([(0, 0), (0, 10), (10, 10), (10, 0)], closed=True), tolerance=10.0)
    assert len(path.point) == 1 + 4 * 3
    assert np.count_nonzero(path.fill) == 8
    reach = np.linalg.norm(path.centre - path.point, axis=1)
    assert np.count_nonzero(np.isclose(reach, 5 * 2**0.5)) == 4


def test_segments_of_no_length_are_left_out():
    profile = [(0, 0), (10, 5), (10, 5), (20, 0)]
    path, plain = closed(prism(profile)), closed(prism(ROOF))
    np.testing.assert_allclose(path.centre, plain.centre, atol=1e-12)
    assert set(path.segment) == {0, 2}


def test_a_plane_through_vertices_gives_no_needless_rows():
    mesh = field(lambda x, y: -0.01 * (x * x + y * y))
    path = close_gaps(slice_mesh(mesh, np.array([0.0]), 0.0), mesh, 5.0, 10.0)
    assert len(path.point) == 2 + 3 * 19


def test_polylines_do_not_touch_each_other():
    parts = [
        prism(ROOF),
        prism([(0, 0), (20, 0), (20, -2), (40, -2)], (0.1, 1, 0)),
        prism([(0, 0), (0, 9), (9, 9)], closed=True),
        prism([(0, 0), (6, 0), (6, 6), (0, 6)], closed=True),
        prism([(0, 9), (9, 0), (25, 9)], (0.3, 1, 0)),
        prism([(0, 0), (20, 0), (20, -9), (26, -9), (26, 0), (46, 0)]),
    ]
    path, alone = closed(joined(*parts)), [closed(part) for part in parts]
    for name in (
        "point",
        "centre",
        "normal",
        "before",
        "after",
        "step_before",
        "step_after",
        "face",
        "coedge",
        "fill",
    ):
        np.testing.assert_array_equal(
            getattr(path, name), np.concatenate([getattr(one, name) for one in alone])
        )
    assert path.polyline.tolist() == np.repeat(np.arange(6), [len(one.point) for one in alone]).tolist()
    np.testing.assert_array_equal(path.pass_, path.polyline)


def test_the_size_of_the_parts_worked_on_does_not_matter(monkeypatch):
    mesh = field(FIELDS["waves"], seed=2)
    contact = slice_mesh(mesh, np.linspace(-15, 15, 6), ANGLE)
    whole = close_gaps(contact, mesh, 5.0, 0.001)
    monkeypatch.setattr(columns, "CHUNK", 14)
    monkeypatch.setattr(junction, "CHUNK", 7)
    monkeypatch.setattr(junction, "GROUP", 20)
    small = close_gaps(contact, mesh, 5.0, 0.001)
    for name in ("centre", "before", "after", "segment", "fill"):
        np.testing.assert_array_equal(getattr(whole, name), getattr(small, name))


def test_no_contact_gives_no_rows():
    mesh = field(FIELDS["bowl"])
    path = close_gaps(slice_mesh(mesh, np.array([500.0]), 0.0), mesh, 5.0, 0.01)
    assert len(path.point) == 0 and path.centre.shape == (0, 3)


@pytest.mark.parametrize(
    ("radius", "tolerance"),
    [(0.0, 0.01), (-1.0, 0.01), (np.nan, 0.01), (np.inf, 0.01), (5.0, 0.0), (5.0, np.nan)],
)
def test_a_radius_or_tolerance_that_is_no_length_is_refused(radius, tolerance):
    with pytest.raises(SettingsError, match="give a length above 0"):
        closed(prism(ROOF), radius, tolerance)


def test_a_whole_number_serves_as_radius():
    np.testing.assert_array_equal(closed(prism(ROOF), 5).centre, closed(prism(ROOF), 5.0).centre)


def test_progress_can_stop_it():
    class Stop(Exception):
        pass

    def stop(stage, fraction):
        raise Stop

    mesh = field(FIELDS["bowl"])
    with pytest.raises(Stop):
        close_gaps(slice_mesh(mesh, np.array([0.5]), 0.0), mesh, 5.0, 0.01, progress=stop)


OPEN = [field(lambda x, y: 3 * np.sin(x / 4) * np.cos(y / 5), 14), field(lambda x, y: np.abs(x + 0.3 * y), 9)]


@pytest.mark.parametrize("mesh", OPEN)
def test_a_pass_cut_backwards_has_the_same_centres_with_before_and_after_swapped(mesh):
    offsets = np.linspace(-9.7, 9.1, 5)
    there, both = (
        close_gaps(slice_mesh(mesh, offsets, ANGLE, order=order), mesh, 5.0, 0.01)
        for order in ("one_way", "zigzag")
    )
    rows = np.concatenate(
        [np.flatnonzero(there.pass_ == k)[:: -1 if k % 2 else 1] for k in np.unique(there.pass_)]
    )
    back = there.pass_[rows] % 2 == 1
    np.testing.assert_allclose(both.centre, there.centre[rows], atol=1e-9)
    for one, two in (
        ("before", "after"),
        ("after", "before"),
        ("step_before", "step_after"),
        ("step_after", "step_before"),
    ):
        np.testing.assert_allclose(getattr(both, one)[back], getattr(there, two)[rows][back], atol=1e-9)
        np.testing.assert_allclose(getattr(both, one)[~back], getattr(there, one)[rows][~back], atol=1e-9)
    moved = np.flatnonzero((both.polyline[1:] == both.polyline[:-1]) & back[1:]) + 1
    np.testing.assert_array_equal(
        both.fill[moved], there.fill[rows[moved - 1]]
    )  # the move is the same, gone the other way


@pytest.mark.parametrize("mesh", OPEN)  # in the second one trims use up whole facets
def test_at_the_ends_of_an_open_polyline_both_sides_are_its_own_facet(mesh):
    path = close_gaps(slice_mesh(mesh, np.linspace(-9.7, 9.1, 5), ANGLE), mesh, 5.0, 0.01)
    begin = np.flatnonzero(np.diff(path.polyline, prepend=-1))
    for row in (begin, np.append(begin[1:], len(path.point)) - 1):
        for side in (path.before, path.after):
            np.testing.assert_array_equal(side[row], mesh.normal[path.face[row]])
        np.testing.assert_array_equal(path.step_before[row], path.step_after[row])
