# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC's ``xyzac-trt-kins`` and ``xyzbc-trt-kins`` as machines: a trunnion A (or B) that carries the table C.

With J the joints, P the tip in the work, r = (x-, y-, z-rot-point) and d = (0, y-offset, z-offset + tool), for B
d = (x-offset, 0, z-offset + tool), the module's forward formula is P = r + Rz(-C)(d + Rx(-A)(J - r - d)). The C line therefore
runs through r, the A line through r + d, and the **table** turns by +A and +C, against ISO 841, unless the pin
conventional-directions, which newer versions have, is set.

tool     the tool length: where the pin tool-offset follows motion.tooloffset.z it is the setup's; a constant stays in d.
joint    limits are those of [JOINT_n], of [AXIS_L] where they are missing there; the narrower of both for rotary axes, whose
         word is the joint in every kinematics. A rate is the lower of both.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import Path

from freecad_fiveaxis.core.base.errors import MachineError
from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.base.sentences import Number, say
from freecad_fiveaxis.core.machine import Axis, Machine, Vector

from .hal_files import HalValues
from .ini_file import IniFile, number


@dataclass(frozen=True)
class Trt:
    """One of the modules: its letters, the trunnion's direction, and the two pins that shift the trunnion from the table."""

    letters: str
    trunnion: Vector
    offsets: tuple[str, str]
    unused: str


MODULES = {
    "xyzac-trt-kins": Trt("XYZAC", (1.0, 0.0, 0.0), ("y-offset", "z-offset"), "x-offset"),
    "xyzbc-trt-kins": Trt("XYZBC", (0.0, 1.0, 0.0), ("x-offset", "z-offset"), "y-offset"),
}
LENGTHS = {"mm": 1.0, "metric": 1.0, "in": 25.4, "inch": 25.4, "imperial": 25.4}
ANGLES = {"deg": 1.0, "degree": 1.0, "rad": math.degrees(1.0), "radian": math.degrees(1.0), "grad": 0.9, "gon": 0.9}
UNLIMITED = 99999.0
"""A limit beyond this is none, as in machine files."""


def machine_of_ini(path: Path) -> tuple[Machine, tuple[Finding, ...]]:
    """The machine of a LinuxCNC configuration. Raises MachineError naming the value that is missing or wrong, FileError."""
    ini = IniFile(path)
    module, trt, order = _kinematics(ini)
    hal = HalValues(ini)
    length = _unit(ini, "LINEAR_UNITS", LENGTHS)
    angle = _unit(ini, "ANGULAR_UNITS", ANGLES)
    first, second, findings = _lines(hal, module, trt, length)
    sense = 1.0 if hal.value(f"{module}.conventional-directions") else -1.0
    direction = dict(zip("XYZ", ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), strict=True))
    x, y, z = trt.trunnion
    direction |= {trt.letters[3]: (sense * x + 0.0, sense * y + 0.0, sense * z + 0.0), "C": (0.0, 0.0, sense)}
    point = {trt.letters[3]: first, "C": second}
    axes = [
        _axis(ini, letter, order.index(letter), direction[letter], point.get(letter, (0.0, 0.0, 0.0)), length, angle)
        for letter in ("C", trt.letters[3], "X", "Y", "Z")
    ]
    description = f"LinuxCNC's {module}, imported from {path.name}"
    return Machine(_name(ini), tuple(axes), description=description, controller="linuxcnc"), findings


def _kinematics(ini: IniFile) -> tuple[str, Trt, str]:
    """The module's name, its table, and the letters in the order of the joints."""
    remedy = say("known are {modules}", modules=" and ".join(MODULES))
    given = ini.need("KINS", "KINEMATICS", remedy)
    module, *options = given.text.split()
    if module not in MODULES:
        raise MachineError(
            say("{where}: kinematics {module} cannot be imported; {remedy}", where=given.where, module=module, remedy=remedy),
            module,
        )
    letters = next((option[12:] for option in options if option.startswith("coordinates=")), MODULES[module].letters).upper()
    if sorted(set(letters) & set("XYZABC")) != sorted(MODULES[module].letters):
        raise MachineError(
            say(
                "{where}: coordinates={letters} does not name {known}; correct it",
                where=given.where,
                letters=letters,
                known=MODULES[module].letters,
            ),
            letters,
        )
    return module, MODULES[module], letters


def _lines(hal: HalValues, module: str, trt: Trt, length: float) -> tuple[Vector, Vector, tuple[Finding, ...]]:
    """A point of the trunnion's line, one of the table's, mm, and what is to be said about the pins."""
    pins = ("x-rot-point", "y-rot-point", "z-rot-point", *trt.offsets, trt.unused)
    given = {pin: hal.value(f"{module}.{pin}") for pin in pins}
    given["tool-offset"] = (
        0.0 if hal.joined(f"{module}.tool-offset", "motion.tooloffset.z") else hal.value(f"{module}.tool-offset")
    )
    value = {pin: length * (number or 0.0) for pin, number in given.items()}
    x, y, z = (value[f"{letter}-rot-point"] for letter in "xyz")
    shift = {pin[0]: value[pin] for pin in trt.offsets}
    trunnion = (x + shift.get("x", 0.0), y + shift.get("y", 0.0), z + shift["z"] + value["tool-offset"])
    return trunnion, (x, y, z), tuple(_pin_findings(given, module, trt))


def _pin_findings(given: dict[str, float | None], module: str, trt: Trt) -> list[Finding]:
    found = []
    if lacking := [pin for pin in trt.offsets if given[pin] is None]:
        text = say(
            "No HAL file sets {lacking} of {module}; they are 0, as LinuxCNC has them then. Is that so?",
            lacking=" and ".join(lacking),
            module=module,
        )
        found.append(Finding(Severity.WARNING, "offset-not-set", text))
    if number := given[trt.unused]:
        text = say(
            "{unused} is {given}, but {module} does not use it.",
            unused=trt.unused,
            given=Number(number),
            module=module,
        )
        found.append(Finding(Severity.WARNING, "offset-not-used", text, given[trt.unused]))
    if constant := given["tool-offset"]:
        text = say(
            "tool-offset is a constant {given}; it is in the trunnion's height. Join it to motion.tooloffset.z.",
            given=Number(constant),
        )
        found.append(Finding(Severity.WARNING, "constant-tool-offset", text, given["tool-offset"]))
    return found


def _unit(ini: IniFile, key: str, known: dict[str, float]) -> float:
    given = ini.need("TRAJ", key, say("write one of {known}", known=", ".join(known)))
    name = given.text.split()[0].lower()
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


def _axis(ini: IniFile, letter: str, joint: int, direction: Vector, point: Vector, length: float, angle: float) -> Axis:
    rotary = letter not in "XYZ"
    scale = math.radians(angle) if rotary else length
    low = max(_numbers(ini, joint, letter, "MIN_LIMIT", both=rotary))
    high = min(_numbers(ini, joint, letter, "MAX_LIMIT", both=rotary))
    rate = min(_numbers(ini, joint, letter, "MAX_VELOCITY", both=True))
    most = UNLIMITED / (angle if rotary else length)
    low, high = (-math.inf if low <= -most else low * scale), (math.inf if high >= most else high * scale)
    try:
        return Axis(letter, rotary, "table" if rotary else "head", direction, point, low, high, 60.0 * rate * scale)
    except MachineError as error:
        raise MachineError(
            say("{path}: [JOINT_{joint}], {error}", path=ini.path, joint=joint, error=error), error.value
        ) from error


def _numbers(ini: IniFile, joint: int, letter: str, key: str, both: bool) -> list[float]:
    """What [JOINT_n] says, or where it says nothing [AXIS_L]; with ``both``, what each of them says."""
    given = [ini.get(section, key) for section in (f"JOINT_{joint}", f"AXIS_{letter}")]
    found = [number(value, f"{key} of {letter}") for value in given if value is not None and value.text]
    if not found:
        ini.need(f"JOINT_{joint}", key, say("axis {letter} needs it there or under [AXIS_{letter}]", letter=letter))
    return found if both else found[:1]


def _name(ini: IniFile) -> str:
    given = ini.get("EMC", "MACHINE")
    name = re.sub(r"[^\w.+() -]+", "_", given.text if given else "").strip()[:60]
    return name or ini.path.stem
