# SPDX-License-Identifier: LGPL-2.1-or-later
"""Above which heights the tool stays where its axes are chosen freely over a part that stands on its
underside: what carries it there is not known."""

from __future__ import annotations

from freecad_fiveaxis.core.base.records import Bools

from .below_part import has_fixture_below
from .context import MillContext
from .over_table import reaches_into_table, table_below


def find_floors(context: MillContext, standing: Bools) -> tuple[float, ...]:
    """Return the heights, mm, falling, below which the tool goes only where it cannot cut from above them:
    the end of a cutter along a wall goes a radius below what the part stands on, along what looks down beside
    it as much again. None where it stands on no facet (f,) of ``standing``, has a fixture below, or its place
    is not known; none below the table."""
    settings, machine, mesh = context.settings, context.machine, context.mesh
    if not standing.any() or has_fixture_below(context) or reaches_into_table(settings, machine, mesh):
        return ()
    low, radius = float(mesh.box[0][2]), settings.cutter.cutter.radius
    table = table_below(settings, machine, mesh)
    return tuple(floor for floor in (low - radius, low - 2.0 * radius) if table is None or floor > table)
