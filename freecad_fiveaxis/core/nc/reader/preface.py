# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stands around a program and is none of it: tape marks, names where a number belongs, listings, signs
of an end.

%                      the first ends the leader of the tape, the next one ends the program (ISO 6983-1).
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
from freecad_fiveaxis.core.base.sentences import say

SOLID = re.compile(rb"[^ \n]")
END_SIGN = re.compile(rb"[\x03\x04][\x03\x04\x1a\s]*\Z")
HEAD = 30
"""Lines at the start of a file in which a preface is looked for."""
LISTING = re.compile(
    rb"^(?: *=+ *| *(?:INFORMATION LISTING CREATED BY|DATE|CURRENT WORK PART|NODE NAME) *:[^\n]*)$",
    re.MULTILINE,
)
LISTING_SIGN = b"INFORMATION LISTING CREATED BY"
WORD = rb"(?<![A-Z])[A-Z] *[-+]?[0-9.]"
NAME = re.compile(rb"^ *O(?! *[0-9<#\[])(?![^\n]*" + WORD + rb") *[A-Z][A-Z0-9 _.-]*$", re.MULTILINE)
SIEMENS_NAME = re.compile(rb"^ *O +(?![^\n]*" + WORD + rb")[A-Z][A-Z0-9 _.-]*$", re.MULTILINE)
COLON = re.compile(rb"^ *(:)(?= *[A-Z] *[-+.0-9])", re.MULTILINE)


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


def between_marks(text: bytes, findings: list[Finding]) -> bytes:
    """Cut the text at the closing ``%`` line, and blank the opening one and the leader before it."""
    mark = _mark(text, 0)
    if mark >= 0 and not SOLID.search(text, 0, mark):
        end = line_end(text, mark)
        text = re.sub(rb"[^\n]", b" ", text[:end]) + text[end:]
        mark = _mark(text, end)
    if mark < 0:
        return text
    if SOLID.search(text, line_end(text, mark)):
        findings.append(
            finding_at(Code.TEXT_AFTER_END, say("The text after the closing % is not read."), text, mark)
        )
    return text[:mark]


def line_end(text: bytes, at: int) -> int:
    """Find where the line of position ``at`` ends."""
    end = text.find(b"\n", at)
    return len(text) if end < 0 else end


def finding_at(code: Code, sentence: str, text: bytes, at: int, severity: Severity | None = None) -> Finding:
    """Make a finding with the line of position ``at``."""
    return report_finding(code, sentence, line=text.count(b"\n", 0, at) + 1, severity=severity)


def _mark(text: bytes, start: int) -> int:
    """Return the next ``%`` that begins a line, -1 if there is none."""
    at = text.find(b"%", start)
    while at >= 0 and text[text.rfind(b"\n", 0, at) + 1 : at].strip():
        at = text.find(b"%", at + 1)
    return at


def _blank(found: re.Match[bytes]) -> bytes:
    return b" " * len(found[0])
