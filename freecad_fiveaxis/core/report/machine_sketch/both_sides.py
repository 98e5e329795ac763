# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sketch of a whole machine."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine.kinematics import Chain

from .head_side import draw_head
from .shapes import Body
from .table_side import draw_table

LEAST_RADIUS = 12.0
"""mm, of a spindle."""
WIDER = 2.2
"""Radius of a platter, in radii of the spindle, that a small part has, too."""


@dataclass(frozen=True)
class ToolRoom:
    """What the sketch needs of a tool: ``height`` mm of its top above the driven point, ``radius`` mm where
    it is widest."""

    height: float
    radius: float


def sketch(
    kinematics: Chain, low: Floats, high: Floats, tool: ToolRoom, table: float | None = None
) -> tuple[Body, ...]:
    """Return the bodies of a machine that has a part with the box ``low``, ``high`` (3,) mm, work frame, on
    its table.

    ``table`` mm: height of the table's face, work frame, where it is known; the face never stands in the
    part.
    """
    low, high = np.asarray(low, float), np.asarray(high, float)
    spindle = max(1.25 * tool.radius, LEAST_RADIUS)
    return (
        *draw_table(kinematics, low, high, WIDER * spindle, table),
        *draw_head(kinematics, tool.height, spindle),
    )
