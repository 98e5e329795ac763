# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a CL file says besides the path: tool, spindle, coolant, cutter."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ClHead:
    """``tool`` number (None: no tool call), ``speed`` 1/min (0: not said), ``coolant`` on; ``diameter`` and ``corner`` radius of
    the cutter, mm (0: not said)."""

    tool: int | None = None
    speed: float = 0.0
    coolant: bool = False
    diameter: float = 0.0
    corner: float = 0.0
