# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lead-ins: the tool comes to the surface, and leaves it, on an arc tangent to the surface instead of along
its axis.

end     of a polyline, at which the tool comes from off the part or goes off it: by rapids or by a raised near
        link.
inner   the row next to an end on the polyline.         outer   the row next to it off the part.
arc     a quarter of a circle, from the end along the surface, away from the polyline, and up the surface
        normal; the axis stays.
over    the place over the arc's top, along the axis, that is as high as the outer row: where the approach
        along the axis begins.

Where the tool would enter the part, or the table, the radius is halved, at most twice; else there is no arc
at that end.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, plural
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM
from freecad_fiveaxis.core.geometry.facet_tree import FacetTree
from freecad_fiveaxis.core.gouge.obstacles import is_below
from freecad_fiveaxis.core.gouge.search import which_enter
from freecad_fiveaxis.core.gouge.swept_motion import straight_motion
from freecad_fiveaxis.core.tool.body import Body
from freecad_fiveaxis.core.toolpath.cl_path import CLPath, Motion

from .near_links import take_path_rows, with_margin

HALVINGS = 2
"""Times that the radius is halved where the arc is not free."""

QUARTER = 0.5 * np.pi


@dataclass(frozen=True)
class LeadOptions:
    """``radius`` mm of the arcs; ``tolerance`` mm of their chords; ``limit`` mm: so much the tool may enter;
    ``table`` mm: height of the table's face in the work frame, None where it is not known; ``driven`` and
    ``above`` mm: how far above the tip the points lie that the path's tips are and that goes straight."""

    radius: float
    tolerance: float
    limit: float
    table: float | None = None
    driven: float = 0.0
    above: float = 0.0


class Ends(NamedTuple):
    """``row``, ``inner``, ``outer`` (e,) rows of the path; ``along`` (e, 3) unit, along the surface away from
    the polyline, 0 where the polyline has no direction there; ``near`` (e,) whether a near link leads
    there."""

    row: Ints
    inner: Ints
    outer: Ints
    along: Floats
    near: Bools

    def select(self, some: Ints) -> Ends:
        """Select some (k,) of the ends."""
        return Ends(self.row[some], self.inner[some], self.outer[some], self.along[some], self.near[some])


class Arcs(NamedTuple):
    """``point`` (e, k, 3) mm from the first row off the contact to the top; ``over`` (e, 3) mm; ``apart``
    (e,) whether that is another place than the top."""

    point: Floats
    over: Floats
    apart: Bools


def lead_in(
    path: CLPath, tree: FacetTree, body: Body, options: LeadOptions, progress: Progress = silent
) -> CLPath:
    """Put an arc at each end of a polyline where the tool is free on it; its rows are links at feed.

    Gives the very path where it has no such ends. A finding counts the ends with a smaller arc, or none.
    """
    ends = find_ends(path, options.above - options.driven)
    progress("linking passes", 0.0)
    radius = _free_radius(path, ends, tree, body, options)
    found = _findings(path, ends, radius, options.radius)
    kept = np.flatnonzero(radius > 0.0)
    if not len(kept):
        return replace(path, findings=path.findings + found) if found else path
    ends = ends.select(kept)
    arcs = arcs_at(path, ends, radius[kept], _chords(options))
    dropped = _needless(path, ends, arcs, tree, body, options)
    return replace(_put_in(path, ends, arcs, dropped), findings=path.findings + found)


def find_ends(path: CLPath, above: float = 0.0) -> Ends:
    """Find the ends of polylines; ``above`` mm over the path's tips the point lies whose way gives the
    direction."""
    cut = np.concatenate([[False], np.isin(path.motion, (Motion.CUT, Motion.FILL)), [False, False]])
    before, here, after, next_ = cut[:-3], cut[1:-2], cut[2:-1], cut[3:]
    first = np.flatnonzero(~before & ~here & after)  # the row that ends an approach stands on the part
    first = first[first > 0]
    last = np.flatnonzero(here & ~after & ~next_)
    last = last[last < len(path.tip) - 1]
    row = np.concatenate([first, last])
    step = np.repeat([1, -1], [len(first), len(last)])
    raised = np.intersect1d(last + 1, first - 2)  # two rows off the part, from one polyline to the next
    raised = raised[path.motion[raised + 1] == Motion.LINK]
    near = np.isin(np.concatenate([first - 2, last + 1]), raised)
    return Ends(row, row + step, row - step, _along(path, row, row + step, above), near)


def _along(path: CLPath, row: Ints, inner: Ints, above: float) -> Floats:
    """Return unit directions (e, 3) from the inner row on, made perpendicular to the normal; 0 where there is
    none."""
    point = [path.tip[rows] + above * path.axis[rows] for rows in (row, inner)]
    way, normal = point[0] - point[1], path.normal[row]
    way = way - (way * normal).sum(axis=1, keepdims=True) * normal
    length = np.linalg.norm(way, axis=1, keepdims=True)
    return np.asarray(np.where(length > COINCIDENT_MM, way / np.maximum(length, COINCIDENT_MM), 0.0))


def _chords(options: LeadOptions) -> int:
    """Return the number of chords of a quarter circle that stay within the tolerance."""
    half = np.arccos(max(1.0 - options.tolerance / options.radius, np.cos(0.5 * QUARTER)))
    return int(np.ceil(QUARTER / (2.0 * half) - 1e-9))


def arcs_at(path: CLPath, ends: Ends, radius: Floats, chords: int) -> Arcs:
    """Lay an arc of ``radius`` (e,) mm from each end."""
    turn = QUARTER * np.arange(1, chords + 1) / chords
    axis, start = path.axis[ends.row], path.tip[ends.row]
    way = (
        np.sin(turn)[:, None] * ends.along[:, None]
        + (1.0 - np.cos(turn))[:, None] * path.normal[ends.row][:, None]
    )
    point = start[:, None] + radius[:, None, None] * way
    more = ((path.tip[ends.outer] - point[:, -1]) * axis).sum(axis=1)
    return Arcs(point, point[:, -1] + np.maximum(more, 0.0)[:, None] * axis, more > COINCIDENT_MM)


# ------------------------------------------------------------------------------------- free of part and table


def _free_radius(path: CLPath, ends: Ends, tree: FacetTree, body: Body, options: LeadOptions) -> Floats:
    """Return the radius (e,) mm at each end with which the tool is free, 0 where none is."""
    radius = np.full(len(ends.row), options.radius)
    left = np.flatnonzero(ends.along.any(axis=1))
    radius[~ends.along.any(axis=1)] = 0.0
    for _ in range(HALVINGS + 1):
        some = ends.select(left)
        left = left[
            ~_free(path, some, arcs_at(path, some, radius[left], _chords(options)), tree, body, options)
        ]
        radius[left] *= 0.5
    radius[left] = 0.0
    return radius


def _free(path: CLPath, ends: Ends, arcs: Arcs, tree: FacetTree, body: Body, options: LeadOptions) -> Bools:
    """Whether (e,) the tool is free from the end over the arc to the outer row."""
    if not len(ends.row):
        return np.zeros(0, np.bool_)
    tip = np.concatenate(
        [path.tip[ends.row][:, None], arcs.point, arcs.over[:, None], path.tip[ends.outer][:, None]], axis=1
    )
    axis = np.repeat(path.axis[ends.row][:, None], tip.shape[1], axis=1)
    blocks = np.flatnonzero(np.arange(axis.shape[0] * axis.shape[1]) % axis.shape[1] < axis.shape[1] - 1)
    tip = tip - options.driven * axis
    swept = straight_motion(tip.reshape(-1, 3), axis.reshape(-1, 3), options.above)
    enters = which_enter(body, tree, swept, options.limit, blocks)[blocks].reshape(len(tip), -1).any(axis=1)
    low = tip[np.arange(len(tip)), 1 + tip[:, 1:-1, 2].argmin(axis=1)]
    return np.asarray(~enters & ~is_below(body, low, axis[:, 0], options.table, options.limit))


def _needless(
    path: CLPath, ends: Ends, arcs: Arcs, tree: FacetTree, body: Body, options: LeadOptions
) -> Ints:
    """Return the raised rows that are not needed: near links that are free from arc to arc, without them."""
    place = path.tip.copy()
    place[ends.outer] = arcs.over
    pairs = _near_pairs(ends)
    if not len(pairs):
        return pairs
    rows = np.stack([pairs, pairs + 1], axis=1).ravel()
    axis, blocks = path.axis[rows], np.arange(0, len(rows), 2)
    swept = straight_motion(place[rows] - options.driven * axis, axis, options.above)
    enters = which_enter(with_margin(body), tree, swept, options.limit, blocks)[blocks]
    free = pairs[~enters]
    return np.intersect1d(np.concatenate([free, free + 1]), ends.outer)


def _near_pairs(ends: Ends) -> Ints:
    """Return the upper rows (g,) over the polyline's end of near links with an arc at either end."""
    entry = ends.outer < ends.row
    outer = np.where(entry, ends.outer - 1, ends.outer)
    return np.unique(outer[ends.near])


# ----------------------------------------------------------------------------------------- the path with arcs


def _put_in(path: CLPath, ends: Ends, arcs: Arcs, dropped: Ints) -> CLPath:
    """Return the path with the arcs' rows put in and ``dropped`` (d,) rows left out."""
    kept = np.setdiff1d(np.arange(len(path.tip)), dropped)
    point = np.concatenate([arcs.point, arcs.over[:, None]], axis=1)
    count = point.shape[1]
    new = np.column_stack([np.ones((len(point), count - 1), bool), arcs.apart])
    share = np.arange(1, count + 1) / (count + 1)
    place = ends.row[:, None] + (ends.outer - ends.row)[:, None] * share
    order = np.argsort(np.concatenate([kept, place[new]]), kind="stable")
    source = np.concatenate([kept, np.repeat(ends.row, count)[new.ravel()]])[order]
    tip = np.concatenate([path.tip[kept], point[new]])[order]
    feed = np.concatenate([_feed_on_part(path, ends)[kept], _feeds(path, ends, arcs)[new]])[order]
    new = order >= len(kept)
    motion = np.where(new, np.int8(Motion.LINK), path.motion[source])
    return take_path_rows(path, source, new, tip, path.axis[source], motion, feed)


def _feed_on_part(path: CLPath, ends: Ends) -> Floats:
    """Return the feeds (n,) mm/min of the path, but that an arc comes to the part at that of the cut."""
    feed, entry = path.feed.copy(), ends.outer < ends.row
    feed[ends.row[entry]] = path.feed[ends.inner[entry]]
    return feed


def _feeds(path: CLPath, ends: Ends, arcs: Arcs) -> Floats:
    """Return the feeds (e, k + 1) mm/min of the arcs' rows and the one over them: that of the cut, along the
    axis that of the plunge."""
    entry = ends.outer < ends.row
    cut = path.feed[np.maximum(ends.row, ends.inner)]
    feed = np.repeat(cut[:, None], arcs.point.shape[1] + 1, axis=1)
    feed[entry, -2] = path.feed[ends.row[entry]]
    linked = entry & ends.near
    feed[linked, -1] = path.feed[ends.outer[linked]]
    direct = linked & ~arcs.apart
    feed[direct, -2] = path.feed[ends.outer[direct]]
    return feed


def _findings(path: CLPath, ends: Ends, radius: Floats, wanted: float) -> tuple[Finding, ...]:
    """Say at how many ends the arc is smaller than asked for, or missing."""
    less = np.flatnonzero(radius < wanted)
    if not len(less):
        return ()
    text = plural(
        len(less),
        "{count} of {all} ends of passes has a smaller lead-in or lead-out than {radius}, or none, because "
        "the tool would enter the part or the table on it; a smaller radius fits in more places.",
        "{count} of {all} ends of passes have a smaller lead-in or lead-out than {radius}, or none, because "
        "the tool would enter the part or the table on it; a smaller radius fits in more places.",
        all=len(radius),
        radius=Length(wanted),
    )  # fmt: skip
    x, y, z = path.contact[ends.row[less[0]]].tolist()
    return (report_finding(Code.LEAD_IN_SMALLER, text, float(len(less)), 0.0, place=(x, y, z)),)
