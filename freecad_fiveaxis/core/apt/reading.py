# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a CL file is to be read: what holds where it says nothing itself."""

from __future__ import annotations

from dataclasses import dataclass

ARC_SHARE = 0.2
"""Of the job's tolerance: so far the chords of an arc may leave it. The rest is left to the machine's own motion."""
USUAL_CHORD = 0.002
"""mm, the share of the usual tolerance."""


@dataclass(frozen=True)
class ClReading:
    """``feed`` mm/min until the first FEDRAT; ``chord`` mm, the largest sagitta of the chords that an arc is divided into."""

    feed: float = 0.0
    chord: float = USUAL_CHORD
