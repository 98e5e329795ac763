# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutter, shank and holder against the whole part, along the way that they really go."""

from .check import CURES, DIVIDE, FREEING, GOUGES, GougeCheck, check_motion, check_program, program_motion
from .inside import count_solids, inside, is_closed
from .known_depths import Entries
from .outline import Outline, outline
from .rapid_ways import WayEntries
from .rest_material import RestMaterial, find_rest_material, too_deep_finding, uncut_finding
from .search import find_entries, which_enter
from .spots import spots
from .swept_motion import SweptMotion, real_motion, still_positions, straight_motion
from .too_tight import report_uncut

__all__ = [
    "CURES",
    "DIVIDE",
    "FREEING",
    "GOUGES",
    "Entries",
    "GougeCheck",
    "Outline",
    "RestMaterial",
    "SweptMotion",
    "WayEntries",
    "check_motion",
    "check_program",
    "count_solids",
    "find_entries",
    "find_rest_material",
    "inside",
    "is_closed",
    "outline",
    "program_motion",
    "real_motion",
    "report_uncut",
    "spots",
    "still_positions",
    "straight_motion",
    "too_deep_finding",
    "uncut_finding",
    "which_enter",
]
