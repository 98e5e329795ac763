# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that turn the tool to a plane's normal: the words of the rotary axes there, and what the blocks in a
plane leave open.

Which of the ways to stand the control takes is :mod:`.plane_solution`'s.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bytes, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Angle, say
from freecad_fiveaxis.core.machine.kinematics import Chain, forward

from .arcs import Chords
from .plane_calls import MOVE
from .plane_solution import report_solution, report_unreachable, solution
from .planes import IN_PLANE, Planes, report_refusal
from .positions import ABSOLUTE, STEP, Moves, track

OFF_NORMAL = 0.01
"""deg; the tool lies along the normal, as far as rotary words are rounded."""
Words = list[tuple[Floats, Bytes]]


@dataclass(eq=False)
class Turned:
    """``words``: those of the lines, with the rotary words of the turning lines; ``findings``."""

    words: Words
    findings: tuple[Finding, ...]


def turn_into_planes(
    kinematics: Chain, words: Words, at: Ints, planes: Planes, wrap: tuple[str, str]
) -> Turned:
    """Return the words (m,) of the lines ``at`` (m,), with where the axes turn in the lines of
    ``planes.turning``."""
    output: Words = [(value.copy(), kind.copy()) for value, kind in words]
    rotary, stand, since, findings = output[3:], np.zeros(2), 0, list[Finding]()
    first = True
    for line, (tilt, frame) in planes.turning.items():
        row = int(np.searchsorted(at, line))
        if row > since:
            for k, (value, kind) in enumerate(rotary):
                stand[k] = track(value[since:row], kind[since:row], stand[k], since > 0, wrap[k] == "modulo")[
                    -1
                ]
        angles, why = solution(kinematics, tilt, frame, np.radians(stand))
        if angles is None:
            findings.append(report_unreachable(line, why))
            continue
        if not tilt.back and first:
            findings.append(report_solution(kinematics, tilt, angles, line))
            first = False
        if tilt.move == MOVE and tilt.dist:
            axes = forward(
                kinematics, np.concatenate([np.zeros((2, 3)), np.radians([stand, angles])], axis=1)
            )[1]
            for k, way in enumerate(tilt.dist * (axes[1] - axes[0])):
                output[k][0][row], output[k][1][row] = way, STEP
        for k, (value, kind) in enumerate(rotary):
            value[row], kind[row] = angles[k], ABSOLUTE
        stand, since = angles, row + 1
    return Turned(output, tuple(findings))


def vector_findings(planes: Planes, motions: Moves) -> tuple[Finding, ...]:
    """Where tool axes are told by vectors in a tilted plane."""
    both = (
        (motions.meaning >= IN_PLANE)
        & ~planes.frames(motions.meaning)
        & ~np.isnan(motions.vector).all(axis=1)
    )
    return (
        (
            report_refusal(
                say("Tool vectors"),
                say("tool axes are told by vectors in it"),
                int(motions.at[both.argmax()]),
            ),
        )
        if both.any()
        else ()
    )


def off_normal(planes: Planes, motions: Moves, chords: Chords | None, axis: Floats) -> tuple[Finding, ...]:
    """Return the blocks (m,) in planes in which the tool ``axis`` (m, 3) does not lie along the normal, and
    nobody guides the tip."""
    row = np.arange(len(axis)) if chords is None else chords.row
    meaning, on, line = motions.meaning[row], motions.on[row], motions.at[row]
    rows = np.flatnonzero((meaning >= IN_PLANE) & ~on & ~planes.frames(meaning))
    normal = planes.turn[meaning[rows] - IN_PLANE, :, 2]
    lean = np.degrees(2.0 * np.arcsin(np.clip(np.linalg.norm(axis[rows] - normal, axis=1) / 2.0, 0.0, 1.0)))
    off = lean > OFF_NORMAL
    if not off.any():
        return ()
    block = int(rows[off.argmax()])
    text = say(
        "In {count} blocks of a tilted plane the tool stands up to {lean} off its normal: nothing has turned "
        "it there, and where "
        "the control leads it then is not known. Turn the axes first (G53.1, TURN, MOVE, or their words).",
        count=int(off.sum()),
        lean=Angle(float(lean.max()), ".3g"),
    )
    return (report_finding(Code.PLANE_NOT_TAKEN, text, float(off.sum()), block=block, line=int(line[block])),)
