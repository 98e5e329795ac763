# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines made from LinuxCNC's configurations and FreeCAD's machine files, and the one line that names what
is missing."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import FileError, FiveAxisError, MachineError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.machine import load_machine, save_machine
from freecad_fiveaxis.core.machine.importing import import_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward
from freecad_fiveaxis.core.machine.machine_file import machine_folder

INI = """# a mill
[EMC]
VERSION = 1.1
MACHINE = my mill
[KINS]
KINEMATICS = {module} sparm=identityfirst
JOINTS = 5
[HAL]
HALFILE = LIB:basic_sim.tcl
HALFILE = mill.hal
HALCMD = net :tool-offset motion.tooloffset.z => {module}.tool-offset
[TRAJ]
COORDINATES = {letters}
LINEAR_UNITS = mm
ANGULAR_UNITS = deg
"""
AXIS = """[AXIS_{letter}]
MIN_LIMIT = {low}
MAX_LIMIT = {high}
MAX_VELOCITY = {rate}
[JOINT_{joint}]
TYPE = {kind}
MIN_LIMIT = {low}
MAX_LIMIT = {high}
MAX_VELOCITY = {rate}
"""
OFFSETS = {
    "xyzac": "setp {m}.y-offset 20\nsetp {m}.z-offset 10\n",
    "xyzbc": "setp {m}.x-offset -20\nsetp {m}.z-offset -15\n",
}
KINDS = pytest.mark.parametrize("kind", ["xyzac", "xyzbc"])
LIMITS = {"X": (-300, 300, 20000 / 60), "Y": (-300, 300, 20000 / 60), "Z": (-300, 300, 20000 / 60), "A": (-100, 50, 90), "B": (-100, 50, 90), "C": (-36000, 36000, 150)}  # fmt: skip


@pytest.fixture
def write(tmp_path):
    """A configuration like that of the shipped machine, with pieces of its texts replaced."""

    def make(kind: str = "xyzac", hal: str | None = None, **changed: dict[str, str]) -> Path:
        module, letters = f"{kind}-trt-kins", kind.upper()
        ini = INI.format(module=module, letters=letters)
        for joint, letter in enumerate(letters):
            low, high, rate = LIMITS[letter]
            ini += AXIS.format(
                letter=letter,
                joint=joint,
                low=low,
                high=high,
                rate=rate,
                kind="LINEAR" if letter in "XYZ" else "ANGULAR",
            )
        for old, new in changed.get("swap", {}).items():
            assert old in ini
            ini = ini.replace(old, new)
        (tmp_path / "mill.ini").write_bytes(ini.encode())
        (tmp_path / "mill.hal").write_text((OFFSETS[kind] if hal is None else hal).replace("{m}", module))
        return tmp_path / "mill.ini"

    return make


@KINDS
def test_linuxcncs_simulation_gives_the_shipped_machine(kind, write) -> None:
    imported = import_machine(str(write(kind)))
    shipped = load_machine(f"linuxcnc_{kind}_trt")
    assert imported.findings == ()
    for ours, theirs in zip(imported.machine.axes, shipped.axes, strict=True):
        assert ours == replace(theirs, max_rate=ours.max_rate)
        assert ours.max_rate == pytest.approx(theirs.max_rate, rel=1e-12)
    assert (imported.machine.controller, imported.machine.name) == ("linuxcnc", "my mill")


@KINDS
@pytest.mark.parametrize("sense", [-1.0, 1.0], ids=["as it is", "conventional-directions"])
def test_the_tip_is_where_the_modules_formula_puts_it(kind, sense, write) -> None:
    """P = r + Rz(-C)(d + Rx(-A)(J - r - d)), with Ry for B; with conventional directions the angles change
    sign."""
    r, d = (
        np.array([3.0, -5.0, -40.0]),
        np.array([0.0, 20.0, 10.0] if kind == "xyzac" else [-20.0, 0.0, -15.0]),
    )
    pins = dict(zip(("x-rot-point", "y-rot-point", "z-rot-point"), r, strict=True)) | {
        "conventional-directions": int(sense > 0)
    }
    hal = OFFSETS[kind] + "".join(f"setp {{m}}.{pin} {value}\n" for pin, value in pins.items())
    machine = import_machine(str(write(kind, hal))).machine
    kinematics = chain(machine, Setup(machine.origin))
    joints = np.random.default_rng(2).uniform(-1, 1, (200, 5)) * (100, 100, 100, 3, 3)
    for q in joints:
        tilt, turn = q[3], q[4]
        expected = r + _turn("z", sense * turn) @ (
            d + _turn("x" if kind == "xyzac" else "y", sense * tilt) @ (q[:3] - r - d)
        )
        tip, axis = forward(kinematics, np.array([[*q[:3], q[4], q[3]]]))
        assert np.abs(tip[0] - expected).max() < 1e-11
        assert (
            np.abs(
                axis[0]
                - _turn("z", sense * turn) @ _turn("x" if kind == "xyzac" else "y", sense * tilt) @ (0, 0, 1)
            ).max()
            < 1e-13
        )


def _turn(about: str, angle: float) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    return np.array({"x": [[1, 0, 0], [0, c, -s], [0, s, c]], "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]], "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]]}[about])  # fmt: skip


@pytest.mark.parametrize(
    "hal",
    [
        "setp {m}.y-offset 20 # from the drawing\nsetp {m}.z-offset 10\n",
        "net up {m}.y-offset => gui.y\nnet zo <= {m}.z-offset\nsets up 20\nsets zo 10\n",
        "{m}.y-offset = 20\n{m}.z-offset=10\n",
        "hal setp {m}.y-offset 20; \nsetp {m}.z-offset [OFFSETS](Z)\n",
        "setp {m}.y-offset \\\n   20\nsetp {m}.z-offset [OFFSETS]Z\n",
        "hal setp {m}.y-offset $::OFFSETS(Y)\nsetp {m}.z-offset 1\nsource more.hal\n",
        "setp {m}.y-offset 2e1\r\nlinkps {m}.z-offset zo\r\nsets zo 10.0\r\n",
    ],
)
def test_offsets_are_found_however_hal_says_them(hal, write, tmp_path) -> None:
    (tmp_path / "more.hal").write_text("setp xyzac-trt-kins.z-offset 10\n")
    path = write(hal=hal, swap={"[KINS]": "[OFFSETS]\nY = 20\nZ = 10\n[KINS]"})
    assert import_machine(str(path)).machine.rotary[1].point == (0.0, 20.0, 10.0)


def test_inches_and_radians_become_mm_and_radians(write) -> None:
    machine = import_machine(str(write(swap={"= mm": "= inch", "= deg": "= radian"}))).machine
    plain = import_machine(str(write())).machine
    assert np.allclose(machine.rotary[1].point, 25.4 * np.array(plain.rotary[1].point))
    for ours, theirs in zip(machine.axes, plain.axes, strict=True):
        factor = math.degrees(1.0) if ours.rotary else 25.4
        assert ours.max_rate == pytest.approx(factor * theirs.max_rate)
        assert ours.letter == "C" or ours.low == pytest.approx(
            factor * theirs.low
        )  # C's are beyond all turns then


def test_limits_come_from_the_joint_or_else_the_axis_and_of_rotary_axes_the_narrower(write) -> None:
    lost = write(
        swap={
            "[JOINT_0]\nTYPE = LINEAR\nMIN_LIMIT = -300\n": "[JOINT_0]\nTYPE = LINEAR\n",
            "[AXIS_X]\nMIN_LIMIT = -300": "[AXIS_X]\nMIN_LIMIT = -250",
        }
    )
    assert import_machine(str(lost)).machine.axes[2].low == -250.0
    wide = write(
        swap={
            "[AXIS_Y]\nMIN_LIMIT = -300": "[AXIS_Y]\nMIN_LIMIT = -9",
            "[AXIS_A]\nMIN_LIMIT = -100": "[AXIS_A]\nMIN_LIMIT = -80",
        }
    )
    machine = import_machine(str(wide)).machine
    assert machine.axes[3].low == -300.0 and machine.axes[1].low == pytest.approx(math.radians(-80))
    free = write(swap={"MIN_LIMIT = -36000": "MIN_LIMIT = -1e99"})
    assert import_machine(str(free)).machine.axes[0].low == -math.inf


def test_a_rotary_axis_without_either_limit_turns_without_end_and_that_is_stated(write) -> None:
    """As LinuxCNC's own four-axis simulations have it; one limit alone is still refused."""
    found = import_machine(str(write(swap={"MIN_LIMIT = -36000\nMAX_LIMIT = 36000\n": ""})))
    axis = found.machine.axes[0]
    assert (axis.letter, axis.low, axis.high) == ("C", -math.inf, math.inf)
    notes = [one for one in found.findings if one.code == "axis-endless"]
    assert [one.severity for one in notes] == [Severity.NOTE] and "gives C neither" in notes[0].text
    assert "axis-endless" not in [one.code for one in import_machine(str(write())).findings]
    with pytest.raises(MachineError, match="MIN_LIMIT is missing; axis X"):
        import_machine(
            str(write(swap={"MIN_LIMIT = -300\nMAX_LIMIT = 300\nMAX_VELOCITY = 333": "MAX_VELOCITY = 333"}))
        )


def test_an_axis_that_takes_signs_for_directions_is_refused(write) -> None:
    """LinuxCNC's unwrap_rotary: C-30 of a wrapped axis is 30 deg, reached backwards."""
    with pytest.raises(MachineError, match=r"ini line \d+: WRAPPED_ROTARY takes C-30"):
        import_machine(str(write(swap={"[AXIS_C]\n": "[AXIS_C]\nWRAPPED_ROTARY = 1\n"})))
    found = import_machine(str(write(swap={"[AXIS_C]\n": "[AXIS_C]\nWRAPPED_ROTARY = 0\n"})))
    assert found.machine.axes == import_machine(str(write())).machine.axes


def test_the_lower_acceleration_counts_and_none_need_be_given(write, tmp_path) -> None:
    """[JOINT_0] 400 and [AXIS_X] 250 mm/s^2 for X, [JOINT_4] 90 deg/s^2 for C alone, nothing for Y."""
    swap = {
        "[JOINT_0]\n": "[JOINT_0]\nMAX_ACCELERATION = 400\n",
        "[AXIS_X]\n": "[AXIS_X]\nMAX_ACCELERATION = 250\n",
        "[JOINT_4]\n": "[JOINT_4]\nMAX_ACCELERATION = 90\n",
    }
    machine = import_machine(str(write(swap=swap))).machine
    found = {axis.letter: axis.max_acceleration for axis in machine.axes}
    assert found["X"] == 250.0 and found["C"] == pytest.approx(math.pi / 2) and found["Y"] == math.inf
    save_machine(machine, tmp_path / "saved.fcm")
    assert load_machine(str(tmp_path / "saved.fcm")).axes == machine.axes
    none = import_machine(str(write(swap={"[JOINT_0]\n": "[JOINT_0]\nMAX_ACCELERATION = 0\n"}))).machine
    assert [axis.max_acceleration for axis in none.axes] == [math.inf] * 5  # LinuxCNC takes such a file


def test_included_files_and_other_orders_of_joints_are_read(write, tmp_path) -> None:
    (tmp_path / "axes.inc").write_text("[TRAJ]\nANGULAR_UNITS = deg\n")
    path = write(swap={"ANGULAR_UNITS = deg\n": "#INCLUDE axes.inc\n", "sparm=": "coordinates=xyzca sparm="})
    text = (
        path.read_text()
        .replace("JOINT_3", "JOINT_x")
        .replace("JOINT_4", "JOINT_3")
        .replace("JOINT_x", "JOINT_4")
    )
    path.write_text(text)
    assert import_machine(str(path)).machine.axes == import_machine(str(write())).machine.axes


@pytest.mark.parametrize(
    ("swap", "words"),
    [
        ({"KINEMATICS = xyzac-trt-kins sparm=identityfirst\n": ""}, ["[KINS] KINEMATICS is missing", "xyzac-trt-kins", "mill.ini"]),
        ({"KINEMATICS = xyzac-trt-kins": "KINEMATICS = genhexkins"}, ["genhexkins", "known are", "line 6"]),
        ({"LINEAR_UNITS = mm\n": ""}, ["[TRAJ] LINEAR_UNITS is missing"]), ({"LINEAR_UNITS = mm": "LINEAR_UNITS = ell"}, ["'ell'", "mm"]),
        ({"ANGULAR_UNITS = deg\n": ""}, ["[TRAJ] ANGULAR_UNITS is missing"]),
        ({"MAX_LIMIT = 50\n": ""}, ["[JOINT_3] MAX_LIMIT is missing", "axis A", "[AXIS_A]"]),
        ({"MAX_VELOCITY = 150\n": ""}, ["[JOINT_4] MAX_VELOCITY is missing"]), ({"MIN_LIMIT = -100": "MIN_LIMIT = low"}, ["'low'", "line"]),
        ({"MIN_LIMIT = -100": "MIN_LIMIT = 60"}, ["[JOINT_3]", "limits"]), ({"MAX_VELOCITY = 150": "MAX_VELOCITY = 0"}, ["[JOINT_4]", "rate"]),
        ({"HALFILE = mill.hal": "HALFILE = gone.hal"}, ["gone.hal", "HAL file"]), ({"sparm=": "coordinates=XYZ sparm="}, ["coordinates=XYZ"]),
        ({"[EMC]": "#INCLUDE mill.ini\n[EMC]"}, ["circle"]),
    ],
)  # fmt: skip
def test_what_is_missing_or_wrong_is_named_in_one_line(swap, words, write) -> None:
    with pytest.raises((MachineError, FileError)) as caught:
        import_machine(str(write(swap=swap)))
    assert "\n" not in str(caught.value)
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize(
    ("hal", "words"),
    [
        ("setp {m}.y-offset high\n", ["mill.hal line 1", "xyzac-trt-kins.y-offset", "'high'"]),
        ("setp {m}.y-offset [KINS]Y_OFFSET\n", ["[KINS] Y_OFFSET is missing"]), ("net y gui.y => {m}.y-offset\n", ["y-offset", "gui.y", "setp"]),
        ("setp {m}.z-offset 1e9\n", ["origin"]), ("setp {m}.z-offset nan\n", ["'nan'"]), ("\0", ["no text file"]),
    ],
)  # fmt: skip
def test_offsets_that_cannot_be_known_are_named_in_one_line(hal, words, write) -> None:
    with pytest.raises(MachineError) as caught:
        import_machine(str(write(hal=hal)))
    assert "\n" not in str(caught.value)
    for word in words:
        assert word in str(caught.value)


@pytest.mark.parametrize(
    ("hal", "code"),
    [
        ("setp {m}.z-offset 10\n", "offset-not-set"), ("", "offset-not-set"), (OFFSETS["xyzac"] + "setp {m}.x-offset 3\n", "offset-not-used"),
    ],
)  # fmt: skip
def test_offsets_that_are_not_set_or_not_used_are_reported(hal, code, write) -> None:
    (found,) = import_machine(str(write(hal=hal))).findings
    assert (found.code, found.severity) == (code, Severity.WARNING)


def test_a_constant_tool_offset_is_part_of_the_trunnions_height_and_reported(write) -> None:
    path = write(
        hal=OFFSETS["xyzac"] + "setp {m}.tool-offset 7\n",
        swap={"HALCMD = net :tool-offset motion.tooloffset.z =>": "#"},
    )
    imported = import_machine(str(path))
    assert imported.machine.rotary[1].point == (0.0, 20.0, 17.0)
    assert [found.code for found in imported.findings] == ["constant-tool-offset"]


def freecad_file(name: str = "trunnion_ac") -> dict:
    """A shipped machine as FreeCAD's editor saves it: joints as lists, keys of its own, none of ours."""
    data = json.loads((machine_folder() / f"{name}.fcm").read_text(encoding="utf-8"))
    del data["fiveaxis"]
    for axis in data["machine"]["axes"].values():
        axis["joint"] = [axis["joint"]["origin"], axis["joint"]["axis"]]
    data["machine"]["kinematics"] |= {"dwo_supported": False, "rotation_strategy": "none", "notes": ""}
    data["postprocessor"] = {"file_name": "linuxcnc", "properties": {}}
    return data


def test_a_file_of_freecads_machine_editor_is_taken_and_what_it_cannot_say_is_reported(tmp_path) -> None:
    (tmp_path / "m.fcm").write_text(json.dumps(freecad_file()))
    imported = import_machine(str(tmp_path / "m.fcm"))
    assert (
        imported.machine.axes == load_machine("trunnion_ac").axes
        and imported.machine.controller == "linuxcnc"
    )
    assert [found.code for found in imported.findings] == ["machine-default", "sign-unproven"]
    save_machine(imported.machine, tmp_path / "again.fcm")
    assert import_machine(str(tmp_path / "again.fcm")).findings == ()


def test_a_base_frame_that_is_turned_is_an_error_finding(tmp_path) -> None:
    data = freecad_file()
    data["machine"]["kinematics"]["base_frame"]["origin"] = [0, 0, 5]
    (tmp_path / "m.fcm").write_text(json.dumps(data))
    assert [found.severity for found in import_machine(str(tmp_path / "m.fcm")).findings][
        -1
    ] is Severity.ERROR


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda data: data["machine"]["axes"]["A"].pop("limits"), ["machine.axes.A.limits", "missing"]),
        (
            lambda data: data["machine"]["axes"]["C"].update(parent=None) or data["machine"]["axes"].pop("A"),
            ["only rotary axis C", "parallel to the tool"],
        ),
        (
            lambda data: (
                data["machine"]["axes"]["A"].update(parent="C")
                or data["machine"]["axes"]["C"].update(parent=None)
            ),
            ["order"],
        ),
    ],
    ids=["no limits", "C alone", "FreeCAD's own template: C carries A"],
)
def test_a_freecad_file_that_makes_no_machine_of_ours_is_refused(spoil, words, tmp_path) -> None:
    data = freecad_file()
    spoil(data)
    (tmp_path / "m.fcm").write_text(json.dumps(data))
    with pytest.raises(MachineError) as caught:
        import_machine(str(tmp_path / "m.fcm"))
    assert all(word in str(caught.value) for word in ["m.fcm", *words]) and "\n" not in str(caught.value)


def test_a_freecad_file_of_four_axes_is_a_machine(tmp_path) -> None:
    data = freecad_file()
    data["machine"]["axes"].pop("C")
    (tmp_path / "m.fcm").write_text(json.dumps(data))
    assert [
        axis.letter for axis in import_machine(str(tmp_path / "m.fcm")).machine.fitted if axis.rotary
    ] == ["A"]


def test_the_command_writes_a_machine_that_the_program_takes(write, tmp_path, capsys) -> None:
    out = tmp_path / "my.fcm"
    assert cli.main(["import-machine", str(write()), "-o", str(out)]) == cli.DONE
    reported = capsys.readouterr().out
    assert "A table -1,0,0" in reported and f"wrote {out}" in reported
    assert load_machine(out).axes == import_machine(str(write())).machine.axes
    assert (
        cli.main(["import-machine", str(write()), "-o", str(out)]) == cli.UNUSABLE
    )  # no file is overwritten
    assert "exists already" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("source", "out", "message"),
    [("mill.ini", "my.json", ".fcm"), ("gone.ini", "my.fcm", "does not exist"), ("mill.hal", "my.fcm", ".ini"), ("mill.ini", "no/my.fcm", "folder")],
)  # fmt: skip
def test_the_command_refuses_in_one_line_and_leaves_no_file(
    source, out, message, write, tmp_path, capsys
) -> None:
    write()
    assert cli.main(["import-machine", str(tmp_path / source), "-o", str(tmp_path / out)]) == cli.UNUSABLE
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1
    assert not (tmp_path / out).exists()


@settings(max_examples=200, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(spots=st.lists(st.tuples(st.floats(0, 1), st.binary(max_size=6)), max_size=5), ini=st.booleans())
def test_no_spoilt_configuration_gives_a_traceback(spots, ini, write, tmp_path) -> None:
    path = write()
    spoilt = path if ini else tmp_path / "mill.hal"
    text = spoilt.read_bytes()
    for where, piece in spots:
        at = int(where * len(text))
        text = text[:at] + piece + text[at + len(piece) :]
    spoilt.write_bytes(text)
    try:
        import_machine(str(path))
    except FiveAxisError as error:
        assert "\n" not in str(error)


def older_file(*rotary: str) -> dict:
    """A file as FreeCAD's templates were before the Machine editor's release: limits beside the axis, no
    roles, direction first."""
    vectors = {"X": [1.0, 0, 0], "Y": [0, 1.0, 0], "Z": [0, 0, 1.0], "A": [1.0, 0, 0]}
    axes = {
        letter: {
            "joint": [vectors[letter], [0, 0, 0]],
            "min": 0,
            "max": 320,
            "max_velocity": 9000,
            "sequence": 0,
            "type": "linear",
        }
        for letter in "XYZ"
    }
    turning = {
        "joint": [[0, 0, 0], vectors["A"]],
        "min": -90,
        "max": 90,
        "max_velocity": 3600,
        "type": "angular",
    }
    axes |= dict.fromkeys(rotary, turning)
    return {
        "machine": {"axes": axes, "name": "old mill", "units": "metric", "spindles": []}, "postprocessor": {"file_name": "grbl"}, "version": 1,
    }  # fmt: skip


def test_a_template_of_freecads_from_before_the_release_is_a_machine_and_what_is_taken_is_reported(
    tmp_path,
) -> None:
    (tmp_path / "m.fcm").write_text(json.dumps(older_file()))
    imported = import_machine(str(tmp_path / "m.fcm"))
    axes = {axis.letter: axis for axis in imported.machine.fitted}
    assert {letter: axis.side for letter, axis in axes.items()} == {"X": "table", "Y": "table", "Z": "head"}
    assert (axes["Y"].direction, axes["Y"].low, axes["Y"].high) == ((0.0, 1.0, 0.0), 0.0, 320.0)
    assert any("older layout" in found.text for found in imported.findings)
    assert load_machine(tmp_path / "m.fcm") == replace(imported.machine, controller="")


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda axes: None, ["X.role, X.parent, Y.role, Y.parent, Z.role, Z.parent, A.role, A.parent are missing", "table_rotary"]),
        (lambda axes: axes["X"].pop("max"), ["X.limits", "missing"]), (lambda axes: axes.update(A=3), ["machine.axes: ", "X.role", "missing"]),
        (lambda axes: [axis.update(role="head_linear", parent=None) for axis in axes.values()], ["machine.axes.A.role", "contradicts"]),
        (lambda axes: [axis.update(role="head_linear", parent=None) for axis in axes.values()] and axes["A"].pop("role"), ["machine.axes.A.role", "missing"]),
    ],
)  # fmt: skip
def test_an_older_file_with_a_rotary_axis_says_what_is_missing(spoil, words, tmp_path) -> None:
    data = older_file("A")
    spoil(data["machine"]["axes"])
    (tmp_path / "m.fcm").write_text(json.dumps(data))
    with pytest.raises(MachineError) as caught:
        import_machine(str(tmp_path / "m.fcm"))
    assert all(word in str(caught.value) for word in words) and "\n" not in str(caught.value)
