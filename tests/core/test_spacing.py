# SPDX-License-Identifier: LGPL-2.1-or-later
"""The planes: a constant stepover, and the scallop that is really left, measured by dense sampling of
analytic surfaces."""

import math

import numpy as np
import pytest
from scipy.spatial import cKDTree
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import Cancelled, FiveAxisError, SettingsError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.passes import prepare_planes, slice_mesh
from freecad_fiveaxis.core.passes.scallop import (
    compute_turn,
    facet_curvature,
    flat_interval,
    kink_factor,
    scallop_height,
)
from freecad_fiveaxis.core.passes.spacing import AIM

RADIUS, SCALLOP, LEAST = 5.0, 0.01, 0.02
LENGTH, WIDTH = 13.0, 11.0  # of the patches, along and across the passes
TURN = 0.3  # of the patches and their passes in the xy-plane, rad


def place_planes(*given, **options):
    return prepare_planes(*given, **options)()


def grid_faces(along, across):
    row = np.arange((along + 1) * (across + 1)).reshape(along + 1, across + 1)
    a, b, c, d = (corner.ravel() for corner in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def turned(s, t, turn):
    return s * math.cos(turn) - t * math.sin(turn), s * math.sin(turn) + t * math.cos(turn)


def patch(height, length=LENGTH, width=WIDTH, size=0.2, turn=TURN, uneven=0.25, seed=5):
    """Mesh of z = height(x, y) over a rectangle whose sides lie along and across the passes."""
    along, across = round(length / size), round(width / size)
    s, t = np.meshgrid(
        np.linspace(-0.5, 0.5, along + 1) * length, np.linspace(-0.5, 0.5, across + 1) * width, indexing="ij"
    )
    rng = np.random.default_rng(seed)
    s[1:-1, 1:-1] += rng.uniform(-uneven, uneven, s[1:-1, 1:-1].shape) * size
    t[1:-1, 1:-1] += rng.uniform(-uneven, uneven, s[1:-1, 1:-1].shape) * size
    x, y = turned(s, t, turn)
    return from_faces(
        np.column_stack([x.ravel(), y.ravel(), height(x, y).ravel()]), grid_faces(along, across)
    )


def plane(tilt, toward):
    a, b = math.tan(tilt) * math.cos(toward), math.tan(tilt) * math.sin(toward)
    return lambda x, y: a * x + b * y


def cylinder(radius, axis):
    """Convex for a positive radius, concave for a negative one."""

    def height(x, y):
        v = -math.sin(axis) * x + math.cos(axis) * y
        return math.copysign(1.0, radius) * np.sqrt(radius**2 - v**2)

    return height


def sphere(radius):
    return lambda x, y: math.copysign(1.0, radius) * np.sqrt(radius**2 - x**2 - y**2)


def normals(height, x, y, step=1e-4):
    a = (height(x + step, y) - height(x - step, y)) / (2 * step)
    b = (height(x, y + step) - height(x, y - step)) / (2 * step)
    n = np.stack([-a, -b, np.ones_like(a)], axis=-1)
    return n / np.linalg.norm(n, axis=-1, keepdims=True)


def surface(height, s, t, turn):
    x, y = turned(s, t, turn)
    return np.stack([x, y, height(x, y)], axis=-1)


def smooth_centres(height, offset, length, turn):
    """Ball centres over the smooth surface along one plane, every 0.04 mm."""
    s = np.arange(-0.5 * length, 0.5 * length, 0.04)
    point = surface(height, s, np.full_like(s, offset), turn)
    return point + RADIUS * normals(height, point[:, 0], point[:, 1])


def facet_centres(path, plane):
    """Ball centres over the facets that one plane cuts, every 0.04 mm, and on arcs where one facet follows
    another."""
    entry = np.flatnonzero(path.pass_ == plane)[::2]
    start, end, normal = path.point[entry], path.point[entry + 1], path.normal[entry]
    share = np.linspace(0.0, 1.0, 2 + int(np.linalg.norm(end - start, axis=1).max() / 0.04))[:, None, None]
    along = start + share * (end - start) + RADIUS * normal
    joined = np.flatnonzero(path.polyline[entry[1:]] == path.polyline[entry[:-1]])
    turn = normal[joined] + np.linspace(0.0, 1.0, 5)[:, None, None] * (normal[joined + 1] - normal[joined])
    arcs = end[joined] + RADIUS * turn / np.linalg.norm(turn, axis=-1, keepdims=True)
    return np.concatenate([along.reshape(-1, 3), arcs.reshape(-1, 3)])


def left_between(height, first, second, centres, length=LENGTH, turn=TURN):
    """Largest distance of the surface between two planes from the nearer pass's centres, less the radius.

    Half an interval short of the ends: beyond, the surface no longer lies between two passes where they end
    aslant.
    """
    s, t = np.meshgrid(
        np.arange(-0.5, 0.5, 0.13 / length) * (length - 1),
        np.linspace(first, second, 25)[1:-1],
        indexing="ij",
    )
    point = surface(height, s, t, turn).reshape(-1, 3)
    nearest = np.minimum(*(cKDTree(part).query(point)[0] for part in centres))
    return nearest.max() - RADIUS


def some_pairs(offsets, count=3):
    return np.unique(np.linspace(0, len(offsets) - 2, count).round().astype(int))


SURFACES = {f"plane {tilt} deg toward {toward} deg": plane(math.radians(tilt), math.radians(toward))
            for tilt in (0, 30, 60) for toward in (17, 60, 107)}  # fmt: skip
SURFACES |= {f"cylinder {radius} along {axis} deg": cylinder(radius, math.radians(axis))
             for radius in (18, 60, -18, -60) for axis in (17, 60, 107)}  # fmt: skip
SURFACES |= {f"sphere {radius}": sphere(radius) for radius in (18, 60, -18, -60)}


@some_in_core("name", SURFACES, kept=(0, 4, 9, 13, 16, 20, 21, 23))
def test_the_scallop_left_is_nearly_what_was_requested_and_never_more(name):
    height = SURFACES[name]
    mesh = patch(height, size=0.5 if "plane" in name else 0.13)
    offsets, found = place_planes(mesh, TURN, RADIUS, scallop=SCALLOP, least=LEAST)
    assert not found
    pairs = some_pairs(offsets)
    path = slice_mesh(mesh, offsets, TURN)
    for i in pairs:
        smooth = [smooth_centres(height, offsets[k], LENGTH, TURN) for k in (i, i + 1)]
        driven = [facet_centres(path, k) for k in (i, i + 1)]
        for centres in (smooth, driven):
            share = left_between(height, offsets[i], offsets[i + 1], centres) / SCALLOP
            assert 0.8 <= share <= 1.0, (i, share, centres is driven)


def test_wider_planes_would_fail_that_measure():
    height = sphere(60)
    offsets, _ = place_planes(patch(height), TURN, RADIUS, scallop=SCALLOP, least=LEAST)
    first, second = offsets[5], offsets[5] + 1.15 * (offsets[6] - offsets[5])
    centres = [smooth_centres(height, offset, LENGTH, TURN) for offset in (first, second)]
    assert left_between(height, first, second, centres) > 1.1 * SCALLOP


@pytest.mark.oldest
@pytest.mark.thorough
def test_the_interval_on_a_flat_is_equation_2_and_shrinks_with_the_slope():
    flat = 2 * math.sqrt(RADIUS**2 - (RADIUS - AIM * SCALLOP) ** 2)
    for tilt in (0, 30, 60):
        mesh = patch(plane(math.radians(tilt), TURN + math.pi / 2), length=4.0, width=40.0, size=1.0)
        offsets, _ = place_planes(mesh, TURN, RADIUS, scallop=SCALLOP, least=LEAST)
        assert np.diff(offsets).max() == pytest.approx(flat * math.cos(math.radians(tilt)), rel=1e-6)


def test_the_outermost_planes_stand_within_half_an_interval_of_the_edge():
    for width in np.linspace(3.0, 5.0, 9):
        offsets, _ = place_planes(patch(sphere(30), width=width), TURN, RADIUS, scallop=SCALLOP, least=LEAST)
        interval = np.diff(offsets)
        assert 0 < offsets[0] + width / 2 <= 0.505 * interval[0] / math.sqrt(0.9), width
        assert 0 < width / 2 - offsets[-1] <= 0.55 * interval[-1] / math.sqrt(0.9), width
        assert interval.min() > 0.85 * interval.max()


@pytest.mark.parametrize("curvature", [0.0, 1e-6, 1 / 60, 1 / 4, -1 / 60, -1 / 8])
def test_the_scallop_height_is_where_two_circles_meet(curvature):
    radius, chord = 5.0, 0.7
    if curvature:
        big = 1 / curvature
        half = math.asin(0.5 * chord / big)
        reach = abs(big + radius)
        x, y = reach * math.sin(abs(half)), reach * math.cos(half)
        drop = math.sqrt(radius**2 - x**2)
        expected = (y - drop) - big if big > 0 else -(y + drop) - big
    else:
        expected = radius - math.sqrt(radius**2 - 0.25 * chord**2)
    height = scallop_height(np.array([chord]), radius, np.array([curvature]))[0]
    assert height == pytest.approx(expected, rel=1e-6 if abs(curvature) != 1e-6 else 1e-3)


def test_balls_that_do_not_meet_leave_half_their_distance():
    np.testing.assert_allclose(
        scallop_height(np.array([10.0, 12.0, 40.0]), 5.0, np.zeros(3)), [5.0, 6.0, 20.0]
    )


def test_the_flat_interval_inverts_the_flat_scallop():
    for scallop in (1e-6, 0.01, 1.0, 4.9):
        assert scallop_height(np.array([flat_interval(5.0, scallop)]), 5.0, np.zeros(1))[0] == pytest.approx(
            scallop
        )


@pytest.mark.parametrize("share", [0.0, 0.2, 0.5, 0.9])
@pytest.mark.parametrize("angle", [0.05, 0.3, 1.2])
def test_an_edge_between_two_contacts_leaves_no_more_than_its_bound(angle, share):
    chord = 0.6
    a, b = share * chord, (1 - share) * chord  # to the edge at (0, 0); the second facet falls by ``angle``
    first, down = np.array([-a, RADIUS]), np.array([math.cos(angle), -math.sin(angle)])
    second = b * down + RADIUS * np.array([math.sin(angle), math.cos(angle)])
    x = np.linspace(-a, b, 4001)[:, None]
    surface_points = np.where(x < 0, x * np.array([1.0, 0.0]), x * down)
    left = np.minimum(*(np.linalg.norm(surface_points - c, axis=1) for c in (first, second))).max() - RADIUS
    far = np.array([max(share, 1 - share)])
    bound = (
        chord**2
        / (8 * RADIUS)
        * kink_factor(np.array([chord]), RADIUS, np.array([angle]), np.zeros(1), far)[0]
    )
    assert left <= bound * 1.02
    assert bound <= 1.3 * max(left, chord**2 / (8 * RADIUS)) or angle < 0.1


def test_an_edge_across_the_passes_raises_nothing():
    one = np.ones(1)
    assert kink_factor(0.6 * one, RADIUS, 0.5 * one, 0.5 * one, one)[0] == 1.0
    assert kink_factor(0.6 * one, RADIUS, -0.5 * one, 0.0 * one, one)[0] == 1.0


@pytest.mark.parametrize("radius", [30.0, -30.0])
def test_facets_of_cylinder_and_sphere_have_their_curvature(radius):
    for height, round_across in ((cylinder(radius, 0.0), 0.0), (sphere(radius), 1.0)):
        mesh = patch(height, size=0.4, turn=0.0, uneven=0.0)
        tensor = facet_curvature(mesh)
        for direction, expected in (((0.0, 1.0, 0.0), 1.0), ((1.0, 0.0, 0.0), round_across)):
            tangent = np.array(direction) - (mesh.normal @ direction)[:, None] * mesh.normal
            tangent /= np.linalg.norm(tangent, axis=1)[:, None]
            along = (compute_turn(tensor, tangent) * tangent).sum(axis=1)
            inner = np.abs(mesh.vertex[mesh.face].mean(axis=1)[:, :2]).max(axis=1) < 4.0
            assert np.median(along[inner]) * radius == pytest.approx(expected, abs=0.02)


def test_facets_that_hang_together_nowhere_are_flat():
    """Sums over no co-edge at all are whole numbers in numpy, and an area below 1 mm2 would be none."""
    loose = box(size=(0.9, 0.8, 0.7))
    apart = from_faces(loose.vertex[loose.face].reshape(-1, 3), np.arange(3 * len(loose.face)).reshape(-1, 3))
    tensor = facet_curvature(apart)
    assert tensor.shape == (6, len(apart.face)) and (tensor == 0.0).all()


def test_a_sharp_edge_bends_no_surface():
    assert not facet_curvature(box()).any()


# ----------------------------------------------------------------------------------------- walls, steps, gaps


def box(size=(20.0, 30.0, 10.0), low=(0.0, 0.0, 0.0), draft=0.0):
    """Box with walls that lean in by ``draft`` mm over their height."""
    x, y, z = size
    lean = np.array([[draft * (1 - 2 * i), draft * (1 - 2 * j), 0.0] for i in (0, 1) for j in (0, 1)])
    bottom = np.array([[i * x, j * y, 0.0] for i in (0, 1) for j in (0, 1)])
    vertex = np.concatenate([bottom, bottom + lean + (0.0, 0.0, z)]) + low
    face = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 2, 6], [0, 6, 4],
            [1, 5, 7], [1, 7, 3], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6]]  # fmt: skip
    return from_faces(vertex, np.array(face))


def upward(mesh):
    return mesh.normal[:, 2] > -1e-6


@some_in_core("angle", [0.0, 0.4, math.pi / 2], kept=(0, 2))
def test_sharp_edges_and_upright_walls_stop_nothing(angle):
    mesh = box()
    offsets, found = place_planes(mesh, angle, RADIUS, scallop=SCALLOP, least=LEAST, keep=upward(mesh))
    slope = max(min(abs(math.cos(angle)), abs(math.sin(angle))), 1e-3)  # of the walls across the planes
    span = 20 * abs(math.sin(angle)) + 30 * abs(math.cos(angle))
    flat = flat_interval(RADIUS, SCALLOP)
    assert len(offsets) <= span / flat * 1.1 / (slope if slope > 1e-2 else 1.0) + 2
    assert not found


def test_a_steep_wall_goes_on_at_the_least_interval_with_a_warning():
    mesh = box(draft=0.5)
    offsets, found = place_planes(mesh, 0.0, RADIUS, scallop=SCALLOP, least=0.1, keep=upward(mesh))
    assert [finding.code for finding in found] == ["least-interval"]
    assert found[0].severity == Severity.WARNING and found[0].unit == "mm" and found[0].limit == SCALLOP
    climb = math.hypot(0.1, 0.1 * 10 / 0.5)  # of neighbouring passes on the wall
    between = RADIUS - math.sqrt(RADIUS**2 - climb**2 / 4)
    assert (
        between <= found[0].value <= 4 * between
    )  # more where the edge of the wall lies at one of the passes
    assert np.diff(offsets).min() == pytest.approx(0.1)
    assert found[0].place is not None and min(found[0].place[1], 30 - found[0].place[1]) < 0.6
    assert str(len(np.flatnonzero(np.diff(offsets) < 0.1001))) in found[0].text


def test_what_is_higher_than_the_cutters_radius_is_called_no_scallop():
    mesh = box(draft=0.5)
    _, found = place_planes(mesh, 0.0, 0.4, scallop=SCALLOP, least=0.1, keep=upward(mesh))
    assert found[0].code == "least-interval" and found[0].value > 0.4
    assert "material up to" in found[0].text and "scallops up to" not in found[0].text
    _, low = place_planes(box(draft=0.5), 0.0, RADIUS, scallop=SCALLOP, least=0.1, keep=upward(mesh))
    assert low[0].value < RADIUS and "scallops up to" in low[0].text


def test_a_smaller_least_interval_keeps_the_scallop_on_the_wall():
    mesh = box(draft=0.5)
    _, found = place_planes(mesh, 0.0, RADIUS, scallop=SCALLOP, least=0.005, keep=upward(mesh))
    assert not found


def test_no_plane_stands_in_the_gap_between_two_islands():
    one, two = box(), box(low=(0.0, 50.0, 0.0))
    mesh = from_faces(
        np.concatenate([one.vertex, two.vertex]), np.concatenate([one.face, two.face + len(one.vertex)])
    )
    offsets, found = place_planes(mesh, 0.0, RADIUS, scallop=SCALLOP, least=LEAST, keep=upward(mesh))
    assert not found
    assert not ((offsets > 30) & (offsets < 50)).any()
    assert (offsets < 30).sum() == (offsets > 50).sum()
    assert 0 < offsets[offsets > 50][0] - 50 < 0.5


def test_only_the_facets_that_are_kept_count():
    mesh = box()
    top = mesh.normal[:, 2] > 0.5
    offsets, _ = place_planes(mesh, 0.4, RADIUS, scallop=0.1, least=LEAST, keep=top)
    every, _ = place_planes(mesh, 0.4, RADIUS, scallop=0.1, least=LEAST, keep=upward(mesh))
    assert len(offsets) < 0.6 * len(every)


# ------------------------------------------------------------------------------------------------ stepover


@pytest.mark.parametrize("stepover", [0.7, 3.0, 5.0, 29.9, 30.0, 100.0])
def test_a_stepover_is_constant_and_leaves_both_edges_alike(stepover):
    offsets, found = place_planes(box(), 0.0, RADIUS, stepover=stepover, least=LEAST)
    assert not found
    np.testing.assert_allclose(np.diff(offsets), stepover)
    assert offsets[0] == pytest.approx(30 - offsets[-1])
    assert 0 < offsets[0] <= 0.51 * max(stepover, 30.0 if len(offsets) == 1 else 0)
    assert len(offsets) == max(1, math.ceil(30 / stepover - 1e-3))


# ----------------------------------------------------------------------------------------- settings, progress


@pytest.mark.parametrize(
    ("wrong", "named"),
    [
        ({"scallop": 0.0}, "scallop 0"),
        ({"scallop": -0.01}, "scallop -0.01"),
        ({"scallop": 5.0}, "cutter radius 5"),
        ({"scallop": math.nan}, "scallop nan"),
        ({"stepover": 0.0}, "stepover 0"),
        ({"stepover": -1.0}, "stepover -1"),
        ({"stepover": 1e-7}, "planes"),
        ({"scallop": 1e-12}, "planes"),
        ({"scallop": 0.01, "stepover": 1.0}, "both"),
        ({}, "neither"),
        ({"scallop": 0.01, "least": 0.0}, "least interval 0"),
        ({"scallop": 0.01, "radius": 0.0}, "cutter radius 0"),
        ({"scallop": 0.01, "angle": math.inf}, "direction"),
        ({"scallop": 0.01, "keep": np.zeros(12, dtype=bool)}, "no facet"),
    ],
)
def test_settings_out_of_range_are_named_with_their_remedy(wrong, named):
    options = {"least": LEAST, "angle": 0.0, "radius": RADIUS} | wrong
    with pytest.raises(SettingsError, match=named) as caught:
        place_planes(box(), options.pop("angle"), options.pop("radius"), **options)
    assert isinstance(caught.value, FiveAxisError) and "\n" not in str(caught.value)
    assert "give" in str(caught.value) or "turn" in str(caught.value)


def test_progress_rises_to_one_and_can_stop_the_work(monkeypatch):
    monkeypatch.setattr("freecad_fiveaxis.core.passes.spacing.PERIOD", -1.0)
    reported = []
    place_planes(
        box(), 0.0, RADIUS, scallop=0.1, least=LEAST, progress=lambda stage, share: reported.append(share)
    )
    assert len(reported) > 5 and reported == sorted(reported) and reported[0] > 0 and reported[-1] <= 1

    def stop(stage, share):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        place_planes(box(), 0.0, RADIUS, scallop=0.1, least=LEAST, progress=stop)


@pytest.mark.parametrize("scallop", [1e-9, 1e-12, 1e-300])
def test_a_scallop_that_needs_too_many_samples_is_refused_at_once(scallop):
    """Its samples stand half an interval of a flat apart, 1e-4 mm at 1e-9: the work would take hours."""
    mesh = patch(plane(0.1, 0.0), length=60.0, width=60.0, size=2.0)
    with pytest.raises(
        SettingsError, match=r"scallop .* needs .*; give a larger scallop or check the units of the part"
    ):
        place_planes(mesh, TURN, RADIUS, scallop=scallop, least=0.05)


def test_the_smallest_stepover_is_reported_in_a_machinists_words():
    mesh = box(draft=0.5)
    _, found = place_planes(mesh, 0.0, 0.4, scallop=SCALLOP, least=0.1, keep=upward(mesh))
    assert (
        found[0].text.startswith("On steep walls ")
        and "binds" not in found[0].text
        and "--least-interval" in found[0].text
    )
