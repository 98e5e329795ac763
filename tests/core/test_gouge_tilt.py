# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool tilted free: by the angle that the wall demands, smoothly, within its limits; and every cure where
none can help."""

from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest
from gouge_examples import bowl, dense_points, sampled_depth, step
from plain import build_settings
from scipy.optimize import brentq
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.geometry.mesh import from_faces, read_stl
from freecad_fiveaxis.core.gouge import check_motion, straight_motion
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.orientation.spacing_radius import scallop_of
from freecad_fiveaxis.core.orientation.strategies import AxisOptions
from freecad_fiveaxis.core.orientation.tilt import _Runs
from freecad_fiveaxis.core.passes import axes_within_limits
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.tool import parse_cutter
from freecad_fiveaxis.core.tool.body import HOLDER

WALL = 30.0
OPTIONS = {
    "machine": "trunnion_ac",
    "tool_length": 120,
    "tool_axis": "fixed",
    "max_axis_angle": 60,
    "linearize": "on",
}
LONG = {"cutter": "ball:6:24", "holder": "24x40", "max_tilt": 30}
CURES = ("report", "lift", "leave-out", "tilt")


def result_of(mesh, faces=None, **options):
    return job.make(
        build_settings("mill", "part", {**OPTIONS, "stepover": 6, **options}), mesh=mesh, faces=faces
    )


def codes(result):
    return {finding.code for finding in result.findings}


def rows_on(outcome, low, high):
    """The rows of the passes with contacts on the floor, y from ``low`` to ``high``."""
    path, y = outcome.path, outcome.path.contact[:, 1]
    return np.flatnonzero((path.pass_ >= 0) & (y > low) & (y < high) & (path.contact[:, 2] < 1.0))


@pytest.fixture(scope="module")
def along():
    """Passes along a wall, which the holder would enter on those near it, off and with the tilt."""
    return result_of(step(WALL), gouge="off", **LONG), result_of(step(WALL), gouge="tilt", **LONG)


def needed(distance):
    """The least tilt away from the wall under which the holder's rim, 21 mm above the ball's centre, touches
    the wall."""
    return brentq(lambda angle: distance + 21.0 * np.sin(angle) - 12.0 * np.cos(angle), 0.0, np.radians(60.0))


def test_beside_a_wall_the_tool_tilts_by_the_least_angle_that_frees_the_holder(along):
    outcome = along[1]
    seen = 0
    for y in np.unique(np.round(outcome.path.contact[rows_on(outcome, -12.0, -4.0), 1], 6)):
        rows = rows_on(outcome, y - 1e-3, y + 1e-3)
        middle = rows[np.abs(outcome.path.contact[rows, 0]) < 5.0]
        tilt = np.arccos(np.clip(outcome.path.axis[middle, 2], -1.0, 1.0))
        least = needed(-y - 0.04)  # the holder stays 0.05 mm off, but for the tolerance
        assert (
            np.degrees(tilt.min()) > np.degrees(least) - 0.01
            and np.degrees(tilt.max()) < np.degrees(least) + 0.4
        )
        assert (outcome.path.axis[middle, 1] < 0.0).all()  # away from the wall
        seen += len(middle)
    assert seen > 3


def test_the_tilted_program_is_free_and_a_judge_says_so_too(along):
    off, outcome = along
    result = job.prove(outcome)
    tilted = next(finding for finding in result.findings if finding.code == "tilted")
    assert (
        5.0 < tilted.value < 30.0 == pytest.approx(tilted.limit)
        and f"most by {tilted.value:.3g} deg" in tilted.text
    )
    body, points = job.tool_body(outcome.settings), dense_points(step(WALL), 1.0)
    holder = body.only(HOLDER)
    for path, free in ((off.path, False), (outcome.path, True)):
        blocks = [
            k
            for k in range(len(path.tip) - 1)
            if path.motion[k + 1] == 0 and -13.0 < path.contact[k + 1, 1] < -4.0
        ]
        worst = max(sampled_depth(holder, points, straight_motion(path.tip, path.axis), k, 5) for k in blocks)
        assert (worst <= 0.01) == free


def test_contacts_and_centres_stay_where_they_are(along):
    off, outcome = along
    centre = outcome.path.tip + 3.0 * outcome.path.axis
    for row in rows_on(off, -30.0, -4.0):
        there = off.path.tip[row] + 3.0 * off.path.axis[row]
        assert np.linalg.norm(centre - there, axis=1).min() < 1e-9


@pytest.mark.thorough
def test_rows_before_and_behind_turn_together_and_none_jumps():
    outcome = result_of(step(WALL), gouge="tilt", direction=90, **{**LONG, "max_tilt": 20})
    path = outcome.path
    first = path.pass_ == path.pass_[path.pass_ >= 0][0]
    floor = np.flatnonzero(first & (path.contact[:, 2] < 1.0))
    tilt = np.degrees(np.arccos(np.clip(path.axis[floor, 2], -1.0, 1.0)))
    way = np.abs(np.diff(path.contact[floor, 1]))
    assert tilt.max() > 5.0 and (np.abs(np.diff(tilt)) / np.maximum(way, 0.5)).max() < tilt.max() / 4.0
    lone = make_jump(tilt)
    assert (
        np.abs(np.diff(lone)) / np.maximum(way, 0.5)
    ).max() > tilt.max() / 4.0  # a row that turns alone would be noticed


def make_jump(tilt):
    alone = np.zeros_like(tilt)
    alone[tilt.argmax()] = tilt.max()
    return alone


def test_what_no_tilt_frees_is_reported_with_its_place():
    result = job.prove(result_of(step(WALL), gouge="tilt", **{**LONG, "max_tilt": 2}))
    assert {"not-freed", "holder-collision"} <= codes(result)
    reported = next(finding for finding in result.findings if finding.code == "not-freed")
    assert reported.value > 20.0 and reported.place is not None and "max-tilt" in reported.text


@pytest.mark.parametrize("gouge", ["report", "tilt"])
def test_a_holder_that_hits_advises_only_what_has_not_been_tried(gouge):
    result = job.prove(result_of(step(WALL), gouge=gouge, **{**LONG, "max_tilt": 2}))
    text = str(next(one.text for one in result.findings if one.code == "holder-collision"))
    assert ("be tilted free" in text) == (gouge == "report")
    assert ("No tilt that was tried" in text and "smaller holder" in text) == (gouge == "tilt")
    assert "longer tool" in text and "leave" in text


def test_tilted_axes_stay_within_the_rotary_limits_and_the_largest_tilt(along):
    outcome = along[1]
    assert axes_within_limits(outcome.kinematics, outcome.path.axis).all()
    assert np.degrees(np.arccos(outcome.path.axis[:, 2].min())) < 30.0 + 1e-6


def test_no_step_of_the_search_leads_beyond_the_largest_tilt():
    """Two of 0.15 rad the same way, where the largest is 0.2 and a larger one would cost less."""
    most, rows = 0.2, 4
    axis, across = np.tile([0.0, 0.0, 1.0], (rows, 1)), np.tile([1.0, 0.0, 0.0], (rows, 1))
    runs = SimpleNamespace(
        task=SimpleNamespace(max_tilt=most), axis=axis, frame=np.stack([across, np.cross(axis, across)]), weight=np.ones(rows),
        first=np.array([0]), size=np.array([rows]), is_allowed=lambda axes: np.ones(axes.shape[:2], bool),
        standing=lambda axes: axes,
        share=lambda block: 0.0 * axis[:, 0], penalty=lambda tips, axes: 1e3 * axes[:, :, 2],
        change=lambda offset, tips, axes: np.zeros((len(axes), len(axes), rows - 1)),
    )  # fmt: skip
    found = _Runs.choose_way(runs, 0.15 * across, np.array([[0.0, 0.15, -0.15], [0.0, 0.0, 0.0]]))
    np.testing.assert_allclose(found, most * across, atol=1e-12)


def test_a_tapered_flank_never_leans_into_the_facet():
    """A taper of 20 deg: the axis may stand 70 deg from the normal, no more; the first state, which is the
    given one, always."""
    lean = np.radians([0.0, 69.9, 70.1, 85.0])
    axes = np.stack([np.zeros(4), np.sin(lean), np.cos(lean)], axis=1)
    upright = np.tile([0.0, 0.0, 1.0], (2, 1))
    for taper, known in ((20.0, [True, True, False, False]), (0.0, [True, True, True, True])):
        task = SimpleNamespace(
            kinematics=chain(load_machine("trunnion_ac"), Setup()),
            cutter=SimpleNamespace(taper=np.radians(taper)),
        )
        runs = SimpleNamespace(window=np.array([0]), task=task, path=SimpleNamespace(normal=upright))
        found = _Runs.is_allowed(runs, np.repeat(axes[:, None], 2, axis=1))
        assert found[:, 0].tolist() == known and (found[:, 0] == found[:, 1]).all()
        assert _Runs.is_allowed(runs, np.repeat(axes[::-1, None], 2, axis=1))[0].all()


@pytest.mark.parametrize("cutter", ["bull:6:1:24", pytest.param("flat:6:24", marks=pytest.mark.slow)])
def test_a_cutter_with_a_ring_sits_anew_under_the_tilted_axis(cutter):
    options = {**LONG, "cutter": cutter, "stepover": 9, "holder": "30x30"}
    outcome = result_of(step(WALL), gouge="tilt", **options)
    assert "tilted" in {finding.code for finding in outcome.findings}
    rows = rows_on(outcome, -13.0, -8.0)
    lean = np.arccos(np.clip(outcome.path.axis[rows, 2], -1.0, 1.0))
    corner = outcome.settings.cutter.cutter.corner
    ring = outcome.settings.cutter.cutter.ring
    # the lowest point of a tilted ring is on the floor: hub height - ring sin(lean) - corner
    hub = outcome.path.tip[rows] + corner * outcome.path.axis[rows]
    assert lean.max() > 0.02 and hub[:, 2] - ring * np.sin(lean) - corner == pytest.approx(0.0, abs=2e-4)


@cache
def convex(path, gouge):
    """The program for a convex part, made once for all cures that are compared with it; what stays uncut,
    which changes nothing of it, is not looked for before the map of rest material."""
    options = {
        "machine": "trunnion_ac",
        "tool_length": 120,
        "stepover": 15,
        "holder": "30x30",
        "links": "over",
        "rest": "on",
    }
    return job.make(build_settings("mill", path, {**options, "gouge": gouge}))


@pytest.mark.parametrize("gouge", CURES[1:])
@some_in_core("part", ["dome", "blade", "half_cylinder"])
def test_on_convex_parts_no_cure_changes_a_bit(parts, part, gouge):
    one, two = (
        convex(str(parts / f"{part}.stl"), cure) for cure in ("report", gouge)
    )  # with "off" rapids would keep the cutter alone off the part
    assert one.nc == two.nc
    assert all(
        (getattr(one.path, name) == getattr(two.path, name)).all()
        for name in ("tip", "axis", "motion", "contact", "normal")
    )


# -------------------------------------------------------------------------------------------- the other cures


@pytest.mark.parametrize("cutter", ["bull:6:1", "flat:6"])
def test_leaving_out_looks_at_the_hub_of_a_cutter_with_a_ring(cutter):
    """Fixed upright, the hub stands a ring radius off the contact: over the shelf's edge, and in the wall
    beside the floor."""
    options = {"cutter": cutter, "direction": 90, "stepover": 8}
    before, after = (
        job.prove(result_of(step(6.0), gouge=gouge, **options)) for gouge in ("report", "leave-out")
    )
    assert "overcut" in codes(before) and "left-out" in codes(after) and "overcut" not in codes(after)
    assert len(rows_on(after.draft, -25.0, -3.5)) >= 2  # the floor away from the wall is still cut


@some_in_core(("diameter", "cure"), [(20, "lift"), (60, "lift"), (20, "leave-out")])
def test_with_divided_blocks_no_more_than_the_tolerance_is_left_on_the_real_way(parts, diameter, cure):
    options = {"tool_axis": "facet_mean", "cutter": f"ball:{diameter}", "stepover": 4, "max_axis_angle": 85}
    mesh = read_stl(str(parts / "freeform_233.stl"))
    result = job.prove(result_of(mesh, gouge=cure, **options))
    assert {"lift": "lifted", "leave-out": "left-out"}[cure] in codes(result) and "overcut" not in codes(
        result
    )


@pytest.mark.parametrize(
    ("lean", "radius"), [({"lead": 5.0}, 2.0 + 3.0 / np.sin(np.radians(5.0))), ({"tilt": 20.0}, 2.0)]
)
def test_the_scallop_of_a_stepover_is_that_of_the_effective_radius(lean, radius):
    mesh, stepover = step(1.0), 1.0
    options = AxisOptions(**{name: np.radians(angle) for name, angle in lean.items()})
    scallop = scallop_of(
        parse_cutter("bull:10:2"), mesh, mesh.normal[:, 2] > 0.9, 0.0, "facet_mean", options, stepover
    )
    assert scallop == pytest.approx(stepover**2 / (8.0 * radius), rel=0.1)
    assert abs(scallop - stepover**2 / 40.0) > 0.2 * scallop  # not that of the diameter


# ------------------------------------------------------------------------------------------------ bad cases


def everywhere(gouge):
    """The floor beside a wall, under a holder as wide as the part that begins below the wall's top."""
    mesh = step(WALL)
    floor = (mesh.normal[:, 2] > 0.9) & (mesh.vertex[mesh.face][:, :, 2].max(axis=1) < 1.0)
    return result_of(mesh, floor, cutter="ball:6:4", holder="200x30", gouge=gouge, stepover=15, max_tilt=5)


@pytest.mark.thorough
@pytest.mark.parametrize("gouge", ["report", "lift", "tilt"])
def test_a_holder_that_collides_everywhere_is_reported(gouge):
    result = job.prove(everywhere(gouge))
    assert "holder-collision" in codes(result)
    assert ("not-freed" in codes(result)) == (gouge == "tilt")


def test_leaving_out_everything_is_an_error_that_says_so():
    with pytest.raises(SettingsError, match=r"leaves nothing to cut.*deepest by"):
        everywhere("leave-out")


@pytest.mark.parametrize("gouge", CURES)
def test_a_cutter_larger_than_the_part_ends_with_a_path_or_an_error(gouge):
    mesh = bowl(8.0, 10, side=20.0)
    try:
        result = job.prove(result_of(mesh, cutter="ball:100", gouge=gouge, stepover=4))
    except SettingsError as error:
        assert gouge == "leave-out" and "leaves nothing" in str(error)
    else:
        assert {"overcut", "lifted", "left-out", "corner-not-reached", "surface-tighter-than-cutter"} & codes(
            result
        )
        assert gouge == "report" or "overcut" not in codes(result)


@some_in_core("gouge", CURES, kept=(1,))
def test_open_meshes_and_facets_that_look_inward_end_with_a_finding_or_an_error(gouge):
    mesh = step(WALL)
    turned = from_faces(mesh.vertex, mesh.face[:, ::-1])
    opened = from_faces(mesh.vertex, mesh.face[1:])
    assert {"holder-collision", "tilted", "left-out"} & codes(
        job.prove(result_of(opened, gouge=gouge, **LONG))
    )
    try:
        result = job.prove(result_of(turned, gouge=gouge, **LONG))
    except SettingsError as error:
        assert str(error)
    else:
        assert len(result.findings)


def test_blocks_of_no_length_are_cured_as_others_are():
    """A zigzag whose passes begin where the last one ended has such blocks; the check takes them for
    poses."""
    tips = np.repeat(np.array([[0.0, -6.0, 0.0], [4.0, -6.0, 0.0]]), 3, axis=0)
    swept = straight_motion(tips, np.tile([0.0, 0.0, 1.0], (6, 1)))
    body = job.tool_body(build_settings("mill", "part", {**OPTIONS, **LONG}))
    done = check_motion(step(WALL), body, swept, np.zeros(5, np.int8), 0.01)
    assert (done.above.depth > 1.0).all() and "5 blocks" in done.findings[0].text
