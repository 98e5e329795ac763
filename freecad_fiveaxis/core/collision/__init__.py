# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutter, shank and holder against the whole part, along the way that they really go."""

from .check import CURES, DIVIDE, GOUGES, GougeCheck, check_course, check_program, program_course, spots
from .inside import inside, is_closed
from .outline import Outline, outline
from .rest_material import Remainder, find_remainder, too_deep_finding, uncut_finding
from .search import Entries, find_entries, which_enter
from .swept_motion import Course, real_course, still_course, straight_course

__all__ = [
    "CURES",
    "DIVIDE",
    "GOUGES",
    "Course",
    "Entries",
    "GougeCheck",
    "Outline",
    "Remainder",
    "check_course",
    "check_program",
    "find_entries",
    "find_remainder",
    "inside",
    "is_closed",
    "outline",
    "program_course",
    "real_course",
    "spots",
    "still_course",
    "straight_course",
    "too_deep_finding",
    "uncut_finding",
    "which_enter",
]
