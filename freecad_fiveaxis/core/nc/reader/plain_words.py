# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens' and Heidenhain's text brought to plain words, run first where it has variables, jumps or calls.

What a text is made of shows when its words are read: a plain program is not searched for it before.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import NoReturn

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Ints
from freecad_fiveaxis.core.base.sentences import Template, say

from . import codes, din_iso, heidenhain, heidenhain_run, interpreter, siemens, siemens_polar, siemens_run
from .feed_groups import FeedGroup
from .heidenhain_corners import mark_corners
from .heidenhain_polar import without_polar
from .noted import Notes
from .of_machine import NO_MACHINE, OfMachine
from .plane_calls import Tilt
from .siemens_cycles import Drill

NOT_RUN = Template(
    "The lines with variables, expressions or jumps are not interpreted, because of this one: {reason}. "
    "Their words are missing here; post without them."
)
BEHIND_A_CALL = re.compile(b"[%c%c][0-9]+ +[0-9.]" % (ord(codes.PLANE), ord(codes.DRILL)))


@dataclass(frozen=True)
class Plain:
    """``text`` as plain words; ``source``: the lines of the file that its lines are, where it was run;
    ``findings``; ``tilts``: the lines that begin or end a tilted plane; ``drills``: the calls of drilling
    cycles; ``cause``: of the findings why it was not run; ``groups``: over which axes F is measured."""

    text: bytes
    source: Ints | None
    findings: tuple[Finding, ...]
    tilts: tuple[Tilt, ...]
    drills: tuple[Drill, ...] = ()
    cause: Finding | None = None
    groups: tuple[FeedGroup, ...] = ()


def plain_words(text: bytes, language: str, progress: Progress, of_machine: OfMachine = NO_MACHINE) -> Plain:
    """Return a text in capitals, without comments. Raises ProgramError for what does not end."""
    return (
        _siemens(text, progress, of_machine)
        if language == "siemens"
        else _heidenhain(text, progress, of_machine)
    )


def _siemens(text: bytes, progress: Progress, of_machine: OfMachine) -> Plain:
    notes = Notes()
    read = siemens.plain(text, notes)
    met = notes.met.keys()
    calls = bool(of_machine.search) and any(kind is codes.CALL for kind, _ in met)
    if not (
        calls
        or siemens_run.SIGN.search(text)
        or siemens_run.EXPRESSION.search(text)
        or any(kind is codes.MACRO or name == siemens.SWIVEL for kind, name in met)
    ):
        if siemens_polar.SIGN.search(text):
            text, notes = siemens_polar.without_polar(text), Notes()
            read = siemens.plain(text, notes)
        return _with_findings(text, read, notes, None, [])
    notes, called = Notes(), text
    text = siemens.shifts(siemens.without_strings(siemens.swivels(text, notes)))
    source, refused = None, list[Finding]()
    if calls or siemens_run.MARK.search(text) or siemens_run.EXPRESSION.search(text):
        run = interpreter.run_program(text, False, progress, siemens=called, search=of_machine.search)
        if isinstance(run, interpreter.Written):
            text, source = run.text, run.source
        else:
            refused = [not_run(run)]
    text = text if refused else siemens_polar.without_polar(text)
    result = _with_findings(text, siemens.plain(text, notes), notes, source, refused, first=True)
    return replace(result, cause=refused[0] if refused else None)


def _heidenhain(text: bytes, progress: Progress, of_machine: OfMachine) -> Plain:
    source, refused, cause, notes = None, list[Finding](), None, Notes()
    text = din_iso.with_labels(heidenhain.with_points(text))
    if heidenhain_run.has_parameters(text):
        run = heidenhain_run.run_heidenhain(text, progress, of_machine)
        if isinstance(run, interpreter.Written):
            text, source, refused = run.text, run.source, list(run.findings)
        else:
            cause = not_run(run)
            refused = [cause]
    text = mark_corners(without_polar(heidenhain.join_lines(text)))
    text = din_iso.with_own_words(text, notes)
    return replace(_with_findings(text, heidenhain.plain(text, notes), notes, source, refused), cause=cause)


def not_run(run: interpreter.Refused) -> Finding:
    """Why a text was not run."""
    return report_finding(codes.MACRO[0], NOT_RUN.say(reason=run.reason), line=run.line)


def _with_findings(
    text: bytes, read: bytes, notes: Notes, source: Ints | None, refused: list[Finding], first: bool = False
) -> Plain:
    """``first``: what was refused is said before what was met."""
    if (notes.tilts or notes.drills) and (found := BEHIND_A_CALL.search(read)):
        _refuse_digits(text, read.count(b"\n", 0, found.start()), source)
    met = notes.findings(text, source)
    return Plain(
        read, source, (*refused, *met) if first else (*met, *refused), tuple(notes.tilts),
        tuple(notes.drills), groups=tuple(notes.feeds.met),
    )  # fmt: skip


def _refuse_digits(text: bytes, row: int, source: Ints | None) -> NoReturn:
    """Raise for a line of the text, counted from 0, in which digits behind a call would be read as a part of
    its private word."""
    line = row + 1 if source is None else int(source[row + 1])
    shown = text.split(b"\n")[row].decode("latin-1").strip()[:60]
    raise ProgramError(
        say(
            "line {line}: digits stand right behind a call, and no letter before them: {found}",
            line=line,
            found=repr(shown),
        ),
        shown,
    )


def relocate_finding(found: Finding, source: Ints | None) -> Finding:
    """Return a finding with the line of the file."""
    return found if source is None or found.line is None else replace(found, line=int(source[found.line]))
