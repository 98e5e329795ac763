# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cutter, shank and holder against the whole part, along the way that they really go."""

from .body import CUTTER, HOLDER, SHANK, Body, Piece, body_of, depth_of, frustum_piece, round_piece
from .check import GougeCheck, check_course, check_program
from .course import Course, real_course, straight_course
from .facet_tree import FacetTree, facet_tree
from .inside import inside, is_closed
from .leave_out import leave_out
from .lift import AIM, Lifted, lift_path
from .remainder import Remainder, find_remainder, uncut_finding
from .search import Entries, find_entries
from .tilt import tilt_free

__all__ = [
    "AIM",
    "CUTTER",
    "HOLDER",
    "SHANK",
    "Body",
    "Course",
    "Entries",
    "FacetTree",
    "GougeCheck",
    "Lifted",
    "Piece",
    "Remainder",
    "body_of",
    "check_course",
    "check_program",
    "depth_of",
    "facet_tree",
    "find_entries",
    "find_remainder",
    "frustum_piece",
    "inside",
    "is_closed",
    "leave_out",
    "lift_path",
    "real_course",
    "round_piece",
    "straight_course",
    "tilt_free",
    "uncut_finding",
]
