# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the table is below the part, and how far tool axes may therefore lean where nobody says it."""

from __future__ import annotations

import math

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.sentences import Length, Option, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.machine import Machine

from .settings import Settings
from .settings.tree import FROM_AXIS

AUTO = "auto"
IN_TABLE = 0.1
"""mm by which a part may lie in its table: zeros are touched off no better."""


def largest_axis_angle(settings: Settings, machine: Machine, mesh: Mesh) -> float:
    """How far tool axes may lean from +Z, rad: as asked; else as far as the machine goes where they are
    chosen freely over a table that is known; all round where they point at the only rotary axis; else (what
    is below is not known, or they follow the normals) no farther than level."""
    wanted, free = settings.passes.max_axis_angle, settings.tool_axis.tool_axis in (AUTO, FROM_AXIS)
    if wanted is not None:
        return wanted
    if settings.tool_axis.tool_axis == FROM_AXIS and machine.rotaries == 1:
        return math.pi
    return math.pi if free and table_below(settings, machine, mesh) is not None else 0.5 * math.pi


def table_below(settings: Settings, machine: Machine, mesh: Mesh) -> float | None:
    """Give the height of the table's face in the work frame, mm; None where it is not known or the part lies
    in it."""
    into = reaches_into_table(settings, machine, mesh)
    return None if machine.table is None or into else _table_height(settings, machine)


def reaches_into_table(settings: Settings, machine: Machine, mesh: Mesh) -> bool:
    """Tell whether a part lies in the table as it is placed: where that is, is not known."""
    return float(mesh.box[0][2]) < _table_height(settings, machine) - IN_TABLE


def table_looked_at(settings: Settings, machine: Machine, mesh: Mesh) -> float | None:
    """Give the height of the table's face in the work frame, mm, against which a finished program is checked;
    None: none."""
    return None if settings.gouge.gouge == "off" else table_below(settings, machine, mesh)


def report_part_in_table(settings: Settings, machine: Machine, mesh: Mesh) -> tuple[Finding, ...]:
    """Say that a part reaches below the table as it is placed, where undersides are not cut for that
    reason."""
    free = settings.passes.max_axis_angle is None and settings.tool_axis.tool_axis == AUTO
    if not free or not reaches_into_table(settings, machine, mesh):
        return ()
    low = float(mesh.box[0][2])
    text = say(
        "The part reaches {depth} below the table of {machine}, so its place is not known and no tool axis "
        "leans below level. "
        "Give {origin} the place of the work zero, or {max_axis_angle} how far axes may lean.",
        depth=Length(_table_height(settings, machine) - low, ".6g"), machine=machine.name,
        origin=Option("origin"),
        max_axis_angle=Option("max_axis_angle"),
    )  # fmt: skip
    return (report_finding(Code.PART_IN_TABLE, text, low),)


def _table_height(settings: Settings, machine: Machine) -> float:
    """mm of the table's face in the work frame; -inf where the machine does not say."""
    origin = machine.origin if settings.machine.origin is None else settings.machine.origin
    return -math.inf if machine.table is None else machine.table - origin[2]
