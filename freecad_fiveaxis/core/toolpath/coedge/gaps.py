# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closes the gaps that offsetting leaves at co-edges (Lin & Ye, II.D and Fig. 6, 7).

offset    the path of the ball's centre: the contact moved out along a normal by the radius r (eq. 3).
gap       what opens between the offsets of two facets at a convex co-edge; a straight line across it would
          cut the edge.
R         length of the co-edge normal, r / cos(theta / 2) (eq. 4), at which the offset planes of both facets
          meet.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from freecad_fiveaxis.core.base.chunks import in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Floats, Ints, freeze, take_rows
from freecad_fiveaxis.core.base.sentences import Choice, Length, plural, say
from freecad_fiveaxis.core.geometry.mesh import Mesh
from freecad_fiveaxis.core.passes import ContactPath

from .breaks import Part
from .columns import Columns
from .junction import Segments, find_segments, groups
from .rows import Closed, close_rows, row_begins

NOTABLE = 0.01
"""mm cut into the part or left on it before it is worth a finding: a usual finishing tolerance."""


ROW_COLUMNS = {
    "point": "f3", "centre": "f3", "normal": "f3", "before": "f3", "after": "f3", "step_before": "f",
    "step_after": "f",
    "face": "i", "coedge": "i", "segment": "i", "polyline": "i", "pass_": "i", "fill": "b",
}  # fmt: skip
"""What every row of an offset path has, and its form."""


@dataclass(frozen=True, eq=False)
class OffsetPath:
    """Contact points with the ball centres that belong to them, gaps closed; one row a cutter location.

    ``point`` (n, 3) contact, mm; ``centre`` (n, 3) of the ball, mm; ``normal`` (n, 3) unit, of the offset at
    this row (facet normal or co-edge normal); ``before`` and ``after`` (n, 3) the facet normals on either
    side of the contact point (equal inside a facet); ``step_before`` and ``step_after`` (n,) lengths of the
    contact segments on either side, mm (S1 and S2 of eqs. 9 and 10; equal at the ends of an open polyline);
    ``face``, ``coedge``, ``segment``, ``polyline``, ``pass_`` (n,) as in ContactPath; ``fill`` (n,) True
    where the move that arrives here closes a gap and cuts no facet. ``beside`` (b,) rows at which the ball
    also touches a facet that is not cut, ``wall`` (b, 3) that facet's normal: until the tool axes have been
    held against them. ``middle``: a bottom that stands square on the surface does so with its middle over the
    contact, not with its foremost point.
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
    beside: Ints = field(default_factory=lambda: np.empty(0, np.int64))
    wall: Floats = field(default_factory=lambda: np.empty((0, 3)))
    middle: bool = False
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, None, **ROW_COLUMNS)
        freeze(self, None, beside="i", wall="f3")


def lasting_rows(path: OffsetPath, rows: Ints) -> Ints:
    """Those of ``rows`` (ascending) that have a neighbour among them: a row alone cuts nothing."""
    begins = row_begins(rows, path.polyline[rows])
    size = np.diff(np.flatnonzero(begins), append=len(rows))
    return rows[np.repeat(size > 1, size)]


def take_path_rows(path: OffsetPath, rows: Ints) -> OffsetPath:
    """Return some rows of a path, ascending: a polyline ends where rows are left out, and what is left of it
    begins a new one."""
    begins = row_begins(rows, path.polyline[rows])
    columns = {
        name: getattr(path, name)[rows]
        for name in ("face", "coedge", "segment", "pass_", "step_before", "step_after")
    }
    columns |= {
        name: take_rows(getattr(path, name), rows)
        for name in ("point", "centre", "normal", "before", "after")
    }
    columns |= {"polyline": np.cumsum(begins) - 1, "fill": path.fill[rows] & ~begins}
    return OffsetPath(**columns, middle=path.middle, findings=path.findings)


def break_polylines(path: OffsetPath, breaks: Bools) -> OffsetPath:
    """End polylines of ``path`` at these ``breaks`` (n - 1,) between rows, and begin new ones behind them."""
    if not breaks.any():
        return path
    polyline = path.polyline + np.append(0, np.cumsum(breaks))
    return replace(path, polyline=polyline, fill=path.fill & ~np.append(False, breaks))


def close_gaps(
    contact: ContactPath,
    mesh: Mesh,
    radius: float,
    tolerance: float,
    keep: Bools | None = None,
    progress: Progress = silent,
) -> OffsetPath:
    """Offset the contact path by the ball's ``radius`` mm and close it at every co-edge (Lin & Ye, eqs. 3 to
    5, Fig. 7).

    ``mesh`` is the part that the path was cut from; its normals travel with the path, and it is asked only
    where a trim would use up what the ball may reach. ``keep`` (f,): facets to cut. The others only limit how
    near the ball may come: what stands over them is left out after the trimming, so that no ball enters a
    wall that is not cut itself.

    Convex: the arithmetic-mean normal of length R = r / cos(theta / 2) between the two facet normals; where R
    - r is more than ``tolerance`` mm, as many equal steps of theta as keep it within. Concave: both offsets
      trimmed where they cross, each no farther than the other's facet reaches: where the offsets do not meet,
      the polyline is broken.
    Chords keep off the two facets of their co-edge by r, on a convex part off all of it. Segments of no
    length are left out; those under which the ball does not fit are dropped, with a finding where more than
    NOTABLE of material stays or is cut into. A closed polyline ends where it began. Raises SettingsError for
    a radius or tolerance that is not above 0.
    """
    for name, value in ((say("cutter radius"), radius), (say("co-edge tolerance"), tolerance)):
        if not 0.0 < value < np.inf:
            raise SettingsError(
                say("{name} is {value}; give a length above 0", name=name, value=Length(value)), value
            )
    progress("closing co-edges", 0.0)
    cut = None if keep is None else keep[contact.face[::2]]  # which segments lie in facets that are kept
    segments, part = find_segments(contact), Part(mesh, radius)

    def close(group: Segments) -> Closed:
        return close_rows(group, radius, tolerance, cut, part)

    parts = in_threads(close, groups(segments), lambda done: progress("closing co-edges", 0.5 * done))
    columns = Columns(contact, segments, parts)
    in_threads(columns.write, range(len(parts)), lambda done: progress("closing co-edges", 0.5 + 0.5 * done))
    progress("closing co-edges", 1.0)
    path = OffsetPath(**columns.values, **columns.walls, findings=_findings(contact, parts, cut))
    broken = np.zeros(len(path.point), bool)
    broken[columns.breaks] = True
    return break_polylines(path, broken[1:])


def _findings(contact: ContactPath, parts: list[Closed], cut: Bools | None) -> tuple[Finding, ...]:
    """Where the ball cuts into facets, and where it leaves material, by more than NOTABLE.

    Neither depth nor height is told: both are measured to the facets that were dropped, along their own pass,
    and may be less than what is found elsewhere.
    """
    found = []
    trimmed = [part.trimmed for part in parts if part.trimmed]
    wanted = np.ones(len(contact.face) // 2, bool) if cut is None else cut
    deep = _over([part.cut_into for part in trimmed], [part.depth for part in trimmed], wanted)
    if deep:
        text = plural(
            deep.number,
            "At 1 place the surface curls tighter than the cutter, which cuts into it; how deep is not known "
            "here. Have the path "
            "checked against the part ({report}), or lifted out of it ({lift}), or use a smaller cutter.",
            "At {count} places the surface curls tighter than the cutter, which cuts into it; how deep is "
            "not known here. Have the path checked against the part ({report}), or lifted out of it "
            "({lift}), or use a smaller cutter.",
            report=Choice("gouge", ("report",)),
            lift=Choice("gouge", ("lift",)),
        )
        code, place = Code.SURFACE_TIGHTER_THAN_CUTTER, _place(contact, deep.segment)
        found.append(report_finding(code, text, place=place))
    high = _over([part.missed for part in trimmed], [part.height for part in trimmed], wanted)
    if high:
        much = say("a whole stretch of the surface stays uncut")
        if np.isfinite(high.worst):
            much = say(
                "how much stays is not known from the passes alone, but told by the map of what is left "
                "where that is asked for ({left})",
                left=Choice("rest", ("on",)),
            )
        text = plural(
            high.number,
            "At 1 place an inside corner is tighter than the cutter; {much}. Use a smaller cutter there.",
            "At {count} places an inside corner is tighter than the cutter; {much}. Use a smaller cutter "
            "there.",
            much=much,
        )
        within = (
            None if np.isfinite(high.worst) else 0.0
        )  # whole stretches, of an area that is not known here
        place = _place(contact, high.segment)
        found.append(report_finding(Code.CORNER_NOT_REACHED, text, place=place, within=within))
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
