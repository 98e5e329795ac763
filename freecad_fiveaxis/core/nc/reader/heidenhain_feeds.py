# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feeds of a Heidenhain program that stand elsewhere than behind F, and words that belong to an M function
(User's manual Klartext programming).

TOOL CALL ... F800      in force from there on, as F of a block. F AUTO: that of the last TOOL CALL.
FZ0.1 FU0.2 FT3         of a tooth, of a turn, time of the block: not known here.
M136, M137              F is in mm a turn; in mm a minute again.
M128 F1000, M103 F20    the largest feed of compensating moves; a share of F for plunging: no feed of a block.
M118 X1, M120 LA5       limits of the handwheel, blocks ahead: no places.     M94 C, M138 A C   names of axes.
"""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.sentences import say

from . import codes
from .noted import Notes

NUMBER = rb" *[-+]? *(?:Q[LRS]?)?[0-9]*\.?[0-9]+\.?"
CALL_OR_AUTO = re.compile(rb"(?<![A-Z])TOOL +CALL\b([^\n]*)|(?: |(?<![A-Z]))F *AUTO\b")
FEED = re.compile(rb"(?<![A-Z0-9])F *([0-9]+\.?[0-9]*)(?![A-Z0-9])")
ANY_FEED = re.compile(rb"(?<![A-Z0-9])F")
TOOL = re.compile(rb" *(?:[0-9Q]|\"|#)")
STRING = re.compile(rb'"[^"\n]*"')
BY_TOOL = re.compile(rb"(?<![A-Z])F *(?:MAXT|[UZT] *[0-9]*\.?[0-9]+)")
OF_M = re.compile(
    rb"(?<![A-Z0-9])M(?:(?:120 *LA|103 *F|128 *F(?! *MAX))" + NUMBER + rb"|128 *F *MAX\b"
    rb"|118(?: *[XYZABCUVW]" + NUMBER + rb")+|(?:94|138)(?: *[ABCUVW]\b(?! *[-+.0-9]))+)"
)
"""An M function with the words that are its own."""
PER_TURN = re.compile(rb"(?<![A-Z0-9])M13([67])(?![0-9])")
UNKNOWN_FEED = (Code.FEED_BY_PARAMETER, say("feeds told by a parameter or the tool; F is not known there"))
PLUNGING = (
    Code.FEED_BY_PARAMETER,
    say("a lower feed for plunging, of which the times here know nothing; F is taken as it stands"),
)
UNKNOWN = b"F-1"
"""The word of a feed that only the control knows (:data:`.feeds.NOT_KNOWN`)."""


def feeds_of_tools(text: bytes, notes: Notes) -> bytes:
    """Return the text with the F of the last TOOL CALL for each F AUTO."""
    feed: bytes | None = None

    def put(found: re.Match[bytes]) -> bytes:
        nonlocal feed
        if found[1] is None:
            return _feed_or_note(found, feed, notes)
        own = feed_of_call(found[1])
        if own is not None or TOOL.match(found[1]) or ANY_FEED.search(STRING.sub(b"", found[1])):
            feed = own
        return found[0]

    return CALL_OR_AUTO.sub(put, text) if b"AUTO" in text else text


def feed_of_call(words: bytes) -> bytes | None:
    """Return the number of the F of a TOOL CALL, None where it has none."""
    found = FEED.search(STRING.sub(b"", words))
    return found[1] if found else None


def _feed_or_note(found: re.Match[bytes], feed: bytes | None, notes: Notes) -> bytes:
    word = b"" if feed is None else b"F" + feed
    if word and len(word) <= len(found[0]):
        return word.rjust(len(found[0]))
    return note_unknown(found, notes)


def note_unknown(found: re.Match[bytes], notes: Notes) -> bytes:
    """Return the word of a feed that is not known, which is noted."""
    notes.note(UNKNOWN_FEED, b" ".join(found[0].split()).decode("latin-1"), found.start())
    return UNKNOWN.rjust(len(found[0]))


def without_words_of_m(text: bytes, notes: Notes) -> bytes:
    """Return the text without the words that belong to an M function, and M136 and M137 as codes."""
    text = PER_TURN.sub(lambda found: _per_turn(found, notes), text) if b"M13" in text else text
    return OF_M.sub(lambda found: _of_m(found, notes), text) if b"M" in text else text


def _per_turn(found: re.Match[bytes], notes: Notes) -> bytes:
    if found[1] == b"7":
        return b"G94 "
    notes.note(codes.PER_TURN_KIND, "M136", found.start())
    return b"G%d" % (codes.PER_TURN_M // 10)


def _of_m(found: re.Match[bytes], notes: Notes) -> bytes:
    code = re.match(rb"M[0-9]+", found[0])
    assert code is not None
    if code[0] == b"M103":
        notes.note(PLUNGING, "M103", found.start())
    return code[0].ljust(len(found[0]))
