# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that move nothing, passed over: a table of those that are met in programs, and a machine file's
own.

CYCL DEF 392     DMG's ATC: mode and weight for tuning the drives, as programs for its machines say beside
                 Q240 and Q241.
M202(0.0024)     a tolerance, the machine builder's. Neither was looked up in a manual of the builder.
G05 P10000, P0   Fanuc's high precision contour control on and off (B-63324EN), in a line of its own: with
                 other words G05 is another function.
POPEN, DPRNT[...], BPRNT[...], PCLOS
                 what Fanuc's and Haas' macros write to a port (external output commands), each a line of its
                 own.

What a function's line says beside it stays: of ``M202(0.0024) X5`` the X is read.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import say

from .codes import UNKNOWN

SHIPPED: dict[str, tuple[str, ...]] = {
    "heidenhain": ("CYCL DEF 392", "M202"),
    "siemens": ("M202",),
    "iso": ("M202", "G05 P10000", "G05 P0"),
}
WHOLE = rb"^(?P<before>[ 0-9/]*)%b(?![0-9.A-Z])(?:[^\n]*~ *\n)*[^\n]*"
ALONE = rb"^(?P<before> *(?:/[0-9]? *)?(?:N *[0-9]+ *)?)%b *$"
"""A G code with its word, and no other: G5 of LinuxCNC, which has more, is a spline."""
OUTPUT = re.compile(
    rb"^(?P<before> *(?:/[0-9]? *)?(?:N *[0-9]+ *)?)(?:POPEN|PCLOS|[BD]PRNT *\[[^\n]*\]) *$", re.MULTILINE
)
BRACKETED = re.compile(rb"(?<![A-Z0-9])(M *[0-9]+) *\([^()\n]*\)")


def pass_over(text: bytes, language: str, own: Sequence[str] = ()) -> tuple[bytes, list[Finding]]:
    """Blank the functions without motion in a text in capitals, at equal length; and say what there is to
    say. ``own``: the names of a machine file (:mod:`freecad_fiveaxis.core.machine.no_motion`)."""
    findings: list[Finding] = []
    for name in dict.fromkeys((*SHIPPED[language], *own)):
        pattern = _pattern(name)
        if _needle(name) in text and (found := pattern.search(text)):
            if name not in SHIPPED[language]:
                sentence = say(
                    "{name} is passed over: the machine file says that it moves nothing (no_motion).",
                    name=name,
                )
                findings.append(
                    report_finding(Code.NO_MOTION, sentence, line=text.count(b"\n", 0, found.start()) + 1)
                )
            text = pattern.sub(_blank, text)
    if language == "iso" and (b"PRNT" in text or b"POPEN" in text or b"PCLOS" in text):
        text = OUTPUT.sub(_blank, text)
    return _without_brackets(text, findings), findings


def _without_brackets(text: bytes, findings: list[Finding]) -> bytes:
    """Return the text without the M functions in brackets that no table names, each of them found."""
    at = dict[bytes, list[int]]()
    for found in BRACKETED.finditer(text) if b"(" in text else ():
        at.setdefault(found[1], []).append(found.start())
    for name, places in at.items():
        shown = name.replace(b" ", b"").decode()
        sentence = say(
            "{name}(...) stands in {count} lines and is not known; what it does is missing here. If it "
            "moves nothing, name it under no_motion in the machine file.",
            name=shown,
            count=len(places),
        )
        line = text.count(b"\n", 0, places[0]) + 1
        findings.append(report_finding(UNKNOWN[0], sentence, float(len(places)), line=line, unit=""))
    return BRACKETED.sub(_blank, text) if at else text


def _needle(name: str) -> bytes:
    """Return what a text without the function has seldom: searched first, for it costs little."""
    return name.lstrip("MG0").split(" ")[-1].encode()


def _pattern(name: str) -> re.Pattern[bytes]:
    if name.startswith("CYCL"):
        return re.compile(WHOLE % rb"CYCL +DEF *%b" % name.split()[-1].encode(), re.MULTILINE)
    if name.startswith("FUNCTION"):
        return re.compile(WHOLE % (rb"FUNCTION +%b" % re.escape(name.split()[-1]).encode()), re.MULTILINE)
    words = rb" *".join(rb"%b *0*%b(?![0-9.=])" % _letter_and_number(word) for word in name.split())
    if name.startswith("G"):
        return re.compile(ALONE % words, re.MULTILINE)
    return re.compile(rb"(?<![A-Z0-9])" + words + rb"(?: *\([^()\n]*\))?")


def _letter_and_number(word: str) -> tuple[bytes, bytes]:
    return word[:1].encode(), re.escape(word[1:].lstrip("0") or "0").encode()


def _blank(found: re.Match[bytes]) -> bytes:
    """Return the words before a whole function stay, and ends of lines."""
    before = found.groupdict().get("before") or b""
    return before + re.sub(rb"[^\n]", b" ", found[0][len(before) :])
