# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a CL file is to be read: what holds where it says nothing itself."""

from __future__ import annotations

from dataclasses import dataclass

from .vocabulary import UNITS

ARC_SHARE = 0.2
"""Of the job's tolerance: so far the chords of an arc may leave it. The rest is left to the machine's own
motion."""
USUAL_CHORD = 0.002
"""mm, the share of the usual tolerance."""


@dataclass(frozen=True)
class ClReading:
    """``feed`` mm/min until the first FEDRAT; ``chord`` mm, the largest sagitta of the chords that an arc is
    divided into; ``units``: ``mm``, ``inch``, or ``file`` where nobody says it for a file that does not (mm,
    with a warning where it speaks against that); ``tool``: the number of the one whose moves are meant, None:
    all."""

    feed: float = 0.0
    chord: float = USUAL_CHORD
    units: str = "file"
    tool: int | None = None

    @property
    def scale(self) -> float:
        """mm of the unit until the file says one."""
        return 1.0 if self.units == "file" else UNITS[self.units.upper()]
