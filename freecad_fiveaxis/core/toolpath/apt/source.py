# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of a CL file cut into statements.

$      the statement goes on in the next line.
$$     the rest of the line is a comment. Creo's ``$$->`` lines go on with $ as statements do, and are
       comments throughout.
soft   a byte that stands for the end of a line within a statement.
"""

from __future__ import annotations

import re
from copy import copy
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from freecad_fiveaxis.core.base.errors import ProgramError
from freecad_fiveaxis.core.base.records import Bools, Ints
from freecad_fiveaxis.core.base.sentences import say

from .arc_statements import catia_arcs_apart
from .columns import without_sequence_numbers
from .vocabulary import FREE_TEXT, MOTIONS

TEXT = bytes({*range(32, 256), *b"\t\n\v\f\r"})
SOFT = b"\x01"
COMMENT = re.compile(rb"\$\$->(?:[^\n]*\$[ \t]*\n)*[^\n]*|\$\$[^\n]*")
CONTINUED = re.compile(rb"\$[^\n]*\n")
FREE_LINE = re.compile(rb"(?m)^[ \t]*(?:" + "|".join(FREE_TEXT).encode() + rb")[^\n]*\$[^\n]*")
HOME = re.compile(rb"(?m)^GOHOME/(?=(?:[-+.0-9E\x01]+,){2}(?:(?:[-+.0-9E\x01]+,){3})?[-+.0-9E\x01]+$)")
"""NX's rapid to the place that it names: read as FROM, which is one too."""
WIDE = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}
"""What files of two-byte characters begin with."""


class Source:
    """The statements of the text without blanks, in capitals: where each begins and ends, its line, and which
    are moves."""

    def __init__(self, raw: bytes) -> None:
        self.plain = plain_text(raw)
        joined = without_sequence_numbers(self.plain)
        joined = COMMENT.sub(_lines_only, joined) if b"$$" in joined else joined
        joined = FREE_LINE.sub(_without_dollar, joined) if b"$" in joined else joined
        joined = CONTINUED.sub(SOFT, joined) if b"$" in joined else joined
        self.text = HOME.sub(b"FROM/", catia_arcs_apart(joined.translate(None, b" \t\v\f$"))) + b"\n"
        self.code: NDArray[Any] = np.frombuffer(self.text, np.uint8)
        ends = np.flatnonzero(self.code == ord("\n"))
        self.line: Ints = np.arange(1, len(ends) + 1)
        soft = np.flatnonzero(self.code == SOFT[0])
        if len(soft):
            self.line += np.searchsorted(soft, np.concatenate([[0], ends[:-1]]))
        begins = np.concatenate([[0], ends[:-1] + 1])
        real = ends > begins
        self.begin, self.end, self.line = begins[real], ends[real], self.line[real]
        self._cut_at_end()
        self._find_moves()

    def starts(self, word: bytes) -> Bools:
        """Which statements start with the word."""
        found: Bools = self.end - self.begin >= len(word)
        for k, byte in enumerate(word):
            found &= self.code[np.minimum(self.begin + k, len(self.code) - 1)] == byte
        return found

    def move_rows(self, word: bytes) -> Bools:
        """Which moves start with the word."""
        rows: Bools = self.starts(word)[self.move_at]
        return rows

    def statement(self, k: int) -> str:
        """Return the text of statement k."""
        return self.text[self.begin[k] : self.end[k]].replace(SOFT, b"").decode("latin-1")

    def take_lines(self, begin: Ints, end: Ints) -> NDArray[Any]:
        """Return the bytes from each ``begin`` up to and with its end of line, one after the other, as
        codes."""
        edge = np.zeros(len(self.code) + 1, np.int8)
        edge[begin] += 1
        edge[end + 1] -= 1  # the end of line goes along: it separates the last number from the next
        taken: NDArray[Any] = self.code[np.cumsum(edge[:-1], dtype=np.int8).view(np.bool_)]
        return taken

    def fail(self, k: int, part: str, reason: str) -> NoReturn:
        """Raise for statement k, pointing at ``part`` of it in the file."""
        lines = self.plain.split(b"\n")
        line = int(self.line[k])
        last = line + self.text.count(SOFT, int(self.begin[k]), int(self.end[k]))
        for number in range(line, last + 1):
            column = lines[number - 1].find(part.encode("latin-1")) if part else -1
            if column >= 0:
                break
        else:
            number, column = line, 0
        raise ProgramError(
            say(
                "line {number}, column {column}: {reason}: {statement}",
                number=number,
                column=column + 1,
                reason=reason,
                statement=repr(self.statement(k)[:60]),
            ),
            part,
        )

    def take(self, statements: Bools) -> Source:
        """Return the same text with some of its statements (s,) alone."""
        selected = copy(self)
        selected.begin, selected.end, selected.line = (
            self.begin[statements],
            self.end[statements],
            self.line[statements],
        )
        selected._find_moves()
        return selected

    def _find_moves(self) -> None:
        kinds = [self.starts(word) for word in MOTIONS]
        self.moves: Bools = np.logical_or.reduce(kinds)
        self.moves_before: Ints = np.cumsum(self.moves) - self.moves
        self.move_at: Ints = np.flatnonzero(self.moves)

    def _cut_at_end(self) -> None:
        last = np.flatnonzero(self.starts(b"FINI") & (self.end - self.begin == len(b"FINI")))
        self.after_end = int(self.line[last[0] + 1]) if len(last) and last[0] + 1 < len(self.line) else 0
        if len(last):
            keep = slice(0, last[0] + 1)
            self.begin, self.end, self.line = self.begin[keep], self.end[keep], self.line[keep]


def plain_text(raw: bytes) -> bytes:
    """Return the text in capitals, lines ended by LF, whatever system it comes from. Raises ProgramError for
    what is no text."""
    codec = WIDE.get(raw[:2])
    if codec:
        raw = raw[2:].decode(codec, "replace").encode("latin-1", "replace")
    raw = raw.rstrip(b"\x1a\0\r\n\t ").removeprefix(b"\xef\xbb\xbf")
    if b"\r" in raw:
        raw = raw.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    if control := raw.translate(None, TEXT):
        offset = raw.index(control[:1])
        line, column = raw.count(b"\n", 0, offset) + 1, offset - raw.rfind(b"\n", 0, offset)
        reason = say(
            "this is no CL file: byte {control} (offset {offset}) stands in no text; give a text file",
            control=control[0],
            offset=offset,
        )
        raise ProgramError(
            say("line {line}, column {column}: {reason}", line=line, column=column, reason=reason), control[0]
        )
    return raw.upper()


def _lines_only(comment: re.Match[bytes]) -> bytes:
    return b"\n" * comment[0].count(b"\n")


def _without_dollar(line: re.Match[bytes]) -> bytes:
    return line[0].replace(b"$", b" ")
