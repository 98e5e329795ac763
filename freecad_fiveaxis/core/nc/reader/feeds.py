# SPDX-License-Identifier: LGPL-2.1-or-later
"""The F words of a program and what they mean: mm a minute (G94), one over minutes (G93), mm a turn (G95).

inches   F is in inches a minute; on Heidenhain's in tenths of an inch a minute (TNC7 user's manual, *Cutting
         data*; its programming station, as others have published, gives F100 of such a program as 254
         mm/min).
degrees  where rotary axes move alone F is in degrees a minute, in a program in inches too (NIST RS274NGC 3,
         2.1.2.5; LinuxCNC's emccanon.cc). Where it is measured over all axes (Fanuc B-63324EN, 4.3), a degree
         counts as the unit of length that F counts; not looked up in a manual for Heidenhain's.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Template

from . import codes
from .codes import INCH
from .lines import last_of
from .positions import Moves
from .source import Source

NO_FEED = (
    Template("1 block has no F above 0 in force; most controllers stop there. Give F."),
    Template("{count} blocks have no F above 0 in force; most controllers stop there. Give F."),
)
NO_INVERSE_FEED = (
    Template("1 block under G93 has no F of its own; most controllers stop there. Give F in every block."),
    Template(
        "{count} blocks under G93 have no F of their own; most controllers stop there. Give F in every block."
    ),
)


NOT_KNOWN = -1.0
"""The F of a feed that only a Heidenhain control knows; a finding of the text's words has said so."""


class Feeds(NamedTuple):
    """One row a motion line, (m,): ``feed`` in force, mm/min (deg/min where rotary axes move alone), mm a
    turn or 1/min; whether it is of ``inverse`` time, and ``per_turn``; ``unit``: the mm that F counts a
    degree as."""

    feed: Floats
    inverse: Bools
    per_turn: Bools
    unit: Floats


def find_feeds(source: Source, motions: Moves) -> tuple[Feeds, list[Finding]]:
    """Return what F is in the motion lines, and where there is none."""
    lines, at, feeding = source.lines, motions.at, motions.mode != codes.RAPID
    mode, column = lines.mode(codes.FEED_MODE, 0), lines.column("F")
    given = np.flatnonzero(~np.isnan(column))
    as_written, unit = column.copy(), np.where(mode == codes.INVERSE, 1.0, _find_units(source, mode))
    column[given] *= unit[given]
    last = last_of(given, lines.count)
    changed = last_of(np.flatnonzero(np.diff(mode, prepend=mode[:1])), lines.count)
    valid = (last > 0) & (last >= changed)  # an F word dies with its feed mode
    feed = np.where(valid[at] & feeding, column[last[at]], 0.0)
    unit = unit[last[at]]
    if not source.grammar.inch_degrees:
        unit = np.ones(len(at))
    elif source.grammar.name != "siemens":  # there by what FGROUP names
        feed = np.where(_turns_alone(motions), feed / unit, feed)
    inverse: Bools = mode[at] == codes.INVERSE
    own = last[at] == at
    hidden = (source.grammar.name == "heidenhain") & valid[at] & (as_written[last[at]] == NOT_KNOWN)
    cases = (
        (feeding & ~(feed > 0.0) & ~hidden, Code.NO_FEED, NO_FEED),
        (feeding & inverse & ~own & (feed > 0.0), Code.INVERSE_FEED_MISSING, NO_INVERSE_FEED),
    )
    found = [
        report_finding(
            code,
            texts[int(rows.sum() > 1)].say(count=int(rows.sum())),
            block=int(rows.argmax()),
            line=int(at[rows.argmax()]),
        )
        for rows, code, texts in cases
        if rows.any()
    ]
    return Feeds(np.where(feed > 0.0, feed, 0.0), inverse, mode[at] == codes.PER_TURN, unit), found


def _find_units(source: Source, mode: Ints) -> Floats:
    """Return the mm (lines,) that F counts in each line."""
    per_minute = np.where(mode == codes.PER_MINUTE, source.grammar.inch_feed, INCH)
    return np.where(source.lines.inch_feed(source.grammar), per_minute, 1.0)


def _turns_alone(motions: Moves) -> Bools:
    """Return the motion lines (m,) in which X Y Z stay, but no full circle."""
    stay = (motions.before[:, :3] == motions.programmed[:, :3]).all(axis=1)
    return np.asarray(stay & (motions.mode != codes.ARC))
