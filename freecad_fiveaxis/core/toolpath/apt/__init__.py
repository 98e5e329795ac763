# SPDX-License-Identifier: LGPL-2.1-or-later
"""CL files in APT form (ISO 4343, ANSI X3.37): written, and read from any CAM system."""

from .head import ClHead, cutter_note, cutter_taken, of_cl_file
from .reader import ClFile, read_apt, read_cl_file
from .reading import ARC_SHARE, ClReading
from .writer import write_apt

__all__ = [
    "ARC_SHARE",
    "ClFile",
    "ClHead",
    "ClReading",
    "cutter_note",
    "cutter_taken",
    "of_cl_file",
    "read_apt",
    "read_cl_file",
    "write_apt",
]
