# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values of a kinematics module's pins, and what is to be said about them.

default  where nothing sets a pin, LinuxCNC has the module's own value; so has the import, and a finding names
         it.
panel    a pin that a slider of the screen sets has the value that the slider starts with, and a finding names
         it.
tool     the tool length: where the tool's pin follows motion.tooloffset.z it is the setup's; a constant lifts
         the rotary lines.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Number, say

from .hal_files import HalValues
from .record import Kinematics

TOOL = "motion.tooloffset.z"


@dataclass(frozen=True)
class PinValues:
    """``values``: of the pins by name, lengths in mm. ``lift``: of the rotary lines by a constant tool
    length, mm.

    ``follows_tool``: whether the tool length comes from motion.tooloffset.z. ``findings``: what is to be
    said."""

    values: Mapping[str, float]
    lift: float
    follows_tool: bool
    findings: tuple[Finding, ...]


def pin_values(hal: HalValues, kind: Kinematics, length: float) -> PinValues:
    """Read the pins of a module; ``length``: mm in a unit of the machine.

    Raises MachineError naming a pin whose value is no number or that no file says.
    """
    given, follows = _read_pins(hal, kind)
    constant = 0.0 if not kind.tool or kind.tool_in or follows else hal.value(kind.pin(kind.tool)) or 0.0
    values = {
        pin.name: (length if pin.length else 1.0)
        * (pin.default if (number := given[pin.name]) is None else number)
        for pin in kind.pins
    }
    findings = [
        *_lacking(given, kind),
        *_report_unused(hal, kind),
        *_constant(kind, constant),
        *_by_panel(hal, kind),
    ]
    return PinValues(values, length * constant, follows, tuple(findings))


def _read_pins(hal: HalValues, kind: Kinematics) -> tuple[dict[str, float | None], bool]:
    """Return what the files say of each pin, and whether the tool length comes in by one of them."""
    given, follows = (
        {pin.name: hal.value(kind.pin(pin.name)) for pin in kind.pins if not _is_summed(kind, pin.name)},
        False,
    )
    if kind.tool_in:
        given[kind.tool], follows = hal.beside(kind.pin(kind.tool), TOOL)
    elif kind.tool:
        follows = hal.is_joined(kind.pin(kind.tool), TOOL)
    return given, follows


def _is_summed(kind: Kinematics, name: str) -> bool:
    return kind.tool_in and name == kind.tool


def _lacking(given: Mapping[str, float | None], kind: Kinematics) -> list[Finding]:
    lacking = [
        f"{pin.name} ({pin.default:g})" for pin in kind.pins if pin.required and given[pin.name] is None
    ]
    if not lacking:
        return []
    text = say(
        "No HAL file sets {lacking} of {module}; LinuxCNC has the values in brackets then. Is that so?",
        lacking=" and ".join(lacking),
        module=kind.name,
    )
    return [report_finding(Code.OFFSET_NOT_SET, text)]


def _report_unused(hal: HalValues, kind: Kinematics) -> list[Finding]:
    found = []
    for name in kind.unused:
        if number := hal.value(kind.pin(name)):
            text = say(
                "{unused} is {given}, but {module} does not use it.",
                unused=name,
                given=Number(number),
                module=kind.name,
            )
            found.append(report_finding(Code.OFFSET_NOT_USED, text, number))
    return found


def _constant(kind: Kinematics, constant: float) -> list[Finding]:
    if not constant:
        return []
    text = say(
        "{pin} is a constant {given}; the rotary axes are that much higher for it. Join it to "
        "motion.tooloffset.z.",
        pin=kind.tool,
        given=Number(constant),
    )
    return [report_finding(Code.CONSTANT_TOOL_OFFSET, text, constant)]


def _by_panel(hal: HalValues, kind: Kinematics) -> list[Finding]:
    taken = [f"{pin.removeprefix(kind.pin(''))} {value:g}" for pin, value in hal.from_panel.items()]
    if not taken:
        return []
    text = say(
        "Sliders of the screen set pins of {module}; taken is what they start with: {taken}. Is that so on "
        "your machine?",
        module=kind.name,
        taken=", ".join(taken),
    )
    return [report_finding(Code.OFFSET_FROM_PANEL, text)]
