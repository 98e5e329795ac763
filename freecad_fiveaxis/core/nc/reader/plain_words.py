# SPDX-License-Identifier: LGPL-2.1-or-later
"""Siemens' and Heidenhain's text brought to plain words, run first where it has variables, jumps or calls.

What a text is made of shows when its words are read: a plain program is not searched for it before.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Ints
from freecad_fiveaxis.core.base.sentences import Template

from . import codes, heidenhain, heidenhain_run, interpreter, siemens, siemens_run
from .noted import Notes
from .plane_calls import Tilt
from .siemens_cycles import Drill

NOT_RUN = Template(
    "The lines with variables, expressions or jumps are not interpreted, because of this one: {reason}. Their words are missing "
    "here; post without them."
)


@dataclass(frozen=True)
class Plain:
    """``text`` as plain words; ``source``: the lines of the file that its lines are, where it was run; ``findings``; ``tilts``:
    the lines that begin or end a tilted plane; ``drills``: the calls of drilling cycles."""

    text: bytes
    source: Ints | None
    findings: tuple[Finding, ...]
    tilts: tuple[Tilt, ...]
    drills: tuple[Drill, ...] = ()


def plain_words(text: bytes, language: str, progress: Progress) -> Plain:
    """A text in capitals, without comments. Raises ProgramError for what does not end."""
    return _siemens(text, progress) if language == "siemens" else _heidenhain(text, progress)


def _siemens(text: bytes, progress: Progress) -> Plain:
    notes = Notes()
    read = siemens.plain(text, notes)
    met = notes.met.keys()
    if not (siemens_run.SIGN.search(text) or any(kind is codes.MACRO or name == siemens.SWIVEL for kind, name in met)):
        return _told(text, read, notes, None, [])
    notes = Notes()
    text = siemens.shifts(siemens.without_strings(siemens.swivels(text, notes)))
    source, refused = None, list[Finding]()
    if siemens_run.MARK.search(text):
        run = interpreter.written_out(text, False, progress, siemens=True)
        if isinstance(run, interpreter.Written):
            text, source = run.text, run.source
        else:
            refused = [not_run(run)]
    return _told(text, siemens.plain(text, notes), notes, source, refused, first=True)


def _heidenhain(text: bytes, progress: Progress) -> Plain:
    source, refused, notes = None, list[Finding](), Notes()
    if heidenhain_run.marked(text):
        run = heidenhain_run.written_out(text, progress)
        if isinstance(run, interpreter.Written):
            text, source = run.text, run.source
        else:
            refused = [not_run(run)]
    return _told(text, heidenhain.plain(text, notes), notes, source, refused)


def not_run(run: interpreter.Refused) -> Finding:
    """Why a text was not run."""
    return Finding(Severity.ERROR, codes.MACRO[1], NOT_RUN.say(reason=run.reason), line=run.line)


def _told(text: bytes, read: bytes, notes: Notes, source: Ints | None, refused: list[Finding], first: bool = False) -> Plain:
    """``first``: what was refused is said before what was met."""
    met = [moved(found, source) for found in notes.findings(text)]
    return Plain(read, source, (*refused, *met) if first else (*met, *refused), tuple(notes.tilts), tuple(notes.drills))


def moved(found: Finding, source: Ints | None) -> Finding:
    """A finding with the line of the file."""
    return found if source is None or found.line is None else replace(found, line=int(source[found.line]))
