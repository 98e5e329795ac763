# SPDX-License-Identifier: LGPL-2.1-or-later
"""The NC program as the machine gets it: words rounded to the controller's step, feeds, times.

block     one row: the straight joint move from the row before it to this one. Row 0 is the first position:
          where the machine comes from is not known, so nothing is claimed of it.
G94, G93  feed in mm/min, or inverse time: one over the minutes that the block takes.
F         is chosen such that the **tip over the part** moves at the CL path's feed along its real path, or
          slower where an axis would exceed its maximum rate. It is rounded down, so that no rate is exceeded
          by rounding.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.columns import empty_rows
from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.number_text import round_as_printed
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints, freeze, take_rows
from freecad_fiveaxis.core.base.sentences import Feed, Template, say
from freecad_fiveaxis.core.controllers.dialect import Dialect, Guide, feed_distance
from freecad_fiveaxis.core.machine.kinematics import Chain, words_to_q
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.toolpath.cl_path import Motion

from .feeds import feed_minutes, rapid_minutes, tip_travel
from .guided import Guided, rounding_finding, standing, take_up_axes
from .wrapping import by_the_shorter_way, wraps_of

FEED_SLACK = 1e-9
"""F is rounded down, but a relative rounding error of this size must not cost a whole step (999.9999 for
1000)."""

TIMED = 300_000
"""Blocks that are timed together, at most: the few that bend much are then many enough for the many calls
that they need."""


@dataclass(frozen=True, eq=False)
class Program:
    """``letters``: the five words in order: X Y Z, first rotary, second rotary (nearer to the work first), as
    "XYZCA".

    ``words`` (m, 5) mm and **degrees**, as rounded for the controller, turns not folded; ``feed`` (m,) the F
    word (mm/min, or 1/min where ``inverse_time``; 0 for rapids); ``inverse_time`` (m,) True under G93;
    ``motion`` (m,) of :class:`~freecad_fiveaxis.core.toolpath.cl_path.Motion`; ``seconds`` (m,) the time that
    the block is meant to take (0 for row 0); ``row`` (m,) row of the JointPath and of the CL path in it, -1
    where there is none;
    ``line`` (m,) line of the NC file, counted from 1. ``guided``: what the NC file says where the controller
    guides the tip; ``words`` are then where the axes stand at the blocks' ends, worked out from that.
    ``wrap``: how the controller takes each rotary word of the NC file. ``unknown_way`` (m,) rows to which the
    machine comes from a position of its own, so that of the way nothing is known, as of that to row 0; None:
    no others.
    """

    letters: str
    words: Floats
    feed: Floats
    inverse_time: Bools
    motion: Bytes
    seconds: Floats
    row: Ints
    line: Ints
    findings: tuple[Finding, ...] = ()
    guided: Guided | None = None
    wrap: tuple[str, str] = ("unwound", "unwound")
    unknown_way: Bools | None = None

    def __post_init__(self) -> None:
        freeze(self, None, words="f5", feed="f", inverse_time="b", motion="m", seconds="f", row="i", line="i")
        if self.unknown_way is not None:
            freeze(self, len(self.words), unknown_way="b")


def feed_blocks(program: Program) -> Ints:
    """Return the rows of the feed blocks. Row 0 is none: where the machine comes from is not known."""
    rows = np.flatnonzero(program.motion != Motion.RAPID)
    return rows[rows > 0]


def find_unknown_ways(program: Program) -> Bools:
    """Tell in which blocks (m - 1,) the way is not known; block i leads to row i + 1."""
    if program.unknown_way is None:
        return np.zeros(max(len(program.words) - 1, 0), np.bool_)
    return program.unknown_way[1:]


def block_starts(program: Program, rows: Ints) -> Floats:
    """Return the words (k, 5) at which the blocks that lead to these ``rows`` (k,) begin; one whose way is
    not known, and that of row 0, stands at its end."""
    rows = np.asarray(rows)
    if program.unknown_way is None:
        return program.words[np.maximum(rows - 1, 0)]
    return program.words[np.where(program.unknown_way[rows], rows, np.maximum(rows - 1, 0))]


def build_program(
    joints: JointPath, kinematics: Chain, dialect: Dialect, inverse_time: bool, progress: Progress = silent
) -> Program:
    """Return the program of a joint path for one controller: rounded words, one block for every row that
    moves, F words, times.

    A row whose words are all those of the row before it is left out (row 0 never). Row 0 is a rapid, because
    no time can be given for a move that starts nowhere. Raises ProgramError where another row that is no
    rapid has no feed above 0.
    """
    findings = _no_inverse_time(dialect) if inverse_time and not dialect.inverse_time else ()
    inverse_time &= bool(dialect.inverse_time)
    rotary = tuple(axis.wrap for axis in kinematics.axes[3:])
    wrap = wraps_of(rotary, dialect)
    words, row = (
        _round_words(joints.q, dialect)
        if dialect.guide is None
        else _round_guided(joints, dialect.guide, dialect)
    )
    motion, tip_feed = joints.path.motion.take(row), joints.path.feed.take(row)
    findings += _first_findings(motion)
    motion[:1] = Motion.RAPID
    _check_feeds(row, motion, tip_feed)
    words, more = by_the_shorter_way(words, wrap, rotary, kinematics.letters, dialect, motion != Motion.RAPID)
    guided, stands = None, words
    if dialect.guide is not None:
        guided, words, stands = _split_guided(joints, row, words, kinematics, dialect.guide)
        more += (
            (
                rounding_finding(
                    kinematics, stands, take_rows(joints.path.tip, row), take_rows(joints.path.axis, row)
                ),
            )
            if len(row)
            else ()
        )
    scale = _FeedScale(dialect, inverse_time)
    times = _time_blocks(stands, words, motion, tip_feed, kinematics, scale, progress)
    line = np.arange(dialect.first_line, dialect.first_line + len(row))
    findings += more + _feed_findings(times, scale)
    modes = np.full(len(row), inverse_time)
    return Program(
        kinematics.letters,
        stands,
        times.feed,
        modes,
        motion,
        times.seconds,
        row,
        line,
        findings,
        guided,
        wrap,
    )


def _no_inverse_time(dialect: Dialect) -> tuple[Finding, ...]:
    text = say(
        "{name} has no inverse time (G93): F is written in mm/min, one for each block.", name=dialect.name
    )
    return (report_finding(Code.NO_INVERSE_TIME, text),)


def _round_guided(joints: JointPath, guide: Guide, dialect: Dialect) -> tuple[Floats, Ints]:
    """As _round_words, of the words that a guided block says: the tip (mm) and the rotary words (deg), which
    are only rounded where they are said. A row moves where tip, or what is said of the axis, changes."""
    rotary = 15 if guide.vector else dialect.rotary_decimals
    programmed = np.column_stack([dialect.round_word(joints.path.tip, 0), np.degrees(joints.q[:, 3:])])
    if guide.vector is None:
        programmed[:, 3:] = round_as_printed(programmed[:, 3:], rotary)
    written = (
        programmed
        if guide.vector is None
        else np.column_stack([programmed[:, :3], round_as_printed(joints.path.axis, guide.vector_decimals)])
    )
    moving = np.flatnonzero(
        np.append(np.ones(min(len(programmed), 1), np.bool_), (np.diff(written, axis=0) != 0.0).any(axis=1))
    )
    return programmed[moving], moving


def _split_guided(
    joints: JointPath, row: Ints, programmed: Floats, kinematics: Chain, guide: Guide
) -> tuple[Guided, Floats, Floats]:
    """Return what the guided blocks say; the tip with the rotary words (m, 5); and where the axes stand (m,
    5)."""
    tip, angles, vector = programmed[:, :3], programmed[:, 3:], None
    if guide.vector is not None:
        vector = round_as_printed(take_rows(joints.path.axis, row), guide.vector_decimals)
        angles = take_up_axes(kinematics, vector, angles)
    return (
        Guided(np.ones(len(row), np.bool_), tip, vector),
        np.column_stack([tip, angles]),
        standing(kinematics, tip, angles),
    )


def _round_words(q: Floats, dialect: Dialect) -> tuple[Floats, Ints]:
    """Words (m, 5) mm and degrees, the doubles nearest to what is printed, of the rows that move; and these
    rows (m,)."""
    words, moves = empty_rows(len(q), 5), np.zeros(len(q), np.bool_)
    moves[:1] = True

    def fill(rows: slice) -> None:
        for k in range(5):
            words[rows, k] = dialect.round_word(q[rows, k] if k < 3 else np.degrees(q[rows, k]), k)

    def compare(rows: slice) -> None:
        since = slice(max(rows.start, 1), rows.stop)
        for k in range(5):
            moves[since] |= words[since, k] != words[since.start - 1 : since.stop - 1, k]

    in_threads(fill, chunks(len(q)))
    in_threads(compare, chunks(len(q)))
    row = np.flatnonzero(moves)
    return (words if len(row) == len(q) else take_rows(words, row)), row


def _check_feeds(row: Ints, motion: Bytes, tip_feed: Floats) -> None:
    bad = np.flatnonzero((motion != Motion.RAPID) & ~(tip_feed > 0.0))
    if len(bad):
        value = float(tip_feed[bad[0]])
        raise ProgramError(
            say(
                "row {row} of the CL path is a feed move with feed {value}; give a feed above 0",
                row=row[bad[0]],
                value=Feed(value, bare=True),
            ),
            value,
        )


def _first_findings(motion: Bytes) -> tuple[Finding, ...]:
    if not len(motion) or motion[0] == Motion.RAPID:
        return ()
    text = say(
        "The CL path starts with a feed move; the program reaches its first position in rapid. Start it "
        "above the part."
    )
    return (report_finding(Code.FIRST_POSITION_RAPID, text, block=0),)


@dataclass(frozen=True)
class _FeedScale:
    """What an F word means and how fine it is."""

    dialect: Dialect
    inverse_time: bool

    @property
    def decimals(self) -> int:
        return self.dialect.inverse_decimals if self.inverse_time else self.dialect.feed_decimals

    @property
    def largest(self) -> float:
        return self.dialect.largest_inverse if self.inverse_time else self.dialect.largest_feed

    def distance(self, change: Floats) -> Floats:
        """Return what F times minutes gives in blocks that change the words by ``change`` (n, 5) mm and deg:
        1, or what F is measured over, mm (deg)."""
        return np.ones(len(change)) if self.inverse_time else feed_distance(self.dialect, change)

    def units(self, change: Floats) -> Floats | float:
        """Return the mm (n,) that F counts in these blocks, 1.0 where it counts degrees or is 1/min."""
        if self.inverse_time or self.dialect.unit == 1.0:
            return 1.0
        return self.dialect.find_feed_units(change)

    def round_down(self, commanded: Floats) -> Floats:
        """F at most ``commanded`` and at most the controller's largest, but at least one step."""
        step = 10.0**-self.decimals
        count = np.floor(np.minimum(commanded, self.largest) * ((1.0 + FEED_SLACK) / step))
        return round_as_printed(np.maximum(count, 1.0) * step, self.decimals)


class _Times(NamedTuple):
    """``commanded`` (m,) the F that each block asks for, ``feed`` (m,) as rounded (both 0 for rapids);
    ``held`` (m,) whether an axis holds it back; ``seconds`` (m,) by the rounded F; ``real`` (m,) mm/min the
    tip's mean feed over the part in feed blocks."""

    commanded: Floats
    held: Bools
    feed: Floats
    seconds: Floats
    real: Floats


def _time_blocks(
    words: Floats,
    programmed: Floats,
    motion: Bytes,
    tip_feed: Floats,
    kinematics: Chain,
    scale: _FeedScale,
    progress: Progress,
) -> _Times:
    """``words`` (m, 5): where the axes stand; ``programmed`` (m, 5): the same, or the tip and the rotary
    words where it is guided."""
    count, guided = len(words), programmed is not words
    times = _Times(np.zeros(count), np.zeros(count, np.bool_), *np.zeros((3, count)))

    def fill(steps: slice) -> None:
        rows, ends = slice(steps.start + 1, steps.stop + 1), slice(steps.start, steps.stop + 1)
        q, ends_at, rapid = (
            words_to_q(words[ends]),
            programmed[ends],
            np.flatnonzero(motion[rows] == Motion.RAPID),
        )
        change, wanted, along = (
            np.diff(ends_at, axis=0),
            tip_feed[rows].copy(),
            np.ones(rows.stop - rows.start, np.bool_),
        )
        wanted[rapid], along[rapid] = 1.0, False
        distance, unit = scale.distance(change), scale.units(change)
        travel = np.linalg.norm(change[:, :3], axis=1) if guided else tip_travel(kinematics, q, along)
        if guided:
            change = np.diff(q, axis=0)
        else:
            change[:, 3:] *= np.pi / 180.0
        minutes, held = feed_minutes(kinematics, change, travel, wanted)
        commanded = distance / (minutes * unit)
        commanded[rapid] = 0.0
        held[rapid] = False
        feed = scale.round_down(commanded) * unit
        seconds = 60.0 * distance / feed
        seconds[rapid] = 60.0 * rapid_minutes(kinematics, change[rapid])
        feed[rapid] = 0.0
        real = np.divide(60.0 * travel, seconds, out=np.zeros(len(travel)), where=along & (seconds > 0.0))
        for whole, part in zip(times, (commanded, held, feed, seconds, real), strict=True):
            whole[rows] = part

    in_threads(fill, chunks(max(count - 1, 0), TIMED), lambda done: progress("feeds", done))
    progress("feeds", 1.0)
    return times


def block_findings(findings: tuple[Finding, ...], program: Program) -> tuple[Finding, ...]:
    """Return findings whose ``block`` is a row of the joint path, at the block of the program that drives to
    it, with its NC line.

    A row without a block of its own (the row before it has the same words) is at that row's.
    """
    placed = []
    for finding in findings:
        block = (
            None
            if finding.block is None
            else int(np.searchsorted(program.row, finding.block, side="right")) - 1
        )
        placed.append(
            finding if block is None else replace(finding, block=block, line=int(program.line[block]))
        )
    return tuple(placed)


HELD = Template(
    "In {count} blocks an axis would exceed its maximum rate; they run slower than programmed, half of them "
    "at less than {feed}. For an even feed give a lower one."
)
ABOVE = Template(
    "In {count} blocks F would exceed the controller's largest; they run slower than programmed, half of "
    "them at less than {feed}. Use G94, or give a lower feed."
)
BELOW = Template("In {count} blocks F would be below one step; they run faster than programmed. Use G93.")


def _feed_findings(times: _Times, scale: _FeedScale) -> tuple[Finding, ...]:
    commanded, held = times.commanded, times.held
    unit, step = "1/min" if scale.inverse_time else "mm/min", 10.0**-scale.decimals
    per_feed = 1.0 if scale.inverse_time else scale.dialect.unit
    below = np.flatnonzero(commanded < step / (1.0 + FEED_SLACK))
    below = below[commanded[below] > 0.0]  # not those of rapids
    cases = (
        (np.flatnonzero(held), Code.FEED_HELD_BACK,
         HELD, float(held.sum()), 0.0, "1"),
        (np.flatnonzero(commanded > scale.largest), Code.FEED_ABOVE_LARGEST,
         ABOVE,
         per_feed * float(commanded.max(initial=0.0)), per_feed * scale.largest, unit),
        (below, Code.FEED_BELOW_STEP, BELOW,
         per_feed * float(commanded[below].min(initial=step)), per_feed * step, unit),
    )  # fmt: skip
    found = []
    for blocks, code, text, value, limit, unit_of in cases:
        if len(blocks):
            block = int(blocks[0])
            feed = Feed(float(np.median(times.real[blocks])), ".3g")
            programmed = text.say(count=len(blocks), feed=feed)
            found.append(
                report_finding(
                    code, programmed, value, limit, block, scale.dialect.first_line + block, unit=unit_of
                )
            )
    return tuple(found)
