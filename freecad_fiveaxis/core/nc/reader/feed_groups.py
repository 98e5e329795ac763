# SPDX-License-Identifier: LGPL-2.1-or-later
"""Over which axes F is measured in a Siemens program (NC programming, 2.7.1: Feedrate, FGROUP, FGREF).

FGROUP(X,Y,A)   F is the speed over these axes; all others arrive with them.
FGROUP()        and a program without it: the basic setting, MD22420 as delivered: the geometry axes X Y Z,
                under TRAORI the tip's.
FGREF[A]=10     a rotary axis of the group counts by its way at this radius; 360/2pi mm without it: a
                degree is a millimetre.

What F then measures in each block: :mod:`.feed_measure`.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field

import numpy as np

from freecad_fiveaxis.core.base.records import Floats

from .codes import FEED_GROUPS

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
