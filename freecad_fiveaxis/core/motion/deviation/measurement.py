# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the tip leaves the commanded segment while the axes move linearly, with a proven bound.

chord             the straight segment between the real tips at a block's two ends: what the block commands.
line deviation    largest distance of the real path from the infinite line through the chord (So et al. 2008,
                  eq. 6).
segment deviation largest distance from the chord itself: where the tool should have been. Never less than the
former. A chord
                  shorter than ``quartic.POINT`` has no direction: both are then measured from its point of
                  the same u.
bound             a proven upper bound of the segment deviation, whatever u, rounding of the arithmetic
                  included.
axis deviation    largest angle of the real tool axis off the plane of the block's two end axes
                  (``axis_swing``).
same-u deviation  largest distance from the point of the chord with the same u; it also counts uneven speed.

Ordinary blocks are proven by the quartic through five points of the path, the others by search. Both are
derived and proven at the head of their modules, and in docs/deviation.md.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Floats, Ints, freeze
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine.kinematics import Chain, forward_tip, lift_of, raise_chain, words_to_q
from freecad_fiveaxis.core.motion.trajectory import (
    Frames,
    Motion,
    Pose,
    Vectors,
    at,
    axis,
    chain_motion,
    check_words,
    flat_length,
    frames,
    inner,
    motion,
    outer,
    tip,
    to_work,
)

from . import so2008
from .axis_swing import small_swing, swing
from .bound import CHUNK, Levers, allowance, bending, close_levers, end_levers
from .quartic import POINT, Chord, bow, chord, node_poses, subtract_chord_motion
from .search import Chords, farthest

SEARCHED = 2048
"""Blocks searched at a time: their pieces fill a chunk."""

REPORT_EVERY = 0.25
"""s between calls of progress."""


@dataclass(frozen=True, eq=False)
class Deviation:
    """One row a block of the Program, row 0 (the first position) all zero.

    ``line`` (m,) mm: largest distance of the real tip path from the infinite line through the block's ends
    (So et al., eq. 6), at ``u_line``; ``segment`` (m,) mm: largest distance from the commanded segment, at
    ``u_segment``; ``bound`` (m,) mm: proven upper bound of ``segment``; ``axis`` (m,) rad: largest angle by
    which the real tool axis leaves the plane of the block's two end axes; ``place`` (m, 3) mm: the real tip
    at ``u_segment``, work frame. ``lift`` (3,) mm: the linear words that raise the driven point to the one
    that is measured.
    """

    line: Floats
    u_line: Floats
    segment: Floats
    u_segment: Floats
    bound: Floats
    axis: Floats
    place: Floats
    findings: tuple[Finding, ...] = ()
    lift: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        freeze(self, None, line="f", u_line="f", segment="f", u_segment="f", bound="f", axis="f", place="f3")

    def raise_words(self, kinematics: Chain, words: Floats) -> tuple[Chain, Floats]:
        """Raise chain and ``words`` (n, 5) mm and degrees so that the tip of both is the point that was
        measured."""
        if not any(self.lift):
            return kinematics, words
        return raise_chain(kinematics, np.array(self.lift)), words + (*self.lift, 0.0, 0.0)


METHODS = ("exact", "so2008", "so2008-printed")
"""Of the line deviation; everything else is exact with each."""


def measure(
    kinematics: Chain, words: ArrayLike, method: str = "exact", progress: Progress = silent
) -> Deviation:
    """Return the deviation of every block of a program, from its words as rounded for the controller.

    ``words`` (m, 5) mm and **degrees** in the chain's word order, turns not folded. ``method``: ``exact``, or
    ``so2008`` or ``so2008-printed`` for ``line`` and ``u_line`` by the model of So et al. (module
    ``so2008``); all else is exact. Distances are within 1e-5 of their value or 1e-6 mm; ``bound`` is no more
    than that above ``segment``, but for rounding. Raises ProgramError for words that cannot be used
    (``trajectory.check_words``), SettingsError for an unknown method.
    """
    if method not in METHODS:
        raise SettingsError(
            say(
                "unknown method {method} of the line deviation; use one of {methods}",
                method=repr(method),
                methods=", ".join(METHODS),
            ),
            method,
        )
    rows = check_words(words)
    result = _exact(frames(kinematics), rows, pace_progress(progress))
    if method == "exact":
        return result
    line, u_line, findings = so2008.line_deviation(
        kinematics, rows, method == "so2008-printed", pace_progress(progress)
    )
    return replace(result, line=line, u_line=u_line, findings=findings)


def measure_above(
    kinematics: Chain,
    words: ArrayLike,
    above: float,
    decimals: int,
    method: str = "exact",
    progress: Progress = silent,
    unit: float = 1.0,
) -> Deviation:
    """Measure the same of the point ``above`` mm over the driven one along the tool axis, against its own
    chords.

    ``decimals`` of the linear words, in ``unit`` mm: the point is that nearest one whose words are rounded
    when ``words`` are. ``place`` (m, 3) mm is where the driven point stands when that one deviates most.
    Raises as :func:`measure`.
    """
    rows = check_words(words)
    lift = lift_of(kinematics, above, decimals, unit)
    x, y, z = lift.tolist()
    found = measure(raise_chain(kinematics, lift), rows + np.append(lift, (0.0, 0.0)), method, progress)
    before = np.concatenate([rows[:1], rows[:-1]])
    place = forward_tip(kinematics, words_to_q(before + found.u_segment[:, None] * (rows - before)))
    return replace(found, place=place, lift=(x, y, z))


def pace_progress(progress: Progress) -> Progress:
    """``progress``, called no more often than every :data:`REPORT_EVERY` seconds, and at the end."""
    last = time.monotonic()

    def report(stage: str, fraction: float) -> None:
        nonlocal last
        if fraction >= 1.0 or time.monotonic() - last >= REPORT_EVERY:
            progress(stage, fraction)
            last = time.monotonic()

    return report


@dataclass(frozen=True, eq=False)
class _Table:
    """The columns of a :class:`Deviation` while they are filled; ``place`` (3, m)."""

    line: Floats
    u_line: Floats
    segment: Floats
    u_segment: Floats
    bound: Floats
    axis: Floats
    place: Floats

    def put(self, rows: Ints | slice, **columns: Floats) -> None:
        for name, values in columns.items():
            getattr(self, name)[..., rows] = values


def _exact(frame: Frames, words: Floats, progress: Progress) -> Deviation:
    count = len(words)
    line, u_line, segment, u_segment, bound, angle = np.zeros((6, count))
    table = _Table(line, u_line, segment, u_segment, bound, angle, np.zeros((3, count)))
    for part in _yield_left_rows(lambda rows: _fit(frame, words, rows, table), count, progress):
        _search(frame, words, part, table)
    columns = {name: value for name, value in vars(table).items() if name != "place"}
    return Deviation(**columns, place=table.place.T)


def _yield_left_rows(fit: Callable[[slice], Ints], count: int, progress: Progress) -> Iterator[Ints]:
    """Call ``fit`` on slices of all blocks; yield the rows of those that it returns, enough at a time to be
    worth a search."""
    waiting: list[Ints] = []
    for first in range(0, count - 1, CHUNK):
        last = min(first + CHUNK, count - 1)
        waiting.append(first + 1 + fit(slice(first + 1, last + 1)))
        found = sum(map(len, waiting))
        if found >= SEARCHED or (found and last == count - 1):
            yield from np.array_split(np.concatenate(waiting), -(-found // SEARCHED))
            waiting.clear()
        progress("deviation", last / (count - 1))


def _fit(frame: Frames, words: Floats, rows: slice, table: _Table) -> Ints:
    """Measure the blocks that end in these rows by quartics; returns the indices of those that need a
    search."""
    move, poses = chain_motion(frame, words[rows.start - 1 : rows.stop])
    way, nodes, levers = _five_points(frame, move, poses)
    found = bow(way, np.array(tip(frame, nodes)), levers)
    table.put(rows, line=found.distance, u_line=found.u, segment=found.distance, u_segment=found.u)
    table.put(
        rows, bound=found.bound + allowance(move), place=np.array(to_work(frame, _columns(found.place)))
    )
    x, y, z = axis(frame, poses)
    table.put(rows, axis=small_swing((x[:-1], y[:-1], z[:-1]), (x[1:], y[1:], z[1:]), axis(frame, nodes)))
    return np.flatnonzero(~found.proven)


def _five_points(frame: Frames, move: Motion, poses: Pose) -> tuple[Chord, Pose, Levers]:
    """Return the chords, the poses at the nodes between their ends, and the levers."""
    y = inner(frame, poses)
    tips, reach = np.array(outer(poses, y)), flat_length(y[0], y[1])
    return chord(tips[:, :-1], tips[:, 1:]), node_poses(move, poses), end_levers(move, reach[:-1], reach[1:])


def _search(frame: Frames, words: Floats, rows: Ints, table: _Table) -> None:
    """Measure the blocks that end in these rows by search."""
    move = motion(frame, words[rows - 1], words[rows])
    way, zero, endless = _chord_of(frame, move), np.zeros(len(rows)), np.full(len(rows), np.inf)
    seen = subtract_chord_motion(move, way, way.length <= POINT)
    twice = _chords(frame, seen, way, zero, way.length).take(np.tile(np.arange(len(rows)), 2))
    low, high = np.concatenate([-endless, zero]), np.concatenate([endless, way.length])
    distance, at_u, proven = farthest(frame, replace(twice, low=low, high=high))
    (line, segment), (u_line, u), bound = np.split(distance, 2), np.split(at_u, 2), proven[len(rows) :]
    place = np.array(to_work(frame, tip(frame, at(move, u))))
    table.put(rows, line=line, u_line=u_line, segment=segment, u_segment=u, bound=bound + allowance(move))
    table.put(rows, axis=swing(frame, move), place=place)


def _chord_of(frame: Frames, move: Motion) -> Chord:
    start, end = (np.array(tip(frame, at(move, np.full_like(move.a, u)))) for u in (0.0, 1.0))
    return chord(start, end)


def _chords(frame: Frames, move: Motion, way: Chord, low: Floats, high: Floats) -> Chords:
    levers = close_levers(frame, move)
    second, third = bending(levers, 2), bending(levers, 3)
    return Chords(move, _columns(way.start), _columns(way.along), low, high, second, third, levers.turn)


def _columns(vector: Floats) -> Vectors:
    return vector[0], vector[1], vector[2]


# --------------------------------------------------------------------------------------------- other measures


def same_u_deviation(
    kinematics: Chain, words: ArrayLike, progress: Progress = silent
) -> tuple[Floats, Floats]:
    """Return the largest distance (m,) mm of the real tip from the point of the chord with the same u, and
    that u; row 0 zero.

    ``words`` (m, 5) mm and **degrees**. It is never less than the segment deviation, and accurate like that.
    """
    rows, frame = check_words(words), frames(kinematics)
    distance, at_u = np.zeros((2, len(rows)))

    def fit(part: slice) -> Ints:
        move, poses = chain_motion(frame, rows[part.start - 1 : part.stop])
        way, nodes, levers = _five_points(frame, move, poses)
        found = bow(replace(way, along=np.zeros_like(way.along)), np.array(tip(frame, nodes)), levers)
        distance[part], at_u[part] = found.distance, found.u
        return np.flatnonzero(~found.proven)

    for part in _yield_left_rows(fit, len(rows), pace_progress(progress)):
        move = motion(frame, rows[part - 1], rows[part])
        way = _chord_of(frame, move)
        zero = np.zeros_like(way.length)
        still = replace(way, along=np.zeros_like(way.along))
        seen = subtract_chord_motion(move, way, np.ones(len(part), np.bool_))
        distance[part], at_u[part], _ = farthest(frame, _chords(frame, seen, still, zero, zero))
    return distance, at_u


def lin_ye_deviation(centre_distance: ArrayLike, step: ArrayLike, beta: ArrayLike = 0.0) -> Floats:
    """Deviation in mid step, mm, of an arc cut with the tool normal to it by one rotary axis (Lin & Ye, eq.
    6).

    ``centre_distance`` mm: from the rotary axis to the **arc's centre** (the paper prints: to the contact
    point, with which its own example does not come out); ``step``, ``beta`` rad: the turn of a step, and
    where on the arc its middle is, 0 where the arc's normal is along the line from the rotary axis to the
    centre. ``e_f R0 |cos beta| / R_A`` with the chord error ``e_f = R_A (1 - cos(step / 2))``: exact at beta
    = 0, of first order in the step elsewhere.
    """
    sagitta = 1.0 - np.cos(0.5 * np.asarray(step, float))
    return np.asarray(np.asarray(centre_distance, float) * sagitta * np.abs(np.cos(np.asarray(beta, float))))
