# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter-location path: links, retracts."""

from .linking import SAFE_MARGIN, keepout, tool_keepout, way_out
from .path import CLPath, LinkOptions, Motion, link_passes

__all__ = [
    "SAFE_MARGIN",
    "CLPath",
    "LinkOptions",
    "Motion",
    "keepout",
    "link_passes",
    "tool_keepout",
    "way_out",
]
