# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heidenhain's DIN/ISO where its words mean what klartext says otherwise (TNC 640, User's Manual for ISO
programming).

N50 L1,2, N60 G98 L1    CALL LBL 1 REP 2, LBL 1; L1,0 calls a subprogram.
I+5 J+0 K-3             the pole or centre: absolute, and kept until the next one, as CC; under G91 from where
                        the tool is.
G80 A+30 B+0 C+0        the tilted working plane, whose words turn no axis.
G83 P01 +2 P02 -20 ..   cycles whose values are numbered.
"""

from __future__ import annotations

import re
from bisect import bisect_right

from . import codes
from .noted import Notes

SIGN = re.compile(rb"^ *(?:N *[0-9]+ *)?G *[0-9]", re.MULTILINE)
LOOKED_AT = 20_000
"""Bytes at the start of a text that show a line of DIN/ISO."""
LABEL = re.compile(rb"^ *N *[0-9]+ *G98 *L *([0-9]+) *$", re.MULTILINE)
CALL = re.compile(rb"^ *N *[0-9]+ *L *([0-9]+) *, *([0-9]+) *$", re.MULTILINE)
CENTRE = re.compile(rb"(?<![A-Z0-9])([IJK])(?= *[-+.0-9])")
DISTANCE = re.compile(rb"(?<![A-Z0-9])G9([01])(?![0-9.])")
PLANE = re.compile(rb"(?<![A-Z0-9])G80(?= *[ABC])[^\n]*")

CYCLE = re.compile(rb"(?<![A-Z0-9])G *(?P<name>7[4-8]|8[3-6]) +[^\n]*P *0?[0-9]+ +[-+0-9][^\n]*")


def with_labels(text: bytes) -> bytes:
    """Return the text with labels and calls of DIN/ISO as klartext has them."""
    if b"G98" not in text and b"G 98" not in text:
        return text
    text = LABEL.sub(rb"LBL \1", text)
    return CALL.sub(lambda found: b"CALL LBL " + found[1] + _repeats(found[2]), text)


def _repeats(count: bytes) -> bytes:
    return b" REP " + count if int(count) else b""


def with_own_words(text: bytes, notes: Notes) -> bytes:
    """Return the text with centres as those of CC, at equal length, and without cycles and tilted planes,
    which are noted."""
    if not SIGN.search(text[:LOOKED_AT]):
        return text
    if b"G80" in text:
        text = PLANE.sub(lambda found: _leave_out(found, codes.SHIFT, "G80", notes), text)
    if b"P0" in text:
        text = CYCLE.sub(lambda found: _leave_out(found, codes.CYCLE_KIND, _name(found), notes), text)
    if not CENTRE.search(text):
        return text
    switches = [(found.start(), found[1] == b"1") for found in DISTANCE.finditer(text)]
    starts = [at for at, _ in switches]

    def centre(found: re.Match[bytes]) -> bytes:
        line_end = text.find(b"\n", found.start())
        before = bisect_right(starts, line_end if line_end >= 0 else len(text))
        if before and switches[before - 1][1]:
            return found[1]
        return codes.CENTRE["IJK".index(found[1].decode())].encode()

    return CENTRE.sub(centre, text)


def _name(found: re.Match[bytes]) -> str:
    return "G" + found["name"].decode()


def _leave_out(found: re.Match[bytes], kind: codes.Kind, name: str, notes: Notes) -> bytes:
    notes.note(kind, name, found.start())
    return b" " * len(found[0])
