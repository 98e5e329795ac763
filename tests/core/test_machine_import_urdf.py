# SPDX-License-Identifier: LGPL-2.1-or-later
"""A URDF file becomes the machine that it describes: a trunnion written here is compared with the shipped
one, and with products of its own joints' matrices, at random joints. What is no machine is refused by
name."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mesh_shapes import box

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import FiveAxisError, MachineError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.geometry.mesh import from_triangles, read_stl, write_stl
from freecad_fiveaxis.core.machine import load_machine
from freecad_fiveaxis.core.machine.importing import import_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward

BASE = np.array([100.0, 200.0, 800.0])
"""Where the trunnion's machine zero is in the URDF's root, mm."""
TURNS, TRAVEL = 'lower="-2.0943951023931953" upper="2.0943951023931953" velocity="1.5707963267948966"', 'lower="-0.5" upper="0.5" velocity="0.5"'  # fmt: skip
TRUNNION = f"""<?xml version="1.0"?>
<robot name="home trunnion">
  <link name="base"><collision><origin xyz="0.1 0.2 0.6"/><geometry><box size="0.4 0.6 0.1"/></geometry></collision></link>
  <link name="cradle"><visual><geometry><mesh filename="package://mill/meshes/cradle.stl" scale="0.001 0.001 0.001"/></geometry></visual></link>
  <link name="platter"><collision><origin xyz="0 0 -0.065"/><geometry><cylinder radius="0.08" length="0.03"/></geometry></collision>
    <visual><geometry><mesh filename="fine.dae"/></geometry></visual></link>
  <link name="table"/>
  <link name="x_slide"/> <link name="y_slide"/> <link name="ram"/>
  <link name="tool"><collision><origin xyz="0 0 0.03" rpy="0 1.5708 0"/><geometry><box size="0.06 0.07 0.08"/></geometry></collision>
    <collision><geometry><sphere radius="0.02"/></geometry></collision></link>
  <joint name="joint_a" type="revolute"><parent link="base"/><child link="cradle"/><origin xyz="0.1 0.2 0.75"/>
    <axis xyz="-1 0 0"/><limit {TURNS} effort="9"/></joint>
  <joint name="joint_c" type="continuous"><parent link="cradle"/><child link="platter"/>
    <axis xyz="0 0 -1"/><limit velocity="2.6179938779914944"/></joint>
  <joint name="top" type="fixed"><parent link="platter"/><child link="table"/><origin xyz="0 0 0.05"/></joint>
  <joint name="x" type="prismatic"><parent link="base"/><child link="x_slide"/><origin xyz="0 0.2 1.0" rpy="0 0 1.5708"/>
    <axis xyz="0 -1 0"/><limit {TRAVEL}/></joint>
  <joint name="y" type="prismatic"><parent link="x_slide"/><child link="y_slide"/><axis xyz="1 0 0"/><limit {TRAVEL}/></joint>
  <joint name="z" type="prismatic"><parent link="y_slide"/><child link="ram"/><axis xyz="0 0 1"/><limit {TRAVEL}/></joint>
  <joint name="nose" type="fixed"><parent link="ram"/><child link="tool"/><origin xyz="0 -0.1 -0.2"/></joint>
  <transmission name="not read"><joint name="x"/></transmission>
</robot>
"""  # fmt: skip


@pytest.fixture
def write(tmp_path):
    """A function that writes the trunnion, pieces of its text replaced, and the mesh of its cradle; returns
    its path."""
    (tmp_path / "mill" / "meshes").mkdir(parents=True)
    (tmp_path / "mill" / "urdf").mkdir()
    write_stl(
        from_triangles(box((-100, -50, -60), (100, 50, -40))), tmp_path / "mill" / "meshes" / "cradle.stl"
    )

    def act(*swaps, name="mill.urdf"):
        text = TRUNNION
        for old, new in swaps:
            assert old in text
            text = text.replace(old, new)
        path = tmp_path / "mill" / "urdf" / name
        path.write_text(text, encoding="utf-8")
        return path

    return act


def turn(axis, angle):
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross


def at(*xyz, turned=None):
    found = np.eye(4)
    found[:3, 3] = xyz
    if turned is not None:
        found[:3, :3] = turned
    return found


def by_matrices(joints):
    """The tool's point and axis in the frame of the table, mm, by the joints that stand in TRUNNION (x, y, z
    m; a, c rad)."""
    x, y, z, a, c = joints
    table = (
        at(0.1, 0.2, 0.75)
        @ at(0, 0, 0, turned=turn((-1, 0, 0), a))
        @ at(0, 0, 0, turned=turn((0, 0, -1), c))
        @ at(0, 0, 0.05)
    )
    slide = at(0, 0.2, 1.0, turned=turn((0, 0, 1), 0.5 * math.pi)) @ at(0, -x, 0)
    tool = slide @ at(y, 0, 0) @ at(0, 0, z) @ at(0, -0.1, -0.2)
    seen = np.linalg.inv(table) @ tool
    return 1000.0 * seen[:3, 3], seen[:3, 2]


def test_a_trunnion_is_the_shipped_one_but_for_where_its_zero_is(write):
    machine, shipped = import_machine(str(write())).machine, load_machine("trunnion_ac")
    assert machine.letters == shipped.letters == "CAXYZ" and machine.name == "home trunnion"
    for ours, theirs in zip(machine.axes, shipped.axes, strict=True):
        assert (ours.letter, ours.side, ours.rotary) == (theirs.letter, theirs.side, theirs.rotary)
        assert ours.direction == pytest.approx(theirs.direction, abs=1e-15)
        assert (ours.low, ours.high) == pytest.approx((theirs.low, theirs.high), abs=1e-12)
        assert ours.max_rate == pytest.approx(theirs.max_rate, rel=1e-12)
    assert machine.gauge_point == pytest.approx(BASE) and machine.origin == pytest.approx(BASE)
    words = np.random.default_rng(3).uniform(-1, 1, (300, 5)) * (200, 200, 200, math.pi, 2.0)
    found, expected = (forward(chain(one, Setup(one.origin)), words) for one in (machine, shipped))
    assert np.abs(found[0] - expected[0]).max() < 1e-9 and np.abs(found[1] - expected[1]).max() < 1e-12
    moved = replace(
        machine,
        axes=tuple(
            replace(axis, point=(0.0, 0.0, 1.0)) if axis.letter == "A" else axis for axis in machine.axes
        ),
    )
    assert np.abs(forward(chain(moved, Setup(moved.origin)), words)[0] - expected[0]).max() > 1.0, (
        "a wrong point would be noticed"
    )


def test_the_tip_is_where_the_urdf_s_own_matrices_put_it(write):
    machine = import_machine(str(write())).machine
    kinematics = chain(machine, Setup(machine.origin))
    joints = np.random.default_rng(4).uniform(-1, 1, (200, 5)) * (0.5, 0.5, 0.5, 2.0, 3.0)
    order = [kinematics.letters.index(letter) for letter in "XYZAC"]
    words = np.empty((200, 5))
    words[:, order] = joints * (1000.0, 1000.0, 1000.0, 1.0, 1.0)
    tip, axis = forward(kinematics, words)
    points, axes = zip(*map(by_matrices, joints), strict=True)
    assert np.abs(tip - points).max() < 1e-9 and np.abs(axis - axes).max() < 1e-12


def test_a_head_moves_the_tool_as_its_joints_say(tmp_path):
    """A fork C, B on a ram, over a table that stands still: products of matrices again."""
    limit = '<limit lower="-2" upper="2" velocity="1"/>'
    rows = [("saddle", "base", "1 0 0", "0 0 0", "prismatic"), ("beam", "saddle", "0 1 0", "0 0 0.3", "prismatic"),
            ("ram", "beam", "0 0 1", "0.1 0 0", "prismatic"), ("fork", "ram", "0 0 1", "0 0.02 0", "revolute"),
            ("spindle", "fork", "0 1 0", "0.03 0 -0.1", "revolute")]  # fmt: skip
    text = "".join(
        f'<link name="{child}"/><joint name="{child}_joint" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{place}"/><axis xyz="{axis}"/>{limit}</joint>'
        for child, parent, axis, place, kind in rows
    )
    path = tmp_path / "fork.urdf"
    table = '<link name="base"/><link name="table"/><joint name="bed" type="fixed"><parent link="base"/><child link="table"/><origin xyz="0 0 -0.4"/></joint>'  # fmt: skip
    path.write_text(f'<robot name="fork">{table}{text}</robot>')
    machine = import_machine(str(path)).machine
    assert machine.letters == "XYZCB" and {axis.side for axis in machine.axes} == {"head"}
    kinematics = chain(machine, Setup(machine.origin))
    gauge = np.array(machine.gauge_point) - machine.origin
    for x, y, z, c, b in np.random.default_rng(5).uniform(-0.5, 0.5, (50, 5)):
        seen = at(x, 0, 0) @ at(0, y, 0.3) @ at(0.1, 0, z) @ at(0, 0.02, 0, turned=turn((0, 0, 1), c))
        seen = seen @ at(0.03, 0, -0.1, turned=turn((0, 1, 0), b))
        tip, axis = forward(kinematics, np.array([[*(1000.0 * np.array([x, y, z]) + gauge), c, b]]))
        assert np.abs(tip[0] - (1000.0 * seen[:3, 3] - machine.origin)).max() < 1e-9
        assert np.abs(axis[0] - seen[:3, 2]).max() < 1e-12


def test_shapes_become_bodies_where_they_stand_on_the_axis_that_moves_them(write, tmp_path, capsys):
    out = tmp_path / "mine.fcm"
    (tmp_path / "mine cradle.stl").write_text("somebody's")
    assert cli.main(["import-machine", str(write()), "-o", str(out)]) == cli.DONE
    reported = capsys.readouterr().out
    assert (
        "A table 1,0,0" in reported
        and "cradle (A)" in reported
        and f"wrote {out}" in reported
        and "mine cradle-2.stl" in reported
    )
    bodies = json.loads(out.read_bytes())["fiveaxis"]["bodies"]
    assert bodies == [
        {"name": "base", "carrier": "base", "box": {"low": [-100.0, -100.0, 550.0], "high": [300.0, 500.0, 650.0]}},
        {"name": "cradle", "carrier": "A", "file": "mine cradle-2.stl"},
        {"name": "platter", "carrier": "C", "cylinder": {"low": [100.0, 200.0, 670.0], "high": [100.0, 200.0, 700.0], "radius": 80.0}},
        {"name": "tool", "carrier": "spindle", "box": {"low": [65.0, 160.0, 800.0], "high": [135.0, 240.0, 860.0]}},
        {"name": "tool 2", "carrier": "spindle", "sphere": {"centre": [100.0, 200.0, 800.0], "radius": 20.0}},
    ]  # fmt: skip
    assert [tuple(one) for one in read_stl(tmp_path / "mine cradle-2.stl").box] == [
        (0.0, 150.0, 690.0),
        (200.0, 250.0, 710.0),
    ]
    assert (tmp_path / "mine cradle.stl").read_text() == "somebody's"
    assert len(load_machine(out).bodies) == 5


def test_a_box_that_leans_is_a_mesh_and_a_mirrored_mesh_keeps_its_outside_out(write):
    leaning = import_machine(str(write(('xyz="0.1 0.2 0.6"/>', 'xyz="0.1 0.2 0.6" rpy="0 0 0.5"/>'))))
    corner = leaning.meshes["base"].vertex - (100.0, 200.0, 600.0)
    assert np.allclose(
        sorted(np.abs(corner @ turn((0, 0, 1), 0.5)).max(axis=0)), (50.0, 200.0, 300.0), atol=1e-6
    )
    mesh = import_machine(str(write(("0.001 0.001 0.001", "-0.001 0.001 0.002")))).meshes["cradle"]
    assert [tuple(np.round(one, 6)) for one in mesh.box] == [(0.0, 150.0, 630.0), (200.0, 250.0, 670.0)]
    volume = (
        np.einsum(
            "fi,fi->", np.cross(*np.moveaxis(mesh.vertex[mesh.face], 1, 0)[:2]), mesh.vertex[mesh.face][:, 2]
        )
        / 6.0
    )
    assert volume == pytest.approx(200.0 * 100.0 * 40.0)


def test_what_is_assumed_is_reported(write):
    found = import_machine(str(write())).findings
    assert [one.code for one in found] == ["machine-default", "sign-unproven"] and found[
        1
    ].severity == Severity.WARNING
    assert (
        "C joint_c, A joint_a" in found[0].text and "(100, 200, 800) mm, the origin of tool" in found[0].text
    )
    (plain,) = [one for one in import_machine(str(bare(write))).findings if "no bodies" in one.text]
    assert plain.code == "machine-default"


def bare(write):
    """The trunnion without shapes."""
    path = write()
    text = path.read_text()
    while "<collision>" in text or "<visual>" in text:
        for tag in ("collision", "visual"):
            first, stop = text.find(f"<{tag}>"), text.find(f"</{tag}>")
            text = text if first < 0 else text[:first] + text[stop + len(tag) + 3 :]
    path.write_text(text)
    return path


@pytest.mark.parametrize(
    ("swaps", "letters"),
    [
        ([], "CAXYZ"),
        ([('name="x"', 'name="linear_1"')], "CAXYZ"),  # by directions then, as all of its kind
        ([('name="joint_a"', 'name="tilt"')], "CAXYZ"),
        ([('name="joint_a"', 'name="B-axis"')], "CBXYZ"),
        ([('name="x"', 'name="axisY"'), ('name="y"', 'name="X_joint"')], "CAYXZ"),
    ],
)  # fmt: skip
def test_letters_come_from_names_or_else_from_directions(swaps, letters, write):
    assert import_machine(str(write(*swaps))).machine.letters == letters


@pytest.mark.parametrize(
    ("swaps", "words"),
    [
        ([('type="revolute"', 'type="planar"')], ["joint joint_a", "planar", "known are prismatic"]),
        ([('<limit velocity="2.6179938779914944"/>', "")], ["joint joint_c has no <limit>"]),
        ([(TRAVEL, 'lower="-0.5" upper="0.5"')], ["joint x <limit> lacks velocity="]),
        ([(TRAVEL, 'lower="-0.5" upper="0.5" velocity="0"')], ["joint x", "maximum rate 0 is not positive"]),
        ([(TRAVEL, 'lower="0" upper="0" velocity="1"')], ["joint", "limits min"]),
        ([(TRAVEL, 'lower="low" upper="0" velocity="1"')], ["joint x: lower is 'low'", "a finite number"]),
        ([('xyz="0 0 -1"', 'xyz="0 0"')], ["joint joint_c: xyz is '0 0'", "3 finite numbers"]),
        ([('xyz="0 0 -1"', 'xyz="0 0 0"')], ["joint joint_c has the axis 0 0 0"]),
        ([('name="joint_c" type="continuous"', 'name="tilt" type="continuous"'), ('xyz="0 0 -1"', 'xyz="0 1 -1"')], ["joint tilt runs along none of X, Y, Z"]),
        ([('name="z" type', 'name="lift" type'), ('<axis xyz="0 0 1"/>', '<axis xyz="1 0 0"/>')], ["y, lift would all be Y"]),
        ([('name="z" type="prismatic"', 'name="z" type="fixed"')], ["x, y run straight", "joint_c, joint_a turn", "needs three"]),
        ([('<link name="table"/>', '<link name="plate"/>'), ('<child link="table"/>', '<child link="plate"/>')], []),
        ([('"platter"', '"rotor"'), ('<link name="table"/>', '<link name="top"/>'), ('<child link="table"/>', '<child link="top"/>')], ["no link is called table, platter"]),
        ([('<link name="y_slide"/>', '<link name="y_slide"/><link name="tool changer"/><joint name="hold" type="fixed"><parent link="base"/><child link="tool changer"/></joint>')], ["tool changer", "only one"]),
        ([('<link name="y_slide"/>', '<link name="y_slide"/><link name="door"/><joint name="hinge" type="continuous"><parent link="base"/><child link="door"/><limit velocity="1"/></joint>')], ["hinge move neither"]),
        ([('<parent link="y_slide"/>', '<parent link="slide"/>')], ["joint z names the link slide"]),
        ([('<child link="ram"/>', '<child link="table"/>')], ["two joints carry the link table"]),
        ([('<parent link="base"/><child link="x_slide"/>', '<parent link="tool"/><child link="x_slide"/>')], ["x_slide, y_slide, ram, tool carry one another in a circle"]),
        ([('<link name="x_slide"/>', '<link name="x_slide"/><link name="floor"/>')], ["base, floor"]),
        ([('<link name="x_slide"/>', '<link name="x_slide"/><link name="ram"/>')], ["two links or joints are called ram"]),
        ([('<origin xyz="0 -0.1 -0.2"/>', '<origin xyz="0 -0.1 -0.2" rpy="1.5708 0 0"/>')], ["Z axis of tool leans 90 deg"]),
        ([("cradle.stl", "cradle.dae")], ["cradle", "cradle.dae is not found"]), ([("cradle.stl", "gone.stl")], ["gone.stl is not found"]),
        ([('"0.001 0.001 0.001"', '"0.001 0 0.001"')], ["cradle: the scale 0.001 0 0.001"]),
        ([('<sphere radius="0.02"/>', '<capsule radius="0.02"/>')], ["link tool has the geometry capsule"]),
        ([('<sphere radius="0.02"/>', '<sphere radius="-2"/>')], ["tool 2: the sizes -2 of its sphere"]),
        ([('<sphere radius="0.02"/>', '<sphere radius="1e6"/>')], ["radius", "not above 0, or beyond"]),
        ([('<?xml version="1.0"?>', '<!DOCTYPE robot [<!ENTITY a "b">]>')], ["entities"]), ([("</robot>", "")], ["no XML"]),
        ([("<robot", "<sdf"), ("</robot>", "</sdf>")], ["root is <sdf>"]), ([('<link name="x_slide"/>', '<xacro:x xmlns:xacro="u"/>')], ["xacro"]),
        ([('<axis xyz="1 0 0"/>', '<axis xyz="1 0 0"/><mimic joint="x"/>')], ["joint y follows another"]),
    ],
)  # fmt: skip
def test_what_is_no_machine_is_refused_by_name_in_one_line(swaps, words, write, tmp_path):
    path = write(*swaps)
    if not words:  # the platter is the table then
        assert import_machine(str(path)).machine.letters == "CAXYZ"
        return
    with pytest.raises(FiveAxisError) as caught:
        import_machine(str(path))
    assert all(word in str(caught.value) for word in ["mill.urdf", *words]) and "\n" not in str(caught.value)
    assert cli.main(["import-machine", str(path), "-o", str(tmp_path / "out.fcm")]) == cli.UNUSABLE
    assert not list(tmp_path.glob("out*")), "no file is left"


def test_a_mesh_that_is_no_stl_is_named_with_the_remedy(write):
    path = write(("package://mill/meshes/cradle.stl", "cradle.dae"))
    (path.parent / "cradle.dae").write_text("<COLLADA/>")
    with pytest.raises(
        MachineError, match=r"mill.urdf: cradle: the mesh cradle.dae is no STL file; convert it"
    ):
        import_machine(str(path))


def test_meshes_are_found_in_packages_beside_and_by_whole_names(write, tmp_path):
    whole = (tmp_path / "mill" / "meshes" / "cradle.stl").as_uri()
    for given_name in ("../meshes/cradle.stl", whole, str(tmp_path / "mill" / "meshes" / "cradle.stl")):
        assert "cradle" in import_machine(str(write(("package://mill/meshes/cradle.stl", given_name)))).meshes


@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(spots=st.lists(st.tuples(st.floats(0, 1), st.sampled_from(['"', "<", ">", "0", "1e300", "-", "nan", "link", "/", ""]), st.integers(0, 9)), max_size=4))  # fmt: skip
def test_no_spoilt_file_gives_a_traceback(spots, write):
    path = write()
    text = path.read_text()
    for where, piece, length in spots:
        first = int(where * len(text))
        text = text[:first] + piece + text[first + length :]
    path.write_text(text)
    try:
        import_machine(str(path))
    except FiveAxisError as error:
        assert "\n" not in str(error)
