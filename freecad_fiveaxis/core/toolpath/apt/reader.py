# SPDX-License-Identifier: LGPL-2.1-or-later
"""CL files read, from any CAM system: the path, and what else they say.

row       one of the path for each GOTO, GODLTA and FROM (a rapid).
RAPID     the next move alone is a rapid.            FEDRAT/   the feed of those that follow, per minute, or
          per turn of SPINDL.
UNITS/    the unit of all numbers from there on; before it that of the reading, mm if nobody says.
CIRCLE/   the next move is an arc: one row for each of its chords.
CYCLE/    each GOTO until CYCLE/OFF is a hole: one row for each of its moves.

Nothing is passed over in silence: what is not interpreted is a finding with its count and its lines.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .arc_reading import chords
from .feeds import hold_last, read_feeds
from .findings import find_poor_spots, units_findings
from .head import ClHead
from .holes import drill_holes, read_holes, with_feeds
from .poses import Moves, places, read_moves
from .reading import ClReading
from .rows import Put, Rows
from .source import Source
from .statements import Kind, Statements, head_of, read_statements
from .tools import only, tool_findings, tools_of

USUAL = ClReading()


@dataclass(frozen=True, eq=False)
class ClFile:
    """A CL file: its path, what it says of tool, spindle, coolant and cutter, and the numbers of its tools in
    the order of their moves; none where it names none."""

    path: CLPath
    head: ClHead
    tools: tuple[int, ...] = ()


def read_apt(text: bytes | str, reading: ClReading = USUAL, progress: Progress = silent) -> CLPath:
    """Return the CLPath of an APT text: a row for each move, and for each chord of an arc; ``reading``: what
    the file does not say.

    The contact is the tip and the normal the axis; face and co-edge are -1; ``pass_`` counts the runs of
    cutting moves. A move of three numbers keeps the axis (0, 0, 1 at first). Raises ProgramError, naming line
    and column.
    """
    return read_cl_file(text, reading, progress).path


def read_cl_file(text: bytes | str, reading: ClReading = USUAL, progress: Progress = silent) -> ClFile:
    """Return the path of an APT text as ``read_apt`` gives it, and its head."""
    progress("reading CL", 0.0)
    source = Source(text.encode("utf-8") if isinstance(text, str) else text)
    progress("reading CL", 0.3)
    statements = read_statements(source)
    moves, tools = _moves(source, statements), tools_of(source, statements)
    if reading.tool is not None:
        kept = only(source, statements, tools, reading.tool)
        moves, source = moves.take(kept[source.move_at]), source.take(kept)
        statements = read_statements(source)
    progress("reading CL", 0.8)
    units = statements.of(Kind.UNITS)
    scale = hold_last(
        statements.statement[units], statements.value(units), reading.scale, np.arange(len(source.begin))
    )
    path = _path(source, statements, moves, scale, reading)
    reports = units_findings(source, statements, reading.units) + tool_findings(tools, reading.tool)
    return ClFile(
        replace(path, findings=path.findings + reports),
        head_of(statements, scale[statements.statement]),
        tuple(tools.names),
    )


def _path(source: Source, statements: Statements, moves: Moves, scale: Floats, reading: ClReading) -> CLPath:
    """Return the path of the moves; ``scale`` (s,) mm of the unit at each statement."""
    length = _lengths(moves.axis, source, statements)
    axis, mm = moves.axis / length[:, None], scale[source.move_at]
    tip, motion = places(moves, axis, mm, source), _motion(source, statements, len(length))
    scale = scale[statements.statement]
    at, rate = read_feeds(statements, scale, source)
    rated = hold_last(statements.row[at], rate, reading.feed, np.arange(len(length)))
    each = Rows(tip, axis, motion, np.where(motion == Motion.RAPID, 0.0, rated))
    holes, of_holes = read_holes(source, statements, rated, scale)
    findings = find_poor_spots(source, statements, moves, length, *with_feeds(each, holes)) + of_holes
    with np.errstate(over="ignore", invalid="ignore"):  # rows beyond all bounds fit no arc
        each, drilling = drill_holes(each, holes)
        turning, of_arcs = chords(source, statements, each, mm, reading.chord, holes.row)
    located = each.with_put(Put.join([drilling, turning]))
    none, runs = np.full(len(located.tip), -1), _runs(located.motion)
    return CLPath(
        located.tip,
        located.axis,
        located.motion,
        located.speed,
        located.tip,
        located.axis,
        none,
        none,
        runs,
        findings + of_arcs,
    )


def _moves(source: Source, statements: Statements) -> Moves:
    axes = statements.of(Kind.AXIS)
    turned = np.array([statements.meanings[which].more for which in statements.which[axes]]).reshape(-1, 3)
    return read_moves(source, statements.statement[axes], turned)


def _motion(source: Source, statements: Statements, rows: int) -> Bytes:
    links = statements.of(Kind.LINK)
    link = hold_last(statements.row[links], statements.value(links), 0.0, np.arange(rows)) > 0.0
    rapid = source.move_rows(b"FROM/")
    one_shot = statements.row[statements.of(Kind.RAPID)]
    rapid[one_shot[one_shot < rows]] = True
    return np.where(rapid, Motion.RAPID, np.where(link, Motion.LINK, Motion.CUT)).astype(np.int8)


def _lengths(axis: Floats, source: Source, statements: Statements) -> Floats:
    with np.errstate(over="ignore"):
        length: Floats = np.linalg.norm(axis, axis=1)
    wrong: Bools = ~((length > 0.0) & (length < np.inf))
    if wrong.any():
        source.fail(
            int(source.move_at[wrong.argmax()]), "", say("the tool axis is 0, 0, 0, or beyond all bounds")
        )
    return length


def _runs(motion: Bytes) -> Ints:
    """Count the runs of cutting moves; -1 in the others."""
    cut = motion == Motion.CUT
    begins = cut & ~np.concatenate([[False], cut[:-1]])
    return np.where(cut, np.cumsum(begins) - 1, -1)
