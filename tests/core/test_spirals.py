# SPDX-License-Identifier: LGPL-2.1-or-later
"""Spirals instead of closed passes round one another: by closed forms, and by dense samples of the surface
between the loops."""

import math
from dataclasses import fields, replace
from functools import lru_cache

import numpy as np
import pytest
from mesh_shapes import field as height_field
from mesh_shapes import sphere
from scipy.spatial import cKDTree
from uncured import UNCURED

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.passes import PASS_STRATEGIES, PassField, PassOptions, Region, bands, cut, spirals
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.cl_path import Motion

STEP = 1.0
OPTIONS = PassOptions(stepover=STEP)


def revolved(radius, height, columns=48):
    """What a polyline of ``radius`` and ``height`` makes about Z; what lies to its left is outside."""
    turn = 2 * math.pi * np.arange(columns) / columns
    radius, height = np.asarray(radius, float)[:, None], np.asarray(height, float)[:, None]
    row = np.stack([radius * np.cos(turn), radius * np.sin(turn), height + 0 * turn], axis=-1)
    a, b, c, d = row[:-1], np.roll(row, -1, axis=1)[:-1], np.roll(row, -1, axis=1)[1:], row[1:]
    corner = np.concatenate([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)]).reshape(-1, 3, 3)
    area = np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
    return from_triangles(corner[area > 1e-9])


def bumps(size, height):
    return from_triangles(height_field(size, height))


def tube():
    """The side of a cylinder, 10 mm in radius and 12.4 mm high."""
    return revolved([10.0, 10.0], [0.0, 12.4])


@lru_cache
def part(name):
    """A part and the facets to cut."""
    if name == "cylinder side":
        mesh = tube()
    elif name == "cone":
        mesh = revolved([12.0, 5.0], [0.0, 9.0])
    elif name == "bowl":
        polar = np.linspace(math.pi / 2, math.radians(15), 16)
        mesh = revolved(12 * np.sin(polar[::-1]), -12 * np.cos(polar[::-1]))
    else:
        polar = np.linspace(math.radians(150), math.radians(10), 24)
        mesh = revolved([3.0, *(8 * np.sin(polar))], [-14.0, *(8 * np.cos(polar))])
    return mesh


def plan_passes(mesh, strategy, options=OPTIONS, keep=None, order="zigzag"):
    """The passes with loops, and with spirals."""
    region = Region(mesh, np.ones(len(mesh.face), bool) if keep is None else keep, 3.0, STEP)
    found = PASS_STRATEGIES[strategy].field(region, options)
    return tuple(cut(region, found, order, spiral) for spiral in (False, True))


def lines(contact):
    """The points (2 s, 3) of each polyline."""
    return np.split(contact.point, np.flatnonzero(np.diff(contact.polyline)) + 1)


def is_closed(line):
    return bool((line[0] == line[-1]).all())


def dense(line, step=0.05):
    """Points of the segments of a polyline at most ``step`` mm apart."""
    start, end = line[::2], line[1::2]
    pieces = np.ceil(np.linalg.norm(end - start, axis=1) / step).astype(int) + 1
    row = np.repeat(np.arange(len(start)), pieces)
    share = (np.arange(len(row)) - np.repeat(np.cumsum(pieces) - pieces, pieces)) / np.maximum(pieces - 1, 1)[
        row
    ]
    return start[row] + share[:, None] * (end - start)[row]


def samples(mesh, count=20_000):
    """Points (count, 3) spread over the facets by area."""
    random = np.random.default_rng(3)
    row = random.choice(len(mesh.face), count, p=mesh.area / mesh.area.sum())
    share = random.random((count, 2))
    share = np.where(share.sum(1, keepdims=True) > 1, 1 - share, share)
    a, b, c = mesh.vertex[mesh.face[row]].transpose(1, 0, 2)
    return a + share[:, :1] * (b - a) + share[:, 1:] * (c - a)


def farthest(mesh, contact, low, high):
    """The farthest that a sample of the mesh from Z ``low`` to ``high`` is from all passes, mm."""
    point = samples(mesh)
    between = (point[:, 2] >= low) & (point[:, 2] <= high)
    return float(
        cKDTree(np.concatenate([dense(line) for line in lines(contact)])).query(point[between])[0].max()
    )


def same(one, two):
    return all(
        np.array_equal(getattr(one, f.name), getattr(two, f.name))
        for f in fields(one)
        if f.name != "findings"
    )


PARTS = [
    ("cylinder side", "zlevel"), ("cylinder side", "morph"), ("cone", "zlevel"), ("cone", "morph"), ("bowl", "zlevel"),
    ("bowl", "morph"), ("sphere on a stem", "zlevel"), ("sphere on a stem", "morph"),
]  # fmt: skip


@pytest.mark.thorough
@pytest.mark.parametrize(("name", "strategy"), PARTS)
def test_the_loops_of_a_region_become_one_pass_as_close_as_they_were(name, strategy):
    mesh = part(name)
    loops, spiral = plan_passes(mesh, strategy)
    assert len(lines(loops)) > 5 and all(map(is_closed, lines(loops)))
    assert len(lines(spiral)) == 1 and not is_closed(lines(spiral)[0])
    low, high = loops.point[:, 2].min(), loops.point[:, 2].max()
    assert farthest(mesh, spiral, low, high) <= 1.03 * farthest(mesh, loops, low, high) + 0.01
    assert spiral.point[:, 2].min() == pytest.approx(low, abs=1e-3)
    assert spiral.point[:, 2].max() == pytest.approx(high, abs=1e-3)


def test_constant_scallop_from_one_border_is_one_spiral_and_from_two_are_two():
    for mesh, count in ((revolved([9.0, 4.0, 0.0], [-5.0, 0.0, 0.0]), 1), (tube(), 2)):
        loops, spiral = plan_passes(mesh, "scallop")
        assert len(lines(loops)) > 6 and len(lines(spiral)) == count


def test_a_pass_that_is_too_coarse_would_be_noticed():
    mesh = tube()
    loops, spiral = plan_passes(mesh, "zlevel")
    line = lines(spiral)[0]
    turn = np.linalg.norm(np.diff(line, axis=0), axis=1).cumsum() // (2 * math.pi * 10.0)
    gone = replace(
        spiral, **{name: getattr(spiral, name)[:-1][turn != 5][: 2 * (int((turn != 5).sum()) // 2)]
                   for name in ("point", "normal", "face", "coedge", "segment", "polyline", "pass_")}
    )  # fmt: skip
    low, high = loops.point[:, 2].min(), loops.point[:, 2].max()
    assert farthest(mesh, gone, low, high) > 1.5 * farthest(mesh, loops, low, high)


@pytest.mark.parametrize(("name", "strategy"), PARTS)
def test_points_lie_in_the_facets_that_they_name_and_on_their_coedges(name, strategy):
    mesh = part(name)
    _, contact = plan_passes(mesh, strategy)
    corner = mesh.vertex[mesh.face[contact.face]]
    np.testing.assert_array_equal(contact.normal, mesh.normal[contact.face])
    assert np.abs(((contact.point - corner[:, 0]) * contact.normal).sum(axis=1)).max() < 1e-9
    for k in range(3):  # inside the facet: to the left of each of its sides
        side = corner[:, (k + 1) % 3] - corner[:, k]
        assert (np.cross(side, contact.point - corner[:, k]) * contact.normal).sum(axis=1).min() > -1e-7
    rows = np.flatnonzero(contact.coedge >= 0)
    assert len(rows) > 0.5 * len(contact.coedge)
    start, end = mesh.vertex[mesh.coedge_vertex[contact.coedge[rows]]].transpose(1, 0, 2)
    assert np.linalg.norm(np.cross(contact.point[rows] - start, end - start), axis=1).max() < 1e-7
    np.testing.assert_array_equal(
        contact.point[2::2], contact.point[1:-1:2]
    )  # one segment goes on where the other ended
    np.testing.assert_array_equal(contact.segment, np.arange(len(contact.point)) // 2)
    np.testing.assert_array_equal(contact.face[::2], contact.face[1::2])


def test_on_a_cylinder_it_is_a_helix_between_two_circles():
    loops, spiral = plan_passes(tube(), "zlevel", order="one_way")
    point = spiral.point
    angle = np.unwrap(np.arctan2(point[:, 1], point[:, 0])) / (2 * math.pi)
    turn, count = angle - angle[0], len(lines(loops))
    low, high = loops.point[:, 2].min(), loops.point[:, 2].max()
    assert turn[-1] == pytest.approx(
        count + 1, abs=0.1
    )  # a turn from each loop to the next, and the first and the last loop
    pitch = (high - low) / (count - 1)
    wanted = low + pitch * np.clip(turn - 1.0, 0.0, count - 1.0)
    np.testing.assert_allclose(point[:, 2], wanted, atol=0.1 * pitch)


def test_passes_begin_in_the_sense_of_the_loops_with_what_is_higher_to_their_left():
    _, spiral = plan_passes(tube(), "zlevel", order="one_way")
    way = spiral.point[1::2] - spiral.point[::2]
    left = np.cross(spiral.normal[::2], way)
    assert (left[:, 2] > 0.0).all()


def test_a_region_with_two_peaks_is_three_spirals():
    """Below the saddle round both peaks, and round each of them: three rings."""
    mesh = bumps(
        60,
        lambda x, y: (
            9 * np.exp(-((x - 18) ** 2 + (y - 30) ** 2) / 90)
            + 9 * np.exp(-((x - 42) ** 2 + (y - 30) ** 2) / 90)
        ),
    )
    heights = np.arange(0.61, 9.0, 0.4)
    saddle = 18 * math.exp(-144 / 90)
    region = Region(mesh, np.ones(len(mesh.face), bool), 3.0, STEP)
    loops, spiral = (
        cut(region, PassField(mesh.vertex[:, 2], heights), "one_way", on) for on in (False, True)
    )
    count = (heights < saddle).sum() + 2 * (heights > saddle).sum()
    assert len(lines(loops)) == count and all(map(is_closed, lines(loops)))
    assert len(lines(spiral)) == 3
    top = [line[:, 2].max() for line in lines(spiral)]
    assert sum(height > saddle for height in top) == 2


def test_level_planes_through_an_upright_ring_make_four_spirals():
    """Below the hole, on either side of it, and above it."""
    turn, tube = np.meshgrid(
        2 * math.pi * np.arange(60) / 60, 2 * math.pi * np.arange(30) / 30, indexing="ij"
    )
    radius = 12.0 + 5.0 * np.cos(tube)
    row = np.stack([5.0 * np.sin(tube), radius * np.cos(turn), radius * np.sin(turn)], axis=-1)
    a, b, c, d = row, np.roll(row, -1, 0), np.roll(row, (-1, -1), (0, 1)), np.roll(row, -1, 1)
    corner = np.concatenate([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)]).reshape(-1, 3, 3)
    loops, spiral = plan_passes(from_triangles(corner), "zlevel")
    assert len(lines(loops)) > 40 and all(map(is_closed, lines(loops)))
    assert len(lines(spiral)) == 4
    assert (
        sum(line[:, 2].max() < -6.0 for line in lines(spiral))
        == sum(line[:, 2].min() > 6.0 for line in lines(spiral))
        == 1
    )


def uneven():
    """Loops of a tube, the upper ones twice as far apart as the lower ones: heights, and the spirals."""
    heights = np.array([1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0])
    mesh = tube()
    region = Region(mesh, np.ones(len(mesh.face), bool), 3.0, STEP)
    return heights, cut(region, PassField(mesh.vertex[:, 2], heights), "one_way", True)


def beyond(heights, contact):
    """How much farther from all passes a sample is than half-way between the two loops it lies between, mm at
    most."""
    point = samples(tube(), 40_000)
    point = point[(point[:, 2] > heights[0]) & (point[:, 2] < heights[-1])]
    gap = np.diff(heights)[np.searchsorted(heights, point[:, 2]) - 1]
    off = cKDTree(np.concatenate([dense(line) for line in lines(contact)])).query(point)[0]
    return float((off - 0.5 * gap).max())


def test_between_loops_that_lie_apart_otherwise_than_the_next_no_turn_leads():
    heights, contact = uneven()
    assert len(lines(contact)) == 2
    assert [line[:, 2].max() for line in lines(contact)] == [pytest.approx(3.0), pytest.approx(7.0)]
    assert [line[:, 2].min() for line in lines(contact)] == [pytest.approx(1.0), pytest.approx(4.0)]
    assert beyond(heights, contact) < 0.02


def test_a_spiral_over_uneven_loops_would_be_too_coarse(monkeypatch):
    monkeypatch.setattr(bands, "EVEN", math.inf)
    heights, contact = uneven()
    assert len(lines(contact)) == 1 and beyond(heights, contact) > 0.05


def test_two_loops_stay_loops():
    mesh = revolved([10.0, 10.0], [0.0, 2.0])
    loops, spiral = plan_passes(mesh, "zlevel")
    assert len(lines(loops)) == 2 and same(loops, spiral)


def test_turns_that_do_not_meet_leave_the_loops(monkeypatch):
    make_result = spirals._all_turns

    def torn(rings):
        turns = make_result(rings)
        return turns._replace(turn=np.where(turns.turn == 3, 2, turns.turn))

    monkeypatch.setattr(spirals, "_all_turns", torn)
    loops, spiral = plan_passes(tube(), "zlevel")
    assert same(loops, spiral)


@pytest.mark.parametrize("strategy", ["planes", "radial", "zlevel"])
def test_open_passes_stay_as_they_are(strategy):
    mesh = tube()
    keep = mesh.vertex[mesh.face, 0].max(axis=1) < 9.0 if strategy != "planes" else None
    loops, spiral = plan_passes(mesh, strategy, keep=keep)
    assert len(lines(loops)) > 5 and same(loops, spiral)


def test_loops_beside_open_passes_become_a_spiral_and_the_others_stay():
    mesh = bumps(40, lambda x, y: 8 * np.exp(-((x - 20) ** 2 + (y - 20) ** 2) / 120))
    loops, spiral = plan_passes(mesh, "zlevel", PassOptions(stepover=0.5), order="one_way")
    opened = [line for line in lines(loops) if not is_closed(line)]
    closed = len(lines(loops)) - len(opened)
    kept = [
        line for line in lines(spiral) if any(len(line) == len(one) and (line == one).all() for one in opened)
    ]
    assert closed > 4 and len(kept) == len(opened)
    assert len(lines(spiral)) == len(opened) + 1


def test_a_ball_is_cut_from_its_lowest_place_in_one_spiral():
    _, spiral = plan_passes(from_triangles(sphere(8.0, 24, 40)), "scallop")
    assert len(lines(spiral)) == 1


# ---------------------------------------------------------------------------------------------- the whole way


@pytest.fixture(scope="module")
def boss(tmp_path_factory):
    file = tmp_path_factory.mktemp("spirals") / "boss.stl"
    write_stl(revolved([0, 12, 12, 7, 4, 0], [-4, -4, 0, 0, 9, 9], 24), file)
    return file


def make_result(file, **more):
    options = {
        "machine": "trunnion_ac",
        "controller": "linuxcnc",
        "cutter": "ball:6",
        "passes": "zlevel",
        "stepover": 1.0,
    }
    options |= {"tool_axis": "facet_mean", **UNCURED}
    return job.make(build_settings("mill", str(file), {**options, **more}))


def runs(path, motion):
    on = np.append(False, np.asarray(path.motion) == motion).astype(int)
    return int((np.diff(on) == 1).sum())


@pytest.mark.parametrize(
    "more", [{}, pytest.param({"tool_axis": "auto", "gouge": "lift", "linearize": "on"}, marks=pytest.mark.thorough)],
    ids=["bare", "with what a user gets"],
)  # fmt: skip
def test_a_program_has_fewer_links_and_no_more_rapids(boss, more):
    loops, spiral = make_result(boss, **more), make_result(boss, spiral="on", **more)
    assert runs(spiral.path, Motion.LINK) <= 0.5 * runs(loops.path, Motion.LINK)
    assert runs(spiral.path, Motion.RAPID) <= runs(loops.path, Motion.RAPID)


def test_off_is_the_default_and_open_planes_give_the_same_program(boss, tmp_path):
    def program(name, *more):
        out = tmp_path / name
        given = [
            "--machine",
            "trunnion_ac",
            "--cutter",
            "ball:6",
            "--stepover",
            "2",
            "--tool-axis",
            "facet_mean",
            "--quiet",
            "--gouge",
            "off",
        ]
        assert cli.main(["mill", str(boss), *given, "-o", str(out), *more]) == 0
        return out.read_bytes()

    level = program("a.ngc", "--passes", "zlevel")
    assert level == program("a.ngc", "--passes", "zlevel", "--spiral", "off")
    assert level != program("a.ngc", "--passes", "zlevel", "--spiral", "on")
    assert program("a.ngc", "--passes", "planes") == program("a.ngc", "--passes", "planes", "--spiral", "on")


def test_another_word_is_refused_and_nothing_is_written(boss, tmp_path, capsys):
    out = tmp_path / "a.ngc"
    with pytest.raises(SystemExit) as ended:
        cli.main(["mill", str(boss), "--machine", "trunnion_ac", "--spiral", "maybe", "-o", str(out)])
    assert ended.value.code == 2
    message = capsys.readouterr().err.splitlines()[-1]
    assert "--spiral" in message and "'maybe'" in message and "on" in message and "off" in message
    assert not out.exists()
