# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is in force in each line, and which lines are blocks."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine.kinematics import Chain

from . import codes
from .codes import INCH, Grammar
from .dynamic_offset import find_offset_planes
from .kinematics_switch import find_switches, switch_findings
from .lines import Lines, last_of
from .noted import kind_findings
from .planes import Planes, planes_of
from .positions import ABSOLUTE, STEP, AxisWords, MotionLines, absolute_anyway, axis_words
from .source import Source
from .turning import turn_into_planes

VECTOR_NAMES = {"heidenhain": "TX TY TZ", "siemens": "A3= B3= C3="}


@dataclass(frozen=True, eq=False)
class LineState:
    """One row a line, (lines,): ``axes``: the word of each axis, and how it is meant; ``mode`` of motion;
    ``on``: whether the controller guides the tip; ``planes``: the tilted ones, None where there are none."""

    axes: AxisWords
    mode: Ints
    on: Bools
    planes: Planes | None


def find_line_states(source: Source, kinematics: Chain) -> tuple[LineState, tuple[Finding, ...]]:
    """Return what is in force in each line, and the findings of switches and of planes."""
    lines, grammar = source.lines, source.grammar
    axes = [axis_words(lines, letter) for letter in kinematics.letters]
    mode, on = lines.mode(grammar.motion, codes.NONE), _guide_on(lines, grammar)
    dynamic, reports = find_offset_planes(lines, axes, on, kinematics, grammar)
    findings = (*reports, *switch_findings(lines, grammar), *_name_idle_vectors(lines, on, grammar))
    planes = planes_of(lines, grammar, kinematics, dynamic)
    if planes is not None:
        mode, on = planes.modes(mode, on)
    return LineState(axes, mode, on, planes), findings


def _name_idle_vectors(lines: Lines, on: Bools, grammar: Grammar) -> list[Finding]:
    """Report tool vectors in lines where the controller does not guide the tip."""
    name = VECTOR_NAMES.get(grammar.name)
    if name is None or not any(letter in lines.letters for letter in codes.VECTOR):
        return []
    row = np.flatnonzero(~np.isnan(lines.columns(codes.VECTOR)).all(axis=1) & ~on)
    if not len(row):
        return []
    line = int(lines.words.in_file(row[:1])[0])
    return [
        replace(found, line=int(row[0]))
        for found in kind_findings(codes.IDLE_VECTOR, {name: (line, len(row))})
    ]


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


def find_motion_lines(
    source: Source, state: LineState, kinematics: Chain
) -> tuple[MotionLines, tuple[Finding, ...]]:
    """Return the lines that are blocks, those of a safe start too, and the findings of turning lines. Raises
    ProgramError where there are none."""
    at = _find_moving(source, state)
    if not len(at):
        raise _no_motion(source.findings, kinematics.letters)
    mode, on, vector = state.mode[at], state.on[at], np.full((len(at), 3), np.nan)
    if state.on.any():
        vector = _tool_vectors(source.lines, state)[at]
    words = _convert_words(source, state.axes, at, kinematics.letters)
    if state.planes is None:
        return MotionLines(at, words, mode, on, vector, on.astype(np.int64)), ()
    turned = turn_into_planes(kinematics, words, at, state.planes)
    meaning = state.planes.of_blocks(at, on, turned.words)
    vector = state.planes.vectors_in_work(vector, meaning)
    return MotionLines(at, turned.words, mode, on, vector, meaning), turned.findings


def _find_moving(source: Source, state: LineState) -> Ints:
    """Return the lines that are blocks."""
    lines, mode, grammar = source.lines, state.mode, source.grammar
    moving = np.logical_or.reduce([kind != 0 for _, kind in state.axes])
    if state.on.any():
        moving |= ~np.isnan(_tool_vectors(lines, state)).all(axis=1)
    if codes.ANGLE in lines.letters:
        moving |= ~np.isnan(lines.column(codes.ANGLE)) & np.isin(mode, (codes.RAPID, codes.STRAIGHT))
    if (mode == codes.ARC).any():  # a full circle needs no word of an axis
        moving |= (mode == codes.ARC) & ~np.isnan(lines.columns("IJK")).all(axis=1)
    moving &= ~lines.any_of(grammar.no_move) & (mode != codes.CYCLE)
    moving[lines.m_line(grammar.machine_m)] = False
    if codes.MACHINE in lines.letters:
        moving &= np.isnan(lines.column(codes.MACHINE))
    if state.planes is not None:
        moving[list(state.planes.turning)] = True
    return np.flatnonzero(moving)


def _no_motion(before: tuple[Finding, ...], letters: str) -> ProgramError:
    """Return the error of a text without a motion line: where all stands in what is not interpreted, that is
    the cause."""
    lost = next((found for found in before if found.code == codes.MACRO[0]), None)
    if lost is None:
        text = say("the file holds no motion blocks: no axis word of this machine under G0 or G1")
    else:
        text = say(
            "all moves stand in variables, expressions or jumps, which are not interpreted; line {line}: "
            "{text}",
            line=lost.line or 0,
            text=lost.text,
        )
    return ProgramError(text, letters)


def _tool_vectors(lines: Lines, state: LineState) -> Floats:
    """Return the tool axis (lines, 3) that each guided line gives as a vector, NaN where none."""
    vector = np.where(state.on[:, None], lines.columns(codes.VECTOR), np.nan)
    if not np.isin(lines.code, codes.VECTORS_ON).any():
        return vector
    group = {**dict.fromkeys((*codes.GUIDE_ON, *codes.GUIDE_OFF), 0), **dict.fromkeys(codes.VECTORS_ON, 1)}
    by_ijk = (lines.mode(group, 0) == 1) & (state.mode != codes.ARC) & state.on
    return np.where(by_ijk[:, None], lines.columns("IJK"), vector)


def _convert_words(source: Source, axes: AxisWords, at: Ints, letters: str) -> AxisWords:
    """Return the words of the motion lines in mm and degrees, and how each is meant."""
    lines = source.lines
    steps = lines.mode(codes.DISTANCE, 0)[at] == 1
    inch = lines.inch(source.grammar)[at]
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
