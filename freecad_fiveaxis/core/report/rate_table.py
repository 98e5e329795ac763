# SPDX-License-Identifier: LGPL-2.1-or-later
"""The second table of blocks, of audits: what each block asks for. One CSV row for every motion block, as in
``blocks_csv``.

The columns of the first table are fixed, for scripts outside; so what an audit adds stands in a table of its
own.

seconds       what the F word means, 0 where no time is known; of rapids by the axes' maximum rates.
tip_feed      mean speed of the tip over the part, mm/min; rate_X ... of each axis, mm/min and deg/min;
              rate_ratio the largest share of an axis' maximum; 0 in rapids.
excess        how far the end words lie beyond the machine's limits, mm or deg: the largest.
off, off_bound   distance off the CL path, or depth of the ball in the part (below 0: clear), mm; 0 where
                 neither is given.
"""

from __future__ import annotations

from freecad_fiveaxis.core.audit import Audit
from freecad_fiveaxis.core.audit.rates import DEGREES
from freecad_fiveaxis.core.base.number_text import table
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.motion.program import Program

from .block_table import block_columns, letter_order, round_up


def rates_header(letters: str) -> str:
    """Return the column names for the machine's ``letters`` (in the order of the words)."""
    rates = ",".join(f"rate_{letters[column]}" for column in letter_order(letters))
    return f"block,line,motion,seconds,tip_feed,{rates},rate_ratio,excess,off,off_bound"


def rates_csv(kinematics: Chain, program: Program, audit: Audit, progress: Progress = silent) -> bytes:
    """Return the whole table as ASCII text, lines ending in a line feed."""
    order, (off, bound) = letter_order(program.letters), audit.off()
    rates = [audit.rates.rate[:, column] * DEGREES[column] for column in order]
    numbers = [
        program.seconds,
        audit.rates.tip_feed,
        *rates,
        audit.rates.ratio,
        audit.limits.excess,
        off + 0.0,
        round_up(bound),
    ]
    parts = block_columns(program, numbers)
    return rates_header(kinematics.letters).encode() + b"\n" + table(parts, progress=progress)
