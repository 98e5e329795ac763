# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a posted program leaves the CL path that it was made from.

CL line      the straight lines from row to row of the CL file, rapids included: a post may make feed moves of
             them.
off          the distance of the real tip, or of the centre of a ball that is known, from the nearest place of
             the CL line of the same point, at its largest in each feed block.
missed row   a row of the CL file, reached at feed, that no feed block comes near: a pass that is not cut.
axis off     the angle between the tool axis at a block's end and that of the CL path at the nearest place; of
             several places that are as near (passes that cross, the tool turning on the spot) the one that
             suits best counts.

**Proof.** The distance from one straight line is convex: between two places on a chord it is at most the
larger end value, and the real tip is within ``bend / 8`` of the chord. This serves for blocks along one CL
line, its neighbours included; otherwise the distance of the nearest line changes by no more than the way:
``(d0 + d1 + way) / 2``.

The order in which the rows are visited is not compared. A block that is set over to the next pass lies on the
CL line there; the row that it should have reached is then a missed row.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.columns import cache_chunks
from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, freeze, number_runs
from freecad_fiveaxis.core.base.sentences import Angle, Choice, Length, Option, Sentence, Task, plural, say
from freecad_fiveaxis.core.base.vectors import slerp
from freecad_fiveaxis.core.geometry.nearest import Pieces, Segments, nearest, search
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.deviation import Deviation
from freecad_fiveaxis.core.motion.program import Program, feed_blocks
from freecad_fiveaxis.core.motion.trajectory import axis_at
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .real_path import Ends, Peaks, RealPath, peaks

SHARE = 0.1
"""Of the tolerance: how much of it the chords may cost by which the real path is replaced for the missed
rows."""
ROUGH = 50.0
"""A place that is so many reaches of a piece (some 12 mean lines) off is known to a tenth of its distance, no
better."""
MOST_CHORDS = 64
"""For one block."""
TIED = 16
"""Places that are compared for the axis."""
ROUNDED = 1e-3
"""mm by which the same place may differ in two blocks."""
ALL_ALIKE = 0.9
"""Share of the blocks' ends that are off, from which it is no single slip but the machine or the zero."""


@dataclass(frozen=True, eq=False)
class AgainstPath:
    """``block`` (n,) the feed blocks, rows of the Program; ``off`` (n,) mm the largest distance from the CL
    line, at ``u`` (n,) and ``place`` (n, 3); ``bound`` (n,) proven; ``end`` (n,) mm that of the block's end;
    ``axis`` (n,) rad at the end. ``missed`` (k,) rows of the CL file, ``distance`` (k,) mm of the nearest
    feed block from each."""

    block: Ints
    off: Floats
    u: Floats
    place: Floats
    bound: Floats
    end: Floats
    axis: Floats
    missed: Ints
    distance: Floats
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, None, block="i", off="f", u="f", place="f3", bound="f", end="f", axis="f")
        freeze(self, None, missed="i", distance="f")


def against_path(
    kinematics: Chain, program: Program, deviation: Deviation, path: CLPath, tolerance: float,
    axis_tolerance: float,
    progress: Progress = silent, above: float = 0.0,
) -> AgainstPath:  # fmt: skip
    """Return the program against the CL path. ``tolerance`` mm, ``axis_tolerance`` rad; ``above`` mm:
    compared is the point so far over the tip, with the same point of the CL path (of a ball the centre).
    Raises ProgramError for a path of one row."""
    if len(path.tip) < 2:
        raise ProgramError(
            say("the CL file holds fewer than two rows: there is no path to compare with"), len(path.tip)
        )
    given, path = path, replace(path, tip=path.tip + above * path.axis)
    lines = Segments(path.tip[:-1], path.tip[1:])
    pieces, rows, real = lines.pieces(), feed_blocks(program), RealPath(kinematics, program, above)

    def measure(place: Floats) -> Floats:
        return search(place, pieces, lines.square_distances, nearest, 2, ROUGH, progress)

    found = (
        peaks(real, rows, measure, _bound_distance(lines), tolerance, progress)
        if len(rows)
        else Peaks(np.zeros(0), np.zeros(0), np.zeros((0, 3)), np.zeros(0))
    )
    ends, ones = real.places(rows, np.ones(len(rows))), np.ones(len(rows))
    stands = (
        axis_at(kinematics, program.words[rows - 1], program.words[rows], ones)
        if len(rows)
        else np.zeros((0, 3))
    )
    at_end = _at_ends(path, lines, pieces, ends, stands, tolerance, progress)
    missed, distance = _find_missed(real, rows, deviation, path, tolerance, progress)
    against = AgainstPath(
        rows, found.value, found.u, found.place, found.bound, at_end[:, 0], at_end[:, 1], missed, distance
    )  # fmt: skip
    findings = _findings(
        program, against, _own_ways(against, ends, stands, tolerance), given, tolerance, axis_tolerance
    )
    return AgainstPath(**{**vars(against), "findings": findings})


def _bound_distance(lines: Segments) -> Callable[[Ends], Floats]:
    last = len(lines.start) - 1

    def upper(ends: Ends) -> Floats:
        least: Floats = ends.value[:, :, 0].sum(axis=0) / 2.0 + ends.travel / 2.0
        for rows in cache_chunks(len(least)):
            part = ends.take(rows)
            near = part.value[:, :, 1].astype(np.int64)
            tried = np.clip(np.concatenate([near + step for step in (-1, 0, 1)]).T, 0, last)
            both = np.maximum(*(lines.square_distances(part.place[side], tried) for side in (0, 1)))
            straight = np.sqrt(both.min(axis=1)) + part.bend / 8.0
            least[rows] = np.minimum(least[rows], straight)
        return least

    return upper


def _at_ends(
    path: CLPath,
    lines: Segments,
    pieces: Pieces,
    places: Floats,
    axis: Floats,
    tolerance: float,
    progress: Progress,
) -> Floats:
    """Distance mm from the CL line and angle rad of the axes (n, 2) at ``places`` (n, 3) with tool axes
    ``axis`` (n, 3)."""
    with_axis = np.concatenate([places, axis], axis=1)

    def square_distances(here: Floats, element: Ints) -> Floats:
        return lines.square_distances(here, element)

    def resolve(here: Floats, element: Ints, distance2: Floats) -> Floats:
        least = np.sqrt(distance2.min(axis=1))
        order = np.argsort(distance2, axis=1)[:, :TIED]
        at = np.take_along_axis(element, order, axis=1)
        near = np.sqrt(np.take_along_axis(distance2, order, axis=1)) <= least[:, None] + tolerance
        angle = np.where(near, _angles(path, lines, here[:, :3], here[:, 3:], at), np.inf)
        return np.column_stack([least, angle.min(axis=1)])

    return search(with_axis, pieces, square_distances, resolve, 2, ROUGH, progress)


def _angles(path: CLPath, lines: Segments, place: Floats, axis: Floats, element: Ints) -> Floats:
    """Angle (n, k) rad between ``axis`` (n, 3) and that of the CL path at the feet on the lines ``element``
    (n, k): on the great arc between the axes of a line's ends; where the line is a point, the nearest of that
    arc."""
    first, last = path.axis[element], path.axis[element + 1]
    share = lines.share(place, element)
    here = axis[:, None]
    still = (lines.start[element] == lines.end[element]).all(axis=-1)
    towards = ((here - first) * (last - first)).sum(axis=-1)
    length2 = ((last - first) ** 2).sum(axis=-1)
    by_axis = np.clip(np.divide(towards, length2, out=np.zeros_like(towards), where=length2 > 0.0), 0.0, 1.0)
    share = np.where(still, by_axis, share)
    meant = slerp(first, last, share)
    return np.asarray(2.0 * np.arcsin(np.clip(np.linalg.norm(here - meant, axis=-1) / 2.0, 0.0, 1.0)))


def _find_missed(
    real: RealPath, rows: Ints, deviation: Deviation, path: CLPath, tolerance: float, progress: Progress
) -> tuple[Ints, Floats]:
    """Return the rows of the CL path reached at feed that the real path of the feed blocks misses by more
    than the tolerance."""
    wanted = np.flatnonzero(path.motion != Motion.RAPID)
    if not len(rows) or not len(wanted):
        return wanted, np.full(len(wanted), math.inf)
    spare = SHARE * tolerance
    count = np.clip(np.ceil(np.sqrt(deviation.bound[rows] / spare)), 1, MOST_CHORDS).astype(np.int64)
    block, step = number_runs(count)
    share = [(step + more) / count[block] for more in (0.0, 1.0)]
    chords = Segments(*(real.places(rows[block], u) for u in share))
    distance = search(
        path.tip[wanted], chords.pieces(), chords.square_distances, nearest, 2, ROUGH, progress
    )[:, 0]
    far = distance > tolerance + spare
    return wanted[far], distance[far]


# ------------------------------------------------------------------------------------------------ findings


def _own_ways(against: AgainstPath, places: Floats, axis: Floats, tolerance: float) -> Bools:
    """Return the blocks (n,) of ways of the post's own: from a place of the path out along the tool, and back
    to the same place. ``places``, ``axis`` (n, 3): where the blocks end, and how the tool stands there."""
    off = against.off > tolerance
    first = np.flatnonzero(off & ~np.append(False, off[:-1])[: len(off)])
    first = first[first > 0]
    own = np.zeros(len(off), np.bool_)
    if not len(first):
        return own
    last = np.flatnonzero(off & ~np.append(off[1:], False))
    last = last[len(last) - len(first) :]
    back = np.linalg.norm(places[last] - places[first - 1], axis=1) <= max(tolerance, ROUNDED)
    on_path = (against.end[first - 1] <= tolerance) & (against.end[last] <= tolerance) & (last > first)
    run, within = number_runs(last - first)  # all but the last block of each way end off the path
    row = first[run] + within
    height = ((places[row] - places[first[run] - 1]) * axis[first[run] - 1]).sum(axis=1)
    lowest = np.full(len(first), np.inf)
    np.minimum.at(lowest, run, height)
    count = np.where(back & on_path & (lowest > 0.0), last - first + 1, 0)
    run, within = number_runs(count)
    own[first[run] + within] = True
    return own


def _findings(
    program: Program, against: AgainstPath, own: Bools, path: CLPath, tolerance: float, axis_tolerance: float
) -> tuple[Finding, ...]:
    ends = against.end > tolerance
    between = ~ends & (against.off > tolerance) & ~np.append(False, ends[:-1])[: len(ends)]
    found = []
    between &= ~own
    off = np.flatnonzero((against.off > tolerance) & ~between & ~own)
    if len(off):
        found.append(
            _place_finding(program, against, off, Code.OFF_CL_PATH, _ends_text(against, ends), tolerance)
        )
    if between.any():
        text = say(
            "leave the CL path between their ends, which lie on it: the axes' even motion carries the tip "
            "off. Divide blocks ({linearize}).",
            linearize=Choice("linearize", ("on",)),
        )
        found.append(
            _place_finding(program, against, np.flatnonzero(between), Code.BETWEEN_CL_ROWS, text, tolerance)
        )
    if own.any():
        text = say(
            "leave the CL path out along the tool and come back to the same place: ways of the post's own, "
            "as to rewind."
        )
        found.append(
            _place_finding(program, against, np.flatnonzero(own), Code.WAY_NOT_IN_CL_PATH, text, tolerance)
        )
    leaning = np.flatnonzero((against.axis > axis_tolerance) & (against.end <= max(100.0 * tolerance, 1.0)))
    if len(leaning):
        found.append(_axis_finding(program, against, leaning, axis_tolerance))
    if len(against.missed):
        found.append(_report_missed(against, path, tolerance))
    return tuple(found)


def _ends_text(against: AgainstPath, ends: Bools) -> Sentence:
    if ends.mean() < ALL_ALIKE:
        return say(
            "leave the CL path, and end off it: a word is wrong there, or they are moves of the post's own, "
            "as retracts."
        )
    off = np.percentile(against.end, (5, 95))
    return say(
        "are off the CL path, nearly all alike ({least} to {most} at their ends): the post had another "
        "machine, work zero or "
        "tool length in mind. See {origin} and {tool_length}; {recover} finds the machine that fits.",
        recover=Task("recover"),
        least=Length(off[0], ".4g", bare=True),
        most=Length(off[1], ".4g"),
        origin=Option("origin"),
        tool_length=Option("tool_length"),
    )


def _place_finding(
    program: Program, against: AgainstPath, at: Ints, code: Code, text: str, tolerance: float
) -> Finding:
    worst = int(at[against.off[at].argmax()])
    row = int(against.block[worst])
    whole = plural(
        len(at),
        "1 feed block: {count} of {all} feed blocks {what} Worst is NC line {line}, {off} off ({tolerance} "
        "allowed); first NC line {first}.",
        "{count} of {all} feed blocks {what} Worst is NC line {line}, {off} off ({tolerance} allowed); first "
        "NC line {first}.",
        all=len(against.block),
        what=text,
        line=program.line[row],
        off=Length(against.off[worst], ".5g"),
        tolerance=Length(tolerance),
        first=program.line[against.block[at[0]]],
    )
    x, y, z = against.place[worst].tolist()
    value, line = float(against.off[worst]), int(program.line[row])
    return report_finding(code, whole, value, tolerance, row, line, (x, y, z))


def _axis_finding(program: Program, against: AgainstPath, at: Ints, tolerance: float) -> Finding:
    worst = int(at[against.axis[at].argmax()])
    row, lean = int(against.block[worst]), math.degrees(against.axis[worst])
    text = say(
        "At the end of {count} feed blocks the tool does not stand as the CL path says: worst NC line {line},"
        " by {lean} ({tolerance} allowed); first NC line {first}. Are signs, order and zeros of the "
        "rotary axes those of the machine?",
        count=len(at),
        line=program.line[row],
        lean=Angle(lean, ".4g"),
        tolerance=Angle(math.degrees(tolerance)),
        first=program.line[against.block[at[0]]],
    )
    line = int(program.line[row])
    return report_finding(Code.AXIS_OFF_CL_PATH, text, lean, math.degrees(tolerance), row, line)


def _report_missed(against: AgainstPath, path: CLPath, tolerance: float) -> Finding:
    worst, first = int(against.distance.argmax()), int(against.missed[0])
    text = say(
        "{count} rows of the CL file are not cut: no feed block comes within {tolerance} of them. The first "
        "is row {first} of {all}, the farthest row {missed}, {distance} off. Is the program whole, and "
        "made from this file?",
        count=len(against.missed),
        tolerance=Length(tolerance),
        first=first + 1,
        all=len(path.tip),
        missed=against.missed[worst] + 1,
        distance=Length(against.distance[worst], ".4g"),
    )
    x, y, z = path.tip[against.missed[worst]].tolist()
    value = float(against.distance[worst]) if math.isfinite(against.distance[worst]) else None
    return report_finding(Code.CL_ROWS_MISSED, text, value, tolerance, place=(x, y, z))
