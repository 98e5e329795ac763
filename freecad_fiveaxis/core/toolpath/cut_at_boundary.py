# SPDX-License-Identifier: LGPL-2.1-or-later
"""Passes cut where their contact, or the cutter's centre, crosses a boundary.

Passes are cut once they are offset and closed: what stands outside still keeps the cutter off, as facets do
that are not machined.

move    from a row of a path to the next one of its polyline.
node    a row of the path, or a place within a move where it crosses the boundary.
piece   nodes one after another with nothing outside between them; a pass of its own.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints
from freecad_fiveaxis.core.base.sentences import Length, say
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM, row_dot, slerp
from freecad_fiveaxis.core.passes.boundary import Boundary, nothing_inside

from .coedge import ROW_COLUMNS, OffsetPath

LEAST = 1e-6
"""mm; a piece that is no longer is none."""


@dataclass(frozen=True)
class Nodes:
    """``row`` (k,) of the path that each node is, or to which the move leads that it lies in, at ``share``
    (k,) of that move; ``polyline`` (k,); ``arrives`` (k,) whether the move to it, from the node before, lies
    inside."""

    row: Ints
    share: Floats
    polyline: Ints
    arrives: Bools

    def take(self, at: Ints) -> Nodes:
        """Take the nodes ``at`` (k,)."""
        return Nodes(self.row[at], self.share[at], self.polyline[at], self.arrives[at])


def cut_at_boundary(
    path: OffsetPath, boundary: Boundary, by_centre: bool = False, axis: Floats | None = None
) -> tuple[OffsetPath, Floats | None]:
    """Cut the passes where their contact crosses the boundary (``by_centre``: where the centre does), each
    piece inside a polyline of its own; the path itself where all of it lies inside. ``axis`` (n, 3) of the
    rows, where it is known already.

    The ends of a cut lie on the boundary but for rounding. A closed polyline that is cut goes on over its
    seam. Raises SettingsError where nothing is left.
    """
    if not len(path.point):
        raise SettingsError(nothing_inside(boundary), boundary.name)
    cut, along = cut_at_nodes(path, _find_nodes(path, boundary, by_centre), by_centre, axis)
    if cut is path:
        return path, axis
    if not len(cut.point):
        raise SettingsError(nothing_inside(boundary), boundary.name)
    return replace(cut, findings=(*path.findings, _report_cut(path, cut, boundary))), along


def cut_at_nodes(
    path: OffsetPath, found: Nodes, by_centre: bool, axis: Floats | None
) -> tuple[OffsetPath, Floats | None]:
    """Give the pieces between the nodes ``found``, and their axes; the path itself where all of it is kept.
    May leave no rows."""
    nodes = _with_halves_joined(path, found)
    if nodes is found and nodes.arrives[goes_on(nodes.polyline)].all():
        return path, axis
    nodes = _over_seams(path, nodes)
    arrives = nodes.arrives & goes_on(nodes.polyline)
    kept = np.flatnonzero(arrives | np.append(arrives[1:], False))
    begins, taken = ~arrives[kept], nodes.take(kept)
    columns, along = _columns(path, taken, by_centre, axis)
    kept = np.flatnonzero(_long(columns["centre" if by_centre else "point"], begins))
    begins = begins[kept]
    columns = {name: values[kept] for name, values in columns.items()}
    columns |= {"polyline": np.cumsum(begins) - 1, "fill": columns["fill"] & ~begins}
    beside, wall = _still_beside(path, taken.take(kept))
    return OffsetPath(
        **columns, beside=beside, wall=wall, findings=path.findings
    ), None if along is None else along[kept]


def goes_on(polyline: Ints) -> Bools:
    """Whether each node (k,) goes on with the polyline of the one before."""
    return np.asarray(np.diff(polyline, prepend=-1) == 0)


def _find_nodes(path: OffsetPath, boundary: Boundary, by_centre: bool) -> Nodes:
    """All rows and crossings in the order of the path. Moves that close a gap have no contact on their
    way."""
    place = boundary.project(path.centre if by_centre else path.point)
    end = np.flatnonzero(goes_on(path.polyline))
    solid = end if by_centre else end[~path.fill[end]]
    piece, share = boundary.curves.crossings(place[solid - 1], place[solid])
    row = np.concatenate([np.arange(len(place)), solid[piece]])
    share = np.concatenate([np.ones(len(place)), share])
    order = np.lexsort((share, row))
    row, share = row[order], share[order]
    start = place[np.maximum(row - 1, 0)]
    where = np.where((share < 1.0)[:, None], start + share[:, None] * (place[row] - start), place[row])
    arrives = np.append(False, boundary.curves.inside(0.5 * (where[:-1] + where[1:])))
    if not by_centre:
        inside = boundary.curves.inside(place)
        fills = np.flatnonzero(path.fill[row])
        arrives[fills] = inside[row[fills]] & inside[row[fills] - 1]
    return without_touches(Nodes(row, share, path.polyline[row], arrives & goes_on(path.polyline[row])))


def without_touches(nodes: Nodes) -> Nodes:
    """Without crossings that have the same on both sides: there the boundary is only touched."""
    same = nodes.arrives == np.append(nodes.arrives[1:], False)
    return nodes.take(np.flatnonzero((nodes.share == 1.0) | ~same))


def _with_halves_joined(path: OffsetPath, nodes: Nodes) -> Nodes:
    """Join the halves of closed passes from which facets were left out: two polylines, one that begins at
    their seam and one that ends there."""
    begin = np.flatnonzero(~goes_on(nodes.polyline))
    size = np.diff(begin, append=len(nodes.row))
    end = begin + size - 1
    pose = np.hstack([path.point, path.centre, path.pass_[:, None]])
    place = np.unique(pose[nodes.row[np.concatenate([begin, end])]], axis=0, return_inverse=True)[1].reshape(
        2, -1
    )
    closed = place[0] == place[1]
    ends_at = np.full(place.max() + 1, -1)
    ends_at[place[1, ~closed]] = np.flatnonzero(~closed)
    before = np.where(closed, -1, ends_at[place[0]])
    before[before >= 0] = np.where(
        before[before[before >= 0]] >= 0, -1, before[before >= 0]
    )  # no more than two in a row
    if (before < 0).all():
        return nodes
    line = np.where(before >= 0, before, np.arange(len(begin)))
    order = np.lexsort((np.arange(len(nodes.row)), np.repeat(before >= 0, size), np.repeat(line, size)))
    dropped = np.zeros(len(order), np.bool_)
    dropped[begin[before >= 0]] = True
    joined = replace(nodes, polyline=np.repeat(line, size))
    return joined.take(order[~dropped[order]])


def _over_seams(path: OffsetPath, nodes: Nodes) -> Nodes:
    """Begin closed polylines that are cut behind a move that lies outside, so that no piece ends at a seam;
    of the two rows of the seam the first goes."""
    first = np.flatnonzero(~goes_on(nodes.polyline))
    last = np.append(first[1:], len(nodes.row)) - 1
    one, two = nodes.row[first], nodes.row[last]
    joined = (last - first > 1) & (np.abs(path.centre[one] - path.centre[two]).max(axis=1) < COINCIDENT_MM)
    joined &= np.abs(path.point[one] - path.point[two]).max(axis=1) < COINCIDENT_MM
    at = np.arange(len(nodes.row))
    line = np.repeat(np.arange(len(first)), last - first + 1)
    outside = np.where(nodes.arrives | (at == first[line]), len(at), at)
    begin = np.minimum.reduceat(outside, first)  # the node behind the first move outside
    joined &= begin < len(at)
    turned = joined[line]
    begin, size = begin[line], (last - first)[line]
    within = np.where(turned, (at - begin) % np.maximum(size, 1), at)
    order = np.lexsort((within, line))
    return nodes.take(order[~(turned & (at == first[line]))[order]])


def _columns(
    path: OffsetPath, nodes: Nodes, by_centre: bool, axis: Floats | None
) -> tuple[dict[str, Any], Floats | None]:
    """Return the columns of the nodes' rows, and their axes."""
    row, share = nodes.row, nodes.share
    columns = {name: np.array(getattr(path, name)[row]) for name in ROW_COLUMNS}
    new = np.flatnonzero(share < 1.0)
    end, share = row[new], share[new]
    for name, values in _between(path, end, share, by_centre, axis is not None).items():
        columns[name][new] = values
    if axis is None:
        return columns, None
    along = np.array(axis[row])
    along[new] = slerp(axis[end - 1], axis[end], share)
    return columns, along


def _between(path: OffsetPath, end: Ints, share: Floats, by_centre: bool, seated: bool) -> dict[str, Any]:
    """Columns of rows at ``share`` (k,) of the moves that lead to the rows ``end`` (k,).

    On a facet a ball stands straight above its contact, as everywhere on that move; the normals beside the
    row turn evenly from one end of the move to the other, so that no axis turns at once. ``seated``: the
    centres are those of a cutter on its axes.
    """
    start, part = end - 1, share[:, None]
    point, centre = ((1.0 - part) * given[start] + part * given[end] for given in (path.point, path.centre))
    fill, facet = path.fill[end], path.before[end]
    normal = np.where(fill[:, None], slerp(path.normal[start], path.normal[end], share), facet)
    before, after = path.before[end], path.after[end]
    step = np.where(fill, path.step_before[end], np.linalg.norm(path.point[end] - path.point[start], axis=1))
    if not seated:
        lift = row_dot(path.centre[end] - path.point[end], facet)[:, None] * facet
        if by_centre:
            point = np.where(fill[:, None], point, _foot(path, end, centre - lift))
        else:
            centre = np.where(fill[:, None], centre, _foot_of_centre(path, end, point + lift))
    even = slerp(_mean(path, start), _mean(path, end), share)
    before, after = (np.where(fill[:, None], side, even) for side in (before, after))
    coedge = np.where(fill, path.coedge[end], -1)
    return {"point": point, "centre": centre, "normal": normal, "before": before, "after": after,
        "step_before": step,
            "step_after": np.where(fill, path.step_after[end], step), "coedge": coedge}  # fmt: skip


def _mean(path: OffsetPath, rows: Ints) -> Floats:
    """Return the mean (k, 3) of the normals beside rows; the row's own normal where they are opposed."""
    mean = path.before[rows] + path.after[rows]
    length = np.linalg.norm(mean, axis=1)[:, None]
    return np.where(length > COINCIDENT_MM, mean / np.maximum(length, COINCIDENT_MM), path.normal[rows])


def _foot(path: OffsetPath, end: Ints, place: Floats) -> Floats:
    """Return the contacts (k, 3) nearest to places on the moves that lead to the rows ``end``."""
    return _on_way(path.point[end - 1], path.point[end], place)


def _foot_of_centre(path: OffsetPath, end: Ints, place: Floats) -> Floats:
    """Return the centres (k, 3) nearest to places on those moves: beside a hollow the ball does not get
    everywhere."""
    return _on_way(path.centre[end - 1], path.centre[end], place)


def _on_way(start: Floats, end: Floats, place: Floats) -> Floats:
    way = end - start
    square = np.maximum(row_dot(way, way), np.finfo(float).tiny)
    return np.asarray(start + np.clip(row_dot(place - start, way) / square, 0.0, 1.0)[:, None] * way)


def _long(place: Floats, begins: Bools) -> Bools:
    """Which nodes (k,) are of pieces that have a length."""
    first = np.flatnonzero(begins)
    step = np.where(begins, 0.0, np.linalg.norm(np.diff(place, axis=0, prepend=place[:1]), axis=1))
    length = np.add.reduceat(step, first) if len(first) else np.empty(0)
    return np.repeat(length > LEAST, np.diff(first, append=len(begins)))


def _report_cut(path: OffsetPath, cut: OffsetPath, boundary: Boundary) -> Finding:
    """Return what of the passes is left."""
    left, whole = _length(cut), _length(path)
    text = say(
        "The passes end at boundary {name}: {left} of {whole} lie inside.", name=boundary.name,
        left=Length(left, ".6g"),
        whole=Length(whole, ".6g"),
    )  # fmt: skip
    return report_finding(Code.CUT_AT_BOUNDARY, text, left)


def _length(path: OffsetPath) -> float:
    """How far the contact moves on the surface, mm."""
    end = np.flatnonzero(goes_on(path.polyline) & ~path.fill)
    return float(np.linalg.norm(path.point[end] - path.point[end - 1], axis=1).sum())


def _still_beside(path: OffsetPath, nodes: Nodes) -> tuple[Ints, Floats]:
    """Where the rows beside a wall are now, and the walls."""
    where = np.full(len(path.point), -1)
    rows = np.flatnonzero(nodes.share == 1.0)
    where[nodes.row[rows]] = rows
    left = where[path.beside] >= 0
    return where[path.beside[left]], path.wall[left]
