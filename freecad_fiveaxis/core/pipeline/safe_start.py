# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the program that the settings ask for begins and ends: its head's lines, and what to say of them.

The lines are made by core/nc/start.py, the plane is found in :mod:`.start_plane`; the Program itself
begins where block 0 ends, with the tool above that place and the rotary axes turned.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Option, Sentence, join_sentences, say
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.machine import BY_NOTHING, Machine
from freecad_fiveaxis.core.machine.kinematics import forward, words_to_q
from freecad_fiveaxis.core.motion.program import Program, upwards
from freecad_fiveaxis.core.nc.start import UPRIGHT, by_reference, with_start

from .context import Box, JobContext, PostContext
from .settings import Settings
from .start_plane import find_start_plane


def add_safe_start(dialect: Dialect, machine: Machine) -> Dialect:
    """Return the dialect with the machine's safe start and end."""
    table = [axis.direction for axis in machine.rotary if axis.side == "table"]
    return with_start(
        dialect, machine.safe_start, all(abs(z) > 1.0 - UPRIGHT for _, _, z in table), machine.rotaries > 0
    )


def start_plane(context: JobContext, program: Program) -> tuple[float, tuple[Finding, ...]]:
    """Return the word of Z at which the program begins and ends, 0 where none is written, and what there is
    to say of it."""
    plane = find_start_plane(context, program)
    return plane.z or 0.0, plane.findings


def start_findings(context: JobContext, program: Program) -> tuple[Finding, ...]:
    """Return what there is to say of start and end."""
    machine, dialect = context.machine, context.dialect
    found: tuple[Finding, ...] = ()
    if dialect.guide is not None and by_reference(dialect, machine.safe_start):
        text = say(
            "Under {split} the program begins and ends at the reference point of Z, because before it no "
            "tool length is active. Set the machine file's safe_start to reference or machine.",
            split=dialect.guide.on[0].split()[0],
        )
        found += (report_finding(Code.STARTS_AT_REFERENCE, text),)
    if machine.safe_start.retract == BY_NOTHING or not len(program.words):
        return found
    return found + _through_part(context, program)


def find_spindle_off(settings: Settings) -> tuple[Finding, ...]:
    """Warn of a program that leaves the spindle off because no speed is given; a note where that is asked
    for."""
    speed = settings.head.spindle
    if speed is None:
        text, severity = (
            say("The spindle stays off: give {spindle}.", spindle=Option("spindle", given="S")),
            Severity.WARNING,
        )
    else:
        text, severity = say("The spindle stays off, as asked: this program is for a dry run."), Severity.NOTE
    return () if speed else (report_finding(Code.SPINDLE_OFF, text, severity=severity),)


def _find_obstacles(context: JobContext) -> list[tuple[Sentence, Box, Severity]]:
    """Find what the first and the last way must not pass through. Where no part is known the cutting points
    stand for it, which is worth a note only, or a warning where the tool points downwards: links and retracts
    are where the part is not."""
    if not isinstance(context, PostContext):
        return [(say("the part"), context.box, Severity.ERROR)]
    fixed = [
        (say("the fixture {name}", name=one.name), one.mesh.box, Severity.ERROR) for one in context.fixtures
    ]
    return [*fixed, (say("the box of the cutting points"), context.cuts, Severity.NOTE)]


def _through_part(context: JobContext, program: Program) -> tuple[Finding, ...]:
    """Return what the straight way of Z to the first place, or from the last, meets."""
    kinematics, obstacles = context.kinematics, _find_obstacles(context)
    found, ends = [], (0, len(program.words) - 1)
    for row, what in zip(
        ends, (say("comes down to its first place"), say("rises from its last place")), strict=True
    ):
        words = program.words[row : row + 1]
        (place,), (axis,) = forward(kinematics, words_to_q(words))
        up = upwards(kinematics, np.radians(words[:, 3:]))[0]
        for obstacle, box, severity in obstacles:
            if _meets(place, up, *box):
                if severity is Severity.NOTE and axis[2] < 0.0:
                    severity = Severity.WARNING
                text = _through_text(what, obstacle, bool(axis[2] < 0.0), severity)
                found.append(_through_finding(text, severity, program, row, place))
    return tuple(found)


def _through_text(what: Sentence, obstacle: Sentence, downwards: bool, severity: Severity) -> Sentence:
    why = (
        say("because the tool axis points downwards there")
        if downwards
        else say("which lies above that place")
    )
    lead = say("The tool {what} along Z through {obstacle}, {why}.", what=what, obstacle=obstacle, why=why)
    if severity is not Severity.ERROR:
        return join_sentences((lead, say("The part is not known here: watch that move.")))
    remedy = say(
        "Begin and end with an upright tool, or set the machine file's safe_start to none and begin by hand."
    )
    return join_sentences((lead, remedy))


def _through_finding(
    text: Sentence, severity: Severity, program: Program, row: int, place: Floats
) -> Finding:
    x, y, z = place.tolist()
    return report_finding(
        Code.START_THROUGH_PART, text, block=row, line=int(program.line[row]), place=(x, y, z),
        severity=severity,
    )  # fmt: skip


def _meets(place: Floats, way: Floats, low: Floats, high: Floats) -> bool:
    """Whether the ray from ``place`` along ``way`` passes the box (slab test)."""
    with np.errstate(divide="ignore", invalid="ignore"):
        near, far = (low - place) / way, (high - place) / way
    level = way == 0.0
    outside = bool((level & ((place <= low) | (place >= high))).any())
    enter = float(np.where(level, -np.inf, np.minimum(near, far)).max())
    leave = float(np.where(level, np.inf, np.maximum(near, far)).min())
    return not outside and max(enter, 0.0) < leave
