# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane on which a program begins and ends: above the part, and above the machine's bodies, wherever the
axes stand before."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.ranges import ROUNDING
from freecad_fiveaxis.core.base.sentences import Length, Option, Sentence, join_sentences, say
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.gouge.above_bodies import AbovePlane, Clearing, find_clearings
from freecad_fiveaxis.core.gouge.machine_check import InMachine, zero_words
from freecad_fiveaxis.core.machine import BY_CLEARANCE, BY_MACHINE, Machine
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program, plane_above, within_travel
from freecad_fiveaxis.core.motion.program.retract import WHOLE
from freecad_fiveaxis.core.nc.start import by_reference

from .context import JobContext
from .options import choose_rapid_body, resolve_setup, tip_to_driven, tool_body


class StartPlane(NamedTuple):
    """``z``: the word of Z (mm) of the plane, None where no such word is known; ``findings``: what there is
    to say of it; ``above``: what is proven there of the machine's bodies, None: nothing."""

    z: float | None
    findings: tuple[Finding, ...] = ()
    above: AbovePlane | None = None


def find_start_plane(context: JobContext, program: Program) -> StartPlane:
    """Find where Z stands when the program begins and ends, as the machine file asks for it. Raises
    SettingsError where Z does not lift the tool, FiveAxisError for the file of a body that cannot be used."""
    start, kinematics = context.machine.safe_start, context.kinematics
    if not len(program.words) or start.retract not in (BY_CLEARANCE, BY_MACHINE):
        return StartPlane(None)
    _, setup, _ = resolve_setup(context.settings, context.machine)
    needs, sign = _find_needs(context), math.copysign(1.0, float(kinematics.direction[2, 2]))
    if start.z is not None:
        z = start.z + float(zero_words(context.machine, setup, kinematics)[2])
        return _judge(
            needs,
            sign,
            z,
            say("Give safe_start of the machine file a higher Z."),
            (*_beyond_limit(kinematics, z), *_downwards(program, sign, start.z, z)),
        )
    part, found = within_travel(kinematics, _plane_above_part(context, program), program.words)
    if context.dialect.guide is not None and by_reference(context.dialect, start):
        return StartPlane(None, found)
    limit = float(kinematics.high[2] if sign > 0.0 else -kinematics.low[2])
    passed = [one.z for one in needs if math.isfinite(one.z) and not (one.still and one.z > limit)]
    z = max([sign * part, *(math.ceil(one / WHOLE) * WHOLE for one in passed)])
    remedy = say(
        "Z goes no higher: before the start stand the rotary axes by hand where the first block wants them, "
        "use a shorter tool, or narrow the rotary limits in the machine file to what is really used."
    )
    return _judge(needs, sign, sign * min(z, limit) if z > sign * part else part, remedy, found)


def find_written_plane(machine: Machine, dialect: Dialect, plane: StartPlane) -> float | None:
    """Return the word of Z, mm, that the NC file says of the plane, None where it retracts otherwise."""
    if machine.safe_start.retract != BY_CLEARANCE or plane.z is None:
        return None
    return float(dialect.round_word(np.array([plane.z]), 2)[0])


def _beyond_limit(kinematics: Chain, z: float) -> tuple[Finding, ...]:
    """Warn of a machine position of the machine file that Z, as its limits have it, does not reach."""
    low, high = float(kinematics.low[2]), float(kinematics.high[2])
    if low - ROUNDING <= z <= high + ROUNDING:
        return ()
    limit = high if z > high else low
    text = say(
        "The program retracts to the machine position of safe_start, where Z would be {height}, beyond its "
        "limit {limit}. Give safe_start of the machine file another Z, or correct the limits of Z.",
        height=Length(z, bare=True),
        limit=Length(limit, bare=True),
    )
    return (report_finding(Code.SAFE_START_BEYOND_LIMIT, text, z, limit),)


def _downwards(program: Program, sign: float, position: float, z: float) -> tuple[Finding, ...]:
    """Warn of a machine position ``position``, mm, whose word ``z`` is below the place where the program
    begins or ends: the tool would go down to it, or come up from it, past the part."""
    ends = program.words[[0, -1], 2]
    highest = float(ends[(sign * ends).argmax()])
    if sign * (highest - z) <= ROUNDING:
        return ()
    text = say(
        "The program retracts to Z {position} of the machine, which by machine file, work zero and tool "
        "length is Z {height} of the program, below the place at Z {place} where it begins or ends: the "
        "retract goes down, in rapid. Give safe_start of the machine file a higher Z, or say where the part "
        "stands ({origin}).",
        position=Length(position, bare=True), height=Length(z, bare=True), place=Length(highest, bare=True),
        origin=Option("origin"),
    )  # fmt: skip
    return (report_finding(Code.RETRACT_DOWNWARDS, text, z, highest),)


def _plane_above_part(context: JobContext, program: Program) -> float:
    """Return the word of Z of the plane above the part, at every pair of rotary words."""
    settings = context.settings
    widest = max(
        max(piece.low_radius, piece.high_radius) + piece.round for piece in choose_rapid_body(settings).pieces
    )
    body = widest if context.machine.has_head else 0.0  # a tool that lies level reaches down by its radius
    margin = settings.links.clearance + tip_to_driven(settings) + body
    return plane_above(context.kinematics, *context.box, margin, program.words)


def _find_needs(context: JobContext) -> tuple[Clearing, ...]:
    settings, machine = context.settings, context.machine
    _, setup, _ = resolve_setup(settings, machine)
    length = None if settings.machine.tool_length is None else setup.tool_length
    given = InMachine(
        machine, setup, context.kinematics, tool_body(settings), length, tip_to_driven(settings)
    )
    return find_clearings(given, context.box, settings.links.clearance)


def _judge(
    needs: Sequence[Clearing], sign: float, z: float, remedy: Sentence, found: tuple[Finding, ...]
) -> StartPlane:
    """Tell what of the bodies a plane is above."""
    higher = [one for one in needs if one.z > sign * z]
    moved = [one for one in higher if not one.still]
    if not needs or any(math.isinf(one.z) for one in moved):
        return StartPlane(z, found)
    if moved:
        return StartPlane(z, (*found, _too_low(moved, sign, z, remedy)))
    return StartPlane(z, found, AbovePlane(z, tuple(one.name for one in higher)))


def _too_low(moved: Sequence[Clearing], sign: float, z: float, remedy: Sentence) -> Finding:
    need = sign * max(one.z for one in moved)
    text = say(
        "The program begins and ends at Z {height}. Only from Z {need} on are tool and spindle above what "
        "the axes carry, wherever these stand before: {names}.",
        height=Length(z, bare=True), need=Length(need, bare=True), names=", ".join(one.name for one in moved),
    )  # fmt: skip
    return report_finding(Code.START_BELOW_BODIES, join_sentences((text, remedy)), need, z)
