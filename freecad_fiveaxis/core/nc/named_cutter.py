# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter that an NC program names in its head, as our own do: ``(T3 BALL 10 MM, L 120.000)``."""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.tool import Cutter, cutter_name, parse_cutter

CENTRE = ", centre driven"
"""Behind the cutter's name where the words drive its centre: then nobody takes them for the tip's."""

_COMMENT = re.compile(
    rb"^(?:N?\d+ +)?[(;] *(?:T\d+ )?(?P<kind>(?:TAPER )?(?:BALL|BULL)|FLAT|LOLLIPOP|BARREL) "
    rb"(?P<diameter>[\d.]+) MM"
    rb"(?:, CORNER (?P<corner>[\d.]+) MM)?(?:, NECK (?P<neck>[\d.]+) MM)?(?:, FLANK (?P<flank>[\d.]+) MM)?"
    rb"(?:, (?P<taper>[\d.]+) DEG)?(?:, L [-\d.]+(?: IN)?)?\)?[ \t\r]*$",
    re.MULTILINE,
)


def find_named_cutter(text: bytes) -> Cutter | None:
    """Give the one cutter that comments of a program name; None without one, with several, and where its
    centre is driven."""
    named = {
        match.group("kind", "diameter", "corner", "neck", "flank", "taper")
        for match in _COMMENT.finditer(text)
    }
    if len(named) != 1:
        return None
    kind, diameter, corner, neck, flank, taper = (
        part.decode("ascii") if part else "" for part in named.pop()
    )
    sizes = [diameter, flank, corner, neck, f"{taper}deg" if taper else ""]  # each kind's in its order
    try:
        return parse_cutter(":".join([kind.replace(" ", "").lower(), *filter(None, sizes)]))
    except SettingsError:
        return None


def note_named_cutter(cutter: Cutter) -> tuple[Finding, ...]:
    """Say that the cutter is taken from the program, because none is given."""
    text = say(
        "No cutter is given; the one that the program names is taken: {cutter}.", cutter=cutter_name(cutter)
    )
    return (report_finding(Code.CUTTER_FROM_PROGRAM, text, cutter.diameter),)
