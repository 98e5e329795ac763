# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sequence numbers of punched cards, which CATIA and older processors still print in columns 73 to 80.

Nothing in a file says that it has them, and a file without may use these columns for its statements. They are
taken for sequence numbers only where every longer line has a number there, behind at most a few letters, that
counts up; where none of these lines would end in the middle of a statement without it. Right behind a digit,
where they might be its decimals, they must fill all eight columns, in steps that cards have, on three lines
at least.
"""

from __future__ import annotations

import re

import numpy as np

from .vocabulary import FREE_TEXT

COLUMNS, CARD = 72, 80
NUMBERED = re.compile(rb"([A-Z]{0,5}) *(\d{1,8})")
TEXT = re.compile(rb"[ ]*(?:\$\$|" + "|".join(FREE_TEXT).encode() + rb")")
"""Lines that are no statements."""
STEP = 1000
"""Cards are numbered in no greater steps."""
FEWEST = 3
"""Lines, where digits stand before the numbers."""
OPEN = (b",", b"/", b"(")
"""A statement does not end so."""


def without_sequence_numbers(text: bytes) -> bytes:
    """Return the text, in capitals and with plain ends of lines, with all its lines but no sequence
    numbers."""
    ends = np.flatnonzero(np.frombuffer(text + b"\n", np.uint8) == ord("\n"))
    if not (np.diff(ends, prepend=-1) - 1 > COLUMNS).any():
        return text
    lines = text.split(b"\n")
    return b"\n".join(_cut(line) for line in lines) if _are_numbered(lines) else text


def _are_numbered(lines: list[bytes]) -> bool:
    last: dict[bytes, int] = {}
    count, apart = 0, True
    for line in lines:
        if not _is_long(line):
            continue
        statement, number = line[:COLUMNS], NUMBERED.fullmatch(line[COLUMNS:].strip())
        short = len(line.rstrip()) <= CARD
        if number is None or not short or b"\t" in line or statement.rstrip().endswith(OPEN):
            return False
        before, here = last.get(number[1], -1), int(number[2])
        behind = number[1] == b"" and statement[-1:].isdigit()
        if here <= before or (behind and (len(number[2]) < CARD - COLUMNS or here - before > STEP)):
            return False
        last[number[1]] = here
        count, apart = count + 1, apart and not behind
    return count >= (1 if apart else FEWEST)


def _is_long(line: bytes) -> bool:
    """Whether a line has anything in the columns that could belong to a statement."""
    return (
        len(line) > COLUMNS
        and bool(line[COLUMNS:].strip())
        and b"$" not in line[:COLUMNS]
        and not TEXT.match(line)
    )


def _cut(line: bytes) -> bytes:
    return line[:COLUMNS] if _is_long(line) else line
