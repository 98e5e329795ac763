# SPDX-License-Identifier: LGPL-2.1-or-later
"""What Mach3 and grbl take from a program's text beside its blocks: comments of their own, and lines for the
control.

//     Mach3: a comment up to the end of the line (Using Mach3Mill, comments).
$H     grbl: what begins with a dollar sign is for the control (grbl 1.1, commands): $H drives to the
       switches, $J= jogs, $X, $C and questions move nothing; a setting ($100=80) may change what a word
       means.
"""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.findings import Finding

from . import codes
from .noted import Notes

COMMENT = re.compile(rb"//[^\n]*")
CONTROL = re.compile(rb"^( *)\$ *([^\n]*)", re.MULTILINE)
HOMING = re.compile(rb"H *[XYZABC]* *$")
QUIET = re.compile(rb"(?:[$#GXCIN]|SLP|I\+)? *$")
"""Questions, the check mode, and the end of an alarm."""


def without_control_lines(text: bytes, controller: str) -> tuple[bytes, list[Finding]]:
    """Return a text in capitals with blanks for what is no block to that control, at equal length, and what
    is to be said of it."""
    if controller == "mach3" and b"//" in text:
        return COMMENT.sub(_blank, text), []
    if controller != "grbl" or b"$" not in text:
        return text, []
    notes = Notes()
    return CONTROL.sub(lambda found: _read_line(found, notes), text), notes.findings(text)


def _read_line(found: re.Match[bytes], notes: Notes) -> bytes:
    """Return the private word of a machine position for homing, blanks for any other line; noted where it
    moves or sets something."""
    if HOMING.match(found[2]):
        return (found[1] + codes.MACHINE.encode() + b"1").ljust(len(found[0]))
    if not QUIET.match(found[2]):
        kind = codes.HOME if found[2].startswith(b"J") else codes.UNKNOWN
        notes.note(kind, "$" + found[2].strip().decode("latin-1"), found.start())
    return _blank(found)


def _blank(found: re.Match[bytes]) -> bytes:
    return b" " * len(found[0])
