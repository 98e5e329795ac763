# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of LinuxCNC machines from vismach models. Two models written here are compared, body by body, with
products of their own matrices at three positions of the joints; what is not plain is told and left out."""

import math
import os
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mesh_shapes import box

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import FiveAxisError, MachineError
from freecad_fiveaxis.core.geometry.convex import convex_hull
from freecad_fiveaxis.core.geometry.mesh import from_triangles, write_stl
from freecad_fiveaxis.core.gouge.carried_motion import CarriedMotion, steps_between
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.bodies import BASE, BOX, FILE
from freecad_fiveaxis.core.machine.importing import find_model, import_machine

ARM = ((-90.0, -10.0, -40.0), (-80.0, 15.0, 0.0))
TRUNNION = """#!/usr/bin/env python3
from vismach import *
import hal, sys
open("ran.txt", "w").write("this script was run")

depth = 30
half = depth / 2 + 1
for setting in sys.argv[1:]: exec(setting)

class Own(CylinderZ):
    def coords(self):
        return gui.tool_length, 5, 0, 5

gui = hal.component("mymill")
for pin in ("x", "y"): gui.newpin(pin, hal.HAL_FLOAT, hal.HAL_IN)
gui.ready()

tip, work = Capture(), Capture()
tool = HalTranslate([tip, CylinderZ(-10, 3, 0, 3)], gui, "tool-length", 0, 0, -1)
nose = Collection([tool, CylinderZ(40, 25, 0, 15)])
block = Translate([Rotate([BoxCentered(10, 20, 30)], 30, 0, 0, 1)], 0, 50, 80)
motor = Color([1, 0, 0, 1], [Box(20, 60, 140, -20, -25, 40)])
ram = Collection([nose, block, motor])
ram = HalTranslate([ram], gui, "ram", 0, 0, 1)
ram = Translate(parts=[ram], x=5, y=7, z=300)

ball = Translate([Sphere(0, 0, 0, 4)], 60, 0, 5)
platter = Collection([work, CylinderZ(-half, 80, 0, 80), ball])
platter = HalRotate([platter], gui, "platter", 1, 0, 0, 2)
plate = Translate([BoxCenteredXY(100, 90, -20)], 0, 0, -half)
arm = AsciiSTL(filename="arm.stl")
cradle = Collection([platter, plate, arm])
cradle = HalTranslate([cradle], gui, "yo", 0, -1, 0)
cradle = HalTranslate([cradle], gui, "zo", 0, 0, -1)
cradle = HalRotate([cradle], gui, "tilt", -1, -1, 0, 0)
cradle = HalVectorTranslate([cradle], gui, 0, "yo", "zo")
slide = Collection([cradle, Box(-150, -50, -80, 150, 50, -70)])
slide = HalTranslate([slide], gui, "x", -1, 0, 0)
screw = CylinderX(-60, 9, 70, 12)
saddle = HalTranslate([slide, screw], gui, "y", 0, -1, 0)
table = Translate([saddle], 5, 7, 300)
bed = Box(-300, -300, -50, 300, 300, 0)
model = Collection([ram, table, bed])
main(model, tip, work, size=500, lat=-60)
"""
HAL = """loadusr -W ./mill.py
net a joint.0.pos-fb => mymill.x
net b joint.1.pos-fb => mymill.y
net c limit.out => joint.2.motor-pos-fb mymill.ram
net d joint.3.pos-fb mymill.tilt
net e joint.4.pos-fb mymill.platter
net f motion.tooloffset.z xyzac-trt-kins.tool-offset mymill.tool-length
net g xyzac-trt-kins.y-offset mymill.yo
net h xyzac-trt-kins.z-offset mymill.zo
sets g 20
sets h 10
"""
FORK = """import vismach as v
from hal import component
import hal
picture = hal.component("forkgui")
tip, work = v.Capture(), v.Capture()
spindle = v.Translate([tip, v.CylinderZ(0, 30, 90, 30), v.CylinderY(-40, 10, 40, 10)], 0, 0, -200)
spindle = v.HalRotate([spindle], picture, "jb", 1, 0, -1, 0)
fork = v.HalRotate([spindle, v.Box(-60, 50, -50, 60, 80, 120)], picture, "jc", 1, 0, 0, 1)
ram = v.HalTranslate([fork, v.Box(-70, -70, 120, 70, 70, 800)], picture, "jz", 0, 0, 1)
beam = v.HalTranslate([ram, v.Box(-70, 70, 300, 70, 150, 500)], picture, "jx", 1, 0, 0)
bridge = v.HalTranslate([beam, v.Box(-900, 150, 300, 900, 300, 500)], picture, "jy", 0, 1, 0)
v.main(v.Collection([bridge, work, v.Box(-500, -500, -450, 500, 500, -400)]), tip, work)
"""
FORK_HAL = "loadrt sum2 names=reach\nsetp reach.in0 200\nnet t motion.tooloffset.z => reach.in1\nnet p reach.out => 5axiskins.pivot-length\n"
MODELS = {
    "trunnion": ("xyzac-trt-kins", "XYZAC", HAL, TRUNNION),
    "fork": ("5axiskins", "XYZBC", FORK_HAL, FORK),
}
LIMITS = "MIN_LIMIT = -350\nMAX_LIMIT = 350\nMAX_VELOCITY = 50\n"


@pytest.fixture
def write(tmp_path):
    """A function that writes a configuration and its model, pieces of the texts replaced; returns the names
    of both."""
    write_stl(from_triangles(box(*ARM)), tmp_path / "arm.stl")

    def act(name="trunnion", *swaps, hal=None, units="mm", angles="deg"):
        module, letters, own, text = MODELS[name]
        for old, new in swaps:
            assert old in text
            text = text.replace(old, new)
        ini = f"[KINS]\nKINEMATICS = {module}\n[HAL]\nHALFILE = m.hal\n[TRAJ]\nLINEAR_UNITS = {units}\nANGULAR_UNITS = {angles}\n"
        ini += "".join(f"[JOINT_{joint}]\n{LIMITS}" for joint, _ in enumerate(letters))
        for file, content in (("m.ini", ini), ("m.hal", own if hal is None else hal), ("mill.py", text)):
            (tmp_path / file).write_text(content, encoding="utf-8")
        return str(tmp_path / "m.ini"), str(tmp_path / "mill.py")

    return act


# --------------------------------------------------------------------- a second route: the models' own matrices


def at(x, y, z):
    found = np.eye(4)
    found[:3, 3] = x, y, z
    return found


def turn(axis, degrees):
    angle, found = math.radians(degrees), np.eye(4)
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    found[:3, :3] = np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross
    return found


def corners(low, high):
    return [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]


def of_trunnion(x, y, z, a, c):
    """Where each body's points are in the machine frame, joints in mm and degrees, by the text of TRUNNION."""
    frame = at(-5, -7, -300)
    base = at(5, 7, 300)
    ram = frame @ base @ at(0, 0, z)
    saddle = frame @ base @ at(0, -y, 0)
    slide = saddle @ at(-x, 0, 0)
    cradle = slide @ at(0, 20, 10) @ turn((1, 0, 0), a) @ at(0, -20, -10)
    platter = cradle @ turn((0, 0, 1), c)
    return {
        "nose": (ram, [(0, 0, 0), (0, 0, 40)]),
        "block": (ram @ at(0, 50, 80) @ turn((0, 0, 1), 30), corners((-5, -10, -15), (5, 10, 15))),
        "motor": (ram, corners((-20, -25, 40), (20, 60, 140))),
        "platter": (platter, [(0, 0, -16), (0, 0, 0)]),
        "ball": (platter @ at(60, 0, 5), [(0, 0, 0)]),
        "plate": (cradle @ at(0, 0, -16), corners((-50, -45, -20), (50, 45, 0))),
        "arm": (cradle, corners(*ARM)),
        "slide": (slide, corners((-150, -50, -80), (150, 50, -70))),
        "screw": (saddle, [(-60, 0, 0), (70, 0, 0)]),
        "bed": (frame, corners((-300, -300, -50), (300, 300, 0))),
    }


def of_fork(x, y, z, b, c):
    frame = at(0, 0, 200)
    bridge = frame @ at(0, y, 0)
    beam = bridge @ at(x, 0, 0)
    ram = beam @ at(0, 0, z)
    fork = ram @ turn((0, 0, 1), c)
    spindle = fork @ turn((0, -1, 0), b) @ at(0, 0, -200)
    return {
        "spindle": (spindle, [(0, 0, 0), (0, 0, 90)]),
        "spindle 2": (spindle, [(0, -40, 0), (0, 40, 0)]),
        "fork": (fork, corners((-60, 50, -50), (60, 80, 120))),
        "ram": (ram, corners((-70, -70, 120), (70, 70, 800))),
        "beam": (beam, corners((-70, 70, 300), (70, 150, 500))),
        "bridge": (bridge, corners((-900, 150, 300), (900, 300, 500))),
        "body": (frame, corners((-500, -500, -450), (500, 500, -400))),
    }


ROUTES = {"trunnion": of_trunnion, "fork": of_fork}
POSITIONS = ((0, 0, 0, 0, 0), (31, -42, 53, 37, 114), (-120, 88, -17, -71, -203))


def farthest(imported, route):
    """How far, mm, a point of any body is at most from where the second route has it, over POSITIONS."""
    machine, found = imported.machine, 0.0
    for q in POSITIONS:
        words = dict(zip("XYZ" + ("AC" if "A" in machine.letters else "BC"), q, strict=True))
        expected = route(*q)
        assert set(expected) == {body.name for body in machine.bodies}
        for body in machine.bodies:
            points = np.array(body.points)
            if body.shape == BOX:
                points = np.array(corners(*body.points))
            elif body.shape == FILE:
                points = imported.meshes[body.name].vertex
            steps = steps_between(machine, BASE, body.carrier)
            joints = [
                math.radians(words[step.axis.letter]) if step.axis.rotary else words[step.axis.letter]
                for step in steps
            ]
            poses = CarriedMotion(steps, convex_hull(points)).lines(np.array([joints])).poses
            ours = points @ poses.turn[0].T + poses.shift[0]
            place, local = expected[body.name]
            theirs = np.array(local) @ place[:3, :3].T + place[:3, 3]
            apart = np.linalg.norm(ours[:, None] - theirs, axis=2)
            found = max(found, apart.min(axis=0).max(), apart.min(axis=1).max())
    return found


@pytest.mark.parametrize("name", MODELS)
def test_every_body_moves_as_the_matrices_of_the_model_move_it(name, write, tmp_path):
    imported = import_machine(*write(name))
    assert farthest(imported, ROUTES[name]) < 1e-9
    assert not (tmp_path / "ran.txt").exists(), "the script is never run"
    turned = replace(imported.machine, axes=tuple(
        replace(axis, direction=tuple(-x for x in axis.direction)) if axis.letter == "C" else axis
        for axis in imported.machine.axes
    ))  # fmt: skip
    assert farthest(replace(imported, machine=turned), ROUTES[name]) > 1.0, "a wrong sign would be noticed"


def test_sides_carriers_and_shapes_are_those_of_the_model(write):
    machine = import_machine(*write()).machine
    assert [(axis.letter, axis.side) for axis in machine.axes] == [
        ("C", "table"), ("A", "table"), ("X", "table"), ("Y", "table"), ("Z", "head")
    ]  # fmt: skip
    bodies = {body.name: body for body in machine.bodies}
    assert {name: (body.carrier, body.shape) for name, body in bodies.items()} == {
        "nose": ("spindle", "cone"), "block": ("Z", "file"), "motor": ("Z", "box"),
        "platter": ("C", "cylinder"), "ball": ("C", "sphere"), "plate": ("A", "box"), "arm": ("A", "file"),
        "slide": ("X", "box"), "screw": ("Y", "cone"), "bed": ("base", "box"),
    }  # fmt: skip
    assert bodies["nose"].radii == (15.0, 25.0) and bodies["nose"].points == ((0, 0, 0), (0, 0, 40))
    assert bodies["screw"].radii == (9.0, 12.0) and bodies["ball"].radii == (4.0,)
    head = import_machine(*write("fork")).machine
    assert [(axis.letter, axis.side) for axis in head.axes] == [
        (letter, "head") for letter in "YXZCB"
    ]  # fmt: skip
    assert {body.name: body.carrier for body in head.bodies} == {
        "spindle": "spindle", "spindle 2": "B", "fork": "C", "ram": "Z", "beam": "X", "bridge": "Y", "body": "base"
    }  # fmt: skip


def test_a_model_that_agrees_says_what_is_taken_and_what_is_the_tool(write):
    notes, left = [[found.text for found in import_machine(*write()).findings if found.code == code]
                   for code in ("machine-default", "model-left-out")]  # fmt: skip
    assert len(notes) == 2 and not left
    assert "10 bodies of mill.py" in notes[0] and "table moves with C, A, X, Y, the tool with Z" in notes[0]
    assert notes[1].startswith("One shape of mill.py moves with the tool's length")


def test_hal_gives_the_script_its_settings_and_units_are_those_of_the_machine(write):
    machine = import_machine(*write(hal=HAL.replace("./mill.py", "./mill.py depth=50"))).machine
    assert next(body for body in machine.bodies if body.name == "bed").points[1] == (295, 293, -300)
    settled = "half = depth / 2 + 1\nfor setting in sys.argv[1:]: exec(setting)\n"
    other = "for setting in sys.argv[1:]: exec(setting)\nhalf = depth / 2 + 1\n"
    machine = import_machine(
        *write("trunnion", (settled, other), hal=HAL.replace("./mill.py", "./mill.py depth=50"))
    ).machine
    assert next(body for body in machine.bodies if body.name == "platter").points[0] == (0, 0, -26)
    inches = import_machine(*write(units="inch")).machine
    assert next(body for body in inches.bodies if body.name == "nose").points[1] == pytest.approx(
        (0, 0, 1016)
    )
    radians = [
        ('platter", 1, 0', 'platter", 57.29577951308232, 0'),
        ('tilt", -1', 'tilt", -57.29577951308232'),
    ]
    assert len(import_machine(*write("trunnion", *radians, angles="rad")).machine.bodies) == 10


def test_a_setting_that_is_no_number_may_be_anything(write):
    """The script would take 2*40 for 80: what hangs on it is left out, not read as it was before."""
    settled = "half = depth / 2 + 1\nfor setting in sys.argv[1:]: exec(setting)\n"
    other = "for setting in sys.argv[1:]: exec(setting)\nhalf = depth / 2 + 1\n"
    hal = HAL.replace("./mill.py", "./mill.py depth=2*40")
    imported = import_machine(*write("trunnion", (settled, other), hal=hal))
    (left,) = [found for found in imported.findings if found.code == "model-left-out"]
    assert "CylinderZ(-half" in left.text
    assert "platter" not in [body.name for body in imported.machine.bodies]


def test_names_of_another_module_may_be_those_of_vismach(write):
    swap = ("import hal, sys\n", "import hal, sys\nfrom OpenGL.GL import *\n")
    assert len(import_machine(*write("trunnion", swap)).machine.bodies) == 10
    with pytest.raises(MachineError, match="main"):
        import_machine(*write("trunnion", ("import hal, sys\n", "import hal, sys\nfrom mine import *\n")))


def test_a_word_of_hal_that_is_too_long_for_a_file_is_none(write, tmp_path):
    write(hal=HAL + "loadusr " + 300 * "x" + "\n")
    assert find_model(tmp_path / "m.ini") == tmp_path / "mill.py"


def test_an_acceleration_that_cannot_be_is_not_taken(write, tmp_path):
    source, model = write()
    for text in ("0", "-5", "abc", "1e999"):
        ini = (tmp_path / "m.ini").read_text(encoding="utf-8")
        (tmp_path / "m.ini").write_text(
            ini.replace("MAX_VELOCITY = 50\n", f"MAX_VELOCITY = 50\nMAX_ACCELERATION = {text}\n")
        )
        machine = import_machine(source, model).machine
        assert all(np.isinf(axis.max_acceleration) for axis in machine.axes)
        write()


def test_the_model_that_hal_starts_is_found(write, tmp_path):
    source, model = write()
    assert find_model(tmp_path / "m.ini") == tmp_path / "mill.py"
    write(hal=HAL.replace("./mill.py", "./arm.stl"))
    assert find_model(tmp_path / "m.ini") is None and (source, model) == write()


def test_a_model_that_is_installed_as_a_command_is_found_and_named_not_taken(
    write, tmp_path, monkeypatch, capsys
):
    source, _ = write(hal=HAL.replace("./mill.py", "mill-gui"))
    folder = tmp_path / "bin"
    folder.mkdir()
    command = folder / ("mill-gui.exe" if os.name == "nt" else "mill-gui")
    (tmp_path / "mill.py").replace(command)
    command.chmod(0o755)
    assert find_model(tmp_path / "m.ini") is None
    monkeypatch.setenv("PATH", str(folder))
    assert find_model(tmp_path / "m.ini") == command
    assert cli.main(["import-machine", source, "-o", str(tmp_path / "m.fcm")]) == 0
    assert f"--bodies {command}" in capsys.readouterr().out
    assert not load_machine(str(tmp_path / "m.fcm")).bodies


def test_pins_of_which_no_hal_file_speaks_are_axes_by_their_names_alone(write):
    swaps = [('"ram"', '"spindle-z"'), ('"yo"', '"offset_y"')]
    hal = (
        "\n".join(line for line in HAL.splitlines() if "mymill" not in line)
        + "\nsetp xyzac-trt-kins.y-offset 0\nsetp xyzac-trt-kins.z-offset 0\n"
    )
    swaps += [('"tilt"', '"tilt-a"'), ('"platter"', '"rotary_c"')]
    imported = import_machine(*write("trunnion", *swaps, hal=hal))
    assert [axis.letter for axis in imported.machine.axes] == list("CAXYZ")
    unset = [found.text for found in imported.findings if "mymill.offset_y" in found.text]
    assert len(unset) == 1 and "LinuxCNC has 0 there" in unset[0] and "mymill.zo" in unset[0]


@pytest.mark.parametrize(
    ("swap", "reported"),
    [
        (("bed = Box(-300", "bed = HalShow([Box(-1, -1, -1, 1, 1, 1)], gui, 1, 'show')  # Box(-300"), "HalShow("),
        (("bed = Box(-300", "bed = Own(gui)  # Box(-300"), "Own(gui)"),
        (("bed = Box(-300", "bed = Box(-abs(300)"), "Box(-abs(300)"),
        (("bed = Box(-300", "bed = Box(300"), "it is flat"),
        (("300, 300, 0)\n", "300, 300, 0)\nfor i in range(3):\n    bed = Translate([bed], i, 0, 0)\n"), "for i in range(3)"),
        (("300, 300, 0)\n", "300, 300, 0)\nif wide:\n    bed.parts = []\n"), "line 43 may have changed"),
        (("300, 300, 0)\n", "300, 300, 0)\nenlarge(bed)\n"), "line 43 may have changed"),
        (("300, 300, 0)\n", "300, 300, 0)\ndef grow():\n    bed.coords = None\n"), "line 43 may have changed"),
        (("300, 300, 0)\n", "300, 300, 0)\nall_ = [bed]\nenlarge(all_)\n"), "line 44 may have changed"),
        (("300, 300, 0)\n", "300, 300, 0)\nall_ = [bed]\nbed = Collection(all_)\nall_ += [tip]\n"), "line 45 may have changed"),
        (("300, 300, 0)\n", "300, 300, 0)\ndef f(): all_.pop()\nall_ = [bed]\nbed = Collection(all_)\nall_ = None\n"), "line 43 may have changed"),
        (("bed = Box(-300", "wide = 300\ndef f():\n    global wide\n    wide = 5\nbed = Box(-wide"), "Box(-wide"),
        (("300, 300, 0)\n", "300, 300, 0)\ntry: f()\nexcept Exception as bed: pass\n"), "try:"),
        (("300, 300, 0)\n", "300, 300, 0)\nmatch f():\n    case bed: pass\n"), "match f()"),
        (("300, 300, 0)\n", "300, 300, 0)\nbed = 0x" + 4000 * "F" + "\n"), "Constant"),
        (("300, 300, 0)\n", "300, 300, 0)\nbed = HalTranslate([bed], gui, 'x', -2, 0, 0)\n"), "moves by 2 times X"),
        (("300, 300, 0)\n", "300, 300, 0)\nbed = HalTranslate([bed], gui, 'x', 0, 1, 0)\n"), "moves by X as neither"),
        (("300, 300, 0)\n", "300, 300, 0)\nbed = Rotate([bed], 90, 0, 0, 0)\n"), "turns about no direction"),
        (("bed = Box(-300", "bed = Box(-1e300"), "Box(-1e+300"),
        (("bed = Box(-300", "bed = Box(-1e300 * 1e300"), "Box("),
        (("bed = Box(-300, -300, -50, 300, 300, 0)", "bed = CylinderX(0, -5, 10, -5)"), "radius"),
        (("bed = Box(-300, -300, -50, 300, 300, 0)", "bed = 'box'"), "'box'"),
        (("bed = Box(-300, -300, -50, 300, 300, 0)", "bed = AsciiOBJ('bed.obj')"), "AsciiOBJ('bed.obj')"),
    ],
)  # fmt: skip
def test_what_is_not_plain_is_reported_by_its_line_and_left_out(swap, reported, write):
    imported = import_machine(*write("trunnion", swap))
    assert [body.name for body in imported.machine.bodies] == [
        name for name in of_trunnion(0, 0, 0, 0, 0) if name != "bed"
    ]
    (left,) = [found for found in imported.findings if found.code == "model-left-out"]
    assert reported in left.text and "line 4" in left.text and left.value == 1.0


def test_one_shape_left_out_leaves_its_neighbours_in(write):
    """A list that a loop may have changed, and an own class beside plain shapes."""
    swap = (
        "bed = Box(-300",
        "legs = [Sphere(0, 0, -200, 9)]\nfor i in range(4): legs.append(Sphere(i, 0, 0, 1))\nbed = Box(-300",
    )
    imported = import_machine(
        *write("trunnion", swap, ("[ram, table, bed]", "[ram, table, Collection(legs), Own(gui), bed]"))
    )
    assert len(imported.machine.bodies) == 10
    (left,) = [found for found in imported.findings if found.code == "model-left-out"]
    assert "which line 43 may have changed" in left.text and "Own(gui)" in left.text


@pytest.mark.parametrize(
    ("swap", "reported"),
    [
        (
            ('"tilt", -1, -1, 0, 0', '"tilt", 1, -1, 0, 0'),
            "moves A along or about (-1, 0, 0), the kinematics (1, 0, 0)",
        ),
        (
            ('"ram", 0, 0, 1', '"ram", 0, 0, -1'),
            "moves Z along or about (0, 0, -1), the kinematics (0, 0, 1)",
        ),
        (('0, "yo", "zo")', '0, 0, "zo")'), "turns A about a line that is 20 mm from that of the kinematics"),
    ],
)
def test_what_the_model_moves_otherwise_than_the_kinematics_is_reported(swap, reported, write):
    found = [one for one in import_machine(*write("trunnion", swap)).findings if one.code == "model-differs"]
    assert len(found) >= 1 and reported in found[0].text


@pytest.mark.parametrize(
    ("swaps", "words"),
    [
        ([("main(model", "draw(model")], r"has no main\(model, tool, work\)"),
        ([("depth = 30", "depth = = 30")], "line 6 is no Python 3"),
        ([("depth = 30", "exec setting")], "line 6 is no Python 3"),
        ([("depth = 30", "depth = \0")], "is no script"),
        ([("depth = 30", "depth = " + "(" * 300 + ")" * 300)], "line 6 is no Python 3"),
        ([("depth = 30", "depth = " + "-" * 20000 + "1")], "is no Python 3|is nested too deep"),
        ([("ram = HalTranslate([ram], gui", "ram = HalShow([ram], gui")], "captures at tool and work.*HalShow"),
        ([('"y", 0, -1, 0)', '"elsewhere", 0, -1, 0)')], "nothing in it moves tool or work by Y"),
        ([("ram = Translate(", "ram = HalTranslate([ram], gui, 'y', 0, 1, 0)\nram = Translate(")], "both move tool or work by Y"),
        ([('gui, "platter", 1, 0, 0, 2', 'gui, "tilt", 1, 1, 0, 0'), ('gui, "tilt", -1, -1, 0, 0', 'gui, "platter", 1, 0, 0, 1')],
         r"from work to tool it has A \(table\) C \(table\) XYZ, the kinematics C \(table\) A \(table\) XYZ"),
        ([("ram = Translate(", "ram = Rotate([ram], 10, 1, 0, 0)\nram = Translate(")], "its tool does not stand along Z"),
        ([("arm.stl", "leg.stl")], r"line 31: .*leg.stl is not found; put it beside the model"),
        ([("[ram, table, bed]", "[ram, table, " + "bed, " * 600 + "bed]")], "has more than 500 shapes"),
        ([("model = Coll", "a = [bed]\n" + "a = [Collection(a), Collection(a)]\n" * 40 + "bed = Collection(a)\nmodel = Coll")], "too many parts"),
    ],
)  # fmt: skip
def test_a_model_that_does_not_fit_is_refused_in_one_line(swaps, words, write):
    files = write("trunnion", *swaps)
    with pytest.raises(MachineError, match=words) as caught:
        import_machine(*files)
    assert "\n" not in str(caught.value) and str(files[1]) in str(caught.value)


def test_the_command_writes_bodies_and_meshes_and_refuses_a_model_without_ini(write, tmp_path, capsys):
    source, model = write()
    assert cli.main(["import-machine", source, "--bodies", model, "-o", str(tmp_path / "out.fcm")]) == 0
    assert "10 bodies of mill.py" in capsys.readouterr().out
    machine, expected = load_machine(str(tmp_path / "out.fcm")), import_machine(source, model).machine
    assert [replace(body, file="") for body in machine.bodies] == [
        replace(body, file="") for body in expected.bodies
    ]
    assert [axis.side for axis in machine.axes] == [axis.side for axis in expected.axes]
    assert sum(body.shape == FILE for body in machine.bodies) == 2
    code = cli.main(
        ["import-machine", str(tmp_path / "out.fcm"), "--bodies", model, "-o", str(tmp_path / "b.fcm")]
    )
    assert code == cli.UNUSABLE and "leave it out for" in capsys.readouterr().err
    assert (
        cli.main(["import-machine", source, "--bodies", "none.py", "-o", str(tmp_path / "b.fcm")])
        == cli.UNUSABLE
    )
    assert not (tmp_path / "b.fcm").exists()


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    spots=st.lists(
        st.tuples(st.integers(0, len(TRUNNION) - 1), st.sampled_from("()[],.'=\n#01-e:*\0x")), max_size=6
    )
)
def test_no_spoilt_model_gives_a_traceback(spots, write):
    text = list(TRUNNION)
    for place, sign in spots:
        text[place] = sign
    source, model = write("trunnion", (TRUNNION, "".join(text)))
    try:
        import_machine(source, model)
    except FiveAxisError as error:
        assert "\n" not in str(error)
