# SPDX-License-Identifier: LGPL-2.1-or-later
"""Level planes where a surface is steep and other passes where it is not: against closed forms, and by dense
samples of it."""

import math
from dataclasses import fields
from functools import lru_cache

import numpy as np
import pytest
from gouge_examples import prism
from mesh_shapes import field as height_field
from scipy.spatial import cKDTree
from test_spirals import dense, lines, revolved, samples
from uncured import UNCURED

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import from_faces, from_triangles, write_stl
from freecad_fiveaxis.core.passes import (
    PASS_STRATEGIES,
    Division,
    PassOptions,
    Region,
    flat_interval,
    lay_by_slope,
    lay_whole,
    steep_and_shallow,
)
from freecad_fiveaxis.core.passes.slopes import corner_slopes, divide_by_slope
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.settings import build_settings

BALL, SCALLOP = 3.0, 0.05
STEP = flat_interval(BALL, SCALLOP)
OPTIONS = PassOptions(scallop=SCALLOP)


@lru_cache
def hemisphere(radius=15.0, plate=25.0, rows=45, columns=72):
    polar = np.linspace(math.pi / 2, 0, rows + 1)
    return revolved([plate, *(radius * np.sin(polar))], [0.0, *(radius * np.cos(polar))], columns)


@lru_cache
def filleted_box(width=20.0, height=12.0, fillet=5.0, steps=20):
    turn = np.linspace(0, math.pi / 2, steps + 1)
    right = np.stack(
        [width - fillet + fillet * np.cos(turn), height - fillet + fillet * np.sin(turn)], axis=1
    )
    left = right[::-1] * [-1, 1]
    return prism([(-width, 0), (width, 0), *right, *left])


def cone(slope, height=9.0, top=4.0):
    return revolved([top + height / math.tan(math.radians(slope)), top], [0.0, height], 72)


def region_of(mesh, keep=None):
    return Region(mesh, np.ones(len(mesh.face), bool) if keep is None else keep, BALL, STEP)


def plan_passes(
    mesh, degrees, strategy="scallop", order="zigzag", spiral=False, overlap=1.0, keep=None, options=OPTIONS
):
    division = Division(
        math.radians(degrees), PASS_STRATEGIES["zlevel"], PASS_STRATEGIES[strategy], order, spiral, overlap
    )
    return lay_by_slope(region_of(mesh, keep), options, division)


def alone(mesh, strategy, keep=None, spiral=False, options=OPTIONS):
    return lay_whole(region_of(mesh, keep), options, PASS_STRATEGIES[strategy], "zigzag", spiral)


def same(one, two):
    return all(
        np.array_equal(getattr(one, f.name), getattr(two, f.name))
        for f in fields(one)
        if f.name != "findings"
    )


def is_level(line):
    return bool(np.ptp(line[:, 2]) < 1e-6)


def length(contact):
    return float(np.linalg.norm(contact.point[1::2] - contact.point[::2], axis=1).sum())


def off(contact, point):
    """How far points (n, 3) are from all passes."""
    return cKDTree(np.concatenate([dense(line) for line in lines(contact)])).query(point)[0]


# ---------------------------------------------------------------------------------------- where the line runs


@pytest.mark.parametrize(
    "degrees", [45.0, *(pytest.param(one, marks=pytest.mark.slow) for one in (20.0, 70.0))]
)
def test_a_hemisphere_is_divided_on_a_circle_and_the_passes_overlap_by_a_stepover(degrees):
    """The circle on which the slope is DEG has the radius R sin DEG; facets are 2 deg high."""
    mesh, radius, bound = hemisphere(), 15.0, math.radians(degrees)
    slopes = divide_by_slope(mesh, bound, STEP)
    steep = samples_of(slopes.copy.mesh, slopes.steep)
    ball = steep[steep[:, 2] > 1e-9]
    wide = np.hypot(ball[:, 0], ball[:, 1])
    assert wide.min() == pytest.approx(radius * math.sin(bound), abs=0.02 * radius * math.cos(bound))
    contact, _ = plan_passes(mesh, degrees, "planes")
    polar = [
        math.atan2(np.hypot(*line[0, :2]), line[0, 2])
        for line in lines(contact)
        if is_level(line) and line[0, 2] > 1e-6
    ]
    assert (
        0.4 * STEP < radius * (bound - min(polar)) <= 1.02 * STEP
    )  # within half an interval of the strip's rim
    assert (
        0.4 * STEP
        < radius * (max(polar_of(line) for line in lines(contact) if not is_level(line)) - bound)
        <= 1.02 * STEP
    )


def polar_of(line):
    """The largest angle from +Z of places of a polyline, as long as it leaves level ground, rad."""
    above = line[line[:, 2] > 1e-6]
    return float(np.arctan2(np.hypot(*above[:, :2].T), above[:, 2]).max())


def samples_of(mesh, chosen):
    return mesh.vertex[mesh.face[chosen]].reshape(-1, 3)


@pytest.mark.slow
def test_every_strategy_goes_a_stepover_beyond_the_line():
    """Upright planes end where their strip does: on a cylinder along X a straight line in closed form."""
    turn = np.linspace(0, math.pi, 91)
    mesh = prism([*np.stack([12 * np.cos(turn), 12 * np.sin(turn)], axis=1)], 60.0)
    keep = np.abs(mesh.normal[:, 0]) + (mesh.normal[:, 2] < -0.5) < 0.5
    options = PassOptions(direction=math.pi / 2, stepover=2.0)
    for degrees in (30.0, 60.0):
        contact, _ = plan_passes(mesh, degrees, "planes", keep=keep, options=options)
        across = [line for line in lines(contact) if not is_level(line)]
        ends = np.array(
            [np.degrees(np.arctan2(np.abs(line[[0, -1], 1]), line[[0, -1], 2])) for line in across]
        )
        assert len(across) > 20 and ends == pytest.approx(degrees + math.degrees(STEP / 12), abs=1.0)


def test_the_line_is_smooth_where_facets_are_not():
    """On a ball of facets in disorder the line stays nearer to its circle than a facet is wide, and is one
    closed curve."""
    random = np.random.default_rng(5)
    mesh = from_triangles(height_field(40, lambda x, y: np.zeros_like(x), 0.5))
    place = mesh.vertex[:, :2] - 10
    place = place + np.where(np.abs(place) < 9.9, random.uniform(-0.15, 0.15, place.shape), 0)
    mesh = from_faces(np.column_stack([place, np.sqrt(20.0**2 - (place**2).sum(axis=1))]), mesh.face)
    slopes = divide_by_slope(mesh, math.radians(25), 0.0)
    side = slopes.copy.mesh.coedge_face
    edge = np.flatnonzero((side[:, 1] >= 0) & (slopes.steep[side[:, 0]] != slopes.steep[side[:, 1]]))
    ends = slopes.copy.mesh.coedge_vertex[edge]
    assert (np.bincount(ends.reshape(-1))[np.unique(ends)] == 2).all()
    wide = np.hypot(*slopes.copy.mesh.vertex[ends.reshape(-1), :2].T)
    assert wide == pytest.approx(20 * math.sin(math.radians(25)), abs=0.25)
    assert slopes.copy.mesh.area.sum() == pytest.approx(mesh.area.sum(), rel=1e-12)


def test_facets_at_the_bound_belong_to_the_shallow_side_alone():
    mesh = cone(35)
    assert corner_slopes(mesh) == pytest.approx(corner_slopes(mesh).mean(), abs=1e-12)
    degrees = math.degrees(corner_slopes(mesh).mean())
    assert not divide_by_slope(mesh, math.radians(degrees), STEP).steep.any()
    assert divide_by_slope(mesh, math.radians(degrees - 0.05), STEP).steep.all()
    box = filleted_box()
    upright = np.abs(box.normal[:, 2]) < 1e-9
    assert not divide_by_slope(box, math.pi / 2, STEP).steep.any()
    slopes = divide_by_slope(box, math.radians(0.1), STEP)
    assert slopes.steep[upright[slopes.copy.parent]].all()
    assert not slopes.steep[box.normal[slopes.copy.parent, 2] < -0.9].any()


# ---------------------------------------------------------------------------------------------- one side only


def test_a_part_on_one_side_has_the_very_passes_of_the_one_strategy():
    for slope in (30, 50):
        mesh, strategy = cone(slope), "zlevel" if slope > 40 else "scallop"
        assert same(plan_passes(mesh, 40)[0], alone(mesh, strategy)[0])


def test_what_is_not_cut_counts_for_neither_side():
    mesh = hemisphere()
    keep = mesh.normal[:, 2] < math.cos(math.radians(60))
    assert same(plan_passes(mesh, 40, keep=keep)[0], alone(mesh, "zlevel", keep)[0])


# ----------------------------------------------------------------------------------------------- what is left


def hilly():
    return from_triangles(height_field(40, lambda x, y: 4 * np.sin(0.25 * x) * np.cos(0.2 * y), 0.75))


PARTS = {"hemisphere": hemisphere, "box with a fillet": filleted_box, "hills": hilly}


def cut_of(name):
    """A part, and what of it is cut: what looks down is not."""
    mesh = PARTS[name]()
    return mesh, mesh.normal[:, 2] > -0.5


@pytest.mark.parametrize(
    "strategy",
    [
        "scallop",
        pytest.param("planes", marks=(pytest.mark.thorough, pytest.mark.oldest)),
        pytest.param("radial", marks=pytest.mark.thorough),
    ],
)
@pytest.mark.parametrize(
    "name", [pytest.param(one, marks=[pytest.mark.slow] * ("box" in one)) for one in PARTS]
)
def test_every_place_is_as_near_to_a_pass_as_with_the_worse_of_both_alone(name, strategy):
    mesh, keep = cut_of(name)
    contact, _ = plan_passes(mesh, 35, strategy, keep=keep)
    point, slope = spread(mesh, keep)
    own = [off_alone(name, one) for one in ("zlevel", strategy)]
    worst = max(own[0][slope > math.radians(37)].max(), own[1][slope < math.radians(33)].max())
    assert off(contact, point).max() <= max(worst, 0.5 * STEP) * 1.1 + 0.05


@lru_cache
def off_alone(name, strategy):
    """How far these places of a part are from the passes of one strategy alone."""
    mesh, keep = cut_of(name)
    return off(alone(mesh, strategy, keep)[0], spread(mesh, keep)[0])


def spread(mesh, keep):
    """Places on what is cut, and the slope there."""
    random = np.random.default_rng(3)
    share = mesh.area * keep
    row = random.choice(len(mesh.face), 20_000, p=share / share.sum())
    at = random.random((len(row), 2))
    at = np.where(at.sum(1, keepdims=True) > 1, 1 - at, at)
    a, b, c = mesh.vertex[mesh.face[row]].transpose(1, 0, 2)
    slope = np.arctan2(np.hypot(*mesh.normal[row, :2].T), np.abs(mesh.normal[row, 2]))
    return a + at[:, :1] * (b - a) + at[:, 1:] * (c - a), slope


@pytest.mark.thorough
def test_a_removed_pass_would_be_noticed_but_for_the_overlap():
    """Without overlap both strategies end at the line, half an interval from it: the highest level plane is
    needed there. With it the other strategy's passes lie over that plane."""
    mesh, keep = cut_of("hemisphere")
    point, _ = spread(mesh, keep)
    polar = np.arctan2(np.hypot(*point[:, :2].T), point[:, 2])
    beside = point[(np.abs(15.0 * (polar - math.radians(50))) < 1.5 * STEP) & (point[:, 2] > 0.5)]
    for overlap in (1.0, 0.0):
        contact, _ = plan_passes(mesh, 50, "planes", keep=keep, overlap=overlap)
        high = max(line[0, 2] for line in lines(contact) if is_level(line) and line[0, 2] > 1)
        rest = [dense(line) for line in lines(contact) if line[0, 2] != high]
        assert len(rest) == len(lines(contact)) - 1 and off(contact, beside).max() <= 0.55 * STEP
        left = cKDTree(np.concatenate(rest)).query(beside)[0].max() / STEP
        assert left <= 0.6 if overlap else left > 0.7


def test_nothing_is_reported_of_what_the_other_strategy_cuts():
    """Pieces of facets between two passes are no facets without a pass, and the rim of a strip is no steep
    wall."""
    mesh, keep = cut_of("hemisphere")
    codes = [one.code for one in alone(mesh, "zlevel", keep)[1]]
    assert "side-not-machined" in codes  # the plate, of which nothing is told where another strategy cuts it
    assert plan_passes(mesh, 40, keep=keep)[1] == ()


@pytest.mark.slow
def test_at_the_rim_of_a_strip_no_planes_are_too_far_apart(monkeypatch):
    """Behind the rim of the fillet's strip the next level plane is on the ends of the box, 20 mm off."""
    mesh = filleted_box(20.0, 12.0, 4.0, 12)
    keep, options = mesh.normal[:, 2] > -0.5, PassOptions(scallop=SCALLOP)
    found = Region(mesh, keep, BALL, STEP)
    assert "least-interval" not in [one.code for one in lay_by_slope(found, options, of_scallop(40))[1]]
    monkeypatch.setattr(steep_and_shallow, "_at_rim", lambda *_: False)
    reported = next(
        one for one in lay_by_slope(found, options, of_scallop(40))[1] if one.code == "least-interval"
    )
    assert reported.value > BALL


# ------------------------------------------------------------------------------------ order, length, contract


def test_the_steep_part_comes_first_from_the_top_down():
    mesh = hemisphere()
    contact, _ = plan_passes(mesh, 45, "planes", order="one_way")
    level = np.array(
        [
            is_level(line) and 1e-6 < line[0, 2] < 15 * math.cos(math.radians(44)) + STEP
            for line in lines(contact)
        ]
    )
    height = np.array([line[0, 2] for line in lines(contact)])[level]
    assert level[: level.sum()].all() and not level[level.sum() :].any() and len(height) > 8
    assert (np.diff(height) <= 0).all() and (np.diff(contact.pass_) >= 0).all()
    plain, _ = alone(mesh, "zlevel")
    assert (contact.point[1, :2] - contact.point[0, :2]) @ np.array(
        [-contact.point[0, 1], contact.point[0, 0]]
    ) * (
        (plain.point[1, :2] - plain.point[0, :2]) @ np.array([-plain.point[0, 1], plain.point[0, 0]])
    ) > 0  # the way round is the one of level planes alone


def test_a_dome_with_a_top_nearly_flat_takes_less_than_level_planes_alone():
    """Its top leans by 1 to 8 deg: level planes stand as near as its flattest place asks for, all round."""
    mesh = from_triangles(height_field(48, lambda x, y: dome_height(x - 24, y - 24), 1.0))
    both, level = plan_passes(mesh, 20)[0], alone(mesh, "zlevel")[0]
    assert length(both) < 0.9 * length(level)


def dome_height(x, y):
    out = np.hypot(x, y)
    return np.where(out < 14, 0.02 * x + 0.06 * y, 0.02 * x + 0.06 * y - 0.09 * np.maximum(out - 14, 0) ** 2)


@pytest.mark.slow
def test_turned_shifted_and_scaled_the_passes_go_along():
    mesh = hilly()
    plain, _ = plan_passes(mesh, 35)
    turn = math.radians(37)
    matrix = np.array([[math.cos(turn), -math.sin(turn), 0], [math.sin(turn), math.cos(turn), 0], [0, 0, 1]])
    moved = from_faces(mesh.vertex @ matrix.T + [100, -50, 7], mesh.face)
    back = (lay_by_slope(region_of(moved), OPTIONS, of_scallop(35))[0].point - [100, -50, 7]) @ matrix
    assert_alike(plain.point, back)
    double = from_faces(2 * mesh.vertex, mesh.face)
    region = Region(double, np.ones(len(mesh.face), bool), 2 * BALL, 2 * STEP)
    scaled, _ = lay_by_slope(region, PassOptions(scallop=2 * SCALLOP, least=0.1), of_scallop(35))
    assert_alike(plain.point, scaled.point / 2)


def of_scallop(degrees):
    return Division(math.radians(degrees), PASS_STRATEGIES["zlevel"], PASS_STRATEGIES["scallop"], "zigzag")


def assert_alike(one, two):
    """Points lie on the same curves; how a curve is divided into segments may differ by rounding."""
    near = cKDTree(one).query(two)[0], cKDTree(two).query(one)[0]
    assert (
        max(float(np.quantile(away, 0.99)) for away in near) < 0.02 and max(away.max() for away in near) < 0.5
    )


def test_passes_lie_on_the_part_in_the_facets_and_on_the_coedges_that_they_name():
    mesh, keep = cut_of("hills")
    contact, _ = plan_passes(mesh, 35, keep=keep)
    foot = ((contact.point - mesh.vertex[mesh.face[contact.face, 0]]) * mesh.normal[contact.face]).sum(axis=1)
    assert np.abs(foot).max() < 1e-9 and (contact.normal == mesh.normal[contact.face]).all()
    on = contact.coedge >= 0
    start, end = mesh.vertex[mesh.coedge_vertex[contact.coedge[on]]].transpose(1, 0, 2)
    way = (end - start) / np.linalg.norm(end - start, axis=1)[:, None]
    aside = contact.point[on] - start
    assert np.linalg.norm(aside - (aside * way).sum(axis=1)[:, None] * way, axis=1).max() < 1e-9
    goes_on = np.flatnonzero((np.diff(contact.polyline) == 0) & (np.diff(contact.segment) == 1))
    assert (contact.point[goes_on] == contact.point[goes_on + 1]).all()
    assert on.mean() > 0.6


def test_no_pass_that_lies_in_the_strip_is_a_stub():
    mesh, keep = cut_of("hills")
    contact, _ = plan_passes(mesh, 35, "planes", keep=keep)
    slopes = divide_by_slope(mesh, math.radians(35), STEP)
    middle = slopes.copy.mesh.vertex[slopes.copy.mesh.face].mean(axis=1)
    for line in lines(contact):
        if np.linalg.norm(line[1::2] - line[::2], axis=1).sum() < 0.3 * STEP:
            assert not slopes.strip[cKDTree(middle).query(line.mean(axis=0))[1]]


@pytest.mark.parametrize("strategy", ["scallop", pytest.param("morph", marks=pytest.mark.slow)])
def test_both_parts_become_spirals_where_they_can(strategy):
    polar = np.linspace(0, math.pi / 2, 46)
    mesh = revolved(15 * np.sin(polar[::-1]), 15 * np.cos(polar[::-1]), 72)
    mesh = (
        mesh
        if strategy == "scallop"
        else from_faces(mesh.vertex, mesh.face[mesh.vertex[mesh.face][:, :, 2].max(axis=1) < 14.5])
    )
    loops, spiral = plan_passes(mesh, 45, strategy)[0], plan_passes(mesh, 45, strategy, spiral=True)[0]
    assert len(lines(loops)) > 15 and len(lines(spiral)) <= 3  # two, and a loop round the top
    point = samples(mesh)
    low = (point[:, 2] > loops.point[:, 2].min()) & (point[:, 2] < loops.point[:, 2].max())
    assert off(spiral, point[low]).max() <= 1.05 * off(loops, point[low]).max() + 0.02


# ------------------------------------------------------------------------------------------------ jobs


JOB = {
    "machine": "trunnion_ac",
    "controller": "linuxcnc",
    "cutter": "ball:6",
    "scallop": SCALLOP,
    "tool_axis": "facet_mean",
}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("steep")
    write_stl(filleted_box(), folder / "box.stl")
    write_stl(cone(50), folder / "cone.stl")
    mesh = filleted_box()
    level = mesh.normal[:, 2] > 1 - 1e-9
    for name, chosen in (
        ("top", level),
        ("sides", (np.abs(mesh.normal[:, 0]) < 0.5) & ~level & (mesh.normal[:, 2] > -0.5)),
    ):
        write_stl(from_faces(mesh.vertex, mesh.face[chosen]), folder / f"{name}.stl")
    return folder


def make_result(files, **more):
    return job.make(
        build_settings(
            "mill", str(files / "box.stl"), {**JOB, "passes": "scallop", "steep_shallow": 40, **more}
        )
    )


def slope_at(found):
    """The slope of the facets under the contacts, degrees."""
    up = np.abs(found.mesh.normal[found.contact.face][:, 2])
    return np.degrees(np.arccos(np.clip(up, 0, 1)))


def test_the_same_bytes_as_the_one_strategy_where_the_part_lies_on_one_side(files, tmp_path):
    def program(name, *more):
        out = tmp_path / name
        given = [word for key, value in JOB.items() for word in (f"--{key.replace('_', '-')}", str(value))]
        given += ["--scallop", str(4 * SCALLOP), "--gouge", "off", "--linearize", "off"]
        assert cli.main(["mill", str(files / "cone.stl"), *given, "--quiet", "-o", str(out), *more]) == 0
        return out.read_bytes()

    scallop, level = (program("a.ngc", "--passes", one) for one in ("scallop", "zlevel"))
    assert program("a.ngc", "--passes", "scallop", "--steep-shallow", "60") == scallop != level
    assert program("a.ngc", "--passes", "scallop", "--steep-shallow", "40") == level


@pytest.mark.slow
def test_with_faces_to_machine_and_to_avoid(files):
    found = make_result(files, faces=str(files / "sides.stl"))
    assert slope_at(found).min() > 0.1 and slope_at(found).max() == pytest.approx(90)
    found = make_result(files, avoid=str(files / "sides.stl"))
    place = found.offset.point
    assert found.keep.any() and len(place) and not ((np.abs(place[:, 0]) < 19.9) & (place[:, 2] < 11.9)).any()
    assert (place[:, 2] > 11.9).any() and (place[:, 2] < 5).any()  # the top and the ends


@pytest.mark.oldest
@pytest.mark.thorough
def test_with_a_boundary(files, tmp_path):
    curve = tmp_path / "b.csv"
    curve.write_text("-10,-25,0\n10,-25,0\n10,25,0\n-10,25,0\n-10,-25,0\n")
    found = make_result(files, boundary=str(curve), boundary_axis="0,0,1", scallop=4 * SCALLOP, **UNCURED)
    assert np.abs(found.offset.point[:, 0]).max() == pytest.approx(10, abs=1e-6)
    assert {True, False} == set(np.unique(found.offset.point[:, 2] < 6).tolist())


@pytest.mark.slow
@pytest.mark.parametrize("axis", ["auto", "facet_mean"])
def test_the_rest_is_no_higher_than_with_the_worse_of_both_alone(files, axis):
    """Dense samples of the part under the whole program, as the job's own rest material has them."""
    jobs = [
        job.run(
            build_settings(
                "mill",
                str(files / "box.stl"),
                {**JOB, "tool_axis": axis, "rest": "on", "scallop": 4 * SCALLOP, **more},
            )
        )
        for more in ({"passes": "scallop", "steep_shallow": 40}, {"passes": "scallop"}, {"passes": "zlevel"})
    ]
    both, scallop, level = (one.rest for one in jobs)
    assert both.uncut(8 * SCALLOP)[0] <= max(scallop.uncut(8 * SCALLOP)[0], level.uncut(8 * SCALLOP)[0])


# -------------------------------------------------------------------------------------------- what is refused


BAD = [
    (["--steep-shallow", "-1"], "steep-shallow"), (["--steep-shallow", "0"], "above 0 deg and at most 90 deg"), (["--steep-shallow", "91"], "steep-shallow"),
    (["--steep-shallow", "nan"], "steep-shallow"), (["--steep-shallow", "steep"], "steep-shallow"),
    (["--steep-shallow", "40", "--passes", "zlevel"], "leave one of them out"),
    (["--steep-shallow", "40", "--passes", "frames"], "leave one of them out"),
]  # fmt: skip


@pytest.mark.parametrize(("words", "message"), BAD, ids=range(len(BAD)))
def test_what_is_no_slope_is_refused_in_one_line(files, tmp_path, capsys, words, message):
    out = tmp_path / "out.ngc"
    given = [
        "mill",
        str(files / "box.stl"),
        "--machine",
        "trunnion_ac",
        "--cutter",
        "ball:6",
        "-o",
        str(out),
        "--quiet",
        *words,
    ]
    try:
        code = cli.main(given)
    except SystemExit as ended:
        code = ended.code
    error = capsys.readouterr().err.strip().splitlines()[-1]
    assert code == 2 and message in error and not out.exists()
