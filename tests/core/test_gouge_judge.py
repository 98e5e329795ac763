# SPDX-License-Identifier: LGPL-2.1-or-later
"""Overcuts by another library's distances along the real ways: of concave parts and of real meshes, before
and after the cure."""

import os
from functools import lru_cache
from pathlib import Path

import gouge_judge
import numpy as np
import pytest
from gouge_examples import blade_beside_hub, bowl_block, knob_in_corner, round_groove, step
from plain import build_settings
from thorough import some_in_core

from freecad_fiveaxis.core.geometry.mesh import read_stl
from freecad_fiveaxis.core.gouge import check_program
from freecad_fiveaxis.core.pipeline import job, options, solve_joints
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.cl_path import Motion

TOLERANCE = 0.01
OPTIONS = {
    "machine": "trunnion_ac", "tool_length": 120, "tool_axis": "fixed", "max_axis_angle": 60, "linearize": "on",
    "tolerance": TOLERANCE, "gouge": "report", "rest": "on",
}  # fmt: skip
"""With the map of rest material, which is drawn where a program is proven, none looks for what stays uncut while
a path is made."""

PARTS = {
    "groove": (lambda: round_groove(4.0, 24), {"direction": 0}),
    "step": (lambda: step(6.0), {"direction": 70}),
    "bowl": (lambda: bowl_block(11.0, cells=36), {"direction": 20}),
    "knob": (lambda: knob_in_corner(cells=40), {"direction": 20}),
    "blade": (lambda: blade_beside_hub(cells=40), {"direction": 20}),
}
CUTTERS = ("ball:10:40", "bull:10:2:40", "flat:6:40")
QUICK = ("groove", "step")
"""Parts on which cutters with a corner are tried in a second too."""

MESHES = Path(os.environ.get("FIVEAXIS_MESHES", "/usr/share/opencascade/data/stl"))
"""Where the meshes of Debian's occt-misc lie."""

REAL = {
    "head": (220, 10),
    "motor": (60, 8),
    "propeller": (200, 30),
    "bearing": (40, 5),
    "video_part": (70, 12),
}
"""Stepover and diameter, mm."""


def milled(mesh, **options):
    return job.make(build_settings("mill", "part", {**OPTIONS, **options}), mesh=mesh)


def both(result):
    """What the check says of the cuts, which blocks these are, and the judge's verdict on them."""
    program, cutter = result.program, result.settings.cutter.cutter
    checked = check_program(
        result.mesh, options.tool_body(result.settings), result.kinematics, program, TOLERANCE
    )
    cuts = np.flatnonzero(np.isin(program.motion[1:], (Motion.CUT, Motion.FILL)))
    return (
        checked.cutter,
        cuts,
        gouge_judge.judged(result.mesh, cutter, result.kinematics, program.words, cuts),
    )


def agree(result):
    """Worst entries within a tenth, no block beyond its bound, and each block's deepest place where it is
    told to be."""
    found, cuts, verdict = both(result)
    assert verdict.worst == pytest.approx(found.depth[cuts].max(), rel=0.1) and verdict.worst > 10 * TOLERANCE
    assert (verdict.entry <= found.bound[cuts] + 1e-6).all()
    deep = np.flatnonzero(found.depth > 0.0)
    assert np.abs(gouge_judge.distances(result.mesh, found.place[deep])).max() < 1e-6


@pytest.mark.parametrize(
    "cutter", [CUTTERS[0], *(pytest.param(name, marks=pytest.mark.slow) for name in CUTTERS[1:])]
)
@some_in_core("part", PARTS, kept=(0, 1, 3))
def test_the_worst_overcut_of_concave_parts_is_the_judges_too(part, cutter):
    shape, options = PARTS[part]
    agree(milled(shape(), cutter=cutter, stepover=8, **options))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("part", "cutter"),
    [pytest.param(part, cutter, marks=[] if cutter == CUTTERS[0] or part in QUICK else pytest.mark.large)
     for part in PARTS for cutter in CUTTERS],
)  # fmt: skip
def test_after_the_lift_the_judge_finds_nothing_deeper_than_the_tolerance(part, cutter):
    shape, options = PARTS[part]
    result = milled(shape(), cutter=cutter, stepover=8, gouge="lift", **options)
    _, _, verdict = both(result)
    assert verdict.worst <= TOLERANCE and verdict.dug <= TOLERANCE
    given = milled(shape(), cutter=cutter, stepover=8, gouge="off", **options)
    assert (
        nearest(result) > min(nearest(given, 10**6), 0.0) - 0.03
    )  # no row is lifted off the part; most of this is the cloud's coarseness


def nearest(result, most=100):
    """The entry (mm) at the row on the part, of at most so many, that stands farthest off it."""
    path, inner = result.path, gouge_judge.cloud(result.settings.cutter.cutter, rings=24)
    rows = np.flatnonzero(np.isin(path.motion, (Motion.CUT, Motion.FILL)))
    rows = rows[np.unique(np.linspace(0, len(rows) - 1, most).astype(int))]
    return gouge_judge.entries(result.mesh, path.tip[rows], path.axis[rows], inner).min()


@pytest.mark.thorough
def test_a_judge_of_a_thinner_cutter_would_disagree():
    result = milled(bowl_block(11.0, cells=36), cutter="ball:10:40", stepover=8, direction=20)
    found, cuts, _ = both(result)
    thin = gouge_judge.judged(result.mesh, Cutter(6.0, 40.0), result.kinematics, result.program.words, cuts)
    assert thin.worst < 0.9 * found.depth.max()


def test_the_judge_knows_how_deep_a_cutter_stands_in_a_floor():
    """A ball, a bull nose and a leaning flat, 0.5 mm deep in the floor of a step; the flat by the right angle
    of its edge."""
    tip, axis = np.array([[-0.0, -14.0, -0.5]]), np.array([[0.0, 0.0, 1.0]])
    for cutter in (Cutter(6.0, 30.0), Cutter(6.0, 30.0, 1.0), Cutter(6.0, 30.0, 0.0)):
        assert gouge_judge.entries(step(), tip, axis, gouge_judge.cloud(cutter, 16))[0] == pytest.approx(
            0.5, rel=0.02
        )
        assert gouge_judge.dug(step(), tip, axis, gouge_judge.skin(cutter))[0] == pytest.approx(0.5, rel=0.02)
    lean = np.radians(30.0)
    axis, tip = (
        np.array([[0.0, np.sin(lean), np.cos(lean)]]),
        np.array([[0.0, -14.0, 3.0 * np.sin(lean) - 0.5]]),
    )
    flat = Cutter(6.0, 30.0, 0.0)
    inner = gouge_judge.entries(step(), tip, axis, gouge_judge.cloud(flat, 48))[0]
    assert inner == pytest.approx(0.5 / (np.sin(lean) + np.cos(lean)), rel=0.05)
    assert gouge_judge.dug(step(), tip, axis, gouge_judge.skin(flat))[0] == pytest.approx(0.5, rel=0.02)


def measure_everywhere(mesh, tip, axis, inner):
    """What :func:`gouge_judge.entries` says, of all points of the cutter at all poses."""
    points = gouge_judge.placed(inner.point, tip, axis)
    return (inner.below - gouge_judge.distances(mesh, points.reshape(-1, 3)).reshape(points.shape[:2])).max(
        axis=1
    )


@pytest.fixture(scope="module")
def about_a_step():
    """A step, and tips and axes of tools in it, on it and off it."""
    rng = np.random.default_rng(3)
    axis = np.column_stack([rng.uniform(-0.6, 0.6, (60, 2)), np.ones(60)])
    return (
        step(),
        rng.uniform((-8.0, -8.0, -3.0), (8.0, 8.0, 8.0), (60, 3)),
        axis / np.linalg.norm(axis, axis=1)[:, None],
    )


@pytest.mark.parametrize("cutter", [Cutter(6.0, 30.0), Cutter(6.0, 30.0, 1.0), Cutter(6.0, 30.0, 0.0)])
def test_the_judge_says_the_same_where_it_leaves_cells_of_the_cutter_out(cutter, about_a_step):
    inner = gouge_judge.cloud(cutter, 12)
    np.testing.assert_allclose(
        gouge_judge.entries(*about_a_step, inner), measure_everywhere(*about_a_step, inner), atol=1e-9
    )


def test_cells_that_are_left_out_too_soon_would_be_noticed(about_a_step, monkeypatch):
    """As if no point were farther than a tenth as far from the one that its cell is asked by."""
    inner, cells = gouge_judge.cloud(Cutter(6.0, 30.0, 0.0), 12), gouge_judge._cells

    def narrow(points):
        first, cell, apart = cells(points)
        return first, cell, 0.1 * apart

    monkeypatch.setattr(gouge_judge, "_cells", narrow)
    assert (
        np.abs(gouge_judge.entries(*about_a_step, inner) - measure_everywhere(*about_a_step, inner)).max()
        > 0.01
    )


# ------------------------------------------------------------------------------------------------ real meshes


KINDS = {"ball": "ball:{0}:{1}", "bull": "bull:{0}:{2}:{1}", "flat": "flat:{0}:{1}"}

FEW = [(name, "ball") for name in REAL if name != "motor"] + [("video_part", "bull"), ("video_part", "flat")]
"""Meshes and cutters that take seconds; each of the others takes up to two minutes."""


def samples(pairs, few=FEW):
    """Parameters (mesh, cutter) of the slow ring; those that are not among the few are of the large one
    besides."""
    large = [pytest.mark.slow, pytest.mark.large]
    return [pytest.param(*pair, marks=pytest.mark.slow if pair in few else large) for pair in pairs]


EVERY = [(name, kind) for name in REAL for kind in KINDS]
LIFTED = [pair for pair in FEW if pair not in (("video_part", "flat"), ("bearing", "ball"))]
"""Those that are lifted and judged within seconds."""


def milled_real(name, kind, **options):
    """A program over one of the real meshes."""
    path = MESHES / f"{name}.stl"
    if not path.exists():
        pytest.skip(
            f"no {path}: install Debian's occt-misc, or name a folder with its meshes in FIVEAXIS_MESHES"
        )
    stepover, diameter = REAL[name]
    cutter = KINDS[kind].format(diameter, 3 * diameter, 0.2 * diameter)
    given = {"cutter": cutter, "stepover": stepover, "tool_axis": "facet_mean", "lead": "3deg", **options}
    return milled(real(path), **given)


@lru_cache(maxsize=2)
def real(path):
    """The mesh of a file, read once for the tests of it, with the trees that are made over it."""
    return read_stl(str(path))


@pytest.mark.parametrize(("name", "kind"), samples(EVERY))
def test_the_worst_overcut_of_real_meshes_is_the_judges_too(name, kind):
    agree(milled_real(name, kind))


@pytest.mark.parametrize(("name", "kind"), samples(EVERY, LIFTED))
def test_after_the_lift_the_judge_finds_nothing_in_real_meshes_either(name, kind):
    """Bearing, propeller and motor have overhangs."""
    found, cuts, verdict = both(milled_real(name, kind, gouge="lift"))
    assert verdict.worst <= TOLERANCE and verdict.dug <= TOLERANCE
    assert (verdict.entry <= found.bound[cuts] + 1e-6).all()


@pytest.mark.parametrize(("name", "kind"), samples([("propeller", "bull")]))
def test_without_rows_half_way_the_turning_axis_leads_the_cutter_into_the_part(name, kind, monkeypatch):
    """The tip is led within half the tolerance, but the machine turns the axis otherwise than on a great arc.
    (A ball does not mind: its centre is led.)"""
    monkeypatch.setattr(solve_joints, "HALVINGS", 0)
    _, _, verdict = both(milled_real(name, kind, gouge="lift"))
    assert verdict.worst > 1.5 * TOLERANCE
