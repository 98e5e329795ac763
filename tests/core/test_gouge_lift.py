# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cures against gouging: what is lifted or left out is no more than the part demands, and nothing enters
afterwards."""

import importlib
import json
from dataclasses import replace

import numpy as np
import pytest
from gouge_examples import bowl, dense_points, prism, round_groove, sampled_depth, shelf, step
from plain import build_settings
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import Cancelled, SettingsError
from freecad_fiveaxis.core.base.quantity import parse_stack
from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.geometry.mesh import read_stl
from freecad_fiveaxis.core.gouge import find_entries, lift, real_motion, straight_motion
from freecad_fiveaxis.core.gouge.lift import lift_path
from freecad_fiveaxis.core.pipeline import job, solve_joints
from freecad_fiveaxis.core.pipeline.context import MillContext
from freecad_fiveaxis.core.pipeline.settings import flat_options
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import Body, body_of, frustum_piece, round_piece, way_out
from freecad_fiveaxis.core.toolpath import cl_offset as seating
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

TOLERANCE = 0.01
OPTIONS = {
    "machine": "trunnion_ac",
    "tool_length": 120,
    "tool_axis": "fixed",
    "max_axis_angle": 85,
    "linearize": "on",
}


UNASKED = {"rest": "on"}
"""What stays uncut is the matter of the map of rest material, which is drawn where a program is proven: none
looks for it while the path is made."""


def milled(mesh, **options):
    settings = build_settings("mill", "part", {**OPTIONS, "stepover": 2, **options})
    return job.make(settings, mesh=mesh)


def cl_path(tips, axis=(0.0, 0.0, 1.0)):
    n = len(tips)
    tips, axes = np.array(tips, float), np.tile(np.array(axis, float), (n, 1))
    none, motion = np.full(n, -1), np.full(n, Motion.CUT, np.int8)
    motion[0] = Motion.RAPID
    return CLPath(
        tips, axes, motion, np.where(motion == Motion.CUT, 500.0, 0.0), tips, axes, none, none, none
    )


def entering(path, mesh, body, tolerance=TOLERANCE):
    """The depth of cuts, by the check, along the path as it is commanded."""
    found = find_entries(body, facet_tree(mesh), straight_motion(path.tip, path.axis), tolerance)
    return found.depth[np.isin(path.motion[1:], (Motion.CUT, Motion.FILL))]


# ------------------------------------------------------------------------------------------------ lift


def test_a_ball_over_a_groove_that_is_too_narrow_is_lifted_onto_its_rims():
    groove, radius = 4.0, 5.0
    path = cl_path([(-5, 0, -4), (0, 0, -4), (5, 0, -4)])
    lifted = lift_path(path, facet_tree(round_groove(groove)), body_of(Cutter(2 * radius)), TOLERANCE)
    touching = np.sqrt(radius**2 - groove**2) - radius  # the tip when both rims touch
    assert lifted.path.tip[:, 2] == pytest.approx(touching, abs=TOLERANCE)
    assert (
        lifted.lift == pytest.approx(touching + 4.0, abs=TOLERANCE)
        and (lifted.path.tip[:, :2] == path.tip[:, :2]).all()
    )
    finding = lifted.path.findings[-1]
    assert finding.code == "lifted" and finding.value == pytest.approx(touching + 4.0, abs=TOLERANCE)
    assert not entering(lifted.path, round_groove(groove), body_of(Cutter(2 * radius))).any()


def test_lifting_says_how_far_it_is_and_can_be_stopped_at_each_word():
    path, tree, body, message = (
        cl_path([(-5, 0, -4), (0, 0, -4), (5, 0, -4)]),
        facet_tree(round_groove(4.0)),
        body_of(Cutter(10.0)),
        [],
    )
    lift_path(path, tree, body, TOLERANCE, progress=lambda *reported: message.append(reported))
    done = [fraction for _, fraction in message]
    assert (
        {stage for stage, _ in message} == {"lift"}
        and done == sorted(done)
        and done[-1] == 1.0
        and len(set(done)) > 5
    )
    for last in range(0, len(message), 9):
        words = iter(range(len(message)))

        def stop(stage, fraction, words=words, last=last):
            if next(words) == last:
                raise Cancelled("stopped")

        with pytest.raises(Cancelled):
            lift_path(path, tree, body, TOLERANCE, progress=stop)


@pytest.mark.slow
def test_over_a_step_rows_are_put_in_so_that_no_block_cuts_the_edge():
    mesh, radius = step(6.0), 3.0
    path = cl_path([(0, -9, 0), (0, 6, 0), (0, 9, 0)])
    body = body_of(Cutter(2 * radius, 20.0))
    lifted = lift_path(path, facet_tree(mesh), body, TOLERANCE)
    assert len(lifted.path.tip) > 3 and not entering(lifted.path, mesh, body).any()
    y, z = lifted.path.tip[:, 1], lifted.path.tip[:, 2]
    over = np.clip(-y, 0.0, radius)
    demanded = np.where(y > -radius, 6.0 - (radius - np.sqrt(radius**2 - over**2)), 0.0)
    assert (z <= demanded + TOLERANCE).all()  # no row is higher than the edge demands
    points = dense_points(mesh, 0.5)
    swept = straight_motion(lifted.path.tip, lifted.path.axis)
    assert max(sampled_depth(body, points, swept, k, 7) for k in range(len(swept))) <= TOLERANCE


def test_the_rows_between_are_needed():
    """Without them, the judge finds the edge in the cutter."""
    body, points = body_of(Cutter(6.0, 20.0)), dense_points(step(6.0), 0.5)
    swept = straight_motion(np.array([(0, -9.0, 0), (0, 6.0, 6.0)]), np.tile([0.0, 0, 1], (2, 1)))
    assert sampled_depth(body, points, swept, 0, 41) > 1.0


def cuts_of_no_length(path):
    cuts = np.isin(path.motion[1:], (Motion.CUT, Motion.FILL))
    return int((cuts & (np.linalg.norm(np.diff(path.tip, axis=0), axis=1) < 1e-4)).sum())


@pytest.mark.thorough
def test_no_rows_are_put_in_that_stand_on_each_other():
    outcome = milled(step(), cutter="flat:8:40", stepover=4, direction=70, gouge="lift", **UNASKED)
    assert any(finding.code == "lifted" for finding in outcome.findings)
    assert cuts_of_no_length(outcome.path) == 0


@pytest.mark.thorough
def test_without_room_below_the_aim_rows_are_put_in_for_nothing(monkeypatch):
    """A row that enters by the whole aim has blocks beside it that enter by a hair more, however short they
    are."""
    monkeypatch.setattr(lift, "ROOM", 1.0)
    outcome = milled(step(), cutter="flat:8:40", stepover=4, direction=70, gouge="lift", **UNASKED)
    assert cuts_of_no_length(outcome.path) > 10


def test_rows_half_way_stand_on_the_commanded_way_and_lead_where_the_next_does():
    path = cl_path([(0, 0, 0), (0, 2, 0), (0, 6, 2)])
    axes = np.array([(0.0, 0.0, 1.0), (0.0, 0.0, 1.0), (0.0, np.sin(0.4), np.cos(0.4))])
    path = replace(path, axis=axes, face=np.array([4, 5, 6]))
    outcome = solve_joints._halve_blocks(path, np.array([2]))
    assert outcome.tip.tolist() == [[0, 0, 0], [0, 2, 0], [0, 4, 1], [0, 6, 2]] and outcome.face.tolist() == [
        4,
        5,
        6,
        6,
    ]
    np.testing.assert_allclose(outcome.axis[2], (0.0, np.sin(0.2), np.cos(0.2)), atol=1e-12)
    assert outcome.motion.tolist() == [*path.motion.tolist(), Motion.CUT]


def context_of(**options):
    settings = build_settings(
        "mill", "part", {**OPTIONS, "stepover": 2, "cutter": "ball:6:20", "gouge": "lift", **options}
    )
    mesh = step()
    return MillContext(
        settings, None, None, None, mesh.box, lambda *_: None, mesh, np.ones(len(mesh.face), bool)
    )


@pytest.mark.parametrize("options", [{"gouge": "report"}, {"linearize": "off"}])
def test_no_rows_are_put_half_way_into_a_path_that_is_only_looked_at_or_whose_blocks_stay_whole(
    options, monkeypatch
):
    path, driven = cl_path([(0, 0, 0), (0, 2, 0)]), []
    monkeypatch.setattr(solve_joints, "drive", lambda _, path, entering: driven.append((path, entering)))
    given, joints = solve_joints.drive_free(context_of(**options), path, 0.003)
    assert given is path and joints is None and driven == [(path, 0.003)]


def test_rows_are_put_half_way_into_a_path_that_no_cure_has_changed(monkeypatch):
    """The machine may lead the cutter into the part though nothing of the path had to be lifted."""
    path, entering = cl_path([(0, 0, 0), (0, 2, 0)]), iter([np.array([1]), np.array([], int)])
    monkeypatch.setattr(solve_joints, "_entering", lambda *_: next(entering))
    monkeypatch.setattr(solve_joints, "drive", lambda _, path, entering: len(path.tip))
    given, joints = solve_joints.drive_free(context_of(), path, 0.0)
    assert not path.findings and given.tip.tolist() == [[0, 0, 0], [0, 1, 0], [0, 2, 0]] and joints == 3


UNDER_A_ROOF = [(0, -20, 0), (0, -10, 0), (0, 5, 0), (0, 10, 0), (0, 14, 0), (0, 25, 16)]
"""Tips of a short ball of radius 2 that is free on the floor under the shelf's roof, until the wall comes too
near."""


@pytest.mark.slow
def test_rows_under_a_roof_from_which_no_way_leads_up_are_lifted_above_it():
    mesh, body, path = shelf(), body_of(Cutter(4.0, 6.0)), cl_path(UNDER_A_ROOF)
    lifted = lift_path(path, facet_tree(mesh), body, TOLERANCE)
    assert not entering(lifted.path, mesh, body).any()
    y, z = lifted.path.tip[:, 1], lifted.path.tip[:, 2]
    over = np.clip(-y, 0.0, 2.0)  # the roof's edge at y = 0 and the ball: no row is higher than they demand
    demanded = np.where(y > -2.0, 16.0 - (2.0 - np.sqrt(4.0 - over**2)), 0.0)
    assert z == pytest.approx(demanded, abs=2 * TOLERANCE)
    points, swept = dense_points(mesh, 0.5), straight_motion(lifted.path.tip, lifted.path.axis)
    assert max(sampled_depth(body, points, swept, k, 41) for k in range(len(swept))) <= TOLERANCE


@pytest.mark.slow
def test_without_a_look_above_the_way_goes_through_the_roof(monkeypatch):
    monkeypatch.setattr(lift, "OVERHANGS", 0)
    mesh, body = shelf(), body_of(Cutter(4.0, 6.0))
    lifted = lift_path(cl_path(UNDER_A_ROOF), facet_tree(mesh), body, TOLERANCE)
    assert entering(lifted.path, mesh, body).max() > 1.5


UNDER_AND_OUT = [(0, -20, 30), (0, -20, 0), (0, -10, 0), (0, 5, 0), (0, 10, 0), (0, 10, 30)]
"""A cut that ends under the shelf's roof, with the ways down to it and straight up from it."""


def linked_path(tips):
    path = cl_path(tips)
    motion = path.motion.copy()
    motion[[1, -1]] = Motion.LINK
    return replace(path, motion=motion)


@pytest.mark.thorough
def test_a_cut_that_ends_under_a_roof_is_lifted_above_it_before_the_tool_leaves():
    mesh, body = shelf(), body_of(Cutter(4.0, 6.0))
    lifted = lift_path(linked_path(UNDER_AND_OUT), facet_tree(mesh), body, TOLERANCE)
    y, z = lifted.path.tip[1:-1, 1], lifted.path.tip[1:-1, 2]
    over = np.clip(-y, 0.0, 2.0)
    demanded = np.where(y > -2.0, 16.0 - (2.0 - np.sqrt(4.0 - over**2)), 0.0)
    assert z == pytest.approx(demanded, abs=2 * TOLERANCE)
    points, swept = dense_points(mesh, 0.5), straight_motion(lifted.path.tip, lifted.path.axis)
    assert max(sampled_depth(body, points, swept, k, 41) for k in range(len(swept))) <= TOLERANCE


@pytest.mark.parametrize("direction", [0, pytest.param(90, marks=pytest.mark.slow)])
@some_in_core("gouge", ["lift", "leave-out"])
def test_from_under_a_roof_no_link_goes_through_it(gouge, direction):
    outcome = milled(shelf(), cutter="ball:4:6", stepover=4, direction=direction, gouge=gouge)
    assert not {"overcut", "rapid-collision"} & {f.code for f in job.prove(outcome).findings}
    body, points, swept = (
        body_of(Cutter(4.0, 6.0)),
        dense_points(shelf(), 0.8),
        real_motion(outcome.kinematics, outcome.program.words),
    )
    assert max(sampled_depth(body, points, swept, k, 9) for k in range(len(swept))) <= TOLERANCE
    some = outcome.path.contact[outcome.path.motion == Motion.CUT]
    assert (some[:, 1] < -3.0).any() and (some[:, 2] > 15.9).any()  # beside the roof and on it all is cut


@some_in_core("gouge", ["lift", "leave-out"])
def test_without_a_look_above_the_ends_a_link_goes_through_the_roof(gouge, monkeypatch):
    cure = importlib.import_module(f"freecad_fiveaxis.core.gouge.{gouge.replace('-', '_')}")
    monkeypatch.setattr(cure, "is_under", lambda *given: np.zeros(len(given[2]), np.bool_))
    outcome = milled(shelf(), cutter="ball:4:6", stepover=4, gouge=gouge)
    assert "rapid-collision" in {f.code for f in job.prove(outcome).findings}


def test_where_all_is_under_a_roof_leave_out_says_what_to_do():
    cave = prism([(0, -5), (20, -5), (20, 16), (0, 16), (0, 12), (15, 12), (15, 0), (0, 0)])
    floor = (cave.vertex[cave.face][:, :, 2] == 0.0).all(axis=1)
    with pytest.raises(
        SettingsError, match=r"leaves nothing to cut: the tool could not get out along its axis on every pass"
    ):
        job.make(
            build_settings("mill", "part", {**OPTIONS, "cutter": "ball:4:6", "gouge": "leave-out"}),
            mesh=cave,
            faces=floor,
        )


@pytest.mark.slow
@pytest.mark.parametrize(
    "body",
    [
        Body((round_piece(2.0, 1.0, 1.0), frustum_piece(1.0, 3.0, 25.0, 3.0))),
        Body((frustum_piece(0.0, 3.0, 25.0, 3.0),)),
        Body((round_piece(0.0, 1.0, 1.0), frustum_piece(1.0, 1.0, 20.0, 4.0))),
    ],
    ids=["bull", "flat", "taper"],
)
def test_other_cutters_are_lifted_too(body):
    mesh = step(6.0)
    path = cl_path([(0, -4.0, 0.0), (0, -2.0, 0.0), (0, 2.0, 0)], (0.1, 0.0, np.sqrt(0.99)))
    lifted = lift_path(path, facet_tree(mesh), body, 0.1)
    assert lifted.lift.max() > 5.0 and not entering(lifted.path, mesh, body, 0.1).any()


def test_the_way_out_of_a_cutter_is_where_a_drop_cutter_stops():
    rng = np.random.default_rng(3)
    body = Body((round_piece(2.0, 1.0, 1.0), frustum_piece(1.0, 3.0, 10.0, 6.0)))
    points = rng.uniform((-7, -7, -2), (7, 7, 9), (500, 3))
    tip, axis = np.zeros((500, 3)), np.tile([0.0, 0.0, 1.0], (500, 1))
    by = way_out(body, tip, axis, points)
    radius = np.hypot(points[:, 0], points[:, 1])
    over = np.clip(radius - 2.0, 0.0, 1.0)
    low = np.where(
        radius <= 3.0,
        1.0 - np.sqrt(1.0 - over**2),
        np.where(radius <= 6.0, 1.0 + (radius - 3.0) * 3.0, np.inf),
    )
    assert by == pytest.approx(np.maximum(points[:, 2] - low, 0.0), abs=1e-12)


def test_where_nothing_enters_the_path_stays_the_same_object():
    outcome = milled(step(6.0), tool_axis="facet_mean", direction=90, cutter="ball:6")
    lifted = lift_path(outcome.path, facet_tree(outcome.mesh), body_of(Cutter(6.0)), TOLERANCE)
    assert lifted.path is outcome.path and not lifted.lift.any()


@some_in_core("part", ["dome", "half_cylinder"], kept=(1,))
def test_convex_parts_are_posted_byte_for_byte_as_without_the_check(parts, part):
    options = {
        "machine": "trunnion_ac",
        "tool_length": 120,
        "stepover": 12,
        "linearize": "on",
        "links": "over",
        **UNASKED,
    }
    bytes_of = lambda gouge: (  # noqa: E731
        job.make(build_settings("mill", str(parts / f"{part}.stl"), {**options, "gouge": gouge})).nc
    )
    assert bytes_of("lift") == bytes_of("off") == bytes_of("leave-out")


RINGS = (
    {"cutter": "bull:10:2"},
    {"cutter": "bull:10:2", "lead": 0},
    {"cutter": "taperbull:8:1:5deg"},
    {"cutter": "flat:10"},
)


def over_sharp_edges(parts, part, gouge, **options):
    """A path round the edges of a part that is cut on all sides, so that its hub swings over them."""
    given = {
        "machine": "trunnion_ac",
        "origin": (0, 40, 0),
        "stepover": 12,
        "lead": 8,
        "linearize": "off",
        "links": "over",
        **options,
    }
    return job.make(build_settings("mill", str(parts / f"{part}.stl"), {**given, "gouge": gouge}))


@some_in_core(
    "options",
    [*RINGS[:2], *(pytest.param(ring, marks=pytest.mark.slow) for ring in RINGS[2:])],
    ids=[" ".join(map(str, options.values())) for options in RINGS],
)
@pytest.mark.parametrize("part", ["dome", pytest.param("half_cylinder", marks=pytest.mark.slow)])
def test_round_sharp_edges_of_convex_parts_no_cure_touches_a_ring_cutter(parts, part, options):
    off, lift, out = (
        over_sharp_edges(parts, part, gouge, **options, **UNASKED) for gouge in ("off", "lift", "leave-out")
    )
    assert off.nc == lift.nc == out.nc


@pytest.mark.thorough
@some_in_core("options", RINGS[:2], ids=["lead 8", "lead 0"])
def test_divided_within_the_tolerance_of_the_tip_the_ring_swings_farther_and_is_kept_out_all_the_same(
    parts, options
):
    """Blocks that are short enough for the tip are not for the ring: that takes rows half-way, though no row
    is lifted."""
    report, lift = (
        job.prove(over_sharp_edges(parts, "dome", gouge, linearize="on", **options))
        for gouge in ("report", "lift")
    )
    assert report.gouge.cutter.depth.max() > 1.2 * report.draft.settings.proof.tolerance
    assert not lift.gouge.cutter.depth.any() and "lifted" not in {finding.code for finding in lift.findings}
    assert len(lift.draft.path.tip) < 1.05 * len(report.draft.path.tip)


@pytest.mark.slow
def test_without_rows_along_the_hubs_swing_the_edge_is_cut(parts, monkeypatch):
    """The comparison above can fail: the straight swing dips the bottom's rim into the edge."""
    monkeypatch.setattr(seating, "_swing_hubs", lambda path, axis, *_: (path, axis))
    lifted = over_sharp_edges(parts, "dome", "lift", cutter="bull:10:2", **UNASKED)
    assert "lifted" in {finding.code for finding in lifted.findings}


# ----------------------------------------------------------------------------------------------- the pipeline


@pytest.mark.parametrize(
    ("mesh", "cutter"),
    [
        (round_groove(4.0, side=12.0, length=12.0), "ball:10"),
        pytest.param(bowl(15.0, 30), "ball:20", marks=pytest.mark.slow),
    ],
    ids=["groove", "bowl"],
)
@some_in_core("gouge", ["lift", "leave-out"])
def test_after_the_cure_the_program_does_not_enter_on_its_real_way(mesh, cutter, gouge):
    before = job.prove(milled(mesh, cutter=cutter, gouge="report"))
    assert "overcut" in {f.code for f in before.findings}
    outcome = milled(mesh, cutter=cutter, gouge=gouge)
    assert len(outcome.axis) == len(outcome.offset.point)
    after = job.prove(outcome)
    assert not {"overcut", "rapid-collision", "buried"} & {f.code for f in after.findings}
    assert {"lift": "lifted", "leave-out": "left-out"}[gouge] in {f.code for f in after.findings}
    swept = real_motion(outcome.kinematics, outcome.program.words)
    points = dense_points(mesh, 0.8)
    blocks = np.random.default_rng(0).permutation(len(swept))[:40]
    cutter = body_of(outcome.settings.cutter.cutter)
    assert max(sampled_depth(cutter, points, swept, int(k), 5) for k in blocks) <= TOLERANCE


@pytest.mark.thorough
def test_where_the_machine_leaves_a_cured_path_the_overcut_says_so():
    """The axis turns from facet to facet of a coarse bowl, and the tip swings between the ends of blocks."""
    for gouge, helps in (
        ("report", "gouge lift, leave-out"),
        ("lift", "path itself is free of the part there"),
    ):
        options = {"cutter": "ball:20", "stepover": 4, "tool_axis": "facet_mean", "linearize": "off"}
        outcome = milled(bowl(15.0, 8), gouge=gouge, **options)
        message = [f.text for f in job.prove(outcome).findings if f.code == "overcut"]
        assert message and all(helps in text and "linearize on" in text for text in message)


@pytest.mark.thorough
@some_in_core("diameter", [20, 60])
def test_the_worst_overcut_of_a_wavy_patch_is_the_judges_too(parts, diameter):
    mesh = read_stl(str(parts / "freeform_233.stl"))
    outcome = milled(mesh, tool_axis="facet_mean", cutter=f"ball:{diameter}", stepover=4, gouge="report")
    worst = max((f for f in job.prove(outcome).findings if f.code == "overcut"), key=lambda f: f.value)
    body, swept = (
        Body(body_of(outcome.settings.cutter.cutter).pieces[:1]),
        real_motion(outcome.kinematics, outcome.program.words),
    )
    points = dense_points(mesh, 0.4)
    assert sampled_depth(body, points, swept, worst.block - 1, 21) == pytest.approx(worst.value, rel=0.02)
    others = np.random.default_rng(1).choice(len(swept), 30, replace=False)
    assert max(sampled_depth(body, points, swept, int(k), 5) for k in others) <= 1.011 * worst.value


@pytest.mark.slow
def test_a_path_driven_by_the_centre_is_lifted_as_that_of_the_tip():
    options = {"cutter": "ball:10", "gouge": "lift", **UNASKED}
    by_tip, by_centre = (
        milled(round_groove(4.0), **options),
        milled(round_groove(4.0), control_point="centre", **options),
    )
    assert by_centre.path.tip - 5.0 * by_centre.path.axis == pytest.approx(by_tip.path.tip, abs=1e-9)


def test_a_holder_is_checked_and_its_block_and_line_are_reported():
    outcome = milled(step(30.0), cutter="ball:6:10", gouge="report", holder="50x30", direction=90)
    found = [f for f in job.prove(outcome).findings if f.code == "holder-collision"]
    assert found and found[0].line == outcome.program.line[found[0].block] and found[0].value > 1.0


def test_stacks_are_read_with_units_and_written_back():
    assert parse_stack("40x25, 0.5inx1in") == ((40.0, 25.0), (12.7, 25.4))
    settings = build_settings(
        "mill", "a.stl", {"machine": "trunnion_ac", "holder": "40x25,63x50", "shank": "8x20"}
    )
    assert settings.gouge.holder == ((40.0, 25.0), (63.0, 50.0))
    again = build_settings(
        "mill", "a.stl", {k: v for k, v in flat_options(settings).items() if k not in ("task", "source")}
    )
    assert again.gouge == settings.gouge


@pytest.mark.parametrize("text", ["40", "40x", "x40", "40x0", "-4x5", "40x25,", "40x1e9"])
def test_a_stack_that_cannot_be_read_is_refused(text):
    with pytest.raises(SettingsError, match="holder"):
        build_settings("mill", "a.stl", {"machine": "trunnion_ac", "holder": text})


def test_the_command_line_tells_an_overcut_and_lifts_it(tmp_path, parts, capsys):
    common = [
        "mill",
        str(parts / "freeform_233.stl"),
        "--machine",
        "trunnion_ac",
        "--cutter",
        "ball:40",
        "--stepover",
        "6",
    ]
    common += [
        "--linearize",
        "on",
        "--passes",
        "planes",
        "--holder",
        "63x40",
        "-o",
        str(tmp_path / "a.ngc"),
        "--report",
        str(tmp_path / "a.json"),
    ]
    assert main([*common, "--gouge", "report"]) == 1
    reported = json.loads((tmp_path / "a.json").read_text())
    assert (
        "overcut" in {finding["code"] for finding in reported["findings"]}
        and reported["inputs"]["holder"] == "63x40"
    )
    assert main([*common, "--gouge", "lift", "--quiet"]) == 0
    assert "too deep into the part" in capsys.readouterr().out


def test_where_the_controller_guides_the_tip_its_straight_way_is_checked():
    options = {"cutter": "ball:10", "gouge": "report", "linearize": "off"}
    by_joints, guided = (
        job.prove(milled(round_groove(4.0), **options, rtcp=rtcp)) for rtcp in ("off", "angles")
    )
    worst = [max(f.value for f in result.findings if f.code == "overcut") for result in (by_joints, guided)]
    assert guided.draft.program.guided is not None and worst[1] == pytest.approx(worst[0], rel=0.03)
