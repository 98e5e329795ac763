# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that turn the tool to a plane's normal: the words of the rotary axes there, and what the blocks in a
plane leave open.

Which of the ways to stand the control takes is :mod:`.plane_solution`'s.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import Angle, say
from freecad_fiveaxis.core.machine.kinematics import Chain, forward

from .blocks import Blocks
from .plane_calls import MOVE
from .plane_solution import report_solution, report_unreachable, solution
from .planes import IN_PLANE, Planes, report_change, report_refusal
from .positions import ABSOLUTE, STEP, AxisWords, Moves, find_wraps, tool_axes, track

OFF_NORMAL = 0.01
"""deg; the tool lies along the normal, as far as rotary words are rounded."""

OPPOSITE = 179.0
"""deg from the normal of a turned frame: the tool would cut from below."""


@dataclass(eq=False)
class Turned:
    """``words``: those of the lines, with the rotary words of the turning lines; ``findings``."""

    words: AxisWords
    findings: tuple[Finding, ...]


def turn_into_planes(kinematics: Chain, words: AxisWords, at: Ints, planes: Planes) -> Turned:
    """Return the words (m,) of the lines ``at`` (m,), with where the axes turn in the lines of
    ``planes.turning``."""
    output = [(value.copy(), kind.copy()) for value, kind in words]
    rotary, stand, since, findings = output[3:], np.zeros(2), 0, list(planes.findings)
    wrap = find_wraps(kinematics)
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


def plane_findings(
    kinematics: Chain, planes: Planes | None, motions: Moves, blocks: Blocks, words: Floats
) -> list[Finding]:
    """Return what the moves in tilted planes, and their blocks with ``words`` (n, 5), leave open."""
    if planes is None:
        return []
    axis = tool_axes(kinematics, words)
    return (
        _vectors_in_planes(planes, motions)
        + _find_guide_in_scale(planes, motions)
        + _off_normal(planes, blocks, axis)
        + _opposite(planes, blocks, axis)
    )


def _vectors_in_planes(planes: Planes, motions: Moves) -> list[Finding]:
    """Where tool axes are told by vectors in a tilted plane."""
    flat = (motions.meaning >= IN_PLANE) & ~planes.frames(motions.meaning)
    both = flat & ~np.isnan(motions.vector).all(axis=1)
    if not both.any():
        return []
    name, reason = say("Tool vectors"), say("tool axes are told by vectors in it")
    return [report_refusal(name, reason, int(motions.at[both.argmax()]))]


def _find_guide_in_scale(planes: Planes, motions: Moves) -> list[Finding]:
    """Report where the control guides the tip in coordinates that are mirrored or scaled."""
    uneven = np.append(~planes.is_rigid(), False)[np.maximum(motions.meaning - IN_PLANE, -1)]
    both = uneven & motions.on
    if not both.any():
        return []
    reason = say("the control guides the tip in mirrored or scaled coordinates")
    return [report_change("CYCL DEF 8, 11, 26", reason, int(motions.at[both.argmax()]))]


def _off_normal(planes: Planes, blocks: Blocks, axis: Floats) -> list[Finding]:
    """Return the blocks (n,) in planes in which the tool ``axis`` (n, 3) does not lie along the normal, and
    nobody guides the tip."""
    meaning = blocks.meaning
    rows = np.flatnonzero((meaning >= IN_PLANE) & ~blocks.on & ~planes.frames(meaning))
    lean = _lean_in_planes(planes, meaning[rows], axis[rows])
    off = lean > OFF_NORMAL
    if not off.any():
        return []
    block = int(rows[off.argmax()])
    text = say(
        "In {count} blocks of a tilted plane the tool stands up to {lean} off its normal: nothing has turned "
        "it there, and where "
        "the control leads it then is not known. Turn the axes first (G53.1, TURN, MOVE, or their words).",
        count=int(off.sum()),
        lean=Angle(float(lean.max()), ".3g"),
    )
    line = int(blocks.at[block])
    return [report_finding(Code.PLANE_NOT_TAKEN, text, float(off.sum()), block=block, line=line)]


def _opposite(planes: Planes, blocks: Blocks, axis: Floats) -> list[Finding]:
    """Return the blocks (n,) in which the tip is guided in a plane or frame against whose normal the tool
    points: a rotary word, or the machine, has the wrong sign."""
    meaning = blocks.meaning
    rows = np.flatnonzero((meaning >= IN_PLANE) & blocks.on)
    rows = rows[_lean_in_planes(planes, meaning[rows], axis[rows]) > OPPOSITE]
    if not len(rows):
        return []
    text = say(
        "In {count} blocks the tool points against the normal of the frame that is turned there, as if it "
        "cut from below. Compare the signs of the rotary words with those of the machine.",
        count=len(rows),
    )
    line = int(blocks.at[rows[0]])
    found = report_finding(Code.PLANE_NOT_TAKEN, text, float(len(rows)), block=int(rows[0]), line=line)
    return [replace(found, severity=Severity.WARNING)]


def _lean_in_planes(planes: Planes, meaning: Ints, axis: Floats) -> Floats:
    """Return how far (n,) deg the tool ``axis`` (n, 3) leans from the normals of the planes that ``meaning``
    (n,) names."""
    normal = planes.turn[meaning - IN_PLANE, :, 2]
    chord = np.linalg.norm(axis - normal, axis=1)
    return np.asarray(np.degrees(2.0 * np.arcsin(np.clip(chord / 2.0, 0.0, 1.0))))
