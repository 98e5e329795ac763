# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutter, shank and holder against the whole part, along the way that they really go."""

from .body import CUTTER, HOLDER, PARTS, SHANK, Body, Piece, body_of, depth_of, frustum_piece, round_piece
from .check import CURES, DIVIDE, GOUGES, GougeCheck, check_course, check_program, program_course, spots
from .course import Course, real_course, still_course, straight_course
from .facet_tree import FacetTree, facet_tree
from .inside import inside, is_closed
from .leave_out import leave_out
from .left_map import (
    NO_HEIGHT,
    HeightScale,
    facet_heights,
    height_colours,
    height_levels,
    height_scale,
    left_patches,
    level_colours,
    machined,
    round_values,
    scale_marks,
)
from .lift import AIM, Lifted, lift_path
from .outline import Outline, outline
from .remainder import Remainder, find_remainder, too_deep_finding, uncut_finding
from .search import Entries, find_entries, which_enter
from .tilt import tilt_free

__all__ = [
    "AIM",
    "CURES",
    "CUTTER",
    "DIVIDE",
    "GOUGES",
    "HOLDER",
    "NO_HEIGHT",
    "PARTS",
    "SHANK",
    "Body",
    "Course",
    "Entries",
    "FacetTree",
    "GougeCheck",
    "HeightScale",
    "Lifted",
    "Outline",
    "Piece",
    "Remainder",
    "body_of",
    "check_course",
    "check_program",
    "depth_of",
    "facet_heights",
    "facet_tree",
    "find_entries",
    "find_remainder",
    "frustum_piece",
    "height_colours",
    "height_levels",
    "height_scale",
    "inside",
    "is_closed",
    "leave_out",
    "left_patches",
    "level_colours",
    "lift_path",
    "machined",
    "outline",
    "program_course",
    "real_course",
    "round_piece",
    "round_values",
    "scale_marks",
    "spots",
    "still_course",
    "straight_course",
    "tilt_free",
    "too_deep_finding",
    "uncut_finding",
    "which_enter",
]
