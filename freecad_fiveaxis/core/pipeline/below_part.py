# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of the finished path lies below the part: how many ways between cuts lead there, for links near the
part take the place of most of those over it; and how deep the tool dips below what the part stands on. That
may be a vice, parallels or a plate: nobody has named it, so that no check looks at it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freecad_fiveaxis.core.base.codes import Code, Severity
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, Option, plural, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.passes import standing_facets
from freecad_fiveaxis.core.tool.body import body_support
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .context import MillContext
from .options import tip_to_driven, tool_body

CUT = 0.5
"""Of what the part stands on: where more is cut from below, it is held otherwise."""

TOUCH = 0.05
"""mm: a tool that goes no lower beside the part is not told of."""


def count_below_part(
    findings: tuple[Finding, ...], path: CLPath, mesh: Mesh, above: float, radius: float
) -> tuple[Finding, ...]:
    """Return the findings, retracts and approaches below the part as there are in the finished ``path``;
    none where there is none. ``above`` mm: from the driven point to the hub, whose end of the tool is
    ``radius`` mm wide about it."""
    if not any(one.code == Code.RETRACT_BELOW_PART for one in findings):
        return findings
    first = _first_rows(_below(path, *mesh.box, above, radius))
    return tuple(
        _recount(one, path, first) if one.code == Code.RETRACT_BELOW_PART else one
        for one in findings
        if len(first) or one.code != Code.RETRACT_BELOW_PART
    )


def report_dip(context: MillContext, path: CLPath) -> tuple[Finding, ...]:
    """Tell how deep the tool dips below the plane on which the part stands in the finished ``path``: a note
    for what the end of the cutter needs beside a wall, a warning for more. Of a part that stands on the table
    itself there is none: the tool stays above that. A fixture below the part is looked at by itself."""
    standing, area, low = standing_facets(context.mesh), context.mesh.area, context.mesh.box[0]
    cut = area[standing & context.keep].sum() > CUT * area[standing].sum()
    if not standing.any() or cut or has_fixture_below(context):
        return ()
    lowest = _find_lowest(context, path)
    row = int(lowest.argmin())
    depth, radius = float(low[2] - lowest[row]), context.settings.cutter.cutter.radius
    if depth <= TOUCH:
        return ()
    deep = depth > radius + TOUCH
    text, severity = _describe_dip(depth, float(low[2]), deep), Severity.WARNING if deep else Severity.NOTE
    x, y, _ = path.tip[row].tolist()
    where = (x, y, float(lowest[row]))
    return (report_finding(Code.DIP_BELOW_PART, text, depth, radius, place=where, severity=severity),)


def _describe_dip(depth: float, height: float, deep: bool) -> str:
    low, by = Length(round(height, 3) + 0.0, bare=True), Length(depth, ".3g")
    if not deep:
        return say(
            "The tool dips up to {depth} below Z {height}, on which the part stands. Hold the part so that "
            "as much is free below its edges, or give what is there with {fixture}.",
            depth=by, height=low, fixture=Option("fixture"),
        )  # fmt: skip
    return say(
        "The tool goes up to {depth} below Z {height}, on which the part stands: farther than the end of the "
        "cutter needs beside a wall. Raise the part by as much, give what is there with {fixture}, or keep "
        "the tool from leaning so far with {max_axis_angle}.",
        depth=by, height=low, fixture=Option("fixture"), max_axis_angle=Option("max_axis_angle"),
    )  # fmt: skip


def _find_lowest(context: MillContext, path: CLPath) -> Floats:
    """Return the height (n,) mm of the lowest point of cutter, shank and holder at each row."""
    along = path.axis[:, 2]
    tip = path.tip[:, 2] - tip_to_driven(context.settings) * along
    return np.asarray(tip - body_support(tool_body(context.settings), -along))


def has_fixture_below(context: MillContext) -> bool:
    """Tell whether a fixture reaches below the part, at least under some of it."""
    low, high = context.mesh.box
    boxes = [one.mesh.box for one in context.fixtures]
    return any(bool((b[:2] < high[:2]).all() and (t[:2] > low[:2]).all() and b[2] < low[2]) for b, t in boxes)


def _below(path: CLPath, low: Floats, high: Floats, above: float, radius: float) -> Bools:
    """Which rows (n,) a link or a rapid leads to with all of the tool's end below the part's box ``low``,
    ``high`` (3,) mm, and not beside it."""
    hub = path.tip + above * path.axis
    beside = ((hub < low - radius) | (hub > high + radius))[:, :2].any(axis=1)
    between = np.isin(path.motion, (Motion.LINK, Motion.RAPID))
    return np.asarray(between & ~beside & (hub[:, 2] < low[2] - radius))


def _first_rows(below: Bools) -> Ints:
    """Return the first row (k,) of each stretch."""
    return np.flatnonzero(below & ~np.append(False, below[:-1]))


def _recount(one: Finding, path: CLPath, first: Ints) -> Finding:
    text = plural(
        len(first),
        "The tool passes below the part once between two cuts, because it looks down there. Check that "
        "nothing holds the part from below, or choose a tool axis that looks up.",
        "{count} times the tool passes below the part between two cuts, because it looks down there. Check "
        "that nothing holds the part from below, or choose a tool axis that looks up.",
    )
    x, y, z = path.tip[first[0]].tolist()
    return replace(one, text=text, value=float(len(first)), place=(x, y, z))
