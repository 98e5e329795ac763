# SPDX-License-Identifier: LGPL-2.1-or-later
"""What F measures in each block of a Siemens program, by the axes that it names (:mod:`.feed_groups`).

Blocks in which no axis of the group moves are measured over all that do, degrees as millimetres. Where rotary
axes move alone and have no radius, F is in degrees a minute, in a program in inches too.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Bools, Floats, Ints

from .codes import FEED_GROUPS, INCH
from .feed_groups import FeedGroup
from .source import Source


@dataclass(frozen=True, eq=False)
class Measure:
    """Over what F is measured in each block: ``groups``; ``which`` (n,) of them; ``inch`` (n,): radii are in
    inches; ``inch_feed`` (n,): so is F; ``letters`` of the machine."""

    groups: tuple[FeedGroup, ...]
    which: Ints
    inch: Bools
    inch_feed: Bools
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
        return np.asarray(np.sqrt(square) * np.where(degrees & self.inch_feed, INCH, 1.0))


def find_measure(source: Source, at: Ints, letters: str) -> Measure | None:
    """Return over what F is measured in the blocks of the lines ``at`` (n,); None in other languages, where
    the controller says it."""
    if source.grammar.name != "siemens":
        return None
    lines, groups = source.lines, source.lines.words.groups
    codes = FEED_GROUPS[: len(groups)]
    which = lines.mode({code: k for k, code in enumerate(codes)}, 0)[at]
    inch, inch_feed = lines.inch(source.grammar)[at], lines.inch_feed(source.grammar)[at]
    return Measure(groups, which, inch, inch_feed, letters)
