# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that move nothing: the shipped table, a machine file's own, what beside them moves, and what may
not be named."""

from __future__ import annotations

import json

import pytest
from test_nc_cycles import errors, path, read

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.findings import Severity
from freecad_fiveaxis.core.cli import main
from freecad_fiveaxis.core.machine import load_machine, save_machine
from freecad_fiveaxis.core.machine.machine_file import machine_folder
from freecad_fiveaxis.core.nc.reader import Assumed

HEAD = "0 BEGIN PGM T MM\n1 L X+0 Y+0 Z+20 A+0 C+0 R0 FMAX\n"
TUNING = "2 CYCL DEF {} ~\n   Q240=0 ;TUNING MODE~\n   Q241=1 ;WEIGHT\n"
ISO = "G21 G90 G94 F100\nG0 X0 Y0 Z20 A0 C0\n"


def klartext(text: str, *own: str):
    return read(HEAD + text, "heidenhain", Assumed(no_motion=own))


def poor(program) -> list[str]:
    return [found.code for found in program.findings if found.severity is not Severity.NOTE]


@pytest.mark.parametrize(
    "line",
    [
        TUNING.format("392 ATC"),
        "CYCL DEF9.0 DWELL\nCYCL DEF9.1 DWELL2\n",
        "M202(0.0024)\n",
        "L M202(0.0024)\n",
    ],
)
def test_what_moves_nothing_is_no_finding(line: str) -> None:
    program = klartext(f"{line}L X+5 F100\nL X+7\n")
    assert not poor(program), program.findings
    assert path(program) == ["f 5 0 20", "f 7 0 20"]


@pytest.mark.parametrize("controller", ["fanuc", "linuxcnc"])
def test_high_precision_contour_control_is_no_spline(controller: str) -> None:
    program = read(ISO + "G05 P10000\nG1 X1\nX2\nN40 G5P0\nX3\n", controller)
    assert path(program) == ["f 1 0 20", "f 2 0 20", "f 3 0 20"] and not errors(program)
    spline = read(ISO + "G5 P10001\nG1 X1\n", controller)
    assert errors(spline) == ["spline-not-interpreted"]


def test_what_stands_beside_such_a_function_is_read() -> None:
    program = klartext(
        "L X+5 M202(0.0024) Y+2 F100\n" + TUNING.format("392 ATC") + "CYCL DEF 7.1 X+10\nL X+5\n"
    )
    assert path(program) == ["f 5 2 20", "f 15 2 20"]
    for line in ("G5 P0 Q-3 X2 Y2 I0 J3", "X2 Y2 I0 J3 G5 P0 Q-3", "G05 P10000 X4"):
        assert "spline-not-interpreted" in errors(read(ISO + line + "\nX5\n", "linuxcnc"))


def test_other_cycles_and_functions_in_brackets_are_named_until_the_machine_file_names_them() -> None:
    program = klartext("L F100\n" + TUNING.format("361 CHECK") + "M317(2)\nL X+5\n")
    assert poor(program) == ["unknown-code", "cycle-not-interpreted"] and path(program) == ["f 5 0 20"]
    assert [found.line for found in program.findings if found.code == "unknown-code"] == [7]
    program = klartext("L F100\n" + TUNING.format("361 CHECK") + "M317(2)\nL X+5\n", "CYCL DEF 361", "M317")
    assert not poor(program) and [(found.code, found.line) for found in program.findings] == [
        ("no-motion", 4),
        ("no-motion", 7),
    ]
    other = klartext("L F100\n" + TUNING.format("361 CHECK") + "L X+5\n", "CYCL DEF 36" + "2")
    assert poor(other) == ["cycle-not-interpreted"]


def test_a_cycle_without_motion_leaves_the_one_before_it_to_be_called() -> None:
    drill = "CYCL DEF 200 DRILLING ~\nQ200=2 ~\nQ201=-3 ~\nQ206=150 ~\nQ202=4 ~\nQ203=0\n"
    program = klartext(drill + TUNING.format("392 ATC") + "L X+5 R0 FMAX M99\n")
    assert path(program) == ["r 5 0 20", "r 5 0 2", "f 5 0 -3", "r 5 0 2"] and not errors(program)


GOOD = ["M317", " m202 ", "CYCL DEF 361", "G05 P10000", "FUNCTION FEED-CHECK"]
BAD = [
    "L X",
    "M30",
    "M0099",
    "M91",
    "M128",
    "G1",
    "G01 P5",
    "G05",
    "CYCL DEF 200",
    "CYCL DEF 7",
    "FUNCTION TCPM",
    "PLANE RESET",
    "",
    "CALL LBL 1",
]


def test_a_machine_file_keeps_its_names(tmp_path) -> None:
    data = json.loads((machine_folder() / "trunnion_ac.fcm").read_text(encoding="utf-8"))
    data["fiveaxis"]["no_motion"] = GOOD
    (tmp_path / "a.fcm").write_text(json.dumps(data), encoding="utf-8")
    machine = load_machine(tmp_path / "a.fcm")
    assert machine.no_motion == ("M317", "M202", "CYCL DEF 361", "G05 P10000", "FUNCTION FEED-CHECK")
    save_machine(machine, tmp_path / "b.fcm")
    assert load_machine(tmp_path / "b.fcm") == machine


@pytest.mark.parametrize("value", [*([name] for name in BAD), "M202", [5], {"M202": 1}, None])
def test_a_wrong_value_is_refused_in_one_line(value, tmp_path, capsys) -> None:
    data = json.loads((machine_folder() / "trunnion_ac.fcm").read_text(encoding="utf-8"))
    data["fiveaxis"]["no_motion"] = value
    (tmp_path / "a.fcm").write_text(json.dumps(data), encoding="utf-8")
    (tmp_path / "a.ngc").write_text(ISO, encoding="utf-8")
    with pytest.raises(MachineError, match="no_motion"):
        load_machine(tmp_path / "a.fcm")
    assert main(["audit", str(tmp_path / "a.ngc"), "--machine", str(tmp_path / "a.fcm")]) == 2
    message = capsys.readouterr().err.strip()
    shown = value[0] if isinstance(value, list) else value
    assert "\n" not in message and "no_motion" in message and str(shown)[:4].upper() in message.upper()
    assert any(remedy in message for remedy in ("write", "leave it out"))


def test_the_audit_of_a_machine_with_its_own_names(tmp_path, capsys) -> None:
    data = json.loads((machine_folder() / "trunnion_ac.fcm").read_text(encoding="utf-8"))
    (tmp_path / "a.h").write_text(
        HEAD + TUNING.format("361 CHECK") + "L X+5 F100\nL X+6\nEND PGM T MM\n", encoding="utf-8"
    )
    (tmp_path / "a.fcm").write_text(json.dumps(data), encoding="utf-8")
    assert main(["audit", str(tmp_path / "a.h"), "--machine", str(tmp_path / "a.fcm")]) == 1
    data["fiveaxis"]["no_motion"] = ["CYCL DEF 361"]
    (tmp_path / "a.fcm").write_text(json.dumps(data), encoding="utf-8")
    assert main(["audit", str(tmp_path / "a.h"), "--machine", str(tmp_path / "a.fcm")]) == 0
    assert "CYCL DEF 361 is passed over" in capsys.readouterr().out
