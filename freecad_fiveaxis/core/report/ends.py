# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the NC file comes to the first block of a program made here, and leaves its last: moves of its head and
tail, no blocks of the Program.

plane   of a safe start ``clearance``: Z stands there when the rotary axes turn, comes down to the first block
        and rises from the last one. These two moves are counted; X, Y and the rotary axes stand by then where
        the first block wants them.
others  the way to that plane, and the retracts to a machine position or a reference point, are not counted:
        where they begin is not known. An audit of the NC file counts the same.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.base.sentences import Length, Sentence, say
from freecad_fiveaxis.core.motion.program import Program


def measure_ends(program: Program, plane: float | None) -> Floats:
    """Return the way of Z (2,) mm from the ``plane`` (mm, a word of Z) to the first block and from the last
    one to it; 0 where no plane is known."""
    if plane is None or not len(program.words):
        return np.zeros(2)
    return np.abs(program.words[[0, -1], 2] - plane)


def state_ends(numbers: Mapping[str, Any]) -> Sentence:
    """Say which of the first and last moves the axes' figures count; ``numbers``: the summary."""
    plane = numbers["start_plane"]
    if isinstance(plane, float):
        return say(
            "From and to, travel and the length of rapids count Z coming down from {plane} to the first "
            "block and rising to it from the last. Where the axes stand before is not known.",
            plane=Length(plane),
        )
    return say(
        "Where the axes stand before the first known position is not known, nor where a retract to a machine "
        "position or a reference point begins: neither is counted."
    )
