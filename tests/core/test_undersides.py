# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets that look down are cut, and cutter, shank and holder get there and away again: by the check of the
program, and by points of the tool's skin set on the forward kinematics of interpolated words."""

import json
from pathlib import Path

import gouge_judge
import numpy as np
import pytest
from plain import build_settings
from thorough import some_in_core
from underside_parts import PARTS

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.gouge.check import GOUGES
from freecad_fiveaxis.core.motion.joint_path import rewind
from freecad_fiveaxis.core.passes import facets_within_limits
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.options import tip_to_driven, tool_body
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import body_of, body_support, lower_body, swing_support
from freecad_fiveaxis.core.toolpath.cl_path import Motion, keepout, path

TOOL = {"cutter": "ball:6:20", "shank": "6x15", "holder": "40x30", "stepover": 4.0, "order": "one_way"}
MACHINE = {
    "trunnion_ac": {"machine": "trunnion_ac", "max_axis_angle": 120, "passes": "planes"},
    "fork_head_bc": {"machine": "fork_head_bc", "tool_length": 65, "max_axis_angle": 180, "passes": "zlevel"},
}
FILES = Path(__file__).resolve().parents[2] / "resources" / "machines"
STEP = 1.0
"""mm that the tip goes between two places that are looked at."""
TURN = 2.0
"""deg that a rotary word turns between them."""


def milled(part, name, **options):
    return job.make(build_settings("mill", part, {**TOOL, **MACHINE[name], **options}), mesh=PARTS[part]())


def skin(body, step=3.0):
    """Points (k, 3) mm of the tool's skin about z, tip at 0: of every piece the rims, the side and both
    ends."""
    points = []
    for low, low_radius, high, high_radius, corner, *_ in body.pieces:
        up = np.linspace(0.0, 1.0, int(np.ceil((high - low) / step)) + 2)
        outline = [
            np.column_stack([low_radius + up * (high_radius - low_radius) + corner, low + up * (high - low)])
        ]
        outline += [
            np.column_stack([np.linspace(0.0, r, 6), np.full(6, z)])
            for r, z in ((low_radius, low), (high_radius, high))
        ]
        bend = np.linspace(-np.pi / 2, 0.0, 5)
        outline.append(np.column_stack([low_radius + corner * np.cos(bend), low + corner * np.sin(bend)]))
        radius, height = np.concatenate(outline).T
        turn = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)[:, None]
        points.append(
            np.stack([radius * np.cos(turn), radius * np.sin(turn), height + 0.0 * turn], axis=-1).reshape(
                -1, 3
            )
        )
    return np.concatenate(points)


def samples(result, motion):
    """Blocks (n,) with this motion, and shares (n,) of them, close enough to each other."""
    program = result.program
    words, blocks = program.words, np.flatnonzero(program.motion[1:] == motion)
    tip = gouge_judge.poses(result.kinematics, words, blocks, np.zeros(len(blocks)))[0]
    end = gouge_judge.poses(result.kinematics, words, blocks, np.ones(len(blocks)))[0]
    turn = np.abs(words[blocks + 1, 3:] - words[blocks, 3:]).max(axis=1)
    count = np.ceil(np.maximum(np.linalg.norm(end - tip, axis=1) / STEP, turn / TURN)).astype(int) + 2
    return gouge_judge.spread(blocks, count)


def skin_at(result, block, u):
    """Places of the tool's skin (n, k, 3) mm at shares (n,) of blocks (n,)."""
    pose = gouge_judge.poses(
        result.kinematics, result.program.words, block, u, tip_to_driven(result.settings)
    )
    return gouge_judge.placed(skin(tool_body(result.settings)), *pose)


def batches(block, u):
    """The same in batches of some 500."""
    some = len(block) // 500 + 1
    return zip(np.array_split(block, some), np.array_split(u, some), strict=True)


def nearest_to_box(result):
    """How far (mm) the tool keeps off the part's box on rapids; negative inside, by so much as it is in from
    the nearest side. The skin is no nearer than the box about all that is as near to the tool's axis as its
    widest point: where that is nearest the skin is asked first, until none of the others can be nearer."""
    (block, u), points = samples(result, Motion.RAPID), skin(tool_body(result.settings))
    tip, axis = gouge_judge.poses(
        result.kinematics, result.program.words, block, u, tip_to_driven(result.settings)
    )
    ends = [tip + height * axis for height in (points[:, 2].min(), points[:, 2].max())]
    low, high = result.mesh.box
    apart = np.maximum(low - np.maximum(*ends), np.minimum(*ends) - high).max(axis=1)
    bound = apart - np.hypot(points[:, 0], points[:, 1]).max()
    order, nearest = np.argsort(bound, kind="stable"), np.inf
    for some in np.array_split(order, len(order) // 100 + 1):
        if bound[some].min() < nearest:
            at = skin_at(result, block[some], u[some])
            nearest = min(nearest, np.maximum(low - at, at - high).max(axis=2).min())
    return nearest


def deepest_link(result):
    """How deep (mm) the tool's skin is in the part on links, by libigl's distances to the mesh; 0 where it
    stays out. Of a closed part only what is in its box can be in it: nothing else is asked."""
    low, high = result.mesh.box
    deepest = 0.0
    for some in batches(*samples(result, Motion.LINK)):
        at = skin_at(result, *some)
        inside = at[((at >= low) & (at <= high)).all(axis=2)]
        if len(inside):
            deepest = max(deepest, -gouge_judge.distances(result.mesh, inside, signed=True).min())
    return deepest


def gouges(result):
    """Codes of the errors of a program that say where the tool enters the part."""
    return {
        one.code
        for one in job.prove(result).findings
        if one.severity == Severity.ERROR and one.code in GOUGES
    }


def starts(result):
    return {one.code for one in result.findings} & {"start-through-part"}


@some_in_core("links", ["over", "near"], kept=(1,))
@some_in_core("machine", list(MACHINE))
@some_in_core("part", list(PARTS))
def test_the_whole_tool_gets_there_and_away(part, machine, links):
    result = milled(part, machine, links=links)
    assert (result.path.axis[:, 2].min() < -0.25) == (part != "block")
    assert not gouges(result) and not starts(result)
    off = result.settings.links.clearance - 2.5  # half of it for the bend of a traverse that turns
    assert nearest_to_box(result) > off
    assert deepest_link(result) <= result.settings.proof.tolerance


def machine_file(folder, name, **limits):
    """A machine of ours with other limits, deg, of its rotary axes."""
    reported = json.loads((FILES / f"{name}.fcm").read_text())
    for letter, (low, high) in limits.items():
        reported["machine"]["axes"][letter]["limits"] = {"min": low, "max": high}
    path = folder / f"{name}.fcm"
    path.write_text(json.dumps(reported))
    return str(path)


@some_in_core("passes", ["scallop", "planes"])
@some_in_core("name, letter", [("trunnion_ac", "A"), ("fork_head_bc", "B")])
def test_a_machine_that_turns_right_round_cuts_the_underside(tmp_path, name, letter, passes):
    machine = machine_file(tmp_path, name, **{letter: (-180.0, 180.0)})
    result = milled(
        "mushroom", name, machine=machine, max_axis_angle=180, passes=passes, scallop=0.3, stepover=None
    )
    assert result.path.axis[:, 2].min() == pytest.approx(-1.0) and result.keep.all()
    assert not gouges(result) and not starts(result)
    assert nearest_to_box(result) > result.settings.links.clearance - 2.5


def rewinding(folder, links):
    """The mushroom on a machine that has to turn back inside cuts."""
    machine = machine_file(folder, "trunnion_ac", C=(-170.0, 190.0), A=(0.0, 120.0))
    result = milled("mushroom", "trunnion_ac", machine=machine, links=links, passes="zlevel", stepover=7.0)
    assert any(one.code == "rewind" for one in result.findings)
    return result


def test_rewinds_between_cuts_keep_the_whole_tool_off(tmp_path):
    machine = machine_file(tmp_path, "trunnion_ac", C=(-200.0, 200.0), A=(0.0, 120.0))
    result = milled("mushroom", "trunnion_ac", machine=machine, links="near", passes="zlevel", stepover=7.0)
    assert {"rewinds-between-cuts"} <= {one.code for one in result.findings} and not gouges(result)
    assert nearest_to_box(result) > result.settings.links.clearance - 2.5


@pytest.mark.thorough
@some_in_core("links", ["over", "near"], kept=(1,))
def test_rewinds_keep_the_whole_tool_off_too(tmp_path, links):
    result = rewinding(tmp_path, links)
    assert not gouges(result)
    assert nearest_to_box(result) > result.settings.links.clearance - 2.5


def test_both_judges_see_a_rewind_that_only_looks_after_the_ball(tmp_path, monkeypatch):
    monkeypatch.setattr(rewind, "tool_keepout", ball_only)
    result = rewinding(tmp_path, "near")
    assert "holder-collision" in gouges(result)
    assert nearest_to_box(result) < 0.0


def ball_only(low, high, radius, clearance, body, axis):
    """The keep-out of the ball alone, which was that of the whole tool once."""
    keep = keepout(low, high, radius, clearance)
    return keep._replace(safe=np.full(len(axis), keep.safe))


@pytest.mark.thorough
@some_in_core(
    "part, name",
    [
        ("tee", "trunnion_ac"),
        ("block", "fork_head_bc"),
        ("tee", "fork_head_bc"),
        ("mushroom", "fork_head_bc"),
    ],
)
def test_both_judges_see_a_holder_that_only_the_ball_looks_after(part, name, monkeypatch):
    monkeypatch.setattr(path, "tool_keepout", ball_only)
    monkeypatch.setattr(rewind, "tool_keepout", ball_only)
    result = milled(part, name, links="over")
    assert "holder-collision" in gouges(result)
    assert nearest_to_box(result) < 0.0


def test_a_program_begins_and_ends_upright_however_its_passes_stand():
    result = milled("tee", "trunnion_ac", passes="zlevel")
    assert result.path.axis[[0, -1], 2].min() > -1e-4


def test_facets_that_look_down_further_than_requested_are_left_out():
    mesh = PARTS["tee"]()
    up = mesh.normal[:, 2]
    for angle in (90.0, 106.0, 166.0, 180.0):
        keep, found = facets_within_limits(mesh, None, np.radians(angle))
        assert np.array_equal(keep, up >= np.cos(np.radians(angle)) - 1e-4)
        assert [one.code for one in found] == ["facets-looking-down"] * (angle < 180.0)
    with pytest.raises(SettingsError, match="at most 180 deg"):
        facets_within_limits(mesh, None, np.radians(181.0))


def test_supports_are_those_of_points_of_the_skin():
    body = lower_body(body_of(Cutter(6.0, 20.0), [(6.0, 15.0)], [(40.0, 30.0)]), 3.0)
    points = skin(body, 0.5)
    lean = np.linspace(0.0, np.pi, 61)
    reach = (np.outer(np.cos(lean), points[:, 2]) + np.outer(np.sin(lean), points[:, 0])).max(axis=1)
    np.testing.assert_allclose(body_support(body, np.cos(lean)), reach, atol=0.06)
    most = np.array([reach[k:].max() for k in range(len(lean))])
    np.testing.assert_allclose(swing_support(body, np.cos(lean)), most, atol=0.06)
