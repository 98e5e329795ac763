# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with a draft, and what it leaves open: by the reader of machine files itself, axis by axis
and body by body.

field     what a problem is about: "axes.A" is one axis, "bodies.platter" a body, "axes" are all together,
          "machine" is the rest.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from freecad_fiveaxis.core.base.codes import Severity
from freecad_fiveaxis.core.base.errors import FiveAxisError, MachineError
from freecad_fiveaxis.core.base.files import check_readable
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import Machine
from freecad_fiveaxis.core.machine.bodies import FILE, MachineBody, check_carriers
from freecad_fiveaxis.core.machine.bodies_file import read_bodies, write_bodies
from freecad_fiveaxis.core.machine.file_objects import read_axis, read_machine
from freecad_fiveaxis.core.machine.kinematics import Setup, chain

from .draft import AxisDraft, MachineDraft
from .draft_file import axis_data, draft_data

AXES, MACHINE = "axes", "machine"


@dataclass(frozen=True)
class Problem:
    """``field`` as at the head of the module; ``text`` names value and remedy; an ERROR keeps the draft from
    being written."""

    field: str
    text: str
    severity: Severity = Severity.ERROR


def check_draft(draft: MachineDraft) -> tuple[Machine | None, tuple[Problem, ...]]:
    """Give the machine of a draft, None where some problem is an error, and the problems, errors first. Its
    bodies' files have their whole names."""
    found = [*_find_repeated_letters(draft), *_axis_errors(draft), *_body_errors(draft)]
    machine: Machine | None = None
    if not found:
        machine, found = _whole(draft)
    return machine, (*found, *_open_questions(draft))


def require_machine(draft: MachineDraft) -> Machine:
    """Give the machine of a draft. Raises MachineError for the first thing that is wrong with it."""
    machine, problems = check_draft(draft)
    if machine is None:
        raise MachineError(problems[0].text, problems[0].field)
    return machine


def _find_repeated_letters(draft: MachineDraft) -> list[Problem]:
    letters = draft.letters()
    twice = sorted({letter for letter in letters if letters.count(letter) > 1})
    return [
        Problem(
            f"{AXES}.{letter}",
            say("two axes are called {letter}; give each a letter of its own", letter=letter),
        )
        for letter in twice
    ]


def _axis_errors(draft: MachineDraft) -> Iterator[Problem]:
    for axis in draft.axes:
        yield from _try_field(f"{AXES}.{axis.letter}", partial(_check_axis, axis, draft.unit))


def _check_axis(axis: AxisDraft, unit: float) -> None:
    if axis.max_rate is None:
        raise MachineError(
            say("axis {letter} has no maximum rate; give what its drive reaches", letter=axis.letter),
            axis.letter,
        )
    read_axis(axis.letter, {axis.letter: axis_data(axis, unit)}, unit)


def _body_errors(draft: MachineDraft) -> Iterator[Problem]:
    """Of each body alone; two of one name are an error of the whole."""
    for body in draft.bodies:
        yield from _try_field(f"bodies.{body.name}", partial(_check_body, body, draft))


def _check_body(body: MachineBody, draft: MachineDraft) -> None:
    read_bodies(write_bodies([body]), f"bodies.{body.name}", 1.0)
    check_carriers([body], draft.letters())
    if body.shape == FILE:
        check_readable(body.file)


def _whole(draft: MachineDraft) -> tuple[Machine | None, list[Problem]]:
    """Return the machine as its file will be read, and the chain that it makes."""
    try:
        machine = read_machine(draft_data(draft))
    except FiveAxisError as error:
        return None, [Problem(MACHINE, error.text)]
    unsolved = list(_try_field(AXES, lambda: chain(machine, Setup(machine.origin))))
    return (None if unsolved else machine), unsolved


def _try_field(field: str, work: Callable[[], Any]) -> Iterator[Problem]:
    try:
        work()
    except FiveAxisError as error:
        yield Problem(field, error.text)


def _open_questions(draft: MachineDraft) -> Iterator[Problem]:
    """Yield what a machine may leave out, and what then is not looked at."""
    for axis in draft.axes:
        if not axis.rotary and (math.isinf(axis.low) or math.isinf(axis.high)):
            text = say(
                "axis {letter} has no end; give its limits, or its travel is not checked", letter=axis.letter
            )
            yield Problem(f"{AXES}.{axis.letter}", text, Severity.WARNING)
        if axis.rotary and not axis.low <= 0.0 <= axis.high:
            text = say(
                "axis {letter} cannot stand at 0; programs begin with their rotary axes there",
                letter=axis.letter,
            )
            yield Problem(f"{AXES}.{axis.letter}", text, Severity.WARNING)
    if draft.table is None:
        text = say("the height of the table's face is not known; setup leaves Z alone without it")
        yield Problem(MACHINE, text, Severity.NOTE)
