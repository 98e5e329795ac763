# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes kept within a boundary: against closed forms, against the passes that are not cut, and what is
refused."""

import itertools
import json
import math
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest
from gouge_examples import step
from mesh_shapes import box, field, sphere
from plain import PLAIN_WORDS, build_settings
from scipy.spatial import cKDTree

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.passes import slice_mesh
from freecad_fiveaxis.core.passes.boundary import facets_within, read_boundary
from freecad_fiveaxis.core.passes.plane_curves import PlaneCurves
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.studies import reach_map
from freecad_fiveaxis.core.toolpath.cl_path import Motion
from freecad_fiveaxis.core.toolpath.coedge import close_gaps
from freecad_fiveaxis.core.toolpath.cut_at_boundary import cut_at_boundary

PLATE = np.array([[[0, 0, 0], [40, 0, 0], [40, 30, 0]], [[0, 0, 0], [40, 30, 0], [0, 30, 0]]], float)
JOB = {"machine": "trunnion_ac", "cutter": "ball:6", "stepover": 1}
RECTANGLE, ISLAND = ((5, 5), (35, 5), (35, 25), (5, 25)), ((15, 10), (25, 10), (25, 20), (15, 20))


def written(path, *curves):
    """The curves, (n, 2) or (n, 3) without the first point again, as a file."""
    full = [
        [(*point, 0.0)[:3] for point in (*curve, curve[0])]
        for curve in (np.asarray(one).tolist() for one in curves)
    ]
    path.write_text(
        "\n\n".join("\n".join(",".join(f"{x:.17g}" for x in point) for point in one) for one in full) + "\n"
    )
    return str(path)


def star(count=41, radius=8.0, deep=0.35, middle=(0.0, 0.0), turn=0.1):
    angle = turn + 2 * np.pi * np.arange(count) / count
    out = radius * (1 + deep * np.cos(5 * angle))
    return np.stack([middle[0] + out * np.cos(angle), middle[1] + out * np.sin(angle)], axis=1)


def wound(curves, point):
    """Whether points (n, 2) are inside, by the angle that each curve turns about them: another route than
    rays."""
    turns = np.zeros(len(point))
    for curve in curves:
        to = np.asarray(curve, float)[None] - point[:, None]
        z = to[..., 0] + 1j * to[..., 1]
        turns += np.abs(np.rint(np.angle(np.roll(z, -1, axis=1) / z).sum(axis=1) / (2 * np.pi)))
    return turns % 2 == 1


def off(curves, point):
    """The distance (n,) of points (n, 2) from the nearest edge."""
    least = np.full(len(point), np.inf)
    for curve in curves:
        a = np.asarray(curve, float)
        for one, two in zip(a, np.roll(a, -1, axis=0), strict=True):
            share = np.clip((point - one) @ (two - one) / ((two - one) @ (two - one)), 0, 1)
            least = np.minimum(least, np.hypot(*(point - one - share[:, None] * (two - one)).T))
    return least


def lasting(path):
    """Rows to which a polyline goes on."""
    return np.flatnonzero(np.diff(path.polyline, prepend=-1) == 0)


def length(path):
    end = lasting(path)
    return float(np.linalg.norm(path.point[end] - path.point[end - 1], axis=1).sum())


def dense(path, by="point", gap=0.02, fills=True):
    """Places along all moves of a path, at most so far apart; the contact jumps where a move closes a gap."""
    end, place = lasting(path), getattr(path, by)
    end = end if fills else end[~path.fill[end]]
    count = np.ceil(np.linalg.norm(place[end] - place[end - 1], axis=1) / gap).astype(int) + 1
    row = np.repeat(end, count)
    share = (np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)) / count[
        np.repeat(np.arange(len(end)), count)
    ]
    return np.concatenate([place[row - 1] + share[:, None] * (place[row] - place[row - 1]), place[end]])


@lru_cache
def hills():
    """The passes over a wavy field, 20 x 20 mm about the origin, aslant to its facets; ball of radius 1.5."""
    mesh = from_triangles(
        field(24, lambda x, y: 1.2 * np.sin(0.5 * x) * np.cos(0.4 * y), 20 / 24) - np.array([10.0, 10.0, 0.0])
    )
    return mesh, close_gaps(slice_mesh(mesh, np.linspace(-13, 13, 53), 0.4), mesh, 1.5, 0.01)


def compared(uncut, cut, curves, by="point"):
    """What lies inside of the uncut passes is on the cut ones, and nothing else is; ends lie on the boundary
    or are old ends."""
    where, wanted = dense(cut, by, fills=by != "point"), dense(uncut, by, fills=by != "point")
    seen = where[:, :2]
    assert (wound(curves, seen) | (off(curves, seen) < 1e-9)).all()
    inside = wound(curves, wanted[:, :2])
    assert inside.any() and not inside.all()
    assert cKDTree(where).query(wanted[inside])[0].max() < 0.021
    first = np.flatnonzero(np.diff(cut.polyline, prepend=-1))
    ends = np.concatenate([first, np.append(first[1:], len(cut.point)) - 1])
    old = cKDTree(getattr(uncut, by)).query(getattr(cut, by)[ends])[0] < 1e-12
    assert (off(curves, getattr(cut, by)[ends[~old]][:, :2]) < 1e-9 * 16).all() and (~old).sum() > 20


# --------------------------------------------------------------------------------------------- what is inside


def test_inside_is_what_the_winding_number_says_also_among_many_edges():
    curves = [star(900, 8.0), star(300, 3.0, middle=(0.5, 0.2)), star(7, 1.0, 0.0)]
    found = PlaneCurves.of([np.concatenate([one, one[:1]]) for one in curves])
    point = np.random.default_rng(3).uniform(-12, 12, (3000, 2))
    assert (found.inside(point) == wound(curves, point)).all()
    assert len(found.first) > 100  # more than a few slabs


def test_a_point_on_an_edge_or_a_corner_lies_inside():
    curves = [np.array([*one, one[0]], float) for one in (RECTANGLE, ISLAND)]
    found = PlaneCurves.of(curves)
    share = np.linspace(0, 1, 11)[:, None]
    on = np.concatenate([a + share * (b - a) for one in curves for a, b in itertools.pairwise(one)])
    assert found.inside(on).all()
    assert found.inside(on * [1, 1] + [1e-6, 1e-6]).sum() < len(on)


def test_crossings_of_random_pieces_are_those_of_every_edge_by_itself():
    curve = star(200)
    closed = np.concatenate([curve, curve[:1]])
    found, draw = PlaneCurves.of([closed]), np.random.default_rng(5)
    start, end = draw.uniform(-12, 12, (2, 100, 2))
    piece, share = found.crossings(start, end)
    for one in range(len(start)):
        own = []
        for a, b in itertools.pairwise(closed):
            s, u = np.linalg.solve(np.stack([end[one] - start[one], a - b], axis=1), a - start[one])
            own += [s] if 0 < s < 1 and 0 <= u <= 1 else []
        np.testing.assert_allclose(share[piece == one], sorted(own), atol=1e-10)


# --------------------------------------------------------------------------------------- flat, in closed form


def make_result(tmp_path, curves, triangles=PLATE, **more):
    part = tmp_path / "part.stl"
    write_stl(from_triangles(triangles), part)
    return job.make(
        build_settings("mill", str(part), {**JOB, "boundary": written(tmp_path / "b.csv", *curves), **more})
    )


def test_a_rectangle_with_an_island_keeps_the_length_of_its_passes(tmp_path):
    offset = make_result(tmp_path, (RECTANGLE, ISLAND)).offset
    assert length(offset) == pytest.approx(
        20 * 30 - 10 * 10, abs=1e-9
    )  # passes 1 mm apart, between whole millimetres
    assert offset.polyline[-1] + 1 == 20 + 10
    assert set(np.round(offset.point[:, 0], 9)) >= {5, 15, 25, 35} and offset.point[
        :, 0
    ].min() == pytest.approx(5, abs=1e-9)


def test_a_round_boundary_keeps_the_chords_of_its_polygon(tmp_path):
    turn = 2 * np.pi * (np.arange(72) + 0.3) / 72
    offset = make_result(
        tmp_path, [np.stack([20 + 11 * np.cos(turn), 15 + 11 * np.sin(turn)], axis=1)]
    ).offset
    chords = 0.0
    for y in np.unique(np.round(offset.point[:, 1], 9)):
        x = [20 + 11 * (math.cos(a) + (y - 15 - 11 * math.sin(a)) / (11 * (math.sin(b) - math.sin(a))) * (math.cos(b) - math.cos(a)))
             for a, b in zip(turn, np.roll(turn, -1), strict=True) if (15 + 11 * math.sin(a) > y) != (15 + 11 * math.sin(b) > y)]  # fmt: skip
        chords += max(x) - min(x)
    assert length(offset) == pytest.approx(chords, rel=1e-12) and chords == pytest.approx(
        np.pi * 121, rel=0.01
    )


def test_passes_that_run_along_the_boundary_stay_and_so_does_a_path_that_lies_inside(tmp_path):
    offset = make_result(tmp_path, [((5, 4.5), (35, 4.5), (35, 24.5), (5, 24.5))]).offset
    assert length(offset) == pytest.approx(21 * 30)
    whole = make_result(tmp_path, [((-5, -5), (50, -5), (50, 50), (-5, 50))])
    free = job.make(build_settings("mill", str(tmp_path / "part.stl"), JOB))
    assert whole.nc == free.nc and not [one for one in whole.findings if "boundary" in one.code]


def test_a_pass_that_only_touches_an_island_goes_on(tmp_path):
    offset = make_result(tmp_path, (RECTANGLE, ((20, 7.5), (22, 9), (20, 9), (18, 9)))).offset
    assert set(np.bincount(offset.polyline[np.isclose(offset.point[:, 1], 7.5)])) <= {
        0,
        3,
    }  # two ends and a co-edge
    assert offset.polyline[-1] + 1 == 20 + 1  # the island divides the pass at 8.5 alone


def test_facets_outside_are_left_out_and_their_area_is_reported(tmp_path):
    triangles = field(20, lambda x, y: 0 * x, 2.0)
    found = make_result(tmp_path, [((0, 0), (20, 0), (20, 12), (0, 12))], triangles)
    reported = next(one for one in found.findings if one.code == "outside-boundary")
    assert reported.value == pytest.approx(40 * 40 - 20 * 12) and found.mesh.area[
        found.keep
    ].sum() == pytest.approx(240)
    assert "lie outside boundary b.csv and are not machined" in reported.text
    mesh = found.mesh
    boundary = read_boundary(
        written(tmp_path / "c.csv", star(30, 9.0, middle=(20, 20))), "c", (0.0, 0.0, 1.0)
    )
    kept, _ = facets_within(boundary, mesh, None)
    share = np.stack(np.meshgrid(*[np.linspace(0.01, 0.97, 16)] * 2), axis=-1).reshape(-1, 2)
    share = share[share.sum(axis=1) < 0.995]
    a, b, c = mesh.vertex[mesh.face].transpose(1, 0, 2)[:, :, :2]
    place = a[:, None] + share[:, :1] * (b - a)[:, None] + share[:, 1:] * (c - a)[:, None]
    inside = wound([star(30, 9.0, middle=(20, 20))], place.reshape(-1, 2)).reshape(len(kept), -1)
    assert (
        not (inside.any(axis=1) & ~kept).any() and (kept & ~inside.any(axis=1)).sum() <= 3
    )  # slivers between the samples


# ----------------------------------------------------------------------------------- curved, by dense samples


CURVES = (star(), star(12, 2.0, 0.0, (0.5, 1.0)))


def boundary_of(tmp_path, curves=CURVES, axis=(0.0, 0.0, 1.0)):
    return read_boundary(written(tmp_path / "b.csv", *curves), "b.csv", axis)


@pytest.mark.parametrize("by", ["point", "centre"])
def test_what_lies_inside_stays_and_nothing_else(tmp_path, by):
    _, uncut = hills()
    cut, _ = cut_at_boundary(uncut, boundary_of(tmp_path), by == "centre")
    compared(uncut, cut, CURVES, by)


@pytest.mark.parametrize("by", ["point", "centre"])
def test_the_comparison_notices_a_boundary_that_is_a_little_off(tmp_path, by):
    _, uncut = hills()
    cut, _ = cut_at_boundary(uncut, boundary_of(tmp_path, [one + 0.002 for one in CURVES]), by == "centre")
    with pytest.raises(AssertionError):
        compared(uncut, cut, CURVES, by)
    lost = replace_rows(cut_at_boundary(uncut, boundary_of(tmp_path), by == "centre")[0])
    with pytest.raises(AssertionError):
        compared(uncut, lost, CURVES, by)


def replace_rows(path):
    """The path without its longest polyline."""
    from freecad_fiveaxis.core.toolpath.coedge import take_path_rows

    return take_path_rows(path, np.flatnonzero(path.polyline != np.bincount(path.polyline).argmax()))


def test_ends_of_a_cut_stand_as_the_ball_does_on_their_facet(tmp_path):
    mesh, uncut = hills()
    cut, _ = cut_at_boundary(uncut, boundary_of(tmp_path))
    on = np.flatnonzero(off(CURVES, cut.point[:, :2]) < 1e-9)
    assert len(on) > 60
    np.testing.assert_allclose(cut.centre[on], cut.point[on] + 1.5 * mesh.normal[cut.face[on]], atol=1e-9)
    corner = mesh.vertex[mesh.face[cut.face[on]]]
    assert np.abs(((cut.point[on] - corner[:, 0]) * mesh.normal[cut.face[on]]).sum(axis=1)).max() < 1e-9
    solid = np.flatnonzero(~uncut.fill & (np.diff(uncut.polyline, prepend=-1) == 0))
    end = solid[np.searchsorted(uncut.segment[solid], cut.segment[on])]
    assert (uncut.segment[end] == cut.segment[on]).all() and (cut.before[on] == cut.after[on]).all()
    mean = uncut.before + uncut.after
    mean /= np.linalg.norm(mean, axis=1)[:, None]
    share = (np.linalg.norm(cut.point[on] - uncut.point[end - 1], axis=1)
             / np.linalg.norm(uncut.point[end] - uncut.point[end - 1], axis=1))[:, None]  # fmt: skip
    even = (1 - share) * mean[end - 1] + share * mean[end]  # so that no axis turns at once
    np.testing.assert_allclose(cut.before[on], even / np.linalg.norm(even, axis=1)[:, None], atol=2e-4)


def test_rows_beside_a_wall_are_still_known_where_others_are_gone(tmp_path):
    mesh = from_triangles(np.asarray(step().vertex)[np.asarray(step().face)])
    floor = (np.abs(mesh.vertex[mesh.face][..., 2]).max(axis=1) == 0.0) & (mesh.normal[:, 2] > 0.9)
    uncut = close_gaps(
        slice_mesh(mesh, np.arange(-15, 15.5, 1.0), np.pi / 2, plain=~floor), mesh, 4.0, 0.01, floor
    )
    assert len(uncut.beside) > 20
    curve = ((-10.5, -25), (12.5, -25), (12.5, 5), (-10.5, 5))
    cut, _ = cut_at_boundary(uncut, boundary_of(tmp_path, [curve]))
    kept = wound([curve], uncut.point[uncut.beside, :2])
    assert 0 < kept.sum() < len(kept)
    np.testing.assert_array_equal(cut.point[cut.beside], uncut.point[uncut.beside[kept]])
    np.testing.assert_array_equal(cut.wall, uncut.wall[kept])


def rotation():
    one, _ = np.linalg.qr(np.random.default_rng(11).normal(size=(3, 3)))
    return one * np.sign(np.linalg.det(one))


@pytest.mark.parametrize("scale", [1e-2, 1.0, 1e3])
@pytest.mark.parametrize("by", [False, True])
def test_turned_shifted_and_scaled_the_cut_is_the_same(tmp_path, scale, by):
    _, uncut = hills()
    cut, _ = cut_at_boundary(uncut, boundary_of(tmp_path), by)
    turn, shift = rotation(), np.array([310.0, -45.0, 77.0])
    normals = {name: getattr(uncut, name) @ turn.T for name in ("normal", "before", "after")}
    places = {name: scale * (getattr(uncut, name) @ turn.T + shift) for name in ("point", "centre")}
    curves = [scale * (np.column_stack([one, np.full(len(one), 4.0)]) @ turn.T + shift) for one in CURVES]
    axis = tuple((turn @ [0.0, 0.0, 1.0]).tolist())
    other, _ = cut_at_boundary(replace(uncut, **normals, **places), boundary_of(tmp_path, curves, axis), by)
    assert len(other.point) == len(cut.point) and (other.polyline == cut.polyline).all()
    for name in ("point", "centre"):
        np.testing.assert_allclose(
            getattr(other, name), scale * (getattr(cut, name) @ turn.T + shift), atol=1e-9 * scale * 400
        )


def test_by_the_centre_the_contact_on_a_ball_lies_nearer_to_its_axis(tmp_path):
    """Over a ball of radius S the centre of one of radius r is (S + r) / S times as far from the axis as the
    contact."""
    big, small, far = 10.0, 4.0, 7.0
    mesh = from_triangles(sphere(big, 90, 180))
    uncut = close_gaps(
        slice_mesh(mesh, np.linspace(-6, 6, 25), 0.0, mesh.normal[:, 2] > 0.1), mesh, small, 0.01
    )
    turn = 2 * np.pi * np.arange(360) / 360
    circle = far * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    ends = {}
    for by in (False, True):
        cut, _ = cut_at_boundary(uncut, boundary_of(tmp_path, [circle]), by)
        first = np.flatnonzero(np.diff(cut.polyline, prepend=-1))
        row = np.concatenate([first, np.append(first[1:], len(cut.point)) - 1])
        assert off([circle], (cut.centre if by else cut.point)[row, :2]).max() < 1e-8
        ends[by] = np.hypot(*cut.point[row, :2].T)
    np.testing.assert_allclose(ends[False], far, rtol=1e-3)
    np.testing.assert_allclose(ends[True], far * big / (big + small), rtol=8e-3)  # the ball stands on facets


def test_closed_passes_stay_closed_or_become_one_piece_over_the_seam(tmp_path):
    mesh = from_triangles(sphere(10.0, 24, 36))
    part = tmp_path / "ball.stl"
    write_stl(mesh, part)
    options = {**JOB, "stepover": 1.5, "plane_normal": "0,0,1"}
    free = job.make(build_settings("mill", str(part), options))
    rings = free.offset.polyline[-1] + 1

    def closed(offset):
        first = np.flatnonzero(np.diff(offset.polyline, prepend=-1))
        last = np.append(first[1:], len(offset.point)) - 1
        return np.abs(offset.centre[first] - offset.centre[last]).max(axis=1) < 1e-9

    assert closed(free.offset).all() and rings > 4
    around = written(tmp_path / "all.csv", ((-20, -20), (20, -20), (20, 20), (-20, 20)))
    whole = job.make(build_settings("mill", str(part), {**options, "boundary": around}))
    assert closed(whole.offset).all() and whole.nc == free.nc
    for sign in (-1, 1):  # the seam lies on one side or the other
        side = written(tmp_path / "half.csv", ((0, -20), (20 * sign, -20), (20 * sign, 20), (0, 20)))
        half = job.make(build_settings("mill", str(part), {**options, "boundary": side}))
        assert half.offset.polyline[-1] + 1 == rings and not closed(half.offset).any()
        assert length(half.offset) == pytest.approx(0.5 * length(free.offset), rel=1e-3)
        assert (sign * half.offset.point[:, 0]).min() > -1e-9
        cut, _ = cut_at_boundary(
            free.offset, read_boundary(side, "half.csv", (0.0, 0.0, 1.0))
        )  # no facet left out before
        assert cut.polyline[-1] + 1 == rings and length(cut) == pytest.approx(length(half.offset), rel=1e-12)


# ------------------------------------------------------------------------------------------------ in the job


def test_a_wall_beyond_the_boundary_still_keeps_the_ball_off(tmp_path):
    """The wall stands at y = 0; the boundary ends before it, nearer than the ball's radius."""
    write_stl(step(), tmp_path / "part.stl")
    options = {**JOB, "cutter": "ball:8", "direction": 90, "max_axis_angle": 30}
    curve = written(tmp_path / "b.csv", ((-15, -25), (15, -25), (15, -1), (-15, -1)))
    offset = job.make(
        build_settings("mill", str(tmp_path / "part.stl"), {**options, "boundary": curve})
    ).offset
    assert offset.point[:, 1].max() == pytest.approx(-4, abs=1e-6) and offset.centre[:, 1].max() <= -4 + 1e-9


def test_what_the_part_stands_on_stays_out_with_free_axes(tmp_path):
    write_stl(from_triangles(box((0, 0, 10), (30, 20, 20))), tmp_path / "part.stl")
    curve = written(tmp_path / "b.csv", ((5, 5), (20, 5), (20, 15), (5, 15)))
    found = job.make(build_settings("mill", str(tmp_path / "part.stl"), {
        "machine": "trunnion_ac", "cutter": "ball:6", "scallop": 0.1, "passes": "scallop", "tool_axis": "auto", "boundary": curve,
    }))  # fmt: skip
    assert found.mesh.area[found.keep].sum() == pytest.approx(600) and (found.offset.point[:, 2] == 20).all()
    assert found.offset.point[:, :2].min(axis=0) == pytest.approx([5, 5], abs=1.0)
    assert wound(
        [((5, 5), (20, 5), (20, 15), (5, 15))], found.offset.point[:, :2] * (1 - 1e-9) + 1e-9 * 10
    ).all()


@pytest.mark.parametrize("cutter", ["flat:6", "bull:6:1", "ball:6"])
def test_by_the_centre_the_hub_of_every_cutter_stays_inside(tmp_path, cutter):
    found = make_result(tmp_path, (RECTANGLE, ISLAND), cutter=cutter, boundary_by="centre", lead=5)
    cuts = found.path.motion == 0
    hub = found.path.tip[cuts][:, :2] + found.settings.cutter.cutter.corner * found.path.axis[cuts][:, :2]
    assert (wound((RECTANGLE, ISLAND), hub) | (off((RECTANGLE, ISLAND), hub) < 1e-6)).all()
    assert hub[:, 0].min() == pytest.approx(5, abs=1e-6) and hub[:, 0].max() == pytest.approx(35, abs=1e-6)


def test_an_axis_other_than_z_and_faces_beside_it(tmp_path):
    write_stl(from_triangles(PLATE), tmp_path / "part.stl")
    curve = written(tmp_path / "b.csv", ((0, 10, -50), (0, 20, -50), (0, 20, 50), (0, 10, 50)))
    options = {**JOB, "boundary": curve, "boundary_axis": "2,0,0"}
    offset = job.make(build_settings("mill", str(tmp_path / "part.stl"), options)).offset
    assert length(offset) == pytest.approx(10 * 40)


@pytest.mark.oldest
@pytest.mark.thorough
@pytest.mark.parametrize("by", ["contact", "centre"])
def test_what_is_left_is_looked_for_within_the_boundary_alone(tmp_path, by):
    """The plate's two facets lie outside for the larger part; beside passes that end at the boundary no more
    stays than between."""
    found = job.run(with_rest(make_result(tmp_path, (RECTANGLE, ISLAND), boundary_by=by).settings))
    assert (
        found.rest.area.sum() == pytest.approx(30 * 20 - 10 * 10, rel=0.03) and found.rest.height.max() < 0.1
    )
    assert not [one for one in found.findings if one.code == "uncut"]
    whole = job.run(with_rest(replace(found.draft.settings, boundary=type(found.draft.settings.boundary)())))
    assert whole.rest.area.sum() == pytest.approx(40 * 30)


@pytest.mark.parametrize("by", ["contact", "centre"])
def test_links_over_an_island_that_is_narrower_than_the_cutter_are_lifted(tmp_path, by):
    curves = RECTANGLE, ((19, 10), (21, 10), (21, 20), (19, 20))
    path = make_result(tmp_path, curves, boundary_by=by, order="one_way").path
    end = np.flatnonzero(path.motion != Motion.RAPID)[1:]
    share = np.linspace(0, 1, 21)[:, None, None]
    way = (path.tip[end - 1] + share * (path.tip[end] - path.tip[end - 1])).reshape(-1, 3)
    low = way[way[:, 2] < 0.5]
    assert len(low) > 1000 and (wound(curves, low[:, :2]) | (off(curves, low[:, :2]) < 1e-6)).all()


def with_rest(settings):
    return replace(settings, gouge=replace(settings.gouge, rest="on"))


# -------------------------------------------------------------------------------------------- what is refused


BAD = [
    (
        "0,0,0\n10,0,0\n10,10,0\n",
        "is not closed: its ends are 14.14 mm apart; repeat the first point at the end",
    ),
    ("0,0,0\n10,0,0\n0,0,0\n", "has 2 points; give three or more"),
    ("0,0,0\n10,0,0\n", "has 2 points; give three or more"),
    ("0,0,0\n10,10,0\n10,0,0\n0,10,0\n0,0,0\n", "crosses itself at (5, 5, 0) mm"),
    (
        "0,0,0\n20,0,0\n20,20,0\n0,20,0\n0,0,0\n\n10,10,0\n30,10,0\n30,30,0\n10,30,0\n10,10,0\n",
        "crosses itself",
    ),
    (
        "100,0,0\n120,0,0\n120,20,0\n100,0,0\n",
        "no part of the surface that is to be machined lies inside boundary b.csv",
    ),
    ("1,1,0\n1,9,0\n1,9,9\n1,1,0\n", "has no area when it is seen along 0,0,1; give another --boundary-axis"),
    ("1,1,0\n1,1,0\n1,1,0\n1,1,0\n", "has no area"),
    ("once upon a time\nthere was\n", "X,Y,Z in mm on a line each"),
    ("0,0,0\n10,zero,0\n10,10,0\n0,0,0\n", "X,Y,Z in mm on a line each"),
    ("0,0,0\n10,nan,0\n10,10,0\n0,0,0\n", "X,Y,Z in mm on a line each"),
    ("0,0\n10,0\n10,10\n0,0\n", "X,Y,Z in mm on a line each"),
    ("0,0,0\n10,0\n10,10,0\n0,0,0\n", "X,Y,Z in mm on a line each"),
    ("", "X,Y,Z in mm on a line each"),
    ("x,y,z\n", "X,Y,Z in mm on a line each"),
    ("a\0b,1,2\n3,\0,5\n", "X,Y,Z in mm on a line each"),
    ("1,2,3\n" * 20_001, "at most 20000 points"),
    ("1" * 200_000 + ",2,3\n", "X,Y,Z in mm on a line each"),
    ("0,0,0\n1e9,0,0\n1e9,1e9,0\n0,0,0\n", "none beyond"),
]


@pytest.mark.parametrize(("text", "message"), BAD, ids=range(len(BAD)))
def test_what_is_no_boundary_is_refused_in_one_line(tmp_path, capsys, text, message):
    write_stl(from_triangles(PLATE), tmp_path / "part.stl")
    (tmp_path / "b.csv").write_bytes(text.encode())
    refused(tmp_path, capsys, message, "--boundary", str(tmp_path / "b.csv"))


def refused(tmp_path, capsys, message, *words):
    out = tmp_path / "out.ngc"
    common = [
        "--machine",
        "trunnion_ac",
        "--cutter",
        "ball:6",
        "--stepover",
        "2",
        *PLAIN_WORDS,
        "-o",
        str(out),
        "--quiet",
    ]
    assert main(["mill", str(tmp_path / "part.stl"), *common, *words]) == 2
    error = capsys.readouterr().err
    assert message in error and len(error.strip().splitlines()) == 1 and not out.exists()


def test_an_axis_without_direction_a_missing_file_and_a_word_are_refused(tmp_path, capsys):
    write_stl(from_triangles(PLATE), tmp_path / "part.stl")
    curve = ["--boundary", written(tmp_path / "b.csv", RECTANGLE)]
    refused(tmp_path, capsys, "boundary-axis 0,0,0 has no direction", *curve, "--boundary-axis", "0,0,0")
    refused(tmp_path, capsys, "none.csv does not exist; name the", "--boundary", str(tmp_path / "none.csv"))
    refused(tmp_path, capsys, "", "--boundary", str(tmp_path))
    with pytest.raises(SettingsError, match="boundary-by 'tip' is not one of contact, centre"):
        build_settings(
            "mill", "part.stl", {"machine": "trunnion_ac", "boundary": "b.csv", "boundary_by": "tip"}
        )


def test_names_of_columns_blank_lines_and_a_curve_that_is_closed_but_for_rounding_are_read(tmp_path):
    (tmp_path / "b.csv").write_text(
        "\n\nX,Y,Z\n0,0,0\n10,0,0\n10,10,0\n0.0005,0,0\n\n  \n\n2,1,0\n4,1,0\n4,2,0\n2,1,0\n\n"
    )
    found = read_boundary(str(tmp_path / "b.csv"), "b.csv", (0.0, 0.0, 1.0))
    assert (
        len(found.curves.start) == 6
        and (found.curves.start[:3] == np.roll(found.curves.end[:3], 1, axis=0)).all()
    )


def test_where_facets_reach_in_but_no_pass_does_it_is_refused(tmp_path):
    with pytest.raises(SettingsError, match="no part of the surface that is to be machined lies inside"):
        make_result(tmp_path, [((10.1, 10.6), (11, 10.6), (11, 10.9), (10.1, 10.9))], stepover=5)


# ------------------------------------------------------------------------------------------------ other tasks


@pytest.mark.oldest
@pytest.mark.thorough
def test_reach_setup_and_compare_keep_to_it_too(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(reach_map, "PLACES", 500)
    write_stl(from_triangles(field(10, lambda x, y: 0 * x, 4.0)), tmp_path / "part.stl")
    curve = ["--boundary", written(tmp_path / "b.csv", ((0, 0), (20, 0), (20, 12), (0, 12)))]
    part, report = str(tmp_path / "part.stl"), tmp_path / "r.json"
    common = ["--machine", "trunnion_ac", "--cutter", "ball:6", "--report", str(report), "--quiet"]
    assert main(["reach", part, *common, *curve]) == 0
    found = json.loads(report.read_text())
    assert sum(found["summary"]["by_reason"].values()) + found["summary"]["reachable_area"] == pytest.approx(
        240
    )
    assert [one["code"] for one in found["findings"] if "boundary" in one["code"]] == ["outside-boundary"]
    for task, machine in (("setup", "--machine"), ("compare", "--machines")):
        words = [
            task,
            part,
            machine,
            "trunnion_ac",
            "--cutter",
            "ball:6",
            "--stepover",
            "2",
            *PLAIN_WORDS,
            "--quiet",
        ]
        assert main([*words, *curve, "--boundary-by", "centre"]) in (0, 1)
        assert main([*words, "--boundary", str(tmp_path / "none.csv")]) == 2
        cl = tmp_path / "path.apt"
        cl.write_text("GOTO/0,0,0,0,0,1\nGOTO/9,0,0,0,0,1\n")
        assert main([task, str(cl), machine, "trunnion_ac", *curve, "--quiet"]) == 2
        assert "--boundary needs the part" in capsys.readouterr().err


@pytest.mark.thorough
def test_the_lines_in_place_of_the_file_give_the_same_program(tmp_path):
    """Guides and boundaries may be given as what their files would hold; the job file's folder then does not
    count."""
    stl = tmp_path / "plate.stl"
    write_stl(from_triangles(PLATE), stl)
    file = written(tmp_path / "outline.csv", RECTANGLE, ISLAND)
    lines = ";".join(Path(file).read_text().splitlines())
    assert lines.count(";;") == 1
    nc = [str(tmp_path / f"{name}.ngc") for name in "ab"]
    base = [
        "mill",
        str(stl),
        "--machine",
        "trunnion_ac",
        "--controller",
        "linuxcnc",
        "--cutter",
        "ball:6",
        "--stepover",
        "1",
    ]
    base += ["--passes", "scallop", "--spindle", "off", "--quiet", "--boundary"]
    guide = tmp_path / "guide.csv"
    guide.write_text("x,y,z\n5,5,0\n5,25,0\n")
    assert main([*base, file, "--from", str(guide), "-o", nc[0]]) == 0
    assert main([*base, lines, "--from", "5,5,0;5,25,0", "-o", nc[1]]) == 0
    one, other = (Path(path).read_text() for path in nc)
    assert one == other and one.count("\n") > 100
    job_ = tmp_path / "in" / "job.json"
    job_.parent.mkdir()
    given = {
        "task": "mill",
        "source": str(stl),
        "machine": "trunnion_ac",
        "controller": "linuxcnc",
        "cutter": "ball:6",
        "stepover": 1,
    }
    given |= {
        "passes": "scallop",
        "spindle": "off",
        "boundary": lines,
        "from": "5,5,0;5,25,0",
        "output": str(tmp_path / "c.ngc"),
    }
    job_.write_text(json.dumps(given))
    assert main(["run", str(job_), "--quiet"]) == 0
    assert (tmp_path / "c.ngc").read_text() == one


@pytest.mark.parametrize(
    ("option", "given", "reported"),
    [
        ("--boundary", "0,0,0;1,0,0;2,0", "boundary 0,0,0;1,0,0;2,0 holds no closed curves"),
        ("--boundary", "0,0;1,1;" * 30, "boundary " + ("0,0;1,1;" * 30)[:39] + "… holds no closed curves"),
        ("--boundary", "0,0,0;1,0,0;1,nan,0;0,1,0", "'1,nan,0' in curve 1 is no point; give X,Y,Z in mm"),
        ("--boundary", "0,0,0;9,0,0;9,9,0;;1,1,0;2000000,1,0", "'2000000,1,0' in curve 2 is no point"),
        ("--from", "1,2,3;x,y,z", "guide curve 1,2,3;x,y,z needs two points or more"),
        ("--from", "1,2,3;", "guide curve 1,2,3; needs two points or more"),
    ],
)
def test_lines_that_are_no_curve_are_refused(tmp_path, capsys, option, given, reported):
    stl = tmp_path / "plate.stl"
    write_stl(from_triangles(PLATE), stl)
    out = tmp_path / "x.ngc"
    given = [
        "--machine",
        "trunnion_ac",
        "--controller",
        "linuxcnc",
        "--cutter",
        "ball:6",
        "--spindle",
        "off",
        option,
        given,
    ]
    assert main(["mill", str(stl), "-o", str(out), *given]) == 2
    assert reported in capsys.readouterr().err and not out.exists()
