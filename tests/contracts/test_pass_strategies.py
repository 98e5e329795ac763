# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every pass strategy promises: a finite field, ascending levels, passes on the region only, no place
higher than the scallop, and passes that turn with the part; and that what cannot be used is refused before
any long work."""

import itertools
import json
import math
from functools import lru_cache

import numpy as np
import pytest
from scipy.spatial import cKDTree

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces, write_stl
from freecad_fiveaxis.core.passes import (
    PASS_STRATEGIES,
    Division,
    PassOptions,
    Region,
    cut,
    facets_under_axes,
    find_pass_strategy,
    flat_interval,
    lay_by_slope,
    refine,
    scallop_passes,
    slice_field,
    slice_mesh,
)
from freecad_fiveaxis.core.passes.scallop_passes import AIM
from freecad_fiveaxis.core.passes.spirals import take_lines
from freecad_fiveaxis.core.pipeline import job, mill_context
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.coedge import close_gaps

RADIUS, SCALLOP = 3.0, 0.03
STEP = flat_interval(RADIUS, SCALLOP)
OPTIONS = PassOptions(scallop=SCALLOP)


def turned(angle):
    return np.array(
        [[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1.0]]
    )


def grid(point):
    """Two facets for each square of points (n, m, 3)."""
    row = np.arange(point.shape[0] * point.shape[1]).reshape(point.shape[:2])
    a, b, c, d = (part.ravel() for part in (row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]))
    return from_faces(
        point.reshape(-1, 3), np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    )


@lru_cache
def slope(turn=0.0):
    """A wavy slope, 26 x 18 mm, steep enough for level planes and of no regular pattern; turned about Z by
    ``turn`` rad."""
    x, y = np.meshgrid(np.linspace(-13, 13, 40), np.linspace(-9, 9, 28), indexing="ij")
    aside = np.random.default_rng(5).uniform(-0.08, 0.08, (2, *x.shape))
    x, y = x + aside[0], y + aside[1]
    z = 0.9 * x + 0.5 * y + 0.8 * np.sin(x / 5) * np.cos(y / 6)
    return grid(np.stack([x, y, z], axis=-1) @ turned(turn).T)


def ball(radius=6.0, rows=20, columns=30, centre=(0.0, 0.0, 0.0)):
    """A closed ball about the centre."""
    polar, turn = np.linspace(0, np.pi, rows + 1)[1:-1], 2 * np.pi * np.arange(columns) / columns
    ring = np.stack([np.outer(np.sin(polar), np.cos(turn)), np.outer(np.sin(polar), np.sin(turn))], axis=-1)
    upright = np.broadcast_to(np.cos(polar)[:, None, None], (rows - 1, columns, 1))
    vertex = np.concatenate([[[0, 0, 1], [0, 0, -1]], np.concatenate([ring, upright], axis=2).reshape(-1, 3)])
    row = 2 + np.arange((rows - 1) * columns).reshape(rows - 1, columns)
    after = np.roll(row, -1, axis=1)
    caps = [
        np.stack([np.full(columns, k), one, two], axis=1)
        for k, one, two in ((0, row[0], after[0]), (1, after[-1], row[-1]))
    ]
    a, b, c, d = (part.ravel() for part in (row[:-1], row[1:], after[1:], after[:-1]))
    face = np.concatenate([*caps, np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return from_faces(radius * vertex + np.asarray(centre), face)


def box(size):
    """A block from the origin, twelve facets."""
    corner = np.array(list(itertools.product((0.0, 1.0), repeat=3)))[:, ::-1] * np.asarray(size, float)
    face = [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5],
            [3, 7, 5]]  # fmt: skip
    return from_faces(corner, np.array(face))


def region(mesh, keep=None):
    return Region(mesh, np.ones(len(mesh.face), bool) if keep is None else keep, RADIUS, STEP)


def passes(strategy, mesh, keep=None, options=OPTIONS, order="zigzag"):
    where = region(mesh, keep)
    return cut(where, strategy.field(where, options), order)


def samples(mesh, rows, count=4000):
    """Points (count, 3) spread over facets by area."""
    random = np.random.default_rng(11)
    row = random.choice(rows, count, p=mesh.area[rows] / mesh.area[rows].sum())
    share = random.random((count, 2))
    share = np.where(share.sum(1, keepdims=True) > 1, 1 - share, share)
    a, b, c = mesh.vertex[mesh.face[row]].transpose(1, 0, 2)
    return a + share[:, :1] * (b - a) + share[:, 1:] * (c - a), row


def rest_heights(mesh, contact, point):
    """What (n,) mm a ball that follows the passes, gaps closed, leaves over points of the mesh."""
    path = close_gaps(contact, mesh, RADIUS, 0.002)
    start, end = path.centre[:-1], path.centre[1:]
    same = path.polyline[1:] == path.polyline[:-1]
    start, end = start[same], end[same]
    pieces = np.ceil(np.linalg.norm(end - start, axis=1) / 0.05).astype(int) + 1
    row = np.repeat(np.arange(len(start)), pieces)
    share = (np.arange(len(row)) - np.repeat(np.cumsum(pieces) - pieces, pieces)) / np.maximum(pieces - 1, 1)[
        row
    ]
    centre = start[row] + share[:, None] * (end - start)[row]
    return cKDTree(centre).query(point)[0] - RADIUS


@pytest.fixture(params=sorted(PASS_STRATEGIES))
def strategy(request):
    return PASS_STRATEGIES[request.param]


# --------------------------------------------------------------------------------------------- every strategy


def test_the_field_is_finite_and_its_levels_ascend(strategy):
    found = strategy.field(region(slope()), OPTIONS)
    carrier = slope() if found.surface is None else found.surface.mesh
    assert found.value.shape == (len(carrier.vertex),) and np.isfinite(found.value).all()
    assert len(found.levels) > 10 and (np.diff(found.levels) > 0).all()
    assert found.levels[0] > found.value.min() and found.levels[-1] < found.value.max()


def test_passes_are_on_the_region_only(strategy):
    mesh = slope()
    keep = mesh.vertex[mesh.face, 0].mean(axis=1) > -2.0
    contact = passes(strategy, mesh, keep)
    rows = np.flatnonzero(np.repeat(keep, 1)[contact.face])
    assert len(rows) > 200
    point, corner = contact.point, mesh.vertex[mesh.face[contact.face]]
    np.testing.assert_allclose(contact.normal, mesh.normal[contact.face])
    assert np.abs(((point - corner[:, 0]) * contact.normal).sum(axis=1)).max() < 1e-9
    for k in range(3):  # inside the facet: to the left of each of its sides
        side = corner[:, (k + 1) % 3] - corner[:, k]
        assert (np.cross(side, point - corner[:, k]) * contact.normal).sum(axis=1).min() > -1e-7
    if (
        strategy.field(region(mesh, keep), OPTIONS).surface is not None
    ):  # the others pass over what is not cut
        assert keep[contact.face].all()


def test_points_with_a_coedge_lie_on_it(strategy):
    mesh = slope()
    contact = passes(strategy, mesh)
    rows = np.flatnonzero(contact.coedge >= 0)
    assert len(rows) > 0.5 * len(contact.coedge)
    start, end = mesh.vertex[mesh.coedge_vertex[contact.coedge[rows]]].transpose(1, 0, 2)
    off = np.cross(contact.point[rows] - start, end - start)
    assert np.linalg.norm(off, axis=1).max() < 1e-7
    assert (mesh.coedge_face[contact.coedge[rows]] == contact.face[rows][:, None]).any(axis=1).all()


def test_polylines_are_runs_of_segments_that_meet(strategy):
    contact = passes(strategy, slope(), order="one_way")
    goes_on = contact.polyline[2::2] == contact.polyline[1:-1:2]
    assert goes_on.any()
    np.testing.assert_array_equal(contact.point[2::2][goes_on], contact.point[1:-1:2][goes_on])
    assert (np.diff(contact.pass_) >= 0).all() and (np.diff(contact.polyline) >= 0).all()


@pytest.mark.thorough
def test_no_place_inside_the_region_is_higher_than_the_scallop(strategy):
    mesh = slope()
    point, _ = samples(mesh, np.arange(len(mesh.face)))
    inside = (np.abs(point[:, 0]) < 12.0) & (np.abs(point[:, 1]) < 8.0)
    below = PassOptions(
        scallop=SCALLOP, axis=(1.0, 0.0, 0.0), centre=(0.0, 0.0, -60.0)
    )  # all of the slope faces away from that
    given = below if strategy is PASS_STRATEGIES["rotary"] else OPTIONS
    stays = rest_heights(mesh, passes(strategy, mesh, options=given), point[inside])
    assert (
        np.quantile(stays, 0.98) <= 1.02 * SCALLOP and stays.max() <= 2.2 * SCALLOP
    )  # twice, where fronts meet
    assert stays.max() > 0.3 * SCALLOP
    assert stays.min() > -0.01  # facets are chords of the slope, the ball stands on both


def test_wider_passes_would_be_noticed(strategy):
    mesh = slope()
    point, _ = samples(mesh, np.arange(len(mesh.face)))
    inside = (np.abs(point[:, 0]) < 12.0) & (np.abs(point[:, 1]) < 8.0)
    wide = passes(strategy, mesh, options=PassOptions(scallop=2.0 * SCALLOP))
    assert rest_heights(mesh, wide, point[inside]).max() > 1.3 * SCALLOP


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["scallop", "zlevel"])
def test_spirals_leave_no_more_than_the_loops_that_they_stand_for(name):
    mesh, strategy = ball(), PASS_STRATEGIES[name]
    point, _ = samples(mesh, np.arange(len(mesh.face)))
    found = strategy.field(region(mesh), OPTIONS)
    loops, spiral = (cut(region(mesh), found, "zigzag", on) for on in (False, True))
    assert spiral.polyline.max() < 0.3 * loops.polyline.max()
    assert np.quantile(rest_heights(mesh, spiral, point), 0.98) <= 1.02 * SCALLOP
    assert rest_heights(mesh, spiral, point).max() <= 1.1 * rest_heights(mesh, loops, point).max()


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "most"), [("planes", 1.0), ("scallop", 3.5)]
)  # in corners where fronts meet
@pytest.mark.parametrize("degrees", [43.0, 46.0])
def test_divided_by_slope_no_place_is_higher_than_with_the_worse_of_both_alone(name, most, degrees):
    """The wavy slope leans by 42 to 49 deg. Without the level planes, the same comparison fails on the steep
    part."""
    mesh = slope()
    point, _ = samples(mesh, np.arange(len(mesh.face)))
    point = point[(np.abs(point[:, 0]) < 12.0) & (np.abs(point[:, 1]) < 8.0)]
    division = Division(math.radians(degrees), PASS_STRATEGIES["zlevel"], PASS_STRATEGIES[name], "zigzag")
    both, _ = lay_by_slope(region(mesh), OPTIONS, division)
    stays = rest_heights(mesh, both, point)
    worst = max(
        rest_heights(mesh, passes(PASS_STRATEGIES[one], mesh), point).max() for one in ("zlevel", name)
    )
    assert np.quantile(stays, 0.98) <= 1.02 * SCALLOP and stays.max() <= max(1.02 * worst, most * SCALLOP)
    level = np.array(
        [np.ptp(both.point[both.polyline == one, 2]) < 1e-6 for one in range(both.polyline.max() + 1)]
    )
    assert level.sum() > 20 and (~level).sum() > 5
    assert (
        rest_heights(mesh, take_lines(both, np.flatnonzero(~level[both.polyline])), point).max()
        > 5.0 * SCALLOP
    )


@pytest.mark.thorough
@pytest.mark.parametrize("turn", [0.7, 2.5])
def test_passes_turn_with_the_part(strategy, turn):
    here, there = (
        passes(strategy, slope(angle), options=PassOptions(angle, None, SCALLOP)) for angle in (0.0, turn)
    )
    length = [np.linalg.norm(one.point[1::2] - one.point[::2], axis=1).sum() for one in (here, there)]
    assert length[1] == pytest.approx(length[0], rel=1e-3)
    off = cKDTree(here.point @ turned(turn).T).query(there.point)[0]
    assert np.quantile(off, 0.99) < 0.02


def test_passes_that_stay_behind_would_be_noticed(strategy):
    here, there = (
        passes(strategy, slope(angle), options=PassOptions(angle, None, SCALLOP)) for angle in (0.0, 0.7)
    )
    assert np.quantile(cKDTree(here.point).query(there.point)[0], 0.99) > 0.02


def test_every_strategy_says_in_one_line_what_it_does(strategy):
    assert len(strategy.text) > 20 and "\n" not in strategy.text
    assert all(math.isfinite(angle) for angle in strategy.travels(OPTIONS))


def test_a_check_that_lets_pass_does_none_of_the_work_of_the_field(strategy):
    reported = []
    where = Region(
        slope(),
        np.ones(len(slope().face), bool),
        RADIUS,
        STEP,
        progress=lambda stage, share: reported.append(stage),
    )
    strategy.check(where, OPTIONS)
    assert not reported
    strategy.field(where, OPTIONS)
    assert reported


@pytest.mark.parametrize(
    "options",
    [PassOptions(scallop=RADIUS), PassOptions(stepover=1e-7), PassOptions(scallop=1e-12, least=1e-9)],
    ids=["scallop of the radius", "tiny stepover", "tiny scallop"],
)
def test_what_the_field_refuses_the_check_refuses_in_the_same_words(strategy, options):
    refused = []
    for ask in (strategy.check, strategy.field):
        with pytest.raises(SettingsError) as raised:
            ask(region(slope()), options)
        refused.append((str(raised.value), raised.value.value))
    assert refused[0] == refused[1]


# ------------------------------------------------------------------------------------------------ planes


def test_planes_of_an_upright_normal_are_those_of_their_direction():
    planes, mesh = find_pass_strategy("planes"), slope()
    normal = (-math.sin(0.4), math.cos(0.4), 0.0)
    one, two = (
        passes(planes, mesh, options=options)
        for options in (PassOptions(0.4, 1.0), PassOptions(0.0, 1.0, normal=normal))
    )
    np.testing.assert_allclose(two.point, one.point, atol=1e-9)
    np.testing.assert_array_equal(two.face, one.face)


@pytest.mark.parametrize("normal", [(0.3, -0.5, 0.9), (0.0, 2.0, -3.0)])
def test_passes_lie_in_planes_of_the_normal(normal):
    planes, across = find_pass_strategy("planes"), np.array(normal) / np.linalg.norm(normal)
    contact = passes(planes, slope(), options=PassOptions(0.0, 1.0, normal=normal))
    offset = contact.point @ across
    assert (
        np.ptp(
            np.bincount(contact.pass_, offset) / np.bincount(contact.pass_)
            - offset[np.searchsorted(contact.pass_, np.arange(contact.pass_.max() + 1))]
        )
        < 1e-9
    )
    steps = np.diff(np.unique(offset.round(6)))
    np.testing.assert_allclose(steps, 1.0, atol=1e-5)


def test_level_planes_are_level():
    contact = passes(find_pass_strategy("zlevel"), slope(), options=PassOptions(0.0, 0.8))
    assert np.ptp(contact.point[::2, 2] - contact.point[1::2, 2]) < 1e-9


def test_a_field_of_offsets_cuts_what_planes_cut():
    mesh, levels = slope(), np.linspace(-6, 6, 9)
    one, two = slice_mesh(mesh, levels, 0.0), slice_field(mesh, mesh.vertex[:, 1].copy(), levels)
    np.testing.assert_array_equal(one.face, two.face)
    np.testing.assert_allclose(one.point, two.point, atol=1e-12)


def test_a_normal_without_direction_is_refused():
    with pytest.raises(SettingsError, match="0,0,0 has no direction"):
        passes(find_pass_strategy("planes"), slope(), options=PassOptions(0.0, 1.0, normal=(0.0, 0.0, 0.0)))


def test_a_field_that_is_no_number_is_refused():
    with pytest.raises(SettingsError, match="field of the passes"):
        slice_field(slope(), np.full(len(slope().vertex), np.nan), [0.0])


# ------------------------------------------------------------------------------------------- constant scallop

CONSTANT = PASS_STRATEGIES["scallop"]
FLAT_STEP = flat_interval(RADIUS, AIM * SCALLOP)


def with_source(source):
    return PassOptions(scallop=SCALLOP, source=source)


def field_of(mesh, keep=None, options=OPTIONS):
    return CONSTANT.field(region(mesh, keep), options)


def highest(mesh, keep=None, options=OPTIONS, count=4000):
    """The height that stays on the region, hardly more anywhere: 0.99 of all; nowhere more than what counts
    as a gap."""
    rows = np.arange(len(mesh.face)) if keep is None else np.flatnonzero(keep)
    stays = rest_heights(mesh, passes(CONSTANT, mesh, keep, options), samples(mesh, rows, count)[0])
    assert np.quantile(stays, 0.999) < 2.5 * SCALLOP
    return np.quantile(stays, 0.99)


def plate():
    """A level plate, 20 x 16 mm, about the origin."""
    x, y = np.meshgrid(np.linspace(-10, 10, 41), np.linspace(-8, 8, 33), indexing="ij")
    return grid(np.stack([x, y, 0 * x], axis=-1))


def test_a_closed_surface_begins_at_its_lowest_place_and_is_covered():
    mesh = ball()
    found = field_of(mesh)
    main = np.flatnonzero(found.surface.component == 0)
    assert found.surface.mesh.vertex[main[found.value[main].argmin()]] == pytest.approx([0, 0, -6])
    way = math.pi * 6.0 * math.sqrt(1.0 + RADIUS / 6.0) / FLAT_STEP  # in the metric round a ball
    assert found.value[main].max() == pytest.approx(way, rel=0.03)
    assert highest(mesh) < 1.25 * SCALLOP


def test_pieces_have_sources_of_their_own_and_follow_one_another():
    one, two = ball(4.0, 50, 72), ball(2.5, 32, 48, centre=(20.0, 0.0, 0.0))
    both = from_faces(
        np.concatenate([one.vertex, two.vertex]), np.concatenate([one.face, two.face + len(one.vertex)])
    )
    found = field_of(both)
    piece = [found.value[found.surface.component == number] for number in (0, 1)]
    assert min(len(np.unique(np.floor(part))) for part in piece) > 8 and piece[0].max() < piece[1].min() + 1.0
    assert highest(both) < 1.25 * SCALLOP


def test_facets_far_longer_than_the_step_are_cut_as_any_others():
    mesh = box((30.0, 20.0, 8.0))
    top = mesh.normal[:, 2] > 0.5
    found = field_of(mesh, top)
    main = found.surface.component == 0
    x, y = found.surface.mesh.vertex[main, :2].T
    rim = np.min([x, 30.0 - x, y, 20.0 - y], axis=0) / FLAT_STEP
    assert np.abs(found.value[main] - rim).max() < 0.5
    contact = passes(CONSTANT, mesh, top)
    assert set(contact.face) == set(np.flatnonzero(top))
    assert (
        len(contact.face) < 4000
    )  # straight inside a facet: hardly more segments than the passes have corners
    assert highest(mesh, top) < 1.2 * SCALLOP


def test_the_part_itself_is_not_refined():
    mesh = box((30.0, 20.0, 8.0))
    before = mesh.vertex.copy(), mesh.face.copy()
    passes(CONSTANT, mesh, mesh.normal[:, 2] > 0.5)
    np.testing.assert_array_equal(mesh.vertex, before[0])
    np.testing.assert_array_equal(mesh.face, before[1])


def test_slivers_carry_the_field_too():
    """A plate of strips down to a fiftieth of a millimetre wide, in facets as long as the plate."""
    x = np.concatenate([np.linspace(0, 6, 13), np.linspace(6.02, 6.5, 25), np.linspace(7, 12, 11)])
    x, y = np.meshgrid(x, np.array([0.0, 15.0]), indexing="ij")
    mesh = grid(np.stack([x, y, 0 * x], axis=-1))
    contact = passes(CONSTANT, mesh)
    length = np.linalg.norm(contact.point[1::2] - contact.point[::2], axis=1).sum()
    even = grid(
        np.stack(
            [*np.meshgrid(np.linspace(0, 12, 25), np.linspace(0, 15, 31), indexing="ij"), np.zeros((25, 31))],
            axis=-1,
        )
    )
    same = passes(CONSTANT, even)
    assert length < 1.1 * np.linalg.norm(same.point[1::2] - same.point[::2], axis=1).sum()
    assert highest(mesh) < 1.3 * SCALLOP


@pytest.mark.parametrize("width", [0.05, 0.3, 0.5, 0.8, 1.1, 1.6])
def test_a_strip_narrower_than_the_steps_is_cut(width):
    """From both borders at once: what lies between the last passes is a gap, whatever the width."""
    x, y = np.meshgrid(np.linspace(0, 20, 25), np.linspace(0, width * FLAT_STEP, 3), indexing="ij")
    assert highest(grid(np.stack([x, y, 0 * x], axis=-1))) < 1.25 * SCALLOP


def rib(length, width, turn=0.0):
    """A strip of two rows of vertices, all of them on its border."""
    x, y = np.meshgrid(
        np.linspace(0, length, int(length / 0.6) + 1), [-0.5 * width, 0.5 * width], indexing="ij"
    )
    return grid(np.stack([x, y, 0 * x], axis=-1) @ turned(turn).T)


@pytest.mark.parametrize("width", [0.01, 0.3, 0.9, 1.2])
@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_a_strip_whose_vertices_all_lie_on_the_border_gets_its_pass(width, turn):
    mesh = rib(20.0, width * FLAT_STEP, turn)
    assert (np.bincount(mesh.coedge_vertex[mesh.coedge_face[:, 1] < 0].ravel()) == 2).all()
    x, y, _ = (passes(CONSTANT, mesh).point @ turned(turn)).T
    assert np.ptp(x) > 20.0 - 2.0 * FLAT_STEP and np.median(np.abs(y)) < 0.3 * width * FLAT_STEP
    assert highest(mesh) < 1.25 * SCALLOP


def test_a_strip_without_vertices_inside_would_get_none(monkeypatch):
    monkeypatch.setattr(
        refine, "_split_across", lambda vertex, face, label: (vertex, face, label, np.arange(len(face)))
    )
    assert not len(passes(CONSTANT, rib(20.0, 0.9 * FLAT_STEP)).point)


def test_a_strip_that_leads_from_plate_to_plate_gets_its_pass_too():
    mesh = plate()
    middle = mesh.vertex[mesh.face].mean(axis=1)
    keep = (np.abs(middle[:, 0]) > 5.0) | ((middle[:, 1] > 0.0) & (middle[:, 1] < 0.5))
    x = passes(CONSTANT, mesh, keep).point[:, 0]
    assert np.histogram(x, np.linspace(-5, 5, 11))[0].all()
    assert highest(mesh, keep) < 1.25 * SCALLOP


def test_a_facet_alone_is_cut():
    mesh = from_faces([[0, 0, 0], [3, 0, 0], [0, 2, 0]], [[0, 1, 2]])
    assert len(passes(CONSTANT, mesh).point) and highest(mesh) < 1.6 * SCALLOP


def fan(slivers):
    """A flat cone of slivers that meet at its tip."""
    turn, row = np.linspace(0, 2 * np.pi, slivers, endpoint=False), np.arange(slivers)
    rim = np.stack([6 * np.cos(turn), 6 * np.sin(turn), 0 * turn], axis=1)
    return from_faces(
        np.concatenate([[[0, 0, 0.5]], rim]), np.stack([0 * row, 1 + row, 1 + (row + 1) % slivers], axis=1)
    )


def test_samples_of_passes_do_not_grow_with_the_slivers_at_a_tip(monkeypatch):
    """Each place near the tip is as far from all of them, so that a search of the nearest looks at every
    one."""
    counts, thinned = [], scallop_passes._thin_points

    def counted(point, normal, step):
        result = thinned(point, normal, step)
        counts.append((len(point), len(result[0])))
        return result

    monkeypatch.setattr(scallop_passes, "_thin_points", counted)
    for slivers in (400, 1600):
        passes(CONSTANT, fan(slivers))
    (few, few_left), (many, many_left) = counts
    assert many > 3.0 * few and many_left < 2.5 * few_left


def test_a_fan_of_slivers_is_cut():
    assert highest(fan(400)) < 1.25 * SCALLOP


def test_passes_about_a_point_are_rings():
    options = with_source((1.0, 0.5, 0.0))
    contact = passes(CONSTANT, plate(), options=options)
    steps = np.linalg.norm(contact.point - (1.0, 0.5, 0.0), axis=1) / FLAT_STEP
    main = contact.pass_ < 10
    assert np.abs(steps[main] - 0.5 - contact.pass_[main]).max() < 0.6
    assert highest(plate(), options=options) < 1.25 * SCALLOP


def test_passes_along_a_curve_keep_their_distance_from_it(tmp_path):
    (tmp_path / "curve.csv").write_text("X,Y,Z\n-10,1,0\n 10,1,0\n")
    found = field_of(plate(), options=with_source(str(tmp_path / "curve.csv")))
    main = found.surface.component == 0
    known = np.abs(found.surface.mesh.vertex[main, 1] - 1.0) / FLAT_STEP
    np.testing.assert_allclose(found.value[main], known, atol=0.1)


def test_a_source_counts_as_off_the_surface_by_its_distance_from_the_facets():
    """In the middle of a facet twice as long as the ball is thick, far from its corners."""
    mesh, thick = box((30.0, 20.0, 8.0)), 2.0 * RADIUS
    top = mesh.normal[:, 2] > 0.5
    CONSTANT.check(region(mesh, top), with_source((16.0, 10.0, 8.0 + thick - 1e-6)))
    with pytest.raises(SettingsError, match=r"it is 6 mm off the surface"):
        CONSTANT.check(region(mesh, top), with_source((16.0, 10.0, 8.0 + thick + 1e-6)))
    with pytest.raises(SettingsError, match=r"it is 8 mm off the surface"):
        CONSTANT.check(region(mesh, top), with_source((16.0, 10.0, 0.0)))  # on a face that is not to be cut


def test_behind_an_edge_over_which_the_ball_rolls_as_much_is_cut():
    """A roof: a pass on one side does nothing for the other. Where edges were not looked at, four times as
    much would stay."""
    x, y = np.meshgrid(np.linspace(-5.13, 5.31, 30), np.linspace(0, 8, 25), indexing="ij")
    mesh = grid(np.stack([x, y, -np.abs(x - 0.1)], axis=-1))
    assert highest(mesh) < 1.6 * SCALLOP


@pytest.mark.parametrize(("widest", "spread"), [(None, 0.5), (1.0, 1.0)])
def test_in_a_hollow_what_is_no_ball_gets_the_step_of_a_flat(widest, spread):
    hollow = ball(6.0, 40, 60)
    hollow = from_faces(hollow.vertex, hollow.face[hollow.vertex[hollow.face, 2].max(axis=1) < 0.1, ::-1])
    found = CONSTANT.field(Region(hollow, np.ones(len(hollow.face), bool), RADIUS, STEP, widest), OPTIONS)
    way = 0.5 * math.pi * 6.0 * math.sqrt(spread) / FLAT_STEP
    assert found.value[found.surface.component == 0].max() == pytest.approx(way, rel=0.05)


def test_facets_that_no_pass_touches_are_reported():
    keep = np.ones(len(slope().face), bool)
    found = field_of(slope())
    near = slope().vertex[slope().face, 0].mean(axis=1) < 0.0
    assert not CONSTANT.report_untouched(region(slope(), keep), OPTIONS, found, np.flatnonzero(keep))
    (warning,) = CONSTANT.report_untouched(region(slope(), keep), OPTIONS, found, np.flatnonzero(near))
    assert warning.value == pytest.approx(slope().area[~near].sum(), rel=0.3)


def test_facets_between_two_passes_are_not_reported():
    fine = grid(
        np.stack(
            [*np.meshgrid(np.linspace(0, 9, 91), np.linspace(0, 9, 91), indexing="ij"), np.zeros((91, 91))],
            axis=-1,
        )
    )
    where = region(fine)
    found = CONSTANT.field(where, OPTIONS)
    contact = cut(where, found, "zigzag")
    assert len(np.unique(contact.face)) < 0.8 * len(fine.face)
    assert not CONSTANT.report_untouched(where, OPTIONS, found, contact.face)


def test_level_planes_say_what_they_leave():
    mesh = box((30.0, 20.0, 8.0))
    keep = mesh.normal[:, 2] > -0.5
    level = PASS_STRATEGIES["zlevel"]
    found = level.field(region(mesh, keep), OPTIONS)
    contact = cut(region(mesh, keep), found, "zigzag")
    (warning,) = [
        one
        for one in level.report_untouched(region(mesh, keep), OPTIONS, found, contact.face)
        if one.unit == "mm2"
    ]
    assert warning.value == pytest.approx(600.0) and warning.code == "side-not-machined"


# ------------------------------------------------------------------------------------------------ bad input


@pytest.fixture
def stl(tmp_path):
    write_stl(slope(), tmp_path / "part.stl")
    return tmp_path


BAD = [
    (["--passes", "rings"], "unknown passes 'rings'"),
    (["--plane-normal", "0,0,0"], "0,0,0 has no direction"),
    (["--passes", "scallop", "--from", "edge"], "neither border nor X,Y,Z nor a file"),
    (["--passes", "scallop", "--from", "300,0,0"], "cannot begin at"),
    (["--passes", "scallop", "--from", "far.csv"], "cannot begin at"),
    (["--passes", "scallop", "--from", "words.csv"], "needs two points or more"),
    (["--passes", "scallop", "--from", "one.csv"], "needs two points or more"),
    (["--passes", "scallop", "--from", "none.csv"], "none.csv"),
    (["--passes", "scallop", "--from", "1,2"], "neither border nor X,Y,Z nor a file"),
    (["--passes", "scallop", "--scallop", "5", "--cutter", "ball:6"], "not below the cutter radius"),
    (["--passes", "scallop", "--stepover", "0.00001"], "give a larger stepover"),
    (["--passes", "scallop", "--stepover", "0.00001", "--cutter", "bull:10:2"], "give a larger stepover"),
    (["--passes", "planes", "--scallop", "5", "--cutter", "ball:6"], "not below the cutter radius"),
    (["--passes", "planes", "--stepover", "0.00001"], "give a larger stepover"),
    (["--passes", "zlevel", "--stepover", "0.00001"], "give a larger stepover"),
    (["--passes", "scallop", "--faces", "elsewhere.stl"], "elsewhere.stl"),
]


class Begun(Exception):
    """The field of axes was begun."""


@pytest.fixture
def no_axis_field(monkeypatch):
    def begin(*given):
        raise Begun

    monkeypatch.setattr(mill_context, "find_axis_field", begin)


@pytest.mark.parametrize("tool_axis", ["auto", "facet_mean"])
@pytest.mark.parametrize(("words", "message"), BAD)
def test_what_cannot_be_used_is_one_line_and_no_file(
    stl, no_axis_field, words, message, tool_axis, monkeypatch, capsys
):
    """And it is refused before the field of axes is computed, where the tool axis is auto."""
    monkeypatch.chdir(stl)
    (stl / "far.csv").write_text("0,0,0\n0,0,90\n")
    (stl / "words.csv").write_text("X,Y,Z\n1,two,3\n4,5,6\n")
    (stl / "one.csv").write_text("0,0,0\n")
    write_stl(ball(centre=(500.0, 0.0, 0.0)), stl / "elsewhere.stl")
    given = [
        "mill",
        "part.stl",
        "--machine",
        "trunnion_ac",
        "--tool-axis",
        tool_axis,
        "-o",
        "out.ngc",
        "--quiet",
    ]
    assert cli.main([*given, *words]) == 2
    reported = capsys.readouterr().err
    assert message in reported and reported.count("\n") == 1
    assert not (stl / "out.ngc").exists()


def test_what_can_be_used_comes_to_the_field_of_axes(stl, no_axis_field, monkeypatch):
    monkeypatch.chdir(stl)
    with pytest.raises(Begun):
        job.make(
            build_settings(
                "mill", "part.stl", {"machine": "trunnion_ac", "tool_axis": "auto", "passes": "scallop"}
            )
        )


def test_what_no_axis_leans_over_does_not_count():
    """The underside of a block, but for axes that may point up; its walls for axes a little off +Z as
    well."""
    up = box((30.0, 20.0, 8.0)).normal[:, 2]
    for most, counts in ((90.0, up > -0.5), (180.0, up > -2.0), (30.0, up > -0.5)):
        np.testing.assert_array_equal(facets_under_axes(box((30.0, 20.0, 8.0)), math.radians(most)), counts)


def test_the_options_are_those_of_job_files_too(stl, monkeypatch):
    monkeypatch.chdir("/")
    (stl / "curve.csv").write_text("-10,0,-9\n10,0,9\n")
    job = {"task": "mill", "source": "part.stl", "machine": "trunnion_ac", "passes": "scallop", "scallop": 0.2, "from": "curve.csv",
           "output": str(stl / "a.ngc"), "report": [str(stl / "a.json")], "gouge": "off", "tool_axis": "facet_mean"}  # fmt: skip
    (stl / "job.json").write_text(json.dumps(job))
    assert cli.main(["run", str(stl / "job.json"), "--quiet"]) in (0, 1)
    inputs = json.loads((stl / "a.json").read_text())["inputs"]
    assert (inputs["passes"], inputs["plane_normal"]) == ("scallop", None) and inputs["from"].endswith(
        "curve.csv"
    )
