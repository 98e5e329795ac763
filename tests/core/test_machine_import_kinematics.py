# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every kinematics of LinuxCNC that is imported puts the tip where the module's formula puts it.

J are the joints, P the tip in the work with the tool length t counted in, so that the tip itself is P - t ez;
k is the tool axis. The formulas stand here a second time, with matrices, as the modules' sources have them;
none of the project's kinematics is used for them.
"""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from freecad_fiveaxis.core import cli
from freecad_fiveaxis.core.base.errors import FileError, MachineError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.machine import load_machine, save_machine
from freecad_fiveaxis.core.machine.importing import import_machine
from freecad_fiveaxis.core.machine.importing.registry import KINEMATICS
from freecad_fiveaxis.core.machine.kinematics import Setup, chain, forward

EZ = np.array([0.0, 0.0, 1.0])
TOOL = 87.5
LIMITS = "MIN_LIMIT = -350\nMAX_LIMIT = 350\nMAX_VELOCITY = 50\n"


def turn(axis, angle):
    """The right-handed turn (3, 3) about an axis (3,), which need not be a unit vector."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * cross + (1.0 - math.cos(angle)) * cross @ cross


def rx(angle):
    return turn((1, 0, 0), angle)


def ry(angle):
    return turn((0, 1, 0), angle)


def rz(angle):
    return turn((0, 0, 1), angle)


def trt(tilting):
    def tip(joints, angle, pins, tool):
        r = np.array([pins["x-rot-point"], pins["y-rot-point"], pins["z-rot-point"]])
        d = np.array([pins.get("x-offset", 0.0), pins.get("y-offset", 0.0), pins["z-offset"] + tool])
        table = rz(-angle["C"]) @ tilting(-angle["A" if tilting is rx else "B"])
        return r + rz(-angle["C"]) @ d + table @ (joints - r - d), table @ EZ

    return tip


def five_axis(joints, angle, pins, tool):
    axis = rz(angle["C"]) @ ry(-angle["B"]) @ EZ
    length = pins["pivot-length"] + tool
    return joints + length * EZ - length * axis, axis


def maxkins(sense):
    def tip(joints, angle, pins, tool):
        """The inverse, solved for P; the tool length is the word W, and P - W ez the tip."""
        pivot = pins["pivot-length"]
        head = ry(sense * angle["B"]) @ EZ
        p = rz(angle["C"]) @ (joints - (pivot + tool) * head + pivot * EZ)
        return p + tool * EZ, rz(angle["C"]) @ head

    return tip


def dual_rotary(joints, angle, pins, tool):
    r = np.array([pins["x-rot-point"], pins["y-rot-point"], pins["z-rot-point"]])
    d = pins["z-offset"] * EZ
    p = r + d + tool * EZ + rx(angle["A"]) @ (ry(angle["B"]) @ (joints - r - tool * EZ) - d)
    return p, rx(angle["A"]) @ ry(angle["B"]) @ EZ


def nutating(letter, lean):
    def tip(joints, angle, pins, tool):
        nu = math.radians(pins["nut-angle"])
        across = np.array([0.0, 1.0, 0.0] if lean == "y" else [1.0, 0.0, 0.0])
        head = rz(angle["C"]) @ turn(math.sin(nu) * across + math.cos(nu) * EZ, angle[letter])
        pivot = pins[f"{lean}-pivot"] * across + pins["z-pivot"] * EZ
        offset = np.array([pins["x-offset"], pins["y-offset"], 0.0])
        p = joints + offset + pivot - rz(angle["C"]) @ offset - head @ (pivot + tool * EZ) + tool * EZ
        return p, head @ EZ

    return tip


CENTRE = {"x-rot-point": 3.0, "y-rot-point": -5.0, "z-rot-point": -40.0}
CASES = {
    "xyzac-trt-kins": ("XYZAC", CENTRE | {"y-offset": 20.0, "z-offset": 10.0}, trt(rx)),
    "xyzbc-trt-kins": ("XYZBC", CENTRE | {"x-offset": -20.0, "z-offset": -15.0}, trt(ry)),
    "xyzab_tdr_kins": ("XYZAB", CENTRE | {"z-offset": -12.5}, dual_rotary),
    "5axiskins": ("XYZBCW", {"pivot-length": 231.0}, five_axis),
    "maxkins": ("XYZABCUVW", {"pivot-length": 93.0}, maxkins(-1.0)),
    "xyzacb_trsrn": ("XYZABC", {"y-pivot": 31.0, "z-pivot": 120.0, "x-offset": 2.5, "y-offset": -7.0, "nut-angle": 55.0}, nutating("B", "y")),
    "xyzbca_trsrn": ("XYZABC", {"x-pivot": 31.0, "z-pivot": 120.0, "x-offset": 2.5, "y-offset": -7.0, "nut-angle": 50.0}, nutating("A", "x")),
}  # fmt: skip
TOOL_PINS = {
    "xyzac-trt-kins": "tool-offset",
    "xyzbc-trt-kins": "tool-offset",
    "xyzab_tdr_kins": "tool-offset-z",
} | dict.fromkeys(["xyzacb_trsrn", "xyzbca_trsrn"], "tool-offset-z")
EVERY = pytest.mark.parametrize("module", CASES)


def hal_of(module: str, pins: dict[str, float]) -> str:
    """A HAL file in which the tool length follows motion.tooloffset.z, as the modules' authors mean it."""
    prefix = module + ("_kins" if module.endswith("trsrn") else "")
    lines = [f"setp {prefix}.{pin} {value}" for pin, value in pins.items()]
    if module == "5axiskins":
        lines = [
            "loadrt sum2 names=other,reach",
            f"setp reach.in0 {pins['pivot-length']}",
            "net tool motion.tooloffset.z => reach.in1",
        ]
        lines.append("net pivot reach.out => 5axiskins.pivot-length")
    if module in TOOL_PINS:
        lines.append(f"net tool motion.tooloffset.z => {prefix}.{TOOL_PINS[module]}")
    return "\n".join(lines) + "\n"


def write(folder: Path, kinematics: str, letters: str, hal: str, traj: str = "", more: str = "") -> str:
    """A small configuration; ``letters`` in the order of the joints."""
    named = f"KINEMATICS = {kinematics}\n" if kinematics else ""
    ini = f"[KINS]\n{named}[HAL]\nHALFILE = m.hal\n[TRAJ]\nLINEAR_UNITS = mm\nANGULAR_UNITS = deg\n"
    ini += (f"COORDINATES = {traj}\n" if traj else "") + more
    ini += "".join(f"[JOINT_{joint}]\n{LIMITS}" for joint, _ in enumerate(letters))
    (folder / "m.ini").write_text(ini, encoding="utf-8")
    (folder / "m.hal").write_text(hal, encoding="utf-8")
    return str(folder / "m.ini")


def imported_of(module: str, folder: Path, **changed: float):
    letters, pins, _ = CASES[module]
    return import_machine(write(folder, module, letters, hal_of(module, pins | changed)))


def farthest(machine, module: str, formula=None, **changed: float) -> tuple[float, float]:
    """How far tip (mm) and tool axis are at most from the formula, over random joints, with a tool."""
    _, pins, own = CASES[module]
    kinematics, tip_error, axis_error = chain(machine, Setup(machine.origin, TOOL)), 0.0, 0.0
    letters = [axis.letter for axis in machine.rotary]
    for q in np.random.default_rng(3).uniform(-1, 1, (100, 5)) * (100, 100, 100, 3, 3):
        place, axis = (formula or own)(q[:3], dict(zip(letters, q[3:], strict=True)), pins | changed, TOOL)
        tip, k = forward(kinematics, np.array([[*(q[:3] - TOOL * EZ), *q[3:]]]))
        tip_error = max(tip_error, np.abs(tip[0] - (place - TOOL * EZ)).max())
        axis_error = max(axis_error, np.abs(k[0] - axis).max())
    return tip_error, axis_error


@EVERY
def test_tip_and_axis_are_where_the_modules_formula_puts_them(module, tmp_path) -> None:
    tip, axis = farthest(imported_of(module, tmp_path).machine, module)
    assert tip < 1e-9 and axis < 1e-12


def test_every_module_that_has_a_formula_is_proven() -> None:
    assert set(KINEMATICS) - {"trivkins"} == set(CASES)


@EVERY
@pytest.mark.parametrize("which", [0, 1])
def test_a_wrong_sign_or_place_of_either_axis_would_be_noticed(module, which, tmp_path) -> None:
    machine = imported_of(module, tmp_path).machine
    axis = machine.rotary[which]
    x, y, z = axis.direction
    reversed_axis = replace(axis, direction=(-x, -y, -z))
    beside = replace(axis, point=tuple(np.add(axis.point, np.cross(axis.direction, (0.6, 0.64, 0.48)))))
    for wrong in (reversed_axis, beside):
        axes = tuple(wrong if one is axis else one for one in machine.axes)
        assert farthest(replace(machine, axes=axes), module)[0] > 0.1


@EVERY
def test_the_machine_is_the_same_from_its_file(module, tmp_path) -> None:
    machine = imported_of(module, tmp_path).machine
    save_machine(machine, tmp_path / "m.fcm")
    assert load_machine(tmp_path / "m.fcm").axes == machine.axes


def test_conventional_directions_turn_the_b_of_maxkins(tmp_path) -> None:
    machine = imported_of("maxkins", tmp_path, **{"conventional-directions": 1}).machine
    assert farthest(machine, "maxkins", maxkins(1.0))[0] < 1e-9


def test_maxkins_warns_of_its_forward_formula_and_says_where_the_tool_length_belongs(tmp_path) -> None:
    assert [found.code for found in imported_of("maxkins", tmp_path).findings][:2] == [
        "forward-differs",
        "tool-length-in-w",
    ]


@pytest.mark.parametrize(
    ("module", "held"), [("xyzacb_trsrn", "A"), ("xyzbca_trsrn", "B"), ("5axiskins", "W")]
)
def test_an_axis_that_a_machine_file_cannot_hold_is_named(module, held, tmp_path) -> None:
    (found,) = imported_of(module, tmp_path).findings
    assert (found.code, found.severity) == ("axis-held", Severity.WARNING) and f" {held} " in found.text


@pytest.mark.parametrize("angle", [0.0, 1e-4, 180.0])
def test_a_head_that_never_tilts_the_tool_is_refused_with_its_pin(angle, tmp_path) -> None:
    with pytest.raises(MachineError, match=r"nut-angle is .* setp xyzacb_trsrn_kins.nut-angle"):
        imported_of("xyzacb_trsrn", tmp_path, **{"nut-angle": angle})


@pytest.mark.parametrize(("module", "own"), [("5axiskins", 250.0), ("maxkins", 0.666)])
def test_a_pivot_that_no_file_sets_is_the_modules_own_and_named(module, own, tmp_path) -> None:
    imported = import_machine(write(tmp_path, module, CASES[module][0], ""))
    assert imported.machine.rotary[1].point == (0.0, 0.0, own)
    (text,) = (found.text for found in imported.findings if found.code == "offset-not-set")
    assert f"pivot-length ({own:g})" in text


def test_a_pivot_without_the_tool_length_is_reported(tmp_path) -> None:
    imported = import_machine(
        write(tmp_path, "5axiskins", "XYZBCW", "setp 5axiskins.pivot-length 200\n", traj="XYZBC")
    )
    assert imported.machine.rotary[1].point == (0.0, 0.0, 200.0)
    assert [found.code for found in imported.findings] == ["constant-tool-offset"]


@pytest.mark.parametrize(
    ("hal", "pivot"),
    [
        ("loadrt sum2\nnet p sum2.0.out => 5axiskins.pivot-length\nnet t motion.tooloffset.z sum2.0.in0\nsetp sum2.0.in1 70\nsetp sum2.0.offset 5\n", 75.0),
        ("loadrt sum2 count=3\nnet p sum2.2.out => 5axiskins.pivot-length\nnet t motion.tooloffset.z sum2.2.in0\nsetp sum2.2.in1 7\nsetp sum2.2.gain1 10\n", 70.0),
        ("loadrt sum2 names=s\nnet p s.out => 5axiskins.pivot-length\nnet t motion.tooloffset.z s.in1\nnet g s.in0 gui.len\nsetp s.in0 60\n", 60.0),
    ],
)  # fmt: skip
def test_a_pivot_that_is_the_sum_of_a_length_and_the_tool_is_that_length(hal, pivot, tmp_path) -> None:
    imported = import_machine(write(tmp_path, "5axiskins", "XYZBCWY", hal, traj="X Y Z B C"))
    assert imported.machine.rotary[1].point == (0.0, 0.0, pivot) and imported.findings == ()


def test_a_slider_in_the_sum_is_named_and_a_tool_length_that_counts_twice_is_refused(tmp_path) -> None:
    (tmp_path / "p.xml").write_text('<spinbox><halpin>"reach"</halpin><initval>90</initval></spinbox>')
    panel, hal = (
        "[DISPLAY]\nPYVCP = p.xml\n",
        "loadrt sum2 names=s\nnet p s.out => 5axiskins.pivot-length\nnet t motion.tooloffset.z s.in1",
    )
    slider = write(
        tmp_path, "5axiskins", "XYZBCW", hal + "\nnet g pyvcp.reach => s.in0\n", traj="XYZBC", more=panel
    )
    imported = import_machine(slider)
    assert imported.machine.rotary[1].point == (0.0, 0.0, 90.0)
    assert [found.code for found in imported.findings] == [
        "offset-from-panel"
    ] and "s.in0 90" in imported.findings[0].text
    with pytest.raises(MachineError, match=r"motion\.tooloffset\.z"):
        import_machine(write(tmp_path, "5axiskins", "XYZBCW", hal + " s.in0\n", traj="XYZBC"))


def test_a_sum_of_what_nobody_says_is_refused_with_the_pin_to_set(tmp_path) -> None:
    hal = "loadrt sum2 names=s\nnet p s.out => 5axiskins.pivot-length\nnet t motion.tooloffset.z s.in1\nnet g s.in0 gui.len\n"
    with pytest.raises(
        MachineError, match=r"s\.in0 comes from signal g \(gui\.len\).*write setp s\.in0 VALUE"
    ):
        import_machine(write(tmp_path, "5axiskins", "XYZBCW", hal))


def test_a_slider_of_the_screen_gives_what_it_starts_with_and_is_named(tmp_path) -> None:
    (tmp_path / "p.xml").write_text(
        '<pyvcp><scale><halpin>"tilt"</halpin><initval>-20</initval></scale><!--<scale><halpin>"z"</halpin></scale>-->'
        '<spinbox><halpin>"z"</halpin><initval>7.5</initval></spinbox><scale><halpin>"y"</halpin></scale></pyvcp>'
    )
    hal = "".join(f"net {pin} {gui} => xyzab_tdr_kins.{pin}\n" for pin, gui in [("x-rot-point", "pyvcp.tilt-f"), ("y-rot-point", "pyvcp.y-f"), ("z-rot-point", "pyvcp.z")])  # fmt: skip
    hal += "sets x-rot-point 99\nsetp xyzab_tdr_kins.z-offset 2\n"
    imported = import_machine(
        write(tmp_path, "xyzab_tdr_kins", "XYZAB", hal, more="[DISPLAY]\nPYVCP = p.xml\n")
    )
    assert imported.machine.rotary[1].point == (-20.0, 0.0, 7.5)
    (found,) = imported.findings
    assert (
        found.code == "offset-from-panel" and "x-rot-point -20, y-rot-point 0, z-rot-point 7.5" in found.text
    )


@pytest.mark.parametrize(
    "panel", [None, "\0", "<scale><halpin>oddly</halpin>"], ids=["missing", "no text", "cut off"]
)
def test_a_panel_that_cannot_be_read_leaves_the_pin_open(panel, tmp_path) -> None:
    if panel is not None:
        (tmp_path / "p.xml").write_text(panel)
    hal = "net z pyvcp.z => xyzab_tdr_kins.z-offset\n"
    with pytest.raises(MachineError, match=r"pyvcp\.z"):
        import_machine(write(tmp_path, "xyzab_tdr_kins", "XYZAB", hal, more="[DISPLAY]\nPYVCP = p.xml\n"))


@pytest.mark.parametrize("letters", ["xyz", "XZY", "xyyz"])
def test_trivkins_of_linear_axes_alone_is_a_machine_of_three_axes(letters, tmp_path) -> None:
    imported = import_machine(write(tmp_path, f"trivkins coordinates={letters} kinstype=BOTH", letters, ""))
    assert [axis.letter for axis in imported.machine.fitted] == ["X", "Y", "Z"] and imported.findings == ()


@pytest.mark.parametrize(("letter", "direction"), [("A", (1.0, 0.0, 0.0)), ("B", (0.0, 1.0, 0.0))])
def test_trivkins_with_one_rotary_axis_says_what_is_assumed_of_it(letter, direction, tmp_path) -> None:
    imported = import_machine(write(tmp_path, f"trivkins coordinates=xyz{letter}", f"XYZ{letter}", ""))
    rotary = imported.machine.rotary[0]
    assert (rotary.letter, rotary.side, rotary.direction, rotary.point) == (
        letter,
        "table",
        direction,
        (0.0, 0.0, 0.0),
    )
    (found,) = imported.findings
    assert (found.code, found.severity) == ("rotary-assumed", Severity.WARNING) and "ISO 841" in found.text


def test_trivkins_without_coordinates_has_the_axes_of_traj_and_nine_joints(tmp_path) -> None:
    imported = import_machine(write(tmp_path, "trivkins", "XYZABCUVW", "", traj="X Y Z B"))
    assert [axis.letter for axis in imported.machine.fitted] == ["B", "X", "Y", "Z"]


def test_trivkins_with_two_rotary_axes_names_the_shipped_machines_to_begin_with(tmp_path) -> None:
    with pytest.raises(MachineError, match=r"with these axes \(fork_head_bc, ") as caught:
        import_machine(write(tmp_path, "trivkins coordinates=xyzbc", "XYZBC", ""))
    assert "trunnion_bc" in str(caught.value) and "trunnion_ac" not in str(caught.value)
    with pytest.raises(MachineError, match="describe the machine by hand"):
        import_machine(write(tmp_path, "trivkins coordinates=xyzab", "XYZAB", ""))


@pytest.mark.parametrize(
    ("letters", "words"),
    [
        ("XYZAC", ["A and C", "by hand"]), ("XYZC", ["C alone", "leave C out"]), ("XZ", ["without Y", "name X, Y and Z"]),
        ("XYZQ", ["coordinates=XYZQ"]),
    ],
)  # fmt: skip
def test_trivkins_that_says_too_little_is_refused_in_one_line(letters, words, tmp_path) -> None:
    with pytest.raises(MachineError) as caught:
        import_machine(write(tmp_path, f"trivkins coordinates={letters}", letters, ""))
    assert all(word in str(caught.value) for word in ["m.ini line 2", *words]) and "\n" not in str(
        caught.value
    )


def test_the_module_that_hal_loads_counts_where_the_ini_file_names_none(tmp_path) -> None:
    imported = import_machine(
        write(tmp_path, "", "XYZ", "loadrt threads name1=t\nloadrt trivkins coordinates=xyz\n")
    )
    assert "trivkins" in imported.machine.description
    both = write(tmp_path, "trivkins coordinates=xyz", "XYZ", "loadrt [KINS]KINEMATICS\n")
    assert import_machine(both).machine.axes == imported.machine.axes


def test_a_hal_file_that_is_missing_matters_only_where_the_module_has_pins(tmp_path) -> None:
    gone = "[HAL]\nHALFILE = core_sim.hal\n"
    imported = import_machine(write(tmp_path, "trivkins coordinates=xyz", "XYZ", "", more=gone))
    assert [found.code for found in imported.findings] == [
        "hal-file-not-read"
    ] and "core_sim.hal" in imported.findings[0].text
    with pytest.raises(FileError, match=r"core_sim\.hal"):
        import_machine(
            write(tmp_path, "maxkins", "XYZABCUVW", hal_of("maxkins", CASES["maxkins"][1]), more=gone)
        )


def test_two_modules_are_refused_with_both_names(tmp_path) -> None:
    with pytest.raises(
        MachineError, match=r"m\.hal line 1 loads maxkins, but \[KINS\] KINEMATICS is 5axiskins"
    ):
        import_machine(write(tmp_path, "5axiskins", "XYZBCW", "loadrt maxkins\n"))


@pytest.mark.parametrize(("unit", "length"), [("1.0", 1.0), ("0.03937007874015748", 25.4)])
def test_a_unit_as_a_number_is_so_many_in_a_millimetre(unit, length, tmp_path) -> None:
    path = Path(write(tmp_path, "maxkins", "XYZABCUVW", "setp maxkins.pivot-length 10\n"))
    path.write_text(path.read_text().replace("LINEAR_UNITS = mm", f"LINEAR_UNITS = {unit}"))
    assert import_machine(str(path)).machine.rotary[1].point == pytest.approx(
        (0.0, 0.0, 10.0 * length), rel=1e-15
    )


def test_the_command_tells_findings_and_ends_well(tmp_path, capsys) -> None:
    path = write(tmp_path, "trivkins coordinates=xyza", "XYZA", "")
    assert cli.main(["import-machine", path, "-o", str(tmp_path / "m.fcm")]) == cli.DONE
    assert "trivkins does not say where A stands" in capsys.readouterr().out
    assert load_machine(tmp_path / "m.fcm").rotaries == 1
