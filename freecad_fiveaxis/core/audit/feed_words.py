# SPDX-License-Identifier: LGPL-2.1-or-later
"""F words that are larger than the controller takes.

G93   one over the minutes of a block: short blocks have large words. Fanuc takes 0.001 to 9999.999
      (Operator's manual B-62764EN, 5 Feed functions, inverse time feed); what the others take stands in their
      tables (core/controllers).
line  an arc is many blocks of one line here, and has one F there: the time of the whole line counts.
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Number, plural
from freecad_fiveaxis.core.controllers import Dialect
from freecad_fiveaxis.core.motion.program import Program, feed_blocks

ROUNDING = 1e-6
"""Of F as it comes out of a block's time, as a share of it."""


def large_feeds(program: Program, dialect: Dialect) -> tuple[Finding, ...]:
    """Return a warning for each feed mode in which lines of the program have an F above the controller's
    largest."""
    blocks = feed_blocks(program)
    inverse: Bools = program.inverse_time[blocks]
    modes = (
        (dialect.inverse_time, "1/min", dialect.largest_inverse, *_of_lines(program, blocks[inverse])),
        (
            dialect.per_minute,
            "mm/min",
            dialect.largest_feed,
            blocks[~inverse],
            program.feed[blocks[~inverse]],
        ),
    )
    found = (_over(program, dialect, *mode) for mode in modes)
    return tuple(one for one in found if one is not None)


def _of_lines(program: Program, blocks: Ints) -> tuple[Ints, Floats]:
    """Return the first block (k,) of each line that has ``blocks`` under G93, and its F (k,): one over the
    minutes of all of them."""
    if not len(blocks):
        return blocks, np.zeros(0)
    first = np.flatnonzero(np.append(True, np.diff(program.line[blocks]) != 0))
    seconds = np.add.reduceat(program.seconds[blocks], first)
    return blocks[first], np.divide(60.0, seconds, out=np.zeros(len(first)), where=seconds > 0.0)


def _over(
    program: Program, dialect: Dialect, mode: str, unit: str, largest: float, blocks: Ints, feed: Floats
) -> Finding | None:
    rows = np.flatnonzero(feed > largest * (1.0 + ROUNDING))
    if not len(rows):
        return None
    worst = int(rows[feed[rows].argmax()])
    block, line = int(blocks[worst]), int(program.line[blocks[worst]])
    text = plural(
        len(rows),
        "NC line {line} has F{feed}, and {name} takes F{most} at most under {mode}: it refuses the line. "
        "Post the program with longer blocks, or with a lower F.",
        "{count} NC lines have an F above {most}, the largest that {name} takes under {mode}, the largest "
        "in line {line}, F{feed}: it refuses them. Post the program with longer blocks, or with a lower F.",
        line=line, feed=Number(float(feed[worst]), ".10g"), name=dialect.name, most=Number(largest, ".10g"),
        mode=mode or unit,
    )  # fmt: skip
    return report_finding(Code.FEED_WORD_TOO_LARGE, text, float(feed[worst]), largest, block, line, unit=unit)
