# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shifts of the zero along X, Y and Z, put into the words: G52, CYCL DEF 7, TRANS DATUM AXIS, TRANS, ATRANS.

Fanuc       G52: of the axes that it names; under a tilted plane it stands before the plane's own zero.
Heidenhain  of the axes that the line names, I (in DIN/ISO, G54: G91) for on from where the zero is. One
            before a tilted plane moves the system in which the plane lies; one within a plane counts in the
            plane.
Siemens     TRANS: of all axes, those that it does not name by 0; ATRANS: on from where the zero is. CYCLE800
            ends both.

Sources: Fanuc B-63324EN, 7.2.5 (local coordinate system); LinuxCNC 2.9, G52, moved as its ``rs274`` moves;
Heidenhain TNC 620, datum shift (cycle 7) and tilting; Siemens 840D sl, Programming Manual Fundamentals (frame
instructions), 6FC5398-7CP41, 10.6. Not looked up in a manual: which shift a TNC resets within a plane; it is
named where a plane ends with a shift in it and moves follow.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from . import codes
from .arcs import AXES
from .codes import Grammar
from .findings import shift_finding
from .lines import Lines, last_of
from .plane_calls import FANUC, HEIDENHAIN, SIEMENS, TURN, Tilt
from .planes import tilts_of
from .positions import ABSOLUTE, STEP, axis_words
from .siemens_frames import ROTATED, replace_frames
from .words import Words

NONE, NAMED, WHOLE, ON = 0, 1, 2, 3
"""What a line with a shift does (:data:`.codes.SHIFTED`)."""
NAMES = {"iso": "G52", "siemens": "TRANS", "heidenhain": "CYCL DEF 7, TRANS DATUM, G54"}

LEFT = say("a tilted plane ends with a shift in it, and moves follow; reset the shift first")


@dataclass(eq=False)
class _Zero:
    """Where the zero is, mm: ``base`` of the untilted system, ``own`` in the plane that is on (``tilted``);
    ``left`` (3,): the axes whose shift in a plane ended with the plane in line ``end``, and was not told
    again. ``framed``: no plane, but coordinates that stand on ``base`` (:mod:`.heidenhain_frames`)."""

    base: Floats = field(default_factory=lambda: np.zeros(3))
    own: Floats = field(default_factory=lambda: np.zeros(3))
    tilted: bool = False
    framed: bool = False
    left: Bools = field(default_factory=lambda: np.zeros(3, np.bool_))
    end: int = 0


@dataclass(eq=False)
class _Table:
    """The shifts of a program by line: ``kind`` NaN where the line is none; ``value``, ``meant`` (lines, 3):
    its words, mm, and how they are meant; ``rotary``: it names a rotary axis by other than 0."""

    kind: Floats
    value: Floats
    meant: Bytes
    rotary: Bools


def shift_words(words: Words, lines: Lines, grammar: Grammar) -> tuple[Words, list[Finding]]:
    """Return the words with all shifts put into them, those of the shifts themselves left out. Without any,
    the same object."""
    kind = find_shift_lines(lines, grammar)
    if np.isnan(kind).all():
        return words, []
    if (kind >= ROTATED).any():
        return replace_frames(words, lines, grammar, kind)
    table, tilts = _table(lines, grammar, kind), tilts_of(lines, grammar)
    zero, at, states, origins, findings = _Zero(), [0], [np.zeros(3)], dict[int, Floats](), list[Finding]()
    moving = np.flatnonzero((table.meant != 0).any(axis=1) & np.isnan(kind) & ~lines.any_of(grammar.no_move))
    for row in sorted({*np.flatnonzero(~np.isnan(kind)).tolist(), *tilts}):
        findings += _report_moving_zero(zero, moving, row, grammar)
        if row in tilts:
            _tilt_zero(zero, tilts[row], row)
        if (
            (row not in tilts or zero.framed)
            and not np.isnan(kind[row])
            and (reason := _shift_zero(zero, table, row, grammar))
        ):
            findings.append(shift_finding(NAMES[grammar.name], reason, row))
        if row in tilts and zero.base.any() and grammar.name != "siemens":
            origins[row] = zero.base
        at.append(row)
        states.append(zero.own if zero.tilted else zero.base)
    findings += _report_moving_zero(zero, moving, lines.count, grammar)
    shift = np.array(states)[np.searchsorted(at, last_of(np.array(at[1:]), lines.count))]
    return _put(words, lines, grammar, shift, np.asarray(~np.isnan(kind)), origins), findings


def _report_moving_zero(zero: _Zero, moving: Ints, row: int, grammar: Grammar) -> list[Finding]:
    """Report that lines before ``row`` move by a zero that only the control knows."""
    if not zero.left.any() or np.searchsorted(moving, zero.end) == np.searchsorted(moving, row):
        return []
    zero.left = np.zeros(3, np.bool_)
    return [shift_finding(NAMES[grammar.name], LEFT, zero.end)]


def find_shift_lines(lines: Lines, grammar: Grammar) -> Floats:
    """Return what each line (lines,) does to the zero, NaN where nothing."""
    kind = lines.column(codes.SHIFTED)
    code = {"iso": codes.LOCAL, "heidenhain": codes.DATUM}.get(grammar.name)
    return kind if code is None else np.where(lines.any_of((code,)), float(NAMED), kind)


def _table(lines: Lines, grammar: Grammar, kind: Floats) -> _Table:
    scale = lines.unit(grammar)
    axes = [axis_words(lines, letter) for letter in "XYZ"]
    rotary = [axis_words(lines, letter)[0] for letter in "ABC"]
    on = (lines.mode(codes.DISTANCE, 0) == 1) & (grammar.name == "heidenhain")
    return _Table(
        kind,
        np.stack([value * scale for value, _ in axes], axis=1),
        np.stack([np.where(on & (meant == ABSOLUTE), STEP, meant) for _, meant in axes], axis=1),
        np.logical_or.reduce([np.nan_to_num(value) != 0.0 for value in rotary]),
    )


def _tilt_zero(zero: _Zero, tilt: Tilt, row: int) -> None:
    """Shift the zero by what a line of a tilted plane makes of it."""
    if tilt.refused or (tilt.rule == FANUC and tilt.move == TURN):
        return
    if tilt.rule == SIEMENS:
        zero.base = np.zeros(3)
    if zero.own.any() and (tilt.relative or tilt.rule != SIEMENS):
        zero.left, zero.end = zero.own != 0.0, row
    zero.tilted, zero.own = tilt.turn is not None, np.zeros(3)
    zero.framed = zero.tilted and tilt.frame and tilt.rule == HEIDENHAIN


def _shift_zero(zero: _Zero, table: _Table, row: int, grammar: Grammar) -> str:
    """Return what a line with a shift makes of the zero; why that is not known."""
    if zero.tilted and grammar.name == "iso":
        return say("it stands in a tilted plane")
    if table.rotary[row]:
        return say("it shifts a rotary axis")
    in_plane = zero.tilted and not zero.framed
    before = zero.own if in_plane else zero.base
    kind, named = int(table.kind[row]), table.meant[row] != 0
    on = named & (table.meant[row] != ABSOLUTE) if kind != ON else named
    value = np.where(named, np.nan_to_num(table.value[row]), 0.0)
    zero.left = zero.left & ~(named | (kind in (NONE, WHOLE)))
    after = np.where(on, before + value, np.where(named | (kind in (NONE, WHOLE)), value, before))
    if in_plane:
        zero.own = after
    else:
        zero.base = after
    return ""


def _put(
    words: Words, lines: Lines, grammar: Grammar, shift: Floats, own: Bools, origins: dict[int, Floats]
) -> Words:
    """Return the words with ``shift`` (lines, 3) mm on those that it moves, and ``origins`` in the lines of
    planes."""
    shift = shift / lines.unit(grammar)[:, None]
    value, line, letter = words.value.copy(), words.line, words.letter
    shift[lines.any_of(grammar.no_move) | own] = 0.0
    shift[lines.m_line(grammar.machine_m)] = 0.0
    if codes.MACHINE in lines.letters:
        shift[~np.isnan(lines.column(codes.MACHINE))] = 0.0
    moved = np.where((lines.mode(codes.DISTANCE, 0) == 1)[:, None], 0.0, shift)
    motion = lines.mode(grammar.motion, codes.NONE)
    cycles, absolute = motion == codes.CYCLE, (motion == codes.ARC) & (lines.mode(codes.CENTRES, 0) == 1)
    along = np.take_along_axis(moved, AXES[lines.mode(codes.PLANES, 0), 2:], axis=1)[:, 0]
    for letters, how in (
        ("XYZ", moved),
        (codes.CENTRE, shift),
        ("IJK", np.where(absolute[:, None], shift, 0.0)),
    ):
        for k, one in enumerate(letters):
            chosen = letter == ord(one)
            value[chosen] += how[line[chosen], k]
    if cycles.any():
        chosen = (letter == ord("R")) & cycles[line]
        value[chosen] += along[line[chosen]]
    gone = own[line] & np.isin(letter, [ord(one) for one in SHIFT_LETTERS])
    return _with_origins(replace(words, value=value), ~gone, origins)


SHIFT_LETTERS = codes.SHIFTED + "XYZABC" + "".join(codes.STEP_OF.values())


def _with_origins(words: Words, keep: Bools, origins: dict[int, Floats]) -> Words:
    row = np.repeat(np.array(list(origins), np.int64), 3)
    value = np.array(list(origins.values()), float).reshape(-1)
    letter = np.array([ord(one) for one in codes.ORIGIN] * len(origins), np.int8)
    line = np.concatenate([words.line[keep], row])
    order: Ints = np.argsort(line, kind="stable")
    start = None if words.start is None else np.concatenate([words.start[keep], np.full(len(row), -1)])[order]
    return replace(
        words,
        letter=np.concatenate([words.letter[keep], letter])[order],
        value=np.concatenate([words.value[keep], value])[order],
        line=line[order],
        start=start,
    )
