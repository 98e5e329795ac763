# SPDX-License-Identifier: LGPL-2.1-or-later
"""The distance in the metric of the scallop, against what is known of planes, cylinders and balls."""

import math
from dataclasses import replace

import numpy as np
import pytest
from offset_examples import joined as both_paths
from offset_examples import prism

from freecad_fiveaxis.core.base import chunks
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces
from freecad_fiveaxis.core.passes import facet_curvature, flat_interval, scallop_passes, slice_field
from freecad_fiveaxis.core.passes.field import PassField, PassOptions, Region
from freecad_fiveaxis.core.passes.geodesic import (
    _stiffness,
    as_tensor,
    distance,
    frames,
    gradient,
    scallop_metric,
    side_lengths,
    steepness,
    step_across,
)
from freecad_fiveaxis.core.passes.refine import Copy, finer_copy, join_copies, take_facets
from freecad_fiveaxis.core.passes.scallop_passes import ConstantScallop, Surface, _gaps
from freecad_fiveaxis.core.passes.sources import find_source, source_values

RADIUS, SCALLOP = 3.0, 0.02
STEP = flat_interval(RADIUS, SCALLOP)


def sheet(u, v, place):
    """Two facets for each square of the values ``u``, ``v``; ``place``: from both to points."""
    point = np.stack(place(*np.meshgrid(u, v, indexing="ij")), axis=-1)
    row = np.arange(len(u) * len(v)).reshape(len(u), len(v))
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    return from_faces(
        point.reshape(-1, 3), np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    )


HEIGHTS = np.linspace(0, 20, 41)


def cylinder(radius=10.0, count=120, height=HEIGHTS):
    """The half of a cylinder about Z that looks to +X, convex."""
    turn = np.linspace(-0.5 * math.pi, 0.5 * math.pi, count)
    return sheet(turn, height, lambda t, z: (radius * np.cos(t), radius * np.sin(t), z))


def measured(mesh, source, tensor=None, radius=RADIUS, known=None):
    frame = frames(mesh.vertex, mesh.face)
    metric = scallop_metric(frame, facet_curvature(mesh) if tensor is None else tensor, radius, STEP)
    known = np.zeros(len(source)) if known is None else known
    return distance(np.asarray(mesh.vertex), mesh.face, frame, metric, source, known), frame, metric


def test_on_a_flat_the_distance_is_the_straight_one():
    random = np.random.default_rng(2)
    mesh = sheet(
        np.linspace(-8, 8, 41),
        np.linspace(-6, 6, 31),
        lambda x, y: (x + random.uniform(-0.1, 0.1, x.shape), y, 0 * x),
    )
    source = np.array([np.linalg.norm(mesh.vertex, axis=1).argmin()])
    value, frame, metric = measured(mesh, source)
    straight = np.linalg.norm(mesh.vertex - mesh.vertex[source], axis=1) / STEP
    assert np.abs(value - straight).max() < 0.6  # nearest the one vertex that is the source
    far = straight[mesh.face].min(axis=1) > 3.0
    slope = steepness(metric, gradient(frame, mesh.face, value))[far]
    assert np.quantile(slope, 0.05) > 0.92 and np.quantile(slope, 0.95) < 1.06


def test_round_a_cylinder_a_step_is_shorter_than_along_it():
    """The ball's own curve on the convex side: ``s / sqrt(1 + r / R)`` round it, s along it (Lin & Ye, eq. 1
    on a circle)."""
    mesh = cylinder()
    source = np.array([np.linalg.norm(mesh.vertex - (10.0, 0.0, 10.0), axis=1).argmin()])
    value, *_ = measured(mesh, source)
    x, y, z = (mesh.vertex - mesh.vertex[source] * (0, 0, 1)).T
    arc = 10.0 * (np.arctan2(y, x) - math.atan2(*mesh.vertex[source[0], 1::-1]))
    known = np.sqrt(z**2 + arc**2 * (1.0 + RADIUS / 10.0)) / STEP
    assert np.abs(value - known).max() < 0.02 * known.max()


def test_in_a_hollow_a_step_is_longer_and_never_endless():
    mesh = cylinder()
    hollow = from_faces(mesh.vertex, mesh.face[:, ::-1])
    end = np.flatnonzero(mesh.vertex[:, 1] < -9.999)
    for radius, spread in ((3.0, 0.7), (9.99, 1.0 / 16.0)):
        value, *_ = measured(hollow, end, radius=radius)
        assert value.max() == pytest.approx(math.pi * 10.0 * math.sqrt(spread) / STEP, rel=0.04)


@pytest.mark.parametrize("aslant", [0.0, 0.5, 1.1, math.pi / 2])
def test_a_unit_of_the_metric_leaves_the_scallop_whichever_way_the_pass_runs(aslant):
    """Two passes on a cylinder at an angle to its axis, one unit apart; what the ball leaves is measured on
    the way half-way."""
    ring, radius = 8.0, 3.0
    mesh = cylinder(ring, 400, np.linspace(0, 20, 3))
    frame = frames(mesh.vertex, mesh.face)
    metric = scallop_metric(frame, facet_curvature(mesh), radius, STEP)
    middle = np.abs(mesh.vertex[mesh.face].mean(axis=1)[:, 1]).argmin()
    normal = mesh.normal[middle]
    round_it = np.cross((0, 0, 1.0), normal)
    across = -math.sin(aslant) * round_it + math.cos(aslant) * np.array((0, 0, 1.0))
    local = np.array([frame.one[middle] @ across, frame.two[middle] @ across])[:, None]
    step = float(step_across(metric[:, [middle]], local)[0])
    way = np.linspace(-8, 8, 40001)
    turn, rise = math.cos(aslant), math.sin(aslant)
    arc = way * turn - 0.5 * step * math.sin(aslant)
    high = way * rise + 0.5 * step * math.cos(aslant)
    centre = np.stack(
        [(ring + radius) * np.cos(arc / ring), (ring + radius) * np.sin(arc / ring), high], axis=1
    )
    low, top = 0.0, 0.1
    for _ in range(40):
        level = 0.5 * (low + top)
        stays = np.linalg.norm(centre - (ring + level, 0, 0), axis=1).min() > radius
        low, top = (level, top) if stays else (low, level)
    assert low == pytest.approx(SCALLOP, rel=0.03)


def test_the_metric_in_space_is_that_of_the_facets():
    mesh = cylinder(5.0, 20)
    frame = frames(mesh.vertex, mesh.face)
    metric = scallop_metric(frame, facet_curvature(mesh), RADIUS, STEP)
    side = mesh.vertex[np.roll(mesh.face, -1, axis=1)] - mesh.vertex[mesh.face]
    xx, yy, zz, xy, yz, zx = as_tensor(frame, metric)
    x, y, z = side.transpose(2, 1, 0)
    square = xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + yz * y * z + zx * z * x)
    np.testing.assert_allclose(np.sqrt(square), side_lengths(mesh.vertex, mesh.face, frame, metric))


def test_facets_without_heat_still_get_a_distance():
    """A strip a thousand steps long: heat would fade to nothing, and the time is chosen so that it does
    not."""
    mesh = sheet(np.linspace(0, 800, 401), np.linspace(0, 2, 3), lambda x, y: (x, y, 0 * x))
    value, *_ = measured(mesh, np.flatnonzero(mesh.vertex[:, 0] == 0.0))
    np.testing.assert_allclose(value, mesh.vertex[:, 0] / STEP, atol=1.0)


def test_a_source_that_is_known_to_be_farther_has_its_front_later():
    """Two opposite sides of a flat strip, the one half a width behind the other: the fronts meet three
    quarters of the way."""
    mesh = sheet(np.linspace(0, 20, 41), np.linspace(0, 2, 5), lambda x, y: (x, y, 0 * x))
    x = mesh.vertex[:, 0]
    source = np.flatnonzero((x == 0.0) | (x == 20.0))
    value, *_ = measured(mesh, source, known=np.where(x[source] == 0.0, 0.0, 10.0 / STEP))
    np.testing.assert_allclose(value, np.minimum(x, 30.0 - x) / STEP, atol=0.5)


def test_no_heat_flows_uphill_over_obtuse_corners():
    """Off the diagonal nothing is positive (a Stieltjes matrix has no negative inverse); of the Poisson
    equation some is."""
    mesh = sheet(np.linspace(0, 9, 10), np.linspace(0, 1, 4), lambda x, y: (x + 4.0 * y, y, 0 * x))
    frame = frames(mesh.vertex, mesh.face)
    metric = scallop_metric(frame, facet_curvature(mesh), RADIUS, STEP)
    beside = {}
    for clipped in (False, True):
        matrix = _stiffness(mesh.face, frame, metric, len(mesh.vertex), clipped).toarray()
        np.testing.assert_allclose(matrix.sum(axis=1), 0.0, atol=1e-9)
        beside[clipped] = (matrix - np.diag(np.diag(matrix))).max()
    assert beside[False] > 0.1 and beside[True] <= 0.0


def test_no_distance_is_longer_than_the_way_along_sides():
    mesh = sheet(np.linspace(0, 8, 9), np.linspace(0, 8, 9), lambda x, y: (x, y, 0 * x))
    value, *_ = measured(mesh, np.array([0]))
    x, y, _ = mesh.vertex.T
    diagonal = np.minimum(x, y) * math.sqrt(2.0) + np.abs(x - y)
    assert (value <= diagonal / STEP * (1.0 + 1e-12)).all()


# ------------------------------------------------------------------------------------------------ sources


def flat_copy(side=10.0, count=2, longest=1.5):
    mesh = sheet(np.linspace(0, side, count), np.linspace(0, side, count), lambda x, y: (x, y, 0 * x))
    rows = np.arange(len(mesh.face))
    return mesh, finer_copy(mesh, rows, flat_metric(mesh, rows), longest)


def sourced(copy, curve):
    frame = frames(copy.mesh.vertex, copy.mesh.face)
    return source_values(
        copy, frame, scallop_metric(frame, np.zeros((6, len(copy.parent))), RADIUS, STEP), np.array(curve)
    )


def test_all_corners_of_facets_under_a_curve_know_their_distance_from_it():
    _, copy = flat_copy()
    source, known = sourced(copy, [(-5.0, 3.3, 0.0), (15.0, 3.3, 0.0)])
    y = copy.mesh.vertex[:, 1]
    corner = y[copy.mesh.face]
    under = (corner.min(axis=1) < 3.3) & (corner.max(axis=1) > 3.3)
    assert under.any() and np.isin(copy.mesh.face[under], source).all()
    np.testing.assert_allclose(known, np.abs(y[source] - 3.3) / STEP, atol=0.02)


def test_the_vertex_nearest_to_a_point_counts_as_the_point():
    _, copy = flat_copy()
    source, known = sourced(copy, [(3.3, 3.2, 0.5)])
    assert source.tolist() == [
        np.linalg.norm(copy.mesh.vertex - (3.3, 3.2, 0.5), axis=1).argmin()
    ] and known.tolist() == [0.0]


def region_of(mesh):
    return Region(mesh, np.ones(len(mesh.face), bool), RADIUS, STEP)


def test_a_source_farther_off_the_surface_than_the_ball_is_thick_is_refused():
    region = region_of(flat_copy()[0])
    assert find_source((5.0, 5.0, 1.9 * RADIUS), region) is not None
    with pytest.raises(SettingsError, match=r"cannot begin at .*5.*: it is 6\.3 mm off"):
        find_source((5.0, 5.0, 2.1 * RADIUS), region)


# ------------------------------------------------------------------------------------------------ the passes


def plan_passes(mesh, **options):
    """The field of a strategy, and its passes on the copy and on the part, on flat ground."""
    field = ConstantScallop("").field(region_of(mesh), PassOptions(**options))
    contact = slice_field(field.surface.mesh, field.value, field.levels)
    return contact, field.surface.on_part(contact, mesh)


def test_the_first_pass_stands_half_a_step_from_the_border():
    contact, _ = plan_passes(flat_copy(6.0)[0], stepover=1.0)
    first = contact.point[contact.pass_ == contact.pass_.min()]
    off = np.minimum(first[:, :2], 6.0 - first[:, :2]).min(axis=1)
    assert np.median(off) == pytest.approx(0.5, abs=0.05)


def test_passes_round_a_point_are_round_within_a_part_of_a_step():
    """On two facets: only their copy can carry circles, and only short segments follow them."""
    contact, result = plan_passes(flat_copy(12.0)[0], stepover=1.0, source=(6.0, 6.0, 0.0))
    radius = np.linalg.norm(contact.point - (6.0, 6.0, 0.0), axis=1)
    assert np.abs(radius - np.floor(radius) - 0.5)[radius < 6.0].max() < 0.3
    start, step = result.point[::2], result.point[1::2] - result.point[::2]
    off = contact.point[radius < 6.0][:, None] - start
    share = np.clip((off * step).sum(axis=2) / (step * step).sum(axis=1), 0.0, 1.0)
    assert np.linalg.norm(off - share[:, :, None] * step, axis=2).min(axis=1).max() < 0.03 + 1e-9


def test_more_passes_than_any_job_can_want_are_refused_before_they_are_planned():
    with pytest.raises(SettingsError, match="more than any job can want"):
        ConstantScallop("").check(region_of(flat_copy(10.0)[0]), PassOptions(stepover=1e-3))


def test_laying_passes_tells_its_progress_and_can_be_stopped_while_gaps_are_looked_for(monkeypatch):
    monkeypatch.setattr(scallop_passes, "BATCH", 64)
    monkeypatch.setattr(chunks, "ALONE", True)  # a helper may take it all, and then has nothing to tell

    def lay(stop=math.inf):
        reported = []

        def listen(stage, share):
            reported.append(share)
            if share >= stop:
                raise InterruptedError

        ConstantScallop("").field(
            replace(region_of(flat_copy()[0]), progress=listen), PassOptions(stepover=0.5)
        )
        return reported

    reported = lay()
    assert reported == sorted(reported) and len([share for share in reported if 0.9 < share < 1.0]) >= 4
    for stop in (0.84, 0.95):
        with pytest.raises(InterruptedError):
            lay(stop)


def gaps_of(copy, metric, value, levels):
    """The facets that are left out by the passes at ``levels``."""
    frame = frames(copy.mesh.vertex, copy.mesh.face)
    return _gaps(Surface(copy, frame, metric, 1.0), value, PassField(value, np.array(levels), surface=copy))


def unit_metric(copy, scale=1.0):
    frame = frames(copy.mesh.vertex, copy.mesh.face)
    return scallop_metric(frame, np.zeros((6, len(copy.parent))), RADIUS, 1.0 / scale)


def test_a_pass_does_not_cover_the_other_side_of_a_thin_wall():
    """Two faces 0.01 mm apart that look away from each other, with passes on the one alone."""
    one = flat_copy(4.0)[0]
    back = from_faces(one.vertex - (0, 0, 0.01), one.face[:, ::-1])
    a, b = (finer_copy(mesh, np.arange(2), flat_metric(mesh, np.arange(2)), 1.0) for mesh in (one, back))
    copy = join_copies(a, b)
    value = copy.mesh.vertex[:, 0] + 100.0 * copy.component
    left = gaps_of(copy, unit_metric(copy), value, [0.5, 1.5, 2.5, 3.5])
    np.testing.assert_array_equal(left, copy.mesh.normal[:, 2] < 0.0)


def test_where_steps_are_half_as_long_every_second_pass_is_too_few():
    _, copy = flat_copy(4.0, longest=0.5)
    value, metric = 2.0 * copy.mesh.vertex[:, 0], unit_metric(copy, 2.0)
    assert not gaps_of(copy, metric, value, np.arange(0.5, 8.0)).any()
    assert gaps_of(copy, metric, value, [0.5, 2.5, 4.5, 6.5, 7.5]).any()


@pytest.mark.parametrize("half", [0.2, 0.5, 3.0])
def test_passes_are_looked_for_no_farther_than_it_matters(half, monkeypatch):
    """The same facets are left out as where the nearest pass is found however far it is."""
    _, copy = flat_copy(8.0, longest=half)
    metric = unit_metric(copy) * np.linspace(0.5, 4.0, len(copy.mesh.face))  # steps that differ
    found = [gaps_of(copy, metric, copy.mesh.vertex[:, 0], [0.5, 1.5, 5.5])]
    monkeypatch.setattr(scallop_passes, "AMPLE", np.inf)
    found.append(gaps_of(copy, metric, copy.mesh.vertex[:, 0], [0.5, 1.5, 5.5]))
    np.testing.assert_array_equal(*found)
    assert found[0].any() and (half > 1.0 or not found[0].all())


# --------------------------------------------------------------------------------------------- the finer copy


def flat_metric(mesh, rows):
    frame = frames(mesh.vertex, mesh.face[rows])
    return as_tensor(frame, scallop_metric(frame, np.zeros((6, len(rows))), RADIUS, STEP))


def test_a_copy_covers_the_same_surface_with_sides_short_enough():
    mesh = sheet(np.array([0.0, 7.0, 20.0]), np.array([0.0, 1.0, 9.0]), lambda x, y: (x, y, 0.3 * x * y))
    rows = np.arange(len(mesh.face))
    copy = finer_copy(mesh, rows, flat_metric(mesh, rows), 1.5)
    assert copy.mesh.area.sum() == pytest.approx(mesh.area.sum())
    np.testing.assert_allclose(np.bincount(copy.parent, copy.mesh.area), mesh.area)
    side = copy.mesh.vertex[np.roll(copy.mesh.face, -1, axis=1)] - copy.mesh.vertex[copy.mesh.face]
    assert np.linalg.norm(side, axis=2).max() <= 1.5 * STEP * (1 + 1e-9)
    np.testing.assert_array_equal(copy.mesh.normal, mesh.normal[copy.parent])
    twice = np.cross(side[:, 0], side[:, 1])
    assert ((twice * copy.mesh.normal).sum(axis=1) > 0).all()


def test_a_copy_hangs_together_where_the_part_does():
    mesh = sheet(np.array([0.0, 7.0, 20.0]), np.array([0.0, 1.0, 9.0]), lambda x, y: (x, y, 0.3 * x * y))
    copy = finer_copy(mesh, np.arange(8), flat_metric(mesh, np.arange(8)), 1.5)
    border = copy.mesh.coedge_face[:, 1] < 0
    parents = mesh.coedge_face[copy.coedge[border], 1]
    assert (parents == -1).all() and not copy.component.any()
    inner = copy.coedge[~border]
    assert set(inner[inner >= 0]) == set(np.flatnonzero(mesh.coedge_face[:, 1] >= 0))
    long = np.linalg.norm(
        np.diff(copy.mesh.vertex[copy.mesh.coedge_vertex[border]], axis=1)[:, 0], axis=1
    ).sum()
    ends = mesh.vertex[mesh.coedge_vertex[mesh.coedge_face[:, 1] < 0]]
    assert long == pytest.approx(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())


def test_facets_that_only_touch_in_a_vertex_are_two_pieces():
    mesh = from_faces(
        np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1.0, 0]]),
        np.array([[0, 1, 2], [0, 3, 4]]),
    )
    copy = finer_copy(mesh, np.arange(2), flat_metric(mesh, np.arange(2)), 1.5)
    assert copy.component.max() == 1 and not set(copy.mesh.face[copy.parent == 0].ravel()) & set(
        copy.mesh.face[copy.parent == 1].ravel()
    )
    both = join_copies(copy, take_facets(copy, mesh, np.arange(3)))
    assert both.component.max() >= 2 and len(both.mesh.face) == len(copy.mesh.face) + 3
    again = both.mesh.coedge_vertex[both.mesh.face_coedge]
    ends = np.stack([both.mesh.face, np.roll(both.mesh.face, -1, axis=1)], axis=2)
    np.testing.assert_array_equal(np.sort(again, axis=2), np.sort(ends, axis=2))


def test_facets_stay_joined_where_only_one_of_two_finds_their_side_too_long():
    """In the metric of the second facet, no side is too long, and the side that the first one halves is not
    its longest."""
    mesh = from_faces(
        np.array([[0, 0, 0], [4, 0, 0], [2, 3, 0], [2, -9.0, 0]]), np.array([[0, 1, 2], [0, 3, 1]])
    )
    tensor = np.zeros((6, 2))
    tensor[:3] = 1.0, 0.01
    copy = finer_copy(mesh, np.arange(2), tensor, 2.0)
    assert set(copy.coedge[copy.mesh.coedge_face[:, 1] < 0]) == set(
        np.flatnonzero(mesh.coedge_face[:, 1] < 0)
    )


def on_one_facet(*corners, **given):
    """Polylines (x, z) of a copy whose facets all have one parent, led back to it."""
    contact = both_paths(*(prism(corner) for corner in corners))
    mesh = from_faces(np.array([[0, 0, 0], [1, 0, 0], [0, 1.0, 0]]), np.array([[0, 1, 2]]))
    count = len(contact.point)
    return Copy(mesh, np.zeros(count, int), np.full(count, -1), np.zeros(3, int), **given).on_part(
        contact, mesh
    )


def test_on_the_part_a_pass_is_one_segment_only_as_far_as_it_is_straight():
    assert len(on_one_facet([(0, 0), (5, 0.09), (10, 0)], bend=0.1).point) == 2
    assert len(on_one_facet([(0, 0), (5, 0.2), (10, 0)], bend=0.1).point) == 4


def test_two_polylines_in_line_within_a_facet_stay_two():
    result = on_one_facet([(0, 0), (5, 0)], [(7, 0), (12, 0)], bend=0.1)
    assert result.point[:, 0].tolist() == [0.0, 5.0, 7.0, 12.0] and result.polyline.tolist() == [0, 0, 1, 1]


def test_what_is_shorter_than_a_pass_may_be_is_left_out():
    result = on_one_facet([(0, 0), (0.9, 0)], [(7, 0), (8.1, 0)], short=1.0)
    assert result.point[:, 0].tolist() == [7.0, 8.1] and result.polyline.tolist() == [0, 0]
