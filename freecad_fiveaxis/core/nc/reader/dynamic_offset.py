# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dynamic work offset of Haas: under G254 the work zero goes with the table, and X Y Z stay parallel to
the machine's axes.

G254    X Y Z count from the work zero where the rotary axes, as they stand now, have carried it about the
        machine's centres of rotation. It is read as a tilted plane (:mod:`.planes`) whose zero is the work
        zero, and whose axes are the machine's.
G255    ends it, as M2 and M30 do. G28, G53 and M6 do not heed it.

Source: Haas, Next Generation Control, mill operator's manual, G254 Dynamic Work Offset (group 23), and the
operator's manual of the UMC-750, p. 40: for 3+1 and 3+2; the control knows the centers of rotation for the
rotary table (MRZP) and the location of the workpiece (active work offset); all rotary motion must be complete
before G254, X, Y and Z are to be told after it, and G255 comes before any rotary motion. What the control
does where this is not kept is not said there: it is an error here.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine import find_physical_columns
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, words_to_q

from . import codes
from .codes import Grammar
from .lines import Lines
from .plane_calls import HAAS, Tilt
from .planes import report_refusal
from .positions import ABSOLUTE, NOTHING, STEP, AxisWords, absolute_anyway, track

NAME = "G254"
SAME = 1e-6
"""deg; words that differ by less leave an axis where it is."""


def find_offset_planes(
    lines: Lines, axes: AxisWords, on: Bools, kinematics: Chain, grammar: Grammar
) -> tuple[Mapping[int, Tilt], list[Finding]]:
    """Return the planes that the lines with G254 begin and end, by line, and what is said of them; ``axes``:
    the words of each of the machine's axes in each line; ``on`` (lines,): whether the control guides the
    tip."""
    if grammar.name != "iso" or codes.DYNAMIC[0] not in lines.code:
        return {}, []
    stands = _stands(lines, axes[3:], kinematics, grammar)
    tilts, findings, since = dict[int, Tilt](), list[Finding](), -1
    called, ended = lines.any_of(codes.DYNAMIC[:1]), lines.any_of(codes.DYNAMIC[1:])
    turns = np.abs(np.diff(stands, axis=0, prepend=stands[:1])).max(axis=1) > 0.0
    for row in np.flatnonzero(called | ended | turns | np.diff(on, prepend=False)).tolist():
        reason = (
            _explain_break(stands, on, row, since) if called[row] or (since >= 0 and not ended[row]) else ""
        )
        if reason:
            findings.append(report_refusal(NAME, reason, row))
        if called[row] and not reason:
            tilts[row], since = _plane(kinematics, stands[row]), row
        elif ended[row] or reason:
            tilts[row], since = Tilt(HAAS), -1
    return tilts, findings


def _stands(lines: Lines, rotary: AxisWords, kinematics: Chain, grammar: Grammar) -> Floats:
    """Where the rotary axes stand (lines, 2) deg at the end of each line; 0 where nothing was told so far."""
    no_move, steps = lines.any_of(grammar.no_move), lines.mode(codes.DISTANCE, 0) == 1
    columns = []
    for (value, kind), axis in zip(rotary, kinematics.axes[3:], strict=True):
        step = steps & (kind == ABSOLUTE) & ~absolute_anyway(lines, axis.letter)
        meant = np.where(no_move, NOTHING, np.where(step, STEP, kind)).astype(np.int8)
        columns.append(track(value, meant, 0.0, False, axis.wrap == "modulo"))
    return np.stack(columns, axis=1)


def _explain_break(stands: Floats, on: Bools, row: int, since: int) -> str:
    """Why the control's way from ``row`` on is not known, under the G254 of the line ``since``, -1 where
    there is none."""
    if on[row]:
        return say("the tip is guided (G234) at the same time")
    if since >= 0 and np.abs(stands[row] - stands[since]).max() > SAME:
        return say("rotary axes turn before G255 has ended it")
    return ""


def _plane(kinematics: Chain, angles: Floats) -> Tilt:
    """Return the plane at the rotary words ``angles`` (2,) deg: its axes are where the machine's linear axes
    lead in the work."""
    there = find_physical_columns(kinematics.letters)
    head = [
        axis.letter
        for k, axis in enumerate(kinematics.axes)
        if k in there and axis.rotary and axis.side == "head"
    ]
    if head:
        return Tilt(
            HAAS,
            refused=say("{letter} turns the head, and it is for tables alone", letter=head[0]),
            name=NAME,
        )
    words = np.concatenate([np.vstack([np.zeros(3), np.eye(3)]), np.tile(angles, (4, 1))], axis=1)
    tip = forward(kinematics, words_to_q(words))[0]
    return Tilt(HAAS, (tip[1:] - tip[0]).T, name=NAME)
