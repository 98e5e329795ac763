# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks over tolerance, divided into the fewest that hold it.

divide    a block into pieces whose ends stand on the commanded chord, with the tool axis on the great arc
          between the commanded end axes (``moves``).
held      every piece's real path is proven to stay within the tolerance of the commanded segment and of its
          own, with the words as rounded for the controller (``proof``).
fewest    found for all pieces of all blocks at once (``division``).

Feed blocks are divided, rapids never. What is within the tolerance stays one block.

above     what makes the surface is not the tip: where the axis swings while the tip runs straight, a ball's
          centre bulges off. A path can so be divided by a point above the tip: it is led by the chain whose
          driven point that is (``raise_chain``), and the words are shifted back.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.number_text import round_as_printed
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.controllers.dialect import Dialect
from freecad_fiveaxis.core.machine.kinematics import (
    Chain,
    RotaryPair,
    branch_of,
    forward,
    forward_tip,
    lift_of,
    raise_chain,
    words_to_q,
)
from freecad_fiveaxis.core.motion.deviation import quick_bound
from freecad_fiveaxis.core.motion.joint_path import JointPath
from freecad_fiveaxis.core.motion.trajectory import check_words, frames
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .commanded_moves import CommandedMoves, Steps, compute_commanded_moves, most_off, place_words, tool_axis
from .division import Divided, divide
from .findings import Outcome, report_division
from .halving import halve_blocks, promising
from .proof import judge_pieces, off_points

CHUNK = 8192
"""Blocks judged at a time."""

PORTION = 32768
"""Pieces aimed at in a portion of blocks that are divided together."""

LIMIT_SPARE, LIMIT_FACTOR = 64, 8.0
"""A block may be divided into so many pieces, and so many times what its quick bound asks for: far more than
any move needs whose words stay finite."""


def linearize(
    joints: JointPath,
    kinematics: Chain,
    dialect: Dialect,
    tolerance: float,
    wanted: Bools | None = None,
    progress: Progress = silent,
    above: float = 0.0,
) -> JointPath:
    """Return the joint path with every feed block that is over ``tolerance`` (mm) divided into the fewest
    that hold it.

    ``wanted`` (n,): only the blocks that end in these rows may be divided; None: all. Rapids never are.
    ``above`` (mm): the point that holds the tolerance stands so far above the driven one along the tool axis,
    as a ball's centre above the tip.

    The commanded segments of that point are between the rows of the CL path. Inserted rows carry motion,
    feed, pass and ``row`` of the row that they lead to; all words are returned as ``dialect`` rounds them,
    the linear ones worked out for the rounded rotary ones, so that the point is in every row within the
    rounding of the linear words of its place. Findings say how many blocks were divided, and what could not
    be held; the path's own keep their blocks. Raises SettingsError for a tolerance that is no number above 0.
    """
    _check(tolerance)
    steps = Steps(dialect.linear_decimals, dialect.rotary_decimals, dialect.unit)
    feeds = joints.path.motion != Motion.RAPID
    rows = np.flatnonzero((feeds if wanted is None else feeds & wanted)[1:]) + 1
    way = _divide_above(joints, kinematics, above, rows, tolerance, steps, progress)
    q = words_to_q(way.words)
    pair = RotaryPair.of(kinematics.direction[3], kinematics.direction[4])
    sine = np.asarray(pair.reach * np.abs(np.sin(q[:, 4] - pair.best)))
    branch = joints.branch[way.row].copy()
    branch[way.new] = branch_of(kinematics, q[way.new, 4])
    findings = (
        *_move_findings(joints.findings, way),
        *report_division(kinematics, way.outcome, way.words, way.new, steps, tolerance),
    )
    return JointPath(
        _longer(joints.path, way, above), joints.row[way.row], q, branch, sine, findings, joints.rewinds
    )


def _divide_above(
    joints: JointPath,
    kinematics: Chain,
    above: float,
    rows: Ints,
    tolerance: float,
    steps: Steps,
    progress: Progress,
) -> _DividedPath:
    """Divide the blocks that end in ``rows`` by the point ``above`` mm over the driven one; the words are
    those of the driven point. Its lift is rounded as the words are, so that none of them is rounded twice."""
    if above == 0.0:
        tip, angles = joints.path.tip, joints.q[:, 3:]
        words = place_words(kinematics, tip, angles, steps)
        return _divide_blocks(kinematics, tip, angles, words, rows, tolerance, steps, progress)
    lift = lift_of(kinematics, above, steps.linear)
    upper, q = raise_chain(kinematics, lift), joints.q + np.append(lift, (0.0, 0.0))
    tip = forward_tip(upper, q)
    words = place_words(upper, tip, q[:, 3:], steps)
    way = _divide_blocks(upper, tip, q[:, 3:], words, rows, tolerance, steps, progress)
    linear = round_as_printed(way.words[:, :3] - lift, steps.linear)
    return replace(way, words=np.concatenate([linear, way.words[:, 3:]], axis=1))


def linearize_words(
    kinematics: Chain, words: ArrayLike, decimals: tuple[int, int], tolerance: float,
    feeds: Bools | None = None,
    progress: Progress = silent,
) -> tuple[Floats, Ints, tuple[Finding, ...]]:  # fmt: skip
    """Return the words of a program with every block that is over ``tolerance`` (mm) divided into the fewest
    that hold it.

    ``words`` (m, 5) mm and **degrees**, turns not folded; ``decimals`` of linear and of rotary words;
    ``feeds`` (m,): the blocks that may be divided, None: all. Returns the words (k, 5), the row (k,) of
    ``words`` that each leads to, and findings. Raises ProgramError for words that cannot be used,
    SettingsError for a tolerance that is no number above 0.
    """
    _check(tolerance)
    rows, steps = check_words(words), Steps(*decimals)
    q = words_to_q(rows)
    tip = forward(kinematics, q)[0]
    grid = np.stack(
        [round_as_printed(rows[:, k], steps.linear if k < 3 else steps.rotary) for k in range(5)], axis=1
    )
    placed = place_words(kinematics, tip, q[:, 3:], steps)
    stay = np.any(np.isnan(placed), axis=1) | np.all(np.abs(grid - rows) < SAME_WORD, axis=1)
    feed = np.flatnonzero(np.ones(len(rows), bool) if feeds is None else feeds)
    way = _divide_blocks(
        kinematics,
        tip,
        q[:, 3:],
        np.where(stay[:, None], grid, placed),
        feed[feed > 0],
        tolerance,
        steps,
        progress,
    )
    return way.words, way.row, report_division(kinematics, way.outcome, way.words, way.new, steps, tolerance)


SAME_WORD = 1e-9
"""mm or deg: words that differ by less from rounded ones are rounded ones."""


def _check(tolerance: float) -> None:
    if not 0.0 < tolerance < math.inf:
        raise SettingsError(
            say(
                "tolerance is {tolerance}; blocks can be divided for a tolerance above 0 only",
                tolerance=Length(tolerance),
            ),
            tolerance,
        )


@dataclass(frozen=True, eq=False)
class _DividedPath:
    """Rows (k,) of the divided path: ``row`` of the given path that each leads to, ``share`` of that row's
    block (1 for the row itself), ``words`` (k, 5) mm and degrees, ``axis`` (k, 3) of inserted rows, which are
    ``new`` (i,), as on their moves."""

    row: Ints
    share: Floats
    words: Floats
    axis: Floats
    new: Ints
    outcome: Outcome


def _divide_blocks(
    kinematics: Chain,
    tip: Floats,
    angles: Floats,
    words: Floats,
    rows: Ints,
    tolerance: float,
    steps: Steps,
    progress: Progress,
) -> _DividedPath:
    """Divide the blocks that end in ``rows`` where they are over tolerance, but for those that rounding alone
    keeps over it."""
    over, deviation, held = _over(kinematics, tip, words, rows, tolerance)
    count, even = np.ones(len(over), np.int64), np.zeros(len(over), np.bool_)
    todo = np.flatnonzero(held > max(tolerance, most_off(kinematics, steps)))
    bound = quick_bound(kinematics, words)[over] if len(todo) else held
    parts: list[_Part] = []
    load = np.cumsum(np.sqrt(deviation[todo] / tolerance) + 2.0) // PORTION
    for part in np.split(todo, np.flatnonzero(np.diff(load)) + 1) if len(todo) else []:
        progress("linearize", float(part[0]) / len(over))
        limit = (LIMIT_SPARE + LIMIT_FACTOR * np.sqrt(bound[part] / tolerance)).astype(np.int64)
        way = compute_commanded_moves(kinematics, tip, angles, words, over[part])
        divided, even[part] = _of_portion(kinematics, way, deviation[part], limit, tolerance, steps)
        count[part], held[part] = divided.pieces.count, divided.pieces.held
        parts.append(divided)
    progress("linearize", 1.0)
    return _weave_rows(words, Outcome(over, count, held, even), parts)


def _over(
    kinematics: Chain, tip: Floats, words: Floats, rows: Ints, tolerance: float
) -> tuple[Ints, Floats, Floats]:
    """Which blocks, that end in ``rows``, are not proven to be within tolerance (b,), how far they are out at
    least (b,) mm, and what is proven of them (b,) mm, rounding included."""
    frame, over, out, proven = frames(kinematics), [np.empty(0, np.int64)], [np.empty(0)], [np.empty(0)]
    wanted = np.zeros(len(words), bool)
    wanted[rows] = True
    off = off_points(frame, words, tip)
    for first in range(0, len(words) - 1, CHUNK):
        part = slice(first, min(first + CHUNK, len(words) - 1) + 1)
        inside = wanted[part][1:]
        judged = judge_pieces(frame, words[part], inside, off[part], np.full(len(inside), tolerance))
        at = np.flatnonzero(inside & ~(judged.most + judged.off <= tolerance))
        over.append(first + 1 + at)
        out.append(judged.least[at])
        proven.append((judged.most + judged.off)[at])
    return np.concatenate(over), np.concatenate(out), np.concatenate(proven)


@dataclass(frozen=True, eq=False)
class _Part:
    """A portion of blocks as divided, and the tool axis (r, 3) at the rows between pieces."""

    pieces: Divided
    axis: Floats


def _of_portion(
    kinematics: Chain, way: CommandedMoves, deviation: Floats, limit: Ints, tolerance: float, steps: Steps
) -> tuple[_Part, Bools]:
    """Divide a portion of blocks. Those that cannot be divided along their arcs as close as is asked get even
    rotary words where these hold more, those in doubt are compared with halving. Also: which are even."""
    goal = max(tolerance, most_off(kinematics, steps))
    pieces = divide(kinematics, way, deviation, limit, goal, steps)
    again = np.flatnonzero((pieces.goal > goal) & ~way.even)
    if len(again):
        evenly = way.take(again)
        evenly = replace(evenly, even=np.ones(len(again), np.bool_))
        others = divide(kinematics, evenly, deviation[again], limit[again], goal, steps)
        closer = np.flatnonzero((others.goal < pieces.goal[again]) | np.isinf(pieces.goal[again]))
        even = way.even.copy()
        even[again[closer]] = True
        way, pieces = replace(way, even=even), pieces.with_others(again[closer], others.take(closer))
    doubt = promising(pieces, np.flatnonzero(pieces.doubt)) if pieces.doubt.any() else np.empty(0, np.int64)
    if len(doubt):
        other = halve_blocks(kinematics, way.take(doubt), pieces.count[doubt], pieces.goal[doubt], steps)
        fewer = np.flatnonzero(np.isfinite(other.goal))
        pieces = pieces.with_others(doubt[fewer], other.take(fewer))
    block = np.repeat(np.arange(len(pieces.count)), pieces.count - 1)
    return _Part(pieces, tool_axis(kinematics, way, block, pieces.share)), way.even


def _weave_rows(words: Floats, outcome: Outcome, parts: list[_Part]) -> _DividedPath:
    """Return the given rows and the inserted ones, each before the row that its block ends in."""
    pieces = np.ones(len(words), np.int64)
    pieces[outcome.row] = outcome.count
    row = np.repeat(np.arange(len(words)), pieces)
    share, all_words, axis = np.ones(len(row)), words[row], np.zeros((len(row), 3))
    own = np.zeros(len(row), bool)
    own[np.cumsum(pieces) - 1] = True
    new = np.flatnonzero(~own)
    for target, name in ((share, "share"), (all_words, "words")):
        target[new] = np.concatenate([getattr(part.pieces, name) for part in parts]) if parts else target[new]
    axis[new] = np.concatenate([part.axis for part in parts]) if parts else axis[new]
    return _DividedPath(row, share, all_words, axis, new, outcome)


def _move_findings(findings: tuple[Finding, ...], way: _DividedPath) -> Iterator[Finding]:
    """Yield the findings of the given path, each at the row that its own has become."""
    own = np.flatnonzero(way.share == 1.0)
    for finding in findings:
        yield finding if finding.block is None else replace(finding, block=int(own[finding.block]))


def _longer(path: CLPath, way: _DividedPath, above: float) -> CLPath:
    """Return the CL path with the inserted rows. Those that cut touch the part between their neighbours, the
    others nothing. The point ``above`` mm over the tip goes straight."""
    columns: dict[str, Any] = {name: getattr(path, name)[way.row] for name in _CL_COLUMNS}
    new, share = way.new, way.share[way.new][:, None]
    end = way.row[new]
    cuts = (path.motion[end] < Motion.LINK)[:, None]
    point = path.tip + above * path.axis if above else path.tip
    tip, contact, normal = (
        v[end - 1] + share * (v[end] - v[end - 1]) for v in (point, path.contact, path.normal)
    )
    tip = tip - above * way.axis[new] if above else tip
    length = np.sqrt((normal * normal).sum(axis=1))[:, None]
    normal = np.where(length > 0.0, normal / np.where(length > 0.0, length, 1.0), path.normal[end])
    columns["tip"][new], columns["axis"][new] = tip, way.axis[new]
    columns["contact"][new], columns["normal"][new] = (
        np.where(cuts, contact, tip),
        np.where(cuts, normal, way.axis[new]),
    )
    return replace(path, **columns)


_CL_COLUMNS = ("tip", "axis", "motion", "feed", "contact", "normal", "face", "coedge", "pass_")
