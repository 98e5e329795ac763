# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a program asks of the axes, and at which speed the tip then moves over the part.

asked rate   how fast an axis would have to move so that a block takes the time which its F word means:
             ``|change of the word| / minutes``. The axes of a block move evenly, so it is the rate everywhere
             in the block; where the controller guides the tip it is the mean.
minutes      under G93 ``1 / F``; under G94 what F is measured over (``post.dialect.feed_distance``), divided
             by F.
tip feed     length of the tip's real path over the part in a block, over its minutes: what F ought to mean.
untimed      a feed block without F, or with a feed per turn of the spindle: nothing can be said of it.

Rapids are left out: each goes as fast as its slowest axis may.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bytes, Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import (
    Feed,
    Number,
    Sentence,
    Task,
    measure,
    plural,
    say,
)
from freecad_fiveaxis.core.machine.kinematics import Chain, forward_tip, words_to_q
from freecad_fiveaxis.core.motion.program import Program, feed_blocks
from freecad_fiveaxis.core.motion.program.feeds import STILL, tip_travel
from freecad_fiveaxis.core.toolpath.cl_path import Motion

PORTION = 65536
"""Blocks worked on at a time."""
RATE_ROUNDING = 1e-3
"""Share; excess over a rate that is rounding of F and of the words."""
OTHER_THAN_F, OTHER_THAN_MEDIAN = 2.0, 5.0
"""A tip feed off by this factor is worth a finding: off the F word under G94; off the median of all feed
blocks, where approaches are rightly slower than cuts, under G93 and where F follows the way of the axes."""
STEADY = 0.05
"""Share off the median up to which F, or the tip feed, is that of most blocks."""
AT_LIMIT = 0.95
"""Share of its maximum rate from which an axis holds a block back, rightly."""
DEGREES = np.array([1.0, 1.0, 1.0, math.degrees(1.0), math.degrees(1.0)])


@dataclass(frozen=True, eq=False)
class Rates:
    """One row a block, 0 in rapids and untimed blocks: ``rate`` (m, 5) mm/min and rad/min, unsigned;
    ``ratio`` (m,) the largest rate over its axis' maximum, ``axis`` (m,) the word that it is of; ``tip_feed``
    (m,) mm/min; ``travel`` (m,) mm of the tip."""

    rate: Floats
    ratio: Floats
    axis: Bytes
    tip_feed: Floats
    travel: Floats

    def __post_init__(self) -> None:
        freeze(self, None, rate="f5", ratio="f", axis="m", tip_feed="f", travel="f")


def compute_commanded_rates(kinematics: Chain, program: Program, progress: Progress = silent) -> Rates:
    """Return what the F words of ``program`` ask for, block by block."""
    count = len(program.words)
    rate, ratio, tip_feed, travel = np.zeros((5, count)).T, np.zeros(count), np.zeros(count), np.zeros(count)
    axis = np.zeros(count, np.int8)
    for first in range(1, count, PORTION):
        progress("axis rates", first / count)
        rows = slice(first, min(first + PORTION, count))
        q = words_to_q(program.words[first - 1 : rows.stop])
        feeding = program.motion[rows] != Motion.RAPID
        minutes = np.where(feeding, program.seconds[rows] / 60.0, 0.0)
        timed = minutes > 0.0
        per_minute = np.divide(1.0, minutes, out=np.zeros(len(minutes)), where=timed)
        rate[rows] = np.abs(np.diff(q, axis=0)) * per_minute[:, None]
        shares = rate[rows] / kinematics.rate
        axis[rows] = shares.argmax(axis=1)
        ratio[rows] = shares.max(axis=1)
        travel[rows] = np.where(feeding, _tip_travel(kinematics, program, q, rows), 0.0)
        tip_feed[rows] = travel[rows] * per_minute
    progress("axis rates", 1.0)
    return Rates(rate, ratio, axis, tip_feed, travel)


def _tip_travel(kinematics: Chain, program: Program, q: Floats, rows: slice) -> Floats:
    """Length (n,) mm of the tip's path in the blocks ``rows``, ``q`` (n + 1, 5) their ends: straight where it
    is guided."""
    wanted = program.motion[rows] != Motion.RAPID
    if program.guided is None:
        return tip_travel(kinematics, q, wanted)
    on = program.guided.on[rows]
    straight: Floats = np.linalg.norm(np.diff(forward_tip(kinematics, q), axis=0), axis=1)
    return np.where(on, straight, tip_travel(kinematics, q, wanted & ~on))


def find_timed_feeds(program: Program) -> Ints:
    """Return the feed blocks whose time is known."""
    feeds = feed_blocks(program)
    return feeds[program.seconds[feeds] > 0.0]


def rate_findings(kinematics: Chain, program: Program, rates: Rates) -> tuple[Finding, ...]:
    """Return a warning for each axis of which feed blocks ask more than its maximum rate."""
    found = []
    for k, letter in enumerate(program.letters):
        rows = np.flatnonzero(rates.rate[:, k] > kinematics.rate[k] * (1.0 + RATE_ROUNDING))
        if not len(rows):
            continue
        worst = int(rows[rates.rate[rows, k].argmax()])
        commanded, most = float(rates.rate[worst, k] * DEGREES[k]), float(kinematics.rate[k] * DEGREES[k])
        unit = "mm/min" if k < 3 else "deg/min"
        text = say(
            "{blocks} more of {letter} than it can: at most NC line {line}, {commanded_rate}, {share} times "
            "its maximum of {most}; first NC line {first}. The control slows down there, or stops with a "
            "fault. Give a lower F there, or inverse time (G93) made for this machine, as {post} does.",
            post=Task("post"),
            blocks=_blocks(rows),
            letter=letter,
            line=program.line[worst],
            commanded_rate=measure(commanded, unit, ".5g"),
            share=Number(commanded / most, ".4g"),
            most=measure(most, unit, ".5g", bare=True),
            first=program.line[rows[0]],
        )
        found.append(_finding(Code.AXIS_RATE, text, commanded, most, unit, kinematics, program, worst))
    return tuple(found)


@dataclass(frozen=True, eq=False)
class _Meant:
    """What the tip feed of feed blocks ``rows`` (n,) should be: ``wanted`` (n,) mm/min, within ``factor`` to
    either side; ``by_f``: because F says so, else because most blocks have it."""

    rows: Ints
    wanted: Floats
    factor: float
    by_f: bool
    advice: Sentence
    severity: Severity


def feed_findings(
    kinematics: Chain, program: Program, rates: Rates, inverse_time: str = "G93"
) -> tuple[Finding, ...]:
    """Return a finding where the tip moves over the part at quite another speed than F says (G94), or than
    elsewhere (G93, and G94 where F follows the way of the axes so that the tip keeps its feed).
    ``inverse_time``: the controller's word for it, "" where it has none."""
    rows = find_timed_feeds(program)
    rows = rows[rates.travel[rows] > STILL]
    inverse = program.inverse_time[rows]
    by_f, by_time = rows[~inverse], rows[inverse]
    usual = _median(rates.tip_feed[by_time])
    look = say(
        "Approaches and blocks in which an axis is at its limit are rightly slower; look at the others."
    )
    meant = (
        _find_what_f_is_for(program, rates, by_f, inverse_time),
        _Meant(by_time, usual, OTHER_THAN_MEDIAN, False, look, Severity.NOTE),
    )
    return tuple(one for each in meant for one in _unlike(kinematics, program, rates, each))


def _find_what_f_is_for(program: Program, rates: Rates, rows: Ints, inverse_time: str) -> _Meant:
    """Find what F in the blocks ``rows`` is for: the tip, or the way of the axes, so that the tip keeps its
    feed. In the second case blocks are left out in which the tip does what F says (a plunge), or which an
    axis at its maximum rate makes slower."""
    feed, tip_feed = program.feed[rows], rates.tip_feed[rows]
    if _count_steady(tip_feed) <= _count_steady(feed):
        return _Meant(rows, feed, OTHER_THAN_F, True, _advise(inverse_time), Severity.WARNING)
    usual = _median(tip_feed)
    held_back = (tip_feed < usual) & (rates.ratio[rows] >= AT_LIMIT)
    kept = np.flatnonzero((_factor(tip_feed / feed) > OTHER_THAN_F) & ~held_back)
    advice = say("Most blocks keep that feed, whatever way their axes go; look at F in the others.")
    return _Meant(rows[kept], usual[kept], OTHER_THAN_MEDIAN, False, advice, Severity.WARNING)


def _advise(inverse_time: str) -> Sentence:
    """Return what to do where F is not the feed over the part."""
    if inverse_time:
        return say(
            "With rotary axes turning, F under G94 means other things on other controls. Post with inverse "
            "time (G93)."
        )
    return say(
        "With rotary axes turning, F means other things on other controls. This one has no inverse time: "
        "give each block an F for the way of its axes, as {post} does.",
        post=Task("post"),
    )


def _median(values: Floats) -> Floats:
    return np.full(len(values), np.median(values)) if len(values) else values


def _count_steady(values: Floats) -> int:
    """Count what is off the median by STEADY at most."""
    return int((np.abs(values - _median(values)) <= STEADY * _median(values)).sum())


def _factor(share: Floats) -> Floats:
    return np.maximum(share, 1.0 / share)


def _unlike(kinematics: Chain, program: Program, rates: Rates, meant: _Meant) -> tuple[Finding, ...]:
    """Return one finding of all blocks whose tip feed is not what is ``meant``."""
    rows, off = meant.rows, _factor(rates.tip_feed[meant.rows] / meant.wanted)
    far = np.flatnonzero(off > meant.factor)
    if not len(far):
        return ()
    at = int(far[off[far].argmax()])
    row, feed = int(rows[at]), float(rates.tip_feed[rows[at]])
    speed = Feed(meant.wanted[at], ".5g", bare=True)
    first, last = (int(program.line[rows[far[i]]]) for i in (0, -1))
    where = plural(
        len(far),
        "1 feed block (NC line {first})",
        "{count} feed blocks (between NC lines {first} and {last})",
        first=first,
        last=last,
    )
    lead = say(
        "In {where} the tip moves over the part more than {factor} times faster or slower than meant: at "
        "worst {feed} in NC line {line}, where {meant}. ",
        where=where,
        factor=Number(meant.factor),
        feed=Feed(feed, ".5g"),
        line=program.line[row],
        meant=say("F says {speed}", speed=speed)
        if meant.by_f
        else say("the median of all blocks is {speed}", speed=speed),
    )
    limit = float(meant.wanted[at])
    found = _finding(
        Code.FEED_OVER_PART, lead + meant.advice, feed, limit, "mm/min", kinematics, program, row
    )
    return (replace(found, severity=meant.severity),)


def _blocks(rows: Ints) -> Sentence:
    return plural(len(rows), "1 feed block asks", "{count} feed blocks ask")


def _finding(
    code: Code,
    text: str,
    value: float,
    limit: float,
    unit: str,
    kinematics: Chain,
    program: Program,
    row: int,
) -> Finding:
    x, y, z = forward_tip(kinematics, words_to_q(program.words[row : row + 1]))[0].tolist()
    return report_finding(code, text, value, limit, row, int(program.line[row]), (x, y, z), unit=unit)
