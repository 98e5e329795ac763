# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program against the bodies of its machine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.files import check_readable
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import join_sentences, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.machine_bodies import spindle_body
from freecad_fiveaxis.core.gouge.machine_check import InMachine, check_machine
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.report.standing_bodies import StandingBody, stand_bodies
from freecad_fiveaxis.core.tool.body import Body
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .options import rapids_of, resolve_setup, tip_to_driven, tool_body
from .programs import MilledProgram, PostedProgram, ProgramDraft
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
    tolerance = settings.proof.tolerance
    found = check_machine(given, draft.program, part, tolerance, progress)
    if isinstance(draft, PostedProgram) and machine.bodies and draft.plane.z is not None:
        found += _look_at_ends(given, draft.program, draft.plane.z, part, tolerance)
    return found


def _look_at_ends(
    given: InMachine, program: Program, plane: float, part: Mesh | None, tolerance: float
) -> tuple[Finding, ...]:
    """Find what is hit where Z alone comes down from the plane to the first block, and rises to it from the
    last one: lines of the NC file, but no blocks."""
    rows = np.array([0, 0, -1, -1])
    words = program.words[rows]
    words[[0, 3], 2] = plane
    ends = Program(
        program.letters, words, np.zeros(4), np.zeros(4, np.bool_), np.full(4, Motion.RAPID, np.int8),
        np.zeros(4), program.row[rows], program.line[rows], unknown_way=np.array([True, False, True, False]),
    )  # fmt: skip
    lead = say("Where Z comes down to the first block, or rises from the last one:")
    return tuple(
        replace(one, text=join_sentences((lead, one.text)), block=_end_of(one, program), hit=None)
        for one in check_machine(given, ends, part, tolerance)
        if one.code in (Code.MACHINE_COLLISION, Code.MACHINE_UNPROVEN) and one.block is not None
    )


def _end_of(found: Finding, program: Program) -> int:
    """Return the block of the program, its first or last, at which something is hit."""
    return 0 if found.block == 1 else len(program.words) - 1
