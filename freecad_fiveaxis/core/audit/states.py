# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is in force in each row of an NC text that was read: spindle, speed, tool and length, as columns.

row       as of :class:`~freecad_fiveaxis.core.nc.reader.Reading`: lines in the order in which the control
          comes to them. A state holds until another of its kind is read.
unread    from the first call or macro on that was not interpreted nothing is claimed: what stands there may
          start a spindle or take a length.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.motion.program import feed_blocks
from freecad_fiveaxis.core.nc.reader import Reading
from freecad_fiveaxis.core.nc.reader.preface import with_line_feeds

NOTHING = -1
"""No event in a row; and the state before the first."""
UNKNOWN = np.inf
"""A number that the program does not say, as S of a variable."""
UNREAD = frozenset({Code.CALL_NOT_INTERPRETED, Code.MACRO_NOT_INTERPRETED})
UNREAD_KEYWORD = Code.UNKNOWN_CODE
"""In Siemens' and Heidenhain's language a word that is not known may be a subprogram of the builder."""
END_PGM = re.compile(rb"^ *[0-9]* *END +PGM\b", re.IGNORECASE | re.MULTILINE)
REMARK = re.compile(rb";[^\n]*|\"[^\"\n]*\"")
TAIL = 4096
"""Bytes at the end of the text in which the end of the program is looked for."""


def hold(event: Floats) -> Floats:
    """Return what is in force after each row (rows,): the last of the events at or before it, and
    :data:`NOTHING` before the first. ``event`` (rows,): NaN where there is none."""
    at = np.maximum.accumulate(np.where(np.isnan(event), 0, np.arange(len(event))))
    held = event[at]
    return np.where(np.isnan(held), float(NOTHING), held)


def before(state: Floats) -> Floats:
    """Return the state that each row (rows,) begins with."""
    return np.concatenate([[float(NOTHING)], state[:-1]])


def words_of(reading: Reading, letter: str) -> tuple[Ints, Floats]:
    """Return the rows (k,) and the numbers (k,) of the words of a letter."""
    words = reading.lines.words
    at = np.flatnonzero(words.letter == ord(letter))
    return words.line[at], words.value[at]


def events(reading: Reading) -> Floats:
    """Return a column (rows,) without any event."""
    return np.full(reading.lines.count, np.nan)


def mark_file_lines(reading: Reading, event: Floats, text: bytes, at: Iterable[tuple[int, float]]) -> None:
    """Set the events of the rows that come from the lines of these offsets of the ``text``; where a number is
    there already it stays."""
    places = list(at)
    if not places:
        return
    ends = np.flatnonzero(np.frombuffer(text, np.uint8) == ord("\n"))
    line = np.searchsorted(ends, [place for place, _ in places]) + 1
    of_file = np.full(len(ends) + 2, np.nan)
    of_file[line] = [value for _, value in places]
    given = of_file[np.minimum(reading.in_file(), len(of_file) - 1)]
    np.copyto(event, given, where=np.isnan(event))


def clean_text(text: bytes, language: str) -> bytes:
    """Return the text in capitals with lines ending in LF; of Siemens and Heidenhain, whose words are looked
    for in it, blanks for remarks and strings."""
    text = with_line_feeds(text).upper()
    return text if language == "iso" else REMARK.sub(lambda found: b" " * len(found[0]), text)


def cutting_rows(reading: Reading) -> tuple[Ints, Ints]:
    """Return the feed blocks (k,) of which something can be claimed, and their rows (k,): not those behind
    what was not read, nor those that only go up along Z, away from the part."""
    program = reading.program
    block = feed_blocks(program)
    change = program.words[block] - program.words[block - 1]
    only_up = (change[:, 2] > 0.0) & (np.delete(change, 2, axis=1) == 0.0).all(axis=1)
    block = block[~only_up & (reading.row[block] < first_unread(reading))]
    return block, reading.row[block]


def first_unread(reading: Reading) -> int:
    """Return the first row that was not interpreted, or behind the last one where all were."""
    codes = UNREAD if reading.language == "iso" else UNREAD | {UNREAD_KEYWORD}
    line = [found.line or 0 for found in reading.program.findings if found.code in codes]
    if not line:
        return reading.lines.count
    return int(np.searchsorted(np.maximum.accumulate(reading.in_file()), min(line)))


def ends(reading: Reading, text: bytes) -> bool:
    """Whether this is a whole program: M2, M30 or END PGM ends it. A part of one may be called with the
    spindle on and the length active."""
    _, number = words_of(reading, "M")
    return bool(np.isin(number, (2, 30)).any() or END_PGM.search(text[-TAIL:]))


def has_code(reading: Reading, codes: Iterable[int]) -> Bools:
    """Return the rows (rows,) with one of these G codes, ten times their numbers."""
    return reading.lines.any_of(codes)
