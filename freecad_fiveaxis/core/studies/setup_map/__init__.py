# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where on the table the part should stand, and how turned."""

from .driven import Posting, part_box, turn_path
from .heat_map import heat_maps, pictures
from .mapping import Collide, setup_map
from .page import (
    advice,
    heat_map_html,
    list_marked_rows,
    origin_option,
    setup_json,
    setup_markers,
    setup_text,
    verdict,
)
from .setups import Kind, Region, SetupMap

__all__ = [
    "Collide", "Kind", "Posting", "Region", "SetupMap", "advice", "heat_map_html", "heat_maps",
    "list_marked_rows", "origin_option", "part_box", "pictures", "setup_json", "setup_map",
    "setup_markers", "setup_text", "turn_path", "verdict",
]  # fmt: skip
