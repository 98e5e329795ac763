# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether anything starts the spindle before a program feeds."""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.motion.program import Program, feed_blocks

START = re.compile(rb"(?<![A-Za-z_])M(?:[0-9]+\s*=\s*)?0*(?:3|4|13|14)(?![0-9.])", re.IGNORECASE)
"""M3 and M4, with coolant M13 and M14, and Siemens' of one spindle of several, M1=3."""

END = re.compile(rb"(?<![A-Za-z_])(?:M0*(?:2|30)(?![0-9.=])|END PGM)", re.IGNORECASE)
"""What only a whole program ends with; a part of one may be called with the spindle on."""

TAIL = 4096
"""Bytes at the end of the text in which the end of the program is looked for."""

REMARK = re.compile(rb"\([^)\n]*\)?|;[^\n]*")
"""Remarks: what stands in them starts nothing."""


def spindle_findings(text: bytes, program: Program) -> tuple[Finding, ...]:
    """Say of a whole program that nothing in its ``text`` starts the spindle before its first feed block."""
    feeds = feed_blocks(program)
    if not len(feeds):
        return ()
    line = int(program.line[feeds[0]])
    before = b"\n".join(text.split(b"\n", line)[:line])
    if START.search(REMARK.sub(b"", before)) or not END.search(REMARK.sub(b"", text[-TAIL:])):
        return ()
    found = say(
        "The spindle stays off: nothing before NC line {line}, the first that feeds, starts it. Give M3 "
        "with S before the tool gets to the part.",
        line=line,
    )
    return (report_finding(Code.SPINDLE_OFF, found, line=line),)
