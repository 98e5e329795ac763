# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sketch of a machine: every body stands and moves as its axis does, and the table never meets its
part."""

from __future__ import annotations

import numpy as np
import pytest
from five_kinds import KINDS, kinematics_of
from test_playback import random_words, shipped

from freecad_fiveaxis.core.machine import Axis, Machine, list_shipped_machines, load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.report.machine_sketch import Box, Cylinder, ToolRoom, corners, sketch
from freecad_fiveaxis.core.report.playback import placements, sides

TOOL = ToolRoom(90.0, 20.0)
PART = np.array([-30.0, -20.0, -5.0]), np.array([42.0, 25.0, 28.0])
CLOSE = 1e-9  # mm
REVERSED = {  # a table on a table whose platter stands upright; a head that swings before it tilts
    "upright platter": (
        Axis("A", True, "table", (1, 0, 0), (0, 0, 80)), Axis("B", True, "table", (0, 1, 0), (0, 0, -90)), *KINDS["table_table"][2:]
    ),
    "gimbal": (*KINDS["head_head"][:3], Axis("A", True, "head", (1, 0, 0), (0, 0, 260)), Axis("B", True, "head", (0, 1, 0), (0, 0, 200))),
    "nutating head": (
        *KINDS["head_head"][:3], Axis("C", True, "head", (0, 0, 1)), Axis("B", True, "head", (0, 0.6, 0.8), (0, 0, 180))
    ),
}  # fmt: skip


@pytest.fixture(params=[*sorted(list_shipped_machines()), *KINDS, *REVERSED])
def kinematics(request):
    if request.param in REVERSED:
        return chain(Machine(request.param, REVERSED[request.param]), Setup((0.0, 0.0, 0.0), 150.0))
    return kinematics_of(request.param) if request.param in KINDS else shipped(request.param)


def holds(shape, points, skin=1e-6):
    """Which of the points (n, 3) lie inside a shape, at least ``skin`` mm deep."""
    if isinstance(shape, Box):
        return (np.abs((points - shape.centre) @ shape.along.T) < shape.half - skin).all(axis=1)
    axis = shape.end - shape.start
    length = np.linalg.norm(axis)
    along = (points - shape.start) @ axis / length
    across = np.linalg.norm(points - shape.start - along[:, None] * axis / length, axis=1)
    return (along > skin) & (along < length - skin) & (across < shape.radius - skin)


def about(line, direction, angle):
    """The turn (4, 4) about a line by Euler's formula, written out by itself."""
    x, y, z = direction
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn = (
        np.outer(direction, direction)
        + np.cos(angle) * (np.eye(3) - np.outer(direction, direction))
        + np.sin(angle) * cross
    )
    placement = np.eye(4)
    placement[:3, :3], placement[:3, 3] = turn, line - turn @ line
    return placement


def test_what_an_axis_carries_moves_as_the_axes_below_it(kinematics):
    """From the base outwards: a table axis moves what it carries the other way round than its word says (ISO
    841)."""
    words = random_words(kinematics)
    carried = placements(kinematics, words)["machine_from_carried"]
    for row in range(len(words)):
        for side, sign in zip(sides(kinematics), (-1.0, 1.0), strict=True):
            placement = np.eye(4)
            for axis in side[::-1] if sign < 0.0 else side:
                if axis < 3:
                    move = np.eye(4)
                    move[:3, 3] = sign * words[row, axis] * kinematics.direction[axis]
                else:
                    point = (kinematics.point1, kinematics.point2)[axis - 3]
                    move = about(point, kinematics.direction[axis], sign * np.radians(words[row, axis]))
                placement = placement @ move
                assert np.abs(carried[row, axis] - placement).max() < CLOSE


def test_the_platter_carries_the_work_and_the_spindle_the_tool(kinematics):
    words = random_words(kinematics)
    placed = placements(kinematics, words)
    bodies = {body.name: body for body in reversed(sketch(kinematics, *PART, TOOL))}
    for name, last, whole in (
        ("spindle", sides(kinematics)[1], "machine_from_tool"), ("platter", sides(kinematics)[0][:1], "machine_from_work"),
    ):  # fmt: skip
        if name in bodies and last and (name == "spindle" or bodies[name].carrier == last[0]):
            assert bodies[name].carrier == last[-1]
            assert np.abs(placed["machine_from_carried"][:, last[-1]] - placed[whole]).max() < CLOSE


def test_every_machine_has_a_spindle_and_a_table_and_the_bodies_its_rotary_axes_ask_for(kinematics):
    bodies = sketch(kinematics, *PART, TOOL)
    names = {body.name for body in bodies}
    table, head = ([axis for axis in side if axis >= 3] for side in sides(kinematics))
    assert {"spindle", "ram"} <= names
    assert ("table" in names) == (not table) and ("platter" in names) == bool(table)
    assert ("cradle" in names) == (len(table) == 2) and ("fork" in names) == bool(head)
    assert all({body.carrier for body in bodies} >= {axis} for axis in (*table, *head))
    for body in bodies:
        assert np.isfinite(corners(body.shape)).all()
        size = (
            body.shape.half
            if isinstance(body.shape, Box)
            else (body.shape.radius, np.linalg.norm(body.shape.end - body.shape.start))
        )
        assert min(size) > 0.1


def test_a_rotary_body_of_revolution_lies_on_its_line(kinematics):
    """The platter about the table axis next to the work, the cradle's pins about its own."""
    for body in sketch(kinematics, *PART, TOOL):
        if body.name == "platter" or (
            body.name == "cradle" and isinstance(body.shape, Cylinder) and body.carrier == 4
        ):
            line, direction = (
                (kinematics.point1, kinematics.point2)[body.carrier - 3],
                kinematics.direction[body.carrier],
            )
            if (
                body.name == "cradle"
                and abs(direction @ (body.shape.end - body.shape.start))
                < np.linalg.norm(body.shape.end - body.shape.start) - 1e-6
            ):
                continue  # the neck of a nutating table stands along the platter's axis
            for end in (body.shape.start, body.shape.end):
                assert np.linalg.norm(np.cross(end - line, direction)) < 1e-9


def test_the_table_meets_its_part_nowhere_between_the_limits(kinematics):
    """The part as a cloud of points, which the platter carries; cradle and base as they stand against it."""
    rng = np.random.default_rng(11)
    cloud = PART[0] + rng.random((4000, 3)) * (PART[1] - PART[0])
    bodies = [
        body
        for body in sketch(kinematics, *PART, TOOL)
        if body.name in ("platter", "table", "cradle", "base")
    ]
    low, high = (np.clip(limit[3:], -np.pi, np.pi) for limit in (kinematics.low, kinematics.high))
    words = np.zeros((40, 5))
    words[1:, 3:] = np.degrees(low + rng.random((39, 2)) * (high - low))
    words[:, 3:][:, [axis not in sides(kinematics)[0] for axis in (3, 4)]] = 0.0
    placed = placements(kinematics, words)
    for row in range(len(words)):
        part = cloud @ placed["machine_from_work"][row, :3, :3].T + placed["machine_from_work"][row, :3, 3]
        for body in bodies:
            placement = (
                np.eye(4) if body.carrier is None else placed["machine_from_carried"][row, body.carrier]
            )
            inside = holds(body.shape, (part - placement[:3, 3]) @ placement[:3, :3])
            assert not inside.any(), f"{body.name} at {words[row, 3:]}: {inside.sum()} points of the part"


def test_a_body_in_the_part_would_be_noticed():
    body = next(one for one in sketch(shipped("trunnion_ac"), *PART, TOOL) if one.name == "platter")
    assert holds(
        body.shape, np.array([[0.0, 0.0, PART[0][2] - 1.0], [0.0, 0.0, PART[0][2] + 1.0]])
    ).tolist() == [True, False]


def test_the_platter_lies_under_the_part_and_has_room_for_it_wherever_it_is_clamped():
    kinematics = shipped("trunnion_ac")
    for shift in (np.zeros(3), np.array([150.0, -80.0, 30.0])):
        body = next(
            one for one in sketch(kinematics, PART[0] + shift, PART[1] + shift, TOOL) if one.name == "platter"
        )
        assert body.shape.end == pytest.approx([0.0, 0.0, PART[0][2] + shift[2]])
        assert body.shape.radius > np.linalg.norm((PART[1] + np.abs(shift))[:2])


def test_limits_that_swing_less_need_less_room():
    machine = load_machine("trunnion_ac")
    axes = [
        Axis(**{**{k: getattr(a, k) for k in ("letter", "rotary", "side", "direction", "point", "high", "max_rate", "wrap")}, "low": a.low if a.letter != "A" else -0.2, "high": a.high if a.letter != "A" else 0.2})
        for a in machine.axes
    ]  # fmt: skip
    floor = [
        min(
            corners(body.shape)[:, 2].min()
            for body in sketch(chain(one, Setup()), *PART, TOOL)
            if body.name == "base"
        )
        for one in (machine, Machine("still", tuple(axes)))
    ]
    assert floor[0] < floor[1] - 5.0


@pytest.mark.parametrize(("table", "face"), [(None, -5.0), (-30.0, -30.0), (10.0, -5.0)])
def test_the_face_stands_where_the_machine_file_says_but_never_in_the_part(table, face):
    for name in ("trunnion_ac", "head_b_table_c", "fork_head_bc"):
        (body,) = [
            one for one in sketch(shipped(name), *PART, TOOL, table) if one.name in ("platter", "table")
        ]
        assert corners(body.shape)[:, 2].max() == pytest.approx(face)


@pytest.mark.parametrize("name", ["trunnion_ac", "mikron_ucp710"])
def test_a_part_above_the_table_stands_on_a_riser_and_does_not_float(name):
    low, high = PART
    bodies = sketch(shipped(name), low, high, TOOL, float(low[2]) - 40.0)
    (riser,) = [body for body in bodies if body.name == "riser"]
    (platter,) = [body for body in bodies if body.name == "platter"]
    ends = corners(riser.shape)
    assert riser.carrier == platter.carrier
    assert np.allclose((ends[:, 2].min(), ends[:, 2].max()), (low[2] - 40.0, low[2])) and np.isclose(
        platter.shape.end[2], low[2] - 40.0
    )
    assert (ends[:, :2] >= low[:2]).all() and (ends[:, :2] <= high[:2]).all()


@pytest.mark.parametrize("table", [None, float(PART[0][2]), float(PART[1][2])])
def test_a_part_on_the_table_needs_no_riser(table):
    assert "riser" not in {body.name for body in sketch(shipped("trunnion_ac"), *PART, TOOL, table)}


def test_a_part_above_a_plain_table_stands_on_a_riser():
    plain = next(one for one in sorted(KINDS) if one.startswith("head"))
    bodies = sketch(kinematics_of(plain), *PART, TOOL, float(PART[0][2]) - 10.0)
    assert [body.carrier for body in bodies if body.name == "riser"] == [
        body.carrier for body in bodies if body.name == "table"
    ]
    assert any(body.name == "riser" for body in bodies)
