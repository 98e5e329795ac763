# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closes the gaps that offsetting leaves at co-edges (Lin & Ye, II.D and Fig. 6, 7).

offset    the path of the ball's centre: the contact moved out along a normal by the radius r (eq. 3).
gap       what opens between the offsets of two facets at a convex co-edge; a straight line across it would cut the edge.
R         length of the co-edge normal, r / cos(theta / 2) (eq. 4), at which the offset planes of both facets meet.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from freecad_fiveaxis.core.errors import SettingsError
from freecad_fiveaxis.core.findings import Finding, Severity
from freecad_fiveaxis.core.mesh import Mesh
from freecad_fiveaxis.core.passes import ContactPath
from freecad_fiveaxis.core.progress import Progress, silent
from freecad_fiveaxis.core.records import Bools, Floats, Ints, freeze, picked

from .junction import CHUNK, Junctions, Rows, Segments, direction, dot, find_junctions, find_segments, junction_rows
from .trimming import Trimmed, find_used_up, trim_polylines

NOTABLE = 0.01
"""mm cut into the part or left on it before it is worth a finding: a usual finishing tolerance."""

BATCH = 65536
"""Segments of tight polylines that are trimmed together: bounds the memory that this takes."""


@dataclass(frozen=True, eq=False)
class OffsetPath:
    """Contact points with the ball centres that belong to them, gaps closed; one row a cutter location.

    ``point`` (n, 3) contact, mm; ``centre`` (n, 3) of the ball, mm; ``normal`` (n, 3) unit, of the offset at this row
    (facet normal or co-edge normal); ``before`` and ``after`` (n, 3) the facet normals on either side of the contact point
    (equal inside a facet); ``step_before`` and ``step_after`` (n,) lengths of the contact segments on either side, mm
    (S1 and S2 of eqs. 9 and 10; equal at the ends of an open polyline); ``face``, ``coedge``, ``segment``, ``polyline``,
    ``pass_`` (n,) as in ContactPath; ``fill`` (n,) True where the move that arrives here closes a gap and cuts no facet.
    """

    point: Floats
    centre: Floats
    normal: Floats
    before: Floats
    after: Floats
    step_before: Floats
    step_after: Floats
    face: Ints
    coedge: Ints
    segment: Ints
    polyline: Ints
    pass_: Ints
    fill: Bools
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(
            self, None, point="f3", centre="f3", normal="f3", before="f3", after="f3", step_before="f", step_after="f",
            face="i", coedge="i", segment="i", polyline="i", pass_="i", fill="b",
        )  # fmt: skip


def lasting_rows(path: OffsetPath, rows: Ints) -> Ints:
    """Those of ``rows`` (ascending) that have a neighbour among them: a row alone cuts nothing."""
    begins = _begins(path, rows)
    size = np.diff(np.flatnonzero(begins), append=len(rows))
    return rows[np.repeat(size > 1, size)]


def take_rows(path: OffsetPath, rows: Ints) -> OffsetPath:
    """Some rows of a path, ascending: a polyline ends where rows are left out, and what is left of it begins a new one."""
    begins = _begins(path, rows)
    columns = {name: getattr(path, name)[rows] for name in ("face", "coedge", "segment", "pass_", "step_before", "step_after")}
    columns |= {name: picked(getattr(path, name), rows) for name in ("point", "centre", "normal", "before", "after")}
    return replace(path, **columns, polyline=np.cumsum(begins) - 1, fill=path.fill[rows] & ~begins)


def _begins(path: OffsetPath, rows: Ints) -> Bools:
    """Which rows begin a polyline when the others are left out."""
    return np.asarray((np.diff(rows, prepend=-2) != 1) | (np.diff(path.polyline[rows], prepend=-1) != 0))


def close_gaps(
    contact: ContactPath, mesh: Mesh, radius: float, tolerance: float, keep: Bools | None = None, progress: Progress = silent
) -> OffsetPath:
    """Offset the contact path by the ball's ``radius`` mm and close it at every co-edge (Lin & Ye, eqs. 3 to 5, Fig. 7).

    ``mesh`` is the part that the path was cut from; its normals travel with the path, so nothing is read from it here.
    ``keep`` (f,): facets to cut. The others only limit how near the ball may come: what stands over them is left out after
    the trimming, so that no ball enters a wall that is not cut itself.

    Convex: the arithmetic-mean normal of length R = r / cos(theta / 2) between the two facet normals; where R - r is more
    than ``tolerance`` mm, as many equal steps of theta as keep it within. Concave: both offsets trimmed where they cross.
    Chords keep off the two facets of their co-edge by r, on a convex part off all of it. Segments of no length are left out;
    those under which the ball does not fit are dropped, with a finding where more than NOTABLE of material stays or is cut into.
    A closed polyline ends where it began. Raises SettingsError for a radius or tolerance that is not above 0.
    """
    for name, value in (("cutter radius", radius), ("co-edge tolerance", tolerance)):
        if not 0.0 < value < np.inf:
            raise SettingsError(f"{name} is {value:g} mm; give a length above 0", value)
    progress("closing co-edges", 0.0)
    segments = find_segments(contact)
    junctions = find_junctions(segments, radius, tolerance)
    tight = find_used_up(segments, junctions)
    trimmed = []
    for at in _batches(segments, tight):
        progress("closing co-edges", 0.5 * float(at[0]) / len(segments.live))
        trimmed.append(trim_polylines(segments, junctions, at, radius, tolerance))
    place = _places(segments, junctions, tight, trimmed)
    path = _Columns(contact, segments, int(place[-1]), keep)
    for part, (where, rows) in enumerate(_all_rows(segments, junctions, tight, trimmed, place, radius)):
        path.write(where, rows)
        if part % 32 == 0:
            progress("closing co-edges", min(1.0, 0.5 + 0.25 * part * CHUNK / max(len(segments.live), 1)))
    whole = OffsetPath(**path.columns(), findings=_findings(contact, trimmed, keep))
    return whole if keep is None else take_rows(whole, lasting_rows(whole, np.flatnonzero(path.kept)))


def _batches(segments: Segments, tight: Ints) -> Iterator[Ints]:
    """Positions of the tight polylines, whole polylines at a time."""
    size = np.diff(segments.first, append=len(segments.live))[tight]
    batch = np.cumsum(size) // BATCH
    for number in np.unique(batch):
        chosen = tight[batch == number]
        count = size[batch == number]
        start = segments.first[chosen]
        yield np.repeat(start - np.cumsum(count) + count, count) + np.arange(count.sum())


def _places(segments: Segments, junctions: Junctions, tight: Ints, trimmed: list[Trimmed]) -> Ints:
    """Row (m + 1,) of the offset path at which each position begins; all rows of a tight polyline stand at its first one."""
    count = junctions.rows.copy()
    count[segments.first] += 1
    if len(tight):
        count[_is_tight(segments, tight)] = 0
        for part in trimmed:
            count[segments.first] += np.bincount(part.line, minlength=len(segments.first))
    return np.concatenate([[0], np.cumsum(count)])


def _is_tight(segments: Segments, tight: Ints) -> Bools:
    flag = np.zeros(len(segments.first), bool)
    flag[tight] = True
    return flag[segments.line]


def _all_rows(
    segments: Segments, junctions: Junctions, tight: Ints, trimmed: list[Trimmed], place: Ints, radius: float
) -> Iterator[tuple[Ints | slice, Rows]]:
    """The rows in parts, and where in the offset path they belong."""
    m = len(segments.live)
    easy = np.flatnonzero(~_is_tight(segments, tight)) if len(tight) else np.arange(m)
    last = np.full(m, -1)
    last[segments.first] = segments.last
    for low in range(0, len(easy), CHUNK // 2):  # each position makes about two or three rows
        at = easy[low : low + CHUNK // 2]
        count = place[at + 1] - place[at]
        head = np.cumsum(count) - count
        where: Ints | slice = slice(int(place[at[0]]), int(place[at[-1] + 1]))
        if len(tight):
            where = np.repeat(place[at] - head, count) + np.arange(count.sum())
        step = np.arange(count.sum()) - np.repeat(head + (last[at] >= 0), count)
        yield where, _easy_rows(segments, junctions, np.repeat(at, count), step, last, radius)
    for part in trimmed:
        start = np.flatnonzero(np.diff(part.line, prepend=-1))
        size = np.diff(start, append=len(part.line))
        shift = place[segments.first[part.line[start]]] - start
        yield np.arange(len(part.line)) + np.repeat(shift, size), part.rows


def _easy_rows(segments: Segments, junctions: Junctions, at: Ints, step: Ints, last: Ints, radius: float) -> Rows:
    """Rows of junctions; step -1 is the row where a polyline begins: its first contact, or the last row of its seam."""
    begin = np.flatnonzero(step < 0)
    first, end = at[begin], last[at[begin]]
    closed = segments.following[end] >= 0
    at[begin], step[begin] = np.where(closed, end, first), np.where(closed, junctions.rows[end] - 1, 0)
    rows = junction_rows(segments, junctions, at, step, radius)
    rows.fill[begin] = False
    opened, segment = begin[~closed], segments.live[first[~closed]]
    for column, value in ((rows.w1, 1.0), (rows.w2, 0.0), (rows.w3, 0.0), (rows.reach, radius), (rows.shift, 0.0)):
        column[opened] = value
    rows.base[opened], rows.left[opened], rows.right[opened] = 2 * segment, segment, segment
    return rows


class _Columns:
    """The columns of an offset path while they are filled in."""

    def __init__(self, contact: ContactPath, segments: Segments, n: int, keep: Bools | None) -> None:
        self.contact, self.segments = contact, segments
        self.cut = None if keep is None else keep[contact.face[::2]]  # which segments lie in facets that are kept
        self.kept = np.ones(n, bool)
        self.vectors = {name: np.empty((3, n)) for name in ("point", "centre", "normal", "before", "after")}
        self.lengths = {name: np.empty(n) for name in ("step_before", "step_after")}
        self.labels = {name: np.empty(n, np.int64) for name in ("face", "coedge", "segment", "polyline", "pass_")}
        self.fill = np.empty(n, bool)

    def write(self, where: Ints | slice, rows: Rows) -> None:
        """Work out the rows in short form and put them in their place."""
        segments, vectors = self.segments, self.vectors
        segment = rows.base >> 1
        if self.cut is not None:
            rows = self._without_neighbours(where, rows)
        point = segments.point.take(rows.base, axis=1)
        normal = segments.normal.take(rows.base, axis=1)
        normal *= rows.w1
        normal += rows.w2 * segments.normal.take(2 * rows.far, axis=1)
        along = np.flatnonzero((rows.shift != 0.0) | (rows.w3 != 0.0))
        if len(along):
            travel = direction(segments, segment[along])
            point[:, along] += rows.shift[along] * travel
            normal[:, along] += rows.w3[along] * travel
        centre = point + rows.reach * normal
        centre[:, rows.lifted] = rows.centre
        lift = rows.centre - point[:, rows.lifted]
        normal[:, rows.lifted] = lift / np.sqrt(dot(lift, lift))
        vectors["point"][:, where], vectors["normal"][:, where], vectors["centre"][:, where] = point, normal, centre
        vectors["before"][:, where] = segments.normal.take(2 * rows.left, axis=1)
        vectors["after"][:, where] = segments.normal.take(2 * rows.right, axis=1)
        self.lengths["step_before"][where] = segments.length.take(rows.left)
        self.lengths["step_after"][where] = segments.length.take(rows.right)
        for name in ("face", "coedge", "polyline", "pass_"):
            self.labels[name][where] = getattr(self.contact, name).take(rows.base)
        self.labels["segment"][where] = segment
        coedge = self.contact.coedge.take(rows.base)
        self.labels["coedge"][where] = np.where(rows.shift != 0.0, -1, coedge)  # a trimmed contact lies inside its facet
        self.fill[where] = rows.fill

    def _without_neighbours(self, where: Ints | slice, rows: Rows) -> Rows:
        """Mark the rows that are kept, and let the segments on their sides be kept ones."""
        assert self.cut is not None
        left, right = self.cut.take(rows.left), self.cut.take(rows.right)
        between = (left != right) & ((rows.w2 != 0.0) | (rows.w3 != 0.0))  # on its way round an edge to a left-out facet
        self.kept[where] = self.cut.take(rows.base >> 1) & ~between
        return rows._replace(left=np.where(left, rows.left, rows.right), right=np.where(right, rows.right, rows.left))

    def columns(self) -> dict[str, Any]:
        """All columns by name."""
        return {name: vector.T for name, vector in self.vectors.items()} | self.lengths | self.labels | {"fill": self.fill}


def _findings(contact: ContactPath, trimmed: list[Trimmed], keep: Bools | None) -> tuple[Finding, ...]:
    """Where the ball cuts into facets, and where it leaves material, by more than NOTABLE."""
    found = []
    wanted = np.ones(len(contact.face) // 2, bool) if keep is None else keep[contact.face[::2]]
    deep = _over([part.cut_into for part in trimmed], [part.depth for part in trimmed], wanted)
    if deep:
        text = (
            f"The facets curl tighter than the cutter at {deep.number} segments, and the cutter cuts up to {deep.worst:.3g} mm "
            "into them. Use a smaller cutter or a finer mesh, or check these places before milling."
        )
        code, place = "surface-tighter-than-cutter", _place(contact, deep.segment)
        found.append(Finding(Severity.WARNING, code, text, deep.worst, NOTABLE, "mm", place=place))
    high = _over([part.missed for part in trimmed], [part.height for part in trimmed], wanted)
    if high:
        much = f"up to {high.worst:.3g} mm of material stays" if np.isfinite(high.worst) else "a whole run of facets stays uncut"
        text = f"The cutter does not fit into the corners at {high.number} facet segments; {much}. Use a smaller cutter there."
        worst, place = high.worst if np.isfinite(high.worst) else None, _place(contact, high.segment)
        found.append(Finding(Severity.WARNING, "corner-not-reached", text, worst, NOTABLE, "mm", place=place))
    return tuple(found)


class _Worst(NamedTuple):
    """How many of the wanted segments are over NOTABLE, the largest value and its segment."""

    number: int
    worst: float
    segment: int


def _over(segments: list[Ints], values: list[Floats], wanted: Bools) -> _Worst | None:
    if not segments:
        return None
    segment, value = np.concatenate(segments), np.concatenate(values)
    over = np.flatnonzero((value > NOTABLE) & wanted[segment])
    if not len(over):
        return None
    worst = over[value[over].argmax()]
    return _Worst(len(np.unique(segment[over])), float(value[worst]), int(segment[worst]))


def _place(contact: ContactPath, segment: int) -> tuple[float, float, float]:
    x, y, z = contact.point[2 * segment : 2 * segment + 2].mean(axis=0)
    return float(x), float(y), float(z)
