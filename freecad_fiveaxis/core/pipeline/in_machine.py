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

from .options import rapids_of, resolve_setup, tip_to_driven, tool_body
from .programs import MilledProgram, ProgramDraft
from .settings import AUDIT, Settings, is_part
from .settings.tree import without_part


def check_bodies(settings: Settings, machine: Machine) -> None:
    """Refuse, before the long work, a body whose file cannot be read, and an audit's shank and holder where
    there is nothing to look at. Raises FileError, SettingsError."""
    for body in machine.bodies:
        if body.file:
            check_readable(body.file)
    gouge, against = settings.gouge, settings.audit.against
    alone = not machine.bodies and not gouge.fixture and (against is None or not is_part(against))
    if settings.task == AUDIT and alone and (gouge.shank or gouge.holder):
        raise without_part(against)


def stand_up(draft: ProgramDraft, progress: Progress = silent) -> tuple[StandingBody, ...]:
    """Stand up the bodies of a program's machine, to be drawn. Raises FiveAxisError for a body's file that
    cannot be used."""
    machine, setup, _ = resolve_setup(draft.settings, draft.machine)
    length = None if draft.settings.machine.tool_length is None else setup.tool_length
    return stand_bodies(machine, setup, draft.kinematics, length, progress)


def over_tip(draft: ProgramDraft) -> Body:
    """Give the tool, and what the spindle carries over it where the tool's length is known; heights from the
    tip."""
    machine, setup, _ = resolve_setup(draft.settings, draft.machine)
    tool = tool_body(draft.settings)
    if draft.settings.machine.tool_length is None:
        return tool
    return Body(
        (*tool.pieces, *spindle_body(machine, setup.tool_length + tip_to_driven(draft.settings)).pieces)
    )


def look_in_machine(draft: ProgramDraft, against: object, progress: Progress) -> tuple[Finding, ...]:
    """Find what tool, spindle and bodies of the machine hit of it, and the spindle of the part (what the tool
    hits of fixtures is looked at by itself); ``against``: what an audit compares with."""
    settings = draft.settings
    machine, setup, _ = resolve_setup(settings, draft.machine)
    length = None if settings.machine.tool_length is None else setup.tool_length
    part = draft.mesh if isinstance(draft, MilledProgram) else against if isinstance(against, Mesh) else None
    given = InMachine(
        machine, setup, draft.kinematics, tool_body(settings), length, tip_to_driven(settings),
        rapids_of(settings, machine, draft.dialect), settings.gouge.fixture_clearance, draft.fixtures,
    )  # fmt: skip
    return check_machine(given, draft.program, part, settings.proof.tolerance, progress)
