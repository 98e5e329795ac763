# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the settings allow rows of a pass that are merged, where they crowd."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.geometry.facet_tree import facet_tree
from freecad_fiveaxis.core.gouge import straight_motion, which_enter
from freecad_fiveaxis.core.gouge.lift import AIM
from freecad_fiveaxis.core.tool.body import Body
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath
from freecad_fiveaxis.core.toolpath.merge_rows import (
    Allowance,
    ToolPoints,
    find_kept_rows,
    merge_rows,
    rows_crowd,
)

from .context import MillContext
from .options import tip_to_surface, tool_body
from .settings import Settings

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
    """Return the rows that are kept, their axes (k, 3), and what merging uses up of the tolerance, mm: 0
    where rows do not crowd. ``seated``: with hubs."""
    if not rows_crowd(seated, context.settings.proof.tolerance):
        return seated, axis, 0.0
    allowed = read_allowance(context)
    rows = find_kept_rows(seated, axis, tool_points(context.settings), allowed)
    if _is_chosen_free(context):
        rows = _keep_entering(context, seated, axis, rows)
    if len(rows) == len(axis):
        return seated, axis, 0.0
    merged, turned = merge_rows(seated, axis, rows)
    found = report_merged(len(axis) - len(rows), len(axis), allowed.off)
    return replace(merged, findings=(*merged.findings, found)), turned, allowed.off


def tool_points(settings: Settings) -> ToolPoints:
    """Return the points of the tool by which rows are merged."""
    cutter = settings.cutter.cutter
    ring = 0.0 if cutter.touches_as_ball else cutter.ring if cutter.barrel is None else cutter.contact_reach
    return ToolPoints(cutter.corner - tip_to_surface(settings), cutter.corner, ring)


def read_allowance(context: MillContext) -> Allowance:
    """Return what a merged row may be off. Where the tool keeps off faces to avoid, no point of all of it may
    be off by more than the tolerance."""
    tolerance, turn = context.settings.proof.tolerance, TURN
    if context.keep_off is not None:
        turn = min(turn, tolerance / _height(tool_body(context.settings)))
    return Allowance(OFF * tolerance, ASIDE * tolerance, TIP * tolerance, turn)


def _is_chosen_free(context: MillContext) -> bool:
    """Tell whether the rows and their axes have been chosen for the whole tool to be free of the part."""
    chosen = context.field is not None or context.frames is not None
    return chosen or context.settings.gouge.gouge in ("tilt", "leave-out")


def _keep_entering(context: MillContext, seated: OffsetPath, axis: Floats, rows: Ints) -> Ints:
    """Return ``rows`` (k,) and all those between two of them on whose way the tool would enter the part."""
    settings, cutter = context.settings, context.settings.cutter.cutter
    tip = seated.centre[rows] - cutter.corner * axis[rows]
    swept = straight_motion(tip, axis[rows], tip_to_surface(settings))
    limit = AIM * settings.proof.tolerance if cutter.touches_as_ball else settings.proof.tolerance
    wide = np.flatnonzero(np.diff(rows) > 1)
    enters = which_enter(
        tool_body(settings), facet_tree(context.obstacles), swept, limit, wide, context.progress
    )
    kept = np.zeros(len(axis), np.bool_)
    kept[rows] = True
    kept[:-1] |= np.repeat(enters, np.diff(rows))  # from the first row on, which is always kept
    return np.flatnonzero(kept)


def report_merged(merged: int, count: int, off: float) -> Finding:
    """Say how many of the rows of the passes were merged, and how far these are at most from the way of the
    others, ``off`` mm."""
    text = say(
        "{merged} of {count} rows of the passes, which are close together, were merged; that takes the "
        "cutter off the surface by at most {off}.",
        merged=merged,
        count=count,
        off=Length(off),
    )
    return report_finding(Code.ROWS_MERGED, text, float(merged), unit="1")


def _height(body: Body) -> float:
    """How high the tool stands over its tip, mm."""
    return max(piece.high + piece.round for piece in body.pieces)
