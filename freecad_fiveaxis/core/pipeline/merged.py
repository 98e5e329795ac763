# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the settings allow rows of a pass that are merged, where they crowd."""

from __future__ import annotations

import math

from freecad_fiveaxis.core.base.records import Floats
from freecad_fiveaxis.core.tool.body import Body
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath
from freecad_fiveaxis.core.toolpath.merge_rows import Allowance, ToolPoints, merge_rows

from .context import MillContext
from .options import tip_to_surface, tool_body

OFF = 0.1
"""Of the tolerance: what merging may take the cutter off the surface by. The machine's own way is held to
what is left; a tenth costs it hardly a block, and four times as much would only halve the rows."""

ASIDE = 1.0
"""Of the tolerance: what the point that makes the surface may be off its place along the surface. Facets put
it to and fro by some of that, for their normals do."""

TIP = 2.0
"""Of the tolerance: the same of the tip, which makes no surface."""

TURN = math.radians(0.5)
"""What the axis may be turned by: normals of neighbouring facets say no better how a surface stands."""


def merge_crowded_rows(
    context: MillContext, seated: OffsetPath, axis: Floats
) -> tuple[OffsetPath, Floats, float]:
    """Return the rows that are kept, their axes (k, 3), and what merging uses up of the tolerance, mm: 0 where
    no rows crowd. ``seated``: with hubs."""
    cutter = context.settings.cutter.cutter
    allowed = read_allowance(context)
    ring = 0.0 if cutter.touches_as_ball else cutter.ring if cutter.barrel is None else cutter.contact_reach
    tool = ToolPoints(cutter.corner - tip_to_surface(context.settings), cutter.corner, ring, cutter.radius)
    merged, turned = merge_rows(seated, axis, tool, allowed)
    return merged, turned, 0.0 if merged is seated else allowed.off


def read_allowance(context: MillContext) -> Allowance:
    """Return what a merged row may be off. Where axes have been chosen for the whole tool to be free, none of
    its points may be off by more than the tolerance."""
    tolerance, turn = context.settings.proof.tolerance, TURN
    chosen = context.field is not None or context.frames is not None
    if chosen or context.settings.gouge.gouge == "tilt":
        turn = min(turn, tolerance / _height(tool_body(context.settings)))
    return Allowance(OFF * tolerance, ASIDE * tolerance, TIP * tolerance, turn)


def _height(body: Body) -> float:
    """How high the tool stands over its tip, mm."""
    return max(piece.high + piece.round for piece in body.pieces)
