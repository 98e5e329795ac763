# SPDX-License-Identifier: LGPL-2.1-or-later
"""A text of nothing but NC words into columns: letters, numbers, lines; and what is no word, with its line
and column."""

from __future__ import annotations

import re
import warnings
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from .preface import SOLID, line_end

LEGAL = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-. \n\x7f"
EXPONENT = re.compile(rb"(?<=[0-9.])E[+-]?[0-9]")
LETTERS_TO_BLANKS = bytes.maketrans(bytes(range(65, 91)) + bytes(range(97, 123)) + b"\n\x7f", b" " * 54)
PREFACE = 3
"""Lines at the start of a file in which somebody may have written what the program is."""


def split_words(text: bytes, source: Ints | None) -> tuple[Bytes, Floats, Ints, Ints]:
    """Return letter, number, line (from 1) and place in the text without blanks of every word (w,) each.
    ``source``: the line of the file of each line of the text, None: the same. Raises ProgramError for what is
    no word."""
    _check_characters(text, source)
    compact = text.translate(None, b" ") + b"\n"
    code = np.frombuffer(compact, np.uint8)
    is_letter = code >= ord("A")
    start = np.flatnonzero(is_letter)
    bad = _find_malformed(code, is_letter, start)
    if bad >= 0:
        _complain(text, compact, bad, source)
    value = _numbers(compact, len(start))
    if not np.isfinite(value).all():
        _complain(text, compact, int(start[np.flatnonzero(~np.isfinite(value))[0]]), source)
    return code[start].astype(np.int8), value, _lines(code, start), start


def _check_characters(text: bytes, source: Ints | None) -> None:
    if illegal := text.translate(None, LEGAL):
        shown = illegal[:1].decode("latin-1")
        partner = say("a bracket without its partner")
        hint = {"(": partner, ")": partner, ",": say("write a decimal point")}
        _fail(
            text,
            text.index(illegal[:1]),
            say(
                "character {shown} cannot be read ({hint})",
                shown=repr(shown),
                hint=hint.get(shown, say("not part of any word")),
            ),
            source,
        )
    if b"E" in text and (found := EXPONENT.search(text)):
        _fail(text, found.start(), say("a number with an exponent; write it out"), source)


def _find_malformed(code: NDArray[np.uint8], is_letter: Bools, start: Ints) -> int:
    """Position of the first character that makes no word, -1 if all is well."""
    before = np.empty(len(code), np.uint8)
    before[0], before[1:] = ord("\n"), code[:-1]
    sign = (code == ord("+")) | (code == ord("-"))
    bad = sign & (before < ord("A"))  # a sign that follows no letter
    bad |= (before == ord("\n")) & ~is_letter & (code != ord("\n"))  # a line that begins with no letter
    bad_places = np.flatnonzero(bad)
    if not len(start):
        return int(bad_places[0]) if len(bad_places) else -1
    digits = np.add.reduceat((code - np.uint8(ord("0"))) < 10, start, dtype=np.int32)
    points = np.add.reduceat(code == ord("."), start, dtype=np.int32)
    bad_words = start[(digits == 0) | (points > 1)]
    places = [int(found[0]) for found in (bad_places, bad_words) if len(found)]
    return min(places, default=-1)


def _numbers(compact: bytes, count: int) -> Floats:
    """All numbers of a text that was found well formed."""
    if count == 0:
        return np.empty(0)  # numpy finds one number in blanks
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)  # numpy's way to say that it stopped early
        value = np.fromstring(compact.translate(LETTERS_TO_BLANKS), np.float64, sep=" ")
    if len(value) != count:
        raise ProgramError(
            say("{count} numbers for {words} words; the text is malformed", count=len(value), words=count),
            count,
        )
    return value


def _lines(code: NDArray[np.uint8], start: Ints) -> Ints:
    ends = np.flatnonzero(code == ord("\n"))
    words_so_far = np.searchsorted(start, ends)
    return np.repeat(np.arange(1, len(ends) + 1), np.diff(words_so_far, prepend=0))


def _complain(text: bytes, compact: bytes, at: int, source: Ints | None) -> NoReturn:
    """Raise for the malformed word at ``at`` of the text without blanks."""
    line = compact.count(b"\n", 0, at)
    begin = _line_start(text, line + 1)
    column = find_column(text, line + 1, at - (compact.rfind(b"\n", 0, at) + 1))
    found = text[begin : line_end(text, begin)].strip()
    reason = say("a word is a letter and one number")
    if found == b"O":
        reason = say("the program has no number; write one after the O, as O1")
    elif line < PREFACE and b"G" not in text[:begin] and not re.search(rb"[0-9]", found):
        reason = say("this is no NC line; delete what stands before the program, or put it in brackets")
    _fail(text, begin + column - 1, reason, source)


def _line_start(text: bytes, line: int) -> int:
    """Where a line, counted from 1, begins."""
    begin = 0
    for _ in range(line - 1):
        begin = text.index(b"\n", begin) + 1
    return begin


def find_column(text: bytes, line: int, within: int) -> int:
    """Find the column, counted from 1, of character ``within`` of a line without its blanks; 1 beyond its
    end."""
    begin = _line_start(text, line)
    places = [found.start() for found in SOLID.finditer(text, begin, line_end(text, begin))]
    return places[within] - begin + 1 if within < len(places) else 1


def _fail(text: bytes, at: int, reason: str, source: Ints | None) -> NoReturn:
    begin = text.rfind(b"\n", 0, at) + 1
    line = text.count(b"\n", 0, at) + 1
    line = line if source is None else int(source[line])
    found = text[begin : begin + 200].split(b"\n")[0].decode("latin-1").strip()[:60]
    raise ProgramError(
        say(
            "line {line}, column {at}: {reason}: {found}",
            line=line,
            at=at - begin + 1,
            reason=reason,
            found=repr(found),
        ),
        found,
    )
