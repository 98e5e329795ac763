# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holes of the drilling cycles, written out as moves.

end       CYCLE/OFF, the next CYCLE, tool or operation, or an arc.
over      Where the axis is that of the row before, the tool first goes along it to the height of the hole's
          ``clear``, or stays at its own where that is higher, then across, then down; as a controller's cycle
          does. To a hole with another axis it goes straight: the CAM system has seen to the way between.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import plural, say
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .cycles import Cycle, cycle_of, set_leaving, way
from .feeds import hold_last, per_minute
from .rows import Put, Rows
from .source import Source
from .statements import Kind, Meaning, Statements, meaning_of

SAME_AXIS = 1e-6
"""rad, in sine, between axes that are one."""
ENDS, OPERATION = ("LOADTL", "LOAD/", "TOOLNO/", "CIRCLE/", "TANGENT/"), "TOOLPATH/"
"""Statements that end a cycle that no ``CYCLE/OFF`` has ended."""
SAME_PLACE = 1e-6
"""mm."""


@dataclass(frozen=True, eq=False)
class Holes:
    """``row`` (h,) of the moves that are holes, ascending; ``group`` (h,) of the CYCLE statement's ``cycles``
    each is drilled by; ``feed`` (h,) mm/min."""

    row: Ints
    group: Ints
    cycles: list[tuple[Cycle, float]]
    feed: Floats


def read_holes(
    source: Source, statements: Statements, rate: Floats, scale: Floats
) -> tuple[Holes, tuple[Finding, ...]]:
    """Return the holes, and what is to be said of them. ``rate`` (n,) mm/min: what FEDRAT says at each row;
    ``scale`` (s,) mm of the unit at each statement. Raises ProgramError for a feed per turn of no spindle."""
    cycle = [
        cycle_of(text[len("CYCLE/") :]) if text.startswith("CYCLE/") else None for text in statements.texts
    ]
    named = np.array(
        [
            text.startswith("CYCLE") and meaning.kind is not Kind.LEAVING
            for text, meaning in zip(statements.texts, statements.meanings, strict=True)
        ]
        or [False]
    )
    drills = np.array([one is not None for one in cycle] or [False])
    ends = np.array([_ends_cycle(text) for text in statements.texts] or [False])
    events = np.flatnonzero((named | ends)[statements.which])
    events = events[~_before_first_hole(statements, events, drills, ends)]
    at = np.append(-1, events)[np.searchsorted(statements.row[events], np.arange(len(rate)), side="right")]
    on = (at >= 0) & drills[statements.which[at]] if len(events) else np.zeros(len(rate), np.bool_)
    plain = source.move_rows(b"GOTO/")
    row = np.flatnonzero(on & plain)
    at = at[row]
    leaving = statements.of(Kind.LEAVING)
    leaves = hold_last(statements.row[leaving], statements.value(leaving), 0.0, row)
    pairs, group = np.unique(np.stack([statements.which[at], scale[at], leaves]), axis=1, return_inverse=True)
    cycles = [
        (set_leaving(one, how), float(mm))
        for which, mm, how in pairs.T
        if (one := cycle[int(which)]) is not None
    ]
    group = group.reshape(-1)
    holes = Holes(row, group, cycles, _feeds(statements, at, group, cycles, rate[row], scale, source))
    found = _findings(source, statements, events, cycle, np.flatnonzero(on & ~plain))
    return holes, (*found, *_without_end(source, statements, events, drills, ends, len(rate)))


def _ends_cycle(text: str) -> bool:
    """Whether a statement ends a drilling cycle that nothing has ended: no hole is drilled by another tool,
    in the next operation, or along an arc."""
    of_tool = text.startswith(ENDS) and meaning_of(text) != Meaning(Kind.NOTHING)
    return of_tool or text.startswith(OPERATION)


def _before_first_hole(statements: Statements, events: Ints, drills: Bools, ends: Bools) -> Bools:
    """Which events (e,) would end a cycle that has drilled nothing yet: they stand right behind it."""
    row, which = statements.row[events], statements.which[events]
    begun = np.concatenate([[-1], row])[
        np.maximum.accumulate(np.where(~ends[which], np.arange(1, len(row) + 1), 0))
    ]
    return np.asarray(ends[which] & (begun == row))


def _without_end(
    source: Source, statements: Statements, events: Ints, drills: Bools, ends: Bools, rows: int
) -> Iterator[Finding]:
    """Yield that drilling cycles end without ``CYCLE/OFF``, where moves follow before the next one."""
    which, row = statements.which[events], statements.row[events]
    moves = np.append(row[1:], rows) > row
    open_ = np.flatnonzero(drills[which][:-1] & ends[which][1:])
    later = np.array(
        [bool(moves[k + 1 : _next_cycle(ends[which], int(k) + 1)].any()) for k in open_], np.bool_
    )
    open_ = open_[later]
    if not len(open_):
        return
    line, end = (int(source.line[statements.statement[events[open_[0] + k]]]) for k in (0, 1))
    text = plural(
        len(open_),
        "A drilling cycle (line {line}) is not ended by CYCLE/OFF: it is taken to end at the next tool, "
        "operation or arc (line {end}), and the moves behind that drill no holes. Say CYCLE/OFF.",
        "{count} drilling cycles (first line {line}) are not ended by CYCLE/OFF: they are taken to end at "
        "the next tool, operation or arc (first line {end}), and the moves behind that drill no holes. Say "
        "CYCLE/OFF.",
        line=line,
        end=end,
    )
    yield report_finding(Code.NO_HOLE_IN_CYCLE, text, float(len(open_)), line=line, severity=Severity.WARNING)


def _next_cycle(ends: Bools, start: int) -> int:
    """Return the first event from ``start`` on that is a CYCLE statement, or the number of all."""
    cycles = np.flatnonzero(~ends[start:])
    return start + int(cycles[0]) if len(cycles) else len(ends)


def _feeds(
    statements: Statements,
    at: Ints,
    group: Ints,
    cycles: list[tuple[Cycle, float]],
    rate: Floats,
    scale: Floats,
    source: Source,
) -> Floats:
    """mm/min (h,): the cycle's own, else that of FEDRAT."""
    own = np.array([(cycle.feed, cycle.unit, cycle.turn) for cycle, _ in cycles]).reshape(-1, 3)[group]
    fed = ~np.isnan(own[:, 0])
    feed = rate.copy()
    value, unit, turn = own[fed].T
    feed[fed] = per_minute(statements, at[fed], value, unit, turn > 0.0, scale, source)
    return feed


def drill_holes(rows: Rows, holes: Holes) -> tuple[Rows, Put]:
    """Return the rows of the moves, those of holes where the tool leaves them; and the rows to be put in
    before: over, and down."""
    if not len(holes.row):
        return rows, Put.none()
    point, axis = rows.tip[holes.row], rows.axis[holes.row]
    out = _heights_out(rows, holes, point, axis)
    tip, motion, speed = rows.tip.copy(), rows.motion.copy(), rows.speed.copy()
    tip[holes.row] = point + out[:, None] * axis
    fed_out = np.array([cycle.fed_out and cycle.out is None for cycle, _ in holes.cycles])[holes.group]
    motion[holes.row] = np.where(fed_out, Motion.CUT, Motion.RAPID)
    speed[holes.row] = np.where(fed_out, holes.feed, 0.0)
    left = replace(rows, tip=tip, motion=motion, speed=speed)
    return left, Put.join([_over(left, holes, point, axis), *_ways(holes, point, axis)])


def _clear(holes: Holes) -> Floats:
    return np.array([cycle.clear * scale for cycle, scale in holes.cycles])[holes.group]


def _heights_out(rows: Rows, holes: Holes, point: Floats, axis: Floats) -> Floats:
    """mm (h,) above the point: where the tool leaves each hole, never below its clear."""
    clear = _clear(holes)
    height = np.array([cycle.clear if cycle.out is None else cycle.out for cycle, _ in holes.cycles])
    height = (height * [scale for _, scale in holes.cycles])[holes.group]
    stands = np.arange(len(rows.tip))
    stands[holes.row] = -1
    stands = np.maximum.accumulate(stands)[holes.row]
    before = np.where(stands >= 0, ((rows.tip[stands] - point) * axis).sum(axis=1), -np.inf)
    return np.maximum(clear, np.where(np.isnan(height), before, height))


def _over(left: Rows, holes: Holes, point: Floats, axis: Floats) -> Put:
    """Up along the axis before the way across, or across before the way down."""
    clear, before = _clear(holes), np.maximum(holes.row - 1, 0)
    apart = left.tip[before] - point
    height = (apart * axis).sum(axis=1)
    aside = np.linalg.norm(apart - height[:, None] * axis, axis=1) > SAME_PLACE
    one = np.linalg.norm(left.axis[before] - axis, axis=1) <= SAME_AXIS
    needed = (holes.row > 0) & one & aside & (np.abs(height - clear) > SAME_PLACE)
    up = left.tip[before] + (clear - height)[:, None] * axis
    across = point + height[:, None] * axis
    place = np.where((height < clear)[:, None], up, across)[needed]
    return Put.rapids(holes.row[needed], place, axis[needed])


def _ways(holes: Holes, point: Floats, axis: Floats) -> Iterator[Put]:
    """Down each hole and, between its pecks, out; one Put for each cycle."""
    for k, (cycle, scale) in enumerate(holes.cycles):
        mine = np.flatnonzero(holes.group == k)
        height, fed = np.array(way(cycle, scale)).T
        of = np.repeat(mine, len(height))
        height, feeding = np.tile(height, len(mine)), np.tile(fed > 0.0, len(mine))
        motion = np.where(feeding, Motion.CUT, Motion.RAPID).astype(np.int8)
        speed = np.where(feeding, holes.feed[of], 0.0)
        yield Put(holes.row[of], point[of] + height[:, None] * axis[of], axis[of], motion, speed)


def _findings(
    source: Source, statements: Statements, events: Ints, cycle: list[Cycle | None], others: Ints
) -> Iterator[Finding]:
    def where(of: list[bool]) -> Ints:
        return statements.statement[events[np.array(of)[statements.which[events]]]] if len(events) else events

    whole = where([one is not None and bool(one.chips) and not one.steps for one in cycle])
    if len(whole):
        line = int(source.line[whole[0]])
        text = plural(
            len(whole),
            "A drilling cycle with pecks says no STEP (line {line}): its holes are drilled in one go. Say "
            "the step, if the chips are to come out.",
            "{count} drilling cycles with pecks say no STEP (first line {line}): their holes are drilled in "
            "one go. Say the step, if the chips are to come out.",
            line=line,
        )
        yield report_finding(Code.CYCLE_STEP_NOT_SAID, text, float(len(whole)), line=line)
    dwells = where([one is not None and one.dwell > 0.0 for one in cycle])
    if len(dwells):
        line = int(source.line[dwells[0]])
        text = plural(
            len(dwells),
            "A drilling cycle dwells at the bottom (line {line}): the tool does not wait there in the "
            "program.",
            "{count} drilling cycles dwell at the bottom (first line {line}): the tool does not wait there "
            "in the program.",
            line=line,
        )
        yield report_finding(Code.CYCLE_DWELL_LEFT_OUT, text, float(len(dwells)), line=line)
    if len(others):
        line = int(source.line[source.move_at[others[0]]])
        text = say(
            "A step or FROM stands within a drilling cycle (line {line}): no hole is drilled there. Say "
            "CYCLE/OFF before.",
            line=line,
        )
        yield report_finding(Code.NO_HOLE_IN_CYCLE, text, float(len(others)), line=line)


def with_feeds(rows: Rows, holes: Holes) -> tuple[Floats, Bools]:
    """Return the feed mm/min (n,) that each move needs, and which moves need one, holes among them."""
    speed, needs = rows.speed.copy(), rows.motion != Motion.RAPID
    speed[holes.row] = holes.feed
    needs[holes.row] = True
    return speed, needs
