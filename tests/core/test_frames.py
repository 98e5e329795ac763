# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes in frames: few directions see it all, rotary axes are locked in each, and what none sees is told. By
closed forms, by brute force and by a ball swept along the posted words."""

import itertools
import math
import os
import re
from functools import lru_cache
from pathlib import Path
from types import SimpleNamespace
from unittest.mock import patch

import numpy as np
import pytest
from gouge_examples import prism, shelf
from mesh_shapes import box, sphere
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist
from test_fewer_axes import table_a, three
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import Mesh, from_faces, from_triangles, read_stl, write_stl
from freecad_fiveaxis.core.machine import save_machine
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.orientation import axis_field, find_frames
from freecad_fiveaxis.core.passes import flat_interval, frame_passes
from freecad_fiveaxis.core.passes.frames import Frames
from freecad_fiveaxis.core.pipeline import job, mill_context, milling
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.toolpath.cl_path import Motion

RADIUS, SCALLOP, TOLERANCE = 3.0, 0.05, 0.01
FEW = 300
"""Places by which frames are chosen; the product takes more, which the slow ring has."""


def fewer_places(mesh, facets, reacher, tree, count=FEW):
    return axis_field.surface_nodes(mesh, facets, reacher, tree, min(count, 10 * FEW))


@pytest.fixture(autouse=True)
def few(request, monkeypatch):
    if not any(request.node.get_closest_marker(one) for one in ("slow", "thorough")):
        monkeypatch.setattr(find_frames, "surface_nodes", fewer_places)


def block() -> Mesh:
    return from_triangles(box((-15, -12, 0), (15, 12, 16)))


def hexagon() -> Mesh:
    """A prism of six sides, standing upright: that of a profile along x, turned up."""
    turn = math.pi / 3 * np.arange(6)
    make_result = prism(14.0 * np.column_stack([np.cos(turn), np.sin(turn)]), 20.0)
    return from_faces(np.asarray(make_result.vertex)[:, [1, 2, 0]] + (0.0, 0.0, 10.0), make_result.face)


def knob() -> Mesh:
    """A ball of 10 mm at Z 26 on a stem of 4 mm, turned about Z."""
    columns = 20
    polar = np.linspace(0.0, math.pi - math.asin(0.4), 14)
    profile = np.concatenate([np.column_stack([10 * np.sin(polar), 26 + 10 * np.cos(polar)]), [[4.0, 0.0]]])[
        1:
    ]
    turn, k = 2 * math.pi * np.arange(columns) / columns, len(profile)
    ring = np.stack([np.outer(profile[:, 0], np.cos(turn)), np.outer(profile[:, 0], np.sin(turn))], axis=-1)
    point = np.concatenate([ring, np.repeat(profile[:, 1, None, None], columns, axis=1)], axis=2).reshape(
        -1, 3
    )
    row = np.arange(k * columns).reshape(k, columns)
    after = np.roll(row, -1, axis=1)
    a, b, c, d = (part.ravel() for part in (row[:-1], row[1:], after[1:], after[:-1]))
    top, low = k * columns, k * columns + 1
    caps = [
        np.stack([np.full(columns, top), row[0], after[0]], 1),
        np.stack([np.full(columns, low), after[-1], row[-1]], 1),
    ]
    face = np.concatenate([*caps, np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return from_faces(np.concatenate([point, [[0, 0, 36.0], [0, 0, 0.0]]]), face)


def slot() -> Mesh:
    """A slot 10 mm wide and 12 mm deep along x, in a block."""
    return prism([(-18, 0), (18, 0), (18, 20), (5, 20), (5, 8), (-5, 8), (-5, 20), (-18, 20)], 30.0)


PARTS = {"block": block, "hexagon": hexagon, "knob": knob, "slot": slot}


def make_result(mesh, **given):
    options = {
        "machine": "trunnion_ac",
        "cutter": "ball:6",
        "scallop": SCALLOP,
        "passes": "frames",
        "spindle": 9000,
        **given,
    }
    return job.make(build_settings("mill", "part", options), mesh=mesh)


def milled(mesh, **given):
    return job.prove(make_result(mesh, **given))


@lru_cache
def simultaneous(name):
    """The program of a part whose tool axis turns while it cuts."""
    return milled(PARTS[name](), passes="scallop", linearize="on")


def of(name):
    return result_of(name, find_frames.surface_nodes)


@lru_cache
def result_of(name, _):
    return milled(PARTS[name]())


def axes_of(result):
    """The frames' axes, of what the note says."""
    text = next(str(one.text) for one in result.draft.findings if one.code == "frames")
    return np.array(
        [[float(x) for x in one.split(",")] for one in text.rstrip(".").split(": ")[1].split("; ")]
    )


def rotary_of_feed(result):
    """Rotary words (b, 2) at both ends of every feed block, as our reader reads the posted text."""
    make_result = result.draft
    program = read_nc(make_result.nc, make_result.kinematics, make_result.dialect)
    feed = np.flatnonzero(program.motion[1:] != Motion.RAPID)
    return np.asarray(program.words)[feed, 3:], np.asarray(program.words)[feed + 1, 3:]


def locked(result):
    """The distinct rotary positions of feed blocks; that they turn in none, and that the text says it once a
    frame."""
    before, after = rotary_of_feed(result)
    assert (before == after).all()
    lines = result.draft.nc.decode().splitlines()
    assert not [line for line in lines if line.startswith("G1") and re.search("[ABC]", line)]
    turns = np.flatnonzero((np.diff(after, axis=0) != 0.0).any(axis=1))
    distinct = len(np.unique(after, axis=0))
    assert len(turns) + 1 == distinct == len(axes_of(result))  # each frame is come to once
    return distinct


def centres(result, step=0.1):
    """Where the ball's centre is on feed blocks, by a forward map of the words."""
    words, feed = result.draft.program.words, result.draft.program.motion[1:] != Motion.RAPID
    tip, axis = forward(result.draft.kinematics, words_to_q(words))
    centre = tip + RADIUS * axis
    start, end = centre[:-1][feed], centre[1:][feed]  # straight: the rotary axes stand
    pieces = np.ceil(np.linalg.norm(end - start, axis=1) / step).astype(int) + 1
    row = np.repeat(np.arange(len(start)), pieces)
    share = (np.arange(len(row)) - np.repeat(np.cumsum(pieces) - pieces, pieces)) / np.maximum(pieces - 1, 1)[
        row
    ]
    return start[row] + share[:, None] * (end - start)[row]


def spread(mesh, count, seed=7):
    random = np.random.default_rng(seed)
    facet = random.choice(len(mesh.face), count, p=mesh.area / mesh.area.sum())
    share = random.random((count, 2))
    share = np.where(share.sum(1, keepdims=True) > 1, 1 - share, share)
    a, b, c = mesh.vertex[mesh.face[facet]].transpose(1, 0, 2)
    return a + share[:, :1] * (b - a) + share[:, 1:] * (c - a), np.asarray(mesh.normal)[facet]


def seen_by(mesh, axes, point, normal, lean=0.1):
    """Whether (n,) the ball and its shank as wide stand free on each point with one of the axes, against
    points of the part."""
    cloud, centre, seen = spread(mesh, 6000, 3)[0], point + RADIUS * normal, np.zeros(len(point), bool)
    fits = cKDTree(cloud).query(centre)[0] > RADIUS - 0.05
    for axis in axes:
        rows = np.flatnonzero(fits & ~seen & (normal @ axis > lean))
        along = cloud @ axis - (centre[rows] @ axis)[:, None]
        beside = cdist(centre[rows], cloud, "sqeuclidean") - along**2
        seen[rows] = ~((along > 0.0) & (beside < (RADIUS - 0.05) ** 2)).any(axis=1)
    return seen


# -------------------------------------------------------------------------------------- few frames see it all


@pytest.mark.parametrize("name", ["block", "hexagon"])
def test_two_frames_see_what_stands_upright_and_convex(name):
    """A direction leans less than 90 deg from at most half of the sides all round, and two opposite ones from
    all."""
    assert locked(of(name)) == 2


@pytest.mark.parametrize(
    "name", [pytest.param(one, marks=[pytest.mark.slow] * (one == "knob")) for one in PARTS]
)
def test_rotary_axes_are_locked_in_each_frame(name):
    result = of(name)
    assert 1 <= locked(result) <= 12
    assert not any(
        len(depth) and depth.max() > TOLERANCE
        for _, _, depth in result.gouge.cases(result.draft.program.motion[1:])
    )


def test_a_turn_in_a_feed_block_would_be_noticed():
    with pytest.raises((AssertionError, StopIteration)):
        locked(simultaneous("block"))


@some_in_core("name", PARTS, kept=(0, 1, 3))
def test_no_more_than_scallops_stays_on_what_a_frame_sees(name):
    result, mesh = of(name), PARTS[name]()
    point, normal = spread(mesh, 1500)
    above = (normal[:, 2] > -0.99) | (point[:, 2] > 1e-3)
    point, normal = point[above], normal[above]
    rest = cKDTree(centres(result)).query(point)[0] - RADIUS
    seen = seen_by(mesh, axes_of(result), point, normal)
    assert seen.mean() > 0.6 and rest.min() > -TOLERANCE - 0.005
    assert np.quantile(rest[seen], 0.99) <= 2 * SCALLOP + TOLERANCE


def test_where_a_frame_is_not_cut_more_stays():
    result, mesh = of("block"), block()
    point, normal = spread(mesh, 1500)
    rest = cKDTree(centres(result)[: len(centres(result)) // 2]).query(point)[0] - RADIUS
    assert np.quantile(rest[normal[:, 2] > -0.9], 0.9) > 1.0


@pytest.mark.parametrize("name", ["block", pytest.param("knob", marks=pytest.mark.slow)])
def test_frames_finish_about_what_simultaneous_passes_finish(name):
    mesh = PARTS[name]()
    point, _ = spread(mesh, 1500)
    finished = [
        (cKDTree(centres(result)).query(point)[0] - RADIUS <= 2 * SCALLOP + TOLERANCE).mean()
        for result in (of(name), simultaneous(name))
    ]
    assert finished[0] > finished[1] - 0.03


# ------------------------------------------------------------------------------------------ where frames meet


FLAT = 2.0 * math.sqrt(2.0 * RADIUS * SCALLOP - SCALLOP**2)
REAL = Path(os.environ.get("FIVEAXIS_MESHES", "/usr/share/opencascade/data/stl")) / "sh1.stl"


def ball_in_frames():
    """A ball that stands free: frames meet all over it, where the surface is smooth."""
    return from_triangles(sphere(14.0, 30, 44, (0, 0, 40)))


FOUND = {}
"""The frames of a part, found once for all passes in them: these and what they leave to others change
nothing of where the part is seen from."""


def find_once(mesh, *given, **more):
    name = mesh.vertex.tobytes()
    if name not in FOUND:
        FOUND[name] = find_frames.find_frames(mesh, *given, **more)
    return FOUND[name]


def result_and_frames(mesh, overlap, **given):
    """The program, unproven, and which frame cuts what, as the strategy was told. What stays is for the judge
    to find: with ``rest`` on nothing looks for it before a program is proven."""
    seen, field_of = [], frame_passes.FramePasses.field

    def remember(strategy, region, options):
        seen.append(region.frames)
        return field_of(strategy, region, options)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(frame_passes.FramePasses, "field", remember)
        patch.setattr(frame_passes, "OVERLAP", overlap)
        patch.setattr(mill_context, "find_frames", find_once)
        return SimpleNamespace(draft=make_result(mesh, rest="on", **given)), seen[0]


def at_seams(result, frames, mesh, count, within):
    """What is left (k,) mm at places no farther than ``within`` steps from where another frame's territory
    begins on a surface as smooth as there; and which of these (k,) the ball can touch in the frame of their
    own, by a thick cloud of the surface."""
    point, normal = spread(mesh, count)
    own = frames.at(point, normal)
    place, far = np.hstack([point, 2.0 * FLAT * normal]), np.full(count, np.inf)
    for one in range(len(frames.axis)):
        other = (own != one) & (own >= 0)
        if (own == one).any() and other.any():
            far[own == one] = cKDTree(place[other]).query(place[own == one])[0]
    near = np.flatnonzero((own >= 0) & (far < within * FLAT))
    rest = cKDTree(centres(result)).query(point[near])[0] - RADIUS
    return rest, comes_free(mesh, point[near], normal[near], frames.axis[own[near]])


def comes_free(mesh, point, normal, axis, step=0.75):
    """Whether (k,) the ball on a point, and balls all the way up its axis, keep out of the part."""
    cloud, centre = cKDTree(spread(mesh, 60_000, 3)[0]), point + RADIUS * normal
    free = ((normal * axis).sum(axis=1) > 0.1) & (cloud.query(centre)[0] > RADIUS - 0.05)
    for height in np.arange(step, np.linalg.norm(mesh.box[1] - mesh.box[0]), step):
        rows = np.flatnonzero(free)
        free[rows] = (
            cloud.query(centre[rows] + height * axis[rows], distance_upper_bound=RADIUS)[0] > RADIUS - 0.05
        )
    return free


WITHIN = pytest.mark.parametrize("within", ["scallop", "planes"])


@pytest.mark.slow
@WITHIN
def test_at_smooth_seams_between_frames_no_more_than_the_scallop_stays_and_without_the_overlap_more(within):
    mesh = ball_in_frames()
    most = []
    for overlap in (frame_passes.OVERLAP, 0.0):
        rest, free = at_seams(*result_and_frames(mesh, overlap, within_frames=within), mesh, 40_000, 1.0)
        assert free.sum() > 2000 and rest.min() > -TOLERANCE
        most.append(np.quantile(rest[free], 0.999))
    assert most[0] <= SCALLOP < 1.2 * SCALLOP < most[1]


@pytest.mark.slow
@pytest.mark.skipif(
    not REAL.exists(), reason="the mesh sh1 of OCCT's samples is not here (Debian's occt-misc)"
)
@WITHIN
def test_at_seams_on_a_real_part_no_more_than_two_scallops_stay_where_the_tool_is_free(within):
    """All seams, between sharp edges too; its seven frames see nine tenths of it."""
    mesh = read_stl(str(REAL))
    rest, free = at_seams(
        *result_and_frames(mesh, frame_passes.OVERLAP, within_frames=within), mesh, 40_000, 1.0
    )
    assert free.sum() > 500 and rest.min() > -TOLERANCE
    assert (
        np.quantile(rest[free], 0.99) <= SCALLOP + TOLERANCE and np.quantile(rest[free], 0.998) <= 2 * SCALLOP
    )


# ----------------------------------------------------------------------------------------- what no frame sees


@lru_cache
def roofed():
    mesh = shelf(gap=7.0, roof=6.0, back=25.0, length=20.0)
    return mesh, milled(mesh, origin="0,0,80")


def test_what_is_under_a_roof_is_reported_with_its_area():
    """The ceiling of a shelf and what lies behind it."""
    mesh, result = roofed()
    lost = [
        one
        for one in result.findings
        if one.code in ("outside-frames", "facets-without-free-axis", "facets-looking-down")
    ]
    point, normal = spread(mesh, 3000)
    rest = cKDTree(centres(result)).query(point)[0] - RADIUS
    standing = (normal[:, 2] < -0.99) & (point[:, 2] < -4.9)
    uncut = ((rest > 2 * SCALLOP + TOLERANCE) & ~standing).mean() * mesh.area.sum()
    reported = sum(one.value for one in lost if "stands on" not in str(one.text))
    assert uncut > 100.0 and reported == pytest.approx(uncut, rel=0.35)


def test_facets_that_are_cut_and_those_that_are_not_make_up_the_part_once():
    """What no frame sees of facets that are cut elsewhere counts as uncut there, not beside them."""
    mesh, result = roofed()
    codes = ("outside-frames", "facets-without-free-axis", "facets-looking-down")
    lost = [one for one in result.findings if one.code in codes]
    whole = mesh.area[result.draft.keep].sum() + sum(one.value - (one.within or 0.0) for one in lost)
    assert any(one.within for one in lost) and whole == pytest.approx(mesh.area.sum(), rel=1e-9)
    assert "uncut" in {one.code for one in result.findings}, "how much stays of them is looked for"


def test_what_no_axis_frees_is_not_called_missed_nor_requested_with_other_passes():
    mesh, keep = block(), np.ones(12, bool)
    frames = Frames(np.eye(3)[2:], np.zeros((10, 3)), np.tile(np.eye(3)[2], (10, 1)), np.array([0] * 6 + [-1] * 4), 1.0)  # fmt: skip
    elsewhere = np.zeros(10, bool)
    whole = find_frames.Whole(float(mesh.area.sum()), find_frames.OF_PART)
    (none,) = find_frames._unseen(frames, elsewhere, mesh, keep, keep, 12, whole)
    assert none.code == "facets-without-free-axis" and "other passes" not in none.text
    assert none.value == none.within == pytest.approx(0.4 * mesh.area.sum())
    elsewhere[-2:] = True
    free, none = find_frames._unseen(frames, elsewhere, mesh, keep, keep, 12, whole)
    assert (free.code, none.code) == ("outside-frames", "facets-without-free-axis")
    assert free.value == none.value == pytest.approx(0.2 * mesh.area.sum()) and "other passes" in free.text
    seen = np.arange(12) >= 2
    dropped = find_frames._unseen(frames, elsewhere, mesh, keep, seen, 12, whole)
    assert sum(one.value - one.within for one in dropped) == pytest.approx(mesh.area[:2].sum())


def test_fewer_frames_than_it_takes_say_what_they_do_not_see():
    whole, one = of("block"), milled(block(), frames=1)
    assert locked(one) == 1 and not [f for f in whole.findings if f.code == "outside-frames"]
    (reported,) = [f for f in one.findings if f.code == "outside-frames"]
    assert reported.value == pytest.approx(30 * 16 + 24 * 16, rel=0.02) and "allow more frames" in str(
        reported.text
    )


# ------------------------------------------------------------------------------------------------ the cover


def fewest(free):
    """How many directions free all that any frees: by trying them all."""
    some = free.any(axis=1)
    return next(
        n
        for n in range(1, 13)
        for of in itertools.combinations(range(free.shape[1]), n)
        if free[some][:, of].any(1).all()
    )


@pytest.mark.parametrize("seed", range(12))
def test_the_cover_takes_no_more_than_one_direction_too_many(seed):
    random = np.random.default_rng(seed)
    normal, direction = (
        v / np.linalg.norm(v, axis=1)[:, None]
        for v in (random.normal(size=(60, 3)), random.normal(size=(16, 3)))
    )
    cosine = normal @ direction.T
    free = (cosine > 0.4) & (random.random(cosine.shape) > 0.1)
    chosen = find_frames.find_cover(free, cosine, direction[:, 2], 12)
    assert free[:, chosen].any(axis=1).sum() == free.any(axis=1).sum()
    assert len(chosen) <= fewest(free) + 1


def test_the_cover_of_few_frees_nearly_as_much_as_any():
    random = np.random.default_rng(3)
    free = random.random((80, 14)) > 0.7
    chosen = find_frames.find_cover(free, np.ones(free.shape), np.zeros(14), 3)
    best = max(free[:, of].any(axis=1).sum() for of in itertools.combinations(range(14), 3))
    assert len(chosen) == 3 and free[:, chosen].any(axis=1).sum() >= (1 - (1 - 1 / 3) ** 3) * best


# --------------------------------------------------------------------------- the part turned, shifted, scaled


@pytest.mark.parametrize(("turn", "shift", "scale"), [(0.7, (20, -15, 0), 1.5)])
def test_a_part_turned_shifted_or_scaled_is_cut_as_well(turn, shift, scale):
    mesh = hexagon()
    matrix = np.array(
        [[math.cos(turn), -math.sin(turn), 0], [math.sin(turn), math.cos(turn), 0], [0, 0, 1.0]]
    )
    moved = from_faces(scale * np.asarray(mesh.vertex) @ matrix.T + shift, mesh.face)
    result = milled(moved)
    assert locked(result) == 2
    point, normal = spread(moved, 1000)
    rest = cKDTree(centres(result)).query(point)[0] - RADIUS
    assert np.quantile(rest[normal[:, 2] > -0.9], 0.99) <= 2 * SCALLOP + TOLERANCE


# ------------------------------------------------------------------------------------- fewer axes, bad values


def test_one_rotary_axis_gives_frames_in_its_plane(tmp_path):
    save_machine(table_a(), tmp_path / "a.fcm")
    result = milled(block(), machine=str(tmp_path / "a.fcm"), tool_length=120)
    assert locked(result) >= 2
    np.testing.assert_allclose(axes_of(result)[:, 0], 0.0, atol=1e-3)
    reported = sum(one.value for one in result.findings if one.code == "facets-without-free-axis")
    assert reported == pytest.approx(2 * 24 * 16, rel=0.05)  # both ends


def test_without_rotary_axes_there_is_one_frame_and_walls_are_reported(tmp_path):
    save_machine(three(), tmp_path / "three.fcm")
    result = milled(block(), machine=str(tmp_path / "three.fcm"), tool_length=120)
    np.testing.assert_allclose(axes_of(result), [[0, 0, 1]])
    reported = sum(one.value for one in result.findings if one.code == "facets-without-free-axis")
    assert reported == pytest.approx(2 * 16 * (30 + 24), rel=0.05)


@pytest.mark.parametrize(
    ("words", "message"),
    [(["--frames", "0"], "at least 1 and at most 12"), (["--frames", "13"], "at least 1 and at most 12"),
     (["--frames", "few"], "is not a number"), (["--frames", "2.5"], "not a whole number"),
     (["--tool-axis", "fixed"], "leave --tool-axis out"), (["--lead", "5"], "leave --lead out"),
     (["--tilt", "5"], "leave --tilt out"), (["--gouge", "tilt"], "choose another"),
     (["--singularity", "deform"], "choose another")],
)  # fmt: skip
def test_what_frames_cannot_do_is_refused_in_one_line(words, message, tmp_path, capsys):
    write_stl(block(), tmp_path / "part.stl")
    given = [
        "mill",
        str(tmp_path / "part.stl"),
        "--machine",
        "trunnion_ac",
        "--cutter",
        "ball:6",
        "--passes",
        "frames",
    ]
    code = cli.main([*given, *words, "-o", str(tmp_path / "out.ngc")])
    error = capsys.readouterr().err.strip()
    assert code == 2 and message in error and "\n" not in error
    assert sorted(path.name for path in tmp_path.iterdir()) == ["part.stl"]


def test_a_number_of_frames_alone_asks_for_frames():
    assert (
        build_settings("mill", "part.stl", {"machine": "trunnion_ac", "frames": 3}).passes.passes == "frames"
    )


@pytest.mark.oldest
@pytest.mark.thorough
def test_each_facet_is_of_one_frame_and_passes_are_spaced_by_how_the_cutter_stands_on_these():
    """In the frame that leans about Y the walls across X are not cut: that a flat end mill would stand on its
    edge there is no reason to step more closely."""
    mesh, given = block(), {"cutter": "flat:6", "scallop": 0.15, "gouge": "off", "linearize": "off"}
    with patch.object(milling, "find_region", wraps=milling.find_region) as found:
        draft = make_result(mesh, **given)
    ((_, _, keep, _, frames), _), region = found.call_args, milling.find_region(*found.call_args[0])
    own = frames.facets(mesh)
    assert (np.sum(own, axis=0)[keep] == 1).all() and len(own) == 2
    with patch.object(Frames, "facets", lambda self, part: [np.ones(len(part.face), bool)] * len(self.axis)):
        assert region.radius > 1.2 * milling.find_region(*found.call_args[0]).radius
    (narrow,) = [one for one in draft.findings if one.code == "narrow-passes"]
    assert narrow.value < 0.25 * narrow.limit and narrow.limit == pytest.approx(flat_interval(3.0, 0.15))


def test_of_a_ball_and_of_a_level_bottom_it_is_not_stated_that_passes_are_narrow():
    quick = {"gouge": "off", "linearize": "off", "rest": "off", "passes": "scallop"}
    for given in ({"cutter": "ball:6"}, {"cutter": "flat:6", "tool_axis": "face_normal"}):
        assert "narrow-passes" not in [one.code for one in make_result(block(), **quick, **given).findings]


@pytest.mark.slow
def test_other_cutters_are_cut_in_frames_too():
    result = milled(from_triangles(sphere(12.0, 16, 24, (0, 0, 30))), cutter="bull:6:1", scallop=0.1)
    assert locked(result) >= 2


def test_frames_keep_clear_of_fixtures(tmp_path):
    """A jaw along one long side, as high as the part: that side's lower half is not cut, and nothing enters
    the jaw."""
    jaw = from_triangles(box((-15, 12.5, 0), (15, 30, 14)))
    write_stl(jaw, tmp_path / "jaw.stl")
    result, free = milled(block(), fixture=[str(tmp_path / "jaw.stl")]), of("block")
    locked(result)
    hidden = [sum((centres(one)[:, 1] > 12.0) & (centres(one)[:, 2] < 8.0)) for one in (result, free)]
    assert hidden[0] == 0 < hidden[1]
    assert not [one.code for one in result.findings if one.code in ("fixture-collision", "fixture-unproven")]


# --------------------------------------------------------------------------------------- planes in each frame


def planar(result, angle):
    """How far (k,) mm the contacts of each pass are from one plane that contains the pass's frame's axis and
    the travel, and how far apart (j,) mm such planes of a frame are that follow one another."""
    make_result = result.draft
    axes = np.unique(np.round(make_result.axis, 12), axis=0)  # the note rounds them
    travel = np.array([math.cos(angle), math.sin(angle), 0.0])
    across = np.cross(axes, travel)
    across /= np.linalg.norm(across, axis=1)[:, None]
    contact = make_result.contact
    off, apart = [], []
    for one in across:
        value = contact.point @ one
        order = np.unique(contact.pass_)
        widths = np.array([np.ptp(value[contact.pass_ == number]) for number in order])
        middle = np.array([value[contact.pass_ == number].mean() for number in order])
        off.append(widths)
        apart.append(np.abs(np.diff(middle[widths < 1e-6])))
    return np.min(off, axis=0), np.concatenate(apart)


@lru_cache
def in_planes():
    return milled(block(), within_frames="planes", direction=30)


@pytest.mark.thorough
@pytest.mark.oldest
def test_planes_in_each_frame_contain_its_axis_and_leave_no_more_than_scallops():
    result, mesh = in_planes(), block()
    assert locked(result) == 2
    off, apart = planar(result, math.radians(30))
    flat = 2.0 * math.sqrt(2.0 * RADIUS * SCALLOP - SCALLOP**2)
    assert (
        off.max() < 1e-6 and apart[apart < 2.0].max() <= flat + 1e-6
    )  # on a plane the steps are those of a flat, or less
    point, normal = spread(mesh, 1500)
    above = (normal[:, 2] > -0.99) | (point[:, 2] > 1e-3)
    rest = cKDTree(centres(result)).query(point[above])[0] - RADIUS
    seen = seen_by(mesh, axes_of(result), point[above], normal[above])
    assert seen.mean() > 0.6 and rest.min() > -TOLERANCE - 0.005
    assert np.quantile(rest[seen], 0.99) <= 2 * SCALLOP + TOLERANCE


def test_passes_that_are_not_planes_would_be_noticed():
    off, _ = planar(of("block"), math.radians(30))
    assert off.max() > 1.0


def test_planes_in_frames_ask_for_frames_by_themselves():
    settings = build_settings(
        "mill", "part", {"machine": "trunnion_ac", "within_frames": "planes", "direction": 30}
    )
    assert settings.passes.passes == "frames" and settings.tool_axis.tool_axis == "auto"
