# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter-location (CL) path: links, retracts.

motion    what the move that arrives at a row does: CUT cuts a facet, FILL closes a gap at a co-edge, LINK
          goes at feed away from or to the part along the tool axis, RAPID goes above the part.
centre    of the ball; for a cutter that is no ball, its hub (see core/tool/cutter.py), of which the same is
          true.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import IntEnum
from typing import Any, Literal

import numpy as np

from freecad_fiveaxis.core.base.chunks import in_threads
from freecad_fiveaxis.core.base.codes import Code
from freecad_fiveaxis.core.base.errors import SettingsError
from freecad_fiveaxis.core.base.findings import Finding, report_finding
from freecad_fiveaxis.core.base.progress import Progress, silent
from freecad_fiveaxis.core.base.records import Bools, Bytes, Floats, Insertion, Ints, freeze
from freecad_fiveaxis.core.base.sentences import Number, say
from freecad_fiveaxis.core.base.vectors import COINCIDENT_MM
from freecad_fiveaxis.core.tool import Cutter
from freecad_fiveaxis.core.tool.body import Body, body_of, lower_body
from freecad_fiveaxis.core.toolpath.coedge import OffsetPath

from .linking import LOOKS_DOWN, WayOut, tool_keepout, way_out

CONTROL_POINTS = ("tip", "centre")


class Motion(IntEnum):
    """What the move that arrives at a row does."""

    CUT = 0
    FILL = 1
    LINK = 2
    RAPID = 3


@dataclass(frozen=True, eq=False)
class CLPath:
    """The whole path of the tool in the work frame; row i is the end of move i, row 0 the first position.

    ``tip`` (n, 3) the point that the words drive, mm: the cutter's tip, or its centre where the control point
    is the centre; ``axis`` (n, 3) unit, tip to holder; ``motion`` (n,) of :class:`Motion`; ``feed`` (n,)
    mm/min of the tip over the part (0 for RAPID); ``contact`` (n, 3) mm; ``normal`` (n, 3) unit, the
    offset's; ``face``, ``coedge``, ``pass_`` (n,), -1 where there is none. Off the part contact is ``tip``
    and normal is the axis; the LINK row that ends an approach stands on the part.
    """

    tip: Floats
    axis: Floats
    motion: Bytes
    feed: Floats
    contact: Floats
    normal: Floats
    face: Ints
    coedge: Ints
    pass_: Ints
    findings: tuple[Finding, ...] = ()

    def __post_init__(self) -> None:
        freeze(
            self,
            None,
            tip="f3",
            axis="f3",
            motion="m",
            feed="f",
            contact="f3",
            normal="f3",
            face="i",
            coedge="i",
            pass_="i",
        )


@dataclass(frozen=True)
class LinkOptions:
    """``clearance`` mm of rapids from the part's box; ``feed`` and ``plunge_feed`` mm/min; ``control_point``:
    what the words drive, the cutter's tip or the ball's centre; ``turning``: the part turns under the tool,
    so that a way below it where it lies now is none below it then."""

    clearance: float = 5.0
    feed: float = 1000.0
    plunge_feed: float = 300.0
    control_point: Literal["tip", "centre"] = "tip"
    turning: bool = False

    def __post_init__(self) -> None:
        for name, least in (
            ("clearance", 0.0),
            ("feed", np.nextafter(0.0, 1.0)),
            ("plunge_feed", np.nextafter(0.0, 1.0)),
        ):
            value = getattr(self, name)
            if not least <= value < np.inf:
                raise SettingsError(
                    say("{name} is {value}; give a number above 0", name=name, value=Number(value))
                    if least
                    else say(
                        "{name} is {value}; give a number of at least 0", name=name, value=Number(value)
                    ),
                    value,
                )
        if self.control_point not in CONTROL_POINTS:
            known = ", ".join(CONTROL_POINTS)
            raise SettingsError(
                say(
                    "control_point is {control_point}; choose one of {known}",
                    control_point=repr(self.control_point),
                    known=known,
                ),
                self.control_point,
            )


def link_passes(
    path: OffsetPath, axis: Floats, cutter: Cutter, low: Floats, high: Floats, options: LinkOptions,
    progress: Progress = silent,
    body: Body | None = None, retreat: Floats | None = None,
) -> CLPath:  # fmt: skip
    """Return the whole path of the tool: the passes as they stand, with a safe way from each polyline to the
    next.

    ``axis`` (n, 3) unit, one for each row of ``path``; ``low``, ``high`` (3,) mm the part's box; ``body``:
    cutter, shank and holder, None: the cutter alone; ``retreat`` (n, 3) unit: in which direction it leaves a
    row, None: along its axis. From the end of a polyline the tool retracts that way until it is clear of the
    inflated box, goes straight up to the safe plane, across (there the axis turns), straight down, and so to
    the next start. A polyline that starts where the last one ended goes on without a retract. Raises
    SettingsError where there are no passes.
    """
    if not len(path.point):
        raise SettingsError(
            say(
                "there are no passes: none runs over a facet that the tool reaches; check its axis, stepover "
                "and direction"
            ),
            0,
        )
    progress("linking passes", 0.0)
    first = _starts(path.polyline)
    last = np.append(first[1:], len(path.point)) - 1
    seen = lower_body(body_of(cutter) if body is None else body, cutter.corner)

    def way(row: Ints, other: Ints) -> WayOut:
        """Out at these rows; each as high as the way in at the ``other`` row, or out of it, has to be."""
        own, its = (
            tool_keepout(low, high, cutter.radius, options.clearance, seen, axis[rows])
            for rows in (row, other)
        )
        return way_out(
            path.centre[row],
            axis[row] if retreat is None else retreat[row],
            own._replace(safe=np.maximum(own.safe, its.safe)),
        )

    leave, enter = way(last, np.append(first[1:], last[-1])), way(first, np.append(first[0], last[:-1]))
    links = _links(leave, enter, axis[last], axis[first], _goes_on(path.centre, first, last), _highest(axis))
    progress("linking passes", 0.5)
    return replace(
        _merge_links(path, axis, first, links, cutter, options),
        findings=() if options.turning else _below(leave, enter),
    )


@dataclass(frozen=True, eq=False)
class _Links:
    """The rows between polylines: ``before`` (m,) counts the polyline that each leads to (the number of
    polylines for the last); ``centre``, ``axis`` (m, 3); ``motion`` (m,); ``goes_on`` (p,) True where a
    polyline has no rows before it."""

    before: Ints
    centre: Floats
    axis: Floats
    motion: Bytes
    goes_on: Bools


def _highest(axis: Floats) -> Floats:
    """Return the axis (3,) that looks up most: one that the machine has to take up anyway."""
    return np.asarray(axis[axis[:, 2].argmax()])


def _links(
    leave: WayOut, enter: WayOut, leave_axis: Floats, enter_axis: Floats, goes_on: Bools, highest: Floats
) -> _Links:
    """Seven possible rows in each gap: clear, beside, up; turned up, where the program begins or ends with an
    axis that looks down; over, beside, down to the approach."""
    gaps = len(goes_on) + 1
    centre, axis = np.zeros((gaps, 7, 3)), np.zeros((gaps, 7, 3))
    needed = np.zeros((gaps, 7), bool)
    centre[1:, :3], axis[1:, :3], needed[1:, :3] = leave.station, leave_axis[:, None], leave.needed
    centre[:-1, 4:], axis[:-1, 4:] = enter.station[:, ::-1], enter_axis[:, None]
    needed[:-1, 5:] = enter.needed[:, ::-1][:, :2]
    needed[:-1, 4] = True
    needed[:-1][goes_on] = False
    centre[[0, -1], 3], axis[[0, -1], 3] = (enter.station[0, 2], leave.station[-1, 2]), highest
    ends = np.array([enter_axis[0, 2], leave_axis[-1, 2]])
    needed[[0, -1], 3] = (ends < -LOOKS_DOWN) & (highest[2] > ends)
    gap, slot = np.nonzero(needed)
    motion = np.where(slot == 0, Motion.LINK, Motion.RAPID).astype(np.int8)
    return _Links(gap, centre[gap, slot], axis[gap, slot], motion, goes_on)


def _merge_links(
    path: OffsetPath, axis: Floats, start: Ints, links: _Links, cutter: Cutter, options: LinkOptions
) -> CLPath:
    """Return the rows of the path and the rows between its polylines, which begin at ``start``, each at its
    place."""
    put = Insertion(len(path.point), np.append(start, len(path.point))[links.before])
    drive = cutter.tip_at if options.control_point == "tip" else lambda hub, _: hub
    link_tip = drive(links.centre, links.axis)

    def motion() -> Any:
        own = np.where(path.fill, np.int8(Motion.FILL), np.int8(Motion.CUT))
        own[start] = Motion.LINK
        return put.interleave(own, links.motion)

    def feed() -> Any:
        own = np.full(len(path.point), options.feed)
        own[start[~links.goes_on]] = options.plunge_feed
        return put.interleave(own, np.where(links.motion == Motion.RAPID, 0.0, options.feed))

    columns: dict[str, Callable[[], Any]] = {
        "tip": lambda: put.interleave(drive(path.centre, axis), link_tip),
        "axis": lambda: put.interleave(axis, links.axis),
        "contact": lambda: put.interleave(path.point, link_tip),
        "normal": lambda: put.interleave(path.normal, links.axis),
        "motion": motion, "feed": feed, "face": lambda: put.interleave(path.face, -1),
        "coedge": lambda: put.interleave(path.coedge, -1), "pass_": lambda: put.interleave(path.pass_, -1),
    }  # fmt: skip
    return CLPath(**dict(zip(columns, in_threads(lambda name: columns[name](), list(columns)), strict=True)))


def _goes_on(centre: Floats, first: Ints, last: Ints) -> Bools:
    """Which polylines start where the one before them ended."""
    near = np.abs(centre[first[1:]] - centre[last[:-1]]).max(axis=1, initial=0.0) < COINCIDENT_MM
    return np.concatenate([[False], near])


def _starts(label: Ints) -> Ints:
    """Rows where a new label begins."""
    return np.concatenate([np.arange(min(len(label), 1)), 1 + np.flatnonzero(label[1:] != label[:-1])])


def _below(leave: WayOut, enter: WayOut) -> tuple[Finding, ...]:
    """Return a finding where the tool leaves or comes from below the part."""
    under = np.concatenate([leave.needed[:, 1], enter.needed[:, 1]])
    if not under.any():
        return ()
    place = np.concatenate([leave.station[:, 1], enter.station[:, 1]])[under][0]
    text = say(
        "{count} retracts or approaches pass below the part, because the tool looks down there. Check that "
        "nothing holds the part from below, or choose a tool axis that looks up.",
        count=np.count_nonzero(under),
    )
    where = (float(place[0]), float(place[1]), float(place[2]))
    return (report_finding(Code.RETRACT_BELOW_PART, text, float(np.count_nonzero(under)), place=where),)
