# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reach map beside fixtures: a wall next to a block, against dense samples of both in the tool with every
axis tried and with others; the command line, where a fixture far away changes nothing and one in the part is
refused."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest
from gouge_examples import dense_points, sampled_depth
from mesh_shapes import box

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge import still_positions
from freecad_fiveaxis.core.gouge.fixture_in_part import PRESSED, find_common, find_deep, report_in_part
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.machine_check import InMachine
from freecad_fiveaxis.core.gouge.machine_in_pose import machine_in_pose
from freecad_fiveaxis.core.gouge.obstacles import Obstacle, Reacher, tip_at
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.studies import reach_map as module
from freecad_fiveaxis.core.studies.reach_map import TILTS, choose_trial_axes, reach_map
from freecad_fiveaxis.core.tool import Cutter

BLOCK = from_triangles(box((0, 0, 0), (30, 24, 20)))
WALL = Fixture("wall", from_triangles(box((34, -4, 0), (42, 28, 44))))
"""4 mm beside the block, 24 mm higher than its top: a ball of 6 mm does not get between them."""
LOW_WALL = Fixture("low wall", from_triangles(box((34, -4, 0), (42, 28, 8))))
BALL = Cutter(6.0, 16.0)
TOOL = Reacher(BALL, holder=((20.0, 40.0),), most=math.radians(89.0))
SPARE = 0.15
"""mm: what lies as near as that is told apart by no samples 0.4 mm apart."""


@pytest.fixture(autouse=True)
def coarse(monkeypatch):
    monkeypatch.setattr(module, "PLACES", 150)


def depths(meshes, reacher, point, normal, axes):
    """How deep (n, d) mm the meshes are in the tool by dense samples, of n places with d axes each."""
    points = np.concatenate([dense_points(one, 0.4) for one in meshes])
    many = axes.shape[1]
    place, across = np.repeat(point, many, axis=0), np.repeat(normal, many, axis=0)
    axis = axes.reshape(-1, 3)
    swept = still_positions(tip_at(reacher.cutter, place, across, axis), axis)
    found = [sampled_depth(reacher.body, points, swept, k, 1) for k in range(len(axis))]
    return np.array(found).reshape(-1, many)


def all_axes(normal):
    """Every axis (n, d, 3) that the map tries at places with these normals."""
    return np.concatenate([choose_trial_axes(normal, tilt, 0.0) for tilt in TILTS], axis=1)


@pytest.mark.thorough
@pytest.mark.oldest
def test_what_the_wall_keeps_the_tool_from_is_what_dense_samples_of_every_axis_say():
    """At places of each kind on the block: where the map says *fixture*, some axis that is wanted keeps the
    part out of the tool, and all that do have the wall in it; where it says *reachable*, its axis keeps both
    out. The wall is the only reason: without it the tool gets everywhere that the part allows."""
    found, alone = reach_map(BLOCK, TOOL, fixtures=[WALL]), reach_map(BLOCK, TOOL)
    held, free = (np.flatnonzero(found.obstacle == one) for one in (Obstacle.FIXTURE, Obstacle.NONE))
    assert len(held) > 20 and len(free) > 100 and (alone.obstacle[held] == Obstacle.NONE).all()
    assert set(found.obstacle[found.obstacle != alone.obstacle]) == {int(Obstacle.FIXTURE)}
    for rows in (held[:: len(held) // 3], free[:: len(free) // 6]):
        point, normal = found.point[rows], BLOCK.normal[found.facet[rows]]
        if found.obstacle[rows[0]] == Obstacle.NONE:
            axes = found.axis[rows][:, None]
            assert depths([BLOCK, WALL.mesh], TOOL, point, normal, axes).max() <= 0.01 + 1e-9
            continue
        axes = all_axes(normal)
        wanted = axes[:, :, 2] >= math.cos(TOOL.most)
        in_part, in_wall = (depths([one], TOOL, point, normal, axes) for one in (BLOCK, WALL.mesh))
        may = wanted & (in_part <= SPARE)
        assert may.any(axis=1).all() and (in_wall[may] > 0.0).all()


@pytest.mark.thorough
def test_where_no_axis_of_a_sphere_of_them_is_free_the_map_says_so_too():
    """A second set of axes, even over the sphere: what none of them frees the map does not call reachable, and
    what many of them free it does."""
    found = reach_map(BLOCK, TOOL, fixtures=[WALL])
    rows = np.flatnonzero(BLOCK.normal[found.facet][:, 0] > 0.5)  # the side that looks at the wall
    rows = np.concatenate([rows[:: max(1, len(rows) // 6)], np.flatnonzero(found.point[:, 2] > 19.9)[::20]])
    step = np.arange(60)
    up, turn = 1.0 - (step + 0.5) / 60, step * math.pi * (3.0 - math.sqrt(5.0))
    sphere = np.stack([np.sqrt(1 - up**2) * np.cos(turn), np.sqrt(1 - up**2) * np.sin(turn), up], axis=1)
    sphere = sphere[up >= math.cos(TOOL.most)]
    axes = np.broadcast_to(sphere, (len(rows), *sphere.shape))
    deep = depths([BLOCK, WALL.mesh], TOOL, found.point[rows], BLOCK.normal[found.facet[rows]], axes)
    never, often = (deep > SPARE).all(axis=1), (deep <= 0.01).mean(axis=1) > 0.1
    assert never.sum() > 3 and (found.obstacle[rows[never]] == Obstacle.FIXTURE).all()
    assert often.sum() > 3 and (found.obstacle[rows[often]] == Obstacle.NONE).all()


def test_the_area_beside_a_wall_that_the_ball_does_not_pass_is_that_of_the_closed_form():
    """A cutter alone, wall and block 4 mm apart, the wall 8 mm high: the ball of radius 3 that touches the
    side at Z z lies 1 mm deep in the wall's face up to Z 8, and above as long as its middle, 1 mm from the
    face, is nearer than 3 mm to the edge at (34, 8). Upright it is (34 - 33) from it: up to 8 + sqrt(8) mm.
    Leaning away from the wall does not help a ball."""
    reacher = Reacher(Cutter(6.0, 60.0), most=math.radians(89.0))
    side = BLOCK.normal[:, 0] > 0.5
    found = reach_map(BLOCK, reacher, side, fixtures=[LOW_WALL])
    z = found.point[:, 2]
    assert (found.obstacle[z < 8.0 + math.sqrt(8.0) - 0.1] == Obstacle.FIXTURE).all()
    assert (found.obstacle[z > 8.0 + math.sqrt(8.0) + 0.1] == Obstacle.NONE).all()
    assert found.without == ((("low wall", pytest.approx(found.area_of(Obstacle.FIXTURE))),))
    assert reach_map(BLOCK, reacher, side).without == ()


@pytest.mark.oldest
@pytest.mark.thorough
def test_of_two_fixtures_each_is_reported_with_what_it_alone_keeps_the_tool_from():
    """Behind one wall another: to take away the farther one frees nothing, nor the nearer one what both
    stand over. A clamp on the other side is its own."""
    clamp = Fixture("clamp", from_triangles(box((-12, 8, 0), (-3, 16, 30))))
    behind = Fixture("behind", from_triangles(box((36, -4, 0), (44, 28, 44))))
    tool, sides = replace(TOOL, most=math.radians(40.0)), BLOCK.normal[:, 2] > -0.5

    def reached(*fixtures):
        return reach_map(BLOCK, tool, sides, fixtures=fixtures)

    found = dict(reached(WALL, clamp).without)
    each = {one.name: reached(one).area_of(Obstacle.FIXTURE) for one in (WALL, clamp)}
    assert found == pytest.approx(each, rel=0.15) and min(each.values()) > 50.0
    both = dict(reached(WALL, behind).without)
    assert "behind" not in both and both.get("wall", 0.0) < 0.9 * each["wall"]


def test_a_longer_tool_helps_where_only_the_holder_meets_the_fixture():
    """A wall 6 mm higher than the holder, 20 mm wide, stands where the tip is on the block: 10 mm more get over
    it, 5 mm do not."""
    far_wall = Fixture("far wall", from_triangles(box((37, -4, 0), (60, 28, 36))))
    reacher = replace(TOOL, most=math.radians(1.0), cutter=Cutter(6.0, 10.0))
    found = reach_map(BLOCK, reacher, BLOCK.normal[:, 2] > 0.5, fixtures=[far_wall])
    held = found.area_of(Obstacle.FIXTURE)
    assert held > 20.0 and found.area_of(Obstacle.HOLDER) == 0.0
    assert found.longer[-1][1] == pytest.approx(held) and found.longer[0][0] == 10.0


def test_what_the_spindle_hits_of_a_fixture_is_the_fixtures_and_not_the_machines():
    """A nose of a spindle 35 mm in radius close above a short tool, and a wall 12 mm beside the block that is
    as high: without the tool's length it is not known where the nose is."""
    nose = MachineBody("nose", "spindle", "cylinder", ((0, 0, 0), (0, 0, 80)), radii=(35.0,))
    machine = replace(load_machine("trunnion_ac"), bodies=(nose,))
    wall = Fixture("wall", from_triangles(box((42, -4, 0), (60, 28, 60))))
    reacher = Reacher(Cutter(6.0, 30.0), most=math.radians(1.0))
    kinds = {}
    for length in (30.0, None):
        setup = Setup((0.0, 0.0, 0.0), length or 0.0)
        given = InMachine(machine, setup, chain(machine, setup), reacher.body, length, fixtures=(wall,))
        pose = machine_in_pose(given, BLOCK, 0.01)
        held = replace(reacher, kinematics=chain(machine, setup), machine=pose)
        found = reach_map(BLOCK, held, BLOCK.normal[:, 2] > 0.5, fixtures=[wall])
        kinds[length] = {Obstacle(one) for one in found.obstacle}
    assert kinds == {30.0: {Obstacle.FIXTURE, Obstacle.NONE}, None: {Obstacle.NONE}}


@pytest.fixture
def files(tmp_path):
    write_stl(BLOCK, tmp_path / "block.stl")
    write_stl(WALL.mesh, tmp_path / "wall.stl")
    write_stl(from_triangles(box((0, 0, 0), (8, 32, 44))), tmp_path / "own.stl")
    return tmp_path


FLAGS = ["--machine", "trunnion_ac", "--cutter", "ball:6:16", "--holder", "20x40"]


def reach(files, capsys, *more, code=cli.DONE):
    """What the terminal says, and the record without the inputs."""
    report = files / "r.json"
    assert cli.main(["reach", str(files / "block.stl"), *FLAGS, *more, "--report", str(report)]) == code
    record = json.loads(report.read_text())
    record.pop("inputs")
    return capsys.readouterr().out, record


@pytest.mark.thorough
@pytest.mark.oldest
def test_the_command_line_names_the_fixture_as_a_reason_with_its_area(files, capsys):
    text, record = reach(files, capsys, "--fixture", str(files / "wall.stl"))
    area = record["summary"]["by_reason"]["fixture"]
    assert area > 100.0 and "fixture in the way" in text
    assert "Without the fixture wall.stl the tool reaches about" in text
    (one,) = record["summary"]["without_fixture"]
    assert one["fixture"] == "wall.stl" and one["area"] == pytest.approx(area, rel=0.2)
    placed, same = reach(files, capsys, "--fixture", f"{files / 'own.stl'}@34,-4,0")
    assert same["summary"]["by_reason"] == record["summary"]["by_reason"] and "own.stl@34,-4,0" in placed


def test_a_fixture_far_away_changes_no_byte_of_the_report(files, capsys):
    assert reach(files, capsys) == reach(files, capsys, "--fixture", f"{files / 'own.stl'}@300,0,0")


@pytest.mark.oldest
@pytest.mark.thorough
def test_a_job_file_takes_it_relative_to_itself(files, capsys):
    given = {"task": "reach", "source": "block.stl", "machine": "trunnion_ac", "cutter": "ball:6:16"}
    given |= {"holder": "20x40", "fixture": ["own.stl@34,-4,0"], "report": ["job.json.out.json"]}
    (files / "job.json").write_text(json.dumps(given))
    assert cli.main(["run", str(files / "job.json")]) == cli.DONE
    capsys.readouterr()
    record = json.loads((files / "job.json.out.json").read_text())
    assert record["summary"]["by_reason"]["fixture"] > 100.0
    assert record["inputs"]["fixture"] == [f"{files}/own.stl@34,-4,0"]


@pytest.mark.parametrize("place", ["10,4,10", "-1,0,-10", "nowhere"])
def test_a_fixture_that_stands_in_the_part_or_nowhere_is_one_line_with_exit_code_2(files, capsys, place):
    report = files / "never.json"
    given = ["--fixture", f"{files / 'own.stl'}@{place}", "--report", str(report)]
    assert cli.main(["reach", str(files / "block.stl"), *FLAGS, *given]) == cli.UNUSABLE
    (line,) = capsys.readouterr().err.strip().splitlines()
    assert "own.stl" in line and "--fixture" in line and not report.exists()
    assert ("stands in the part" in line) == (place != "nowhere")


def test_in_the_part_is_what_lies_deeper_in_it_than_a_jaw_is_pressed():
    def shifted(x, size=(8, 32, 44)):
        return from_triangles(box((x, -4, 0), (x + size[0], -4 + size[1], size[2])))

    for x in (30.0, 30.0 - 0.9 * PRESSED):
        assert find_deep(shifted(x), BLOCK) is None and find_deep(BLOCK, shifted(x)) is None, "it touches"
    for mesh in (shifted(30.0 - 1.5 * PRESSED), from_triangles(box((-9, -9, -9), (60, 60, 60)))):
        assert find_deep(BLOCK, mesh) is not None
    pin = from_triangles(box((14, 11, -5), (16, 13, 40)))
    x, y, z = find_deep(pin, BLOCK)
    assert 14 <= x <= 16 and 11 <= y <= 13 and 0.0 < z < 20.0
    assert find_deep(from_triangles(BLOCK.vertex[BLOCK.face][2:] + 4.0), BLOCK) is not None
    assert find_deep(pin, from_triangles(BLOCK.vertex[BLOCK.face][2:])) is None, "an open part has no inside"


@pytest.mark.parametrize("larger", [0.0, 0.5 * PRESSED, -0.5 * PRESSED])
def test_the_part_itself_and_what_is_little_larger_or_smaller_is_no_fixture(larger):
    low, high = BLOCK.box
    twin = from_triangles(box(low - larger, high + larger))
    assert find_deep(twin, BLOCK) is None and find_deep(BLOCK, twin) is None
    x, y, z = find_common(twin, BLOCK) or find_common(BLOCK, twin)
    assert ((np.array((x, y, z)) - low) > PRESSED).all() and ((high - (x, y, z)) > PRESSED).all()
    (found,) = report_in_part(BLOCK, [Fixture("own.stl", twin)])
    assert found.code == "fixture-in-part" and "own.stl stands in the part" in found.text


def test_jaws_on_all_sides_have_nothing_in_common_with_the_part():
    low, high = BLOCK.box
    for axis in range(3):
        for side in (low - 5.0, high):
            end = np.where(np.arange(3) == axis, side, low - 3.0)
            jaw = from_triangles(box(end, np.where(np.arange(3) == axis, side + 5.0, high + 3.0)))
            assert find_common(BLOCK, jaw) is None is find_common(jaw, BLOCK)
    assert find_common(BLOCK, from_triangles(BLOCK.vertex[BLOCK.face][2:])) is None, (
        "an open one has no inside"
    )
