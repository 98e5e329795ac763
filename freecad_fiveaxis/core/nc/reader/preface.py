# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands around a program and is none of it: tape marks, names where a number belongs, listings, signs
of an end.

%                      the first ends the leader of the tape, the next one ends the program (ISO 6983-1). A
                       stretch that moves nothing is none; before a single one the longer stretch is taken.
O NONAME, OFinal Path  a name after O, which takes a number on Fanuc's and Haas' controls: passed over, with a
                       warning.
Information listing    what NX writes at the head of its listing window, up to a line of equals signs: the
                       same.
: G17                  a colon without a number (a main block of old posts): the rest of its line is read.
ETX, EOT               at the end of a file: passed over.

None of it is taken for such where a word with a number stands in it: that could move something.
"""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Template, say

from .tape_sections import find_called, join_sections, sentence_of

SOLID = re.compile(rb"[^ \n]")
END_SIGN = re.compile(rb"[\x03\x04][\x03\x04\x1a\s]*\Z")
LONE_CR = re.compile(rb"\r(?! *N *[0-9])", re.IGNORECASE)
HEAD = 30
"""Lines at the start of a file in which a preface is looked for."""
LISTING = re.compile(
    rb"^(?: *=+ *| *(?:INFORMATION LISTING CREATED BY|DATE|NODE NAME)[ :][^\n]*"
    rb"| *CURRENT WORK PART[ :][^\n]*(?:(?:\n[^\n]*){1,3}(?=\n *NODE NAME[ :]))?)$",
    re.MULTILINE,
)
"""A colon or a tab, by now a blank, stands behind each name; the part's path may go on in the next line."""
LISTING_SIGN = b"INFORMATION LISTING CREATED BY"
WORD = rb"(?<![A-Z])[A-Z] *[-+]?[0-9.]"
NAME = re.compile(rb"^ *O(?! *[0-9<#\[])(?![^\n]*" + WORD + rb") *[A-Z][A-Z0-9 _.-]*$", re.MULTILINE)
SIEMENS_NAME = re.compile(rb"^ *O +(?![^\n]*" + WORD + rb")[A-Z][A-Z0-9 _.-]*$", re.MULTILINE)
COLON = re.compile(rb"^ *(:)(?= *[A-Z] *[-+.0-9])", re.MULTILINE)
MOVE = re.compile(rb"(?<![A-Z])I?[XYZABCUVW] *(?:[-+.0-9#\[(]|= *[^ \n])[^\n]*")
"""From the first word of an axis to the end of its line."""
LEADER = Template(
    "Lines {first} to {last} stand before the % that begins the program; they are not read, as controls do "
    "not read them."
)
LEADER_MOVES = Template(
    "Lines {first} to {last} stand before the % that begins the program, and hold moves; they are not read, "
    "as controls do not read them. If they belong to the program, put them behind the %."
)


def with_line_feeds(text: bytes) -> bytes:
    """Return the text with LF alone at the end of each line. A CR alone ends one where lines end so; among
    lines of LF or CRLF it is a blank, but before a block number, where the LF was lost."""
    text = text.replace(b"\r\n", b"\n")
    if 0 < text.count(b"\r") < text.count(b"\n"):
        text = LONE_CR.sub(b" ", text)
    return text.replace(b"\r", b"\n")


def without_end_sign(text: bytes, findings: list[Finding]) -> bytes:
    """Blank the control characters with which a file ends."""
    found = END_SIGN.search(text[-200:])
    if found is None:
        return text
    at = len(text) - len(found[0])
    findings.append(
        finding_at(
            Code.NOT_NC_TEXT, say("The file ends in control characters; they are passed over."), text, at
        )
    )
    return text[:at] + b" " * len(found[0])


def without_preface(text: bytes, language: str, findings: list[Finding]) -> bytes:
    """Blank what is no program in the first lines of a text in capitals, at equal length, and say so."""
    if language == "heidenhain":
        return text
    end = 0
    for _ in range(HEAD):
        end = line_end(text, end) + 1
    head, rest = text[:end], text[end:]
    if LISTING_SIGN in head:
        head = _pass_over(head, LISTING, findings, say("the head of NX's listing"))
    head = _pass_over(
        head,
        SIEMENS_NAME if language == "siemens" else NAME,
        findings,
        say("a program's name where O takes a number"),
    )
    return _without_colons(head + rest, findings)


def _pass_over(text: bytes, pattern: re.Pattern[bytes], findings: list[Finding], what: str) -> bytes:
    found = pattern.search(text)
    if found is None:
        return text
    sentence = say(
        "{shown} is {what}, no NC line; it is passed over. A control may refuse it: delete it.",
        shown=repr(found[0].decode("latin-1").strip()[:40]),
        what=what,
    )
    findings.append(finding_at(Code.NOT_NC_TEXT, sentence, text, found.start(), Severity.WARNING))
    return pattern.sub(_blank, text)


def _without_colons(text: bytes, findings: list[Finding]) -> bytes:
    """Return the text without colons that stand before words of other letters than numbers."""
    places = [found.start(1) for found in COLON.finditer(text)] if b":" in text else []
    if not places:
        return text
    sentence = say(
        "{count} lines begin with a colon without a number; the rest of them is read.", count=len(places)
    )
    findings.append(finding_at(Code.NOT_NC_TEXT, sentence, text, places[0]))
    return COLON.sub(lambda found: found[0].replace(b":", b" "), text)


def between_marks(text: bytes, findings: list[Finding], language: str = "iso") -> bytes:
    """Cut the text at the ``%`` line that ends the program, and blank what stands before it: the opening one
    with the leader. In ISO, subprograms behind it that are called stay (:mod:`.tape_sections`)."""
    marks = _marks(text)
    if not marks:
        return text
    begins = [0, *(line_end(text, mark) for mark in marks)]
    spans = list(zip(begins, [*marks, len(text)], strict=True))
    which = _program(text, spans)
    begin, end = spans[which]
    findings += _leader_findings(text, spans[:which])
    called = find_called(text, spans[which], spans[which + 1 :]) if language == "iso" else {}
    if called:
        findings.append(finding_at(Code.TEXT_AFTER_END, sentence_of(called), text, end))
    elif SOLID.search(text, line_end(text, end)):
        findings.append(
            finding_at(Code.TEXT_AFTER_END, say("The text after the closing % is not read."), text, end)
        )
    return re.sub(rb"[^\n]", b" ", text[:begin]) + join_sections(text, (begin, end), called)


def _program(text: bytes, spans: list[tuple[int, int]]) -> int:
    """Return which of the stretches between marks is the program: the first behind a mark that moves
    something. A single mark may as well be the closing one: there the longer of both."""
    first = next((k for k, span in enumerate(spans) if k and MOVE.search(text, *span)), 0)
    if not first:
        return 0 if SOLID.search(text, *spans[0]) else 1
    if len(spans) > 2:
        return first
    before, behind = (sum(1 for _ in MOVE.finditer(text, *span)) for span in spans)
    return int(behind >= before)


def _leader_findings(text: bytes, spans: list[tuple[int, int]]) -> list[Finding]:
    """Return what is to be said of the stretches before the program's: that they are not read."""
    solid = [(begin, end) for begin, end in spans if SOLID.search(text, begin, end)]
    if not solid:
        return []
    first = solid[0][1] - len(text[slice(*solid[0])].lstrip())
    last = solid[-1][0] + len(text[slice(*solid[-1])].rstrip()) - 1
    moves = any(MOVE.search(text, *span) for span in spans)
    template = LEADER_MOVES if moves else LEADER
    sentence = template.say(first=text.count(b"\n", 0, first) + 1, last=text.count(b"\n", 0, last) + 1)
    severity = Severity.WARNING if moves else None
    return [finding_at(Code.NOT_NC_TEXT, sentence, text, first, severity)]


def line_end(text: bytes, at: int) -> int:
    """Find where the line of position ``at`` ends."""
    end = text.find(b"\n", at)
    return len(text) if end < 0 else end


def finding_at(code: Code, sentence: str, text: bytes, at: int, severity: Severity | None = None) -> Finding:
    """Make a finding with the line of position ``at``."""
    return report_finding(code, sentence, line=text.count(b"\n", 0, at) + 1, severity=severity)


def _marks(text: bytes) -> list[int]:
    """Return the ``%`` that begin a line."""
    marks, at = list[int](), text.find(b"%")
    while at >= 0:
        if not text[text.rfind(b"\n", 0, at) + 1 : at].strip():
            marks.append(at)
        at = text.find(b"%", at + 1)
    return marks


def _blank(found: re.Match[bytes]) -> bytes:
    return re.sub(rb"[^\n]", b" ", found[0])
