# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool and spindle against bodies of the machine: by dense samples of the joints' way, with turns of their
own, and by closed forms."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from mesh_shapes import box
from scipy.spatial.transform import Rotation
from thorough import some_in_core

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.findings import Hit
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.fixtures import Fixture
from freecad_fiveaxis.core.gouge.machine_check import InMachine, check_machine, zero_words
from freecad_fiveaxis.core.gouge.machine_in_pose import machine_in_pose
from freecad_fiveaxis.core.machine import load_machine, machine_bytes, save_machine
from freecad_fiveaxis.core.machine.bodies import MachineBody
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward, words_to_q
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.tool.body import Body, frustum_piece, round_piece
from freecad_fiveaxis.core.toolpath.cl_path import Motion

EXAMPLE = Path(__file__).resolve().parents[2] / "resources" / "machines" / "trunnion_with_bodies.fcm"
LENGTH, RADIUS, ORIGIN = 80.0, 3.0, (10.0, -5.0, 20.0)
TOOL = Body(
    (
        round_piece(0.0, RADIUS, RADIUS),
        frustum_piece(RADIUS, RADIUS, 40.0, RADIUS),
        frustum_piece(40.0, 15.0, LENGTH, 15.0, 2),
    )
)
NOSE = MachineBody("nose", "spindle", "cylinder", ((0.0, 0.0, 0.0), (0.0, 0.0, 60.0)), (35.0,))
MACHINES = ("trunnion_ac", "head_b_table_c", "nutating_table_b45", "fork_head_bc", "linuxcnc_xyzbc_trt")


def program_of(machine, words, motion=None):
    count = len(words)
    zero = np.zeros(count)
    return Program(
        chain(machine, Setup(ORIGIN, LENGTH)).letters, words, zero + 100.0, np.zeros(count, bool),
        np.zeros(count, np.int8) if motion is None else motion, zero + 1.0, np.arange(count), 1 + np.arange(count),
    )  # fmt: skip


def checked(machine, words, tolerance=0.01, part=None, length=LENGTH, motion=None, rapids="interpolated"):
    setup = Setup(ORIGIN, LENGTH)
    given = InMachine(machine, setup, chain(machine, setup), TOOL, length, rapids=rapids)
    return check_machine(given, program_of(machine, words, motion), part, tolerance)


EYE = np.eye(4)
EYE.setflags(write=False)


def frames(machine, q):
    """Of each axis the places (..., 4, 4) that it carries in the machine frame at joints ``q`` (letter: mm or
    deg, (...,)), and those of the tool.

    From the base outwards; a table's axis moves what it carries the other way."""
    fitted = machine.fitted
    place, found = EYE, {"base": EYE}
    for axis in [one for one in fitted[::-1] if one.side == "table"]:
        place = place @ moved(axis, -q[axis.letter])
        found[axis.letter] = place
    place = EYE
    for axis in [one for one in fitted if one.side == "head"]:
        place = place @ moved(axis, q[axis.letter])
    return found, place


def moved(axis, by):
    """The places (..., 4, 4) to which an axis takes what it carries, by (...,) mm or deg."""
    by = np.asarray(by, float)
    found = np.tile(EYE, (*by.shape, 1, 1))
    if not axis.rotary:
        found[..., :3, 3] = by[..., None] * np.array(axis.direction)
        return found
    turn = Rotation.from_rotvec(np.radians(by).reshape(-1, 1) * np.array(axis.direction)).as_matrix()
    turn = turn.reshape(*by.shape, 3, 3)
    found[..., :3, :3], found[..., :3, 3] = turn, np.array(axis.point) - turn @ axis.point
    return found


def joints_at(machine, words, origin=None):
    """Of each letter the joints (...,), mm or deg, at words (..., 5) of a tool of ``LENGTH``."""
    origin = ORIGIN if origin is None else origin
    kinematics = chain(machine, Setup(origin, LENGTH))
    gauge = np.array(machine.gauge_point) - (0, 0, LENGTH)
    shift = np.linalg.solve(kinematics.direction[:3].T, np.array(origin) - gauge)
    joints = np.asarray(words) + np.concatenate([shift, (0, 0)])
    return dict(zip(kinematics.letters, np.moveaxis(joints, -1, 0), strict=True))


def skin_of(body, count):
    """Points (n, 3) mm on a grid of the skin of a box, so many along each edge."""
    share = np.stack(np.meshgrid(*(np.linspace(0.0, 1.0, count),) * 3, indexing="ij"), -1).reshape(-1, 3)
    low, high = np.array(body.points)
    return low + share[((share == 0.0) | (share == 1.0)).any(axis=1)] * (high - low)


def dense(machine, words, body, count=160, way=None):
    """How deep a point of the box ``body`` is in the tool at most, on a straight way of the joints, or on
    that which ``way`` gives at shares (count,): by its points on a grid."""
    share = np.linspace(0.0, 1.0, count)
    carried, tool = frames(
        machine,
        joints_at(machine, words[0] + share[:, None] * (words[1] - words[0]) if way is None else way(share)),
    )
    place, gauge = carried[body.carrier], np.array(machine.gauge_point) - (0, 0, LENGTH)
    seen = np.linalg.inv(tool) @ place
    off = skin_of(body, 17) @ seen[..., :3, :3].swapaxes(-1, -2) + (seen[..., None, :3, 3] - gauge)
    height, across = off[..., 2], np.hypot(off[..., 0], off[..., 1])
    deepest = max(0.0, float((RADIUS - np.hypot(across, height - RADIUS)).max()))
    for bottom, top, radius in (
        (RADIUS, 40.0, RADIUS),
        (40.0, LENGTH, 15.0),
        (LENGTH, LENGTH + 60.0, 35.0),
    ):
        inside = np.minimum(np.minimum(height - bottom, top - height), radius - across)
        deepest = max(deepest, float(inside.max()))
    return deepest


def carriers(machine):
    return ["base", *(axis.letter for axis in machine.fitted if axis.side == "table")]


@pytest.mark.thorough
@some_in_core("name", MACHINES)
def test_dense_samples_find_nothing_deeper_than_what_is_reported(name):
    """Random boxes on each carrier and random blocks: with a straight way of the joints nothing is missed,
    and what is told is there."""
    rng, plain = np.random.default_rng(5), load_machine(name)
    hit = missed = 0
    for _ in range(24):
        carrier = rng.choice(carriers(plain))
        middle, half = rng.uniform(-25, 25, 3) + ORIGIN, rng.uniform(8, 20, 3)
        body = MachineBody("box", str(carrier), "box", (tuple(middle - half), tuple(middle + half)))
        machine = replace(plain, bodies=(body, NOSE))
        words = np.concatenate([rng.uniform(-30, 30, (2, 3)), rng.uniform(-60, 60, (2, 2))], axis=1)
        found = [one for one in checked(machine, words, 0.05) if one.code == "machine-collision"]
        sampled, reported = dense(machine, words, body), found[0].value if found else 0.0
        assert reported >= 0.98 * sampled - 0.15, (carrier, reported, sampled)
        assert reported <= sampled + 1.5, (carrier, reported, sampled)
        hit += bool(found)
        missed += not found
    assert hit > 3 and missed > 3


def test_a_locked_axis_that_is_not_locked_would_be_noticed(monkeypatch):
    from freecad_fiveaxis.core.gouge import machine_check

    monkeypatch.setattr(machine_check, "find_locked_letters", lambda machine, body: "")
    with pytest.raises(AssertionError):
        test_dense_samples_find_nothing_deeper_than_what_is_reported("trunnion_ac")


def test_the_depth_in_a_column_is_that_of_the_closed_form():
    """The holder, 15 mm in radius, stops 12 mm before a wall of the base, on a trunnion whose table has
    turned meanwhile."""
    plain = load_machine("trunnion_ac")
    column = MachineBody("column", "base", "box", ((40.0, -200.0, -100.0), (140.0, 200.0, 400.0)))
    machine = replace(plain, bodies=(column,))
    setup, words = Setup((0.0, 0.0, 0.0), LENGTH), np.zeros((2, 5))
    kinematics = chain(machine, setup)
    words[0, 0], words[1, 0] = -20.0, 28.0
    for column_of, turned in ((3, 70.0), (4, 200.0)):
        words[:, column_of] = turned if kinematics.letters[column_of] == "C" else 0.0
    found = check_machine(
        InMachine(machine, setup, kinematics, TOOL, LENGTH), program_of(plain, words), None, 0.01
    )
    assert [one.code for one in found] == ["machine-collision"]
    assert (
        found[0].value == pytest.approx(3.0, abs=0.15)
        and found[0].line == 2
        and "holder" in found[0].text
        and "column" in found[0].text
    )
    assert found[0].hit == Hit("holder", "column", pytest.approx(1.0, abs=0.01))
    assert found[0].hit == Hit("holder", "column", pytest.approx(1.0, abs=0.01))


def test_the_spindle_is_kept_out_of_part_and_bodies_and_needs_the_tools_length():
    plain = load_machine("trunnion_ac")
    machine = replace(
        plain,
        bodies=(
            NOSE,
            MachineBody("post", "base", "cylinder", ((60.0, 0.0, 0.0), (60.0, 0.0, 120.0)), (10.0,)),
        ),
    )
    part = from_triangles(box((-60.0, -60.0, 0.0), (-40.0, -40.0, 110.0)) + ORIGIN)
    words = np.zeros((2, 5))
    words[:, :3] = -np.array(ORIGIN)
    words[0, 2], words[1, 0], words[1, 1] = 200.0, -30.0 - ORIGIN[0], -30.0
    words[1, 2] = 0.0
    found = checked(machine, words, part=part)
    assert (
        [one.code for one in found] == ["machine-collision"]
        and "spindle" in found[0].text
        and "part" in found[0].text
    )
    assert (found[0].hit.enters, found[0].hit.entered) == ("spindle", "")
    assert (found[0].hit.enters, found[0].hit.entered) == ("spindle", "")
    blind = checked(machine, words, part=part, length=None)
    assert (
        [one.code for one in blind] == ["machine-unproven"]
        and "--tool-length" in blind[0].text
        and "nose" in blind[0].text
    )


def test_a_rapid_of_independent_axes_goes_another_way():
    """From beside a post to its other side at another height: interpolated it goes over it, axis by axis
    through it."""
    machine = replace(
        load_machine("trunnion_ac"),
        bodies=(
            MachineBody(
                "post",
                "base",
                "box",
                ((-10, -10, -100), (10, 10, 20)),
            ),
        ),
    )
    words = np.zeros((2, 5))
    words[:, :3] = [[-60.0, 0.0, 90.0], [60.0, 0.0, -10.0]]
    rapid = np.full(2, Motion.RAPID, np.int8)
    straight, free = (
        checked(machine, words, motion=rapid, rapids=how) for how in ("interpolated", "independent")
    )
    assert [one.code for one in free] == ["machine-collision"]
    assert not straight or straight[0].value < free[0].value


GOOD = [
    {"name": "cradle", "carrier": "A", "box": {"low": [-1, -2, -3], "high": [1, 2, 3]}},
    {"name": "platter", "carrier": "C", "cylinder": {"low": [0, 0, -10], "high": [0, 0, 0], "radius": 50}},
    {"name": "cap", "carrier": "base", "sphere": {"centre": [0, 0, 1], "radius": 2}},
    {
        "name": "nose",
        "carrier": "spindle",
        "cone": {"low": [0, 0, 0], "high": [0, 0, 30], "low_radius": 20, "high_radius": 30},
    },
    {"name": "vise", "carrier": "C", "file": "vise.stl"},
]


def machine_file(tmp_path, bodies):
    data = json.loads(machine_bytes(load_machine("trunnion_ac")))
    data["fiveaxis"]["bodies"] = bodies
    path = tmp_path / "own.fcm"
    path.write_text(json.dumps(data))
    return path


def test_bodies_are_read_and_written_as_they_are(tmp_path):
    found = load_machine(machine_file(tmp_path, GOOD))
    assert [one.name for one in found.bodies] == [one["name"] for one in GOOD]
    assert found.bodies[0].points == ((-1, -2, -3), (1, 2, 3)) and found.bodies[3].radii == (20, 30)
    assert found.bodies[4].file == str(tmp_path / "vise.stl")
    save_machine(replace(found, bodies=found.bodies[:4]), tmp_path / "again.fcm")
    assert load_machine(tmp_path / "again.fcm").bodies == found.bodies[:4]
    imperial = json.loads((tmp_path / "own.fcm").read_text())
    imperial["machine"]["units"] = "imperial"
    (tmp_path / "inch.fcm").write_text(json.dumps(imperial))
    assert load_machine(tmp_path / "inch.fcm").bodies[1].radii == (pytest.approx(1270.0),)


@pytest.mark.parametrize(
    ("body", "reported"),
    [
        ({"name": "x", "carrier": "B", "box": GOOD[0]["box"]}, "body x: B carries no body; name one of base, spindle, C, A, X, Y, Z"),
        ({"name": "x", "carrier": "A"}, "fiveaxis.bodies[0]: it needs one of file, box, cylinder, cone, sphere"),
        ({"name": "x", "carrier": "A", "box": GOOD[0]["box"], "colour": 1}, "key colour is not known"),
        ({"carrier": "A", "box": GOOD[0]["box"]}, "fiveaxis.bodies[0].name: the key is missing"),
        ({"name": "x", "carrier": "A", "box": {"low": [1, 1, 1], "high": [0, 2, 2]}}, "low is not below high"),
        ({"name": "x", "carrier": "A", "box": {"low": [1, 1, 1]}}, "it needs low, high and nothing else"),
        ({"name": "x", "carrier": "A", "sphere": {"centre": [0, 0, 0], "radius": -1}}, "is not above 0"),
        ({"name": "x", "carrier": "A", "sphere": {"centre": [0, 0, 1e9], "radius": 1}}, "is not finite or beyond 100000"),
        ({"name": "x", "carrier": "A", "sphere": {"centre": [0, 0], "radius": 1}}, "is not a vector"),
        ("cradle", "'cradle' is not an object"),
    ],
)  # fmt: skip
def test_a_body_that_cannot_be_used_is_refused_in_one_line(tmp_path, body, reported):
    with pytest.raises(MachineError) as raised:
        load_machine(machine_file(tmp_path, [body]))
    assert reported in str(raised.value) and "\n" not in str(raised.value) and "own.fcm" in str(raised.value)


@pytest.mark.thorough
@pytest.mark.oldest
def test_the_example_cuts_a_part_free_of_its_bodies_and_a_short_tool_brings_the_spindle_into_them(tmp_path):
    """On the trunnion of examples/, whose table turns up beside the tool; with a stub of a tool the nose hits
    what holds the table."""
    from freecad_fiveaxis.core.pipeline import job
    from freecad_fiveaxis.core.pipeline.settings import build_settings

    write_stl(from_triangles(box((-30, -20, -90), (30, 20, -80))), tmp_path / "part.stl")
    given = {
        "machine": str(EXAMPLE),
        "cutter": "ball:6:30",
        "passes": "planes",
        "stepover": 6,
        "tool_axis": "facet_mean",
    }
    given |= {"spindle": "off", "linearize": "off", "gouge": "off", "max_axis_angle": 91}
    hit = {
        length: [one.text for one in job.run(build_settings("mill", str(tmp_path / "part.stl"), {**given, "tool_length": length})).findings
                 if one.code == "machine-collision"]
        for length in (160, 35)
    }  # fmt: skip
    assert not hit[160] and any("spindle" in text for text in hit[35])


def test_two_bodies_of_one_name_are_refused(tmp_path):
    with pytest.raises(MachineError, match="two bodies are called cap"):
        load_machine(machine_file(tmp_path, [GOOD[2], GOOD[2]]))


def test_the_command_line_tells_what_is_hit_and_what_was_looked_at(tmp_path, capsys):
    """A post of the base beside the part, in the way of the holder; the same program without it is free."""
    write_stl(from_triangles(box((-10, -10, 0), (10, 10, 10))), tmp_path / "part.stl")
    post = {"name": "post", "carrier": "base", "box": {"low": [22, -50, -100], "high": [60, 50, 200]}}
    far = {"name": "far", "carrier": "base", "box": {"low": [400, -50, -100], "high": [460, 50, 200]}}
    given = [
        "mill",
        str(tmp_path / "part.stl"),
        "--cutter",
        "ball:6",
        "--passes",
        "planes",
        "--stepover",
        "4",
        "--spindle",
        "off",
    ]
    given += [
        "--tool-axis",
        "facet_mean",
        "--max-axis-angle",
        "10",
        "--holder",
        "40x30",
        "--quiet",
        "--report",
        str(tmp_path / "r.json"),
    ]
    codes, message = [], []
    for body in (post, far):
        machine = machine_file(tmp_path, [body])
        codes.append(
            cli.main([*given, "--machine", str(machine), "-o", str(tmp_path / f"{body['name']}.ngc")])
        )
        report = json.loads((tmp_path / "r.json").read_text())
        message.append([one["code"] for one in report["findings"]])
        assert ("machine's bodies: far" in json.dumps(report)) == (body is far)
    assert codes[0] == 1 and "machine-collision" in message[0] and "machine-collision" not in message[1]
    guided = ["--controller", "fanuc", "--rtcp", "angles", "--tool", "1", "--linearize", "off"]
    assert cli.main([*given, *guided, "--machine", str(machine), "-o", str(tmp_path / "guided.nc")]) == 0
    rests = json.loads((tmp_path / "r.json").read_text())["scope"]
    assert "other bodies of the machine" in rests["unknown"][0]
    assert any("machine's bodies: far" in one for one in rests["proven"])
    assert any("turns the rotary axes evenly" in one for one in rests["assumed"])
    guided[3] = "vectors"  # which may be turned otherwise: nothing of it is called proven
    assert cli.main([*given, *guided, "--machine", str(machine), "-o", str(tmp_path / "vectors.nc")]) == 0
    report = json.loads((tmp_path / "r.json").read_text())
    assert not any("machine's bodies: far" in one for one in report["scope"]["proven"])
    assert "machine-unproven" in [one["code"] for one in report["findings"]]
    near = machine_file(tmp_path, [post])
    guided[3] = "angles"
    assert cli.main([*given, *guided, "--machine", str(near), "-o", str(tmp_path / "hit.nc")]) == 1
    assert "machine-collision" in (tmp_path / "r.json").read_text()
    assert (tmp_path / "post.ngc").read_bytes() == (tmp_path / "far.ngc").read_bytes()
    vise = machine_file(tmp_path, [GOOD[4]])
    assert cli.main([*given, "--machine", str(vise), "-o", str(tmp_path / "none.ngc")]) == 2
    assert "vise.stl" in capsys.readouterr().err and not (tmp_path / "none.ngc").exists()
    write_stl(from_triangles(box((22, -50, -100), (60, 50, 200))), tmp_path / "vise.stl")
    audit = [
        "audit",
        str(tmp_path / "post.ngc"),
        "--machine",
        str(vise),
        "--cutter",
        "ball:6",
        "--holder",
        "40x30",
        "--quiet",
    ]
    assert cli.main([*audit, "--report", str(tmp_path / "a.json")]) == 1
    assert "machine-collision" in [
        one["code"] for one in json.loads((tmp_path / "a.json").read_text())["findings"]
    ]


def test_a_body_is_reported_that_comes_nearer_than_its_own_clearance_or_that_of_all(tmp_path):
    """A post on the platter, 15 mm beside the edge over which the middle of a ball of 6 runs: 12 mm are
    left."""
    from freecad_fiveaxis.core.pipeline import job
    from freecad_fiveaxis.core.pipeline.settings import build_settings

    write_stl(from_triangles(box((-10, -10, 0), (10, 10, 10))), tmp_path / "part.stl")
    post = {"name": "post", "carrier": "C", "box": {"low": [25, -50, 0], "high": [60, 50, 40]}}
    given = {
        "cutter": "ball:6",
        "passes": "planes",
        "stepover": 4,
        "spindle": "off",
        "gouge": "off",
        "max_axis_angle": 1,
    }
    given |= {"tool_axis": "facet_mean", "linearize": "off"}

    def near(body, **more):
        machine = str(machine_file(tmp_path, [body]))
        found = job.run(
            build_settings("mill", str(tmp_path / "part.stl"), {**given, "machine": machine, **more})
        ).findings
        return [one for one in found if one.code == "machine-near"]

    assert not near(post) and not near(post, fixture_clearance=2.0) and not near({**post, "clearance": 11.9})
    (one,), (other,) = near({**post, "clearance": 13}), near(post, fixture_clearance=13.0)
    assert (
        one.value == pytest.approx(12.0, abs=0.02) == other.value and one.limit == 13.0 and "post" in one.text
    )
    assert (one.near.enters, one.near.entered, one.hit) == ("cutter", "post", None)


def test_the_clearance_of_a_body_is_read_and_written_in_mm(tmp_path):
    machine = load_machine(machine_file(tmp_path, [{**GOOD[2], "clearance": 2.5}]))
    assert machine.bodies[0].clearance == 2.5
    save_machine(machine, tmp_path / "again.fcm")
    assert load_machine(tmp_path / "again.fcm").bodies == machine.bodies
    with pytest.raises(MachineError, match=r"bodies\[0\].clearance: -1 mm is no clearance"):
        load_machine(machine_file(tmp_path, [{**GOOD[2], "clearance": -1}]))


def downward(machine, stop, **more):
    """Check a machine whose tool, at X and Y zero, goes straight down to Z ``stop`` of the spindle's face."""
    setup = Setup(ORIGIN, LENGTH)
    kinematics = chain(machine, setup)
    words = np.tile(zero_words(machine, setup, kinematics), (2, 1))
    words[:, 2] += (100.0, stop)
    given = InMachine(machine, setup, kinematics, TOOL, LENGTH, **more)
    return given, program_of(machine, words)


@pytest.mark.parametrize("of_post", [0.0, 4.0])
def test_the_clearance_that_the_spindles_nose_has_itself_counts(of_post):
    """The nose, 35 mm in radius, goes down beside a post, a part and a fixture, each 8 mm from it; the tool
    stays farther away."""
    low, high = np.array([43.0, -20.0, -60.0]), np.array([60.0, 20.0, 50.0])
    post = MachineBody("post", "base", "box", (tuple(low), tuple(high)), clearance=of_post)
    block = from_triangles(box(low, high) - ORIGIN)
    scenes = {
        "post": ((post,), {}, None),
        "part": ((), {}, block),
        "vise": ((), {"fixtures": (Fixture("vise", block),)}, None),
    }
    for name, (bodies, more, part) in scenes.items():
        for own, near in ((0.0, False), (7.9, False), (10.0, True)):
            machine = replace(load_machine("trunnion_ac"), bodies=(replace(NOSE, clearance=own), *bodies))
            found = check_machine(*downward(machine, 20.0, **more), part, 0.01)
            assert [one.code for one in found] == ["machine-near"] * near, (name, own)
            if near:
                assert found[0].value == pytest.approx(8.0, abs=0.02) and found[0].limit == 10.0
                assert found[0].near.enters == "spindle" and name in found[0].text


def test_the_clearance_of_the_nose_does_not_count_for_the_tool():
    post = MachineBody("post", "base", "box", ((21.0, -20.0, -60.0), (30.0, 20.0, -20.0)))
    machine = replace(load_machine("trunnion_ac"), bodies=(replace(NOSE, clearance=10.0), post))
    assert not check_machine(*downward(machine, 20.0), None, 0.01)
    (one,) = check_machine(*downward(machine, 20.0, clearance=8.0), None, 0.01)
    assert one.near.enters == "holder" and one.limit == 8.0


SHORT = Body((round_piece(0.0, RADIUS, RADIUS), frustum_piece(RADIUS, RADIUS, 20.0, RADIUS)))
"""A tool that ends 60 mm below the spindle's face."""


@pytest.mark.parametrize("deep", [True, False])
def test_a_nose_that_is_wholly_in_a_body_is_reported_though_the_tool_below_it_is_not(deep):
    """The tool ends 20 mm below the beam, the nose begins 20 mm in it, or all is far below."""
    low = 60.0 if deep else 300.0
    machine = replace(
        load_machine("trunnion_ac"),
        bodies=(NOSE, MachineBody("beam", "base", "box", ((-200.0, -200.0, low), (200.0, 200.0, 900.0)))),
    )
    given, program = downward(machine, 80.0)
    found = check_machine(replace(given, body=SHORT), program, None, 0.01)
    assert [one.code for one in found] == ["machine-collision"] * deep
    if deep:
        assert (
            found[0].hit == Hit("spindle", "beam", None)
            and "whole spindle is inside the beam" in found[0].text
        )
    block = from_triangles(box((-200.0, -200.0, low), (200.0, 200.0, 900.0)) - ORIGIN)
    alone = replace(given, machine=replace(machine, bodies=(NOSE,)), body=SHORT)
    assert [one.code for one in check_machine(alone, program, block, 0.01)] == ["machine-collision"] * deep
    pose = machine_in_pose(replace(given, body=SHORT), None, 0.01)
    tip, axis = forward(given.kinematics, words_to_q(program.words))
    assert pose.is_blocked(tip, axis, np.deg2rad(program.words[:, 3:])).all() == deep
