# SPDX-License-Identifier: LGPL-2.1-or-later
"""The F words of a program and what they mean: mm a minute (G94), one over minutes (G93), mm a turn (G95)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats
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
    """One row a motion line, (m,): ``feed`` in force, mm/min, mm a turn or 1/min; whether it is of
    ``inverse`` time, and ``per_turn``."""

    feed: Floats
    inverse: Bools
    per_turn: Bools


def find_feeds(source: Source, motions: Moves) -> tuple[Feeds, list[Finding]]:
    """Return what F is in the motion lines, and where there is none."""
    lines, at, feeding = source.lines, motions.at, motions.mode != codes.RAPID
    mode, inch, column = lines.mode(codes.FEED_MODE, 0), lines.inch(source.grammar), lines.column("F")
    given = np.flatnonzero(~np.isnan(column))
    as_written = column.copy()
    column[given] *= np.where(inch[given] & (mode[given] != codes.INVERSE), INCH, 1.0)
    last = last_of(given, lines.count)
    changed = last_of(np.flatnonzero(np.diff(mode, prepend=mode[:1])), lines.count)
    valid = (last > 0) & (last >= changed)  # an F word dies with its feed mode
    feed = np.where(valid[at] & feeding, column[last[at]], 0.0)
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
    return Feeds(np.where(feed > 0.0, feed, 0.0), inverse, mode[at] == codes.PER_TURN), found
