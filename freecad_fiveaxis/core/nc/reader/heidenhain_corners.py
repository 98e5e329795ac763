# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext's roundings and chamfers, which stand in lines of their own, as private words of the move before
(:mod:`.corners`).

RND R5   an arc of that radius between the move before and the one after.
CHF 2    a chamfer so far from the corner on both lines (TNC 620, Klartext Programming: chamfer side length).

Their F counts for the corner alone: it changes no place, and is not read.
"""

from __future__ import annotations

import re

from .corners import BEYOND, LETTER

SIGN = re.compile(rb"(?<![A-Z])(?:RND|CHF)(?![A-Z])")
CORNER = re.compile(
    rb" *(?:/ *)?(?:[0-9]+ +)?(?:RND *R|(CHF)) *\+?([0-9]+\.?[0-9]*|\.[0-9]+)"
    rb"(?: *F *(?:MAX|AUTO|[0-9.]+))? *"
)
MOVE = re.compile(rb" *(?:/ *)?(?:[0-9]+ +)?(?:L|CR?) +I?[XYZ] *[-+.0-9]")


def mark_corners(text: bytes) -> bytes:
    """Return the text with each corner in the line of the move before; one that does not stand between two
    moves, or has no plain number, stays as it is."""
    if not SIGN.search(text):
        return text
    rows = text.split(b"\n")
    solid = [at for at, row in enumerate(rows) if row.strip()]
    for before, at, behind in zip(solid, solid[1:], solid[2:], strict=False):
        if (found := CORNER.fullmatch(rows[at])) and _between(rows[before], rows[behind]):
            size = float(found[2])
            if 0.0 < size < BEYOND:
                rows[before] += b" %c%.6f" % (ord(LETTER), -size if found[1] else size)
                rows[at] = b""
    return b"\n".join(rows)


def _between(before: bytes, behind: bytes) -> bool:
    """Whether both lines are moves, and the first has no corner yet."""
    return bool(MOVE.match(before) and MOVE.match(behind)) and LETTER.encode() not in before
