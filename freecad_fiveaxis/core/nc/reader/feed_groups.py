# SPDX-License-Identifier: LGPL-2.1-or-later
"""Over which axes F is measured in a Siemens program (NC programming, 2.7.1: Feedrate, FGROUP, FGREF).

FGROUP(X,Y,A)   F is the speed over these axes; all others arrive with them.
FGROUP()        and a program without it: the basic setting, MD22420 as delivered: the geometry axes X Y Z,
                under TRAORI the tip's.
FGREF[A]=10     a rotary axis of the group counts by its way at this radius; 360/2pi mm without it: a
                degree is a millimetre.

Blocks in which no axis of the group moves are measured over all that do, degrees as millimetres. Where rotary
axes move alone and have no radius, F is in degrees a minute, in a program in inches too.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .codes import FEED_GROUPS, INCH

if TYPE_CHECKING:
    from .source import Source

WORD = re.compile(
    rb"(?<![A-Z0-9_$])(?:FGROUP *\(([^()\n]*)\)|"
    rb"FGREF *\[ *([ABC])[A-Z0-9_]* *\] *= *([0-9]+\.?[0-9]*)(?= *(?:$|[A-Z])))",
    re.MULTILINE,
)
GEOMETRY = "XYZ"


@dataclass(frozen=True)
class FeedGroup:
    """``axes``: the letters of the axes that F is measured over; ``radii``: of rotary ones, in the program's
    unit, where the program says it."""

    axes: str = GEOMETRY
    radii: tuple[tuple[str, float], ...] = ()

    def weights(self, letters: str) -> Floats:
        """Return the millimetres (5,) that a mm or degree of each axis counts; those with a radius in the
        program's unit."""
        radii = dict(self.radii)
        each = [math.radians(radii[letter]) if letter in radii else 1.0 for letter in letters]
        return np.array(each) * [letter in self.axes for letter in letters]


@dataclass
class FeedGroups:
    """The groups of a text in the order in which they come into force, as they are met."""

    met: list[FeedGroup] = field(default_factory=lambda: [FeedGroup()])
    now: FeedGroup = FeedGroup()

    def word(self, found: re.Match[bytes]) -> bytes:
        """Return the private code for what is in force from this FGROUP or FGREF on."""
        if found[2]:
            radii = {**dict(self.now.radii), found[2].decode(): float(found[3])}
            self.now = FeedGroup(self.now.axes, tuple(sorted(radii.items())))
        else:
            names = [name.strip()[:1].decode() for name in found[1].split(b",")]
            self.now = FeedGroup("".join(names) or GEOMETRY, self.now.radii)
        if self.now not in self.met and len(self.met) < len(FEED_GROUPS):
            self.met.append(self.now)
        at = self.met.index(self.now) if self.now in self.met else 0
        return (b"G%d" % (FEED_GROUPS[at] // 10)).ljust(len(found[0]))


@dataclass(frozen=True, eq=False)
class Measure:
    """Over what F is measured in each block: ``groups``; ``which`` (n,) of them; ``inch`` (n,): radii are in
    inches; ``letters`` of the machine."""

    groups: tuple[FeedGroup, ...]
    which: Ints
    inch: Bools
    letters: str

    def distance(self, change: Floats) -> Floats:
        """Return what F measures, mm, for ``change`` (n, 5) of the words, mm and degrees."""
        unit = np.where(self.inch, INCH, 1.0)[:, None]
        table = np.array([group.weights(self.letters) for group in self.groups])
        radii = np.array([[letter in dict(group.radii) for letter in self.letters] for group in self.groups])
        weight = table[self.which] * np.where(radii[self.which], unit, 1.0)
        square = ((change * weight) ** 2).sum(axis=1)
        rows = np.flatnonzero(square == 0.0)
        square[rows] = (change[rows] ** 2).sum(axis=1)
        degrees = ~(change[:, :3].any(axis=1) | radii[self.which].any(axis=1))
        return np.asarray(np.sqrt(square) * np.where(degrees, unit[:, 0], 1.0))


def find_measure(source: Source, at: Ints, letters: str) -> Measure | None:
    """Return over what F is measured in the blocks of the lines ``at`` (n,); None in other languages, where
    the controller says it."""
    if source.grammar.name != "siemens":
        return None
    lines, groups = source.lines, source.lines.words.groups
    codes = FEED_GROUPS[: len(groups)]
    which = lines.mode({code: k for k, code in enumerate(codes)}, 0)[at]
    return Measure(groups, which, lines.inch(source.grammar)[at], letters)
