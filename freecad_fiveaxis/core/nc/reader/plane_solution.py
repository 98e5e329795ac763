# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the rotary axes stand that take the tool to a plane's normal: by the machine's own inverse
kinematics.

Two ways to stand take up the normal, each in several turns. Of those within the limits the control picks:

Fanuc       the least way of the master axis, then of the other, then the master nearest to 0; of a table and
            a head the table first (16i/18i/160i/180i-MB operator's manual, tool axis direction control:
            output judgement conditions).
Heidenhain  SEQ+ or SEQ-: the axis nearest to the tool is positive, or negative; without SEQ the shortest way
            (TNC7 basic 81762x-19, tilting solution; the examples of iTNC 530, DIN/ISO programming, 6/2010,
            12.2).
Siemens     DIR: the higher or lower value of the reference axis, the other where that cannot be reached
            (6FC5398-7CP41, 10.6). Which axis it is, is set in the machine: the one nearest to the tool is
            taken, of two in the head the first.

At the pole, where the normal lies along the first axis, that axis is free: in the work all its angles are the
same. It stays, but with Heidenhain's TABLE ROT a table turns until the plane's X lies along the machine's
(TNC7 81762x-17, transformation types).
"""

from __future__ import annotations

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import say
from freecad_fiveaxis.core.machine.kinematics import Chain, inverse_axis
from freecad_fiveaxis.core.machine.kinematics.serial_chain import turn
from freecad_fiveaxis.core.motion.program.guided import AT_POLE

from .plane_calls import FANUC, HEIDENHAIN, Tilt

SLACK = 1e-9
"""rad; rounding at a limit."""
MOST_TURNS = 4
"""Whole turns on each side of where an axis stands that are looked at."""
ALIKE = 1e-7
"""rad; ways that are as long as each other."""


def solution(kinematics: Chain, tilt: Tilt, frame: Floats, stand: Floats) -> tuple[Floats | None, str]:
    """Pick rotary words (2,) degrees for the plane ``frame`` (3, 3), its axes as columns, from where the axes
    ``stand`` (2,) rad; None, with the reason, where there are none."""
    if tilt.back:
        return np.degrees(_nearest_zero(kinematics, stand)), ""
    branches, _ = inverse_axis(kinematics, frame[None, :, 2])
    if (
        np.linalg.norm(np.cross(kinematics.direction[3], frame[:, 2])) < AT_POLE
    ):  # the measure is 0 at a nutating axis' rim too
        branches[:, 0, 0] = _free(kinematics, tilt, frame, stand, branches[:, 0, 1])
    ways = _windings(branches[:, 0], stand)
    ways = ways[~np.isnan(ways).any(axis=1)]
    if not len(ways):
        return None, say("this machine cannot take up its normal")
    within = ((ways >= kinematics.low[3:] - SLACK) & (ways <= kinematics.high[3:] + SLACK)).all(axis=1)
    if not within.any():
        return None, say("no way to stand lies within the limits of the rotary axes")
    chosen = _choose_solution(kinematics, tilt, ways[within], stand)
    return (
        (None, say("SEQ asks for a way that lies beyond the limits"))
        if chosen is None
        else (np.degrees(chosen), "")
    )


def _free(kinematics: Chain, tilt: Tilt, frame: Floats, stand: Floats, second: Floats) -> Floats:
    """Return the free first axis (n,) rad beside the ``second`` (n,) rad: where it stands, or where TABLE ROT
    asks a table to turn."""
    if not tilt.table or kinematics.axes[3].side != "table":
        return np.full(len(second), stand[0])
    first, other = kinematics.direction[3:]
    x = np.tile((1.0, 0.0, 0.0), (len(second), 1))
    x = turn(x, other, np.cos(second), np.sin(second)) if kinematics.axes[4].side == "table" else x
    return np.asarray(np.arctan2(np.cross(x, frame[:, 0]) @ first, x @ frame[:, 0]))


def _windings(ways: Floats, stand: Floats) -> Floats:
    """Return the ways (n, 2) rad in the turns around where the axes stand."""
    near = ways + 2.0 * np.pi * np.rint((stand - ways) / (2.0 * np.pi))
    whole = 2.0 * np.pi * np.arange(-MOST_TURNS, MOST_TURNS + 1)
    grid = np.stack(np.meshgrid(whole, whole, indexing="ij"), axis=-1).reshape(-1, 2)
    return np.asarray((near[:, None] + grid[None]).reshape(-1, 2))


def _nearest_zero(kinematics: Chain, stand: Floats) -> Floats:
    """Both words 0, or the whole turns nearest to where they stand."""
    turns = 2.0 * np.pi * np.rint(stand / (2.0 * np.pi))
    fits = (turns >= kinematics.low[3:] - SLACK) & (turns <= kinematics.high[3:] + SLACK)
    return np.where(fits, turns, 0.0)


def master(kinematics: Chain, rule: str) -> int:
    """Return the axis (0 nearest to the work, 1 nearest to the tool) that the rule looks at first."""
    first, second = (axis.side for axis in kinematics.axes[3:])
    if rule == FANUC:
        return int(first == second == "table")
    return 0 if rule != HEIDENHAIN and first == "head" else 1


def _choose_solution(kinematics: Chain, tilt: Tilt, ways: Floats, stand: Floats) -> Floats | None:
    """One of the ways (n, 2) rad; None where none has the sign that is asked for."""
    one = master(kinematics, tilt.rule)
    other, way = 1 - one, np.abs(ways - stand)
    zero = np.abs((ways + np.pi) % (2.0 * np.pi) - np.pi)
    if tilt.rule == FANUC:
        keys = (way[:, one], way[:, other], zero[:, one], zero[:, other])
    elif tilt.rule == HEIDENHAIN:
        keep = ways[:, one] * tilt.side >= -SLACK
        if not keep.any():
            return None
        ways, way, zero = ways[keep], way[keep], zero[keep]
        keys = (way.sum(axis=1), way[:, one], zero[:, one], zero[:, other])
    else:
        folded = (ways[:, one] + np.pi - ALIKE) % (2.0 * np.pi) - np.pi
        keys = (-tilt.side * folded, way[:, one], way[:, other], zero[:, one])
    order = np.lexsort([np.rint(key / ALIKE) for key in keys[::-1]])
    return np.asarray(ways[order[0]])


def report_solution(kinematics: Chain, tilt: Tilt, angles: Floats, line: int) -> Finding:
    """Say which of the ways to stand (2,) deg is taken, and from which line on."""
    letters = kinematics.letters[3:]
    first, second = letters[0] + f"{angles[0]:.4f}", letters[1] + f"{angles[1]:.4f}"
    text = say(
        "Tilted planes: of the ways to stand the one that {control} takes by its manual is taken, at first "
        "{first} {second}; a setting of the machine may choose another. Compare with the control.",
        control=tilt.rule.capitalize(),
        first=first,
        second=second,
    )
    return report_finding(Code.PLANE_SOLUTION, text, line=line)


def report_unreachable(line: int, reason: str) -> Finding:
    """Say that the axes cannot turn to the plane of that line, and why."""
    text = say(
        "The rotary axes cannot turn to the tilted plane: {reason}. Choose the program's own machine.",
        reason=reason,
    )
    return report_finding(Code.AXIS_NOT_REACHABLE, text, line=line)
