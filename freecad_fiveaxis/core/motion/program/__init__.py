# SPDX-License-Identifier: LGPL-2.1-or-later
"""The NC program as the machine gets it: rounded words, feeds, times."""

from .feeds import rapid_minutes
from .guided import Guided, standing, take_up_axes
from .retract import plane_above, upwards, within_travel
from .rounded import Program, block_findings, block_starts, build_program, feed_blocks, find_unknown_ways
from .wrapping import shorter_turns

__all__ = [
    "Guided", "Program", "block_findings", "block_starts", "build_program", "feed_blocks",
    "find_unknown_ways", "plane_above", "rapid_minutes", "shorter_turns",
    "standing", "take_up_axes", "upwards", "within_travel",
]  # fmt: skip
