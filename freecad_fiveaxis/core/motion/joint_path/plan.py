# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the CL path to joints: branch, winding, limits, retract and re-engage.

pole row   a row whose axis is parallel to the first rotary axis. Any first rotary word will do there, so it
           keeps that of the row before until the path needs another; the turn is then made where it harms
           least: on a rapid if there is one, else evenly along the cuts at the pole, or on the longest of
           those that begin or end there.
crossing   a step through the pole. The branch may change there at no cost: the second rotary word passes its
           pole position and changes sides while the first one stays.

Branch and winding come from :mod:`.branches`, the rows that are inserted where no continuous way exists from
:mod:`.rewind`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.chunks import chunks, in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.columns import Matrix, map_vectors, split
from freecad_fiveaxis.core.base.errors import ReachError, SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints, freeze, number_runs
from freecad_fiveaxis.core.base.sentences import Angle, Choice, Length, Option, Point, say
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.machine.kinematics import Chain, RotaryPair, inverse_axis, joint_words
from freecad_fiveaxis.core.motion.short_travel import find_aside, say_remedy_beyond_limit
from freecad_fiveaxis.core.tool.body import Body, Piece
from freecad_fiveaxis.core.toolpath.cl_path import SAFE_MARGIN, CLPath, Motion

from .branches import BETWEEN, POLE_ANGLE, choose, find_broken_steps, within_limits
from .rewind import Drive, insert_rewinds, rewind_findings, subdivide_rapids

POINT = Body((Piece(0.0, 0.0, 0.0, 0.0, 0.0),))
"""A tool of which nothing is known but its ball."""

CROSSING_ANGLE = math.radians(0.1)
"""A step whose axis passes the pole that near (rad) may go through the pole itself; its axis then leaves the
commanded arc by about this angle."""
Blocked = Callable[[Floats, Floats, Floats], Bools]
"""Where (n,) the machine is in its own way with the tip (n, 3) mm and unit axis (n, 3) there at rotary words
(n, 2) rad."""

LINEAR_SLACK = 1e-6
"""Excess over a linear limit (mm) that is rounding, not travel: below any controller's step."""


@dataclass(frozen=True, eq=False)
class JointPath:
    """Words before rounding, one row a block end.

    ``path`` the CL path that is really driven: the one given plus inserted retract, rewind and re-engage
    rows; ``row`` (n,) the row of the given CL path that each row came from (an inserted row has that of the
    row which it leads to); ``q`` (n, 5) words before rounding in the order X Y Z, first rotary, second rotary
    (rotary: nearer to the work first), mm and rad, turns not folded; ``branch`` (n,) 0 or 1; ``sine`` (n,)
    singularity measure, 0 at the pole; ``rewinds``: how often the rotary axes turn back, the tool retracted,
    and ``inside``: of these inside cuts.
    """

    path: CLPath
    row: Ints
    q: Floats
    branch: Bytes
    sine: Floats
    findings: tuple[Finding, ...] = ()
    rewinds: int = 0
    inside: int = 0

    def __post_init__(self) -> None:
        freeze(self, len(self.path.tip), row="i", q="f5", branch="m", sine="f")


def solve(
    path: CLPath, kinematics: Chain, low: Floats, high: Floats, clearance: float, radius: float = 0.0,
    progress: Progress = silent, tool: Body | None = None, blocked: Blocked | None = None,
) -> JointPath:  # fmt: skip
    """Drive ``path`` on the machine with the least rotary travel and the fewest breaks.

    ``low``, ``high`` (3,) mm: the part's box in the work frame; the tool retracts out of it by ``clearance``
    (mm) before it rewinds; ``radius`` mm of the ball, which the rewinds keep off the part too, and ``tool``,
    the body as seen from the driven point (:func:`~freecad_fiveaxis.core.tool.body.lower_body`), None: the
    ball alone. ``blocked``: where the machine is in its own way; there the other branch is taken, where it is
    free. Rotary words may jump on rapids that go above the part; a rapid beside it drives on as a cut does.
    Where no way does without a break, one between two cuts is preferred to one inside a cut.
    Rapids that turn a rotary axis are cut into blocks whose real tip curve stays within half the clearance of
    the chord, and within the safe plane's margin. Each break gives a warning, each linear axis beyond its
    limits an error. Raises ReachError where the machine cannot take up an axis within its rotary limits,
    SettingsError for a clearance that is not positive.
    """
    if not clearance > 0.0:
        raise SettingsError(
            say(
                "clearance {clearance} must be positive: rapids and rewinds need room about the part",
                clearance=Length(clearance, ""),
            ),
            clearance,
        )
    if len(path.tip) == 0:
        return JointPath(path, np.empty(0, np.int64), np.empty((0, 5)), np.empty(0, np.int8), np.empty(0))
    path = _begin_by_rapid(path)
    pole, crossing = find_crossings(path.axis, kinematics.direction[3])
    angles = _angles(kinematics, path.axis, pole)
    fits = _reachable(kinematics, path, angles, pole)
    cutting = ~_above(path, high[2] + clearance)
    between = path.motion[1:] == Motion.LINK

    def choose_words(fits: Bools) -> tuple[Floats, Bytes]:
        low, high = kinematics.low[3:], kinematics.high[3:]
        words, branch = choose(angles, fits, low, high, cutting, crossing, progress)
        if not find_broken_steps(words, branch, cutting, crossing).any():
            return words, branch
        weight = np.where(between, BETWEEN, 1.0) * cutting
        return choose(angles, fits, low, high, weight, crossing, progress)

    words, branch = choose_words(fits)
    if blocked is not None and blocked(path.tip, path.axis, words).any():
        words, branch = choose_words(_free_of_machine(path, angles, fits, blocked))
    _place_turns(path, pole, words, branch)
    _hold_stand_ins(words, kinematics)
    breaks = np.flatnonzero(find_broken_steps(words, branch, cutting, crossing))
    start = Drive(path, np.arange(len(words)), words, branch)
    drive, gaps = insert_rewinds(
        start, kinematics, breaks, np.asarray(low), np.asarray(high), clearance, radius, tool or POINT
    )
    drive = subdivide_rapids(drive, kinematics, min(0.5 * clearance, SAFE_MARGIN))
    progress("joint path", 1.0)
    findings = rewind_findings(start, drive, kinematics, breaks, gaps, cutting, between)
    return replace(
        _finish(drive, kinematics, findings), rewinds=len(breaks), inside=int((~between[breaks]).sum())
    )


def _above(path: CLPath, height: float) -> Bools:
    """Return the steps (n - 1,) that are rapids with both ends at least that high: a tool that swings there
    meets nothing."""
    high = path.tip[:, 2] >= height
    return np.asarray((path.motion[1:] == Motion.RAPID) & high[1:] & high[:-1])


def _begin_by_rapid(path: CLPath) -> CLPath:
    """Where the machine comes from is not known, so the first position counts as reached by a rapid."""
    if path.motion[0] == Motion.RAPID:
        return path
    motion, feed = path.motion.copy(), path.feed.copy()
    motion[0], feed[0] = Motion.RAPID, 0.0
    return replace(path, motion=motion, feed=feed)


def find_crossings(axis: Floats, first: Floats) -> tuple[Bools, Bools]:
    """Which rows (n,) are pole rows, and which steps (n - 1,) are crossings: those whose great arc from axis
    to axis passes the pole, or begins or ends there, within CROSSING_ANGLE. ``first``: direction of the first
    rotary axis.

    In the gnomonic view along ``first`` great arcs are straight: the arc passes the pole where the segment
    from ``across / along`` to the next passes the origin. All is multiplied by both values of ``along``, so
    nothing divides.
    """
    frame: Matrix = [*np.linalg.svd(first[None])[2][1:].tolist(), first.tolist()]
    pole, crossing = np.empty(len(axis), bool), np.empty(len(axis) - 1, bool)

    def fill(rows: slice) -> None:
        x, y, z = (
            np.asarray(column) for column in map_vectors(frame, split(axis[rows.start : rows.stop + 1]))
        )
        square = x * x + y * y
        pole[rows] = square[: rows.stop - rows.start] <= POLE_ANGLE**2
        near = square <= math.sin(CROSSING_ANGLE) ** 2
        at = np.flatnonzero(x[1:] * x[:-1] + y[1:] * y[:-1] < 0.0)
        passed = np.zeros(len(x) - 1, bool)
        passed[at] = _passes_origin(*(column[at + end] for column in (x, y, z) for end in (0, 1)))
        crossing[rows] = passed | near[1:] | near[:-1]

    in_threads(fill, chunks(len(axis)))
    return pole, crossing


def _passes_origin(x0: Floats, x1: Floats, y0: Floats, y1: Floats, z0: Floats, z1: Floats) -> Bools:
    """Of segments that face the origin, those within CROSSING_ANGLE of it."""
    chord = np.hypot(x1 * z0 - x0 * z1, y1 * z0 - y0 * z1)
    facing = (z0 * z1 > 0.0) & (x0 * x1 + y0 * y1 + z0 * z1 > 0.0)
    return np.asarray(facing & (np.abs(x0 * y1 - y0 * x1) <= math.tan(CROSSING_ANGLE) * chord))


def _angles(kinematics: Chain, axis: Floats, pole: Bools) -> Floats:
    """Rotary words (2, n, 2) of both branches, pole rows filled."""
    first = kinematics.direction[3]
    angles, _ = inverse_axis(kinematics, axis)
    rows = np.flatnonzero(pole)
    if len(rows):
        angles[:, rows] = inverse_axis(kinematics, np.copysign(1.0, axis[rows] @ first)[:, None] * first)[0]
        _fill_poles(angles, pole, kinematics)
    return angles


def _fill_poles(angles: Floats, pole: Bools, kinematics: Chain) -> None:
    """Give each pole row the first rotary word of the last row before it that is none; the next one's at the
    beginning."""
    if pole.all():
        angles[:, :, 0] = np.clip(0.0, kinematics.low[3], kinematics.high[3])
        return
    source = np.maximum.accumulate(np.where(pole, int(np.argmin(pole)), np.arange(len(pole))))
    rows = np.flatnonzero(pole)
    angles[:, rows, 0] = angles[:, source[rows], 0]


def _reachable(kinematics: Chain, path: CLPath, angles: Floats, pole: Bools) -> Bools:
    """Which branches (2, n) the rotary limits allow. Raises ReachError where they allow none."""
    fits = within_limits(angles, kinematics.low[3:], kinematics.high[3:])
    lost = np.flatnonzero(~fits.any(0))
    if len(lost):
        lost = (
            lost[~pole[lost]] if not pole[lost].all() else lost
        )  # a pole row only shares the fate of its neighbour
        x, y, z = path.tip[lost[0]]
        i, j, k = path.axis[lost[0]]
        letters = "".join(
            kinematics.letters[column] for column in find_physical_columns(kinematics.letters)[3:]
        )
        if len(letters) < 2:
            text = _too_few_axes(letters, len(lost), len(path.tip), path.tip[lost[0]], path.axis[lost[0]])
            raise ReachError(text, (float(i), float(j), float(k)))
        raise ReachError(
            say(
                "{count} of {all} points need a tool axis that the rotary limits of {letters} do not allow, "
                "the first is {axis} at {place}: widen the limits, lower {max_axis_angle} or take another "
                "machine",
                count=len(lost),
                all=len(path.tip),
                letters=letters,
                axis=f"({i:.6g}, {j:.6g}, {k:.6g})",
                place=Point((x, y, z), ".6g", bare=True),
                max_axis_angle=Option("max_axis_angle"),
            ),
            (float(i), float(j), float(k)),
        )
    return fits


def _free_of_machine(path: CLPath, angles: Floats, fits: Bools, blocked: Blocked) -> Bools:
    """Which branches (2, n) of those that fit are not blocked; both stay where no other is left."""
    free = fits & ~np.array([blocked(path.tip, path.axis, branch) for branch in angles])
    return np.where(free.any(0), free, fits)


def _too_few_axes(letter: str, count: int, all_rows: int, tip: Floats, axis: Floats) -> str:
    i, j, k = axis.tolist()
    given = {
        "count": count,
        "all": all_rows,
        "axis": f"({i:.6g}, {j:.6g}, {k:.6g})",
        "fixed": Choice("tool_axis", ("fixed",)),
    }
    given["place"] = Point(tuple(tip.tolist()), ".6g", bare=True)
    if letter:
        return say(
            "{count} of {all} points need a tool axis that {letter} alone does not reach within its limits, "
            "the first is {axis} at {place}: keep the tool axis along Z ({fixed}), widen the limits or take "
            "a machine with two rotary axes",
            letter=letter,
            **given,
        )
    return say(
        "{count} of {all} points need a leaning tool, the first is {axis} at {place}, and this machine has "
        "no rotary axis: keep the tool axis along Z ({fixed}) or take another machine",
        **given,
    )


def _place_turns(path: CLPath, pole: Bools, words: Floats, branch: Bytes) -> None:
    """Move the turn of each run of pole rows to its best step, or spread it over the cuts along which the
    axis stays at the pole; the travel stays the same. Changes words and branch in place.

    A turn of more than pi that has no rapid stays spread over its steps as it was found: in one step it would
    be a break.
    """
    if not pole.any():
        return
    bounds = np.flatnonzero(np.diff(np.concatenate([[False], pole, [False]]).astype(np.int8))).reshape(-1, 2)
    bounds = bounds[(bounds[:, 0] > 0) & (bounds[:, 1] < len(pole))] - (1, 0)
    if len(bounds) == 0:
        return
    harmless = np.linalg.norm(np.diff(path.tip, axis=0), axis=1)
    harmless[path.motion[1:] == Motion.LINK] = -1.0
    harmless[path.motion[1:] == Motion.RAPID] = math.inf
    best = np.maximum.reduceat(np.append(harmless, 0.0), bounds.ravel())[::2]
    movable = (np.abs(words[bounds[:, 1], 0] - words[bounds[:, 0], 0]) <= math.pi) | (best == math.inf)
    bounds, best = bounds[movable], best[movable]
    fed = np.append(0.0, np.cumsum(np.where(np.isinf(harmless), 0.0, np.maximum(harmless, 0.0))))
    spread = fed[bounds[:, 1] - 1] - fed[bounds[:, 0] + 1] >= best
    _spread_turns(fed, bounds[spread], words, branch)
    _turn_at_once(harmless, bounds[~spread], best[~spread], words, branch)


def _spread_turns(fed: Floats, bounds: Ints, words: Floats, branch: Bytes) -> None:
    """Turn evenly over the length of cut ``fed`` (n,) mm up to each row, between the first and the last pole
    row of runs whose neighbours are ``bounds`` (k, 2): at once the tool would dwell there until the turn is
    made."""
    first, last = bounds.T
    run, row = _rows_between(first, last - 1)
    begin = fed[first + 1]
    share = (fed[row] - begin[run]) / np.maximum(fed[last - 1] - begin, 1e-300)[run]
    one, other = words[first, 0][run], words[last, 0][run]
    words[row, 0], branch[row] = (
        one + share * (other - one),
        branch[np.where(share < 1.0, first[run], last[run])],
    )


def _turn_at_once(harmless: Floats, bounds: Ints, best: Floats, words: Floats, branch: Bytes) -> None:
    """Turn on the first step of each run that is as ``harmless`` (n - 1,) as the ``best`` (k,) of it."""
    first, last = bounds.T
    run, step = _rows_between(first - 1, last - 1)
    chosen = np.full(len(first), len(words))
    at_best = harmless[step] >= best[run]
    np.minimum.at(chosen, run[at_best], step[at_best])
    row, run = step[step > first[run]], run[step > first[run]]
    source = np.where(row <= chosen[run], first[run], last[run])
    words[row, 0], branch[row] = words[source, 0], branch[source]


def _rows_between(first: Ints, last: Ints) -> tuple[Ints, Ints]:
    """Return the runs (m,) and rows (m,) behind ``first`` (k,) up to and with ``last`` (k,)."""
    run, number = number_runs(last - first)
    return run, first[run] + 1 + number


def _hold_stand_ins(angles: Floats, kinematics: Chain) -> None:
    """Rotary axes that the machine has not stay at 0; what a tool axis leans about them is within the print
    of CL files."""
    for k, axis in enumerate(kinematics.axes[3:]):
        if not axis.fitted:
            angles[:, k] = 0.0


def _finish(drive: Drive, kinematics: Chain, findings: tuple[Finding, ...]) -> JointPath:
    _hold_stand_ins(drive.angles, kinematics)
    q = joint_words(kinematics, drive.path.tip, drive.angles)
    if np.isnan(q[:, :3].min()):
        lost = np.flatnonzero(np.isnan(q[:, :3]).any(1))
        first, second = np.degrees(drive.angles[lost[0]])
        raise ReachError(
            say(
                "the linear axes lie in one plane at {letter} {first} {other} {second} and cannot place the "
                "tip ({count} rows): lower {max_axis_angle} or take another machine",
                letter=kinematics.letters[3],
                first=Angle(first, ".3f", bare=True),
                other=kinematics.letters[4],
                second=Angle(second, ".3f"),
                count=len(lost),
                max_axis_angle=Option("max_axis_angle"),
            ),
            (float(first), float(second)),
        )
    findings += _limit_findings(drive.path, kinematics, q)
    pair = RotaryPair.of(kinematics.direction[3], kinematics.direction[4])
    sines = in_threads(lambda rows: pair.reach * np.abs(np.sin(q[rows, 4] - pair.best)), chunks(len(q)))
    return JointPath(drive.path, drive.row, q, drive.branch, np.concatenate(sines), findings)


def _limit_findings(path: CLPath, kinematics: Chain, q: Floats) -> tuple[Finding, ...]:
    """Return an error for each linear axis that the path drives beyond its limits, with the worst place."""
    findings = []
    for axis in range(3):
        for sign, limit in ((-1.0, float(kinematics.low[axis])), (1.0, float(kinematics.high[axis]))):
            worst = int(q[:, axis].argmax() if sign > 0.0 else q[:, axis].argmin())
            if sign * (q[worst, axis] - limit) > LINEAR_SLACK:
                count = int((sign * (q[:, axis] - limit) > LINEAR_SLACK).sum())
                text = say(
                    "{letter} would have to go to {word}, its limit is {limit} ({count} rows): {remedy}",
                    letter=kinematics.letters[axis],
                    word=Length(q[worst, axis], ".4f"),
                    limit=Length(limit, ".4f"),
                    count=count,
                    remedy=say_remedy_beyond_limit(
                        kinematics.letters[axis],
                        q[:, axis],
                        float(kinematics.low[axis]),
                        float(kinematics.high[axis]),
                        find_aside(kinematics, path.tip),
                    ),
                )
                x, y, z = path.tip[worst].tolist()
                findings.append(
                    report_finding(
                        Code.LIMIT, text, float(q[worst, axis]), limit, worst, place=(x, y, z), unit="mm"
                    )
                )
    return tuple(findings)
