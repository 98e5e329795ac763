# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feeds of a CL file: per minute in any unit, or per turn of the spindle."""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from .source import Source
from .statements import Kind, Statements


def hold_last(at: Ints, value: Floats, first: float, rows: Ints) -> Floats:
    """Return the value of the last event at or before each row; ``at`` (e,) rises; ``first`` before all of
    them."""
    return np.concatenate([[first], value])[np.searchsorted(at, rows, side="right")]


def read_feeds(statements: Statements, scale: Floats, source: Source) -> tuple[Ints, Floats]:
    """Return the rows of ``statements`` with a FEDRAT, and the feeds in mm/min; ``scale`` mm of the unit at
    each statement. Raises ProgramError for a feed per turn of no spindle."""
    at = statements.of(Kind.FEED)
    return at, per_minute(
        statements, at, statements.value(at), statements.unit(at), statements.turn(at), scale, source
    )


def per_minute(
    statements: Statements, at: Ints, value: Floats, unit: Floats, turn: Bools, scale: Floats, source: Source
) -> Floats:
    """mm/min (k,) of the feeds ``value`` that the rows ``at`` of ``statements`` say, in mm of their ``unit``
    (NaN: the file's), some per ``turn``. Raises ProgramError."""
    spindle = statements.of(Kind.SPINDLE)
    speed = statements.value(spindle)
    going = ~np.isnan(speed)
    turns = hold_last(statements.statement[spindle[going]], speed[going], 0.0, statements.statement[at])
    lost = np.flatnonzero(turn & ~(turns > 0.0))
    if len(lost):
        k = int(statements.statement[at[lost[0]]])
        source.fail(
            k, "", say("a feed per turn needs the spindle speed; say SPINDL/ before, or give it per minute")
        )
    with np.errstate(over="ignore"):  # the machine's greatest feed is below any of these
        return np.asarray(value * np.where(np.isnan(unit), scale[at], unit) * np.where(turn, turns, 1.0))
