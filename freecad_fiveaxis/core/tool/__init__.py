# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter: its shapes, how they are written, where the tip lies for a contact, and how wide it cuts.

No numpy until a method asks for it: options and their help need a cutter's name and sizes alone.
"""

from .cutter import LEAST, MOST, MOST_TAPER, Cutter, Profile
from .text import (
    KINDS,
    SIZES,
    apt_numbers,
    cutter_from_apt,
    cutter_name,
    cutter_sizes,
    cutter_text,
    flank_numbers,
    kind_of,
    neck_numbers,
    parse_cutter,
    sizes_text,
)

__all__ = [
    "KINDS",
    "LEAST",
    "MOST",
    "MOST_TAPER",
    "SIZES",
    "Cutter",
    "Profile",
    "apt_numbers",
    "cutter_from_apt",
    "cutter_name",
    "cutter_sizes",
    "cutter_text",
    "flank_numbers",
    "kind_of",
    "neck_numbers",
    "parse_cutter",
    "sizes_text",
]  # fmt: skip
