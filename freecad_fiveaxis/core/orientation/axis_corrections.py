# SPDX-License-Identifier: LGPL-2.1-or-later
"""The corrections of tool axes that know the machine, by name: what is cut stays, the axes change.

To add one: a line in AXIS_CORRECTIONS. ``job`` takes those that its settings name, ``compare`` puts each into
a column.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from freecad_fiveaxis.core.base.findings import Finding
from freecad_fiveaxis.core.base.progress import Progress
from freecad_fiveaxis.core.base.records import Bools, Floats
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.gouge.obstacles import Reacher
from freecad_fiveaxis.core.machine.kinematics import Chain
from freecad_fiveaxis.core.orientation.strategies import AxisOptions
from freecad_fiveaxis.core.passes import with_room
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

from .auto_axis import auto_axes, divide_path, find_contacts, refine_field
from .facets_with_axis import find_axis_field
from .minimax import minimax_axes
from .past_pole import deform_axes, trade_findings

Findings = tuple[Finding, ...]


@dataclass(frozen=True, eq=False)
class PartToCut:
    """The ``mesh`` whose ``facets`` (f,) are cut, and the tool, its machine and table (``reacher``) that must
    keep out of it."""

    mesh: Mesh
    facets: Bools
    reacher: Reacher


@dataclass(frozen=True)
class AxisCorrectionOptions:
    """``driven_to_hub`` mm: from the point that the words drive to the middle of the cutter's corner circles;
    ``ring`` mm: the radius of these, 0 for a ball; ``feed`` mm/min; ``tolerance`` mm; ``max_tilt``,
    ``max_change`` rad: how far an axis may leave the facet normals, and the axis given; ``lean``: lead and
    tilt that were asked for; ``part``: what is cut with which tool."""

    driven_to_hub: float = 0.0
    ring: float = 0.0
    feed: float = math.inf
    tolerance: float = 0.01
    max_tilt: float = 0.0
    max_change: float = 0.0
    lean: AxisOptions = AxisOptions()
    part: PartToCut | None = None


def _no_trade(*_: object) -> Findings:
    return ()


def _as_they_are(
    offset: OffsetPath, axis: Floats, options: AxisCorrectionOptions
) -> tuple[OffsetPath, Floats]:
    return offset, axis


@dataclass(frozen=True)
class AxisCorrection:
    """``axes``: from rows, their unit axes (n, 3) and a machine to better axes (n, 3), and what there is to
    say of them. ``trade``: of the same, what other limits would give; asked only where there was something to
    say, for it takes as long. ``rows``: the rows, and their axes, with as many between them as it needs."""

    axes: Callable[[OffsetPath, Floats, Chain, AxisCorrectionOptions, Progress], tuple[Floats, Findings]]
    trade: Callable[[OffsetPath, Floats, Chain, AxisCorrectionOptions, Progress], Findings] = _no_trade
    rows: Callable[[OffsetPath, Floats, AxisCorrectionOptions], tuple[OffsetPath, Floats]] = _as_they_are


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
    barrel = None if options.part is None else options.part.reacher.cutter.barrel
    return trade_findings(
        offset, axis, kinematics, change, options.tolerance, hub, progress, options.ring, barrel
    )


def _to_free_axes(
    offset: OffsetPath, axis: Floats, kinematics: Chain, options: AxisCorrectionOptions, progress: Progress
) -> tuple[Floats, Findings]:
    if options.part is None:
        return axis, ()
    mesh, reacher = options.part.mesh, replace(options.part.reacher, kinematics=with_room(kinematics))
    field = find_axis_field(mesh, options.part.facets, reacher, progress)
    contacts = find_contacts(offset, mesh, reacher)
    field = refine_field(field, offset, mesh, reacher, progress, contacts)
    axis, _, found = auto_axes(offset, axis, field, mesh, reacher, options.lean, progress, contacts)
    return axis, found


def _close_rows(
    offset: OffsetPath, axis: Floats, options: AxisCorrectionOptions
) -> tuple[OffsetPath, Floats]:
    """Rows no farther apart than the cutter's radius: over a wide facet the field turns too."""
    if options.part is None:
        return offset, axis
    cutter = options.part.reacher.cutter
    return divide_path(offset, axis, cutter.radius, cutter.ring, cutter.barrel)


AXIS_CORRECTIONS: Mapping[str, AxisCorrection] = {
    "minimax": AxisCorrection(_to_least_deviation),
    "auto": AxisCorrection(_to_free_axes, rows=_close_rows),
    "deform": AxisCorrection(_past_pole, _other_changes),
}
