# SPDX-License-Identifier: LGPL-2.1-or-later
"""What follows a move to a machine position: until every axis that it drove has a word again, nobody knows
where the tool is.

gap       the rapids of that stretch: no blocks, as those of a safe start. The first line after it is a block
          to whose end the way is not known (``Program.unknown_way``).
feeding   a stretch in which something feeds is no safe way back from the machine's position: its lines stay
          blocks, with the words that they had before, which is an error: the tool is elsewhere.
retract   Heidenhain's M140 draws the tool back along its axis, to the end of the travel (MB MAX) or so far
          (MB 50), at the start of its block (TNC 640, Klartext Programming, retraction in the tool axis): the
          block's own words lead from there. It drives Z alone where X Y Z are those of the axes and the tool
          lies along Z, else X, Y and Z.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Bytes, Ints, take_rows
from freecad_fiveaxis.core.base.sentences import plural
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Guided, Program

from . import codes
from .planes import JOINTS
from .positions import ABSOLUTE, NOTHING, SHORTER, AxisWords, Moves, tool_axes
from .source import Source

ALL_AXES = (280, 281, 300, 301, 740, 750)
"""Codes that drive all axes where their line names none: G28, G30 and Siemens' G74, G75; G53, M91 and SUPA
drive what their line names alone."""
UPRIGHT = 1e-9
"""How far a tool that lies along Z may leave it, as a sine."""


class Gaps(NamedTuple):
    """Of the motion lines (m,): those that are in a gap, and those to whose end the way is not known.
    ``feeding`` (m, 5): the axes from whose unknown places a line feeds."""

    inside: Bools
    after: Bools
    feeding: Bools


def find_gaps(source: Source, motions: Moves, axes: AxisWords, kinematics: Chain) -> Gaps:
    """Find the gaps among the motion lines (m,); ``axes``: the five words in each line of the source and how
    they are meant."""
    at, kind = motions.at, np.column_stack([kind for _, kind in axes])
    retracts = _find_retracts(source, int(at[0]))
    driven = _find_driven(source, kind, int(at[0])) | _find_drawn(retracts, motions, kinematics, len(kind))
    if not driven.any():
        none = np.zeros(len(at), np.bool_)
        return Gaps(none, none, np.zeros_like(kind[at], np.bool_))
    given = np.zeros_like(driven)
    given[at] = np.isin(kind[at], (ABSOLUTE, SHORTER))
    given[at, 3:] |= ~np.isnan(motions.vector).all(axis=1, keepdims=True)
    line = np.arange(len(driven))[:, None]
    left, back = (np.maximum.accumulate(np.where(rows, line, -1), axis=0)[at] for rows in (driven, given))
    lost: Bools = np.asarray((left > back).any(axis=1))
    before = np.concatenate([at[:1], at[:-1]])
    fresh: Bools = np.asarray((left > before[:, None]).any(axis=1))
    fresh |= np.concatenate([[False], lost[:-1]])
    rapid = (motions.mode == codes.RAPID) | np.isin(at, retracts)
    unknown: Bools = np.asarray(left > np.concatenate([np.full_like(back[:1], -1), back[:-1]]))
    return Gaps(*_without_feeds(lost, fresh, rapid), unknown & ~rapid[:, None])


def feed_findings(gaps: Gaps, motions: Moves, letters: str) -> list[Finding]:
    """Report the lines that feed while an axis is where the machine alone knows."""
    rows = np.flatnonzero(gaps.feeding.any(axis=1))
    if not len(rows):
        return []
    axes = ", ".join(letter for letter, one in zip(letters, gaps.feeding[rows[0]], strict=True) if one)
    text = plural(
        len(rows),
        "1 block feeds after a move to a machine position, before {axes} has a word again in a rapid move: "
        "it is taken from where the axis stood before. Give {axes} first.",
        "{count} blocks feed after a move to a machine position, before {axes} has a word again in a rapid "
        "move: they are taken from where the axis stood before. Give {axes} first.",
        axes=axes,
    )
    line = int(motions.at[rows[0]])
    return [report_finding(Code.FEED_FROM_MACHINE_POSITION, text, float(len(rows)), line=line)]


def _find_driven(source: Source, kind: Bytes, first: int) -> Bools:
    """Whether each line (lines, 5) drives an axis to a machine position: those that it names, or of
    :data:`ALL_AXES` all that the program names anywhere (others are taken as 0 from begin to end), after the
    line ``first`` of the first block."""
    lines, grammar = source.lines, source.grammar
    going = lines.any_of(code for code, meant in grammar.codes.items() if meant is codes.HOME)
    going[lines.m_line(grammar.machine_m)] = True
    if codes.MACHINE in lines.letters:
        going |= ~np.isnan(lines.column(codes.MACHINE))
    going[: first + 1] = False
    named: Bools = kind != NOTHING
    whole = lines.any_of(ALL_AXES) & ~named.any(axis=1)
    return going[:, None] & (named | whole[:, None] & named.any(axis=0))


def _find_retracts(source: Source, first: int) -> Ints:
    """Return the lines with an M140 after the line ``first``."""
    if source.grammar.name != "heidenhain":
        return np.empty(0, np.int64)
    at = source.lines.m_line((codes.RETRACT_M,))
    return at[at > first]


def _find_drawn(retracts: Ints, motions: Moves, kinematics: Chain, count: int) -> Bools:
    """Return the axes (count, 5) that these lines drive back along the tool, from where the motion line
    before leaves it."""
    drawn = np.zeros((count, 5), np.bool_)
    row = np.searchsorted(motions.at, retracts) - 1
    across = np.abs(tool_axes(kinematics, motions.programmed[row])[:, :2]).max(axis=1, initial=0.0)
    upright = (motions.meaning[row] == JOINTS) & ~motions.on[row] & (across < UPRIGHT)
    drawn[retracts, 2] = True
    drawn[retracts, :2] = ~upright[:, None]
    return drawn


def _without_feeds(lost: Bools, fresh: Bools, rapid: Bools) -> tuple[Bools, Bools]:
    """Return the gaps, but those in which, or from which, something feeds. A gap goes from where the machine
    leaves to where all its axes are known again."""
    touched = lost | fresh
    group = np.cumsum(fresh & ~np.concatenate([[False], lost[:-1]]))
    feeding = np.zeros(int(group[-1]) + 1, np.bool_)
    feeding[group[touched & ~rapid]] = True
    kept = ~feeding[group]
    return lost & kept, fresh & ~lost & kept


def leave_out_gaps(program: Program, gaps: Gaps, row: Ints | slice) -> Program:
    """Return the program without the blocks of the gaps; ``row`` (n,): the motion line of each block."""
    if not (gaps.inside | gaps.after).any():
        return program
    keep, unknown = np.flatnonzero(~gaps.inside[row]), gaps.after[row][~gaps.inside[row]]
    seconds = np.where(unknown, 0.0, program.seconds[keep])
    guided = program.guided
    if guided is not None:
        vector = None if guided.vector is None else guided.vector[keep]
        guided = Guided(guided.on[keep], guided.tip[keep], vector)
    names = ("feed", "inverse_time", "motion", "row", "line")
    columns = {name: getattr(program, name)[keep] for name in names}
    words = take_rows(program.words, keep)
    return replace(program, words=words, seconds=seconds, guided=guided, unknown_way=unknown, **columns)
