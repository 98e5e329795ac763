# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the rotary axes stand after a line that turns the tool to a plane's normal: by the machine's own inverse kinematics.

Two ways to stand take up the normal, each in several turns. Of those within the limits the control picks:

Fanuc       the least way of the master axis, then of the other, then the master nearest to 0; of a table and a head the
            table first (16i/18i/160i/180i-MB operator's manual, tool axis direction control: output judgement conditions).
Heidenhain  SEQ+ or SEQ-: the axis nearest to the tool is positive, or negative; without SEQ the shortest way (TNC7 basic
            81762x-19, tilting solution).
Siemens     DIR: the higher or lower value of the reference axis, the other where that cannot be reached (6FC5398-7CP41,
            10.6). Which axis it is, is set in the machine: the one nearest to the tool is taken, of two in the head the first.

At the pole, where the normal lies along the first axis, that axis stays: in the work all its angles are the same.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding, Severity
from freecad_fiveaxis.core.base.records import Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Angle, say
from freecad_fiveaxis.core.machine.kinematics import Chain, forward, inverse_axis
from freecad_fiveaxis.core.motion.program.guided import AT_POLE

from .arcs import Chords
from .plane_calls import FANUC, HEIDENHAIN, MOVE, Tilt
from .planes import IN_PLANE, Planes, refused
from .positions import ABSOLUTE, STEP, Moves, track

SLACK = 1e-9
"""rad; rounding at a limit."""
MOST_TURNS = 4
"""Whole turns on each side of where an axis stands that are looked at."""
ALIKE = 1e-7
"""rad; ways that are as long as each other."""
OFF_NORMAL = 0.01
"""deg; the tool lies along the normal, as far as rotary words are rounded."""
Words = list[tuple[Floats, Bytes]]


@dataclass(eq=False)
class Turned:
    """``words``: those of the lines, with the rotary words of the turning lines; ``findings``."""

    words: Words
    findings: tuple[Finding, ...]


def turned(kinematics: Chain, words: Words, at: Ints, planes: Planes, wrap: tuple[str, str]) -> Turned:
    """The words (m,) of the lines ``at`` (m,), with where the axes turn in the lines of ``planes.turning``."""
    made: Words = [(value.copy(), kind.copy()) for value, kind in words]
    rotary, stand, since, findings = made[3:], np.zeros(2), 0, list[Finding]()
    first = True
    for line, (tilt, normal) in planes.turning.items():
        row = int(np.searchsorted(at, line))
        if row > since:
            for k, (value, kind) in enumerate(rotary):
                stand[k] = track(value[since:row], kind[since:row], stand[k], since > 0, wrap[k] == "modulo")[-1]
        angles, why = _solution(kinematics, tilt, normal, np.radians(stand))
        if angles is None:
            findings.append(_lost(line, why))
            continue
        if not tilt.back and first:
            findings.append(_taken(kinematics, tilt, angles, line))
            first = False
        if tilt.move == MOVE and tilt.dist:
            axes = forward(kinematics, np.concatenate([np.zeros((2, 3)), np.radians([stand, angles])], axis=1))[1]
            for k, way in enumerate(tilt.dist * (axes[1] - axes[0])):
                made[k][0][row], made[k][1][row] = way, STEP
        for k, (value, kind) in enumerate(rotary):
            value[row], kind[row] = angles[k], ABSOLUTE
        stand, since = angles, row + 1
    return Turned(made, tuple(findings))


def _solution(kinematics: Chain, tilt: Tilt, normal: Floats, stand: Floats) -> tuple[Floats | None, str]:
    """Rotary words (2,) degrees, from where the axes ``stand`` (2,) rad; None, with the reason, where there are none."""
    if tilt.back:
        return np.degrees(_nearest_zero(kinematics, stand)), ""
    branches, sine = inverse_axis(kinematics, normal[None])
    if sine[0] < AT_POLE:
        branches[:, 0, 0] = stand[0]
    ways = _windings(branches[:, 0], stand)
    ways = ways[~np.isnan(ways).any(axis=1)]
    if not len(ways):
        return None, say("this machine cannot take up its normal")
    within = ((ways >= kinematics.low[3:] - SLACK) & (ways <= kinematics.high[3:] + SLACK)).all(axis=1)
    if not within.any():
        return None, say("no way to stand lies within the limits of the rotary axes")
    chosen = _chosen(kinematics, tilt, ways[within], stand)
    return (None, say("SEQ asks for a way that lies beyond the limits")) if chosen is None else (np.degrees(chosen), "")


def _windings(ways: Floats, stand: Floats) -> Floats:
    """The ways (n, 2) rad in the turns around where the axes stand."""
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
    """The axis (0 nearest to the work, 1 nearest to the tool) that the rule looks at first."""
    first, second = (axis.side for axis in kinematics.axes[3:])
    if rule == FANUC:
        return int(first == second == "table")
    return 0 if rule != HEIDENHAIN and first == "head" else 1


def _chosen(kinematics: Chain, tilt: Tilt, ways: Floats, stand: Floats) -> Floats | None:
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


def _taken(kinematics: Chain, tilt: Tilt, angles: Floats, line: int) -> Finding:
    letters = kinematics.letters[3:]
    first, second = letters[0] + f"{angles[0]:.4f}", letters[1] + f"{angles[1]:.4f}"
    text = say(
        "Tilted planes: of the ways to stand the one that {control} takes by its manual is taken, at first {first} {second}; a "
        "setting of the machine may choose another. Compare with the control.",
        control=tilt.rule.capitalize(),
        first=first,
        second=second,
    )
    return Finding(Severity.NOTE, "plane-solution", text, line=line)


def _lost(line: int, reason: str) -> Finding:
    text = say("The rotary axes cannot turn to the tilted plane: {reason}. Choose the program's own machine.", reason=reason)
    return Finding(Severity.ERROR, "axis-not-reachable", text, line=line)


def vector_findings(told: Moves) -> tuple[Finding, ...]:
    """Where tool axes are told by vectors in a tilted plane."""
    both = (told.meaning >= IN_PLANE) & ~np.isnan(told.told).all(axis=1)
    return (
        (refused(say("Tool vectors"), say("tool axes are told by vectors in it"), int(told.at[both.argmax()])),)
        if both.any()
        else ()
    )


def off_normal(planes: Planes, told: Moves, chords: Chords | None, axis: Floats) -> tuple[Finding, ...]:
    """The blocks (m,) in planes in which the tool ``axis`` (m, 3) does not lie along the normal, and nobody guides the tip."""
    row = np.arange(len(axis)) if chords is None else chords.row
    meaning, on, line = told.meaning[row], told.on[row], told.at[row]
    rows = np.flatnonzero((meaning >= IN_PLANE) & ~on)
    normal = planes.turn[meaning[rows] - IN_PLANE, :, 2]
    lean = np.degrees(2.0 * np.arcsin(np.clip(np.linalg.norm(axis[rows] - normal, axis=1) / 2.0, 0.0, 1.0)))
    off = lean > OFF_NORMAL
    if not off.any():
        return ()
    block = int(rows[off.argmax()])
    text = say(
        "In {count} blocks of a tilted plane the tool stands up to {lean} off its normal: nothing has turned it there, and where "
        "the control leads it then is not known. Turn the axes first (G53.1, TURN, MOVE, or their words).",
        count=int(off.sum()),
        lean=Angle(float(lean.max()), ".3g"),
    )
    return (Finding(Severity.ERROR, "plane-not-taken", text, float(off.sum()), block=block, line=int(line[block])),)
