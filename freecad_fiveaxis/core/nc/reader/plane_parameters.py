# SPDX-License-Identifier: LGPL-2.1-or-later
"""Q120, Q121 and Q122: the words of A, B and C that the control works out for each PLANE function.

A program that turns its axes itself (STAY) reads them: PLANE SPATIAL ... STAY, then L A+Q120 C+Q122 FMAX.
They hold "rotary axis coordinates calculated by the TNC" (Heidenhain TNC 640, 34059x-05, ISO programming,
1/2015, 9.11; iTNC 530, 9.10), 0 for an axis that the machine has not. Not looked up in a manual: that PLANE
RESET sets the basic position. Check it on the control.
"""

from __future__ import annotations

import re

import numpy as np

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine.kinematics import Chain

from .expressions import NUMBER
from .old_working_plane import read_working_plane, settle_meaning
from .plane_calls import STAY, heidenhain
from .plane_solution import report_solution, report_unreachable, solution

NAMES = {"A": "120", "B": "121", "C": "122"}
READS = re.compile(rb"Q12[0-2](?![0-9])")
STRAIGHT = re.compile(r" *(?:/ *)?LN?(?![A-Z]*LBL)(?=[ IABCXYZ])")
ROTARY = re.compile(rf"(?<![A-Z])(I?)([ABC]) *([-+]?(?:{NUMBER.pattern}))")


class PlaneParameters:
    """What one run on a machine (``kinematics``) knows of its planes: ``frame`` (3, 3) of the plane that is
    on, ``stand`` (2,) degrees of the rotary axes; ``findings``, with lines of the file."""

    def __init__(self, kinematics: Chain) -> None:
        self.kinematics, self.letters = kinematics, kinematics.letters[3:]
        self.frame, self.stand, self.followed = np.eye(3), np.zeros(2), 0
        self.findings: list[Finding] = []
        self.picked: Finding | None = None
        self.read = False

    def tilt(self, row: str, at: int, output: list[tuple[int, str]]) -> dict[str, float]:
        """Work out the parameters that the PLANE function or cycle 19 in ``row``, the line of index ``at``,
        sets after the rows ``output``; none where it is not understood (:mod:`.planes` says so)."""
        self._follow(output)
        line = " ".join(row.split())
        tilt = settle_meaning(read_working_plane(line) or heidenhain(line), self.kinematics)
        if tilt.refused:
            return {}
        self._turn_frame(tilt.turn, tilt.relative)
        angles, why = solution(self.kinematics, tilt, self.frame, np.radians(self.stand))
        if angles is None:
            self.findings.append(report_unreachable(at + 1, why))
            angles = self.stand
        elif not tilt.back:
            self.picked = report_solution(self.kinematics, tilt, angles, at + 1)
        if tilt.move != STAY:
            self.stand = angles.copy()
        found = dict(zip(self.letters, angles.tolist(), strict=True))
        return {name: found.get(letter, 0.0) for letter, name in NAMES.items()}

    def note_read(self) -> None:
        """Say once, where the program reads its first parameter, which way to stand was taken."""
        if not self.read and self.picked is not None:
            self.findings.append(self.picked)
            self.read = True

    def _turn_frame(self, turn: Floats | None, relative: bool) -> None:
        if turn is None:
            self.frame = np.eye(3)
        else:
            self.frame = self.frame @ turn if relative else turn

    def _follow(self, output: list[tuple[int, str]]) -> None:
        """Follow the rotary words of the rows that were made since the last time."""
        for _, row in output[self.followed :]:
            if STRAIGHT.match(row):
                for step, letter, value in ROTARY.findall(row):
                    if letter in self.letters:
                        k = self.letters.index(letter)
                        self.stand[k] = float(value) + (self.stand[k] if step else 0.0)
        self.followed = len(output)
