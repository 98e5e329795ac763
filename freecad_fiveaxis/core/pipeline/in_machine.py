# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program against the bodies of its machine."""

from __future__ import annotations

from freecad_fiveaxis.core.base.files import check_readable
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.machine_bodies import spindle_body
from freecad_fiveaxis.core.gouge.machine_check import InMachine, check_machine
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.report.standing_bodies import StandingBody, stand_bodies
from freecad_fiveaxis.core.tool.body import Body

from .made import Made, Milled
from .options import rapids_of, stood, tip_to_driven, tool_body
from .settings import AUDIT, Settings, is_part
from .settings.tree import without_part


def check_bodies(settings: Settings, machine: Machine) -> None:
    """Refuse, before the long work, a body whose file cannot be read, and an audit's shank and holder where there is nothing to
    look at. Raises FileError, SettingsError."""
    for body in machine.bodies:
        if body.file:
            check_readable(body.file)
    gouge, against = settings.gouge, settings.audit.against
    alone = not machine.bodies and not gouge.fixture and (against is None or not is_part(against))
    if settings.task == AUDIT and alone and (gouge.shank or gouge.holder):
        raise without_part(against)


def stand_up(made: Made, progress: Progress = silent) -> tuple[StandingBody, ...]:
    """Stand up the bodies of a program's machine, to be drawn. Raises FiveAxisError for a body's file that cannot be used."""
    machine, setup, _ = stood(made.settings, made.machine)
    length = None if made.settings.machine.tool_length is None else setup.tool_length
    return stand_bodies(machine, setup, made.kinematics, length, progress)


def over_tip(made: Made) -> Body:
    """Give the tool, and what the spindle carries over it where the tool's length is known; heights from the tip."""
    machine, setup, _ = stood(made.settings, made.machine)
    tool = tool_body(made.settings)
    if made.settings.machine.tool_length is None:
        return tool
    return Body((*tool.pieces, *spindle_body(machine, setup.tool_length + tip_to_driven(made.settings)).pieces))


def look_in_machine(made: Made, against: object, progress: Progress) -> tuple[Finding, ...]:
    """Find what tool and spindle hit of the machine, and the spindle of the part (fixtures are looked
    at by themselves); ``against``: what an audit compares with."""
    settings = made.settings
    machine, setup, _ = stood(settings, made.machine)
    length = None if settings.machine.tool_length is None else setup.tool_length
    part = made.mesh if isinstance(made, Milled) else against if isinstance(against, Mesh) else None
    given = InMachine(
        machine, setup, made.kinematics, tool_body(settings), length, tip_to_driven(settings),
        rapids_of(settings, machine, made.dialect), settings.gouge.fixture_clearance,
    )  # fmt: skip
    return check_machine(given, made.program, part, settings.proof.tolerance, progress)
