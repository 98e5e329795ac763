# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the moves of a CL file put the tool: the numbers of all of them at once.

carrier   a statement that says the tool axis: a GOTO of six numbers, or TLAXIS. It holds until the next.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, say

from .source import SOFT, Source
from .vocabulary import MOTIONS, NUMBER

MOST = 7
"""One number more than any move has."""
FARTHEST = 1e7
"""mm; no part is as large, and beyond some power of ten nothing can be computed."""


@dataclass(frozen=True, eq=False)
class Moves:
    """The numbers of each move as printed: ``point`` (n, 3) a place or a step (``step`` (n,) True; one
    number: along the axis, first column, ``along`` (n,) True); ``axis`` (n, 3) of each, carried on where it
    has none; ``full`` (n,) it has one."""

    point: Floats
    step: Bools
    along: Bools
    axis: Floats
    full: Bools

    def take(self, rows: Bools) -> Moves:
        """Return some of the moves, with the axes that they have."""
        return Moves(self.point[rows], self.step[rows], self.along[rows], self.axis[rows], self.full[rows])


def read_moves(source: Source, turned_at: Ints, turned: Floats) -> Moves:
    """Return the moves, with the axes that TLAXIS says: statement ``turned_at`` (t,), ``turned`` (t, 3).
    Raises ProgramError."""
    at = source.move_at
    if not len(at):
        raise ProgramError(say("line 1, column 1: the CL file holds no GOTO statement"), None)
    begin, allowed = source.begin[at].copy(), np.zeros((len(at), MOST + 1), np.bool_)
    for word, counts in MOTIONS.items():
        rows = source.move_rows(word)
        begin[rows] += len(word)
        allowed[rows[:, None] & np.isin(np.arange(MOST + 1), counts)] = True
    chosen = source.take_lines(begin, source.end[at])
    commas = np.searchsorted(np.flatnonzero(chosen == ord(",")), np.flatnonzero(chosen == ord("\n")))
    count = np.diff(commas, prepend=0) + 1
    value = _floats(chosen)
    right = allowed[np.arange(len(at)), np.minimum(count, MOST)]
    if value is None or len(value) != count.sum() or not right.all():
        _explain(source)
    return _sort_out_moves(value, count, source, turned_at, turned)


def _sort_out_moves(value: Floats, count: Ints, source: Source, turned_at: Ints, turned: Floats) -> Moves:
    first, full = np.cumsum(count) - count, count == 6
    along = count == 1
    point = value[np.minimum(first[:, None] + (0, 1, 2), len(value) - 1)]
    point[along, 1:] = 0.0
    own = value[first[full][:, None] + (3, 4, 5)]
    carrier = np.concatenate([[-1], source.move_at[full], turned_at])
    stated = np.concatenate([[(0.0, 0.0, 1.0)], own, turned])
    order = np.argsort(carrier, kind="stable")
    last = np.searchsorted(carrier[order], source.move_at, side="right") - 1
    return Moves(point, source.move_rows(b"GODLTA/"), along, stated[order][last], full)


def places(moves: Moves, unit: Floats, scale: Floats, source: Source) -> Floats:
    """Return the driven points (n, 3) mm, steps added up; ``unit`` (n, 3) the axes, ``scale`` (n,) mm. Raises
    ProgramError."""
    with np.errstate(over="ignore"):
        point: Floats = moves.point * scale[:, None]
    _refuse_far(point, source)
    if not moves.step.any():
        return point
    rows = np.arange(len(point))
    anchor = np.maximum.accumulate(np.where(moves.step, -1, rows))
    if anchor[0] < 0:
        source.fail(
            int(source.move_at[0]), "", say("GODLTA stands before the first GOTO: from where is not known")
        )
    point[moves.along] = point[moves.along, :1] * unit[moves.along]
    travelled = np.cumsum(np.where(moves.step[:, None], point, 0.0), axis=0)
    summed: Floats = point[anchor] + (travelled - travelled[anchor])
    _refuse_far(summed, source)
    return summed


def _refuse_far(point: Floats, source: Source) -> None:
    far = np.abs(point).max(axis=1) > FARTHEST
    if far.any():
        reason = say("a place or step beyond {farthest}; is it in another unit?", farthest=Length(FARTHEST))
        source.fail(int(source.move_at[far.argmax()]), "", reason)


def _floats(chosen: NDArray[Any]) -> Floats | None:
    """All numbers of the moves; None where there is something else among them."""
    text = chosen.tobytes().replace(SOFT, b"").replace(b"\n", b",")
    if text.translate(None, b"0123456789+-.E,"):
        return None
    code = np.frombuffer(text, np.uint8)
    after_comma = np.concatenate([[0], np.flatnonzero(code == ord(","))[:-1] + 1])
    if not np.add.reduceat(code - np.uint8(ord("0")) < 10, after_comma, dtype=np.int32).all():
        return None  # a field without a digit
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)  # numpy's way to say that it stopped early
        try:
            value = np.fromstring(text.replace(b",", b" "), np.float64, sep=" ")
        except (DeprecationWarning, ValueError):
            return None
    return value if np.isfinite(value).all() else None


def _explain(source: Source) -> NoReturn:
    """Find the move that cannot be read, and say why."""
    for k in source.move_at:
        word, _, rest = source.statement(k).partition("/")
        parts = rest.split(",")
        for part in parts:
            if not NUMBER.fullmatch(part) or not np.isfinite(float(part)):
                source.fail(k, part, say("{part} is no number", part=repr(part[:40])))
        if len(parts) not in MOTIONS[word.encode() + b"/"]:
            source.fail(k, "", say("{word} has {count} numbers; give 3 or 6", word=word, count=len(parts)))
    raise ProgramError(say("line 1, column 1: the GOTO statements cannot be read"), None)
