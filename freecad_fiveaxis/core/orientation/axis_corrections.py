# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corrections of tool axes that know the machine, by name: what is cut stays, the axes change.

To add one: a line in AXIS_CORRECTIONS. ``job`` takes those that its settings name, ``compare`` puts each into
a column.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.tool.barrel import Flank
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

from .minimax import minimax_axes
from .past_pole import deform_axes, trade_findings

Findings = tuple[Finding, ...]


@dataclass(frozen=True)
class AxisCorrectionOptions:
    """``driven_to_hub`` mm: from the point that the words drive to the middle of the cutter's corner circles;
    ``ring`` mm: the radius of these, 0 for a ball; ``feed`` mm/min; ``tolerance`` mm; ``max_tilt``,
    ``max_change`` rad: how far an axis may leave the facet normals, and the axis given; ``barrel``: the flank
    of a barrel."""

    driven_to_hub: float = 0.0
    ring: float = 0.0
    feed: float = math.inf
    tolerance: float = 0.01
    max_tilt: float = 0.0
    max_change: float = 0.0
    barrel: Flank | None = None


def _no_trade(*_: object) -> Findings:
    return ()


@dataclass(frozen=True)
class AxisCorrection:
    """``axes``: from rows, their unit axes (n, 3) and a machine to better axes (n, 3), and what there is to
    say of them. ``trade``: of the same, what other limits would give; asked only where there was something to
    say, for it takes as long."""

    axes: Callable[[OffsetPath, Floats, Chain, AxisCorrectionOptions, Progress], tuple[Floats, Findings]]
    trade: Callable[[OffsetPath, Floats, Chain, AxisCorrectionOptions, Progress], Findings] = _no_trade


def _to_least_deviation(
    offset: OffsetPath, axis: Floats, kinematics: Chain, options: AxisCorrectionOptions, progress: Progress
) -> tuple[Floats, Findings]:
    tilt, feed = options.max_tilt, options.feed
    return minimax_axes(
        offset, axis, kinematics, options.driven_to_hub, tilt, feed, progress, options.ring
    ), ()


def _past_pole(
    offset: OffsetPath, axis: Floats, kinematics: Chain, options: AxisCorrectionOptions, progress: Progress
) -> tuple[Floats, Findings]:
    return deform_axes(offset, axis, kinematics, options.max_change, progress)


def _other_changes(
    offset: OffsetPath, axis: Floats, kinematics: Chain, options: AxisCorrectionOptions, progress: Progress
) -> Findings:
    change, hub = options.max_change, options.driven_to_hub
    return trade_findings(
        offset, axis, kinematics, change, options.tolerance, hub, progress, options.ring, options.barrel
    )


AXIS_CORRECTIONS: Mapping[str, AxisCorrection] = {
    "minimax": AxisCorrection(_to_least_deviation),
    "deform": AxisCorrection(_past_pole, _other_changes),
}
