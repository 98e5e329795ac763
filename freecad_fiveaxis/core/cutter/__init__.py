# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter: its shapes, how they are written, where the tip lies for a contact, and how wide it cuts."""

from .contact import ring_direction
from .cutter import LEAST, MOST, MOST_TAPER, Cutter, Profile
from .shadow import effective_radius, width_at
from .text import KINDS, apt_numbers, cutter_from_apt, cutter_name, cutter_sizes, cutter_text, kind_of, parse_cutter, sizes_text

__all__ = [
    "KINDS",
    "LEAST",
    "MOST",
    "MOST_TAPER",
    "Cutter",
    "Profile",
    "apt_numbers",
    "cutter_from_apt",
    "cutter_name",
    "cutter_sizes",
    "cutter_text",
    "effective_radius",
    "kind_of",
    "parse_cutter",
    "ring_direction",
    "sizes_text",
    "width_at",
]  # fmt: skip
