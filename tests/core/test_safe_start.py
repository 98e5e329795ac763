# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs begin and end safely: Z is up before the rotary axes turn, and never do two groups of axes move at
once."""

import json
import math
import re
import shutil
import subprocess
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from bare_machines import BARE
from mesh_shapes import box as make_box
from scipy.spatial.transform import Rotation
from thorough import some_in_core

from freecad_fiveaxis.core.base.errors import MachineError, SettingsError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.base.progress import silent
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.machine import SafeStart, load_machine, save_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.machine.machine_file import machine_folder
from freecad_fiveaxis.core.motion.program import plane_above
from freecad_fiveaxis.core.nc.reader import read_nc
from freecad_fiveaxis.core.pipeline import job
from freecad_fiveaxis.core.pipeline.context import JobContext, PostContext
from freecad_fiveaxis.core.pipeline.safe_start import start_findings
from freecad_fiveaxis.core.pipeline.settings import build_settings
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.toolpath.apt import ClHead, write_apt
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

LOW, HIGH = np.array([-40.0, -25.0, -10.0]), np.array([30.0, 35.0, 45.0])
GROUPS = ("Z", "AC", "XY")


def height_over_part(machine, setup, z, q1, q2):
    """The lowest place of the tip over the highest corner of the box (n,), in the machine frame, by rotations
    of its own: the tool by the axes of the head, the part by those of the table the other way. X and Y stand
    at 0."""
    origin, tip = np.array(setup.origin), np.array(machine.gauge_point) - (0.0, 0.0, setup.tool_length)
    corners = np.array(list(product(*zip(LOW, HIGH, strict=True)))) + origin
    up = np.tile(origin + (0.0, 0.0, z), (len(q1), 1))  # the linear words count from the work zero
    shift = origin - tip  # so far the head has gone at X0 Y0 Z0
    part = np.tile(corners, (len(q1), 1, 1)).transpose(1, 0, 2)
    for axis, q in reversed(list(zip(machine.rotary, (q1, q2), strict=True))):
        turn, point = np.array(axis.direction), np.array(axis.point)
        if axis.side == "head":
            centre = point + shift + (0.0, 0.0, z)
            up = centre + Rotation.from_rotvec(q[:, None] * turn).apply(up - centre)
    for axis, q in zip(machine.rotary, (q1, q2), strict=True):
        if axis.side == "table":
            turn, point = np.array(axis.direction), np.array(axis.point)
            part = np.array(
                [point + Rotation.from_rotvec(-q[:, None] * turn).apply(corner - point) for corner in part]
            )
    return up[:, 2] - part[:, :, 2].max(axis=0)


@some_in_core("name", BARE, kept=(0, 1))
def test_the_plane_is_above_the_part_wherever_the_rotary_axes_stand(name):
    machine, setup, random = load_machine(name), Setup((7.0, -3.0, 12.0), 80.0), np.random.default_rng(2)
    z = plane_above(chain(machine, setup), LOW, HIGH, 5.0, np.zeros((1, 5)))
    limits = [(max(axis.low, -math.pi), min(axis.high, math.pi)) for axis in machine.rotary]
    q1, q2 = (random.uniform(low, high, 200_000) for low, high in limits)
    room = height_over_part(machine, setup, z, q1, q2)
    assert room.min() >= 5.0 and room.min() < 8.0  # above it, and no higher than it must be


def test_the_plane_is_not_below_the_places_where_the_program_begins_and_ends():
    kinematics = chain(load_machine("trunnion_ac"), Setup())
    ends = np.zeros((2, 5))
    ends[:, 2] = 40.0, 321.5
    assert plane_above(kinematics, LOW, HIGH, 5.0, ends) == 322.0


def test_a_z_that_does_not_lift_the_tool_is_refused():
    machine = load_machine("trunnion_ac")
    swapped = {"Y": (0.0, 0.0, 1.0), "Z": (0.0, 1.0, 0.0)}
    axes = tuple(replace(axis, direction=swapped.get(axis.letter, axis.direction)) for axis in machine.axes)
    with pytest.raises(
        SettingsError, match="Z of this machine does not lift the tool: give its file another safe_start"
    ):
        plane_above(chain(replace(machine, axes=axes), Setup()), LOW, HIGH, 5.0, np.zeros((1, 5)))


# The machine file.


@pytest.mark.parametrize(
    ("given", "read"),
    [
        ({"retract": "machine", "Z": -1}, SafeStart("machine", -1.0)),
        ({"retract": "reference"}, SafeStart("reference")),
        ({"retract": "clearance"}, SafeStart()),
        ({"retract": "none"}, SafeStart("none")),
        (None, SafeStart("clearance")),
    ],
)
def test_the_machine_file_says_how_programs_begin(given, read, tmp_path):
    data = json.loads((machine_folder() / "trunnion_ac.fcm").read_text())
    data["fiveaxis"].pop("safe_start")
    data["fiveaxis"] |= {} if given is None else {"safe_start": given}
    (tmp_path / "a.fcm").write_text(json.dumps(data))
    machine = load_machine(tmp_path / "a.fcm")
    assert machine.safe_start == read
    save_machine(machine, tmp_path / "b.fcm")
    assert load_machine(tmp_path / "b.fcm") == machine


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            {"retract": "home"},
            r"fiveaxis\.safe_start\.retract: 'home' is none of machine, reference, clearance, none",
        ),
        ({"retract": "machine"}, r"fiveaxis\.safe_start\.Z: the key is missing"),
        ({"retract": "machine", "Z": "up"}, r"fiveaxis\.safe_start\.Z: 'up' is not a finite number"),
        (
            {"retract": "clearance", "Z": 5},
            r"fiveaxis\.safe_start\.Z: retract clearance takes no such key; leave it out",
        ),
        (
            {"retract": "machine", "z": 5, "Z": 5},
            r"fiveaxis\.safe_start\.z: retract machine takes no such key",
        ),
        ({}, r"fiveaxis\.safe_start\.retract: the key is missing"),
        ("G28", r"fiveaxis\.safe_start: 'G28' is not an object"),
    ],
)
def test_a_safe_start_that_makes_no_sense_is_refused_with_its_key(given, message, tmp_path):
    data = json.loads((machine_folder() / "trunnion_ac.fcm").read_text())
    data["fiveaxis"]["safe_start"] = given
    (tmp_path / "a.fcm").write_text(json.dumps(data))
    with pytest.raises(MachineError, match=message):
        load_machine(tmp_path / "a.fcm")


def test_a_machine_coordinate_in_inches_is_converted(tmp_path):
    data = json.loads((machine_folder() / "trunnion_ac.fcm").read_text())
    data["machine"]["units"] = "imperial"
    data["fiveaxis"] |= {"safe_start": {"retract": "machine", "Z": -2}, "table": -1}
    (tmp_path / "a.fcm").write_text(json.dumps(data))
    machine = load_machine(tmp_path / "a.fcm")
    assert machine.safe_start.z == pytest.approx(-50.8) and machine.table == pytest.approx(-25.4)


# Programs.


def path_file(folder, axes=((0.6, 0.0, 0.8), (0.0, 0.6, 0.8))):
    """A CL file without a tool number: down to a place, a cut with turning axes, and up again."""
    axis = np.array([axes[0], axes[0], axes[1], axes[1]])
    tip = np.array([(20.0, 10.0, 60.0), (20.0, 10.0, 30.0), (24.0, 11.0, 30.0), (24.0, 11.0, 60.0)])
    motion, none = np.array([Motion.RAPID, Motion.CUT, Motion.CUT, Motion.RAPID], np.int8), np.full(4, -1)
    feed = np.where(motion == Motion.RAPID, 0.0, 500.0)
    path = CLPath(tip, axis, motion, feed, tip, axis, none, none, none)
    (folder / "a.apt").write_bytes(write_apt(path, Cutter(8.0), "a", head=ClHead()))
    return str(folder / "a.apt")


def machine_with(folder, start, name="trunnion_ac"):
    save_machine(replace(load_machine(name), safe_start=start), folder / "m.fcm", overwrite=True)
    return str(folder / "m.fcm")


def posted(folder, start=None, name="trunnion_ac", axes=((0.6, 0.0, 0.8), (0.0, 0.6, 0.8)), **options):
    machine = machine_with(folder, start, name) if start else name
    return job.make(
        build_settings("post", path_file(folder, axes), {"machine": machine, "tool_length": 90.0} | options)
    )


def traverses(nc, folder):
    """Where LinuxCNC's interpreter drives to in rapid, up to the first feed (n, 6): X Y Z A B C."""
    (folder / "a.ngc").write_bytes(nc)
    run = subprocess.run(
        ["rs274", "-g", "a.ngc"],
        cwd=folder,
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        timeout=60,
    )
    assert run.returncode == 0, run.stderr
    before = run.stdout.split("STRAIGHT_FEED")[0]
    return np.array(
        [
            [float(n) for n in found.split(",")]
            for found in re.findall(r"STRAIGHT_TRAVERSE\(([^)]*)\)", before)
        ]
    )


@pytest.mark.rs274
@pytest.mark.skipif(shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed")
@pytest.mark.parametrize(
    ("start", "z"), [(SafeStart("machine", 200.0), 200.0), (SafeStart(), None), (SafeStart("reference"), 0.0)]
)
def test_linuxcnc_drives_z_then_the_rotary_axes_then_x_and_y_then_z(start, z, tmp_path):
    result = posted(tmp_path, start)
    moves = traverses(result.nc, tmp_path)
    first = result.program.words[0]
    at = (
        [moves[0]] if start.retract != "reference" else [moves[0], moves[1]]
    )  # G28 goes by way of where it is
    up = at[-1]
    assert up[2] == (z if z is not None else up[2]) and (up[[0, 1, 3, 4, 5]] == 0.0).all()
    turned, over, down = moves[len(at) : len(at) + 3]
    assert (turned[:3] == up[:3]).all() and np.allclose(turned[[5, 3]], first[3:])
    assert (over[2:] == turned[2:]).all() and np.allclose(over[:2], first[:2])
    assert (down[[0, 1, 3, 4, 5]] == over[[0, 1, 3, 4, 5]]).all() and down[2] == pytest.approx(first[2])
    if start.retract == "clearance":
        assert up[2] >= first[2]


@pytest.mark.parametrize(
    "start", [SafeStart("machine", 200.0), SafeStart("reference"), SafeStart(), SafeStart("none")]
)
@pytest.mark.parametrize(
    "options",
    [
        {"controller": "linuxcnc"}, {"controller": "linuxcnc", "rtcp": "angles"}, {"controller": "fanuc", "rtcp": "vectors"},
        {"controller": "haas", "rtcp": "angles"}, {"controller": "siemens840d"}, {"controller": "siemens840d", "rtcp": "vectors"},
        {"controller": "heidenhain", "rtcp": "vectors"}, {"controller": "heidenhain_m128", "rtcp": "angles"},
        {"controller": "grbl"}, {"controller": "mach3"},
    ],
    ids=lambda given: "-".join(given.values()) if isinstance(given, dict) else "",
)  # fmt: skip
def test_the_written_file_is_read_again_as_the_same_blocks_and_without_a_word_of_its_start(
    start, options, tmp_path
):
    result = posted(tmp_path, start, tool=3, spindle=9000.0, **options)
    again = read_nc(result.nc, result.kinematics, result.dialect)
    own = np.isin(again.line, result.program.line)
    assert np.abs(again.words[own] - result.program.words).max() < 1e-9 and np.array_equal(
        again.line[own], result.program.line
    )
    assert {found.code for found in again.findings} <= {"tip-guided-by-controller"}
    others = again.words[~own]  # of a plane above the part only: over the first place, and over the last
    if len(others):
        ends = result.program.words[[0, -1]]
        assert start.retract == "clearance" and len(others) == 2
        assert (
            np.abs(others[:, [0, 1, 3, 4]] - ends[:, [0, 1, 3, 4]]).max() < 2e-4
            and (others[:, 2] >= ends[:, 2]).all()
        )
    elif start.retract == "clearance":
        assert options["controller"] in ("fanuc", "haas")
        assert any(found.code == "starts-at-reference" for found in result.findings)


def groups_of(line):
    """Which axes a line of the start drives."""
    return "".join(re.findall(r"(?<![A-Z0-9])[XYZABC](?=[+=-]?[\d.(D])", line))


@pytest.mark.parametrize(
    "controller",
    ["linuxcnc", "fanuc", "haas", "siemens840d", "heidenhain", "heidenhain_m128", "mach3", "grbl"],
)
@pytest.mark.parametrize("start", [SafeStart("machine", -1.0), SafeStart("reference"), SafeStart()])
@pytest.mark.parametrize("rtcp", ["off", "angles"])
def test_no_line_before_the_first_block_drives_two_groups_and_the_guide_comes_after_the_rotary_axes(
    controller, start, rtcp, tmp_path
):
    if rtcp == "angles" and controller in ("mach3", "grbl"):
        pytest.skip("no RTCP")
    result = posted(tmp_path, start, controller=controller, rtcp=rtcp, tool=3)
    head = result.nc.decode().split(result.dialect.newline)[: int(result.program.line[0]) - 1]
    code = [re.sub(r"\(.*\)$|;.*", "", line) for line in head]
    driven = [
        (k, groups_of(line)) for k, line in enumerate(code) if groups_of(line) and "TOOL CALL" not in line
    ]
    driven = [(k, axes) for k, axes in driven if "FGROUP" not in code[k]]
    assert [axes for _, axes in driven if axes != "Z"] == ["AC", "XY"] and driven[0][1] == "Z"
    if rtcp == "angles":
        guide = next(
            k
            for k, line in enumerate(code)
            if result.dialect.guide.on[0].split(" {")[0].split()[0] in line.split()
        )
        assert driven[-1][0] < guide or controller.startswith("heidenhain")


def test_the_head_names_tool_cutter_and_length(tmp_path):
    assert b"\n(T3 BALL 8 MM, L 90.000)\n" in posted(tmp_path, tool=3, cutter="ball:8").nc
    assert b"\n(BALL 8 MM, L 90.000)\n" in posted(tmp_path, cutter="ball:8").nc
    assert b"T3 M6" not in posted(tmp_path, cutter="ball:8").nc
    assert (
        b"\n2 ; T3 BALL 8 MM, L 90.000\n"
        in posted(tmp_path, controller="heidenhain", tool=3, cutter="ball:8").nc
    )


def test_a_spindle_that_stays_off_is_stated(tmp_path):
    found = [one for one in posted(tmp_path).findings if one.code == "spindle-off"]
    assert [(one.severity, one.text) for one in found] == [
        (Severity.WARNING, "The spindle stays off: give --spindle S.")
    ]
    assert not [one for one in posted(tmp_path, spindle=8000.0).findings if one.code == "spindle-off"]


@pytest.mark.parametrize("given", ["off", 0.0])
def test_a_spindle_that_is_requested_to_stay_off_is_a_note(tmp_path, given):
    result = posted(tmp_path, spindle=given)
    found = [one for one in result.findings if one.code == "spindle-off"]
    assert [(one.severity, one.text.startswith("The spindle stays off, as asked")) for one in found] == [
        (Severity.NOTE, True)
    ]
    assert b"M5" in result.nc and b"M3" not in result.nc


def test_a_plane_beyond_the_travel_is_lowered_to_it_and_stated(tmp_path):
    result = posted(tmp_path, SafeStart(), tool_length=20.0, origin="0,0,450")
    found = [one for one in result.findings if one.code == "safe-start-beyond-limit"]
    assert len(found) == 1 and found[0].severity is Severity.WARNING
    assert f"\nG0 Z{found[0].limit:.4f}\n".encode() in result.nc and found[0].limit == 500.0 - 450.0 - 20.0


def test_a_plane_beyond_the_travel_is_never_lower_than_the_places_where_the_program_begins_and_ends(tmp_path):
    # Z ends 10 mm above the work zero, the path at 60 mm: from its last place Z must not come down in rapid
    upright = ((0.0, 0.0, 1.0), (0.0, 0.0, 1.0))
    result = posted(tmp_path, SafeStart(), axes=upright, tool_length=20.0, origin="0,0,470")
    ends = result.program.words[[0, -1], 2]
    (found,) = [one for one in result.findings if one.code == "safe-start-beyond-limit"]
    assert found.limit == 10.0 < ends.max() <= found.value
    assert [float(z) for z in re.findall(rb"\nG0 Z([\d.-]+)\n", result.nc)] == [round(ends.max(), 4)] * 2
    assert f"begins and ends at Z {ends.max():.4f}" in found.text and "--origin" in found.text


@pytest.mark.parametrize(("z", "down"), [(-1.0, True), (300.0, False)])
def test_a_retract_to_a_machine_position_below_the_last_place_is_a_warning(z, down, tmp_path):
    result = posted(tmp_path, SafeStart("machine", z))
    found = [one for one in result.findings if one.code == "retract-downwards"]
    assert [one.severity for one in found] == [Severity.WARNING] * down
    for one in found:
        assert one.value == z - 90.0 < one.limit == result.program.words[[0, -1], 2].max()


def test_a_start_from_below_through_the_part_is_an_error(tmp_path):
    lean = math.radians(-20.0)
    down = (math.cos(lean), 0.0, math.sin(lean))
    result = posted(tmp_path, SafeStart(), axes=(down, down))
    for side, errors in ((25.0, 2), (-25.0, 0)):  # the tool comes from +X, and a little from below
        box = (np.array([side - 5.0, -20.0, -100.0]), np.array([side + 20.0, 40.0, 58.0]))
        context = JobContext(result.settings, result.machine, result.kinematics, result.dialect, box, silent)
        found = [one for one in start_findings(context, result.program) if one.code == "start-through-part"]
        assert [one.severity for one in found] == [Severity.ERROR] * errors
        assert all("because the tool axis points downwards there" in one.text for one in found)
        of_cl = PostContext(
            result.settings, result.machine, result.kinematics, result.dialect, box, silent, box
        )
        found = [one for one in start_findings(of_cl, result.program) if one.code == "start-through-part"]
        assert [one.severity for one in found] == [Severity.WARNING] * errors, "the part is not known"


def test_a_part_above_an_upright_tool_is_not_reported_of_as_an_axis_that_points_downwards(tmp_path):
    result = posted(tmp_path, SafeStart())
    box = (np.array([0.0, 0.0, 65.0]), np.array([80.0, 80.0, 200.0]))
    context = JobContext(result.settings, result.machine, result.kinematics, result.dialect, box, silent)
    found = [one for one in start_findings(context, result.program) if one.code == "start-through-part"]
    assert [one.severity for one in found] == [Severity.ERROR] * 2
    assert all("which lies above that place" in one.text and "down" not in one.text[25:] for one in found)


def path_with_link(folder, high):
    """A CL file that cuts at Z 30 and goes over, by a link at ``high`` mm, to where it ends."""
    lean = (0.6, 0.0, 0.8)
    tip = np.array([(20, 10, 60), (20, 10, 30), (24, 11, 30), (60, 11, high), (24, 10.5, 50)], float)
    motion = np.array([Motion.RAPID, Motion.CUT, Motion.CUT, Motion.LINK, Motion.LINK], np.int8)
    axis, none, feed = np.tile(lean, (5, 1)), np.full(5, -1), np.where(motion == Motion.RAPID, 0.0, 500.0)
    path = CLPath(tip, axis, motion, feed, tip, axis, none, none, none)
    (folder / "b.apt").write_bytes(write_apt(path, Cutter(8.0), "b", head=ClHead()))
    return str(folder / "b.apt")


def through(source, **options):
    given = {"machine": "trunnion_ac", "tool_length": 90.0, "spindle": "off"} | options
    result = job.make(build_settings("post", source, given))
    return [one for one in result.findings if one.code == "start-through-part"]


def test_links_and_retracts_of_a_cl_file_do_not_stand_for_the_part(tmp_path):
    """The tool rises within the box of all feed moves, whose farthest corner is a link."""
    assert not through(path_with_link(tmp_path, 90.0))


def test_cutting_points_above_the_last_place_are_a_note_of_a_part_that_is_not_known(tmp_path):
    tip = np.array([(0, 0, 60), (-20, 0, 30), (20, 0, 30), (0, 0, 40), (0, 0, 20)], float)
    motion = np.array([Motion.RAPID, *[Motion.CUT] * 3, Motion.LINK], np.int8)
    axis, none, feed = np.tile((0.0, 0.0, 1.0), (5, 1)), np.full(5, -1), np.full(5, 500.0)
    path = CLPath(tip, axis, motion, feed, tip, axis, none, none, none)
    source = tmp_path / "c.apt"
    tip[1, 1], tip[2, 1] = -20.0, 20.0  # the box has a width
    source.write_bytes(write_apt(path, Cutter(8.0), "c", head=ClHead()))
    (found,) = through(str(source))
    assert found.severity is Severity.NOTE and "The part is not known here" in found.text
    assert "rises from its last place along Z through the box of the cutting points" in found.text


def test_a_fixture_over_the_last_place_is_an_error_without_a_part_too(tmp_path):
    write_stl(from_triangles(make_box((0, 0, 0), (80, 80, 200))), tmp_path / "clamp.stl")
    found = through(path_file(tmp_path), fixture=(f"{tmp_path / 'clamp.stl'}@0,0,65",))
    assert [one.severity for one in found] == [Severity.ERROR] * 2
    assert all("through the fixture clamp.stl@0,0,65" in one.text for one in found)
