# SPDX-License-Identifier: LGPL-2.1-or-later
"""NC text of any origin into a Program.

motion line  a line with a word of one of the machine's axes under G0, G1, G2 or G3: one block of the Program,
             an arc several.
guided       where the controller guides the tip (G43.4, G43.5, G234, M128, M428, TRAORI, FUNCTION TCPM) the
             words of the axes are worked out from the tip and the tool axis; what the file says stays in
             ``Program.guided``.

start        rapids of single axes from an unknown place, until all places are known: no blocks. Moves to
             machine positions before the first block and after the last lead nowhere that the program knows,
             and are passed over; one between blocks leaves a gap (:mod:`.machine_moves`).

Drilling cycles are written out (:mod:`.canned_cycles`), variables, jumps and calls within the file are run
(:mod:`.interpreter`). What is not interpreted (other cycles and calls, splines, offsets, compensation) is
never passed over in silence: each kind is a finding with its name, its first line and its count.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.controllers.dialect import Dialect
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program

from .blocks import build_program, divide_blocks
from .causes import fold
from .chords import divide_moves
from .contour_angles import apply_angles
from .feed_measure import find_measure
from .feeds import find_feeds
from .findings import (
    code_findings,
    guide_findings,
    in_file,
    read_as_finding,
    start_findings,
    word_findings,
    wrap_findings,
)
from .lines import UNTOLD, Assumed, Lines
from .machine_moves import feed_findings, find_gaps, leave_out_gaps
from .motion_lines import find_line_states, find_motion_lines
from .positions import find_moves
from .source import read_source
from .turning import plane_findings
from .words import language_of


@dataclass(frozen=True, eq=False)
class Reading:
    """A program with what stands between its blocks. ``lines``: rows of words in the order in which the
    control comes to them, loops and calls written out, row 0 empty; ``row`` (m,) that of each block;
    ``guided`` (rows,) where the controller guides the tip; ``language`` of the text."""

    program: Program
    lines: Lines
    row: Ints
    guided: Bools
    language: str

    def in_file(self) -> Ints:
        """Return the line of the file that each row comes from (rows,)."""
        return self.lines.words.in_file(np.arange(self.lines.count))


def read_nc(
    text: bytes,
    kinematics: Chain,
    dialect: Dialect | None = None,
    progress: Progress = silent,
    assumed: Assumed = UNTOLD,
) -> Program:
    """Return the Program of an NC text. ``dialect``: whose language it is (where the text does not show that
    itself), how F is meant under G94; None: ISO, over X Y Z. ``assumed``: what is taken where the text does
    not say it.

    Rotary words are taken as the machine file's ``wrap_strategy`` says; inches become mm; arcs become chords.
    Axes that the first motion line does not name are taken as 0 there, with a finding. Raises ProgramError,
    naming line and column, for text that cannot be read, and where there is no motion line at all.
    """
    return read_in_order(text, kinematics, dialect, progress, assumed).program


def read_in_order(
    text: bytes,
    kinematics: Chain,
    dialect: Dialect | None = None,
    progress: Progress = silent,
    assumed: Assumed = UNTOLD,
) -> Reading:
    """Return the Program as :func:`read_nc`, with the words between its blocks. Raises ProgramError."""
    progress("reading NC", 0.0)
    source = read_source(text, kinematics, dialect, assumed, progress)
    lines, grammar, words = source.lines, source.grammar, source.lines.words
    state, switched = find_line_states(source, kinematics)
    moving, turned = find_motion_lines(source, state, kinematics)
    moving, bent = apply_angles(lines, moving)
    motions = find_moves(moving, kinematics, state.planes)
    gaps = find_gaps(source, motions, state.axes, kinematics)
    feeds, without_feed = find_feeds(source, motions)
    unknown, of_codes = code_findings(words, grammar, motions.at[~gaps.inside])
    chords, sharp = divide_moves(source, motions)
    blocks = divide_blocks(motions, feeds, chords)
    measure = find_measure(source, blocks.at, kinematics.letters)
    program = build_program(blocks, kinematics, dialect, state.planes, measure)
    findings: tuple[Finding, ...] = (
        *switched, *turned, *unknown, *bent, *word_findings(lines, kinematics.letters, bool(state.on.any())),
        *without_feed, *sharp, *start_findings(kinematics.letters, motions, lines, grammar),
        *wrap_findings(kinematics, motions, dialect),
        *plane_findings(kinematics, state.planes, motions, blocks, program.words),
        *feed_findings(gaps, motions, kinematics.letters),
    )  # fmt: skip
    program = leave_out_gaps(program, gaps, blocks.row)
    findings = (*source.findings, *in_file(words, findings + guide_findings(program, motions)), *of_codes)
    row = program.line
    program = replace(program, line=words.in_file(row), findings=fold(findings, source.cause))
    return Reading(program, lines, row, state.on, grammar.name)


def dialect_of_text(text: bytes, usual: Dialect) -> tuple[Dialect, tuple[Finding, ...]]:
    """Whose program a text is, where nobody has said the controller: ``usual``'s, or by the text's own signs
    that of the first dialect in that language, with a note."""
    language = language_of(text, usual.language)
    if language == usual.language:
        return usual, ()
    dialect = next(one for one in DIALECTS.values() if one.language == language)
    return dialect, (read_as_finding(language, dialect.name),)
