# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one line of klartext says of a mirror image, a rotation or a scaling (Heidenhain TNC 640, cycle
programming, coordinate transformation cycles).

CYCL DEF 8.1 X Y         these axes point the other way; no letters: none does.
CYCL DEF 10.1 ROT+35     coordinates turned by that angle in the plane across the tool; IROT: on from there.
CYCL DEF 11.1 SCL 0.99   X, Y and Z times that.
CYCL DEF 26.1 X1.4 Y0.6 CCX+15 CCY+20   each axis by its own factor, about a centre.

The lines 8.0 to 26.0 only name the cycle. :mod:`.heidenhain_frames` makes coordinates of them.
"""

from __future__ import annotations

import re

from freecad_fiveaxis.core.base.sentences import say

from .plane_calls import HEIDENHAIN, NUMBER, Change, Tilt

HEAD = re.compile(r"CYCL DEF (?:8|10|11|26)\.0(?![0-9])")
LINE = re.compile(r"CYCL DEF (8|10|11|26)\.1(?![0-9]) *(.*)")
MIRROR, TURN, SCALE, STRETCH = "8", "10", "11", "26"
ORDER = (MIRROR, TURN, SCALE, STRETCH)
"""The control's order, after the shift of the zero."""
MIRRORED = re.compile(r"(?:[XYZABCUVW] *)*")
TURNED = re.compile(rf"(I?)ROT *({NUMBER})")
SCALED = re.compile(rf"SCL *({NUMBER})")
STRETCHED = re.compile(rf"(?:(?:CC)?[XYZ] *{NUMBER} *)+")
ENTRY = re.compile(rf"((?:CC)?[XYZ]) *({NUMBER})")
LARGEST = 10.0
"""A factor beyond this would draw arcs more coarsely than the reader promises."""
ROTARY = say("it changes a rotary axis, or one beside X, Y and Z")
FACTOR = say("its factor is 0 or less, or more than 10")
UNKNOWN = say("it is not known in this form")


def read_change(line: str) -> Tilt | None:
    """Return what a line of these cycles says, in capitals, single blanks; None for another line."""
    found = LINE.fullmatch(line)
    if found is None:
        return None
    name, read = f"CYCL DEF {found[1]}", READ[found[1]]
    change = read(found[2].strip())
    if isinstance(change, Change):
        return Tilt(HEIDENHAIN, name=name, change=change)
    return Tilt(HEIDENHAIN, name=name, change=Change(found[1]), refused=change)


def _mirror(rest: str) -> Change | str:
    if not MIRRORED.fullmatch(rest):
        return UNKNOWN
    if set(rest) - set("XYZ "):
        return ROTARY
    x, y, z = (-1.0 if axis in rest else 1.0 for axis in "XYZ")
    return Change(MIRROR, (x, y, z))


def _turn(rest: str) -> Change | str:
    found = TURNED.fullmatch(rest)
    if found is None or abs(float(found[2])) > 1e6:
        return UNKNOWN
    return Change(TURN, angle=float(found[2]), on=bool(found[1]))


def _scale(rest: str) -> Change | str:
    found = SCALED.fullmatch(rest)
    if found is None:
        return UNKNOWN
    factor = float(found[1])
    return Change(SCALE, (factor, factor, factor)) if 0.0 < factor <= LARGEST else FACTOR


def _scale_axes(rest: str) -> Change | str:
    if not STRETCHED.fullmatch(rest):
        return UNKNOWN
    entries = {name: float(value) for name, value in ENTRY.findall(rest)}
    x, y, z = (entries.get(axis, 1.0) for axis in "XYZ")
    if not all(0.0 < one <= LARGEST for one in (x, y, z)):
        return FACTOR
    u, v, w = (entries.get("CC" + axis, 0.0) for axis in "XYZ")
    return Change(STRETCH, (x, y, z), about=(u, v, w)) if max(map(abs, (u, v, w))) < 1e7 else UNKNOWN


READ = {MIRROR: _mirror, TURN: _turn, SCALE: _scale, STRETCH: _scale_axes}
