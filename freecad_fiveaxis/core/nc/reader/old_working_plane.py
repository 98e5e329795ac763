# SPDX-License-Identifier: LGPL-2.1-or-later
"""Klartext's cycle 19, WORKING PLANE, as a tilted plane (:mod:`.planes`).

CYCL DEF 19.1 A+0 B+45 C+0      the plane; the program's own words turn the axes (L B+Q121 C+Q122).
CYCL DEF 19.1 A+45 F1000 DIST50 the control turns the axes, and keeps the tip where it is.
CYCL DEF 19.1                   without a word: it ends.

By a setting of the machine the angles are spatial ones (as those of PLANE SPATIAL), or where the rotary axes
stand (Heidenhain iTNC 530, cycle programming, WORKING PLANE). Where both are the same plane it is read, and
where no rotary axis of the machine has such a letter only the first can be meant; else it is named. Not
looked up in a manual: that a defined plane of 0 and the end of the cycle leave the axes, and that Q120 to
Q122 hold 0 after the end.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.machine.kinematics.serial_chain import turn

from .plane_calls import HEIDENHAIN, MOVE, NUMBER, STAY, Tilt, beyond, one_by_one

HEAD = re.compile(r"CYCL *DEF *19\.0(?![0-9])")
LINE = re.compile(r"CYCL *DEF *19\.1(?![0-9]) *(.*)")
ENTRY = re.compile(rf"([ABC]) *({NUMBER}) *")
REST = re.compile(rf"(?:F *(?:MAX|AUTO|{NUMBER}) *)?(?:(?:DIST|ABST) *({NUMBER}) *)?")
NAME = "CYCL DEF 19"
SAME = 1e-9
"""Two frames, of cosines, that are one."""
TWO_MEANINGS = say(
    "by a setting of the machine its angles are spatial or those of the rotary axes, here two unlike planes"
)


def read_working_plane(line: str) -> Tilt | None:
    """Return what a line of cycle 19 says, in capitals, single blanks; None for another line."""
    found = LINE.fullmatch(line)
    if found is None:
        return None
    entries = ENTRY.findall(found[1])
    rest = REST.fullmatch(ENTRY.sub("", found[1]).strip())
    if rest is None or len({name for name, _ in entries}) < len(entries):
        return Tilt(HEIDENHAIN, name=NAME, refused=say("it is not known in this form"))
    if not entries:
        return Tilt(HEIDENHAIN, name=NAME, back=True)
    angles = {name: float(value) for name, value in entries}
    dist = float(rest[1] or 0.0)
    if why := beyond([*angles.values(), dist]):
        return Tilt(HEIDENHAIN, name=NAME, refused=why)
    spatial = one_by_one((2, 1, 0), [angles.get(name, 0.0) for name in "CBA"])
    move = MOVE if rest[0] else STAY
    return Tilt(HEIDENHAIN, spatial, move=move, dist=dist, name=NAME, angles=tuple(angles.items()))


def settle_meaning(tilt: Tilt, kinematics: Chain) -> Tilt:
    """Return a plane of cycle 19 as it is on that machine: refused where its angles are two planes."""
    letters = kinematics.letters[3:]
    if not tilt.angles or tilt.turn is None:
        return tilt
    if any(value and name not in letters for name, value in tilt.angles):
        return tilt
    words = dict(tilt.angles)
    stand = _compute_frame(kinematics, [words.get(name, 0.0) for name in letters])
    return tilt if np.allclose(stand, tilt.turn, atol=SAME) else replace(tilt, refused=TWO_MEANINGS)


def _compute_frame(kinematics: Chain, degrees: list[float]) -> Floats:
    """Return the machine's axes in the work, as columns (3, 3), with the rotary axes at ``degrees`` (2)."""
    rows = np.eye(3)
    for axis, angle in zip(kinematics.direction[:2:-1], np.radians(degrees[::-1]), strict=True):
        rows = turn(rows, axis, np.full(3, np.cos(angle)), np.full(3, np.sin(angle)))
    return np.asarray(rows.T)
