# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two tasks about the machine itself: ``recover``, what a post takes it to be; ``prove-signs``, whether it is
what its file says.

``run`` makes, ``write_outputs`` writes: the machine file or the NC file, and the reports.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from freecad_fiveaxis.core.audit.units import units_of_steps
from freecad_fiveaxis.core.base.errors import FileError, ProgramError, SettingsError, naming_file
from freecad_fiveaxis.core.base.files import check_readable, read_bytes, write_all
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.sentences import Option, one_line, say
from freecad_fiveaxis.core.machine import Axis, Machine, check_new, load_machine, machine_bytes
from freecad_fiveaxis.core.machine.kinematics import Setup, chain
from freecad_fiveaxis.core.motion.program import Program
from freecad_fiveaxis.core.nc.head import PostOptions
from freecad_fiveaxis.core.nc.reader import Assumed, dialect_of_text, read_nc
from freecad_fiveaxis.core.pipeline.options import (
    cl_reading,
    dialect_for,
    load_setup,
    search_folders,
    title_of,
)
from freecad_fiveaxis.core.pipeline.settings import RECOVER, Settings, flat_options
from freecad_fiveaxis.core.toolpath.apt import read_apt

from .prove_signs import Plan, Wishes, make_plan, proof_nc, proof_program, sheet_html, sheet_json, sheet_text
from .recover import (
    Recovery,
    find_axis_step,
    recover,
    recovery_findings,
    recovery_html,
    recovery_json,
    recovery_text,
    rotary_letters,
)

SUFFIX = ".fcm"


@dataclass(frozen=True, eq=False)
class Recovered:
    """``found``: the machine as it is to be written, its fit and its findings."""

    settings: Settings
    found: Recovery
    findings: tuple[Finding, ...]


@dataclass(frozen=True, eq=False)
class Proof:
    """``plan``: the stops; ``program``: its blocks; ``nc``: the file."""

    settings: Settings
    plan: Plan
    program: Program
    nc: bytes
    findings: tuple[Finding, ...]


Work = Recovered | Proof


def run(settings: Settings, progress: Progress = silent) -> Work:
    """Do the task that the settings name. Raises FiveAxisError for input that cannot be used; writes
    nothing."""
    return (recover_machine if settings.task == RECOVER else prove)(settings, progress)


def _with_cause(refused: ProgramError, units: tuple[Finding, ...]) -> ProgramError:
    """Return the same refusal and, where a file seems to be in another unit, that this is why."""
    if not units:
        return refused
    return ProgramError(say("{reason}. {cause}", reason=refused.args[0], cause=units[0].text), refused.value)


def recover_machine(settings: Settings, progress: Progress = silent) -> Recovered:
    """Return the machine that a post had in mind. Raises FiveAxisError where the files cannot be used."""
    output = settings.recover.machine_file
    if not output:
        raise SettingsError(say("no machine file named; give one with -o OUT.fcm"), None)
    if Path(output).suffix.lower() != SUFFIX:
        raise SettingsError(
            say(
                "{output} does not end in {suffix}, as machine files do; name it so",
                output=output,
                suffix=SUFFIX,
            ),
            output,
        )
    if os.path.exists(output):
        raise FileError(
            say("{output} exists already; choose another name, so that no machine is lost", output=output),
            output,
        )
    for file in (settings.source, settings.recover.program):
        check_readable(file)
    apt, nc = read_bytes(settings.source, "CL file"), read_bytes(settings.recover.program, "NC file")
    start, setup = _start(settings)
    with naming_file(settings.source):
        path = read_apt(apt, cl_reading(settings), progress)
    dialect = dialect_for(settings.machine.controller, start)
    dialect, read_as = (dialect, ()) if settings.machine.controller else dialect_of_text(nc, dialect)
    search = search_folders(settings, settings.recover.program)
    assumed = Assumed(
        settings.reading.units, settings.reading.decimal, start.no_motion if start else (), search, False
    )
    with naming_file(settings.recover.program):
        program = read_nc(nc, chain(_reader(nc, start), Setup()), dialect, progress, assumed)
        _refuse_guided(program)
    units = units_of_steps(program, path)
    try:
        found = recover(path, program, start, setup, find_axis_step(apt), Path(output).stem, progress)
    except ProgramError as refused:
        raise _with_cause(refused, units) from refused
    verdicts = units + recovery_findings(found, settings.recover.certainty)
    machine = replace(found.machine, controller=dialect.name, description=_description(settings, found))
    found = replace(found, machine=machine, findings=path.findings + read_as + program.findings + verdicts)
    return Recovered(settings, found, found.findings)


def _refuse_guided(program: Program) -> None:
    """Raise ProgramError where the controller guides the tip: X Y Z are then its place, whatever the
    machine."""
    if program.guided is None or not program.guided.on.any():
        return
    line = int(program.line[int(program.guided.on.argmax())])
    raise ProgramError(
        say(
            "from line {line} on the controller guides the tip (G43.4, G43.5, G234, M128, M428, TRAORI or "
            "FUNCTION TCPM): X Y Z "
            "are tips and say nothing of pivots; post it again without tool centre point control",
            line=line,
        ),
        line,
    )


def _start(settings: Settings) -> tuple[Machine | None, Setup]:
    given = settings.machine
    start = load_machine(given.machine) if given.machine else None
    if start is not None and start.rotaries < 2:
        raise SettingsError(
            say(
                "machine {name} has fewer than two rotary axes, and only five axes are recovered: leave "
                "{machine} out",
                name=start.name,
                machine=Option("machine"),
            ),
            start.rotaries,
        )
    origin = given.origin or (start.origin if start else (0.0, 0.0, 0.0))
    return start, Setup(origin, given.tool_length or 0.0)


def _reader(nc: bytes, start: Machine | None) -> Machine:
    """Return the machine that is given, where the program has its letters; else one of the program's."""
    letters = rotary_letters(nc)
    if start is not None and {axis.letter for axis in start.rotary} == set(letters):
        return start
    return _reader_machine(letters)


def _reader_machine(letters: str) -> Machine:
    """Return a machine of these letters, to read words with; nothing else of it is used."""
    ways = {"A": (1.0, 0.0, 0.0), "B": (0.0, 1.0, 0.0), "C": (0.0, 0.0, 1.0)}
    first, second = letters[1], letters[0]
    rotary = (Axis(first, True, "table", ways[first]), Axis(second, True, "table", ways[second]))
    linear = (
        Axis("X", False, "head", ways["A"]),
        Axis("Y", False, "head", ways["B"]),
        Axis("Z", False, "head", ways["C"]),
    )
    return Machine("program", (*rotary, *linear))


def _description(settings: Settings, found: Recovery) -> str:
    names = f"{Path(settings.source).name} and {Path(settings.recover.program).name}"
    plain = "".join(letter if letter.isprintable() else "?" for letter in names)
    return f"Recovered from {plain}: {found.fit.layout.kind}, {int(found.fit.good.sum())} rows"


def prove(settings: Settings, progress: Progress = silent) -> Proof:
    """Return the program that proves a machine's signs, and its sheet. Raises SettingsError where the limits
    leave no room."""
    if not settings.output.output:
        raise SettingsError(say("no NC file named; give one with -o OUT.ngc"), None)
    machine, setup, dialect = load_setup(settings)
    wish = settings.prove
    plan = make_plan(machine, setup, Wishes(wish.mark, wish.gap, wish.travel, wish.angle, wish.slow_feed))
    progress("prove signs", 0.5)
    program = proof_program(plan, dialect)
    tool = None if settings.head.tool is None else int(settings.head.tool)
    nc = proof_nc(plan, program, dialect, PostOptions(tool, offset=settings.head.work_offset))
    return Proof(settings, plan, program, nc, plan.findings)


def as_text(done: Work) -> str:
    """Return what was found, for the terminal."""
    if isinstance(done, Recovered):
        return f"{title_of(done.settings)}: recover\n" + recovery_text(done.found)
    return f"{done.plan.machine.name}: prove-signs\n" + sheet_text(done.plan, done.program)


def as_json(done: Work) -> str:
    """Return what was found, for scripts; ``inputs`` is a job file."""
    inputs: dict[str, Any] = flat_options(done.settings)
    if isinstance(done, Recovered):
        return recovery_json(done.found, inputs)
    return sheet_json(done.plan, done.program, inputs)


def as_html(done: Work) -> str:
    """Write what was found, as a page of its own."""
    if isinstance(done, Recovered):
        names = f"{title_of(done.settings)} and {Path(done.settings.recover.program).name}"
        return recovery_html(done.found, one_line(names))
    return sheet_html(done.plan, done.program)


REPORTS: dict[str, Callable[[Work], str]] = {
    ".json": as_json,
    ".html": as_html,
    ".htm": as_html,
    ".txt": as_text,
}


def write_outputs(done: Work) -> list[str]:
    """Write the machine or NC file and the reports, all or none; returns their names. Raises FileError."""
    reports = done.settings.output.report
    files = {
        path: REPORTS[Path(path).suffix.lower()](done).encode("utf-8", "backslashreplace") for path in reports
    }
    target = done.settings.output.output if isinstance(done, Proof) else done.settings.recover.machine_file
    assert target  # checked before the work
    if isinstance(done, Recovered):
        check_new(target)
    content = done.nc if isinstance(done, Proof) else machine_bytes(done.found.machine)
    write_all({target: content, **files})
    return [target, *files]
