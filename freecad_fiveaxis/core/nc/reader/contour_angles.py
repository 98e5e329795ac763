# SPDX-License-Identifier: LGPL-2.1-or-later
"""Straight lines of a contour that are told by their angle: Fanuc's ``,A30.``, Siemens' ``ANG=30``.

The angle is counted in the working plane from its first axis (G17: X, G18: Z, G19: Y) to the second. One
coordinate of the end makes the other; a line with the angle alone ends where it meets the next one, which has
an angle and both coordinates of its end.

Sources: Siemens, SINUMERIK ONE, NC programming, 6FC5398-2EP40, 2.9.9 (contour definitions: the end point by
an angle, two straight lines), and 808D advanced, 6FC5398-4DP10, p. 89 (the angle is referred to the abscissa
of the plane, positive counter-clockwise); Fanuc's direct drawing dimension programming has the same words
after a comma.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import say

from . import codes
from .arcs import AXES
from .lines import Lines
from .positions import ABSOLUTE, NOTHING, STEP, AxisWords, MotionLines

EVEN = 1e-9
"""Sine or cosine below which a line lies along an axis."""


class Contour:
    """The words of the motion lines (m,), X Y Z, mm, with how they are meant; where they lead is followed
    from row to row."""

    def __init__(self, words: AxisWords, plane: Ints, meaning: Ints) -> None:
        self.words, self.plane = [(value.copy(), kind.copy()) for value, kind in words[:3]], plane
        self.place, self.since = np.full(3, np.nan), 0
        self.anew = np.flatnonzero(np.diff(meaning, prepend=meaning[:1]))

    def start(self, row: int) -> Floats:
        """Where the tool is before this row (3,) mm; NaN where nothing has told it in this system."""
        anew = self.anew[(self.anew > self.since) & (self.anew <= row)]
        if len(anew):
            self.place[:], self.since = np.nan, int(anew[-1])
        for k, (value, kind) in enumerate(self.words):
            value, kind = value[self.since : row], kind[self.since : row]
            absolute = np.flatnonzero(kind == ABSOLUTE)
            if len(absolute):
                self.place[k], value, kind = value[absolute[-1]], value[absolute[-1] :], kind[absolute[-1] :]
            self.place[k] += value[kind == STEP].sum()
        self.since = row
        return self.place

    def end(self, row: int) -> tuple[Floats, list[bool]]:
        """Where this row says that it ends, in its plane (2,), and which of both it tells."""
        start = self.start(row)
        axes = AXES[self.plane[row], :2].tolist()
        kinds = [self.words[axis][1][row] for axis in axes]
        value = [
            self.words[axis][0][row] + (start[axis] if how == STEP else 0.0)
            for axis, how in zip(axes, kinds, strict=True)
        ]
        return np.array(value), [how != NOTHING for how in kinds]

    def put(self, row: int, place: Floats) -> None:
        """Let this row end at ``place`` (2,) of its plane."""
        for axis, value in zip(AXES[self.plane[row], :2].tolist(), place.tolist(), strict=True):
            self.words[axis][0][row], self.words[axis][1][row] = value, ABSOLUTE


def apply_angles(lines: Lines, moving: MotionLines) -> tuple[MotionLines, list[Finding]]:
    """Return the motion lines with the words that their angles make."""
    angle = lines.column(codes.ANGLE)[moving.at]
    rows = np.flatnonzero(~np.isnan(angle))
    if not len(rows):
        return moving, []
    straight = np.isin(moving.mode, (codes.RAPID, codes.STRAIGHT))
    contour = Contour(moving.words, lines.mode(codes.PLANES, 0)[moving.at], moving.meaning)
    lost = list[int]()
    for row in rows.tolist():
        place = _end(contour, row, angle) if straight[row] else None
        if place is None:
            lost.append(row)
        else:
            contour.put(row, place)
    return replace(moving, words=[*contour.words, *moving.words[3:]]), _findings(lost, moving.at)


def _end(contour: Contour, row: int, angle: Floats) -> Floats | None:
    """Where the line of this row ends in its plane (2,); None where that is not known."""
    axes = AXES[contour.plane[row], :2]
    start = contour.start(row)[axes].copy()
    end, given = contour.end(row)
    way = _way(angle[row])
    if np.isnan(start).any():
        return None
    if sum(given) == 1:
        k = int(given[1])
        return None if abs(way[k]) < EVEN else start + (end[k] - start[k]) / way[k] * way
    if all(given):
        return end if _meets(start, end, way) else None
    return _crossing(contour, row, start, angle)


def _way(degrees: float) -> Floats:
    return np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])


def _meets(start: Floats, end: Floats, way: Floats) -> bool:
    """Whether the line leads there by its angle, as far as numbers are rounded."""
    off = end - start
    return bool(abs(off[0] * way[1] - off[1] * way[0]) <= 1e-3 * max(1.0, float(np.hypot(*off))))


def _crossing(contour: Contour, row: int, start: Floats, angle: Floats) -> Floats | None:
    """Where a line without an end meets the next one, which has an angle and an end."""
    if row + 1 >= len(angle) or np.isnan(angle[row + 1]) or contour.plane[row] != contour.plane[row + 1]:
        return None
    axes = AXES[contour.plane[row], :2].tolist()
    if any(contour.words[axis][1][row + 1] != ABSOLUTE for axis in axes):
        return None
    end = np.array([contour.words[axis][0][row + 1] for axis in axes])
    one, two = _way(angle[row]), _way(angle[row + 1])
    cross = float(one[0] * two[1] - one[1] * two[0])
    if abs(cross) < EVEN:
        return None
    off = end - start
    return start + float(off[0] * two[1] - off[1] * two[0]) / cross * one


def _findings(lost: list[int], line: Ints) -> list[Finding]:
    if not lost:
        return []
    text = say(
        "{count} lines by their angle (,A, ANG=) are not worked out, first NC line {line}: it takes one "
        "coordinate of the end, or a next line with an angle and both. Post the places of their ends.",
        count=len(lost),
        line=int(line[lost[0]]),
    )
    return [report_finding(codes.CORNER[0], text, float(len(lost)), line=int(line[lost[0]]), unit="")]
