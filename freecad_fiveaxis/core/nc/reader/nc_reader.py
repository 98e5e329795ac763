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

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.controllers import DIALECTS
from freecad_fiveaxis.core.controllers.dialect import Dialect, feed_distance
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Guided, Program, rapid_minutes
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from . import codes, corners
from .arcs import Arcs, Chords, divide_arcs
from .canned_cycles import write_out_cycles
from .causes import fold
from .codes import GRAMMARS, INCH, Grammar
from .contour_angles import apply_angles
from .dynamic_offset import find_offset_planes
from .feeds import feeds
from .findings import (
    code_findings,
    guide_findings,
    in_file,
    language_finding,
    point_findings,
    read_as_finding,
    start_findings,
    up_to_end,
    word_findings,
    wrap_findings,
)
from .heidenhain_cycles import diameters
from .kinematics_switch import find_switches, switch_findings
from .lines import UNTOLD, Assumed, Lines, by_least_increment, last_of, without_dwells
from .machine_moves import find_gaps, leave_out_gaps
from .of_machine import OfMachine
from .planes import Planes, planes_of
from .positions import (
    ABSOLUTE,
    STEP,
    Moves,
    absolute_anyway,
    axis_words,
    check_near,
    find_start,
    in_work,
    moves,
    tool_axes,
    where_axes_stand,
)
from .shifts import shift_words
from .siemens_holes import holes_written_out
from .turning import off_normal, turn_into_planes, vector_findings
from .words import Words, language_of, read_words


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
    progress("reading NC", 0.0)
    expected = "iso" if dialect is None else dialect.language
    language = language_of(text, expected)
    grammar = GRAMMARS[language]
    words, lines, before, cause = _words_and_lines(
        text,
        grammar,
        dialect,
        assumed,
        progress,
        OfMachine(kinematics, assumed.no_motion, diameters(text), assumed.search),
    )
    findings = language_finding(language, expected)
    axes = [axis_words(lines, letter) for letter in kinematics.letters]
    mode, on = lines.mode(grammar.motion, codes.NONE), _guide_on(lines, grammar)
    dynamic, reports = find_offset_planes(lines, axes, on, kinematics, grammar)
    findings += (*reports, *switch_findings(lines, grammar))
    planes = planes_of(lines, grammar, dynamic)
    if planes is not None:
        mode, on = planes.modes(mode, on)
    at = _motion_lines(lines, grammar, axes, mode, on, planes)
    if not len(at):
        raise _no_motion(before, kinematics.letters)
    first, second = (axis.wrap for axis in kinematics.axes[3:])
    wrap, meant = (first, second), _convert_words(lines, axes, at, grammar, kinematics.letters)
    meaning = on[at].astype(np.int64)
    if planes is not None:
        solved = turn_into_planes(kinematics, meant, at, planes, wrap)
        meant, findings = solved.words, (*findings, *planes.findings, *solved.findings)
        meaning = planes.of_blocks(at, on[at], meant)
    meant, bent = apply_angles(lines, at, meant, mode[at], meaning)
    at, motions = _moves(lines, at, meant, mode, on, kinematics, wrap, meaning, planes)
    by_vector: Bools = np.asarray(~np.isnan(motions.vector).all(axis=1))
    gaps = find_gaps(lines, at, axes, mode[at] == codes.RAPID, by_vector, grammar)
    feed, inverse, more = feeds(lines, at, mode[at] != codes.RAPID, grammar)
    unknown, of_codes = code_findings(words, grammar, at[~gaps.inside])
    chords, bad = _chords(lines, motions, mode[at], grammar)
    chords, sharp = _corners(lines, motions, mode[at], grammar, chords)
    bad += sharp
    findings += (
        *unknown,
        *bent,
        *word_findings(words, lines, kinematics.letters, bool(on.any())),
        *more,
        *bad,
    )
    findings += tuple(start_findings(kinematics.letters, motions, mode[at], lines, grammar))
    findings += tuple(
        wrap_findings(kinematics.letters, wrap, meant, motions, mode[at] != codes.RAPID, dialect)
    )
    program = _program(
        kinematics,
        motions,
        chords,
        mode[at],
        feed,
        inverse,
        lines.mode(codes.FEED_MODE, 0)[at],
        dialect,
        planes,
    )
    if planes is not None:
        findings += (
            *vector_findings(planes, motions),
            *off_normal(planes, motions, chords, tool_axes(kinematics, program.words)),
        )
    program = leave_out_gaps(program, gaps, np.arange(len(at)) if chords is None else chords.row)
    findings = fold((*before, *in_file(words, findings + guide_findings(program, motions)), *of_codes), cause)
    return replace(program, line=words.in_file(program.line), findings=findings, wrap=wrap)


def _no_motion(before: tuple[Finding, ...], letters: str) -> ProgramError:
    """Return the error of a text without a motion line: where all stands in what is not interpreted, that is
    the cause."""
    lost = next((found for found in before if found.code == codes.MACRO[0]), None)
    if lost is None:
        return ProgramError(
            say("the file holds no motion blocks: no axis word of this machine under G0 or G1"), letters
        )
    return ProgramError(
        say(
            "all moves stand in variables, expressions or jumps, which are not interpreted; line {line}: "
            "{text}",
            line=lost.line or 0,
            text=lost.text,
        ),
        letters,
    )


def _words_and_lines(
    text: bytes,
    grammar: Grammar,
    dialect: Dialect | None,
    assumed: Assumed,
    progress: Progress,
    of_machine: OfMachine,
) -> tuple[Words, Lines, tuple[Finding, ...], Finding | None]:
    """Return the words up to the program's end, loops and cycles written out; the same by lines; the
    findings, and the one of them that says why the program was not run."""
    controller = "" if dialect is None else dialect.name
    words = read_words(text, grammar.name, controller, progress, of_machine)
    progress("reading NC", 0.5)
    cause = words.cause
    words, findings = up_to_end(words, grammar)
    words = without_dwells(words, grammar)
    lines = Lines(words, assumed)
    if assumed.decimal == "least-increment":
        words = by_least_increment(words, lines, grammar)
        lines = Lines(words, assumed)
    elif dialect is not None and dialect.least_increment:
        findings += point_findings(words)
    if grammar.name == "siemens":  # its cycles tell heights, which the shifts move then
        expanded, found = holes_written_out(words, lines, grammar)
    else:
        expanded, found = shift_words(words, lines, grammar)
    findings = words.findings + in_file(words, (*findings, *found))
    words, lines = expanded, lines if expanded is words else Lines(expanded, assumed)
    if grammar.name == "siemens":
        expanded, found = shift_words(words, lines, grammar)
    else:
        expanded, found = write_out_cycles(words, lines, grammar, controller)
    findings += in_file(words, tuple(found))
    return expanded, lines if expanded is words else Lines(expanded, assumed), findings, cause


def dialect_of_text(text: bytes, usual: Dialect) -> tuple[Dialect, tuple[Finding, ...]]:
    """Whose program a text is, where nobody has said the controller: ``usual``'s, or by the text's own signs
    that of the first dialect in that language, with a note."""
    language = language_of(text, usual.language)
    if language == usual.language:
        return usual, ()
    dialect = next(one for one in DIALECTS.values() if one.language == language)
    return dialect, (read_as_finding(language, dialect.name),)


def _guide_on(lines: Lines, grammar: Grammar) -> Bools:
    """Whether the controller guides the tip, in each line. G43 and G49 end what G43.4 began, but not what
    M428 or M128 did."""
    events = [(lines.m_line((code,)), bool(number)) for code, number in (grammar.guide_m or {}).items()]
    if codes.SWITCH in lines.letters:
        switch = lines.column(codes.SWITCH)
        events += [(np.flatnonzero(switch == number), bool(number)) for number in (0, 1)]
    on = _find_states([*events, *find_switches(lines, grammar)], lines.count)
    if grammar.name == "iso":
        both = ((codes.GUIDE_ON, True), ((*codes.GUIDE_OFF, *codes.KINEMATICS[1:]), False))
        on |= _find_states(
            [(lines.code_line[np.isin(lines.code, chosen)], state) for chosen, state in both], lines.count
        )
    return on


def _find_states(events: list[tuple[Ints, bool]], count: int) -> Bools:
    """Return the state in each line, off at first, from the lines where it is switched; on wins over off in
    the same line."""
    on, marked = np.zeros(count, np.bool_), np.zeros(count, np.bool_)
    for where, state in sorted(events, key=lambda event: event[1]):
        on[where], marked[where] = state, True
    return on[last_of(np.flatnonzero(marked), count)]


def _motion_lines(
    lines: Lines,
    grammar: Grammar,
    axes: list[tuple[Floats, Bytes]],
    mode: Ints,
    on: Bools,
    planes: Planes | None,
) -> Ints:
    """Return the lines that are blocks."""
    moving = np.logical_or.reduce([kind != 0 for _, kind in axes])
    if on.any():
        moving |= ~np.isnan(_tool_vectors(lines, mode, on)).all(axis=1)
    if codes.ANGLE in lines.letters:
        moving |= ~np.isnan(lines.column(codes.ANGLE)) & ((mode == codes.RAPID) | (mode == codes.STRAIGHT))
    if (mode == codes.ARC).any():  # a full circle needs no word of an axis
        moving |= (mode == codes.ARC) & np.logical_or.reduce(
            [~np.isnan(lines.column(letter)) for letter in "IJK"]
        )
    moving &= ~lines.any_of(grammar.no_move) & (mode != codes.CYCLE)
    moving[lines.m_line(grammar.machine_m)] = False
    if codes.MACHINE in lines.letters:
        moving &= np.isnan(lines.column(codes.MACHINE))
    if planes is not None:
        moving[list(planes.turning)] = True
    return np.flatnonzero(moving)


def _moves(
    lines: Lines, at: Ints, words: list[tuple[Floats, Bytes]], mode: Ints, on: Bools, kinematics: Chain,
    wrap: tuple[str, str],
    meaning: Ints, planes: Planes | None,
) -> tuple[Ints, Moves]:  # fmt: skip
    """Return the lines of the blocks, those of a safe start left out, and where they lead."""
    vector = _vectors(lines, at, mode, on)
    vector = vector if planes is None else planes.vectors_in_work(vector, meaning)
    start = find_start(words, meaning, mode[at] == codes.RAPID, vector)
    kept = [(value[start.row :], kind[start.row :]) for value, kind in words]
    at, vector, meaning = at[start.row :], vector[start.row :], meaning[start.row :]
    return at, moves(at, kept, on[at], vector, kinematics, wrap, start.programmed, meaning, planes)


def _tool_vectors(lines: Lines, mode: Ints, on: Bools) -> Floats:
    """Return the tool axis (lines, 3) that each guided line gives as a vector, NaN where none."""
    private = [lines.column(letter) for letter in codes.VECTOR]
    vector = np.stack(private, axis=1)
    if not np.isin(lines.code, codes.VECTORS_ON).any():
        return np.where(on[:, None], vector, np.nan)
    group = {**dict.fromkeys((*codes.GUIDE_ON, *codes.GUIDE_OFF), 0), **dict.fromkeys(codes.VECTORS_ON, 1)}
    by_ijk = (lines.mode(group, 0) == 1) & (mode != codes.ARC) & on
    iso = np.stack([lines.column(letter) for letter in "IJK"], axis=1)
    return np.where(by_ijk[:, None], iso, np.where(on[:, None], vector, np.nan))


def _vectors(lines: Lines, at: Ints, mode: Ints, on: Bools) -> Floats:
    return _tool_vectors(lines, mode, on)[at] if on.any() else np.full((len(at), 3), np.nan)


def _convert_words(
    lines: Lines, axes: list[tuple[Floats, Bytes]], at: Ints, grammar: Grammar, letters: str
) -> list[tuple[Floats, Bytes]]:
    """Return the words of the motion lines in mm and degrees, and how each is meant."""
    steps = lines.mode(codes.DISTANCE, 0)[at] == 1
    inch = lines.inch(grammar)[at]
    meant = []
    for k, (value, kind) in enumerate(axes):
        value, kind = value[at], kind[at]
        if k < 3 and inch.any():
            value = np.where(inch, value * INCH, value)
        if steps.any():
            anyway = absolute_anyway(lines, letters[k])[at]
            kind = np.where(steps & (kind == ABSOLUTE) & ~anyway, STEP, kind).astype(np.int8)
        meant.append((value, kind))
    return meant


def _chords(
    lines: Lines, motions: Moves, mode: Ints, grammar: Grammar
) -> tuple[Chords | None, list[Finding]]:
    """Return the arcs as chords; None where there are none."""
    row = np.flatnonzero(mode == codes.ARC)
    if not len(row):
        return None, []
    line = motions.at[row]
    inch = np.where(lines.inch(grammar)[line], INCH, 1.0)
    is_arc = np.zeros(lines.count, np.bool_)
    is_arc[line] = True
    columns = {letter: lines.column(letter) for letter in ("I", "J", "K", "R", *codes.CENTRE)}
    for letter, column in columns.items():
        check_near(lines, letter, np.where(is_arc, column, np.nan))
    offset = np.stack([columns[letter][line] for letter in "IJK"], axis=1) * inch[:, None]
    here = np.stack([columns[letter] for letter in codes.CENTRE], axis=1)
    centre = np.stack([_last_programmed(column)[line] for column in here.T], axis=1) * inch[:, None]
    sense = lines.mode({codes.CLOCKWISE: 0, codes.COUNTER: 1}, 0)[line]
    arcs = Arcs(
        row, lines.mode(codes.PLANES, 0)[line], sense == 1, offset, lines.mode(codes.CENTRES, 0)[line] == 1,
        columns["R"][line] * inch, centre,
        lines.column(codes.TURNS)[line] if codes.TURNS in lines.letters else None,
    )  # fmt: skip
    return divide_arcs(arcs, motions.before, motions.programmed, motions.at)


def _corners(
    lines: Lines, motions: Moves, mode: Ints, grammar: Grammar, chords: Chords | None
) -> tuple[Chords | None, list[Finding]]:
    """Return the chords with those of rounded and chamfered corners."""
    if corners.LETTER not in lines.letters:
        return chords, []
    at = motions.at
    size, length, modal = corners.sizes(lines.column(corners.LETTER), at)
    scale = np.where(lines.inch(grammar)[at], INCH, 1.0)
    found = corners.Corners(size * scale, length, modal, lines.mode(codes.PLANES, 0)[at], mode != codes.RAPID)
    return corners.with_corners(found, motions.before, motions.programmed, chords, at)


def _last_programmed(column: Floats) -> Floats:
    """Return the last value of a column at or before each line, NaN before the first."""
    return column[last_of(np.flatnonzero(~np.isnan(column)), len(column))]


def _program(
    kinematics: Chain, motions: Moves, chords: Chords | None, mode: Ints, feed: Floats, inverse: Bools,
    feed_mode: Ints,
    dialect: Dialect | None, planes: Planes | None,
) -> Program:  # fmt: skip
    before, programmed, on, line = motions.before, motions.programmed, motions.on, motions.at
    vector, meaning = motions.vector, motions.meaning
    if chords is not None:
        row, before, programmed = chords.row, chords.before, chords.programmed
        feed = np.where(inverse, feed * chords.count, feed)
        mode, feed_mode, line = mode[row], feed_mode[row], line[row]
        feed, inverse, on, vector, meaning = feed[row], inverse[row], on[row], vector[row], meaning[row]
    motion = np.where(mode == codes.RAPID, Motion.RAPID, Motion.CUT).astype(np.int8)
    change = programmed - before
    programmed = in_work(programmed, meaning, planes)
    words = where_axes_stand(kinematics, programmed, on if planes is None else on | planes.by_tip(meaning))
    guided = _gather_guided(kinematics, words, programmed, on, vector) if on.any() else None
    seconds = _seconds(
        words, change, motion, feed, inverse, feed_mode == codes.PER_TURN, on, kinematics, dialect
    )
    return Program(
        kinematics.letters, words, feed, inverse, motion, seconds, np.full(len(line), -1), line, (), guided
    )


def _gather_guided(kinematics: Chain, words: Floats, programmed: Floats, on: Bools, vector: Floats) -> Guided:
    """Return what the file says: a vector stays until the rotary words change."""
    given: Bools = np.asarray(~np.isnan(vector).all(axis=1))
    if not given.any():
        return Guided(on, programmed[:, :3])
    last = last_of(np.flatnonzero(given), len(given))
    stays = given[last] & (programmed[:, 3:] == programmed[last, 3:]).all(axis=1)
    return Guided(
        on,
        programmed[:, :3],
        np.where(stays[:, None], np.nan_to_num(vector[last]), tool_axes(kinematics, words)),
    )


def _seconds(
    words: Floats, travel: Floats, motion: Bytes, feed: Floats, inverse: Bools, unknown: Bools, on: Bools,
    kinematics: Chain,
    dialect: Dialect | None,
) -> Floats:  # fmt: skip
    """Return the time (m,) s that the controller takes by what the words say (``travel`` (m, 5): their
    change); 0 where nothing."""
    distance = feed_distance(dialect, travel)
    if on.any():
        guide = next(iter(dialect.guides.values()), None) if dialect is not None else None
        over_all = guide is not None and guide.rotary_in_feed
        guided = feed_distance(dialect if over_all else None, travel)
        distance = np.where(on, guided, distance)
    distance = np.where(inverse, 1.0, distance)
    minutes = np.divide(distance, feed, out=np.zeros(len(feed)), where=(feed > 0.0) & ~unknown)
    change = np.diff(words, axis=0, prepend=words[:1])
    change[:, 3:] = np.radians(change[:, 3:])
    seconds: Floats = 60.0 * np.where(motion == Motion.RAPID, rapid_minutes(kinematics, change), minutes)
    seconds[0] = 0.0
    return seconds
