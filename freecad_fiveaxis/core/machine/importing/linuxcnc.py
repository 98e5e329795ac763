# SPDX-License-Identifier: LGPL-2.1-or-later
"""A LinuxCNC configuration as a machine: its kinematics module by :mod:`.registry`, units, limits and rates
by the ini file.

module   what a HAL file loads by ``loadrt``, else ``[KINS] KINEMATICS``. ``coordinates=`` gives the order of
         the joints.
axes     those that the module and [TRAJ] COORDINATES have. What a machine file cannot hold stays at 0, and a
         finding says so.
joint    limits are those of [JOINT_n], of [AXIS_L] where they are missing there; the narrower of both for
         rotary axes, whose word is the joint in every kinematics; one that has neither turns without end. A
         rate is the lower of both, as is an acceleration, which may be missing.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Number, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Axis, Machine

from .hal_files import HalValues
from .ini_file import IniFile, Value, number
from .pins import PinValues, pin_values
from .record import Given, Kinematics, Turn, X, Y, Z
from .registry import KINEMATICS
from .vismach import Configuration, add_bodies

LENGTHS = {"mm": 1.0, "metric": 1.0, "in": 25.4, "inch": 25.4, "imperial": 25.4}
ANGLES = {
    "deg": 1.0,
    "degree": 1.0,
    "rad": math.degrees(1.0),
    "radian": math.degrees(1.0),
    "grad": 0.9,
    "gon": 0.9,
}
NUMBER = r"\d{1,9}(\.\d{0,17})?"
"""How older files give a unit: so many of it in a millimetre or a degree."""
UNLIMITED = 99999.0
"""A limit beyond this is none, as in machine files."""
LINEAR = tuple(
    Turn(letter, "head", direction, (0.0, 0.0, 0.0))
    for letter, direction in zip("XYZ", (X, Y, Z), strict=True)
)


def machine_of_ini(
    path: Path, model: Path | None = None
) -> tuple[Machine, tuple[Finding, ...], dict[str, Mesh]]:
    """Make the machine of a LinuxCNC configuration, with bodies by its vismach ``model``, and the meshes, mm,
    of those of the shape ``file`` by their names. Raises MachineError naming the value that is missing or
    wrong, FileError."""
    given, findings = _configuration(path)
    if model is None:
        return given.machine, findings, {}
    machine, more, meshes = add_bodies(given, model)
    return machine, (*findings, *more), meshes


def _configuration(path: Path) -> tuple[Configuration, tuple[Finding, ...]]:
    ini = IniFile(path)
    hal = HalValues(ini)
    line = _kinematics_line(ini, hal)
    kind, order = _kinematics(line)
    if hal.unread and kind.pins:
        raise hal.unread[0]
    length, angle = _unit(ini, "LINEAR_UNITS", LENGTHS), _unit(ini, "ANGULAR_UNITS", ANGLES)
    pins = pin_values(hal, kind, length)
    given = Given(kind.prefix or kind.name, _present(ini, order), pins.values, line.where, pins.follows_tool)
    turns = tuple(_lift_turn(turn, pins) for turn in kind.turns(given))
    _refuse_wrapped(ini, turns)
    axes = tuple(_axis(ini, axis, order.index(axis.letter), length, angle) for axis in _work_to_tool(turns))
    findings = (
        *pins.findings,
        *kind.remarks(given),
        *_report_unheld_letters(kind, given, turns),
        *_report_endless(ini, turns, order),
        *_unread(hal, kind),
    )
    description = f"LinuxCNC's {kind.name}, imported from {path.name}"
    machine = Machine(_name(ini), axes, description=description, controller="linuxcnc")
    return Configuration(machine, hal, order, length, angle), findings


def _kinematics_line(ini: IniFile, hal: HalValues) -> Value:
    """Return the module and its options: what HAL loads, else what the ini file names. Raises MachineError
    where they differ."""
    remedy = say("known are {modules}", modules=", ".join(KINEMATICS))
    loaded = next((value for value in hal.loaded if _is_kinematics(value.text.split()[0])), None)
    if loaded is None:
        return ini.need("KINS", "KINEMATICS", remedy)
    named = ini.get("KINS", "KINEMATICS")
    if named is not None and named.text and named.text.split()[0] != loaded.text.split()[0]:
        text = say(
            "{where} loads {loaded}, but [KINS] KINEMATICS is {named}; make them agree",
            where=loaded.where,
            loaded=loaded.text.split()[0],
            named=named.text.split()[0],
        )
        raise MachineError(text, loaded.text)
    return loaded


def _is_kinematics(module: str) -> bool:
    return module in KINEMATICS or module.endswith("kins")


def _kinematics(line: Value) -> tuple[Kinematics, str]:
    """Return the module's record, and the letters in the order of the joints."""
    module, *options = line.text.split()
    if module not in KINEMATICS:
        remedy = say("known are {modules}", modules=", ".join(KINEMATICS))
        raise MachineError(
            say(
                "{where}: kinematics {module} cannot be imported; {remedy}",
                where=line.where,
                module=module,
                remedy=remedy,
            ),
            module,
        )
    kind = KINEMATICS[module]
    given = next((option[12:] for option in options if option.startswith("coordinates=")), None)
    letters = (kind.joints if given is None or kind.fixed else given).upper()
    if not set(kind.needs) <= set(letters) or not set(letters) <= set(kind.needs + kind.spare):
        raise MachineError(
            say(
                "{where}: coordinates={letters} does not name {known}; correct it",
                where=line.where,
                letters=letters,
                known=kind.needs or kind.joints,
            ),
            letters,
        )
    return kind, letters


def _present(ini: IniFile, order: str) -> str:
    """Return the letters of the axes that there are: those of the module that [TRAJ] COORDINATES names too,
    where it is given."""
    named = ini.get("TRAJ", "COORDINATES")
    letters = named.text.upper() if named is not None and named.text else order
    return "".join(letter for letter in dict.fromkeys(order) if letter in letters)


def _lift_turn(turn: Turn, pins: PinValues) -> Turn:
    x, y, z = turn.point
    return Turn(turn.letter, turn.side, turn.direction, (x, y, z + pins.lift))


def _work_to_tool(turns: tuple[Turn, ...]) -> tuple[Turn, ...]:
    """All axes: the table's, the linear ones, the head's."""
    table, head = ([turn for turn in turns if turn.side == side] for side in ("table", "head"))
    return (*table, *LINEAR, *head)


def _unread(hal: HalValues, kind: Kinematics) -> list[Finding]:
    if not hal.unread:
        return []
    text = say(
        "{count} HAL files cannot be read; {module} takes no value from them. The first: {error}",
        count=Number(len(hal.unread)),
        module=kind.name,
        error=hal.unread[0],
    )
    return [report_finding(Code.HAL_FILE_NOT_READ, text)]


def _report_unheld_letters(kind: Kinematics, given: Given, turns: tuple[Turn, ...]) -> list[Finding]:
    kept = {axis.letter for axis in (*LINEAR, *turns)}
    held = [letter for letter in given.letters if letter not in kept]
    if not held:
        return []
    text = say(
        "{module} moves {letters} too, which a machine file cannot hold; the machine is right only while "
        "that stands at 0.",
        module=kind.name,
        letters=" and ".join(held),
    )
    return [report_finding(Code.AXIS_HELD, text)]


def _unit(ini: IniFile, key: str, known: dict[str, float]) -> float:
    given = ini.need("TRAJ", key, say("write one of {known}", known=", ".join(known)))
    name = given.text.split()[0].lower()
    if re.fullmatch(NUMBER, name) and float(name) > 0.0:
        return 1.0 / float(name)
    if name not in known:
        raise MachineError(
            say(
                "{where}: [TRAJ] {key} is {text}; known are {known}",
                where=given.where,
                key=key,
                text=repr(given.text[:40]),
                known=", ".join(known),
            ),
            given.text,
        )
    return known[name]


def _axis(ini: IniFile, axis: Turn, joint: int, length: float, angle: float) -> Axis:
    letter, rotary = axis.letter, axis.letter not in "XYZ"
    scale = math.radians(angle) if rotary else length
    low, high = (-math.inf, math.inf) if _is_endless(ini, axis, joint) else _limits(ini, axis, joint)
    rate = min(_numbers(ini, joint, letter, "MAX_VELOCITY", both=True))
    acceleration = scale * _acceleration(ini, joint, letter)
    most = UNLIMITED / (angle if rotary else length)
    low, high = (-math.inf if low <= -most else low * scale), (math.inf if high >= most else high * scale)
    try:
        return Axis(
            letter, rotary, axis.side, axis.direction, axis.point, low, high, 60.0 * rate * scale,
            max_acceleration=acceleration,
        )  # fmt: skip
    except MachineError as error:
        raise MachineError(
            say("{path}: [JOINT_{joint}], {error}", path=ini.path, joint=joint, error=error), error.value
        ) from error


def _refuse_wrapped(ini: IniFile, turns: tuple[Turn, ...]) -> None:
    """Raise MachineError for an axis that takes its words modulo 360 deg and their sign for the direction, so
    that C-30 is 30 deg reached backwards: ours mean -30 deg (LinuxCNC, interp_convert.cc: unwrap_rotary)."""
    for turn in turns:
        value = ini.get(f"AXIS_{turn.letter}", "WRAPPED_ROTARY")
        if value is not None and number(value, f"WRAPPED_ROTARY of {turn.letter}") != 0.0:
            text = say(
                "{where}: WRAPPED_ROTARY takes {letter}-30 for 30 deg reached backwards; programs written "
                "here mean -30 deg. Set it to 0, there and on the machine.",
                where=value.where,
                letter=turn.letter,
            )
            raise MachineError(text, value.text)


def _is_endless(ini: IniFile, axis: Turn, joint: int) -> bool:
    """Whether an axis is rotary and has neither limit: LinuxCNC then takes -1e99 and 1e99, as its manual says
    of axes that turn without end."""
    keys = ("MIN_LIMIT", "MAX_LIMIT")
    return axis.letter not in "XYZ" and not any(_read_numbers(ini, joint, axis.letter, key) for key in keys)


def _limits(ini: IniFile, axis: Turn, joint: int) -> tuple[float, float]:
    letter, rotary = axis.letter, axis.letter not in "XYZ"
    low = max(_numbers(ini, joint, letter, "MIN_LIMIT", both=rotary))
    return low, min(_numbers(ini, joint, letter, "MAX_LIMIT", both=rotary))


def _report_endless(ini: IniFile, turns: tuple[Turn, ...], order: str) -> list[Finding]:
    endless = [turn.letter for turn in turns if _is_endless(ini, turn, order.index(turn.letter))]
    if not endless:
        return []
    text = say(
        "{path} gives {letters} neither MIN_LIMIT nor MAX_LIMIT: it turns without end, as LinuxCNC takes it. "
        "If cables or hoses stop it, write both limits there.",
        path=ini.path.name,
        letters=", ".join(endless),
    )
    return [report_finding(Code.AXIS_ENDLESS, text)]


def _acceleration(ini: IniFile, joint: int, letter: str) -> float:
    """Return the lower of both that the ini file says; without a limit where it says none that can be one:
    nothing reckons with it, and a file that LinuxCNC takes is not to be refused for it."""
    try:
        found = min(_read_numbers(ini, joint, letter, "MAX_ACCELERATION"), default=math.inf)
    except MachineError:
        return math.inf
    return found if found > 0.0 else math.inf


def _numbers(ini: IniFile, joint: int, letter: str, key: str, both: bool) -> list[float]:
    """Return what [JOINT_n] says, or where it says nothing [AXIS_L]; with ``both``, what each of them
    says."""
    found = _read_numbers(ini, joint, letter, key)
    if not found:
        ini.need(
            f"JOINT_{joint}", key, say("axis {letter} needs it there or under [AXIS_{letter}]", letter=letter)
        )
    return found if both else found[:1]


def _read_numbers(ini: IniFile, joint: int, letter: str, key: str) -> list[float]:
    """Return what [JOINT_n] and [AXIS_L] say."""
    given = [ini.get(section, key) for section in (f"JOINT_{joint}", f"AXIS_{letter}")]
    return [number(value, f"{key} of {letter}") for value in given if value is not None and value.text]


def _name(ini: IniFile) -> str:
    given = ini.get("EMC", "MACHINE")
    name = re.sub(r"[^\w.+() -]+", "_", given.text if given else "").strip()[:60]
    return name or ini.path.stem
