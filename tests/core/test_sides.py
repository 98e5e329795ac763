# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sides of the part that no pass touches: told with place, area and a remedy that helps."""

import re

import numpy as np
import pytest
from gouge_examples import prism
from mesh_shapes import box, sphere
from plain import build_settings
from test_verdict import filleted
from thorough import some_in_core

from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.geometry.mesh import from_triangles
from freecad_fiveaxis.core.gouge import find_rest_material, program_motion
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.tool.body import body_of


def block():
    return from_triangles(box((0.0, 0.0, 0.0), (60.0, 35.0, 20.0)))


def fine_block():
    """The same block, its facets divided until none is longer than a few mm: as a mesher gives it, or a
    scanner."""
    corner = box((0.0, 0.0, 0.0), (60.0, 35.0, 20.0))
    for _ in range(5):
        middle = 0.5 * (corner + np.roll(corner, -1, axis=1))
        parts = [np.stack([corner[:, k], middle[:, k], middle[:, k - 1]], axis=1) for k in range(3)]
        corner = np.concatenate([*parts, middle])
    return from_triangles(corner)


def drafted():
    """A block whose side at Y 30 leans in by 0.1 mm over 20 mm: planes nearer than that cut it."""
    return prism([(0, 0), (30.0, 0), (29.9, 20), (0, 20)])


def make_result(mesh, faces=None, **options):
    given = {"machine": "trunnion_ac", "cutter": "ball:8", "gouge": "off", "stepover": 3, **options}
    return job.make(
        build_settings("mill", "part.stl", {k: v for k, v in given.items() if v}), mesh=mesh, faces=faces
    )


def sides(result):
    return [one for one in result.findings if one.code == "side-not-machined"]


@pytest.mark.parametrize("part", [block, fine_block])
@pytest.mark.parametrize(
    ("direction", "where", "area"), [(0, ("Y 0", "Y 35"), 1200.0), (90, ("X 0", "X 60"), 700.0)]
)
def test_the_sides_along_the_passes_are_reported_with_their_area(part, direction, where, area):
    reported = sides(make_result(part(), direction=direction))
    assert sorted(one.text.split(" is not")[0] for one in reported) == [f"The side at {one}" for one in where]
    for one in reported:
        assert (
            one.severity is Severity.WARNING
            and one.unit == "mm2"
            and one.value == pytest.approx(area, rel=1e-9)
        )
        axis, at = "XYZ".index(where[0][0]), float(re.search(r"[XY] (\d+)", one.text).group(1))
        assert one.place[axis] == pytest.approx(at, abs=1e-9), "its marker stands on that side"
        assert all(
            0.0 < value < high
            for k, (value, high) in enumerate(zip(one.place, (60, 35, 20), strict=True))
            if k != axis
        )


@some_in_core("part", [block, fine_block, filleted])
@pytest.mark.parametrize("direction", [0, 90])
def test_who_follows_the_remedy_sees_the_side_cut(part, direction):
    """By another route: what the cutter leaves at the middle of the side, before and after."""
    mesh = part()
    before = make_result(mesh, direction=direction, stepover=1, cutter="ball:4")
    reported = sides(before)
    assert reported
    for one in reported:
        better = float(re.search(r"in direction ([\d.]+) deg", one.text).group(1))
        after = make_result(mesh, direction=better, stepover=1, cutter="ball:4")
        assert one.text.split(":")[0] not in [other.text.split(":")[0] for other in sides(after)]
        assert rest_at(before, one.place) > 0.5 > 0.3 > rest_at(after, one.place)


def rest_at(result, place):
    """mm that stay at the sample of the surface nearest to a place."""
    facets = np.linalg.norm(result.mesh.vertex[result.mesh.face].mean(axis=1) - place, axis=1) < 1e-9
    assert facets.sum() == 1
    cuts = np.flatnonzero(result.program.motion[1:] <= 1)
    course, body = program_motion(result.kinematics, result.program), body_of(result.settings.cutter.cutter)
    rest = find_rest_material(result.mesh, body, course, cuts, 1.0, facets)
    return rest.height[np.linalg.norm(rest.point - place, axis=1).argmin()]


@some_in_core("part", [block, fine_block])
def test_passes_that_cut_every_side_leave_nothing_to_tell(part):
    assert not sides(make_result(part(), direction=45)) and not sides(make_result(part(), direction=20))


@some_in_core(("stepover", "caps"), [(0.5, 2), (3.9, 0)])
def test_strips_between_passes_are_no_sides_but_caps_beyond_the_outermost_are(stepover, caps):
    ball = from_triangles(sphere(20.0, rows=80, columns=160))
    for direction in (0, 33):
        reported = sides(make_result(ball, stepover=stepover, direction=direction))
        assert len(reported) == caps, (
            "told where the caps beyond the outermost passes are wider than passes may lie apart"
        )
        for one in reported:
            facing = np.degrees(np.arctan2(one.place[1], one.place[0]))
            assert abs((facing - direction) % 180.0 - 90.0) < 5.0
            inset = 20.0 - 0.5 * (np.ceil(40.0 / stepover) - 1.0) * stepover
            assert one.value == pytest.approx(np.pi * 20.0 * inset, rel=0.35), (
                "half a cap's area: its lower half looks down"
            )
            assert "direction" not in one.text and "a smaller stepover would cut it" in one.text.lower()
    assert not sides(make_result(ball, stepover=None, scallop=0.02))


def test_faces_that_nobody_wants_cut_are_not_reported():
    mesh = block()
    top = mesh.normal[:, 2] > 0.5
    assert not sides(make_result(mesh, faces=top))
    one_side = make_result(mesh, faces=top | (mesh.normal[:, 1] < -0.5))
    assert [one.text.split(" is not")[0] for one in sides(one_side)] == ["The side at Y 0"]


@pytest.mark.thorough
def test_a_side_that_leans_can_be_cut_by_nearer_planes_too():
    reported = sides(make_result(drafted(), stepover=3))
    leaning, plumb = (next(one for one in reported if at in one.text) for at in ("Y 29.9", "Y 0"))
    assert "or a smaller stepover" in leaning.text and "smaller" not in plumb.text
    assert ["Y 0" in one.text for one in sides(make_result(drafted(), stepover=0.04))] == [True]


@pytest.mark.oldest
@pytest.mark.thorough
def test_where_a_side_makes_the_least_interval_bind_the_side_is_reported_instead():
    result = make_result(filleted(), stepover=None, scallop=0.01)
    codes = [one.code for one in result.findings]
    assert codes.count("side-not-machined") == 2 and "least-interval" not in codes
    assert all("Beside it up to 0.03" in one.text for one in sides(result))


def test_the_underside_is_a_note_by_its_name():
    (one,) = [one for one in make_result(block()).findings if one.code == "facets-looking-down"]
    assert one.severity is Severity.NOTE and one.value == pytest.approx(2100.0) and one.place[2] == 0.0
    assert one.text.startswith(
        "The underside at Z 0 is not machined: 2100 mm2 (26.2 % of the part) face away from the spindle."
    )


def test_where_every_direction_leaves_as_much_out_the_rest_is_named():
    """A round part of plane walls: a plumb wall is cut by no finer planes, and each direction has walls of
    its own."""
    turn = np.radians(np.arange(5.0, 365.0, 10.0))
    ring = 40.0 * np.column_stack([np.cos(turn), np.sin(turn)])
    low, high = (np.column_stack([ring, np.full(36, z)]) for z in (0.0, 20.0))
    after = np.roll(np.arange(36), -1)
    walls = [np.stack([low, low[after], high[after]], axis=1), np.stack([low, high[after], high], axis=1)]
    lids = [
        np.stack([np.tile((0.0, 0.0, z), (36, 1)), a, b], axis=1)
        for z, a, b in ((20, high, high[after]), (0, low[after], low))
    ]
    reported = sides(make_result(from_triangles(np.concatenate([*walls, *lids])), stepover=1))
    assert len(reported) == 2
    for one in reported:
        assert "in direction" in one.text and "smaller" not in one.text
        assert re.search(r"cut the [\d.]+ mm2 that lie along those passes with another path", one.text)
