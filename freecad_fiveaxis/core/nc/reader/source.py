# SPDX-License-Identifier: LGPL-2.1-or-later
"""A text brought to lines of plain words: up to the program's end, loops, shifts and cycles written out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.controllers.dialect import Dialect
from freecad_fiveaxis.core.machine.kinematics import Chain

from .canned_cycles import write_out_cycles
from .codes import Grammar
from .controller_codes import grammar_of, name_inclinations, name_quadratic_splines, turn_arcs
from .findings import in_file, language_finding, point_findings, up_to_end
from .heidenhain_cycles import diameters
from .heidenhain_frames import replace_changes
from .lines import Assumed, Lines, by_least_increment, without_dwells
from .of_machine import OfMachine
from .polar_mode import without_polar_mode
from .shifts import shift_words
from .siemens_holes import holes_written_out
from .words import Words, language_of, read_words

Expansion = Callable[[Words, Lines, Grammar], tuple[Words, list[Finding]]]


@dataclass(frozen=True, eq=False)
class Source:
    """``lines`` of a text in the language of ``grammar``; ``findings`` of bringing it there, with lines of
    the file; ``cause``: the one of them that says why the program was not run."""

    grammar: Grammar
    lines: Lines
    findings: tuple[Finding, ...]
    cause: Finding | None

    def expand(self, expansion: Expansion) -> Source:
        """Return the source with what the expansion writes out."""
        words, found = expansion(self.lines.words, self.lines, self.grammar)
        lines = self.lines if words is self.lines.words else Lines(words, self.lines.assumed)
        return replace(self, lines=lines, findings=self.findings + in_file(self.lines.words, tuple(found)))


def read_source(
    text: bytes, kinematics: Chain, dialect: Dialect | None, assumed: Assumed, progress: Progress
) -> Source:
    """Return the source of an NC text, as of :func:`.nc_reader.read_nc`. Raises ProgramError, naming line and
    column, for text that cannot be read."""
    expected, controller = ("iso", "") if dialect is None else (dialect.language, dialect.name)
    grammar = grammar_of(language_of(text, expected), controller)
    of_machine = OfMachine(kinematics, assumed.no_motion, diameters(text), assumed.search)
    whole = read_words(text, grammar.name, controller, progress, of_machine)
    progress("reading NC", 0.5)
    words, findings = up_to_end(whole, grammar)
    lines = Lines(without_dwells(words, grammar), assumed)
    if assumed.decimal == "least-increment":
        lines = Lines(by_least_increment(lines, grammar), assumed)
    elif dialect is not None and dialect.least_increment:
        findings += point_findings(lines)
    source = Source(grammar, lines, whole.findings + in_file(words, findings), whole.cause)
    expansions: tuple[Expansion, ...] = (
        without_polar_mode, replace_changes, shift_words, name_quadratic_splines, name_inclinations,
        partial(turn_arcs, controller=controller), partial(write_out_cycles, controller=controller),
    )  # fmt: skip
    if grammar.name == "siemens":  # its cycles tell heights, which the shifts move then
        expansions = holes_written_out, shift_words
    for expansion in expansions:
        source = source.expand(expansion)
    return replace(source, findings=source.findings + language_finding(grammar.name, expected))
