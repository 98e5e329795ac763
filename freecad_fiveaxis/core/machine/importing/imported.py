# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine from a file of another program, with what that file leaves open.

LinuxCNC   an ini file (``.ini``) with kinematics of :mod:`.registry`, and the HAL files that it names; bodies
           by a vismach model (``.py``): :mod:`.vismach`.
URDF       a robot description of ROS (``.urdf``): :mod:`.urdf`.
FreeCAD    a file of the Machine editor (``.fcm``). It is this program's own format already; what it lacks is
           told.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.files import read_bytes
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Axis, Machine, load_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.machine.older_layout import is_older

from .linuxcnc import machine_of_ini
from .urdf import machine_of_urdf

UPRIGHT = {"origin": [0, 0, 0], "orientation_quaternion": [0, 0, 0, 1]}
DEFAULTS = {
    "gauge_point": "0,0,0", "origin": "0,0,0", "singular_cone": "5 deg", "safe_start": "clearance",
}  # fmt: skip
"""What a FreeCAD file cannot say, and what is taken for it."""


@dataclass(frozen=True)
class Imported:
    """A machine and what its source leaves open; ``meshes``, mm, of its bodies that have no file yet, by
    their names."""

    machine: Machine
    findings: tuple[Finding, ...]
    meshes: Mapping[str, Mesh] = field(default_factory=dict, compare=False)


def import_machine(path: str, bodies: str = "") -> Imported:
    """Return the machine of a LinuxCNC ini file, a URDF file or a FreeCAD machine file, checked for a chain
    that can be solved.

    ``bodies``: the vismach model of a LinuxCNC configuration, a Python script, empty for none. Raises
    MachineError that names the missing or wrong value and its file, FileError where a file cannot be read.
    """
    suffix, meshes = Path(path).suffix.lower(), dict[str, Mesh]()
    if bodies and suffix != ".ini":
        text = say(
            "{bodies} has the bodies of a LinuxCNC .ini; leave it out for {path}", bodies=bodies, path=path
        )
        raise MachineError(text, bodies)
    if suffix == ".ini":
        machine, findings, meshes = machine_of_ini(Path(path), Path(bodies) if bodies else None)
    elif suffix == ".urdf":
        machine, findings, meshes = machine_of_urdf(Path(path))
    elif suffix == ".fcm":
        machine, findings = _of_freecad(path)
    else:
        raise MachineError(
            say(
                "{path} has no ending that is known; give LinuxCNC's .ini, a .urdf or FreeCAD's .fcm",
                path=path,
            ),
            path,
        )
    try:
        chain(machine, Setup(machine.origin))
    except MachineError as error:
        raise MachineError(say("{path}: {error}", path=path, error=error), error.value) from error
    return Imported(machine, findings, meshes)


def _of_freecad(path: str) -> tuple[Machine, tuple[Finding, ...]]:
    machine = load_machine(str(Path(path).absolute()))
    data = json.loads(read_bytes(path, "machine file").decode("utf-8-sig"))
    extra, found = data.get("fiveaxis", {}), []
    if lacking := [f"{key} {value}" for key, value in DEFAULTS.items() if key not in extra]:
        text = say(
            "FreeCAD's file does not say everything; taken: {lacking}. Correct them under fiveaxis.",
            lacking=", ".join(lacking),
        )
        found.append(report_finding(Code.MACHINE_DEFAULT, text))
    if is_older(data["machine"]["axes"]):
        text = say(
            "The file is of an older layout, which does not say what carries what; taken: X and Y move the "
            "table, Z the head. Limits are those beside each axis."
        )
        found.append(report_finding(Code.MACHINE_DEFAULT, text))
    if not extra:
        text = say(
            "The joint axes are taken as the way the tool moves relative to the work (ISO 841). Prove the "
            "signs before cutting."
        )
        found.append(report_finding(Code.SIGN_UNPROVEN, text))
    kinematics = data["machine"].get("kinematics")
    frame = kinematics.get("base_frame") if isinstance(kinematics, dict) else None
    if isinstance(frame, dict) and any(frame.get(key, value) != value for key, value in UPRIGHT.items()):
        text = say(
            "The file's base frame is shifted or turned and is not used; write the axes in the machine's own "
            "frame."
        )
        found.append(report_finding(Code.BASE_FRAME_NOT_USED, text))
    return replace(machine, controller=machine.controller or _controller(data)), tuple(found)


def _controller(data: dict[str, object]) -> str:
    """FreeCAD's post-processor, where it speaks one of the dialects that are known here."""
    post = data.get("postprocessor")
    name = post.get("file_name") if isinstance(post, dict) else None
    name = name.lower().removesuffix(".py").removesuffix("_post") if isinstance(name, str) else ""
    return name if name in DIALECTS else ""


def as_text(imported: Imported) -> str:
    """Return the machine as a table, from the work to the tool, and the findings."""
    machine = imported.machine
    rows = [
        f"{machine.name}: {machine.description}",
        *(_row(axis) for axis in machine.fitted),
        *_bodies(machine),
        _start(machine),
    ]
    marks = {Severity.NOTE: "note", Severity.WARNING: "warning", Severity.ERROR: "ERROR"}
    return "\n".join([*rows, *(f"{marks[found.severity]}: {found.text}" for found in imported.findings)])


def _row(axis: Axis) -> str:
    unit, scale = ("deg", math.degrees(1.0)) if axis.rotary else ("mm", 1.0)
    line = f"  {axis.letter} {axis.side:5} {_vector(axis.direction):12}"
    line += f" through {_vector(axis.point):18}" if axis.rotary else 27 * " "
    line += f" {axis.low * scale:g} to {axis.high * scale:g} {unit}, {axis.max_rate * scale:g} {unit}/min"
    known = not math.isinf(axis.max_acceleration)
    return line + (f", {axis.max_acceleration * scale:g} {unit}/s^2" if known else "")


def _bodies(machine: Machine) -> list[str]:
    """Return what each of machine's bodies is carried by, in one row."""
    named = ", ".join(f"{body.name} ({body.carrier})" for body in machine.bodies)
    return [f"  bodies, and what carries them: {named}"] if named else []


def _start(machine: Machine) -> str:
    start, table = machine.safe_start, machine.table
    retract = start.retract if start.z is None else f"{start.retract} Z {start.z:g} mm"
    height = "at a height that is not known" if table is None else f"at Z {table:g} mm"
    return f"  programs begin and end by safe_start {retract}; the table's face is {height}"


def _vector(value: tuple[float, float, float]) -> str:
    return ",".join(f"{component + 0.0:.6g}" for component in value)
